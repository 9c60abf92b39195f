"""A glTF 2.0 document that grows with its data: for small models whose every member is known."""

import base64
import json
import struct

from lib.glb import glb_file

PACK = {5120: "b", 5121: "B", 5122: "h", 5123: "H", 5125: "I", 5126: "f"}
QUAD = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 1)]
FACES = [0, 1, 2, 0, 2, 3]
IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
FLOAT, U8, U16, U32 = 5126, 5121, 5123, 5125


class Model:
    """A glTF document that grows with its data."""

    def __init__(self, **members):
        self.json = {"asset": {"version": "2.0"}, "nodes": [{"mesh": 0}], **members}
        self.data = bytearray()

    def add(self, kind, item):
        self.json.setdefault(kind, []).append(item)
        return len(self.json[kind]) - 1

    def view(self, data, **members):
        self.data += bytes(-len(self.data) % 4)
        start = len(self.data)
        self.data += data
        return self.add("bufferViews", {"buffer": 0, "byteOffset": start, "byteLength": len(data), **members})

    def accessor(self, rows, component=FLOAT, kind=None, **members):
        rows = [row if isinstance(row, (tuple, list)) else (row,) for row in rows]
        kind = kind or {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}[len(rows[0])]
        data = b"".join(struct.pack("<%d%s" % (len(row), PACK[component]), *row) for row in rows)
        item = {"bufferView": self.view(data), "componentType": component, "count": len(rows), "type": kind}
        return self.add("accessors", {**item, **members})

    def mesh(self, attributes=None, indices=FACES, component=U16, weights=None, **members):
        attributes = attributes or {"POSITION": self.accessor(QUAD)}
        primitive = {"attributes": attributes, **members}
        if indices is not None:
            primitive["indices"] = self.accessor(indices, component)
        mesh = {"primitives": [primitive]}
        if weights:
            mesh["weights"] = weights
        return self.add("meshes", mesh)

    def document(self, uri=None):
        buffer = {"byteLength": len(self.data)}
        if uri:
            buffer["uri"] = uri
        return json.dumps({**self.json, "buffers": [buffer]}, separators=(",", ":")).encode()

    def glb(self):
        text = self.document()
        text += b" " * (-len(text) % 4)
        data = bytes(self.data) + bytes(-len(self.data) % 4)
        return glb_file(text, data)

    def gltf(self):
        return self.document("data:application/octet-stream;base64," + base64.b64encode(self.data).decode())
