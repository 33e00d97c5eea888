"""Airfoil sections for the examples."""

import math


def naca_half(thickness, chord, points=24):
    """[(x, z), …] of the upper side of a symmetric four-digit NACA section, from the leading to the (closed) trailing edge.

    thickness -- over the chord; points -- number of intervals, denser towards the leading edge
    """
    half = []
    for i in range(points + 1):
        x = 1.0 - math.cos(0.5 * math.pi * i / points)
        y = 5.0 * thickness * (0.2969 * math.sqrt(x) - 0.1260 * x - 0.3516 * x**2 + 0.2843 * x**3 - 0.1036 * x**4)
        half.append((chord * x, chord * y))
    return half
