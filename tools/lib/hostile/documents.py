"""JSON that is damaged or not what glTF asks for."""

import json

from lib.hostile.cases import DELETE, PICTURE, case, changed, quad, text_with


def documents():
    case("json_lists_100000_deep.gltf", "deep",
         '{"asset":{"version":"2.0"},"extras":' + "[" * 100000 + "]" * 100000 + "}")
    case("json_objects_100000_deep.gltf", "deep", '{"a":' * 100000 + "1" + "}" * 100000)
    case("json_400_deep.gltf", PICTURE, text_with(quad(), '"asset"', '"extras":' + "[" * 400 + "]" * 400 + ',"asset"'))
    case("json_not_utf8.gltf", "JSON", quad().gltf().replace(b'"asset"', b'"\xff\xfe":1,"asset"'))
    case("json_cut_in_a_string.gltf", "JSON", quad().gltf()[:30])
    case("json_zero_byte.gltf", "JSON", quad().gltf().replace(b'"asset"', b'"a\0b":1,"asset"'))
    case("json_lone_surrogate.gltf", "JSON", text_with(quad(), '"asset"', r'"name":"\ud800","asset"'))
    case("json_number_1e999.gltf", "JSON", text_with(quad(), '"count":4', '"count":1e999'))
    case("json_trailing_text.gltf", "JSON", quad().gltf() + b" and more")
    case("json_key_twice.gltf", PICTURE, text_with(quad(), '"asset":', '"asset":{"version":"1.0"},"asset":'))
    case("json_string_of_8_mb.gltf", PICTURE, text_with(quad(), '"asset"', '"a":"' + "x" * (8 << 20) + '","asset"'))
    case("json_list_at_the_top.gltf", "found", "[1,2,3]")
    case("json_comments.gltf", "JSON", "{ // a comment\n}")
    case("asset_missing.gltf", "version", changed(["asset"], DELETE).gltf())
    case("asset_a_list.gltf", "version", changed(["asset"], [1]).gltf())
    case("version_1.gltf", "1.0", changed(["asset", "version"], "1.0").gltf())
    case("version_3.gltf", "3.0", changed(["asset", "version"], "3.0").gltf())
    case("version_a_number.gltf", "version", changed(["asset", "version"], 2.0).gltf())
    case("version_minimum_2.1.gltf", "minVersion", changed(["asset", "minVersion"], "2.1").gltf())
    case("extension_required_unknown.gltf", "ACME_secret", changed(["extensionsRequired"], ["ACME_secret"]).gltf())
    case("extension_required_with_newline.gltf", "extensions", changed(["extensionsRequired"], ["a\nb"]).gltf())
    case("extensions_required_a_number.gltf", "extensionsRequired", changed(["extensionsRequired"], 7).gltf())
    for kind in ("accessors", "bufferViews", "buffers", "meshes", "nodes", "scenes"):
        for name, value in (("null", None), ("a_string", "x"), ("of_numbers", [1, 2])):
            expected = PICTURE if kind == "scenes" and not isinstance(value, list) else "found"
            document = {**json.loads(quad().gltf()), kind: value}
            case(f"{kind}_{name}.gltf", expected, json.dumps(document))
    case("scene_out_of_range.gltf", "scene", changed(["scene"], 7).gltf())
    case("scene_negative.gltf", "found", changed(["scene"], -7).gltf())
    case("scene_empty.gltf", "triangle", changed(["scenes"], [{"nodes": []}]).gltf())
    case("scene_without_anything.gltf", "triangle", '{"asset":{"version":"2.0"}}')
