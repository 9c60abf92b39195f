"""Solids and sheets that several models are made of."""

from math import cos, pi, sin

from lib.assets.curves import arc, bezier, circle
from lib.assets.surface import Surface
from lib.assets.vectors import add, cross, scale, unit


def lift(loop, z):
    return [(x, y, z) for x, y in loop]


def prism(outline, back, front):
    """Solid between two planes of constant z."""
    solid = Surface()
    solid.loft([lift(outline, back), lift(outline, front)])
    solid.polygon(outline, [], lambda x, y: (x, y, back), flip=True)
    solid.polygon(outline, [], lambda x, y: (x, y, front))
    return solid


def box(size_x, size_y, size_z):
    """Axis-aligned box centred at the origin."""
    x, y, z = size_x / 2, size_y / 2, size_z / 2
    return prism([(-x, -y), (x, -y), (x, y), (-x, y)], -z, z)


def revolve(profile, segments):
    """Surface of revolution about Y of (radius, height) points that run upwards."""
    surface = Surface()
    angles = [2 * pi * j / segments for j in range(segments)]
    rings = [
        [(r * sin(a), y, r * cos(a)) for a in angles] if r > 0 else [(0, y, 0)] for r, y in profile
    ]
    surface.loft(rings)
    return surface


def planar_tube(curve, stations, segments, width=1.0):
    """Tube along a Bezier curve in the XY plane, closed by a pole at either end.

    Stations are (curve parameter, radius) pairs; width stretches the section along Z.
    """
    rings = []
    for t, radius in stations:
        here, ahead = bezier(curve, t - 1e-3), bezier(curve, t + 1e-3)
        tangent = unit((ahead[0] - here[0], ahead[1] - here[1], 0))
        side = cross(tangent, (0, 0, 1))
        centre = (*bezier(curve, t), 0)
        ring = [
            add(centre, add((0, 0, width * radius * x), scale(side, radius * y)))
            for x, y in circle(1, segments)
        ]
        rings.append(ring if radius > 0 else [centre])
    tube = Surface()
    tube.loft(rings)
    return tube


def add_grid(surface, rows):
    """Fill a grid of points; it faces up where columns run to +X and rows to -Z."""
    for lower, upper in zip(rows, rows[1:]):
        for j in range(len(lower) - 1):
            surface.quad(lower[j], lower[j + 1], upper[j + 1], upper[j])


def make_ball(radius, segments, bands):
    profile = arc((0, 0), radius, -90, 90, bands)
    return revolve([(0, -radius), *profile[1:-1], (0, radius)], segments)
