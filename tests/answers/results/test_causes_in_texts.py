"""Wrong answers in a text, each worked out from a wrong model, and the physical cause that the feedback names."""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.core.diagnostics import Fragment
from tests.support.shared import loaded, solved

CAUSES = [
    ("rod-falls-on-an-edge", "theta' = 3*a*v/(4*l^2 + 3*a^2)", "moment of inertia 4*m*l^2/3"),
    ("rod-falls-on-an-edge", "θ' = v/√(l²/3 + a²)", "kinetic energy is taken to be conserved"),
    ("centre-of-percussion", "x' = J/m", "without `hinge`"),
    ("disc-against-a-step", "theta' = 2/3*omega*(1 - h/R)", "without theta' just before the impact"),
    ("swinging-atwood", "F = M g", "as if there were no acceleration"),
    ("cylinder-on-wedge", "N = m g cos(alpha)", "as if there were no acceleration"),
    ("particle-in-bowl", "N = -m g z/l", "at rest: what the velocities contribute"),
    ("ball-on-a-string", "T = m g cos(phi)", "at rest: what the velocities contribute"),
    ("shortening-pendulum", "T = m*g*cos(phi) + m*l*phi'^2", "for a constant l"),
    ("hoop-on-incline", "F = m g sin(alpha)/3", "3/2 times as large"),
    ("ex15-rough-incline", "F_N = m g", "a factor cos(alpha) is missing"),
    ("cylinder-on-rough-incline", "F = mu_s*m*g*cos(alpha)", "does not depend on mu_s"),
    ("rough-incline", "P = W tan(alpha) - mu_s W", "mu_s times a part of the normal force"),
    ("rough-incline", "P_min = W (tan(alpha) - mu_s), P_max = W (tan(alpha) + mu_s)", "part of the normal force"),
    (
        "rough-incline",  # the same reason is given once
        "N = W cos(alpha)\nP cos(alpha) + mu_s W cos(alpha) = W sin(alpha)\nP_min = W (tan(alpha) - mu_s)",
        "the term mu_s*P*sin(alpha) is missing, mu_s times a part of the normal force",
    ),
    ("rough-incline", "P = W tan(alpha)", "as if mu_s = 0"),
    ("conical-pendulum", "T sinθ = m l φ'^2, T cosθ = m g, so tanθ = l φ'^2/g", "a factor sin(theta) is missing"),
    ("conical-pendulum", "tan(theta) = l*phi'^2/g", "a factor sin(theta) is missing"),
    ("inverted-pendulum-springs", "θ = 0, θ = π, cosθ = W l/(2 c b²)", "an energy without its 1/2"),
    ("thrown-stone", "y = x*tan(alpha) - g*x^2/(2*v^2)", "no division by cos(alpha)^2 in the term"),
    ("escape-from-a-planet", "v = sqrt(K/R)", "a factor sqrt(2) is missing"),
    ("charge-in-crossed-fields", "y = m E/(q B^2)", "the middle of the oscillation"),
    ("coupled-pendulums", "omega_1 = sqrt(g/l), omega_2 = sqrt(g/l + c/m)", "the other coordinates held fast"),
    ("rotating-unbalance", "|y| = m e w² / (c − (M+m) w²)", "without b, as if b = 0"),
    ("balanced-lamp", "W = c*h/2", "twice as large, or acting at twice the distance"),
    ("balanced-lamp", "W = c*l", "with l in place of h"),
    ("hawser-on-a-bollard", "mu >= 0.135", "logarithm to base ten"),
    ("hawser-on-a-bollard", "mu >= log(50)/720", "in degrees"),
    ("chain-off-a-table", "speed = sqrt(2*g*(l - a))", "the force at the end is taken for the whole way"),
    ("ball-on-a-string", "T = m l phi'^2", "without g"),
    ("dynamic-absorber", "x = F/(c_1 - m_1*w^2)", "without what couples x with y in the equation of x"),
    ("dynamic-absorber", "y = F*c_2/((c_1 + c_2 - m_1*w^2)*(c_2 - m_2*w^2))", "without the term with y in the"),
    ("shaken-support", "x = a*m*w^2/sqrt((c - m*w^2)^2 + b^2*w^2)", "relative to the support"),
    ("shaken-support", "x = a*c/sqrt((c - m*w^2)^2 + b^2*w^2)", "without the cos(w*t) term of the drive"),
    ("step-ladder", "tan(theta_1) <= mu", "at twice the distance from where the friction `rub_1`, `rub_2` acts"),
    ("collar-on-a-shaft", "a = h/mu", "without the friction `above`"),
    ("ladder-on-rough-ground", "cot(theta) = 2*mu/(1 - mu*nu)", "sine and cosine of theta exchanged"),
    ("conical-pendulum", "cos(theta) = g/(2*l*phi'^2)", "twice the centrifugal terms"),
    (
        "three-rods",
        "tan(theta_1) = 2*P/W, tan(theta_2) = 2*P/(3*W), tan(theta_3) = 2*P/(5*W)",
        "with theta_1 and theta_3 exchanged",
    ),
    ("ladder-leaves-the-wall", "sin(theta) = 2/3*sin(alpha)", "sine and cosine exchanged"),
    ("load-that-lifts-a-chain", "lowest = M/rho", "the forces are balanced"),
    ("rolling-without-slip", "least_roughness = tan(alpha)", "as if there were no acceleration"),
    ("rolling-without-slip", "speed = sqrt(16/9*g*s*sin(alpha))", "x' = 2*R*theta' as the constraint `rolling`"),
    ("rolling-without-slip", "least_roughness = tan(alpha)/9", "x' = 2*R*theta' as the constraint `rolling`"),
    ("rod-cut-loose", "turning = -6*g/l", "the motion of the mass centre of `rod`"),
    ("charge-in-a-magnetic-field", "m*x'' = -q*B*y', m*y'' = q*E + q*B*x'", "the force `magnetic` acting the other"),
    ("chain-off-a-table", "speed = sqrt(g*(l - a)^2/l)", "the way from the start stands where x belongs"),
]


@pytest.mark.parametrize(("problem", "text", "cause"), CAUSES)
def test_a_wrong_text_is_told_its_cause(problem: str, text: str, cause: str) -> None:
    judgement = Examiner(loaded(problem), solved(problem)).check((Fragment.of(text),))
    assert judgement.verdict.value in ("wrong", "undecided")
    said = str(judgement) + " ".join(a.diagnosis for a in judgement.others)
    parts = [e.diagnosis for e in (*judgement.each, *(e for a in judgement.others for e in a.equations))]
    assert cause in " ".join([said, *parts])
    hint = " ".join(str(judgement.at_hint_level(1)).split())
    assert cause not in hint
