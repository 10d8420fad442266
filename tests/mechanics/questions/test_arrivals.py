"""Whether a motion arrives where a question is asked."""

from __future__ import annotations

from collections.abc import Callable

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.signs import sign_of
from lagrange.core.diagnostics import ProblemError
from lagrange.core.symbols import t
from lagrange.explain.report import report
from lagrange.mechanics.questions.arrivals import while_slipping
from lagrange.mechanics.solution import solve
from lagrange.render import terminal
from lagrange.render.json import as_object
from tests.mechanics.questions.test_questions import SPHERE, Read, asked
from tests.mechanics.test_book_questions import SPRING
from tests.support.shared import solved


def test_a_position_at_rest_that_may_be_left_to_either_side_leaves_the_sense_open(problem: Read) -> None:
    answer = asked(
        problem, SPHERE + "initial: {theta: 0, theta': 0}\nask: {it: {quantity: \"R*theta'\", when: N = 0}}\n"
    )
    assert answer.mirrored
    assert len(answer.branches) == 2


BOAT = """
title: Boat that drifts
parameters: [m, b, v, s]
coordinates: [x]
particles: {P: {mass: m, position: x*i}}
forces: {drag: {on: P, vector: "-b*x'*i"}}
initial: {x: 0, x': v}
"""


def test_a_rest_that_is_only_approached_is_said_to_be(problem: Read) -> None:
    solution = report(problem(BOAT + 'ask: {rest: {quantity: x, when: "x\' = 0"}}\n'), None)
    [answer] = solution.solution.asked
    assert answer.branches[0].limit
    assert "in the limit t → ∞" in terminal.text(solution.derivation, solution.notation, 100)
    assert "in the limit t → ∞" in as_object(solution)["asked"][0]["conditions"]
    with pytest.raises(ProblemError) as error:
        solve(problem(BOAT + 'ask: {rest: {quantity: t, when: "x\' = 0"}}\n'), complete=False)
    assert "only in the limit" in error.value.diagnostics[0].message


def test_a_pendulum_never_gets_above_where_it_was_let_go(problem: Read) -> None:
    text = """
title: Pendulum
parameters: {m: positive, l: positive, g: positive, alpha: acute}
coordinates: [theta]
particles: {P: {mass: m, position: l*sin(theta)*i - l*cos(theta)*j}}
gravity: -g*j
initial: {theta: alpha, theta': 0}
ask: {QUESTION}
"""
    for quantity in ("theta'", "theta''", "energy"):
        question = f'side: {{quantity: "{quantity}", when: theta = pi/2}}'
        with pytest.raises(ProblemError) as error:
            solve(problem(text.replace("QUESTION", question)), complete=False)
        assert error.value.diagnostics[0].code == "never-holds"


def test_a_system_that_stays_at_rest_never_gets_anywhere(problem: Read) -> None:
    text = SPRING.partition("forces:")[0] + "initial: {x: 0, x': 0}\nask: {it: {quantity: t, when: x = a}}\n"
    with pytest.raises(ProblemError) as error:
        solve(problem(text))
    assert [d.code for d in error.value.diagnostics] == ["never-holds"]


@pytest.mark.parametrize(
    ("until", "least"),
    [(sp.pi / 2, 1), (sp.pi / 6, sp.Rational(1, 2)), (2, 1)],
)
def test_what_is_never_reached_ends_nothing(until: sp.Expr, least: sp.Expr) -> None:
    """l − A sin(w t) > 0 up to w t = π/2 for l ≥ A, where arcsin(l/A) need not exist."""
    length, size, w = sp.symbols("l A w", positive=True)
    [condition] = while_slipping([length - size * sp.sin(w * t)], until / w, sign_of)
    assert condition.relation == "≥"
    assert sp.simplify((condition.lhs - condition.rhs) / (length - least * size)).is_positive


def test_a_wave_that_starts_at_its_least_value_lasts() -> None:
    """l − d cos(w t) > 0 where it begins, l > d, holds ever after, also for l > d where arccos(l/d) does not exist."""
    length, d, w = sp.symbols("l d w", positive=True)
    [condition] = while_slipping([length - d * sp.cos(w * t)], sp.pi / (2 * w), sign_of)
    assert (condition.lhs - condition.rhs) * (1 if condition.relation == ">" else -1) == length - d


@pytest.mark.parametrize(
    ("force", "final"), [("c*v'^2", lambda m, g, c: sp.sqrt(m * g / c)), ("c*v'", lambda m, g, c: m * g / c)]
)
def test_a_final_speed_is_the_limit_of_the_fall(problem: Read, force: str, final: Callable[..., sp.Expr]) -> None:
    """With v² drag v'' = 0 has two roots: the fall from rest comes to one of them, and is never there."""
    text = (
        "title: Stone that falls\nparameters: {m: positive, g: positive, c: positive}\ngravity: -g*j\n"
        "coordinates: [v]\nparticles: {stone: {mass: m, position: -v*j}}\n"
        f'forces: {{drag: {{on: stone, vector: "{force}*j"}}}}\ninitial: {{v: 0, v\': 0}}\n'
        "ask: {final: {quantity: v', when: \"v'' = 0\"}}\n"
    )
    [asked] = solve(problem(text)).asked
    [branch] = asked.branches
    assert branch.limit
    assert not branch.provided
    symbols = {s.name: s for s in branch.rhs.free_symbols}
    assert sp.simplify(branch.rhs - final(symbols["m"], symbols["g"], symbols["c"])) == 0


DOME = """title: Ball on a dome
parameters: {m: positive, R: positive, g: positive}
gravity: -g*j
coordinates: [r, theta]
particles: {ball: {mass: m, position: "r*(sin(theta)*i + cos(theta)*j)"}}
constraints: {dome: {equation: r >= R, reaction: N}}
initial: {theta: 0, theta': 0}
"""


def test_no_answer_after_contact_has_ended(problem: Read) -> None:
    """The ball leaves the dome where cos θ = 2/3: there is no speed on it at θ = π/2."""
    before = DOME + "ask: {v: {quantity: R*theta', when: theta = pi/4}}\n"
    assert len(solve(problem(before)).asked[0].branches) == 1
    with pytest.raises(ProblemError) as error:
        solve(problem(DOME + "ask: {v: {quantity: R*theta', when: theta = pi/2}}\n"))
    assert [d.code for d in error.value.diagnostics] == ["never-holds"]
    assert "contact with `dome`" in error.value.diagnostics[0].message


def test_a_string_must_be_taut_where_a_swing_turns(problem: Read) -> None:
    """v² ≤ 4 g l would do for a rod; on a string the bob turns within the lower half only, v² ≤ 2 g l."""
    text = (
        "title: Load on a rope\nparameters: {m: positive, v_0: positive, l: positive, g: positive}\ngravity: -g*j\n"
        "coordinates: [r, theta]\nparticles: {load: {mass: m, position: 'r*(sin(theta)*i - cos(theta)*j)'}}\n"
        "constraints: {rope: {equation: r <= l, reaction: T}}\ninitial: {theta: 0, theta': v_0/l}\n"
        "ask: {angle: {quantity: theta, when: theta' = 0}}\n"
    )
    [asked] = solve(problem(text)).asked
    [condition] = asked.branches[0].conditions
    assert sp.expand(condition.lhs - condition.rhs - sp.sympify("2*g*l - v_0**2", {s.name: s for s in (
        condition.lhs.free_symbols | condition.rhs.free_symbols)})) == 0  # fmt: skip


def test_contact_lasts_all_the_way_round_a_loop(problem: Read) -> None:
    """N is least at the top: v² ≥ 5 g R for the whole turn, where N = m v²/R + m g at its end is positive anyway."""
    text = (
        "title: Loop\nparameters: {m: positive, R: positive, g: positive, v: positive}\ngravity: -g*j\n"
        "coordinates: [r, theta]\nparticles: {car: {mass: m, position: 'r*(sin(theta)*i - cos(theta)*j)'}}\n"
        "constraints: {track: {equation: r <= R, reaction: N}}\ninitial: {theta: 0, theta': v/R}\n"
        "ask: {after: {quantity: R*theta', when: theta = 2*pi}}\n"
    )
    [asked] = solve(problem(text)).asked
    [condition] = asked.branches[0].conditions
    at = {"R": 2, "g": 10}
    margin = (condition.lhs - condition.rhs).xreplace(
        {s: at[s.name] for s in (condition.lhs - condition.rhs).free_symbols if s.name in at}
    )
    [least] = [v for v in sp.solve(margin) if v.is_positive]
    assert least == 10  # v² = 5 g R


def test_a_terminal_speed_is_approached(problem: Read) -> None:
    """v' = g - k v²/m from rest: the root √(m g/k) is approached, the other is not."""
    text = FALL + 'ask: {terminal: {quantity: "y\'", when: "y\'\' = 0"}}\n'
    [answer] = report(problem(text), None).solution.asked
    [branch] = answer.branches
    m, g, k = sp.symbols("m g k", positive=True)
    assert (branch.rhs - sp.sqrt(m * g / k)).equals(0)
    assert branch.limit
    assert not branch.provided


FALL = """
title: Fall
axes: {j: down}
parameters: [m, g, k]
coordinates: [y]
particles: {P: {mass: m, position: y*j}}
gravity: g*j
forces: {drag: {on: P, vector: "-k*y'*abs(y')*j"}}
initial: {y: 0, y': 0}
"""


SPHERE_ON_AN_INCLINE = """
title: Sphere let go on a rough incline, said to slip
parameters: {m: positive, R: positive, g: positive, mu: STATIC, mu_s: STATIC, alpha: 40 deg}
coordinates: [x, y, theta]
bodies: {ball: {mass: m, inertia: 2/5*m*R^2, position: x*i + y*j, angle: -theta}}
constraints: {incline: {equation: y >= R, reaction: N}}
gravity: g*sin(alpha)*i - g*cos(alpha)*j
forces: {rub: {friction: mu, static: mu_s, constraint: incline, on: ball, at: r_ball - R*j, slip: i}}
initial: {x: 0, x': 0, theta: 0, theta': 0}
ask: {it: {quantity: "x'", when: t = 2}}
"""


@pytest.mark.parametrize(("kinetic", "static", "slips"), [("0.2", "0.22", True), ("0.2", "0.25", False)])
def test_friction_at_rest_decides_whether_a_stated_slip_begins(
    kinetic: str, static: str, slips: bool, problem: Read
) -> None:
    """A sphere rolls without slipping where (2/7) tan 40° = 0.2397 is no more than the coefficient at rest."""
    values = f"mu: {{value: {kinetic}}}, mu_s: {{value: {static}}}"
    text = SPHERE_ON_AN_INCLINE.replace("mu: STATIC, mu_s: STATIC", values)
    if slips:
        assert asked(problem, text).answered
        return
    with pytest.raises(ProblemError) as error:
        solve(problem(text), complete=False)
    assert error.value.diagnostics[0].code == "never-holds"


def test_without_values_the_coefficient_at_rest_is_in_a_condition(problem: Read) -> None:
    [branch] = asked(problem, SPHERE_ON_AN_INCLINE.replace("STATIC", "positive")).branches
    assert any("mu_s" in {s.name for s in (c.lhs - c.rhs).free_symbols} for c in branch.conditions)


def test_the_top_is_not_reached_with_just_the_energy() -> None:
    """With m² v² = 4 (M + m)² g l the ballistic pendulum gets upright only as t → ∞."""
    [swing, *_] = solved("ballistic-pendulum").asked
    [b] = swing.branches
    assert [c.relation for c in b.conditions] == [">"]
