"""Reading `let`, `particles` and `bodies`, which may refer to one another.

An abbreviation may use the position r_P of a particle, and a position may use an abbreviation or another position. Each
entry is read once, after those whose names it uses; entries that are defined by one another are an error.

A body adds vectors to the language: its position, its angular velocity and its axes (`core.vectors`). How it is turned
is read apart from where it is, because its position may use its axes. A planar body has an angle about k; in space it
has a sequence of three rotations about body axes, or the file gives the triad of the inertia and the angular velocity.

Its inertia is one moment about k, three principal moments, or a symmetric matrix. An inertia that no distribution of
mass can have is refused where the file's numbers, or the signs of its parameters, make a kinetic energy negative. A
moment that exceeds the sum of the other two is a note: the equations hold all the same.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from functools import cached_property, partial
from itertools import product

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError
from lagrange.algebra.fourier.vector_cleanup import tidied
from lagrange.core.diagnostics import Diagnostic, ProblemError, Severity
from lagrange.core.inertia import NO_PRODUCTS, InertiaTensor, Three, moments_of_mass, principal_minors
from lagrange.core.printable import is_hidden
from lagrange.core.records import record
from lagrange.core.vectors import Vector, axis_names, names_before_last
from lagrange.problem.keys import BODY, EXCHANGE, ORIENTATION, PARTICLE, SEQUENCES, WAYS_OF_TURNING
from lagrange.problem.limits import MAX_WORDS_LENGTH
from lagrange.problem.load_context import LoadContext, SpokenName, names_in
from lagrange.problem.model import Body, Exchange, Particle
from lagrange.problem.sections import (
    CONSTANT,
    INERTIA,
    MASS,
    MASS_OF_BODY,
    POSITION,
    RATE,
    Allowed,
    Section,
    entries_of,
    items_of,
    mapping_of,
    scalar_of,
    wrong_kind,
)
from lagrange.problem.yaml.nodes import ListNode, MappingNode, Node, Scalar, scalars

_EXAMPLE = "{mass: m, inertia: I_G, position: x*i + y*j, angle: theta}"
_INERTIA = "write `inertia: [A, B, C]`, or a matrix `inertia: [[A, F, E], [F, B, D], [E, D, C]]`"
_TURNING = (
    "a planar body has one moment of inertia and `angle`; a body in space has three or a matrix, and `orientation`, "
    "or `axes` with `angular_velocity`"
)


def names_of_turning(name: str, node: Node) -> dict[str, str]:
    """The vectors that a body adds to the language beside its position: name -> description."""
    described = {f"omega_{name}": f"the angular velocity of `{name}`"}
    described |= dict.fromkeys(axis_names(name), f"an axis of the body `{name}`")
    if isinstance(node, MappingNode) and any(key.text == "orientation" for key, _ in node.entries):
        described |= dict.fromkeys(names_before_last(name), f"an axis before the last rotation of `{name}`")
    return described


class _BodyBeingRead:
    """One entry of `bodies`, whose orientation and position are read at different times."""

    def __init__(self, name: str, key: Scalar, node: Node, context: LoadContext) -> None:
        self.name = name
        self.key = key
        self.node = node
        self.context = context
        self._body: Body | None = None

    @cached_property
    def _section(self) -> Section:
        what = f"the body `{self.name}`"
        return Section(mapping_of(self.node, what, f"{self.name}: {_EXAMPLE}"), what, BODY, self.context.diagnostics)

    def turning(self) -> Mapping[str, Vector]:
        """Reads everything but the position. Returns the vectors that this adds to the language."""
        section, context = self._section, self.context
        keep_shape(section, self.name, context)
        self.name = keep_words(section, self.name, context)
        mass, (inertia, products) = context.diagnostics.all_of(
            lambda: mass_of(section.get("mass"), self.name, context),
            lambda: _inertia(section.get("inertia"), section, context),
        )
        if mass != 0 and not section.has("inertia"):
            context.without_inertia[self.name] = self.key.span
        body = Body(self.name, mass, Vector.zero(), inertia, self.key.span, products)
        self._body = _turned_body(body, section, context)
        turned = self._body.orientation(context.scope.slots)
        return {f"omega_{self.name}": turned.angular_velocity, **turned.vectors}

    def position(self) -> Vector:
        """Reads the position of the mass centre."""
        node = self._section.required("position", self.key.span)
        return self.context.vector(node, f"the position of `{self.name}`")

    def at(self, position: Vector) -> Body | None:
        """The body; None if the rest of it could not be read."""
        return None if self._body is None else replace(self._body, position=position)


def keep_shape(section: Section, name: str, context: LoadContext) -> None:
    """Keeps the shape of a particle or body, which may be given in vectors that are not read yet."""
    node = section.get("shape")
    if node is not None:
        context.shapes[name] = node


_CALLED = "write a few words for a sentence, without a full stop: `name: upper particle`"


def keep_words(section: Section, name: str, context: LoadContext) -> str:
    """The name of a particle or body, with the words that `name:` gives for it; they are kept for the forces on it."""
    node = section.get("name")
    if node is None:
        return name
    called = context.diagnostics.attempt(lambda: SpokenName(name, _words(node, name, context)))
    if called is not None:
        context.called[name] = called
    return called or name


def _words(node: Node, name: str, context: LoadContext) -> str:
    """The words, checked. Raises ProblemError if they are none, or not for one line of a page."""
    scalar = scalar_of(node, f"`name` of `{name}`")
    words = scalar.text.strip()
    same = next((n for n, c in context.called.items() if c.words.casefold() == words.casefold()), "")
    if "\n" in words:
        message = f"the words for `{name}` have several lines"
    elif any(is_hidden(c) for c in words):
        message = f"the words for `{name}` contain a control character"
    elif len(words) > MAX_WORDS_LENGTH:
        message = f"the words for `{name}` are longer than {MAX_WORDS_LENGTH} characters"
    elif not any(c.isalpha() for c in words):
        message = f"the words for `{name}` contain no letter"
    elif same:
        message = f"`{same}` and `{name}` are both called `{words}`"
    else:
        return " ".join(words.split())
    raise ProblemError(Diagnostic("words-for-body", message, node.span, help=_CALLED))


def constant(node: Node, what: str, context: LoadContext, allowed: Allowed = CONSTANT) -> sp.Expr:
    """An expression that is not negative, constant by default. Raises ProblemError if it is not one."""
    value = context.scalar(node, what, allowed)
    if value.xreplace(context.values).is_negative:
        shown = "" if value.is_negative else ", with the values that the file gives"
        raise ProblemError(Diagnostic("negative", f"{what} is negative{shown}", node.span, help="change its sign"))
    return value


def mass_of(node: Node | None, name: str, context: LoadContext, allowed: Allowed = MASS_OF_BODY) -> sp.Expr:
    """The mass of a particle or body; 0 where the file gives none."""
    return sp.S.Zero if node is None else constant(node, f"the mass of `{name}`", context, allowed)


def _inertia(node: Node | None, section: Section, context: LoadContext) -> tuple[tuple[sp.Expr, ...], Three]:
    """One moment or three, zero where none is given, and the elements J_23, J_31, J_12 off the diagonal.

    Raises ProblemError.
    """
    if node is None:
        return (sp.S.Zero,) * (1 if section.has("angle") else 3), NO_PRODUCTS
    if isinstance(node, Scalar) and node.text.lstrip().startswith("["):
        message = "`inertia` must be a list here, not a text"
        raise ProblemError(Diagnostic("inertia", message, node.span, help="write `inertia: [A, B, C]` without quotes"))
    if not isinstance(node, ListNode):
        return (constant(node, "a moment of inertia", context, INERTIA),), NO_PRODUCTS
    if len(node.items) != 3:
        message = f"`inertia` has one moment, or three principal moments, not {len(node.items)}"
        raise ProblemError(Diagnostic("inertia", message, node.span, help=_INERTIA))
    if any(isinstance(row, ListNode) for row in node.items):
        tensor = _matrix(node, context)
    else:
        a, b, c = (constant(item, "a moment of inertia", context, INERTIA) for item in node.items)
        tensor = InertiaTensor((a, b, c))
    _check_possible(tensor, node, context)
    return tensor.moments, tensor.products


def _matrix(node: ListNode, context: LoadContext) -> InertiaTensor:
    """A symmetric matrix, row by row."""
    rows = [row.items for row in node.items if isinstance(row, ListNode) and len(row.items) == 3]
    if len(rows) != 3:
        message = "a matrix `inertia` has three rows of three elements each"
        raise ProblemError(Diagnostic("inertia", message, node.span, help=_INERTIA))
    reads = (
        (lambda m=m, n=n: constant(rows[m][n], "a moment of inertia", context, INERTIA))
        if m == n
        else (lambda m=m, n=n: context.scalar(rows[m][n], "an element of the tensor of inertia", INERTIA))
        for m, n in product(range(3), repeat=2)
    )
    elements = context.diagnostics.all_of(*reads)
    for m, n in ((0, 1), (0, 2), (1, 2)):
        above, below = elements[3 * m + n], elements[3 * n + m]
        if above != below and context.is_zero(above - below) is not True:
            message = f"the tensor of inertia is symmetric, but its elements {m + 1}{n + 1} and {n + 1}{m + 1} differ"
            help_ = (
                "write the same element in both places; off the diagonal it is minus the product of inertia: "
                "J_xy = -(sum of m*x*y)"
            )
            raise ProblemError(Diagnostic("inertia", message, rows[n][m].span, help=help_))
    a, b, c = elements[0::4]
    return InertiaTensor((a, b, c), (elements[5], elements[2], elements[1]))


def _check_possible(tensor: InertiaTensor, node: Node, context: LoadContext) -> None:
    """Refuses a tensor with negative kinetic energies; a note where the moments exceed what masses can have."""
    valued = InertiaTensor(_valued(tensor.moments, context), _valued(tensor.products, context))
    if any(m.is_negative for m in principal_minors(sp.Matrix(valued.rows))):
        message = "no body has this tensor of inertia: its rotation about some axis would have negative energy"
        help_ = "check the elements off the diagonal: J_xy^2 is at most J_xx*J_yy"
        raise ProblemError(Diagnostic("impossible-inertia", message, node.span, help=help_))
    if any(m.is_negative for m in principal_minors(moments_of_mass(valued))):
        message = "no distribution of mass has this inertia: a principal moment is larger than the sum of the other two"
        help_ = "check the moments: A <= B + C, B <= C + A, C <= A + B, with equality for a flat body"
        note = Diagnostic("impossible-inertia", message, node.span, help=help_, level=Severity.NOTE)
        context.diagnostics.report(note)


def _valued(elements: Three, context: LoadContext) -> Three:
    a, b, c = (e.xreplace(context.values) for e in elements)
    return a, b, c


def _turned_body(body: Body, section: Section, context: LoadContext) -> Body:
    """The body with its orientation. Raises ProblemError if that is not clear."""
    given = tuple(key for way in WAYS_OF_TURNING for key in way if section.has(key))
    planar = len(body.inertia) == 1
    for way, read in zip(WAYS_OF_TURNING, (_with_angle, _with_orientation, _with_axes), strict=True):
        if given == way and planar == (read is _with_angle):
            return read(body, section, context)
    message = f"it is not clear how the body `{body.name}` is turned"
    raise ProblemError(Diagnostic("orientation", message, body.span, help=_TURNING))


def _with_angle(body: Body, section: Section, context: LoadContext) -> Body:
    angle = context.scalar(section.required("angle", body.span), f"the angle of `{body.name}`", POSITION)
    return replace(body, angle=angle)


def _with_orientation(body: Body, section: Section, context: LoadContext) -> Body:
    node = section.required("orientation", body.span)
    mapping = mapping_of(node, "`orientation`", f"orientation: {BODY.example('orientation')}")
    inner = Section(mapping, "the orientation", ORIENTATION, context.diagnostics)
    sequence = _sequence(inner.required("axes", node.span))
    angles_node = inner.required("angles", node.span)
    items = items_of(angles_node, "`angles`", "angles: [phi, theta, psi]")
    if len(items) != 3:
        message = f"an orientation has three angles, not {len(items)}"
        help_ = "write `angles: [phi, theta, psi]`"
        raise ProblemError(Diagnostic("orientation", message, angles_node.span, help=help_))
    angles = tuple(context.scalar(i, f"an angle of `{body.name}`", POSITION) for i in items)
    return replace(body, sequence=sequence, angles=angles)


def _sequence(node: Node) -> str:
    scalar = scalar_of(node, "`axes`")
    if scalar.text not in SEQUENCES:
        message = f"`{scalar.text}` is not a sequence of rotations"
        help_ = f"it is one of {', '.join(SEQUENCES)}: neighbouring axes differ"
        raise ProblemError(Diagnostic("unknown-sequence", message, scalar.span, help=help_))
    return scalar.text


def _with_axes(body: Body, section: Section, context: LoadContext) -> Body:
    node = section.required("axes", body.span)
    items = items_of(node, "`axes`", "axes: [e1, e2, e3]")
    if len(items) != 3:
        raise ProblemError(wrong_kind(node, f"`axes` has three vectors, not {len(items)}", "write `[e1, e2, e3]`"))
    a, b, c = (context.vector(i, f"an axis of `{body.name}`") for i in items)
    _check_triad((a, b, c), node, context)
    spin_node = section.required("angular_velocity", body.span)
    spin = context.vector(spin_node, f"the angular velocity of `{body.name}`", RATE)
    names = tuple(item.text for item in items if isinstance(item, Scalar) and item.text in context.scope.vectors)
    called = names if len(set(names)) == 3 else ()
    return replace(body, axes=(a, b, c), axes_called=called, angular_velocity=spin)


def _check_triad(axes: tuple[Vector, Vector, Vector], node: Node, context: LoadContext) -> None:
    """Raises ProblemError if axes are not a right-handed triad of unit vectors. What is undecided passes."""
    wanted = [(axes[m].dot(axes[n]), int(m == n)) for m in range(3) for n in range(m, 3)]
    if any(_differs(value, number, context) for value, number in wanted):
        message = "these axes are not perpendicular unit vectors"
        help_ = "check their lengths and the angles between them"
    elif _differs(axes[0].cross(axes[1]).dot(axes[2]), 1, context):
        message, help_ = "these axes are left-handed", "reverse or exchange two of them"
    else:
        return
    raise ProblemError(Diagnostic("axes", message, node.span, help=help_))


def _differs(value: sp.Expr, number: int, context: LoadContext) -> bool:
    try:
        return context.is_zero(value - number) is False
    except DivisionByZeroError:
        return True


_PARTICLE = "P: {mass: m, position: x*i + y*j}"
_BODY = "B: {mass: m, inertia: I_G, position: x*i + y*j, angle: theta}"


@record
class Things:
    """The particles, bodies and abbreviations of a file, in its order."""

    particles: tuple[Particle, ...]
    bodies: tuple[Body, ...]
    abbreviations: Mapping[str, sp.Expr | Vector]


@record
class _Entry:
    """An entry that waits to be read: the names that it defines, and those that it uses."""

    key: Scalar
    defines: tuple[str, ...]
    uses: frozenset[str]
    read: Callable[[], None]


def read_things(root: Section, context: LoadContext) -> Things:
    """The abbreviations go into the scope, particles and bodies are returned."""
    particles: dict[str, Particle] = {}
    bodies: dict[str, Body] = {}
    short: dict[str, sp.Expr | Vector] = {}
    entries = [
        *_abbreviations(root, context, short),
        *_particles(root, context, particles),
        *_bodies(root, context, bodies),
    ]
    for entry in _in_order(entries, context):
        try:
            entry.read()
        except ProblemError as error:
            context.diagnostics.report_all(error.diagnostics)
            context.names.fail(*entry.defines)
    known = context.things.known()
    return Things(
        tuple(particles[n] for n in known if n in particles), tuple(bodies[n] for n in known if n in bodies), short
    )


def _entries(root: Section, key: str, example: str, context: LoadContext) -> tuple[tuple[Scalar, Node], ...]:
    node = root.section(key)
    if node is None:
        return ()
    entries = context.diagnostics.attempt(lambda: entries_of(node, f"`{key}`", f"{key}: {{{example}}}"))
    if entries is None:
        context.names.fail_all(node)
    return entries or ()


def _abbreviations(root: Section, context: LoadContext, abbreviations: dict[str, sp.Expr | Vector]) -> Iterator[_Entry]:
    for key, node in _entries(root, "let", 'n: "sin(theta)*i - cos(theta)*j"', context):
        name = context.names.declare(key, "an abbreviation")
        if name is not None:
            yield _Entry(key, (name,), _uses(node), partial(_read_abbreviation, name, node, context, abbreviations))


def _read_abbreviation(name: str, node: Node, context: LoadContext, abbreviations: dict[str, sp.Expr | Vector]) -> None:
    value = context.value(node, f"`{name}`")
    if isinstance(value, Vector):
        value = value.map(tidied)
        context.add_vectors({name: value})
    else:
        context.add_scalars({name: value})
    abbreviations[name] = value


def _particles(root: Section, context: LoadContext, particles: dict[str, Particle]) -> Iterator[_Entry]:
    for key, node in _entries(root, "particles", _PARTICLE, context):
        name = context.things.declare(key, "a particle")
        if name is None:
            continue
        context.points[name] = None
        named = _named_vectors({f"r_{name}": f"the position of `{name}`"}, key, context)
        if named is None:
            continue
        of_position, of_mass = _names_used(node)
        yield _Entry(key, named, of_position | of_mass, partial(_read_particle, name, key, node, context, particles))


def _named_vectors(described: Mapping[str, str], key: Scalar, context: LoadContext) -> tuple[str, ...] | None:
    """Those names of the vectors of a particle or body that no symbol has; None where one clashes (reported)."""
    taken = [name for name in described if context.names.is_symbol(name)]
    for name in taken:
        context.names.report_symbol(name, described[name], key.span)
    added = [context.names.add(name, what, key.span) for name, what in described.items() if name not in taken]
    return tuple(name for name in described if name not in taken) if all(added) else None


def _read_particle(name: str, key: Scalar, node: Node, context: LoadContext, particles: dict[str, Particle]) -> None:
    mapping = mapping_of(node, f"the particle `{name}`", f"{name}: {{mass: m, position: x*i + y*j}}")
    section = Section(mapping, f"the particle `{name}`", PARTICLE, context.diagnostics)
    mass = context.diagnostics.attempt(lambda: mass_of(section.get("mass"), name, context, MASS))
    keep_shape(section, name, context)
    name = keep_words(section, name, context)
    position = context.vector(section.required("position", key.span), f"the position of `{name}`")
    context.points[name] = position
    context.add_vectors({f"r_{name}": position})
    if mass is not None:
        exchange = context.diagnostics.attempt(lambda: _exchange(mass, section, key, context))
        particles[name] = Particle(name, mass, position, key.span, exchange)


_LAW = "give the velocity of that mass: `leaves: {relative: -u*j}`, or `gains: {velocity: 0}` where it was at rest"


def _exchange(mass: sp.Expr, section: Section, key: Scalar, context: LoadContext) -> Exchange | None:
    """How a particle loses or gains mass; None if its mass is constant.

    Raises ProblemError if the mass varies and the file does not say with what velocity mass leaves or joins, and
    where what it says contradicts the mass.
    """
    rate = context.scope.slots.time_derivative(mass)
    given = [way for way in ("leaves", "gains") if section.has(way)]
    node = section.get("mass")
    span = node.span if node is not None else key.span
    if not given:
        if rate == 0:
            return None
        message = f"the mass of `{key.text}` varies, but nothing says with what velocity mass leaves or joins it"
        raise ProblemError(Diagnostic("variable-mass", message, span, help=_LAW))
    if len(given) > 1:
        message, help_ = f"`{key.text}` both loses and gains mass", "keep the one of them that changes its mass"
        raise ProblemError(Diagnostic("mass-exchange", message, section.span_of("gains"), help=help_))
    [way] = given
    at = section.span_of(way)
    if rate == 0:
        message = f"`{key.text}` has `{way}`, but its mass is constant"
        help_ = "give the mass as a function of time or of a coordinate, such as `mass: m_0 - q*t`"
        raise ProblemError(Diagnostic("mass-exchange", message, at, help=help_))
    if rate.is_negative if way == "gains" else rate.is_positive:
        change, other = ("decreases", "leaves") if way == "gains" else ("increases", "gains")
        message = f"`{key.text}` has `{way}`, but its mass {change}"
        raise ProblemError(Diagnostic("mass-exchange", message, at, help=f"write `{other}`, or correct the mass"))
    what = f"`{way}` of `{key.text}`"
    inner = Section(
        mapping_of(section.required(way, at), what, f"{way}: {{relative: -u*j}}"), what, EXCHANGE, context.diagnostics
    )
    kinds = [k for k in ("velocity", "relative") if inner.has(k)]
    if len(kinds) != 1:
        if inner.strange:
            raise ProblemError(())
        message = f"{what} has {'both' if kinds else 'neither'} `velocity` {'and' if kinds else 'nor'} `relative`"
        help_ = "`velocity` is that in the fixed axes, `relative` that with respect to the particle: give one of them"
        raise ProblemError(Diagnostic("mass-exchange", message, at, help=help_))
    velocity = _velocity(inner.required(kinds[0], at), f"`{kinds[0]}` of {what}", context)
    return Exchange(velocity, kinds[0] == "relative", way == "leaves", at)


def _velocity(node: Node, what: str, context: LoadContext) -> Vector:
    """A velocity; `0` is one."""
    if isinstance(node, Scalar) and node.text.strip() == "0":
        return Vector.zero()
    return context.vector(node, what, RATE)


def _bodies(root: Section, context: LoadContext, bodies: dict[str, Body]) -> Iterator[_Entry]:
    for key, node in _entries(root, "bodies", _BODY, context):
        name = context.things.declare(key, "a rigid body")
        if name is None:
            continue
        context.points[name] = None
        context.bodies.append(name)
        body = _BodyBeingRead(name, key, node, context)
        of_position, of_turning = _names_used(node)
        turning = names_of_turning(name, node)
        place = f"r_{name}"
        named = _named_vectors({place: f"the position of `{name}`", **turning}, key, context)
        if named is None:
            continue
        of_place, of_axes = (tuple(n for n in named if (n == place) == wanted) for wanted in (True, False))
        yield _Entry(key, of_axes, of_turning, partial(_read_turning, body, context, bodies))
        yield _Entry(key, of_place, of_position, partial(_read_place, body, context, bodies))


def _read_turning(body: _BodyBeingRead, context: LoadContext, bodies: dict[str, Body]) -> None:
    context.add_vectors(body.turning())
    _complete(body, context, bodies)


def _read_place(body: _BodyBeingRead, context: LoadContext, bodies: dict[str, Body]) -> None:
    position = body.position()
    context.points[body.name] = position
    context.add_vectors({f"r_{body.name}": position})
    _complete(body, context, bodies)


def _complete(body: _BodyBeingRead, context: LoadContext, bodies: dict[str, Body]) -> None:
    """Adds the body, once both of its parts are read."""
    position = context.points[body.name]
    complete = None if position is None else body.at(position)
    if complete is not None:
        bodies[body.name] = complete


def _names_used(node: Node) -> tuple[frozenset[str], frozenset[str]]:
    """The names that the position of a body uses, and those that the rest of it uses."""
    if not isinstance(node, MappingNode):
        return frozenset(), _uses(node)
    unread = ("shape", "leaves", "gains")  # the last two are no keys of a body, which is said elsewhere
    uses = [(key.text == "position", _uses(value)) for key, value in node.entries if key.text not in unread]
    place, rest = ([names for is_place, names in uses if is_place == wanted] for wanted in (True, False))
    return frozenset().union(*place), frozenset().union(*rest)


def _uses(node: Node) -> frozenset[str]:
    return frozenset(name for scalar in scalars(node) for name in names_in(scalar.text))


# -- order -----------------------------------------------------------------------------------------------------------


def _in_order(entries: list[_Entry], context: LoadContext) -> list[_Entry]:
    """Each entry after those whose names it uses; circular definitions are reported and omitted."""
    giver = {name: n for n, entry in enumerate(entries) for name in entry.defines}
    needs = [[giver[name] for name in sorted(entry.uses) if name in giver] for entry in entries]
    order: dict[int, None] = {}
    for start in range(len(entries)):
        path = {start: iter(needs[start])} if start not in order else {}
        while path:
            last = next(reversed(path))
            needed = next((n for n in path[last] if n not in order), None)
            if needed is None:
                order[last] = None
                del path[last]
            elif needed in path:
                visited = list(path)
                _report_circle([entries[n] for n in visited[visited.index(needed) :]], context)
            else:
                path[needed] = iter(needs[needed])
    return [entries[n] for n in order if not any(context.names.has_failed(g) for g in entries[n].defines)]


def _report_circle(circle: list[_Entry], context: LoadContext) -> None:
    """Reports entries that are defined by one another, at the first of them in the file."""
    ordered = sorted(circle, key=lambda e: e.key.span.start)
    for entry in ordered:
        context.names.fail(*entry.defines)
    names = [f"`{entry.key.text}`" for entry in ordered]
    message = (
        f"{names[0]} is defined by itself"
        if len(names) == 1
        else f"{', '.join(names[:-1])} and {names[-1]} are defined in terms of one another"
    )
    help_ = "write one of them without the others" if len(names) > 1 else "write it with other names"
    context.diagnostics.report(Diagnostic("circular-definition", message, ordered[0].key.span, help=help_))
