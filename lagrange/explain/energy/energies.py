"""T, V and the generalized forces of Lagrange's method, in every set of coordinates.

Hamilton's function and the canonical equations, and Routh's function of the coordinates that are not cyclic.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import sympy as sp

from lagrange.core.records import record
from lagrange.core.symbols import DotProduct, Partial, TimeDerivative, VectorSymbol, prime, t, variation
from lagrange.core.vectors import Vector
from lagrange.document.derivation import (
    Block,
    Equation,
    EquationKind,
    Part,
    Rule,
    Step,
    display,
    listed,
    math,
    paragraph,
    prose,
)
from lagrange.explain.displacements import points_called
from lagrange.explain.newton import explain_friction, natures
from lagrange.explain.words import are, capital, joined, load_called, plural, qualified, suffix_of, the, title_in
from lagrange.mechanics.constraints.constrained_system import Row
from lagrange.mechanics.dynamics.energies import Energies, is_weight
from lagrange.mechanics.dynamics.equations import LagrangeMotion
from lagrange.mechanics.dynamics.friction import FrictionForce
from lagrange.mechanics.dynamics.motion import NewtonLaw
from lagrange.mechanics.dynamics.newton import Reaction
from lagrange.mechanics.energy_symbols import EnergySymbols
from lagrange.mechanics.momenta.hamiltonian import Hamiltonian
from lagrange.problem.model import Friction, GeneralizedForce, Problem

ZERO = sp.S.Zero


@record
class LagrangeExposition:
    """What the explanation of Lagrange's method needs in one set of coordinates.

    friction_forces  the friction forces
    finite  names of constraints on velocities that are equivalent to finite relations
    """

    motion: LagrangeMotion
    letters: EnergySymbols
    law: NewtonLaw
    problem: Problem
    friction_forces: Sequence[FrictionForce] = ()
    finite: frozenset[str] = frozenset()

    @property
    def energies(self) -> Energies:
        """T, V and the terms of Lagrange's equations."""
        return self.motion.principle

    @property
    def choice(self) -> str:
        """The name of the choice of coordinates; empty for the file's own."""
        return self.energies.configuration.name

    @property
    def suffix(self) -> str:
        """The end of labels."""
        return suffix_of(self.choice)

    @property
    def coordinates(self) -> tuple[sp.Symbol, ...]:
        """q."""
        return self.energies.configuration.slots.coordinates

    @property
    def velocities(self) -> tuple[sp.Symbol, ...]:
        """q'."""
        return self.energies.configuration.slots.velocities

    @property
    def rows(self) -> list[Row]:
        """The constraints that have multipliers."""
        return [self.energies.configuration.rows[n] for n in self.motion.used]

    @property
    def function(self) -> sp.Symbol:
        """The function to differentiate: L where there is a potential energy, T otherwise."""
        return self.letters.lagrangian if self.energies.has_lagrangian else self.letters.kinetic

    def reaction(self, row: Row) -> Reaction:
        """The reaction that maintains a constraint."""
        return next(r for r in self.law.newton.reactions if r.name == row.name)

    def title(self, words: str) -> str:
        """The title of a step."""
        return title_in(words, self.choice)


def explain_energies(setup: LagrangeExposition) -> Step:
    """v² and ω, T, V, and the generalized forces of forces that have no potential energy."""
    if setup.energies.configuration.is_outright:
        return _outright(setup)
    body = [
        *_velocities(setup),
        *_kinetic(setup),
        *_potential(setup),
        *_moving(setup),
        *_forces(setup),
        *_masses(setup),
    ]
    title = "Kinetic and potential energy" if setup.energies.potential != 0 else "Kinetic energy"
    title += ", generalized forces" * any(q != 0 for q in setup.energies.applied)
    return Step(Rule.ENERGIES, setup.title(title), tuple(body))


def _outright(setup: LagrangeExposition) -> Step:
    """A Lagrangian given directly in the file, with the accompanying generalized forces."""
    L = Equation((setup.letters.lagrangian, setup.energies.lagrangian), label=f"lagrangian{setup.suffix}")
    given = prose("The Lagrangian is given. The derivation begins with it: there are no masses and forces to which "
                  "d'Alembert's principle could be applied, and none that could check it." if not setup.choice else
                  "In these coordinates the Lagrangian is")  # fmt: skip
    return Step(Rule.ENERGIES, setup.title("The Lagrangian"), (given, display(L), *_forces(setup)))


def _moving(setup: LagrangeExposition) -> list[Block]:
    """L with potentials that depend on velocities."""
    energies, letters = setup.energies, setup.letters
    if energies.moving == 0:
        return []
    L = Equation((letters.lagrangian, energies.lagrangian), label=f"lagrangian{setup.suffix}")
    words = "A potential that depends on velocities belongs to the Lagrangian, with a minus sign, as it is:"
    return [prose(words), display(L)]


def _velocities(setup: LagrangeExposition) -> list[Block]:
    """The velocities that are more than x' i + y' j, and all their squares; in a choice ω too."""
    blocks: list[Block] = []
    velocities, squares = setup.energies.velocities, setup.energies.squares
    whose = points_called(setup.energies.configuration)
    lines = [
        Equation((VectorSymbol(f"r_{name}'"), v), label=f"velocity{setup.suffix}-{name}")
        for name, v in velocities.items()
        if not _is_evident(v)
    ]
    if lines:
        names = (the(n) for n, v in velocities.items() if not _is_evident(v))
        of = joined(names) if len(lines) < len(velocities) else f"the {whose}"
        blocks += [
            prose(plural(len(lines), f"The velocity of {of} is", f"The velocities of {of} are")),
            display(*lines),
        ]
    if squares:
        of = "" if lines else f" of the {whose}"
        one, more = f"The square of the velocity{of} is", f"The squares of the velocities{of} are"
        lines = [
            Equation((setup.letters.speed(name) ** 2, square), label=f"square{setup.suffix}-{name}")
            for name, square in squares.items()
        ]
        blocks += [prose(plural(len(lines), one, more)), display(*lines)]
    turning = [r for r in setup.energies.configuration.rotations if r.has_inertia]
    if setup.choice and turning:
        spins = (
            Equation(
                (VectorSymbol(f"omega_{r.name}"), r.angular_velocity),
                label=f"spin{setup.suffix}-{r.name}",
                kind=EquationKind.SPIN,
            )
            for r in turning
        )
        word = plural(len(turning), "The angular velocity is", "The angular velocities are")
        blocks += [prose(word), display(*spins)]
    return blocks


def _is_evident(velocity: Vector) -> bool:
    """Whether it is x' i + y' j."""
    return all(c == 0 or c.is_Symbol for c in velocity.components)


def _kinetic(setup: LagrangeExposition) -> list[Block]:
    """T as the sum of its parts."""
    energies, letters = setup.energies, setup.letters
    terms = [
        p.mass * letters.speed(p.name) ** 2 / 2 for p in energies.configuration.points if p.name in energies.squares
    ]
    turning = [r for r in energies.configuration.rotations if r.has_inertia]
    spins = [DotProduct(VectorSymbol(f"omega_{r.name}"), VectorSymbol(f"H_{r.name}")) / 2 for r in turning]
    parts = plural(len(turning), "of the mass centre and of the rotation about it",
                   "of the mass centres and of the rotations about them")  # fmt: skip
    what = f"The kinetic energy, {parts}, is" if terms and spins else "The kinetic energy is"
    if not terms and not spins:
        return [prose("Nothing has mass, so the kinetic energy is 0.")]
    line = Equation((letters.kinetic, sp.Add(*terms, *spins), energies.kinetic), label=f"kinetic{setup.suffix}")
    return [prose(what), display(line)]


def _potential(setup: LagrangeExposition) -> list[Block]:
    """V, and what has it."""
    if setup.energies.potential == 0:
        return []
    configuration = setup.energies.configuration
    weights = sum(is_weight(f, configuration) for f in configuration.loads)
    springs = configuration.springs
    whats = [plural(weights, "the weight", "the weights")] * bool(weights)
    whats += [plural(len(springs), "the spring", "the springs")] * bool(springs)
    whats += ["the given field"] * configuration.has_field
    return [
        prose(f"The potential energy of {joined(whats)} is"),
        display(Equation((setup.letters.potential, setup.energies.potential), label=f"potential{setup.suffix}")),
    ]


def _forces(setup: LagrangeExposition) -> list[Block]:
    """δW of the forces that are not in V, and the Q_k that follow."""
    energies, letters, configuration = setup.energies, setup.letters, setup.energies.configuration
    acting = _acting(setup)
    other = "other " if energies.potential != 0 else ""
    if not acting:
        return [] if setup.choice else [prose(f"No {other}force is applied: the generalized forces are 0.")]
    if all(q == 0 for q in energies.applied):
        verb = plural(len(acting), "does", "do")
        return [prose(f"{capital(joined(acting))} {verb} no virtual work: the generalized forces are 0.")]
    work = sp.Add(*(q * variation(x) for q, x in zip(energies.applied, setup.coordinates, strict=True)))
    lines = [
        Equation((letters.force(x), q), label=f"generalized{setup.suffix}-{x.name}")
        for q, x in zip(energies.applied, setup.coordinates, strict=True)
        if q != 0
    ]
    idle = [letters.force(x) for q, x in zip(energies.applied, setup.coordinates, strict=True) if q == 0]
    function = letters.lagrangian if configuration.is_outright else letters.potential
    included: tuple[Part, ...] = (", not included in ", math(function), ",") if other else ()
    words = (capital(joined(acting)), *included, plural(len(acting), " does", " do"), " the virtual work")
    rest: list[Block] = [prose(*listed(math(s) for s in idle), plural(len(idle), " is 0.", " are 0."))] if idle else []
    so = plural(len(lines), "so the generalized force is", "so the generalized forces are")
    return [
        prose(*words),
        display(Equation((work,), label=f"work{setup.suffix}")),
        prose(so),
        display(*lines),
        *rest,
    ]


def _masses(setup: LagrangeExposition) -> list[Block]:
    """What masses that vary add on the right."""
    energies, letters, configuration = setup.energies, setup.letters, setup.energies.configuration
    if not configuration.variable_masses:
        return []
    lines = [
        Equation((letters.of_masses(x), s), label=f"of-masses{setup.suffix}-{x.name}")
        for s, x in zip(energies.of_masses, setup.coordinates, strict=True)
        if s != 0
    ]
    kinetic = math(letters.kinetic)
    if not lines:
        return [prose("That masses vary adds nothing else: they vary at places that do not move.")]
    one = len(configuration.variable_masses) == 1
    whose = f"The mass of {the(configuration.variable_masses[0].name)} varies" if one else "Masses vary"
    return [
        prose(f"{whose}. The derivatives of ", kinetic, " differentiate ", "it" if one else "them", " too, and give "
              "more than the mass times the acceleration. So that the law of motion results, a further term belongs on "
              "the right: for each such mass, its rate of change times the generalized momentum per unit mass, minus "
              "its partial derivative with respect to the coordinate times half the square of the velocity,"),
        display(*lines),
    ]  # fmt: skip


def explain_friction_first(setup: LagrangeExposition) -> Step:
    """The reaction on which the friction depends, before T and V."""
    said = natures(setup.reaction(r) for r in setup.rows)
    depends = plural(len(setup.friction_forces), "The friction depends on this reaction, which follows",
                     "The friction forces depend on these reactions, which follow")  # fmt: skip
    body = [*([paragraph(*said)] if said else []), *explain_friction(setup.friction_forces)]
    body.append(prose(f"{depends} from Lagrange's equations with multipliers, given below."))
    return Step(
        Rule.REACTIONS, plural(len(setup.rows), "The reaction and friction", "Reactions and friction"), tuple(body)
    )


def _acting(setup: LagrangeExposition) -> list[str]:
    """The applied forces that are not in V, in words."""
    configuration = setup.energies.configuration
    rubbing = {f.name for f in setup.problem.forces if isinstance(f, Friction)}
    names = []
    for load in configuration.loads:
        if not is_weight(load, configuration):
            kind = "friction" if load.name in rubbing else "force"
            names.append(load_called(load.name, kind))
    names += [f"the {qualified('moment', m.name)}" for m in configuration.torques]
    names += [f"the {qualified('force', f.name)}" for f in setup.problem.forces if isinstance(f, GeneralizedForce)]
    names += [f"the {qualified('damper', d.name)}" for d in configuration.dampers]
    return list(dict.fromkeys(names))


# Hamilton


def explain_hamiltonian(hamiltonian: Hamiltonian, letters: EnergySymbols) -> Step:
    """The momenta, the velocities in terms of them, H, the canonical equations, what is conserved, R."""
    body = [
        *_integrated(hamiltonian),
        *_momenta(hamiltonian, letters),
        *_function(hamiltonian, letters),
        *_equations(hamiltonian, letters),
        *_constant(hamiltonian, letters),
    ]
    return Step(Rule.HAMILTON, title_in("Hamilton's equations", hamiltonian.configuration.name), tuple(body))


def _label(hamiltonian: Hamiltonian, kind: str) -> str:
    return f"{kind}{suffix_of(hamiltonian.configuration.name)}"


def _integrated(hamiltonian: Hamiltonian) -> Iterable[Block]:
    """`θ = −s/R + const: θ appears nowhere else, and the others are free.`"""
    if hamiltonian.integrated:
        relations = [math(q, e + sp.Symbol("const")) for q, e in hamiltonian.integrated.items()]
        names = [math(q) for q in hamiltonian.integrated]
        nowhere = plural(len(names), " does not appear in the energies: the remaining coordinates are free.",
                         " do not appear in the energies: the remaining coordinates are free.")  # fmt: skip
        yield paragraph(prose(plural(len(relations), "The constraint on velocities integrates to ",
                                     "The constraints on velocities integrate to "), *listed(relations), "."),
                        prose(*listed(names), nowhere))  # fmt: skip


def _momenta(hamiltonian: Hamiltonian, letters: EnergySymbols) -> list[Block]:
    """p_k = ∂L/∂q_k', and q_k' in terms of them."""
    velocities = hamiltonian.configuration.slots.velocities
    function = letters.lagrangian if hamiltonian.energies.has_lagrangian else letters.kinetic
    energies = [(letters.kinetic, hamiltonian.energies.kinetic), (letters.potential, hamiltonian.energies.potential)]
    if hamiltonian.energies.moving != 0:
        energies = [(letters.lagrangian, hamiltonian.energies.lagrangian)]
    stated = [Equation(pair, label=_label(hamiltonian, f"energy-{pair[0].name}")) for pair in energies if pair[1] != 0]
    momenta = [
        Equation(
            (p, Partial(function, v), e), label=_label(hamiltonian, f"momentum-{p.name}"), kind=EquationKind.MOMENTUM
        )
        for p, v, e in zip(hamiltonian.momenta, velocities, hamiltonian.energies.momenta, strict=True)
    ]
    solved = [
        Equation((v, e), label=_label(hamiltonian, f"velocity-{v.name}"))
        for v, e in zip(velocities, hamiltonian.velocities, strict=True)
    ]
    lagrangian = math(letters.lagrangian, letters.kinetic - letters.potential)
    lagrangian = math(letters.lagrangian) if hamiltonian.energies.moving != 0 else lagrangian
    of: tuple[Part, ...] = (", and with ", lagrangian) if function is letters.lagrangian else ()
    energy = (
        "The Lagrangian is"
        if hamiltonian.energies.moving != 0
        else plural(len(stated), "The kinetic energy is", "The kinetic and the potential energy are")
    )
    momentum = plural(len(momenta), " the generalized momentum is", " the generalized momenta are")
    gives = "Solved for the velocity, it gives" if len(solved) == 1 else "Solved for the velocities, they give"
    return [
        prose(energy),
        display(*stated),
        prose("With ", lagrangian, momentum) if of else prose(momentum.strip().capitalize()),
        display(*momenta),
        prose(gives),
        display(*solved),
    ]


def _function(hamiltonian: Hamiltonian, letters: EnergySymbols) -> list[Block]:
    """H, and whether it is the energy."""
    H = letters.hamiltonian
    function = letters.lagrangian if hamiltonian.energies.has_lagrangian else letters.kinetic
    definition = math(H, _transformed(function, hamiltonian, range(len(hamiltonian.momenta))))
    body: list[Block] = [
        prose("Hamilton's function ", definition, ", in terms of coordinates and momenta, is"),
        display(Equation((H, hamiltonian.function), label=_label(hamiltonian, "hamiltonian")), boxed=True),
    ]
    energy = letters.kinetic + letters.potential if hamiltonian.energies.potential != 0 else letters.kinetic
    if hamiltonian.configuration.is_outright:
        return body
    if hamiltonian.is_energy and hamiltonian.energies.moving_energy != 0:
        body.append(prose("It is the energy ", math(energy), ", with what the potential that depends on velocities "
                          "adds to it."))  # fmt: skip
    elif hamiltonian.is_energy:
        body.append(prose("It is the energy ", math(energy), "."))
    elif hamiltonian.is_energy is False:
        body.append(prose("It is not the energy ", math(energy), ": the positions contain time, so the kinetic "
                          "energy is not a quadratic form in the velocities."))  # fmt: skip
    return body


def _equations(hamiltonian: Hamiltonian, letters: EnergySymbols) -> list[Block]:
    """q' = ∂H/∂p, p' = −∂H/∂q + Q."""
    H = math(letters.hamiltonian)
    lines = []
    for q, p, velocity, rate in zip(
        hamiltonian.coordinates, hamiltonian.momenta, hamiltonian.velocities, hamiltonian.rates, strict=True
    ):
        lines.append(Equation((prime(q), velocity), label=_label(hamiltonian, f"canonical-{q.name}")))
        lines.append(Equation((prime(p), rate), label=_label(hamiltonian, f"canonical-{p.name}")))
    forces = "" if hamiltonian.is_conservative else ", plus the generalized force that has no potential"
    return [
        prose("Each velocity is the derivative of ", H, " with respect to its momentum; each momentum changes at the "
              "rate of minus the derivative with respect to its coordinate", forces,
              ". Hamilton's canonical equations are therefore"),
        display(*lines, boxed=True),
    ]  # fmt: skip


def _constant(hamiltonian: Hamiltonian, letters: EnergySymbols) -> list[Block]:
    """Whether H is constant; the cyclic coordinates; Routh's function."""
    H = letters.hamiltonian
    body: list[Block] = []
    if not hamiltonian.depends_on_time and hamiltonian.is_conservative:
        body.append(prose("Time does not appear explicitly in ", math(H), ", so ",
                          math(TimeDerivative(H), Partial(H, t), ZERO), ": it is constant."))  # fmt: skip
    if not hamiltonian.cyclic:
        return body
    cyclic = [math(hamiltonian.coordinates[c]) for c in hamiltonian.cyclic]
    constant = [math(hamiltonian.momenta[c]) for c in hamiltonian.cyclic]
    verb = plural(len(cyclic), " does not appear in ", " do not appear in ")
    body.append(prose(*listed(cyclic), verb, math(H), ", so ", *listed(constant), are(constant), "constant."))
    if hamiltonian.routhian is not None:
        R = letters.routhian
        function = letters.lagrangian if hamiltonian.energies.has_lagrangian else letters.kinetic
        others = [math(q) for k, q in enumerate(hamiltonian.coordinates) if k not in hamiltonian.cyclic]
        definition = math(R, -_transformed(function, hamiltonian, hamiltonian.cyclic))
        replaced = listed(math(prime(hamiltonian.coordinates[c])) for c in hamiltonian.cyclic)
        body += [
            prose("For ", *listed(others), " alone, Routh's function ", definition, ", with the constant ",
                  plural(len(cyclic), "momentum", "momenta"), " in place of ", *replaced, ", is the Lagrangian:"),
            display(Equation((R, hamiltonian.routhian), label=_label(hamiltonian, "routhian")), boxed=True),
        ]  # fmt: skip
    return body


def _transformed(function: sp.Expr, hamiltonian: Hamiltonian, which: Iterable[int]) -> sp.Expr:
    """Σ p_k q_k' − L over some coordinates."""
    velocities = hamiltonian.configuration.slots.velocities
    return sp.Add(*(hamiltonian.momenta[k] * velocities[k] for k in which), -function)
