"""Systems of any size, as problem files: pendulums of n links by angles and by distances, masses and springs."""

from __future__ import annotations

from collections.abc import Callable, Iterable


def links(n: int) -> str:
    """A chain of n links with masses at their ends, in the plane, by n angles from the vertical; y points down."""
    angles = [f"theta{k}" for k in range(1, n + 1)]
    sums = _positions(angles)
    lines = [*_heading(f"Chain of {n} links", n), f"coordinates: [{', '.join(angles)}]", "particles:"]
    lines += [f"  P{k}: {{mass: m{k}, position: '[{x}, {y}]'}}" for k, (x, y) in enumerate(sums, 1)]
    return _text([*lines, "gravity: g*j"])


def rods(n: int) -> str:
    """The same in 2n Cartesian coordinates with n distance constraints, and the angles as a choice of coordinates."""
    names = [f"theta{k}" for k in range(1, n + 1)]
    lines = [*_heading(f"Chain of {n} rods", n), *_free_particles(n), "constraints:", "  rod1: x1^2 + y1^2 = l1^2"]
    lines += [*_distances(n), "generalized_coordinates:", "  angles:", f"    coordinates: [{', '.join(names)}]"]
    lines.append("    substitute:")
    lines += [f"      {c}{k}: {s}" for k, xy in enumerate(_positions(names), 1) for c, s in zip("xy", xy, strict=True)]
    return _text([*lines, "gravity: g*j"])


def necklace(n: int) -> str:
    """n free particles in the plane, in 2n dependent coordinates, with n - 1 distances kept; no choice is given."""
    lines = [*_heading(f"Necklace of {n} particles", n, first=2), *_free_particles(n), "constraints:", *_distances(n)]
    return _text([*lines, "gravity: g*j"])


def springs(n: int) -> str:
    """n masses on a line between two walls, with n + 1 springs; the coordinates are displacements."""
    lines = [f"title: {n} masses and {n + 1} springs", "axes: {i: right}"]
    lines.append(f"parameters: [{', '.join([*_numbered('m', n), *_numbered('k', n + 1), 'a'])}]")
    lines += [f"coordinates: [{', '.join(_numbered('x', n))}]", "particles:"]
    lines += [f"  P{k}: {{mass: m{k}, position: ({k}*a + x{k})*i}}" for k in range(1, n + 1)]
    ends = ["0*i", *_numbered("P", n), f"{n + 1}*a*i"]
    lines.append("forces:")
    lines += [f"  spring{k}: {{spring: k{k}, between: [{ends[k - 1]}, {ends[k]}], length: a}}" for k in range(1, n + 2)]
    return _text(lines)


FAMILIES: dict[str, Callable[[int], str]] = {
    "links": links,
    "springs": springs,
    "necklace": necklace,
    "rods": rods,
}


def _heading(title: str, n: int, first: int = 1) -> list[str]:
    """With n masses, and the lengths from the first on."""
    parameters = [*_numbered("m", n), *_numbered("l", n)[first - 1 :], "g"]
    return [f"title: {title}", "axes: {i: right, j: down}", f"parameters: [{', '.join(parameters)}]"]


def _free_particles(n: int) -> list[str]:
    particles = [f"  P{k}: {{mass: m{k}, position: x{k}*i + y{k}*j}}" for k in range(1, n + 1)]
    return [f"coordinates: [{', '.join(f'x{k}, y{k}' for k in range(1, n + 1))}]", "particles:", *particles]


def _distances(n: int) -> list[str]:
    """Those of each particle from the one before."""
    return [f"  rod{k}: (x{k} - x{k - 1})^2 + (y{k} - y{k - 1})^2 = l{k}^2" for k in range(2, n + 1)]


def _numbered(letter: str, n: int) -> list[str]:
    return [f"{letter}{k}" for k in range(1, n + 1)]


def _positions(angles: list[str]) -> list[tuple[str, str]]:
    """x and y of the ends of the links."""
    found = []
    for k in range(1, len(angles) + 1):
        x, y = (" + ".join(f"l{j}*{f}({a})" for j, a in enumerate(angles[:k], 1)) for f in ("sin", "cos"))
        found.append((x, y))
    return found


def _text(lines: Iterable[str]) -> str:
    return "\n".join([*lines, ""])
