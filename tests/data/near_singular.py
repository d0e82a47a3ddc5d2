"""Answers near singular points to 50 digits, for tests/tests/near_singular.rs.

Run in this folder: `python3 near_singular.py > near_singular.toml` (Python 3, mpmath 1.3). Every input is the number that
the program reads, to its last bit; `condition` is the sum over the inputs of |d ln y / d ln x|, by central differences with
50 digits: what the last places of the inputs alone do to the answer, over its own.
"""

from mpmath import mp, mpf, cos, sin, sinh, cosh, exp, sqrt, log, pi, ellipk, asin, mpc, re

mp.dps = 80
points = []


def point(family, analysis, inputs, answer, formula, numbers):
    """One answer of one problem; `formula` takes the numbers, which stand in `inputs` as {0}, {1}, ..."""
    exact = [mpf(x) for x in numbers]
    value = formula(*exact)
    condition = mpf(0)
    for at, x in enumerate(exact):
        if x == 0:
            continue
        step = abs(x) * mpf(10) ** -30
        ends = [formula(*(exact[:at] + [x + side * step] + exact[at + 1:])) for side in (1, -1)]
        condition += abs((ends[0] - ends[1]) / (2 * step) * x / value)
    text = inputs.format(*(repr(float(x)) for x in numbers))
    points.append((family, analysis, text, answer, value, condition))


def free(natural, zeta, x0, v0, t):
    s = natural * sqrt(mpc(zeta * zeta - 1))
    shape = t if s == 0 else sinh(s * t) / s
    return re(exp(-zeta * natural * t) * (x0 * cosh(s * t) + (v0 + zeta * natural * x0) * shape))


for zeta in [1.0] + [1 + sign * 10.0**-k for k in (4, 6, 8, 10, 12, 14) for sign in (1, -1)
                      if (k, sign) not in [(10, 1), (12, 1), (14, -1)]]:
    point(
        "free vibration at critical damping", "vibration/free-vibration",
        'oscillator.ratios = {{ natural_frequency = "{0} rad/s", ratio = "{1}", displacement = "{2} m", velocity = "{3} m/s" }}\n'
        'time = "{4} s"',
        "displacement", free, [2.0, zeta, 0.01, 0.125, 0.75],
    )


def forced(m, k, zeta, w, f):
    r2 = w * w * m / k
    return f / k / sqrt((1 - r2) ** 2 + 4 * zeta**2 * r2)


for zeta, off in [(0.0, 1e-3), (0.0, 1e-6), (0.0, 1e-9), (0.0, -1e-8), (1e-3, 1e-6), (1e-6, 0.0), (1e-6, 1e-9),
                  (1e-9, 1e-10), (1e-9, 0.0), (1e-12, 0.0)]:
    point(
        "harmonic force at resonance", "vibration/harmonic-force",
        'mass.mass.mass = "{0} kg"\nelasticity.stiffness.stiffness = "{1} N/m"\ndamping.ratio.ratio = "{2}"\n'
        'frequency = "{3} rad/s"\nexcitation.force.force = "{4} N"',
        "amplitude", forced, [2.0, 8.0, zeta, 2 * (1 + off), 3.0],
    )


def base(m, k, zeta, y, w):
    r2 = w * w * m / k
    return y * sqrt((1 + 4 * zeta**2 * r2) / ((1 - r2) ** 2 + 4 * zeta**2 * r2))


for zeta, off in [(0.0, 1e-3), (0.0, 1e-6), (0.0, 1e-9), (1e-3, 1e-6), (1e-6, 1e-9), (1e-9, 1e-10), (1e-9, 0.0), (1e-12, 0.0)]:
    point(
        "base excitation at resonance", "vibration/base-excitation",
        'mass.mass.mass = "{0} kg"\nelasticity.stiffness.stiffness = "{1} N/m"\ndamping.ratio.ratio = "{2}"\n'
        'base.displacement = {{ amplitude = "{3} m", frequency = "{4} rad/s" }}',
        "amplitude", base, [2.0, 8.0, zeta, 0.001, 2 * (1 + off)],
    )

for ratio in [1 + 1e-15, 1 + 1e-12, 1 + 1e-9, 1 + 1e-6, 1 + 1e-3, 1e3, 1e100, 1e300]:
    point(
        "decrement of hardly and of almost fully damped motions", "vibration/logarithmic-decrement",
        'decay.amplitudes.amplitudes = {{ amplitude_ratio = "{0}", counted.cycles.cycles = "1" }}\n'
        'system.period.period = "1 s"',
        "damping_ratio", lambda x: log(x) / sqrt(4 * pi**2 + log(x) ** 2), [ratio],
    )

for apart in [1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-9, 1e-10, 1e-12]:
    point(
        "balancing planes close together", "balancing/two-plane",
        'masses = [{{ mass = "{0} kg", radius = "{1} m", angle = "0.5 rad", position = "{2} m" }}]\nplane_a = "{3} m"\n'
        'plane_b = "{4} m"\ncorrection_a.radius.radius = "0.1 m"\ncorrection_b.radius.radius = "0.1 m"\nway = "add"',
        "unbalance_a", lambda m, r, z, a, b: abs(m * r * (b - z) / (b - a)), [1.5, 0.03, 0.02, 0.25, 0.25 + apart],
    )

for spring in [1e-1, 1e-3, 1e-5, 1e-7, 1e-9, 1e-10, 1e-12, 1e-14]:
    point(
        "weakly coupled equal pendulums", "vibration/coupled-pendulums",
        'left.bob = {{ mass = "{0} kg", length = "{1} m", spring = "{2} m" }}\n'
        'right.bob = {{ mass = "{0} kg", length = "{1} m", spring = "{2} m" }}\nspring = "{3} N/m"\ngravity = "{4} m/s^2"',
        "frequency[2]", lambda m, l, a, k, g: sqrt(g / l + 2 * k * a**2 / (m * l**2)), [2.0, 1.25, 0.5, spring, 9.81],
    )

for amplitude in [1e-8, 1e-6, 1e-3, 1.0, 3.0, 3.14, 3.1415, 3.141592, 3.14159265, 3.1415926535]:
    point(
        "pendulum from the smallest swing to the top", "vibration/large-pendulum",
        'length = "{0} m"\namplitude = "{1} rad"\ngravity = "{2} m/s^2"',
        "period", lambda l, q, g: 4 * sqrt(l / g) * ellipk(sin(q / 2) ** 2), [1.5, amplitude, 9.81],
    )


def toggle(l1, l2, q):
    other = asin(l1 * sin(q) / l2)
    return l1 * (1 - cos(q)) + l2 * (1 - cos(other))


for angle in [0.5, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8, 1e-9]:
    point(
        "toggle near its straight line", "virtual-work/toggle-press",
        'fixed_link = "{0} m"\nram_link = "{1} m"\nangle = "{2} rad"\nsought.thrust.knee = "500 N"',
        "remaining_stroke", toggle, [0.25, 0.375, angle],
    )


def slider(r, l, q, w):
    return -r * w * sin(q) - r * r * w * sin(q) * cos(q) / sqrt(l * l - r * r * sin(q) ** 2)


for rod, angle in [(0.375, 1e-2), (0.375, 1e-4), (0.375, 1e-6), (0.375, 1e-9), (0.375, 3.141592), (0.375, 3.14159265358),
                   (0.25 * (1 + 1e-6), 1.5), (0.25 * (1 + 1e-9), 1.57), (0.25 * (1 + 1e-13), 1.5)]:
    point(
        "slider-crank at its dead centres, and with rod and crank alike", "virtual-work/slider-crank",
        'crank = "{0} m"\nrod = "{1} m"\nangle = "{2} rad"\nunknown.torque.force = "10 N"\nspeed = "{3} rad/s"',
        "slider_velocity", slider, [0.25, rod, angle, 20.0],
    )



def lower_node(m, j, front, rear, a, b):
    up, mixed, turning = front + rear, rear * b - front * a, front * a**2 + rear * b**2
    half = (up / m + turning / j) / 2
    square = half - sqrt((up / m - turning / j) ** 2 / 4 + mixed**2 / (m * j))
    return (turning - square * j) / mixed


for apart in [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, -1e-12]:
    point(
        "bar on springs that are nearly equal", "vibration/bar-on-two-springs",
        'body.mass.mass = "{0} kg"\ninertia.moment.moment = "{1} kg*m^2"\nfront = "{2} N/m"\nrear = "{3} N/m"\n'
        'front_distance = "{4} m"\nrear_distance = "{5} m"',
        "node[1]", lower_node, [10.0, 3.0, 500.0, 500.0 + apart, 1.0, 1.0],
    )

print("# Written by near_singular.py: answers near singular points to 50 digits, and their condition numbers.")
for family, analysis, inputs, answer, value, condition in points:
    print(f'\n[[point]]\nfamily = "{family}"\nanalysis = "{analysis}"\nanswer = "{answer}"')
    print(f'value = "{mp.nstr(value, 50, min_fixed=0, max_fixed=0)}"\ncondition = {mp.nstr(condition, 4, min_fixed=0, max_fixed=0)}')
    print(f"inputs = '''\n{inputs}\n'''")
