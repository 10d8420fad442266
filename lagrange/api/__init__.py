"""The interface for Python programs and notebooks, re-exported by `import lagrange`."""
