"""A syntax tree -> the scalar or vector that it means, with the declared names: nothing else has a meaning.

Numbers are exact. x' and diff(e, t) are total time derivatives, diff(e, x) is a partial one, all carried out at once;
the partial derivative of an undefined function with respect to its argument X stays as it is, ∂f/∂X. d(x) and delta(x)
are the symbols dx and δx; for an abbreviation or a vector they are carried out, Σ (∂e/∂q) dq.

A vector is a linear combination of unit vectors, or a list of components. Where a vector is expected and a file
declares `k` (or `i`, `j`) as a scalar, the name means the scalar inside component lists, arguments of scalar functions,
exponents and divisors, and in a term that has another vector; otherwise it means the unit vector, and a note says so.
In a term with several, `k*k`, the last one is the unit vector.
"""

from __future__ import annotations

import sympy as sp

from lagrange.core.diagnostics import Fragment, ProblemError
from lagrange.core.symbols import Decimal, Unspecified, base, differential, prime, t, variation
from lagrange.core.vectors import Vector
from lagrange.expressions.bounded_arithmetic import BoundedArithmetic
from lagrange.expressions.limits import HIGHEST_PRESCRIBED_RATE, MAX_EXPONENT, MAX_NESTED_EXPONENT
from lagrange.expressions.scope import UNITS, FunctionDeclaration, Scope, TreeReport
from lagrange.expressions.syntax_tree import (
    FUNCTIONS,
    INVERSE_HYPERBOLIC,
    Bars,
    BracketedList,
    Call,
    Name,
    NumberLiteral,
    Power,
    Primed,
    Product,
    Role,
    Sum,
    Tree,
    parts,
)

DIFFERENTIALS = ("d", "delta")

FactorTrees = tuple[tuple[str, Tree], ...]


class TextMeaning:
    """What the trees of one text mean, as scalars and as vectors.

    names  all that occur in the text
    """

    def __init__(self, fragment: Fragment, scope: Scope, names: frozenset[str]) -> None:
        self.scope = scope
        self.report = TreeReport(fragment, scope)
        self._names = names
        self._arithmetic = BoundedArithmetic(scope.slots, scope.budget)
        self._nested: dict[int, float] = {}

    # -- scalars ---------------------------------------------------------------------------------------------

    def scalar(self, tree: Tree) -> sp.Expr:
        """The tree as a scalar. Raises ProblemError if it is none."""
        match tree:
            case NumberLiteral(text=text, start=start):
                if self.scope.decimals is not None and Decimal.is_rounded(text):
                    return Decimal(text, f"{self.scope.decimals}{start}")
                return sp.Rational(text)
            case Name():
                return self._named(tree)
            case Primed(operand=inner, order=order):
                return self._rate(inner, order, tree)
            case Sum(terms=terms):
                with self.report.blaming(tree):
                    return self._arithmetic.sum([self._signed(sign, term) for sign, term in terms])
            case Product(factors=factors):
                dotted = self._dotted(tree)
                return self._product(tree, factors) if dotted is None else self._inner(tree, *dotted)
            case Power():
                return self._power(tree)
            case Call():
                return self._called(tree)
            case Bars(operand=inner):
                return self._size(inner, tree)
            case BracketedList():
                message = "a list of components is used where a scalar is expected"
                help_ = "group with parentheses; brackets make a vector"
                raise self.report.error("vector-for-scalar", message, tree, help_)

    def _product(self, blamed: Tree, factors: tuple[tuple[str, Tree], ...]) -> sp.Expr:
        """The product of scalars, or quotient where the operator is `/`."""
        values = [self._divisor(f) if operator == "/" else self.scalar(f) for operator, f in factors]
        with self.report.blaming(blamed):
            return self._arithmetic.product(values)

    def _inner(self, blamed: Tree, a: Tree, b: Tree) -> sp.Expr:
        left, right = self.vector(a), self.vector(b)
        with self.report.blaming(blamed):
            return self._arithmetic.dot(left, right)

    def _signed(self, sign: int, term: Tree) -> sp.Expr:
        value = self.scalar(term)
        return value if sign > 0 else self._arithmetic.product([sp.S.NegativeOne, value])

    def _divisor(self, tree: Tree) -> sp.Expr:
        value = self.scalar(tree)
        with self.report.blaming(tree):
            return self._arithmetic.inverse(value)

    def _size(self, inner: Tree, blamed: Tree) -> sp.Expr:
        """|a| of a scalar or a vector."""
        if self.is_vector(inner):
            vector = self.vector(inner)
            with self.report.blaming(blamed):
                return self._arithmetic.norm(vector)
        value = self.scalar(inner)
        with self.report.blaming(blamed):
            return self._arithmetic.apply("abs", [value])

    # -- names -----------------------------------------------------------------------------------------------

    def _named(self, name: Name) -> sp.Expr:
        value = self.scope.scalar(name.text)
        if value is not None:
            with self.report.blaming(name):
                return self._arithmetic.checked(value)
        if name.text in self.scope.functions:
            return self._bare_function(self.scope.functions[name.text], name)
        if self.scope.vector(name.text) is not None:
            unit = name.text in UNITS
            help_ = (
                f"`{name.text}` is a unit vector unless it is declared, under `parameters:` for example"
                if unit
                else f"take a component, `dot({name.text}, i)`, or the length, `norm({name.text})`"
            )
            message = f"the vector `{name.text}` is used where a scalar is expected"
            raise self.report.error("vector-for-scalar", message, name, help_)
        raise ProblemError(self.report.undeclared(name))

    def _bare_function(self, function: FunctionDeclaration, name: Name) -> sp.Expr:
        """An undefined function without arguments: taken at those that its declaration names, or at its only ones."""
        where = function.standard or self._standard(function)
        if where is None:
            help_ = f"write `{function.name}(...)`; it is declared as {function}"
            raise self.report.error("no-argument", f"`{function.name}` needs its arguments", name, help_)
        return Unspecified.of(function.name, function.arguments, *where)

    def _standard(self, function: FunctionDeclaration) -> tuple[sp.Expr, ...] | None:
        """The arguments that the declaration names, if all of these are declared: x, x', t."""
        values = []
        for argument in function.arguments:
            value = self.scope.scalar(argument.rstrip("'"))
            if value is None:
                return None
            for _ in range(argument.count("'")):
                value = self._arithmetic.rate(value)
            values.append(value)
        return tuple(values)

    # -- powers ----------------------------------------------------------------------------------------------

    def _power(self, tree: Power) -> sp.Expr:
        if self._nested_exponent(tree) > MAX_NESTED_EXPONENT:
            message = f"nested exponents multiply to more than {MAX_NESTED_EXPONENT}"
            if isinstance(tree.exponent, NumberLiteral) and sp.Rational(tree.exponent.text) > MAX_EXPONENT:
                message = f"a number in an exponent may be at most {MAX_EXPONENT}"
            raise self.report.error("exponent-too-large", message, tree, "is this the intended power?")
        if self.is_vector(tree.base):
            help_ = "write `dot(a, a)` for its square"
            raise self.report.error("vector-power", "a vector has no powers", tree, help_)
        base = self.scalar(tree.base)
        number = tree.exponent.text if isinstance(tree.exponent, NumberLiteral) else None
        exponent = self.scalar(tree.exponent) if number is None else sp.Rational(number)
        with self.report.blaming(tree):
            return self._arithmetic.power(base, exponent)

    def _nested_exponent(self, tree: Tree) -> float:
        """The largest product of numeric exponents nested in a tree."""
        highest = self._nested.get(id(tree))
        if highest is None:
            match tree:
                case Power(base=base, exponent=exponent):
                    own = float(sp.Rational(exponent.text)) if isinstance(exponent, NumberLiteral) else 1.0
                    highest = max(own, 1.0) * self._nested_exponent(base)
                case Sum() | Product() | Primed() | Bars():
                    highest = max(self._nested_exponent(part) for part in parts(tree))
                case _:
                    highest = 1.0
            self._nested[id(tree)] = highest
        return highest

    # -- functions -------------------------------------------------------------------------------------------

    def _called(self, call: Call) -> sp.Expr:
        name = call.name
        if name in FUNCTIONS:
            return self._function(call)
        if name in self.scope.functions:
            return self._undefined(self.scope.functions[name], call)
        match name:
            case "dot":
                a, b = self._vectors(call, 2)
                with self.report.blaming(call):
                    return self._arithmetic.dot(a, b)
            case "norm":
                (a,) = self._vectors(call, 1)
                with self.report.blaming(call):
                    return self._arithmetic.norm(a)
            case "diff":
                return self._partial(call)
            case "cross":
                message, help_ = (
                    "`cross` is a vector, and a scalar is expected here",
                    "write `dot(cross(a, b), c)`",
                )
                raise self.report.error("vector-for-scalar", message, call, help_)
            case "d" | "delta":
                return self._differential(call)
        if name in INVERSE_HYPERBOLIC:
            return self._inverse_hyperbolic(call)
        raise ProblemError(self.report.undeclared(call))

    def _inverse_hyperbolic(self, call: Call) -> sp.Expr:
        """acosh x = log(x + √(x² − 1)), asinh x = log(x + √(x² + 1)), atanh x = log((1 + x)/(1 − x))/2."""
        self._check_count(call, 1, f"write `{call.name}(x)`")
        x, do = self.scalar(call.arguments[0]), self._arithmetic
        kind = INVERSE_HYPERBOLIC[call.name]
        with self.report.blaming(call):
            if kind == "tanh":
                above, below = do.sum([sp.S.One, x]), do.sum([sp.S.One, do.product([sp.S.NegativeOne, x])])
                return do.product([sp.S.Half, do.apply("log", [do.product([above, do.inverse(below)])])])
            square = do.sum([do.power(x, sp.Integer(2)), sp.S.One if kind == "sinh" else sp.S.NegativeOne])
            return do.apply("log", [do.sum([x, do.power(square, sp.S.Half)])])

    def _function(self, call: Call) -> sp.Expr:
        name, arguments = call.name, call.arguments
        if name == "atan2":
            self._check_count(call, 2, "`atan2(y, x)` is the angle of the point (x, y)")
        else:
            self._check_count(call, 1, f"write `{name}(x)`")
        if name == "abs":
            return self._size(arguments[0], call)
        values = [self.scalar(a) for a in arguments]
        with self.report.blaming(call):
            return self._arithmetic.apply(name, values)

    def _undefined(self, function: FunctionDeclaration, call: Call) -> sp.Expr:
        self._check_count(call, len(function.arguments), f"it is declared as {function}")
        values = [self.scalar(a) for a in call.arguments]
        with self.report.blaming(call):
            return self._arithmetic.checked(Unspecified.of(function.name, function.arguments, *values))

    def _vectors(self, call: Call, count: int) -> list[Vector]:
        """The arguments of a call, as vectors."""
        self._check_count(call, count, f"write `{call.name}({', '.join('ab'[:count])})`")
        return [self.vector(a) for a in call.arguments]

    def _check_count(self, call: Call, expected: int, help_: str) -> None:
        """Refuse a wrong number of arguments."""
        given = len(call.arguments)
        if given != expected:
            arguments = "1 argument" if expected == 1 else f"{expected} arguments"
            message = f"`{call.name}` takes {arguments}, but {given} {'is' if given == 1 else 'are'} given"
            raise self.report.error("number-of-arguments", message, call, help_)

    # -- derivatives -----------------------------------------------------------------------------------------

    def _rate(self, tree: Tree, order: int, primed: Primed) -> sp.Expr:
        value = self.scalar(tree)
        self._check_moves(value, tree, primed)
        self._check_order(order, primed)
        with self.report.blaming(primed):
            for _ in range(order):
                value = self._arithmetic.rate(value)
        return value

    def _check_order(self, order: int, primed: Primed) -> None:
        """Refuse more primes than anything may have."""
        if order > HIGHEST_PRESCRIBED_RATE:
            help_ = "equations of motion have second derivatives at most"
            raise self.report.error("too-many-primes", f"{order} primes are too many", primed, help_)

    def _check_moves(self, value: sp.Expr, tree: Tree, primed: Primed) -> None:
        """Refuse primes of numbers and of constant symbols; a constant abbreviation may have them."""
        if isinstance(tree, NumberLiteral):
            message, help_ = (
                f"the number {tree.text} has no time derivative",
                "write `x'^2` for the square of x'",
            )
            raise self.report.error("prime-of-constant", message, primed, help_)
        if not isinstance(tree, Name) or value == t or not (value.is_Symbol or value == sp.pi):
            return
        if value == sp.pi or self.scope.role(base(value).name) not in (Role.COORDINATE, Role.PRESCRIBED):
            message = f"`{tree.text}` has no time derivative: it is neither a coordinate nor a function of time"
            help_ = "declare it under `coordinates:`, or under `functions:` as `u: [t]`"
            raise self.report.error("prime-of-constant", message, primed, help_)

    def _partial(self, call: Call) -> sp.Expr:
        """diff(e, x), diff(e, t), diff(f, X); diff(e, t, t) and diff(e, t, 2) are second derivatives."""
        if len(call.arguments) > 2:
            return self._partial(self._nested_derivative(call))
        tree, by = self._derivative_parts(call)
        value = self.scalar(tree)
        if isinstance(value, Unspecified) and isinstance(by, Name):
            declared = self.scope.scalar(by.text) is not None
            if by.text in value.argument_names and not (declared and isinstance(tree, Call)) and by.text != "t":
                return value.partial(value.argument_names.index(by.text))
        with self.report.blaming(call):
            if isinstance(by, Name) and by.text == "t":
                return self._arithmetic.rate(value)
            return self._arithmetic.partial(value, self._variable(by))

    def _nested_derivative(self, call: Call) -> Call:
        """diff(e, x, y) as diff(diff(e, x), y), and diff(e, x, 2) as diff(diff(e, x), x)."""
        inner, *by = call.arguments
        variables: list[Tree] = []
        for argument in by:
            if isinstance(argument, NumberLiteral) and variables and argument.text in ("1", "2", "3", "4"):
                variables += [variables[-1]] * (int(argument.text) - 1)
            else:
                variables.append(argument)
        if len(variables) > HIGHEST_PRESCRIBED_RATE:
            self._check_count(call, 2, "write `diff(e, x)`, and `diff(diff(e, x), y)` for a second derivative")
        for variable in variables[:-1]:
            inner = Call("diff", (inner, variable), call.start, call.end, call.name_end)
        return Call("diff", (inner, variables[-1]), call.start, call.end, call.name_end)

    def _derivative_parts(self, call: Call) -> tuple[Tree, Tree]:
        """The operand and the variable of a derivative."""
        self._check_count(call, 2, "write `diff(e, x)`, and `diff(diff(e, x), y)` for a second derivative")
        return call.arguments[0], call.arguments[1]

    def _variable(self, tree: Tree) -> sp.Symbol:
        """The variable of a partial derivative: a symbol, or a velocity."""
        if isinstance(tree, Name) and self.scope.scalar(tree.text) is None and self.is_argument_name(tree.text):
            message = f"`{tree.text}` is an argument of an undefined function"
            help_ = f"differentiate the function itself with respect to it: `diff(f, {tree.text})`"
            raise self.report.error("not-a-variable", message, tree, help_)
        value = self.scalar(tree) if isinstance(tree, (Name, Primed)) else None
        if value is None or not value.is_Symbol:
            message, help_ = (
                "`diff` differentiates with respect to a variable",
                "name a coordinate, a velocity, a parameter or t",
            )
            raise self.report.error("not-a-variable", message, tree, help_)
        return value

    def is_argument_name(self, name: str) -> bool:
        """Whether an undefined function has an argument of that name."""
        return any(name in f.arguments for f in self.scope.functions.values())

    def quasi_variation(self, tree: Tree) -> sp.Expr | None:
        """delta(pi_u), the variation of a quasi-coordinate and not of a symbol, where a derivation has defined it."""
        match tree:
            case Call(name="delta", arguments=(Name(text=text),)):
                return self.scope.scalars.get(f"delta({text})")
        return None

    def _differential(self, call: Call) -> sp.Expr:
        """d(x) and delta(x); for an abbreviation, Σ (∂e/∂q) dq."""
        self._check_count(call, 1, f"write `{call.name}(x)`")
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
            with self.report.blaming(call):
                parts = ((self._arithmetic.partial(value, q), make(q)) for q in sorted(moving, key=str))
                return self._arithmetic.sum([self._arithmetic.product(p) for p in parts])
        if value not in moving:
            what = "a coordinate" if call.name == "delta" else "a coordinate or to t"
            help_ = f"write `{call.name}(x)` for each coordinate, or declare `{call.name}` if it is a symbol"
            raise self.report.error("not-a-differential", f"`{call.name}` applies to {what}", call, help_)
        return make(value)

    # -- vectors ---------------------------------------------------------------------------------------------

    def is_vector(self, tree: Tree) -> bool:
        """Whether a tree is certainly a vector; a declared `k` counts as the scalar."""
        match tree:
            case Name(text=text):
                return self.scope.vector(text) is not None
            case BracketedList() | Call(name="cross"):
                return True
            case Primed(operand=inner):
                return self.is_vector(inner)
            case Sum(terms=terms):
                return any(self.is_vector(term) for _, term in terms)
            case Product(factors=factors):
                return self._dotted(tree) is None and any(self.is_vector(f) for _, f in factors)
            case Call(name="diff", arguments=arguments):
                return self.is_vector(arguments[0])
            case Call(name=name, arguments=(inner,)) if name in DIFFERENTIALS and name not in self.scope.functions:
                return self.virtual_rotation(tree) is not None or self.is_vector(inner)
            case _:
                return False

    def vector(self, tree: Tree) -> Vector:
        """The tree as a vector. Raises ProblemError if it is none."""
        match tree:
            case Name():
                return self._named_vector(tree)
            case BracketedList(items=items):
                return self._listed(tree, items)
            case Primed(operand=inner, order=order):
                self._check_order(order, tree)
                vector = self.vector(inner)
                with self.report.blaming(tree):
                    for _ in range(order):
                        vector = self._arithmetic.rate_of_vector(vector)
                return vector
            case Sum(terms=terms):
                return self._vector_sum(tree, terms)
            case Product(factors=factors):
                crossed = self._split_at(tree, "⨯")
                return self._scaled(tree, factors) if crossed is None else self._crossed(tree, *crossed)
            case Call(name="cross"):
                a, b = self._vectors(tree, 2)
                with self.report.blaming(tree):
                    return self._arithmetic.cross(a, b)
            case Call(name="diff", arguments=(inner, _)) if self._can_be_vector(inner):
                return self._differentiated(tree)
            case Call(arguments=(inner,)) if tree.name in DIFFERENTIALS and self.is_vector(tree):
                return self.virtual_rotation(tree) or self._displacement(tree, self.vector(inner))
        return self._zero_vector(self.scalar(tree), tree, "a scalar")

    def _dotted(self, tree: Product) -> tuple[Tree, Tree] | None:
        """The two vectors of which a product with ⋅ is the scalar product; None if it is none."""
        return self._split_at(tree, "⋅")

    def _split_at(self, tree: Product, sign: str) -> tuple[Tree, Tree] | None:
        """The factors before and after the last ⋅ or ⨯ of a product, if both parts are vectors."""
        factors = tree.factors
        at = next((n for n in range(len(factors) - 1, 0, -1) if factors[n][0] == sign), 0)
        if not at:
            return None
        left, right = self._product_of(factors[:at]), self._product_of((("*", factors[at][1]), *factors[at + 1 :]))
        return (left, right) if self.is_vector(left) and self.is_vector(right) else None

    def _product_of(self, factors: FactorTrees) -> Tree:
        first, last = factors[0][1], factors[-1][1]
        return first if len(factors) == 1 else Product(factors, first.start, last.end)

    def _crossed(self, blamed: Tree, a: Tree, b: Tree) -> Vector:
        left, right = self.vector(a), self.vector(b)
        with self.report.blaming(blamed):
            return self._arithmetic.cross(left, right)

    def virtual_rotation(self, tree: Tree) -> Vector | None:
        """delta(pi_B), a virtual rotation and not the variation of a vector, where a derivation has defined it."""
        match tree:
            case Call(name="delta", arguments=(Name(text=text),)):
                return self.scope.vectors.get(f"delta({text})")
        return None

    def _displacement(self, call: Call, vector: Vector) -> Vector:
        """d(a) = Σ (∂a/∂q) dq + (∂a/∂t) dt, and delta(a), where time is frozen."""
        slots, dt = self.scope.slots, differential(t)
        make = differential if call.name == "d" else variation
        rates: dict[sp.Symbol, sp.Expr] = {q: make(q) for q in slots.coordinates}
        if call.name == "d":
            moving = (
                prime(u, order) if order else u for u in slots.prescribed for order in range(HIGHEST_PRESCRIBED_RATE)
            )
            rates |= {t: dt} | {u: prime(u) * dt for u in moving}
        with self.report.blaming(call):
            return self._arithmetic.change_of_vector(vector, rates)

    def _named_vector(self, name: Name) -> Vector:
        vector = self.scope.vector(name.text)
        if vector is not None:
            return vector
        unit = self.scope.unit(name.text)
        if unit is None:
            return self._zero_vector(self.scalar(name), name, f"the scalar `{name.text}`")
        axis = "xyz"["ijk".index(name.text)]
        message = f"`{name.text}` is the unit vector here, not the symbol of that name"
        self.report.note(message, name, f"`e_{axis}` always is the unit vector")
        return unit

    def _listed(self, tree: BracketedList, items: tuple[Tree, ...]) -> Vector:
        if len(items) not in (2, 3):
            message = f"a vector has two or three components, not {len(items)}"
            raise self.report.error(
                "components", message, tree, "write `[x, y]` or `[x, y, z]`; group with parentheses"
            )
        a, b, c = [*(self.scalar(item) for item in items), sp.S.Zero][:3]
        return Vector((a, b, c))

    def _vector_sum(self, tree: Sum, terms: tuple[tuple[int, Tree], ...]) -> Vector:
        vectors = [self.vector(term) if sign > 0 else -self.vector(term) for sign, term in terms]
        with self.report.blaming(tree):
            return self._arithmetic.sum_of_vectors(vectors)

    def _scaled(self, tree: Product, factors: FactorTrees) -> Vector:
        """A product with exactly one vector among its factors."""
        for operator, factor in factors:
            if operator == "/" and self.is_vector(factor):
                help_ = "divide by its length, `norm(a)`"
                raise self.report.error("division-by-vector", "this divides by a vector", factor, help_)
        vectors = [n for n, (_, f) in enumerate(factors) if self.is_vector(f)]
        if len(vectors) > 1:
            help_ = "write `dot(a, b)` or `cross(a, b)`"
            place = factors[vectors[1]][1]
            raise self.report.error("product-of-vectors", "two vectors are multiplied", place, help_)
        if not vectors:
            vectors = [n for n, (op, f) in enumerate(factors) if op == "*" and self._can_be_vector(f)]
        if not vectors:
            return self._zero_vector(self._product(tree, factors), tree, "a scalar")
        chosen = vectors[-1]
        others = self._product(tree, tuple(f for n, f in enumerate(factors) if n != chosen))
        vector = self.vector(factors[chosen][1])
        with self.report.blaming(tree):
            return self._arithmetic.scaled(vector, others)

    def _can_be_vector(self, tree: Tree) -> bool:
        """Whether a factor is a vector once a declared `k` is read as the unit vector."""
        match tree:
            case Name(text=text):
                return text in UNITS or self.is_vector(tree)
            case Sum(terms=terms):
                return all(self._can_be_vector(term) for _, term in terms)
            case Product(factors=factors):
                return any(op == "*" and self._can_be_vector(f) for op, f in factors)
            case Primed(operand=inner) | Call(name="diff", arguments=(inner, _)):
                return self._can_be_vector(inner)
            case _:
                return self.is_vector(tree)

    def _differentiated(self, call: Call) -> Vector:
        tree, by = self._derivative_parts(call)
        vector = self.vector(tree)
        with self.report.blaming(call):
            if isinstance(by, Name) and by.text == "t":
                return self._arithmetic.rate_of_vector(vector)
            return self._arithmetic.partial_of_vector(vector, self._variable(by))

    def _zero_vector(self, value: sp.Expr, tree: Tree, what: str) -> Vector:
        """The zero vector for a scalar that is 0; any other scalar is an error."""
        if value == 0:
            return Vector.zero()
        help_ = "write components along unit vectors, `x*i + y*j`, or a list `[x, y]`"
        units = self._names & set(UNITS)
        if any(self.scope.scalar(n) is not None for n in units):
            help_ += "; `e_x`, `e_y`, `e_z` always are unit vectors"
        elif units:
            help_ += "; `i`, `j`, `k` are unit vectors unless they are declared"
        raise self.report.error("scalar-for-vector", f"{what} is used where a vector is expected", tree, help_)
