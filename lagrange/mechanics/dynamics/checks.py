"""The checks of a solution, each by a second route that shares no code with the first.

    finite relations            dF ∧ ω = 0, by exterior algebra in the coordinates of the file
    equations of motion         Lagrange's equations from T, V and Q, which share only the positions with d'Alembert's
                                principle; or d'Alembert's principle, where Lagrange's equations are the method
    virtual displacements       the solved δq substituted back into A δq = 0
    energy                      dT/dt with the accelerations from the equations, against the power of the forces
    coordinates                 the equations in the file's coordinates, rewritten in those of a choice
    reactions                   their virtual work; their values substituted into the equations of the other method

All are exact: expressions are evaluated at random states of a random prime field, and solution sets are compared, never
printed forms. A check that cannot be decided reports that and does not count as passed.

Moments of inertia must be constant in the triad that the file gives for them. A triad that turns with Ω while the body
turns with ω is fixed in the body only if ω = Ω; otherwise the inertia must be unaffected by the relative rotation,

    (B − C) (ω − Ω)·e_1 = 0 ,    (C − A) (ω − Ω)·e_2 = 0 ,    (A − B) (ω − Ω)·e_3 = 0

in every possible state; a body with A = B may turn relative to the triad about e_3. With products of inertia the
elements of dJ/dt take the place of these.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from lagrange.algebra.exact.zero_test import Point, Surface, agreed, has_real_point
from lagrange.algebra.forms.exact_forms import ExteriorForm, differentiated, exterior_derivative, one_form, wedge
from lagrange.algebra.fourier.vector_cleanup import is_many_waves
from lagrange.core.diagnostics import Diagnostic, ProblemError, UndecidedError
from lagrange.core.inertia import NO_PRODUCTS
from lagrange.core.records import all_hold, any_holds, record
from lagrange.core.symbols import partial, t
from lagrange.mechanics.constraints.classification import Classification
from lagrange.mechanics.constraints.constrained_system import Row
from lagrange.mechanics.constraints.coordinates import GeneralizedCoordinates
from lagrange.mechanics.constraints.displacements import Elimination, virtual_displacement
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.comparison import (
    System,
    affine_rows,
    agreed_in_motion,
    compare,
    follow,
    random_state,
    symbols_of,
)
from lagrange.mechanics.dynamics.equations import EquationsOfMotion
from lagrange.mechanics.dynamics.lagrangian import applied_power, kinetic_energy, lagrange_equations
from lagrange.mechanics.dynamics.motion import Method
from lagrange.mechanics.dynamics.newton import WorkOfReaction
from lagrange.mechanics.dynamics.principle import dalembert, given_forces
from lagrange.mechanics.dynamics.reactions import Reactions
from lagrange.problem.model import Body, Problem


def check_constant_inertia(problem: Problem, configuration: Configuration) -> None:
    """Refuse a triad in which the inertia of a body changes.

    Raises ProblemError with the reason, UndecidedError if this could not be decided.
    """
    if not problem.bodies:
        return
    from lagrange.mechanics.constraints.rigid_bodies import relative_to_triad

    rotations = {r.name: r for r in configuration.rotations}
    for body in problem.bodies:
        parts = relative_to_triad(rotations[body.name], configuration.slots)
        constant = _vanish(parts, configuration)
        if constant is None:
            question = f"whether the moments of inertia of the body `{body.name}` are constant in its axes"
            raise UndecidedError(question, body.span)
        if not constant:
            raise ProblemError(_refusal(body))


def _refusal(body: Body) -> Diagnostic:
    a, b, c = body.inertia
    what = "moments" if body.products == NO_PRODUCTS else "tensor"
    does = "do" if what == "moments" else "does"
    message = (
        f"the body `{body.name}` turns relative to its axes, "
        f"and its {what} of inertia about them {does} not stay constant"
    )
    equal = what == "moments" and (a in (b, c) or b == c)
    help_ = (
        "two moments are equal: it may turn relative to the axes about the third axis only; check `angular_velocity`"
        if equal
        else "give axes that are fixed in the body, so that `angular_velocity` is theirs, or two equal moments, "
        "written alike, where the body spins about the third axis"
    )
    return Diagnostic("varying-inertia", message, body.span, help=help_)


def _vanish(parts: tuple[sp.Expr, ...], configuration: Configuration) -> bool | None:
    if not parts:
        return True
    symbols = symbols_of(parts)

    def vanish(moving: Point) -> bool:
        return all(moving.is_zero(e) for e in parts)

    return agreed(configuration.surface, vanish, parts, prepare=lambda p: random_state(p, configuration, symbols))


@record
class Check:
    """A check: the statement, whether it holds (None: undecided), and how that was found.

    `choice` is the choice of coordinates concerned; empty for the file's own.
    """

    name: str
    passed: bool | None
    how: str
    choice: str = ""


def certainty(surface: Surface) -> str:
    """How certain a result on a surface is: in a prime field, or at points that only Newton's iteration finds."""
    return "exact" if surface.exact else "to sixty digits"


def at_random_states(configuration: Configuration) -> str:
    """How a check is made at admissible states of a configuration."""
    return f"{certainty(configuration.states)}, at random states"


def multiplier_system(
    configuration: Configuration, left: tuple[sp.Expr, ...], multipliers: tuple[sp.Symbol, ...]
) -> System:
    """The equations left_k = Σ λ_j a_jk of a configuration, shape (n,), with the multipliers as unknowns."""
    equations = []
    for k, expression in enumerate(left):
        reactions = (m * row.coefficients[k] for m, row in zip(multipliers, configuration.rows, strict=True))
        equations.append(expression - sp.Add(*reactions))
    return System(configuration, tuple(equations), multipliers)


def check_integrability(classification: Classification) -> list[Check]:
    """Frobenius' form, expanded symbolically, against the verdict on the constraint, which is found with jets."""
    checks = []
    for c in classification.constraints:
        tested = c.pfaffian and c.row.finite is None and not c.restricted  # there Frobenius' condition is not enough
        if tested and not c.exactness.exact and c.integrable is not None:
            name = f"Frobenius' condition {'holds' if c.integrable else 'fails'} for {_called(c.row)}"
            if any(map(is_many_waves, c.row.form)):  # its components would fill pages
                from lagrange.algebra.forms.derived_flag import derived_flag

                system = classification.constrained
                finite = system.without(classification.redundant).geometric
                flag = derived_flag([c.row.form], system.slots, [r.finite for r in finite if r.finite is not None])
                alone = None if flag.integrable_rank is None else flag.integrable_rank > len(finite)
                passed = None if alone is None else alone == c.integrable
                checks.append(Check(name, passed, "exact: by the derived system of this form alone"))
                continue
            verdicts = [k.nonzero for k in c.frobenius]
            nonzero = any_holds(verdicts)
            passed = None if nonzero is None else nonzero != c.integrable
            checks.append(Check(name, passed, "exact: by its components and by the derived system"))
    return checks


def _called(row: Row) -> str:
    """`the rear-wheels constraint`."""
    return f"the {row.name.replace('_', '-').replace('.', ' ')} constraint"


def check_finite_forms(classification: Classification) -> list[Check]:
    """Factors and finite relations, substituted into the forms.

    A factor for the geometric constraints only is tried there, any other everywhere.
    """
    checks = []
    system = classification.constrained
    slots, surface = system.slots, system.surface
    variables = (*slots.coordinates, t)
    geometric = system.without(classification.redundant).geometric
    for c in classification.constraints:
        if c.row.finite is not None:
            continue
        coefficients = (*c.row.coefficients, c.row.drift)
        name = _called(c.row)
        restricted = c.finite_form is not None and c.finite_form.restriction is not None
        rows, place = (geometric, surface) if restricted else ([], Surface())
        where = ", where the geometric constraints hold" if restricted else ""
        if c.finite_form is not None:
            multiplied = [c.finite_form.factor * a for a in coefficients]
            passed = _vanishes_beside(exterior_derivative(multiplied, variables, slots), rows, place)
            how = f"{certainty(place)}: its exterior derivative is 0{where}"
            checks.append(Check(f"the factor makes the form of {name} exact", passed, how))
        if c.integral is not None:
            gradient = one_form([differentiated(c.integral, v, slots) for v in variables])
            proportional = _vanishes_beside(wedge(gradient, one_form(coefficients)), rows, place)
            constant = _vanishes_beside(gradient, rows, place)
            passed = None if None in (proportional, constant) else proportional and not constant
            how = f"{certainty(place)}: dF ∧ ω = 0{where}"
            checks.append(
                Check(f"the finite relation has a differential proportional to the form of {name}", passed, how)
            )
    return checks


def _vanishes_beside(form: ExteriorForm, rows: Sequence[Row], surface: Surface) -> bool | None:
    """Whether a form is 0 on the surface, for differentials along it: form ∧ df_1 ∧ ... = 0 there."""
    for row in rows:
        form = wedge(form, one_form((*row.coefficients, row.drift)))
    verdicts = [surface.is_zero(a) for a in form.values()]
    return all_hold(verdicts)


def check_hidden(classification: Classification, elimination: Elimination, configuration: Configuration) -> list[Check]:
    """The hidden relations, found at random points, against the virtual displacements, solved symbolically."""
    relations = classification.hidden.found
    if not relations:
        return []
    columns = displacement_basis(elimination, len(configuration.slots.coordinates))
    verdicts = [
        configuration.surface.is_zero(sp.Add(*(a * x for a, x in zip(r.differential, column, strict=False))))
        for r in relations
        for column in columns
    ]
    passed = all_hold(verdicts)
    how = f"{certainty(configuration.surface)}: their differentials at the solved displacements"
    return [Check("the hidden relations hold in every virtual displacement", passed, how)]


def check_reality(configuration: Configuration) -> list[Check]:
    """Whether some real configuration satisfies the constraints: x² + y² = −1 has none.

    If they are not linear in the velocities, real velocities are required as well.
    """
    pfaffian = configuration.constrained.is_pfaffian
    if pfaffian and not configuration.finite_constraints:
        return []
    name = f"a real {'configuration' if pfaffian else 'state'} satisfies the constraints"
    if has_real_point(configuration.states):
        return [Check(name, True, "one was found, to sixty digits")]
    return [Check(name, None, "none was found")]


def check_displacements(
    configuration: Configuration, elimination: Elimination, transport_rates: Sequence[sp.Expr] = ()
) -> list[Check]:
    """The solved virtual displacements, and the rates (n,) imposed by moving constraints, in A and a_t."""
    if not configuration.rows or not elimination.is_closed:
        return []
    how = f"{certainty(configuration.states)}: the solved displacements substituted into the constraints"
    passed = _displacements_hold(configuration, elimination)
    checks = [Check("the virtual displacements satisfy the constraints", passed, how, configuration.name)]
    if any(transport_rates):
        rule = dict(zip(configuration.slots.velocities, transport_rates, strict=True))
        verdicts = [
            configuration.surface.is_zero(row.velocity_form(configuration.slots).xreplace(rule))
            for row in configuration.rows
        ]
        passed = all_hold(verdicts)
        how = f"{certainty(configuration.surface)}: substituted into the constraints"
        checks.append(
            Check("the displacement imposed by the moving constraints satisfies them", passed, how, configuration.name)
        )
    return checks


def check_motion(
    motion: EquationsOfMotion, reactions: Mapping[str, sp.Symbol], method: Method = Method.DALEMBERT
) -> list[Check]:
    """The checks of one set of equations of motion; `reactions` are the multipliers of the constraints, by name.

    method  by which they were derived: the other one is the check
    """
    configuration = motion.configuration
    multipliers = tuple(reactions[row.name] for row in configuration.rows)
    name = configuration.name
    other = "Lagrange's equations give" if method is Method.DALEMBERT else "d'Alembert's principle gives"
    if configuration.is_outright:
        other = "the derivatives of L along a curve give"
    how = at_random_states(configuration)
    checks = [Check(f"{other} the same motion", _agrees_with_other(motion, multipliers, method), how, name)]
    if not configuration.is_outright and _reactions_have_no_power(configuration):
        how = f"{certainty(configuration.states)}: dT/dt along the motion against the power of the forces"
        checks.append(
            Check(
                "the rate of change of the kinetic energy is the power of the forces",
                _energy_rate_holds(motion),
                how,
                name,
            )
        )
    return checks


def check_workless(works: Sequence[WorkOfReaction], configuration: Configuration) -> list[Check]:
    """The virtual work of the reactions of a configuration, after substituting the dependent displacements."""
    if not works:
        return []
    verdicts = [w.vanishes for w in works]
    passed = all_hold(verdicts)
    how = f"{certainty(configuration.states)}: where the constraints hold"
    return [Check("the reactions do no virtual work", passed, how)]


def check_reactions(
    original: Configuration,
    multipliers: tuple[sp.Symbol, ...],
    reactions: Reactions | None,
    method: Method = Method.DALEMBERT,
) -> list[Check]:
    """Reactions and accelerations, substituted into the equations with multipliers of the other method.

    original     the system in the file's coordinates, friction included
    multipliers  of its constraints
    method       by which the reactions were derived
    """
    claims = [] if reactions is None else _claims(reactions)
    if reactions is None or not claims:
        return []
    configuration = reactions.configuration
    system = multiplier_system(original, _left_by_other(original, method), multipliers)
    rule = {s: e for s, e in configuration.substitution.items() if not str(s).endswith("''")}
    known = [e.xreplace(rule) for e in (*system.equations, *system.accelerated_constraints)]
    unknowns = (*original.slots.accelerations, *multipliers)

    passed = follow(configuration, claims, known, unknowns)
    equations = "Lagrange's equations" if method is Method.DALEMBERT else "the equations of d'Alembert's principle"
    if configuration.is_outright:
        equations = "the equations from the derivatives of L along a curve"
    what = (
        f"reactions satisfy {equations} with multipliers"
        if multipliers
        else f"solved accelerations satisfy {equations}"
    )
    name = f"the {what}"
    return [Check(name, passed, at_random_states(configuration), configuration.name)]


def _claims(reactions: Reactions) -> list[sp.Expr]:
    """The expressions claimed to be zero: λ − value, q'' − value."""
    claims = [symbol - value for symbol, value in reactions.values.items()]
    for c in reactions.combinations:
        if c.value is not None:
            claims.append(sp.Add(*(factor * symbol for factor, symbol in c.terms), -c.value))
    return claims


def _left_by_other(configuration: Configuration, method: Method) -> tuple[sp.Expr, ...]:
    """The left sides of D_k = Σ λ_j a_jk, shape (n,), by the method that was not used."""
    if method is Method.DALEMBERT:
        return lagrange_equations(configuration).left
    return tuple(d.to_sympy() for d in dalembert(configuration).coefficients)


def _agrees_with_other(motion: EquationsOfMotion, multipliers: tuple[sp.Symbol, ...], method: Method) -> bool | None:
    configuration = motion.configuration
    system = multiplier_system(configuration, _left_by_other(configuration, method), multipliers)
    result = compare([e.expression for e in motion.final], system)
    return None if result is None else result.agree


def _displacements_hold(configuration: Configuration, elimination: Elimination) -> bool | None:
    """Whether A δq is zero after substituting the dependent δq, for all values of the independent ones."""
    slots = configuration.slots
    solved = dict(elimination.solved(slots))
    left = [virtual_displacement(row, slots).xreplace(solved) for row in configuration.rows]
    verdicts = [configuration.states.is_zero(e) for e in left]
    return all_hold(verdicts)


def displacement_basis(elimination: Elimination, size: int) -> list[list[sp.Expr]]:
    """One virtual displacement for each independent δq, shape (n,) each."""
    basis = []
    for column, k in enumerate(elimination.independent):
        displacement = [sp.S.Zero] * size
        displacement[k] = sp.S.One
        for d, row in zip(elimination.dependent, elimination.solution, strict=True):
            displacement[d] = row[column]
        basis.append(displacement)
    return basis


def _reactions_have_no_power(configuration: Configuration) -> bool:
    """Whether reactions have no power: a_t = 0 where the constraints hold, and no position contains t."""
    slots = configuration.slots
    fixed = all(row.drift == 0 or _no_drift(row, configuration) for row in configuration.rows)
    moved = (p.position.frozen_derivative(slots) for p in configuration.points)
    turned = (r.virtual(slots.velocities) - r.angular_velocity for r in configuration.rotations)
    return fixed and all(v.is_zero for v in moved) and all(sp.expand(c) == 0 for w in turned for c in w.components)


def _no_drift(row: Row, configuration: Configuration) -> bool:
    """Whether a_t is zero where a constraint that is not Pfaffian holds: x'² + y'² − z'² has a_t = −φ."""
    return row.nonlinear is not None and configuration.states.is_zero(row.drift) is True


def _energy_rate_holds(motion: EquationsOfMotion) -> bool | None:
    """dT/dt = Σ F·v + Σ M·ω − Σ (∂V/∂q) q' − Σ c d'², with the accelerations from the equations of motion."""
    configuration = motion.configuration
    slots = configuration.slots
    rate = slots.time_derivative(kinetic_energy(configuration))
    power = applied_power(configuration) - sp.Add(
        *(partial(configuration.potential, q) * v for q, v in zip(slots.coordinates, slots.velocities, strict=True))
    )
    others = given_forces(configuration)
    power += sp.Add(*(q * v for q, v in zip(others, slots.velocities, strict=False)))
    system = System(configuration, motion.expressions)
    expressions = (rate, power, *system.equations, *system.accelerated_constraints)

    def holds(moving: Point) -> bool:
        accelerated = with_accelerations(moving, system)
        return accelerated is not None and accelerated.is_zero(rate - power)

    return agreed_in_motion(configuration, holds, expressions)


def with_accelerations(point: Point, system: System) -> Point | None:
    """The state with the accelerations from a system; None if the system does not determine them."""
    unknowns = system.configuration.slots.accelerations
    rows = affine_rows(point, (*system.equations, *system.accelerated_constraints), unknowns)
    accelerations = point.solution([r[:-1] for r in rows], [point.arithmetic.reduce(-r[-1]) for r in rows])
    return None if accelerations is None else point.with_values(dict(zip(unknowns, accelerations, strict=True)))


def check_substitutions(choices: Sequence[GeneralizedCoordinates]) -> list[Check]:
    """The constraints that `generalized_coordinates` has verified to hold, as checks."""
    checks = []
    for c in choices:
        if c.satisfied:
            listed = ", ".join(name.replace("_", " ") for name in c.satisfied)
            how = "exact, at random states"
            checks.append(Check(f"satisfied identically: {listed}", True, how, c.configuration.name))
    return checks


def check_choice(original: EquationsOfMotion, motion: EquationsOfMotion) -> Check:
    """Whether the equations in a choice of coordinates describe the same motion as those of the file."""
    rewritten = [motion.configuration.rewritten(e) for e in original.expressions]
    result = compare(rewritten, System(motion.configuration, tuple(e.expression for e in motion.final)))
    passed = None if result is None else result.agree
    return Check(
        "the equations in the file's coordinates describe the same motion",
        passed,
        at_random_states(motion.configuration),
        motion.configuration.name,
    )
