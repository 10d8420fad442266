"""Steady motions: cyclic coordinates change at constant rates, the others are at rest.

A coordinate is cyclic here if it does not occur in the equations of motion, and no force acts along it once the others
rest. With q_c' constant, and q_o' = 0 for the others, the equations of motion become conditions between q_o and q_c':
cos θ = g/(l φ'²) for the conical pendulum. They are solved like those of equilibrium, the q_c' being parameters.

About a steady motion q_o = q_0 + ξ, q_c' = const + η', and to first order, with M, D, K as for small oscillations,

    M_co ξ'' + M_cc η'' + D_co ξ' = 0         which integrates to   M_co ξ' + M_cc η' + D_co ξ = const ,

the change of the momenta p_c. A change of the momenta leads to a neighbouring steady motion; with the momenta as they
were, the constant is zero, η' drops out, and what is left is an equation of small oscillations for ξ alone, that of
Routh's function:

    M̃ = M_oo − M_oc M_cc⁻¹ M_co ,   D̃ = D_oo − M_oc M_cc⁻¹ D_co − D_oc M_cc⁻¹ M_co ,   K̃ = K_oo − D_oc M_cc⁻¹ D_co .

With constraints on the velocities the same is done with the independent coordinates (`reduced_form`). The momenta are
then not constant, but their equations integrate to first order in the same way wherever K_co = 0 and D_cc = 0 .

Where the conditions have no closed solution for the coordinates, or contain several constant rates, they are solved for
one of these: a disc that rolls in a circle, or a top that precesses, has ψ' = F(θ, φ'). The case that its denominator
excludes, φ' = 0, is a separate family: the disc that rolls straight on. So are positions at which the rate drops out of
the condition and is arbitrary: a sleeping top in gimbals. A condition that contains no coordinate, such as a φ'² = g in
a paraboloid, gives one rate for all positions.

Reference: Routh, Advanced Rigid Dynamics, ch. 3; Whittaker, §§ 83, 84; Neimark and Fufaev, ch. VI.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import sympy as sp

from lagrange.algebra.closed_forms.eigenmodes import Matrix
from lagrange.algebra.closed_forms.signs import more_than_zero
from lagrange.algebra.closed_forms.single_equation import Relation
from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.algebra.exact.expression_graph import DivisionByZeroError, UnsupportedError
from lagrange.algebra.exact.prime_field import InadmissibleError
from lagrange.algebra.exact.real_points import RealPoint
from lagrange.algebra.exact.zero_test import kept_surface
from lagrange.algebra.fourier.ring import FourierRing
from lagrange.algebra.fourier.textbook_form import Textbook, textbook_form
from lagrange.core.diagnostics import Diagnostic, NotCoveredError, ProblemError
from lagrange.core.expression_size import count_operations
from lagrange.core.records import all_hold, record
from lagrange.core.symbols import partial, sign_between, t, variation
from lagrange.mechanics.constraints.displacements import Elimination
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.checks import Check
from lagrange.mechanics.dynamics.equations import EquationsOfMotion
from lagrange.mechanics.dynamics.lagrangian import lagrange_equations
from lagrange.mechanics.dynamics.matrix_form import MatrixForm, matrix_form
from lagrange.mechanics.dynamics.reactions import over_one_denominator
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium, VirtualWork, equilibrium
from lagrange.mechanics.equilibrium.limits import (
    MOST_DRAWS,
    MOST_EQUILIBRIA,
    MOST_OSCILLATING,
    SAMPLES_PER_SIDE,
)
from lagrange.mechanics.equilibrium.linearization import (
    Linearization,
    SmallOscillations,
    decay_letter,
    displacement_names,
    letters_of,
    oscillations,
)
from lagrange.mechanics.equilibrium.relative_equilibrium import branches_at_rest, is_time
from lagrange.mechanics.equilibrium.sampled_checks import HOW, Samples, determinant_in_numbers, exists
from lagrange.mechanics.equilibrium.stability import on_branch
from lagrange.mechanics.momenta.constant_rates import (
    condition_for_rate,
    determines,
    have_several,
    rate_at_any_position,
    rate_at_position,
)
from lagrange.mechanics.momenta.reduced_form import independent_first, only, rates_of_dependent, reduced_form

ZERO = sp.S.Zero


@record
class Family:
    """Steady motions in which some of the constant rates are given.

    rates  of cyclic coordinates: 0, or in terms of the other rates and of the coordinates that rest; a root is meant
           with either sign
    about  the conditions, as an equilibrium of the other coordinates, and the linear equations of these at constant
           momenta of the cyclic ones
    """

    rates: Mapping[sp.Symbol, sp.Expr]
    about: Linearization

    def relations(self, b: Branch) -> tuple[Relation, ...]:
        """What determines one of its branches."""
        return (*b.equations, *(_without_root(v, value) for v, value in _rates_on(b, self.rates).items()))


@record
class SteadyMotions:
    """The steady motions in one set of coordinates.

    motion      the equations of motion
    form        M and f of the independent coordinates
    cyclic      shape (c,): the coordinates whose velocities are constant
    general     the conditions, as an equilibrium of the other coordinates, whatever the constant rates
    families    the steady motions
    complete    whether these are all
    """

    motion: EquationsOfMotion
    form: MatrixForm
    cyclic: tuple[sp.Symbol, ...]
    general: Equilibrium
    families: tuple[Family, ...]
    complete: bool


def steady_motions(motion: EquationsOfMotion, taken: frozenset[str], radius: sp.Symbol | None = None) -> SteadyMotions:
    """The steady motions of a system in free coordinates, or with constraints on velocities.

    taken   names that the letters of the linear equations must not use
    radius  a coordinate that is not negative: the radius of a frame

    Raises NotCoveredError if the coordinates are not free and `reduced_form` cannot help, or time occurs; ProblemError
    if no coordinate is cyclic.
    """
    form = _within_ranges(reduced_form(motion) if motion.configuration.rows else matrix_form(motion))
    configuration = form.configuration
    slots = configuration.slots
    symbols = {s for e in (*form.force, *(e for row in form.mass for e in row)) for s in e.free_symbols}
    if any(is_time(s, configuration) for s in symbols):
        raise NotCoveredError(
            "steady motions where the equations of motion contain time",
            cure="let coordinates turn with what is driven; `find: response` has the motion under a harmonic drive",
        )
    absent = [k for k, q in enumerate(slots.coordinates) if q not in symbols]
    cyclic = _free_to_turn(form, absent)
    if not cyclic:
        raise _none_cyclic(configuration, absent)
    others = [k for k in range(len(slots.coordinates)) if k not in cyclic]
    steady = {slots.velocities[k]: ZERO for k in others}
    forces = [form.force[k].xreplace(steady) for k in others]
    remaining = only(configuration, [slots.coordinates[k] for k in others])
    small = displacement_names(remaining.slots.coordinates, taken)
    letters = letters_of(taken)

    def resting(rates: Mapping[sp.Symbol, sp.Expr]) -> Equilibrium:
        return _without_poles(_conditions(remaining, [f.xreplace(dict(rates)) for f in forces]), form, rates)

    def family(rates: Mapping[sp.Symbol, sp.Expr], at_rest: Equilibrium) -> Family:
        branches, complete = branches_at_rest(at_rest)
        known: dict[Any, SmallOscillations | None] = {}
        at = tuple(
            _about(b, form, cyclic, at_rest, small, *letters, rates, known, radius) if n < MOST_EQUILIBRIA else None
            for n, b in enumerate(branches)
        )
        of_others = replace(motion, configuration=remaining)
        about = Linearization(
            of_others, at_rest, branches, complete, small, *letters, False, at,
            decay=decay_letter(taken), omitted=tuple(range(MOST_EQUILIBRIA, len(branches))),
        )  # fmt: skip
        return Family(rates, about)

    general = resting({})
    complete = branches_at_rest(general)[1]
    rates = [slots.velocities[k] for k in cyclic]
    conditions = [c.expression for c in general.conditions]
    condition, solved = condition_for_rate(conditions, rates, complete)
    if solved is not None and len(conditions) > 1 and any(b.left for b in resting(solved).branches):
        solved = None
    if solved is None or (complete and not have_several(conditions, rates)):
        alone = [rate for b in general.branches if (rate := rate_at_any_position(b, rates))]
        with_position = _only(general, lambda b: rate_at_any_position(b, rates) is None)
        families: tuple[Family, ...] = (
            *([family({}, with_position)] if with_position.branches or not alone else []),
            *(family(rate, resting(rate)) for rate in alone),
        )
        by_position = rate_at_position(conditions, rates, general, radius) if len(families) == 1 else None
        if by_position is not None:
            other = family(by_position, resting(by_position))
            families = (other,) if 2 * _length(other) < _length(families[0]) else families
    else:
        [(rate, value)] = solved.items()
        complete = complete or determines(condition, rate, general, radius)
        denominator = sp.fraction(sp.together(value))[1]
        whatever = _at_any_rate(general, partial(condition, rate))
        excluded: list[dict[sp.Symbol, sp.Expr]] = [{v: ZERO} for v in rates if v in denominator.free_symbols]
        known = [b.equations for b in whatever.branches]
        others_at = ((r, _only(resting(r), lambda b: b.equations not in known)) for r in excluded)
        families = (
            family(solved, resting(solved)),
            *([family({}, whatever)] if known else []),
            *(family(r, at_rest) for r, at_rest in others_at if at_rest.branches or not known),
        )
    turning = tuple(slots.coordinates[k] for k in cyclic)
    return SteadyMotions(motion, form, turning, general, families, complete)


def _free_to_turn(form: MatrixForm, absent: Sequence[int]) -> list[int]:
    """The largest set found of coordinates along which no force acts while only they move.

    Of a ball that rolls inside an upright cylinder, the force along the spin α about the normal is that of φ' β', and
    the weight acts along β: α is cyclic because β rests.
    """
    slots, states = form.configuration.slots, form.configuration.states

    def hold(turning: Sequence[int]) -> list[int]:
        resting = {v: ZERO for k, v in enumerate(slots.velocities) if k not in turning}
        return [k for k in turning if states.is_zero(form.force[k].xreplace(resting))]

    cyclic = hold(absent)
    if len(cyclic) == len(absent):
        return cyclic
    cyclic = hold(cyclic)
    for k in absent:
        if k not in cyclic and len(hold(wider := sorted([*cyclic, k]))) == len(wider):
            cyclic = wider
    return cyclic


def _none_cyclic(configuration: Configuration, absent: Sequence[int]) -> ProblemError:
    """Which coordinates were tried, why none is cyclic, and what can be asked instead."""
    names = [f"`{q.name}`" for q in configuration.slots.coordinates]
    reasons = []
    if occurring := [n for k, n in enumerate(names) if k not in absent]:
        reasons.append(f"the equations of motion contain {', '.join(occurring)}")
    if pushed := [names[k] for k in absent]:
        reasons.append(f"the equation of motion of {', '.join(pushed)} does not hold at constant velocities")
    turning = any(s == t for p in configuration.points for e in p.position.components for s in e.free_symbols)
    cures = [
        "`find: linearization` has equilibria relative to what turns, and oscillations about them"
        if turning
        else "`find: equilibrium` asks for rest, `find: linearization` for oscillations about it"
    ]
    if len(names) > 1:
        cures.append(
            "where a system can turn about an axis, the angle about it is cyclic: make that a coordinate, as in "
            "`frame: {type: polar, coordinates: [r, phi]}`"
        )
    where = f" of choice `{configuration.name}`" if configuration.name else ""
    message = f"a steady motion needs a cyclic coordinate, and none{where} is cyclic: {', and '.join(reasons)}"
    return ProblemError(Diagnostic("no-cyclic-coordinate", message, help="; ".join(cures)))


def _within_ranges(form: MatrixForm) -> MatrixForm:
    """M and f with the signs that the ranges of the coordinates give: sgn sin θ = 1 for arms at 0 < θ < 90°."""
    signs = _signs_in_ranges(form.configuration, form.force)
    return replace(form, force=tuple(textbook_form(f.xreplace(signs)) for f in form.force)) if signs else form


def _signs_in_ranges(configuration: Configuration, expressions: Sequence[sp.Expr]) -> dict[sp.Basic, sp.Basic]:
    """The signs and magnitudes of sin q and cos q that are known inside the range of a coordinate."""
    known: dict[sp.Basic, sp.Basic] = {}
    for f in {f for e in expressions for f in e.atoms(sp.sign, sp.Abs)}:
        inner = f.args[0]
        limits = configuration.ranges.get(inner.args[0]) if isinstance(inner, sp.sin | sp.cos) else None
        if limits is not None and limits.low.is_number and limits.high.is_number:
            sign = sign_between(inner.func, limits.low, limits.high, (True, True))
            if sign is not None:
                known[f] = sp.Integer(sign) * (inner if isinstance(f, sp.Abs) else 1)
    return known


def _length(family: Family) -> int:
    """How long the linear equations about the motions of a family are; one with cube roots counts twice."""
    equations = [e for s in family.about.originals for e in s.equations]
    return sum(count_operations(e) * (2 if _has_cube_root(e) else 1) for e in equations) or sys.maxsize


def _has_cube_root(e: sp.Expr) -> bool:
    return any(p.exp.is_Rational and p.exp.q > 2 for p in e.atoms(sp.Pow))


def on_one_side(conditions: Equilibrium) -> Iterator[tuple[sp.Expr, Equilibrium]]:
    """Conditions that contain sgn f, as where f > 0 and where f < 0; nothing if there is no such f, or several."""
    forces = conditions.independent_forces
    inside = {s.args[0] for e in forces for s in e.atoms(sp.sign)}
    if len(inside) != 1 or any(e.has(sp.Abs) for e in forces):
        return
    [f] = inside
    for sign in (1, -1):
        side = [e.xreplace({sp.sign(f): sp.Integer(sign)}) for e in forces]
        yield sign * f, _conditions(conditions.configuration, side)


def _rates_on(b: Branch, rates: Mapping[sp.Symbol, sp.Expr]) -> dict[sp.Symbol, sp.Expr]:
    """The given rates where a branch places some coordinates: φ'(r, θ) at θ = 0."""
    placed: dict[sp.Basic, sp.Basic] = {r.lhs: r.rhs for r in b.relations if r.lhs.is_Symbol}
    inside = {s for e in rates.values() for s in e.free_symbols}
    return {v: textbook_form(e.xreplace(placed)) if placed.keys() & inside else e for v, e in rates.items()}


def _without_root(v: sp.Symbol, value: sp.Expr) -> Relation:
    """φ'² = g/a for φ' = √(g/a), whose other sign turns the motion around."""
    is_root = any(p.exp == sp.S.Half for p in value.atoms(sp.Pow))
    return Relation(v**2, value**2) if is_root else Relation(v, value)


def _conditions(remaining: Configuration, forces: Sequence[sp.Expr]) -> Equilibrium:
    """The conditions of steady motion, solved as those of an equilibrium under `forces`."""
    ring = FourierRing()
    textbook = Textbook(ring)
    coordinates = remaining.slots.coordinates
    coefficients = tuple(ring.from_sympy(f) for f in forces)
    displacements = [ring.from_sympy(variation(q)) for q in coordinates]
    statement = ring.total(q * v for q, v in zip(coefficients, displacements, strict=True))
    work = VirtualWork(coefficients, tuple(map(textbook.form, coefficients)), textbook.form(statement), textbook)
    free = Elimination(tuple(range(len(coordinates))), (), (), (), (), ())
    return equilibrium(remaining, free, work=work)


def _without_poles(resting: Equilibrium, form: MatrixForm, rates: Mapping[sp.Symbol, sp.Expr]) -> Equilibrium:
    """The steady motions without positions where M is singular: there the coordinates fail, as an azimuth at a pole."""
    mass = sp.Matrix(form.mass).det(method="berkowitz").xreplace(dict(rates))

    def is_pole(b: Branch) -> bool:
        if _differs_from_zero(mass, b, resting):
            return False
        value = None if b.left or b.special else on_branch(b, mass, resting)
        return value is not None and kept_surface().is_zero(value) is True

    def failing(b: Branch) -> Branch:
        """A pole with the one relation that makes M singular, where one does: β = π/2, whatever α is."""
        single = (
            r for r in b.relations if r.lhs.is_Symbol and kept_surface().is_zero(mass.xreplace({r.lhs: r.rhs})) is True
        )
        r = next(single, None)
        return b if r is None else replace(b, relations=(r,))

    poles = tuple(b for b in resting.branches if is_pole(b))
    return replace(_only(resting, lambda b: b not in poles), poles=tuple(map(failing, poles)))


def _at_any_rate(general: Equilibrium, slope: sp.Expr) -> Equilibrium:
    """The solutions of a condition at which a rate has no influence on it: its slope vanishes there."""

    def holds(b: Branch) -> bool:
        value = None if b.left or b.special else on_branch(b, slope, general)
        return value is not None and kept_surface().is_zero(value) is True

    return _only(general, holds)


def _only(resting: Equilibrium, chosen: Callable[[Branch], bool]) -> Equilibrium:
    """The steady motions of some branches."""
    kept = [(b, i) for b, i in zip(resting.branches, resting.idle, strict=True) if chosen(b)]
    real = (b for b in resting.solution.branches if b not in resting.poles and chosen(b))
    solution = replace(resting.solution, branches=tuple(real))
    branches, idle = tuple(b for b, _ in kept), tuple(i for _, i in kept)
    return replace(resting, solution=solution, branches=branches, idle=idle)


def _differs_from_zero(e: sp.Expr, b: Branch, resting: Equilibrium) -> bool:
    """Whether an expression is found not to vanish at sampled points of a branch."""
    for point in _points(b, resting):
        try:
            return not point.is_zero(e)
        except (InadmissibleError, UnsupportedError, DivisionByZeroError):
            continue
    return False


def _about(
    b: Branch,
    form: MatrixForm,
    cyclic: Sequence[int],
    resting: Equilibrium,
    names: Sequence[sp.Symbol],
    omega: sp.Symbol,
    exponent: sp.Symbol,
    rates: Mapping[sp.Symbol, sp.Expr],
    known: dict[Any, SmallOscillations | None],
    radius: sp.Symbol | None,
) -> SmallOscillations | None:
    """The linear equations about the steady motions of one branch, at constant momenta.

    known  those of earlier branches, by their matrices and conditions: of a satellite that points in or out alike
    """
    if b.left or b.special or not names or len(names) > MOST_OSCILLATING:
        return None
    try:
        matrices = reduced_matrices(b, form, cyclic, resting, _rates_on(b, rates))
        if matrices is None:  # the fourth root of r² + l² is no letter, the root of a root is
            matrices = reduced_matrices(b, form, cyclic, resting, rates)
    except (DivisionByZeroError, ZeroDivisionError):
        return None
    if matrices is None:
        return None
    real = [x for v, e in _rates_on(b, rates).items() for x in _without_root(v, e).positive]
    real += [radius] if radius in resting.configuration.slots.coordinates else []
    b = replace(b, implied=(*b.implied, *map(more_than_zero, real)))
    size = len(names)
    shape = tuple(tuple(sp.Integer(i == j) for j in range(size)) for i in range(size))
    like = (matrices, b.conditions)
    if like not in known:
        known[like] = oscillations(tuple(range(size)), shape, matrices, b, resting, names, omega, exponent)
    return known[like]


def reduced_matrices(
    b: Branch, form: MatrixForm, cyclic: Sequence[int], resting: Equilibrium, rates: Mapping[sp.Symbol, sp.Expr]
) -> tuple[Matrix, Matrix, Matrix] | None:
    """M̃, D̃, K̃ on a branch; None if the momenta are not constant to first order, or there is no closed form."""
    slots = form.configuration.slots
    o, c = [k for k in range(len(slots.coordinates)) if k not in cyclic], list(cyclic)
    steady = {slots.velocities[k]: ZERO for k in o} | dict(rates)

    def matrix(rows: Sequence[Sequence[sp.Expr]]) -> sp.Matrix:
        return sp.Matrix([[e.xreplace(steady) for e in row] for row in rows])

    def on(e: sp.Expr) -> sp.Expr | None:
        value = on_branch(b, e, resting, in_parameters=True)
        return None if value is None or value.has(sp.zoo, sp.nan, sp.oo) else value

    mass = matrix(form.mass)
    damping = matrix([[-partial(f, v) for v in slots.velocities] for f in form.force])
    stiffness = matrix([[-partial(f, q) for q in slots.coordinates] for f in form.force])
    surface = kept_surface()
    for e in (*stiffness.extract(c, o), *damping.extract(c, c)):  # what changes the momenta
        value = on(e)
        if value is None or surface.is_zero(value) is not True:
            return None
    turned = mass.extract(c, c)
    size = on(turned.det(method="berkowitz"))
    if size is None or surface.is_zero(size) is not False:
        return None
    # The elimination comes before the values of the branch: with them the entries of M are long.
    inverse = (turned.adjugate() / turned.det(method="berkowitz")).applyfunc(sp.cancel)
    across, turning, back = inverse * mass.extract(c, o), inverse * damping.extract(c, o), damping.extract(o, c)
    reduced = (
        mass.extract(o, o) - mass.extract(o, c) * across,
        damping.extract(o, o) - mass.extract(o, c) * turning - back * across,
        stiffness.extract(o, o) - back * turning,
    )
    written = [[[on(e) for e in m.row(k)] for k in range(m.rows)] for m in reduced]
    if any(e is None for m in written for row in m for e in row):
        return None
    m, d, k = (tuple(tuple(e for e in row if e is not None) for row in rows) for rows in written)
    coordinates = {slots.coordinates[k] for k in o}
    if any(e.free_symbols & coordinates for rows in (m, d, k) for row in rows for e in row):
        plain = [[[over_one_denominator(e) for e in x.row(n)] for n in range(x.rows)] for x in reduced]
        lengths = [sum(count_operations(e) for rows in x for row in rows for e in row) for x in (plain, (m, d, k))]
        if lengths[0] < lengths[1]:  # sin θ stays either way: better with cos θ as it is, too
            m, d, k = (tuple(map(tuple, rows)) for rows in plain)
    return m, d, k


def check_steady(motions: SteadyMotions) -> list[Check]:
    """The steady motions against Lagrange's equations, and their linear equations by determinants, in numbers.

    At drawn parameters and a drawn p, det(K + p D + p² M) of all independent coordinates must be p^2c det M_cc times
    that of the reduced equations. Neither the equations of d'Alembert nor the elimination of the η are used.
    """
    slots = motions.form.configuration.slots
    left = _lagrange(motions.motion)
    left = [e.xreplace(_signs_in_ranges(motions.form.configuration, left)) for e in left]
    pairs = zip(slots.coordinates, slots.velocities, strict=True)
    resting = dict.fromkeys((v for q, v in pairs if q not in motions.cyclic), ZERO)
    uniform = dict.fromkeys(slots.accelerations, ZERO)
    steady = [e.xreplace(resting | uniform) for e in left]
    slopes = [  # what is zero in any case is omitted before differentiating, where it is not what is differentiated by
        [[partial(e, q) for q in slots.coordinates] for e in steady],
        [[partial(e, v).xreplace(resting) for v in slots.velocities] for e in (e.xreplace(uniform) for e in left)],
        [[partial(e, a).xreplace(uniform) for a in slots.accelerations] for e in (e.xreplace(resting) for e in left)],
    ]
    c = [slots.coordinates.index(q) for q in motions.cyclic]
    hold: list[bool | None] = []
    linear: list[bool | None] = []
    for family in motions.families:
        rates = dict(family.rates)
        tables = [[[e.xreplace(rates) for e in row] for row in rows] for rows in slopes]
        balance = [e.xreplace(rates) for e in steady]
        for b, s in zip(family.about.branches, family.about.at, strict=True):
            tried = len(hold), len(linear)
            for point in _points(b, family.about.equilibrium):
                try:
                    hold.append(all(point.is_zero(e) for e in balance))
                    if s is not None:
                        p = point.arithmetic.sample()
                        full = [point.matrix(t) for t in tables]
                        reduced = [point.matrix(m) for m in (s.system.stiffness, s.system.damping, s.system.mass)]
                        inner = determinant_in_numbers([[full[2][i][j] for j in c] for i in c])
                        product = p ** (2 * len(c)) * inner * determinant_in_numbers(_pencil(reduced, p))
                        total = determinant_in_numbers(_pencil(full, p))
                        linear.append(point.arithmetic.vanishes((total - product) / (abs(total) + abs(product))))
                except (InadmissibleError, UnsupportedError, DivisionByZeroError):
                    continue
            # Other motions do not stand in for one at which nothing could be tried.
            silent = b.special or b.may_be_empty
            hold += [None] if len(hold) == tried[0] and not silent else []
            linear += [None] if len(linear) == tried[1] and s is not None and not silent else []
    statements = [
        ("the steady motions satisfy Lagrange's equations", hold),
        ("the linear equations about them have the exponents of Lagrange's equations", linear),
    ]
    return [Check(name, all_hold(v), HOW, motions.motion.configuration.name) for name, v in statements if v]


def _lagrange(motion: EquationsOfMotion) -> list[sp.Expr]:
    """Lagrange's equations of the independent displacements, L_I + Bᵀ L_D, each zero, in independent velocities."""
    configuration = motion.configuration
    left = lagrange_equations(configuration).left
    if not configuration.rows:
        return list(left)
    solved = independent_first(motion)
    rates = rates_of_dependent(solved, configuration.slots)
    combined = (
        left[k] + sp.Add(*(row[n] * left[d] for d, row in zip(solved.dependent, solved.solution, strict=True)))
        for n, k in enumerate(solved.independent)
    )
    return [e.xreplace(rates) for e in combined]


def _points(b: Branch, resting: Equilibrium) -> Iterator[RealPoint]:
    """Points at which a branch exists, with drawn parameters."""
    if b.special:
        return
    for points in Samples(resting).series(b):
        used = 0
        for number, point in enumerate(points):
            try:
                usable = exists(b, point)
            except (InadmissibleError, UnsupportedError, DivisionByZeroError):
                continue
            if usable:
                used += 1
                yield point
            if used == SAMPLES_PER_SIDE or (used and number >= MOST_DRAWS):
                break


def _pencil(matrices: Sequence[Sequence[Sequence[Any]]], p: Any) -> list[list[Any]]:
    """K + p D + p² M in numbers."""
    k, d, m = matrices
    size = range(len(k))
    return [[k[i][j] + p * d[i][j] + p**2 * m[i][j] for j in size] for i in size]
