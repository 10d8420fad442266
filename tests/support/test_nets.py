"""The nets themselves: their arithmetic, that they find what is wrong, and a few cases of each kind that always run."""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from tests.support.nets import constraint_systems, in_print, motions, statics, units
from tests.support.nets.evaluate import NotReadError, evaluate, holds, names_in
from tests.support.nets.rest import rests
from tests.support.nets.run import Printed, TooLongError, limited, wrong_names
from tests.support.nets.statics import check_system, conditions_of_stability
from tests.support.nets.system import System
from tests.support.nets.taylor import variables

TEXT = "x^2*sin(y)/(1 + sqrt(x)) + tan(x*y) - exp(-x)*log(y) + x^-1 + abs(x - y)"


def plain(x: float, y: float) -> float:
    return float(evaluate(TEXT, {"x": x, "y": y}))


def test_derivatives_are_those_of_differences() -> None:
    x, y, h = 0.3, 0.7, 1e-4
    names = dict(zip("xy", variables([x, y], 2), strict=True))
    series = evaluate(TEXT, names)
    expected = (
        x**2 * math.sin(y) / (1 + math.sqrt(x)) + math.tan(x * y) - math.exp(-x) * math.log(y) + 1 / x + abs(x - y)
    )
    assert series.value == pytest.approx(expected)
    slope = (plain(x + h, y) - plain(x - h, y)) / (2 * h)
    mixed = (plain(x + h, y + h) - plain(x + h, y - h) - plain(x - h, y + h) + plain(x - h, y - h)) / (4 * h * h)
    assert series.gradient[0] == pytest.approx(slope, rel=1e-5)
    assert series.hessian[0, 1] == pytest.approx(mixed, rel=1e-4)


def test_inverse_functions_have_their_derivatives() -> None:
    [x] = variables([0.4], 2)
    for name, inverse in (("asin", "sin"), ("acos", "cos"), ("atan", "tan")):
        series = evaluate(f"{inverse}({name}(x))", {"x": x})
        assert series.coefficients == pytest.approx([0.4, 1, 0], abs=1e-12)


def test_texts_are_no_code() -> None:
    for text in ("__import__('os')", "x.real", "[x]", "x if x else y", "print(x)", "y"):
        with pytest.raises(NotReadError):
            evaluate(text, {"x": 1.0})


def test_language() -> None:
    assert evaluate("2*x' - x''^2", {"x__1": 3.0, "x__2": 2.0}) == 2
    assert evaluate("3*i + x*j", {"x": 2.0, "i": np.eye(3)[0], "j": np.eye(3)[1]}).tolist() == [3, 2, 0]
    assert math.isnan(evaluate("sqrt(x)/x", {"x": 0.0}))
    assert names_in("m*l^2*theta'' - sin(phi)/2e3") == {"m", "l", "theta", "phi"}
    assert holds("x ≥ 2", {"x": 3.0}) is True
    assert holds("x < 2", {"x": 2.0}) is None


def pendulum() -> System:
    """A pendulum in its angle, from the top, with a pull to the side: tan θ = 3/4 below, and opposite."""
    s = System("pendulum", ["theta"], {"theta"})
    s.particle("P", "1", "2*sin(theta)", "2*cos(theta)")
    s.weigh("4")
    s.push("P", "3", "0")
    return s


def test_places_of_rest() -> None:
    low, high = sorted(rests(pendulum(), {}, random.Random(1)), key=lambda r: float(abs(r.q[0])), reverse=True)
    assert float(low.q[0]) == pytest.approx(math.pi - math.atan(0.75))
    assert float(high.q[0]) == pytest.approx(-math.atan(0.75))
    assert (low.stable, high.stable) == (True, False)
    assert low.squares == pytest.approx([5 / 2])


def test_a_point_of_inflection_is_not_judged() -> None:
    """x⁴ + x³ at 0: Newton's method ends a little beside a double root, on whichever side."""
    s = System("inflection", ["x"])
    s.field("x^4 + x^3")
    assert {r.stable for r in rests(s, {}, random.Random(1)) if abs(r.q[0]) < 0.1} == {None}


def kinds(
    shown: Printed, monkeypatch: pytest.MonkeyPatch, system: Callable[[], System] = pendulum, **changes: Any
) -> set[str]:
    """The kinds of findings where the program prints something else."""
    other = Printed(shown.text, shown.report, shown.json | changes)
    monkeypatch.setattr(statics, "printed", lambda _: other)
    return {f.kind for f in check_system(system(), random.Random(1), checking=False)} - {"undecided stability"}


def test_what_is_wrong_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    shown = statics.printed(pendulum().text)
    assert isinstance(shown, Printed)
    [both] = shown.json["equilibrium"] if len(shown.json["equilibrium"]) == 1 else [["tan(theta) = -3/4"]]
    one = {"stability": ["undecided"], "equilibrium_conditions": [[]], "stability_conditions": [{}]}
    assert kinds(shown, monkeypatch, equilibrium=[both], **one) == set()
    assert kinds(shown, monkeypatch, equilibrium=[["tan(theta) = 3/4"]], **one) == {
        "false equilibrium",
        "missing equilibrium",
    }
    assert kinds(shown, monkeypatch, equilibrium=[["sin(theta) = -3/5"]], **one) == {
        "false equilibrium",
        "missing equilibrium",
    }
    assert "missing equilibrium" in kinds(shown, monkeypatch, equilibrium=[], equilibrium_conditions=[], stability=[])
    assert kinds(shown, monkeypatch, equilibrium=[both], equilibrium_conditions=[[]], stability=["stable"]) == {
        "stability"
    }
    somewhere = one | {"stability_conditions": [{"unstable_where": [["sin(theta) > 0"]]}]}
    assert kinds(shown, monkeypatch, equilibrium=[both], **somewhere) == {"condition of stability"}
    assert "strange symbol" in kinds(shown, monkeypatch, equilibrium=[both], generalized_forces={"theta": "u*v"}, **one)
    assert "not for print" in kinds(shown, monkeypatch, equilibrium=[both], note="nan", **one)


def hanging() -> System:
    """A particle of mass 1 on a rod of length 2 in Cartesian coordinates, and its small oscillations, ω² = 4/2."""
    s = System("hanging", ["x", "y"], box=3, find="[equilibrium, linearization]")
    s.particle("P", "1", "x", "y")
    s.constraints["rod"] = "x^2 + y^2 = 4"
    s.weigh("4")
    return s


def test_wrong_frequencies_and_reactions_are_found(monkeypatch: pytest.MonkeyPatch) -> None:
    shown = statics.printed(hanging().text)
    assert isinstance(shown, Printed)
    assert kinds(shown, monkeypatch, hanging) == set()
    entries = shown.json["linearization"]
    assert [f["multiplicity"] for x in entries for f in x["frequencies"]] == [1, 1]
    for change in ({"multiplicity": 2}, {"squared": "1 + 1/3"}):
        wrong = [x | {"frequencies": [f | change for f in x["frequencies"]]} for x in entries]
        assert kinds(shown, monkeypatch, hanging, linearization=wrong) == {"frequencies"}
    rod = shown.json["reactions"]["rod"]
    for factor in ("-1", "2"):
        turned = [r | {"multiplier": f"{factor}*({r['multiplier']})"} for r in rod["at_equilibrium"]]
        assert kinds(shown, monkeypatch, hanging, reactions={"rod": rod | {"at_equilibrium": turned}}) == {"reaction"}
    for n in (0, 1):
        kept = {k: shown.json[k][1 - n : 2 - n] for k in ("equilibrium", "equilibrium_conditions", "stability")}
        assert "missing equilibrium" in kinds(shown, monkeypatch, hanging, **kept, linearization=[], reactions={})


def test_conditions_are_read_from_the_page() -> None:
    prose = "At [equilibrium-1] they are a and b: stable where k > m*g*l and 2*k^2 > 4*g. At [equilibrium-2] it is c, negative: unstable."
    shown = Printed("", None, {"steps": [{"rule": "equilibrium", "body": [{"prose": prose}]}]})  # type: ignore[arg-type]
    assert conditions_of_stability(shown, 1) == ["k > m*g*l", "2*k^2 > 4*g"]
    assert conditions_of_stability(shown, 2) is None


@pytest.mark.parametrize(
    ("fault", "kinds"),
    [
        ("x = lambda_of_equilibrium_0*q", {"strange symbol", "not for print"}),
        ("x = a*ImaginaryUnit()", {"strange symbol", "not for print"}),
        ("x = sqrt(2 - 3)*a", {"not for print"}),
        ("x = a*asin(3/2)", {"not for print"}),
        ("x = oo", {"strange symbol", "not for print"}),
        ("x = b*xi", {"strange symbol"}),
        ("x = p_y*xi", {"strange symbol"}),
        ("x = sqrt(3 - 2)*a + p_x*lambda_rod", set()),
    ],
)
def test_what_must_not_be_printed_is_found(fault: str, kinds: set[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(in_print.terminal, "text", lambda *_: "")
    report: Any = SimpleNamespace(derivation=None, notation=None)
    steps = [{"body": [{"equations": [{"text": fault}]}]}]
    for place in ({"equilibrium": [[fault]]}, {"steps": steps}):
        found = {"constraints": [{"name": "rod"}], "checks": [], **place}
        shown = Printed("{coordinates: [x], parameters: [a, q]}", report, found)
        assert {f.kind for f in wrong_names(shown)} == kinds


def test_on_the_page_imaginary_units_are_found(monkeypatch: pytest.MonkeyPatch) -> None:
    report: Any = SimpleNamespace(derivation=None, notation=None)
    for line in ("y = (a Q/√(Q² − 4W²)) ImaginaryUnit()", "ω² = ∞", "x = √(−3)", "V = DiracDelta(x)"):
        monkeypatch.setattr(in_print.terminal, "text", lambda *_, line=line: f"fine\n  {line}\n")
        assert [kind for kind, *_ in in_print.unfit(report, {"constraints": []}, set())] == ["not for print"]
    monkeypatch.setattr(in_print.terminal, "text", lambda *_: "ω → 0 where t → ∞")
    assert [*in_print.unfit(report, {"constraints": []}, set())] == []


@pytest.mark.parametrize(
    ("keeper", "sign", "wrong"),
    [("", 1, False), ("", -1, True), ("string", 1, False), ("wire", -1, False), ("wire", 1, True)],
)
def test_a_named_reaction_with_a_wrong_sign_is_found(keeper: str, sign: int, wrong: bool) -> None:
    """A pendulum that hangs at rest: its rod pulls with m g = 20, upwards; a wire presses along the outer normal with −20."""
    s = System("pendulum", ["x", "y"])
    s.particle("P", "2", "x", "y")
    s.constraints, s.named = {"rod": "x^2 + y^2 = 4"}, {"rod": "T"}
    if keeper == "wire":
        s.keepers = {"rod": "wire"}
    else:
        s.anchors = {"rod": ("P", ("0", "0"))}
    s.weigh("10")
    at = motions.accelerated(s, np.array([0.0, -2.0]), np.zeros(2), {}, 0.0)
    assert at is not None
    assert bool(list(motions._named_forces(s, {"T": 20.0 * sign}, at))) is wrong


def test_a_wrong_unit_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(units, "UNITS", {name: {"g": 1.0, "in": 1.0, "lb": 1.0} for name in units.UNITS})
    found = [f.kind for seed in (1, 2) for f in units.findings(seed)]
    assert "value" in found


def test_limit_of_time() -> None:
    with pytest.raises(TooLongError), limited(0.05):
        sum(1 for _ in iter(int, 1))


def test_integrable_ranks() -> None:
    s = System("constraints", ["x", "y", "z"])
    s.forms = {"c": {"z": "1", "x": "-y"}}
    assert constraint_systems.ranks(s, random.Random(1)) == (1, 0)
    s.forms["d"] = {"y": "1"}
    assert constraint_systems.ranks(s, random.Random(1)) == (2, 2)


def test_a_state_is_consistent() -> None:
    """A pendulum in Cartesian coordinates: x x″ + y y″ + x′² + y′² = 0, and y″ x − x″ y is the moment of the weight."""
    s = System("pendulum", ["x", "y"])
    s.particle("P", "2", "x", "y")
    s.constraints["rod"] = "x^2 + y^2 = 4"
    s.weigh("10")
    at = motions.state(s, random.Random(1))
    assert at is not None
    (x, y), (v, w), (a, b) = at.q, at.velocities, at.accelerations
    assert x * x + y * y == pytest.approx(4)
    assert x * v + y * w == pytest.approx(0, abs=1e-12)
    assert x * a + y * b + v * v + w * w == pytest.approx(0, abs=1e-9)
    assert x * b - y * a == pytest.approx(-10 * x)


@pytest.mark.parametrize(
    ("net", "seed"),
    [
        (statics, 2),
        (statics, 6),
        (motions, 2),
        (motions, 4),
        (constraint_systems, 1),
        (constraint_systems, 4),
        (units, 1),
    ],
)
def test_a_few_cases(net: Any, seed: int) -> None:
    """Seven cases that always run; more are in truth/test_nets.py."""
    assert [str(f) for f in net.findings(seed)] == []
