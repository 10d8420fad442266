"""Pages of the site that no file of docs/ is: README, changelog, the reference of `import lagrange`."""

from __future__ import annotations

import re
from pathlib import Path

import griffe
from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files
from mkdocs.structure.pages import Page

import lagrange

ROOT = Path(__file__).resolve().parent.parent
PAGES = {
    "README.md": "index.md",
    "CHANGELOG.md": "changelog.md",
    "CONTRIBUTING.md": "contributing.md",
    "SECURITY.md": "security.md",
}


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """Adds the files beside docs/ and the page of the public names."""
    for source, page in PAGES.items():
        files.append(File.generated(config, page, content=(ROOT / source).read_text(encoding="utf-8")))
    files.append(File.generated(config, "LICENSE", content=(ROOT / "LICENSE").read_text(encoding="utf-8")))
    files.append(File.generated(config, "api.md", content=reference()))
    return files


def reference() -> str:
    """Every public name by the module that it comes from."""
    homes = [
        f"::: lagrange.{home}.{name}" for home, names in lagrange._HOMES.items() for name in names if name[0] != "_"
    ]
    return "\n\n".join(["# Reference of `import lagrange`", lagrange.__doc__ or "", *sorted(homes)])


def on_page_markdown(markdown: str, page: Page, **_: object) -> str:
    """Links between README and docs/ as they are on the site."""
    up = page.file.src_uri in PAGES.values()
    for source, name in PAGES.items():
        markdown = re.sub(rf"\]\((?:\.\./)?{re.escape(source)}(?=[)#])", f"]({name}", markdown)
    markdown = markdown.replace("](../LICENSE)", "](LICENSE)")
    return re.sub(r"(\]\(|src=\")docs/", r"\1", markdown) if up else markdown


class Tables(griffe.Extension):
    """Docstrings say names and meanings in two columns; the reference has them as a list."""

    _ROW = re.compile(r"^(\w+(?:, \w+)*) {2,}(?=\S)", re.MULTILINE)

    def on_instance(self, *, obj: griffe.Object, **_: object) -> None:
        """Every class and function as it is read."""
        if obj.docstring:
            obj.docstring.value = self._ROW.sub(r"* `\1`: ", obj.docstring.value)
