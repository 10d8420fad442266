"""Results in numbers, after each result in letters whose parameters all have values."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import replace

import sympy as sp

from lagrange.core.symbols import UnitSymbol
from lagrange.document.derivation import (
    Block,
    Detail,
    Display,
    Equation,
    Math,
    Part,
    Purpose,
    Ref,
    Rule,
    Step,
    Table,
    display,
    has_purpose,
    index_of,
    listed,
    math,
    prose,
    series,
)
from lagrange.explain.limits import MOST_SHAPES
from lagrange.explain.questions import angle_of, answer_label, in_degrees
from lagrange.explain.words import plural, suffix_of, title_in
from lagrange.mechanics.equilibrium.in_numbers import (
    Decay,
    EquilibriaInNumbers,
    Position,
    acute_parameters,
    angles_of_branch,
    critical_values,
)
from lagrange.mechanics.equilibrium.linear_stability import Ground
from lagrange.mechanics.equilibrium.numerical_equilibria import NumericalEquilibria
from lagrange.mechanics.equilibrium.stability import StabilityVerdict
from lagrange.mechanics.results import InCoordinates, Solution
from lagrange.values.bounds import bound_with
from lagrange.values.dimensions import dimension, dimension_of_unit
from lagrange.values.quantities import NotRealError, Quantity, Values, degrees, is_exact, rounded, with_unit

RESULTS = (
    Rule.EQUATIONS_OF_MOTION,
    Rule.QUASI_VELOCITIES,
    Rule.SOLVED_REACTIONS,
    Rule.QUESTION,
    Rule.EQUILIBRIUM,
    Rule.LINEARIZATION,
    Rule.FRICTION_AT_REST,
    Rule.STEADY,
    Rule.RESPONSE,
    Rule.IMPACT,
)
"""The steps whose boxed equations are results."""
_BOUNDS = ("≤", "≥", "<", ">")
Sides = tuple[object, ...]
Angles = Mapping[Sides, tuple[Part, ...]]
"""The angle in degrees for an answer by its sides, sin θ = 2/3 sin α; two of them where both may be meant."""


def with_numbers(steps: Iterable[Step], solution: Solution, values: Values, digits: int) -> Iterator[Step]:
    """The steps with results in numbers."""
    positions = {title: view for view in solution.views for title in _titles(view)}
    excluded = frozenset(_excluded_answers(solution, values))
    bare = frozenset((b.lhs, b.rhs) for a in solution.asked for b in a.branches if a.has_bare_numbers)
    angles: dict[Sides, tuple[Part, ...]] = {(b.lhs, b.rhs): (angle,) for a in solution.asked for b in a.branches
              if b.rhs.free_symbols and (angle := angle_of(a, b, values, digits)) is not None}  # fmt: skip
    angles = {**angles, **{sides: angle for view in solution.views for sides, angle in _at_rest(view, values, digits)}}
    critical = {c: bound for view in solution.views for c, bound in _critical_values(view, values, digits)}
    for step in steps:
        view = positions.get((step.rule, step.title))
        if view is not None:
            step = replace(step, body=(*step.body, *_critical(view, values, digits)))
        if step.rule is Rule.STATEMENT:
            yield replace(step, body=(*step.body, *_given(solution, values, digits)))
        elif step.rule in (Rule.RESULT, Rule.MEANING):
            body = (_with_values(b, values, digits, bare, angles) for b in step.body)
            yield replace(step, body=tuple(_with_bounds(b, critical) for b in body))
        elif step.rule not in RESULTS:
            yield step
        elif view is not None and view.in_numbers is not None:
            table = _equilibria(view, view.in_numbers, digits, _start(values))
            numerical = view.in_numbers.numerical
            settled = any(p.branch is None for p in view.in_numbers.positions)
            settled = settled or (numerical is not None and numerical.is_exhaustive)
            body = (b for b in step.body if not (settled and has_purpose(b, Purpose.EXISTENCE_OPEN)))
            yield replace(step, body=(*body, *table, *_forces_at_roots(view, digits)))
        elif view is not None and not _determines_forces(view):
            yield step
        else:
            there = _at_positions_found(step, solution, values, digits) if step.rule is Rule.SOLVED_REACTIONS else ()
            yield replace(step, body=(*_blocks(step, values, digits, excluded, bare, angles), *there))


def _at_rest(view: InCoordinates, values: Values, digits: int) -> Iterator[tuple[Sides, tuple[Part, ...]]]:
    """The angles of equilibria that a sine, cosine or tangent determines: one or two, as far as the range admits."""
    branches = view.equilibrium.branches if view.equilibrium is not None else ()
    verdicts = view.stability.verdicts if view.stability is not None else (None,) * len(branches)
    absent = view.in_numbers.absent if view.in_numbers is not None else ()
    for n, (b, verdict) in enumerate(zip(branches, verdicts, strict=True)):
        if n in absent:
            continue
        conditions = verdict.conditions if verdict is not None else ()
        for r, angles, stable in angles_of_branch(b, conditions, view.configuration.ranges, values):
            shown = [m for a in angles if (m := in_degrees(r.lhs.args[0], a, digits)) is not None]
            if shown and len(shown) == len(angles):
                word = " (stable)" if stable == 1 < len(angles) else ""
                yield (r.lhs, r.rhs), (shown[0], word, *(p for m in shown[1:] for p in (" or ", m)))
    for motion in view.impending or ():
        for r, symbol, angle in acute_parameters(motion.equilibrium, values):
            if (limit := in_degrees(symbol, angle, digits)) is not None:
                yield (r.lhs, r.rhs), (limit,)


def _given(solution: Solution, values: Values, digits: int) -> Iterator[Block]:
    """`Given: m = 2 kg, g = 9.81 m/s² and α = 30°`, in SI units, angles in degrees.

    What the file has in kg stays so: a rate of mass in kg/s, which as a damping coefficient is in N s/m.
    """
    digits = max(digits, 6)
    by_mass = {p.symbol: p.unit for p in solution.problem.parameters if re.match(r"kg(?![A-Za-z])", p.unit)}
    quantities = [(p, values.quantity(p)) for p in sorted(values.numbers, key=str)]
    quantities = [(p, replace(q, unit=by_mass.get(p, q.unit)) if q is not None else None) for p, q in quantities]
    given = [
        math(p, degrees(q.formula, digits) if q.unit == "rad" else q.shown(digits))
        for p, q in quantities
        if q is not None and q.is_number
    ]
    if given:
        rate = solution.classification.rheonomic_with
        at_rest: tuple[Part, ...] = ()
        if rate is not None and values.put_in(rate) == 0:
            at_rest = (" So nothing moves the constraints here: the system is scleronomic, and every possible "
                       "displacement is a virtual one.",)  # fmt: skip
        yield prose("Given: ", *listed(given), ".", *at_rest)


def _at_positions_found(step: Step, solution: Solution, values: Values, digits: int) -> Iterator[Block]:
    """The reactions at rest where the equilibria were found numerically, and the reactions depend on the position."""
    in_numbers = solution.own.in_numbers
    if in_numbers is None or in_numbers.numerical is None or solution.own.dynamics is not None:
        return
    lines = [e for b in step.body if isinstance(b, Display) and b.boxed for e in b.equations if e.relation == "="]
    for n, p in enumerate(in_numbers.positions, start=1):
        place = {q: x.formula for q, x in p.coordinates.items()}
        shown = []
        for e in lines:
            name, value = e.sides[0], e.sides[-1]
            if not isinstance(value, sp.Expr) or not isinstance(name, sp.Expr) or not value.free_symbols & {*place}:
                continue
            quantity = values.quantity(value.xreplace(place))
            if quantity is not None and quantity.is_number:
                size = replace(quantity, unit=values.unit_of(value) or values.unit_of(name))
                shown.append(Equation((name, size.shown(digits)), relation="≈"))
        if shown:
            which = "the position" if len(in_numbers.positions) == 1 else f"position {n}"
            yield prose(f"In {which} found in numbers:", detail=Detail.BRIEF)
            yield display(*shown, detail=Detail.BRIEF)


def _forces_at_roots(view: InCoordinates, digits: int) -> Iterator[Block]:
    """The named reactions at the equilibria that were found numerically, where no formula for them is stated."""
    stated = view.reactions_at_rest
    if not view.is_own or view.in_numbers is None:
        return
    if stated is not None and any(there is not None for there in stated.at):
        return
    roots = [p for p in view.in_numbers.positions if p.branch is None]
    rows = [p.forces for p in roots]
    names = [*rows[0]] if rows and all(rows) else []
    if names:
        where = "At the equilibria" if view.in_numbers.slack else "There"
        order = ", in the same order," if len(roots) > 1 else ""
        yield prose(f"{where}{order} the reactions are", detail=Detail.BRIEF)
        shown = tuple(tuple(math(row[name].shown(digits)) for name in names) for row in rows)
        yield Table(tuple(math(name) for name in names), shown, Detail.BRIEF)


def _start(values: Values) -> str:
    if not values.numbers:
        return "In numbers:"
    return "With the given values, in SI units:" if values.units else "With the given values:"


def _titles(view: InCoordinates) -> Iterator[tuple[Rule, str]]:
    """The steps in which the equilibria of a view are stated."""
    if view.linearization is not None:
        yield Rule.LINEARIZATION, title_in("Small oscillations", view.name)
    elif view.equilibrium is not None:
        title = title_in("Equilibrium", view.name) if view.name else "The principle of virtual work"
        yield Rule.EQUILIBRIUM, title


def _critical(view: InCoordinates, values: Values, digits: int) -> Iterator[Block]:
    """`With the given values, k l > P is P < 100 N.`"""
    clauses = [(condition, " is ", bound) for condition, bound in _critical_values(view, values, digits)]
    if clauses:
        yield prose("With the given values, ", *series(clauses), ".", detail=Detail.BRIEF)


def _critical_values(view: InCoordinates, values: Values, digits: int) -> Iterator[tuple[Part, Part]]:
    """Conditions and what they are with the given values: k l > P and P < 100 N."""
    for v in critical_values(view.equilibrium, view.stability, view.linearization, values):
        bound = math(v.parameter, v.bound.shown(digits), relation=v.relation)
        yield math(v.condition.lhs, v.condition.rhs, relation=v.condition.relation), bound


def _with_bounds(block: Block, critical: Mapping[Part, Part]) -> Block:
    """The box at the head with critical values in numbers beside conditions: P < (3 − √5) k l/2, that is P < 3820 N."""
    if not isinstance(block, Display) or not critical:
        return block

    def beside(part: Part) -> tuple[Part, ...]:
        return (part, ", that is ", critical[part]) if part in critical else (part,)

    return block.map(lambda e: replace(e, condition=tuple(p for part in e.condition for p in beside(part))))


def _determines_forces(view: InCoordinates) -> bool:
    return view.linearization is None and view.equilibrium is not None and view.equilibrium.given


def _excluded_answers(solution: Solution, values: Values) -> Iterator[str]:
    """The labels of answers to questions whose conditions the values violate."""
    if not solution.asked:
        return
    from lagrange.mechanics.questions.ranges import branches_with

    for asked in solution.asked:
        left = branches_with(asked, values)
        for n, b in enumerate(asked.branches, start=1):
            if not any(b is kept for kept in left):
                yield answer_label(asked, n)


def _blocks(
    step: Step, values: Values, digits: int, excluded: frozenset[str], bare: Collection[Sides], angles: Angles
) -> Iterator[Block]:
    for block in step.body:
        if isinstance(block, Display) and any(_is_found_in_numbers(e) for e in block.equations):
            block = block.map(lambda e: _measured_there(e, values, digits, bare))
        yield block
        if isinstance(block, Display) and block.boxed:
            possible = [e for e in block.equations if e.label not in excluded]
            lines = [_in_numbers(e, values, digits, bare) for e in possible]
            if any(e.relation in _BOUNDS for e in possible):
                lines = [line for line in lines if line is not None]  # a condition without values stands as it is
            shown = [e for e in lines if e is not None]
            if len(possible) < len(block.equations):
                gone = [Ref(e.label) for e in block.equations if e.label in excluded]
                words = plural(
                    len(gone), " does not exist with the given values.", " do not exist with the given values."
                )
                yield prose(*listed(gone), words, detail=Detail.BRIEF)
            if shown and len(shown) == len(lines):
                yield prose(_start(values), detail=Detail.BRIEF)
                yield display(*shown, detail=Detail.BRIEF)
                if measured_ := [angles[e.sides] for e in possible if e.sides in angles]:
                    yield prose("That is ", *series(measured_), ".", detail=Detail.BRIEF)


def _with_values(block: Block, values: Values, digits: int, bare: Collection[Sides], angles: Angles) -> Block:
    """The box at the head, and constant accelerations, with the numerical value of each quantity that has one."""
    if not isinstance(block, Display):
        return block
    return block.map(lambda e: _with_value(e, values, digits, bare, angles))


def _with_value(equation: Equation, values: Values, digits: int, bare: Collection[Sides], angles: Angles) -> Equation:
    if equation.relation in _BOUNDS and (bound := _in_numbers(equation, values, digits)) is not None:
        same = bound.sides == equation.sides
        more = bound.condition[1:] if bound.condition[:1] == ("that is ",) else bound.condition
        said = (math(*bound.sides, relation=bound.relation), ", " if more else "", *more)
        before = (*equation.condition, ", " if equation.condition else "", "that is ")
        return equation if same else replace(equation, condition=(*before, *said))
    if _is_found_in_numbers(equation):
        return _measured_there(equation, values, digits, bare)
    measured = _in_numbers(equation, values, digits, bare) if equation.relation == "=" else None
    if measured is None or measured.sides[0] != equation.sides[0] or not isinstance(measured.sides[0], sp.Expr):
        return equation
    right = measured.sides[-1]
    if not isinstance(right, sp.Expr) or not all(isinstance(s, UnitSymbol) for s in right.free_symbols):
        return equation  # with coordinates in it: the step has it
    if (found := _frequency(equation, values)) is not None:
        letter, omega = found
        number_of = omega.formula_shown(digits)
        measured = Equation((letter, omega.shown(digits)),
                            relation="=" if is_exact(omega.formula, number_of) else "≈")  # fmt: skip
        if omega.formula == 0:
            return equation
    number: tuple[Part, ...] = (math(*measured.sides, relation=measured.relation),)
    if index_of(Purpose.GIVEN_VALUES, equation.condition) is None:
        number = ("that is ", *number)
    number = (*number, ", ", *angles[equation.sides]) if equation.sides in angles else number
    is_followed = equation.condition[-1:] in (("or",), (", or",))  # by another system: the number comes before
    said = equation.condition[:-1] if is_followed else equation.condition
    return replace(equation, condition=(*said, ", " if said else "", *number, *((", or",) if is_followed else ())))


def _frequency(equation: Equation, values: Values) -> tuple[sp.Expr, Quantity] | None:
    """The ω of `ω² = ...`, if that is a frequency with a value that is not negative: one measures ω, not ω²."""
    left, right = equation.sides[0], equation.sides[-1]
    if not isinstance(left, sp.Pow) or left.exp != 2 or not isinstance(right, sp.Expr):
        return None
    if not str(left.base).lower().startswith("omega") or left.base in values.parameters:
        return None
    square = values.quantity(right)
    if square is None or not square.is_number or square.formula.is_negative is not False:
        return None
    return left.base, Quantity(sp.sqrt(square.formula), "rad/s" if values.units else "")


def _is_found_in_numbers(equation: Equation) -> bool:
    return isinstance(equation.sides[-1], sp.Float)


def _measured_there(equation: Equation, values: Values, digits: int, bare: Collection[Sides]) -> Equation:
    """A result that has no formula, with its unit in its place: t ≈ 0.5616 s."""
    measured = _in_numbers(equation, values, digits, bare) if _is_found_in_numbers(equation) else None
    return equation if measured is None else replace(equation, sides=measured.sides, relation=measured.relation)


def _in_numbers(equation: Equation, values: Values, digits: int, bare: Collection[Sides] = ()) -> Equation | None:
    """An equation with numbers; None if a value is missing. Of T = 19.62 N the right side has its unit.

    bare  sides of equations in which a number hides a unit: only that of the left side is known
    """
    sides = [s for s in equation.sides if isinstance(s, sp.Expr)]
    if equation.relation != "=":
        return _bound(equation, values, digits) if equation.relation in _BOUNDS and len(sides) == 2 else None
    if len(sides) != len(equation.sides):
        return None
    has_unit = _is_found_in_numbers(equation) or _is_plain_number(equation, values)
    if not has_unit and not any(s.free_symbols & values.parameters for s in sides):
        return None
    right = values.quantity(sides[-1])
    if right is None:
        return None
    try:
        if right.is_number and right.formula != 0 and not sides[0].is_number:
            number, unit = right.formula_shown(digits), _unit(sides[0], right, values, (sides[0], sides[-1]) in bare)
            unit = unit or ("rad" if isinstance(sides[-1], sp.atan2) and values.units else "")  # a phase lag
            shown = with_unit(number, unit) if unit else number
            beside = (degrees(right.formula, digits),) if unit == "rad" else ()
            return Equation((sides[0], shown, *beside), relation="=" if is_exact(right.formula, number) else "≈")
        left = values.quantity(sides[0])
        if left is None:
            return None
        if not right.is_number or not sides[0].is_Symbol:
            return Equation((left.formula_shown(digits), right.formula_shown(digits)))
        number, shown = right.formula_shown(digits), right.shown(digits)
    except NotRealError:
        return None
    return Equation((sides[0], shown), relation="=" if is_exact(right.formula, number) else "≈")


def _is_plain_number(equation: Equation, values: Values) -> bool:
    """Whether it has a number for what has a unit: x' = 10/7 m/s, of an initial state in numbers with their units."""
    left, right = equation.sides[0], equation.sides[-1]
    plain = isinstance(left, sp.Symbol) and isinstance(right, sp.Expr) and right.is_number and right != 0
    return plain and values.unit_of(left) not in ("", "rad")


def _bound(equation: Equation, values: Values, digits: int) -> Equation | None:
    """An inequality with numbers, solved where one quantity is left: P ≥ 5.767 N."""
    left, right = equation.sides if equation.relation in ("≤", "<") else equation.sides[::-1]
    assert isinstance(left, sp.Expr)
    assert isinstance(right, sp.Expr)
    bound = bound_with(left, right, values, "<" if equation.relation in ("<", ">") else "≤")
    if bound is None:
        return None
    try:
        shown = bound.left.shown(digits) if isinstance(bound.left, Quantity) else bound.left
        words: tuple[Part, ...] = ()
        if bound.angle is not None:
            ends = [e for e in (bound.angle.low, bound.angle.value) if e is not None]
            limits = [degrees(e, digits) for e in ends]
            sides = (*limits[:-1], bound.angle.symbol, limits[-1])
            words = ("that is ", math(*sides, relation=bound.angle.relation), " for an acute angle")
        elif bound.holds is not None:
            words = ("which holds" if bound.holds else "which does not hold",)
        low = () if bound.low is None else (bound.low.shown(digits),)
        return Equation((*low, shown, bound.bound.shown(digits)), relation=bound.relation, condition=words)
    except NotRealError:
        return None


def _unit(left: sp.Expr, right: Quantity, values: Values, is_bare: bool) -> str:
    """The unit of a result: that of the left side, if it is known."""
    own = dimension(left, values.units) if left.free_symbols else None
    if own is None:
        return "" if is_bare else right.unit
    named = values.unit_of(left)  # of an angular velocity rad/s, where the right side says s⁻¹
    is_special = named == "J" or named.startswith("rad")
    same = right.unit and own == dimension_of_unit(right.unit) and not is_special
    return right.unit if same else named


def measured(quantity: Quantity, digits: int) -> Math:
    """A number with its unit in running text; an angle in degrees as well."""
    if quantity.formula == 0:
        return math(sp.S.Zero)
    shown = quantity.shown(digits)
    if quantity.unit != "rad":
        return math(shown)
    return math(shown, degrees(quantity.formula, digits))


def _equilibria(view: InCoordinates, in_numbers: EquilibriaInNumbers, digits: int, start: str) -> Iterator[Block]:
    """A table of the equilibria: where they are, whether they are stable, how they oscillate."""
    suffix = suffix_of(view.name)
    rest, about = view.equilibrium, view.linearization
    kind = "equilibrium" if about is None or (rest is not None and about.is_about_all_of(rest)) else "at-rest"

    def called(n: int) -> Ref:
        return Ref(f"{kind}{suffix}-{n + 1}")

    if in_numbers.positions:
        yield prose(start, detail=Detail.BRIEF)
        yield _table(view, in_numbers, called, digits)
        yield from _decays(view, in_numbers, called, digits)
    if in_numbers.numerical is not None:
        yield _searched(in_numbers.numerical, any(p.branch is not None for p in in_numbers.positions), digits)
    if slack := in_numbers.slack:
        number = len(slack)
        words = plural(number, "One of them is no equilibrium", f"{number} of them are no equilibria")
        places = series((listed(math(q, x.shown(digits)) for q, x in p.coordinates.items()) for p in slack), "; at ")
        yield prose(words, ": at ", *places, " a contact would have to pull, or a string to push.", detail=Detail.BRIEF)
    if in_numbers.absent:
        one = plural(len(in_numbers.absent), " has no real position", " have no real positions")
        yield prose(*listed(called(n) for n in in_numbers.absent), f"{one} with these values.", detail=Detail.BRIEF)


def _searched(numerical: NumericalEquilibria, known: bool, digits: int) -> Block:
    """Where roots were searched for, and whether they are all; `known` if some are in closed form."""
    places: list[Part] = []
    for u, s in numerical.searched.items():
        if s.is_circle:
            places.append(math(-sp.pi, u, sp.pi, relation="≤"))
        else:
            ends = (end if (end / sp.pi).is_Rational else rounded(end, digits) for end in (s.low, s.high))
            low, high = ends
            places.append(math(low, u, high, relation="≤"))
    number = len(numerical.found)
    what = plural(number, "one solution", f"{number} solutions") if number else "no solution"
    if numerical.complete:
        words = ": found numerically, and interval arithmetic encloses each one and excludes the rest of this range."
        return prose(f"The conditions have {what} with ", *listed(places), words, detail=Detail.BRIEF)
    found = what if number else "no further solution" if known else what
    words = f" {found} of the conditions {plural(number or 1, 'was', 'were')} found numerically; the list may be "
    words += "incomplete, because not all of this range could be excluded."
    return prose("With ", *listed(places), words, detail=Detail.BRIEF)


def _table(view: InCoordinates, in_numbers: EquilibriaInNumbers, called: Callable[[int], Ref], digits: int) -> Table:
    unknowns = [u for u in in_numbers.unknowns if any(u in p.coordinates for p in in_numbers.positions)]
    judged = any(p.stability is not None for p in in_numbers.positions)
    most = max((len(p.oscillations) for p in in_numbers.positions), default=0)
    omega = view.linearization.omega if view.linearization is not None else sp.Symbol("omega", real=True)
    header: list[Part] = ["equilibrium", *(math(u) for u in unknowns)]
    shapes = any(o.mode for p in in_numbers.positions for o in p.oscillations)
    moved = _moved(view) if shapes else []
    for k in range(most):
        header += [math(omega if most == 1 else sp.Symbol(f"{omega.name}_{k + 1}", real=True)), "period"]
        header += [math(*moved, relation=":")] if moved else []
    header += ["stability"] if judged else []
    rows = []
    for p in in_numbers.positions:
        row: list[Part] = [called(p.branch) if p.branch is not None else "numerical"]
        row += [measured(p.coordinates[u], digits) if u in p.coordinates else "any" for u in unknowns]
        for k in range(most):
            if k < len(p.oscillations):
                o = p.oscillations[k]
                row += [math(o.frequency.shown(digits)), math(o.period.shown(digits))]
                ratio = [sp.Integer(int(x)) if x in (0, 1) else rounded(sp.Float(x), digits) for x in o.mode]
                row += [math(*ratio, relation=":") if ratio else "–"] if moved else []
            else:
                row += ["–", "–", *(("–",) if moved else ())]
        row += [_judged(p, view)] if judged else []
        rows.append(tuple(row))
    return Table(tuple(header), tuple(rows), Detail.BRIEF)


def _moved(view: InCoordinates) -> list[sp.Symbol]:
    """The small displacements whose ratios in each mode are shown; none for one coordinate, or for many."""
    linear = view.linearization
    free = () if linear is None else next((s.free for s in linear.at if s is not None), ())
    return [linear.displacements[k] for k in free] if linear is not None and 1 < len(free) <= MOST_SHAPES else []


def _decays(
    view: InCoordinates, in_numbers: EquilibriaInNumbers, called: Callable[[int], Ref], digits: int
) -> list[Block]:
    """The damped modes: σ, ω, and for few coordinates amplitude and phase of each."""
    linear = view.linearization
    listed_ = [(p, d) for p in in_numbers.positions for d in p.decays]
    if linear is None or not listed_:
        return []
    moved = _moved(view)
    one = all(len(s.free) == 1 for s in linear.at if s is not None)
    header: list[Part] = [
        "equilibrium",
        "decay rate",
        "frequency",
        *(("damping ratio", "log. decrement") if one else ()),
    ]
    for x in moved:
        header += [math(x), "phase"]
    rows = []
    for p, d in listed_:
        row: list[Part] = [called(p.branch) if p.branch is not None else "numerical", math(d.rate.shown(digits))]
        row.append("none" if d.frequency is None else math(d.frequency.shown(digits)))
        row += _share_and_decrement(d, digits) if one else []
        for amplitude, phase in zip(d.amplitudes, d.phases, strict=True) if moved else ():
            row += [math(rounded(sp.Float(amplitude), digits)), math(rounded(sp.Float(phase), digits))]
        rows.append(tuple(row))
    phases = ", with amplitudes and phases (in rad) relative to the largest displacement of each" if moved else ""
    return [prose(f"The damped modes in numbers{phases}:"), Table(tuple(header), tuple(rows), Detail.BRIEF)]


def _share_and_decrement(d: Decay, digits: int) -> list[Part]:
    """ζ = σ/√(σ² + ω²) and the logarithmic decrement 2π σ/ω of one coordinate, where it oscillates."""
    if d.frequency is None:
        return ["–", "–"]
    rate, omega = d.rate.formula, d.frequency.formula
    return [math(rounded(e, digits)) for e in (rate / sp.sqrt(rate**2 + omega**2), 2 * sp.pi * rate / omega)]


def _judged(p: Position, view: InCoordinates) -> str:
    """The verdict in a word or three."""
    if p.stability is None or p.stability in (StabilityVerdict.UNDECIDED, StabilityVerdict.CONDITIONAL):
        return "undecided"
    s = view.linearization.at[p.branch] if view.linearization is not None and p.branch is not None else None
    if s is not None and p.stability is StabilityVerdict.STABLE:
        if s.judgement.asymptotic:
            return "asymptotically stable"
        if s.judgement.ground not in (None, Ground.POTENTIAL, Ground.HURWITZ):
            return "stable to first order"
    return p.stability.value
