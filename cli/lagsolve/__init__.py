"""The command `lagsolve`."""
