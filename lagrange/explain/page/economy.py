"""What a page can omit: what it said before, a letter defined twice; and what it says in one line or one section.

The derivation is written as if each of its steps stood alone. On the page they follow one another, and a step need not
repeat what the one before has said. Nothing is computed here; equal unit vectors are those with equal components.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import CONSTANT, Slots, t
from lagrange.document.derivation import (
    Block,
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
    has_purpose,
    index_of,
    listed,
    math,
    paired,
    paragraph,
    parts_of,
    prose,
)
from lagrange.explain.limits import LONGEST_IN_LINE, LONGEST_STEP, MOST_LINES_TWICE
from lagrange.explain.page.system import are_short
from lagrange.explain.words import counted, in_words, plural
from lagrange.mechanics.constraints.classification import Classification
from lagrange.mechanics.results import Solution
from lagrange.mechanics.rewriting.factors import in_factors_where, without_constant_factors

if TYPE_CHECKING:
    from lagrange.mechanics.questions.results import Asked

# -- what has been said ----------------------------------------------------------------------------------------------


def said_before(steps: Sequence[Step]) -> Iterator[Step]:
    """The steps without a second definition of a letter, and without a box of several lines that the head has too."""
    defined: dict[object, object] = {}
    head = next((s for s in steps if s.rule is Rule.RESULT), None)
    shown = [e.sides for b in head.body if isinstance(b, Display) for e in b.equations] if head else []
    asked: dict[object, list[str | None]] = {}
    kinematics: dict[object, list[str]] = {}
    for step in steps:
        blocks: list[Block] = []
        for block in step.body:
            if isinstance(block, Display) and step.rule is Rule.SOLVED_REACTIONS:
                asked |= {((e.sides[0], e.sides[-1]),): [e.label] for e in block.equations if e.label}
            if isinstance(block, Display) and step.rule is not Rule.RESULT:
                block = _defined_once(block, defined)
            if isinstance(block, Display) and step.rule is Rule.QUESTION and not block.boxed:
                sides = tuple(e.sides for e in block.equations)
                if sides in asked and blocks and isinstance(blocks[-1], Prose):
                    blocks[-1:] = [*_as_before([Ref(label) for label in asked[sides] if label])]
                    continue
                asked[sides] = [e.label for e in block.equations]
            if isinstance(block, Display) and _is_kinematic(block):
                sides = tuple(e.sides for e in block.equations)
                same, last = kinematics.get(sides), blocks[-1] if blocks else None
                if same is not None and has_purpose(last, Purpose.KINEMATICS):
                    blocks[-1] = replace(last, parts=(*last.parts, " given by ", *listed(map(Ref, same)), "."))
                    continue
                if all(e.label for e in block.equations):
                    kinematics[sides] = [e.label for e in block.equations if e.label]
            before = blocks[-1] if blocks else None
            if has_purpose(before, Purpose.IN_SHORT) and isinstance(block, Display) and _is_repeated(block, shown):
                assert isinstance(before, Prose)
                blocks[-1] = prose(Emphasis("In short"), ": ", *_combined(before))
            elif has_purpose(before, Purpose.CONSTANT_RATES) and isinstance(block, Display) and _is_shown(block, shown):
                if len(block.equations) == 1:
                    blocks.pop()
                else:
                    blocks[-1] = replace(before, parts=(*before.parts, " those at the head of the page."))
            else:
                blocks.append(block)
        if blocks or not step.body:
            yield replace(step, body=tuple(_referring_once(blocks)))


def _combined(in_short: Prose) -> tuple[Part, ...]:
    """The equations at the head of the page, with the step that leads to them as far as it is known."""
    how = in_short.parts[2:]
    if not how:
        return ("combined, these are the equations at the head of the page.",)
    return ("the equations at the head of the page; there", *how)


def _as_before(known: Sequence[Ref]) -> Iterator[Prose]:
    """`As before, (17) and (18) hold.`; nothing if there is nothing to refer to."""
    if known:
        holds = plural(len(known), " holds.", " hold.")
        yield prose("As before, ", *listed(known), holds, purpose=Purpose.AS_BEFORE)


def _referring_once(blocks: Iterable[Block]) -> Iterator[Block]:
    """The blocks with neighbouring references to what earlier questions found as one sentence."""
    known: list[Ref] = []
    alone: list[Block] = []
    for block in blocks:
        if has_purpose(block, Purpose.AS_BEFORE):
            known += [p for p in parts_of(block) if isinstance(p, Ref)]
            alone.append(block)
            continue
        yield from alone if len(alone) < 2 else _as_before(known)
        yield block
        known, alone = [], []
    yield from alone if len(alone) < 2 else _as_before(known)


def _is_kinematic(block: Display) -> bool:
    return block.is_of(EquationKind.ACCELERATION, EquationKind.MOMENTUM_RATE)


def _is_repeated(block: Display, shown: Sequence[object]) -> bool:
    """Whether a box of several lines has only equations that were shown."""
    return len(block.equations) > MOST_LINES_TWICE and _is_shown(block, shown)


def _is_shown(block: Display, shown: Sequence[object]) -> bool:
    return all(e.sides in shown for e in block.equations)


def in_pairs(steps: Sequence[Step]) -> Iterator[Step]:
    """The steps with short lines of one kind two by two: positions, forces, ω and H, accelerations, displacements."""
    referred = {p.label for s in steps for b in s.body for p in parts_of(b) if isinstance(p, Ref)}
    for step in steps:
        blocks = (
            replace(b, equations=tuple(_paired(b.equations, referred))) if isinstance(b, Display) and not b.boxed else b
            for b in step.body
        )
        yield replace(step, body=tuple(blocks))


_IN_PAIRS = frozenset({
    EquationKind.POSITION, EquationKind.FORCE, EquationKind.MOMENT, EquationKind.SPIN, EquationKind.MOMENTUM,
    EquationKind.ACCELERATION, EquationKind.MOMENTUM_RATE, EquationKind.DELTA, EquationKind.ROTATION,
    EquationKind.BEFORE, EquationKind.REACTION, EquationKind.COUPLE, EquationKind.NEWTON, EquationKind.TURNING,
    EquationKind.KINEMATIC, EquationKind.QUASI_VARIATION, EquationKind.SPEED, EquationKind.POSSIBLE_WORK,
})  # fmt: skip
"""Of which two short lines stand side by side."""
_ALSO_IN_PAIRS = (
    (EquationKind.SPIN, EquationKind.MOMENTUM),
    (EquationKind.REACTION, EquationKind.COUPLE),
    (EquationKind.DELTA, EquationKind.ROTATION),
)


def _paired(equations: Sequence[Equation], referred: Collection[str]) -> Iterator[Equation]:
    waiting: Equation | None = None
    for e in equations:
        if waiting is not None and _go_together(waiting, e) and e.label not in referred:
            yield paired((waiting, e))[0]
            waiting = None
            continue
        if waiting is not None:
            yield waiting
        waiting = e
    if waiting is not None:
        yield waiting


def _go_together(first: Equation, second: Equation) -> bool:
    kinds = (first.kind, second.kind)
    plain = not first.condition and not second.condition and first.relation == second.relation == "="
    alike = first.kind in _IN_PAIRS and (first.kind is second.kind or kinds in _ALSO_IN_PAIRS)
    return plain and alike and are_short((first, second))


def _defined_once(block: Display, defined: dict[object, object]) -> Display:
    """A box without its last line, a letter for a denominator, where a box before it has the same."""
    if len(block.equations) < 2:
        return block
    last = block.equations[-1]
    if len(last.sides) != 2 or last.label is not None or not block.boxed:
        return block
    letter, value = last.sides
    if not isinstance(letter, sp.Symbol) or letter == CONSTANT:
        return block
    if defined.setdefault(letter, value) != value or not any(
        isinstance(s, sp.Expr) and letter in s.free_symbols for e in block.equations[:-1] for s in e.sides
    ):
        return block
    if (letter, "seen") not in defined:
        defined[letter, "seen"] = True
        return block
    lines = block.equations[:-1]
    above = ("with ", math(letter), " as above")
    return replace(block, equations=(*lines[:-1], replace(lines[-1], condition=(*lines[-1].condition, *above))))


def together_shortly(classification: Classification, block: Block) -> Block:
    """What the constraints imply together, in one sentence instead of the construction of derived systems."""
    flag = classification.flag
    if not has_purpose(block, Purpose.FORMS_TOGETHER) or len(flag.ranks) < 2:
        return block
    several = sum(c.integrable is True for c in classification.constraints)
    if several == flag.integrable_rank == len(classification.constraints) - 1 and _rest_is_finite(classification):
        return prose()  # the only form that is not integrable has been tested where the others hold
    letter, rate = (p for p in block.parts if isinstance(p, Math))
    first, *rest = flag.ranks
    left = f"leaves {counted(rest[0], 'independent combination')} " if rest[0] else "leaves none of the combinations "
    course: tuple[Part, ...] = (left, letter, f" of the {first} forms")
    last = len(rest) - 1
    for n, rank in enumerate(rest[1:], start=1):
        these, many = plural(rest[n - 1], "it", "these"), "none" if rank == 0 else str(rank)
        course = (*course, f"; repeated with {these}, it leaves {many}" if n == 1 else f", and then {many}")
    passes = plural(rest[last], ", which passes again", ", which pass again") if rest[last] else ""
    return prose(
        f"Taken together, the constraints imply {_relations(flag.integrable_rank or 0, several)}, by Frobenius' "
        "theorem for several forms: the test that ", math(rate.sides[0]),
        " vanish for any two admissible displacements ", *course, f"{passes}.",
    )  # fmt: skip


def _rest_is_finite(classification: Classification) -> bool:
    return all(c.row.finite is not None for c in classification.constraints if c.integrable)


def _relations(together: int, single: int) -> str:
    """The joint implications of the constraints, in addition to relations implied by single ones."""
    if together == 0:
        return "no finite relation"
    if together == single:
        return "no finite relation beyond " + plural(single, "that one", "those")
    return f"{in_words(together, 'finite relation')} between the coordinates"


def likewise_in_a_line(body: Sequence[Block]) -> Iterator[Block]:
    """Frobenius' product of further forms in the paragraphs that say what follows; equal ones once."""
    blocks = list(body)
    alike: list[_FurtherForm] = []
    n = 0
    while n < len(blocks):
        form = _further_form(blocks[n : n + 4])
        if form is None or (alike and not alike[0].is_like(form)):
            yield from _as_one(alike)
            alike = []
        if form is None:
            yield blocks[n]
            n += 1
        else:
            alike.append(form)
            n += 4
    yield from _as_one(alike)


@record
class _FurtherForm:
    """`(7) is not exact either: ... With ω now for the form (7), ω ∧ dω = ... . This does not vanish: ...`"""

    exactness: Prose
    question: Prose
    shown: Equation
    verdict: Prose

    @property
    def product(self) -> tuple[Part, ...]:
        """`ω ∧ dω = ... and two more components`."""
        more = (" ", *self.shown.condition) if self.shown.condition else ()
        return (math(*self.shown.sides), *more)

    @property
    def does_not(self) -> str:
        """`which do` of several components."""
        return "which do" if self.shown.condition else "which does"

    def is_like(self, other: _FurtherForm) -> bool:
        """Whether the products are the same, so that a paragraph can be about both."""
        purposes = {self.exactness.purpose, other.exactness.purpose}
        return purposes == {Purpose.NOT_EXACT_EITHER} and self.product == other.product

    def in_a_line(self) -> Prose:
        """The paragraph on this form alone."""
        subject = index_of(Purpose.SUBJECT, self.verdict.parts)
        rest = self.verdict.parts if subject is None else self.verdict.parts[subject + 1 :]
        return paragraph(self.exactness, prose(*self.question.parts, *self.product, ", ", self.does_not, *rest))


def _further_form(blocks: Sequence[Block]) -> _FurtherForm | None:
    """Four blocks on a form after the theorem has been stated, if its product is short."""
    if len(blocks) < 4:
        return None
    exactness, question, shown, verdict = blocks
    if not isinstance(exactness, Prose) or not isinstance(shown, Display) or len(shown.equations) != 1:
        return None
    if not has_purpose(question, Purpose.NEXT_PRODUCT) or not has_purpose(verdict, Purpose.NEXT_NOT_INTEGRABLE):
        return None
    [e] = shown.equations
    value = e.sides[-1]
    if not isinstance(value, sp.Expr) or count_operations(value) > LONGEST_IN_LINE:
        return None
    return _FurtherForm(exactness, question, e, verdict)


def _as_one(forms: Sequence[_FurtherForm]) -> Iterator[Block]:
    """`(6) and (7) are not exact either: for (6), ... With ω for either of them, ...: neither is integrable.`"""
    if len(forms) < 2:
        yield from (form.in_a_line() for form in forms)
        return
    first = forms[0]
    refs = [form.exactness.parts[0] for form in forms]
    pair = first.exactness.parts[2:-1]
    letter = next(p for p in first.question.parts if isinstance(p, Math))
    each, none = ("either of them", "neither") if len(refs) == 2 else ("each of them", "none of them")
    yield prose(*listed(refs), " are not exact either: for ", refs[0], ", ", *pair, ". With ", letter, f" for {each}, ",
                *first.product, f", {first.does_not} not vanish identically: {none} is integrable.")  # fmt: skip


def freedom_in_one(steps: Iterable[Step]) -> Iterator[Step]:
    """The classification and the degrees of freedom in one section."""

    def join(first: Step, second: Step) -> Step | None:
        if (first.rule, second.rule) != (Rule.CLASSIFICATION, Rule.DEGREES_OF_FREEDOM) or first.choice != second.choice:
            return None
        title = "Classification and degrees of freedom"
        return replace(second, rule=first.rule, title=title, body=(*first.body, *second.body))

    return joined(steps, join)


def joined(steps: Iterable[Step], join: Callable[[Step, Step], Step | None]) -> Iterator[Step]:
    """The steps, with successive ones replaced by what `join` makes of them."""
    waiting: Step | None = None
    for step in steps:
        both = None if waiting is None else join(waiting, step)
        if waiting is not None and both is None:
            yield waiting
        waiting = both or step
    if waiting is not None:
        yield waiting


def remaining_shortly(step: Step, slots: Slots) -> Step:
    """A constraint that remains in a choice of coordinates, divided by constant factors common to all its terms."""
    moving = {*slots.coordinates, *slots.velocities, *slots.prescribed, t}

    def line(e: Equation) -> Equation:
        left = e.sides[0]
        if e.kind is not EquationKind.REMAINING_RATE or e.sides[1:] != (sp.S.Zero,) or not isinstance(left, sp.Expr):
            return e
        return replace(e, sides=(without_constant_factors(left, moving), sp.S.Zero))

    return step.map(line)


def lagrangian_once(step: Step) -> Step:
    """The step on a given Lagrangian without a second display of it, which the statement has."""
    body = list(step.body)
    for n, block in enumerate(body):
        if n and isinstance(block, Display) and [e.label for e in block.equations] == ["lagrangian"]:
            begins = prose(
                "The derivation begins with ",
                Ref("given-lagrangian"),
                ": there are no masses and forces to which d'Alembert's principle could be applied, and none that "
                "could check it.",
            )
            return replace(step, body=(*body[: n - 1], begins, *body[n + 1 :]))
    return step


def without_momenta(step: Step) -> Step:
    """The statement of bodies without their angular momenta, where these follow in quasi-velocities."""
    body: list[Block] = []
    for block in step.body:
        if isinstance(block, Display) and any(e.kind is EquationKind.MOMENTUM for e in block.equations):
            kept = tuple(e for e in block.equations if e.kind is not EquationKind.MOMENTUM)
            before = body[-1]
            assert isinstance(before, Prose)
            body[-1] = replace(before, parts=tuple(map(_without_momentum, before.parts)))
            positions = [e for e in kept if e.kind is EquationKind.POSITION]
            block = replace(block, equations=(*positions, *(e for e in kept if e not in positions)))
        body.append(block)
    return replace(step, body=tuple(body))


def _without_momentum(part: Part) -> Part:
    return part.instead if isinstance(part, Phrase) and part.purpose is Purpose.MOMENTA else part


def questions_shortly(solution: Solution, step: Step) -> Step:
    """The answer to a question with simple conditions substituted into long expressions; what stays long is omitted.

    With β = α and β' = α' the accelerations of a double pendulum are two short fractions. A velocity that is asked
    to be zero is zero in every expression.
    """
    asked = next((a for a in solution.asked if step.about and step.about == a.question.name), None)
    if asked is None:
        return step
    simple = {
        c.lhs: c.rhs for c in asked.question.when if isinstance(c.lhs, sp.Symbol) and isinstance(c.rhs, sp.Symbol)
    }
    resting = _resting(asked)
    simple |= resting
    body: list[Block] = []
    for block in step.body:
        if (
            not isinstance(block, Display)
            or block.boxed
            or (_longest(block) <= LONGEST_STEP and not _occur(resting, block))
        ):
            body.append(block)
            continue
        lines = tuple(_where(e, simple) for e in block.equations)
        short = replace(block, equations=tuple(e for e in lines if e.sides[0] != e.sides[-1]))
        before = body.pop() if body and isinstance(body[-1], Prose) else None
        if not simple or not short.equations or _longest(short) > LONGEST_STEP:
            continue
        if has_purpose(before, Purpose.IN_TERMS_OF):
            given = listed(math(a, b) for a, b in simple.items() if not str(a).endswith("''"))
            before = prose("With ", *given, ", the equations of motion give")
        body += [before, short] if before is not None else [short]
    return replace(step, body=tuple(body))


def _resting(asked: Asked) -> dict[sp.Expr, sp.Expr]:
    """The velocities that a question about a state asks to be zero."""
    from lagrange.mechanics.questions.results import Route

    if asked.route is not Route.STATE:
        return {}
    zero = [c.lhs for c in asked.question.when if isinstance(c.lhs, sp.Symbol) and c.rhs == 0]
    return {v: sp.S.Zero for v in zero if v.name.endswith("'") and not v.name.endswith("''")}


def _occur(symbols: Mapping[sp.Expr, sp.Expr], block: Display) -> bool:
    sides = (s for e in block.equations for s in e.sides if isinstance(s, sp.Expr))
    return any(not s.free_symbols.isdisjoint(symbols) for s in sides)


def _longest(block: Display) -> int:
    return max((count_operations(s) for e in block.equations for s in e.sides if isinstance(s, sp.Expr)), default=0)


def _where(e: Equation, simple: Mapping[sp.Expr, sp.Expr]) -> Equation:
    """An equation with simple values substituted; a symbol on the left stays."""
    first, *rest = (s if isinstance(s, sp.Expr) else sp.S.Zero for s in e.sides)
    first = first if first.is_Symbol else in_factors_where(first, simple)
    return replace(e, sides=(first, *(in_factors_where(s, simple) for s in rest)))
