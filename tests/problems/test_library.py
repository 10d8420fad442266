"""The shipped library as a whole: what every problem must state, and the index of what each exercises.

That every problem passes its own checks and agrees with its answers is held in `test_read_back`, where all are solved.
"""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml

from lagrange.problem import library
from lagrange.problem.model import Belt, Find, Friction, Problem
from tests.support.paths import PROBLEMS
from tests.support.shared import loaded

FILES = {p.relative_to(PROBLEMS).with_suffix("").as_posix(): p for p in sorted(PROBLEMS.glob("*/*.yaml"))}
INDEX = yaml.safe_load((PROBLEMS / "index.yaml").read_text(encoding="utf-8"))
BENT = {"motion/appell-hamel", "motion/constant-speed", "motion/parallel-skates"}
"""Problems whose constraint is not linear in the velocities: there is no form to be integrable."""
MANY = {"motion/coupled-pendulums", "motion/cycloidal-pendulum"}
"""Problems of which the source treats one equilibrium, and there are others, not all of them regular or in closed form."""
UNSTABLE = {"motion/hill-moon"}
"""Problems whose linear equations have roots that are no frequencies."""


def said(path: Path) -> dict[str, object]:
    return yaml.safe_load(path.read_text(encoding="utf-8"))


def answers(name: str) -> set[str]:
    return set(said(FILES[name])["answers"])


def test_there_are_more_than_a_hundred_problems_with_names_of_their_own() -> None:
    assert len(FILES) >= 100
    assert len({name.partition("/")[2] for name in FILES}) == len(FILES)
    assert library.entries() == FILES


def test_the_index_has_every_problem_and_no_other() -> None:
    assert set(INDEX) == {"topics", "exercises"}
    assert list(INDEX["exercises"]) == sorted(
        INDEX["exercises"], key=lambda n: list(INDEX["topics"]).index(n.split("/")[0])
    )
    assert set(INDEX["exercises"]) == set(FILES)
    assert set(INDEX["topics"]) == {name.partition("/")[0] for name in FILES}


def test_no_two_problems_exercise_the_same() -> None:
    lines = list(INDEX["exercises"].values())
    assert len({" ".join(line.lower().split()) for line in lines}) == len(lines)
    assert [line for line in lines if not 20 <= len(line) <= 100 or line.endswith(".")] == []


def test_no_two_problems_have_one_title_or_one_text() -> None:
    documents = [said(p) for p in FILES.values()]
    assert len({d["description"] for d in documents}) == len(documents)
    bodies = [{k: v for k, v in d.items() if k not in ("title", "source", "description")} for d in documents]
    assert len({repr(b) for b in bodies}) == len(bodies)


@pytest.mark.parametrize("name", FILES)
def test_a_problem_has_a_description_a_reference_and_answers(name: str) -> None:
    document = said(FILES[name])
    assert len(document["title"]) > 5
    assert len(document["source"]) > 8
    assert len(document["description"].split()) >= 12 or name.endswith("ideal-pendulum")
    assert document["answers"].keys() >= {"degrees_of_freedom", "classification"}


@pytest.mark.parametrize("name", FILES)
def test_the_answers_are_about_all_that_is_asked(name: str) -> None:
    problem = loaded(FILES[name])
    # There are no keys for equations in abbreviations and linear equations in numbers: tests/mechanics/nearby.
    beyond = {"equations", "equilibrium", "frequencies"} if name.startswith("large/") else set()
    assert wanted(name, problem) - beyond <= answers(name)
    if "integrable" in answers(name):
        assert set(said(FILES[name])["answers"]["integrable"]) == {c.name for c in problem.constraints}


def wanted(name: str, problem: Problem) -> set[str]:
    """The keys of answers that a problem must have."""
    keys = {"integrable"} if problem.constraints and name not in BENT else set()
    if Find.MOTION in problem.find:
        keys.add("equations")
    if Find.EQUILIBRIUM in problem.find:
        keys.add("rest" if any(isinstance(f, Friction | Belt) for f in problem.forces) else "equilibrium")
    if Find.IMPENDING in problem.find:
        keys.add("equilibrium")
    if Find.LINEARIZATION in problem.find:
        keys |= {"equilibrium", "frequencies"} - ({"equilibrium"} if name in MANY else set())
        keys -= {"frequencies"} if name in UNSTABLE else set()
    return keys
