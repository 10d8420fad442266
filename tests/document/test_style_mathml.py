"""Mathematics as MathML: fractions, roots and powers are elements, and nothing of a name is markup."""

from __future__ import annotations

from xml.etree import ElementTree

import pytest
import sympy as sp

from lagrange.core.symbols import Unspecified
from lagrange.document.math_writer import Writer
from lagrange.document.style_mathml import MathML, WideMathML, is_tall, row

theta = sp.Symbol("theta", real=True)
m, g, l_0 = sp.symbols("m g l_0", positive=True)


@pytest.mark.parametrize(
    ("expression", "elements"),
    [
        (m / g, {"mfrac"}),
        (sp.sqrt(m + g), {"msqrt"}),
        (m**2, {"msup", "mn"}),
        (l_0, {"msub"}),
        (sp.sin(theta), {"mi"}),
    ],
)
@pytest.mark.parametrize("style", [MathML, WideMathML])
def test_the_elements_of_an_expression(style: type[MathML], expression: sp.Expr, elements: set[str]) -> None:
    tree = ElementTree.fromstring(f"<math>{Writer(style()).plain(expression)}</math>")
    if style is MathML:
        assert elements <= {e.tag for e in tree.iter()}
    assert "".join(tree.itertext()).strip()


def test_a_derivative_of_a_function_of_one_variable_has_primes() -> None:
    slope = Unspecified.of("f", ("u",), theta).partial(0)
    assert "".join(ElementTree.fromstring(f"<math>{Writer(MathML()).plain(slope)}</math>").itertext()) == "f′"


def test_a_fraction_is_tall_and_a_row_is_one_element() -> None:
    assert is_tall(Writer(MathML()).plain(m / g))
    assert not is_tall(Writer(MathML()).plain(m))
    assert len(ElementTree.fromstring(f"<math>{row('<mi>m</mi><mi>g</mi>')}</math>")) == 1
