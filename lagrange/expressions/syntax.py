"""Tokens -> a syntax tree, by precedence.

    equation := sum "=" sum
    sum      := ["+" | "-"] term { ("+" | "-") term }
    term     := factor { ("*" | "/" | "⋅" | "⨯") factor | factor }    juxtaposition multiplies, from left to right
    factor   := { "-" | "+" } base [ "^" factor ]
    base     := atom { primes }

Atoms are read by `atoms`. Where a reading could surprise, a note says what was read. Every node has its place
in the text. Depth is limited, and reading takes time proportional to the length.
"""

from __future__ import annotations

from lagrange.expressions.atoms import AtomParser
from lagrange.expressions.lexicon import FUNCTIONS, OPERATIONS, Lexicon, Role
from lagrange.expressions.stream import MAX_NESTING
from lagrange.expressions.tokens import Kind, Token
from lagrange.expressions.trees import Name, Number, Power, Primed, Product, Sum, Tree

__all__ = ["FUNCTIONS", "MAX_NESTING", "OPERATIONS", "Lexicon", "Parser", "Role"]


class Parser(AtomParser):
    """One reading of one list of tokens. Surprising readings go to `notes`."""

    def expression(self) -> Tree:
        """The whole text as one expression."""
        self._not_empty("expression", "write an expression")
        tree = self._sum()
        if self._is("="):
            message = "an expression is expected here, not an equation"
            raise self._mistake("unexpected-equation", message, self._here, "keep one side of it")
        self._at_end()
        return tree

    def equation(self) -> tuple[Tree, Tree]:
        """The whole text as one equation."""
        self._not_empty("equation", "write `left = right`")
        left = self._side("left")
        if self._ends:
            raise self._mistake("no-equals-sign", "an equation needs a `=`", self._here, "write `... = 0`")
        if not self._is("="):
            raise self._unexpected()
        self._step()
        right = self._side("right")
        if self._is("="):
            help_ = "write one equation at a time"
            raise self._mistake("several-equals-signs", "a second `=`", self._here, help_)
        self._at_end()
        return left, right

    def _side(self, which: str) -> Tree:
        if self._is("=") or self._ends:
            message = f"the {which} side of the equation is empty"
            raise self._mistake("empty-side", message, self._here, "write 0 where nothing is left")
        return self._sum()

    def _not_empty(self, what: str, help_: str) -> None:
        if self._ends:
            raise self._mistake("empty-expression", f"the {what} is empty", self._here, help_)

    def _at_end(self) -> None:
        if not self._ends:
            raise self._unexpected()

    # -- sums, products, powers ------------------------------------------------------------------------------

    def _sum(self) -> Tree:
        start = self._here.start
        terms = [(self._signs(), self._term())]
        while self._is("+") or self._is("-"):
            terms.append((self._signs(), self._term()))
        if len(terms) == 1 and terms[0][0] == 1:
            return terms[0][1]
        return Sum(tuple(terms), start, self._last_end)

    def _term(self) -> Tree:
        start, slash = self._here.start, 0
        factors: list[tuple[str, Tree]] = [("*", self._factor())]
        while True:
            operator, begins = "*", self._here
            if self._operator in ("*", "/", "⋅", "⨯"):
                operator = begins.text
                self._step()
                slash = begins.start if operator == "/" else 0
                factors.append((operator, self._factor()))
            elif self._begins_factor():
                if begins.text == "|" and self._closed_bars:
                    message = "bars are read in pairs, from the left"
                    help_ = "write `abs(...)` where bars could be read in two ways"
                    self._note(start, begins.end, message, help_)
                factors.append((operator, self._factor()))
                self._note_quotient(start, slash, factors[-2][1], begins)
                slash = 0
            else:
                break
        if len(factors) == 1:
            return factors[0][1]
        return Product(tuple(factors), start, self._last_end)

    def _note_quotient(self, start: int, slash: int, before: Tree, begins: Token) -> None:
        """Says how `a/b c` was read; `1/2 m` is as it looks, `1/2m` is not."""
        if slash and not (isinstance(before, Number) and self.fragment.text[begins.start - 1].isspace()):
            quotient, divisor = self._text(start, begins.start), self._text(slash + 1, begins.start)
            factor = self._text(begins.start, self._last_end)
            help_ = f"for the other reading write `{self._text(start, slash)}/({divisor} {factor})`"
            self._read_as(start, self._last_end, f"({quotient})*{factor}", help_)

    def _begins_factor(self) -> bool:
        token = self._here
        if token.kind is Kind.NUMBER:
            raise self._number_behind_factor()
        if token.kind is Kind.NAME:
            return True
        return token.kind is Kind.OPERATOR and (token.text in ("(", "[") or (token.text == "|" and not self._in_bars))

    def _factor(self) -> Tree:
        start = self._here.start
        sign = self._signs()
        factor = self._factor_without_sign()
        return Sum(((-1, factor),), start, self._last_end) if sign < 0 else factor

    def _factor_without_sign(self) -> Tree:
        start = self._here.start
        base = self._base()
        if not self._is("^"):
            return base
        opening = self._here
        self._step()
        self._enter(opening)
        exponent = self._factor()
        self._depth -= 1
        if isinstance(exponent, Number) and exponent.text == "1" and self._is("/"):
            written = self._text(start, self._last_end)
            message = f"the exponent of `{written}` ends before the `/`"
            self._note(start, self._here.end, message, "write `x^(1/2)` for a root")
        return Power(base, exponent, start, self._last_end)

    def _base(self) -> Tree:
        start = self._here.start
        tree = self._atom()
        self._before_parenthesis(tree)
        order = 0
        while self._here.kind is Kind.PRIMES:
            order += self._here.count
            self._step()
        if order:
            primed = Primed(tree, order, start, self._last_end)
            self._check_primed(tree, primed)
            self._before_parenthesis(primed)
            return primed
        return tree

    def _check_primed(self, tree: Tree, primed: Primed) -> None:
        if not isinstance(tree, Name) or self._role(tree.text) is not Role.FUNCTION:
            return
        name = tree.text
        if self._is("("):
            message = f"`{name}'(...)` could be a derivative by the argument or by the time"
            help_ = f"write `diff({name}(x), x)` for the one, `({name}(x))'` for the other"
            raise self._mistake("prime-of-function", message, primed, help_)
        help_ = f"`diff({name}, X)` is the derivative by the argument X"
        self._note(primed.start, primed.end, f"`{name}'` is the time derivative of `{name}`", help_)

    def _before_parenthesis(self, tree: Tree) -> None:
        """`x(t)` and `x'(t)` are x and x'; other names multiply what stands in parentheses behind them."""
        name = tree.operand if isinstance(tree, Primed) else tree
        if not isinstance(name, Name) or not self._is("("):
            return
        role, inside = self._role(name.text), self._single_inside()
        if role in (Role.COORDINATE, Role.PRESCRIBED) and inside == "t":
            self._step(3)
        elif role is Role.PRESCRIBED and not self._is_product_in_latex():
            message = f"`{name.text}` is a function of `t` alone"
            help_ = f"write `{name.text}` or `{name.text}(t)`; a product is written `{name.text}*(...)`"
            raise self._mistake("argument-of-prescribed", message, self._here, help_)
        elif inside:
            written = self._text(tree.start, self._last_end)
            help_ = "a symbol before a parenthesis multiplies"
            self._read_as(tree.start, self._ahead(2).end, f"{written}*{inside}", help_)

    def _is_product_in_latex(self) -> bool:
        r"""Whether more than one thing stands in the parentheses, in LaTeX: `l (\ddot{l} + g)`, no sign being usual."""
        return "\\" in self.fragment.text and self._ahead(2).text != ")"

    def _single_inside(self) -> str:
        """`t` or a number, if that alone stands in the parentheses that open here."""
        inside, closing = self._ahead(1), self._ahead(2)
        alone = inside.text == "t" or inside.kind is Kind.NUMBER
        return inside.text if alone and closing.text == ")" else ""
