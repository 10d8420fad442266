"""Reading `impact`: the state just before, given impulses, the constraints that begin to act, restitution.

    impact:
      before: {x': v, theta: 0}
      impulses: {blow: {on: rod, vector: J*i, at: r_A}}
      constraints: {peg: "x + l*cos(theta) = 0"}
      restitution: {peg: e}

`before` has velocities, and coordinates where the position in which the impact occurs is known. The names of new
constraints differ from those of the others, which go on.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import sympy as sp

from lagrange.core.diagnostics import Diagnostic, suggestion
from lagrange.expressions.reader import Scope
from lagrange.problem import keys
from lagrange.problem.constraints import read_constraints
from lagrange.problem.declared_names import Namespace, canonical
from lagrange.problem.forces import read_impulses
from lagrange.problem.load_context import LoadContext
from lagrange.problem.model import Constraint, Impact
from lagrange.problem.questions import Instant, read_state
from lagrange.problem.sections import CONSTANT, Section, entries_of, mapping_of
from lagrange.problem.yaml.nodes import Node

_EXAMPLE = "impact: {before: {x': v}, constraints: {wall: x = 0}, restitution: {wall: e}}"

_BEFORE = Instant("`before`", "the state just before", "value before the impact", "before: {x': v, theta: 0}")


def read_impact(
    node: Node | None, context: LoadContext, scope: Scope, old: Iterable[Constraint]
) -> Impact | None:
    """The section `impact`; None where there is none.

    scope  the names that the state before may use
    old    the constraints that act before and after
    """
    if node is None:
        return None
    mapping = context.diagnostics.attempt(lambda: mapping_of(node, "`impact`", _EXAMPLE))
    if mapping is None:
        return None
    section = Section(mapping, "the impact", keys.IMPACT, context.diagnostics)
    before = read_state(section.section("before"), context, scope, _BEFORE)
    impulses = read_impulses(section.section("impulses"), context)
    names = Namespace(context.names)
    for constraint in old:
        names.reserve(constraint.name, "a constraint", constraint.span)
    constraints = read_constraints(section.section("constraints"), context, names)
    declared = [*dict.fromkeys(c.name.partition(".")[0] for c in constraints)]
    restitution = _restitution(section.section("restitution"), context, declared)
    if not section.has("impulses") and not section.has("constraints"):
        message = "nothing happens in this impact: there is neither an impulse nor a new constraint"
        help_ = "give `impulses`, or `constraints` that begin to act"
        context.diagnostics.report(Diagnostic("empty-impact", message, section.node.span, help=help_))
    of_components = {c.name: restitution.get(c.name.partition(".")[0], sp.S.Zero) for c in constraints}
    return Impact(section.node.span, before, impulses, constraints, of_components)


def _restitution(node: Node | None, context: LoadContext, declared: list[str]) -> Mapping[str, sp.Expr]:
    """name of a new constraint -> its coefficient."""
    if node is None:
        return {}
    coefficients: dict[str, sp.Expr] = {}
    for key, value in context.diagnostics.attempt(lambda: entries_of(node, "`restitution`", "{peg: e}")) or ():
        name = canonical(key.text, declared)
        if name not in declared:
            if not context.names.has_failed(key.text):
                message = f"`{key.text}` is not a constraint that begins to act"
                help_ = suggestion(name, declared, "new constraints")
                context.diagnostics.report(Diagnostic("unknown-name", message, key.span, help=help_))
            continue
        read = context.diagnostics.attempt(
            lambda v=value, n=name: context.scalar(v, f"the restitution of `{n}`", CONSTANT)  # type: ignore[misc]
        )
        if read is None:
            continue
        if read.is_negative or (read - 1).is_positive:
            message = f"the coefficient of restitution of `{name}` is not between 0 and 1"
            help_ = "0 is a perfectly inelastic impact, 1 an elastic one"
            context.diagnostics.report(Diagnostic("bad-restitution", message, value.span, help=help_))
            continue
        coefficients[name] = read
    return coefficients
