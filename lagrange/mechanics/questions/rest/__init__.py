"""Questions about positions: a system at rest, and the ranges that coordinates have."""
