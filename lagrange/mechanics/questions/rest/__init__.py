"""Questions about a system at rest, the ranges of coordinates, and why a question has no answer."""
