"""Questions as Moodle's XML."""

from __future__ import annotations

import base64
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest

from tests.command.test_main import run


def questions(path: str) -> list[ET.Element]:
    return ET.parse(path).getroot().findall("question")


def text(element: ET.Element, path: str) -> str:
    return element.findtext(path) or ""


HOSTILE = """title: "]]> & <b>"
description: "A bead </text> ]]> on `x` at $x^2$, {{ 7*7 }} @@PLUGINFILE@@."
parameters: {m: {unit: kg, meaning: "<script>", value: 1/2}}
coordinates: [x]
particles: {P: {mass: m, position: x*i}}
"""


@pytest.mark.parametrize("platform", ["moodle", "coderunner"])
def test_questions_for_moodle(platform: str, here: Path) -> None:  # noqa: ARG001
    Path("mine.yaml").write_text(HOSTILE)
    assert run("new", "q.xml", "--from", "mine.yaml", "--for", platform).exit_code == 0
    *prototype, question = questions("q.xml")
    assert question.get("type") == ("essay" if platform == "moodle" else "coderunner")
    assert text(question, "name/text") == "]]> & <b>"
    statement = text(question, "questiontext/text")
    assert "<script>" not in statement
    assert r"\(x^{2}\)" in statement
    assert r"\(\frac{1}{2}\) kg" in statement
    assert "Find the equations of motion." in statement
    if platform == "coderunner":
        [prototype_question] = prototype
        assert text(prototype_question, "prototypetype") == "2"
        assert (text(prototype_question, "iscombinatortemplate"), text(prototype_question, "grader")) == (
            "1",
            "TemplateGrader",
        )
        assert text(prototype_question, "coderunnertype") == text(question, "coderunnertype") == "lagsolve"
        assert text(question, "globalextra") == HOSTILE
        assert text(question, "template") == text(question, "grader") == ""  # inherited
        template = text(prototype_question, "template")
        assert "QUESTION.globalextra | e('py')" in template
        assert "STUDENT_ANSWER | e('py')" in template


def test_a_question_has_its_figure(here: Path) -> None:  # noqa: ARG001
    assert run("new", "q.xml", "--from", "ex11", "--for", "moodle").exit_code == 0
    [question] = questions("q.xml")
    file = question.find("questiontext/file")
    assert file is not None
    svg = ET.fromstring(base64.b64decode(file.text or ""))
    assert svg.tag == "{http://www.w3.org/2000/svg}svg"
    assert "var(" not in ET.tostring(svg, encoding="unicode")
    assert f'src="@@PLUGINFILE@@/{file.get("name")}"' in text(question, "questiontext/text")
