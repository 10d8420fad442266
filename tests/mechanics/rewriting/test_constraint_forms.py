"""Forms without common factors, v·n = 0, and the only coordinate as a function of time.

Conditions on displacements satisfied by a parameter, where solving for one displacement would divide by zero.
"""

from __future__ import annotations

import math
from dataclasses import replace

import pytest
import sympy as sp

from lagrange.core.diagnostics import Source
from lagrange.core.effort import allowed
from lagrange.core.symbols import Slots, VectorSymbol, t, variation
from lagrange.mechanics.constraints.constrained_system import Row
from lagrange.mechanics.rewriting.constraint_forms import (
    common_number,
    free_displacements,
    frobenius_on_surface,
    integral_in_angle,
    is_drive,
    only_coordinate,
    vanishing_components,
    with_short_forms,
    without_common_number,
)
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem
from tests.support.shared import loaded, solved

x, y, z = sp.symbols("x y z", real=True)
a = sp.Symbol("a", positive=True)
SLOTS = Slots((x, y, z))


@pytest.mark.parametrize(
    ("coefficients", "number"),
    [((2 * x, 2 * y, 0), 2), ((4 * x, 6 * y, 2 * a), 2), ((2 * x, 3 * y, 0), 1), ((x, 0, 0), 1)],
)
def test_the_number_that_a_form_contains(coefficients: tuple[sp.Expr, ...], number: int) -> None:
    row = Row("f", tuple(map(sp.sympify, coefficients)), sp.S.Zero)
    assert common_number(row) == number
    assert tuple(number * c for c in without_common_number(row).coefficients) == row.coefficients


def test_partial_derivatives_are_divided_as_the_forms_are() -> None:
    classification = solved("ex06-two-particle-skate").classification
    short = with_short_forms(classification)
    assert short is not None
    for whole, halved in zip(classification.constraints, short.constraints, strict=True):
        if whole.row.finite is not None:
            number = common_number(whole.row)
            assert [number * c for c in halved.row.coefficients] == [*whole.row.coefficients]
            for before, after in zip(whole.exactness.comparisons, halved.exactness.comparisons, strict=True):
                assert [number * d for d in after.derivatives] == [*before.derivatives]
    assert {common_number(c.row) for c in short.constraints if c.row.finite is not None} == {1}
    assert with_short_forms(solved("ex05-ice-skate").classification) is None


def test_frobenius_product_loses_constant_factors_only() -> None:
    """ω = y dx − dz has ω ∧ dω = dx ∧ dy ∧ dz up to its sign; d(xy) and a form in two variables settle nothing here."""
    reduced = frobenius_on_surface(Row("f", (a * y, sp.S.Zero, -a), sp.S.Zero), SLOTS)
    assert reduced is not None
    assert reduced.form in ((y, 0, -1), (-y, 0, 1))
    assert abs(reduced.component.coefficient) == 1
    assert frobenius_on_surface(Row("f", (y, x, sp.S.Zero), sp.S.Zero), SLOTS) is None


def test_a_velocity_that_vanishes_along_a_named_unit_vector() -> None:
    [(velocity, normal)] = vanishing_components(loaded("ex05-ice-skate"))
    assert normal in loaded("ex05-ice-skate").abbreviations
    assert velocity.has(sp.Symbol("x'", real=True)) or velocity.atoms(VectorSymbol)
    assert [*vanishing_components(loaded("ex11-ideal-pendulum"))] == []


def test_one_constraint_determines_the_only_coordinate() -> None:
    """x' + κ x = v t: the function of time satisfies it for every constant."""
    text = "title: Belt\nparameters: [kappa, v, m]\ncoordinates: [x]\nparticles: {P: {mass: m, position: x*i}}\n"
    solution = solve(read_problem(Source("belt.yaml", text + "constraints: {drag: x' + kappa*x = v*t}\n")))
    only = only_coordinate(solution)
    assert only is not None
    kappa, v = (next(s for s in only.value.free_symbols if s.name == name) for name in ("kappa", "v"))
    assert sp.expand(only.value.diff(t) + kappa * only.value - v * t) == 0
    assert only.constant in only.value.free_symbols
    assert only_coordinate(solved("ex11-ideal-pendulum")) is None


def test_a_drive_is_no_support() -> None:
    """An arm that turns at Ω holds its bead by a moment; a floor that goes up and down is one coordinate, too."""
    text = (
        "title: Driven\nparameters: {{m: positive, a: positive, Omega: positive}}\ncoordinates: {coordinates}\n"
        "particles: {{P: {{mass: m, position: {position}}}}}\nconstraints: {{c: {constraint}}}\n"
    )
    arm = text.format(coordinates="[r, phi]", position="r*cos(phi)*i + r*sin(phi)*j", constraint="phi = Omega*t")
    floor = text.format(coordinates="[x, y]", position="x*i + y*j", constraint="y = a*cos(Omega*t)")
    for given, drives in ((arm, True), (floor, False)):
        law = solve(read_problem(Source("driven", given))).law
        assert law is not None
        assert [is_drive(r) for r in law.newton.reactions] == [drives]


# Free displacements


def test_the_displacements_of_a_skate_satisfy_its_condition_in_every_position() -> None:
    own = solved("ex05-ice-skate").own
    slots = own.configuration.slots
    made = free_displacements(own.elimination, slots, {"s"})
    assert made is not None
    assert made.pivots == ()
    assert made.free[0] == variation(sp.Symbol("u", real=True))  # s is taken
    displaced = {variation(q): value for q, value in made.values.items()}
    [row] = own.configuration.rows
    steps = [displaced.get(variation(q), variation(q)) for q in slots.coordinates]
    left = sp.Add(*(c * step for c, step in zip(row.coefficients, steps, strict=True)))
    assert sp.expand(left) == 0
    assert not any(sp.fraction(sp.together(e))[1].free_symbols for e in displaced.values())


def test_what_is_never_infinite_needs_no_parameter() -> None:
    own = solved("ex07-constant-coefficients").own
    assert free_displacements(own.elimination, own.configuration.slots, set()) is None


def test_the_heading_is_free_rather_than_a_wheel() -> None:
    own = solved("two-wheels-on-an-axle").own
    slots = own.configuration.slots
    made = free_displacements(own.elimination, slots, set())
    assert made is not None
    assert [d.name for d in made.free] == ["delta(s)", "delta(theta)"]
    steps = [made.values.get(q, variation(q)) for q in slots.coordinates]
    for row in own.configuration.rows:
        total = sp.Add(*(c * step for c, step in zip(row.coefficients, steps, strict=True)))
        assert sp.simplify(total) == 0


def test_long_denominators_are_not_multiplied_out() -> None:
    own = solved("ex05-ice-skate").own
    nested, below = sp.Symbol("x", real=True), sp.S.One
    for _ in range(20):
        nested = 2 + sp.log(nested)
        below *= nested
    long = replace(own.elimination, solution=((1 / below,),))
    with allowed(1_000):
        assert free_displacements(long, own.configuration.slots, set()) is None


def test_the_tractrix_in_its_angle() -> None:
    """The relation in ψ is that in the coordinates, and the blade moves along the rod on the curve that it describes."""
    [_, blade] = solved("towed-blade").classification.constraints
    relation = integral_in_angle(blade)
    assert relation is not None
    [psi] = [s for s in relation.free_symbols if s.name == "psi"]
    l, x = (next(s for s in relation.free_symbols if s.name == n) for n in ("l", "x"))
    for angle in (0.4, 1.3, 2.2):
        at = [float((-relation + x).subs({l: 1, psi: angle + h})) for h in (-1e-6, 1e-6)]
        slope = (math.sin(angle + 1e-6) - math.sin(angle - 1e-6)) / (at[1] - at[0])
        assert slope == pytest.approx(-math.tan(angle), rel=1e-6)  # the rod to A has the direction (−cos ψ, sin ψ)


@pytest.mark.parametrize("name", ["cylinder-in-a-cylinder", "form-in-two-variables", "ex06-two-particle-skate"])
def test_other_relations_have_no_angle(name: str) -> None:
    assert all(integral_in_angle(c) is None for c in solved(name).classification.constraints)
