"""A wavy sheet and a folded one."""

from math import cos, pi, radians, sin

from lib.assets.glb_writer import single_mesh
from lib.assets.solids import add_grid
from lib.assets.surface import Surface
from lib.assets.vectors import add, rotate, scale, sub, unit


def wave_profile(swing, segments, substeps=16):
    """Curve of unit length whose slope swings to either side, centred, as (run, rise) points."""
    steps = segments * substeps
    points = [(0.0, 0.0)]
    for i in range(steps):
        slope = swing * cos(2 * pi * (i + 0.5) / steps)
        run, rise = points[-1]
        points.append((run + cos(slope) / steps, rise + sin(slope) / steps))
    middle = scale((*points[-1], 0), 0.5)
    return [(run - middle[0], rise - middle[1]) for run, rise in points[::substeps]]


def make_sheet():
    rows, columns, length, depth = 28, 56, 3.6, 1.8
    grid = []
    for i in range(rows + 1):
        t = i / rows
        profile = wave_profile(radians(62 + 48 * t), columns)
        grid.append([(length * x, length * y, depth * (0.5 - t)) for x, y in profile])
    sheet = Surface()
    add_grid(sheet, grid)
    return single_mesh("sheet", sheet.shaded(crease=180), (0.45, 0.62, 0.48), double_sided=True)


def make_folded_paper():
    """Sheet folded over an oblique line; the flap stands off the layer beneath like a wedge."""
    opening = radians(8)
    front, back = (0.15, 0, 0.7), (0.55, 0, -0.7)
    axis = unit(sub(back, front))

    def fold(corner):
        return add(front, rotate(sub(corner, front), axis, opening - pi))

    paper = Surface()
    paper.quad((-1.2, 0, 0.7), front, back, (-1.2, 0, -0.7))
    paper.quad(front, fold((1.0, 0, 0.7)), fold((1.0, 0, -0.7)), back)
    return single_mesh("folded_paper", paper.shaded(), (0.93, 0.91, 0.84), double_sided=True)
