#!/usr/bin/env python3
"""The README's Python reads the maps that the command writes, and what it reads agrees.

usage: maps_test.py SOURCE COMMAND; exit status 77: NumPy or OpenCV are not there
"""
import os
import re
import subprocess
import sys
import tempfile

try:
    import cv2  # noqa: F401
    import numpy as np
except ImportError as missing:
    print(f"SKIPPED: {missing}; tools/setup installs python3-numpy and python3-opencv", flush=True)
    sys.exit(77)


def examples(readme):
    """The commands of section Maps and the Python that follows each."""
    section = readme[readme.index("\n## Maps\n"):readme.index("\n## Flags of")]
    found = re.findall(r"`(inkedge render [^`]*)`[^`]*```python\n(.*?)```", section, re.S)
    assert len(found) == 3, f"expected three examples in the README, found {len(found)}"
    return found


def run(command, example, model, camera=("--azimuth", "200")):
    arguments = example[0].replace("part.glb", model).split()[1:]
    subprocess.run([command, *arguments, "--size", "120x90", *camera, "--supersampling", "2"], check=True)
    values = {}
    exec(example[1], values)  # pylint: disable=exec-used  # it is ours
    return values


def expect_on_model(npz, bounds):
    """What is unprojected lies on the model: within its bounds, and where OpenGL's matrices have it."""
    part = npz["part"]
    far_off = np.linalg.norm(npz["world"] - bounds["centre"], axis=1).max()
    assert far_off <= bounds["radius"] * (1 + 1e-5), far_off
    clip = part["projection"] @ part["view"] @ np.vstack([npz["world"].T, np.ones(len(npz["world"]))])
    height, width = part["depth"].shape
    ndc = clip[:2] / clip[3]
    pixels = np.stack([(ndc[0] + 1) / 2 * width - 0.5, (1 - ndc[1]) / 2 * height - 0.5])
    assert np.abs(pixels - [npz["x"], npz["y"]]).max() < 1e-3, "the middle of each pixel"


def main():
    source, command = map(os.path.abspath, sys.argv[1:])
    model = os.path.join(source, "assets", "lantern.glb")
    with open(os.path.join(source, "README.md"), encoding="utf-8") as file:
        arrays, pictures, floats = examples(file.read())
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        iso = run(command, arrays, model, ("--view", "iso"))
        npz = run(command, arrays, model)
        png = run(command, pictures, model)
        tif = run(command, floats, model)
    part = npz["part"]
    assert set(npz["names"]) <= {"lantern/cup", "lantern/pane", "leaf"} and len(set(npz["names"])) > 1
    assert list(png["names"].values()) == ["lantern/cup", "lantern/pane", "leaf"]
    assert np.array_equal(part["ids"][..., 2], png["objects"])
    assert np.array_equal(part["ids"][..., 2], tif["objects"])
    assert np.array_equal(part["depth"], tif["depth"])
    assert np.array_equal(part["normal"], tif["normal"])
    assert np.abs(part["normal"] - png["normal"]).max() <= 1 / 255 + 1e-6, "8 bits round by half a step"
    step = png["data"]["depth_png"]["scale"]
    assert np.abs(part["depth"] - png["depth"]).max() <= step / 2 + 1e-6, "16 bits round by half a step"
    assert np.array_equal(part["types"] & 8 != 0, png["creases"])
    assert np.array_equal(part["ids"][..., 2] == 0, part["depth"] == np.float32(part["far"]))
    assert iso["part"]["orthographic_height"] > 0 and part["orthographic_height"] == 0
    for arrays in (npz, iso):
        expect_on_model(arrays, png["data"]["bounds"])
    print("the README's Python reads what is written")


main()
