"""The consequences of the equations of motion in words: constant vectors, the motion in the limit, resonances."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from lagrange.core.symbols import (
    CONSTANT,
    CrossProduct,
    DotProduct,
    TimeDerivative,
    VectorSymbol,
    free_letter,
    prime,
    t,
)
from lagrange.document.derivation import Block, Emphasis, Part, Rule, Step, listed, math, prose
from lagrange.mechanics.consequences.gathered import Consequences, LimitMotion
from lagrange.mechanics.consequences.oscillations import Beats, DoubleResonance, SleepingAxis
from lagrange.mechanics.consequences.time_dependent import FastDrive, SlowChange, UniformStiffness
from lagrange.mechanics.consequences.vectors import ConeVector, ConstantSpin, Hodograph
from lagrange.mechanics.results import InCoordinates


def explain_consequences(c: Consequences, view: InCoordinates) -> Iterator[Block]:
    """A paragraph for each."""
    yield from (_spin(s, alone=len(view.configuration.rotations) == 1) for s in c.spins)
    if c.cone is not None:
        yield from _cone(c.cone, view)
    yield from _directions(c.directions, view)
    if c.hodograph is not None:
        yield _hodograph(c.hodograph)
    yield from (_limit(x) for x in c.limits)
    if c.beats is not None:
        yield _beats(c.beats, view)
    if c.resonance is not None:
        yield _resonance(c.resonance)
    if c.sleeping is not None:
        yield _sleeping(c.sleeping)
    if c.drive is not None:
        yield _drive(c.drive)
    if c.slow is not None:
        yield _slow(c.slow)
    if c.uniform is not None:
        yield _uniform(c.uniform, view)


def _spin(s: ConstantSpin, *, alone: bool) -> Block:
    momentum = VectorSymbol("H" if alone else f"H_{s.body}")
    square = () if s.square is None else (", and its square is constant, ", math(s.square, CONSTANT))
    return prose(
        *(Emphasis("Angular momentum in space"), ": no moment about the mass centre acts on the body, so "),
        *(math(momentum), " keeps its direction and its size in space", *square, "."),
    )


def _cone(c: ConeVector, view: InCoordinates) -> Iterator[Block]:
    r, v, J = VectorSymbol("r"), VectorSymbol("v"), VectorSymbol("J")
    e = VectorSymbol("e") if c.direction is None else c.direction
    where: tuple[Part, ...] = (", ", math(e), " being the unit vector along ", math(r)) if c.direction is None else ()
    if c.factor == 0:
        vector = math(J, c.mass * CrossProduct(r, v))
        yield prose(
            *(
                Emphasis("Plane"),
                ": the force has no moment about the origin, so ",
                vector,
                " is a constant vector, and ",
            ),
            "the path lies in the plane through the origin perpendicular to it.",
        )
    else:
        moment = math(CrossProduct(r, VectorSymbol("F")), c.factor * TimeDerivative(e))
        vector = math(J, c.mass * CrossProduct(r, v) - c.factor * e)
        yield prose(
            *(Emphasis("Cone"), ": the force has the moment ", moment, " about the origin", *where, ", so "),
            *(
                vector,
                " is a constant vector. Since ",
                math(CrossProduct(r, v)),
                " is perpendicular to ",
                math(e),
                ", ",
            ),
            *(
                math(DotProduct(J, e), -c.factor),
                ": the radius makes a constant angle with ",
                math(J),
                ", and the path ",
            ),
            *("lies on a cone about ", math(J), " with its vertex at the origin."),
        )
    if c.spread:
        distance = next((q for q in view.configuration.slots.coordinates if q.name == "r"), None)
        square = DotProduct(r, r) if distance is None else distance**2
        speed = sp.Symbol("v", positive=True)
        yield prose(
            *(Emphasis("Distance"), ": the force is perpendicular to ", math(r), " and ", math(v), ", so the speed "),
            *(
                math(speed),
                " is constant, and the second time derivative of ",
                math(square),
                " is ",
                math(2 * speed**2),
            ),
            ". Therefore ",
            *(math(square - speed**2 * t**2, CONSTANT), ", with ", math(t), " from the time of closest approach."),
        )


def _directions(pairs: tuple[tuple[sp.Symbol, sp.Symbol], ...], view: InCoordinates) -> Iterator[Block]:
    for x in dict.fromkeys(first for first, _ in pairs):
        others = [y for first, y in pairs if first == x]
        if any(x == y for _, y in pairs):
            return  # it stands in the ratios to the first already
        ratios = listed(math(prime(y) / prime(x), CONSTANT) for y in others)
        rates = listed(math(prime(x) * prime(y, 2) - prime(y) * prime(x, 2), sp.S.Zero) for y in others)
        whole = len(view.configuration.slots.coordinates) == len(others) + 1
        says = "the path is a straight line" if whole else "the velocity keeps its direction in this plane"
        yield prose(Emphasis("Direction"), ": ", *ratios, ", because ", *rates, " along the motion: ", says, ".")


def _hodograph(h: Hodograph) -> Block:
    speeds = (math(prime(h.first), h.speed * sp.cos(h.angle)), math(prime(h.second), h.speed * sp.sin(h.angle)))
    return prose(
        *(
            Emphasis("Hodograph"),
            ": with the speed ",
            math(h.speed),
            " and the direction of the velocity ",
            math(h.angle),
        ),
        *(", that is ", *listed(speeds), ", the direction changes by ", math(h.speed * prime(h.angle), h.turning)),
        *(". Dividing the rate of ", math(h.ahead, prime(h.first)), " by that of ", math(h.angle), ", we have "),
        *(math(*h.sides), ", in which neither time nor position occurs."),
    )


def _limit(x: LimitMotion) -> Block:
    unless: tuple[Part, ...] = () if x.unless is None else (", if ", math(x.unless, sp.S.Zero, relation="≠"))
    spin: tuple[Part, ...] = ()
    if x.spin is not None:
        spin = (", and in the end the body turns uniformly, with ", math(VectorSymbol("omega"), x.spin))
    return prose(
        *(Emphasis("In the end"), ": ", math(x.vanishing, sp.S.Zero, relation="→"), *unless, ". The energy bounds "),
        *(math(x.lasting), ", which moves in one sense, so that its rate tends to zero. Of the energy only "),
        *(math(x.remaining), " remains: ", math(x.lasting), " tends to a constant", *spin, "."),
    )


def _beats(b: Beats, view: InCoordinates) -> Block:
    assert view.linearization is not None
    omega = view.linearization.omega.name
    low, high = (sp.Symbol(f"{omega}_{n + 1}", real=True) for n in b.frequencies)
    return prose(
        *(
            Emphasis("Beats"),
            ": for a weak coupling, ",
            math(b.coupling, sp.S.Zero, relation="→"),
            ", the frequencies ",
        ),
        *("are close: ", math(high - low, b.difference, relation="≈"), ". If ", math(b.displacements[0]), " alone is "),
        *(
            "not zero at first, and without velocities, after the time ",
            math(sp.pi / (high - low)),
            " nearly all of it has ",
        ),
        *("passed to ", math(b.displacements[1]), ", and after twice that time it is back."),
    )


def _resonance(r: DoubleResonance) -> Block:
    places = listed(math(q, e) for q, e in r.rest.items())
    names = (math(r.driven), " and ", math(r.driving))
    squares: tuple[Part, ...] = (*listed(math(e) for e in r.squares),)
    if any(e.has(r.driven) for e in r.squares):
        squares = (*squares, ", with this ", math(r.driven))
    return prose(
        *(
            Emphasis("Resonance 2 : 1"),
            ": about the rest at ",
            *places,
            " small changes of ",
            *names,
            " are independent, ",
        ),
        *("with the squares of the frequencies ", *squares, ". Terms of second order in ", math(r.driving), " drive "),
        *(math(r.driven), " at twice the frequency of ", math(r.driving), ". If "),
        *(math(*r.condition), ", that is its own frequency, and the two motions exchange their energy."),
    )


def _sleeping(x: SleepingAxis) -> Block:
    spin = math(x.spin, DotProduct(VectorSymbol("omega"), x.axis))
    return prose(
        *(
            Emphasis("Upright"),
            ": the spin ",
            spin,
            " is constant. With it the axis can stay at ",
            math(x.angle, sp.S.Zero),
        ),
        *(
            ", where these coordinates have a pole. To first order in the horizontal components of ",
            math(x.axis),
            " it is ",
        ),
        *("stable there if ", math(x.more, x.less, relation=">"), ", and it falls if "),
        *(math(x.more, x.less, relation="<"), "."),
    )


def _drive(d: FastDrive) -> Block:
    """`Fast drive: for Ω → ∞, with a Ω kept constant, ... The rest at θ = 0 is stable on average if a² Ω² > 2 g l.`"""
    q, product = d.coordinate, d.amplitude * d.frequency
    verdicts: list[Part] = []
    for place in d.changed:
        becomes = ("unstable", "stable") if not place.without_drive else ("stable", "unstable")
        verdicts += [
            *(
                " The rest at ",
                math(q, place.place),
                f", {becomes[0]} without the drive, is {becomes[1]} on average if ",
            ),
            *(math(place.more, place.less, relation=">"), "."),
        ]
    return prose(
        *(Emphasis("Fast drive"), ": for ", math(d.frequency, sp.oo, relation="→"), ", with ", math(product)),
        " kept constant, the motion averaged over one period of the drive satisfies, to leading order, ",
        *(math(prime(q, 2), d.mean), ".", *verdicts),
    )


def _uniform(u: UniformStiffness, view: InCoordinates) -> Block:
    """`Motion: r = C₁ cosh Ωt + C₂ sinh Ωt, with two constants.`"""
    taken = set() if view.motion is None else {s.name for e in view.motion.final for s in e.expression.free_symbols}
    letter = free_letter("C", "D", "K", taken={*taken, *(f"{n}_1" for n in taken)})
    one, two = (sp.Symbol(f"{letter}_{n}", real=True) for n in (1, 2))
    motion = math(u.coordinate, u.rest + one * u.first + two * u.second)
    constants = (math(one), " and ", math(two))
    return prose(Emphasis("Motion"), ": ", motion, ", where ", *constants, " follow from the initial state.")


def _slow(s: SlowChange) -> Block:
    amplitude = math(sp.Pow(s.length, s.exponent))
    return prose(
        *(Emphasis("Slow change"), ": if ", math(s.length), " changes little in one period, small oscillations about "),
        *(math(s.coordinate, s.place), " have, to leading order, an amplitude proportional to ", amplitude, "."),
    )


def explain_at_rest(view: InCoordinates) -> Step | None:
    """The meaning of a force that holds a system at rest in every position."""
    from lagrange.mechanics.consequences.at_rest import shape, without_dependent

    body: list[Block] = []
    alone, curve = without_dependent(view), shape(view)
    if alone is not None:
        z, force = math(alone.dependent), math(alone.force, alone.value)
        by = (" for ", math(alone.dependent, sp.S.Zero, relation=">"), ": ", force, ".")
        body.append(prose(Emphasis("Without "), z, ", by the constraint,", *by))
        if alone.coordinate is not None:
            small = math(alone.force, alone.stiffness * alone.coordinate, relation="≈")
            body.append(prose(Emphasis("Small "), math(alone.coordinate), ": ", small, "."))
    if curve is not None:
        whole: tuple[Part, ...] = ()
        if curve.whole is not None:
            whole = (", that is ", math(curve.function, curve.whole + CONSTANT))
        law = (math(curve.derivative, curve.slope), *whole, ".")
        says = ": it is zero in every position if, by the constraint, "
        body.append(prose(Emphasis("Without "), math(curve.force), says, *law))
    return Step(Rule.MEANING, "What it says", tuple(body), view.name) if body else None
