"""The problems of `textbook_systems`, `body_systems` and `shipped_systems`: what the program derives against a second route, as solution sets.

At random states on the constraint surface, in numbers of sixty digits, both give the accelerations; so do the equations
in every choice of coordinates, on every branch, and the reactions where the second route has them.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Mapping
from functools import cache
from itertools import product
from pathlib import Path
from typing import Any

import pytest
import sympy as sp
import yaml
from mpmath import mp, mpf

from lagrange.answers.references import reference_of_solution
from lagrange.core.diagnostics import ProblemError, Source
from lagrange.core.symbols import Sign, Unspecified, base
from lagrange.explain.report import Report, report
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.spot_values import SpotValue
from lagrange.mechanics.results import InCoordinates
from lagrange.problem.loader import read_problem
from tests.support.paths import PROBLEMS, SYSTEM_FILES
from tests.support.second_route import (
    AGREED,
    DIGITS,
    Route,
    accelerations,
    affine,
    drawn,
    least_change,
    number,
    solved,
    states,
)
from tests.support.shared import reported
from tests.truth.asked_systems import ASKED
from tests.truth.body_systems import BODIES
from tests.truth.further_systems import FURTHER
from tests.truth.shipped_systems import SHIPPED as FIRST
from tests.truth.textbook_systems import SYSTEMS as PARTICLES
from tests.truth.textbook_systems import Textbook

SHIPPED = {**FIRST, **FURTHER, **ASKED}
SYSTEMS = {**PARTICLES, **BODIES, **SHIPPED}
STATES = 3


def path_of(name: str) -> Path:
    return (PROBLEMS / "motion" if name in SHIPPED else SYSTEM_FILES) / f"{name}.yaml"


def solution_of(name: str) -> Report:
    return reported(path_of(name))


@cache
def routes_of(name: str) -> tuple[Route, ...]:
    return SYSTEMS[name].routes()


def concrete(expression: sp.Expr, book: Textbook) -> sp.Expr:
    """The expression with the book's functions in place of undefined ones, and their derivatives carried out."""

    def replaced(f: Unspecified) -> sp.Expr:
        names, text = book.functions[f.name]
        stand_ins = sp.symbols(names.replace(" ", ",") + ",")
        value = sp.sympify(text, locals={s.name: s for s in stand_ins})
        for s, order in zip(stand_ins, f.orders, strict=True):
            value = value.diff(s, order) if order else value
        return value.subs(dict(zip(stand_ins, f.arguments, strict=True)), simultaneous=True)

    while expression.has(Unspecified):
        expression = expression.replace(lambda e: isinstance(e, Unspecified), replaced)
    return expression


def differentiated(expression: sp.Expr, configuration: Configuration) -> sp.Expr:
    """d/dt of an expression in slots, by SymPy's own functions of time."""
    t = sp.Symbol("time_")
    names = {s.name for s in (*configuration.slots.coordinates, *configuration.slots.prescribed)}
    forth, back = {}, {}
    for s in expression.free_symbols:
        root, order = base(s).name, s.name.count("'")
        if root in names:
            function = sp.Function(root)(t)
            forth[s] = function.diff(t, order) if order else function
            for n in range(order + 2):
                back[function.diff(t, n) if n else function] = sp.Symbol(root + "'" * n, real=True)
        elif s.name == "t":
            forth[s], back[t] = t, s
    return expression.xreplace(forth).diff(t).xreplace(back)


def derived_rows(configuration: Configuration, equations: tuple[sp.Expr, ...], book: Textbook) -> list[sp.Expr]:
    """The equations of motion, and the remaining constraints differentiated until accelerations occur."""
    rows = []
    for row in configuration.rows:
        if row.finite is not None:
            rows.append(differentiated(differentiated(concrete(row.finite, book), configuration), configuration))
        else:
            velocities = configuration.slots.velocities
            form = sp.Add(*(a * v for a, v in zip(row.coefficients, velocities, strict=True))) + row.drift
            rows.append(differentiated(concrete(form, book), configuration))
    return [*(concrete(e, book) for e in equations), *rows]


def names_in(expressions: list[sp.Expr]) -> set[str]:
    return {s.name for e in expressions for s in e.free_symbols}


def agree(one: Mapping[str, mpf], other: Mapping[str, mpf]) -> None:
    assert set(one) <= set(other), f"{set(one) - set(other)} are not determined"
    for n in one:
        assert abs(one[n] - other[n]) < AGREED * (1 + abs(one[n])), f"{n}: {mp.nstr(one[n])} and {mp.nstr(other[n])}"


NONLINEAR = {"appell-hamel", "constant-speed", "parallel-skates"}
"""Problems whose constraints are not linear in the velocities: in `test_nonlinear_constraints`."""


def test_every_shipped_problem_of_motion_has_a_second_route() -> None:
    assert {path.stem for path in (PROBLEMS / "motion").glob("*.yaml")} - NONLINEAR == set(SHIPPED)


# -- classification ----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", SYSTEMS)
def test_class_and_degrees_of_freedom(name: str) -> None:
    book, found = SYSTEMS[name], solution_of(name).solution.classification
    words = (
        "holonomic" if found.holonomic else "nonholonomic",
        "scleronomic" if found.scleronomic else "rheonomic",
        "catastatic" if found.catastatic else "acatastatic",
    )
    assert " ".join(words) == book.classification
    assert found.degrees_of_freedom == book.freedom
    assert found.integrable_rank == book.integrable
    assert found.configuration_dimension == found.coordinates - book.integrable
    assert found.redundant == book.redundant
    assert tuple(c.constraint.name for c in found.constraints if c.integrable is not True) == book.not_integrable
    assert all(c.integrable is not None for c in found.constraints)


@pytest.mark.parametrize("name", SYSTEMS)
def test_own_checks_and_answers_hold(name: str) -> None:
    found = solution_of(name)
    assert [(c.name, c.choice) for c in found.solution.checks if not c.passed] == []
    assert [(a.name, a.verdict.value) for a in found.answers if a.verdict.value != "equivalent"] == []
    assert found.holds


# -- motion ------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", SYSTEMS)
def test_accelerations_in_the_coordinates_of_the_file(name: str) -> None:
    book, solution = SYSTEMS[name], solution_of(name).solution
    configuration = solution.own.configuration
    rows = derived_rows(configuration, solution.own.motion.expressions, book)
    unknowns = [a.name for a in configuration.slots.accelerations]
    for n, route in enumerate(routes_of(name)):
        assert tuple(q.name for q in configuration.slots.coordinates) == route.coordinates
        for state in states(route, names_in(rows) - set(unknowns), book.ranges, 100 + n, STATES):
            expected = accelerations(route, state)
            assert expected.consistent
            found = solved(affine(rows, unknowns, state), unknowns)
            assert found.consistent
            agree({u: expected.values[u] for u in unknowns}, found.values)


@pytest.mark.parametrize("name", [n for n, book in SYSTEMS.items() if not book.redundant])
def test_multipliers(name: str) -> None:
    """m r'' = F + sum of lambda times the gradient of left side less right side."""
    book, solution = SYSTEMS[name], solution_of(name).solution
    route = next((r for r in routes_of(name) if any(m.startswith("lambda_") for m in r.multipliers)), None)
    if route is None:
        return  # no second route has them
    system = reference_of_solution(solution).candidates[0].system
    multipliers = [m.name for m in system.multipliers]
    unknowns = [*(a.name for a in solution.own.configuration.slots.accelerations), *multipliers]
    rows = derived_rows(solution.own.configuration, system.equations, book)
    for state in states(route, names_in(rows) - set(unknowns), book.ranges, 200, 2):
        expected = accelerations(route, state).values
        wanted = {
            m: expected[f"lambda_{c.name}"] for m, c in zip(multipliers, solution.problem.constraints, strict=True)
        }
        agree(wanted, solved(affine(rows, unknowns, state), unknowns).values)


def route_with_multipliers(name: str) -> Route | None:
    return next((r for r in routes_of(name) if any(m.startswith("lambda_") for m in r.multipliers)), None)


@pytest.mark.parametrize("name", [n for n, book in SYSTEMS.items() if not book.redundant])
def test_reactions_and_accelerations_as_functions_of_the_state(name: str) -> None:
    """The expressions that are found for multipliers and accelerations, against the second route's numbers."""
    book, reactions = SYSTEMS[name], solution_of(name).solution.own.dynamics.reactions
    route = route_with_multipliers(name)
    if route is None or reactions is None or not reactions.multipliers:
        return
    values = {f"lambda_{n}": concrete(v, book) for n, v in reactions.multipliers.items() if v is not None}
    values |= {s.name: concrete(v, book) for s, v in reactions.accelerations.items() if v is not None}
    for state in states(route, names_in(list(values.values())), book.ranges, 300, 2):
        expected = accelerations(route, state).values
        agree({n: number(v, state) for n, v in values.items()}, expected)


@pytest.mark.parametrize("name", [n for n, book in SYSTEMS.items() if not book.redundant])
def test_reactions_in_a_choice(name: str) -> None:
    book, route = SYSTEMS[name], route_with_multipliers(name)
    for found in solution_of(name).solution.choices:
        if route is None or found.dynamics.reactions is None:
            continue
        values = {
            f"lambda_{n}": concrete(v, book) for n, v in found.dynamics.reactions.multipliers.items() if v is not None
        }
        configuration = found.motion.configuration
        expressed = {q.name: concrete(e, book) for q, e in configuration.expressed.items()}
        unknowns = [a.name for a in configuration.slots.accelerations]
        rows = derived_rows(configuration, found.motion.expressions, book)
        signs = {s.name: mpf(1) for s in found.signs}
        for state in states_of_choice(found, expressed, route, book, signs):
            here = solved(affine(rows, unknowns, state), unknowns).values
            whole = moved(expressed, configuration, state, {u: here[u] for u in unknowns})
            agree({n: number(v, state) for n, v in values.items()}, accelerations(route, whole).values)


TOO_LARGE = {
    "bicycle": "rear_wheel front_wheel",
    "chain_of_four": "rod1 rod2 rod3 rod4",
    "circles_with_common_point": "first second rod",
    "four-bar-linkage": "closure.1 closure.2",
    "four_bar": "crank coupler rocker",
    "heavy_slider_crank": "pin.1 pin.2 bolt.1 bolt.2",
    "rear-wheel-drive": "rear front",
    "three-link-chain": "upper middle lower",
    "two-wheeled-carriage": "sideways left_wheel right_wheel",
}
"""The reactions that are left unsolved. They are the exception."""


@pytest.mark.parametrize("name", SYSTEMS)
def test_reactions_are_found(name: str) -> None:
    dynamics = solution_of(name).solution.own.dynamics
    found = dynamics.reactions.multipliers if dynamics and dynamics.reactions else {}
    assert [n for n, value in found.items() if value is None] == TOO_LARGE.get(name, "").split()


# -- choices -----------------------------------------------------------------------------------------------------------


def _data(name: str) -> dict[str, Any]:
    """The file as PyYAML reads it, by its parser in C where there is one: every collection of tests reads all files."""
    with path_of(name).open("rb") as file:
        return yaml.load(file, getattr(yaml, "CSafeLoader", yaml.SafeLoader))


CHOICES = [(name, choice) for name in sorted(SYSTEMS) for choice in _data(name).get("generalized_coordinates") or {}]


def substitution_of_file(name: str, choice: str, configuration: Configuration) -> dict[str, sp.Expr] | None:
    """The substitution as SymPy reads it from the file, old coordinate -> expression; None where there is none."""
    data = _data(name)
    given = data["generalized_coordinates"][choice].get("substitute")
    if given is None:
        return None
    local = {s.name: s for e in configuration.expressed.values() for s in e.free_symbols}
    local |= {s.name: s for s in (*configuration.slots.coordinates, *configuration.slots.prescribed)}
    local |= {old: sp.Symbol(old, real=True) for old in given}
    found = {old: sp.sympify(str(text).replace("^", "**"), locals=local) for old, text in given.items()}
    for _ in given:
        found = {old: e.subs({sp.Symbol(o, real=True): v for o, v in found.items()}) for old, e in found.items()}
    return found


def moved(
    expressed: Mapping[str, sp.Expr],
    configuration: Configuration,
    state: Mapping[str, mpf],
    accelerated: Mapping[str, mpf],
) -> dict[str, mpf]:
    """Old coordinates with velocities and accelerations at a state of the new ones."""
    found = dict(state) | dict(accelerated)
    for old, e in expressed.items():
        rate = differentiated(e, configuration)
        whole = {**state, **accelerated}
        found |= {
            old: number(e, whole),
            f"{old}'": number(rate, whole),
            f"{old}''": number(differentiated(rate, configuration), whole),
        }
    return found


@pytest.mark.parametrize(("name", "choice"), CHOICES)
def test_accelerations_in_a_choice(name: str, choice: str) -> None:
    book, solution = SYSTEMS[name], solution_of(name).solution
    found = next(c for c in solution.choices if c.name == choice)
    configuration = found.motion.configuration
    written = substitution_of_file(name, choice, configuration)
    expressed = written or {q.name: concrete(e, book) for q, e in configuration.expressed.items()}
    route = routes_of(name)[0]
    branches = list(product((-1, 1), repeat=len(found.signs)))
    assert found.coordinates.branches == len(branches)
    for branch in branches:
        signs = {s.name: mpf(n) for s, n in zip(found.signs, branch, strict=True)}
        count = 0
        for state in states_of_choice(found, expressed, route, book, signs):
            compare_at(found, expressed, route, book, state)
            count += 1
        assert count == 2, "no real states on this branch"


def states_of_choice(
    found: InCoordinates, expressed: Mapping[str, sp.Expr], route: Route, book: Textbook, signs: Mapping[str, mpf]
) -> Iterator[dict[str, mpf]]:
    """Two random states of a choice: positions free, velocities as the second route's constraints allow them."""
    configuration = found.motion.configuration
    q = [s.name for s in configuration.slots.coordinates]
    rows = derived_rows(configuration, found.motion.expressions, book)
    more = {
        s.name
        for e in expressed.values()
        for s in differentiated(differentiated(e, configuration), configuration).free_symbols
    }
    velocities = [f"{n}'" for n in q]
    names = {*names_in(rows), *more, *route.names, *q, *velocities, "t"}
    names |= {s.name for e in expressed.values() for s in e.free_symbols}
    old = set(expressed)
    names = {n for n in names if n.rstrip("'") not in old and n not in {f"{c}''" for c in q} and n not in signs}
    names = {n for n in names if n not in route.multipliers and not n.startswith("lam")}
    source = random.Random(len(q) + len(names))
    count = 0
    for _ in range(400):
        state = drawn(source, names, book.ranges) | dict(signs)
        zero = dict.fromkeys((f"{c}''" for c in q), mpf(0))
        try:
            allowed = _allowed(expressed, configuration, route, state, velocities, zero)
        except ValueError:
            continue
        yield allowed
        count += 1
        if count == 2:
            return


def _allowed(
    expressed: Mapping[str, sp.Expr],
    configuration: Configuration,
    route: Route,
    state: Mapping[str, mpf],
    velocities: list[str],
    zero: Mapping[str, mpf],
) -> dict[str, mpf]:
    """The state with velocities that satisfy the constraints of the second route."""
    with mp.workdps(DIGITS):

        def rates(values: list[mpf]) -> list[mpf]:
            tried = {**state, **dict(zip(velocities, values, strict=True))}
            return [number(e, moved(expressed, configuration, tried, zero)) for e in route.rates]

        start = [state[v] for v in velocities]
        here = rates(start)
        unit = [rates([x + (1 if n == k else 0) for k, x in enumerate(start)]) for n in range(len(start))]
        jacobian = [[unit[n][r] - here[r] for n in range(len(start))] for r in range(len(here))]
        change = least_change(jacobian, [-h for h in here]) or [mpf(0)] * len(start)
        chosen = [x + c for x, c in zip(start, change, strict=True)]
        at = {**state, **dict(zip(velocities, chosen, strict=True))}
        whole = moved(expressed, configuration, at, zero)
        for e in (*route.positions, *route.rates):
            assert abs(number(e, whole)) < mpf(10) ** -45, "the choice leaves the constraints"
        return at


def compare_at(
    found: InCoordinates, expressed: Mapping[str, sp.Expr], route: Route, book: Textbook, state: Mapping[str, mpf]
) -> None:
    configuration = found.motion.configuration
    unknowns = [a.name for a in configuration.slots.accelerations]
    rows = derived_rows(configuration, found.motion.expressions, book)
    here = solved(affine(rows, unknowns, state), unknowns)
    assert here.consistent
    assert set(unknowns) <= set(here.values), "the equations do not determine all accelerations"
    whole = moved(expressed, configuration, state, {u: here.values[u] for u in unknowns})
    there = accelerations(route, whole)
    assert there.consistent
    wanted = {f"{q}''": there.values[f"{q}''"] for q in route.coordinates}
    agree(wanted, whole)


# -- spot values -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("name", "choice"), [*((name, "") for name in SYSTEMS), *CHOICES])
def test_spot_value(name: str, choice: str) -> None:
    """The numbers that are printed: put into the second route, they give the accelerations that are printed."""
    book, solution, route = SYSTEMS[name], solution_of(name).solution, routes_of(name)[0]
    if choice:
        found = next(c for c in solution.choices if c.name == choice)
        spot, configuration = found.spot, found.motion.configuration
        written = substitution_of_file(name, choice, configuration)
        expressed = written or {q.name: concrete(e, book) for q, e in configuration.expressed.items()}
    else:
        spot, configuration, expressed = solution.own.spot, solution.own.configuration, {}
    if spot is None:
        assert not choice or book.functions, "there is no spot value"
        assert book.functions or any(c.spot for c in solution.choices), "there is no spot value at all"
        return
    motion = solution.own.motion if not choice else found.motion
    needed = names_in(derived_rows(configuration, motion.expressions, book)) - {a.name for a in spot.accelerations}
    assert needed <= {s.name for s in spot.values}, "numbers are missing that the accelerations depend on"
    state = stated(spot, route, configuration)
    unknowns = {a.name: mpf(str(v)) for a, v in spot.accelerations.items()}
    assert set(unknowns) == {a.name for a in configuration.slots.accelerations}
    whole = moved(expressed, configuration, state, unknowns)
    all_rates = all(f"{q.name}'" in {s.name for s in spot.values} for q in configuration.slots.coordinates)
    for e in (*route.positions, *(route.rates if all_rates else ())):
        assert abs(number(e, whole)) < 1e-4, "the printed state is not possible"
    expected = accelerations(route, whole).values
    for q in route.coordinates:
        there, here = expected[f"{q}''"], whole[f"{q}''"]
        assert abs(there - here) < 2e-4 * (1 + abs(there)), (
            f"{q}'': {mp.nstr(here)} is printed, {mp.nstr(there)} is right"
        )


def stated(spot: SpotValue, route: Route, configuration: Configuration) -> dict[str, mpf]:
    """The printed numbers; a state needs no others but values of coordinates that do not occur."""
    state = {s.name: mpf(str(sp.N(v, 20))) for s, v in spot.values.items()}
    moving_names = {n + p for n in (s.name for s in configuration.slots.coordinates) for p in ("", "'")}
    for n in (route.names | moving_names) - set(state):
        if n.rstrip("'") in route.coordinates and n not in moving_names:
            continue
        if n not in route.unknowns:
            state[n] = mpf("0.7")
    for sign in (s for e in configuration.expressed.values() for s in e.atoms(Sign)):
        state.setdefault(sign.name, mpf(1))
    return state


# -- a doubt -----------------------------------------------------------------------------------------------------------


def test_a_substitution_that_needs_a_positive_radius_is_refused_with_the_reason() -> None:
    """sqrt(x^2 + y^2) = z + l with x = r cos phi, y = r sin phi, z = r - l: true for r > 0 only."""
    text = (SYSTEM_FILES / "hole_in_table.yaml").read_text(encoding="utf-8")
    polar = "  polar: {coordinates: [r, phi], substitute: {x: r*cos(phi), y: r*sin(phi), z: r - l}}\n"
    problem = read_problem(
        Source("polar", text.replace("generalized_coordinates:\n", "generalized_coordinates:\n" + polar))
    )
    with pytest.raises(ProblemError) as refused:
        report(problem)
    assert "positive coordinates only" in refused.value.show()
