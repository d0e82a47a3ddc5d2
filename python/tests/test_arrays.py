"""Sweeps and studies on arrays of NumPy."""

import _thread
import threading
import time

import dalembert
import numpy as np
import pytest

FAN = "vibration/rotating-unbalance"


def test_a_sweep_is_what_solve_answers():
    speeds = np.linspace(60, 160, 11)
    table = dalembert.sweep(FAN, {"speed": speeds}, answers=["amplitude", "phase"], case=1)
    assert list(table) == ["amplitude", "phase"] and table.units == {"amplitude": "mm", "phase": "deg"}
    for speed, amplitude, phase in zip(speeds, table["amplitude"], table["phase"]):
        one = dalembert.solve(FAN, case=1, speed=float(speed))
        assert (one.amplitude.value, one.phase.value) == (amplitude, phase)
    assert table.refused == []


def test_arrays_are_broadcast_and_inputs_need_no_first_value():
    inputs = {"unbalance": "0.1 kg*m", "damping": 0.06, "support": {"stiffness": {"stiffness": "451 kN/m"}}}
    table = dalembert.sweep(FAN, {"mass": np.array([[30.0], [40.0]]), "speed": np.array([90.0, 100.0, 110.0])}, **inputs)
    assert table["amplitude"].shape == (2, 3)
    one = dalembert.solve(FAN, mass=40, speed=110, **inputs)
    assert table["amplitude"][1, 2] == one.amplitude.value
    assert set(table) >= {"amplitude", "phase", "natural_frequency"}
    assert table["amplitude"].flags.writeable
    assert dalembert.sweep(FAN, {"mass": 40.0}, case=1)["amplitude"].shape == ()


def test_refused_points_are_listed():
    masses = np.array([[30.0, -1.0], [np.nan, 50.0]])
    table = dalembert.sweep(FAN, {"mass": masses}, answers=["amplitude"], case=1)
    assert np.isnan(table["amplitude"]).tolist() == [[False, True], [True, False]]
    assert [place for place, _ in table.refused] == [(0, 1), (1, 0)]
    assert "outside the limits" in table.refused[0][1]
    flat = dalembert.sweep(FAN, {"mass": masses.ravel()}, answers=["amplitude"], case=1)
    assert [place for place, _ in flat.refused] == [1, 2]


def test_wrong_names_are_said():
    with pytest.raises(dalembert.InputError, match="did you mean `speed`"):
        dalembert.sweep(FAN, {"sped": [1.0]}, case=1)
    with pytest.raises(dalembert.InputError, match="did you mean `amplitude`"):
        dalembert.sweep(FAN, {"speed": [100.0]}, answers=["amplitud"], case=1)
    with pytest.raises(dalembert.InputError, match="no input varies"):
        dalembert.sweep(FAN, {}, case=1)
    with pytest.raises(ValueError):
        dalembert.sweep(FAN, {"speed": [1.0, 2.0], "mass": [1.0, 2.0, 3.0]}, case=1)


def test_the_lock_is_released_and_threads_agree():
    speeds = np.linspace(60, 160, 200_000)
    one = dalembert.sweep(FAN, {"speed": speeds}, answers=["amplitude"], case=1, threads=1)
    two = dalembert.sweep(FAN, {"speed": speeds}, answers=["amplitude"], case=1)
    assert (one["amplitude"] == two["amplitude"]).all()
    counted = []

    def count():
        while not done.is_set():
            counted.append(time.perf_counter())
            time.sleep(0.001)

    done = threading.Event()
    thread = threading.Thread(target=count)
    thread.start()
    start = time.perf_counter()
    dalembert.sweep(FAN, {"speed": np.linspace(60, 160, 2_000_000)}, answers=["amplitude"], case=1, threads=1)
    end = time.perf_counter()
    done.set()
    thread.join()
    assert sum(start < at < end for at in counted) > 3


def test_an_interrupt_stops_a_study():
    plan = {
        "problem": FAN,
        "samples": 400_000_000,
        "answers": ["amplitude"],
        "vary": [{"input": "mass", "distribution": "normal", "deviation": "1 %"}],
    }
    threading.Timer(0.3, _thread.interrupt_main).start()
    start = time.perf_counter()
    with pytest.raises(KeyboardInterrupt):
        dalembert.study(plan)
    assert time.perf_counter() - start < 5


def test_a_study_is_a_table_and_its_statistics(tmp_path):
    plan = {
        "problem": FAN,
        "answers": ["amplitude"],
        "samples": 2000,
        "sampling": "latin-hypercube",
        "vary": [
            {"input": "speed", "from": "900 rpm", "to": "1100 rpm", "points": 3},
            {"input": "mass", "distribution": "normal", "deviation": "2 %"},
        ],
        "limit": [{"answer": "amplitude", "above": "10 mm"}],
    }
    study = dalembert.study(plan)
    assert list(study) == ["speed", "mass", "amplitude"]
    assert study.units == {"speed": "rpm", "mass": "kg", "amplitude": "mm"}
    assert study["amplitude"].shape == (6000,)
    statistics = study.summary["answers"][0]
    assert statistics["mean"] == pytest.approx(np.nanmean(study["amplitude"]), rel=1e-12)
    assert statistics["exceedances"][0]["count"] == (study["amplitude"] > 10).sum()
    assert (study["amplitude"] == dalembert.study(plan, threads=1)["amplitude"]).all()
    path = tmp_path / "plan.toml"
    path.write_text(
        f'problem = "{FAN}"\nanswers = ["amplitude"]\n[[vary]]\ntable = "points.csv"\n', encoding="utf-8"
    )
    (tmp_path / "points.csv").write_text("mass [kg],speed [rpm]\n39,900\n41,1000\n", encoding="utf-8")
    table = dalembert.study(path)
    assert table["mass"].tolist() == [39, 41]
    assert table["amplitude"][1] == pytest.approx(dalembert.solve(FAN, case=1, mass=41, speed="1000 rpm").amplitude.value, rel=1e-12)
    with pytest.raises(dalembert.InputError, match="unknown field `varry`"):
        dalembert.study({"problem": FAN, "varry": []})
    with pytest.raises(dalembert.InputError) as caught:
        dalembert.study({"problem": FAN, "vary": [{"input": "mas", "values": [1]}]})
    assert caught.value.errors[0].path.startswith("vary[1]")
