"""An example of every diagnostic code: what docs/diagnostics.md is made of.

    code: (what is wrong and what to do, example)

An example is an equation given to `lagsolve check ex11-ideal-pendulum -e ...` (a string), a problem file (`File`), or a
command line (`Command`). What cannot be shown in a page has None and is only described.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class File:
    """A problem file, as text or as bytes."""

    text: str | bytes


@dataclass(frozen=True)
class Checked(File):
    """A problem file whose own answers are checked."""


@dataclass(frozen=True)
class Command:
    """Arguments of `lagsolve`, and the name of a file that is there."""

    arguments: tuple[str, ...]
    beside: str = ""


def problem(more: str, coordinates: str = "[x, y]", parameters: str = "[m, l, g]") -> File:
    """A small problem file with more lines."""
    return File(f"title: Example\nparameters: {parameters}\ncoordinates: {coordinates}\n{more}\n")


PARTICLE = "particles: {P: {mass: m, position: x*i + y*j}}\n"
ROD = "constraints: {rod: x^2 + y^2 = l^2}\n"

EXAMPLES: dict[str, tuple[str, str | File | Command | None]] = {
    # -- expressions -------------------------------------------------------------------------------------------------
    "argument-of-prescribed": ("A coordinate or prescribed motion is a function of t alone.", File(
        "title: Example\ncoordinates: [x]\nfunctions: {u: [t]}\nconstraints: {a: x = u(x)}\n")),
    "ambiguous-product": ("A run of letters is a product of declared names in several ways; write spaces.", problem(
        "answers: {equations: ['aba \\cdot x = 0']}", parameters="[a, b, ab, ba]")),
    "bad-derivative": ("A derivative is written `\\dot{x}`, `\\frac{d^2 x}{dt^2}` or `\\frac{\\partial f}{\\partial x}`.",
        r"\frac{d^2\theta}{dt} = 0"),
    "bad-root": ("The index of a root is a positive integer.", r"\sqrt[n]{x} = 0"),
    "bad-subscript": ("An index has letters and digits, and belongs to a letter.", r"(\theta)_1 = 0"),
    "double-script": ("A letter has one exponent and one subscript; `_{1,2}` has two parts.", r"\theta^2^3 = 0"),
    "latex-argument": ("The argument of a command is in braces; without them it is one letter or digit.",
        r"\dot x^23 = 0"),
    "not-a-vector": ("Bold letters, arrows and hats belong to vectors.", r"\mathbf{x} = 0"),
    "unknown-command": ("Only mathematical commands are known, and macros that the answer itself defines.", r"\ddot{\thet} = 0"),
    "words-in-equation": ("Words stand beside an equation, not in it.", r"\theta = 0 + \text{a constant} + x"),
    "bad-exponent": ("A superscript is an integer.", "x⁻ = 0"),
    "bad-number": ("A number has one decimal point.", "1.2.3 = x"),
    "mass-exchange": ("Mass leaves a particle whose mass decreases, and joins one whose mass increases, with one velocity.",
        problem("particles: {P: {mass: m + l*t, position: x*i, leaves: {velocity: 0}}}\n", coordinates="[x]")),
    "words-for-body": ("`name:` has a few words for sentences, in one line, other than those of other bodies.", problem(
        "particles: {P: {name: bob, position: x*i}, Q: {name: bob, position: y*j}}\n")),
    "variable-mass": ("Say with what velocity mass leaves or joins a particle whose mass varies.", problem(
        "particles: {P: {mass: m - l*t, position: x*i}}\n", coordinates="[x]")),
    "starts-without-mass": ("A particle that has no mass at t = 0 has no determined motion: begin with a small one.", problem(
        "particles: {P: {mass: m*x, position: x*i, gains: {velocity: 0}}}\ngravity: g*i\ninitial: {x: 0, x': 0}\n",
        coordinates="[x]")),
    "two-starts": ("Questions of a file with an impact are about the motion after it, which begins with the impact.", problem(
        PARTICLE + "impact: {before: {x: 0, y: 0, x': g, y': 0}, constraints: {wall: x = 0}}\ninitial: {y: l}\n"
        "ask: {far: {quantity: y, when: t = 1}}\n")),
    "misplaced-gravity": ("Gravity acts on every mass: it is a key of the problem, and not one of its forces.", problem(
        PARTICLE + "forces: {gravity: -g*j}\n")),
    "components": ("A vector has two or three components.", problem("gravity: '[1, 2, 3, 4]'")),
    "constant-too-involved": ("A constant is worked out exactly; write it more simply, or as a parameter.", None),
    "division-by-vector": ("Divide by the length of the vector.", problem("let: {n: '(x*i)/(y*j)'}")),
    "division-by-zero": ("The divisor is exactly zero, always or wherever the constraints hold.", "x/(1 - 1) = 0"),
    "empty-brackets": ("There must be something between brackets.", "sin() = 0"),
    "empty-expression": ("Write an expression.", problem("let: {n: ' '}")),
    "empty-side": ("Both sides of an equation must be there; write 0 where nothing is left.", "theta'' ="),
    "ends-early": ("The expression stops where something must follow.", "theta'' = g +"),
    "exponent-too-large": ("Exponents are limited to 20, and nested ones to 40 together.", "theta''^(10^10) = 0"),
    "expression-too-large": ("Multiplied out, the expression has too many terms; leave out or abbreviate.",
        "(x + y + m + g + l + theta)^20 * (x + y + m + g + l + theta')^20 = 0"),
    "expression-too-long": ("An expression may have 10,000 characters, one of an answer 2,000.",
        "theta + " * 300 + "x = 0"),
    "function-exponent": ("The inverse function is called asin, not sin^-1.", "sin^-1(x) = theta"),
    "indefinite-constant": ("Whether a constant is zero or not could not be settled; simplify it.", None),
    "inequality": ("Answers are equations, and so are constraints that hold from both sides. A one-sided constraint has "
        "one `<=` or `>=`: in contact, the two sides are equal.", problem("constraints: {floor: y > 0}")),
    "invisible-character": ("Delete the character; it was probably copied from a web page.", "theta''\u200b = 0"),
    "list-in-parentheses": ("A list of components is written in square brackets.", problem("gravity: '(0, g)'")),
    "misplaced-operator": ("An operator goes between two expressions.", "theta'' * / x = 0"),
    "misplaced-prime": ("A prime follows what it differentiates.", "'x = 0"),
    "missing-operator": ("Write the operator.", None),
    "nested-too-deep": ("Brackets nest 60 deep at most; introduce abbreviations with `let`.",
        "(" * 80 + "x" + ")" * 80 + " = 0"),
    "no-argument": ("A function needs its argument.", "theta'' = sin"),
    "no-equals-sign": ("An equation has an equals sign.", "theta'' + g/l"),
    "not-a-differential": ("d(x) and delta(x) apply to a coordinate, a vector, or t.", "d(m) = 0"),
    "not-a-variable": ("`diff` differentiates by a coordinate, a velocity, a parameter or t.", "diff(x^2, 2*x) = 0"),
    "not-closed": ("Close the bracket.", "theta'' = sin(theta"),
    "not-finite": ("The value is infinite.", "tan(pi/2) = x"),
    "not-opened": ("Open the bracket, or remove this one.", "sin(theta)) = 0"),
    "not-real": ("The value is not a real number.", "sqrt(-1)*x = 0"),
    "number-of-arguments": ("The function takes another number of arguments.", "atan2(x) = 0"),
    "number-too-large": ("The result is too large to be intended.", None),
    "number-too-long": ("A number has 30 digits at most, and a power of ten up to 40; make it a parameter with a `value`.",
        "3.14159265358979323846264338327950288 = x"),
    "prime-of-constant": ("A parameter is constant; what varies is a coordinate or a function `u: [t]`.", "m' = 0"),
    "prime-of-function": ("Write the derivative of a function with `diff`.", File(
        "title: Example\ncoordinates: [x]\nfunctions: {f: [X]}\nconstraints: {a: f'(x) = 0}\n")),
    "product-of-vectors": ("Two vectors are multiplied with dot or cross.", problem("gravity: (x*i)*(y*j)")),
    "read-as": ("A note: the text could be read in two ways, and this is the one that was taken.",
        "theta'' = -g/l sin theta"),
    "scalar-for-vector": ("Multiply by a unit vector, or list components.", problem("gravity: g")),
    "several-equals-signs": ("One equation at a time.", problem("constraints: {a: x = y = 0}")),
    "too-many-primes": ("Positions, velocities and accelerations are all there is.", "x''' = 0"),
    "two-readings": ("Write `2*m` for the product; for a unit give the parameter another name.", File(
        "title: Example\ncoordinates: [x]\nparameters: [m, c]\nparticles: {P: {mass: m, position: c*x*i}}\n"
        "initial: {x: 2 m}\n")),
    "unexpected-character": ("This character means nothing here.", "theta'' @ gravity = 0"),
    "unexpected-equation": ("An expression without an equals sign is required here.", problem("gravity: g = 0")),
    "unknown-function": ("Functions other than the known ones must be declared.", "erf(x) = 0"),
    "unknown-symbol": ("Every symbol must be declared; `ml` is one name, `m l` a product.",
        "m l theta'' + gr*sin(theta) = 0"),
    "vector-for-scalar": ("A vector is used where a number is expected.", "sin(r_P) = theta"),
    "vector-power": ("Write dot(a, a) for the square of a vector.", "r_P^2 = l^2"),
    # -- the file ----------------------------------------------------------------------------------------------------
    "control-character": ("Delete the character.", File(b"title: Exa\x01mple\ncoordinates: [x]\n")),
    "duplicate-key": ("YAML would silently keep the last one.", problem("constraints: {a: x = 0, a: y = 0}")),
    "empty-file": ("A problem has at least a title and coordinates.", File("")),
    "empty-value": ("A key without a value.", problem("forces: {push: {on: P, vector: }}\n" + PARTICLE)),
    "escaped-latex": ("In double quotes a backslash begins an escape; use single quotes.", None),
    "file-too-large": ("A problem file has one megabyte at most.", File(b"#" * (1 << 20) + b"#")),
    "is-a-folder": ("Name a file.", Command((".",))),
    "key-not-a-name": ("A key is a name.", problem("constraints: {[a, b]: x = 0}")),
    "merge-key": ("Write the keys out.", None),
    "missing-space": ("A colon is followed by a space.", None),
    "more-mistakes": ("Only the first mistakes of a file are shown.", None),
    "factor-excluded": (
        "A note: a factor without velocities vanishes somewhere. The constraint is considered where it does not.",
        problem("constraints: {skate: \"x*(x' - y')^2 = 0\"}")),
    "file-beside": (
        "A name without `.yaml` is a problem of the library, whatever files exist. The exit status is not changed.",
        Command(("check", "ex11", "-e", "theta'' + g/l*sin(theta) = 0"), beside="ex11.yaml")),
    "no-such-file": ("Check the name.", Command(("nothing.yaml",))),
    "no-such-problem": ("`lagsolve list` shows the library.", Command(("ideal-pendulum",))),
    "several-problems": ("Several problems of the library begin with that.", None),
    "no-standard-input": ("There is nothing on standard input.", None),
    "not-a-mapping": ("A problem file is a mapping of keys.", File("pendulum\n")),
    "not-text": ("Save the file as UTF-8.", File(b"\xff\xfet\x00i\x00")),
    "not-yaml": ("The text is not YAML here; quote what has special characters.", File("title: [Pendulum\n")),
    "several-documents": ("One file holds one problem.", File("title: A\n---\ntitle: B\n")),
    "split-at-comma": ("Quote an item that has a comma inside parentheses.", problem("let: {a: [x, atan2(y, x)]}")),
    "tag": ("YAML tags are not accepted.", File("title: !!python/object/apply:os.system [id]\ncoordinates: [x]\n")),
    "too-many-aliases": ("The number of aliases is limited, and so is what they expand to.", None),
    "too-many-values": ("A file has 20,000 values at most.", None),
    "unknown-alias": ("A value that begins with `*` must be quoted.", None),
    "unreadable-file": ("The system does not allow the file to be read.", None),
    "file-exists": ("`lagsolve new` never overwrites a file.", None),
    "no-such-folder": ("Create the folder first.", Command(("new", "mechanics/pendulum.yaml"))),
    "cannot-write": ("The output cannot be written there. An old file stays as it was, unless its folder is read-only.", None),
    "journal-ignored": (
        "A note: the journal of an interrupted batch has lines that no batch has written. They are not used, and the "
        "submissions are graded again. The exit status is not changed.", None),
    "given-up": (
        "The problem takes more work, time or memory than is allowed. What was found before that is printed; with "
        "`--timeout` the work may take as long as you say. Exit status 3.",
        None,
    ),
    "out-of-memory": ("The computer has not enough memory for this derivation. Exit status 3.", None),
    # -- the problem -------------------------------------------------------------------------------------------------
    "axes": ("A triad has three vectors.", None),
    "bad-name": ("A name has letters, digits and underscores, and begins with a letter.", problem("let: {2x: x}")),
    "reserved-name": ("The name belongs to a function, to time, or to a unit vector.", File(
        "title: Example\ncoordinates: [t]\n")),
    "circular-definition": ("Abbreviations and positions must not be defined in terms of one another.",
        problem("let: {a: b, b: a}")),
    "circular-substitution": ("Write each old coordinate in terms of the chosen ones.", problem(
        PARTICLE + "generalized_coordinates: {c: {coordinates: [s], substitute: {x: y + s, y: x}}}")),
    "dependent-speeds": ("A quasi-velocity is independent of the others and of the constraints: there are as many as there are "
        "degrees of freedom, or fewer.", problem(PARTICLE + "speeds: {u: \"x' + y'\", v: x', w: y'}")),
    "speed-not-linear": ("A quasi-velocity is linear in the velocities.", problem("speeds: {u: \"x'^2 + y'^2\"}")),
    "contradictory-answer": ("The textbook's answer contradicts itself.",
        problem("answers: {classification: [holonomic, nonholonomic]}")),
    "coordinate-left-out": ("Every old coordinate is kept or replaced.", problem(
        PARTICLE + "generalized_coordinates: {c: {coordinates: [s], substitute: {x: s}}}")),
    "declared-twice": ("A symbol means one thing in a file.", problem("", parameters="[m, x]")),
    "force-kind": ("A force has exactly one kind.", problem(PARTICLE + "forces: {push: {on: P}}")),
    "frame-coordinates": ("A frame has its number of coordinates.", problem("frame: {type: polar, coordinates: [x]}")),
    "inertia": ("One moment of inertia in the plane, three in space.", None),
    "kept-and-replaced": ("An old coordinate is kept or replaced.", problem(
        PARTICLE + "generalized_coordinates: {c: {coordinates: [x], substitute: {x: 2*x, y: 0}}}")),
    "missing-key": ("The key is needed.", File("coordinates: [x]\n")),
    "negative": ("A mass or moment of inertia is not negative.", problem("particles: {P: {mass: -m, position: x*i}}")),
    "no-arguments": ("A function names its arguments; `u: [t]` is a prescribed motion.", problem("functions: {f: []}")),
    "no-substitution": ("Say how the old coordinates follow from the new one.", problem(
        PARTICLE + "generalized_coordinates: {c: {coordinates: [theta]}}")),
    "no-state": ("The state at t = 0 is given by coordinates and velocities.", problem("initial: {m: 2}")),
    "velocity-multiple": ("A multiple of a velocity, `r*phi'`, gives the velocity where its factor is known and not 0.",
        problem(PARTICLE + "initial: {y: 0, x*y': g}")),
    "contradictory-state": ("The state just before an impact satisfies the constraints of the file, and its position the new ones too.",
        problem(PARTICLE + ROD + "impact: {before: {x: l, y: l}, impulses: {blow: {on: P, vector: m*i}}}")),
    "contradictory-impact": ("An impact needs an approach, impulses that push, and velocities after it that agree.",
        problem(PARTICLE + "impact: {before: {y': g, x': 0}, constraints: {floor: y >= 0}}")),
    "bad-restitution": ("A coefficient of restitution is between 0 and 1.",
        problem(PARTICLE + "impact: {constraints: {floor: y >= 0}, restitution: {floor: 2}}")),
    "empty-impact": ("An impact has impulses, or constraints that begin to act.", problem(PARTICLE + "impact: {before: {x': 0}}")),
    "initial-contradicts": ("The state at t = 0 must satisfy the constraints; leave out what follows from the rest.",
        problem(PARTICLE + ROD + "initial: {x: l, y: l, x': 0, y': 0}\nask: {tension: {quantity: lambda_rod, when: x = 0}}")),
    "negative-radius": ("The radius of a polar, cylindrical or spherical frame is not negative.", problem(
        "frame: {type: polar, coordinates: [r, phi]}\nparticles: {P: {mass: m, position: r*e_r}}\n"
        "initial: {r: -l, r': 0, phi: 0, phi': 0}\nask: {what: {quantity: \"r'\", when: r = l}}",
        coordinates="[r, phi]")),
    "negative-coefficient": ("A coefficient of friction, and the angle of a belt on its drum, are not negative.", problem(
        PARTICLE + "forces: {drum: {belt: m, angle: -pi, tight: g, slack: l}}\nfind: equilibrium")),
    "nothing-asked": ("A question asks for something that has to be found.",
        problem(PARTICLE + "ask: {what: {quantity: 2}}")),
    "no-variable": ("`by` names one coordinate, or t.",
        problem(PARTICLE + "ask: {height: {quantity: y, by: m}}")),
    "not-determined": ("Say at which state the quantity is wanted, or complete the initial state.",
        problem(PARTICLE + "gravity: -g*j\ninitial: {y: l, y': 0}\nask: {height: {quantity: y}}")),
    "never-holds": ("The condition of a question contradicts the initial state.", problem(
        PARTICLE + "gravity: -g*j\ninitial: {y: 0, y': 0}\nask: {speed: {quantity: \"y'\", when: y = l}}")),
    "mixed-choices": ("A question uses the file's coordinates and those of one choice.", problem(
        PARTICLE + ROD + "generalized_coordinates:\n"
        "  a: {coordinates: [p], substitute: {x: l*sin(p), y: l*cos(p)}}\n"
        "  b: {coordinates: [q], substitute: {x: l*cos(q), y: l*sin(q)}}\n"
        "ask: {both: {quantity: p, when: q = 0}}")),
    "too-many-questions": ("A file asks 20 questions at most.", None),
    "no-velocity": ("A quasi-velocity is made of velocities.", problem("speeds: {u: x}")),
    "not-a-form": ("In differentials a constraint is linear and homogeneous.",
        problem("constraints: {a: d(x)*d(y) = 0}")),
    "not-a-number": ("A number is required here.", problem("answers: {degrees_of_freedom: two}")),
    "not-a-truth-value": ("Write true or false.", problem(ROD + "answers: {integrable: {rod: maybe}}")),
    "no-forces": ("Equilibrium is asked for, but no force acts.", problem("find: equilibrium")),
    "force-of-motion": ("Equilibrium is asked for, but a force depends on the motion or on time.", problem(
        PARTICLE + "forces: {drag: {on: P, vector: -m*x'*i}}\nfind: equilibrium")),
    "moving-constraint": ("Equilibrium is asked for, but a constraint moves.", problem(
        PARTICLE + "constraints: {belt: x = l*t}\nforces: {push: {on: P, vector: g*i}}\nfind: equilibrium")),
    "orientation": ("Say how the body is turned, in the way that fits its inertia.", problem(
        "bodies: {B: {mass: m, inertia: m*l^2, position: x*i}}")),
    "one-sided": ("A one-sided constraint is a scalar condition on positions, kept by a surface or a string.",
        problem("constraints: {wall: x' >= 0}")),
    "restricts-nothing": ("A constraint relates coordinates.", problem("constraints: {a: m = l}")),
    "not-allowed-here": ("Positions have no velocities, forces no accelerations, masses no coordinates.",
        problem("particles: {P: {mass: m, position: x'*i}}")),
    "too-many-names": ("The number of names in a file is limited.", None),
    "two-ends": ("A spring or damper has two ends.", problem(PARTICLE + "forces: {s: {spring: g, between: [P]}}")),
    "two-systems": ("`equations` takes the place of particles and bodies.", problem(
        PARTICLE + "equations: [\"x'' = 0\"]")),
    "unknown-assumption": ("positive, nonnegative, real, sign or acute.", problem("", parameters="{m: positiv}")),
    "unknown-class": ("The classes are fixed words.", problem("answers: {classification: [holonomous]}")),
    "unknown-coordinate": ("Name one of the file's coordinates.",
        problem("frame: {type: polar, coordinates: [r, phi]}")),
    "unknown-frame": ("The frames are cartesian, polar, cylindrical and spherical.",
        problem("frame: {type: toroidal, coordinates: [x, y]}")),
    "unknown-key": ("The key is misspelt.", problem("constraint: {rod: x = 0}")),
    "unknown-name": ("The file has no particle, body or constraint of that name.", problem(
        PARTICLE + "forces: {push: {on: Q, vector: g*i}}")),
    "unknown-question": ("Ask for constraints, equilibrium, motion, linearization, impending, hamiltonian, steady, impact or response.", problem("find: movement")),
    "unknown-keeper": ("What keeps a constraint: a rod, a string, a surface, a wire, a hinge, rolling or a gear.", problem(
        PARTICLE + "constraints: {rod: {equation: x^2 + y^2 = l^2, by: rubber}}")),
    "unknown-sense": ("Write positive or negative.", problem(
        PARTICLE + ROD + "forces: {rub: {friction: g, constraint: rod, on: P, slip: up}}")),
    "sense-off-line": ("A spring has a sense only along a unit vector.", problem(
        PARTICLE + "forces: {s: {spring: m, between: [P, '[0, 0]'], length: l, sense: positive}}")),
    "unknown-sequence": ("One of the twelve sequences of rotations.", problem(
        "bodies: {B: {mass: m, inertia: [m, m, m], position: x*i, orientation: {axes: 311, angles: [x, y, x]}}}")),
    "unit-mismatch": ("The unit of a value has another dimension than the parameter's `unit`, or than its place in the "
        "problem: a mass is in kg, a force in N.",
        problem("", parameters="{l: {value: 30 cm, unit: kg}}")),
    "bad-range": ("A range has a least and a greatest value.", problem("", parameters="{l: {range: [2 m, 1 m]}}")),
    "shape": ("A shape is one of the known ones.", problem(
        "particles: {P: {mass: m, position: x*i, shape: {disc: l, box: [l, l]}}}")),
    "figure-word": ("The kind of a circle or curve in a figure is one of a few words.", problem(
        PARTICLE + "figure: {circles: [{centre: P, radius: l, as: disk}]}")),
    "figure-too-large": ("Nobody can tell so many parts of a figure apart.", problem(
        PARTICLE + "figure: {lines: [" + ", ".join(["[P, O]"] * 61) + "]}")),
    "assumed-of-coordinate": ("Only parameters are positive; a coordinate has a range.", problem(
        PARTICLE, coordinates="{x: positive, y: height}")),
    "unused-parameter": ("A parameter appears nowhere: a force has been forgotten, or another letter was meant.", problem(
        PARTICLE, parameters="[m, k]")),
    "inertia-dimension": ("A moment of inertia is a mass times the square of a length.", problem(
        "bodies: {rod: {mass: m, inertia: m*l/12, position: l*sin(theta)*i, angle: theta}}", parameters="[m, l]", coordinates="[theta]")),
    "bad-setting": ("`--set` gives a parameter its value.", Command(("ex11", "--set", "l"))),
    "unknown-parameter": ("`--set` names something that is no parameter of the problem.", Command(
        ("ex11", "--set", "L=30 cm"))),
    "unknown-unit": ("A value has a unit that is not known, or ambiguous as `J/kg K` is.",
        problem("", parameters="{l: {value: 3 furlong}}")),
    "value-against-assumption": ("Change the value or the assumption.",
        problem("", parameters="{m: {assume: positive, value: -1}}")),
    "wrong-kind": ("A list, a mapping or a value is given where another of these is required.",
        problem("constraints: [x = 0]")),
    # -- the derivation ----------------------------------------------------------------------------------------------
    "friction-place": ("Friction acts on what its constraint holds, at the point of contact. The coordinates must place it freely: "
        "a constraint that they satisfy by themselves has no reaction.", problem(
        "particles: {P: {mass: m, position: x*i + y*j}, Q: {mass: m, position: l*i}}\n" + ROD
        + "forces: {rub: {friction: g, constraint: rod, on: Q}}")),
    "static-below-kinetic": ("The coefficient at rest is usually the larger one; the two may have been exchanged.", problem(
        PARTICLE + "constraints: {floor: y >= 0}\n"
        "forces: {rub: {friction: 1/2, static: 1/3, constraint: floor, on: P}, push: {on: P, vector: -g*j}}")),
    "spring-sense": ("On a line the length of a spring is an absolute value, unless the file says in which sense it lies.", problem(
        "particles: {P: {mass: m, position: x*i}}\nforces: {tie: {spring: c, between: [O, P], length: l}}",
        coordinates="[x]", parameters="[m, c, l]")),
    "angle-in-radians": ("A number without a unit is in SI units, an angle in radians; 30 degrees are `30 deg`.", problem(
        PARTICLE + "forces: {push: {on: P, vector: m*g*cos(beta)*i}}",
        parameters="{m: positive, g: positive, beta: 30}")),
    "impending-without-friction": ("Impending motion is equilibrium with static friction at its limit.", problem(
        PARTICLE + "forces: {push: {on: P, vector: g*i}}\nfind: impending")),
    "friction-slip": ("`slip` says in which sense a particle slides along a line; leave it out where there is none.", problem(
        "particles: {P: {mass: m, position: '[x, y, z]'}}\nconstraints: {floor: z = 0}\n"
        "forces: {rub: {friction: g, constraint: floor, on: P, slip: positive}}", coordinates="[x, y, z]")),
    "friction-unpressed": ("The reaction that would press is zero, and so is the friction; usually a weight has been forgotten.", problem(
        "particles: {P: {mass: m, position: x*i + y*j}}\nconstraints: {floor: y >= 0}\n"
        "forces: {push: {on: P, vector: m*g*i}, rub: {friction: 1/2, constraint: floor, on: P}}")),
    "friction-undetermined": ("Several constraints act in the same way, and how they share the reaction is not determined; "
        "remove those that follow from the others.", problem(
        PARTICLE + "constraints: {floor: y = 0, again: 2*y = 0}\n"
        "forces: {rub: {friction: g, constraint: floor, on: P}}")),
    "choice-against-constraint": ("The substitution must satisfy every geometric constraint identically.", problem(
        PARTICLE + ROD + "generalized_coordinates: {angle: {coordinates: [th], substitute: {x: l*sin(th), y: l*sin(th)}}}")),
    "contradictory-constraints": ("No position or velocity satisfies these constraints.",
        problem("constraints: {a: x = 0, b: x = 1}")),
    "dependent-coordinates": ("The chosen coordinates move the system in fewer directions than there are of them.",
        problem(
        PARTICLE + ROD + "generalized_coordinates: {two: {coordinates: [a, b], substitute: {x: l*sin(a+b), y: l*cos(a+b)}}}")),
    "too-few-coordinates": ("The choice would add a constraint of its own.", problem(
        PARTICLE + "generalized_coordinates: {line: {coordinates: [s], substitute: {x: s, y: s}}}")),
    "no-direction": ("Both ends of a spring are one point.", problem(
        PARTICLE + "constraints: {floor: y = 0}\nforces: {s: {spring: g, between: [P, x*i], length: l}}\n")),
    "no-inertia": ("Something moves without mass; the equations do not determine its acceleration.", problem(
        "particles: {P: {mass: m, position: x*i}}\n")),
    "no-cyclic-coordinate": ("Steady motions are those in which a coordinate that the equations do not contain changes at "
        "a constant rate.", problem(PARTICLE + "forces: {f: {potential: (x^2 + y^2)/2}}\nfind: steady\n")),
    "impossible-inertia": ("No distribution of mass has such a tensor of inertia.", problem(
        "bodies: {B: {mass: m, inertia: [[1, 2, 0], [2, 1, 0], [0, 0, 1]], position: x*i,\n"
        "             orientation: {axes: 313, angles: [y, x, y]}}}\n")),
    "varying-inertia": ("Axes that spin in the body need two equal moments of inertia.", problem(
        "bodies: {B: {inertia: [m, l, l], position: 0*i, axes: [i, j, k], angular_velocity: x'*k}}\n"
        "particles: {P: {mass: m, position: y*j}}\n")),
    "singular-constraint": ("The derivatives of the constraint vanish where it holds, so that it restricts nothing.",
        problem("constraints: {a: sin(x) = 1}")),
    "unstated-condition": ("These constraints can be met only where one more relation holds. Add it.",
        problem("constraints: {a: x = 0, b: \"x' = y\"}")),
    "no-reference-motion": ("Linear equations in numbers need `initial`, which says about which motion.", None),
    "not-steady": ("Equations are linear about a steady motion or a state of rest.", None),
    "undetermined-motion": ("Give as many velocities as there are degrees of freedom.", None),
    "initial-off-constraints": ("A steady motion satisfies the constraints; leave out what follows from the rest.", None),
    "values-needed": ("Linear equations in numbers need values.", None),
    "not-covered": ("The format allows this, but the program does not support it yet. Exit status 3.", problem(
        PARTICLE + "unknowns: [F]\nforces: {push: {on: P, vector: F*i}}\nfind: linearization")),
    "several-branches": ("The constraint is satisfied in several ways; a problem is about one of them.", problem(
        "constraints: {wedge: \"x'^2 = l^2*y'^2\"}")),
    "undecided": ("The question could not be settled, and nothing is guessed. Exit status 3.", None),
    "check-failed": ("A check of the solution did not hold. Exit status 3. Please report it.", None),
    "answer-differs": ("What `answers` says is not what is derived. Exit status 3.", problem(
        PARTICLE + ROD + "answers: {degrees_of_freedom: 2}")),
    "no-such-choice": ("The problem has no choice of coordinates of that name.",
        Command(("ex11", "--choice", "angel"))),
    "function-not-given": (
        "In Python, a simulation needs to know every function of time or place that moves the system.", None),
    "missing-extra": ("Simulations and plots need NumPy, SciPy and Matplotlib: the extra `sim`.", None),
    "no-answer": ("Give equations with -e, or in a file.", None),
    "method-without-motion": ("A note: `--method` chooses how equations of motion are derived, and none are asked for.",
        Command(("ladder", "--method", "lagrange"))),
    "not-judged": ("A note: this part of an answer is no equation asked for (a definition, a value, an energy).",
        "theta'' = -omega^2*sin(theta), omega = sqrt(g/l)"),
    "not-compared": (
        "Answers of the file in coordinates that `--choice` leaves out are read but not compared.",
        Command(("ex11", "--choice", "depth", "--detail", "brief"))),
    "no-equations": ("Equations of motion are asked for, but nothing has a mass.", Command(("export", "ex05", "--to", "c"))),
    "reference-contradictory": ("No motion satisfies all of the equations that are given to check answers against.", Checked(
        "title: Example\ncoordinates: [x]\nequations: [x'' = 1, x'' = 2]\nanswers: {equations: [x'' = 1]}\n")),
    "reference-coordinates": ("The equations that are given to check answers against are in the coordinates of the file.",
        Checked("title: Example\nparameters: [l, g]\ncoordinates: [x, y]\nconstraints: {rod: x^2 + y^2 = l^2}\n"
             "generalized_coordinates: {a: {coordinates: [theta], substitute: {x: l*sin(theta), y: l*cos(theta)}}}\n"
             "equations: [\"theta'' + g/l*sin(theta) = 0\"]\nanswers: {equations: [x'' = 1]}\n")),
    "reference-not-linear": ("Answers are checked against equations of motion.", Checked(
        "title: Example\ncoordinates: [x]\nequations: [x'^2 = 1]\nanswers: {equations: [x'' = 1]}\n")),
    "too-many-equations": ("An answer has twelve equations at most.",
        Command(("check", "ex11", *("-e", "x = 0") * 13))),
    "no-submissions": ("Name files, or a folder that has some.", None),
    "feedback-among-answers": ("The pages need a folder of their own.",
        Command(("grade", "ex11", ".", "--feedback", "."))),
    "would-be-lost": ("`--csv` names a file that is not a table of grades.", None),
    "several-submissions": ("Gradescope and PrairieLearn grade one submission at a time: name its folder.",
        Command(("grade", "ex11", "a.txt", "b.txt", "--format", "gradescope"))),
    "bad-roster": ("The table of `--roster` is your own CSV, or the one that a platform gives out.", Command(
        ("grade", "ex11", ".", "--roster", "marks.csv"), "marks.csv")),
    "bad-time": ("Times are in ISO 8601; times that are compared all have a time zone, or none has.",
        Command(("grade", "ex11", ".", "--due", "tomorrow"))),
    "nothing-varies": ("A variant needs values to be drawn: the section `vary`.", Command(("variant", "ex11", "--seed", "anna"))),
    "bad-seed": ("A seed is a short text: the name or the number of a student.", None),
    "variant-without-answer": ("The values that a seed draws leave no answer: no equilibrium, a question without one, or a stated answer "
        "that belongs to other values.", None),
    "variant-not-written": ("The values of a variant could not be written into the text of the problem file.", None),
    "several-answer-files": ("A folder with the submission of one person has one file of answers in YAML.", None),
    "limits-too-low": ("The problem cannot be solved with the memory that a submission may use.", None),
    "no-cluster": ("The Dask cluster cannot be reached, or its workers cannot grade.", None),
    "internal": ("A mistake of the program. Please report it with the problem file.", None),
}  # fmt: skip
