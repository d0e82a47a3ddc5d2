# A million samples of a rigid rotor with two eccentric masses, balanced in two planes, with NumPy: draws, formulas, and the
# mean, the standard deviation and percentiles of the correction in plane A.
import time
import numpy as np

n = 1_000_000
A, B = 0.1, 0.9


def whole():
    r = np.random.default_rng(1)
    m, e = (r.normal(2, 0.02, n), r.normal(3, 0.03, n)), (r.normal(0.1, 1e-3, n), r.normal(0.15, 1e-3, n))
    t, z = (r.normal(0.5, 0.01, n), r.normal(2.2, 0.01, n)), (r.normal(0.3, 2e-3, n), r.normal(0.7, 2e-3, n))
    x = sum(m * e * np.cos(t) * (B - z) for m, e, t, z in zip(m, e, t, z)) / (A - B)
    y = sum(m * e * np.sin(t) * (B - z) for m, e, t, z in zip(m, e, t, z)) / (A - B)
    u, angle = np.hypot(x, y), np.arctan2(y, x) % (2 * np.pi)
    return u.mean(), u.std(), np.percentile(u, [2.5, 50, 97.5]), angle.mean(), np.percentile(angle, [2.5, 50, 97.5])


times = []
for _ in range(5):
    start = time.perf_counter()
    mean, deviation, *_ = whole()
    times.append(time.perf_counter() - start)
print(sorted(times)[2] * 1e3)
print(mean)
print(deviation)
