"""Claims beside equations: stability, frequencies, conditions under which something happens, degrees of freedom."""
