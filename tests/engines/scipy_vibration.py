"""Vibration by SciPy: eigenvalues, matrix exponentials, linear solves, quadrature, events of an integrator."""

import math

import numpy as np
import scipy
from scipy.integrate import quad, solve_ivp
from scipy.linalg import eigh, expm
from scipy.optimize import brentq

from rows import Draw, Rows

ROWS = Rows(
    "SciPy",
    scipy.__version__,
    1e-10,
    "Eigenvalues and linear solves; where it integrates, a row has its own.",
)
DIGITS = dict(method="DOP853", rtol=3e-14, atol=1e-16)


def chain(draw, count, wall=True, damped=True):
    """A chain with springs and dampers between, to the ground and to a wall: inputs and matrices."""
    links = [draw.floats((1, 8), (400, 3000), (1, 9), (20, 200), (0.5, 3)) for _ in range(count)]
    ends = draw.floats((300, 900), (1, 5))
    m, c, k = np.zeros((count, count)), np.zeros((count, count)), np.zeros((count, count))
    rows = []
    for i, (mass, spring, damper, ground, slow) in enumerate(links):
        row = {"mass": f"{mass} kg", "spring": f"{spring} N/m", "ground_spring": f"{ground} N/m"}
        m[i, i] = float(mass)
        along = np.eye(count)[i] - (np.eye(count)[i - 1] if i else 0)
        own = np.eye(count)[i]
        k += float(spring) * np.outer(along, along) + float(ground) * np.outer(own, own)
        if damped:
            row |= {"damper": f"{damper} N*s/m", "ground_damper": f"{slow} N*s/m"}
            c += float(damper) * np.outer(along, along) + float(slow) * np.outer(own, own)
        rows.append(row)
    system = {"chain": {"masses": rows}}
    if wall:
        system["chain"]["wall"] = {"spring": f"{ends[0]} N/m"} | (
            {"damper": f"{ends[1]} N*s/m"} if damped else {}
        )
        k[-1, -1] += float(ends[0])
        c[-1, -1] += float(ends[1]) if damped else 0
    return system, m, c, k


def state_matrix(m, c, k):
    count = len(m)
    return np.block(
        [[np.zeros((count, count)), np.eye(count)], [-np.linalg.solve(m, k), -np.linalg.solve(m, c)]]
    )


def damped_modes(m, c, k):
    """Of each swinging pair: size, damped frequency, damping ratio."""
    values = [v for v in np.linalg.eigvals(state_matrix(m, c, k)) if v.imag > 0]
    values.sort(key=abs)
    return [(abs(v), v.imag, -v.real / abs(v)) for v in values]


def modal():
    draw = Draw(21)
    for count, damped in ((3, True), (5, False), (6, True)):
        system, m, c, k = chain(draw, count, damped=damped)
        values, shapes = eigh(k, m)
        answers = {}
        for n, value in enumerate(values):
            answers[f"frequency[{n + 1}]"] = math.sqrt(value)
            answers[f"modal_stiffness[{n + 1}]"] = value
            answers[f"effective_mass[{n + 1}]"] = ((shapes[:, n] @ m).sum() ** 2, 1e-8)
        if damped:
            for n, (size, omega, ratio) in enumerate(damped_modes(m, c, k)):
                answers |= {
                    f"complex_frequency[{n + 1}]": size,
                    f"damped_frequency[{n + 1}]": omega,
                    f"damping_ratio[{n + 1}]": ratio,
                }
        ROWS.add(
            "vibration/modal-analysis",
            f"chain of {count}",
            {"system": system, "damping": "dampers", "normalisation": {"modal-mass": {"mass": "1 kg"}}},
            answers,
        )
    for _ in range(2):
        m, j, a, b, kf, kr, cf, cr, wf, wr, tf, tr = draw.floats(
            (900, 1500),
            (1200, 2500),
            (1, 1.4),
            (1.3, 1.7),
            (15000, 30000),
            (15000, 30000),
            (1000, 2000),
            (1000, 2000),
            (30, 50),
            (30, 50),
            (150000, 200000),
            (150000, 200000),
        )
        inputs = {"body": f"{m} kg", "inertia": f"{j} kg*m^2"}
        for name, (at, stiff, slow, wheel, tyre) in (
            ("front", (a, kf, cf, wf, tf)),
            ("rear", (b, kr, cr, wr, tr)),
        ):
            inputs[name] = {
                "distance": f"{at} m",
                "stiffness": f"{stiff} N/m",
                "damping": f"{slow} N*s/m",
                "wheel": f"{wheel} kg",
                "tyre": f"{tyre} N/m",
            }
        m, j, a, b, kf, kr, cf, cr, wf, wr, tf, tr = map(float, (m, j, a, b, kf, kr, cf, cr, wf, wr, tf, tr))
        # Heave, pitch, wheels: any coordinates have the same frequencies.
        front, rear = np.array([1, a, -1, 0]), np.array([1, -b, 0, -1])
        masses = np.diag([m, j, wf, wr])
        stiff = kf * np.outer(front, front) + kr * np.outer(rear, rear) + np.diag([0, 0, tf, tr])
        slow = cf * np.outer(front, front) + cr * np.outer(rear, rear)
        answers = {
            f"frequency[{n + 1}]": math.sqrt(v) for n, v in enumerate(eigh(stiff, masses, eigvals_only=True))
        }
        for n, (size, omega, ratio) in enumerate(damped_modes(masses, slow, stiff)):
            answers |= {
                f"complex_frequency[{n + 1}]": size,
                f"damped_frequency[{n + 1}]": omega,
                f"damping_ratio[{n + 1}]": ratio,
            }
        ROWS.add("vibration/half-car", f"body of {m:g} kg", inputs, answers)
    for shafts, held in (
        ([(0, 1), (1, 2), (2, 3)], False),
        ([(0, 1), (1, 2), (1, 3), (3, 4)], False),
        ([(0, 1), (1, 2), (2, 3)], True),
    ):
        count = max(b for _, b in shafts) + 1
        inertia = [draw(0.5, 6) for _ in range(count)]
        twist = [draw(2e4, 2e5) for _ in shafts]
        discs = [
            {"name": f"d{n + 1}", "inertia": {"given": {"inertia": f"{j} kg*m^2"}}}
            for n, j in enumerate(inertia)
        ]
        if held:
            discs[0]["inertia"] = "held"
        k = np.zeros((count, count))
        for (i, j), stiff in zip(shafts, twist):
            along = np.eye(count)[i] - np.eye(count)[j]
            k += float(stiff) * np.outer(along, along)
        m = np.diag([float(j) for j in inertia])
        if held:
            k, m = k[1:, 1:], m[1:, 1:]
        values = eigh(k, m, eigvals_only=True)
        values = values if held else values[1:]
        ROWS.add(
            "vibration/torsional-train",
            f"{count} discs{', one held' if held else ''}",
            {
                "discs": discs,
                "shafts": [
                    {
                        "from": f"d{i + 1}",
                        "to": f"d{j + 1}",
                        "stiffness": {"stiffness": {"stiffness": f"{s} N*m/rad"}},
                    }
                    for (i, j), s in zip(shafts, twist)
                ],
            },
            {f"frequency[{n + 1}]": math.sqrt(v) for n, v in enumerate(values)},
        )


def responses():
    draw = Draw(22)
    for count in (2, 4):
        system, m, c, k = chain(draw, count)
        force, omega, x0, v0 = draw.floats((20, 90), (5, 30), (0.01, 0.05), (0.1, 0.6))
        times = draw.floats((0.1, 0.3), (0.4, 0.7), (0.9, 1.5))
        # The force as two more states: its cosine and its sine.
        big = np.zeros((2 * count + 2, 2 * count + 2))
        big[: 2 * count, : 2 * count] = state_matrix(m, c, k)
        big[count, 2 * count] = float(force) / m[0, 0]
        big[-2, -1], big[-1, -2] = -float(omega), float(omega)
        start = np.zeros(2 * count + 2)
        start[count - 1], start[count], start[-2] = float(x0), float(v0), 1
        answers = {}
        for n, t in enumerate(times):
            now = expm(big * float(t)) @ start
            for i in range(count):
                answers[f"displacement[{n + 1}][{i + 1}]"] = now[i]
                answers[f"velocity[{n + 1}][{i + 1}]"] = now[count + i]
        ROWS.add(
            "vibration/multi-degree-response",
            f"{count} masses, harmonic force",
            {
                "system": system,
                "damping": "dampers",
                "start": [
                    {"coordinate": 1, "displacement": "0 m", "velocity": f"{v0} m/s"},
                    {"coordinate": count, "displacement": f"{x0} m", "velocity": "0 m/s"},
                ],
                "forces": [
                    {
                        "coordinate": 1,
                        "course": {
                            "harmonic": {"force": f"{force} N", "frequency": f"{omega} rad/s", "lag": "0 deg"}
                        },
                    }
                ],
                "times": "[s]\n" + "\n".join(times),
                "observed": [{"coordinate": i + 1} for i in range(count)],
                "duration": "2 s",
            },
            answers,
        )
    for count, quantity, order in ((3, "displacement", 0), (5, "velocity", 1), (3, "acceleration", 2)):
        system, m, c, k = chain(draw, count)
        first, second = draw.floats((5, 50), (5, 50))
        omegas = draw.floats((5, 15), (16, 30), (31, 60))
        forces = np.zeros(count, complex)
        forces[0] += float(first)
        forces[-1] += float(second) * np.exp(1j * math.radians(50))
        answers = {}
        for n, omega in enumerate(map(float, omegas)):
            moves = np.linalg.solve(k + 1j * omega * c - omega**2 * m, forces) * (1j * omega) ** order
            for i in (0, count - 1):
                answers |= {
                    f"amplitude[{n + 1}][{i + 1}]": abs(moves[i]),
                    f"real[{n + 1}][{i + 1}]": (moves[i].real, 1e-8),
                    f"imaginary[{n + 1}][{i + 1}]": (moves[i].imag, 1e-8),
                }
        ROWS.add(
            "vibration/frequency-response-matrix",
            f"{count} masses, {quantity}",
            {
                "system": system,
                "damping": "dampers",
                "forces": [
                    {"coordinate": 1, "amplitude": f"{first} N", "phase": "0 deg"},
                    {"coordinate": count, "amplitude": f"{second} N", "phase": "50 deg"},
                ],
                "frequencies": "[rad/s]\n" + "\n".join(omegas),
                "observed": [{"coordinate": 1}, {"coordinate": count}],
                "quantity": quantity,
            },
            answers,
        )


def extreme(of, slope, start, end, pieces=4000):
    """Largest size of a smooth function: at the ends, and where its slope changes sign."""
    places = np.linspace(start, end, pieces + 1)
    slopes = [slope(t) for t in places]
    found = [start, end] + [
        brentq(slope, a, b, xtol=1e-15)
        for a, b, p, q in zip(places, places[1:], slopes, slopes[1:])
        if p * q < 0
    ]
    best = max(found, key=lambda t: abs(of(t)))
    return of(best), best


def shocks():
    draw = Draw(23)
    for form, ratio in (("half-sine", "0.03"), ("rectangle", "0.1"), ("half-sine", "0")):
        size, duration = draw.floats((50, 400), (0.006, 0.02))
        hertz = draw.floats((15, 30), (60, 120))
        a0, td, zeta = float(size), float(duration), float(ratio)
        answers = {"velocity_change": a0 * td * (2 / math.pi if form == "half-sine" else 1)}
        for n, w in enumerate(2 * math.pi * float(f) for f in hertz):
            # z, z', and the pulse and its derivative over its frequency, as one linear system.
            wp = math.pi / td if form == "half-sine" else 0.0
            a = np.array([[0, 1, 0, 0], [-w * w, -2 * zeta * w, -1, 0], [0, 0, 0, wp], [0, 0, -wp, 0]])
            start = np.array([0, 0, 0, a0]) if form == "half-sine" else np.array([0, 0, a0, 0])
            during = lambda t: expm(a * t) @ start
            left = during(td) * [1, 1, 0, 0]
            after = lambda t: expm(a * t) @ left
            row = np.array([-w * w, -2 * zeta * w, 0, 0])
            most = lambda state, end: abs(
                extreme(lambda t: row @ state(t), lambda t: row @ a @ state(t), 0.0, end, 300)[0]
            )
            primary = most(during, td)
            # Right after the pulse the acceleration is what it was before; from there on it is the free motion.
            residual = most(after, 2 * math.pi / w)
            answers |= {
                f"primary[{n + 1}]": primary,
                f"residual[{n + 1}]": residual,
                f"maximax[{n + 1}]": max(primary, residual),
                f"amplification[{n + 1}]": max(primary, residual) / a0,
            }
        ROWS.add(
            "vibration/shock-response-spectrum",
            f"{form}, damping ratio {ratio}",
            {
                "shock": {
                    "pulse": {"acceleration": f"{size} m/s^2", "form": {form: {"duration": f"{duration} s"}}}
                },
                "ratio": ratio,
                "measure": "absolute",
                "lowest": "5 Hz",
                "highest": "500 Hz",
                "frequencies": [f"{f} Hz" for f in hertz],
            },
            answers,
            1e-9,
        )
    for course, key in (("half-sine", "duration"), ("ramp-step", "rise"), ("exponential", "constant")):
        m, k, c, force, tau = draw.floats((2, 6), (1000, 4000), (5, 25), (50, 300), (0.05, 0.2))
        times = draw.floats((0.02, 0.05), (0.1, 0.2), (0.3, 0.5))
        mf, kf, cf, f0, t0 = map(float, (m, k, c, force, tau))
        load = {
            "half-sine": lambda t: f0 * math.sin(math.pi * t / t0) if t < t0 else 0.0,
            "ramp-step": lambda t: f0 * min(t / t0, 1),
            "exponential": lambda t: f0 * math.exp(-t / t0),
        }[course]
        # Duhamel's integral with the response to an impulse as an exponential.
        a = np.array([[0, 1], [-kf / mf, -cf / mf]])
        impulse = lambda t: expm(a * t)[0, 1] / mf
        answers = {}
        for n, t in enumerate(map(float, times)):
            corners = [t0] if 0 < t0 < t else None
            answers[f"displacement[{n + 1}]"] = quad(
                lambda s: impulse(t - s) * load(s),
                0,
                t,
                points=corners,
                epsabs=1e-16,
                epsrel=1e-13,
                limit=200,
            )[0]
        ROWS.add(
            "vibration/transient-response",
            course,
            {
                "mass": {"mass": {"mass": f"{m} kg"}},
                "elasticity": {"stiffness": {"stiffness": f"{k} N/m"}},
                "damping": {"coefficient": {"coefficient": f"{c} N*s/m"}},
                "excitation": {
                    "force": {
                        "size": {"largest": {"force": f"{force} N"}},
                        "course": {course: {key: f"{tau} s"}},
                    }
                },
                "times": [f"{t} s" for t in times],
            },
            answers,
        )


def random_vibration():
    draw = Draw(24)
    for zeta in ("0.05", "0.12", "0.3"):
        f, level, low, high = draw.floats((20, 80), (1, 4), (5, 15), (120, 400))
        w, z, s = 2 * math.pi * float(f), float(zeta), float(level)
        part = lambda of: quad(
            lambda x: of(2 * math.pi * x) * s,
            float(low),
            float(high),
            points=[float(f)],
            epsrel=1e-13,
            epsabs=0,
            limit=400,
        )[0]
        line = lambda o: 1 / ((w * w - o * o) ** 2 + (2 * z * w * o) ** 2)
        x, v, a = (
            math.sqrt(part(of))
            for of in (line, lambda o: o * o * line(o), lambda o: (w**4 + (2 * z * w * o) ** 2) * line(o))
        )
        ROWS.add(
            "vibration/random-response",
            f"band, damping ratio {zeta}",
            {
                "elasticity": {"natural-frequency": {"frequency": f"{f} Hz"}},
                "damping": {"ratio": {"ratio": zeta}},
                "excitation": {
                    "base": {
                        "density": {
                            "band": {"level": f"{level} m^2/s^4/Hz", "from": f"{low} Hz", "to": f"{high} Hz"}
                        }
                    }
                },
            },
            {
                "displacement": x,
                "velocity": v,
                "acceleration": a,
                "crossing_rate": v / x,
                "three_sigma_acceleration": 3 * a,
            },
        )
    for count in (2, 3):
        links = [draw.floats((2, 6), (2e4, 9e4)) for _ in range(count)]
        level, low, high = draw.floats((0.5, 2), (2, 4), (60, 90))
        zeta = 0.04
        m, k = np.diag([float(a) for a, _ in links]), np.zeros((count, count))
        for i, (_, spring) in enumerate(links):
            along = np.eye(count)[i] - (np.eye(count)[i - 1] if i else 0)
            k += float(spring) * np.outer(along, along)
        values, shapes = eigh(k, m)
        omegas = np.sqrt(values)
        c = m @ shapes @ np.diag(2 * zeta * omegas) @ shapes.T @ m
        solve = lambda o: np.linalg.solve(k + 1j * o * c - o * o * m, -m @ np.ones(count))
        corners = [w / (2 * math.pi) for w in omegas]
        part = lambda of: math.sqrt(
            quad(
                lambda f: float(level) * abs(of(2 * math.pi * f)) ** 2,
                float(low),
                float(high),
                points=corners,
                epsrel=1e-13,
                epsabs=0,
                limit=400,
            )[0]
        )
        answers = {f"frequency[{n + 1}]": w for n, w in enumerate(omegas)}
        for i in range(count):
            answers[f"displacement[{i + 1}]"] = part(lambda o: solve(o)[i])
            answers[f"relative_acceleration[{i + 1}]"] = part(lambda o: o * o * solve(o)[i])
            answers[f"acceleration[{i + 1}]"] = part(lambda o: 1 - o * o * solve(o)[i])
        ROWS.add(
            "vibration/random-chain",
            f"{count} masses",
            {
                "links": [{"mass": {"mass": {"mass": f"{a} kg"}}, "stiffness": f"{b} N/m"} for a, b in links],
                "ratio": str(zeta),
                "density": {
                    "band": {"level": f"{level} m^2/s^4/Hz", "from": f"{low} Hz", "to": f"{high} Hz"}
                },
            },
            answers,
        )


def forces_with_corners():
    """Friction and springs of two slopes by an integrator that stops at each corner."""
    draw = Draw(25)
    for c in ("0", "4"):
        m, k, friction, x0, t = draw.floats((2, 5), (500, 2000), (2, 5), (0.08, 0.12), (0.35, 0.55))
        mf, kf, ff, cf, asked = float(m), float(k), float(friction), float(c), float(t)
        x, now, strokes, place = np.array([float(x0), 0.0]), 0.0, 0, None
        while kf * abs(x[0]) > ff:
            sign = -np.sign(x[0])
            # The velocity is zero at the start of a stroke too: its end is a zero in the other direction.
            stops = lambda t, y: y[1]
            stops.terminal, stops.direction = True, -sign
            run = solve_ivp(
                lambda t, y: [y[1], (-kf * y[0] - cf * y[1] - ff * sign) / mf],
                (now, now + 10),
                x,
                events=stops,
                dense_output=True,
                **DIGITS,
            )
            if place is None and run.t[-1] >= asked:
                place = solve_ivp(
                    lambda t, y: [y[1], (-kf * y[0] - cf * y[1] - ff * sign) / mf], (now, asked), x, **DIGITS
                ).y[:, -1]
            x, now, strokes = np.array([run.y[0, -1], 0.0]), run.t[-1], strokes + 1
        answers = {"displacement": place[0], "velocity": place[1], "stop_time": now, "rest_position": x[0]}
        if float(c) == 0:
            answers["strokes"] = strokes
        ROWS.add(
            "vibration/coulomb-damping",
            f"viscous {c} N s/m",
            {
                "mass": {"mass": {"mass": f"{m} kg"}},
                "stiffness": f"{k} N/m",
                "friction": {"force": {"force": f"{friction} N"}},
                "static_ratio": "1",
                "damping": f"{c} N*s/m",
                "displacement": f"{x0} m",
                "velocity": "0 m/s",
                "time": f"{t} s",
            },
            answers,
            1e-9,
        )
    for kind in ("two-slopes", "saturating", "gap"):
        m, k1, corner, k2, v0 = draw.floats((1, 4), (200, 600), (0.02, 0.04), (900, 2000), (0.8, 1.5))
        fields = {"corner": f"{corner} m"}
        fields |= {"stiffness": f"{k1} N/m"} if kind != "gap" else {}
        fields |= {"beyond": f"{k2} N/m"} if kind != "saturating" else {}
        mf, y0, v = float(m), float(corner), float(v0)
        inner, outer = (0.0 if kind == "gap" else float(k1)), (0.0 if kind == "saturating" else float(k2))
        pull = lambda x: inner * x if x < y0 else inner * y0 + outer * (x - y0)
        energy = lambda x: quad(pull, 0, x, points=[y0] if x > y0 else None, epsrel=1e-14)[0]
        top = brentq(lambda x: energy(x) - mf * v * v / 2, 1e-9, 10, xtol=1e-15)
        # x = top - u^2 takes the root away from the turning point.
        root = lambda u: (
            2 * u / math.sqrt(2 * (mf * v * v / 2 - energy(top - u * u)) / mf)
            if u
            else 2 / math.sqrt(2 * pull(top) / mf)
        )
        edge = math.sqrt(top - y0)
        quarter = (
            quad(root, 0, edge, epsrel=1e-12)[0]
            + quad(lambda x: 1 / math.sqrt(v * v - 2 * energy(x) / mf), 0, y0, epsrel=1e-12)[0]
        )
        ROWS.add(
            "vibration/piecewise-spring",
            kind,
            {
                "mass": f"{m} kg",
                "characteristic": {kind: fields},
                "displacement": "0 m",
                "velocity": f"{v0} m/s",
            },
            {"largest_displacement": top, "period": 4 * quarter, "largest_force": pull(top)},
            1e-8,
        )


def networks():
    draw = Draw(26)
    for frequency in ("14", "55"):
        m, k1, c1, k2, c2, k3, force = draw.floats(
            (5, 12), (2000, 4000), (50, 120), (9000, 15000), (200, 400), (1000, 3000), (1, 9)
        )
        k1f, c1f, k2f, c2f, k3f, f, w = map(float, (k1, c1, k2, c2, k3, force, frequency))
        link = lambda z1, z2, z3: np.array([[z1 + z3, -z1], [-z1, z1 + z2]])
        still = np.linalg.solve(link(k1f, k2f, k3f), [f, 0])
        a = link(k1f + 1j * w * c1f, k2f + 1j * w * c2f, k3f)
        a[0, 0] -= float(m) * w * w
        moves = np.linalg.solve(a, [f, 0])
        pad = lambda k, c: {"kelvin-voigt": {"stiffness": f"{k} N/m", "damping": f"{c} N*s/m"}}
        ROWS.add(
            "vibration/spring-network",
            f"two pads and a spring at {frequency} rad/s",
            {
                "nodes": [{"name": "mass", "mass": f"{m} kg"}, {"name": "between"}],
                "elements": [
                    {"from": "mass", "to": "between", "kind": pad(k1, c1)},
                    {"from": "between", "kind": pad(k2, c2)},
                    {
                        "from": "mass",
                        "kind": {"spring": {"spring": {"stiffness": {"stiffness": f"{k3} N/m"}}}},
                    },
                ],
                "loaded": "mass",
                "force": f"{force} N",
                "frequency": f"{frequency} rad/s",
            },
            {
                "stiffness": f / still[0],
                "displacement[1]": still[0],
                "displacement[2]": still[1],
                "natural_frequency": math.sqrt(f / still[0] / float(m)),
                "amplitude": abs(moves[0]),
            },
        )


modal()
responses()
shocks()
random_vibration()
forces_with_corners()
networks()
ROWS.write()
