"""The work allowed for one problem, in units of `core.effort`."""

UNITS_OF_SOLVING = 800_000
"""About twenty seconds; 32 links of a chain take most of it, a shipped problem less than a twentieth."""
