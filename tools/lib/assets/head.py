"""A head of soft bumps and hollows: smooth all over, with folds for lines of form to find."""

from math import cos, exp, pi, sin

from lib.assets.glb_writer import single_mesh
from lib.assets.surface import Surface

# Height, centre and widths of bumps, as seen from the front of a ball of radius 1; the left half mirrors the right.
FEATURES = [
    (0.11, (0.30, 0.28), (0.24, 0.09)),  # brow
    (-0.14, (0.32, 0.09), (0.17, 0.12)),  # eye socket
    (0.12, (0.32, 0.07), (0.11, 0.08)),  # eye
    (0.13, (0.00, 0.06), (0.10, 0.22)),  # nose
    (0.19, (0.00, -0.14), (0.12, 0.11)),
    (0.06, (0.13, -0.19), (0.07, 0.06)),  # nostril
    (0.08, (0.48, -0.16), (0.20, 0.17)),  # cheek
    (-0.08, (0.33, -0.36), (0.12, 0.18)),
    (0.10, (0.00, -0.40), (0.22, 0.075)),  # lips
    (-0.07, (0.00, -0.47), (0.26, 0.04)),
    (0.10, (0.00, -0.54), (0.18, 0.075)),
    (-0.05, (0.00, -0.66), (0.20, 0.06)),
    (0.15, (0.00, -0.80), (0.22, 0.15)),  # chin
]


def features(x, y):
    height = 0.0
    for bump, (centre, level), (width, breadth) in FEATURES:
        for middle in {centre, -centre}:
            height += bump * exp(-(((x - middle) / width) ** 2) - ((y - level) / breadth) ** 2)
    return height


def make_head():
    """Rings around a displaced ball, closer together on the face."""
    around, bands = 96, 80

    def place(latitude, longitude):
        x, y, z = cos(latitude) * sin(longitude), sin(latitude), cos(latitude) * cos(longitude)
        front = max(0.0, z) ** 0.5
        radius = 1 + front * features(x, y)
        return (0.78 * radius * x, 1.08 * radius * y, 0.92 * radius * z)

    rings = []
    for k in range(bands + 1):
        latitude = pi * (k / bands - 0.5) - 0.25 * sin(2 * pi * k / bands)
        count = around if 0 < k < bands else 1
        rings.append([place(latitude, 2 * pi * j / around - 0.5 * sin(2 * pi * j / around)) for j in range(count)])
    head = Surface()
    head.loft(rings)
    return single_mesh("head", head.shaded(crease=180), (0.86, 0.66, 0.54))
