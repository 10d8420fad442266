"""What a notebook shows: well-formed HTML with the figure, TeX, and nothing of a file's text as markup."""

from __future__ import annotations

import copy
import pickle
import re
from xml.etree import ElementTree

import pytest
import sympy as sp

import lagrange
from lagrange.api.notebook import Equations
from lagrange.api.result import Result
from lagrange.core.vectors import Vector
from tests.support.shared import reported


@pytest.fixture(scope="module")
def pendulum() -> Result:
    return Result(reported("ex11-ideal-pendulum"))


def elements(page: str) -> ElementTree.Element:
    """The output as a tree: HTML that is also XML, except for the empty elements that the pages use."""
    return ElementTree.fromstring(page.replace("<wbr>", "<wbr/>"))


def tags(page: str) -> list[str]:
    return [e.tag for e in elements(page).iter()]


def test_everything_is_shown_with_its_figure(pendulum: Result) -> None:
    for shown in (pendulum, pendulum["angle"], pendulum.own, lagrange.load("ex11")):
        page = shown._repr_html_()
        assert page is not None
        found = tags(page)
        assert "svg" in found
        assert "math" in found
        assert "Ideal pendulum" in page


def test_one_set_of_coordinates_has_its_own_figure(pendulum: Result) -> None:
    angle, own = (
        re.findall("<figcaption>(.*?)</figcaption>", f._repr_html_()) for f in (pendulum["angle"], pendulum.own)
    )
    assert "The system with the coordinate" in angle[0]
    assert "The system in a general position" in own[0]


def test_a_problem_is_shown_without_being_solved() -> None:
    problem = lagrange.loads(
        "title: two\ncoordinates: [x, y]\nparameters: [m, a]\nparticles: {P: {mass: m, position: x*i + y*j}}\n"
        "constraints: {low: y >= a*x^2, skate: x' = a*y'}\nask: {leaves: {quantity: x, when: x = 2*x}}\n"
    )
    page = problem._repr_html_()
    assert page is not None
    assert "The constraints are" in page
    assert 'aria-label="y &gt;= a*x^2"' in page or "≥" in page
    assert "leaves" not in page


def test_a_problem_that_contradicts_itself_is_shown_by_its_heading() -> None:
    problem = lagrange.loads("title: no <such> thing\ncoordinates: [x]\nconstraints: {a: x = 1, b: x = 2}\n")
    page = problem._repr_html_()
    assert page is not None
    assert "no &lt;such&gt; thing" in page


HOSTILE = "<script>alert(1)</script><img src=x onerror=alert(2)> $$\\\\href{javascript:x}{y}$$ </style></svg>"


def test_no_text_of_a_file_is_markup() -> None:
    problem = lagrange.loads(
        f"title: '{HOSTILE}'\nsource: '{HOSTILE}'\ndescription: '{HOSTILE}'\ncoordinates:\n"
        f"  x: {{meaning: '{HOSTILE}', unit: m}}\nparameters: {{m: {{meaning: '{HOSTILE}'}}, g: positive}}\n"
        f"axes: {{i: '{HOSTILE}'}}\n"
        "particles: {P: {mass: m, position: x*i}}\ngravity: g*i\n"
    )
    result = lagrange.solve(problem)
    for page in (problem._repr_html_(), result._repr_html_(), result.own._repr_html_()):
        assert page is not None
        assert not {"script", "img", "iframe", "object"} & set(tags(page))
        assert page.count("<style>") == page.count("</style>") == 1
        attributes = [pair for e in elements(page).iter() for pair in e.attrib.items()]
        assert not [k for k, v in attributes if k.startswith("on") or k == "src" or (k == "href" and v[:1] != "#")]
        assert elements(page).get("class") == "lagsolve tex2jax_ignore mathjax_ignore"


def test_equations_are_tuples_that_show_themselves(pendulum: Result) -> None:
    angle = pendulum["angle"]
    assert angle.equations == tuple(angle.equations)
    assert isinstance(angle.equations[0], sp.Expr)
    assert angle.equations._repr_latex_() == r"$\displaystyle l \ddot{\theta} + g \sin\theta = 0$"
    assert tags(angle.equations._repr_html_() or "").count("math") >= 1
    assert (pendulum.newton._repr_latex_() or "").count(r" &= ") == 2
    assert (pendulum.virtual_displacements._repr_latex_() or "").count(r"\delta") == 2
    assert pendulum["angle"].constraints == ()
    assert pendulum["angle"].constraints._repr_html_() is pendulum["angle"].constraints._repr_latex_() is None


def test_copies_of_equations_keep_their_notation(pendulum: Result) -> None:
    for again in (copy.deepcopy(pendulum.newton), pickle.loads(pickle.dumps(pendulum.newton))):
        assert isinstance(again, Equations)
        assert (again, again._repr_latex_()) == (pendulum.newton, pendulum.newton._repr_latex_())


def test_formulas(pendulum: Result) -> None:
    angle = pendulum["angle"]
    tension = angle.tensions["rod"]
    assert str(angle.formula(tension)) == r"m l \dot{\theta}^{2} + m g \cos\theta"
    assert str(angle.formula(sp.Symbol("T"), 2, tension)).startswith("T = 2 = m l")
    assert str(angle.formula(pendulum.newton[0])) == str(angle.formula(*pendulum.newton[0].args))
    vector = Vector((tension, sp.S.Zero, sp.S.Zero))
    assert r"\mathbf{i}" in angle.formula(vector)._repr_latex_()
    assert "math" in tags(angle.formula(tension)._repr_html_())
    for wrong in ((), ("x",), (None,), (True,), (sp.true,)):
        with pytest.raises(TypeError):
            angle.formula(*wrong)


def test_each_gives_its_forms_in_one_bundle(pendulum: Result) -> None:
    for shown in (pendulum.problem, pendulum, pendulum["angle"], pendulum["angle"].equations):
        bundle = shown._repr_mimebundle_(include={"text/html", "text/plain"})
        assert bundle["text/html"] == shown._repr_html_()
