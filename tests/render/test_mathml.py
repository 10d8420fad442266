"""Formulas of a web page: well formed, and cut at their signs where they are wide."""

import re
from xml.etree import ElementTree

import pytest
import sympy as sp

from lagrange.core.symbols import differential, prime
from lagrange.document.math_writer import Notation, Writer
from lagrange.render.limits import PHONE_PIECE
from lagrange.render.mathml import MATHML, WIDE_MATHML, Formulas, width
from tests.support.sample_derivations import SAMPLES

x, y, m, theta = sp.symbols("x y m theta", real=True)
ALL = [sample() for sample in SAMPLES]


def mathml(expression, style=MATHML):
    return Writer(style).plain(expression)


@pytest.mark.parametrize(
    ("expression", "written"),
    [
        (prime(theta), '<mover><mi>θ</mi><mo stretchy="false" lspace="0" rspace="0">˙</mo></mover>'),
        (differential(x), '<mi mathvariant="normal">d</mi><mi>x</mi>'),
        (x**2, "<msup><mi>x</mi><mn>2</mn></msup>"),
        (x / y, "<mfrac><mi>x</mi><mi>y</mi></mfrac>"),
        (sp.sqrt(x), "<msqrt><mi>x</mi></msqrt>"),
        (x - y, '<mi>x</mi><mo form="infix">−</mo><mi>y</mi>'),
        (-x, '<mo form="prefix">−</mo><mi>x</mi>'),
        (sp.Symbol("x_1"), "<msub><mi>x</mi><mn>1</mn></msub>"),
        (sp.Symbol("x_1") ** 2, "<msubsup><mi>x</mi><mn>1</mn><mn>2</mn></msubsup>"),
        (sp.Symbol("lambda_rod"), "<msub><mi>λ</mi><mtext>rod</mtext></msub>"),
        (sp.Symbol("a_1t"), "<msub><mi>a</mi><mrow><mn>1</mn><mi>t</mi></mrow></msub>"),
        (2 * x, "<mn>2</mn><mo>\u2062</mo><mi>x</mi>"),
        (sp.pi, '<mi mathvariant="normal">π</mi>'),
        (sp.sin(theta), '<mi>sin</mi><mo>\u2061</mo><mspace width="0.17em"/><mi>θ</mi>'),
        (
            sp.Abs(x),
            '<mrow><mo form="prefix" stretchy="false">|</mo><mi>x</mi><mo form="postfix" stretchy="false">|</mo></mrow>',
        ),
        (sp.Symbol("Omega"), '<mi mathvariant="normal">Ω</mi>'),
        (sp.Symbol("pos"), "<mi>pos</mi>"),
    ],
)
def test_mathml(expression, written):
    assert mathml(expression) == written


def test_brackets_grow_around_fractions_only():
    assert '<mo stretchy="false">(</mo>' in mathml(m * (x + y))
    assert "<mrow><mo>(</mo>" in mathml(m * (x + y / m))


@pytest.mark.parametrize("style", [MATHML, WIDE_MATHML])
@pytest.mark.parametrize(("derivation", "notation"), ALL, ids=lambda v: getattr(v, "title", ""))
def test_every_formula_is_xml_also_where_it_is_cut(derivation, notation, style):
    formulas = Formulas(*(Writer(style, notation) for _ in range(4)))
    count = 0
    for step in derivation.steps:
        for block in step.body:
            for equation in getattr(block, "equations", ()):
                written = formulas.equation(equation.sides, equation.relation, displayed=True)
                ElementTree.fromstring(f"<p>{written.replace('<wbr>', '')}</p>")
                count += 1
    assert count


def test_a_long_sum_is_cut_at_its_signs_and_nothing_is_lost():
    terms = [sp.Symbol(f"a_{n}") * sp.sin(theta) ** n for n in range(2, 12)]
    formulas = Formulas.of(Notation())
    written = formulas.equation((sp.Add(*terms), x), "=")
    assert written.count("<math>") == 11
    whole = re.sub(r"</math><wbr><math>|<math>|</math>|<wbr>", "", written)
    relation = MATHML.relation("=")
    assert whole == Writer(MATHML).plain(sp.Add(*terms)) + relation + "<mi>x</mi>"


def test_a_wide_term_is_cut_inside_its_brackets():
    inner = sp.Add(*(sp.Symbol(f"a_{n}") * sp.sin(theta) ** n for n in range(2, 12)))
    written = Formulas.of(Notation()).equation((m * inner + x * inner.subs(theta, y), sp.S.Zero), "=")
    assert '<span class="term">' in written
    assert max(width(code) for code in re.findall("<math>(.*?)</math>", written)) <= PHONE_PIECE
