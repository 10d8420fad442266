"""Wrong amplitudes of a steady state: which changed linear equations have them?

The right ones are those of (K − ω² M + iω D) Z = F − iG. A changed problem has another K, M, D or F: a coupling that is
missing in one equation or in all, or has the wrong sign, a drive in the wrong equation, other letters. Its amplitudes
are numbers at random values of the letters, and the stated ones, all of them, are those of the first change that gives
them at several such values; of each only the modulus counts. What agrees to thirty digits three times does so always,
except by a chance too small to matter.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from random import Random

import sympy as sp

from lagrange.answers.limits import AMPLITUDE_DRAWS, MOST_AMPLITUDES, RANDOM_DIGITS, RANDOM_ZERO_DIGITS
from lagrange.answers.results.meanings import other_meanings
from lagrange.core.records import record
from lagrange.core.symbols import base, t
from lagrange.document.math_writer import text
from lagrange.document.names import Notation
from lagrange.mechanics.equilibrium.response import Response

_SMALL = sp.Float(10) ** -RANDOM_ZERO_DIGITS


Matrix = list[list[sp.Expr]]


@record
class _Equations:
    """(K − ω² M + iω D) Z = F, shape (n, n) and (n,)."""

    stiffness: Matrix
    mass: Matrix
    damping: Matrix
    forces: list[sp.Expr]
    frequency: sp.Expr

    def changed(self, part: str, i: int, j: int, value: sp.Expr) -> _Equations:
        """With another entry of one matrix."""
        parts = {name: [[*row] for row in getattr(self, name)] for name in ("stiffness", "mass", "damping")}
        parts[part][i][j] = value
        return _Equations(**parts, forces=self.forces, frequency=self.frequency)


def explained_amplitudes(stated: Mapping[str, sp.Expr], response: Response) -> str:
    """What stated amplitudes, by coordinate, are instead, in a sentence; empty if that is not found."""
    slots = response.forced.configuration.slots
    places = {q.name: n for n, q in enumerate(slots.coordinates)}
    if len(places) > MOST_AMPLITUDES or not stated.keys() <= places.keys():
        return ""
    claims = {places[name]: value for name, value in stated.items()}
    right = [sp.Add(a**2, b**2) for a, b in zip(response.cosines, response.sines, strict=True)]
    letters = {s for e in right for s in e.free_symbols}
    used = {s for e in claims.values() for s in e.free_symbols}
    if any(base(s) in slots.coordinates for s in used):
        return ""
    draws = [_Draw(letters | used, seed) for seed in range(AMPLITUDE_DRAWS)]
    squares = {n: [d.value(claim) ** 2 for d in draws] for n, claim in claims.items()}

    def given_by(values: Callable[[_Draw, int], sp.Expr]) -> bool:
        return all(_close(values(d, n), own[k]) for n, own in squares.items() for k, d in enumerate(draws))

    if len(places) == 2 and given_by(lambda d, n: d.value(right[1 - n])):
        return f"the amplitudes of {slots.coordinates[0]} and {slots.coordinates[1]} are exchanged"
    if len(places) == 1 and (why := _of_phase(response, given_by)):
        return why
    for clause, equations in _changes(response):
        if given_by(lambda d, n, e=equations: d.square(e, n)):  # type: ignore[misc]
            return f"these are the amplitudes {clause}" if len(claims) > 1 else f"this is the amplitude {clause}"
    for meaning in other_meanings(letters, used):
        if given_by(lambda d, n, m=meaning: d.value(right[n].xreplace(dict(m.rule)))):  # type: ignore[misc]
            return (
                f"these are the amplitudes {meaning.clause}"
                if len(claims) > 1
                else f"this is the amplitude {meaning.clause}"
            )
    return ""


def _of_phase(response: Response, given_by: Callable[[Callable[[_Draw, int], sp.Expr]], bool]) -> str:
    """Whether stiffness and damping are added as if they were in phase, or a root or square is missing; a sentence."""
    system, w = response.forced.free.system, response.drive.frequency
    in_phase = system.stiffness[0][0] - w**2 * system.mass[0][0]
    across = w * system.damping[0][0]
    right = sp.Add(response.cosines[0] ** 2, response.sines[0] ** 2)
    force = sp.sqrt(right * (in_phase**2 + across**2))
    stiffness, damping = (text(e, Notation()) for e in (in_phase, across))
    ways = [(force / (in_phase + sign * across), _ADDED.format(stiffness, damping)) for sign in (1, -1)]
    ways.append((force / sp.sqrt(in_phase**2 - across**2), f"the sign of ({damping})^2 under the root is wrong"))
    ways.append((right, "the root is missing"))
    if across == 0:
        ways = []
    return next((said for e, said in ways if given_by(lambda d, _, e=e: d.value(e) ** 2)), "")  # type: ignore[misc]


_ADDED = (
    "{} and {} are added as if they had one phase: they are a quarter of a period apart, so that the root of the sum "
    "of their squares counts"
)


def _changes(response: Response) -> Iterator[tuple[str, _Equations]]:
    system, coordinates = response.forced.free.system, response.forced.configuration.slots.coordinates
    angle = response.drive.frequency * t
    forces = [sp.expand(f) for f in response.forced.forces]
    drive = [f.coeff(sp.cos(angle)) - sp.I * f.coeff(sp.sin(angle)) for f in forces]
    stiffness, mass, damping = ([[*row] for row in m] for m in (system.stiffness, system.mass, system.damping))
    own = _Equations(stiffness, mass, damping, drive, response.drive.frequency)
    n = len(coordinates)
    pairs = [(i, j) for i in range(n) for j in range(n) if i != j]
    words = {"stiffness": "", "mass": "''", "damping": "'"}
    for part, primes in words.items():
        matrix = getattr(own, part)
        for i, j in pairs:
            if matrix[i][j] == 0:
                continue
            where = f"in the equation of {coordinates[i]}"
            yield f"without the term with {coordinates[j]}{primes} {where}", own.changed(part, i, j, sp.S.Zero)
            yield (
                f"with the wrong sign of the term with {coordinates[j]}{primes} {where}",
                own.changed(part, i, j, -matrix[i][j]),
            )
            without = own.changed(part, i, j, sp.S.Zero).changed(part, i, i, matrix[i][i] + matrix[i][j])
            yield f"without what couples {coordinates[i]} with {coordinates[j]} {where}", without
            relative = own.changed(part, i, i, matrix[i][i] + matrix[i][j])
            yield f"with a coupling {where} that depends on {coordinates[j]} alone and not on the difference", relative
            if i < j:
                both = own.changed(part, i, j, sp.S.Zero).changed(part, j, i, sp.S.Zero)
                yield f"without the coupling of {coordinates[i]} and {coordinates[j]}", both
                neither = without.changed(part, j, i, sp.S.Zero).changed(part, j, j, matrix[j][j] + matrix[j][i])
                yield f"without the force between {coordinates[i]} and {coordinates[j]}", neither
    yield from _other_drives(own, drive, coordinates)
    for i, q in enumerate(coordinates):
        balanced = own.frequency**2 * mass[i][i]
        yield f"at resonance, where stiffness and inertia of {q} balance", own.changed("stiffness", i, i, balanced)
    for i, j in pairs:
        if drive[i] == 0 != drive[j]:
            forces = [drive[j] if k == i else sp.S.Zero if k == j else f for k, f in enumerate(drive)]
            moved = _Equations(own.stiffness, own.mass, own.damping, forces, own.frequency)
            yield f"for a drive that acts on {coordinates[i]} and not on {coordinates[j]}", moved
    for part, what in (("stiffness", "stiffness"), ("mass", "inertia"), ("damping", "damping")):
        terms = [sp.Add.make_args(sp.expand(getattr(own, part)[i][i])) for i in range(n)]
        for i in range(n):
            whole = getattr(own, part)[i][i]
            where = f"in the {what} of {coordinates[i]}"
            for term in terms[i] if len(terms[i]) > 1 else ():
                yield f"without {term} {where}", own.changed(part, i, i, whole - term)
            for term in dict.fromkeys(x for j, row in enumerate(terms) if j != i for x in row if x not in terms[i]):
                if term != 0:
                    yield f"with {term} as well {where}", own.changed(part, i, i, whole + term)


def _other_drives(
    own: _Equations, drive: Sequence[sp.Expr], coordinates: Sequence[sp.Symbol]
) -> Iterator[tuple[str, _Equations]]:
    """Omissions: a support's motion not transmitted by a damper or spring; motion relative to the support."""
    for i, q in enumerate(coordinates):
        whole = sp.expand(drive[i])
        cosine, sine = whole.coeff(sp.I, 0), whole.coeff(sp.I, 1)
        for kept in (cosine, sp.I * sine) if cosine != 0 and sine != 0 else ():
            lost = "cos" if kept is not cosine else "sin"
            forces = [kept if k == i else f for k, f in enumerate(drive)]
            clause = f"without the {lost}({own.frequency}*t) term of the drive in the equation of {q}"
            yield clause, _Equations(own.stiffness, own.mass, own.damping, forces, own.frequency)
    if len(coordinates) == 1:
        k, m, d, w = own.stiffness[0][0], own.mass[0][0], own.damping[0][0], own.frequency
        for letter in sorted(drive[0].free_symbols - {w}, key=str):
            motion = sp.cancel(sp.expand(drive[0]) / sp.expand(k + sp.I * w * d))
            if letter in motion.free_symbols and motion.free_symbols == {letter}:
                forces = [sp.expand(m * w**2 * motion)]
                clause = "of the motion relative to the support, but the one in the fixed frame is asked for"
                yield clause, _Equations(own.stiffness, own.mass, own.damping, forces, own.frequency)


class _Draw:
    """Random values of all letters."""

    def __init__(self, letters: set[sp.Symbol], seed: int) -> None:
        random = Random(seed)
        draws = {s: sp.Rational(random.randint(200, 900), random.randint(200, 900)) for s in sorted(letters, key=str)}
        self._values = draws
        self._solved: dict[int, tuple[_Equations, list[sp.Expr]]] = {}

    def value(self, e: sp.Expr) -> sp.Expr:
        """The value of an expression."""
        return e.xreplace(self._values).evalf(RANDOM_DIGITS)

    def square(self, equations: _Equations, n: int) -> sp.Expr:
        """|Z_n|²."""
        known = self._solved.get(id(equations))
        if known is None:
            known = self._solved[id(equations)] = equations, self._amplitudes(equations)
        return known[1][n] if known[1] else sp.nan

    def _amplitudes(self, e: _Equations) -> list[sp.Expr]:
        w = self.value(e.frequency)
        size = range(len(e.forces))
        k, m, d = ([[self.value(x) for x in row] for row in matrix] for matrix in (e.stiffness, e.mass, e.damping))
        rows = [[k[i][j] - w**2 * m[i][j] + sp.I * w * d[i][j] for j in size] for i in size]
        forces = [self.value(f) for f in e.forces]
        whole = _determinant(rows)
        if abs(whole) < _SMALL:
            return []
        solved = (
            _determinant([[f if c == n else x for c, x in enumerate(r)] for r, f in zip(rows, forces, strict=True)])
            for n in size
        )
        return [abs(sp.expand(z)) ** 2 / abs(sp.expand(whole)) ** 2 for z in solved]


def _determinant(rows: Sequence[Sequence[sp.Expr]]) -> sp.Expr:
    if len(rows) == 1:
        return rows[0][0]
    minors = [[[*r[:j], *r[j + 1 :]] for r in rows[1:]] for j in range(len(rows))]
    return sp.expand(
        sp.Add(*((-1) ** j * a * _determinant(m) for j, (a, m) in enumerate(zip(rows[0], minors, strict=True))))
    )


def _close(a: sp.Expr, b: sp.Expr) -> bool:
    if not (a.is_number and b.is_number and a.is_finite and b.is_finite):
        return False
    return bool(abs(sp.expand(a - b)) <= _SMALL * (1 + abs(b)))
