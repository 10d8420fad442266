"""Broken inputs, one for each seed, and what becomes of them.

Each function takes a seed and says what became of its input: "refused", "given up", "solved", a verdict. Any exception
but the project's own leaves it, and is a fault.
"""

from __future__ import annotations

import atexit
import random
import re
import shutil
import tempfile
from functools import cache
from pathlib import Path
from unittest.mock import patch

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.answers.examiner import Examiner
from lagrange.answers.submissions import Grader, Submission
from lagrange.answers.verdicts import Verdict
from lagrange.core.diagnostics import Fragment, GaveUpError, ProblemError, Source
from lagrange.core.vectors import Vector
from lagrange.document.math_writer import LATEX, TEXT, UNICODE, Writer
from lagrange.document.names import Notation
from lagrange.explain.report import report
from lagrange.expressions.reader import Scope, read_equation
from lagrange.problem.loader import load, read_problem
from lagsolve.grading.journal import Journal
from lagsolve.grading.table import TableRow
from tests.support.expression_texts import EQUATIONS, scope
from tests.support.paths import PROBLEMS

TOKEN = re.compile(r"\s+|\w+|.", re.DOTALL)
STRANGE = [
    "",
    "0",
    "1/0",
    "10^9",
    "sqrt(-1)",
    "\u202e",
    "\x1b[2J",
    "²",
    "'",
    '"',
    "{",
    "]",
    ":",
    "\t",
    "-",
    "&a",
    "*a",
    "!!x",
]
FUNCTIONS = ["sin", "cos", "tan", "atan", "sqrt", "exp", "log", "abs", "norm", "f"]


def mutated(text: str, rng: random.Random) -> str:
    """A text with one to three tokens or lines exchanged, doubled, lost, wrapped or replaced."""
    for _ in range(rng.randint(1, 3)):
        tokens = TOKEN.findall(text)
        places = [n for n, token in enumerate(tokens) if token.strip()]
        if not places:
            return text
        n, m = rng.choice(places), rng.choice(places)
        match rng.randrange(7):
            case 0:
                tokens[n] = tokens[m]
            case 1:
                tokens[n], tokens[m] = tokens[m], tokens[n]
            case 2:
                tokens[n] = ""
            case 3:
                tokens[n] = rng.choice(STRANGE)
            case 4:
                tokens[n] = f"{rng.choice(FUNCTIONS)}({tokens[n]})"
            case 5:
                tokens[n] *= rng.choice([2, 3, 40])
            case _:
                lines = text.splitlines(keepends=True)
                line = rng.randrange(len(lines))
                tokens = [*lines[:line], *rng.choice([[], [lines[line]] * 2, [rng.choice(lines)]]), *lines[line + 1 :]]
        text = "".join(tokens)
    return text


def _expression(rng: random.Random, depth: int, atoms: list[str]) -> str:
    if depth == 0 or rng.random() < 0.25:
        return rng.choice(atoms)
    a, b = (_expression(rng, depth - 1, atoms) for _ in range(2))
    return rng.choice([f"{a} + {b}", f"{a} - {b}", f"({a})*({b})", f"({a})/({b})", f"({a})^{rng.choice([2, 3, '(1/2)', -1])}",
                       f"{rng.choice(FUNCTIONS[:8])}({a})"])  # fmt: skip


def _by_grammar(rng: random.Random) -> str:
    """A file of the right form in which any expression may stand anywhere."""
    atoms = ["x", "y", "x", "y", "a", "2", "t"]
    depth = rng.randint(1, 3)
    constraints = [f"{_expression(rng, depth, [*atoms, *(['diff(x, t)'] if rng.random() < 0.2 else [])])} = "
                   f"{_expression(rng, depth - 1, atoms)}" for _ in range(rng.randint(0, 2))]  # fmt: skip
    lines = ["title: t", "parameters: [m, g, a]", "coordinates: [x, y]"]
    lines.append(f"particles: {{P: {{mass: m, position: '({_expression(rng, depth - 1, atoms[:5])})*i + y*j'}}}}")
    lines += ["gravity: -g*j"] if rng.random() < 0.7 else []
    lines += ["constraints:", *(f"  c{n}: '{c}'" for n, c in enumerate(constraints))] if constraints else []
    if rng.random() < 0.5:
        lines.append(f"forces: {{V: {{potential: '{_expression(rng, depth, atoms[:6])}'}}}}")
    lines.append(f"find: [{rng.choice(['motion', 'equilibrium', 'linearization'])}]")
    return "\n".join(lines) + "\n"


def refused(error: ProblemError) -> str:
    if not (error.diagnostics and str(error)):
        raise ValueError("an error without a message")
    return "refused"


UNITS = 30_000
"""Of work for a problem: a second or two. The heaviest shipped problems take more, so that they are given up as well."""


@patch("lagrange.mechanics.solution.UNITS_OF_SOLVING", UNITS)
def _of_problem(text: str) -> str:
    try:
        solved = report(read_problem(Source("fuzz.yaml", text)), complete=False)
    except GaveUpError:
        return "given up"
    except ProblemError as error:
        return refused(error)
    return "given up" if solved.solution.given_up else "solved" if solved.holds else "solved in part"


@cache
def _shipped() -> list[str]:
    return [path.read_text(encoding="utf-8") for path in sorted(PROBLEMS.glob("*/*.yaml"))]


def mutated_problem(seed: int) -> str:
    """A shipped problem file with a few tokens changed."""
    rng = random.Random(seed)
    return _of_problem(mutated(rng.choice(_shipped()), rng))


def read_file(seed: int) -> str:
    """A shipped problem file with a few tokens changed, which is only read."""
    rng = random.Random(seed)
    try:
        read_problem(Source("fuzz.yaml", mutated(rng.choice(_shipped()), rng)))
    except ProblemError as error:
        return refused(error)
    return "read"


def problem_by_grammar(seed: int) -> str:
    """A small problem of random expressions."""
    return _of_problem(_by_grammar(random.Random(seed)))


@cache
def _pendulum() -> Examiner:
    return Examiner.of(load(PROBLEMS / "chapter6/ex11-ideal-pendulum.yaml"))


ANSWERS = [
    "theta'' + g/l*sin(theta) = 0",
    r"\ddot{\theta} = -\frac{g}{l} \sin\theta",
    "x*y'' - y*x'' = g*x\nx^2 + y^2 = l^2",
    "lambda_rod = -m*(g*y + l^2*theta'^2)/(2*l^2)",
    r"\begin{align} m \ddot{x} &= 2 \lambda x \\ m \ddot{y} &= m g + 2 \lambda y \end{align}",
]


def answer(seed: int) -> str:
    """An answer to the ideal pendulum with a few tokens changed."""
    rng = random.Random(seed)
    lines = mutated(rng.choice(ANSWERS), rng).splitlines() or [""]
    try:
        judged = _pendulum().check(tuple(Fragment.of(line, f"answer {n}") for n, line in enumerate(lines)))
    except GaveUpError:
        return "given up"
    except ProblemError as error:
        return refused(error)
    return str(judged.verdict)


@cache
def _names() -> tuple[Scope, dict[str, Writer]]:
    names = scope("k", "alpha", "omega", "a_1")
    moving = names.slots.coordinates
    notation = Notation(moving, prescribed=names.slots.prescribed, parameters=tuple(names.scalars.values()))
    return names, {
        "text": Writer(TEXT, notation),
        "terminal": Writer(UNICODE, notation),
        "latex": Writer(LATEX, notation),
    }


BEYOND = ("exponent-too-large", "nested-too-deep", "number-too-long")
"""Limits on what is read, which a value may exceed that was written in fewer letters: 101010^9."""


def read_text(seed: int) -> str:
    """An equation, mutated or random, read and written in three styles, each of which is read back as the same."""
    rng = random.Random(seed)
    if rng.random() < 0.5:
        text = mutated(rng.choice(TEXTS), rng)
    else:
        text = f"{_expression(rng, rng.randint(1, 3), ATOMS)} = {rng.choice(ATOMS)}"
    names, writers = _names()
    try:
        read = read_equation(Fragment.of(text), names, [], latex=True)
    except ProblemError as error:
        return refused(error)
    if isinstance(read.lhs, Vector) or isinstance(read.rhs, Vector):
        return "a vector"
    for style, writer in writers.items():
        written = f"{writer.plain(read.lhs)} = {writer.plain(read.rhs)}"
        try:
            again = read_equation(Fragment.of(f"${written}$" if style == "latex" else written), names, [], latex=True)
        except ProblemError as error:
            if style == "terminal" or error.diagnostics[0].code in BEYOND:
                continue  # ln x and [x + y] are for the eye
            raise ValueError(f"{style}: `{written}` of `{text}` is not read: {error}") from None
        sides = ((again.lhs, read.lhs), (again.rhs, read.rhs))
        if not all(isinstance(a, sp.Expr) and isinstance(b, sp.Expr) and _equal(a, b) for a, b in sides):
            raise ValueError(f"{style}: `{written}` of `{text}` is read as {again.lhs} = {again.rhs}")
    return "read back"


def _equal(a: sp.Expr, b: sp.Expr) -> bool:
    return a == b or sp.expand(a - b) == 0 or is_zero(a - b) is not False


TEXTS = [*EQUATIONS, *ANSWERS]
ATOMS = [
    "x",
    "y",
    "theta",
    "theta_1",
    "u'",
    "x''",
    "theta'",
    "t",
    "m",
    "l",
    "g",
    "omega",
    "alpha",
    "a_1",
    "2",
    "1/3",
    "0.5",
    "pi",
]


FILES = [
    (".tex", "\\newcommand{\\tdd}{\\ddot{\\theta}}\n\\[ m l^2 \\tdd + m g l \\sin\\theta = 0 \\qquad (1) \\]"),
    (".tex", r"\[ \begin{pmatrix} m & 0 \\ 0 & m \end{pmatrix} \begin{pmatrix} \ddot x \\ \ddot y \end{pmatrix}"
             r" = \begin{pmatrix} 2\lambda x \\ mg + 2\lambda y \end{pmatrix} \]"),
    (".tex", "$M = \\begin{pmatrix} m l^2 \\end{pmatrix}$, $h = \\begin{pmatrix} m g l \\sin\\theta \\end{pmatrix}$, $M\\ddot q + h = 0$"),
    (".py", "def f(t, y):\n    th, om = y\n    return [om, -g/l*np.sin(th)]"),
    (".m", "function dz = f(t,z)\nth = z(1); w = z(2);\ndz = [w; -g/l*sin(th)];\nend"),
    (".py", "L = m*l**2*theta.diff(t)**2/2 + m*g*l*cos(theta)\neq = Eq(L.diff(theta.diff(t)).diff(t) - L.diff(theta), 0)"),
    (".py", "T, V = m*l**2*theta.diff()**2/2, -m*g*l*cos(theta)\nL = T - V\nLM = LagrangesMethod(L, [theta])"),
    (".txt", "Let s be the arc, so s = l theta, thus\nm s'' = -m g sin(theta) which gives a = theta'' = -(g/l) sin(theta)."),
    (".nb", r"T = 1/2 m l^2 \[Theta]'[t]^2; V = -m g l Cos[\[Theta][t]];" "\n" r"D[D[T - V, \[Theta]'[t]], t] - D[T - V, \[Theta][t]] == 0"),
    (".md", "## Solution\n- `L = T - V`\n- $\\boxed{\\ddot\\theta = -\\frac{g}{l}\\sin\\theta}$ (Ans.)"),
]  # fmt: skip


@cache
def _grader() -> Grader:
    return Grader.of(_pendulum())


def submission(seed: int) -> str:
    """A file with macros, matrices, a program or sentences, handed in for the ideal pendulum, a few tokens changed."""
    rng = random.Random(seed)
    ending, text = rng.choice(FILES)
    content = mutated(text, rng).encode("utf-8", "replace")
    return _grader().grade(Submission("x", ((f"answer{ending}", content),))).verdict.value


ROWS = [TableRow(f"{n}.txt", Verdict.WRONG, 1, 2, 1, "a remark", 0.5, f"{n}.md") for n in range(3)]


@cache
def _journal() -> tuple[Path, str]:
    """A file for journals, and what it has for these rows as they are."""
    folder = Path(tempfile.mkdtemp())
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    path = folder / "marks.csv.journal"
    written = Journal(path)
    for n, row in enumerate(ROWS):
        written.add(f"k{n}", row)
    written.close(complete=False)
    return path, path.read_text(encoding="utf-8")


def journal(seed: int) -> str:
    """The journal of a batch with a few bytes changed."""
    rng = random.Random(seed)
    path, text = _journal()
    damaged = bytearray(mutated(text, rng).encode("utf-8", "surrogatepass"))
    for _ in range(rng.randrange(3) if damaged else 0):
        damaged[rng.randrange(len(damaged))] = rng.randrange(256)
    path.write_bytes(bytes(damaged))
    again = Journal(path)
    found = [again.row(f"k{n}") for n in range(len(ROWS))]
    again.close(complete=False)
    return f"{len(ROWS) - found.count(None)} rows read"
