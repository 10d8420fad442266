"""Which of N values a seed draws: integers and SHA-256, so that it is the same on every machine and in every version.

With the seed s and the name p of a parameter, both as UTF-8 in Unicode's form C, without blanks around them,

    k = SHA-256("lagsolve variant 1" 0 s 0 p) mod N,

where 0 is a byte and the 32 bytes of the digest are one number, the first byte the highest (FIPS 180-4). The value of
a parameter depends on its own name and on the number of its values, and so stays as it is when others are added to
`vary`. The remainder prefers no value by more than N/2^256. This rule is a promise, and a test holds its numbers.
"""

from __future__ import annotations

import hashlib
import unicodedata
from collections.abc import Mapping, Sequence

from lagrange.problem.model import Varied

RULE = "lagsolve variant 1"


def values_drawn(varied: Sequence[Varied], seed: str) -> Mapping[str, str]:
    """The value, as text, that a seed draws for each parameter."""
    return {v.name: v.values[drawn_place(seed, v.name, len(v.values))] for v in varied}


def drawn_place(seed: str, name: str, number: int) -> int:
    """The place of the value, from 0, that a seed draws for a parameter with a number of values."""
    text = "\0".join((RULE, _plain(seed), _plain(name)))
    return int.from_bytes(hashlib.sha256(text.encode("utf-8", "surrogatepass")).digest(), "big") % number


def _plain(text: str) -> str:
    return unicodedata.normalize("NFC", text).strip()
