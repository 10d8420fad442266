"""A derivation printed in every format: renderers select, number and break lines; they never compute."""
