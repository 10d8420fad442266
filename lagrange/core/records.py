"""Records: values with named parts that are not changed once they are made.

A record is a dataclass, to `dataclasses.fields` and `replace` as to the type checker, that is frozen and compared part
by part. `@dataclass(frozen=True)` compiles six methods for each class, and compiling those of two hundred classes is a
tenth of what a short run takes beyond importing SymPy; here `__init__` alone is compiled, the others are shared.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import FrozenInstanceError, dataclass, field, fields
from functools import wraps
from typing import Any, TypeVar, dataclass_transform

Made = TypeVar("Made")


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
def record(cls: type[Made]) -> type[Made]:
    """Makes a class a record. Methods of these names that the class has itself are left as they are."""
    made: Any = dataclass(eq=False, repr=False)(cls)
    made.__init__ = _initializer(made.__init__)
    made.__compared__ = tuple(f.name for f in fields(made) if f.compare)
    for name, method in _SHARED.items():
        if name not in vars(cls):
            setattr(made, name, method)
    return cls


class _Open:
    """What may be assigned to."""


def _initializer(plain: Callable[..., None]) -> Callable[..., None]:
    """`__init__` of a class that refuses assignments, from that of one that does not."""

    @wraps(plain)
    def initialize(one: Any, /, *parts: Any, **named: Any) -> None:
        there = _Open()
        there.__dict__ = one.__dict__
        plain(there, *parts, **named)

    return initialize


def _compared(one: Any) -> list[Any]:
    parts = one.__dict__
    return [parts[name] for name in one.__compared__]


def _equal(one: Any, other: object) -> bool:
    return one is other or _compared(one) == _compared(other) if type(other) is type(one) else NotImplemented


def _hash(one: Any) -> int:
    return hash(tuple(_compared(one)))


def _shown(one: Any) -> str:
    shown = ", ".join(f"{f.name}={getattr(one, f.name)!r}" for f in fields(one) if f.repr)
    return f"{type(one).__qualname__}({shown})"


def _set(_: Any, name: str, __: object) -> None:
    raise FrozenInstanceError(f"cannot assign to field {name!r}")


def _delete(_: Any, name: str) -> None:
    raise FrozenInstanceError(f"cannot delete field {name!r}")


_SHARED: dict[str, Callable[..., Any]] = {
    "__eq__": _equal,
    "__hash__": _hash,
    "__repr__": _shown,
    "__setattr__": _set,
    "__delattr__": _delete,
}
