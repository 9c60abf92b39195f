"""Triangles that share points, and their normals."""

from collections import defaultdict
from dataclasses import dataclass
from math import dist, radians

from lib.assets.triangulation import triangulate
from lib.assets.vectors import add, angle_between, cross, rounded, scale, sub, unit

STRAY_ANGLE = radians(45)


@dataclass
class Geometry:
    """Vertex arrays as glTF stores them."""

    positions: list
    indices: list
    normals: list = None
    uvs: list = None
    colors: list = None


class Surface:
    """Triangles over points that are welded by position."""

    def __init__(self):
        self.points = []
        self.faces = []
        self.face_uvs = []
        self._index_of = {}

    def point(self, position):
        key = rounded(position)
        if key not in self._index_of:
            self._index_of[key] = len(self.points)
            self.points.append(key)
        return self._index_of[key]

    def triangle(self, a, b, c, uvs=((0, 0),) * 3):
        self.faces.append((self.point(a), self.point(b), self.point(c)))
        self.face_uvs.append(uvs)

    def quad(self, a, b, c, d):
        self.triangle(a, b, c)
        self.triangle(a, c, d)

    def body(self, other, offset=(0, 0, 0)):
        """Take in another surface, moved by offset."""
        for face, uvs in zip(other.faces, other.face_uvs):
            self.triangle(*(add(other.points[i], offset) for i in face), uvs)

    def polygon(self, outer, holes, place, flip=False):
        """Fill a planar polygon; place(x, y) maps it into space."""
        for corners in triangulate(outer, holes):
            self.triangle(*(place(*p) for p in (corners[::-1] if flip else corners)))

    def loft(self, rings, closed=False):
        """Skin rings that turn counter-clockwise seen from the end of their path.

        A ring of one point is a pole.
        """
        path = rings + rings[:1] if closed else rings
        lengths = [0.0]
        for ring, following in zip(path, path[1:]):
            lengths.append(lengths[-1] + dist(ring[0], following[0]))
        for k, (lower, upper) in enumerate(zip(path, path[1:])):
            self._band(lower, upper, lengths[k] / lengths[-1], lengths[k + 1] / lengths[-1])

    def _band(self, lower, upper, v0, v1):
        count = max(len(lower), len(upper))
        for j in range(count):
            following = (j + 1) % count
            u0, u1 = j / count, (j + 1) / count
            middle = (u0 + u1) / 2
            if len(lower) == 1:
                corners = (lower[0], upper[following], upper[j])
                self.triangle(*corners, ((middle, v0), (u1, v1), (u0, v1)))
            elif len(upper) == 1:
                corners = (lower[j], lower[following], upper[0])
                self.triangle(*corners, ((u0, v0), (u1, v0), (middle, v1)))
            else:
                a, b, c, d = lower[j], lower[following], upper[following], upper[j]
                self.triangle(a, b, c, ((u0, v0), (u1, v0), (u1, v1)))
                self.triangle(a, c, d, ((u0, v0), (u1, v1), (u0, v1)))

    def face_normal(self, face):
        a, b, c = (self.points[i] for i in face)
        return unit(cross(sub(b, a), sub(c, a)))

    def corner_angle(self, face, k):
        a, b, c = (self.points[face[(k + i) % 3]] for i in range(3))
        return angle_between(sub(b, a), sub(c, a))

    def unshaded(self):
        """Geometry without normals."""
        return Geometry(self.points, [i for face in self.faces for i in face])

    def shaded(self, crease=30, with_uvs=False):
        """Geometry with angle-weighted normals, split at edges that bend by more than crease.

        Where the mean strays too far from a face, as at the apex of a cone, that face keeps
        its own normal.
        """
        face_normals = [self.face_normal(face) for face in self.faces]
        group_of = self._smoothing_groups(face_normals, radians(crease))
        sums = defaultdict(lambda: (0.0, 0.0, 0.0))
        for f, face in enumerate(self.faces):
            for k in range(3):
                weighted = scale(face_normals[f], self.corner_angle(face, k))
                sums[group_of(3 * f + k)] = add(sums[group_of(3 * f + k)], weighted)
        vertices = {}
        indices = []
        for f, face in enumerate(self.faces):
            for k in range(3):
                normal = unit(sums[group_of(3 * f + k)])
                if angle_between(normal, face_normals[f]) > STRAY_ANGLE:
                    normal = face_normals[f]
                uv = self.face_uvs[f][k] if with_uvs else None
                key = (self.points[face[k]], rounded(normal), uv)
                indices.append(vertices.setdefault(key, len(vertices)))
        positions, normals, uvs = map(list, zip(*vertices))
        return Geometry(positions, indices, normals, uvs if with_uvs else None)

    def _smoothing_groups(self, face_normals, crease):
        """Union-find over face corners; corners meet across every edge that is no crease."""
        parent = list(range(3 * len(self.faces)))

        def root(corner):
            while parent[corner] != corner:
                parent[corner] = parent[parent[corner]]
                corner = parent[corner]
            return corner

        corner_at = {}
        for f, face in enumerate(self.faces):
            for k in range(3):
                corner_at[face[k], face[(k + 1) % 3]] = (f, 3 * f + k, 3 * f + (k + 1) % 3)
        for (a, b), (f, at_a, at_b) in corner_at.items():
            other = corner_at.get((b, a))
            if other and angle_between(face_normals[f], face_normals[other[0]]) <= crease:
                parent[root(at_a)] = root(other[2])
                parent[root(at_b)] = root(other[1])
        return root
