"""Names that an answer defines with a mark: with a prime, A' = A + m l², or a letter behind a Greek one, ωc = q B/m.

A prime would make a rate of a constant, and the letter a factor.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Sequence

from lagrange.answers.readings import GivenEquation
from lagrange.core.diagnostics import Fragment
from lagrange.expressions.characters import GREEK
from lagrange.expressions.edits import Draft
from lagrange.expressions.latex_layout import is_latex
from lagrange.expressions.scope import Scope
from lagrange.expressions.syntax_tree import Role

_PRIMED = re.compile(rf"[\s$&]*(\\?[A-Za-z](?:_?\w{{1,8}})?|[{''.join(GREEK)}])['′]\s*&?=(?!=)")


def with_primed_names(answer: Sequence[Fragment], parameters: Collection[str]) -> Sequence[Fragment]:
    """`A' = A + m l²` with a constant A: A_prime as a separate name, wherever it occurs."""
    names = {m[1] for f in answer if (m := _PRIMED.match(f.text)) and GREEK.get(m[1], m[1].lstrip("\\")) in parameters}
    if not names:
        return answer
    pattern = re.compile(rf"(?<![A-Za-z0-9_\\])({'|'.join(map(re.escape, names))})['′](?!['′])")
    return [_replaced(f, pattern, r"\1_{prime}" if is_latex(f) else r"\1_prime") for f in answer]


_GREEK_LABEL = re.compile(
    rf"\s*(?P<greek>[{''.join({*GREEK} - {'δ'})}])(?P<index>[a-z]{{1,3}})\s*(?:²|\^2)?\s*:?=(?!=)"
)


def with_indices_of_greek(answer: Sequence[Fragment], scope: Scope) -> Sequence[Fragment]:
    """`ωc = q B/m` as ω_c, wherever it occurs: a name of its own, unless its letters are names of the problem."""
    names = {
        m["greek"] + m["index"]: f"{m['greek']}_{m['index']}"
        for f in answer
        if not is_latex(f)
        if (m := _GREEK_LABEL.match(f.text))
        if not all(scope.role(n) is not Role.UNDECLARED for n in m["index"])
        and scope.role(m["index"]) is Role.UNDECLARED
    }
    if not names:
        return answer
    pattern = re.compile(rf"(?<![A-Za-z0-9_\\])({'|'.join(names)})(?![A-Za-z0-9_])")
    return [_replaced(f, pattern, lambda m: names[m[0]]) for f in answer]


def _replaced(fragment: Fragment, pattern: re.Pattern[str], new: str | Callable[[re.Match[str]], str]) -> Fragment:
    draft = Draft(fragment)
    if isinstance(fragment, GivenEquation) or not draft.replace(pattern, new):
        return fragment
    return draft.finished(latex=is_latex(fragment))
