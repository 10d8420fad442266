"""The notation of letters: vectors, components, arguments of functions."""

import sympy as sp

from lagrange.core.symbols import (
    Sign,
    UnitVector,
    Unspecified,
    differential,
    multiplier,
    prime,
    t,
    variation,
)
from lagrange.core.vectors import Triad, Vector
from lagrange.document.math_writer import TEXT, Notation, Writer, latex, text, unicode
from lagrange.document.names import SymbolKind


def symbols(names):
    return sp.symbols(names, real=True)


x, y, z, r, th, ph = symbols("x y z r theta phi")
x1, x2, th1, th2 = symbols("x_1 x_2 theta_1 theta_2")
m, M, m1, m2, l, l1, l2, g, k, a, b, c = symbols("m M m_1 m_2 l l_1 l_2 g k a b c")
omega, alpha, gamma, mu, F, P = symbols("omega alpha gamma mu F P")
u, s = symbols("u s")
lam, slip = multiplier("rod"), multiplier("no_slip")
sigma = Sign("sigma_1")
i, j, e_r, e_theta = (UnitVector(n) for n in ("i", "j", "e_r", "e_theta"))
sin, cos, tan, sqrt = sp.sin, sp.cos, sp.tan, sp.sqrt
d, delta = differential, variation
f = Unspecified.of("f", ("X", "Y", "Z"), x - u * t, y, z)
N = Notation(coordinates=(x, y, z, r, th, ph, x1, x2, th1, th2), prescribed=(s,), forces=(P,))


def D(symbol, order=1):
    return prime(symbol, order)


def test_vectors_by_components():
    polar = Triad(("e_r", "e_theta", "e_phi"))
    vector = Vector((D(r, 2) - r * D(th) ** 2, -m * g * sin(th), g / l * x), polar)
    assert text(vector, N) == "(r'' - r*theta'^2)*e_r - m*g*sin(theta)*e_theta + g*x*e_phi/l"
    assert unicode(vector, N) == "(r̈ − r θ̇²) e_r − m g sin θ e_θ + (g/l) x e_φ"
    assert latex(vector, N) == (
        r"(\ddot{r} - r \dot{\theta}^{2}) \, \mathbf{e}_{r} - m g \sin\theta \, \mathbf{e}_{\theta}"
        r" + \frac{g}{l} x \, \mathbf{e}_{\phi}"
    )
    assert (text(Vector.zero()), unicode(Vector.zero()), latex(Vector.zero())) == ("0", "0", r"\mathbf{0}")
    assert unicode(Vector((sp.S.Zero, -m * g, sp.S.Zero))) == "−m g j"


def test_a_scalar_called_k_takes_its_name_from_the_unit_vector():
    shadowed = Notation(coordinates=(x, y), scalar_names=frozenset({"k", "m"}))
    vector = Vector((k * x, sp.S.Zero, m * g))
    assert unicode(vector, N) == "k x i + m g k"
    assert text(vector, shadowed) == "k*x*e_x + m*g*e_z"
    assert unicode(vector, shadowed) == "k x e_x + m g e_z"
    assert latex(vector, shadowed) == r"k x \, \mathbf{e}_{x} + m g \, \mathbf{e}_{z}"


def test_an_undefined_function_with_several_lists_of_arguments_shows_them():
    other = Unspecified.of("f", ("X", "Y", "Z"), y, x, z)
    both = f.partial(0) + other.partial(1)
    assert text(both, N) == "diff(f(x - u*t, y, z), X) + diff(f(y, x, z), Y)"
    assert unicode(f.partial(0), Notation(ambiguous=frozenset({"f"}))) == "∂f/∂X(x − u t, y, z)"
    writer = Writer(TEXT, N)
    assert writer.plain(f.partial(0)) == "diff(f, X)"
    assert writer.plain(both).startswith("diff(f(")
    assert writer.plain(f.partial(0)) == "diff(f, X)"


def test_a_long_list_of_arguments_that_the_declaration_has_is_not_repeated():
    names = ("x", "y", "x'", "t")
    force = Unspecified.of("F_x", names, x, y, D(x), t)
    assert unicode(m * D(x, 2) - force, N) == "m ẍ − F_x"
    assert latex(force, N) == "F_{x}"
    assert text(force, N) == "F_x(x, y, x', t)"
    assert unicode(force.partial(2), N) == "∂F_x/∂ẋ"
    elsewhere = Unspecified.of("F_x", names, x, 2 * y, D(x), t)
    assert unicode(elsewhere, N) == "F_x(x, 2y, ẋ, t)"
    assert unicode(force + elsewhere, N) == "F_x(x, 2y, ẋ, t) + F_x(x, y, ẋ, t)"
    short = Unspecified.of("F_x", names[:3], x, y, D(x))
    assert unicode(short, N) == "F_x(x, y, ẋ)"


def test_derivatives_of_a_function_of_one_variable_have_primes():
    shape = Unspecified.of("h", ("u",), x)
    slope = shape.partial(0)
    assert unicode(slope**2 * D(x, 2) + slope.partial(0) * g, N) == "h′² ẍ + g h″"
    assert latex(slope**2, N) == "h'^{2}"
    assert text(slope, N) == "diff(h, u)"
    assert unicode(slope, Notation(ambiguous=frozenset({"h"}))) == "h′(x)"


def test_everything_may_be_left_out_of_the_notation():
    bare = Notation()
    kinds = {
        x: SymbolKind.COORDINATE, D(x): SymbolKind.VELOCITY, D(x, 2): SymbolKind.ACCELERATION, d(x): SymbolKind.DIFFERENTIAL,
        m: SymbolKind.PARAMETER, t: SymbolKind.TIME, lam: SymbolKind.FORCE, sigma: SymbolKind.SIGN, i: SymbolKind.VECTOR,
    }  # fmt: skip
    assert {symbol: bare.kind(symbol) for symbol in kinds} == kinds
    assert unicode(m * g * l * sin(th) + m * l**2 * D(th, 2)) == "m l² θ̈ + m g l sin θ"
