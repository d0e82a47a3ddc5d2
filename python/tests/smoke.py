"""The module without any other package: run by `cargo xtask verify` with the interpreter that is there."""

import json
import sys

import dalembert

FAN = "vibration/rotating-unbalance"


def main() -> None:
    fan = dalembert.solve(FAN, case=1)
    assert fan.amplitude.shown == "19.456 mm", fan.amplitude
    assert abs(float(fan.answers["amplitude"]) - 19.4564) < 5e-5
    numbers = dalembert.solve(
        FAN, mass=40, unbalance=0.1, speed="1000 rpm", damping={"ratio": {"ratio": 0.0617}}, set={"support.stiffness.stiffness": 451389}
    )
    assert numbers.notes == [] and numbers.warnings == [], numbers.notes
    assert abs(numbers.amplitude.si - 0.0194564) < 1e-4
    assert all(check.passed for check in fan.checks) and fan.checks
    assert json.loads(fan.to_json())["answers"]["amplitude"]["si"] == fan.amplitude.si
    assert fan._repr_html_().startswith('<div class="dalembert">') and "<svg" in fan._repr_html_()
    assert fan._repr_latex_().startswith("$$")
    try:
        dalembert.solve(FAN, case=1, mas="3 kg")
    except dalembert.InputError as error:
        assert error.errors[0].path == "mas" and error.errors[0].repair == "mass", error.errors
    else:
        raise AssertionError("a wrong name was accepted")
    assert len(dalembert.analyses()) > 100
    print(f"dalembert {dalembert.__version__}: {len(fan.answers)} answers, {len(fan.steps)} steps, Python {sys.version.split()[0]}")


if __name__ == "__main__":
    main()
