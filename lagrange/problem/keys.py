"""The keys of problem files, each declared once: what its value may be, what it means, whether it is required.

The reader accepts these keys and no others; `lagsolve schema` and `lagsolve new` are made from this module, and a test
compares the tables of docs/problem-files.md with it. A new key is declared here and read in the module of its section.

A `Kind` is what a value may be: the name of a primitive kind (`PRIMITIVE`) or of a part (`PARTS`), words, a list,
names with values of one kind, a form (a mapping with known keys), or one of several kinds. Values are text to the
reader, so what an expression may contain is not decided by its kind.

SymPy is not imported here: schema and template must not wait for it.
"""

from __future__ import annotations

from enum import StrEnum

from lagrange.problem.yaml.kinds import AnyOf, Key, Keys, Kind, ListOf, Named, OneOf, one_or_list, or_nothing, three

# -- words -------------------------------------------------------------------------------------------------------------


class Assumption(StrEnum):
    """What is assumed of a parameter."""

    POSITIVE = "positive"
    NONNEGATIVE = "nonnegative"
    REAL = "real"
    SIGN = "sign"
    ACUTE = "acute"


class Find(StrEnum):
    """What is asked."""

    CONSTRAINTS = "constraints"
    EQUILIBRIUM = "equilibrium"
    MOTION = "motion"
    LINEARIZATION = "linearization"
    IMPENDING = "impending"
    HAMILTONIAN = "hamiltonian"
    STEADY = "steady"
    IMPACT = "impact"
    RESPONSE = "response"


class FrameType(StrEnum):
    """The frames that a file may name."""

    CARTESIAN = "cartesian"
    POLAR = "polar"
    CYLINDRICAL = "cylindrical"
    SPHERICAL = "spherical"


class Keeper(StrEnum):
    """What keeps a constraint, and so what its reaction can be."""

    ROD = "rod"
    STRING = "string"
    SURFACE = "surface"
    WIRE = "wire"
    HINGE = "hinge"
    ROLLING = "rolling"
    GEAR = "gear"


class Outline(StrEnum):
    """What a body looks like."""

    DISC = "disc"
    RING = "ring"
    ROD = "rod"
    BOX = "box"
    SPHERE = "sphere"
    CONE = "cone"


class Drawn(StrEnum):
    """What a line, circle, curve or mark of a figure is; the first ones are keys of `figure`."""

    GROUND = "ground"
    RODS = "rods"
    STRINGS = "strings"
    LINES = "lines"
    OUTLINES = "outlines"
    SPRINGS = "springs"
    DAMPERS = "dampers"
    SUPPORTS = "supports"
    BLADES = "blades"
    WHEELS = "wheels"
    ANGLES = "angles"
    LENGTHS = "lengths"
    ARROWS = "arrows"
    CURVE = "curve"
    DISC = "disc"
    RING = "ring"
    SPHERE = "sphere"
    PULLEY = "pulley"


HIDEABLE = ("axes", "gravity", "loads", "constraints", "origin", "links")
"""What a figure can leave out, beside coordinates, particles and bodies."""

FRAME_COORDINATES = {
    FrameType.CARTESIAN: ("x", "y", "z"),
    FrameType.POLAR: ("r", "phi"),
    FrameType.CYLINDRICAL: ("rho", "phi", "z"),
    FrameType.SPHERICAL: ("r", "theta", "phi"),
}
"""The coordinates of a frame in their order, under their usual names. A Cartesian frame need not list them."""

SEQUENCES = ("121", "123", "131", "132", "212", "213", "231", "232", "312", "313", "321", "323")
"""The sequences of three rotations about body axes of which no two neighbours agree."""

CLASSES = ("holonomic", "nonholonomic", "scleronomic", "rheonomic", "catastatic", "acatastatic")
"""The classes of systems; the two of each pair exclude each other."""

SENSES = {"positive": 1, "negative": -1}

WAYS_OF_TURNING = (("angle",), ("orientation",), ("axes", "angular_velocity"))
"""How a body is turned: the keys of exactly one of these are given. The first is planar, the others are in space."""


# -- forms -------------------------------------------------------------------------------------------------------------

AXES = Keys("words for the axes", tuple(Key(axis, "text", f"The direction of {axis}.") for axis in "ijk"))

PARAMETER = Keys(
    "what a parameter is",
    (
        Key("assume", OneOf(tuple(a.value for a in Assumption)), "What is assumed of it; positive by default."),
        Key("unit", "text", "Its unit, such as kg*m^2."),
        Key("meaning", "text", "What it is, in words."),
        Key("value", "expression", "Its value, a number with its unit: 9.81 m/s^2, 30 cm, 30 deg, 2/3, 2*pi rad/s."),
        Key("range", ListOf("expression", 2, 2), "The least and the greatest value that it can have: [0, 60 deg]."),
    ),
)

COORDINATE = Keys(
    "what a coordinate is",
    (
        Key("meaning", "text", "What it measures, in words."),
        Key("unit", "text", "Its unit."),
        Key("range", ListOf("expression", 2, 2), "Between which values it lies: [-90 deg, 90 deg], [0, l]."),
    ),
)

FRAME = Keys(
    "a frame",
    (
        Key(
            "type",
            OneOf(tuple(t.value for t in FrameType)),
            "One of cartesian, polar [r, phi], cylindrical [rho, phi, z] or spherical [r, theta, phi].",
            required=True,
            example="polar",
        ),
        Key("coordinates", ListOf("name"), "The coordinates of the file that these are, in this order."),
    ),
)

SHAPE = Keys(
    "a shape",
    (
        Key("disc", "expression", "A disc of this radius, across the third axis of the body.", example="R"),
        Key("ring", "expression", "A ring of this radius, also across the third axis."),
        Key("rod", ListOf("vector", 2, 2), "A rod between two places."),
        Key("box", ListOf("expression", 2, 2), "A box with these sides, along the first and second axis of the body."),
        Key("sphere", "expression", "A sphere of this radius."),
        Key("cone", ListOf("expression", 2, 2), "A cone with this radius and height, tip down along the third axis."),
        Key("axis", "vector", "In space: the axis of a disc, ring or cone; of a box, the direction of its first side."),
    ),
)
_NAME = Key("name", "text", "What sentences call it: `name: upper particle`. The article is added.")
_SHAPE = Key("shape", "shape", "What it looks like in the figure: {disc: R}, {rod: [A, B]}, {box: [a, b]}.")

EXCHANGE = Keys(
    "exchanged mass",
    (
        Key("velocity", "vector", "Its velocity just after it leaves, or just before it joins.", example="0"),
        Key("relative", "vector", "Instead: that velocity relative to the particle.", example="-u*j"),
    ),
)

PARTICLE = Keys(
    "a particle",
    (
        Key("mass", "expression", "Its mass, m or m_0 - q*t; without one it is a massless point."),
        Key("position", "vector", "Where it is.", required=True, example="x*i + y*j"),
        Key("leaves", "exchange", "Where its mass decreases: with what velocity mass leaves it."),
        Key("gains", "exchange", "Where its mass increases: with what velocity mass joins it."),
        _NAME,
        _SHAPE,
    ),
)

ORIENTATION = Keys(
    "three rotations",
    (
        Key("axes", OneOf(SEQUENCES), "About which axes, in their order: 313.", required=True, example="313"),
        Key("angles", three("expression"), "By which angles.", required=True, example="[phi, theta, psi]"),
    ),
)

BODY = Keys(
    "a rigid body",
    (
        Key("mass", "expression", "Its mass; 0 by default."),
        Key(
            "inertia",
            AnyOf(("expression", three("expression"), three(three("expression")))),
            "About the mass centre: one moment about k, three principal moments [A, B, C], or a symmetric matrix. "
            "At rest none is needed, nor without a mass.",
            example="I_G",
        ),
        Key("position", "vector", "Where the mass centre is.", required=True, example="x*i + y*j"),
        Key("angle", "expression", "Of a planar body: its angle about k.", example="theta"),
        Key(
            "orientation",
            ORIENTATION,
            "In space: three rotations about axes of the body.",
            example="{axes: 313, angles: [phi, theta, psi]}",
        ),
        Key("axes", three("vector"), "In space: the triad that the inertia refers to.", example="[e1, e2, e3]"),
        Key("angular_velocity", "vector", "With `axes`: the angular velocity, a vector.", example="theta'*k"),
        _NAME,
        _SHAPE,
    ),
)

CONSTRAINT = Keys(
    "a constraint in full",
    (
        Key(
            "equation",
            "equation",
            "The equation, or a one-sided constraint with <= or >=; a vector equation counts as its components.",
            required=True,
            example='"x^2 + y^2 = l^2"',
        ),
        Key("note", "text", "A remark, in words."),
        Key("reaction", "name", "What its force of constraint is called."),
        Key(
            "by",
            OneOf(tuple(k.value for k in Keeper)),
            "What keeps it, where the equation does not show it: a rod pulls and pushes, a string pulls.",
        ),
    ),
)

_ON = Key("on", "name", "The particle or body that is acted on.", required=True, example="P")
_ON_BODY = Key("on", "name", "The body that is acted on.", required=True, example="rod")
_BETWEEN = Key(
    "between", ListOf("vector", 2, 2), "The two ends: particles, bodies or positions.", required=True, example="[P, Q]"
)

FORCES = {
    "vector": Keys(
        "a force",
        (
            Key("vector", "vector", "A force: its vector.", required=True, example="F*i"),
            _ON,
            Key("at", "vector", "Where a force acts, if not at that point itself."),
        ),
    ),
    "moment": Keys(
        "a moment", (Key("moment", "vector", "A moment on a body: its vector.", required=True, example="M*k"), _ON_BODY)
    ),
    "spring": Keys(
        "a spring",
        (
            Key("spring", "expression", "A spring: its stiffness.", required=True, example="c"),
            _BETWEEN,
            Key("length", "expression", "The free length of the spring; 0 by default.", example="l_0"),
            Key("sense", "sense", "The sign of the second end's coordinate minus the first's, on a line."),
        ),
    ),
    "damper": Keys(
        "a damper", (Key("damper", "expression", "A damper: its coefficient.", required=True, example="b"), _BETWEEN)
    ),
    "potential": Keys(
        "a field of force",
        (
            Key(
                "potential",
                "expression",
                "A field of force: its potential energy, which may depend on velocities.",
                required=True,
                example="m*g*y",
            ),
        ),
    ),
    "generalized": Keys(
        "generalized forces",
        (
            Key(
                "generalized",
                Named("expression", new=False),
                "Generalized forces, by coordinates: {theta: -c*theta'}.",
                required=True,
                example="{theta: -c*theta'}",
            ),
        ),
    ),
    "friction": Keys(
        "Coulomb friction",
        (
            Key("friction", "expression", "Coulomb friction: its coefficient.", required=True, example="mu"),
            Key("constraint", one_or_list("name"), "What presses; for a list, the sum.", required=True, example="wall"),
            _ON,
            Key("static", "expression", "The coefficient at rest: there friction takes any value up to static*N."),
            Key("at", "vector", "On a body: the point that touches."),
            Key("surface_velocity", "vector", "The velocity of the surface."),
            Key(
                "slip",
                "slip",
                "The sense of the slip along the coordinate, or a vector in the direction in which the touching point "
                "slips or is about to slip.",
            ),
            Key("contact", "sense", "The sign of the reaction, when known."),
        ),
    ),
    "belt": Keys(
        "a belt on a rough drum",
        (
            Key("belt", "expression", "A belt or rope on a rough drum: the coefficient.", required=True, example="mu"),
            Key("angle", "expression", "The angle of contact.", required=True, example="beta"),
            Key("tight", "expression", "The larger tension: a name or an expression.", required=True, example="T_1"),
            Key("slack", "expression", "The smaller tension.", required=True, example="T_2"),
        ),
    ),
}
"""The kinds of forces, each recognised by the key of its name."""

CHOICE = Keys(
    "a choice of coordinates",
    (
        Key(
            "coordinates",
            ListOf("name", 1),
            "Its coordinates: new ones, and old ones that it keeps.",
            required=True,
            example="[theta]",
        ),
        Key("substitute", Named("expression"), "The other old coordinates in terms of these: {x: l*sin(theta)}."),
    ),
)

IMPACT = Keys(
    "an impact",
    (
        Key(
            "before",
            or_nothing(Named("expression", new=False)),
            "The state just before: velocities, and coordinates where the position is known: {x': v, theta: 0}. "
            "A velocity that is not given stays a symbol, x'_0.",
        ),
        Key("impulses", or_nothing(Named("impulse")), "Given blows."),
        Key(
            "constraints",
            or_nothing(Named(AnyOf(("equation", "constraint")))),
            "Constraints that begin to act; those of the file go on.",
        ),
        Key(
            "restitution",
            or_nothing(Named("expression", new=False)),
            "The coefficient of restitution of each of these constraints; 0 where none is given.",
        ),
    ),
)

IMPULSES = {
    "vector": Keys(
        "an impulse",
        (
            Key("vector", "vector", "An impulse: its vector.", required=True, example="J*i"),
            _ON,
            Key("at", "vector", "Where it acts, if not at that point itself."),
        ),
    ),
    "moment": Keys(
        "an impulsive moment",
        (Key("moment", "vector", "An impulsive moment on a body.", required=True, example="H*k"), _ON_BODY),
    ),
}
"""The kinds of given impulses, each recognised by the key of its name."""

QUESTION = Keys(
    "a question",
    (
        Key("quantity", "expression", "What is asked for: an expression.", required=True, example="theta"),
        Key(
            "when",
            one_or_list("equation"),
            "The state it is asked for: equations joined by `and`, or a list.",
        ),
        Key("by", "name", "Instead of `when`: the coordinate, or t, of which the answer is a function."),
    ),
)

ANSWERS = Keys(
    "answers",
    (
        Key("degrees_of_freedom", "number", "How many there are."),
        Key("classification", one_or_list(OneOf(CLASSES)), "Such as [holonomic, scleronomic]."),
        Key("integrable", Named(OneOf(("true", "false")), new=False), "Which constraints are integrable: {rod: true}."),
        Key("equations", one_or_list("equation"), "The equations of motion."),
        Key("equilibrium", "alternatives", "A list is one system; lists in a list are alternatives."),
        Key(
            "reactions", Named("expression", new=False), "Reactions, by their own names or those of their constraints."
        ),
        Key("rest", one_or_list("text"), "With friction: the conditions under which it can be at rest."),
        Key("frequencies", "alternatives", "Of small oscillations; lists in a list are those of several equilibria."),
        Key("decay", "alternatives", "Decay rates of damped small oscillations, in the same form: c/(2*m)."),
        Key("ask", Named(AnyOf(("expression", "equation")), new=False), "Of the questions, by their names."),
        Key(
            "hamiltonian", AnyOf(("expression", "equation")), "Hamilton's function, in coordinates and momenta p_theta."
        ),
        Key("steady", "alternatives", "Steady motions: a list is one; lists in a list are alternatives."),
        Key("kinetic_energy", "expression", "T, in the coordinates of the file or of a choice."),
        Key("generalized_forces", Named("expression", new=False), "Q_k of all applied forces, by coordinates."),
        Key("conserved", one_or_list("expression"), "First integrals, such as m*r^2*phi' = const."),
        Key("virtual_displacements", one_or_list("equation"), "Equations between delta(x), delta(y), ..."),
        Key(
            "response",
            Named(AnyOf(("expression", "equation")), new=False),
            "Amplitudes of the steady state under a harmonic drive, by coordinates.",
        ),
        Key(
            "impact",
            Named(AnyOf(("expression", "equation")), new=False),
            "After an impact: velocities (x'), impulses by the names of their constraints, `energy_lost`.",
        ),
    ),
)

_EACH = AnyOf(("decimal", Named("decimal", new=False)))
POINTS = Keys(
    "points",
    tuple(Key(k, _EACH if k in ("ask", "reactions") else "decimal", f"For `{k}` in an answer.") for k in ANSWERS.names),
)
VARY = Keys(
    "a range of values",
    (
        Key("from", "expression", "The first value.", required=True, example="0.2 m"),
        Key("to", "expression", "The last value, or a bound for it.", required=True, example="1 m"),
        Key("step", "expression", "By how much the values differ.", required=True, example="0.1 m"),
    ),
)

_CHAINS = ListOf("path")

CIRCLE = Keys(
    "a circle of a figure",
    (
        Key("centre", "vector", "Its centre.", required=True, example="r_P"),
        Key("radius", "expression", "Its radius.", required=True, example="R"),
        Key("axis", "vector", "In space: the direction across it."),
        Key("as", OneOf(("disc", "ring", "sphere", "curve")), "What it is; a disc by default."),
    ),
)

CURVE = Keys(
    "a curve or surface of a figure",
    (
        Key("point", "vector", "A place that depends on one parameter, or on two.", required=True, example="x*i"),
        Key("along", one_or_list("name"), "That parameter, a coordinate or a new name; two of them for a surface.",
            required=True, example="x"),
        Key("from", one_or_list("expression"), "Where it begins.", required=True, example="0"),
        Key("to", one_or_list("expression"), "Where it ends.", required=True, example="2*pi"),
        Key("as", OneOf(("ground", "curve", "rods", "strings", "lines", "outlines")),
            "What it is: ground is hatched on the right-hand side; a curve by default."),
    ),
)  # fmt: skip

FIGURE = Keys(
    "a figure",
    (
        Key("at", Named("expression", new=False), "The position drawn, in numbers: {theta: 30 deg, l: 2}."),
        Key("down", "vector", "What points down on the page, if that is not gravity and not said by `axes`."),
        Key("seen_from", "vector", "The direction from which a system in space is seen: `-j`."),
        Key("points", Named("vector"), "Further points, with their letters: {A: l*i}. The others may use them."),
        Key("ground", _CHAINS, "What does not move, hatched to the right of the way through these places."),
        Key("rods", _CHAINS, "Rods and bars, from place to place: a particle, a body, a point, O or a vector."),
        Key("strings", _CHAINS, "Strings; a pulley among the places is gone around."),
        Key("lines", _CHAINS, "Thin dashed lines."),
        Key("outlines", _CHAINS, "Closed outlines of bodies."),
        Key("springs", _CHAINS, "Springs that are not among the forces."),
        Key("dampers", _CHAINS, "Dampers that are not among the forces."),
        Key("supports", ListOf("vector"), "Hinges that are fixed to the ground."),
        Key("blades", _CHAINS, "Blades seen from above: place and direction."),
        Key("wheels", _CHAINS, "Wheels seen from above: place and direction."),
        Key("pulleys", Named("circle"), "Pulleys: {upper: {centre: h*j, radius: R}}."),
        Key("circles", ListOf("circle"), "Discs, rings, spheres and circles."),
        Key("curves", ListOf("curve"), "Curves and surfaces: {point: x*i + x^2*j, along: x, from: -1, to: 1}."),
        Key("angles", Named("mark", new=False), "Angles with their labels: {alpha: [at, from, to]}, `from` and "
            "`to` being directions."),
        Key("lengths", Named("mark", new=False), "Lengths with their labels: {R: [from, to]}."),
        Key("arrows", Named("mark", new=False), "Arrows with their labels: {v: [from, to]}."),
        Key("hide", ListOf("name"), "What is not drawn: coordinates, particles, bodies, `axes`, `gravity`, `loads`, "
            "`constraints`, `origin`, `links`."),
    ),
)  # fmt: skip

PROBLEM = Keys(
    "a problem for lagsolve",
    (
        Key("title", "text", "What the problem is called.", required=True, example="..."),
        Key("source", "text", "Where it is from: book, chapter, number."),
        Key("description", "text", "The system in words. Declared symbols, `...` and $...$ are set as mathematics."),
        Key("axes", or_nothing(AXES), "Words for the unit vectors, for the prose and the pictures: {i: right, j: up}."),
        Key(
            "parameters",
            or_nothing(ListOf("name"), Named("parameter")),
            "Constants: a list of names, all positive, or each name with its assumption.",
        ),
        Key(
            "coordinates",
            AnyOf((ListOf("name", 1), Named("coordinate"))),
            "What the system is described with; coordinates need not be independent. A list, or each with its meaning.",
            required=True,
            example="[x, y]",
        ),
        Key(
            "functions",
            or_nothing(Named(ListOf("argument", 1))),
            "Undefined functions with their arguments: {f: [X, Y]}. A function of [t] alone is a prescribed motion.",
        ),
        Key("let", or_nothing(Named("vector")), "Abbreviations, scalars or vectors."),
        Key("frame", "frame", "Unit vectors that turn: e_r, e_phi, ..., named after the coordinates."),
        Key("particles", or_nothing(Named("particle")), "Particles with mass and position."),
        Key("bodies", or_nothing(Named("body")), "Rigid bodies."),
        Key(
            "constraints",
            or_nothing(Named(AnyOf(("equation", "constraint")))),
            "Equations between coordinates, velocities and time. One with velocities is kinematic, one without is "
            "geometric. One-sided constraints have <= or >=.",
        ),
        Key("gravity", "vector", "The acceleration of gravity, a vector; it adds a weight to every mass."),
        Key("forces", or_nothing(Named("force")), "What else acts."),
        Key("unknowns", or_nothing(ListOf("name")), "Unknown forces, to be found as well."),
        Key(
            "speeds",
            or_nothing(Named("expression")),
            "Quasi-velocities in which the equations are given too: {u: \"x'*cos(theta) + y'*sin(theta)\"}.",
        ),
        Key(
            "generalized_coordinates",
            or_nothing(Named("choice")),
            "Choices of generalized coordinates, any number of them; each is verified.",
        ),
        Key("initial", or_nothing(Named("expression", new=False)), "The state at t = 0: {theta: 0, theta': 0}."),
        Key("ask", or_nothing(Named("question")), "Questions about the motion, by names of your own."),
        Key("impact", IMPACT, "Blows, and constraints that begin to act in an instant."),
        Key("lagrangian", "expression", "The Lagrangian outright, instead of particles and bodies."),
        Key("equations", "equations", "A reference system, instead of masses, to check answers against."),
        Key("find", one_or_list(OneOf(tuple(f.value for f in Find))), "What is asked: one question or a list."),
        Key("answers", "answers", "What the textbook says; every run compares."),
        Key(
            "vary",
            or_nothing(Named(AnyOf((ListOf("expression", 1), VARY)), new=False)),
            "Values that `lagsolve variant` draws: {m: [1 kg, 2 kg], l: {from: 0.2 m, to: 1 m, step: 0.1 m}}.",
        ),
        Key("points", or_nothing(POINTS), "What each part of an answer is worth: {equations: 6, ask: {leaves: 3}}."),
        Key("figure", or_nothing(FIGURE), "What the figure shows in addition to what the problem implies."),
    ),
)

PARTS: dict[str, Kind] = {
    "vector": AnyOf(("expression", ListOf("expression", 2, 3))),
    "path": ListOf("vector", 2),
    "mark": ListOf("vector", 2, 3),
    "shape": SHAPE,
    "circle": CIRCLE,
    "curve": CURVE,
    "equations": or_nothing(one_or_list("equation")),
    "alternatives": AnyOf((one_or_list("expression"), ListOf(ListOf("expression")))),
    "sense": OneOf(tuple(SENSES)),
    "slip": AnyOf((OneOf(tuple(SENSES)), "vector")),
    "parameter": or_nothing(OneOf(tuple(a.value for a in Assumption)), "quantity", PARAMETER),
    "coordinate": AnyOf(("text", COORDINATE)),
    "frame": or_nothing(FRAME),
    "exchange": EXCHANGE,
    "particle": PARTICLE,
    "body": BODY,
    "constraint": CONSTRAINT,
    "force": AnyOf(tuple(FORCES.values())),
    "impulse": AnyOf(tuple(IMPULSES.values())),
    "choice": CHOICE,
    "question": QUESTION,
    "answers": or_nothing(ANSWERS),
}
"""Kinds with a name of their own."""

FORMS = (
    *(PROBLEM, AXES, PARAMETER, COORDINATE, FRAME, PARTICLE, EXCHANGE, BODY, ORIENTATION, SHAPE, CONSTRAINT),
    *(*FORCES.values(), CHOICE, QUESTION, IMPACT, *IMPULSES.values(), ANSWERS, POINTS, VARY, FIGURE, CIRCLE, CURVE),
)
"""All forms, in the order in which the documentation has them."""
