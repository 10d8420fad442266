"""Records: immutable values with named fields.

A record is a frozen dataclass, for `dataclasses.fields` and `replace` as well as for the type checker, and is compared
field by field. `@dataclass(frozen=True)` compiles six methods for each class, and compiling those of two hundred
classes is a tenth of what a short run takes beyond importing SymPy. Here the methods are shared, and the fields of a
class are looked at when its first record is made (a short run makes records of every third class). `__init__` is
compiled only for arguments that do not fit, so that they are refused in Python's own words, and for `help`.

Three-valued verdicts: True, False, or None if a question is undecided.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import MISSING, Field, FrozenInstanceError, dataclass, field, fields
from functools import cache
from inspect import Signature, signature
from threading import RLock
from typing import Any, TypeVar, dataclass_transform

Made = TypeVar("Made")


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
def record(cls: type[Made]) -> type[Made]:
    """Make a class a record. Methods defined in the class itself are kept."""
    made: Any = cls
    for name, method in _SHARED.items():
        if name not in vars(cls):
            setattr(made, name, method)
    made.__dataclass_fields__ = _WhenFirstAsked(cls)

    def first(self: Any, /, *values: Any, **named: Any) -> None:
        made.__init__ = _initializer(made)
        made.__init__(self, *values, **named)

    made.__init__ = first
    made.__signature__ = _SignatureWhenAsked()
    return cls


class _WhenFirstAsked:
    """The fields of a class, determined on first access and not when the class is created."""

    def __init__(self, cls: type) -> None:
        self.cls = cls

    def __get__(self, _: object, __: type) -> dict[str, Any]:
        made: Any = self.cls
        with _ONE_AT_A_TIME:
            if vars(made)["__dataclass_fields__"] is self:  # still, if no memory or time was left the last time
                made.__doc__ = made.__doc__ or made.__name__  # otherwise `dataclass` asks for the signature
                _with_fields(made)
        fields: dict[str, Any] = made.__dataclass_fields__
        return fields


def _with_fields(made: Any) -> None:
    """Lets `dataclass` read the fields of a class."""
    # It would search each annotation three times for ClassVar and the like, as they are texts: half of its time.
    annotations = vars(made).get("__annotations__", {})
    made.__annotations__ = {n: a if any(w in str(a) for w in _MARKS) else object for n, a in annotations.items()}
    try:
        dataclass(eq=False, repr=False, init=False)(made)
    finally:
        made.__annotations__ = annotations
    for f in fields(made):
        f.type = annotations.get(f.name, f.type)


_MARKS = ("ClassVar", "InitVar", "KW_ONLY")
"""What `dataclass` looks for in annotations."""

_ONE_AT_A_TIME = RLock()
"""Held while a class is completed, in which its bases are."""


class _Open:
    """An object without protection, which shares the `__dict__` of a record while its fields are set."""


def _initializer(cls: Any) -> Callable[..., None]:
    """The `__init__` of a class: the values by place and by name, then the defaults."""
    initial = _declared(cls)
    places = tuple(n for n, f in initial.items() if f.kw_only is not True)
    allowed = {*initial}
    defaults = {n: f.default for n, f in initial.items() if f.default is not MISSING}
    factories = {n: f.default_factory for n, f in initial.items() if f.default_factory is not MISSING}
    required = allowed - {*defaults, *factories}
    plain = len(places) == len(initial)

    def initialize(self: Any, /, *values: Any, **named: Any) -> None:
        if plain and not named and len(values) == len(places):  # as nearly all are that are made by the thousand
            self.__dict__.update(zip(places, values, strict=True))
            return
        given = {**defaults, **dict(zip(places, values)), **named}  # noqa: B905, too many are refused below
        if (
            len(values) > len(places)
            or not required <= given.keys() <= allowed
            or not named.keys().isdisjoint(places[: len(values)])
        ):
            unprotected = _Open()
            unprotected.__dict__ = self.__dict__
            _compiled(cls).__init__(unprotected, *values, **named)
            return
        for name, factory in factories.items():
            if name not in given:
                given[name] = factory()
        self.__dict__.update(given)

    return initialize


def _declared(cls: Any) -> dict[str, Any]:
    """The arguments of a class by name, as it declares its fields: `dataclass` takes three times as long to say it."""
    declared: dict[str, Any] = {}
    for base in cls.__mro__[::-1]:
        known = vars(base).get("__dataclass_fields__")
        if known is None:
            continue
        if isinstance(known, dict):  # it has been completed, and no more than the defaults are left where fields were
            declared |= {f.name: f for f in fields(base) if f.init}
            continue
        for name, annotation in vars(base).get("__annotations__", {}).items():
            value = vars(base).get(name, MISSING)
            if any(w in str(annotation) for w in _MARKS) or (isinstance(value, Field) and not value.init):
                return {f.name: f for f in fields(cls) if f.init}
            declared[name] = value if isinstance(value, Field) else _WithDefault(value)
    return declared


class _WithDefault:
    """A field that is declared without `field`."""

    kw_only, default_factory = False, MISSING

    def __init__(self, default: object) -> None:
        self.default = default


def _compiled(cls: Any) -> Any:
    """A class of the same fields with an `__init__` that `dataclass` compiles."""
    fields(cls)  # completes the class: without a text about it `dataclass` would ask for the signature made here
    names = {"__qualname__": cls.__qualname__, "__module__": cls.__module__, "__doc__": cls.__doc__}
    return dataclass(eq=False, repr=False)(type(cls.__name__, (cls,), names))


class _SignatureWhenAsked:
    """The arguments of a class, for `help`."""

    def __get__(self, _: object, cls: Any) -> Signature:
        signature_of_init = signature(_compiled(cls).__init__)
        return signature_of_init.replace(parameters=list(signature_of_init.parameters.values())[1:])


def _compared(instance: Any) -> list[Any]:
    values = instance.__dict__
    of: Any = type(instance)
    return [values[name] for name in _names_compared(of)]


@cache
def _names_compared(cls: Any) -> tuple[str, ...]:
    return tuple(f.name for f in fields(cls) if f.compare)


def _equal(self: Any, other: object) -> bool:
    return self is other or _compared(self) == _compared(other) if type(other) is type(self) else NotImplemented


def _hash(self: Any) -> int:
    return hash(tuple(_compared(self)))


def _repr(self: Any) -> str:
    shown = ", ".join(f"{f.name}={getattr(self, f.name)!r}" for f in fields(self) if f.repr)
    return f"{type(self).__qualname__}({shown})"


def _set(_: Any, name: str, __: object) -> None:
    raise FrozenInstanceError(f"cannot assign to field {name!r}")


def _delete(_: Any, name: str) -> None:
    raise FrozenInstanceError(f"cannot delete field {name!r}")


_SHARED: dict[str, Callable[..., Any]] = {
    "__eq__": _equal,
    "__hash__": _hash,
    "__repr__": _repr,
    "__setattr__": _set,
    "__delattr__": _delete,
}


# Verdicts of three values


def all_hold(verdicts: Iterable[bool | None]) -> bool | None:
    """Whether all verdicts are True: False if one is False, otherwise None if one is undecided (Kleene)."""
    known = set(verdicts)
    return False if False in known else None if None in known else True


def any_holds(verdicts: Iterable[bool | None]) -> bool | None:
    """Whether one verdict is True: otherwise None if one is undecided, and False if all are False (Kleene)."""
    known = set(verdicts)
    return True if True in known else None if None in known else False
