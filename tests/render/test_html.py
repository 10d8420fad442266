"""The web page: what it contains, that nothing in it comes from elsewhere, and what a real browser makes of it.

A derivation in a notebook.
"""

from __future__ import annotations

import re
from html.parser import HTMLParser

import pytest
import sympy as sp

from lagrange.document.derivation import (
    CheckMark,
    Derivation,
    Detail,
    Equation,
    Ref,
    Rule,
    Step,
    Table,
    display,
    math,
    prose,
)
from lagrange.document.names import Notation
from lagrange.render import html
from lagrange.render.html import style_sheet
from tests.support.browser import CHROMIUM, measured
from tests.support.paths import PROBLEMS
from tests.support.sample_derivations import SAMPLES, pendulum
from tests.support.shared import reported

x, y, m, theta = sp.symbols("x y m theta", real=True)
ALL = [sample() for sample in SAMPLES]
VOID = {"meta", "wbr"}
EXAMPLES = ("ex04", "ex06", "ex11", "ex15-rough-s", "ex17", "ex18", "rolling-disc", "slider-crank")


class Tree(HTMLParser):
    """Elements in order, and whether each is closed."""

    def __init__(self, page):
        super().__init__()
        self.open, self.ids, self.links, self.tags, self.attributes, self.text = [], [], [], [], [], ""
        self.feed(page)
        assert self.open == []

    def handle_starttag(self, tag, attrs):
        self.tags.append(tag)
        self.attributes += attrs
        self.ids += [v for k, v in attrs if k == "id"]
        self.links += [v for k, v in attrs if k == "href"]
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, _attrs):
        self.tags.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.text += data


def page(*blocks, title="T", source=""):
    return html.render([(Derivation(title, source, (Step(Rule.STATEMENT, "S", blocks),)), Notation())])


def article(*blocks):
    return page(*blocks).split("</h2>\n")[1].split("\n</article>")[0]


@pytest.fixture(scope="module")
def shipped():
    """A page with many of the shipped problems, in full detail."""
    paths = [p for name in EXAMPLES for p in PROBLEMS.glob(f"*/{name}*.yaml")]
    found = [reported(p) for p in paths]
    return html.render([(r.derivation, r.notation) for r in found], Detail.FULL)


@pytest.mark.parametrize(("derivation", "notation"), ALL, ids=lambda v: getattr(v, "title", ""))
@pytest.mark.parametrize("detail", Detail)
def test_a_page_is_well_formed(derivation, notation, detail):
    tree = Tree(html.render([(derivation, notation)], detail))
    assert tree.tags.count("h1") == 1
    assert tree.tags.count("h2") == sum(any(b.detail <= detail for b in s.body) for s in derivation.steps)


def test_shipped_problems_on_one_page(shipped):
    tree = Tree(shipped)
    assert tree.tags.count("article") == len(EXAMPLES)
    assert len(tree.ids) == len(set(tree.ids))
    assert {link.removeprefix("#") for link in tree.links} <= set(tree.ids)
    assert all(link.startswith("#") for link in tree.links)


def test_nothing_comes_from_elsewhere_and_nothing_runs(shipped):
    tree = Tree(shipped)
    assert not {"script", "link", "img", "iframe", "object", "embed", "base", "form"} & set(tree.tags)
    assert not [k for k, _ in tree.attributes if k.startswith("on") or k in ("src", "srcset", "action", "style")]
    assert "url(" not in shipped
    assert "@import" not in shipped
    assert "http" not in shipped.replace("http-equiv", "")


def test_text_of_a_file_stands_for_itself():
    evil = "<script>alert(1)</script>&\x1b\u202e\"'"
    written = page(
        prose(evil), Table((evil, "b"), ((evil, evil),)), CheckMark((evil,), True, evil), title=evil, source=evil
    )
    tree = Tree(written)
    assert "script" not in tree.tags
    assert tree.text.count("<script>alert(1)</script>&\"'") == 9  # title, h1, source, p, header, two cells, check, how
    assert not {"\x1b", "\u202e"} & set(written)
    symbol = sp.Symbol("<b>")
    assert "<b>" not in page(display(Equation((symbol, symbol * x))))


def test_headings_and_language():
    written = html.render([pendulum()])
    assert written.startswith('<!DOCTYPE html>\n<html lang="en">')
    assert "<title>Ideal pendulum</title>" in written
    assert '<meta name="viewport"' in written
    assert re.search(r"<h1>Ideal pendulum</h1>\n<p class=\"source\">Chapter 6, Ex. 11</p>", written)


def test_an_equation_is_numbered_said_and_referred_to():
    written = article(display(Equation((x**2, y), "a")), prose("By ", Ref("a"), "."))
    assert 'role="math" aria-label="x^2 = y"' in written
    assert '<div class="number" id="t-a">(1)</div>' in written
    assert '<p>By <a href="#t-a">(1)</a>.</p>' in written


def test_a_table_has_headers_for_columns_and_rows():
    written = article(Table(("of", math(x), "c", "d"), (("a", math(y), "1", "2"),)))
    assert written.count('<th scope="col">') == 4
    assert '<th scope="row">a</th>' in written
    assert "<td><math><mi>y</mi></math></td><td>1</td><td>2</td>" in written


def test_a_check_says_in_words_whether_it_held():
    written = article(CheckMark(("a",), True, "h"), CheckMark(("b",), False, ""), CheckMark(("c",), None, ""))
    assert re.findall(r'unseen">([^<]*)<', written) == ["held: ", "did not hold: ", "undecided: "]
    assert '<span class="how">h</span>' in written


def test_what_closes_a_phrase_stays_with_the_formula():
    assert '<span class="together"><math><mi>x</mi></math>),</span> b' in article(prose("(a ", math(x), "), b"))


def test_what_opens_a_phrase_stays_with_the_formula():
    assert 'a <span class="together">(<math><mi>x</mi></math>),</span> b' in article(prose("a (", math(x), "), b"))


def test_pages_of_the_same_title_have_ids_of_their_own():
    derivation, notation = pendulum()
    tree = Tree(html.render([(derivation, notation)] * 2))
    assert len(tree.ids) == len(set(tree.ids))


@pytest.mark.skipif(CHROMIUM is None, reason="there is no browser")
@pytest.mark.parametrize("pixels", [360, 1280])
def test_a_browser_draws_everything_and_nothing_is_cut_off(shipped, pixels):
    found = measured(shipped, pixels)
    assert abs(found["width"] - pixels) < 30
    assert found["drawn"] > 1000
    assert found["faults"] == []


# Notebook


def test_the_style_sheet_reaches_nothing_outside() -> None:
    rules = re.sub(r"@media[^{]*\{", "", style_sheet())
    selectors = [s.strip() for rule in re.findall(r"([^{}]+)\{", rules) for s in rule.split(",")]
    assert len(selectors) > 60
    assert [s for s in selectors if ".lagsolve" not in s] == []
    assert style_sheet().count("{") == style_sheet().count("}")
    assert len(re.findall(r"[^{}]+\{", html.CSS)) < len(re.findall(r"[^{}]+\{", style_sheet()))
