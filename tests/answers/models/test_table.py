"""The table of models, and that there are enough wrong answers in `slips.txt`: each is tried beside the module that names it."""

from __future__ import annotations

from lagrange.answers.models.table import MODELS
from tests.answers.models.slips import answers_by, wrong_answers


def test_there_are_enough_answers() -> None:
    assert len({w.problem for w in wrong_answers()}) >= 25
    assert len(wrong_answers()) >= 70
    names = {m.name for m in MODELS}
    assert len(names) == len(MODELS)


def test_every_answer_is_tried_beside_one_module() -> None:
    modules = ("composed", "forces", "groups", "kinematics", "kinetic", "lengths", "links", "pairs", "variable_masses")
    assert sum(len(answers_by(m)) for m in modules) == len(wrong_answers())
    assert all(answers_by(m) for m in modules)
