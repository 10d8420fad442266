"""Whole verdicts in LaTeX alone: however a right equation is written it is right, and with one term changed it is wrong.

An equation is a list of terms, each a number and factors with powers; what is written is made from these, at random,
and never read back. A change is of one term of several, so that no multiple of the right equation comes out.
"""

from __future__ import annotations

from fractions import Fraction
from random import Random

import pytest

from lagrange.answers.submissions import Submission
from tests.answers.test_student_answers import grader_of
from tests.support.chance import examples

Term = tuple[Fraction, dict[str, int]]
"""A number, and the power of each factor."""


def term(number: int, **powers: int) -> Term:
    return Fraction(number), powers


ANGLE = {"theta": r"\theta", "phi1": r"\varphi_1", "phi2": r"\varphi_2"}
SYSTEMS: dict[str, list[list[Term]]] = {
    "ex11-ideal-pendulum": [[term(1, l=1, theta_2=1), term(1, g=1, sin_theta=1)]],
    "ex17-spherical-pendulum": [
        [term(1, r=1, theta_2=1), term(2, r_1=1, theta_1=1), term(-1, r=1, phi_1=2, sin_theta=1, cos_theta=1),
         term(-1, g=1, sin_theta=1)],
        [term(1, r=1, phi_2=1, sin_theta=1), term(2, r_1=1, phi_1=1, sin_theta=1),
         term(2, r=1, theta_1=1, phi_1=1, cos_theta=1)],
    ],
    "spring-pendulum": [
        [term(1, m=1, r_2=1), term(-1, m=1, r=1, phi_1=2), term(1, c=1, r=1), term(-1, c=1, l=1),
         term(-1, m=1, g=1, cos_phi=1)],
        [term(1, r=1, phi_2=1), term(2, r_1=1, phi_1=1), term(1, g=1, sin_phi=1)],
    ],
    "swinging-atwood": [
        [term(1, M=1, r_2=1), term(1, m=1, r_2=1), term(-1, m=1, r=1, theta_1=2), term(-1, m=1, g=1, cos_theta=1),
         term(1, M=1, g=1)],
        [term(1, r=1, theta_2=1), term(2, r_1=1, theta_1=1), term(1, g=1, sin_theta=1)],
    ],
}  # fmt: skip


class Pen:
    """Writes equations in LaTeX, in one of many ways."""

    def __init__(self, chance: Random) -> None:
        self.chance = chance

    def pick(self, *ways: str) -> str:
        return self.chance.choice(ways)

    def letter(self, name: str) -> str:
        return {"theta": r"\theta", "phi": self.pick(r"\phi", r"\varphi")}.get(name, name)

    def braced(self, text: str) -> str:
        return self.pick(f"{{{text}}}", f" {text}" if text.startswith("\\") or len(text) == 1 else f"{{{text}}}")

    def factor(self, name: str, power: int) -> str:
        stem, _, rest = name.partition("_")
        if stem in ("sin", "cos"):
            angle = self.letter(rest)
            inside = self.pick(f"({angle})", f"{{{angle}}}", rf"\left({angle}\right)", f" {angle}")
            return rf"\{stem}{self.power(power)}{inside}" + self.pick("", r"\,") + " "
        if not rest:
            return self.letter(stem) + self.power(power) + " "
        return self.rate(self.letter(stem), int(rest), power)

    def rate(self, q: str, order: int, power: int) -> str:
        dots = "d" * order + "ot"
        exponent = f"^{order}" if order > 1 else ""
        d = self.pick("d", r"\mathrm{d}", r"\mathrm d ")
        ways = [
            rf"\{dots}{self.braced(q)}{self.power(power)} ",
            rf"\frac{{{d}{exponent} {q}}}{{{d} t{exponent}}}",
            rf"\dv[{order}]{{{q}}}{{t}}",
            rf"\overset{{{'.' * order}}}{{{q}}}{self.power(power)}",
            rf"\{dots}{{{q}}}(t){self.power(power)}" if power == 1 else rf"\{dots}{{{q}}}{self.power(power)}",
        ]
        if power != 1:
            bracketed = [f"({w}){self.power(power)}" for w in ways[1:3]]
            ways[1:3] = bracketed
        return self.chance.choice(ways)

    def power(self, power: int) -> str:
        return "" if power == 1 else self.pick(f"^{power}", f"^{{{power}}}")

    def product(self, factors: list[str]) -> str:
        self.chance.shuffle(factors)
        parts = []
        for f in factors:
            parts += [f, self.pick("", " ", r"\,", r"\cdot ", r"\; ", " ")]
        return "".join(parts[:-1]) if parts else "1"

    def written(self, t: Term, divisor: str) -> str:
        number, powers = abs(t[0]), t[1]
        above = [self.factor(name, power) for name, power in powers.items()]
        numerator, denominator = number.numerator, number.denominator
        below = [str(denominator)] if denominator != 1 else []
        if divisor and divisor in powers and powers[divisor] == 1:
            above = [self.factor(name, power) for name, power in powers.items() if name != divisor]
        elif divisor:
            below.append(divisor)
        front = "" if numerator == 1 and above else f"{numerator} "
        if not below:
            return front + self.product(above)
        bottom = " ".join(below)
        if self.chance.random() < 0.5:
            return rf"{self.pick(chr(92) + 'frac', chr(92) + 'dfrac', chr(92) + 'tfrac')}{{{front}{self.product(above)}}}{{{bottom}}}"
        return rf"\frac{{{numerator}}}{{{bottom}}}" + (rf"\, {self.product(above)}" if above else "")

    def side(self, terms: list[Term], divisor: str) -> str:
        if not terms:
            return "0"
        text = ""
        for n, t in enumerate(terms):
            sign = "-" if t[0] < 0 else "+" if n else ""
            text += f"{sign} {self.written(t, divisor)}" + self.pick("", " ", r"\, ")
        return text

    def equation(self, terms: list[Term], divisors: tuple[str, ...]) -> str:
        scale = Fraction(self.chance.choice([1, 1, 1, 2, 3, -1]), self.chance.choice([1, 1, 2]))
        scaled = [(n * scale, powers) for n, powers in terms]
        self.chance.shuffle(scaled)
        cut = self.chance.choice([0, len(scaled), self.chance.randint(0, len(scaled))])
        left, right = scaled[:cut], [(-n, p) for n, p in scaled[cut:]]
        divisor = self.pick("", "", *divisors)
        return f"{self.side(left, divisor)} = {self.side(right, divisor)}"

    def answer(self, equations: list[str]) -> str:
        match self.chance.randrange(6):
            case 0:
                return "\n".join(f"${e}$" + self.pick("", ".", ",") for e in equations)
            case 1:
                rows = r" \\ ".join(e.replace("=", "&=") for e in equations)
                return rf"\begin{{align*}}{rows}\end{{align*}}"
            case 2:
                return "\n".join(rf"\[{self.pick('', chr(92) + 'boxed')}{{{e}}}\]" for e in equations)
            case 3:
                rows = r" \\ ".join(equations)
                return rf"\begin{{cases}}{rows}\end{{cases}}"
            case 4:
                return "\n".join(rf"$${e} \quad ({n})$$" for n, e in enumerate(equations, 1))
            case _:
                return "\n".join(
                    rf"\begin{{equation}} {e} \label{{eq:{n}}} \end{{equation}}" for n, e in enumerate(equations)
                )


def changed(terms: list[Term], chance: Random) -> list[Term]:
    """The terms with one of them changed."""
    n = chance.randrange(len(terms))
    number, powers = terms[n]
    waves = [f for f in powers if f.startswith(("sin_", "cos_"))]
    match chance.choice(["sign", "factor", "missing", "wave" if waves else "sign", "power"]):
        case "sign":
            new = [(-number, powers)]
        case "factor":
            new = [(number * chance.choice([2, Fraction(1, 2), 3]), powers)]
        case "missing":
            new = []
        case "wave":
            other = {"sin": "cos", "cos": "sin"}[waves[0][:3]] + waves[0][3:]
            rest = {f: p for f, p in powers.items() if f != waves[0]}
            new = [(number, {**rest, other: rest.get(other, 0) + powers[waves[0]]})]
        case _:
            name = chance.choice([f for f in powers if not f.endswith(("_1", "_2"))] or list(powers))
            new = [(number, {**powers, name: powers[name] + 1})]
    return [*terms[:n], *new, *terms[n + 1 :]]


def verdict(problem: str, text: str) -> tuple[str, list[str]]:
    graded = grader_of(problem).grade(Submission("a", (("a.tex", text.encode()),)))
    return graded.verdict.value, [e.text for e in graded.equations]


DIVISORS = {"ex11-ideal-pendulum": ("l", "g"), "ex17-spherical-pendulum": ("r",), "spring-pendulum": ("m", "r"),
            "swinging-atwood": ("m", "r")}  # fmt: skip


@pytest.mark.parametrize("seed", range(examples(40)))
@pytest.mark.parametrize("problem", SYSTEMS)
def test_a_right_answer_stays_right_however_it_is_written(problem: str, seed: int) -> None:
    chance = Random(f"{problem} {seed}")
    pen = Pen(chance)
    text = pen.answer([pen.equation(e, DIVISORS[problem]) for e in SYSTEMS[problem]])
    assert verdict(problem, text)[0] == "equivalent", text


@pytest.mark.parametrize("seed", range(examples(40)))
@pytest.mark.parametrize("problem", SYSTEMS)
def test_an_answer_with_one_term_changed_is_wrong(problem: str, seed: int) -> None:
    chance = Random(f"changed {problem} {seed}")
    pen = Pen(chance)
    equations = [*SYSTEMS[problem]]
    n = chance.randrange(len(equations))
    equations[n] = changed(equations[n], chance)
    text = pen.answer([pen.equation(e, DIVISORS[problem]) for e in equations])
    assert verdict(problem, text)[0] == "wrong", text
