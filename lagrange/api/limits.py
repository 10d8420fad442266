"""Limits of what a Python program gets."""

LONGEST_FEEDBACK = 20_000
"""Characters: four pages, and few enough for the results of a platform."""

SMALLEST_PIVOT = 1e-14
"""A smaller pivot counts as zero, if the largest entry of each row is 1: fifty rounding errors of 2e-16."""
