"""Linear equations about a given motion, in numbers, of systems whose equations nobody would write down."""
