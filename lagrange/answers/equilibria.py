"""The equilibria of an answer: are they right, and complete?

An answer is a system of equations, or several alternative ones: nested lists in a file, `theta = 0 or theta = pi` in
one equation. It is compared with the equilibria in the file's coordinates and in every choice
(`EquilibriumComparison`), and the best verdict counts. In θ = atan(u) the principal value is meant; if that leaves
something out, the answer is also read as tan θ = u.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import replace
from itertools import combinations, product

import sympy as sp

from lagrange.algebra.closed_forms.polynomial_roots import without_squares
from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.zero_test import DivisionByZeroError, NoPointError, UnsupportedError
from lagrange.answers.equilibrium_comparison import EquilibriumComparison
from lagrange.answers.limits import (
    MAX_ALTERNATIVES,
    MAX_EQUATIONS,
    MOST_NUMERICAL_ROOTS,
    UNITS_OF_EXPLAINING,
)
from lagrange.answers.models.letters import geometry_of, letter_variations
from lagrange.answers.models.mechanics import Variation
from lagrange.answers.other_angles import widened_system
from lagrange.answers.readings import (
    GivenEquation,
    Reading,
    decimals_in,
    displaced_coordinates,
    is_radius,
    read_answer,
    without_displacements,
)
from lagrange.answers.references import Reference
from lagrange.answers.results.contradictions import with_contradictions, with_factors_of_parameters
from lagrange.answers.verdicts import (
    MIXED_CHOICES,
    NOT_JUDGED,
    REST,
    STEADY_MOTION,
    WORST_TO_BEST,
    AnswerVerdict,
    EquationVerdict,
    Subject,
    Verdict,
)
from lagrange.answers.written.decimals import as_written, remark_on
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.effort import within
from lagrange.core.symbols import Decimal, Sign, Unspecified
from lagrange.core.symbols import variation as virtual_displacement
from lagrange.document.math_writer import text
from lagrange.document.names import Notation
from lagrange.expressions.edits import Draft
from lagrange.expressions.latex_layout import ALTERNATIVE, is_latex, piece
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from lagrange.problem.model import Problem

_ALL_ANGLES = "only one of the angles with this tangent, sine or cosine is given; all of them are taken to be meant"
_BRANCH = "it is right on one of the two branches of the square root: {} = {:+d}"


def alternatives_of(answer: Sequence[Fragment]) -> list[tuple[Fragment, ...]]:
    """The alternatives of a flat list in which an equation may read `theta = 0 or theta = pi`.

    Raises ProblemError if there are too many.
    """
    parts = [[one for part in _split(f) for one in with_both_signs(part)] for f in answer]
    total = 1
    for p in parts:
        total *= len(p)
    if total > MAX_ALTERNATIVES:
        message = f"an answer may have {MAX_ALTERNATIVES} alternatives; this one has {total}"
        raise ProblemError(Diagnostic("too-many-equations", message, answer[0].whole))
    return [tuple(choice) for choice in product(*parts)]


def _split(fragment: Fragment) -> list[Fragment]:
    if isinstance(fragment, GivenEquation):
        return [fragment]
    latex = is_latex(fragment)
    parts, start = [], 0
    for match in [*re.finditer(ALTERNATIVE if latex else r"(?<![\w\\])or(?![\w'])", fragment.text), None]:
        end = match.start() if match else len(fragment.text)
        begin = None if fragment.start is None else fragment.start + start
        text = fragment.text[start:end].strip()
        parts.append(piece(fragment, start, end) if latex else replace(fragment, text=text, start=begin))
        start = match.end() if match else end
    return parts


def with_both_signs(fragment: Fragment) -> list[Fragment]:
    """An equation with ± as two, with all upper and all lower signs."""
    if isinstance(fragment, GivenEquation) or not _PLUS_MINUS.search(fragment.text):
        return [fragment]
    both = []
    for upper, lower in (("+", "-"), ("-", "+")):
        draft = Draft(fragment)
        draft.replace(_PLUS_MINUS, lambda m, u=upper, l=lower: l if m[0].strip() in ("∓", r"\mp") else u)  # type: ignore[misc]
        both.append(draft.finished(latex=is_latex(fragment)))
    return both


_PLUS_MINUS = re.compile(r"[±∓]|\\(?:pm|mp)(?![A-Za-z])|\+/-|\+-(?=\s?sqrt)")


def check_equilibria(
    alternatives: Sequence[Sequence[Fragment]], equilibria: Sequence[Equilibrium], reference: Reference
) -> AnswerVerdict:
    """The verdict on an answer; `equilibria` are those in the file's coordinates and in each choice.

    Raises ProblemError if there are no equations, or too many.
    """
    flat = [f for a in alternatives for f in a]
    if not flat:
        raise ProblemError(
            Diagnostic("no-answer", "there is no equation to check", help="give equations with -e, or in a file")
        )
    if len(alternatives) > MAX_ALTERNATIVES or any(len(a) > MAX_EQUATIONS for a in alternatives):
        message = f"an answer may have {MAX_EQUATIONS} equations"
        raise ProblemError(Diagnostic("too-many-equations", message, flat[0].whole))
    alternatives = [tuple(choice) for a in alternatives for choice in product(*map(with_both_signs, a))]
    readings, more = [*zip(*(_read(a, reference) for a in alternatives), strict=True)]
    notes = (*(n for a in readings for r in a for n in r.notes), *(n for several in more for n in several))
    errors = tuple(d for a in readings for r in a if r.error for d in r.error.diagnostics)
    if errors:
        return _unreadable(readings, errors, notes)
    solved = [e for e in equilibria if e.branches] or equilibria
    best = _best(readings, solved, reference)
    if best is None:
        equations = tuple(EquationVerdict(r.text, Verdict.UNREADABLE, MIXED_CHOICES) for a in readings for r in a)
        return AnswerVerdict(Verdict.UNREADABLE, equations, notes=notes)
    best = with_contradictions(best, readings, lambda systems: _best(systems, solved, reference))
    best = with_factors_of_parameters(best, readings, solved)
    if best.verdict is Verdict.WRONG and [len(a) for a in readings] == [1]:
        from lagrange.answers.results.at_random import with_sign_of_root

        best = with_sign_of_root(best, readings[0][0], solved)
    return replace(best, notes=notes)


def _best(
    readings: Sequence[Sequence[Reading]], equilibria: Sequence[Equilibrium], reference: Reference
) -> AnswerVerdict | None:
    """The best of the verdicts in each set of coordinates; None if no set covers all that the answer uses."""
    tried = [v for e in equilibria if (v := _tried(readings, e, reference)) is not None]
    return max(tried, key=lambda v: WORST_TO_BEST.index(v.verdict), default=None)


def check_steady_answers(
    alternatives: Sequence[Sequence[Fragment]], conditions: Sequence[Equilibrium], reference: Reference
) -> AnswerVerdict:
    """The verdict on steady motions.

    Those in one sense are complete if those in the opposite sense are steady too, and those at r > 0 if what is missing
    is the same at r < 0.
    """
    verdict = check_equilibria(alternatives, conditions, reference)
    verdict = replace(verdict, equations=tuple(e.about(STEADY_MOTION) for e in verdict.equations))
    if verdict.verdict is Verdict.WRONG:
        verdict = _on_one_side(alternatives, conditions, reference) or verdict
    if verdict.verdict is not Verdict.INCOMPLETE:
        return verdict
    both = [tuple(GivenEquation.of_reading(r, "answer") for r in _read(a, reference)[0]) for a in alternatives]
    for change, remark in _same_motions(reference):
        turned = [
            tuple(
                replace(
                    g, reading=replace(g.reading, components=tuple(c.xreplace(change) for c in g.reading.components))
                )
                for g in a
            )
            for a in both
        ]
        if (
            turned == both
            or check_equilibria([*both, *turned], conditions, reference).verdict is not Verdict.EQUIVALENT
        ):
            continue
        right = (replace(e, verdict=Verdict.EQUIVALENT, remarks=(*e.remarks, remark)) for e in verdict.equations)
        return replace(verdict, verdict=Verdict.EQUIVALENT, equations=tuple(right), missing=0)
    return verdict


def _on_one_side(
    alternatives: Sequence[Sequence[Fragment]], conditions: Sequence[Equilibrium], reference: Reference
) -> AnswerVerdict | None:
    """The verdict on an answer that is right where f > 0, of conditions that contain sgn f; None if it is not."""
    from lagrange.mechanics.momenta.steady_motions import on_one_side

    for side, general in (s for e in conditions for s in on_one_side(e)):
        verdict = check_equilibria(alternatives, [general], reference)
        if verdict.verdict is Verdict.EQUIVALENT:
            remark = f"it is right where {text(side, Notation())} > 0, which is taken to be meant"
            right = (replace(e, remarks=(*e.remarks, remark)) for e in verdict.equations)
            return replace(verdict, equations=tuple(right))
    return None


def _same_motions(reference: Reference) -> Iterator[tuple[dict[sp.Symbol, sp.Expr], str]]:
    """Substitutions that turn a steady motion into one that books leave implicit, each with a remark."""
    opposite = {v: -v for v in reference.scope.slots.velocities}
    yield opposite, "the same motion in the opposite sense is taken to be meant as well"
    for configuration in (c.system.configuration for c in reference.candidates):
        for r in configuration.slots.coordinates:
            if is_radius(r, configuration):
                yield (
                    {r: -r},
                    f"{r} is taken to be positive: a negative one is the same place, seen from the other side",
                )


def _read(alternative: Sequence[Fragment], reference: Reference) -> tuple[tuple[Reading, ...], tuple[Diagnostic, ...]]:
    """The equations of one alternative, and notes; read as an answer with working where one cannot be read alone."""
    readings = tuple(read_answer(f, reference.scope) for f in alternative)
    notes: tuple[Diagnostic, ...] = ()
    if any(r.error for r in readings):
        from lagrange.answers.written.working import understood

        working = understood(alternative, reference, moving=False)
        if working.judged and not working.unreadable:
            readings = tuple(f.reading for f in working.judged if isinstance(f, GivenEquation))
            notes = working.notes
    return _without_unknowns(readings, reference), notes


def _without_unknowns(readings: Sequence[Reading], reference: Reference) -> tuple[Reading, ...]:
    """The equations without names that the problem does not know, unknown forces, each eliminated by one of them."""
    coordinates = reference.scope.slots.coordinates
    known = {
        *reference.scope.names(),
        *(f"{q.name}'" for q in coordinates),
        *(str(virtual_displacement(q)) for q in coordinates),
    }
    present = {s for r in readings for e in r.components for s in e.free_symbols if type(s) is sp.Symbol}
    readings = tuple(readings)
    for unknown in sorted((s for s in present if s.name not in known and s == sp.Symbol(s.name, real=True)), key=str):
        for n, r in enumerate(readings):
            [e, *others] = r.components or (sp.S.Zero,)
            rate = e.diff(unknown)
            if others or rate == 0 or unknown in rate.free_symbols:
                continue
            rule = {unknown: -e.xreplace({unknown: sp.S.Zero}) / rate}
            readings = tuple(
                replace(other, components=tuple(sp.together(c.xreplace(rule)) for c in other.components))
                for m, other in enumerate(readings)
                if m != n
            )
            break
    return readings


def explained_equilibria(
    alternatives: Sequence[Sequence[Fragment]],
    equilibria: Sequence[Equilibrium],
    reference: Reference,
    problem: Problem | None = None,
    subject: Subject = REST,
) -> str:
    """The changed problem whose equilibria the wrong alternatives are, in a sentence; empty if not found."""
    return within(UNITS_OF_EXPLAINING, lambda: _explained(alternatives, equilibria, reference, problem, subject)) or ""


def _explained(
    alternatives: Sequence[Sequence[Fragment]],
    equilibria: Sequence[Equilibrium],
    reference: Reference,
    problem: Problem | None,
    subject: Subject,
) -> str:
    everything = [tuple(read_answer(f, reference.scope) for f in a) for a in alternatives]
    for e in [e for e in equilibria if e.branches]:
        values = dict(reference.values)
        wrong = [a for a in everything if not _right(_verdict_of([a], e, reference, values))] or everything
        if why := next(_Wrong(wrong, e, reference, problem, subject).reasons(), ""):
            return why
    return ""


class _Wrong:
    """Wrong alternatives of an answer, and for which other problem they would be right."""

    def __init__(
        self,
        wrong: Sequence[tuple[Reading, ...]],
        e: Equilibrium,
        reference: Reference,
        problem: Problem | None,
        subject: Subject,
    ) -> None:
        from lagrange.answers.results.at_random import AtRandom
        from lagrange.answers.results.resting import WrongEquilibria

        self.wrong, self.e, self.reference, self.problem, self.subject = wrong, e, reference, problem, subject
        self.values = dict(reference.values)
        self.stated = [c for a in wrong for r in a for c in r.components]
        self.tried = WrongEquilibria(_components(wrong), e, self.values)
        used = {s for c in self.stated for s in c.free_symbols}
        # Random places of rest tell nothing of undefined functions, nor of relations between parameters, W = c l.
        self.beyond_random = used.isdisjoint(e.configuration.slots.coordinates) or any(
            x.atoms(Unspecified) for x in (*e.work.forces, *self.stated)
        )
        self.at_random = AtRandom(_components(wrong), e)

    def reasons(self) -> Iterator[str]:
        """What they are instead, the likeliest first."""
        from lagrange.answers.models.one_place import other_waves
        from lagrange.answers.results.balances import of_another_balance, of_equal_energy
        from lagrange.answers.results.meanings import wrong_dimension
        from lagrange.answers.results.other_sides import INVERTED, other_sides
        from lagrange.answers.results.resting import angles_and_lengths

        e = self.e
        others = [*other_sides(self.wrong)]
        yield from self._with_sides(s for s in others if s[0] == INVERTED)
        slots, forces = e.configuration.slots, (*e.expressions, *e.work.forces)
        variations = letter_variations(self.stated, forces, slots, (*e.forces, *e.multipliers))
        pairs = combinations(e.forces, 2)
        yield from self._varied(Variation(f"with {a} and {b} exchanged", "", rule={a: b, b: a}) for a, b in pairs)
        if self.problem is not None:
            yield from filter(None, [self.tried.of_differential(self.problem)])
            yield from self._these(self.tried.of_one_force(self.problem, changing=True))
        yield from self._varied(v for v in variations if v.is_exchange)
        yield from self._varied(angles_and_lengths(self.stated, e))
        yield from self._with_sides(other_waves(self.wrong, slots.coordinates))
        yield from filter(None, [of_another_balance(_components(self.wrong), e.configuration)])
        if self.problem is not None and self.tried.tried:
            yield from filter(None, [of_equal_energy(_components(self.wrong), e.configuration)])
            yield from self._these(self.tried.of_changed_problem(self.problem))
            yield from self._these(self.tried.of_one_displacement(self.problem))
        bound = geometry_of(e.configuration)
        tied = {s for f in e.configuration.finite_constraints for s in f.free_symbols}
        fit = (v for v in variations if (bound if 0 in v.values.values() else tied).isdisjoint(v.values))
        yield from self._varied(fit)
        yield from self._with_sides(s for s in others if s[0] != INVERTED)
        foreign = self._foreign_parameters()
        if others and self.tried.tried:
            yield from self._without_factor(foreign)
        if self.problem is not None:
            yield from self._these(self.tried.of_one_force(self.problem))
        if self.tried.tried:
            yield from filter(None, [self.tried.of_displacement()])
        yield from filter(None, (wrong_dimension(c, self.reference.units) for c in self.stated))
        if foreign:
            yield f"the conditions of {self.subject.one} do not depend on {', '.join(sorted(foreign))}"

    def _these(self, clause: str) -> Iterator[str]:
        if clause:
            yield f"these are the {self.subject.many} {clause}"

    def _varied(self, variations: Iterable[Variation]) -> Iterator[str]:
        return (sentence for v in variations if self._holds(v) for sentence in self._these(v.clause))

    def _with_sides(self, changed: Iterable[tuple[str, Sequence[tuple[Reading, ...]]]]) -> Iterator[str]:
        return (sentence for sentence, sides in changed if self._right(sides))

    def _holds(self, variation: Variation) -> bool:
        """Whether they are the equilibria of the problem that is changed so."""
        if not (self.tried.tried and self.beyond_random) and not self.at_random.may_hold(variation):
            return False
        if self.tried.tried:
            return self.tried.holds(variation)
        rule = dict(variation.rule)
        changed = [
            tuple(replace(r, components=tuple(c.xreplace(rule) for c in r.components)) for r in a) for a in self.wrong
        ]
        return _right(_verdict_of(changed, self.e, self.reference, {**self.values, **variation.values}))

    def _right(self, sides: Sequence[tuple[Reading, ...]]) -> bool:
        """Whether other alternatives are the equilibria of the problem as it is."""
        from lagrange.answers.results.at_random import AtRandom
        from lagrange.answers.results.resting import WrongEquilibria

        if self.tried.tried:
            return WrongEquilibria(_components(sides), self.e, self.values).holds(_AS_IT_IS)
        if not AtRandom(_components(sides), self.e).may_hold(_AS_IT_IS):
            return False
        return _right(_verdict_of(sides, self.e, self.reference, self.values))

    def _foreign_parameters(self) -> set[str]:
        """Parameters that are in the answer and not in the conditions."""
        own = {s.name for x in (*self.e.expressions, *self.e.work.forces) for s in x.free_symbols}
        stated = {s.name for c in self.stated for s in c.free_symbols}
        return (stated - own) & {*self.reference.parameters}

    def _without_factor(self, foreign: Set[str]) -> Iterator[str]:
        lhs, rhs = (s for s in self.wrong[0][0].sides if isinstance(s, sp.Expr))
        factor = self.tried.missing_factor(lhs, rhs)
        if factor is not None and foreign.isdisjoint(s.name for s in factor.free_symbols):
            yield f"its right side has to be multiplied by {text(factor, Notation())}"


def _components(alternatives: Sequence[tuple[Reading, ...]]) -> list[list[sp.Expr]]:
    return [[c for r in a for c in r.components] for a in alternatives]


_AS_IT_IS = Variation("", "")


def _right(verdict: AnswerVerdict | None) -> bool:
    return verdict is not None and verdict.verdict in (Verdict.EQUIVALENT, Verdict.INCOMPLETE)


def _verdict_of(
    readings: Sequence[Sequence[Reading]], e: Equilibrium, reference: Reference, values: Mapping[sp.Symbol, sp.Expr]
) -> AnswerVerdict | None:
    try:
        return _judged(readings, e, reference, dict(values))
    except (DivisionByZeroError, NoPointError, UnsupportedError):
        return None


def _unreadable(
    readings: Sequence[Sequence[Reading]], errors: tuple[Diagnostic, ...], notes: tuple[Diagnostic, ...]
) -> AnswerVerdict:
    equations = tuple(
        EquationVerdict(r.text, Verdict.UNREADABLE, r.error.diagnostics[0].message)
        if r.error
        else EquationVerdict(r.text, Verdict.UNDECIDED, NOT_JUDGED)
        for a in readings
        for r in a
    )
    return AnswerVerdict(Verdict.UNREADABLE, equations, unreadable=errors, notes=notes)


def _tried(
    readings: Sequence[Sequence[Reading]], equilibrium: Equilibrium, reference: Reference
) -> AnswerVerdict | None:
    """The verdict in one set of coordinates; None if the answer uses others.

    An answer in letters is judged without the values first: sin θ = M/m is right even if M > m with the values.
    """
    if reference.values:
        in_letters = _judged(readings, equilibrium, reference, {})
        if in_letters is None or in_letters.verdict is Verdict.EQUIVALENT:
            return in_letters
    verdict = _judged(readings, equilibrium, reference, dict(reference.values))
    if verdict is None or verdict.verdict is not Verdict.WRONG:
        return verdict
    signs = {s for e in equilibrium.expressions for s in e.free_symbols if isinstance(s, Sign)}
    for sign in (1, -1) if len(signs) == 1 else ():
        branch = _judged(
            readings, equilibrium, reference, {**reference.values, **dict.fromkeys(signs, sp.Integer(sign))}
        )
        if branch is not None and branch.verdict is Verdict.EQUIVALENT:
            remark = _BRANCH.format(next(iter(signs)), sign)
            return replace(branch, equations=tuple(replace(e, remarks=(*e.remarks, remark)) for e in branch.equations))
    return verdict


def _judged(
    readings: Sequence[Sequence[Reading]],
    equilibrium: Equilibrium,
    reference: Reference,
    values: Mapping[sp.Symbol, sp.Expr],
) -> AnswerVerdict | None:
    configuration = equilibrium.configuration
    components = [e for a in readings for r in a for e in r.components]
    moved = displaced_coordinates(components, reference.scope.slots.coordinates)
    used = {s.name for s in moved.union(*(e.free_symbols for e in components))}
    known = {s.name for s in (*configuration.slots.coordinates, *configuration.expressed)}
    if not used & {q.name for q in reference.scope.slots.coordinates} <= known:
        return None

    def rewritten(e: sp.Expr) -> list[sp.Expr]:
        stated = without_displacements(_with_roots_named(configuration.rewritten(e), configuration), configuration)
        return [without_squares(part.xreplace(dict(values))) for part in stated]

    systems = [[tuple(part for e in r.components for part in rewritten(e)) for r in a] for a in readings]
    comparison = EquilibriumComparison(equilibrium, values, systems)
    literal = comparison.verdict(readings, systems)
    if literal.verdict is Verdict.WRONG and any(r.with_decimals for a in readings for r in a):
        exact, remarks = _with_right_decimals(readings, systems, comparison, rewritten)
        if exact != systems:
            literal, systems = EquilibriumComparison(equilibrium, values, exact).verdict(readings, exact), exact
            literal = replace(
                literal,
                equations=tuple(
                    replace(v, remarks=(*v.remarks, remark)) if remark and v.verdict is Verdict.EQUIVALENT else v
                    for v, remark in zip(literal.equations, remarks, strict=True)
                ),
            )
    if literal.verdict is Verdict.EQUIVALENT:
        return literal
    waves = (None, *((sp.tan, sp.cos, sp.sin) if literal.verdict is Verdict.INCOMPLETE else ()))
    meant = [comparison.is_in_contact(r, a) for r, a in zip(readings, systems, strict=True)]
    for wave in waves:
        wider = [widened_system(a, wave) if c else a for a, c in zip(systems, meant, strict=True)]
        if wider == systems:
            continue
        read_wider = EquilibriumComparison(equilibrium, values, wider).verdict(readings, wider)
        if WORST_TO_BEST.index(read_wider.verdict) > WORST_TO_BEST.index(literal.verdict):
            changed = [old != new for a, w in zip(systems, wider, strict=True) for old, new in zip(a, w, strict=True)]
            equations = tuple(
                replace(v, remarks=(*v.remarks, _ALL_ANGLES)) if is_changed else v
                for v, is_changed in zip(read_wider.equations, changed, strict=True)
            )
            return replace(read_wider, equations=equations)
    return literal


def _with_roots_named(e: sp.Expr, configuration: Configuration) -> sp.Expr:
    """sqrt(l² − x²) as y, where that is y² by the constraints: books mean the position that is drawn, where y > 0."""
    roots = [p for p in e.atoms(sp.Pow) if abs(p.exp) == sp.Rational(1, 2)]
    if not roots or not configuration.finite_constraints:
        return e
    rule = {}
    for root in roots[:MOST_NUMERICAL_ROOTS]:
        for q in configuration.slots.coordinates:
            try:
                if configuration.surface.is_zero(root.base - q**2) is True:
                    rule[root] = q if root.exp > 0 else 1 / q
                    break
            except (DivisionByZeroError, NoPointError, UnsupportedError):
                continue
    return e.xreplace(rule)


def _with_right_decimals(
    readings: Sequence[Sequence[Reading]],
    systems: list[list[tuple[sp.Expr, ...]]],
    comparison: EquilibriumComparison,
    rewritten: Callable[[sp.Expr], list[sp.Expr]],
) -> tuple[list[list[tuple[sp.Expr, ...]]], list[str]]:
    """The equations with the numbers at an equilibrium instead of the decimals that round them, and remarks."""
    meant: list[list[tuple[sp.Expr, ...]]] = []
    remarks = []
    for alternative, equations in zip(readings, systems, strict=True):
        meant.append([])
        for r, es in zip(alternative, equations, strict=True):
            parts = [part for e in r.with_decimals for part in rewritten(e)]
            values = _right_decimals(parts, comparison) if len(parts) == 1 else {}
            meant[-1].append(tuple(as_written(e.xreplace(values)) for e in parts) if values else es)
            remarks.append(remark_on({d: v.evalf(20) for d, v in values.items()}))
    return meant, remarks


def _right_decimals(equations: Sequence[sp.Expr], comparison: EquilibriumComparison) -> dict[Decimal, sp.Expr]:
    """The value of one decimal of an equation at an equilibrium, exactly, the others rounded; none if none is close."""
    (e,) = equations
    decimals = decimals_in([e])
    right = []
    for d in decimals:
        others = {x: x.written for x in decimals if x != d}
        slope = e.diff(d)
        if d in slope.free_symbols:
            continue
        rest = sp.expand(e.xreplace({d: sp.S.Zero}))
        for _, point in comparison.points:
            for value in _at_equilibrium((-rest / slope).xreplace(others), point, comparison, d):
                number = value.evalf(20)
                ratios = [abs(e.diff(x) / slope) * x.half_width for x in decimals]
                leeway = as_written(sp.Add(*ratios).xreplace({d: d.written}))
                if number.is_real and not leeway.free_symbols and abs(number - d.written) <= leeway:
                    right.append((abs(number - d.written), d, value))
    nearest = min(right, key=lambda x: x[0], default=None)
    return {nearest[1]: nearest[2]} if nearest else {}


def _at_equilibrium(
    e: sp.Expr, point: Mapping[sp.Symbol, sp.Expr], comparison: EquilibriumComparison, near: Decimal
) -> list[sp.Expr]:
    """The values without parameters that an expression has at an equilibrium; an angle has many."""
    angles = sorted(e.free_symbols & (comparison.angles | comparison.mixed), key=str)
    bare = [u for u in angles if (e.diff(u) * sp.pi).is_Rational or e.diff(u).is_Rational]  # in degrees, or not
    try:
        if len(bare) == 1 and len(angles) == 1:
            (u,), rate = bare, e.diff(bare[0])
            cosine, sine = (comparison.solution.at(point, f(u)) for f in (sp.cos, sp.sin))
            if cosine.free_symbols | sine.free_symbols or e.free_symbols != {u}:
                return []
            angle = sp.acos(cosine) if sine.evalf(20) >= 0 else -sp.acos(cosine)
            value = e.xreplace({u: angle})
            turn = 2 * sp.pi * rate
            return [value + turn * sp.Integer(round(float((near.written - value.evalf(20)) / turn.evalf(20))))]
        value = comparison.solution.at(point, e)
    except (NotAlgebraicError, DivisionByZeroError):
        return []
    return [] if value.free_symbols or value.has(sp.zoo, sp.nan, sp.oo) else [value]
