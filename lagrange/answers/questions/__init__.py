"""Answers to the questions of a file."""
