"""Questions about the motion: which integrals and conditions answer them, and which branch comes first."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import prime, t
from lagrange.document.derivation import (
    Block,
    Detail,
    Equation,
    Math,
    Part,
    Prose,
    Purpose,
    Ref,
    Rule,
    Step,
    display,
    listed,
    math,
    prose,
    series,
)
from lagrange.explain.asked_for import titles_of_questions
from lagrange.explain.beside_answers import beside_answer
from lagrange.explain.limits import LONGEST_IN_TEXT
from lagrange.explain.words import as_stated, at_start, plural, sign_conditions, suffix_of, title_in
from lagrange.mechanics.questions.closed_motions import FromStart
from lagrange.mechanics.questions.forms import rate_of, under_one_root
from lagrange.mechanics.questions.results import (
    AnswerBranch,
    Asked,
    How,
    IntegralKind,
    InverseRadius,
    Reason,
    Route,
    UsedIntegral,
    one_value,
)
from lagrange.mechanics.results import Solution
from lagrange.problem.model import Question

if TYPE_CHECKING:
    from lagrange.algebra.closed_forms.signs import SignCondition
    from lagrange.values.quantities import Values


def explain_questions(solution: Solution) -> Iterator[Step]:
    """A step for each question."""
    shown = {v.name for v in solution.views if v.conserved is not None}
    seen: dict[tuple[str, sp.Expr], str] = {}
    states: set[tuple[sp.Expr, ...]] = set()
    for asked, title in zip(solution.asked, titles_of_questions(solution), strict=True):
        when = tuple(c.function for c in asked.question.when)
        body = (*_body(asked, asked.choice in shown, seen), *beside_answer(solution, asked, first=when not in states))
        states.add(when)
        yield Step(Rule.QUESTION, title, body, about=asked.question.name)


def explain_from_start(start: FromStart) -> Step:
    """The motion from the initial state, where nothing is asked."""
    return Step(Rule.QUESTION, title_in("Motion from the initial state", start.choice), tuple(_start(start)))


def _start(start: FromStart) -> Iterator[Block]:
    given = at_start(start.initial)
    if len(start.motions) > 1:
        yield prose("The equations of motion integrate in closed form. From the state with ", *given, " at ",
                    math(t, sp.S.Zero), " there are these cases, as substitution shows:")  # fmt: skip
    elif start.motions:
        yield prose("The equations of motion integrate in closed form. With ", *given, " at ", math(t, sp.S.Zero),
                    ", as substitution shows,")  # fmt: skip
    for n, m in enumerate(start.motions, start=1):
        where = ("where ", *sign_conditions(m.conditions)) if m.conditions else ()
        lines = [
            Equation((q, under_one_root(e)), label=f"from-start-{n}-{k}", condition=where if k == 1 else ())
            for k, (q, e) in enumerate(m.solutions.items(), start=1)
        ]
        yield display(*lines, boxed=True, detail=Detail.BRIEF)
    if not start.motions and start.integrals:
        yield prose("The equations of motion do not integrate in closed form here. With ", *given, " at ",
                    math(t, sp.S.Zero), " the integrals have the values")  # fmt: skip
        yield display(*(Equation((i.expression, i.value)) for i in start.integrals))
    if not start.motions:
        yield prose("Nothing else depends on the initial state: the questions of a file are under `ask`.")


def _body(asked: Asked, conserved_shown: bool, seen: dict[tuple[str, sp.Expr], str]) -> Iterator[Block]:
    """The step; `seen` has the labels of integrals that earlier questions have shown with their values."""
    yield prose(*_asked(asked.question), detail=Detail.BRIEF)
    if asked.opposite is not None:
        force = math(asked.opposite)
        yield prose("With the sense of ", force, " above there is no solution, so ", force, " is counted in the "
                    "opposite sense here: it stands for the size of the force.")  # fmt: skip
    if asked.used and not _is_direct(asked):
        yield _terms_of(asked)
        yield display(*(Equation((u.symbol, u.value)) for u in asked.used))
    if asked.turning is not None:
        at = math(asked.turning.symbol, asked.turning.value)
        yield prose("The motion comes to rest at ", at, ", and goes back from there.")
    if asked.senses and asked.route in (Route.INTEGRALS, Route.QUADRATURE, Route.SOLUTION):
        yield _senses(asked)
    if asked.route in (Route.INTEGRALS, Route.QUADRATURE, Route.ORBIT) and asked.integrals:
        labels = [seen.get((asked.choice, i.expression)) for i in asked.integrals]
        if None in labels:
            yield from _integrals(asked, conserved_shown)
            for n, i in enumerate(asked.integrals, start=1):
                seen.setdefault((asked.choice, i.expression), _label(asked, "integral", n))
        else:
            known = listed(Ref(x) for x in labels if x is not None)
            holds = plural(len(labels), " holds.", " hold.")
            yield prose("Throughout the motion, as before, ", *known, holds, purpose=Purpose.AS_BEFORE)
    if asked.integrand is not None:
        yield from _quadrature(asked.integrand, asked.question.quantity)
    if asked.solutions:
        yield from _solutions(asked)
    if asked.orbit is not None:
        yield from _orbit(asked, asked.orbit)
    yield from _condition(asked)
    if not asked.answered:
        yield prose(*_unanswered(asked), detail=Detail.BRIEF)
        if asked.integral is not None:
            yield display(Equation((t, asked.integral), label=answer_label(asked, 1)), boxed=True, detail=Detail.BRIEF)
        return
    yield from _answer(asked)


def _asked(question: Question) -> tuple[Part, ...]:
    """`Asked for: θ when N = 0.`"""
    words: list[Part] = ["Asked for: ", math(question.quantity)]
    if question.by is not None:
        words += [" as a function of ", math(question.by)]
    if question.when:
        words += [" when ", *listed(map(as_stated, question.when))]
    return (*words, ".")


def _is_direct(asked: Asked) -> bool:
    """Whether the equations of motion give the quantity directly, with nothing to substitute."""
    given = [(u.symbol, u.value) for u in asked.used]
    return len(given) == 1 and given == [(b.lhs, b.rhs) for b in asked.branches]


def _terms_of(asked: Asked) -> Prose:
    values = [u.value for u in asked.used]
    if asked.route is Route.IMPACT:
        return prose("In the impact the reactions have the impulses" if len(values) > 1 else
                     "In the impact the reaction has the impulse")  # fmt: skip
    if any(_moves(e) for e in values):
        return prose("In terms of position and velocity,", purpose=Purpose.IN_TERMS_OF)
    if any(not s.is_positive for e in values for s in e.free_symbols):
        return prose("In terms of the position,", purpose=Purpose.IN_TERMS_OF)
    return prose("The equations of motion give")


def _moves(e: sp.Expr) -> bool:
    return any(s.name.endswith("'") for s in e.free_symbols)


def _initial(asked: Asked) -> tuple[Part, ...]:
    """`At t = 0, θ = 0 and θ̇ = 0`."""
    return at_start(asked.initial)


def _integrals(asked: Asked, conserved_shown: bool) -> Iterator[Block]:
    """The integrals with their values at t = 0."""
    suffix = suffix_of(asked.choice)
    own = [i for i in asked.integrals if i.kind is IntegralKind.CONSERVED]
    for i in asked.integrals:
        if i.kind is not IntegralKind.CONSERVED:
            yield from _found(i)
    references: list[Part] = [Ref(f"conserved{suffix}-{(i.number or 0) + 1}") for i in own] if conserved_shown else []
    what: tuple[Part, ...]
    if references and len(own) == len(asked.integrals):
        what = (*listed(references), plural(len(own), " has the value", " have the values"))
    else:
        several = len(asked.integrals) > 1
        what = ("these integrals have the values" if several else "this integral has the value",)
    had = plural(len(asked.integrals), " that it has at ", " that they have at ")
    had_at_start: tuple[Part, ...] = (":",)
    if asked.turning is not None:
        had_at_start = (plural(len(asked.integrals), " that it has where the motion turns:",
                           " that they have where the motion turns:"),)  # fmt: skip
    elif asked.initial:
        had_at_start = (had, math(t, sp.S.Zero), ", where ", *_initial(asked), ":")
    yield prose("Throughout the motion ", *what, *had_at_start)
    yield display(*(Equation((i.expression, i.value), label=_label(asked, "integral", n))
                    for n, i in enumerate(asked.integrals, start=1)))  # fmt: skip


def answer_line(b: AnswerBranch) -> Equation:
    """The answer; a number in front of letters is rounded."""
    if not b.rhs.free_symbols or not b.rhs.as_coeff_Mul()[0].is_Float:
        return Equation((b.lhs, b.rhs))
    from lagrange.values.quantities import rounded_in

    return Equation((b.lhs, under_one_root(rounded_in(b.rhs))), relation="≈")


def _has_speed(b: AnswerBranch) -> bool:
    """Whether something moves in the state of the answer."""
    return any(s.name.endswith("'") and e != 0 for state in b.states[:1] for s, e in state.items())


def answer_label(asked: Asked, number: int) -> str:
    """The label of a branch of an answer, counted from 1."""
    return _label(asked, "answer", number)


def _label(asked: Asked, what: str, number: int) -> str:
    return f"asked-{asked.question.name}-{what}-{number}"


def _found(i: UsedIntegral) -> Iterator[Block]:
    """How an integral of one equation of motion is found."""
    if i.kind is IntegralKind.CENTRE:
        yield prose(
            math(i.equation, sp.S.Zero), " throughout the motion, so that ", math(i.expression), " is constant."
        )
        return
    assert i.coordinate is not None
    q, v = i.coordinate, sp.Symbol(f"{i.coordinate.name}'", real=True)
    a = sp.Symbol(f"{i.coordinate.name}''", real=True)
    alone = " contains no coordinate." if i.kind is IntegralKind.SPEED else " contains no other coordinate."
    yield prose("The equation of motion ", math(a, i.equation), alone, *_multiplied(i, q, v))


def _multiplied(i: UsedIntegral, q: sp.Symbol, v: sp.Symbol) -> tuple[Part, ...]:
    a = sp.Symbol(f"{q.name}''", real=True)
    if i.kind is IntegralKind.IMPULSE:
        return (" Since ", math(v), " is the rate of ", math(q), ", it can be integrated over time.")
    if i.kind is IntegralKind.SPEED:
        return (" With ", math(v), " as a function of ", math(q), ", ", math(a), " is ", math(v), " times its "
                "derivative: the velocity and the way are separated, and each side can be integrated.")  # fmt: skip
    if i.factor == 1:
        return (" Multiplied by ", math(v), " it can be integrated: the work–energy theorem.")
    return (" It is linear in ", math(v**2), " as a function of ", math(q), ": multiplied by ", math(v),
            " and the integrating factor ", math(i.factor), " it can be integrated.")  # fmt: skip


def _senses(asked: Asked) -> Block:
    """`At first ẏ > 0, and as long as this holds the modulus of ẏ is ẏ.`"""
    senses = dict(_as_modulus(v, s) for v, s in asked.senses.items())
    signs = listed(math(v, sp.S.Zero, relation=">" if s > 0 else "<") for v, s in senses.items())
    one = len(senses) == 1
    what = "its modulus is it, or its opposite" if not one else ""
    [v, *_] = senses
    same: tuple[Part, ...] = (math(sp.Abs(v), v if senses[v] > 0 else -v),) if one else (what,)
    begins = "The motion begins with " if asked.turning is None else "It goes back with "
    return prose(begins, *signs, ", and as long as this holds, ", *same, ".")


def _as_modulus(v: sp.Expr, sign: int) -> tuple[sp.Expr, int]:
    """A velocity with the sign that it has in its modulus: |b − a| is written for |a − b| too."""
    modulus = sp.Abs(v)
    inside = modulus.args[0] if isinstance(modulus, sp.Abs) else v
    return (v, sign) if inside == v else (-v, -sign)


def _quadrature(integrand: tuple[sp.Expr, sp.Expr, sp.Expr, sp.Expr], quantity: sp.Expr) -> Iterator[Block]:
    """The velocity, and between which places its inverse is integrated; for a distance q q'/q'' over q'."""
    q, speed, start, end = integrand
    v = rate_of(q)
    yield prose("This gives")
    yield display(Equation((v, speed)))
    if quantity != t:
        yield prose("The change of ", math(quantity), " is the integral of ", math(q / v), " over ", math(q), " from ",
                    math(start), " to ", math(end), ".")  # fmt: skip
        return
    yield prose(
        "The time is the integral of ", math(1 / v), " over ", math(q), " from ", math(start), " to ", math(end), "."
    )


def _solutions(asked: Asked) -> Iterator[Block]:
    """Coordinates as functions of time."""
    one = len(asked.solutions) == 1
    start = (", where ", *_initial(asked)) if asked.initial else ()
    what = "The solution of the equation of motion that begins at " if one else (
        "The solutions of the equations of motion that begin at ")  # fmt: skip
    yield prose(what, math(t, sp.S.Zero), *start, ", is" if one else ", are", ", as substitution shows,")
    yield display(
        *(
            Equation((q, e), label=_label(asked, "solution", n))
            for n, (q, e) in enumerate(asked.solutions.items(), start=1)
        )
    )


def _orbit(asked: Asked, orbit: InverseRadius) -> Iterator[Block]:
    """Binet's equation and its solution."""
    inverse, angle = math(1 / orbit.radius), math(orbit.angle)
    second = orbit.constant - orbit.stiffness / orbit.radius
    radius, start = math(orbit.radius), (", where ", *_initial(asked)) if asked.initial else ()
    speed, rate = math(prime(orbit.radius)), math(prime(orbit.angle))
    yield prose("Along the orbit ", speed, " is ", rate, " times the derivative of ", radius, " by ", angle, ". So the "
                "equation of motion for ", radius, " becomes a linear one for ", inverse, " as a function of ", angle,
                ", whose second derivative is ", math(second), " (Binet). The solution that begins at ",
                math(t, sp.S.Zero), *start, ", is, as substitution shows,")  # fmt: skip
    yield display(Equation((1 / orbit.radius, orbit.value), label=_label(asked, "orbit", 1)))


def _condition(asked: Asked) -> Iterator[Block]:
    """The conditions after substitution, where they changed."""
    changed = [
        (a, b) for c, (a, b) in zip(asked.question.when, asked.conditions, strict=False) if (a, b) != (c.lhs, c.rhs)
    ]
    if changed:
        yield prose(plural(len(changed), "The condition becomes", "The conditions become"))
        yield display(
            *(Equation(sides, label=_label(asked, "condition", n)) for n, sides in enumerate(changed, start=1))
        )


def _answer(asked: Asked) -> Iterator[Block]:
    several = len(asked.branches) > 1
    yield prose(*_how(asked), detail=Detail.BRIEF)
    lines = [
        replace(answer_line(b), label=answer_label(asked, n), condition=where_it_holds(b, asked.divided_by))
        for n, b in enumerate(asked.branches, start=1)
    ]
    yield display(*lines, boxed=True, detail=Detail.BRIEF)
    if divided := asked.divided_by:
        vanish = listed((math(c.lhs, c.rhs) for c in divided), " or ")
        yield prose("Where ", *vanish, ", the condition holds for every ", math(asked.question.quantity), ".",
                    detail=Detail.BRIEF)  # fmt: skip
    if (least := asked.least) is not None:
        wave, relation, bound = least
        yield prose("Since ", math(wave, sp.S.One, relation="≤"), ", this needs ",
                    math(asked.branches[0].lhs, bound, relation=relation), ".", detail=Detail.BRIEF)  # fmt: skip
    if angles := [*_angles(asked)]:
        yield prose("That is ", *listed(angles), ".", detail=Detail.BRIEF)
    if any(b.limit and not b.states for b in asked.branches):
        yield prose("The motion approaches this in the limit ", math(t, sp.oo, relation="→"), ", and is never there.",
                    detail=Detail.BRIEF)  # fmt: skip
    elif any(b.limit and _has_speed(b) for b in asked.branches):
        yield prose("There the acceleration vanishes: the motion only approaches this speed, in the limit ",
                    math(t, sp.oo, relation="→"), ".", detail=Detail.BRIEF)  # fmt: skip
    elif any(b.limit for b in asked.branches):
        yield prose("There the velocity and the acceleration vanish: a motion that starts elsewhere only approaches "
                    "this state, in the limit ", math(t, sp.oo, relation="→"), ".", detail=Detail.BRIEF)  # fmt: skip
    if any(b.provided for b in asked.branches):
        yield prose("This holds provided that the motion gets there, which is not decided here.", detail=Detail.BRIEF)
    if asked.mirrored and not asked.initial:
        yield prose("The motion may have either sense: one value belongs to each.")
    elif asked.mirrored:
        yield prose("The initial state is an equilibrium, from which the motion may start in either direction: "
                    "one value belongs to each.")  # fmt: skip
    elif several and asked.route is Route.REST:
        yield prose("These belong to different positions; a `range` of a coordinate, in the file, excludes those that "
                    "are not meant.", detail=Detail.BRIEF)  # fmt: skip
    elif several and not all(b.conditions for b in asked.branches):
        yield prose("Which of these comes first depends on more than was decided here.")
    for b, because in asked.dropped:
        yield prose(*_dropped(b, because, asked))


def _angles(asked: Asked) -> Iterator[Math]:
    """θ = 48.19°, for cos θ = 2/3; of an angle and its opposite the positive one."""
    return (angle for b in asked.branches if (angle := angle_of(asked, b)) is not None)


def angle_of(asked: Asked, b: AnswerBranch, values: Values | None = None, digits: int = 4) -> Math | None:
    """θ = 48.19° for cos θ = 2/3, with values substituted; None if it gives no angle by its cosine or the like."""
    if not isinstance(b.lhs, sp.cos | sp.sin | sp.tan):
        return None
    angles = [v if values is None else values.put_in(v) for v in b.values]
    angle = one_value([v for v in angles if v.is_number])
    return None if angle is None else in_degrees(asked.question.quantity, angle, digits)


def in_degrees(name: sp.Expr, angle: sp.Expr, digits: int) -> Math | None:
    """θ = 48.19° for an angle that is a number; None if it is not real."""
    from lagrange.values.quantities import NotRealError, is_exact, rounded, with_unit

    degrees = angle * 180 / sp.pi
    try:
        shown = rounded(degrees, digits)
        return math(name, with_unit(shown, "°"), relation="=" if is_exact(degrees, shown) else "≈")
    except NotRealError:
        return None


def where_it_holds(b: AnswerBranch, divided: Collection[SignCondition] = ()) -> tuple[Part, ...]:
    """The conditions in words; that a long square is not negative needs no letters.

    divided  that the factors do not vanish by which its equation was divided
    """
    square = b.of_square
    long = sum(count_operations(c.lhs) for c in square) > LONGEST_IN_TEXT
    stated = sign_conditions((*divided, *(() if long else square), *b.beyond_square))
    words: tuple[Part, ...] = ("the right side is not negative", " and " if stated else "") if long else ()
    return ("where ", *words, *stated) if words or stated else ()


def _how(asked: Asked) -> tuple[Part, ...]:
    if _is_direct(asked):
        return _terms_of(asked).parts
    if asked.how is How.NUMERICAL and asked.integrand is not None:
        return ("No elementary function was found for it. In numbers it is",)
    if asked.how is How.NUMERICAL and asked.mirrored:
        return ("The motion begins in an unstable equilibrium, to one side or the other. The integrals leave one "
                "coordinate in the condition, which holds first, in numbers, where",)  # fmt: skip
    if asked.how is How.NUMERICAL:
        return ("Integrating the equations of motion numerically gives, for the first time that this holds,",)
    if asked.route is Route.SOLUTION and not asked.solutions:
        return ("The equation of motion can be integrated. For the initial state there are several cases, and in "
                "each of them, as substitution shows,",)  # fmt: skip
    if asked.route is Route.SOLUTION and any(c.lhs == t or c.rhs == t for c in asked.question.when):
        return ("At that time",)
    if asked.question.by is not None and asked.route is Route.INTEGRALS and not _has_velocities(asked):
        return ("Solving this for the quantity gives",)
    if asked.question.by is not None:
        return ("Eliminating the velocities gives",) if asked.route is Route.INTEGRALS else ("Therefore",)
    if asked.route is Route.STATE and not asked.question.when:
        return ("Therefore",)
    if asked.route is Route.STATE:
        return ("In this state",)
    if asked.route is Route.IMPACT:
        return ("Hence",)
    if asked.route is Route.STABILITY:
        return ("There the forces balance for every value. By the second variation it is the limit of stability:",)
    if asked.route is Route.REST:
        return ("The balance of the generalized forces, the constraints and this condition together give"
                if asked.question.when else "The balance of the forces and the constraints give",)  # fmt: skip
    if asked.route is Route.QUADRATURE:
        return ("It is elementary, as differentiation shows:",)
    return ("Together these give",)


def _has_velocities(asked: Asked) -> bool:
    """Whether the quantity is more than velocities and constant factors."""
    return not all(s.name.endswith("'") or s.is_positive for s in asked.quantity.free_symbols)


def _dropped(b: AnswerBranch, because: Reason, asked: Asked) -> tuple[Part, ...]:
    equation = math(b.lhs, b.rhs)
    opposite = any(kept.lhs == b.lhs and kept.rhs == -b.rhs for kept in asked.branches)
    long = opposite and count_operations(b.rhs) > LONGEST_IN_TEXT  # as it stands above, but for the sign
    solution: tuple[Part, ...] = ("The opposite value",) if long else ("The solution ", equation)
    match because:
        case Reason.INITIAL:
            return (*solution, " is the initial state itself.")
        case Reason.ARRIVAL:
            if opposite:
                return ("The sign is that of the first arrival.",)
            return (*solution, " has the wrong sense: a coordinate that reaches a value for the first "
                    "time moves towards it.")  # fmt: skip
        case Reason.TURNING:
            return (*solution, " lies on the other side: the motion begins in the opposite direction, "
                    "and keeps it up to the first turning point.")  # fmt: skip
        case Reason.SENSE:
            return (*solution, " has the opposite sense, for which this equation of motion does "
                    "not hold.")  # fmt: skip
        case Reason.PAST:
            return (*solution, " lies before ", math(t, sp.S.Zero), ".")
        case Reason.OPPOSITE:
            return ("The equations contain ", math(b.lhs), " in even powers only, so that the opposite value ",
                    equation, " is possible as well.")  # fmt: skip
        case Reason.LATER:
            return (*solution, " comes later, if at all.")
        case Reason.START:
            return (*solution, " does not begin with the initial state.")


def _unanswered(asked: Asked) -> tuple[Part, ...]:
    """The statement of what is known and what is missing."""
    if asked.integrand is not None:
        return ("No elementary function was found for this integral; with values for all parameters it is found in "
                "numbers.",)  # fmt: skip
    why: tuple[Part, ...] = ("The integrals that are known do not determine this in closed form.",)
    if not asked.integrals:
        why = ("No integral of the motion with a known value was found that would determine this.",)
    if asked.missing:
        needed = series((math(s),) for s in asked.missing)
        why = (*why, " Another integral would need the initial values of ", *needed, ", which are not given.")
    if asked.needs:
        extra = f"install lagsolve with the extra `{asked.needs}`"
        why = (*why, f" All values are given, so that it can be found numerically: {extra}.")
    return why
