# The rotor of thirty elements in ROSS: a Campbell diagram at fifty speeds and its unbalance response at 501, with a new
# rotor each time, since a rotor keeps what it was asked: the milliseconds of both.
# ROSS 2.3 wants plotly below 6.
import time
import numpy, ross

ELEMENTS, LENGTH = 30, 1.5


def rotor():
    steel = ross.Material("steel", rho=7810, E=211e9, G_s=81.2e9)
    shaft = [ross.ShaftElement(LENGTH / ELEMENTS, 0.0, 0.05, material=steel) for _ in range(ELEMENTS)]
    disc = dict(material=steel, width=0.07, i_d=0.05, o_d=0.28)
    discs = [ross.DiskElement.from_geometry(n=node * ELEMENTS // 3, **disc) for node in (1, 2)]
    bearings = [ross.BearingElement(n=node, kxx=1e6, kyy=0.8e6, cxx=200, cyy=150) for node in (0, ELEMENTS)]
    return ross.Rotor(shaft, discs, bearings)


def shortest(work):
    times = []
    for _ in range(3):
        of = rotor()
        start = time.perf_counter()
        work(of)
        times.append(time.perf_counter() - start)
    return min(times) * 1e3


campbell = shortest(lambda of: of.run_campbell(numpy.linspace(0, 1000, 50)))
speeds = numpy.linspace(0, 1000, 501)
response = shortest(lambda of: of.run_unbalance_response([ELEMENTS // 3], [0.001], [0.0], frequency=speeds))
print(campbell + response)
