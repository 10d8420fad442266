"""The work allowed for one problem, in units of `core.effort`."""

UNITS_OF_SOLVING = 800_000
"""About twenty seconds; 32 links of a chain take most of it, a shipped problem less than a twentieth."""

UNITS_OF_REST = 15_000
"""Friction at rest: a shipped problem takes 750. Of a wedge with three rough faces only impending motion is found."""
