"""Settings are the table's: named, checked and worded as on the command line."""
import pathlib
import subprocess
import warnings

import numpy as np
import pytest

import inkedge
from conftest import COMMAND, asset

SIZE = (96, 64)
TAKES_ANY_TEXT = {"animation", "brush", "only", "hide"}


def call_of(setting):
    """The call that takes a setting."""
    if setting.group == "backend":
        return lambda **settings: inkedge.Renderer(lazy=True, **settings)
    if setting.group == "camera":
        return lambda **settings: inkedge.Camera.look_at((0, 0, 9), (0, 0, 0), **settings)
    if setting.group in ("model", "limits"):
        return lambda **settings: inkedge.Scene.load(asset("cube"), **settings)
    scene = inkedge.Scene.load(asset("cube"))
    camera = inkedge.Camera.frame(scene)
    return lambda **settings: camera.matrices(scene, **settings)


@pytest.mark.parametrize("setting", [s for s in inkedge.settings.values() if s.name not in TAKES_ANY_TEXT],
                         ids=lambda setting: setting.name)
def test_every_setting_is_a_keyword_that_refuses_as_the_command_does(setting):
    said = subprocess.run([COMMAND, "render", "--print-config", setting.flag, "?"], capture_output=True, text=True)
    assert said.returncode == 2
    expected = said.stderr.strip().removeprefix(f"inkedge: error: {setting.flag}: ")
    for keyword in filter(None, (setting.name, setting.short_name)):
        if setting.group == "camera" and keyword in ("eye", "target", "camera_position", "camera_focal_point"):
            scene = inkedge.Scene.load(asset("cube"))
            with pytest.raises(inkedge.UsageError) as refusal:
                inkedge.Camera.frame(scene, **{keyword: "?"})
        else:
            with pytest.raises(inkedge.UsageError) as refusal:
                call_of(setting)(**{keyword: "?"})
        assert str(refusal.value) == f"{keyword}: {expected}"


def test_a_setting_draws_what_its_flag_draws(tmp_path, renderer, gear):
    cv2 = pytest.importorskip("cv2")
    camera = inkedge.Camera.frame(gear, azimuth=-30, elevation=22)
    for flags, settings in (
        ([], {}),
        (["--line-width", "3.5", "--line-color", "#0a7"], {"line_width": 3.5, "line_color": "#0a7"}),
        (["--lines", "outline,crease", "--supersampling", "2"], {"lines": ("outline", "crease"), "supersampling": 2}),
        (["--preset", "blueprint"], {"preset": "blueprint"}),
        (["--detector", "classic", "--kernel", "farid"], {"detector": "classic", "kernel": "farid"}),
        (["--crop", "4"], {"crop": 4}),
        (["--hidden", "dashed", "--background", "none"], {"hidden": "dashed", "background": "none"}),
    ):
        file = tmp_path / "part.png"
        subprocess.run([COMMAND, "render", asset("gear"), "-o", file, "--azimuth", "-30", "--elevation", "22", "--size",
                        "96x64", *flags], check=True)
        expected = cv2.imread(str(file), cv2.IMREAD_UNCHANGED)
        if expected.ndim == 3:  # OpenCV has BGR
            expected = cv2.cvtColor(expected, cv2.COLOR_BGRA2RGBA if expected.shape[2] == 4 else cv2.COLOR_BGR2RGB)
        found = renderer.render(gear, camera, size=SIZE, maps=(), **settings)["picture"]
        assert np.array_equal(found, expected), flags


@pytest.mark.parametrize("size", [(640, 480), [640, 480], "640x480", np.array([640, 480]), (np.int64(640), 480)])
def test_several_numbers_may_be_a_text_or_any_sequence(gear, view, size):
    assert view.matrices(gear, size=size).size == (640, 480)


def test_numbers_may_be_numpys(gear):
    for fov in (30, 30.0, "30", np.float32(30), np.int64(30), np.array(30.0)[()]):
        assert np.isclose(inkedge.Camera.frame(gear, fov=fov).matrices(gear).K[1, 1], 512 / np.tan(np.radians(15)))


def test_maps_may_be_named_as_flags_or_as_keywords(renderer, gear, view):
    for maps in ("depth-edges,edges", ("depth_edges", "edges"), ["depth-edges", "edges"]):
        assert list(renderer.render(gear, view, size=SIZE, maps=maps)) == ["picture", "depth_edges", "edges"]
    assert list(renderer.render(gear, view, size=SIZE, maps=())) == ["picture"]


def test_a_preset_comes_before_what_is_given_besides(renderer, view):
    gear = inkedge.Scene.load(asset("gear"), preset="dataset")
    maps = renderer.render(gear, view, size=SIZE, preset="dataset")
    assert set(maps) >= {"picture", "shade", "edges", "ids"}
    assert list(renderer.render(gear, view, size=SIZE, preset="dataset", maps="depth")) == ["picture", "depth"]
    with pytest.raises(inkedge.UsageError, match="^preset: expected one of .* 'datasets'; is it dataset\\?$"):
        renderer.render(gear, view, preset="datasets")


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"linewidth": 2}, "linewidth: there is no setting named 'linewidth'; is it line-width?"),
        ({"azimuth": 30}, "azimuth: expected it for Camera.frame(), found it for Renderer.render()"),
        ({"crease_angle": 30}, "crease_angle: expected it for Scene.load(), found it for Renderer.render()"),
        ({"backend": "egl"}, "backend: expected it for Renderer(), found it for Renderer.render()"),
        ({"line_width": None}, "line_width: expected a value, found None; leave it out where its default will do"),
        ({"line_width": {}}, "line_width: expected a text, a number or several of them, found dict"),
        ({"size": ((1, 2), 3)}, "size: expected a text, a number or several of them, found tuple"),
        ({"line_width": True}, "line_width: expected a text, a number or several of them, found bool"),
        ({"line_width": float("nan")}, "line_width: expected a number, found 'nan'"),
        ({"size": (0, 5)}, "size: expected 1x1 to 32768x32768 pixels, found '0x5'"),
    ],
)
def test_what_is_wrong_with_a_setting_is_said(renderer, gear, view, settings, message):
    with pytest.raises(inkedge.UsageError) as refusal:
        renderer.render(gear, view, **settings)
    assert str(refusal.value) == message


def test_a_setting_that_does_nothing_is_a_warning_of_the_callers_line(renderer, gear, view):
    with pytest.warns(inkedge.Warning, match="^--hatch-width does nothing: it is for another --style$") as found:
        renderer.render(gear, view, size=SIZE, hatch_width=1)
    assert pathlib.Path(found[0].filename) == pathlib.Path(__file__)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        renderer.render(gear, view, size=SIZE, style="hatch", hatch_width=1)
        with pytest.raises(inkedge.Warning):
            renderer.render(gear, view, size=SIZE, hatch_width=1)
