"""The prose on contact: one-sided constraints, and friction at rest."""
