"""Texts of the problem file: symbols and formulas in them are mathematics, words are words."""

from __future__ import annotations

import pytest

from lagrange.document.derivation import Math
from lagrange.document.math_writer import unicode
from lagrange.explain.page.texts import set_text
from tests.support.problem_texts import read
from tests.support.shared import loaded

PROBLEM = read(
    "title: T\ncoordinates: [x, theta, r_1]\nparameters: [m, l, l1, alpha, a, I]\n"
    "particles: {P: {mass: m, position: x*i}}\nconstraints: {c: r_1 = l}\n"
    "functions: {f: [x]}\nspeeds: {w: x'}\n"
)


def written(text: str) -> str:
    """The text with mathematics between ‹ and ›."""
    parts = set_text(text, PROBLEM)
    return "".join(p if isinstance(p, str) else f"‹{'='.join(map(unicode, p.sides))}›" for p in parts if p)  # type: ignore[union-attr]


@pytest.mark.parametrize(
    ("text", "printed"),
    [
        ("the angle alpha between", "the angle ‹α› between"),
        ("a rod of length l, and of mass m.", "a rod of length ‹l›, and of mass ‹m›."),
        ("carried along i, k up", "carried along ‹i›, ‹k› up"),
        ("rods l1 and r_1", "rods ‹l₁› and ‹r₁›"),
        ("its rate theta' is small", "its rate ‹θ̇› is small"),
        ("I take a body; its a is a letter", "I take a body; its a is a letter"),
        ("a distance a ahead, of radius a", "a distance ‹a› ahead, of radius ‹a›"),
        ("the speed w, and f rises", "the speed ‹w›, and ‹f› rises"),
        ("d'Alembert's x-axis, m's", "d'Alembert's ‹x›-axis, m's"),
        ("where `l*sin(theta) = x` holds", "where ‹l sin θ=x› holds"),
        ("$\\sqrt{3} \\sin\\alpha$ times", "‹√3 sin α› times"),
        ("beta is not declared", "beta is not declared"),
        ("$F = 60 N$ and $k = 400 N/m$ at $0.5 s$", "‹F=60 N› and ‹k=400 N/m› at ‹0.5 s›"),
        ("a rod of $2 m$", "a rod of ‹2m›"),  # m is a mass here
        ("with l1 = 0.3 m", "with ‹l₁=3m/10›"),  # nothing says what l1 is
        ("released at x = 0.4 m with $x = 2 m$", "released at ‹x=0.4 m› with ‹x=2 m›"),  # x is a length
        ("shaken as $u = a \\cos \\Omega t$", "shaken as ‹u=a cos Ωt›"),  # letters of the description alone
        ("`sin(` cannot be read, $5 neither", "sin( cannot be read, $5 neither"),
        ("on x = l (r_1^2 + 1/2), smooth", "on ‹x=l (r₁² + 1/2)›, smooth"),
        ("m = 3 kg and l = l1 = 2*a", "‹m=3 kg› and ‹l=l₁=2a›"),
        ("of x^l^l^l^(1/0) or v = m x", "of ‹x›^‹l›^‹l›^‹l›^(1/0) or v = ‹m› ‹x›"),  # no value; v is none either
        ("formal is no m, lm neither", "formal is no ‹m›, lm neither"),
    ],
)
def test_what_is_set(text: str, printed: str) -> None:
    assert written(text) == printed


def test_formulas_are_limited() -> None:
    parts = set_text("`x` " * 1000, PROBLEM)
    assert sum(isinstance(p, Math) for p in parts) == 50


def test_the_unit_vectors_of_the_only_body() -> None:
    parts = set_text("about n1 and e3", loaded("heavy-top"))
    assert [str(p.sides[0]) for p in parts if isinstance(p, Math)] == ["n1", "e3"]


def test_the_origin_is_a_point_in_a_text() -> None:
    assert written("hinged at $O$, `O`") == "hinged at ‹O›, ‹O›"
