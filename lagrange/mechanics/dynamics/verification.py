"""The checks of a solution, each by a second route.

    finite relations            dF ∧ ω = 0, by exterior algebra in the coordinates of the file
    Lagrange's equations        from T, V and Q: no step in common with d'Alembert's principle but the positions;
                                d'Alembert's principle, where Lagrange's equations are the method
    virtual displacements       the solved δq put back into A δq = 0
    energy                      dT/dt with the accelerations that the equations give, against the power of the forces
    coordinates                 the equations of the file's coordinates, rewritten in those of a choice
    reactions                   their virtual work; their values put back into the equations of the other method

All are exact: expressions are evaluated at random states of a random prime field, and solution sets are compared, never
printed forms. A check that cannot be decided says so and does not count as held.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from lagrange.algebra.exact.exact import Point, Surface, has_real_point
from lagrange.algebra.forms.exterior import Form, exterior_derivative, one_form, wedge
from lagrange.algebra.forms.potentials import differentiated
from lagrange.core.records import record
from lagrange.core.symbols import Slots, t
from lagrange.mechanics.constraints.classification import Classification
from lagrange.mechanics.constraints.displacements import Elimination, virtual_displacement
from lagrange.mechanics.constraints.kinematics import Configuration, Row, is_pfaffian
from lagrange.mechanics.dynamics.comparison import System, affine_rows, agreed_in_motion, compare, follow
from lagrange.mechanics.dynamics.equations import EquationsOfMotion
from lagrange.mechanics.dynamics.lagrangian import applied_power, kinetic_energy, lagrange_equations
from lagrange.mechanics.dynamics.motion import Method
from lagrange.mechanics.dynamics.principle import dalembert
from lagrange.mechanics.dynamics.reactions import Reactions
from lagrange.mechanics.dynamics.workless import WorkOfReaction


@record
class Check:
    """A check: what holds, whether it did (None: undecided), and how that was found.

    `choice` is the choice of coordinates that it is about; empty for the file's own.
    """

    name: str
    passed: bool | None
    how: str
    choice: str = ""


def certainty(surface: Surface) -> str:
    """How sure is what was found on a surface: in a prime field, or at points that only Newton's iteration finds."""
    return "exact" if surface.exact else "to sixty digits"


def at_random_states(configuration: Configuration) -> str:
    """How a check is made at states that the constraints of a configuration admit."""
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
    """Frobenius' form, worked out in symbols, against the verdict on the constraint, which is found with jets."""
    found = []
    for c in classification.constraints:
        if c.pfaffian and c.row.finite is None and not c.exactness.exact and c.integrable is not None:
            verdicts = [k.nonzero for k in c.frobenius]
            vanishes = False if True in verdicts else None if None in verdicts else True
            passed = None if vanishes is None else vanishes == c.integrable
            name = f"Frobenius' condition {'holds' if c.integrable else 'fails'} for {c.row.name.replace('_', ' ')}"
            found.append(Check(name, passed, "exact: by its components and by the derived system"))
    return found


def check_finite_forms(classification: Classification, slots: Slots, surface: Surface) -> list[Check]:
    """Factors and finite relations that were found, put back into the forms.

    What was found on the geometric constraints only is tried there; the rest everywhere.
    """
    found = []
    variables = (*slots.coordinates, t)
    geometric = [r for r in classification.rows if r.finite is not None and r.name not in classification.redundant]
    for c in classification.constraints:
        if c.row.finite is not None:
            continue
        name, coefficients = c.row.name.replace("_", " "), (*c.row.coefficients, c.row.drift)
        restricted = c.finite_form is not None and c.finite_form.restriction is not None
        around, there = (geometric, surface) if restricted else ([], Surface())
        where = ", where the geometric constraints hold" if restricted else ""
        if c.finite_form is not None:
            multiplied = [c.finite_form.factor * a for a in coefficients]
            passed = _vanishes_beside(exterior_derivative(multiplied, variables, slots), around, there)
            how = f"{certainty(there)}: its exterior derivative is 0{where}"
            found.append(Check(f"the factor makes {name} exact", passed, how))
        if c.integral is not None:
            gradient = one_form([differentiated(c.integral, v, slots) for v in variables])
            proportional = _vanishes_beside(wedge(gradient, one_form(coefficients)), around, there)
            constant = _vanishes_beside(gradient, around, there)
            passed = None if None in (proportional, constant) else proportional and not constant
            how = f"{certainty(there)}: dF ∧ ω = 0{where}"
            found.append(Check(f"the finite relation has a differential proportional to {name}", passed, how))
    return found


def _vanishes_beside(form: Form, around: Sequence[Row], surface: Surface) -> bool | None:
    """Whether a form is 0 on the surface, among differentials along it: form ∧ df_1 ∧ ... = 0 there."""
    for row in around:
        form = wedge(form, one_form((*row.coefficients, row.drift)))
    verdicts = [surface.is_zero(a) for a in form.values()]
    return False if False in verdicts else None if None in verdicts else True


def check_hidden(classification: Classification, elimination: Elimination, configuration: Configuration) -> list[Check]:
    """The hidden relations, found at random points, against the virtual displacements, solved in symbols."""
    found = classification.hidden.found
    if not found:
        return []
    columns = displacement_basis(elimination, len(configuration.slots.coordinates))
    verdicts = [
        configuration.surface.is_zero(sp.Add(*(a * x for a, x in zip(r.differential, column, strict=False))))
        for r in found
        for column in columns
    ]
    passed = False if False in verdicts else None if None in verdicts else True
    how = f"{certainty(configuration.surface)}: their differentials in the solved displacements"
    return [Check("the hidden relations hold in every virtual displacement", passed, how)]


def check_reality(configuration: Configuration) -> list[Check]:
    """Whether some real configuration satisfies the constraints: x² + y² = −1 has none.

    Where they are not linear in the velocities, real velocities are asked for too.
    """
    pfaffian = is_pfaffian(configuration.rows)
    if pfaffian and not configuration.finite_constraints:
        return []
    name = f"a real {'configuration' if pfaffian else 'state'} satisfies the constraints"
    if has_real_point(configuration.states):
        return [Check(name, True, "one was found, to sixty digits")]
    return [Check(name, None, "none was found")]


def check_displacements(
    configuration: Configuration, elimination: Elimination, carried: Sequence[sp.Expr] = ()
) -> list[Check]:
    """The solved virtual displacements, and the rates at which moving constraints carry (n,), put into A and a_t."""
    if not configuration.rows:
        return []
    how = f"{certainty(configuration.states)}: the solved displacements put into the constraints"
    passed = _displacements_hold(configuration, elimination)
    found = [Check("the virtual displacements satisfy the constraints", passed, how, configuration.name)]
    if any(carried):
        rule = dict(zip(configuration.slots.velocities, carried, strict=True))
        verdicts = [
            configuration.surface.is_zero(row.velocity_form(configuration.slots).xreplace(rule))
            for row in configuration.rows
        ]
        passed = False if False in verdicts else None if None in verdicts else True
        how = f"{certainty(configuration.surface)}: put into the constraints"
        found.append(
            Check("the displacement that the moving constraints force satisfies them", passed, how, configuration.name)
        )
    return found


def check_motion(
    motion: EquationsOfMotion, reactions: Mapping[str, sp.Symbol], method: Method = Method.DALEMBERT
) -> list[Check]:
    """The checks of one set of equations of motion; `reactions` are the multipliers of the constraints, by name.

    method  by what they were derived: the other one is the check
    """
    configuration = motion.configuration
    multipliers = tuple(reactions[row.name] for row in configuration.rows)
    name = configuration.name
    other = "Lagrange's equations give" if method is Method.DALEMBERT else "d'Alembert's principle gives"
    how = at_random_states(configuration)
    found = [Check(f"{other} the same motion", _agrees_with_other(motion, multipliers, method), how, name)]
    if _conserves_reactions(configuration):
        how = f"{certainty(configuration.states)}: dT/dt along the motion against the power of the forces"
        found.append(Check("the rate of the energy is the power of the forces", _energy_rate_holds(motion), how, name))
    return found


def check_workless(works: Sequence[WorkOfReaction], configuration: Configuration) -> list[Check]:
    """The virtual work of the reactions of a configuration, the dependent displacements put in."""
    if not works:
        return []
    verdicts = [w.vanishes for w in works]
    passed = False if False in verdicts else None if None in verdicts else True
    how = f"{certainty(configuration.states)}: where the constraints hold"
    return [Check("the reactions do no virtual work", passed, how)]


def check_reactions(
    original: Configuration,
    multipliers: tuple[sp.Symbol, ...],
    found: Reactions | None,
    method: Method = Method.DALEMBERT,
) -> list[Check]:
    """Reactions and accelerations, put back into the equations with multipliers that they were not derived from.

    original     the system in the file's coordinates, friction included
    multipliers  of its constraints
    method       by what the reactions were derived
    """
    claims = [] if found is None else _claims(found)
    if found is None or not claims:
        return []
    configuration = found.configuration
    system = multiplier_system(original, _left_by_other(original, method), multipliers)
    rule = {s: e for s, e in configuration.substitution.items() if not str(s).endswith("''")}
    known = [e.xreplace(rule) for e in (*system.equations, *system.accelerated_constraints)]
    unknowns = (*original.slots.accelerations, *multipliers)

    passed = follow(configuration, claims, known, unknowns)
    equations = "Lagrange's equations" if method is Method.DALEMBERT else "the equations of d'Alembert's principle"
    what = (
        f"reactions satisfy {equations} with multipliers"
        if multipliers
        else (f"accelerations, solved for, satisfy {equations}")
    )
    name = f"the {what}"
    return [Check(name, passed, at_random_states(configuration), configuration.name)]


def _claims(found: Reactions) -> list[sp.Expr]:
    """Each of these is said to be zero: λ − value, q'' − value."""
    claims = [symbol - value for symbol, value in found.values.items()]
    for c in found.combinations:
        if c.value is not None:
            claims.append(sp.Add(*(factor * symbol for factor, symbol in c.terms), -c.value))
    return claims


def _left_by_other(configuration: Configuration, method: Method) -> tuple[sp.Expr, ...]:
    """What equals Σ λ_j a_jk, shape (n,), by the method that was not used."""
    if method is Method.DALEMBERT:
        return lagrange_equations(configuration).left
    return tuple(d.to_sympy() for d in dalembert(configuration).coefficients)


def _agrees_with_other(motion: EquationsOfMotion, multipliers: tuple[sp.Symbol, ...], method: Method) -> bool | None:
    configuration = motion.configuration
    system = multiplier_system(configuration, _left_by_other(configuration, method), multipliers)
    result = compare([e.expression for e in motion.final], system)
    return None if result is None else result.agree


def _displacements_hold(configuration: Configuration, elimination: Elimination) -> bool | None:
    """Whether A δq is zero with the dependent δq put in, whatever the independent ones are."""
    slots = configuration.slots
    solved = dict(elimination.solved(slots))
    moved = [virtual_displacement(row, slots).xreplace(solved) for row in configuration.rows]
    verdicts = [configuration.states.is_zero(e) for e in moved]
    return False if False in verdicts else None if None in verdicts else True


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


def _conserves_reactions(configuration: Configuration) -> bool:
    """Whether reactions have no power: no constraint has an a_t where it holds, and no position contains t."""
    slots = configuration.slots
    still = all(row.drift == 0 or _no_drift(row, configuration) for row in configuration.rows)
    moved = (p.position.frozen_derivative(slots) for p in configuration.points)
    turned = (r.virtual(slots.velocities) - r.angular_velocity for r in configuration.rotations)
    return still and all(v.is_zero for v in moved) and all(sp.expand(c) == 0 for w in turned for c in w.components)


def _no_drift(row: Row, configuration: Configuration) -> bool:
    """Whether a_t is zero where a constraint that is not Pfaffian holds: x'² + y'² − z'² has a_t = −φ."""
    return row.nonlinear is not None and configuration.states.is_zero(row.drift) is True


def _contains_time(parts: tuple[sp.Expr, ...], slots: Slots) -> bool:
    return any(s == t or s in slots.prescribed for c in parts for s in c.free_symbols)


def _energy_rate_holds(motion: EquationsOfMotion) -> bool | None:
    """dT/dt = Σ F·v + Σ M·ω − Σ (∂V/∂q) q' − Σ c d'², with the accelerations that the equations of motion give."""
    configuration = motion.configuration
    slots = configuration.slots
    rate = slots.time_derivative(kinetic_energy(configuration))
    power = applied_power(configuration) - sp.Add(
        *(configuration.potential.diff(q) * v for q, v in zip(slots.coordinates, slots.velocities, strict=True))
    )
    system = System(configuration, motion.expressions)
    expressions = (rate, power, *system.equations, *system.accelerated_constraints)

    def holds(moving: Point) -> bool:
        accelerated = with_accelerations(moving, system)
        return accelerated is not None and accelerated.is_zero(rate - power)

    return agreed_in_motion(configuration, holds, expressions)


def with_accelerations(point: Point, system: System) -> Point | None:
    """The state with the accelerations that a system gives it; None where it gives none."""
    unknowns = system.configuration.slots.accelerations
    rows = affine_rows(point, (*system.equations, *system.accelerated_constraints), unknowns)
    found = point.solution([r[:-1] for r in rows], [point.arithmetic.reduce(-r[-1]) for r in rows])
    return None if found is None else point.with_values(dict(zip(unknowns, found, strict=True)))


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
