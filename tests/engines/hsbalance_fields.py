"""Correction weights of field balancing by hsbalance: influence coefficients, least squares, least largest reading."""

import cmath
import logging
import math
from importlib.metadata import version

import numpy as np
from hsbalance.IC_matrix import Alpha
from hsbalance.model import LeastSquares, Min_max

from rows import Draw, Rows

logging.disable(logging.WARNING)
ROWS = Rows(
    "hsbalance",
    version("hsbalance"),
    1e-8,
    "Its solver stops early; each row is allowed what its own optimality leaves open.",
)


def polar(draw, least, most):
    return draw(least, most), draw(5, 355)


def number(pair):
    return float(pair[0]) * cmath.exp(1j * math.radians(float(pair[1])))


def reading(pair):
    return {"amplitude": f"{pair[0]} mm/s", "phase": f"{pair[1]} deg"}


def field(draw, planes, readings, stay, method):
    first = [polar(draw, 20, 90) for _ in range(readings)]
    trials = [polar(draw, 5, 20) for _ in range(planes)]
    runs = [[polar(draw, 20, 90) for _ in range(readings)] for _ in range(planes)]
    a = np.array([[number(pair)] for pair in first])
    b = np.array([[number(run[s]) for run in runs] for s in range(readings)])
    alpha = Alpha()
    alpha.add(A=a, B=b, U=np.array([number(trial) for trial in trials]), keep_trial=stay)
    model = {"least-squares": LeastSquares, "min-max": Min_max}[method](A=a, alpha=alpha)
    weights = model.solve()[:, 0]
    left = abs(model.expected_residual_vibration().ravel())
    if method == "least-squares":
        # What a step of Newton's would still change is what the solver stopped short of.
        rest = np.linalg.lstsq(model.ALPHA, model.ALPHA @ weights + a[:, 0], rcond=None)[0]
        open_ = 3 * abs(rest)
    else:
        # The optimum is flat: a weight is known as the root of what the solver leaves of the largest reading.
        open_ = 3e-5 * abs(weights)
    answers = {}
    for n, weight in enumerate(weights):
        answers[f"correction[{n + 1}]"] = (abs(weight) / 1000, open_[n] / abs(weight))
        angles = [("correction_angle", cmath.phase(weight))]
        if method == "least-squares":
            angles.append(("existing_angle", cmath.phase(-weight)))
        for key, angle in angles:
            answers[f"{key}[{n + 1}]"] = (angle % math.tau, open_[n] / abs(weight) / (angle % math.tau))
    if readings > planes:
        answers["largest_residual"] = (left.max() / 1000, 1e-5 if method == "least-squares" else 1e-7)
        answers["rms_residual"] = (math.sqrt((left**2).mean()) / 1000, 1e-5)
    ROWS.add(
        "balancing/field",
        f"{planes} planes, {readings} readings{', trial weights left on' if stay else ''}, {method}",
        {
            "measured": {
                "velocity": {
                    "first": [reading(pair) for pair in first],
                    "influence": {
                        "runs": {
                            "after": "stay" if stay else "taken-off",
                            "runs": [
                                {
                                    "plane": n + 1,
                                    "mass": f"{trial[0]} g",
                                    "angle": f"{trial[1]} deg",
                                    "readings": [reading(pair) for pair in run],
                                }
                                for n, (trial, run) in enumerate(zip(trials, runs))
                            ],
                        }
                    },
                }
            },
            # A phase that grows when the weight is moved with the rotation adds up as complex numbers do.
            "phase": "lead",
            "angles": "with",
            "method": {"min-max": {}} if method == "min-max" else method,
            "amplitude_uncertainty": "1 %",
            "phase_uncertainty": "1 deg",
        },
        answers,
    )


DRAW = Draw(51)
for planes, readings, stay, method in (
    (1, 1, False, "least-squares"),
    (2, 2, False, "least-squares"),
    (2, 2, True, "least-squares"),
    (3, 3, False, "least-squares"),
    (3, 3, True, "least-squares"),
    (2, 4, False, "least-squares"),
    (3, 8, True, "least-squares"),
    (2, 4, False, "min-max"),
    (3, 6, False, "min-max"),
):
    field(DRAW, planes, readings, stay, method)
ROWS.write()
