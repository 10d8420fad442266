"""Are the stated amplitudes of a steady state right?

Each entry is an expression, or an equation with the coordinate on the left, for the amplitude of one coordinate. Its
square must be that of the derived one, exactly, with decimals that may be rounded: the sign of an amplitude tells the
phase, and may be stated either way.

A steady state as it is worked out on paper: an amplitude under a name of its own, or the motion itself.

    A = F/sqrt((c - m w^2)^2 + b^2 w^2)        X = F (c_2 - m_2 w^2)/D, D = ...        x(t) = A cos(w t - phi)

A letter is the amplitude of a coordinate if it is that of the coordinate in any case, `X` or `x_max` for x, or has its
number or index, `A_x`, `A_2`; where there is one coordinate, `A` is its amplitude. A motion is compared with the steady
state at all times; where its lag is left open, its amplitude counts. For the angular frequency ω may be written,
although the problem calls it w. Without damping, equations between amplitudes are right if these satisfy them.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.exact.expression_graph import DivisionByZeroError
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.answers.questions.named_values import (
    WRONG_UNIT,
    Judged,
    check_each,
    dimensions_of_value,
    in_si,
    worst,
)
from lagrange.answers.readings import GivenEquation, decimals_in
from lagrange.answers.references import Reference, reference_of_solution
from lagrange.answers.verdicts import UNDECIDED, AnswerVerdict, EquationVerdict, Verdict
from lagrange.answers.written.decimals import as_written, numbers_rounding_to
from lagrange.answers.written.reading import read_as_written, tried
from lagrange.answers.written.statements import statement
from lagrange.answers.written.working import Working, understood
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError, suggestion
from lagrange.core.symbols import base, t
from lagrange.core.vectors import Vector
from lagrange.expressions.edits import Draft
from lagrange.expressions.latex_layout import is_latex
from lagrange.expressions.reader import read_value
from lagrange.mechanics.equilibrium.response import Response
from lagrange.mechanics.results import Solution

_NOT_DERIVED = "the problem does not ask for the response to a harmonic drive"
_MOVES = "an amplitude does not depend on time"


def check_response_answers(stated: Mapping[str, Fragment], solution: Solution) -> AnswerVerdict:
    """The verdict on all amplitudes together."""
    responses = [v.response for v in solution.views if v.response is not None]
    if not responses:
        return AnswerVerdict(Verdict.UNDECIDED, name="response", diagnosis=_NOT_DERIVED)
    reference = reference_of_solution(solution)
    claims: dict[str, sp.Expr] = {}
    verdict = check_each(
        "response", stated, lambda name, fragment: _judged(name, fragment, responses, reference, claims)
    )
    if verdict.verdict is not Verdict.WRONG or len(claims) < len(stated):
        return verdict
    from lagrange.answers.results.amplitudes import explained_amplitudes

    together = next(filter(None, (explained_amplitudes(claims, r) for r in responses)), "")
    if not together:
        return verdict
    plain = tuple(replace(e, diagnosis="") for e in verdict.equations)  # one cause for all of them
    return replace(verdict, equations=plain, diagnosis=together)


def _judged(
    name: str, fragment: Fragment, responses: Sequence[Response], reference: Reference, claims: dict[str, sp.Expr]
) -> Judged:
    """The verdict on one amplitude, which is added to `claims`. Raises ProblemError, DivisionByZeroError."""
    squares = _squares(responses)
    if name not in squares:
        message = f"`{name}` is not a coordinate with an amplitude"
        raise ProblemError(
            Diagnostic("unknown-name", message, fragment.whole, help=suggestion(name, list(squares), "coordinates"))
        )
    fragment, unit_fits = in_si(fragment, dimensions_of_value(sp.sqrt(squares[name]), reference), reference)
    if not unit_fits:
        return Verdict.WRONG, WRONG_UNIT
    scalars = {n: e for n, e in reference.scope.scalars.items() if n not in reference.letters}
    stated = statement(fragment, replace(reference.scope, scalars=scalars, decimals=""), name=name)
    # x = F/k, A = F/k, |x| = F/k: what stands on the left is the amplitude
    claim = tried(stated.sides[-1], stated.scope, lambda f: read_value(f, stated.scope, [], latex=True))
    if isinstance(claim, Vector):
        raise ProblemError(Diagnostic("vector-for-scalar", "an amplitude is a number, not a vector", fragment.whole))
    if not any(s.name == "t" for s in claim.free_symbols):
        claims[name] = as_written(claim).xreplace(dict(reference.values))
    return judged_amplitude(claim, name, responses, reference)


def judged_amplitude(claim: sp.Expr, name: str, responses: Sequence[Response], reference: Reference) -> Judged:
    """The verdict on the value of the amplitude of a coordinate. Raises DivisionByZeroError."""
    squares = _squares(responses)
    if any(s.name == "t" for s in claim.free_symbols):
        return Verdict.WRONG, _MOVES
    difference = (claim**2 - squares[name]).xreplace(dict(reference.values))
    same = is_zero(as_written(difference))
    if same is False and decimals_in([difference]):
        same = numbers_rounding_to([difference]) is not None
    if same is not False:
        return (Verdict.UNDECIDED, UNDECIDED) if same is None else (Verdict.EQUIVALENT, "")
    from lagrange.answers.models.questions import explained_value

    amplitude = sp.powdenest(sp.sqrt(sp.factor(sp.expand(squares[name]))), force=True)
    why = (explained_value(sign * as_written(claim), amplitude, set()) for sign in (1, -1))
    if reason := next(filter(None, why), ""):
        return Verdict.WRONG, reason
    if reference.values and not as_written(claim).free_symbols:  # a number alone is in SI units
        return Verdict.WRONG, ""
    from lagrange.answers.results.meanings import wrong_dimension

    return Verdict.WRONG, wrong_dimension(as_written(claim), reference.units, amplitude)


def _squares(responses: Sequence[Response]) -> dict[str, sp.Expr]:
    """The squares of the amplitudes by the names of their coordinates."""
    return {
        q.name: sp.Add(a**2, b**2)
        for r in responses
        for q, a, b in zip(r.forced.configuration.slots.coordinates, r.cosines, r.sines, strict=True)
    }


# A steady state with its working


_HAT = re.compile(r"\\(?:hat|widehat|bar|overline|tilde|underline)\s*(?:\{\s*(\\?[A-Za-z]+)\s*\}|(\\?[A-Za-z]+))")
_MODULUS = re.compile(r"\A[\s$]*(?:\\left\s*)?\|\s*(\\?\w{1,12})\s*(?:\\right\s*)?\|\s*=(?!=)")
"""`|x| = ...`, an amplitude."""
_HAT_ABOVE = re.compile(r"([^\W\d_])[\u0302\u0304\u0303]")
_LAG = re.compile(r"\\delta(?![A-Za-z]|\s*[A-Za-z({\\])|δ(?!\s*[\w(])|(?<![A-Za-z\\])delta(?![A-Za-z0-9_]|\s*[\w(])")
"""A lag that is called δ, and is no virtual displacement."""
_LAGS = ("phi", "varphi", "psi", "epsilon", "alpha", "beta", "gamma")
_AMPLITUDES = re.compile(r"(?:A|X|Amp|amp|amplitude|a|R|C|B)(?:_?\w{1,12})?")
_STRONG = re.compile(r"(?:A|X|[Aa]mp)")
_PHASE = sp.Symbol("lag", real=True)
_LAG_OPEN = "its lag is left open, and only the amplitude is compared"
_QUADRANT = "its lag is given by its tangent, which leaves the quadrant open"
_NOT_STEADY = "it is not the steady state"


def without_hats(fragment: Fragment) -> Fragment:
    """x_max for an x with a hat, which is no unit vector here."""
    draft = Draft(fragment)
    changed = draft.replace(_MODULUS, r"\1 =")
    changed = draft.replace(_HAT, lambda m: f"{m[1] or m[2]}_{{max}}") or changed
    changed = draft.replace(_HAT_ABOVE, r"\1_max") or changed
    changed = draft.replace(_LAG, lambda m: "\\psi " if m[0][0] == "\\" else "psi") or changed
    return draft.finished(latex=is_latex(fragment)) if changed else fragment


def with_names_of_response(reference: Reference, responses: Sequence[Response], *, lags: bool) -> Reference:
    """The names that an answer may use, with ω for the frequency of the drive, and letters for lags that stay open."""
    names: dict[str, sp.Expr] = {n: _PHASE for n in _LAGS if n not in reference.declared} if lags else {}
    for r in responses:
        if isinstance(r.drive.frequency, sp.Symbol):
            names |= {n: r.drive.frequency for n in ("omega", "Omega") if n not in reference.declared}
    amplitudes = {s.name for r in responses for s in r.letters}  # the answer's own, where it has them
    scalars = {n: e for n, e in reference.scope.scalars.items() if n not in amplitudes} | names
    return replace(reference, scope=replace(reference.scope, scalars=scalars))


def response_in_text(answer: Sequence[Fragment], solution: Solution) -> AnswerVerdict | None:
    """The verdict on amplitudes and motions; None if a text has none, or equations of motion as well."""
    responses = [v.response for v in solution.views if v.response is not None]
    answer, trials = _without_trials(answer, {q.name: q for r in responses for q in r.by_coordinate})
    for lags in (False, True):
        reference = with_names_of_response(reference_of_solution(solution), responses, lags=lags)
        working = understood([without_hats(f) for f in answer], reference)
        verdict = check_response_in_text(working, responses, reference, trials)
        if verdict is not None and not verdict.unreadable:
            break
    if verdict is None:
        return None
    written = {without_hats(f).text.strip(): f.text.strip() for f in answer}
    parts = tuple(replace(e, text=written.get(e.text, e.text)) for e in verdict.equations)
    return replace(verdict, name="response", equations=parts)


_TRIAL = re.compile(
    r"[\s$&]*(?P<coordinate>\\?[^\W\d_]\w{0,12}?)\s*(?:\(\s*t\s*\))?\s*&?=\s*"
    r"(?P<amplitude>\\?[^\W\d_](?:_\{?\w{1,3}\}?)?)"
    r"(?:\\[,;:! ]|[\s*·])*\\?(?:cos|sin)\s*(?:\\left\s*)?\(?"
    r"\s*\\?\w{1,8}\s*\\?,?[\s*]*t\s*(?:\\right\s*)?\)?[\s.,:;$]*\Z"
)
"""A trial solution, `x = X cos(w t)`, whose amplitude other lines determine."""


def _without_trials(
    answer: Sequence[Fragment], coordinates: Mapping[str, sp.Symbol]
) -> tuple[list[Fragment], dict[str, sp.Symbol]]:
    """The lines without trial solutions for a coordinate, in letters that occur in other lines and are not given.

    Also those letters, each with the coordinate whose amplitude it is.
    """
    kept, letters = [], dict[str, sp.Symbol]()
    for f in answer:
        match = _TRIAL.match(f.text)
        others = [g.text for g in answer if g is not f]
        trial = match is not None and match["coordinate"].lstrip("\\") in coordinates
        if match is not None and trial:
            letter = re.escape(match["amplitude"])
            used = any(re.search(rf"(?<![A-Za-z_\\]){letter}(?![A-Za-z0-9_])", text) for text in others)
            given = any(re.match(rf"[\s$&]*{letter}\s*&?=", text) for text in others)
            if used and not given and not all(map(_TRIAL.match, others)):
                letters[re.sub(r"[{}]", "", match["amplitude"])] = coordinates[match["coordinate"].lstrip("\\")]
                continue
        kept.append(f)
    return kept, letters


def check_response_in_text(
    working: Working, responses: Sequence[Response], reference: Reference, trials: Mapping[str, sp.Symbol]
) -> AnswerVerdict | None:
    """The verdict on amplitudes and motions; None if the text has none, but equations of motion or nothing of it.

    trials  the letters that the answer chose for the amplitudes of coordinates
    """
    parts: list[EquationVerdict] = []
    answered: set[str] = set()
    coordinates = list(dict.fromkeys(q for r in responses for q in r.by_coordinate))
    amplitudes = _amplitudes(working.defined, coordinates)
    doubtful: list[EquationVerdict] = []
    claims: dict[str, tuple[str, sp.Expr]] = {}  # by the text of a part
    for name, q in amplitudes.items():
        claims[name] = q.name, working.defined[name]
        verdict, why = judged_amplitude(working.defined[name], q.name, responses, reference)
        part = EquationVerdict.of(name, verdict, why)
        if verdict is Verdict.WRONG:  # it may be an abbreviation after all
            doubtful += [part] if _STRONG.match(name) or q.name.lower() in name.lower() else []
        else:
            parts, answered = [*parts, part], answered | {q.name}
    solved: list[GivenEquation] = []
    for line in working.unreadable:
        ratio = _solved(line, working, coordinates, reference)
        if ratio is not None:
            verdict, why = judged_amplitude(ratio[1], ratio[0].name, responses, reference)
            parts.append(EquationVerdict.of(line.reading.text, verdict, why))
            answered |= {ratio[0].name}
            claims[line.reading.text] = ratio[0].name, ratio[1]
            solved.append(line)
    unknown = _undamped(working, coordinates, responses, trials)
    rows: list[sp.Expr] = []
    approximate: list[Fragment] = []
    for n, f in enumerate(working.judged):
        if n in working.approximate and _moves(f, reference):
            approximate.append(f)
            continue
        if not isinstance(f, GivenEquation) or len(f.reading.components) != 1:
            return None
        [e] = f.reading.components
        if e.free_symbols <= {*reference.parameters.values()}:  # between the amplitudes that the answer states
            holds = is_zero(e.xreplace(dict(reference.values)))
            verdict = Verdict.UNDECIDED if holds is None else Verdict.EQUIVALENT if holds else Verdict.WRONG
            parts.append(EquationVerdict.of(f.reading.text, verdict, ""))
            continue
        if e.free_symbols & unknown.keys():
            holds = is_zero(
                e.xreplace({s: value for s, (_, value) in unknown.items()}).xreplace(dict(reference.values))
            )
            verdict = Verdict.UNDECIDED if holds is None else Verdict.EQUIVALENT if holds else Verdict.WRONG
            parts.append(EquationVerdict.of(f.reading.text, verdict, ""))
            rows.append(e)
            continue
        verdict_on_motion = _motion(f, responses, coordinates, reference)
        if verdict_on_motion is None:
            return None
        q, (verdict, why) = verdict_on_motion
        value = next(side for side in f.reading.sides if isinstance(side, sp.Expr) and side != q)
        if t not in value.free_symbols:
            claims[f.reading.text] = q.name, value
        parts.append(EquationVerdict.of(f.reading.text, verdict, why))
        answered |= {q.name}
    if rows and sp.Matrix([[e.diff(s) for s in unknown] for e in rows]).rank() == len(unknown):
        answered |= {q.name for q, _ in unknown.values()}
    unanswered = [p for p in doubtful if amplitudes[p.text].name not in answered]
    parts += unanswered
    answered |= {amplitudes[p.text].name for p in unanswered}
    if not parts:
        return None
    parts = _with_causes(parts, claims, responses, reference)
    unread = [f for f in working.unreadable if f not in solved]
    parts += [
        EquationVerdict(f.reading.text, Verdict.UNREADABLE, f.reading.error.diagnostics[0].message)
        for f in unread
        if f.reading.error
    ]
    errors = tuple(d for f in unread if f.reading.error for d in f.reading.error.diagnostics)
    verdict = worst([p for p in parts if p.verdict is not Verdict.UNREADABLE])
    missing = [q.name for q in coordinates if q.name not in answered]
    if verdict is Verdict.EQUIVALENT and missing:
        verdict = Verdict.UNREADABLE if errors else Verdict.INCOMPLETE
    why = f"the amplitude of {', '.join(missing)} is missing" if missing else ""
    defined = [f"`{p.text}`" for p in parts if p.text in amplitudes]
    notes = tuple(n for n in working.notes if not any(f"defines {name}," in n.message for name in defined))
    notes += tuple(
        Diagnostic(
            "not-judged", f"`{f.text.strip()}` is marked as an approximation, and is not judged", f.whole
        ).as_note()
        for f in approximate
    )
    return AnswerVerdict(verdict, tuple(parts), unreadable=errors, notes=notes, diagnosis=why)


def _moves(fragment: Fragment, reference: Reference) -> bool:
    """Whether accelerations occur in an equation."""
    components = fragment.reading.components if isinstance(fragment, GivenEquation) else ()
    return any(not e.free_symbols.isdisjoint(reference.scope.slots.accelerations) for e in components)


def _with_causes(
    parts: Sequence[EquationVerdict],
    claims: Mapping[str, tuple[str, sp.Expr]],
    responses: Sequence[Response],
    reference: Reference,
) -> list[EquationVerdict]:
    """The verdicts with the changed linear equations that have all stated amplitudes, or else each wrong one."""
    from lagrange.answers.results.amplitudes import explained_amplitudes

    values = dict(reference.values)
    stated = [(p.text, *claims[p.text]) for p in parts if p.text in claims]
    wrong = [p.text for p in parts if p.verdict is Verdict.WRONG and p.text in claims]
    if not wrong:
        return [*parts]

    def cause(those: Sequence[tuple[str, str, sp.Expr]]) -> str:
        amplitudes = {q: as_written(value).xreplace(values) for _, q, value in those}
        return next(filter(None, (explained_amplitudes(amplitudes, r) for r in responses)), "")

    together = cause(stated) if len(stated) > 1 else ""
    causes = {text: together or cause([s for s in stated if s[0] == text]) for text in wrong}
    return [EquationVerdict.of(p.text, p.verdict, why) if (why := causes.get(p.text)) else p for p in parts]


def _solved(
    fragment: GivenEquation, working: Working, coordinates: Sequence[sp.Symbol], reference: Reference
) -> tuple[sp.Symbol, sp.Expr] | None:
    """The coordinate and the amplitude that an equation states, with an undeclared name for it: X/a = ..."""
    errors = fragment.reading.error.diagnostics if fragment.reading.error else ()
    names = {m[1] for d in errors if (m := re.match(r"`(\w+)` is not declared", d.message))}
    amplitudes = _amplitudes(dict.fromkeys(names, sp.S.Zero), coordinates)
    if len(names) != 1 or not amplitudes:
        return None
    unknown = sp.Symbol("amplitude", positive=True)
    scalars = {**reference.scope.scalars, **working.defined, next(iter(names)): unknown}
    reading = read_as_written(Fragment.of(fragment.reading.text), replace(reference.scope, scalars=scalars))
    if reading.error or len(reading.components) != 1:
        return None
    [e] = reading.components
    slope = e.diff(unknown)
    if slope == 0 or slope.has(unknown):
        return None
    return next(iter(amplitudes.values())), sp.expand(unknown - e / slope)


def _undamped(
    working: Working,
    coordinates: Sequence[sp.Symbol],
    responses: Sequence[Response],
    trials: Mapping[str, sp.Symbol],
) -> dict[sp.Symbol, tuple[sp.Symbol, sp.Expr]]:
    """Names that the answer uses for amplitudes with their signs, each with its coordinate and its value."""
    signed = {q: c for r in responses if not any(r.sines) for q, c in zip(r.by_coordinate, r.cosines, strict=True)}
    named = {**_amplitudes({s.name: sp.S.Zero for s in working.unknowns}, coordinates), **trials}
    return {s: (q, signed[q]) for s in working.unknowns if (q := named.get(s.name)) in signed and q is not None}


def _amplitudes(defined: Mapping[str, sp.Expr], coordinates: Sequence[sp.Symbol]) -> dict[str, sp.Symbol]:
    """Which of the names that an answer defines are amplitudes, and of which coordinate."""
    amplitudes: dict[str, sp.Symbol] = {}
    for name, value in defined.items():
        if t in value.free_symbols or any(base(s) in coordinates for s in value.free_symbols):
            continue
        letter, _, index = name.partition("_")
        for n, q in enumerate(coordinates, 1):
            plain = q.name.lower().replace("_", "")
            mine = {plain, f"a{plain}", f"{plain}max", f"{plain}0", f"{plain}p", f"{plain}hat", f"{plain}amp"}
            is_numbered = index == str(n) and len(coordinates) > 1 and letter in ("A", "X", "a", "B")
            if name.lower().replace("_", "") in mine or is_numbered:
                amplitudes[name] = q
        if name not in amplitudes and len(coordinates) == 1 and _AMPLITUDES.fullmatch(name):
            amplitudes[name] = coordinates[0]
    return amplitudes


def _motion(
    fragment: GivenEquation, responses: Sequence[Response], coordinates: Sequence[sp.Symbol], reference: Reference
) -> tuple[sp.Symbol, Judged] | None:
    """The coordinate and the verdict, if an equation gives a coordinate as a function of time."""
    sides = fragment.reading.sides
    for q, value in (sides, sides[::-1]) if len(sides) == 2 else ():
        if not isinstance(q, sp.Symbol) or q not in coordinates or not isinstance(value, sp.Expr):
            continue
        if any(base(s) in coordinates for s in value.free_symbols):
            return None
        if t not in value.free_symbols:
            return q, judged_amplitude(value, q.name, responses, reference)
        return q, _judged_motion(q, value, responses, reference)
    return None


def _judged_motion(q: sp.Symbol, value: sp.Expr, responses: Sequence[Response], reference: Reference) -> Judged:
    """The verdict on x(t)."""
    response = next(r for r in responses if q in r.by_coordinate)
    motion = dict(zip(response.by_coordinate, response.motions, strict=True))[q]
    try:
        if _PHASE in value.free_symbols:
            wave = sp.expand(sp.expand_trig(value))
            angle = response.drive.frequency * t
            a, b = wave.coeff(sp.cos(angle)), wave.coeff(sp.sin(angle))
            if is_zero(wave - a * sp.cos(angle) - b * sp.sin(angle)) is not True:
                return Verdict.UNDECIDED, UNDECIDED
            verdict, why = judged_amplitude(sp.sqrt(a**2 + b**2), q.name, responses, reference)
            return verdict, _LAG_OPEN if verdict is Verdict.EQUIVALENT else why
        difference = (value - motion).xreplace(dict(reference.values))
        same = is_zero(as_written(difference))
        if same is False and decimals_in([difference]):
            same = numbers_rounding_to([difference]) is not None
        if same is None and difference.has(sp.atan, sp.acos, sp.asin):
            same = is_zero(sp.expand(sp.expand_trig(difference)))
    except DivisionByZeroError:
        return Verdict.UNDECIDED, UNDECIDED
    if same is not True and difference.has(sp.atan):
        return _with_tangent(q, value, response, responses, reference)
    if same is None:
        return Verdict.UNDECIDED, UNDECIDED
    return (Verdict.EQUIVALENT, "") if same else (Verdict.WRONG, _NOT_STEADY)


def _with_tangent(
    q: sp.Symbol, value: sp.Expr, response: Response, responses: Sequence[Response], reference: Reference
) -> Judged:
    """The verdict on A cos(ω t − φ) with φ given by its tangent, which leaves its quadrant open."""
    wave = sp.expand(sp.expand_trig(value))
    angle = response.drive.frequency * t
    a, b = wave.coeff(sp.cos(angle)), wave.coeff(sp.sin(angle))
    verdict, why = judged_amplitude(sp.sqrt(a**2 + b**2), q.name, responses, reference)
    n = list(response.by_coordinate).index(q)
    aligned = is_zero((a * response.sines[n] - b * response.cosines[n]).xreplace(dict(reference.values)))
    if verdict is not Verdict.EQUIVALENT or aligned:
        return verdict, _QUADRANT if verdict is Verdict.EQUIVALENT else why
    return (Verdict.UNDECIDED, UNDECIDED) if aligned is None else (Verdict.WRONG, _NOT_STEADY)
