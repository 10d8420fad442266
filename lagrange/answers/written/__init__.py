"""Answers as people write them: their lines, notations and definitions, before anything is compared."""
