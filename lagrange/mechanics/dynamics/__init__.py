"""Newton, d'Alembert, Lagrange: equations of motion, reactions, friction, conserved quantities."""
