"""Answers compared with the derived results: verdict and diagnosis."""
