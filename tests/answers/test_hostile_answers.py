"""Inputs that must not hurt: each gives its verdict or error as an answer, and nothing else happens.

The table of the contract, in plain text. A hang is caught by the time limit of the test. `trap` makes every way of running code from text an error.
"""

from __future__ import annotations

import builtins
import os
import sys
import time
from collections.abc import Callable

import pytest
import sympy as sp
from click.testing import CliRunner
from sympy.parsing import sympy_parser

from lagrange.answers.equations import Reference, check_equations
from lagrange.answers.examiner import reference
from lagrange.core.diagnostics import Fragment, ProblemError, Source
from lagrange.problem.loader import read_problem
from lagsolve.main import main
from tests.answers.test_equations import given_reference
from tests.support.shared import loaded

REJECTED = "unreadable"

INPUTS = [
    ("   \n", REJECTED),
    ("=", REJECTED),
    ("theta'' == 0", "wrong"),
    ("sin(theta)^2+cos(theta)^2 = 1", "trivial"),
    ("9**9**9 = 0", REJECTED),
    ("2^(20000*theta) = theta''", REJECTED),
    ("2^(20000*theta)", REJECTED),
    ("theta''^(10^10) = 0", REJECTED),
    ("theta'' + theta^(10^18) = 0", REJECTED),
    ("factorial(10**7) = 0", REJECTED),
    ("gamma(10**8) = 0", REJECTED),
    ("binomial(10**9,5*10**8) = 0", REJECTED),
    ("10.0**10.0**10.0 = 0", REJECTED),
    ("sin(sin(exp(exp(exp(3)))+3)) = 0", REJECTED),
    ("theta+" * 20000 + "theta = 0", REJECTED),
    ("theta**" * 200 + "theta = 0", REJECTED),
    ("__import__('os').system('id') = 0", REJECTED),
    ("S('__import__(\"os\").getpid()') = 0", REJECTED),
    ("lambda: 1", REJECTED),
    ("print(hello)", REJECTED),
    ("[0]*10**10 = 0", REJECTED),
    ("'a'*10**10 = 0", REJECTED),
    ("Sum(1,(x,1,10**10)).doit() = 0", REJECTED),
    ("0*theta'' = 0", "trivial"),
    ("theta'' + g/l*sin(theta) = 0  # comment", REJECTED),
    ("theta''\x00 = 0", REJECTED),
    ("theta''+\u200bg = 0", REJECTED),
    ("l*θ'' + g*sin θ = 0", "equivalent"),
    ("θ'' + θ'²·0 + g/l·sin(θ) + sin²θ + cos²θ − 1 = 0", "equivalent"),
    ("theta'' + q*theta = 0", REJECTED),
    ("1/2m = theta''", "wrong"),
    ("l theta'' + g sin theta = 0", "equivalent"),
    ("l*theta''/cos theta/2 = -g*tan theta/2", "equivalent"),
    ("m(l*theta''+g*sin(theta)) = 0", "equivalent"),
    ("[m*l](theta'') = 0", REJECTED),
    ("|theta| = 0", "wrong"),
    ("{" * 40 + "theta" + "}" * 40 + " = 0", REJECTED),
    ("24! * 24! = 0", REJECTED),
    ('=HYPERLINK("http://x")', REJECTED),
    ("@SUM(1) = 0", REJECTED),
    ("theta''.__class__ = 0", REJECTED),
    ("exec(1) = 0", REJECTED),
    ("theta'' = `id`", REJECTED),
    ("theta'' = $(id)", REJECTED),
    ("${theta} = 0", "wrong"),
    ("(" * 5000 + "theta" + ")" * 5000 + " = 0", REJECTED),
    ("sqrt(" * 55 + "theta" + ")" * 55 + " = theta''", REJECTED),
    ("((((((((theta+1)^20+1)^20)))))) = 0", REJECTED),
    ("(theta + m + l + g + theta')^20 = theta''", "wrong"),
    ("theta'' = 1" + "0" * 31, REJECTED),
    ("theta'' = 1e400", REJECTED),
    ("theta'' = atan2(theta, 0)/0", REJECTED),
    ("theta''/(theta - theta) = 0", REJECTED),
    ("theta''''''''''''' = 0", REJECTED),
    ("diff(theta'', t) = 0", REJECTED),
    ("theta" * 300 + " = 0", REJECTED),
    ("theta'' = " + "+".join(f"sin({n}*theta)" for n in range(2, 90)), "wrong"),
    ("theta''*" + "*".join(f"(theta + {n})" for n in range(2, 90)) + " = 0", REJECTED),
    ("theta''*" + "*".join(f"cos({n}*theta)" for n in range(2, 90)) + " = 0", "wrong"),
    ("(l*theta'' + g*sin(theta))*" + "*".join(f"(theta + {n})" for n in range(2, 14)) + " = 0", "equivalent"),
    ("(l*theta'' + g*sin(theta))*" + "*".join(f"(cos({n}*theta) + {n})" for n in range(2, 14)) + " = 0", "equivalent"),
    ("(l*theta'' + g*sin(theta))/(" + "+".join(f"cos({n}*theta)" for n in range(2, 60)) + ") = 0", "equivalent"),
    ("(l*theta'' + g*sin(theta))^20 = 0", "wrong"),
    ("theta'^20 + cos(theta)^20 = const", "wrong"),
]  # fmt: skip

KEYWORDS = """
title: Names that mean something elsewhere
parameters: [m, I, S, lambda, E, N, Q, beta, gamma, zeta, d]
coordinates: [x, theta]
equations: ["I*theta'' + S*x = 0", "lambda*x'' + E*N*Q*beta*gamma*zeta*d*x = 0"]
"""


@pytest.fixture
def trap(monkeypatch: pytest.MonkeyPatch) -> None:
    """Running anything that is made from text fails the test; Python's own modules may still be loaded."""

    def guarded(run: Callable[..., object]) -> Callable[..., object]:
        def call(source: object, *rest: object, **options: object) -> object:
            outside = sys._getframe(1).f_globals.get("__name__", "").split(".")[0]
            assert outside in ("importlib", "dataclasses", "collections", "typing", "_pytest"), "text was run as code"
            return run(source, *rest, **options)

        return call

    def caught(*_: object, **__: object) -> None:
        raise AssertionError("text was run as code")

    real = sp.sympify

    def strict(a: object, *rest: object, **options: object) -> object:
        assert not isinstance(a, str), "text was given to sympify"
        return real(a, *rest, **options)

    monkeypatch.setattr(builtins, "eval", guarded(builtins.eval))
    monkeypatch.setattr(builtins, "exec", guarded(builtins.exec))
    monkeypatch.setattr(os, "system", caught)
    monkeypatch.setattr(sympy_parser, "parse_expr", caught)
    monkeypatch.setattr(sp, "sympify", strict)


def outcome(text: str, against: Reference) -> str:
    """The verdict on a text; an error is as good as `unreadable`."""
    try:
        found = check_equations([Fragment.of(text)], against)
    except ProblemError:
        return REJECTED
    return found.verdict.value


@pytest.mark.parametrize(("text", "expected"), INPUTS, ids=lambda x: ascii(x)[:40])
def test_hostile_answers(text: str, expected: str, request: pytest.FixtureRequest) -> None:
    against = given_reference("pendulum")
    request.getfixturevalue("trap")
    assert outcome(text, against) == expected


@pytest.mark.parametrize(
    ("answer", "expected"),
    [
        ("I*theta'' + S*x = 0 ; lambda*x'' = -E*N*Q*beta*gamma*zeta*d*x", "equivalent"),
        ("I theta'' = -S x ; lambda x'' = -E N Q beta gamma zeta d x", "equivalent"),
        ("I*theta'' - S*x = 0 ; lambda*x'' = -E*N*Q*beta*gamma*zeta*d*x", "wrong"),
        ("lambda*x = 0", "wrong"),
    ],
)
def test_names_of_python_and_sympy_are_free(answer: str, expected: str) -> None:
    against = reference(read_problem(Source("names", KEYWORDS)))
    found = check_equations([Fragment.of(e.strip()) for e in answer.split(";")], against)
    assert found.verdict.value == expected


@pytest.mark.parametrize(
    "text", [t for t, _ in INPUTS[:12]] + ["-1", "+1", "--help", "@file"], ids=lambda x: ascii(x)[:40]
)
def test_hostile_answers_on_the_command_line(text: str) -> None:
    result = CliRunner().invoke(main, ["check", "ex11-ideal-pendulum", f"--equation={text}"])
    assert result.exit_code in (1, 2)
    assert "Traceback" not in result.output
    assert "internal" not in result.output


def test_long_runs_of_letters_take_no_time() -> None:
    from lagrange.answers.written.notation.plain import rewritten

    scope = reference(loaded("ex11-ideal-pendulum")).scope_of_answers
    start = time.process_time()
    for run in ("a" * 2000, "ab1_" * 500, "a " * 1000):
        rewritten(Fragment.of(f"{run} = 0"), scope)
    assert time.process_time() - start < 1
