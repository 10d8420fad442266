"""Formats of teaching platforms: results, tables of marks, questions, starter files."""
