"""Models whose materials carry pictures, glass and vertex colours."""

import zlib
from math import dist

from lib.assets.curves import bezier_points
from lib.assets.glb_writer import GlbWriter
from lib.assets.solids import make_ball, revolve
from lib.assets.surface import Geometry, Surface
from lib.assets.vectors import quaternion
from lib.png import GREY_ALPHA, RGB, png_file


def stored_png(size, color_type, rows):
    """PNG file of rows of bytes; stored, not packed, so that every zlib writes the same."""
    return png_file(size, color_type, zlib.compress(b"".join(b"\0" + row for row in rows), 0))


def grey_alpha_png(rows):
    """Rows of alpha values over white."""
    pixels = [b"".join(bytes((255, value)) for value in row) for row in rows]
    return stored_png((len(rows[0]), len(rows)), GREY_ALPHA, pixels)


def rgb_png(rows):
    """Rows of (red, green, blue)."""
    return stored_png((len(rows[0]), len(rows)), RGB, [b"".join(map(bytes, row)) for row in rows])


def leaf_alpha(size):
    """A leaf between two arcs, with a round hole, drawn upright; its rim takes a texel to fade."""

    def depth(x, y):
        """How far inside a point lies, texels."""
        rim = 0.76 - max(dist((x, y), (-0.1, 0.5)), dist((x, y), (1.1, 0.5)))
        return size * min(rim, dist((x, y), (0.5, 0.4)) - 0.07)

    steps = [(i + 0.5) / size for i in range(size)]
    return [[round(255 * max(0.0, min(1.0, 0.5 + depth(x, y)))) for x in steps] for y in steps]


def open_box(size):
    """A cup: five sides of a cube, seen from outside."""
    h = size / 2
    corners = [(x, y, z) for z in (-h, h) for y in (-h, h) for x in (-h, h)]
    sides = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4)]
    surface = Surface()
    for side in sides:
        surface.quad(*(corners[i] for i in side))
    return surface.unshaded()


def upright_square(size):
    h = size / 2
    positions = [(-h, -h, 0), (h, -h, 0), (h, h, 0), (-h, h, 0)]
    uvs = [(0, 1), (1, 1), (1, 0), (0, 0)]
    return Geometry(positions, [0, 1, 2, 0, 2, 3], [(0, 0, 1)] * 4, uvs)


def make_lantern():
    """What materials, animations and scenes do to a drawing."""
    glb = GlbWriter()
    tin = glb.material("tin", (0.5, 0.5, 0.5))
    glass = glb.material("glass", (0.7, 0.8, 0.9), double_sided=True)
    glb.document["materials"][glass]["alphaMode"] = "BLEND"
    leaf = glb.picture_material("leaf", grey_alpha_png(leaf_alpha(64)), "MASK")
    cup = glb.node("cup", mesh=glb.mesh("cup", open_box(0.8), tin))
    pane_mesh = glb.mesh("pane", upright_square(0.7), glass)
    pane = glb.node("pane", mesh=pane_mesh, translation=[0, 0.1, 0.6])
    glb.node("lantern", children=[cup, pane])
    square = glb.mesh("leaf", upright_square(1), leaf)
    one = glb.node("leaf", mesh=square, translation=[0.95, 0.1, 0])
    glb.rotation_animation("swing", 2, [(0, (0, 0, 0, 1)), (1, quaternion((0, 0, 1), 40))])
    return glb.to_bytes({"name": "leaf alone", "nodes": [one]})


def glaze_pattern(size):
    """A ring around a dot between two bands, which goes on where copies meet; rims take two texels to fade."""

    def blend(one, other, share):
        return tuple(round(a + (b - a) * max(0.0, min(1.0, share))) for a, b in zip(one, other))

    def color(x, y):
        middle = dist((x, y), (0.5, 0.5))
        inked = max(0.07 - middle, 0.04 - abs(middle - 0.2), abs(y - 0.5) - 0.42)
        return blend((236, 224, 196), (30, 66, 110), 0.5 + inked * size / 2)

    steps = [(i + 0.5) / size for i in range(size)]
    return [[color(x, y) for x in steps] for y in steps]


def make_vase():
    """A picture laid three times around a vase, and a ball of vertex colours."""
    glb = GlbWriter()
    glaze = glb.picture_material("glaze", rgb_png(glaze_pattern(96)), "OPAQUE")
    foot = [(0, 0.0), (0.3, 0.0), (0.34, 0.05)]
    belly = bezier_points([(0.34, 0.05), (0.86, 0.5), (0.42, 0.9), (0.34, 1.3)], 20)
    vase = revolve(foot + belly[1:] + [(0.38, 1.36), (0.34, 1.36), (0.3, 1.28), (0, 1.1)], 48)
    vase = vase.shaded(crease=48, with_uvs=True)
    vase.uvs = [(3 * u, 2.2 * v) for u, v in vase.uvs]
    glb.node("vase", mesh=glb.mesh("vase", vase, glaze))
    ball = make_ball(0.26, 40, 28).shaded(crease=48)
    ball.colors = [
        (0.9, 0.25, 0.1) if y > 0.1 else (0.95, 0.85, 0.5) if y > -0.08 else (0.1, 0.3, 0.6)
        for _, y, _ in ball.positions
    ]
    painted = glb.mesh("ball", ball, glb.material("paint", (1, 1, 1)))
    glb.node("ball", mesh=painted, translation=[0.72, 0.26, 0.5])
    return glb.to_bytes()
