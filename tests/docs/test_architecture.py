"""The house: imports run one way, a few libraries are imported in one package only, nothing is evaluated as code, files stay short.

The order of packages is `PACKAGES`, here and on docs/architecture.md.
"""

from __future__ import annotations

import ast
import doctest
import importlib
import re
from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path

import pytest

from tests.support.paths import ROOT

PACKAGES = [
    "core",
    "document",
    "expressions",
    "algebra.exact",
    "algebra.fourier",
    "algebra.forms",
    "algebra.closed_forms",
    "values",
    "problem",
    "mechanics.constraints",
    "mechanics.dynamics",
    "mechanics.equilibrium",
    "mechanics.questions",
    "mechanics",
    "answers",
    "pictures",
    "programs",
    "animation",
    "explain",
    "render",
    "api",
]
"""Each package imports only from itself and from those before it; `lagrange` and the command import from all of them."""

SOURCES = sorted(p for folder in ("lagrange", "cli") for p in (ROOT / folder).rglob("*.py"))
_REFERENCE = re.compile(r"`((?:[a-z_]+\.)*([a-z_]+)\.(_?[A-Za-z]\w*))")

MOST_MODULES = 20
"""In one folder."""

ROOMS = {
    "click": {
        *("lagsolve.main", "lagsolve.command_group", "lagsolve.output", "lagsolve.problem_commands"),
        *("lagsolve.new_file", "lagsolve.man_page", "lagsolve.program_commands", "lagsolve.course_commands"),
        *("lagsolve.grading.assignments", "lagsolve.platforms.starters"),
    },
    "rich": {"lagrange.render.terminal", "lagrange.render.terminal_layout", "lagsolve.grading.table"},
    "distributed": {"lagsolve.grading.pool"},
    "numpy": {
        *("lagrange.api.numerical", "lagrange.api.motion", "lagrange.programs.compiled"),
        *("lagrange.programs.numerical_system", "lagrange.programs.simulation", "lagrange.programs.sticking"),
        *("lagrange.programs.special.orbits", "lagrange.programs.special.poles"),
    },
    "scipy": {"lagrange.mechanics.questions.numerical", "lagrange.programs.integrator"},
    "matplotlib": {"lagrange.programs.plots"},
    "yaml": {"lagrange.problem.yaml.composer", "lagsolve.shipped"},
    "sympy": None,
    "mpmath": None,
}
"""Libraries, and the only modules that import them (None: all of `lagrange`, and not the command)."""

FORBIDDEN = {
    *("eval", "exec", "compile", "__import__"),  # a text is never code
    *("sympify", "parse_expr", "srepr", "lambdify", "S", "parse_latex"),  # these evaluate it, or write code
    *("nsimplify", "simplify", "trigsimp"),  # slow, and not to be relied on
}

COMPILED = {"lagrange.api.numerical": ["lambdify"], "lagrange.programs.compiled": ["exec", "compile"]}
"""The only modules that make Python code, of expressions whose symbols they have given names of their own."""

MATHEMATICS = {
    *("expand", "expand_mul", "expand_trig", "factor", "factor_terms", "factor_list", "together", "cancel", "collect"),
    *("apart", "fraction", "diff", "integrate", "series", "limit", "solve", "solveset", "Poly", "groebner", "subs"),
    *("Surface", "is_rational_function", "is_polynomial"),
}
"""What explanations do not do themselves: they choose and word. `mechanics/rewriting` makes the forms of a result."""

LONGEST = 600
"""Lines in a file."""


def files() -> dict[str, Path]:
    found = {}
    for package in (ROOT / "lagrange", ROOT / "cli" / "lagsolve"):
        for path in package.rglob("*.py"):
            parts = path.relative_to(package.parent).with_suffix("").parts
            found[".".join(parts).removesuffix(".__init__")] = path
    return found


FILES = files()


@cache
def tree_of(name: str) -> ast.AST:
    return ast.parse(FILES[name].read_text(encoding="utf-8"))


@cache
def imports_of(name: str) -> frozenset[str]:
    """The modules that a module imports: also in functions, and for types only. A late import hides no way up."""
    return frozenset(_imported(tree_of(name)))


def _imported(tree: ast.AST) -> Iterator[str]:
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, "imports are absolute"
            base = node.module or ""
            yield from (f"{base}.{a.name}" if f"{base}.{a.name}" in FILES else base for a in node.names)


def package_of(module: str) -> str:
    """The package of a module of `lagrange`; empty for its face and for modules of other libraries."""
    homes = [p for p in PACKAGES if f"{module}.".startswith(f"lagrange.{p}.")]
    return max(homes, key=len, default="")


def circle(module: str, above: tuple[str, ...] = (), done: set[str] | None = None) -> tuple[str, ...]:
    """A circular chain of imports; empty if there is none."""
    done = set() if done is None else done
    if module in above:
        return (*above[above.index(module) :], module)
    if module in done:
        return ()
    done.add(module)
    inner = (
        circle(i, (*above, module), done) for i in sorted(imports_of(module) if module in FILES else ()) if i != module
    )
    return next((c for c in inner if c), ())


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


def test_every_module_is_in_a_package() -> None:
    homeless = {m for m in FILES if m.startswith("lagrange.") and not package_of(m)}
    assert homeless == {"lagrange.algebra"}
    assert {package_of(m) for m in FILES} - {""} == set(PACKAGES)


@pytest.mark.parametrize("package", PACKAGES)
def test_packages_import_only_those_before_them(package: str) -> None:
    allowed = PACKAGES[: PACKAGES.index(package) + 1]
    for module in (m for m in FILES if package_of(m) == package):
        upwards = {i for i in imports_of(module) if package_of(i) and package_of(i) not in allowed}
        assert not upwards, f"{module} imports {', '.join(sorted(upwards))}"


def test_no_module_imports_itself_by_a_detour() -> None:
    done: set[str] = set()
    assert [c for c in (circle(m, (), done) for m in FILES) if c] == []


def test_folders_are_not_crowded() -> None:
    sizes = Counter(path.parent.relative_to(ROOT) for path in FILES.values() if path.stem != "__init__")
    assert {folder: n for folder, n in sizes.items() if n > MOST_MODULES} == {}


@pytest.mark.parametrize("library", ROOMS)
def test_libraries_stay_in_their_rooms(library: str) -> None:
    users = {name for name in FILES if library in {i.split(".")[0] for i in imports_of(name)}}
    rooms = ROOMS[library]
    if rooms is None:
        assert {u.split(".")[0] for u in users} == {"lagrange"}
    else:
        assert users == rooms


def test_the_library_knows_nothing_of_the_command() -> None:
    for name in FILES:
        if name.split(".")[0] == "lagrange":
            assert not {i.split(".")[0] for i in imports_of(name)} & {"lagsolve", "click", "argparse", "cli"}


@pytest.mark.parametrize("name", FILES)
def test_no_text_is_evaluated_and_nothing_is_simplified(name: str) -> None:
    assert forbidden(tree_of(name)) == COMPILED.get(name, [])


@pytest.mark.parametrize(
    "code", ["eval(x)", "sp.S('1/2')", "S('x')", "sp.sympify(x)", "e.simplify()", "sympy.simplify(e)", "f(g(exec(x)))"]
)
def test_the_search_for_forbidden_calls_finds_them(code: str) -> None:
    assert len(forbidden(ast.parse(code))) == 1
    assert forbidden(ast.parse("re.compile(x); sp.S.Zero; simplify = 1; sp.sympify(1, strict=True)")) == []


def mathematics(tree: ast.AST) -> list[str]:
    """The calls in a module that rewrite expressions: methods of SymPy, and functions of `lagrange.algebra`."""
    names = {
        alias.asname or alias.name
        for node in ast.walk(tree)
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("lagrange.algebra")
        for alias in node.names
    }
    called = (call.func for call in ast.walk(tree) if isinstance(call, ast.Call))
    return [
        f.attr if isinstance(f, ast.Attribute) else f.id
        for f in called
        if (isinstance(f, ast.Attribute) and f.attr in MATHEMATICS) or (isinstance(f, ast.Name) and f.id in names)
    ]


@pytest.mark.parametrize("name", [m for m in FILES if package_of(m) == "explain"])
def test_explanations_do_no_mathematics(name: str) -> None:
    assert mathematics(tree_of(name)) == []


def test_the_search_for_mathematics_finds_it() -> None:
    text = (
        "from lagrange.algebra.exact.zero_test import Surface as S, Row; S(); Row; sp.expand(e); e.diff(x); f(expand)"
    )
    assert mathematics(ast.parse(text)) == ["S", "expand", "diff"]


READING = {
    *("startswith", "endswith", "partition", "rpartition", "removeprefix", "removesuffix", "replace"),
    *("find", "index", "count", "split", "strip", "rstrip", "lstrip"),
}
"""Methods that look into a text."""


def wordings(tree: ast.AST, constants: Mapping[str, object]) -> list[str]:
    """The parts of sentences that a module looks for, spelled out or as constants: in comparisons and by methods."""
    sought: list[ast.expr] = []
    for node in ast.walk(tree):
        match node:
            case ast.Compare(left=left, comparators=right):
                sought += [left, *right]
            case ast.Call(func=ast.Attribute(value=ast.Name(id="re")), args=arguments):
                sought += arguments
            case ast.Call(func=ast.Attribute(attr="get", value=table)):
                sought.append(table)
            case ast.Call(func=ast.Attribute(attr=name), args=arguments) if name in READING:
                sought += arguments
    return [text for e in sought for node in ast.walk(e) for text in _texts(node, constants) if _is_prose(text)]


def _texts(node: ast.AST, constants: Mapping[str, object]) -> Iterator[str]:
    match node:
        case ast.Constant(value=str(text)):
            yield text
        case ast.Name(id=name):
            value = constants.get(name)
            several = value if isinstance(value, tuple | list | set | frozenset | dict) else (value,)
            yield from (v for v in several if isinstance(v, str))


def _is_prose(text: str) -> bool:
    """Whether it may be a part of a sentence: it has a space, or is a word with a capital."""
    return any(c.isspace() for c in text) or (text[:1].isupper() and text[1:].islower())


@pytest.mark.parametrize("name", [m for m in FILES if m.startswith("lagrange.explain.page")])
def test_pages_find_paragraphs_by_their_purposes(name: str) -> None:
    """What a page shortens it finds by the purpose that is given where a sentence is made, never by its words."""
    assert wordings(tree_of(name), vars(importlib.import_module(name))) == []


def test_the_search_for_wordings_finds_them() -> None:
    text = 'a.startswith("In terms of"); b == (BEGINS,); c.replace(" is", ""); LIST.get(d); e.startswith("virtual-")'
    constants = {"BEGINS": "Momentum", "LIST": {"With the ": 1}}
    assert {*wordings(ast.parse(text), constants)} == {"In terms of", "Momentum", " is", "With the "}
    assert wordings(ast.parse('prose("In terms of"); e.label == "virtual-work"'), {}) == []


def diagnoses_read(tree: ast.AST) -> list[str]:
    """Where a module looks into the words of a diagnosis, or of the clause of a changed problem."""
    return [
        ast.unparse(node)
        for node in ast.walk(tree)
        if isinstance(node, ast.Call)
        and isinstance(node.func, ast.Attribute)
        and node.func.attr in READING
        and isinstance(node.func.value, ast.Attribute)
        and node.func.value.attr in ("diagnosis", "clause")
        and any(len(str(c.value)) > 2 for c in ast.walk(node) if isinstance(c, ast.Constant))
    ]


@pytest.mark.parametrize("name", [m for m in FILES if m.startswith("lagrange.answers")])
def test_verdicts_depend_on_reasons(name: str) -> None:
    """What depends on why an equation is wrong asks for the `Reason`, and never for the words of its diagnosis."""
    assert diagnoses_read(tree_of(name)) == []


def test_the_search_for_diagnoses_finds_them() -> None:
    found = diagnoses_read(ast.parse('e.diagnosis.startswith("it is a first"); v.clause.endswith("exchanged")'))
    assert len(found) == 2
    assert diagnoses_read(ast.parse('e.diagnosis.partition("; "); e.text.startswith("it is")')) == []


READ_IN_PARTS = {"startswith", "endswith", "partition", "rpartition", "split", "rsplit", "removeprefix", "removesuffix",
                 "find", "index", "replace", "match", "search", "fullmatch"}  # fmt: skip


def looks_into_labels(tree: ast.AST) -> list[str]:
    """Where a part of a label is read, or sought in one: `e.label.startswith("virtual-")`."""
    found: list[ast.AST] = []
    for node in ast.walk(tree):
        match node:
            case ast.Call(func=ast.Attribute(attr=name, value=text), args=arguments) if name in READ_IN_PARTS:
                is_read = _is_label(text) or (ast.unparse(text) == "re" and any(map(_is_label, arguments)))
                found += [node] * is_read
            case ast.Subscript(value=text):
                found += [node] * _is_label(text)
            case ast.Compare(ops=[ast.In() | ast.NotIn()], comparators=[text]):
                found += [node] * _is_label(text)
    return [ast.unparse(n) for n in found]


def _is_label(node: ast.AST) -> bool:
    """Whether it is a label, or one that may be missing: `e.label or ""`."""
    match node:
        case ast.Attribute(attr="label") | ast.Name(id="label"):
            return True
        case ast.BoolOp(values=values):
            return any(map(_is_label, values))
        case ast.Call(func=ast.Name(id="str"), args=arguments):
            return any(map(_is_label, arguments))
    return False


@pytest.mark.parametrize("name", [m for m in FILES if m.startswith("lagrange.explain")])
def test_equations_are_found_by_their_kinds(name: str) -> None:
    """What an equation is, its kind says; its label is an id in which the user's names stand."""
    assert looks_into_labels(tree_of(name)) == []


def test_the_search_for_parts_of_labels_finds_them() -> None:
    text = '(e.label or "").startswith("a-"); label.partition("-"); e.label[:3]; re.match("a", e.label); "b" in e.label'
    assert len(looks_into_labels(ast.parse(text))) == 5
    assert looks_into_labels(ast.parse('e.label == "a"; e.label in labels; name.split(); Ref(e.label)')) == []


def test_files_are_short() -> None:
    lengths = {str(p.relative_to(ROOT)): len(p.read_text(encoding="utf-8").splitlines()) for p in FILES.values()}
    assert {f: n for f, n in lengths.items() if n > LONGEST} == {}


# docs/architecture.md


PAGE = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")


def test_the_session_on_the_page_runs(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    [session] = re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL)
    examples = doctest.DocTestParser().get_doctest(session, {}, "architecture.md", None, 0)
    assert len(examples.examples) > 20
    assert doctest.DocTestRunner().run(examples).failed == 0


def test_the_page_has_every_package_in_its_order() -> None:
    named = re.findall(r"^\| `([\w/]+)/` \|", PAGE, re.MULTILINE)
    assert named == [p.replace(".", "/") for p in PACKAGES]


def test_files_named_on_the_page_exist() -> None:
    mentioned = set(re.findall(r"`((?:\w+/)+\w+\.py)`", PAGE))
    assert {m for m in mentioned if not (ROOT / m).is_file() and not (ROOT / "lagrange" / m).is_file()} == set()


TESTED_ELSEWHERE = {
    "lagsolve.__main__": "command/test_processes.py",  # it is run as a process
    "lagsolve.platforms.parts": "command/platforms/test_gradescope.py",  # a record
}
"""Modules without a test file of their own, with the file that tests them; every `limits` has tests/docs/test_limits.py."""


def test_every_module_has_a_test_file_of_its_name() -> None:
    """The test of lagrange/a/b/c.py is tests/a/b/test_c.py, that of cli/lagsolve/b/c.py tests/command/b/test_c.py."""
    from tests.support.tests_of import named_test, tests_of

    modules = [m for m, path in FILES.items() if path.stem not in ("__init__", "limits")]
    assert {m for m in modules if not named_test(m).is_file()} == {*TESTED_ELSEWHERE}
    assert all((ROOT / "tests" / file).is_file() for file in TESTED_ELSEWHERE.values())
    assert [m for m in modules if not tests_of(m)] == []
    assert [p.name for p in tests_of("lagrange.algebra.exact.triangular")] == ["test_triangular.py"]


def _names_by_module() -> dict[str, set[str]]:
    """What each module defines or imports, and each package contains, by the last part of its name."""
    found: defaultdict[str, set[str]] = defaultdict(set)
    for path in SOURCES:
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.FunctionDef | ast.ClassDef):
                found[path.stem].add(node.name)
            elif isinstance(node, ast.Import | ast.ImportFrom):
                found[path.stem] |= {a.asname or a.name for a in node.names}
            elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
                found[path.stem].add(node.id)
        found[path.parent.name].add(path.stem)
        found[path.parent.parent.name].add(path.parent.name)
    return found


def test_what_a_comment_refers_to_exists() -> None:
    """`sampler.Branches` in a docstring or comment: a module of the project and a name in it."""
    known = _names_by_module()
    stale = [
        f"{path}: {module}.{name}"
        for path in SOURCES
        for whole, module, name in _REFERENCE.findall(path.read_text(encoding="utf-8"))
        if module in known
        and module != "lagrange"
        and name not in known[module] | {"py", "js", "json", "svg"}
        and "sympy" not in whole
    ]
    assert stale == []
