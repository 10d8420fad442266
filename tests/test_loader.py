"""Problem files, read from the contract: every key in each of its forms, every trap of YAML, every mistake at its place."""

from __future__ import annotations

from pathlib import Path

import pytest
import sympy as sp
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from lagrange.core.diagnostics import Diagnostic, ProblemError, Source
from lagrange.core.symbols import Sign, Unspecified, t
from lagrange.core.vectors import Vector
from lagrange.problem.loader import load, read_problem
from lagrange.problem.model import (
    AppliedForce,
    AppliedMoment,
    Assumption,
    Damper,
    Find,
    Friction,
    Potential,
    Problem,
    Spring,
)
from lagrange.problem.yaml_nodes import MAX_BYTES, decode

HEAD = """title: Example
parameters: [m, l, g, k, c, F, R, mu, A, C, I_G]
coordinates: [x, y, theta]
"""
PARTICLES = "particles: {P: {mass: m, position: x*i + y*j}, Q: {mass: m, position: y*i}}\n"
BODY = "bodies: {B: {mass: m, inertia: I_G, position: x*i, angle: theta}}\n"
ROD = "constraints: {rod: x^2 + y^2 = l^2}\n"
ALL = HEAD + PARTICLES + BODY + ROD

x, y, theta = (sp.Symbol(n, real=True) for n in ("x", "y", "theta"))
v, w, om = (sp.Symbol(n, real=True) for n in ("x'", "y'", "theta'"))
m, l, g, k, c, F, R, mu, A, C, I_G = sp.symbols("m l g k c F R mu A C I_G", positive=True)


def read(text: str) -> Problem:
    return read_problem(Source("problem.yaml", text))


def vector(*components: sp.Expr | int) -> Vector:
    p, q, r = (sp.sympify(e) for e in components)
    return Vector((p, q, r))


def mistakes(text: str | bytes) -> tuple[Diagnostic, ...]:
    with pytest.raises(ProblemError) as caught:
        read_problem(decode(text, "problem.yaml") if isinstance(text, bytes) else Source("problem.yaml", text))
    return caught.value.diagnostics


def places(text: str | bytes) -> list[tuple[str, int, int]]:
    """Code, line and column of all mistakes, in the order of the file; each says what to do."""
    found = mistakes(text)
    assert all(d.help for d in found)
    return [(d.code, *(d.span.source.position(d.span.start) if d.span else (0, 0))) for d in found]


# -- every key in each of its forms --------------------------------------------------------------------------------------


def test_title_and_coordinates_are_enough() -> None:
    problem = read("title: T\ncoordinates: [x]\n")
    assert (problem.title, [q.symbol for q in problem.coordinates]) == ("T", [x])
    assert problem.find == (Find.CONSTRAINTS,)


def test_the_words_of_the_statement() -> None:
    problem = read(
        "title: Ideal   pendulum\nsource: Chapter 6, Ex. 11\ndescription: >\n  Two\n  lines.\naxes: {i: right, j: down}\n"
        "coordinates: [x]\n"
    )
    assert (problem.title, problem.source, problem.description) == (
        "Ideal pendulum",
        "Chapter 6, Ex. 11",
        "Two lines.",
    )
    assert problem.axes == {"i": "right", "j": "down"}


def test_parameters_in_a_list_are_positive() -> None:
    problem = read("title: T\nparameters: [m, θ_0]\ncoordinates: [x]\n")
    assert [p.symbol for p in problem.parameters] == [m, sp.Symbol("theta_0", positive=True)]


def test_parameters_in_a_mapping() -> None:
    problem = read("""title: T
coordinates: [x]
parameters:
  m: positive
  a: real
  b: nonnegative
  s: sign
  n:
  q: {assume: real, unit: m/s^2, meaning: acceleration of gravity, value: 9.81}
  r: {value: 2/3}
  z: {unit: kg}
  w: {assume: real, value: -1e-3}
""")
    found = {str(p.symbol): p for p in problem.parameters}
    assert [str(p.symbol) for p in problem.parameters] == ["m", "a", "b", "s", "n", "q", "r", "z", "w"]
    assert found["m"].symbol.is_positive
    assert found["n"].symbol.is_positive
    assert found["a"].symbol.is_real
    assert found["a"].symbol.is_positive is None
    assert found["b"].symbol.is_nonnegative
    assert found["b"].symbol.is_positive is None
    assert isinstance(found["s"].symbol, Sign)
    assert found["s"].symbol ** 2 == 1
    assert (found["q"].unit, found["q"].meaning) == ("m/s^2", "acceleration of gravity")
    assert found["q"].assume is Assumption.REAL
    assert found["q"].value == sp.Rational(981, 100)
    assert found["r"].value == sp.Rational(2, 3)
    assert found["z"].value is None
    assert found["w"].value == sp.Rational(-1, 1000)


@pytest.mark.parametrize(
    ("written", "value"),
    [("1e-3", "1/1000"), ("012", "12"), (".5", "1/2"), ("2", "2"), ("'2'", "2"), ("1.50", "3/2"), ("2e3", "2000")],
)
def test_numbers_are_exact(written: str, value: str) -> None:
    problem = read(f"title: T\nparameters: {{m: {{value: {written}}}}}\ncoordinates: [x]\n")
    assert problem.parameters[0].value == sp.Rational(value)


def test_coordinates_in_a_mapping() -> None:
    problem = read("title: T\ncoordinates: {x: distance right of O, y: {meaning: height, unit: m}, z: }\n")
    assert [(str(q.symbol), q.meaning, q.unit) for q in problem.coordinates] == [
        ("x", "distance right of O", ""),
        ("y", "height", "m"),
        ("z", "", ""),
    ]


def test_functions() -> None:
    problem = read(
        "title: T\ncoordinates: [x, y]\nfunctions: {f: [X, Y], u: [t], F_x: [x, x', t]}\n"
        'constraints: {a: "f(x - u, y) = 0", b: "x\' = u\'"}\n'
        "particles: {P: {mass: 1, position: x*i}}\nforces: {p: {on: P, vector: F_x*i}}\n"
    )
    u = sp.Symbol("u", real=True)
    assert problem.slots.prescribed == (u,)
    assert [str(f) for f in problem.functions] == ["f(X, Y)", "F_x(x, x', t)"]
    assert problem.constraints[0].function == Unspecified.of("f", ("X", "Y"), x - u, y)
    assert problem.constraints[1].function == v - sp.Symbol("u'", real=True)
    push = problem.forces[0]
    assert isinstance(push, AppliedForce)
    assert push.vector == vector(Unspecified.of("F_x", ("x", "x'", "t"), x, v, t), 0, 0)


@pytest.mark.parametrize("section", ["a: l*x\n  b: a^2\n  n: a*i\n  w: n'", "w: n'\n  n: a*i\n  b: a^2\n  a: l*x"])
def test_abbreviations_whatever_their_order(section: str) -> None:
    problem = read(f"{HEAD}let:\n  {section}\n")
    assert problem.scope.scalars["b"] == l**2 * x**2
    assert problem.scope.vectors["w"] == vector(l * v, 0, 0)


def test_abbreviations_and_positions_may_use_one_another() -> None:
    problem = read(f"{HEAD}let: {{n: sin(theta)*i, h: r_P'}}\nparticles: {{P: {{mass: m, position: l*n}}}}\n")
    assert problem.particles[0].position == vector(l * sp.sin(theta), 0, 0)
    assert problem.scope.vectors["h"] == vector(l * sp.cos(theta) * om, 0, 0)


@pytest.mark.parametrize(
    ("frame", "coordinates", "first"),
    [
        ("{type: cartesian}", "[x, y, z]", (1, 0, 0)),
        ("{type: polar, coordinates: [r, phi]}", "[r, phi]", ("cos(phi)", "sin(phi)", 0)),
        ("{type: cylindrical, coordinates: [rho, phi, z]}", "[rho, phi, z]", ("cos(phi)", "sin(phi)", 0)),
        (
            "{type: spherical, coordinates: [r, theta, phi]}",
            "[r, theta, phi]",
            ("sin(theta)*cos(phi)", "sin(theta)*sin(phi)", "cos(theta)"),
        ),
    ],
)
def test_frames(frame: str, coordinates: str, first: tuple[object, ...]) -> None:
    names = coordinates.strip("[]").split(", ")
    unit = "i" if "cartesian" in frame else f"e_{names[0]}"
    problem = read(f"title: T\ncoordinates: {coordinates}\nframe: {frame}\nlet: {{n: {unit}}}\n")
    symbols = {n: sp.Symbol(n, real=True) for n in ("theta", "phi")}
    expected = vector(*(sp.sympify(e, symbols) for e in first))
    assert problem.scope.vectors["n"].fixed() == expected


def test_particles() -> None:
    problem = read(
        HEAD + "particles:\n  P: {mass: m, position: x*i + y*j}\n  Q: {mass: 2 m, position: [x, y]}\n"
        '  S: {position: "[x, y]"}\n  Z: {mass: 0, position: r_P + l*j}\n'
    )
    assert [(p.name, p.mass) for p in problem.particles] == [("P", m), ("Q", 2 * m), ("S", 0), ("Z", 0)]
    assert {p.position for p in problem.particles[:3]} == {vector(x, y, 0)}
    assert problem.particles[3].position == vector(x, y + l, 0)


def test_bodies() -> None:
    problem = read(
        HEAD + "let: {e1: cos(theta)*i + sin(theta)*j, e2: -sin(theta)*i + cos(theta)*j}\nbodies:\n"
        "  rod: {mass: m, inertia: I_G, position: x*i + y*j, angle: theta}\n"
        "  top: {mass: m, inertia: [A, A, C], position: [x, y, 0], orientation: {axes: 313, angles: [x, y, theta]}}\n"
        "  coin: {mass: m, inertia: [A, A, C], position: r_rod, axes: [e1, e2, e_z], angular_velocity: theta'*e_z}\n"
        'constraints: {roll: "r_rod\' + cross(omega_rod, R*e2_rod) = 0"}\n'
    )
    rod, top, coin = problem.bodies
    assert (rod.inertia, rod.angle, rod.position) == ((I_G,), theta, vector(x, y, 0))
    assert (top.inertia, top.sequence, top.angles) == ((A, A, C), "313", (x, y, theta))
    assert coin.angular_velocity == vector(0, 0, om)
    assert coin.axes[0] == vector(sp.cos(theta), sp.sin(theta), 0)
    rolls = {c.name: c.function for c in problem.constraints}
    assert sp.simplify(rolls["roll.1"] - (v - R * om * sp.cos(theta))) == 0
    assert sp.simplify(rolls["roll.2"] - (w - R * om * sp.sin(theta))) == 0


CONSTRAINTS: dict[str, tuple[sp.Expr, bool]] = {
    "x^2 + y^2 = l^2": (x**2 + y**2 - l**2, False),
    "{equation: x = 0}": (x, False),
    "\"x' - R*theta' = 0\"": (v - R * om, True),
    "sin(theta)*d(x) - cos(theta)*d(y) = 0": (sp.sin(theta) * v - sp.cos(theta) * w, True),
    "x*d(x) = l*d(t)": (x * v - l, True),
    "d(x) = t*d(y)": (v - t * w, True),
    "y = x*tan(theta)": (y - x * sp.tan(theta), False),
    "x == y": (x - y, False),
    "\"(x' + 1)*x = x'*x\"": (x, False),
}


@pytest.mark.parametrize("text", CONSTRAINTS)
def test_constraint(text: str) -> None:
    constraint = read(f"{HEAD}constraints: {{rod: {text}}}\n").constraints[0]
    expected, kinematic = CONSTRAINTS[text]
    assert sp.expand(constraint.function - expected) == 0
    assert constraint.kinematic is kinematic
    assert (constraint.name, constraint.reaction) == ("rod", sp.Symbol("lambda_rod", real=True))


def test_notes_and_reactions_of_constraints() -> None:
    problem = read(
        f"{HEAD}constraints: {{no_slip: {{equation: \"x' = R*theta'\", reaction: N, note: 'It  rolls'}}, no: y = 0}}\n"
    )
    rolling, no = problem.constraints
    assert (rolling.reaction.name, rolling.note) == ("N", "It rolls")
    assert (no.name, no.reaction.name) == ("no", "lambda_no")
    assert problem.scope.scalars["N"] == sp.Symbol("N", real=True)


def test_a_vector_constraint_counts_as_its_components() -> None:
    problem = read(f"{HEAD}constraints:\n  hinge: {{equation: '[x, y, 0] = [l, x, 0]', reaction: N}}\n")
    assert [(c.name, c.function, c.reaction.name) for c in problem.constraints] == [
        ("hinge.1", x - l, "N_1"),
        ("hinge.2", y - x, "N_2"),
    ]


def test_identical_components_of_a_vector_constraint_do_not_count() -> None:
    problem = read(f"{HEAD}constraints:\n  a: '[x, sin(x)^2 + cos(x)^2, y] = [0, 1, l]'\n")
    assert [c.name for c in problem.constraints] == ["a.1", "a.3"]
    assert places(f"{HEAD}constraints:\n  a: '[1, sin(x)^2] = [1, 1 - cos(x)^2]'\n") == [("restricts-nothing", 5, 6)]
    assert places(f"{HEAD}constraints:\n  a: '[x, m] = [0, l]'\n") == [("restricts-nothing", 5, 6)]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("g*j", (0, g, 0)),
        ("-g*e_y", (0, -g, 0)),
        ("[0, -g]", (0, -g, 0)),
        ("'[0, 0, -g]'", (0, 0, -g)),
        ("0", (0, 0, 0)),
    ],
)
def test_gravity(text: str, expected: tuple[sp.Expr, ...]) -> None:
    assert read(f"{HEAD}gravity: {text}\n").gravity == vector(*expected)


def test_forces() -> None:
    problem = read(
        ALL
        + """forces:
  push: {on: P, vector: F*i, at: r_P + l*j}
  plain: {on: B, vector: "[0, F]"}
  torque: {on: B, moment: F*e_z}
  spring: {spring: k, between: [P, Q], length: l}
  loose: {spring: k, between: [P, l*j]}
  damper: {damper: c, between: [B, "[1, 2]"]}
  field: {potential: k*x^2/2}
  rub: {friction: mu, constraint: rod, on: P}
  full: {friction: mu, constraint: rod, on: P, surface_velocity: F*i, slip: positive, contact: negative}
"""
    )
    push, plain, torque, spring, loose, damper, field, rub, full = problem.forces
    assert isinstance(push, AppliedForce)
    assert (push.on, push.vector, push.at) == ("P", vector(F, 0, 0), vector(x, y + l, 0))
    assert isinstance(plain, AppliedForce)
    assert (plain.on, plain.vector, plain.at) == ("B", vector(0, F, 0), None)
    assert isinstance(torque, AppliedMoment)
    assert (torque.on, torque.moment) == ("B", vector(0, 0, F))
    assert isinstance(spring, Spring)
    assert (spring.stiffness, spring.length, spring.ends) == (k, l, (vector(x, y, 0), vector(y, 0, 0)))
    assert isinstance(loose, Spring)
    assert (loose.length, loose.ends[1]) == (0, vector(0, l, 0))
    assert isinstance(damper, Damper)
    assert (damper.coefficient, damper.ends) == (c, (vector(x, 0, 0), vector(1, 2, 0)))
    assert isinstance(field, Potential)
    assert field.energy == k * x**2 / 2
    assert isinstance(rub, Friction)
    assert (rub.coefficient, rub.constraint, rub.on, rub.slip, rub.contact) == (mu, "rod", "P", None, None)
    assert isinstance(full, Friction)
    assert (full.surface_velocity, full.slip, full.contact) == (vector(F, 0, 0), 1, -1)


def test_unknowns_speeds_and_choices() -> None:
    problem = read(
        ALL
        + """unknowns: [P]
forces: {hold: {on: P, vector: P*i}}
speeds: {u1: "x'*cos(theta) + y'*sin(theta)"}
generalized_coordinates:
  angle: {coordinates: [s, theta], substitute: {x: l*sin(s), y: l*cos(s)}}
  depth: {coordinates: [y, theta]}
"""
    )
    assert problem.unknowns == (sp.Symbol("P", real=True),)
    assert [s.definition for s in problem.speeds] == [v * sp.cos(theta) + w * sp.sin(theta)]
    angle, depth = problem.choices
    s = sp.Symbol("s", real=True)
    assert angle.coordinates == (s, theta)
    assert angle.substitute == {x: l * sp.sin(s), y: l * sp.cos(s)}
    assert (depth.coordinates, depth.substitute) == ((y, theta), None)


def test_answers() -> None:
    answers = read(
        ALL
        + """answers:
  degrees_of_freedom: 1
  classification: [holonomic, scleronomic]
  integrable: {rod: true}
  equations: ["theta'' + g/l*sin(theta) = 0", "x'' = 0"]
  equilibrium: [["theta = 0"], ["theta = pi", "x = 0"]]
  reactions: {rod: m*g}
"""
    ).answers
    assert answers is not None
    assert (answers.degrees_of_freedom, answers.classification) == (1, ("holonomic", "scleronomic"))
    assert answers.integrable == {"rod": True}
    assert [e.text for e in answers.equations] == ["theta'' + g/l*sin(theta) = 0", "x'' = 0"]
    assert [[e.text for e in way] for way in answers.equilibrium] == [["theta = 0"], ["theta = pi", "x = 0"]]
    assert answers.reactions["rod"].text == "m*g"


def test_a_flat_list_of_equilibrium_is_one_system() -> None:
    answers = read(ALL + "answers: {equilibrium: [theta = 0, x = 0]}\n").answers
    assert answers is not None
    assert [[e.text for e in way] for way in answers.equilibrium] == [["theta = 0", "x = 0"]]
    assert places(ALL + "answers: {equilibrium: [theta = 0, [x = 0]]}\n") == [("wrong-kind", 7, 24)]


FIND = {
    "": (Find.MOTION,),
    "find: constraints": (Find.CONSTRAINTS,),
    "find: [motion, equilibrium]": (Find.MOTION, Find.EQUILIBRIUM),
    "find: linearization": (Find.LINEARIZATION,),
}


@pytest.mark.parametrize("text", FIND)
def test_find(text: str) -> None:
    assert read(HEAD + PARTICLES + text).find == FIND[text]


def test_find_by_default() -> None:
    massless = "particles: {P: {position: x*i}}\n"
    assert read(HEAD + massless).find == (Find.CONSTRAINTS,)
    assert read(HEAD + ROD).find == (Find.CONSTRAINTS,)
    assert read(HEAD + massless + "forces: {a: {on: P, vector: F*i}}\n").find == (Find.EQUILIBRIUM,)
    assert read(HEAD + BODY).find == (Find.MOTION,)
    assert read(HEAD + "equations: [\"x'' = 0\"]\n").find == (Find.MOTION,)
    assert read(HEAD + "bodies: {B: {inertia: I_G, position: 0, angle: theta}}\n").find == (Find.MOTION,)


def test_a_reference_system() -> None:
    assert [e.text for e in read(HEAD + "equations: [\"m x'' = F\", y'' = 0]\n").equations] == ["m x'' = F", "y'' = 0"]


def test_namespaces_are_apart() -> None:
    """A constraint, a body, a force and a choice may share a name, and a symbol may have it too."""
    problem = read(
        "title: T\nparameters: [rod, m]\ncoordinates: [x, theta]\n"
        "bodies: {rod: {mass: rod, inertia: m, position: x*i, angle: theta}}\nconstraints: {rod: x = rod}\n"
        "forces: {rod: {on: rod, vector: rod*i}}\ngeneralized_coordinates: {rod: {coordinates: [x, theta]}}\n"
    )
    assert problem.constraints[0].function == x - sp.Symbol("rod", positive=True)
    assert problem.bodies[0].name == problem.forces[0].name == problem.choices[0].name == "rod"


def test_names_of_other_languages_are_free() -> None:
    names = [
        "e",
        "E",
        "I",
        "S",
        "N",
        "Q",
        "beta",
        "lambda",
        "d",
        "n",
        "y",
        "no",
        "on",
        "yes",
        "off",
        "true",
        "null",
        "gamma",
    ]
    problem = read(f"title: T\ncoordinates: [{', '.join(names)}]\nconstraints: {{a: {' + '.join(names)} = 0}}\n")
    assert [str(q.symbol) for q in problem.coordinates] == names
    assert problem.constraints[0].function == sp.Add(*(q.symbol for q in problem.coordinates))


def test_a_declared_k_stays_a_stiffness_where_a_scalar_is_meant() -> None:
    problem = read(ALL + "forces: {a: {on: P, vector: -k*x*i}, b: {on: B, moment: F*k}}\n")
    pull, torque = problem.forces
    assert isinstance(pull, AppliedForce)
    assert pull.vector == vector(-k * x, 0, 0)
    assert isinstance(torque, AppliedMoment)
    assert torque.moment == vector(0, 0, F)
    assert [(n.code, n.level) for n in problem.notes] == [("read-as", "note")]
    assert "e_z" in problem.notes[0].help


# -- the traps of YAML -----------------------------------------------------------------------------------------------------


def test_prime_quotes() -> None:
    """In single quotes YAML halves the primes, which is said; in double quotes and without any it does not."""
    halved = read(ALL + "answers: {equations: ['x'' = 0']}\n")
    assert [n.code for n in halved.notes] == ["read-as"]
    assert "double quotes" in halved.notes[0].help
    for written in ("\"x'' = 0\"", "'x'''' = 0'", "x'' = 0", "'x'''' + y'' = 0'"):
        assert read(ALL + f"answers: {{equations: [{written}]}}\n").notes == ()


def test_line_ends_and_byte_order_marks() -> None:
    for text in (ALL, ALL.replace("\n", "\r\n"), ALL.replace("\n", "\r"), "\ufeff" + ALL):
        problem = read_problem(decode(text.encode(), "problem.yaml"))
        assert problem.constraints[0].function == x**2 + y**2 - l**2


def test_a_column_is_that_of_the_file_with_a_byte_order_mark(tmp_path: Path) -> None:
    path = tmp_path / "problem.yaml"
    path.write_bytes(b"\xef\xbb\xbftitel: T\r\ncoordinates: [x]\r\nlet: {a: q}\r\n")
    with pytest.raises(ProblemError) as caught:
        load(path)
    spans = [d.span for d in caught.value.diagnostics]
    assert [s.source.position(s.start) for s in spans if s] == [(1, 1), (3, 10)]


def laughs() -> str:
    lines = ["a0: &a0 [" + ",".join("x" * 9) + "]"]
    lines += [f"a{n}: &a{n} [{','.join([f'*a{n - 1}'] * 9)}]" for n in range(1, 10)]
    return "\n".join(lines)


YAML: dict[str, tuple[str | bytes, list[tuple[str, int, int]]]] = {
    "empty": ("", [("empty-file", 0, 0)]),
    "blank": ("  \n\n", [("empty-file", 0, 0)]),
    "comments": ("# nothing\n", [("empty-file", 0, 0)]),
    "document start": ("---\n", [("empty-file", 0, 0)]),
    "a word": ("pendulum\n", [("not-a-mapping", 1, 1)]),
    "a list": ("- a\n- b\n", [("not-a-mapping", 1, 1)]),
    "null": ("null\n", [("not-a-mapping", 1, 1)]),
    "no spaces": ("title:T\ncoordinates:[x]\n", [("not-a-mapping", 1, 1)]),
    "empty mapping": ("{}\n", [("missing-key", 1, 1), ("missing-key", 1, 1)]),
    "UTF-16": (HEAD.encode("utf-16"), [("not-text", 0, 0)]),
    "UTF-16 without mark": (HEAD.encode("utf-16-le"), [("control-character", 1, 2)]),
    "Latin 1": ("title: \xe9\ncoordinates: [x]\n".encode("latin-1"), [("not-text", 0, 0)]),
    "binary": (b"\x00\x01PK", [("control-character", 1, 1)]),
    "control": (b"title: T\ncoordinates: [x\x07]\n", [("control-character", 2, 16)]),
    "NUL": (b"title: T\x00\n", [("control-character", 1, 9)]),
    "too large": (b"#" * (MAX_BYTES + 1), [("file-too-large", 0, 0)]),
    "not too large": (b"#" * MAX_BYTES, [("empty-file", 0, 0)]),
    "tab": ("title: T\n\tcoordinates: [x]\n", [("not-yaml", 2, 1)]),
    "open bracket": ("title: T\ncoordinates: [x\n", [("not-yaml", 2, 14)]),
    "extra bracket": ("title: T\ncoordinates: [x]]\n", [("not-yaml", 2, 17)]),
    "extra brace": ("title: T\ncoordinates: {x: }}\n", [("not-yaml", 2, 19)]),
    "behind a list": (HEAD + "constraints:\n  a: [x, y] = [1, 2]\n", [("not-yaml", 5, 13)]),
    "open quote": ("title: 'T\ncoordinates: [x]\n", [("not-yaml", 1, 8)]),
    "indented": ("title: T\n coordinates: [x]\n", [("not-yaml", 2, 2)]),
    "two colons": ("title: T: U\ncoordinates: [x]\n", [("not-yaml", 1, 9)]),
    "at sign": ("title: @T\ncoordinates: [x]\n", [("not-yaml", 1, 8)]),
    "LaTeX in double quotes": (HEAD + 'let: {a: "\\dot x"}\n', [("not-yaml", 4, 11)]),
    "theta in double quotes": (HEAD + 'let: {a: "\\theta"}\n', [("escaped-latex", 4, 11)]),
    "deep lists": ("title: T\nlet: " + "[" * 30 + "]" * 30, [("nested-too-deep", 2, 25)]),
    "very deep lists": ("[" * 100_000, [("nested-too-deep", 1, 21)]),
    "very deep mappings": ("{a: " * 20_000, [("nested-too-deep", 1, 78)]),
    "many values": (HEAD + "find: [" + "x," * 20_001 + "x]", [("too-many-values", 4, 39962)]),
    "billion laughs": (laughs(), [("too-many-values", 5, 14)]),
    "many aliases": (HEAD + "find: [&a motion" + ", *a" * 51 + "]", [("too-many-aliases", 4, 219)]),
    "alias of itself": (HEAD + "let: {a: &a [*a, x]}\n", [("unknown-alias", 4, 14)]),
    "star": (HEAD + "gravity: *g\n", [("unknown-alias", 4, 10)]),
    "tag": ("title: !!python/object/apply:os.system [id]\ncoordinates: [x]\n", [("tag", 1, 8), ("wrong-kind", 1, 8)]),
    "own tag": (HEAD + "let: {a: !x y}\n", [("tag", 4, 10)]),
    "merge": (HEAD + "<<: {a: b}\n", [("merge-key", 4, 1)]),
    "two documents": ("title: T\ncoordinates: [x]\n---\ntitle: U\n", [("several-documents", 3, 1)]),
    "list as a key": (HEAD + "? [a]\n: b\n", [("key-not-a-name", 4, 3)]),
    "duplicate section": (HEAD + "title: U\n", [("duplicate-key", 4, 1)]),
    "duplicate parameter": (
        "title: T\ncoordinates: [x]\nparameters: {m: real, m: real}\n",
        [("duplicate-key", 3, 23)],
    ),
    "duplicate mass": (HEAD + "particles: {P: {mass: m, mass: m, position: 0}}\n", [("duplicate-key", 4, 26)]),
    "split": (HEAD + "let: {a: [x, atan2(y, x)]}\n", [("split-at-comma", 4, 14)]),
    "split in a mapping": (HEAD + "constraints: {a: x = atan2(y, x), b: y = 0}\n", [("split-at-comma", 4, 18)]),
    "split twice": (
        HEAD + "let: {a: [atan2(y, x), 1, atan2(x, y)]}\n",
        [("split-at-comma", 4, 11), ("split-at-comma", 4, 27)],
    ),
    "no space": (HEAD + "constraints: {a:x = 0}\n", [("missing-space", 4, 16)]),
}


@pytest.mark.parametrize("what", YAML)
def test_trap(what: str) -> None:
    text, expected = YAML[what]
    assert places(text) == expected


def test_a_split_list_in_quotes_is_whole() -> None:
    problem = read(HEAD + 'let:\n  a: [x, "atan2(y, x)"]\n  b: "[x, atan2(y, x)]"\n  c1: cross(i, j)\n')
    assert problem.scope.vectors["a"] == problem.scope.vectors["b"] == vector(x, sp.atan2(y, x), 0)
    assert 'put it in quotes: `"atan2(y, x)"`' in mistakes(YAML["split"][0])[0].help


def test_an_alias_repeats_a_value() -> None:
    problem = read(HEAD + "particles: {P: &P {mass: m, position: x*i}, Q: *P}\n")
    assert problem.particles[0].position == problem.particles[1].position == vector(x, 0, 0)


# -- every mistake at its place ---------------------------------------------------------------------------------------------

MISTAKES: dict[str, list[tuple[str, int, int]]] = {
    # the frame of the file
    "coordinates: [x]": [("missing-key", 1, 1)],
    "title: T": [("missing-key", 1, 1)],
    "title: T\ncoordinates: []": [("empty-value", 2, 14)],
    "title: T\ncoordinates:": [("empty-value", 2, 1)],
    "title: T\ncoordinates: x, y": [("wrong-kind", 2, 14)],
    "title:\ncoordinates: [x]": [("empty-value", 1, 1)],
    "title: ''\ncoordinates: [x]": [("empty-value", 1, 8)],
    "title: [a]\ncoordinates: [x]": [("wrong-kind", 1, 8)],
    HEAD + "gravty: g*j": [("unknown-key", 4, 1)],
    HEAD + "gravity:": [("empty-value", 4, 1)],
    HEAD + "axes: {l: up}": [("unknown-key", 4, 8)],
    # names
    "title: T\ncoordinates: [x, x]": [("declared-twice", 2, 18)],
    "title: T\nparameters: [x]\ncoordinates: [x]": [("declared-twice", 3, 15)],
    "title: T\nparameters: [theta]\ncoordinates: [θ]": [("declared-twice", 3, 15)],
    "title: T\ncoordinates: [t, pi, sin, dot, e_x]": [("reserved-name", 2, n) for n in (15, 18, 22, 27, 32)],
    "title: T\ncoordinates: [2x, x', a-b, '', _a]": [("bad-name", 2, n) for n in (15, 19, 23, 28, 32)],
    "title: T\ncoordinates: [x y]": [("bad-name", 2, 15)],
    f"title: T\ncoordinates: [{'x' * 61}]": [("bad-name", 2, 15)],
    f"title: T\ncoordinates: [{', '.join(f'x{n}' for n in range(1_001))}]": [("too-many-names", 2, 5905)],
    # parameters
    "title: T\nparameters: {m: positiv}\ncoordinates: [x]": [("unknown-assumption", 2, 17)],
    "title: T\nparameters: {m: negative}\ncoordinates: [x]": [("unknown-assumption", 2, 17)],
    "title: T\nparameters: {m: {asume: real}}\ncoordinates: [x]": [("unknown-key", 2, 18)],
    "title: T\nparameters: {m: {value: 0}}\ncoordinates: [x]": [("value-against-assumption", 2, 25)],
    "title: T\nparameters: {m: {assume: sign, value: 2}}\ncoordinates: [x]": [("value-against-assumption", 2, 39)],
    "title: T\nparameters: {m: {value: 1/0}}\ncoordinates: [x]": [("division-by-zero", 2, 27)],
    **{
        f"title: T\nparameters: {{m: {{value: {value}}}}}\ncoordinates: [x]": [("not-a-number", 2, 25)]
        for value in ("12:30", "0x10", "null", "~", "1_000", "3 m", "pi", "no", "yes", "i")
    },
    # functions
    HEAD + "functions: [f]": [("wrong-kind", 4, 12)],
    HEAD + "functions: {f: []}": [("no-arguments", 4, 16)],
    HEAD + "functions: {f: [X, X]}": [("declared-twice", 4, 20)],
    HEAD + "functions: {x: [X]}": [("declared-twice", 4, 13)],
    HEAD + "functions: {f: [X + Y]}": [("bad-name", 4, 17)],
    HEAD + "functions: {u: [t]}\nconstraints: {a: x = u(x)}": [("argument-of-prescribed", 5, 23)],
    HEAD + "functions: {f: [X]}\nconstraints: {a: f = 0}": [("no-argument", 5, 18)],
    # abbreviations
    HEAD + "let: {a: b, b: a}": [("circular-definition", 4, 7)],
    HEAD + "let: {a: a + 1}": [("circular-definition", 4, 7)],
    HEAD + "let: {x: y}": [("declared-twice", 4, 7)],
    HEAD + "let: {a: }": [("empty-value", 4, 10)],
    HEAD + "let: {a: x = y}": [("unexpected-equation", 4, 12)],
    HEAD + "let: {a: [x]}": [("wrong-kind", 4, 10)],
    HEAD + "let: {a: r_Q}": [("unknown-symbol", 4, 10)],
    # frames
    HEAD + "frame: polar": [("wrong-kind", 4, 8)],
    HEAD + "frame: {type: toroidal, coordinates: [x, y]}": [("unknown-frame", 4, 15)],
    HEAD + "frame: {type: spherical, coordinates: [x, theta]}": [("frame-coordinates", 4, 39)],
    HEAD + "frame: {type: polar, coordinates: [theta, phi]}": [("unknown-coordinate", 4, 43)],
    # particles and bodies
    HEAD + "particles: {P: {mass: m}}": [("missing-key", 4, 13)],
    HEAD + "particles: {P: {mass: x, position: 0}}": [("not-constant", 4, 23)],
    HEAD + "particles: {P: {mass: -m, position: 0}}": [("negative", 4, 23)],
    HEAD + "particles: {P: {mass: , position: 0}}": [("empty-value", 4, 17)],
    HEAD + "particles: {P: {mass: m, position: x}}": [("scalar-for-vector", 4, 36)],
    HEAD + "particles: {P: {mass: m, position: x'*i}}": [("not-allowed-here", 4, 36)],
    HEAD + "particles: {P: {mass: m, position: [x, y', 0]}}": [("not-allowed-here", 4, 40)],
    HEAD + "particles: {P: {mass: m, position: r_Q}, Q: {mass: m, position: r_P}}": [("circular-definition", 4, 13)],
    HEAD + "particles: {1: {mass: m, position: 0}}\nforces: {a: {on: 1, vector: F*i}}": [("bad-name", 4, 13)],
    HEAD + PARTICLES + "bodies: {P: {mass: m, inertia: A, position: 0, angle: x}}": [("declared-twice", 5, 10)],
    HEAD + "bodies: {B: {mass: m, position: 0, angle: x}}": [("missing-key", 4, 10)],
    HEAD + "bodies: {B: {inertia: A, position: 0}}": [("orientation", 4, 10)],
    HEAD + "bodies: {B: {inertia: [A, C], position: 0, angle: x}}": [("inertia", 4, 23)],
    HEAD + "bodies: {B: {inertia: '[A, A, C]', position: 0, angle: x}}": [("inertia", 4, 23)],
    HEAD + "bodies: {B: {inertia: [A, A, C], position: 0, angle: x}}": [("orientation", 4, 10)],
    HEAD + "bodies: {B: {inertia: [A, A, C], position: 0, orientation: {axes: zxz, angles: [x, y, theta]}}}": [
        ("unknown-sequence", 4, 67)
    ],
    HEAD + "bodies: {B: {inertia: [A, A, C], position: 0, axes: [i, i, j], angular_velocity: 0}}": [("axes", 4, 53)],
    HEAD + "bodies: {B: {inertia: [A, A, C], position: 0, axes: [j, i, e_z], angular_velocity: 0}}": [("axes", 4, 53)],
    # constraints
    HEAD + "constraints: [x = 0]": [("wrong-kind", 4, 14)],
    HEAD + "constraints: {a: x}": [("no-equals-sign", 4, 19)],
    HEAD + "constraints: {a: x = 0, y = 0}": [("bad-name", 4, 25)],
    HEAD + "constraints: {a: y >= 0}": [("inequality", 4, 20)],
    HEAD + "constraints: {a: 0 < y}": [("inequality", 4, 20)],
    HEAD + "constraints: {a: m = l}": [("restricts-nothing", 4, 18)],
    HEAD + "constraints: {a: x - x = 0}": [("restricts-nothing", 4, 18)],
    HEAD + "constraints: {a: sin(x)^2 = 1 - cos(x)^2}": [("restricts-nothing", 4, 18)],
    HEAD + "constraints: {a: x'' = 0}": [("not-allowed-here", 4, 18)],
    HEAD + "constraints: {a: delta(x) = 0}": [("not-allowed-here", 4, 18)],
    HEAD + "constraints: {a: d(x)*d(y) = 0}": [("not-a-form", 4, 18)],
    HEAD + "constraints: {a: d(x) = l}": [("not-a-form", 4, 18)],
    HEAD + 'constraints: {a: "d(x) = y\'"}': [("not-a-form", 4, 18)],
    HEAD + "constraints: {a: x/(sin(y)^2 + cos(y)^2 - 1) = 0}": [("division-by-zero", 4, 18)],
    HEAD + "constraints: {a: x*i = y}": [("scalar-for-vector", 4, 24)],
    HEAD + "constraints: {a: {equation: x = 0, reaction: m}}": [("declared-twice", 4, 46)],
    HEAD + "constraints: {a: {equation: x = 0, reaction: N}, b: {equation: y = 0, reaction: N}}": [
        ("declared-twice", 4, 81)
    ],
    HEAD + "constraints: {a: {reaction: N}}": [("missing-key", 4, 15)],
    HEAD + "constraints: {a: x = 0}\nlet: {b: lambda_a}": [("unknown-symbol", 5, 10)],
    HEAD + "constraints: {no-slip: x = 0}\nanswers: {integrable: {no-slip: true}}": [("bad-name", 4, 15)],
    # forces
    ALL + "gravity: g": [("scalar-for-vector", 7, 10)],
    ALL + "gravity: (0, -g)": [("list-in-parentheses", 7, 12)],
    ALL + "forces: {a: {on: P}}": [("force-kind", 7, 10)],
    ALL + "forces: {a: {on: P, force: F*i}}": [("unknown-key", 7, 21)],
    ALL + "forces: {a: {on: Z, vector: F}}": [("unknown-name", 7, 18), ("scalar-for-vector", 7, 29)],
    ALL + "forces: {a: {on: P, vector: x''*i}}": [("not-allowed-here", 7, 29)],
    ALL + "forces: {a: {on: P, vector: F*i, moment: F*j}}": [("force-kind", 7, 10)],
    ALL + "forces: {a: {on: P, moment: F*j}}": [("unknown-name", 7, 18)],
    ALL + "forces: {a: {spring: k, between: [P]}}": [("two-ends", 7, 34)],
    ALL + "forces: {a: {spring: k, between: [P, Z]}}": [("unknown-name", 7, 38)],
    ALL + "forces: {a: {friction: mu, constraint: rood, on: P}}": [("unknown-name", 7, 40)],
    ALL + "forces: {a: {friction: mu, constraint: rod, on: P, slip: up}}": [("unknown-sense", 7, 58)],
    ALL + "forces: {a: {potential: k*x'^2}}": [("not-allowed-here", 7, 27)],
    # the rest
    ALL + "unknowns: [x]": [("declared-twice", 7, 12)],
    ALL + "unknowns: N": [("wrong-kind", 7, 11)],
    ALL + "speeds: {u: x}": [("no-velocity", 7, 13)],
    ALL + "speeds: {u: x'*y'}": [("speed-not-linear", 7, 13)],
    ALL + "generalized_coordinates: {a: {coordinates: [s]}}": [("no-substitution", 7, 45)],
    ALL + "generalized_coordinates: {a: {coordinates: [s, theta], substitute: {x: s}}}": [
        ("coordinate-left-out", 7, 27)
    ],
    ALL + "generalized_coordinates: {a: {coordinates: [s, theta], substitute: {x: s', y: s}}}": [
        ("not-allowed-here", 7, 72)
    ],
    ALL + "generalized_coordinates: {a: {coordinates: [s, theta], substitute: {x: s, y: s, z: s}}}": [
        ("unknown-coordinate", 7, 81)
    ],
    ALL + "generalized_coordinates: {a: {coordinates: [m, theta], substitute: {x: m, y: m}}}": [
        ("declared-twice", 7, 45)
    ],
    ALL + "generalized_coordinates: {a: {coordinates: [y, theta], substitute: {x: y, y: x}}}": [
        ("kept-and-replaced", 7, 75)
    ],
    ALL + "equations: [\"x'' = 0\"]": [("two-systems", 7, 1)],
    ALL + "find: movement": [("unknown-question", 7, 7)],
    ALL + "find: motion, equilibrium": [("unknown-question", 7, 7)],
    ALL + "answers: {degrees_of_freedom: one}": [("not-a-number", 7, 31)],
    ALL + "answers: {classification: [holonomous]}": [("unknown-class", 7, 28)],
    ALL + "answers: {classification: [rheonomic, scleronomic]}": [("contradictory-answer", 7, 39)],
    ALL + "answers: {integrable: {rod: no}}": [("not-a-truth-value", 7, 29)],
    ALL + "answers: {integrable: {rood: true}}": [("unknown-name", 7, 24)],
    ALL + "answers: {equations: [\"x'' = q\"]}": [("unknown-symbol", 7, 30)],
    ALL + "answers: {equilibrium: [theta = q]}": [("unknown-symbol", 7, 33)],
    ALL + "answers: {reactions: {rod: q}}": [("unknown-symbol", 7, 28)],
}


@pytest.mark.parametrize("text", MISTAKES)
def test_mistake(text: str) -> None:
    assert places(text + "\n") == MISTAKES[text]


HELPS = {
    HEAD + "gravty: g*j": "did you mean `gravity`?",
    HEAD + "particles: {P: {mas: m, position: 0}}": "did you mean `mass`?",
    HEAD + "constraints: {a: {equation: x = 0, reacton: N}}": "did you mean `reaction`?",
    HEAD + "constraints: {a: thetta = 0}": "did you mean `theta`?",
    HEAD + "constraints: {a: x = ml}": "did you mean `m l`?",
    HEAD + "constraints: {a: y >= 0}": "reversible",
    HEAD + "constraints: {a: x = 0, y = 0}": "every entry is `name: ...`",
    ALL + "find: motion, equilibrium": "`find: [equilibrium, motion]`",
    ALL + "answers: {classification: [holonomous]}": "did you mean `holonomic`?",
    "title: T\nparameters: {m: negative}\ncoordinates: [x]": "minus",
    "title: T\ncoordinates: x, y": "`coordinates: [x, y]`",
    "title: T\ncoordinates: [x y]": "`[x, y]`",
}


@pytest.mark.parametrize("text", HELPS)
def test_help(text: str) -> None:
    found = mistakes(text + "\n")
    assert len(found) == 1
    assert HELPS[text] in found[0].help


def test_all_mistakes_of_a_file_are_told_at_once_in_its_order() -> None:
    text = """titel: Example
parameters: {m: positiv, g: }
coordinates: [x, 2y]
let: {a: sin(x}
particles: {P: {mass: x, position: x}}
constraints: {rod: x >= 0}
gravity: g*z
forces: {push: {on: Q, vector: g*i}}
find: movement
answers: {degrees_of_freedom: one}
"""
    assert places(text) == [
        ("unknown-key", 1, 1),
        ("unknown-assumption", 2, 17),
        ("bad-name", 3, 18),
        ("not-closed", 4, 13),
        ("not-constant", 5, 23),
        ("scalar-for-vector", 5, 36),
        ("inequality", 6, 22),
        ("unknown-symbol", 7, 12),
        ("unknown-name", 8, 21),
        ("unknown-question", 9, 7),
        ("not-a-number", 10, 31),
    ]


def test_a_mistake_is_shown_with_file_line_column_and_caret() -> None:
    with pytest.raises(ProblemError) as caught:
        read(HEAD + "constraints: {rod: x^2 = L^2}\n")
    assert caught.value.show() == (
        "error[unknown-symbol]: `L` is not declared\n --> problem.yaml:4:26\n  |\n"
        "4 | constraints: {rod: x^2 = L^2}\n  |                          ^\n  = help: did you mean `l`?"
    )


@pytest.mark.parametrize(
    ("text", "written"),
    [
        ('a: "sin(theta) + q"', "q"),
        ("a: 'sin(theta) + q'", "q"),
        ("a: >\n    sin(theta)\n    + q", "q"),
        ("a: |\n    sin(theta)\n    + q", "q"),
        ("a: sin(theta)\n    + q", "q"),
        ("a: '(theta'')'' + q'", "q"),
        ('a: "\\u03b8 + q"', "q"),
        ("a: θ̈ + q", "q"),
        ("a: &here theta + q", "q"),
    ],
)
def test_a_place_in_any_style_of_yaml(text: str, written: str) -> None:
    (found,) = mistakes(f"{HEAD}let:\n  {text}\n")
    assert found.span is not None
    assert found.span.source.text[found.span.start : found.span.end] == written


def test_a_mistake_is_not_repeated_where_its_name_is_used() -> None:
    assert places(HEAD + "let: {a: q, b: a, c1: b*i}\nparticles: {P: {mass: m, position: c1}}\n") == [
        ("unknown-symbol", 4, 10)
    ]
    found = mistakes(HEAD + "let: {a: q, b: q + 1}\nconstraints: {rod: x = q}\n")
    assert [d.code for d in found] == ["unknown-symbol"]
    assert found[0].label == "also on line 5"


def test_the_hundred_first_mistake_is_not_told() -> None:
    found = mistakes(HEAD + "constraints:\n" + "".join(f"  a{n}: q{n} = 0\n" for n in range(900)))
    assert len(found) == 101
    assert found[-1].code == "more-mistakes"


# -- what a file amounts to --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("lines", "code"),
    [
        (["a0: x + y", *(f"a{n + 1}: sin(a{n})*a{n}" for n in range(100))], "expression-too-large"),
        (["a0: x + y", *(f"a{n + 1}: a{n}^2" for n in range(100))], "exponent-too-large"),
        (["a0: x*i", *(f"a{n + 1}: cross(a{n}, x*y*j) + a{n}" for n in range(100))], "expression-too-large"),
    ],
)
def test_abbreviations_do_not_grow_without_bound(lines: list[str], code: str) -> None:
    found = mistakes(HEAD + "let:\n" + "".join(f"  {line}\n" for line in lines))
    assert [d.code for d in found] == [code]


def test_differentials_of_large_vectors_are_paid_for() -> None:
    """190 coordinates and 200 differentials of a vector with 190 sines took minutes."""
    names = [f"x{n}" for n in range(190)]
    terms = " + ".join(f"sin({p}*{q})" for p, q in zip(names, [*names[1:], names[0]], strict=True))
    text = f"title: T\ncoordinates: [{', '.join(names)}]\nlet: {{v: ({terms})*i}}\nconstraints:\n"
    text += "".join(f'  a{n}: "dot(d(v), i) = {n}*d(t)"\n' for n in range(200))
    assert {d.code for d in mistakes(text)} <= {"expression-too-large", "more-mistakes"}


def test_a_file_of_many_expressions_has_one_budget() -> None:
    """Three hundred constraints with a hundred sines each took two minutes; the budget is said to be spent once."""
    text = HEAD + "constraints:\n"
    for n in range(300):
        text += f"  a{n}: {' + '.join(f'sin({i + 100 * n}*x + y)*x^{i % 7}' for i in range(100))} = y\n"
    (found,) = mistakes(text)
    assert found.code == "expression-too-large"
    assert "all of the file" in found.message


def test_differentials_of_vectors() -> None:
    """In a turning frame, with a prescribed motion: d(a) = a' dt, and delta(a) leaves time out."""
    text = """title: T
coordinates: [r, phi]
functions: {u: [t]}
frame: {type: polar, coordinates: [r, phi]}
let: {a: r*e_r + u*t*i, b: d(a), c: delta(a), rate: a'}
"""
    scope = read(text).scope
    r, phi, u = (sp.Symbol(n, real=True) for n in ("r", "phi", "u"))
    total = scope.vectors["b"].fixed().components
    frozen = scope.vectors["c"].fixed().components
    rate = scope.vectors["rate"].fixed().components
    for n in range(3):
        to_rate = {sp.Symbol(f"d({q})", real=True): sp.Symbol(f"{q}'", real=True) for q in (r, phi)}
        to_rate[sp.Symbol("d(t)", real=True)] = sp.S.One
        assert sp.expand(total[n].xreplace(to_rate) - rate[n]) == 0
        to_total = {sp.Symbol(f"delta({q})", real=True): sp.Symbol(f"d({q})", real=True) for q in (r, phi)}
        still = {sp.Symbol("d(t)", real=True): sp.S.Zero}
        assert sp.expand(frozen[n].xreplace(to_total) - total[n].xreplace(still)) == 0
    assert total[0].has(u)


LINES = [
    *ALL.splitlines(),
    "gravity: g*j", "unknowns: [N]", "find: motion", "let: {a: x*i, b: a'}", 'functions: {f: [X], u: [t]}',
    "forces: {a: {on: P, vector: F*i}, s: {spring: k, between: [P, Q], length: l}}", "axes: {i: right}",
    "generalized_coordinates: {a: {coordinates: [s, theta], substitute: {x: l*sin(s), y: l*cos(s)}}}",
    "answers: {degrees_of_freedom: 2, classification: [holonomic], equations: [\"x'' = 0\"]}", "speeds: {s1: x' + y'}",
    "frame: {type: cartesian}", 'equations: ["x\'\' = 0"]', "description: >", "  some words",
]  # fmt: skip
BITS = [
    *"{}[]:,'\"#&*!|>%@-\n\t =?\x00é",
    ": ",
    "- ",
    "null",
    "x",
    "sin(",
    "''",
    "&a ",
    "*a",
    "!!str ",
    "<<: ",
    "---\n",
    "1e400",
    "\ufeff",
]


@st.composite
def misspelt_files(draw: st.DrawFn) -> str:
    """Lines of a file in some order, with characters cut out and put in."""
    text = "\n".join(draw(st.lists(st.sampled_from(LINES), max_size=12)) + draw(st.sampled_from([[], LINES[:3]])))
    for _ in range(draw(st.integers(0, 4))):
        start = draw(st.integers(0, len(text)))
        end = min(len(text), start + draw(st.integers(0, 8)))
        text = text[:start] + draw(st.sampled_from(["", *BITS])) + text[end:]
    return text


def check_file(text: str) -> None:
    """A problem, or mistakes that say where and what to do."""
    shown = "nothing is wrong"
    found: tuple[Diagnostic, ...] = ()
    try:
        read(text)
    except ProblemError as error:
        found, shown = error.diagnostics, error.show()
    assert shown
    for d in found:
        assert d.help, d.code
        assert d.span is None or 0 <= d.span.start <= d.span.end


@given(misspelt_files())
@settings(max_examples=300, deadline=None, suppress_health_check=[HealthCheck.too_slow])
def test_misspelt_files_are_refused_or_read(text: str) -> None:
    check_file(text)


@given(st.text(max_size=200))
@settings(max_examples=100, deadline=None)
def test_any_text_is_refused_or_read(text: str) -> None:
    check_file(text)


@given(st.binary(max_size=200))
@settings(max_examples=100, deadline=None)
def test_any_bytes_are_refused_or_read(data: bytes) -> None:
    try:
        text = decode(data, "problem.yaml").text
    except ProblemError as error:
        text = error.show()
    check_file(text)
