"""Diagnosis by models: an answer as the equations of motion of a slightly different problem."""
