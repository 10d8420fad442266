"""Shorter ways of saying what a page says: whole sections in a few lines where nothing is to be learned from them."""
