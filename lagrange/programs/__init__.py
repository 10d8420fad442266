"""The equations of motion as programs: first-order equations, source text in several languages, simulations."""
