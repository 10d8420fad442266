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


def explain_hamiltonian(found: Hamiltonian, letters: EnergySymbols) -> Step:
    """The momenta, the velocities in terms of them, H, the canonical equations, what is conserved, R."""
    body = [
        *_integrated(found),
        *_momenta(found, letters),
        *_function(found, letters),
        *_equations(found, letters),
        *_constant(found, letters),
    ]
    return Step(Rule.HAMILTON, title_in("Hamilton's equations", found.configuration.name), tuple(body))


def _label(found: Hamiltonian, kind: str) -> str:
    return f"{kind}{suffix_of(found.configuration.name)}"


def _integrated(found: Hamiltonian) -> Iterable[Block]:
    """`θ = −s/R + const: θ appears nowhere else, and the others are free.`"""
    if found.integrated:
        relations = [math(q, e + sp.Symbol("const")) for q, e in found.integrated.items()]
        names = [math(q) for q in found.integrated]
        nowhere = plural(len(names), " does not appear in the energies: the remaining coordinates are free.",
                         " do not appear in the energies: the remaining coordinates are free.")  # fmt: skip
        yield paragraph(prose(plural(len(relations), "The constraint on velocities integrates to ",
                                     "The constraints on velocities integrate to "), *listed(relations), "."),
                        prose(*listed(names), nowhere))  # fmt: skip


def _momenta(found: Hamiltonian, letters: EnergySymbols) -> list[Block]:
    """p_k = ∂L/∂q_k', and q_k' in terms of them."""
    velocities = found.configuration.slots.velocities
    function = letters.lagrangian if found.energies.has_lagrangian else letters.kinetic
    energies = [(letters.kinetic, found.energies.kinetic), (letters.potential, found.energies.potential)]
    if found.energies.moving != 0:
        energies = [(letters.lagrangian, found.energies.lagrangian)]
    stated = [Equation(pair, label=_label(found, f"energy-{pair[0].name}")) for pair in energies if pair[1] != 0]
    momenta = [
        Equation((p, Partial(function, v), e), label=_label(found, f"momentum-{p.name}"))
        for p, v, e in zip(found.momenta, velocities, found.energies.momenta, strict=True)
    ]
    solved = [
        Equation((v, e), label=_label(found, f"velocity-{v.name}"))
        for v, e in zip(velocities, found.velocities, strict=True)
    ]
    lagrangian = math(letters.lagrangian, letters.kinetic - letters.potential)
    lagrangian = math(letters.lagrangian) if found.energies.moving != 0 else lagrangian
    of: tuple[Part, ...] = (", and with ", lagrangian) if function is letters.lagrangian else ()
    energy = (
        "The Lagrangian is"
        if found.energies.moving != 0
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


def _function(found: Hamiltonian, letters: EnergySymbols) -> list[Block]:
    """H, and whether it is the energy."""
    H = letters.hamiltonian
    function = letters.lagrangian if found.energies.has_lagrangian else letters.kinetic
    definition = math(H, _transformed(function, found, range(len(found.momenta))))
    body: list[Block] = [
        prose("Hamilton's function ", definition, ", in terms of coordinates and momenta, is"),
        display(Equation((H, found.function), label=_label(found, "hamiltonian")), boxed=True),
    ]
    energy = letters.kinetic + letters.potential if found.energies.potential != 0 else letters.kinetic
    if found.configuration.is_outright:
        return body
    if found.is_energy and found.energies.moving_energy != 0:
        body.append(prose("It is the energy ", math(energy), ", with what the potential that depends on velocities "
                          "adds to it."))  # fmt: skip
    elif found.is_energy:
        body.append(prose("It is the energy ", math(energy), "."))
    elif found.is_energy is False:
        body.append(prose("It is not the energy ", math(energy), ": the positions contain time, so the kinetic "
                          "energy is not a quadratic form in the velocities."))  # fmt: skip
    return body


def _equations(found: Hamiltonian, letters: EnergySymbols) -> list[Block]:
    """q' = ∂H/∂p, p' = −∂H/∂q + Q."""
    H = math(letters.hamiltonian)
    lines = []
    for q, p, velocity, rate in zip(found.coordinates, found.momenta, found.velocities, found.rates, strict=True):
        lines.append(Equation((prime(q), velocity), label=_label(found, f"canonical-{q.name}")))
        lines.append(Equation((prime(p), rate), label=_label(found, f"canonical-{p.name}")))
    forces = "" if found.is_conservative else ", plus the generalized force that has no potential"
    return [
        prose("Each velocity is the derivative of ", H, " with respect to its momentum; each momentum changes at the "
              "rate of minus the derivative with respect to its coordinate", forces,
              ". Hamilton's canonical equations are therefore"),
        display(*lines, boxed=True),
    ]  # fmt: skip


def _constant(found: Hamiltonian, letters: EnergySymbols) -> list[Block]:
    """Whether H is constant; the cyclic coordinates; Routh's function."""
    H = letters.hamiltonian
    body: list[Block] = []
    if not found.depends_on_time and found.is_conservative:
        body.append(prose("Time does not appear explicitly in ", math(H), ", so ",
                          math(TimeDerivative(H), Partial(H, t), ZERO), ": it is constant."))  # fmt: skip
    if not found.cyclic:
        return body
    cyclic = [math(found.coordinates[c]) for c in found.cyclic]
    constant = [math(found.momenta[c]) for c in found.cyclic]
    verb = plural(len(cyclic), " does not appear in ", " do not appear in ")
    body.append(prose(*listed(cyclic), verb, math(H), ", so ", *listed(constant), are(constant), "constant."))
    if found.routhian is not None:
        R = letters.routhian
        function = letters.lagrangian if found.energies.has_lagrangian else letters.kinetic
        others = [math(q) for k, q in enumerate(found.coordinates) if k not in found.cyclic]
        definition = math(R, -_transformed(function, found, found.cyclic))
        replaced = listed(math(prime(found.coordinates[c])) for c in found.cyclic)
        body += [
            prose("For ", *listed(others), " alone, Routh's function ", definition, ", with the constant ",
                  plural(len(cyclic), "momentum", "momenta"), " in place of ", *replaced, ", is the Lagrangian:"),
            display(Equation((R, found.routhian), label=_label(found, "routhian")), boxed=True),
        ]  # fmt: skip
    return body


def _transformed(function: sp.Expr, found: Hamiltonian, which: Iterable[int]) -> sp.Expr:
    """Σ p_k q_k' − L over some coordinates."""
    velocities = found.configuration.slots.velocities
    return sp.Add(*(found.momenta[k] * velocities[k] for k in which), -function)
