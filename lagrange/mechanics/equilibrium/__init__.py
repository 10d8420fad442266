"""The principle of virtual work: equilibria, their stability, reactions at rest, small oscillations."""
