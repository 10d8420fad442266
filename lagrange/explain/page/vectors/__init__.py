"""Pages on which everything is written in vectors: a particle on any surface, two particles joined by a rod."""
