"""Numbers that are not given: values of parameters, and the state in which a motion begins.

A file's `value:` and `initial:` and the command line's `--set` always win. Otherwise lengths and positions are those of
the drawing, so that a motion begins as the figure looks on paper; a parameter with a unit gets a value by the unit
(9.81 m/s², 20 N/m). A coordinate that the potential energy contains is let go from rest, one that it does not contain
moves already, so that something happens; a body with an axis in space spins fast, as a top does. Contacts that are
stated to slip do slip.

Sample functions for those that the file leaves open, so that the system can be drawn, moved and simulated.

A surface f(x − u t, y, z) = c of no particular shape becomes a bowl, f = Z − (X² + Y²)/4, a curve y = f(x) a parabola;
a potential U(r) becomes that of a spring, a resistance D(v) one that is proportional to the speed. A force F_x(x, ...)
along a Cartesian axis is zero, except for the weight of a particle on a surface. A prescribed motion u(t) oscillates
about a mean. The page and the report of a simulation state these choices.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from enum import IntEnum
from itertools import product

import sympy as sp
from sympy.functions.elementary.trigonometric import TrigonometricFunction

from lagrange.core.expression_size import distinct_parts
from lagrange.core.symbols import Bounded, Sign, Unspecified, t
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.energies import potential_energy
from lagrange.mechanics.dynamics.motion import Motion
from lagrange.mechanics.results import InCoordinates, Solution
from lagrange.pictures.floats import NoValueError, value
from lagrange.pictures.poses import Pose, general_pose
from lagrange.pictures.systems import SystemPicture, system_in_file, system_posed_in_choice
from lagrange.problem.model import Parameter, Potential, Problem
from lagrange.programs.limits import MOST_TRIED, SLOWEST_SLIP

GRAVITY = 9.81
_BY_UNIT = {"m/s^2": GRAVITY, "N/m": 20.0, "N*s/m": 0.4, "1/s": 2.0, "rad/s": 2.0, "m/s": 1.0, "N": 5.0, "kg*m^2": 0.5}
_BY_LETTER = {"g": GRAVITY, "k": 20.0, "c": 0.4, "mu": 0.3, "omega": 2.0, "Omega": 2.0, "w": 2.0, "F": 5.0}
SPEED, SLOWER = 1.0, 0.2
"""The speed of the first coordinate that the potential energy does not contain, and how much slower each next one is:
particles with the same velocity would not turn about each other."""
SPIN, ROLLING_SPIN = 14.0, 5.0
"""The spin of a body in space about its own axis under gravity, in rad/s: without constraints, and with them."""


def angles_in(expressions: Iterable[sp.Expr]) -> frozenset[sp.Symbol]:
    """The symbols that are a term of the argument of a sine or cosine, up to a factor."""
    functions = (f for f in distinct_parts(expressions) if isinstance(f, TrigonometricFunction))
    terms = (a for f in functions for a in sp.Add.make_args(f.args[0]))
    return frozenset(s for a in terms if (s := a.as_coeff_Mul()[1]).is_Symbol)


def drawn_system(solution: Solution, view: InCoordinates) -> tuple[SystemPicture | None, Pose | None]:
    """The system as the figure shows it, and that position in the coordinates of a view."""
    if view.is_own:
        system = system_in_file(solution)
        return system, None if system is None else system.pose
    posed = system_posed_in_choice(solution, view.coordinates.configuration)
    return posed if posed is not None else (system_in_file(solution), None)


def drawn_position(solution: Solution, view: InCoordinates, configuration: Configuration) -> dict[sp.Symbol, float]:
    """The numbers of the position that the figure shows; none if there is no figure."""
    system, pose = drawn_system(solution, view)
    pose = pose or general_pose(solution.problem, configuration)
    values = {**(system.pose.values if system else {}), **(pose.values if pose else {})}
    return {s: float(x) for s, x in values.items()}


def parameter_value(
    symbol: sp.Symbol, declared: Parameter | None, problem: Problem, drawn: Mapping[sp.Symbol, float], angle: bool
) -> float:
    """The number of a parameter: the file's, otherwise a sensible one. `angle`: whether it turns something."""
    if declared is not None and declared.value is not None:
        return float(declared.value)
    if isinstance(symbol, Sign):
        return 1.0
    at = problem.figure.at.get(symbol.name)
    if at is not None:
        return float(at)
    unit = "" if declared is None else declared.unit or declared.stated_unit
    letter = symbol.name.split("_")[0].rstrip("0123456789")
    if letter == "c" and any(isinstance(f, Potential) and f.energy.has(symbol) for f in problem.forces):
        letter = "k"  # a stiffness
    by = _BY_UNIT.get(unit) or (None if unit in ("m", "kg", "rad", "1") else _BY_LETTER.get(letter))
    number = GRAVITY if symbol in _heavy(problem) else by if by is not None else drawn.get(symbol, 1.0)
    if unit in ("m", "kg") or declared is None:
        number = float(f"{number:.2g}")
    if angle and abs(number) > math.pi / 2:
        number = 0.5
    if isinstance(symbol, Bounded) and not symbol.low <= number <= symbol.high:
        number = float((symbol.low + symbol.high) / 2)
    return number


def _heavy(problem: Problem) -> set[sp.Symbol]:
    """The symbols that say how strong gravity is."""
    falls = problem.gravity.fixed().components if problem.gravity is not None else ()
    turned = {s for c in falls for f in c.atoms(sp.Function) for s in f.free_symbols}
    return {s for c in falls for s in c.free_symbols} - turned


def default_velocities(problem: Problem, configuration: Configuration) -> dict[sp.Symbol, float]:
    """A velocity for each coordinate, where nothing is known of the state at t = 0."""
    slots, potential = configuration.slots, sp.sympify(potential_energy(configuration), strict=True)
    turning = spins(configuration) if problem.gravity is not None else ()
    bound = bool(configuration.rows)
    others = 0.0 if turning and bound else SPEED
    spin = ROLLING_SPIN if bound else SPIN
    free = [q for q in slots.coordinates if not potential.has(q) and q not in turning]
    return {
        v: spin if q in turning else others * max(1 - SLOWER * free.index(q), SLOWER) if q in free else 0.0
        for q, v in zip(slots.coordinates, slots.velocities, strict=True)
    }


class KnownSense(IntEnum):
    """What the sense of a slip is known to be: as the sign of the velocity, as stated, or only that it slips."""

    UNKNOWN, STATED, ANY = range(3)


def slip_speeds(dynamics: Motion | None) -> Iterator[tuple[KnownSense, sp.Expr]]:
    """The slip speeds, positive in the stated direction; for slip in a plane, the square."""
    for f in dynamics.friction_forces if dynamics is not None else ():
        if f.speed is None:
            yield KnownSense.ANY, f.slip.dot(f.slip)
        elif f.sense.is_number:
            yield KnownSense.STATED, f.speed * f.sense
        else:
            yield KnownSense.UNKNOWN, f.speed


def slipping(
    state: Mapping[sp.Symbol, float],
    speeds: Sequence[sp.Symbol],
    slips: Sequence[sp.Expr],
    parameters: Mapping[sp.Symbol, float],
) -> dict[sp.Symbol, float]:
    """The state with other speeds, where what is to slip would not slip in it: the first that does of a few."""

    def slips_in(s: Mapping[sp.Symbol, float]) -> bool:
        try:
            return all(value(e, {**parameters, **s}) > SLOWEST_SLIP for e in slips)
        except NoValueError:
            return False

    if slips and not slips_in(state) and len(speeds) <= MOST_TRIED:
        for trial in product((0.6, 0.0, -0.6, 2.0, -2.0), repeat=len(speeds)):
            tried = {**state, **dict(zip(speeds, trial, strict=True))}
            if slips_in(tried):
                return tried
    return dict(state)


def spins(configuration: Configuration) -> Sequence[sp.Symbol]:
    """The coordinates that turn a body in space about its third axis: they do not move that axis."""
    turning = []
    for r in configuration.rotations:
        first, third = r.axes[0].fixed(), r.axes[2].fixed()
        moving = set().union(*(c.free_symbols for c in third.components))
        if moving & {*configuration.slots.coordinates}:
            own = set().union(*(c.free_symbols for c in first.components)) - moving
            turning += [q for q in configuration.slots.coordinates if q in own]
    return turning


# Samples


SampleFunctions = dict[str, sp.Expr]
"""By name of a function: what is taken for it, in the names of its arguments."""
UNDECLARED_GRAVITY = sp.Symbol("g", positive=True)
"""In samples of a problem that has no `g` of its own."""
AMPLITUDE, FREQUENCY = 0.3, 2.0
"""Amplitude and angular frequency of a prescribed motion, in SI units."""


def samples(solution: Solution) -> SampleFunctions:
    """The sample functions assumed for functions of the problem without a given value."""
    configuration = solution.own.configuration
    relations = [sp.sympify(f, strict=True) for f in configuration.finite_constraints]
    bound = {f.name for r in relations for f in r.atoms(Unspecified)}
    out: SampleFunctions = {}
    gravity = UNDECLARED_GRAVITY if "g" not in solution.problem.scope.names() else sp.Integer(10)
    for declared in solution.problem.functions:
        names = tuple(sp.Symbol(a, real=True) for a in declared.arguments)
        squares = sp.Add(*(a**2 for a in names))
        if declared.name in bound:
            implicit = any(_is_alone(r, declared.name, configuration) for r in relations) and len(names) > 1
            taken = names[-1] - (squares - names[-1] ** 2) / 4 if implicit else squares / 4
        elif sp.sympify(configuration.potential, strict=True).has(Unspecified) and len(names) == 1:
            taken = 2 * squares
        elif len(names) == 1 and not _component(configuration, declared.name):
            taken = names[0] / 5
        else:
            part = _component(configuration, declared.name)
            taken = -gravity * part if part is not None and bound else sp.S.Zero
        out[declared.name] = sp.sympify(taken, strict=True)
    return out


def _is_alone(relation: sp.Expr, name: str, configuration: Configuration) -> bool:
    """Whether a relation is f(...) = c, and not z = f(x, y)."""
    functions = [f for f in relation.atoms(Unspecified) if f.name == name]
    rest = relation.xreplace(dict.fromkeys(functions, sp.S.Zero))
    return bool(rest.free_symbols.isdisjoint(configuration.slots.coordinates))


def _component(configuration: Configuration, name: str) -> sp.Expr | None:
    """The mass of the particle on which the function is the last component of a force; None if it is none."""
    for load in configuration.loads:
        parts = load.vector.fixed().components
        last = next((c for c in reversed(parts) if c != 0), sp.S.Zero)
        if isinstance(last, Unspecified) and last.name == name:
            return next(p.mass for p in configuration.points if p.name == load.on)
    return None


def oscillation(u: sp.Symbol, drawn: Mapping[sp.Symbol, float]) -> sp.Expr:
    """The sample motion assumed for a prescribed motion u(t): an oscillation about its value in the figure."""
    mean, size, rate = (sp.Float(f"{x:.6g}") for x in (drawn.get(u, 0.5), AMPLITUDE, FREQUENCY))
    return sp.Add(mean, size * sp.sin(rate * t))
