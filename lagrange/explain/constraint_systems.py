"""The constraints as a system: integrable together or not, hidden relations, redundancy, special configurations.

Constraints that are not linear in the velocities: reduction to linear ones, Chetaev's rule for the rest.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence

import sympy as sp

from lagrange.algebra.forms.hidden_relations import HiddenRelation
from lagrange.algebra.forms.velocity_polynomials import Reduction, Why
from lagrange.core.symbols import CONSTANT, FormSymbol, Slots, differential, t, variation
from lagrange.document.derivation import (
    Block,
    Emphasis,
    Equation,
    EquationKind,
    Part,
    Prose,
    Purpose,
    Ref,
    display,
    listed,
    math,
    paragraph,
    prose,
    series,
)
from lagrange.explain.limits import SHOWN_LOSSES
from lagrange.explain.words import capital, constraints_called, counted, in_words, joined, plural
from lagrange.mechanics.constraints.classification import Classification, Redundancy
from lagrange.mechanics.constraints.constrained_system import Row
from lagrange.mechanics.constraints.constraints import ConstraintAnalysis
from lagrange.mechanics.constraints.degeneracies import RankLoss
from lagrange.mechanics.constraints.displacements import virtual_displacement
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.problem.model import Given

LETTERS = ("omega", "eta", "chi", "zeta", "xi")
"""Letters for a form; the first that the problem does not use is taken."""


def form_letter(taken: Collection[str]) -> str:
    """The letter for a form: one with which no name of the problem begins."""
    return next((n for n in LETTERS if not any(name.startswith(n) for name in taken)), LETTERS[0])


def explain_together(classification: Classification, letter: str) -> list[Block]:
    """Frobenius' condition for the whole system, and its derived systems."""
    constraints, flag = classification.constraints, classification.flag
    if len(constraints) < 2 or all(c.row.finite is not None for c in constraints):
        return []
    if not all(c.pfaffian for c in constraints):
        return together(classification)
    if flag.integrable_rank is None:
        return [prose("It could not be decided how many finite relations the constraints imply together.")]
    relations = in_words(flag.integrable_rank, "finite relation") if flag.integrable_rank else "no finite relation"
    if all(c.integrable for c in constraints):
        return [prose(f"Taken together, the constraints are equivalent to {relations} between the coordinates.")]
    if any(c.restricted for c in constraints):
        return [prose(f"Together, and with what restricts the rotation, the constraints imply {relations}.")]
    omega = sp.Symbol(letter, real=True)
    question = prose(
        "Taken together, the constraints may imply finite relations that none implies alone. Only such combinations ",
        math(omega), " of the forms can belong to one for which ", math(differential(omega)), " vanishes for any two "
        "displacements that satisfy all the constraints.", purpose=Purpose.FORMS_TOGETHER,
    )  # fmt: skip
    if len(flag.ranks) == 1:
        answer = f"Here all of them do: by Frobenius' theorem the constraints are equivalent to {relations}."
    else:
        systems = plural(len(flag.ranks) - 1, "its derived system", "the derived systems")
        answer = (
            f"They form the derived system, from which the next is formed in the same way. "
            f"The system has rank {flag.ranks[0]}, {systems} "
            f"{joined(map(str, flag.ranks[1:]))}; by Frobenius' theorem the last is the number of finite relations: "
            f"the constraints imply {relations} between the coordinates."
        )
    return [paragraph(question, prose(answer))]


def explain_manoeuvre(classification: Classification, slots: Slots) -> list[Block]:
    """Which displacement, forbidden at every step, several steps add up to."""
    steps = classification.manoeuvre
    if steps is None:
        return []
    epsilon = sp.Symbol("epsilon", positive=True)
    first, second, left = (
        listed(math(variation(q), size * a) for q, a in zip(slots.coordinates, direction, strict=True) if a != 0)
        for direction, size in ((steps.first, epsilon), (steps.second, epsilon), (steps.left_over, epsilon**2))
    )
    return [prose("Yet the system can get where no single step leads: with a small ", math(epsilon), ", the steps ",
                  *first, ", then ", *second, ", then both back in the same order add up, to second order, to ", *left,
                  ", a displacement that the constraint forbids.")]  # fmt: skip


def explain_hidden(classification: Classification, slots: Slots, letter: str) -> list[Block]:
    """The finite relations that no single constraint shows."""
    hidden, missing = classification.hidden.found, classification.hidden.missing
    body: list[Block] = []
    if hidden:
        many = in_words(len(hidden), "relation").capitalize()
        what = f"{many} {plural(len(hidden), 'follows', 'follow')} that no single constraint shows:"
        lines = (
            Equation((r.function, CONSTANT), label=f"hidden-{n}", kind=EquationKind.HIDDEN)
            for n, r in enumerate(hidden, start=1)
        )
        body += [prose(what), display(*lines), *_explain_combinations(classification, slots, letter)]
    body += _explain_together(classification)
    if missing and len(classification.constraints) > 1:
        many = in_words(missing, f"{'further ' if hidden else ''}finite relation").capitalize()
        body.append(prose(f"{many} {plural(missing, 'exists', 'exist')}, not found in closed form."))
    return body


def _explain_together(classification: Classification) -> list[Block]:
    """What two of the relations say together: `(12) and (13) together say that θ + ψ = const.`"""
    names = [name for name, _ in classification.integrals]
    labels = [f"integral-{name}" if name else f"hidden-{n - names.index('') + 1}" for n, name in enumerate(names)]
    body: list[Block] = []
    for n, c in enumerate(classification.combined[:1], start=1):
        first, second = (Ref(labels[place]) for place in c.places)
        body += [
            prose(first, " and ", second, " together say that"),
            display(Equation((c.function, CONSTANT), label=f"combined-{n}"), boxed=True),
        ]
    return body


def _explain_combinations(classification: Classification, slots: Slots, letter: str) -> list[Block]:
    """The differentials of the hidden relations as combinations of the forms, where these are short."""
    hidden = classification.hidden.found
    shown = [r for r in hidden if r.combination is not None]
    if not shown:
        what = plural(len(hidden), "this function", "these functions")
        return [prose(f"No displacement that satisfies the constraints changes {what}: verified exactly.")]
    names = [c.row.name for c in classification.independent if c.pfaffian]
    used = {n for r in shown for n, c in zip(names, r.combination or (), strict=True) if c != 0}
    what = "its differential is" if len(hidden) == 1 else "the differentials are"
    what = what if len(shown) == len(hidden) else "those of the differentials with short combinations are"
    lines = (_as_combination(r, names, classification, slots, letter) for r in shown)
    end = plural(len(hidden), "so it does not change", "so they do not change")
    return [
        prose(*_with_symbols(classification, used, letter), what),
        display(*lines),
        prose(f"{end} in any displacement that satisfies the constraints."),
    ]


def _form_symbol(classification: Classification, name: str, letter: str) -> FormSymbol:
    """ω_j for the form of the j-th constraint."""
    place = [c.row.name for c in classification.constraints].index(name)
    return FormSymbol(f"{letter}_{place + 1}", real=True)


def _with_symbols(classification: Classification, names: Collection[str], letter: str) -> tuple[Part, ...]:
    """`With ω_1 for (3) and ω_2 for (4), `."""
    used = [c.row.name for c in classification.constraints if c.row.name in names]
    forms = ((math(_form_symbol(classification, n, letter)), " for ", Ref(f"form-{n}")) for n in used)
    return ("With ", *series(forms), ", ")


def _as_combination(
    relation: HiddenRelation, names: Sequence[str], classification: Classification, slots: Slots, letter: str
) -> Equation:
    """Σ ∂φ/∂q_k dq_k = Σ c_j ω_j."""
    variables = (*slots.coordinates, t)
    left = sp.Add(*(a * differential(v) for a, v in zip(relation.differential, variables, strict=True)))
    terms = zip(relation.combination or (), names, strict=True)
    return Equation((left, sp.Add(*(c * _form_symbol(classification, n, letter) for c, n in terms))))


def explain_redundant(classification: Classification, letter: str) -> list[Prose]:
    """Each redundant constraint with the combination that makes it so."""
    if not classification.redundancies:
        return []
    called = capital(constraints_called(r.name for r in classification.redundancies))
    follows = " is redundant: it follows from the preceding ones and is not counted."
    follow = " are redundant: they follow from the preceding ones and are not counted."
    sentences = [prose(called, plural(len(classification.redundancies), follows, follow))]
    shown = [r for r in classification.redundancies if r.combination]
    if shown:
        used = {n for r in shown for n in (r.name, *(name for name, _ in r.combination or ()))}
        equations = listed(math(*_redundancy(classification, r, letter)) for r in shown)
        sentences.append(prose(*_with_symbols(classification, used, letter), *equations, "."))
    return sentences


def _redundancy(classification: Classification, r: Redundancy, letter: str) -> tuple[sp.Expr, sp.Expr]:
    """ω_3 = ω_1 + 2 ω_2."""
    terms = (c * _form_symbol(classification, name, letter) for name, c in r.combination or ())
    return _form_symbol(classification, r.name, letter), sp.Add(*terms)


def explain_losses(classification: Classification, *, excluded: bool = True) -> list[Prose]:
    """The places where the constraints are not independent, and, if `excluded`, those that the constraints exclude."""
    sentences = []
    left_out: list[Part] = []
    alike: dict[tuple[str, int | None], list[RankLoss]] = {}
    finite = {c.row.name for c in classification.constraints if c.row.finite is not None}
    for loss in classification.losses[:SHOWN_LOSSES]:
        if loss.excluded and not excluded:
            continue
        place, form = math(*loss.conditions, sp.S.Zero), Ref(f"form-{loss.vanishing}")
        if loss.excluded:
            start: tuple[Part, ...] = ("; ", form) if left_out else ("The form ", form, " vanishes")
            verb = plural(len(loss.excluded), "excludes", "exclude")
            left_out += [*start, " only where ", place, f", which {constraints_called(loss.excluded)} {verb}"]
        else:
            key = (loss.vanishing or str(loss.conditions), loss.rank)
            alike.setdefault(key, []).append(loss)
    for losses in alike.values():
        [first, *_] = losses
        where = series([(math(*loss.conditions, sp.S.Zero),) for loss in losses], " or ")
        rank = _rank_there(classification, first)
        if first.vanishing:
            words: tuple[Part, ...] = (", the form ", Ref(f"form-{first.vanishing}"), " vanishes and restricts nothing")
            if first.vanishing in finite:
                words = (*words, "; ", Ref(f"constraint-{first.vanishing}"), " itself still holds")
        else:
            words = (", the constraints are not independent",)
        sentences.append(prose("Where ", *where, *words, *rank, "."))
    if left_out:
        sentences.append(prose(*left_out, "."))
    return sentences


def _rank_there(classification: Classification, loss: RankLoss) -> tuple[Part, ...]:
    one = len(classification.independent) == 1
    return () if one else (f": the rank is {loss.rank} there, not {classification.rank}",)


# Nonlinear


ZERO = sp.S.Zero

_BECAUSE = {
    Why.POWER: "a power is zero only where its base is",
    Why.FACTOR: "its other factors do not vanish",
    Why.QUOTIENT: "a quotient is zero only where its numerator is",
    Why.FUNCTION: "the function vanishes only at zero",
    Why.INVERSE: "the function takes no value twice",
    Why.DIRECTION: "the angle is that of a direction",
    Why.SQUARED: "both sides may be squared",
    Why.SQUARES: "a sum of real terms of one sign is zero only where all of them are",
    Why.FACTORED: "this is its factorized form",
    Why.EXPANDED: "this is its expanded form",
    Why.SPLIT: "the first alternative admits whatever the others do",
}


def explain_reduction(given: Given, count: int) -> list[Block]:
    """The constraint of the file, its reduction step by step; the `count` equivalent equations follow."""
    shown = display(Equation((given.lhs, given.rhs)))
    steps = [_sentence(step) for step in given.steps]
    end = "It is therefore equivalent to" if count == 1 else f"It is therefore equivalent to the {count} constraints"
    words = prose("is not linear in the velocities as it stands.")
    excluded = [*dict.fromkeys(e for step in given.steps for e in step.excluded)]
    if excluded:
        zeros = [math(e, ZERO) for e in excluded]
        words = prose(*words.parts, " It admits more velocities where ", *listed(zeros, " or "), "; such positions are "
                      "excluded here.")  # fmt: skip
    return [prose("The constraint"), shown, paragraph(words, *steps, prose(end))]


def _sentence(step: Reduction) -> Prose:
    """`x'² + y'² = 0 if and only if x' = 0 and y' = 0: a sum of real terms ...`"""
    zeros = listed((math(f, ZERO) for f in step.forms), " or " if step.why is Why.SPLIT else " and ")
    return prose(math(step.function, ZERO), " if and only if ", *zeros, *_conditions(step.conditions),
                 f": {_BECAUSE[step.why]}.")  # fmt: skip


def _conditions(conditions: Sequence[tuple[sp.Expr, str]]) -> tuple[Part, ...]:
    if not conditions:
        return ()
    return (" (where ", *listed(math(e, ZERO, relation=relation) for e, relation in conditions), ")")


def without_form(members: Sequence[ConstraintAnalysis]) -> list[Block]:
    """Constraints that are not linear in the velocities."""
    if not members:
        return []
    refs = listed(Ref(f"constraint-{c.row.name}") for c in members)
    if len(members) == 1:
        words = (" is neither linear in the velocities nor equivalent to linear equations. It has no differential form "
                 "and lies outside the ")  # fmt: skip
    else:
        words = (" are neither linear in the velocities nor equivalent to linear equations. They have no differential "
                 "forms and lie outside the ")  # fmt: skip
    return [prose(*refs, words, Emphasis("Pfaffian"), " class.")]


def explain_bending(c: ConstraintAnalysis) -> list[Block]:
    """Why a constraint that is not linear in the velocities is, or is not, equivalent to finite relations."""
    label = f"constraint-{c.row.name}"
    if c.integrable is None:
        return [prose("It could not be decided whether ", Ref(label), " is equivalent to a finite relation.")]
    if c.integrable:
        words = (" leaves no velocity free: it gives each as a function of position and time, perhaps in several "
                 "branches, and the solutions of such equations are finite relations between coordinates and "
                 "time.")  # fmt: skip
        return [prose(Ref(label), words)]
    why = prose(
        "A finite relation, differentiated with respect to time, is linear in the velocities: those that it admits at "
        "one position and time fill a plane. Those of ", Ref(label), " lie on a curved surface",
    )  # fmt: skip
    end = prose("No plane contains them: the constraint is ", Emphasis("not integrable"), ".")
    if c.bending is None:
        return [paragraph(Prose((*why.parts, ".")), end)]
    changes = [math(e) for e in c.bending.direction]
    shown: tuple[Part, ...] = (
        ": where ", *listed(math(v) for v in c.bending.velocities), " change in the ratio ", changes[0], " to ",
        changes[1],
        ", the constraint still holds to first order, but the second derivative of its left side minus its right side "
        "is ",
        math(c.bending.value, sp.S.Zero, relation="≠"), ".",
    )  # fmt: skip
    return [paragraph(Prose((*why.parts, *shown)), end)]


def together(classification: Classification) -> list[Block]:
    """The finite relations of all constraints, of which some are not linear in the velocities."""
    rank = classification.flag.integrable_rank
    if rank is None:
        return [prose("It could not be decided how many finite relations the constraints imply together.")]
    relations = counted(rank, "finite relation") if rank else "no finite relation"
    if classification.degrees_of_freedom == 0:
        return [prose(f"Taken together, the constraints leave no velocity free: they are equivalent to {relations}.")]
    words = (f"Taken together, the constraints imply {relations} between the coordinates: the velocities admitted at "
             "one position span all that the linear constraints leave, so the others add none.")  # fmt: skip
    return [prose(words)]


def virtual_conditions(rows: Iterable[Row], slots: Slots) -> tuple[Equation, ...]:
    """The equation that each constraint sets for virtual displacements."""
    return tuple(
        Equation(
            (virtual_displacement(r, slots), sp.S.Zero),
            label=f"virtual-{r.name}",
            kind=EquationKind.VIRTUAL,
            about=r.name,
        )
        for r in rows
    )


def by_chetaev(configuration: Configuration) -> list[Block]:
    """The virtual displacements of constraints that are not linear in the velocities: a postulate."""
    rows = [r for r in configuration.rows if r.nonlinear is not None]
    if not rows:
        return []
    of = f"rate-{configuration.name}-" if configuration.name else "constraint-"
    refs = listed(Ref(f"{of}{r.name}") for r in rows)
    lines = virtual_conditions(rows, configuration.slots)
    return [
        prose(
            "The condition that ", *refs, plural(len(rows), " imposes", " impose"), " on possible displacements is not "
            "linear, so their differences satisfy no linear condition, and virtual displacements cannot be found in "
            "that way. ", Emphasis("Chetaev's rule"),
            " admits those for which the derivatives of the constraint with respect to the velocities, each times the "
            "virtual displacement of its coordinate, add up to zero. For constraints linear in the velocities this is "
            "nothing new; for others it is a ", Emphasis("postulate"), " and follows from nothing above. Here it reads",
        ),
        display(*lines),
    ]  # fmt: skip
