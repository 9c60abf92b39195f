"""Failures are classes by kind, with the command's texts."""
import os
import pathlib
import shutil
import subprocess
import sys

import pytest

import inkedge
from conftest import COMMAND, asset


def test_each_kind_is_an_error_and_one_of_pythons_own():
    for kind, own in ((inkedge.RuntimeError, RuntimeError), (inkedge.UsageError, ValueError),
                      (inkedge.InputError, OSError), (inkedge.ContextError, RuntimeError),
                      (inkedge.OutputError, OSError), (inkedge.StoppedError, RuntimeError)):
        assert issubclass(kind, inkedge.Error) and issubclass(kind, own) and kind.__module__ == "inkedge"


def test_a_file_that_cannot_be_read_is_said_as_the_command_says_it(tmp_path):
    torn = tmp_path / "torn.glb"
    torn.write_bytes(asset("gear").read_bytes()[:1000])
    for file in (torn, tmp_path / "none.glb", tmp_path, tmp_path / "b\udcff.glb"):
        said = subprocess.run([COMMAND, "render", file, "-o", tmp_path / "x.png"], capture_output=True)
        with pytest.raises(inkedge.InputError) as refusal:
            inkedge.Scene.load(file)
        assert f"inkedge: error: {refusal.value}\n" == said.stderr.decode(errors="replace")


def test_what_a_scene_was_not_loaded_for_is_said(renderer):
    vase = inkedge.Scene.load(asset("vase"))
    with pytest.raises(inkedge.UsageError, match="^scene: expected one loaded with its colours, which shades, "):
        renderer.render(vase, inkedge.Camera.frame(vase), size=(32, 32), shade="light")
    vase = inkedge.Scene.load(asset("vase"), shade="light")
    renderer.render(vase, inkedge.Camera.frame(vase), size=(32, 32), shade="light")


def test_a_device_that_is_not_there_is_said():
    with pytest.raises(inkedge.UsageError, match="--device: expected an EGL device"):
        inkedge.Renderer(device=999)
    with pytest.raises(inkedge.UsageError, match="^backend: expected one of auto, egl, osmesa, found 'vulkan'$"):
        inkedge.Renderer(backend="vulkan")


def test_a_closed_renderer_draws_no_more(gear, view):
    with inkedge.Renderer() as renderer:
        depth = renderer.render(gear, view, size=(32, 32))["depth"]
    with pytest.raises(inkedge.UsageError, match="found one that was closed"):
        renderer.render(gear, view)
    renderer.close()
    assert depth.max() > 0, "what was drawn stays"


def test_a_file_that_cannot_be_written_is_said(renderer, gear, view, tmp_path):
    lines = renderer.lines(gear, view, size=(64, 64))
    with pytest.raises(inkedge.OutputError, match="no_folder"):
        lines.write(tmp_path / "no_folder" / "x.svg")
    with pytest.raises(inkedge.UsageError):
        lines.write(tmp_path / "x.docx")


def test_another_python_is_refused_in_one_line(tmp_path):
    package = pathlib.Path(inkedge.__file__).parent
    shutil.copytree(package, tmp_path / "inkedge", ignore=shutil.ignore_patterns("*.so"))
    (tmp_path / "inkedge" / "_inkedge.cpython-399-x86_64-linux-gnu.so").touch()
    done = subprocess.run([sys.executable, "-c", "import inkedge"], capture_output=True, text=True,
                          env={**os.environ, "PYTHONPATH": str(tmp_path)})
    said = done.stderr.splitlines()[-1]
    assert said.startswith("ImportError: inkedge: expected a Python for _inkedge.cpython-399-x86_64-linux-gnu.so, "
                           f"found {sys.executable}, ")
