"""Things that no printed result may contain, searched for in the whole JSON and on the terminal page.

Results of algebra that has gone wrong: imaginary units, nan, an infinity where no limit is taken, functions that readers
do not know (DiracDelta, Piecewise), a root of a negative number. And names that are in neither the file nor the notation:
internal ones, and those that were never replaced.
"""

from __future__ import annotations

import ast
import math
import re
from collections.abc import Iterator
from typing import Any

import yaml

from lagrange.document.derivation import Detail
from lagrange.explain.report import Report
from lagrange.render import terminal
from tests.support.nets.evaluate import FUNCTIONS, NotReadError, evaluate, names_in

WIDTH = 100
NOT_IN_PRINT = re.compile(
    r"\bnan\b|\bNaN\b|\bzoo\b|(?<!→ )∞|(?<!→ )\boo\b|ImaginaryUnit|Infinity|DiracDelta|Heaviside|_of_equilibrium"
    r"|Subs\(|Derivative\(|Piecewise|ExprCondPair|RootOf|CRootOf|\bre\(|\bim\(|_?Dummy|√−|√\(−[\d.]+\)|sqrt\(-[\d.]+\)"
)
PREDEFINED = {"i", "j", "k", "e_x", "e_y", "e_z", "t", "pi", "delta", "d", "diff", "const"}
RESULTS = {
    "C",
    "F",
    "Omega",
    "S",
    "T",
    "V",
    "Z",
    "e",
    "e1",
    "e2",
    "e3",
    "lambda",
    "n1",
    "n2",
    "n3",
    "omega",
    "p",
    "pi",
    "sigma",
    "xi",
    "zeta",
}
"""Letters that results have beside the names of the file, alone or before a name or a number: multipliers, signs of
roots, displacements, frequencies and damping ratios, momenta, impulses, friction, abbreviations, constants, axes of bodies."""

LETTERS = RESULTS | {"A", "Gamma", "H", "L", "M", "Phi", "Q", "R", "U", "d", "phi", "q", "r", ""}
"""Those that the steps of the derivation have besides: positions, reactions, energies, phases."""

WORDS = {"kind", "because", "stability", "how", "name", "choice", "unit", "method", "verdict", "conditions_are", "title",
         "source", "answers", "checks", "problem", "status", "sense", "meaning", "words"}  # fmt: skip
"""Keys under which JSON has words."""

IN_WORDS = {"title", "description", "source", "meaning", "note", "axes", "answers", "unit", "units"}
"""Keys under which a file has words."""


def names_of_file(text: str) -> set[str]:
    """All names in a problem file, except those in its prose."""
    return {n for x in _texts(yaml.load(text, yaml.BaseLoader), IN_WORDS, True) for n in re.findall(r"[^\W\d]\w*", x)}


def unfit(found: Report, shown: dict[str, Any], names: set[str]) -> Iterator[tuple[str, str, str]]:
    """What kind of fault it is, what is wrong, and in which text: the report as JSON and as a page; `names` of the file."""
    page = terminal.text(found.derivation, found.notation, WIDTH, Detail.FULL)
    for text in (*_texts(shown, set()), *page.splitlines()):
        if bad := NOT_IN_PRINT.search(text):
            yield "not for print", bad[0], text.strip()
    known = names | PREDEFINED | {f"lambda_{c['name']}" for c in shown["constraints"]}
    for text in _texts({k: v for k, v in shown.items() if k != "steps"}, WORDS):
        if not _in_words(text):
            strange = {n for n in names_in(text) - known - {"or"} if not _is_notation(n, known, RESULTS)}
            yield from (("strange symbol", n, text) for n in sorted(strange))
            yield from (("not for print", part, text) for part in _without_value(text))
    known |= {n for text in _texts(shown.get("steps", []), set()) for n in re.findall(r"with an angle (\w+)", text)}
    for text in _equations(shown.get("steps", [])):
        yield from (("not for print", part, text) for part in _without_value(text))
        strange = {n for n in names_in(text) - known if not _is_notation(n, known, LETTERS)}
        yield from (("strange symbol", n, text) for n in sorted(strange))


_UNIT = re.compile(r"(?<=\d) [A-Za-z°%][\w°%/^() ]*$")
"""Behind a number, where a product has its sign: 8.561 N, 2 m/s^2."""


def _equations(value: Any) -> Iterator[str]:
    """The texts of the equations in the steps of a derivation."""
    if isinstance(value, dict):
        yield from (_UNIT.sub("", e["text"]) for e in value.get("equations", ()) if "text" in e)
        value = [*value.values()]
    if isinstance(value, list):
        for v in value:
            yield from _equations(v)


def _is_notation(name: str, known: set[str], letters: set[str]) -> bool:
    letter, _, index = name.partition("_")
    return letter in letters and (bool({index, re.sub(r"_\d+$", "", index)} & {*known, "", "k"}) or index.isdigit())


def _in_words(text: str) -> bool:
    """Whether a text is a sentence or a phrase: two words in a row, with no sign between them."""
    return bool(re.search(r"[A-Za-z]{2,} [A-Za-z]{2,}", text))


def _texts(value: Any, without: set[str], with_keys: bool = False) -> Iterator[str]:
    """All texts of an object, and its keys where they are names, except the values of some keys."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, dict):
        for k, v in value.items():
            if k not in without:
                yield from (k,) if with_keys else ()
                yield from _texts(v, without, with_keys)
    elif isinstance(value, list):
        for v in value:
            yield from _texts(v, without, with_keys)


def _without_value(text: str) -> Iterator[str]:
    """The parts of an expression in numbers alone that are no real numbers: sqrt(2 - 3), asin(2), log(-1)."""
    for side in re.split(r"\s(?:=|!=|>=|<=|>|<)\s", text):
        source = re.sub(r"('+)", lambda m: f"__{len(m[1])}", side.replace("^", "**"))
        try:
            tree = ast.parse(source.strip(), mode="eval")
        except SyntaxError:
            continue  # of no expression; the nets read back what they compare
        for node in ast.walk(tree):
            if isinstance(node, ast.Call) and not any(
                isinstance(x, ast.Name) and x.id not in FUNCTIONS | {"pi"} for x in ast.walk(node)
            ):
                part = ast.unparse(node)
                try:
                    value = evaluate(part, {"pi": math.pi})
                except (NotReadError, ArithmeticError, ValueError):
                    continue
                if isinstance(value, float) and not math.isfinite(value):
                    yield part
