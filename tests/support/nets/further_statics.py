"""Systems at rest that are no family of `statics_systems`: surfaces, curves, closed chains, ropes, central fields, springs without length.

The same is compared with numbers as there.
"""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import replace

from tests.support.nets.run import Finding
from tests.support.nets.statics import check_system, rewritten
from tests.support.nets.statics_systems import PYTHAGOREAN, letters, number, signed, whole
from tests.support.nets.system import System

Rng = random.Random


def sides_of(rng: Rng, left: str, right: str) -> str:
    """An equation in one of four forms."""
    factor = rng.choice(["2", "-3", "1/2"])
    return rng.choice(
        [
            f"{left} = {right}",
            f"{right} = {left}",
            f"{factor}*({left}) - ({factor})*({right}) = 0",
            f"0 = {left} - ({right})",
        ]
    )


def ellipse(rng: Rng) -> System:
    s = System("bead on an ellipse", ["x", "y"])
    p = letters(s, rng, 0.35, a=whole(rng, 1, 3), b=whole(rng, 1, 3), m=whole(rng), g=whole(rng), k=whole(rng))
    s.particle("P", p["m"], "x", "y")
    s.constraints["c"] = sides_of(rng, f"x^2/{p['a']}^2 + y^2/{p['b']}^2", "1")
    if rng.random() < 0.6:
        s.weigh(p["g"])
    if rng.random() < 0.6 or not s.terms:
        s.spring(p["k"], [rng.choice(["0", signed(rng)]), rng.choice(["0", "0", signed(rng)])], "P")
    return s


def curve(rng: Rng) -> System:
    """A bead on a curve y = f(x), perhaps with a spring."""
    s = System("bead on a curve", ["x", "y"])
    p = letters(s, rng, 0.4, a=whole(rng), m=whole(rng), g=whole(rng), k=whole(rng))
    s.particle("P", p["m"], "x", "y")
    right = rng.choice(
        [f"{p['a']}*x^2", f"{p['a']}*x^3 - x", "cos(x)", f"x^4 - {p['a']}*x^2", f"{p['a']}/x", "exp(x)", "cosh(x)"]
    )
    s.constraints["c"] = sides_of(rng, "y", right)
    s.weigh(p["g"])
    if rng.random() < 0.5:
        s.spring(p["k"], [rng.choice(["0", signed(rng)]), rng.choice(["0", signed(rng)])], "P")
    return s


def plane_and_sphere(rng: Rng) -> System:
    s = System("bead on the section of a sphere", ["x", "y", "z"])
    p = letters(s, rng, 0.3, R=whole(rng, 2, 3), m=whole(rng), g=whole(rng))
    s.particle("P", p["m"], "x", "y", "z")
    s.constraints["ball"] = sides_of(rng, "x^2 + y^2 + z^2", f"{p['R']}^2")
    s.constraints["plane"] = rng.choice(["x + z = 1", "z = x", "3*x + 4*z = 2", "y = 1", "x + y + z = 1"])
    s.weigh(p["g"], rng.choice([1, 2]))
    if rng.random() < 0.4:
        s.push("P", signed(rng), "0", "0")
    return s


def surface(rng: Rng) -> System:
    s = System("particle on a surface", ["x", "y", "z"])
    p = letters(s, rng, 0.3, a=whole(rng, 1, 2), m=whole(rng), g=whole(rng), k=whole(rng))
    s.particle("P", p["m"], "x", "y", "z")
    left, right = rng.choice(
        [("z", f"{p['a']}*x^2 + y^2"), ("z", f"{p['a']}*(x^2 - y^2)"), ("z", f"{p['a']}*x*y"), ("x^2 + y^2", f"{p['a']}^2"),
         ("x^2 + y^2 - z^2", f"{p['a']}^2"), ("x*y*z", p["a"]), ("z", f"x^2 + y^2 - {p['a']}*x")]
    )  # fmt: skip
    s.constraints["c"] = sides_of(rng, left, right)
    s.weigh(p["g"], 2)
    s.spring(p["k"], [rng.choice(["0", signed(rng)]), "0", rng.choice(["0", signed(rng)])], "P")
    return s


def cone_chart(rng: Rng) -> System:
    """A particle in a cone, on a cylinder or a paraboloid, in its coordinates, with a cross wind or a spring."""
    s = System("cone, cylinder, paraboloid", ["r", "phi"], {"phi"})
    p = letters(s, rng, 0.35, m=whole(rng), g=whole(rng), F=whole(rng), k=whole(rng))
    x, y, z = rng.choice(
        [("r*cos(phi)", "r*sin(phi)", "2*r"), ("2*cos(phi)", "2*sin(phi)", "r"), ("r*cos(phi)", "r*sin(phi)", "r^2/2")]
    )
    s.particle("P", p["m"], x, y, z)
    s.weigh(p["g"], rng.choice([2, 2, 0]))
    if rng.random() < 0.7:
        s.push("P", *rng.choice([(p["F"], "0", "0"), ("3", "4", "0"), (p["F"], p["F"], "0")]))
    if rng.random() < 0.7:
        s.spring(p["k"], ["0", "0", signed(rng)], "P", rng.choice(["0", "0", "1"]))
    return s


def three_rods(rng: Rng) -> System:
    """A chain of three rods between two fixed points, Cartesian: two knots with weights."""
    s = System("chain of three rods", ["x", "y", "X", "Y"], box=4)
    a, b, c = (rng.randint(1, 3) for _ in range(3))
    d = rng.choice([a, b, c, a + b, 2, 4])
    s.particle("A", whole(rng), "x", "y")
    s.particle("B", whole(rng), "X", "Y")
    s.constraints["p"] = f"x^2 + y^2 = {a}^2"
    s.constraints["q"] = sides_of(rng, "(X - x)^2 + (Y - y)^2", f"{b}^2")
    s.constraints["r"] = f"(X - {d})^2 + Y^2 = {c}^2"
    s.weigh("1")
    return s


def two_circles(rng: Rng) -> System:
    """Beads on two circles, or both on one, with a spring between them that may lose its length."""
    s = System("two beads and a spring", ["theta", "phi"], {"theta", "phi"})
    p = letters(s, rng, 0.3, m=whole(rng), g=whole(rng), k=whole(rng))
    r = rng.randint(1, 2)
    d, big = rng.choice([(0, r), (0, r + 1), (2 * r, r), (1, r)])
    s.particle("A", p["m"], f"{r}*cos(theta)", f"{r}*sin(theta)")
    s.particle("B", rng.choice([p["m"], "1"]), f"{d} + {big}*cos(phi)", f"{big}*sin(phi)")
    if rng.random() < 0.7:
        s.weigh(p["g"])
    s.spring(p["k"], "A", "B", rng.choice(["0", "0", "1", number(rng)]))
    return s


def rope(rng: Rng) -> System:
    """Weights on two inclines or a vertical and a curve, joined by a rope; or a ring on a rope of given length."""
    if rng.random() < 0.5:
        s = System("ring on a rope", ["x", "y"], box=5)
        s.particle("P", whole(rng), "x", "y")
        s.constraints["rope"] = sides_of(
            rng, "sqrt((x + 2)^2 + y^2) + sqrt((x - 2)^2 + y^2)", rng.choice(["5", "6", "20/3"])
        )
        s.weigh(whole(rng))
        if rng.random() < 0.5:
            s.push("P", signed(rng), "0")
        return s
    s = System("two weights on a rope", ["x", "y"], box=5)
    p = letters(s, rng, 0.4, L=whole(rng, 3, 6), m=whole(rng), M=whole(rng), g=whole(rng))
    a, b, c = rng.choice(PYTHAGOREAN)
    s.particle("A", p["m"], f"-{a}*x/{c}", f"-{b}*x/{c}")
    s.particle("B", p["M"], "0", "-y")
    s.constraints["rope"] = sides_of(rng, "x + y", p["L"])
    s.weigh(p["g"])
    if rng.random() < 0.6:
        s.spring(whole(rng), ["0", "0"], "A", rng.choice(["0", "1"]))
    return s


def central(rng: Rng) -> System:
    """Polar coordinates: a central energy, perhaps with a uniform field."""
    s = System("central field", ["r", "phi"], {"phi"})
    p = letters(s, rng, 0.5, a=whole(rng), b=whole(rng), m=whole(rng), F=whole(rng))
    s.particle("P", p["m"], "r*cos(phi)", "r*sin(phi)")
    s.field(rng.choice([f"-{p['a']}/r + {p['b']}/r^2", f"{p['a']}*r^2/2 + {p['b']}/r", f"{p['a']}*(r - 1)^2/2", f"{p['a']}*r^2/2",
                        f"{p['a']}/r^2 + {p['b']}*r"]))  # fmt: skip
    if rng.random() < 0.6:
        s.push("P", *rng.choice([(p["F"], "0"), ("0", f"-{p['F']}"), ("3", "4")]))
    return s


def on_line(rng: Rng) -> System:
    """Springs with lengths, charges and constant forces on a line: moduli and poles."""
    s = System("springs and charges on a line", ["x"])
    p = letters(s, rng, 0.5, k=whole(rng), d=whole(rng), F=whole(rng), c=whole(rng), q=whole(rng))
    s.particle("P", rng.choice(["0", "1"]), "x")
    s.spring(p["k"], ["0"], "P", rng.choice(["0", p["d"], p["d"]]))
    if rng.random() < 0.4:
        s.spring(whole(rng), [signed(rng)], "P", rng.choice(["0", "1", p["d"]]))
    if rng.random() < 0.5:
        s.push("P", rng.choice([p["F"], f"-{p['F']}"]))
    if rng.random() < 0.4:
        s.field(f"-{p['c']}*x^2/2")
    if rng.random() < 0.3:
        s.field(rng.choice([f"{p['q']}/x", f"{p['q']}/sqrt(x^2)", f"-{p['q']}/(x - 1)^2"]))
    return s


def poles(rng: Rng) -> System:
    """In the plane: two centres, on a line or a circle perhaps."""
    s = System("two centres", ["x", "y"])
    p = letters(s, rng, 0.3, q=whole(rng), Q=whole(rng), k=whole(rng))
    s.particle("P", rng.choice(["0", "1"]), "x", "y")
    sign = rng.choice(["", "-"])
    s.field(f"{sign}{p['q']}/sqrt((x - 1)^2 + y^2) + {sign}{p['Q']}/sqrt((x + 1)^2 + y^2)")
    if rng.random() < 0.7:
        s.constraints["c"] = rng.choice(["y = 0", "x = 0", "x^2 + y^2 = 4", "x^2 + y^2 = 1", "y = 1"])
    elif rng.random() < 0.5:
        s.field(f"{p['k']}*(x^2 + y^2)/2")
    return s


def two_angles(rng: Rng) -> System:
    """Two angles in the energy as products, sums and differences of sines."""
    s = System("energy of two angles", ["theta", "phi"], {"theta", "phi"})
    p = letters(s, rng, 0.4, a=whole(rng), b=whole(rng), c=whole(rng))
    s.field(rng.choice([f"{p['a']}*sin(theta)*sin(phi) + {p['b']}*cos(theta)", f"{p['a']}*cos(theta - phi) + {p['b']}*cos(phi)",
                        f"{p['a']}*cos(theta + phi) + {p['b']}*cos(theta - phi)", f"{p['a']}*sin(theta)^2*cos(phi) - {p['b']}*cos(theta)",
                        f"{p['a']}*cos(theta)*cos(phi) + {p['b']}*sin(theta)",
                        f"{p['a']}*cos(theta - phi) - {p['b']}*cos(theta) - {p['c']}*cos(phi)"]))  # fmt: skip
    return s


def flat(rng: Rng) -> System:
    """Energies whose second variation vanishes somewhere: quartics, valleys, products."""
    s = System("degenerate energy", ["x", "y"])
    p = letters(s, rng, 0.4, a=whole(rng), b=whole(rng), c=whole(rng))
    s.field(rng.choice([f"{p['a']}*x^4 + {p['b']}*y^4 - {p['c']}*x^2*y^2", f"{p['a']}*x^4 + {p['b']}*y^2 - {p['c']}*x^2*y",
                        f"{p['a']}*(x^2 - y)^2 + {p['b']}*x^4", f"{p['a']}*x^2*y^2", f"{p['a']}*x^4 - {p['b']}*y^4",
                        f"{p['a']}*(x - y)^2 + {p['b']}*(x + y)^4", f"{p['a']}*x^3 - {p['b']}*x*y^2",
                        f"{p['a']}*(x*y - 1)^2 + {p['b']}*x^2", f"{p['a']}*x^2*y^2 + {p['b']}*x^2"]))  # fmt: skip
    return s


def blades(rng: Rng) -> System:
    """A blade or a wheel held at rest by springs, weights or a field, with a real letter somewhere."""
    s = System("blade", ["x", "y", "theta"], {"theta"})
    s.particle("P", "0", "x", "y")
    f = rng.choice(["1", "-2", "1/3"])
    s.forms["blade"] = rng.choice(
        [{"x": f"{f}*sin(theta)", "y": f"-({f})*cos(theta)"}, {"x": f"{f}*cos(theta)", "y": f"{f}*sin(theta)"}]
    )
    p = letters(s, rng, 0.5, k=whole(rng), F=whole(rng), c=whole(rng))
    s.real |= {"c"} & {*s.parameters}
    s.field(rng.choice([f"{p['k']}*(x^2 + y^2)/2 + {p['c']}*x", f"{p['k']}*x^2/2 + {p['c']}*cos(theta)", f"{p['k']}*x*y",
                        f"{p['F']}*x + {p['c']}*y", f"{p['k']}*(x - 1)^2/2 + {p['F']}*y - {p['c']}*sin(theta)"]))  # fmt: skip
    return s


FAMILIES: list[Callable[[Rng], System]] = [
    ellipse, curve, plane_and_sphere, surface, cone_chart, three_rods, two_circles, rope, central, on_line, on_line, poles,
    two_angles, flat, blades,
]  # fmt: skip


def random_system(rng: Rng) -> System:
    s = rng.choice(FAMILIES)(rng)
    if s.particles and not s.forms and all(m != "0" for m, _ in s.particles.values()) and rng.random() < 0.4:
        s.find = "[equilibrium, linearization]"
    return s


def findings(seed: int) -> list[Finding]:
    """One random system, and the same written in another way."""
    rng = random.Random(seed)
    system = random_system(rng)
    found = check_system(system, random.Random(seed), checking=seed % 3 == 0)
    if seed % 4 == 1 and (system.constraints or system.forms):
        again = check_system(rewritten(system, rng), random.Random(seed), checking=False)
        found += [replace(f, kind=f"{f.kind} (rewritten)") for f in again]
    return found
