"""`python -m lagsolve`."""

from lagsolve.main import main

main(prog_name="lagsolve")
