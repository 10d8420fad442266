"""The pictures of a derivation and their places: the system, its free bodies, the coordinates of a choice.

Nothing is drawn here: a picture is drawn when a renderer asks for it, and then once; one that takes too much work is
omitted. Each has a caption, and a description in words for readers who cannot see it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cache
from itertools import takewhile
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.core.diagnostics import GaveUpError
from lagrange.core.effort import allowed_for
from lagrange.document.derivation import Block, Part, Picture, Prose, Rule, Step, listed, math
from lagrange.document.names import Notation
from lagrange.explain.limits import UNITS_OF_A_PICTURE
from lagrange.explain.words import bare, plural, spoken
from lagrange.mechanics.constraints.coordinates import GeneralizedCoordinates
from lagrange.mechanics.dynamics.newton import Newton
from lagrange.mechanics.results import Solution

if TYPE_CHECKING:
    from lagrange.document.scene import Scene
    from lagrange.mechanics.supports import Supports

CAPTION_OF_SYSTEM: tuple[Part, ...] = ("The system in a general position.",)
"""Below the picture of the system."""


def caption_of_choice(symbols: Sequence[Part]) -> tuple[Part, ...]:
    """Below the picture of the system in other coordinates."""
    return (plural(len(symbols), "The system with the coordinate ", "The system with the coordinates "),
            *listed(symbols), ".")  # fmt: skip


def caption_of_free_bodies(newton: Newton) -> tuple[Part, ...]:
    """Below the free-body diagrams."""
    bodies = newton.bodies or ()
    what = "The free body" if len(bodies) == 1 else "The free bodies"
    if not any(b.bound for b in bodies):
        return (f"{what}.",)
    if len([r for b in bodies for r in b.bound]) == 1:
        return (f"{what}; the unknown force is drawn in its positive direction.",)
    return (f"{what}; unknown forces are drawn in their positive directions.",)


def system_in_words(solution: Solution) -> str:
    """`Drawing of the system: P1, P2; upper rod, lower rod.`"""
    things = [bare(p.name) for p in solution.problem.masses]
    links = [s.name for s in solution.own.configuration.links]
    constraints = [c.name for c in solution.problem.constraints]
    everything = "; ".join(", ".join(map(spoken, group)) for group in (things, links, constraints) if group)
    return f"Drawing of the system: {everything}."


def free_bodies_in_words(newton: Newton) -> str:
    """`Free-body diagrams. P1: weight, upper rod.`"""
    sentences = []
    for b in newton.bodies or ():
        acting = [*(spoken(n) if n else "field" for n in b.loads), *(f"reaction of {spoken(r.name)}" for r in b.bound)]
        sentences.append(f"{bare(b.name)}: {', '.join(acting)}." if acting else f"{bare(b.name)}.")
    return " ".join(["Free-body diagrams.", *sentences])


def coordinates_in_words(coordinates: Sequence[sp.Symbol]) -> tuple[Part, ...]:
    """Coordinates as parts of a sentence."""
    return tuple(math(q) for q in coordinates)


def illustrated(steps: Iterable[Step], solution: Solution, notation: Notation) -> Iterator[Step]:
    """The steps with their pictures."""
    choices = iter(solution.choices)
    steps = tuple(steps)
    free = solution.law is not None and bool(solution.law.newton.bodies)
    later = any(s.rule is Rule.REACTIONS for s in steps)
    bodies = _of_free_bodies(solution, notation) if free else None
    for step in steps:
        match step.rule:
            case Rule.STATEMENT:
                words = len([*takewhile(_is_sentence, step.body[:2])])
                step = _with(step, words, _of_system(solution, notation, bodies))
                if bodies is not None and not later:
                    step = _with(step, len(step.body), bodies)
                yield step
            case Rule.REACTIONS if bodies is not None:
                yield _with(step, 1 if _is_sentence(step.body[0]) else 2, bodies)
            case Rule.GENERALIZED_COORDINATES:
                choice = next(choices, None)
                drawn = choice is not None and _has_new(choice.coordinates, solution)
                if choice is not None and drawn:
                    yield _with(step, len(step.body), _of_choice(solution, choice.coordinates, notation))
                else:
                    yield step
            case _:
                yield step


def _is_sentence(block: Block) -> bool:
    """Whether a block is a paragraph that ends, and does not lead to an equation."""
    return isinstance(block, Prose) and isinstance(block.parts[-1], str) and block.parts[-1].endswith(".")


def _has_new(coordinates: GeneralizedCoordinates, solution: Solution) -> bool:
    """Whether a choice has coordinates that the file does not have."""
    return not set(coordinates.configuration.slots.coordinates) <= set(solution.own.configuration.slots.coordinates)


def _with(step: Step, place: int, picture: Picture) -> Step:
    body: tuple[Block, ...] = (*step.body[:place], picture, *step.body[place:])
    return replace(step, body=body)


def _picture(draw: Callable[[], Scene | None], caption: tuple[Part, ...], alt: str) -> Picture:
    def drawn() -> Scene | None:
        try:
            with allowed_for("pictures", UNITS_OF_A_PICTURE):
                return draw()
        except GaveUpError:
            return None

    return Picture(cache(drawn), caption, alt)


def _of_system(solution: Solution, notation: Notation, free_bodies: Picture | None) -> Picture:
    """The system, with the applied forces where no free bodies show them; not the weights, where these cannot be drawn.

    An arrow beside the system shows gravity.
    """

    def draw() -> Scene | None:
        from lagrange.pictures.surfaces import has_generic_surface, surface_scene
        from lagrange.pictures.system_drawing import configuration_scene
        from lagrange.pictures.systems import system_in_file, without_weights

        if has_generic_surface(solution.own.configuration):
            return surface_scene(solution, notation)
        system = system_in_file(solution)
        if system is None:
            return None
        if free_bodies is not None and system.is_bare and free_bodies.draw() is None:
            return configuration_scene(without_weights(system), notation, with_loads=True)
        return configuration_scene(system, notation, with_loads=free_bodies is None)

    return _picture(draw, CAPTION_OF_SYSTEM, system_in_words(solution))


def _of_free_bodies(solution: Solution, notation: Notation) -> Picture:
    def draw() -> Scene | None:
        from lagrange.pictures.free_bodies import free_body_scene
        from lagrange.pictures.surfaces import has_generic_surface, surface_free_body
        from lagrange.pictures.systems import system_in_file

        if has_generic_surface(solution.own.configuration):
            return surface_free_body(solution, notation)
        system = system_in_file(solution)
        return None if system is None else free_body_scene(system, notation)

    assert solution.law is not None
    newton = solution.law.newton
    return _picture(draw, caption_of_free_bodies(newton), free_bodies_in_words(newton))


def of_supported_rod(solution: Solution, supports: Supports, sizes: Mapping[str, sp.Symbol]) -> Picture:
    """The free body of a rod on two supports."""

    def draw() -> Scene | None:
        from lagrange.pictures.free_bodies import supported_rod_scene
        from lagrange.pictures.systems import system_in_file

        system, normals = system_in_file(solution), {s.point: s.normal for s in supports.at}
        parameters = tuple(p.symbol for p in solution.problem.parameters)
        notation = Notation(solution.problem.slots.coordinates, parameters=parameters, forces=tuple(sizes.values()))
        return None if system is None else supported_rod_scene(system, normals, sizes, notation)

    acting = [
        *(spoken(f.name) for f in solution.own.configuration.loads),
        *(f"support at {s.point}" for s in supports.at),
    ]
    return _picture(draw, ("The free body.",), f"Free-body diagram. Rod: {', '.join(acting)}.")


def _of_choice(solution: Solution, coordinates: GeneralizedCoordinates, notation: Notation) -> Picture:
    configuration = coordinates.configuration
    chosen = configuration.slots.coordinates

    def draw() -> Scene | None:
        from lagrange.pictures.system_drawing import configuration_scene
        from lagrange.pictures.systems import system_in_choice

        system = system_in_choice(solution, configuration)
        scene = None if system is None else configuration_scene(system, notation, with_loads=False)
        marked = scene is not None and {label.content for label in scene.labels} >= set(chosen)
        return scene if marked else None

    return _picture(draw, caption_of_choice(coordinates_in_words(chosen)), system_in_words(solution))
