"""Sections of the full derivation in fewer lines, where a reader would learn nothing from the others."""
