"""Which pictures a derivation has, and where: the system, its free bodies, the coordinates of a choice.

Nothing is drawn here: a picture is drawn when a renderer asks for it, and then once.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from functools import cache
from itertools import takewhile

from lagrange.document.derivation import Block, Part, Picture, Prose, Rule, Step
from lagrange.document.notation import Notation
from lagrange.document.scene import Scene
from lagrange.explain.pictures import (
    CAPTION_OF_SYSTEM,
    caption_of_choice,
    caption_of_free_bodies,
    free_bodies_in_words,
    symbols_of,
    system_in_words,
)
from lagrange.mechanics.constraints.coordinates import GeneralizedCoordinates
from lagrange.mechanics.solution import Solution


def illustrated(steps: Iterable[Step], solution: Solution, notation: Notation) -> Iterator[Step]:
    """The steps with their pictures."""
    choices = iter(solution.choices)
    steps = tuple(steps)
    free = solution.law is not None and bool(solution.law.newton.bodies)
    later = any(s.rule is Rule.REACTIONS for s in steps)
    for step in steps:
        match step.rule:
            case Rule.STATEMENT:
                words = len([*takewhile(lambda b: isinstance(b, Prose), step.body[:2])])
                found = _with(step, words, _of_system(solution, notation, with_loads=not free))
                last = len(found.body)
                yield found if later or not free else _with(found, last, _of_free_bodies(solution, notation))
            case Rule.REACTIONS if free:
                yield _with(step, 1, _of_free_bodies(solution, notation))
            case Rule.GENERALIZED_COORDINATES:
                choice = next(choices, None)
                drawn = choice is not None and _has_new(choice.coordinates, solution)
                if choice is not None and drawn:
                    yield _with(step, len(step.body), _of_choice(solution, choice.coordinates, notation))
                else:
                    yield step
            case _:
                yield step


def _has_new(coordinates: GeneralizedCoordinates, solution: Solution) -> bool:
    """Whether a choice has coordinates that the file has not."""
    return not set(coordinates.configuration.slots.coordinates) <= set(solution.configuration.slots.coordinates)


def _with(step: Step, place: int, picture: Picture) -> Step:
    body: tuple[Block, ...] = (*step.body[:place], picture, *step.body[place:])
    return replace(step, body=body)


def _picture(draw: Callable[[], Scene | None], caption: tuple[Part, ...], alt: str) -> Picture:
    return Picture(cache(draw), caption, alt)


def _of_system(solution: Solution, notation: Notation, *, with_loads: bool) -> Picture:
    def draw() -> Scene | None:
        from lagrange.pictures.configurations import configuration_scene
        from lagrange.pictures.systems import system_in_file

        system = system_in_file(solution)
        return None if system is None else configuration_scene(system, notation, with_loads)

    return _picture(draw, CAPTION_OF_SYSTEM, system_in_words(solution))


def _of_free_bodies(solution: Solution, notation: Notation) -> Picture:
    def draw() -> Scene | None:
        from lagrange.pictures.free_bodies import free_body_scene
        from lagrange.pictures.systems import system_in_file

        system = system_in_file(solution)
        return None if system is None else free_body_scene(system, notation)

    assert solution.law is not None
    newton = solution.law.newton
    return _picture(draw, caption_of_free_bodies(newton), free_bodies_in_words(newton))


def _of_choice(solution: Solution, coordinates: GeneralizedCoordinates, notation: Notation) -> Picture:
    configuration = coordinates.configuration
    chosen = configuration.slots.coordinates

    def draw() -> Scene | None:
        from lagrange.pictures.configurations import configuration_scene
        from lagrange.pictures.systems import system_in_choice

        system = system_in_choice(solution, configuration)
        scene = None if system is None else configuration_scene(system, notation, with_loads=False)
        marked = scene is not None and {label.content for label in scene.labels} >= set(chosen)
        return scene if marked else None

    return _picture(draw, caption_of_choice(symbols_of(chosen)), system_in_words(solution))
