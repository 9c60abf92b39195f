"""Draws edges of depth and normals, as scripts do: moderngl for the geometry, OpenCV for Sobel's kernels.

MODEL.glb PICTURE.png SIDE: a model as make_mesh writes it.
--pool FOLDER OUT SIDE VIEWS JOBS [maps]: all models of a folder, by so many processes; maps: with depth and ids.
"""

import json
import multiprocessing
import os
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


class Drawing:
    """Pictures of one size, with a context that is kept."""

    def __init__(self, side):
        self.side = side
        self.context = moderngl.create_context(standalone=True, backend="egl")
        self.program = self.context.program(vertex_shader=VERTEX, fragment_shader=FRAGMENT)
        self.target = self.context.framebuffer([self.context.texture((side, side), 4, dtype="f4")],
                                               self.context.depth_renderbuffer((side, side)))
        self.context.enable(moderngl.DEPTH_TEST)

    def surfaces(self, model, azimuths):
        """For each azimuth, in radians: normals and depths as side x side x 4 floats, 0 where there is nothing; and the
        model's radius."""
        positions, indices = read(model)
        low, high = positions.min(0), positions.max(0)
        centre, radius = (low + high) / 2, np.linalg.norm(high - low) / 2
        away = 3.0 * radius
        mesh = self.context.vertex_array(self.program, [(self.context.buffer(positions.tobytes()), "3f", "position")],
                                         self.context.buffer(indices.tobytes()))
        projection = perspective(42.0, away - 1.5 * radius, away + 1.5 * radius)
        self.program["projection"].write(projection.T.astype("f4").tobytes())
        self.target.use()
        for azimuth in azimuths:
            eye = centre + away * np.array([np.sin(azimuth) * 0.94, 0.34, np.cos(azimuth) * 0.94])
            self.program["modelView"].write(look_at(eye, centre).T.astype("f4").tobytes())
            self.target.clear(0.0, 0.0, 0.0, 0.0)
            mesh.render()
            values = np.frombuffer(self.target.read(components=4, dtype="f4"), "f4")
            yield values.reshape(self.side, self.side, 4)[::-1], radius

    def write(self, surface, radius, picture):
        magnitude = np.zeros((self.side, self.side), "f4")
        for channel, step in ((0, 1.6), (1, 1.6), (2, 1.6), (3, 0.1 * radius)):
            values = np.ascontiguousarray(surface[:, :, channel])
            along, across = cv2.Sobel(values, cv2.CV_32F, 1, 0), cv2.Sobel(values, cv2.CV_32F, 0, 1)
            magnitude = np.maximum(magnitude, cv2.magnitude(along, across) / step)
        cv2.imwrite(picture, np.where(magnitude > 1.0, 0, 255).astype("u1"))


def draw_views(task):
    """A picture for each view, as `inkedge batch`; its depth and its ids, too, as with `--maps depth,ids`, but one kind
    of ids."""
    model, out, views, maps = task
    os.makedirs(out, exist_ok=True)
    try:
        azimuths = 2 * np.pi * np.arange(views) / views
        for i, (surface, radius) in enumerate(pooled.surfaces(model, azimuths)):
            pooled.write(surface, radius, f"{out}/{i}.png")
            if not maps:
                continue
            depth = np.clip(surface[:, :, 3] / (6.0 * radius) * 65535, 0, 65535).astype("u2")
            cv2.imwrite(f"{out}/{i}.depth.png", depth)
            cv2.imwrite(f"{out}/{i}.ids.png", (surface[:, :, 3] > 0).astype("u2"))
    except Exception as error:  # of a model that nobody can read: the others go on
        print(f"{model}: {error}", file=sys.stderr)


def start(side):
    global pooled
    pooled = Drawing(side)


def main():
    if sys.argv[1] == "--pool":
        models, out, side, views, jobs = *sys.argv[2:4], *map(int, sys.argv[4:7])
        maps = sys.argv[7:] == ["maps"]
        tasks = [(f"{models}/{name}", f"{out}/{name}", views, maps) for name in sorted(os.listdir(models))]
        with multiprocessing.get_context("spawn").Pool(jobs, start, (side,)) as pool:
            for _ in pool.imap_unordered(draw_views, tasks):
                pass
        return
    model, picture, side = sys.argv[1], sys.argv[2], int(sys.argv[3])
    drawing = Drawing(side)
    for surface, radius in drawing.surfaces(model, [0.5]):
        drawing.write(surface, radius, picture)


if __name__ == "__main__":
    main()
