"""The house: imports run one way, a few libraries stay in their rooms, nothing is evaluated as code, files stay short.

A new module fails `test_every_module_has_its_place` until it stands in `LAYERS` and in docs/architecture.md.
"""

from __future__ import annotations

import ast
import doctest
import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from conftest import ROOT

LAYERS = {
    "words and symbols": "records diagnostics notation vectors rotation",
    "exact evaluation": """elimination graph field evaluation points residues reals walls branches blocks projection
        triangular sampler exact sampling""",
    "the ring of Fourier sums": """packing polynomials terms fourier generators parameters division products
        differentiation trigonometry common_factor textbook lowest_terms""",
    "expressions": """characters constants measures lexicon trees tokens bounded scope stream spelling atoms remarks syntax
        meaning vector_meaning latex_commands latex_layout latex_scanner latex_names latex_atoms latex_functions
        latex_derivatives latex_brackets latex_input expressions answer_files tidying""",
    "problem files": """nodes yaml_text yaml_mistakes findings symbols frames yaml_composer sections yaml_nodes names
         velocity_polynomials alternatives reduction problem reading declarations undefined_functions reference_frame orientation bodies
        forces constraint_equations answer_key choices
        particles loader answer_yaml library""",
    "differential forms": """quadratics waves antiderivatives potentials exterior jets taylor flags charts
        integrability one_forms factor_candidates exponents symmetries one_variable relations integrating_factors
        restrictions combinations candidates first_integrals hidden_relations""",
    "closed forms": "positivity unit_circle presentation polynomial_roots pencils closed_form seen solution_sets branching",
    "a derivation": "scene derivation",
    "mathematics written": """render render.names render.pieces render.kinds render.products render.order render.styles
        render.style_unicode render.style_latex render.mathematics""",
    "stages": """links rigid_bodies kinematics bending consistency rank_loss quasi_coordinates constraints classification displacements
        coordinates linear placing rods newton workless balance principle lagrangian energies reactions friction equations
        eliminated_rates multipliers comparison constant_inertia matrix_form dynamics quasi_velocities quasi_equations spot verification
        quasi_verification conservative energy_functions noether gauges admitted conservation equilibrium stability static_reactions
        statics rest linear_stability linearization linearization_checks""",
    "results": """solution letters benches edits conventions diagnosis dimensions advice answer_readings radii references reference_systems
        validity recognition answers reaction_answers
        equilibrium_comparison equilibrium_answers frequency_answers checked checking grading""",
    "derivations": """explain explain.words explain.bodies explain.statement explain.nonlinear
        explain.displacements explain.factors explain.systems explain.quasi_coordinates explain.constraints explain.newton explain.motion
        explain.energies explain.lagrange explain.matrix_form explain.quasi_velocities explain.reactions
        explain.conservation explain.static_reactions explain.statics explain.linearization explain.checks explain.pictures""",
    "pictures": """pictures pictures.floats pictures.poses pictures.views pictures.labels pictures.sketch pictures.shapes
        pictures.marks pictures.systems pictures.curves pictures.loads pictures.measures pictures.configurations
        pictures.free_bodies pictures.illustrated""",
    "renderers": """render.abridged render.shown render.breaking render.matrices render.paragraphs render.tables render.pretty render.ems render.escape
        render.aligned render.letters_of_vectors render.tikz render.latex render.markdown render.style_mathml render.formulas render.svg render.stylesheet render.html""",
    "reports": "report render.json_linear render.json_motion render.json render.verdict",
    "in Python": """time_functions given_functions first_order numerical sympy_answers judgement formulation result interface
        lagrange""",
    "the command": """lagsolve lagsolve.status lagsolve.group lagsolve.stages lagsolve.library lagsolve.catalogue
        lagsolve.reading lagsolve.completing lagsolve.schema_forms lagsolve.schema lagsolve.template
        lagsolve.grading lagsolve.grading.child lagsolve.grading.worker lagsolve.grading.pool lagsolve.grading.examining
        lagsolve.grading.submissions lagsolve.grading.batch lagsolve.grading.rows lagsolve.grading.feedback
        lagsolve.grading.journal lagsolve.grading.progress lagsolve.grading.cluster lagsolve.grading.order
        lagsolve.output lagsolve.beginning lagsolve.files lagsolve.solving lagsolve.watching lagsolve.main
        lagsolve.__main__""",
}
"""A module imports only what stands before it."""

FOR_TYPES_ONLY = {
    (
        "lagrange.algebra.fourier.fourier",
        "lagrange.algebra.fourier.generators",
    ),  # a sum knows its basis, which numbers what sums are made of
    (
        "lagrange.algebra.fourier.differentiation",
        "lagrange.algebra.fourier.trigonometry",
    ),  # derivations of a ring are members of it
}
"""Imports the other way, under TYPE_CHECKING."""

ROOMS = {
    "click": {
        *("lagsolve.main", "lagsolve.group", "lagsolve.output", "lagsolve.status", "lagsolve.files"),
        *("lagsolve.completing", "lagsolve.beginning"),
    },
    "rich": {
        "lagrange.render.terminal",
        "lagrange.render.paragraphs",
        "lagrange.render.tables",
        "lagrange.render.matrices",
        "lagsolve.grading.rows",
    },
    "distributed": {"lagsolve.grading.cluster"},
    "numpy": {"lagrange.api.numerical"},
    "yaml": {
        "lagrange.problem.yaml_composer",
        "lagrange.problem.yaml_mistakes",
        "lagrange.problem.yaml_nodes",
        "lagsolve.library",
    },
    "sympy": None,
    "mpmath": None,
}
"""Libraries, and the only modules that import them (None: all of `lagrange`, and not the command)."""

FORBIDDEN = {
    *("eval", "exec", "compile", "__import__"),  # a text is never code
    *("sympify", "parse_expr", "srepr", "lambdify", "S", "parse_latex"),  # these evaluate it, or write code
    *("nsimplify", "simplify", "trigsimp"),  # slow, and not to be relied on
}

COMPILED = {"lagrange.api.numerical"}
"""The only module that makes Python code, of expressions whose symbols it has given names of its own."""

LONGEST = 400
LONGER: dict[str, str] = {}
"""Files over the limit, with the reason."""


def full(name: str) -> str:
    return name if name.split(".")[0] in ("lagrange", "lagsolve") else f"lagrange.{name}"


ORDER = [full(name) for names in LAYERS.values() for name in names.split()]


def files() -> dict[str, Path]:
    found = {}
    for package in (ROOT / "lagrange", ROOT / "cli" / "lagsolve"):
        for path in package.rglob("*.py"):
            parts = path.relative_to(package.parent).with_suffix("").parts
            found[".".join(parts).removesuffix(".__init__")] = path
    return found


FILES = files()
TREES = {name: ast.parse(path.read_text(encoding="utf-8")) for name, path in FILES.items()}


def imported(tree: ast.AST) -> Iterator[str]:
    """The modules that a module imports, wherever in it."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, "imports are absolute"
            base = node.module or ""
            yield from (f"{base}.{a.name}" if f"{base}.{a.name}" in FILES else base for a in node.names)


def for_types_only(tree: ast.Module) -> set[str]:
    blocks = [n for n in tree.body if isinstance(n, ast.If) and ast.unparse(n.test) == "TYPE_CHECKING"]
    return {name for block in blocks for name in imported(block)}


def forbidden(tree: ast.AST) -> list[str]:
    """The forbidden functions that are called. `sympify(..., strict=True)` is not one: it takes no text."""
    found = []
    for call in (node for node in ast.walk(tree) if isinstance(node, ast.Call)):
        match call.func:
            case ast.Name(id=name):
                owner = ""
            case ast.Attribute(attr=name):
                owner = ast.unparse(call.func.value)
            case _:
                continue
        strict = name == "sympify" and "strict=True" in map(ast.unparse, call.keywords)
        if name in FORBIDDEN and owner != "re" and not strict:
            found.append(name)
    return found


def test_every_module_has_its_place() -> None:
    assert len(ORDER) == len(set(ORDER))
    assert set(ORDER) == set(FILES)


@pytest.mark.parametrize("name", FILES)
def test_imports_run_one_way(name: str) -> None:
    backwards = {i for i in imported(TREES[name]) if i in ORDER and ORDER.index(i) > ORDER.index(name)}
    allowed = {i for m, i in FOR_TYPES_ONLY if m == name}
    assert backwards == allowed
    assert allowed <= for_types_only(TREES[name])


@pytest.mark.parametrize("library", ROOMS)
def test_libraries_stay_in_their_rooms(library: str) -> None:
    users = {name for name, tree in TREES.items() if library in {i.split(".")[0] for i in imported(tree)}}
    rooms = ROOMS[library]
    if rooms is None:
        assert {u.split(".")[0] for u in users} == {"lagrange"}
    else:
        assert users == rooms


def test_the_library_knows_nothing_of_the_command() -> None:
    for name, tree in TREES.items():
        if name.split(".")[0] == "lagrange":
            assert not {i.split(".")[0] for i in imported(tree)} & {"lagsolve", "click", "argparse", "cli"}


@pytest.mark.parametrize("name", FILES)
def test_no_text_is_evaluated_and_nothing_is_simplified(name: str) -> None:
    assert forbidden(TREES[name]) == ["lambdify"] * (name in COMPILED)


@pytest.mark.parametrize(
    "code", ["eval(x)", "sp.S('1/2')", "S('x')", "sp.sympify(x)", "e.simplify()", "sympy.simplify(e)", "f(g(exec(x)))"]
)
def test_the_search_for_forbidden_calls_finds_them(code: str) -> None:
    assert len(forbidden(ast.parse(code))) == 1
    assert forbidden(ast.parse("re.compile(x); sp.S.Zero; simplify = 1; sp.sympify(1, strict=True)")) == []


def test_files_are_short() -> None:
    lengths = {str(p.relative_to(ROOT)): len(p.read_text(encoding="utf-8").splitlines()) for p in FILES.values()}
    assert {f for f, n in lengths.items() if n > LONGEST} == set(LONGER)


# docs/architecture.md


PAGE = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")


def test_the_session_on_the_page_runs(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    [session] = re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL)
    examples = doctest.DocTestParser().get_doctest(session, {}, "architecture.md", None, 0)
    assert len(examples.examples) > 20
    assert doctest.DocTestRunner().run(examples).failed == 0


def test_the_page_names_every_module_and_no_other() -> None:
    mentioned = set(re.findall(r"`((?:\w+/)*\w+\.py)`", PAGE))
    existing = {str(p.relative_to(ROOT)).removeprefix("lagrange/").removeprefix("cli/") for p in FILES.values()}
    assert mentioned == {f for f in existing if not f.endswith("__init__.py")}


def test_the_page_has_the_layers_in_their_order() -> None:
    headings = re.findall(r"^\*\*(.+?)\.\*\*", PAGE, re.MULTILINE)
    assert [h[0].lower() + h[1:] for h in headings] == list(LAYERS)


def test_the_page_has_each_module_in_its_layer() -> None:
    sections = re.split(r"^\*\*.+?\.\*\*", PAGE, flags=re.MULTILINE)[1:]
    for names, section in zip(LAYERS.values(), sections, strict=True):
        written = [f.removesuffix(".py").replace("/", ".") for f in re.findall(r"`((?:\w+/)*\w+\.py)`", section)]
        packages = {"lagrange", "explain", "render", "pictures", "lagsolve", "lagsolve.grading"}
        assert set(written) == set(names.split()) - packages
