"""Motions that need something of their own: orbits, systems whose equations fill pages."""
