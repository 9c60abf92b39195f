"""Trees of nodes, instances and skins that do not end or do not fit."""

from lib.hostile.cases import PICTURE, case, quad
from lib.small_gltf import FLOAT, IDENTITY, QUAD, U8, Model


def chain(length):
    return [{"children": [i + 1]} for i in range(length - 1)] + [{"mesh": 0}]


def nodes():
    def tree(name, expected, *nodes, **members):
        model = quad()
        model.json["nodes"] = list(nodes)
        model.json.update(members)
        case(f"{name}.gltf", expected, model.gltf())

    tree("nodes_in_a_cycle", "descendants", {"children": [1]}, {"children": [2]}, {"children": [0], "mesh": 0})
    tree("node_its_own_child", "descendants", {"children": [0], "mesh": 0})
    tree("node_with_two_parents", "one parent", {"children": [2]}, {"children": [2]}, {"mesh": 0})
    tree("nodes_that_double_at_every_step", "one parent", *[{"children": [i + 1, i + 1]} for i in range(60)],
         {"mesh": 0})
    tree("node_chain_100000_long", PICTURE, *chain(100000))
    tree("nodes_300000_beside_each_other", PICTURE, {"mesh": 0}, *[{}] * 300000)
    tree("node_child_out_of_range", "found", {"children": [5], "mesh": 0})
    tree("node_child_negative", "found", {"children": [-1], "mesh": 0})
    tree("node_children_no_list", PICTURE, {"children": 1, "mesh": 0})
    tree("node_mesh_out_of_range", "mesh", {"mesh": 4})
    tree("node_mesh_negative", "found", {"mesh": -4})
    tree("node_twice_in_the_scene", "twice", {"mesh": 0}, scenes=[{"nodes": [0, 0]}])
    tree("node_of_the_scene_missing", "found", {"mesh": 0}, scenes=[{"nodes": [8]}])
    tree("matrix_of_zeros", PICTURE, {"mesh": 0, "matrix": [0] * 15 + [1]})
    tree("matrix_singular", PICTURE, {"mesh": 0, "matrix": [1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]})
    tree("matrix_projective", "last row", {"mesh": 0, "matrix": [*IDENTITY[:3], 0.5, *IDENTITY[4:]]})
    tree("matrix_without_homogeneous_one", "last row", {"mesh": 0, "matrix": [0] * 16})
    tree("matrix_of_15_numbers", "found", {"mesh": 0, "matrix": IDENTITY[:15]})
    tree("matrix_of_nulls", PICTURE, {"mesh": 0, "matrix": [None] * 16})
    tree("matrix_of_1e300", "finite", {"children": [1], "matrix": [1e300 * x for x in IDENTITY[:15]] + [1]},
         {"mesh": 0, "matrix": [1e300 * x for x in IDENTITY[:15]] + [1]})
    tree("scale_sheared_out_of_range", "finite", {"mesh": 0, "scale": [1e300, 1, 1]})
    tree("scale_of_zero", PICTURE, {"mesh": 0, "scale": [0, 0, 0]})
    tree("scale_of_1e-300", PICTURE, {"mesh": 0, "scale": [1e-300] * 3})
    tree("rotation_of_zero", PICTURE, {"mesh": 0, "rotation": [0, 0, 0, 0]})
    tree("rotation_of_three", "found", {"mesh": 0, "rotation": [0, 0, 0]})
    tree("translation_of_1e308", "finite", {"mesh": 0, "translation": [1e308, 0, 0]})
    tree("node_name_with_newline", "found", {"mesh": 5, "name": "a\nb\u001b[31m"})

    def cameras(name, expected, camera):
        tree(name, expected, {"mesh": 0}, {"camera": 0}, cameras=[camera])

    for name, angle in (("0", 0), ("minus_1", -1), ("4", 4), ("1e308", 1e308), ("null", None)):
        expected = "found" if angle is None else PICTURE
        cameras(f"camera_yfov_{name}", expected, {"type": "perspective", "perspective": {"yfov": angle, "znear": 0.1}})
    cameras("camera_ymag_0", PICTURE,
            {"type": "orthographic", "orthographic": {"xmag": 0, "ymag": 0, "znear": 0, "zfar": 1}})
    cameras("camera_of_no_type", "found", {"type": "fisheye"})
    tree("camera_out_of_range", "camera", {"mesh": 0}, {"camera": 3})


def instances():
    def instanced(name, expected, attributes, node=None, accessors=()):
        model = quad()
        model.json["accessors"] += accessors
        model.json["nodes"] = [{"mesh": 0, "extensions": {"EXT_mesh_gpu_instancing": {"attributes": attributes}},
                                **(node or {})}]
        case(f"{name}.gltf", expected, model.gltf())

    zeros = {"componentType": FLOAT, "type": "VEC3"}
    instanced("instances_2_to_24_of_zeros", "found", {"TRANSLATION": 2}, None, [{**zeros, "count": 1 << 24}])
    instanced("instances_2_to_20_of_zeros_sheared", "found", {"TRANSLATION": 2}, {"scale": [1, 2, 1]},
              [{**zeros, "count": 1 << 20}])
    instanced("instances_differ_in_number", "found", {"TRANSLATION": 0, "SCALE": 2}, None, [{**zeros, "count": 3}])
    instanced("instances_of_no_accessor", "found", {"TRANSLATION": 99})
    instanced("instances_of_nothing", PICTURE, {})
    instanced("instances_attributes_no_object", PICTURE, [1, 2])


def skins():
    def skinned(name, expected, skin, joints=((0, 1, 0, 0),) * 4, weights=((0.5, 0.5, 0, 0),) * 4, drop=None):
        model = Model(nodes=[{"mesh": 0, "skin": 0}, {"children": [2]}, {"rotation": [0, 0, 1, 0]}])
        attributes = {"POSITION": model.accessor(QUAD), "JOINTS_0": model.accessor(joints, U8),
                      "WEIGHTS_0": model.accessor(weights), "INVERSE": model.accessor([IDENTITY] * 2)}
        inverse = attributes.pop("INVERSE")
        attributes.pop(drop, None)
        model.mesh(attributes)
        if skin is not None:
            model.json["skins"] = [{"inverseBindMatrices": inverse, **skin}]
        case(f"{name}.gltf", expected, model.gltf())

    skinned("skin_missing", "skin", None)
    skinned("skin_joint_node_missing", "joint", {"joints": [1, 9]})
    skinned("skin_joint_negative", "found", {"joints": [1, -9]})
    skinned("skin_without_joints", "found", {"joints": []})
    skinned("skin_vertex_joint_out_of_range", "JOINTS_0", {"joints": [1, 2]}, [(0, 200, 0, 0)] * 4)
    skinned("skin_weights_nan", PICTURE, {"joints": [1, 2]}, weights=[(float("nan"),) * 4] * 4)
    skinned("skin_weights_zero", PICTURE, {"joints": [1, 2]}, weights=[(0, 0, 0, 0)] * 4)
    skinned("skin_weights_negative", PICTURE, {"joints": [1, 2]}, weights=[(-1, 2, 0, 0)] * 4)
    skinned("skin_weights_missing", "WEIGHTS_0", {"joints": [1, 2]}, drop="WEIGHTS_0")
    skinned("skin_with_too_few_matrices", "inverse bind", {"joints": [1, 2, 0]})
    skinned("skin_matrices_of_positions", "MAT4", {"joints": [1, 2], "inverseBindMatrices": 0})
