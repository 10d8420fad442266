"""The short names that a page has for reactions, T for T_rod, in an answer.

A derivation with one constraint prints its reaction as T, N or λ. Whoever answers `T = m g cos θ + m l θ'^2` means that
force, if the problem declares no T. A name in several equations is an unknown force, or defined by one of them, as any
other undeclared name. A T may also be the kinetic energy or a period: a T whose terms are all squares of velocities,
that occurs with a V or in L, or that has the dimension of a time, is no force.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

import sympy as sp

from lagrange.answers.references import Reference
from lagrange.core.units import NO_DIMENSION
from lagrange.expressions.characters import GREEK, SUBSCRIPTS
from lagrange.mechanics.dynamics.newton import short_reactions
from lagrange.mechanics.dynamics.reaction_signs import ForceKind
from lagrange.values.dimensions import dimension, dimension_of_unit, dimensions_of_units

_OF_ENERGY = re.compile(
    r"(?<![A-Za-z_])(?:[LEH]|\\mathcal\s*\{?L\}?)\s*:?={1,2}\s*T|(?<![A-Za-z_])T\s*[-+−–]\s*[VU](?![A-Za-z_])"
    r"|(?<![A-Za-z_])[VU]\s*:?={1,2}(?!=)|kinetic|energ|period|Periode|Schwingungsdauer",
)


def printed_names(reference: Reference, texts: Sequence[str] = ()) -> dict[str, sp.Symbol]:
    """The short names of reactions that mean nothing else in the problem, and what the lines of an answer call one."""
    if reference.newton is None:
        return {}
    known = {*reference.declared, *reference.letters, *reference.scope.scalars, *reference.scope.vectors}
    known |= {*reference.scope.functions, *reference.coordinates}
    short_names = {short: symbol for symbol, short in short_reactions(reference.newton, known)}
    return short_names | _of_normal_force(texts, reference)


def _of_normal_force(texts: Sequence[str], reference: Reference) -> dict[str, sp.Symbol]:
    """`N_A` of `N_A = ...`, which is not declared, as the force of the only contact; empty if there are several."""
    known = {*reference.declared, *reference.scope.scalars}
    meant = {re.sub(r"[{}]", "", m[1]) for text in texts if (m := _NORMAL.match(text))} - known
    if len(meant) != 1 or reference.newton is None:
        return {}
    normal = [r for r in reference.newton.reactions if r.single is not None and r.single.kind is ForceKind.ALONG]
    symbol = (normal[0].force if normal[0].named else normal[0].symbol_of_force) if len(normal) == 1 else None
    return {meant.pop(): symbol} if symbol is not None else {}


_NORMAL = re.compile(r"[\s$&]*((?:N|F_N|R)(?:_\{?[A-Za-z0-9]{1,2}\}?)?)\s*&?=(?!=)")


def lines_with(name: str, lines: Sequence[str]) -> list[int]:
    """The lines in which a name occurs by itself, and not as a part of another."""
    letters = [re.escape(c) for c, n in GREEK.items() if n == name] + [rf"\\{re.escape(name)}"] * (len(name) > 1)
    written = "|".join([rf"(?<![A-Za-z0-9_\\]){re.escape(name)}", *letters])
    pattern = re.compile(rf"(?:{written})(?![A-Za-z0-9_'(])")
    return [n for n, line in enumerate(lines) if pattern.search(line)]


def may_be_force(name: str, value: sp.Expr | None, texts: Sequence[str], reference: Reference) -> bool:
    """Whether a name, stated to be `value` where it stands alone, may be the reaction and not an energy or a period."""
    if name != "T":
        return True
    if any(_OF_ENERGY.search(text) for text in texts):
        return False
    if value is None:
        return True
    velocities = [v for v in reference.scope.slots.velocities if v in value.free_symbols]
    scale = sp.Symbol("scale", positive=True)
    if velocities and sp.expand(value.xreplace({v: scale * v for v in velocities}) - scale**2 * value) == 0:
        return _is_force(value, reference.units) is True
    if not value.free_symbols & {*velocities, *reference.scope.slots.coordinates}:
        return _is_force(value, reference.units) is True
    return _is_force(value, reference.units) is not False


def _is_force(value: sp.Expr, units: Mapping[sp.Symbol, str]) -> bool | None:
    """Whether an expression has the dimension of a force; None if that is not known."""
    known = dimensions_of_units(units)
    angles = {q for w in value.atoms(sp.sin, sp.cos, sp.tan) for q in w.args[0].free_symbols if q not in known}
    stated = dimension(value, known | dict.fromkeys(angles, NO_DIMENSION))
    return None if stated is None else stated == dimension_of_unit("N")


def spelled_out(text: str) -> str:
    """θ₁ as theta_1."""
    text = re.sub(f"[{''.join(SUBSCRIPTS)}]+", lambda m: "_" + "".join(SUBSCRIPTS[c] for c in m[0]), text)
    return "".join(f" {GREEK[c]}" if c in GREEK else c for c in text)
