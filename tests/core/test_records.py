"""Records behave like frozen dataclasses, at a lower cost.

Kleene's logic of three values.
"""

from __future__ import annotations

from collections.abc import Callable
from copy import deepcopy
from dataclasses import KW_ONLY, FrozenInstanceError, dataclass, field, fields, replace
from functools import cached_property
from inspect import signature
from pickle import dumps, loads
from typing import Any, ClassVar

import pytest

from lagrange.core.records import all_hold, any_holds, record


def described(made: Callable[[type], type]) -> tuple[type, type]:
    """A class with what dataclasses have, and one derived from it."""

    @made
    class Plane:
        x: int
        y: int = 0
        note: str = field(default="", compare=False, repr=False)

        @cached_property
        def sum(self) -> int:
            return self.x + self.y

    @made
    class Space(Plane):
        z: tuple[int, ...] = field(default_factory=tuple, kw_only=True)

    return Plane, Space


@pytest.mark.parametrize("name", ["parts", "self", "fields", "names", "MISSING", "made", "_hidden"])
def test_names_of_parts(name: str) -> None:
    made = record(type("Named", (), {"__annotations__": {name: int, "other": int}, "other": 2}))
    assert getattr(made(1), name) == 1
    assert made(**{name: 1, "other": 3}) == made(1, 3) != made(1)


@record
class Picklable:
    """At the top of a module, where pickle finds it."""

    name: str


@pytest.fixture(params=[record, dataclass(frozen=True)], ids=["record", "dataclass"])
def classes(request: pytest.FixtureRequest) -> tuple[Any, Any]:
    return described(request.param)


def test_parts(classes: tuple[Any, Any]) -> None:
    plane, space = classes
    assert [f.name for f in fields(space)] == ["x", "y", "note", "z"]
    assert plane(1) == plane(1, 0, "not compared") == replace(plane(2), x=1)
    assert plane(1) != plane(2)
    assert plane(1) != space(1)
    assert plane(1) != (1, 0)
    assert hash(plane(1)) == hash(plane(1, note="n"))
    assert len({space(1), space(1), space(1, z=(2,))}) == 2
    assert repr(plane(1)).endswith("Plane(x=1, y=0)")
    assert repr(space(1, z=(2,))).endswith("Space(x=1, y=0, z=(2,))")


def test_nothing_is_changed(classes: tuple[Any, Any]) -> None:
    for one in (classes[0](1), classes[1](1)):
        assert one.sum == 1  # what is cached may be written
        for name in ("x", "y", "note", "new"):
            with pytest.raises(FrozenInstanceError, match=f"cannot assign to field '{name}'"):
                setattr(one, name, 2)
            with pytest.raises(FrozenInstanceError, match=f"cannot delete field '{name}'"):
                delattr(one, name)
        assert deepcopy(one) == one
        assert one.x == 1


def test_arguments(classes: tuple[Any, Any]) -> None:
    with pytest.raises(TypeError, match="missing 1 required positional argument: 'x'"):
        classes[0]()
    with pytest.raises(TypeError, match="takes from 2 to 4 positional arguments"):
        classes[1](1, 2, "", ())


def test_arguments_that_do_not_fit(classes: tuple[Any, Any]) -> None:
    plane, space = classes
    with pytest.raises(TypeError, match="got multiple values for argument 'x'"):
        plane(1, x=2)
    with pytest.raises(TypeError, match="got an unexpected keyword argument 'w'"):
        space(1, w=2)
    assert list(signature(space).parameters) == ["x", "y", "note", "z"]


def test_fields_are_declared_in_all_ways() -> None:
    """Without being completed by `dataclass`, and with it where an annotation is special."""

    class NoRecord:
        text: str

    @record
    class Plain(NoRecord):
        x: int
        many: list[int] = field(default_factory=list)
        named: int = field(default=3, kw_only=True)

    @record
    class Special(Plain):
        shared: ClassVar[int] = 7
        _: KW_ONLY
        y: int = 5

    assert (Plain(1).many, Plain(1, [2], named=4).named, Plain(1).named) == ([], 4, 3)
    assert Special(1, y=6) == Special(1, [], y=6) != Special(1)
    with pytest.raises(TypeError):
        Plain(1, [], 4)

    @record
    class Later(Plain):  # of a record that has been completed
        z: int = 9

    assert fields(Plain)
    assert (Later(1, [], 4).z, Later(1).named) == (4, 3)


def test_own_methods_stay() -> None:
    @record
    class Own:
        x: int

        def __repr__(self) -> str:
            return "own"

        def __eq__(self, other: object) -> bool:
            return isinstance(other, Own)

        def __hash__(self) -> int:
            return 7

    assert repr(Own(1)) == "own"
    assert Own(1) == Own(2)
    assert hash(Own(1)) == 7


def test_without_a_hash_of_its_own_there_is_none() -> None:
    @record
    class Own:
        x: int

        def __eq__(self, other: object) -> bool:
            return True

    with pytest.raises(TypeError, match="unhashable"):
        hash(Own(1))


def test_pickle() -> None:
    assert loads(dumps(Picklable("n"))) == Picklable("n")


def test_a_record_that_could_not_be_completed_is_completed_when_it_is_used_again(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Memory runs out, or a clock, while the initializer of the message about that is made."""

    def out_of_memory(*_: object, **__: object) -> None:
        raise MemoryError

    @record
    class Plane:
        x: int

    for needed, use in (("_initializer", lambda: Plane(1)), ("dataclass", lambda: fields(Plane))):
        with monkeypatch.context() as shortly:
            shortly.setattr(f"lagrange.core.records.{needed}", out_of_memory)
            with pytest.raises(MemoryError):
                use()
    assert Plane(1).x == 1
    assert [f.name for f in fields(Plane)] == ["x"]


# Verdicts


@pytest.mark.parametrize(
    ("verdicts", "expected"),
    [([], True), ([True, True], True), ([True, None], None), ([None, False, True], False), ([False], False)],
)
def test_undecided_is_not_false(verdicts: list[bool | None], expected: bool | None) -> None:
    assert all_hold(verdicts) is expected


@pytest.mark.parametrize(
    ("verdicts", "expected"),
    [([], False), ([False, False], False), ([False, None], None), ([None, True, False], True), ([True], True)],
)
def test_one_of_several_holds(verdicts: list[bool | None], expected: bool | None) -> None:
    assert any_holds(verdicts) is expected
