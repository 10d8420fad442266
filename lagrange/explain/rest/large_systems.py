"""The derivation for a system in which nothing is eliminated: what was found, in short, and where the long part is."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import prime
from lagrange.document.derivation import (
    Block,
    Detail,
    Equation,
    EquationKind,
    Matrices,
    Part,
    Rule,
    Step,
    Table,
    display,
    listed,
    math,
    prose,
)
from lagrange.explain.constraints import explain_classification, explain_freedom
from lagrange.explain.limits import LARGE_SYSTEM_DIGITS, LONGEST_CONSTRAINT
from lagrange.explain.words import counted, in_words, plural
from lagrange.mechanics.constraints.classification import Classification
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.nearby.linear_motion import LinearBlock, LinearMotion, StableRange
from lagrange.mechanics.nearby.long_equations import LongEquations
from lagrange.mechanics.nearby.one_state import RestInNumbers, StateInNumbers
from lagrange.mechanics.results import Solution


def large_system_steps(solution: Solution, taken: frozenset[str]) -> Iterator[Step]:
    """The steps before the checks."""
    classification = solution.classification
    yield _constraints(classification)
    followed = tuple(replace(r, combination=None) for r in classification.redundancies)  # of forms that are not shown
    yield explain_classification(replace(classification, redundancies=followed), taken)
    yield explain_freedom(classification)
    if solution.long_equations is not None:
        yield _equations(solution.long_equations, solution)
    if solution.at_start is not None:
        yield _start(solution.at_start, solution.own.configuration)
    if solution.linear_motion is not None:
        yield _linear(solution.linear_motion)
    if solution.rest_in_numbers is not None:
        yield _rest(solution.rest_in_numbers, solution.own.configuration)


def _start(state: StateInNumbers, configuration: Configuration) -> Step:
    """Accelerations and multipliers at t = 0."""
    steady = all(x == 0 for x in state.accelerations.values())
    body: list[Block] = []
    if steady:
        body.append(prose("At the start all accelerations are zero: the motion is steady there."))
    else:
        body.append(prose("The equations are linear in the accelerations. At the start, in SI units, they give"))
        body.append(display(*(Equation((a, _short(x))) for a, x in state.accelerations.items()), boxed=True))
    if state.multipliers:
        body.append(prose("and the multipliers" if not steady else "The multipliers are there, in SI units,"))
        rows = (r for r in configuration.rows if r.name in state.multipliers)
        body.append(display(*(Equation((r.multiplier, _short(state.multipliers[r.name]))) for r in rows)))
    return Step(Rule.EQUATIONS_OF_MOTION, "The accelerations at the start", tuple(body))


def _rest(rest: RestInNumbers, configuration: Configuration) -> Step:
    """The position of equilibrium, its stability, the multipliers."""
    body: list[Block] = [
        prose("With the accelerations zero the equations of motion are conditions of equilibrium. Newton's iteration, "
              "begun at the position of `initial`, leads in SI units to"),
        display(*(Equation((q, _short(x))) for q, x in rest.position.items()), boxed=True),
    ]  # fmt: skip
    if rest.stable is not None:
        kind = "a minimum: it is stable" if rest.stable else "no minimum: it is unstable"
        body.append(prose(f"There the potential energy, under the constraints, has {kind}. "
                          "Other positions of equilibrium were not looked for.", detail=Detail.BRIEF))  # fmt: skip
    else:
        body.append(prose("Other positions of equilibrium were not looked for.", detail=Detail.BRIEF))
    if rest.multipliers:
        body.append(prose("The multipliers are there, in SI units,"))
        rows = (r for r in configuration.rows if r.name in rest.multipliers)
        body.append(display(*(Equation((r.multiplier, _short(rest.multipliers[r.name]))) for r in rows)))
    return Step(Rule.EQUILIBRIUM, "Equilibrium", tuple(body))


def _constraints(classification: Classification) -> Step:
    """The constraints, short ones written out, with a description of each."""
    short = [c for c in classification.constraints if count_operations(c.constraint.function) <= LONGEST_CONSTRAINT]
    lines = [Equation((c.constraint.lhs, c.constraint.rhs), label=f"constraint-{c.row.name}") for c in short]
    rows = tuple(
        (
            c.row.name,
            "geometric" if c.row.finite is not None else "kinematic",
            "undecided" if c.integrable is None else "yes" if c.integrable else "no",
            "follows from others" if c.row.name in classification.redundant else "",
        )
        for c in classification.constraints
    )
    body: list[Block] = [display(*lines)] if lines else []
    left = len(classification.constraints) - len(short)
    if left:
        body.append(
            prose(f"{in_words(left, 'other constraint').capitalize()} {plural(left, 'is', 'are')} too long to be read: "
                  "`--format json` prints all of them, as the file states them and as differential forms.")
        )  # fmt: skip
    body.append(prose("Whether a constraint is integrable is decided by Frobenius' condition at random exact points "
                      "where the geometric constraints hold."))  # fmt: skip
    body.append(Table(("constraint", "kind", "integrable", ""), rows, Detail.BRIEF))
    return Step(Rule.CONSTRAINT, "Constraints", tuple(body))


def _equations(equations: LongEquations, solution: Solution) -> Step:
    """The length of the equations of motion and where they can be found; in full, the equations."""
    slots = solution.problem.slots
    operations = sum(count_operations(e) for e in (*equations.definitions.values(), *equations.left, *equations.right))
    names = list(equations.definitions)
    text = (
        f"D'Alembert's principle gives {counted(len(equations.left), 'equation')} with "
        f"{counted(len(solution.classification.rows), 'multiplier')}, one equation for each coordinate. Nothing is "
        f"eliminated or multiplied out. They have {operations:,} operations, with {len(names)} abbreviations ",
    )
    body: list[Block] = []
    if names:
        body.append(
            prose(*text, math(names[0]), " to ", math(names[-1]), " for what occurs several times. `--format json` has "
                  "them under `equations` and `definitions`, `--detail full` prints them here.", detail=Detail.BRIEF)
        )  # fmt: skip
        body.append(display(*(Equation((z, e)) for z, e in equations.definitions.items()), detail=Detail.FULL))
    lines = (
        Equation((left, right), label=f"motion-{q.name}", kind=EquationKind.MOTION)
        for q, left, right in zip(slots.coordinates, equations.left, equations.right, strict=True)
    )
    body.append(display(*lines, detail=Detail.FULL if names else Detail.BRIEF))
    return Step(Rule.EQUATIONS_OF_MOTION, "Equations of motion", tuple(body))


def _linear(motion: LinearMotion) -> Step:
    """The motion, and the linear equations about it."""
    steady = [(s, e) for s, e in motion.state.items() if e != 0]
    rest = [s for s, e in motion.state.items() if e == 0 and not s.name.endswith("'")]
    body: list[Block] = [prose("The steady motion about which the equations are linear has")]
    body.append(display(*(Equation((s, e)) for s, e in steady)))
    body.append(prose("and ", *listed(math(s) for s in rest), plural(len(rest), " is", " are"), " zero at the start. "
                      "Positions and axes are expanded in small changes, the constraints are solved to first order in "
                      "numbers, and nothing else is approximated."))  # fmt: skip
    if motion.ignorable:
        body.append(
            prose(*listed(math(q) for q in motion.ignorable), " follow from the other coordinates by the constraints, "
                  "and do not act on them.")
        )  # fmt: skip
    for n, whole in enumerate(motion.blocks, start=1):
        block = _shorter(whole)
        if len(block.coordinates) > 1:
            body += _matrices(block)
        body.append(prose("The linear equations, the letters standing for small changes:" if n == 1 else "and"))
        body.append(
            display(*(_line(e, block, n, k) for k, e in enumerate(block.equations)), boxed=True, detail=Detail.BRIEF)
        )
        if whole.exponents:
            body.append(
                prose("Their solutions grow or decay as ", math(sp.exp(sp.Symbol("p") * sp.Symbol("t"))), ", with ",
                      math(sp.Symbol("p")), " one of ", *listed(_exponents(whole)), ".", detail=Detail.BRIEF)
            )  # fmt: skip
        if whole.stable_ranges is not None:
            body.append(_stability(whole.stable_ranges))
    return Step(Rule.LINEARIZATION, "Linear equations about the steady motion", tuple(body))


def _stability(ranges: Sequence[StableRange]) -> Block:
    """For which values of the parameter the solutions decay, and what happens at the ends."""
    if not ranges:
        return prose("For no value of the parameter do all their solutions decay.", detail=Detail.BRIEF)
    parts: list[Part] = ["All their solutions decay if "]
    for n, r in enumerate(ranges):
        parts += [" or if " if n else "", math(*_inside(r), relation="<")]
    parts.append(" (in SI units).")
    for r in ranges:
        for end, beyond in ((r.low, "below"), (r.high, "above")):
            if end not in (0, sp.oo):
                grows = "an oscillation grows" if end in r.oscillating else "the deviation grows without oscillating"
                parts += [f" Just {beyond} ", math(r.letter, _short(end)), f" {grows}."]
    return prose(*parts, detail=Detail.BRIEF)


def result_of_large_system(solution: Solution) -> Iterator[Step]:
    """For the head of the page: for which values of the parameter the deviations from the steady motion decay."""
    motion, freedom = solution.linear_motion, solution.classification.degrees_of_freedom
    stable = [b.stable_ranges for b in motion.blocks if b.stable_ranges is not None] if motion is not None else []
    if len(stable) != 1 or freedom is None:
        return
    [ranges] = stable
    start = f"{in_words(freedom, 'degree').capitalize()} of freedom; "
    inside = listed((math(*_inside(r), relation="<") for r in ranges), " or ")
    words: tuple[Part, ...] = ("small deviations from the steady motion decay if ", *inside, " (in SI units).")
    if not ranges:
        words = ("the steady motion is stable for no value of the parameter.",)
    yield Step(Rule.RESULT, "", (prose(start, *words, detail=Detail.BRIEF),))


def _inside(r: StableRange) -> tuple[sp.Expr, ...]:
    """The ends of a range with the letter between them."""
    inside = (r.letter, _short(r.high)) if r.low == 0 else (_short(r.low), r.letter, _short(r.high))
    return tuple(x for x in inside if x is not sp.oo)


def _short(x: sp.Expr) -> sp.Expr:
    return x if x is sp.oo or x == 0 else sp.Float(x, LARGE_SYSTEM_DIGITS)


def _shorter(block: LinearBlock) -> LinearBlock:
    """The block with numbers of six digits."""

    def short(rows: tuple[tuple[sp.Expr, ...], ...]) -> tuple[tuple[sp.Expr, ...], ...]:
        return tuple(
            tuple(e.xreplace({f: sp.Float(f, LARGE_SYSTEM_DIGITS) for f in e.atoms(sp.Float)}) for e in row)
            for row in rows
        )

    return replace(block, mass=short(block.mass), damping=short(block.damping), stiffness=short(block.stiffness))


def _exponents(block: LinearBlock) -> Iterator[str]:
    """`-0.7753 ± 4.465i`, and real ones."""
    for p in block.exponents:
        real, imaginary = (float(x) for x in p.as_real_imag())
        if imaginary >= 0:
            text = f"{real:.{LARGE_SYSTEM_DIGITS}g}" + (f" ± {imaginary:.{LARGE_SYSTEM_DIGITS}g}i" if imaginary else "")
            yield text.replace("-", "\u2212")


def _matrices(block: LinearBlock) -> Sequence[Block]:
    names = (sp.Symbol("M"), sp.Symbol("D"), sp.Symbol("K"))
    named = tuple(zip(names, (block.mass, block.damping, block.stiffness), strict=True))
    x = [math(q) for q in block.coordinates]
    return [prose("With ", *listed(x), " in this order, the accelerations, velocities and coordinates have the tables"),
            Matrices(named, Detail.STEPS)]  # fmt: skip


def _line(e: sp.Expr, block: LinearBlock, n: int, k: int) -> Equation:
    return Equation((e, sp.S.Zero), label=f"linear-{n}-{prime(block.coordinates[k]).name}", kind=EquationKind.LINEAR)
