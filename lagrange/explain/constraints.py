"""The constraints: their kinds, differential forms, exactness, integrability, classification, degrees of freedom.

An integrable form that is not exact gets its integrating factor: the multiplied form, the pairs of mixed partial
derivatives that are equal now, the finite relation. Forms with quasi-coordinates are written in
angles, because their partial derivatives decide nothing.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from itertools import groupby
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.forms.exact_forms import PartialsComparison
from lagrange.core.symbols import CONSTANT, Partial, Slots, Wedge, differential, t
from lagrange.document.derivation import (
    Block,
    Detail,
    Emphasis,
    Equation,
    Part,
    Phrase,
    Prose,
    Purpose,
    Ref,
    Rule,
    Step,
    Table,
    display,
    listed,
    math,
    paragraph,
    prose,
    series,
)
from lagrange.explain.constraint_systems import (
    explain_bending,
    explain_hidden,
    explain_losses,
    explain_manoeuvre,
    explain_reduction,
    explain_redundant,
    explain_together,
    form_letter,
    without_form,
)
from lagrange.explain.contact.one_sided import explain_in_contact, explain_one_sided
from lagrange.explain.limits import SHOWN_PAIRS
from lagrange.explain.words import brief, capital, constraints_called, counted, in_words, joined, plural, spoken, the
from lagrange.mechanics.constraints.classification import Classification
from lagrange.mechanics.constraints.constraints import ConstraintAnalysis, FrobeniusComponent
from lagrange.mechanics.constraints.displacements import possible_displacement
from lagrange.mechanics.rewriting.constraint_forms import integral_in_angle
from lagrange.mechanics.rewriting.factors import without_shared_constant

if TYPE_CHECKING:
    from lagrange.algebra.forms.restrictions import FiniteForm, Restriction


def equal(p: PartialsComparison) -> Part:
    """∂a/∂r = ... = ∂b/∂q."""
    (q, r), (a, b), (left, _) = p.variables, p.coefficients, p.derivatives
    return math(Partial(a, r), left, Partial(b, q))


def explain_factor(c: ConstraintAnalysis) -> list[Block]:
    """The factor and the finite relation of an integrable form that is not exact."""
    form = c.finite_form
    if form is None:
        tried = "products of powers, functions of one variable and symmetries were tried"
        return [prose(f"A factor exists but was not found: {tried}.")]
    body = [] if form.restriction is None else _explain_restriction(form.restriction)
    body += _explain_multiplied(form)
    if c.integral is None:
        return [*body, prose("The finite relation was not found in closed form.")]
    finite = Equation((c.integral, CONSTANT), label=f"integral-{c.row.name}")
    body += [prose("The constraint is equivalent to the finite relation"), display(finite)]
    return [*body, *_in_angle(c), _moral(form)]


def _in_angle(c: ConstraintAnalysis) -> Iterator[Block]:
    """The relation in the angle that was introduced, with the other coordinates in it: a curve as a book has it."""
    relation, form = integral_in_angle(c), c.finite_form
    if relation is None or form is None or form.restriction is None:
        return
    rules = (math(q, e) for q, e in form.restriction.rules if q not in relation.free_symbols)
    yield prose("In ", math(form.restriction.angles[0].symbol), " it reads, with ", *listed(rules), ",")
    yield display(Equation((relation, CONSTANT)))


def _explain_restriction(restriction: Restriction) -> list[Block]:
    """The substitution that satisfies the geometric constraints, and the form after it."""
    rules = listed(math(q, e) for q, e in restriction.rules)
    angles = restriction.angles
    named: tuple[Part, ...] = ()
    if angles:
        named = (plural(len(angles), ", with an angle ", ", with angles "), *listed(math(a.symbol) for a in angles))
    words = prose("There ", *rules, *named, ", and the form becomes")
    return [words, _shown(without_shared_constant(restriction.form), restriction.variables)]


def _explain_multiplied(form: FiniteForm) -> list[Block]:
    """The multiplied form and its pairs of mixed partial derivatives; pairs of zeros are omitted."""
    factor = form.found
    telling = [p for p in factor.exactness.comparisons if p.derivatives != (0, 0)]
    more = [prose(equal(p), detail=Detail.FULL) for p in telling[SHOWN_PAIRS:]]
    pairs = [*(prose(equal(p)) for p in telling[:SHOWN_PAIRS]), *more]
    if factor.factor == 1:
        return [prose("Its mixed partial derivatives agree", ":" if pairs else "."), *pairs]
    words = prose("An integrating factor is ", math(factor.factor), ". Multiplied by it, the form is")
    agree = prose("and now the mixed partial derivatives agree", ":" if pairs else ", all being zero.")
    shown = factor.form if form.restriction is None or telling else without_shared_constant(factor.form)
    return [words, _shown(shown, factor.variables), agree, *pairs]


def _moral(form: FiniteForm) -> Prose:
    """Where the factor is valid, and the moral."""
    factor, moral = form.found, "A form may be integrable without being exact."
    conditions: list[Part] = [math(g, sp.S.Zero, relation="≠") for g in factor.nonzero]
    conditions += [math(g, sp.S.Zero, relation=">") for g in factor.positive]
    if factor.factor == 1:
        return prose(moral)
    where: tuple[Part, ...] = ("where ", *listed(conditions)) if conditions else ("everywhere",)
    return prose("The factor is valid ", *where, ". ", moral)


def _shown(form: Sequence[sp.Expr], variables: Sequence[sp.Symbol]) -> Block:
    terms = (a * differential(v) for a, v in zip(form, variables, strict=True))
    return display(Equation((sp.Add(*terms), sp.S.Zero)))


def explain_quasi(c: ConstraintAnalysis, letter: str, *, likewise: bool) -> list[Block]:
    """A form with quasi-coordinates, which is judged in angles; `likewise`: the reason has been given already."""
    names, form, label = listed(math(q) for q in c.quasi), sp.Symbol(letter, real=True), Ref(f"form-{c.row.name}")
    one = len(c.quasi) == 1
    if likewise:
        words: list[Part] = [label, " likewise contains the ", "differential" if one else "differentials", " of the ",
                             "quasi-coordinate " if one else "quasi-coordinates ", *names]  # fmt: skip
        if c.integrable is None:
            return [prose(*words, "; it could not be decided whether it is integrable.")]
        return [prose(*words, "; written in angles, it is ", "integrable." if c.integrable else "not integrable.")]
    words = [
        label, " contains the ", "differential" if one else "differentials", " of ", *names,
        ", a quasi-coordinate: the time integral of a component of an angular velocity, which determines" if one
        else ", quasi-coordinates: time integrals of components of an angular velocity, which determine",
        " no position. So the partial derivatives of its coefficients do not decide whether it is integrable. ",
    ]  # fmt: skip
    if c.integrable is None:
        return [prose(*words, "This could not be decided.")]
    if c.restricted:
        angles = (
            "The angular velocity, given by fewer than three such rates, restricts the rotation by itself. Together "
            "with this restriction, and written in angles that determine the orientation of the body, the constraint "
        )
        if c.integrable:
            return [prose(*words, angles, "is equivalent to a finite relation.")]
        return [prose(*words, angles, "implies no finite relation: it is ", Emphasis("not integrable"), ".")]
    product = Wedge(form, differential(form))
    end: list[Part] = (
        [math(product, sp.S.Zero), ": it is equivalent to a finite relation."]
        if c.integrable
        else [math(product, sp.S.Zero, relation="≠"), ": it is ", Emphasis("not integrable"), "."]
    )
    angles = "Written in angles that determine the orientation of the body, this form, called "
    return [prose(*words, angles, math(form), ", has ", *end)]


def explain_constraints(classification: Classification, built_in: bool = False) -> Step:
    """Each constraint; which are geometric and which kinematic, and whether time appears."""
    constraints = classification.constraints
    if not constraints:
        words = "No constraints relate the coordinates"
        words += ": the positions, written in them, satisfy the constraints already." if built_in else "."
        return Step(Rule.CONSTRAINT, "Constraints", (prose(words),))
    body: list[Block] = []
    for given, group in groupby(constraints, key=lambda c: c.constraint.given):
        members = list(group)
        lines = []
        for c in members:
            note = f": {c.constraint.note}" if c.constraint.note else ""
            sides = (c.constraint.lhs, c.constraint.rhs)
            label = f"constraint-{c.row.name}"
            condition = (f"({spoken(c.row.name)}{note})",)
            lines.append(Equation(sides, label=label, relation=c.constraint.relation, condition=condition))
        body += explain_reduction(given, len(members)) if given is not None else []
        body.append(display(*lines))
    sentences = []
    for kinematic, velocities, kind in ((False, "no velocities", "geometric"), (True, "velocities", "kinematic")):
        members = [c for c in constraints if c.constraint.kinematic is kinematic]
        if members:
            refs = listed(Ref(f"constraint-{c.row.name}") for c in members)
            contains = plural(len(members), f" contains {velocities}: it is a ", f" contain {velocities}: they are ")
            what = plural(len(members), " constraint.", " constraints.")
            sentences.append(prose(*refs, contains, Emphasis(kind), what))
    timed = [c for c in constraints if c.contains_time]
    if timed:
        sentences.append(prose("Time appears in ", *listed(Ref(f"constraint-{c.row.name}") for c in timed), "."))
    else:
        several = "neither" if len(constraints) == 2 else "none of them"
        words = plural(len(constraints), "Time does not appear in it", f"Time appears in {several}")
        sentences.append(prose(Phrase(f"{words}.", Purpose.NO_TIME, words)))
    sentences += explain_in_contact(constraints)
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
    one = len(constraints) == 1
    differentials = (plural(len(geometric), "The differential of ", "The differentials of "), *listed(geometric))
    multiplied = (*listed(kinematic), " multiplied by ", math(differential(t)))
    both = bool(geometric and kinematic)
    beside = Phrase(", and ", Purpose.VERB)
    words: tuple[Part, ...] = (*differentials, beside, *multiplied, ",") if both else differentials
    body: list[Block] = [
        prose(*(words if geometric else multiplied), Phrase(" is" if one else " are", Purpose.VERB)),
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
    return Table(tuple(header), tuple(rows), Detail.STEPS if len(constraints) > 1 else Detail.FULL)


def explain_integrability(classification: Classification, slots: Slots, taken: Collection[str] = ()) -> Step:
    """Exactness, finite forms, Frobenius' theorem, the system as a whole. `taken`: names that the problem uses."""
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
    if len(classification.constraints) == 1 and classification.constraints[0].integrable is False:
        body += explain_manoeuvre(classification, slots)
    body += explain_together(classification, letter)
    body += explain_hidden(classification, slots, letter)
    return Step(Rule.INTEGRABILITY, "Integrability", tuple(body))


def _explain_finite(members: Sequence[ConstraintAnalysis]) -> list[Block]:
    """The geometric constraints: exact, being differentials of finite relations."""
    if not members:
        return []
    refs = listed(Ref(f"form-{c.row.name}") for c in members)
    relations = listed(Ref(f"constraint-{c.row.name}") for c in members)
    differentials = plural(len(members), " is the differential of the finite relation ",
                           " are the differentials of the finite relations ")  # fmt: skip
    words: list[Part] = [
        *refs,
        differentials,
        *relations,
        " and therefore ",
        Emphasis("exact"),
        ": the mixed partial derivatives agree",
    ]
    telling = [p for c in members if (p := telling_pair(c)) is not None]
    shown = [p for p in telling if 0 not in p.coefficients][:SHOWN_PAIRS]
    if shown:
        words += [", for instance ", *listed(map(equal, shown))]
    return [prose(*words, ".")]


def telling_pair(c: ConstraintAnalysis) -> PartialsComparison | None:
    """The most telling pair of partial derivatives: not 0 = 0, and not of a zero coefficient."""

    def weight(p: PartialsComparison) -> tuple[bool, bool]:
        return (p.derivatives == (0, 0), 0 in p.coefficients)

    pairs = c.exactness.comparisons
    return min(pairs, key=weight) if pairs else None


def _explain_exact(c: ConstraintAnalysis) -> list[Block]:
    """A kinematic constraint whose form is the differential of a function."""
    label = f"form-{c.row.name}"
    pair = telling_pair(c)
    words: list[Part] = ["The mixed partial derivatives of ", Ref(label), " agree"]
    words += [", for instance ", equal(pair)] if pair and 0 not in pair.coefficients else []
    words += [": the form is ", Emphasis("exact"), ". "]
    if c.integral is None:
        return [prose(*words, "Its finite relation was not found in closed form.")]
    finite = Equation((c.integral, CONSTANT), label=f"integral-{c.row.name}")
    return [prose(*words, "The constraint is equivalent to the finite relation"), display(finite)]


def _explain_not_exact(c: ConstraintAnalysis, geometric: Sequence[ConstraintAnalysis], letter: str) -> list[Block]:
    """The pairs that differ, and Frobenius' condition."""
    label = f"form-{c.row.name}"
    differing = c.exactness.differing
    if not differing:
        return [prose("It could not be decided whether ", Ref(label), " is exact.")]
    question = (
        "Is ",
        Ref(label),
        " the differential of a function? If so, its mixed partial derivatives would agree, but",
    )
    body: list[Block] = [prose(*question), *(prose(*_unequal(p)) for p in differing[:SHOWN_PAIRS])]
    if len(differing) > SHOWN_PAIRS:
        body += [prose(*_unequal(p), detail=Detail.FULL) for p in differing[SHOWN_PAIRS:]]
        body.append(prose(f"and likewise for {counted(len(differing) - SHOWN_PAIRS, 'further pair')}."))
    return [*body, *_explain_frobenius(c, label, geometric, letter)]


def _explain_likewise(c: ConstraintAnalysis, geometric: Sequence[ConstraintAnalysis], letter: str) -> list[Block]:
    """The same for a later constraint, after the theorem has been stated."""
    label = f"form-{c.row.name}"
    first, *others = c.exactness.differing
    body: list[Block] = [
        prose(Ref(label), " is not exact either: ", *_unequal(first), ".", purpose=Purpose.NOT_EXACT_EITHER)
    ]
    body += [prose(*_unequal(p), detail=Detail.FULL) for p in others]
    form, product = _forms(geometric, letter)
    question = prose("With ", math(form), " now for the form ", Ref(label), ", ", purpose=Purpose.NEXT_PRODUCT)
    where = _where(geometric)
    verdict = (f" not vanish{_identically(c)}{where}: ", Ref(label), " is not integrable.")
    end = prose(Phrase("This does", Purpose.SUBJECT), *verdict, purpose=Purpose.NEXT_NOT_INTEGRABLE)
    return [*body, *_verdict(c, product, question, end, where)]


def _forms(geometric: Sequence[ConstraintAnalysis], letter: str) -> tuple[sp.Symbol, Wedge]:
    """ω, and ω ∧ dω ∧ ω₁ ∧ ... with the forms of the geometric constraints."""
    form = sp.Symbol(letter, real=True)
    others = [sp.Symbol(f"{letter}_{n}", real=True) for n in range(1, len(geometric) + 1)]
    return form, Wedge(form, differential(form), *others)


IN_THREE_VARIABLES = (
    ": that is, in three variables, if the vector of its coefficients is perpendicular to its own curl. Here "
)
"""What the condition says without exterior products, for whoever does not know them."""


def _explain_frobenius(
    c: ConstraintAnalysis, label: str, geometric: Sequence[ConstraintAnalysis], letter: str
) -> list[Block]:
    form, product = _forms(geometric, letter)
    others = zip(product.args[2:], geometric, strict=True)
    forms = series([(math(form), " for the form ", Ref(label)),
                    *((math(symbol), " for ", Ref(f"form-{g.row.name}")) for symbol, g in others)])  # fmt: skip
    where = _where(geometric)
    given = f",{where}," if geometric else ""
    question = prose(
        "It is not exact, but an integrating factor may still exist; by Frobenius' theorem one does"
        f"{given} if and only if, with ", *forms, ", ", math(product, sp.S.Zero),
        IN_THREE_VARIABLES if len(c.row.coefficients) == 3 and not c.contains_time else ". Here ",
    )  # fmt: skip
    end = prose(
        f"This does not vanish{_identically(c)}{where}: there is no integrating factor, and the constraint hides no "
        "relation between the coordinates. It is ", Emphasis("not integrable"), ".",
    )  # fmt: skip
    return _verdict(c, product, question, end, where)


def _identically(c: ConstraintAnalysis) -> str:
    """What is to be said where a product contains coordinates: it may vanish at some positions."""
    coordinates = {q for p in c.exactness.comparisons for q in p.variables}
    return " identically" if any(k.coefficient.free_symbols & coordinates for k in c.frobenius if k.nonzero) else ""


def _where(geometric: Sequence[ConstraintAnalysis]) -> str:
    return " where the geometric constraints hold" if geometric else ""


def _verdict(c: ConstraintAnalysis, product: Wedge, begin: Prose, end: Prose, where: str) -> list[Block]:
    """The product and what follows from it; `begin` introduces it, `end` is for one that does not vanish."""
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


def _unequal(p: PartialsComparison) -> tuple[Part, ...]:
    (q, r), (a, b), (left, right) = p.variables, p.coefficients, p.derivatives
    return math(Partial(a, r), left), " ≠\u00a0", math(right, Partial(b, q))


def explain_classification(
    classification: Classification, taken: Collection[str] = (), *, excluded: bool = True
) -> Step:
    """Holonomic or not, scleronomic or rheonomic, and why.

    taken     names that the problem uses
    excluded  whether to name the places where a form would vanish and which the constraints exclude
    """
    constraints = classification.constraints
    words: list[Part]
    if classification.holonomic is None:
        words = ["It could not be decided whether the system is holonomic."]
    elif not constraints:
        words = ["Without constraints the system is ", Emphasis("holonomic"), "."]
    elif classification.holonomic:
        words = [_why_holonomic(constraints), ", so the system is ", Emphasis("holonomic"), "."]
    else:
        names = [c.row.name for c in constraints if c.integrable is False]
        verb = plural(len(names), "is not equivalent to a finite relation", "are not equivalent to finite relations")
        conclusion = Phrase(", so the system is ", Purpose.CONCLUSION)
        words = [f"{capital(constraints_called(names))} {verb}", conclusion, Emphasis("nonholonomic"), "."]
    sentences = (
        prose(*words),
        explain_time(classification),
        *(explain_one_sided(constraints) if excluded else ()),
        *explain_redundant(classification, form_letter(taken)),
        *explain_losses(classification, excluded=excluded),
    )
    return Step(Rule.CLASSIFICATION, "Classification", (brief(paragraph(*sentences), paragraph(*sentences[:2])),))


def _why_holonomic(constraints: Sequence[ConstraintAnalysis]) -> str:
    """The reason: finite relations as given, or equivalent to them, each alone or only together."""
    if not all(c.integrable for c in constraints):
        return "Taken together, the constraints are equivalent to finite relations"
    if all(c.row.finite is not None for c in constraints):
        return plural(len(constraints), "The constraint is a finite relation", "All constraints are finite relations")
    one = "The constraint is equivalent to a finite relation"
    return plural(len(constraints), one, "All constraints are equivalent to finite relations")


def explain_time(classification: Classification) -> Prose:
    """Scleronomic or rheonomic, and why."""
    if classification.scleronomic is None:
        return prose("It could not be decided whether time appears explicitly.")
    if classification.scleronomic:
        words = "Time does not appear explicitly, so the system is "
        if classification.weighed:
            words = "Time appears explicitly in a mass, but in no position and no constraint, so the system is "
        elif classification.forced:
            words = "Time appears explicitly in a force, but in no position and no constraint, so the system is "
        if classification.catastatic is False:
            linear = all(c.pfaffian or c.catastatic for c in classification.constraints)
            rest = (
                "a term without velocities remains" if linear else "the motion is not among the virtual displacements"
            )
            return prose(words, Emphasis("scleronomic"), f", though not catastatic, because {rest}.")
        return prose(words, Emphasis("scleronomic"), ".")
    unless = only_if(classification)
    words = f"Time appears explicitly in {_withtime_of(classification)}, so the system is "
    return prose(words, Emphasis("rheonomic"), *unless, ".")


def only_if(classification: Classification) -> tuple[Part, ...]:
    """` if u ≠ 0`, where all terms with time have a parameter that may be zero."""
    rate = classification.rheonomic_with
    return () if rate is None else (" if ", math(rate, sp.S.Zero, relation="≠"))


def _withtime_of(classification: Classification) -> str:
    """What contains time: constraints, else their finite forms, else positions and orientations."""
    timed = [c for c in classification.constraints if c.depends_on_time]
    explicit = [c.row.name for c in timed if c.contains_time]
    if explicit:
        return constraints_called(explicit)
    if timed:
        forms = plural(len(timed), "the finite form of", "the finite forms of")
        return f"{forms} {constraints_called(c.row.name for c in timed)}"
    where = []
    if classification.moving:
        positions = plural(len(classification.moving), "the position of", "the positions of")
        where.append(f"{positions} {joined(map(the, classification.moving))}")
    if classification.driven:
        where.append(f"the orientation of {joined(the(n) for n in classification.driven)}")
    return " and ".join(where)


def _difference(finite: int, kinematic: int) -> str:
    """Why the two counts differ; `finite` is the number of finite relations in the constraints."""
    if not finite:
        which = plural(kinematic, "constraint restricts", "constraints restrict")
        return f"The kinematic {which} the velocities at each position, but not the positions."
    which, beyond = plural(finite, "which restricts", "which restrict"), plural(finite, "it", "them")
    return (
        f"The constraints imply {in_words(finite, 'finite relation')}, {which} the positions; beyond {beyond} they "
        "restrict only the velocities at each position."
    )


def explain_freedom(classification: Classification) -> Step:
    """Both counts, and the meaning of their difference."""
    n, rank, freedom = classification.coordinates, classification.rank, classification.degrees_of_freedom
    pfaffian = all(c.pfaffian for c in classification.constraints)
    difference = f"{counted(n, 'coordinate')} − {counted(rank, 'independent constraint')} = "
    sentences = [
        prose(
            difference,
            Emphasis(f"{counted(freedom, 'degree')} of freedom"),
            ", the number of independent virtual displacements" + ("." if pfaffian else ", by Chetaev's rule."),
        )
    ]
    dimension = classification.reachable_dimension
    if dimension is None:
        sentences.append(prose("The dimension of the space of reachable configurations could not be decided."))
    elif dimension == freedom == 0:
        sentences.append(prose("No displacement is left free: the constraints alone determine the position."))
    elif dimension == freedom:
        sentences.append(prose(f"The space of reachable configurations also has dimension {dimension}: no constraint "
                               "restricts the velocities alone."))  # fmt: skip
    else:
        angles = ", the orientation of a body counted with three angles" if classification.further_angles else ""
        kinematic = sum(c.constraint.kinematic for c in classification.constraints)
        finite = classification.integrable_rank or 0
        words = f"The space of reachable configurations has dimension {dimension}{angles}. "
        shortly = "" if angles or finite else "All positions can be reached: only the velocities are restricted."
        sentences.append(prose(Phrase(words + _difference(finite, kinematic), Purpose.REACHED, shortly)))
    return Step(Rule.DEGREES_OF_FREEDOM, "Degrees of freedom", (brief(paragraph(*sentences), sentences[0]),))
