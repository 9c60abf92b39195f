"""Vectors in space, as tuples."""

from math import acos, cos, radians, sin, sqrt


def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scale(a, s):
    return (a[0] * s, a[1] * s, a[2] * s)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    return scale(a, 1 / sqrt(dot(a, a)))


def angle_between(a, b):
    return acos(max(-1.0, min(1.0, dot(unit(a), unit(b)))))


def rotate(vector, axis, angle):
    """Rodrigues' rotation of a vector about a unit axis."""
    along = scale(axis, dot(axis, vector) * (1 - cos(angle)))
    return add(add(scale(vector, cos(angle)), scale(cross(axis, vector), sin(angle))), along)


def rounded(row):
    """Round to a micrometre; adding zero turns -0.0 into 0.0."""
    return tuple(round(value, 6) + 0.0 for value in row)


def quaternion(axis, degrees):
    half = radians(degrees) / 2
    return rounded((*scale(unit(axis), sin(half)), cos(half)))


def smoothstep(t):
    t = max(0.0, min(1.0, t))
    return t * t * (3 - 2 * t)
