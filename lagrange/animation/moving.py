"""The moving figure of a web page: the equations of motion in JavaScript, and the data that the page needs.

The page integrates

    M q'' − Aᵀ λ = f ,      A q'' = b ,      y = (q, q', t)

in the coordinates of a choice that satisfies the constraints by itself, where there is one, otherwise in those of the
file with the constraints kept by projection. The reactions come from the same equations in the coordinates of the
file, at the state z = (Q, Q', t, q) that belongs to y. For positions of rest it has the generalized forces instead of
M.

What cannot be written as JavaScript (a function that the file leaves open) makes a page without motion; `Still` says
why.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import chain
from typing import TYPE_CHECKING, Any

import sympy as sp

from lagrange.algebra.closed_forms.single_equation import Relation
from lagrange.animation.elements import Elements
from lagrange.animation.figure import (
    EquilibriumButton,
    MovingFigure,
    Slider,
    Still,
    UnmovableError,
    coordinate_slider,
    parameter_slider,
    sampled,
    surfaces,
)
from lagrange.animation.inferred import add_inferred
from lagrange.animation.limits import LONGEST_PROGRAM, MOST_COORDINATES, MOST_OPERATIONS, MOST_ROWS
from lagrange.core.diagnostics import ProblemError
from lagrange.core.expression_size import count_distinct, distinct_parts
from lagrange.core.symbols import Sign, Slots, Unspecified, prime, t
from lagrange.core.vectors import Vector
from lagrange.mechanics.dynamics.conservation import ConservedQuantity, Integral
from lagrange.mechanics.dynamics.energies import potential_energy
from lagrange.mechanics.dynamics.lagrangian import kinetic_energy
from lagrange.mechanics.dynamics.newton import Reaction
from lagrange.mechanics.momenta.impact import ImpulsiveMotion
from lagrange.mechanics.results import InCoordinates, Solution
from lagrange.mechanics.solution import solve
from lagrange.mechanics.through_impact import problem_begun
from lagrange.pictures.floats import NoValueError, value
from lagrange.pictures.poses import Pose
from lagrange.pictures.systems import SystemPicture
from lagrange.programs.contacts import coefficients_at_rest, guards
from lagrange.programs.defaults import (
    AMPLITUDE,
    FREQUENCY,
    GRAVITY,
    UNDECLARED_GRAVITY,
    angles_in,
    drawn_system,
    parameter_value,
    samples,
    slip_speeds,
)
from lagrange.programs.first_order import in_coordinates
from lagrange.programs.languages import JAVASCRIPT, Argument, GeneratedFunction
from lagrange.programs.starting import Start, start
from lagrange.programs.state_equations import StateEquations, filled, state_equations

if TYPE_CHECKING:
    from lagrange.programs.simulation import Simulation


def moving_figure(solution: Solution, simulation: Simulation | None = None) -> MovingFigure | Still:
    """The figure that moves, or why there is none; with a simulation, in its coordinates and from its start."""
    if len(solution.own.configuration.slots.coordinates) > MOST_COORDINATES:
        return Still("the system has too many coordinates")
    try:
        if solution.impact is not None and simulation is None:
            solution = solution.after or _after(solution, solution.impact)
        moves = any(v.dynamics is not None for v in solution.views) or solution.long_equations is not None
        states = simulation.equations if simulation is not None else state_equations(solution) if moves else None
        return _Maker(solution, _view(solution, states), states, simulation).made()
    except (UnmovableError, NoValueError) as error:
        return Still(str(error))
    except ProblemError as error:
        return Still(error.diagnostics[0].message)


def _after(solution: Solution, impact: ImpulsiveMotion) -> Solution:
    """The motion after an impact, where the file asks nothing about it; the solution itself where it cannot be solved.

    Its equations alone: what would follow from the initial state in letters is not shown.
    """
    begun = problem_begun(solution.problem, impact)
    after = solve(replace(begun, questions=(), initial=()), complete=False)
    moves = after.law is not None or after.long_equations is not None
    return solution if after.given_up or not moves else replace(after, problem=begun)


def _view(solution: Solution, states: StateEquations | None) -> InCoordinates:
    """The coordinates of the motion; for a rest free ones without square roots, otherwise those of the file."""
    if states is not None:
        return solution.view(states.name)
    return min(solution.views, key=lambda v: (v.equilibrium is None, bool(v.signs), len(v.configuration.rows)))


@dataclass
class _Maker:
    """Makes the figure of one solution in one set of coordinates."""

    solution: Solution
    view: InCoordinates
    states: StateEquations | None
    simulation: Simulation | None
    functions: dict[str, str] = field(default_factory=dict)
    drives: dict[sp.Symbol, Slider] = field(default_factory=dict)
    taken: dict[str, sp.Expr] = field(default_factory=dict)
    shape: dict[str, Any] = field(default_factory=dict)
    elements: Elements | None = None
    integrals: list[Integral] = field(default_factory=list)
    potential: sp.Expr = sp.S.Zero
    loads: list[int] = field(default_factory=list)
    bound: list[int] = field(default_factory=list)
    slips: list[int] = field(default_factory=list)
    begins: list[int] = field(default_factory=list)
    wanted: list[int] = field(default_factory=list)
    reaction_list: list[Reaction] = field(default_factory=list)
    buttons: list[EquilibriumButton] = field(default_factory=list)
    button_parts: list[list[sp.Symbol]] = field(default_factory=list)

    @property
    def own(self) -> InCoordinates:
        return self.solution.own

    def made(self) -> MovingFigure:
        view = self.view
        self.taken = {**samples(self.solution), **self.given}
        system, pose = drawn_system(sampled(self.solution, self.taken), self.view)
        if system is None and self.states is None:
            raise UnmovableError("there is no drawing of this system")
        drawn = dict(system.pose.values) if system else {}
        slots = view.configuration.slots
        self._drive(slots, drawn)
        expressions = self._expressions(system, pose)
        signs = view.dynamics.signs if view.dynamics else {}
        parts = distinct_parts(e for group in expressions.values() for e in group)
        symbols = sorted({s for s in parts if isinstance(s, sp.Symbol)} - self._state_symbols(), key=str)
        self._refuse_unknown(symbols, signs)
        along = {s for _, names in (self.elements.curves if self.elements else ()) for s in names}
        parameters = [s for s in symbols if s not in along]
        return self._assembled(expressions, parameters, drawn, pose, system)

    # What the page has to know

    @property
    def given(self) -> Mapping[str, sp.Expr]:
        """The functions and motions that the command line has given."""
        return self.states.given if self.states is not None else {}

    def _drive(self, slots: Slots, drawn: Mapping[sp.Symbol, float]) -> None:
        """Prescribed motions u(t) become u_0 + a sin(w t), each with its own mean, amplitude and circular frequency."""
        for u in slots.prescribed:
            if u.name in self.given:
                continue
            mean, size, rate = (sp.Dummy(f"{u.name}_{what}", real=True) for what in ("mean", "amplitude", "frequency"))
            self.taken[u.name] = mean + size * sp.sin(rate * t)
            place = drawn.get(u, 0.5)
            for symbol, what, number, low, high in (
                (mean, "mean of", place, -2 * abs(place) - 0.5, 2 * abs(place) + 0.5),
                (size, "amplitude of", AMPLITUDE, 0.0, 1.0),
                (rate, "frequency of", FREQUENCY, 0.0, 6.0),
            ):
                self.drives[symbol] = Slider(u, number, low, high, meaning=what)

    def _state_symbols(self) -> set[sp.Symbol]:
        view, own = self.view.configuration.slots, self.own.configuration.slots
        return {*view.coordinates, *view.velocities, *own.coordinates, *own.velocities, t}

    def _function(self, name: str, outputs: Sequence[sp.Expr], parameters: Sequence[sp.Symbol]) -> str:
        """A method of JavaScript: of y or z and p, of the parameters of a curve too, or of p alone."""
        view, own = self.view.configuration.slots, self.own.configuration.slots
        of_page: Argument = ("y", (*view.coordinates, *view.velocities, t))
        # A choice may keep a coordinate of the file, whose place among those of the file is the one that is varied.
        more = () if self.view.is_own else tuple(sp.Dummy() if q in own.coordinates else q for q in view.coordinates)
        in_file: Argument = ("z", (*own.coordinates, *own.velocities, t, *more))
        arguments: list[Argument] = [("p", tuple(parameters))]
        if name != "ini":
            arguments.insert(0, in_file if name.startswith(("rea", "fig", "act", "tra", "cur", "car")) else of_page)
        if name.startswith("cur"):
            assert self.elements is not None
            arguments.append(("u", tuple(self.elements.curves[int(name[3:])][1])))
        return " ".join(JAVASCRIPT.function(GeneratedFunction.of(name, arguments, outputs))).removeprefix("function ")

    def _refuse_unknown(self, symbols: Iterable[sp.Symbol], signs: Mapping[Sign, sp.Expr]) -> None:
        for s in symbols:
            if s in signs:
                raise UnmovableError("the sense of a friction force depends on the motion")
            if s.name.endswith("'"):
                raise UnmovableError(f"the velocity {s.name} is not determined")

    def put(self, e: sp.Expr) -> sp.Expr:
        """An expression with the prescribed motions that the page takes."""
        return filled(sp.sympify(e, strict=True), self.taken, self.view.configuration.slots, self.solution.problem)

    # Expressions of all functions, by name

    def _expressions(self, system: SystemPicture | None, pose: Pose | None) -> dict[str, list[sp.Expr]]:
        view, configuration = self.view, self.view.configuration
        out: dict[str, list[sp.Expr]] = {}
        if not view.is_own:
            out["own"] = self._own()
        if self.states is not None:
            out["eq"] = self._equations(view, "eq")
            out["con"] = self._constraints(view)
            if not view.is_own and self.own.dynamics is not None:
                out["rea"] = self._equations(self.own, "rea")
        else:
            out["con"] = self._constraints(view)
            if view.equilibrium is not None:
                out["sta"] = self._statics()
        if any(self.solution.transport_rates):
            out["car"] = [self.put(w) for w in self.solution.transport_rates]
        out["sli"] = self._slips()
        planes = [f.slip for f in view.dynamics.friction_forces if f.speed is None] if view.dynamics is not None else []
        if len(planes) == 1:
            out["pla"] = [self.put(c) for c in planes[0].fixed().components]
        potential = potential_energy(configuration)
        self.potential = self.put(potential)
        kinetic = kinetic_energy(configuration) if self.states is not None else sp.S.Zero
        integrals = view.conserved.integrals if view.conserved else ()
        fast = {*configuration.slots.accelerations}
        self.integrals = [i for i in integrals if not i.expression.free_symbols & fast]
        out["ene"] = [self.put(e) for e in (kinetic, potential, *(i.expression for i in self.integrals))]
        out["ini"] = self._stated()
        self.elements = None if system is None else Elements(system, pose)
        out["act"] = self._acting()
        if self.elements is not None and system is not None:
            elements = self.elements
            for point, along, shift in surfaces(system.configuration) if self.taken else ():
                if not system.view.planar:
                    ends = (shift - 2, shift + 2, sp.Integer(-2), sp.Integer(2))
                    elements.surface(Vector(point), along, ends)
            try:
                elements.all(add_inferred)
            except NoValueError:
                elements.items = [i for i in elements.items if i["k"] in ("dot", "line")]
            out["fig"] = [self.put(e) for e in elements.cells.expressions]
            for n, (place, _) in enumerate(elements.curves):
                out[f"cur{n}"] = [self.put(e) for e in place.fixed().components]
            for n, (f, own, position) in enumerate(elements.traced):
                parts = [f, *(f.diff(q) for q in own), *position.components]
                parts += [c.diff(q) for q in own for c in position.components]
                out[f"tra{n}"] = [self.put(e) for e in parts]
        out.update(self._equilibria())
        return out

    def _own(self) -> list[sp.Expr]:
        own, view = self.own.configuration.slots, self.view.configuration
        rule = view.substitution
        places = [self.put(sp.sympify(rule.get(q, q), strict=True)) for q in own.coordinates]
        speeds = [self.put(sp.sympify(rule.get(prime(q), prime(q)), strict=True)) for q in own.coordinates]
        return [*places, *speeds, t, *view.slots.coordinates]

    def _equations(self, view: InCoordinates, name: str) -> list[sp.Expr]:
        assert self.states is not None
        form = self.states.equations if view.dynamics is None else in_coordinates(view.dynamics)
        self.shape[name] = [len(form.force), len(form.bias)]
        parts = [*chain.from_iterable(form.mass), *form.force, *chain.from_iterable(form.constraint_matrix), *form.bias]
        return [self.put(e) for e in parts]

    def _used(self, view: InCoordinates) -> list[int]:
        rows = view.configuration.rows
        if self.solution.long_equations is not None:
            return [n for n, row in enumerate(rows) if row.name not in self.solution.classification.redundant]
        return [n for n in range(len(rows)) if n not in view.elimination.unused]

    def _constraints(self, view: InCoordinates) -> list[sp.Expr]:
        """g (0 for constraints on velocities), their rates, ∂g/∂t or a_t, and A."""
        configuration = view.configuration
        rows = [configuration.rows[n] for n in self._used(view)]
        self.shape["con"] = [len(configuration.slots.coordinates), len(rows), [int(r.finite is not None) for r in rows]]
        finite = [sp.S.Zero if r.finite is None else r.finite for r in rows]
        rates = [r.velocity_form(configuration.slots) for r in rows]
        parts = [*finite, *rates, *(r.drift for r in rows), *(e for r in rows for e in r.coefficients)]
        return [self.put(e) for e in parts]

    def _statics(self) -> list[sp.Expr]:
        """Q of the coordinates of the page, then Q and A in those of the file."""
        assert self.view.equilibrium is not None
        own = self.own
        assert own.equilibrium is not None
        rows = [own.configuration.rows[n] for n in self._used(own)]
        n = len(self.view.equilibrium.work.forces)
        self.shape["sta"] = [n, len(own.configuration.slots.coordinates), len(rows)]
        in_file = [*own.equilibrium.work.forces, *(e for r in rows for e in r.coefficients)]
        rule = self.view.configuration.substitution
        here = list(self.view.equilibrium.work.forces)
        return [self.put(e) for e in (*here, *(sp.sympify(e, strict=True).xreplace(rule) for e in in_file))]

    def _reactions(self) -> list[Reaction]:
        law = self.solution.law
        if law is None:
            return []
        unused = self.own.elimination.unused
        rows = self.own.configuration.rows
        kept = {rows[n].name for n in range(len(rows)) if n not in unused}
        by_name = {r.name: r for r in law.newton.reactions if r.name in kept}
        return [by_name[rows[n].name] for n in range(len(rows)) if rows[n].name in by_name]

    def _acting(self) -> list[sp.Expr]:
        """Applied forces with their points; then for each reaction its factor and its forces for λ = 1."""
        configuration = self.own.configuration
        if self.own.dynamics is not None:
            configuration = self.own.dynamics.equations.configuration
        out: list[sp.Expr] = []
        loads = []
        for f in configuration.loads:
            parts = (*f.point.fixed().components, *f.vector.fixed().components)
            out += [self.put(c) for c in parts]
            loads.append(int(f.name == "weight"))
        self.loads = loads
        self.reaction_list = self._reactions() if self.view.dynamics or self.view.equilibrium else []
        points = {p.name: p for p in configuration.points}
        places = {p.name: p.position for p in configuration.points}
        turning = {r.name for r in configuration.rotations}
        for r in self.reaction_list:
            factor = sp.S.One if r.single is None else r.single.factor
            forces = []
            for body, vector in (r.directions or {}).items():
                force = vector.fixed()
                at = places[body].fixed()
                if body in turning and self.elements is not None:
                    at = self.elements.acts_at(points[body], r) or at
                forces.append((at, force))
            out.append(self.put(factor))
            for at, force in forces:
                out += [self.put(c) for c in (*at.components, *force.components)]
            self.bound.append(len(forces))
        return out

    def _stated(self) -> list[sp.Expr]:
        """The values of the file at t = 0, first those of the page's coordinates and velocities, then of the file's."""
        slots, own = self.view.configuration.slots, self.own.configuration.slots
        here, file = (*slots.coordinates, *slots.velocities), (*own.coordinates, *own.velocities)
        stated = {s.symbol: s.value for s in self.solution.problem.initial}
        self.begins = [here.index(s) for s in stated if s in here]
        self.wanted = [file.index(s) for s in stated if s in file and s not in here]
        values = [
            *(v for s, v in stated.items() if s in here),
            *(v for s, v in stated.items() if s in file and s not in here),
        ]
        return [self.put(v) for v in values]

    def _slips(self) -> list[sp.Expr]:
        """The speeds of slip, positive in the sense that the file states; for a slip in a plane its square. Then the
        rates at which mass joins or leaves, where the equations hold only as long as it does (their kind is 3), and
        masses that vary, which are positive (4).
        """
        slips = [*slip_speeds(self.view.dynamics)]
        varying = self.view.configuration.variable_masses
        rates = [m.exchanged for m in varying if m.has_one_sense]
        self.slips = [*(int(kind) for kind, _ in slips), *(3 for _ in rates), *(4 for _ in varying)]
        return [self.put(e) for e in (*(e for _, e in slips), *rates, *(m.mass for m in varying))]

    def _static(self, parameters: Sequence[sp.Symbol], number: Callable[[sp.Symbol], float]) -> list[tuple[int, float]]:
        """The place of each coefficient of friction that is a parameter, and the number of the static coefficient."""
        out = []
        for kinetic, static in coefficients_at_rest(self.solution.problem).items():
            if kinetic in parameters:
                numbers = {x: number(x) for x in static.free_symbols}
                out.append((parameters.index(kinetic), value(static, numbers)))
        return out

    def _equilibria(self) -> dict[str, list[sp.Expr]]:
        """The coordinates of each equilibrium in closed form, and the unknown forces there."""
        out: dict[str, list[sp.Expr]] = {}
        view = self.view
        equilibrium = view.equilibrium or (view.linearization.equilibrium if view.linearization else None)
        if equilibrium is None:
            return out
        coordinates = view.configuration.slots.coordinates
        verdicts = view.stability.verdicts if view.stability is not None else ()
        for n, b in enumerate(equilibrium.branches):
            values = _values(b.relations, (*coordinates, *equilibrium.forces))
            if not values or b.left:
                continue
            stability = str(verdicts[n].verdict.value) if n < len(verdicts) else ""
            out[f"eql{len(self.buttons)}"] = [self.put(e) for e in values.values()]
            self.button_parts.append([*values])
            shown = {*coordinates, *equilibrium.forces}
            relations = tuple((r.lhs, r.rhs) for r in b.relations if r.lhs.free_symbols & shown)
            self.buttons.append(EquilibriumButton(relations, stability))
        return out

    # Everything together

    def _assembled(
        self,
        expressions: Mapping[str, Sequence[sp.Expr]],
        parameters: Sequence[sp.Symbol],
        drawn: Mapping[sp.Symbol, float],
        pose: Pose | None,
        system: SystemPicture | None,
    ) -> MovingFigure:
        problem, configuration = self.solution.problem, self.view.configuration
        slots = configuration.slots
        if count_distinct(e for group in expressions.values() for e in group) > MOST_OPERATIONS:
            raise UnmovableError("its equations are too long")
        code = [self._function(name, group, parameters) for name, group in expressions.items()]
        written = "{\n" + ",\n".join(code) + "\n}"
        if len(written) > LONGEST_PROGRAM:
            raise UnmovableError("its equations are too long")
        everything = [e for group in expressions.values() for e in group]
        angles = angles_in(everything)
        begun = self._start(drawn, pose)
        declared = {p.symbol: p for p in problem.parameters}

        def number(s: sp.Symbol) -> float:
            known = begun.values.get(s) if begun is not None else None
            return parameter_value(s, declared.get(s), problem, drawn, s in angles) if known is None else known

        knobs = [self.drives.get(s) or parameter_slider(s, problem, number(s), s in angles) for s in parameters]
        state = self._state(begun, drawn if pose is None else {**drawn, **pose.values})
        sliders = tuple(coordinate_slider(q, problem, state[q], q in angles) for q in slots.coordinates)
        elements = self.elements
        planar = system.view if system else None
        data = {
            "n": len(slots.coordinates),
            "shape": self.shape,
            "y": [state[s] for s in (*slots.coordinates, *slots.velocities)] + [0.0],
            "motion": self._motion(),
            "p": [k.value for k in knobs],
            "angles": [int(s.angle) for s in sliders],
            "items": elements.items if elements else [],
            "rest": int(self.states is not None and not self.buttons and self._may_rest(expressions)),
            "never": [k for k, _ in self._unchanged(expressions)],
            "traced": [
                [self.own.configuration.slots.coordinates.index(q) for q in own] for _, own, _ in elements.traced
            ]
            if elements
            else [],
            "units": [list(u) for u in planar.units] if planar else [[1, 0], [0, 1], [0, 0]],
            "shown": list(planar.shown) if planar else [],
            "planar": int(planar.planar) if planar else 1,
            "axes": int(elements is not None and "axes" not in elements.hidden),
            "loads": self.loads,
            "bound": self.bound,
            "guards": [*map(int, guards(self.view.dynamics, self.reaction_list).values())],
            "static": self._static(parameters, number),
            "slips": self.slips,
            "timed": int(any(e.has(t) for e in expressions.get("eq", ()))),
            "begins": self.begins,
            "wanted": self.wanted,
            "sizes": len(self.own.configuration.slots.coordinates),
            "points": self._points(elements),
            "conserved": [
                int(i.quantity in (ConservedQuantity.ENERGY, ConservedQuantity.JACOBI)) for i in self.integrals
            ],
            "buttons": [
                [slots.coordinates.index(s) if s in slots.coordinates else -1 - parameters.index(s) for s in values]
                for values in self.button_parts
            ],
            "moves": int(self.states is not None),
            "newton": int(any("kg" in (p.unit or p.stated_unit) for p in problem.parameters)),
            "rheonomic": int(any(e.has(t) for name in ("own", "con") for e in expressions.get(name, ()) if e != t)),
        }
        return MovingFigure(
            code=written,
            data=data,
            labels=tuple(elements.labels) if elements else (),
            coordinates=sliders,
            parameters=tuple(knobs),
            reactions=tuple(_force(r) for r in self.reaction_list),
            conserved=tuple((i.quantity.value, i.expression) for i in self.integrals),
            equilibria=tuple(self.buttons),
            moves=self.states is not None,
            rests=self.view.equilibrium is not None,
            released=bool(self.begins or self.wanted),
            pushed=begun is not None and begun.pushed,
            orbits=begun is not None and begun.orbits,
            assumed=self._assumed(),
            needed=tuple(e for _, e in self._unchanged(expressions)),
            driven=tuple(u for u in slots.prescribed if u.name not in self.given),
            divided=problem.lagrangian is None,
        )

    def _start(self, drawn: Mapping[sp.Symbol, float], pose: Pose | None) -> Start | None:
        """Where the motion starts: that of the simulation, otherwise where `simulate` would start; None at rest."""
        if self.simulation is not None:
            return self.simulation.start
        if self.states is None:
            return None
        numbers = {s: sp.Float(k.value, 17) for s, k in self.drives.items()} | {
            UNDECLARED_GRAVITY: sp.Float(GRAVITY, 17)
        }
        taken = {name: e.xreplace(numbers) for name, e in self.taken.items()}
        known = {**drawn, **pose.values} if pose is not None else drawn if self.view.is_own else None
        return start(self.states.with_functions(taken), self.solution, drawn=known)

    def _state(self, begun: Start | None, drawn: Mapping[sp.Symbol, float]) -> dict[sp.Symbol, float]:
        """The coordinates and velocities at the start."""
        slots = self.view.configuration.slots
        if begun is None or self.states is None:
            return {**{q: drawn.get(q, 0.5) for q in slots.coordinates}, **dict.fromkeys(slots.velocities, 0.0)}
        e = self.states.equations
        at = {**begun.values, t: 0.0, **dict(zip(e.state, begun.state, strict=True))}
        rates = (value(self.put(rate), at) for rate in e.rates)
        return {**{q: at[q] for q in slots.coordinates}, **dict(zip(slots.velocities, rates, strict=True))}

    def _motion(self) -> list[list[float]]:
        """The computed motion of a simulation: rows q, q', t."""
        if self.simulation is None:
            return []
        simulation, e = self.simulation, self.simulation.equations.equations
        places = [*simulation.states[: len(e.rates)], *(simulation.along(rate) for rate in e.rates)]
        every = -(-len(simulation.times) // MOST_ROWS)
        rows = zip(*(x.tolist()[::every] for x in (*places, simulation.times)), strict=True)
        return [[float(f"{x:.9g}") for x in row] for row in rows]

    def _assumed(self) -> tuple[tuple[sp.Expr, sp.Expr], ...]:
        """The sample functions assumed for those that the file leaves unspecified."""
        functions = (f for f in self.solution.problem.functions if f.name not in self.given)
        formal = ((f.name, [sp.Symbol(a, real=True) for a in f.arguments], f.arguments) for f in functions)
        return tuple((Unspecified.of(n, names, *places), self.taken[n]) for n, places, names in formal)

    def _may_rest(self, expressions: Mapping[str, Sequence[sp.Expr]]) -> bool:
        """Whether the page looks for positions of rest itself: few free coordinates, forces without time."""
        free = self.shape["eq"][1] == 0 and len(self.view.configuration.slots.coordinates) <= 3
        return free and not self.slips and not any(e.has(t) for e in expressions["eq"])

    def _unchanged(self, expressions: Mapping[str, Sequence[sp.Expr]]) -> Iterator[tuple[int, sp.Expr]]:
        """The generalized forces at rest that no position changes, with the numbers of their coordinates.

        Where one of them is not zero, there is no position of rest: a motor turns its arm, a particle falls.
        """
        if self.states is None or not self._may_rest(expressions):
            return
        slots = self.view.configuration.slots
        n, still = len(slots.coordinates), dict.fromkeys(slots.velocities, sp.S.Zero)
        for k, e in enumerate(expressions["eq"][n * n : n * n + n]):
            force = sp.factor(e.xreplace(still))
            if not force.free_symbols & {*slots.coordinates} and force != 0:
                yield k, force

    def _points(self, elements: Elements | None) -> list[int]:
        """The cells of particles and mass centres, which leave traces."""
        if elements is None:
            return []
        return [elements.at(p.position) for p in self.own.configuration.points if p.name not in elements.hidden]


def _force(reaction: Reaction) -> sp.Symbol:
    """The symbol of the single force that a reaction is, otherwise its multiplier."""
    force = reaction.symbol_of_force if reaction.single is not None else None
    return reaction.multiplier if force is None else force


def _values(relations: Sequence[Relation], unknowns: Sequence[sp.Symbol]) -> dict[sp.Symbol, sp.Expr]:
    """What the relations of a branch determine, cos θ = c as θ = arccos c; the page takes the right angle."""
    values: dict[sp.Symbol, sp.Expr] = {}
    inverse = {sp.cos: sp.acos, sp.sin: sp.asin, sp.tan: sp.atan}
    for r in relations:
        left, right = r.lhs, sp.sympify(r.rhs, strict=True)
        if isinstance(left, sp.sin | sp.cos | sp.tan) and left.args[0].is_Symbol:
            left, right = left.args[0], inverse[type(left)](right)
        if isinstance(left, sp.Pow) and left.exp.is_Integer:
            left, right = left.base, right ** (1 / left.exp)
        if left in unknowns:
            values.setdefault(left, right.xreplace(values))
    return values
