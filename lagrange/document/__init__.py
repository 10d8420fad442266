"""A derivation as data (steps, prose, equations, pictures), and how its mathematics is written in each style."""
