"""Why a quantity is conserved."""

from __future__ import annotations

import pytest

from lagrange.core.diagnostics import Source
from lagrange.document.derivation import Rule
from lagrange.explain.energy.conservation import conserved_called
from lagrange.mechanics.dynamics.conservation import ConservedQuantity
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem
from tests.support.derivation_text import said_in


@pytest.mark.parametrize(
    ("name", "rule", "said"),
    [
        (
            "ex11-ideal-pendulum",
            Rule.CONSERVED,
            "Every force that does work derives from a time-independent potential. Therefore ",
        ),
        ("ex14-two-particles", Rule.CONSERVED, " change neither energy, and the forces do no net work in them"),
        ("bead-in-a-turning-tube", Rule.CONSERVED, "Time appears in the positions but in neither energy, and "),
    ],
)
def test_the_reason_is_given(name: str, rule: Rule, said: str) -> None:
    assert said in said_in(name, rule)


TURNED = "coordinates: [{q}, phi]\nparameters: [h, m, J]\nbodies: {{B: {{mass: m, inertia: [J, J, J], position: {q}*{along}, "


@pytest.mark.parametrize(("along", "quantity"), [("k", "MOMENTUM"), ("i", "ANGULAR_MOMENTUM")])
def test_the_momentum_of_a_screw_is_no_angular_momentum(along: str, quantity: str) -> None:
    """m h ż + J φ̇ of a nut on a thread; of a disc that rolls it is that about the line on which it rolls."""
    text = f"title: Nut\n{TURNED.format(q='z', along=along)}orientation: {{axes: 313, angles: [phi, 0, 0]}}}}}}\n"
    motion = solve(read_problem(Source("nut.yaml", text + "constraints: {thread: z = h*phi}\n"))).own
    conserved = motion.conserved
    assert conserved is not None
    called = [conserved_called(i, motion.configuration) for i in conserved.integrals]
    assert called == [ConservedQuantity[quantity], ConservedQuantity.ENERGY]
