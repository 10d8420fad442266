"""A JSON Schema (draft 2020-12) of problem files, for editors.

The loader is what decides; the schema is never stricter. A value is text to the loader, and what an editor's YAML takes
for a number, a truth value or nothing (`null` may be a name) is allowed where it may be text. What an expression may
say is not in it: an editor learns keys, their values where these are words, and what is a list. A test holds the keys
and the words to those of the loader. Nothing beyond draft 7 is used, for editors that know no more.
"""

from __future__ import annotations

from lagsolve.schema_forms import (
    ARGUMENT,
    NAME,
    WORDS_OF_YAML,
    Schema,
    emptiable,
    keyed,
    mapping,
    name,
    named,
    names,
    one_of,
    one_or_list,
    part,
    said,
    three,
)

ASSUMPTIONS = ("positive", "nonnegative", "real", "sign")
FRAMES = {"cartesian": 0, "polar": 2, "cylindrical": 3, "spherical": 3}
SEQUENCES = ("121", "123", "131", "132", "212", "213", "231", "232", "312", "313", "321", "323")
SENSES = ("positive", "negative")
QUESTIONS = ("constraints", "equilibrium", "motion", "linearization")
CLASSES = ("holonomic", "nonholonomic", "scleronomic", "rheonomic", "catastatic", "acatastatic")


def problem_schema() -> Schema:
    """The schema of a problem file."""
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "description": "A mechanical system: coordinates, constraints, forces, and what is asked of it.",
        **keyed("A problem for lagsolve", _sections(), required=("title", "coordinates")),
        "$defs": _parts(),
    }


def _sections() -> dict[str, Schema]:
    return {
        "title": said("What the problem is called.", part("text")),
        "source": said("Where it is from: book, chapter, number.", part("text")),
        "description": said("The system in words.", part("text")),
        "axes": said(
            "Words for the unit vectors, for the prose and the pictures: {i: right, j: up}.",
            emptiable(
                keyed("words for the axes", {axis: said(f"The direction of {axis}.", part("text")) for axis in "ijk"})
            ),
        ),
        "parameters": said(
            "Constants: a list of names, all positive, or each name with what is assumed of it.",
            emptiable(names(), named(part("parameter"))),
        ),
        "coordinates": said(
            "What the system is described with; coordinates need not be independent. A list, or each with its meaning.",
            {"anyOf": [{**names(), "minItems": 1}, named(part("coordinate"))]},
        ),
        "functions": said(
            "Undefined functions with their arguments: {f: [X, Y]}. A function of [t] alone is a prescribed motion.",
            emptiable(named({"type": "array", "minItems": 1, "items": part("argument")})),
        ),
        "let": said("Abbreviations, scalars or vectors.", emptiable(named(part("vector")))),
        "frame": said("Unit vectors that turn: e_r, e_phi, ..., named after the coordinates.", part("frame")),
        "particles": said("Particles with mass and position.", emptiable(named(part("particle")))),
        "bodies": said("Rigid bodies.", emptiable(named(part("body")))),
        "constraints": said(
            "Equations between coordinates, velocities and time. One with velocities is kinematic.",
            emptiable(named({"anyOf": [part("equation"), part("constraint")]})),
        ),
        "gravity": said("The acceleration of gravity, a vector; it adds a weight to every mass.", part("vector")),
        "forces": said("What else acts.", emptiable(named(part("force")))),
        "unknowns": said("Unknown forces that are to be found too.", emptiable(names())),
        "speeds": said(
            "Quasi-velocities in which the equations are wanted too: {u: \"x'*cos(theta) + y'*sin(theta)\"}.",
            emptiable(named(part("expression"))),
        ),
        "generalized_coordinates": said(
            "Choices of generalized coordinates, any number of them; each is verified.",
            emptiable(named(part("choice"))),
        ),
        "equations": said("A reference system, instead of masses, to check answers against.", part("equations")),
        "find": said("What is asked: one question or a list.", one_or_list(one_of(QUESTIONS))),
        "answers": said("What the textbook says; every run compares.", part("answers")),
    }


def _parts() -> dict[str, Schema]:
    return {
        "text": {"type": ["string", "number", *WORDS_OF_YAML]},
        "name": name(NAME),
        "argument": name(ARGUMENT),
        "expression": {"type": ["string", "number", *WORDS_OF_YAML]},
        "equation": {"type": "string"},
        "vector": {
            "description": "One expression, or a list of two or three components.",
            "anyOf": [part("expression"), {"type": "array", "minItems": 2, "maxItems": 3, "items": part("expression")}],
        },
        "equations": emptiable(one_or_list(part("equation"))),
        "alternatives": {
            "anyOf": [
                one_or_list(part("expression")),
                {"type": "array", "items": {"type": "array", "items": part("expression")}},
            ]
        },
        "sense": one_of(SENSES),
        "parameter": emptiable(
            one_of(ASSUMPTIONS),
            keyed(
                "what a parameter is",
                {
                    "assume": said("What is assumed of it; positive if nothing is said.", one_of(ASSUMPTIONS)),
                    "unit": said("Its unit, such as kg*m^2.", part("text")),
                    "meaning": said("What it is, in words.", part("text")),
                    "value": said("Its value, a rational number: 9.81, 1e-3, 2/3.", part("expression")),
                },
            ),
        ),
        "coordinate": {
            "anyOf": [
                part("text"),
                keyed(
                    "what a coordinate is",
                    {
                        "meaning": said("What it measures, in words.", part("text")),
                        "unit": said("Its unit.", part("text")),
                    },
                ),
            ]
        },
        "frame": emptiable(_frame()),
        "particle": keyed(
            "a particle",
            {
                "mass": said("Its mass; without one it is a massless point.", part("expression")),
                "position": said("Where it is.", part("vector")),
            },
            required=("position",),
        ),
        "body": _body(),
        "constraint": keyed(
            "a constraint in full",
            {
                "equation": said("The equation; of vectors it counts as its components.", part("equation")),
                "note": said("A remark, in words.", part("text")),
                "reaction": said("What its force of constraint is called.", part("name")),
            },
            required=("equation",),
        ),
        "force": {"anyOf": list(_forces())},
        "choice": keyed(
            "a choice of coordinates",
            {
                "coordinates": said(
                    "Its coordinates: new ones, and old ones that it keeps.", {**names(), "minItems": 1}
                ),
                "substitute": said(
                    "The other old coordinates in terms of these: {x: l*sin(theta)}.", named(part("expression"))
                ),
            },
            required=("coordinates",),
        ),
        "answers": emptiable(_answers()),
    }


def _frame() -> Schema:
    """A frame lists as many coordinates as its type has."""
    form = keyed(
        "a frame",
        {
            "type": said(
                "One of cartesian, polar [r, phi], cylindrical [rho, phi, z] or spherical [r, theta, phi].",
                one_of(tuple(FRAMES)),
            ),
            "coordinates": said(
                "The coordinates of the file that these are, in this order.", {"type": "array", "items": part("name")}
            ),
        },
        required=("type",),
    )
    counted = [
        {
            "if": {"properties": {"type": {"const": name}}},
            "then": {
                "required": ["coordinates"],
                "properties": {"coordinates": {"minItems": count, "maxItems": count}},
            },
        }
        for name, count in FRAMES.items()
        if count
    ]
    return {**form, "allOf": counted}


def _body() -> Schema:
    """A rigid body, turned in one of three ways."""
    turned = {
        "angle": said("Of a planar body: its angle about k.", part("expression")),
        "orientation": said(
            "In space: three rotations about axes of the body.",
            keyed(
                "three rotations",
                {
                    "axes": said(
                        "About which axes, in their order: 313.", {"enum": [v for s in SEQUENCES for v in (s, int(s))]}
                    ),
                    "angles": said("By which angles: [phi, theta, psi].", three(part("expression"))),
                },
                required=("axes", "angles"),
            ),
        ),
        "axes": said("In space: the triad that the inertia refers to.", three(part("vector"))),
        "angular_velocity": said("With `axes`: the angular velocity, a vector.", part("vector")),
    }
    form = keyed(
        "a rigid body",
        {
            "mass": said("Its mass; 0 if nothing is said.", part("expression")),
            "inertia": said(
                "About the mass centre: one moment about k, or three principal moments [A, B, C].",
                {"anyOf": [part("expression"), three(part("expression"))]},
            ),
            "position": said("Where the mass centre is.", part("vector")),
            **turned,
        },
        required=("inertia", "position"),
    )
    ways = (("angle",), ("orientation",), ("axes", "angular_velocity"))
    others = [{"required": list(way), "properties": {k: False for k in turned if k not in way}} for way in ways]
    return {**form, "anyOf": others}


FORCES: dict[str, tuple[tuple[str, ...], tuple[str, ...]]] = {
    "vector": (("vector", "on"), ("at",)),
    "moment": (("moment", "on"), ()),
    "spring": (("spring", "between"), ("length", "sense")),
    "damper": (("damper", "between"), ()),
    "potential": (("potential",), ()),
    "friction": (("friction", "constraint", "on"), ("surface_velocity", "slip", "contact")),
}
"""The kinds of forces: the keys that each must have, and those that it may have."""


def _forces() -> list[Schema]:
    ends = {"type": "array", "minItems": 2, "maxItems": 2, "items": part("vector")}
    keys = {
        "vector": said("A force: its vector.", part("vector")),
        "moment": said("A moment on a body: its vector.", part("vector")),
        "on": said("The particle or body that is acted on.", part("name")),
        "at": said("Where a force acts, if not at that point itself.", part("vector")),
        "spring": said("A spring: its stiffness.", part("expression")),
        "damper": said("A damper: its coefficient.", part("expression")),
        "between": said("The two ends: particles, bodies or positions.", ends),
        "length": said("The free length of the spring; 0 if nothing is said.", part("expression")),
        "sense": said("The sign of the second end's coordinate less the first's, on a line.", part("sense")),
        "potential": said("A field of force: its potential energy.", part("expression")),
        "friction": said("Coulomb friction: its coefficient.", part("expression")),
        "constraint": said("The constraint whose reaction presses.", part("name")),
        "surface_velocity": said("The velocity of the surface.", part("vector")),
        "slip": said("The sense of the slip along the coordinate, when known.", part("sense")),
        "contact": said("The sign of the multiplier, when known.", part("sense")),
    }
    titles = {"vector": "a force", "potential": "a field of force", "friction": "Coulomb friction"}
    return [
        keyed(titles.get(kind, f"a {kind}"), {k: keys[k] for k in (*must, *may)}, required=must)
        for kind, (must, may) in FORCES.items()
    ]


def _answers() -> Schema:
    truth = {"enum": [True, False, "true", "false"]}
    number = {
        "anyOf": [{"type": "integer", "minimum": 0, "maximum": 9999}, {"type": "string", "pattern": "^[0-9]{1,4}$"}]
    }
    return keyed(
        "answers",
        {
            "degrees_of_freedom": said("How many there are.", number),
            "classification": said("Such as [holonomic, scleronomic].", one_or_list(one_of(CLASSES))),
            "integrable": said("Which constraints are integrable: {rod: true}.", mapping(truth)),
            "equations": said("The equations of motion.", one_or_list(part("equation"))),
            "equilibrium": said("A list is one system; lists in a list are alternatives.", part("alternatives")),
            "reactions": said("Reactions by the names of their constraints.", mapping(part("expression"))),
            "frequencies": said(
                "Of small oscillations; lists in a list are those of several equilibria.", part("alternatives")
            ),
        },
    )
