"""Finite relations that no single constraint shows: found, and none invented.

Every relation is followed along a random admissible motion, integrated step by step in plain numbers; its gradient is put
into the matrix of the forms at random rational points with SymPy's `Matrix.rank`; and how many there must be is counted by
symbolic Lie brackets. None of that shares code with the search.

Combinations of forms that are differentials: they add up, and lie among the constraints.
"""

from __future__ import annotations

from collections.abc import Callable

import pytest
import sympy as sp
from mpmath import mp

from lagrange.algebra.exact.zero_test import Surface
from lagrange.algebra.forms.hidden_relations import combined_relations, hidden_relations
from lagrange.core.symbols import Slots, t
from lagrange.explain.report import report
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem
from lagrange.render.json import as_object
from tests.algebra.forms.test_derived_flag import in_other_coordinates, many, mixed, six_constraints
from tests.support.exterior import flag_by_brackets, rank
from tests.support.hidden_systems import (
    FOUND,
    SYSTEMS,
    TRAPS,
    System,
    Values,
    admissible_motion,
    forms_of,
    plain,
    somewhere,
)

Read = Callable[[str], Problem]

CONSTANT = 1e-7
CHANGED = 1e-3


every_system = pytest.mark.parametrize("system", SYSTEMS, ids=lambda s: s.name)


def read_expression(read: Read, system: System, text: str) -> sp.Expr:
    found = read(system.text + f"particles: {{P: {{mass: 1, position: ({text})*i}}}}\n")
    return plain(found.particles[0].position.components[0])


def spread(e: sp.Expr, path: list[Values]) -> float:
    """How much an expression changes along a path."""
    found = [float(e.xreplace({s: sp.Float(v, 20) for s, v in values.items()})) for values in path]
    return max(found) - min(found)


@every_system
def test_relations_stay_constant_along_a_random_motion(problem: Read, system: System) -> None:
    read = problem(system.text)
    hidden = solve(read).classification.hidden
    path = admissible_motion(system, read, 1)
    assert max(spread(q, path) for q in read.slots.coordinates) > CHANGED, "nothing moves: the test would be empty"
    for relation in hidden.found:
        assert spread(plain(relation.function), path) < CONSTANT


@every_system
def test_as_many_as_there_are(problem: Read, system: System) -> None:
    """An integrable constraint on velocities is shown by its own integral where that is known, else as a relation."""
    found = solve(problem(system.text)).classification
    shown = sum(c.row.finite is not None for c in found.constraints)
    shown += sum(c.row.finite is None and c.integral is not None for c in found.independent)
    assert found.hidden.missing == system.missing
    assert found.integrable_rank == system.total == shown + len(found.hidden.found) + system.missing


@pytest.mark.parametrize("system", [s for s in TRAPS if not s.hidden], ids=lambda s: s.name)
def test_nothing_is_invented(problem: Read, system: System) -> None:
    assert solve(problem(system.text)).classification.hidden.found == ()


@pytest.mark.parametrize("system", [s for s in SYSTEMS if not s.start], ids=lambda s: s.name)
def test_the_number_by_symbolic_brackets(problem: Read, system: System) -> None:
    read = problem(system.text)
    assert flag_by_brackets(forms_of(read), (*read.slots.coordinates, t))[-1] == system.total


@pytest.mark.parametrize("system", [s for s in SYSTEMS if s.hidden], ids=lambda s: s.name)
def test_the_relations_are_those_expected(problem: Read, system: System) -> None:
    """The gradients expected lie in the span of what was found, what is known and the geometric constraints."""
    read = problem(system.text)
    found = solve(read).classification
    expected = [read_expression(problem, system, text) for text in system.hidden]
    functions = [plain(r.function) for r in found.hidden.found]
    functions += [plain(c.integral) for c in found.constraints if c.integral is not None]
    path = admissible_motion(system, read, 2)
    values = {s: sp.Float(v, 30) for s, v in path[-1].items()}

    def independent_gradients(some: list[sp.Expr]) -> int:
        variables = (*read.slots.coordinates, t)
        table = mp.matrix([[mp.mpf(float(sp.diff(f, v).xreplace(values))) for v in variables] for f in some])
        return sum(s > 1e-9 for s in mp.svd_r(table, compute_uv=False))

    count = independent_gradients(functions)
    assert count == independent_gradients([*functions, *expected]) == len(functions)


def test_the_textbook_relation_as_it_is_written(problem: Read) -> None:
    [relation] = solve(problem(FOUND[0].text)).classification.hidden.found
    p, q, theta = sp.symbols("p q theta", real=True)
    R, b = sp.symbols("R b", positive=True)
    assert relation.function in (R * (p - q) - 2 * b * theta, 2 * b * theta - R * (p - q))
    assert relation.combination in ((0, 1, -1), (0, -1, 1))


def test_logarithms_are_written_as_a_product() -> None:
    x, y, z = sp.symbols("x y z", real=True)
    form = (y * z, 2 * x * z, 3 * x * y, sp.S.Zero)
    found = hidden_relations([form], [], 1, Surface((), (x, y, z)), Slots((x, y, z)))
    assert [r.function for r in found.found] == [x * y**2 * z**3]


def test_json_and_prose(problem: Read) -> None:
    done = report(problem(FOUND[0].text))
    found = as_object(done)
    assert found["classification"]["hidden"] == ["2*b*theta - R*(p - q)"]
    written = str(found["steps"])
    assert "One relation follows that no single constraint shows" in written
    assert "3, the derived systems 2 and 1" in written
    riccati = next(s for s in TRAPS if s.name == "Riccati")
    written = str(as_object(report(problem(riccati.text)))["steps"])
    assert "Two finite relations exist, not found in closed form" in written


@pytest.mark.parametrize(
    ("change", "names"),
    [(list, 2), (mixed, 2), (lambda rows: in_other_coordinates(mixed(rows)), 1)],
    ids=["sparse", "mixed", "moved"],
)
def test_six_constraints_in_twelve_coordinates(change: Callable[..., list[list[sp.Expr]]], names: int) -> None:
    """With trigonometric coefficients; in other coordinates one relation has products that no dictionary holds."""
    rows = [tuple(row) for row in change(six_constraints().forms)]
    slots = Slots(many)
    found = hidden_relations(rows, [], 2, Surface((), many), slots)
    assert len(found.found) == names
    assert found.missing == 2 - names
    table = [[sp.sympify(a) for a in row] for row in rows]
    for relation in found.found:
        point = somewhere([*table, list(relation.differential)], "six")
        assert rank([*table, list(relation.differential)], point) == rank(table, point) == 6


def test_two_trolleys_in_twelve_coordinates(problem: Read) -> None:
    """Six constraints with trigonometric coefficients from the file to the report: each axle hides one relation."""
    rows = []
    for n in (1, 2):
        forward = f"cos(a{n})*x{n}' + sin(a{n})*y{n}'"
        rows.append(f"s{n}: \"sin(a{n})*x{n}' - cos(a{n})*y{n}' = 0\"")
        rows.append(f"l{n}: \"{forward} + b*a{n}' = R*p{n}'\"")
        rows.append(f"r{n}: \"{forward} - b*a{n}' = R*q{n}'\"")
    names = ", ".join(f"{v}{n}" for n in (1, 2) for v in ("x", "y", "a", "p", "q"))
    text = f"title: T\nparameters: [R, b]\ncoordinates: [{names}, u, v]\nconstraints: {{{', '.join(rows)}}}\n"
    done = report(problem(text))
    found = done.solution.classification
    assert done.holds
    assert (found.rank, found.flag.ranks, found.hidden.missing) == (6, (6, 4, 2), 0)
    R, b = sp.symbols("R b", positive=True)
    for n, relation in enumerate(found.hidden.found, start=1):
        a, p, q = (sp.Symbol(f"{v}{n}", real=True) for v in "apq")
        assert sp.expand(relation.function - 2 * b * a + R * (p - q)) == 0


# -- Relations that are added so that a coordinate drops out -----------------------------------------------------------


w, x, y, z = sp.symbols("w x y z", real=True)
R, b = sp.symbols("R b", positive=True)


def test_two_relations_leave_one_with_fewer_coordinates() -> None:
    [found] = combined_relations([R * (x - w) - 2 * b * y, R * (x - w) + 2 * b * z], [w, x, y, z])
    assert sp.expand(found.function - (y + z)) == 0
    assert found.places == (0, 1)


def test_nothing_where_it_is_no_shorter_or_not_linear() -> None:
    assert combined_relations([x + y, y + z], [x, y, z]) == ()
    assert combined_relations([x**2 + y + z, x**3 + y - z], [x]) == ()


# Combinations


@pytest.mark.parametrize("system", [s for s in SYSTEMS if s.hidden and not s.start], ids=lambda s: s.name)
def test_gradients_are_in_the_row_space(problem: Read, system: System) -> None:
    """At random points, by singular values."""
    read = problem(system.text)
    rows = forms_of(read)
    for relation in solve(read).classification.hidden.found:
        gradient = [sp.diff(plain(relation.function), v) for v in (*read.slots.coordinates, t)]
        point = somewhere([*rows, gradient], system.name)
        assert rank([*rows, gradient], point) == rank(rows, point)


@pytest.mark.parametrize("system", [s for s in SYSTEMS if s.hidden], ids=lambda s: s.name)
def test_combinations_add_up(problem: Read, system: System) -> None:
    read = problem(system.text)
    found = solve(read).classification
    path = admissible_motion(system, read, 3)
    values = {s: sp.Float(v, 30) for s, v in path[0].items()}
    forms = [[plain(a) for a in c.row.form] for c in found.independent]
    for relation in found.hidden.found:
        if relation.combination is None:
            continue
        for k, v in enumerate((*read.slots.coordinates, t)):
            total = sp.Add(*(plain(c) * form[k] for c, form in zip(relation.combination, forms, strict=True)))
            assert abs((total - sp.diff(plain(relation.function), v)).xreplace(values).evalf(20)) < 1e-9
