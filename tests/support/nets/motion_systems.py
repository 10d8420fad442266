"""Random systems that move, one function a family."""

from __future__ import annotations

import random
from collections.abc import Callable

from tests.support.nets.statics_systems import letters, number, signed, whole
from tests.support.nets.system import System

Rng = random.Random


def kept(s: System, rng: Rng, constraint: str, particle: str, *anchor: str) -> None:
    """A constraint that keeps a distance, by what the file says: a tension, or the force of a surface."""
    by = rng.choice(["", "", "rod", "string", "wire", "surface"])
    if by:
        s.keepers[constraint] = by
    if by not in ("wire", "surface"):
        s.anchors[constraint] = (particle, anchor)


def central(rng: Rng) -> System:
    s = System("particle in polar coordinates", ["r", "phi"], {"phi"})
    p = letters(s, rng, 0.6, m=whole(rng), a=whole(rng))
    s.particle("P", p["m"], "r*cos(phi)", "r*sin(phi)")
    s.field(rng.choice([f"-{p['a']}/r", f"{p['a']}*r^2/2", f"{p['a']}*r^4", f"{p['a']}*r*cos(phi)"]))
    if rng.random() < 0.3:
        s.damper(whole(rng), ["0", "0"], "P")
    return s


def pendulum_cartesian(rng: Rng) -> System:
    s = System("pendulum, Cartesian", ["x", "y"])
    p = letters(s, rng, 0.6, m=whole(rng), l=whole(rng, 1, 2), g=whole(rng, 1, 10))
    s.particle("P", p["m"], "x", "y")
    s.constraints["rod"] = rng.choice(
        [f"x^2 + y^2 = {p['l']}^2", f"{p['l']} = sqrt(x^2 + y^2)", f"{p['l']}^2 - y^2 - x^2 = 0"]
    )
    s.named["rod"] = "S"
    kept(s, rng, "rod", "P", "0", "0")
    s.weigh(p["g"])
    if rng.random() < 0.4:
        s.push("P", signed(rng), "0")
    if rng.random() < 0.3:
        s.damper(whole(rng), [signed(rng), "3"], "P")
    if rng.random() < 0.6:
        x, y = rng.sample([f"{p['l']}*sin(theta)", f"{rng.choice(['', '-'])}{p['l']}*cos(theta)"], 2)
        s.choose("angle", ["theta"], {"x": x, "y": y}, {"theta"})
    return s


def wire(rng: Rng) -> System:
    s = System("bead on a wire", ["x", "y"])
    p = letters(s, rng, 0.6, m=whole(rng), a=whole(rng), g=whole(rng))
    s.particle("P", p["m"], "x", "y")
    curve = rng.choice(
        [f"{p['a']}*x^2", f"-x*{p['a']}/2", f"sin({p['a']}*x)", "x^2 + sin(t)", f"{p['a']}*x*t", "exp(x)"]
    )
    s.constraints["wire"] = rng.choice([f"y = {curve}", f"{curve} = y", f"2*y - 2*({curve}) = 0"])
    s.named["wire"] = "N"
    s.keepers |= rng.choice([{}, {"wire": "wire"}, {"wire": "surface"}])
    s.weigh(p["g"])
    if rng.random() < 0.6:
        s.choose("abscissa", ["x"], {"y": curve}, set())
    return s


def spherical(rng: Rng) -> System:
    s = System("spherical pendulum", ["theta", "phi"], {"theta", "phi"})
    p = letters(s, rng, 0.5, m=whole(rng), l=whole(rng, 1, 3), g=whole(rng))
    l = rng.choice([p["l"], p["l"], f"({p['l']} + t)"])
    s.particle("P", p["m"], f"{l}*sin(theta)*cos(phi)", f"{l}*sin(theta)*sin(phi)", f"-{l}*cos(theta)")
    s.weigh(p["g"], rng.choice([2, 2, 0]))
    return s


def sphere(rng: Rng) -> System:
    s = System("particle on a surface", ["x", "y", "z"])
    p = letters(s, rng, 0.5, m=whole(rng), R=whole(rng, 1, 3), g=whole(rng))
    s.particle("P", p["m"], "x", "y", "z")
    s.constraints["surface"] = rng.choice(
        [f"x^2 + y^2 + z^2 = {p['R']}^2", f"z = {p['R']}*(x^2 + y^2)", f"x^2 + y^2 = {p['R']}^2*z^2"]
    )
    s.named["surface"] = "N"
    if s.constraints["surface"].startswith("x^2 + y^2 + z^2"):
        kept(s, rng, "surface", "P", "0", "0", "0")
    s.weigh(p["g"], 2)
    return s


def double(rng: Rng) -> System:
    s = System("double pendulum", ["theta", "phi"], {"theta", "phi"})
    p = letters(s, rng, 0.5, a=whole(rng), b=whole(rng), m=whole(rng), M=whole(rng), g=whole(rng))
    s.particle("A", p["m"], f"{p['a']}*sin(theta)", f"-{p['a']}*cos(theta)")
    x, y = s.particles["A"][1]
    s.particle("B", p["M"], f"{x} + {p['b']}*sin(phi)", f"{y} - {p['b']}*cos(phi)")
    s.weigh(p["g"])
    if rng.random() < 0.4:
        s.spring(number(rng), [signed(rng), "5"], "B", rng.choice(["0", "1"]))
    return s


def double_cartesian(rng: Rng) -> System:
    s = System("double pendulum, Cartesian", ["x", "y", "X", "Y"])
    p = letters(s, rng, 0.4, a=whole(rng, 1, 2), b=whole(rng, 1, 2), m=whole(rng), M=whole(rng), g=whole(rng))
    s.particle("A", p["m"], "x", "y")
    s.particle("B", p["M"], "X", "Y")
    s.constraints["c1"] = rng.choice([f"x^2 + y^2 = {p['a']}^2", f"{p['a']}^2 = x^2 + y^2"])
    s.constraints["c2"] = rng.choice([f"(X - x)^2 + (Y - y)^2 = {p['b']}^2", f"{p['b']}^2 = (x - X)^2 + (y - Y)^2"])
    s.named = {"c1": "S", "c2": "T_r"}
    kept(s, rng, "c1", "A", "0", "0")
    s.anchors["c2"] = ("B", ("x", "y"))
    s.weigh(p["g"])
    if rng.random() < 0.5:
        x, y = f"{p['a']}*sin(theta)", f"-{p['a']}*cos(theta)"
        chart = {"x": x, "y": y, "X": f"{x} + {p['b']}*sin(phi)", "Y": f"{y} - {p['b']}*cos(phi)"}
        s.choose("angles", ["theta", "phi"], chart, {"theta", "phi"})
    return s


def sleigh(rng: Rng) -> System:
    """A body in the plane on a blade, beside its mass centre perhaps."""
    s = System("sleigh", ["x", "y", "theta"], {"theta"})
    p = letters(s, rng, 0.6, m=whole(rng), J=whole(rng), c=whole(rng))
    aside = rng.random() < 0.5
    r = (f"x + {p['c']}*cos(theta)", f"y + {p['c']}*sin(theta)") if aside else ("x", "y")
    s.bodies["B"] = (p["m"], p["J"], r, "theta")
    s.forms["blade"] = rng.choice(
        [{"x": "sin(theta)", "y": "-cos(theta)"}, {"x": "2*sin(theta)", "y": "-2*cos(theta)"}]
    )
    if rng.random() < 0.5:
        s.weigh(whole(rng))
    if rng.random() < 0.4:
        s.push_at("B", ("x", "y"), signed(rng), signed(rng))
    return s


def rolling(rng: Rng) -> System:
    s = System("disc on an incline", ["x", "theta"], {"theta"})
    p = letters(s, rng, 0.6, m=whole(rng), J=whole(rng), R=whole(rng), g=whole(rng))
    s.bodies["B"] = (p["m"], p["J"], ("4*x/5", "-3*x/5"), "-theta")
    s.forms["no_slip"] = rng.choice([{"x": "1", "theta": f"-{p['R']}"}, {"theta": f"3*{p['R']}", "x": "-3"}])
    s.weigh(p["g"])
    return s


def springs(rng: Rng) -> System:
    s = System("masses and springs", ["x", "y"])
    p = letters(s, rng, 0.5, m=whole(rng), M=whole(rng), k=whole(rng))
    s.particle("A", p["m"], "x", "0")
    s.particle("B", p["M"], "y", "0")
    s.field(f"{p['k']}*x^2/2 + {whole(rng)}*(x - y)^2/2")
    if rng.random() < 0.5:
        s.damper(whole(rng), ["7", "0"], "B")
    if rng.random() < 0.4:
        s.field("-y*sin(3*t)")
    return s


def atwood(rng: Rng) -> System:
    s = System("two weights on a string", ["x", "y"])
    p = letters(s, rng, 0.6, m=whole(rng), M=whole(rng), L=whole(rng, 3, 6), g=whole(rng))
    s.particle("A", p["m"], "0", "-x")
    s.particle("B", p["M"], "1", "-y")
    s.constraints["string"] = rng.choice([f"x + y = {p['L']}", f"{p['L']} = x + y", f"-2*x - 2*y + 2*{p['L']} = 0"])
    s.named["string"] = "T_s"
    s.anchors["string"] = ("A", ("0", "1000"))
    s.weigh(p["g"])
    return s


def cart(rng: Rng) -> System:
    s = System("pendulum on a cart", ["x", "theta"], {"theta"})
    p = letters(s, rng, 0.6, m=whole(rng), M=whole(rng), l=whole(rng), g=whole(rng))
    s.particle("C", p["M"], "x", "0")
    s.particle("P", p["m"], f"x + {p['l']}*sin(theta)", f"-{p['l']}*cos(theta)")
    s.weigh(p["g"])
    if rng.random() < 0.5:
        s.push("C", rng.choice([signed(rng), "sin(t)"]), "0")
    return s


def knife(rng: Rng) -> System:
    """A particle in space with one kinematic constraint."""
    s = System("kinematic constraint", ["x", "y", "z"])
    p = letters(s, rng, 0.5, m=whole(rng), a=whole(rng))
    s.particle("P", p["m"], "x", "y", "z")
    s.forms["c"] = rng.choice([{"z": "1", "x": f"-{p['a']}*y"}, {"x": "y*z", "y": "x*z", "z": f"{p['a']}*x*y"},
                               {"x": "cos(z)", "y": "sin(z)"}, {"x": "1", "y": "t"}, {"x": "y", "y": "-x"}])  # fmt: skip
    if rng.random() < 0.6:
        s.weigh(whole(rng), rng.choice([1, 2]))
    if rng.random() < 0.3:
        s.field(f"{whole(rng)}*x^2/2")
    return s


def rotating(rng: Rng) -> System:
    s = System("bead on a turning curve", ["theta"], {"theta"})
    p = letters(s, rng, 0.6, m=whole(rng), R=whole(rng), g=whole(rng), w=whole(rng))
    s.particle(
        "P",
        p["m"],
        f"{p['R']}*sin(theta)*cos({p['w']}*t)",
        f"{p['R']}*sin(theta)*sin({p['w']}*t)",
        f"-{p['R']}*cos(theta)",
    )
    s.weigh(p["g"], rng.choice([2, 2, 0]))
    return s


def disc_and_cord(rng: Rng) -> System:
    """A disc on its axis, drawn by a cord; a constant force at a point of a free body."""
    if rng.random() < 0.5:
        s = System("disc drawn by a cord", ["phi"], {"phi"})
        p = letters(s, rng, 0.6, J=whole(rng), R=whole(rng), T=whole(rng))
        s.bodies["disc"] = ("1", p["J"], ("0", "0"), "phi")
        s.forces.append(f"F0: {{on: disc, vector: '{p['T']}*j', at: '{p['R']}*i'}}")
        s.terms.append(f"-({p['T']})*({p['R']})*phi")
        return s
    s = System("free body", ["x", "y", "phi"], {"phi"})
    p = letters(s, rng, 0.6, J=whole(rng), m=whole(rng), F=whole(rng))
    s.bodies["B"] = (p["m"], p["J"], ("x", "y"), "phi")
    a, b = whole(rng), signed(rng)
    s.push_at(
        "B",
        (f"x + {a}*cos(phi) - ({b})*sin(phi)", f"y + {a}*sin(phi) + ({b})*cos(phi)"),
        p["F"],
        rng.choice(["0", signed(rng)]),
    )
    return s


FAMILIES: list[Callable[[Rng], System]] = [
    central, pendulum_cartesian, pendulum_cartesian, wire, wire, spherical, sphere, double, double_cartesian, sleigh, sleigh,
    rolling, springs, atwood, cart, knife, knife, rotating, disc_and_cord, disc_and_cord,
]  # fmt: skip


def random_system(rng: Rng) -> System:
    s = rng.choice(FAMILIES)(rng)
    s.find = "[motion]"
    return s
