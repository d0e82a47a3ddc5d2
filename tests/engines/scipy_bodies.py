"""Rotors, linkages and bodies by SciPy: sums of complex numbers, integrals over bodies, roots."""

import cmath
import math

import numpy as np
import scipy
from scipy.integrate import quad
from scipy.linalg import expm
from scipy.optimize import brentq

from rows import Draw, Rows, vector

ROWS = Rows(
    "SciPy",
    scipy.__version__,
    1e-10,
    "Linear solves, quadrature and roots to double precision; where it takes more, a row has its own.",
)
turn = lambda degrees: cmath.exp(1j * math.radians(float(degrees)))


def balancing():
    draw = Draw(31)
    for count in (3, 5):
        masses = [draw.floats((2, 9), (0.03, 0.09), (0, 359)) for _ in range(count)]
        radius, speed = draw.floats((0.05, 0.1), (40, 150))
        total = sum(float(m) * float(r) * turn(a) for m, r, a in masses)
        ROWS.add(
            "balancing/single-plane",
            f"{count} masses",
            {
                "masses": [
                    {"amount": {"mass": {"mass": f"{m} kg"}}, "radius": f"{r} m", "angle": f"{a} deg"}
                    for m, r, a in masses
                ],
                "angles": "absolute",
                "correction": {"radius": {"radius": f"{radius} m"}},
                "way": "add",
                "gravity": "9.81 m/s^2",
            },
            {
                "unbalance": abs(total),
                "mass": abs(total) / float(radius),
                "angle": cmath.phase(-total) % math.tau,
            },
        )
    for count in (2, 4):
        masses = [draw.floats((2, 9), (0.03, 0.09), (0, 359), (0.05, 0.5)) for _ in range(count)]
        za, zb, ra, rb = draw.floats((-0.1, 0.03), (0.55, 0.7), (0.05, 0.1), (0.05, 0.1))
        products = [(float(m) * float(r) * turn(a), float(z)) for m, r, a, z in masses]
        needs = -np.array([sum(u for u, _ in products), sum(u * z for u, z in products)])
        planes = np.linalg.solve([[1, 1], [float(za), float(zb)]], needs)
        ROWS.add(
            "balancing/two-plane",
            f"{count} masses",
            {
                "masses": [
                    {"mass": f"{m} kg", "radius": f"{r} m", "angle": f"{a} deg", "position": f"{z} m"}
                    for m, r, a, z in masses
                ],
                "plane_a": f"{za} m",
                "plane_b": f"{zb} m",
                "correction_a": {"radius": {"radius": f"{ra} m"}},
                "correction_b": {"radius": {"radius": f"{rb} m"}},
                "way": "add",
                "gravity": "9.81 m/s^2",
            },
            {
                "unbalance_a": abs(planes[0]),
                "angle_a": cmath.phase(planes[0]) % math.tau,
                "mass_a": abs(planes[0]) / float(ra),
                "unbalance_b": abs(planes[1]),
                "angle_b": cmath.phase(planes[1]) % math.tau,
                "mass_b": abs(planes[1]) / float(rb),
            },
        )
        zi, zj, speed = draw.floats((-0.3, -0.15), (0.8, 1), (80, 200))
        w = float(speed)
        loads = np.linalg.solve([[1, 1], [float(zi), float(zj)]], -needs) * w * w
        ROWS.add(
            "balancing/known-masses",
            f"{count} masses on two bearings",
            {
                "masses": [
                    {
                        "amount": {"mass": {"mass": f"{m} kg"}},
                        "radius": f"{r} m",
                        "angle": f"{a} deg",
                        "position": f"{z} m",
                    }
                    for m, r, a, z in masses
                ],
                "angles": "absolute",
                "gravity": "9.81 m/s^2",
                "task": {
                    "planes": {
                        "planes": [
                            {"position": f"{za} m", "correction": {"radius": {"radius": f"{ra} m"}}},
                            {"position": f"{zb} m", "correction": {"radius": {"radius": f"{rb} m"}}},
                        ],
                        "way": "add",
                    }
                },
                "bearings": {"first": f"{zi} m", "second": f"{zj} m", "speed": f"{speed} rad/s"},
            },
            {
                "correction[1]": abs(planes[0]),
                "correction_angle[1]": cmath.phase(planes[0]) % math.tau,
                "correction[2]": abs(planes[1]),
                "correction_angle[2]": cmath.phase(planes[1]) % math.tau,
                "bearing_first": abs(loads[0]),
                "bearing_second": abs(loads[1]),
                "resultant": abs(needs[0]),
            },
        )


def flywheels():
    draw = Draw(33)
    for orders in ((2, 4), (1, 2, 3)):
        mean, rpm, inertia = draw.floats((300, 900), (200, 400), (20, 60))
        parts = [(k, *draw.floats((-600, 600), (-600, 600))) for k in orders]
        torque = lambda th: sum(
            float(a) * math.sin(k * th) + float(b) * math.cos(k * th) for k, a, b in parts
        )
        places = np.linspace(0, 2 * math.pi, 721)
        crossings = [
            brentq(torque, p, q, xtol=1e-15) for p, q in zip(places, places[1:]) if torque(p) * torque(q) < 0
        ]
        levels = np.cumsum(
            [0] + [quad(torque, p, q, epsrel=1e-13)[0] for p, q in zip(crossings, crossings[1:])]
        )
        change, w = levels.max() - levels.min(), float(rpm) * 2 * math.pi / 60
        spread = change / (float(inertia) * w * w)
        ROWS.add(
            "virtual-work/flywheel",
            f"orders {orders}",
            {
                "moment": {
                    "harmonics": {
                        "mean": f"{mean} N*m",
                        "rows": "k; a [N*m]; b [N*m]\n" + "\n".join(f"{k}; {a}; {b}" for k, a, b in parts),
                    }
                },
                "speed": f"{rpm} rpm",
                "sought": {"fluctuation": {"inertia": {"moment": {"inertia": f"{inertia} kg*m^2"}}}},
            },
            {"energy_fluctuation": change, "fluctuation": spread, "power": float(mean) * w},
        )


def inertias():
    """Solids of revolution: mass, height of the mass centre and moments about it as integrals over discs."""
    draw = Draw(34)
    for shape, radius_at in (
        ("cone", lambda z, r, h: r * (1 - z / h)),
        ("paraboloid", lambda z, r, h: r * math.sqrt(1 - z / h)),
        ("cylinder", lambda z, r, h: r),
        ("hemisphere", lambda z, r, h: math.sqrt(r * r - z * z)),
        ("sphere", lambda z, r, h: math.sqrt(r * r - (z - r) ** 2)),
    ):
        r, h, density = draw.floats((0.1, 0.3), (0.3, 0.6), (1000, 8000))
        place = draw.floats((-0.3, 0.3), (-0.3, 0.3), (-0.3, 0.3))
        rf, rho = float(r), float(density)
        top = {"hemisphere": rf, "sphere": 2 * rf}.get(shape, float(h))
        over = lambda of: quad(
            lambda z: of(z, radius_at(z, rf, top)), 0, top, epsabs=0, epsrel=1e-13, limit=200
        )[0]
        area = lambda s: rho * math.pi * s * s
        mass = over(lambda z, s: area(s))
        centre = over(lambda z, s: area(s) * z) / mass
        axial = over(lambda z, s: area(s) * s * s / 2)
        across = over(lambda z, s: area(s) * (s * s / 4 + (z - centre) ** 2))
        x, y, z = map(float, place)
        fields = {"radius": f"{r} m"} | (
            {"height": f"{h} m"} if shape in ("cone", "paraboloid", "cylinder") else {}
        )
        part = {
            "name": "body",
            "shape": {shape: fields},
            "amount": {"per-volume": {"density": f"{density} kg/m^3"}},
            "position": vector(place, "m"),
            "reference": "mass-centre",
            "direction": "same",
            "presence": "material",
        }
        ROWS.add(
            "rigid-body/mass-properties",
            shape,
            {"body": {"parts": {"parts": [part]}}, "point": "(0; 0; 0) m"},
            {
                "mass": mass,
                "inertia_x": across,
                "inertia_y": across,
                "inertia_z": axial,
                "radius_z": math.sqrt(axial / mass),
                "point_inertia_x": across + mass * (y * y + z * z),
                "point_inertia_z": axial + mass * (x * x + y * y),
            },
        )
    # Particles: the principal moments are eigenvalues.
    particles = [draw.floats((1, 4), (-0.4, 0.4), (-0.4, 0.4), (-0.4, 0.4)) for _ in range(5)]
    m = np.array([float(p[0]) for p in particles])
    at = np.array([[float(c) for c in p[1:]] for p in particles])
    centre = m @ at / m.sum()
    tensor = lambda r: sum(mass * ((p @ p) * np.eye(3) - np.outer(p, p)) for mass, p in zip(m, r))
    own = np.linalg.eigvalsh(tensor(at - centre))
    whole, about = tensor(at), tensor(at - centre)
    ROWS.add(
        "rigid-body/mass-properties",
        "five particles",
        {
            "body": {
                "parts": {
                    "parts": [
                        {
                            "name": f"p{n + 1}",
                            "shape": "particle",
                            "amount": {"mass": {"mass": f"{p[0]} kg"}},
                            "position": vector(p[1:], "m"),
                            "reference": "origin",
                            "direction": "same",
                            "presence": "material",
                        }
                        for n, p in enumerate(particles)
                    ]
                }
            },
            "point": "(0; 0; 0) m",
        },
        {
            "centre": list(centre),
            "inertia_x": about[0, 0],
            "product_xy": -about[0, 1],
            "product_yz": -about[1, 2],
            "product_zx": -about[0, 2],
            "point_inertia_y": whole[1, 1],
            "point_product_xy": -whole[0, 1],
        }
        | {f"principal_inertia[{n + 1}]": v for n, v in enumerate(own)},
    )


def spin(axis):
    x, y, z = np.array(axis) / np.linalg.norm(axis)
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def rotations():
    """Products of exponentials with their first and second derivatives."""
    draw = Draw(35)
    for count in (2, 3):
        joints = [
            (draw.floats((-1, 1), (-1, 1), (-1, 1)), draw(-90, 90), draw(-6, 6), draw(-9, 9))
            for _ in range(count)
        ]
        place = draw.floats((-0.3, 0.3), (0.1, 0.4), (-0.3, 0.3))
        r = (np.eye(3), np.zeros((3, 3)), np.zeros((3, 3)))
        for axis, angle, speed, gain in joints:
            k = spin([float(x) for x in axis])
            e = expm(k * math.radians(float(angle)))
            e = (e, k @ e * float(speed), k @ e * float(gain) + k @ k @ e * float(speed) ** 2)
            r = (r[0] @ e[0], r[1] @ e[0] + r[0] @ e[1], r[2] @ e[0] + 2 * r[1] @ e[1] + r[0] @ e[2])
        axial = lambda s: [s[2, 1], s[0, 2], s[1, 0]]
        omega, alpha = r[1] @ r[0].T, r[2] @ r[0].T + r[1] @ r[1].T
        point = np.array([float(x) for x in place])
        ROWS.add(
            "rigid-body/rotation-chain",
            f"{count} joints",
            {
                "joints": [
                    {
                        "name": f"j{n + 1}",
                        "axis": "(" + "; ".join(axis) + ")",
                        "motion": {
                            "now": {
                                "angle": f"{angle} deg",
                                "rate": f"{speed} rad/s",
                                "acceleration": f"{gain} rad/s^2",
                            }
                        },
                        "offset": "(0; 0; 0) m",
                    }
                    for n, (axis, angle, speed, gain) in enumerate(joints)
                ],
                "points": [{"name": "P", "frame": f"j{count}", "place": vector(place, "m")}],
                "axes": "fixed",
            },
            {
                "angular_velocity": axial(omega),
                "angular_acceleration": axial(alpha),
                "velocity[1]": list(r[1] @ point),
                "acceleration[1]": list(r[2] @ point),
                "angular_speed": np.linalg.norm(axial(omega)),
            },
        )


def bearings():
    """Particles on a turning shaft: accelerations one by one, then forces and moments about the first bearing."""
    draw = Draw(36)
    for _ in range(3):
        particles = [draw.floats((0.5, 2), (0.1, 0.7), (-0.2, 0.2), (-0.2, 0.2)) for _ in range(3)]
        speed, gain, far = draw.floats((10, 40), (-80, 80), (0.8, 1))
        w, a = np.array([float(speed), 0, 0]), np.array([float(gain), 0, 0])
        force, moment = np.zeros(3), np.zeros(3)
        for m, *at in particles:
            r = np.array([float(x) for x in at])
            inertial = float(m) * (np.cross(a, r) + np.cross(w, np.cross(w, r))) - float(m) * np.array(
                [0, 0, -9.81]
            )
            force, moment = force + inertial, moment + np.cross(r, inertial)
        # Unknown: three forces at A, two at B across the shaft, the couple of the drive.
        columns = [[*axis, 0, 0, 0] for axis in np.eye(3)]
        columns += [[*axis, *np.cross([float(far), 0, 0], axis)] for axis in np.eye(3)[1:]] + [
            [0, 0, 0, 1, 0, 0]
        ]
        found = np.linalg.solve(np.array(columns).T, [*force, *moment])
        ROWS.add(
            "rigid-body/reactions",
            f"three particles at {speed} rad/s",
            {
                "body": {
                    "parts": {
                        "parts": [
                            {
                                "name": f"p{n + 1}",
                                "shape": "particle",
                                "amount": {"mass": {"mass": f"{m} kg"}},
                                "position": vector(at, "m"),
                                "reference": "origin",
                                "direction": "same",
                                "presence": "material",
                            }
                            for n, (m, *at) in enumerate(particles)
                        ]
                    }
                },
                "joints": [
                    {
                        "name": "shaft",
                        "axis": "(1; 0; 0)",
                        "motion": {
                            "now": {
                                "angle": "0 deg",
                                "rate": f"{speed} rad/s",
                                "acceleration": f"{gain} rad/s^2",
                            }
                        },
                        "offset": "(0; 0; 0) m",
                    }
                ],
                "drive": "motion",
                "axes": "fixed",
                "gravity": "(0; 0; -9.81) m/s^2",
                "supports": [
                    {"name": "A", "at": "(0; 0; 0) m", "kind": "thrust-bearing"},
                    {"name": "B", "at": f"({far}; 0; 0) m", "kind": {"bearing": {"shaft": "(1; 0; 0)"}}},
                ],
            },
            {"reaction[1]": list(found[:3]), "reaction[2]": [0, *found[3:5]], "drive_couple": found[5]},
        )


def rods():
    """A rod welded to a shaft: momentum and its rate as integrals along the rod."""
    draw = Draw(37)
    for degrees in ("25", "62"):
        m, half, speed, gain = draw.floats((2, 6), (0.2, 0.5), (5, 20), (-40, 40))
        # Along the shaft y, and away from it to the other side of x.
        unit = np.array([-math.cos(math.radians(float(degrees))), math.sin(math.radians(float(degrees))), 0])
        w, a = np.array([0, float(speed), 0]), np.array([0, float(gain), 0])
        per = float(m) / (2 * float(half))
        along = lambda of: np.array(
            [
                quad(lambda s: per * of(s * unit)[i], -float(half), float(half), epsabs=1e-14)[0]
                for i in range(3)
            ]
        )
        momentum = along(lambda r: np.cross(r, np.cross(w, r)))
        couple = along(lambda r: np.cross(r, np.cross(a, r) + np.cross(w, np.cross(w, r))))
        ROWS.add(
            "rigid-body/rod-on-shaft",
            f"at {degrees} degrees",
            {
                "mass": f"{m} kg",
                "half_length": f"{half} m",
                "inclination": {"from-horizontal": {"angle": f"{degrees} deg"}},
                "speed": f"{speed} rad/s",
                "acceleration": f"{gain} rad/s^2",
                "shaft_angle": "0 deg",
            },
            {"angular_momentum": list(momentum), "couple": list(couple), "kinetic_energy": momentum @ w / 2},
        )


def equilibria():
    """A lever with a weight and a spring on a drum: where the slope of the energy vanishes."""
    draw = Draw(38)
    for _ in range(2):
        m, arm, k, r = draw.floats((8, 12), (0.28, 0.35), (3500, 4200), (0.075, 0.085))
        mf, af, kf, rf = map(float, (m, arm, k, r))
        slope = lambda th: -mf * 9.81 * af * math.sin(th) + kf * rf * rf * th
        angle = brentq(slope, 0.05, math.pi, xtol=1e-15)
        ROWS.add(
            "virtual-work/spring-lever",
            f"{m} kg",
            {
                "reference": "upright",
                "load": {"mass": {"mass": f"{m} kg", "arm": f"{arm} m", "gravity": "9.81 m/s^2"}},
                "spring": {"drum": {"stiffness": f"{k} N/m", "radius": f"{r} m"}},
                "position": {"sought": {"from": "0 deg", "to": "180 deg"}},
            },
            {
                "stable_angle[1]": angle,
                "stable_curvature[1]": kf * rf * rf - mf * 9.81 * af * math.cos(angle),
            },
        )


balancing()
flywheels()
inertias()
rotations()
bearings()
rods()
equilibria()
ROWS.write()
