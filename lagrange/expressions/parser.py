"""Tokens -> a syntax tree, by recursive descent.

    equation := sum "=" sum
    sum      := ["+" | "-"] term { ("+" | "-") term }
    term     := factor { ("*" | "/" | "⋅" | "⨯") factor | factor }    juxtaposition multiplies, from left to right
    factor   := { "-" | "+" } base [ "^" factor ]
    base     := atom { primes }
    atom     := number [ "deg" ] | name | name "(" sum { "," sum } ")" | function [ "^" number ] argument
              | "(" sum ")" | "[" sum { "," sum } "]" | "|" sum "|"

A function without parentheses takes the product that follows, as books print it: numbers and constants, up to and
including one coordinate or t. `sin 2 theta cos theta` is sin(2 theta) cos(theta), `sin theta theta''` is
sin(theta) theta'', and `sin theta/2` is sin(theta)/2. Bars are paired from the left. A reading that could surprise
is reported in a note. Nesting is bounded, and the time is proportional to the length of the text.
"""

from __future__ import annotations

from collections.abc import Sequence

from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError, Severity
from lagrange.expressions.limits import MAX_NESTING
from lagrange.expressions.syntax_tree import (
    DEGREES,
    FUNCTIONS,
    OPERATIONS,
    Bars,
    BracketedList,
    Call,
    Lexicon,
    Name,
    NumberLiteral,
    Power,
    Primed,
    Product,
    Role,
    Sum,
    Tree,
)
from lagrange.expressions.tokens import Token, TokenKind

_MOVING = (Role.COORDINATE, Role.PRESCRIBED)
_HELP_FOR_MISPLACED = {
    ",": "a decimal point is `.`; a comma separates arguments and components",
    "=": "an equation has one `=`, outside parentheses",
    "|": "write `abs(...)` where bars are nested",
}


def _power_at_the_end(call: Call) -> Power | None:
    """`sin x^2` as (sin x)^2; None if the argument does not end with a power."""
    (argument, *others) = call.arguments
    last = argument.factors[-1][1] if isinstance(argument, Product) else argument
    if others or not isinstance(last, Power) or not isinstance(last.exponent, NumberLiteral):
        return None
    whole: Tree = last.base
    if isinstance(argument, Product):
        factors = (*argument.factors[:-1], (argument.factors[-1][0], last.base))
        whole = Product(factors, argument.start, argument.end)
    return Power(Call(call.name, (whole,), call.start, call.end, call.name_end), last.exponent, call.start, call.end)


class Parser:
    """One parse of one list of tokens, which ends with END. Notes about surprising readings go to `notes`.

    other   read as people also write: in `a/b c` the c divides too, and in `sin x^2` the square is that of the sine
    doubts  whether the other reading differs
    """

    def __init__(self, fragment: Fragment, tokens: list[Token], lexicon: Lexicon, other: bool = False) -> None:
        self.other = other
        self.doubts = False
        self.fragment = fragment
        self.tokens = tokens
        self.lexicon = lexicon
        self.notes: list[Diagnostic] = []
        self._index = 0
        self._depth = 0
        self._in_bars = False
        self._closed_bars = 0
        self._advance(0)

    def expression(self) -> Tree:
        """Parse the whole text as one expression."""
        self._expect_content("expression", "write an expression")
        tree = self._sum()
        if self._is("="):
            message = "an expression is expected here, not an equation"
            raise self._error("unexpected-equation", message, self._token, "keep one side of it")
        self._expect_end()
        return tree

    def equation(self) -> tuple[Tree, Tree]:
        """Parse the whole text as one equation."""
        self._expect_content("equation", "write `left = right`")
        left = self._side("left")
        if self._at_end:
            raise self._error("no-equals-sign", "an equation needs a `=`", self._token, "write `... = 0`")
        if not self._is("="):
            raise self._unexpected()
        self._advance()
        right = self._side("right")
        if self._is("="):
            help_ = "write one equation at a time"
            raise self._error("several-equals-signs", "a second `=`", self._token, help_)
        self._expect_end()
        return left, right

    def _side(self, which: str) -> Tree:
        if self._is("=") or self._at_end:
            message = f"the {which} side of the equation is empty"
            raise self._error("empty-side", message, self._token, "write 0 where nothing is left")
        return self._sum()

    def _expect_content(self, what: str, help_: str) -> None:
        if self._at_end:
            raise self._error("empty-expression", f"the {what} is empty", self._token, help_)

    def _expect_end(self) -> None:
        if not self._at_end:
            raise self._unexpected()

    # -- sums, products, powers ------------------------------------------------------------------------------

    def _sum(self) -> Tree:
        start = self._token.start
        terms = [(self._signs(), self._term())]
        while self._is("+") or self._is("-"):
            terms.append((self._signs(), self._term()))
        if len(terms) == 1 and terms[0][0] == 1:
            return terms[0][1]
        return Sum(tuple(terms), start, self._last_end)

    def _term(self) -> Tree:
        start, slash = self._token.start, 0
        factors: list[tuple[str, Tree]] = [("*", self._factor())]
        while True:
            operator, first = "*", self._token
            if self._operator in ("*", "/", "⋅", "⨯"):
                operator = first.text
                self._advance()
                slash = first.start if operator == "/" else 0
                factors.append((operator, self._divisor() if slash and self.other else self._factor()))
            elif self._begins_factor():
                # Juxtaposition binds as `*` does, not more tightly: `a/b c` is (a/b) c, and a note says so. A bar
                # after a closed pair could have closed a larger pair: |a|b|c| is |a| b |c|.
                if first.text == "|" and self._closed_bars:
                    message = "bars are read in pairs, from the left"
                    help_ = "write `abs(...)` where bars could be read in two ways"
                    self._note(start, first.end, message, help_)
                factors.append((operator, self._factor()))
                self._note_quotient(start, slash, factors[-2][1], first)
                slash = 0
            else:
                break
        if len(factors) == 1:
            return factors[0][1]
        return Product(tuple(factors), start, self._last_end)

    def _divisor(self) -> Tree:
        """A divisor and all that adjoins it: in the other reading `a/b c` is a/(b c), and `a/4b c` is a/(4b) c."""
        start, touching = self._token.start, False
        factors: list[tuple[str, Tree]] = [("*", self._factor())]
        while self._token.kind is not TokenKind.NUMBER and self._begins_factor():
            adjoins = not self.fragment.text[self._token.start - 1].isspace()
            if touching and not adjoins:
                break
            touching = adjoins and (touching or len(factors) == 1)
            factors.append(("*", self._factor()))
        return factors[0][1] if len(factors) == 1 else Product(tuple(factors), start, self._last_end)

    def _note_quotient(self, start: int, slash: int, divisor: Tree, factor: Token) -> None:
        """Report how `a/b c` was read. `1/2 m` with its space is as it looks, `1/2m` is not."""
        self.doubts = self.doubts or bool(slash)
        if slash and not (isinstance(divisor, NumberLiteral) and self.fragment.text[factor.start - 1].isspace()):
            quotient, below = self._text(start, factor.start), self._text(slash + 1, factor.start)
            multiplied = self._text(factor.start, self._last_end)
            help_ = f"for the other reading write `{self._text(start, slash)}/({below} {multiplied})`"
            self._note_reading(start, self._last_end, f"({quotient})*{multiplied}", help_)

    def _begins_factor(self) -> bool:
        token = self._token
        if token.kind is TokenKind.NUMBER:
            raise self._number_after_factor()
        if token.kind is TokenKind.NAME:
            return True
        return token.kind is TokenKind.OPERATOR and (
            token.text in ("(", "[") or (token.text == "|" and not self._in_bars)
        )

    def _factor(self) -> Tree:
        start = self._token.start
        sign = self._signs()
        factor = self._factor_without_sign()
        return Sum(((-1, factor),), start, self._last_end) if sign < 0 else factor

    def _signs(self) -> int:
        sign = 1
        while self._is("+") or self._is("-"):
            sign = -sign if self._token.text == "-" else sign
            self._advance()
        return sign

    def _factor_without_sign(self) -> Tree:
        start = self._token.start
        base = self._base()
        if not self._is("^"):
            return base
        opening = self._token
        self._advance()
        self._enter(opening)
        exponent = self._factor()
        self._depth -= 1
        if isinstance(exponent, NumberLiteral) and exponent.text == "1" and self._is("/"):
            written = self._text(start, self._last_end)
            message = f"the exponent of `{written}` ends before the `/`"
            self._note(start, self._token.end, message, "write `x^(1/2)` for a root")
        return Power(base, exponent, start, self._last_end)

    def _base(self) -> Tree:
        start = self._token.start
        tree = self._atom()
        self._before_parenthesis(tree)
        order = 0
        while self._token.kind is TokenKind.PRIMES:
            order += self._token.count
            self._advance()
        if order:
            primed = Primed(tree, order, start, self._last_end)
            self._check_primed(tree, primed)
            self._before_parenthesis(primed)
            return primed
        return tree

    def _check_primed(self, tree: Tree, primed: Primed) -> None:
        """Refuse `f'(x)` and note `f'`: books write f' for df/dX, while a prime is d/dt everywhere in this language."""
        if not isinstance(tree, Name) or self._role(tree.text) is not Role.FUNCTION:
            return
        name = tree.text
        if self._is("("):
            message = f"`{name}'(...)` could be a derivative with respect to the argument or to time"
            help_ = f"write `diff({name}(x), x)` for the one, `({name}(x))'` for the other"
            raise self._error("prime-of-function", message, primed, help_)
        help_ = f"`diff({name}, X)` is the derivative with respect to the argument X"
        self._note(primed.start, primed.end, f"`{name}'` is the time derivative of `{name}`", help_)

    def _before_parenthesis(self, tree: Tree) -> None:
        """Read `x(t)` and `x'(t)` as x and x'; any other symbol multiplies the parenthesis that follows it."""
        name = tree.operand if isinstance(tree, Primed) else tree
        if not isinstance(name, Name) or not self._is("("):
            return
        role, inside = self._role(name.text), self._single_inside()
        if role in _MOVING and inside == "t":
            self._advance(3)
        elif role is Role.PRESCRIBED and not self._is_product_in_latex():
            message = f"`{name.text}` is a function of `t` alone"
            help_ = f"write `{name.text}` or `{name.text}(t)`; a product is written `{name.text}*(...)`"
            raise self._error("argument-of-prescribed", message, self._token, help_)
        elif inside:
            written = self._text(tree.start, self._last_end)
            help_ = "a symbol before a parenthesis multiplies"
            self._note_reading(tree.start, self._peek(2).end, f"{written}*{inside}", help_)

    def _is_product_in_latex(self) -> bool:
        r"""Whether a LaTeX parenthesis has several tokens: `l (\ddot{l} + g)`, where a sign is not usual."""
        return "\\" in self.fragment.text and self._peek(2).text != ")"

    def _single_inside(self) -> str:
        """`t` or a number, if that alone is in the parentheses that open here."""
        inside, closing = self._peek(1), self._peek(2)
        alone = inside.text == "t" or inside.kind is TokenKind.NUMBER
        return inside.text if alone and closing.text == ")" else ""

    # -- atoms -----------------------------------------------------------------------------------------------

    def _atom(self) -> Tree:
        token = self._token
        if token.kind is TokenKind.NUMBER:
            self._advance()
            number = NumberLiteral(token.text, token.start, token.end)
            return self._in_degrees(number) if self._token.text in DEGREES else number
        if token.kind is TokenKind.NAME:
            return self._named()
        if self._is("("):
            return self._parenthesis()
        if self._is("["):
            items = self._list("]")
            return BracketedList(items, token.start, self._last_end)
        if self._is("|"):
            return self._between_bars()
        raise self._unexpected()

    def _in_degrees(self, number: NumberLiteral) -> Tree:
        """`30 deg` is 30 pi/180, where no symbol is called `deg`."""
        if self._role(self._token.text) is not Role.UNDECLARED:
            return number
        self._advance()
        start, end = number.start, self._last_end
        two, right_angle = (NumberLiteral(n, start, end) for n in ("2", "90"))  # 180, of three digits, seems rounded
        pi = Name("pi", start, end)
        return Product((("*", number), ("*", pi), ("/", two), ("/", right_angle)), start, end)

    def _named(self) -> Tree:
        token = self._token
        self._advance()
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
        bare = not self._is("(") or self._token.hidden
        if self._token.kind is TokenKind.PRIMES:
            help_ = f"write `{token.text}(x)'` for the time derivative"
            raise self._error("misplaced-prime", f"`{token.text}` takes no prime", self._token, help_)
        call = self._applied(token) if self._is("(") else self._bare_function(token)
        if exponent is None and bare and token.text != "sqrt" and (power := _power_at_the_end(call)) is not None:
            self.doubts = True
            if self.other:
                return power
        return call if exponent is None else Power(call, exponent, token.start, self._last_end)

    def _function_exponent(self, token: Token) -> NumberLiteral | None:
        """The 2 of `sin^2(theta)`."""
        if not self._is("^"):
            return None
        self._advance()
        bracketed = self._is("(") and self._peek(2).text == ")"
        self._advance(bracketed)
        number = self._token
        if not number.text.isdigit():
            inverse = f"a{token.text}"
            help_ = f"write `{token.text}(x)^n`"
            if self._is("-") and inverse in FUNCTIONS:
                help_ = f"the inverse function is `{inverse}`, the reciprocal `1/{token.text}(x)`"
            message = f"the exponent of `{token.text}` must be an integer"
            raise self._error("function-exponent", message, number, help_)
        self._advance(1 + bracketed)
        return NumberLiteral(number.text, number.start, number.end)

    def _bare_function(self, token: Token) -> Call:
        """A function without parentheses and the product that it takes."""
        self._enter(token)
        start = self._token.start
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
        self._note_argument(token, factors, call)
        return call

    def _sign_of_argument(self, function: Token) -> int:
        """The sign of the argument. A minus that touches it belongs to it (`sin -x`), another does not (`sin - x`)."""
        if not (self._is("+") or self._is("-")):
            return 1
        sign, following = self._token, self._peek(1)
        if sign.text == "+" or following.start != sign.end or following.kind is TokenKind.END:
            raise self._no_argument(function)
        self._advance()
        return -1

    def _no_argument(self, function: Token) -> ProblemError:
        help_ = f"write `{function.text}(...)`"
        if self._is("-"):
            help_ += f", or `{function.text}(-...)` if the minus belongs to the argument"
        return self._error("no-argument", f"`{function.text}` has no argument", function, help_)

    def _continues_argument(self, factors: list[Tree], function: Token) -> bool:
        token = self._token
        if function.tight and factors:
            return False
        if token.kind is TokenKind.NUMBER:
            if factors:
                raise self._number_after_factor()
            return True
        if token.kind is TokenKind.NAME:
            return not factors or not self._ends_argument(factors, token, function)
        return (self._is("(") and all(isinstance(f, NumberLiteral) for f in factors)) or (
            self._is("|") and not factors and not self._in_bars
        )

    def _ends_argument(self, factors: list[Tree], token: Token, function: Token) -> bool:
        """Whether a name begins the next factor: `sin theta cos phi`, `sin theta i`, `sin theta d(x)`, `cos phi phi''`.

        A root has no end that books would print without a bar or brackets; it goes on.
        """
        if function.text != "sqrt" and (self._moves(factors[-1]) or self._is_derivative(factors)):
            return True
        return self._is_separate(token.text)

    def _is_separate(self, name: str) -> bool:
        """Whether a name is a separate factor: applied to what follows, or a vector."""
        if name in FUNCTIONS or name in OPERATIONS or self._role(name) is Role.VECTOR:
            return True
        return self._peek(1).text == "(" and self._is_applied(name)

    def _moves(self, factor: Tree) -> bool:
        """Whether a factor of an argument is a coordinate or t, perhaps with primes or an exponent."""
        while isinstance(factor, Power | Primed):
            factor = factor.base if isinstance(factor, Power) else factor.operand
        return isinstance(factor, Name) and (factor.text == "t" or self._role(factor.text) in _MOVING)

    def _is_derivative(self, factors: list[Tree]) -> bool:
        """Whether the name here has primes and follows a symbol: a velocity is seldom part of an angle."""
        return self._peek(1).kind is TokenKind.PRIMES and not all(isinstance(f, NumberLiteral) for f in factors)

    def _note_argument(self, token: Token, factors: list[Tree], call: Call) -> None:
        """Report the argument where another reader might end it elsewhere."""
        last, help_ = factors[-1], f"write `{token.text}(...)` around what belongs to it"
        symbols = [f for f in factors if not isinstance(f, NumberLiteral)]
        time = isinstance(last, Name) and last.text == "t"
        argument = call.arguments[0]
        root_of_product = token.text == "sqrt" and len(factors) > 1
        negative = isinstance(argument, Sum)
        if isinstance(last, (Primed, Power)) or root_of_product or negative or (len(symbols) > 1 and not time):
            function = "sqrt" if token.tight else self._text(token.start, argument.start)
            reading = f"{function}({self._text(argument.start, call.end)})"
            self._note_reading(token.start, call.end, reading, help_)
        elif self._is("(") or (self._is("/") and not token.tight) or self._is_cut_short(token, symbols):
            message = f"the argument of `{token.text}` ends before the `{self._token.text}`"
            self._note(token.start, self._token.end, message, help_)

    def _is_cut_short(self, function: Token, symbols: Sequence[Tree]) -> bool:
        """Whether the argument ends before a symbol that might have belonged to it, also in `sin w*t`, `sin 2*x`."""
        if self._is("*"):
            following = self._peek(1)
            is_factor = following.kind is TokenKind.NAME and not self._is_separate(following.text)
            return is_factor and (following.text == "t" or not symbols)
        if self._token.kind is not TokenKind.NAME or function.tight:
            return self._token.kind is TokenKind.NAME
        return not self._is_separate(self._token.text) and self._peek(1).kind is not TokenKind.PRIMES

    # -- brackets --------------------------------------------------------------------------------------------

    def _parenthesis(self) -> Tree:
        opening, in_bars = self._open()
        tree = self._sum()
        if self._is(","):
            message = "a list of components is written in square brackets"
            raise self._error("list-in-parentheses", message, self._token, "write `[a, b]`")
        self._close(")", opening, in_bars)
        return tree

    def _between_bars(self) -> Tree:
        opening, in_bars = self._open(in_bars=True)
        tree = self._sum()
        self._close("|", opening, in_bars)
        self._closed_bars += 1
        return Bars(tree, opening.start, self._last_end)

    def _list(self, closing: str) -> tuple[Tree, ...]:
        opening, in_bars = self._open()
        items = [self._sum()]
        while self._is(","):
            comma = self._token
            self._advance()
            self._expect_item(comma)
            items.append(self._sum())
        self._close(closing, opening, in_bars)
        return tuple(items)

    def _open(self, in_bars: bool = False) -> tuple[Token, bool]:
        """Step into brackets; the opening token, and whether bars were open around them."""
        opening, outer_bars = self._token, self._in_bars
        self._enter(opening)
        self._advance()
        self._in_bars = in_bars
        self._expect_item(opening)
        return opening, outer_bars

    def _expect_item(self, opening: Token) -> None:
        """Refuse a bracket, or a comma, that is followed by the closing bracket."""
        if self._token.kind is TokenKind.OPERATOR and self._token.text in (")", "]"):
            message = f"nothing follows this `{opening.text}`"
            raise self._error("empty-brackets", message, opening, "write an expression there")

    def _close(self, bracket: str, opening: Token, outer_bars: bool) -> None:
        if self._at_end:
            message = f"this `{opening.text}` is not closed"
            raise self._error("not-closed", message, opening, f"add `{bracket}`")
        if not self._is(bracket):
            if self._token.text in (")", "]", "|"):
                message = f"`{opening.text}` is closed by `{self._token.text}`"
                raise self._error("not-closed", message, self._token, f"write `{bracket}`")
            raise self._unexpected()
        self._advance()
        self._depth -= 1
        self._in_bars = outer_bars

    def _enter(self, token: Token) -> None:
        self._depth += 1
        if self._depth > MAX_NESTING:
            message = f"this is nested more than {MAX_NESTING} deep"
            raise self._error("nested-too-deep", message, token, "introduce abbreviations")

    # -- tokens ----------------------------------------------------------------------------------------------

    def _advance(self, count: int = 1) -> None:
        self._index += count
        self._token = self.tokens[self._index]
        self._operator = self._token.text if self._token.kind is TokenKind.OPERATOR else ""

    @property
    def _at_end(self) -> bool:
        return self._token.kind is TokenKind.END

    def _is(self, operator: str) -> bool:
        return self._operator == operator

    def _peek(self, count: int) -> Token:
        return self.tokens[min(self._index + count, len(self.tokens) - 1)]

    @property
    def _last_end(self) -> int:
        return self.tokens[self._index - 1].end

    def _text(self, start: int, end: int) -> str:
        return " ".join(self.fragment.text[start:end].split())

    # -- errors and notes ------------------------------------------------------------------------------------

    def _number_after_factor(self) -> ProblemError:
        number, before = self._token, self.tokens[self._index - 1]
        start = self.tokens[self._index - 2].start if before.kind is TokenKind.PRIMES else before.start
        message = f"a number follows `{self._text(start, before.end)}` without an operator"
        if "/" in number.text:
            help_ = f"write `+ {number.text}` for a sum, `*{number.text}` for a product"
        elif before.kind is TokenKind.NUMBER:
            help_ = "digits are not separated by spaces, and a product is written `*`"
        else:
            help_ = f"write `*{number.text}` for a product, `^{number.text}` for a power"
        return self._error("missing-operator", message, number, help_)

    def _unexpected(self) -> ProblemError:
        token = self._token
        if token.kind is TokenKind.END:
            message = "the expression ends where something must follow"
            return self._error("ends-early", message, token, "complete it")
        if token.kind is TokenKind.PRIMES:
            message = "this prime has nothing to differentiate"
            return self._error("misplaced-prime", message, token, "write `x'`")
        if token.hidden:
            return self._error("ends-early", "something must follow here, before the braces end", token, "complete it")
        if token.text in (")", "]"):
            help_ = "remove it, or add the opening bracket"
            return self._error("not-opened", f"this `{token.text}` closes nothing", token, help_)
        message = f"`{self._text(token.start, token.end)}` is not allowed here"
        return self._error("misplaced-operator", message, token, _HELP_FOR_MISPLACED.get(token.text, "remove it"))

    def _error(self, code: str, message: str, place: Token | Tree, help_: str) -> ProblemError:
        span = self.fragment.span(place.start, max(place.end, place.start + 1))
        return ProblemError(Diagnostic(code, message, span, help=help_))

    def _note_reading(self, start: int, end: int, reading: str, help_: str) -> None:
        self._note(start, end, f"`{self._text(start, end)}` is read as `{reading}`", help_)

    def _note(self, start: int, end: int, message: str, help_: str) -> None:
        span = self.fragment.span(start, end)
        self.notes.append(Diagnostic("read-as", message, span, help=help_, level=Severity.NOTE))
