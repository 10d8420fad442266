"""Are the stated amplitudes of a steady state right?

Each entry is an expression, or an equation with the coordinate on the left, for the amplitude of one coordinate. Its
square must be that of the derived one, exactly, with decimals that may be rounded: the sign of an amplitude tells the
phase, and may be stated either way.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.answers.questions.named_values import Judged, check_each
from lagrange.answers.readings import decimals_in
from lagrange.answers.references import Reference, reference_of_solution
from lagrange.answers.verdicts import UNDECIDED, AnswerVerdict, Verdict
from lagrange.answers.written.decimals import as_written, numbers_rounding_to
from lagrange.answers.written.reading import tried
from lagrange.answers.written.statements import statement
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError, suggestion
from lagrange.core.vectors import Vector
from lagrange.expressions.reader import read_value
from lagrange.mechanics.equilibrium.driven.response import Response
from lagrange.mechanics.results import Solution

_NOT_DERIVED = "the problem does not ask for the response to a harmonic drive"
_MOVES = "an amplitude does not depend on time"


def check_response_answers(stated: Mapping[str, Fragment], solution: Solution) -> AnswerVerdict:
    """The verdict on all amplitudes together."""
    responses = [v.response for v in solution.views if v.response is not None]
    if not responses:
        return AnswerVerdict(Verdict.UNDECIDED, name="response", diagnosis=_NOT_DERIVED)
    reference = reference_of_solution(solution)
    claims: dict[str, sp.Expr] = {}
    verdict = check_each(
        "response", stated, lambda name, fragment: _judged(name, fragment, responses, reference, claims)
    )
    if verdict.verdict is not Verdict.WRONG or len(claims) < len(stated):
        return verdict
    from lagrange.answers.results.amplitudes import explained_amplitudes

    together = next(filter(None, (explained_amplitudes(claims, r) for r in responses)), "")
    if not together:
        return verdict
    plain = tuple(replace(e, diagnosis="") for e in verdict.equations)  # one cause for all of them
    return replace(verdict, equations=plain, diagnosis=together)


def _judged(
    name: str, fragment: Fragment, responses: Sequence[Response], reference: Reference, claims: dict[str, sp.Expr]
) -> Judged:
    """The verdict on one amplitude, which is added to `claims`. Raises ProblemError, DivisionByZeroError."""
    squares = _squares(responses)
    if name not in squares:
        message = f"`{name}` is not a coordinate with an amplitude"
        raise ProblemError(
            Diagnostic("unknown-name", message, fragment.whole, help=suggestion(name, list(squares), "coordinates"))
        )
    scalars = {n: e for n, e in reference.scope.scalars.items() if n not in reference.letters}
    stated = statement(fragment, replace(reference.scope, scalars=scalars, decimals=""), name=name)
    # x = F/k, A = F/k, |x| = F/k: what stands on the left is the amplitude
    claim = tried(stated.sides[-1], stated.scope, lambda f: read_value(f, stated.scope, [], latex=True))
    if isinstance(claim, Vector):
        raise ProblemError(Diagnostic("vector-for-scalar", "an amplitude is a number, not a vector", fragment.whole))
    if not any(s.name == "t" for s in claim.free_symbols):
        claims[name] = as_written(claim).xreplace(dict(reference.values))
    return judged_amplitude(claim, name, responses, reference)


def judged_amplitude(claim: sp.Expr, name: str, responses: Sequence[Response], reference: Reference) -> Judged:
    """The verdict on the value of the amplitude of a coordinate. Raises DivisionByZeroError."""
    squares = _squares(responses)
    if any(s.name == "t" for s in claim.free_symbols):
        return Verdict.WRONG, _MOVES
    difference = (claim**2 - squares[name]).xreplace(dict(reference.values))
    same = is_zero(as_written(difference))
    if same is False and decimals_in([difference]):
        same = numbers_rounding_to([difference]) is not None
    if same is not False:
        return (Verdict.UNDECIDED, UNDECIDED) if same is None else (Verdict.EQUIVALENT, "")
    from lagrange.answers.models.questions import explained_value

    amplitude = sp.powdenest(sp.sqrt(sp.factor(sp.expand(squares[name]))), force=True)
    why = (explained_value(sign * as_written(claim), amplitude, set()) for sign in (1, -1))
    if reason := next(filter(None, why), ""):
        return Verdict.WRONG, reason
    from lagrange.answers.results.units import wrong_dimension

    return Verdict.WRONG, wrong_dimension(as_written(claim), reference.units, amplitude)


def _squares(responses: Sequence[Response]) -> dict[str, sp.Expr]:
    """The squares of the amplitudes by the names of their coordinates."""
    return {
        q.name: sp.Add(a**2, b**2)
        for r in responses
        for q, a, b in zip(r.forced.configuration.slots.coordinates, r.cosines, r.sines, strict=True)
    }
