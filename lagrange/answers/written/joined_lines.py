r"""Which lines of an answer are mathematics, and which of them belong together.

A line continues the one before it if that one ends, or it begins, with a sign that needs something on its other side,
and one of them has no `=`; and as long as a brace of that one is open, as in a list of equations:

    {m r''[t] == m r[t] φ'[t]^2 - k r[t],
     r[t] φ''[t] == -2 r'[t] φ'[t]}
"""

from __future__ import annotations

import re

from lagrange.answers.written.values import is_about
from lagrange.expressions.characters import GREEK
from lagrange.expressions.syntax_tree import FUNCTIONS

KNOWN = frozenset({*FUNCTIONS, *GREEK.values(), "arcsin", "arccos", "arctan", "sgn", "ln", "eq", "diff", "cross"})
_LINKING_WORDS = """
then so thus hence therefore and we get obtain obtained have find gives give the equation equations of motion is are
where with let set define eom finally which yields yield using since because from newton newtons also now again
substituting simplifying dividing result results answer final solution becomes means that for if only as in to by
die der das ist lautet lauten gilt man wir erhalten erhält erhaelt ergibt ergeben also daraus aus nach dem den les la le
est sont donc on obtient equation équation équations du mouvement alors avec sachant ainsi soit here let's
otherwise else sonst sinon ansonsten got hi hello but however instead rather aber sondern
its your my follows follow it i.e e.g eq eqn or
 put try suppose assume guess seek insert trial ansatz
 energy kinetic potential lagrangian euler lagrange linear linearised linearized
small angle angles approximation approximately tangential radial normal direction sum forces force torque moment
constraint constraints rolling condition relation at ode odes differential second order system be case gleichung
bewegungsgleichung mit und dann fuer für folgt damit somit wobei
"""
LINKING = frozenset(_LINKING_WORDS.split())
_MATHEMATICS = re.compile(r"['^*/\\_=\u0300-\u036f′″¨˙²³½·−√()]|\d|[" + "".join(GREEK) + "]")
_ENDS_OPEN = re.compile(r"(?:[-+*/=−·(,&]|\\cdot|\\times|\\left\()\s*\Z")
_BEGINS_OPEN = re.compile(r"\s*(?:&\s*)?(?:[-+*/−·)]|\\cdot|\\times|=(?!=?>))")
_COMMAND = re.compile(r"\\(?:begin|end)\s?\{[a-z]{1,12}\*?\}|\\[A-Za-z]+")
_ENDS_MATRIX = re.compile(r"\\end\s?\{[pbBvV]?matrix\}\s*\Z")
_BEGINS_MATRIX = re.compile(r"\s*\\begin\s?\{[pbBvV]?matrix\}")
_BEGINS_EQUAL = re.compile(r"\s*&?\s*=(?!=?>)")
_OTHER_EQUALS = re.compile(r"[=≡≔]|\{\s*\w+'*(?:\[t\])?\s*->|\\equiv(?![A-Za-z])|\\coloneqq|\bEq\s*\(")


def has_sign_of_equality(line: str) -> bool:
    """Whether a line has an equation: a `=`, or what stands for it."""
    return _OTHER_EQUALS.search(line) is not None or is_about(line)


def is_mathematics(line: str) -> bool:
    """Whether a line without `=` may be a part of an equation, and is no prose."""
    words = [w for w in re.findall(r"[^\W\d_]{2,}", _COMMAND.sub(" ", line)) if w.lower() not in KNOWN]
    prose = [w for w in words if len(w) > 3 or w.lower() in LINKING]
    signs = _MATHEMATICS.search(line) or _BEGINS_OPEN.match(line)
    return signs is not None and not prose and not line.rstrip().endswith(":")


def joined_lines(lines: list[tuple[int, int, str]]) -> list[tuple[int, int]]:
    """Adjoining lines, each with its place and text, put together where one continues the other."""
    parts: list[tuple[int, int]] = []
    equals = mathematics = False
    last = ""
    listed = _listed(lines)
    for n, (start, end, line) in enumerate(lines):
        has = "=" in line
        if n in listed:
            parts[-1] = (parts[-1][0], end)
            equals, mathematics, last = True, True, line
            continue
        if parts and mathematics and (has or is_mathematics(line)):
            waits = bool(_ENDS_OPEN.search(last))
            goes_on = bool(_BEGINS_OPEN.match(line)) and not (has and equals and not _BEGINS_EQUAL.match(line))
            goes_on |= not equals and bool(_ENDS_MATRIX.search(last) and _BEGINS_MATRIX.match(line))
            alone = not equals and has and not _MATHEMATICS.search(last)
            if ((waits and not (equals and has and not last.rstrip().endswith("="))) or goes_on) and not alone:
                parts[-1] = (parts[-1][0], end)
                equals, last = equals or has, line
                continue
        parts.append((start, end))
        equals, mathematics, last = has, has or is_mathematics(line), line
    return parts


def _listed(lines: list[tuple[int, int, str]]) -> set[int]:
    """The lines within a list of equations in braces or brackets that began in a line before them, and is closed."""
    listed: set[int] = set()
    within: list[int] = []
    depth = 0
    for n, (_, _, line) in enumerate(lines):
        if depth == 0 and ("\\" in line or "=" not in line):
            continue
        within = [*within, n] if depth else []
        depth += sum(map(line.count, "{[")) - sum(map(line.count, "}]"))
        if depth < 0:
            return listed
        if depth == 0:
            listed |= {*within}
    return listed
