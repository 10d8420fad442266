"""The answers in a problem file, compared with the derivation after each solve."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.answers.equations import check_equations, sides_of
from lagrange.answers.readings import read_answer
from lagrange.answers.references import Reference, reference_of_solution
from lagrange.answers.verdicts import (
    REST,
    STEADY_MOTION,
    WORST_TO_BEST,
    AnswerVerdict,
    EquationVerdict,
    Subject,
    Verdict,
    missing_equilibria,
)
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.records import all_hold
from lagrange.mechanics.results import Solution
from lagrange.problem.model import Answers, Problem

if TYPE_CHECKING:
    from lagrange.mechanics.constraints.classification import Classification
    from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
    from lagrange.mechanics.equilibrium.friction.friction_at_rest import AtRest as Rest
    from lagrange.mechanics.equilibrium.friction.rolling import Rolling


def compared_answers(solution: Solution) -> Iterator[AnswerVerdict]:
    """The verdicts on the file's own answers. Raises ProblemError if one cannot be read."""
    answers = solution.problem.answers
    if answers is None:
        return
    yield from on_freedom_and_class(solution, answers)
    if answers.equations and (verdict := _equations(solution, answers)) is not None:
        yield AnswerVerdict(verdict)
    yield from map(readable, answers_besides_equations(solution, answers))


def on_freedom_and_class(solution: Solution, answers: Answers) -> Iterator[AnswerVerdict]:
    """The verdicts on the degrees of freedom, the classification, and what is integrable."""
    classification = solution.classification
    if answers.degrees_of_freedom is not None:
        agrees = answers.degrees_of_freedom == classification.degrees_of_freedom
        why = ""
        if not agrees:
            from lagrange.answers.results.constraints import explained_degrees_of_freedom

            why = explained_degrees_of_freedom(answers.degrees_of_freedom, classification)
        yield AnswerVerdict(_agrees(agrees), name="degrees_of_freedom", diagnosis=why)
    if answers.classification:
        stated = {word: _class(solution, word) for word in answers.classification}
        yield _together("classification", stated, _why_not(stated, classification))
    if answers.integrable:
        derived = {c.constraint.name: c.integrable for c in classification.constraints}
        agree = {n: None if derived.get(n) is None else derived[n] == s for n, s in answers.integrable.items()}
        yield _together("integrable", agree, _why_not_integrable(answers.integrable, agree, classification))


def _why_not(parts: Mapping[str, bool | None], classification: Classification) -> str:
    """Why stated classes are wrong."""
    if False not in parts.values():
        return ""
    from lagrange.answers.results.constraints import explained_classes

    return explained_classes([word for word, agrees in parts.items() if agrees is False], classification)


def _why_not_integrable(
    stated: Mapping[str, bool], agree: Mapping[str, bool | None], classification: Classification
) -> str:
    """Why statements about what can be integrated are wrong."""
    if False not in agree.values():
        return ""
    from lagrange.answers.results.constraints import explained_integrability

    return explained_integrability({n: s for n, s in stated.items() if agree[n] is False}, classification)


def _together(name: str, parts: Mapping[str, bool | None], why: str = "") -> AnswerVerdict:
    """The verdict on several statements; it names the incorrect ones and says why they are wrong."""
    verdict = _agrees(all_hold(parts.values()))
    named = [n for n, agrees in parts.items() if agrees is (False if verdict is Verdict.WRONG else None)]
    heading = "undecided" if verdict is Verdict.UNDECIDED else "not right"
    diagnosis = f"{heading}: {', '.join(named)}" if len(parts) > 1 and named else ""
    return AnswerVerdict(verdict, name=name, diagnosis="; ".join(filter(None, (diagnosis, why))))


def _agrees(same: bool | None) -> Verdict:
    return Verdict.UNDECIDED if same is None else Verdict.EQUIVALENT if same else Verdict.WRONG


def _class(solution: Solution, word: str) -> bool | None:
    """Whether the system belongs to a class; None if that is undecided."""
    c = solution.classification
    positive = {"holonomic": c.holonomic, "scleronomic": c.scleronomic, "catastatic": c.catastatic}
    negative = {"nonholonomic": c.holonomic, "rheonomic": c.scleronomic, "acatastatic": c.catastatic}
    if word in positive:
        return positive[word]
    value = negative[word]
    return None if value is None else not value


def readable(answer: AnswerVerdict) -> AnswerVerdict:
    """The verdict on an answer of the file, without messages. Raises ProblemError if the answer cannot be read.

    A file may state some of the first integrals, as books do.
    """
    if answer.verdict is Verdict.UNREADABLE and answer.messages:
        raise ProblemError(answer.messages)
    if (answer.name, answer.verdict) == ("conserved", Verdict.INCOMPLETE):
        answer = replace(answer, verdict=Verdict.EQUIVALENT, missing=0, diagnosis="")
    return replace(answer, unreadable=(), notes=())


def answers_besides_equations(solution: Solution, answers: Answers) -> Iterator[AnswerVerdict]:
    """The verdicts on answers about equilibria, frequencies and reactions."""
    if answers.equilibrium:
        yield compared_equilibrium(solution, answers.equilibrium)
    if answers.rest:
        yield compared_rest(solution, answers.rest)
    if answers.frequencies or answers.decay:
        from lagrange.answers.questions.frequencies import check_oscillation_answers

        yield from check_oscillation_answers(answers, solution)
    if answers.reactions and (of_reactions := _reactions(solution, answers.reactions)) is not None:
        yield of_reactions
    if answers.ask:
        from lagrange.answers.questions.asked_quantities import check_asked

        yield check_asked(answers.ask, solution)
    yield from _quantities(solution, answers)


def _quantities(solution: Solution, answers: Answers) -> Iterator[AnswerVerdict]:
    """The verdicts on energies, generalized forces, first integrals, virtual displacements, Hamilton's function."""
    stated = answers.kinetic_energy, answers.generalized_forces, answers.conserved, answers.virtual_displacements
    if any(stated):
        from lagrange.answers.questions import stated_quantities as quantities

        if answers.kinetic_energy is not None:
            yield quantities.check_kinetic_energy(answers.kinetic_energy, solution)
        if answers.generalized_forces:
            yield quantities.check_generalized_forces(answers.generalized_forces, solution)
        if answers.conserved:
            yield quantities.check_conserved_answers(answers.conserved, solution)
        from lagrange.answers.questions.stated_constraints import about_constraints, check_constraints

        if answers.virtual_displacements and about_constraints(solution):
            from lagrange.answers.written.working import understood

            working = understood(answers.virtual_displacements, reference_of_solution(solution))
            yield replace(check_constraints(working, solution), name="virtual_displacements")
        elif answers.virtual_displacements:
            yield quantities.check_virtual_displacements(answers.virtual_displacements, solution)
    if answers.steady:
        from lagrange.answers.equilibria import check_steady_answers

        conditions = [v.steady.general for v in solution.views if v.steady is not None]
        if conditions:
            verdict = check_steady_answers(answers.steady, conditions, reference_of_solution(solution))
            yield replace(explained_steady(verdict, answers.steady, conditions, solution), name="steady")
        else:
            why = "the problem does not ask for steady motions"
            yield AnswerVerdict(Verdict.UNDECIDED, name="steady", diagnosis=why)
    if answers.response:
        from lagrange.answers.questions.response import check_response_answers

        yield check_response_answers(answers.response, solution)
    if answers.impact:
        from lagrange.answers.questions.impact import check_impact_answers

        yield check_impact_answers(answers.impact, solution)
    if answers.hamiltonian is not None:
        from lagrange.answers.questions.stated_quantities import check_hamiltonian_answer

        yield check_hamiltonian_answer(answers.hamiltonian, solution)


def compared_rest(
    solution: Solution, stated: Sequence[Fragment], defined: Mapping[str, sp.Expr] | None = None
) -> AnswerVerdict:
    """The verdict on the conditions of rest with friction; `defined` are names that the answer gives a meaning."""
    from lagrange.answers.friction.rest_conditions import check_rest_answers

    rests = conditions_of_rest(solution)
    if not rests:
        diagnosis = "the problem does not ask where it can be at rest with friction"
        return AnswerVerdict(Verdict.UNDECIDED, name="rest", diagnosis=diagnosis)
    reference = reference_of_solution(solution)
    if defined:
        scope = replace(reference.scope, scalars={**reference.scope.scalars, **defined})
        reference = replace(reference, scope=scope, declared=reference.declared | defined.keys())
    verdict = check_rest_answers(stated, rests, reference, solution)
    if verdict.verdict is not Verdict.UNREADABLE or len(stated) < 2:
        return verdict
    alone = [check_rest_answers([f], rests, reference, solution) for f in stated]
    unread = [v for v in alone if v.verdict is Verdict.UNREADABLE]
    read = [f for f, v in zip(stated, alone, strict=True) if v.verdict is not Verdict.UNREADABLE]
    if not unread or not read:
        return verdict
    rest = check_rest_answers(read, rests, reference, solution)  # one line that cannot be read does not sink the others
    stays = rest.verdict in (Verdict.EQUIVALENT, Verdict.WRONG, Verdict.UNDECIDED)
    return replace(
        rest,
        verdict=rest.verdict if stays else Verdict.UNREADABLE,
        equations=tuple(e for v in unread for e in v.equations),
        unreadable=tuple(d for v in unread for d in v.unreadable),
    )


def asks_for_rest_alone(solution: Solution) -> bool:
    """Whether a problem asks for conditions of rest, and for neither positions nor motion."""
    return solution.own.equilibrium is None and not any(v.impending or v.motion for v in solution.views)


def conditions_of_rest(solution: Solution) -> list[Rest | Rolling]:
    """The conditions of rest, and of rolling without slipping, in every set of coordinates."""
    return [r for v in solution.views for r in (v.at_rest, v.rolling) if r is not None]


def compared_impending(solution: Solution, alternatives: Sequence[Sequence[Fragment]]) -> AnswerVerdict:
    """The verdict on equilibria with friction at its limit, in the coordinates where it is best."""
    from lagrange.answers.friction.impending import check_impending_answers
    from lagrange.answers.friction.stated_limits import are_reversed

    reference = reference_of_solution(solution)
    verdicts = [
        check_impending_answers(alternatives, v.impending, reference, solution) for v in solution.views if v.impending
    ]
    best = replace(max(verdicts, key=lambda v: WORST_TO_BEST.index(v.verdict)), name="equilibrium")
    stated, rests = [f for a in alternatives for f in a], conditions_of_rest(solution)
    if best.verdict in (Verdict.EQUIVALENT, Verdict.INCOMPLETE) and are_reversed(stated, rests, reference, solution):
        return replace(best, verdict=Verdict.WRONG, diagnosis=_REVERSED)
    return best


_REVERSED = "the upper limit is stated as the lower one, or the other way round"


def compared_equilibrium(solution: Solution, alternatives: Sequence[Sequence[Fragment]]) -> AnswerVerdict:
    """The verdict on equilibria."""
    from lagrange.answers.equilibria import check_equilibria
    from lagrange.answers.questions.statics import compared_in_numbers, compared_with_rest
    from lagrange.answers.written.values import with_value_in_si

    if solution.rest_in_numbers is not None:
        return compared_with_rest(alternatives, solution.rest_in_numbers, solution)
    equilibria = [v.equilibrium for v in solution.views if v.equilibrium is not None]
    if not equilibria:  # small oscillations are about an equilibrium too
        equilibria = [v.linearization.equilibrium for v in solution.views if v.linearization is not None]
    reference = reference_of_solution(solution)
    alternatives = [[with_value_in_si(f, reference) for f in a] for a in alternatives]
    if any(v.impending for v in solution.views):
        return compared_impending(solution, alternatives)
    if not equilibria:
        diagnosis = "the problem does not ask for equilibrium"
        return AnswerVerdict(Verdict.UNDECIDED, name="equilibrium", diagnosis=diagnosis)
    verdict = check_equilibria(alternatives, equilibria, reference)
    verdict = compared_in_numbers(alternatives, verdict, solution)
    why = _about_equilibria(verdict, alternatives, equilibria, solution)
    return replace(verdict, name="equilibrium", diagnosis=why)


def explained_steady(
    verdict: AnswerVerdict,
    alternatives: Sequence[Sequence[Fragment]],
    conditions: Sequence[Equilibrium],
    solution: Solution,
) -> AnswerVerdict:
    """The verdict on conditions of steady motion, with what is missing, or what they are instead."""
    tried = [alternatives]
    if verdict.verdict is Verdict.WRONG and len(alternatives) == 1 and len(alternatives[0]) > 1:
        scope = reference_of_solution(solution).scope  # an equation without an undeclared tension, by itself
        tried = [[(f,)] for f in alternatives[0] if read_answer(f, scope).error is None] or tried
    changed = _changed_steady_motion(alternatives, solution) if verdict.verdict is Verdict.WRONG else ""
    whys = (_about_equilibria(verdict, a, conditions, solution, STEADY_MOTION) for a in tried)
    return replace(verdict, diagnosis=changed or next(filter(None, whys), ""))


def _changed_steady_motion(alternatives: Sequence[Sequence[Fragment]], solution: Solution) -> str:
    """The changed problem whose steady motions one stated condition describes; empty if not found, or if it is none."""
    from lagrange.answers.results.steady_motions import explained_steady_motion

    reference = reference_of_solution(solution)
    stated = [c for a in alternatives for f in a for c in read_answer(f, reference.scope).components]
    steady = {v.name: v.steady for v in solution.views if v.steady is not None}
    if len(stated) != 1:
        return ""
    candidates = [c for c in reference.candidates if c.choice in steady]
    return next(filter(None, (explained_steady_motion(stated[0], steady[c.choice], c) for c in candidates)), "")


def _about_equilibria(
    verdict: AnswerVerdict,
    alternatives: Sequence[Sequence[Fragment]],
    equilibria: Sequence[Equilibrium],
    solution: Solution,
    subject: Subject = REST,
) -> str:
    """What is missing, or the changed problem that has these positions."""
    if verdict.verdict is Verdict.INCOMPLETE:
        return missing_equilibria(verdict.missing)
    if verdict.verdict is not Verdict.WRONG:
        return ""
    return explained_rest(alternatives, equilibria, reference_of_solution(solution), solution.problem, subject)


def explained_rest(
    alternatives: Sequence[Sequence[Fragment]],
    equilibria: Sequence[Equilibrium],
    reference: Reference,
    problem: Problem | None,
    subject: Subject = REST,
) -> str:
    """Which changed problem has these positions, or where a value differs; empty if not found."""
    from lagrange.answers.equilibria import explained_equilibria
    from lagrange.answers.models.positions import explained_position

    if why := explained_equilibria(alternatives, equilibria, reference, problem, subject):
        return why
    readings = [read_answer(f, reference.scope) for a in alternatives for f in a]
    equations = [c for r in readings for c in r.components]
    known = {*reference.parameters.values(), *reference.scope.slots.coordinates, *reference.scope.slots.velocities}
    if not all(known.issuperset(e.free_symbols) for e in equations):
        return ""  # with a tension that is to be eliminated it gives no position by itself
    return next(filter(None, (explained_position(equations, e, subject) for e in equilibria)), "")


def _equations(solution: Solution, answers: Answers) -> Verdict | None:
    """The verdict on the file's equations; None if they are in a choice of coordinates that was not asked for."""
    if solution.linear_motion is not None:
        from lagrange.answers.questions.linear_equations import check_linear_motion_answers

        linear = check_linear_motion_answers(answers.equations, solution)
        if linear.unreadable:
            raise ProblemError(linear.unreadable)
        return linear.verdict
    if solution.own.motion is None:
        return Verdict.UNDECIDED
    verdict = check_equations(answers.equations, reference_of_solution(solution))
    if verdict.unreadable:
        raise ProblemError(verdict.unreadable)
    return None if verdict.verdict is Verdict.UNREADABLE and _some_left_out(solution) else verdict.verdict


def stated_equations(solution: Solution) -> tuple[tuple[sp.Expr, ...], ...]:
    """The file's equations of motion as they are written there, each with its sides.

    None if one is no pair of sides, or contains a reaction: then they are no equations of motion alone; none either
    if one has decimals, which are rounded.
    """
    answers = solution.problem.answers
    if answers is None or not answers.equations or any(_HAS_DECIMALS.search(f.text) for f in answers.equations):
        return ()
    sides = sides_of(answers.equations, reference_of_solution(solution))
    scalars = tuple(tuple(s for s in both if isinstance(s, sp.Expr)) for both in sides)
    if solution.law is not None:
        unknown = {s for r in solution.law.newton.reactions for s in (r.multiplier, r.force, r.symbol)}
        if any(e.free_symbols & unknown for pair in scalars for e in pair):
            return ()
    return scalars if all(len(s) == len(both) > 1 for s, both in zip(scalars, sides, strict=True)) else ()


def stated_reactions(solution: Solution, compared: Sequence[AnswerVerdict]) -> tuple[tuple[sp.Expr, ...], ...]:
    """The file's reactions `F = value` as written there, if they agree with the derived F."""
    answers, law = solution.problem.answers, solution.law
    judged = [p for a in compared if a.name == "reactions" for p in a.equations]
    if answers is None or law is None or not judged:
        return ()
    right = {p.text.partition(":")[0] for p in judged if p.verdict is Verdict.EQUIVALENT and not p.remarks}
    forces = {r.name: r.force for r in law.newton.reactions if r.name in right}
    fragments = [f for name, f in answers.reactions.items() if name in forces and "=" in f.text]
    plain = [f for f in fragments if not _HAS_DECIMALS.search(f.text)]
    sides = sides_of(plain, reference_of_solution(solution)) if plain else ()
    pairs = (tuple(s for s in both if isinstance(s, sp.Expr)) for both in sides)
    return tuple(pair for pair in pairs if len(pair) == 2 and pair[0] in forces.values())


_HAS_DECIMALS = re.compile(r"[0-9]\.[0-9]")


def _some_left_out(solution: Solution) -> bool:
    """Whether there are choices of coordinates that were not asked for."""
    return len(solution.choices) < len(solution.problem.choices)


def not_compared(solution: Solution, compared: Sequence[AnswerVerdict]) -> tuple[Diagnostic, ...]:
    """A note on the answers of the file in coordinates of a choice that was not asked for."""
    answers = solution.problem.answers
    if answers is None or solution.law is None or not _some_left_out(solution):
        return ()
    parts = {a.name: a.equations for a in compared}
    left_out = ["equations"] if answers.equations and "equations" not in parts else []
    left_out += [f"reactions: {name}" for name in answers.reactions] if answers.reactions else []
    judged = {f"reactions: {p.text.partition(':')[0]}" for p in parts.get("reactions", ())}
    names = ", ".join(f"`{name}`" for name in left_out if name not in judged)
    message = f"answers of the file in coordinates of other choices are not compared: {names}"
    return (Diagnostic("not-compared", message, help="without `--choice` all are").as_note(),) if names else ()


def _reactions(solution: Solution, stated: Mapping[str, Fragment]) -> AnswerVerdict | None:
    """The verdict on the stated reactions together, except those in a choice of coordinates that was not asked for."""
    if solution.law is None:
        diagnosis = "no reactions are derived for this problem"
        return AnswerVerdict(Verdict.UNDECIDED, name="reactions", diagnosis=diagnosis)
    from lagrange.answers.reactions import check_reaction

    reactions = {r.name: r for r in solution.law.newton.reactions}
    reference = reference_of_solution(solution)
    at_rest = None
    if solution.own.motion is None:
        from lagrange.answers.questions.statics import reactions_at_rest

        at_rest = reactions_at_rest(solution)
    parts: list[EquationVerdict] = []
    errors: list[Diagnostic] = []
    for name, fragment in stated.items():
        check = at_rest.check_stated if at_rest else partial(check_reaction, reference=reference, solution=solution)
        unreadable = EquationVerdict(f"{name}: {fragment.text}", Verdict.UNREADABLE)
        try:
            verdict = check(fragment, reactions[name])
        except ProblemError as error:
            errors += error.diagnostics
            verdict = unreadable
        if verdict is not None or not _some_left_out(solution):
            parts.append(verdict or unreadable)
    if not parts:
        return None
    order = (Verdict.UNREADABLE, Verdict.WRONG, Verdict.UNDECIDED)
    together = next((v for v in order if any(p.verdict is v for p in parts)), Verdict.EQUIVALENT)
    return AnswerVerdict(together, tuple(parts), unreadable=tuple(errors), name="reactions")
