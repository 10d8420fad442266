"""What `lagsolve new` writes: a small problem that solves as it stands, with every key explained.

A key that is not in use stands behind a `#` without a blank; a sentence has the blank. Without its `#` every such line
is accepted, alone and with the others of its section: a test takes them away.
"""

TEMPLATE = """\
# A problem for lagsolve. It solves as it stands: change it to yours.
# Behind a # without a blank stands a key that is not in use; take the # away to
# use it. Every value is read as text: names such as y and n stay names.
# Equations with primes (velocities x', accelerations x'') stand in double
# quotes. docs/problem-files.md of lagsolve has every key and all its forms.
#
# For completion in an editor, lagsolve schema > lagsolve.schema.json, and here
#   `# yaml-language-server: $schema=lagsolve.schema.json` on a line of its own.

title: Pendulum
#source: the book, the chapter, the number
description: A particle hangs from the fixed point O by a massless rod.

# Words for the unit vectors i, j, k, for the text and the pictures.
axes: {i: right, j: down}

# Constants: a list, where all are positive, or each with what is assumed of it:
# positive | nonnegative | real | sign (that is, +1 or -1).
parameters:
  m: positive
  l: {assume: positive, unit: m, meaning: length of the rod}
  g: {unit: m/s^2, meaning: acceleration of gravity, value: 9.81}
  #c: nonnegative

# What you describe the system with. Coordinates need not be independent.
coordinates: [x, y]

# Functions that are given but not known: a prescribed motion u(t), a surface
# f(X, Y) = 0.
#functions: {u: [t], f: [X, Y]}

# Abbreviations, numbers or vectors, to be used below.
#let: {n: (x*i + y*j)/l}

# Unit vectors e_r, e_phi, ... that turn: polar [r, phi], cylindrical
# [rho, phi, z], spherical [r, theta, phi], named after your coordinates.
#frame: {type: cartesian}

# Masses. A position is a vector: a sum along i, j, k, or a list [x, y]. Without
# a mass it is a point, for forces and springs. r_P is the position of P.
particles:
  P: {mass: m, position: x*i + y*j}
  #Q: {position: "[0, y]"}

# Rigid bodies. The position is that of the mass centre, inertia and angle are
# about k through it.
#bodies: {disc: {mass: m, inertia: m*l^2/2, position: x*i + y*j, angle: x/l}}

# Equations between coordinates, velocities and t, as `rod: x^2 + y^2 = l^2` or
# in full. With velocities a constraint is kinematic, without it is geometric.
constraints:
  rod: {equation: x^2 + y^2 = l^2, note: its length is constant, reaction: T}
  #same: "x*x' + y*y' = 0"

# The acceleration of gravity, as a vector: every mass gets its weight.
gravity: g*j

# What else acts; a force with `at: <position>` where it is not at P itself.
forces:
  #wind: {on: P, vector: m*g/5*i}
  #spring: {spring: m*g/l, between: [P, 2*l*i], length: l}
  #damper: {damper: m, between: [P, 0*i]}
  #field: {potential: m*g*x}
  #rub: {friction: 1/3, constraint: rod, on: P}

# Forces that are to be found with the rest.
#unknowns: [F]

# Velocities in which the equations of motion are wanted too.
#speeds: {w: "(y*x' - x*y')/l"}

# Choices of generalized coordinates, as many as you like; each is verified. New
# coordinates come with the substitution; a coordinate that is kept needs none.
generalized_coordinates:
  angle: {coordinates: [theta], substitute: {x: l*sin(theta), y: l*cos(theta)}}
  #depth: {coordinates: [y]}

# One of constraints, equilibrium, motion and linearization (that is, small
# oscillations), or a list of these.
find: motion

# In place of masses and forces, `equations: [...]` gives equations outright, to
# check answers against.

# What you know already, from a book or your own work: every run compares, and
# says what differs, as the equation here will when another force is put in.
# Leave it out if you know nothing. The last two are for small oscillations.
answers:
  degrees_of_freedom: 1
  equations: ["theta'' + g/l*sin(theta) = 0"]
  #classification: [holonomic, scleronomic]
  #integrable: {rod: true}
  #reactions: {rod: "m*g*cos(theta) + m*l*theta'^2"}
  #equilibrium: [["theta = 0"], ["theta = pi"]]
  #frequencies: [["sqrt(g/l)"]]
"""
