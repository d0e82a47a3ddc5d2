"""Motions of closed linkages by Exudyn: implicit trapezoidal rule with constraints, extrapolated over halved steps."""

import math
import sys
from importlib.metadata import version

sys.exudynFast = True
import exudyn
import numpy as np
from exudyn.utilities import (
    LoadForceVector,
    MarkerBodyPosition,
    MarkerBodyRigid,
    NodeRigidBody2D,
    ObjectGround,
    RevoluteJoint2D,
    RigidBody2D,
)

from rows import Draw, Rows

ROWS = Rows(
    "Exudyn",
    version("exudyn"),
    None,
    "Steps, half, quarter and eighth steps of a rule of order 2, extrapolated; a number is allowed thrice what the last halving changed.",
)


def run(parts, pins, steps, duration, names):
    """Parts: mass, inertia, mass centre, angle, rate and velocity of the centre at the start; pins: place and two parts."""
    container = exudyn.SystemContainer()
    system = container.AddSystem()
    ground = system.AddObject(ObjectGround())
    bodies, nodes = [], []
    for mass, inertia, centre, angle, velocity, rate in parts:
        node = system.AddNode(
            NodeRigidBody2D(referenceCoordinates=[*centre, angle], initialVelocities=[*velocity, rate])
        )
        body = system.AddObject(RigidBody2D(mass=mass, inertia=inertia, nodeNumber=node))
        system.AddLoad(
            LoadForceVector(
                markerNumber=system.AddMarker(MarkerBodyPosition(bodyNumber=body)),
                loadVector=[0, -9.81 * mass, 0],
            )
        )
        bodies.append(body)
        nodes.append(node)

    def marker(part, place):
        if part is None:
            return system.AddMarker(MarkerBodyRigid(bodyNumber=ground, localPosition=[*place, 0]))
        _, _, centre, angle, _, _ = parts[part]
        x, y = place[0] - centre[0], place[1] - centre[1]
        local = [x * math.cos(angle) + y * math.sin(angle), -x * math.sin(angle) + y * math.cos(angle), 0]
        return system.AddMarker(MarkerBodyPosition(bodyNumber=bodies[part], localPosition=local))

    for place, one, two in pins:
        system.AddObject(RevoluteJoint2D(markerNumbers=[marker(one, place), marker(two, place)]))
    system.Assemble()
    settings = exudyn.SimulationSettings()
    of = settings.timeIntegration
    of.numberOfSteps, of.endTime, of.verboseMode = steps, duration, 0
    settings.solution.file.write = False
    of.generalizedAlpha.spectralRadius = 1
    of.generalizedAlpha.useNewmark = True
    of.generalizedAlpha.useIndex2Constraints = True
    of.generalizedAlpha.computeInitialAccelerations = True
    of.newton.relativeTolerance, of.newton.absoluteTolerance = 1e-12, 1e-12
    system.SolveDynamic(settings)
    seen = []
    for n in names:
        seen.append(system.GetNodeOutput(nodes[n], exudyn.OutputVariableType.Coordinates)[2] + parts[n][3])
        seen.append(system.GetNodeOutput(nodes[n], exudyn.OutputVariableType.Coordinates_t)[2])
    return np.array(seen)


def extrapolated(parts, pins, steps, duration, names):
    column = [run(parts, pins, steps * 2**n, duration, names) for n in range(4)]
    for order in (2, 4):
        column = [b + (b - a) / (2**order - 1) for a, b in zip(column, column[1:])]
    return column[-1], np.abs(column[-1] - column[-2])


def four_bars():
    draw = Draw(71)
    for degrees, rate, duration in (("60", "0", "0.5"), ("95", "4", "0.4"), ("120", "-5", "0.6")):
        lengths = draw.floats((0.2, 0.3), (0.4, 0.5), (0.3, 0.4), (0.45, 0.55))
        masses = draw.floats((0.5, 1.5), (0.5, 1.5), (0.5, 1.5))
        inertias = draw.floats((0.003, 0.01), (0.01, 0.02), (0.005, 0.015))
        a, b, c, d = map(float, lengths)
        th, omega = math.radians(float(degrees)), float(rate)
        pin = np.array([a * math.cos(th), a * math.sin(th)])
        to = np.array([d, 0]) - pin
        far = math.hypot(*to)
        along = (b**2 - c**2 + far**2) / (2 * far)
        across = math.sqrt(b**2 - along**2)
        unit = to / far
        end = pin + along * unit + across * np.array([-unit[1], unit[0]])
        three, four = math.atan2(*(end - pin)[::-1]), math.atan2(*(end - [d, 0])[::-1])
        # Rates of coupler and rocker that keep the loop closed.
        w3, w4 = np.linalg.solve(
            [[-b * math.sin(three), c * math.sin(four)], [b * math.cos(three), -c * math.cos(four)]],
            [a * math.sin(th) * omega, -a * math.cos(th) * omega],
        )
        turned = lambda point, w: np.array([-point[1], point[0]]) * w
        parts = [
            (float(masses[0]), float(inertias[0]), pin / 2, th, turned(pin / 2, omega), omega),
            (
                float(masses[1]),
                float(inertias[1]),
                (pin + end) / 2,
                three,
                turned(pin, omega) + turned((end - pin) / 2, w3),
                w3,
            ),
            (
                float(masses[2]),
                float(inertias[2]),
                (end + [d, 0]) / 2,
                four,
                turned((end - [d, 0]) / 2, w4),
                w4,
            ),
        ]
        pins = [((0, 0), None, 0), (pin, 0, 1), (end, 1, 2), ((d, 0), None, 2)]
        seen, open_ = extrapolated(parts, pins, 2000, float(duration), (0, 1, 2))
        keys = [f"{kind}[{n}]" for n in (1, 2, 3) for kind in ("angle", "angular_velocity")]
        answers = {
            key: (value, max(3 * left / abs(value), 1e-9)) for key, value, left in zip(keys, seen, open_)
        }
        on = lambda body: {"body": {"body": body}}
        names = ("crank", "coupler", "rocker")
        angles = (degrees, f"{math.degrees(three):.3f}", f"{math.degrees(four):.3f}")
        ROWS.add(
            "virtual-work/motion",
            f"four-bar from {degrees} degrees",
            {
                "bodies": [
                    {
                        "name": name,
                        "mass": f"{m} kg",
                        "inertia": f"{j} kg*m^2",
                        "centre": f"({float(l) / 2:.10g}; 0) m",
                        "angle": f"{angle} deg",
                    }
                    for name, m, j, l, angle in zip(names, masses, inertias, lengths, angles)
                ],
                "points": [
                    {"name": "O", "on": "ground", "at": "(0; 0) m"},
                    {"name": "C", "on": "ground", "at": f"({lengths[3]}; 0) m"},
                    {"name": "O2", "on": on("crank"), "at": "(0; 0) m"},
                    {"name": "A2", "on": on("crank"), "at": f"({lengths[0]}; 0) m"},
                    {"name": "A3", "on": on("coupler"), "at": "(0; 0) m"},
                    {"name": "B3", "on": on("coupler"), "at": f"({lengths[1]}; 0) m"},
                    {"name": "C4", "on": on("rocker"), "at": "(0; 0) m"},
                    {"name": "B4", "on": on("rocker"), "at": f"({lengths[2]}; 0) m"},
                ],
                "joints": [
                    {"name": "O", "joint": {"pin": {"a": "O", "b": "O2"}}},
                    {"name": "A", "joint": {"pin": {"a": "A2", "b": "A3"}}},
                    {"name": "B", "joint": {"pin": {"a": "B3", "b": "B4"}}},
                    {"name": "C", "joint": {"pin": {"a": "C", "b": "C4"}}},
                ],
                "gravity": "(0; -9.81) m/s^2",
                "duration": f"{duration} s",
                "end": "nothing",
                "starts": [
                    {
                        "name": "start",
                        "what": {
                            "angle": {
                                "body": "crank",
                                "against": "ground",
                                "value": f"{degrees} deg",
                                "velocity": f"{rate} rad/s",
                            }
                        },
                    }
                ],
            },
            answers,
        )


four_bars()
ROWS.write()
