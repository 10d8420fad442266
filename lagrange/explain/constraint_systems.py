"""The constraints as a system: integrable together or not, hidden relations, redundancy, special configurations."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import sympy as sp

from lagrange.algebra.forms.hidden_relations import HiddenRelation
from lagrange.core.symbols import CONSTANT, FormSymbol, Slots, differential, t
from lagrange.document.derivation import Block, Equation, Part, Prose, Ref, display, listed, math, paragraph, prose
from lagrange.explain.nonlinear import together
from lagrange.explain.words import in_words, plural, spoken
from lagrange.mechanics.constraints.classification import Classification, Redundancy
from lagrange.mechanics.constraints.rank_loss import RankLoss

LETTERS = ("omega", "eta", "chi", "zeta", "xi")
"""What a form may be called; the first that the problem does not use."""
SHOWN_LOSSES = 4


def form_letter(taken: Collection[str]) -> str:
    """What a form is called: a letter that no name of the problem begins with."""
    return next((n for n in LETTERS if not any(name.startswith(n) for name in taken)), LETTERS[0])


def explain_together(classification: Classification, letter: str) -> list[Block]:
    """Frobenius' condition for the whole system, and its derived systems."""
    constraints, flag = classification.constraints, classification.flag
    if len(constraints) < 2 or all(c.row.finite is not None for c in constraints):
        return []
    if not all(c.pfaffian for c in constraints):
        return together(classification)
    if flag.integrable_rank is None:
        return [prose("How many finite relations the constraints hold together could not be decided.")]
    relations = in_words(flag.integrable_rank, "finite relation") if flag.integrable_rank else "no finite relation"
    if all(c.integrable for c in constraints):
        return [prose(f"Taken together, the constraints are worth {relations} between the coordinates.")]
    omega = sp.Symbol(letter, real=True)
    question = prose(
        "Together the constraints may hold more. A combination ", math(omega), " of the forms is the differential of a "
        "finite relation, but for a factor, only if ", math(differential(omega)), " vanishes for any two displacements "
        "that satisfy all the constraints: ", math(differential(omega), sp.S.Zero, relation="≡"), " modulo the forms. "
        "By Frobenius' theorem all the constraints come to finite relations if that holds for each of the forms.",
    )  # fmt: skip
    if len(flag.ranks) == 1:
        answer = f"It does: taken together, they are worth {relations} between the coordinates."
    else:
        ranks = "".join(str(p) for p in listed(map(str, flag.ranks[1:])))
        systems = plural(len(flag.ranks) - 1, "its derived system", "the derived systems")
        answer = (
            "It does not. The combinations for which it holds make the derived system; of these, those for which it "
            "holds modulo the derived system make the next one, until nothing more is lost. "
            f"The system has the rank {flag.ranks[0]}, {systems} {ranks}: "
            f"taken together, the constraints hold {relations} between the coordinates."
        )
    return [paragraph(question, prose(answer))]


def explain_hidden(classification: Classification, slots: Slots, letter: str) -> list[Block]:
    """The finite relations that no single constraint shows."""
    found, missing = classification.hidden.found, classification.hidden.missing
    body: list[Block] = []
    if found:
        many = in_words(len(found), "relation").capitalize()
        what = f"{many} {plural(len(found), 'follows', 'follow')} that no constraint shows as it stands:"
        lines = (Equation((r.function, CONSTANT), label=f"hidden-{n}") for n, r in enumerate(found, start=1))
        body += [prose(what), display(*lines), *_explain_combinations(classification, slots, letter)]
    if missing and len(classification.constraints) > 1:
        many = in_words(missing, f"{'further ' if found else ''}finite relation").capitalize()
        body.append(prose(f"{many} {plural(missing, 'exists', 'exist')}, not found in closed form."))
    return body


def _explain_combinations(classification: Classification, slots: Slots, letter: str) -> list[Block]:
    """The differentials of the hidden relations as combinations of the forms, where these are short."""
    found = classification.hidden.found
    shown = [r for r in found if r.combination is not None]
    if not shown:
        what = plural(len(found), "this function", "these functions")
        return [prose(f"No displacement that satisfies the constraints changes {what}: verified exactly.")]
    names = [c.row.name for c in classification.independent if c.pfaffian]
    used = {n for r in shown for n, c in zip(names, r.combination or (), strict=True) if c != 0}
    what = "its differential is" if len(found) == 1 else "the differentials are"
    what = what if len(shown) == len(found) else "of the differentials, those with short combinations are"
    lines = (_as_combination(r, names, classification, slots, letter) for r in shown)
    end = plural(len(found), "so that it does not change", "so that they do not change")
    return [
        prose(*_with_symbols(classification, used, letter), what),
        display(*lines),
        prose(f"{end} in a displacement that satisfies the constraints."),
    ]


def _form_symbol(classification: Classification, name: str, letter: str) -> FormSymbol:
    """ω_j for the form of the j-th constraint."""
    place = [c.row.name for c in classification.constraints].index(name)
    return FormSymbol(f"{letter}_{place + 1}", real=True)


def _with_symbols(classification: Classification, names: Collection[str], letter: str) -> tuple[Part, ...]:
    """`With ω_1 for (3) and ω_2 for (4), `."""
    used = [c.row.name for c in classification.constraints if c.row.name in names]
    parts = [(math(_form_symbol(classification, n, letter)), " for ", Ref(f"form-{n}")) for n in used]
    found: list[Part] = ["With "]
    for k, part in enumerate(parts):
        found += [*([" and " if k == len(parts) - 1 else ", "] if k else []), *part]
    return (*found, ", ")


def _as_combination(
    relation: HiddenRelation, names: Sequence[str], classification: Classification, slots: Slots, letter: str
) -> Equation:
    """Σ ∂φ/∂q_k dq_k = Σ c_j ω_j."""
    variables = (*slots.coordinates, t)
    left = sp.Add(*(a * differential(v) for a, v in zip(relation.differential, variables, strict=True)))
    terms = zip(relation.combination or (), names, strict=True)
    return Equation((left, sp.Add(*(c * _form_symbol(classification, n, letter) for c, n in terms))))


def explain_redundant(classification: Classification, letter: str) -> list[Prose]:
    """Each redundant constraint with the combination that makes it so."""
    if not classification.redundancies:
        return []
    names = listed(spoken(r.name) for r in classification.redundancies)
    many = len(classification.redundancies)
    sentences = [prose(*names, f" {plural(many, 'follows', 'follow')} from the constraints before: redundant, and not "
                       "counted.")]  # fmt: skip
    shown = [r for r in classification.redundancies if r.combination]
    if shown:
        used = {n for r in shown for n in (r.name, *(name for name, _ in r.combination or ()))}
        equations = listed(math(*_redundancy(classification, r, letter)) for r in shown)
        sentences.append(prose(*_with_symbols(classification, used, letter), *equations, "."))
    return sentences


def _redundancy(classification: Classification, r: Redundancy, letter: str) -> tuple[sp.Expr, sp.Expr]:
    """ω_3 = ω_1 + 2 ω_2."""
    terms = (c * _form_symbol(classification, name, letter) for name, c in r.combination or ())
    return _form_symbol(classification, r.name, letter), sp.Add(*terms)


def explain_losses(classification: Classification) -> list[Prose]:
    """Where the constraints are not independent, and where they only would not be."""
    sentences = []
    excluded: list[Part] = []
    for loss in classification.losses[:SHOWN_LOSSES]:
        place, there = math(*loss.conditions, sp.S.Zero), _rank_there(classification, loss)
        form = Ref(f"form-{loss.vanishing}")
        if loss.excluded:
            names = listed(spoken(n) for n in loss.excluded)
            verb = plural(len(loss.excluded), " excludes", " exclude")
            start: tuple[Part, ...] = ("; ", form) if excluded else ("The form ", form, " vanishes, and binds nothing,")
            excluded += [*start, " only where ", place, ", which ", *names, verb]
        elif loss.vanishing:
            sentences.append(prose("Where ", place, " the form ", form, " vanishes and binds nothing", *there, "."))
        else:
            sentences.append(prose("Where ", place, " the constraints are not independent", *there, "."))
    if excluded:
        sentences.append(prose(*excluded, "."))
    return sentences


def _rank_there(classification: Classification, loss: RankLoss) -> tuple[Part, ...]:
    one = len(classification.independent) == 1
    return () if one else (f": there the rank is {loss.rank} and not {classification.rank}",)
