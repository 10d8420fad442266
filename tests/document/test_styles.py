"""Functions and relations in the three styles of writing."""

import pytest
import sympy as sp

from lagrange.document.math_writer import LATEX, TEXT, UNICODE, Writer, latex, text, unicode
from lagrange.document.styles import FUNCTIONS, RELATIONS


def symbols(names):
    return sp.symbols(names, real=True)


x, y, z, r, th, ph = symbols("x y z r theta phi")
m, M, m1, m2, l, l1, l2, g, k, a, b, c = symbols("m M m_1 m_2 l l_1 l_2 g k a b c")
u, s = symbols("u s")


@pytest.mark.parametrize("name", FUNCTIONS)
def test_functions(name):
    plain, terminal, command = FUNCTIONS[name]
    function = sp.sign if name == "sign" else getattr(sp, name)
    if name == "exp":
        assert (text(function(x)), unicode(function(x)), latex(function(x))) == (
            "exp(x)",
            "e^x",
            r"\mathrm{e}^{x}",
        )
        return
    arguments = (y, x) if name == "atan2" else (x,)
    expression = function(*arguments)
    listed = ", ".join(s.name for s in arguments)
    bare = name not in ("atan2", "sign")
    assert text(expression) == f"{plain}({listed})"
    assert unicode(expression) == (f"{terminal} x" if bare else f"{terminal}({listed})")
    assert latex(expression) == (f"{command} x" if bare else f"{command}({listed})")


def test_functions_have_their_own_names():
    """The table that this project learned from had sinh for cosh and tanh."""
    for name, (plain, _, command) in FUNCTIONS.items():
        assert plain == name
        assert name.removeprefix("a") in command or name == "log" or name == "sign"


@pytest.mark.parametrize("relation", RELATIONS)
def test_relations(relation):
    plain, terminal, command = RELATIONS[relation]
    for style, sign in ((TEXT, plain), (UNICODE, terminal), (LATEX, command)):
        assert Writer(style).relation((x, y, z), relation) == f"x {sign} y {sign} z"


def test_relations_may_be_given_in_ascii():
    assert Writer(UNICODE).relation((x, sp.S.Zero), "!=") == "x ≠ 0"
