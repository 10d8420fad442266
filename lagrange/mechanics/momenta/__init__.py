"""What is formed with the generalized momenta: Hamilton's function and equations, Routh's function."""
