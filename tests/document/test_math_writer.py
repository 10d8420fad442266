"""Mathematics in three styles: every row of every table, the order of writing, and reading back."""

import re

import pytest
import sympy as sp
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from lagrange.core.diagnostics import Fragment
from lagrange.core.symbols import (
    DotProduct,
    Partial,
    Sign,
    Slots,
    TimeDerivative,
    UnitVector,
    Unspecified,
    VectorSymbol,
    Wedge,
    differential,
    multiplier,
    prime,
    t,
    variation,
)
from lagrange.core.vectors import Vector
from lagrange.document.math_writer import Notation, latex, text, unicode
from lagrange.expressions.reader import FunctionDeclaration, Scope, read_scalar, read_vector
from tests.support.chance import examples


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


def mul(*factors):
    return sp.Mul(*factors, evaluate=False)


def add(*terms):
    return sp.Add(*terms, evaluate=False)


# expression: text, Unicode, LaTeX
SPELLED = [
    (sp.S.Zero, "0", "0", "0"),
    (-x, "-x", "−x", "-x"),
    (sp.Rational(-1, 2), "-1/2", "−1/2", r"-\frac{1}{2}"),
    (x / 2, "x/2", "x/2", r"\frac{x}{2}"),
    (m * D(x) ** 2 / 2, "m*x'^2/2", "½ m ẋ²", r"\tfrac{1}{2} m \dot{x}^{2}"),
    (sp.Rational(5, 12) * m * l**2, "5*m*l^2/12", "(5/12) m l²", r"\tfrac{5}{12} m l^{2}"),
    (sp.Rational(7, 8) * m * l, "7*m*l/8", "(7/8) m l", r"\tfrac{7}{8} m l"),
    (2 * x * d(x), "2*x*d(x)", "2x dx", r"2x \, \mathrm{d}x"),
    (D(th, 2) + g / l * sin(th), "theta'' + g*sin(theta)/l", "θ̈ + (g/l) sin θ",
     r"\ddot{\theta} + \frac{g}{l} \sin\theta"),
    (3 * g * sin(th) / (2 * l), "3*g*sin(theta)/(2*l)", "(3g/(2l)) sin θ", r"\frac{3g}{2l} \sin\theta"),
    (-m * g * l * sin(th), "-m*g*l*sin(theta)", "−m g l sin θ", r"-m g l \sin\theta"),
    (a / (b * c), "a/(b*c)", "a/(b c)", r"\frac{a}{b c}"),
    (1 / l, "1/l", "1/l", r"\frac{1}{l}"),
    ((a + b) / c, "(a + b)/c", "(a + b)/c", r"\frac{a + b}{c}"),
    (a / (b + c), "a/(b + c)", "a/(b + c)", r"\frac{a}{b + c}"),
    (x**2 / l**2, "x^2/l^2", "x²/l²", r"\frac{x^{2}}{l^{2}}"),
    (-y * delta(y) / x, "-y*delta(y)/x", "−(y/x) δy", r"-\frac{y}{x} \, \delta y"),
    (m * y * D(x, 2) / x, "m*y*x''/x", "m (y/x) ẍ", r"m \frac{y}{x} \ddot{x}"),
    (3 * m * y * D(x) / (2 * x), "3*m*y*x'/(2*x)", "3m (y/(2x)) ẋ", r"3m \frac{y}{2x} \dot{x}"),
    ((m1 + m2) * y * sin(th) / x, "(m_1 + m_2)*y*sin(theta)/x", "(m₁ + m₂) (y/x) sin θ",
     r"(m_{1} + m_{2}) \frac{y}{x} \sin\theta"),
    (g * t * x * D(y) / y, "g*t*x*y'/y", "g (x/y) t ẏ", r"g \frac{x}{y} t \dot{y}"),
    (sqrt(2) * g * sin(th) / l, "sqrt(2)*g*sin(theta)/l", "(√2 g/l) sin θ",
     r"\frac{\sqrt{2} g}{l} \sin\theta"),
    (b * sin(th) / r, "b*sin(theta)/r", "b sin θ/r", r"\frac{b \sin\theta}{r}"),
    (k * x / m, "k*x/m", "(k/m) x", r"\frac{k}{m} x"),
    (m * g * cos(alpha) / (M + m * sin(alpha) ** 2), "m*g*cos(alpha)/(M + m*sin(alpha)^2)", "m g cos α/(M + m sin²α)",
     r"\frac{m g \cos\alpha}{M + m \sin^{2}\alpha}"),
    (D(x) ** 2, "x'^2", "ẋ²", r"\dot{x}^{2}"),
    (D(th1) ** 2, "theta_1'^2", "θ̇₁²", r"\dot{\theta}_{1}^{2}"),
    (x**a, "x^a", "x^a", "x^{a}"),
    (x ** (a + 1), "x^(a + 1)", "x^(a + 1)", "x^{a + 1}"),
    (x**-a, "1/x^a", "1/x^a", r"\frac{1}{x^{a}}"),
    (x ** sp.Rational(3, 2), "x^(3/2)", "x^(3/2)", "x^{3/2}"),
    ((x + y) ** 3, "(x + y)^3", "(x + y)³", "(x + y)^{3}"),
    (2**a, "2^a", "2^a", "2^{a}"),
    (sqrt(2) * x, "sqrt(2)*x", "√2 x", r"\sqrt{2} x"),
    (sqrt(l**2 - y**2), "sqrt(l^2 - y^2)", "√(l² − y²)", r"\sqrt{l^{2} - y^{2}}"),
    (sqrt(g / l), "sqrt(g/l)", "√(g/l)", r"\sqrt{\frac{g}{l}}"),
    (1 / sqrt(2), "sqrt(2)/2", "√2/2", r"\frac{\sqrt{2}}{2}"),
    (-x * D(x) / sqrt(l**2 - x**2), "-x*x'/sqrt(l^2 - x^2)", "−x ẋ/√(l² − x²)",
     r"-\frac{x \dot{x}}{\sqrt{l^{2} - x^{2}}}"),
    (sp.pi / 2, "pi/2", "π/2", r"\frac{\pi}{2}"),
    (2 * sp.pi * a, "2*pi*a", "2π a", r"2\pi a"),
    (sp.E, "exp(1)", "e", r"\mathrm{e}"),
    (sp.Float("0.25") * x, "0.25*x", "0.25x", "0.25x"),
    (sp.Float("-1.25e-7"), "-1.25e-07", "−1.25·10⁻⁷", r"-1.25 \cdot 10^{-7}"),
    (sp.Float("4.123456789012345678", 20), "4.12346", "4.12346", "4.12346"),
    (sin(2 * th), "sin(2*theta)", "sin 2θ", r"\sin 2\theta"),
    (cos(omega * t), "cos(omega*t)", "cos ωt", r"\cos\omega t"),
    (cos(k * x), "cos(k*x)", "cos(k x)", r"\cos k x"),
    (cos(omega * t + alpha), "cos(omega*t + alpha)", "cos(ω t + α)", r"\cos(\omega t + \alpha)"),
    (sin(th / 2) ** 2, "sin(theta/2)^2", "sin²(θ/2)", r"\sin^{2}\frac{\theta}{2}"),
    (sin(th) ** 2, "sin(theta)^2", "sin²θ", r"\sin^{2}\theta"),
    (sin(x) ** 2, "sin(x)^2", "sin²x", r"\sin^{2} x"),
    (sin(th1 - th2), "sin(theta_1 - theta_2)", "sin(θ₁ − θ₂)", r"\sin(\theta_{1} - \theta_{2})"),
    (1 / sin(th) ** 2, "1/sin(theta)^2", "1/sin²θ", r"\frac{1}{\sin^{2}\theta}"),
    (sin(x**2), "sin(x^2)", "sin(x²)", "\\sin(x^{2})"),
    (sin(cos(x)), "sin(cos(x))", "sin(cos x)", r"\sin(\cos x)"),
    (sp.asin(x) ** 2, "asin(x)^2", "(arcsin x)²", r"(\arcsin x)^{2}"),
    (sp.log(x) ** 2, "log(x)^2", "(ln x)²", r"(\ln x)^{2}"),
    (sp.exp(-gamma * t), "exp(-gamma*t)", "e^(−γ t)", r"\mathrm{e}^{-\gamma t}"),
    (sp.Abs(x), "abs(x)", "|x|", r"\lvert x \rvert"),
    (sp.sign(D(x)), "sign(x')", "sgn(ẋ)", r"\operatorname{sgn}(\dot{x})"),
    (2 * (x + y) ** 2, "2*(x + y)^2", "2 (x + y)²", "2 (x + y)^{2}"),
    (sp.atan2(y, x), "atan2(y, x)", "atan2(y, x)", r"\operatorname{atan2}(y, x)"),
    (sp.Function("G")(x), "G(x)", "G(x)", r"\operatorname{G}(x)"),
    (f, "f(x - u*t, y, z)", "f(x − u t, y, z)", "f(x - u t, y, z)"),
    (f.partial(0), "diff(f, X)", "∂f/∂X", r"\frac{\partial f}{\partial X}"),
    (f.partial(0).partial(1) * D(x), "diff(diff(f, X), Y)*x'", "(∂²f/∂X∂Y) ẋ",
     r"\frac{\partial^{2} f}{\partial X \partial Y} \dot{x}"),
    (f.partial(0).partial(0), "diff(diff(f, X), X)", "∂²f/∂X²", r"\frac{\partial^{2} f}{\partial X^{2}}"),
    (Partial(2 * x, y), "diff(2*x, y)", "∂(2x)/∂y", r"\frac{\partial (2x)}{\partial y}"),
    (Partial(symbols("T"), D(th)), "diff(T, theta')", "∂T/∂θ̇", r"\frac{\partial T}{\partial \dot{\theta}}"),
    (TimeDerivative(symbols("T")), "diff(T, t)", "dT/dt", r"\frac{\mathrm{d}T}{\mathrm{d}t}"),
    (TimeDerivative(Partial(symbols("T"), D(x))), "diff(diff(T, x'), t)", "d/dt (∂T/∂ẋ)",
     r"\frac{\mathrm{d}}{\mathrm{d}t} \frac{\partial T}{\partial \dot{x}}"),
    (TimeDerivative(x + y), "diff(x + y, t)", "d/dt (x + y)", r"\frac{\mathrm{d}}{\mathrm{d}t} (x + y)"),
    (x * Wedge(d(x), d(y)), "x*wedge(d(x), d(y))", "x dx ∧ dy", r"x \, \mathrm{d}x \wedge \mathrm{d}y"),
    (DotProduct(m * VectorSymbol("r_P''") - VectorSymbol("F"), VectorSymbol("delta(r_P)")),
     "dot(m*r_P'' - F, delta(r_P))", "(m r̈_P − F)·δr_P",
     r"(m \ddot{\mathbf{r}}_{P} - \mathbf{F}) \cdot \delta \mathbf{r}_{P}"),
    (2 * x * lam, "2*x*lambda_rod", "2x λ_rod", r"2x \lambda_{\text{rod}}"),
    (slip, "lambda_no_slip", "λ_no_slip", r"\lambda_{\text{no slip}}"),
    (sigma * sqrt(l**2 - y**2), "sigma_1*sqrt(l^2 - y^2)", "σ₁ √(l² − y²)",
     r"\sigma_{1} \sqrt{l^{2} - y^{2}}"),
    (mul(2, 3), "2*3", "2·3", r"2 \cdot 3"),
    (add(sp.Integer(3), sp.Integer(-1)), "3 - 1", "3 − 1", "3 - 1"),
    (add(d(x), mul(0, d(y))), "d(x) + 0*d(y)", "dx + 0·dy", r"\mathrm{d}x + 0 \cdot \mathrm{d}y"),
    (mul(m, -g - D(y, 2)), "-m*(y'' + g)", "−m (ÿ + g)", r"-m (\ddot{y} + g)"),
    (mul(-1, x + y), "-(x + y)", "−(x + y)", "-(x + y)"),
    (c * (x / l - 1), "c*(x/l - 1)", "c (x/l − 1)", r"c \left( \frac{x}{l} - 1 \right)"),
    (l * (a * cos(th1 - th2) + b) * x, "l*x*(b + a*cos(theta_1 - theta_2))",
     "l x [b + a cos(θ₁ − θ₂)]", r"l x [b + a \cos(\theta_{1} - \theta_{2})]"),
    (c * (x + l * (a * cos(th1 - th2) + b)), "c*(x + l*(b + a*cos(theta_1 - theta_2)))",
     "c {x + l [b + a cos(θ₁ − θ₂)]}", r"c \{x + l [b + a \cos(\theta_{1} - \theta_{2})]\}"),
    (sin(mul(2, 2, th)), "sin(2*2*theta)", "sin(2·2 θ)", r"\sin(2 \cdot 2 \theta)"),
    (cos(sp.S.One), "cos(1)", "cos(1)", r"\cos(1)"),
    (sin(th1 * th2), "sin(theta_1*theta_2)", "sin(θ₁ θ₂)", r"\sin(\theta_{1} \theta_{2})"),
    (sin(th * D(x)), "sin(theta*x')", "sin(θ ẋ)", r"\sin(\theta \dot{x})"),
    (sin(omega / l * (l - x)), "sin(omega*(l - x)/l)", "sin((ω/l) (l − x))", r"\sin\left( \frac{\omega}{l} (l - x) \right)"),
    (sin(g * t / l), "sin(g*t/l)", "sin((g/l) t)", r"\sin\frac{g}{l} t"),
    (sin(alpha * th), "sin(alpha*theta)", "sin αθ", r"\sin\alpha \theta"),
    (2 ** sp.Rational(3, 4) * sqrt(x) / 2, "2^(3/4)*sqrt(x)/2", "½·2^(3/4) √x", r"\tfrac{1}{2} \cdot 2^{3/4} \sqrt{x}"),
]  # fmt: skip


@pytest.mark.parametrize(("expression", "plain", "terminal", "tex"), SPELLED, ids=[str(n) for n in range(len(SPELLED))])
def test_spelling_in_three_styles(expression, plain, terminal, tex):
    assert text(expression, N) == plain
    assert unicode(expression, N) == terminal
    assert latex(expression, N) == tex


# As they are written by hand
FACTORS = [
    (m * g * l, "m g l"),
    (m * l**2 * omega, "m l² ω"),
    (mu * m * g, "μ m g"),
    (M * m * a, "M m a"),
    (m2 * m1 * l2 * l1, "m₁ m₂ l₁ l₂"),
    ((m1 + m2) * l1 * D(th1, 2), "(m₁ + m₂) l₁ θ̈₁"),
    ((m1 + m2) * g, "(m₁ + m₂) g"),
    ((a + b) * m, "m (a + b)"),
    (b * omega * sin(omega * t), "b ω sin ωt"),
    (g * t**2 / 2, "½ g t²"),
    (m * r * D(ph) ** 2 * sin(th) * cos(th), "m r φ̇² sin θ cos θ"),
    (2 * r * D(th) * D(ph) * cos(th), "2r θ̇ φ̇ cos θ"),
    (r * D(ph, 2) * sin(th), "r φ̈ sin θ"),
    (r * cos(th) * sin(ph), "r cos θ sin φ"),
    (cos(th1) * sin(th1 - th2), "cos θ₁ sin(θ₁ − θ₂)"),
    (sin(th) * sqrt(l**2 - y**2), "√(l² − y²) sin θ"),
    (m * (D(y, 2) - g) * delta(y), "m (ÿ − g) δy"),
    (x * (D(y, 2) - g), "x (ÿ − g)"),
    ((x2 - x1) * lam, "(x₂ − x₁) λ_rod"),
    ((x2 - x1) * D(x1), "(x₂ − x₁) ẋ₁"),
    (x * (l**2 - y**2) * D(y, 2), "x (l² − y²) ÿ"),
    (r * sin(th) * (D(th, 2) - g), "r sin θ (θ̈ − g)"),
    ((x * d(x) + y * d(y)) * lam, "λ_rod (x dx + y dy)"),
    (lam * cos(th), "λ_rod cos θ"),
    (f.partial(0) * lam, "λ_rod ∂f/∂X"),
    (f.partial(0) * d(x), "∂f/∂X dx"),
    (-u * f.partial(0) * d(t), "−u ∂f/∂X dt"),
    (f.partial(0) * D(x, 2), "(∂f/∂X) ẍ"),
    (f.partial(0) * f.partial(1) * d(x), "(∂f/∂X) (∂f/∂Y) dx"),
    (f.partial(0) ** 2 * d(x), "(∂f/∂X)² dx"),
    (f.partial(1) / f.partial(0) * delta(y), "[(∂f/∂Y)/(∂f/∂X)] δy"),
    (u * f.partial(1) / f.partial(0), "u (∂f/∂Y)/(∂f/∂X)"),
    (Partial(-m * (x - y), t), "∂[−m (x − y)]/∂t"),
    (P * sin(th), "P sin θ"),
    (2 * P * x, "2x P"),
    (m * g * i, "m g i"),
    (r * sin(th) * delta(ph) * UnitVector("e_phi"), "r sin θ δφ e_φ"),
    (-sigma * y / sqrt(l**2 - y**2) * delta(y), "−(σ₁ y/√(l² − y²)) δy"),
    (a ** sp.Rational(1, 3) * b ** sp.Rational(5, 3) * D(x), "a^(1/3) b^(5/3) ẋ"),
    (x ** sp.Rational(1, 3) * D(x), "ẋ x^(1/3)"),
    (l * sqrt(a + b) * D(x), "l √(a + b) ẋ"),
    (k * sqrt(m) * x, "k √m x"),
]

TERMS = [
    (m * g * l * sin(th) + m * l**2 * D(th, 2), "m l² θ̈ + m g l sin θ"),
    (k * x + c * D(x) + m * D(x, 2) - F, "m ẍ + c ẋ + k x − F"),
    (D(r, 2) - r * D(th) ** 2 - r * D(ph) ** 2 * sin(th) ** 2, "r̈ − r θ̇² − r φ̇² sin²θ"),
    (
        r * D(th, 2) + 2 * D(r) * D(th) - r * D(ph) ** 2 * sin(th) * cos(th) - g * sin(th),
        "r θ̈ + 2ṙ θ̇ − r φ̇² sin θ cos θ − g sin θ",
    ),
    (
        2 * r * D(th) * D(ph) * cos(th) + 2 * D(r) * D(ph) * sin(th) + r * D(ph, 2) * sin(th),
        "r φ̈ sin θ + 2ṙ φ̇ sin θ + 2r θ̇ φ̇ cos θ",
    ),
    (r - a - b * cos(omega * t), "r − a − b cos ωt"),
    (a + b * cos(omega * t), "a + b cos ωt"),
    (l * sin(th) + x, "x + l sin θ"),
    (a - l * cos(th), "a − l cos θ"),
    (1 - cos(th), "1 − cos θ"),
    (l2 * sin(th2) + l1 * sin(th1), "l₁ sin θ₁ + l₂ sin θ₂"),
    (x2 - x1, "x₂ − x₁"),
    (l**2 - y**2, "l² − y²"),
    (x**2 + y**2 - l**2, "x² + y² − l²"),
    (y**2 + x * y + x**2, "x² + x y + y²"),
    (x + x * y, "x y + x"),
    (a**2 + b**2 + 2 * a * b, "a² + 2a b + b²"),
    (m + M, "M + m"),
    (2 * k - 1, "2k − 1"),
    (symbols("I_G") + m * l**2, "m l² + I_G"),
    (sin(alpha) + mu * cos(alpha), "sin α + μ cos α"),
    (g * t**2 / 2 + a + b * t, "a + b t + ½ g t²"),
    (m * g + 2 * y * lam, "m g + 2y λ_rod"),
    (D(y, 2) - g, "ÿ − g"),
    (x * D(x, 2) + y * D(y, 2) + D(x) ** 2 + D(y) ** 2, "x ẍ + y ÿ + ẋ² + ẏ²"),
    (y * d(y) + x * d(x), "x dx + y dy"),
    (sin(th) * d(x) - cos(th) * d(y), "sin θ dx − cos θ dy"),
    (x * d(y) - y * d(x), "−y dx + x dy"),
    (b * d(t) + d(r), "dr + b dt"),
    (m * g * sin(th) * e_theta - m * g * cos(th) * e_r, "−m g cos θ e_r + m g sin θ e_θ"),
    (y * j + x * i, "x i + y j"),
    (-x - y, "−x − y"),
    (VectorSymbol("r_Q") - VectorSymbol("r_C"), "r_Q − r_C"),
    (D(s, 2) + D(x, 2), "ẍ + s̈"),
]


# Tables


def test_a_denominator_with_sines_takes_the_constants_above_it():
    W, alpha, beta = sp.symbols("W alpha beta", positive=True)
    assert unicode(W * sp.sin(beta) / sp.sin(alpha + beta)) == "W sin β/sin(α + β)"


def test_a_bracket_with_a_root_stands_in_one_fraction_with_what_follows():
    v, h, alpha = sp.symbols("v h alpha", positive=True)
    bracket = v * sp.sin(alpha) + sp.sqrt(2 * g * h + v**2 * sp.sin(alpha) ** 2)
    written = unicode(v * bracket * sp.cos(alpha) / g)
    assert "{" not in written
    assert written.endswith("] cos α/g")


def test_angles_that_are_numbers_stand_in_degrees():
    ninth = sp.cos(sp.pi / 9)
    assert unicode(2 - 3 * ninth) == "2 − 3 cos 20°"
    assert unicode(ninth**2) == "cos²20°"
    assert text(ninth) == "cos(pi/9)"
    assert unicode(sp.sin(sp.pi / 7)) == "sin(π/7)"


def test_vectors_are_bold():
    assert latex(VectorSymbol("r_P''")) == r"\ddot{\mathbf{r}}_{P}"
    assert latex(VectorSymbol("omega_B")) == r"\boldsymbol{\omega}_{B}"
    assert latex(VectorSymbol("delta(r_P)")) == r"\delta \mathbf{r}_{P}"
    assert latex(UnitVector("e_theta")) == r"\mathbf{e}_{\theta}"


# Reading back

DECLARED = [
    m,
    M,
    m1,
    m2,
    l,
    l1,
    l2,
    g,
    k,
    a,
    b,
    c,
    omega,
    alpha,
    gamma,
    mu,
    F,
    P,
    lam,
    slip,
    sigma,
    u,
    symbols("I_G"),
]
SCOPE = Scope(
    scalars={s.name: s for s in DECLARED},
    slots=Slots(N.coordinates, (s,)),
    functions={"f": FunctionDeclaration("f", ("X", "Y", "Z"), (x - u * t, y, z))},
)
SHOWN_ONLY = (DotProduct, Partial, TimeDerivative, Wedge, UnitVector, VectorSymbol, sp.Float)
READABLE = [
    e
    for e in [e for e, *_ in SPELLED] + [e for e, _ in FACTORS + TERMS]
    if not e.has(*SHOWN_ONLY) and not e.atoms(sp.core.function.AppliedUndef)
]


@pytest.mark.parametrize("expression", READABLE, ids=[text(e, N) for e in READABLE])
def test_text_is_read_back(expression):
    read = read_scalar(Fragment.of(text(expression, N)), SCOPE)
    assert sp.expand(read - expression.doit()) == 0


def test_vectors_are_read_back():
    vector = Vector((k * x, -m * g, (x + y) / l))
    shadowed = Notation(coordinates=N.coordinates, scalar_names=frozenset({"k"}))
    assert read_vector(Fragment.of(text(vector, shadowed)), SCOPE) == vector


LEAVES = [
    x,
    y,
    th,
    th1,
    D(x),
    D(th),
    D(x, 2),
    m,
    l,
    l1,
    g,
    omega,
    t,
    lam,
    sp.S.One,
    sp.Integer(2),
    sp.Rational(3, 4),
]


def combined(inner):
    pairs = st.tuples(inner, inner)
    return st.one_of(
        pairs.map(lambda p: p[0] + p[1]),
        pairs.map(lambda p: p[0] - p[1]),
        pairs.map(lambda p: p[0] * p[1]),
        pairs.map(lambda p: sp.Mul(*p, evaluate=False)),
        pairs.map(lambda p: sp.Add(*p, evaluate=False)),
        inner.map(lambda e: e**2),
        inner.map(lambda e: e if e == 0 else 1 / e),
        inner.map(sp.sin),
        inner.map(lambda e: sp.sqrt(e**2 + 1)),
        inner.map(lambda e: -e),
    )


EXPRESSIONS = st.recursive(st.sampled_from(LEAVES), combined, max_leaves=9)


def number(expression):
    """The value at a generic point, which tells expressions apart."""
    symbols = sorted(expression.free_symbols, key=lambda s: s.name)
    values = {s: sp.Rational(sum(map(ord, s.name)), 97) + sp.Rational(1, 3 + len(s.name)) for s in symbols}
    return sp.N(expression.xreplace(values), 30)


def same(read, expression):
    a, b = number(read), number(expression)
    return a == b or abs(a - b) < sp.Float("1e-15") * (1 + abs(b))


@given(EXPRESSIONS)
@settings(deadline=None, max_examples=examples(60), derandomize=True)
def test_any_expression_is_read_back_from_its_text(expression):
    assume(number(expression.doit()).is_finite)
    assert same(read_scalar(Fragment.of(text(expression, N)), SCOPE), expression)


@given(EXPRESSIONS)
@settings(deadline=None, max_examples=examples(60), derandomize=True)
def test_nothing_is_lost_on_the_terminal(expression):
    """The terminal's spelling is read back too, with its brackets and small fractions spelled out."""
    assume(number(expression.doit()).is_finite)
    shown = unicode(expression, N).translate(str.maketrans("[]{}", "()()"))
    shown = re.sub(r"√(\w+)", r"√(\1)", shown.replace("½", "(1/2)").replace("¼", "(1/4)").replace("¾", "(3/4)"))
    assert same(read_scalar(Fragment.of(shown), SCOPE), expression)


def test_roots_of_a_quotient_are_one_root_by_hand_and_apart_in_text():
    p, q, u = sp.symbols("p q u", positive=True)
    assert unicode(sp.sqrt(p) / sp.sqrt(q)) == "√(p/q)"
    assert unicode(sp.sqrt(p) * sp.sqrt(u - q)) == "√(p (u − q))"
    assert text(sp.sqrt(p) / sp.sqrt(q)) == "sqrt(p)/sqrt(q)"


def test_roots_that_may_both_be_imaginary_stay_apart():
    v, w = sp.symbols("v w", real=True)
    root = sp.Pow(v, sp.S.Half) * sp.Pow(w, sp.S.Half)
    assert unicode(root) == "√v √w"


def test_a_constant_exponential_belongs_to_the_fraction():
    mu, beta, r = sp.symbols("mu beta r", positive=True)
    assert unicode(r * sp.exp(mu * beta) / (sp.exp(mu * beta) - 1)) == "r e^(μ β)/[e^(μ β) − 1]"
    assert unicode(sp.exp(-sum(sp.symbols("a_1:9")))).startswith("exp(−")  # long
    assert unicode(sp.exp(mu), Notation(scalar_names=frozenset({"e"}))) == "exp(μ)"
