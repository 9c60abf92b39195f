"""Cameras draw where their matrices say: held to OpenCV's projection of the same points."""
import json
import subprocess

import numpy as np
import pytest

import inkedge
from conftest import COMMAND, asset

cv2 = pytest.importorskip("cv2")

WIDTH, HEIGHT = SIZE = (320, 240)
K = np.array([[300.0, 0, 148.5], [0, 300.0, 125.25], [0, 0, 1]])
RVEC, TVEC = np.array([0.3, -0.5, 0.2]), np.array([0.2, -0.1, 9.0])
CUBE = np.array([[x, y, z] for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]) * 0.25
SIDES = [[0, 2, 3], [0, 3, 1], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4], [2, 6, 7], [2, 7, 3], [0, 4, 6], [0, 6, 2],
         [1, 3, 7], [1, 7, 5]]
MIDDLES = np.array([[x, y, 0.3 * x * y] for x in (-2, 0, 2) for y in (-1.5, 0, 1.5)], float)


@pytest.fixture(scope="module")
def cubes():
    """Nine cubes, each an instance of its own."""
    transforms = np.tile(np.eye(4), (9, 1, 1))
    transforms[:, :3, 3] = MIDDLES
    return inkedge.Scene.from_arrays(CUBE, SIDES, transforms=transforms)


@pytest.fixture(scope="module")
def world_to_camera():
    matrix = np.eye(4)
    matrix[:3, :3] = cv2.Rodrigues(RVEC)[0]
    matrix[:3, 3] = TVEC
    return matrix


def expect_as_projected(maps, k=K):
    """The middle of each cube shows that cube, a little in front of the middle."""
    pixels = cv2.projectPoints(MIDDLES, RVEC, TVEC, k, None)[0][:, 0]
    depths = (cv2.Rodrigues(RVEC)[0] @ MIDDLES.T).T[:, 2] + TVEC[2]
    for number, (pixel, depth) in enumerate(zip(pixels, depths), 1):
        x, y = np.rint(pixel).astype(int)
        assert maps["ids"][y, x, 2] == number
        assert 0.1 < depth - maps["depth"][y, x] < 0.45, "half a side to half a diagonal"


@pytest.mark.parametrize("focal_lengths", [(300, 300), (301.7, 299.2), (150, 300), (300, 200)])
def test_intrinsics_are_opencvs(renderer, cubes, world_to_camera, focal_lengths):
    k = K.copy()
    k[0, 0], k[1, 1] = focal_lengths
    camera = inkedge.Camera.from_intrinsics(k, np.linalg.inv(world_to_camera))
    maps = renderer.render(cubes, camera, size=SIZE)
    expect_as_projected(maps, k)
    assert np.allclose(maps.camera.K, k) and np.allclose(maps.camera.world_to_camera, world_to_camera)
    drawn = {}
    for space in ("object", "image"):
        lines = renderer.lines(cubes, camera, size=SIZE, lines_from=space)
        assert len(lines) > 20
        for pixels, positions in zip(lines.pixels, lines.positions):
            expected = cv2.projectPoints(positions, RVEC, TVEC, k, None)[0][:, 0]
            assert np.allclose(pixels - 0.5, expected, atol=1e-6)
        whole = [np.vstack([pixels, pixels[:closed]]) for pixels, closed in zip(lines.pixels, lines.closed)]
        drawn[space] = sum(np.linalg.norm(np.diff(pixels, axis=0), axis=1).sum() for pixels in whole)
    # Between pixels some of the hundred ends are half a pixel off, of lines that are 8 pixels long on the average.
    assert np.isclose(drawn["image"], drawn["object"], rtol=0.05), "both find the same lines"


def test_opengls_axes_are_turned(renderer, cubes, world_to_camera):
    pose = np.linalg.inv(world_to_camera) @ np.diag([1, -1, -1, 1])
    camera = inkedge.Camera.from_intrinsics(K, pose, convention="opengl")
    expect_as_projected(renderer.render(cubes, camera, size=SIZE))
    with pytest.raises(inkedge.UsageError, match="^convention: expected one of opencv, opengl, found 'blender'$"):
        inkedge.Camera.from_intrinsics(K, pose, convention="blender")


def test_opengls_matrices_are_drawn(renderer, cubes, world_to_camera):
    near, far = 2.0, 30.0
    view = np.diag([1, -1, -1, 1]) @ world_to_camera
    projection = np.array([
        [2 * K[0, 0] / WIDTH, 0, 1 - 2 * (K[0, 2] + 0.5) / WIDTH, 0],
        [0, 2 * K[1, 1] / HEIGHT, 2 * (K[1, 2] + 0.5) / HEIGHT - 1, 0],
        [0, 0, -(far + near) / (far - near), -2 * far * near / (far - near)],
        [0, 0, -1, 0],
    ])
    maps = renderer.render(cubes, inkedge.Camera.from_matrices(view, projection), size=SIZE)
    expect_as_projected(maps)
    assert np.allclose(maps.camera.projection, projection) and np.allclose(maps.camera.view, view)
    assert np.isclose(maps.camera.near, near) and np.isclose(maps.camera.far, far)
    assert maps["depth"].max() == np.float32(maps.camera.far)


def test_what_is_drawn_can_be_drawn_again(renderer, gear, view):
    for settings in ({}, {"view": "iso"}):
        first = renderer.render(gear, inkedge.Camera.frame(gear, **settings), size=SIZE)
        again = inkedge.Camera.from_matrices(first.camera.view, first.camera.projection)
        maps = renderer.render(gear, again, size=SIZE)
        assert np.allclose(maps.camera.projection, first.camera.projection, atol=1e-12)
        assert (maps["ids"] != first["ids"]).mean() < 1e-3, "matrices are rounded to the last bit"


def test_normals_are_the_cameras_or_the_worlds(renderer, cubes):
    camera = inkedge.Camera.look_at((0, 0, 9), (0, 0, 0), fov=40)
    for space in ("camera", "world"):
        maps = renderer.render(cubes, camera, size=SIZE, normal_space=space)
        assert np.allclose(maps["normal"][120, 160], (0, 0, 1), atol=1e-5), "x right, y up, z towards the eye"


def test_a_camera_looks_at_its_target(cubes):
    camera = inkedge.Camera.look_at(eye=(1, 2, 9), target=(1, 2, 3), up=(1, 0, 0), fov=40).matrices(cubes, size=SIZE)
    assert np.allclose(camera.world_to_camera @ (1, 2, 3, 1), (0, 0, 6, 1))
    assert np.allclose(camera.world_to_camera @ (2, 2, 3, 1), (0, -1, 6, 1)), "y is down, and up is x"
    assert np.isclose(camera.K[1, 1], 120 / np.tan(np.radians(20))) and camera.K[0, 0] == camera.K[1, 1]
    assert np.allclose(camera.K[:2, 2], (159.5, 119.5))
    assert camera.orthographic_height == 0
    flat = inkedge.Camera.look_at((0, 0, 9), (0, 0, 0), camera_orthographic=5).matrices(cubes, size=SIZE)
    assert flat.orthographic_height == 5 and np.isclose(flat.K[0, 0], 240 / 5)


def test_a_framed_camera_is_the_commands(gear, tmp_path):
    file = tmp_path / "part.json"
    subprocess.run([COMMAND, "render", asset("gear"), "-o", tmp_path / "part.png", "--azimuth", "40", "--size",
                    "320x240", "--metadata", file], check=True)
    expected = json.loads(file.read_text())["camera"]
    found = inkedge.Camera.frame(gear, azimuth=40).matrices(gear, size=SIZE).to_dict()
    for name in ("view", "projection", "world_to_camera", "K", "near", "far"):
        assert np.allclose(found[name], expected[name], rtol=1e-12, atol=1e-12), name
    assert json.loads(json.dumps(found))["size"] == [320, 240]


def test_a_picture_may_be_cut_to_what_is_drawn(renderer, gear, view):
    maps = renderer.render(gear, view, size="160", crop=3)
    assert maps["picture"].shape[1] == 160 and maps.camera.size == maps["picture"].shape[::-1]
    camera = inkedge.Camera.from_intrinsics(K, np.eye(4))
    for name, settings in (("crop", {"crop": 3}), ("scale", {"scale": "1:2"}), ("size", {"size": "90mm"})):
        with pytest.raises(inkedge.UsageError, match=f"^{name}: expected a camera of Camera.frame"):
            renderer.render(gear, camera, **settings)


def test_a_camera_may_draw_another_scene(renderer, cubes, gear):
    small = inkedge.Scene.from_arrays(CUBE * 0.1, SIDES)
    camera = inkedge.Camera.frame(cubes, view="front")
    maps = renderer.render(small, camera, size=SIZE)
    assert maps["ids"][119, 159, 2] == 1, "near and far planes are the scene's that is drawn"
    assert np.array_equal(maps.camera.view, camera.matrices(cubes, size=SIZE).view)


@pytest.mark.parametrize(("make", "message"), [
    (lambda: inkedge.Camera.from_intrinsics(np.eye(4), np.eye(4)), "K: expected 3 x 3 numbers, found another array"),
    (lambda: inkedge.Camera.from_intrinsics(K, "pose"), "pose: expected 4 x 4 numbers, found another array"),
    (lambda: inkedge.Camera.look_at((0, 0), (0, 0, 1)), "eye: expected three numbers x,y,z, found '0,0'"),
])
def test_what_is_no_camera_is_refused(make, message):
    with pytest.raises(inkedge.UsageError) as refusal:
        make()
    assert str(refusal.value) == message


@pytest.mark.parametrize(("k", "pose", "start"), [
    (np.array([[300, 2, 160], [0, 300, 120], [0, 0, 1.0]]), np.eye(4), "K: expected the rows (fx, 0, cx)"),
    (K, np.diag([1, 1, -1.0, 1]), "pose: expected a rotation and a translation"),
])
def test_what_cannot_be_drawn_is_refused(renderer, gear, k, pose, start):
    with pytest.raises(inkedge.UsageError) as refusal:
        renderer.render(gear, inkedge.Camera.from_intrinsics(k, pose), size=SIZE)
    assert str(refusal.value).startswith(start)
