"""The prose of equilibria, their stability, and small oscillations about them."""
