"""What follows from the equations of motion by an argument of a few lines: constant vectors, limits, resonances."""
