"""Draco and meshopt data that is damaged."""

import json

from lib.glb import glb_file
from lib.hostile.cases import case
from lib.small_gltf import FLOAT, U32, Model


def compressed():
    def draco(name, expected, data, count=4, triangles=2):
        model = Model(extensionsRequired=["KHR_draco_mesh_compression"])
        view = model.view(data)
        position = model.add("accessors", {"componentType": FLOAT, "count": count, "type": "VEC3"})
        indices = model.add("accessors", {"componentType": U32, "count": 3 * triangles, "type": "SCALAR"})
        model.add("meshes", {"primitives": [{
            "attributes": {"POSITION": position}, "indices": indices,
            "extensions": {"KHR_draco_mesh_compression": {"bufferView": view, "attributes": {"POSITION": 0}}}}]})
        case(f"draco_{name}.glb", expected, model.glb())

    head = b"DRACO\x02\x02\x01"
    noise = bytes((i * 7919 >> 3) & 255 for i in range(4000))
    draco("noise", "Draco", noise)
    draco("header_alone", "truncated", head + b"\x01\0\0")
    draco("header_and_noise", "found", head + b"\x01\0\0" + noise)
    draco("sequential_and_noise", "found", head + b"\0\0\0" + noise)
    draco("bitstream_1", "bitstream", b"DRACO\x01\x01\x01\x01\0\0" + noise)
    draco("point_cloud", "mesh", b"DRACO\x02\x02\0\x01\0\0" + noise)
    draco("metadata_and_noise", "found", head + b"\x01\0\x80" + noise)
    huge = b"\xff\xff\xff\xff\x0f"
    draco("2_to_32_triangles", "triangles", head + b"\0\0\0" + huge + huge + noise, triangles=0xFFFFFFFF // 3)
    draco("sequential_2_to_32_vertices", "found", head + b"\0\0\0" + b"\x02" + huge + b"\x01" + bytes(100))
    for attributes in (b"\xff", b"\x01\xff\xff\xff\xff\x0f"):
        draco(f"attributes_beyond_its_data_{len(attributes)}", "found",
              head + b"\0\0\0" + b"\x02\x04\x01\0\x01\x02\0\x02\x03" + attributes + bytes(50))
    vertices = b"\xff\xff\xff\x7f"  # 2^28 - 1: each of them with 255 components of 8 bytes
    draco("2_to_28_vertices_of_255_doubles", "found",
          head + b"\0\0\0" + b"\x01" + vertices + b"\x02\0\0\0\0\0\0" + b"\x01\x01\0\x0a\xff\0\0\0" + bytes(100))

    def meshopt(name, expected, data=b"\xa0" + bytes(100), fallback=True, **members):
        model = Model(extensionsRequired=["EXT_meshopt_compression"])
        view = model.view(data)
        view_of = {"buffer": 0, "byteOffset": 0, "byteLength": len(data), "byteStride": 12, "count": 4,
                   "mode": "ATTRIBUTES", **members}
        model.json["bufferViews"][view] = {
            "buffer": 1, "byteLength": 48, "byteStride": 12, "extensions": {"EXT_meshopt_compression": view_of}}
        model.add("accessors", {"bufferView": view, "componentType": FLOAT, "count": 4, "type": "VEC3"})
        model.add("meshes", {"primitives": [{"attributes": {"POSITION": 0}}]})
        marked = {"EXT_meshopt_compression": {"fallback": True}} if fallback else {}
        body = json.loads(model.document())
        body["buffers"].append({"byteLength": 48, "extensions": marked})
        case(f"meshopt_{name}.glb", expected, glb_file(json.dumps(body).encode(), bytes(model.data)))

    meshopt("noise", "found", noise)
    meshopt("empty", "found", b"\xa0")
    meshopt("version_1_noise", "found", b"\xa1" + noise)
    meshopt("version_1_empty", "found", b"\xa1")
    meshopt("version_1_count_2_to_24", "found", b"\xa1" + bytes(100), count=1 << 24)
    meshopt("count_2_to_31", "found", count=1 << 31)
    meshopt("count_2_to_62_stride_4", "found", count=1 << 62, byteStride=4)
    meshopt("count_2_to_24", "found", count=1 << 24)
    meshopt("count_negative", "found", count=-1)
    meshopt("count_0", "found", count=0)
    meshopt("stride_0", "byteStride", byteStride=0)
    meshopt("stride_7", "byteStride", byteStride=7)
    meshopt("stride_260", "byteStride", byteStride=260)
    meshopt("mode_unknown", "mode", mode="SPLATS")
    meshopt("filter_unknown", "filter", filter="BLUR")
    meshopt("filter_that_does_not_fit", "filter", filter="QUATERNION")
    meshopt("triangles_noise", "found", b"\xe1" + noise, mode="TRIANGLES", byteStride=4, count=12)
    meshopt("indices_noise", "found", b"\xd1" + noise, mode="INDICES", byteStride=4, count=12)
    meshopt("data_beyond_its_buffer", "found", byteOffset=1 << 20)
    meshopt("data_in_its_own_fallback", "found", buffer=1)
