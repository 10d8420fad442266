"""Laws that hold for every problem: what changes its statement and not its mechanics changes nothing that is found.

Problems of `systems/` are rewritten as text (names, order, factors, derivatives, redundant constraints) by rules that
Hypothesis draws, and solved again. Accelerations are compared as numbers at states on the constraint surface.
"""

from __future__ import annotations

import copy
import random
import re
from collections.abc import Mapping
from functools import cache
from typing import Any

import pytest
import sympy as sp
import yaml
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from mpmath import mp, mpf

from lagrange.core.diagnostics import Source
from lagrange.mechanics.constraints.classification import Classification
from lagrange.mechanics.dynamics.lagrangian import kinetic_energy
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem
from tests.support.chance import times
from tests.support.paths import SYSTEM_FILES
from tests.support.second_route import AGREED, DIGITS, Route, affine, number, solved, states
from tests.truth.test_textbook_systems import derived_rows, differentiated, names_in
from tests.truth.textbook_systems import SYSTEMS

Data = dict[str, Any]

LAW = settings(
    max_examples=times(6), deadline=None, derandomize=True, suppress_health_check=[HealthCheck.too_slow], database=None
)

CONSTRAINED = (
    "sphere",
    "bead_on_parabola",
    "rotating_hoop",
    "cart_with_pendulum",
    "kapitza",
    "block_on_wedge",
    "moving_incline",
    "atwood",
    "trammel",
    "skate_with_masses",
    "heisenberg",
    "drifting_skate",
    "turning_rail",
    "integrable_together",
    "dumbbell_with_blade_at_end",
    "two_wheels",
    "hidden_by_a_plane",
    "line_in_disguise",
    "stretched_dumbbell",
)
GEOMETRIC = tuple(n for n in CONSTRAINED if n in {
    "sphere", "bead_on_parabola", "rotating_hoop", "cart_with_pendulum", "kapitza", "block_on_wedge", "moving_incline",
    "atwood", "trammel", "dumbbell_with_blade_at_end", "hidden_by_a_plane", "stretched_dumbbell",
})  # fmt: skip


@cache
def text_of(name: str) -> str:
    return (SYSTEM_FILES / f"{name}.yaml").read_text(encoding="utf-8")


def data_of(name: str) -> Data:
    """The file without choices and answers, all scalars as text."""
    data = yaml.load(text_of(name), Loader=yaml.BaseLoader)
    return {k: v for k, v in data.items() if k not in ("generalized_coordinates", "answers")}


def solution_of(data: Data) -> Solution:
    return solve(read_problem(Source("law.yaml", yaml.safe_dump(data, sort_keys=False))))


@cache
def original(name: str) -> Solution:
    return solution_of(data_of(name))


@cache
def route_of(name: str) -> Route:
    return SYSTEMS[name].routes()[0]


@cache
def some_states(name: str) -> tuple[dict[str, mpf], ...]:
    prescribed = {f"{n}{p}" for n in ("u", "s") for p in ("", "'", "''", "'''")}
    return tuple(states(route_of(name), prescribed | {"l", "x0"}, SYSTEMS[name].ranges, 7, 1))


def accelerations(solution: Solution, state: Mapping[str, mpf], name: str) -> dict[str, mpf]:
    rows = derived_rows(solution.own.configuration, solution.own.motion.expressions, SYSTEMS[name])
    unknowns = [a.name for a in solution.own.configuration.slots.accelerations]
    found = solved(affine(rows, unknowns, state), unknowns)
    assert found.consistent
    assert set(found.values) == set(unknowns), "the equations do not determine the accelerations"
    return dict(found.values)


@cache
def original_accelerations(name: str) -> tuple[dict[str, mpf], ...]:
    return tuple(accelerations(original(name), state, name) for state in some_states(name))


def same_motion(name: str, changed: Solution, renamed: Mapping[str, str] | None = None) -> None:
    renamed = renamed or {}

    def new(symbol: str) -> str:
        root = symbol.rstrip("'")
        return renamed.get(root, root) + symbol[len(root) :]

    for state, before in zip(some_states(name), original_accelerations(name), strict=True):
        there = accelerations(changed, {new(k): v for k, v in state.items()}, name)
        for q, value in before.items():
            assert abs(value - there[new(q)]) < AGREED * (1 + abs(value)), q


def summary(c: Classification) -> tuple[object, ...]:
    words = (c.holonomic, c.scleronomic, c.catastatic)
    return (*words, c.rank, c.integrable_rank, c.degrees_of_freedom, c.configuration_dimension)


def integrability(c: Classification) -> dict[str, bool | None]:
    return {k.constraint.name: k.integrable for k in c.constraints}


def replaced(data: Any, rule: Mapping[str, str]) -> Any:
    """The data with names replaced everywhere, in keys and texts."""
    if isinstance(data, dict):
        return {replaced(k, rule): replaced(v, rule) for k, v in data.items()}
    if isinstance(data, list):
        return [replaced(v, rule) for v in data]
    return re.sub(r"[A-Za-z_][A-Za-z_0-9]*", lambda m: rule.get(m[0], m[0]), data)


def equation_of(entry: Any) -> tuple[str, str]:
    text = entry["equation"] if isinstance(entry, dict) else entry
    left, right = text.split("=")
    return left.strip(), right.strip()


def with_equation(entry: Any, text: str) -> Any:
    return {**entry, "equation": text} if isinstance(entry, dict) else text


def as_text(expression: sp.Expr) -> str:
    return str(expression).replace("**", "^")


@cache
def left_sides(name: str) -> dict[str, sp.Expr]:
    """Left side less right side of each constraint as the program reads it: tested against a second route elsewhere."""
    return {c.name: c.function for c in original(name).problem.constraints}


# -- the laws ----------------------------------------------------------------------------------------------------------


NEW_NAMES = ("a9", "zeta", "Q", "u_1", "e", "S", "q_2", "N", "beta", "X_A", "y_", "w", "xi", "E")


@pytest.mark.parametrize("name", ["cart_with_pendulum", "dumbbell_with_blade_at_end", "two_wheels", "rotating_hoop"])
@settings(LAW, max_examples=times(3))
@given(data=st.data())
def test_renaming_coordinates_permutes_the_result(name: str, data: st.DataObject) -> None:
    coordinates = [q.symbol.name for q in original(name).problem.coordinates]
    names = data.draw(st.permutations(NEW_NAMES).map(lambda p: p[: len(coordinates)]))
    order = data.draw(st.permutations(range(len(coordinates))))
    rule = dict(zip(coordinates, names, strict=True))
    changed = replaced(data_of(name), {**rule, "e": "along", "n": "across"})
    changed["coordinates"] = [changed["coordinates"][k] for k in order]
    found = solution_of(changed)
    assert [q.symbol.name for q in found.problem.coordinates] == [names[k] for k in order]
    assert summary(found.classification) == summary(original(name).classification)
    assert integrability(found.classification) == integrability(original(name).classification)
    assert found.holds
    same_motion(name, found, rule)


FACTORS = ("2", "-3", "exp({q})", "(1 + {q}^2)", "(2 + cos({q}))", "l", "1/(3 + {q}^4)", "l^2/7", "exp({q}*{p})")


@LAW
@given(name=st.sampled_from(CONSTRAINED), data=st.data())
def test_scaling_a_constraint_changes_neither_class_nor_motion(name: str, data: st.DataObject) -> None:
    changed = data_of(name)
    coordinates = [q.symbol.name for q in original(name).problem.coordinates]
    for constraint, entry in changed["constraints"].items():
        q, p = (data.draw(st.sampled_from(coordinates)) for _ in range(2))
        factor = data.draw(st.sampled_from(FACTORS)).format(q=q, p=p)
        parameters = changed["parameters"]
        if "l" in re.findall(r"[A-Za-z_]+", factor) and "l" not in parameters:
            changed["parameters"] = (
                [*parameters, "l"] if isinstance(parameters, list) else {**parameters, "l": "positive"}
            )
        if "d(" in str(entry):
            continue
        left, right = equation_of(entry)
        changed["constraints"][constraint] = with_equation(entry, f"{factor}*({left}) = {factor}*({right})")
    found = solution_of(changed)
    assert summary(found.classification) == summary(original(name).classification)
    assert integrability(found.classification) == integrability(original(name).classification)
    assert found.holds
    same_motion(name, found)


@LAW
@given(name=st.sampled_from(GEOMETRIC), data=st.data())
def test_the_rate_of_a_constraint_says_the_same(name: str, data: st.DataObject) -> None:
    """f = 0 and df/dt = 0: the same verdict on integrability, the same motion."""
    changed = data_of(name)
    functions = left_sides(name)
    kinematic = {c.name for c in original(name).problem.kinematic}
    choice = sorted(set(functions) - kinematic)
    chosen = data.draw(st.sets(st.sampled_from(choice), min_size=1))
    if name == "hidden_by_a_plane":
        return  # the track is integrable only where z = 0, which the rate does not say
    for constraint in sorted(chosen):
        rate = differentiated(functions[constraint], original(name).own.configuration)
        changed["constraints"][constraint] = f"{as_text(rate)} = 0"
    found = solution_of(changed)
    assert summary(found.classification) == summary(original(name).classification)
    assert integrability(found.classification) == integrability(original(name).classification)
    assert found.holds
    same_motion(name, found)


@LAW
@given(name=st.sampled_from(CONSTRAINED), data=st.data())
def test_a_redundant_constraint_changes_nothing(name: str, data: st.DataObject) -> None:
    changed = data_of(name)
    functions = left_sides(name)
    kinematic = {c.name for c in original(name).problem.kinematic}
    coordinates = [q.symbol.name for q in original(name).problem.coordinates]
    constraint = data.draw(st.sampled_from(sorted(functions)))
    f = functions[constraint]
    ways = ["twice", "multiple", "sum"] + (["rate"] if constraint not in kinematic else [])
    way = data.draw(st.sampled_from(ways))
    if way == "multiple":
        f = f * (1 + sp.Symbol(data.draw(st.sampled_from(coordinates)), real=True) ** 2)
    elif way == "rate":
        f = differentiated(f, original(name).own.configuration)
    elif way == "sum":
        others = [g for n, g in functions.items() if (n in kinematic) == (constraint in kinematic)]
        f = sp.Add(*(2 * g for g in others))
    entries = list(changed["constraints"].items())
    place = data.draw(st.integers(0, len(entries)))
    entries.insert(place, ("more", f"{as_text(f)} = 0"))
    changed["constraints"] = dict(entries)
    found = solution_of(changed)
    assert summary(found.classification) == summary(original(name).classification)
    assert len(found.classification.redundant) == 1
    assert found.holds
    same_motion(name, found)


@LAW
@given(name=st.sampled_from(CONSTRAINED), data=st.data())
def test_the_order_of_entries_does_not_matter(name: str, data: st.DataObject) -> None:
    changed = copy.deepcopy(data_of(name))
    for section in ("constraints", "particles", "forces"):
        if section in changed:
            changed[section] = dict(data.draw(st.permutations(list(changed[section].items()))))
    found = solution_of(changed)
    assert summary(found.classification) == summary(original(name).classification)
    assert integrability(found.classification) == integrability(original(name).classification)
    assert found.holds
    same_motion(name, found)


@LAW
@given(name=st.sampled_from(GEOMETRIC), data=st.data())
def test_a_multiple_of_all_masses_and_forces_changes_nothing(name: str, data: st.DataObject) -> None:
    """Masses, and with them weights and potentials, in another unit: accelerations are the same."""
    changed = data_of(name)
    if changed.get("forces"):
        return
    factor = data.draw(st.sampled_from(["2", "7/3", "(1 + pi)", "l^2"]))
    parameters = changed["parameters"]
    if "l" in factor and "l" not in parameters:
        changed["parameters"] = [*parameters, "l"] if isinstance(parameters, list) else {**parameters, "l": "positive"}
    for particle in changed["particles"].values():
        particle["mass"] = f"{factor}*({particle['mass']})"
    same_motion(name, solution_of(changed))


# -- energy ------------------------------------------------------------------------------------------------------------


POTENTIALS = {
    "sphere": "-m*g*z",
    "bead_on_parabola": "m*g*y",
    "cart_with_pendulum": "-m*g*y",
    "four_bar": "-m1*g*y1 - m2*g*y2",
    "kepler": "-kappa/r",
    "elastic_pendulum": "-m*g*r*cos(phi) + kappa*(r - l0)^2/2",
    "spherical_pendulum": "-m*g*l*cos(theta)",
    "triple_pendulum": "-m*g*l*(3*cos(a) + 2*cos(b) + cos(c))",
    "knife_edge": "-2*m*g*sin(alpha)*y",
    "chaplygin_sleigh": "0",
    "heisenberg": "m*g*z",
    "two_wheels": "0",
    "bicycle": "0",
    "torus": "m*g*z",
    "swinging_atwood": "-m*g*r*cos(phi) - M*g*y",
    "rack_and_arm": "-M*g*y - m*g*b*sin(phi)",
    "two_spheres": "m*g*z",
    "charged_pendulum": "-m*g*z",
}


@pytest.mark.parametrize("name", POTENTIALS)
def test_energy_is_conserved(name: str) -> None:
    """dT/dt + dV/dt = 0 along the motion, where constraints are at rest and forces have a potential or no power."""
    found = original(name)
    configuration = found.own.configuration
    symbols = {s.name: s for e in (kinetic_energy(configuration),) for s in e.free_symbols}
    symbols |= {q.symbol.name: q.symbol for q in found.problem.coordinates}
    symbols |= {p.symbol.name: p.symbol for p in found.problem.parameters}
    potential = sp.sympify(POTENTIALS[name].replace("^", "**"), locals=symbols)
    rate = differentiated(kinetic_energy(configuration) + potential, configuration)
    extra = names_in([rate]) - {a.name for a in configuration.slots.accelerations}
    for state in states(route_of(name), extra, SYSTEMS[name].ranges, 11, 2):
        with mp.workdps(DIGITS):
            whole = {**state, **accelerations(found, state, name)}
            assert abs(number(rate, whole)) < AGREED * (1 + abs(number(kinetic_energy(configuration), whole)))


@pytest.mark.parametrize(
    "name", ["kapitza", "rotating_hoop", "moving_incline", "growing_circle", "sphere_with_moving_centre"]
)
def test_moving_constraints_feed_energy(name: str) -> None:
    """There the energy is not constant: the law above is not empty."""
    found = original(name)
    configuration = found.own.configuration
    rate = differentiated(kinetic_energy(configuration), configuration)
    source = random.Random(5)
    extra = names_in([rate]) - {a.name for a in configuration.slots.accelerations} | {"u''", "w''"}
    state = next(iter(states(route_of(name), extra, SYSTEMS[name].ranges, source.randint(0, 99), 1)))
    weight = [
        number(l.vector.fixed().dot(l.point.fixed().time_derivative(configuration.slots)), state)
        for l in configuration.loads
    ]
    whole = {**state, **accelerations(found, state, name)}
    assert abs(number(rate, whole) - sum(weight)) > mpf("1e-6")
