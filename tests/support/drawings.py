"""Shipped problems that are drawn, and what is in their drawings."""

from __future__ import annotations

import math
from functools import cache

import sympy as sp

import lagrange
from lagrange.document.derivation import Picture
from lagrange.document.names import Notation
from lagrange.document.scene import Polyline, Scene, StrokeKind
from lagrange.mechanics.solution import kinematics_and_law
from lagrange.pictures.system_drawing import configuration_scene
from lagrange.pictures.systems import SystemPicture, system_in_file
from tests.support.figure_sheet import figures_of, solution_for_figures
from tests.support.shared import reported

DRAWN = (
    "chapter6/ex03-double-pendulum",
    "chapter6/ex10-double-pendulum",
    "chapter6/ex14-two-particles",
    "chapter6/ex15-rough-incline",
    "chapter6/ex17-spherical-pendulum",
    "motion/bell-and-clapper",
    "motion/coupled-oscillators",
    "motion/hoop-on-incline",
    "motion/sliding-ladder",
    "motion/spring-pendulum",
    "statics/slider-crank",
)


CLOSE = 1e-6


def system_of(name: str) -> SystemPicture:
    found = system_in_file(reported(name).solution)
    assert found is not None
    return found


def scenes(name: str) -> list[Scene]:
    pictures = (b for s in reported(name).derivation.steps for b in s.body if isinstance(b, Picture))
    return [scene for p in pictures if (scene := p.draw()) is not None]


@cache
def figures(name: str) -> list[Scene]:
    """The figure of a shipped problem and its free bodies, drawn from kinematics and Newton's law alone."""
    return figures_of(solution_for_figures(name))


def drawing_of(title: str, text: str) -> SystemPicture:
    """The system of a problem in words, in its position on the page."""
    system = system_in_file(kinematics_and_law(lagrange.loads(f"title: {title}\n{text}")))
    assert system is not None
    return system


def sketched(title: str, text: str) -> Scene:
    """The system of a problem in words, without its loads."""
    system = drawing_of(title, text)
    scene = configuration_scene(system, Notation(), with_loads=False)
    assert scene is not None
    return scene


def evaluated(expression: sp.Expr, system: SystemPicture) -> float:
    """By SymPy, not by the evaluator of the pictures."""
    values = {s: sp.Float(v) for s, v in system.pose.values.items()}
    return float(sp.sympify(expression, strict=True).evalf(15, subs=values))


def lines_of(scene: Scene, kind: StrokeKind) -> list[Polyline]:
    return [line for line in scene.lines if line.kind is kind]


def near(a: tuple[float, float], b: tuple[float, float], within: float = CLOSE) -> bool:
    return math.dist(a, b) < within
