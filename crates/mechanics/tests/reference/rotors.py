# Eigenvalues of random rotors in numbers of 40 digits: rotors.txt, against which tests/rotors.rs holds its own.
# Uniform Timoshenko and Euler-Bernoulli elements in closed form (Nelson 1980; Friswell et al., Dynamics of Rotating
# Machines, ch. 5), added up from the doubles as they are printed. NumPy gives first guesses only; each eigenvalue is then
# found by two-sided Rayleigh quotient iteration with banded elimination, until it does not change in 30 digits.
# Run as: python rotors.py > rotors.txt   (mpmath 1.4.1, NumPy 2.4.6)
import random

import gmpy2
import mpmath
import numpy
from mpmath import mp, mpc, mpf

mp.dps = 40
gmpy2.get_context().precision = mp.prec
ROTORS, MODES = 200, 4


def element(young, shear, density, diameter, length, timoshenko):
    poisson = young / (2 * shear) - 1
    area, moment = mp.pi * diameter**2 / 4, mp.pi * diameter**4 / 64
    kappa = 6 * (1 + poisson) / (7 + 6 * poisson)
    p = 12 * young * moment / (kappa * shear * area * length**2) if timoshenko else mpf(0)
    l = length
    f = young * moment / ((1 + p) * l**3)
    k = [[12, 6 * l, -12, 6 * l], [6 * l, (4 + p) * l**2, -6 * l, (2 - p) * l**2],
         [-12, -6 * l, 12, -6 * l], [6 * l, (2 - p) * l**2, -6 * l, (4 + p) * l**2]]
    m1, m2, m3 = 312 + 588 * p + 280 * p**2, (44 + 77 * p + 35 * p**2) * l, 108 + 252 * p + 140 * p**2
    m4, m5, m6 = -(26 + 63 * p + 35 * p**2) * l, (8 + 14 * p + 7 * p**2) * l**2, -(6 + 14 * p + 7 * p**2) * l**2
    m = [[m1, m2, m3, m4], [m2, m5, -m4, m6], [m3, -m4, m1, -m2], [m4, m6, -m2, m5]]
    m7, m8, m9, m10 = 36, (3 - 15 * p) * l, (4 + 5 * p + 10 * p**2) * l**2, (-1 - 5 * p + 5 * p**2) * l**2
    r = [[m7, m8, -m7, m8], [m8, m9, -m8, m10], [-m7, -m8, m7, -m8], [m8, m10, -m8, m9]]
    a, b = density * area * l / (840 * (1 + p)**2), density * moment / (30 * l * (1 + p)**2)
    stiffness = [[f * x for x in row] for row in k]
    rotary = [[b * x for x in row] for row in r]
    mass = [[a * x + y for x, y in zip(one, two)] for one, two in zip(m, rotary)]
    return mass, [[2 * x for x in row] for row in rotary], stiffness


# Four freedoms a node: x, its slope, y, its slope.
def assembled(rotor):
    n, (length, diameter, young, shear, density), timoshenko, disc, bearings, speed = rotor
    size = 4 * (n + 1)
    mass, damping, stiffness = ([{} for _ in range(size)] for _ in range(3))

    def add(matrix, i, j, value):
        matrix[i][j] = matrix[i].get(j, mpf(0)) + value

    m, g, k = element(*map(mpf, (young, shear, density, diameter)), mpf(length) / n, timoshenko)
    for e in range(n):
        place = [4 * e, 4 * e + 1, 4 * e + 4, 4 * e + 5]
        for i in range(4):
            for j in range(4):
                for plane in (0, 2):
                    add(mass, place[i] + plane, place[j] + plane, m[i][j])
                    add(stiffness, place[i] + plane, place[j] + plane, k[i][j])
                add(damping, place[i], place[j] + 2, speed * g[i][j])
                add(damping, place[i] + 2, place[j], -speed * g[i][j])
    node, heavy, diametral, polar = disc
    for plane in (0, 2):
        add(mass, 4 * node + plane, 4 * node + plane, mpf(heavy))
        add(mass, 4 * node + plane + 1, 4 * node + plane + 1, mpf(diametral))
    add(damping, 4 * node + 1, 4 * node + 3, mpf(speed) * polar)
    add(damping, 4 * node + 3, 4 * node + 1, -mpf(speed) * polar)
    for node, kxx, kxy, kyx, kyy, c in bearings:
        at = 4 * node
        for i, j, value in ((0, 0, kxx), (0, 2, kxy), (2, 0, kyx), (2, 2, kyy)):
            add(stiffness, at + i, at + j, mpf(value))
        for i in (0, 2):
            add(damping, at + i, at + i, mpf(c))
    return mass, damping, stiffness


# Whirls with the spin, y = -i x, or against it, on their own: the same matrices of one plane.
def one_plane(matrices, sign):
    size = len(matrices[0])
    keep = [i for i in range(size) if i % 4 < 2]
    at = {i: n for n, i in enumerate(keep)}
    return tuple([{at[j] if j in at else at[j - 2]: value if j in at else value * mpc(0, -sign)
                   for j, value in matrices[which][i].items() if (j in at) == (which != 1)} for i in keep]
                 for which in range(3))


def guesses(matrices):
    dense = [numpy.zeros((len(m), len(m)), complex) for m in matrices]
    for into, matrix in zip(dense, matrices):
        for i, row in enumerate(matrix):
            for j, value in row.items():
                into[i, j] = complex(value)
    mass, damping, stiffness = dense
    scale = 1 / numpy.sqrt(abs(numpy.diag(mass)))
    mass, damping, stiffness = (scale[:, None] * m * scale for m in dense)
    size = len(mass)
    state = numpy.zeros((2 * size, 2 * size), complex)
    state[:size, size:] = numpy.eye(size)
    state[size:, :size] = -numpy.linalg.solve(mass, stiffness)
    state[size:, size:] = -numpy.linalg.solve(mass, damping)
    return numpy.linalg.eigvals(state)


def exact(number):
    return gmpy2.mpc(gmpy2.mpfr(mpmath.nstr(number.real, 45)), gmpy2.mpfr(mpmath.nstr(number.imag, 45)))


def times(matrix, x):
    return [sum((value * x[j] for j, value in row.items()), gmpy2.mpc(0)) for row in matrix]


def solve(rows, right):
    a, x, size = [dict(row) for row in rows], list(right), len(rows)
    band = max(abs(i - j) for i, row in enumerate(rows) for j in row)
    for p in range(size):
        best = max(range(p, min(p + band + 1, size)), key=lambda i: abs(a[i].get(p, 0)))
        a[p], a[best], x[p], x[best] = a[best], a[p], x[best], x[p]
        for i in range(p + 1, min(p + band + 1, size)):
            if p in a[i]:
                factor = a[i].pop(p) / a[p][p]
                for j, value in a[p].items():
                    if j > p:
                        a[i][j] = a[i].get(j, 0) - factor * value
                x[i] -= factor * x[p]
    for p in reversed(range(size)):
        x[p] = (x[p] - sum(value * x[j] for j, value in a[p].items() if j > p)) / a[p][p]
    return x


def dynamic(matrices, value):
    rows = []
    for m, c, k in zip(*matrices):
        rows.append({j: value**2 * m.get(j, 0) + value * c.get(j, 0) + k.get(j, 0) for j in {*m, *c, *k}})
    return rows


def transposed(matrix):
    rows = [{} for _ in matrix]
    for i, row in enumerate(matrix):
        for j, value in row.items():
            rows[j][i] = value
    return rows


def refined(matrices, guess):
    value, size = gmpy2.mpc(complex(guess)), len(matrices[0])
    right = [gmpy2.mpc(1 + (7 * i) % 5) for i in range(size)]
    left = [gmpy2.mpc(1 + (3 * i) % 7) for i in range(size)]
    slope = lambda v: [2 * value * a + b for a, b in zip(times(matrices[0], v), times(matrices[1], v))]
    for step in range(40):
        near = dynamic(matrices, value * (1 + gmpy2.mpfr(10) ** (-12 if step < 3 else -25)))
        right, left = solve(near, slope(right)), solve(transposed(near), left)
        for v in (right, left):
            largest = max(v, key=abs)
            v[:] = [x / largest for x in v]
        dot = lambda a, b: sum(x * y for x, y in zip(a, b))
        change = dot(left, times(dynamic(matrices, value), right)) / dot(left, slope(right))
        value -= change
        if step > 3 and abs(change) < gmpy2.mpfr(10) ** -30 * abs(value):
            return mpc(mpf(str(value.real)), mpf(str(value.imag)))
    raise ArithmeticError("no eigenvalue")


def draw(random, kind):
    r = lambda a, b: float(f"{random.uniform(a, b):.6g}")
    log = lambda a, b: float(f"{10 ** random.uniform(mpmath.log10(a), mpmath.log10(b)):.6g}")
    n = random.randint(4, 40)
    shaft = (r(0.5, 2), r(0.02, 0.15), r(190e9, 215e9), r(75e9, 83e9), r(7600, 8000))
    heavy, radius = log(1, 300), r(0.08, 0.4)
    disc = (random.randint(1, n - 1), heavy, float(f"{heavy * radius**2 / 3.4:.6g}"), float(f"{heavy * radius**2 / 2:.6g}"))
    bearings = []
    for node in (0, n):
        k = log(1e4, 1e8)
        if kind == 0:
            bearings.append((node, k, 0.0, 0.0, k, 0.0))
        else:
            q, along = k * r(0.02, 0.3), k * r(0.5, 0.9)
            q, along = float(f"{q:.6g}"), float(f"{along:.6g}")
            bearings.append((node, k, q, -q, along, float(f"{k * r(1e-5, 2e-4):.6g}")))
    return n, shaft, random.random() < 0.5, disc, bearings, r(10, 1500)


random = random.Random(20)
print(f"# Written by rotors.py (mpmath 1.4.1 at 40 digits): {ROTORS} rotors, two lines each. First the elements; length, diameter,")
print("# E, G, density of the shaft; 1 for Timoshenko; node, mass, diametral and polar inertia of the disc; for either bearing")
print("# node, kxx, kxy, kyx, kyy, cxx = cyy; the speed. Then real and imaginary parts of the lowest four eigenvalues.")
for number in range(ROTORS):
    rotor = draw(random, number % 2)
    n, shaft, timoshenko, disc, bearings, speed = rotor
    whole = assembled(rotor)
    parts = [one_plane(whole, sign) for sign in (1, -1)] if number % 2 == 0 else [whole]
    found = []
    for part in parts:
        swings = sorted((v for v in guesses(part) if v.imag > 0.3 * abs(v)), key=lambda v: v.imag)[:MODES]
        numbers = tuple([{j: exact(value) for j, value in row.items()} for row in matrix] for matrix in part)
        values = [refined(numbers, v) for v in swings]
        assert all(abs(a - b) > mpf(10) ** -15 * abs(a) for i, a in enumerate(values) for b in values[:i]), number
        found += values
    found.sort(key=lambda v: v.imag)
    print(n, *shaft, int(timoshenko), *disc, *(x for b in bearings for x in b), speed)
    print(*(mpmath.nstr(x, 17) for v in found[:MODES] for x in (v.real if number % 2 else mpf(0), v.imag)))
