"""What a value in a problem file may be, and forms: mappings with declared keys.

A `Kind` is the name of a primitive kind (`PRIMITIVE`) or of a part (`keys.PARTS`), words, a list, names with values of
one kind, a form, or one of several kinds.
"""

from __future__ import annotations

from lagrange.core.records import record

PRIMITIVE = ("text", "name", "argument", "expression", "equation", "number", "decimal", "quantity", "nothing")
"""`number` is a natural number, `decimal` a positive one with up to two decimals, `quantity` a number with its unit;
`nothing` is an empty section, such as one whose entries are all commented out."""


@record
class OneOf:
    """One of several words."""

    words: tuple[str, ...]


@record
class ListOf:
    """A list; `most` is None if it may have any length."""

    item: Kind
    least: int = 0
    most: int | None = None


@record
class Named:
    """name -> value. `new`: whether the names are declared here, and must be spelled like symbols."""

    value: Kind
    new: bool = True


@record
class AnyOf:
    """One of several kinds."""

    kinds: tuple[Kind, ...]


@record
class Key:
    """A key of a form.

    meaning   one or two sentences for authors of files
    required  whether it must be there in every case
    example   a value to suggest where it is missing; empty for keys that no error suggests
    """

    name: str
    kind: Kind
    meaning: str
    required: bool = False
    example: str = ""


@record
class Keys:
    """A mapping with known keys; `title` is what it is called in editors and in the documentation."""

    title: str
    keys: tuple[Key, ...]

    @property
    def names(self) -> tuple[str, ...]:
        """The names of the keys."""
        return tuple(key.name for key in self.keys)

    def example(self, name: str) -> str:
        """The example of a key."""
        return next(key.example for key in self.keys if key.name == name)

    @property
    def required(self) -> tuple[str, ...]:
        """The names of the keys that must be there."""
        return tuple(key.name for key in self.keys if key.required)


Kind = str | OneOf | ListOf | Named | AnyOf | Keys


def or_nothing(*kinds: Kind) -> AnyOf:
    """One of these kinds, or an empty section."""
    return AnyOf((*kinds, "nothing"))


def one_or_list(kind: Kind) -> AnyOf:
    """A value, or a list of such values."""
    return AnyOf((kind, ListOf(kind)))


def three(kind: Kind) -> ListOf:
    """A list of three values."""
    return ListOf(kind, 3, 3)
