"""Numbers with units: dimensions of expressions, results in numbers, roots enclosed in intervals."""
