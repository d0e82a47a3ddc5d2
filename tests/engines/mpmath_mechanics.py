"""Springs, tops, free bodies and linkages at 30 digits, from energies, geometry and their derivatives."""

import mpmath
from mpmath import mp, mpf, matrix

from rows import Draw, Rows, vector

mp.dps = 30
ROWS = Rows(
    "mpmath", mpmath.__version__, 1e-12, "30 digits; 1e-12 is what ours allow for their own rounding."
)
TAU = 2 * mp.pi
G = mpf("9.81")


def free_vibration():
    """The exponential of the state matrix; zeros and turning points as roots of the motion."""
    draw = Draw(11)
    for c in ("12.5", "61", "400", "900"):
        m, k, x, v, t = draw.floats((3, 9), (2000, 6000), (0.01, 0.05), (0.1, 0.9), (0.1, 0.5))
        inputs = {
            "oscillator": {
                "translation": {
                    "mass": {"mass": {"mass": f"{m} kg"}},
                    "stiffness": f"{k} N/m",
                    "damping": {"coefficient": {"coefficient": f"{c} N*s/m"}},
                    "displacement": f"{x} m",
                    "velocity": f"{v} m/s",
                }
            },
            "time": f"{t} s",
            "settled": "2 %",
        }
        m, k, c, x, v, t = map(mpf, (m, k, c, x, v, t))
        state = lambda time: mp.expm(matrix([[0, 1], [-k / m, -c / m]]) * time) * matrix([x, v])
        now = state(t)
        energy = lambda s: (k * s[0] ** 2 + m * s[1] ** 2) / 2
        answers = {
            "displacement": now[0],
            "velocity": now[1],
            "acceleration": -(k * now[0] + c * now[1]) / m,
            "energy": energy([x, v]),
            "energy_lost": energy([x, v]) - energy(now),
        }
        values = mp.polyroots([m, c, k])
        if mp.im(values[0]) != 0:
            omega = abs(mp.im(values[0]))
            answers |= {"damped_frequency": omega, "natural_frequency": abs(values[0]), "period": TAU / omega}
            step = TAU / omega / 40

            def first(part):
                at = mpf(0)
                while state(at)[part] * state(at + step)[part] > 0:
                    at += step
                return mp.findroot(
                    lambda time: state(time)[part], (at, at + step), solver="anderson", tol=mpf(10) ** -50
                )

            answers |= {
                "first_zero": first(0),
                "first_turning": first(1),
                "turning_displacement": state(first(1))[0],
                "maximum": state(first(1))[0],
            }
        else:
            slow, fast = sorted((mp.re(r) for r in values), key=abs)
            answers |= {"slow_root": slow, "fast_root": fast}
        ROWS.add("vibration/free-vibration", f"c = {mp.nstr(c, 6)} N s/m", inputs, answers)


def springs():
    """Stiffnesses from the energy of what bends, twists, stretches or is lifted."""
    draw = Draw(12)

    def add(kind, fields, stiffness, mass="2.6"):
        inputs = {
            "motion": {
                "translation": {
                    "springs": {kind: fields},
                    "load": {"mass": {"mass": f"{mass} kg"}},
                    "gravity": "9.81 m/s^2",
                }
            }
        }
        ROWS.add(
            "vibration/equivalent-stiffness",
            kind,
            inputs,
            {
                "stiffness": stiffness,
                "natural_frequency": mp.sqrt(stiffness / mpf(mass)),
                "static_deflection": mpf(mass) * G / stiffness,
            },
        )

    def bending(moment, length, rigid, *corners):
        """Castigliano: k = 1 / integral of m(x)^2 / (E I), m the moment of a unit load."""
        return 1 / mp.quad(lambda s: moment(s) ** 2 / rigid(s), [0, *corners, length])

    length, young, d = draw.floats((0.4, 1), (6e10, 2e11), (0.01, 0.03))
    section = {"round": {"diameter": f"{d} m"}}
    second = mp.pi * mpf(d) ** 4 / 64
    long, e = mpf(length), mpf(young)
    stiff = lambda _: e * second
    add(
        "cantilever",
        {"length": f"{length} m", "young": f"{young} Pa", "section": section},
        bending(lambda s: s, long, stiff),
    )
    a = draw(0.1, 0.3)
    at = mpf(a)
    simple = lambda s: s * (long - at) / long if s < at else at * (long - s) / long
    add(
        "simply-supported",
        {"length": f"{length} m", "distance": f"{a} m", "young": f"{young} Pa", "section": section},
        bending(simple, long, stiff, at),
    )
    # Held more than needed: the redundant moments make the energy least.
    fields = {"length": f"{length} m", "distance": f"{a} m", "young": f"{young} Pa", "section": section}
    inner = lambda p, q: mp.quad(lambda s: p(s) * q(s), [0, at, long]) / (e * second)
    for kind, shapes in (
        ("clamped", [lambda s: 1 - s / long, lambda s: s / long]),
        ("clamped-pinned", [lambda s: 1 - s / long]),
    ):
        gram = matrix([[inner(p, q) for q in shapes] for p in shapes])
        right = matrix([inner(p, simple) for p in shapes])
        solved = mp.lu_solve(gram, right)
        give = inner(simple, simple) - sum(solved[i] * right[i] for i in range(len(shapes)))
        add(kind, fields, 1 / give)
    over = draw(0.1, 0.3)
    out = mpf(over)
    whole = lambda s: s * out / long if s < long else long + out - s
    add(
        "overhang",
        {"length": f"{length} m", "overhang": f"{over} m", "young": f"{young} Pa", "section": section},
        1 / (mp.quad(lambda s: whole(s) ** 2, [0, long, long + out]) / (e * second)),
    )
    # A column whose top does not turn: the moment is zero at its middle.
    add(
        "column",
        {"length": f"{length} m", "young": f"{young} Pa", "section": section},
        bending(lambda s: s - long / 2, long, stiff),
    )
    first, last = draw.floats((0.01, 0.02), (0.03, 0.05))
    wide = lambda s: mpf(first) + (mpf(last) - mpf(first)) * s / long
    add(
        "tapered-bar",
        {
            "length": f"{length} m",
            "young": f"{young} Pa",
            "first_diameter": f"{first} m",
            "second_diameter": f"{last} m",
        },
        1 / mp.quad(lambda s: 1 / (e * mp.pi * wide(s) ** 2 / 4), [0, long]),
    )
    shear, lever = draw.floats((7e10, 8.2e10), (0.1, 0.3))
    twist = lambda dia, rigid, long: 1 / mp.quad(lambda s: 1 / (rigid * mp.pi * dia(s) ** 4 / 32), [0, long])
    add(
        "torsion-bar",
        {"length": f"{length} m", "shear": f"{shear} Pa", "section": section, "lever": f"{lever} m"},
        twist(lambda _: mpf(d), mpf(shear), long) / mpf(lever) ** 2,
    )
    # A helical spring: its wire is twisted by F D/2 all along pi D n.
    wire, coil, coils = draw.floats((0.003, 0.006), (0.04, 0.07), (5, 12))
    developed = mp.pi * mpf(coil) * mpf(coils)
    add(
        "helical",
        {"shear": f"{shear} Pa", "wire_diameter": f"{wire} m", "coil_diameter": f"{coil} m", "coils": coils},
        twist(lambda _: mpf(wire), mpf(shear), developed) / (mpf(coil) / 2) ** 2,
    )
    # A leaf spring on two eyes: n leaves cut to a beam of equal strength, I(x) growing with the moment to the middle.
    leaves, breadth, thick, span = "5", *draw.floats((0.04, 0.07), (0.005, 0.009), (0.7, 1.1))
    width = lambda s: mpf(leaves) * mpf(breadth) * s / (mpf(span) / 2)
    half = mp.quad(lambda s: (s / 2) ** 2 / (e * width(s) * mpf(thick) ** 3 / 12), [0, mpf(span) / 2])
    add(
        "leaf",
        {
            "young": f"{young} Pa",
            "leaves": leaves,
            "breadth": f"{breadth} m",
            "thickness": f"{thick} m",
            "span": f"{span} m",
        },
        1 / (2 * half),
    )
    # An air spring, a float, a U-tube, a string: the second derivative of the work.
    exponent, pressure, area, volume = "1.32", *draw.floats((1e5, 6e5), (0.002, 0.01), (0.001, 0.004))
    gas = lambda x: mpf(pressure) * (mpf(volume) / (mpf(volume) - mpf(area) * x)) ** mpf(exponent) * mpf(area)
    add(
        "gas",
        {
            "exponent": exponent,
            "pressure": f"{pressure} Pa",
            "area": f"{area} m^2",
            "volume": f"{volume} m^3",
        },
        mp.diff(gas, 0),
    )
    density, water = draw.floats((800, 1030), (0.01, 0.05))
    add(
        "buoyancy",
        {"density": f"{density} kg/m^3", "area": f"{water} m^2", "gravity": "9.81 m/s^2"},
        mp.diff(lambda x: mpf(density) * G * mpf(water) * x, 0),
    )
    # The liquid of one leg, lifted by x, stands on top of the other: potential energy by the heights of its centres.
    bore = draw(0.0005, 0.002)
    column = lambda top: mpf(density) * mpf(bore) * G * mp.quad(lambda z: z, [0, top])
    add(
        "u-tube",
        {"density": f"{density} kg/m^3", "area": f"{bore} m^2", "gravity": "9.81 m/s^2"},
        mp.diff(lambda x: column(1 + x) + column(1 - x), 0, 2),
    )
    tension, left, right = draw.floats((200, 900), (0.2, 0.6), (0.5, 1))
    pull = lambda x: mpf(tension) * sum(x / mp.sqrt(mpf(part) ** 2 + x**2) for part in (left, right))
    add(
        "taut-string",
        {"tension": f"{tension} N", "left": f"{left} m", "right": f"{right} m"},
        mp.diff(pull, 0),
    )
    mass, arm = draw.floats((1, 5), (0.3, 1.2))
    add(
        "pendulum",
        {"mass": f"{mass} kg", "length": f"{arm} m", "gravity": "9.81 m/s^2"},
        mp.diff(lambda x: -mpf(mass) * G * mp.sqrt(mpf(arm) ** 2 - x**2), 0, 2),
        mass,
    )
    # Springs that turn.
    for kind, fields, stiffness in (
        (
            "tapered-shaft",
            {
                "length": f"{length} m",
                "shear": f"{shear} Pa",
                "first_diameter": f"{first} m",
                "second_diameter": f"{last} m",
            },
            twist(wide, mpf(shear), long),
        ),
        (
            "helical",
            {
                "young": f"{young} Pa",
                "wire_diameter": f"{wire} m",
                "coil_diameter": f"{coil} m",
                "coils": coils,
            },
            bending(lambda s: mpf(1), developed, lambda _: e * mp.pi * mpf(wire) ** 4 / 64),
        ),
        (
            "spiral",
            {
                "length": "2.35 m",
                "young": f"{young} Pa",
                "section": {"rectangle": {"breadth": "0.012 m", "height": "0.0009 m"}},
            },
            bending(lambda s: mpf(1), mpf("2.35"), lambda _: e * mpf("0.012") * mpf("0.0009") ** 3 / 12),
        ),
        (
            "cantilever",
            {"length": f"{length} m", "young": f"{young} Pa", "section": section},
            bending(lambda s: mpf(1), long, stiff),
        ),
    ):
        ROWS.add(
            "vibration/equivalent-stiffness",
            f"{kind}, turning",
            {"motion": {"rotation": {"springs": {kind: fields}}}},
            {"torsional_stiffness": stiffness},
        )


def pendulums():
    """Second derivatives of both energies; frequencies from det(K - w^2 M)."""
    draw = Draw(13)
    hessian = lambda of: matrix(
        [
            [mp.diff(of, (0, 0), (2, 0)), mp.diff(of, (0, 0), (1, 1))],
            [mp.diff(of, (0, 0), (1, 1)), mp.diff(of, (0, 0), (0, 2))],
        ]
    )

    def modes(k, m):
        values = mp.polyroots(
            [mp.det(m), -(k[0, 0] * m[1, 1] + k[1, 1] * m[0, 0] - 2 * k[0, 1] * m[0, 1]), mp.det(k)],
            maxsteps=200,
            extraprec=200,
        )
        return [
            (mp.sqrt(v), -(k[0, 0] - v * m[0, 0]) / (k[0, 1] - v * m[0, 1]))
            for v in sorted(values, key=mp.re)
        ]

    for upper, lower in (("body", "body"), ("rod", "bob"), ("bob", "rod")):
        m1, l1, c1, j1, m2, l2, j2 = draw.floats(
            (1, 4), (0.5, 1.2), (0.2, 0.6), (0.05, 0.2), (1, 4), (0.3, 0.8), (0.02, 0.1)
        )
        parts = {"mass": f"{m1} kg", "length": f"{l1} m"}
        if upper == "body":
            parts |= {"centre": f"{c1} m", "inertia": f"{j1} kg*m^2"}
        below = {"mass": f"{m2} kg"} | (
            {"centre": f"{l2} m", "inertia": f"{j2} kg*m^2"} if lower == "body" else {"length": f"{l2} m"}
        )
        m1, l1, c1, j1, m2, l2, j2 = map(mpf, (m1, l1, c1, j1, m2, l2, j2))
        about = {"bob": lambda m, l: (l, mpf(0)), "rod": lambda m, l: (l / 2, m * l**2 / 12)}
        c1, j1 = (c1, j1) if upper == "body" else about[upper](m1, l1)
        c2, j2 = (l2, j2) if lower == "body" else about[lower](m2, l2)
        potential = lambda a, b: -m1 * G * c1 * mp.cos(a) - m2 * G * (l1 * mp.cos(a) + c2 * mp.cos(b))
        kinetic = lambda a, b: ((m1 * c1**2 + j1) * a**2 + m2 * (l1 * a + c2 * b) ** 2 + j2 * b**2) / 2
        answers = {}
        for n, (omega, ratio) in enumerate(modes(hessian(potential), hessian(kinetic))):
            answers |= {
                f"angular_frequency[{n + 1}]": omega,
                f"ratio[{n + 1}]": ratio,
                f"period[{n + 1}]": TAU / omega,
            }
        ROWS.add(
            "vibration/double-pendulum",
            f"{upper} over {lower}",
            {"upper": {upper: parts}, "lower": {lower: below}, "gravity": "9.81 m/s^2"},
            answers,
        )
    for left, right in (("rod", "bob"), ("bob", "rod")):
        m1, l1, a1, m2, l2, a2, k = draw.floats(
            (1, 4), (0.5, 1.2), (0.2, 0.4), (1, 4), (0.5, 0.9), (0.2, 0.4), (40, 90)
        )
        side = lambda m, l, a: {"mass": f"{m} kg", "length": f"{l} m", "spring": f"{a} m"}
        inputs = {
            "left": {left: side(m1, l1, a1)},
            "right": {right: side(m2, l2, a2)},
            "spring": f"{k} N/m",
            "gravity": "9.81 m/s^2",
        }
        m1, l1, a1, m2, l2, a2, k = map(mpf, (m1, l1, a1, m2, l2, a2, k))
        share = {"rod": (mpf(1) / 2, mpf(1) / 3), "bob": (mpf(1), mpf(1))}
        potential = lambda a, b: (
            -m1 * G * l1 * share[left][0] * mp.cos(a)
            - m2 * G * l2 * share[right][0] * mp.cos(b)
            + k * (a2 * b - a1 * a) ** 2 / 2
        )
        kinetic = lambda a, b: (m1 * l1**2 * share[left][1] * a**2 + m2 * l2**2 * share[right][1] * b**2) / 2
        (low, r1), (high, r2) = modes(hessian(potential), hessian(kinetic))
        ROWS.add(
            "vibration/coupled-pendulums",
            f"{left} and {right}",
            inputs,
            {"frequency[1]": low, "ratio[1]": r1, "frequency[2]": high, "ratio[2]": r2},
        )


def tops():
    draw = Draw(14)
    for degrees, spin in (("35", "180"), ("64", "150"), ("118", "90")):
        m, l, axial, transverse = draw.floats((0.4, 0.6), (0.05, 0.07), (4e-4, 6e-4), (2e-3, 3e-3))
        body = {
            "mass": f"{m} kg",
            "distance": f"{l} m",
            "gravity": "9.81 m/s^2",
            "inertia": {"about-point": {"axial": f"{axial} kg*m^2", "transverse": f"{transverse} kg*m^2"}},
        }
        inputs = {"body": body, "nutation": f"{degrees} deg", "motion": {"spin": {"spin": f"{spin} rad/s"}}}
        m, l, c, a, angle, s = (
            mpf(m),
            mpf(l),
            mpf(axial),
            mpf(transverse),
            mp.radians(mpf(degrees)),
            mpf(spin),
        )
        lagrangian = lambda th, phi, psi: (
            a * (phi * mp.sin(th)) ** 2 + c * (psi + phi * mp.cos(th)) ** 2
        ) / 2 - m * G * l * mp.cos(th)
        # Steady: the Lagrangian does not change with the angle. It is of second degree in the precession.
        slope = lambda phi: mp.diff(lambda th: lagrangian(th, phi, s), angle)
        two = mp.diff(slope, 0, 2) / 2
        slow, fast = sorted(
            (mp.re(r) for r in mp.polyroots([two, mp.diff(slope, 0), slope(mpf(0))], extraprec=100)), key=abs
        )
        # The momenta of the slow one, and the small oscillation of the angle while they stay.
        vertical = mp.diff(lambda phi: lagrangian(angle, phi, s), slow)
        along = mp.diff(lambda psi: lagrangian(angle, slow, psi), s)

        def effective(th):
            return (
                (vertical - along * mp.cos(th)) ** 2 / (2 * a * mp.sin(th) ** 2)
                + along**2 / (2 * c)
                + m * G * l * mp.cos(th)
            )

        ROWS.add(
            "rigid-body/heavy-top",
            f"at {degrees} degrees",
            inputs,
            {
                "slow_precession": slow,
                "fast_precession": fast,
                "precession_period": TAU / abs(slow),
                "axial_velocity": along / c,
                "nutation_frequency": mp.sqrt(mp.diff(effective, angle, 2) / a),
            },
            1e-11,
        )
    for degrees, rate, precession, spin in (
        ("40", "0", "0", "150"),
        ("35", "2.1", "-3", "170"),
        ("70", "-1.4", "5", "190"),
    ):
        m, l, axial, transverse = draw.floats((0.4, 0.6), (0.05, 0.07), (4e-4, 6e-4), (2e-3, 3e-3))
        body = {
            "mass": f"{m} kg",
            "distance": f"{l} m",
            "gravity": "9.81 m/s^2",
            "inertia": {"about-point": {"axial": f"{axial} kg*m^2", "transverse": f"{transverse} kg*m^2"}},
        }
        inputs = {
            "body": body,
            "nutation": f"{degrees} deg",
            "nutation_rate": f"{rate} rad/s",
            "precession": f"{precession} rad/s",
            "spin": {"axial-velocity": {"axial_velocity": f"{spin} rad/s"}},
        }
        m, l, c, a = mpf(m), mpf(l), mpf(axial), mpf(transverse)
        th, rate, phi, n = mp.radians(mpf(degrees)), mpf(rate), mpf(precession), mpf(spin)
        along, vertical = c * n, a * phi * mp.sin(th) ** 2 + c * n * mp.cos(th)
        # What is called energy there leaves out that of the spin, which stays.
        energy = a * (rate**2 + (phi * mp.sin(th)) ** 2) / 2 + c * n**2 / 2 + m * G * l * mp.cos(th)
        turning = (
            lambda u: (
                2 * a * (1 - u**2) * (energy - c * n**2 / 2 - m * G * l * u) - (vertical - along * u) ** 2
            )
            / a**2
        )
        places = [mpf(-1) + mpf(k) / 400 for k in range(801)]
        zeros = []
        for low, high in zip(places, places[1:]):
            if turning(low) == 0:
                zeros.append(low)
            elif turning(low) * turning(high) < 0:
                zeros.append(mp.findroot(turning, (low, high), solver="anderson", tol=mpf(10) ** -50))
        if rate == 0:
            # It begins at a turning point itself.
            zeros = [mp.cos(th) if abs(z - mp.cos(th)) < mpf("1e-6") else z for z in zeros]
            if not any(z == mp.cos(th) for z in zeros):
                zeros.append(mp.cos(th))
        low, high = sorted(zeros)[:2]
        # u = middle + half sin(s) takes the roots away from both ends.
        middle, half = (low + high) / 2, (high - low) / 2
        rest = lambda u: mp.sqrt(abs(turning(u) / ((u - low) * (high - u))))
        place = lambda s: middle + half * mp.sin(s)
        ends = [-mp.pi / 2, 0, mp.pi / 2]
        period = 2 * mp.quad(lambda s: 1 / rest(place(s)), ends)
        speed = lambda u: (vertical - along * u) / (a * (1 - u**2))
        advance = 2 * mp.quad(lambda s: speed(place(s)) / rest(place(s)), ends)
        ROWS.add(
            "rigid-body/top-nutation",
            f"from {degrees} degrees",
            inputs,
            {
                "highest": mp.acos(high),
                "lowest": mp.acos(low),
                "nutation_period": period,
                "nutation_frequency": TAU / period,
                "advance": advance,
                "mean_precession": advance / period,
                "vertical_angular_momentum": vertical,
                "energy": energy - c * n**2 / 2,
                "precession_at_lowest": speed(low),
            },
            1e-11,
        )


def free_bodies():
    draw = Draw(15)
    for speed, degrees in (("7.5", "22"), ("3.1", "130")):
        axial, transverse = draw.floats((1, 3), (1.6, 3))
        inputs = {
            "inertia": {"moments": {"axial": f"{axial} kg*m^2", "transverse": f"{transverse} kg*m^2"}},
            "motion": {"speed": {"speed": f"{speed} rad/s", "angle": f"{degrees} deg"}},
        }
        c, a, w, angle = mpf(axial), mpf(transverse), mpf(speed), mp.radians(mpf(degrees))
        omega = [w * mp.sin(angle), w * mp.cos(angle)]
        momentum = [a * omega[0], c * omega[1]]
        size = mp.hypot(*momentum)
        # The velocity as precession along the momentum and spin along the axis: two equations.
        phi, psi = mp.lu_solve(matrix([[momentum[0] / size, 0], [momentum[1] / size, 1]]), matrix(omega))
        ROWS.add(
            "rigid-body/free-axisymmetric",
            f"{speed} rad/s at {degrees} degrees",
            inputs,
            {
                "precession": phi,
                "spin": psi,
                "angular_momentum": size,
                "nutation": mp.atan2(momentum[0], momentum[1]),
                "rotational_energy": (momentum[0] * omega[0] + momentum[1] * omega[1]) / 2,
                "axial_velocity": omega[1],
                "transverse_momentum": momentum[0],
                "precession_period": TAU / phi,
            },
        )
    for velocity, t in (
        (("0.4", "1.9", "0.7"), "2.3"),
        (("1.2", "-0.2", "0.5"), "3.1"),
        (("0.1", "2", "-1.1"), "1.7"),
    ):
        moments = sorted(draw.floats((1, 1.6), (1.8, 2.2), (2.4, 2.9)), key=float)
        inputs = {
            "inertia": {"moments": {axis: f"{i} kg*m^2" for axis, i in zip("xyz", moments)}},
            "velocity": vector(velocity, "rad/s"),
            "instant": f"{t} s",
        }
        inertia, start, end = [mpf(i) for i in moments], [mpf(w) for w in velocity], mpf(t)

        def rates(_, y):
            w, r = y[:3], y[3:]
            turn = [
                ((inertia[(i + 1) % 3] - inertia[(i + 2) % 3]) * w[(i + 1) % 3] * w[(i + 2) % 3]) / inertia[i]
                for i in range(3)
            ]
            # The axes of the body, e_i' = w x e_i; w is in their components, so e_1' = w3 e_2 - w2 e_3.
            e = [r[0:3], r[3:6], r[6:9]]
            axes = []
            for i in range(3):
                j, k = (i + 1) % 3, (i + 2) % 3
                axes += [w[k] * e[j][n] - w[j] * e[k][n] for n in range(3)]
            return turn + axes

        with mp.workdps(20):
            y = mp.odefun(rates, 0, start + [mpf(int(i == j)) for i in range(3) for j in range(3)])(end)
        w, e = y[:3], [y[3:6], y[6:9], y[9:12]]
        momentum = mp.sqrt(sum((i * x) ** 2 for i, x in zip(inertia, start)))
        ROWS.add(
            "rigid-body/free-triaxial",
            f"({', '.join(velocity)}) rad/s",
            inputs,
            {
                "velocity": list(w),
                "fixed_velocity": [sum(w[i] * e[i][n] for i in range(3)) for n in range(3)],
                "x_axis": list(e[0]),
                "y_axis": list(e[1]),
                "z_axis": list(e[2]),
                "angular_momentum": momentum,
                "rotational_energy": sum(i * x**2 for i, x in zip(inertia, start)) / 2,
            },
            1e-11,
        )


def presses():
    """Virtual work with the derivative of where the load stands."""
    draw = Draw(16)
    for degrees in ("6", "24", "41"):
        first, second, knee = draw.floats((0.2, 0.3), (0.25, 0.5), (200, 900))
        inputs = {
            "fixed_link": f"{first} m",
            "ram_link": f"{second} m",
            "angle": f"{degrees} deg",
            "sought": {"thrust": {"knee": f"{knee} N"}},
        }
        a, b, p, angle = mpf(first), mpf(second), mpf(knee), mp.radians(mpf(degrees))
        ram = lambda th: a * mp.cos(th) + mp.sqrt(b**2 - (a * mp.sin(th)) ** 2)
        advantage = -mp.diff(lambda th: a * mp.sin(th), angle) / mp.diff(ram, angle)
        ROWS.add(
            "virtual-work/toggle-press",
            f"at {degrees} degrees",
            inputs,
            {
                "thrust": p * advantage,
                "mechanical_advantage": advantage,
                "remaining_stroke": a + b - ram(angle),
            },
        )
    for stages, degrees in ((1, "38"), (3, "22"), (4, "51")):
        bar, x, load, weight = draw.floats((1, 2), (1.5, 2.5), (3000, 9000), (50, 200))
        distance = draw(0.3, 0.8)
        inputs = {
            "stages": stages,
            "bar": f"{bar} m",
            "angle": f"{degrees} deg",
            "bar_weight": f"{weight} N",
            "frames": 2,
            "lower": {"ground": {"x": f"{x} m", "y": "-0.2 m"}},
            "upper": {"rising": {"stage": 1, "distance": f"{distance} m"}},
            "sought": {"cylinder": {"load": f"{load} N"}},
            "speed": "0.015 m/s",
        }
        bar, x, load, weight, distance, angle = (
            mpf(bar),
            mpf(x),
            mpf(load),
            mpf(weight),
            mpf(distance),
            mp.radians(mpf(degrees)),
        )
        long = lambda th: mp.hypot(distance * mp.cos(th) - x, distance * mp.sin(th) + mpf("0.2"))
        height = lambda th: stages * bar * mp.sin(th)
        # Two bars of a stage in each of two frames, each with its centre at the middle of its stage.
        potential = lambda th: load * height(th) + 4 * weight * sum(
            (n + mpf(1) / 2) * bar * mp.sin(th) for n in range(stages)
        )
        grows = mp.diff(long, angle)
        ratio = mp.diff(height, angle) / grows
        ROWS.add(
            "virtual-work/scissor-lift",
            f"{stages} stages at {degrees} degrees",
            inputs,
            {
                "cylinder_length": long(angle),
                "height": height(angle),
                "speed_ratio": ratio,
                "table_speed": ratio * mpf("0.015"),
                "cylinder_force": mp.diff(potential, angle) / grows / 2,
            },
        )
    for count, pull in ((2, "37"), (4, "-55")):
        bars = [draw.floats((20, 60), (0.3, 0.9)) for _ in range(count)]
        down = draw(5, 30)
        inputs = {
            "bars": [{"weight": f"{w} N", "length": f"{l} m"} for w, l in bars],
            "vertical": f"{down} N",
            "sought": {"angles": {"force": f"{pull} N"}},
        }
        bars, down, pull = [(mpf(w), mpf(l)) for w, l in bars], mpf(down), mpf(pull)

        def potential(*angles):
            across, depth, total = mpf(0), mpf(0), mpf(0)
            for (w, l), th in zip(bars, angles):
                total -= w * (depth + l / 2 * mp.cos(th))
                across, depth = across + l * mp.sin(th), depth + l * mp.cos(th)
            return total - pull * across - down * depth

        slopes = lambda *angles: [
            mp.diff(potential, angles, tuple(int(i == j) for j in range(count))) for i in range(count)
        ]
        with mp.workdps(40):
            found = mp.findroot(slopes, [mp.sign(pull) * mpf("0.6")] * count, tol=mpf(10) ** -40)
        angles = [found[i] for i in range(count)]
        answers = {f"angle[{n + 1}]": th for n, th in enumerate(angles)}
        answers |= {
            f"curvature[{n + 1}]": mp.diff(potential, angles, tuple(2 * int(n == j) for j in range(count)))
            for n in range(count)
        }
        answers |= {
            "end_across": sum(l * mp.sin(th) for (_, l), th in zip(bars, angles)),
            "end_depth": sum(l * mp.cos(th) for (_, l), th in zip(bars, angles)),
            "pin_vertical": sum(w for w, _ in bars) + down,
        }
        ROWS.add("virtual-work/hanging-chain", f"{count} bars", inputs, answers)


def linkages():
    """Positions as functions of time, differentiated; efforts from power."""
    draw = Draw(17)
    for degrees, omega, alpha in (("33", "12", "40"), ("140", "-9", "25"), ("255", "20", "-60")):
        r, l, offset, rod, slider, force = draw.floats(
            (0.06, 0.1), (0.25, 0.4), (-0.03, 0.03), (0.8, 2), (1, 3), (-500, 500)
        )
        inputs = {
            "crank": f"{r} m",
            "rod": f"{l} m",
            "offset": f"{offset} m",
            "angle": f"{degrees} deg",
            "unknown": {"torque": {"force": f"{force} N"}},
            "pin_force": "(0; 0) N",
            "speed": f"{omega} rad/s",
            "acceleration": f"{alpha} rad/s^2",
            "rod_mass": {"uniform": {"mass": f"{rod} kg"}},
            "slider_mass": f"{slider} kg",
            "gravity": "(0; -9.81) m/s^2",
        }
        r, l, e, m3, m4, f = map(mpf, (r, l, offset, rod, slider, force))
        th0, w, a = mp.radians(mpf(degrees)), mpf(omega), mpf(alpha)
        crank = lambda t: th0 + w * t + a * t**2 / 2
        pin = lambda t: (r * mp.cos(crank(t)), r * mp.sin(crank(t)))
        leans = lambda t: mp.asin((e - r * mp.sin(crank(t))) / l)
        place = lambda t: r * mp.cos(crank(t)) + l * mp.cos(leans(t))
        centre = lambda t: ((pin(t)[0] + place(t)) / 2, (pin(t)[1] + e) / 2)

        def energy(t):
            vx, vy = (mp.diff(lambda s, i=i: centre(s)[i], t) for i in range(2))
            return (
                m3 * (vx**2 + vy**2) + m3 * l**2 / 12 * mp.diff(leans, t) ** 2 + m4 * mp.diff(place, t) ** 2
            ) / 2 + m3 * G * centre(t)[1]

        with mp.workdps(60):
            torque = (mp.diff(energy, 0) - f * mp.diff(place, 0)) / w
            answers = {
                "slider_position": place(mpf(0)),
                "slider_velocity": mp.diff(place, 0),
                "slider_acceleration": mp.diff(place, 0, 2),
                "rod_angle": leans(mpf(0)),
                "rod_speed": mp.diff(leans, 0),
                "rod_acceleration": mp.diff(leans, 0, 2),
                "torque": torque,
            }
        ROWS.add("virtual-work/slider-crank", f"at {degrees} degrees", inputs, answers)
    for degrees, omega, alpha in (("50", "7", "11"), ("210", "-4", "30")):
        r, x, y, force = draw.floats((0.2, 0.4), (0.5, 0.9), (-0.1, 0.2), (500, 2000))
        inputs = {
            "crank": f"{r} m",
            "pivot": vector((x, y), "m"),
            "angle": f"{degrees} deg",
            "unknown": {"torque": {"force": f"{force} N"}},
            "pin_force": "(0; 0) N",
            "speed": f"{omega} rad/s",
            "acceleration": f"{alpha} rad/s^2",
            "gravity": "(0; 0) m/s^2",
        }
        r, x, y, f, th0, w, a = (
            mpf(r),
            mpf(x),
            mpf(y),
            mpf(force),
            mp.radians(mpf(degrees)),
            mpf(omega),
            mpf(alpha),
        )
        crank = lambda t: th0 + w * t + a * t**2 / 2
        long = lambda t: mp.hypot(r * mp.cos(crank(t)) - x, r * mp.sin(crank(t)) - y)
        points = lambda t: mp.atan2(r * mp.sin(crank(t)) - y, r * mp.cos(crank(t)) - x)
        ROWS.add(
            "virtual-work/oscillating-cylinder",
            f"at {degrees} degrees",
            inputs,
            {
                "length": long(mpf(0)),
                "rod_velocity": mp.diff(long, 0),
                "rod_acceleration": mp.diff(long, 0, 2),
                "cylinder_speed": mp.diff(points, 0),
                "cylinder_acceleration": mp.diff(points, 0, 2),
                "torque": -f * mp.diff(long, 0) / w,
            },
        )
    for degrees, omega, alpha in (("65", "14", "30"), ("200", "-8", "90")):
        r, yoke, force = draw.floats((0.05, 0.1), (2, 5), (-300, 300))
        inputs = {
            "crank": f"{r} m",
            "angle": f"{degrees} deg",
            "unknown": {"torque": {"force": f"{force} N"}},
            "speed": f"{omega} rad/s",
            "acceleration": f"{alpha} rad/s^2",
            "yoke_mass": f"{yoke} kg",
            "gravity": "(0; 0) m/s^2",
        }
        r, m, f, th0, w, a = mpf(r), mpf(yoke), mpf(force), mp.radians(mpf(degrees)), mpf(omega), mpf(alpha)
        place = lambda t: r * mp.cos(th0 + w * t + a * t**2 / 2)
        speed, gain = mp.diff(place, 0), mp.diff(place, 0, 2)
        ROWS.add(
            "virtual-work/scotch-yoke",
            f"at {degrees} degrees",
            inputs,
            {
                "position": place(mpf(0)),
                "velocity": speed,
                "acceleration": gain,
                "torque": (m * gain - f) * speed / w,
            },
        )


def engines():
    """Harmonics of the exact motion of a piston as Fourier integrals."""
    draw = Draw(18)
    for angles in (("0",), ("0", "180"), ("0", "240", "120")):
        m, r, l, pitch = draw.floats((0.4, 0.9), (0.04, 0.06), (0.14, 0.18), (0.08, 0.12))
        inputs = {
            "arrangement": {
                "inline": {
                    "every": {
                        "reciprocating": f"{m} kg",
                        "rotating": "0 kg",
                        "throw": {"radius": {"radius": f"{r} m"}},
                        "rod": f"{l} m",
                    },
                    "count": len(angles),
                    "spacing": {"pitch": {"pitch": f"{pitch} m"}},
                    "cranks": {"angles": {"angles": [f"{a} deg" for a in angles]}},
                }
            },
            "speed": "314 rad/s",
            "motion": "exact",
        }
        m, r, l, w = mpf(m), mpf(r), mpf(l), mpf(314)
        place = lambda th: r * mp.cos(th) + mp.sqrt(l**2 - (r * mp.sin(th)) ** 2)
        answers = {}
        for order in (1, 2, 4, 6):
            part = 2 * mp.quad(lambda th: place(th) * mp.cos(order * th), [0, mp.pi / 2, mp.pi]) / mp.pi
            force = m * (order * w) ** 2 * part
            turned = abs(sum(mp.expj(order * mp.radians(mpf(a))) for a in angles))
            if turned > mpf("1e-20"):
                answers[f"force[{order}]"] = abs(force) * turned
        ROWS.add("balancing/reciprocating", f"{len(angles)} in line, exact", inputs, answers, 1e-11)


free_vibration()
springs()
pendulums()
tops()
free_bodies()
presses()
linkages()
engines()
ROWS.write()
