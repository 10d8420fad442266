"""Claims that something happens under a condition: rolling, sliding, tipping, coming back, a position that exists.

    It does not slip if μ ≥ tan α/2.             |F| ≤ μ N of what keeps it from slipping
    It begins to slide if tan α > μ.             friction in neither sense stops it
    It stays on the road if v² < g a.            the force of the contact is positive
    It tips before it slides if μ > b/h.         the order of two limits of rest, as one force grows
    The ball comes back if R w > 5/2 v.          the velocity that is asked for is negative
    ... is only possible if φ'² > g/l            |cos θ| ≤ 1 in cos θ = g/(l φ'²)
    If M > m then r'' < 0 at all times.          in random states of motion

Each is compared with what the solution has, at random values of the parameters on both sides of the limits.
"""

from __future__ import annotations

import random
import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.answers.claims.sentences import Relation, Sentence
from lagrange.answers.claims.trying import Outcome, Values, agree, drawn, holds, tried
from lagrange.answers.limits import LONGEST_LINEARIZED, MOST_SOLVED, STATES_OF_MOTION
from lagrange.answers.references import Reference
from lagrange.answers.verdicts import EquationVerdict, Verdict
from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import prime, symbols_in
from lagrange.document.math_writer import text
from lagrange.expressions.scope import Scope
from lagrange.mechanics.equilibrium.friction.conditions_of_rest import RestCondition
from lagrange.mechanics.results import InCoordinates, Solution
from lagrange.problem.model import Friction

_NOT = r"\b(?:not|no|never|without|cannot|nicht|kein\w*|ohne|nie)\b|n['’]t\b"
_SLIP = re.compile(r"\b(?:slip|slid|skid|rutsch|gleit)\w*", re.IGNORECASE)
_ROLL = re.compile(r"\b(?:roll|haft|stick)\w*", re.IGNORECASE)
_NEGATED_SLIP = re.compile(rf"(?:{_NOT})\s*(?:\w+\s+){{0,3}}(?:slip|slid|skid|rutsch|gleit)\w*", re.IGNORECASE)
_STAYS = re.compile(
    r"\b(?:stays?|remains?|can\s+be|is|bleibt)\s+(?:\w+\s+)?(?:at\s+rest|liegen|in\s+ruhe)\b", re.IGNORECASE
)
_KEEPS = re.compile(
    r"\b(?:stays?|remains?)\s+(?:on|in\s+contact)\b|\bkeeps?\s+contact\b|\bbleibt\s+auf\b", re.IGNORECASE
)
_LEAVES = re.compile(r"\b(?:leaves?|lifts?\s+off|loses?\s+contact|takes?\s+off|hebt\b.*\bab|verlässt)\b", re.IGNORECASE)
_TIP = re.compile(r"\b(?:tip|tilt|topple|overturn|kipp)\w*", re.IGNORECASE)
_FIRST = re.compile(r"\bfirst\b|\bzuerst\b", re.IGNORECASE)
_BEFORE = re.compile(r"\b(?:before|rather\s+than|instead\s+of|sooner\s+than|bevor|eher\s+als)\b", re.IGNORECASE)
_BACK = re.compile(
    r"\b(?:comes?|rolls?|goes|moves?|runs?|kommt|rollt|läuft)\s+(?:\w+\s+)?(?:back|backwards?|zurück)\b"
    r"|\breturns?\b|\breverses?\b|\bkehrt\b",
    re.IGNORECASE,
)
_EXISTS = re.compile(
    r"(?:possible|exists?|occurs?|möglich|existier\w*|there\s+(?:is|are)\b[^…]{0,60}|gibt\s+es\b[^…]{0,60})"
    r"\s*(?:,\s*)?(?:only|nur)?\s*(?:if|for|when|as\s+long\s+as|provided(?:\s+that)?|where|wenn|falls|für)\s*,?\s*…",
    re.IGNORECASE,
)
_ALWAYS = re.compile(
    r"\b(?:always|at\s+all\s+times|at\s+any\s+time|never|whatever|in\s+any\s+case|immer|stets|jederzeit|nie)\b",
    re.IGNORECASE,
)
_IS_NOT = re.compile(_NOT, re.IGNORECASE)

_ROLLING = "it rolls without slipping as long as |F| <= mu N with the friction {}"
_RIGHT_LIMIT = "that is the limit, but the inequality has the wrong sense"
_NOT_WHERE = "it is not this condition that decides it"
_CONTACT = "contact lasts as long as the force that presses is positive"
_SLIDES = "it begins to slide where the force along the contact is greater than mu N, both taken at rest"
_NOT_ALWAYS = "it does not hold in every state of motion"


def on_conditions(
    sentence: Sentence, before: Sequence[Sentence], solution: Solution, reference: Reference
) -> EquationVerdict | None:
    """The verdict on what a sentence says happens under a condition; None if that cannot be judged.

    before  the sentences that precede it
    """
    if not sentence.inequalities:
        return None
    for judged in (_on_order, _on_rolling, _on_sliding, _on_contact, _on_return, _on_accelerations):
        if (verdict := judged(sentence, solution, reference)) is not None:
            return verdict
    return _on_existence(sentence, before, solution, reference)


def _conditions(sentence: Sentence, scope: Scope) -> list[sp.Expr] | None:
    read = [r.positive(scope) for r in sentence.inequalities]
    return None if None in read else [e for e in read if e is not None]


def _verdict(
    sentence: Sentence, stated: Sequence[sp.Expr], truths: Sequence[sp.Expr], solution: Solution,
    where: Sequence[sp.Expr] = (), why: str = "",
) -> EquationVerdict | None:  # fmt: skip
    """The verdict on conditions that must hold exactly where one of the truths is positive."""
    outcomes = [agree(stated, truth, solution, where) for truth in truths]
    if Outcome.TRUE in outcomes:
        return EquationVerdict.of(sentence.shown, Verdict.EQUIVALENT, "")
    if not outcomes or Outcome.OPEN in outcomes:
        return None
    reason = _RIGHT_LIMIT if outcomes == [Outcome.FALSE] else why or _NOT_WHERE
    return EquationVerdict.of(sentence.shown, Verdict.WRONG, reason)


def _on_rolling(sentence: Sentence, solution: Solution, reference: Reference) -> EquationVerdict | None:
    """It rolls without slipping: |F| ≤ μ N, where the constraints give F and N."""
    slips, rolls = _SLIP.search(sentence.words), _ROLL.search(sentence.words)
    reactions = solution.own.dynamics.reactions if solution.own.dynamics else None
    if not (slips or rolls) or reactions is None or _BACK.search(sentence.words):
        return None
    turning = {
        n: s for n, s in reactions.sizes.items() if any(not m.is_zero for m in reactions.couples.get(n, {}).values())
    }
    pressing = {n: s for n, s in reactions.sizes.items() if n not in turning}
    if len(turning) != 1 or len(pressing) != 1:
        return None
    [friction], [pressed] = turning.values(), pressing.values()
    names = {n for r in sentence.inequalities for n in r.unknown_names(reference.scope)}
    if len(names) > 1:
        return None
    own = {n: sp.Symbol(n, positive=True) for n in names}
    scope = replace(reference.scope, scalars={**reference.scope.scalars, **own})
    stated = _conditions(sentence, scope)
    forces = friction.free_symbols | pressed.free_symbols
    coefficients = {s for e in stated or () for s in e.free_symbols} - forces
    if not stated or len(coefficients) != 1:
        return None
    [mu] = coefficients
    truth = mu * sp.Abs(pressed) - sp.Abs(friction)
    slipping = slips is not None and _NEGATED_SLIP.search(sentence.words) is None
    why = _ROLLING.format(f"|F| = {text(sp.Abs(friction))}, N = {text(pressed)}")
    return _verdict(sentence, stated, [-truth if slipping else truth], solution, [pressed], why)


def _on_sliding(sentence: Sentence, solution: Solution, reference: Reference) -> EquationVerdict | None:
    """It begins to slide from rest, or stays there.

    With friction of its full size in either sense, the slip is accelerated in the same sense: no smaller one stops it.
    """
    stays = _STAYS.search(sentence.words)
    stated = _conditions(sentence, reference.scope) if stays or _SLIP.search(sentence.words) else None
    rubbing = [f for f in solution.problem.forces if isinstance(f, Friction)]
    if not stated or not rubbing or solution.chosen.dynamics is None:
        return None
    slots = solution.chosen.configuration.slots
    if any(not e.free_symbols.isdisjoint(slots.velocities) for e in stated):
        return None  # while it slides down, x' > 0
    reactions, slips = solution.chosen.dynamics.reactions, solution.chosen.dynamics.slips
    pressed = [s for n, s in (reactions.sizes if reactions else {}).items() if n in {f.constraint for f in rubbing}]
    solved = accelerations(solution.chosen)
    slips = slips or (slots.velocities if len(slots.velocities) == 1 else ())
    opposite = {s: -s for f in rubbing for s in f.coefficient.free_symbols}
    still = dict.fromkeys(slots.velocities, sp.S.Zero)
    truths = []
    for slip in slips:
        rate = slip.xreplace(dict(zip(slots.velocities, slots.accelerations, strict=True)))
        if not rate.free_symbols & {*slots.accelerations} <= solved.keys():
            return None
        rate = rate.xreplace(solved).xreplace(still)
        truths.append(rate * rate.xreplace(opposite))
    if stays or _NEGATED_SLIP.search(sentence.words):
        truths = [-truth for truth in truths]
    return _verdict(sentence, stated, truths, solution, pressed, _SLIDES)


def accelerations(view: InCoordinates) -> dict[sp.Symbol, sp.Expr]:
    """The accelerations in terms of positions and velocities, as far as they are short."""
    slots, dynamics = view.configuration.slots, view.dynamics
    known = dict(dynamics.solved) if dynamics else {}
    if dynamics and dynamics.reactions:
        known |= {s: e for s, e in dynamics.reactions.accelerations.items() if e is not None}
    if view.motion is None or known or len(slots.coordinates) > MOST_SOLVED:
        return known
    rates = slots.accelerations
    equations = [*view.motion.expressions]
    for row in view.configuration.rows:
        terms = (c * v for c, v in zip(row.coefficients, slots.velocities, strict=True))
        equations.append(slots.time_derivative(sp.Add(*terms, row.drift)))
    mass = sp.Matrix([[e.diff(s) for s in rates] for e in equations])
    force = sp.Matrix([-e.xreplace(dict.fromkeys(rates, sp.S.Zero)) for e in equations])
    if (
        mass.rows != mass.cols
        or mass.free_symbols & {*rates}
        or any(count_operations(e) > LONGEST_LINEARIZED for e in force)
    ):
        return known
    solution = mass.adjugate() * force / mass.det()
    return dict(zip(rates, solution, strict=True))


def _on_contact(sentence: Sentence, solution: Solution, reference: Reference) -> EquationVerdict | None:
    """It stays in contact: the force of the contact is positive, where parameters alone decide it."""
    keeps, leaves = _KEEPS.search(sentence.words), _LEAVES.search(sentence.words)
    stated = _conditions(sentence, reference.scope) if keeps or leaves else None
    newton = solution.law.newton if solution.law else None
    names = {s.name for r in (newton.reactions if newton else ()) for s in (r.multiplier, r.symbol) if s is not None}
    asked = [a for a in solution.asked if len(a.branches) == 1 and str(a.question.quantity) in names]
    if not stated or len(asked) != 1:
        return None
    force = asked[0].branches[0].rhs
    if not force.free_symbols <= {*reference.parameters.values()} or force.is_positive or force.is_negative:
        return None
    holds_on = (keeps is not None) is (_IS_NOT.search(sentence.words) is None)
    return _verdict(sentence, stated, [force if holds_on else -force], solution, why=_CONTACT)


def is_no_result(text_: str, solution: Solution) -> bool:
    """Whether a line with an inequality claims something beside the results.

    It says which limit of rest comes first, or where something that moves stays at rest, and the file asks for no rest.
    """
    verbs = bool(_TIP.search(text_)) + bool(_SLIP.search(text_))
    order = (verbs == 2 and _BEFORE.search(text_) is not None) or (verbs > 0 and _FIRST.search(text_) is not None)
    moves = all(v.at_rest is None for v in solution.views) and solution.own.motion is not None
    return order or (moves and _STAYS.search(text_) is not None)


def _on_order(sentence: Sentence, solution: Solution, reference: Reference) -> EquationVerdict | None:
    """It tips before it slides: which of two limits of rest a growing force reaches first."""
    tips, slides = _TIP.search(sentence.words), _SLIP.search(sentence.words)
    at_rest = next((v.at_rest for v in solution.views if v.at_rest is not None), None)
    if at_rest is None or len(at_rest.cases) != 1 or not (tips or slides):
        return None
    verbs = [m for m in (tips, slides) if m is not None]
    before, first = _BEFORE.search(sentence.words), _FIRST.search(sentence.words)
    if before is not None and len(verbs) == 2:
        tips_first = tips.start() < slides.start()  # type: ignore[union-attr]
    elif first is not None and len(verbs) == 1:
        tips_first = tips is not None
    else:
        return None
    stated = _conditions(sentence, reference.scope)
    rough = {s for f in solution.problem.forces if isinstance(f, Friction) for s in _coefficients(f)}
    limits = {k: [c for c in at_rest.cases[0] if bool(_symbols(c) & rough) is k] for k in (True, False)}
    if not stated or any(len(each) != 1 for each in limits.values()):
        return None
    [sliding], [tipping] = limits[True], limits[False]
    used = {s for e in stated for s in e.free_symbols}
    truths = [
        t
        for s in sorted((_symbols(sliding) & _symbols(tipping)) - used, key=str)
        if (t := _sooner(tipping, sliding, s))
    ]
    return _verdict(sentence, stated, [t if tips_first else -t for t in truths[:1]], solution)


def _coefficients(friction: Friction) -> set[sp.Symbol]:
    return {s for e in (friction.coefficient, friction.static) if e is not None for s in e.free_symbols}


def _symbols(condition: RestCondition) -> set[sp.Symbol]:
    return {*condition.left.free_symbols, *condition.right.free_symbols}


def _sooner(one: RestCondition, other: RestCondition, load: sp.Symbol) -> sp.Expr | None:
    """What is positive where the first limit is reached before the other as a load grows; None if it is not known."""
    limits = []
    for condition in (one, other):
        slack = sp.expand(sp.numer(sp.together(condition.right - condition.left)))
        slope = slack.diff(load)
        if load in slope.free_symbols or slope.is_negative is not True:
            return None
        limits.append(-slack.xreplace({load: sp.S.Zero}) / slope)
    return limits[1] - limits[0]


def _on_return(sentence: Sentence, solution: Solution, reference: Reference) -> EquationVerdict | None:
    """It comes back: the velocity that is asked for is negative, where it may have either sign."""
    stated = _conditions(sentence, reference.scope) if _BACK.search(sentence.words) else None
    rates = {*solution.problem.slots.velocities}
    asked = [a for a in solution.asked if a.question.quantity in rates and len(a.branches) == 1]
    if not stated or len(asked) != 1:
        return None
    velocity = asked[0].branches[0].rhs
    if not velocity.free_symbols <= {*reference.parameters.values()} or velocity.is_positive or velocity.is_negative:
        return None
    sense = 1 if _IS_NOT.search(sentence.words) else -1
    why = f"it comes back where {asked[0].question.quantity} is negative at the end"
    return _verdict(sentence, stated, [sense * velocity], solution, why=why)


def _on_accelerations(sentence: Sentence, solution: Solution, reference: Reference) -> EquationVerdict | None:
    """Inequalities for accelerations, in random states of motion that satisfy the other conditions."""
    if not _ALWAYS.search(sentence.words) or solution.chosen.dynamics is None:
        return None
    slots = solution.chosen.configuration.slots
    stated = _conditions(sentence, reference.scope) or []
    rewritten = [solution.chosen.configuration.rewritten(e) for e in stated]
    known = {*slots.accelerations}
    solved = accelerations(solution.chosen)
    claims = [e for e in rewritten if e.free_symbols & known]
    conditions = [e for e in rewritten if not e.free_symbols & known]
    if not claims or sentence.equations or any({*c.free_symbols} & known - solved.keys() for c in claims):
        return None
    claims = [c.xreplace(solved) for c in claims]
    moving = {*slots.coordinates, *slots.velocities}
    symbols = {s for e in (*claims, *conditions) for s in symbols_in(e)}
    if not symbols <= moving | {*reference.parameters.values()}:
        return None
    angles = {s for e in claims for f in e.atoms(sp.sin, sp.cos, sp.tan) for s in f.args[0].free_symbols}
    draw = random.Random(17)

    def states() -> Iterator[Values]:
        for _ in range(STATES_OF_MOTION):
            values = drawn(symbols - moving, angles, draw)
            for s in sorted(symbols & moving, key=str):
                values[s] = draw.uniform(-3.1, 3.1) if s in angles else draw.lognormvariate(0, 0.8)
                values[s] *= draw.choice((1, -1)) if s in slots.velocities else 1
            yield values

    def trial(values: Values) -> Iterator[bool | None]:
        yield holds(claims, values) if not conditions or holds(conditions, values) else None

    outcome = tried(states(), trial, STATES_OF_MOTION)
    if outcome in (Outcome.FALSE, Outcome.SOMETIMES):
        return EquationVerdict.of(sentence.shown, Verdict.WRONG, _NOT_ALWAYS)
    return EquationVerdict.of(sentence.shown, Verdict.EQUIVALENT, "") if outcome is Outcome.TRUE else None


def _on_existence(
    sentence: Sentence, before: Sequence[Sentence], solution: Solution, reference: Reference
) -> EquationVerdict | None:
    """A position exists: its sine or cosine is between −1 and 1."""
    match = _EXISTS.search(sentence.words)
    if match is None:
        return None
    relation = _relation_at(sentence, match)
    stated = relation.positive(reference.scope) if relation is not None else None
    if stated is None:
        return None
    bounded = [e for r in sentence.equations if (e := _bounded(r, reference)) is not None]
    for other in reversed(before):
        bounded = bounded or [e for r in other.equations if (e := _bounded(r, reference)) is not None]
    truths = [1 - e**2 for e in bounded]
    if _IS_NOT.search(sentence.words[: match.end()]):
        truths = [-truth for truth in truths]
    return _verdict(sentence, [stated], truths, solution)


def _relation_at(sentence: Sentence, match: re.Match[str]) -> Relation | None:
    """The inequality at the end of a match in the words of a sentence."""
    number = sentence.words.count("…", 0, match.end()) - 1
    relation = sentence.relations[number] if number < len(sentence.relations) else None
    return relation if relation is not None and relation.is_inequality else None


def _bounded(relation: Relation, reference: Reference) -> sp.Expr | None:
    """X of `cos q = X`, or of a sine, for a coordinate q that occurs nowhere else; None for other equations."""
    reading = relation.reading(reference.scope)
    if reading.error is not None or len(reading.components) != 1:
        return None
    [e] = reading.components
    coordinates = e.free_symbols & {*reference.scope.slots.coordinates}
    rates = {prime(q) for q in reference.scope.slots.coordinates}
    waves = [f for f in e.atoms(sp.sin, sp.cos) if f.args[0] in coordinates]
    allowed = coordinates | rates | {*reference.parameters.values()}
    if len(coordinates) != 1 or len(waves) != 1 or not e.free_symbols <= allowed:
        return None
    z = sp.Dummy("z")
    replaced = sp.numer(sp.together(e.xreplace({waves[0]: z})))
    slope = replaced.diff(z)
    if replaced.free_symbols & coordinates or slope == 0 or z in slope.free_symbols:
        return None
    return -replaced.xreplace({z: sp.S.Zero}) / slope
