"""Pictures of a solution: the system in a general position, and its free bodies. A picture that would be wrong is None."""
