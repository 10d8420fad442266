"""Powers that come from logarithms are real somewhere."""

import sympy as sp

from lagrange.algebra.forms.factor_methods import exp_of, is_never_positive, unbarred

psi, x = sp.symbols("psi x", real=True)


def test_what_is_never_positive_changes_its_sign() -> None:
    assert unbarred(sp.Abs((sp.cos(psi) - 1) / sp.sin(psi))) == (1 - sp.cos(psi)) / sp.sin(psi)
    power = exp_of(sp.sqrt(2) * sp.log(sp.Abs(sp.cos(psi) - 1)))
    assert power.subs(psi, 1).evalf().is_real
    assert unbarred(sp.Abs(x - 1)) == x - 1


def test_bounds_of_waves() -> None:
    assert is_never_positive(sp.cos(psi) - 1)
    assert is_never_positive(sp.sin(2 * psi) + sp.cos(psi) - 2)
    assert not is_never_positive(sp.cos(psi) - sp.Rational(1, 2))
    assert not is_never_positive(x - 1)
