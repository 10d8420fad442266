"""Wrong positions of equilibrium, and wrong forces that hold a system: the changed problem for which they are right.

At rest the equations of a system are

    E_k = Σ_a μ_a ( ∂_t (J_ka J_ta) − ½ ∂_k J_ta² ) − Q_k = Σ_j λ_j a_jk ,

where the first sum occurs only in moving frames. A stated equation is solved for a letter that occurs linearly in it: a
force, a weight, a stiffness. With this substituted, a changed problem, or another meaning of the letters, explains the
answer if E_k = 0, or if the rank of (a, E) is that of a. That is one exact test for each change, and no equation has to
be solved for a position.

Wrong positions of rest, force by force: what one force contributes to the balance as the answer has it.

At rest each equation is a sum of contributions S_f, one of every force: its moment about a hinge, its component along
a direction. A stated equation, solved for a letter and put in, leaves a residue in some of them,

    E_k = −Σ_f S_fk ≠ 0 ,     and     −Σ_f S_fk + (1 − c) S_gk = 0     for   c = 1 + E_k/S_gk ,

so that force g with c S_gk instead of S_gk, another arm, explains the equation of q_k. That is said where c is short:
a number, a ratio of lengths, a sine. Where the residue is the contribution of a force to another equation, that force
was taken to act there as well.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from itertools import combinations

import sympy as sp

from lagrange.algebra.closed_forms.solution_sets import has_root
from lagrange.algebra.exact.expression_graph import DivisionByZeroError, UnsupportedError
from lagrange.algebra.exact.sampler import NoPointError
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.answers.limits import (
    MAX_RESTING_MODELS,
    MOST_RESTING_COORDINATES,
    MOST_RESTING_FACTORS,
    MOST_RESTING_FORCES,
    MOST_RESTING_ROWS,
    RATIO_OPERATIONS,
    SHORTEST_RATIO,
)
from lagrange.answers.models.forces import name_of
from lagrange.answers.models.mechanics import (
    AppliedForceKind,
    ForceShare,
    Inertia,
    Mechanics,
    Variation,
    mechanics_of,
    written,
)
from lagrange.answers.models.table import MODELS, Model
from lagrange.core.symbols import Slots, Unspecified, partial, t
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from lagrange.problem.model import Problem

Substitution = Mapping[sp.Basic, sp.Basic]
_LIKELIER = ("gravity reversed", "carried weight left out", "force left out")
_OTHER_FACTOR = "force with another factor"
_LESS_LIKELY = (_OTHER_FACTOR, "force in the wrong equation")
"""At rest an arm is taken wrongly more often than a weight, and a force forgotten more often than reversed."""
_ACTING_SOMEWHERE = (AppliedForceKind.WEIGHT, AppliedForceKind.FORCE)
_ELASTIC = (AppliedForceKind.SPRING, AppliedForceKind.POTENTIAL)
_SIZES = {sp.Integer(2): ("twice", "half"), sp.Rational(1, 2): ("half", "twice")}
"""A factor in words, and its inverse."""


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
            if e == 0:
                continue  # it says the same as another one
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

    def balanced(
        self, forces: Sequence[sp.Expr], rule: Substitution, rows: Sequence[Sequence[sp.Expr]] | None = None
    ) -> bool:
        """Whether forces E_k are balanced, by reactions alone, where a rule holds.

        An unknown force of which an answer says nothing may be any, as a reaction.
        """
        rows = [*(self.rows if rows is None else rows)]
        open_ = self._unstated(rule)
        slopes = [[f.diff(u) for f in forces] for u in open_]
        if any(not a.free_symbols.isdisjoint(open_) for row in slopes for a in row) or len(open_) + len(rows) >= len(
            forces
        ):
            slopes, open_ = [], []
        forces = [f.xreplace(dict.fromkeys(open_, sp.S.Zero)) for f in forces]
        rows += [row for row in slopes if any(a != 0 for a in row)]
        put = [f.xreplace(self.values).xreplace(dict(rule)) for f in forces]
        rows = [[a.xreplace(self.values).xreplace(dict(rule)) for a in row] for row in rows]
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

    def _unstated(self, rule: Substitution) -> list[sp.Symbol]:
        """The unknown forces that an answer does not mention; none without an answer."""
        used = {s for e in (*rule, *rule.values()) for s in e.free_symbols}
        return [u for u in self.equilibrium.forces if rule and u not in used]

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
        from lagrange.answers.results.virtual_work import in_one_equation_only

        number = 0
        likeliest = sorted(MODELS, key=lambda n: (n.name in _LESS_LIKELY) - (n.name in _LIKELIER))
        if not self.rows:  # of coordinates that constraints bind nobody writes an equation each
            likeliest.append(Model("force left out in one equation", in_one_equation_only))
        for model in likeliest:
            for variation in model.changes(m):
                changed = variation.mechanics
                if changed is None or variation.quasi is not None or changed.kept != m.kept:
                    continue
                if changed.forces == m.forces and not self._driven(changed.inertias):
                    continue
                if model.name == _OTHER_FACTOR:
                    known = self._of_known_forces(variation, m)
                    if known is None:
                        continue
                    variation = known
                number += 1
                if number > MAX_RESTING_MODELS:
                    return
                yield variation, self._at_rest(changed)

    def _of_known_forces(self, variation: Variation, m: Mechanics) -> Variation | None:
        """A variation in which some forces have another factor; None if these are asked for.

        Of two forces that balance, one twice as large is the other one at half the distance.
        """
        assert variation.mechanics is not None
        pairs = [*zip(m.forces, variation.mechanics.forces, strict=True)]
        scaled, rest = [f for f, g in pairs if f != g], [f for f, g in pairs if f == g and any(f.shares)]
        if all(any(not s.free_symbols.isdisjoint(self.equilibrium.forces) for s in f.shares) for f in scaled):
            return None
        factors = {g.factor / f.factor if f.shares == g.shares else None for f, g in pairs if f != g}
        factor = next(iter(factors)) if len(factors) == 1 else None
        if factor not in _SIZES or any(f.kind not in _ACTING_SOMEWHERE for f in scaled):
            return variation
        size, inverse = _SIZES[factor]
        clause = f"{variation.clause}, or acting at {size} the distance"
        if len(rest) == 1 and rest[0].kind in _ACTING_SOMEWHERE:
            clause = f"{clause}, or for {name_of(rest[0])} acting at {inverse} the distance"
        elif rest and all(f.kind in _ELASTIC for f in rest):
            names = " and ".join(map(name_of, rest))
            clause = f"{clause}, or for {names} {inverse} as large"
        return replace(variation, clause=clause)

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

    @cached_property
    def tried(self) -> bool:
        """Whether changes can be tried on them.

        If the forces are balanced as it is, as for θ = 0 beside any other value of θ, every change would seem to fit.
        """
        rules = [r for r in self.rules if r is not None]
        own = self.resting.own
        return 0 < len(rules) == len(self.rules) and not all(self.resting.balanced(own, r) for r in rules)

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
                return variation.clause
        return ""

    def of_one_displacement(self, problem: Problem) -> str:
        """The force whose virtual displacement is taken as a multiple, as the end of a sentence; empty if not found."""
        from lagrange.answers.results.virtual_work import of_one_displacement

        resting = self.resting
        if len(self.rules) != 1 or len(resting.slots.coordinates) != 1 or resting.rows:
            return ""
        forces = [f for f in mechanics_of(resting.configuration, problem).forces if any(f.shares)]
        rule = {**resting.values, **(self.rules[0] or {})}
        return of_one_displacement(forces, rule) if {f.kind for f in forces} <= {*_ACTING_SOMEWHERE} else ""

    def of_differential(self, problem: Problem) -> str:
        """The term of a constraint whose derivative is wrong, in a sentence; empty if not found."""
        from lagrange.answers.results.virtual_work import of_differential

        resting = self.resting

        def balanced(rows: Sequence[Sequence[sp.Expr]]) -> bool:
            return all(rule is not None and resting.balanced(resting.own, rule, rows) for rule in self.rules)

        return of_differential(balanced, resting.equilibrium, problem) if self.tried else ""

    def of_one_force(self, problem: Problem, *, changing: bool = False) -> str:
        """Which force contributes something else in the one wrong alternative, as the end of a sentence; empty if not
        found. A length with a root in it counts as a letter. `changing`: only by a ratio of lengths that change."""
        resting = self.resting
        if len(self.wrong) != 1 or not resting.small or (changing and not resting.rows):
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
            said = contributions(m, rule, resting.values, resting.rows, written)
            turned = {a for w in _waves([*shares, *(a for row in resting.rows for a in row)]) for a in w.free_symbols}
            lengths = {q.name for q in m.slots.coordinates if q not in turned}
            return said if not changing or lengths & {*re.findall(r"\w+", said)} else ""
        except (DivisionByZeroError, NoPointError, UnsupportedError, ValueError):
            return ""

    def of_displacement(self) -> str:
        """The relation between the displacements of two coordinates which the one wrong alternative implies, with the
        forces as they are, in a sentence; empty if it depends on the forces, or there are other coordinates."""
        resting = self.resting
        if len(self.rules) != 1 or len(resting.rows) != 1 or len(resting.slots.coordinates) != 2:
            return ""
        [rule], [row] = self.rules, resting.rows
        if rule is None or any(s in resting.slots.coordinates for s in rule):
            return ""
        put = [sp.cancel(sp.together(f.xreplace(resting.values).xreplace(rule))) for f in resting.own]
        straight = sorted(
            range(2), key=lambda k: any(resting.slots.coordinates[k] in w.free_symbols for w in _waves(row))
        )
        moved, free = straight
        if 0 in (put[moved], row[moved]):
            return ""
        stated, right = (sp.factor(sp.cancel(-f[free] / f[moved])) for f in (put, row))
        forces = stated.free_symbols - right.free_symbols
        if forces or stated == right or sp.count_ops(stated) > 2 * sp.count_ops(right):
            return ""
        q, d = (f"d{resting.slots.coordinates[k]}" for k in (moved, free))
        way = f"{q} = {written(stated, resting.slots)}*{d}"
        return f"with these forces it would be right for the displacements {way}, which the constraint does not give"

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


def _waves(expressions: Sequence[sp.Expr]) -> set[sp.Basic]:
    return {w for e in expressions for w in e.atoms(sp.sin, sp.cos)}


def angles_and_lengths(stated: Sequence[sp.Expr], e: Equilibrium) -> Iterator[Variation]:
    """Half an angle, or twice one, for the angle itself; a coordinate and a parameter exchanged under a root, as the
    legs of a triangle are."""
    coordinates = [q for q in e.configuration.slots.coordinates if any(q in c.free_symbols for c in stated)]
    for q, p in combinations(coordinates, 2):
        yield Variation(f"with {q} and {p} exchanged", "", rule={q: p, p: q})
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


# Contributions


_OPPOSITE = ", with the opposite sign,"


def contributions(
    m: Mechanics,
    rule: Substitution,
    values: Substitution,
    rows: Sequence[Sequence[sp.Expr]] = (),
    letters: Substitution | None = None,
) -> str:
    """Which forces contribute something else in a wrong answer, as the end of a sentence; empty if not found.

    rule     the answer, solved for a letter in each of its equations
    rows     the coefficients of constraints: then the virtual work in the displacements that they leave is compared
    letters  what letters stand for that the problem does not have
    """
    forces = [f for f in m.forces if f.kind is not AppliedForceKind.QUASI]
    if not 1 < len(forces) <= MOST_RESTING_FORCES:
        return ""
    rest = dict.fromkeys((*m.slots.velocities, *m.slots.accelerations), sp.S.Zero)
    shares = [[(f.factor * s).xreplace(rest) for s in f.shares] for f in forces]
    ways = sp.Matrix(rows).nullspace() if rows else [sp.Matrix(v) for v in sp.eye(len(m.slots.coordinates)).tolist()]
    own = [[_reduced(sp.Add(*(a * b for a, b in zip(s, way, strict=True)))) for way in ways] for s in shares]
    said = []
    for k in range(len(ways)):
        put = [_reduced(work[k].xreplace(dict(values)).xreplace(dict(rule))) for work in own]
        residue = _reduced(-sp.Add(*put))
        if residue == 0:
            continue
        changes = _changes(k, forces, put, own, residue, m, letters or {}, tied=bool(rows))
        change = min(changes, default=None, key=lambda pair: pair[0])
        if change is None:
            return ""
        several = len(ways) > 1 and not rows
        said.append(f"{change[1]} in the equation of {m.slots.coordinates[k]}" if several else change[1].rstrip(","))
    return " and ".join(said)


def _changes(
    k: int,
    forces: Sequence[ForceShare],
    put: Sequence[sp.Expr],
    own: Sequence[Sequence[sp.Expr]],
    residue: sp.Expr,
    m: Mechanics,
    letters: Substitution,
    *,
    tied: bool,
) -> Iterator[tuple[int, str]]:
    """What one force would have to contribute to equation k, with the length of that."""

    def said(e: sp.Expr) -> str:
        return written(e.xreplace(dict(letters)), m.slots)

    strengths = [_strength(shares, m) for shares in own]
    letters_of_forces = {s for s in strengths if s is not None}
    known = {
        s for es in (*own, letters.values(), m.configuration.finite_constraints) for e in es for s in e.free_symbols
    }
    for f, share, shares in zip(forces, put, own, strict=True):
        if share == 0:
            continue
        c = sp.factor(sp.cancel(1 + residue / share))
        if c == 0:
            yield 0, f"without {name_of(f)}"
        elif (
            c == 1
            or not _is_plain(c, m, tied=tied)
            or not letters_of_forces.isdisjoint(c.free_symbols)
            or not c.free_symbols <= known
        ):
            continue
        else:
            derived = _unsigned(shares[k])
            size = 1 + int(sp.count_ops(c))
            if tied:
                divided = sp.fraction(c)[0] == 1
                how, by = ("divided", 1 / c) if divided else ("multiplied", c)
                yield size, f"with the contribution of {name_of(f)} {how} by {said(by)}"
                continue
            opposite = c.as_coeff_Mul()[0].is_negative and not c.has(sp.Add)
            stated = sp.factor(sp.cancel(-c * derived if opposite else c * derived))
            stated = sp.expand(stated) if stated.could_extract_minus_sign() else stated
            what = f"with {said(stated)} in place of {said(derived)}"
            yield (
                size + int(sp.count_ops(stated)),
                f"{what} as the contribution of {name_of(f)}{_OPPOSITE if opposite else ''}",
            )
    for f, shares in zip(forces, own, strict=True):
        elsewhere = [s for s in shares if s != 0]
        if put[forces.index(f)] == 0 and any(sp.expand(residue - x * s) == 0 for s in elsewhere for x in (1, -1)):
            yield 2, f"with {name_of(f)}, which does not act there,"


def _strength(shares: Sequence[sp.Expr], m: Mechanics) -> sp.Symbol | None:
    """The letter of a force in its contributions: a factor of all of them that is no length of a place."""
    common = set.intersection(*({*_factors(s)} for s in shares if s != 0)) if any(s != 0 for s in shares) else set()
    places = {s for p in m.configuration.points for c in p.position.fixed().components for s in c.free_symbols}
    letters = sorted(common - places - {*m.slots.coordinates}, key=str)
    return letters[0] if len(letters) == 1 else None


def _factors(e: sp.Expr) -> Iterator[sp.Symbol]:
    for f in sp.Mul.make_args(sp.factor_terms(e)):
        if f.is_Symbol:
            yield f


def _reduced(e: sp.Expr) -> sp.Expr:
    if not e.has(sp.sin, sp.cos):
        return sp.factor(e)
    above, below = sp.fraction(sp.cancel(sp.together(e)))
    return sp.factor(textbook_form(above) / textbook_form(below))


def _is_plain(c: sp.Expr, m: Mechanics, *, tied: bool) -> bool:
    """Whether a ratio of contributions is a plausible slip: made of numbers, letters, sums of two letters and functions
    of angles; `tied`: a short ratio may also have a coordinate that is a length, as l/x.
    """
    above, below = sp.fraction(c)
    factors = [f.as_base_exp()[0] for f in (*sp.Mul.make_args(above), *sp.Mul.make_args(below)) if not f.is_Rational]
    short = all(
        f.is_Symbol
        or isinstance(f, Unspecified)
        or f.func in (sp.sin, sp.cos, sp.tan)
        or (f.is_Add and len(f.args) == 2 and all(_is_term(a) for a in f.args))
        for f in factors
    )
    straight = {*m.slots.coordinates} - {a for w in c.atoms(sp.sin, sp.cos, sp.tan) for a in w.free_symbols}
    bare = c.xreplace(dict.fromkeys(c.atoms(Unspecified), sp.S.One))
    if not straight.isdisjoint(bare.free_symbols) and not (tied and sp.count_ops(c) <= SHORTEST_RATIO):
        return False
    number = c.as_coeff_Mul()[0]
    small = number.is_Rational and max(abs(number.p), number.q) <= MOST_RESTING_FACTORS
    return bool(short and small and len(factors) <= MOST_RESTING_FACTORS and sp.count_ops(c) <= RATIO_OPERATIONS)


def _is_term(e: sp.Expr) -> bool:
    rest = e.as_coeff_Mul()[1]
    return bool(rest.is_Symbol or rest.func in (sp.sin, sp.cos))


def _unsigned(e: sp.Expr) -> sp.Expr:
    return -e if e.could_extract_minus_sign() else e
