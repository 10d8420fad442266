r"""Which declared name is meant by letters and subscripts in LaTeX.

`\theta_{1}` names theta_1 or theta1, `\lambda_{\text{rod}}` lambda_rod, `\theta_{1,B}` theta_1_B or theta1_B,
whichever is declared. A run of letters is a product of declared names, as it is printed: mgR is m g R, unless it is
itself a name.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import product

from lagrange.core.diagnostics import nearest
from lagrange.core.records import record
from lagrange.expressions.characters import VARIANTS
from lagrange.expressions.latex_commands import NAMED_FUNCTIONS
from lagrange.expressions.lexicon import Role
from lagrange.expressions.scope import Scope

LONGEST_RUN = 60
_MOST_PARTS = 4


@record
class Run:
    """A run of letters taken apart: where each piece ends, and the name that it is.

    several    other ways in which it could be read, as few pieces each
    surprises  whether another reader could have taken it apart otherwise
    """

    pieces: tuple[tuple[int, str], ...]
    several: tuple[str, ...] = ()
    surprises: bool = False


@dataclass
class Names:
    """The names of a scope, as LaTeX spells them."""

    scope: Scope
    _known: dict[str, bool] = field(default_factory=dict)

    def is_declared(self, name: str) -> bool:
        """Whether a name means something."""
        if name not in self._known:
            self._known[name] = self.scope.role(name) is not Role.UNDECLARED
        return self._known[name]

    def spelled(self, stem: str, parts: tuple[str, ...] = ()) -> str | None:
        """The declared name that a letter with subscripts is; None where there is none."""
        plain = [VARIANTS[stem]] if stem in VARIANTS and stem != "ell" else []  # of \ell it is said that l is meant
        for letter in (stem, *plain):
            for name in spellings(letter, parts):
                if self.is_declared(name):
                    return name
        return None

    def run(self, text: str, parts: tuple[str, ...] = ()) -> Run:
        """A run of letters and digits, the last of which has subscripts."""
        whole = self.spelled(text, parts)
        if whole is not None:
            return Run(((len(text), whole),))
        if len(text) > LONGEST_RUN:
            return Run(((len(text), spellings(text, parts)[0]),))
        return self._split(text, parts) or Run(tuple(self._blamed(text, parts)))

    def _piece(self, text: str, start: int, end: int, parts: tuple[str, ...]) -> str | None:
        """The name that a piece of a run is, if it is one."""
        if text[start].isdigit() or (end < len(text) and text[end].isdigit()):
            return None
        if end < len(text):
            return text[start:end] if self.is_declared(text[start:end]) else None
        if not parts and text[start:] in NAMED_FUNCTIONS and end - start > 1:
            return text[start:]
        return self.spelled(text[start:], parts)

    def _split(self, text: str, parts: tuple[str, ...]) -> Run | None:
        """As few declared names as possible. Several ways with as few are left to the reader."""
        best: list[list[tuple[tuple[int, str], ...]]] = [[()]]
        ways = [1]
        for end in range(1, len(text) + 1):
            found: list[tuple[tuple[int, str], ...]] = []
            count = 0
            for start in range(end):
                if best[start] and (name := self._piece(text, start, end, parts)) is not None:
                    found += [(*before, (end, name)) for before in best[start]]
                    count += ways[start]
            fewest = min(map(len, found), default=0)
            best.append([way for way in found if len(way) == fewest][:2])
            ways.append(count)
        if not best[-1]:
            return None
        first, *others = best[-1]
        return Run(first, tuple(" ".join(name for _, name in way) for way in [first, *others] if others), ways[-1] > 1)

    def _blamed(self, text: str, parts: tuple[str, ...]) -> list[tuple[int, str]]:
        """The pieces of a run that is no product of declared names: those that are declared, and the rest."""
        near = nearest(text, self.scope.names()) if len(text) > 1 else None
        if near is not None and (near.casefold() == text.casefold() or len(text) > 2):
            return [(len(text), spellings(text, parts)[0])]
        pieces: list[tuple[int, str]] = []
        at = 0
        while at < len(text):
            ends = range(len(text), at, -1)
            end = next((e for e in ends if self._piece(text, at, e, parts) is not None), 0)
            name = self._piece(text, at, end, parts) if end else None
            if name is None:
                end = at + 1
                while end < len(text) and text[end].isdigit():
                    end += 1
                name = text[at:end] if end < len(text) else spellings(text[at:], parts)[0]
            pieces.append((end, name))
            at = end
        declared = [name for _, name in pieces if self.is_declared(name)]
        return pieces if declared else [(len(text), spellings(text, parts)[0])]


def spellings(stem: str, parts: tuple[str, ...]) -> tuple[str, ...]:
    """The names that a letter with subscripts may be, the usual one first: theta_1_B, theta_1B, theta1_B, theta1B."""
    if not parts or len(parts) > _MOST_PARTS:
        return ("_".join((stem, *parts)),)
    joints = product("_|", repeat=len(parts))
    return tuple(
        stem + "".join(joint.replace("|", "") + part for joint, part in zip(how, parts, strict=True)) for how in joints
    )
