#!/usr/bin/env python3
"""Makes the numbers that stand in the stability tests, with mpmath.

Run by hand; needs python3-mpmath. Inputs are taken as the doubles they are,
directions as exactly unit.
"""

from mpmath import asin, mp, mpf, sqrt

mp.prec = 400
ULP = mpf(2) ** -52


def sphere(center, radius, o, d):
    """Both distances from o along d, unit or not, to the sphere."""
    d = [mpf(x) for x in d]
    length = sqrt(sum(x * x for x in d))
    f = [mpf(a) - mpf(b) for a, b in zip(o, center)]
    b = -sum(x * y / length for x, y in zip(f, d))
    s = sqrt(b * b - sum(x * x for x in f) + mpf(radius) ** 2)
    return b - s, b + s


def show(name, value):
    print(f'{name:32} {mp.nstr(value, 17)}')


Z = (0, 0, 1)
show('S01', sphere((0, 0, 1e8), 1, (0, 0, 0), Z)[0])
show('S02', sphere((.5, 0, 1e8), 1, (0, 0, 0), Z)[0])
show('S03', sphere((.5, 0, 1e12), 1, (0, 0, 0), Z)[0])
show('S02, S03 N.z', -sqrt(mpf(3)) / 2)
show('S05', sphere((5e-10, 0, 1), 1e-9, (0, 0, 0), Z)[0])
show('S06', sphere((0, -1e9, 0), 1e9, (0, 1, 0), (0, -1, 0))[0])
show('S07', sphere((0, -1e9, 0), 1e9, (0, 1, 0), (1, -mpf('1e-3'), 0))[0])
show('S08', sphere((0, -1e9, 0), 1e9, (0, 1, 0), (1, -mpf('6e-5'), 0))[0])
show('S09', sphere((0, -1e12, 0), 1e12, (0, 1, 0), (1, -mpf('1e-3'), 0))[0])
show('S12', sphere((0, 0, 0), 1, (0, 1 - ULP / 2, -5), Z)[0])
show('S16', sphere((0, 0, 0), 1, (1, 0, 0), (-1, mpf('.3'), mpf('.1')))[1])
show('S17', sphere((0, 0, 0), 1, (1 - 1e-12, 0, 0), (1, 0, 0))[1])

# V05: a slab of ior 1.5, 1 thick, at 60 degrees
SINE, COSINE = sqrt(mpf(3)) / 2, mpf(1) / 2
INSIDE = sqrt(1 - (SINE / mpf(1.5)) ** 2)
show('V05 shift', SINE * (1 - COSINE / (mpf(1.5) * INSIDE)))

# V07: n r sin is the same along a ray through concentric spheres
H, WATER = mpf('.3'), mpf('1.33')
TURN = 2 * (asin(H) - asin(H / mpf(1.5)) + asin(H / (mpf(1.5) * mpf('.8')))
            - asin(H / (WATER * mpf('.8'))))
show('V07 x', -mp.sin(TURN))
show('V07 z', mp.cos(TURN))

show('R01 critical cosine', sqrt(1 - 1 / mpf(1.5) ** 2))

# R11: Fresnel at 60 degrees into ior 1.5
R_S = (COSINE - mpf(1.5) * INSIDE) / (COSINE + mpf(1.5) * INSIDE)
R_P = (mpf(1.5) * COSINE - INSIDE) / (mpf(1.5) * COSINE + INSIDE)
show('R11', (R_S ** 2 + R_P ** 2) / 2)
