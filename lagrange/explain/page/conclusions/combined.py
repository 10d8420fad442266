"""The step from the equations of motion to those in another form: which multiples of them add up to these."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from lagrange.document.derivation import Part, Ref, listed, math, series
from lagrange.explain.motion import label_from_principle
from lagrange.explain.words import suffix_of
from lagrange.mechanics.dynamics.equations import EquationsOfMotion
from lagrange.mechanics.rewriting.combinations import Combination

_ORDER = ("first", "second", "third", "fourth", "fifth", "sixth")


def explain_combined(found: Sequence[Combination], motion: EquationsOfMotion) -> tuple[Part, ...]:
    """` from (16) times 1 + sin² s:`, or of several `the first is the sum of (13) times ... ;`; empty if not known."""
    new = [(n, c) for n, c in enumerate(found) if not c.is_one]
    if not new or len(found) > len(_ORDER):
        return ()
    clauses = [(f"the {_ORDER[n]} is " if len(found) > 1 else "it is ", *_sum(c, motion)) for n, c in new]
    refs = [Ref(f"with{suffix_of(motion.configuration.name)}-{row.name}") for row in motion.completing]
    by = (", by ", *listed(refs)) if refs and any(c.with_constraints for _, c in new) else ()
    return (" ", *series(clauses), *by, ".")


def _sum(c: Combination, motion: EquationsOfMotion) -> tuple[Part, ...]:
    suffix = suffix_of(motion.configuration.name)
    whats: list[tuple[sp.Expr, tuple[Part, ...]]] = [
        *((m, (Ref(label_from_principle(motion, e)),)) for m, e in zip(c.equations, motion.equations, strict=True)),
        *((m, ("the time derivative of ", Ref(f"with{suffix}-{row.name}")))
          for m, row in zip(c.constraints, motion.completing, strict=True)),
    ]  # fmt: skip
    used = [(m, what) for m, what in whats if m != 0]
    if len(used) == 2 and used[1][0] == -1:
        return (*_times(*used[0]), " minus ", *used[1][1])
    terms = [_times(m, what) for m, what in used]
    return terms[0] if len(terms) == 1 else ("the sum of ", *series(terms))


def _times(m: sp.Expr, what: tuple[Part, ...]) -> tuple[Part, ...]:
    if m == 1:
        return what
    factor = math(m)
    return ("(", factor, ") times ", *what) if m.is_Add else (factor, " times ", *what)
