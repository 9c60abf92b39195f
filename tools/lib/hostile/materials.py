"""Materials and pictures."""

import random
import zlib

from lib.hostile.cases import PICTURE, case, changed, quad
from lib.png import GREY_ALPHA, RGBA, png_file
from lib.small_gltf import QUAD, Model


BITS = bytes(255 * (value & 1) for value in range(256))


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
    noise = random.Random(1)
    side = 1500
    rows = b"".join(b"\0" + noise.randbytes(2 * side).translate(BITS) for _ in range(side))
    textured("mask_of_noise", PICTURE, {"content": png_file((side, side), GREY_ALPHA, zlib.compress(rows))})
    side = 8000
    rows = [b"\0" + bytes([255, 255, 255, 0] * (side // 2)), b"\0" + bytes([255, 0, 255, 255] * (side // 2))]
    packer = zlib.compressobj()
    checker = b"".join(packer.compress(rows[y % 2]) for y in range(side)) + packer.flush()
    textured("mask_of_64_million_squares", PICTURE, {"content": png_file((side, side), GREY_ALPHA, checker)})
    case("material_out_of_range.gltf", PICTURE, quad(material=7).gltf())
    case("material_negative.gltf", "material", quad(material=-7).gltf())
    case("materials_100000_all_alike.gltf", PICTURE, changed(
        ["materials"], [{"pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 1]}}] * 100000).gltf())
    case("animation_without_samplers.gltf", PICTURE, changed(
        ["animations"], [{"channels": [{"sampler": 9, "target": {"node": 8, "path": "x"}}], "samplers": []}]).gltf())
