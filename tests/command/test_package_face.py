"""What surrounds the program: version, public names, the manual page, files of the project, another `lagrange`."""

from __future__ import annotations

import re
import subprocess
import sys
import tomllib
from pathlib import Path

import yaml
from packaging.requirements import Requirement

import lagrange
from tests.support.paths import ROOT
from tests.support.processes import PATIENCE

PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]


def test_only_public_names_are_listed() -> None:
    assert dir(lagrange) == sorted(lagrange.__all__)
    assert not [name for name in dir(lagrange) if name.startswith("_") and name != "__version__"]


def test_one_version() -> None:
    citation = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
    assert lagrange.__version__ in (PROJECT["version"], "0+unknown")
    assert citation["version"] == PROJECT["version"]
    assert citation["license"] == "MIT"
    assert {"cff-version", "message", "title", "authors"} <= set(citation)


def test_the_classifiers_have_every_python() -> None:
    listed = [c.rpartition(" ")[2] for c in PROJECT["classifiers"] if re.search(r"Python :: 3\.\d+$", c)]
    assert listed == ["3.11", "3.12", "3.13", "3.14"]
    workflow = yaml.safe_load((ROOT / ".github/workflows/tests.yml").read_text(encoding="utf-8"))
    assert workflow["jobs"]["tests"]["strategy"]["matrix"]["python"] == listed
    oldest = next(d for d in PROJECT["dependencies"] if d.startswith("sympy"))
    assert f"sympy=={oldest.partition('>=')[2]}.*" in str(workflow)


def test_every_target_of_the_workflows_and_hooks_is_there() -> None:
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    workflow = (ROOT / ".github/workflows/tests.yml").read_text(encoding="utf-8")
    for target in re.findall(r"make ([\w-]+)", workflow):
        assert f"\n{target}:" in makefile
    hooks = yaml.safe_load((ROOT / ".pre-commit-config.yaml").read_text(encoding="utf-8"))
    assert [h["id"] for h in hooks["repos"][0]["hooks"]] == ["ruff", "format", "mypy"]


def test_the_changelog_has_the_headings_of_keep_a_changelog() -> None:
    text = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    assert "\n## [Unreleased]\n" in text
    kinds = {"Added", "Changed", "Deprecated", "Removed", "Fixed", "Security"}
    assert set(re.findall(r"^### (.*)$", text, re.MULTILINE)) <= kinds


def test_files_that_are_named_are_there() -> None:
    for page in ("SECURITY.md", "CONTRIBUTING.md", "CHANGELOG.md"):
        for target in re.findall(r"\]\(([^)#:]+)(?:#[^)]*)?\)", (ROOT / page).read_text(encoding="utf-8")):
            assert (ROOT / target).exists(), f"{page}: {target}"


def test_another_package_of_the_same_name_is_noticed(tmp_path: Path) -> None:
    (tmp_path / "lagrange").mkdir()
    (tmp_path / "lagrange" / "__init__.py").write_text("def interpolate(x): return x\n", encoding="utf-8")
    code = f"import sys; sys.path[:0] = [{str(tmp_path)!r}, {str(ROOT / 'cli')!r}]; from lagsolve.__main__ import run; run()"
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, timeout=PATIENCE, check=False, cwd=ROOT.parent
    )
    assert done.returncode == 2
    assert done.stderr.startswith("error[another-lagrange]: `lagrange` in ")
    assert "pip install --force-reinstall lagsolve" in done.stderr
    assert "Traceback" not in done.stderr


def test_the_lock_file_pins_every_dependency_with_its_hashes() -> None:
    text = (ROOT / "requirements.lock").read_text(encoding="utf-8")
    pins = re.findall(r"^([\w-]+)==(\S+)(.*\n(?:    --hash=sha256:[0-9a-f]{64}.*\n)+)?", text, re.MULTILINE)
    assert all(hashes for _, _, hashes in pins)
    for wanted in map(Requirement, [*PROJECT["dependencies"], *PROJECT["optional-dependencies"]["sim"]]):
        versions = [version for name, version, _ in pins if name == wanted.name]
        assert versions
        assert all(wanted.specifier.contains(v) for v in versions)


def test_the_site_has_every_page_of_the_documentation() -> None:
    [nav] = re.findall(r"^nav:\n.*", (ROOT / "mkdocs.yml").read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
    pages = {
        page
        for part in yaml.safe_load(nav)["nav"]
        for pages in part.values()
        for page in (pages if isinstance(pages, list) else [pages])
    }
    beside = {"index.md", "api.md", "contributing.md", "changelog.md", "security.md"}
    assert pages == beside | {path.name for path in (ROOT / "docs").glob("*.md")}
