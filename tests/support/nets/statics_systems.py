"""Random systems at rest, one function a family; weighted towards those in which faults were found."""

from __future__ import annotations

import random
from collections.abc import Callable
from fractions import Fraction

from tests.support.nets.system import System

Rng = random.Random
PYTHAGOREAN = [(3, 4, 5), (4, 3, 5), (5, 12, 13), (8, 15, 17)]


def whole(rng: Rng, least: int = 1, most: int = 5) -> str:
    return str(rng.randint(least, most))


def signed(rng: Rng, most: int = 4) -> str:
    return str(rng.choice([-1, 1]) * rng.randint(1, most))


def number(rng: Rng) -> str:
    """A positive number, mostly whole."""
    return rng.choice([whole(rng), whole(rng), str(Fraction(rng.randint(1, 7), rng.randint(2, 4)))])


def letters(system: System, rng: Rng, chance: float, **values: str) -> dict[str, str]:
    """Each quantity as a positive symbol with that chance, otherwise its number."""
    chosen = {}
    for name, value in values.items():
        if rng.random() < chance:
            system.parameters.append(name)
            chosen[name] = name
        else:
            chosen[name] = value
    return chosen


def circle_cartesian(rng: Rng) -> System:
    s = System("bead on a circle, Cartesian", ["x", "y"])
    p = letters(s, rng, 0.4, R=whole(rng), m=whole(rng), g=whole(rng), F=whole(rng))
    s.particle("P", p["m"], "x", "y")
    s.constraints["c"] = rng.choice(
        [f"x^2 + y^2 = {p['R']}^2", f"{p['R']}^2 = x^2 + y^2", f"-3*x^2 - 3*y^2 + 3*{p['R']}^2 = 0"]
    )
    s.weigh(p["g"])
    if rng.random() < 0.6:
        s.push("P", rng.choice([p["F"], f"-{p['F']}"]), "0")
    if rng.random() < 0.4:
        s.spring(number(rng), [rng.choice(["0", signed(rng)]), rng.choice(["0", signed(rng)])], "P")
    if rng.random() < 0.4:
        x, y = rng.sample([f"{p['R']}*sin(theta)", f"{rng.choice(['', '-'])}{p['R']}*cos(theta)"], 2)
        s.choose("angle", ["theta"], {"x": x, "y": y}, {"theta"})
    return s


def circle_spring(rng: Rng) -> System:
    """A bead on a circle with a spring to a point, which may lie on the circle; the angle is the coordinate."""
    s = System("bead on a circle, spring", ["theta"], {"theta"})
    r, d = rng.randint(1, 3), rng.randint(0, 3)
    p = letters(s, rng, 0.2, k=whole(rng, 1, 400), F=whole(rng))
    s.particle("B", rng.choice(["0", "1"]), f"{d} + {r}*cos(theta)", f"{r}*sin(theta)")
    at = rng.choice([str(d + r), str(d - r), signed(rng), "0"])
    s.spring(p["k"], [at, "0"], "B", rng.choice(["0", number(rng), "0.2"]))
    if rng.random() < 0.6:
        s.push("B", *rng.choice([(p["F"], "0"), ("0", p["F"]), (f"-{p['F']}", "0")]))
    return s


def circle_pole(rng: Rng) -> System:
    """A bead on a circle in the potential of a centre, which may lie on the circle."""
    s = System("bead on a circle, centre", ["theta"], {"theta"})
    r = rng.randint(1, 2)
    s.particle("B", rng.choice(["0", "1"]), f"{r}*cos(theta)", f"{r}*sin(theta)")
    y = rng.choice([r, -r, r + 1, 2 * r])
    s.field(f"{rng.choice(['', '-'])}{number(rng)}/sqrt(({r}*cos(theta))^2 + ({r}*sin(theta) - ({y}))^2)")
    if rng.random() < 0.7:
        s.push("B", *rng.choice([("0", signed(rng)), (signed(rng), "0")]))
    return s


def line(rng: Rng) -> System:
    s = System("bead on a line", ["x", "y"])
    a, b, c = rng.choice(PYTHAGOREAN)
    p = letters(s, rng, 0.3, m=whole(rng), g=whole(rng), k=whole(rng))
    s.particle("P", p["m"], "x", "y")
    s.constraints["c"] = rng.choice([f"{a}*x + {b}*y = {c}", f"{c} - {a}*x = {b}*y", f"{a}*x/{c} + {b}*y/{c} - 1 = 0"])
    s.weigh(p["g"])
    s.spring(p["k"], [whole(rng, 0, 3), signed(rng)], "P", rng.choice(["0", "0", "1"]))
    return s


def sphere_chart(rng: Rng) -> System:
    """A spherical pendulum with constant forces."""
    s = System("sphere, angles", ["theta", "phi"], {"theta", "phi"})
    p = letters(s, rng, 0.35, l=whole(rng, 1, 3), m=whole(rng), g=whole(rng, 1, 10), F=whole(rng))
    l = p["l"]
    s.particle("P", p["m"], f"{l}*sin(theta)*cos(phi)", f"{l}*sin(theta)*sin(phi)", f"{l}*cos(theta)")
    if rng.random() < 0.75:
        s.weigh(rng.choice([p["g"], f"-({p['g']})"]), 2)
    wind = rng.choice([(p["F"], p["F"], "0"), ("3", "4", "0"), (p["F"], "0", "0"), (signed(rng), signed(rng), "0"),
                       ("0", p["F"], "0"), (signed(rng), signed(rng), signed(rng))])  # fmt: skip
    s.push("P", *wind)
    if rng.random() < 0.2:
        s.spring(whole(rng), ["0", "0", signed(rng)], "P")
    return s


def sphere_cartesian(rng: Rng) -> System:
    s = System("sphere, Cartesian", ["x", "y", "z"])
    p = letters(s, rng, 0.3, R=whole(rng, 1, 3), m=whole(rng), g=whole(rng), F=whole(rng))
    s.particle("P", p["m"], "x", "y", "z")
    s.constraints["c"] = f"x^2 + y^2 + z^2 = {p['R']}^2"
    s.weigh(p["g"], 2)
    if rng.random() < 0.7:
        s.push("P", p["F"], rng.choice(["0", signed(rng)]), "0")
    if rng.random() < 0.3:
        s.field(f"{whole(rng)}*x^2/2 + {rng.choice(['', '-'])}{whole(rng)}*y^2/2")
    if rng.random() < 0.3:
        chart = {
            "x": f"{p['R']}*sin(theta)*cos(phi)",
            "y": f"{p['R']}*sin(theta)*sin(phi)",
            "z": f"{p['R']}*cos(theta)",
        }
        s.choose("angles", ["theta", "phi"], chart, {"theta", "phi"})
    return s


def torus_chart(rng: Rng) -> System:
    s = System("torus, angles", ["theta", "phi"], {"theta", "phi"})
    r = rng.randint(1, 2)
    big = r + rng.randint(1, 2)
    p = letters(s, rng, 0.2, m=whole(rng), g=whole(rng, 1, 10))
    around = f"({big} + {r}*cos(phi))"
    s.particle("P", p["m"], f"{around}*cos(theta)", f"{around}*sin(theta)", f"{r}*sin(phi)")
    s.weigh(p["g"], rng.choice([0, 1, 2]))
    if rng.random() < 0.5:
        s.push("P", *rng.choice([("0", "0", signed(rng)), (signed(rng), "0", "0"), ("3", "4", "0")]))
    return s


def double_pendulum_cartesian(rng: Rng) -> System:
    s = System("double pendulum, Cartesian", ["x", "y", "X", "Y"], box=5)
    p = letters(s, rng, 0.35, a=whole(rng, 1, 3), b=whole(rng, 1, 3), m=whole(rng), M=whole(rng), g=whole(rng))
    s.particle("A", p["m"], "x", "y")
    s.particle("B", p["M"], "X", "Y")
    s.constraints["c1"] = rng.choice([f"x^2 + y^2 = {p['a']}^2", f"{p['a']}^2 - x^2 - y^2 = 0"])
    s.constraints["c2"] = rng.choice([f"(X - x)^2 + (Y - y)^2 = {p['b']}^2", f"{p['b']}^2 = (x - X)^2 + (y - Y)^2"])
    s.weigh(p["g"])
    if rng.random() < 0.4:
        s.push("B", signed(rng), "0")
    if rng.random() < 0.3:
        x, y = f"{p['a']}*sin(theta)", f"-{p['a']}*cos(theta)"
        chart = {"x": x, "y": y, "X": f"{x} + {p['b']}*sin(phi)", "Y": f"{y} - {p['b']}*cos(phi)"}
        s.choose("angles", ["theta", "phi"], chart, {"theta", "phi"})
    return s


def double_pendulum(rng: Rng) -> System:
    s = System("double pendulum, angles", ["theta", "phi"], {"theta", "phi"})
    p = letters(
        s, rng, 0.4, a=whole(rng, 1, 3), b=whole(rng, 1, 3), m=whole(rng), M=whole(rng), g=whole(rng), F=whole(rng)
    )
    s.particle("A", p["m"], f"{p['a']}*sin(theta)", f"-{p['a']}*cos(theta)")
    x, y = s.particles["A"][1]
    s.particle("B", p["M"], f"{x} + {p['b']}*sin(phi)", f"{y} - {p['b']}*cos(phi)")
    s.weigh(p["g"])
    if rng.random() < 0.6:
        s.push("B", p["F"], "0")
    return s


def torsion(rng: Rng) -> System:
    """Two rods with torsion springs under a force of constant direction."""
    s = System("rods with torsion springs", ["phi", "psi"], {"phi", "psi"})
    p = letters(s, rng, 0.6, k=whole(rng), a=whole(rng), F=whole(rng))
    s.angles = set()  # a torsion spring counts the turns of one rod against the other
    s.field(f"{p['k']}*(phi - psi)^2/2")
    s.field(
        rng.choice([f"{p['a']}*{p['F']}*sin(phi)", f"{p['F']}*cos(psi) + {p['a']}*cos(phi)", f"-{p['F']}*cos(phi)"])
    )
    s.turns_as_a_whole = rng.random() < 0.7
    if not s.turns_as_a_whole:
        s.field(f"{whole(rng)}*phi^2/2")
    return s


def four_bar(rng: Rng) -> System:
    """A closed linkage: three bars between two fixed pivots, each with its angle to the x axis."""
    s = System("four-bar linkage", ["alpha", "beta", "gamma"], {"alpha", "beta", "gamma"})
    a, b, c = (rng.randint(1, 3) for _ in range(3))
    d = rng.choice([a + b - c, b, a, rng.randint(1, 4)]) or 1
    s.constraints["h"] = f"{a}*cos(alpha) + {b}*cos(beta) - {c}*cos(gamma) = {d}"
    s.constraints["v"] = f"{a}*sin(alpha) + {b}*sin(beta) - {c}*sin(gamma) = 0"
    s.particle("A", "1", f"{a}*cos(alpha)", f"{a}*sin(alpha)")
    s.push("A", *rng.choice([("0", signed(rng)), (signed(rng), "0"), (signed(rng), signed(rng))]))
    s.particles["A"] = ("0", s.particles["A"][1])
    return s


def slider(rng: Rng) -> System:
    s = System("slider and crank", ["theta", "phi", "x"], {"theta", "phi"}, box=6)
    r, l = rng.choice([(1, 2), (1, 1), (3, 5), (2, 3)])
    s.constraints["h"] = f"x = {r}*cos(theta) + {l}*cos(phi)"
    s.constraints["v"] = rng.choice([f"{r}*sin(theta) = {l}*sin(phi)", f"2*{l}*sin(phi) - 2*{r}*sin(theta) = 0"])
    s.particle("A", "0", f"{r}*cos(theta)", f"{r}*sin(theta)")
    s.particle("S", "0", "x", "0")
    s.push("A", rng.choice(["0", signed(rng)]), signed(rng))
    if rng.random() < 0.5:
        s.push("S", signed(rng), "0")
    else:
        s.spring(whole(rng), ["0", "0"], "S", rng.choice(["0", "1"]))
    return s


def saddle(rng: Rng) -> System:
    """A quadratic form with symbols, perhaps with zeros on its diagonal."""
    n = rng.choice([2, 2, 3])
    s = System("quadratic potential", ["x", "y", "z"][:n])
    terms = []
    names = iter("abcdeh")
    for i in range(n):
        for j in range(i, n):
            if rng.random() < 0.6:
                coefficient = next(names) if rng.random() < 0.5 else whole(rng)
                if coefficient.isalpha():
                    s.parameters.append(coefficient)
                q = f"{s.coordinates[i]}^2/2" if i == j else f"{s.coordinates[i]}*{s.coordinates[j]}"
                terms.append(f"{rng.choice(['+', '-'])} {coefficient}*{q}")
    s.field(" ".join(terms or ["x*y"]).removeprefix("+ "))
    if rng.random() < 0.3:
        s.field(f"{signed(rng)}*x")
    return s


def polynomial(rng: Rng) -> System:
    s = System("polynomial potential", ["x", "y"][: rng.choice([1, 2])])
    p = letters(s, rng, 0.5, a=whole(rng), b=whole(rng), c=whole(rng))
    sign = rng.choice(["", "-"])
    if len(s.coordinates) == 1:
        s.field(rng.choice([f"{p['a']}*x^4/4 - {p['b']}*x^2/2", f"{p['a']}*x^3/3 - {p['b']}*x", f"{sign}{p['a']}*x^4 + {p['b']}*x^3",
                            f"{p['a']}*x^2/2 + {p['b']}/x", f"{p['a']}*x^4/4 - {p['b']}*x^2/2 + {p['c']}*x^3/3",
                            f"{p['a']}/x^2 - {p['b']}/x"]))  # fmt: skip
    else:
        s.field(rng.choice([f"{p['a']}*(x^2 + y^2 - 1)^2 + {p['b']}*x*y", f"{p['a']}*x^2*y - {p['b']}*y + {p['c']}*y^2/2",
                            f"{p['a']}*x^4/4 - {p['b']}*x^2/2 {rng.choice('+-')} {p['c']}*y^2/2",
                            f"{p['a']}*x^3/3 - {p['b']}*x + {p['c']}*x*y + y^2/2"]))  # fmt: skip
    return s


def angle_potential(rng: Rng) -> System:
    """A bead in a potential of one angle, as on a rotating hoop."""
    s = System("potential of an angle", ["theta"], {"theta"})
    p = letters(s, rng, 0.5, a=whole(rng), b=whole(rng), c=whole(rng))
    s.field(rng.choice([f"-{p['a']}*sin(theta)^2/2 - {p['b']}*cos(theta)", f"{p['a']}*cos(theta) + {p['b']}*sin(theta)",
                        f"{p['a']}*cos(2*theta) + {p['b']}*cos(theta)", f"{p['a']}*sin(2*theta) - {p['b']}*cos(theta)",
                        f"-{p['a']}*sin(theta)^2/2 - {p['b']}*cos(theta) + {p['c']}*sin(theta)^4"]))  # fmt: skip
    return s


def skate(rng: Rng) -> System:
    """A blade in a plane, held by a spring or pulled; its angle may have a spring as well."""
    s = System("skate", ["x", "y", "theta"], {"theta"})
    s.particle("P", "0", "x", "y")
    s.forms["blade"] = rng.choice(
        [{"x": "sin(theta)", "y": "-cos(theta)"}, {"y": "2*cos(theta)", "x": "-2*sin(theta)"}]
    )
    p = letters(s, rng, 0.4, k=whole(rng), F=whole(rng))
    kind = rng.randrange(4)
    if kind == 0:
        s.field(f"{p['k']}*x^2/2")
    elif kind == 1:
        s.spring(p["k"], ["0", "0"], "P", rng.choice(["0", "1"]))
    elif kind == 2:
        s.push("P", p["F"], rng.choice(["0", signed(rng)]))
    else:
        s.field(f"{p['k']}*x^2/2")
        s.push("P", "0", p["F"])
    return s


def inclines(rng: Rng) -> System:
    """Two beads on two lines, joined by a rod."""
    s = System("two beads and a rod", ["x", "y"], box=5)
    p = letters(s, rng, 0.3, l=whole(rng, 1, 4), m=whole(rng), M=whole(rng), g=whole(rng))
    if rng.random() < 0.5:
        s.particle("A", p["m"], "x", "0")
        s.particle("B", p["M"], "0", "y")
        s.constraints["rod"] = rng.choice([f"x^2 + y^2 = {p['l']}^2", f"{p['l']}^2 = y^2 + x^2"])
    else:
        s.particle("A", p["m"], "3*x/5", "4*x/5")
        s.particle("B", p["M"], "-y", "0")
        s.constraints["rod"] = f"(3*x/5 + y)^2 + (4*x/5)^2 = {p['l']}^2"
    s.weigh(p["g"])
    s.spring(whole(rng), ["0", "0"], rng.choice("AB"), rng.choice(["0", "0", "1"]))
    return s


def rod_pulled(rng: Rng) -> System:
    """A rod on a pivot with its weight, a pull and perhaps a spring to a point above the pivot."""
    s = System("rod on a pivot", ["theta"], {"theta"})
    p = letters(s, rng, 0.4, l=whole(rng, 1, 3), m=whole(rng), g=whole(rng), F=whole(rng), H=whole(rng), k=whole(rng))
    s.particle("P", p["m"], f"{p['l']}*sin(theta)", f"{p['l']}*cos(theta)")
    s.weigh(p["g"])
    if rng.random() < 0.5:
        s.push("P", p["F"], p["H"])
    else:
        s.spring(p["k"], ["0", p["H"]], "P", rng.choice(["0", "0", "1"]))
    return s


FAMILIES: list[tuple[int, Callable[[Rng], System]]] = [
    (2, circle_cartesian), (4, circle_spring), (2, circle_pole), (2, line), (5, sphere_chart), (2, sphere_cartesian),
    (4, torus_chart), (3, double_pendulum_cartesian), (3, double_pendulum), (3, torsion), (4, four_bar), (2, slider),
    (5, saddle), (4, polynomial), (3, angle_potential), (4, skate), (2, inclines), (3, rod_pulled),
]  # fmt: skip


def random_system(rng: Rng) -> System:
    """A system at rest; with masses everywhere it may be asked for small oscillations too."""
    weights, families = zip(*FAMILIES, strict=True)
    [family] = rng.choices(families, weights)
    s = family(rng)
    if s.particles and not s.forms and all(m != "0" for m, _ in s.particles.values()) and rng.random() < 0.4:
        s.find = "[equilibrium, linearization]"
    return s
