"""The symbols for T, V, L, H, R, p_k, Q_k, S_k and v, and replacements where the problem uses these letters otherwise.

A pendulum of length L has the Lagrangian Λ; one whose rod has the tension T has the kinetic energy K. The names are
valid in the language of problem files, so that what is printed with them can be read back.
"""

from __future__ import annotations

from collections.abc import Collection
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.core.records import record
from lagrange.core.symbols import free_letter
from lagrange.mechanics.results import Solution

if TYPE_CHECKING:
    from lagrange.mechanics.dynamics.energies import Energies
    from lagrange.mechanics.equilibrium.linearization import Linearization


@record
class EnergySymbols:
    """The symbols of one derivation; those of coordinates and points by their first letters."""

    kinetic: sp.Symbol
    potential: sp.Symbol
    lagrangian: sp.Symbol
    hamiltonian: sp.Symbol
    routhian: sp.Symbol
    momenta: str
    forces: str
    quasi: str
    masses: str
    speeds: str
    index: str

    @property
    def before(self) -> sp.Symbol:
        """T_0, the kinetic energy before an impact."""
        return _symbol(f"{self.kinetic.name}_0")

    @property
    def of_energies(self) -> tuple[sp.Symbol, ...]:
        """T, T_0, V, L, H: what is measured in J."""
        return self.kinetic, self.before, self.potential, self.lagrangian, self.hamiltonian

    @property
    def coordinate(self) -> sp.Symbol:
        """q_k, any coordinate."""
        return _symbol(f"q_{self.index}")

    @property
    def any(self) -> tuple[sp.Symbol, sp.Symbol, sp.Symbol]:
        """p_k, Q_k and N_k of any coordinate."""
        k = _symbol(self.index)
        return self.momentum(k), self.force(k), self.addition(k)

    def momentum(self, coordinate: sp.Symbol) -> sp.Symbol:
        """p_k."""
        return _symbol(f"{self.momenta}_{coordinate.name}")

    def force(self, coordinate: sp.Symbol) -> sp.Symbol:
        """Q_k."""
        return _symbol(f"{self.forces}_{coordinate.name}")

    def addition(self, coordinate: sp.Symbol) -> sp.Symbol:
        """N_k, of quasi-coordinates."""
        return _symbol(f"{self.quasi}_{coordinate.name}")

    def of_masses(self, coordinate: sp.Symbol) -> sp.Symbol:
        """S_k, of masses that vary."""
        return _symbol(f"{self.masses}_{coordinate.name}")

    def speed(self, point: str) -> sp.Symbol:
        """v of a particle or mass centre."""
        return _symbol(f"{self.speeds}_{point}")

    def meanings(self, energies: Energies) -> dict[sp.Symbol, sp.Expr]:
        """The meaning of each letter in one set of coordinates."""
        known = {
            self.kinetic: energies.kinetic,
            self.potential: energies.potential,
            self.lagrangian: energies.lagrangian,
        }
        known |= {s: s for s in (*self.any, self.of_masses(_symbol(self.index)))}
        known |= {self.speed(name): sp.sqrt(square) for name, square in energies.squares.items()}
        for k, q in enumerate(energies.configuration.slots.coordinates):
            known |= {self.momentum(q): energies.momenta[k], self.force(q): energies.applied[k]}
            known |= {self.addition(q): energies.quasi[k], self.of_masses(q): energies.of_masses[k]}
        return known


def lagrangian_letter(taken: Collection[str]) -> sp.Symbol:
    """L, or another letter where that is taken."""
    return _symbol(free_letter("L", "Lambda", "L_agr", taken=taken))


def energy_symbols(solution: Solution) -> EnergySymbols:
    """The letters that a problem leaves free for energies."""
    problem = solution.problem
    chosen = [q.name for c in solution.choices for q in c.configuration.slots.coordinates]
    forces = {c.reaction.name for c in problem.constraints}
    if solution.law is not None:
        forces |= {s.name for s in solution.law.newton.single_forces}
    taken = {*problem.scope.names(), *chosen, *forces}
    if states_potential(solution):
        taken.add(solution.own.configuration.potential_letter.name)
    coordinates = [*(q.name for q in problem.slots.coordinates), *chosen]
    points = [p.name for p in solution.own.configuration.points]
    return EnergySymbols(
        kinetic=_symbol(free_letter("T", "K", "T_kin", taken=taken)),
        potential=_symbol(free_letter("V", "U", "V_pot", taken=taken)),
        lagrangian=lagrangian_letter(taken),
        hamiltonian=_symbol(free_letter("H", "H_am", taken=taken)),
        routhian=_symbol(free_letter("R", "L_R", taken=taken)),
        momenta=free_letter("p", "P", "p_gen", taken=taken, of=coordinates),
        forces=free_letter("Q", "K", "Q_gen", taken=taken, of=coordinates),
        quasi=free_letter("N", "B", "N_gen", taken=taken, of=coordinates),
        masses=free_letter("S", "M", "S_gen", taken=taken, of=coordinates),
        speeds=free_letter("v", "u", "v_abs", taken=taken, of=points),
        index=next(k for k in ("k", "n", "s", "gen") if k not in coordinates and f"q_{k}" not in taken),
    )


def small_displacements(solution: Solution) -> tuple[sp.Symbol, ...]:
    """The letters ξ of all linear equations."""
    return tuple(dict.fromkeys(x for f in _linearizations(solution) for x in f.displacements))


def _linearizations(solution: Solution) -> list[Linearization]:
    """Those about equilibria, and about steady motions."""
    linearizations = [v.linearization for v in solution.views]
    linearizations += [f.about for v in solution.views if v.steady is not None for f in v.steady.families]
    linearizations += [v.forced.linearization for v in solution.views if v.forced is not None]
    return [f for f in linearizations if f is not None]


def letters_of_oscillations(solution: Solution) -> tuple[sp.Symbol, ...]:
    """The letters for frequencies, exponents, decay rates and damping ratios."""
    linear = _linearizations(solution)
    names = {f"{f.omega}{i}" for f in linear for i in ("", *(f"_{n}" for n in range(len(f.displacements) + 1)))}
    names |= {f.exponent.name for f in linear} | ({"zeta"} if linear else set())
    damped = (f for f in linear if any(s is not None and s.decaying is not None for s in f.at))
    names |= {f"{f.decay}{i}" for f in damped for i in ("", *(f"_{n}" for n in range(1, 2 * len(f.displacements) + 1)))}
    return tuple(sp.Symbol(n, real=True) for n in sorted(names))


def states_potential(solution: Solution) -> bool:
    """Whether the derivation has a separate V, that of statics, which excludes the weights."""
    return solution.own.equilibrium is not None and solution.own.configuration.potential != 0


def _symbol(name: str) -> sp.Symbol:
    return sp.Symbol(name, real=True)
