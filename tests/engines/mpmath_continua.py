"""Oscillators by integrals and Taylor series, continua by the roots of their frequency equations, at 40 digits."""

import mpmath
from mpmath import mp, mpf, matrix

from rows import Draw, Rows

mp.dps = 40
ROWS = Rows(
    "mpmath", mpmath.__version__, 1e-12, "40 digits; 1e-12 is what ours allow for their own rounding."
)
TAU = 2 * mp.pi


def roots(of, start, step, count):
    """The first roots of a function above `start`, by their changes of sign, to all digits."""
    found, low, at_low = [], mpf(start), of(mpf(start))
    while len(found) < count:
        high = low + step
        at_high = of(high)
        if at_low * at_high < 0:
            found.append(mp.findroot(of, (low, high), solver="anderson", tol=mpf(10) ** -60))
        low, at_low = high, at_high
    return found


def duffing():
    draw = Draw(1)
    for cubic in ("45.2", "310", "-6.5", "900"):
        m, k, a = draw.floats((0.5, 4), (80, 300), (0.3, 1.2))
        inputs = {
            "mass": f"{m} kg",
            "stiffness": f"{k} N/m",
            "cubic": f"{cubic} N/m^3",
            "motion": {"free": {"amplitude": f"{a} m"}},
        }
        m, k, h, a = mpf(m), mpf(k), mpf(cubic), mpf(a)
        # x = A sin u in dt = dx/v, v from the energy.
        quarter = mp.quad(lambda u: mp.sqrt(m / (k + h / 2 * a**2 * (1 + mp.sin(u) ** 2))), [0, mp.pi / 2])
        # The balance of the first harmonic: the force of the spring along cos over a turn.
        first = (
            mp.quad(lambda u: (k * a * mp.cos(u) + h * (a * mp.cos(u)) ** 3) * mp.cos(u), [0, mp.pi, TAU])
            / mp.pi
        )
        ROWS.add(
            "vibration/duffing-oscillator",
            f"free, h = {cubic}",
            inputs,
            {
                "period": 4 * quarter,
                "frequency": TAU / (4 * quarter),
                "natural_frequency": mp.sqrt(k / m),
                "balance_period": TAU / mp.sqrt(first / (m * a)),
            },
        )


def pendulum():
    draw = Draw(2)
    for degrees in ("12", "75", "140", "178.5"):
        length, t = draw.floats((0.3, 3), (1, 6))
        inputs = {
            "length": f"{length} m",
            "amplitude": f"{degrees} deg",
            "gravity": "9.81 m/s^2",
            "instant": f"{t} s",
        }
        length, t, top, g = mpf(length), mpf(t), mp.radians(mpf(degrees)), mpf("9.81")
        period = 4 * mp.sqrt(length / g) * mp.ellipk(mp.sin(top / 2) ** 2)
        small = TAU * mp.sqrt(length / g)
        motion = mp.odefun(lambda _, y: [y[1], -g / length * mp.sin(y[0])], 0, [top, mpf(0)])
        angle, rate = motion(t)
        ROWS.add(
            "vibration/large-pendulum",
            f"from {degrees} degrees",
            inputs,
            {
                "period": period,
                "small_angle_period": small,
                "shortfall": (period - small) / period,
                "largest_angular_velocity": mp.sqrt(2 * g / length * (1 - mp.cos(top))),
                # Close to the top the motion doubles what the angle at the start was rounded by, again and again.
                "angle": (angle, 1e-11),
                "angular_velocity": (rate, 1e-11),
                "swings": t / period,
            },
        )


class Beam:
    """A beam of spans by the exponentials of its first-order equations in (w, slope, moment, force)."""

    def __init__(self, spans, joints):
        """Spans: (length, EI, mass per length, axial force, foundation, shear stiffness, rotary inertia per length).

        Joints, one more than spans: a name of a support, or (k, k_t, mass, inertia)."""
        self.spans, self.joints = spans, joints

    def across(self, span, omega):
        length, bending, mass, axial, foundation, shear, rotary = span
        slope = 1 if shear is None else 1
        flexibility = mpf(0) if shear is None else -1 / shear
        rates = matrix(
            [
                [0, slope, 0, flexibility],
                [0, 0, 1 / bending, 0],
                [0, axial - rotary * omega**2, 0, 1],
                [mass * omega**2 - foundation, 0, 0, 0],
            ]
        )
        return mp.expm(rates * length)

    def determinant(self, omega):
        """Of all states at the left ends of the spans, scaled to be of the order of one."""
        spans, count = self.spans, len(self.spans)
        total = sum(span[0] for span in spans)
        bending = spans[0][1]
        scale = [total, 1, bending / total, bending / total**2]
        rows = []

        def put(*parts):
            row = [mpf(0)] * (4 * count)
            for at, state in parts:
                for place in range(4):
                    row[4 * at + place] += state[place]
            rows.append(row)

        def held(joint):
            spring, turning, mass, inertia = joint
            return spring - mass * omega**2, turning - inertia * omega**2

        unit = [[mpf(int(i == j)) for j in range(4)] for i in range(4)]
        combine = lambda *parts: [sum(f * row[i] for f, row in parts) for i in range(4)]
        # At the left end the force is -k w and the moment k_t times the slope; at the right end the opposite.
        ends = {"free": (2, 3), "pinned": (0, 2), "clamped": (0, 1), "guided": (1, 3)}
        left = self.joints[0]
        if isinstance(left, str):
            for place in ends[left]:
                put((0, unit[place]))
        else:
            k, turning = held(left)
            put((0, combine((1, unit[3]), (k, unit[0]))))
            put((0, combine((1, unit[2]), (-turning, unit[1]))))
        for at, span in enumerate(spans):
            step = self.across(span, omega)
            end = [[step[i, j] for j in range(4)] for i in range(4)]
            joint = self.joints[at + 1]
            if at + 1 < count:
                minus = [[-x for x in row] for row in unit]
                if joint == "pinned":
                    put((at, end[0]))
                    put((at + 1, unit[0]))
                    put((at, end[1]), (at + 1, minus[1]))
                    put((at, end[2]), (at + 1, minus[2]))
                else:
                    k, turning = held(joint)
                    put((at, end[0]), (at + 1, minus[0]))
                    put((at, end[1]), (at + 1, minus[1]))
                    put((at, combine((1, end[2]), (turning, end[1]))), (at + 1, minus[2]))
                    put((at, combine((1, end[3]), (-k, end[0]))), (at + 1, minus[3]))
            elif isinstance(joint, str):
                for place in ends[joint]:
                    put((at, end[place]))
            else:
                k, turning = held(joint)
                put((at, combine((1, end[3]), (-k, end[0]))))
                put((at, combine((1, end[2]), (turning, end[1]))))
        columns = [scale[i % 4] for i in range(4 * count)]
        scaled = []
        for row in rows:
            row = [x * s for x, s in zip(row, columns)]
            size = max(abs(x) for x in row)
            scaled.append([x / size for x in row])
        return mp.det(matrix(scaled))

    def frequencies(self, count):
        total = sum(span[0] for span in self.spans)
        unit = mp.sqrt(self.spans[0][1] / self.spans[0][2]) / total**2
        found = []
        with mp.workdps(25):
            low, at_low = mpf("0.3"), None
            while len(found) < count:
                high = low + mpf("0.13")
                at_high = self.determinant(high**2 * unit)
                if at_low is not None and at_low * at_high < 0:
                    found.append((low, high))
                low, at_low = high, at_high
        return [
            mp.findroot(lambda b: self.determinant(b**2 * unit), pair, solver="anderson", tol=mpf(10) ** -50)
            ** 2
            * unit
            for pair in found
        ]


def beams():
    draw = Draw(3)
    names = ("length", "area", "second", "young", "mass")
    steel = [draw.floats((0.8, 3), (2e-4, 9e-4), (2e-9, 8e-9), (7e10, 2.1e11), (1, 6)) for _ in range(6)]
    more = [
        # (left, right, axial, foundation, attachments: distance share, mass, inertia, spring)
        ("clamped", "free", None, None, []),
        ("pinned", "clamped", "900", "2500", []),
        ("guided", "pinned", "-60", None, []),
        (("3200", "45"), ("9000", "12"), None, None, []),
        ("clamped", "free", None, "800", [("0.5", "1.7", "0.02", None), ("1", "0.6", None, None)]),
        ("pinned", "pinned", None, None, [("0.3", "2.5", None, None), ("0.75", None, None, "6000")]),
    ]
    for values, (left, right, axial, foundation, attached) in zip(steel, more):
        of = dict(zip(names, values))
        length = mpf(of["length"])
        bending, mass = mpf(of["young"]) * mpf(of["second"]), mpf(of["mass"])
        side = lambda end: (
            end
            if isinstance(end, str)
            else {"springs": {"transverse": f"{end[0]} N/m", "rotational": f"{end[1]} N*m/rad"}}
        )
        inputs = {
            "length": f"{of['length']} m",
            "section": {"given": {"area": f"{of['area']} m^2", "second_moment": f"{of['second']} m^4"}},
            "young": f"{of['young']} Pa",
            "mass": {"per-length": {"mass": f"{of['mass']} kg/m"}},
            "theory": "euler-bernoulli",
            "left": side(left),
            "right": side(right),
            "modes": 4,
        }
        if axial:
            inputs["axial"] = f"{axial} N"
        if foundation:
            inputs["foundation"] = f"{foundation} N/m^2"
        joint = lambda end: end if isinstance(end, str) else (mpf(end[0]), mpf(end[1]), mpf(0), mpf(0))
        spans, joints, at = [], [joint(left)], mpf(0)
        span = lambda long: (long, bending, mass, mpf(axial or 0), mpf(foundation or 0), None, mpf(0))
        parts = []
        for share, lump, inertia, spring in attached:
            # The distance that is written is the one that is computed with.
            place = mp.nstr(mpf(share) * length, 6) if share != "1" else of["length"]
            if lump:
                part = {
                    "mass": {"mass": f"{lump} kg"} | ({"inertia": f"{inertia} kg*m^2"} if inertia else {})
                }
            else:
                part = {"spring": {"stiffness": f"{spring} N/m"}}
            parts.append({"distance": f"{place} m", "part": part})
            here = (mpf(spring or 0), mpf(0), mpf(lump or 0), mpf(inertia or 0))
            spans.append(span(mpf(place) - at))
            joints.append(here)
            at = mpf(place)
        if parts:
            inputs["attachments"] = parts
        if at < length:
            spans.append(span(length - at))
            joints.append(joint(right))
        found = Beam(spans, joints).frequencies(4)
        kind = f"{left if isinstance(left, str) else 'springs'} and {right if isinstance(right, str) else 'springs'}"
        ROWS.add(
            "vibration/beam-vibration",
            f"{kind}, {len(attached)} attached",
            inputs,
            {f"frequency[{n + 1}]": f for n, f in enumerate(found)},
        )
    # Timoshenko's, with the shear stiffness and the rotary inertia of a rectangle.
    for left, right in (("clamped", "free"), ("pinned", "clamped"), ("clamped", "clamped")):
        length, b, h, young, shear, density = draw.floats(
            (1, 2), (0.05, 0.1), (0.15, 0.3), (1.9e11, 2.1e11), (7e10, 8.2e10), (7000, 8000)
        )
        inputs = {
            "length": f"{length} m",
            "section": {"rectangle": {"breadth": f"{b} m", "height": f"{h} m"}},
            "young": f"{young} Pa",
            "mass": {"density": {"density": f"{density} kg/m^3"}},
            "theory": {
                "timoshenko": {
                    "shear": {"given": {"shear": f"{shear} Pa"}},
                    "coefficient": {"given": {"coefficient": "0.85"}},
                }
            },
            "left": left,
            "right": right,
            "modes": 3,
        }
        length, b, h, young, shear, density = map(mpf, (length, b, h, young, shear, density))
        second = b * h**3 / 12
        span = (
            length,
            young * second,
            density * b * h,
            mpf(0),
            mpf(0),
            mpf("0.85") * shear * b * h,
            density * second,
        )
        found = Beam([span], [left, right]).frequencies(3)
        ROWS.add(
            "vibration/beam-vibration",
            f"Timoshenko, {left} and {right}",
            inputs,
            {f"frequency[{n + 1}]": f for n, f in enumerate(found)},
        )
    # Several spans.
    for left, joints, count in (
        ("clamped", [("pinned", None, None), ("free", "1.3", "0.05")], 4),
        ("pinned", [("pinned", None, None), ("pinned", None, None), ("free", None, None)], 4),
        ("free", [("pinned", None, "0.3"), ("free", "2.2", None), ("clamped", None, None)], 4),
    ):
        inputs = {"left": {"support": left}, "spans": [], "modes": count}
        spans, held = [], [left]
        for support, lump, inertia in joints:
            length, area, second, young, mass, axial = draw.floats(
                (0.6, 1.6), (2e-4, 9e-4), (2e-9, 8e-9), (7e10, 2.1e11), (1, 6), (20, 400)
            )
            end = {"support": support}
            end |= {"mass": f"{lump} kg"} if lump else {}
            end |= {"inertia": f"{inertia} kg*m^2"} if inertia else {}
            inputs["spans"].append(
                {
                    "length": f"{length} m",
                    "section": {"given": {"area": f"{area} m^2", "second_moment": f"{second} m^4"}},
                    "young": f"{young} Pa",
                    "mass": {"per-length": {"mass": f"{mass} kg/m"}},
                    "axial": f"{axial} N",
                    "end": end,
                }
            )
            spans.append((mpf(length), mpf(young) * mpf(second), mpf(mass), mpf(axial), mpf(0), None, mpf(0)))
            lumped = (mpf(0), mpf(0), mpf(lump or 0), mpf(inertia or 0))
            held.append(lumped if support == "free" else support)
        # A body on a pin turns with the beam: the pin is a spring that is stiff beyond all digits.
        held = [
            (
                (mpf(10) ** 45, mpf(0), mpf(0), mpf(joints[n - 1][2]))
                if n and joints[n - 1][2] and h == "pinned"
                else h
            )
            for n, h in enumerate(held)
        ]
        with mp.workdps(80):
            found = Beam(spans, held).frequencies(count)
        ROWS.add(
            "vibration/multi-span-beam",
            f"{left}, then {', '.join(j[0] for j in joints)}",
            inputs,
            {f"frequency[{n + 1}]": f for n, f in enumerate(found)},
        )


def waves():
    """Rods, strings, shafts: (displacement, force) carried along."""
    draw = Draw(4)
    for body, left, right in (
        ("rod", "fixed", ("mass", "3.1")),
        ("string", ("spring", "1400"), "fixed"),
        ("rod", ("spring-and-mass", "2.5e7", "4.2"), "free"),
        ("shaft", ("disc", "0.31"), ("disc", "0.82")),
        ("shaft", "fixed", ("spring-and-disc", "5200", "0.044")),
    ):
        length = draw(0.7, 2.5)
        name = {
            "spring": ("stiffness",),
            "mass": ("mass",),
            "spring-and-mass": ("stiffness", "mass"),
            "disc": ("inertia",),
            "spring-and-disc": ("stiffness", "inertia"),
        }
        units = {"stiffness": "N*m/rad" if body == "shaft" else "N/m", "mass": "kg", "inertia": "kg*m^2"}
        side = lambda end: (
            end
            if isinstance(end, str)
            else {end[0]: {key: f"{value} {units[key]}" for key, value in zip(name[end[0]], end[1:])}}
        )
        if body == "rod":
            young, density, area = draw.floats((6e10, 2.1e11), (2500, 8000), (2e-4, 2e-3))
            given = {"young": f"{young} Pa", "density": f"{density} kg/m^3", "area": f"{area} m^2"}
            stiff, heavy = mpf(young) * mpf(area), mpf(density) * mpf(area)
        elif body == "string":
            tension, mass = draw.floats((50, 900), (0.01, 0.2))
            given = {"tension": f"{tension} N", "mass": {"per-length": {"mass": f"{mass} kg/m"}}}
            stiff, heavy = mpf(tension), mpf(mass)
        else:
            shear, density, torsion, polar = draw.floats(
                (7e10, 8.2e10), (7000, 8000), (2e-7, 9e-7), (9e-7, 2e-6)
            )
            given = {
                "shear": {"given": {"shear": f"{shear} Pa"}},
                "density": f"{density} kg/m^3",
                "section": {"given": {"torsion": f"{torsion} m^4", "polar": f"{polar} m^4"}},
            }
            stiff, heavy = mpf(shear) * mpf(torsion), mpf(density) * mpf(polar)
        inputs = {
            "body": {body: given | {"left": side(left), "right": side(right)}},
            "length": f"{length} m",
            "modes": 4,
        }
        speed, long = mp.sqrt(stiff / heavy), mpf(length)

        def held(end, omega):
            """Force over displacement that an end asks for; None where it is fixed."""
            if end == "fixed":
                return None
            if end == "free":
                return mpf(0)
            of = dict(zip(name[end[0]], map(mpf, end[1:])))
            return of.get("stiffness", 0) - omega**2 * (of.get("mass", 0) + of.get("inertia", 0))

        def rest(beta):
            omega = beta * speed / long
            a, b = held(left, omega), held(right, omega)
            move, force = (mpf(0), mpf(1)) if a is None else (mpf(1), a)
            step = mp.expm(matrix([[0, long / stiff], [-heavy * omega**2 * long, 0]]))
            move, force = step[0, 0] * move + step[0, 1] * force, step[1, 0] * move + step[1, 1] * force
            return move if b is None else force + b * move

        betas = roots(rest, "0.05", mpf("0.03"), 4)
        ROWS.add(
            "vibration/string-rod-shaft",
            f"{body}, {left} and {right}",
            inputs,
            {"wave_speed": speed} | {f"frequency[{n + 1}]": b * speed / long for n, b in enumerate(betas)},
        )


def plates():
    inputs = {
        "body": {
            "membrane": {
                "tension": "740 N/m",
                "mass": {"per-area": {"mass": "0.31 kg/m^2"}},
                "outline": {"circle": {"radius": "0.23 m"}},
            }
        },
        "modes": 6,
    }
    zeros = sorted(mp.besseljzero(n, k) for n in range(6) for k in range(1, 4))[:6]
    speed = mp.sqrt(mpf(740) / mpf("0.31"))
    ROWS.add(
        "vibration/plate-and-membrane",
        "circular membrane",
        inputs,
        {f"frequency[{n + 1}]": z * speed / mpf("0.23") for n, z in enumerate(zeros)},
    )
    for edge in ("clamped", "simple"):
        for young, poisson, thickness, density, radius in (("7.1e10", "0.33", "0.0031", "2710", "0.41"),):
            inputs = {
                "body": {
                    "plate": {
                        "young": f"{young} Pa",
                        "poisson": poisson,
                        "thickness": f"{thickness} m",
                        "density": f"{density} kg/m^3",
                        "outline": {"circle": {"radius": f"{radius} m", "edge": edge}},
                    }
                },
                "modes": 5,
            }
            nu = mpf(poisson)

            def rest(n, x):
                """Deflection zero at the edge for w = J(x r)/J(x) - I(x r)/I(x); what the edge asks besides."""
                j = lambda d: mp.besselj(n, x, derivative=d) / mp.besselj(n, x)
                i = lambda d: mp.besseli(n, x, derivative=d) / mp.besseli(n, x)
                if edge == "clamped":
                    return j(1) - i(1)
                return x * (j(2) - i(2)) + nu * (j(1) - i(1))

            found = []
            for n in range(5):
                # Between the zeros of J there is one root; the function has poles at them.
                places = [mpf("0.1")] + [mp.besseljzero(n, k) for k in (1, 2, 3)]
                for low, high in zip(places, places[1:]):
                    whole = lambda x: rest(n, x) * mp.besselj(n, x)
                    gap = (high - low) * mpf("1e-6")
                    step = (high - low - 2 * gap) / 24
                    at = low + gap
                    for _ in range(24):
                        if whole(at) * whole(at + step) < 0:
                            found.append(mp.findroot(whole, (at, at + step), solver="anderson"))
                        at += step
            found = sorted(found)[:5]
            rigid = mpf(young) * mpf(thickness) ** 3 / (12 * (1 - nu**2))
            unit = mp.sqrt(rigid / (mpf(density) * mpf(thickness))) / mpf(radius) ** 2
            ROWS.add(
                "vibration/plate-and-membrane",
                f"circular plate, {edge}",
                inputs,
                {f"frequency[{n + 1}]": x**2 * unit for n, x in enumerate(found)},
            )


def tapered():
    """By power series of (E I w'')'' = m w^2 w about the thick end."""
    for b, b_end, h, h_end, left, right in (
        ("0.06", "0.06", "0.04", "0.024", "clamped", "free"),
        ("0.08", "0.05", "0.03", "0.02", "clamped", "free"),
        ("0.05", "0.04", "0.05", "0.03", "pinned", "clamped"),
    ):
        length, young, density = "1.4", "2.05e11", "7830"
        inputs = {
            "length": f"{length} m",
            "section": {
                "rectangle": {
                    "breadth": f"{b} m",
                    "end_breadth": f"{b_end} m",
                    "height": f"{h} m",
                    "end_height": f"{h_end} m",
                }
            },
            "young": f"{young} Pa",
            "density": f"{density} kg/m^3",
            "left": left,
            "right": right,
            "modes": 3,
        }

        def multiply(factors):
            product = [mpf(1)]
            for factor in factors:
                longer = [mpf(0)] * (len(product) + len(factor) - 1)
                for i, x in enumerate(product):
                    for j, y in enumerate(factor):
                        longer[i + j] += x * y
                product = longer
            return product

        breadth = [mpf(1), mpf(b_end) / mpf(b) - 1]
        height = [mpf(1), mpf(h_end) / mpf(h) - 1]
        area, second = multiply([breadth, height]), multiply([breadth, height, height, height])

        def series(start, square):
            """w(0), w'(0), EI w''(0), (EI w'')'(0) carried to 1, unit length and stiffness."""
            w = [start[0], start[1]]
            moment = [start[2], start[3]]
            for n in range(300):
                # EI w'' = M: the next coefficient of w.
                known = sum(
                    second[k] * (n - k + 2) * (n - k + 1) * w[n - k + 2]
                    for k in range(1, min(n, len(second) - 1) + 1)
                )
                w.append((moment[n] - known) / ((n + 2) * (n + 1)))
                load = square * sum(area[k] * w[n - k] for k in range(0, min(n, len(area) - 1) + 1))
                moment.append(load / ((n + 2) * (n + 1)))
            rate = lambda c: sum(i * x for i, x in enumerate(c))
            return [sum(w), rate(w), sum(moment), rate(moment)]

        ends = {"free": (2, 3), "pinned": (0, 2), "clamped": (0, 1)}
        open_ = [i for i in range(4) if i not in ends[left]]

        def rest(beta):
            one, two = (series([mpf(int(i == o)) for i in range(4)], beta**4) for o in open_)
            i, j = ends[right]
            return (one[i] * two[j] - one[j] * two[i]) / mp.cosh(beta) ** 2

        betas = roots(rest, "0.5", mpf("0.25"), 3)
        unit = mp.sqrt(mpf(young) * mpf(h) ** 2 / 12 / mpf(density)) / mpf(length) ** 2
        ROWS.add(
            "vibration/tapered-beam",
            f"{left} and {right}, {h} to {h_end}",
            inputs,
            {f"frequency[{n + 1}]": x**2 * unit for n, x in enumerate(betas)},
        )


duffing()
pendulum()
waves()
plates()
tapered()
beams()
ROWS.write()
