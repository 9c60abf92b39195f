"""A knot, a blob and a sphere."""

from math import asin, atan2, cos, dist, pi, sin, sqrt

from lib.assets.curves import circle
from lib.assets.glb_writer import single_mesh
from lib.assets.surface import Surface
from lib.assets.vectors import add, cross, dot, rotate, scale, smoothstep, sub, unit


def make_torus_knot():
    """Tube along a (2,3) torus knot, drawn as a trefoil that bends inwards everywhere."""
    segments, sides, core_radius, coil_radius, tube_radius = 200, 20, 1.0, 0.5, 0.21

    def centre(t):
        x = core_radius * cos(2 * t) + coil_radius * cos(t)
        y = core_radius * sin(2 * t) - coil_radius * sin(t)
        return (x, y, coil_radius * sin(3 * t))

    rings, normals = [], []
    for i in range(segments):
        t = 2 * pi * i / segments
        tangent = unit(sub(centre(t + 1e-4), centre(t - 1e-4)))
        # The normal of the carrying torus closes on itself after one turn of the knot.
        torus_normal = (cos(3 * t) * cos(2 * t), cos(3 * t) * sin(2 * t), sin(3 * t))
        side = unit(cross(tangent, torus_normal))
        normal = cross(side, tangent)
        spokes = [add(scale(normal, x), scale(side, y)) for x, y in circle(1, sides)]
        normals += spokes
        rings.append([add(centre(t), scale(spoke, tube_radius)) for spoke in spokes])
    knot = Surface()
    for position in (p for ring in rings for p in ring):
        knot.point(position)
    knot.loft(rings, closed=True)
    geometry = knot.unshaded()
    geometry.normals = normals
    return single_mesh("torus_knot", geometry, (0.24, 0.52, 0.68))


def ridge_height(around):
    """Height of the ridge at an angle from the top towards the front, in degrees."""
    return 0.29 * smoothstep((105 - around) / 95) * smoothstep((around + 130) / 60)


def blob_radius(direction):
    x, y, z = direction
    swell = 0.13 * sin(2.1 * x + 1.3 * y + 0.4) + 0.10 * sin(2.7 * y - 1.9 * z + 1.1)
    swell += 0.09 * sin(3.3 * z + 2.4 * x - 0.6)
    spread = 0.7
    flank = max(0.0, 1 - abs(asin(x)) / spread) ** 2
    return 1 + swell + ridge_height(atan2(z, y) * 180 / pi) * flank


def make_blob():
    """Displaced sphere; its equator, in the plane x = 0, carries a ridge that fades out."""
    around, half_bands, twist = 80, 20, 0.55

    def place(latitude, longitude):
        x, reach = sin(latitude), cos(latitude)
        direction = (x, reach * cos(longitude), reach * sin(longitude))
        turned = rotate(direction, (0, 1, 0), twist * direction[1])
        return scale(turned, blob_radius(direction))

    rings = []
    for k in range(-half_bands, half_bands + 1):
        t = k / half_bands
        latitude = pi / 2 * (0.65 * t + 0.35 * t**3)
        count = around if abs(k) < half_bands else 1
        rings.append([place(latitude, 2 * pi * j / around) for j in range(count)])
    blob = Surface()
    blob.loft(rings)
    return single_mesh("blob", blob.shaded(crease=30), (0.78, 0.42, 0.46))


def icosahedron():
    golden = (1 + sqrt(5)) / 2
    points = []
    for a, b in ((-1, golden), (1, golden), (-1, -golden), (1, -golden)):
        points += [(a, b, 0), (0, a, b), (b, 0, a)]
    shortest = 2.01
    faces = []
    for a in points:
        for b in points:
            for c in points:
                close = max(dist(a, b), dist(b, c), dist(c, a)) < shortest
                if close and min(a, b, c) == a and dot(cross(a, b), c) > 0:
                    faces.append((a, b, c))
    return faces


def subdivide(triangle):
    a, b, c = triangle
    ab, bc, ca = unit(add(a, b)), unit(add(b, c)), unit(add(c, a))
    return [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]


def make_sphere():
    triangles = [tuple(map(unit, face)) for face in icosahedron()]
    for _ in range(4):
        triangles = [small for triangle in triangles for small in subdivide(triangle)]
    sphere = Surface()
    for corners in triangles:
        sphere.triangle(*corners)
    geometry = sphere.unshaded()
    geometry.normals = geometry.positions
    return single_mesh("sphere", geometry, (0.70, 0.70, 0.72))
