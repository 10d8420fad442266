"""Two mistakes at once: an answer that follows from a problem changed in two ways.

Only likely mistakes are combined, each of which changes the system itself, and only where neither one of them nor one
changed term explains the answer: `without dT/dq, and for gravity that acts the other way`. A second change is made in
the system that the first has changed, so that nothing is derived. Their number is a budget of work.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations, islice

import sympy as sp

from lagrange.answers.limits import MAX_FIRST_MISTAKES, MAX_OF_ONE_KIND, MAX_PAIR_WORK
from lagrange.answers.models.mechanics import Mechanics, Variation
from lagrange.answers.models.search import Explanation, Models, changed_space, follows_from_rest, said_of_all, unusable
from lagrange.answers.models.table import MODELS, Model

LIKELY = frozenset(
    (
        "gravity reversed",
        "friction the other way",
        "force reversed",
        "momentum of exchanged mass",
        "moving frame or support taken as fixed",
        "rotational energy left out",
        "carried velocity left out",
        "product of velocities in T left out",
        "moment of inertia of another body",
        "gravity left out",
        "friction left out",
        "spring with its length for its extension",
        "force left out",
        "dT/dq left out",
        "d/dt of a product half done",
        "energy of a spring or potential without its half",
        "mass left out",
    )
)


def explained_by_two(equations: Sequence[sp.Expr], models: Models) -> Explanation | None:
    """The two mistakes from which all equations of an answer follow together; None if none are found."""
    try:
        if models.mechanics is None:
            return None
        states = models.states(equations)
        rows = [[at.row(e) for e in equations] for at in states]
        others = states[1:]
        for name, variation, space in models.pairs(lambda: _pairs(models)):
            if (
                all(r is not None and r in space for r in rows[0])
                and all(
                    (other := changed_space(variation, at)) is not None
                    and all(r is not None and r in other for r in own)
                    for at, own in zip(others, rows[1:], strict=True)
                )
                and not any(r is not None and follows_from_rest(r, variation, states[0]) for r in rows[0])
            ):
                return said_of_all(name, variation, len(equations))
    except unusable:
        pass
    return None


def _pairs(models: Models) -> Iterator[tuple[str, Variation]]:
    assert models.mechanics is not None
    likely = [m for m in MODELS if m.name in LIKELY]
    first = [(m, v) for m in likely for v in islice(_changes(m, models.mechanics), MAX_OF_ONE_KIND)]
    first = first[:MAX_FIRST_MISTAKES]
    work = MAX_PAIR_WORK
    cost = len(models.system.equations) * (len(models.states(())[0].unknowns) + 1)
    # The earlier both are in the table, the likelier they are together.
    for (a, one), (b, two) in sorted(combinations(first, 2), key=lambda pair: _rank(pair, first)):
        if a.name == b.name:
            continue
        both = next((v for v in _changes(b, one.mechanics) if v.clause == two.clause), None)
        if both is None:
            continue
        yield f"{a.name}; {b.name}", Variation(f"{one.clause}, and {two.clause}", one.place, both.mechanics)
        work -= cost
        if work < 0:
            return


def _rank(pair: tuple[tuple[Model, Variation], ...], first: list[tuple[Model, Variation]]) -> int:
    a, b = (next(n for n, f in enumerate(first) if f is p) for p in pair)
    return a + b


def _changes(model: Model, mechanics: Mechanics | None) -> Iterator[Variation]:
    if mechanics is not None:
        for v in model.changes(mechanics):
            if v.mechanics is not None and v.quasi is None and not v.is_reduced:
                yield v
