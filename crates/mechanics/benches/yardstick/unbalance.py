# A million samples of the amplitude of a rotating unbalance with NumPy: draws, formula, mean, deviation, percentiles.
import time
import numpy as np

n = 1_000_000


def whole():
    r = np.random.default_rng(1)
    m, k, c = r.normal(100, 1, n), r.normal(4e5, 8e3, n), r.normal(600, 60, n)
    me, w = r.normal(0.05, 0.005, n), r.normal(60, 0.5, n)
    x = me * w * w / np.sqrt((k - m * w * w) ** 2 + (c * w) ** 2)
    return x.mean(), x.std(), np.percentile(x, [2.5, 50, 97.5])


times = []
for _ in range(5):
    start = time.perf_counter()
    mean, deviation, _ = whole()
    times.append(time.perf_counter() - start)
print(sorted(times)[2] * 1e3)
print(mean)
print(deviation)
