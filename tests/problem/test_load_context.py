"""How expressions of a file are read.

A name that brings its words along.

Namespaces of a file.
"""

from __future__ import annotations

import sympy as sp

from lagrange.core.diagnostics import Fragment
from lagrange.core.symbols import prime
from lagrange.core.vectors import Vector
from lagrange.problem.load_context import SpokenName, expanded_size, place_of_symbol
from lagrange.problem.model import AppliedForce, AppliedMoment
from tests.support.problem_texts import ALL, read, readings

x = sp.Symbol("x", real=True)


def test_the_place_of_a_symbol_with_its_primes() -> None:
    fragment = Fragment.of("a + x'' - b")
    span = place_of_symbol(prime(prime(x)), fragment)
    assert fragment.text[span.start : span.end] == "x''"
    elsewhere = place_of_symbol(sp.Symbol("w", real=True), fragment)
    assert (elsewhere.start, elsewhere.end) == (0, len(fragment.text))


def test_the_size_counts_what_is_written_out() -> None:
    assert expanded_size(x) < expanded_size(x + 1) < expanded_size((x + 1) ** 2 * (x + 1))


# Spoken name


def test_a_name_with_words_is_the_name_in_every_other_respect() -> None:
    upper = SpokenName("P1", "upper particle")
    assert upper == "P1"
    assert {upper: 1}["P1"] == 1
    assert f"r_{upper}" == "r_P1"
    assert upper.words == "upper particle"
    assert SpokenName("P1").words == ""


# Declared names


x_declared_names, y, theta = (sp.Symbol(n, real=True) for n in ("x", "y", "theta"))
m, l, g, k, c, F, R, mu, A, C, I_G = sp.symbols("m l g k c F R mu A C I_G", positive=True)


def vector(*components: sp.Expr | int) -> Vector:
    p, q, r = (sp.sympify(e) for e in components)
    return Vector((p, q, r))


def test_namespaces_are_apart() -> None:
    """A constraint, a body, a force and a choice may share a name, and a symbol may have it too."""
    problem = read(
        "title: T\nparameters: [rod, m]\ncoordinates: [x, theta]\n"
        "bodies: {rod: {mass: rod, inertia: m, position: x*i, angle: theta}}\nconstraints: {rod: x = rod}\n"
        "forces: {rod: {on: rod, vector: rod*i}}\ngeneralized_coordinates: {rod: {coordinates: [x, theta]}}\n"
    )
    assert problem.constraints[0].function == x_declared_names - sp.Symbol("rod", positive=True)
    assert problem.bodies[0].name == problem.forces[0].name == problem.choices[0].name == "rod"


def test_names_of_other_languages_are_free() -> None:
    names = [
        "e",
        "E",
        "I",
        "S",
        "N",
        "Q",
        "beta",
        "lambda",
        "d",
        "n",
        "y",
        "no",
        "on",
        "yes",
        "off",
        "true",
        "null",
        "gamma",
    ]
    problem = read(f"title: T\ncoordinates: [{', '.join(names)}]\nconstraints: {{a: {' + '.join(names)} = 0}}\n")
    assert [str(q.symbol) for q in problem.coordinates] == names
    assert problem.constraints[0].function == sp.Add(*(q.symbol for q in problem.coordinates))


def test_a_declared_k_stays_a_stiffness_where_a_scalar_is_meant() -> None:
    problem = read(ALL + "forces: {a: {on: P, vector: -k*x*i}, b: {on: B, moment: F*k}}\n")
    pull, torque = problem.forces
    assert isinstance(pull, AppliedForce)
    assert pull.vector == vector(-k * x_declared_names, 0, 0)
    assert isinstance(torque, AppliedMoment)
    assert torque.moment == vector(0, 0, F)
    [note] = readings(problem)
    assert (note.code, note.level) == ("read-as", "note")
    assert "e_z" in note.help
