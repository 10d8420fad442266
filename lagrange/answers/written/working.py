"""The working around the equations of an answer: definitions, values, initial conditions, approximations, energies.

A whole solution has lines that are not the equations asked for. A name that the problem does not declare is defined by
an equation in which it stands alone on one side; from there on it means that, and the definition is not judged. The
letters that a derivation adds (L, T, V, omega) may be defined anew in the same way. Values of parameters and initial
conditions are not judged either. Whatever is not judged is named in a note. All other equations are: one that is
marked as an approximation counts only if it follows. A name that is neither declared nor defined, but occurs in two
equations or more, may be an unknown force; it is eliminated.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import field, replace

import sympy as sp

from lagrange.answers.limits import LONGEST_LAW, LONGEST_WRITTEN_NAME, MAX_LINES
from lagrange.answers.readings import GivenEquation, Reading, decimals_in, has_decimals
from lagrange.answers.references import Reference
from lagrange.answers.written.cases import about_special_cases
from lagrange.answers.written.marked_names import with_indices_of_greek, with_primed_names
from lagrange.answers.written.names import (
    AT_EQUILIBRIUM,
    as_virtual,
    coordinates_at_rest,
    defined_coordinate,
    is_rate_along,
    lines_with,
    may_be_force,
    other_names,
    printed_names,
    rates_without_bar,
    solved_for,
    spelled_out,
    with_names_of_vectors,
    without_arguments,
)
from lagrange.answers.written.notation.matrices import has_matrix, with_named_matrices
from lagrange.answers.written.notation.plain import is_rate
from lagrange.answers.written.one_line import (
    Line,
    each_equation_of_motion,
    finished,
    in_place_of,
    is_condition,
    is_integral,
    lines_of,
    with_definitions_in_alternatives,
    with_integrals,
    without_prose,
    words_known,
)
from lagrange.answers.written.reading import is_name, quotes_the_method, read_as_written, tried, undeclared
from lagrange.answers.written.values import NUMBER, is_unit, marks_approximation, value_of, with_value_in_si
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError, Severity
from lagrange.core.records import record
from lagrange.core.vectors import Vector
from lagrange.expressions.characters import GREEK
from lagrange.expressions.edits import Draft, cuts
from lagrange.expressions.latex_layout import OneEquation, is_latex
from lagrange.expressions.meaning import DIFFERENTIALS
from lagrange.expressions.reader import read_value, token_texts
from lagrange.expressions.scope import RESERVED, Scope
from lagrange.expressions.syntax_tree import Role

_EQUALS = re.compile(r"(?<![<>!=:])==?(?![=>])")
_AT_ZERO = re.compile(
    r"[^=+/]{1,40}(?:\(\s*(?:t\s*=\s*)?(?:0|t_?\{?0\}?)\s*\)|\[\s*0\s*\]|\|_\{?\s*t\s*=\s*0\s*\}?|_\{t=0\})\s*\Z"
)
_TIME = re.compile(r"\s*\$?\s*t(?:_\{?[0-9a-z]{1,3}\}?)?\s*\Z")
_WORDS = re.compile(r"[^\W\d]+")
_INDEX = re.compile(r"[_^]\{[^{}]*\}")
_DOTS = re.compile(r"d{1,3}ot\Z")
"""`ddot(theta)` is a derivative, and no function of theta that an answer defines."""
_NO_NAME = re.compile(r"[-+*/=−·'\u0307\u0308]|^\s*[0-9]|\\(?:[dt]?frac|d?dot|cdot|sqrt|partial|times)(?![A-Za-z])")
"""What does not occur in a side that is a name alone: a quick test before the side is read."""
_NUMBERED = re.compile(r"\A([A-Za-z]+)([0-9])\Z")
_OF_TIME = re.compile(r"[\s$]*([A-Za-z]\w{0,12})\s*\(\s*t\s*\)\s*&?=(?!=)")
"""A function of the time that the answer defines: `m(t) = m_0 - q t`."""
_RATE_OF = re.compile(
    r"(?<![A-Za-z])d\s?([A-Za-z]{1,3})\s*(?:/|\}\s*\{)\s*d\s?[A-Za-z]|\\dot\s*\{?\s*([A-Za-z])(?![A-Za-z])"
)
"""The rate of a letter: `dv/dt`, `\\frac{dv}{dx}`, `\\dot v`."""
_ARITHMETIC = re.compile(r"[\d\s+\-−*/·×().=]+")
_RATE_ALONE = re.compile(r"\s*d([A-Za-z][A-Za-z0-9_]{0,20})\s*=(?!=)")
_DIFFERENTIAL = re.compile(r"(?<![A-Za-z0-9_])[dδ](?:[A-Za-z]|θ|φ)|/\s*d")
_UNDOING: dict[str, Callable[[sp.Expr], sp.Expr]] = {
    "": lambda e: e,
    "^2": sp.sqrt,
    "sin": sp.asin,
    "cos": sp.acos,
    "tan": sp.atan,
}
"""What a name is if what is applied to it is known."""


@record
class Working:
    """An answer, sorted.

    judged       the equations that are compared
    approximate  which of them are marked as approximations
    unreadable   those that could not be read, with their readings
    written      both together, in the order in which they were written
    notes        what is not judged, and why
    unknowns     undeclared names that are eliminated as unknown forces
    defined      the names that the answer defines, with their meanings
    quoting      whether it quotes the method, d/dt(∂L/∂q') − ∂L/∂q = 0
    """

    judged: tuple[Fragment, ...]
    approximate: frozenset[int] = frozenset()
    unreadable: tuple[GivenEquation, ...] = ()
    written: tuple[Fragment, ...] = ()
    notes: tuple[Diagnostic, ...] = ()
    unknowns: tuple[sp.Symbol, ...] = ()
    defined: Mapping[str, sp.Expr] = field(default_factory=dict)
    quoting: bool = False


def understood(
    answer: Sequence[Fragment],
    reference: Reference,
    *,
    eliminating: bool = True,
    moving: bool = True,
    naming: bool = False,
) -> Working:
    """The answer sorted into what is judged and what is not.

    eliminating  with undeclared names as unknown forces
    naming       with the reactions' short names in several lines, too, where they otherwise are unknown forces
    moving       whether it is about motion; in statics a parameter may be stated to have a particular value

    Raises ProblemError if it has too many lines.
    """
    if len(answer) > MAX_LINES:
        message = f"an answer may have at most {MAX_LINES} lines with equations; this one has {len(answer)}"
        help_ = "leave the working out, and hand in the equations asked for"
        raise ProblemError(Diagnostic("too-many-equations", message, answer[MAX_LINES].whole, help=help_))
    sorting = _Sorting(reference, moving, naming)
    answer = with_indices_of_greek(with_primed_names(answer, reference.parameters), sorting.scope)
    answer = with_integrals(answer, sorted(reference.coordinates))
    answer = with_definitions_in_alternatives(answer, sorting.declared)
    if moving:
        answer = [part for f in answer for part in each_equation_of_motion(f)]
    if any(has_matrix(f.text) for f in answer):
        sets = [[q.name for q in c.configuration.slots.coordinates] for c in reference.candidates]
        texts = with_named_matrices([f.text for f in answer], sets)
        answer = [
            f if text == f.text else in_place_of(f, text)
            for f, text in zip(answer, texts, strict=True)
            if text is not None
        ]
    else:
        answer = with_names_of_vectors(answer, sorting.scope)
    return sorting.sorted([line for f in answer for line in lines_of(f, sorting.declared)], eliminating)


class _Sorting:
    """One answer on its way through; `scope` grows with the definitions."""

    def __init__(self, reference: Reference, values_are_asides: bool, naming: bool) -> None:
        self.reference = reference
        self.naming = naming
        self.values_are_asides = values_are_asides
        self.scope = reference.scope_of_answers
        self.declared = reference.declared
        self.notes: list[Diagnostic] = []
        self.defined: list[str] = []
        self.unknowns: list[sp.Symbol] = []
        self.rounded: dict[str, sp.Expr] = {}  # definitions with symbols for their decimals
        self.texts: list[str] = []
        # what was read of a side, and with which names; and the same of a side that may be a name alone
        self.sides: dict[str, tuple[Scope, sp.Expr | Vector | None]] = {}
        self.names: dict[str, tuple[Scope, tuple[str, str]]] = {}
        self.given: list[Line] = []  # the values of parameters that the problem leaves open
        self.moving: set[str] = set()  # parameters whose letters the answer uses for what changes in time

    def sorted(self, lines: list[Line], eliminating: bool) -> Working:
        waiting = [line for line in lines if line.whole or not self._is_aside(line)]
        plain = [line for line in waiting if not line.whole and line.reading is None]
        self._use_plain_names(plain)
        self._find_definitions(plain)
        for line in waiting:
            if not line.definition:
                self._read(line)
        if eliminating:
            self._find_unknowns([line for line in waiting if not line.definition])
        waiting = [line for line in waiting if line.reading and not line.definition]
        quotes = self._not_judged(waiting)
        waiting = _without(waiting, quotes)
        for line in waiting:
            self._note_number(line)
        judged = [line for line in waiting if line.reading and not line.reading.error]
        given = {id(line): _given(line) for line in waiting}
        return Working(
            tuple(given[id(line)] for line in judged),
            frozenset(n for n, line in enumerate(judged) if marks_approximation(getattr(line.fragment, "beside", ""))),
            tuple(f for f in given.values() if isinstance(f, GivenEquation) and f.reading.error is not None),
            tuple(given.values()),
            tuple(self.notes),
            tuple(self.unknowns),
            {n: self.scope.scalars[n] for n in self.defined if n in self.scope.scalars},
            len(quotes) > 0,
        )

    def _use_plain_names(self, lines: list[Line]) -> None:
        for line in lines:
            line.fragment = without_arguments(line.fragment, self.scope)
        self._use_other_names(lines)
        self.texts = [spelled_out(line.fragment.text) for line in lines]
        self._without_time(lines)
        self._write_rates(lines)
        self._use_printed_names(lines)
        self.moving = {m[k] for line in lines for m in _RATE_OF.finditer(line.text) for k in (1, 2) if m[k]}
        self.moving &= {*self.reference.parameters}
        self._leave_prose_out(lines)

    def _find_definitions(self, lines: list[Line]) -> None:
        """Those of kinematics first; what one line defines may stand in the definition of another."""
        for kinematic in (True, False, False, False):
            before = len(self.defined)
            for line in lines:
                line.definition = line.definition or self._defines(line, kinematic)
            if kinematic:
                continue
            if len(self.defined) == before:
                for line in lines:
                    line.definition = line.definition or self._defines_coordinate(line)
            if len(self.defined) == before or all(line.definition for line in lines):
                break

    def _read(self, line: Line) -> None:
        if line.whole:
            line.reading = Reading(line.text)
        if line.reading is not None:
            return
        if not self.values_are_asides:
            line.fragment = as_virtual(line.fragment, self.scope)
            if is_rate_along(line.fragment, self.scope):
                self._note(line, f"`{line.text}` is a derivative along the constraints, and is not judged")
                return
        try:
            written = line.fragment
            line.fragment = with_value_in_si(written, self.reference)
            line.reading = read_as_written(line.fragment, self.scope, line.text, self.rounded)
            if line.fragment is not written:  # `T = 2 N` may also be twice the reaction N
                product = read_as_written(written, self.scope, line.text, self.rounded)
                line.reading = replace(line.reading, other=None if product.error else product)
        except ProblemError as error:
            line.reading = Reading(line.text, error=error)

    def _not_judged(self, lines: list[Line]) -> list[Line]:
        """The method quoted, general laws, integrals, special cases, and conditions beside equations."""
        quoted = [x for x in lines if quotes_the_method(x.reading, x.text, self.scope)]
        quotes = self._noted(quoted, "quotes the method")
        quotes += self._noted([x for x in lines if self._is_general_law(x)], "is taken as a general law")
        integrals = [x for x in lines if x.reading and x.reading.error and is_integral(x.text)]
        quotes += self._noted(integrals, "is an integral")
        counts = [x for x in lines if _ARITHMETIC.fullmatch(x.text) and x.reading and x.reading.components == (0,)]
        quotes += self._noted(counts, "is arithmetic") if len(counts) < len(lines) else []
        quotes += self._about_special_cases(_without(lines, quotes))
        conditions = [x for x in lines if is_condition(getattr(x.fragment, "beside", ""), x.text)]
        if len(conditions) < len(lines):
            quotes += self._noted(conditions, "is taken as a condition")
        return quotes

    def _use_other_names(self, lines: list[Line]) -> None:
        """Take th for theta, a_x for x'', r_1 for the position of the first particle."""
        scalars, vectors = other_names([line.text for line in lines], self.scope, self.reference)
        if not self.values_are_asides:
            scalars = {**scalars, **coordinates_at_rest([line.text for line in lines], self.scope)}
        if not scalars and not vectors:
            return
        self.scope = replace(
            self.scope, scalars={**self.scope.scalars, **scalars}, vectors={**self.scope.vectors, **vectors}
        )
        self.declared |= {*scalars, *vectors}
        for name, meaning in scalars.items():
            message = f"`{name}` is taken as `{meaning}`"
            self.notes.append(Diagnostic("read-as", message, lines[0].fragment.whole, level=Severity.NOTE))

    def _without_time(self, lines: list[Line]) -> None:
        """`u(t)` as u, for a speed u and for what the answer defines as u(t) = ..., just as x(t) is x."""
        velocities = {*self.scope.slots.velocities}
        speeds = [n for n, v in self.scope.scalars.items() if not velocities.isdisjoint(v.free_symbols)]
        defined = {m[1] for line in lines if (m := _OF_TIME.match(line.fragment.text))}
        speeds += sorted(n for n in defined if self.scope.role(n) is Role.UNDECLARED)
        if not speeds:
            return
        letters = [*speeds, *(c for c, n in GREEK.items() if n in speeds)]
        pattern = re.compile(rf"(?<![A-Za-z0-9_\\])({'|'.join(map(re.escape, letters))})\s*\(\s*t\s*\)")
        for line in lines:
            draft = Draft(line.fragment)
            if "\\" not in draft.text and draft.replace(pattern, r"\1"):
                line.fragment = finished(draft, line.fragment, False)

    def _write_rates(self, lines: list[Line]) -> None:
        """`dtheta = omega; domega = ...` of a program as rates, where one of them is of a coordinate."""
        names: dict[str, Line | None] = {}
        for line in lines:
            match = _RATE_ALONE.match(line.fragment.text)
            if (
                match is not None
                and match[0].strip(" =") not in self.declared
                and not _DIFFERENTIAL.search(line.fragment.text, match.end())
            ):
                names[match[1]] = line
        if names.keys().isdisjoint({q.name for q in self.scope.slots.coordinates}):
            names = dict.fromkeys(rates_without_bar([line.text for line in lines], self.scope))
        if not names:
            return
        pattern = re.compile(rf"(?<![A-Za-z0-9_'/])(?<!/ )d({'|'.join(map(re.escape, names))})(?![A-Za-z0-9_'(])")
        for line in lines:
            draft = Draft(line.fragment)
            if "\\" not in draft.text and draft.replace(pattern, r"\1'"):
                line.fragment = finished(draft, line.fragment, False)

    def _use_printed_names(self, lines: list[Line]) -> None:
        """Take T for the tension T_rod, as on a page, where it occurs in one equation and is no energy."""
        texts = [f"{getattr(line.fragment, 'beside', '')} {line.fragment.text}" for line in lines]
        stated = [line.fragment.text for line in lines]
        for name, symbol in printed_names(self.reference, stated, "\n".join(texts)).items():
            renamed = lines_with(name, stated)
            if len(renamed) != 1 and not (self.naming and renamed):
                continue
            line = lines[renamed[0]]
            alone, value = False, None
            for side, other in (sides, sides[::-1]) if (sides := _sides(line.fragment)) else ():
                if self._name_alone(side)[0] == name:
                    alone = True
                    value = self._value_of(other)
            if isinstance(value, Vector) or (symbol.name.startswith("lambda") and not alone and not self.naming):
                continue
            if may_be_force(name, value, texts, self.reference):
                self.scope = replace(self.scope, scalars={**self.scope.scalars, name: symbol})
                self.declared |= {name}
                self._note(line, f"`{name}` is taken as `{symbol.name}`", code="read-as")

    def _is_general_law(self, line: Line) -> bool:
        """Whether an unreadable line has several undeclared names and no coordinate: F = m a, L = T − V."""
        if len(set(undeclared(line.reading, line.text))) < 2 or len(line.text) > LONGEST_LAW:
            return False
        names = {n.strip("_") for n in _WORDS.findall(line.text)} | {GREEK[c] for c in line.text if c in GREEK}
        return names.isdisjoint(self.reference.coordinates)

    def _about_special_cases(self, lines: list[Line]) -> list[Line]:
        """The lines about a special case, each with a note; none if there are no other lines."""
        for line in self.given:
            self._read(line)
        everything = sorted([*self.given, *lines], key=lambda x: x.fragment.span(0, 0).start)
        read = [(x.fragment, x.reading or Reading("")) for x in everything]
        cases, special = about_special_cases(read, self.reference, at_rest=not self.values_are_asides)
        found = [(everything[n], n in cases) for n in sorted(cases | special) if everything[n] not in self.given]
        found = found if len(found) < len(lines) else []
        for line, states in found:
            self._note(line, f"`{line.text}` {'states' if states else 'is about'} a special case, and is not judged")
        return [line for line, _ in found]

    def _note_definition(self, line: Line, name: str) -> None:
        used = len(lines_with(name, self.texts)) > 1 or line.text.count("=") > 1
        what = "which is used from here on and not judged" if used else "which no other line uses, and is not judged"
        self._note(line, f"`{line.text}` defines `{name}`, {what}")

    def _note(self, line: Line, message: str, code: str = "not-judged") -> None:
        span = line.fragment.span(0, len(line.fragment.text))
        self.notes.append(Diagnostic(code, message, span, level=Severity.NOTE))

    def _noted(self, lines: list[Line], what: str) -> list[Line]:
        for line in lines:
            self._note(line, f"`{line.text}` {what}, and is not judged")
        return lines

    def _note_number(self, line: Line) -> None:
        if line.number:
            self._note(line, f"`{line.number}` after the equation numbers it, and is no factor", code="read-as")

    # -- asides ----------------------------------------------------------------------------------------------

    def _is_aside(self, line: Line) -> bool:
        """Whether a line is an initial condition or a value, which is noted."""
        if line.reading is not None:
            return False
        sides = _sides(line.fragment)
        if sides is None:
            return False
        for side, other in (sides, sides[::-1]):
            if _AT_ZERO.match(_plain(side.text)) and "'" not in other.text and "dot" not in other.text:
                self._note(line, f"`{line.text}` is taken as an initial condition, and is not judged")
                return True
            if _TIME.match(side.text):
                self._note(line, f"`{line.text}` states a time, and is not judged")
                return True
            name = self._name_alone(side)[0]
            match = NUMBER.match(other.text.strip()) if name in self.reference.parameters else None
            if match and is_unit(match["unit"], self.declared, self.values_are_asides):
                self._note_value(line, name, match)
                return True
        return False

    def _note_value(self, line: Line, name: str, number: re.Match[str]) -> None:
        known = self.reference.values.get(self.reference.parameters[name])
        stated = value_of(number)
        if known is None or number["unit"].strip(" .,;$") or abs(stated - known) <= abs(known) / 50:
            self._note(line, f"`{line.text}` is taken as a value, and is not judged")
            self.given += [line] if known is None else []
        else:
            self._note(line, f"`{line.text}` contradicts the problem, in which `{name}` is {known}")

    # -- definitions and equations ---------------------------------------------------------------------------

    def _name_alone(self, side: Fragment) -> tuple[str, str]:
        """The name that alone makes up one side, and what is applied to it: `^2`, `sin`; empty if there is none."""
        if len(side.text.strip()) > LONGEST_WRITTEN_NAME or _NO_NAME.search(_INDEX.sub("", side.text)):
            return "", ""
        known = self.names.get(side.text)
        if known is None or known[0] is not self.scope:
            known = self.names[side.text] = self.scope, self._name_in(side)
        return known[1]

    def _name_in(self, side: Fragment) -> tuple[str, str]:
        try:
            texts = tried(side, self.scope, lambda f: token_texts(f, self.scope))
        except ProblemError:
            return "", ""
        texts = [w for w in texts if w not in ("|",)]
        if any(is_rate(w, self.scope) for w in texts):
            return "", ""
        match texts:
            case [name] if is_name(name):
                return name, ""
            case [name, "^", "2"] if is_name(name):
                return name, "^2"
            case [("sin" | "cos" | "tan") as function, "(", name, ")"] if is_name(name):
                return name, function
            case [name, "(", argument, ")"] if is_name(name) and argument in ("t", *self.reference.coordinates):
                return ("", "") if name in DIFFERENTIALS or name in RESERVED or _DOTS.match(name) else (name, "")
            case [("sin" | "cos" | "tan") as function, name] if is_name(name):
                return name, function
        return "", ""

    def _defines(self, line: Line, kinematic: bool) -> bool:
        """Whether an equation defines a name that the problem does not declare; it is in scope from here on.

        kinematic  only of a velocity or an acceleration, v = x': of several equations with v, this one defines it
        """
        sides = _sides(line.fragment)
        if sides is None:
            return False
        for side, other in (sides, sides[::-1]):
            name, applied = self._name_alone(side)
            if not name or name in self.declared - self.moving or name in RESERVED or name in self.defined:
                continue
            if not self.values_are_asides and self._marks_a_coordinate(line, name):
                return False
            known = self.scope.scalar(name) is not None and name not in self.reference.letters
            if (known and applied not in ("", "^2")) or (value := self._value_of(other)) is None:
                continue
            if kinematic and (isinstance(value, Vector) or not self._is_rate_of(value)):
                continue
            if isinstance(value, Vector):
                self.scope = replace(self.scope, vectors={**self.scope.vectors, name: value})
            else:
                if name in self.declared and value.free_symbols.isdisjoint(self.scope.slots.velocities):
                    continue
                itself = sp.Symbol(name)
                if itself in value.free_symbols and self.scope.scalar(name) == itself:
                    continue
                undone = _UNDOING[applied]
                if self.rounded or has_decimals(other.text):
                    rounded = replace(self.scope, scalars={**self.scope.scalars, **self.rounded}, decimals=f"{name} ")
                    with_decimals = tried(other, rounded, lambda f, s=rounded: read_value(f, s, latex=True))  # type: ignore[misc]
                    if decimals_in([with_decimals]):
                        self.rounded[name] = undone(with_decimals)
                self.scope = replace(self.scope, scalars={**self.scope.scalars, name: undone(value)})
            self.defined.append(name)
            self._note_definition(line, name)
            return True
        return False

    def _value_of(self, side: Fragment) -> sp.Expr | Vector | None:
        """What one side means; None if it cannot be read. Each is asked for several times."""
        known = self.sides.get(side.text)
        if known is None or known[0] is not self.scope:
            try:
                value = tried(side, self.scope, lambda f: read_value(f, self.scope, latex=True))
            except ProblemError:
                value = None
            known = self.sides[side.text] = self.scope, value
        return known[1]

    def _is_rate_of(self, value: sp.Expr) -> bool:
        """Whether an expression is a velocity or an acceleration, linear in the velocities and accelerations."""
        slots = self.scope.slots
        rates = {*slots.velocities, *slots.accelerations} & value.free_symbols
        return bool(rates) and all(rates.isdisjoint(sp.diff(value, s).free_symbols) for s in rates)

    def _defines_coordinate(self, line: Line) -> bool:
        """Whether an equation with a coordinate defines one of the answer's own: s by r = l + s."""
        names = {*undeclared(read_as_written(line.fragment, self.scope, line.text), line.text)}
        if len(names) != 1 or not self.values_are_asides or not is_name(name := names.pop()):
            return False
        value = defined_coordinate(line.fragment, name, self.scope)
        if value is None and len(lines_with(name, self.texts)) > 1:
            value = solved_for(line.fragment, name, self.scope)
        if value is None:
            return False
        self.scope = replace(self.scope, scalars={**self.scope.scalars, name: value})
        self.defined.append(name)
        self._note_definition(line, name)
        return True

    def _leave_prose_out(self, lines: list[Line]) -> None:
        """Take the equations out of their sentences."""
        known = words_known(self.scope, [line.fragment.text for line in lines])
        for line in lines:
            kept = without_prose(line.fragment, known)
            if kept is not line.fragment:
                beside = getattr(line.fragment, "beside", "")
                words = f"{beside} {line.fragment.text[: line.fragment.text.find(kept.text)]}"
                line.fragment = replace(kept, beside=words) if isinstance(kept, OneEquation) else kept
                line.text = kept.text.strip()

    def _marks_a_coordinate(self, line: Line, name: str) -> bool:
        """Whether a name is that of a coordinate with an index for equilibrium, theta_0, and means the coordinate."""
        coordinate, _, index = _NUMBERED.sub(r"\1_\2", name).partition("_")
        asked = [*self.scope.slots.coordinates, *self.reference.unknowns]
        asked += self.reference.parameters.values() if index in ("min", "max") else ()
        symbol = next((q for q in asked if q.name == coordinate), None)
        if symbol is None or not (index in AT_EQUILIBRIUM or self._numbers_an_alternative(name, coordinate, index)):
            return False
        self.scope = replace(self.scope, scalars={**self.scope.scalars, name: symbol})
        self._note(line, f"`{name}` is taken as the value of `{coordinate}` at equilibrium", code="read-as")
        return True

    def _numbers_an_alternative(self, name: str, coordinate: str, index: str) -> bool:
        """Whether `theta_2` or `P_max` is one of several values, and no name of something else."""
        alone = len(lines_with(name, self.texts)) == 1
        return alone and (index in ("min", "max") or (index.isdigit() and not lines_with(coordinate, self.texts)))

    def _find_unknowns(self, lines: list[Line]) -> None:
        """Names that are neither declared nor defined, and occur in two equations or more: unknown forces."""
        occurring: dict[str, list[Line]] = {}
        for line in lines:
            for name in undeclared(line.reading, line.text):
                occurring.setdefault(name, []).append(line)
        several = (n for n, where in occurring.items() if len(where) > 1)
        names = [n for n in several if n not in (*RESERVED, *DIFFERENTIALS) and is_name(n)]
        if not names or len(names) > 6:
            return
        symbols = {n: sp.Symbol(n, real=True) for n in names}
        wider = replace(self.scope, scalars={**self.scope.scalars, **symbols})
        read = {
            id(line): read_as_written(line.fragment, wider, line.text)
            for line in lines
            if line.reading and line.reading.error and set(undeclared(line.reading, line.text)) & set(names)
        }
        readings = [r for r in read.values() if not r.error]
        for symbol in symbols.values():
            used = [r for r in readings if any(symbol in c.free_symbols for c in r.components)]
            linear = all(symbol not in sp.diff(c, symbol).free_symbols for r in used for c in r.components)
            if len(used) > 1 and linear:
                self.unknowns.append(symbol)
        if not self.unknowns:
            return
        for line in lines:
            new = read.get(id(line))
            strange = set(symbols.values()) - set(self.unknowns)
            if new and not new.error and not any(c.free_symbols & strange for c in new.components):
                line.reading = new


def _plain(text: str) -> str:
    return re.sub(r"\\left|\\right|\\bigg?l?|\\bigg?r?|\$|&|\\[,;!]", "", text).strip()


def _sides(fragment: Fragment) -> tuple[Fragment, Fragment] | None:
    """The two sides of an equation; None if it has another number of them."""
    parts = cuts(fragment.text, _EQUALS)
    if len(parts) != 2:
        return None
    made = []
    for first, last in parts:
        draft = Draft(fragment)
        draft.keep(first, last)
        made.append(draft.finished(latex=is_latex(fragment)))
    return made[0], made[1]


def _given(line: Line) -> Fragment:
    if line.whole or line.reading is None:
        return line.fragment
    return GivenEquation.of_reading_at(line.reading, line.fragment)


def _without(lines: Sequence[Line], others: Sequence[Line]) -> list[Line]:
    return [line for line in lines if not any(line is other for other in others)]
