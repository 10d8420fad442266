"""Derivations for notebooks, notes and lessons, composed of the formats of `render`."""
