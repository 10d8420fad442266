"""A page with a figure that moves: nothing from elsewhere, no text of a file as code, a figure for paper."""

import base64
import hashlib
import re

import pytest

import lagrange
from lagrange.animation.moving import moving_figure
from lagrange.explain.report import report
from lagrange.mechanics.dynamics.motion import Method
from lagrange.render import html
from tests.support.problem_texts import read
from tests.support.shared import reported
from tests.support.unpictured import UNPICTURED


def page_of(name):
    r = reported(name, Method.DALEMBERT, complete=False)
    return html.render([(r.derivation, r.notation)], moving=[moving_figure(r.solution)])


@pytest.fixture(scope="module")
def page():
    return page_of("ex11-ideal-pendulum")


def test_the_policy_allows_these_scripts_and_styles_only(page):
    [policy] = re.findall(r'http-equiv="Content-Security-Policy" content="([^"]*)"', page)
    assert policy.startswith("default-src 'none';")
    for tag, rule in (("script", "script-src"), ("style", "style-src")):
        texts = re.findall(rf"<{tag}>(.*?)</{tag}>", page, re.DOTALL)
        hashes = [base64.b64encode(hashlib.sha256(t.encode()).digest()).decode() for t in texts]
        assert len(texts) == 2
        assert re.search(rf"{rule} ([^;]*)", policy)[1].split() == [f"'sha256-{h}'" for h in hashes]
    assert "unsafe" not in policy


def test_nothing_is_fetched_and_the_page_is_small(page):
    assert not re.search(r"<(link|img|iframe|object|embed|base|form)\b", page)
    assert "://" not in page.replace("http://www.w3.org/2000/svg", "")
    assert not re.search(r"\b(fetch|XMLHttpRequest|WebSocket|eval|innerHTML|import)\b", page)
    assert len(page) < 300_000


def test_a_page_without_it_has_no_script():
    r = reported("ex11-ideal-pendulum", Method.DALEMBERT, complete=False)
    static = html.render([(r.derivation, r.notation)])
    assert "<script" not in static
    assert "script-src 'none'" in static
    assert "<svg" in static


def test_paper_has_the_figure_that_stands_still(page):
    assert '<figure class="still">' in page
    assert re.search(r"@media print \{[^}]*\.moving \{ display: none", page)


def test_text_of_a_file_is_never_code_and_ends_no_element():
    evil = "</script><script>alert(1)</script>"
    problem = read(
        f"""title: {evil!r}
parameters: {{m: {{meaning: {evil!r}, unit: kg}}, g: positive}}
coordinates: {{x: {{meaning: {evil!r}}}}}
particles: {{P: {{mass: m, position: x*i}}}}
gravity: g*i
"""
    )
    r = report(problem)
    written = html.render([(r.derivation, r.notation)], moving=[moving_figure(r.solution)])
    assert 'data-moving="0"' in written
    assert "alert(1)" in written
    assert "<script>alert" not in written
    assert all("alert" not in s for s in re.findall(r"<script[^>]*>(.*?)</script>", written, re.DOTALL))


def test_the_energy_of_a_lagrangian_is_not_divided():
    for name, kept in (("relativistic-oscillator", True), ("oscillating-circuit", False)):
        written = page_of(name)
        assert "kinetic energy</dt>" not in written
        assert ("<dt>conserved: energy</dt>" in written) == kept
    assert "<dt>kinetic energy</dt>" in page_of("ex11-ideal-pendulum")


def test_a_lagrangian_without_positions_has_no_empty_picture():
    assert 'class="picture stage empty"' in page_of("oscillating-circuit")
    assert "stage empty" not in page_of("ex11-ideal-pendulum")


def test_the_drawing_stays_where_the_moving_figure_has_fewer_strings(page):
    assert 'figure class="still"' in page  # the pendulum's rod moves: the drawing is for paper
    text, _ = UNPICTURED["a movable pulley"]
    found = report(lagrange.loads(text), complete=False)
    both = html.render([(found.derivation, found.notation)], moving=[moving_figure(found.solution)])
    assert both.index("<figure>") < both.index('figure class="moving"')
    assert 'figure class="still"' not in both
