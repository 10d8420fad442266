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

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import sympy as sp

from lagrange.algebra.closed_forms.single_equation import Relation
from lagrange.animation.elements import Elements
from lagrange.animation.figure import EquilibriumButton, MovingFigure, Slider, Still
from lagrange.animation.javascript import UnprintableError, function, names_of
from lagrange.animation.limits import LONGEST_PROGRAM, MOST_COORDINATES, MOST_OPERATIONS
from lagrange.animation.samples import Samples, put, sampled, samples, surfaces
from lagrange.animation.values import angles_in, coordinate_slider, initial_state, parameter_slider, slipping, spins
from lagrange.core.symbols import Sign, Slots, Unspecified, prime, t
from lagrange.core.vectors import Vector
from lagrange.mechanics.dynamics.conservation import ConservedQuantity, Integral
from lagrange.mechanics.dynamics.energies import potential_energy
from lagrange.mechanics.dynamics.lagrangian import kinetic_energy
from lagrange.mechanics.dynamics.newton import Reaction
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from lagrange.mechanics.results import InCoordinates, Solution
from lagrange.pictures.floats import NoValueError
from lagrange.pictures.poses import Pose
from lagrange.pictures.systems import SystemPicture, system_in_file, system_posed_in_choice
from lagrange.problem.model import Keeper


def moving_figure(solution: Solution) -> MovingFigure | Still:
    """The figure that moves, or why there is none."""
    if len(solution.own.configuration.slots.coordinates) > MOST_COORDINATES:
        return Still("the system has too many coordinates")
    view = _best(solution)
    try:
        return _Maker(solution, view).made()
    except (UnprintableError, NoValueError) as error:
        return Still(str(error))


def _best(solution: Solution) -> InCoordinates:
    """Free coordinates without square roots, otherwise those of the file."""

    def rank(v: InCoordinates) -> tuple[bool, bool, int]:
        done = v.dynamics is not None or v.equilibrium is not None
        return (not done, bool(v.signs), len(v.configuration.rows))

    return min(solution.views, key=rank)


@dataclass
class _Maker:
    """Makes the figure of one solution in one set of coordinates."""

    solution: Solution
    view: InCoordinates
    functions: dict[str, str] = field(default_factory=dict)
    rule: dict[sp.Basic, sp.Basic] = field(default_factory=dict)
    drives: list[Slider] = field(default_factory=list)
    drive_symbols: list[sp.Symbol] = field(default_factory=list)
    samples: Samples = field(default_factory=dict)
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
        self.samples = samples(self.solution)
        system, pose = self._posed()
        if system is None and view.dynamics is None:
            raise UnprintableError("there is no drawing of this system")
        drawn = dict(system.pose.values) if system else {}
        slots = view.configuration.slots
        self._drive(slots, drawn)
        expressions = self._expressions(system, pose)
        signs = view.dynamics.signs if view.dynamics else {}
        symbols = sorted(
            set().union(*(e.free_symbols for group in expressions.values() for e in group)) - self._state_symbols(),
            key=str,
        )
        self._refuse_unknown(symbols, signs)
        along = {s for _, names in (self.elements.curves if self.elements else ()) for s in names}
        parameters = [s for s in symbols if s not in along]
        names = self._names(parameters)
        return self._assembled(expressions, names, parameters, drawn, pose, system)

    # What the page has to know

    def _posed(self) -> tuple[SystemPicture | None, Pose | None]:
        solution = sampled(self.solution, self.samples)
        if self.view.is_own:
            system = system_in_file(solution)
            return system, None if system is None else system.pose
        posed = system_posed_in_choice(solution, self.view.coordinates.configuration)
        return posed if posed is not None else (system_in_file(solution), None)

    def _drive(self, slots: Slots, drawn: Mapping[sp.Symbol, float]) -> None:
        """Prescribed motions u(t) become u_0 + a sin(w t), each with its own mean, amplitude and circular frequency."""
        for u in slots.prescribed:
            mean, size, rate = (sp.Dummy(f"{u.name}_{what}", real=True) for what in ("mean", "amplitude", "frequency"))
            motion = mean + size * sp.sin(rate * t)
            for order in range(5):
                self.rule[prime(u, order) if order else u] = motion.diff(t, order) if order else motion
            start = drawn.get(u, 0.5)
            for symbol, what, value, low, high in (
                (mean, "mean of", start, -2 * abs(start) - 0.5, 2 * abs(start) + 0.5),
                (size, "amplitude of", 0.3, 0.0, 1.0),
                (rate, "frequency of", 2.0, 0.0, 6.0),
            ):
                self.drive_symbols.append(symbol)
                self.drives.append(Slider(u, value, low, high, meaning=what))

    def _state_symbols(self) -> set[sp.Symbol]:
        view, own = self.view.configuration.slots, self.own.configuration.slots
        return {*view.coordinates, *view.velocities, *own.coordinates, *own.velocities, t}

    def _names(self, parameters: Sequence[sp.Symbol]) -> dict[str, dict[sp.Symbol, str]]:
        view, own = self.view.configuration.slots, self.own.configuration.slots
        p = names_of("p", parameters)
        y = names_of("y", (*view.coordinates, *view.velocities, t))
        z = names_of("z", (*own.coordinates, *own.velocities, t, *(() if self.view.is_own else view.coordinates)))
        return {"y": {**p, **y}, "z": {**p, **z}, "p": p}

    def _refuse_unknown(self, symbols: Iterable[sp.Symbol], signs: Mapping[Sign, sp.Expr]) -> None:
        for s in symbols:
            if s in signs:
                raise UnprintableError("the sense of a friction force depends on the motion")
            if s.name.endswith("'"):
                raise UnprintableError(f"the velocity {s.name} is not determined")

    def put(self, e: sp.Expr) -> sp.Expr:
        """An expression with the prescribed motions that the page takes."""
        e = put(sp.sympify(e, strict=True), self.samples)
        return e.xreplace(self.rule) if self.rule else e

    # Expressions of all functions, by name

    def _expressions(self, system: SystemPicture | None, pose: Pose | None) -> dict[str, list[sp.Expr]]:
        view, configuration = self.view, self.view.configuration
        out: dict[str, list[sp.Expr]] = {}
        if not view.is_own:
            out["own"] = self._own()
        if view.dynamics is not None:
            out["eq"] = self._equations(view, "eq")
            out["con"] = self._constraints(view)
            if not view.is_own and self.own.dynamics is not None:
                out["rea"] = self._equations(self.own, "rea")
        else:
            out["con"] = self._constraints(view)
            if view.equilibrium is not None:
                out["sta"] = self._statics()
        out["sli"] = self._slips()
        potential = potential_energy(configuration)
        self.potential = self.put(potential)
        kinetic = kinetic_energy(configuration) if view.dynamics is not None else sp.S.Zero
        integrals = view.conserved.integrals if view.conserved else ()
        fast = {*configuration.slots.accelerations}
        self.integrals = [i for i in integrals if not i.expression.free_symbols & fast]
        out["ene"] = [self.put(e) for e in (kinetic, potential, *(i.expression for i in self.integrals))]
        out["ini"] = self._stated()
        self.elements = None if system is None else Elements(system, pose)
        out["act"] = self._acting()
        if self.elements is not None and system is not None:
            elements = self.elements
            for point, along, shift in surfaces(system.configuration) if self.samples else ():
                if not system.view.planar:
                    ends = (shift - 2, shift + 2, sp.Integer(-2), sp.Integer(2))
                    elements.surface(Vector(point), along, ends)
            try:
                elements.all()
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
        assert view.dynamics is not None
        form = view.dynamics.matrices
        unused = view.dynamics.equations.elimination.unused
        used = [n for n in range(len(form.configuration.rows)) if n not in unused]
        self.shape[name] = [len(form.force), len(used)]
        rows = [e for n in used for e in form.constraint_matrix[n]]
        parts = [*(e for row in form.mass for e in row), *form.force, *rows, *(form.constraint_vector[n] for n in used)]
        return [self.put(e) for e in parts]

    def _used(self, view: InCoordinates) -> list[int]:
        return [n for n in range(len(view.configuration.rows)) if n not in view.elimination.unused]

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
        """The speeds of slip, positive in the sense that the file states; of a slip in a plane its square."""
        forces = self.view.dynamics.friction_forces if self.view.dynamics is not None else ()
        self.slips = [2 if f.speed is None else 1 if f.sense.is_number else 0 for f in forces]
        return [self.put(f.slip.dot(f.slip) if f.speed is None else f.speed * f.sense if f.sense.is_number else f.speed)
                for f in forces]  # fmt: skip

    def _guards(self) -> list[int]:
        """For each reaction when the equations cease to hold; 0: never.

        1 or -1: where λ does not have this sign. 2: where the force is negative. 3: where it changes its sign, as it
        cannot pull on what lies on a surface.
        """
        frictions = self.view.dynamics.friction_forces if self.view.dynamics is not None else ()
        pressed = {f.reaction.name: int(f.contact) for f in frictions if f.contact.is_Integer}
        signs = []
        for r in self.reaction_list:
            side = r.constraint.side or pressed.get(r.name, 0)
            pulls = r.constraint.by is Keeper.STRING and r.tension is not None
            signs.append(side or (2 if pulls else 3 if r.constraint.by is Keeper.SURFACE else 0))
        return signs

    def _equilibria(self) -> dict[str, list[sp.Expr]]:
        """The coordinates of each equilibrium in closed form, and the unknown forces there."""
        out: dict[str, list[sp.Expr]] = {}
        equilibrium = self._equilibrium()
        if equilibrium is None:
            return out
        coordinates = self.view.configuration.slots.coordinates
        verdicts = self.view.stability.verdicts if self.view.stability is not None else ()
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

    def _equilibrium(self) -> Equilibrium | None:
        view = self.view
        return view.equilibrium or (view.linearization.equilibrium if view.linearization else None)

    # Everything together

    def _assembled(
        self,
        expressions: Mapping[str, Sequence[sp.Expr]],
        names: Mapping[str, Mapping[sp.Symbol, str]],
        parameters: Sequence[sp.Symbol],
        drawn: Mapping[sp.Symbol, float],
        pose: Pose | None,
        system: SystemPicture | None,
    ) -> MovingFigure:
        problem, configuration = self.solution.problem, self.view.configuration
        slots = configuration.slots
        operations = sum(sp.count_ops(e) for group in expressions.values() for e in group)
        if operations > MOST_OPERATIONS:
            raise UnprintableError("its equations are too long")
        code = []
        for name, group in expressions.items():
            if name.startswith("cur"):
                assert self.elements is not None
                along = names_of("u", self.elements.curves[int(name[3:])][1])
                code.append(f"{name}: {function('z, p, u', group, {**names['z'], **along})}")
            elif name == "ini":
                code.append(f"{name}: {function('p', group, names['p'])}")
            elif name in ("rea", "fig", "act") or name.startswith("tra"):
                code.append(f"{name}: {function('z, p', group, names['z'])}")
            else:
                code.append(f"{name}: {function('y, p', group, names['y'])}")
        written = "{\n" + ",\n".join(code) + "\n}"
        if len(written) > LONGEST_PROGRAM:
            raise UnprintableError("its equations are too long")
        everything = [e for group in expressions.values() for e in group]
        angles = angles_in(everything)
        drives = dict(zip(self.drive_symbols, self.drives, strict=True))
        knobs = [drives.get(s) or parameter_slider(s, problem, drawn, s in angles) for s in parameters]
        numbers = {s: k.value for s, k in zip(parameters, knobs, strict=True)} | {t: 0.0}
        start = {} if pose is None else {q: pose.values[q] for q in pose.coordinates if q in pose.values}
        state = initial_state(problem, configuration, start, numbers, self.potential)
        released = bool(self.begins or self.wanted)
        if not released:
            known = (
                [e if kind else sp.Abs(e) for e, kind in zip(expressions["sli"], self.slips, strict=True)]
                if self.slips
                else []
            )
            state = slipping(state, slots.velocities, known, numbers)
        sliders = tuple(coordinate_slider(q, problem, state[q], q in angles) for q in slots.coordinates)
        elements = self.elements
        planar = system.view if system else None
        data = {
            "n": len(slots.coordinates),
            "shape": self.shape,
            "kept": self._kept(slots),
            "y": [state[s] for s in (*slots.coordinates, *slots.velocities)] + [0.0],
            "p": [k.value for k in knobs],
            "angles": [int(s.angle) for s in sliders],
            "items": elements.items if elements else [],
            "rest": int(self.view.dynamics is not None and not self.buttons and self._may_rest(expressions)),
            "along": [len(names_) for _, names_ in elements.curves] if elements else [],
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
            "guards": self._guards(),
            "slips": self.slips,
            "timed": int(any(e.has(t) for e in expressions.get("eq", ()))),
            "begins": self.begins,
            "wanted": self.wanted,
            "sizes": len(self.own.configuration.slots.coordinates),
            "points": self._points(elements),
            "conserved": [self._kind(i.quantity) for i in self.integrals],
            "buttons": [
                [slots.coordinates.index(s) if s in slots.coordinates else -1 - parameters.index(s) for s in values]
                for values in self.button_parts
            ],
            "moves": int(self.view.dynamics is not None),
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
            moves=self.view.dynamics is not None,
            rests=self.view.equilibrium is not None,
            released=released,
            assumed=self._assumed(),
        )

    def _assumed(self) -> tuple[tuple[sp.Expr, sp.Expr], ...]:
        """What is taken for functions and prescribed motions that the file leaves open."""
        functions = (
            (Unspecified.of(name, [a.name for a in names], *names), value)
            for name, (names, value) in self.samples.items()
        )
        return tuple(functions)

    def _may_rest(self, expressions: Mapping[str, Sequence[sp.Expr]]) -> bool:
        """Whether the page looks for positions of rest itself: few free coordinates, forces without time."""
        free = self.shape["eq"][1] == 0 and len(self.view.configuration.slots.coordinates) <= 3
        return free and not self.slips and not any(e.has(t) for e in expressions["eq"])

    def _points(self, elements: Elements | None) -> list[int]:
        """The cells of the particles and mass centres: what leaves a trace."""
        if elements is None:
            return []
        return [elements.at(p.position) for p in self.own.configuration.points if p.name not in elements.hidden]

    def _kept(self, slots: Slots) -> int:
        """The velocity that stays when the others are fitted to the constraints: that of a spin; -1 for none."""
        turning = spins(self.view.configuration)
        return slots.coordinates.index(turning[0]) if turning else -1

    @staticmethod
    def _kind(quantity: ConservedQuantity) -> int:
        return int(quantity in (ConservedQuantity.ENERGY, ConservedQuantity.JACOBI))


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
