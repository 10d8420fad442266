"""Systems too large for symbols, such as a bicycle: equations in numbers about a given motion, or in abbreviations."""
