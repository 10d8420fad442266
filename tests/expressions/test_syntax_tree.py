"""The syntax tree."""

from __future__ import annotations

from lagrange.expressions.syntax_tree import Call, Name, NumberLiteral, Power, Product, Sum, parts


def test_children_in_the_order_of_the_text() -> None:
    x, two = Name("x", 0, 1), NumberLiteral("2", 2, 3)
    power = Power(x, two, 0, 3)
    product = Product((("*", power), ("/", x)), 0, 5)
    call = Call("sin", (product,), 0, 9, 3)
    assert parts(Sum(((1, call), (-1, two)), 0, 12)) == (call, two)
    assert parts(call) == (product,)
    assert parts(product) == (power, x)
    assert parts(power) == (x, two)
    assert parts(x) == ()
