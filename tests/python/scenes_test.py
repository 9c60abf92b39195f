"""Scenes of files and of arrays."""
import json
import subprocess

import numpy as np
import pytest

import inkedge
from conftest import COMMAND, asset

CORNERS = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], float)
SIDES = np.array([[0, 2, 3], [0, 3, 1], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4], [2, 6, 7], [2, 7, 3], [0, 4, 6],
                  [0, 6, 2], [1, 3, 7], [1, 7, 5]])


def moved(x, y=0.0, z=0.0):
    transform = np.eye(4)
    transform[:3, 3] = x, y, z
    return transform


def picture(renderer, scene, **settings):
    return renderer.render(scene, inkedge.Camera.frame(scene), size=(64, 48), **settings)


def test_a_file_says_what_the_command_says_of_it():
    scene = inkedge.Scene.load(str(asset("lantern")))
    found = json.loads(subprocess.run([COMMAND, "inspect", asset("lantern"), "--json"], capture_output=True).stdout)
    assert scene.triangles == found["triangles"]
    assert [(i.id, i.node, i.mesh) for i in scene.instances] == [
        (i["id"], i["node"], i["mesh"]) for i in found["instances"]]
    assert np.array_equal(scene.instances[0].transform, found["instances"][0]["transform"])
    low, high = scene.box
    assert (high > low).all() and np.allclose(scene.up, (0, 1, 0)) and np.allclose(scene.front, (0, 0, 1))
    assert np.linalg.norm(high - scene.centre) >= scene.radius * 0.5
    assert len(scene.material_names) == len(found["materials"]) and scene.warnings == found["warnings"]
    assert repr(scene) == f"<inkedge.Scene of {scene.triangles} triangles, 3 instances>"


def test_settings_of_models_act(gear):
    assert inkedge.Scene.load(asset("gear"), subdivide=1).triangles == 4 * gear.triangles
    assert len(inkedge.Scene.load(asset("lantern"), only="leaf").instances) == 1
    assert len(inkedge.Scene.load(asset("lantern"), hide=("leaf", "pane")).instances) == 1
    assert np.allclose(inkedge.Scene.load(asset("gear"), up="+Z").up, (0, 0, 1))


@pytest.mark.parametrize("vertices", [
    CORNERS, CORNERS.astype("float32"), CORNERS.astype(int), CORNERS.tolist(), CORNERS.astype(">f8"),
    CORNERS.astype("float16"), np.asfortranarray(CORNERS), np.repeat(CORNERS, 2, axis=0)[::2], CORNERS[::-1][::-1],
], ids=lambda vertices: str(getattr(vertices, "dtype", "list")))
@pytest.mark.parametrize("faces", [
    SIDES, SIDES.astype("uint8"), SIDES.astype(">i4"), SIDES.astype("int16"), SIDES.tolist()
], ids=lambda faces: str(getattr(faces, "dtype", "list")))
def test_arrays_may_have_any_type_and_stride(vertices, faces):
    scene = inkedge.Scene.from_arrays(vertices, faces)
    assert scene.triangles == 12 and np.array_equal(scene.box, [[0, 0, 0], [1, 1, 1]])


def test_arrays_that_repeat_themselves_are_read(renderer):
    normals = np.broadcast_to(np.array([0.0, 0.0, 1.0]), (3, 3))  # of stride 0
    scene = inkedge.Scene.from_arrays([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]], normals=normals)
    maps = renderer.render(scene, inkedge.Camera.frame(scene, view="front"), size=(32, 32))
    assert np.allclose(maps["normal"][maps["ids"][..., 2] == 1], (0, 0, 1), atol=1e-6)


def test_instances_have_transforms_and_names(renderer):
    scene = inkedge.Scene.from_arrays(CORNERS, SIDES, transforms=[moved(0), moved(3)], names=["left", "right"])
    assert np.array_equal(scene.box, [[0, 0, 0], [4, 1, 1]])
    assert [i.node for i in scene.instances] == ["left", "right"]
    assert np.array_equal(scene.instances[1].transform, moved(3))
    ids = renderer.render(scene, inkedge.Camera.frame(scene, view="front"), size=(64, 48))["ids"][..., 2]
    assert ids[24, 8] == 1 and ids[24, 55] == 2


def test_several_meshes_are_lists():
    scene = inkedge.Scene.from_arrays([CORNERS, CORNERS[:3] + 5], [SIDES, [[0, 1, 2]]],
                                      transforms=[np.stack([moved(0), moved(9)]), None], names=["box", "plate"])
    assert scene.triangles == 25 and [i.node for i in scene.instances] == ["box", "box", "plate"]
    assert [i.mesh for i in scene.instances] == ["box", "box", "plate"]


def test_uv_gives_isolines(renderer):
    plane = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], float)
    scene = inkedge.Scene.from_arrays(plane, [[0, 1, 2], [0, 2, 3]], uv=plane[:, :2])
    lines = renderer.lines(scene, inkedge.Camera.frame(scene, view="front"), isolines="u:4,v:0")
    marks = sorted(p[0, 0] for p, t in zip(lines.positions, lines.types) if t == inkedge.LineType.ISOPARAMETRIC)
    assert np.allclose(marks, [0.25, 0.5, 0.75])


def test_doubles_far_from_the_origin_keep_their_precision():
    scene = inkedge.Scene.from_arrays(CORNERS / 1024 + 1e9, SIDES)
    assert np.array_equal(scene.box[1] - scene.box[0], np.full(3, 1 / 1024))


@pytest.mark.parametrize(("arguments", "message"), [
    ({"vertices": CORNERS[:, :2]}, "positions: expected 3 numbers a row, found 2"),
    ({"vertices": CORNERS[None]}, "vertices: expected an array of one row or more, found one of the shape (1, 8, 3)"),
    ({"vertices": "corners"}, "vertices: expected an array of numbers, found another value"),
    ({"vertices": CORNERS * 1j}, "vertices: expected an array of numbers, found another value"),
    ({"vertices": CORNERS * np.nan}, "positions: expected finite numbers, found (nan, nan, nan) in row 0"),
    ({"faces": SIDES.astype(float)}, "indices: expected whole numbers, found real ones"),
    ({"faces": SIDES + 1}, "indices: expected numbers below 8, found 8 in row 2"),
    ({"faces": SIDES - 1}, "indices: expected numbers from 0, found -1 in row 0"),
    ({"faces": SIDES[:0]}, "faces: expected an array of one row or more, found one of the shape (0, 3)"),
    ({"normals": CORNERS[:3]}, "normals: expected 8 rows, one a position, found 3"),
    ({"uv": CORNERS}, "texture coordinates: expected 2 numbers a row, found 3"),
    ({"transforms": np.eye(3)}, "transforms: expected one or several matrices of 4 x 4 numbers, found another array"),
    ({"transforms": 2 * np.eye(4)}, "transforms: expected finite matrices whose last row is 0, 0, 0, 1, found another: "
                                    "number 0"),
    ({"names": ["a", "b"]}, "names: expected 1, one an instance, found 2"),
    ({"names": [1]}, "names: expected a text, or a list of texts, found another value"),
])
def test_what_is_wrong_with_an_array_is_said(arguments, message):
    with pytest.raises(inkedge.UsageError) as refusal:
        inkedge.Scene.from_arrays(**{"vertices": CORNERS, "faces": SIDES, **arguments})
    assert str(refusal.value) == message


def test_which_of_several_meshes_is_wrong_is_said():
    with pytest.raises(inkedge.UsageError, match="^mesh 1 'lid': positions: expected 3 numbers a row, found 2$"):
        inkedge.Scene.from_arrays([CORNERS, CORNERS[:, :2]], [SIDES, SIDES], names=["box", "lid"])
    with pytest.raises(inkedge.UsageError, match="^faces: expected 2, one a mesh, found another number$"):
        inkedge.Scene.from_arrays([CORNERS, CORNERS], [SIDES])


def test_what_draws_nothing_is_refused():
    with pytest.raises(inkedge.UsageError, match="^vertices: expected an array of one row or more"):
        inkedge.Scene.from_arrays(np.zeros((0, 3)), None)
