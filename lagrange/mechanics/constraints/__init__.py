"""Kinematics, constraints one by one and together, virtual displacements, generalized coordinates."""
