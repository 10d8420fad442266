"""Pictures of the system and its free bodies, in floating point, drawn from the solution alone."""
