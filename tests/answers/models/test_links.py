"""Where springs and dampers are fastened, and with which arm they act: the answers are derived by hand."""

from __future__ import annotations

import pytest

from tests.answers.models.slips import WrongAnswer, answers_by, assert_named, feedback_on, name_of


@pytest.mark.parametrize("answer", answers_by("links"), ids=name_of)
def test_the_cause_is_named(answer: WrongAnswer) -> None:
    assert_named(answer)


OSCILLATORS = "m*x2'' + b*(x2' - x1') + kappa*(x2 - x1 - l) + c*(x2 - L + l) = 0"
DAMPING = "b*a^2*h^2*sin(theta)^2*theta'/d^2"
SPRING = "c*a*h*sin(theta)*(1 - l/d)"
COLUMN = "m*l^2*(3*theta'' + (theta'' + psi'')*cos(psi) - (theta' + psi')^2*sin(psi)) + {} = -P*l*sin(psi)"
TOP = "m*l^2*(theta'' + psi'' + theta''*cos(psi) + theta'^2*sin(psi)) + {} = 0"
LINKS = [
    (
        "coupled-oscillators",
        "m*x1'' + b*(x1' - x2') + c*(x1 - l) - kappa*(x2 - x1 - l) = 0;"
        "m*x2'' + b*(x2' - x1') + kappa*(x2 - x1 - l) + c*(x2 - l) = 0",
        "for the spring `right` fastened at O",
    ),
    (
        "coupled-oscillators",
        f"m*x1'' + b*(x1' - x2') + c*(x1 - L + l) - kappa*(x2 - x1 - l) = 0;{OSCILLATORS}",
        "for the spring `left` fastened at `L*i`",
    ),
    ("door-closer", f"J*theta'' + b*theta' + {SPRING} = 0", "with b*theta' as its moment, as if it had no lever arm"),
    ("door-closer", f"J*theta'' + b*a^2*theta' + {SPRING} = 0", "with the constant lever arm a, once for its force"),
    ("door-closer", f"J*theta'' + {DAMPING} + c*h*(d - l) = 0", "the spring `spring` with the constant lever arm h"),
    ("door-closer", f"J*theta'' + {DAMPING} + c*(d - l) = 0", "with its force for its moment, without the lever arm"),
    (
        "ziegler-column",
        f"{COLUMN.format('c*theta')};{TOP.format('c*(theta + psi)')}",
        "with theta + psi in place of psi in the force of the potential `middle`",
    ),
    (
        "ziegler-column",
        f"{COLUMN.format('c*(3*theta - 2*psi)')};{TOP.format('c*(psi - theta)')}",
        "with psi - theta in place of psi in the force of the potential `middle`",
    ),
]


@pytest.mark.parametrize(("problem", "stated", "said"), LINKS)
def test_the_end_or_the_arm_is_named(problem: str, stated: str, said: str) -> None:
    assert said in feedback_on(problem, stated)
