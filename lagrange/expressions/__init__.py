"""Text and LaTeX to SymPy: declared names only, and nothing is ever run as code."""
