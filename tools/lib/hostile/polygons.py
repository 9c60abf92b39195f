"""OBJ, STL and PLY."""

import struct
from math import cos, pi, sin

from lib.hostile.cases import PICTURE, case

TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"


def ring(count):
    return "".join(f"v {cos(2 * pi * i / count):.9f} {sin(2 * pi * i / count):.9f} 0\n" for i in range(count))


def comb(count):
    """A polygon whose every other corner lies deep inside: ears are far to seek."""
    return "".join(f"v {i} {0 if i % 2 else 100 + i % 7} 0\n" for i in range(count)) + f"v {count} -1 0\nv 0 -1 0\n"


def objs():
    def obj(name, expected, text):
        case(f"{name}.obj", expected, text)

    obj("obj_empty", "empty", "")
    obj("obj_comment_alone", "faces", "# nothing\n")
    obj("obj_points_alone", "triangle", TRIANGLE + "p 1 2 3\n")
    obj("obj_index_0", "line 4", TRIANGLE + "f 0 1 2\n")
    obj("obj_index_minus_4", "line 4", TRIANGLE + "f -4 1 2\n")
    obj("obj_index_over", "from 1 to 3", TRIANGLE + "f 1 2 4\n")
    obj("obj_index_2_to_32", "from 1 to 3", TRIANGLE + "f 1 2 4294967297\n")
    obj("obj_index_2_to_64", "found", TRIANGLE + "f 1 2 18446744073709551617\n")
    obj("obj_index_a_fraction", "found", TRIANGLE + "f 1 2 2.5\n")
    obj("obj_index_of_slashes", "found", TRIANGLE + "f 1/2/3/4 2 3\n")
    obj("obj_normal_over", "a normal", TRIANGLE + "f 1//1 2//1 3//1\n")
    obj("obj_face_of_two", PICTURE, TRIANGLE + "f 1 2\n")
    obj("obj_face_of_one_vertex", PICTURE, TRIANGLE + "f 1 1 1\n")
    obj("obj_position_nan", "finite", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    obj("obj_position_1e39", "finite", "v 1e39 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    obj("obj_position_1e38", PICTURE, "v 1e38 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    obj("obj_position_of_two", "line 1", "v 0 0\n")
    obj("obj_zero_bytes", "zero byte", TRIANGLE + "f 1 2 3\n" + "\0" * 100)
    obj("obj_binary", "found", bytes(range(1, 256)) * 20)
    obj("obj_line_of_16_mb", PICTURE, TRIANGLE + "f 1 2 3\n# " + "x" * (16 << 20))
    obj("obj_lines_joined_without_end", PICTURE, TRIANGLE + "f 1 2 3\n" + "\\\n" * 200000)
    obj("obj_ends_in_a_backslash", PICTURE, TRIANGLE + "f 1 2 3 \\")
    obj("obj_with_carriage_returns", PICTURE, (TRIANGLE + "f 1 2 3\n").replace("\n", "\r\n"))
    obj("obj_polygon_of_1000000_corners_at_one_point", PICTURE, TRIANGLE + "f " + "1 " * 1000000 + "2 3\n")
    obj("obj_polygon_of_3000_corners", PICTURE, ring(3000) + "f " + " ".join(map(str, range(1, 3001))) + "\n")
    obj("obj_polygon_of_100000_corners", PICTURE, ring(100000) + "f " + " ".join(map(str, range(1, 100001))) + "\n")
    obj("obj_polygon_a_comb", PICTURE, comb(3000) + "f " + " ".join(map(str, range(1, 3003))) + "\n")
    obj("obj_polygons_of_one_line", PICTURE, TRIANGLE + "f 1 2 3\n" + "f 1 2 1 2 1 2\n" * 1000)
    obj("obj_materials_100000", PICTURE, TRIANGLE + "".join(f"usemtl m{i}\nf 1 2 3\n" for i in range(100000)))
    obj("obj_material_library_outside", PICTURE,
        "mtllib ../../../../../../etc/passwd\nmtllib /dev/zero\n" + TRIANGLE + "f 1 2 3\n")
    obj("obj_includes_itself", PICTURE, "call obj_includes_itself.obj\n" + TRIANGLE + "f 1 2 3\n")
    obj("obj_utf16", "UTF-16 text", (TRIANGLE + "f 1 2 3\n").encode("utf-16"))


def facet(values):
    return struct.pack("<12fH", 0, 0, 1, *values, 0)


def stls():
    good = facet([0, 0, 0, 1, 0, 0, 0, 1, 0])
    text = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
    text += "endsolid a\n"
    case("stl_empty.stl", "empty", b"")
    case("stl_of_zeros.stl", "found", bytes(84))
    case("stl_header_cut.stl", "found", bytes(50))
    case("stl_of_2_to_32_triangles.stl", PICTURE, bytes(80) + b"\xff" * 4 + good)
    case("stl_of_one_more_triangle.stl", PICTURE, bytes(80) + struct.pack("<I", 2) + good)
    case("stl_with_more_after_its_end.stl", PICTURE, bytes(80) + struct.pack("<I", 1) + good * 2)
    case("stl_binary_named_solid.stl", PICTURE, b"solid".ljust(80, b" ") + struct.pack("<I", 1) + good)
    case("stl_position_nan.stl", "finite", bytes(80) + struct.pack("<I", 1) + facet([float("nan")] * 9))
    case("stl_text_cut_off.stl", "truncated", text[:60])
    case("stl_text_without_end.stl", PICTURE, text[: text.index("endsolid")])
    case("stl_text_word_wrong.stl", "facet 0", text.replace("outer", "inner"))
    case("stl_text_number_wrong.stl", "number", text.replace("vertex 1", "vertex one"))
    case("stl_text_position_1e39.stl", "finite", text.replace("vertex 1", "vertex 1e39"))
    case("stl_text_empty_solid.stl", "empty", "solid nothing\nendsolid nothing\n")
    case("stl_text_is_html.stl", "HTML", "<html></html>")
    case("stl_points_all_the_same.stl", PICTURE, bytes(80) + struct.pack("<I", 20) + facet([1] * 9) * 20)


def plys():
    def ply(name, expected, vertices="element vertex 3", faces="element face 1", data="0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
            list_type="uchar int", encoding="ascii", end="end_header\n", properties="xyz"):
        head = f"ply\nformat {encoding} 1.0\n{vertices}\n" + "".join(f"property float {p}\n" for p in properties)
        head += f"{faces}\nproperty list {list_type} vertex_indices\n{end}"
        case(f"ply_{name}.ply", expected, head.encode() + (data if isinstance(data, bytes) else data.encode()))

    binary = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)
    case("ply_empty.ply", "empty", b"")
    case("ply_of_one_word.ply", "end_header", "ply")
    ply("without_end_header", "end_header", end="", data="")
    ply("without_format", "format", encoding="ebcdic")
    ply("vertices_2_to_32", "found", vertices="element vertex 4294967296")
    ply("vertices_4_billion", "max-vertices", vertices="element vertex 4294967295")
    ply("vertices_negative", "found", vertices="element vertex -3")
    ply("vertices_too_many", "found", vertices="element vertex 4")
    ply("vertices_none", "found", vertices="element vertex 0")
    ply("vertices_twice", "twice", vertices="element vertex 3\nproperty float x\nelement vertex 3")
    ply("vertices_without_z", "property z", properties="xy")
    ply("faces_4_billion", "max-vertices", faces="element face 4294967295")
    ply("faces_twice", "found it twice",
        vertices="element face 0\nproperty list uchar int vertex_indices\nelement vertex 3")
    ply("list_of_4_billion", "max-vertices", data=binary + struct.pack("<I", 0xFFFFFFFF), list_type="uint int",
        encoding="binary_little_endian")
    ply("list_negative", "negative", data=binary + struct.pack("<i", -3), list_type="int int",
        encoding="binary_little_endian")
    ply("list_negative_in_text", "length", data="0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n")
    ply("list_of_floats", "integer", list_type="float int")
    ply("list_of_an_unknown_type", "type", list_type="uchar quaternion")
    ply("index_over", "below 3", data="0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n")
    ply("index_negative", "found", data="0 0 0\n1 0 0\n0 1 0\n3 0 1 -2\n")
    ply("position_nan", "finite", data="0 0 nan\n1 0 0\n0 1 0\n3 0 1 2\n")
    ply("position_a_word", "number", data="0 0 zero\n1 0 0\n0 1 0\n3 0 1 2\n")
    ply("binary_cut_off", "truncated", data=binary[:20], encoding="binary_big_endian")
    ply("text_cut_off", "truncated", data="0 0 0\n1 0")
    ply("property_before_element", "element", vertices="property float x\nelement vertex 3")
    ply("header_with_an_unknown_word", "line 3", vertices="elephant vertex 3")
    ply("elements_of_nothing_4_billion", "properties", vertices="element ghost 4294967295\nelement vertex 3")
    ply("strips", PICTURE, vertices="element vertex 4", faces="element tristrips 3", list_type="int int",
        data="0 0 0\n1 0 0\n0 1 0\n1 1 1\n4 0 1 2 3\n9 0 1 2 -1 1 2 3 -1 0\n1 2\n")
    ply("strip_index_over", "found", faces="element tristrips 1", data="0 0 0\n1 0 0\n0 1 0\n3 0 1 9\n")
    ply("points_alone", "triangle", faces="element face 0", data="0 0 0\n1 0 0\n0 1 0\n")
    ply("polygon_of_100000_corners", PICTURE, vertices="element vertex 100000", list_type="int int",
        data=ring(100000).replace("v ", "") + "100000 " + " ".join(map(str, range(100000))) + "\n")
