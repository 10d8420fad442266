"""Pictures of a solution: the system in a general position, its free bodies. What would be wrong is left out."""
