"""Systems of constraints: rank, integrable rank, hidden relations, degrees of freedom, against Lie brackets in numbers.

The motions that constraints A(q) q′ = 0 admit are combinations of fields X₁, …, X_f that span the kernel of A. The smallest involutive
set of fields that contains them has at a generic point a dimension d; n − d independent functions are constant along every motion, and
that is the rank of the largest integrable subsystem. Fields are Taylor series about a random point: a bracket costs one order.
"""

from __future__ import annotations

import random
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from tests.support.nets.evaluate import difference, evaluate
from tests.support.nets.rest import newton
from tests.support.nets.run import Finding, printed, wrong_names
from tests.support.nets.statics import rewritten
from tests.support.nets.system import System
from tests.support.nets.taylor import Taylor, variables

Array = Any
ORDER = 4
"""Of the series: so many brackets one within the other."""
POINTS_SOUGHT = 3
"""Places from which a position that satisfies refused constraints is sought."""


def findings(seed: int) -> list[Finding]:
    """One random system of constraints, and the same written in another way."""
    rng = random.Random(seed)
    system = random_system(rng)
    found = check_system(system, random.Random(seed))
    if seed % 2:
        found += [
            replace(f, kind=f"{f.kind} (rewritten)") for f in check_system(rewritten(system, rng), random.Random(seed))
        ]
    return found


def random_system(rng: random.Random) -> System:
    """One to three constraints in three to five coordinates: forms, relations, and forms that hide a relation."""
    n = rng.choice([3, 3, 4, 4, 5])
    s = System("constraints", ["x", "y", "z", "u", "v"][:n])
    for c in range(rng.randint(1, min(3, n - 1))):
        if rng.random() < 0.25:
            s.constraints[f"c{c}"] = f"{_function(s, rng)} = {rng.randint(1, 3)}"
        else:
            s.forms[f"c{c}"] = _form(s, rng)
    s.find = "[constraints]"
    return s


def _function(s: System, rng: random.Random) -> str:
    a, b, c = rng.sample(s.coordinates, 3)
    return rng.choice([f"{a}*{b} + {c}", f"{a}^2 + {b}^2", f"{a} + 2*{b} - sin({c})", f"{a}*exp({b})", f"{a}*{b}*{c}"])


def _derivative(f: str, q: str) -> str:
    """∂f/∂q for the functions above, by their form."""
    terms: list[str] = []
    for term in f.replace(" - ", " + -1*").split(" + "):
        factors = term.split("*")
        for k, factor in enumerate(factors):
            inner = {q: "1", f"{q}^2": f"2*{q}", f"sin({q})": f"cos({q})", f"exp({q})": f"exp({q})"}.get(factor)
            if inner:
                terms.append("*".join([*factors[:k], inner, *factors[k + 1 :]]))
    return " + ".join(terms) or "0"


def _form(s: System, rng: random.Random) -> dict[str, str]:
    kind = rng.randrange(4)
    if kind == 0:  # the differential of a function, perhaps with a factor
        f = _function(s, rng)
        factor = rng.choice(["1", "1", "(1 + x^2)", "exp(z)", "(2 + sin(y))"])
        form = {q: f"{factor}*({d})" for q in s.coordinates if (d := _derivative(f, q)) != "0"}
    elif kind == 1:  # contact form
        a, b, c = rng.sample(s.coordinates, 3)
        form = {a: "1", b: f"-{c}"}
    elif kind == 2:  # a blade
        a, b, c = rng.sample(s.coordinates, 3)
        form = {a: f"sin({c})", b: f"-cos({c})"}
    else:
        chosen = rng.sample(s.coordinates, rng.randint(2, 3))
        form = {
            a: rng.choice(["1", rng.choice(s.coordinates), str(rng.randint(2, 3)), f"{rng.choice(s.coordinates)}^2"])
            for a in chosen
        }
    return form


def _point(system: System, rng: random.Random) -> list[float] | None:
    """A random point at which the geometric constraints hold: there, by convention, integrability is judged."""

    def broken(q: Array) -> tuple[Array, Array]:
        fs = system.finite(q, {})
        return np.array([f.value for f in fs]), np.array([f.gradient for f in fs])

    for _ in range(20):
        start = np.array([rng.uniform(0.3, 1.6) for _ in system.coordinates])
        found = newton(broken, start) if system.constraints else (start, None)
        if found is not None and np.abs(found[0]).min() > 0.05:
            return [float(x) for x in found[0]]
    return None


def ranks(system: System, rng: random.Random) -> tuple[int, int] | None:
    """Rank and integrable rank at a random point; None where two points disagree, or a bracket is needed beyond the order."""
    found = set()
    for _ in range(2):
        at = _point(system, rng)
        found.add(_ranks(system, at) if at is not None else None)
    return found.pop() if len(found) == 1 else None


def _ranks(system: System, at: Sequence[float]) -> tuple[int, int] | None:
    xs = variables(at, ORDER + 1)
    names = dict(zip(system.coordinates, xs, strict=True))
    zero, n = xs[0] * 0, len(xs)
    rows = [[difference(c, names).derivative(k) for k in range(n)] for c in system.constraints.values()]
    rows += [[zero + evaluate(form.get(q, "0"), names) for q in system.coordinates] for form in system.forms.values()]
    fields, rank = _kernel(rows, n, zero)
    span = _span(fields)
    known = list(fields)
    newest = list(fields)
    for _ in range(ORDER):
        further = []  # brackets of combinations of fields are combinations of their brackets and of the fields
        for bracket in (_bracket(a, b) for a in fields for b in newest if a is not b):
            if _span([*known, bracket]) > span:
                span += 1
                known.append(bracket)
                further.append(bracket)
        if not further or span == n:
            return rank, n - span
        newest = further
    return None


def _span(fields: Sequence[list[Taylor]]) -> int:
    matrix = np.array([[c.value for c in field] for field in fields])
    sizes = np.linalg.svd(matrix / (1e-300 + np.abs(matrix).max(axis=1, keepdims=True).clip(1e-8)))[1]
    return int((sizes > 1e-7 * sizes[0]).sum())


def _bracket(a: list[Taylor], b: list[Taylor]) -> list[Taylor]:
    """[a, b]ₖ = Σ aⱼ ∂ⱼbₖ − bⱼ ∂ⱼaₖ."""
    result = []
    for k in range(len(a)):
        total = a[0] * 0
        for j in range(len(a)):
            total = total + a[j] * b[k].derivative(j) - b[j] * a[k].derivative(j)
        result.append(total)
    return result


def _kernel(rows: list[list[Taylor]], n: int, zero: Taylor) -> tuple[list[list[Taylor]], int]:
    """Fields that span the kernel near the point, by elimination with the largest pivots; and the rank."""
    left = [row[:] for row in rows]
    pivots: list[tuple[int, list[Taylor]]] = []
    while left:
        taken = {p for p, _ in pivots}
        sizes = [[abs(row[k].value) if k not in taken else 0.0 for k in range(n)] for row in left]
        r = max(range(len(left)), key=lambda i: max(sizes[i]))
        k = max(range(n), key=lambda j: sizes[r][j])
        if sizes[r][k] < 1e-8:
            break
        inverse = left[r][k] ** -1
        row = [x * inverse for x in left.pop(r)]
        left = [[x - other[k] * y for x, y in zip(other, row, strict=True)] for other in left]
        pivots = [(p, [x - other[k] * y for x, y in zip(other, row, strict=True)]) for p, other in pivots]
        pivots.append((k, row))
    solved = dict(pivots)
    fields = []
    for free in range(n):
        if free in solved:
            continue
        field = [zero for _ in range(n)]
        field[free] = zero + 1
        for p, row in pivots:
            field[p] = -row[free]
        fields.append(field)
    return fields, len(pivots)


def check_system(system: System, rng: random.Random) -> list[Finding]:
    """All that is not true of what is printed for a system of constraints."""
    shown = printed(system.text)
    if isinstance(shown, Finding):
        # x z + y = 2 with x z + y = 1, or y (2 − y) = 3: what no position satisfies is rightly refused.
        satisfied = not system.constraints or any(_point(system, rng) is not None for _ in range(POINTS_SOUGHT))
        return [shown] if shown.kind != "refused" or satisfied else []
    found = wrong_names(shown)
    numbers = ranks(system, rng)
    if numbers is None:
        return found
    rank, integrable = numbers
    n, stated = len(system.coordinates), shown.json["classification"]
    true = {"rank": rank, "integrable_rank": integrable, "holonomic": rank == integrable}
    for key, value in true.items():
        if stated[key] is not None and stated[key] != value:
            found.append(Finding(key, f"{key}: {stated[key]}", str(value)))
        if stated[key] is None:
            found.append(Finding(f"undecided {key}", f"{key}: undecided", str(value)))
    if shown.json["degrees_of_freedom"] != n - rank:
        found.append(Finding("degrees of freedom", str(shown.json["degrees_of_freedom"]), str(n - rank)))
    if shown.json["configuration_dimension"] not in (n - integrable, None):
        found.append(
            Finding("configuration dimension", str(shown.json["configuration_dimension"]), str(n - integrable))
        )
    for c in shown.json["constraints"]:
        name = c["name"]
        forms = {name: system.forms[name]} if name in system.forms else {}
        alone = ranks(System("one", system.coordinates, constraints=system.constraints, forms=forms), rng)
        if alone and c.get("integrable") is not None and c["integrable"] != (alone[0] == alone[1]):
            found.append(Finding("integrable", f"{name} alone: {c['integrable']}", str(alone[0] == alone[1])))
        if c.get("integral"):
            found += _integral(system, c, rng)
    found += _hidden(system, stated["hidden"], integrable, rng)
    return [replace(f, text=system.text) for f in {f.kind: f for f in found}.values()]


def _rows(system: System, names: dict[str, Any], chosen: str | None = None) -> list[Array]:
    """Gradients of the geometric constraints, and coefficients of the kinematic ones, or of the one chosen."""
    zero = names[system.coordinates[0]] * 0
    rows = [difference(c, names).gradient for c in system.constraints.values()]
    forms = [f for n, f in system.forms.items() if chosen in (n, None)]
    return rows + [np.array([(zero + evaluate(f.get(q, "0"), names)).value for q in system.coordinates]) for f in forms]


def _strays(text: str, system: System, rng: random.Random, chosen: str | None = None) -> bool:
    """Whether the gradient of a function is no combination of the constraints, where they hold and it is real."""
    for _ in range(10):
        at = _point(system, rng)
        if at is None:
            return False
        names = dict(zip(system.coordinates, variables(at, 1), strict=True))
        gradient = (names[system.coordinates[0]] * 0 + evaluate(text, names)).gradient
        if np.isfinite(gradient).all():
            break
    matrix = np.array(_rows(system, names, chosen)).T
    rest = gradient - matrix @ np.linalg.lstsq(matrix, gradient, rcond=1e-9)[0]
    return not np.abs(rest).max() < 1e-6 * (1 + np.abs(gradient).max())


def _integral(system: System, c: dict[str, Any], rng: random.Random) -> list[Finding]:
    """The differential of a stated integral must be a multiple of the form, where the geometric constraints hold."""
    if _strays(c["integral"], system, rng, c["name"]):
        return [
            Finding(
                "integral", f"{c['name']}: {c['integral']} is constant", "its differential is no multiple of the form"
            )
        ]
    return []


def _hidden(system: System, hidden: list[str], integrable: int, rng: random.Random) -> list[Finding]:
    """A stated hidden relation must be constant along every admissible motion."""
    for text in hidden:
        if _strays(text, system, rng):
            return [
                Finding("hidden relation", f"{text} is constant", "its gradient is no combination of the constraints")
            ]
    return [] if len(hidden) <= integrable else [Finding("hidden relation", str(hidden), f"at most {integrable}")]
