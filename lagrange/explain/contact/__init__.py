"""The words on contact: one-sided constraints, and friction at rest."""
