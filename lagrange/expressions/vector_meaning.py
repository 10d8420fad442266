"""A syntax tree -> the vector that it means: a linear combination of unit vectors, or a list of components.

Where a vector is expected and a file declares `k` (or `i`, `j`) as a scalar, the name means the scalar inside
component lists, arguments of scalar functions, exponents and divisors, and in a term that has another vector;
otherwise the unit vector, and a note says so. In a term with several, `k*k`, the last one is the unit vector.
"""

from __future__ import annotations

import sympy as sp

from lagrange.core.symbols import differential, prime, t, variation
from lagrange.core.vectors import Vector
from lagrange.expressions.bounded import HIGHEST_PRESCRIBED_RATE
from lagrange.expressions.meaning import DIFFERENTIALS, ScalarMeaning
from lagrange.expressions.scope import UNITS
from lagrange.expressions.trees import Call, Components, Name, Primed, Product, Sum, Tree

Factors = tuple[tuple[str, Tree], ...]


class Meaning(ScalarMeaning):
    """What the trees of one text mean, as scalars and as vectors."""

    def is_vector(self, tree: Tree) -> bool:
        """Whether a tree is a vector beyond doubt: a declared `k` counts as the scalar."""
        match tree:
            case Name(text=text):
                return self.scope.vector(text) is not None
            case Components() | Call(name="cross"):
                return True
            case Primed(operand=inner):
                return self.is_vector(inner)
            case Sum(terms=terms):
                return any(self.is_vector(term) for _, term in terms)
            case Product(factors=factors):
                return self.dotted(tree) is None and any(self.is_vector(f) for _, f in factors)
            case Call(name="diff", arguments=arguments):
                return self.is_vector(arguments[0])
            case Call(name=name, arguments=(inner,)) if name in DIFFERENTIALS and name not in self.scope.functions:
                return self.virtual_rotation(tree) is not None or self.is_vector(inner)
            case _:
                return False

    def vector(self, tree: Tree) -> Vector:
        """The tree as a vector. Raises ProblemError where it is none."""
        match tree:
            case Name():
                return self._named_vector(tree)
            case Components(items=items):
                return self._listed(tree, items)
            case Primed(operand=inner, order=order):
                self.check_order(order, tree)
                vector = self.vector(inner)
                with self.blaming(tree):
                    for _ in range(order):
                        vector = self.arithmetic.rate_of_vector(vector)
                return vector
            case Sum(terms=terms):
                return self._vector_sum(tree, terms)
            case Product(factors=factors):
                crossed = self._parted(tree, "⨯")
                return self._scaled(tree, factors) if crossed is None else self._crossed(tree, *crossed)
            case Call(name="cross"):
                a, b = self.vectors(tree, 2)
                with self.blaming(tree):
                    return self.arithmetic.cross(a, b)
            case Call(name="diff", arguments=(inner, _)) if self._can_be_vector(inner):
                return self._differentiated(tree)
            case Call(arguments=(inner,)) if tree.name in DIFFERENTIALS and self.is_vector(tree):
                return self.virtual_rotation(tree) or self._displacement(tree, self.vector(inner))
        return self._zero_or_mistake(self.scalar(tree), tree, "a scalar")

    def dotted(self, tree: Product) -> tuple[Tree, Tree] | None:
        """The two vectors of which a product with ⋅ is the scalar product; None where it is none."""
        return self._parted(tree, "⋅")

    def _parted(self, tree: Product, sign: str) -> tuple[Tree, Tree] | None:
        """What stands before and behind the last ⋅ or ⨯ of a product, if both are vectors."""
        factors = tree.factors
        at = next((n for n in range(len(factors) - 1, 0, -1) if factors[n][0] == sign), 0)
        if not at:
            return None
        before, behind = (
            self._product_of(part) for part in (factors[:at], (("*", factors[at][1]), *factors[at + 1 :]))
        )
        return (before, behind) if self.is_vector(before) and self.is_vector(behind) else None

    def _product_of(self, factors: Factors) -> Tree:
        first, last = factors[0][1], factors[-1][1]
        return first if len(factors) == 1 else Product(factors, first.start, last.end)

    def _crossed(self, whole: Tree, a: Tree, b: Tree) -> Vector:
        left, right = self.vector(a), self.vector(b)
        with self.blaming(whole):
            return self.arithmetic.cross(left, right)

    def virtual_rotation(self, tree: Tree) -> Vector | None:
        """delta(pi_B), which is no variation of a vector, where a derivation has given it a meaning."""
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
        with self.blaming(call):
            return self.arithmetic.change_of_vector(vector, rates)

    def _named_vector(self, name: Name) -> Vector:
        vector = self.scope.vector(name.text)
        if vector is not None:
            return vector
        unit = self.scope.unit(name.text)
        if unit is None:
            return self._zero_or_mistake(self.scalar(name), name, f"the scalar `{name.text}`")
        axis = "xyz"["ijk".index(name.text)]
        message = f"`{name.text}` is the unit vector here, not the symbol of that name"
        self.note(message, name, f"`e_{axis}` always is the unit vector")
        return unit

    def _listed(self, tree: Components, items: tuple[Tree, ...]) -> Vector:
        if len(items) not in (2, 3):
            message = f"a vector has two or three components, not {len(items)}"
            raise self.mistake("components", message, tree, "write `[x, y]` or `[x, y, z]`; group with parentheses")
        a, b, c = [*(self.scalar(item) for item in items), sp.S.Zero][:3]
        return Vector((a, b, c))

    def _vector_sum(self, tree: Sum, terms: tuple[tuple[int, Tree], ...]) -> Vector:
        vectors = [self.vector(term) if sign > 0 else -self.vector(term) for sign, term in terms]
        with self.blaming(tree):
            return self.arithmetic.sum_of_vectors(vectors)

    def _scaled(self, tree: Product, factors: Factors) -> Vector:
        """A product with exactly one vector among its factors."""
        for operator, factor in factors:
            if operator == "/" and self.is_vector(factor):
                help_ = "divide by its length, `norm(a)`"
                raise self.mistake("division-by-vector", "this divides by a vector", factor, help_)
        vectors = [n for n, (_, f) in enumerate(factors) if self.is_vector(f)]
        if len(vectors) > 1:
            help_ = "write `dot(a, b)` or `cross(a, b)`"
            place = factors[vectors[1]][1]
            raise self.mistake("product-of-vectors", "two vectors are multiplied", place, help_)
        if not vectors:
            vectors = [n for n, (op, f) in enumerate(factors) if op == "*" and self._can_be_vector(f)]
        if not vectors:
            return self._zero_or_mistake(self.product(tree, factors), tree, "a scalar")
        chosen = vectors[-1]
        others = self.product(tree, tuple(f for n, f in enumerate(factors) if n != chosen))
        vector = self.vector(factors[chosen][1])
        with self.blaming(tree):
            return self.arithmetic.scaled(vector, others)

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
        tree, by = self.derivative_parts(call)
        vector = self.vector(tree)
        with self.blaming(call):
            if isinstance(by, Name) and by.text == "t":
                return self.arithmetic.rate_of_vector(vector)
            return self.arithmetic.partial_of_vector(vector, self.variable(by))

    def _zero_or_mistake(self, value: sp.Expr, tree: Tree, what: str) -> Vector:
        """The vector 0, where a scalar is 0."""
        if value == 0:
            return Vector.zero()
        help_ = "write components along unit vectors, `x*i + y*j`, or a list `[x, y]`"
        units = self.names & set(UNITS)
        if any(self.scope.scalar(n) is not None for n in units):
            help_ += "; `e_x`, `e_y`, `e_z` always are unit vectors"
        elif units:
            help_ += "; `i`, `j`, `k` are unit vectors unless they are declared"
        raise self.mistake("scalar-for-vector", f"{what} stands where a vector belongs", tree, help_)
