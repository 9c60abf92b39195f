"""A plane seen at a flat angle, with solids on it."""

from math import radians, tan

from lib.assets.glb_writer import GlbWriter
from lib.assets.solids import add_grid, box, make_ball, revolve
from lib.assets.surface import Surface
from lib.assets.vectors import quaternion, rounded


def make_ground(size, cells):
    steps = [size * (i / cells - 0.5) for i in range(cells + 1)]
    ground = Surface()
    add_grid(ground, [[(x, 0, -z) for x in steps] for z in steps])
    return ground


# Name, part, position, turn about Y in degrees, size; all but the ground sink in a little.
GRAZING_PLACES = [
    ("ground", "ground", (0, 0, 0), 0, 1),
    ("box_near", "box", (-3.2, 0.62, 2.0), 28, 1),
    ("box_far", "box", (4.6, 0.85, -9.0), -15, 1.4),
    ("cylinder_near", "cylinder", (2.9, -0.1, 1.4), 0, 1),
    ("cylinder_far", "cylinder", (-5.6, -0.1, -7.0), 0, 1.3),
    ("cone_near", "cone", (0.9, -0.1, -1.6), 0, 1),
    ("cone_far", "cone", (-2.0, -0.1, -11.0), 0, 1.5),
    ("ball_near", "ball", (-0.9, 0.7, 3.2), 10, 1),
]


def add_grazing_camera(glb):
    """Camera that looks down at the ground by four degrees."""
    distance, pitch = 15, 4
    eye = rounded((0, 0.6 + distance * tan(radians(pitch)), distance))
    lens = {"yfov": round(radians(30), 6), "aspectRatio": 16 / 9, "znear": 0.1, "zfar": 100}
    turn_down = quaternion((1, 0, 0), -pitch)
    glb.camera("grazing", "perspective", lens, translation=eye, rotation=turn_down)


def make_grazing_plane():
    parts = {
        "ground": (make_ground(40, 16), 30, (0.62, 0.64, 0.58)),
        "box": (box(1.4, 1.4, 1.4), 30, (0.75, 0.42, 0.32)),
        "cylinder": (revolve([(0, 0), (0.6, 0), (0.6, 2), (0, 2)], 40), 30, (0.36, 0.52, 0.66)),
        "cone": (revolve([(0, 0), (0.8, 0), (0, 1.9)], 40), 30, (0.84, 0.68, 0.34)),
        "ball": (make_ball(0.9, 12, 7), 0.1, (0.52, 0.44, 0.62)),
    }
    glb = GlbWriter()
    meshes = {}
    for name, (surface, crease, rgb) in parts.items():
        meshes[name] = glb.mesh(name, surface.shaded(crease), glb.material(name, rgb))
    for name, part, position, yaw, size in GRAZING_PLACES:
        glb.node(
            name,
            mesh=meshes[part],
            translation=position,
            rotation=quaternion((0, 1, 0), yaw),
            scale=[size] * 3,
        )
    add_grazing_camera(glb)
    return glb.to_bytes()
