"""Numbers of equations, which are no factors, behind an equation and where words refer to one."""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.answers.submissions import answer_to
from lagrange.answers.written.numbering import notes_on_numbers, number_at_the_end, without_numbers
from lagrange.core.diagnostics import Source
from tests.support.shared import loaded, solved


@pytest.mark.parametrize(
    ("text", "equation", "number"),
    [
        ("m x'' + k x = 0   (2)", "m x'' + k x = 0", "(2)"),
        (r"m \ddot x = 0\;(2a)", r"m \ddot x = 0", "(2a)"),
        ("x'' = g  [3]", "x'' = g", "[3]"),
        ("x'' = g (Ans.)", "x'' = g", "(Ans.)"),
        ("x'' = -(g)(2)", "x'' = -(g)(2)", ""),  # a factor
        ("x'' = a  (b)", "x'' = a", "(b)"),
        ("x'' = a (b)", "x'' = a (b)", ""),  # a name, unless the space is wide
        ("see (2)", "see (2)", ""),
        ("P <= mu W   (2)", "P <= mu W", "(2)"),
        ("h = 5 R/2 ..... (2)", "h = 5 R/2", "(2)"),
        ("h = 5 R/2   Eq. (2)", "h = 5 R/2", "Eq. (2)"),
        (r"h = \frac52 R \leqno(2)", r"h = \frac52 R", "leqno(2)"),
        (r"h &= \frac52 R &&(2)", r"h &= \frac52 R", "&&(2)"),
    ],
)
def test_a_number_ends_an_equation(text: str, equation: str, number: str) -> None:
    end, found = number_at_the_end(text)
    assert (text[:end].rstrip(), found) == (equation, number)


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("m x'' = F   (2)\nx = 0", "m x'' = F\nx = 0"),
        (r"\[ m \ddot x = F \;(2) \]", r"\[ m \ddot x = F   \]"),
        (r"m \ddot x = F \quad (2) \\", r"m \ddot x = F  \\"),
        ("$m x'' = F$ (2)", "$m x'' = F$"),
        ("From (2) and (3)  F = m x''", "From F = m x''"),
        ("(1) in (2): F = m x''", "F = m x''"),
        ("using eq. 2, F = m x''", "using , F = m x''"),
        ("[2] F = m x''", "F = m x''"),
        ("A = [1   2", "A = [1   2"),  # a row of a matrix
        ("x'' = (a + b)(2)", "x'' = (a + b)(2)"),
        ("degrees of freedom (2)", "degrees of freedom (2)"),
    ],
)
def test_numbers_of_equations_are_left_out_of_a_text(text: str, plain: str) -> None:
    made = without_numbers(text)
    assert len(made) == len(text)  # places in it are places in the text
    assert made.split() == plain.split()


def test_a_number_that_is_left_out_is_named() -> None:
    [note] = notes_on_numbers(Source("answer", "H = p^2/(2*m)   (2)"))
    assert note.message == "`(2)` after the equation numbers it, and is no factor"


@pytest.mark.parametrize("number", ["   (2)", " [2]", "   (eq. 2)", " ②", "   (II)", ",   (2)", " .... (2)"])
@pytest.mark.parametrize(
    ("problem", "answer"),
    [
        ("bead-in-a-turning-tube", "H = p_r^2/(2*m) + k*(r - a)^2/2 - m*r^2*Omega^2/2"),
        ("bead-in-a-turning-tube", "m*r'' = m*r*Omega^2 - k*(r - a)"),
        ("crate-tips-or-slides", "P <= W*b/h\nP <= mu*W"),
        ("ladder", "P = W/2*tan(phi)"),
        ("rod-caught-at-an-end", "x' = 0\ny' = 3/4*v\ntheta' = 3*v/(2*l)"),
    ],
)
def test_no_number_behind_an_answer_is_a_factor(problem: str, answer: str, number: str) -> None:
    examiner = Examiner(loaded(problem), solved(problem))
    parts = answer_to(examiner, Source("answer.txt", f"{answer}{number}\n"), ".txt")
    assert examiner.check(parts).verdict.value == "equivalent"


@pytest.mark.parametrize("run", ["-", "—", ".", "…", " ", "\t", "~", "- ", "·", r"\dots", "&"])
def test_a_long_run_before_no_number_is_read_at_once(run: str) -> None:
    """Its parts could be divided in exponentially many ways; the time limit of a test would end it."""
    text = f"x = y{run * 60}!"
    assert without_numbers(text) == text
