"""Wrong positions of equilibrium, and wrong forces that hold a system: the changed problem for which they are right.

At rest the equations of a system are

    E_k = Σ_a μ_a ( ∂_t (J_ka J_ta) − ½ ∂_k J_ta² ) − Q_k = Σ_j λ_j a_jk ,

where the first sum occurs only in moving frames. A stated equation is solved for a letter that occurs linearly in it: a
force, a weight, a stiffness. With this substituted, a changed problem, or another meaning of the letters, explains the
answer if E_k = 0, or if the rank of (a, E) is that of a. That is one exact test for each change, and no equation has to
be solved for a position.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from itertools import combinations

import sympy as sp

from lagrange.algebra.closed_forms.solution_sets import has_root
from lagrange.algebra.exact.zero_test import DivisionByZeroError, NoPointError, UnsupportedError
from lagrange.answers.limits import (
    MAX_RESTING_MODELS,
    MOST_RESTING_COORDINATES,
    MOST_RESTING_FACTORS,
    MOST_RESTING_ROWS,
)
from lagrange.answers.models.mechanics import Inertia, Mechanics, mechanics_of
from lagrange.answers.models.table import MODELS
from lagrange.answers.models.variation import Variation
from lagrange.core.symbols import Slots, partial, t
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from lagrange.problem.model import Problem

Substitution = Mapping[sp.Basic, sp.Basic]
_LIKELIER = ("gravity reversed", "carried weight left out", "force left out")
_LESS_LIKELY = ("force with another factor", "force in the wrong equation")
"""At rest an arm is taken wrongly more often than a weight, and a force forgotten more often than reversed."""


class Resting:
    """Changes of a problem, tried on wrong equations of its equilibrium."""

    def __init__(self, equilibrium: Equilibrium, values: Substitution) -> None:
        self.equilibrium = equilibrium
        self.configuration = equilibrium.configuration
        self.slots: Slots = self.configuration.slots
        self.values = dict(values)
        self.rows = [row.coefficients for row in equilibrium.binding]

    @property
    def small(self) -> bool:
        """Whether there are few constraints and coordinates."""
        return len(self.rows) <= MOST_RESTING_ROWS and len(self.slots.coordinates) <= MOST_RESTING_COORDINATES

    @property
    def usable(self) -> bool:
        """Whether the balance of forces is small enough to be tried, and has no roots, whose signs would be open."""
        return self.small and not any(map(has_root, self.own))

    @cached_property
    def own(self) -> tuple[sp.Expr, ...]:
        """E_k of the problem itself."""
        return tuple(-q for q in self.equilibrium.work.forces)

    def solved(self, equations: Sequence[sp.Expr], *fixed: sp.Symbol) -> dict[sp.Expr, sp.Expr] | None:
        """Equations as a rule for letters other than those that are fixed, or for the sine or cosine of an angle, each
        in one of them; None if one cannot be written so."""
        rule: dict[sp.Expr, sp.Expr] = {}
        bound = {s for row in self.rows for a in row for s in a.free_symbols}
        bound |= {s for f in self.configuration.finite_constraints for s in f.free_symbols}
        coordinates = {*self.slots.coordinates}
        if any(map(has_root, equations)):
            return None
        for equation in equations:
            equation = equation.replace(sp.tan, lambda x: sp.sin(x) / sp.cos(x))
            equation = equation.replace(sp.cot, lambda x: sp.cos(x) / sp.sin(x))
            e = sp.together(equation.xreplace(self.values).xreplace(rule))
            e = sp.numer(e)
            free = e.free_symbols - bound - {*rule, *fixed, t}
            letters = sorted(free, key=lambda s: (s in coordinates, s not in self.equilibrium.forces, str(s)))
            waves = sorted((w for w in e.atoms(sp.sin, sp.cos) if w.args[0] in coordinates), key=str, reverse=True)
            for s in (*letters, *waves):
                stand_in = s if s.is_Symbol else sp.Dummy()
                with_it = e if s.is_Symbol else e.xreplace({s: stand_in})
                slope = sp.diff(with_it, stand_in)
                if slope != 0 and stand_in not in slope.free_symbols and not (slope.has(s) and s in waves):
                    value = -with_it.xreplace({stand_in: sp.S.Zero}) / slope
                    rule = {k: v.xreplace({s: value}) for k, v in rule.items()} | {s: value}
                    break
            else:
                return None
        return rule

    def balanced(self, forces: Sequence[sp.Expr], rule: Substitution) -> bool:
        """Whether forces E_k are balanced, by reactions alone, where a rule holds."""
        put = [f.xreplace(self.values).xreplace(dict(rule)) for f in forces]
        rows = [[a.xreplace(self.values).xreplace(dict(rule)) for a in row] for row in self.rows]
        surface = self.configuration.surface
        size = len(rows) + 1
        try:
            return all(
                surface.is_zero(sp.Matrix([[r[k] for k in chosen] for r in (*rows, put)]).det(method="berkowitz"))
                is True
                for chosen in combinations(range(len(put)), size)
            )
        except (DivisionByZeroError, NoPointError, UnsupportedError, ValueError):
            return False

    def changed(self, problem: Problem) -> Iterator[tuple[Variation, tuple[sp.Expr, ...]]]:
        """The changed problems in which other forces act at rest, each with its E_k; none if the parts do not add up
        to the problem itself."""
        try:
            m = mechanics_of(self.configuration, problem)
            same = all(
                self.configuration.surface.is_zero(a - b) is True
                for a, b in zip(self._at_rest(m), self.own, strict=True)
            )
        except (DivisionByZeroError, NoPointError, UnsupportedError, ValueError):
            return
        if not same:
            return
        number = 0
        for model in sorted(MODELS, key=lambda n: (n.name in _LESS_LIKELY) - (n.name in _LIKELIER)):
            for variation in model.changes(m):
                changed = variation.mechanics
                if changed is None or variation.quasi is not None or changed.kept != m.kept:
                    continue
                if changed.forces == m.forces and not self._driven(changed.inertias):
                    continue
                number += 1
                if number > MAX_RESTING_MODELS:
                    return
                yield variation, self._at_rest(changed)

    def _driven(self, inertias: Sequence[Inertia]) -> bool:
        return any(c != 0 for i in inertias for c in i.columns[-1])

    def _at_rest(self, m: Mechanics) -> tuple[sp.Expr, ...]:
        rest = dict.fromkeys((*self.slots.velocities, *self.slots.accelerations), sp.S.Zero)
        total = [sp.S.Zero for _ in self.slots.coordinates]
        for f in m.forces:
            for k, share in enumerate(f.shares):
                total[k] -= f.factor * share.xreplace(rest)
        for i in m.inertias if self._driven(m.inertias) else ():
            for k, share in enumerate(self._of_frame(i)):
                total[k] += share
        return tuple(total)

    def _of_frame(self, i: Inertia) -> Iterator[sp.Expr]:
        """What the motion of a frame adds to each E_k at rest."""
        last, pairs = len(self.slots.coordinates), dict(i.pairs)
        drift = i.columns[-1]
        square = sp.Add(*(w * c**2 for w, c in zip(i.weights, drift, strict=True)))
        for k, q in enumerate(self.slots.coordinates):
            mixed = sp.Add(*(w * a * b for w, a, b in zip(i.weights, i.columns[k], drift, strict=True)))
            change = self.slots.frozen_derivative(mixed) * i.product * i.explicit * pairs.get((k, last), sp.S.One)
            bend = partial(square, q) * i.gradient * pairs.get((last, last), sp.S.One)
            yield sp.S.Zero if k in i.still else i.factor * (change - bend / 2)


class WrongEquilibria:
    """Wrong alternatives of an answer about equilibria, each with all its equations, and what explains them."""

    def __init__(self, wrong: Sequence[Sequence[sp.Expr]], equilibrium: Equilibrium, values: Substitution) -> None:
        self.wrong = wrong
        self.resting = Resting(equilibrium, values)
        self.rules = [self.resting.solved(a) for a in wrong] if self.resting.usable else [None]

    @property
    def tried(self) -> bool:
        """Whether changes can be tried on them."""
        return bool(self.rules) and None not in self.rules

    def holds(self, variation: Variation) -> bool:
        """Whether they are right with another meaning of a letter, or in a special case."""
        meant, resting = dict(variation.rule), self.resting
        if variation.values:
            resting = Resting(resting.equilibrium, {**resting.values, **variation.values})
        rules = [resting.solved([e.xreplace(meant) for e in a]) for a in self.wrong]
        own = resting.own
        return not resting.balanced(own, {}) and all(r is not None and resting.balanced(own, r) for r in rules)

    def of_changed_problem(self, problem: Problem) -> str:
        """The changed problem whose equilibria they are, as the end of a sentence; empty if not found."""
        for variation, forces in self.resting.changed(problem):
            if all(
                r is not None and self.resting.balanced(forces, r) for r in self.rules
            ) and not self.resting.balanced(forces, {}):
                size = next((w for w in ("twice as large", "half as large") if variation.clause.endswith(w)), "")
                acts = size and variation.clause.startswith(("for the weight", "for the force"))
                arm = f", or acting at {size.split()[0]} the distance" if acts else ""
                return f"{variation.clause}{arm}"
        return ""

    def of_one_force(self, problem: Problem) -> str:
        """Which force contributes something else in the one wrong alternative, as the end of a sentence; empty if not
        found. A length with a root in it counts as a letter."""
        from lagrange.answers.results.contributions import contributions

        resting = self.resting
        if len(self.wrong) != 1 or not resting.small:
            return ""
        try:
            m = mechanics_of(resting.configuration, problem)
            shares = [s for f in m.forces for s in f.shares]
            roots = {p for e in (*shares, *self.wrong[0]) for p in e.atoms(sp.Pow) if not p.exp.is_Integer}
            bases = {p.base for p in roots}
            if len(bases) > 1 or any((2 * p.exp).is_Integer is not True for p in roots):
                return ""
            length = sp.Dummy("length", positive=True)
            letters: dict[sp.Basic, sp.Basic] = {p: length ** (2 * p.exp) for p in roots}
            rule = resting.solved([e.xreplace(letters) for e in self.wrong[0]], length)
            if rule is None:
                return ""
            m = m.force(lambda f: replace(f, shares=tuple(s.xreplace(letters) for s in f.shares)))
            written = {length: sp.sqrt(sp.Add(*bases))}  # there is one, or none
            return contributions(m, rule, resting.values, resting.rows, written)
        except (DivisionByZeroError, NoPointError, UnsupportedError, ValueError):
            return ""

    def missing_factor(self, lhs: sp.Expr, rhs: sp.Expr) -> sp.Expr | None:
        """What the right side of the one wrong equation has to be multiplied by; None if that is no product of powers
        of a few letters."""
        factor = sp.Symbol("factor", positive=True)
        rule = self.resting.solved([lhs - factor * rhs], factor)
        if self.resting.rows or rule is None:
            return None
        factors = {*()}
        for force in self.resting.own:
            whole = sp.numer(sp.together(force.xreplace(self.resting.values).xreplace(rule)))
            slope = sp.diff(whole, factor)
            if slope == 0 and whole == 0:
                continue
            if slope == 0 or factor in slope.free_symbols:
                return None
            factors.add(sp.factor(sp.cancel(-whole.xreplace({factor: sp.S.Zero}) / slope)))
        value = factors.pop() if len(factors) == 1 else None
        if value is None or value in (0, 1) or value.free_symbols & {*self.resting.slots.coordinates}:
            return None
        parts = [p.as_base_exp()[0] for p in sp.Mul.make_args(value) if not p.is_Rational]
        plain = all(p.is_Symbol or isinstance(p, sp.sin | sp.cos | sp.tan) for p in parts)
        return value if plain and len(parts) <= MOST_RESTING_FACTORS else None


def angles_and_lengths(stated: Sequence[sp.Expr], e: Equilibrium) -> Iterator[Variation]:
    """Half an angle, or twice one, for the angle itself; a coordinate and a parameter exchanged under a root, as the
    legs of a triangle are."""
    coordinates = [q for q in e.configuration.slots.coordinates if any(q in c.free_symbols for c in stated)]
    waves = {w for c in stated for w in c.atoms(sp.sin, sp.cos, sp.tan)}
    for q in coordinates:
        if (sp.tan(q / 2) in waves or sp.sin(q / 2) in waves) and sp.tan(q) not in waves:
            yield Variation(f"with {q}/2 in place of {q}", "", rule={q: 2 * q})
        elif sp.tan(2 * q) in waves or sp.sin(2 * q) in waves:
            yield Variation(f"with 2*{q} in place of {q}", "", rule={q: q / 2})
    placed = {s for f in e.configuration.finite_constraints for s in f.free_symbols}
    used, moving = {s for c in stated for s in c.free_symbols}, {*e.configuration.slots.coordinates}
    for q in sorted((moving & placed) - used, key=str):
        for p in sorted((used & placed) - moving, key=str):
            yield Variation(f"with {p} in place of {q}", "", rule={p: q})
    functions = {type(w) for w in waves}
    if len(functions) == 1 and all(any(abs(sp.expand(c).coeff(w)) == 1 for w in c.atoms(*functions)) for c in stated):
        [own] = functions
        for other in (f for f in (sp.tan, sp.sin, sp.cos) if f is not own):
            names = own.__name__, other.__name__
            yield Variation(f"with {names[0]} in place of {names[1]}", "", rule={w: other(w.args[0]) for w in waves})
    legs = {r.base for c in stated for r in c.atoms(sp.Pow) if r.exp in (sp.S.Half, -sp.S.Half) and r.base.is_Add}
    for q in coordinates:
        for p in sorted(
            {s for leg in legs if q in leg.free_symbols for s in leg.free_symbols} - {*coordinates}, key=str
        ):
            yield Variation(f"with {q} and {p} exchanged, the two legs of the triangle", "", rule={q: p, p: q})
