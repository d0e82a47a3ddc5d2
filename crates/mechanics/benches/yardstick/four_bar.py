# Directions, velocities, accelerations and torque of a four-bar linkage at a million angles, by formulas that numba
# compiles: the nanoseconds of an angle on one thread, then the mean torque and the mean of its square.
import math, time
import numba, numpy

FRAME, CRANK, COUPLER, ROCKER, GRAVITY, LOAD = 0.30, 0.10, 0.28, 0.20, 9.81, 5.0
M2, M3, M4 = 0.5, 1.0, 0.8


@numba.njit
def cycle(angles, speed, acceleration, out):
    i2, i3, i4 = M2 * CRANK * CRANK / 12, M3 * COUPLER * COUPLER / 12, M4 * ROCKER * ROCKER / 12
    square = speed * speed
    for n in range(angles.size):
        s, c = math.sin(angles[n]), math.cos(angles[n])
        x, y = FRAME - CRANK * c, -CRANK * s
        distance = x * x + y * y
        along = (COUPLER * COUPLER - ROCKER * ROCKER + distance) / (2 * distance)
        height = math.sqrt(COUPLER * COUPLER / distance - along * along)
        bx, by = along * x - height * y, along * y + height * x
        c3, s3, c4, s4 = bx / COUPLER, by / COUPLER, (bx - x) / ROCKER, (by - y) / ROCKER
        sine = s3 * c4 - c3 * s4
        h3, h4 = CRANK * (s4 * c - c4 * s) / (COUPLER * sine), CRANK * (s3 * c - c3 * s) / (ROCKER * sine)
        w3, w4 = h3 * speed, h4 * speed
        px = CRANK * (s * acceleration + c * square) + COUPLER * c3 * w3 * w3 - ROCKER * c4 * w4 * w4
        py = CRANK * (s * square - c * acceleration) + COUPLER * s3 * w3 * w3 - ROCKER * s4 * w4 * w4
        a3, a4 = -(px * c4 + py * s4) / (COUPLER * sine), -(px * c3 + py * s3) / (ROCKER * sine)
        half, other = 0.5 * COUPLER, 0.5 * ROCKER
        gx, gy = -CRANK * s - half * s3 * h3, CRANK * c + half * c3 * h3
        ax = -CRANK * (s * acceleration + c * square) - half * (s3 * a3 + c3 * w3 * w3)
        ay = CRANK * (c * acceleration - s * square) + half * (c3 * a3 - s3 * w3 * w3)
        out[0, n], out[1, n], out[2, n], out[3, n] = c3, s3, c4, s4
        out[4, n], out[5, n], out[6, n], out[7, n] = w3, w4, a3, a4
        out[8, n] = (
            (i2 + M2 * 0.25 * CRANK * CRANK) * acceleration
            + M2 * GRAVITY * 0.5 * CRANK * c
            + M3 * (ax * gx + (ay + GRAVITY) * gy)
            + i3 * a3 * h3
            + (i4 + M4 * other * other) * a4 * h4
            + M4 * GRAVITY * other * c4 * h4
            + LOAD * h4
        )


angles, out = numpy.linspace(0, 2 * math.pi, 1_000_000, endpoint=False), numpy.empty((9, 1_000_000))
times = []
for _ in range(10):
    start = time.perf_counter()
    cycle(angles, 30.0, 5.0, out)
    times.append(time.perf_counter() - start)
print(min(times) * 1e9 / angles.size)
print(out[8].mean())
print((out[8] ** 2).mean())
