"""Variants of a problem: `vary:`, the values that a seed draws, and the file with these values in it."""
