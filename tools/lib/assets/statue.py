"""A draped figure."""

from math import cos, dist, pi, sin

from lib.assets.glb_writer import single_mesh
from lib.assets.surface import Surface
from lib.assets.vectors import add, scale, smoothstep, unit

# From the ground up: height, half width, half depth, and the middle's place to the side and towards the front.
STATUE_SECTIONS = (
    (0.00, 0.300, 0.250, 0.00, 0.00),
    (0.12, 0.285, 0.240, 0.00, 0.00),
    (0.30, 0.255, 0.222, 0.01, 0.01),
    (0.48, 0.240, 0.212, 0.02, 0.02),
    (0.64, 0.236, 0.200, 0.03, 0.02),
    (0.78, 0.238, 0.182, 0.04, 0.01),
    (0.90, 0.232, 0.168, 0.05, 0.00),
    (1.00, 0.205, 0.148, 0.045, 0.00),
    (1.09, 0.172, 0.124, 0.03, 0.00),
    (1.17, 0.158, 0.114, 0.01, 0.00),
    (1.25, 0.168, 0.122, -0.01, 0.00),
    (1.33, 0.184, 0.132, -0.02, 0.00),
    (1.41, 0.200, 0.132, -0.025, 0.00),
    (1.48, 0.214, 0.118, -0.025, -0.01),
    (1.54, 0.190, 0.098, -0.02, -0.02),
    (1.58, 0.112, 0.080, -0.015, -0.02),
    (1.62, 0.064, 0.064, -0.01, -0.015),
    (1.67, 0.058, 0.060, -0.005, -0.005),
    (1.71, 0.066, 0.078, 0.00, 0.005),
    (1.75, 0.078, 0.096, 0.005, 0.01),
    (1.80, 0.086, 0.106, 0.01, 0.005),
    (1.85, 0.088, 0.112, 0.01, -0.005),
    (1.90, 0.078, 0.104, 0.01, -0.015),
    (1.94, 0.052, 0.072, 0.01, -0.02),
    (1.96, 0.020, 0.028, 0.01, -0.02),
)
# Swellings: where the middle is (side, height, towards the front), how far they reach and rise.
STATUE_SWELLINGS = (
    ((0.065, 1.345, 0.14), 0.062, 0.062),
    ((-0.105, 1.36, 0.14), 0.062, 0.062),
    ((0.115, 0.90, -0.16), 0.09, 0.030),
    ((-0.035, 0.88, -0.16), 0.09, 0.026),
    ((0.03, 1.02, 0.15), 0.09, 0.012),
    ((0.21, 1.47, 0.0), 0.055, 0.045),
    ((-0.25, 1.49, 0.0), 0.055, 0.040),
    ((0.01, 1.77, 0.12), 0.026, 0.034),
    ((0.01, 1.70, 0.09), 0.026, 0.016),
    ((0.01, 1.85, -0.14), 0.050, 0.060),
    ((0.13, 0.60, 0.19), 0.12, 0.070),
)


def statue_point(section, around):
    """Point of a section, 0 at the front and a quarter turn at the side."""
    height, half_width, half_depth, side, front = section
    drape = smoothstep((0.95 - height) / 0.5)
    folds = 1 + drape * (0.07 * cos(7 * around + 4 * height) + 0.05 * cos(3 * around - 7 * height))
    # Hips and shoulders lean against each other.
    lean = 0.16 * smoothstep((height - 0.5) / 0.4) * smoothstep((1.25 - height) / 0.25)
    lean -= 0.14 * smoothstep((height - 1.2) / 0.2) * smoothstep((1.62 - height) / 0.1)
    x, z = half_width * sin(around) * folds, half_depth * cos(around) * folds
    point = (side + x, height + lean * x, front + z)
    for middle, reach, rise in STATUE_SWELLINGS:
        swell = rise * 2.7 ** -((dist(point, middle) / reach) ** 2)
        point = add(point, scale(unit((x, 0, z)), swell))
    return point


def make_statue():
    """Coarse draped figure to be subdivided, for the hatch marks of the paper's Figure 2."""
    segments = 28
    statue = Surface()
    statue.loft(
        [[(0.0, 0.0, 0.0)]]
        + [
            [statue_point(section, 2 * pi * j / segments) for j in range(segments)]
            for section in STATUE_SECTIONS
        ]
        + [[(0.01, 1.965, -0.02)]]
    )
    return single_mesh("statue", statue.shaded(crease=180), (0.9, 0.88, 0.84))
