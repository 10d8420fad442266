"""Renderers: one file a format, all of them reading the same derivation."""
