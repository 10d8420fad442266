"""What people write instead of what a file says: understood, with the cure."""

from __future__ import annotations

import pytest

import lagrange
from lagrange.problem import keys
from lagrange.problem.sections import ENTRIES_OF_FORCES, OTHER_ENTRY_KEYS, OTHER_KEYS, OTHER_QUESTIONS

HEAD = "title: a\ncoordinates: [x]\n"
PARTICLE = "particles: {P: {mass: m, position: x*i}}\n"
FREE = HEAD + "parameters: [m, g]\n" + PARTICLE


@pytest.mark.parametrize(
    ("text", "cure"),
    [
        (FREE + "find: statics\n", "help: write `equilibrium`"),
        (FREE + "find: Equations_of_Motion\n", "help: write `motion`"),
        (FREE + "find: [small oscillations, dof]\n", "help: write `linearization`"),
        (FREE + "find: equilibriun\n", "did you mean `equilibrium`?"),
        (HEAD + "parameters: {m: {positive: true}}\n" + PARTICLE, "help: write `assume: positive`"),
        (HEAD + "parameters: {m: {min: 0}}\n" + PARTICLE, "help: write `range: [a, b]`"),
        (HEAD + "parameters: [m]\nmasses: {P: {mass: m, position: x*i}}\n", "help: write `particles`"),
        (
            FREE + "springs: {s: {spring: 3, between: [O, P]}}\n",
            "`forces: {s: {spring: k, between: [O, P], length: l}}`",
        ),
        (FREE + "forces: {gravity: -g*i}\n", "without the mass, beside `forces`: `gravity: -g*j`"),
        (FREE + "forces: {gravity: {vector: g*i}}\n", "without the mass, beside `forces`: `gravity: -g*j`"),
    ],
)
def test_the_cure(text: str, cure: str) -> None:
    with pytest.raises(lagrange.ProblemError) as found:
        lagrange.loads(text)
    assert cure in found.value.show()


def test_a_letter_is_one_more_quantity_rather_than_a_misprint() -> None:
    with pytest.raises(lagrange.ProblemError) as found:
        lagrange.loads(HEAD + "parameters: [mu, g]\n" + PARTICLE)
    text = " ".join(found.value.show().split())
    assert "`m` is not declared" in text
    assert "a quantity of its own goes under `parameters` of the problem file; or did you mean `mu`?" in text


def test_a_force_that_is_only_called_gravity_is_a_force() -> None:
    assert lagrange.loads(FREE + "forces: {gravity: {on: P, vector: -m*g*i}}\n").forces[0].name == "gravity"


def test_other_words_are_no_keys_and_mean_keys() -> None:
    questions = {q.value for q in keys.Find}
    assert set(OTHER_QUESTIONS.values()) <= questions
    assert not questions & set(OTHER_QUESTIONS)
    assert set(OTHER_KEYS.values()) <= set(keys.PROBLEM.names)
    assert not set(OTHER_KEYS) & set(keys.PROBLEM.names)
    entries = {
        name for form in (*keys.FORCES.values(), keys.BODY, keys.PARTICLE, keys.CONSTRAINT) for name in form.names
    }
    assert set(OTHER_ENTRY_KEYS.values()) <= entries


@pytest.mark.parametrize("entry", sorted(set(ENTRIES_OF_FORCES.values())))
def test_the_force_shown_for_a_section_that_there_is_not_is_one(entry: str) -> None:
    """`springs:` beside `forces:` is answered by an entry that can be copied."""
    text = """title: a
coordinates: [x, y]
parameters: [m, k, l, c, mu, M, R]
particles: {P: {mass: m, position: x*i + y*j}}
bodies: {wheel: {mass: m, inertia: m*R^2, position: 2*l*i, angle: y/R}}
constraints: {plane: y = 0}
forces: {%s}
"""
    assert len(lagrange.loads(text % entry).forces) == 1


@pytest.mark.parametrize(
    ("forces", "cure"),
    [
        ("{gravity: g}", "write `gravity: -g*j` beside `forces`, not in it"),
        ("{torque: M*k, on: B}", "write `moment`"),
        ("{moment: m, on: B}", "write `M*k` for one that turns i towards j"),
        ("{force: m*i, on: P}", "write `vector`"),
        ("{stiffness: m, between: [O, P]}", "write `spring`"),
    ],
)
def test_keys_of_forces_as_one_might_guess_them(forces: str, cure: str) -> None:
    bodies = "bodies: {B: {mass: m, inertia: m, position: x*i}}\n"
    with pytest.raises(lagrange.ProblemError) as found:
        lagrange.loads(FREE + bodies + f"forces: {{one: {forces}}}\n")
    assert cure in found.value.show()


def test_names_that_the_program_adds_are_not_offered() -> None:
    """A question may use `omega_drum`, `e1_drum` and `energy`; who forgot to declare `v` is told the names of the file."""
    text = """title: a
coordinates: [theta]
parameters: [m, R, omega_1]
bodies: {drum: {mass: m, inertia: m*R^2, position: 0*i, angle: theta}}
initial: {theta: 0, theta': zzz}
"""
    with pytest.raises(lagrange.ProblemError) as found:
        lagrange.loads(text)
    names = found.value.show().partition("the declared names are ")[2].split("\n")[0]
    assert names == "`theta`, `m`, `R`, `omega_1`, `r_drum`"
