"""Equilibria searched for in numbers, to see whether a list in closed form lacks any."""
