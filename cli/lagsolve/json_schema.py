"""A JSON Schema (draft 2020-12) of problem files, for editors, made from the declarations in `lagrange.problem.keys`.

The reader decides; the schema is never stricter. Every value is text to the reader, so whatever an editor's YAML takes
for a number, a truth value or nothing (`null` may be a name) is allowed wherever text may be. What an expression may
contain is left to lagsolve: an editor learns the keys, their values where these are words, and what is a list. Nothing
beyond draft 7 is used, for editors that know no more.
"""

from __future__ import annotations

import re
from typing import Any

from lagrange.core.unit_names import names_of_units
from lagrange.problem.keys import (
    BODY,
    FRAME,
    FRAME_COORDINATES,
    PARTS,
    PROBLEM,
    WAYS_OF_TURNING,
    FrameType,
)
from lagrange.problem.yaml.kinds import AnyOf, Keys, Kind, ListOf, Named, OneOf

Schema = dict[str, Any]

_SIGNS = r"""=+*/^()\[\]{}<>|,;:!?#$%&~"`'\\.\-"""
_NAME = f"^[^0-9{_SIGNS}][^{_SIGNS}]*$"
_ARGUMENT = f"^[^0-9{_SIGNS}][^{_SIGNS}]*['′’]?$"
_UNIT = f"(({'|'.join(sorted(map(re.escape, names_of_units())))})\\s*($|[*/·⋅^()⁰¹²³⁴⁵⁶⁷⁸⁹⁻])|[(])"
"""How the name of a unit begins a text: an editor still shows a misspelt assumption."""
_WORDS_OF_YAML = ["boolean", "null"]
"""What YAML may take a name for: `true`, `null`."""
_READ_AS: dict[str, Any] = {"true": True, "false": False}
"""What YAML may take a word for, beside integers."""
_EXPLAINED = {"patternErrorMessage": "A name begins with a letter and has letters, digits and _."}
"""Not a keyword of the standard: some editors show it instead of the pattern."""

_SHARED: dict[str, Schema] = {
    "text": {"type": ["string", "number", *_WORDS_OF_YAML]},
    "name": {"type": ["string", *_WORDS_OF_YAML], "pattern": _NAME, **_EXPLAINED},
    "argument": {"type": ["string", *_WORDS_OF_YAML], "pattern": _ARGUMENT, **_EXPLAINED},
    "expression": {"type": ["string", "number", *_WORDS_OF_YAML]},
    "equation": {"type": "string"},
}
"""The primitive kinds that are defined once and referred to."""

_INLINE: dict[str, Schema] = {
    "number": {
        "anyOf": [{"type": "integer", "minimum": 0, "maximum": 9999}, {"type": "string", "pattern": "^[0-9]{1,4}$"}]
    },
    "decimal": {
        "anyOf": [
            {"type": "number", "exclusiveMinimum": 0, "exclusiveMaximum": 10000},
            {"type": "string", "pattern": r"^[0-9]{1,4}(\.[0-9]{1,2})?$"},
        ]
    },
    "quantity": {"anyOf": [{"type": "number"}, {"type": "string", "pattern": rf"^\s*([-+−]?\s*\.?[0-9]|{_UNIT})"}]},
    "nothing": {"type": "null"},
}

_DESCRIPTIONS = {"vector": "One expression, or a list of two or three components."}


def problem_schema() -> Schema:
    """The schema of a problem file."""
    root = {**_form(PROBLEM), "title": PROBLEM.title.capitalize()}
    parts = {name: _described(_DESCRIPTIONS.get(name), schema_of(kind)) for name, kind in PARTS.items()}
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "description": "A mechanical system: coordinates, constraints, forces, and what is asked of it.",
        **root,
        "$defs": {**_SHARED, **parts},
    }


def schema_of(kind: Kind) -> Schema:
    """The schema of a value of a kind."""
    match kind:
        case str():
            return _INLINE.get(kind, {"$ref": f"#/$defs/{kind}"})
        case OneOf(words=words):
            return {"enum": [value for word in words for value in _as_yaml_reads(word)]}
        case ListOf(item=item, least=least, most=most):
            bounds = ({"minItems": least} if least else {}) | ({"maxItems": most} if most is not None else {})
            return {"type": "array", **bounds, "items": schema_of(item)}
        case Named(value=value, new=new):
            spelled = {"propertyNames": {"pattern": _NAME, **_EXPLAINED}} if new else {}
            return {"type": "object", "additionalProperties": schema_of(value), **spelled}
        case AnyOf(kinds=kinds):
            return {"anyOf": [schema_of(k) for k in kinds]}
        case Keys():
            return _form(kind) | _conditions(kind)


def _as_yaml_reads(word: str) -> list[Any]:
    """A word, and what YAML may take it for: `313` for a number, `true` for a truth value."""
    if word.isdigit():
        return [word, int(word)]
    return [word, _READ_AS[word]] if word in _READ_AS else [word]


def _form(form: Keys) -> Schema:
    """A mapping with known keys; an editor offers it under its title."""
    properties = {key.name: _described(key.meaning, schema_of(key.kind)) for key in form.keys}
    schema: Schema = {
        "title": form.title, "type": "object", "properties": properties, "additionalProperties": False,
    }  # fmt: skip
    return {**schema, "required": list(form.required)} if form.required else schema


def _described(description: str | None, schema: Schema) -> Schema:
    """A schema with a description of its own. (Before draft 2019-09 no keyword is allowed beside a `$ref`.)"""
    if description is None:
        return schema
    return {"description": description, **({"allOf": [schema]} if "$ref" in schema else schema)}


def _conditions(form: Keys) -> Schema:
    """What holds between keys: a frame has as many coordinates as its type, a body is turned in one way."""
    if form == FRAME:
        counts = {t: len(names) for t, names in FRAME_COORDINATES.items() if t is not FrameType.CARTESIAN}
        return {"allOf": [_counted(frame_type.value, count) for frame_type, count in counts.items()]}
    if form == BODY:
        turning = [key for way in WAYS_OF_TURNING for key in way]
        return {
            "anyOf": [
                {"required": list(way), "properties": {key: False for key in turning if key not in way}}
                for way in WAYS_OF_TURNING
            ]
        }
    return {}


def _counted(frame_type: str, count: int) -> Schema:
    return {
        "if": {"properties": {"type": {"const": frame_type}}},
        "then": {"required": ["coordinates"], "properties": {"coordinates": {"minItems": count, "maxItems": count}}},
    }
