"""Problem files, read from the contract: every key in each of its forms, every trap of YAML, every mistake at its place."""

from __future__ import annotations

import pytest
import sympy as sp
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from lagrange.core.diagnostics import Diagnostic, ProblemError
from lagrange.core.vectors import Vector
from lagrange.problem.model import (
    Find,
)
from lagrange.problem.sources import decode
from tests.support.chance import examples
from tests.support.problem_texts import ALL, HEAD, PARTICLES, mistakes, places, read, readings

x, y, theta = (sp.Symbol(n, real=True) for n in ("x", "y", "theta"))
m, l, g, k, c, F, R, mu, A, C, I_G = sp.symbols("m l g k c F R mu A C I_G", positive=True)


def vector(*components: sp.Expr | int) -> Vector:
    p, q, r = (sp.sympify(e) for e in components)
    return Vector((p, q, r))


# -- every key in each of its forms --------------------------------------------------------------------------------------


def test_title_and_coordinates_are_enough() -> None:
    problem = read("title: T\ncoordinates: [x]\n")
    assert (problem.title, [q.symbol for q in problem.coordinates]) == ("T", [x])
    assert problem.find == (Find.CONSTRAINTS,)


def test_the_words_of_the_statement() -> None:
    problem = read(
        "title: Ideal   pendulum\nsource: Chapter 6, Ex. 11\ndescription: >\n  Two\n  lines.\naxes: {i: right, j: down}\n"
        "coordinates: [x]\n"
    )
    assert (problem.title, problem.source, problem.description) == (
        "Ideal pendulum",
        "Chapter 6, Ex. 11",
        "Two lines.",
    )
    assert problem.axes == {"i": "right", "j": "down"}


def test_a_reference_system() -> None:
    assert [e.text for e in read(HEAD + "equations: [\"m x'' = F\", y'' = 0]\n").equations] == ["m x'' = F", "y'' = 0"]


# -- the traps of YAML -----------------------------------------------------------------------------------------------------


def test_prime_quotes() -> None:
    """In single quotes YAML halves the primes, which gives a note; in double quotes and without quotes it does not."""
    halved = read(ALL + "answers: {equations: ['x'' = 0']}\n")
    [note] = readings(halved)
    assert note.code == "read-as"
    assert "double quotes" in note.help
    for written in ("\"x'' = 0\"", "'x'''' = 0'", "x'' = 0", "'x'''' + y'' = 0'"):
        assert readings(read(ALL + f"answers: {{equations: [{written}]}}\n")) == []


# -- every mistake at its place ---------------------------------------------------------------------------------------------

MISTAKES: dict[str, list[tuple[str, int, int]]] = {
    # the frame of the file
    "coordinates: [x]": [("missing-key", 1, 1)],
    "title: T": [("missing-key", 1, 1)],
    "title: T\ncoordinates: []": [("empty-value", 2, 14)],
    "title: T\ncoordinates:": [("empty-value", 2, 1)],
    "title: T\ncoordinates: x, y": [("wrong-kind", 2, 14)],
    "title:\ncoordinates: [x]": [("empty-value", 1, 1)],
    "title: ''\ncoordinates: [x]": [("empty-value", 1, 8)],
    "title: [a]\ncoordinates: [x]": [("wrong-kind", 1, 8)],
    HEAD + "gravty: g*j": [("unknown-key", 4, 1)],
    HEAD + "gravity:": [("empty-value", 4, 1)],
    HEAD + "axes: {l: up}": [("unknown-key", 4, 8)],
    # names
    "title: T\ncoordinates: [x, x]": [("declared-twice", 2, 18)],
    "title: T\nparameters: [x]\ncoordinates: [x]": [("declared-twice", 3, 15)],
    "title: T\nparameters: [theta]\ncoordinates: [θ]": [("declared-twice", 3, 15)],
    "title: T\ncoordinates: [t, pi, sin, dot, e_x]": [("reserved-name", 2, n) for n in (15, 18, 22, 27, 32)],
    "title: T\ncoordinates: [2x, x', a-b, '', _a]": [("bad-name", 2, n) for n in (15, 19, 23, 28, 32)],
    "title: T\ncoordinates: [x y]": [("bad-name", 2, 15)],
    f"title: T\ncoordinates: [{'x' * 61}]": [("bad-name", 2, 15)],
    f"title: T\ncoordinates: [{', '.join(f'x{n}' for n in range(1_001))}]": [("too-many-names", 2, 5905)],
    # parameters
    "title: T\nparameters: {m: positiv}\ncoordinates: [x]": [("unknown-assumption", 2, 17)],
    "title: T\nparameters: {m: negative}\ncoordinates: [x]": [("unknown-assumption", 2, 17)],
    "title: T\nparameters: {m: {asume: real}}\ncoordinates: [x]": [("unknown-key", 2, 18)],
    "title: T\nparameters: {m: {value: 0}}\ncoordinates: [x]": [("value-against-assumption", 2, 25)],
    "title: T\nparameters: {m: {assume: sign, value: 2}}\ncoordinates: [x]": [("value-against-assumption", 2, 39)],
    "title: T\nparameters: {m: {value: 1/0}}\ncoordinates: [x]": [("division-by-zero", 2, 27)],
    **{
        f"title: T\nparameters: {{m: {{value: {value}}}}}\ncoordinates: [x]": [("not-a-number", 2, 25)]
        for value in ("12:30", "null", "~", "1_000", "no", "yes", "i")
    },
    **{
        f"title: T\nparameters: {{m: {{value: {value}}}}}\ncoordinates: [x]": [("unknown-unit", 2, 25)]
        for value in ("0x10", "3 furlong", "2 m2")
    },
    # functions
    HEAD + "functions: [f]": [("wrong-kind", 4, 12)],
    HEAD + "functions: {f: []}": [("no-arguments", 4, 16)],
    HEAD + "functions: {f: [X, X]}": [("declared-twice", 4, 20)],
    HEAD + "functions: {x: [X]}": [("declared-twice", 4, 13)],
    HEAD + "functions: {f: [X + Y]}": [("bad-name", 4, 17)],
    HEAD + "functions: {u: [t]}\nconstraints: {a: x = u(x)}": [("argument-of-prescribed", 5, 23)],
    HEAD + "functions: {f: [X]}\nconstraints: {a: f = 0}": [("no-argument", 5, 18)],
    # abbreviations
    HEAD + "let: {a: b, b: a}": [("circular-definition", 4, 7)],
    HEAD + "let: {a: a + 1}": [("circular-definition", 4, 7)],
    HEAD + "let: {x: y}": [("declared-twice", 4, 7)],
    HEAD + "let: {a: }": [("empty-value", 4, 10)],
    HEAD + "let: {a: x = y}": [("unexpected-equation", 4, 12)],
    HEAD + "let: {a: [x]}": [("wrong-kind", 4, 10)],
    HEAD + "let: {a: r_Q}": [("unknown-symbol", 4, 10)],
    # frames
    HEAD + "frame: polar": [("wrong-kind", 4, 8)],
    HEAD + "frame: {type: toroidal, coordinates: [x, y]}": [("unknown-frame", 4, 15)],
    HEAD + "frame: {type: spherical, coordinates: [x, theta]}": [("frame-coordinates", 4, 39)],
    HEAD + "frame: {type: polar, coordinates: [theta, phi]}": [("unknown-coordinate", 4, 43)],
    # particles and bodies
    HEAD + "particles: {P: {mass: m}}": [("missing-key", 4, 13)],
    HEAD + "particles: {P: {mass: x, position: 0}}": [("variable-mass", 4, 23)],
    HEAD + "particles: {P: {mass: -m, position: 0}}": [("negative", 4, 23)],
    HEAD + "particles: {P: {mass: , position: 0}}": [("empty-value", 4, 17)],
    HEAD + "particles: {P: {mass: m, position: x}}": [("scalar-for-vector", 4, 36)],
    HEAD + "particles: {P: {mass: m, position: x'*i}}": [("not-allowed-here", 4, 36)],
    HEAD + "particles: {P: {mass: m, position: [x, y', 0]}}": [("not-allowed-here", 4, 40)],
    HEAD + "particles: {P: {mass: m, position: r_Q}, Q: {mass: m, position: r_P}}": [("circular-definition", 4, 13)],
    HEAD + "particles: {1: {mass: m, position: 0}}\nforces: {a: {on: 1, vector: F*i}}": [("bad-name", 4, 13)],
    HEAD + PARTICLES + "bodies: {P: {mass: m, inertia: A, position: 0, angle: x}}": [("declared-twice", 5, 10)],
    HEAD + "bodies: {B: {mass: m, position: 0, angle: x}}": [("missing-key", 4, 10)],
    HEAD + "bodies: {B: {inertia: A, position: 0}}": [("orientation", 4, 10)],
    HEAD + "bodies: {B: {inertia: [A, C], position: 0, angle: x}}": [("inertia", 4, 23)],
    HEAD + "bodies: {B: {inertia: '[A, A, C]', position: 0, angle: x}}": [("inertia", 4, 23)],
    HEAD + "bodies: {B: {inertia: [A, A, C], position: 0, angle: x}}": [("orientation", 4, 10)],
    HEAD + "bodies: {B: {inertia: [A, A, C], position: 0, orientation: {axes: zxz, angles: [x, y, theta]}}}": [
        ("unknown-sequence", 4, 67)
    ],
    HEAD + "bodies: {B: {inertia: [A, A, C], position: 0, axes: [i, i, j], angular_velocity: 0}}": [("axes", 4, 53)],
    HEAD + "bodies: {B: {inertia: [A, A, C], position: 0, axes: [j, i, e_z], angular_velocity: 0}}": [("axes", 4, 53)],
    # constraints
    HEAD + "constraints: [x = 0]": [("wrong-kind", 4, 14)],
    HEAD + "constraints: {a: x}": [("no-equals-sign", 4, 19)],
    HEAD + "constraints: {a: x = 0, y = 0}": [("bad-name", 4, 25)],
    HEAD + "constraints: {a: 0 <= y <= l}": [("inequality", 4, 20)],
    HEAD + "constraints: {a: y = x >= 0}": [("inequality", 4, 24)],
    HEAD + "constraints: {a: x*y' >= 0}": [("one-sided", 4, 18)],
    HEAD + "constraints: {a: d(x) >= 0}": [("one-sided", 4, 18)],
    HEAD + "constraints: {a: x*i + y*j >= x*j}": [("one-sided", 4, 18)],
    HEAD + "constraints: {a: {equation: y >= 0, by: rod}}": [("one-sided", 4, 41)],
    HEAD + "constraints: {a: 0 < y}": [("inequality", 4, 20)],
    HEAD + "constraints: {a: m = l}": [("restricts-nothing", 4, 18)],
    HEAD + "constraints: {a: x - x = 0}": [("restricts-nothing", 4, 18)],
    HEAD + "constraints: {a: sin(x)^2 = 1 - cos(x)^2}": [("restricts-nothing", 4, 18)],
    HEAD + "constraints: {a: x'' = 0}": [("not-allowed-here", 4, 18)],
    HEAD + "constraints: {a: delta(x) = 0}": [("not-allowed-here", 4, 18)],
    HEAD + "constraints: {a: d(x)*d(y) = 0}": [("not-a-form", 4, 18)],
    HEAD + "constraints: {a: d(x) = l}": [("not-a-form", 4, 18)],
    HEAD + 'constraints: {a: "d(x) = y\'"}': [("not-a-form", 4, 18)],
    HEAD + "constraints: {a: x/(sin(y)^2 + cos(y)^2 - 1) = 0}": [("division-by-zero", 4, 18)],
    HEAD + "constraints: {a: x*i = y}": [("scalar-for-vector", 4, 24)],
    HEAD + "constraints: {a: {equation: x = 0, reaction: m}}": [("declared-twice", 4, 46)],
    HEAD + "constraints: {a: {equation: x = 0, reaction: N}, b: {equation: y = 0, reaction: N}}": [
        ("declared-twice", 4, 81)
    ],
    HEAD + "constraints: {a: {reaction: N}}": [("missing-key", 4, 15)],
    HEAD + "constraints: {a: x = 0}\nlet: {b: lambda_a}": [("unknown-symbol", 5, 10)],
    HEAD + "constraints: {no-slip: x = 0}\nanswers: {integrable: {no-slip: true}}": [("bad-name", 4, 15)],
    # forces
    ALL + "gravity: g": [("scalar-for-vector", 7, 10)],
    ALL + "gravity: (0, -g)": [("list-in-parentheses", 7, 12)],
    ALL + "forces: {a: {on: P}}": [("force-kind", 7, 10)],
    ALL + "forces: {a: {on: P, force: F*i}}": [("unknown-key", 7, 21)],
    ALL + "forces: {a: {on: Z, vector: F}}": [("unknown-name", 7, 18), ("scalar-for-vector", 7, 29)],
    ALL + "forces: {a: {on: P, vector: x''*i}}": [("not-allowed-here", 7, 29)],
    ALL + "forces: {a: {on: P, vector: F*i, moment: F*j}}": [("force-kind", 7, 10)],
    ALL + "forces: {a: {on: P, moment: F*j}}": [("unknown-name", 7, 18)],
    ALL + "forces: {a: {spring: k, between: [P]}}": [("two-ends", 7, 34)],
    ALL + "forces: {a: {spring: k, between: [P, Z]}}": [("unknown-name", 7, 38)],
    ALL + "forces: {a: {friction: mu, constraint: rood, on: P}}": [("unknown-name", 7, 40)],
    ALL + "forces: {a: {friction: mu, constraint: rod, on: P, slip: up}}": [("unknown-sense", 7, 58)],
    ALL + "forces: {a: {potential: k*x''^2}}": [("not-allowed-here", 7, 27)],
    # the rest
    ALL + "unknowns: [x]": [("declared-twice", 7, 12)],
    ALL + "unknowns: N": [("wrong-kind", 7, 11)],
    ALL + "speeds: {u: x}": [("no-velocity", 7, 13)],
    ALL + "speeds: {u: x'*y'}": [("speed-not-linear", 7, 13)],
    ALL + "generalized_coordinates: {a: {coordinates: [s]}}": [("no-substitution", 7, 45)],
    ALL + "generalized_coordinates: {a: {coordinates: [s, theta], substitute: {x: s}}}": [
        ("coordinate-left-out", 7, 27)
    ],
    ALL + "generalized_coordinates: {a: {coordinates: [s, theta], substitute: {x: s', y: s}}}": [
        ("not-allowed-here", 7, 72)
    ],
    ALL + "generalized_coordinates: {a: {coordinates: [s, theta], substitute: {x: s, y: s, z: s}}}": [
        ("unknown-coordinate", 7, 81)
    ],
    ALL + "generalized_coordinates: {a: {coordinates: [m, theta], substitute: {x: m, y: m}}}": [
        ("declared-twice", 7, 45)
    ],
    ALL + "generalized_coordinates: {a: {coordinates: [y, theta], substitute: {x: y, y: x}}}": [
        ("kept-and-replaced", 7, 75)
    ],
    ALL + "equations: [\"x'' = 0\"]": [("two-systems", 7, 1)],
    ALL + "find: movement": [("unknown-question", 7, 7)],
    ALL + "find: motion, equilibrium": [("unknown-question", 7, 7)],
    ALL + "answers: {degrees_of_freedom: one}": [("not-a-number", 7, 31)],
    ALL + "answers: {classification: [holonomous]}": [("unknown-class", 7, 28)],
    ALL + "answers: {classification: [rheonomic, scleronomic]}": [("contradictory-answer", 7, 39)],
    ALL + "answers: {integrable: {rod: no}}": [("not-a-truth-value", 7, 29)],
    ALL + "answers: {integrable: {rood: true}}": [("unknown-name", 7, 24)],
    ALL + "answers: {equations: [\"x'' = q\"]}": [("unknown-symbol", 7, 30)],
    ALL + "answers: {equilibrium: [theta = q]}": [("unknown-symbol", 7, 33)],
    ALL + "answers: {reactions: {rod: q}}": [("unknown-symbol", 7, 28)],
}


@pytest.mark.parametrize("text", MISTAKES)
def test_mistake(text: str) -> None:
    assert places(text + "\n") == MISTAKES[text]


HELPS = {
    HEAD + "gravty: g*j": "did you mean `gravity`?",
    HEAD + "gravity: 9.81": "`gravity: -g*j` where j points up",
    HEAD + "forces: {gravity: -m*g*j}": "without the mass, beside `forces`: `gravity: -g*j`",
    HEAD + "forces: {tie: {type: spring, k: m, on: P}}": "write `{spring: c, between: [P, Q]}`",
    HEAD + "particles: {P: {mas: m, position: 0}}": "did you mean `mass`?",
    HEAD + "constraints: {a: {equation: x = 0, reacton: N}}": "did you mean `reaction`?",
    HEAD + "constraints: {a: thetta = 0}": "did you mean `theta`?",
    HEAD + "constraints: {a: x = ml}": "did you mean `m l`?",
    HEAD + "constraints: {a: y > 0}": "the two sides are equal",
    HEAD + "constraints: {a: x = 0, y = 0}": "every entry is `name: ...`",
    ALL + "find: motion, equilibrium": "`find: [equilibrium, motion]`",
    ALL + "answers: {classification: [holonomous]}": "did you mean `holonomic`?",
    "title: T\nparameters: {m: negative}\ncoordinates: [x]": "minus",
    "title: T\nparameters: {a: 30 degg}\ncoordinates: [x]": "did you mean `deg`?",
    HEAD + "constraints: {a: x = 4 ft}": "`parameters: {a: {value: 4 ft}}`",
    "title: T\ncoordinates: [x]\nlet: {r_P: x*i}\nparticles: {P: {position: x*i}}": "`r_P` always is the position",
    HEAD
    + "constraints: {a: {equation: x = q, reaction: N}}\nask: {b: {quantity: N}}\nanswers: {ask: {b: 3}}": "declared",
    ALL + "forces: {a: {static: m, constraint: s, on: P}}": "add `friction: mu`",
    "title: T\ncoordinates: x, y": "`coordinates: [x, y]`",
    "title: T\ncoordinates: [x y]": "`[x, y]`",
}


@pytest.mark.parametrize("text", HELPS)
def test_help(text: str) -> None:
    found = mistakes(text + "\n")
    assert len(found) == 1
    assert HELPS[text] in found[0].help


# -- what a file amounts to --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("lines", "code"),
    [
        (["a0: x + y", *(f"a{n + 1}: sin(a{n})*a{n}" for n in range(100))], "expression-too-large"),
        (["a0: x + y", *(f"a{n + 1}: a{n}^2" for n in range(100))], "exponent-too-large"),
        (["a0: x*i", *(f"a{n + 1}: cross(a{n}, x*y*j) + a{n}" for n in range(100))], "expression-too-large"),
    ],
)
def test_abbreviations_do_not_grow_without_bound(lines: list[str], code: str) -> None:
    found = mistakes(HEAD + "let:\n" + "".join(f"  {line}\n" for line in lines))
    assert [d.code for d in found] == [code]


def test_differentials_of_large_vectors_are_paid_for() -> None:
    """190 coordinates and 200 differentials of a vector with 190 sines took minutes."""
    names = [f"x{n}" for n in range(190)]
    terms = " + ".join(f"sin({p}*{q})" for p, q in zip(names, [*names[1:], names[0]], strict=True))
    text = f"title: T\ncoordinates: [{', '.join(names)}]\nlet: {{v: ({terms})*i}}\nconstraints:\n"
    text += "".join(f'  a{n}: "dot(d(v), i) = {n}*d(t)"\n' for n in range(200))
    assert {d.code for d in mistakes(text)} <= {"expression-too-large", "more-mistakes"}


def test_a_file_of_many_expressions_has_one_budget() -> None:
    """Three hundred constraints with a hundred sines each took two minutes; that work is given up is said once."""
    text = HEAD + "constraints:\n"
    for n in range(300):
        text += f"  a{n}: {' + '.join(f'sin({i + 100 * n}*x + y)*x^{i % 7}' for i in range(100))} = y\n"
    (found,) = mistakes(text)
    assert found.code == "given-up"
    assert "shorter" in (found.help or "")


def test_differentials_of_vectors() -> None:
    """In a turning frame, with a prescribed motion: d(a) = a' dt, and delta(a) leaves time out."""
    text = """title: T
coordinates: [r, phi]
functions: {u: [t]}
frame: {type: polar, coordinates: [r, phi]}
let: {a: r*e_r + u*t*i, b: d(a), c: delta(a), rate: a'}
"""
    scope = read(text).scope
    r, phi, u = (sp.Symbol(n, real=True) for n in ("r", "phi", "u"))
    total = scope.vectors["b"].fixed().components
    frozen = scope.vectors["c"].fixed().components
    rate = scope.vectors["rate"].fixed().components
    for n in range(3):
        to_rate = {sp.Symbol(f"d({q})", real=True): sp.Symbol(f"{q}'", real=True) for q in (r, phi)}
        to_rate[sp.Symbol("d(t)", real=True)] = sp.S.One
        assert sp.expand(total[n].xreplace(to_rate) - rate[n]) == 0
        to_total = {sp.Symbol(f"delta({q})", real=True): sp.Symbol(f"d({q})", real=True) for q in (r, phi)}
        still = {sp.Symbol("d(t)", real=True): sp.S.Zero}
        assert sp.expand(frozen[n].xreplace(to_total) - total[n].xreplace(still)) == 0
    assert total[0].has(u)


LINES = [
    *ALL.splitlines(),
    "gravity: g*j", "unknowns: [N]", "find: motion", "let: {a: x*i, b: a'}", 'functions: {f: [X], u: [t]}',
    "forces: {a: {on: P, vector: F*i}, s: {spring: k, between: [P, Q], length: l}}", "axes: {i: right}",
    "generalized_coordinates: {a: {coordinates: [s, theta], substitute: {x: l*sin(s), y: l*cos(s)}}}",
    "answers: {degrees_of_freedom: 2, classification: [holonomic], equations: [\"x'' = 0\"]}", "speeds: {s1: x' + y'}",
    "frame: {type: cartesian}", 'equations: ["x\'\' = 0"]', "description: >", "  some words",
]  # fmt: skip
BITS = [
    *"{}[]:,'\"#&*!|>%@-\n\t =?\x00é",
    ": ",
    "- ",
    "null",
    "x",
    "sin(",
    "''",
    "&a ",
    "*a",
    "!!str ",
    "<<: ",
    "---\n",
    "1e400",
    "\ufeff",
]


@st.composite
def misspelt_files(draw: st.DrawFn) -> str:
    """Lines of a file in some order, with characters removed and inserted."""
    text = "\n".join(draw(st.lists(st.sampled_from(LINES), max_size=12)) + draw(st.sampled_from([[], LINES[:3]])))
    for _ in range(draw(st.integers(0, 4))):
        start = draw(st.integers(0, len(text)))
        end = min(len(text), start + draw(st.integers(0, 8)))
        text = text[:start] + draw(st.sampled_from(["", *BITS])) + text[end:]
    return text


def check_file(text: str) -> None:
    """A problem, or mistakes that say where and what to do."""
    shown = "nothing is wrong"
    found: tuple[Diagnostic, ...] = ()
    try:
        read(text)
    except ProblemError as error:
        found, shown = error.diagnostics, error.show()
    assert shown
    for d in found:
        assert d.help, d.code
        assert d.span is None or 0 <= d.span.start <= d.span.end


@given(misspelt_files())
@settings(max_examples=examples(300), deadline=None, suppress_health_check=[HealthCheck.too_slow])
def test_misspelt_files_are_refused_or_read(text: str) -> None:
    check_file(text)


@given(st.text(max_size=200))
@settings(max_examples=examples(100), deadline=None)
def test_any_text_is_refused_or_read(text: str) -> None:
    check_file(text)


@given(st.binary(max_size=200))
@settings(max_examples=examples(100), deadline=None)
def test_any_bytes_are_refused_or_read(data: bytes) -> None:
    try:
        text = decode(data, "problem.yaml").text
    except ProblemError as error:
        text = error.show()
    check_file(text)
