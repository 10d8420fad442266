"""Which branches of an answer exist with the values of a problem: those whose conditions are not violated by them."""

from __future__ import annotations

from lagrange.algebra.closed_forms.signs import SignCondition
from lagrange.mechanics.equilibrium.in_numbers import condition_holds
from lagrange.mechanics.questions.results import AnswerBranch, Asked
from lagrange.values.quantities import NotRealError, Values


def branches_with(asked: Asked, values: Values) -> tuple[AnswerBranch, ...]:
    """The branches without those that the values exclude; a condition with open parameters excludes none."""
    return tuple(b for b in asked.branches if not any(_is_violated(c, values) for c in b.conditions))


def _is_violated(condition: SignCondition, values: Values) -> bool:
    try:
        return condition_holds(condition, values.put_in) is False
    except NotRealError:
        return True
