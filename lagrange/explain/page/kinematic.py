"""Geometric constraints beside kinematic ones: their forms without common factors, here as where they stand alone.

Forms and their partial derivatives are those of the full derivation, divided by the whole number that their
coefficients have in common; so is Frobenius' product, once for each form in it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import combinations

import sympy as sp

from lagrange.algebra.closed_forms.shortest_form import shortest_form
from lagrange.algebra.forms.integrability import frobenius_form
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.operations import count_operations
from lagrange.core.symbols import Slots, TimeDerivative, Wedge, differential, free_letter, t, variation
from lagrange.document.builders import display, listed, math, paragraph, prose
from lagrange.document.derivation import Block, Detail, Display, Emphasis, Equation, Mathematics, Part, Prose, Ref, Step
from lagrange.explain.constraints import IN_THREE_VARIABLES, explain_forms, explain_integrability
from lagrange.explain.displacements import conditions, explain_displacements
from lagrange.explain.page.constraints import common_number, halved
from lagrange.explain.words import in_words, plural
from lagrange.mechanics.constraints.classification import Classification
from lagrange.mechanics.constraints.constrained_system import Row
from lagrange.mechanics.constraints.constraints import ConstraintAnalysis
from lagrange.mechanics.constraints.displacements import Elimination
from lagrange.mechanics.meaning import square_of
from lagrange.mechanics.results import Solution

LONGEST_SOLUTION = 40
"""The most operations of the dependent displacements together that are written by the free ones."""


def with_short_forms(classification: Classification) -> Classification | None:
    """The classification with the geometric forms without common factors.

    None where no geometric form has a common factor, or where other forms are written as combinations of them.
    """
    numbers = {c.row.name: common_number(c.row) for c in classification.constraints if c.row.finite is not None}
    if all(n == 1 for n in numbers.values()) or classification.hidden.found or classification.redundancies:
        return None
    product = sp.Mul(*numbers.values())
    constraints = tuple(_divided(c, numbers.get(c.row.name, sp.S.One), product) for c in classification.constraints)
    return replace(classification, constraints=constraints)


def _divided(c: ConstraintAnalysis, number: sp.Integer, product: sp.Expr) -> ConstraintAnalysis:
    if c.row.finite is None:
        parts = (replace(k, coefficient=textbook_form(k.coefficient / product)) for k in c.frobenius)
        return replace(c, frobenius=tuple(parts))
    pairs = (
        replace(
            p,
            coefficients=tuple(a / number for a in p.coefficients),
            derivatives=tuple(a / number for a in p.derivatives),
        )
        for p in c.exactness.comparisons
    )
    return replace(c, row=halved(c.row), exactness=replace(c.exactness, comparisons=tuple(pairs)))


def explain_short_forms(short: Classification, slots: Slots) -> Step:
    """The forms."""
    step = explain_forms(short, slots)
    first = step.body[0]
    assert isinstance(first, Prose)
    at = next(n for n, p in enumerate(first.parts) if isinstance(p, str) and p.startswith((", and", " is", " are")))
    follows = first.parts[at]
    comma = "" if isinstance(follows, str) and follows.startswith(",") else ","
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
    form = _without_constants(rows[0], slots)
    components = frobenius_form(form, slots.coordinates, slots)
    if len(components) != 1 or not components[0].nonzero:
        return step
    [product] = (e.sides[0] for b in (step.body[at],) if isinstance(b, Display) for e in b.equations)
    letter, rate, *_ = product.args if isinstance(product, Wedge) else (sp.Symbol("omega"), sp.Symbol("omega"))
    written = sp.Add(*(a * differential(q) for a, q in zip(form, slots.coordinates, strict=True)))
    substituted = [Ref(f"choice-{view.name}-{q.name}") for q in view.configuration.expressed]
    volume = components[0].coefficient * Wedge(*(differential(q) for q in components[0].variables))
    question = prose(
        "It is not exact, but an integrating factor may still exist where the geometric constraints hold. In the "
        "coordinates ", *listed(math(q) for q in slots.coordinates), " of ", substituted[0], " to ", substituted[-1],
        " these hold identically, and the form becomes, without a constant factor, ", math(letter, written),
        "; by Frobenius' theorem a factor exists if and only if ", math(Wedge(letter, rate), sp.S.Zero),
        IN_THREE_VARIABLES if len(slots.coordinates) == 3 else ". Here ",
    )  # fmt: skip
    shown = display(Equation((Wedge(letter, rate), volume), label=f"frobenius-{c.row.name}"))
    end = prose(
        "This does not vanish: there is no integrating factor, and the constraint hides no relation between the "
        "coordinates. It is ", Emphasis("not integrable"), ".",
    )  # fmt: skip
    return replace(step, body=(*step.body[: at - 1], question, shown, end, *step.body[at + 2 :]))


def _is_product(block: Display, c: ConstraintAnalysis) -> bool:
    return [e.label for e in block.equations] == [f"frobenius-{c.row.name}"]


def _without_constants(row: Row, slots: Slots) -> tuple[sp.Expr, ...]:
    """The coefficients without the constant factors that all of them share."""
    letters = {q: sp.Dummy() for q in slots.coordinates}
    total = sp.factor_terms(sp.Add(*(a * letters[q] for a, q in zip(row.coefficients, slots.coordinates, strict=True))))
    moving = {*slots.coordinates, *letters.values()}
    kept = sp.Mul(*(f for f in sp.Mul.make_args(total) if f.free_symbols & moving))
    return tuple(sp.expand(kept).coeff(letters[q]) for q in slots.coordinates)


def explain_short_displacements(solution: Solution) -> Step:
    """The displacements, those that are zero put into the other conditions; no solution that is too long to be read."""
    own = solution.own
    rows = tuple(halved(r) if r.finite is not None else r for r in own.configuration.rows)
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
        body[n - 1 : n + 2] = [prose(f"{many} of the displacements can be chosen freely, for instance ", *free, ".")]
    return replace(step, body=tuple(body))


def _with(zero: dict[sp.Symbol, sp.Expr], block: Display) -> Display:
    """Equations between displacements, with those put in that are zero; those that say it stay."""
    return replace(block, equations=tuple(_simpler(zero, e) for e in block.equations))


def _simpler(zero: dict[sp.Symbol, sp.Expr], e: Equation) -> Equation:
    left, *right = e.sides
    if not (e.label or "").startswith("virtual-") or left in zero or not isinstance(left, sp.Expr):
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
        where = (" where ", *conditions(solution.own.elimination)) if solution.own.elimination.pivots else ()
        words = prose("So ", *listed(math(d, sp.S.Zero) for d in solved), *where, ". ", *names,
                      plural(free, " remains free.", " remain free."))  # fmt: skip
    before, last = step.body[: at - 1], step.body[at - 1]
    first = [paragraph(last, words)] if isinstance(last, Prose) else [last, words]
    return replace(step, body=(*before, *first, *step.body[at + 3 :]))


def without_division(solution: Solution, step: Step) -> Step:
    """The dependent displacements by a parameter, where solving for them would divide by what may vanish.

    Of sin θ δx = cos θ δy every solution, whatever θ, is δx = cos θ δs, δy = sin θ δs. That takes in all of them if one
    free displacement only has denominators, and what it is multiplied by to clear them, and the others with it, never
    vanish at once: the sum of their squares is a positive number.
    """
    elimination, slots = solution.own.elimination, solution.problem.slots
    at = next((n for n, b in enumerate(step.body) if _is_solution(b)), None)
    if at is None or not elimination.pivots or not elimination.solution or solution.own.dynamics is not None:
        return step
    columns = [[*map(_by_sines, column)] for column in zip(*elimination.solution, strict=True)]
    divided = [k for k, column in enumerate(columns) if any(_varies(e, elimination) for e in column)]
    if len(divided) != 1:
        return step
    [k] = divided
    below = sp.lcm_list([sp.fraction(sp.together(e))[1] for e in columns[k]])
    own = {slots.coordinates[d]: sp.cancel(e * below) for d, e in zip(elimination.dependent, columns[k], strict=True)}
    own[slots.coordinates[elimination.independent[k]]] = below
    common = _common(list(own.values()), slots)
    if common is None:
        return step
    own = {q: min(e, shortest_form(e), key=lambda x: count_operations(x)) for q, e in
           ((q, sp.cancel(e / common)) for q, e in own.items())}  # fmt: skip
    pivots = [
        f for f in sp.Mul.make_args(sp.factor(common)) if f.free_symbols & {*slots.coordinates, *slots.prescribed, t}
    ]
    chosen = (q.name for c in solution.problem.choices for q in c.coordinates)
    names = {*solution.problem.scope.names(), *(q.name for q in slots.coordinates), *chosen}
    s = variation(sp.Symbol(free_letter("s", "u", "sigma", "w", taken=names), real=True))
    rest = [n for n in range(len(columns)) if n != k]
    lines = []
    for n, q in enumerate(slots.coordinates):
        if q not in own:
            continue
        total = own[q] * s
        if n in elimination.dependent:
            row = elimination.solution[elimination.dependent.index(n)]
            total += sp.Add(*(row[m] * variation(slots.coordinates[elimination.independent[m]]) for m in rest))
        lines.append(Equation((variation(q), total)))
    free = [s, *(variation(slots.coordinates[elimination.independent[m]]) for m in rest)]
    where: tuple[Part, ...] = ("In every position ",)
    if pivots:
        where = ("Where ", *listed(math(f, sp.S.Zero, relation="≠") for f in pivots), ", ")
    verb = "these are" if len(elimination.dependent) > 1 else "this is"
    words = prose(*where, f"{verb} satisfied by")
    end = prose("with arbitrary ", *listed(math(d) for d in free), ", and by no others.")
    return replace(step, body=(*step.body[:at], words, display(*lines), end, *step.body[at + 3 :]))


def _is_solution(block: Block) -> bool:
    first = block.parts[0] if isinstance(block, Prose) and block.parts else ""
    return isinstance(first, str) and first.startswith("Solving for ")


def _by_sines(e: sp.Expr) -> sp.Expr:
    return e.replace(sp.tan, lambda x: sp.sin(x) / sp.cos(x)).replace(sp.cot, lambda x: sp.cos(x) / sp.sin(x))


def _common(entries: Sequence[sp.Expr], slots: Slots) -> sp.Expr | None:
    """What the entries have to be divided by for those without parameters to have squares that add up to 1."""
    varying = {*slots.coordinates, *slots.prescribed, t}
    for common in (sp.S.One, *(sp.gcd(a, b) for a, b in combinations(entries, 2))):
        divided = [sp.cancel(e / common) for e in entries]
        lengths = [e for e in divided if all(s in varying or e.has(t) for s in e.free_symbols)]
        if len(lengths) > 1 and textbook_form(sp.Add(*(e**2 for e in lengths))) == 1:
            return common
    return None


def _varies(e: sp.Expr, elimination: Elimination) -> bool:
    """Whether it has a denominator that one of the pivots makes vanish."""
    below = sp.fraction(sp.together(e))[1]
    return any(sp.fraction(sp.cancel(below / _by_sines(p)))[1] == 1 for p in elimination.pivots)


def on_nonlinear_constraint(solution: Solution, step: Step) -> Step:
    """A step with v² for x'² + y'² where a constraint that is not linear in the velocities says so."""
    rows = [r for r in solution.own.configuration.rows if r.nonlinear is not None]
    slots = solution.problem.slots
    rules = [rule for r in rows if (rule := square_of(r, slots)) is not None]
    if not rules:
        return step

    def shorter(side: Mathematics) -> Mathematics:
        if isinstance(side, TimeDerivative) or not isinstance(side, sp.Expr) or not side.has(*slots.velocities):
            return side
        for velocity, square in rules:
            reduced = sp.factor(sp.cancel(sp.expand(side).xreplace({velocity**2: square})))
            side = reduced if count_operations(reduced) < count_operations(side) else side
        return side

    def line(e: Equation) -> Equation:
        if e.label == "virtual-work":
            return e
        return replace(e, sides=(e.sides[0], *map(shorter, e.sides[1:]))) if len(e.sides) > 1 else replace(
            e, sides=tuple(map(shorter, e.sides)))  # fmt: skip

    blocks = (replace(b, equations=tuple(map(line, b.equations))) if isinstance(b, Display) else b for b in step.body)
    return replace(step, body=tuple(blocks))


def with_only_coordinate(solution: Solution, step: Step) -> Step:
    """Integrability, with x = v t − v/κ + C exp(−κ t) where one constraint determines the only coordinate."""
    classification, coordinates = solution.classification, solution.problem.slots.coordinates
    if len(coordinates) != 1 or len(classification.integrals) != 1 or classification.degrees_of_freedom != 0:
        return step
    [q], [(_, function)] = coordinates, classification.integrals
    factor = function.diff(q)
    if factor == 0 or factor.has(q) or function.is_Symbol:
        return step
    constant = sp.Symbol(free_letter("C", "K", "c", taken={*solution.problem.scope.names()}), real=True)
    rest = sp.expand(-function.xreplace({q: sp.S.Zero}) / factor)
    size, moving = factor.as_independent(t, as_Add=False)
    value = rest + constant / moving if size.free_symbols else rest + constant / factor
    words = prose("Solved for ", math(q), ", with a constant ", math(constant), ", it is")
    line = display(Equation((q, sp.powsimp(value)), label=f"only-{q.name}"), boxed=True)
    return replace(step, body=(*step.body, words, line))
