"""The length of a spring as the letter that the statement gives it, where it is a long root when written out.

d = √(a² + 2a l (sin θ₂ − sin θ₁) + ...) occurs in the potential energy, in every equation of motion and in those of
rest: all of them are easier to read with d, like the force of a spring, c (d − a).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.core.symbols import prime, variation
from lagrange.document.derivation import Block, Display, Equation, Mathematics, Rule, Step
from lagrange.explain.limits import SHORTEST_REPEATED_LENGTH
from lagrange.mechanics.results import Solution
from lagrange.mechanics.rewriting.root_letters import is_root_of, roots_by_letters

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
            step = replace(step, body=tuple(_block(b, lengths, stated) for b in step.body))
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
    """The radicands of long roots that a letter stands for, with the letter."""
    for block in step.body:
        for e in block.equations if isinstance(block, Display) else ():
            name, value = e.sides[0], e.sides[-1]
            if not isinstance(name, sp.Symbol) or not isinstance(value, sp.Pow) or value.exp != sp.S.Half:
                continue
            if e.operations >= SHORTEST_REPEATED_LENGTH:
                yield value.base, sp.Symbol(name.name, positive=True)


def _block(block: Block, lengths: dict[sp.Expr, sp.Symbol], stated: dict[str, sp.Symbol]) -> Block:
    if not isinstance(block, Display):
        return block
    return replace(block, equations=tuple(_line(e, lengths, stated) for e in block.equations))


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
