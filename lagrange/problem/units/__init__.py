"""Dimensions of what a problem file states."""
