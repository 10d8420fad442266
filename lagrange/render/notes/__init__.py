"""Derivations for notebooks, notes and lessons: what the formats of `render` are put together to."""
