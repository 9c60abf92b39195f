"""A teapot of four parts."""

from lib.assets.curves import bezier_points
from lib.assets.glb_writer import GlbWriter
from lib.assets.solids import planar_tube, revolve


def teapot_body():
    foot = [(0, 0.0), (0.5, 0.0), (0.53, 0.03), (0.5, 0.09)]
    belly = bezier_points([(0.5, 0.09), (1.16, 0.3), (1.06, 0.94), (0.54, 1.06)], 18)
    rim = [(0.54, 1.12), (0.5, 1.14), (0.47, 1.1), (0, 1.08)]
    return revolve(foot + belly[1:] + rim, 44)


def teapot_lid():
    edge = [(0, 1.05), (0.485, 1.05), (0.485, 1.15)]
    dome = bezier_points([(0.485, 1.15), (0.4, 1.29), (0.14, 1.27), (0.07, 1.34)], 8)
    knob = bezier_points([(0.07, 1.34), (0.03, 1.42), (0.26, 1.42), (0.13, 1.57)], 9)
    return revolve(edge + dome[1:] + knob[1:] + [(0.07, 1.6), (0, 1.61)], 36)


def teapot_spout():
    curve = [(0.5, 0.38), (1.3, 0.36), (0.98, 0.98), (1.52, 1.14)]
    outside = [(i / 16, 0.1 + 0.17 * (1 - i / 16) ** 1.4) for i in range(17)]
    inside = [(1.0, 0.075), (0.93, 0.07), (0.84, 0.07)]
    return planar_tube(curve, [(0, 0), *outside, *inside, (0.84, 0)], 24)


def teapot_handle():
    curve = [(-0.6, 0.93), (-1.72, 1.22), (-1.55, 0.2), (-0.66, 0.3)]
    middle = [(i / 22, 0.07 + 0.03 * (2 * i / 22 - 1) ** 2) for i in range(23)]
    return planar_tube(curve, [(0, 0), *middle, (1, 0)], 18, width=1.35)


def make_teapot():
    glb = GlbWriter()
    glaze = glb.material("glaze", (0.32, 0.50, 0.62))
    parts = {
        "body": teapot_body(),
        "lid": teapot_lid(),
        "spout": teapot_spout(),
        "handle": teapot_handle(),
    }
    nodes = []
    for name, surface in parts.items():
        geometry = surface.shaded(crease=48, with_uvs=True)
        nodes.append(glb.node(name, mesh=glb.mesh(name, geometry, glaze)))
    glb.node("teapot", children=nodes)
    return glb.to_bytes()
