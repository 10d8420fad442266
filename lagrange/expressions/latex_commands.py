r"""The commands of LaTeX that have a meaning in an answer. There are no others, and nothing is expanded.

Commands are spelled without their backslash. A Greek letter is a name; `\dot` and its like are time derivatives;
`\mathbf{r}`, `\vec{r}`, `\hat{e}` say that a name is a vector's; what is only there for looks is passed over.
"""

from __future__ import annotations

from lagrange.core.diagnostics import nearest
from lagrange.expressions.characters import GREEK
from lagrange.expressions.lexicon import FUNCTIONS as PLAIN_FUNCTIONS

LETTERS = {name: name for name in GREEK.values()} | {
    name: name for name in ("varepsilon", "varphi", "varkappa", "varpi", "ell", "digamma")
}
LETTERS |= {"imath": "i", "jmath": "j"}
"""Letters, and the names that they are."""

FUNCTIONS = {name: name for name in PLAIN_FUNCTIONS if name not in ("asin", "acos", "atan", "atan2", "sqrt", "abs")}
FUNCTIONS |= {"arcsin": "asin", "arccos": "acos", "arctan": "atan", "ln": "log"}
"""Functions, which take what follows: `\\sin 2\\theta`."""

NAMED_FUNCTIONS = {name: name for name in PLAIN_FUNCTIONS} | FUNCTIONS | {"sgn": "sign", "arctan2": "atan2"}
"""Functions as `\\operatorname{...}`, or as plain words."""

ACCENTS = {"dot": 1, "ddot": 2, "dddot": 3}
FRACTIONS = ("frac", "tfrac", "dfrac", "cfrac")
WORDS = ("mathrm", "text", "textrm", "mathit", "textit", "mathsf", "mathnormal", "textnormal", "mbox", "rm")
VECTORS = ("mathbf", "boldsymbol", "bm", "vec", "hat", "pmb", "overrightarrow", "textbf")

SPACES = (",", ";", ":", " ", ">", "quad", "qquad", "enspace", "thinspace", "medspace", "thickspace", "hspace")
"""Spaces that are seen: a function's argument ends there."""

NOTHING = (
    "!", "/", "displaystyle", "textstyle", "scriptstyle", "limits", "nolimits", "nonumber", "notag", "negthinspace",
    "allowbreak", "nobreak", "relax", "centering", "noindent", "hline",
)  # fmt: skip
"""What is passed over."""

MARKS = ("label", "tag", "tag*", "ref", "eqref", "hspace", "vspace", "phantom", "hphantom", "vphantom", "intertext")
"""What is passed over with the braces behind it."""

FRAMES = ("boxed", "fbox", "ensuremath")
"""What stands in their braces counts as if it stood there alone."""

SIZES = (
    "left", "right", *(size + side for size in ("big", "Big", "bigg", "Bigg") for side in ("", "l", "r", "m")),
)  # fmt: skip

OPERATORS = {"cdot": "⋅", "times": "⨯", "ast": "*", "div": "/", "slash": "/", "prime": "'", "equal": "="}

ENVIRONMENTS = tuple(
    name + star
    for name in (
        "equation", "align", "aligned", "alignat", "alignedat", "flalign", "cases", "dcases", "rcases", "gather",
        "gathered", "split", "multline", "multlined", "array", "eqnarray", "subequations", "math", "displaymath",
        "empheq",
    )
    for star in ("", "*")
)  # fmt: skip
"""The environments of mathematics in which equations are looked for."""

_DERIVATIVE = r"write `\dot{x}` or `\frac{d}{dt}(...)`"
_VARIANT = "names come from the problem, and it has none with an accent"
_DEFINED = "nothing is expanded: write out what it stands for"
_CURES = {
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
    "arcsec": r"write `\arccos(1/x)`", "lim": "a limit is no expression", "cdots": "write the terms out",
    "dots": "write the terms out", "ldots": "write the terms out", "middle": "brackets stand in pairs",
    "langle": "write `(...)`, or `\\cdot` between vectors", "partial": r"write `\frac{\partial f}{\partial x}`",
    "ddddot": "equations of motion have second derivatives at most",
}  # fmt: skip
_INEQUALITIES = ("le", "leq", "leqslant", "ge", "geq", "geqslant", "ne", "neq", "ll", "gg", "lt", "gt", "not")


def is_inequality(command: str) -> bool:
    """Whether a command is a relation that makes no equation."""
    return command in _INEQUALITIES


def help_for_command(command: str) -> str:
    """A way out where a command is not known."""
    if command in _CURES:
        return _CURES[command]
    for length in (1, 2):
        if command[:-length] in LETTERS or command[:-length] in FUNCTIONS:
            return rf"did you mean `\{command[:-length]} {command[-length:]}`? A space ends a command"
    known = {
        *LETTERS,
        *FUNCTIONS,
        *ACCENTS,
        *FRACTIONS,
        *OPERATORS,
        "sqrt",
        "operatorname",
        "begin",
        "end",
        "left",
        "right",
    }
    near = nearest(command[:60], known)
    if near is not None:
        return rf"did you mean `\{near}`?"
    return "write it with Greek letters, functions, fractions, roots and dots; nothing is expanded"
