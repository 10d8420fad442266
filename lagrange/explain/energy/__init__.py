"""The prose of the energies: T and V, Lagrange's and Hamilton's equations, conserved quantities."""
