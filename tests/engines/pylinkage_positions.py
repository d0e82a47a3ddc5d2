"""Positions, velocities and accelerations of linkages by pylinkage's solver of dyads."""

import math
from importlib.metadata import version

import pylinkage as pl

from rows import Draw, Rows, vector

ROWS = Rows(
    "pylinkage", version("pylinkage"), 1e-12, "Intersections of circles and lines in double precision."
)
STEP = 1e-3


def meet(a, b, from_a, from_b, side):
    """A point at two distances: where a dyad begins, so that it closes on the side that is meant."""
    far = math.dist(a, b)
    along = (from_a**2 - from_b**2 + far**2) / (2 * far)
    across = side * math.sqrt(from_a**2 - along**2)
    x, y = (b[0] - a[0]) / far, (b[1] - a[1]) / far
    return a[0] + along * x - across * y, a[1] + along * y + across * x


class Motion:
    """Places, velocities and accelerations of the components after one small step of the crank."""

    def __init__(self, components, cranks):
        linkage = pl.Linkage(components=components, name="linkage")
        for crank, omega, alpha in cranks:
            linkage.set_input_velocity(crank, omega, alpha)
        linkage.compile()
        places, speeds, gains = linkage.step_fast_with_kinematics(1)
        self.of = {part.name: (places[0, n], speeds[0, n], gains[0, n]) for n, part in enumerate(components)}

    def place(self, name):
        return self.of[name][0]

    def turn(self, a, b):
        """Angle, angular velocity and angular acceleration of the line from one point to another."""
        (p, v, w), (q, u, z) = self.of[a], self.of[b]
        r, s, t = q - p, u - v, z - w
        square = r @ r
        cross = lambda x, y: x[0] * y[1] - x[1] * y[0]
        omega = cross(r, s) / square
        return math.atan2(r[1], r[0]), omega, (cross(r, t) - 2 * omega * (r @ s)) / square


def crank(anchor, radius, angle, name):
    return pl.Crank(
        anchor=anchor, radius=radius, angular_velocity=STEP, initial_angle=angle - STEP, name=name
    )


def tip(at, radius, angle):
    return at[0] + radius * math.cos(angle - STEP), at[1] + radius * math.sin(angle - STEP)


def place(part, at):
    part.x, part.y = at
    return part


def four_bars():
    draw = Draw(41)
    for degrees, side in (("40", 1), ("110", 1), ("200", -1), ("305", 1), ("75", -1)):
        a, b, c, d, omega, alpha = draw.floats(
            (0.05, 0.08), (0.2, 0.25), (0.15, 0.2), (0.18, 0.22), (5, 20), (-60, 60)
        )
        af, bf, cf, df, th = float(a), float(b), float(c), float(d), math.radians(float(degrees))
        left, right = pl.Ground(0, 0, name="O"), pl.Ground(df, 0, name="C")
        arm = crank(left, af, th, "A")
        pin = pl.RRRDyad(anchor1=arm.output, anchor2=right, distance1=bf, distance2=cf, name="B")
        place(pin, meet(tip((0, 0), af, th), (df, 0), bf, cf, side))
        motion = Motion([left, right, arm, pin], [(arm, float(omega), float(alpha))])
        coupler, rocker = motion.turn("A", "B"), motion.turn("C", "B")
        ROWS.add(
            "virtual-work/four-bar",
            f"at {degrees} degrees, {'open' if side > 0 else 'crossed'}",
            {
                "crank": f"{a} m",
                "coupler": f"{b} m",
                "rocker": f"{c} m",
                "frame": f"{d} m",
                "closing": "open" if side > 0 else "crossed",
                "angle": f"{degrees} deg",
                "unknown": {"torque": {"load": "0 N*m"}},
                "speed": f"{omega} rad/s",
                "acceleration": f"{alpha} rad/s^2",
                "gravity": "(0; 0) m/s^2",
            },
            {
                "coupler_angle": coupler[0],
                "rocker_angle": rocker[0],
                "coupler_speed": coupler[1],
                "rocker_speed": rocker[1],
                "coupler_acceleration": coupler[2],
                "rocker_acceleration": rocker[2],
            },
        )


def slider_cranks():
    draw = Draw(42)
    for degrees in ("25", "130", "280"):
        r, l, omega, alpha = draw.floats((0.05, 0.08), (0.2, 0.3), (5, 20), (-60, 60))
        rf, lf, th = float(r), float(l), math.radians(float(degrees))
        o, p, q = pl.Ground(0, 0, name="O"), pl.Ground(-1, 0, name="P"), pl.Ground(1, 0, name="Q")
        arm = crank(o, rf, th, "A")
        pin = pl.RRPDyad(revolute_anchor=arm.output, line_anchor1=p, line_anchor2=q, distance=lf, name="B")
        x, y = tip((0, 0), rf, th)
        place(pin, (x + math.sqrt(lf**2 - y**2), 0))
        motion = Motion([o, p, q, arm, pin], [(arm, float(omega), float(alpha))])
        rod = motion.turn("A", "B")
        ROWS.add(
            "virtual-work/slider-crank",
            f"at {degrees} degrees",
            {
                "crank": f"{r} m",
                "rod": f"{l} m",
                "offset": "0 m",
                "angle": f"{degrees} deg",
                "unknown": {"torque": {"force": "0 N"}},
                "pin_force": "(0; 0) N",
                "speed": f"{omega} rad/s",
                "acceleration": f"{alpha} rad/s^2",
                "slider_mass": "0 kg",
                "gravity": "(0; 0) m/s^2",
            },
            {
                "slider_position": motion.of["B"][0][0],
                "slider_velocity": motion.of["B"][1][0],
                "slider_acceleration": motion.of["B"][2][0],
                "rod_angle": rod[0],
                "rod_speed": rod[1],
                "rod_acceleration": rod[2],
            },
        )


def six_bars():
    draw = Draw(43)
    for degrees, output in (("35", "slider"), ("160", "slider"), ("50", "rocker"), ("220", "rocker")):
        a, b, c, d, link, last, omega, alpha = draw.floats(
            (0.05, 0.07), (0.2, 0.25), (0.15, 0.2), (0.18, 0.22), (0.3, 0.35), (0.2, 0.25), (5, 20), (-60, 60)
        )
        along = draw(0.1, 0.14)
        af, bf, cf, df, lf, ef, th = (
            float(a),
            float(b),
            float(c),
            float(d),
            float(link),
            float(last),
            math.radians(float(degrees)),
        )
        o, right = pl.Ground(0, 0, name="O"), pl.Ground(df, 0, name="C")
        arm = crank(o, af, th, "A")
        pin = pl.RRRDyad(anchor1=arm.output, anchor2=right, distance1=bf, distance2=cf, name="B")
        start = tip((0, 0), af, th)
        at = place(pin, meet(start, (df, 0), bf, cf, 1)).x, pin.y
        # A point on the rocker, by its distance and its angle from the line of the pins.
        hung = pl.FixedDyad(anchor1=right, anchor2=pin, distance=float(along), angle=0.0, name="D")
        share = float(along) / cf
        there = df + share * (at[0] - df), share * at[1]
        place(hung, there)
        parts = [o, right, arm, pin, hung]
        inputs = {
            "crank": f"{a} m",
            "coupler": f"{b} m",
            "rocker": f"{c} m",
            "frame": f"{d} m",
            "closing": "open",
            "angle": f"{degrees} deg",
            "attached": {"rocker": {"along": f"{along} m", "across": "0 m"}},
            "link": f"{link} m",
        }
        if output == "slider":
            p, q = pl.Ground(-2, -0.05, name="P"), pl.Ground(2, -0.05, name="Q")
            end = pl.RRPDyad(revolute_anchor=hung, line_anchor1=p, line_anchor2=q, distance=lf, name="E")
            place(end, (there[0] + math.sqrt(lf**2 - (there[1] + 0.05) ** 2), -0.05))
            parts += [p, q, end]
            inputs |= {
                "output": {
                    "slider": {
                        "through": "(0; -0.05) m",
                        "direction": "0 deg",
                        "side": "ahead",
                        "mass": "0 kg",
                    }
                },
                "load": {"force": {"force": "10 N"}},
            }
        else:
            pivot = pl.Ground(df + 0.3, -0.02, name="F")
            end = pl.RRRDyad(anchor1=hung, anchor2=pivot, distance1=lf, distance2=ef, name="E")
            place(end, meet(there, (df + 0.3, -0.02), lf, ef, 1))
            parts += [pivot, end]
            inputs |= {
                "output": {
                    "rocker": {
                        "pivot": vector((f"{df + 0.3:.10g}", "-0.02"), "m"),
                        "length": f"{last} m",
                        "closing": "open",
                    }
                },
                "load": {"torque": {"torque": "1 N*m"}},
            }
        inputs |= {"speed": f"{omega} rad/s", "acceleration": f"{alpha} rad/s^2", "gravity": "(0; 0) m/s^2"}
        motion = Motion(parts, [(arm, float(omega), float(alpha))])
        answers = {
            "coupler_angle": motion.turn("A", "B")[0],
            "rocker_angle": motion.turn("C", "B")[0],
            "link_angle": motion.turn("D", "E")[0],
            "rocker_ratio": motion.turn("C", "B")[1] / float(omega),
        }
        if output == "slider":
            answers |= {
                "slider_position": motion.of["E"][0][0],
                "slider_velocity": motion.of["E"][1][0],
                "slider_acceleration": motion.of["E"][2][0],
            }
        else:
            angle, speed, gain = motion.turn("F", "E")
            answers |= {"output_angle": angle, "output_speed": speed, "output_acceleration": gain}
        ROWS.add("virtual-work/six-bar", f"{output} at {degrees} degrees", inputs, answers)


def five_bars():
    draw = Draw(44)
    for first, second, side in (("70", "115", 1), ("20", "60", 1), ("150", "40", 1)):
        a, b, c, e, d = draw.floats((0.05, 0.08), (0.15, 0.2), (0.15, 0.2), (0.05, 0.08), (0.12, 0.16))
        af, bf, cf, ef, df = map(float, (a, b, c, e, d))
        one, two = math.radians(float(first)), math.radians(float(second))
        left, right = pl.Ground(0, 0, name="O"), pl.Ground(df, 0, name="C")
        arm, other = crank(left, af, one, "A"), crank(right, ef, two, "B")
        apex = pl.RRRDyad(anchor1=arm.output, anchor2=other.output, distance1=bf, distance2=cf, name="P")
        place(apex, meet(tip((0, 0), af, one), tip((df, 0), ef, two), bf, cf, side))
        motion = Motion([left, right, arm, other, apex], [(arm, 1.0, 0.0), (other, 1.0, 0.0)])
        ROWS.add(
            "virtual-work/five-bar",
            f"cranks at {first} and {second} degrees",
            {
                "first_crank": f"{a} m",
                "first_rod": f"{b} m",
                "second_rod": f"{c} m",
                "second_crank": f"{e} m",
                "frame": f"{d} m",
                "apex": "left",
                "first_angle": f"{first} deg",
                "second_angle": f"{second} deg",
                "cranks": "free",
                "unknown": {"torques": {"force": "(10; -20) N"}},
            },
            {"first_rod_angle": motion.turn("A", "P")[0], "second_rod_angle": motion.turn("B", "P")[0]},
        )


four_bars()
slider_cranks()
six_bars()
five_bars()
ROWS.write()
