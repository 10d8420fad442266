"""Analytical mechanics step by step: constraints, virtual displacements, d'Alembert's principle."""
