"""The work allowed for one problem, in units of `core.effort`."""

UNITS_OF_SOLVING = 800_000
"""About twenty seconds; 32 links of a chain take most of it, a shipped problem less than a twentieth."""

UNITS_OF_REST = 100_000
"""Friction at rest: two contacts take 15,000. Of a wedge with three rough faces only impending motion is found."""
