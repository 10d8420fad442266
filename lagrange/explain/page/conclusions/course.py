"""How a motion goes on, in words: what friction stops, where contact ends, rates that swing."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from lagrange.core.symbols import base, prime
from lagrange.document.derivation import Block, Emphasis, Part, listed, math, prose
from lagrange.explain.words import capital, the
from lagrange.mechanics.consequences.course import Released, Sense, SwingingRate


def explain_sense(s: Sense | None) -> Iterator[Block]:
    """`Speed: while x' > 0 it grows if tan α > μ; if tan α < μ, it falls to zero, and the motion stops.`"""
    if s is None:
        return
    grows, falls = (math(s.more, s.less, relation=relation) for relation in "><")
    yield prose(
        *(Emphasis("Speed"), ": while ", math(s.velocity, sp.S.Zero, relation=">"), " it grows if ", grows),
        *("; if ", falls, ", it falls to zero."),
    )


def explain_released(places: tuple[Released, ...]) -> Iterator[Block]:
    """`Released from rest at θ = θ_0: W = 0 where sin θ = ⅔ sin θ_0; contact ends there at the latest.`"""
    for r in places:
        only: tuple[Part, ...] = () if r.provided is None else (", if ", math(r.provided, sp.S.Zero, relation=">"))
        yield prose(
            *(Emphasis("Released from rest"), " at ", math(r.coordinate, r.start), *only, ": by the energy, "),
            *(math(r.force, sp.S.Zero), " where ", math(r.wave, r.place), *_ends(r)),
        )


_SHARES = {"1/3": "one third", "1/2": "one half", "2/3": "two thirds", "1/4": "one quarter"}


def _ends(r: Released) -> Iterator[Part]:
    """`. Contact ends there; N > 0 until then. The mass centre of the ladder has then fallen by 1/3 of its height.`"""
    if not r.exact:
        yield "; contact ends there at the latest."
        return
    yield "; contact ends there"
    if r.others:
        yield from (", and ", *listed(math(s, sp.S.Zero, relation="≥") for s in r.others), " until then")
    yield "."
    if r.heavy:
        what = f"The mass centre of {the(r.heavy)}" if r.is_body else capital(the(r.heavy))
        share = _SHARES.get(str(r.fallen))
        yield from (f" {what} has then fallen by ", share or math(r.fallen), " of its first height above ", "O.")


def explain_swinging(s: SwingingRate | None) -> Iterator[Block]:
    """`The equation for z'', differentiated with constant φ', gives the third derivative as −(2/7) φ'² z'.`"""
    if s is None:
        return
    third = prime(base(s.rate), 3)
    constants = (" with constant ", *listed(map(math, s.constants))) if s.constants else ()
    yield prose(
        *(Emphasis("In one"), ": the equation for ", math(prime(base(s.rate), 2)), ", differentiated", *constants),
        *(", gives ", math(third + s.square * s.rate, sp.S.Zero), ": ", math(s.rate)),
        *(" oscillates harmonically with the frequency ", math(s.frequency), "."),
    )
