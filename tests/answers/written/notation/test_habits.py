"""Habits of writing that change no mathematics."""

from __future__ import annotations

import pytest

from lagrange.answers.written.notation.habits import in_usual_signs


@pytest.mark.parametrize(
    ("written", "usual"),
    [
        (r"m\ddot x \stackrel{!}{=} 0", r"m\ddot x = 0"),
        (r"m\ddot x \overset{(1)}{=} \overset{..}{y}", r"m\ddot x = \overset{..}{y}"),
        (r"p = m \dot x = \text{const.}", r"p = m \dot x = \text{const} "),
        (r"$\sum F_A = 0:\ m_1 g - c_1 x_1 = 0$", r"$ \ m_1 g - c_1 x_1 = 0$"),
        (r"\sum_i F_{x} = -k x = m\ddot x", r" -k x = m\ddot x"),
        (r"\sum M_O = 0 \Rightarrow N l = W a", r" N l = W a"),
        (r"\sum F_x=m\ddot x &\implies m\ddot x=mg - N", r" m\ddot x=mg - N"),
        (r"\sum F = m\ddot x", r"\sum F = m\ddot x"),
        (r"\theta = 0 \lor \theta = \pi", r"\theta = 0 \text{ or } \theta = \pi"),
        ("θ = 0 ∨ θ = π", "θ = 0 or θ = π"),
        (r"\sin\theta = \frac{M}{m} \quad (M < m)", r"\sin\theta = \frac{M}{m}"),
        (r"F = \mu N \quad (\dot x > 0)", r"F = \mu N \quad (\dot x > 0)"),
        ("cos θ = 2/3 (θ ≈ 48.2°)", "cos θ = 2/3"),
        ("m g h = m g 2R + m v²/2", "m g h = m g*2R + m v²/2"),
        ("x 2 + x 3 = sin 2x", "x 2 + x 3 = sin 2x"),
        (r"m\ddot x = -\frac{\mathrm dU}{\mathrm dx}", r"m\ddot x = -\frac{ dU}{ dx}"),
        (r"x = a (b + c)", r"x = a (b + c)"),
        ("x'' = a, rolls if mu >= b", "x'' = a; mu >= b"),
        ("The disc does not slip as long as mu >= b", "mu >= b"),
        ("x'' = a, slides if mu < b", "x'' = a, slides if mu < b"),  # the opposite is the condition of rest
        ("rolls if x' = R theta'", "rolls if x' = R theta'"),
        ("N = W cos a (a = alpha)", "N = W cos a ;a = alpha;"),
        ("T = m g (theta = pi)", "T = m g (theta = pi)"),
        ("with tan(phi) = mu:  P <= W", "with tan(phi) = mu;  P <= W"),
        ("I about the shaft = m R^2", "I = m R^2"),
        ("v := t -> a*t", "v := a*t"),
        ("(%o5) 'diff(x,t,2) = -%pi*x", "diff(x,t,2) = - pi*x"),
        ("{x: a + b, y'': f(a, b)}", "x = a + b; y'' = f(a, b)"),
        ("{x: a, b}", "{x: a, b}"),
        ("r'' = r sen²α - sen(α)", "r'' = r sin²α - sin(α)"),
        ("sense = senior", "sense = senior"),
        ("p_φ = m r² φ' is conserved (= h), so", "p_phi = m r² φ' = h = const, so"),
        ("the energy is conserved: m r^2 phi' is constant.", "the energy is conserved: m r^2 phi' = const."),
        (r"$z = R + \text{const.}$", "$z = R + const           $"),
        ("Steady ($\\ddot x = \\dot x = 0$): $y = a$", "Steady : $y = a$"),
        ("x = 2 (y'' + 0)", "x = 2 (y'' + 0)"),
        ("t½ = m/b", "t_½ = m/b"),
        ("𝑥 = 𝜔 𝑡", "x = ω t"),
        ("frequencies: a about q = 0; b about q = pi", "omega = a about q = 0; omega = b about q = pi"),
    ],
)
def test_habits(written: str, usual: str) -> None:
    assert in_usual_signs(written).split() == usual.split()


def test_places_stay_where_they_are() -> None:
    text = r"$\sum F = 0: a \stackrel{!}{=} b \quad (a < 1)$"
    assert len(in_usual_signs(text)) == len(text)
