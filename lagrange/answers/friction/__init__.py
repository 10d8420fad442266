"""Answers about friction at rest and at its limit."""
