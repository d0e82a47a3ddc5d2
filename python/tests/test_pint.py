"""Quantities of pint in and out."""

import dalembert
import numpy as np
import pint
import pytest

FAN = "vibration/rotating-unbalance"

ureg = pint.UnitRegistry()


@pytest.mark.parametrize(
    ("path", "quantity", "typed"),
    [
        ("mass", ureg.Quantity(88, "pound"), "88 lb"),
        ("mass", ureg.Quantity(40000, "gram"), "40 kg"),
        ("speed", ureg.Quantity(1000, "rpm"), "1000 rpm"),
        ("speed", ureg.Quantity(100, "rad/s"), "100 rad/s"),
        ("speed", ureg.Quantity(16, "hertz"), "16 Hz"),
        ("unbalance", ureg.Quantity(100, "kg*mm"), "0.1 kg*m"),
        ("support.stiffness.stiffness", ureg.Quantity(2, "kN/m"), "2 kN/m"),
        ("support.stiffness.stiffness", ureg.Quantity(2, "lbf/inch"), "2 lbf/in"),
        ("damping.coefficient.coefficient", ureg.Quantity(300, "N*s/m"), "300 N*s/m"),
        ("damping.ratio.ratio", ureg.Quantity(0.06, ""), "0.06"),
        ("damping.ratio.ratio", ureg.Quantity(6, "percent"), "6 %"),
        ("mass", ureg.Quantity(np.float64(3), "slug"), "3 slug"),
    ],
)
def test_a_quantity_is_what_would_be_typed(path, quantity, typed):
    a = dalembert.solve(FAN, case=1, set={path: quantity})
    b = dalembert.solve(FAN, case=1, set={path: typed})
    assert a.inputs[path]["si"] == pytest.approx(b.inputs[path]["si"], rel=1e-9)
    assert a.amplitude.si == pytest.approx(b.amplitude.si, rel=1e-8)


def test_a_wrong_dimension_is_refused():
    with pytest.raises(dalembert.InputError) as caught:
        dalembert.solve(FAN, case=1, mass=ureg.Quantity(3, "meter"))
    assert caught.value.errors[0].path == "mass"


def test_answers_become_quantities():
    fan = dalembert.solve(FAN, case=1)
    amplitude = fan.amplitude.pint(ureg)
    assert amplitude.to("m").magnitude == pytest.approx(fan.amplitude.si)
    for answer in fan.answers.values():
        quantity = answer.pint(ureg)
        assert "Hz" not in answer.unit
        assert quantity.to_base_units().magnitude == pytest.approx(answer.si, rel=1e-9), answer


def test_every_unit_of_every_first_case_goes_out():
    """Where pint does not know our unit the answer is in SI: its dimension and size stay."""
    for analysis in dalembert.analyses():
        for answer in dalembert.solve(analysis["id"], case=1).answers.values():
            quantity = answer.pint(ureg)
            if isinstance(answer.si, tuple):
                continue
            if "Hz" in answer.unit:
                # A frequency is 1/s to pint, and has 2π rad in a cycle here.
                assert quantity.magnitude == pytest.approx(answer.value)
            else:
                assert quantity.to_base_units().magnitude == pytest.approx(answer.si, rel=1e-7, abs=1e-300), answer


def test_arrays_of_quantities():
    speeds = ureg.Quantity(np.linspace(600, 1500, 5), "rpm")
    table = dalembert.sweep(FAN, {"speed": speeds}, answers=["amplitude"], case=1)
    for speed, amplitude in zip(speeds, table["amplitude"]):
        assert amplitude == pytest.approx(dalembert.solve(FAN, case=1, speed=speed).amplitude.value, rel=1e-12)
    points = {"frequency": np.linspace(4, 15, 23)}
    points["receptance"] = 1e-6 / np.hypot(1 - (points["frequency"] / 10) ** 2, 0.02 * points["frequency"])
    identified = dalembert.solve("vibration/frequency-response-identification", measurement={"table": {"points": points}})
    in_units = dalembert.solve(
        "vibration/frequency-response-identification",
        measurement={"table": {"points": np.column_stack([points["frequency"], points["receptance"]])}},
    )
    for name, answer in identified.answers.items():
        assert answer.si == in_units.answers[name].si
