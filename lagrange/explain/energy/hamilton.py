"""Hamilton's function and the canonical equations, and Routh's function of the coordinates that are not cyclic."""

from __future__ import annotations

from collections.abc import Iterable

import sympy as sp

from lagrange.core.symbols import Partial, TimeDerivative, prime, t
from lagrange.document.builders import display, listed, math, paragraph, prose
from lagrange.document.derivation import Block, Equation, Part, Rule, Step
from lagrange.explain.words import are, plural, suffix_of, title_in
from lagrange.mechanics.energy_symbols import EnergySymbols
from lagrange.mechanics.momenta.hamiltonian import Hamiltonian

ZERO = sp.S.Zero


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
        Equation((p, Partial(function, v), e), label=_label(hamiltonian, f"momentum-{p.name}"))
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
