"""The constraints: what kind, their differential forms, exactness, integrability, classification, freedom."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from itertools import groupby

import sympy as sp

from lagrange.algebra.forms.integrability import Comparison
from lagrange.core.symbols import CONSTANT, Partial, Slots, Wedge, differential, t
from lagrange.document.derivation import (
    Block,
    Detail,
    Equation,
    Part,
    Prose,
    Ref,
    Rule,
    Step,
    Table,
    Term,
    display,
    listed,
    math,
    paragraph,
    prose,
)
from lagrange.explain.constraint_systems import (
    explain_hidden,
    explain_losses,
    explain_redundant,
    explain_together,
    form_letter,
)
from lagrange.explain.factors import SHOWN_PAIRS, equal, explain_factor
from lagrange.explain.nonlinear import explain_bending, explain_reduction, without_form
from lagrange.explain.quasi_coordinates import explain_quasi
from lagrange.explain.words import brief, counted, in_words, plural, spoken
from lagrange.mechanics.constraints.classification import Classification
from lagrange.mechanics.constraints.constraints import ConstraintAnalysis, FrobeniusComponent
from lagrange.mechanics.constraints.displacements import possible_displacement


def explain_constraints(classification: Classification) -> Step:
    """Each constraint; which are geometric and which kinematic, and whether time occurs."""
    constraints = classification.constraints
    if not constraints:
        return Step(Rule.CONSTRAINT, "Constraints", (prose("There are none: the coordinates are free."),))
    body: list[Block] = []
    for given, group in groupby(constraints, key=lambda c: c.constraint.given):
        members = list(group)
        lines = []
        for c in members:
            note = f": {c.constraint.note}" if c.constraint.note else ""
            sides = (c.constraint.lhs, c.constraint.rhs)
            label = f"constraint-{c.row.name}"
            lines.append(Equation(sides, label=label, condition=(f"({spoken(c.row.name)}{note})",)))
        body += explain_reduction(given, len(members)) if given is not None else []
        body.append(display(*lines))
    sentences = []
    for kinematic, why, kind in (
        (False, "No velocity occurs in ", "geometric"),
        (True, "Velocities occur in ", "kinematic"),
    ):
        members = [c for c in constraints if c.constraint.kinematic is kinematic]
        if members:
            refs = listed(Ref(f"constraint-{c.row.name}") for c in members)
            what = plural(len(members), " constraint.", " constraints.")
            sentences.append(prose(why, *refs, plural(len(members), ": a ", ": "), Term(kind), what))
    timed = [c for c in constraints if c.contains_time]
    if timed:
        sentences.append(prose("Time occurs in ", *listed(Ref(f"constraint-{c.row.name}") for c in timed), "."))
    else:
        sentences.append(prose(plural(len(constraints), "Time does not occur in it.", "Time occurs in none of them.")))
    title = plural(len(constraints), "The constraint", "Constraints")
    return Step(Rule.CONSTRAINT, title, (*body, paragraph(*sentences)))


def explain_forms(classification: Classification, slots: Slots) -> Step:
    """The differential forms, and the table of their coefficients."""
    constraints = [c for c in classification.constraints if c.pfaffian]
    others = [c for c in classification.constraints if not c.pfaffian]
    if not constraints:
        return Step(Rule.PFAFFIAN_FORM, "Differential form", tuple(without_form(others)))
    lines = (
        Equation((possible_displacement(c.row, slots), sp.S.Zero), label=f"form-{c.row.name}") for c in constraints
    )
    geometric = [Ref(f"constraint-{c.row.name}") for c in constraints if not c.constraint.kinematic]
    kinematic = [Ref(f"constraint-{c.row.name}") for c in constraints if c.constraint.kinematic]
    ways: list[Part] = []
    if geometric:
        ways += [plural(len(geometric), "The differential of ", "The differentials of "), *listed(geometric)]
    if kinematic:
        ways += [", and " if ways else "", *listed(kinematic), " multiplied by ", math(differential(t))]
    one = len(constraints) == 1
    body: list[Block] = [
        prose(*ways, " is" if one else ", are" if geometric and kinematic else " are"),
        display(*lines),
        _coefficients(constraints, slots),
        *without_form(others),
    ]
    return Step(Rule.PFAFFIAN_FORM, "Differential form" if one else "Differential forms", tuple(body))


def _coefficients(constraints: Sequence[ConstraintAnalysis], slots: Slots) -> Table:
    """The table of a_ji, with a_jt where some constraint has one."""
    with_time = any(c.row.drift != 0 for c in constraints)
    header: list[Part] = ["coefficient of", *(math(differential(q)) for q in slots.coordinates)]
    if with_time:
        header.append(math(differential(t)))
    rows: list[tuple[Part, ...]] = []
    for c in constraints:
        cells = (*c.row.coefficients, c.row.drift) if with_time else c.row.coefficients
        rows.append((spoken(c.row.name), *(math(a) for a in cells)))
    return Table(tuple(header), tuple(rows))


def explain_integrability(classification: Classification, slots: Slots, taken: Collection[str] = ()) -> Step:
    """Exactness by pairs, finite forms, Frobenius, and the system as a whole. `taken`: names that the problem has."""
    letter = form_letter(taken)
    finite = [c for c in classification.constraints if c.row.finite is not None]
    independent = [c for c in finite if c.row.name not in classification.redundant]
    body = _explain_finite(finite)
    explained = in_angles = False
    for c in classification.constraints:
        if c.row.finite is not None:
            continue
        if not c.pfaffian:
            body += explain_bending(c)
        elif c.quasi:
            body += explain_quasi(c, letter, likewise=in_angles)
            in_angles = True
        elif c.exactness.exact:
            body += _explain_exact(c)
        elif explained and c.exactness.differing:
            body += _explain_likewise(c, independent, letter)
        else:
            body += _explain_not_exact(c, independent, letter)
            explained = bool(c.exactness.differing)
    body += explain_together(classification, letter)
    body += explain_hidden(classification, slots, letter)
    return Step(Rule.INTEGRABILITY, "Integrability", tuple(body))


def _explain_finite(members: Sequence[ConstraintAnalysis]) -> list[Block]:
    """The geometric constraints: exact, being differentials of finite relations."""
    if not members:
        return []
    refs = listed(Ref(f"form-{c.row.name}") for c in members)
    relations = listed(Ref(f"constraint-{c.row.name}") for c in members)
    one = len(members) == 1
    words: list[Part] = [
        *refs,
        " is the differential of the finite relation " if one else " are the differentials of the finite relations ",
        *relations,
        ", so " + ("it is " if one else "they are "),
        Term("exact"),
        ": all pairs of partial derivatives agree",
    ]
    telling = [p for c in members if (p := _telling_pair(c)) is not None]
    shown = [p for p in telling if 0 not in p.coefficients][:SHOWN_PAIRS]
    for n, pair in enumerate(shown):
        words += [", for instance " if n == 0 else ", ", equal(pair)]
    return [prose(*words, ".")]


def _telling_pair(c: ConstraintAnalysis) -> Comparison | None:
    """The pair of partial derivatives that says most: one that is not 0 = 0 of zeros."""

    def weight(p: Comparison) -> tuple[bool, bool]:
        return (p.derivatives == (0, 0), 0 in p.coefficients)

    pairs = c.exactness.comparisons
    return min(pairs, key=weight) if pairs else None


def _explain_exact(c: ConstraintAnalysis) -> list[Block]:
    """A kinematic constraint whose form is a differential as it stands."""
    label = f"form-{c.row.name}"
    pair = _telling_pair(c)
    words: list[Part] = ["All pairs of partial derivatives of ", Ref(label), " agree"]
    words += [", for instance ", equal(pair)] if pair and 0 not in pair.coefficients else []
    words += [": it is ", Term("exact"), ". "]
    if c.integral is None:
        return [prose(*words, "Its finite form was not found in closed form.")]
    finite = Equation((c.integral, CONSTANT), label=f"integral-{c.row.name}")
    return [prose(*words, "The constraint is the finite relation"), display(finite)]


def _explain_not_exact(c: ConstraintAnalysis, geometric: Sequence[ConstraintAnalysis], letter: str) -> list[Block]:
    """The pairs that differ, and Frobenius' condition."""
    label = f"form-{c.row.name}"
    differing = c.exactness.differing
    if not differing:
        return [prose("Whether ", Ref(label), " is exact could not be decided.")]
    found: list[Block] = [
        prose(
            "Is ",
            Ref(label),
            " the differential of a function? Then its partial derivatives would agree in pairs, but",
        )
    ]
    found += [prose(*_unequal(p)) for p in differing[:SHOWN_PAIRS]]
    if len(differing) > SHOWN_PAIRS:
        found += [prose(*_unequal(p), detail=Detail.FULL) for p in differing[SHOWN_PAIRS:]]
        found.append(prose(f"and so on in {len(differing) - SHOWN_PAIRS} more pairs."))
    return [*found, *_explain_frobenius(c, label, geometric, letter)]


def _explain_likewise(c: ConstraintAnalysis, geometric: Sequence[ConstraintAnalysis], letter: str) -> list[Block]:
    """The same for a later constraint, when the theorem has been said."""
    label = f"form-{c.row.name}"
    first, *others = c.exactness.differing
    found: list[Block] = [prose(Ref(label), " is not exact either: ", *_unequal(first), ".")]
    found += [prose(*_unequal(p), detail=Detail.FULL) for p in others]
    form, product = _forms(geometric, letter)
    question = prose("With ", math(form), " for the form ", Ref(label), " now, ")
    where = _where(geometric)
    end = prose(f"This is not zero{where}: ", Ref(label), " is not integrable.")
    return [*found, *_verdict(c, product, question, end, where)]


def _forms(geometric: Sequence[ConstraintAnalysis], letter: str) -> tuple[sp.Symbol, Wedge]:
    """ω, and ω ∧ dω ∧ ω₁ ∧ ... with the forms of the geometric constraints."""
    form = sp.Symbol(letter, real=True)
    others = [sp.Symbol(f"{letter}_{n}", real=True) for n in range(1, len(geometric) + 1)]
    return form, Wedge(form, differential(form), *others)


def _explain_frobenius(
    c: ConstraintAnalysis, label: str, geometric: Sequence[ConstraintAnalysis], letter: str
) -> list[Block]:
    form, product = _forms(geometric, letter)
    others = product.args[2:]
    forms: list[Part] = [math(form), " for the form ", Ref(label)]
    for n, (symbol, g) in enumerate(zip(others, geometric, strict=True), start=1):
        forms += [" and " if n == len(others) else ", ", math(symbol), " for ", Ref(f"form-{g.row.name}")]
    given = f",{_where(geometric)}," if geometric else ""
    question = prose(
        "It is not exact. That alone does not settle it: a factor might still make it exact. By Frobenius' theorem one "
        f"does{given} just when, with ", *forms, ", ", math(product, sp.S.Zero), ". Here ",
    )  # fmt: skip
    where = _where(geometric)
    end = prose(
        f"This is not zero{where}: no factor exists at all, and no relation between the coordinates is hidden in the "
        "constraint. It is ", Term("not integrable"), ".",
    )  # fmt: skip
    return _verdict(c, product, question, end, where)


def _where(geometric: Sequence[ConstraintAnalysis]) -> str:
    return " where the geometric constraints hold" if geometric else ""


def _verdict(c: ConstraintAnalysis, product: Wedge, begin: Prose, end: Prose, where: str) -> list[Block]:
    """What the product is, and what follows; `begin` leads to it, `end` is said where it does not vanish."""
    if c.integrable is None:
        return [prose(*begin.parts, "it could not be decided whether ", math(product, sp.S.Zero), ".")]
    if c.integrable:
        words = ": an integrating factor exists, and the constraint is a finite relation in disguise."
        return [prose(*begin.parts, math(product, sp.S.Zero), where, words), *explain_factor(c)]
    nonzero = [k for k in c.frobenius if k.nonzero]
    more: tuple[Part, ...] = (f"and {in_words(len(nonzero) - 1, 'more component')}",) if len(nonzero) > 1 else ()
    shown = Equation((product, *map(_component, nonzero[:1])), label=f"frobenius-{c.row.name}", condition=more)
    return [begin, display(shown), end]


def _component(c: FrobeniusComponent) -> sp.Expr:
    return c.coefficient * Wedge(*(differential(v) for v in c.variables))


def _unequal(p: Comparison) -> tuple[Part, ...]:
    (q, r), (a, b), (left, right) = p.variables, p.coefficients, p.derivatives
    return math(Partial(a, r), left), " ≠\u00a0", math(right, Partial(b, q))


def explain_classification(classification: Classification, taken: Collection[str] = ()) -> Step:
    """Holonomic or not, scleronomic or rheonomic, and why. `taken`: names that the problem has."""
    constraints = classification.constraints
    words: list[Part]
    if classification.holonomic is None:
        words = ["Whether the system is holonomic could not be decided."]
    elif not constraints:
        words = ["Without constraints the system is ", Term("holonomic"), "."]
    elif classification.holonomic:
        alone = all(c.integrable for c in constraints)
        why = plural(len(constraints), "The constraint is a finite relation", "All constraints are finite relations")
        why = why if alone else "Taken together, the constraints come to finite relations"
        words = [f"{why}: the system is ", Term("holonomic"), "."]
    else:
        names = listed(spoken(c.row.name) for c in constraints if c.integrable is False)
        verb = " comes to no finite relation" if len(names) == 1 else " do not come to finite relations"
        words = [
            "The constraint " if len(names) == 1 else "The constraints ",
            *names,
            f"{verb}: the system is ",
            Term("nonholonomic"),
            ".",
        ]
    sentences = (
        prose(*words),
        _time(classification),
        *explain_redundant(classification, form_letter(taken)),
        *explain_losses(classification),
    )
    return Step(Rule.CLASSIFICATION, "Classification", (brief(paragraph(*sentences), paragraph(*sentences[:2])),))


def _time(classification: Classification) -> Prose:
    if classification.scleronomic is None:
        return prose("Whether time occurs could not be decided.")
    if classification.scleronomic:
        words = "Time occurs neither in the constraints nor in the positions: it is "
        if classification.catastatic is False:
            linear = all(c.pfaffian or c.catastatic for c in classification.constraints)
            rest = (
                "a term without velocities remains" if linear else "the motion is not among the virtual displacements"
            )
            return prose(words, Term("scleronomic"), f", though not catastatic, because {rest}.")
        return prose(words, Term("scleronomic"), ".")
    timed = [c for c in classification.constraints if c.depends_on_time]
    seen = [c for c in timed if c.contains_time]
    if seen:
        words = plural(len(seen), "Time occurs in the constraint ", "Time occurs in the constraints ")
        return prose(words, *listed(spoken(c.row.name) for c in seen), ": it is ", Term("rheonomic"), ".")
    if timed:
        words = plural(len(timed), "Time occurs in the finite form of the constraint ",
                       "Time occurs in the finite forms of the constraints ")  # fmt: skip
        return prose(words, *listed(spoken(c.row.name) for c in timed), ": it is ", Term("rheonomic"), ".")
    what = plural(len(classification.moving), "the position of ", "the positions of ")
    where: list[Part] = [what, *listed(classification.moving)] if classification.moving else []
    if classification.driven:
        where += [" and " if where else "", "the orientation of ", *listed(classification.driven)]
    return prose("Time occurs in ", *where, ": it is ", Term("rheonomic"), ".")


def _difference(finite: int) -> str:
    """What makes the two counts differ; `finite` is the number of finite relations in the constraints."""
    if not finite:
        return (
            "The difference is what the kinematic constraints do: they restrict the velocities at each position, and "
            "not the positions."
        )
    which, beyond = plural(finite, "which restricts", "which restrict"), plural(finite, "it", "them")
    return (
        f"The constraints come to {in_words(finite, 'finite relation')}, {which} the positions; what they demand "
        f"beyond {beyond} restricts only the velocities at each position."
    )


def explain_freedom(classification: Classification) -> Step:
    """Both counts, and what their difference means."""
    n, rank, freedom = classification.coordinates, classification.rank, classification.degrees_of_freedom
    pfaffian = all(c.pfaffian for c in classification.constraints)
    difference = f"{counted(n, 'coordinate')} − {counted(rank, 'independent constraint')} = "
    sentences = [
        prose(
            difference,
            Term(f"{counted(freedom, 'degree')} of freedom"),
            ", the number of independent virtual displacements" + ("." if pfaffian else ", by Chetaev's rule."),
        )
    ]
    dimension = classification.configuration_dimension
    if dimension is None:
        sentences.append(prose("The dimension of the configurations that can be reached could not be decided."))
    elif dimension == freedom == 0:
        sentences.append(prose("No displacement is left: the constraints alone determine where the system is."))
    elif dimension == freedom:
        sentences.append(prose(f"The configurations that can be reached have dimension {dimension} as well: "
                          "nothing is restricted in the velocities alone."))  # fmt: skip
    else:
        sentences.append(prose(f"The configurations that can be reached have dimension {dimension}. "
                               + _difference(n - dimension)))  # fmt: skip
    return Step(Rule.DEGREES_OF_FREEDOM, "Degrees of freedom", (brief(paragraph(*sentences), sentences[0]),))
