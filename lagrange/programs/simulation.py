"""A motion integrated from its initial state, with events, and with measures of its accuracy.

The state is brought back to the constraints after every step, so that they are kept for any time. Events are zeros of
functions of the state, located on the interpolating polynomial of the step in which the sign changes:

    the condition of a question       the first time is reported, and the motion goes on
    contact, slip in a stated sense,  where it ends the equations end too, and so does the simulation
    mass that joins or leaves
    the sign of a slip, of |R|        the step ends there, and the motion goes on with the other sign; where neither
                                      sign goes on, friction holds the system, and the simulation ends
    slip in a plane                   likewise, where its speed has become zero, with the direction in which it begins
    a two-sided reaction              that it changes its sign is reported, and the motion goes on

Conserved quantities are not enforced: their drift, relative to the largest sum of the sizes of their terms, measures
the errors of the integration. A zero that is only touched is not seen.
"""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Callable, Mapping, Sequence
from dataclasses import field, replace
from enum import StrEnum
from typing import Any

import sympy as sp

from lagrange.core.diagnostics import NotCoveredError
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import partial
from lagrange.problem.model import ENERGY, Question
from lagrange.programs.contacts import Guard
from lagrange.programs.integrator import IntegrationStep, IntegrationStoppedError, State, at, interpolated, steps
from lagrange.programs.limits import (
    ENDED_SLIP,
    LARGEST_DRIFT,
    LEAST_SAMPLES,
    LONGEST_EXPANDED,
    MOST_FLIPS,
    MOST_SAMPLES,
    NARROW,
    NEXT_TO_NOTHING,
    REPEATED,
    ROUNDING,
    SAMPLES_A_SECOND,
    SLOWEST_REFERENCE,
    TOLERANCE,
    WRONG_SIGN,
)
from lagrange.programs.numerical_system import NumericalSystem, value_or_nan
from lagrange.programs.special.poles import REASON, pole
from lagrange.programs.starting import Start
from lagrange.programs.state_equations import StateEquations
from lagrange.programs.sticking import beginning, beginning_in_plane, growth, with_static_coefficients

Watched = Callable[..., float]


class EventKind(StrEnum):
    """What happens at an event."""

    ASKED = "asked"  # the condition of a question holds
    CONTACT = "contact"  # a contact or a string ends
    REVERSED = "reversed"  # the force of a two-sided constraint changes its sign
    AT_REST = "at rest"  # of several slips in planes one ends
    EXCHANGE = "exchange"  # mass no longer joins a particle, or no longer leaves it
    EMPTY = "empty"  # a particle that loses mass has none left
    SLIP = "slip"  # slip ends to have the sense for which the equations hold
    HELD = "held"  # slip ends, and friction keeps it from beginning again
    STOPPED = "stopped"  # the integration cannot go on


@record
class Event:
    """Something that happened.

    name   of the question, the constraint; the reason where the integration cannot go on
    value  of the quantity asked
    """

    kind: EventKind
    name: str
    time: float
    state: State
    value: float | None = None


@record
class Simulation:
    """A motion in numbers.

    times      shape (N,)
    states     y at these times, shape (n + p, N)
    events     in their order
    drift      of each conserved quantity, relative
    violation  the largest error in the constraints, relative
    repeated   if nothing is conserved: how far the motion is from one with ten times the tolerance, relative
    count      the steps taken
    """

    equations: StateEquations
    start: Start
    times: Any
    states: Any
    system: NumericalSystem
    events: tuple[Event, ...] = ()
    drift: Mapping[str, float] = field(default_factory=dict)
    violation: float = 0.0
    repeated: float | None = None
    count: int = 0

    @property
    def names(self) -> tuple[str, ...]:
        """The names of the components of the state."""
        return tuple(s.name for s in self.equations.state)

    @property
    def is_accurate(self) -> bool:
        """Whether what is conserved and the constraints were kept, and the integration went on to its end."""
        kept = all(d <= LARGEST_DRIFT for d in (*self.drift.values(), self.violation, self.repeated or 0.0))
        return kept and not any(e.kind is EventKind.STOPPED for e in self.events)

    def along(self, expression: sp.Expr) -> Any:
        """The values of an expression of the problem at the times, shape (N,).

        Raises NotCoveredError if it contains something that is not a function of the state.
        """
        return self.system.along(meant(self.equations, expression), self.times, self.states)


def meant(states: StateEquations, expression: sp.Expr) -> sp.Expr:
    """An expression of a file in terms of state, accelerations and multipliers: energies, reactions substituted."""
    rule: dict[sp.Basic, sp.Basic] = {sp.Symbol(n, real=True): e for n, e in states.reactions.items()}
    if states.energy is not None:
        rule[ENERGY] = states.energy
    return states.in_state(expression.xreplace(rule)).xreplace(rule)


def _distance(one: Any, other: Any) -> float:
    """The largest difference of two motions in one component, relative to the largest coordinate or speed."""
    import numpy

    count = min(one.shape[1], other.shape[1])
    half = len(one) // 2
    sizes = [float(numpy.abs(part).max(initial=0.0)) for part in (one[:half], one[half:])]
    apart = numpy.abs(one[:, :count] - other[:, :count]).max(axis=1, initial=0.0)
    return max(float(d) / (sizes[k >= half] or 1.0) for k, d in enumerate(apart))


@record
class _Watch:
    """A function of the state whose sign is watched; `others` vanish too where the event counts."""

    kind: EventKind | None
    name: str
    value: Watched
    falling: bool = False
    others: tuple[Watched, ...] = ()
    indicator: sp.Expr | None = None
    question: Question | None = None
    slip: tuple[sp.Expr, ...] = ()


# Of what happens at one time, questions are answered first, and that a sign of |R| changes comes last.
_LATER: Mapping[EventKind | None, float] = {EventKind.ASKED: 0.0, None: 2e-9}


def simulated(
    states: StateEquations,
    start: Start,
    until: float,
    *,
    questions: Sequence[Question] = (),
    samples: int | None = None,
    tolerance: float = TOLERANCE,
) -> Simulation:
    """The motion from its start until a time, or until its equations cease to hold.

    Raises NotCoveredError if the equations contain something that has no numbers.
    """
    run = _Run(states, start, until, questions, samples, tolerance)
    run.go()
    if 0 < run.ended < until:
        run = _Run(states, start, until, questions, samples, tolerance, shown=run.ended)
        run.go()
    made = _until_pole(run.result())
    if made.drift or not len(made.times):
        return made
    again = _Run(states, start, until, (), samples, REPEATED * tolerance, shown=run.ended)
    again.go()
    return replace(made, repeated=_distance(made.states, again.result().states))


def _until_pole(made: Simulation) -> Simulation:
    """The motion as far as a pole of the coordinates, if what is conserved changes there."""
    name = max(made.drift, key=lambda n: made.drift[n], default=None)
    if name is None or not made.drift[name] > LARGEST_DRIFT:
        return made
    import numpy

    values = made.system.along(made.equations.conserved[name], made.times, made.states)
    share = made.drift[name] / float(numpy.abs(values - values[0]).max())
    k = pole(made.system, made.times, made.states, share * numpy.abs(values - values[0]), LARGEST_DRIFT)
    if k is None:
        return made
    end = float(made.times[k])
    stop = Event(EventKind.STOPPED, REASON, end, tuple(made.states[:, k].tolist()))
    events = (*(e for e in made.events if e.time <= end), stop)
    return _judged(replace(made, times=made.times[: k + 1], states=made.states[:, : k + 1], events=events))


class _Run:
    def __init__(
        self,
        states: StateEquations,
        start: Start,
        until: float,
        questions: Sequence[Question],
        samples: int | None,
        tolerance: float,
        shown: float | None = None,
    ) -> None:
        import numpy

        self.states, self.start, self.until, self.tolerance = states, start, until, tolerance
        end = until if shown is None else shown
        wanted = int(min(max(LEAST_SAMPLES, end * SAMPLES_A_SECOND), MOST_SAMPLES))
        self.grid = numpy.linspace(0.0, end, samples or wanted + 1)
        self.ended = until
        self._times: list[float] = self.grid.tolist()
        self.asked = [q for q in questions if q.when]
        self.system = NumericalSystem(states, start.values)
        self.pieces: list[tuple[float, float, State, Sequence[State], int]] = []
        self.events: list[Event] = []
        self.count = self.flips = 0
        self.sides: dict[str, int] = {}
        self.last: tuple[float, State] = (0.0, start.state)
        self.begun = start.state

    def go(self) -> None:
        """Integrates to the end."""
        time, state = 0.0, self.start.state
        try:
            self.system = self._consistent(time, state)
            if not self._begins(time, state):
                return
            state = self.begun
            while time < self.until:
                again = self._smooth(time, state)
                if again is None:
                    return
                time, state = again
        except IntegrationStoppedError as stop:
            empty = self._emptied(stop.time)
            kind, name = (EventKind.STOPPED, stop.reason) if empty is None else (EventKind.EMPTY, empty)
            self._end(kind, name, stop.time, self.last[1])

    def _emptied(self, time: float) -> str | None:
        """The particle with next to no mass left where the motion stops: any force accelerates it without bound."""
        for name, mass in self.states.masses.items():
            value = self.system.function(mass)
            first, last = value(0.0, *self.start.state), value(time, *self.last[1])
            if last < NEXT_TO_NOTHING * first:
                return name
        return None

    def _smooth(self, time: float, state: State) -> tuple[float, State] | None:
        """Integrates until a sign changes, and returns the state there; None at the end."""
        system, watched = self.system, self._watched()
        size = max((abs(y) for y in state), default=1.0)
        before = [value_or_nan(w.value, time, state) for w in watched]
        run = steps(
            system.rate,
            time,
            state,
            self.until,
            self.tolerance,
            self.tolerance * min(1.0, max(size, 1e-6)),
            self._longest,
        )
        step = next(run, None)
        while step is not None:
            self.count += 1
            corrected = self._projected(step)
            after = [value_or_nan(w.value, step.end, corrected or step.after) for w in watched]
            crossed = [w for w, a, b in zip(watched, before, after, strict=True) if _crosses(w, a, b)]
            if crossed:
                end = self._crossed(step, crossed)
                if end is not None:
                    return end if end[0] < math.inf else None
            self._keep(step, step.end)
            self.last = (step.end, corrected or step.after)
            before = after
            try:
                step = run.send(corrected)  # type: ignore[attr-defined]
            except StopIteration:
                step = None
        return None

    @property
    def _longest(self) -> float:
        """The longest step: events are looked for once in each."""
        watched = self.asked or self.states.contacts or self.states.exchanges or self.states.masses or self.system.signs
        return self.until / 50 if watched else math.inf

    def _projected(self, step: IntegrationStep) -> State | None:
        try:
            return self.system.projected(step.end, step.after)
        except (ArithmeticError, ValueError):
            raise IntegrationStoppedError(step.end, "the constraints cannot be met any more") from None

    # -- events --------------------------------------------------------------------------------------------------------

    def _begins(self, time: float, state: State) -> bool:
        """Whether the equations hold at the start: contacts press, and what is to slip does."""
        resting = [e for e in self.system.slips if abs(value_or_nan(self.system.function(e), time, state)) <= NARROW]
        if resting:
            begun = beginning(self.system, resting, time, state)
            if begun is None:
                self._end(EventKind.HELD, str(resting[0]), time, state)
                return False
            self.system = self.system.with_signs(begun)
        for slip in self.states.plane_slips:
            if not self._speed_squared(slip, time, state) > NARROW:
                begun_in_plane = self._slides_again(slip, time, state)
                if begun_in_plane is None:
                    return False
                self.begun = begun_in_plane
        for c in self.states.contacts:
            x = value_or_nan(self.system.function(c.value), time, state)
            self.sides[c.name] = (x > 0) - (x < 0)
            if c.guard < Guard.KEEPS_SIGN and x < -WRONG_SIGN:
                self._end(EventKind.CONTACT, c.name, time, state)
                return False
        return True

    def _watched(self) -> list[_Watch]:
        function, states = self.system.function, self.states
        ended, reversed_ = [], []
        for c in states.contacts:
            side = self.sides[c.name] if c.guard >= Guard.KEEPS_SIGN else 1
            if c.guard is not Guard.TWO_SIDED and side:
                ended.append(_Watch(EventKind.CONTACT, c.name, function(side * c.value), falling=True))
            elif c.guard is Guard.TWO_SIDED and all(e.name != c.force for e in self.events):
                reversed_.append(_Watch(EventKind.REVERSED, c.force, function(c.value)))
        watches = [*ended, *(_Watch(EventKind.SLIP, str(e), function(e), falling=True) for e in states.slips)]
        for slip in states.plane_slips:
            least = (ENDED_SLIP * self._reference(slip)) ** 2
            square = function(sp.Add(*(c**2 for c in slip)) - least)
            watches.append(_Watch(EventKind.AT_REST, str(slip), square, falling=True, slip=slip))
        watches += [_Watch(EventKind.EXCHANGE, n, function(e), falling=True) for n, e in states.exchanges.items()]
        watches += [_Watch(EventKind.EMPTY, n, function(e), falling=True) for n, e in states.masses.items()]
        watches += [_Watch(None, str(e), function(e), indicator=e) for e in self.system.signs]
        return [*watches, *reversed_, *(w for q in self.asked for w in self._watch_of(q))]

    def _watch_of(self, question: Question) -> list[_Watch]:
        try:
            first, *others = [self.system.function(meant(self.states, c.function)) for c in question.when]
        except NotCoveredError:
            return []
        return [_Watch(EventKind.ASKED, question.name, first, others=tuple(others), question=question)]

    def _crossed(self, step: IntegrationStep, crossed: Sequence[_Watch]) -> tuple[float, State] | None:
        """Records the events of a step; returns where to go on, at infinity for nowhere, None to the next step."""
        coefficients = step.interpolation()
        roots = ((self._root(w.value, step, coefficients), w) for w in crossed)
        places = sorted(roots, key=lambda p: p[0] + _LATER.get(p[1].kind, 1e-9) * max(1.0, p[0]))
        for time, watch in places:
            state = self._on_constraints(time, at(step, coefficients, time))
            if watch.kind is EventKind.ASKED:
                self._answer(watch, time, state)
                continue
            if watch.kind is EventKind.REVERSED:
                if all(e.name != watch.name for e in self.events):
                    self.events.append(Event(watch.kind, watch.name, time, state))
                continue
            if time <= self.last[0] + NARROW * max(1.0, abs(time)) and watch.kind is None and self.flips:
                continue  # the sign that has just been taken
            self._keep(step, time)
            self.last = (time, state)
            if watch.slip:
                again = self._slides_again(watch.slip, time, state)
                return (math.inf, state) if again is None else (time, again)
            if watch.kind is not None:
                self._end(watch.kind, watch.name, time, state)
                return math.inf, state
            return self._flipped(watch, time, state)
        return None

    def _root(self, value: Watched, step: IntegrationStep, coefficients: Sequence[State]) -> float:
        """The time at which a function changes its sign in a step, by bisection."""
        low, high = step.time, step.end
        sign = value_or_nan(value, low, step.before) > 0
        while high - low > NARROW * max(1.0, abs(high)):
            middle = (low + high) / 2
            if (value_or_nan(value, middle, at(step, coefficients, middle)) > 0) == sign:
                low = middle
            else:
                high = middle
        return high

    def _on_constraints(self, time: float, state: State) -> State:
        try:
            return self.system.projected(time, state) or state
        except (ArithmeticError, ValueError):
            return state

    def _answer(self, watch: _Watch, time: float, state: State) -> None:
        assert watch.question is not None
        size = 1 + max(map(abs, state))
        if any(not abs(value_or_nan(o, time, state)) < 1e-6 * size for o in watch.others):
            return
        if any(e.kind is EventKind.ASKED and e.name == watch.name for e in self.events):
            return
        try:
            quantity = self.system.function(meant(self.states, watch.question.quantity))
            value = value_or_nan(quantity, time, state)
        except NotCoveredError:
            value = math.nan
        self.events.append(Event(EventKind.ASKED, watch.name, time, state, value if math.isfinite(value) else None))
        self.asked = [q for q in self.asked if q.name != watch.name]

    def _end(self, kind: EventKind, name: str, time: float, state: State) -> None:
        self.events.append(Event(kind, name, time, state))
        self.ended = time
        self.grid = self.grid[self.grid <= time * (1 + 1e-12)]

    # -- dry friction --------------------------------------------------------------------------------------------------

    def _consistent(self, time: float, state: State) -> NumericalSystem:
        """The system with the signs that the state has; those of reactions must agree with themselves."""
        system = self.system
        for _ in range(len(system.signs) + 1):
            signs = dict(system.signs)
            for e in signs:
                x = value_or_nan(system.function(e), time, state)
                signs[e] = signs[e] if not abs(x) > NARROW else (1 if x > 0 else -1)
            if signs == system.signs:
                return system
            system = system.with_signs(signs)
        return system

    def _flipped(self, watch: _Watch, time: float, state: State) -> tuple[float, State]:
        """Goes on with the other sign; where what it is the sign of then goes back, friction holds the system."""
        self.flips += 1
        if self.flips > MOST_FLIPS:
            raise IntegrationStoppedError(time, "friction changes its sense again and again")
        assert watch.indicator is not None
        signs = dict(self.system.signs)
        old = signs[watch.indicator]
        signs[watch.indicator] = -old
        other = self.system.with_signs(signs)
        leaving = with_static_coefficients(other) if watch.indicator in other.slips else other
        if growth(leaving, watch.indicator, time, state) * -old <= 0:
            self._end(EventKind.HELD, watch.name, time, state)
            return math.inf, state
        self.system = other
        return time, state

    def _speed_squared(self, slip: Sequence[sp.Expr], time: float, state: State) -> float:
        return value_or_nan(self.system.function(sp.Add(*(c**2 for c in slip))), time, state)

    def _reference(self, slip: Sequence[sp.Expr]) -> float:
        """The speed to which a slip in a plane is compared where it has ended: that of the start, if it slips there."""
        return max(math.sqrt(self._speed_squared(slip, 0.0, self.start.state)), SLOWEST_REFERENCE)

    def _slides_again(self, slip: Sequence[sp.Expr], time: float, state: State) -> State | None:
        """The state in which a slip in a plane begins again; None, with the event, if the simulation ends."""
        self.flips += 1
        if self.flips > MOST_FLIPS:
            raise IntegrationStoppedError(time, "friction changes its sense again and again")
        if len(self.states.plane_slips) > 1:
            self._end(EventKind.AT_REST, str(slip), time, state)
            return None
        speed = 2 * ENDED_SLIP * self._reference(slip)
        again = beginning_in_plane(self.system, slip, speed, time, state)
        if again is None:
            self._end(EventKind.HELD, str(slip), time, state)
        return again

    # -- results -------------------------------------------------------------------------------------------------------

    def _keep(self, step: IntegrationStep, end: float) -> None:
        """Keeps the interpolation of a step if some of the times lie in it."""
        place = self.pieces[-1][4] if self.pieces else 0
        last = bisect_right(self._times, end * (1 + ROUNDING))
        if last > place:
            self.pieces.append((step.time, step.length, step.before, step.interpolation(), last))

    def result(self) -> Simulation:
        """The simulation, with its drifts."""
        import numpy

        n = len(self.states.state)
        count = self.pieces[-1][4] if self.pieces else 0
        times = self.grid[:count]
        values = numpy.empty((n, count))
        if self.pieces:
            ends = numpy.array([p[4] for p in self.pieces])
            index = numpy.searchsorted(ends, numpy.arange(count), side="right")
            begin, length = (numpy.array([p[k] for p in self.pieces])[index] for k in (0, 1))
            x = (times - begin) / length
            before = numpy.array([p[2] for p in self.pieces]).T[:, index]
            coefficients = numpy.array([p[3] for p in self.pieces])
            values = interpolated(before, [coefficients[index, k, :].T for k in range(coefficients.shape[1])], x)
        if self.states.equations.kept and count:
            for k, (time, state) in enumerate(zip(times.tolist(), values.T.tolist(), strict=True)):
                values[:, k] = self._on_constraints(time, tuple(state))
        made = Simulation(self.states, self.start, times, values, self.system, tuple(self.events), count=self.count)
        return _judged(made)


def _crosses(watch: _Watch, before: float, after: float) -> bool:
    if watch.falling:
        return before >= 0 > after
    return (before > 0 >= after) or (before < 0 <= after)


def _judged(made: Simulation) -> Simulation:
    """The simulation with the drift of what is conserved, and the largest error in the constraints."""
    drift = {name: _largest_change(made, e) for name, e in made.equations.conserved.items()}
    errors = [_largest_change(made, e, from_zero=True) for e in made.equations.equations.kept]
    return replace(made, drift=drift, violation=max(errors, default=0.0))


def _largest_change(made: Simulation, expression: sp.Expr, *, from_zero: bool = False) -> float:
    """The largest change of an expression along a motion, relative to its size.

    The size is the largest sum of the absolute values of its terms or, for an expression that stays about zero, the
    change that the largest values of all coordinates and speeds would cause.
    """
    import numpy

    if not len(made.times):
        return 0.0
    terms = sp.Add.make_args(
        sp.expand_mul(expression) if count_operations(expression) < LONGEST_EXPANDED else expression
    )
    parts = numpy.array([made.system.along(e, made.times, made.states) for e in terms])
    values = parts.sum(axis=0)
    change = float(numpy.abs(values - (0.0 if from_zero else values[0])).max())
    if not math.isfinite(change):
        return math.inf
    scale = float(numpy.abs(parts).sum(axis=0).max())
    if change > LARGEST_DRIFT / 100 * scale:
        scale = max(scale, _reach(made, expression))
    return change / scale if scale > 0 else change


def _reach(made: Simulation, expression: sp.Expr) -> float:
    """Σ |∂e/∂y_k| · (the largest coordinate, the largest speed)."""
    import numpy

    e = made.equations.equations
    n = len(e.slots.coordinates)
    sizes = numpy.abs(made.states).max(axis=1)
    largest = [max(sizes[:n]), max(sizes[n:])]
    reach = 0.0
    for k, symbol in enumerate(e.state):
        if symbol in expression.free_symbols:
            slopes = numpy.abs(made.system.along(partial(expression, symbol), made.times, made.states))
            reach += float(numpy.median(slopes)) * float(largest[k >= n])
    return reach
