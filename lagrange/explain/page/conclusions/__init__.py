"""The paragraphs of what a result says: limits, positions of rest, how the motion goes on, other forms."""
