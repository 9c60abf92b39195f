#include "python/documentation.h"

#include <fmt/format.h>

#include <inkedge/setting_table.h>

#include "python/keywords.h"

namespace inkedge::python {
namespace documentation {
namespace {

std::string settingsOf(const Call& call) {
    std::string text = R"(

Settings are keywords, all of them optional; their values are texts as on the command line, numbers, or
several of these in a list, a tuple or an array:
)";
    for (const SettingDescription& row : settingTable()) {
        if (!takes(call, row)) continue;
        const std::string byDefault = row.defaultValue();
        text += fmt::format("\n    {}{}: {}{}\n        {}", keywordOf(row.name),
                            row.shortName.empty() ? "" : fmt::format(" or {}", keywordOf(row.shortName)), row.range(),
                            byDefault.empty() ? "" : fmt::format(" [{}]", byDefault), row.help);
    }
    text += "\n    preset: ";
    for (const Preset& each : presets())
        text += fmt::format("{}{}", &each == &presets().front() ? "" : ", ", each.name);
    return text + "\n        a named set of settings, which the others override\n";
}

}  // namespace

const char* const module = R"(Clean line drawings of 3D models, and the maps that go with them, as numpy arrays.

    import inkedge

    scene = inkedge.Scene.load("part.glb")
    camera = inkedge.Camera.frame(scene, azimuth=30, elevation=20)
    with inkedge.Renderer() as renderer:
        maps = renderer.render(scene, camera, size=(640, 480))
    maps["types"], maps["depth"], maps["normal"], maps["ids"], maps.camera.K

Row 0 of every array is the top one. inkedge.settings describes every keyword. Failures are inkedge.Error.)";

const char* const setting = R"(A setting: a keyword of the calls of its group, and a flag of the command.

name, short_name: the keyword and its second name, or ""
flag: on the command line
group: "output", "picture", "lines", "style", "camera", "model", "limits", "detector" or "backend"
kind: "number", "count", "choice", "list" or "text"
choices: the names that a choice or a list takes
values, range, default, help: as the command's manual has them)";

const char* const scene = R"(Meshes and their instances, ready to be drawn. It never changes; threads may share it.

triangles: how many are drawn, every instance counted
box: two arrays of 3, the smallest and the largest corner in the world
centre, radius: of a sphere around everything, in the world
up, front: which way is up, and where the front looks to, in the world
instances: list of Instance, by id
material_names: list of texts, id 1 first
warnings: list of texts, what the file holds that is not drawn)";

const char* const instance = R"(What an id of maps["ids"][..., 2] and of lines.objects stands for.

id: from 1
node: names from a root of the file's tree to its node, as in "crane/arm"
mesh: its mesh's name
materials: ids of its triangles' materials
transform: 4 x 4 float64, mesh to world)";

const char* const camera = R"(Where pictures are taken from. It never changes; threads may share it.

Made by Camera.frame(), .look_at(), .from_matrices() or .from_intrinsics(). The picture's size is render()'s.)";

const char* const cameraMatrices = R"(The matrices of a camera for pictures of one size, for column vectors.

size: width, height
view: 4 x 4 float64, world to view space, as OpenGL has it: x right, y up, z towards the eye
projection: 4 x 4 float64, view space to clip space, as OpenGL has it: -w <= z <= w
world_to_camera: 4 x 4 float64, as OpenCV has it: x right, y down, z into the scene
K: 3 x 3 float64, OpenCV's: that camera's x/z, y/z, 1 to pixels, (0, 0) the middle of the first one; in an
    orthographic view of x, y, 1
near, far: distance of the planes along the view direction, units of the scene
orthographic_height: units of the scene across the picture's height; 0: perspective)";

const char* const renderer = R"(Renderer(backend="auto", device=None, *, lazy=False)

Owns one offscreen OpenGL context and draws any number of scenes and views with it: a context manager, or until
close(). Threads that share one wait for each other; several renderers draw side by side, in threads or processes.
A process that has drawn cannot draw in a fork: fork before, or start processes by "spawn".

backend: "auto", "egl" or "osmesa"; device: an EGL device's number, as inkedge doctor lists them
lazy: make the context when a call needs it; exact lines need no OpenGL

Raises ContextError if no context can be had.)";

const char* const maps = R"(What was drawn: a mapping of names to arrays, height x width or height x width x channels.

picture: uint8; 1 channel (grey, height x width), 3 (RGB) or, with background="none", 4 (RGBA, not premultiplied)
depth: float32, distance along the view direction, units of the scene; background: camera.far
normal: float32, 3 channels, unit length, x right, y up, z towards the eye, or normal_space="world"; background: 0
types: uint16, bits of LineType at pixels of lines, else 0
ids: uint32, 4 channels: patch, patch across the line, instance, material, from 1; 0: none
edges, depth_edges, normal_edges: uint8, 255 on an edge, else 0
shade: uint8, 4 channels, RGBA, not premultiplied: what lies under the lines; background: 0

The arrays are read-only unless render() is asked for writable ones. Each holds its own memory, which C++ wrote: nothing
is copied, and what is not kept is given up.

camera: CameraMatrices
instance_names, material_names: lists of texts, by id; 0 is ""
backend: what drew it; times: milliseconds of each stage
warnings: list of texts, what was asked for and the scene has nothing for)";

const char* const lines = R"(The lines of a view, each a polyline of one type, all of it seen or all of it hidden.

pixels: list of n x 2 float64, (0, 0) the picture's top left corner, y down, not rounded
positions: list of n x 3 float64, in the world
strengths: list of n float64: of lines of form, 0 to 1
types: uint16, a bit of LineType for each line
visible, closed: bool for each line; a closed line's last point is joined to its first
ids: uint32 for each line, the same whenever scene, camera and settings are the same
objects, patches: uint32 for each line: the instance and the patch that it lies on, as in maps["ids"]
widths: float64 for each line, a share of its pen's width
camera: CameraMatrices
instances: list of Instance that lines lie on
times, warnings: as Maps has them

The arrays are read-only. They are copies, so that each is contiguous, as OpenCV asks.)";

const char* const linesComparison = R"(What became of lines.

same: whether the share that changed is within the one that is allowed
share: of the length of all lines, what changed
changes: list of dicts, as "changes" of inkedge compare --lines --json
write(path): draws them; str() says them, a line each)";

const char* const pictureComparison = R"(How far two pictures differ.

same: whether they are within the tolerances
share: of the pixels that differ by more than the level
maximum: the largest difference)";

const char* const compareLines = R"(compare_lines(before, after, *, distance=1.5, share=0.0, speck=4.0)

Which lines appeared, vanished, moved, or changed type or visibility: LinesComparison. The GIL is released meanwhile.

before, after: Lines, or the path of lines as .json or .svg, or of a picture; both of one size
distance: pixels; lines that run along each other this near are the same
share: 0 to 1; of the length of all lines, how much may have changed
speck: pixels; shorter changes are left out

Raises InputError if a file cannot be read or the sizes differ, UsageError if a number is out of range.)";

const char* const comparePictures = R"(compare_pictures(a, b, *, level=0.0, share=0.0, hard_limit=None, difference=None)

How far the pictures of two files differ: PictureComparison. The GIL is released meanwhile.

level: 0 to 1; differences up to this do not count
share: 0 to 1; of the pixels, how many may differ by more
hard_limit: 0 to 1; no pixel may differ by more. None: no limit where a share is allowed, else the level
difference: path of a picture of the differences, or None

Raises InputError if a file cannot be read or the sizes differ, OutputError if the difference cannot be written.)";

const char* const backend = R"(What drew a picture.

backend: "egl" or "osmesa"; empty while there is no context
platform, vendor, renderer, version: texts
software: whether it is no graphics card)";

const char* const fromMatrices = R"(from_matrices(view, projection)

The camera of OpenGL's matrices for column vectors: view is 4 x 4, world to view space, a rotation and a translation;
projection is 4 x 4, perspective or orthographic, made for the picture's aspect. Of a projection with an infinite far
plane both planes are fitted to the scene.)";

const char* const fromIntrinsics = R"(from_intrinsics(K, pose, convention="opencv")

The camera of a calibration: K is 3 x 3, focal lengths and principal point in pixels of pictures of the size that is
drawn, (0, 0) the middle of the first pixel, as OpenCV has it; no skew. pose is 4 x 4, camera to world: the inverse of
OpenCV's [R | t].

convention: the camera's own axes, "opencv" (x right, y down, z into the scene) or "opengl" (x right, y up, z towards
the eye; Blender's, too))";

const char* const matrices = R"(matrices(scene, **settings)

CameraMatrices of the picture that render() would draw of the scene with these settings.)";

std::string load() {
    return R"(load(path, **settings)

Reads a model. The settings of pictures that will be drawn of it say what is loaded besides triangles: give what
render() is given where it draws a function, isolines or a shade.

Raises InputError if the file cannot be read, is damaged or draws nothing.)" +
           settingsOf(loading);
}

std::string fromArrays() {
    return R"(from_arrays(vertices, faces, normals=None, uv=None, transforms=None, names=None, **settings)

A scene of one mesh, or of several where vertices is a list of arrays; then all others are lists, too, an item a mesh,
or None.

vertices: n x 3, finite; doubles far from the origin keep their precision
faces: m x 3, whole numbers, into vertices, counter-clockwise from outside; None: each three vertices are a face
normals: n x 3; (0, 0, 0): none
uv: n x 2, (0, 0) the top left corner of the picture, as in glTF
transforms: 4 x 4 or k x 4 x 4, mesh to world for column vectors, affine: an instance each; None: one
names: a text, or k texts: of the instances

Settings as for load(); those of files do nothing, and normals is no setting here.)";
}

std::string frame() {
    return R"(frame(scene, **settings)

A camera that the whole scene is framed by; in a three-quarter view unless the settings say otherwise.)" +
           settingsOf(framing);
}

std::string lookAt() {
    return R"(look_at(eye, target, up=None, **settings)

A camera that stands at eye and looks at target, three numbers each, in the world; up is upwards in the picture, or the
scene's up. fov (degrees, vertical) or camera_orthographic (height) and others as for frame().)";
}

std::string render() {
    return R"(render(scene, camera, *, writable=False, **settings)

Draws one view: Maps with "picture" and the maps that are named. The GIL is released meanwhile.

size=(width, height): pixels
maps=("types", "depth", "normal", "ids"): what is drawn beside the picture; of these
    depth, normal, depth_edges, normal_edges, edges, types, ids, shade
writable: whether the arrays may be written to)" +
           settingsOf(drawing);
}

std::string renderLines() {
    return R"(lines(scene, camera, **settings)

The lines of one view as polylines: Lines. Exact ones of the mesh, visible, and hidden ones with hidden="solid", unless
lines_from="image". The GIL is released meanwhile.)" +
           settingsOf(lining);
}

}  // namespace documentation
}  // namespace inkedge::python
