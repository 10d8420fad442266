"""The vocabulary that everything shares: records, diagnostics, symbols, vectors. Imports SymPy only."""
