r"""LaTeX, as the contract defines it: what it means, where it is refused, and with which message.

What a row means is given in the plain language, which has tables of its own; a few are built by hand beside it. A refusal
has a code and a column.
"""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.expressions.latex_layout import piece
from lagrange.expressions.reader import EquationRead, Scope, read_equation, read_value
from tests.support.expression_texts import same, scope

SCOPE = scope(
    "k", "omega", "omega_0", "I", "alpha", "L", "M", "m_12", "b2", "theta_1_B", "F_C", "ab", "a", "b", "ba", "rho"
)


def latex(text: str) -> Fragment:
    return piece(Fragment.of(text), 0, len(text))


def value(text: str, known: Scope = SCOPE, notes: list[Diagnostic] | None = None) -> object:
    return read_value(latex(text), known, notes, latex=True)


def means(text: str, plain: str, known: Scope = SCOPE) -> bool:
    return same(value(text, known), read_value(Fragment.of(plain), known))  # type: ignore[arg-type]


MEANINGS = {
    # dots and primes
    r"\dot{x}": "x'",
    r"\dot x": "x'",
    r"\ddot{\theta}": "theta''",
    r"\ddot\theta": "theta''",
    r"\ddot{\theta}_1": "theta_1''",
    r"\ddot\theta_1": "theta_1''",
    r"\ddot{\theta}_{1}": "theta_1''",
    r"\ddot{\theta_1}": "theta_1''",
    r"\ddot{\theta_{1}}": "theta_1''",
    r"\ddot{{\theta}}": "theta''",
    r"\dot x^2": "(x')^2",
    r"\dot{x}^{2}": "(x')^2",
    r"\dot x_1": "x1'",
    r"\dot{x}_1^2": "(x1')^2",
    r"\dot{x}^2_1": "(x1')^2",
    r"\dot{\varphi}^{2}\sin\theta\cos\theta": "phi'^2*sin(theta)*cos(theta)",
    r"\theta'": "theta'",
    r"\theta''": "theta''",
    r"\theta''_1": "theta_1''",
    r"\theta_1''": "theta_1''",
    r"\theta_{1}'": "theta_1'",
    r"\theta^{\prime}": "theta'",
    r"\theta^\prime": "theta'",
    r"\theta^{\prime\prime}": "theta''",
    r"\theta^{''}": "theta''",
    r"\theta'^2": "theta'^2",
    r"x''": "x''",
    r"(x^2\dot\phi)'": "(x^2*phi')'",
    r"\left(x^2\dot\phi\right)'": "(x^2*phi')'",
    r"\dot{x y}": "(x*y)'",
    r"\dot{\left(x^2\right)}": "(x^2)'",
    r"\dot{(x + y)}": "(x + y)'",
    r"\dot{\theta}(t)": "theta'",
    r"\theta(t)": "theta",
    r"\theta\left(t\right)": "theta",
    r"\ddot{\theta}(t)": "theta''",
    r"\theta''(t)": "theta''",
    r"\dot u": "u'",
    r"u(t)": "u",
    r"\dot{\vartheta}": "theta'",
    r"\dot{\mathrm{x}}": "x'",
    "θ̈": "theta''",
    "ẍ": "x''",
    "θ′": "theta'",
    "θ″": "theta''",
    "θ₁": "theta_1",
    "x²": "x^2",
    "ẋ²": "x'^2",
    "mẍ": "m*x''",
    "½m": "m/2",
    "√2": "sqrt(2)",
    "l·x": "l*x",
    "l×x": "l*x",
    "x − y": "x - y",
    # total derivatives
    r"\frac{d\theta}{dt}": "theta'",
    r"\frac{d \theta}{d t}": "theta'",
    r"\frac{d^2\theta}{dt^2}": "theta''",
    r"\frac{d^{2}\theta}{dt^{2}}": "theta''",
    r"\frac{d^{2} \theta}{d t^{2}}": "theta''",
    r"\frac{\mathrm{d}\theta}{\mathrm{d}t}": "theta'",
    r"\frac{\mathrm{d}^{2}\theta}{\mathrm{d}t^{2}}": "theta''",
    r"\frac{\mathrm d}{\mathrm dt}x": "x'",
    r"\frac{\mathrm d x}{\mathrm d t}": "x'",
    r"\frac{\text{d}x}{\text{d}t}": "x'",
    r"\dfrac{d\theta_1}{dt}": "theta_1'",
    r"\tfrac{d x_1}{dt}": "x1'",
    r"\frac{d\dot\theta}{dt}": "theta''",
    r"\frac{d}{dt}\left(m l^2\dot\theta\right)": "m*l^2*theta''",
    r"\frac{d}{dt}(m x \dot{x})": "m*(x'^2 + x*x'')",
    r"\frac{d}{dt}[m x]": "m*x'",
    r"\frac{d}{dt}\bigl( m x \bigr)": "m*x'",
    r"\frac{d}{dt}\{m x\}": "m*x'",
    r"\frac{d}{dt}\frac{x^2}{2}": "x*x'",
    r"\frac{d}{dt} m x \dot x": "m*(x'^2 + x*x'')",
    r"\frac{d}{dt} m x + y": "m*x' + y",
    r"\frac{d}{dt}(x) y": "x'*y",
    r"\frac{d}{dt}(x)^2": "(x^2)'",
    r"\frac{d^2}{dt^2}(x^2)": "(x^2)''",
    r"\frac{d^2}{dt^2} x": "x''",
    r"\frac{d}{dt}\sin\theta": "cos(theta)*theta'",
    r"\frac{d(x\dot x)}{dt}": "(x*x')'",
    r"\frac{d\left(x^2\right)}{dt}": "(x^2)'",
    r"\frac{dm}{dt}": "diff(m, t)",
    r"\frac{d\theta}{dt}^2": "theta'^2",
    r"\left(\frac{d\theta}{dt}\right)^2": "theta'^2",
    r"m\frac{d^2 x}{dt^2}": "m*x''",
    r"\frac{d^2 x}{dt^2}\frac{g}{l}": "x''*g/l",
    # partial derivatives and differentials
    r"\frac{\partial}{\partial x}(x^2 y)": "diff(x^2*y, x)",
    r"\frac{\partial (x^2 y)}{\partial y}": "diff(x^2*y, y)",
    r"\frac{\partial^2}{\partial x \partial y}(x^2 y^2)": "diff(diff(x^2*y^2, x), y)",
    r"\frac{\partial^2 (x^3)}{\partial x^2}": "6*x",
    r"\frac{\partial^{2} (x^3)}{\partial x^{2}}": "6*x",
    r"\frac{\partial}{\partial \dot x}(\dot x^2)": "2*x'",
    r"\frac{\partial f}{\partial X}(x, y)": "diff(f(x, y), X)",
    r"\frac{\partial f(x, y)}{\partial X}": "diff(f(x, y), X)",
    r"\partial f(x, y) / \partial X": "diff(f(x, y), X)",
    r"\mathrm{d}x": "d(x)",
    r"\mathrm{d} \theta": "d(theta)",
    r"\mathrm d x": "d(x)",
    r"x \, \mathrm{d}x": "x*d(x)",
    r"d(x)": "d(x)",
    r"\delta x": "delta(x)",
    r"\delta\theta": "delta(theta)",
    r"\delta(x)": "delta(x)",
    r"l\cos\theta\,\delta\theta": "l*cos(theta)*delta(theta)",
    # fractions and roots
    r"\frac{g}{l}": "g/l",
    r"\frac gl": "g/l",
    r"\frac g l": "g/l",
    r"\frac12": "1/2",
    r"\frac1l": "1/l",
    r"\frac1{2l}": "1/(2*l)",
    r"\frac{1}2": "1/2",
    r"\tfrac{g}{l}": "g/l",
    r"\dfrac{g}{l}": "g/l",
    r"\cfrac{g}{l}": "g/l",
    r"\frac\theta2": "theta/2",
    r"\frac{x + y}{x - y}": "(x + y)/(x - y)",
    r"\frac{g}{l}^2": "(g/l)^2",
    r"m\frac{g}{l}x": "m*(g/l)*x",
    r"x/\frac{g}{l}": "x/(g/l)",
    r"\frac{\frac{x}{y}}{\frac{g}{l}}": "(x/y)/(g/l)",
    r"-\frac{g}{l}": "-g/l",
    r"\frac{-g}{l}": "-g/l",
    r"f(x, y)\frac{g}{l}": "f(x, y)*g/l",
    r"\sqrt{x}": "sqrt(x)",
    r"\sqrt x": "sqrt(x)",
    r"\sqrt2": "sqrt(2)",
    r"\sqrt{x^2 + y^2}": "sqrt(x^2 + y^2)",
    r"\sqrt[3]{m}": "m^(1/3)",
    r"\sqrt[ 4 ]{m}^2": "sqrt(m)",
    r"\sqrt{2} l": "sqrt(2)*l",
    r"\sqrt{\frac gl}": "sqrt(g/l)",
    r"2\sqrt{l}^3": "2*sqrt(l)^3",
    # functions
    r"\sin\theta": "sin(theta)",
    r"\sin \theta": "sin(theta)",
    r"\sin{\theta}": "sin(theta)",
    r"\sin(\theta)": "sin(theta)",
    r"\sin\left(\theta\right)": "sin(theta)",
    r"\sin\left(\theta(t)\right)": "sin(theta)",
    r"\sin\theta(t)": "sin(theta)",
    r"\sin[\theta]": "sin(theta)",
    r"\sin\{\theta\}": "sin(theta)",
    r"\sin\bigl(\theta\bigr)": "sin(theta)",
    r"\sin^2\theta": "sin(theta)^2",
    r"\sin^{2}\theta": "sin(theta)^2",
    r"\sin^{2}{\theta}": "sin(theta)^2",
    r"\sin^2(\theta)": "sin(theta)^2",
    r"\sin^2 2\theta": "sin(2*theta)^2",
    r"(\sin\theta)^2": "sin(theta)^2",
    r"\sin(\theta)^2": "sin(theta)^2",
    r"\sin{\theta}^2": "sin(theta)^2",
    r"\sin\theta^2": "sin(theta^2)",
    r"\sin 2\theta": "sin(2*theta)",
    r"\sin2\theta": "sin(2*theta)",
    r"\sin{2\theta}": "sin(2*theta)",
    r"\sin{2}\theta": "sin(2*theta)",
    r"\sin(2\theta)": "sin(2*theta)",
    r"\sin 2(\theta + \phi)": "sin(2*(theta + phi))",
    r"\sin\theta\cos\theta": "sin(theta)*cos(theta)",
    r"\sin 2\theta\cos\theta": "sin(2*theta)*cos(theta)",
    r"\sin\cos\theta": "sin(cos(theta))",
    r"\sin\theta\,\dot\phi": "sin(theta)*phi'",
    r"\sin\theta\dot\phi": "sin(theta)*phi'",
    r"\sin\theta\,\dot\theta^2": "sin(theta)*theta'^2",
    r"\sin\theta \ddot{x}": "sin(theta)*x''",
    r"\sin\theta\,x": "sin(theta)*x",
    r"\sin\theta x": "sin(theta)*x",
    r"\sin\theta\cdot x": "sin(theta)*x",
    r"\sin\theta\times x": "sin(theta)*x",
    r"\sin\theta/2": "sin(theta)/2",
    r"\sin\theta + x": "sin(theta) + x",
    r"\sin\theta - x": "sin(theta) - x",
    r"\sin\theta(x + y)": "sin(theta)*(x + y)",
    r"\sin\frac{\theta}{2}": "sin(theta/2)",
    r"\sin\frac{\theta}{2}\cos\frac{\theta}{2}": "sin(theta/2)*cos(theta/2)",
    r"\sin\tfrac12\theta": "sin(theta/2)",
    r"\sin\frac\theta2": "sin(theta/2)",
    r"\sin\theta\frac{g}{l}": "sin(theta)*g/l",
    r"\sin\omega t": "sin(omega*t)",
    r"\sin\omega\,t": "sin(omega*t)",
    r"\sin\omega_0 t": "sin(omega_0*t)",
    r"\sin\omega t \cos\theta": "sin(omega*t)*cos(theta)",
    r"\sin k x": "sin(k*x)",
    r"\sin kx": "sin(k*x)",
    r"\sin\alpha\,x": "sin(alpha)*x",
    r"\sin\alpha\dot x": "sin(alpha)*x'",
    r"\sin 2\dot\theta": "sin(2*theta')",
    r"\sin\dot\theta": "sin(theta')",
    r"\sin\sqrt{x}": "sin(sqrt(x))",
    r"\sin\theta\sqrt{x}": "sin(theta)*sqrt(x)",
    r"\sin x\sin y": "sin(x)*sin(y)",
    r"m g\sin\alpha": "m*g*sin(alpha)",
    r"\sin\theta_1\cos\theta_1": "sin(theta_1)*cos(theta_1)",
    r"\sin(\theta_1 - \theta)": "sin(theta_1 - theta)",
    r"\operatorname{atan2}(y, x)": "atan2(y, x)",
    r"\operatorname{sgn}(x)": "sign(x)",
    r"\operatorname{sgn}x": "sign(x)",
    r"\operatorname{arcsin}x": "asin(x)",
    r"\operatorname*{sin}x": "sin(x)",
    r"\mathrm{sin}\,\theta": "sin(theta)",
    r"\mathrm{sgn}(x)": "sign(x)",
    r"sin\theta": "sin(theta)",
    r"mg sin(\theta)": "m*g*sin(theta)",
    r"mgsin\theta": "m*g*sin(theta)",
    r"\cos^{-2}\theta": None,
    r"\ln x": "log(x)",
    r"\log x": "log(x)",
    r"\exp(-k t)": "exp(-k*t)",
    r"\mathrm{e}^{-k t}": "exp(-k*t)",
    r"\sin m \mathrm{e}^{-k t}": "sin(m)*exp(-k*t)",
    r"m \sin\omega e^{-k t}": "m*sin(omega)*exp(-k*t)",
    r"\cos m \mathrm{d}x": "cos(m)*d(x)",
    r"e^{-kt}": "exp(-k*t)",
    r"e^x": "exp(x)",
    r"m\,e^{x}y": "m*exp(x)*y",
    r"\mathrm{e}": "exp(1)",
    r"|x|": "abs(x)",
    r"\left|x\right|": "abs(x)",
    r"\lvert x \rvert": "abs(x)",
    r"\left\lvert x \right\rvert": "abs(x)",
    r"\bigl| x \bigr|": "abs(x)",
    r"\vert x\vert": "abs(x)",
    r"\abs{x}": "abs(x)",
    r"\left|\frac{x}{2}\right|": "abs(x)/2",
    r"f(x, y)": "f(x, y)",
    r"f\left(x, \frac y2\right)": "f(x, y/2)",
    # names
    r"m g R": "m*g*R",
    r"mgR": "m*g*R",
    r"mgl\sin\theta": "m*g*l*sin(theta)",
    r"ml^2": "m*l^2",
    r"ml^2\theta''": "m*l^2*theta''",
    r"2mgl": "2*m*g*l",
    r"m_{12}": "m_12",
    r"b_{2}": "b2",
    r"b_2": "b2",
    r"b2": "b2",
    r"x_1": "x1",
    r"x1": "x1",
    r"x_{1}": "x1",
    r"mx_1": "m*x1",
    r"m\ddot x_1": "m*x1''",
    r"\theta_1": "theta_1",
    r"\theta_{1}": "theta_1",
    r"\theta _ { 1 }": "theta_1",
    r"\theta_{1,B}": "theta_1_B",
    r"\theta_{1B}": None,
    r"\theta_{1, \mathrm{B}}": "theta_1_B",
    r"F_C": "F_C",
    r"F_{C}": "F_C",
    r"F_{\mathrm{C}}": "F_C",
    r"F_\text{C}": "F_C",
    r"\omega_0^2": "omega_0^2",
    r"\omega^2_0": "omega_0^2",
    r"\omega^{2}_{0}": "omega_0^2",
    r"\lambda_{rod}": "lambda_rod",
    r"\lambda_{\text{rod}}": "lambda_rod",
    r"\lambda_{\mathrm{rod}}": "lambda_rod",
    r"\lambda_\mathrm{rod}": "lambda_rod",
    r"lambda_rod \cdot x": "lambda_rod*x",
    r"theta_1 + \theta": "theta_1 + theta",
    r"\varphi": "phi",
    r"\vartheta": "theta",
    r"\dot\varphi": "phi'",
    r"\mathit{ab}": "ab",
    r"\mathrm{ab}": "ab",
    r"\text{ab}": "ab",
    r"ab": "ab",
    r"mab": "m*ab",
    r"\mathrm{mg}": "m*g",
    r"\pi x": "pi*x",
    r"2\pi": "2*pi",
    r"θ + φ": "theta + phi",
    r"\boldsymbol{r}_P": "r_P",
    r"\mathbf{r}_{P}": "r_P",
    r"\mathbf{r}_{\mathrm{P}}": "r_P",
    r"\vec{r}_P": "r_P",
    r"\vec r_P": "r_P",
    r"\bm{r}_P": "r_P",
    r"\mathbf{r_P}": "r_P",
    r"\ddot{\mathbf{r}}_P": "r_P''",
    r"\dot{\vec{r}}_{P}": "r_P'",
    r"\vec{\dot r}_P": "r_P'",
    r"x\,\mathbf{i} + y\,\mathbf{j}": "x*i + y*j",
    r"x\hat{i} + y\hat\jmath": "x*i + y*j",
    r"x\hat{x} + y\hat{y}": "x*e_x + y*e_y",
    r"x\mathbf{e}_x": "x*e_x",
    r"x\hat{\mathbf{e}}_{x}": "x*e_x",
    r"x\vec{e}_x": "x*e_x",
    r"x\hat{k}": "x*e_z",
    r"\mathbf{n}": "n",
    r"\mathbf{r}_P \cdot \mathbf{n}": "dot(r_P, n)",
    r"2\mathbf{r}_P \cdot m\mathbf{n}": "2*m*dot(r_P, n)",
    r"(\mathbf{r}_P - x\mathbf{n}) \cdot \delta\mathbf{r}_P": "dot(r_P - x*n, delta(r_P))",
    r"\mathbf{r}_P \cdot \mathbf{n} + x": "dot(r_P, n) + x",
    r"m \cdot \mathbf{n}": "m*n",
    r"\mathbf{r}_P \times \mathbf{n}": "cross(r_P, n)",
    r"(\mathbf{r}_P \times \mathbf{n}) \cdot \mathbf{k}": "dot(cross(r_P, n), e_z)",
    r"\lVert\mathbf{r}_P\rVert": "norm(r_P)",
    r"\left\|\mathbf{r}_P\right\|": "norm(r_P)",
    r"\|\mathbf{r}_P\| x": "norm(r_P)*x",
    r"|\mathbf{r}_P|": "norm(r_P)",
    r"[x, y]": "[x, y]",
    r"\left[x, y, 0\right]": "[x, y, 0]",
    # brackets
    r"(x + y)": "x + y",
    r"[x + y] m": "(x + y)*m",
    r"\{x + y\} m": "(x + y)*m",
    r"m[x - (y - [x + 1])]": "m*(x - (y - (x + 1)))",
    r"\left\{x + \left[y - \left(x\right)\right]\right\}": "y",
    r"\left\lbrace x \right\rbrace": "x",
    r"\Bigl[x\Bigr]\biggl(y\biggr)\Biggl\{x\Biggr\}\big(y\big)": "x^2*y^2",
    r"\left ( x \right )": "x",
    r"{x + y} m": "(x + y)*m",
    r"{x}{y}": "x*y",
    r"x{}y": "x*y",
    r"m(x + y)^2": "m*(x + y)^2",
    r"\left(x + y\right)^{2}": "(x + y)^2",
    r"{x}^2": "x^2",
    r"x{t}": "x*t",
    # powers, numbers, operators
    r"x^2": "x^2",
    r"x^{2}": "x^2",
    r"x^2y": "x^2*y",
    r"x^{-1}": "1/x",
    r"m^{1/2}": "sqrt(m)",
    r"m^{\frac12}": "sqrt(m)",
    r"x^{2} y^{2}": "x^2*y^2",
    r"2^3": "8",
    r"l^k": "l^k",
    r"l^{2k}": "l^(2*k)",
    r"0.5 x": "x/2",
    r".5 x": "x/2",
    r"9{,}81": "9.81",
    r"2e3": "2000",
    r"2\cdot 10^{-3}": "2*10^(-3)",
    r"2\times3": "6",
    r"x\cdot y": "x*y",
    r"x\times y": "x*y",
    r"x\ast y * x": "x^2*y",
    r"x\div y": "x/y",
    r"x/y": "x/y",
    r"1/2 m": "m/2",
    r"-x": "-x",
    r"x - -y": "x + y",
    r"+x": "x",
    r"\boxed{x} + y": "x + y",
    r"\displaystyle\frac{x}{y}": "x/y",
    "x % a comment {\n + y": "x + y",
    "x %\n^2": None,
    r"x\label{eq:a b}": "x",
    r"x \nonumber": "x",
    r"x \tag{3}": "x",
    r"& x &": "x",
    r"x \\ + y": "x + y",
    r"x \\[2pt] + y": "x + y",
    r"$x$": "x",
    r"$$x$$": "x",
    r"\(x\)": "x",
}  # fmt: skip
REFUSED_ROWS = {text for text, plain in MEANINGS.items() if plain is None}


@pytest.mark.parametrize("text", sorted(MEANINGS.keys() - REFUSED_ROWS))
def test_meanings(text: str) -> None:
    plain = MEANINGS[text]
    assert plain is not None
    assert means(text, plain)


x, theta, phi = (sp.Symbol(n, real=True) for n in ("x", "theta", "phi"))
xd, thetad, phid = (sp.Symbol(n, real=True) for n in ("x'", "theta'", "phi'"))
thetadd = sp.Symbol("theta''", real=True)
m, l, g = (sp.Symbol(n, positive=True) for n in ("m", "l", "g"))
BY_HAND = {
    r"\ddot{\theta}+\frac{g}{l}\sin\theta": thetadd + g / l * sp.sin(theta),
    r"\ddot\theta + \frac gl \sin(\theta)": thetadd + g / l * sp.sin(theta),
    r"ml\ddot{\theta}+mg\sin{\theta}": m * l * thetadd + m * g * sp.sin(theta),
    r"\frac{d}{dt}\left(ml^2\sin^2\theta\,\dot\phi\right)": m * l**2 * (
        sp.sin(theta) ** 2 * sp.Symbol("phi''", real=True) + 2 * sp.sin(theta) * sp.cos(theta) * thetad * phid
    ),
    r"\dot x^2": xd**2,
    r"\sin 2\theta\cos^2\phi": sp.sin(2 * theta) * sp.cos(phi) ** 2,
}  # fmt: skip


@pytest.mark.parametrize("text", BY_HAND)
def test_by_hand(text: str) -> None:
    assert sp.expand(value(text) - BY_HAND[text]) == 0  # type: ignore[operator]


# -- refusals --------------------------------------------------------------------------------------------------------

REFUSED = {
    r"\foo x": ("unknown-command", 1, "nothing is expanded"),
    r"x + \thet": ("unknown-command", 5, r"\theta"),
    r"\cosx": ("unknown-command", 1, r"\cos x"),
    r"m\omegat": ("unknown-command", 2, r"\omega t"),
    r"\Dot{x}": ("unknown-command", 1, r"\dot"),
    r"\Sin x": ("unknown-command", 1, r"\sin"),
    r"\newcommand{\a}{b}": ("unknown-command", 1, "nothing is expanded"),
    r"\def\a{x}": ("unknown-command", 1, "nothing is expanded"),
    r"\input{a}": ("unknown-command", 1, "nothing is expanded"),
    r"\csname x\endcsname": ("unknown-command", 1, "nothing is expanded"),
    r"\bar x": ("unknown-command", 1, "accent"),
    r"\tilde{x}": ("unknown-command", 1, "accent"),
    r"\dv{x}{t}": ("unknown-command", 1, r"\dot{x}"),
    r"\pm x": ("unknown-command", 1, "sign"),
    r"x \over y": ("unknown-command", 3, r"\frac{a}{b}"),
    r"\tg x": ("unknown-command", 1, r"\tan"),
    r"\arctg x": ("unknown-command", 1, r"\arctan"),
    r"\sgn x": ("unknown-command", 1, "operatorname"),
    r"\int x": ("unknown-command", 1, "integrals"),
    r"\begin{pmatrix} x \end{pmatrix}": ("unknown-command", 1, "environment"),
    r"\infty": ("unknown-command", 1, "finite"),
    r"x \approx y": ("unknown-command", 3, "="),
    r"30^\circ": ("latex-argument", 4, ""),
    r"30^{\circ}": ("unknown-command", 5, "radians"),
    r"\langle x \rangle": ("unknown-command", 1, "(...)"),
    r"x \le y": ("inequality", 3, "="),
    r"x \neq y": ("inequality", 3, "="),
    r"x < y": ("inequality", 3, "="),
    r"x \geq y": ("inequality", 3, "="),
    r"\ell": ("unknown-symbol", 1, "`l`"),
    r"\frac{g}{\ell}": ("unknown-symbol", 10, "`l`"),
    r"q": ("unknown-symbol", 1, "the declared names are"),
    r"\Theta": ("unknown-symbol", 1, "`theta`"),
    r"mgq": ("unknown-symbol", 3, ""),
    r"qmg": ("unknown-symbol", 1, ""),
    r"\theta_3": ("unknown-symbol", 1, "theta_1"),
    r"\ddot{\theta}_{3}": ("unknown-symbol", 1, "theta_1"),
    r"\omega_1": ("unknown-symbol", 1, "omega_0"),
    r"\mu": ("unknown-symbol", 1, "`u`"),
    r"X": ("unknown-symbol", 1, "`x`"),
    r"w": ("unknown-symbol", 1, "`omega`"),
    r"\mathrm{rood}": ("unknown-symbol", 1, ""),
    r"lambda_rot": ("unknown-symbol", 1, "lambda_rod"),
    r"а + \theta": ("unexpected-character", 1, "CYRILLIC"),
    r"\theta + о": ("unexpected-character", 10, "CYRILLIC"),
    r"\theta # x": ("unexpected-character", 8, "comments"),
    r"\theta ! x": ("unexpected-character", 8, "factorials"),
    r"\theta : x": ("unexpected-character", 8, ""),
    "\\theta\u200b": ("invisible-character", 7, "delete"),
    "\\theta\x00": ("invisible-character", 7, "delete"),
    "\\th\x07eta": ("invisible-character", 4, "delete"),
    r"\theta \& x": ("unknown-command", 8, ""),
    r"\theta \% x": ("unknown-command", 8, "percentage"),
    r"\frac{x}{": ("not-closed", 9, "}"),
    r"\frac{x": ("not-closed", 6, "}"),
    r"x}": ("not-opened", 2, ""),
    r"x)": ("not-opened", 2, ""),
    r"\frac{x)}{2}": ("not-opened", 8, ""),
    r"(x": ("not-closed", 1, ")"),
    r"\left(x": ("not-closed", 1, ")"),
    r"\frac{(x}{2}": ("not-closed", 7, ")"),
    r"(x]": ("not-closed", 3, ")"),
    r"\left(x\right]": ("not-closed", 8, ")"),
    r"\lvert x)": ("not-closed", 9, ""),
    r"\left x": ("latex-argument", 1, "right"),
    r"\left. x \right|": ("latex-argument", 1, "pairs"),
    r"x \right)": ("not-opened", 3, ""),
    r"\frac{}{2}": ("empty-brackets", 6, ""),
    r"\frac{x}{}": ("empty-brackets", 9, ""),
    r"\sqrt{}": ("empty-brackets", 6, ""),
    r"\sin{}": ("empty-brackets", 5, ""),
    r"x_{}": ("empty-brackets", 2, ""),
    r"()": ("empty-brackets", 1, ""),
    r"\frac{x+}{2}": ("ends-early", 9, ""),
    r"x +": ("ends-early", 4, ""),
    r"\frac{x}": ("latex-argument", 1, "frac"),
    r"\frac": ("latex-argument", 1, "frac"),
    r"\dot": ("latex-argument", 1, "dot"),
    r"\dot = x": ("latex-argument", 1, ""),
    r"\frac x\sqrt y": ("latex-argument", 8, "braces"),
    r"x^": ("latex-argument", 2, "^{...}"),
    r"x_": ("latex-argument", 2, "_{...}"),
    r"x^\frac12": ("latex-argument", 3, "braces"),
    r"x^2^3": ("double-script", 4, ""),
    r"x_1_2": ("double-script", 4, ""),
    r"\dot{x_1}_2": ("double-script", 10, ""),
    r"x^23": ("latex-argument", 2, "^{23}"),
    r"\theta_12": ("latex-argument", 7, "_{12}"),
    r"(x)_1": ("bad-subscript", 4, ""),
    r"_1 x": ("bad-subscript", 1, ""),
    r"2_1": ("bad-subscript", 2, ""),
    r"\log_{10} x": ("bad-subscript", 5, r"\ln"),
    r"x_{+}": ("bad-subscript", 4, ""),
    r"\sqrt[n]{x}": ("bad-root", 1, "3"),
    r"\sqrt[0]{x}": ("bad-root", 1, "3"),
    r"\sin": ("no-argument", 1, "sin"),
    r"\sin + x": ("no-argument", 1, "sin"),
    r"\sin^{-1} x": ("function-exponent", 7, r"\arcsin"),
    r"\sin^k x": ("function-exponent", 6, ""),
    r"\cos^{-2}\theta": ("function-exponent", 7, ""),
    r"\sin' x": ("misplaced-prime", 5, ""),
    r"' x": ("misplaced-prime", 1, ""),
    r"x 2": ("missing-operator", 3, "*2"),
    r"2 3": ("missing-operator", 3, ""),
    r"\frac{d}{dt}": ("no-argument", 1, "(...)"),
    r"\frac{d}{dt} + x": ("no-argument", 1, "(...)"),
    r"\frac{d^2 x}{dt}": ("bad-derivative", 1, "d^2"),
    r"\frac{dx}{dt^2}": ("bad-derivative", 1, "d^2"),
    r"\frac{\partial^2 x}{\partial x}": ("bad-derivative", 1, "partial"),
    r"\partial x": ("bad-derivative", 1, "frac"),
    r"\frac{d x}{d y}": ("unknown-symbol", 7, "differential"),
    r"\mathbf{x}": ("not-a-vector", 1, "leave"),
    r"\vec{m}": ("not-a-vector", 1, "leave"),
    r"\hat{\theta}": ("not-a-vector", 1, "leave"),
    r"\mathrm{d} + x": ("not-a-differential", 1, ""),
    r"\text{for all } x": ("words-in-equation", 1, "beside"),
    r"x \text{ is } y": ("unknown-symbol", 3, ""),
    r"\dot m": ("prime-of-constant", 1, ""),
    r"\dot{2}": ("prime-of-constant", 5, ""),
    r"1.2.3": ("bad-number", 4, ""),
    "1" * 31 + r"\theta": ("number-too-long", 1, "round"),
    r"x^{21}": ("exponent-too-large", 1, ""),
    r"x^{10^{18}}": ("exponent-too-large", 1, ""),
    r"\frac{x}{1 - 1}": ("division-by-zero", 0, ""),
    r"x = y": ("unexpected-equation", 3, ""),
    "{" * 61 + "x" + "}" * 61: ("nested-too-deep", 61, ""),
    "(" * 61 + "x" + ")" * 61: ("nested-too-deep", 62, ""),
    r"\frac{1}{" * 61 + "x" + "}" * 61: ("nested-too-deep", 0, ""),
    r"\theta_{1B}": ("unknown-symbol", 1, ""),
    r"\begin{align} x": ("unknown-command", 1, ""),
    r"aba": ("ambiguous-product", 1, ""),
}  # fmt: skip


def refused(text: str, known: Scope = SCOPE) -> tuple[Diagnostic, ...]:
    with pytest.raises(ProblemError) as caught:
        value(text, known)
    return caught.value.diagnostics


@pytest.mark.parametrize("text", REFUSED)
def test_refused(text: str) -> None:
    found = refused(text)[0]
    code, column, help_ = REFUSED[text]
    assert found.span is not None
    assert found.code == code
    assert found.span.start + 1 == column or not column
    assert found.span.end <= max(len(text), found.span.start + 1)
    assert help_ in found.help
    assert not found.message.endswith(".")


# -- notes -----------------------------------------------------------------------------------------------------------

NOTED = {
    r"\sin\theta/2": "ends before the `/`",
    r"\cos\theta x": "ends before the `x`",
    r"\sin\theta(x + y)": "ends before the `(`",
    r"\sin\alpha x": r"\sin(\alpha x)",
    r"\sin k x": r"\sin(k x)",
    r"\sin\theta^2": r"\sin(\theta^2)",
    r"\sin\dot\theta": r"\sin(\dot\theta)",
    r"\sin{\theta}^2": r"(\sin{\theta})^",
    r"x/l m": "(x/l)*m",
    r"1/2m": "(1/2)*m",
    r"2\frac{1}{2}": "multiplies it",
    r"x^{(2)}": "read as a power",
    r"mab": "`m ab`",
    r"\frac{d}{dt} m x": "differentiates all of `m x`",
    r"\frac{d}{dt}(x)^2": "of the power",
    r"m(2)": "m*2",
    r"\sin -x": "sin(-x)",
    r"abba": "`ab ba`",
}
QUIET = (
    r"\sin\theta", r"\sin 2\theta", r"\sin\omega t", r"\sin\theta\cos\theta", r"\sin\theta\,x", r"\frac{d}{dt}(m x)", r"mgR",
    r"\frac12 m\dot x^2", r"1/2 m", r"\ddot\theta_1", r"\sin^2\theta\,\dot\phi", r"\sqrt{x} y", r"\omega^2_0", r"\theta(t)",
    r"\frac{g}{l}\sin\theta", r"\sin\frac{\theta}{2}", r"\sin(2\theta)\,x", r"e^{-kt}x", r"\frac{d\theta}{dt}", r"ab", r"mg\sin\theta",
)  # fmt: skip


@pytest.mark.parametrize("text", NOTED)
def test_surprising_readings_are_echoed(text: str) -> None:
    notes: list[Diagnostic] = []
    value(text, notes=notes)
    assert [n for n in notes if NOTED[text] in n.message]


@pytest.mark.parametrize("text", QUIET)
def test_usual_readings_are_not(text: str) -> None:
    notes: list[Diagnostic] = []
    value(text, notes=notes)
    assert notes == []


# -- anything at all -------------------------------------------------------------------------------------------------


def test_a_doubled_sign_is_one() -> None:
    notes: list[Diagnostic] = []
    equation = read_equation(latex(r"\dot x == y"), SCOPE, notes, latex=True)
    assert (str(equation.lhs), str(equation.rhs)) == ("x'", "y")
    assert ["==" in n.message for n in notes] == [True]


def test_problem_files_are_plain_text() -> None:
    with pytest.raises(ProblemError, match="no meaning here"):
        read_equation(Fragment.of(r"\dot x = 0"), SCOPE)
    assert isinstance(read_equation(Fragment.of(r"\dot x = 0"), SCOPE, latex=True), EquationRead)
