"""Problems of statics as files."""

from __future__ import annotations

BEAD = """
title: Bead in a potential
parameters: [a, b]
coordinates: [theta]
forces: {field: {potential: "-a*sin(theta)^2/2 - b*cos(theta)"}}
"""
PENDULUM = """
title: Pendulum
axes: {i: right, j: down}
parameters: [m, l, g]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {rod: x^2 + y^2 = l^2}
gravity: g*j
find: equilibrium
generalized_coordinates:
  angle: {coordinates: [theta], substitute: {x: l*sin(theta), y: l*cos(theta)}}
  depth: {coordinates: [y]}
"""
CHAIN = """
title: Two rods pulled sideways
parameters: [W, l, P]
coordinates: [theta, phi]
particles:
  A: {position: l*sin(theta)*i - l*cos(theta)*j}
  B: {position: r_A + l*sin(phi)*i - l*cos(phi)*j}
forces: {w: {on: A, vector: -W*j}, v: {on: B, vector: -W*j}, pull: {on: B, vector: P*i}}
"""
LEVER = """
title: Two forces on a lever
parameters: [W, a, b, c]
unknowns: [P, R]
coordinates: [theta]
particles:
  A: {position: -a*cos(theta)*i - a*sin(theta)*j}
  B: {position: b*cos(theta)*i + b*sin(theta)*j}
  C: {position: c*cos(theta)*i + c*sin(theta)*j}
forces: {w: {on: A, vector: -W*j}, p: {on: B, vector: -P*j}, r: {on: C, vector: -R*j}}
"""
ATWOOD = """
title: Two weights on a string
parameters: [W, M, L]
coordinates: [x]
particles: {A: {position: -x*j}, B: {position: (x - L)*j}}
forces: {w: {on: A, vector: -W*j}, v: {on: B, vector: -M*j}}
"""
SPRINGS = """
title: Spring between two points
parameters: [c, b, h, W]
coordinates: [y]
particles: {P: {position: "[h, y]"}}
forces: {s: {spring: c, between: [P, "[0, 0]"], length: b}}
"""
INCLINES = """
title: Two weights on two inclines, joined by a string
parameters: [P, Q, alpha, beta, L]
coordinates: [x, y]
particles:
  A: {position: -x*cos(alpha)*i - x*sin(alpha)*j}
  B: {position: y*cos(beta)*i - y*sin(beta)*j}
constraints: {string: x + y = L}
forces: {p: {on: A, vector: -P*j}, q: {on: B, vector: -Q*j}}
find: equilibrium
"""
WINDING = """
title: A weight on a string that winds around a cylinder
parameters: [W, l, R]
coordinates: [theta]
let: {out: cos(theta)*i + sin(theta)*j, along: sin(theta)*i - cos(theta)*j}
particles: {P: {position: R*out + (l + R*theta)*along}}
forces: {weight: {on: P, vector: -W*j}}
"""
WIND = """
title: A pendulum in the wind, with a balloon
parameters: {m: positive, g: positive, l: positive, F: real, H: real}
coordinates: [theta]
particles: {P: {mass: m, position: l*sin(theta)*i - l*cos(theta)*j}}
gravity: -g*j
forces: {wind: {on: P, vector: F*i}, lift: {on: P, vector: H*j}}
find: equilibrium
"""
PULLED_SPRING = """
title: A spring pulled by a force
parameters: [P, k, l, W]
coordinates: [x]
particles: {A: {position: x*i}}
forces: {spring: {potential: k*x^2/2}, pull: {on: A, vector: P*i}}
"""
SCALES = """
title: A balanced lever, in equilibrium everywhere if P a = Q b
parameters: [P, Q, a, b]
coordinates: [theta]
particles: {A: {position: -a*cos(theta)*i - a*sin(theta)*j}, B: {position: b*cos(theta)*i + b*sin(theta)*j}}
forces: {p: {on: A, vector: -P*j}, q: {on: B, vector: -Q*j}}
"""
SPRING_ON_CIRCLE = """
title: A spring to the top of a circle
coordinates: [theta]
particles: {B: {mass: 1, position: "0.5*sin(theta)*i + 0.5*cos(theta)*j"}}
forces:
  tie: {spring: 400, between: [0.5*j, B], length: 0.2}
  weight: {on: B, vector: -10*j}
find: equilibrium
"""
STRAIGHT_SPRING = """
title: A spring on a line
parameters: [k, l, F]
coordinates: [x]
particles: {P: {mass: 1, position: x*i}}
forces:
  tie: {spring: k, between: [0*i, P], length: l}
  push: {on: P, vector: F*i}
find: equilibrium
"""
POLE = """
title: A repelling end of a circle
coordinates: [theta]
particles: {P: {mass: 1, position: sin(theta)*i + cos(theta)*j}}
forces:
  field: {potential: 2/norm(r_P + j)}
  weight: {on: P, vector: -10*j}
find: equilibrium
"""
CROSS_WIND = """
title: A spherical pendulum in a cross wind
parameters: [W, l]
coordinates: [theta, phi]
particles: {P: {position: l*sin(theta)*cos(phi)*i + l*sin(theta)*sin(phi)*j - l*cos(theta)*k}}
forces: {all: {on: P, vector: W*(i + j - k)}}
find: equilibrium
"""
SKATE = """
title: A skate on a spring
parameters: [K]
coordinates: [x, y, theta]
particles: {P: {mass: 1, position: x*i + y*j}}
constraints: {blade: "sin(theta)*x' - cos(theta)*y' = 0"}
forces: {spring: {potential: K*(x^2 + y^2)/2}}
find: equilibrium
"""
FOUR_BAR = """
title: A four-bar linkage under two couples
parameters: [a, b, c, d, M_1, M_2]
coordinates: [alpha, beta, gamma]
constraints:
  along: a*cos(alpha) + b*cos(beta) = d + c*cos(gamma)
  across: a*sin(alpha) + b*sin(beta) = c*sin(gamma)
forces: {couples: {potential: M_1*alpha - M_2*gamma}}
find: equilibrium
"""
POLES_OF_A_CHOICE = """
title: A heavy particle on a sphere, and a horizontal force
parameters: [m, g, F, R]
coordinates: [x, y, z]
particles: {P: {mass: m, position: x*i + y*j + z*k}}
constraints: {sphere: x^2 + y^2 + z^2 = R^2}
gravity: -g*k
forces: {push: {on: P, vector: F*i}}
generalized_coordinates:
  angles: {coordinates: [theta, phi], substitute: {x: R*sin(theta)*cos(phi), y: R*sin(theta)*sin(phi), z: R*cos(theta)}}
find: equilibrium
"""
PUSHED_LINKAGE = """
title: A four-bar linkage pushed at a joint
coordinates: [alpha, beta, gamma]
particles: {A: {position: '3*cos(alpha)*i + 3*sin(alpha)*j'}}
constraints:
  h: 3*cos(alpha) + 3*cos(beta) - 2*cos(gamma) = 2
  v: 3*sin(alpha) + 3*sin(beta) - 2*sin(gamma) = 0
forces: {F: {on: A, vector: '-i + 2*j'}}
find: equilibrium
"""
OPEN_LINKAGE = """
title: A four-bar linkage pushed at a joint, whose coupler and rocker may be in line
coordinates: [alpha, beta, gamma]
particles: {A: {position: '3*cos(alpha)*i + 3*sin(alpha)*j'}}
constraints:
  h: 3*cos(alpha) + 4*cos(beta) - 3*cos(gamma) = 5
  v: 3*sin(alpha) + 4*sin(beta) - 3*sin(gamma) = 0
forces: {F: {on: A, vector: '2*i + 3*j'}}
find: equilibrium
"""
