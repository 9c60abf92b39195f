"""A bracket of sheet metal and a gear."""

from math import asin, cos, pi, sin

from lib.assets.curves import arc, circle
from lib.assets.glb_writer import single_mesh
from lib.assets.solids import lift
from lib.assets.surface import Surface


class Bracket:
    """L bracket with drilled holes, chamfered rims and a gusset rib, as one closed solid.

    It is laid out flat (u across, v along, w through the plate, inner side at THICKNESS)
    and bent afterwards: v runs over the base flange, one unit of bend, the upright flange.
    """

    WIDTH, THICKNESS, CHAMFER = 1.9, 0.2, 0.04
    BASE, UPRIGHT = 1.1, 1.3
    INNER_RADIUS, BEND_SEGMENTS = 0.14, 8
    CORNER_RADIUS, CORNER_SEGMENTS = 0.32, 10
    HOLE_RADIUS, HOLE_SEGMENTS = 0.17, 48
    HOLES = ((-0.55, 0.5), (0.55, 0.5), (-0.55, BASE + 1 + 0.75), (0.55, BASE + 1 + 0.75))
    RIB_HALF_WIDTH, RIB_RUN, RIB_STEP = 0.1, 0.62, 0.05

    def __init__(self):
        self.solid = Surface()
        self.stations = [self.BASE + i / self.BEND_SEGMENTS for i in range(self.BEND_SEGMENTS + 1)]
        low, high = self.stations[0] - self.RIB_RUN, self.stations[-1] + self.RIB_RUN
        self.rib_stations = [low, *self.stations, high]

    def build(self):
        chamfer, thickness = self.CHAMFER, self.THICKNESS
        levels = ((chamfer, 0), (0, chamfer), (0, thickness - chamfer), (chamfer, thickness))
        self.solid.loft([self.bend_loop(self.outline(inset), w) for inset, w in levels])
        for centre in self.HOLES:
            rings = [self.bend_loop(self.hole(centre, inset), w) for inset, w in levels]
            self.solid.loft(rings[::-1])
        self.outer_face()
        self.inner_face()
        self.rib()
        return self.solid

    def bend(self, u, v, w):
        centre = self.THICKNESS + self.INNER_RADIUS
        if v <= self.BASE:
            return (u, w, centre + self.BASE - v)
        if v >= self.BASE + 1:
            return (u, centre + v - self.BASE - 1, w)
        angle, radius = (v - self.BASE) * pi / 2, centre - w
        return (u, centre - radius * cos(angle), centre - radius * sin(angle))

    def bend_loop(self, loop, w):
        return [self.bend(u, v, w) for u, v in loop]

    def hole(self, centre, inset):
        return circle(self.HOLE_RADIUS + inset, self.HOLE_SEGMENTS, centre)

    def side(self, u):
        return [(u, v) for v in self.stations]

    def corners(self, end, inset, angles):
        """Rounded corners of one flange end, in counter-clockwise order."""
        reach = self.WIDTH / 2 - self.CORNER_RADIUS
        towards_bend = self.CORNER_RADIUS if end == 0 else -self.CORNER_RADIUS
        points = []
        for start in angles:
            u = reach if start in (0, 270) else -reach
            centre, radius = (u, end + towards_bend), self.CORNER_RADIUS - inset
            points += arc(centre, radius, start, start + 90, self.CORNER_SEGMENTS)
        return points

    def flanges(self, inset):
        """Outlines of base and upright, each from one end of its bend line round to the other."""
        half, first, last = self.WIDTH / 2 - inset, self.stations[0], self.stations[-1]
        base = self.corners(0, inset, (180, 270))
        upright = self.corners(self.BASE + 1 + self.UPRIGHT, inset, (0, 90))
        return [(-half, first), *base, (half, first)], [(half, last), *upright, (-half, last)]

    def outline(self, inset):
        base, upright = self.flanges(inset)
        right, left = self.side(base[-1][0]), self.side(base[0][0])[::-1]
        return right + upright[1:-1] + left + base[1:-1]

    def face(self, loop, w, holes=(), flip=False):
        rims = [self.hole(centre, self.CHAMFER) for centre in holes]
        self.solid.polygon(loop, rims, lambda u, v: self.bend(u, v, w), flip)

    def bend_strips(self, u0, u1, w, flip=False):
        for v0, v1 in zip(self.stations, self.stations[1:]):
            self.face([(u0, v0), (u1, v0), (u1, v1), (u0, v1)], w, flip=flip)

    def outer_face(self):
        half = self.WIDTH / 2 - self.CHAMFER
        base, upright = self.flanges(self.CHAMFER)
        self.face(base, 0, self.HOLES[:2], flip=True)
        self.face(upright, 0, self.HOLES[2:], flip=True)
        self.bend_strips(-half, half, 0, flip=True)

    def inner_face(self):
        """Inner side, with a notch where the rib stands."""
        half, rib, w = self.WIDTH / 2 - self.CHAMFER, self.RIB_HALF_WIDTH, self.THICKNESS
        low, first, *_, last, high = self.rib_stations
        base, upright = self.flanges(self.CHAMFER)
        base += [(rib, first), (rib, low), (-rib, low), (-rib, first)]
        upright += [(-rib, last), (-rib, high), (rib, high), (rib, last)]
        self.face(base, w, self.HOLES[:2])
        self.face(upright, w, self.HOLES[2:])
        self.bend_strips(-half, -rib, w)
        self.bend_strips(rib, half, w)

    def rib(self):
        half, top = self.RIB_HALF_WIDTH, self.THICKNESS + self.RIB_STEP
        foot = [self.bend(0, v, self.THICKNESS) for v in self.rib_stations]
        crest = [self.bend(0, self.rib_stations[i], top) for i in (-1, 0)]
        profile = [(-z, y) for _, y, z in foot + crest]
        self.solid.polygon(profile, [], lambda x, y: (half, y, -x))
        self.solid.polygon(profile, [], lambda x, y: (-half, y, -x), flip=True)
        free = [foot[0], crest[1], crest[0], foot[-1]]
        for (_, y0, z0), (_, y1, z1) in zip(free, free[1:]):
            self.solid.quad((half, y0, z0), (half, y1, z1), (-half, y1, z1), (-half, y0, z0))


def make_bracket():
    return single_mesh("bracket", Bracket().build().unshaded(), (0.62, 0.66, 0.70))


def gear_outline(teeth, root, tip):
    """Trapezoid teeth, as (fraction of the pitch, radius) corners per tooth."""
    corners = ((-0.40, root), (-0.27, root), (-0.12, tip), (0.12, tip), (0.27, root), (0.40, root))
    polar = [(2 * pi * (i + f) / teeth, r) for i in range(teeth) for f, r in corners]
    return [(r * cos(a), r * sin(a)) for a, r in polar]


def keyed_bore(radius, key_half_width, key_height):
    """Round bore with a rectangular keyway towards +Y."""
    opening = asin(key_half_width / radius) * 180 / pi
    round_part = arc((0, 0), radius, 90 + opening, 450 - opening, 44)
    return round_part + [(key_half_width, key_height), (-key_half_width, key_height)]


def make_gear():
    back, web, face, chamfer_start, top = -0.18, 0.04, 0.18, 0.43, 0.48
    teeth, bore = gear_outline(20, 0.98, 1.2), keyed_bore(0.22, 0.07, 0.3)
    rim, hub, hub_top = circle(0.8, 72), circle(0.45, 60), circle(0.40, 60)
    spots = arc((0, 0), 0.625, 30, 390, 6)[:-1]
    windows = [circle(0.1, 32, spot) for spot in spots]

    gear = Surface()

    def wall(*stages):
        gear.loft([lift(loop, z) for loop, z in stages])

    def flat(outer, holes, z, flip=False):
        gear.polygon(outer, holes, lambda x, y: (x, y, z), flip)

    flat(teeth, [bore, *windows], back, flip=True)
    wall((teeth, back), (teeth, face))
    flat(teeth, [rim], face)
    wall((rim, face), (rim, web))
    flat(rim, [hub, *windows], web)
    wall((hub, web), (hub, chamfer_start), (hub_top, top))
    flat(hub_top, [bore], top)
    for loop, front in [(bore, top)] + [(window, web) for window in windows]:
        wall((loop, front), (loop, back))
    return single_mesh("gear", gear.unshaded(), (0.72, 0.62, 0.40))
