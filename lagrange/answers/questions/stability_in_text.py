"""Statements on stability beside positions of equilibrium: are they true?

    theta = 0, stable for W < c h        theta = pi is unstable        sin(theta) = M/m, stable if cos(theta) > 0

A claim is tried at random values of the parameters, at every position that its equation describes and that exists
there, against the second variation of the potential energy. A position that is called stable under a condition is meant
to be unstable elsewhere. Where V'' has no clear sign the claim is not judged. A claim without a condition that is true
for some values of the parameters only lacks its condition.

Sentences on stability without an equation for the position they are about.

    The upright position is stable for W l < c b^2 and unstable for W l > c b^2.      stable as long as Ω² < g/R

They are right if they are true at one of the equilibria, at random values of the parameters; the feedback says which. A
condition alone is meant to be decisive: where it fails, the equilibrium is unstable.
"""

from __future__ import annotations

import random
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import mpmath
import sympy as sp

from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.answers.limits import CLEAR_STABILITY, ENOUGH_PLACES, SENTENCE_SAMPLES, STABILITY_SAMPLES
from lagrange.answers.questions.texts.frequency_labels import stated_position
from lagrange.answers.readings import GivenEquation
from lagrange.answers.references import Reference, reference_of_solution
from lagrange.answers.results.at_random import beside_limit
from lagrange.answers.verdicts import AnswerVerdict, EquationVerdict, Judgement, Verdict
from lagrange.answers.written.reading import read_as_written
from lagrange.answers.written.values import WHEN
from lagrange.core.diagnostics import Fragment, ProblemError
from lagrange.core.records import record
from lagrange.core.symbols import base, symbols_in
from lagrange.expressions.reader import is_inequality, limit_of
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from lagrange.mechanics.equilibrium.linearization import Linearization
from lagrange.mechanics.results import InCoordinates, Solution

WRONG_STABILITY = "the claim about its stability is wrong"
ONLY_SOMETIMES = "it is {} for some values of the parameters only: the condition is missing"
WORD = re.compile(
    r"(?<![^\W\d_])(?P<not>un|in|not\s+|non[- ]|nicht\s+)?(?P<word>stab(?:le|il)|labil)(?![^\W\d_])", re.IGNORECASE
)
CONDITION = re.compile(
    rf"[^<>≤≥=]*?(?<![^\W\d_]){WHEN}\s+(?P<text>.*[<>≤≥].*)",
    re.IGNORECASE | re.DOTALL,
)
ENDS = re.compile(
    r"[;\n]|,(?=\s)|\.(?=\s|$)|\s(?:and|but|otherwise|else|while|whereas|sonst|und|aber)\s", re.IGNORECASE
)
AMBIGUOUS = re.compile(r"marginal|neutral|indiff|metastab", re.IGNORECASE)


@record
class _Claim:
    stable: bool
    condition: sp.Expr | None = None  # that it is stable, or unstable, where this is positive


def on_stability(judged: Sequence[Fragment], solution: Solution, reference: Reference) -> dict[int, tuple[bool, str]]:
    """Place of an equation in the answer -> whether its stability is stated wrongly, and how."""
    views = [v for v in solution.views if v.equilibrium is not None and v.stability is not None]
    said: dict[int, tuple[bool, str]] = {}
    for n, fragment in enumerate(judged):
        if not isinstance(fragment, GivenEquation):
            continue
        claim = _claim(fragment, reference)
        if claim is None:
            continue
        for view in views:
            used = {s for e in fragment.reading.components for s in symbols_in(e)}
            moving = set(reference.scope.slots.coordinates)
            if not used & moving <= set(view.configuration.slots.coordinates):
                continue
            true, false = _tried(fragment.reading.components, claim, view, reference.values)
            if false and (not true or claim.condition is not None):
                said[n] = True, WRONG_STABILITY
            elif false:
                said[n] = False, ONLY_SOMETIMES.format("stable" if claim.stable else "unstable")
            if true or false:
                break
    return said


def with_stability(
    verdict: AnswerVerdict, judged: Sequence[Fragment], solution: Solution, reference: Reference
) -> AnswerVerdict:
    """The verdict on positions of equilibrium, with that on their stated stability."""
    equations, whole = list(verdict.equations), verdict.verdict
    for place, (is_wrong, why) in on_stability(judged, solution, reference).items():
        stated = _text(judged[place])
        later = sum(_text(f) == stated for f in judged[place + 1 :])  # the same position may be in a list before it
        found = [n for n, e in enumerate(equations) if e.text == stated][::-1]
        worse = Verdict.WRONG if is_wrong else Verdict.INCOMPLETE
        if later < len(found) and equations[found[later]].verdict is Verdict.EQUIVALENT:
            equations[found[later]] = EquationVerdict.of(stated, worse, why)
        elif not found:
            equations.append(EquationVerdict.of(stated, worse, why))
        else:
            continue
        whole = worse if whole in (Verdict.EQUIVALENT, Verdict.INCOMPLETE) else whole
    return replace(verdict, verdict=whole, equations=tuple(equations))


def _text(fragment: Fragment) -> str:
    return fragment.reading.text if isinstance(fragment, GivenEquation) else fragment.text.strip()


def _claim(fragment: Fragment, reference: Reference) -> _Claim | None:
    """The claim about stability that accompanies an equation; None unless there is exactly one."""
    return _claim_in(getattr(fragment, "beside", ""), reference)


def _claim_in(words: str, reference: Reference) -> _Claim | None:
    matches = [*WORD.finditer(words)]
    if not matches or AMBIGUOUS.search(words):
        return None
    kinds = {bool(m["not"]) or m["word"].lower() == "labil" for m in matches}
    first = matches[0]
    rest = words[first.end() : matches[1].start() if len(matches) > 1 else len(words)]
    otherwise = re.search(r"otherwise|else|if\s+not|sonst", words[first.end() :], re.IGNORECASE)
    conditional = CONDITION.match(rest)
    if len(matches) > 2 or (len(kinds) > 1 and not (conditional and otherwise)):
        return None
    stable = not (first["not"] or first["word"].lower() == "labil")
    if conditional is None:
        return _Claim(stable) if not is_inequality(Fragment.of(rest)) else None
    text = ENDS.split(conditional["text"])[0].strip(" .]")
    text = text.rstrip(")") if text.count(")") > text.count("(") else text
    try:
        limit, side = limit_of(Fragment.of(text), "a condition", strict=True)
    except ProblemError:
        return None
    reading = read_as_written(limit, reference.scope)
    if reading.error is not None or len(reading.components) != 1:
        return None
    return _Claim(stable, reading.components[0] * (side or 1))


def _tried(
    components: Sequence[sp.Expr], claim: _Claim, view: InCoordinates, values: Mapping[sp.Symbol, sp.Rational]
) -> tuple[int, int]:
    """At how many random places a claim is true, and at how many false."""
    assert view.stability is not None
    true = false = 0
    for state in _places(view, components, claim, values):
        if any(
            abs(residual) > CLEAR_STABILITY
            for residual in _numbers([view.configuration.rewritten(e) for e in components], state)
        ):
            continue
        entries = [_numbers(row, state) for row in view.stability.matrix]
        if any(len(row) < len(entries) for row in entries):
            continue
        stable = is_stable(sp.Matrix(entries))
        holds: bool | None = True
        if claim.condition is not None:
            numbers = _numbers([claim.condition], state)
            holds = None if not numbers or abs(numbers[0]) < CLEAR_STABILITY else bool(numbers[0] > 0)
        if stable is None or holds is None:
            continue
        right = stable is (claim.stable if holds else not claim.stable)
        true, false = true + right, false + (not right)
        if true + false >= ENOUGH_PLACES:
            break
    return true, false


def is_stable(hessian: sp.Matrix) -> bool | None:
    """Whether a matrix of numbers is positive definite; None if that is not clear."""
    minors = [hessian[:n, :n].det() for n in range(1, hessian.rows + 1)]
    return None if any(abs(m) < CLEAR_STABILITY for m in minors) else all(m > 0 for m in minors)


def _places(
    view: InCoordinates,
    components: Sequence[sp.Expr],
    claim: _Claim,
    values: Mapping[sp.Symbol, sp.Rational],
) -> Iterator[dict[sp.Symbol, sp.Expr]]:
    """Random parameters, with each position of equilibrium that exists there."""
    e, stability = view.equilibrium, view.stability
    assert e is not None
    assert stability is not None
    coordinates = e.configuration.slots.coordinates
    everything = [*e.required, *components, *(m for row in stability.matrix for m in row)]
    everything += [claim.condition] if claim.condition is not None else []
    parameters = sorted({s for x in everything for s in x.free_symbols} - {*coordinates}, key=str)
    angles = {s for x in everything for f in x.atoms(sp.sin, sp.cos, sp.tan) for s in f.args[0].free_symbols}
    draw = random.Random(7)
    for _ in range(STABILITY_SAMPLES):
        state: dict[sp.Symbol, sp.Expr] = {}
        for s in parameters:
            number = draw.uniform(0.05, 1.5) if s in angles else draw.lognormvariate(0, 0.8)
            state[s] = sp.Float(values.get(s, number))
        beside = () if claim.condition is None else beside_limit(claim.condition, state, values)
        for moved in (state, *beside):
            for branch in e.branches:
                for point in branch.points:
                    letters = {k: e.solution.letters.write(v) for k, v in point.items()}
                    position = position_at(letters, coordinates, moved)
                    if position is None:
                        continue
                    for turns in (0, 1, -1) if angles & {*coordinates} else (0,):
                        yield moved | {
                            q: p + turns * 2 * sp.pi.evalf() if q in angles else p for q, p in position.items()
                        }


def position_at(
    point: Mapping[sp.Expr, sp.Expr], coordinates: Sequence[sp.Symbol], state: Mapping[sp.Symbol, sp.Expr]
) -> dict[sp.Symbol, sp.Expr] | None:
    """The coordinates at a point of a branch, as numbers; None if it does not exist or leaves one open."""
    named = {str(k): v for k, v in point.items()}
    position: dict[sp.Symbol, sp.Expr] = {}
    for q in coordinates:
        written = [named.get(str(f)) for f in (sp.sin(q), sp.cos(q))]
        stated = (
            [v for v in written if v is not None] if None not in written else [named[q.name]] if q.name in named else []
        )
        numbers = _numbers(stated, state)
        if not stated or len(numbers) < len(stated):
            return None
        position[q] = sp.atan2(*numbers).evalf() if len(numbers) == 2 else numbers[0]
    return position


def _numbers(expressions: Sequence[sp.Expr], state: Mapping[sp.Symbol, sp.Expr]) -> list[sp.Expr]:
    """The numerical values of expressions, without those that are not real numbers."""
    numbers = [e.xreplace(dict(state)).evalf() for e in map(sp.Add, expressions)]
    return [v for v in numbers if v.is_real and v.is_finite]


# Sentences without an equation


_ABOUT = "it is taken to be about {}"
_NOWHERE = "this is true at none of the equilibria"
REVERSED = "the condition for stability has the wrong sense"


@record
class _Clause:
    """Stable, or unstable, where the condition is positive."""

    stable: bool
    condition: sp.Expr


@record
class _Place:
    """An equilibrium, and the matrix that is positive definite where it is stable.

    motion  M and D of M ξ'' + D ξ' + K ξ = 0, whose matrix K is, if there are terms with velocities
    """

    resting: Equilibrium
    branch: Branch
    matrix: sp.Matrix
    motion: tuple[sp.Matrix, sp.Matrix] | None = None

    @property
    def expressions(self) -> list[sp.Expr]:
        """Everything that stability depends on."""
        relations = [r.lhs - r.rhs for r in self.branch.relations]
        return [*self.resting.required, *self.matrix, *(e for m in self.motion or () for e in m), *relations]

    def is_stable(self, at: Mapping[sp.Symbol, sp.Expr]) -> bool | None:
        """Whether it is stable at values of the parameters; None if that is not clear."""
        matrices = [m.xreplace(dict(at)).evalf() for m in (self.matrix, *(self.motion or ()))]
        if any(not e.is_real for m in matrices for e in m):
            return None
        return is_stable(matrices[0]) if self.motion is None else _stays(*matrices)


def _stays(stiffness: sp.Matrix, mass: sp.Matrix, damping: sp.Matrix) -> bool | None:
    """Whether no motion exp(p t) near an equilibrium grows; None if that is not clear."""
    size = stiffness.rows
    try:
        inverse = mass.inv()
        lower = (-inverse * stiffness).row_join(-inverse * damping)
        rates = mpmath.eig(mpmath.matrix(sp.zeros(size).row_join(sp.eye(size)).col_join(lower).tolist()), right=False)
    except (ValueError, ZeroDivisionError, mpmath.NoConvergence):
        return None
    if min(map(abs, rates)) < CLEAR_STABILITY:
        return None
    return bool(max(mpmath.re(p) for p in rates) < CLEAR_STABILITY)


def is_about_stability(text_: str) -> bool:
    """Whether a text without equations says when something is stable."""
    return WORD.search(text_) is not None and is_inequality(Fragment.of(text_))


def check_stability_sentences(
    answer: Sequence[Fragment], solution: Solution, reference: Reference
) -> AnswerVerdict | None:
    """The verdict on such sentences; None if they are none, or cannot be understood."""
    places = [*_all_places(solution)]
    parts: list[EquationVerdict] = []
    for f in answer:
        clauses = _clauses(f.text, reference)
        if not clauses or not places:
            return None
        stated = " ".join(f.text.split())
        at = [p for p in places if _is_true(clauses, p)]
        if at:
            where = " or ".join(stated_position(p.branch) for p in at)
            parts.append(EquationVerdict(stated, Verdict.EQUIVALENT, remarks=(_ABOUT.format(where),)))
            continue
        opposite = [_Clause(not c.stable, c.condition) for c in clauses]
        why = REVERSED if any(_is_true(opposite, p) for p in places) else _NOWHERE
        parts.append(EquationVerdict.of(stated, Verdict.WRONG, why))
    wrong = any(p.verdict is Verdict.WRONG for p in parts)
    return AnswerVerdict(Verdict.WRONG if wrong else Verdict.EQUIVALENT, tuple(parts), name="stability")


_LABELLED = re.compile(r"(?P<place>[^:=]+=[^:=]+):(?P<value>[^:]+[,;]\s)?(?P<claim>[^,;:]+)")
_ALL = re.compile(r"\b(?:both|all|each|every|beide|alle|jede[rs]?|toutes|tous|les\s+deux)\b", re.IGNORECASE)
_ORDINALS = (r"first|former|erste|premi[eè]re?", r"second|zweite|deuxi[eè]me|seconde", r"third|dritte|troisi[eè]me")
_LAST = re.compile(r"\b(?:latter|last|letzte|derni[eè]re?)\b", re.IGNORECASE)
_SENTENCE = re.compile(
    rf"[;\n]|\.(?:\s|\Z)|,\s+(?=(?:and\s+)?(?:the|die|la)\s+(?:{'|'.join(_ORDINALS)}|other|latter))", re.I
)


def with_sentences_on_stability(answer: Sequence[Fragment], judged: Judgement, solution: Solution) -> Judgement:
    """The verdict on a text with that on its sentences on stability: `Both are stable.`, `The second is unstable.`"""
    if judged.verdict not in (Verdict.EQUIVALENT, Verdict.INCOMPLETE) or not answer:
        return judged
    sources = dict.fromkeys(f.whole.source for f in answer)
    sentences = [s for source in sources for s in _SENTENCE.split(source.text.replace("$", " ")) if WORD.search(s)]
    labelled = [m for s in sentences if (m := _LABELLED.fullmatch(s.strip())) is not None]
    sentences = [s for s in sentences if "=" not in s.replace("<=", "").replace(">=", "")]
    places = [*_all_places(solution)] if sentences or labelled else []
    if not places:
        return judged
    reference = reference_of_solution(solution)
    positions = [*_positions_in(answer, reference)]
    parts = [p for s in sentences if (p := _judged_sentence(s, positions, places, reference, solution)) is not None]
    parts += [p for m in labelled if (p := _judged_label(m, places, reference)) is not None]
    if not parts:
        return judged
    wrong = any(p.verdict is Verdict.WRONG for p in parts)
    verdict = AnswerVerdict(Verdict.WRONG if wrong else Verdict.EQUIVALENT, tuple(parts), name="stability")
    return replace(judged, others=(*judged.others, verdict))


def _judged_label(labelled: re.Match[str], places: Sequence[_Place], reference: Reference) -> EquationVerdict | None:
    """The verdict on `θ = 0: ω = √(g/l), stable for l > 0`: a claim on the position before the colon."""
    claim = _claim_in(labelled["claim"], reference)
    position = read_as_written(Fragment.of(labelled["place"]), reference.scope)
    if claim is None or position.error is not None:
        return None
    true = [t for p in places if (t := _holds_at(claim, position.components, p)) is not None]
    verdict = Verdict.EQUIVALENT if all(true) else Verdict.WRONG
    stated = f"{labelled['place'].strip()}: {labelled['claim'].strip()}"
    return EquationVerdict.of(stated, verdict, "" if all(true) else WRONG_STABILITY) if true else None


def _positions_in(answer: Sequence[Fragment], reference: Reference) -> Iterator[Sequence[sp.Expr]]:
    """What the equations of an answer between coordinates and parameters alone say, in their order."""
    from lagrange.answers.equilibria import alternatives_of

    for f in answer:
        for [one] in [] if is_inequality(f) else alternatives_of([f]):
            reading = read_as_written(one, reference.scope)
            symbols = {s for e in reading.components for s in symbols_in(e)}
            if reading.error is None and all(base(s) == s for s in symbols):
                yield reading.components


def _judged_sentence(
    sentence: str,
    positions: Sequence[Sequence[sp.Expr]],
    places: Sequence[_Place],
    reference: Reference,
    solution: Solution,
) -> EquationVerdict | None:
    """The verdict on one sentence on stability without an equation; None if it cannot be judged."""
    stated, claim = " ".join(sentence.split()), _claim_in(sentence, reference)
    before = sentence[: WORD.search(sentence).start()]  # type: ignore[union-attr]
    ordinal = next((n for n, o in enumerate(_ORDINALS) if re.search(rf"\b(?:{o})\b", before, re.IGNORECASE)), None)
    if claim is None:
        return None
    about: list[bool] = []
    known = []
    for position in positions:
        true = [t for p in places if (t := _holds_at(claim, position, p)) is not None]
        known += [any(true)] if true else []
    if _ALL.search(before):
        about = known
    elif ordinal is not None or _LAST.search(before):
        about = known[ordinal : ordinal + 1] if ordinal is not None else known[-1:]
    elif is_inequality(Fragment.of(sentence)):
        found = check_stability_sentences([Fragment.of(sentence)], solution, reference)
        return found.equations[0] if found is not None else None
    if not about:
        return None
    right = all(about)
    return EquationVerdict.of(stated, Verdict.EQUIVALENT if right else Verdict.WRONG, "" if right else WRONG_STABILITY)


def check_stability_beside(
    answer: Sequence[Fragment], solution: Solution, reference: Reference
) -> AnswerVerdict | None:
    """The verdict on claims beside positions, where small oscillations are asked for; None if there are none."""
    parts: list[EquationVerdict] = []
    for f in answer:
        claim = _claim(f, reference) if isinstance(f, GivenEquation) else None
        if claim is None or not isinstance(f, GivenEquation):
            continue
        true = [t for p in _all_places(solution) if (t := _holds_at(claim, f.reading.components, p)) is not None]
        if true:
            right = Verdict.EQUIVALENT if any(true) else Verdict.WRONG
            stated = f"{f.reading.text}, {f.beside}".strip(" ,;")
            parts.append(EquationVerdict.of(stated, right, "" if any(true) else WRONG_STABILITY))
    wrong = any(p.verdict is Verdict.WRONG for p in parts)
    whole = Verdict.WRONG if wrong else Verdict.EQUIVALENT
    return AnswerVerdict(whole, tuple(parts), name="stability") if parts else None


def _holds_at(claim: _Claim, components: Sequence[sp.Expr], place: _Place) -> bool | None:
    """Whether a claim is true at an equilibrium; None if its equations are not about this one, or it is not clear."""
    coordinates = place.resting.configuration.slots.coordinates
    moving = {*coordinates} & {s for e in components for s in e.free_symbols}
    conditions = [claim.condition] if claim.condition is not None else []
    everything = [*place.expressions, *components, *conditions]
    parameters = sorted({s for e in everything for s in e.free_symbols} - {*coordinates}, key=str)
    angles = {s for e in everything for f in e.atoms(sp.sin, sp.cos, sp.tan) for s in f.args[0].free_symbols}
    draw, found = random.Random(5), set()
    for _ in range(SENTENCE_SAMPLES if moving else 0):
        state: dict[sp.Symbol, sp.Expr] = {
            s: sp.Float(draw.uniform(0.05, 1.5) if s in angles else draw.lognormvariate(0, 0.8)) for s in parameters
        }
        beside = beside_limit(claim.condition, state) if claim.condition is not None else ()
        for stable, at in (s for moved in (state, *beside) for s in _states(place, coordinates, moved)):
            if any(abs(residual) > CLEAR_STABILITY for residual in _numbers(components, at)):
                return None
            holds = [e.xreplace(at).evalf() for e in conditions]
            if all(h.is_number and abs(h) >= CLEAR_STABILITY for h in holds):
                found.add(stable is (claim.stable if all(h > 0 for h in holds) else not claim.stable))
    return None if not found or (len(found) > 1 and not conditions) else found == {True}


def _clauses(stated: str, reference: Reference) -> list[_Clause]:
    """The clauses of a sentence on stability; none if a part of it cannot be read."""
    matches = [*WORD.finditer(stated)]
    clauses = []
    for n, match in enumerate(matches):
        rest = stated[match.end() : matches[n + 1].start() if n + 1 < len(matches) else len(stated)]
        conditional = CONDITION.match(rest)
        if conditional is None:
            if n > 0 and not is_inequality(Fragment.of(rest)):  # `unstable otherwise`
                continue
            return []
        try:
            limit, side = limit_of(Fragment.of(ENDS.split(conditional["text"])[0].strip(" .")), "", strict=True)
        except ProblemError:
            return []
        reading = read_as_written(limit, reference.scope)
        if reading.error is not None or len(reading.components) != 1:
            return []
        stable = not (match["not"] or match["word"].lower() == "labil")
        clauses.append(_Clause(stable, reading.components[0] * (side or 1)))
    return clauses


def _all_places(solution: Solution) -> Iterator[_Place]:
    for view in solution.views:
        if view.equilibrium is not None and view.stability is not None:
            for branch in view.equilibrium.branches:
                yield _Place(view.equilibrium, branch, sp.Matrix(view.stability.matrix))
        elif view.linearization is not None:
            yield from _places_about(view.linearization)
        if view.steady is not None:
            for family in view.steady.families:
                yield from _places_about(family.about)


def _places_about(linear: Linearization) -> Iterator[_Place]:
    for branch, s in zip(linear.branches, linear.at, strict=True):
        if s is not None:
            resting, mass, damping = s.system.stiffness, s.system.mass, s.system.damping
            moving = any(e != 0 for row in damping for e in row)
            motion = (sp.Matrix(mass), sp.Matrix(damping)) if moving else None
            yield _Place(linear.equilibrium, branch, sp.Matrix(resting), motion)


def _is_true(clauses: Sequence[_Clause], place: _Place) -> bool:
    """Whether the clauses are true at an equilibrium, which is stable in some cases and unstable in others."""
    coordinates = place.resting.configuration.slots.coordinates
    everything = [*place.expressions, *(c.condition for c in clauses)]
    parameters = sorted({s for e in everything for s in e.free_symbols} - {*coordinates}, key=str)
    angles = {s for e in everything for f in e.atoms(sp.sin, sp.cos, sp.tan) for s in f.args[0].free_symbols}
    draw, seen = random.Random(3), set()
    for _ in range(SENTENCE_SAMPLES):
        state: dict[sp.Symbol, sp.Expr] = {
            s: sp.Float(draw.uniform(0.05, 1.5) if s in angles else draw.lognormvariate(0, 0.8)) for s in parameters
        }
        beside = (moved for clause in clauses for moved in beside_limit(clause.condition, state))
        for stable, at in (s for moved in (state, *beside) for s in _states(place, coordinates, moved)):
            for clause in clauses:
                holds = clause.condition.xreplace(at).evalf()
                if not holds.is_number or abs(holds) < CLEAR_STABILITY or (holds < 0 and len(clauses) > 1):
                    continue
                if stable is not (clause.stable if holds > 0 else not clause.stable):
                    return False
                seen.add(stable)
    return len(seen) == 2


def _states(
    place: _Place, coordinates: Sequence[sp.Symbol], state: dict[sp.Symbol, sp.Expr]
) -> Iterator[tuple[bool, dict[sp.Symbol, sp.Expr]]]:
    """Whether the equilibrium is stable at values of the parameters, at each of its points that exist there."""
    for point in place.branch.points:
        letters = place.resting.solution.letters
        position = position_at({k: letters.write(v) for k, v in point.items()}, coordinates, state)
        if position is None:
            continue
        at = {**state, **position}
        stable = place.is_stable(at)
        if stable is not None:
            yield stable, at
