"""Greek letters and the names of functions in LaTeX."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.diagnostics import Diagnostic, Fragment
from lagrange.core.symbols import Slots
from lagrange.document.names import GREEK
from lagrange.expressions.latex_layout import piece
from lagrange.expressions.latex_names import FUNCTIONS
from lagrange.expressions.reader import Scope, read_value
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


x, theta, phi = (sp.Symbol(n, real=True) for n in ("x", "theta", "phi"))


@pytest.mark.parametrize("command", sorted(FUNCTIONS))
def test_each_function(command: str) -> None:
    name = FUNCTIONS[command]
    if command in ("sign",):  # `\operatorname{sgn}` in LaTeX
        return
    for text in (rf"\{command} x", rf"\{command}(x)", rf"\{command}{{x}}", rf"\{command}\left(x\right)", f"{name}(x)"):
        assert means(text, f"{name}(x)")
    assert means(rf"2\{command} x \{command} y", f"2*{name}(x)*{name}(y)")


LETTERS = {name: command for name, (_, command) in GREEK.items() if command.startswith("\\") and "{" not in command}


@pytest.mark.parametrize("name", sorted(LETTERS))
def test_each_greek_letter(name: str) -> None:
    if name == "pi":
        return
    known = scope(name, f"{name}_0")
    command = LETTERS[name]
    assert means(f"{command} x", f"{name}*x", known)
    assert means(f"{command}_0^2", f"{name}_0^2", known)
    assert means(f"2{command} x{command}", f"2*{name}^2*x", known)
    moving = Scope({}, Slots((sp.Symbol(name, real=True),)))
    assert means(rf"\ddot{{{command}}} + \dot{command}", f"{name}'' + {name}'", moving)
