r"""Names in an answer that the problem does not declare: usual ones, short ones of a page, vectors, coordinates.

Names of coordinates and of their rates that the problem does not declare but every reader understands.

    th, ph1                      θ, φ1, where these are coordinates and `th` is nothing else
    \ell, ℓ                      l
    a, in `m a = ...`            x'', where x is the only coordinate that is a length
    v, in `m dv/dt = ...`        x', likewise
    v, in `m v^2/2 = ...`        the speed of the only particle
    a_x, v_x                     x'', x', where x is a coordinate; unless the answer defines them: a_x = x''
    dx, where ddx stands, too    x'
    r_1, r_2                     the positions of the first and the second particle
    state_1                      the first coordinate of a program that numbers them

A name that the problem declares, or that the answer defines, keeps its meaning.

The short names that a page has for reactions, T for T_rod, in an answer.

A derivation with one constraint prints its reaction as T, N or λ. Whoever answers `T = m g cos θ + m l θ'^2` means that
force, if the problem declares no T. A name in several equations is an unknown force, or defined by one of them, as any
other undeclared name. A T may also be the kinetic energy or a period: a T whose terms are all squares of velocities,
that occurs with a V or in L, or that has the dimension of a time, is no force.

Vectors and their magnitudes under one letter: \vec r beside r^3 is r_vec, and r is its magnitude.

The letter is a vector where it has an arrow, a bold face or a bar, and a number where it has none. Where both occur
without an index, the vector gets a name of its own.

Coordinates of the answer's own: names that an equation with a coordinate of the problem defines.

    r = l + s, s the extension of the spring      s = r − l
    x = R φ,   x' = R φ'                          φ = x/R

One side is a coordinate alone, or has velocities alone, or accelerations alone, linearly; the other has one name that
nobody declared, to the same order and linearly. Where it has only rates of that name, its coefficients are constants,
so that the equation can be integrated; the constant of integration does not matter in an equation of motion. A velocity
may have a name without a prime, `x' = R omega`.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.answers.limits import LONGEST_NEW_COORDINATE
from lagrange.answers.references import Reference
from lagrange.answers.written.notation.rare import with_indices
from lagrange.answers.written.reading import read_as_written
from lagrange.core.diagnostics import Fragment
from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import Slots, base, prime, t
from lagrange.core.units import NO_DIMENSION
from lagrange.core.vectors import Vector
from lagrange.expressions.characters import GREEK, SUBSCRIPTS
from lagrange.expressions.edits import Draft
from lagrange.expressions.latex_layout import is_latex
from lagrange.expressions.scope import Scope
from lagrange.expressions.syntax_tree import Role
from lagrange.mechanics.dynamics.newton import short_reactions
from lagrange.mechanics.dynamics.reaction_signs import ForceKind
from lagrange.values.dimensions import dimension, dimension_of_unit, dimensions_of_units

_SHORT = {"th": "theta", "tht": "theta", "ph": "phi", "ps": "psi", "al": "alpha", "alp": "alpha", "be": "beta"}
_SHORT |= {"w": "omega", "W": "Omega"}
_SHORT |= {"bet": "beta", "ga": "gamma", "gam": "gamma", "ka": "kappa", "om": "omega", "Om": "Omega", "lam": "lambda"}
_ABBREVIATION = re.compile(rf"(?<![A-Za-z0-9_\\])({'|'.join(_SHORT)})(_?[0-9]{{0,2}})(?=d{{0,2}}(?:ot)?(?![A-Za-z]))")
_OMEGA = re.compile(r"(?<![A-Za-z0-9_])(?:\\?omega(?![A-Za-z])|ω)(?![0-9_'(₀-₉]|\s*_)")
_DERIVED_TWICE = re.compile(r"''|\u0308|¨|ddot|″|d\s*(?:\^\s*\{?2|²)")
_SCRIPT_L = re.compile(r"\\ell(?![A-Za-z])|ℓ")
_MASS_TIMES_A = re.compile(r"(?<![A-Za-z_])[mM](?:_?[0-9])?\s*[*·]?\s*a(?![A-Za-z0-9_'(^])")
_A_IS = re.compile(r"[\s$&]*a\s*&?=(?!=)(?=[^=]*(?<![A-Za-z\\])g(?![A-Za-z]))[^=]*\Z")
_TWICE_DERIVED = re.compile(r"(?<![A-Za-z0-9_])([^\W\d_][A-Za-z0-9_]{0,12})(?:''|\u0308|¨)")
_A_STATED = re.compile(
    r"(?<![\w\\])a\s*&?=[^=+]*(?:''|ddot|\u0308|¨|dv|d\^2|d²)|(?:''|\u0308|¨|\}|v\u0307)[^=+]*=\s*a\s*\Z"
)
_RATE_OF_V = re.compile(
    r"(?<![A-Za-z_])[mM]\s*[*·]?\s*v'|(?<![A-Za-z])d\s?v\s*(?:/|\}\s*\{)\s*d\s?[a-z]|\\dot\s*\{?\s*v(?![A-Za-z])|v\u0307"
)
_V_IS = re.compile(r"(?<![A-Za-z_])(?<!\\dot\s)(?<!/dt\s)v(?:\^2|²|\^\{2\})?\s*&?=(?!=)|=\s*v\s*\Z")
_V_SQUARED = re.compile(r"(?<![A-Za-z_\\])v\s*(?:\^\s*\{?\s*2|²|\*\*\s*2)")
_STATE = re.compile(r"(?<![A-Za-z0-9_])state_([0-9]{1,2})(?![0-9])")
_PLACE = re.compile(
    r"(?<![A-Za-z0-9_])(?:\\(?:mathbf|vec|boldsymbol|bm)\s*\{?\s*)?r\s*\}?\s*_?\{?([1-9])\}?(?![A-Za-z0-9_])"
)
_OF_COORDINATE = re.compile(
    r"[\s$&]*(?P<name>\\?[^\W\d_](?:\w{0,12}|_\{\w{1,12}\}))\s*(?P<bracket>(?:\\left)?\(\s*(?P<argument>\\?\w{1,12})\s*(?:\\right)?\))"
    r"\s*&?=(?!=)"
)
_QUANTITY = r"\\?[^\W\d_]+(?:_\w{1,8}|_\{\w{1,8}\})?"
_MODULUS = re.compile(
    r"[\s$&]*(?P<bars>(?:\\left\s*)?(?:\||\\[lv]vert)\s*(?P<name>\\?[^\W\d_]\w{0,12})\s*(?:\\right\s*)?(?:\||\\[rv]vert))\s*&?=(?!=)"
)
_RATE_OVER = (
    rf"[\s$&]*(?:d\s?(?P<name>{_QUANTITY})\s*/\s*d\s?(?P<by>{_QUANTITY})"
    rf"|\\[dt]?frac\s*\{{\s*(?:d|\\mathrm\s*\{{\s*d\s*\}})\s*(?P<name2>{_QUANTITY})\s*\}}"
    rf"\s*\{{\s*(?:d|\\mathrm\s*\{{\s*d\s*\}})\s*(?P<by2>{_QUANTITY})\s*\}})\s*&?="
)
_STATIONARY = re.compile(rf"{_RATE_OVER}\s*0[\s.,;$]*\Z")
_RATE_ALONG = re.compile(rf"{_RATE_OVER}(?!\s*0[\s.,;$]*\Z)")
AT_EQUILIBRIUM = frozenset({"0", "e", "eq", "s", "st", "stat", "G", "gl", "eqm", "star", "equilibrium"})
"""The index of a coordinate at rest."""
_WITH_INDEX = re.compile(
    rf"(?<![A-Za-z0-9_])\\?(?P<name>[A-Za-z]+|[{''.join(GREEK)}])_(?:\{{\s*(?:\\(?:text|mathrm|rm)\s*\{{?)?)?(?P<index>[0-9A-Za-z]{{1,12}})(?![A-Za-z0-9])"
)
_RATE_SIGN = re.compile(r"['\u0307\u0308¨˙′]|\\d?dot|_?d?dot|/\s*d")


def other_names(
    texts: Sequence[str], scope: Scope, reference: Reference
) -> tuple[Mapping[str, sp.Expr], Mapping[str, Vector]]:
    """The meanings of the undeclared names of coordinates, of their rates, and of positions in an answer."""
    whole = "\n".join(texts)
    scalars: dict[str, sp.Expr] = {}
    for match in _ABBREVIATION.finditer(whole):
        name, long = match[1] + match[2], _SHORT[match[1]] + match[2]
        value = scope.scalar(scope.spelling(long))
        if (
            value is not None
            and str(value) not in reference.letters
            and scope.role(name) is Role.UNDECLARED
            and not _defined(name, texts)
        ):
            scalars[name] = value
    has_w = "w" in reference.parameters and "omega" not in reference.parameters and not _defined("omega", texts)
    if has_w and _OMEGA.search(whole) and _DERIVED_TWICE.search(whole):  # and no frequency is stated
        scalars["omega"] = reference.parameters["w"]
    if _SCRIPT_L.search(whole) and scope.role("ell") is Role.UNDECLARED and not _defined("ell", texts):
        length = scope.scalar("l")
        scalars |= {"ell": length} if length is not None and "l" in reference.declared else {}
    if "a_" in whole or "v_" in whole:
        for q in scope.slots.coordinates:
            for letter, value in (("a", prime(prime(q))), ("v", prime(q))):
                name = f"{letter}_{q}"
                written = re.compile(rf"(?<![A-Za-z0-9_\\]){letter}_\{{?\\?{q}\}}?(?![A-Za-z0-9])")
                if scope.role(name) is Role.UNDECLARED and written.search(whole) and not _states_a_rate(written, texts):
                    scalars[name] = value
    if (length := _only_length(scope, reference)) is not None:
        if _is_acceleration(texts, scope):
            scalars["a"] = prime(prime(length))
        if _is_speed(texts, scope, reference):
            scalars["v"] = prime(length)
    elif _is_speed(texts, scope, reference) and (along := _speed_along_path(reference)) is not None:
        scalars["v"] = along
    if "v" not in scalars and _is_squared_speed(texts, scope) and (speed := _only_speed(reference)) is not None:
        scalars["v"] = speed
    if states := {int(m[1]) for m in _STATE.finditer(whole)}:
        named = {*scalars.values()} | {q for q in scope.slots.coordinates if has_word(q.name, whole)}
        scalars.update(_of_states(max(states), named, reference))
    return scalars, _positions(whole, scope)


def coordinates_at_rest(texts: Sequence[str], scope: Scope) -> dict[str, sp.Expr]:
    """theta_0 as theta at rest, in statics; with `x = R*phi + x_0`, which gives x itself, x_0 is a constant."""
    coordinates = {q.name: q for q in scope.slots.coordinates}
    at_rest: dict[str, sp.Expr] = {}
    for text in texts:
        for match in _WITH_INDEX.finditer(text):
            symbol = coordinates.get(GREEK.get(match["name"], match["name"]))
            name = f"{symbol}_{match['index']}"
            if symbol is not None and match["index"] in AT_EQUILIBRIUM and scope.role(name) is Role.UNDECLARED:
                at_rest[name] = symbol
    stated = {
        n for n in at_rest if any(re.match(rf"[\s$]*\\?{n.partition('_')[0]}\b[^=+*/()-]*=", text) for text in texts)
    }
    beside = {n for n, q in at_rest.items() if any(has_word(n, text) and has_word(q.name, text) for text in texts)}
    return {n: q for n, q in at_rest.items() if n not in stated | beside}


def _only_length(scope: Scope, reference: Reference) -> sp.Symbol | None:
    """The only coordinate that is a length and is not fixed by a constraint; None if there is none, or another."""
    lengths = {q for q, unit in reference.units.items() if unit == "m" and q in scope.slots.coordinates}
    sets = [c.configuration.slots.coordinates for c in reference.candidates]
    for c in reference.candidates:
        if c.configuration.slots.coordinates == sets[0]:
            rows = [[q for q, a in zip(sets[0], r.coefficients, strict=False) if a != 0] for r in c.configuration.rows]
            lengths -= {row[0] for row in rows if len(row) == 1}
    own = lengths & {*sets[0]} if sets else set()  # of two lengths neither is the one that v and a belong to
    single = {q for s in sets for q in s if len(s) == 1 and q in lengths and (q not in own or len(own) == 1)}
    alone = single or (lengths if len(lengths) == 1 else set())
    return alone.pop() if len(alone) == 1 else None


def _is_acceleration(texts: Sequence[str], scope: Scope) -> bool:
    """Whether `a` is an acceleration: in `m a = ...` or `a = g/2`, unless it is defined otherwise."""
    if scope.role("a") is not Role.UNDECLARED:
        return False
    if any(_A_STATED.search(text) and not _has_foreign_rate(text, scope) for text in texts):
        return False
    return any(_MASS_TIMES_A.search(text) or _A_IS.match(text) for text in texts)


def _has_foreign_rate(text: str, scope: Scope) -> bool:
    """Whether a line is about an acceleration that is none of the problem's: `a = R φ''`, where φ is not declared."""
    names = {GREEK.get(n, n) for n in _TWICE_DERIVED.findall(text)}
    return bool(names) and all(scope.role(scope.spelling(n)) is Role.UNDECLARED for n in names)


def _is_speed(texts: Sequence[str], scope: Scope, reference: Reference) -> bool:
    """Whether `v` is a speed: dv/dt occurs, and it is not defined otherwise."""
    known = scope.role("v") is not Role.UNDECLARED and "v" not in reference.parameters
    if known or _states_a_rate(re.compile("v"), texts):
        return False
    return any(_RATE_OF_V.search(text) for text in texts) and not any(_V_IS.search(text) for text in texts)


def _is_squared_speed(texts: Sequence[str], scope: Scope) -> bool:
    """Whether `v` occurs as v², in an energy or in m v²/R, and is not defined otherwise."""
    if scope.role("v") is not Role.UNDECLARED or any(_V_IS.search(text) for text in texts):
        return False
    return any(_V_SQUARED.search(text) for text in texts)


def _only_speed(reference: Reference) -> sp.Expr | None:
    """The speed of the only mass that moves, if it is a particle.

    With an initial state v may be the speed at one place.
    """
    if not reference.candidates or reference.candidates[0].starts is not None:
        return None
    configuration = reference.candidates[0].configuration
    moving = [p for p in configuration.points if p.mass != 0]
    if len(moving) != 1 or configuration.rotations:
        return None
    return sp.sqrt(sp.Add(*(sp.expand(c**2) for c in moving[0].velocity.components)))


def _speed_along_path(reference: Reference) -> sp.Expr | None:
    """The speed of the only mass that moves, a particle on a path, in the sense of its only coordinate: l θ'."""
    for c in reference.candidates:
        slots, points = c.configuration.slots, [p for p in c.configuration.points if p.mass != 0]
        if len(slots.coordinates) != 1 or len(points) != 1 or c.configuration.rotations:
            continue
        rate = slots.velocities[0]
        squared = sp.expand(sp.Add(*(e**2 for e in points[0].velocity.components)))
        per_rate = textbook_form(sp.cancel(squared / rate**2))
        if not per_rate.has(rate) and not per_rate.has(t):
            return sp.sqrt(per_rate) * rate
    return None


def rates_without_bar(texts: Sequence[str], scope: Scope) -> frozenset[str]:
    """The coordinates x of which `ddx` occurs, so that `dx` is a rate and no differential."""
    whole = "\n".join(texts)
    if "δ" in whole or "dd" not in whole:
        return frozenset()
    return frozenset(
        q.name
        for q in scope.slots.coordinates
        if re.search(rf"(?<![A-Za-z0-9_])dd{q}(?![A-Za-z0-9_/])", whole) and scope.role(f"dd{q}") is Role.UNDECLARED
    )


def without_arguments(fragment: Fragment, scope: Scope) -> Fragment:
    """`T(θ) = ...` as T = ..., without the arguments after a name alone on the left; `x1` as x_1."""
    fragment = _without_modulus(with_indices(fragment, scope), scope)
    match = _OF_COORDINATE.match(fragment.text)
    if match is None or scope.role(_plain(match["name"])) is not Role.SCALAR:
        return fragment
    argument = scope.scalar(scope.spelling(_plain(match["argument"])))
    if argument is None or not (argument == t or argument in scope.slots.coordinates):
        return fragment
    draft = Draft(fragment)
    draft.apply([(match.end("name"), match.end("bracket"), "")])
    return draft.finished(latex=is_latex(fragment))


def _without_modulus(fragment: Fragment, scope: Scope) -> Fragment:
    """`|F| = ...` as F = ... with undetermined sign: the name of a force may denote its opposite."""
    match = _MODULUS.match(fragment.text)
    symbol = scope.scalar(scope.spelling(_plain(match["name"]))) if match is not None else None
    if match is None or symbol is None or symbol in scope.slots.coordinates or not isinstance(symbol, sp.Symbol):
        return fragment
    draft = Draft(fragment)
    draft.apply([(0, match.end("bars"), match["name"])])
    return draft.finished(latex=is_latex(fragment))


def as_virtual(fragment: Fragment, scope: Scope) -> Fragment:
    """`dy/dθ = 0` in statics as δy = 0: a total derivative, where other coordinates depend on θ."""
    match = _STATIONARY.match(fragment.text)
    if match is None:
        return fragment
    name, by = _plain(match["name"] or match["name2"]), _plain(match["by"] or match["by2"])
    if scope.scalar(scope.spelling(by)) not in scope.slots.coordinates or scope.scalar(scope.spelling(name)) is None:
        return fragment
    draft = Draft(fragment)
    draft.apply([(0, len(fragment.text), f"δ{name} = 0")])
    return draft.finished()


def is_rate_along(fragment: Fragment, scope: Scope) -> bool:
    """Whether a line of statics is `dy/dθ = ...`, a total derivative by a coordinate, in its working."""
    match = _RATE_ALONG.match(fragment.text)
    if match is None:
        return False
    name, by = _plain(match["name"] or match["name2"]), _plain(match["by"] or match["by2"])
    coordinates = {q.name for q in scope.slots.coordinates}
    return scope.spelling(by) in coordinates and scope.spelling(name) not in coordinates


def _plain(name: str) -> str:
    return "".join(GREEK.get(c, c) for c in name.lstrip("\\").replace("{", "").replace("}", ""))


def _defined(name: str, texts: Sequence[str]) -> bool:
    """Whether a line of the answer defines a name."""
    return any(re.match(rf"\s*{re.escape(name)}\s*:?=(?!=)", text) for text in texts)


def has_word(word: str, text: str) -> bool:
    """Whether a name occurs in a text as a whole word; a number may precede it."""
    return re.search(rf"(?<![A-Za-z_\\]){re.escape(word)}(?![A-Za-z0-9_{{])", text) is not None


def _states_a_rate(written: re.Pattern[str], texts: Sequence[str]) -> bool:
    """Whether a line defines a name, as in `a_x = x''`."""
    for text in texts:
        sides = text.split("=")
        for side, other in ((sides[0], sides[-1]), (sides[-1], sides[0])):
            if len(sides) == 2 and written.fullmatch(side.strip(" $&")) and _RATE_SIGN.search(other):
                return True
    return False


_VECTOR_R = re.compile(r"\\(?:vec|mathbf|boldsymbol|bm)\s*(?:\{\s*r\s*\}|\s*r(?![A-Za-z]))(?!\s*_)")
"""The position of the only particle: `\\vec r`."""


def _of_states(number: int, named: Collection[sp.Expr], reference: Reference) -> dict[str, sp.Expr]:
    """The coordinates of a set that has so many, or so many without a name, those of a choice first."""
    sets = [c.configuration.slots.coordinates for c in reference.candidates]
    sets = [*sets[1:], *sets[:1]]
    others = [[q for q in c if q not in named] for c in sets]
    fitting = [c for c in [*sets, *others] if len(c) == number]
    return {f"state_{n}": q for n, q in enumerate(fitting[0], 1)} if fitting else {}


def _positions(whole: str, scope: Scope) -> dict[str, Vector]:
    numbers = {int(m[1]) for m in _PLACE.finditer(whole)}
    places = [name for name in scope.vectors if name.startswith("r_")]
    if len(places) == 1 and _VECTOR_R.search(whole) and scope.role("r") is Role.UNDECLARED:
        return {"r": scope.vectors[places[0]]}
    if not numbers or len(places) < 2 or max(numbers) > len(places):
        return {}
    positions = {}
    for n in numbers:
        for name in (f"r_{n}", f"r{n}"):
            if scope.role(name) is Role.UNDECLARED:
                positions[name] = scope.vectors[places[n - 1]]
    return positions


# Printed names


_OF_ENERGY = re.compile(
    r"(?<![A-Za-z_])(?:[LEH]|\\mathcal\s*\{?L\}?)\s*:?={1,2}\s*T|(?<![A-Za-z_])T\s*[-+−–]\s*[VU](?![A-Za-z_])"
    r"|(?<![A-Za-z_])[VU]\s*:?={1,2}(?!=)|kinetic|energ|period|Periode|Schwingungsdauer",
)


def printed_names(reference: Reference, texts: Sequence[str] = (), words: str = "") -> dict[str, sp.Symbol]:
    """The short names of reactions that have no other meaning in the problem, and an answer's own name for one.

    texts  the equations of the answer
    words  everything that it says
    """
    if reference.newton is None:
        return {}
    known = {*reference.declared, *reference.letters, *reference.scope.scalars, *reference.scope.vectors}
    known |= {*reference.scope.functions, *reference.coordinates}
    short_names = {short: symbol for symbol, short in short_reactions(reference.newton, known)}
    return short_names | _of_normal_force(texts, words, reference) | _of_tension(texts, reference)


def _of_tension(texts: Sequence[str], reference: Reference) -> dict[str, sp.Symbol]:
    """`S = m*g*cos(theta) + ...` and `F_T = ...` as the force of the only rod or string; empty if there are several."""
    known = {*reference.declared, *reference.scope.scalars}
    meant = {re.sub(r"[{}]", "", m[1]) for text in texts if (m := TENSION.match(text))} - known
    reactions = reference.newton.reactions if reference.newton is not None else ()
    if len(meant) != 1 or len(reactions) != 1 or reactions[0].single is None:
        return {}
    rod = reactions[0]
    is_tension = rod.single is not None and rod.single.kind is ForceKind.TENSION
    return {meant.pop(): rod.force if rod.named else rod.symbol_of_force} if is_tension else {}


TENSION = re.compile(r"[\s$&]*((?:S|Z|F_?\{?[STZ]\}?|F_\{?(?:rod|tension|Seil|Stab|Faden)\}?))\s*&?=(?!=)")


def _of_normal_force(texts: Sequence[str], words: str, reference: Reference) -> dict[str, sp.Symbol]:
    """`N_A` of `N_A = ...`, which is not declared, as the force of the only contact; empty if there are several.

    It is another force, R = mu*N, where the contact's own name occurs as well, or where it is called friction.
    """
    known = {*reference.declared, *reference.scope.scalars}
    meant = {re.sub(r"[{}]", "", m[1]) for text in texts if (m := _NORMAL.match(text))} - known
    if len(meant) != 1 or reference.newton is None:
        return {}
    normal = [r for r in reference.newton.reactions if r.single is not None and r.single.kind is ForceKind.ALONG]
    symbol = (normal[0].force if normal[0].named else normal[0].symbol_of_force) if len(normal) == 1 else None
    if symbol is None or lines_with(symbol.name, texts):
        return {}
    name = meant.pop()
    called_friction = re.search(
        rf"(?:{_FRICTION})[^=\n]{{0,40}}(?<![A-Za-z]){re.escape(name)}\s*[=:,(]", words, re.IGNORECASE
    )
    return {} if called_friction else {name: symbol}


_FRICTION = "fri[ck]tion|reib|frottement|rozamiento|attrito"
_NORMAL = re.compile(r"[\s$&]*((?:N|F_N|R)(?:_\{?[A-Za-z0-9]{1,2}\}?)?)\s*&?=(?!=)")


def lines_with(name: str, lines: Sequence[str]) -> list[int]:
    """The lines in which a name occurs as a whole word."""
    letters = [re.escape(c) for c, n in GREEK.items() if n == name] + [rf"\\{re.escape(name)}"] * (len(name) > 1)
    written = "|".join([rf"(?<![A-Za-z0-9_\\]){re.escape(name)}", *letters])
    pattern = re.compile(rf"(?:{written})(?![A-Za-z0-9_'(])")
    return [n for n, line in enumerate(lines) if pattern.search(line)]


def may_be_force(name: str, value: sp.Expr | None, texts: Sequence[str], reference: Reference) -> bool:
    """Whether a name stated to equal `value`, alone on its side, may be the reaction and not an energy or a period."""
    if TENSION.match(f"{name} ="):
        return value is not None and _is_force(value, reference.units) is True
    if name != "T":
        return True
    if any(_OF_ENERGY.search(text) for text in texts):
        return False
    if value is None:
        return True
    velocities = [v for v in reference.scope.slots.velocities if v in value.free_symbols]
    scale = sp.Symbol("scale", positive=True)
    if velocities and sp.expand(value.xreplace({v: scale * v for v in velocities}) - scale**2 * value) == 0:
        return _is_force(value, reference.units) is True
    if not value.free_symbols & {*velocities, *reference.scope.slots.coordinates}:
        return _is_force(value, reference.units) is True
    return _is_force(value, reference.units) is not False


def _is_force(value: sp.Expr, units: Mapping[sp.Symbol, str]) -> bool | None:
    """Whether an expression has the dimension of a force; None if that is not known."""
    known = dimensions_of_units(units)
    angles = {q for w in value.atoms(sp.sin, sp.cos, sp.tan) for q in w.args[0].free_symbols if q not in known}
    stated = dimension(value, known | dict.fromkeys(angles, NO_DIMENSION))
    return None if stated is None else stated == dimension_of_unit("N")


_EXTREME_INDEX = re.compile(r"_\s*(?:\{\s*)?(?:\\(?:text|mathrm)\s*\{\s*)?\\?(max|min)(?![A-Za-z])(?:\s*\})*")


def spelled_out(text: str) -> str:
    """θ₁ as theta_1, and P_{\\max} as P_max, \\theta_{3} as \\theta_3."""
    text = re.sub(r"_\{(\w{1,3})\}", r"_\1", _EXTREME_INDEX.sub(r"_\1", text))
    text = re.sub(f"[{''.join(SUBSCRIPTS)}]+", lambda m: "_" + "".join(SUBSCRIPTS[c] for c in m[0]), text)
    return "".join(f" {GREEK[c]}" if c in GREEK else c for c in text)


# Vector names


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


# New coordinates


def defined_coordinate(fragment: Fragment, name: str, scope: Scope) -> sp.Expr | None:
    """A name as a new coordinate, from the equation that defines it; None if the equation does not."""
    slots = scope.slots
    own = sp.Symbol(name, real=True)
    reading = read_as_written(fragment, replace(scope, slots=replace(slots, coordinates=(*slots.coordinates, own))))
    if reading.error is not None or len(reading.sides) != 2:
        return None
    left, right = reading.sides
    if isinstance(left, Vector) or isinstance(right, Vector):
        return None
    for known, other in ((left, right), (right, left)):
        order = _order(known, slots)
        rates = [n for n in range(3) if prime(own, n) in other.free_symbols]
        if (
            order is None
            or not rates
            or count_operations(other) > LONGEST_NEW_COORDINATE
            or count_operations(known) > LONGEST_NEW_COORDINATE
        ):
            continue
        if rates == [order]:
            return _integrated(known, other, prime(own, order), order, scope)
        if rates == [0] and order == 1:
            return _solved(known, other, own)
    return None


def solved_for(fragment: Fragment, name: str, scope: Scope) -> sp.Expr | None:
    """A name solved from `2 δ = b/m` or `m ω_0^2 = k`, where one side is a multiple of it or of its square."""
    own = sp.Symbol(name, positive=True)
    reading = read_as_written(fragment, replace(scope, scalars={**scope.scalars, name: own}))
    if reading.error is not None or len(reading.sides) != 2:
        return None
    left, right = reading.sides
    if isinstance(left, Vector) or isinstance(right, Vector) or moves(left, scope) or moves(right, scope):
        return None
    for side, other in ((left, right), (right, left)):
        factor, power = side.as_independent(own)
        if own not in other.free_symbols and power in (own, own**2) and factor != 0:
            value = other / factor
            return value if power == own else sp.sqrt(value)
    return None


def moves(e: sp.Expr, scope: Scope) -> bool:
    """Whether an expression has a coordinate, a rate, or the time in it."""
    return any(base(s) in scope.slots.coordinates or s == t for s in e.free_symbols)


def _order(side: sp.Expr, slots: Slots) -> int | None:
    """0 for a coordinate alone, 1 or 2 for an expression linear in velocities alone, or in accelerations alone."""
    if side in slots.coordinates:
        return 0
    rates = {s for s in side.free_symbols if base(s) != s}
    orders = {len(s.name) - len(base(s).name) for s in rates}
    linear = all(sp.diff(side, s).free_symbols.isdisjoint(rates) for s in rates)
    return orders.pop() if len(orders) == 1 and linear and orders <= {1, 2} else None


def _solved(known: sp.Expr, other: sp.Expr, unknown: sp.Symbol) -> sp.Expr | None:
    """The unknown from an equation that is linear in it."""
    slope = sp.diff(other, unknown)
    if unknown in slope.free_symbols or slope == 0:
        return None
    return (known - other.xreplace({unknown: sp.S.Zero})) / slope


def _integrated(known: sp.Expr, other: sp.Expr, unknown: sp.Symbol, order: int, scope: Scope) -> sp.Expr | None:
    """The coordinate from its rate, where that is a sum of rates of this order with constant coefficients."""
    value = _solved(known, other, unknown)
    if value is None or order == 0:
        return value
    slots = scope.slots
    rates = {prime(q, order): q for q in (*slots.coordinates, *slots.prescribed)}
    moving = {t, *slots.coordinates, *slots.prescribed, *slots.velocities, *slots.accelerations}
    value = sp.expand(value)
    for term in sp.Add.make_args(value):
        coefficient, rate = term.as_independent(*rates, as_Add=False)
        if rate not in rates or coefficient.free_symbols & moving:
            return None
    return value.xreplace(rates)
