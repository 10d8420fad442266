"""The tests, laid out as the packages of `lagrange` are: `tests/algebra/exact/test_points.py` is about `lagrange/algebra/exact/points.py`.

Beside the packages:

    truth/      second routes on all systems: books, SymPy's methods, laws, mutations
    problems/   the shipped library
    docs/       every page of the documentation is true
    command/    `lagsolve`, in this process and as a process
    golden/     what is printed, letter by letter
    bench/      measurements; no test depends on them
    support/    what tests share; nothing else imports it

`conftest.py` says which tests `make test` runs, and which only `make test-all`.
"""
