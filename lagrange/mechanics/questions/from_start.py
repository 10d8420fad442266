"""The motion from the initial state of the file, where no question is asked.

Where the equations of motion integrate in closed form this is the solution, as functions of time; otherwise the first
integrals, each with its value at t = 0.
"""

from __future__ import annotations

from collections.abc import Sequence

from lagrange.core.records import record
from lagrange.core.symbols import prime
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.questions.closed_motions import ClosedMotion, closed_motions
from lagrange.mechanics.questions.dependent import dependent
from lagrange.mechanics.questions.forms import given_state
from lagrange.mechanics.questions.results import Substituted, UsedIntegral
from lagrange.mechanics.questions.setting import Setting
from lagrange.mechanics.questions.states import MotionView, initial_state
from lagrange.problem.model import Problem


@record
class FromStart:
    """What is known of the motion from the initial state.

    choice     the coordinates; empty for the file's own
    initial    the state at t = 0 as the file gives it
    motions    coordinates as functions of time, in each case; empty where they are not found
    integrals  with their values
    """

    choice: str
    initial: tuple[Substituted, ...]
    motions: tuple[ClosedMotion, ...] = ()
    integrals: tuple[UsedIntegral, ...] = ()


def motion_from_start(
    problem: Problem, places: Sequence[MotionView], configurations: Sequence[Configuration]
) -> FromStart | None:
    """The motion in the first place in which it is found in closed form, or the integrals in the first place of all.

    Raises ProblemError where the initial state contradicts the constraints.
    """
    initial = given_state(problem)
    settings = [Setting(place, problem, initial_state(place, problem, configurations)) for place in places]
    for setting in settings:
        rule = dependent(setting.place.configuration)
        known = {a: e.xreplace(rule) for a, e in setting.known.accelerations.items()}
        wanted = {q for q in setting.place.configuration.slots.coordinates if q not in rule and prime(q) not in rule}
        motions = [] if setting.slips else closed_motions(known, setting.initial, wanted - {*setting.fixed})
        if motions and wanted:
            return FromStart(setting.place.name, initial, tuple(motions))
    return FromStart(settings[0].place.name, initial, (), tuple(settings[0].integrals)) if settings else None
