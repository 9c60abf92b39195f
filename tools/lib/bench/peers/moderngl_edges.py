"""Draws edges of depth and normals, as scripts do: moderngl for the geometry, OpenCV for Sobel's kernels.

MODEL.glb PICTURE.png SIDE: a model as make_mesh writes it.
"""

import json
import struct
import sys

import cv2
import moderngl
import numpy as np

VERTEX = """#version 330
in vec3 position;
uniform mat4 modelView, projection;
out vec3 eye;
void main() {
    eye = (modelView * vec4(position, 1.0)).xyz;
    gl_Position = projection * vec4(eye, 1.0);
}"""
FRAGMENT = """#version 330
in vec3 eye;
out vec4 surface;
void main() { surface = vec4(normalize(cross(dFdx(eye), dFdy(eye))), -eye.z); }"""


def read(model):
    data = open(model, "rb").read()
    length = struct.unpack_from("<I", data, 12)[0]
    document = json.loads(data[20 : 20 + length])
    binary = 28 + length
    primitive = document["meshes"][0]["primitives"][0]

    def values(number, kind):
        accessor = document["accessors"][number]
        view = document["bufferViews"][accessor["bufferView"]]
        count = accessor["count"] * (3 if accessor["type"] == "VEC3" else 1)
        return np.frombuffer(data, kind, count, binary + view.get("byteOffset", 0))

    return values(primitive["attributes"]["POSITION"], "f4").reshape(-1, 3), values(primitive["indices"], "u4")


def look_at(eye, centre):
    back = (eye - centre) / np.linalg.norm(eye - centre)
    right = np.cross([0.0, 1.0, 0.0], back)
    right /= np.linalg.norm(right)
    view = np.eye(4)
    view[:3, :3] = [right, np.cross(back, right), back]
    view[:3, 3] = -view[:3, :3] @ eye
    return view


def perspective(degrees, near, far):
    scale = 1.0 / np.tan(np.radians(degrees) / 2)
    return np.array([[scale, 0, 0, 0], [0, scale, 0, 0],
                     [0, 0, (far + near) / (near - far), 2 * far * near / (near - far)], [0, 0, -1, 0]])


def main():
    model, picture, side = sys.argv[1], sys.argv[2], int(sys.argv[3])
    positions, indices = read(model)
    low, high = positions.min(0), positions.max(0)
    centre, radius = (low + high) / 2, np.linalg.norm(high - low) / 2

    context = moderngl.create_context(standalone=True, backend="egl")
    program = context.program(vertex_shader=VERTEX, fragment_shader=FRAGMENT)
    away = 3.0 * radius
    eye = centre + away * np.array([np.sin(0.5) * 0.94, 0.34, np.cos(0.5) * 0.94])
    program["modelView"].write(look_at(eye, centre).T.astype("f4").tobytes())
    program["projection"].write(perspective(42.0, away - 1.5 * radius, away + 1.5 * radius).T.astype("f4").tobytes())
    target = context.framebuffer([context.texture((side, side), 4, dtype="f4")], context.depth_renderbuffer((side, side)))
    target.use()
    target.clear(0.0, 0.0, 0.0, 0.0)
    context.enable(moderngl.DEPTH_TEST)
    mesh = context.vertex_array(program, [(context.buffer(positions.tobytes()), "3f", "position")],
                                context.buffer(indices.tobytes()))
    mesh.render()
    surface = np.frombuffer(target.read(components=4, dtype="f4"), "f4").reshape(side, side, 4)[::-1]

    magnitude = np.zeros((side, side), "f4")
    for channel, step in ((0, 1.6), (1, 1.6), (2, 1.6), (3, 0.1 * radius)):
        values = np.ascontiguousarray(surface[:, :, channel])
        along, across = cv2.Sobel(values, cv2.CV_32F, 1, 0), cv2.Sobel(values, cv2.CV_32F, 0, 1)
        magnitude = np.maximum(magnitude, cv2.magnitude(along, across) / step)
    cv2.imwrite(picture, np.where(magnitude > 1.0, 0, 255).astype("u1"))


main()
