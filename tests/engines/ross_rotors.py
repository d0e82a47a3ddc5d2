"""Rotors of beam elements by the matrices of ROSS: damped frequencies, decrements, critical speeds, unbalance response."""

import math
import warnings
from importlib.metadata import version

import numpy as np
import scipy.linalg
from scipy.optimize import brentq

warnings.filterwarnings("ignore")
import ross

from rows import Rows

ROWS = Rows(
    "ROSS", version("ross-rotordynamics"), 1e-9, "Eigenvalues of the lateral part of its matrices by LAPACK."
)
STEEL = ("211e9", "81.2e9", "7810")


class Rotor:
    def __init__(self, segments, elements, discs, supports):
        steel = ross.Material("steel", rho=float(STEEL[2]), E=float(STEEL[0]), G_s=float(STEEL[1]))
        shaft, node = [], [0]
        for length, outer in segments:
            shaft += [
                ross.ShaftElement(
                    float(length) / elements,
                    0.0,
                    float(outer),
                    material=steel,
                    shear_effects=True,
                    rotary_inertia=True,
                    gyroscopic=True,
                )
                for _ in range(elements)
            ]
            node.append(node[-1] + elements)
        self.node = node
        discs = [ross.DiskElement(n=node[at], m=float(m), Id=float(d), Ip=float(p)) for at, m, d, p in discs]
        bearings = [
            ross.BearingElement(
                n=node[at], **({"cxx": 0.0} | {key: float(value) for key, value in of.items()})
            )
            for at, of in supports
        ]
        self.rotor = ross.Rotor(shaft, discs, bearings)
        # Six coordinates a node: x, y, z and the rotations about them; bending has four.
        self.lateral = [6 * n + k for n in range(node[-1] + 1) for k in (0, 1, 3, 4)]

    def matrices(self, speed):
        part = np.ix_(self.lateral, self.lateral)
        m, k = self.rotor.M()[part], self.rotor.K(speed)[part]
        return m, self.rotor.C(speed)[part] + speed * self.rotor.G()[part], k

    def modes(self, speed):
        m, c, k = self.matrices(speed)
        n = len(m)
        state = np.block([[np.zeros((n, n)), np.eye(n)], [-np.linalg.solve(m, k), -np.linalg.solve(m, c)]])
        values = [v for v in scipy.linalg.eigvals(state) if v.imag > 1e-3]
        return sorted(values, key=lambda v: v.imag)

    def critical(self, highest, step):
        speeds = np.arange(step, highest + step / 2, step)
        count = 12
        gaps = [[v.imag - speed for v in self.modes(speed)[:count]] for speed in speeds]
        found = []
        for i in range(count):
            for a, b, p, q in zip(speeds, speeds[1:], gaps, gaps[1:]):
                if p[i] * q[i] < 0:
                    found.append(brentq(lambda s: self.modes(s)[i].imag - s, a, b, xtol=1e-10, rtol=1e-14))
        return sorted(found)

    def response(self, at, size, angle, speed, place):
        """x and y at a node; the spin turns x towards y."""
        m, c, k = self.matrices(speed)
        force = np.zeros(len(m), complex)
        force[4 * self.node[at]] = size * speed**2 * np.exp(1j * angle)
        force[4 * self.node[at] + 1] = -1j * size * speed**2 * np.exp(1j * angle)
        moves = np.linalg.solve(k + 1j * speed * c - speed**2 * m, force)
        return moves[4 * self.node[place]], moves[4 * self.node[place] + 1]


def rotor(name, segments, elements, discs, supports, rpm, modes, highest, unbalance):
    of = Rotor(segments, elements, discs, supports)
    places = np.cumsum([0] + [float(length) for length, _ in segments])
    speed = float(rpm) * math.tau / 60
    answers = {}
    damped = any(key.startswith("c") for _, given in supports for key in given)
    for n, value in enumerate(of.modes(speed)[:modes]):
        answers[f"frequency[{n + 1}]"] = value.imag
        if damped:
            answers[f"damping_ratio[{n + 1}]"] = (-value.real / abs(value), 1e-8)
            answers[f"log_decrement[{n + 1}]"] = (-math.tau * value.real / value.imag, 1e-8)
    for n, value in enumerate(
        of.critical(float(highest) * math.tau / 60, float(highest) * math.tau / 60 / 40)
    ):
        answers[f"critical_speed[{n + 1}]"] = value
    at, size, degrees, place = unbalance
    x, y = of.response(at, float(size), math.radians(float(degrees)), speed, place)
    forward, backward = (x + 1j * y) / 2, (x - 1j * y).conjugate() / 2
    answers |= {
        "response_x": abs(x),
        "response_y": abs(y),
        "response_major": abs(forward) + abs(backward),
        "mass": sum(e.m for e in of.rotor.shaft_elements) + sum(d.m for d in of.rotor.disk_elements),
    }
    unit = lambda key: "N*s/m" if key.startswith("c") else "N/m"
    digits = lambda at: f"{places[at]:.6g}"
    ROWS.add(
        "vibration/rotor-dynamics",
        name,
        {
            "segments": [{"length": f"{length} m", "outer": f"{outer} m"} for length, outer in segments],
            "material": {
                "young": f"{STEEL[0]} Pa",
                "shear": f"{STEEL[1]} Pa",
                "density": f"{STEEL[2]} kg/m^3",
                "damping": "none",
            },
            "discs": [
                {
                    "position": f"{digits(at)} m",
                    "size": {
                        "inertia": {"mass": f"{m} kg", "diametral": f"{d} kg*m^2", "polar": f"{p} kg*m^2"}
                    },
                }
                for at, m, d, p in discs
            ],
            "supports": [
                {
                    "position": f"{digits(at)} m",
                    "bearing": {
                        "coefficients": {"kxy": "0 N/m", "kyx": "0 N/m"}
                        | {key: f"{value} {unit(key)}" for key, value in given.items()}
                    },
                }
                for at, given in supports
            ],
            "unbalances": [
                {"position": f"{digits(at)} m", "size": f"{size} kg*m", "angle": f"{degrees} deg"}
            ],
            "speed": f"{rpm} rpm",
            "highest_speed": f"{highest} rpm",
            "slope": "1",
            "place": f"{digits(place)} m",
            "theory": "timoshenko",
            "elements": elements,
            "modes": modes,
        },
        answers,
    )


plain = dict(kxx="1e6", kyy="0.8e6", cxx="200", cyy="150")
crossed = dict(kxx="4e7", kxy="2e6", kyx="-1.5e6", kyy="3e7", cxx="1.2e4", cxy="300", cyx="250", cyy="0.9e4")
rotor(
    "two discs between two bearings",
    [("0.5", "0.05"), ("0.4", "0.06"), ("0.6", "0.05")],
    2,
    [(1, "32.59", "0.1781", "0.3292"), (2, "50.6", "0.4044", "0.7677")],
    [(0, plain), (3, plain)],
    "4000",
    6,
    "5000",
    (1, "1e-3", "0", 1),
)
rotor(
    "an overhung disc",
    [("0.2", "0.06"), ("0.7", "0.08"), ("0.25", "0.07")],
    3,
    [(3, "45", "0.62", "1.1"), (0, "12", "0.05", "0.08")],
    [(1, crossed), (2, crossed)],
    "3000",
    6,
    "9000",
    (3, "2e-4", "35", 3),
)
rotor(
    "four discs, steps of diameter",
    [("0.3", "0.06"), ("0.25", "0.09"), ("0.25", "0.1"), ("0.25", "0.09"), ("0.3", "0.06")],
    2,
    [(1, "18", "0.12", "0.22"), (2, "25", "0.2", "0.37"), (3, "25", "0.2", "0.37"), (4, "15", "0.1", "0.18")],
    [(0, crossed), (5, plain)],
    "7200",
    8,
    "10000",
    (2, "5e-4", "120", 3),
)
rotor(
    "undamped, orthotropic",
    [("0.4", "0.04"), ("0.4", "0.04")],
    4,
    [(1, "20", "0.1", "0.2")],
    [(0, dict(kxx="2e7", kyy="1.1e7")), (2, dict(kxx="3e7", kyy="0.9e7"))],
    "5500",
    6,
    "20000",
    (1, "3e-4", "10", 1),
)
ROWS.write()
