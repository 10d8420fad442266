"""Where dialects of Markdown differ: labels of equations, references, figures, folds, exercises.

    github   numbers are part of the formulas, which is what GitHub, Jupyter, pandoc and all others show alike
    myst     Sphinx with myst-parser, Jupyter Book: `$$ ... $$ (label)`, `` {eq}`label` ``, `{figure}`, `{exercise}`
    quarto   `$$ ... $$ {#eq-label}`, `@eq-label`, `![caption](file){#fig-label}`, divs `#exr-` and `.solution`

MyST: https://myst-parser.readthedocs.io/en/latest/syntax/math.html and .../syntax/images_and_figures.html; exercises:
https://ebp-sphinx-exercise.readthedocs.io/en/latest/syntax.html. Quarto:
https://quarto.org/docs/authoring/cross-references.html and https://quarto.org/docs/authoring/callouts.html. Quarto
wants labels in lower case, so all labels are.
"""

from __future__ import annotations

from collections.abc import Iterable
from enum import StrEnum

from lagrange.core.records import record
from lagrange.render.escape import slug

DIV, FENCE = ":::", "```"
"""The fences of Quarto and of MyST; longer ones may have shorter ones inside."""


class Flavour(StrEnum):
    """For whom Markdown is written."""

    GITHUB = "github"
    MYST = "myst"
    QUARTO = "quarto"

    @property
    def labels(self) -> bool:
        """Whether equations have labels, which the reader numbers."""
        return self is not Flavour.GITHUB

    def formula(self, code: str, label: str | None = None) -> str:
        """A displayed formula, with its label where it has one."""
        after = "" if label is None else f" ({label})" if self is Flavour.MYST else f" {{#eq-{label}}}"
        return f"$$\n{code}\n$${after}"

    def reference(self, label: str) -> str:
        """The number of a labelled formula in parentheses."""
        return f"{{eq}}`{label}`" if self is Flavour.MYST else f"([-@eq-{label}])"

    def figure(self, file: str, caption: str, alt: str, label: str) -> str:
        """A picture in a file beside the page, with its caption."""
        match self:
            case Flavour.MYST:
                return f"{FENCE}{{figure}} {file}\n:name: fig-{label}\n:alt: {alt}\n\n{caption}\n{FENCE}"
            case Flavour.QUARTO:
                quoted = alt.replace('"', "'")
                return f'![{caption}]({file}){{#fig-{label} fig-alt="{quoted}"}}'
            case _:
                return f"![{alt}]({file})\n\n*{caption}*" if caption else f"![{alt}]({file})"

    def folded(self, summary: str) -> tuple[str, str]:
        """What opens and closes a part that is shown on request."""
        match self:
            case Flavour.MYST:
                return f"{FENCE}`{{admonition}} {summary}\n:class: dropdown", f"{FENCE}`"
            case Flavour.QUARTO:
                return f'{DIV} {{.callout-note collapse="true"}}\n## {summary}', DIV
            case _:
                return f"<details><summary>{summary}</summary>", "</details>"

    def exercise(self, title: str, label: str, body: Iterable[str]) -> list[str]:
        """An exercise; GitHub has no block for it, but a heading."""
        match self:
            case Flavour.MYST:
                return [f"{FENCE}``{{exercise}} {title}\n:label: {label}", *body, f"{FENCE}``"]
            case Flavour.QUARTO:
                return [f"{DIV}: {{#exr-{label}}}", f"## {title}", *body, f"{DIV}:"]
            case _:
                return [f"# {title}", *body]

    def solution(self, title: str, label: str, body: Iterable[str]) -> list[str]:
        """The solution of the exercise with this label."""
        match self:
            case Flavour.MYST:
                return [f"{FENCE}``{{solution}} {label}\n:label: {label}-solution", *body, f"{FENCE}``"]
            case Flavour.QUARTO:
                return [f"{DIV}: {{.solution}}", *body, f"{DIV}:"]
            case _:
                return [f"# {title}", *body]


@record
class Labels:
    """The labels of one page: `ideal-pendulum-motion`, in lower case, each once."""

    prefix: str
    given: dict[str, str]

    def of(self, label: str) -> str:
        """The label of an equation or picture, the same whenever it is asked for."""
        if label not in self.given:
            plain = f"{self.prefix}-{slug(label)}"
            taken = [*self.given.values()]
            number = next(n for n in range(1, len(taken) + 2) if self._numbered(plain, n) not in taken)
            self.given[label] = self._numbered(plain, number)
        return self.given[label]

    @staticmethod
    def _numbered(plain: str, number: int) -> str:
        return plain if number == 1 else f"{plain}-{number}"
