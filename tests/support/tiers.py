"""Which tests `make test` runs a part of: names of folders, files and functions below `tests/`.

The tiers `truth` and `process` are listed here. Of the others those are `slow` whose function takes more than
`LONG` processor seconds, all its parameters together: `slow_tests.txt` has them, as `pytest --renew-slow` measured them
last. Where a single one of its parameters takes no more than `SHORT`, the first is run each time. The seconds also say
which tests several processes begin with (`grouping.py`).
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path

TIERS = {
    "truth": (
        "truth/",
        "algebra/closed_forms/test_eigenmodes.py",
        "mechanics/dynamics/test_conservation.py",
    ),
    "process": (
        "algebra/exact/test_prime_field.py::test_every_process_has_a_prime_of_its_own",
        "animation/test_played.py",
        "api/test_interface.py::test_importing_costs_nothing",
        "command/grading/test_pool.py",
        "command/grading/test_worker.py",
        "command/grading/test_worker_process.py",
        "command/test_command_group.py::test_a_real_shell_completes",
        "command/grading/test_run.py",
        "command/test_packaging.py",
        "command/test_processes.py",
        "command/test_solve_task.py::test_a_process_watches_until_it_is_interrupted",
        "command/test_solve_task.py::test_ctrl_c_during_an_import_is_no_traceback",
        "docs/test_authors.py::test_the_makefile_builds_the_document",
        "docs/test_teachers.py",
        "problems/test_every_format.py",
        "programs/test_contacts.py::test_a_page_ends_where_a_simulation_does",
        "programs/test_languages.py::test_the_exported_f_satisfies_the_equations_of_the_page",
        "render/test_escape.py::test_tex_is_content",
        "render/test_html.py::test_a_browser_draws_everything_and_nothing_is_cut_off",
        "render/test_latex.py::test_a_fragment_goes_into_a_document",
        "render/test_markdown.py::test_pandoc_reads_every_formula",
        "render/test_tex_layout.py::test_the_estimate_of_widths_is_good",
        "render/test_tikz.py::test_pictures_compile",
    ),
}

ALWAYS = {
    "docs/test_architecture.py::test_every_module_has_a_test_file_of_its_name",
    "docs/test_architecture.py::test_no_module_imports_itself_by_a_detour",
    "docs/test_architecture.py::test_no_text_is_evaluated_and_nothing_is_simplified",
    "docs/test_architecture.py::test_packages_import_only_those_before_them",
    "docs/test_diagnostics.py::test_every_code_has_an_entry_and_every_entry_a_code",
    "docs/test_limits.py::test_no_other_module_has_a_limit",
    "document/test_math_writer.py::test_text_is_read_back",
    "explain/test_constraints.py::test_a_form_has_a_name_that_nothing_else_has",
    "expressions/test_latex_lexer.py::test_meanings",
    "golden/test_golden.py::test_output_is_as_it_was",
    "problems/test_read_back.py::test_it_passes_its_own_checks_and_agrees_with_its_answers",
    "problems/test_read_back.py::test_equations_can_be_read_again",
    "support/test_processes.py::test_every_process_has_a_limit",
}
"""Long, and run each time: the rules for imports, limits and processes hold, every shipped problem is solved, its checks
hold, and what is printed means what it should."""

LONG = 0.25
SHORT = 0.2
MEASURED = Path(__file__).with_name("slow_tests.txt")
SECONDS = {
    name: float(seconds)
    for name, seconds in (line.split() for line in MEASURED.read_text(encoding="utf-8").splitlines())
}
"""Of each function that takes long, in whatever tier: all its parameters together."""


def tier_of(test: str) -> str | None:
    """`truth`, `process`, `slow`, or None for a test that always runs. `test`: its path below `tests/`, `::`, its name."""
    return _tier_of_function(test.partition("[")[0])


@cache
def _tier_of_function(function: str) -> str | None:
    file = function.partition("::")[0]
    for tier, slow in TIERS.items():
        if any(function.startswith(name) if name.endswith("/") else name in (function, file) for name in slow):
            return tier
    return "slow" if function in SECONDS and function not in ALWAYS else None


def representatives(tests: Sequence[str]) -> set[str]:
    """The first test of each slow function with several tests that are short on average."""
    functions = [test.partition("[")[0] for test in tests]
    number = Counter(functions)
    first = dict(zip(reversed(functions), reversed(tests), strict=True))
    return {
        test
        for function, test in first.items()
        if tier_of(test) == "slow" and number[function] > 1 and SECONDS[function] <= SHORT * number[function]
    }


def renew(seconds: Mapping[str, float]) -> None:
    """Writes the list anew, from the processor seconds of each test in a run of all."""
    by_function: Counter[str] = Counter()
    for test, taken in seconds.items():
        by_function[test.partition("[")[0]] += taken
    lines = [f"{function} {taken:.1f}\n" for function, taken in sorted(by_function.items()) if taken > LONG]
    MEASURED.write_text("".join(lines), encoding="utf-8")
