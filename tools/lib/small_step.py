"""A small STEP file: a box of plane faces."""

from itertools import count

HEADER = ("ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
          "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n")
END = "ENDSEC;\nEND-ISO-10303-21;\n"
CORNERS = [(x, y, z) for z in (0, 3) for y in (0, 2) for x in (0, 1)]
# Corners of each face, seen from outside, and the face's normal.
FACES = [((0, 2, 3, 1), (0, 0, -1)), ((4, 5, 7, 6), (0, 0, 1)), ((0, 1, 5, 4), (0, -1, 0)),
         ((2, 6, 7, 3), (0, 1, 0)), ((0, 4, 6, 2), (-1, 0, 0)), ((1, 3, 7, 5), (1, 0, 0))]


def vector(values):
    return "(" + ",".join(f"{float(v)}" for v in values) + ")"


class Step:
    """Entities, numbered as they come."""

    def __init__(self):
        self.lines = []
        self.numbers = count(1)

    def add(self, text):
        number = next(self.numbers)
        self.lines.append(f"#{number}={text};\n")
        return f"#{number}"

    def text(self):
        return HEADER + "".join(self.lines) + END

    def point(self, position):
        return self.add(f"CARTESIAN_POINT('',{vector(position)})")

    def direction(self, ratios):
        return self.add(f"DIRECTION('',{vector(ratios)})")

    def axes(self, position, normal):
        across = (0, 1, 0) if normal[0] else (1, 0, 0)
        names = [self.point(position), self.direction(normal), self.direction(across)]
        return self.add(f"AXIS2_PLACEMENT_3D('',{','.join(names)})")

    def shell(self):
        vertices = [self.add(f"VERTEX_POINT('',{self.point(c)})") for c in CORNERS]
        edges = {}

        def edge(a, b):
            if (b, a) in edges:
                return self.add(f"ORIENTED_EDGE('',*,*,{edges[b, a]},.F.)")
            way = [q - p for p, q in zip(CORNERS[a], CORNERS[b])]
            along = self.add(f"VECTOR('',{self.direction(way)},1.)")
            line = self.add(f"LINE('',{self.point(CORNERS[a])},{along})")
            edges[a, b] = self.add(f"EDGE_CURVE('',{vertices[a]},{vertices[b]},{line},.T.)")
            return self.add(f"ORIENTED_EDGE('',*,*,{edges[a, b]},.T.)")

        faces = []
        for corners, normal in FACES:
            around = [edge(a, b) for a, b in zip(corners, corners[1:] + corners[:1])]
            loop = self.add(f"EDGE_LOOP('',({','.join(around)}))")
            bound = self.add(f"FACE_OUTER_BOUND('',{loop},.T.)")
            plane = self.add(f"PLANE('',{self.axes(CORNERS[corners[0]], normal)})")
            faces.append(self.add(f"ADVANCED_FACE('',({bound}),{plane},.T.)"))
        return self.add(f"CLOSED_SHELL('',({','.join(faces)}))")

    def product(self, items):
        millimetre = self.add("(LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.))")
        radian = self.add("(NAMED_UNIT(*) PLANE_ANGLE_UNIT() SI_UNIT($,.RADIAN.))")
        solid = self.add("(NAMED_UNIT(*) SI_UNIT($,.STERADIAN.) SOLID_ANGLE_UNIT())")
        doubt = self.add(f"UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-07),{millimetre},'','')")
        context = self.add(f"(GEOMETRIC_REPRESENTATION_CONTEXT(3) GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({doubt})) "
                           f"GLOBAL_UNIT_ASSIGNED_CONTEXT(({millimetre},{radian},{solid})) "
                           "REPRESENTATION_CONTEXT('',''))")
        application = self.add("APPLICATION_CONTEXT('')")
        kind = self.add(f"PRODUCT_CONTEXT('',{application},'')")
        product = self.add(f"PRODUCT('box','box','',({kind}))")
        formation = self.add(f"PRODUCT_DEFINITION_FORMATION('','',{product})")
        design = self.add(f"PRODUCT_DEFINITION_CONTEXT('',{application},'design')")
        definition = self.add(f"PRODUCT_DEFINITION('','',{formation},{design})")
        shape = self.add(f"PRODUCT_DEFINITION_SHAPE('','',{definition})")
        representation = self.add(f"ADVANCED_BREP_SHAPE_REPRESENTATION('',({','.join(items)}),{context})")
        self.add(f"SHAPE_DEFINITION_REPRESENTATION({shape},{representation})")


def box():
    step = Step()
    solid = step.add(f"MANIFOLD_SOLID_BREP('',{step.shell()})")
    step.product([step.axes((0, 0, 0), (0, 0, 1)), solid])
    return step.text()
