"""`lagsolve schema`: what it accepts and refuses, against the loader, and its keys and words against those declared.

YAML is read here in both ways in which an editor may read it: with numbers, truth values and nothing (YAML 1.2), and
with every value as text.
"""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Iterator
from typing import Any

import pytest
import yaml
from click.testing import CliRunner
from jsonschema import Draft7Validator, Draft202012Validator

from lagrange.core.diagnostics import ProblemError, Source
from lagrange.problem import coordinate_choices, forces, keys
from lagrange.problem.loader import read_problem
from lagrange.problem.sections import Section
from lagsolve import json_schema
from lagsolve.main import main
from lagsolve.new_file import TEMPLATE
from tests.support.paths import PROBLEMS, ROOT

SCHEMA = json_schema.problem_schema()
CORE = [
    ("null", r"~|null|Null|NULL|"),
    ("bool", r"true|True|TRUE|false|False|FALSE"),
    ("int", r"[-+]?[0-9]+"),
    ("float", r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?"),
]
DOCS = re.findall(r"```yaml\n(.*?)```", (ROOT / "docs" / "problem-files.md").read_text(encoding="utf-8"), re.DOTALL)


class Core(yaml.BaseLoader):
    """YAML 1.2 as editors read it. Keys stay text."""


for _tag, _pattern in CORE:
    Core.add_implicit_resolver(f"tag:yaml.org,2002:{_tag}", re.compile(f"(?:{_pattern})$"), None)


class Text(yaml.BaseLoader):
    """YAML in which every value is text, and an empty value is null."""


Text.add_implicit_resolver("tag:yaml.org,2002:null", re.compile("$"), [""])
Text.add_constructor("tag:yaml.org,2002:null", lambda _l, _n: None)


def _mapping(loader: yaml.BaseLoader, node: yaml.MappingNode) -> dict[str, Any]:
    return {k.value: loader.construct_object(v, deep=True) for k, v in node.value}  # type: ignore[no-untyped-call]


Core.add_constructor("tag:yaml.org,2002:null", lambda _l, _n: None)
Core.add_constructor("tag:yaml.org,2002:bool", lambda _l, n: n.value.lower() == "true")
Core.add_constructor("tag:yaml.org,2002:int", lambda _l, n: int(n.value))
Core.add_constructor("tag:yaml.org,2002:float", lambda _l, n: float(n.value))
Core.add_constructor("tag:yaml.org,2002:map", _mapping)


def faults(text: str, loader: type[yaml.BaseLoader] = Core, draft: type = Draft202012Validator) -> list[str]:
    """What the schema has against a file."""
    document = yaml.load(text, Loader=loader)
    return [f"{error.json_path}: {error.message}" for error in draft(SCHEMA).iter_errors(document)]


def loads(text: str) -> bool:
    try:
        read_problem(Source("problem.yaml", text))
    except ProblemError:
        return False
    return True


def objects(part: Any) -> Iterator[dict[str, Any]]:
    """The objects of the schema whose keys are known."""
    if isinstance(part, dict):
        if part.get("additionalProperties") is False:
            yield part
        for value in part.values():
            yield from objects(value)
    elif isinstance(part, list):
        for value in part:
            yield from objects(value)


# Against the declarations


def test_it_has_the_declared_keys() -> None:
    here = [frozenset(found["properties"]) for found in objects(SCHEMA)]
    assert Counter(here) == Counter(frozenset(form.names) for form in keys.FORMS)
    assert tuple(SCHEMA["properties"]) == keys.PROBLEM.names


def test_the_loader_reads_every_declared_key(monkeypatch: pytest.MonkeyPatch) -> None:
    """What is declared and never asked for would be accepted and ignored."""
    asked: set[tuple[str, str]] = set()
    entry = Section._entry
    monkeypatch.setattr(Section, "_entry", lambda self, key: asked.add((self.form.title, key)) or entry(self, key))
    for text in (TEMPLATE, *DOCS, *GOOD):
        loads(text)
    declared = {(form.title, key) for form in keys.FORMS for key in form.names}
    assert declared - asked == {(keys.AXES.title, axis) for axis in keys.AXES.names}  # read as entries
    assert asked <= declared


def test_it_has_the_declared_words() -> None:
    parts, properties = SCHEMA["$defs"], SCHEMA["properties"]
    assert parts["parameter"]["anyOf"][0]["enum"] == [*keys.Assumption]
    assert properties["find"]["anyOf"][0]["enum"] == [*keys.Find]
    assert parts["frame"]["anyOf"][0]["properties"]["type"]["enum"] == [*keys.FrameType]
    assert len(parts["force"]["anyOf"]) == len(keys.FORCES)
    assert parts["sense"]["enum"] == [*keys.SENSES]
    assert set(forces._READERS) == set(keys.FORCES)
    assert set(coordinate_choices._TRIADS) == set(keys.FrameType) == set(keys.FRAME_COORDINATES)


def test_every_key_is_described() -> None:
    for found in objects(SCHEMA):
        assert found["title"]
        for key, part in found["properties"].items():
            assert re.fullmatch(r"[A-Z].*[.\]}]", part["description"]), key


# Files


@pytest.mark.parametrize("loader", [Core, Text])
def test_it_accepts_the_shipped_files(loader: type[yaml.BaseLoader]) -> None:
    texts = {p.stem: p.read_text(encoding="utf-8") for p in PROBLEMS.glob("*/*.yaml")}
    texts |= {f"example {n}": text for n, text in enumerate((TEMPLATE, *DOCS))}
    assert {name: faults(text, loader) for name, text in texts.items() if faults(text, loader)} == {}


BASE = "title: t\ncoordinates: [x, y]\nparameters: [m, null, true, y0, n]\n"
POINT = BASE + "particles: {P: {mass: m, position: [x, y]}}\n"
BODY = BASE + "bodies: {B: {inertia: %s, position: [x, y], %s}}\n"

GOOD = [
    BASE + "vary: {m: [1 kg, 2], n: {from: 0.2 m, to: 1 m, step: 0.1 m}}\n",
    "title: 42\ncoordinates: {x: 3, y: , z: {meaning: , unit: m}}\n",
    "title: null\ncoordinates: {}\n",
    "title: t\ncoordinates: [n, no, on, θ, x₁, 'x_2']\n",
    "title: t\ncoordinates: [x]\nparameters: {m: , a: real, b: {unit: , value: 2/3}, c: {assume: sign, value: -1}, d: {value: 1e-3}}\n",
    BASE + "particles: {P: {mass: null, position: [1, 0.5]}, Q: {mass: 0, position: '[x, y]'}, n: {mass: true, position: 0*i}}\n",
    BASE + "axes: {i: null, j: 1}\nlet:\nframe:\nparticles:\nbodies:\nconstraints:\nforces:\nspeeds:\nanswers:\nequations:\n",
    BASE + "functions: {u: [t], f: [X, Y], F: [x, x', t]}\nunknowns: [F_1]\nlet: {a: 3, b: [1, x], ' c': 2*x, c_1: [x, y, 1]}\n",
    BASE + "frame: {type: cartesian, coordinates: []}\n",
    BASE + "frame: {type: cartesian}\n",
    BASE.replace("x, y", "r, phi") + "frame: {type: polar, coordinates: [r, phi]}\n",
    BASE + "constraints: {a: x = y, b: {equation: \"x' = 0\", note: , reaction: R}}\nfind: [constraints]\n",
    POINT + "gravity: 0\nfind: []\n",
    POINT + "gravity: [0, 1]\nforces: {a: {potential: 1}, b: {on: P, vector: [1, 0]}, c: {spring: 2, between: [P, [0, 1]], length: 1}}\n",
    POINT + "constraints: {on: x = y}\nforces: {rub: {friction: 0.5, constraint: on, on: P, slip: positive, contact: negative}}\n",
    BODY % ("1", "angle: x"),
    (BODY % ("m", "angle: x")).replace("inertia: m, ", ""),
    BODY % ("[1, 2, 2]", "orientation: {axes: 313, angles: [x, y, 0]}"),
    BODY % ("[1, 2, 2]", "orientation: {axes: '123', angles: [x, y, 0]}"),
    BODY % ("[1, 1, 1]", "axes: [i, j, k], angular_velocity: x'*k"),
    BODY % ("[1, 1, 1]", "axes: [[1, 0], [0, 1], k], angular_velocity: 0"),
    BASE + "generalized_coordinates: {a: {coordinates: [x, y], substitute: {}}, b: {coordinates: [x, q], substitute: {y: q}}}\n",
    BASE + "answers: {degrees_of_freedom: '02', classification: holonomic, equilibrium: [], equations: x'' = 0}\n",
    POINT + "answers: {degrees_of_freedom: 2, classification: [holonomic], equilibrium: [[x = 0], []], frequencies: [1, 2]}\n",
    POINT + "constraints: {a: x = y, b: x' = 0}\nanswers: {integrable: {a: true, b: 'true'}, reactions: {a: 0}, frequencies: 1}\n",
    'title: t\ncoordinates: [x]\nequations: "x\'\' = 0"\nfind: motion\n',
]  # fmt: skip

WRONG = [
    "title: t\n",
    "coordinates: [x]\n",
    "[1, 2]\n",
    "title: [a]\ncoordinates: [x]\n",
    "title: t\ncoordinates: x\n",
    "title: t\ncoordinates: []\n",
    "title: t\ncoordinates: [1]\n",
    "title: t\ncoordinates: [x']\n",
    "title: t\ncoordinates: [x, [y]]\n",
    "title: t\ncoordinates: {x: [a]}\n",
    "title: t\ncoordinates: {x: {means: a}}\n",
    "title: t\ncoordinates: {2x: a}\n",
    "title: t\ncoordinates: [x]\nparametres: [m]\n",
    "title: t\ncoordinates: [x]\nparameters: {m: negative}\n",
    "title: t\ncoordinates: [x]\nparameters: {m: {assume: }}\n",
    "title: t\ncoordinates: [x]\nparameters: {m: [positive]}\n",
    "title: t\ncoordinates: [x]\nparameters: m\n",
    BASE + "axes: {x: right}\n",
    BASE + "axes: right\n",
    BASE + "functions: {u: t}\n",
    BASE + "functions: {u: []}\n",
    BASE + "functions: {u: [x'']}\n",
    BASE + "let: {a: [x]}\n",
    BASE + "let: {a: [x, y, x, y]}\n",
    BASE + "let: {a: {b: c}}\n",
    BASE + "let: {a+b: x}\n",
    BASE + "frame: polar\n",
    BASE + "frame: {type: round}\n",
    BASE + "frame: {type: polar}\n",
    BASE + "frame: {type: spherical, coordinates: [x, y]}\n",
    BASE + "frame: {coordinates: [x, y]}\n",
    BASE + "particles: [P]\n",
    BASE + "particles: {P: }\n",
    BASE + "particles: {P: {mass: m}}\n",
    BASE + "particles: {P: {position: [x]}}\n",
    BASE + "particles: {P: {position: [x, y], colour: red}}\n",
    BODY % ("[m, m]", "angle: x"),
    BODY % ("m", "mass: m"),
    BODY % ("m", "angle: x, axes: [i, j, k]"),
    BODY % ("[m, m, m]", "axes: [i, j, k]"),
    BODY % ("[m, m, m]", "axes: [i, j], angular_velocity: x'*k"),
    BODY % ("[m, m, m]", "orientation: {axes: 331, angles: [x, y, x]}"),
    BODY % ("[m, m, m]", "orientation: {axes: 313, angles: [x, y]}"),
    BODY % ("[m, m, m]", "orientation: {axes: 313}"),
    BASE + "constraints: [x = y]\n",
    BASE + "constraints: {a: [x = y]}\n",
    BASE + "constraints: {a: 3}\n",
    BASE + "constraints: {a: {note: no equation}}\n",
    BASE + "constraints: {a: {equation: x = y, force: R}}\n",
    BASE + "constraints: {a: {equation: x = y, reaction: 2}}\n",
    BASE + "constraints: {a.1: x = y}\n",
    POINT + "gravity: {j: -g}\n",
    POINT + "gravity: [0]\n",
    POINT + "forces: [push]\n",
    POINT + "forces: {push: m*i}\n",
    POINT + "forces: {push: {on: P}}\n",
    POINT + "forces: {push: {vector: m*i}}\n",
    POINT + "forces: {push: {on: P, vector: m*i, moment: m*k}}\n",
    POINT + "forces: {s: {spring: m, between: [P]}}\n",
    POINT + "forces: {s: {spring: m}}\n",
    POINT + "forces: {s: {spring: m, between: [P, 0*i], sense: left}}\n",
    POINT + "forces: {d: {damper: m, between: [P, 0*i], length: m}}\n",
    POINT + "constraints: {a: x = y}\nforces: {f: {friction: m, on: P}}\n",
    POINT + "constraints: {a: x = y}\nforces: {f: {friction: m, on: P, constraint: a, contact: 1}}\n",
    BASE + "unknowns: {F: force}\n",
    BASE + "speeds: [x']\n",
    BASE + "generalized_coordinates: [q]\n",
    BASE + "generalized_coordinates: {a: [x, y]}\n",
    BASE + "generalized_coordinates: {a: {coordinates: []}}\n",
    BASE + "generalized_coordinates: {a: {substitute: {x: q}}}\n",
    BASE + "generalized_coordinates: {a: {coordinates: [x, y], substitute: }}\n",
    BASE + "equations: {a: x = 0}\n",
    POINT + "find: movement\n",
    POINT + "find: [motion, all]\n",
    POINT + "find:\n",
    POINT + "answers: [2]\n",
    POINT + "answers: {dof: 2}\n",
    POINT + "answers: {degrees_of_freedom: two}\n",
    POINT + "answers: {degrees_of_freedom: -1}\n",
    POINT + "answers: {classification: [rigid]}\n",
    POINT + "constraints: {a: x = y}\nanswers: {integrable: {a: yes}}\n",
    POINT + "constraints: {a: x = y}\nanswers: {integrable: [a]}\n",
    POINT + "answers: {equations: {a: x = 0}}\n",
    POINT + "answers: {equilibrium: [x = 0, [y = 0]]}\n",
    POINT + "answers: {frequencies: [m, [m]]}\n",
    POINT + "answers: {reactions: [m]}\n",
]  # fmt: skip


@pytest.mark.parametrize("text", GOOD)
def test_what_both_accept(text: str) -> None:
    assert loads(text)
    assert faults(text) == faults(text, Text) == []


@pytest.mark.parametrize("text", WRONG)
def test_what_both_refuse(text: str) -> None:
    assert not loads(text)
    assert faults(text)


def test_it_is_a_schema_in_both_drafts() -> None:
    Draft202012Validator.check_schema(SCHEMA)
    Draft7Validator.check_schema({k: v for k, v in SCHEMA.items() if k != "$schema"})
    for text in GOOD:
        assert faults(text, draft=Draft7Validator) == []
    for text in WRONG:
        assert faults(text, draft=Draft7Validator)


def test_the_command_prints_it() -> None:
    result = CliRunner().invoke(main, ["schema"])
    assert (result.exit_code, result.stderr) == (0, "")
    assert json.loads(result.stdout) == SCHEMA
