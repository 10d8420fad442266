"""The table of units, as text: it is read for the names alone too, without SymPy."""

from __future__ import annotations

# The factor to SI, a text of rational numbers and pi, and the powers of kg, m, s, A, K. A unit is made from it when it
# is named first: few problems name more than five, and numbers of SymPy take time.
WITH_PREFIX = {
    "g": ("1/1000", (1,)), "m": ("1", (0, 1)), "s": ("1", (0, 0, 1)), "A": ("1", (0, 0, 0, 1)),
    "K": ("1", (0, 0, 0, 0, 1)), "Hz": ("1", (0, 0, -1)), "N": ("1", (1, 1, -2)), "J": ("1", (1, 2, -2)),
    "W": ("1", (1, 2, -3)), "Pa": ("1", (1, -1, -2)), "C": ("1", (0, 0, 1, 1)), "V": ("1", (1, 2, -3, -1)),
    "T": ("1", (1, 0, -2, -1)), "Ω": ("1", (1, 2, -3, -2)), "F": ("1", (-1, -2, 4, 2)), "H": ("1", (1, 2, -2, -2)),
    "Nm": ("1", (1, 2, -2)), "rad": ("1", ()), "Ns": ("1", (1, 1, -1)), "Nms": ("1", (1, 2, -1)),
    "Js": ("1", (1, 2, -1)), "Wh": ("3600", (1, 2, -2)),
}  # fmt: skip
PREFIXES = {
    "p": -12, "n": -9, "u": -6, "µ": -6, "μ": -6, "m": -3, "c": -2, "d": -1, "h": 2, "k": 3, "M": 6, "G": 9, "T": 12,
}  # fmt: skip
_POUND_FORCE = "0.45359237*9.80665"
WITHOUT_PREFIX = {
    "1": ("1", ()), "%": ("1/100", ()), "sr": ("1", ()), "t": ("1000", (1,)), "min": ("60", (0, 0, 1)),
    "h": ("3600", (0, 0, 1)), "deg": ("1/180*pi", ()), "°": ("1/180*pi", ()), "rev": ("2*pi", ()),
    "rpm": ("1/30*pi", (0, 0, -1)), "ft": ("0.3048", (0, 1)), "in": ("0.0254", (0, 1)), "mph": ("0.44704", (0, 1, -1)),
    "lb": (_POUND_FORCE, (1, 1, -2)), "lbf": (_POUND_FORCE, (1, 1, -2)), "slug": (f"{_POUND_FORCE}/0.3048", (1,)),
}  # fmt: skip


def names_of_units() -> frozenset[str]:
    """All names of single units, with their prefixes."""
    return frozenset({*WITH_PREFIX, *WITHOUT_PREFIX, *(p + u for p in PREFIXES for u in WITH_PREFIX)})
