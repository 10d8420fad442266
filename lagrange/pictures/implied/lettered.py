"""Rods of which the text gives the ends by their letters: the crank OA, the connecting rod AB, the piston B.

O is the origin, A a lettered vector of the file, B a particle of that name or one that the text calls the piston B. Two
such points whose distance is the same in all positions and at all times are joined by a rod or rope, as the text says,
unless both belong to one body, which is drawn anyway.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import replace
from itertools import permutations

import sympy as sp

from lagrange.core.symbols import t
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.pictures.floats import NoValueError, minus, projected
from lagrange.pictures.limits import SAME_PLACE
from lagrange.pictures.poses import Pose
from lagrange.problem.model import Problem

_PAIR = re.compile(
    r"\b(?P<word>rod|crank|link|bar|arm|lever|rocker|coupler|string|rope|cord|thread|cable)s?\b"
    r"(?: of length \S+)?,? (?P<pairs>\$?[A-Z]{2}\b\$?(?:(?:,| and|, and) \$?[A-Z]{2}\b\$?)*)"
)
_UNIFORM, _ROD = re.compile(r"\b(uniform|homogeneous)", re.I), re.compile(r"\b(rod|bar|beam)s?\b", re.I)
_ROPE = re.compile("string|rope|cord|thread|cable")


def lettered(problem: Problem, configuration: Configuration) -> Mapping[str, Vector]:
    """The points that have a letter in the text, in the coordinates of the configuration."""
    text = f"{problem.title} {problem.description}"
    named = {n: v for n, v in problem.abbreviations.items() if isinstance(v, Vector) and re.fullmatch("[A-Z]", n)}
    points = {n: v.fixed().map(lambda c: c.xreplace(dict(configuration.expressed))) for n, v in named.items()}
    for p in configuration.points:
        called = re.search(rf"\b{re.escape(p.name.replace('_', ' '))},? \(?\$?([A-Z])\b(?! [a-z]* ?=)", text)
        letter = p.name if re.fullmatch("[A-Z]", p.name) else called[1] if called else ""
        if letter and letter not in points:
            points[letter] = p.position.fixed()
    for _ in _centres(configuration) if _UNIFORM.search(text) else ():  # each round finds at least one more, or none
        for ends, middle in _centres(configuration).items():
            for known, other in permutations(ends):
                if known in points and other not in points:
                    points[other] = (middle * 2 - points[known]).map(sp.expand)
    return {"O": Vector.zero()} | points


def _centres(configuration: Configuration) -> dict[str, Vector]:
    """The particles that are called by the ends of the uniform rods of which they are the centres: BC, CD."""
    return {p.name: p.position.fixed() for p in configuration.points if re.fullmatch("[A-Z]{2}", p.name)}


def rods_between_letters(problem: Problem, pose: Pose) -> Iterator[tuple[str, str, bool]]:
    """The letters of the ends of each rod or rope of the text whose length is constant, and whether it is a rope."""
    points = lettered(problem, pose.configuration)
    poses = [
        pose,
        *filter(_is_possible, pose.others),
        *(x for by in (0.1, 0.25) if (x := _later(pose, by)) is not None),
    ]
    text = f"{problem.title}. {problem.description}"
    named = [(name, False) for name in _centres(pose.configuration) if _UNIFORM.search(text) and _ROD.search(text)]
    for match in _PAIR.finditer(text):
        rope = bool(_ROPE.search(match["word"]))
        named += [(pair, rope) for pair in re.findall("[A-Z]{2}", match["pairs"]) if (pair, rope) not in named]
    for pair, rope in named:
        a, b = pair[0], pair[1]
        if a in points and b in points and a != b and len(poses) > 2:
            with suppress(NoValueError):
                ways = [minus(x.at(points[b]), x.at(points[a])) for x in poses]
                sizes = [math.hypot(*w) for w in ways]
                if max(sizes) - min(sizes) < SAME_PLACE < 1e-3 < min(sizes):
                    yield a, b, rope


def _is_possible(pose: Pose) -> bool:
    """Whether a position satisfies its constraints: those off a strut that is taken away do not."""
    relations = (sp.sympify(f, strict=True) for f in pose.configuration.finite_constraints)
    try:
        return all(abs(pose.number(f)) < SAME_PLACE for f in relations)
    except NoValueError:
        return False


def _later(pose: Pose, by: float) -> Pose | None:
    """The nearest position on the constraints at a later time."""
    start = {**pose.values, t: pose.values.get(t, 0.0) + by}
    relations = [sp.sympify(f, strict=True) for f in pose.configuration.finite_constraints]
    slopes = [[f.diff(q) for q in pose.coordinates] for f in relations]
    try:
        return replace(pose, values=projected(relations, slopes, pose.coordinates, start))
    except NoValueError:
        return None


def with_lettered_points(problem: Problem, pose: Pose) -> Problem:
    """The problem with the lettered vectors that are ends of such rods as points of its figure."""
    figure = problem.figure
    if figure.points or figure.lines or figure.circles or figure.curves:
        return problem
    places = lettered(problem, pose.configuration)
    positions = [p.position.fixed() for p in pose.configuration.points]
    ends = {end for a, b, _ in rods_between_letters(problem, pose) for end in (a, b)}
    taken = {"O", *(p.name for p in pose.configuration.points)}
    added = {n: v for n, v in places.items() if n in ends - taken and v not in positions}
    return replace(problem, figure=replace(figure, points=added)) if added else problem
