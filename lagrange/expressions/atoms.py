"""The innermost parts of an expression: numbers, names, brackets, and functions with what they are applied
to.

    atom := number | name | name "(" sum { "," sum } ")" | function [ "^" number ] argument
          | "(" sum ")" | "[" sum { "," sum } "]" | "|" sum "|"

A function without parentheses takes the product that follows, as books print it: numbers and constants, and one
coordinate or t. `sin 2 theta cos theta` is sin(2 theta) cos(theta), `sin theta theta''` is sin(theta) theta'', and
`sin theta/2` is sin(theta)/2. Bars are read in pairs, from the left.
"""

from __future__ import annotations

from abc import abstractmethod

from lagrange.core.diagnostics import Fragment, ProblemError
from lagrange.expressions.lexicon import FUNCTIONS, OPERATIONS, Lexicon, Role
from lagrange.expressions.stream import TokenStream
from lagrange.expressions.tokens import Kind, Token
from lagrange.expressions.trees import Bars, Call, Components, Name, Number, Power, Primed, Product, Sum, Tree

_MOVING = (Role.COORDINATE, Role.PRESCRIBED)


class AtomParser(TokenStream):
    """Reads atoms; what stands inside them is left to the parser of sums."""

    def __init__(self, fragment: Fragment, found: list[Token], lexicon: Lexicon) -> None:
        super().__init__(fragment, found, lexicon)
        self._in_bars = False
        self._closed_bars = 0

    @abstractmethod
    def _sum(self) -> Tree:
        """What may stand in brackets."""

    @abstractmethod
    def _factor_without_sign(self) -> Tree:
        """An atom with its primes and its exponent."""

    def _atom(self) -> Tree:
        token = self._here
        if token.kind is Kind.NUMBER:
            self._step()
            return Number(token.text, token.start, token.end)
        if token.kind is Kind.NAME:
            return self._named()
        if self._is("("):
            return self._parenthesis()
        if self._is("["):
            items = self._list("]")
            return Components(items, token.start, self._last_end)
        if self._is("|"):
            return self._between_bars()
        raise self._unexpected()

    def _parenthesis(self) -> Tree:
        opening, bars = self._open()
        tree = self._sum()
        if self._is(","):
            message = "a list of components stands in brackets"
            raise self._mistake("list-in-parentheses", message, self._here, "write `[a, b]`")
        self._close(")", opening, bars)
        return tree

    def _between_bars(self) -> Tree:
        opening, bars = self._open(in_bars=True)
        tree = self._sum()
        self._close("|", opening, bars)
        self._closed_bars += 1
        return Bars(tree, opening.start, self._last_end)

    def _named(self) -> Tree:
        token = self._here
        self._step()
        if token.text in FUNCTIONS:
            return self._function(token)
        if self._is("(") and self._is_applied(token.text):
            return self._applied(token)
        return Name(token.text, token.start, token.end)

    def _role(self, name: str) -> Role:
        return self.lexicon.role(name)

    def _is_applied(self, name: str) -> bool:
        """Whether `name(...)` is an application and not a product."""
        return name in OPERATIONS or self._role(name) in (Role.UNDECLARED, Role.FUNCTION)

    def _applied(self, token: Token) -> Call:
        arguments = self._list(")")
        return Call(token.text, arguments, token.start, self._last_end, token.end)

    # -- functions -------------------------------------------------------------------------------------------

    def _function(self, token: Token) -> Tree:
        exponent = self._function_exponent(token)
        if self._here.kind is Kind.PRIMES:
            help_ = f"write `{token.text}(x)'` for the time derivative"
            raise self._mistake("misplaced-prime", f"`{token.text}` takes no prime", self._here, help_)
        call = self._applied(token) if self._is("(") else self._bare_function(token)
        return call if exponent is None else Power(call, exponent, token.start, self._last_end)

    def _function_exponent(self, token: Token) -> Number | None:
        """The 2 of `sin^2(theta)`."""
        if not self._is("^"):
            return None
        self._step()
        bracketed = self._is("(") and self._ahead(2).text == ")"
        self._step(bracketed)
        number = self._here
        if not number.text.isdigit():
            inverse = f"a{token.text}"
            help_ = f"write `{token.text}(x)^n`"
            if self._is("-") and inverse in FUNCTIONS:
                help_ = f"the inverse function is `{inverse}`, the reciprocal `1/{token.text}(x)`"
            message = f"an exponent behind `{token.text}` must be a whole number"
            raise self._mistake("function-exponent", message, number, help_)
        self._step(1 + bracketed)
        return Number(number.text, number.start, number.end)

    def _bare_function(self, token: Token) -> Call:
        """A function and the product that follows it."""
        self._enter(token)
        start = self._here.start
        sign = self._sign_of_argument(token)
        factors: list[Tree] = []
        while self._continues_argument(factors, token):
            factors.append(self._factor_without_sign())
        if not factors:
            raise self._no_argument(token)
        self._depth -= 1
        tree: Tree = factors[0]
        if len(factors) > 1:
            tree = Product(tuple(("*", f) for f in factors), start, self._last_end)
        if sign < 0:
            tree = Sum(((-1, tree),), start, self._last_end)
        call = Call(token.text, (tree,), token.start, self._last_end, token.end)
        self._note_surprise(token, factors, call)
        return call

    def _sign_of_argument(self, function: Token) -> int:
        """A minus that touches the argument belongs to it (`sin -x`); one that stands apart does not (`sin - x`)."""
        if not (self._is("+") or self._is("-")):
            return 1
        sign, behind = self._here, self._ahead(1)
        if sign.text == "+" or behind.start != sign.end or behind.kind is Kind.END:
            raise self._no_argument(function)
        self._step()
        return -1

    def _no_argument(self, function: Token) -> ProblemError:
        help_ = f"write `{function.text}(...)`"
        if self._is("-"):
            help_ += f", or `{function.text}(-...)` if the minus belongs to the argument"
        return self._mistake("no-argument", f"`{function.text}` has no argument", function, help_)

    def _continues_argument(self, factors: list[Tree], function: Token) -> bool:
        token = self._here
        if function.tight and factors:
            return False
        if token.kind is Kind.NUMBER:
            if factors:
                raise self._number_behind_factor()
            return True
        if token.kind is Kind.NAME:
            return not factors or not self._ends_argument(factors, token, function)
        return (self._is("(") and all(isinstance(f, Number) for f in factors)) or (
            self._is("|") and not factors and not self._in_bars
        )

    def _ends_argument(self, factors: list[Tree], token: Token, function: Token) -> bool:
        """Whether a name begins the next factor: `sin theta cos phi`, `sin theta i`, `sin theta d(x)`, `cos phi phi''`.

        A root has no end that books would print without a bar or brackets; it goes on.
        """
        if function.text != "sqrt" and (self._moves(factors[-1]) or self._is_derivative(factors)):
            return True
        return self._stands_apart(token.text)

    def _stands_apart(self, name: str) -> bool:
        """Whether a name is applied to what follows it, or a vector."""
        if name in FUNCTIONS or name in OPERATIONS or self._role(name) is Role.VECTOR:
            return True
        return self._ahead(1).text == "(" and self._is_applied(name)

    def _moves(self, factor: Tree) -> bool:
        """Whether a factor of an argument is a coordinate or t, perhaps with primes or an exponent."""
        while isinstance(factor, Power | Primed):
            factor = factor.base if isinstance(factor, Power) else factor.operand
        return isinstance(factor, Name) and (factor.text == "t" or self._role(factor.text) in _MOVING)

    def _is_derivative(self, factors: list[Tree]) -> bool:
        """Whether a name with primes stands here, behind a symbol."""
        return self._ahead(1).kind is Kind.PRIMES and not all(isinstance(f, Number) for f in factors)

    def _note_surprise(self, token: Token, factors: list[Tree], call: Call) -> None:
        """Says what the argument is, where another reader might end it elsewhere."""
        last, help_ = factors[-1], f"write `{token.text}(...)` around what belongs to it"
        symbols = [f for f in factors if not isinstance(f, Number)]
        time = isinstance(last, Name) and last.text == "t"
        argument = call.arguments[0]
        root_of_product = token.text == "sqrt" and len(factors) > 1
        negative = isinstance(argument, Sum)
        if isinstance(last, (Primed, Power)) or root_of_product or negative or (len(symbols) > 1 and not time):
            function = "sqrt" if token.tight else self._text(token.start, argument.start)
            reading = f"{function}({self._text(argument.start, call.end)})"
            self._read_as(token.start, call.end, reading, help_)
        elif self._is("(") or (self._is("/") and not token.tight) or self._is_cut_short(token):
            message = f"the argument of `{token.text}` ends before the `{self._here.text}`"
            self._note(token.start, self._here.end, message, help_)

    def _is_cut_short(self, function: Token) -> bool:
        """Whether the argument ends before a symbol that it might have had."""
        if self._here.kind is not Kind.NAME or function.tight:
            return self._here.kind is Kind.NAME
        return not self._stands_apart(self._here.text) and self._ahead(1).kind is not Kind.PRIMES

    # -- brackets --------------------------------------------------------------------------------------------

    def _open(self, in_bars: bool = False) -> tuple[Token, bool]:
        """Steps into brackets; the opening token, and whether bars were open around them."""
        opening, bars = self._here, self._in_bars
        self._enter(opening)
        self._step()
        self._in_bars = in_bars
        self._not_empty_behind(opening)
        return opening, bars

    def _not_empty_behind(self, opening: Token) -> None:
        """Something stands between a bracket, or a comma, and the bracket that closes."""
        if self._here.kind is Kind.OPERATOR and self._here.text in (")", "]"):
            message = f"nothing stands behind this `{opening.text}`"
            raise self._mistake("empty-brackets", message, opening, "write an expression there")

    def _list(self, closing: str) -> tuple[Tree, ...]:
        opening, bars = self._open()
        items = [self._sum()]
        while self._is(","):
            comma = self._here
            self._step()
            self._not_empty_behind(comma)
            items.append(self._sum())
        self._close(closing, opening, bars)
        return tuple(items)

    def _close(self, bracket: str, opening: Token, bars: bool) -> None:
        if self._ends:
            message = f"this `{opening.text}` is not closed"
            raise self._mistake("not-closed", message, opening, f"add `{bracket}`")
        if not self._is(bracket):
            if self._here.text in (")", "]", "|"):
                message = f"`{opening.text}` is closed by `{self._here.text}`"
                raise self._mistake("not-closed", message, self._here, f"write `{bracket}`")
            raise self._unexpected()
        self._step()
        self._depth -= 1
        self._in_bars = bars

    # -- signs and numbers -----------------------------------------------------------------------------------

    def _signs(self) -> int:
        sign = 1
        while self._is("+") or self._is("-"):
            sign = -sign if self._here.text == "-" else sign
            self._step()
        return sign

    def _number_behind_factor(self) -> ProblemError:
        number, before = self._here, self.tokens[self._at - 1]
        start = self.tokens[self._at - 2].start if before.kind is Kind.PRIMES else before.start
        message = f"a number follows `{self._text(start, before.end)}` without an operator"
        if "/" in number.text:
            help_ = f"write `+ {number.text}` for a sum, `*{number.text}` for a product"
        elif before.kind is Kind.NUMBER:
            help_ = "digits are not separated by spaces, and a product is written `*`"
        else:
            help_ = f"write `*{number.text}` for a product, `^{number.text}` for a power"
        return self._mistake("missing-operator", message, number, help_)
