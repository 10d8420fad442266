"""Random answers: no text crashes the comparison, and every verdict on a generated answer is the true one.

    right equations, rearranged        rows of the system combined with random coefficients, terms on either side
    one thing changed in them          a coefficient, a sign, a function, an exponent
    texts                              characters and words of both input languages without sense

The true verdict is found in numbers, with `answer_truth`, which shares no code with the program.
"""

from __future__ import annotations

import json
import random
from functools import cache

import pytest
import sympy as sp
from click.testing import CliRunner
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from lagrange.answers.equations import AnswerVerdict, Reference, Verdict, check_equations
from lagrange.core.diagnostics import Fragment, ProblemError
from lagsolve.main import main
from tests.answers.test_equations import GIVEN, TABLE, given_reference
from tests.support.answer_truth import RANGES, read, route, truth, written
from tests.support.chance import examples
from tests.support.second_route import Route, slots
from tests.truth.test_answers import derived

FUZZ = settings(deadline=None, derandomize=True, suppress_health_check=list(HealthCheck), database=None)
SYSTEMS = ("pendulum", "spherical", "cart", "kepler", "ex11 in x, y", "ex18", "sleigh", "heavy-top", "wheel-suspension")


@cache
def system(name: str) -> tuple[Route, Reference]:
    """A system by the second route, and what the program compares with."""
    if name not in GIVEN:
        return route(name), derived(name)
    coordinates, _, equations = GIVEN[name]
    names = tuple(q.strip() for q in coordinates.split(","))
    return Route(names, tuple(read(e) for e in equations)), given_reference(name)


@cache
def right_equations(name: str) -> tuple[sp.Expr, ...]:
    """The equations of a system, in plain symbols; where there are constraints, with multipliers."""
    found, _ = system(name)
    return tuple(slots(sp.sympify(e)) for e in found.equations)


def verdict_on(equations: list[str], name: str) -> AnswerVerdict:
    """The program's verdict on an answer to a system."""
    return check_equations([Fragment.of(e) for e in equations], system(name)[1])


def factors(name: str, draw: random.Random) -> sp.Expr:
    """A coefficient: seldom zero, sometimes somewhere."""
    coordinates = system(name)[0].coordinates
    q, v = sp.Symbol(draw.choice(coordinates)), sp.Symbol(draw.choice(coordinates) + "'")
    m = sp.Symbol("m") if any(s.name == "m" for e in right_equations(name) for s in e.free_symbols) else sp.S.One
    choices = [1, 1, 2, -3, sp.Rational(2, 5), q, v, sp.sin(q), sp.cos(q), 1 + q**2, m, 1 / m, 1 / q, sp.exp(q), v - q]
    return sp.sympify(draw.choice(choices))


def rearranged(name: str, draw: random.Random) -> list[sp.Expr]:
    """The equations combined: as many, or one less, or one more."""
    own = right_equations(name)
    count = len(own) + draw.choice((0, 0, 0, -1, 1))
    found = []
    for n in range(max(count, 1)):
        e = factors(name, draw) * own[n % len(own)]
        for other in own:
            if draw.random() < 0.3:
                e += factors(name, draw) * other
        found.append(e)
    draw.shuffle(found)
    return found


def as_equation(e: sp.Expr, draw: random.Random) -> str:
    """Some terms on the left and the others on the right, multiplied out or not."""
    e = sp.expand(e) if draw.random() < 0.5 else e
    terms = list(sp.Add.make_args(e))
    draw.shuffle(terms)
    cut = draw.randint(0, len(terms))
    left, right = sp.Add(*terms[:cut]), sp.Add(*(-x for x in terms[cut:]))
    return f"{written(left)} = {written(right)}"


def changed(e: sp.Expr, draw: random.Random) -> sp.Expr:
    """The equation with one thing changed that it has."""
    e = sp.expand(e)
    terms = list(sp.Add.make_args(e))
    n = draw.randrange(len(terms))
    kinds = [lambda x: 2 * x, lambda x: -x, lambda x: 0 * x, lambda x: x * sp.Rational(1, 3)]
    kinds += [lambda x: x.replace(sp.sin, sp.cos) if x.has(sp.sin) else x.replace(sp.cos, sp.sin)]
    velocities = [s for s in terms[n].free_symbols if s.name.endswith("'") and not s.name.endswith("''")]
    kinds += [lambda x, v=v: x / v for v in velocities]
    terms[n] = draw.choice(kinds)(terms[n])
    return sp.Add(*terms)


@pytest.mark.parametrize("name", SYSTEMS)
@settings(FUZZ, max_examples=12)
@given(seed=st.integers(0, 10**9))
def test_right_equations_combined(name: str, seed: int) -> None:
    draw = random.Random(seed)
    found, _ = system(name)
    equations = rearranged(name, draw)
    expected = truth(found, equations, RANGES.get(name), seed)
    answered = verdict_on([as_equation(e, draw) for e in equations], name)
    assert answered.verdict.value == expected, equations
    assert expected != "wrong"


@pytest.mark.parametrize("name", SYSTEMS)
@settings(FUZZ, max_examples=12)
@given(seed=st.integers(0, 10**9))
def test_one_thing_changed(name: str, seed: int) -> None:
    draw = random.Random(seed)
    found, _ = system(name)
    equations = list(right_equations(name))
    n = draw.randrange(len(equations))
    equations[n] = changed(equations[n], draw)
    if not any(s.name in found.unknowns for s in equations[n].free_symbols):
        return  # no equation of motion is left
    expected = truth(found, equations, RANGES.get(name), seed)
    answered = verdict_on([as_equation(e, draw) for e in equations], name)
    assert answered.verdict.value == expected, equations
    right = [e.verdict is Verdict.EQUIVALENT for e in answered.equations]
    assert all(r for k, r in enumerate(right) if k != n)


# -- texts -------------------------------------------------------------------------------------------------------------


LISTED = (
    "theta theta' theta'' phi x y m l g sin cos tan sqrt exp abs sign diff cross dot norm d delta t pi const lambda_rod T_rod "
    "0 1 2 1/2 0.5 9.81 2e3 + - * / ^ ** ( ) [ ] { } = == , ; ' '' ² √ θ θ̈ · − π or and lambda eval __import__ i j k e_x r_P "
    "\\frac \\sin \\theta \\ddot \\dot \\left( \\right) $ \\\\ & \\begin{align} \\end{align} _1 ^2 \\sqrt{ } \\text \\input"
)
WORDS = LISTED.split()
ODD = "\x00\u200b\u202e\ufeff\n\t\\\"'`#%~|<>!?:@𝑥ｓ²₁é€\U0001f600"
ALLOWED = {v.value for v in Verdict}
RIGHT = [(name, answer) for name, answer, verdict in TABLE.values() if verdict == "equivalent"]


def outcome(text: str, name: str = "pendulum") -> str:
    """The verdict on one text as an answer, or the code of the error."""
    try:
        return verdict_on([text], name).verdict.value
    except ProblemError as error:
        return error.diagnostics[0].code


def truth_on(text: str, name: str) -> str | None:
    """The true verdict on one text; None where SymPy reads it otherwise or not at all, or it is not affine."""
    try:
        return truth(system(name)[0], [read(text)])
    except (
        ArithmeticError,
        AssertionError,
        AttributeError,
        LookupError,
        NameError,
        SyntaxError,
        TypeError,
        ValueError,
    ):
        return None


@settings(FUZZ, max_examples=examples(400))
@given(st.lists(st.sampled_from(WORDS), max_size=14), st.sampled_from(("", " ")))
def test_words_without_sense(words: list[str], between: str) -> None:
    assert outcome(between.join(words)) in ALLOWED


@settings(FUZZ, max_examples=examples(300))
@given(st.text(st.characters() | st.sampled_from(ODD + "theta'=+-*/^()"), max_size=60))
def test_characters_without_sense(text: str) -> None:
    assert outcome(text) in ALLOWED


@settings(FUZZ, max_examples=examples(300))
@given(st.sampled_from(RIGHT), st.integers(0, 10**9))
def test_right_answers_with_misprints(right: tuple[str, str], seed: int) -> None:
    """A misprint may leave an answer right, but only if its meaning is unchanged, which is decided in numbers."""
    name, answer = right
    draw = random.Random(seed)
    text = list(draw.choice(answer.split(";")))
    for _ in range(draw.randint(1, 3)):
        place = draw.randrange(len(text))
        match draw.randrange(4):
            case 0:
                text[place] = ""
            case 1:
                text[place] *= 2
            case 2:
                text[place] = draw.choice([*"0123456789+-*/^()=' .", *WORDS])
            case _:
                other = draw.randrange(len(text))
                text[place], text[other] = text[other], text[place]
    joined = "".join(text)
    found = outcome(joined, name)
    assert found in ALLOWED
    if found in ("equivalent", "incomplete", "wrong"):
        assert truth_on(joined, name) in (found, None), joined


@settings(FUZZ, max_examples=15)
@given(st.lists(st.sampled_from(WORDS), max_size=10), st.lists(st.sampled_from(WORDS), max_size=10))
def test_the_command_line_says_a_verdict_for_any_texts(first: list[str], second: list[str]) -> None:
    arguments = ["check", "ex11-ideal-pendulum", f"--equation={' '.join(first)}", f"--equation={' '.join(second)}"]
    result = CliRunner().invoke(main, [*arguments, "--format", "json"])
    assert result.exit_code in (0, 1, 2, 3)
    assert "Traceback" not in result.output
    assert "internal" not in result.stderr
    assert json.loads(result.stdout)["verdict"] in ALLOWED
