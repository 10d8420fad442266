"""Equal forms of what was derived, as a page writes them: shorter, in other variables, in vectors."""
