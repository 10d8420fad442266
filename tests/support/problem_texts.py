"""The head of a problem file, and the messages about its mistakes."""

from __future__ import annotations

import pytest

from lagrange.core.diagnostics import Diagnostic, ProblemError, Source
from lagrange.problem.loader import read_problem
from lagrange.problem.model import (
    Problem,
)
from lagrange.problem.sources import decode

HEAD = """title: Example
parameters: [m, l, g, k, c, F, R, mu, A, C, I_G]
coordinates: [x, y, theta]
"""
PARTICLES = "particles: {P: {mass: m, position: x*i + y*j}, Q: {mass: m, position: y*i}}\n"
BODY = "bodies: {B: {mass: m, inertia: I_G, position: x*i, angle: theta}}\n"
ROD = "constraints: {rod: x^2 + y^2 = l^2}\n"
ALL = HEAD + PARTICLES + BODY + ROD


def read(text: str) -> Problem:
    return read_problem(Source("problem.yaml", text))


def readings(problem: Problem) -> list[Diagnostic]:
    """The notes of a problem, apart from that on parameters which a short text does not use."""
    return [n for n in problem.notes if n.code != "unused-parameter"]


def mistakes(text: str | bytes) -> tuple[Diagnostic, ...]:
    with pytest.raises(ProblemError) as caught:
        read_problem(decode(text, "problem.yaml") if isinstance(text, bytes) else Source("problem.yaml", text))
    return caught.value.diagnostics


def places(text: str | bytes) -> list[tuple[str, int, int]]:
    """Code, line and column of all mistakes, in the order of the file; each says what to do."""
    found = mistakes(text)
    assert all(d.help for d in found)
    return [(d.code, *(d.span.source.position(d.span.start) if d.span else (0, 0))) for d in found]
