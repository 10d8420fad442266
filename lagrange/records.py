"""Records: values with named parts that are not changed once they are made.

A record is a dataclass, to `dataclasses.fields` and `replace` as to the type checker, that is frozen and compared part
by part. `@dataclass(frozen=True)` would compile six methods for each class, and compiling those of two hundred classes
is a tenth of what a short run takes beyond importing SymPy; here `__init__` alone is compiled, the others are shared.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import FrozenInstanceError, dataclass, field, fields
from typing import Any, TypeVar, dataclass_transform

Made = TypeVar("Made")


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
def record(cls: type[Made]) -> type[Made]:
    """Makes a class a record. Shared methods that the class has itself are left as they are."""
    made = dataclass(eq=False, repr=False)(cls)
    for name, method in _SHARED.items():
        if name not in vars(cls):
            setattr(made, name, method)
    return made


def _parts(one: Any) -> Iterator[Any]:
    return (getattr(one, f.name) for f in one.__dataclass_fields__.values() if f.compare)


def _equal(one: Any, other: object) -> bool:
    return one is other or tuple(_parts(one)) == tuple(_parts(other)) if type(other) is type(one) else NotImplemented


def _hash(one: Any) -> int:
    return hash(tuple(_parts(one)))


def _shown(one: Any) -> str:
    shown = ", ".join(f"{f.name}={getattr(one, f.name)!r}" for f in fields(one) if f.repr)
    return f"{type(one).__qualname__}({shown})"


def _set_once(one: Any, name: str, value: Any) -> None:
    parts = vars(one)
    if name in parts or name not in one.__dataclass_fields__:
        raise FrozenInstanceError(f"cannot assign to field {name!r}")
    parts[name] = value


def _delete(_: Any, name: str) -> None:
    raise FrozenInstanceError(f"cannot delete field {name!r}")


_SHARED: dict[str, Callable[..., Any]] = {
    "__eq__": _equal,
    "__hash__": _hash,
    "__repr__": _shown,
    "__setattr__": _set_once,
    "__delattr__": _delete,
}
