"""Reading the parts of a problem file: keys that are known, values of the right kind.

A `Section` is a mapping of the file whose keys are declared by a form. An unknown key is reported with the nearest
declared one, and its value is taken for that one's, so that the same mistake is not reported again as a missing key or
as undeclared names; mistakes inside the value are not reported, for it may be meant otherwise.

Which quantities may occur where: no velocity in a position, nothing variable in a moment of inertia.

    a moment of inertia             parameters
    a mass                          parameters; for a particle that exchanges mass: time, coordinates
    a position, an angle            parameters, time, coordinates
    a potential energy              the same, velocities, and unknown forces
    a Lagrangian                    the same, without unknown forces
    where a force acts              parameters, time, coordinates, unknown forces
    a stiffness, a free length      parameters, time, unknown forces
    a quasi-velocity                parameters, time, coordinates, velocities
    a constraint                    the same, and differentials d(x)
    a force                         parameters, time, coordinates, velocities, unknown forces
    a question, its condition       the same, and accelerations and reactions

No acceleration may occur in any of the others. Prescribed motions u, u', u'' belong to time.
"""

from __future__ import annotations

from collections.abc import Iterable
from enum import StrEnum

import sympy as sp

from lagrange.core.diagnostics import Diagnostic, ProblemError, Span, nearest, suggestion
from lagrange.core.records import record
from lagrange.core.symbols import Slots, base, differential, t, variation
from lagrange.problem.diagnostic_collector import Diagnostics
from lagrange.problem.keys import Assumption
from lagrange.problem.yaml.kinds import Keys
from lagrange.problem.yaml.nodes import ListNode, MappingNode, Node, Scalar


class AllowedQuantity(StrEnum):
    """The kind of a symbol, as far as it decides where the symbol may occur."""

    TIME = "time"
    COORDINATE = "the coordinate"
    VELOCITY = "the velocity"
    ACCELERATION = "the acceleration"
    UNKNOWN = "the unknown force"
    DIFFERENTIAL = "the differential"
    VARIATION = "the virtual displacement"


@record
class Allowed:
    """The quantities that may occur in an expression beside parameters, and the help where another one does."""

    quantities: frozenset[AllowedQuantity]
    help: str
    code: str = "not-allowed-here"


_T, _Q, _V, _P, _D = (
    AllowedQuantity.TIME,
    AllowedQuantity.COORDINATE,
    AllowedQuantity.VELOCITY,
    AllowedQuantity.UNKNOWN,
    AllowedQuantity.DIFFERENTIAL,
)
CONSTANT = Allowed(frozenset(), "it is made of numbers and of names under `parameters:`", "not-constant")
COEFFICIENT = Allowed(frozenset({_P}), "a belt and its drum do not change with position or time", "not-constant")
MASS = Allowed(
    frozenset({_T, _Q}),
    "a mass depends on time and coordinates; for a rate such as k*m*x' make the mass a coordinate with a constraint, "
    "`m' = k*m*x'`, or integrate it first: m_0*exp(k*x)",
)
VARYING_PART = (
    "a rigid body keeps its mass: give the part that varies as a particle that the body carries, `fuel: {mass: m_0 - "
    "q*t, position: r_rocket - a*e1_rocket, leaves: {relative: -u*e1_rocket}}`, or several"
)
MASS_OF_BODY = Allowed(
    frozenset(),
    f"{VARYING_PART}; where what leaves or joins does not change its velocity in a jump, as of a carpet that unrolls, "
    "give T - V as `lagrangian:` instead",
    "not-constant",
)
INERTIA = Allowed(frozenset(), f"{CONSTANT.help}; {VARYING_PART}", "not-constant")
POSITION = Allowed(frozenset({_T, _Q}), "positions depend on coordinates and time")
PLACE = Allowed(frozenset({_T, _Q, _P}), "where a force acts depends on coordinates, time and unknowns")
ENERGY = Allowed(frozenset({_T, _Q, _V, _P}), "it depends on coordinates, velocities and time")
SPRING = Allowed(frozenset({_T, _P}), "a spring is the same wherever it is; give another energy as a `potential:`")
RATE = Allowed(frozenset({_T, _Q, _V}), "it depends on coordinates, velocities and time")
CONSTRAINT = Allowed(frozenset({_T, _Q, _V, _D}), "a constraint relates coordinates, velocities and time")
FORCE = Allowed(frozenset({_T, _Q, _V, _P}), "forces depend on coordinates, velocities and time")
SUBSTITUTION = Allowed(frozenset({_T, _Q}), "it depends on coordinates and time; velocities follow by differentiation")
STATE = Allowed(
    frozenset(AllowedQuantity) - {AllowedQuantity.DIFFERENTIAL, AllowedQuantity.VARIATION},
    "it is made of coordinates, velocities, accelerations, `t`, parameters and names of reactions",
)
ANYTHING = Allowed(frozenset(AllowedQuantity), "")


def kind_of_symbol(symbol: sp.Symbol, slots: Slots, unknowns: Iterable[sp.Symbol]) -> AllowedQuantity | None:
    """The kind of a symbol; None for a parameter."""
    if symbol in unknowns:
        return AllowedQuantity.UNKNOWN
    plain = base(symbol)
    if symbol == t or plain in slots.prescribed:
        return AllowedQuantity.TIME
    if plain in slots.coordinates:
        order = len(symbol.name) - len(plain.name)
        return (AllowedQuantity.COORDINATE, AllowedQuantity.VELOCITY, AllowedQuantity.ACCELERATION)[min(order, 2)]
    if not symbol.name.endswith(")"):
        return None
    moving = (*slots.coordinates, *slots.prescribed, t)
    if symbol in {differential(q) for q in moving}:
        return AllowedQuantity.DIFFERENTIAL
    return AllowedQuantity.VARIATION if symbol in {variation(q) for q in moving} else None


def first_refused(
    expression: sp.Expr, allowed: Allowed, slots: Slots, unknowns: Iterable[sp.Symbol]
) -> tuple[sp.Symbol, AllowedQuantity] | None:
    """The first symbol that is not allowed in an expression, and its kind; None if all are."""
    for symbol in sorted(expression.free_symbols, key=lambda s: str(s.name)):
        kind = kind_of_symbol(symbol, slots, unknowns)
        if kind is not None and kind not in allowed.quantities:
            return symbol, kind
    return None


OTHER_QUESTIONS = {
    **dict.fromkeys(("statics", "static", "rest", "virtual work", "equilibria", "balance"), "equilibrium"),
    **dict.fromkeys(
        ("dynamics", "kinetics", "equations", "equations of motion", "equation of motion", "eom"), "motion"
    ),
    **dict.fromkeys(("oscillations", "small oscillations", "vibrations", "modes", "normal modes"), "linearization"),
    **dict.fromkeys(("frequencies", "frequency", "stability", "linear"), "linearization"),
    **dict.fromkeys(("hamilton", "hamilton s equations", "canonical equations", "momenta"), "hamiltonian"),
    **dict.fromkeys(("steady motion", "steady motions", "stationary", "relative equilibrium"), "steady"),
    **dict.fromkeys(("classification", "degrees of freedom", "dof", "kinematics"), "constraints"),
}
"""What a textbook calls a question, and what a file calls it."""
OTHER_KEYS = {
    "masses": "particles", "rigid_bodies": "bodies", "constants": "parameters",
    "params": "parameters", "variables": "coordinates", "choices": "generalized_coordinates",
    "generalised_coordinates": "generalized_coordinates", "name": "title", "loads": "forces",
    "questions": "ask", "initial_conditions": "initial",
    "g": "gravity", "expect": "answers", "solution": "answers", "solutions": "answers", "text": "description",
    "quasi_velocities": "speeds", "quasivelocities": "speeds",
}  # fmt: skip
"""Keys as one might guess them, of the sections that have those keys."""
ENTRIES_OF_FORCES = {
    **dict.fromkeys(("spring", "springs"), "s: {spring: k, between: [O, P], length: l}"),
    **dict.fromkeys(("damper", "dampers"), "d: {damper: c, between: [O, P]}"),
    **dict.fromkeys(("potential", "potentials"), "field: {potential: k*x^2/2}"),
    **dict.fromkeys(("friction",), "rub: {friction: mu, constraint: plane, on: P}"),
    **dict.fromkeys(("torque", "torques", "moments", "couples"), "drive: {on: wheel, moment: M*k}"),
}
"""Kinds of forces that one might take for sections, each as an entry of `forces`."""
OTHER_ENTRY_KEYS = {
    **dict.fromkeys(("torque", "couple"), "moment"), **dict.fromkeys(("force", "f"), "vector"),
    **dict.fromkeys(("point", "applied_at", "point_of_application"), "at"),
    **dict.fromkeys(("body", "particle", "applied_to"), "on"), **dict.fromkeys(("stiffness", "k"), "spring"),
    **dict.fromkeys(("rest_length", "natural_length", "free_length", "unstretched", "l_0", "l0"), "length"),
    **dict.fromkeys(("ends", "from", "points"), "between"), **dict.fromkeys(("mu", "coefficient"), "friction"),
    **dict.fromkeys(("damping", "dashpot", "c"), "damper"), **dict.fromkeys(("v", "energy"), "potential"),
    **dict.fromkeys(("moment_of_inertia", "i", "j"), "inertia"), **dict.fromkeys(("m", "weight"), "mass"),
    **dict.fromkeys(("r", "pos", "centre", "center", "center_of_mass", "centre_of_mass"), "position"),
    **dict.fromkeys(("orientation", "rotation"), "angle"), **dict.fromkeys(("eq", "condition"), "equation"),
    **dict.fromkeys(("tension", "normal", "multiplier", "normal_force"), "reaction"),
}  # fmt: skip
"""Keys as one might guess them, of the entries of sections that have those keys."""


class Section:
    """A mapping whose keys are known.

    what     what the mapping is, for messages: "the particle `P`"
    form     declares the keys that it may have; only these can be asked for
    strange  the values of other keys that were not taken for one of them
    """

    def __init__(self, node: MappingNode, what: str, form: Keys, diagnostics: Diagnostics) -> None:
        self.node = node
        self.what = what
        self.form = form
        self.diagnostics = diagnostics
        self.strange: list[Node] = []
        self._values = {key.text: (key, value) for key, value in node.entries if key.text in form.names}
        for key, value in node.entries:
            if key.text not in form.names:
                self._unknown(key, value)

    def _unknown(self, key: Scalar, value: Node) -> None:
        message = f"`{key.text}` is not a key of {self.what}"
        help_ = self._help_for(key)
        self.diagnostics.report(Diagnostic("unknown-key", message, key.span, help=help_))
        self.diagnostics.mute(value.span)
        meant = None if help_ is VARYING_PART else nearest(key.text, self.form.names)
        if meant is None or meant in self._values:
            self.strange.append(value)
        else:
            self._values[meant] = (key, value)

    def _help_for(self, key: Scalar) -> str:
        """What was meant by a key: an assumption, a key in other words, or the key that is spelt nearly so."""
        if "assume" in self.form.names and key.text in [*Assumption]:
            return f"write `assume: {key.text}`"
        if "range" in self.form.names and key.text in ("min", "max", "between"):
            return "write `range: [a, b]`"
        if "inertia" in self.form.names and key.text in ("leaves", "gains"):
            return VARYING_PART
        if "vector" in self.form.names and key.text in ("gravity", "weight", "g"):
            return "weights come from the masses: write `gravity: -g*j` beside `forces`, not in it"
        if "forces" in self.form.names and key.text.lower() in ENTRIES_OF_FORCES:
            return f"write it as a force: `forces: {{{ENTRIES_OF_FORCES[key.text.lower()]}}}`"
        if self.what == "`points`" and key.text[:1].isupper():
            return "`points` are the marks of an answer: give a place its name by `let: {r_A: l*i}`"
        for other in (OTHER_KEYS.get(key.text.lower()), OTHER_ENTRY_KEYS.get(key.text.lower())):
            if other in self.form.names:
                return f"write `{other}`"
        return suggestion(key.text, self.form.names, "keys")

    def _entry(self, key: str) -> tuple[Scalar, Node] | None:
        """A key of the form with its value; None if it is absent."""
        assert key in self.form.names, f"`{key}` is not declared as a key of {self.form.title}"
        return self._values.get(key)

    def get(self, key: str) -> Node | None:
        """The value of a key; None if it is absent. A key without a value is reported, and counts as absent."""
        entry = self._entry(key)
        if entry is None:
            return None
        name, value = entry
        if isinstance(value, Scalar) and value.is_empty:
            help_ = f"write `{key}: ...`, or remove the key"
            self.diagnostics.report(Diagnostic("empty-value", f"`{key}` has no value", name.span, help=help_))
            return None
        return value

    def section(self, key: str) -> Node | None:
        """The value of a key that may be left empty, as a section whose entries are all commented out is."""
        entry = self._entry(key)
        if entry is None or (isinstance(entry[1], Scalar) and entry[1].is_empty):
            return None
        return entry[1]

    def required(self, key: str, span: Span, example: str = "") -> Node:
        """The value of a required key; `span` is blamed where it is missing. Raises ProblemError.

        example  the value to suggest, where the declared one does not fit
        """
        value = self.get(key)
        if value is not None:
            return value
        if self.has(key):
            raise ProblemError(())  # its value is missing, which has been reported
        message = f"{self.what} has no `{key}`"
        raise ProblemError(
            Diagnostic("missing-key", message, span, help=f"add `{key}: {example or self.form.example(key)}`")
        )

    def has(self, key: str) -> bool:
        """Whether a key is present."""
        return self._entry(key) is not None

    def span_of(self, key: str) -> Span:
        """The place of a key that is present."""
        return self._values[key][0].span

    def text(self, key: str) -> str:
        """A value that is text, on one line; empty if the key is absent."""
        value = self.section(key)
        if value is None:
            return ""
        scalar = self.diagnostics.attempt(lambda: scalar_of(value, f"`{key}`"))
        return " ".join(scalar.text.split()) if scalar else ""


def scalar_of(node: Node, what: str) -> Scalar:
    """The node as a scalar. Raises ProblemError if it is a list or a mapping."""
    if isinstance(node, Scalar):
        if node.is_empty:
            raise ProblemError(Diagnostic("empty-value", f"{what} is empty", node.span, help="write its value"))
        return node
    raise ProblemError(wrong_kind(node, f"{what} is one value", "write one value"))


def items_of(node: Node, what: str, example: str) -> tuple[Node, ...]:
    """The items of a list. Raises ProblemError if the node is not a list."""
    if isinstance(node, ListNode):
        return node.items
    raise ProblemError(wrong_kind(node, f"{what} is a list", f"write `{example}`"))


def entries_of(node: Node, what: str, example: str) -> tuple[tuple[Scalar, Node], ...]:
    """The entries of a mapping. Raises ProblemError if the node is not a mapping."""
    return mapping_of(node, what, example).entries


def mapping_of(node: Node, what: str, example: str) -> MappingNode:
    """The node as a mapping. Raises ProblemError if it is not one."""
    if isinstance(node, MappingNode):
        return node
    raise ProblemError(wrong_kind(node, f"{what} is a mapping", f"write `{example}`"))


def wrong_kind(node: Node, message: str, help: str) -> Diagnostic:
    """The diagnostic for a list where a value belongs, and the like."""
    match node:
        case Scalar():
            label = "this is one value"
        case ListNode():
            label = "this is a list"
        case _:
            label = "this is a mapping"
    return Diagnostic("wrong-kind", message, node.span, label, help)
