"""What a file does not say of its figure and the problem implies."""
