"""Wrong positions of rest, force by force: what one force contributes to the balance as the answer has it.

At rest each equation is a sum of contributions S_f, one of every force: its moment about a hinge, its component along
a direction. A stated equation, solved for a letter and put in, leaves a residue in some of them,

    E_k = −Σ_f S_fk ≠ 0 ,     and     −Σ_f S_fk + (1 − c) S_gk = 0     for   c = 1 + E_k/S_gk ,

so that force g with c S_gk instead of S_gk, another arm, explains the equation of q_k. That is said where c is short:
a number, a ratio of lengths, a sine. Where the residue is the contribution of a force to another equation, that force
was taken to act there as well.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import sympy as sp

from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.answers.limits import MOST_RESTING_FACTORS, MOST_RESTING_FORCES, RATIO_OPERATIONS
from lagrange.answers.models.forces import name_of
from lagrange.answers.models.mechanics import AppliedForceKind, ForceShare, Mechanics
from lagrange.answers.models.variation import written
from lagrange.core.symbols import Unspecified

Substitution = Mapping[sp.Basic, sp.Basic]
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
    known = {s for shares in (*own, letters.values()) for e in shares for s in e.free_symbols}
    for f, share, shares in zip(forces, put, own, strict=True):
        if share == 0:
            continue
        c = sp.factor(sp.cancel(1 + residue / share))
        if c == 0:
            yield 0, f"without {name_of(f)}"
        elif (
            c == 1
            or not _is_plain(c, m)
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


def _is_plain(c: sp.Expr, m: Mechanics) -> bool:
    """Whether a ratio of contributions is one that is forgotten or put in: of numbers, letters, sums of two letters and
    functions of angles."""
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
    if not straight.isdisjoint(c.xreplace(dict.fromkeys(c.atoms(Unspecified), sp.S.One)).free_symbols):
        return False
    number = c.as_coeff_Mul()[0]
    small = number.is_Rational and max(abs(number.p), number.q) <= MOST_RESTING_FACTORS
    return bool(short and small and len(factors) <= MOST_RESTING_FACTORS and sp.count_ops(c) <= RATIO_OPERATIONS)


def _is_term(e: sp.Expr) -> bool:
    rest = e.as_coeff_Mul()[1]
    return bool(rest.is_Symbol or rest.func in (sp.sin, sp.cos))


def _unsigned(e: sp.Expr) -> sp.Expr:
    return -e if e.could_extract_minus_sign() else e
