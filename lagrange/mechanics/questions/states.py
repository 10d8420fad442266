"""States of motion in one set of coordinates: what is known at t = 0, and what follows from position and velocity.

Accelerations are solved from the equations of motion with the constraints differentiated twice; reactions are those of
`dynamics.reactions`. Both are functions of position, velocity and time, so that a question is one about the state.

The initial state is given in any of the coordinates of the file and of its choices. It is carried over to the present
ones: positions by the substitution of a choice and by the finite constraints, velocities by the constraints on them,
which are linear. What contradicts a constraint is an error.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field, replace
from itertools import product

import sympy as sp

from lagrange.algebra.closed_forms.branching import solutions
from lagrange.algebra.closed_forms.signs import SignCondition, more_than_zero, sign_of
from lagrange.algebra.closed_forms.single_equation import Relation
from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero
from lagrange.algebra.fourier.linear_systems import solved_linear, tidy_quotient
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.diagnostics import Diagnostic, ProblemError
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Slots, base, prime, t
from lagrange.document.math_writer import text
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.conservation import Conserved
from lagrange.mechanics.dynamics.friction import friction_forces
from lagrange.mechanics.dynamics.lagrangian import kinetic_energy
from lagrange.mechanics.dynamics.motion import Motion, NewtonLaw
from lagrange.mechanics.equilibrium.friction.balance import held_coordinates
from lagrange.mechanics.questions.limits import LONGEST_EQUATION, MOST_ANGLES, MOST_TOGETHER
from lagrange.problem.model import ENERGY, KINETIC_ENERGY, Friction, InitialValue, Problem, Question, Range

SymbolValues = Mapping[sp.Symbol, sp.Expr]
Senses = Mapping[sp.Expr, int]


@record
class MotionView:
    """The motion in one set of coordinates.

    dynamics   with the reactions
    conserved  the conserved quantities
    """

    dynamics: Motion
    conserved: Conserved
    law: NewtonLaw

    @property
    def configuration(self) -> Configuration:
        """The coordinates."""
        return self.dynamics.equations.configuration

    @property
    def name(self) -> str:
        """The name of the choice; empty for the file's own coordinates."""
        return self.configuration.name

    @property
    def moving(self) -> tuple[sp.Symbol, ...]:
        """t, coordinates, velocities."""
        slots = self.configuration.slots
        return (t, *slots.coordinates, *slots.velocities)

    def knows(self, names: Iterable[sp.Symbol], all_coordinates: Iterable[sp.Symbol]) -> bool:
        """Whether the coordinates among some symbols are coordinates here, or are expressed in these."""
        known = {*self.configuration.slots.coordinates, *self.configuration.expressed}
        return all(q in known for q in all_coordinates if {q, prime(q), prime(q, 2)} & {*names})


@record
class Meanings:
    """The values of symbols of questions at a state: accelerations, reactions, energies; None if unknown.

    senses    the signs with which velocities and speeds of slip start, where |q'| or sign q' is replaced by their means
    sides     the signs with which coordinates and their differences start, likewise for |q| and |x − y|
    starting  the conditions under which a motion from rest starts against friction
    held      whether friction holds it at rest
    rolling   whether slip does not begin, or its sense is not known, where what touches does not slip at t = 0
    fixed     the coordinates and velocities that constraints hold at their initial values
    """

    accelerations: SymbolValues
    reactions: Mapping[sp.Symbol, sp.Expr | None]
    energies: SymbolValues = field(default_factory=dict)
    senses: Senses = field(default_factory=dict)
    sides: Senses = field(default_factory=dict)
    starting: tuple[SignCondition, ...] = ()
    held: bool = False
    rolling: bool = False
    fixed: SymbolValues = field(default_factory=dict)

    def unknown(self, e: sp.Expr) -> set[sp.Symbol]:
        """The reactions in an expression that are not known."""
        return {s for s, v in self.reactions.items() if v is None and s in e.free_symbols}

    def on_side(self, e: sp.Expr) -> sp.Expr:
        """An expression with |q| and sgn q as at the start."""
        rule: dict[sp.Basic, sp.Expr] = {}
        for f in e.atoms(sp.Abs, sp.sign) if self.sides else ():
            inside = f.args[0].xreplace(dict(self.fixed))  # |x − y| is |y| where x = 0
            side = self.sides.get(inside) or -self.sides.get(-inside, 0)
            if side:
                rule[f] = side * f.args[0] if isinstance(f, sp.Abs) else sp.Integer(side)
        return textbook_form(e.xreplace(rule)) if rule else e

    def applied(self, e: sp.Expr) -> sp.Expr:
        """An expression as a function of position, velocity and time."""
        known = {s: v for s, v in self.reactions.items() if v is not None}
        return e.xreplace({**self.energies, **known}).xreplace(dict(self.accelerations))


def meanings(place: MotionView) -> Meanings:
    """The meanings of all symbols that questions may use, in the coordinates of a place."""
    meant: dict[sp.Symbol, sp.Expr | None] = {}
    reactions = place.dynamics.reactions
    for r in place.law.newton.reactions:
        value = None if reactions is None else reactions.multipliers.get(r.name)
        size = None if reactions is None else reactions.sizes.get(r.name)
        meant[r.multiplier] = value
        if r.symbol is not None:
            meant[r.symbol] = size
        if r.force != r.multiplier:
            meant[r.force] = size
    energy = {KINETIC_ENERGY: textbook_form(kinetic_energy(place.configuration))}
    total = next((i.expression for i in place.conserved.integrals if i.quantity.value == "energy"), None)
    if place.conserved.energy is not None and not place.conserved.energy.hidden:
        total = place.conserved.energy.expression
    if total is not None:
        energy[ENERGY] = total
    return Meanings(_accelerations(place), meant, energy)


def _accelerations(place: MotionView) -> SymbolValues:
    """q'' of the coordinates, without those that cannot be solved for."""
    configuration = place.configuration
    wanted = configuration.slots.accelerations
    equations = [*place.dynamics.equations.expressions, *configuration.accelerated_constraints]
    rest = dict.fromkeys(wanted, sp.S.Zero)
    rows = [[e.diff(a) for a in wanted] for e in equations]
    if any(not c.free_symbols.isdisjoint(wanted) for row in rows for c in row):
        return {}
    try:
        solved = solved_linear(rows, [-e.xreplace(rest) for e in equations], configuration.states)
    except DivisionByZeroError:
        return {}
    pairs = zip(wanted, solved or [], strict=False)
    return {a: v for a, v in pairs if v is not None and count_operations(v) <= LONGEST_EQUATION}


def meanings_at(place: MotionView, known: Meanings, state: SymbolValues) -> Meanings:
    """The meanings where some coordinates and velocities have given values, for what is too large in general.

    state  with expressions in parameters; what is omitted stays
    """
    law, configuration = place.law, place.configuration
    frictions = friction_forces(law.frictions, law.newton, law.configuration, configuration)
    if not state or any(f.also for f in frictions):
        return known
    rule = dict(state)
    slots = law.configuration.slots
    configured = {s: configuration.rewritten(s).xreplace(rule) for s in (*slots.coordinates, *slots.velocities)}
    rows = [[e.xreplace(configured).xreplace(rule) for e in row] for row in law.system.rows]
    right = [e.xreplace(configured).xreplace(rule) for e in law.system.right]
    signs = {sp.sign(v): sp.Integer(s) for v, s in known.senses.items()}
    for f in frictions:  # proportional to the reaction
        column = law.system.unknowns.index(f.reaction.multiplier)
        for k, share in enumerate(f.generalized(f.share)):
            rows[k][column] -= share.xreplace(rule).xreplace(signs)
    try:
        solved = solved_linear(rows, right, configuration.states)
    except DivisionByZeroError:
        return known
    values = {s: v for s, v in zip(law.system.unknowns, solved or [], strict=False) if v is not None}
    reactions = dict(known.reactions)
    for r in law.newton.reactions:
        value = values.get(r.multiplier)
        if value is None:
            continue
        reactions[r.multiplier] = value
        if r.single is not None and r.symbol is not None:
            factor = r.single.factor.xreplace(configured).xreplace(rule)
            reactions[r.symbol] = reactions[r.force] = textbook_form(factor * value)
    accelerations = {s: v for s, v in values.items() if s in configuration.slots.accelerations}
    return replace(known, accelerations={**accelerations, **known.accelerations}, reactions=reactions)


def places_stated(question: Question, slots: Slots) -> dict[sp.Symbol, sp.Expr]:
    """The values of coordinates that the conditions state by themselves, θ = 0."""
    moving = {*slots.coordinates, *slots.velocities, t}
    return {c.lhs: c.rhs for c in question.when if c.lhs in slots.coordinates and c.rhs.free_symbols.isdisjoint(moving)}


def fixed_coordinates(place: MotionView, initial: SymbolValues) -> dict[sp.Symbol, sp.Expr]:
    """The coordinates whose velocity the constraints keep zero, with their initial values, and these velocities.

    Where `initial` says nothing about the position in which they are held, angles are 0 there, as in statics.
    """
    configuration = place.configuration
    slots = configuration.slots
    rows = [list(r.coefficients) for r in configuration.rows if r.nonlinear is None and r.drift == 0]
    if not rows or len(rows) < len(configuration.rows):
        return {}
    fixed: dict[sp.Symbol, sp.Expr] = {}
    held = held_coordinates(configuration) if {*initial}.isdisjoint(_kept(configuration)) else {}
    initial = {**held, **initial}
    try:
        before = configuration.states.rank(rows)
        for n, (q, v) in enumerate(zip(slots.coordinates, slots.velocities, strict=True)):
            alone = [sp.Integer(k == n) for k in range(len(slots.coordinates))]
            if q in initial and before is not None and configuration.states.rank([*rows, alone]) == before:
                fixed |= {q: initial[q], v: sp.S.Zero}
    except DivisionByZeroError:
        return {}
    return fixed


def _kept(configuration: Configuration) -> set[sp.Symbol]:
    """The coordinates in the finite constraints."""
    return set().union(*(f.free_symbols for f in configuration.finite_constraints)) & {*configuration.slots.coordinates}


def held_in_place(known: Meanings, fixed: SymbolValues) -> Meanings:
    """The meanings where the constraints hold some coordinates where they are at t = 0: the tilt of a crate, 0."""
    if not fixed:
        return known
    rule = dict(fixed)
    accelerations = {a: e.xreplace(rule) for a, e in known.accelerations.items()}
    accelerations |= {prime(q, 2): sp.S.Zero for q in fixed if prime(q) in fixed}
    reactions = {s: e if e is None else textbook_form(e.xreplace(rule)) for s, e in known.reactions.items()}
    return replace(
        known,
        accelerations=accelerations,
        reactions=reactions,
        energies={s: e.xreplace(rule) for s, e in known.energies.items()},
        fixed=fixed,
    )


def with_senses(
    known: Meanings,
    initial: SymbolValues,
    given: Senses | None,
    values: SymbolValues,
    frictions: Sequence[Friction] = (),
) -> Meanings:
    """The meanings once the sense of the start is known, where |q'| or the sign of q' occurs: c |q'| q' is c q'^2.

    From rest the motion starts in the direction of the acceleration, if that is against friction in this direction.

    given      the senses, where they are not those of the initial state
    values     numbers for the parameters, which decide what letters leave open
    frictions  whose coefficients at rest hold for the start, if they are given
    """
    senses: dict[sp.Expr, int] = dict(given or {})
    starting: list[SignCondition] = []
    held = rolling = False
    at_rest = {f.coefficient: f.static for f in frictions if f.static is not None and f.coefficient.is_Symbol}

    def sign(e: sp.Expr) -> int | None:
        sense = sign_of(e)
        return sign_of(e.xreplace(dict(values))) if sense is None and e.free_symbols <= values.keys() else sense

    for a, value in known.accelerations.items():
        v = sp.Symbol(a.name[:-1], real=True)
        if v in senses or v not in initial or not value.has(sp.Abs(v), sp.sign(v)):
            continue
        way = sign(initial[v])
        if way == 0 and not value.has(sp.sign(v)):
            way = sign(value.xreplace(dict(initial)))
        elif way == 0:
            rates = [value.xreplace({sp.sign(v): s, sp.Abs(v): sp.S.Zero}).xreplace(dict(initial)) for s in (1, -1)]
            way = sign(sp.expand(sum(rates)))
            if way in (1, -1):
                starts = (way * rates[0 if way == 1 else 1]).xreplace(at_rest)
                moves = sign(starts)
                held = held or moves in (0, -1)
                starting += [more_than_zero(starts)] if moves is None else []
        if way in (1, -1):
            senses[v] = way
    expressions = [e for e in (*known.accelerations.values(), *known.reactions.values()) if e is not None]
    for slip in {f.args[0] for e in expressions for f in e.atoms(sp.Abs, sp.sign) if f.args[0].is_Add}:
        way = sign(slip.xreplace(dict(initial))) if any(base(s) != s for s in slip.free_symbols & {*initial}) else None
        if way == 0 and slip not in senses and any(e.has(sp.sign(slip)) for e in expressions):
            # From rolling or rest it begins in the sense in which the forces drive it, if these exceed friction:
            rate = sp.Add(*(slip.diff(s) * known.accelerations.get(prime(s), prime(s)) for s in slip.free_symbols))
            either = ({sp.sign(slip): sp.Integer(s), sp.Abs(slip): sp.S.Zero} for s in (1, -1))
            rates = [rate.xreplace(rule).xreplace(dict(initial)) for rule in either]
            way = sign(sp.expand(sum(rates)))
            if way not in (1, -1):
                rolling = True
                continue
            starts = (way * rates[0 if way == 1 else 1]).xreplace(at_rest)
            moves = sign(sp.expand(starts))
            rolling = rolling or moves in (0, -1)
            starting += [more_than_zero(starts)] if moves is None else []
        if way in (1, -1):  # x' − R θ' of a ball that is thrown along a lane
            senses[slip] = way
    sides = {
        q: way
        for q in {f.args[0] for e in expressions for f in e.atoms(sp.Abs, sp.sign)}
        if (moving := {s for s in q.free_symbols if prime(s, 2) in known.accelerations})
        and all(s in initial and prime(s) in initial for s in moving)
        and (way := sign(q.xreplace(dict(initial)))) in (1, -1)
    }
    signed = {**sides, **senses}
    rule = {f: e for v, s in signed.items() for f, e in ((sp.Abs(v), s * v), (sp.sign(v), sp.Integer(s)))}
    accelerations = {a: e.xreplace(rule) for a, e in known.accelerations.items()}
    reactions = {s: e if e is None else e.xreplace(rule) for s, e in known.reactions.items()}
    return replace(
        known,
        accelerations=accelerations,
        reactions=reactions,
        senses=senses,
        sides=sides,
        starting=tuple(starting),
        held=held,
        rolling=rolling,
    )


# The initial state


def initial_state(place: MotionView, problem: Problem, others: Sequence[Configuration]) -> dict[sp.Symbol, sp.Expr]:
    """The coordinates and velocities at t = 0, as far as they are determined.

    others  the other sets of coordinates

    Raises ProblemError if what is given contradicts the constraints.
    """
    if not problem.initial:
        return {}
    configuration = place.configuration
    coordinates, velocities = configuration.slots.coordinates, configuration.slots.velocities
    given = {v.symbol: v for v in problem.initial}
    known: dict[sp.Symbol, sp.Expr] = {s: v.value for s, v in given.items() if s in (*coordinates, *velocities)}
    conditions = [
        (_at_start(configuration.rewritten(s)) - v.value, v)
        for s, v in given.items()
        if s in configuration.substitution
    ]
    known |= {s: v for s, v in _from_choices(others, given, (*coordinates, *velocities)).items() if s not in known}
    finite = [_at_start(f) for f in configuration.finite_constraints]
    placed = [e for e, v in conditions if not v.symbol.name.endswith("'")]
    whole = bool(configuration.expressed) and configuration.expressed.keys() <= given.keys()
    known |= _positions([*finite, *placed], coordinates, known, configuration.ranges, one_position=whole)
    rows = [_at_start(r.velocity_form(configuration.slots)) for r in configuration.rows]
    moved = [e for e, v in conditions if v.symbol.name.endswith("'")]
    known |= _velocities([e.xreplace(known) for e in (*rows, *moved)], velocities, known)
    _check_radii(known, problem)
    _check(place, known, problem, conditions)
    return known


def _check_radii(known: SymbolValues, problem: Problem) -> None:
    """Raises ProblemError if the radius of the frame begins negative."""
    for v in problem.initial:
        value = known.get(v.symbol)
        if v.symbol == problem.radius and value is not None and sign_of(value) == -1:
            message = f"the initial value of `{v.symbol}` is negative, and it is a radius"
            help_ = "a radius is not negative: turn the angle by pi instead"
            raise ProblemError(Diagnostic("negative-radius", message, v.span, help=help_))


def _at_start(e: sp.Expr) -> sp.Expr:
    return e.xreplace({t: sp.S.Zero})


def _from_choices(
    others: Sequence[Configuration], given: Mapping[sp.Symbol, InitialValue], wanted: Sequence[sp.Symbol]
) -> dict[sp.Symbol, sp.Expr]:
    """The file's coordinates and velocities where those of a choice are given: x = l sin θ."""
    values = {s: v.value for s, v in given.items()}
    by_choice = {}
    for configuration in others:
        moving = {*configuration.slots.coordinates, *configuration.slots.velocities}
        for s, e in configuration.substitution.items():
            value = _at_start(e).xreplace(values)
            if s in wanted and value.free_symbols.isdisjoint(moving):
                by_choice[s] = value
    return by_choice


def _positions(
    equations: Sequence[sp.Expr],
    coordinates: Sequence[sp.Symbol],
    known: SymbolValues,
    ranges: Mapping[sp.Symbol, Range],
    *,
    one_position: bool = False,
) -> dict[sp.Symbol, sp.Expr]:
    """The coordinates determined by the equations and the known coordinates, within their ranges.

    one_position  all solutions are names of one position, r and θ or −r and θ + π: the simplest is taken
    """
    open_ = [e for e in (f.xreplace(dict(known)) for f in equations) if e.free_symbols & {*coordinates}]
    unknown = [q for q in coordinates if q not in known]
    if not open_ or not unknown:
        return {}
    if one_position and (seen := _angles_seen(open_, unknown)) is not None:
        return seen
    try:
        solved = solutions(open_, unknown)
    except (NotAlgebraicError, DivisionByZeroError):
        return {}
    branches = [b for b in solved.branches if not b.special and not any(_is_beyond(r, ranges) for r in b.relations)]
    if any(b.left for b in branches) or (len(branches) != 1 and not (one_position and branches)):
        return {}
    values = [{r.lhs: r.rhs for r in b.relations if r.lhs in unknown} for b in branches]
    values = [{s: e for s, e in v.items() if not e.free_symbols & {*unknown}} for v in values]
    return min(values, key=_size_of_position)


def _is_beyond(value: Relation, ranges: Mapping[sp.Symbol, Range]) -> bool:
    """Whether a value of a coordinate is certainly outside its range: the bar hangs below its supports, z > 0."""
    limits = ranges.get(value.lhs)
    return limits is not None and -1 in (sign_of(value.rhs - limits.low), sign_of(limits.high - value.rhs))


def _angles_seen(equations: Sequence[sp.Expr], unknown: Sequence[sp.Symbol]) -> dict[sp.Symbol, sp.Expr] | None:
    """Angles that satisfy equations and stand in them already, or are right: θ = α where l sin θ is l sin α.

    None where there are none, or lengths among the unknowns.
    """
    waves = {f for e in equations for f in e.atoms(sp.sin, sp.cos)}
    given = [f.args[0] for f in sorted(waves, key=str) if f.free_symbols.isdisjoint(unknown)]
    angles = {f.args[0] for f in waves}
    if len(unknown) > MOST_ANGLES or len({*given}) > MOST_ANGLES or not {*unknown} <= angles:
        return None
    plain = [e for a in dict.fromkeys(given) for e in (a, sp.pi - a, -a)]
    candidates = [*plain, sp.S.Zero, sp.pi / 2, -sp.pi / 2, sp.pi]
    for values in product(candidates, repeat=len(unknown)):
        rule = dict(zip(unknown, values, strict=True))
        if all(sp.expand(e.xreplace(rule)) == 0 for e in equations):
            return rule
    return None


def _size_of_position(values: SymbolValues) -> tuple[int, float]:
    """The least of this is the simplest of several sets of coordinates of one position: no negative radius, no turn."""
    negative = sum(sign_of(e) == -1 for e in values.values())
    return negative, sum(abs(float(e)) for e in values.values() if e.is_number)


def _velocities(
    equations: Sequence[sp.Expr], velocities: Sequence[sp.Symbol], known: SymbolValues
) -> dict[sp.Symbol, sp.Expr]:
    """The velocities determined by equations linear in them and the known velocities."""
    rates: dict[sp.Symbol, sp.Expr] = {}
    moving = {*velocities, *map(base, velocities)}
    for _ in velocities:
        for e in equations:
            e = e.xreplace(rates)
            unknown = [v for v in velocities if v in e.free_symbols]
            if len(unknown) != 1:
                continue
            [v] = unknown
            slope = e.diff(v)
            # A slope that depends on a position that is not known may be zero in it:
            if not slope.free_symbols.isdisjoint(moving) or is_zero(slope) is not False:
                continue
            rates[v] = tidy_quotient(-e.xreplace({v: sp.S.Zero}) / slope)
    rates |= _together([e.xreplace(rates) for e in equations], [v for v in velocities if v not in rates])
    return {v: value for v, value in rates.items() if v not in known}


def _together(equations: Sequence[sp.Expr], velocities: Sequence[sp.Symbol]) -> dict[sp.Symbol, sp.Expr]:
    """The velocities that several equations determine together: both feet of a crate stay on the floor."""
    present = [v for v in velocities if any(v in e.free_symbols for e in equations)]
    left = [e for e in equations if not e.free_symbols.isdisjoint(present)]
    if len(left) < 2 or len(present) > MOST_TOGETHER:
        return {}
    rows = [[e.diff(v) for v in present] for e in left]
    if any(not c.free_symbols.isdisjoint(velocities) for row in rows for c in row):
        return {}
    at_rest = dict.fromkeys(present, sp.S.Zero)
    right = [-e.xreplace(at_rest) for e in left]
    reduced, pivots = sp.Matrix([[*row, b] for row, b in zip(rows, right, strict=True)]).rref(
        iszerofunc=lambda e: is_zero(e) is not False, simplify=sp.cancel
    )
    if len(present) in pivots:
        return {}
    return {
        present[k]: tidy_quotient(reduced[n, len(present)])
        for n, k in enumerate(pivots)
        if all(reduced[n, other] == 0 for other in range(len(present)) if other != k)
    }


def _check(
    place: MotionView, known: SymbolValues, problem: Problem, conditions: Sequence[tuple[sp.Expr, InitialValue]]
) -> None:
    """Raises ProblemError if the initial state contradicts a constraint."""
    configuration = place.configuration
    moving = {*configuration.slots.coordinates, *configuration.slots.velocities}
    last = problem.initial[-1].span
    values = problem.given_values
    # b = -asin(1/4) is no contradiction to r sin a + l sin b = 0 where l is 4 r
    for row in configuration.rows:
        forms = [row.velocity_form(configuration.slots)]
        if row.finite is not None:
            forms.insert(0, row.finite)
        for velocity, form in enumerate(forms, start=1 if row.finite is None else 0):
            left = _at_start(form).xreplace(dict(known))
            if left.free_symbols & moving or is_zero(left) is not False or is_zero(left.xreplace(values)) is True:
                continue
            kind = "the rate of left minus right" if velocity and row.finite is not None else "left minus right"
            message = f"the initial state contradicts the constraint `{row.name}`"
            label = f"{kind} would be {_with_number(left, problem)}, not 0"
            help_ = "change the values, or leave out those that follow from the others"
            raise ProblemError(Diagnostic("initial-contradicts", message, last, label, help_))
    for e, v in conditions:
        left = e.xreplace(dict(known))
        if not left.free_symbols & moving and is_zero(left) is False and is_zero(left.xreplace(values)) is False:
            message = f"the initial value of `{v.symbol}` contradicts the others"
            label = f"it would differ by {_with_number(left, problem)}"
            help_ = "change the values, or leave out those that follow from the others"
            raise ProblemError(Diagnostic("initial-contradicts", message, v.span, label, help_))


def _with_number(e: sp.Expr, problem: Problem) -> str:
    """`H - 3, that is 9 m`, where the letters have values."""
    from lagrange.problem.values import values_of

    known = values_of(problem)
    quantity = known.quantity(e) if known is not None and e.free_symbols else None
    written = text(tidy_quotient(e))
    return f"{written}, that is {text(quantity.shown())}" if quantity is not None and quantity.is_number else written


def without(state: SymbolValues, letters: Iterable[sp.Symbol]) -> dict[sp.Symbol, sp.Expr]:
    """A state without what contains one of some letters."""
    unknown = {*letters}
    return {s: e for s, e in state.items() if not e.free_symbols & unknown}
