r"""The commands of LaTeX that have a meaning in an answer, and the declared names of letters with subscripts.

Commands are spelled without their backslash; there are no others, and nothing is expanded. A Greek letter is a name;
`\dot`, `\ddot` and `\dddot` are time derivatives; `\mathbf{r}`, `\vec{r}`, `\hat{e}` mark the name of a vector;
commands that only affect the appearance are skipped.

`\theta_{1}` names theta_1 or theta1, `\lambda_{\text{rod}}` lambda_rod, `\theta_{1,B}` theta_1_B or theta1_B,
whichever is declared. A run of letters is a product of declared names, as it is printed: mgR is m g R, unless it is
itself a declared name.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import product

from lagrange.core.diagnostics import nearest
from lagrange.core.records import record
from lagrange.expressions.characters import GREEK, VARIANTS
from lagrange.expressions.limits import MAX_LETTER_RUN, MAX_NAME, MAX_SUBSCRIPTS
from lagrange.expressions.scope import Scope
from lagrange.expressions.syntax_tree import FUNCTIONS as PLAIN_FUNCTIONS
from lagrange.expressions.syntax_tree import Role

LETTERS = {name: name for name in GREEK.values()} | {
    name: name for name in ("varepsilon", "varphi", "varkappa", "varpi", "ell", "digamma")
}
LETTERS |= {"imath": "i", "jmath": "j"}
"""Letters and their names."""

FUNCTIONS = {name: name for name in PLAIN_FUNCTIONS if name not in ("asin", "acos", "atan", "atan2", "sqrt", "abs")}
FUNCTIONS |= {"arcsin": "asin", "arccos": "acos", "arctan": "atan", "ln": "log"}
"""Functions, applied to what follows: `\\sin 2\\theta`."""

NAMED_FUNCTIONS = {name: name for name in PLAIN_FUNCTIONS} | FUNCTIONS | {"sgn": "sign", "arctan2": "atan2"}
"""Functions in `\\operatorname{...}`, or as plain words."""

ACCENTS = {"dot": 1, "ddot": 2, "dddot": 3}
FRACTIONS = ("frac", "tfrac", "dfrac", "cfrac")
WORDS = ("mathrm", "text", "textrm", "mathit", "textit", "mathsf", "mathnormal", "textnormal", "mbox", "rm")
VECTORS = ("mathbf", "boldsymbol", "bm", "vec", "hat", "pmb", "overrightarrow", "textbf")

SPACES = (",", ";", ":", " ", ">", "quad", "qquad", "enspace", "thinspace", "medspace", "thickspace", "hspace")
"""Spaces that are visible in print: the argument of a function ends there."""

NOTHING = (
    "!", "/", "displaystyle", "textstyle", "scriptstyle", "limits", "nolimits", "nonumber", "notag", "negthinspace",
    "allowbreak", "nobreak", "relax", "centering", "noindent", "hline",
)  # fmt: skip
"""Commands that are skipped."""

MARKS = ("label", "tag", "tag*", "ref", "eqref", "hspace", "vspace", "phantom", "hphantom", "vphantom", "intertext")
"""Commands that are skipped together with their argument."""

FRAMES = ("boxed", "fbox", "ensuremath")
"""Commands whose argument is read as if it were written without them."""

SIZES = (
    "left", "right", *(size + side for size in ("big", "Big", "bigg", "Bigg") for side in ("", "l", "r", "m")),
)  # fmt: skip

OPERATORS = {"cdot": "⋅", "times": "⨯", "ast": "*", "div": "/", "slash": "/", "prime": "'", "equal": "="}

_DERIVATIVE = r"write `\dot{x}` or `\frac{d}{dt}(...)`"
_VARIANT = "names come from the problem, and it has none with an accent"
_DEFINED = "nothing is expanded: write out what it stands for"
_SUGGESTIONS = {
    "dv": _DERIVATIVE, "odv": _DERIVATIVE, "diff": _DERIVATIVE, "dd": r"write `\mathrm{d}x`",
    "pdv": r"write `\frac{\partial f}{\partial x}`", "pder": r"write `\frac{\partial f}{\partial x}`",
    "bar": _VARIANT, "tilde": _VARIANT, "overline": _VARIANT, "widetilde": _VARIANT, "widehat": _VARIANT,
    "check": _VARIANT, "breve": _VARIANT, "acute": _VARIANT, "grave": _VARIANT, "mathring": _VARIANT,
    "mathcal": _VARIANT, "mathscr": _VARIANT, "mathfrak": _VARIANT,
    "newcommand": _DEFINED, "renewcommand": _DEFINED, "def": _DEFINED, "let": _DEFINED, "input": _DEFINED,
    "DeclareMathOperator": _DEFINED, "usepackage": _DEFINED, "include": _DEFINED, "csname": _DEFINED,
    "pm": "declare a sign: `parameters: {sigma: sign}` is +1 or -1",
    "mp": "declare a sign: `parameters: {sigma: sign}` is +1 or -1",
    "approx": "an equation is written with `=`", "equiv": "an equation is written with `=`",
    "simeq": "an equation is written with `=`", "sim": "an equation is written with `=`",
    "propto": "an equation is written with `=`", "to": "an equation is written with `=`",
    "Rightarrow": "write one equation on each line", "implies": "write one equation on each line",
    "iff": "write one equation on each line", "Leftrightarrow": "write one equation on each line",
    "int": "there are no integrals in an expression", "sum": "write the terms out", "prod": "write the factors out",
    "nabla": r"write `\frac{\partial f}{\partial x}`", "infty": "numbers are finite",
    "over": r"write `\frac{a}{b}`", "atop": r"write `\frac{a}{b}`", "circ": r"angles are in radians: `30\pi/180`",
    "degree": r"angles are in radians: `30\pi/180`", "%": "write a percentage as a fraction: `10/100`",
    "tg": r"did you mean `\tan`?", "ctg": r"did you mean `\cot`?", "arctg": r"did you mean `\arctan`?",
    "sh": r"did you mean `\sinh`?", "ch": r"did you mean `\cosh`?", "th": r"did you mean `\tanh`?",
    "cosec": r"did you mean `\csc`?", "sgn": r"write `\operatorname{sgn}`", "sign": r"write `\operatorname{sgn}`",
    "arcsec": r"write `\arccos(1/x)`", "lim": "a limit is not an expression", "cdots": "write the terms out",
    "dots": "write the terms out", "ldots": "write the terms out", "middle": "brackets come in pairs",
    "langle": "write `(...)`, or `\\cdot` between vectors", "partial": r"write `\frac{\partial f}{\partial x}`",
    "ddddot": "equations of motion have second derivatives at most",
}  # fmt: skip
_INEQUALITIES = ("le", "leq", "leqslant", "ge", "geq", "geqslant", "ne", "neq", "ll", "gg", "lt", "gt", "not")


def is_inequality(command: str) -> bool:
    """Whether a command is a relation other than equality."""
    return command in _INEQUALITIES


def help_for_command(command: str) -> str:
    """A suggestion for a command that is not known."""
    if command in _SUGGESTIONS:
        return _SUGGESTIONS[command]
    for length in (1, 2):
        if command[:-length] in LETTERS or command[:-length] in FUNCTIONS:
            return rf"did you mean `\{command[:-length]} {command[-length:]}`? A space ends a command"
    known = {*LETTERS, *FUNCTIONS, *ACCENTS, *FRACTIONS, *OPERATORS, "sqrt", "operatorname"}
    known |= {"begin", "end", "left", "right"}
    near = nearest(command[:MAX_NAME], known)
    if near is not None:
        return rf"did you mean `\{near}`?"
    return "write it with Greek letters, functions, fractions, roots and dots; nothing is expanded"


@record
class Run:
    """A run of letters split into names: where each piece ends, and its name.

    several    the two readings between which nothing decides, where there are two with as few pieces
    surprises  whether there is another way to split it
    """

    pieces: tuple[tuple[int, str], ...]
    several: tuple[str, ...] = ()
    surprises: bool = False


@dataclass
class LatexNames:
    """The names of a scope in the spellings of LaTeX."""

    scope: Scope
    _known: dict[str, bool] = field(default_factory=dict)

    def is_declared(self, name: str) -> bool:
        """Whether a name means something."""
        if name not in self._known:
            self._known[name] = self.scope.role(name) is not Role.UNDECLARED
        return self._known[name]

    def spelled(self, stem: str, parts: tuple[str, ...] = ()) -> str | None:
        """The declared name of a letter with subscripts; None if there is none."""
        # Where only l is declared, \ell is an unknown name, and the error suggests l.
        plain = [VARIANTS[stem]] if stem in VARIANTS and stem != "ell" else []
        for letter in (stem, *plain):
            for name in spellings(letter, parts):
                if self.is_declared(name):
                    return name
        return None

    def run(self, text: str, parts: tuple[str, ...] = ()) -> Run:
        """Split a run of letters and digits; the subscripts belong to the last of its names."""
        name = self.spelled(text, parts)
        if name is not None:
            return Run(((len(text), name),))
        if len(text) > MAX_LETTER_RUN:
            return Run(((len(text), spellings(text, parts)[0]),))
        return self._split(text, parts) or Run(tuple(self._blamed(text, parts)))

    def _piece(self, text: str, start: int, end: int, parts: tuple[str, ...]) -> str | None:
        """The name of a piece of a run, if it is a name; digits are never separated from what precedes them."""
        if text[start].isdigit() or (end < len(text) and text[end].isdigit()):
            return None
        if end < len(text):
            return text[start:end] if self.is_declared(text[start:end]) else None
        if not parts and text[start:] in NAMED_FUNCTIONS and end - start > 1:
            return text[start:]
        return self.spelled(text[start:], parts)

    def _split(self, text: str, parts: tuple[str, ...]) -> Run | None:
        """Split a run into as few declared names as possible; a tie is left to the author of the text.

        The best splits of each prefix are built from those of shorter ones. Two are kept, enough to show a tie.
        """
        best: list[list[tuple[tuple[int, str], ...]]] = [[()]]
        ways = [1]
        for end in range(1, len(text) + 1):
            candidates: list[tuple[tuple[int, str], ...]] = []
            count = 0
            for start in range(end):
                if best[start] and (name := self._piece(text, start, end, parts)) is not None:
                    candidates += [(*before, (end, name)) for before in best[start]]
                    count += ways[start]
            fewest = min(map(len, candidates), default=0)
            best.append([way for way in candidates if len(way) == fewest][:2])
            ways.append(count)
        if not best[-1]:
            return None
        first, *others = best[-1]
        return Run(first, tuple(" ".join(name for _, name in way) for way in [first, *others] if others), ways[-1] > 1)

    def _blamed(self, text: str, parts: tuple[str, ...]) -> list[tuple[int, str]]:
        """The pieces of a run that is not a product of declared names, so that an error points at the unknown one.

        A run that resembles a declared name is one piece, a misspelling.
        """
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
    """The possible names of a letter with subscripts, the usual one first: theta_1_B, theta_1B, theta1_B, theta1B."""
    if not parts or len(parts) > MAX_SUBSCRIPTS:
        return ("_".join((stem, *parts)),)
    joints = product("_|", repeat=len(parts))
    return tuple(
        stem + "".join(joint.replace("|", "") + part for joint, part in zip(how, parts, strict=True)) for how in joints
    )
