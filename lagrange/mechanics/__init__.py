"""The stages of a derivation, in the order of the chapter; `solution.solve` runs them."""
