"""YAML to a Problem, with every mistake reported at its place."""
