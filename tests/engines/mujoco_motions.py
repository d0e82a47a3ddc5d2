"""Motions of chains of bodies and of bodies in space by MuJoCo's Runge–Kutta, to what halving its step leaves open."""

import math

import mujoco
import numpy as np

from rows import Draw, Rows, vector

ROWS = Rows(
    "MuJoCo",
    mujoco.__version__,
    None,
    "Runge–Kutta of order 4 with three steps, extrapolated; each number is allowed thrice what the last halving changed.",
)
# What our own integrators are asked for in a step is 1e-11 and 1e-13; of some hundred steps errors add up.
PLANE, SPACE = 1e-9, 1e-11
HEAD = (
    '<mujoco><compiler angle="radian" balanceinertia="false"/><option timestep="{step}" gravity="{gravity}" integrator="RK4">'
    '<flag contact="disable"/></option><worldbody>'
)


def motion(model, start, duration, look, ours):
    """What `look` sees at the end with its accuracy, by step, half step and quarter step; not below that of our own."""
    seen = []
    for halving in range(3):
        steps = round(duration * 4000) * 2**halving
        made = mujoco.MjModel.from_xml_string(model.replace("{step}", repr(duration / steps)))
        data = mujoco.MjData(made)
        start(data)
        mujoco.mj_step(made, data, nstep=steps)
        mujoco.mj_forward(made, data)
        seen.append(look(data))
    answers = {}
    for key in seen[0]:
        one, two, four = (np.atleast_1d(np.array(each[key], float)) for each in seen)
        coarse, fine = two + (two - one) / 15, four + (four - two) / 15
        within = max(3 * np.abs(fine - coarse).max() / np.linalg.norm(fine), ours)
        answers[key] = (fine.tolist() if len(fine) > 1 else float(fine[0]), within)
    return answers


def chains():
    """Rods one below the other, with torsion springs in their pins."""
    draw = Draw(61)
    for count, duration in ((1, "1.5"), (2, "1"), (3, "0.8"), (2, "2.5")):
        rods = [
            dict(
                zip(
                    ("mass", "inertia", "centre", "length", "angle", "rate", "spring"),
                    draw.floats(
                        (0.5, 2), (0.01, 0.04), (0.15, 0.3), (0.4, 0.7), (-120, -40), (-3, 3), (1, 6)
                    ),
                )
            )
            for _ in range(count)
        ]
        model, ends = HEAD.replace("{gravity}", "0 -9.81 0"), ""
        before = "0"
        for rod in rods:
            model += (
                f'<body pos="{before} 0 0"><joint type="hinge" axis="0 0 1" stiffness="{rod["spring"]}" springref="-0.3"/>'
                f'<inertial pos="{rod["centre"]} 0 0" mass="{rod["mass"]}" diaginertia="{rod["inertia"]} {rod["inertia"]} {rod["inertia"]}"/>'
            )
            ends, before = ends + "</body>", rod["length"]
        model += ends + "</worldbody></mujoco>"
        angles = [math.radians(float(rod["angle"])) for rod in rods]
        rates = [float(rod["rate"]) for rod in rods]

        def start(data):
            data.qpos[:] = np.diff([0, *angles])
            data.qvel[:] = np.diff([0, *rates])

        look = (
            lambda data: {f"angle[{n + 1}]": data.qpos[: n + 1].sum() for n in range(count)}
            | {f"angular_velocity[{n + 1}]": data.qvel[: n + 1].sum() for n in range(count)}
            | {f"angular_acceleration[{n + 1}]": data.qacc[: n + 1].sum() for n in range(count)}
        )
        part = lambda n: {"body": {"body": f"rod {n}"}} if n else "ground"
        points, joints, loads, starts = [], [], [], []
        for n, rod in enumerate(rods):
            at = f"({rods[n - 1]['length']}; 0) m" if n else "(0; 0) m"
            points += [
                {"name": f"end {n}", "on": part(n), "at": at},
                {"name": f"head {n + 1}", "on": part(n + 1), "at": "(0; 0) m"},
            ]
            joints.append({"name": f"pin {n + 1}", "joint": {"pin": {"a": f"end {n}", "b": f"head {n + 1}"}}})
            loads.append(
                {
                    "name": f"spring {n + 1}",
                    "load": {
                        "torsion-spring": {
                            "of": part(n + 1),
                            "against": part(n),
                            "stiffness": f"{rod['spring']} N*m/rad",
                            "free": "-0.3 rad",
                        }
                    },
                }
            )
            starts.append(
                {
                    "name": f"start {n + 1}",
                    "what": {
                        "angle": {
                            "body": f"rod {n + 1}",
                            "against": "ground",
                            "value": f"{rod['angle']} deg",
                            "velocity": f"{rod['rate']} rad/s",
                        }
                    },
                }
            )
        ROWS.add(
            "virtual-work/motion",
            f"{count} rods for {duration} s",
            {
                "bodies": [
                    {
                        "name": f"rod {n + 1}",
                        "mass": f"{rod['mass']} kg",
                        "inertia": f"{rod['inertia']} kg*m^2",
                        "centre": f"({rod['centre']}; 0) m",
                        "angle": f"{rod['angle']} deg",
                    }
                    for n, rod in enumerate(rods)
                ],
                "points": points,
                "joints": joints,
                "loads": loads,
                "gravity": "(0; -9.81) m/s^2",
                "starts": starts,
                "duration": f"{duration} s",
                "end": "nothing",
            },
            motion(model, start, float(duration), look, PLANE),
        )


def carts():
    """A pendulum on a block that slides along a rail against a spring."""
    draw = Draw(62)
    for duration in ("0.9", "1.7"):
        block, rod, inertia, centre, stiff, angle, rate, speed = draw.floats(
            (2, 5), (0.5, 2), (0.01, 0.04), (0.2, 0.4), (50, 200), (-140, -60), (-2, 2), (-0.5, 0.5)
        )
        model = HEAD.replace("{gravity}", "0 -9.81 0") + (
            f'<body><joint type="slide" axis="1 0 0" stiffness="{stiff}"/><inertial pos="0 0 0" mass="{block}" diaginertia="1 1 1"/>'
            f'<body><joint type="hinge" axis="0 0 1"/><inertial pos="{centre} 0 0" mass="{rod}" diaginertia="{inertia} {inertia} {inertia}"/>'
            "</body></body></worldbody></mujoco>"
        )

        def start(data):
            data.qpos[:] = [0, math.radians(float(angle))]
            data.qvel[:] = [float(speed), float(rate)]

        look = lambda data: {
            "angle[2]": data.qpos[1],
            "angular_velocity[2]": data.qvel[1],
            "angular_acceleration[2]": data.qacc[1],
        }
        on = lambda body: {"body": {"body": body}}
        ROWS.add(
            "virtual-work/motion",
            f"pendulum on a cart for {duration} s",
            {
                "bodies": [
                    {
                        "name": "cart",
                        "mass": f"{block} kg",
                        "inertia": "1 kg*m^2",
                        "centre": "(0; 0) m",
                        "angle": "0 deg",
                    },
                    {
                        "name": "rod",
                        "mass": f"{rod} kg",
                        "inertia": f"{inertia} kg*m^2",
                        "centre": f"({centre}; 0) m",
                        "angle": f"{angle} deg",
                    },
                ],
                "points": [
                    {"name": "O", "on": "ground", "at": "(0; 0) m"},
                    {"name": "left", "on": "ground", "at": "(-10; 0) m"},
                    {"name": "pivot", "on": on("cart"), "at": "(0; 0) m"},
                    {"name": "head", "on": on("rod"), "at": "(0; 0) m"},
                ],
                "joints": [
                    {
                        "name": "rail",
                        "joint": {
                            "slider": {
                                "guide": "O",
                                "direction": "0 deg",
                                "slides": "pivot",
                                "angle": "0 deg",
                            }
                        },
                    },
                    {"name": "pin", "joint": {"pin": {"a": "pivot", "b": "head"}}},
                ],
                # A spring along the rail, its other end far to the left.
                "loads": [
                    {
                        "name": "spring",
                        "load": {
                            "spring": {
                                "from": "left",
                                "to": "pivot",
                                "stiffness": f"{stiff} N/m",
                                "free": "10 m",
                            }
                        },
                    }
                ],
                "gravity": "(0; -9.81) m/s^2",
                "duration": f"{duration} s",
                "end": "nothing",
                "starts": [
                    {
                        "name": "place",
                        "what": {
                            "position": {
                                "from": "O",
                                "to": "pivot",
                                "direction": "0 deg",
                                "value": "0 m",
                                "velocity": f"{speed} m/s",
                            }
                        },
                    },
                    {
                        "name": "swing",
                        "what": {
                            "angle": {
                                "body": "rod",
                                "against": "ground",
                                "value": f"{angle} deg",
                                "velocity": f"{rate} rad/s",
                            }
                        },
                    },
                ],
            },
            motion(model, start, float(duration), look, PLANE),
        )


def bodies():
    """A heavy body without symmetry about a fixed point, and free bodies, with products of inertia."""
    draw = Draw(63)
    for heavy, duration in ((True, "0.8"), (True, "1.6"), (False, "2"), (False, "4.5")):
        mass, x, y, z, xy, yz, zx = draw.floats(
            (2, 5), (0.05, 0.09), (0.05, 0.09), (0.05, 0.09), (-0.01, 0.01), (-0.01, 0.01), (-0.01, 0.01)
        )
        centre = draw.floats((-0.05, 0.1), (-0.1, 0.05), (0.1, 0.3))
        omega = draw.floats((-2, 2), (-2, 2), (4, 12))
        joint = '<joint type="ball"/>' if heavy else "<freejoint/>"
        at = " ".join(centre) if heavy else "0 0 0"
        # The products of the problem are integrals; the matrix has their negatives.
        signs = lambda text: text[1:] if text.startswith("-") else "-" + text
        model = HEAD.replace("{gravity}", "0 0 -9.81" if heavy else "0 0 0") + (
            f'<body>{joint}<inertial pos="{at}" mass="{mass}" fullinertia="{x} {y} {z} {signs(xy)} {signs(zx)} {signs(yz)}"/></body></worldbody></mujoco>'
        )

        def start(data):
            data.qvel[-3:] = [float(w) for w in omega]

        def look(data):
            turned = np.zeros(9)
            mujoco.mju_quat2Mat(turned, data.qpos[-4:])
            turned = turned.reshape(3, 3)
            seen = {
                "omega_body": data.qvel[-3:].copy(),
                "omega": turned @ data.qvel[-3:],
                "axis": turned[:, 2].copy(),
            }
            return seen | ({"centre": turned @ np.array([float(c) for c in centre])} if heavy else {})

        pivot = {
            "fixed-point": {
                "mass": f"{mass} kg",
                "centre": vector(centre, "m"),
                "about": "mass-centre",
                "gravity": "9.81 m/s^2",
            }
        }
        ROWS.add(
            "rigid-body/motion",
            f"{'heavy' if heavy else 'free'} body for {duration} s",
            {
                "pivot": pivot if heavy else "mass-centre",
                "moments": {
                    "tensor": {
                        "x": f"{x} kg*m^2",
                        "y": f"{y} kg*m^2",
                        "z": f"{z} kg*m^2",
                        "xy": f"{xy} kg*m^2",
                        "yz": f"{yz} kg*m^2",
                        "zx": f"{zx} kg*m^2",
                    }
                },
                "attitude": "aligned",
                "velocity": {"body": {"omega": vector(omega, "rad/s")}},
                "axis": "z",
                "duration": f"{duration} s",
                "end": "nothing",
            },
            motion(model, start, float(duration), look, SPACE),
        )


chains()
carts()
bodies()
ROWS.write()
