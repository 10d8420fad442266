"""Somebody else's equations compared with the derived ones: verdict and diagnosis."""
