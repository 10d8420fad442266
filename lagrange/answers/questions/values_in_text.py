r"""Answers to questions among the lines of a text: equations for them, and values alone or beside their working.

Values without a sign of equality: the name of a question before a colon, or an expression alone.

    range: v^2*sin(2*alpha)/g          range = v^2*sin(2*alpha)/g
    0, \sqrt{c/m}                      the frequencies, where small oscillations are asked for
    F/sqrt((c - m*w^2)^2 + b^2*w^2)    the amplitude of the only coordinate, where a response is asked for

An expression alone answers the only thing that the problem asks for beside its equations of motion.

Lines beside the answers to questions: the working that leads to them, and values under names of their own.

A line that cannot be read only because it contains the label of an answer, `m v^2/2 = m g h` before `v = ...`, is
working; so is one without accelerations and forces, an energy or a relation of kinematics. A value under a name that
nobody declared, which answers none of the questions though it has the dimension of one, is a wrong answer.

Answers to questions among the lines of a text: h_min = 5/2 R, N = m g (1 + 2 h/R), v = sqrt(2 g l).

A line answers a question if it is an equation for the quantity that is asked for, or has its letter as a label, and
contains no other coordinate or velocity. It is compared with every question. A line that answers none, although its
letter is that of a quantity, is wrong as an answer to those. All other lines are judged as in any other answer.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.exact.expression_graph import DivisionByZeroError, UnsupportedError
from lagrange.algebra.exact.sampler import NoPointError
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.answers.limits import LONGEST_RUN_OF_LETTERS
from lagrange.answers.questions.asked_quantities import MAGNITUDES, check_asked, claims_of, with_stated_forces
from lagrange.answers.questions.named_values import NOT_EQUAL, at_a_value, is_used_beside, label_of, sides_agree
from lagrange.answers.references import Reference, reference_of_solution
from lagrange.answers.verdicts import AnswerVerdict, EquationVerdict, Verdict
from lagrange.answers.written.decimals import as_written
from lagrange.answers.written.joined_lines import has_sign_of_equality
from lagrange.answers.written.judging import is_of_motion
from lagrange.answers.written.lines import in_pairs
from lagrange.answers.written.names import lines_with, spelled_out
from lagrange.answers.written.reading import read_as_written, tried, undeclared
from lagrange.answers.written.statements import marked_coordinates, statement
from lagrange.answers.written.working import Working, understood
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.records import record
from lagrange.core.symbols import base, t
from lagrange.core.units import NO_DIMENSION, unit_of
from lagrange.core.vectors import Vector
from lagrange.expressions.characters import ABOUT, GREEK
from lagrange.expressions.edits import Draft, closings, cut, cuts
from lagrange.expressions.latex_layout import is_latex
from lagrange.expressions.reader import is_inequality, read_value
from lagrange.expressions.syntax_tree import FUNCTIONS
from lagrange.mechanics.questions.results import Asked
from lagrange.mechanics.results import Solution
from lagrange.values.dimensions import dimension, dimensions_of_units

_NAMED = re.compile(
    r"^[ \t]*(?:[-*][ \t]+)?(?P<name>[^\W\d]\w{0,40}(?: \w{1,20}){0,5})[ \t]*(?P<colon>:)(?=[ \t]+\S)(?P<rest>[^\n]*)$",
    re.MULTILINE,
)
_SENTENCE = re.compile(
    r"^[ \t]*(?P<before>(?:(?:the|die|der|das|la|le|el)[ \t]+)?)(?P<name>[^\W\d]\w{0,40}(?:[ ]\w{1,20}){0,4}?)[ \t]+"
    r"(?P<colon>is|ist|beträgt|est|vaut|es)"
    r"(?=[ \t]+\S)(?P<rest>[^\n]*?)(?P<end>\.?[ \t]*)$",
    re.MULTILINE | re.IGNORECASE,
)
"""`The range is v^2/g.`"""
_NAME_IN_TEXT = re.compile(
    r"(?:[A-Za-z]_\{?\s*)?\\(?:text|textrm|textbf|textit|mathrm|mbox)\s*\{\s*(?P<name>[^{}=$]{1,60}?)\s*:?\s*\}(?:\s*\})?(?P<sign>\s*:?\s*&?\s*=(?!=))"
)
_BETWEEN = re.compile(r"[,;]|\b(?:and|or)\b|\\(?:text|mathrm|mbox)\{\s*(?:and|or)?\s*\}|\\q?quad(?![A-Za-z])|\n")
_COMMAND = re.compile(r"\\(?:text|mathrm|mbox)\{[^{}]*\}|\\[A-Za-z]+")
_WORD = re.compile(r"[^\W\d_]{2,}")
_SMALL_WORDS = "is are be the it we an to of in at on by for if no so"
_OF_SENTENCES = frozenset(_SMALL_WORDS.split())
_KNOWN = frozenset({*FUNCTIONS, *GREEK.values(), "arcsin", "arccos", "arctan", "and", "or"})


def with_sign_after_names(text: str, names: Collection[str]) -> str:
    """`height: v^2/(2*g)` with `=` for the colon, for each name of a question; every place stays where it is."""
    text = _NAME_IN_TEXT.sub(lambda m: _without_text(m, names), text)
    for m in [*_SENTENCE.finditer(text)]:
        name = "_".join(m["name"].split(" "))
        plain = not has_sign_of_equality(m["rest"]) and not is_inequality(Fragment.of(m["rest"]))
        if plain and name in names and is_expressions(m["rest"]):
            made = f"{' ' * len(m['before'])}{name}{'='.rjust(m.end('colon') - m.end('name'))}{m['rest']}"
            text = text[: m.start("before")] + made + " " * len(m["end"]) + text[m.end() :]
    for m in [*_NAMED.finditer(text)]:
        name = "_".join(m["name"].split(" "))  # of the same length
        if name in names and not has_sign_of_equality(m["rest"]) and not is_inequality(Fragment.of(m["rest"])):
            place = m.start("colon")
            text = f"{text[: m.start('name')]}{name}{text[m.end('name') : place]}={text[place + 1 :]}"
    return text


def _without_text(match: re.Match[str], names: Collection[str]) -> str:
    r"""`\text{height} &= ...` as height &= ..., for the name of a question."""
    written = "_".join(match["name"].replace("\\_", "_").split())
    name = next((n for n in (written, written.lower()) if n in names), "")
    made = f"{name}{match['sign'].replace(':', ' ')}" if name else match[0]
    return made.rjust(len(match[0]))


def is_expressions(text: str) -> bool:
    """Whether a text without equations may be expressions, and no sentence."""
    words = [w.lower() for w in _WORD.findall(_COMMAND.sub(" ", text))]
    prose = [w for w in words if w not in _KNOWN and (len(w) > LONGEST_RUN_OF_LETTERS or w in _OF_SENTENCES)]
    return bool(text.strip()) and not prose and ":" not in text and not is_inequality(Fragment.of(text))


def as_asked(answer: Sequence[Fragment], solution: Solution) -> tuple[Fragment, ...] | None:
    """Expressions as equations for what the problem asks for; None if that is not clear."""
    names_of_questions = {a.question.name for a in solution.asked}
    named = [with_sign_after_names(f.text, names_of_questions) for f in answer]
    if any(text != f.text for text, f in zip(named, answer, strict=True)):
        return tuple(replace(f, text=text) for text, f in zip(named, answer, strict=True))
    if not all(is_expressions(f.text) for f in answer):
        return None
    answer = [_listed(f) for f in answer]
    pieces = [cut(f, *p) for f in answer for p in cuts(f.text, _BETWEEN) if f.text[slice(*p)].strip(" $.\n")]
    names = _names(solution, pieces)
    if names is None or len(names) != len(pieces):
        return None
    return tuple(_equation(name, f) for name, f in zip(names, pieces, strict=True))


def _listed(fragment: Fragment) -> Fragment:
    """What stands between the brackets of a list, `{0, Sqrt[c/m]}`; the text itself where it is none."""
    start, end = len(fragment.text) - len(fragment.text.lstrip()), len(fragment.text.rstrip())
    within = fragment.text[start : start + 1] in ("{", "[") and closings(fragment.text).get(start) == end - 1
    return cut(fragment, start + 1, end - 1) if within and "," in fragment.text else fragment


def _names(solution: Solution, pieces: Sequence[Fragment]) -> list[str] | None:
    """What each expression is the value of."""
    views = solution.views
    responses = [v.response for v in views if v.response is not None]
    if any(v.hamiltonian is not None for v in views):
        return ["H"] if all("p_" in f.text for f in pieces) else None
    if responses:
        return [q.name for q in responses[0].by_coordinate]
    if any(v.linearization is not None for v in views):
        return None if solution.asked else [f"omega_{n}" for n, _ in enumerate(pieces, 1)]
    return [solution.asked[0].question.name] if len(solution.asked) == 1 else None


def _equation(name: str, fragment: Fragment) -> Fragment:
    letter, _, index = name.partition("_")
    latex = is_latex(fragment)
    draft = Draft(fragment)
    if latex and letter in GREEK.values():
        name = f"\\{letter}_{{{index}}}" if index else f"\\{letter}"
    draft.apply([(0, 0, f"{name} = ")])
    return draft.finished(latex=latex)


# Values beside their working


_SPEEDS = {"v", "V", "u"}
_UNANSWERED = "it answers none of the questions"


def working_beside(rest: Sequence[Fragment], answer: Sequence[Fragment], reference: Reference) -> list[Fragment]:
    """The lines that cannot be read only because of names that other lines state, or of v, the speed at some place."""
    labels = {name for f in answer if (name := label_of(f))} | _SPEEDS
    values = []
    for f in rest:
        sides = [p.finished(latex=is_latex(f)) for p in in_pairs(f)] or [f]
        names = {n for s in sides for n in undeclared(read_as_written(s, reference.scope_of_answers), s.text)}
        if names and names <= labels:
            values.append(f)
    return values


def only_beside(working: Working, reference: Reference) -> bool:
    """Whether what could be read is about the motion in none of its lines: energies, relations of kinematics."""
    return not any(is_of_motion(f, reference) for f in working.judged)


def not_judged(lines: Sequence[Fragment], why: str) -> tuple[Diagnostic, ...]:
    """A note on each line."""
    return tuple(Diagnostic("not-judged", f"`{f.text.strip()}` {why}", f.whole).as_note() for f in lines)


def under_another_name(answer: Sequence[Fragment], solution: Solution) -> AnswerVerdict | None:
    """The verdict on values of parameters alone, none of which answers a question; None if there is anything else."""
    reference = reference_of_solution(solution)
    known = dimensions_of_units(reference.units)
    if known:  # what has no unit where others have one is a number
        known |= {s: NO_DIMENSION for s in reference.parameters.values() if s not in known}
    derived = [v for a in solution.asked for b in a.branches for v in b.values]
    expected = {d for v in derived if (d := dimension(v, known)) is not None}
    parts = []
    for f in answer:
        try:
            stated = statement(f, reference.scope)
            if not stated.label or len(stated.sides) != 1 or label_of(f) in reference.declared:
                return None
            value = tried(stated.sides[0], stated.scope, lambda g, s=stated.scope: read_value(g, s, [], latex=True))  # type: ignore[misc]
        except ProblemError:
            return None
        if isinstance(value, Vector) or not value.free_symbols <= {*reference.parameters.values()}:
            return None
        if any(base(s) != s for s in value.free_symbols) or dimension(value, known) not in expected:
            return None
        said = "; ".join(filter(None, (_UNANSWERED, _nearest(value, label_of(f) or "", solution))))
        parts.append(EquationVerdict(f.text.strip(), Verdict.WRONG, said))
    return AnswerVerdict(Verdict.WRONG, tuple(parts), name="ask") if parts else None


def _nearest(value: sp.Expr, label: str, solution: Solution) -> str:
    """How a value differs from the answer to the question whose name begins with its letter, or to the only one from
    which it differs in a simple way; empty if there is none."""
    from lagrange.answers.models.questions import NO_DEPENDENCE, explained_value

    found = {}
    for a in (a for a in solution.asked if a.answered):
        right = [v for b in a.branches for v in b.values]
        why = next(filter(None, (explained_value(value, v, {*()}) for v in right)), "")
        if why and not why.startswith(NO_DEPENDENCE):
            found[a.question.name] = why
    own = [name for name in found if label and name.startswith(label)]
    names = own or (list(found) if len(found) == 1 else [])
    return f"of `{names[0]}`: {found[names[0]]}" if len(names) == 1 else ""


# Equations for what is asked


_LETTER = re.compile(r"\s*\$?\s*\\?(?P<name>[^\W\d_](?:[^\W\d_]*))(?P<rest>[^=]{0,40}?)\s*=")
_APPLIED = re.compile(r"\s*\$?\s*\\?(?:cos|sin|tan)\s*(?:\(|\\left\s*\(|\{|~|\s)?\s*\\?(?P<name>[^\W\d_]+)[^=]{0,40}=")
_NAMES_A_RATE = re.compile(
    r"\s*\$?\s*\\?\w{1,8}\s*(?::=|=|\\equiv)\s*(?:\\dot\s*(?:\{\s*\\?\w+\s*\}|\s\w+|\\\w+)|\w+'|d\s?\w+\s*/\s*dt|\\[dt]?frac\s*\{\s*d\s?\\?\w+\s*\}\s*\{\s*dt\s*\})\s*\$?[\s.,;]*\Z"
)
"""`v = \\dot y`, `v = y'`, `v = dy/dt`: a letter for a velocity, which answers no question."""
_FREQUENCY = re.compile(r"[\s$]*\\?(?:omega|Omega|ω|Ω)(?:_\w+|\^2|²)?\s*=")
"""A frequency, where these are asked for as well as a speed."""
_SPEED_QUANTITIES = frozenset({"v", "V", "u", "w", "omega", "speed", "velocity"})
_TIMES = frozenset({"t", "T", "tau", "time"})
_NOT_JUDGED = (Verdict.UNREADABLE, Verdict.UNDECIDED)
_NO_ANSWER = (*_NOT_JUDGED, Verdict.TRIVIAL)


@record
class AskedInText:
    """The lines of a text, sorted.

    verdict  on the lines that answer questions; None if there are none
    rest     the other lines
    missing  the questions without an answer
    """

    verdict: AnswerVerdict | None
    rest: tuple[Fragment, ...]
    missing: tuple[str, ...]


def asked_in_text(
    answer: Sequence[Fragment], solution: Solution, *, among: Sequence[Fragment] | None = None
) -> AskedInText:
    """The lines that answer questions, and the others; `among`: of these lines only."""
    every = [a for a in solution.asked if a.answered]
    parts: list[EquationVerdict] = []
    rest: list[Fragment] = []
    answered: set[str] = set()
    reference = reference_of_solution(solution)
    defined = understood(answer, reference).defined
    scalars = {n: e for n, e in defined.items() if n not in reference.scope.scalars}

    def with_definitions(without: Collection[str] = ()) -> Reference:
        added = {n: e for n, e in scalars.items() if n not in without}
        return replace(reference, scope=replace(reference.scope, scalars={**reference.scope.scalars, **added}))

    has_frequencies = any(v.linearization is not None for v in solution.views)
    for fragment in answer if among is None else among:
        fragment, questions = _at_its_place(fragment, every, solution)
        fragment = _with_number_as_side(fragment)
        wider = with_definitions()
        if _is_condition(fragment, questions, reference) or _is_condition(fragment, questions, wider):
            continue
        left = spelled_out(fragment.text.partition("=")[0])
        if (relation := _between_answers(fragment, questions, wider)) is not None:
            parts.append(relation)
            continue
        own = {n for n in scalars if n == label_of(fragment) or lines_with(n, [left])}  # of v(h) = a, v(t) = b each
        compared = [*_verdicts(fragment, questions, solution, reference)]
        for names in [with_definitions(own), wider] if own else [wider] if scalars else []:
            if any(v.verdict is Verdict.EQUIVALENT for _, v in compared):
                break
            with_names = [*_verdicts(fragment, questions, solution, names)]
            right_so = any(v.verdict is Verdict.EQUIVALENT for _, v in with_names)
            compared = with_names if right_so else compared or with_names
        right = [(name, v) for name, v in compared if v.verdict is Verdict.EQUIVALENT]
        marked = {*marked_coordinates(fragment, reference.scope).values()}  # 1 - cos(theta_max) = ...
        named = [
            a.question.name
            for a in questions
            if _is_named(fragment, a) or _states_quantity(fragment, a, reference) or a.question.quantity in marked
        ]
        exactly = [a.question.name for a in questions if str(a.question.quantity) == label_of(fragment)]
        named = [name for name in named if name in exactly] or named  # N_B is not N_A
        named = [] if _NAMES_A_RATE.match(fragment.text) or is_used_beside(fragment, answer, reference) else named
        named = [] if _is_potential_energy(fragment, answer, wider) else named
        named = [] if has_frequencies and _FREQUENCY.match(fragment.text) else named
        about = {name for name, _ in compared}  # y = f(x) is about the path, and not about the greatest height
        named = [name for name in named if name in about] or named
        named = _labels_before(fragment, questions) or _of_function(named, fragment, questions, reference)
        judged = [(name, v) for name, v in compared if v.verdict not in _NO_ANSWER and name in named]
        if right and sides_agree(fragment, wider, {a.question.quantity for a in questions}) is False:
            parts.append(EquationVerdict(" ".join(fragment.text.split()), Verdict.WRONG, NOT_EQUAL))
        elif right:
            answered |= {name for name, _ in right}
            name, verdict = next(((n, v) for n, v in right if n in named), right[0])
            parts.append(_part(fragment, name, verdict))
        elif judged and _holds_at_a_limit(fragment, judged, questions, solution, reference):
            continue
        elif judged and len(judged) == len(named):
            name, verdict = _explained(fragment, judged, solution)
            functions = [a for a in questions if a.question.name in named and a.question.by is not None]
            is_value = any(_is_its_value(fragment, a, wider) for a in functions)
            if is_value or _is_right_where_stated(fragment, verdict.diagnosis):
                parts.append(EquationVerdict(" ".join(fragment.text.split()), Verdict.EQUIVALENT, "", (_ELSEWHERE,)))
                continue
            answered |= {*named} if len(named) == 1 else set()
            parts.append(_part(fragment, name, verdict))
        elif open_ := [(name, v) for name, v in compared if v.verdict is Verdict.UNDECIDED and name in named]:
            parts.append(_part(fragment, *open_[0]))  # as an equation of motion it would be wrong
        else:
            rest.append(fragment)
    missing = tuple(a.question.name for a in every if a.question.name not in answered)
    if not parts:
        return AskedInText(None, tuple(rest), missing)
    verdicts = {p.verdict for p in parts}
    order = (Verdict.WRONG, *_NOT_JUDGED, Verdict.INCOMPLETE)
    whole = next((v for v in order if v in verdicts), Verdict.EQUIVALENT)
    asked = AnswerVerdict(whole, tuple(parts), name="ask")
    if whole is Verdict.WRONG:
        asked = with_stated_forces(asked, [(p.part, Fragment.of(p.text)) for p in parts], solution)
    return AskedInText(asked, tuple(rest), missing)


_RELATION = "it is a relation between what is asked for"
_FALSE_RELATION = "it does not hold between the right answers to the questions"


def _between_answers(fragment: Fragment, questions: Sequence[Asked], reference: Reference) -> EquationVerdict | None:
    """The verdict on an equation between several asked forces, N_A + N_B = m g; None if it is none, or not settled."""
    reading = read_as_written(fragment, reference.scope)
    used = set() if reading.error else {s for e in reading.components for s in e.free_symbols}
    moving = {q for c in reference.candidates for q in c.configuration.slots.coordinates}
    if any(base(s) in moving for s in used):
        return None
    parameters = {*reference.parameters.values()}
    asked = [a for a in questions if a.question.quantity in used - parameters]
    values = [[v for b in a.branches for v in b.values] for a in asked]
    at_once = len({tuple((c.lhs, c.rhs) for c in a.question.when) for a in asked}) == 1
    if len(asked) < 2 or not at_once or any(len(v) != 1 for v in values) or label_of(fragment):
        return None
    rule = {a.question.quantity: v for a, [v] in zip(asked, values, strict=True)} | dict(reference.values)
    residuals = [e.xreplace(rule) for e in reading.components]
    if any(not e.free_symbols <= parameters for e in residuals):
        return None
    try:
        holds = [is_zero(as_written(e)) for e in residuals]
    except DivisionByZeroError:
        return None
    text = " ".join(fragment.text.split())
    if False in holds:
        return EquationVerdict.of(text, Verdict.WRONG, _FALSE_RELATION)
    return None if None in holds else EquationVerdict(text, Verdict.EQUIVALENT, "", (_RELATION,))


_ELSEWHERE = "it is right for the place that is stated, at which it is not asked for"
_PLACE_OF_VALUE = re.compile(r"this is the value where (?P<name>\w+) = (?P<value>[\w/*]+)\Z")


def _is_right_where_stated(fragment: Fragment, diagnosis: str) -> bool:
    """Whether the line of a value says that it is for the place at which it is right: `At the top θ = π: N = ...`."""
    place = _PLACE_OF_VALUE.search(diagnosis)
    if place is None:
        return False
    text, at = fragment.whole.source.text, fragment.span(0, len(fragment.text)).start
    line, begin = text[text.rfind("\n", 0, at) + 1 :].partition("\n")[0], text.rfind("\n", 0, at) + 1
    spelled = ["".join(f" {GREEK[c]} " if c in GREEK else c for c in part) for part in (line[: at - begin], line)]
    name = rf"(?<![\w/*^]){re.escape(place['name'])}\s*=\s*\\?"
    value = rf"{re.escape(place['value'])}(?![\w/*^])"
    before = re.findall(rf"{name}[^=]{{1,20}}", spelled[0])
    if before:  # the last place that is named counts
        return re.match(rf"{name}{value}\s*(?:\)|\$|:|,)", before[-1]) is not None
    return re.search(rf"\b(?:at|where|when|for|if)\s+\$?\\?{name}{value}", spelled[1]) is not None


def _is_its_value(fragment: Fragment, function: Asked, reference: Reference) -> bool:
    """Whether a line states what an asked function is at a place named before it: `At the top theta = 0: N = m g`."""
    by, text, at = function.question.by, fragment.whole.source.text, fragment.span(0, len(fragment.text)).start
    before = spelled_out(text[text.rfind("\n", 0, at) + 1 : at])
    places = re.findall(rf"(?<![\w/*^]){re.escape(str(by))}\s*=\s*([^=:,;$]{{1,20}}?)\s*[:,;$]", before)
    try:
        place = read_value(Fragment.of(places[-1]), reference.scope, latex=is_latex(fragment)) if places else None
        claims = read_as_written(fragment, reference.scope)
        if not isinstance(place, sp.Expr) or claims.error is not None or len(claims.components) != 1:
            return False
        values = [v.xreplace({by: place}) for b in function.branches for v in b.values]
        residuals = [claims.components[0].xreplace({function.question.quantity: v, by: place}) for v in values]
        return any(is_zero(as_written(e)) is True for e in residuals)
    except (ProblemError, DivisionByZeroError):
        return False


_POTENTIAL = re.compile(r"[\s$&]*(?:\\mathcal\s*\{?\s*)?(?P<name>[VU])\s*\}?\s*(?:\([^()=]{0,20}\))?\s*&?=(?!=)")
_KINETIC = re.compile(r"[\s$&]*(?:\\mathcal\s*\{?\s*)?[TK](?:_\{?\w{1,8}\}?)?\s*\}?\s*&?=[^=]*(?:['\u0307]|dot)")
_ENERGY = tuple(sp.Integer(n) for n in unit_of("J").dimension)  # type: ignore[union-attr]


def _is_potential_energy(fragment: Fragment, answer: Sequence[Fragment], reference: Reference) -> bool:
    """Whether `V = ...` is an energy and no speed: by its dimension, or beside a kinetic energy."""
    match = _POTENTIAL.match(fragment.text)
    if match is None or match["name"] in reference.declared:
        return False
    scope, known = reference.scope, dimensions_of_units(reference.units)
    side = cut(fragment, match.end(), len(fragment.text))
    try:
        value = tried(side, scope, lambda f: read_value(f, scope, [], latex=True))
    except ProblemError:
        return False
    of_value = dimension(value, known) if isinstance(value, sp.Expr) else None
    return of_value == _ENERGY if of_value is not None else any(_KINETIC.match(f.text) for f in answer)


_NUMBER_BESIDE = re.compile(
    rf"(?P<exact>=[^=≈]{{1,200}}?)\s*(?P<about>{ABOUT})(?P<number>\s*[-+−]?[0-9]{{1,9}}(?:\.[0-9]{{1,9}})?)"
    r"\s*(?:°|\^\s*\{?\s*\\circ\s*\}?|deg)?[\s.$]*\Z"
)


def _with_number_as_side(fragment: Fragment) -> Fragment:
    """`theta = acos(2/3) ≈ 0.841` as theta = acos(2/3) = 0.841; a whole number, which is rounded, is left out."""
    match = _NUMBER_BESIDE.search(fragment.text)
    if match is None:
        return fragment
    draft = Draft(fragment)
    if "." in match["number"]:
        draft.apply([(*match.span("about"), "=")])
    else:
        draft.keep(0, match.end("exact"))
    return draft.finished(latex=is_latex(fragment))


def _at_its_place(fragment: Fragment, questions: list[Asked], solution: Solution) -> tuple[Fragment, list[Asked]]:
    """`N(0) = ...` as N = ..., with the questions whose place, or time, is 0; unchanged if there are none."""
    stated = at_a_value(fragment)
    if stated is None:
        return fragment, questions
    value = stated[1]
    there = [
        a
        for a in questions
        for c in a.question.when
        if any(c.lhs == q and c.rhs == value for q in c.lhs.free_symbols if base(q) == q)
    ]
    if value == 0:  # theta''(0), where theta = alpha at the start
        start = {(i.symbol, i.value) for i in solution.problem.initial}
        there += [a for a in questions if a.question.when and all((c.lhs, c.rhs) in start for c in a.question.when)]
    return (stated[0], there) if there else (fragment, questions)


def _labels_before(fragment: Fragment, questions: Sequence[Asked]) -> list[str]:
    """The question whose name is the label of a line with a letter of its own: `speed: u = 5 v/7`."""
    before = getattr(fragment, "beside", "").rstrip().lower()
    names = [a.question.name for a in questions if before.endswith(f"{a.question.name.replace('_', ' ').lower()}:")]
    return sorted(names, key=len)[-1:]


def _of_function(
    named: Sequence[str], fragment: Fragment, questions: Sequence[Asked], reference: Reference
) -> list[str]:
    """Of questions for one quantity those for a function of what occurs in a line, x(t) = ..., or those for none."""
    reading = read_as_written(fragment, reference.scope)
    used = set() if reading.error else {s for e in reading.components for s in e.free_symbols}
    by = {a.question.name: a.question.by for a in questions}
    functions = [name for name in named if by[name] is not None and by[name] in used]
    return functions or [name for name in named if by[name] is None] or [*named]


def _explained(
    fragment: Fragment, judged: Sequence[tuple[str, EquationVerdict]], solution: Solution
) -> tuple[str, EquationVerdict]:
    """A wrong line with what is wrong about it, as the answer to the question to which it is close."""
    for name, _ in judged:
        explained = check_asked({name: fragment}, solution).equations[0]
        if explained.verdict not in _NOT_JUDGED and (explained.diagnosis or len(judged) == 1):
            why = explained.diagnosis if len(judged) == 1 else f"as the answer to `{name}`: {explained.diagnosis}"
            return name, replace(explained, diagnosis=why)
    return judged[0]


def _states_quantity(fragment: Fragment, asked: Asked, reference: Reference) -> bool:
    """Whether one side of a line is the quantity itself, or its square, as in R*theta' = ... and x'^2 = a = b."""
    pairs = in_pairs(fragment)
    reading = read_as_written(pairs[0].finished(latex=is_latex(fragment)) if pairs else fragment, reference.scope)
    quantity = asked.question.quantity
    is_expression = not quantity.is_Symbol or base(quantity) != quantity
    return not reading.error and is_expression and any(s in (quantity, quantity**2) for s in reading.sides)


def _holds_at_a_limit(
    fragment: Fragment,
    judged: Sequence[tuple[str, EquationVerdict]],
    questions: Sequence[Asked],
    solution: Solution,
    reference: Reference,
) -> bool:
    """Whether a line is right for the value of a parameter that is asked for: v = sqrt(g R) at the least height."""
    names = {name for name, _ in judged}
    for asked in questions:
        quantity, values = asked.question.quantity, [v for b in asked.branches for v in b.values]
        if quantity not in reference.parameters.values() or len(values) != 1 or asked.question.name in names:
            continue
        special = replace(reference, values={**reference.values, quantity: values[0]})
        others = [a for a in questions if a.question.name in names]
        if any(v.verdict is Verdict.EQUIVALENT for _, v in _verdicts(fragment, others, solution, special)):
            return True
    return False


def _is_condition(fragment: Fragment, questions: Sequence[Asked], reference: Reference) -> bool:
    """Whether a line is the condition of a question, N = 0, and no answer."""
    reading = read_as_written(fragment, reference.scope)
    if reading.error or len(reading.components) != 1:
        return False
    [e] = reading.components
    conditions = [c.lhs - c.rhs for a in questions for c in a.question.when]
    return any(sp.expand(e - sign * c) == 0 for c in conditions for sign in (1, -1))


def _part(fragment: Fragment, name: str, verdict: EquationVerdict) -> EquationVerdict:
    remarks = (*verdict.remarks, f"it is taken as the answer to `{name}`")
    text = " ".join(fragment.text.split())
    shown = () if verdict.diagnosis else remarks
    return EquationVerdict(text, verdict.verdict, verdict.diagnosis, shown, part=name)


def _verdicts(
    fragment: Fragment, questions: Sequence[Asked], solution: Solution, reference: Reference
) -> Iterator[tuple[str, EquationVerdict]]:
    """The verdicts on a line as the answer to each question that it may answer."""
    coordinates = {q for v in solution.views for q in v.configuration.slots.coordinates}
    for asked in questions:
        try:
            claims = claims_of(fragment, asked, solution, reference)
            stated = [e for c in claims for e in (c.expression, c.equation) if e is not None]
            used = {s for e in stated for s in e.free_symbols if isinstance(s, sp.Symbol)}
            asked_for = {*asked.question.quantity.free_symbols, asked.question.by}
            if t in used - asked_for and not any(t in v.free_symbols for b in asked.branches for v in b.values):
                continue
            if any((base(s) in coordinates or base(s) != s) and s not in asked_for for s in used):
                continue
            values = [c.expression for c in claims if c.expression is not None]
            if any(base(s) != s for e in values for s in e.free_symbols) or (
                label_of(fragment) and any(c.equation == 0 for c in claims)
            ):
                continue  # v = R theta' says what v is, where R theta' is asked for
            best = min((c.verdict(explaining=False) for c in claims), key=lambda v: v[0] is Verdict.EQUIVALENT)
        except (ProblemError, DivisionByZeroError, NoPointError, UnsupportedError):
            continue
        yield asked.question.name, EquationVerdict.of(fragment.text, *best)


def _is_named(fragment: Fragment, asked: Asked) -> bool:
    """Whether the letter on the left of a line is that of the quantity, or the name of the question."""
    match = _APPLIED.match(fragment.text) or _LETTER.match(fragment.text)
    if match is None:
        return False
    name = "".join(GREEK.get(c, c) for c in match["name"])
    question = asked.question
    if re.match(rf"\s*{re.escape(question.name)}\s*=", fragment.text):
        return True
    symbols = question.quantity.free_symbols
    if re.search(r"['′̇̈]|dot|/", match["rest"] if "rest" in match.re.groupindex else ""):
        return False
    if len(symbols) == 1 and question.quantity.is_Symbol:
        [symbol] = symbols
        if symbol.name == "t":
            return name in _TIMES
        if symbol.name == base(symbol).name:
            return bool(name == symbol.name.partition("_")[0] or match[0].strip(" $=\\") == symbol.name)
    orders = {s.name.count("'") for s in symbols if base(s) != s}
    return (1 in orders and name in _SPEED_QUANTITIES) or (orders == {2} and name in (*MAGNITUDES, "acceleration"))
