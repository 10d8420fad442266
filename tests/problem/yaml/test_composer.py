"""Traps of YAML: line ends, marks, types that are guessed, quotes, aliases."""

from __future__ import annotations

from pathlib import Path

import pytest
import sympy as sp

from lagrange.core.diagnostics import ProblemError
from lagrange.core.vectors import Vector
from lagrange.problem.limits import MAX_BYTES
from lagrange.problem.loader import load, read_problem
from lagrange.problem.sources import decode
from tests.support.problem_texts import ALL, HEAD, mistakes, places, read

x, y, theta = (sp.Symbol(n, real=True) for n in ("x", "y", "theta"))
m, l, g, k, c, F, R, mu, A, C, I_G = sp.symbols("m l g k c F R mu A C I_G", positive=True)


def vector(*components: sp.Expr | int) -> Vector:
    p, q, r = (sp.sympify(e) for e in components)
    return Vector((p, q, r))


def test_line_ends_and_byte_order_marks() -> None:
    for text in (ALL, ALL.replace("\n", "\r\n"), ALL.replace("\n", "\r"), "\ufeff" + ALL):
        problem = read_problem(decode(text.encode(), "problem.yaml"))
        assert problem.constraints[0].function == x**2 + y**2 - l**2


def test_a_column_is_that_of_the_file_with_a_byte_order_mark(tmp_path: Path) -> None:
    path = tmp_path / "problem.yaml"
    path.write_bytes(b"\xef\xbb\xbftitel: T\r\ncoordinates: [x]\r\nlet: {a: q}\r\n")
    with pytest.raises(ProblemError) as caught:
        load(path)
    spans = [d.span for d in caught.value.diagnostics]
    assert [s.source.position(s.start) for s in spans if s] == [(1, 1), (3, 10)]


def laughs() -> str:
    lines = ["a0: &a0 [" + ",".join("x" * 9) + "]"]
    lines += [f"a{n}: &a{n} [{','.join([f'*a{n - 1}'] * 9)}]" for n in range(1, 10)]
    return "\n".join(lines)


YAML: dict[str, tuple[str | bytes, list[tuple[str, int, int]]]] = {
    "empty": ("", [("empty-file", 0, 0)]),
    "blank": ("  \n\n", [("empty-file", 0, 0)]),
    "comments": ("# nothing\n", [("empty-file", 0, 0)]),
    "document start": ("---\n", [("empty-file", 0, 0)]),
    "a word": ("pendulum\n", [("not-a-mapping", 1, 1)]),
    "a list": ("- a\n- b\n", [("not-a-mapping", 1, 1)]),
    "null": ("null\n", [("not-a-mapping", 1, 1)]),
    "no spaces": ("title:T\ncoordinates:[x]\n", [("not-a-mapping", 1, 1)]),
    "empty mapping": ("{}\n", [("missing-key", 1, 1), ("missing-key", 1, 1)]),
    "UTF-16": (HEAD.encode("utf-16"), [("not-text", 0, 0)]),
    "UTF-16 without mark": (HEAD.encode("utf-16-le"), [("control-character", 1, 2)]),
    "Latin 1": ("title: \xe9\ncoordinates: [x]\n".encode("latin-1"), [("not-text", 0, 0)]),
    "binary": (b"\x00\x01PK", [("control-character", 1, 1)]),
    "control": (b"title: T\ncoordinates: [x\x07]\n", [("control-character", 2, 16)]),
    "NUL": (b"title: T\x00\n", [("control-character", 1, 9)]),
    "too large": (b"#" * (MAX_BYTES + 1), [("file-too-large", 0, 0)]),
    "not too large": (b"#" * MAX_BYTES, [("empty-file", 0, 0)]),
    "tab": ("title: T\n\tcoordinates: [x]\n", [("not-yaml", 2, 1)]),
    "open bracket": ("title: T\ncoordinates: [x\n", [("not-yaml", 2, 14)]),
    "extra bracket": ("title: T\ncoordinates: [x]]\n", [("not-yaml", 2, 17)]),
    "extra brace": ("title: T\ncoordinates: {x: }}\n", [("not-yaml", 2, 19)]),
    "behind a list": (HEAD + "constraints:\n  a: [x, y] = [1, 2]\n", [("not-yaml", 5, 13)]),
    "open quote": ("title: 'T\ncoordinates: [x]\n", [("not-yaml", 1, 8)]),
    "indented": ("title: T\n coordinates: [x]\n", [("not-yaml", 2, 2)]),
    "two colons": ("title: T: U\ncoordinates: [x]\n", [("not-yaml", 1, 9)]),
    "at sign": ("title: @T\ncoordinates: [x]\n", [("not-yaml", 1, 8)]),
    "LaTeX in double quotes": (HEAD + 'let: {a: "\\dot x"}\n', [("not-yaml", 4, 11)]),
    "theta in double quotes": (HEAD + 'let: {a: "\\theta"}\n', [("escaped-latex", 4, 11)]),
    "deep lists": ("title: T\nlet: " + "[" * 30 + "]" * 30, [("nested-too-deep", 2, 25)]),
    "very deep lists": ("[" * 100_000, [("nested-too-deep", 1, 21)]),
    "very deep braces": ("{" * 3_000, [("nested-too-deep", 1, 21)]),
    "very deep dashes": ("- " * 100_000, [("nested-too-deep", 1, 41)]),
    "very deep mappings": ("{a: " * 20_000, [("nested-too-deep", 1, 78)]),
    "many values": (HEAD + "find: [" + "x," * 20_001 + "x]", [("too-many-values", 4, 39962)]),
    "billion laughs": (laughs(), [("too-many-values", 5, 14)]),
    "many aliases": (HEAD + "find: [&a motion" + ", *a" * 51 + "]", [("too-many-aliases", 4, 219)]),
    "alias of itself": (HEAD + "let: {a: &a [*a, x]}\n", [("unknown-alias", 4, 14)]),
    "star": (HEAD + "gravity: *g\n", [("unknown-alias", 4, 10)]),
    "tag": ("title: !!python/object/apply:os.system [id]\ncoordinates: [x]\n", [("tag", 1, 8), ("wrong-kind", 1, 8)]),
    "own tag": (HEAD + "let: {a: !x y}\n", [("tag", 4, 10)]),
    "merge": (HEAD + "<<: {a: b}\n", [("merge-key", 4, 1)]),
    "two documents": ("title: T\ncoordinates: [x]\n---\ntitle: U\n", [("several-documents", 3, 1)]),
    "list as a key": (HEAD + "? [a]\n: b\n", [("key-not-a-name", 4, 3)]),
    "duplicate section": (HEAD + "title: U\n", [("duplicate-key", 4, 1)]),
    "duplicate parameter": (
        "title: T\ncoordinates: [x]\nparameters: {m: real, m: real}\n",
        [("duplicate-key", 3, 23)],
    ),
    "duplicate mass": (HEAD + "particles: {P: {mass: m, mass: m, position: 0}}\n", [("duplicate-key", 4, 26)]),
    "split": (HEAD + "let: {a: [x, atan2(y, x)]}\n", [("split-at-comma", 4, 14)]),
    "split in a mapping": (HEAD + "constraints: {a: x = atan2(y, x), b: y = 0}\n", [("split-at-comma", 4, 18)]),
    "split twice": (
        HEAD + "let: {a: [atan2(y, x), 1, atan2(x, y)]}\n",
        [("split-at-comma", 4, 11), ("split-at-comma", 4, 27)],
    ),
    "no space": (HEAD + "constraints: {a:x = 0}\n", [("missing-space", 4, 16)]),
}


@pytest.mark.parametrize("what", YAML)
def test_trap(what: str) -> None:
    text, expected = YAML[what]
    assert places(text) == expected


def test_a_split_list_in_quotes_is_whole() -> None:
    problem = read(HEAD + 'let:\n  a: [x, "atan2(y, x)"]\n  b: "[x, atan2(y, x)]"\n  c1: cross(i, j)\n')
    assert problem.scope.vectors["a"] == problem.scope.vectors["b"] == vector(x, sp.atan2(y, x), 0)
    assert 'put it in quotes: `"atan2(y, x)"`' in mistakes(YAML["split"][0])[0].help


def test_an_alias_repeats_a_value() -> None:
    problem = read(HEAD + "particles: {P: &P {mass: m, position: x*i}, Q: *P}\n")
    assert problem.particles[0].position == problem.particles[1].position == vector(x, 0, 0)


@pytest.mark.parametrize(
    ("text", "written"),
    [
        ('a: "sin(theta) + q"', "q"),
        ("a: 'sin(theta) + q'", "q"),
        ("a: >\n    sin(theta)\n    + q", "q"),
        ("a: |\n    sin(theta)\n    + q", "q"),
        ("a: sin(theta)\n    + q", "q"),
        ("a: '(theta'')'' + q'", "q"),
        ('a: "\\u03b8 + q"', "q"),
        ("a: θ̈ + q", "q"),
        ("a: &here theta + q", "q"),
    ],
)
def test_a_place_in_any_style_of_yaml(text: str, written: str) -> None:
    (found,) = mistakes(f"{HEAD}let:\n  {text}\n")
    assert found.span is not None
    assert found.span.source.text[found.span.start : found.span.end] == written
