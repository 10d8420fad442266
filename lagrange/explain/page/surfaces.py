"""A particle on a surface f = c of any form: everything in vectors, with the gradient ∇f.

Newton's law is m r'' = F + R, and what a smooth surface exerts is normal to it: R = λ ∇f. Virtual displacements are
those with ∇f·δr = 0, so d'Alembert's principle says that m r'' − F is along ∇f,

    (m r'' − F) × ∇f = 0 ,

wherever ∇f ≠ 0. To solve for one of the δx, δy, δz would lose an equation where a component of ∇f vanishes. With the
constraint differentiated twice, ∇f·r'' + D = 0, the law times ∇f gives λ = −(m D + F·∇f)/|∇f|². Friction acts against
the slip, −μ N r'/|r'| with N = |λ| |∇f|, and counts as an applied force. What is written in vectors is compared with
the components that were derived; where they do not agree the derivation is left as it is.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

import sympy as sp

from lagrange.core.records import record
from lagrange.core.symbols import (
    CrossProduct,
    DotProduct,
    TimeDerivative,
    Unspecified,
    VectorSymbol,
    differential,
    free_letter,
    t,
)
from lagrange.core.vectors import Vector
from lagrange.document.derivation import (
    Block,
    Display,
    Equation,
    EquationKind,
    Math,
    Part,
    Prose,
    Purpose,
    Ref,
    Rule,
    Step,
    display,
    has_purpose,
    math,
    prose,
)
from lagrange.explain.newton import works_when_moving
from lagrange.explain.page.laws import missing_relations
from lagrange.explain.reactions import pushed_side
from lagrange.explain.words import constraints_called, the
from lagrange.mechanics.constraints.constrained_system import Row
from lagrange.mechanics.dynamics.equations import DalembertMotion
from lagrange.mechanics.dynamics.friction import FrictionForce
from lagrange.mechanics.dynamics.newton import FreeBody, Reaction
from lagrange.mechanics.results import Solution
from lagrange.mechanics.rewriting.vectors import curvature_term, is_power, is_surface_multiplier

ZERO = sp.S.Zero


@record
class OnSurface:
    """A particle on a surface, and the symbols of its page.

    gradient   ∇f, and its components
    letters    D of the second derivative, N of the normal force
    """

    solution: Solution
    row: Row
    name: str
    mass: sp.Expr
    gradient: VectorSymbol
    components: tuple[sp.Expr, ...]
    letters: tuple[sp.Symbol, sp.Symbol]

    @property
    def velocity(self) -> VectorSymbol:
        """r'."""
        return VectorSymbol(f"r_{self.name}'")

    @property
    def friction(self) -> FrictionForce | None:
        """The friction, if there is one."""
        dynamics = self.solution.own.dynamics
        return dynamics.friction_forces[0] if dynamics is not None and dynamics.friction_forces else None

    @property
    def rubbing(self) -> sp.Expr:
        """μ N r'/|r'|, to be subtracted from the force."""
        if self.friction is None:
            return ZERO
        return self.friction.coefficient * self.letters[1] * self.velocity / sp.Abs(self.velocity)

    @property
    def applied(self) -> sp.Expr:
        """F; zero where nothing is applied."""
        bodies = self.solution.law.newton.bodies if self.solution.law is not None else None
        return ZERO if not bodies or _applied(self.solution).is_zero else VectorSymbol(f"F_{self.name}")

    @property
    def left_over(self) -> sp.Expr:
        """m r'' − F, with the friction."""
        return self.mass * VectorSymbol(f"r_{self.name}''") - self.applied + self.rubbing


def _applied(solution: Solution) -> Vector:
    """The applied force without friction."""
    assert solution.law is not None
    loads = [f.vector for f in solution.law.configuration.loads]
    return sum(loads, Vector.zero())


def on_surface(solution: Solution) -> OnSurface | None:
    """The particle and its surface; None for any other system."""
    own, problem = solution.own, solution.problem
    configuration = own.configuration
    if len(configuration.points) != 1 or configuration.rotations or len(configuration.rows) != 1 or problem.choices:
        return None
    if configuration.links or configuration.potential != 0 or configuration.torques or own.equilibrium is not None:
        return None
    [point], [row] = configuration.points, configuration.rows
    if row.finite is None or point.position.components != configuration.slots.coordinates:
        return None
    functions = row.finite.atoms(Unspecified)
    if len(functions) != 1:
        return None
    [f] = functions
    rest = row.finite - f
    if any(f.orders) or not rest.free_symbols.isdisjoint({*configuration.slots.coordinates, t}):
        return None
    names = problem.scope.names()
    letters = (free_letter("D", "B", "E", taken=names), free_letter("N", "R_N", taken=names))
    d, n = (sp.Symbol(letter, real=True) for letter in letters)
    made = OnSurface(solution, row, point.name, point.mass, VectorSymbol(f"nabla({f.name})"), row.coefficients, (d, n))
    return made if _agrees(made) else None


def _agrees(s: OnSurface) -> bool:
    """Whether the vector form of the reaction and of the friction is that of the derivation."""
    dynamics, law = s.solution.own.dynamics, s.solution.law
    if dynamics is None:
        return True
    friction = s.friction
    if law is None or not isinstance(dynamics.written, DalembertMotion) or len(dynamics.friction_forces) > 1:
        return False
    if friction is not None:
        speed = tuple(s.solution.own.configuration.slots.velocities)
        if s.row.drift != 0 or friction.slip.fixed().components != speed or friction.beside is not None:
            return False
    [r] = law.newton.reactions
    value = dynamics.reactions.multipliers.get(r.name) if dynamics.reactions is not None else None
    if value is None or r.named or r.directions is None:
        return False
    return is_surface_multiplier(value, s.solution.own.configuration, s.mass, s.components, _applied(s.solution))


def in_vectors(s: OnSurface, steps: Iterable[Step]) -> Iterator[Step]:
    """The steps of the page in vectors; the matrix form, in components, stands in the complete derivation only."""
    has_motion = False
    for step in steps:
        match step.rule:
            case Rule.STATEMENT:
                yield _stated(s, step)
            case Rule.CONSTRAINT | Rule.PFAFFIAN_FORM | Rule.CLASSIFICATION:
                yield _with_gradient(s, step)
            case Rule.DISPLACEMENTS:
                yield _displacements(s, step)
            case Rule.REACTIONS:
                yield _laws(s)
            case Rule.WORKLESS:
                yield _work(s)
            case Rule.PRINCIPLE:
                yield _principle(s)
            case Rule.EQUATIONS_OF_MOTION:
                if not has_motion:
                    yield _motion(s, step)
                has_motion = True
            case Rule.SOLVED_REACTIONS:
                yield _reaction(s, step)
            case Rule.CONSERVED:
                yield _energy(s, step)
            case _:
                yield step


def _stated(s: OnSurface, step: Step) -> Step:
    """The statement, with the applied force without friction."""
    if s.friction is None:
        return step
    label, force = f"force-{s.name}", _applied(s.solution)
    body: list[Block] = []
    for block in step.body:
        if isinstance(block, Display) and any(e.label == label for e in block.equations):
            lines = (replace(e, sides=(e.sides[0], force)) if e.label == label else e for e in block.equations)
            body.append(display(*lines))
        elif not has_purpose(block, Purpose.FRICTION_INSIDE):
            body.append(block)
    return replace(step, body=tuple(body))


def _with_gradient(s: OnSurface, step: Step) -> Step:
    """∇f·dr before the form."""
    product = DotProduct(s.gradient, VectorSymbol(f"d(r_{s.name})")) + s.row.drift * differential(t)

    def line(e: Equation) -> Equation:
        return replace(e, sides=(product, *e.sides)) if e.label == f"form-{s.row.name}" else e

    def changed(b: Block) -> Block:
        if isinstance(b, Display):
            return b.map(line)
        return _where_it_vanishes(s, b) if isinstance(b, Prose) else b

    return replace(step, body=tuple(map(changed, step.body)))


def _where_it_vanishes(s: OnSurface, block: Prose) -> Prose:
    """`Where ∇f = 0` for `Where ∂f/∂x = ∂f/∂y = ∂f/∂z = 0`."""
    everywhere = {*s.components, ZERO}
    parts = (math(s.gradient, ZERO) if isinstance(p, Math) and {*p.sides} == everywhere else p for p in block.parts)
    return replace(block, parts=tuple(parts))


def _displacements(s: OnSurface, step: Step) -> Step:
    """∇f·δr = 0, and what that says."""
    dt = math(differential(t))
    moving = s.row.drift != 0
    words: tuple[Part, ...] = (
        "Possible displacements satisfy ", Ref(f"form-{s.row.name}"), ". A virtual displacement is the difference of "
        "two of them in the same time ", dt, ", from the same position: ",
        *(("the terms in ", dt, " drop out, and ") if moving else ()), "it satisfies",
    )  # fmt: skip
    virtual = Equation(
        (DotProduct(s.gradient, _virtual(s)), ZERO),
        label=f"virtual-{s.row.name}",
        kind=EquationKind.VIRTUAL,
        about=s.row.name,
    )
    tangent: tuple[Part, ...] = (
        math(s.gradient),
        " is normal to the surface. So every virtual displacement is tangent to it, ",
    )
    if moving:
        tangent += ("as it is at that time; a possible displacement in general is not.",)
    else:
        tangent += ("and so is every possible one: without a term in ", dt, " they are the same.")
    drift = next((n for n, b in enumerate(step.body) if has_purpose(b, Purpose.DRIFT)), None)
    rest = step.body[drift:] if drift is not None else ()
    return replace(step, body=(prose(*words), display(virtual), prose(*tangent), *rest))


def _virtual(s: OnSurface) -> VectorSymbol:
    return VectorSymbol(f"delta(r_{s.name})")


def _only(s: OnSurface) -> tuple[FreeBody, Reaction]:
    assert s.solution.law is not None
    newton = s.solution.law.newton
    return (newton.bodies or ())[0], newton.reactions[0]


def _laws(s: OnSurface) -> Step:
    """m r'' = F + R, and R = λ ∇f."""
    _, r = _only(s)
    reaction, friction = VectorSymbol(f"R_{s.name}"), s.friction
    law = Equation((s.mass * VectorSymbol(f"r_{s.name}''"), s.applied - s.rubbing + reaction), label=f"law-{s.name}")
    force: tuple[Part, ...] = ("the applied force ", math(s.applied), " and ") if s.applied != 0 else ()
    normal = Equation((reaction, r.force * s.gradient), label=f"reaction-{s.name}", kind=EquationKind.REACTION)
    newton = s.solution.law.newton if s.solution.law is not None else None
    assert newton is not None
    body: list[Block] = []
    if friction is None:
        body += [prose("With ", *force, "the reaction ", math(reaction), ", Newton's law is"), display(law)]
        body += missing_relations(s.solution, newton)
        body += [
            prose("A smooth surface pushes only along its normal, with a factor ", math(r.force), ":"),
            display(normal),
        ]
    else:
        size = Equation((s.letters[1], sp.Abs(reaction), sp.Abs(r.force) * sp.Abs(s.gradient)), label="normal-force")
        body += [
            prose("The surface exerts a force along its normal, the reaction, with a factor ", math(r.force),
                  ", and friction:"),
            display(normal),
            prose("While ", the(s.name), " slides, the friction is ", math(friction.coefficient), " times the "
                  "magnitude of the reaction,"),
            display(size),
            prose("and directed against the velocity. It does work and counts as an applied force. Without slip, "
                  "static friction takes whatever value prevents it, up to a limit. Newton's law is"),
            display(law),
        ]  # fmt: skip
    return Step(Rule.REACTIONS, "Newton's law and the reactions", tuple(body))


def _work(s: OnSurface) -> Step:
    """R·δr = 0, and the work in a possible displacement of a surface that moves."""
    _, r = _only(s)
    virtual = f"virtual-{s.row.name}"
    work = DotProduct(s.gradient, _virtual(s))
    line = Equation((DotProduct(VectorSymbol(f"R_{s.name}"), _virtual(s)), r.force * work, ZERO), label="virtual-work",
                    condition=("by ", Ref(virtual)))  # fmt: skip
    body: list[Block] = []
    if _shows_displacements(s):
        body.append(prose("In a virtual displacement the reaction does no work:"))
    else:
        body += [
            prose(
                "Time does not appear in ",
                Ref(f"form-{s.row.name}"),
                ": virtual displacements satisfy it too,",
                purpose=Purpose.TIMELESS,
            ),
            display(Equation((work, ZERO), label=virtual)),
            prose("They are tangent to the surface, and in them the reaction does no work:"),
        ]
    body += [display(line), *works_when_moving(s.solution.works)]
    return Step(Rule.WORKLESS, "The reaction does no virtual work", tuple(body))


def work_of_surface(s: OnSurface) -> list[Equation]:
    """R = λ ∇f and R·δr = 0; for a surface that moves R·dr, too, which is not zero."""
    _, r = _only(s)
    force = VectorSymbol(f"R_{s.name}")
    lines = [Equation((force, r.force * s.gradient)), Equation((DotProduct(force, _virtual(s)), ZERO))]
    if s.row.drift != 0:
        possible = -r.force * s.row.drift * differential(t)
        lines.append(Equation((DotProduct(force, VectorSymbol(f"d(r_{s.name})")), possible)))
    return lines


def _shows_displacements(s: OnSurface) -> bool:
    """Whether displacements have a step of their own: where the surface moves, or there is friction."""
    return s.row.drift != 0 or s.friction is not None


def _principle(s: OnSurface) -> Step:
    body = (
        prose("Multiply Newton's law by the virtual displacement: the reaction drops out by ", Ref("virtual-work"),
              ", and d'Alembert's principle remains:"),
        display(Equation((DotProduct(s.left_over, _virtual(s)), ZERO), label="principle")),
    )  # fmt: skip
    return Step(Rule.PRINCIPLE, "D'Alembert's principle", body)


def _motion(s: OnSurface, step: Step) -> Step:
    """(m r'' − F) × ∇f = 0, and its components."""
    configuration = s.solution.own.configuration
    constraint = s.solution.problem.constraints[0]
    size: tuple[Part, ...] = ()
    if s.friction is not None:
        size = ("with ", math(s.letters[1], sp.Abs(VectorSymbol(f"R_{s.name}"))))
    both = (
        Equation(
            (CrossProduct(s.left_over, s.gradient), ZERO),
            label="motion-across",
            kind=EquationKind.MOTION,
            condition=size,
        ),
        Equation((constraint.lhs, constraint.rhs), label="motion-surface", kind=EquationKind.COMPLETING),
    )
    body: list[Block] = [
        prose("By ", Ref(f"virtual-{s.row.name}"), ", ", math(_virtual(s)), " is any vector normal to ",
              math(s.gradient), ", and ", math(s.left_over), " is normal to all of these if and only if it is along ",
              math(s.gradient), " itself:"),
        display(*both, boxed=True),
    ]  # fmt: skip
    if s.friction is None:
        force = _applied(s.solution).components
        sides = [s.mass * a - f for a, f in zip(configuration.slots.accelerations, force, strict=True)]
        pairs = ((1, 2), (2, 0), (0, 1))
        lines = (
            Equation(
                (sides[a] * s.components[b], sides[b] * s.components[a]),
                label=f"motion-component-{n}",
                kind=EquationKind.MOTION,
            )
            for n, (a, b) in enumerate(pairs, start=1)
        )
        body += [prose("In components, of which two are independent wherever ", math(s.gradient, ZERO, relation="≠"),
                       ","), display(*lines)]  # fmt: skip
    return replace(step, body=tuple(body))


def _reaction(s: OnSurface, step: Step) -> Step:
    """λ from Newton's law times ∇f."""
    _, r = _only(s)
    d = s.letters[0]
    product = DotProduct(s.gradient, VectorSymbol(f"r_{s.name}''"))
    force = DotProduct(s.applied, s.gradient) if s.applied != 0 else ZERO
    rubs = "," if s.friction is None else ", to which the friction is perpendicular,"
    body: list[Block] = [
        prose("Differentiated twice, ", Ref(f"constraint-{s.row.name}"), " is"),
        display(Equation((product + d, ZERO), label="differentiated-twice")),
        prose("with"),
        display(Equation((d, curvature_term(s.solution.own.configuration)), label="second-derivative")),
        prose("So Newton's law, multiplied by ", math(s.gradient), f"{rubs} gives"),
        display(
            Equation((r.force * sp.Abs(s.gradient) ** 2, -s.mass * d - force), label=f"multiplier-{r.name}"), boxed=True
        ),
    ]
    bounds = [pushed_side(r, s.gradient) for b in step.body if has_purpose(b, Purpose.ONLY_PUSHES)]
    return replace(step, body=(*body, *bounds))


def _energy(s: OnSurface, step: Step) -> Step:
    """d/dt (½ m r'²) = F·r', and what the surface adds."""
    view = s.solution.own
    energy = view.conserved.energy if view.conserved is not None else None
    others = view.conserved is None or bool(view.conserved.integrals)
    if energy is None or energy.rate is None or energy.hidden or others:
        return step
    slots, force = view.configuration.slots, _applied(s.solution)
    _, r = _only(s)
    added = -r.force * s.row.drift
    shown = DotProduct(s.applied, s.velocity) if s.applied != 0 else ZERO
    if s.friction is not None:
        shown -= s.friction.coefficient * s.letters[1] * sp.Abs(s.velocity)
        added -= s.friction.coefficient * s.friction.magnitude * sp.sqrt(sp.Add(*(v**2 for v in slots.velocities)))
    if not is_power(energy, s.mass, force, slots.velocities, added):
        return step
    if s.friction is None:
        shown += added
    rate = TimeDerivative(sp.Mul(sp.Rational(1, 2), s.mass, s.velocity**2))
    called = constraints_called([r.name])
    words: tuple[Part, ...]
    if s.row.drift != 0:
        moved_by = s.row.moves_with(slots)
        unless: tuple[Part, ...] = () if moved_by is None else (" unless ", math(moved_by, ZERO))
        begins = f"Though the reaction does no virtual work, it does work on {the(s.name)}"
        words = (begins, *unless, f": {called} moves. Along the motion")
    elif s.friction is not None:
        words = ("The reaction does no work, but friction takes energy. Along the motion",)
    else:
        words = ("The surface does no work in the motion either: only the applied force changes the kinetic energy,",)
    return replace(
        step, body=(prose(*words), display(Equation((rate, shown), label="energy-rate", kind=EquationKind.ENERGY_RATE)))
    )
