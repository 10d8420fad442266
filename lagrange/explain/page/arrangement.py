"""The page from the full derivation: which steps come first, are joined, or are folded.

The full derivation has a step for each idea, in the order of the chapter. On the page the result comes first. Geometric
constraints that are independent and free of time need no separate sections on form, exactness, classification and
freedom: they share one. Displacements appear where they are used, with the work of the reactions. Of several choices of
coordinates the first is shown; the others are folded. All other steps are those of the derivation.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace

from lagrange.document.derivation import Block, Display, Part, Prose, Rule, Step, listed, math, paragraph
from lagrange.explain.consequences import explain_at_rest
from lagrange.explain.page import linked_particles
from lagrange.explain.page.constraints import (
    on_nonlinear_constraint,
    without_test,
)
from lagrange.explain.page.definitions import defined_in_order, in_one_name, without_unused
from lagrange.explain.page.economy import (
    freedom_in_one,
    in_pairs,
    joined,
    said_before,
)
from lagrange.explain.page.friction import with_reaction_first
from lagrange.explain.page.laws import (
    without_idle,
)
from lagrange.explain.page.meaning import explain_meaning
from lagrange.explain.page.motion import (
    ends_with_speeds,
    in_one_step,
    in_speeds_only,
    short_in_speeds,
    without_detour,
)
from lagrange.explain.page.result import explain_result, rest_has_roots
from lagrange.explain.page.shortening import Shortening, is_detour
from lagrange.explain.page.shorter.constraints import in_few_lines, integrates_at_sight, with_one_list
from lagrange.explain.page.shorter.held import put_in, with_held_values, with_values_put_in
from lagrange.explain.page.shorter.oscillations import in_one_box, response_shortly
from lagrange.explain.page.shorter.reactions import (
    counted_shortly,
    in_directions,
    with_stated_forces,
    with_sums_along_axes,
)
from lagrange.explain.page.shorter.sentences import in_fewer_words, with_lengths, with_symbol_first
from lagrange.explain.page.shorter.signs import with_like_terms_in_one, with_turned_sums
from lagrange.explain.page.shorter.unbound import without_unused_sections
from lagrange.explain.page.statics import said_once, with_supports
from lagrange.explain.page.surfaces import in_vectors, on_surface, work_of_surface
from lagrange.explain.page.system import alike_about_all_axes
from lagrange.explain.words import capital, plural, spoken
from lagrange.mechanics.meaning import meaning
from lagrange.mechanics.results import Solution
from lagrange.mechanics.rewriting.held_coordinates import held_together
from lagrange.mechanics.rewriting.quasi_velocities import StatedEquations, in_names, with_terms_added_in

_FOLLOWING = (Rule.EQUATIONS_OF_MOTION, Rule.EQUILIBRIUM)
"""What comes under one title with the coordinates in which it is."""
ABOUT_CONSTRAINTS = (
    Rule.CONSTRAINT,
    Rule.PFAFFIAN_FORM,
    Rule.INTEGRABILITY,
    Rule.CLASSIFICATION,
    Rule.DEGREES_OF_FREEDOM,
)


def steps_of_page(
    solution: Solution,
    steps: Iterable[Step],
    stated: StatedEquations = (),
    forces: StatedEquations = (),
    *,
    every_choice: bool = False,
) -> list[Step]:
    """The steps of the page.

    steps         of the full derivation
    stated        the equations of motion in the form of the file's answers, if these are right
    forces        likewise the reactions
    every_choice  whether no choice of coordinates is folded
    """
    solution = _with_best_choice_first(solution)
    arranged = [*_arranged(solution, steps, stated, forces, every_choice=every_choice)]
    return _through(_FINISHING, solution, arranged)


def _with_best_choice_first(solution: Solution) -> Solution:
    """The solution with choices in closed form before those with square roots of either sign."""
    return replace(solution, choices=tuple(sorted(solution.choices, key=lambda c: bool(c.signs))))


def _arranged(
    solution: Solution, steps: Iterable[Step], stated: StatedEquations, forces: StatedEquations, *, every_choice: bool
) -> Iterator[Step]:
    """The steps in the order of the page, the result first, those last that are folded."""
    first = solution.choices[0].name if solution.choices and not rest_has_roots(solution) else ""
    surface, link = on_surface(solution), linked_particles.linked(solution)
    plain, stated = stated, with_terms_added_in(in_names(solution, stated))
    named = in_names(solution, forces)
    if surface is not None or link is not None:
        stated = ()
    arranged = _through(_SHORTENING, solution, Shortening(solution).shortened(steps))
    open_, folded = [], []
    if not every_choice:
        arranged = without_detour(solution, arranged, lambda step: is_detour(solution, step))
    for step in _in_pairs(arranged):
        if every_choice or (step.choice in ("", first) and not is_detour(solution, step)):
            open_.append(step)
        elif not step.choice:
            folded.append(replace(step, folded=(step.title,)))
        else:
            folded.append(replace(step, folded=_summary(solution, step.choice)))
    if not every_choice:
        open_, tested = without_test(solution, open_)
        folded += tested
        open_ = [*with_sums_along_axes(solution, with_stated_forces(solution, open_, named, stated))]
        open_ = [*with_values_put_in(solution, open_)]
    # Of the reaction of a surface the box would need the abbreviations of its step.
    solved = [s for s in open_ if surface is None or s.rule is not Rule.SOLVED_REACTIONS]
    work = () if surface is None or solution.law is None else work_of_surface(surface)
    yield from explain_result(solution, solved, stated, work if link is None else linked_particles.work_of_link(link))
    shown = open_ if every_choice else [*_conserved_once(open_, first)]
    for step in _with_meaning(solution, shown, stated, plain):
        yield step if link is None or step.rule is not Rule.MEANING else linked_particles.meaning_of_link(link, step)
    yield from folded


def without_names_of_choices(steps: Iterable[Step]) -> Iterator[Step]:
    """The steps with plain titles, where those of one choice of coordinates are shown: they need no name."""
    steps = tuple(steps)
    shown = {s.choice for s in steps if s.choice and not s.folded}
    ending = f" (choice {spoken(next(iter(shown)))})" if len(shown) == 1 else None
    return (replace(s, title=s.title.removesuffix(ending)) if ending and not s.folded else s for s in steps)


def _in_pairs(steps: Iterable[Step]) -> Iterator[Step]:
    """The steps, with coordinates and the equations of motion, or the equilibrium, in them under one title."""
    waiting: Step | None = None
    for step in steps:
        follows = waiting is not None and step.rule in _FOLLOWING and step.choice == waiting.choice
        if waiting is not None and not follows:
            yield waiting
        if waiting is not None and follows:
            yield from in_one_step(waiting, step)
        elif step.rule is not Rule.GENERALIZED_COORDINATES:
            yield step
        waiting = step if step.rule is Rule.GENERALIZED_COORDINATES else None
    if waiting is not None:
        yield waiting


def _conserved_once(steps: Sequence[Step], first: str) -> Iterator[Step]:
    """The steps, without what is conserved in the file's coordinates where it follows in those of the first choice."""
    again = bool(first) and any(s.rule is Rule.CONSERVED and s.choice == first for s in steps)
    yield from (s for s in steps if not (again and s.rule is Rule.CONSERVED and not s.choice))


def _with_meaning(
    solution: Solution, steps: Sequence[Step], stated: StatedEquations, plain: StatedEquations
) -> Iterator[Step]:
    """The steps, with what the result says before questions and checks, and the conserved quantities in it."""
    said = meaning(solution)
    if said is None:
        yield from _before_checks(steps, explain_at_rest(solution.chosen))
        return
    conserved = next((s for s in steps if s.rule is Rule.CONSERVED and s.choice == said.view.name), None)
    shown = {e.label for s in steps for b in s.body if isinstance(b, Display) for e in b.equations}
    at_sight = integrates_at_sight(solution)
    step = explain_meaning(said, conserved, stated, shown, solution.problem, finite=at_sight, plain=plain)
    step = step and put_in(held_together(solution), step)
    yield from _before_checks((s for s in steps if s is not conserved), step)


def _before_checks(steps: Iterable[Step], step: Step | None) -> Iterator[Step]:
    """The steps, with another before questions and checks."""
    for s in steps:
        if step is not None and s.rule in (Rule.QUESTION, Rule.CHECKS):
            yield step
            step = None
        yield s


def _summary(solution: Solution, choice: str) -> tuple[Part, ...]:
    """`Other coordinate (choice depth): y`."""
    view = next(v for v in solution.choices if v.name == choice)
    coordinates = view.coordinates.choice.coordinates
    words = capital(plural(len(coordinates), "other coordinate", "other coordinates"))
    return (f"{words} (choice {spoken(choice)}): ", *listed(math(q) for q in coordinates))


def _without_bodies(solution: Solution, steps: Iterable[Step]) -> Iterator[Step]:
    """The steps, with reactions that are not forces on single bodies described together with their work."""
    if solution.law is None or solution.law.newton.bodies is not None:
        return iter(steps)

    def join(first: Step, second: Step) -> Step | None:
        reactions = (first.rule, second.rule) == (Rule.REACTIONS, Rule.WORKLESS)
        return replace(second, body=_meeting(first.body, second.body)) if reactions else None

    return joined(steps, join)


def _meeting(first: tuple[Block, ...], second: tuple[Block, ...]) -> tuple[Block, ...]:
    """Both, with the paragraphs at which they meet in one."""
    last, begin = first[-1:], second[:1]
    if last and begin and isinstance(last[0], Prose) and isinstance(begin[0], Prose):
        return (*first[:-1], paragraph(last[0], begin[0]), *second[1:])
    return (*first, *second)


# The passes


def _in_vectors(solution: Solution, steps: list[Step]) -> Iterable[Step]:
    """The steps of a particle on a surface, or of two particles on a rod, in vectors."""
    surface, link = on_surface(solution), linked_particles.linked(solution)
    if surface is not None:
        steps = [*in_vectors(surface, steps)]
    return steps if link is None else linked_particles.in_vectors(link, steps)


def _on_nonlinear_constraint(solution: Solution, steps: list[Step]) -> Iterable[Step]:
    about = (Rule.SOLVED_REACTIONS, Rule.CONSERVED, Rule.WORKLESS)
    return (on_nonlinear_constraint(solution, s) if s.rule in about else s for s in steps)


def _in_speeds_only(solution: Solution, steps: list[Step]) -> Iterable[Step]:
    return in_speeds_only(solution, steps) if ends_with_speeds(solution) else steps


def _alike_about_all_axes(solution: Solution, steps: list[Step]) -> Iterable[Step]:
    return (alike_about_all_axes(solution, s) for s in steps)


Pass = Callable[[Solution, list[Step]], Iterable[Step]]


def _of_steps(change: Callable[[list[Step]], Iterable[Step]]) -> Pass:
    """A pass that needs the steps only."""
    return lambda _, steps: change(steps)


_SHORTENING: tuple[tuple[Pass, str], ...] = (
    (said_once, "which steps there are: all others need only be made for these"),
    (with_supports, "adds reactions at rest, in place of the step that said there are none"),
    (_alike_about_all_axes, "H = J ω, while angular momenta are still components"),
    (_on_nonlinear_constraint, "v² for x'² + y'², while reactions are still components"),
    (_in_vectors, "makes whole sections anew, and so comes after what changes their lines"),
    (_in_speeds_only, "leaves the principle out where quasi-velocities follow"),
    (without_idle, "leaves out work that is zero, before sections on reactions are joined"),
    (_without_bodies, "joins the sections on reactions and their work"),
    (_of_steps(freedom_in_one), "joins the sections on classification and freedom, now neighbours"),
)
"""What is done to the steps before some are folded and the head is made, with the reason for its place."""
_FINISHING: tuple[tuple[Pass, str], ...] = (
    (without_unused_sections, "makes displacements anew where they are used, and so comes first"),
    (in_one_name, "first of the others, as these compare unit vectors by their names"),
    (short_in_speeds, "shorter components, before vectors are made of them"),
    (in_directions, "vectors as multiples of named ones, once their components are final"),
    (with_reaction_first, "moves steps, and so comes before all that ask what has been said above"),
    (_of_steps(with_one_list), "refers to the forms above in place of a list of displacements"),
    (with_held_values, "puts values in before lengths decide what is written out"),
    (_of_steps(in_few_lines), "omits long lines to which nothing refers any more"),
    (_of_steps(in_one_box), "boxes of small motions, before letters are found for their denominators"),
    (counted_shortly, "counts the equations that are left"),
    (_of_steps(with_symbol_first), "conditions turned round, before they are compared"),
    (response_shortly, "refers to the boxes of the equations of motion, which are final"),
    (with_lengths, "letters for long roots, once all lines that have them are there"),
    (_of_steps(in_fewer_words), "pairs displacements and substitutions in lines that stay"),
    (with_like_terms_in_one, "the last change of a frequency, before repetitions are sought"),
    (_of_steps(said_before), "compares finished lines, and omits those said before"),
    (without_unused, "definitions of what no line has now"),
    (_of_steps(defined_in_order), "the definitions that are left"),
    (_of_steps(with_turned_sums), "signs, which no later pass compares"),
    (_of_steps(in_pairs), "last: two short lines as one could not be compared any more"),
)
"""What is done to the page, the head included, with the reason for its place."""


def _through(passes: Iterable[tuple[Pass, str]], solution: Solution, steps: Iterable[Step]) -> list[Step]:
    """The steps after all passes, one after another."""
    finished = [*steps]
    for change, _reason in passes:
        finished = [*change(solution, finished)]
    return finished
