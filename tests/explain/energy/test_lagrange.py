"""The prose about Lagrange's equations, and its place."""

from __future__ import annotations

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.core.symbols import prime
from lagrange.document.derivation import Display, Rule
from lagrange.explain.report import report
from lagrange.mechanics.dynamics.comparison import System, compare
from lagrange.mechanics.dynamics.motion import Method
from lagrange.problem.loader import load
from lagrange.render.json import as_object
from tests.support.derivation_text import words
from tests.support.lagrange_motions import by_lagrange, euler_lagrange, motions
from tests.support.paths import PROBLEMS


def test_an_integrable_constraint_could_be_put_in() -> None:
    """x' = R φ' is equivalent to a finite relation, so that it is not a mistake, and the text does not call it one."""
    found = by_lagrange("rolling_cylinder_by_velocities")
    motion = motions(found)[0]
    configuration, principle = motion.configuration, motion.principle
    slots_ = configuration.slots
    assert all(r.finite is None for r in configuration.rows)
    gone = [slots_.coordinates[k] for k in motion.elimination.dependent]
    forms = [r.velocity_form(slots_) for r in configuration.rows]
    rates = sp.solve(forms, [prime(q) for q in gone], dict=True)[0]
    rest = [q for q in slots_.coordinates if q not in gone]
    lagrangian = principle.kinetic - principle.potential
    shares = {q: sp.Add(*(lagrangian.diff(g) * rates[prime(g)].diff(prime(q)) for g in gone)) for q in rest}
    put_in = euler_lagrange(principle.kinetic.xreplace(rates), rest, motion)
    forces = [lagrangian.diff(q) - principle.kinetic.diff(q) + shares[q] for q in rest]
    same = compare([e - f for e, f in zip(put_in, forces, strict=True)], System(configuration, motion.expressions))
    assert same is not None
    assert same.agree
    said = words(next(s for s in found.derivation.steps if s.rule is Rule.LAGRANGE))
    assert "is equivalent to a finite relation" in said or "are equivalent to finite relations" in said
    assert "would be lost" not in said


def test_quasi_coordinates_have_their_term_told() -> None:
    found = by_lagrange("free_top_quasi")
    [motion] = motions(found)
    assert motion.principle.has_quasi_coordinates
    step = next(s for s in found.derivation.steps if s.rule is Rule.LAGRANGE)
    assert "Hamel" in words(step)
    labels = [e.label for b in step.body if isinstance(b, Display) for e in b.equations]
    assert {"quasi-p", "quasi-q", "quasi-r"} <= set(labels)
    without = [r - p - q for r, p, q in zip(motion.principle.rates, motion.principle.partials, motion.principle.applied, strict=True)]  # fmt: skip
    assert any(
        is_zero(e - c.to_sympy()) is False for e, c in zip(without, motion.principle.coefficients, strict=True)
    )  # left out, the equations would be others


def test_nothing_is_said_of_quasi_coordinates_where_angles_are_given() -> None:
    assert "quasi" not in words(next(s for s in by_lagrange("heavy-top").derivation.steps if s.rule is Rule.LAGRANGE))


def test_statics_is_the_same_page_with_a_remark() -> None:
    path = PROBLEMS / "statics" / "ladder.yaml"
    plain, asked = report(load(path)), report(load(path), method=Method.LAGRANGE)
    assert asked.derivation == plain.derivation
    assert [n.code for n in asked.notes] == ["method-without-motion"]
    assert plain.notes == ()
    assert asked.holds
    assert "method" not in as_object(asked)
