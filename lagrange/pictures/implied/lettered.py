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
    return {"O": Vector.zero()} | points


def rods_between_letters(problem: Problem, pose: Pose) -> Iterator[tuple[str, str, bool]]:
    """The letters of the ends of each rod or rope of the text whose length is constant, and whether it is a rope."""
    points = lettered(problem, pose.configuration)
    poses = [
        pose,
        *filter(_is_possible, pose.others),
        *(x for by in (0.1, 0.25) if (x := _later(pose, by)) is not None),
    ]
    for match in _PAIR.finditer(f"{problem.title}. {problem.description}"):
        for a, b in re.findall(r"([A-Z])([A-Z])", match["pairs"]):
            if a not in points or b not in points or a == b or len(poses) < 3:
                continue
            with suppress(NoValueError):
                ways = [minus(x.at(points[b]), x.at(points[a])) for x in poses]
                sizes = [math.hypot(*w) for w in ways]
                if max(sizes) - min(sizes) < SAME_PLACE < 1e-3 < min(sizes):
                    yield a, b, bool(_ROPE.search(match["word"]))


def _is_possible(pose: Pose) -> bool:
    """Whether a position satisfies its constraints: those off a strut that is taken away do not."""
    return all(abs(pose.number(sp.sympify(f, strict=True))) < SAME_PLACE for f in pose.configuration.finite_constraints)


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
    ends = {end for a, b, _ in rods_between_letters(problem, pose) for end in (a, b)}
    added = {n: v for n, v in places.items() if n in ends and n in problem.abbreviations}
    return replace(problem, figure=replace(figure, points=added)) if added else problem
