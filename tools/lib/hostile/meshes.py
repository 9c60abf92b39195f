"""Indices, attributes and positions that make no surface, or too much of one."""

import random
from math import cos, pi, sin

from lib.hostile.cases import DELETE, INDEX, PICTURE, case, changed, quad, with_positions
from lib.small_gltf import FACES, FLOAT, QUAD, U8, U16, U32, Model


def meshes():
    for component, restart in ((U8, 255), (U16, 65535), (U32, 0xFFFFFFFF)):
        case(f"index_is_restart_value_{restart}.gltf", "restart",
             quad(indices=[0, 1, 2, restart, 0, 2], component=component).gltf())
    case("index_out_of_range.gltf", "below 4", quad(indices=[0, 1, 4]).gltf())
    case("indices_of_float.gltf", "FLOAT", changed([*INDEX, "componentType"], FLOAT).gltf())
    case("indices_of_bytes_with_sign.gltf", "found", changed([*INDEX, "componentType"], 5120).gltf())
    model = changed([*INDEX, "bufferView"], DELETE, changed([*INDEX, "count"], 1 << 30))
    case("indices_of_zeros_2_to_30.gltf", "without data", model.gltf())
    case("indices_normalized.gltf", "normalized", changed([*INDEX, "normalized"], True).gltf())
    case("indices_none.gltf", "found", changed([*INDEX, "count"], 0).gltf())
    case("indices_five.gltf", PICTURE, changed([*INDEX, "count"], 5).gltf())
    case("indices_of_an_accessor_that_is_missing.gltf", "found",
         changed(["meshes", 0, "primitives", 0, "indices"], 9).gltf())
    case("position_missing.gltf", "triangle",
         changed(["meshes", 0, "primitives", 0, "attributes"], {"NORMAL": 0}).gltf())
    case("position_of_indices.gltf", "POSITION",
         changed(["meshes", 0, "primitives", 0, "attributes"], {"POSITION": 1}).gltf())
    case("position_of_an_accessor_that_is_missing.gltf", "POSITION",
         changed(["meshes", 0, "primitives", 0, "attributes"], {"POSITION": 1 << 31}).gltf())
    case("attributes_empty.gltf", "found", changed(["meshes", 0, "primitives", 0, "attributes"], {}).gltf())
    case("primitives_empty.gltf", "found", changed(["meshes", 0, "primitives"], []).gltf())
    for mode in (-1, 7, 1 << 31):
        case(f"mode_{mode}.gltf", "mode", changed(["meshes", 0, "primitives", 0, "mode"], mode).gltf())
    case("mode_points.gltf", "triangle", changed(["meshes", 0, "primitives", 0, "mode"], 0).gltf())
    normals = Model()
    normals.mesh({"POSITION": normals.accessor(QUAD), "NORMAL": normals.accessor(QUAD[:3])})
    case("normals_too_few.gltf", "NORMAL", normals.gltf())
    for name, value in (("zero", 0.0), ("nan", float("nan")), ("infinite", float("inf"))):
        model = Model()
        model.mesh({"POSITION": model.accessor(QUAD), "NORMAL": model.accessor([(value,) * 3] * 4)})
        case(f"normals_{name}.gltf", PICTURE, model.gltf())
    shared = Model()
    shared.mesh({"POSITION": shared.accessor([QUAD[i % 4] for i in range(30000)])}, None)
    shared.json["meshes"][0]["primitives"] *= 20000
    case("mesh_of_20000_primitives_of_one_big_accessor.glb", "small a file", shared.glb())
    targets = Model()
    targets.mesh(targets=[{"POSITION": targets.accessor(QUAD[:2])}], weights=[1.0])
    case("target_too_short.gltf", "target 0", targets.gltf())
    case("target_weight_1e308.gltf", "finite", changed(["meshes", 0, "weights"], [1e308],
         changed(["meshes", 0, "primitives", 0, "targets"], [{"POSITION": 0}])).gltf())
    case("target_missing.gltf", "found", changed(["meshes", 0, "weights"], [1.0],
         changed(["meshes", 0, "primitives", 0, "targets"], [{"POSITION": 77}])).gltf())


def coordinates():
    nan, inf, tiny = float("nan"), float("inf"), 1e-45
    case("position_nan.gltf", "finite", with_positions([(0, 0, 0), (1, 0, 0), (0, nan, 0)]).gltf())
    case("position_infinite.gltf", "finite", with_positions([(0, 0, 0), (1, 0, 0), (0, -inf, 0)]).gltf())
    case("position_minus_zero.gltf", PICTURE, with_positions([(-0.0, 0, -0.0), (1, -0.0, 0), (0, 1, -0.0)]).gltf())
    case("positions_denormal.gltf", PICTURE, with_positions([(0, 0, 0), (9 * tiny, 0, 0), (0, 9 * tiny, 0)]).gltf())
    case("positions_1e-30.gltf", PICTURE, with_positions([(0, 0, 0), (1e-30, 0, 0), (0, 1e-30, 0)]).gltf())
    case("positions_1e38.gltf", PICTURE, with_positions([(0, 0, 0), (1e38, 0, 0), (0, 1e38, 0)]).gltf())
    case("positions_to_both_ends.gltf", PICTURE,
         with_positions([(-3.4e38, 0, 0), (3.4e38, 0, 0), (0, 3.4e38, 0)]).gltf())
    case("positions_1e38_and_1e-38.gltf", PICTURE,
         with_positions([(0, 0, 0), (1e38, 0, 0), (0, 1e-38, 0), (0, 0, 0), (1, 0, 0), (0, 1, 0)]).gltf())
    case("positions_far_from_the_origin.gltf", PICTURE,
         with_positions([(1e30, 0, 0), (1e30, 1, 0), (1e30, 0, 1)]).gltf())
    case("positions_identical.gltf", PICTURE, with_positions([(1, 2, 3)] * 30).gltf())
    case("position_repeated_by_every_index.gltf", "triangle", with_positions([(1, 2, 3)], [0] * 300).gltf())
    case("positions_on_a_line.gltf", PICTURE, with_positions([(i, i, i) for i in range(12)]).gltf())
    case("positions_in_a_plane.gltf", PICTURE, with_positions([(i % 7, i * i % 5, 0) for i in range(300)]).gltf())
    toward = (cos(pi / 9) * sin(pi / 6), sin(pi / 9), cos(pi / 9) * cos(pi / 6))  # the eye of the default view
    case("triangle_edge_on.gltf", PICTURE, with_positions([(0, 0, 0), (0, 1, 0), toward]).gltf())
    many = [(0, 0, 0), (1, 0, 0)] + [(0.5, cos(i), sin(i)) for i in range(3000)]
    case("faces_3000_on_one_edge.glb", PICTURE,
         with_positions(many, [k for i in range(3000) for k in (0, 1, i + 2)]).glb())
    case("faces_10000_times_the_same.glb", PICTURE, with_positions(QUAD, FACES * 10000).glb())
    noise = random.Random(1)
    triangles = [[noise.uniform(-1, 1) for _ in range(3)] for _ in range(60000)]
    case("faces_20000_in_each_others_way.glb", PICTURE, with_positions(triangles).glb())
    case("faces_20000_in_each_others_way_in_a_plane.glb", PICTURE,
         with_positions([(x, y, 0) for x, y, _ in triangles]).glb())
    strips = [p for i in range(20000) for p in ((0, i, 0), (1000, i, 0), (1000, i + 0.7, 0.5 * (i % 2)))]
    case("faces_20000_long_and_side_by_side.glb", PICTURE, with_positions(strips).glb())
    layers = [(x + i * 1e-3, y, 0) for i in range(3000) for x, y in ((0, 0), (1, 0), (0, 1))]
    case("faces_3000_over_each_other_in_a_plane.glb", PICTURE, with_positions(layers).glb())
