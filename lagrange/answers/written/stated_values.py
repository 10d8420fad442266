"""Values that an answer states for parameters, `g = 9.81 m/s^2`: numbers, and what follows them as a unit."""

from __future__ import annotations

import re
from collections.abc import Collection

import sympy as sp

NUMBER = re.compile(
    r"\s*(?:≈|\\approx)?\s*[-+−]?\s*(?P<number>[0-9]+(?:(?:[.,]|\{,\})[0-9]+)?|[0-9]*\.[0-9]+)"
    r"(?:\s*(?:\\cdot|\\times|\*|·|×)\s*10\s*\^\s*\{?(?P<ten>-?[0-9]{1,3})\}?|[eE](?P<power>-?[0-9]{1,3}))?(?P<unit>[^+=]{0,60})\Z"
)
_UNIT_NAMES = """
m cm mm km dm g kg mg t s ms min h N kN mN J kJ W Pa Hz rad deg rev rpm ft in lb lbf slug mph K Nm Ns SI grad m2 m3
kgm2 units metres meters seconds kilograms newton newtons
"""
_UNITS = frozenset(_UNIT_NAMES.split())
_UNIT_WORDS = re.compile(r"[^\W\d_]+[23]?")
_NO_WORDS = re.compile(r"\\(?:mathrm|text|rm|frac|si|SI|unit|cdot|left|right|quad|,|;|:|!)")


def is_unit(text: str, declared: Collection[str], bare: bool) -> bool:
    """Whether what follows a number is a unit; `bare`: whether there may be none."""
    words = _UNIT_WORDS.findall(_NO_WORDS.sub(" ", text))
    if not words:
        return bare and not text.strip(" .,;$\\{}")
    return all(w in _UNITS for w in words) and (text[0] in " \\~" or not all(w in declared for w in words))


def value_of(number: re.Match[str]) -> sp.Expr:
    """The number that a match of NUMBER states."""
    power = int(number["ten"] or number["power"] or 0)
    return sp.Rational(number["number"].replace(",", ".").strip("{}")) * sp.Integer(10) ** power
