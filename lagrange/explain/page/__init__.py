"""The page that is printed by default: the result, then the shortest way to it, what it means, and the checks."""
