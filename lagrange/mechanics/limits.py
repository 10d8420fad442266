"""The work allowed for one problem, in units of `core.effort`."""

UNITS_OF_SOLVING = 500_000
"""About twenty seconds."""
