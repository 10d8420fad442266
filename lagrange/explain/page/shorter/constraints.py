"""Constraints in fewer lines: integrated at sight, their virtual displacements, and choices that leave one of them.

Constraints that integrate at sight, in one section: a wheel rolling along a line, or several that move.

R θ' = x' is R dθ − dx = 0, which is exact and integrates to R θ − x = const. It teaches nothing about integrability
that would justify three sections: the relations, their forms, the finite relation, classification and freedom share
one. A form that is exact only where the geometric constraints hold, ds − h dψ with h = R, belongs here too; one that
needs an integrating factor does not. Of several geometric constraints with time in them each is the differential of a
relation as well; a single one keeps its sections, which show what time changes.

Virtual displacements without a list of their own, where it would repeat that of the forms with δ for d.

Time does not appear in A dq = 0, so that virtual displacements satisfy A δq = 0: one sentence under the forms says it,
and what referred to the second list refers to the first.

A choice of coordinates that leaves a constraint, in fewer lines.

The full derivation states the constraint that is left for velocities, for displacements, solved for a displacement, and
solved for a velocity. Each follows from the one before at sight: the page has the first and the solved one.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise

import sympy as sp

from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import CONSTANT, VectorSymbol, differential, t
from lagrange.document.derivation import (
    Block,
    Detail,
    Display,
    Emphasis,
    Equation,
    EquationKind,
    Math,
    Part,
    Phrase,
    Prose,
    Purpose,
    Ref,
    Rule,
    Step,
    display,
    has_purpose,
    index_of,
    listed,
    math,
    paragraph,
    parts_of,
    prose,
)
from lagrange.explain.constraints import explain_time
from lagrange.explain.contact.one_sided import explain_in_contact
from lagrange.explain.limits import (
    LONGEST_INTEGRATED_RELATION,
    LONGEST_PRINCIPLE,
    LONGEST_PRINCIPLE_OF_BODIES,
    LONGEST_SOLVED_RELATION,
)
from lagrange.explain.page.constraints import relation_of
from lagrange.explain.page.system import are_short
from lagrange.explain.words import capital, counted, plural
from lagrange.mechanics.constraints.classification import Classification
from lagrange.mechanics.constraints.constrained_system import Row
from lagrange.mechanics.constraints.constraints import ConstraintAnalysis
from lagrange.mechanics.constraints.displacements import possible_displacement
from lagrange.mechanics.results import Solution
from lagrange.mechanics.rewriting.constraint_forms import common_number, without_common_number


def integrates_at_sight(solution: Solution) -> bool:
    """Whether all constraints are finite relations or integrate to them, on a page about a motion or an impact.

    Where all are finite relations and free of time, `explain_geometric` says so in fewer lines.
    """
    classification = solution.classification
    constraints = classification.constraints
    if solution.own.dynamics is None and solution.impact is None:
        return False
    kinematic = any(c.row.finite is None for c in constraints)
    moving = len(constraints) > 1 and any(c.contains_time for c in constraints)
    simple = all(_is_simple(c) for c in constraints) and (kinematic or moving)
    independent = classification.rank == len(constraints) and not classification.redundancies
    usual = all(loss.excluded for loss in classification.losses) and not classification.hidden.found
    return simple and independent and usual and classification.holonomic is True


def _is_simple(c: ConstraintAnalysis) -> bool:
    if c.constraint.given is not None or not c.pfaffian or c.quasi:
        return False
    if c.row.finite is not None:
        return True
    if c.contains_time or c.catastatic is not True:
        return False
    form = c.finite_form
    angles = form is not None and form.restriction is not None and form.restriction.angles
    exact_where_restricted = form is not None and not angles and form.found.factor == 1
    return c.integral is not None and (c.exactness.exact is True or exact_where_restricted)


def explain_at_sight(solution: Solution) -> Step:
    """The constraints, their forms, the relations that these integrate to, classification and freedom."""
    classification, slots = solution.classification, solution.problem.slots
    constraints = classification.constraints
    forms = (
        Equation((possible_displacement(_form(c), slots), sp.S.Zero), label=f"form-{c.row.name}") for c in constraints
    )
    relations = display(*map(relation_of, constraints))
    body: list[Block] = [relations, _kinds(constraints), display(*forms), *_integrated(constraints)]
    return Step(
        Rule.CONSTRAINT,
        plural(len(constraints), "The constraint", "Constraints"),
        tuple(_ending(body, _conclusions(classification))),
    )


def _ending(body: list[Block], conclusions: list[Prose]) -> list[Block]:
    """The conclusions, in the paragraph before them if there is one."""
    last = body[-1]
    if isinstance(last, Prose):
        return [*body[:-1], paragraph(last, *conclusions)]
    return [*body, paragraph(*conclusions)]


def _form(c: ConstraintAnalysis) -> Row:
    return without_common_number(c.row) if c.row.finite is not None else c.row


def _kinds(constraints: Sequence[ConstraintAnalysis]) -> Prose:
    """Which are geometric and which kinematic; how their forms come about."""
    geometric = [c for c in constraints if c.row.finite is not None]
    kinematic = [c for c in constraints if c.row.finite is None]
    timed = [Ref(f"constraint-{c.row.name}") for c in constraints if c.contains_time]
    refs = [listed(Ref(f"constraint-{c.row.name}") for c in group) for group in (geometric, kinematic)]
    are = [plural(len(group), " is ", " are ") for group in (geometric, kinematic)]
    words: list[Part] = []
    if geometric:
        words += [*refs[0], are[0], Emphasis("geometric"), ", " if kinematic else ""]
    if kinematic:
        words += [*refs[1], are[1], Emphasis("kinematic")]
    words += ["; time appears in ", *listed(timed), ". "] if timed else ["; time does not appear. "]
    sentences = explain_in_contact(constraints)
    words += [*sentences[0].parts, " "] if sentences else []
    divided = ", without common factors," if any(common_number(c.row) != 1 for c in geometric) else ""
    multiplied = (" multiplied by ", math(differential(t)))
    if not geometric:
        words += ["Multiplied by ", math(differential(t)), plural(len(constraints), ", it is", ", they are")]
    elif not kinematic:
        words += [f"Their differentials{divided} are"]
    else:
        differentials = plural(len(geometric), "The differential of ", "The differentials of ")
        words += [differentials, *refs[0], divided or ",", " and ", *refs[1], *multiplied, ", are"]
    return prose(*words)


def _integrated(constraints: Sequence[ConstraintAnalysis]) -> list[Block]:
    """That the forms are exact, at least where the others hold, and the relations that the kinematic ones are."""
    geometric = [c for c in constraints if c.row.finite is not None]
    kinematic = [c for c in constraints if c.row.finite is None]
    relations = listed(Ref(f"constraint-{c.row.name}") for c in geometric)
    refs = listed(Ref(f"form-{c.row.name}") for c in kinematic or geometric)
    if not kinematic:
        return [prose(*refs, " are ", Emphasis("exact"), ", being the differentials of ", *relations, ".")]
    restricted = [c for c in kinematic if c.exactness.exact is not True]
    where = ("Where ", *relations, plural(len(geometric), " holds, ", " hold, ")) if restricted else ()
    lead: tuple[Part, ...] = (*where, *refs, plural(len(kinematic), " is ", " are "), Emphasis("exact"))
    integrals = [c.integral for c in kinematic if c.integral is not None]
    if len(integrals) == 1 and count_operations(integrals[0]) <= LONGEST_INTEGRATED_RELATION:
        return [prose(*lead, " and integrates to ", math(integrals[0], CONSTANT), ".")]
    lines = (Equation((c.integral, CONSTANT), label=f"integral-{c.row.name}") for c in kinematic if c.integral)
    return [prose(*lead, plural(len(kinematic), " and integrates to", " and integrate to")), display(*lines)]


def _conclusions(classification: Classification) -> list[Prose]:
    freedom = classification.degrees_of_freedom
    timeless = classification.scleronomic is True
    time = prose("So the system is ", Emphasis("holonomic"), *((", and ", Emphasis("scleronomic")) if timeless else ()),
                 ".")  # fmt: skip
    count = f"{classification.coordinates}\u00a0−\u00a0{classification.rank}\u00a0=\u00a0"
    return [
        time,
        *([] if timeless else [explain_time(classification)]),
        prose(f"It has {count}", Emphasis(f"{counted(freedom, 'degree')} of freedom"), "."),
    ]


# Displacements


def with_one_list(steps: Sequence[Step]) -> Iterator[Step]:
    """The steps, without a list of conditions on virtual displacements that repeats the forms."""
    at = next((n for n, s in enumerate(steps) if s.rule is Rule.DISPLACEMENTS and not s.folded and not s.choice), None)
    names = [] if at is None else _repeated(steps, steps[at], [*steps[at + 1 :]])
    before = {e.label: n for n, s in enumerate(steps[:at]) for e in _equations(s) if not s.folded}
    forms = [f"form-{name}" for name in names]
    on_velocities = any(form not in before for form in forms)
    if on_velocities:
        forms = [f"constraint-{name}" for name in names]  # as they stand
    if at is None or not names or any(form not in before for form in forms):
        yield from steps
        return
    rule = {f"virtual-{name}": form for name, form in zip(names, forms, strict=True)}
    last = max(before[form] for form in forms)
    shown = {e.label: e for s in steps[:at] for e in _equations(s)}
    how = ", with δ in place of d:"
    if on_velocities:
        plain = all(shown[form].sides[-1] == 0 for form in forms)
        how = how.replace("d:", "d/dt:") if plain else ", the right sides taken to the left, and δ in place of d/dt:"
    for n, step in enumerate(steps):
        if n == at:
            continue
        yield _referring(_with_sentence(step, forms) if n == last else step, rule, how)


def _repeated(steps: Sequence[Step], step: Step, after: Sequence[Step]) -> list[str]:
    """The names of the constraints whose forms a step repeats, if it does nothing else that the page needs."""
    if len(step.body) < 2:
        return []
    first, shown, *rest = step.body
    if not has_purpose(first, Purpose.TIMELESS) or not isinstance(shown, Display):
        return []
    if not shown.equations or not shown.is_of(EquationKind.VIRTUAL):
        return []
    if rest and not (_are_used_later(after) and not _referred(rest, steps)):
        return []
    return [e.about for e in shown.equations]


def _are_used_later(after: Sequence[Step]) -> bool:
    """Whether displacements follow again where they are used: in coordinates that are chosen."""
    shown = [s for s in after if not s.folded]
    again = any(s.choice and any(_is_delta(e) for e in _equations(s)) for s in shown)
    return again or any(s.rule is Rule.FRICTION_AT_REST for s in shown)


def _is_delta(e: Equation) -> bool:
    return e.kind is EquationKind.DELTA


def _referred(blocks: Sequence[Block], steps: Sequence[Step]) -> bool:
    """Whether anything refers to an equation of these blocks, or uses what they solve for."""
    labels = {e.label for b in blocks if isinstance(b, Display) for e in b.equations if e.label}
    return any(p.label in labels for s in steps for b in s.body for p in parts_of(b) if isinstance(p, Ref))


def _equations(step: Step) -> Iterator[Equation]:
    yield from (e for b in step.body if isinstance(b, Display) for e in b.equations)


def _with_sentence(step: Step, forms: Sequence[str]) -> Step:
    """The step with the forms, and that virtual displacements satisfy them too."""
    refs = listed(map(Ref, forms))
    *body, last = step.body
    if isinstance(last, Prose) and index_of(Purpose.NO_TIME, last.parts[-1:]) is not None:
        *parts, end = last.parts
        assert isinstance(end, Phrase)
        them = plural(len(forms), "it", "them")
        so = f"{end.instead}, so virtual displacements satisfy {them} with δ in place of d/dt."
        return replace(step, body=(*body, prose(*parts, so, purpose=last.purpose)))
    words = prose("Since time does not appear, virtual displacements satisfy ", *refs, " with δ in place of d.")
    return replace(step, body=(*body, paragraph(last, words)) if isinstance(last, Prose) else (*body, last, words))


def _referring(step: Step, rule: dict[str, str], how: str) -> Step:
    """The step with references to other labels; `how` their sides are meant where these are multiplied."""

    def part(p: Part) -> Part:
        return Ref(rule[p.label]) if isinstance(p, Ref) and p.label in rule else p

    def block(b: Block) -> Block:
        if isinstance(b, Prose):
            parts = tuple(map(part, b.parts))
            if parts != b.parts and index_of(Purpose.LEFT_SIDES, parts[-1:]) is not None:
                parts = (*parts[:-1], how)  # it is a left side with d, or with velocities, now
            return replace(b, parts=parts, short=tuple(map(part, b.short)))
        if isinstance(b, Display):
            return replace(b, equations=tuple(replace(e, condition=tuple(map(part, e.condition))) for e in b.equations))
        return b

    return replace(step, body=tuple(map(block, step.body)))


# Choices


_RULES = (Rule.GENERALIZED_COORDINATES, Rule.EQUATIONS_OF_MOTION)


def in_few_lines(steps: Sequence[Step]) -> Iterator[Step]:
    """The steps, those in chosen coordinates shorter."""
    shown: dict[object, str] = {}
    for step in steps:
        if step.choice and not step.folded and step.rule in _RULES:
            body = _velocities_solved(_displacements_solved(_without_announcement([*step.body])))
            step = replace(step, body=tuple(_brackets_once(_kinematics_at_once(body, shown), steps)))
        elif not step.folded:
            lines = (e for b in step.body if isinstance(b, Display) and _is_kinematic(b) for e in b.equations)
            shown |= {e.sides: e.label for e in lines if e.label}
        yield step


def _without_announcement(body: list[Block]) -> list[Block]:
    """No `ψ is eliminated through its velocity`, where the velocity is then solved for."""
    return [b for b in body if not has_purpose(b, Purpose.ELIMINATED)]


def _place(purpose: Purpose, body: Sequence[Block]) -> int | None:
    return next((n for n, b in enumerate(body) if has_purpose(b, purpose)), None)


def _displacements_solved(body: list[Block]) -> list[Block]:
    """`In a virtual displacement δψ = (1/R) δs` without the equation of which this is the solution."""
    at = _place(Purpose.VIRTUAL, body)
    if at is None or len(body) < at + 4:
        return body
    solving, solved = body[at + 2], body[at + 3]
    if not has_purpose(solving, Purpose.SOLVING) or not isinstance(solved, Display) or solved.detail is Detail.FULL:
        return body
    where = _condition(solving)
    rest = body[at + 4 :]
    if rest and has_purpose(rest[0], Purpose.FREE):
        rest = rest[1:]
    begins: tuple[Part, ...] = ("In a virtual displacement", *where)
    if len(solved.equations) == 1 and solved.operations <= LONGEST_SOLVED_RELATION:
        return [*body[:at], prose(*begins, " ", math(*solved.equations[0].sides), "."), *rest]
    return [*body[:at], prose(*begins), solved, *rest]


def _condition(solving: Prose) -> tuple[Part, ...]:
    """`, where x ≠ 0,` of `Solving for δx, where x ≠ 0, gives`."""
    at = index_of(Purpose.WHERE, solving.parts)
    return () if at is None else solving.parts[at:-1]


def _velocities_solved(body: list[Block]) -> list[Block]:
    """Velocities and accelerations side by side, or in a sentence if there is one of each."""
    at = _place(Purpose.RATES, body)
    if at is None:
        return body
    solving, rates = body[at], body[at + 1]
    assert isinstance(solving, Prose)
    assert isinstance(rates, Display)
    half = len(rates.equations) // 2
    velocities, accelerations = rates.equations[:half], rates.equations[half:]
    if len(velocities) != len(accelerations):
        return body
    pairs = [e for both in zip(velocities, accelerations, strict=True) for e in both]
    end = body[at + 2]
    if half == 1 and sum(e.operations for e in pairs) <= LONGEST_SOLVED_RELATION and isinstance(end, Prose):
        refs = [p for p in solving.parts if isinstance(p, Ref)]
        if len(refs) == 1:
            both = listed(math(*e.sides) for e in pairs)
            words = prose("By ", *refs, ", ", *both, ". ", *end.parts)
            return [*body[:at], words, *body[at + 3 :]]
    if not are_short(pairs):
        return body
    lines = (replace(v, condition=(Math(a.sides),)) for v, a in zip(velocities, accelerations, strict=True))
    return [*body[: at + 1], display(*lines), *body[at + 2 :]]


def _brackets_once(body: list[Block], steps: Sequence[Step]) -> list[Block]:
    """A long principle not written out, where nothing is left to be done but to read off its brackets."""
    at = _place(Purpose.PRINCIPLE, body)
    if at is None or len(body) < at + 4:
        return body
    reads, written, vanish, box = body[at : at + 4]
    if not isinstance(written, Display) or not isinstance(box, Display) or not box.boxed:
        return body
    [line, *more] = written.equations
    used = any(p.label == line.label for s in steps for b in s.body for p in parts_of(b) if isinstance(p, Ref))
    turning = any(e.kind is EquationKind.ROTATION for b in body if isinstance(b, Display) for e in b.equations)
    longest = LONGEST_PRINCIPLE_OF_BODIES if turning else LONGEST_PRINCIPLE
    if more or used or line.operations <= longest or not isinstance(vanish, Prose):
        return body
    assert isinstance(reads, Prose)
    refs = [p for p in reads.parts if isinstance(p, Ref)]
    words = prose("Substitute these in d'Alembert's principle ", *refs, ". ", *vanish.parts)
    return [*body[:at], words, box, *body[at + 4 :]]


def _kinematics_at_once(body: list[Block], before: Mapping[object, str]) -> list[Block]:
    """Accelerations, virtual displacements and rotations of bodies in one display.

    before  the labels of those that the page has shown in the file's coordinates, by their sides
    """
    places = [n for n, b in enumerate(body) if isinstance(b, Display) and _is_kinematic(b)]
    if len(places) not in (2, 3) or any(b - a != 2 for a, b in pairwise(places)):
        return body
    shown = [b for n in places if isinstance(b := body[n], Display)]
    kinds = [_kind(b) for b in shown]
    if kinds not in (_KINEMATICS, [_KINEMATICS[0], _KINEMATICS[-1]]):
        return body
    lines = [e for b in shown for e in b.equations]
    if not all(_is_vector(e) for e in lines):
        return body
    first = _subject(body[places[0] - 1])
    moved = plural(len(shown[1].equations), "the virtual displacement", "the virtual displacements")
    turned = plural(len(shown[-1].equations), "the virtual rotation", "the virtual rotations")
    whats = [first, moved, turned] if len(shown) == 3 else [first, turned]
    known = [before.get(e.sides) for e in shown[0].equations]
    if all(known):
        refs = listed(Ref(label) for label in known if label)
        verb = plural(len(known), "is", "are")
        like = "formed like the angular velocity with δ for d/dt"
        are = plural(len(shown[-1].equations), "is", "are")
        begins = f"{moved} and, {like}, {turned} are" if len(shown) == 3 else f"{turned}, {like}, {are}"
        both = " and ".join(first.rsplit(", ", 1))
        given = prose(f"{capital(both)} {verb} given by ", *refs, f". {capital(begins)}")
        rest = [e for b in shown[1:] for e in b.equations]
        return [*body[: places[0] - 1], given, display(*rest), *body[places[-1] + 1 :]]
    what = f"{', '.join(whats[:-1])} and, formed like the angular velocity with δ for d/dt, {whats[-1]}"
    return [*body[: places[0] - 1], prose(f"{capital(what)} are"), display(*lines), *body[places[-1] + 1 :]]


def _subject(lead: Block) -> str:
    """`the accelerations, the rates of change of the angular momenta`, whose values follow."""
    assert isinstance(lead, Prose)
    subject = next(p for p in lead.parts if isinstance(p, Phrase) and p.purpose is Purpose.SUBJECT)
    return subject.instead


_KINEMATICS = [EquationKind.ACCELERATION, EquationKind.DELTA, EquationKind.ROTATION]


def _kind(block: Display) -> EquationKind | None:
    kind = block.equations[0].kind
    return EquationKind.ACCELERATION if kind is EquationKind.MOMENTUM_RATE else kind


def _is_kinematic(block: Display) -> bool:
    return block.is_of(*_KINEMATICS, EquationKind.MOMENTUM_RATE)


def _is_vector(e: Equation) -> bool:
    return isinstance(e.sides[0], VectorSymbol)
