"""Other notations written as that of the language: LaTeX commands, programs, macros, matrices, marked up texts."""
