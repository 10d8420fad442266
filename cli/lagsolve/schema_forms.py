"""What a JSON Schema is made of: mappings with known keys, names, words, lists, and parts that are defined once."""

from __future__ import annotations

from typing import Any

Schema = dict[str, Any]

_SIGNS = r"""=+*/^()\[\]{}<>|,;:!?#$%&~"`'\\.\-"""
NAME = f"^[^0-9{_SIGNS}][^{_SIGNS}]*$"
ARGUMENT = f"^[^0-9{_SIGNS}][^{_SIGNS}]*['′’]?$"
WORDS_OF_YAML = ["boolean", "null"]
"""What YAML may take a name for: `true`, `null`."""
_EXPLAINED = {"patternErrorMessage": "A name begins with a letter and has letters, digits and _."}
"""No word of the standard: some editors show it in place of the pattern."""


def part(name: str) -> Schema:
    """A part that is defined once, by its name."""
    return {"$ref": f"#/$defs/{name}"}


def said(description: str, schema: Schema) -> Schema:
    """A schema with a description of its own. (Before draft 2019-09 nothing may stand beside a `$ref`.)"""
    return {"description": description, **({"allOf": [schema]} if "$ref" in schema else schema)}


def keyed(title: str, properties: dict[str, Schema], required: tuple[str, ...] = ()) -> Schema:
    """A mapping with known keys; an editor offers it under its title."""
    found: Schema = {"title": title, "type": "object", "properties": properties, "additionalProperties": False}
    return {**found, "required": list(required)} if required else found


def mapping(values: Schema) -> Schema:
    """A mapping with any keys."""
    return {"type": "object", "additionalProperties": values}


def named(values: Schema) -> Schema:
    """A mapping whose keys are names."""
    return {**mapping(values), "propertyNames": {"pattern": NAME, **_EXPLAINED}}


def name(pattern: str) -> Schema:
    """A name of this pattern. What YAML takes for a word of its own is not held to it."""
    return {"type": ["string", *WORDS_OF_YAML], "pattern": pattern, **_EXPLAINED}


def names() -> Schema:
    """A list of names."""
    return {"type": "array", "items": part("name")}


def one_of(words: tuple[str, ...]) -> Schema:
    """One of several words."""
    return {"enum": list(words)}


def one_or_list(schema: Schema) -> Schema:
    """One, or a list of them."""
    return {"anyOf": [schema, {"type": "array", "items": schema}]}


def three(schema: Schema) -> Schema:
    """A list of three."""
    return {"type": "array", "minItems": 3, "maxItems": 3, "items": schema}


def emptiable(*schemas: Schema) -> Schema:
    """A section that may be left empty, as one whose entries are all commented out is."""
    return {"anyOf": [*schemas, {"type": "null"}]}
