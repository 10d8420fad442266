"""A set of coordinates with all that questions need: the initial state, the integrals with their values.

When the motion turns back from a state of rest against friction or drag, that state becomes the initial one.

Coordinates and velocities that the constraints give outright in terms of the others.

x = l sin θ gives x and x' wherever they occur, so that the equations of a question are left with θ and θ' alone. A
symbol is expressed where it occurs linearly, with a factor of known sign and nowhere else in the constraint.

Parameters that conditions give in terms of others, a = 3 h/2 or tan β = μ: a parameter is expressed where it occurs
linearly, as its square if it is positive, or, an acute angle, in one sine, cosine or tangent.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from functools import cached_property

import sympy as sp

from lagrange.algebra.closed_forms.signs import SignCondition, more_than_zero, sign_of
from lagrange.algebra.exact.zero_test import vanishes
from lagrange.core.diagnostics import ProblemError
from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import Bounded, prime, t
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.friction import friction_forces
from lagrange.mechanics.equilibrium.loads import load_parameters
from lagrange.mechanics.questions.elimination import eliminated
from lagrange.mechanics.questions.integrals_of_motion import has_pole, integrals, resting_centres
from lagrange.mechanics.questions.ranges import does_not_slip
from lagrange.mechanics.questions.results import UsedIntegral
from lagrange.mechanics.questions.states import (
    Meanings,
    MotionView,
    Senses,
    SymbolValues,
    fixed_coordinates,
    held_in_place,
    meanings,
    with_senses,
)
from lagrange.problem.model import Problem, Question


class Setting:
    """A position with all data that questions need about it, computed once.

    initial   the state at t = 0, or a later one from which the motion goes on
    senses    the signs of velocities whose modulus occurs, where they are not those of the initial state
    turnings  how often the motion has come to rest before that
    """

    def __init__(
        self, place: MotionView, problem: Problem, initial: SymbolValues, senses: Senses | None = None
    ) -> None:
        self.turnings = 0 if senses is None else 1
        self._squares: dict[sp.Symbol, sp.Expr | None] = {}
        self.place = place
        self.problem = problem
        self.initial: SymbolValues = initial
        known = held_in_place(meanings(place), self.fixed)
        self.known: Meanings = with_senses(known, initial, senses, self.values, place.law.frictions)
        self.integrals, self.missing = integrals(place, self.known, initial)

    @cached_property
    def values(self) -> SymbolValues:
        """Numbers for the parameters."""
        return self.problem.given_values

    @cached_property
    def not_given(self) -> list[sp.Symbol]:
        """The coordinates and velocities that have no value at t = 0."""
        slots = self.place.configuration.slots
        return [s for s in (*slots.coordinates, *slots.velocities) if s not in self.initial]

    def has_numbers(self, about: Sequence[sp.Expr]) -> bool:
        """Whether the motion, and some expressions, have numbers: it can be integrated numerically."""
        known, moving = self.known.accelerations, {*self.place.moving} | self.values.keys()
        expressions = [*known.values(), *self.initial.values(), *about]
        complete = len(known) == len(self.place.configuration.slots.coordinates) and not self.not_given
        return complete and all(e.free_symbols <= moving for e in expressions)

    def is_of_state(self, quantity: sp.Expr, when: Sequence[sp.Expr]) -> bool:
        """Whether a quantity does not depend on t, or a condition gives t: ω t = 60° of a crank."""
        moving = {*self.place.moving}
        return t not in quantity.free_symbols or any(e.free_symbols & moving == {t} for e in when)

    @cached_property
    def slips(self) -> list[sp.Expr]:
        """Velocities that must not be negative: those of slip in a sense that the file states, or that was taken."""
        return [*(sense * v for v, sense in self.known.senses.items() if v.is_Symbol), *self.stated_slips]

    @cached_property
    def stated_slips(self) -> list[sp.Expr]:
        """What must not be negative: slip as in the file or at the start, and coordinates whose modulus occurs."""
        law = self.place.law
        forces = friction_forces(law.frictions, law.newton, law.configuration, self.place.configuration)
        stated = [f.speed * f.sense for f in forces if f.speed is not None and f.sense in (1, -1)]
        sides = self.known.sides
        stated += [s * e for e, s in self.known.senses.items() if not e.is_Symbol]
        return [*map(self.known.on_side, stated), *(s * q for q, s in sides.items())]

    def square_of(self, q: sp.Symbol) -> sp.Expr | None:
        """q'^2 as a function of q alone; None if the integrals do not give it."""
        if q not in self._squares:
            self._squares[q] = self._square(q)
        return self._squares[q]

    def is_kept_from_zero(self, q: sp.Symbol) -> bool:
        """Whether q'^2 → −∞ for q → 0, as a constant angular momentum has it: q then keeps its sign."""
        square = self.square_of(q) if {q, prime(q)} <= {*self.initial} else None
        if square is None or not square.is_rational_function(q):
            return False
        above, below = sp.fraction(sp.factor(sp.together(square)))
        power = next((f.as_base_exp()[1] for f in sp.Mul.make_args(below) if f.as_base_exp()[0] == q), sp.S.Zero)
        if not power.is_Integer or power <= 0 or power % 2:
            return False
        return sign_of((above / sp.cancel(below / q**power)).xreplace({q: sp.S.Zero})) == -1

    def _square(self, q: sp.Symbol) -> sp.Expr | None:
        configuration = self.place.configuration
        slots = configuration.slots
        rule = self.dependent({q, prime(q)}, q)
        rates = [r.velocity_form(slots) for r in configuration.rows]
        used = [i.expression - i.value for i in self.integrals]
        equations = reduced([*used, *configuration.finite_constraints, *rates], rule)
        unknowns = [s for s in (*slots.velocities, *slots.coordinates) if s != q and s not in rule]
        velocities = [v for v in slots.velocities if v in unknowns]
        if not used or prime(q) in rule:
            return None
        elimination = eliminated(equations, prime(q) ** 2, unknowns, velocities, prime(q) ** 2)
        values = {v for b in elimination.branches for v in b.values}
        moving = {*self.place.moving} - {q}
        if not elimination.solved or elimination.free or len(values) != 1:
            return None
        [value] = values
        return value if value.free_symbols.isdisjoint(moving) else None

    def finite_integrals(self, when: Sequence[sp.Expr]) -> Iterator[Sequence[UsedIntegral]]:
        """The integrals, without those that are infinite where a condition holds; then with mass centres at rest."""
        coordinates = self.place.configuration.slots.coordinates
        used = [i for i in self.integrals if not any(has_pole(i.expression, e, coordinates) for e in when)]
        centres = resting_centres(used, self.place, self.initial)
        yield from (several for several in (used, [*used, *centres] if centres else []) if several)

    def adapted(self, when: Sequence[sp.Expr]) -> sp.Symbol | None:
        """The one parameter without a value, where conditions are about parameters: the force at which a crate tips.

        Of several the one that is an applied force.
        """
        named = {s for e in when for s in e.free_symbols}
        left = named - self.values.keys()
        if len(named) < 2 or not left <= {p.symbol for p in self.problem.parameters}:
            return None
        if len(left) > 1:
            left &= {*load_parameters(self.place.configuration, self.problem.unknowns)}
        return next(iter(left)) if len(left) == 1 else None

    @cached_property
    def fixed(self) -> SymbolValues:
        """The coordinates that the constraints hold where they are at t = 0, and their velocities."""
        return fixed_coordinates(self.place, self.initial)

    def dependent(self, rather_not: Collection[sp.Symbol] = (), never: sp.Symbol | None = None) -> Substitution:
        """The symbols that the constraints give outright, those that they hold where they are at t = 0 among them."""
        held = {s: e for s, e in self.fixed.items() if s != never}
        return held_at(dependent(self.place.configuration, rather_not, never), held)

    def places_of_no_matter(self, accelerations: SymbolValues) -> dict[sp.Symbol, sp.Symbol]:
        """A letter for the initial value of each coordinate that is not given and does not occur in the equations."""
        initial, coordinates = self.initial, self.place.configuration.slots.coordinates
        occurring = set().union(*(e.free_symbols for e in accelerations.values()))
        free = (q for q in coordinates if q not in initial and prime(q) in initial and q not in occurring)
        return {q: sp.Dummy(f"{q}_0", real=True) for q in free}

    def refuse_rolling(self, question: Question) -> None:
        """Raises ProblemError if slip does not begin."""
        if self.known.rolling:
            raise ProblemError(does_not_slip(question))

    def of_either_sense(self, question: Question) -> Iterator[sp.Symbol]:
        """The forces whose sense a question leaves open: those of rolling, and what holds two bodies together, F = μ N.

        Elsewhere a sense matters; a force that only pushes or pulls has one.
        """
        reactions = [r for r in self.place.law.newton.reactions if r.symbol_of_force in mentioned(question)]
        pressed = any(r.constraint.side is not None for r in reactions)
        for r in reactions:
            rolls = r.row.finite is None and question.quantity.is_Symbol and question.quantity.is_positive
            if rolls or (pressed and r.constraint.side is None):
                yield r.symbol_of_force

    def turned(self, state: SymbolValues, senses: Senses) -> Setting:
        """The motion after a state of rest, with these senses."""
        return Setting(self.place, self.problem, state, senses)


def all_coordinates(configuration: Configuration) -> Iterator[sp.Symbol]:
    """The coordinates of a configuration, and those expressed in terms of them."""
    yield from configuration.slots.coordinates
    yield from configuration.expressed


def mentioned(question: Question) -> set[sp.Symbol]:
    """The symbols in the quantity and the conditions of a question."""
    symbols = set(question.quantity.free_symbols)
    return symbols.union(*(c.function.free_symbols for c in question.when))


# Coordinates that constraints give


Substitution = Mapping[sp.Symbol, sp.Expr]


def dependent(
    configuration: Configuration, rather_not: Collection[sp.Symbol] = (), never: sp.Symbol | None = None
) -> dict[sp.Symbol, sp.Expr]:
    """The symbols that are expressed, each in terms of those that are not.

    rather_not  symbols that are expressed only where no other can be
    never       a symbol that is not expressed
    """
    slots = configuration.slots
    rule: dict[sp.Symbol, sp.Expr] = {}
    coordinates = [q for q in slots.coordinates if q != never]
    _express(configuration.finite_constraints, coordinates, rather_not, rule)
    _express([r.velocity_form(slots) for r in configuration.rows], slots.velocities, rather_not, rule)
    return rule


def _express(
    equations: Sequence[sp.Expr],
    symbols: Sequence[sp.Symbol],
    rather_not: Collection[sp.Symbol],
    rule: dict[sp.Symbol, sp.Expr],
) -> None:
    """Adds what the equations give, one after another, to the rule."""
    for e in equations:
        present = e.xreplace(rule)
        for s in sorted((s for s in symbols if s in present.free_symbols), key=lambda s: s in rather_not):
            slope = present.diff(s)
            if s in slope.free_symbols or not _has_sign(slope):
                continue
            value = sp.expand(-present.xreplace({s: sp.S.Zero}) / slope)
            for other, known in rule.items():
                rule[other] = known.xreplace({s: value})
            rule[s] = value
            break


def held_at(rule: Substitution, held: Substitution) -> dict[sp.Symbol, sp.Expr]:
    """What is dependent where some symbols keep their values, and these symbols."""
    values = dict(held)
    return {**{s: e.xreplace(values) for s, e in rule.items()}, **values}


def _has_sign(slope: sp.Expr) -> bool:
    return slope != 0 and count_operations(slope) < 20 and sign_of(slope) in (1, -1)


def reduced(equations: Sequence[sp.Expr], rule: Substitution) -> list[sp.Expr]:
    """The equations with dependent symbols substituted, without those that become identities."""
    changed = [e.xreplace(dict(rule)) for e in equations]
    return [e for e, old in zip(changed, equations, strict=True) if e is old or e == old or not vanishes(e)]


def completed(state: Substitution, rule: Substitution, moving: Collection[sp.Symbol]) -> dict[sp.Symbol, sp.Expr]:
    """A state with the dependent symbols that it determines; `moving` are all coordinates and velocities."""
    values = {s: e.xreplace(dict(state)) for s, e in rule.items() if s not in state}
    return {**state, **{s: v for s, v in values.items() if v.free_symbols.isdisjoint(moving)}}


# Parameters that conditions relate


def related_parameters(
    relations: Sequence[sp.Expr], values: SymbolValues
) -> tuple[dict[sp.Symbol, sp.Expr], list[SignCondition]] | None:
    """Parameters in terms of the others, and where they are real; None if a relation, zero, is not solved for one.

    values  what the file gives: rather a parameter without a value is expressed
    """
    rule: dict[sp.Symbol, sp.Expr] = {}
    conditions: list[SignCondition] = []
    for e in relations:
        present = e.xreplace(rule)
        if vanishes(present):
            continue
        symbols = sorted(present.free_symbols, key=lambda s: (s in values, present.coeff(s) not in (1, -1), str(s)))
        found = next(((s, v) for s in symbols if (v := _value_of(s, present, conditions)) is not None), None)
        if found is None:
            return None
        rule = {**{s: v.xreplace(dict([found])) for s, v in rule.items()}, found[0]: found[1]}
    return rule, conditions


def _value_of(s: sp.Symbol, e: sp.Expr, conditions: list[SignCondition]) -> sp.Expr | None:
    """s where e is zero, if that is one value; adds where it is real."""
    acute = isinstance(s, Bounded) and s.low >= 0 and s.high <= sp.pi / 2
    waves = sorted((w for w in e.atoms(sp.sin, sp.cos, sp.tan) if w.args[0] == s), key=str) if acute else []
    if len(waves) == 2 and {w.func for w in waves} == {sp.sin, sp.cos}:
        e = sp.expand(sp.expand(e) / sp.cos(s)).xreplace({sp.sin(s) / sp.cos(s): sp.tan(s)})
        waves = [sp.tan(s)]
    square = [s**2] if s.is_positive and s**2 in e.atoms(sp.Pow) else []
    for function in [s, *square, *waves]:
        letter = sp.Dummy("y")
        present = e.xreplace({function: letter}) if function != s else e
        of = letter if function != s else s
        slope = present.diff(of)
        if (function != s and s in present.free_symbols) or of in slope.free_symbols or not _has_sign(slope):
            continue
        value = sp.factor(-present.xreplace({of: sp.S.Zero}) / slope)
        if function == s:
            return value
        if function in square:
            conditions += [] if sign_of(value) == 1 else [more_than_zero(value)]
            return sp.sqrt(value)
        if function.func is not sp.tan:
            conditions += [] if sign_of(1 - value) == 1 else [more_than_zero(1 - value)]
        return {sp.sin: sp.asin, sp.cos: sp.acos, sp.tan: sp.atan}[function.func](value)
    return None


def may_equal(parameter: sp.Symbol, value: sp.Expr) -> bool:
    """Whether a parameter may have a value: a length is positive, an acute angle less than π/2."""
    if isinstance(parameter, Bounded) and value.is_number:
        return value.is_real is not False and bool(parameter.low <= value) and bool(value <= parameter.high)
    return not (parameter.is_positive and sign_of(value) in (0, -1))
