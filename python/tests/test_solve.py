"""Solutions: answers, steps, errors, what is handed in and out."""

import copy
import json
import pickle
import threading

import dalembert
import pytest

FAN = "vibration/rotating-unbalance"

FILE = """
format = 2
analysis = "vibration/rotating-unbalance"
[inputs]
mass = "40 kg"
unbalance = "0.1 kg*m"
speed = "1000 rpm"
support.stiffness = { stiffness = "451.389 kN/m" }
damping.ratio = { ratio = 0.0617 }
"""


def test_answers_have_units():
    fan = dalembert.solve(FAN, case=1)
    amplitude = fan.answers["amplitude"]
    assert fan.amplitude == fan.answers.amplitude == amplitude
    assert (amplitude.unit, amplitude.si_unit, amplitude.shown) == ("mm", "m", "19.456 mm")
    assert amplitude.value == pytest.approx(1000 * amplitude.si, rel=1e-12)
    assert float(amplitude) == amplitude.value
    assert "amplitude" in dir(fan) and "amplitude = 19.456 mm" in repr(fan)
    with pytest.raises(AttributeError, match="there is no answer 'amplitud'"):
        fan.amplitud
    assert dalembert.solve(FAN, case=1, unit={"amplitude": "um"}).amplitude.unit == "um"
    assert dalembert.solve(FAN, case=1, units="in-lbf-s").amplitude.unit == "in"
    assert dalembert.solve(FAN, case=1, digits=3, lang="pt-BR").amplitude.shown == "19,5 mm"


def test_steps_are_a_graph():
    fan = dalembert.solve(FAN, case=1)
    steps = {step.number: step for step in fan.steps}
    amplitude = steps[fan.amplitude.step]
    assert amplitude.si == fan.amplitude.si
    # Every step leads back to inputs.
    seen, found, open_ = set(), set(), [amplitude.number]
    while open_:
        number = open_.pop()
        if number not in seen:
            seen.add(number)
            open_ += steps[number].from_steps
            found |= set(steps[number].from_inputs)
            assert all(before < number for before in steps[number].from_steps)
    assert {"mass", "unbalance", "speed"} <= found <= set(fan.inputs)
    assert str(amplitude).startswith("X = ")
    # Light damping is assumed where the peak is given.
    errors = [error for step in fan.steps if step.symbol == "ζ" for error in step.common_errors]
    assert any("light damping" in error.what and abs(error.value - 0.0616) < 5e-5 for error in errors)


def test_inputs_are_keywords_paths_or_groups():
    inputs = {"mass": 40, "unbalance": 0.1, "speed": "1000 rpm", "damping": 0.0617}
    a = dalembert.solve(FAN, set={"support.stiffness.stiffness": 451389}, **inputs)
    b = dalembert.solve(FAN, support={"stiffness": {"stiffness": "451.389 kN/m"}}, **inputs)
    c = dalembert.solve(FILE)
    assert a.notes == []
    for name in ("amplitude", "phase", "transmitted_force"):
        assert a.answers[name].si == pytest.approx(c.answers[name].si, rel=1e-12)
        assert b.answers[name].si == pytest.approx(c.answers[name].si, rel=1e-12)


def test_the_unit_of_a_number_is_listed():
    listed = {one.path: one for one in dalembert.inputs(FAN)}
    assert listed["mass"].unit == "kg" and listed["mass"].kind == "a mass"
    assert listed["speed"].unit == "rad/s"
    assert "cantilever" in listed["support"].names
    assert listed["support"].text in listed["support"].names
    changed = {one.path: one for one in dalembert.inputs(FAN, mass="41 kg")}
    assert changed["mass"].text == "41 kg" and changed["speed"].text == listed["speed"].text
    assert {one.path for one in dalembert.inputs(FILE)} > {"mass", "damping.ratio.ratio"}
    for path, one in listed.items():
        if one.unit and one.text:
            case = dalembert.solve(FAN, case=1)
            number = case.inputs[path]["si"]
            # Those of the fan have coherent units.
            if case.inputs[path]["si_unit"] == one.unit:
                again = dalembert.solve(FAN, case=1, set={path: number})
                assert again.inputs[path]["si"] == pytest.approx(number, rel=1e-15)


def test_an_answer_is_an_input_of_another_problem():
    first = dalembert.solve(FAN, case=1)
    second = dalembert.solve(FAN, case=1, mass=first.inputs["mass"]["text"], support={"stiffness": {"stiffness": first.stiffness}})
    assert second.amplitude.si == pytest.approx(first.amplitude.si, rel=1e-9)


def test_questions_definitions_and_unknowns():
    fan = dalembert.solve(FAN, case=1, ask={"peak to peak": "2*X"}, let={"bolt": "12 g"})
    asked = [answer for answer in fan.answers.values() if answer.label == "peak to peak"]
    assert asked and asked[0].si == pytest.approx(2 * fan.amplitude.si)
    assert fan.definitions["bolt"]["si"] == pytest.approx(0.012)
    assert len(dalembert.solve(FAN, case=1, ask=["rms_velocity"]).answers) == len(dalembert.solve(FAN, case=1).answers) + 1
    found = dalembert.solve(FAN, case=1, mass="?", given={"natural_frequency": "8.2 Hz"})
    assert found.unknowns["mass"]["si"]


def test_everything_that_is_wrong_is_said_at_once():
    with pytest.raises(dalembert.InputError) as caught:
        dalembert.solve(FAN, case=1, mas=3, speed="fast")
    assert isinstance(caught.value, ValueError)
    assert {error.path for error in caught.value.errors} == {"mas", "speed"}
    assert caught.value.errors[0].repair == "mass"
    again = pickle.loads(pickle.dumps(caught.value))
    assert again.errors == caught.value.errors
    with pytest.raises(dalembert.InputError) as caught:
        dalembert.solve(FILE.replace("40 kg", "40 km"))
    assert (caught.value.errors[0].path, caught.value.errors[0].line) == ("mass", 5)
    with pytest.raises(dalembert.InputError, match="did you mean `vibration/rotating-unbalance`"):
        dalembert.solve("vibration/rotating-unbalanc")
    with pytest.raises(dalembert.InputError, match="unit = 3: a text is needed here"):
        dalembert.solve(FAN, case=1, unit={"amplitude": 3})
    with pytest.raises(TypeError, match="not a finite number"):
        dalembert.solve(FAN, case=1, mass=float("nan"))
    with pytest.raises(TypeError, match="a object is no value"):
        dalembert.solve(FAN, case=1, mass=object())


def test_a_refusal_is_an_exception():
    refused = [
        (analysis["id"], n + 1)
        for analysis in dalembert.analyses("field balancing")
        for n, case in enumerate(dalembert.describe(analysis["id"])["cases"])
        if case["refused"]
    ]
    id, case = refused[0]
    with pytest.raises(dalembert.Refusal) as caught:
        dalembert.solve(id, case=case)
    assert caught.value.errors[0].message


def test_a_solution_is_written_and_sent():
    fan = dalembert.solve(FAN, case=1)
    assert fan.html().startswith("<!DOCTYPE html>") and "<svg" in fan.html()
    assert "\\documentclass" in fan.latex() and fan.markdown().startswith("# Rotating unbalance")
    assert str(fan).startswith("Rotating unbalance")
    assert fan._repr_latex_().count("&=") == len(fan.steps)
    assert fan.to_dict()["format"] == dalembert.schema()["properties"]["format"]["const"]
    assert json.loads(fan.to_json())["plots"][0]["curves"][0]["x"]
    assert len(fan.plots[0]["curves"][0]["x"]) == len(fan.plots[0]["curves"][0]["y"])
    for other in (pickle.loads(pickle.dumps(fan)), copy.deepcopy(fan)):
        assert other.to_json() == fan.to_json()


def test_no_input_hides_behind_an_option():
    """An input of the name of an option is set by `set`."""
    options = set(dalembert.solve.__kwdefaults__)
    named = {one["name"]: analysis["id"] for analysis in dalembert.analyses() for one in _inputs(analysis["id"])}
    hidden = {name: id for name, id in named.items() if name in options - {"case"}}
    assert not hidden, hidden


def _inputs(id):
    try:
        return dalembert.describe(id)["inputs"]
    except dalembert.InputError:
        return []


def test_threads_solve_at_once():
    expected = dalembert.solve(FAN, case=1).to_json()
    wrong = []

    def work():
        for _ in range(20):
            if dalembert.solve(FAN, case=1).to_json() != expected:
                wrong.append(1)

    threads = [threading.Thread(target=work) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong
