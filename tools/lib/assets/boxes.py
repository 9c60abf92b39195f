"""Boxes: in one plane, touching, and a cube."""

from lib.assets.glb_writer import GlbWriter, single_mesh
from lib.assets.solids import box, prism, revolve
from lib.assets.surface import Surface


def make_boxes():
    """Boxes whose fronts share one plane and look as if they overlapped.

    Every spot of the plane is covered once, and neighbours share their border vertices,
    so nothing fights for depth and no pinhole opens.  All coordinates are exact in binary.
    """
    front = 0.5
    layout = [
        ("middle", 1.0, (0.85, 0.45, 0.30), (0, 0),
         [(-0.5, -0.5), (-0.25, -0.5), (0.5, -0.5), (0.5, 0), (0.5, 0.5), (0.25, 0.5),
          (-0.5, 0.5), (-0.5, 0)]),
        ("upper_right", 0.625, (0.90, 0.72, 0.35), (0.75, 0.5),
         [(-0.25, -0.5), (0.25, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5), (-0.5, 0),
          (-0.25, 0)]),
        ("lower_left", 0.75, (0.35, 0.58, 0.62), (-0.75, -0.5),
         [(-0.5, -0.5), (0.5, -0.5), (0.5, 0), (0.25, 0), (0.25, 0.5), (-0.5, 0.5)]),
        ("lower_right", 1.25, (0.55, 0.62, 0.38), (0.75, -0.375),
         [(-0.25, -0.375), (0.25, -0.375), (0.25, 0.375), (-0.25, 0.375), (-0.25, -0.125)]),
        ("upper_left", 0.375, (0.55, 0.45, 0.62), (-0.25, 0.75),
         [(-0.5, -0.25), (-0.25, -0.25), (0.5, -0.25), (0.5, 0.25), (-0.5, 0.25)]),
    ]
    glb = GlbWriter()
    for name, depth, rgb, (x, y), outline in layout:
        solid = prism(outline, -depth, 0)
        mesh = glb.mesh(name, solid.shaded(), glb.material(name, rgb))
        glb.node(name, mesh=mesh, translation=[x, y, front])
    return glb.to_bytes()


def touching_bodies():
    """Closed bodies of one mesh that stand on, run into or lie flush in one another.

    No two of them share a vertex.  All coordinates but the circle's are exact in binary.
    """
    pin = [(0, -0.375), (0.375, -0.375), (0.375, 0), (0, 0)]
    return [
        # A box on a larger one: its bottom lies inside the other's top.
        (box(1.25, 0.5, 1.25), (0, 0.25, -1)),
        (box(0.625, 0.625, 0.5), (0.125, 0.8125, -1.125)),
        # Boxes half run into each other: fronts in one plane, tops in another.
        (box(1.0, 1.0, 1.25), (1.5, 0.5, -1)),
        (box(1.0, 0.625, 0.75), (2.25, 0.6875, -0.75)),
        # A cylinder let into a block: its cap lies in the block's top.
        (box(1.25, 0.5, 1.25), (-1.25, -0.25, 1)),
        (revolve(pin, 48), (-1.25, 0, 1)),
        # A thin plate let into a thicker one: their tops lie in one plane.
        (box(1.75, 0.25, 1.25), (1.25, -0.125, 1)),
        (box(0.875, 0.125, 0.625), (1.375, -0.0625, 1.0625)),
    ]


# Name, centre and size of the steps; they are flush at the left and at the back.
STEPS = [
    ("low_step", (-2, 0.1875, -1), (1.5, 0.375, 1.5)),
    ("middle_step", (-2.25, 0.5625, -1.25), (1.0, 0.375, 1.0)),
    ("high_step", (-2.5, 0.9375, -1.5), (0.5, 0.375, 0.5)),
]


def make_touching_solids():
    """Solids that touch and overlap in coplanar faces, as CAD programs export them."""
    glb = GlbWriter()
    paint = glb.material("paint", (0.58, 0.62, 0.66))
    bodies = Surface()
    for solid, offset in touching_bodies():
        bodies.body(solid, offset)
    glb.node("bodies", mesh=glb.mesh("bodies", bodies.unshaded(), paint))
    step = glb.mesh("step", box(1, 1, 1).unshaded(), paint)
    for name, centre, size in STEPS:
        glb.node(name, mesh=step, translation=centre, scale=size)
    return glb.to_bytes()


def make_cube():
    return single_mesh("cube", box(1, 1, 1).shaded(), (0.70, 0.70, 0.72))
