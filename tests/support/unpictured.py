"""Problems without a `figure:` section, with what their figures must show all the same: how many lines of each kind."""

from __future__ import annotations

from lagrange.document.scene import StrokeKind

BODY, GROUND, ROD = StrokeKind.BODY, StrokeKind.GROUND, StrokeKind.ROD
CURVE, SPRING, STRING = StrokeKind.CURVE, StrokeKind.SPRING, StrokeKind.STRING

DOWN = "axes: {i: right, j: down}\ngravity: g*j\n"
UP = "axes: {i: right, j: up}\ngravity: -g*j\n"
SPACE = "gravity: -g*k\ncoordinates: [x, y, z]\nparticles: {P: {mass: m, position: x*i + y*j + z*k}}\n"

UNPICTURED: dict[str, tuple[str, dict[StrokeKind, int]]] = {
    "two weights, written one above the other": (
        "title: Atwood's machine\ndescription: Two weights hang from a string over a pulley.\n"
        f"{DOWN}parameters: [m, M, L, g]\ncoordinates: [x, y]\n"
        "particles: {A: {mass: m, position: x*j}, B: {mass: M, position: y*j}}\nconstraints: {string: x + y = L}\n",
        {STRING: 2, GROUND: 1},
    ),
    "a movable pulley": (
        "title: A movable pulley\ndescription: A rope runs under the pulley of block A and over a fixed one to block B.\n"
        f"{DOWN}parameters: [m, M, L, a, g]\ncoordinates: [x, y]\n"
        "particles: {A: {mass: M, position: x*j}, B: {mass: m, position: a*i + y*j}}\n"
        "constraints: {rope: 2*x + y = L}\n",
        {STRING: 4, GROUND: 3, BODY: 5},
    ),
    "a block on an incline and a weight": (
        "title: Incline\ndescription: A block A on a smooth plane is tied to a weight B by a string over a pulley.\n"
        f"{UP}parameters: [m, M, L, g, alpha]\ncoordinates: [s, z]\nparticles:\n"
        "  A: {mass: m, position: -s*cos(alpha)*i - s*sin(alpha)*j}\n  B: {mass: M, position: -z*j}\n"
        "constraints: {string: s + z = L}\n",
        {STRING: 2, GROUND: 1, BODY: 2},
    ),
    "a string through a hole": (
        "title: Hole\ndescription: A moves on a table; a string through a hole joins it to B below.\n"
        "gravity: -g*k\nparameters: [m, M, L, g]\ncoordinates: [r, phi, z]\nparticles:\n"
        "  A: {mass: m, position: r*cos(phi)*i + r*sin(phi)*j}\n  B: {mass: M, position: -z*k}\n"
        "constraints: {string: r + z = L}\n",
        {STRING: 2, BODY: 1},
    ),
    "a pendulum on a cart with a spring": (
        "title: Pendulum on a cart\ndescription: A cart on a rail is tied to a wall by a spring.\n"
        f"{UP}parameters: [M, m, l, c, g]\ncoordinates: [x, theta]\nparticles:\n  cart: {{mass: M, position: x*i}}\n"
        "  bob: {mass: m, position: (x + l*sin(theta))*i - l*cos(theta)*j}\n"
        "forces: {spring: {spring: c, between: [[-2*l, 0], cart], length: 2*l}}\n",
        {BODY: 1, ROD: 1, SPRING: 1},
    ),
    "a rod on a hinge with a spring": (
        "title: Rod\ndescription: A rod is hinged at O; a spring holds its end.\n"
        f"{UP}parameters: [m, l, c, h, g]\ncoordinates: [theta]\n"
        "bodies: {rod: {mass: m, inertia: m*l^2/12, position: l/2*cos(theta)*i + l/2*sin(theta)*j, angle: theta}}\n"
        'forces: {spring: {spring: c, between: ["l*cos(theta)*i + l*sin(theta)*j", [0, h]], length: h}}\n',
        {BODY: 1, SPRING: 1, GROUND: 2},
    ),
    "a disc with a spring": (
        "title: Disc\ndescription: A disc rolls down an incline; a spring holds its centre.\n"
        "axes: {i: down the plane, j: normal to it}\ngravity: g*sin(alpha)*i - g*cos(alpha)*j\n"
        "parameters: [m, R, c, h, g, alpha]\ncoordinates: [x, y, phi]\n"
        "bodies: {disc: {mass: m, inertia: m*R^2/2, position: x*i + y*j, angle: -phi}}\n"
        "constraints: {contact: y = R, rolling: x' - R*phi' = 0}\n"
        "forces: {spring: {spring: c, between: [[0, R], disc], length: h}}\n",
        {BODY: 1, SPRING: 1},
    ),
    "a block on a wedge": (
        "title: Wedge\ndescription: A block slides on a wedge that slides on the floor.\n"
        f"{UP}parameters: [m, M, g, alpha]\ncoordinates: [X, s]\nparticles:\n  wedge: {{mass: M, position: X*i}}\n"
        "  block: {mass: m, position: (X + s*cos(alpha))*i - s*sin(alpha)*j}\n",
        {BODY: 2, GROUND: 1},
    ),
    "four bars": (
        "title: A four-bar linkage\ndescription: A crank OA, a coupler AB and a rocker CB.\n"
        f"{UP}parameters: [m, a, b, c, d, g]\ncoordinates: [alpha, beta]\nparticles:\n"
        "  A: {mass: m, position: a*cos(alpha)*i + a*sin(alpha)*j}\n"
        "  B: {mass: m, position: (d + c*cos(beta))*i + c*sin(beta)*j}\n"
        "constraints: {coupler: (d + c*cos(beta) - a*cos(alpha))^2 + (c*sin(beta) - a*sin(alpha))^2 = b^2}\n",
        {ROD: 3, GROUND: 2},
    ),
    "a cylinder on its string": (
        "title: Yo-yo\ndescription: A cylinder falls while the string round it unwinds.\n"
        f"{DOWN}parameters: [m, R, g]\ncoordinates: [y, phi]\n"
        "bodies: {cylinder: {mass: m, inertia: m*R^2/2, position: R*i + y*j, angle: -phi}}\n"
        "constraints: {string: {equation: y' - R*phi' = 0, by: string}}\n",
        {BODY: 1, STRING: 1, GROUND: 1},
    ),
    "weights on a heavy pulley": (
        "title: Pulley\ndescription: Two weights hang from a string over a pulley.\n"
        f"{DOWN}parameters: [m, M, I, R, g]\ncoordinates: [x, y, phi]\n"
        "particles: {A: {mass: m, position: -R*i + x*j}, B: {mass: M, position: R*i + y*j}}\n"
        "bodies: {pulley: {inertia: I, position: 0*i, angle: phi}}\nconstraints:\n"
        "  left: {equation: x' - R*phi' = 0, by: string}\n  right: {equation: y' + R*phi' = 0, by: string}\n",
        {BODY: 1, STRING: 2, GROUND: 1},
    ),
    "a bowl": (
        f"title: Bowl\n{SPACE}parameters: [m, c, g]\nconstraints: {{bowl: z = c*(x^2 + y^2)}}\n",
        {CURVE: 1},
    ),
    "a helix": (
        f"title: Helix\n{SPACE}parameters: [m, a, h, g]\n"
        "constraints: {cylinder: x^2 + y^2 = a^2, pitch: y*cos(z/h) = x*sin(z/h)}\n",
        {CURVE: 1},
    ),
    "a block on a block": (
        "title: Block on a block\ndescription: A block of mass m slides on a block of mass M, which slides on a floor.\n"
        f"{UP}parameters: [m, M, g]\ncoordinates: [X, x]\n"
        "particles: {lower: {mass: M, position: X*i}, upper: {mass: m, position: (X + x)*i + j}}\n",
        {BODY: 2, GROUND: 1},
    ),
    "a bead on a rod that turns": (
        "title: Bead\ndescription: A bead slides on a straight rod that turns about O.\naxes: {i: right, j: up}\n"
        "parameters: [m, Omega]\ncoordinates: [r]\n"
        "particles: {bead: {mass: m, position: r*(cos(Omega*t)*i + sin(Omega*t)*j)}}\n",
        {ROD: 1, GROUND: 1},
    ),
    "a seesaw": (
        "title: Seesaw\ndescription: Two children sit on a plank.\n"
        f"{UP}parameters: [J, m, M, a, b, g]\ncoordinates: [theta]\n"
        "bodies: {plank: {inertia: J, position: 0*i, angle: theta}}\n"
        "particles: {A: {mass: m, position: a*e1_plank}, B: {mass: M, position: -b*e1_plank}}\n",
        {BODY: 2, GROUND: 1},
    ),
    "a ladder against a wall": (
        "title: Ladder\ndescription: A ladder leans against a wall and stands on the floor.\n"
        f"{UP}parameters: [m, l, g]\ncoordinates: [x, y, theta]\n"
        "bodies: {ladder: {mass: m, inertia: m*l^2/3, position: x*i + y*j, angle: -theta}}\n"
        "constraints: {wall: x = l*cos(theta), floor: y = l*sin(theta)}\n",
        {BODY: 1, GROUND: 2},
    ),
    "gears on their axles": (
        "title: Gears\naxes: {i: right, j: up}\nparameters: [I, J, r, R]\ncoordinates: [phi, psi]\nbodies:\n"
        "  first: {inertia: I, position: 0*i, angle: phi, shape: {disc: r}}\n"
        "  second: {inertia: J, position: (r + R)*i, angle: psi, shape: {disc: R}}\n"
        "constraints: {mesh: r*phi' + R*psi' = 0}\n",
        {BODY: 2, GROUND: 2},
    ),
    "a bead on a hoop that is turned": (
        "title: Bead\ndescription: A bead slides on a hoop, which turns about its vertical diameter.\ngravity: -g*k\n"
        "parameters: [m, R, Omega, g]\ncoordinates: [theta]\nparticles:\n"
        "  bead: {mass: m, position: R*sin(theta)*(cos(Omega*t)*i + sin(Omega*t)*j) - R*cos(theta)*k}\n",
        {CURVE: 1, ROD: 0},
    ),
}
