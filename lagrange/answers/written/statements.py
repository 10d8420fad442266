r"""A statement about one quantity: its value, with a label on the left, and the definitions of what occurs in it.

    x_max = 2 m g/k          v_\text{esc} = \sqrt{2K/R}          h = l (1 - cos(theta)) = v^2/(2 g)
    m g/k (1 - cos(w t)), w = sqrt(k/m)

A label is a name that stands alone on the left and that the problem does not declare: it says what is stated, and is
omitted. A name that is defined after a comma or `where` has that meaning in the statement. Of several sides the first
and the last are compared.
"""

from __future__ import annotations

import re
from collections.abc import Collection
from dataclasses import replace

import sympy as sp

from lagrange.answers.limits import MOST_SIDE_DEFINITIONS
from lagrange.answers.written.names import without_arguments
from lagrange.answers.written.notation.plain import cleaned, is_rate
from lagrange.answers.written.reading import too_long, tried
from lagrange.core.diagnostics import Fragment, ProblemError
from lagrange.core.records import record
from lagrange.core.vectors import Vector
from lagrange.expressions.characters import GREEK, SUBSCRIPTS
from lagrange.expressions.edits import cut, cuts
from lagrange.expressions.limits import MAX_ANSWER_CHARACTERS
from lagrange.expressions.reader import Scope, read_value, token_texts
from lagrange.expressions.scope import RESERVED

_EQUALS = re.compile(r"(?<![<>!=:])(?::=|==?)(?![=>])")
_BEYOND = re.compile(
    r"[,;]|\b(?:where|with|and|wobei|mit|und)\b|(?<![_^])\\(?:text|mbox)\s*\{[^{}]{0,20}\}|\\q?quad(?![A-Za-z])",
    re.IGNORECASE,
)
_INDEX = r"(?:\{(?:[^{}]|\{[^{}]{0,20}\}){0,30}\}|\\(?:text|mathrm|rm)\s*\{[^{}]{0,20}\}|\\?(?:(?![²³])\w){1,12}|\*)"
_GREEK = "|".join(sorted(set(GREEK.values()), key=len, reverse=True))
_MARKED = re.compile(
    rf"\\?(?P<name>[^\W\d_]|{_GREEK})_(?:\{{\s*)?(?:\\(?:text|mathrm|rm)\s*\{{?\s*)?\\?(?P<index>\w{{1,12}})"
)
_LABEL = re.compile(
    rf"\s*\$?\s*(?:\\Delta\s*|Δ\s*)?(?P<name>[^\W\d_]|\\?(?:{_GREEK}))(?:[0-9{''.join(SUBSCRIPTS)}]{{1,3}}|_{_INDEX}|\^(?!\s*\{{?\s*2){_INDEX}){{0,2}}\s*(?:\([^()=]{{0,12}}\))?\s*"
    r"(?P<square>(?:\^\s*\{?\s*2\s*\}?|²)?)\s*\Z"
)


@record
class Statement:
    """What is stated: one side is a value, two are an equation.

    scope   with the names that the statement defines
    label   the letter of what was omitted on the left, with `^2` if its square is stated; empty if nothing was
    """

    sides: tuple[Fragment, ...]
    scope: Scope
    label: str = ""


def statement(fragment: Fragment, scope: Scope, declared: Collection[str] = (), name: str = "") -> Statement:
    """The sides of a statement without its label. A coordinate with an index, theta_1, is its value there.

    declared  names that are never labels, if others are that the scope contains
    name      what is stated, which may be its label

    Raises ProblemError if the text is too long.
    """
    if len(fragment.text) > MAX_ANSWER_CHARACTERS:
        raise too_long(fragment)
    text = without_arguments(cleaned(fragment), scope)
    scope = _with_marked(text, scope)
    parts = _parts(text)
    beyond = parts[1:]
    if not beyond or len(beyond) > MOST_SIDE_DEFINITIONS:
        parts = [text]
    else:
        is_value = len(cuts(parts[0].text, _EQUALS)) == 1
        for _ in beyond:
            for part in beyond:
                scope = _with_definition(part, scope, places=is_value)
        parts = parts[:1]
    sides = [cut(parts[0], *place) for place in cuts(parts[0].text, _EQUALS)]
    label = ""
    while len(sides) > 1 and (labelled := _label(sides[0], scope, declared, name)):
        label, sides = label or labelled, sides[1:]
    for side in sides[1:-1]:  # of a = b = c all must be readable
        tried(side, scope, lambda f: read_value(f, scope, [], latex=True))
    return Statement(tuple(sides if len(sides) < 3 else (sides[0], sides[-1])), scope, label)


def _with_marked(text: Fragment, scope: Scope) -> Scope:
    """The scope with coordinates that have an index which no name of the problem has: `theta_1`, `x_max`."""
    marked = marked_coordinates(text, scope)
    return replace(scope, scalars={**scope.scalars, **marked}) if marked else scope


def marked_coordinates(text: Fragment, scope: Scope) -> dict[str, sp.Symbol]:
    """The coordinates that occur with an index, under their names with it."""
    coordinates = {q.name: q for q in scope.slots.coordinates}
    marked = {}
    for match in _MARKED.finditer(text.text):
        symbol = coordinates.get(GREEK.get(match["name"], match["name"]))
        name = f"{symbol}_{match['index']}"
        if symbol is not None and scope.scalar(name) is None and not is_rate(name, scope):
            marked[name] = symbol
    return marked


def _parts(text: Fragment) -> list[Fragment]:
    """The statement and the definitions after it, provided that everything separated from it is a definition."""
    places = [(a, b) for a, b in cuts(text.text, _BEYOND) if text.text[a:b].strip(" $.~")]
    if not all(len(cuts(text.text[a:b], _EQUALS)) == 2 for a, b in places[1:]):
        return [text]
    return [cut(text, *place) for place in places]


def _with_definition(part: Fragment, scope: Scope, *, places: bool) -> Scope:
    """The scope with a name that a part defines; the same if it defines none.

    places  whether it may be a coordinate, which then has this value at the place in question: `2 x/v, x = ...`
    """
    left, right = (cut(part, *place) for place in cuts(part.text, _EQUALS))
    try:
        names = tried(left, scope, lambda f: token_texts(f, scope))
        squared = names[1:] == ["^", "2"]
        names = names[:1] if squared else names
        if len(names) != 1 or names[0] in RESERVED or not names[0][:1].isalpha():
            return scope
        known = scope.scalar(names[0])
        if known is not None and not (places and known in scope.slots.coordinates):
            return scope
        value = tried(right, scope, lambda f: read_value(f, scope, [], latex=True))
    except ProblemError:
        return scope
    if isinstance(value, Vector):
        return scope
    return replace(scope, scalars={**scope.scalars, names[0]: sp.sqrt(value) if squared else value})


def _label(side: Fragment, scope: Scope, declared: Collection[str], name: str) -> str:
    """The letter of a label; empty if the side is none."""
    written = side.text.strip(" $&")  # without the sign of an alignment
    if name and written == name and name not in scope.names():
        return name
    match = _LABEL.match(written)
    if match is None:
        return ""
    letter = f"{match['name']}{'^2' if match['square'] else ''}"
    try:
        tried(side, scope, lambda f: read_value(f, scope, [], latex=True))
    except ProblemError:
        return letter
    return letter if declared and match["name"] not in declared else ""
