"""Where a simulation starts: numbers for parameters, and the state at t = 0.

What the file or the user gives is taken: `value:`, `initial:`, `--set`. Initial values may be those of any coordinates,
the file's or a choice's; the state is the one nearest to the position of the figure that has them and satisfies the
constraints, with the smallest speeds that do. Whatever nobody gave is assumed (`defaults.py`), and reported as
assumed. A system that would stay at rest in equilibrium is started slightly away from it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field, replace
from importlib.util import find_spec

import sympy as sp

from lagrange.core.diagnostics import Diagnostic, Fragment, NotCoveredError, ProblemError, Span, suggestion
from lagrange.core.expression_size import distinct_parts
from lagrange.core.records import record
from lagrange.core.symbols import Slots, base, prime, t
from lagrange.core.units import split_number
from lagrange.expressions.reader import canonical_name, read_scalar
from lagrange.mechanics.results import Solution
from lagrange.pictures.floats import NoValueError, value
from lagrange.problem.model import InitialValue, Problem
from lagrange.problem.values import read_number_with_unit
from lagrange.programs.defaults import (
    KnownSense,
    angles_in,
    default_velocities,
    drawn_position,
    parameter_value,
    slip_speeds,
    slipping,
)
from lagrange.programs.limits import LARGEST_CONTRADICTION, PUSH
from lagrange.programs.numerical_system import FloatValues, NumericalSystem, solved_near
from lagrange.programs.special.orbits import orbit
from lagrange.programs.state_equations import StateEquations


@record
class Settings:
    """What the command line sets.

    parameters  texts NAME=VALUE of parameters, which reading the problem takes
    initial     values of coordinates and velocities at t = 0
    functions   expressions for undefined functions and prescribed motions, in t or the names of their arguments
    """

    parameters: tuple[Fragment, ...] = ()
    initial: tuple[InitialValue, ...] = ()
    functions: Mapping[str, sp.Expr] = field(default_factory=dict)


@record
class Start:
    """Where a simulation starts.

    values   a number for each parameter, in SI units
    state    y at t = 0
    assumed  names of what nobody has given, with the numbers taken: parameters, components of the state
    pushed   whether the state was moved away from an equilibrium
    orbits   whether velocities are those of a nearly circular orbit, because something attracts
    """

    values: FloatValues
    state: tuple[float, ...]
    assumed: Mapping[str, float]
    pushed: bool = False
    orbits: bool = False


# -- the command line --------------------------------------------------------------------------------------------------


def settings_of(problem: Problem, settings: Sequence[Fragment]) -> Settings:
    """The settings of a command line, by what they set. Raises ProblemError with all that cannot be read."""
    state = _state_names(problem)
    functions = {f.name: f.arguments for f in problem.functions} | {u.name: ("t",) for u in problem.slots.prescribed}
    parameters: list[Fragment] = []
    initial: dict[sp.Symbol, InitialValue] = {}
    given: dict[str, sp.Expr] = {}
    errors: list[Diagnostic] = []
    for setting in settings:
        written, _, value = setting.text.partition("=")
        at = len(written) + 1 + len(value) - len(value.lstrip())
        part = Fragment(value.strip(), setting.span(at, at + len(value.strip())), at)
        plain = written.strip().rstrip("'")
        name = (canonical_name(plain) or plain) + "'" * (len(written.strip()) - len(plain))
        try:
            if not value.strip():
                parameters.append(setting)
            elif name in state:
                symbol = state[name]
                initial[symbol] = InitialValue(symbol, _initial(part, symbol, problem), part.whole)
            elif name in functions:
                given[name] = _function(part, functions[name], problem)
            elif name.endswith("'"):
                message = f"`{name}` is no velocity of this problem"
                help_ = suggestion(name, list(state), "coordinates and velocities")
                raise ProblemError(Diagnostic("unknown-parameter", message, setting.span(0, len(written)), help=help_))
            else:
                parameters.append(setting)
        except ProblemError as error:
            errors += error.diagnostics
    if errors:
        raise ProblemError(errors)
    return Settings(tuple(parameters), tuple(initial.values()), given)


def _state_names(problem: Problem) -> dict[str, sp.Symbol]:
    coordinates = [q.symbol for q in problem.coordinates] + [q for c in problem.choices for q in c.coordinates]
    return {s.name: s for q in coordinates for s in (q, prime(q))} | {u.symbol.name: u.symbol for u in problem.speeds}


def _initial(part: Fragment, symbol: sp.Symbol, problem: Problem) -> sp.Expr:
    """A number with its unit, or an expression in parameters."""
    if split_number(part.text) is not None:
        return read_number_with_unit(part, None, symbol, None).number
    return _in(part, {p.symbol for p in problem.parameters}, problem, "parameters")


def _function(part: Fragment, arguments: Sequence[str], problem: Problem) -> sp.Expr:
    """An expression in the arguments of a function and in parameters."""
    places = {n: t if n == "t" else sp.Symbol(n, real=True) for n in arguments}
    scope = replace(problem.scope, scalars={**problem.scope.scalars, **places})
    allowed = {p.symbol for p in problem.parameters} | {*places.values()}
    read = read_scalar(part, scope)
    _check_symbols(read, allowed, part, f"{', '.join(arguments)} and parameters")
    return read


def _in(part: Fragment, allowed: set[sp.Symbol], problem: Problem, what: str) -> sp.Expr:
    read = read_scalar(part, problem.scope)
    _check_symbols(read, allowed, part, what)
    return read


def _check_symbols(e: sp.Expr, allowed: set[sp.Symbol], part: Fragment, what: str) -> None:
    strange = sorted(e.free_symbols - allowed, key=str)
    if strange:
        message = f"`{strange[0]}` cannot be used here"
        help_ = f"write a number, with its unit if you like, or an expression in {what}"
        raise ProblemError(Diagnostic("not-allowed-here", message, part.whole, help=help_))


# -- numbers for parameters, and the state -----------------------------------------------------------------------------


def start(
    states: StateEquations,
    solution: Solution,
    initial: Iterable[InitialValue] = (),
    given: Mapping[str, float] | None = None,
    drawn: Mapping[sp.Symbol, float] | None = None,
) -> Start:
    """The numbers and the state with which a simulation starts.

    initial  values that replace or complete those of the file
    given    numbers for parameters, by name, that replace those of the file
    drawn    the numbers of the position that the figure shows, where they are known already

    Raises ProblemError if initial values contradict each other or the constraints.
    """
    problem = states.problem
    assumed: dict[str, float] = {}
    drawn = drawn_position(solution, states.view, states.configuration) if drawn is None else drawn
    values = _numbers(states, given or {}, drawn, assumed)
    wanted = {v.symbol: v for v in (*problem.initial, *initial)}
    guess = _guess(states, values, drawn, stated=bool(wanted))
    if states.functions or find_spec("numpy") is None:  # nothing can be brought to the constraints then
        return Start(values, tuple(guess), assumed | {s.name: x for s, x in zip(states.state, guess, strict=True)})
    turned = None if wanted else orbit(states, values, guess)
    system = NumericalSystem(states, values)
    state, named = _state(system, list(wanted.values()), turned or guess)
    assumed |= {s.name: x for s, x in zip(states.state, state, strict=True) if s.name not in named}
    pushed = _rests(system, state)
    if pushed:
        state = _pushed(system, state, at_rest=bool(named))
        assumed |= {n: x for s, x in zip(states.state, state, strict=True) if (n := s.name) in assumed}
    return Start(values, tuple(state), assumed, pushed, orbits=turned is not None)


def _numbers(
    states: StateEquations, given: Mapping[str, float], drawn: Mapping[sp.Symbol, float], assumed: dict[str, float]
) -> dict[sp.Symbol, float]:
    problem, angles = states.problem, angles_in(states.expressions)
    values: dict[sp.Symbol, float] = {}
    used = {p.symbol for p in states.parameters}.union(*(v.value.free_symbols for v in problem.initial))
    for symbol, p in {p.symbol: p for p in (*problem.parameters, *states.parameters)}.items():
        if symbol.name in given:
            values[symbol] = float(given[symbol.name])
            continue
        unknown = symbol in problem.unknowns
        values[symbol] = 0.0 if unknown else parameter_value(symbol, p, problem, drawn, symbol in angles)
        if p.value is None and symbol in used:
            assumed[symbol.name] = values[symbol]
    return {**dict.fromkeys(states.branches, 1.0), **values}  # a sign that cancels in the equations is in positions


def _guess(
    states: StateEquations, values: FloatValues, drawn: Mapping[sp.Symbol, float], *, stated: bool
) -> list[float]:
    """The state where none is given: the position of the figure, at rest where anything is `stated`."""
    e = states.equations
    at: dict[sp.Symbol, float] = {**values, t: 0.0, **{q: drawn.get(q, 0.5) for q in e.slots.coordinates}}
    speeds = dict.fromkeys(e.speeds, 0.0)
    if not stated:
        at |= default_velocities(states.problem, states.configuration)
        defined = {s.symbol: states.configuration.rewritten(s.definition) for s in states.problem.speeds}
        speeds = {s: _known(defined.get(s, s), at) for s in e.speeds}
        slips = [sp.Abs(x) if kind is KnownSense.UNKNOWN else x for kind, x in slip_speeds(states.view.dynamics)]
        speeds = slipping({**at, **speeds}, e.speeds, slips, values)
    return [*(at[q] for q in e.slots.coordinates), *(speeds[s] for s in e.speeds)]


def _known(e: sp.Expr, at: Mapping[sp.Symbol, float]) -> float:
    try:
        return value(e, at)
    except NoValueError:
        return 0.0


def _state(
    system: NumericalSystem, wanted: Sequence[InitialValue], guess: Sequence[float]
) -> tuple[list[float], set[str]]:
    """The state with these initial values, and the names of its components that they determine one by one.

    Coordinates of other choices are unknowns too, related to the present ones by the coordinates of the file.
    """
    states, values = system.states, system.values
    e = states.equations
    slots, numbers = e.slots, {**values, t: 0.0}
    direct = {v.symbol: v for v in wanted}
    others = _Others.of(states, wanted)
    places, speeds = _conditions(states, wanted, others)
    unknown = (*slots.coordinates, *others.coordinates)
    count = len(slots.coordinates)
    guessed = [*guess[:count], *(0.5 for _ in others.coordinates)]
    # The position of an impact may have been left open: y = a x² with any x, which the equations below then settle.
    direct = {q: v for q, v in direct.items() if v.value.free_symbols <= values.keys()}
    start = [_value(direct[q].value, values) if q in direct else g for q, g in zip(unknown, guessed, strict=True)]
    start = others.placed(start, unknown, values)
    solved, error = solved_near([*e.finite, *others.places, *(c for c, _ in places)], unknown, start, numbers)
    _refuse(error, solved, wanted, [v for _, v in places])
    at = {**numbers, **dict(zip(unknown, solved, strict=True))}
    positions = solved[:count]
    forms = [*e.velocity_forms, *others.speeds, *(c for c, _ in speeds)]
    velocities = {*e.speeds}
    nonlinear = any(not a.free_symbols.isdisjoint(velocities) for row in e.constraint_matrix for a in row)
    moving = (*e.speeds, *others.velocities)
    usual = [*guess[count:], *(0.0 for _ in others.velocities)]
    different = [1 + 0.1 * k for k in range(len(moving))]
    # A constraint that is not linear in the velocities gives no direction at rest, and leads there from others.
    for first in (different,) if nonlinear else (usual, different):
        solved, error = solved_near(forms, moving, first, at)
        rates = solved[: len(e.speeds)]
        if error < LARGEST_CONTRADICTION and _has_rate(system, [*positions, *rates]):
            break
    _refuse(error, rates, wanted, [v for _, v in speeds])
    return [*positions, *rates], {v.symbol.name for v in wanted}


@record
class _Others:
    """Coordinates of other choices in which initial values are given, and what relates them to the present ones."""

    coordinates: tuple[sp.Symbol, ...] = ()
    places: tuple[sp.Expr, ...] = ()
    speeds: tuple[sp.Expr, ...] = ()
    expressed: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)

    @classmethod
    def of(cls, states: StateEquations, wanted: Sequence[InitialValue]) -> _Others:
        """The relations through the choices that are needed. Raises ProblemError if a value cannot be used."""
        known = {*states.equations.slots.coordinates, *states.equations.speeds, *states.configuration.expressed}
        coordinates: dict[sp.Symbol, None] = {}
        places: list[sp.Expr] = []
        speeds: list[sp.Expr] = []
        expressed: dict[sp.Symbol, sp.Expr] = {}
        for v in wanted:
            q = base(v.symbol)
            if {q, v.symbol} & known or q in coordinates:
                continue
            choice = next((c for c in states.problem.choices if q in c.coordinates and c.substitute is not None), None)
            if choice is None or choice.substitute is None:
                message = f"the initial value of `{v.symbol}` cannot be used in these coordinates"
                help_ = "choose coordinates that it belongs to with `--choice`, or leave the value out"
                raise ProblemError(Diagnostic("initial-contradicts", message, v.span, help=help_))
            slots = Slots(choice.coordinates, states.equations.slots.prescribed)
            coordinates |= dict.fromkeys(x for x in choice.coordinates if x not in known)
            for old, e in choice.substitute.items():
                expressed[old] = e
                places.append(states.in_state(old) - e)
                speeds.append(states.in_state(prime(old)) - slots.time_derivative(e))
        return cls(tuple(coordinates), tuple(places), tuple(speeds), expressed)

    @property
    def velocities(self) -> tuple[sp.Symbol, ...]:
        """Their velocities."""
        return tuple(prime(q) for q in self.coordinates)

    def placed(self, start: Sequence[float], unknown: Sequence[sp.Symbol], values: FloatValues) -> list[float]:
        """A guess in which coordinates of the file are where the other coordinates put them."""
        at = {**values, t: 0.0, **dict(zip(unknown, start, strict=True))}
        return [
            _value(self.expressed[q], at) if q in self.expressed else x for q, x in zip(unknown, start, strict=True)
        ]


def _conditions(
    states: StateEquations, wanted: Sequence[InitialValue], others: _Others
) -> tuple[list[tuple[sp.Expr, InitialValue]], list[tuple[sp.Expr, InitialValue]]]:
    """Expressions that vanish at t = 0: of positions, and of speeds."""
    velocities = {*states.equations.speeds, *others.velocities, *states.equations.slots.velocities}
    places: list[tuple[sp.Expr, InitialValue]] = []
    speeds: list[tuple[sp.Expr, InitialValue]] = []
    for v in wanted:
        own = v.symbol in others.coordinates or v.symbol in others.velocities
        e = v.symbol if own else states.in_state(v.symbol)
        (places if e.free_symbols.isdisjoint(velocities) else speeds).append((e - v.value, v))
    return places, speeds


def _value(e: sp.Expr, values: FloatValues) -> float:
    return float(sp.N(e.xreplace({s: sp.Float(v, 17) for s, v in values.items()}), 17))


def _refuse(error: float, state: Sequence[float], wanted: Sequence[InitialValue], used: Sequence[InitialValue]) -> None:
    """Raises ProblemError if no state has the initial values and satisfies the constraints."""
    if error < LARGEST_CONTRADICTION * (1 + max(map(abs, state), default=0.0)):
        return
    span: Span | None = used[-1].span if used else (wanted[-1].span if wanted else None)
    message = "no state near the position of the figure has these initial values and satisfies the constraints"
    help_ = "change the values, or leave out those that follow from the others"
    raise ProblemError(Diagnostic("initial-contradicts", message, span, help=help_))


def _rests(system: NumericalSystem, state: Sequence[float]) -> bool:
    """Whether nothing would change: the system is at rest in a position of equilibrium."""
    states = system.states
    try:
        rate = system.rate(0.0, *state)
    except (ArithmeticError, ValueError, NotCoveredError):  # a function that is still to be given
        return False
    if max(map(abs, rate), default=0.0) >= PUSH * 1e-6:
        return False
    return {t, *states.equations.slots.prescribed}.isdisjoint(distinct_parts(states.expressions))


def _has_rate(system: NumericalSystem, state: Sequence[float]) -> bool:
    try:
        system.rate(0.0, *state)
    except (ArithmeticError, ValueError):
        return False
    return True


def _pushed(system: NumericalSystem, state: Sequence[float], *, at_rest: bool) -> list[float]:
    """A state next to an equilibrium: a little aside where the file wants rest, otherwise with speeds of 1."""
    e = system.states.equations
    n = len(e.slots.coordinates)
    moved = [y + PUSH for y in state[:n]] + list(state[n:]) if at_rest else [*state[:n], *(1.0 for _ in e.speeds)]
    try:
        return list(system.projected(0.0, tuple(moved)) or moved)
    except ArithmeticError:
        return list(state)
