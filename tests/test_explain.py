"""Derivations as texts: every reference has its equation, and no equation is referred to before it stands."""

from __future__ import annotations

import pytest
from conftest import PROBLEMS

from lagrange.core.diagnostics import Source
from lagrange.core.symbols import Wedge
from lagrange.document.derivation import (
    CheckMark,
    Derivation,
    Detail,
    Display,
    Math,
    Part,
    Prose,
    Ref,
    Rule,
    Step,
    Table,
)
from lagrange.document.math_writer import unicode
from lagrange.explain.report import names_of, report
from lagrange.explain.words import in_words, spoken
from lagrange.problem.loader import load, read_problem
from lagrange.render import terminal as pretty

SHIPPED = sorted(PROBLEMS.glob("*/*.yaml"))


def reading(derivation: Derivation) -> list[tuple[str, str]]:
    """("label", x) and ("ref", x) in the order in which they are read."""
    found: list[tuple[str, str]] = []

    def parts(several: tuple[Part, ...]) -> None:
        found.extend(("ref", p.label) for p in several if isinstance(p, Ref))

    for step in derivation.steps:
        for block in step.body:
            match block:
                case Prose(parts=p):
                    parts(p)
                case Display(equations=equations):
                    for e in equations:
                        if e.label:
                            found.append(("label", e.label))
                        parts(e.condition)
                case Table(header=header, rows=rows):
                    parts(header)
                    for row in rows:
                        parts(row)
                case CheckMark(name=name):
                    parts(name)
    return found


@pytest.mark.parametrize("path", SHIPPED, ids=lambda p: p.stem)
def test_references_point_back_to_equations(path: object) -> None:
    derivation = report(load(path)).derivation  # type: ignore[arg-type]
    labels: set[str] = set()
    for kind, name in reading(derivation):
        if kind == "label":
            assert name not in labels, f"{name} stands twice"
            labels.add(name)
        else:
            assert name in labels, f"{name} is referred to before it stands"


@pytest.mark.parametrize("path", SHIPPED, ids=lambda p: p.stem)
def test_steps_come_in_the_order_of_the_textbook(path: object) -> None:
    steps = report(load(path)).derivation.steps  # type: ignore[arg-type]
    order = list(Rule)
    again = (  # one for each choice
        Rule.GENERALIZED_COORDINATES,
        Rule.EQUATIONS_OF_MOTION,
        Rule.SOLVED_REACTIONS,
        Rule.CONSERVED,
        Rule.LINEARIZATION,
        Rule.QUASI_VELOCITIES,
    )
    first = [order.index(s.rule) for s in steps if s.rule not in again]
    assert first == sorted(first)
    assert steps[0].rule is Rule.STATEMENT
    assert steps[-1].rule is Rule.CHECKS
    assert all(s.title and s.body for s in steps)


def mathematics(step: Step) -> list[object]:
    """All that is written in formulas in a step."""
    found: list[object] = []
    for block in step.body:
        if isinstance(block, Display):
            found += [side for e in block.equations for side in e.sides]
        if isinstance(block, Prose):
            found += [side for p in block.parts if isinstance(p, Math) for side in p.sides]
    return found


def words(step: Step) -> str:
    """The sentences of a step, with the formulas in the text."""
    texts = []
    for block in step.body:
        if isinstance(block, Prose):
            texts += [
                p if isinstance(p, str) else unicode(p.sides[0]) if isinstance(p, Math) else "" for p in block.parts
            ]
    return "".join(texts)


@pytest.mark.parametrize("path", SHIPPED, ids=lambda p: p.stem)
def test_a_form_has_a_name_that_nothing_else_has(path: object) -> None:
    result = report(load(path))  # type: ignore[arg-type]
    taken = names_of(result.solution.problem)
    for step in result.derivation.steps:
        products = [e for m in mathematics(step) if hasattr(m, "atoms") for e in m.atoms(Wedge)]
        names = {str(s) for e in products for s in e.args if "(" not in str(s)}
        assert not names & taken


def test_the_ball_rolls_with_omega_and_its_forms_are_called_otherwise() -> None:
    steps = report(load(PROBLEMS / "constraints" / "rolling-ball.yaml")).derivation.steps
    [integrability] = [s for s in steps if s.rule is Rule.INTEGRABILITY]
    assert "eta" in {str(s) for m in mathematics(integrability) for s in m.free_symbols}


def test_frobenius_theorem_is_explained_once() -> None:
    """A disc has two constraints that are not integrable, a car with a trailer three."""
    for name, count in (("upright-disc", 2), ("car-with-trailer", 3)):
        steps = report(load(PROBLEMS / "constraints" / f"{name}.yaml")).derivation.steps
        [integrability] = [s for s in steps if s.rule is Rule.INTEGRABILITY]
        text = words(integrability)
        assert text.count("By Frobenius' theorem one does") == 1
        assert text.count("is not exact either") == count - 1
        products = [e for m in mathematics(integrability) for e in m.atoms(Wedge)]
        assert len({str(e) for e in products if len(e.args) == 3}) == count


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("chapter6/ex07-constant-coefficients", "Time occurs in the finite form of the constraint rates"),
        ("constraints/rocking-plane", "Time occurs in the constraint plane"),
        ("constraints/steered-blade", "Time occurs in the constraint blade"),
        ("constraints/rolling-ball", "no slip 1 and no slip 2"),
    ],
)
def test_how_time_enters(name: str, said: str) -> None:
    steps = report(load(PROBLEMS / f"{name}.yaml")).derivation.steps
    [classification] = [s for s in steps if s.rule is Rule.CLASSIFICATION]
    assert said in words(classification)


def test_where_nothing_is_free() -> None:
    steps = report(load(PROBLEMS / "constraints" / "servo.yaml")).derivation.steps
    [freedom] = [s for s in steps if s.rule is Rule.DEGREES_OF_FREEDOM]
    assert "the constraints alone determine where the system is" in words(freedom)


def test_the_statement_says_what_the_file_writes_for_short() -> None:
    statement = report(load(PROBLEMS / "chapter6" / "ex05-ice-skate.yaml")).derivation.steps[0]
    [line] = [e for b in statement.body if isinstance(b, Display) for e in b.equations]
    assert [unicode(s) for s in line.sides] == ["n", "sin θ i − cos θ j"]
    forces = report(load(PROBLEMS / "chapter6" / "ex02-fixed-surface.yaml")).derivation.steps[0]
    assert "F_x, F_y and F_z are unspecified functions of x, y, z, ẋ, ẏ, ż and t." in words(forces)


def test_numbers_and_names_in_words() -> None:
    assert [in_words(n, "relation") for n in (0, 1, 2, 13)] == [
        "no relation", "one relation", "two relations", "13 relations",
    ]  # fmt: skip
    assert spoken("upper_rod") == "upper rod"
    assert spoken("no_slip.2") == "no slip 2"


BOTH = """
title: A plate that hangs and swings
parameters: [m, I, l, g]
coordinates: [x, y, theta]
bodies: {plate: {mass: m, inertia: I, position: "[x, y]", angle: theta}}
constraints: {across: x = l*sin(theta), down: y = -l*cos(theta)}
gravity: -g*j
find: [equilibrium, motion]
generalized_coordinates:
  angle: {coordinates: [theta], substitute: {x: l*sin(theta), y: -l*cos(theta)}}
"""


def test_statics_and_motion_in_one_derivation_have_labels_of_their_own(problem: object) -> None:
    labels = [name for kind, name in reading(report(problem(BOTH)).derivation) if kind == "label"]  # type: ignore[operator]
    assert len(labels) == len(set(labels))
    assert {"delta-at-rest-angle-plate", "delta-angle-plate"} <= set(labels)


def test_little_detail_is_half_a_screen() -> None:
    """Classification, degrees of freedom, the final equations; the checks that held are counted."""
    found = report(load(PROBLEMS / "chapter6" / "ex11-ideal-pendulum.yaml"))
    text = pretty.text(found.derivation, found.notation, 80, Detail.BRIEF)
    assert len(text.splitlines()) <= 32
    assert "l θ̈ + g sin θ = 0" in text
    assert text.count("✓") == 1
    assert "checks held" in text


PINNED_BEAM = """
title: Bead on a beam
parameters: [J, m, k]
coordinates: [s, phi]
bodies: {beam: {inertia: J, position: 0*i, angle: phi}}
particles: {B: {mass: m, position: "s*cos(phi)*i + s*sin(phi)*j"}}
forces: {tie: {spring: k, between: [B, 0*i], length: 0}}
"""


def test_a_spring_fastened_at_a_hinge_is_fastened_at_the_origin() -> None:
    found = report(read_problem(Source("beam.yaml", PINNED_BEAM)))
    page = " ".join(pretty.text(found.derivation, found.notation, 80, Detail.STEPS).split())
    assert "The spring tie, of stiffness k, joins B and O." in page
    assert "k d_tie = k |s|" in page
