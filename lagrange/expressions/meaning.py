"""A syntax tree -> the scalar that it means, with the names that are declared: nothing else has a meaning.

Numbers are exact. x' and diff(e, t) are total time derivatives, diff(e, x) is a partial one, all carried out
at once; the partial derivative of an undefined function by its argument X stays what it is, ∂f/∂X. d(x) and
delta(x) are the symbols dx and δx.
"""

from __future__ import annotations

from abc import ABC, abstractmethod

import sympy as sp

from lagrange.core.diagnostics import Fragment, ProblemError
from lagrange.core.symbols import Unspecified, base, differential, t, variation
from lagrange.core.vectors import Vector
from lagrange.expressions.bounded import HIGHEST_PRESCRIBED_RATE, MAX_EXPONENT, MAX_NESTED_EXPONENT, Arithmetic
from lagrange.expressions.lexicon import FUNCTIONS, Role
from lagrange.expressions.remarks import Remarks
from lagrange.expressions.scope import UNITS, FunctionDeclaration, Scope
from lagrange.expressions.trees import (
    Bars,
    Call,
    Components,
    Name,
    Number,
    Power,
    Primed,
    Product,
    Sum,
    Tree,
    parts,
)

DIFFERENTIALS = ("d", "delta")


class ScalarMeaning(Remarks, ABC):
    """What the trees of one text mean as scalars.

    names  all that occur in the text
    """

    def __init__(self, fragment: Fragment, scope: Scope, names: frozenset[str]) -> None:
        super().__init__(fragment, scope)
        self.names = names
        self.arithmetic = Arithmetic(scope.slots, scope.purse)
        self._nested: dict[int, float] = {}

    @abstractmethod
    def vector(self, tree: Tree) -> Vector:
        """The tree as a vector."""

    @abstractmethod
    def is_vector(self, tree: Tree) -> bool:
        """Whether a tree is a vector beyond doubt."""

    @abstractmethod
    def dotted(self, tree: Product) -> tuple[Tree, Tree] | None:
        """The two vectors of which a product with ⋅ is the scalar product; None where it is none."""

    def scalar(self, tree: Tree) -> sp.Expr:
        """The tree as a scalar. Raises ProblemError where it is none."""
        match tree:
            case Number(text=text):
                return sp.Rational(text)
            case Name():
                return self._named(tree)
            case Primed(operand=inner, order=order):
                return self._rate(inner, order, tree)
            case Sum(terms=terms):
                with self.blaming(tree):
                    return self.arithmetic.sum([self._signed(sign, term) for sign, term in terms])
            case Product(factors=factors):
                dotted = self.dotted(tree)
                return self.product(tree, factors) if dotted is None else self._inner(tree, *dotted)
            case Power():
                return self._power(tree)
            case Call():
                return self._called(tree)
            case Bars(operand=inner):
                return self._size(inner, tree)
            case Components():
                message = "a list of components stands where a scalar belongs"
                help_ = "group with parentheses; brackets make a vector"
                raise self.mistake("vector-for-scalar", message, tree, help_)

    def product(self, whole: Tree, factors: tuple[tuple[str, Tree], ...]) -> sp.Expr:
        """The product of scalars, each multiplied or divided by."""
        values = [self._divisor(f) if operator == "/" else self.scalar(f) for operator, f in factors]
        with self.blaming(whole):
            return self.arithmetic.product(values)

    def _inner(self, whole: Tree, a: Tree, b: Tree) -> sp.Expr:
        left, right = self.vector(a), self.vector(b)
        with self.blaming(whole):
            return self.arithmetic.dot(left, right)

    def _signed(self, sign: int, term: Tree) -> sp.Expr:
        value = self.scalar(term)
        return value if sign > 0 else self.arithmetic.product([sp.S.NegativeOne, value])

    def _divisor(self, tree: Tree) -> sp.Expr:
        value = self.scalar(tree)
        with self.blaming(tree):
            return self.arithmetic.inverse(value)

    def _size(self, inner: Tree, whole: Tree) -> sp.Expr:
        """|a| of a scalar or a vector."""
        if self.is_vector(inner):
            vector = self.vector(inner)
            with self.blaming(whole):
                return self.arithmetic.norm(vector)
        value = self.scalar(inner)
        with self.blaming(whole):
            return self.arithmetic.apply("abs", [value])

    # -- names -----------------------------------------------------------------------------------------------

    def _named(self, name: Name) -> sp.Expr:
        value = self.scope.scalar(name.text)
        if value is not None:
            with self.blaming(name):
                return self.arithmetic.checked(value)
        if name.text in self.scope.functions:
            return self._bare_function(self.scope.functions[name.text], name)
        if self.scope.vector(name.text) is not None:
            unit = name.text in UNITS
            help_ = (
                f"`{name.text}` is a unit vector unless it is declared, under `parameters:` for example"
                if unit
                else f"take a component, `dot({name.text}, i)`, or the length, `norm({name.text})`"
            )
            message = f"the vector `{name.text}` stands where a scalar belongs"
            raise self.mistake("vector-for-scalar", message, name, help_)
        raise ProblemError(self.undeclared(name))

    def _bare_function(self, function: FunctionDeclaration, name: Name) -> sp.Expr:
        """An undefined function without arguments: at those that its declaration names, or its only ones."""
        where = function.standard or self._standard(function)
        if where is None:
            help_ = f"write `{function.name}(...)`; it is declared as {function}"
            raise self.mistake("no-argument", f"`{function.name}` needs its arguments", name, help_)
        return Unspecified.of(function.name, function.arguments, *where)

    def _standard(self, function: FunctionDeclaration) -> tuple[sp.Expr, ...] | None:
        """The arguments that the declaration names, where all of these are declared: x, x', t."""
        values = []
        for argument in function.arguments:
            value = self.scope.scalar(argument.rstrip("'"))
            if value is None:
                return None
            for _ in range(argument.count("'")):
                value = self.arithmetic.rate(value)
            values.append(value)
        return tuple(values)

    # -- powers ----------------------------------------------------------------------------------------------

    def _power(self, tree: Power) -> sp.Expr:
        if self._nested_exponent(tree) > MAX_NESTED_EXPONENT:
            message = f"nested exponents multiply to more than {MAX_NESTED_EXPONENT}"
            if isinstance(tree.exponent, Number) and sp.Rational(tree.exponent.text) > MAX_EXPONENT:
                message = f"numbers in an exponent may be up to {MAX_EXPONENT}"
            raise self.mistake("exponent-too-large", message, tree, "is this the power that is meant?")
        if self.is_vector(tree.base):
            help_ = "write `dot(a, a)` for its square"
            raise self.mistake("vector-power", "a vector has no powers", tree, help_)
        base, exponent = self.scalar(tree.base), self.scalar(tree.exponent)
        with self.blaming(tree):
            return self.arithmetic.power(base, exponent)

    def _nested_exponent(self, tree: Tree) -> float:
        """The product of the numeric exponents that are nested in a tree, at its deepest."""
        found = self._nested.get(id(tree))
        if found is None:
            match tree:
                case Power(base=base, exponent=exponent):
                    own = float(sp.Rational(exponent.text)) if isinstance(exponent, Number) else 1.0
                    found = max(own, 1.0) * self._nested_exponent(base)
                case Sum() | Product() | Primed() | Bars():
                    found = max(self._nested_exponent(part) for part in parts(tree))
                case _:
                    found = 1.0
            self._nested[id(tree)] = found
        return found

    # -- functions -------------------------------------------------------------------------------------------

    def _called(self, call: Call) -> sp.Expr:
        name = call.name
        if name in FUNCTIONS:
            return self._function(call)
        if name in self.scope.functions:
            return self._undefined(self.scope.functions[name], call)
        match name:
            case "dot":
                a, b = self.vectors(call, 2)
                with self.blaming(call):
                    return self.arithmetic.dot(a, b)
            case "norm":
                (a,) = self.vectors(call, 1)
                with self.blaming(call):
                    return self.arithmetic.norm(a)
            case "diff":
                return self._partial(call)
            case "cross":
                message, help_ = (
                    "`cross` is a vector, and a scalar belongs here",
                    "write `dot(cross(a, b), c)`",
                )
                raise self.mistake("vector-for-scalar", message, call, help_)
            case "d" | "delta":
                return self._differential(call)
        raise ProblemError(self.undeclared(call))

    def _function(self, call: Call) -> sp.Expr:
        name, arguments = call.name, call.arguments
        if name == "atan2":
            self.check_count(call, 2, "`atan2(y, x)` is the angle of the point (x, y)")
        else:
            self.check_count(call, 1, f"write `{name}(x)`")
        if name == "abs":
            return self._size(arguments[0], call)
        values = [self.scalar(a) for a in arguments]
        with self.blaming(call):
            return self.arithmetic.apply(name, values)

    def _undefined(self, function: FunctionDeclaration, call: Call) -> sp.Expr:
        self.check_count(call, len(function.arguments), f"it is declared as {function}")
        values = [self.scalar(a) for a in call.arguments]
        with self.blaming(call):
            return self.arithmetic.checked(Unspecified.of(function.name, function.arguments, *values))

    def vectors(self, call: Call, count: int) -> list[Vector]:
        """The arguments of a call, as vectors."""
        self.check_count(call, count, f"write `{call.name}({', '.join('ab'[:count])})`")
        return [self.vector(a) for a in call.arguments]

    def check_count(self, call: Call, wanted: int, help_: str) -> None:
        """Whether a call has as many arguments as it should."""
        given = len(call.arguments)
        if given != wanted:
            arguments = "1 argument" if wanted == 1 else f"{wanted} arguments"
            message = f"`{call.name}` takes {arguments}, and {given} {'is' if given == 1 else 'are'} given"
            raise self.mistake("number-of-arguments", message, call, help_)

    # -- derivatives -----------------------------------------------------------------------------------------

    def _rate(self, tree: Tree, order: int, whole: Primed) -> sp.Expr:
        value = self.scalar(tree)
        self._check_moves(value, tree, whole)
        self.check_order(order, whole)
        with self.blaming(whole):
            for _ in range(order):
                value = self.arithmetic.rate(value)
        return value

    def check_order(self, order: int, whole: Primed) -> None:
        """No more primes than anything may have."""
        if order > HIGHEST_PRESCRIBED_RATE:
            help_ = "equations of motion have second derivatives at most"
            raise self.mistake("too-many-primes", f"{order} primes are too many", whole, help_)

    def _check_moves(self, value: sp.Expr, tree: Tree, whole: Primed) -> None:
        """A number or a constant symbol is primed by mistake, a constant abbreviation need not be."""
        if isinstance(tree, Number):
            message, help_ = (
                f"the number {tree.text} has no time derivative",
                "write `x'^2` for the square of x'",
            )
            raise self.mistake("prime-of-constant", message, whole, help_)
        if not isinstance(tree, Name) or value == t or not (value.is_Symbol or value == sp.pi):
            return
        if value == sp.pi or self.scope.role(base(value).name) not in (Role.COORDINATE, Role.PRESCRIBED):
            message = f"`{tree.text}` has no time derivative: it is neither a coordinate nor a function of time"
            help_ = "declare it under `coordinates:`, or under `functions:` as `u: [t]`"
            raise self.mistake("prime-of-constant", message, whole, help_)

    def _partial(self, call: Call) -> sp.Expr:
        """diff(e, x), diff(e, t), diff(f, X)."""
        tree, by = self.derivative_parts(call)
        value = self.scalar(tree)
        if isinstance(value, Unspecified) and isinstance(by, Name):
            declared = self.scope.scalar(by.text) is not None
            if by.text in value.argument_names and not (declared and isinstance(tree, Call)) and by.text != "t":
                return value.partial(value.argument_names.index(by.text))
        with self.blaming(call):
            if isinstance(by, Name) and by.text == "t":
                return self.arithmetic.rate(value)
            return self.arithmetic.partial(value, self.variable(by))

    def derivative_parts(self, call: Call) -> tuple[Tree, Tree]:
        """What is differentiated, and by what."""
        self.check_count(call, 2, "write `diff(e, x)`, and `diff(diff(e, x), y)` for a second derivative")
        return call.arguments[0], call.arguments[1]

    def variable(self, tree: Tree) -> sp.Symbol:
        """The variable of a partial derivative: a symbol, or a velocity."""
        if isinstance(tree, Name) and self.scope.scalar(tree.text) is None and self.is_argument_name(tree.text):
            message = f"`{tree.text}` is an argument of an undefined function"
            help_ = f"differentiate the function itself by it: `diff(f, {tree.text})`"
            raise self.mistake("not-a-variable", message, tree, help_)
        value = self.scalar(tree) if isinstance(tree, (Name, Primed)) else None
        if value is None or not value.is_Symbol:
            message, help_ = (
                "`diff` differentiates by a variable",
                "name a coordinate, a velocity, a parameter or t",
            )
            raise self.mistake("not-a-variable", message, tree, help_)
        return value

    def is_argument_name(self, name: str) -> bool:
        """Whether an undefined function has an argument of that name."""
        return any(name in f.arguments for f in self.scope.functions.values())

    def quasi_variation(self, tree: Tree) -> sp.Expr | None:
        """delta(pi_u), which is no variation of a symbol, where a derivation has given it a meaning."""
        match tree:
            case Call(name="delta", arguments=(Name(text=text),)):
                return self.scope.scalars.get(f"delta({text})")
        return None

    def _differential(self, call: Call) -> sp.Expr:
        """d(x) and delta(x); of an abbreviation, Σ (∂e/∂q) dq."""
        self.check_count(call, 1, f"write `{call.name}(x)`")
        inner = call.arguments[0]
        given = self.quasi_variation(call)
        if given is not None:
            return given
        value = self.scope.scalar(inner.text) if isinstance(inner, Name) else None
        moving = {
            *self.scope.slots.coordinates,
            *(() if call.name == "delta" else (*self.scope.slots.prescribed, t)),
        }
        make = differential if call.name == "d" else variation
        if value is not None and not value.is_Atom:  # an abbreviation, such as V
            with self.blaming(call):
                parts = ((self.arithmetic.partial(value, q), make(q)) for q in sorted(moving, key=str))
                return self.arithmetic.sum([self.arithmetic.product(p) for p in parts])
        if value not in moving:
            what = "a coordinate" if call.name == "delta" else "a coordinate or of t"
            help_ = f"write `{call.name}(x)` for each coordinate, or declare `{call.name}` if it is a symbol"
            raise self.mistake("not-a-differential", f"`{call.name}` is taken of {what}", call, help_)
        return make(value)
