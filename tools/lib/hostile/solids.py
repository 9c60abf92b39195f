"""3MF and implicit surfaces."""

import struct
import zipfile

from lib.hostile.cases import PICTURE, case
from lib.small_3mf import BUILD, MODEL_FILE, archive, cube, files, model

DIRECTORY_ENTRY = b"PK\1\2"
FILE_HEAD = b"PK\3\4"
DIRECTORY_END = b"PK\5\6"


def with_number(content, signature, offset, form, value):
    """The last record of a kind in an archive says something else."""
    at = content.rindex(signature) + offset
    return content[:at] + struct.pack(form, value) + content[at + struct.calcsize(form):]


def with_entry_twice(content):
    begin, end = content.rindex(DIRECTORY_ENTRY), content.rindex(DIRECTORY_END)
    count, size = struct.unpack_from("<HI", content, end + 10)
    tail = bytearray(content[end:])
    struct.pack_into("<HHI", tail, 8, count + 1, count + 1, size + end - begin)
    return content[:end] + content[begin:end] + bytes(tail)


def archives():
    def packed(name, expected, content):
        case(f"3mf_{name}.3mf", expected, content)

    cubes = files(model(cube(1)))
    good = archive(cubes)
    packed("cube", PICTURE, good)
    packed("empty", "empty", b"")
    packed("words", "a ZIP archive", "solid?\n")
    packed("magic_number_alone", "cut short", b"PK\3\4")
    packed("cut_in_half", "cut short", good[: len(good) // 2])
    packed("cut_in_its_directory", "cut short", good[:-30])
    packed("of_zeros", "cut short", b"PK\3\4" + bytes(100000))
    packed("zeros_within", "found", good[:900] + bytes(100) + good[1000:])
    packed("of_nothing", "[Content_Types].xml", archive({}))
    packed("of_a_picture", "[Content_Types].xml", archive({"a.png": "no picture"}))
    packed("by_bzip2", "method 12", archive(cubes, zipfile.ZIP_BZIP2))
    packed("entries_65534", "entries", with_number(good, DIRECTORY_END, 10, "<H", 65534))
    packed("entries_none", "found", with_number(good, DIRECTORY_END, 10, "<H", 0))
    packed("directory_beyond_its_end", "entries", with_number(good, DIRECTORY_END, 16, "<I", 0xFFFFFF00))
    packed("directory_in_its_own_end", "entries", with_number(good, DIRECTORY_END, 16, "<I", len(good) - 22))
    packed("size_4_gb", "max-file-size", with_number(good, DIRECTORY_ENTRY, 24, "<I", 0xFFFFFFFE))
    packed("size_1_gb", "1073741824 bytes", with_number(good, DIRECTORY_ENTRY, 24, "<I", 1 << 30))
    packed("size_100_bytes", "found more", with_number(good, DIRECTORY_ENTRY, 24, "<I", 100))
    packed("size_0", "found more", with_number(good, DIRECTORY_ENTRY, 24, "<I", 0))
    packed("packed_size_4_gb", "a part of a ZIP archive", with_number(good, DIRECTORY_ENTRY, 20, "<I", 0xFFFFFFF0))
    packed("sum_wrong", "found", with_number(good, DIRECTORY_ENTRY, 16, "<I", 1))
    packed("encrypted", "found", with_number(with_number(good, DIRECTORY_ENTRY, 8, "<H", 1), FILE_HEAD, 6, "<H", 1))
    packed("blanks_128_mb", "found", archive(files(model(cube(1) + " " * (1 << 27)))))
    packed("entry_twice", PICTURE, with_entry_twice(good))
    packed("entries_60000", PICTURE, archive({**cubes, **{f"Metadata/{i}": "" for i in range(60000)}}))

    def without(name, part):
        packed(f"without_{name}", "found", archive({n: text for n, text in cubes.items() if n != part}))

    def relation(name, old, new):
        rels = cubes["_rels/.rels"]
        assert old in rels, old
        packed(f"relation_{name}", "found", archive({**cubes, "_rels/.rels": rels.replace(old, new)}))

    without("types", "[Content_Types].xml")
    without("relations", "_rels/.rels")
    without("a_model", MODEL_FILE)
    relation("no_xml", "<", "(")
    relation("to_nothing", "3dmodel.model", "other.model")
    relation("outside", "/3D/3dmodel.model", "/../../../../etc/passwd")
    relation("of_another_type", "3dmodel\"", "teapot\"")


def models():
    def root(name, expected, text):
        case(f"3mf_{name}.3mf", expected, archive(files(text)))

    def inside(name, expected, resources, build=BUILD):
        root(name, expected, model(resources, build))

    triangle = '<triangle v1="{}" v2="{}" v3="{}"/>'.format
    vertex = '<vertex x="{}" y="{}" z="{}"/>'.format

    def with_triangle(*corners):
        return cube(1).replace("</triangles>", triangle(*corners) + "</triangles>")

    def with_vertex(*position):
        return cube(1).replace(vertex(10, 10, 10), vertex(*position))

    root("model_empty", "found", "")
    root("model_words", "found", "hello")
    root("model_of_zeros", "found", "\0" * 1000)
    root("model_cut_off", "found", model(cube(1))[:400])
    root("model_cut_in_a_tag", "found", model(cube(1))[: model(cube(1)).index("<triangle ") + 5])
    root("model_not_utf8", "found", model(cube(1)).encode().replace(b"<vertices>", b"<\xff\xfe>"))
    root("model_another_root", "found", "<svg xmlns='http://www.w3.org/2000/svg'/>")
    root("model_without_namespace", PICTURE, model(cube(1)).replace("xmlns=", "xmlms="))
    root("unit_unknown", PICTURE, model(cube(1), unit="ell"))
    root("extension_required_unknown", "found", model(cube(1)).replace("<model ", '<model requiredextensions="acme" '))
    root("elements_100000_deep", PICTURE, model(cube(1) + "<metadatagroup>" * 100000))
    laughs = "".join(f'<!ENTITY a{i} "{f"&a{i - 1};" * 10}">' for i in range(1, 10))
    root("entities_of_entities", "found", f'<!DOCTYPE model [<!ENTITY a0 "ha">{laughs}]>'
         + model(cube(1)).replace("<resources>", "<metadata name='a'>&a9;</metadata><resources>"))
    root("attribute_of_16_mb", "found", model(cube(1).replace('id="1"', f'id="1" name="{"x" * (16 << 20)}"')))
    inside("nothing_built", "that no item builds", cube(1), build="<build/>")
    inside("without_build", "found", cube(1), build="")
    inside("item_of_nothing", "found", cube(2))
    inside("item_number_0", "found", cube(0), build='<build><item objectid="0"/></build>')
    inside("item_number_a_word", "found", cube(1), build='<build><item objectid="one"/></build>')
    inside("items_5000", PICTURE, cube(1), build="<build>" + '<item objectid="1"/>' * 5000 + "</build>")
    inside("object_twice", "found", cube(1) + cube(1))
    inside("object_without_a_mesh", "found", '<object id="1" type="model"/>')
    inside("object_of_an_unknown_type", PICTURE, cube(1).replace('type="model"', 'type="ghost"'))
    for name, transform in (("of_11_numbers", "1 " * 11), ("of_words", "a " * 12), ("nan", "nan " * 12),
                            ("1e39", "1e39 " * 12)):
        inside(f"transform_{name}", "found", cube(1), f'<build><item objectid="1" transform="{transform}"/></build>')
    inside("transform_of_zeros", PICTURE, cube(1), f'<build><item objectid="1" transform="{"0 " * 12}"/></build>')
    inside("transform_1e30", PICTURE, cube(1),
           '<build><item objectid="1" transform="1e30 0 0 0 1e30 0 0 0 1e30 0 0 0"/></build>')

    inside("vertices_none", "found", cube(1, places=[]))
    inside("triangles_none", "found", cube(1, corners=[]))
    inside("index_over", "found", with_triangle(0, 1, 8))
    inside("index_negative", "found", with_triangle(0, 1, -2))
    inside("index_2_to_32", "found", with_triangle(0, 1, 4294967296))
    inside("index_a_fraction", "found", with_triangle(0, 1, 2.5))
    inside("index_a_word", "found", with_triangle(0, 1, "two"))
    inside("index_missing", "found", cube(1).replace('v3="', 'w3="'))
    inside("index_twice", "found", with_triangle(0, 1, 1))
    inside("position_nan", "found", with_vertex(10, 10, "nan"))
    inside("position_inf", "found", with_vertex(10, 10, "inf"))
    inside("position_1e39", "found", with_vertex(10, 10, "1e39"))
    inside("position_1e30", "found", with_vertex(10, 10, "1e30"))
    inside("position_a_word", PICTURE, with_vertex(10, 10, "ten"))
    inside("position_of_two", "found", cube(1).replace('z="10"', ""))
    inside("points_all_the_same", PICTURE, cube(1).replace('"10"', '"0"'))
    inside("triangles_repeated", PICTURE, cube(1).replace("<triangles>", "<triangles>" + triangle(0, 1, 2) * 100000))
    inside("pid_of_nothing", PICTURE, cube(1).replace('id="1"', 'id="1" pid="7" pindex="0"'))
    base = '<basematerials id="7"><base name="red" displaycolor="#FF0000"/></basematerials>'
    inside("pindex_over", "found", base + cube(1).replace('id="1"', 'id="1" pid="7" pindex="9"'))
    inside("colour_a_word", PICTURE, base.replace("#FF0000", "red") + cube(1))


def components():
    def tree(name, expected, resources, root=1):
        text = model(resources, f'<build><item objectid="{root}"/></build>')
        case(f"3mf_components_{name}.3mf", expected, archive(files(text)))

    def assembly(number, *of):
        return (f'<object id="{number}" type="model"><components>'
                + "".join(f'<component objectid="{i}"/>' for i in of) + "</components></object>")

    tree("of_itself", "found", assembly(1, 1))
    tree("of_each_other", "found", assembly(1, 2) + assembly(2, 1))
    tree("of_nothing", "found", assembly(1, 9))
    tree("none", "found", assembly(1))
    tree("of_a_later_object", "found", assembly(1, 2) + cube(2))
    for depth, expected in ((50, PICTURE), (1000, "deep"), (3000, "deep")):
        chain = cube(1) + "".join(assembly(i + 1, i) for i in range(1, depth + 1))
        tree(f"{depth}_deep", expected, chain, depth + 1)
    for count in (22, 40):
        doubled = "".join(assembly(i + 1, i, i) for i in range(1, count + 1))
        tree(f"doubled_{count}_times", "raise", cube(1) + doubled, count + 1)
        tree(f"of_components_alone_doubled_{count}_times", "raise", assembly(1) + doubled, count + 1)


BOUNDS = "bounds -1 -1 -1 1 1 1\n"
BALL = "f = x^2 + y^2 + z^2 - 0.5\n"


def implicits():
    def implicit(name, expected, text):
        case(f"implicit_{name}.implicit", expected, text)

    def of(name, expected, expression, bounds=BOUNDS):
        implicit(name, expected, f"{bounds}f = {expression}\n")

    implicit("ball", PICTURE, BOUNDS + BALL)
    implicit("empty", "empty", "")
    implicit("comment_alone", "a line of bounds", "# nothing\n")
    implicit("binary", "found", bytes(range(1, 256)) * 20)
    implicit("zero_bytes", "found", BOUNDS + BALL + "\0" * 100)
    implicit("utf16", "found", (BOUNDS + BALL).encode("utf-16"))
    implicit("without_f", "a line of f", BOUNDS)
    implicit("without_bounds", "a line of bounds", BALL)
    implicit("f_empty", "found", BOUNDS + "f =\n")
    implicit("f_twice", "each once", BOUNDS + BALL + BALL)
    implicit("key_unknown", "each once", BOUNDS + "colour red\n" + BALL)
    implicit("bounds_twice", "bounds once", BOUNDS + BOUNDS + BALL)
    implicit("bounds_of_five", "six numbers", "bounds 0 0 0 1 1\n" + BALL)
    implicit("bounds_of_seven", "six numbers", "bounds 0 0 0 1 1 1 1\n" + BALL)
    implicit("bounds_reversed", "less than", "bounds 1 1 1 -1 -1 -1\n" + BALL)
    implicit("bounds_flat", "less than", "bounds 0 0 0 1 1 0\n" + BALL)
    implicit("bounds_nan", "six numbers", "bounds nan -1 -1 1 1 1\n" + BALL)
    implicit("bounds_inf", "six numbers", "bounds -inf -1 -1 1 1 1\n" + BALL)
    implicit("bounds_1e300", "six numbers", "bounds -1e300 -1 -1 1 1 1\n" + BALL)
    implicit("bounds_1e29", PICTURE, "bounds -1e29 -1e29 -1e29 1e29 1e29 1e29\n" + BALL)
    of("ball_of_1e29", PICTURE, "x^2 + y^2 + z^2 - 1e57", "bounds -1e29 -1e29 -1e29 1e29 1e29 1e29\n")
    of("ball_of_1e-30", PICTURE, "1e60*(x^2 + y^2 + z^2) - 1", "bounds -2e-30 -2e-30 -2e-30 2e-30 2e-30 2e-30\n")
    of("far_off", PICTURE, "(x - 1e9)^2 + y^2 + z^2 - 0.5", "bounds 1e9 -1 -1 1000000000.0000001 1 1\n")
    of("thin_bounds", PICTURE, "y", "bounds 0 -1e9 0 1e-9 1e9 1e-9\n")
    of("flat_bounds", PICTURE, "x^2 + y^2 - 1", "bounds -2 -2 0 2 2 1e-9\n")
    implicit("unit_unknown", "one of", BOUNDS + "unit ell\n" + BALL)
    implicit("unit_without_a_name", "one of", BOUNDS + "unit\n" + BALL)
    of("misses_the_bounds", "over 0 everywhere", "x^2 + y^2 + z^2 + 1")
    of("zero_everywhere", "found", "0")
    of("of_a_constant", "over 0 everywhere", "5")
    of("not_finite_everywhere", "finite", "1/0")
    of("not_finite_in_a_place", "finite", "x/y")
    of("not_finite_on_one_side", "finite", "sqrt(x)")
    of("not_finite_between", PICTURE, "ln(abs(x - 0.3))")
    of("overflows", "finite", "exp(exp(exp(9 + x)))")
    of("jumps", PICTURE, "x < 0.1 ? -1 : 1")
    of("noise", "max-vertices", "sin(1e9*x*y + 3e9*z)")
    of("function_unknown", "an expression", "teapot(x)")
    of("variable_unknown", "an expression", "x + w")
    of("value_a_text", "an expression", '"x"')
    of("assigns", "found", "x = 3")
    of("two_values", "one value", "x, y")
    of("of_operators", "an expression", "x ++-- y")
    of("of_commas", "an expression", "max(,,,)")
    of("of_brackets", "an expression", "(" * 9000)
    of("brackets_4900_deep", PICTURE, "(" * 4900 + "x" + ")" * 4900)
    of("questions_200_deep", PICTURE, "x<2?" * 200 + "x" + ":1" * 200)
    of("functions_200_deep", PICTURE, "sin(" * 200 + "x" + ")" * 200)
    of("powers_of_powers", "finite", "2^" * 300 + "x")
    of("minus_of_minus", "found", "-" * 9000 + "x")
    of("sum_of_500", PICTURE, "x" + "+x" * 500)
    of("number_of_9000_digits", PICTURE, "x - 0." + "1" * 9000)
    of("expression_of_1_mb", "10000 characters", "x" + "+x" * (1 << 19))
    implicit("lines_1000000", "found", BOUNDS + "f = x\n" + " + x\n" * 1000000)
    implicit("line_of_16_mb", PICTURE, BOUNDS + BALL + "# " + "x" * (16 << 20))
    implicit("comments_1000000", PICTURE, "#\n" * 1000000 + BOUNDS + BALL)
