"""Figures that move, played in a real browser: energy and constraints are kept, sliders work, the motion is right.

The references are written by hand and share nothing with the program: the pendulums in Cartesian vectors or in the
equations of a textbook, disc and top by Newton's and Euler's laws for the axis e3 and the angular velocity ω in space.
"""

from __future__ import annotations

import json
import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from lagrange.animation.moving import moving_figure
from lagrange.programs.simulation import simulated
from lagrange.render import html
from tests.support.browser import CHROMIUM
from tests.support.played import DRIVE, played
from tests.support.shared import in_numbers, reported

NAMES = (
    "ex11-ideal-pendulum",
    "ex18-double-pendulum",
    "spherical-pendulum-by-routh",
    "rolling-disc",
    "heavy-top",
    "ex17-spherical-pendulum",
    "roberval-balance",
    "leaving-a-sphere",
    "ex09-moving-surface",
    "bead-on-rotating-hoop",
    "rod-in-bowl",
    "slider-crank",
)
SIMULATED = "the pendulum of `simulate`"
FOLLOWED = """
    if (document.querySelectorAll("iframe").length == found.length + 1) {
      for (let k = 0; k < 20; k++) figure.querySelector("button.step").click();
      one.followed = play(0).state;
    }
"""
AT_REST = ("roberval-balance", "ex09-moving-surface", "rod-in-bowl", "slider-crank")
TURN = """
    one.nameless = [...figure.querySelectorAll("button, select, input")].filter(e => !e.getAttribute("aria-label") && !e.textContent.trim() && !(e.closest("label") || e).textContent.trim()).length;
    slide("p", 1, 2.5);
    one.turned = play(20);
    const frames = [], press = key => figure.querySelector("svg.stage").dispatchEvent(new frame.KeyboardEvent("keydown", {key, bubbles: true}));
    frame.requestAnimationFrame = f => frames.push(f);  // no clock: a frame comes when it is asked for, and late
    let clock = frame.performance.now();
    const tick = () => frames.splice(0).forEach(f => f(clock += 1000));
    const button = figure.querySelector("button.play") || figure, named = () => button.getAttribute("aria-label");
    if (button !== figure) { button.click(); for (let k = 0; k < 4; k++) tick(); one.playing = named(); button.click(); }
    one.later = play(0);
    const [virtual, possible] = ["virtual", "possible"].map(k => { const b = figure.querySelector(`[data-show="${k}"]`); return () => { if (!b) return null; b.checked = true; b.dispatchEvent(new frame.Event("change", {bubbles: true})); return figure.querySelector(`path.${k}.tip:not([display])`).getAttribute("d"); }; });
    one.displaced = [virtual(), possible()];
    one.arrows = figure.querySelectorAll("path.virtual.tip:not([display])").length;
    slide("q", 0, 0.26);
    one.slid = play(0);
    const rest = b => { b.click(); return {state: figure.dataset.state, unrest: figure.dataset.unrest, says: read("message")}; };
    one.rests = [...figure.querySelectorAll("button[data-rest]:enabled")].map(rest);
    one.pressed = [" ", " ", "Enter", "Enter"].map(key => { press(key); return named(); });
"""


@pytest.fixture(scope="module")
def results():
    if CHROMIUM is None:
        pytest.skip("there is no browser")
    reports = [reported(name, complete=False) for name in NAMES]
    figures = [moving_figure(r.solution) for r in reports]
    pages = [html.render([(r.derivation, r.notation)], moving=[f]) for r, f in zip(reports, figures, strict=True)]
    motion = reported("ex11-ideal-pendulum", complete=False).solution
    begun = in_numbers("ex11-ideal-pendulum")
    computed = moving_figure(motion, simulated(begun.states, begun.start, 3.0))
    pages.append(html.render([(reports[0].derivation, reports[0].notation)], moving=[computed]))
    recorded = 'one.recorded = [figure.querySelector("input.time")?.max, one.start.state, play(0).state];'
    found = played(pages, recorded + FOLLOWED + DRIVE + TURN)
    figures.append(computed)
    for one, figure in zip(found, figures, strict=True):
        one["names"] = [str(s.label) for s in figure.parameters]
    return dict(zip((*NAMES, SIMULATED), found, strict=True))


def numbers(one, at):
    return dict(zip(one["names"], json.loads(one[at]["parameters"]), strict=True))


def state(one, at):
    return np.array(json.loads(one[at]["state"]))


def test_pages_run_without_an_error(results):
    for name, one in results.items():
        assert one["moves"], name
        assert one["errors"] == [], name
        assert one["redrawn"] == (name not in AT_REST), name


@pytest.mark.parametrize("name", NAMES[:5])
def test_energy_and_constraints_are_kept(results, name):
    one = results[name]
    assert one["run"]["done"] == "true"
    assert float(one["run"]["drift"]) < 1e-8
    assert float(one["run"]["error"]) < 1e-10
    assert float(one["run"]["milliseconds"]) < 4


@pytest.mark.parametrize("name", ["roberval-balance", "bead-on-rotating-hoop", "rod-in-bowl", "slider-crank"])
def test_equilibria_can_be_chosen(results, name):
    rests = results[name]["rests"]
    assert rests
    assert all(float(r["unrest"]) < 1e-7 for r in rests), rests


def test_contact_ends_where_the_textbook_says(results):
    one = results["leaving-a-sphere"]
    assert one["run"]["done"] == "false"
    assert math.cos(state(one, "run")[0]) == pytest.approx(2 / 3, abs=1e-4)  # pushed a little at the top
    assert one["shown"]["R"] == "0" or "·10⁻" in one["shown"]["R"]


def test_a_slider_changes_the_parameter_and_the_motion(results):
    one = results["ex11-ideal-pendulum"]
    before, after = numbers(one, "run"), numbers(one, "turned")
    assert after == {**before, one["names"][1]: 2.5}
    close(one, "turned", pendulum(after), state(one, "run"), 40)


def test_a_slider_of_a_coordinate_moves_the_system(results):
    assert state(results["ex11-ideal-pendulum"], "slid")[0] == pytest.approx(0.26)
    assert results["ex11-ideal-pendulum"]["arrows"] == 1


def test_play_plays(results):
    one = results["ex11-ideal-pendulum"]
    assert one["playing"] == "Pause"
    assert state(one, "later")[-1] == pytest.approx(state(one, "turned")[-1] + 4 * 0.05)  # at most 0.05 s a frame


def test_a_possible_displacement_is_the_one_of_the_derivation(results):
    virtual, possible = (
        np.array(path[1:].split("L")[0].split(), float) for path in results["ex09-moving-surface"]["displaced"]
    )
    along = np.array(moving_figure(reported("ex09-moving-surface", complete=False).solution).data["units"][0])
    (x, y), (u, v) = possible - virtual, along * [1, -1]  # dr = δr + u dt i, and down is positive on the page
    assert x * v == pytest.approx(y * u, abs=0.3)
    assert x * u + y * v > 10


def test_a_simulated_page_goes_through_its_motion(results):
    one = results[SIMULATED]
    rows, start, again = one["recorded"]
    assert int(rows) == 500
    assert start == again == results["ex11-ideal-pendulum"]["start"]["state"]
    followed = np.array(json.loads(one["followed"]))
    assert followed[-1] == pytest.approx(0.4)
    found = solve_ivp(
        pendulum(numbers(one, "start")), (0, followed[-1]), json.loads(start)[:-1], rtol=1e-12, atol=1e-12
    )
    assert followed[:-1] == pytest.approx(found.y[:, -1], abs=1e-7)
    assert float(one["run"]["drift"]) < 1e-7


def test_controls_have_names_and_the_space_bar_plays(results):
    for name, one in results.items():
        assert one["nameless"] == 0, name
        assert one["pressed"] == ([None] * 4 if name in AT_REST else ["Pause", "Play"] * 2), name


# References


def pendulum(p):
    return lambda _, y: [y[1], -p["g"] / p["l"] * math.sin(y[0])]


def close(one, at, rate, start, until, tolerance=1e-6):
    t, end = start[-1], state(one, at)
    assert end[-1] == pytest.approx(until)
    found = solve_ivp(rate, (t, until), start[:-1], "DOP853", rtol=1e-12, atol=1e-12).y[:, -1]
    assert end[:-1] == pytest.approx(found, abs=tolerance)


def test_the_pendulum(results):
    one = results["ex11-ideal-pendulum"]
    p = numbers(one, "run")
    close(one, "run", pendulum(p), state(one, "start"), 20)
    theta, rate, _ = state(one, "run")
    tension = p["m"] * (p["l"] * rate**2 + p["g"] * math.cos(theta))
    assert float(one["shown"]["R"]) == pytest.approx(tension, rel=6e-3)  # three digits are shown


def test_the_double_pendulum(results):
    one = results["ex18-double-pendulum"]
    p = numbers(one, "run")
    m1, m2, l1, l2, g = (p[n] for n in ("m1", "m2", "l1", "l2", "g"))

    def rate(_, y):
        a, b, u, w = y
        s, c = math.sin(a - b), math.cos(a - b)
        matrix = [[(m1 + m2) * l1, m2 * l2 * c], [l1 * c, l2]]
        right = [-m2 * l2 * w * w * s - (m1 + m2) * g * math.sin(a), l1 * u * u * s - g * math.sin(b)]
        return [u, w, *np.linalg.solve(matrix, right)]

    close(one, "run", rate, state(one, "start"), 20, 1e-5)


def test_the_spherical_pendulum_in_cartesian_coordinates(results):
    one = results["spherical-pendulum-by-routh"]
    p = numbers(one, "run")

    def place(y):
        theta, phi, u, w = y[:4]
        s, c = math.sin(theta), math.cos(theta)
        r = np.array([s * math.cos(phi), s * math.sin(phi), -c]) * p["l"]
        v = u * np.array([c * math.cos(phi), c * math.sin(phi), s]) + w * np.array(
            [-s * math.sin(phi), s * math.cos(phi), 0]
        )
        return np.array([*r, *(v * p["l"])])

    def rate(_, y):
        r, v, fall = y[:3], y[3:], np.array([0, 0, -p["g"]])
        return [*v, *(fall - r * (v @ v + fall @ r) / (r @ r))]

    found = solve_ivp(rate, (0, 20), place(state(one, "start")), "DOP853", rtol=1e-12, atol=1e-12).y[:, -1]
    assert place(state(one, "run")) == pytest.approx(found, abs=1e-6)


def axis_and_spin(phi, theta, rates):
    """e3 and ω in space for Euler's angles 313."""
    n1, e3 = np.array([math.cos(phi), math.sin(phi), 0]), axis(phi, theta)
    return e3, rates[0] * np.array([0, 0, 1]) + rates[1] * n1 + rates[2] * e3


def axis(phi, theta):
    return np.array([math.sin(theta) * math.sin(phi), -math.sin(theta) * math.cos(phi), math.cos(theta)])


def test_the_heavy_top_by_eulers_law(results):
    one = results["heavy-top"]
    p = numbers(one, "run")
    across = p["A"] + p["m"] * p["l"] ** 2

    def rate(_, y):
        e, w = y[:3], y[3:]
        turned = np.cross(w, e)
        inertia = across * np.eye(3) + (p["C"] - across) * np.outer(e, e)
        change = (p["C"] - across) * (np.outer(turned, e) + np.outer(e, turned))
        moment = np.cross(p["l"] * e, [0, 0, -p["m"] * p["g"]])
        return [*turned, *np.linalg.solve(inertia, moment - change @ w)]

    phi, theta, _, *rates, _ = state(one, "start")
    begin = np.array(axis_and_spin(phi, theta, rates)).ravel()
    found = solve_ivp(rate, (0, 20), begin, "DOP853", rtol=1e-12, atol=1e-12).y[:, -1]
    phi, theta, _, *rates, _ = state(one, "run")
    assert np.array(axis_and_spin(phi, theta, rates)).ravel() == pytest.approx(found, abs=1e-6)


def test_the_rolling_disc_by_newtons_and_eulers_laws(results):
    one = results["rolling-disc"]
    p = numbers(one, "run")
    up = np.array([0, 0, 1])

    def contact(e):
        """From the centre to the lowest point, and its rate for a given rate of e."""
        steep = up - e[2] * e
        size = np.linalg.norm(steep)

        def change(d):
            s = -d[2] * e - e[2] * d
            return -p["R"] * (s / size - steep * (steep @ s) / size**3)

        return -p["R"] * steep / size, change

    def rate(_, y):
        e, w = y[:3], y[3:6]
        c, change = contact(e)
        d = np.cross(w, e)
        cross = np.array([[0, -c[2], c[1]], [c[2], 0, -c[0]], [-c[1], c[0], 0]])  # c × .
        inertia = p["A"] * np.eye(3) + (p["C"] - p["A"]) * np.outer(e, e)
        bent = (p["C"] - p["A"]) * (np.outer(d, e) + np.outer(e, d)) @ w
        # v = c × ω;  m v' = F − m g k;  I ω' + I' ω = c × F
        matrix = inertia - p["m"] * cross @ cross
        right = cross @ (p["m"] * (np.cross(change(d), w) + p["g"] * up)) - bent
        return [*d, *np.linalg.solve(matrix, right), *np.cross(c, w)[:2]]

    def place(y):
        return np.array([*np.ravel(axis_and_spin(y[2], y[3], y[7:10])), *y[:2]])

    found = solve_ivp(rate, (0, 20), place(state(one, "start")), "DOP853", rtol=1e-12, atol=1e-12).y[:, -1]
    assert place(state(one, "run")) == pytest.approx(found, abs=1e-5)
