# Position, velocity, acceleration and torque of a slider-crank at a million angles, by formulas that numba compiles:
# the nanoseconds of an angle on one thread, then the mean torque and the mean of its square.
import math, time
import numba, numpy

R, L, GRAVITY, FORCE = 0.05, 0.2, 9.81, 200.0


@numba.njit
def cycle(angles, speed, acceleration, out):
    for n in range(angles.size):
        s, c = math.sin(angles[n]), math.cos(angles[n])
        rod_s = -R / L * s
        rod_c = math.sqrt(1 - rod_s * rod_s)
        ratio = -R * c / (L * rod_c)
        turn = ratio * speed
        along, across = s * acceleration + c * speed * speed, c * acceleration - s * speed * speed
        rod_a = (-R * across + L * rod_s * turn * turn) / (L * rod_c)
        slope = -R * s - L * rod_s * ratio
        slide = -R * along - L * (rod_s * rod_a + rod_c * turn * turn)
        gx, gy = -R * s - 0.07 * rod_s * ratio, R * c + 0.07 * rod_c * ratio
        ax = -R * along - 0.07 * (rod_s * rod_a + rod_c * turn * turn)
        ay = R * across + 0.07 * (rod_c * rod_a - rod_s * turn * turn)
        out[0, n], out[1, n], out[2, n] = R * c + L * rod_c, slope * speed, slide
        out[3, n], out[4, n] = turn, rod_a
        out[5, n] = (
            (8e-4 + 1.2 * 0.02 * 0.02) * acceleration
            + 1.2 * GRAVITY * 0.02 * c
            + 0.8 * (ax * gx + (ay + GRAVITY) * gy)
            + 3.5e-3 * rod_a * ratio
            + 0.5 * slide * slope
            - FORCE * slope
        )


angles, out = numpy.linspace(0, 2 * math.pi, 1_000_000, endpoint=False), numpy.empty((6, 1_000_000))
times = []
for _ in range(10):
    start = time.perf_counter()
    cycle(angles, 30.0, 5.0, out)
    times.append(time.perf_counter() - start)
print(min(times) * 1e9 / angles.size)
print(out[5].mean())
print((out[5] ** 2).mean())
