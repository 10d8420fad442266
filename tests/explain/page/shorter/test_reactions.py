"""Reactions as one vector, on pages and at their heads.

Constant forces by the accelerations where they are long by parameters alone.

Reactions in the form of the answers, or by the quantities in which the motion is stated.

Unknowns and equations of bodies, in a line that agrees with the full count.

Vectors on a page by the unit vectors that the file names.
"""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.symbols import DotProduct, VectorSymbol, prime
from lagrange.core.vectors import Vector
from lagrange.document.derivation import Display, Equation, Prose, Rule, Step, display, math, prose
from lagrange.explain.page.shorter.reactions import counted_shortly, in_accelerations, in_directions, with_stated_forces
from tests.support.shared import reported, solved


def _lines(name: str, rule: Rule) -> list[Equation]:
    steps = reported(name, complete=False).derivation.page
    return [
        e for s in steps if s.rule is rule for b in s.body if isinstance(b, Display) and b.boxed for e in b.equations
    ]


def test_a_coin_has_one_term_along_each_of_its_axes() -> None:
    """R = m (R θ' ψ' + g sin α sin θ) axle − m C g sin α cos θ/(m R² + C) ahead, from Newton's law by hand."""
    [vector] = [e for e in _lines("coin-on-incline", Rule.RESULT) if str(e.sides[0]) == "R_coin"]
    total = vector.sides[1]
    assert isinstance(total, sp.Expr)
    names = {s.name: s for s in total.free_symbols}
    m, R, C, g = (names[n] for n in ("m", "R", "C", "g"))
    sa, th = sp.sin(names["alpha"]), names["theta"]
    along = total.expand().coeff(names["axle"])
    ahead = total.expand().coeff(names["ahead"])
    assert sp.simplify(along - m * (R * names["theta'"] * names["psi'"] + g * sa * sp.sin(th))) == 0
    assert sp.simplify(ahead + m * C * g * sa * sp.cos(th) / (m * R**2 + C)) == 0


def test_the_couple_on_a_skewed_disc() -> None:
    """Along the second axis of the disc it is I_xz φ'², whatever the motor does."""
    [vector] = [e for e in _lines("skewed-disc", Rule.RESULT) if str(e.sides[0]) == "Gamma_disc"]
    total = vector.sides[1]
    assert isinstance(total, sp.Expr)
    names = {s.name: s for s in total.free_symbols}
    second = total.expand().coeff(names["e2_disc"])
    beta, m, R = (names[n] for n in ("beta", "m", "R"))
    assert sp.simplify(second - m * R**2 * sp.sin(beta) * sp.cos(beta) * names["phi'"] ** 2 / 4) == 0


def test_a_page_without_several_reactions_has_none() -> None:
    assert not [e for e in _lines("ex11-ideal-pendulum", Rule.SOLVED_REACTIONS) if (e.label or "").startswith("along")]


# Forces


@pytest.mark.parametrize("name", ["double-atwood"])
def test_the_tensions_of_two_pulleys(name: str) -> None:
    pages = reported(name, complete=False).derivation.page
    [step] = [s for s in pages if s.rule is Rule.SOLVED_REACTIONS and not s.folded]
    [box] = [b for b in step.body if isinstance(b, Display) and b.boxed]
    said = {str(e.sides[0]): e.sides[1] for e in box.equations}
    names = {s.name: s for e in said.values() for s in e.free_symbols}
    assert sp.expand(said["F1"] - names["m1"] * (names["g"] - names["R"] * names["alpha''"])) == 0
    pulled = said["F2"] - names["m2"] * (names["g"] + names["R"] * names["alpha''"] + names["r"] * names["beta''"])
    assert sp.expand(pulled) == 0


@pytest.mark.parametrize("name", ["cylinder-on-rough-incline"])
def test_short_forces_stay(name: str) -> None:
    pages = reported(name, complete=False).derivation.page
    [step] = [s for s in pages if s.rule is Rule.SOLVED_REACTIONS and not s.folded]
    solution = solved(name, complete=False)
    assert in_accelerations(solution, step, solution.chosen) is step


# Stated forces


N, m, g, x = sp.symbols("N m g x", real=True)


@pytest.mark.parametrize(
    ("stated", "shown"),
    [(m * g * (3 * x - 2), m * g * (3 * x - 2)), (m * (3 * g * x - 2 * g), 3 * m * g * x - 2 * m * g)],
)
def test_a_shorter_form_is_taken(stated: sp.Expr, shown: sp.Expr) -> None:
    """Only one that is clearly shorter."""
    step = Step(Rule.SOLVED_REACTIONS, "", (Display((Equation((N, 3 * m * g * x - 2 * m * g)),), boxed=True),))
    [made] = with_stated_forces(solved("leaving-a-sphere", complete=False), [step], ((N, stated),), ())
    [box] = made.body
    assert isinstance(box, Display)
    assert box.equations[0].sides == (N, shown)


def test_a_rolling_ball_has_forces_by_its_spin() -> None:
    """By hand F₂ = (2/7) m (g − b φ' ω·out): m z'' = F₂ − m g with 7 z'' + 2 b φ' ω·out + 5 g = 0. It is not stated."""
    made = reported("ball-in-a-pipe", complete=False)
    lines = [
        e for s in made.derivation.page if s.rule is Rule.SOLVED_REACTIONS for b in s.body if isinstance(b, Display)
        for e in b.equations
    ]  # fmt: skip
    letters = {p.symbol.name: p.symbol for p in made.solution.problem.parameters}
    turning = prime(made.solution.problem.slots.coordinates[0])
    spin = DotProduct(VectorSymbol("omega_ball"), VectorSymbol("out"))
    upward = sp.Rational(2, 7) * letters["m"] * (letters["g"] - letters["b"] * turning * spin)
    assert any(sp.expand(e.sides[-1] - upward) == 0 for e in lines if isinstance(e.sides[-1], sp.Expr))


# Counts


@pytest.mark.parametrize("name", ["cylinder-on-rough-incline"])
def test_the_count_of_a_cylinder(name: str) -> None:
    solution = solved(name, complete=False)
    full = next(s for s in reported(name, complete=False).derivation.steps
                if s.rule is Rule.REACTIONS)  # fmt: skip
    [step] = counted_shortly(solution, [full])
    before, after = full.body[-1], step.body[-1]
    assert isinstance(before, Prose)
    assert "5 equations for 6 unknowns" in str(before.parts[0])
    assert after == prose("With the 2 constraints these are 5 equations for 5 unknowns.")


@pytest.mark.parametrize("name", ["cylinder-on-rough-incline"])
def test_other_paragraphs_stay(name: str) -> None:
    step = Step(Rule.REACTIONS, "", (prose("The directions are known."),))
    assert [*counted_shortly(solved(name, complete=False), [step])] == [step]


# Directions


def test_what_a_named_vector_is_stays_and_its_multiples_are_shorter() -> None:
    solution = solved("ex15-rough-incline")
    name, unit = next((n, v) for n, v in solution.problem.abbreviations.items() if isinstance(v, Vector))
    size = sp.Symbol("N", real=True)
    force, definition = Equation((VectorSymbol("R"), unit * size)), Equation((VectorSymbol(name), unit))
    step = Step(Rule.RESULT, "", (display(force, definition), prose("It is ", math(unit * size), ".")))
    [written] = in_directions(solution, [step])
    along = size * VectorSymbol(name)
    assert written == Step(
        Rule.RESULT, "", (display(Equation((VectorSymbol("R"), along)), definition), prose("It is ", math(along), "."))
    )
