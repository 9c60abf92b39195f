"""Polygons in the plane, with holes, to triangles."""

from math import dist


def turn(a, b, c):
    """Twice the signed area of the triangle abc, positive when counter-clockwise."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def segments_cross(a, b, c, d):
    return turn(a, b, c) * turn(a, b, d) < 0 and turn(c, d, a) * turn(c, d, b) < 0


def edges_of(loop):
    return zip(loop, loop[1:] + loop[:1])


def join_hole(polygon, hole, obstacles):
    """Cut a polygon open along the shortest free bridge to a clockwise hole."""
    walls = [edge for loop in (polygon, *obstacles) for edge in edges_of(loop)]
    bridges = sorted(
        (dist(p, q), i, j)
        for i, p in enumerate(polygon)
        if polygon.count(p) == 1
        for j, q in enumerate(hole)
    )
    for _, i, j in bridges:
        if not any(segments_cross(polygon[i], hole[j], *wall) for wall in walls):
            return polygon[: i + 1] + hole[j:] + hole[: j + 1] + polygon[i:]
    raise ValueError("no bridge to the hole")


def is_ear(before, tip, after, polygon, quality):
    longest = max(dist(before, tip), dist(tip, after), dist(after, before))
    if turn(before, tip, after) <= quality * longest * longest:
        return False
    return not any(
        turn(before, tip, p) >= 0 and turn(tip, after, p) >= 0 and turn(after, before, p) >= 0
        for p in polygon
        if p not in (before, tip, after)
    )


def find_ear(polygon, start):
    """Next ear from a starting corner on; slivers only where no better ear is left."""
    count = len(polygon)
    for quality in (0.1, 0.01, 1e-3, 1e-9):
        for i in range(start, start + count):
            corners = [polygon[k % count] for k in (i - 1, i, i + 1)]
            if is_ear(*corners, polygon, quality):
                return i % count
    raise ValueError("no ear left: the polygon crosses itself")


def triangulate(outer, holes=()):
    """Ear clipping of a counter-clockwise polygon with counter-clockwise holes."""
    polygon = list(outer)
    waiting = [hole[::-1] for hole in holes]
    while waiting:
        nearest = min(waiting, key=lambda h: min(dist(p, q) for p in polygon for q in h))
        polygon = join_hole(polygon, nearest, waiting)
        waiting.remove(nearest)
    triangles = []
    ear = 0
    while len(polygon) > 3:
        ear = find_ear(polygon, ear)
        triangles.append((polygon[ear - 1], polygon[ear], polygon[(ear + 1) % len(polygon)]))
        del polygon[ear]
    return triangles + [tuple(polygon)]
