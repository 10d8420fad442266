"""Is it zero? What is the rank? Decided at random points of a prime field, on the constraint surface."""
