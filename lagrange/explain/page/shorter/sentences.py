"""Sentences and equations of the full derivation in fewer words, conditions turned round, springs by their lengths.

Sentences of the full derivation that a page says in fewer words, and short equations side by side.

The full derivation explains Newton's law and multipliers wherever they occur. A page explains once what it needs.

Conditions with the quantity that they limit on the left, as a reader expects: μ ≥ ½ tan φ, P ≥ M a/(l r).

The length of a spring as the letter that the statement gives it, where it is a long root when written out.

d = √(a² + 2a l (sin θ₂ − sin θ₁) + ...) occurs in the potential energy, in every equation of motion and in those of
rest: all of them are easier to read with d, like the force of a spring, c (d − a).
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.core.symbols import prime, variation
from lagrange.document.derivation import (
    Block,
    Display,
    Equation,
    EquationKind,
    Math,
    Mathematics,
    Phrase,
    Prose,
    Purpose,
    Ref,
    Rule,
    Step,
    has_purpose,
    index_of,
    listed,
    paired,
    parts_of,
    prose,
)
from lagrange.explain.limits import LONGEST_PLAIN_FORCES, SHORTEST_REPEATED_LENGTH
from lagrange.explain.page.system import are_short
from lagrange.mechanics.results import Solution
from lagrange.mechanics.rewriting.factors import with_factors_in_fraction
from lagrange.mechanics.rewriting.readable_forms import is_root_of, roots_by_letters


def in_fewer_words(steps: Sequence[Step]) -> Iterator[Step]:
    """The steps with shorter sentences, and with displacements and substitutions in pairs."""
    referred = {p.label for s in steps for b in s.body for p in parts_of(b) if isinstance(p, Ref)}
    moves = any(s.rule in (Rule.EQUATIONS_OF_MOTION, Rule.QUASI_VELOCITIES) for s in steps)
    for step in steps:
        kept = step.folded or step.rule is Rule.RESULT
        body = step.body if kept else tuple(_shortly(step.body, referred))
        if moves and not kept and step.rule in (Rule.CLASSIFICATION, Rule.DEGREES_OF_FREEDOM):
            body = tuple(map(_only_velocities, body))  # where constraints are the subject it is said in full
        yield replace(step, body=body)


def _shortly(body: Sequence[Block], referred: Collection[str]) -> Iterator[Block]:
    for n, block in enumerate(body):
        follows = body[n + 1] if n + 1 < len(body) else None
        if isinstance(block, Prose):
            yield _words(block, follows)
        elif isinstance(block, Display) and not block.boxed and _are_steps(block, referred):
            yield replace(block, equations=tuple(_in_pairs(block.equations)))
        else:
            yield block


def _only_velocities(block: Block) -> Block:
    if not isinstance(block, Prose):
        return block
    of = Purpose.REACHED
    parts = (p.instead if isinstance(p, Phrase) and p.purpose is of and p.instead else p for p in block.parts)
    return replace(block, parts=tuple(parts))


def _words(block: Prose, follows: Block | None) -> Prose:
    first = block.parts[0] if block.parts else ""
    if isinstance(first, Phrase) and first.purpose is Purpose.LAW:
        return prose(first.instead, *block.parts[1:])
    if isinstance(first, Phrase) and first.purpose is Purpose.SUM_AND_MOMENT:
        return prose(first.instead)
    if has_purpose(block, Purpose.MULTIPLIERS) and index_of(Purpose.EVERY_COORDINATE, block.parts) is not None:
        letters = [p for p in block.parts if isinstance(p, Math)]
        multipliers = letters[: _count(block)]
        return prose("With ", "a multiplier " if len(multipliers) == 1 else "multipliers ", *listed(multipliers),
                     " of the constraint" if len(multipliers) == 1 else " of the constraints",
                     " instead, nothing is eliminated, and for every coordinate")  # fmt: skip
    too_long = index_of(Purpose.REASON, block.parts[:1]) is not None
    if too_long and isinstance(follows, Display) and follows.operations <= LONGEST_PLAIN_FORCES:
        return replace(block, parts=block.parts[1:])
    return block


def _count(block: Prose) -> int:
    """The number of multipliers that a paragraph names before saying what becomes of them."""
    end = index_of(Purpose.VERB, block.parts)
    return sum(isinstance(p, Math) for p in block.parts[:end])


def _are_steps(block: Display, referred: Collection[str]) -> bool:
    """Whether it has substitutions of coordinates, or displacements, to none of which anything refers."""
    free = not any(e.label in referred for e in block.equations)
    return free and len(block.equations) > 1 and all(_is_step(e) for e in block.equations)


def _is_step(e: Equation) -> bool:
    name = e.sides[0].name if isinstance(e.sides[0], sp.Symbol) else ""
    plain = len(e.sides) == 2 and not e.condition and e.relation == "="
    return plain and (e.kind is EquationKind.CHOICE or (e.label is None and name.startswith(("delta(", "d("))))


def _in_pairs(equations: Sequence[Equation]) -> Iterator[Equation]:
    """Neighbours of one point, x₁ and y₁, side by side where both are short."""
    rest = [*equations]
    while rest:
        pair = rest[:2]
        if len(pair) == 2 and len({_index(e) for e in pair}) == 1 and are_short(pair):
            yield paired(pair)[0]
            rest = rest[2:]
        else:
            yield rest.pop(0)


def _index(e: Equation) -> str:
    """`1` of x₁ and of δx₁."""
    name = e.sides[0].name if isinstance(e.sides[0], sp.Symbol) else ""
    name = name.rpartition("(")[2].rstrip(")")
    return name.partition("_")[2] or name.lstrip("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ")


# Conditions turned round


_ASKED = (Rule.RESULT, Rule.QUESTION)
_TURNED = {Rule.RESULT: {"≤": "≥", "<": ">"}, Rule.FRICTION_AT_REST: {"≤": "≥", "<": ">", "=": "="}}
"""The relations that are turned round, and what they become: at the head no equations, which may be anything."""


def with_symbol_first(steps: Sequence[Step]) -> Iterator[Step]:
    """The steps, with conditions of rest reversed if a single symbol, or its tangent, is on the right."""
    for step in steps:
        if step.rule in _ASKED and not step.folded:
            step = replace(step, body=tuple(_factored(b) for b in step.body))
        relations = _TURNED.get(step.rule, {})
        if relations and not step.folded:
            step = replace(step, body=tuple(_turned_block(b, relations) for b in step.body))
        yield step


def _factored(block: Block) -> Block:
    """Answers with the factors of numerator and denominator in front, where these are sums of several terms."""
    if not isinstance(block, Display) or not block.boxed:
        return block
    return block.map(_in_factors)


def _in_factors(e: Equation) -> Equation:
    value = e.sides[-1]
    if not isinstance(value, sp.Expr):
        return e
    return replace(e, sides=(e.sides[0], with_factors_in_fraction(value))) if len(e.sides) == 2 else e


def _turned_block(block: Block, relations: Mapping[str, str]) -> Block:
    if not isinstance(block, Display) or not block.boxed:
        return block
    return block.map(lambda e: _turned(e, relations))


def _turned(e: Equation, relations: Mapping[str, str]) -> Equation:
    if len(e.sides) != 2 or e.relation not in relations:
        return e
    left, right = e.sides
    letters = [s.args[0] if isinstance(s, sp.tan) else s for s in e.sides]
    if not isinstance(letters[1], sp.Symbol) or not isinstance(left, sp.Expr) or isinstance(letters[0], sp.Symbol):
        return e
    if letters[1] in left.free_symbols:
        return e
    return replace(e, sides=(right, left), relation=relations[e.relation])


# Lengths of springs


_RULES = (Rule.STATEMENT, Rule.PRINCIPLE, Rule.EQUATIONS_OF_MOTION, Rule.LINEARIZATION, Rule.CONSERVED, Rule.MEANING,
          Rule.EQUILIBRIUM, Rule.REACTIONS, Rule.SOLVED_REACTIONS)  # fmt: skip


def with_lengths(solution: Solution, steps: Sequence[Step]) -> Iterator[Step]:
    """The steps, with the letters of long lengths after these have been stated: those of the file, if it has any."""
    statement = next((s for s in steps if s.rule is Rule.STATEMENT), None)
    named: dict[sp.Expr, sp.Symbol] = {}
    for radicand, letter in () if statement is None else _lengths(statement):
        named.setdefault(radicand, letter)
    lengths = {radicand: _own_letter(solution, radicand) or letter for radicand, letter in named.items()}
    same = () if statement is None else _lengths(statement)
    stated = {letter.name: lengths[radicand] for radicand, letter in same}
    for step in steps:
        if lengths and step.rule is Rule.RESULT:
            step = replace(step, body=tuple(_defined(b, lengths, stated) for b in step.body))
        elif lengths and step.rule in _RULES and not step.folded:
            step = replace(step, body=tuple(_block_with_lengths(b, lengths, stated) for b in step.body))
        yield step


def _defined(block: Block, lengths: dict[sp.Expr, sp.Symbol], stated: dict[str, sp.Symbol]) -> Block:
    """The box at the head with letters of lengths and a line d² = ... for each, where that is shorter."""
    if not isinstance(block, Display):
        return block
    lines = [_line(e, lengths, stated) for e in block.equations]
    used = {s for e in lines for side in e.sides if isinstance(side, sp.Expr) for s in side.free_symbols}
    letters = {letter: radicand for radicand, letter in lengths.items() if letter in used}
    whole = replace(block, equations=(*lines, *(Equation((d**2, square)) for d, square in letters.items())))
    return whole if letters and whole.operations < block.operations else block


def _own_letter(solution: Solution, radicand: sp.Expr) -> sp.Symbol | None:
    """The abbreviation of the file that is the root."""
    for name, value in solution.problem.abbreviations.items():
        if isinstance(value, sp.Expr) and is_root_of(value, radicand):
            return sp.Symbol(name, positive=True)
    return None


def _lengths(step: Step) -> Iterator[tuple[sp.Expr, sp.Symbol]]:
    """The radicands of long roots, each with the letter that abbreviates it."""
    for block in step.body:
        for e in block.equations if isinstance(block, Display) else ():
            name, value = e.sides[0], e.sides[-1]
            if not isinstance(name, sp.Symbol) or not isinstance(value, sp.Pow) or value.exp != sp.S.Half:
                continue
            if e.operations >= SHORTEST_REPEATED_LENGTH:
                yield value.base, sp.Symbol(name.name, positive=True)


def _block_with_lengths(block: Block, lengths: dict[sp.Expr, sp.Symbol], stated: dict[str, sp.Symbol]) -> Block:
    if not isinstance(block, Display):
        return block
    lines = tuple(_line(e, lengths, stated) for e in block.equations)
    is_stated = len(lines[0].sides) == 1 < len(block.equations[0].sides) and len(lines) == 2
    return replace(block, equations=paired(lines) if is_stated else lines)


def _line(e: Equation, lengths: dict[sp.Expr, sp.Symbol], stated: dict[str, sp.Symbol]) -> Equation:
    first = e.sides[0]
    letter = stated.get(first.name) if isinstance(first, sp.Symbol) else None
    if isinstance(first, sp.Symbol) and first.name in {s.name for s in lengths.values()}:
        return e  # what the letter stands for
    if letter is not None:
        return replace(e, sides=(letter,))  # stated before: by the file, or of another spring
    letters: dict[sp.Basic, sp.Basic] = {}
    for name, s in stated.items():
        letters |= {sp.Symbol(name, **{sign: True}): s for sign in ("real", "positive")}
        plain = sp.Symbol(name, real=True)
        letters |= {prime(plain): prime(s), variation(plain): variation(s)} if name != s.name else {}
    sides = [_side(s, lengths) for s in e.sides]
    sides = [s.xreplace(letters) if isinstance(s, sp.Expr) else s for s in sides]
    kept = [s for n, s in enumerate(sides) if n == 0 or s != sides[n - 1]]
    return replace(e, sides=tuple(kept))


def _side(side: Mathematics, lengths: dict[sp.Expr, sp.Symbol]) -> Mathematics:
    return roots_by_letters(side, lengths) if isinstance(side, sp.Expr) else side
