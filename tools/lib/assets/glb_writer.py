"""Meshes, nodes, cameras and materials to one binary glTF file."""

import json
import struct

from lib.assets.vectors import rounded
from lib.glb import glb_file
from lib.small_gltf import FLOAT, U8, U16

ARRAY_BUFFER, ELEMENT_ARRAY_BUFFER = 34962, 34963
POINTS, LINES, LINE_LOOP, LINE_STRIP, TRIANGLES, TRIANGLE_STRIP, TRIANGLE_FAN = range(7)
VECTOR_TYPE = {2: "VEC2", 3: "VEC3", 4: "VEC4"}


def pack_floats(rows):
    values = [value for row in rows for value in rounded(row)]
    return struct.pack(f"<{len(values)}f", *values)


def pack_indices(values):
    """The bytes of an index array and their component type, the narrowest that holds them."""
    code, component_type = ("B", U8) if max(values) < 255 else ("H", U16)
    return struct.pack(f"<{len(values)}{code}", *values), component_type


def bounds(rows):
    """Componentwise minimum and maximum of the values as stored in single precision."""
    width = len(rows[0])
    stored = list(struct.iter_unpack(f"<{width}f", pack_floats(rows)))
    columns = list(zip(*stored))
    return {"min": [min(c) for c in columns], "max": [max(c) for c in columns]}


class GlbWriter:
    """Collects meshes, nodes and cameras and writes them as one GLB file."""

    def __init__(self):
        self.document = {
            "asset": {
                "version": "2.0",
                "generator": "inkedge make_assets",
                "copyright": "CC0-1.0",
            }
        }
        self.binary = bytearray()

    def _append(self, kind, item):
        items = self.document.setdefault(kind, [])
        items.append(item)
        return len(items) - 1

    def view(self, data, **properties):
        offset = len(self.binary)
        self.binary += data + bytes(-len(data) % 4)
        item = {"buffer": 0, "byteOffset": offset, "byteLength": len(data), **properties}
        return self._append("bufferViews", item)

    def vectors(self, rows, with_bounds=False, **placement):
        """Accessor of float vectors in its own buffer view, unless placement names one."""
        if not placement:
            placement = {"bufferView": self.view(pack_floats(rows), target=ARRAY_BUFFER)}
        item = {
            **placement,
            "componentType": FLOAT,
            "count": len(rows),
            "type": VECTOR_TYPE[len(rows[0])],
            **(bounds(rows) if with_bounds else {}),
        }
        return self._append("accessors", item)

    def interleaved(self, positions, normals):
        """Position and normal attributes that share one strided buffer view."""
        rows = [(*p, *n) for p, n in zip(positions, normals)]
        view = self.view(pack_floats(rows), byteStride=24, target=ARRAY_BUFFER)
        return {
            "POSITION": self.vectors(positions, True, bufferView=view, byteOffset=0),
            "NORMAL": self.vectors(normals, bufferView=view, byteOffset=12),
        }

    def sparse_positions(self, base, changes):
        """Sparse accessor: changes {index: position} over base, zeros without a base view."""
        rows = [changes.get(i, row) for i, row in enumerate(base)]
        order = sorted(changes)
        data, component_type = pack_indices(order)
        sparse = {
            "count": len(order),
            "indices": {"bufferView": self.view(data), "componentType": component_type},
            "values": {"bufferView": self.view(pack_floats([changes[i] for i in order]))},
        }
        placement = {"sparse": sparse}
        if any(any(row) for row in base):
            placement["bufferView"] = self.view(pack_floats(base), target=ARRAY_BUFFER)
        return self.vectors(rows, True, **placement)

    def scalars(self, indices):
        data, component_type = pack_indices(indices)
        item = {
            "bufferView": self.view(data, target=ELEMENT_ARRAY_BUFFER),
            "componentType": component_type,
            "count": len(indices),
            "type": "SCALAR",
        }
        return self._append("accessors", item)

    def material(self, name, rgb, double_sided=False):
        item = {
            "name": name,
            "pbrMetallicRoughness": {
                "baseColorFactor": [*rgb, 1],
                "metallicFactor": 0,
                "roughnessFactor": 0.7,
            },
        }
        if double_sided:
            item["doubleSided"] = True
        return self._append("materials", item)

    def primitive_mesh(self, name, attributes, material, mode=TRIANGLES, indices=None):
        primitive = {"attributes": attributes, "material": material, "mode": mode}
        if indices:
            primitive["indices"] = self.scalars(indices)
        return self._append("meshes", {"name": name, "primitives": [primitive]})

    def mesh(self, name, geometry, material):
        attributes = {"POSITION": self.vectors(geometry.positions, True)}
        if geometry.normals:
            attributes["NORMAL"] = self.vectors(geometry.normals)
        if geometry.uvs:
            attributes["TEXCOORD_0"] = self.vectors(geometry.uvs)
        if geometry.colors:
            attributes["COLOR_0"] = self.vectors(geometry.colors)
        return self.primitive_mesh(name, attributes, material, indices=geometry.indices)

    def node(self, name, **properties):
        return self._append("nodes", {"name": name, **properties})

    def camera(self, name, kind, lens, **placement):
        camera = self._append("cameras", {"name": name, "type": kind, kind: lens})
        return self.node(name, camera=camera, **placement)

    def picture_material(self, name, picture, mode):
        """Double-sided material whose base colour is a PNG picture, with an alpha mode."""
        image = self._append("images", {"bufferView": self.view(picture), "mimeType": "image/png"})
        texture = self._append("textures", {"source": image})
        item = {
            "name": name,
            "pbrMetallicRoughness": {"baseColorTexture": {"index": texture}},
            "alphaMode": mode,
            "doubleSided": True,
        }
        return self._append("materials", item)

    def rotation_animation(self, name, node, keys):
        """Turns a node: keys are (seconds, quaternion)."""
        times = [(time,) for time, _ in keys]
        span = {"min": list(times[0]), "max": list(times[-1])}
        view = self.view(pack_floats(times))
        item = {"bufferView": view, "componentType": FLOAT, "count": len(times), "type": "SCALAR"}
        sampler = {
            "input": self._append("accessors", {**item, **span}),
            "output": self.vectors([turn for _, turn in keys]),
        }
        channel = {"sampler": 0, "target": {"node": node, "path": "rotation"}}
        self._append("animations", {"name": name, "samplers": [sampler], "channels": [channel]})

    def to_bytes(self, *further_scenes):
        nodes = self.document["nodes"]
        children = {child for node in nodes for child in node.get("children", [])}
        roots = [i for i in range(len(nodes)) if i not in children]
        document = {
            **self.document,
            "scene": 0,
            "scenes": [{"nodes": roots}, *further_scenes],
            "buffers": [{"byteLength": len(self.binary)}],
        }
        text = json.dumps(document, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        return glb_file(text, bytes(self.binary))


def single_mesh(name, geometry, rgb, double_sided=False):
    """GLB file of one mesh in one node."""
    glb = GlbWriter()
    glb.node(name, mesh=glb.mesh(name, geometry, glb.material(name, rgb, double_sided)))
    return glb.to_bytes()
