"""Texts that are no expressions are refused, wherever the mistake is."""

from __future__ import annotations

import pytest
import sympy as sp
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.expression_size import Sizes
from lagrange.core.symbols import t
from lagrange.core.vectors import Vector
from lagrange.expressions.limits import MAX_SIZE
from lagrange.expressions.reader import (
    EquationRead,
    read_equation,
    read_scalar,
    read_vector,
)
from tests.expressions.test_meaning import VECTORS
from tests.expressions.test_reader import MEANINGS
from tests.support.chance import examples
from tests.support.expression_texts import (
    EQUATIONS,
    R,
    c,
    g,
    l,
    lambda_rod,
    m,
    phi,
    refused,
    scope,
    theta,
    theta_1,
    u,
    x,
    x1,
    y,
)

v, w, om, om_1 = (sp.Symbol(n, real=True) for n in ("x'", "y'", "theta'", "theta_1'"))


def symbol(name: str) -> sp.Symbol:
    return sp.Symbol(name, positive=True)


# has another unit vector; otherwise the unit vector, with a note
k, i = symbol("k"), symbol("i")
REFUSED: dict[str, tuple[str, int, str]] = {
    "": ("empty-expression", 1, "write"),
    "   \n": ("empty-expression", 1, "write"),
    "x +": ("ends-early", 4, "complete"),
    "x + * y": ("misplaced-operator", 5, "remove"),
    "* x": ("misplaced-operator", 1, "remove"),
    "x ^": ("ends-early", 4, "complete"),
    "()": ("empty-brackets", 1, "write"),
    "sin()": ("empty-brackets", 4, "write"),
    "sin(x, )": ("empty-brackets", 6, "write"),
    "f(x, )": ("empty-brackets", 4, "write"),
    "[x, ]": ("empty-brackets", 3, "write"),
    "f(, x)": ("misplaced-operator", 3, "comma"),
    "f(x,, y)": ("misplaced-operator", 5, "comma"),
    "sin": ("no-argument", 1, "sin(...)"),
    "m g sin": ("no-argument", 5, "sin(...)"),
    "sin + 1": ("no-argument", 1, "sin(...)"),
    "sin - x": ("no-argument", 1, "sin(-"),
    "sin * x": ("no-argument", 1, "sin(...)"),
    "sin(x": ("not-closed", 4, "add `)`"),
    "[x": ("not-closed", 1, "add `]`"),
    "((x)": ("not-closed", 1, "add `)`"),
    "x)": ("not-opened", 2, "remove"),
    "(x]": ("not-closed", 3, "`)`"),
    "{x}": ("unexpected-character", 1, "parentheses"),
    "(x, y)": ("list-in-parentheses", 3, "[a, b]"),
    "1,5": ("misplaced-operator", 2, "decimal point"),
    "ml": ("unknown-symbol", 1, "m l"),
    "m + mgl": ("unknown-symbol", 5, "m g l"),
    "sintheta": ("unknown-symbol", 1, "sin theta"),
    "thetaa": ("unknown-symbol", 1, "theta"),
    "Theta": ("unknown-symbol", 1, "theta"),
    "xdot": ("unknown-symbol", 1, "x'"),
    "theta_ddot": ("unknown-symbol", 1, "theta''"),
    "dx": ("unknown-symbol", 1, "d(x)"),
    "e^x": ("unknown-symbol", 1, "exp(x)"),
    "q": ("unknown-symbol", 1, "`x`"),
    "E": ("unknown-symbol", 1, "the declared names are"),
    "I": ("unknown-symbol", 1, "did you mean `l`"),
    "arcsin(x)": ("unknown-function", 1, "asin"),
    "ln(x)": ("unknown-function", 1, "log"),
    "tg(x)": ("unknown-function", 1, "tan"),
    "factorial(10**7)": ("unknown-function", 1, "the functions are"),
    "gamma(10**8)": ("unknown-function", 1, "the functions are"),
    "binomial(10**9,5*10**8)": ("unknown-function", 1, "the functions are"),
    "print(m)": ("unknown-function", 1, "the functions are"),
    "m'": ("prime-of-constant", 1, "coordinates:"),
    "2'": ("prime-of-constant", 1, "x'^2"),
    "pi'": ("prime-of-constant", 1, "coordinates:"),
    "x'''": ("too-many-primes", 1, "second"),
    "(x'')'": ("too-many-primes", 1, "second"),
    "diff(x'', t)": ("too-many-primes", 1, "second"),
    "'x": ("misplaced-prime", 1, "x'"),
    "sin'(x)": ("misplaced-prime", 4, "sin(x)'"),
    "f'(x, y)": ("prime-of-function", 1, "diff"),
    "f(x)": ("number-of-arguments", 1, "f(X, Y)"),
    "f": ("no-argument", 1, "f(X, Y)"),
    "atan2(x)": ("number-of-arguments", 1, "atan2(y, x)"),
    "sin(x, y)": ("number-of-arguments", 1, "sin(x)"),
    "dot(i)": ("number-of-arguments", 1, "dot(a, b)"),
    "diff(x)": ("number-of-arguments", 1, "diff(e, x)"),
    "diff(x, 2)": ("not-a-variable", 9, "coordinate"),
    "diff(x, x^2)": ("not-a-variable", 9, "coordinate"),
    "u(x)": ("argument-of-prescribed", 2, "u(t)"),
    "d(m)": ("not-a-differential", 1, "d(x)"),
    "delta(t)": ("not-a-differential", 1, "delta(x)"),
    "x + i": ("vector-for-scalar", 5, "unit vector"),
    "sin(r_P)": ("vector-for-scalar", 5, "dot(r_P, i)"),
    "cross(i, j)": ("vector-for-scalar", 1, "dot"),
    "[x, y]": ("vector-for-scalar", 1, "parentheses"),
    "[m*l](theta'')": ("vector-for-scalar", 1, "parentheses"),
    "r_P^2": ("vector-power", 1, "dot(a, a)"),
    "norm(x)": ("scalar-for-vector", 6, "x*i"),
    "1.2.3": ("bad-number", 4, "numbers"),
    "x.y": ("unexpected-character", 2, "dot"),
    "x⁻": ("bad-exponent", 2, "^2"),
    "sin^-1(x)": ("function-exponent", 5, "asin"),
    "sin^x(x)": ("function-exponent", 5, "sin(x)^n"),
    "2 3": ("missing-operator", 3, "*"),
    "x 2": ("missing-operator", 3, "*2"),
    "x = y": ("unexpected-equation", 3, "one side"),
    "x < 1": ("inequality", 3, "under `constraints`"),
    "x >= 1": ("inequality", 3, "under `constraints`"),
    "x ≤ 1": ("inequality", 3, "under `constraints`"),
    "x != 1": ("inequality", 3, "="),
    "x/0": ("division-by-zero", 3, "0"),
    "x/(1-1)": ("division-by-zero", 4, "0"),
    "x/(y - y)": ("division-by-zero", 4, "0"),
    "0^-1": ("division-by-zero", 1, "positive"),
    "0^0": ("not-finite", 1, "positive"),
    "log(0)": ("not-finite", 1, "argument"),
    "tan(pi/2)": ("not-finite", 1, "argument"),
    "sqrt(-1)": ("not-real", 1, "positive"),
    "sqrt(-m)": ("not-real", 1, "negative"),
    "log(-2)": ("not-real", 1, "positive"),
    "asin(2)": ("not-real", 1, "-1 and 1"),
    "(-1)^x": ("not-real", 1, "integer"),
    "x # pull": ("unexpected-character", 3, "comments"),
    "theta''\x00": ("invisible-character", 8, "delete"),
    "theta''+\u200bg": ("invisible-character", 9, "delete"),
    "x\u202ey": ("invisible-character", 2, "delete"),
    "x\u00ady": ("invisible-character", 2, "delete"),
    "х": ("unexpected-character", 1, "Latin letter `x`"),
    "x₊": ("unexpected-character", 2, "write"),
    "x ± y": ("unexpected-character", 3, "sign"),
    'x"': ("unexpected-character", 2, "apostrophes"),
    "x°": ("unknown-symbol", 2, "30 deg"),
    "∂x": ("unexpected-character", 1, "diff"),
    "__import__('os').system('id')": ("unexpected-character", 1, "letter"),
    "S('__import__(\"os\").getpid()')": ("unexpected-character", 4, "letter"),
    "lambda: 1": ("unexpected-character", 7, "="),
    "print(hello)": ("unknown-function", 1, "the functions are"),
    "[0]*10**10": ("vector-for-scalar", 1, "parentheses"),
    "'a'*10**10": ("misplaced-prime", 1, "x'"),
    "Sum(1,(x,1,10**10)).doit()": ("unexpected-character", 20, "write"),
    "24! * 24!": ("unexpected-character", 3, "factorial"),
}


@pytest.mark.parametrize("text", REFUSED)
def test_refused(text: str) -> None:
    found = refused(text)[0]
    code, column, help_ = REFUSED[text]
    assert found.span is not None
    assert (found.code, found.span.start + 1) == (code, column)
    assert found.span.end <= max(len(text), found.span.start + 1)
    assert help_ in found.help
    assert found.message[0] == "`" or found.message[0].islower() or found.message[0].isdigit()
    assert not found.message.endswith(".")


EQUATIONS_REFUSED: dict[str, tuple[str, int]] = {
    "": ("empty-expression", 1),
    "=": ("empty-side", 1),
    "x =": ("empty-side", 4),
    "= x": ("empty-side", 1),
    "x": ("no-equals-sign", 2),
    "x = y = 0": ("several-equals-signs", 7),
    "x == y == 0": ("several-equals-signs", 8),
    "(x = 0)": ("misplaced-operator", 4),
    "x, y = 0": ("misplaced-operator", 2),
    "x = 0; y = 0": ("unexpected-character", 6),
    "y >= 0": ("inequality", 3),
    "x := 0": ("unexpected-character", 3),
    "x ≈ 0": ("unexpected-character", 3),
    "i = x": ("scalar-for-vector", 5),
    "9**9**9 = 0": ("exponent-too-large", 1),
}


@pytest.mark.parametrize("text", EQUATIONS_REFUSED)
def test_equation_refused(text: str) -> None:
    with pytest.raises(ProblemError) as caught:
        read_equation(Fragment.of(text), scope())
    found = caught.value.diagnostics[0]
    assert found.span is not None
    assert (found.code, found.span.start + 1) == EQUATIONS_REFUSED[text]
    assert found.help


PIECES = [
    *"+-*/^=()[]|,.'\"!#$%&:;<>?@\\_`{}~ 0123456789eExyijkdtπθ̇̈²√½₁−·″’𝑥ｘ\u200b\x00\n", "**", "==", "sin", "cos ", "sqrt", "abs(", "atan2(", "log",
    "exp(", "theta", "x'", "theta''", "(t)", "diff(", "dot(", "cross(", "norm(", "d(", "delta(", "f(", ", X)", "r_P", "u", "m ", "l", "1/2",
    "10^10", "2e3", "^20", "^(1/2)", "pi", "lambda_rod", "i", "j", "e_x", "0", "sign", "tan(pi/2)", "__class__", "lambda", "import",
]  # fmt: skip
NONSENSE = st.one_of(st.text(max_size=40), st.lists(st.sampled_from(PIECES), max_size=25).map("".join))
SENSIBLE = [*MEANINGS, *VECTORS, *EQUATIONS, *REFUSED]


@st.composite
def misspelt(draw: st.DrawFn) -> str:
    """A sensible text with a few pieces cut out, doubled, moved or put in."""
    text = draw(st.sampled_from(SENSIBLE))
    for _ in range(draw(st.integers(1, 4))):
        start = draw(st.integers(0, len(text)))
        end = draw(st.integers(start, min(len(text), start + 6)))
        piece = draw(st.sampled_from(["", *PIECES, text[start:end] * 2, "(" + text + ")", text + "*" + text]))
        text = (text[:start] + piece + text[end:])[:2_000]
    return text


def check_reading(text: str) -> None:
    """A value that is made of what is declared and of moderate size, or errors at places of the text that say what to do."""
    known = scope("k", "e")
    for read in (read_scalar, read_vector, read_equation):
        notes: list[Diagnostic] = []
        shown = "nothing is wrong"
        try:
            value = read(Fragment.of(text), known, notes)
        except ProblemError as error:
            notes.extend(error.diagnostics)
            shown = error.show()
        else:
            sides = [value.lhs, value.rhs] if isinstance(value, EquationRead) else [value]
            for e in (c for s in sides for c in (s.fixed().components if isinstance(s, Vector) else [s])):
                assert not e.has(sp.I, sp.nan, sp.zoo, sp.oo, -sp.oo), text
                assert Sizes().of(e).size <= MAX_SIZE
                assert {s.name.rstrip("'") for s in e.free_symbols} <= NAMES
        assert shown
        for d in notes:
            assert d.span is not None
            assert 0 <= d.span.start <= d.span.end <= max(len(text), d.span.start + 1)
            assert d.help or d.message == "`==` is read as `=`"


NAMES = {s.name for s in (x, y, theta, phi, theta_1, x1, u, m, l, g, R, c, lambda_rod, t)} | {"k", "e"}
NAMES |= {f"{d}({name})" for d in ("d", "delta") for name in NAMES}  # in a form


@given(NONSENSE)
@settings(max_examples=examples(400), deadline=None)
def test_nonsense_is_refused_or_read(text: str) -> None:
    check_reading(text)


@given(misspelt())
@settings(max_examples=examples(400), deadline=None, suppress_health_check=[HealthCheck.too_slow])
def test_misspelt_texts_are_refused_or_read(text: str) -> None:
    check_reading(text)
