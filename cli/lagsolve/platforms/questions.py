r"""A problem as a question of Moodle: statement and figure, as XML that Moodle imports.

The format is Moodle's own (https://docs.moodle.org/en/Moodle_XML_format): `<quiz>` with `<question type="...">`; HTML
is in CDATA, a picture in `<file encoding="base64">`, to which `@@PLUGINFILE@@/name` refers. Mathematics is between
`\(` and `\)`, which Moodle's MathJax filter sets. Two kinds of question are written: an essay in a monospaced box,
whose answers `lagsolve grade --format moodle` grades offline, and CodeRunner's, graded at once.

The fields of CodeRunner's are those that it exports itself (`prototypetype` 2: a prototype of the user's;
`TemplateGrader` with `iscombinatortemplate`: the template prints JSON).
"""

from __future__ import annotations

import re
from base64 import b64encode
from collections.abc import Iterable, Iterator
from html import escape

from lagrange.core.diagnostics import Source
from lagrange.core.printable import printable
from lagrange.document.derivation import Derivation, Emphasis, Math, Part, Picture, Ref
from lagrange.document.math_writer import LATEX, UNICODE, Writer
from lagrange.document.names import Notation
from lagrange.explain.page.texts import set_text
from lagrange.explain.report import Report, report
from lagrange.problem.keys import Find
from lagrange.problem.loader import read_problem
from lagrange.problem.model import Coordinate, Parameter, Problem
from lagrange.render.html import CSS
from lagrange.render.svg import figure

FIGURE = "figure.svg"
_COLOURS = {"--ink": "#1c1b1a", "--paper": "#ffffff", "--quiet": "#6b6862", "--accent": "#7a2e1d"}
_MIXED = re.compile(r"color-mix\(in srgb, var\(--ink\) (\d+)%, var\(--paper\)\)")

_ASKED = {
    Find.MOTION: "the equations of motion",
    Find.EQUILIBRIUM: "the positions of equilibrium",
    Find.IMPENDING: "the limits of equilibrium",
    Find.LINEARIZATION: "the equations of small oscillations",
    Find.CONSTRAINTS: "the relations between the virtual displacements",
    Find.HAMILTONIAN: "Hamilton's function",
    Find.STEADY: "the steady motions",
}

TEMPLATE = '''\
import json
import sys

problem = """{{ QUESTION.globalextra | e('py') }}"""
answer = """{{ STUDENT_ANSWER | e('py') }}"""
try:
    from lagsolve.platforms.coderunner import result
except ImportError:
    fault = "lagsolve is not installed on the Jobe server: python3 -m pip install lagsolve"
    print(json.dumps({"fraction": 0, "epiloguehtml": "This question cannot be graded now.", "instructorhtml": fault}))
    sys.exit()
print(result(problem, answer, {{ QUESTION.parameters.hint | default(1) }}))
'''


def essay(source: Source) -> str:
    """The XML of an essay question about a problem. Raises ProblemError if it cannot be read or solved."""
    solved = report(read_problem(source), complete=False)
    return _quiz(_question("essay", solved, _ESSAY))


def coderunner(source: Source) -> str:
    """The XML of CodeRunner's prototype for lagsolve, and of a question about a problem."""
    solved = report(read_problem(source), complete=False)
    prototype = (
        '  <question type="coderunner">\n'
        "    <name><text>PROTOTYPE_lagsolve</text></name>\n"
        f'    <questiontext format="html"><text>{_cdata(_ABOUT)}</text></questiontext>\n'
        f"{_coderunner_fields(2, TEMPLATE, '')}"
        "  </question>\n"
    )
    return _quiz(prototype, _question("coderunner", solved, _coderunner_fields(0, "", source.text)))


_ABOUT = (
    "<p>The answer is a text with equations; lagsolve compares them with the equations of motion that it derives from "
    "the problem file under <i>Global extra</i>. Template parameter <code>hint</code>: how much the feedback reveals, "
    "1 to 3. lagsolve must be installed on the Jobe server.</p>"
)

_ESSAY = """\
    <responseformat>monospaced</responseformat>
    <responserequired>1</responserequired>
    <responsefieldlines>10</responsefieldlines>
    <minwordlimit></minwordlimit>
    <maxwordlimit></maxwordlimit>
    <attachments>0</attachments>
    <attachmentsrequired>0</attachmentsrequired>
    <graderinfo format="html"><text></text></graderinfo>
    <responsetemplate format="html"><text></text></responsetemplate>
"""


def _coderunner_fields(prototype: int, template: str, problem: str) -> str:
    """The fields of CodeRunner; a question leaves to its prototype what it does not change."""
    fixed = {
        "coderunnertype": "lagsolve", "prototypetype": str(prototype), "allornothing": "0", "penaltyregime": "0",
        "precheck": "0", "hidecheck": "0", "showsource": "0", "answerboxlines": "10", "answerboxcolumns": "100",
        "answerpreload": "", "globalextra": problem, "useace": "", "resultcolumns": "", "template": template,
    }  # fmt: skip
    of_prototype = {
        "iscombinatortemplate": "1", "allowmultiplestdins": "0", "language": "python3", "sandbox": "jobesandbox",
        "grader": "TemplateGrader", "cputimelimitsecs": "30", "memlimitmb": "1000",
    }  # fmt: skip
    rest = {name: value if prototype else "" for name, value in of_prototype.items()}
    last = {"templateparams": '{"hint": 1}' if prototype else "", "uiplugin": "ace" if prototype else ""}
    fields = fixed | {"useace": "0" if prototype else ""} | rest | last
    lines = [f"    <{name}>{_cdata(value) if value else ''}</{name}>" for name, value in fields.items()]
    tests = (
        '    <testcases>\n      <testcase testtype="0" useasexample="0" hiderestiffail="0" mark="1.0000000">\n'
        "        <testcode><text></text></testcode>\n        <stdin><text></text></stdin>\n"
        "        <expected><text></text></expected>\n        <extra><text></text></extra>\n"
        "        <display><text>SHOW</text></display>\n      </testcase>\n    </testcases>"
    )
    return "\n".join([*lines, tests]) + "\n"


def _quiz(*questions: str) -> str:
    return '<?xml version="1.0" encoding="UTF-8"?>\n<quiz>\n' + "\n".join(questions) + "</quiz>\n"


def _question(kind: str, solved: Report, fields: str) -> str:
    """A question with the statement and the figure of a problem."""
    problem = solved.solution.problem
    picture = figure_of(solved.derivation, solved.notation)
    shown = f'<p><img src="@@PLUGINFILE@@/{FIGURE}" alt="{escape(picture[1])}" /></p>' if picture else ""
    attached = b64encode(picture[0].encode()).decode() if picture else ""
    file = f'\n      <file name="{FIGURE}" path="/" encoding="base64">{attached}</file>' if picture else ""
    statement = "\n".join(statement_of(problem, solved.notation))
    return (
        f'  <question type="{kind}">\n'
        f"    <name><text>{escape(_clean(problem.title))}</text></name>\n"
        f'    <questiontext format="html">\n      <text>{_cdata(statement + shown)}</text>{file}\n'
        "    </questiontext>\n"
        '    <generalfeedback format="html"><text></text></generalfeedback>\n'
        "    <defaultgrade>1.0000000</defaultgrade>\n    <penalty>0.0000000</penalty>\n    <hidden>0</hidden>\n"
        "    <idnumber></idnumber>\n"
        f"{fields}  </question>\n"
    )


def statement_of(problem: Problem, notation: Notation) -> Iterator[str]:
    """The statement in HTML: the description, a table of symbols with values, what is asked, how to write it."""
    write = Writer(LATEX, notation)
    if problem.description:
        yield f"<p>{_html(set_text(problem.description, problem), write)}</p>"
    symbols: list[Coordinate | Parameter] = [*problem.coordinates, *problem.parameters]
    rows = [_row(s, write) for s in symbols if s.meaning or s.unit or getattr(s, "value", None) is not None]
    if rows:
        yield f"<table><tbody>{''.join(rows)}</tbody></table>"
    asked = [_ASKED[f] for f in problem.find if f in _ASKED]
    if asked:
        yield f"<p>Find {' and '.join(asked)}.</p>"
    coordinates = [q.symbol for q in problem.coordinates] + [q for c in problem.choices for q in c.coordinates]
    names = ", ".join(f"<code>{escape(str(q))}</code>" for q in dict.fromkeys(coordinates))
    example = escape(str(problem.coordinates[0].symbol))
    yield (
        f"<p>Write one equation a line. Coordinates are {names}; <code>{example}'</code> is a velocity, "
        f"<code>{example}''</code> an acceleration. LaTeX is understood too.</p>"
    )


def _row(symbol: Coordinate | Parameter, write: Writer) -> str:
    """The symbol, its meaning, and its value and unit."""
    value = symbol.value if isinstance(symbol, Parameter) else None
    number = rf"\({escape(write.plain(value))}\) " if value is not None else ""
    cells = rf"\({escape(write.plain(symbol.symbol))}\)", escape(_clean(symbol.meaning)), number + escape(symbol.unit)
    return f"<tr>{''.join(f'<td>{cell}</td>' for cell in cells)}</tr>"


def _html(parts: Iterable[Part], write: Writer) -> str:
    """Running text in HTML."""
    code = []
    for part in parts:
        match part:
            case Math(sides=sides, relation=relation):
                joint = {"≤": r" \le "}.get(relation, f" {relation} ")
                code.append(rf"\({escape(joint.join(write.plain(side) for side in sides))}\)")
            case Emphasis(word=word):
                code.append(f"<i>{escape(_clean(word))}</i>")
            case Ref():
                continue
            case str(text):
                code.append(escape(_clean(text)))
    return "".join(code)


def figure_of(derivation: Derivation, notation: Notation) -> tuple[str, str] | None:
    """The figure of the system as an SVG file of its own, and its description; None if there is none."""
    write = Writer(UNICODE, notation)
    for step in derivation.steps:
        for block in step.body:
            if isinstance(block, Picture):
                scene = block.draw()
                if scene is None:
                    return None
                lines = list(figure(scene, printable(block.alt), write.plain))
                head = lines[0].replace("<svg ", '<svg xmlns="http://www.w3.org/2000/svg" ', 1)
                head = head.replace("<title>", f"<style>{_style()}</style><title>", 1)
                return "\n".join([head, *lines[1:]]) + "\n", printable(block.alt)
    return None


def _style() -> str:
    """The rules of the web page for pictures, with their colours written out."""
    rules = re.findall(r"^\.picture [^{]*\{[^}]*\}", CSS, re.MULTILINE)
    text = _MIXED.sub(lambda mix: f"#{3 * format(255 - int(mix[1]) * 227 // 100, '02x')}", " ".join(rules))
    return re.sub(r"var\((--\w+)\)", lambda name: _COLOURS.get(name[1], "#1c1b1a"), text)


def _clean(text: str) -> str:
    return " ".join(printable(text).split())


def _cdata(text: str) -> str:
    """Text that XML does not read: `]]>` would end it."""
    return "<![CDATA[" + text.replace("]]>", "]]]]><![CDATA[>") + "]]>"
