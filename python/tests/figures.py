"""Prints what a call of `solve` and a point of `sweep` take."""

import time

import dalembert
import numpy as np

FAN = "vibration/rotating-unbalance"
INPUTS = {"mass": 40, "unbalance": 0.1, "support": {"stiffness": {"stiffness": 451389}}, "damping": {"ratio": {"ratio": 0.06}}}


def timed(call, times):
    call(0)
    start = time.perf_counter()
    for n in range(times):
        call(n)
    return (time.perf_counter() - start) / times


def main() -> None:
    print(f"solve, an answer read: {1e6 * timed(lambda n: dalembert.solve(FAN, speed=90.0 + n % 50, **INPUTS).amplitude, 2000):.0f} µs")
    print(f"solve from a case:     {1e6 * timed(lambda n: dalembert.solve(FAN, case=1, speed=90.0 + n % 50).amplitude, 2000):.0f} µs")
    print(f"whole result as JSON:  {1e6 * timed(lambda n: dalembert.solve(FAN, case=1, speed=90.0 + n % 50).to_json(), 500):.0f} µs")
    speeds = np.linspace(60, 160, 2_000_000)
    for threads in (1, None):
        point = timed(lambda n: dalembert.sweep(FAN, {"speed": speeds}, answers=["amplitude"], case=1, threads=threads), 3) / speeds.size
        print(f"sweep, {'all' if threads is None else threads} thread{'s' if threads is None else ''}:   {1e9 * point:.0f} ns a point")
    plan = {"problem": FAN, "answers": ["amplitude"], "samples": 1_000_000, "vary": [{"input": "mass", "distribution": "normal", "deviation": "2 %"}]}
    print(f"study of a million samples with its table: {timed(lambda n: dalembert.study(plan), 1):.2f} s")


if __name__ == "__main__":
    main()
