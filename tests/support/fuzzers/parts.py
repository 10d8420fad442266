"""Problem files put together from parts that are right by themselves, their simulations, and answers to what they ask.

A file by grammar (`inputs.problem_by_grammar`) has odd expressions in few keys; here the expressions are those of
textbooks, and the keys meet as nobody has tried: a blow and a friction, names with signs in them, units that do not fit.
"""

from __future__ import annotations

import random
from functools import cache
from unittest.mock import patch

from lagrange.animation.moving import moving_figure
from lagrange.answers.examiner import Examiner
from lagrange.answers.submissions import Grader, Submission
from lagrange.core.diagnostics import GaveUpError, ProblemError, Source
from lagrange.document.derivation import Detail
from lagrange.explain.report import report
from lagrange.problem.loader import load, read_problem
from lagrange.programs.prepared import longest_time, prepared
from lagrange.programs.simulation import simulated
from lagrange.render import html, json, latex, markdown, terminal
from tests.support.fuzzers.inputs import UNITS, mutated, refused
from tests.support.paths import PROBLEMS

NAMES = ["the upper bob", "A & B", "$m_1$", "\\textbf{x}", "<b>bob</b>", "a # b", "x_1^2", "%", "P'", "ß", "*"]
FITTING = {
    "m": "2 kg",
    "l": "30 cm",
    "g": "9.81 m/s^2",
    "k": "5 N/m",
    "c": "0.1 kg/s",
    "F": "3 N",
    "M": "1 ft",
    "J": "0.02 kg*m^2",
}
QUANTITIES = ["2", "{value: 5}", "1e3", "{value: 2, unit: kg}", "3 lb", "30 deg"]
SETS: dict[str, tuple[list[str], str, str]] = {
    "plane": (["x", "y"], "x*i + y*j", ""),
    "angle": (["theta"], "l*sin(theta)*i - l*cos(theta)*j", ""),
    "slope": (["s", "theta"], "s*i", "s*i + l*sin(theta)*i - l*cos(theta)*j"),
    "wire": (["x", "y"], "x*i + y*j", "c: {equation: y = a*x^2, reaction: N}"),
    "rod": (["x", "y"], "x*i + y*j", "string: x^2 + y^2 = l^2"),
    "floor": (["x", "y"], "x*i + y*j", "floor: {equation: y >= 0, reaction: N}"),
}  # fmt: skip
FORCES = [
    "spring1: {spring: k, between: [P, 'a*i'], length: l}",
    "spring2: {spring: k, between: [P, '0*i']}",
    "damp: {damper: c, between: [P, 'b*j']}",
    "pull: {on: P, vector: 'F*i'}",
    'drag: {on: P, vector: "-c*r_P\'"}',
    "field: {potential: 'k*{q}^2/2 - F*{q}'}",
    "rub: {friction: mu, constraint: CONSTRAINT, on: P}",
    "stick: {friction: mu, static: mu, constraint: CONSTRAINT, on: P, slip: positive}",
]
FINDS = [
    "motion",
    "motion",
    "motion",
    "equilibrium",
    "equilibrium",
    "motion",
    "equilibrium",
    "linearization",
    "steady",
    "hamiltonian",
    "impending",
    "response",
    "impact",
    "constraints",
]


def by_parts(rng: random.Random) -> str:
    """A file of a right form, of parts that need not fit one another."""
    coordinates, position, more = SETS[rng.choice(list(SETS))]
    q = coordinates[0]
    constraint = more.partition(":")[0] if ":" in more else "none"
    forces = [f for f in FORCES if ":" in more or "CONSTRAINT" not in f]
    given = FITTING if rng.random() < 0.4 else {}
    symbols = {s: given.get(s, "positive" if rng.random() < 0.8 else "real") for s in "mlagkcbFMJ"}
    symbols |= {s: rng.choice(QUANTITIES) for s in "mlagkcbFMJ" if rng.random() < 0.03}
    lines = ["title: parts", f"parameters: {{{', '.join(f'{s}: {v}' for s, v in symbols.items())}, mu: positive}}"]
    lines.append(f"coordinates: [{', '.join(coordinates)}]")
    name = f", name: {rng.choice(NAMES)!r}" if rng.random() < 0.4 else ""
    lines.append(f"particles: {{P: {{mass: {rng.choice(['m', 'm', '2*m', '0'])}, position: '{position}'{name}}}}}")
    if rng.random() < 0.5:
        inertia = rng.choice(["inertia: J, ", "inertia: J, ", "", "inertia: 'm*l^2/3', "])
        where = more if more and ":" not in more else position
        lines.append(f"bodies: {{B: {{mass: m, {inertia}position: '{where}', angle: {coordinates[-1]}}}}}")
        forces.append("turn: {on: B, moment: 'M*k'}")
    if ":" in more:
        lines += ["constraints:", f"  {more}"]
    lines += ["gravity: -g*j"] * (rng.random() < 0.8)
    chosen = rng.sample(forces, rng.randint(0, 3))
    lines += ["forces:"] * bool(chosen) + [f"  {f.replace('{q}', q).replace('CONSTRAINT', constraint)}" for f in chosen]
    finds = rng.sample(FINDS, rng.choice([1, 1, 2]))
    lines.append(f"find: [{', '.join(finds)}]")
    if "impact" in finds or rng.random() < 0.1:
        blow = rng.choice(["impulses: {blow: {on: P, vector: 'F*i'}}", f"constraints: {{peg: '{q} = 0'}}",
                           f"constraints: {{peg: '{q} = 0'}}, restitution: {{peg: mu}}"])  # fmt: skip
        lines.append(f"impact: {{before: {{{q}': F}}, {blow}}}")
    if rng.random() < 0.4:
        start = {c: rng.choice(["0", "l", "pi/2", "1", "a"]) for c in coordinates}
        start |= {f"{c}'": rng.choice(["0", "F", "sqrt(g*l)"]) for c in coordinates if "impact" not in finds}
        lines.append(f"initial: {{{', '.join(f'{c}: {v}' for c, v in start.items() if rng.random() < 0.8)}}}")
    if rng.random() < 0.3:
        asked = rng.choice([f'"{q}"', f'"{q}\'"', "t", "N", "energy", "T_kinetic"])
        when = rng.choice([f"{q} = 0", f"{q}' = 0", "t = 1", f"{q} = l", *["N = 0"] * ("N}" in more)])
        lines.append(f'ask: {{one: {{quantity: {asked}, when: "{when}"}}}}')
    if rng.random() < 0.2:
        lines.append("answers: {equilibrium: [[" + f"'{q} = {rng.choice(['0', 'm*g/k', 'l', 'pi'])}'" + "]]}")
    return "\n".join(lines) + "\n"


@patch("lagrange.mechanics.solution.UNITS_OF_SOLVING", UNITS)
def problem_by_parts(seed: int) -> str:
    """A problem of parts, solved, and written in every format."""
    try:
        solved = report(read_problem(Source("fuzz.yaml", by_parts(random.Random(seed)))))
        page = [(solved.derivation, solved.notation)]
        terminal.text(*page[0], 80, Detail.FULL)
        html.render(page, Detail.STEPS, [moving_figure(solved.solution)])
        latex.render(page)
        markdown.render(page)
        json.render([solved])
    except GaveUpError:
        return "given up"
    except ProblemError as error:
        return refused(error)
    return "given up" if solved.solution.given_up else "solved" if solved.holds else "solved in part"


@patch("lagrange.mechanics.solution.UNITS_OF_SOLVING", UNITS)
def simulation(seed: int) -> str:
    """A problem of parts, or a shipped one with a few tokens changed, followed for a tenth of its usual time."""
    rng = random.Random(seed)
    text = by_parts(rng) if rng.random() < 0.6 else mutated(rng.choice(_shipped_motions()), rng)
    try:
        made = prepared(read_problem(Source("fuzz.yaml", text)), complete=True)
        motion = simulated(made.states, made.start, longest_time(made.states, made.start) / 10)
    except GaveUpError:
        return "given up"
    except ProblemError as error:
        return refused(error)
    return "accurate" if motion.is_accurate else "not accurate"


@cache
def _shipped_motions() -> list[str]:
    return [path.read_text(encoding="utf-8") for path in sorted(PROBLEMS.glob("motion/*.yaml"))]


QUESTIONS = [
    "motion/leaving-a-sphere", "motion/ball-thrown-up", "motion/released-pendulum", "motion/rod-cut-loose", "statics/ladder",
    "statics/beads-on-hoop", "statics/crate-tips-or-slides", "motion/conical-pendulum", "motion/precessing-top",
    "motion/coupled-oscillators", "motion/ballistic-curve", "statics/rough-incline",
]  # fmt: skip
REPLIES = [
    "N = m*g*cos(theta) - m*v^2/R = 0, so cos(theta) = 2/3",
    "v = sqrt(2*g*h) = sqrt(2*9.81*2) = 6.26 m/s",
    "theta = 48.2 deg (leaves the sphere)",
    "(a) T = 3*m*g\n(b) v^2 = 2*g*l\n(c) stable",
    "x = 0: unstable; x = l: stable",
    "omega_1 = sqrt(g/l), omega_2 = sqrt(g/l + 2*k/m), T = 2*pi*sqrt(l/g)",
    "At the moment of release: a = g/2, T = m*g/4.",
    "N_A = W/2, F_B = -W/2 (to the left), for mu > tan(alpha)",
    "$\\omega^2 = \\frac{g}{l}$, stable for $\\omega^2 < g/R$",
    "mu_s >= tan(alpha)\nP <= W*(sin(alpha) + mu*cos(alpha))",
    "xi'' + (g/l)*xi = 0 for small xi",
    "t = 1.43 s, x = 10.2 m, z = 0",
]


@cache
def _grader(name: str) -> Grader:
    return Grader.of(Examiner.of(load(PROBLEMS / f"{name}.yaml")))


def reply(seed: int) -> str:
    """A text with values, limits, stability and words, handed in for a problem that asks for such things."""
    rng = random.Random(seed)
    text = "\n".join(rng.sample(REPLIES, rng.choice([1, 1, 2])))
    content = (mutated(text, rng) if rng.random() < 0.8 else text).encode("utf-8", "replace")
    return _grader(rng.choice(QUESTIONS)).grade(Submission("x", (("answer.txt", content),))).verdict.value
