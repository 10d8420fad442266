"""Equations of an answer that hold in a case: for one sense of the motion, or for particular values."""
