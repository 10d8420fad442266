"""Geometric constraints on a page, alone or beside kinematic ones; why others are not integrable, folded.

Geometric constraints in one section: the relations, their differentials, exactness, classification, freedom.

Where every constraint is a finite relation between the coordinates, free of time and independent of the others,
each of these takes one line. Where any of this needs an argument, the sections of the full derivation are kept.

Geometric constraints beside kinematic ones: their forms without common factors, here as where they stand alone.

Forms and their partial derivatives are those of the full derivation, divided by the whole number that their
coefficients have in common; so is Frobenius' product, once for each form in it.

What a page that derives a motion, an impact or rest shows only on request: why its constraints are not integrable.

The question of integrability is a subject of its own where a problem asks about constraints. On the way to a motion
the answer suffices: no constraint on velocities is a relation between coordinates. The differential forms are then
the constraints themselves with dx for ẋ; the virtual displacements satisfy them with δx.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.forms.exact_forms import PartialsComparison
from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import (
    DotProduct,
    Slots,
    TimeDerivative,
    Unspecified,
    VectorSymbol,
    Wedge,
    differential,
    variation,
)
from lagrange.document.derivation import (
    Block,
    Detail,
    Display,
    Emphasis,
    Equation,
    EquationKind,
    Mathematics,
    Part,
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
    prose,
)
from lagrange.explain.constraint_systems import explain_losses
from lagrange.explain.constraints import (
    IN_THREE_VARIABLES,
    equal,
    explain_forms,
    explain_integrability,
    explain_time,
    telling_pair,
)
from lagrange.explain.contact.one_sided import explain_in_contact
from lagrange.explain.displacements import explain_displacements, pivot_conditions
from lagrange.explain.limits import LONGEST_PIVOT, LONGEST_SOLUTION
from lagrange.explain.reactions import while_moving
from lagrange.explain.words import counted, in_words, plural, spoken
from lagrange.mechanics.constraints.classification import Classification
from lagrange.mechanics.constraints.constrained_system import Row
from lagrange.mechanics.constraints.constraints import ConstraintAnalysis
from lagrange.mechanics.constraints.displacements import possible_displacement
from lagrange.mechanics.results import Solution
from lagrange.mechanics.rewriting.constraint_forms import (
    common_number,
    frobenius_on_surface,
    only_coordinate,
    vanishing_components,
    without_common_number,
)
from lagrange.mechanics.rewriting.quasi_velocities import squares_by_constraints, with_squares
from lagrange.problem.model import Problem


def is_plainly_geometric(classification: Classification) -> bool:
    """Whether all constraints are geometric, independent and free of time, and so are the positions."""
    constraints = classification.constraints
    plain = all(c.row.finite is not None and not c.contains_time and c.constraint.given is None for c in constraints)
    whole = not classification.redundancies and classification.rank == len(constraints)
    return bool(constraints) and plain and whole and classification.scleronomic is True


def relation_of(c: ConstraintAnalysis) -> Equation:
    """The constraint as the file states it, with its name and note."""
    named = f"({spoken(c.row.name)}{f': {c.constraint.note}' if c.constraint.note else ''})"
    sides = (c.constraint.lhs, c.constraint.rhs)
    return Equation(sides, label=f"constraint-{c.row.name}", relation=c.constraint.relation, condition=(named,))


def explain_geometric(classification: Classification, slots: Slots) -> Step:
    """The constraints, their differentials, and what follows."""
    constraints = classification.constraints
    lines = (
        Equation((possible_displacement(without_common_number(c.row), slots), sp.S.Zero), label=f"form-{c.row.name}")
        for c in constraints
    )
    kind = plural(len(constraints), "a ", "")
    body: list[Block] = [
        display(*map(relation_of, constraints)),
        prose(
            "Neither velocities nor time appear: ", kind, Emphasis("geometric"),
            plural(len(constraints), " constraint. ", " constraints. "), *_in_contact(constraints),
            plural(len(constraints), "Its differential", "Their differentials"),
            _divided([common_number(c.row) for c in constraints]), ":",
        ),
        display(*lines),
        paragraph(*_conclusions(classification)),
    ]  # fmt: skip
    return Step(Rule.CONSTRAINT, plural(len(constraints), "The constraint", "Constraints"), tuple(body))


def _in_contact(constraints: Sequence[ConstraintAnalysis]) -> tuple[Part, ...]:
    """That a one-sided constraint is treated in contact."""
    sentences = explain_in_contact(constraints)
    return (*sentences[0].parts, " ") if sentences else ()


def _divided(contents: Sequence[sp.Integer]) -> str:
    """`, halved`."""
    if all(c == 1 for c in contents):
        return ""
    if set(contents) == {sp.Integer(2)}:
        return ", halved"
    return ", without common factors"


def _conclusions(classification: Classification) -> list[Prose]:
    """Exact, holonomic, scleronomic; the number of degrees of freedom; where a form vanishes."""
    constraints = classification.constraints
    freedom = classification.degrees_of_freedom
    are_exact = plural(len(constraints), " is ", " are ")
    being = plural(len(constraints), "being the differential of ", "being the differentials of ")
    exact: list[Part] = [*listed(Ref(f"form-{c.row.name}") for c in constraints), are_exact, Emphasis("exact")]
    pair = _pair(constraints)
    exact += [", ", being, *listed(Ref(f"constraint-{c.row.name}") for c in constraints)]
    exact += [" in contact"] if any(c.constraint.side is not None for c in constraints) else []
    exact += [" (", equal(pair), ")"] if pair is not None else []
    left = f"{classification.coordinates}\u00a0−\u00a0{classification.rank}\u00a0=\u00a0"
    sentences = [
        prose(*exact, ". So the system is ", Emphasis("holonomic"), ", and ", Emphasis("scleronomic"), "."),
        prose(f"It has {left}", Emphasis(f"{counted(freedom, 'degree')} of freedom"), "."),
    ]
    if freedom == 0:
        sentences.append(prose("The constraints alone determine the position."))
    return [
        *sentences,
        *(s for s in explain_losses(classification) if not _is_excluded(classification)),
    ]


def _is_excluded(classification: Classification) -> bool:
    """Whether the constraints exclude every place where a form would vanish."""
    return all(loss.excluded for loss in classification.losses)


def _pair(constraints: Sequence[ConstraintAnalysis]) -> PartialsComparison | None:
    """The mixed partial derivatives of the only constraint, where they are short and tell something."""
    if len(constraints) != 1:
        return None
    [c] = constraints
    pair = telling_pair(c)
    if pair is None or 0 in pair.coefficients or any(a.has(Unspecified) for a in pair.coefficients):
        return None
    content = common_number(c.row)
    (a, b), (left, right) = pair.coefficients, pair.derivatives
    return replace(pair, coefficients=(a / content, b / content), derivatives=(left / content, right / content))


def without_component(problem: Problem, step: Step) -> Step:
    """The constraints, with v·n = 0 for one that forbids a velocity along a unit vector that the file names."""
    components = [*vanishing_components(problem)]
    lines = [Equation((DotProduct(velocity, VectorSymbol(n)), sp.S.Zero)) for velocity, n in components]
    if not lines:
        return step
    along = listed(math(n) for n in dict.fromkeys(VectorSymbol(n) for _, n in components))
    words = plural(len(lines), "the velocity has no component along ", "velocities have no component along ")
    at = next(n for n, b in enumerate(step.body) if isinstance(b, Display)) + 1
    return replace(
        step, body=(*step.body[:at], prose(f"That is, {words}", *along, ":"), display(*lines), *step.body[at:])
    )


def explain_without(classification: Classification, built_in: bool) -> Step:
    """Freedom and classification where no constraint relates the coordinates."""
    freedom = classification.degrees_of_freedom
    why = "No constraint relates the coordinates"
    if built_in:
        why = "The coordinates satisfy the constraints by themselves"
        why += "" if freedom == 1 else " and are independent"
    holonomic = prose(f"{why}, so the system is ", Emphasis("holonomic"), ".")
    degrees = Emphasis(in_words(freedom, "degree") + " of freedom")
    many = prose("It has ", degrees, ".")
    plain = not (classification.weighed or classification.forced or classification.catastatic is False)
    if classification.scleronomic and plain:
        holonomic = prose(
            f"{why}, and time does not appear explicitly: the system is ", Emphasis("holonomic"), " and ",
            Emphasis("scleronomic"), ", with ", degrees, ".",
        )  # fmt: skip
        return Step(Rule.DEGREES_OF_FREEDOM, "Degrees of freedom", (holonomic,))
    return Step(
        Rule.DEGREES_OF_FREEDOM, "Degrees of freedom", (paragraph(holonomic, explain_time(classification), many),)
    )


# Beside kinematic constraints


def explain_short_forms(short: Classification, slots: Slots) -> Step:
    """The forms."""
    step = explain_forms(short, slots)
    first = step.body[0]
    assert isinstance(first, Prose)
    at = index_of(Purpose.VERB, first.parts)
    assert at is not None
    comma = "," if at == len(first.parts) - 1 else ""
    parts = (*first.parts[:at], f", without common factors{comma}", *first.parts[at:])
    return replace(step, body=(replace(first, parts=parts), *step.body[1:]))


def explain_short_integrability(solution: Solution, short: Classification) -> Step:
    """Which of the forms are integrable."""
    return explain_integrability(
        short, solution.problem.slots, {*solution.problem.scope.names(), *solution.problem.scope.vectors}
    )


def in_chosen_coordinates(solution: Solution, step: Step) -> Step:
    """Frobenius' condition in the coordinates of the first choice, where these satisfy all geometric constraints.

    A form is integrable on the surface of the geometric constraints if and only if it is so in coordinates of that
    surface: ω ∧ dω there takes the place of a product with the forms of all of them.
    """
    classification = solution.classification
    kinematic = [c for c in classification.constraints if c.row.finite is None]
    if len(kinematic) != 1 or len(kinematic) == len(classification.constraints) or not solution.choices:
        return step
    [c], view = kinematic, solution.choices[0]
    rows, slots = view.configuration.rows, view.configuration.slots
    if c.integrable is not False or [r.name for r in rows] != [c.row.name] or rows[0].drift != 0:
        return step
    at = next((n for n, b in enumerate(step.body) if isinstance(b, Display) and _is_product(b, c)), None)
    if at is None:
        return step
    reduced = frobenius_on_surface(rows[0], slots)
    if reduced is None:
        return step
    [product] = (e.sides[0] for b in (step.body[at],) if isinstance(b, Display) for e in b.equations)
    letter, rate, *_ = product.args if isinstance(product, Wedge) else (sp.Symbol("omega"), sp.Symbol("omega"))
    written = sp.Add(*(a * differential(q) for a, q in zip(reduced.form, slots.coordinates, strict=True)))
    substituted = [Ref(f"choice-{view.name}-{q.name}") for q in view.configuration.expressed]
    volume = reduced.component.coefficient * Wedge(*(differential(q) for q in reduced.component.variables))
    question = prose(
        "It is not exact, but an integrating factor may still exist where the geometric constraints hold. In the "
        "coordinates ", *listed(math(q) for q in slots.coordinates), " of ", substituted[0], " to ", substituted[-1],
        " these hold identically, and the form becomes, without a constant factor, ", math(letter, written),
        "; by Frobenius' theorem a factor exists if and only if ", math(Wedge(letter, rate), sp.S.Zero),
        IN_THREE_VARIABLES if len(slots.coordinates) == 3 else ". Here ",
    )  # fmt: skip
    shown = display(Equation((Wedge(letter, rate), volume), label=f"frobenius-{c.row.name}"))
    changes = reduced.component.coefficient.free_symbols & {*slots.coordinates}
    end = prose(
        f"This does not vanish{' identically' if changes else ''}: there is no integrating factor, and the "
        "constraint hides no relation between the coordinates. It is ", Emphasis("not integrable"), ".",
    )  # fmt: skip
    return replace(step, body=(*step.body[: at - 1], question, shown, end, *step.body[at + 2 :]))


def _is_product(block: Display, c: ConstraintAnalysis) -> bool:
    return [e.label for e in block.equations] == [f"frobenius-{c.row.name}"]


def explain_short_displacements(solution: Solution) -> Step:
    """The displacements, vanishing ones substituted into the other conditions; long solutions are omitted."""
    own = solution.own
    rows = tuple(without_common_number(r) if r.finite is not None else r for r in own.configuration.rows)
    configuration = replace(own.configuration, constrained=replace(own.configuration.constrained, rows=rows))
    known = tuple(n for n in solution.normals if not _is_one_coordinate(n.row))
    step = explain_displacements(configuration, own.elimination, solution.transport_rates, known)
    zero = {variation(q): sp.S.Zero for r in rows if _is_one_coordinate(r) for q in _only(r, solution.problem.slots)}
    body = [_with(zero, b) if isinstance(b, Display) else b for b in step.body]
    pairs = [(n, body[n - 1], b) for n, b in enumerate(body) if n and isinstance(b, Display)]
    long = [n for n, before, b in pairs if b.detail is Detail.FULL or (_is_solution(before) and _is_long(b))]
    for n in long:
        free = listed(math(variation(solution.problem.slots.coordinates[k])) for k in own.elimination.independent)
        many = in_words(len(own.elimination.independent), "").split()[0].capitalize()
        if any(count_operations(p) > LONGEST_PIVOT for p in own.elimination.pivots):
            pivots: tuple[Part, ...] = (" in a general position",)
        else:
            pivots = (", where ", *pivot_conditions(own.elimination)) if own.elimination.pivots else ()
        words = (f"{many} of the displacements can be chosen freely, for instance ", *free, *pivots, ".")
        body[n - 1 : n + 2] = [prose(*words)]
    return replace(step, body=tuple(body))


def _with(zero: dict[sp.Symbol, sp.Expr], block: Display) -> Display:
    """Equations between displacements with the vanishing ones substituted; those that say so are kept."""
    return block.map(lambda e: _simpler(zero, e))


def _simpler(zero: dict[sp.Symbol, sp.Expr], e: Equation) -> Equation:
    left, *right = e.sides
    if e.kind is not EquationKind.VIRTUAL or left in zero or not isinstance(left, sp.Expr):
        return e
    return replace(e, sides=(left.xreplace(zero), *right))


def _is_one_coordinate(row: Row) -> bool:
    """Whether a form is dq = 0 for one coordinate."""
    nonzero = [a for a in row.coefficients if a != 0]
    return len(nonzero) == 1 and bool(nonzero[0].is_number) and row.drift == 0


def _only(row: Row, slots: Slots) -> list[sp.Symbol]:
    return [q for q, a in zip(slots.coordinates, row.coefficients, strict=True) if a != 0]


def _is_long(block: Display) -> bool:
    sides = [s for e in block.equations for s in e.sides if isinstance(s, sp.Expr)]
    return sum(map(count_operations, sides)) > LONGEST_SOLUTION


def without_solution(solution: Solution, step: Step) -> Step:
    """The conditions on displacements unsolved, where generalized coordinates satisfy them anyway."""
    at = next((n for n, b in enumerate(step.body) if _is_solution(b)), None)
    chosen = solution.choices[0].configuration if solution.choices else None
    if at is None or chosen is None or chosen.rows or solution.own.dynamics is not None or solution.own.equilibrium:
        return step
    if not solution.own.elimination.pivots:
        return step
    free, size = len(solution.own.elimination.independent), len(solution.problem.slots.coordinates)
    words = prose(f"{in_words(free, '').split()[0].capitalize()} of the {in_words(size, '').split()[0]} can be chosen "
                  "freely.")  # fmt: skip
    solved = solution.own.elimination.solved(solution.problem.slots)
    if free and solved and not any(solved.values()):  # not any of them: these
        names = listed(
            math(variation(solution.problem.slots.coordinates[k])) for k in solution.own.elimination.independent
        )
        where = (", where ", *pivot_conditions(solution.own.elimination)) if solution.own.elimination.pivots else ()
        words = prose("So ", *listed(math(d, sp.S.Zero) for d in solved), *where, ". ", *names,
                      plural(free, " remains free.", " remain free."))  # fmt: skip
    before, last = step.body[: at - 1], step.body[at - 1]
    first = [paragraph(last, words)] if isinstance(last, Prose) else [last, words]
    return replace(step, body=(*before, *first, *step.body[at + 3 :]))


def without_division(solution: Solution, step: Step) -> Step:
    """The dependent displacements by a parameter, where solving for them would divide by what may vanish."""
    elimination, slots = solution.own.elimination, solution.problem.slots
    at = next((n for n, b in enumerate(step.body) if _is_solution(b)), None)
    if at is None or not elimination.pivots or not elimination.solution or solution.own.dynamics is not None:
        return step
    from lagrange.mechanics.rewriting.constraint_forms import free_displacements

    chosen = (q.name for c in solution.problem.choices for q in c.coordinates)
    names = {*solution.problem.scope.names(), *(q.name for q in slots.coordinates), *chosen}
    parametric = free_displacements(elimination, slots, names)
    if parametric is None:
        return step
    where: tuple[Part, ...] = ("In every position ",)
    if parametric.pivots:
        where = ("Where ", *listed(math(f, sp.S.Zero, relation="≠") for f in parametric.pivots), ", ")
    verb = "these are" if len(elimination.dependent) > 1 else "this is"
    words = prose(*where, f"{verb} satisfied by")
    lines = (Equation((variation(q), total)) for q, total in parametric.values.items())
    end = prose("with arbitrary ", *listed(map(math, parametric.free)), ", and by no others.")
    return replace(step, body=(*step.body[:at], words, display(*lines), end, *step.body[at + 3 :]))


def _is_solution(block: Block) -> bool:
    return has_purpose(block, Purpose.SOLVING)


def on_nonlinear_constraint(solution: Solution, step: Step) -> Step:
    """A step with v² for x'² + y'² where a constraint that is not linear in the velocities says so."""
    slots = solution.problem.slots
    squares = squares_by_constraints(solution.own.configuration.rows, slots)
    if not squares:
        return step

    def shorter(side: Mathematics) -> Mathematics:
        if isinstance(side, TimeDerivative) or not isinstance(side, sp.Expr) or not side.has(*slots.velocities):
            return side
        return with_squares(side, squares)

    def line(e: Equation) -> Equation:
        if e.label == "virtual-work":
            return e
        if len(e.sides) < 2:
            return replace(e, sides=tuple(map(shorter, e.sides)))
        e = replace(e, sides=(e.sides[0], *map(shorter, e.sides[1:])))
        if step.rule is Rule.SOLVED_REACTIONS and not e.condition and isinstance(e.sides[-1], sp.Expr):
            return replace(e, condition=while_moving(e.sides[-1], slots.velocities))
        return e

    return step.map(line)


def with_only_coordinate(solution: Solution, step: Step) -> Step:
    """Integrability, with x = v t − v/κ + C exp(−κ t) where one constraint determines the only coordinate."""
    only = only_coordinate(solution)
    if only is None:
        return step
    words = prose("Solved for ", math(only.coordinate), ", with a constant ", math(only.constant), ", it is")
    line = display(
        Equation((only.coordinate, only.value), label=f"only-{only.coordinate.name}", kind=EquationKind.ONLY),
        boxed=True,
    )
    return replace(step, body=(*step.body, words, line))


# Folded proofs


TITLE = "Differential forms and integrability"
_TESTED = (Rule.PFAFFIAN_FORM, Rule.INTEGRABILITY)


def without_test(solution: Solution, steps: Sequence[Step]) -> tuple[list[Step], list[Step]]:
    """The steps of the page, and those on integrability, to be folded."""
    if not _is_beside_the_point(solution):
        return [*steps], []
    tested = [s for s in steps if s.rule in _TESTED]
    forms = {f"form-{c.row.name}" for c in solution.classification.constraints}
    if any(forms & _referred(s) for s in steps if s.rule not in (*_TESTED, Rule.DISPLACEMENTS)):
        tested = [s for s in tested if s.rule is Rule.INTEGRABILITY]
    if any(forms & _referred(s) and not _is_of_same(s) for s in steps if s.rule is Rule.DISPLACEMENTS):
        tested = [s for s in tested if s.rule is Rule.INTEGRABILITY]
    hidden = [b for s in tested for b in _hidden(s)]
    kept: list[Step] = []
    for s in steps:
        if s.rule is Rule.CLASSIFICATION:
            kept.append(replace(s, body=(_by_theorem(s.body[0]), *s.body[1:], *hidden)))
        elif s.rule is Rule.DISPLACEMENTS and _is_of_same(s) and len(tested) > 1:
            kept.append(replace(s, body=(_with_variations(solution), *s.body[1:])))
        elif s not in tested:
            kept.append(s)
    folded = (TITLE,) if len(tested) > 1 else ("Integrability",)
    return kept, [replace(s, folded=folded) for s in tested]


def _is_beside_the_point(solution: Solution) -> bool:
    """Whether more than constraints is asked, and each one on velocities is no relation between coordinates."""
    own = solution.own
    derived = own.dynamics is not None or own.equilibrium is not None or solution.impact is not None
    rows = [c for c in solution.classification.constraints if c.row.finite is None]
    return derived and bool(rows) and all(c.integrable is False and c.pfaffian for c in rows)


def _is_of_same(step: Step) -> bool:
    return bool(step.body) and has_purpose(step.body[0], Purpose.TIMELESS)


def _referred(step: Step) -> set[str]:
    return {p.label for b in step.body if isinstance(b, Prose) for p in b.parts if isinstance(p, Ref)} | {
        p.label for b in step.body if isinstance(b, Display) for e in b.equations for p in e.condition
        if isinstance(p, Ref)
    }  # fmt: skip


def _hidden(step: Step) -> Iterator[Block]:
    """The finite relations that no single constraint shows, with the sentence before them."""
    for before, block in zip(step.body, step.body[1:], strict=False):
        if isinstance(block, Display) and any(e.kind is EquationKind.HIDDEN for e in block.equations):
            yield before
            yield block


def _by_theorem(block: Block) -> Block:
    """`..., so the system is nonholonomic`, citing the theorem by name."""
    if not isinstance(block, Prose):
        return block
    why = index_of(Purpose.CONCLUSION, block.parts)
    if why is None:
        return block
    return replace(block, parts=(*block.parts[:why], " (Frobenius' theorem)", *block.parts[why:]))


def _with_variations(solution: Solution) -> Prose:
    """With time frozen, δx takes the place of ẋ."""
    rows = solution.own.configuration.rows
    refs = listed(Ref(f"constraint-{r.name}") for r in rows)
    return prose("Time does not appear in ", *refs, ". Virtual displacements satisfy ", plural(len(rows), "it", "them"),
                 " with δ in place of d/dt:", purpose=Purpose.TIMELESS)  # fmt: skip
