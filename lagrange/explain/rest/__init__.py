"""The words of equilibria, their stability, and small oscillations about them."""
