"""Remarks on the stability of an equilibrium, as they stand in a line beside its equation.

theta = 0, stable for W < c h        theta = pi is unstable        theta = 0 (stable if c b^2 > W l)
stable: theta = 0        it is stable for k > m g/(2 a), unstable otherwise
"""

from __future__ import annotations

import re

_KIND = r"(?:un|in|not\s+|non-)?(?:stab(?:le|il)|labil)(?:e[nrs]?)?|(?:marginally|neutrally)\s+stable"
_CONDITION = (
    r"\s+(?:only\s+)?(?:iff?|for|when|where|provided(?:\s+that)?|as\s+long\s+as|falls|wenn|für|si|pour)\s+"
    r"[^;\n,=<>≤≥]{1,80}?(?:[<>]=?|[≤≥])[^;\n,=<>≤≥]{1,80}?"
    r"(?=\s*(?:[,;\n]|\Z|\.(?:\s|\Z)|\s(?:and|but|or|otherwise|else|while|whereas|und|aber|sonst)\s))"
)
_OTHERWISE = (
    r"(?:\s*(?:[,;]|\band\b|\bund\b)?\s*"
    r"(?:otherwise\s+(?:un)?stable|(?:un)?stable\s+otherwise|(?:un)?stable\s+if\s+not))?"
)
STABILITY = re.compile(
    rf"\(\s*(?:[^()=<>]{{0,40}}\s)?(?:{_KIND})(?![^\W\d_])(?:[^()=]|\([^()=]{{0,60}}\)){{0,120}}\)"
    rf"|(?:[,;]\s*|(?<=[\s\w)}}°²³])\s|^\s*)(?:(?:and|but)\s+)?(?:(?:which|that|this|it|this\s+(?:one|position))\s+)?"
    rf"(?:(?:is|are|ist|sind)\s+)?(?:always\s+|only\s+|an?\s+)?(?:{_KIND})(?![^\W\d_])"
    rf"(?:\s+(?:equilibrium|position|one)s?(?:\s+(?:at|for|is)(?=\s+[^\s<>≤≥]+\s*=))?)?(?:{_CONDITION})?{_OTHERWISE}\s*[:,]?",
    re.IGNORECASE,
)

CONDITIONAL = re.compile(
    r"\(\s*(?:[^()=<>≤≥]{0,40}\s)?(?:if|for|when|exists?|only|where|falls|nur|wenn|für|provided)(?![^\W\d_])"
    r"(?:[^()=]|\([^()=]{0,60}\)){0,80}[<>≤≥](?:[^()]|\([^()]{0,60}\)){1,80}\)"
)
"""A condition of existence in parentheses after an equation, `(only if W l < c b²)`, which is not judged."""
