"""Questions about the motion: a quantity at a state, or as a function of a coordinate or of time."""
