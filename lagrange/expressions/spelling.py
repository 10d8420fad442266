"""What was meant by a name that nobody declared."""

from __future__ import annotations

from lagrange.core.diagnostics import nearest
from lagrange.expressions.characters import GREEK
from lagrange.expressions.lexicon import FUNCTIONS, OPERATIONS, Role
from lagrange.expressions.scope import RESERVED, UNITS, Scope

_LONGEST_SPLIT = 24
_MOST_LISTED = 30
_OTHER_NAMES = {
    "ln": "log", "arcsin": "asin", "arccos": "acos", "arctan": "atan", "arctan2": "atan2", "arctg": "atan",
    "tg": "tan", "ctg": "cot", "cotan": "cot", "cosec": "csc", "sh": "sinh", "ch": "cosh",
    "th": "tanh", "sgn": "sign", "signum": "sign", "root": "sqrt", "Derivative": "diff", "derivative": "diff",
    "grad": "diff",
}  # fmt: skip
_ALIKE = tuple(
    group.split()
    for group in (
        "l I ell", "O o omicron", "v nu V upsilon", "w omega varpi", "u mu", "p rho", "a alpha", "k kappa varkappa K",
        "x chi X", "n eta", "t tau", "y gamma", "B beta", "E epsilon varepsilon", "phi varphi", "theta vartheta",
        "rho varrho", "sigma varsigma", "i iota", "d delta", "W omega",
    )
)  # fmt: skip
"""Letters that are taken for one another."""
_RATES = (("ddot", 2), ("dot", 1))


def help_for_symbol(name: str, scope: Scope) -> str:
    """A way out where a symbol is not declared."""
    names = scope.names()
    if name in OPERATIONS or name in FUNCTIONS:
        return f"write `{name}(...)`"
    if name == "e":
        return "the exponential function is `exp(x)`; any other `e` must be declared"
    if scope.scalar("e") is not None and name[0] in "eE" and name[1:].isdigit():
        return f"`e` is a symbol here: a power of ten is written `10^{name[1:]}`"
    if name in ("d", "delta"):
        return f"a differential is written `{name}(x)`; any other `{name}` must be declared"
    if rate := _rate(name, scope):
        return f"did you mean `{rate}`? A prime is a time derivative"
    if differential := _differential(name, scope):
        return f"did you mean `{differential}`?"
    if (split := _split(name, scope)) and name not in GREEK.values():
        return f"did you mean `{split}`? Symbols are multiplied with a space or `*` between them"
    near = nearest(name[:60], names)
    if (near is None or near.casefold() != name.casefold()) and (alike := _alike(name, scope)):
        return f"did you mean `{alike}`?"
    if near:
        return f"did you mean `{near}`?"
    declared = [f"`{n}`" for n in names if n not in RESERVED]
    if len(declared) > _MOST_LISTED:
        declared[_MOST_LISTED:] = ["..."]
    return f"declared are {', '.join(declared)}" if declared else "no symbol is declared here"


def help_for_function(name: str, scope: Scope) -> str:
    """A way out where a name before a parenthesis is neither a function nor a symbol."""
    functions = [*FUNCTIONS, *OPERATIONS, *scope.functions]
    if name in _OTHER_NAMES:
        return f"did you mean `{_OTHER_NAMES[name]}`?"
    if split := _split(name, scope):
        return f"did you mean `{split}(...)`? Symbols are multiplied with a space or `*` between them"
    symbol = nearest(name[:60], scope.names())
    if symbol and symbol.casefold() == name.casefold():
        return f"did you mean `{symbol}`?"
    if near := nearest(name[:60], functions):
        return f"did you mean `{near}`?"
    return f"the functions are {', '.join(functions)}; any other name must be declared"


def _alike(name: str, scope: Scope) -> str:
    """The declared name that looks like one: l for \\ell, omega for w; with the same index."""
    letter, joint, index = name.partition("_")
    for group in _ALIKE:
        if letter in group:
            for other in group:
                if other != letter and scope.role(other + joint + index) is not Role.UNDECLARED:
                    return other + joint + index
    return ""


def _rate(name: str, scope: Scope) -> str:
    """x' for x_dot, xdot, x_ddot, x_t."""
    for ending, order in _RATES:
        stem = name.removesuffix(ending).rstrip("_")
        if name.endswith(ending) and scope.scalar(stem) is not None:
            return stem + "'" * order
    return ""


def _differential(name: str, scope: Scope) -> str:
    """d(x) for dx."""
    for operator in ("delta", "d"):
        stem = name.removeprefix(operator)
        if stem != name and scope.role(stem) is Role.COORDINATE:
            return f"{operator}({stem})"
    return ""


def _split(name: str, scope: Scope) -> str:
    """A run of letters as a product of known names, if it is one: `ml` -> m l. The fewest names win."""
    if len(name) > _LONGEST_SPLIT:
        return ""
    names = {*scope.names(), *UNITS}
    best: list[list[str] | None] = [[]]
    for end in range(1, len(name) + 1):
        ways = [
            [*before, name[start:end]]
            for start in range(end)
            if (before := best[start]) is not None and name[start:end] in names
        ]
        best.append(min(ways, key=len) if ways else None)
    found = best[-1]
    return " ".join(found) if found and len(found) > 1 else ""
