"""`lagsolve new`: a problem file to start from, written where there is none.

The template is a small problem that solves as it stands, with every key explained: the comment on a key is its meaning
in `lagrange.problem.keys`, followed by what the example adds. An unused key is commented out by `#` without a space; a
sentence has the space. A test removes the `#`: every such line is then accepted, alone and with the others.
"""

from __future__ import annotations

import os
import re
import shlex
import textwrap
from pathlib import Path

import click

from lagrange.core.diagnostics import Diagnostic, ProblemError
from lagrange.problem import library
from lagrange.problem.keys import PROBLEM
from lagsolve.command_group import write_stderr
from lagsolve.output import write_stdout

_EXAMPLE = """\
# A problem for lagsolve. It solves as it stands: change it to yours. After a #
# without a blank comes a key that is not in use; delete the # to use it. Every
# value is read as text: names such as y and n stay names. Equations with primes
# (velocities x', accelerations x'') go in double quotes. All keys and their
# forms are in docs/problem-files.md of lagsolve.
#
# For completion in an editor, lagsolve schema > lagsolve.schema.json, and here
#   `# yaml-language-server: $schema=lagsolve.schema.json` on a line of its own.

title: Pendulum

#source: the book, the chapter, the number

description: A particle hangs from the fixed point O by a massless rod.

axes: {i: right, j: down}

# An assumption is positive, nonnegative, real, sign (that is, +1 or -1) or acute.
parameters:
  m: positive
  l: {assume: positive, unit: m, meaning: length of the rod}
  g: {unit: m/s^2, meaning: acceleration of gravity, value: 9.81}
  #c: nonnegative
  #beta: {range: [0, 60 deg], value: 30 deg}

coordinates: [x, y]

#functions: {u: [t], f: [X, Y]}

# They may be used in everything below.
#let: {n: (x*i + y*j)/l}

# Polar [r, phi], cylindrical [rho, phi, z] or spherical [r, theta, phi].
#frame: {type: cartesian}

# A position is a vector: a sum along i, j, k, or a list [x, y]. Without a mass
# it is a point, for forces and springs. r_P is the position of P.
particles:
  P: {mass: m, position: x*i + y*j}
  #Q: {position: "[0, y]"}

# The position is that of the mass centre; inertia and angle are about k through
# it.
#bodies: {disc: {mass: m, inertia: m*l^2/2, position: x*i + y*j, angle: x/l}}

# Either `rod: x^2 + y^2 = l^2`, or in full.
constraints:
  rod: {equation: x^2 + y^2 = l^2, note: its length is constant, reaction: T}
  #same: "x*x' + y*y' = 0"

gravity: g*j

# A force has `at: <position>` where it does not act at P itself.
forces:
  #wind: {on: P, vector: m*g/5*i}
  #spring: {spring: m*g/l, between: [P, 2*l*i], length: l}
  #damper: {damper: m, between: [P, 0*i]}
  #field: {potential: m*g*x}
  #rub: {friction: 1/3, constraint: rod, on: P}

#unknowns: [F]

#speeds: {w: "(y*x' - x*y')/l"}

# New coordinates come with the substitution; a coordinate that is kept needs
# none.
generalized_coordinates:
  angle: {coordinates: [theta], substitute: {x: l*sin(theta), y: l*cos(theta)}}
  #depth: {coordinates: [y]}

#initial: {theta: pi/2, theta': 0}
# A quantity when something holds, or as a function (`by: theta`).
#ask: {fall: {quantity: "theta''", when: theta = pi/2}}

#impact: {before: {theta: 0, theta': 0}, impulses: {p: {on: P, vector: m*i}}}

#vary: {l: {from: 0.2 m, to: 1 m, step: 0.1 m}, m: [1, 2]}

# The position that is drawn, the ground, strings and pulleys, angles, lengths.
#figure: {at: {theta: 40 deg}, supports: [O], lengths: {l: [O, P]}}

# The questions are constraints, equilibrium, motion and linearization (that is,
# small oscillations).
find: motion

# Instead of masses, `lagrangian: ...` gives a Lagrangian outright, and
# `equations: [...]` equations, to check answers against.

# It may be your own work too: what differs is named, as the equation here will
# be when another force is added. Leave the section out if you know nothing.
# The last two keys here are for small oscillations.
answers:
  degrees_of_freedom: 1
  equations: ["theta'' + g/l*sin(theta) = 0"]
  #classification: [holonomic, scleronomic]
  #integrable: {rod: true}
  #reactions: {rod: "m*g*cos(theta) + m*l*theta'^2"}
  #equilibrium: [["theta = 0"], ["theta = pi"]]
  #frequencies: [["sqrt(g/l)"]]

#points: {equations: 6, degrees_of_freedom: 1}
"""


def _template() -> str:
    """The example with the declared meaning of each key above it."""
    meanings = {key.name: key.meaning for key in PROBLEM.keys}
    lines: list[str] = []
    comments: list[str] = []
    for line in _EXAMPLE.splitlines():
        key = re.match(r"#?(\w+):", line)
        if key:
            text = " ".join([meanings[key[1]], *(comment.removeprefix("# ") for comment in comments)])
            comments = [f"# {part}" for part in textwrap.wrap(text, WIDTH - 2, break_on_hyphens=False)]
        if line.startswith("#") and not key:
            comments.append(line)
        else:
            lines += [*comments, line]
            comments = []
    return "\n".join(lines) + "\n"


WIDTH = 80
TEMPLATE = _template()


def create(file: str, name: str | None) -> None:
    """Writes the template, or a copy of the shipped problem `name`, and prints the next command.

    Raises ProblemError if the file cannot be written, or there is no such problem; never overwrites a file.
    """
    content = TEMPLATE.encode() if name is None else library.path_of(name).read_bytes()
    if file == "-":
        write_stdout(content.decode())
        return
    path = _place(file)
    try:
        with path.open("xb") as target:
            try:
                target.write(content)
                target.flush()
            except BaseException:  # a full disk, or Ctrl-C: half a template is useless, and would be in the way
                path.unlink()
                raise
    except FileExistsError:
        help_ = "nothing was written: give the new file another name, or remove the old one first"
        raise ProblemError(Diagnostic("file-exists", f"{path} already exists", help=help_)) from None
    except (OSError, ValueError) as error:  # ValueError: a NUL in the name
        reason = getattr(error, "strerror", None) or str(error)
        help_ = "choose another place, or check that you may write there"
        raise ProblemError(Diagnostic("cannot-write", f"{path} cannot be written: {reason}", help=help_)) from None
    what = "a template to change" if name is None else f"a copy of `{name}` to change"
    write_stderr(
        f"{path} is {what}; to solve it, and again whenever you save it:\n  lagsolve {_argument(path)} --watch"
    )


def _place(file: str) -> Path:
    """The path of the new file: with the extension .yaml, in an existing folder. Raises ProblemError."""
    path = Path(file)
    if file.endswith("/") or os.path.isdir(path):
        help_ = f"name a file in it, such as {path / 'problem.yaml'}"
        raise ProblemError(Diagnostic("is-a-folder", f"{file} is a folder", help=help_))
    if path.suffix.lower() not in library.EXTENSIONS:
        if path.suffix and path.stem:
            better = shlex.quote(str(path.with_suffix(".yaml")))
            raise click.UsageError(f"a problem file ends in .yaml, and not in {path.suffix}: lagsolve new {better}")
        path = path.with_name(f"{path.name}.yaml")
    if not os.path.isdir(path.parent):
        help_ = f"make it first: mkdir -p {shlex.quote(str(path.parent))}"
        raise ProblemError(Diagnostic("no-such-folder", f"there is no folder {path.parent}", help=help_))
    return path


def _argument(path: Path) -> str:
    """A path as it is typed in a shell."""
    return shlex.quote(f"./{path}" if str(path).startswith("-") else str(path))
