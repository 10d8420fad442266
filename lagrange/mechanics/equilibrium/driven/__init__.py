"""Forced oscillations: harmonic drives, the linear equations under them, the steady state."""
