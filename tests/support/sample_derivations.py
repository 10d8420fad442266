"""Derivations made by hand, for the tests of the renderers."""

import sympy as sp

from lagrange.core.symbols import DotProduct, Partial, UnitVector, VectorSymbol, differential, prime, t, variation
from lagrange.core.vectors import Triad, Vector
from lagrange.document.derivation import (
    CheckMark,
    Derivation,
    Detail,
    Emphasis,
    Equation,
    Ref,
    Rule,
    Step,
    Table,
    display,
    math,
    prose,
)
from lagrange.document.math_writer import Notation

d, delta = differential, variation
sin, cos = sp.sin, sp.cos
ZERO = sp.S.Zero
m, g, length, a, b, omega = sp.symbols("m g l a b omega", real=True)
POSITION, ACCELERATION, FORCE, SHIFT = (VectorSymbol(n) for n in ("r_P", "r_P''", "F", "delta(r_P)"))
PRINCIPLE = DotProduct(m * ACCELERATION - FORCE, SHIFT)


def dot(symbol):
    return prime(symbol)


def ddot(symbol):
    return prime(symbol, 2)


def pendulum():
    x, y, theta = sp.symbols("x y theta", real=True)
    a_x, a_y, a_t = sp.symbols("a_x a_y a_t", real=True)
    motion = ddot(theta) + g / length * sin(theta)
    steps = (
        Step(
            Rule.STATEMENT,
            "The system",
            (
                prose(
                    "A particle P of mass ", math(m), " hangs from a fixed point O by a massless rigid ",
                    "rod of length ",
                    math(length), ". Axes: ", math(UnitVector("i")), " points right, ",
                    math(UnitVector("j")), " down.",
                ),
                display(
                    Equation((POSITION, Vector((x, y, ZERO)))),
                    Equation((FORCE, Vector((ZERO, m * g, ZERO)))),
                ),
            ),
        ),
        Step(
            Rule.CONSTRAINT,
            "Constraint",
            (
                prose(Emphasis("rod"), ": no velocity occurs, so the constraint is ", Emphasis("geometric"), "."),
                display(Equation((x**2 + y**2 - length**2, ZERO), "rod")),
            ),
        ),
        Step(
            Rule.PFAFFIAN_FORM,
            "Differential form",
            (
                display(Equation((2 * x * d(x) + 2 * y * d(y), ZERO), "pfaffian")),
                Table(
                    ("constraint", math(a_x), math(a_y), math(a_t)),
                    (("rod", math(2 * x), math(2 * y), math(ZERO)),),
                    Detail.FULL,
                ),
                prose(
                    math(Partial(2 * x, y), ZERO, Partial(2 * y, x)),
                    ": exact. The constraint is the finite relation ", math(x**2 + y**2, length**2), ".",
                ),
            ),
        ),
        Step(
            Rule.PRINCIPLE,
            "D'Alembert's principle",
            (
                display(
                    Equation((PRINCIPLE, ZERO)),
                    Equation((m * ddot(x) * delta(x) + m * (ddot(y) - g) * delta(y), ZERO), "principle"),
                ),
            ),
        ),
        Step(
            Rule.EQUATIONS_OF_MOTION,
            "Equation of motion",
            (
                prose("With ", Ref("rod"), " it becomes", detail=Detail.BRIEF),
                display(
                    Equation(
                        (motion, ZERO), "motion", condition=("where ", math(length, ZERO, relation="≠"))
                    ),
                    boxed=True, detail=Detail.BRIEF,
                ),
            ),
        ),
        Step(
            Rule.CHECKS,
            "Checks",
            (
                CheckMark(("Lagrange's equations give the same",), True, "exact, 20 random points"),
                CheckMark((math(motion, ZERO), " is the textbook's"), None, "not decided within two seconds"),
                CheckMark(("energy is conserved",), False, ""),
            ),
        ),
    )  # fmt: skip
    return Derivation("Ideal pendulum", "Chapter 6, Ex. 11", steps), Notation(coordinates=(x, y, theta))


def driven_pendulum():
    r, theta, phi = sp.symbols("r theta phi", real=True)
    triad = Triad(("e_r", "e_theta", "e_phi"))
    acceleration = (
        ddot(r) - r * dot(theta) ** 2 - r * dot(phi) ** 2 * sin(theta) ** 2,
        r * ddot(theta) + 2 * dot(r) * dot(theta) - r * dot(phi) ** 2 * sin(theta) * cos(theta),
        r * ddot(phi) * sin(theta) + 2 * dot(r) * dot(phi) * sin(theta) + 2 * r * dot(theta) * dot(phi) * cos(theta),
    )
    along, across = acceleration[1] - g * sin(theta), acceleration[2]
    form = sp.Add(d(r), sp.Mul(0, d(theta), evaluate=False), b * omega * sin(omega * t) * d(t), evaluate=False)
    steps = (
        Step(Rule.PFAFFIAN_FORM, "Differential form", (display(Equation((form, ZERO), "form")),)),
        Step(
            Rule.PRINCIPLE,
            "D'Alembert's principle",
            (
                prose("With the acceleration"),
                display(Equation((ACCELERATION, Vector(acceleration, triad)), "acceleration")),
                prose("the principle ", math(PRINCIPLE, ZERO), " reads, by ", Ref("acceleration"), ","),
                display(
                    Equation(
                        (m * r * along * delta(theta) + m * r * sin(theta) * across * delta(phi), ZERO),
                        "principle",
                    )
                ),
            ),
        ),
        Step(
            Rule.EQUATIONS_OF_MOTION,
            "Equations of motion",
            (
                prose(
                    math(delta(theta)), " and ", math(delta(phi)), " are independent, so each bracket in ",
                    Ref("principle"), " vanishes (dividing by ", math(m * r, ZERO, relation="!="), "); also ",
                    math(sp.Symbol("lambda"), m * acceleration[0] + m * g * cos(theta)), ".",
                ),
                display(
                    Equation((along, ZERO), "theta"),
                    Equation(
                        (across, ZERO), "phi",
                        condition=(
                            "with ", math(r, a + b * cos(omega * t)), ", ",
                            math(dot(r), -b * omega * sin(omega * t)),
                        ),
                    ),
                    boxed=True,
                ),
            ),
        ),
    )  # fmt: skip
    derivation = Derivation("A pendulum whose length is varied", "Chapter 6, Ex. 17", steps)
    return derivation, Notation(coordinates=(r, theta, phi))


def double_pendulum():
    names = "x_1 y_1 z_1 x_2 y_2 z_2 theta_1 theta_2"
    x1, y1, _, x2, y2, _, t1, t2 = symbols = sp.symbols(names, real=True)
    m1, m2, l1, l2 = sp.symbols("m_1 m_2 l_1 l_2", real=True)
    turn, lean = cos(t1 - t2), sin(t1 - t2)
    first = (m1 + m2) * l1 * ddot(t1) + m2 * l2 * (ddot(t2) * turn + dot(t2) ** 2 * lean) + (m1 + m2) * g * sin(t1)
    second = l1 * ddot(t1) * turn + l2 * ddot(t2) - l1 * dot(t1) ** 2 * lean + g * sin(t2)
    solved = (m2 * g * sin(t1 - 2 * t2) + g * (2 * m1 + m2) * sin(t1) + 2 * m2 * lean * (l2 * dot(t2) ** 2 + a)) / (
        l1 * (2 * m1 + m2 - m2 * cos(2 * t1 - 2 * t2))
    )
    coefficients = (2 * x1 - 2 * x2, 2 * y1 - 2 * y2, ZERO, 2 * x2 - 2 * x1, 2 * y2 - 2 * y1, ZERO, ZERO)
    columns = [sp.Symbol(f"a_{q}") for q in ("x1", "y1", "z1", "x2", "y2", "z2", "t")]
    table = Table(
        ("constraint", *(math(column) for column in columns)),
        (
            ("rod 1", *(math(c) for c in (2 * x1, 2 * y1, ZERO, ZERO, ZERO, ZERO, ZERO))),
            ("rod 2", *(math(c) for c in coefficients)),
        ),
    )
    steps = (
        Step(Rule.PFAFFIAN_FORM, "Differential form of the constraints", (table,)),
        Step(
            Rule.PRINCIPLE,
            "D'Alembert's principle",
            (display(Equation((l1 * first * delta(t1) + m2 * l2 * second * delta(t2), ZERO), "principle")),),
        ),
        Step(
            Rule.EQUATIONS_OF_MOTION,
            "Equations of motion",
            (
                display(Equation((first, ZERO), "first"), Equation((second, ZERO), "second"), boxed=True),
                display(Equation((ddot(t1), -solved), "solved")),
            ),
        ),
    )
    return Derivation("Double pendulum", "Chapter 6, Ex. 18", steps), Notation(coordinates=symbols)


SAMPLES = (pendulum, driven_pendulum, double_pendulum)


def chain(links):
    """The n-link pendulum: equations of any length."""
    m, l, q = (sp.symbols(f"{name}_1:{links + 1}", real=True) for name in ("m", "l", "theta"))
    equations = []
    for i in range(links):
        terms = [
            sp.Add(*m[max(i, j) :]) * l[i] * l[j] * sp.Symbol(f"{q[j]}''") * sp.cos(q[i] - q[j]) for j in range(links)
        ]
        equations.append(Equation((sp.Add(*terms), sp.S.Zero), f"q{i}"))
    work = sp.Add(*(e.sides[0] * sp.Symbol(f"delta({s})") for e, s in zip(equations, q, strict=True)))
    fraction = sp.sqrt(sp.Add(*l)) * equations[0].sides[0] / sp.Add(*m)
    cells = [[math(l[i] * sp.cos(q[i] - q[j])) for j in range(links)] for i in range(links)]
    table = Table(("rod", *(math(s) for s in q)), tuple((f"{n}", *row) for n, row in enumerate(cells)))
    blocks = (
        display(Equation((work, sp.S.Zero), "work", condition=("where ", math(l[0], sp.S.Zero, relation="≠")))),
        display(*equations, boxed=True),
        display(Equation((sp.Symbol("Q"), fraction, fraction**2), "Q")),
        table,
        prose("In the text, ", math(work, sp.S.Zero), " and ", math(fraction), ", by ", Ref("work"), "."),
    )
    steps = (Step(Rule.STATEMENT, "A step", blocks),)
    return Derivation(f"{links} links & more", "50% of θ̈, “中”", steps), Notation(coordinates=q)
