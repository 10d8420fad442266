"""Contact of bodies: the points that touch, and their displacements."""
