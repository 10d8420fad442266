"""What a page need not say: abbreviations that it does not use, a unit vector under two names, a letter defined twice.

The derivation is written as if each of its steps stood alone. On the page they follow one another: what one of them has
said the next need not repeat. Nothing is computed here; equal unit vectors are those with equal components.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.core.symbols import CONSTANT, Slots, UnitVector, t
from lagrange.core.triads import unit_vector
from lagrange.core.vectors import FIXED, UNITS, Triad, Vector
from lagrange.document.builders import math, paired, paragraph, prose
from lagrange.document.derivation import (
    Block,
    Display,
    Emphasis,
    Equation,
    Math,
    Mathematics,
    Part,
    Prose,
    Ref,
    Rule,
    Step,
    Table,
)
from lagrange.explain.bodies import stated_triads, unit_vectors
from lagrange.explain.page.system import are_short
from lagrange.explain.words import capital, in_words, plural
from lagrange.mechanics.constraints.classification import Classification
from lagrange.mechanics.results import Solution

LONGEST_IN_LINE = 12
"""The most operations of a product of differentials that is written in its sentence."""
_MOST_LINES = 1
"""The most stated equations that are printed at the head and again at the end."""


# -- one name for one unit vector ------------------------------------------------------------------------------------


def in_one_name(solution: Solution, steps: Iterable[Step]) -> Iterator[Step]:
    """The steps with one name for equal unit vectors: that of the file, or i, j, k, or the first of those of bodies."""
    names = _names_of_units(solution)
    if not names:
        return iter(steps)
    rule: dict[sp.Basic, sp.Basic] = {UnitVector(old): UnitVector(new) for old, new in names.items()}
    return (replace(s, body=tuple(_renamed(b, rule, names) for b in s.body)) for s in steps)


def _names_of_units(solution: Solution) -> dict[str, str]:
    """The unit vectors of bodies that have another name too, by name."""
    problem, frame = solution.problem, solution.problem.frame
    known = {_components(v): name for name, v in problem.abbreviations.items() if isinstance(v, Vector)}
    known |= {_components(unit_vector(FIXED, n)): name for n, name in enumerate(UNITS)}
    named = {*UNITS, *problem.abbreviations, *(frame.names if frame is not None else ())}
    names: dict[str, str] = {}
    for triad in _triads(solution):
        if triad.directions is None or triad == frame:
            continue
        for symbol, direction in unit_vectors(triad):
            name = symbol.name if symbol.name in named else known.setdefault(_components(direction), symbol.name)
            if name != symbol.name:
                names[symbol.name] = name
    return names


def _triads(solution: Solution) -> tuple[Triad, ...]:
    """The triads in which the page has vectors."""
    triads = [*stated_triads(solution.own.configuration)]
    form = solution.own.in_speeds
    if form is not None and form.equations is not None:
        vectors = (*form.equations.velocities.values(), *form.equations.spins.values())
        triads += [v.triad for v in vectors]
    return tuple(dict.fromkeys(triads))


def _components(v: Vector) -> tuple[sp.Expr, ...]:
    return tuple(sp.expand(c) for c in v.fixed().components)


def _renamed(block: Block, rule: dict[sp.Basic, sp.Basic], names: Mapping[str, str]) -> Block:
    def inside(e: Mathematics) -> Mathematics:
        if not isinstance(e, Vector):
            return e.xreplace(rule)
        a, b, c = (names.get(n, n) for n in e.triad.names)
        return e if (a, b, c) == e.triad.names else Vector(e.components, replace(e.triad, names=(a, b, c)))

    def part(p: Part) -> Part:
        return replace(p, sides=tuple(map(inside, p.sides))) if isinstance(p, Math) else p

    if isinstance(block, Prose):
        return replace(block, parts=tuple(map(part, block.parts)))
    if isinstance(block, Display):
        lines = (
            replace(e, sides=tuple(map(inside, e.sides)), condition=tuple(map(part, e.condition)))
            for e in block.equations
        )
        return replace(block, equations=tuple(lines))
    return block


# -- what is not used ------------------------------------------------------------------------------------------------

_OPENINGS = ("For brevity, write", "The unit vectors that turn with the bodies are", "With the unit vectors")


def without_unused(solution: Solution, steps: Sequence[Step]) -> Iterator[Step]:
    """The steps without abbreviations and unit vectors that are stated and do not occur, or are stated again."""
    units = (u.name for t in _triads(solution) for u in t.units)
    stated = {*map(str, solution.problem.abbreviations), *units} - {*UNITS}
    used = {name for step in steps for block in step.body for name in _names_in(block, stated)}
    defined: set[str] = {*UNITS}
    for step in steps:
        body: list[Block] = []
        for block in step.body:
            before = body[-1] if body else None
            first = before.parts[0] if isinstance(before, Prose) and before.parts else None
            if not isinstance(block, Display) or not isinstance(first, str) or not first.startswith(_OPENINGS):
                body.append(block)
                continue
            kept = []
            for e in block.equations:
                name = _defined(e)
                if name in defined or (name in stated and name not in used):
                    continue
                defined.add(name)
                kept.append(e)
            if kept:
                body.append(replace(block, equations=tuple(kept)))
            else:
                body.pop()
        if body or not step.body:
            yield replace(step, body=tuple(body))


def _defined(e: Equation) -> str:
    left = e.sides[0]
    return left.name if isinstance(left, sp.Symbol) else ""


def _names_in(block: Block, stated: Collection[str]) -> Iterator[str]:
    """The names of symbols in a block; of a definition only those on the right."""
    if isinstance(block, Prose):
        yield from _names_of_parts(block.parts)
    elif isinstance(block, Display):
        for e in block.equations:
            sides = e.sides[1:] if _defined(e) in stated else e.sides
            yield from (n for s in sides for n in _names_of(s))
            yield from _names_of_parts(e.condition)
    elif isinstance(block, Table):
        for row in block.rows:
            yield from _names_of_parts(row)


def _names_of_parts(parts: Iterable[Part]) -> Iterator[str]:
    yield from (n for p in parts if isinstance(p, Math) for s in p.sides for n in _names_of(s))


def _names_of(e: Mathematics) -> Iterator[str]:
    if isinstance(e, Vector):
        yield from (n for n, c in zip(e.triad.names, e.components, strict=True) if c != 0)
    symbols = e.free_symbols if isinstance(e, sp.Basic) else {s for c in e.components for s in c.free_symbols}
    yield from (s.name.rstrip("'") for s in symbols if isinstance(s, sp.Symbol))


# -- what has been said ----------------------------------------------------------------------------------------------


def said_before(steps: Sequence[Step]) -> Iterator[Step]:
    """The steps without a second definition of a letter, and without a box of several lines that the head has too."""
    defined: dict[object, object] = {}
    head = next((s for s in steps if s.rule is Rule.RESULT), None)
    shown = [e.sides for b in head.body if isinstance(b, Display) for e in b.equations] if head else []
    asked: list[object] = []
    for step in steps:
        blocks: list[Block] = []
        for block in step.body:
            if isinstance(block, Display) and step.rule is not Rule.RESULT:
                block = _defined_once(block, defined)
            if isinstance(block, Display) and step.rule is Rule.QUESTION and not block.boxed:
                sides = [e.sides for e in block.equations]
                if sides in asked and blocks and isinstance(blocks[-1], Prose):
                    blocks.pop()  # a question before has the same
                    continue
                asked.append(sides)
            before = blocks[-1] if blocks else None
            in_short = isinstance(before, Prose) and before.parts[:1] == (Emphasis("In short"),)
            if in_short and isinstance(block, Display) and _is_repeated(block, shown):
                blocks.pop()
            else:
                blocks.append(block)
        if blocks or not step.body:
            yield replace(step, body=tuple(blocks))


def _is_repeated(block: Display, shown: Sequence[object]) -> bool:
    """Whether a box of several lines has only equations that were shown."""
    return len(block.equations) > _MOST_LINES and all(e.sides in shown for e in block.equations)


def in_pairs(steps: Sequence[Step]) -> Iterator[Step]:
    """The steps with short lines of one kind two by two: positions, forces, ω and H, accelerations, displacements."""
    referred = {p.label for s in steps for b in s.body for p in _parts_of(b) if isinstance(p, Ref)}
    for step in steps:
        blocks = (
            replace(b, equations=tuple(_paired(b.equations, referred))) if isinstance(b, Display) and not b.boxed else b
            for b in step.body
        )
        yield replace(step, body=tuple(blocks))


_IN_PAIRS = ("position", "force", "moment", "spin", "momentum", "acceleration", "delta", "rotation", "before",
             "reaction", "couple", "newton", "in-speeds-omega", "kinematic", "quasi-variation")  # fmt: skip


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
    kinds = [_kind(e) for e in (first, second)]
    plain = not first.condition and not second.condition and first.relation == second.relation == "="
    alike = bool(kinds[0]) and (kinds[0] == kinds[1] or kinds == ["spin", "momentum"])
    return plain and alike and are_short((first, second))


def _kind(e: Equation) -> str:
    return next((k for k in sorted(_IN_PAIRS, key=len, reverse=True) if (e.label or "").startswith(f"{k}-")), "")


def _parts_of(block: Block) -> Iterator[Part]:
    if isinstance(block, Prose):
        yield from block.parts
    elif isinstance(block, Display):
        yield from (p for e in block.equations for p in e.condition)


def _defined_once(block: Display, defined: dict[object, object]) -> Display:
    """A box without its last line, a letter for a denominator, where a box before it has the same."""
    last = block.equations[-1]
    if len(block.equations) < 2 or len(last.sides) != 2 or last.label is not None or not block.boxed:
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
    """What the constraints imply together, in one sentence in place of the construction of derived systems."""
    if not isinstance(block, Prose) or not block.parts or not isinstance(block.parts[0], str):
        return block
    flag = classification.flag
    if not block.parts[0].startswith("Taken together, the constraints may imply") or len(flag.ranks) < 2:
        return block
    relations = in_words(flag.integrable_rank or 0, "finite relation") if flag.integrable_rank else "no finite relation"
    letter, rate = (p for p in block.parts if isinstance(p, Math))
    first, *rest = flag.ranks
    numbers = ["none" if n == 0 else str(n) for n in rest]
    remain = plural(rest[0] or 1, "remains", "remain")
    course = f"of {first} forms {numbers[0]} {remain}"
    course += "".join(f", then {n}" for n in numbers[1:])
    course += "" if rest[-1] == 0 else ", and no fewer"
    return paragraph(
        prose(f"Taken together, the constraints imply {relations} between the coordinates."),
        prose(
            "To see it keep only the combinations ", letter, " of the forms for which ", rate, " vanishes in any two "
            f"displacements that satisfy all the constraints, and repeat this: {course} (Frobenius' theorem).",
        ),
    )  # fmt: skip


def likewise_in_a_line(body: Sequence[Block]) -> Iterator[Block]:
    """Frobenius' product of a further form in the paragraph that says what follows from it, not displayed."""
    blocks = list(body)
    n = 0
    while n < len(blocks):
        four = blocks[n : n + 4]
        if _is_likewise(four):
            first, question, shown, end = four
            assert isinstance(first, Prose)
            assert isinstance(question, Prose)
            assert isinstance(shown, Display)
            assert isinstance(end, Prose)
            [e] = shown.equations
            more: tuple[Part, ...] = (" ", *e.condition) if e.condition else ()
            verdict = str(end.parts[0]).replace("This does", "which does" if not more else "which do", 1)
            product = prose(*question.parts, math(*e.sides), *more, ", ", verdict, *end.parts[1:])
            yield paragraph(first, product)
            n += 4
        else:
            yield blocks[n]
            n += 1


def _is_likewise(blocks: Sequence[Block]) -> bool:
    if len(blocks) < 4 or not all(isinstance(blocks[k], Prose) for k in (0, 1, 3)):
        return False
    shown = blocks[2]
    if (
        not isinstance(shown, Display)
        or len(shown.equations) != 1
        or not isinstance(shown.equations[0].sides[-1], sp.Expr)
    ):
        return False
    words = [str(p.parts[0]) if isinstance(p, Prose) else "" for p in (blocks[1], blocks[3])]
    length = shown.equations[0].sides[-1].count_ops()
    return words[0].startswith("With ") and words[1].startswith("This does not vanish") and length <= LONGEST_IN_LINE


def freedom_in_one(steps: Iterable[Step]) -> Iterator[Step]:
    """The classification and the degrees of freedom in one section."""
    waiting: Step | None = None
    for step in steps:
        if waiting is not None:
            if step.rule is Rule.DEGREES_OF_FREEDOM and step.choice == waiting.choice:
                title = "Classification and degrees of freedom"
                step = replace(step, rule=waiting.rule, title=title, body=(*waiting.body, *step.body))
            else:
                yield waiting
            waiting = None
        if step.rule is Rule.CLASSIFICATION:
            waiting = step
        else:
            yield step
    if waiting is not None:
        yield waiting


def remaining_shortly(step: Step, slots: Slots) -> Step:
    """A constraint that a choice of coordinates leaves, without the constant factors that all of its terms share."""
    moving = {*slots.coordinates, *slots.velocities, *slots.prescribed, t}

    def line(e: Equation) -> Equation:
        left = e.sides[0]
        if not (e.label or "").startswith("rate-") or e.sides[1:] != (sp.S.Zero,) or not isinstance(left, sp.Expr):
            return e
        factors = sp.Mul.make_args(sp.factor_terms(left))
        kept = [f for f in factors if f.free_symbols & moving or not f.is_nonzero]
        shorter = sp.expand(sp.Mul(*kept))
        return replace(e, sides=(shorter, sp.S.Zero)) if len(kept) < len(factors) else e

    blocks = (replace(b, equations=tuple(map(line, b.equations))) if isinstance(b, Display) else b for b in step.body)
    return replace(step, body=tuple(blocks))


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
        if isinstance(block, Display) and any((e.label or "").startswith("momentum-") for e in block.equations):
            kept = tuple(e for e in block.equations if not (e.label or "").startswith("momentum-"))
            before = body[-1]
            assert isinstance(before, Prose)
            body[-1] = replace(before, parts=tuple(_without_momentum(p) for p in before.parts))
            block = replace(block, equations=kept)
        body.append(block)
    return replace(step, body=tuple(body))


def _without_momentum(part: Part) -> Part:
    if not isinstance(part, str):
        return part
    part = part.replace(
        "Its angular velocity and its angular momentum about the mass centre are", "Its angular velocity is"
    )
    part = part.replace(", angular velocities and angular momenta about the mass centres", " and angular velocities")
    return capital(part) if part.startswith("its angular") else part
