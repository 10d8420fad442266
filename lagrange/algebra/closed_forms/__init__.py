"""Equations solved in closed form: all branches, each with its conditions."""
