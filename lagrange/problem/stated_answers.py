"""Reading stated answers: the `answers` of a problem file, its reference system `equations`, and files of answers.

    degrees_of_freedom: 1
    classification: [holonomic, scleronomic]
    equations: ["theta'' + g/l*sin(theta) = 0"]

A file of answers has the keys of `answers`, at its top level or under `answers:`. Equations stay text, because they are
read and judged like anybody's answer, and they may be in LaTeX. In a problem file an equation that cannot be read is a
mistake of the file; in a file of answers it is not, because the verdict on it says so and the others still count. Other
mistakes (an unknown key, a list where a value belongs) are errors in both.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import Any, TypeVar

import sympy as sp

from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError, Source, suggestion
from lagrange.core.symbols import Sign
from lagrange.core.units import has_unit, split_number, unit_of
from lagrange.expressions.latex_layout import OneEquation, equations, is_latex
from lagrange.expressions.limits import MAX_ANSWER_CHARACTERS
from lagrange.expressions.reader import Scope, limit_of, read_equation, read_value
from lagrange.problem.diagnostic_collector import Diagnostics, EnoughError
from lagrange.problem.keys import ANSWERS, CLASSES, POINTS
from lagrange.problem.limits import MOST_SIGNS
from lagrange.problem.load_context import FragmentReader, LoadContext, canonical
from lagrange.problem.model import Answers, Choice, Constraint, Problem, Question, Weight
from lagrange.problem.questions import scope_of_questions
from lagrange.problem.sections import Section, entries_of, items_of, mapping_of, scalar_of, wrong_kind
from lagrange.problem.yaml.composer import parse
from lagrange.problem.yaml.nodes import ListNode, MappingNode, Node, Scalar
from lagrange.problem.yaml.words import classes_in, truth_in, whole_number_in

_OPPOSITES = tuple(zip(CLASSES[::2], CLASSES[1::2], strict=True))

T = TypeVar("T")


class AnswerReader:
    """Reads what is to be compared with the solution. `constraints` are those that could be read.

    tries  whether an equation that cannot be read is a mistake of the file; otherwise the verdict on it says so
    """

    def __init__(
        self,
        context: LoadContext,
        constraints: tuple[Constraint, ...],
        choices: tuple[Choice, ...],
        scope: Scope,
        questions: tuple[Question, ...] = (),
        *,
        tries: bool = True,
    ) -> None:
        self.context = context
        self.diagnostics = context.diagnostics
        self.components: dict[str, list[str]] = {name: [] for name in context.constraints.known()}
        for c in constraints:
            self.components.setdefault(_vector_equation(c.name), []).append(c.name)
        self.by_reaction = {c.reaction.name: c.name for c in constraints}
        self.tries = tries
        self.scope = _scope_of_answers(scope, choices)
        self.questions = {q.name: q for q in questions}
        self.asking = scope_of_questions(self.scope, constraints, choices)

    def answers(self, node: Node | None) -> Answers | None:
        """The section `answers`; None if there is none."""
        if node is None:
            return None
        mapping = self.diagnostics.attempt(lambda: mapping_of(node, "`answers`", "answers: {degrees_of_freedom: 1}"))
        if mapping is None:
            return None
        section = Section(mapping, "the answers", ANSWERS, self.diagnostics)
        freedom = section.get("degrees_of_freedom")
        return Answers(
            degrees_of_freedom=self.diagnostics.attempt(lambda: self._freedom(freedom)) if freedom else None,
            classification=self._classification(section.get("classification")),
            integrable=self._of_constraints(section.get("integrable"), "integrable", "rod: true", self._truth),
            equations=self.equations(section.get("equations"), "`equations`"),
            equilibrium=self._equilibrium(section.get("equilibrium")),
            reactions=self._of_constraints(section.get("reactions"), "reactions", "rod: m*g", self._reaction),
            frequencies=self._frequencies(section.get("frequencies")),
            decay=self._frequencies(section.get("decay"), "`decay`", '["c/(2*m)"]'),
            ask=self._asked(section.get("ask")),
            rest=self._rest(section.get("rest")),
            steady=self._equilibrium(section.get("steady"), "`steady`"),
            hamiltonian=self._one(section.get("hamiltonian"), "`hamiltonian`"),
            kinetic_energy=self._one(section.get("kinetic_energy"), "a kinetic energy"),
            generalized_forces=self._by_coordinates(section.get("generalized_forces")),
            conserved=self._texts(section.get("conserved"), "`conserved`", '["m*r^2*phi\' = const"]'),
            virtual_displacements=self.equations(section.get("virtual_displacements"), "`virtual_displacements`"),
            response=self._named(section.get("response"), "`response`", "response: {x: F_0/(k - m*w^2)}"),
            impact=self._named(section.get("impact"), "`impact`", "impact: {x': J/m}"),
        )

    def _freedom(self, node: Node) -> int:
        """A number of degrees of freedom; in a file of answers in words, too."""
        stated = whole_number_in(node.text) if isinstance(node, Scalar) and not self.tries else None
        return _whole_number(node) if stated is None else stated

    def _truth(self, node: Node) -> bool:
        stated = truth_in(node.text) if isinstance(node, Scalar) and not self.tries else None
        return _truth_value(node) if stated is None else stated

    def points(self, node: Node | None) -> tuple[Weight, ...]:
        """The section `points`: a weight for each part, or for each statement of a part by its name."""
        if node is None:
            return ()
        mapping = self.diagnostics.attempt(lambda: mapping_of(node, "`points`", EXAMPLE_OF_POINTS))
        if mapping is None:
            return ()
        section = Section(mapping, "`points`", POINTS, self.diagnostics)
        weights: list[Weight] = []
        for part in POINTS.names:
            value = section.get(part)
            if isinstance(value, MappingNode) and part in ("ask", "reactions"):
                weights += self._named_points(part, value)
            elif value is not None:
                points = self.diagnostics.attempt(partial(_points, value, f"`{part}`"))
                weights += [Weight(part, "", points)] if points is not None else []
        return tuple(weights)

    def _named_points(self, part: str, node: MappingNode) -> Iterator[Weight]:
        """The weights of questions, or of reactions; that of a vector equation is shared by its components."""
        for key, value in node.entries:
            names = self.diagnostics.attempt(
                partial(self._constraints if part == "reactions" else self._questions, key)
            )
            points = self.diagnostics.attempt(partial(_points, value, f"`{key.text}`"))
            if names and points is not None:
                yield from (Weight(part, name, points / len(names)) for name in names)

    def _questions(self, scalar: Scalar) -> list[str]:
        """The question that a name means."""
        name = canonical(scalar.text, self.questions)
        if name not in self.questions:
            if self.context.names.has_failed(scalar.text):
                return []
            message = f"`{scalar.text}` is not a question of this file"
            help_ = suggestion(name, list(self.questions), "questions")
            raise ProblemError(Diagnostic("unknown-name", message, scalar.span, help=help_))
        return [name]

    def _one(self, node: Node | None, what: str) -> Fragment | None:
        """One text, which is read when it is judged."""
        if node is None:
            return None
        scalar = self.diagnostics.attempt(lambda: scalar_of(node, what))
        return scalar.fragment if scalar is not None else None

    def _texts(self, node: Node | None, what: str, example: str) -> tuple[Fragment, ...]:
        """A list of texts, or one text, which are read when they are judged."""
        if node is None:
            return ()
        items = (node,) if isinstance(node, Scalar) else self.diagnostics.attempt(lambda: items_of(node, what, example))
        read = (self._one(item, f"an entry of {what}") for item in items or ())
        return tuple(fragment for fragment in read if fragment is not None)

    def _by_coordinates(self, node: Node | None) -> Mapping[str, Fragment]:
        """name of a coordinate -> the generalized force of it."""
        if node is None:
            return {}
        what, example = "`generalized_forces`", "generalized_forces: {theta: -m*g*l*sin(theta)}"
        entries = self.diagnostics.attempt(lambda: entries_of(node, what, example))
        known = {q.name: q.name for q in self.scope.slots.coordinates}
        forces = {canonical(key.text, known): self._one(value, "a generalized force") for key, value in entries or ()}
        return {name: fragment for name, fragment in forces.items() if fragment is not None}

    def _named(self, node: Node | None, what: str, example: str) -> Mapping[str, Fragment]:
        """name -> a text, which is read when it is judged."""
        if node is None:
            return {}
        entries = self.diagnostics.attempt(lambda: entries_of(node, what, example))
        texts = {key.text: self._one(value, f"an entry of {what}") for key, value in entries or ()}
        return {name: fragment for name, fragment in texts.items() if fragment is not None}

    def _rest(self, node: Node | None) -> tuple[Fragment, ...]:
        """Conditions of rest: a list of inequalities or equations, or one."""
        if node is None:
            return ()
        what, example = "`rest`", '["tan(alpha) <= mu_s"]'
        read = (node,) if isinstance(node, Scalar) else self.diagnostics.attempt(lambda: items_of(node, what, example))
        stated = (self.diagnostics.attempt(partial(self._condition, item)) for item in read or ())
        return tuple(fragment for fragment in stated if fragment is not None)

    def _condition(self, node: Node) -> Fragment:
        fragment = scalar_of(node, "an entry of `rest`").fragment
        if self.tries:
            self._try(read_equation, limit_of(fragment, "a condition", strict=True)[0])
        return fragment

    def equations(self, node: Node | None, what: str) -> tuple[Fragment, ...]:
        """Equations: a list of texts, or one text."""
        if node is None:
            return ()
        items = (
            (node,)
            if isinstance(node, Scalar)
            else self.diagnostics.attempt(lambda: items_of(node, what, "[\"theta'' + g/l*sin(theta) = 0\"]"))
        )
        read = (self.diagnostics.attempt(partial(self._equation, item, what)) for item in items or ())
        return tuple(fragment for fragment in read if fragment is not None)

    def _equation(self, node: Node, what: str) -> Fragment:
        fragment = scalar_of(node, f"an entry of {what}").fragment
        self._try(read_equation, fragment)
        return fragment

    def _asked(self, node: Node | None) -> Mapping[str, Fragment]:
        """name of a question -> its answer, an expression for the quantity or an equation."""
        if node is None:
            return {}
        answers: dict[str, Fragment] = {}
        entries = self.diagnostics.attempt(lambda: entries_of(node, "`ask`", 'ask: {leaves: "cos(theta) = 2/3"}'))
        for key, value in entries or ():
            scalar = self.diagnostics.attempt(partial(scalar_of, value, "an answer"))
            names = self.diagnostics.attempt(partial(self._questions, key))
            if names and scalar is not None:
                if not has_unit(scalar.fragment.text):
                    self._try_asked(scalar.fragment)
                answers[names[0]] = scalar.fragment
        return answers

    def _try_asked(self, fragment: Fragment) -> None:
        """Reads an answer to a question to find its mistakes; the name of the question may be its left side."""
        if self.tries and "=" not in fragment.text:
            self.diagnostics.attempt(
                lambda: self.context.read_quietly(partial(read_value, latex=True), fragment, self.asking, [])
            )

    def _reaction(self, node: Node) -> Fragment:
        """A reaction as an expression, or as an equation `T = ...`."""
        fragment = scalar_of(node, "a reaction").fragment
        self._try(read_equation if "=" in fragment.text else read_value, fragment)
        return fragment

    def _try(self, reader: FragmentReader[Any], fragment: Fragment) -> None:
        """Reads an answer only to find its mistakes: notes on how it is read belong to the verdict on it."""
        if not self.tries:
            return
        limited: FragmentReader[Any] = partial(read_value, latex=True)
        if reader is read_equation:
            limited = partial(read_equation, limit=MAX_ANSWER_CHARACTERS, latex=True)
        for equation in equations(fragment):
            try:
                self.context.read_quietly(limited, equation, self.scope, [])
            except ProblemError:
                plain = without_units(equation)
                if plain is equation:
                    raise
                self.context.read_quietly(limited, plain, self.scope, [])

    def _equilibrium(self, node: Node | None, what: str = "`equilibrium`") -> tuple[tuple[Fragment, ...], ...]:
        """Nested lists are alternatives; a flat list is one system."""
        if isinstance(node, ListNode) and any(isinstance(item, ListNode) for item in node.items):
            if not all(isinstance(item, ListNode) for item in node.items):
                help_ = "write `[a, b]` for one system, `[[a], [b]]` for alternatives"
                self.diagnostics.report(wrong_kind(node, f"{what} mixes equations with lists of equations", help_))
            return tuple(self.equations(item, what) for item in node.items)
        flat = self.equations(node, what)
        return (flat,) if flat else ()

    def _frequencies(
        self, node: Node | None, what: str = "`frequencies`", example: str = '["sqrt(g/l)"]'
    ) -> tuple[tuple[Fragment, ...], ...]:
        """Expressions for ω, or for decay rates; nested lists are those of several equilibria."""
        if node is None:
            return ()
        read = (node,) if isinstance(node, Scalar) else self.diagnostics.attempt(lambda: items_of(node, what, example))
        items = list(read or ())
        if any(isinstance(item, ListNode) for item in items):
            lists = [item for item in items if isinstance(item, ListNode)]
            if len(lists) < len(items):
                help_ = "write `[a, b]` for one equilibrium, `[[a, b], [c]]` for several"
                self.diagnostics.report(wrong_kind(node, f"{what} mixes expressions with lists of them", help_))
            return tuple(tuple(self._values(item.items, what)) for item in lists)
        return (tuple(self._values(items, what)),)

    def _values(self, nodes: Sequence[Node], what: str) -> Iterator[Fragment]:
        """The texts of expressions that can be read."""
        for node in nodes:
            scalar = self.diagnostics.attempt(lambda n=node: scalar_of(n, f"an entry of {what}"))  # type: ignore[misc]
            if scalar is not None:
                value = _without_letter(scalar.fragment)
                try:
                    self._try(read_value, value)
                except ProblemError as error:
                    raise ProblemError([_of_frequency(d) for d in error.diagnostics]) from None
                yield scalar.fragment

    def _classification(self, node: Node | None) -> tuple[str, ...]:
        """The classification, in the words of the textbook."""
        if node is None:
            return ()
        example = "classification: [holonomic, scleronomic]"
        if isinstance(node, MappingNode) and not self.tries:
            node = _as_list(node)
        items = (
            (node,)
            if isinstance(node, Scalar)
            else self.diagnostics.attempt(lambda: items_of(node, "`classification`", example))
        )
        words: dict[str, Scalar] = {}
        for item in items or ():
            loose = classes_in(item.text) if isinstance(item, Scalar) and not self.tries else ()
            if loose and isinstance(item, Scalar):
                words |= {word: item for word in loose if word not in words}
                continue
            scalar = self.diagnostics.attempt(lambda i=item: _class(i))  # type: ignore[misc]
            if scalar is not None:
                words.setdefault(scalar.text, scalar)
        for pair in _OPPOSITES:
            if all(word in words for word in pair):
                message = f"a system is not both {pair[0]} and {pair[1]}"
                last = max((words[w] for w in pair), key=lambda s: s.span.start)
                self.diagnostics.report(
                    Diagnostic("contradictory-answer", message, last.span, help="keep one of the two")
                )
        return tuple(words)

    def _of_constraints(self, node: Node | None, key: str, example: str, read: Callable[[Node], T]) -> Mapping[str, T]:
        """name of a constraint -> its answer; an answer for a vector equation counts for all its components."""
        if node is None:
            return {}
        answers: dict[str, T] = {}
        entries = self.diagnostics.attempt(lambda: entries_of(node, f"`{key}`", f"{key}: {{{example}}}"))
        for name, value in entries or ():
            answer = self.diagnostics.attempt(partial(read, value))
            names = self.diagnostics.attempt(partial(self._constraints, name))
            if answer is not None and names is not None:
                answers |= dict.fromkeys(names, answer)
        return answers

    def _constraints(self, scalar: Scalar) -> list[str]:
        """The constraints that a name means: one, also by its reaction, or the components of a vector equation."""
        name = canonical(scalar.text, self.components)
        if name in self.components:
            return self.components[name]
        known = [c for names in self.components.values() for c in names]
        if name in known or (_vector_equation(name) in self.components and not self.components[_vector_equation(name)]):
            return [name]
        if reacting := self.by_reaction.get(name):
            return [reacting]
        if self.context.names.has_failed(scalar.text):
            return []
        help_ = suggestion(name, list(dict.fromkeys((*self.components, *known))), "constraints")
        raise ProblemError(
            Diagnostic("unknown-name", f"`{scalar.text}` is not a constraint of this file", scalar.span, help=help_)
        )


def _vector_equation(name: str) -> str:
    """The name of the constraint that a component belongs to."""
    return name.split(".", 1)[0]


def _scope_of_answers(scope: Scope, choices: tuple[Choice, ...]) -> Scope:
    """The names that an answer may use, with the coordinates of the choices and the signs of their square roots."""
    new = [q for c in choices for q in c.coordinates]
    slots = replace(scope.slots, coordinates=tuple(dict.fromkeys((*scope.slots.coordinates, *new))))
    signs: dict[str, sp.Expr] = {}
    if any(c.substitute is None for c in choices):
        signs = {f"sigma_{n}": Sign(f"sigma_{n}") for n in range(1, MOST_SIGNS)}
    return replace(scope, slots=slots, scalars=signs | dict(scope.scalars))


def _as_list(node: MappingNode) -> Node:
    """`{holonomic: true, scleronomic: no}` as the list of what it says; another mapping as it is."""
    opposite = dict((*_OPPOSITES, *((b, a) for a, b in _OPPOSITES)))
    words: list[Scalar] = []
    for key, value in node.entries:
        holds = truth_in(value.text) if isinstance(value, Scalar) else None
        named = classes_in(key.text)
        if holds is None or len(named) != 1:
            return node
        words.append(replace(key, text=named[0] if holds else opposite[named[0]]))
    return ListNode(tuple(words), node.span)


def _whole_number(node: Node) -> int:
    scalar = scalar_of(node, "`degrees_of_freedom`")
    if not scalar.text.isascii() or not scalar.text.isdigit() or len(scalar.text) > 4:
        message = f"`{scalar.text}` is not a whole number"
        raise ProblemError(Diagnostic("not-a-number", message, scalar.span, help="write a number such as `2`"))
    return int(scalar.text)


def _points(node: Node, what: str) -> Fraction:
    """A number of points: at most four digits and two decimals, and not zero."""
    scalar = scalar_of(node, f"the points for {what}")
    if not re.fullmatch(r"[0-9]{1,4}(?:\.[0-9]{1,2})?", scalar.text, re.ASCII) or not Fraction(scalar.text):
        message = f"`{scalar.text}` is not a number of points"
        help_ = "write a positive number below 10,000 with at most two decimals, such as `2` or `1.5`"
        raise ProblemError(Diagnostic("not-a-number", message, scalar.span, help=help_))
    return Fraction(scalar.text)


def _class(node: Node) -> Scalar:
    scalar = scalar_of(node, "a class")
    if scalar.text not in CLASSES:
        help_ = suggestion(scalar.text, CLASSES, "classes")
        raise ProblemError(
            Diagnostic("unknown-class", f"`{scalar.text}` is not a class of systems", scalar.span, help=help_)
        )
    return scalar


def _truth_value(node: Node) -> bool:
    scalar = scalar_of(node, "`integrable`")
    if scalar.text not in ("true", "false"):
        message = f"`{scalar.text}` is neither `true` nor `false`"
        raise ProblemError(Diagnostic("not-a-truth-value", message, scalar.span, help="write `true` or `false`"))
    return scalar.text == "true"


def _of_frequency(mistake: Diagnostic) -> Diagnostic:
    """A mistake in a stated frequency; where it is imaginary, the help tells what can be stated."""
    help_ = "state the real frequencies only: a root with omega^2 < 0 grows as an exponential function, and is left out"
    return replace(mistake, help=help_) if mistake.code == "not-real" else mistake


_LETTER_OF_FREQUENCY = re.compile(
    r"\s*(?:omega|Omega|[ωΩ]|w|f|nu|ν|T|sigma|σ|delta|δ|tau|τ)(?:_?\w{1,6})?(?:\s*\^\s*2)?\s*=(?!=)"
)
"""`omega^2 = `, before the value itself."""
EXAMPLE_OF_POINTS = "points: {equations: 6, degrees_of_freedom: 1}"
EXAMPLE = "equations: [\"theta'' + g/l*sin(theta) = 0\"]"


def read_answers(source: Source, problem: Problem) -> Answers:
    """The answers that a text gives to a problem. Raises ProblemError with all its mistakes."""
    diagnostics = Diagnostics()
    answers = None
    with suppress(EnoughError):
        answers = diagnostics.attempt(lambda: _answers(source, problem, diagnostics))
    diagnostics.stop_if_any()
    if answers is None or answers == Answers():
        help_ = f"give one, such as `{EXAMPLE}`"
        raise ProblemError(Diagnostic("no-answer", f"there is no answer in {source.name}", help=help_))
    return answers


def _answers(source: Source, problem: Problem, diagnostics: Diagnostics) -> Answers | None:
    root = parse(source, diagnostics, what="an answer file", needs=f"the keys are those of `answers`: `{EXAMPLE}`")
    context = LoadContext(diagnostics)
    questions = problem.questions
    reader = AnswerReader(context, problem.constraints, problem.choices, problem.scope, questions, tries=False)
    return reader.answers(_inside(root))


def _inside(root: MappingNode) -> Node:
    """The value of `answers`, where that is the only key."""
    if len(root.entries) == 1 and root.entries[0][0].text == "answers":
        return mapping_of(root.entries[0][1], "`answers`", f"answers: {{{EXAMPLE}}}")
    return root


# -- Numbers with units among stated answers: `P <= 117.7 N`, `s = 12 in`, `theta = 24.75 deg` -------------------------
#
# An answer is read when the file is loaded, so that its mistakes are reported with the others; what the unit means is
# known only when the answer is judged, by the dimension of what it is compared with. So the number stands for it
# here.


_SIDE = re.compile(r"[^=<>≤≥⩽⩾]+")


def _without_letter(fragment: Fragment) -> Fragment:
    """A frequency without the letter and the sign of equality before it."""
    named = _LETTER_OF_FREQUENCY.match(fragment.text)
    if not named:
        return fragment
    from lagrange.expressions.edits import cut

    return cut(fragment, named.end(), len(fragment.text))


def without_units(fragment: Fragment) -> Fragment:
    """The text with each side that is a number with a known unit as the number alone."""
    if is_latex(fragment) or isinstance(fragment, OneEquation):
        return fragment
    from lagrange.expressions.edits import Draft

    draft = Draft(fragment)
    for side in [*_SIDE.finditer(fragment.text)][::-1]:
        text = side[0].rstrip()
        parts = split_number(text)
        if parts is not None and unit_of(parts[1]) is not None:
            draft.apply([(side.start(), side.start() + len(text), f" {parts[0]}")])
    return draft.finished(latex=False) if draft.text != fragment.text else fragment
