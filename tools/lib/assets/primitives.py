"""Every primitive mode, and layouts of accessors."""

from lib.assets.curves import arc, circle
from lib.assets.glb_writer import (
    LINES,
    LINE_LOOP,
    LINE_STRIP,
    POINTS,
    TRIANGLES,
    TRIANGLE_FAN,
    TRIANGLE_STRIP,
    GlbWriter,
)
from lib.assets.solids import lift, prism
from lib.assets.vectors import quaternion


def closed_loop(radius, start, segments):
    """Regular polygon whose last point repeats the first one exactly."""
    corners = lift(arc((0, 0), radius, start, start + 360, segments)[:-1], 0)
    return corners + corners[:1]


def mode_samples():
    """One small point list per primitive mode, in the unit cell around the origin."""
    lattice = [(0.3 * x, 0.3 * y, 0) for y in (-1, 0, 1) for x in (-1, 0, 1)]
    spokes = lift([p for ends in zip(circle(0.1, 6), circle(0.4, 6)) for p in ends], 0)
    pentagon = lift(arc((0, 0), 0.38, 90, 450, 5)[:-1], 0)
    zigzag = [(0.2 * i - 0.4, 0.35 * (-1) ** i, 0) for i in range(5)]
    apex, base = (0, 0, 0.3), closed_loop(0.42, 45, 4)
    pyramid = [p for a, b in zip(base, base[1:]) for p in (a, b, apex)]
    pleats = [(0.2 * i - 0.4, y, 0.2 * (i % 2)) for i in range(5) for y in (0.35, -0.35)]
    cone = [apex, *closed_loop(0.42, 0, 6)]
    return {
        "points": (POINTS, lattice),
        "lines": (LINES, spokes),
        "line_loop": (LINE_LOOP, pentagon),
        "line_strip": (LINE_STRIP, zigzag),
        "triangles": (TRIANGLES, pyramid),
        "triangle_strip": (TRIANGLE_STRIP, pleats),
        "triangle_fan": (TRIANGLE_FAN, cone),
    }


def letter_f():
    """Solid letter F: it has no symmetry, so every mirroring and shear shows."""
    outline = [
        (-0.3, -0.4), (-0.1, -0.4), (-0.1, -0.05), (0.15, -0.05), (0.15, 0.12),
        (-0.1, 0.12), (-0.1, 0.22), (0.3, 0.22), (0.3, 0.4), (-0.3, 0.4),
    ]
    return prism(outline, -0.12, 0.12).shaded()


def add_mode_rows(glb, line_material, face_material):
    """Every mode without and with indices: points and lines above, triangles below."""
    samples = list(mode_samples().items())
    add_mode_row(glb, line_material, samples[:TRIANGLES], 1.1)
    add_mode_row(glb, face_material, samples[TRIANGLES:], 0)


def add_mode_row(glb, material, samples, height):
    places = iter(row_of_places(2 * len(samples), height))
    for name, (mode, points) in samples:
        unique = list(dict.fromkeys(points))
        indexed = [unique.index(p) for p in points]
        for suffix, stored, indices in (("", points, None), ("_indexed", unique, indexed)):
            attributes = {"POSITION": glb.vectors(stored, True)}
            mesh = glb.primitive_mesh(name + suffix, attributes, material, mode, indices)
            glb.node(name + suffix, mesh=mesh, translation=next(places))


def row_of_places(count, height, spacing=1.1):
    return [[spacing * (i - (count - 1) / 2), height, 0] for i in range(count)]


def sparse_letter(glb, letter, material):
    """Letter whose upper bar is made longer by a sparse accessor."""
    longer = {i: (x + 0.15, y, z) for i, (x, y, z) in enumerate(letter.positions) if x == 0.3}
    attributes = {
        "POSITION": glb.sparse_positions(letter.positions, longer),
        "NORMAL": glb.vectors(letter.normals),
    }
    return glb.primitive_mesh("sparse", attributes, material, indices=letter.indices)


def sparse_arrowhead(glb, material):
    """Sparse accessor without a base buffer view: what it leaves out is zero."""
    corners = {1: (0.35, -0.2, 0), 2: (0, 0.4, 0), 3: (-0.35, -0.2, 0)}
    attributes = {"POSITION": glb.sparse_positions([(0, 0, 0)] * 4, corners)}
    faces = [0, 1, 2, 0, 2, 3]
    return glb.primitive_mesh("sparse_zeros", attributes, material, indices=faces)


def add_layout_row(glb, material):
    """Letters over interleaved and sparse accessors and under awkward transforms."""
    letter = letter_f()
    places = row_of_places(6, -1.1)
    attributes = glb.interleaved(letter.positions, letter.normals)
    plain = glb.primitive_mesh("letter", attributes, material, indices=letter.indices)
    glb.node("interleaved", mesh=plain, translation=places[0])
    glb.node("sparse", mesh=sparse_letter(glb, letter, material), translation=places[1])
    glb.node("sparse_zeros", mesh=sparse_arrowhead(glb, material), translation=places[2])
    glb.node("negative_scale", mesh=plain, translation=places[3], scale=[-1, 1, 1])
    tilted = glb.node("tilted", mesh=plain, rotation=quaternion((0, 0, 1), 40))
    glb.node("sheared", children=[tilted], translation=places[4], scale=[1.25, 0.7, 1])
    c, s = 0.8, 0.6
    columns = [(c, 0, -s, 0), (0, 1, 0, 0), (s, 0, c, 0), (*places[5], 1)]
    glb.node("matrix", mesh=plain, matrix=[value for column in columns for value in column])


def make_primitives():
    glb = GlbWriter()
    ink = glb.material("ink", (0.15, 0.16, 0.20))
    paper = glb.material("paper", (0.36, 0.58, 0.60), double_sided=True)
    paint = glb.material("paint", (0.84, 0.56, 0.32), double_sided=True)
    add_mode_rows(glb, ink, paper)
    add_layout_row(glb, paint)
    lens = {"xmag": 4.8, "ymag": 2.7, "znear": 0.1, "zfar": 20}
    glb.camera("front", "orthographic", lens, translation=[0, 0, 6])
    return glb.to_bytes()
