"""Which tests are slow: those that `make test` runs a tenth of. Names of folders, files and functions below `tests/`."""

from __future__ import annotations

TIERS = {
    "truth": (
        "truth/",
        "algebra/closed_forms/test_branching.py::test_systems",
        "algebra/closed_forms/test_eigenmodes.py",
        "algebra/forms/test_derived_flag.py::test_ranks_by_symbolic_brackets",
        "algebra/forms/test_derived_flag.py::test_six_constraints_in_twelve_coordinates",
        "algebra/forms/test_hidden_relations.py::test_relations_stay_constant_along_a_random_motion",
        "algebra/forms/test_hidden_relations.py::test_six_constraints_in_twelve_coordinates",
        "algebra/forms/test_hidden_relations.py::test_the_number_by_symbolic_brackets",
        "algebra/forms/test_hidden_relations.py::test_two_trolleys_in_twelve_coordinates",
        "answers/test_submissions.py::test_long_files_take_no_longer_than_their_length",
        "api/test_numerical.py::test_the_double_pendulum_is_that_of_sympy",
        "mechanics/constraints/test_coordinates.py::test_a_long_chain_is_solved_as_far_as_that_goes",
        "mechanics/constraints/test_rigid_bodies.py::test_every_sequence_against_newton_and_euler",
        "mechanics/dynamics/test_conservation.py",
        "mechanics/dynamics/test_newton.py::test_newtons_laws_are_lagranges_equations_with_multipliers",
        "mechanics/equilibrium/test_linearization.py::test_both_regimes_were_met",
        "mechanics/equilibrium/test_linearization.py::test_frequencies_and_stability_are_those_of_the_numbers",
        "mechanics/equilibrium/test_stability.py::test_a_double_pendulum_is_stable_only_if_it_hangs",
        "problems/test_constraint_problems.py::test_the_derived_flag_by_brackets",
    ),
    "process": (
        "algebra/exact/test_prime_field.py::test_every_process_has_a_prime_of_its_own",
        "api/test_interface.py::test_importing_costs_nothing",
        "command/grading/test_pool.py",
        "command/test_files.py::test_a_real_shell_completes",
        "command/test_grade.py",
        "command/test_packaging.py",
        "command/test_processes.py",
        "command/test_watching.py::test_a_process_watches_until_it_is_interrupted",
        "command/test_watching.py::test_ctrl_c_during_an_import_is_no_traceback",
        "docs/test_authors.py::test_the_makefile_builds_the_document",
        "docs/test_teachers.py",
        "render/test_escape.py::test_tex_is_content",
        "render/test_html.py::test_a_browser_draws_everything_and_nothing_is_cut_off",
        "render/test_latex.py::test_a_fragment_goes_into_a_document",
        "render/test_markdown.py::test_pandoc_reads_every_formula",
        "render/test_tex_layout.py::test_the_estimate_of_widths_is_good",
        "render/test_tikz.py::test_pictures_compile",
    ),
}


def tier_of(test: str) -> str | None:
    """`truth`, `process`, or None for a test that always runs. `test` is its path below `tests/`, `::`, its name."""
    function = test.partition("[")[0]
    for tier, slow in TIERS.items():
        if any(
            function.startswith(name) if name.endswith("/") else name in (function, function.partition("::")[0])
            for name in slow
        ):
            return tier
    return None
