"""Two particles joined by a massless rod, otherwise free: their motion in vectors.

With u = r_2 − r_1 the constraint is |u|² = l², and virtual displacements satisfy u·(δr_2 − δr_1) = 0. They are made of
δr_1 = δr_2, arbitrary, and of δr_1 = 0 with δr_2 normal to u, so that d'Alembert's principle says

    m_1 r_1'' + m_2 r_2'' = F_1 + F_2 ,      u × (m_2 r_2'' − F_2) = 0 ,

the momentum of both, and that m_2 r_2'' − F_2 is along the rod: five independent equations, in space. To solve for one
of the δx, δy, δz would divide by a component of u, and write these equations in a form that is wrong where it vanishes.
The constraint differentiated twice, u·u'' + u'² = 0, and Newton's laws, each divided by its mass, give

    T = (m_1 m_2/((m_1 + m_2) l)) (u'² + u·(F_2/m_2 − F_1/m_1)) .

Where both forces are the same multiple of the masses, as weights are, u × u'' = 0: the rod turns as if it were free.
The tension is compared with the one that was derived; where they do not agree the page is left as it is.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

import sympy as sp

from lagrange.core.records import record
from lagrange.core.symbols import CONSTANT, CrossProduct, DotProduct, VectorSymbol
from lagrange.core.vectors import Vector
from lagrange.document.derivation import (
    Block,
    Display,
    Emphasis,
    Equation,
    EquationKind,
    Part,
    Purpose,
    Ref,
    Rule,
    Step,
    display,
    has_purpose,
    math,
    prose,
)
from lagrange.mechanics.dynamics.equations import DalembertMotion
from lagrange.mechanics.dynamics.newton import Reaction
from lagrange.mechanics.results import Solution
from lagrange.mechanics.rewriting.vectors import is_tension_of_link

ZERO = sp.S.Zero


@record
class RodLink:
    """Two particles and the rod between them.

    masses, forces  of the two; the forces are those that are applied
    """

    solution: Solution
    reaction: Reaction
    names: tuple[str, str]
    masses: tuple[sp.Expr, sp.Expr]
    forces: tuple[Vector, Vector]
    length: sp.Expr

    @property
    def falls_as_one(self) -> bool:
        """Whether the forces are the same multiple of the masses."""
        (m, n), (f, g) = self.masses, self.forces
        return bool((f * n - g * m).is_zero)

    def symbol(self, n: int, rate: str = "") -> VectorSymbol:
        """r_1 or r_2, with its primes."""
        return VectorSymbol(f"r_{self.names[n]}{rate}")

    def between(self, rate: str = "") -> sp.Expr:
        """r_2 − r_1, or its rate."""
        return self.symbol(1, rate) - self.symbol(0, rate)

    def left_over(self, n: int) -> sp.Expr:
        """m r'' − F."""
        force = ZERO if self.forces[n].is_zero else VectorSymbol(f"F_{self.names[n]}")
        return self.masses[n] * self.symbol(n, "''") - force

    @property
    def motion(self) -> list[Equation]:
        """The equations of motion, without the constraint."""
        forces = [VectorSymbol(f"F_{n}") for n, f in zip(self.names, self.forces, strict=True) if not f.is_zero]
        moved = sp.Add(*(m * self.symbol(n, "''") for n, m in enumerate(self.masses)))
        across = self.between("''") if self.falls_as_one else self.left_over(1)
        return [
            Equation((moved, sp.Add(*forces)), label="link-together"),
            Equation((CrossProduct(self.between(), across), ZERO), label="link-across"),
        ]

    @property
    def tension(self) -> Equation:
        """T in vectors."""
        m, n = self.masses
        bracket: sp.Expr = sp.Abs(self.between("'")) ** 2
        if not self.falls_as_one:
            field = [
                ZERO if f.is_zero else VectorSymbol(f"F_{p}") / mass
                for p, f, mass in zip(self.names, self.forces, self.masses, strict=True)
            ]
            bracket += DotProduct(self.between(), field[1] - field[0])
        return Equation((self.reaction.force, m * n / ((m + n) * self.length) * bracket), label="link-tension")


def linked(solution: Solution) -> RodLink | None:
    """The particles and their rod; None of any other system."""
    own, law = solution.own, solution.law
    configuration = own.configuration
    if law is None or own.dynamics is None or solution.problem.choices or own.equilibrium is not None:
        return None
    if not isinstance(own.dynamics.written, DalembertMotion) or law.all_frictions or configuration.rotations:
        return None
    if len(configuration.points) != 2 or len(configuration.rows) != 1 or configuration.links:
        return None
    if configuration.potential != 0 or any(f.elsewhere for f in configuration.loads) or not own.dynamics.reactions:
        return None
    first, second = configuration.points
    places = (*first.position.fixed().components, *second.position.fixed().components)
    if tuple(c for c in places if c != 0) != tuple(configuration.slots.coordinates) or own.dynamics.reactions is None:
        return None
    [r] = law.newton.in_tensions.reactions
    if r.rod is None or r.tension is None or not r.named or set(r.rod.ends) != {first.name, second.name}:
        return None
    forces = [
        sum((f.vector for f in configuration.loads if f.on == p.name), Vector.zero()).fixed() for p in (first, second)
    ]
    made = RodLink(
        solution, r, (first.name, second.name), (first.mass, second.mass), (forces[0], forces[1]), r.rod.length
    )
    return made if _agrees(made) else None


def _agrees(link: RodLink) -> bool:
    """Whether the tension in vectors is the one that was derived."""
    configuration, dynamics = link.solution.own.configuration, link.solution.own.dynamics
    value = None if dynamics is None or dynamics.reactions is None else dynamics.reactions.sizes.get(link.reaction.name)
    if value is None:
        return False
    return is_tension_of_link(value, configuration, link.forces, link.length)


def work_of_link(link: RodLink) -> list[Equation]:
    """Σ R·δr = 0."""
    return [Equation((_work(link), ZERO))]


def _work(link: RodLink) -> sp.Expr:
    return sp.Add(*(DotProduct(VectorSymbol(f"R_{n}"), VectorSymbol(f"delta(r_{n})")) for n in link.names))


def in_vectors(link: RodLink, steps: Iterable[Step]) -> Iterator[Step]:
    """The steps of the page in vectors; components stand in the complete derivation only."""
    has_motion = False
    for step in steps:
        match step.rule:
            case Rule.PRINCIPLE:
                yield replace(step, body=tuple(map(_first_line, step.body)))
            case Rule.EQUATIONS_OF_MOTION:
                if not has_motion:
                    yield replace(step, body=tuple(_motion(link)))
                has_motion = True
            case Rule.SOLVED_REACTIONS:
                yield _reaction(link, step)
            case Rule.REACTIONS:
                yield replace(step, body=tuple(_without_components(link, step)))
            case _:
                yield step


def _first_line(block: Block) -> Block:
    return display(block.equations[0]) if isinstance(block, Display) else block


def _without_components(link: RodLink, step: Step) -> Iterator[Block]:
    """The laws and the forces, without the components."""
    kept = {f"{kind}-{n}" for kind in ("law", "reaction") for n in link.names}
    for block in step.body:
        if isinstance(block, Display):
            block = display(*(e for e in block.equations if e.label in kept))
        yield block


def _motion(link: RodLink) -> Iterator[Block]:
    """From the principle to the equations of motion."""
    first, second = (VectorSymbol(f"delta(r_{n})") for n in link.names)
    by = Ref(f"virtual-{link.reaction.name}")
    together, across = link.motion
    yield prose(
        by, " holds for ", math(first, second), ", arbitrary, and for ", math(first, ZERO), " with any ", math(second),
        " normal to ", math(link.between()), "; every virtual displacement is the sum of two such. With the former ",
        Ref("principle"), " gives",
    )  # fmt: skip
    yield display(together)
    if link.falls_as_one:
        yield prose(
            "and with the latter, that ", math(link.left_over(1)), " is along the rod. By ", Ref("link-together"),
            " so is ", math(link.left_over(0)), ". Each divided by its mass, and subtracted, these give",
        )  # fmt: skip
    else:
        yield prose("and with the latter, that ", math(link.left_over(1)), " is along the rod:")
    yield display(across)
    constraint = link.solution.problem.constraints[0]
    in_space = len(link.solution.own.configuration.slots.coordinates) == 6
    several: tuple[Part, ...] = ("Of the components of ", Ref("link-across"), " two are independent. ")
    yield prose(*(several if in_space else ()), "With the constraint, these are the equations of motion:")
    lines = (replace(e, label=None) for e in (together, across))
    yield display(
        *lines,
        Equation((constraint.lhs, constraint.rhs), label="motion-link", kind=EquationKind.COMPLETING),
        boxed=True,
    )


def _reaction(link: RodLink, step: Step) -> Step:
    """T from Newton's laws and the constraint differentiated twice."""
    u, v, a = (link.between(rate) for rate in ("", "'", "''"))
    twice = Equation((DotProduct(u, a) + sp.Abs(v) ** 2, ZERO), label="link-twice")
    laws = [Ref(f"law-{n}") for n in link.names]
    body: list[Block] = [
        prose("Differentiated twice, ", Ref(f"constraint-{link.reaction.name}"), " is"),
        display(twice),
        prose("Substituting ", laws[1], " and ", laws[0], ", each divided by its mass, gives"),
        display(link.tension, boxed=True),
    ]
    bounds: list[Block] = [b for b in step.body if has_purpose(b, Purpose.MAY_PUSH)]
    if link.falls_as_one and bounds:
        bounds = [prose(math(link.reaction.force), " is never negative: a string would do as well as the rod.")]
    return replace(step, body=(*body, *bounds))


def meaning_of_link(link: RodLink, step: Step) -> Step:
    """What it says: the mass centre, the rod about it, the energy."""
    if not link.falls_as_one:
        return step
    kept = [b for b in step.body if not has_purpose(b, Purpose.MOMENTUM)]
    parts: tuple[Part, ...] = (
        Emphasis("Mass centre"), ": by ", Ref("link-together"), " it moves as a single particle under both forces, "
        "whatever the rod does.",
    )  # fmt: skip
    turns: tuple[Part, ...] = (
        Emphasis("Rod"), ": ", Ref("link-across"), " integrates to ",
        math(CrossProduct(link.between(), link.between("'")), CONSTANT),
        ". The rod turns in a plane that keeps its direction, and since its length is constant, uniformly: ",
        math(link.reaction.force), " is constant.",
    )  # fmt: skip
    return replace(step, body=(prose(*parts), prose(*turns), *kept))
