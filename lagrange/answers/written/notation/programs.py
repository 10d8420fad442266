r"""State functions of programs, `def f(t, y): ...`, as equations of motion: read like any other text, and never run.

    def f(t, y):                                    dydt(1) = y(2);
        th, om = y                                  dydt(2) = -g/l*sin(y(1));
        return [om, -g/l*np.sin(th)]

A state function gives the rates of a state. A component whose rate is another component is a coordinate, and that other
one is its velocity; the rates of the velocities are accelerations. All other assignments are abbreviations and are
written out where they are used, so that they may have names that mean something else in the problem. Columns, and
matrices times columns, are written out by rows; of `acc = A\b` the rows of A acc = b are the equations. Components that
have no name, y(1), are called state_1, ...: they are coordinates in their order. Python, MATLAB and Julia are known.

Calls of methods in symbolic programs are written as functions:

    L.diff(theta.diff(t)).diff(t)          diff(diff(L, diff(theta, t)), t)
    e.simplify()                           e
    LagrangesMethod(L, [x, theta])         diff(diff(L, x'), t) - diff(L, x) = 0, and so with theta
    ad, bd = alpha.diff(), beta.diff()     ad = diff(alpha, t); bd = diff(beta, t)
    [f(q) for q in (x, theta)]             f(x) = 0; f(theta) = 0
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import field

from lagrange.answers.limits import MOST_METHOD_CALLS, MOST_PROGRAM_STATES, MOST_STATEMENTS
from lagrange.core.diagnostics import Fragment
from lagrange.core.records import record
from lagrange.expressions.edits import Draft, closings, cuts
from lagrange.expressions.limits import MAX_ANSWER_CHARACTERS

_IDENT = r"[^\W\d]\w{0,20}"
_FUNCTIONS = r"(?:sin|cos|tan|exp|log|sqrt|abs|sign|zeros)\b"
_HEADER = re.compile(
    rf"\s*(?:def\s+{_IDENT}\s*\((?P<python>[^()]*)\)\s*(?:->[^:]{{0,40}})?:"
    rf"|function\s+(?:(?:\[\s*)?(?P<result>{_IDENT})(?:\s*\])?\s*=\s*)?{_IDENT}!?\s*\((?P<matlab>[^()]*)\)"
    rf"|(?P<name>{_IDENT})\s*=\s*@\s*\((?P<anonymous>[^()]*)\)"
    rf"|{_IDENT}\s*=\s*lambda\s+(?P<lambda>[\w\s,]{{1,60}}):)\s*"
)
_RATES = re.compile(
    rf"\s*(?:d(?P<state>{_IDENT}?)(?:_?dt)?|(?P<dot>{_IDENT}?)_?dot)\s*(?:[(\[]\s*[0-9]\s*[)\]]\s*)?\.?=(?!=)"
)
_DECLARES = re.compile(
    r"\s*(?:import|from|using|global|clear|clc|close|syms|syms?\b|persistent|export|restart|with\s*\(|@\w+|assert|print|plot|end\b"
    r"|nothing\b|else\b|%%)|[^=]*=\s*(?:\w{1,10}\.)?(?:symbols|Function|dynamicsymbols|zeros|zeros_like|empty|empty_like|similar"
    r"|symfun|Symbol|var)\s*\("
)
_COMMENT = re.compile(r"(?:#|%|//)[^\n]*|\"\"\"(?:[^\"]|\"(?!\"\")){0,2000}\"\"\"|'''(?:[^']|'(?!'')){0,2000}'''")
_ASSIGNED = re.compile(rf"\s*(?P<names>{_IDENT}(?:\s*,\s*{_IDENT})*)\s*,?\s*\.?=(?!=)\s*")
_COMPONENT = re.compile(rf"\s*(?P<name>{_IDENT})\s*[(\[]\s*(?P<index>[0-9])\s*[)\]]\s*\.?=(?!=)\s*")
_INDEXED = re.compile(rf"(?<![\w.])(?P<name>(?!d[^\W\d]|{_FUNCTIONS}){_IDENT})\s*[(\[]\s*(?P<index>[0-9])\s*[)\]]")
_RATE_BEFORE = re.compile(rf"(?<![\w.])d{_IDENT}\s*[(\[]\s*(?P<index>[0-9])\s*[)\]]")
_RETURN = re.compile(r"\s*return\b\s*(?=[\[({\w\-+])")
_NAMED_IN_COMMENT = re.compile(
    rf"(?<!\w)(?P<name>{_IDENT})\s*[(\[]\s*(?P<index>[0-9])\s*[)\]]\s*(?:=|:|is)\s*(?P<is>{_IDENT})(?P<rate>'|_?dot)?"
)
_LIST_IN_COMMENT = re.compile(rf"(?<!\w)(?P<name>{_IDENT})\s*=\s*\[(?P<names>[\w\s,;'\u0307]{{1,80}})\]")
_WORD = re.compile(rf"(?<![\w.'])(?:(?:np|numpy|math|sp|sympy)\.)?(?P<name>{_IDENT})")
_CALLS = re.compile(r"(?:np\.|numpy\.|jnp\.|sp\.)?(?:array|asarray|SA|SVector|vstack|hstack|concatenate)\s*(?=[\[(])")
_SOLVE = re.compile(
    r"(?:np\.|numpy\.|scipy\.|sp\.)?linalg\.solve\s*\((?P<inside>.*)\)\s*\Z|(?:\w+\.)*inv\s*\((?P<inverse>[^()]*)\)\s*[*@]\s*(?P<by>.*)\Z"
)
_SINCOS = re.compile(r"\s*sincos\s*\((?P<of>.*)\)\s*\Z")
_CONTINUED = re.compile(r"\.\.\.[ \t]*\n|\\[ \t]*\n")
_COMMA, _SEMICOLON = re.compile(","), re.compile(";|\n")
_STATEMENT = re.compile(r";|\n")
_BLANKS = re.compile(r"\s+(?![-+*/^]\s)(?=[^\s*/^)])(?<![-+*/^(]\s)")
_METHOD = re.compile(r"\.\s*(?P<name>diff|doit|simplify|expand|trigsimp|factor|evalf)\s*(?=\()")
_NAME_BEFORE = re.compile(r"[^\W\d]\w*(?:\.[^\W\d]\w*)?\Z")
_METHOD_OF_LAGRANGE = re.compile(
    r"(?:[^\W\d]\w*\s*=\s*)?(?:\w+\.)*LagrangesMethod\s*\(\s*(?P<function>[^\W\d]\w*)\s*,\s*\[(?P<coordinates>[\w\s,()]{1,80})\]\s*\)"
)
_NAMED_EQUATION = re.compile(
    r"\s*(?P<name>(?:eom|EOM|eqn?|ode|equation|residual)s?(?:_?\w{1,8})?)\s*:?=(?!=)\s*(?P<zero>[^=<>{}\[\]]*[^=<>{}\[\]\s;])\s*;?\s*\Z"
)
_HAS_RATE = re.compile(r"\bdiff\(|''|ddot|\bDerivative\(|[\u0308¨]")
_COMPREHENSION = re.compile(
    r"\s*(?:[^\W\d]\w*\s*=\s*)?\[(?P<expression>[^\[\]]{1,400})\sfor\s+(?P<variable>[^\W\d]\w*)\s+in\s+[\[(]"
    r"(?P<names>[\w\s,]{1,80})[\])]\s*\]\s*\Z"
)
_SEVERAL = re.compile(r"\s*(?P<names>[^\W\d]\w*(?:\s*,\s*[^\W\d]\w*)+)\s*=(?!=)\s*(?P<values>[^=]*)\Z")

Column = list[str]


@record
class _Function:
    """The statements of one state function that have been read so far.

    base      the index of the first component: 0 in Python, 1 in MATLAB and Julia
    known     abbreviation -> what it stands for
    columns   name -> the components of a column, or the rows of a matrix
    named     index -> name of a component of the state
    rates     index -> rate of a component
    rows      equations that are not solved for the rates
    """

    base: int
    known: dict[str, str] = field(default_factory=dict)
    columns: dict[str, list[Column]] = field(default_factory=dict)
    named: dict[int, str] = field(default_factory=dict)
    rates: dict[int, str] = field(default_factory=dict)
    rows: list[str] = field(default_factory=list)


def declares(line: str) -> bool:
    """Whether a line of a program only declares names, and says nothing about the motion."""
    return _DECLARES.match(line) is not None


def equations_of_program(fragment: Fragment) -> list[Fragment]:
    """The equations that a state function in a text states; none if there is no such function."""
    text = fragment.text
    header = next((m for line in _lines(text) if (m := _HEADER.match(text, *line))), None)
    if header is None and not any(_RATES.match(text, *line) for line in _lines(text)):
        return []
    if "\\begin" in text or "$" in text:
        return []
    function = _Function(0 if header and (header["python"] is not None or header["lambda"]) else _first_index(text))
    try:
        _read(text, header, function)
        stated = list(_stated(function))
    except _NotUnderstoodError:
        return []
    return [_in_place_of(fragment, s) for s in stated]


class _NotUnderstoodError(Exception):
    """The program is not a state function of the kind that is known."""


def _first_index(text: str) -> int:
    return 0 if re.search(rf"{_IDENT}\[\s*0\s*\]", text) else 1


def _lines(text: str) -> Iterator[tuple[int, int]]:
    at = 0
    for line in text.split("\n"):
        yield at, at + len(line)
        at += len(line) + 1


def _in_place_of(fragment: Fragment, text: str) -> Fragment:
    draft = Draft(fragment)
    draft.apply([(0, len(fragment.text), text)])
    return draft.finished()


def _read(text: str, header: re.Match[str] | None, function: _Function) -> None:
    """Read the statements."""
    arguments = ""
    if header is not None:
        arguments = header["python"] or header["matlab"] or header["anonymous"] or header["lambda"] or ""
    given = [a.split(":")[0].split("=")[0].strip() for a in arguments.split(",")]
    rates = (header["result"] or "") if header else ""
    if header is not None and header["result"] is None and header["matlab"] is not None:  # f!(du, u, p, t)
        rates, *given = given
    candidates = [a for a in given if a and a != "t"]
    indexed = _INDEXED.search(_COMMENT.sub("", text))
    state = candidates[0] if candidates else indexed["name"] if indexed else ""
    body = text
    if header is not None:
        body = text[header.end() :]
        if header["anonymous"] is not None or header["lambda"] is not None:
            body = f"return {body}"
    for m in _NAMED_IN_COMMENT.finditer(" ".join(_COMMENT.findall(text))):
        function.named.setdefault(int(m["index"]) - function.base, m["is"] + ("'" if m["rate"] else ""))
    body = _CONTINUED.sub(" ", _COMMENT.sub("", body))
    statements = [body[a:b] for a, b in cuts(body, _STATEMENT)]
    for m in _LIST_IN_COMMENT.finditer(" ".join(_COMMENT.findall(text))):
        if m["name"] == state:
            for n, name in enumerate(re.split(r"[\s,;]+", m["names"].strip())):
                function.named.setdefault(n, name)
    if len(statements) > MOST_STATEMENTS:
        raise _NotUnderstoodError
    for statement in statements:
        if not statement.strip() or declares(statement) or _HEADER.match(statement):
            continue
        if returned := _RETURN.match(statement):
            _set_rates(function, statement[returned.end() :], state)
        elif (component := _COMPONENT.match(statement)) and (not rates or component["name"] == rates):
            rates = component["name"]
            value = _written_out(statement[component.end() :], function, state)
            function.rates[int(component["index"]) - function.base] = value
        elif assigned := _ASSIGNED.match(statement):
            names, value = [n.strip() for n in assigned["names"].split(",")], statement[assigned.end() :].strip()
            _assign(function, names, value, state, rates)


def _assign(function: _Function, names: list[str], value: str, state: str, rates: str) -> None:
    plain = re.sub(r"\.T\b|\[:\]|\.tolist\(\)", "", value).strip()
    if len(names) > 1 and re.fullmatch(_IDENT, plain):
        if plain == state:  # otherwise these are parameters
            function.named.update(enumerate(names))
            function.known.update({n: n for n in names})
        return
    if len(names) > 1:
        if sincos := _SINCOS.match(plain):
            of = _written_out(sincos["of"], function, state)
            function.known.update({names[0]: f"sin({of})", names[1]: f"cos({of})"})
            return
        inner = plain[1:-1] if plain[:1] in "[(" and closings(plain).get(0) == len(plain) - 1 else plain
        parts = [inner[a:b] for a, b in cuts(inner, _COMMA)]
        if len(parts) != len(names):
            raise _NotUnderstoodError
        for name, part in zip(names, parts, strict=True):
            _assign(function, [name], part.strip(), state, rates)
        return
    name = names[0]
    if (indexed := _INDEXED.fullmatch(plain)) and indexed["name"] == state:
        function.named[int(indexed["index"]) - function.base] = name
        function.known[name] = name
    elif name == rates or (not rates and _RATES.match(f"{name}=") and "[" in plain):
        _set_rates(function, plain, state)
    elif (column := _column(plain, function, state)) is not None:
        function.columns[name] = column
    else:
        function.known[name] = _in_brackets(_written_out(plain, function, state))


def _set_rates(function: _Function, value: str, state: str) -> None:
    value = value.strip()
    column = _column(value, function, state)
    if column is None:
        inner = value[1:-1] if value.startswith("(") and closings(value).get(0) == len(value) - 1 else value
        parts = [inner[a:b] for a, b in cuts(inner, _COMMA)]
        if len(parts) < 2 and function.rates:
            return
        column = [[_written_out(p, function, state)] for p in parts]
    for n, row in enumerate(column):
        if len(row) != 1:
            raise _NotUnderstoodError
        function.rates[n] = row[0]


def _column(text: str, function: _Function, state: str) -> list[Column] | None:
    """The rows of a column or a matrix; None if the text is a number."""
    text = _CALLS.sub("", text).strip()
    while text.startswith("(") and closings(text).get(0) == len(text) - 1 and "[" in text:
        text = text[1:-1].strip()
    if (solved := _SOLVE.match(text)) or re.search(r"(?<!\\)\\(?!\\)", text):
        return _solved(text, solved, function, state)
    terms = cuts(text, re.compile(r"(?<=[\w)\]\s])\s*[+](?=\s*[^\s])")) if "+" in text else [(0, len(text))]
    if len(terms) > 1:
        columns = [_column(text[a:b].strip(), function, state) for a, b in terms]
        if all(c is None for c in columns):
            return None
        if any(c is None or len(c) != len(columns[0] or ()) for c in columns):
            raise _NotUnderstoodError
        summed = zip(*(c for c in columns if c), strict=True)
        return [[" + ".join(_in_brackets(r[0]) for r in rows if r[0] != "0") or "0"] for rows in summed]
    factors = cuts(text, re.compile(r"[*@]"))
    if len(factors) == 2:
        first, second = (_column(text[a:b].strip(), function, state) for a, b in factors)
        if second is not None:
            if first is None:
                by = _written_out(text[slice(*factors[0])], function, state)
                return [[f"({by})*({c})" for c in row] for row in second]
            if any(len(row) != len(second) for row in first):
                raise _NotUnderstoodError
            entries = [b[0] for b in second]
            if not state and not function.named and all(re.fullmatch(_IDENT, b) for b in entries):
                function.named.update(enumerate(entries))
            return [[_product(row, entries)] for row in first]
    if re.fullmatch(_IDENT, text):
        return function.columns.get(text)
    if not text.startswith("[") or closings(text).get(0) != len(text) - 1:
        return None
    return _literal(text[1:-1].strip(), function, state)


def _product(row: Sequence[str], column: Sequence[str]) -> str:
    """A row of a matrix times a column, without zeros."""
    terms = [b if a == "1" else f"({a})*({b})" for a, b in zip(row, column, strict=True) if a.strip("0.")]
    return " + ".join(terms) or "0"


def _literal(inner: str, function: _Function, state: str) -> list[Column]:
    """`a, b; c, d`, `[a, b], [c, d]`, or `0 1; -c/m -b/m`."""
    if inner.startswith("["):  # rows of Python
        rows = [inner[a:b].strip() for a, b in cuts(inner, _COMMA)]
        if not all(r.startswith("[") and r.endswith("]") for r in rows):
            raise _NotUnderstoodError
        return [[_written_out(r[1:-1][a:b], function, state) for a, b in cuts(r[1:-1], _COMMA)] for r in rows]
    rows = [inner[a:b].strip() for a, b in cuts(inner, _SEMICOLON)]
    rows = [r for r in rows if r]
    matrix: list[Column] = []
    for row in rows:
        parts = [row[a:b].strip() for a, b in cuts(row, _COMMA)]
        if len(parts) == 1 and len(rows) > 1 and " " in row:
            parts = [row[a:b] for a, b in cuts(row, _BLANKS)]
        matrix.append([p for p in parts if p])
    if len(matrix) == 1:  # one row is a column: [v, a]
        matrix = [[p] for p in matrix[0]]
    written: list[Column] = []
    for cells in matrix:
        if len(cells) == 1 and cells[0] in function.columns:
            written += function.columns[cells[0]]
        else:
            written.append([_written_out(c, function, state) for c in cells])
    return written


def _solved(text: str, solved: re.Match[str] | None, function: _Function, state: str) -> list[Column]:
    r"""`A\b`, `solve(A, b)` or `inv(A)*b`: unknowns, and A times them is b."""
    if solved is None:
        sides = [text[a:b] for a, b in cuts(text, re.compile(r"\\"))]
    elif solved["inside"] is not None:
        sides = [solved["inside"][a:b] for a, b in cuts(solved["inside"], _COMMA)]
    else:
        sides = [solved["inverse"], solved["by"]]
    if len(sides) != 2:
        raise _NotUnderstoodError
    matrix, column = (_column(s.strip(), function, state) for s in sides)
    if matrix is None or column is None or any(len(row) != len(column) for row in matrix):
        raise _NotUnderstoodError
    first = len(function.rows)
    unknown = [f"solved_{first + n + 1}" for n in range(len(column))]
    for row, right in zip(matrix, column, strict=True):
        left = " + ".join(f"({a})*{u}" for a, u in zip(row, unknown, strict=True))
        function.rows.append(f"{left} = {right[0]}")
    return [[u] for u in unknown]


def _written_out(text: str, function: _Function, state: str) -> str:
    """An expression without abbreviations."""
    text = text.strip().rstrip(";, ")

    def component(match: re.Match[str]) -> str:
        name, index = match["name"], int(match["index"]) - function.base
        if name == state:
            return _component(index, function)
        if name in function.columns and 0 <= index < len(function.columns[name]):
            return _in_brackets(function.columns[name][index][0])
        return match[0]

    def earlier(match: re.Match[str]) -> str:
        index = int(match["index"]) - function.base
        return _in_brackets(function.rates[index]) if index in function.rates else match[0]

    text = _RATE_BEFORE.sub(earlier, _INDEXED.sub(component, text))

    def known(match: re.Match[str]) -> str:
        value = function.known.get(match["name"])
        return match["name"] if value is None else value

    written = _WORD.sub(known, text)
    if len(written) > MAX_ANSWER_CHARACTERS:
        raise _NotUnderstoodError
    return written.strip()


def _component(index: int, function: _Function) -> str:
    return function.named.setdefault(index, f"state_{index + 1}")


def _in_brackets(text: str) -> str:
    return text if re.fullmatch(r"\w+", text) else f"({text})"


def _stated(function: _Function) -> Iterator[str]:
    """The equations of motion."""
    size = len(function.rates)
    if not 0 < size <= MOST_PROGRAM_STATES or sorted(function.rates) != list(range(size)):
        raise _NotUnderstoodError
    names = [_component(n, function) for n in range(size)]
    velocities: dict[str, str] = {}
    for n in range(size):
        rate = function.rates[n].strip("() ")
        if rate in names and rate != names[n]:
            velocities[rate] = names[n]
    unnamed = [c for c in names if c.startswith("state_") and c not in velocities]
    numbered = {c: f"state_{k}" for k, c in enumerate(unnamed, 1)}
    final: dict[str, str] = {**numbered, **{v: f"{numbered.get(c, c)}'" for v, c in velocities.items()}}
    for n in range(size):
        if function.rates[n].strip("() ") in velocities:
            continue
        rate = _renamed(function.rates[n], final)
        left = f"{_renamed(names[n], final)}'"
        if (unknown := rate.strip("() ")).startswith("solved_"):
            final[unknown] = left
        else:
            yield f"{left} = {rate}"
    yield from (_renamed(row, final) for row in function.rows)


def _renamed(text: str, names: Mapping[str, str]) -> str:
    return _WORD.sub(lambda m: names.get(m["name"], m["name"]), text)


# Symbolic programs


def as_functions(draft: Draft) -> None:
    """Write the method calls of an equation as functions, the inner ones first."""
    for _ in range(MOST_METHOD_CALLS):
        text = draft.text
        calls = list(_METHOD.finditer(text))
        ends = closings(text) if calls else {}
        begins = {end: start for start, end in ends.items()}
        for match in calls:
            stop = ends.get(match.end())
            if stop is None or _METHOD.search(text, match.end(), stop):
                continue
            start = _receiver(text, match.start(), begins)
            if start == match.start():
                continue
            given = text[match.end() + 1 : stop].strip()
            if match["name"] == "diff":
                draft.apply(
                    [
                        (start, start, "diff("),
                        (match.start(), match.end() + 1, ", "),
                        (stop, stop, "" if given else "t"),
                    ]
                )
            else:
                draft.apply([(match.start(), stop + 1, "")])
            break
        else:
            return


def _receiver(text: str, end: int, begins: dict[int, int]) -> int:
    """Where the object of a method begins: a name, a call, or an expression in parentheses."""
    while end > 0 and text[end - 1] == " ":
        end -= 1
    if end > 0 and text[end - 1] == ")" and end - 1 in begins:
        end = begins[end - 1]
    name = _NAME_BEFORE.search(text, max(0, end - 60), end)
    return name.start() if name else end


def by_method_of_lagrange(text: str) -> list[str]:
    """Lagrange's equations as `LagrangesMethod(L, [x, y])` computes them; none if it also has forces."""
    match = _METHOD_OF_LAGRANGE.search(text)
    if match is None:
        return []
    names = [q.split("(")[0].strip() for q in match["coordinates"].split(",") if q.strip()]
    function = match["function"]
    return [f"diff(diff({function}, {q}'), t) - diff({function}, {q}) = 0" for q in names]


def as_equation(draft: Draft, declared: Collection[str]) -> None:
    """`eom = m*diff(x, t, 2) + k*x` as m*diff(x, t, 2) + k*x = 0: programs name what vanishes."""
    match = _NAMED_EQUATION.match(draft.text)
    if match and match["name"] not in declared and _HAS_RATE.search(match["zero"]):
        draft.apply([(0, match.start("zero"), ""), (match.end("zero"), match.end("zero"), " = 0")])


def by_comprehension(text: str) -> list[str]:
    """The equations that `[L.diff(q.diff(t)).diff(t) - L.diff(q) for q in (x, y)]` makes, each zero."""
    match = _COMPREHENSION.match(text)
    if match is None or "for" in match["expression"].split():
        return []
    own = re.compile(rf"(?<![\w.]){re.escape(match['variable'])}(?!\w)")
    names = [q.strip() for q in match["names"].split(",") if q.strip()]
    expression = match["expression"].strip()
    zero = "" if re.search(r"(?<![<>=!])=|\bEq\(", expression) else " = 0"
    return [own.sub(q, expression) + zero for q in names]


def one_by_one(text: str) -> Iterator[tuple[int, int, int, int]]:
    """The positions of each name and its value in `a, b = c, d`; none if the text is no such assignment."""
    match = _SEVERAL.match(text)
    if match is None:
        return
    names = cuts(match["names"], _COMMA)
    values = cuts(match["values"], _COMMA)
    if len(names) == len(values):
        first, second = match.start("names"), match.start("values")
        for (a, b), (c, d) in zip(names, values, strict=True):
            yield first + a, first + b, second + c, second + d
