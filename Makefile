# Two targets are enough: `make demo` and `make test`; both make .venv first.
VENV := .venv
BIN := $(VENV)/bin
NEW_ENOUGH := -c 'import sys; sys.exit(sys.version_info < (3, 11))'

# The first Python that is new enough, unless `make PYTHON=...` says which.
PYTHON ?= $(shell for p in python3 python3.14 python3.13 python3.12 python3.11 python; do \
	$$p $(NEW_ENOUGH) 2>/dev/null && echo $$p && break; done)

# Where it is set, every child process of the tests would compile all modules again.
unexport PYTHONDONTWRITEBYTECODE

.PHONY: demo test test-all part-of-tests all-tests lint sweep bench golden picture figures gallery site lock man clean

$(VENV)/made: pyproject.toml
	@if [ -z "$(PYTHON)" ]; then \
		echo "lagsolve needs Python 3.11 or later; here there is: $$(python3 --version 2>&1 || true)"; \
		echo "Install a newer one, or say where it is: make PYTHON=/path/to/python3.12"; exit 1; fi
	@$(PYTHON) $(NEW_ENOUGH) || \
		{ echo "lagsolve needs Python 3.11 or later, and $(PYTHON) is $$($(PYTHON) --version 2>&1)"; exit 1; }
	@$(PYTHON) -m venv $(VENV) || \
		{ echo "$(PYTHON) cannot make an environment; on Debian: apt install python3-venv"; exit 1; }
	@touch $@

# What is imported is compiled when it is imported first: most modules of the packages never are.
INSTALL := $(BIN)/python -m pip install --quiet --disable-pip-version-check --no-compile --editable

$(VENV)/python: $(VENV)/made
	@echo "installing into $(VENV), which takes some seconds"
	@$(INSTALL) .
	@touch $@

# With what the tests need.
$(VENV)/installed: $(VENV)/made
	@echo "installing what the tests need into $(VENV), which takes a minute or two"
	@$(INSTALL) '.[dev]'
	@touch $(VENV)/python $@

demo: $(VENV)/python
	@$(BIN)/lagsolve problems/chapter6/ex11-ideal-pendulum.yaml
	@echo
	@echo "What to do next:"
	@echo "  $(BIN)/lagsolve new mine.yaml       a problem of your own, every key explained; then $(BIN)/lagsolve mine.yaml"
	@echo "  $(BIN)/lagsolve list                more problems to look at; $(BIN)/lagsolve ex18 -o page.html makes a web page"
	@echo "  $(BIN)/lagsolve check ex11 -e \"l theta'' - g sin theta = 0\""
	@echo "                                      what is wrong with these equations?"
	@echo "README.md goes on from there."

# The slow tests that `make test` runs: a fortieth of them, another one every day; `make test PART=3` says which, and
# `make test PART=1 PARTS=4`, as in .ci/run, takes a quarter of them and of the shipped problems.
PART ?= today
PARTS ?= 40
PYTEST = $(BIN)/python -m pytest --numprocesses auto --dist loadgroup
# mypy uses one processor for half a minute, and the tests all of them: they run at the same time.
BESIDE = @$(MAKE) --no-print-directory --jobs=2 lint

test: $(VENV)/installed
	$(BESIDE) part-of-tests

# All tests.
test-all: $(VENV)/installed
	$(BESIDE) all-tests

part-of-tests: $(VENV)/installed
	$(PYTEST) --part $(PART) --parts $(PARTS)

all-tests: $(VENV)/installed
	$(PYTEST)

lint: $(VENV)/installed
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy

# Of the tests those of every shipped problem in every format; pdflatex, pandoc and chromium are used where they are installed.
sweep: $(VENV)/installed
	$(PYTEST) tests/problems/test_every_format.py

# Renews the golden files. Read the difference before you commit it.
golden: $(VENV)/installed
	$(BIN)/python -m pytest tests/golden --renew

# Draws the picture of the README anew: what the program prints today.
picture: $(VENV)/installed
	$(BIN)/python -m tests.support.picture

# A sheet of all figures, to be looked through before a release: figures.html, and photographs of it in figures/.
figures: $(VENV)/installed
	$(BIN)/python -m tests.support.figure_sheet --out figures.html --png figures

# A static site of all shipped problems in gallery/, for any web server: index with figures and search, a page for each.
gallery: $(VENV)/installed
	@$(BIN)/python -m lagsolve.gallery gallery

# The documentation and the reference of `import lagrange` as a site with a search, in site/. MkDocs comes with the extra `docs`.
site: $(VENV)/installed
	@$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable '.[docs]'
	@PYTHONPATH=. $(BIN)/python -m mkdocs build --strict --quiet

# The versions that a release was tried with, and what their files must be: pip install --require-hashes -r requirements.lock
lock:
	@uv pip compile pyproject.toml --extra sim --universal --python-version 3.11 --generate-hashes \
		--custom-compile-command "make lock" --output-file requirements.lock --quiet

# The manual page lagsolve.1, from the help of the command.
man: $(VENV)/installed
	@$(BIN)/python -m lagsolve.man_page > lagsolve.1

# Seconds that every shipped problem takes, and chains of 2 to 16 links, and how long other things take, and against what;
# no test depends on it.
bench: $(VENV)/installed
	for script in tests/bench/*.py; do $(BIN)/python $$script || exit 1; done

clean:
	rm -rf $(VENV) build dist .pytest_cache .mypy_cache .ruff_cache .hypothesis tests/actual
	find . -name __pycache__ -prune -exec rm -rf {} +
