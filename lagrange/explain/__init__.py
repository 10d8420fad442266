"""The words of a derivation: one file a part of it, all the English in one place.

Each function takes what a stage has found and returns the step that explains it. Nothing is computed here: what a step
shows is a field of a result.
"""
