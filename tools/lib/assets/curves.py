"""Points along curves."""

from math import cos, radians, sin


def bezier(control, t):
    """Point at t on the cubic Bezier curve of four control points."""
    s = 1 - t
    weights = (s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t)
    return tuple(sum(w * p[k] for w, p in zip(weights, control)) for k in range(len(control[0])))


def bezier_points(control, segments):
    return [bezier(control, i / segments) for i in range(segments + 1)]


def arc(centre, radius, start, stop, segments):
    """Points of a circular arc between two angles in degrees, both ends included."""
    steps = [radians(start + (stop - start) * i / segments) for i in range(segments + 1)]
    return [(centre[0] + radius * cos(a), centre[1] + radius * sin(a)) for a in steps]


def circle(radius, segments, centre=(0, 0)):
    return arc(centre, radius, 0, 360, segments)[:-1]
