"""Largest and least values of a motion by SciPy: roots of the slope of a spectrum, an exponential, an integrator."""

import cmath
import math

import numpy as np
import scipy
from scipy.integrate import solve_ivp
from scipy.linalg import expm
from scipy.optimize import brentq, minimize_scalar

from rows import Draw, Rows, vector

ROWS = Rows(
    "SciPy",
    scipy.__version__,
    1e-8,
    "A largest value is as flat as its place is uncertain; 1e-8 is what the spectra and the integrator hold.",
)


def largest(values):
    """Largest value of a periodic function from its samples: its trigonometric polynomial, refined about the best."""
    n = len(values)
    parts = np.fft.rfft(values) / n
    order = np.arange(len(parts))
    weight = np.where(order == 0, 1, 2)
    at = lambda th: (weight * (parts * np.exp(1j * order * th)).real).sum()
    best = 2 * math.pi * values.argmax() / n
    found = minimize_scalar(
        lambda th: -at(th), bracket=(best - 2 * math.pi / n, best, best + 2 * math.pi / n), tol=1e-12
    )
    return -found.fun


def rate(values, times=1):
    """A derivative of a periodic function of the crank angle, by its spectrum."""
    n = len(values)
    orders = 1j * np.fft.fftfreq(n, 1 / n)
    return np.fft.ifft(np.fft.fft(values) * orders**times)


def shaking():
    """Force on the frame of a linkage at constant speed: the second derivative of its moment of mass."""
    draw = Draw(32)
    th = np.arange(2048) * 2 * math.pi / 2048
    body = lambda m, rho, off, j: {
        "mass": f"{m} kg",
        "distance": f"{rho} m",
        "offset": f"{off} deg",
        "inertia": f"{j} kg*m^2",
    }
    for _ in range(2):
        a, b, c, d, w = draw.floats((0.03, 0.04), (0.11, 0.13), (0.08, 0.09), (0.1, 0.11), (20, 60))
        bodies = [draw.floats((0.2, 0.6), (0.015, 0.05), (-30, 30), (1e-4, 9e-4)) for _ in range(3)]
        af, bf, cf, df, wf = map(float, (a, b, c, d, w))
        pin = af * np.exp(1j * th)
        to = df - pin
        along = (bf**2 - cf**2 + abs(to) ** 2) / (2 * abs(to))
        end = pin + to / abs(to) * (along + 1j * np.sqrt(bf**2 - along**2))
        lines = [(0, pin / af), (pin, (end - pin) / bf), (df, (end - df) / cf)]
        moment, energy = 0, 0
        for (m, rho, off, j), (start, unit) in zip(bodies, lines):
            centre = start + float(rho) * cmath.exp(1j * math.radians(float(off))) * unit
            moment = moment + float(m) * centre
            energy = (
                energy + wf**2 * (float(m) * abs(rate(centre)) ** 2 + float(j) * abs(rate(unit)) ** 2) / 2
            )
        ROWS.add(
            "balancing/linkage-balance",
            f"four-bar at {w} rad/s",
            {
                "mechanism": {
                    "four-bar": {
                        "crank": f"{a} m",
                        "coupler": f"{b} m",
                        "rocker": f"{c} m",
                        "frame": f"{d} m",
                        "closing": "open",
                        "crank_body": body(*bodies[0]),
                        "coupler_body": body(*bodies[1]),
                        "rocker_body": body(*bodies[2]),
                    }
                },
                "speed": f"{w} rad/s",
                "crank_radius": f"{a} m",
                "other_radius": f"{c} m",
            },
            {
                "shaking_force": (math.sqrt(largest(abs(rate(moment, 2) * wf**2) ** 2)), 1e-8),
                "torque": (max(largest(rate(energy).real), largest(-rate(energy).real)), 1e-8),
            },
        )


def responses():
    """Chains under a harmonic force for a long time: every turning point of the exact motion is looked at."""
    draw = Draw(39)
    for count, duration in ((2, "60"), (3, "200")):
        links = [draw.floats((1, 8), (400, 3000), (0.02, 0.2)) for _ in range(count)]
        force, omega = draw.floats((20, 90), (5, 25))
        m, c, k = (np.zeros((count, count)) for _ in range(3))
        for i, (mass, spring, damper) in enumerate(links):
            along = np.eye(count)[i] - (np.eye(count)[i - 1] if i else 0)
            m[i, i] = float(mass)
            k += float(spring) * np.outer(along, along)
            c += float(damper) * np.outer(along, along)
        big = np.zeros((2 * count + 2, 2 * count + 2))
        big[:count, count : 2 * count] = np.eye(count)
        big[count : 2 * count, :count], big[count : 2 * count, count : 2 * count] = -np.linalg.solve(
            m, k
        ), -np.linalg.solve(m, c)
        big[count, -2] = float(force) / m[0, 0]
        big[-2, -1], big[-1, -2] = -float(omega), float(omega)
        state = np.zeros(2 * count + 2)
        state[-2] = 1
        steps = int(float(duration) * 200)
        step = expm(big * float(duration) / steps)
        states = [state]
        for _ in range(steps):
            states.append(step @ states[-1])
        states = np.array(states)
        answers = {}
        for i in range(count):
            x, v = states[:, i], states[:, count + i]
            best = (x[-1], float(duration))
            for n in np.flatnonzero(v[:-1] * v[1:] < 0):
                if max(abs(x[n]), abs(x[n + 1])) < 0.9 * abs(best[0]):
                    continue
                at = brentq(
                    lambda t: (expm(big * t) @ states[n])[count + i], 0, float(duration) / steps, xtol=1e-15
                )
                value = (expm(big * at) @ states[n])[i]
                if abs(value) > abs(best[0]):
                    best = (value, n * float(duration) / steps + at)
            answers |= {f"largest[{i + 1}]": best[0], f"largest_time[{i + 1}]": best[1]}
        ROWS.add(
            "vibration/multi-degree-response",
            f"{count} masses for {duration} s",
            {
                "system": {
                    "chain": {
                        "masses": [
                            {"mass": f"{a} kg", "spring": f"{b} N/m", "damper": f"{d} N*s/m"}
                            for a, b, d in links
                        ]
                    }
                },
                "damping": "dampers",
                "forces": [
                    {
                        "coordinate": 1,
                        "course": {
                            "harmonic": {"force": f"{force} N", "frequency": f"{omega} rad/s", "lag": "0 deg"}
                        },
                    }
                ],
                "times": "[s]\n1",
                "observed": [{"coordinate": i + 1} for i in range(count)],
                "duration": f"{duration} s",
            },
            answers,
        )


def tilts():
    """A body without symmetry about a fixed point: the angle of its axis where the axis neither rises nor falls."""
    draw = Draw(40)
    for duration in ("3", "7"):
        mass, x, y, z = draw.floats((2, 5), (0.05, 0.09), (0.05, 0.09), (0.05, 0.09))
        height, nutation = draw.floats((0.05, 0.1), (20, 50))
        omega = draw.floats((-1, 1), (-1, 1), (20, 40))
        g, l = float(mass) * 9.81, float(height)
        extra = float(mass) * l * l
        j = np.array([float(x) + extra, float(y) + extra, float(z)])
        th = math.radians(float(nutation))

        def rates(_, s):
            w, up = s[:3], s[3:]
            # The vertical in the axes of the body, and the moment of the weight at (0, 0, l).
            return np.concatenate([(np.cross([0, 0, l], -g * up) - np.cross(w, j * w)) / j, np.cross(up, w)])

        level = lambda t, s: np.cross(s[3:], s[:3])[2]
        run = solve_ivp(
            rates,
            (0, float(duration)),
            [*map(float, omega), 0, math.sin(th), math.cos(th)],
            method="DOP853",
            rtol=1e-13,
            atol=1e-15,
            events=level,
            dense_output=True,
        )
        tilt = lambda s: math.acos(s[5])
        seen = [tilt(run.y[:, 0]), tilt(run.y[:, -1])] + [tilt(s) for s in run.y_events[0]]
        ROWS.add(
            "rigid-body/motion",
            f"tilt of a heavy body in {duration} s",
            {
                "pivot": {
                    "fixed-point": {
                        "mass": f"{mass} kg",
                        "centre": f"(0; 0; {height}) m",
                        "about": "mass-centre",
                        "gravity": "9.81 m/s^2",
                    }
                },
                "moments": {"principal": {"x": f"{x} kg*m^2", "y": f"{y} kg*m^2", "z": f"{z} kg*m^2"}},
                "attitude": {
                    "euler": {"precession": "0 deg", "nutation": f"{nutation} deg", "spin": "0 deg"}
                },
                "velocity": {"body": {"omega": vector(omega, "rad/s")}},
                "axis": "z",
                "duration": f"{duration} s",
                "end": "nothing",
            },
            {"least_tilt": min(seen), "largest_tilt": max(seen)},
        )


shaking()
responses()
tilts()
ROWS.write()
