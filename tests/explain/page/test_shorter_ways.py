"""Ways by which pages are shorter or truer: no division by what may vanish, one moment of inertia, signs that are known."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

from lagrange.core.symbols import prime
from lagrange.document.derivation import Display, Math, Rule
from lagrange.mechanics.constraints.displacements import transport_rates, virtual_displacements
from lagrange.render import terminal
from tests.support.shared import reported, solved


def page(name: str) -> str:
    r = reported(name, complete=False)
    return terminal.text(r.derivation, r.notation, 80)


def words(name: str) -> str:
    return " ".join(page(name).split())


@pytest.mark.parametrize(
    ("name", "free"),
    [("ex05-ice-skate", 2), ("south-pointing-chariot", 2), ("car", 2), ("steered-blade", 1)],
)
def test_displacements_by_a_parameter_are_all_solutions_at_every_heading(name: str, free: int) -> None:
    """In numbers, at headings where the division would fail too: A δq = 0, and as many as there are freedoms."""
    r = reported(name, complete=False)
    [step] = [s for s in r.derivation.page if s.rule is Rule.DISPLACEMENTS]
    lines = [e for b in step.body if isinstance(b, Display) for e in b.equations]
    sides = [m.sides for e in lines for m in (e, *(p for p in e.condition if isinstance(p, Math)))]  # two in a line
    given = {a: b for a, b in (pair for pair in sides if len(pair) == 2) if isinstance(a, sp.Symbol)}
    system = r.solution.own.configuration
    moved = [sp.Symbol(f"delta({q.name})", real=True) for q in system.slots.coordinates]
    values = [sp.sympify({s.name: e for s, e in given.items()}.get(d.name, d)) for d in moved]
    parameters = sorted({s for v in values for s in v.free_symbols if s.name.startswith("delta(")}, key=str)
    assert len(parameters) == free
    for heading in (0, 0.3, 1.2):
        symbols = {s for e in (*values, *(a for row in system.rows for a in row.coefficients)) for s in e.free_symbols}
        at = {s: 1.3 if s.is_positive else heading for s in symbols - {*parameters}}
        matrix = np.array([[float(a.subs(at)) for a in row.coefficients] for row in system.rows])
        shape = np.array([[float(v.diff(p).subs(at)) for p in parameters] for v in values])
        assert np.abs(matrix @ shape).max() < 1e-12
        assert np.linalg.matrix_rank(shape) == free


def test_what_a_turning_table_imposes_is_a_rotation() -> None:
    system = solved("skate-on-a-turntable", complete=False).own.configuration.constrained
    x, y, *_ = system.slots.coordinates
    rates = transport_rates(system, virtual_displacements(system))
    [turned] = {(rates[0] / -y), (rates[1] / x)}
    assert turned.free_symbols.isdisjoint({x, y})
    assert set(rates[2:]) == {0}


def test_frobenius_condition_in_chosen_coordinates() -> None:
    said = words("ex06-two-particle-skate")
    assert "ω ∧ dω = −dx ∧ dy ∧ dθ" in said
    assert "½ (𝐫̇_P₁ + 𝐫̇_P₂)·𝐧 = 0" in said
    assert "because of the blade constraint" in said


def test_friction_is_tried_where_something_slides() -> None:
    solution = solved("mass-on-belt", complete=False)
    spot = solution.choices[0].spot
    assert spot is not None
    [x] = solution.choices[0].configuration.slots.coordinates
    belt = next(v for s, v in spot.values.items() if s.name == "v")
    assert spot.values[prime(x)] != belt


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("rough-wedge", "This holds while ṡ > 0"),
        ("rough-wedge", "is the opposite of this force"),
        ("rough-wedge", "P = M (M + m) g/(M + m sin²α − μ m sin α cos α) │"),
        ("constant-speed", "2v² λ dt"),
        ("constant-speed", "λ = (m g/(2v²)) ẏ"),
        ("appell-hamel", "λ = −m g/(2 (a² + 1) ż)"),
        ("triatomic-molecule", "apart from a uniform motion of x₁, x₂ and x₃ together"),
        ("door-closer", "turns about a fixed axis through O. It is turned through the angle θ. Its moment of inertia about "
         "this axis is J"),
        ("ball-in-a-pipe", "about every axis through the mass centre is (2/5) m b²"),
        ("ball-in-a-pipe", "𝐇 = (2/5) m b² 𝛚"),
        ("towed-blade", "a + l ln(|(x − a + l)/y|) = const"),
        ("differential-hoist", "2y − (R − r) φ = const"),
        ("kapitza-pendulum", "x dx + (y − a cos Ωt) dy"),
        ("shortening-pendulum", "A rope can only pull"),
        ("ex12-smooth-surface", "the motion, the reaction and its work"),
        ("two-wheeled-carriage", "λ_sideways = M a ω̇ + (M + 2m) v ω"),
        ("two-wheeled-carriage", "𝐌_body = −(τ₁ + τ₂) 𝐧"),
        ("two-wheeled-carriage", "2b θ + R (φ₁ − φ₂) = const"),
        ("governor", "𝐫_one = l sin θ 𝐨𝐮𝐭 − l cos θ 𝐤"),
        ("sleigh", "Energy: ½ m u² + ½ (m a² + I_G) ω² = const."),
        ("sleigh", "▸ Differential forms and integrability (--choice all)"),
        ("clockwork-skate", "R = m Ω v + m g sin Ωt sin α"),
        ("clockwork-skate", "x = C₂ − (g/(4Ω²)) sin α cos 2Ωt + (C₁/Ω) sin Ωt"),
        ("cycloidal-pendulum", "𝐑·𝐧 = m cos(φ/2) (a φ̇² + g)"),
        ("appell-hamel", "│ z̈ = −g/(a² + 1) │"),
        ("parallel-skates", "Accelerations: none; every coordinate changes uniformly."),
        ("servo", "x = C e^(−κ t) − v/κ + v t"),
        ("rocket", "As before, (9) holds."),
        ("triatomic-molecule", "The particles A, B and C have the masses m, M and m"),
        ("bead-on-lemniscate", "Where x = y = 0, the form (3) vanishes and restricts nothing; (2) itself still holds."),
        ("bicycle", "Two of the displacements can be chosen freely, for instance δy₁ and δψ"),
        ("ex15-rough-incline", "𝐅 = −μ N 𝐝𝐨𝐰𝐧 − m g 𝐣"),
        ("four-bar-linkage", "Try it: "),
    ],
)  # fmt: skip
def test_a_page_says(name: str, said: str) -> None:
    assert said in words(name)


@pytest.mark.parametrize(
    ("name", "unsaid"),
    [
        ("snakeboard", "M_w J_r"),  # no momentum: the two moments of a displacement only cancel
        ("particle-in-bowl", "σ₁ √"),
        ("ex16-rod-on-two-planes", "λ"),
        ("cycloidal-pendulum", "λ = 0 │"),
        ("bead-slowed-on-a-ring", "r θ̈ + 2ṙ θ̇ + μ r θ̇² = 0"),
        ("mass-on-belt", "can only push, contact lasts"),
        ("ex01-horizontal-surface", "is not conserved"),  # nothing is known of the force
        ("struck-sleigh", "integrating factor"),
        ("ex15-rough-incline", "rub"),
        ("ex15-rough-incline", "x = 1/2"),  # the place does not matter
        ("ladder-on-rough-ground", "being the differentials of (4) and (5). So"),  # they are inequalities
    ],
)
def test_a_page_does_not_say(name: str, unsaid: str) -> None:
    assert unsaid not in words(name)


@pytest.mark.parametrize(
    ("name", "lines"), [("two-wheeled-carriage", 175), ("disc-that-rolls-steadily", 185), ("governor", 150)]
)
def test_no_page_is_longer_than_its_reader_is_patient(name: str, lines: int) -> None:
    assert len(page(name).splitlines()) <= lines
