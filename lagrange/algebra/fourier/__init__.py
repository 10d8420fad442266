"""The ring of Fourier sums, in which equations come out tidy, and the form in which textbooks print them."""
