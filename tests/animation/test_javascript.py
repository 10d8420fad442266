"""Expressions as JavaScript: only known functions, only names of the program's own."""

import re

import pytest
import sympy as sp

from lagrange.animation.javascript import UnprintableError, function, names_of
from lagrange.animation.moving import moving_figure
from lagrange.core.symbols import Unspecified
from tests.support.shared import reported

x, y = sp.symbols("x y", real=True)
OWN = re.compile(
    r"(?:[yzpu]|x\d+|const|return|own|eq|con|rea|ene|act|fig|sta|ini|sli|cur\d+|tra\d+|eql\d+|e\d*|"
    r"Math|sin|cos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|exp|log|abs|sign|sqrt|pow|PI)$"
)


def test_a_part_that_occurs_twice_is_computed_once():
    written = function("y, p", [sp.sin(x) * y, sp.sin(x) ** 3], names_of("y", [x, y]))
    assert written.startswith("(y, p) => { const x0 = Math.sin(y[0]); return [")
    assert written.count("Math.sin") == 1
    assert "Math.pow(x0, 3)" in written


def test_roots_quotients_and_numbers():
    names = names_of("p", [x, y])
    assert function("p", [x / y, sp.sqrt(y), 1 / sp.sqrt(y + 1)], names) == (
        "(p) => { return [(p[0]/(p[1])), Math.sqrt(p[1]), (1/Math.sqrt((1 + p[1])))]; }"
    )
    assert (
        function("p", [sp.Rational(1, 4), sp.pi, -x], names)
        == "(p) => { return [0.25, 3.141592653589793, ((-1)*p[0])]; }"
    )


@pytest.mark.parametrize(
    "e", [sp.gamma(x), sp.Symbol("alert(1)"), Unspecified.of("f", ("X",), x), sp.Function("fetch")(x), sp.zoo, sp.nan]
)
def test_what_is_not_known_is_refused(e):
    with pytest.raises(UnprintableError):
        function("y", [e], names_of("y", [x]))


@pytest.mark.parametrize("name", ["ex13-moving-surface", "ex18-double-pendulum", "rolling-disc", "roberval-balance"])
def test_no_name_of_a_file_is_in_a_program(name):
    figure = moving_figure(reported(name, complete=False).solution)
    words = set(re.findall(r"[A-Za-z_]\w*", figure.code))
    assert {w for w in words if not OWN.match(w)} == set()
