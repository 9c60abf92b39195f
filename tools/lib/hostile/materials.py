"""Materials and pictures."""

import zlib

from lib.hostile.cases import PICTURE, case, changed, quad
from lib.png import RGBA, png_file
from lib.small_gltf import QUAD, Model


def materials():
    def textured(name, expected, image, files=None, mode="MASK"):
        model = Model()
        corners = model.accessor([(0, 0), (1, 0), (1, 1), (0, 1)])
        model.mesh({"POSITION": model.accessor(QUAD), "TEXCOORD_0": corners}, material=0)
        if "content" in image:
            image = {"bufferView": model.view(image["content"]), "mimeType": "image/png"}
        model.json.update(
            materials=[{"alphaMode": mode, "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
            textures=[{"source": 0}], images=[image])
        case(f"{name}.glb", expected, model.glb())

    bomb = zlib.compress(bytes(20 << 20), 9)
    huge = {"content": png_file((60000, 60000), RGBA, bomb)}
    textured("texture_of_60000_x_60000", PICTURE, huge)
    textured("texture_of_60000_x_60000_solid", PICTURE, huge, mode="OPAQUE")
    textured("texture_of_2_to_31_pixels_across", PICTURE, {"content": png_file((0x7FFFFFFF, 1), RGBA, bomb)})
    textured("texture_of_no_pixels", PICTURE, {"content": png_file((0, 0), RGBA, b"")})
    textured("texture_cut_off", PICTURE, {"content": png_file((64, 64), RGBA, zlib.compress(bytes(64 * 257))[:20])})
    textured("texture_no_picture", PICTURE, {"content": b"hello there"})
    textured("texture_of_a_device", PICTURE, {"uri": "/dev/zero"})
    textured("texture_outside_the_folder", PICTURE, {"uri": "../../../../etc/passwd"})
    textured("texture_missing", PICTURE, {"uri": "missing.png"})
    textured("texture_of_nothing", PICTURE, {})
    case("material_out_of_range.gltf", PICTURE, quad(material=7).gltf())
    case("material_negative.gltf", "material", quad(material=-7).gltf())
    case("materials_100000_all_alike.gltf", PICTURE, changed(
        ["materials"], [{"pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 1]}}] * 100000).gltf())
    case("animation_without_samplers.gltf", PICTURE, changed(
        ["animations"], [{"channels": [{"sampler": 9, "target": {"node": 8, "path": "x"}}], "samplers": []}]).gltf())
