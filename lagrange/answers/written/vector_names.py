r"""Vectors and their magnitudes under one letter: \vec r beside r^3 is r_vec, and r is its magnitude.

The letter is a vector where it has an arrow, a bold face or a bar, and a number where it has none. Where both occur
without an index, the vector gets a name of its own.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from lagrange.core.diagnostics import Fragment
from lagrange.expressions.edits import Draft
from lagrange.expressions.latex_layout import is_latex
from lagrange.expressions.scope import Scope
from lagrange.expressions.syntax_tree import Role

_MARKED = r"\\(?:vec|mathbf|boldsymbol|bm|overrightarrow|underline)\s*(?:\{\s*NAME\s*\}|NAME(?![A-Za-z]))"
_ANY = re.compile(_MARKED.replace("NAME", r"(?:[A-Za-z])"))
_INDEX = r"(?!\s*\}?\s*_)"


def with_names_of_vectors(answer: Sequence[Fragment], scope: Scope) -> list[Fragment]:
    """The answer with names for the vectors that share their letter with a number."""
    texts = [f.text for f in answer]
    if not any("\\" in text for text in texts):
        return [*answer]
    letters = {m[0].rstrip(" }")[-1] for text in texts for m in _ANY.finditer(text)}
    shared = [x for x in sorted(letters) if scope.role(x) is Role.UNDECLARED and _is_number(x, texts)]
    if not shared:
        return [*answer]
    made = []
    for f in answer:
        draft = Draft(f)
        for x in shared:
            draft.replace(re.compile(_MARKED.replace("NAME", x) + _INDEX), rf"\\vec{{{x}}}_{{vec}}")
        made.append(draft.finished(latex=is_latex(f)) if draft.text != f.text else f)
    return made


def _is_number(letter: str, texts: Sequence[str]) -> bool:
    """Whether a letter that is a vector somewhere occurs without a mark, too."""
    marked = re.compile(_MARKED.replace("NAME", letter))
    bare = re.compile(
        rf"(?<![A-Za-z\\_{{]){letter}(?![A-Za-z_{{]|\s*\\?\()|\{{{letter}\^|\{{\s*{letter}\s*\}}(?<!\\vec\{{{letter}\}})"
    )
    return any(bare.search(marked.sub(" ", text)) for text in texts)
