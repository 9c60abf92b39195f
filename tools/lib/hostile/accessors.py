"""Accessors, views and buffers that reach too far or make no sense."""

import struct

from lib.hostile.cases import ACCESSOR, DELETE, PICTURE, VIEW, case, changed, quad
from lib.small_gltf import FLOAT, QUAD, U16, Model


def accessors():
    def position(name, expected, member, value):
        case(f"accessor_{name}.gltf", expected, changed([*ACCESSOR, member], value).gltf())

    def view(name, expected, member, value):
        case(f"view_{name}.gltf", expected, changed([*VIEW, member], value).gltf())

    position("beyond_its_view", "bufferView", "count", 5)
    position("offset_beyond_its_view", "bufferView", "byteOffset", 40)
    position("offset_negative", "found", "byteOffset", -12)
    position("offset_2_to_63", "found", "byteOffset", 1 << 63)
    position("offset_odd", "bufferView", "byteOffset", 1)
    for name, count in (("0", 0), ("1", 1), ("minus_1", -1), ("1.5", 1.5), ("2_to_31", 1 << 31), ("2_to_63", 1 << 63)):
        position(f"count_{name}", "found", "count", count)
    position("count_2_to_64", "found", "count", 1 << 64)
    position("count_missing", "found", "count", DELETE)
    position("count_a_string", "found", "count", "4")
    position("type_vec2", "VEC2", "type", "VEC2")
    position("type_mat4", "MAT4", "type", "MAT4")
    position("type_unknown", "found", "type", "VEC9")
    position("type_missing", "found", "type", DELETE)
    position("component_unknown", "found", "componentType", 9999)
    position("component_double", "found", "componentType", 5130)
    position("component_negative", "found", "componentType", -1)
    position("of_a_view_that_is_missing", "found", "bufferView", 99)
    position("of_a_view_negative", "found", "bufferView", -2)
    for power in (27, 30):
        model = changed([*ACCESSOR, "bufferView"], DELETE, changed([*ACCESSOR, "count"], 1 << power))
        case(f"accessor_of_zeros_2_to_{power}.gltf", "found", model.gltf())
    case("accessor_bounds_that_lie.gltf", PICTURE,
         changed([*ACCESSOR, "min"], [9, 9, 9], changed([*ACCESSOR, "max"], [-9, -9, -9])).gltf())
    view("beyond_its_buffer", "buffer", "byteLength", 1 << 20)
    view("offset_beyond_its_buffer", "buffer", "byteOffset", 1 << 20)
    view("offset_and_length_overflow", "found", "byteOffset", (1 << 64) - 16)
    view("length_negative", "found", "byteLength", -1)
    view("length_missing", "found", "byteLength", DELETE)
    view("of_a_buffer_that_is_missing", "found", "buffer", 7)
    view("stride_1", "byteStride", "byteStride", 1)
    view("stride_4", "byteStride", "byteStride", 4)
    view("stride_2_to_31", "found", "byteStride", 1 << 31)
    view("stride_negative", "found", "byteStride", -12)
    view("stride_0", PICTURE, "byteStride", 0)
    for name, length in (("0", 0), ("minus_1", -1), ("2_to_63", 1 << 63), ("1.5", 1.5)):
        text = quad().gltf().decode()
        at = text.rindex('"byteLength":')
        end = text.index(",", at)
        case(f"buffer_length_{name}.gltf", "byteLength" if name != "2_to_63" else "found",
             text[:at] + f'"byteLength":{length}' + text[end:])
    case("buffer_2_gib_in_a_small_file.gltf", "found", quad().gltf().replace(
        b'"byteLength":%d,"uri"' % len(quad().data), b'"byteLength":2147483647,"uri"'))


def sparse(**changes):
    model = Model()
    position = model.accessor(QUAD)
    places = model.view(struct.pack("<2H", *changes.get("places", (1, 3))))
    values = model.view(struct.pack("<6f", 5, 0, 0, 0, 5, 0))
    model.json["accessors"][position]["sparse"] = {
        "count": changes.get("count", 2),
        "indices": {"bufferView": changes.get("view", places), "componentType": changes.get("component", U16)},
        "values": {"bufferView": values},
    }
    model.mesh({"POSITION": position})
    return model


def sparse_accessors():
    case("sparse_index_out_of_range.gltf", "sparse", sparse(places=(1, 4)).gltf())
    case("sparse_index_65535.gltf", "sparse", sparse(places=(1, 65535)).gltf())
    case("sparse_indices_out_of_order.gltf", PICTURE, sparse(places=(3, 1)).gltf())
    case("sparse_count_over_its_values.gltf", "bufferView", sparse(count=3).gltf())
    case("sparse_count_2_to_31.gltf", "found", sparse(count=1 << 31).gltf())
    case("sparse_count_negative.gltf", "found", sparse(count=-1).gltf())
    case("sparse_view_missing.gltf", "found", sparse(view=99).gltf())
    case("sparse_indices_of_float.gltf", "FLOAT", sparse(component=FLOAT).gltf())
