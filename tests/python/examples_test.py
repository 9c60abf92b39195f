"""The examples of the README and of tools/examples run as they stand."""
import importlib.util
import json
import re
import shutil
import subprocess
import sys
import warnings

import numpy as np
import pytest

from conftest import SOURCE, asset

cv2 = pytest.importorskip("cv2")


def test_the_data_set_holds_what_it_says(tmp_path):
    script = SOURCE / "tools" / "examples" / "make_dataset.py"
    subprocess.run([sys.executable, script, asset("lantern"), tmp_path / "set", "3"], check=True)
    data = json.loads((tmp_path / "set" / "cameras.json").read_text())
    assert data["labels"] == {"1": "lantern/cup", "2": "lantern/pane", "3": "leaf"} and len(data["cameras"]) == 3
    for name, camera in data["cameras"].items():
        def read(kind, name=name):
            return cv2.imread(str(tmp_path / "set" / f"{name}_{kind}"), cv2.IMREAD_UNCHANGED)

        lines, depth, normal, ids = map(read, ("lines.png", "depth.tiff", "normal.png", "ids.png"))
        assert lines.shape == depth.shape == normal.shape[:2] == ids.shape == (480, 640)
        assert set(np.unique(lines)) == {0, 255} and set(np.unique(ids)) <= {0, 1, 2, 3}
        assert np.array_equal(ids == 0, depth == np.float32(camera["far"]))
        assert (normal[ids > 0][:, 0] > 127).mean() > 0.9, "blue is towards the eye"
        assert len(script.read_text().splitlines()) <= 35


def test_the_readmes_python_runs(tmp_path, monkeypatch):
    readme = (SOURCE / "README.md").read_text()
    section = readme[readme.index("\n## Python\n"):]
    section = section[:section.index("\n## ", 1)]
    blocks = re.findall(r"```python\n(.*?)```", section, re.S)
    assert len(blocks) >= 4
    shutil.copy(asset("gear"), tmp_path / "part.glb")
    monkeypatch.chdir(tmp_path)
    values = {}
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for block in blocks:
            if "torch" in block and importlib.util.find_spec("torch") is None:
                continue
            exec(block, values)  # pylint: disable=exec-used  # it is ours
    assert values["maps"]["ids"][values["y"], values["x"], 2] == 2, "as the README says of OpenCV's point"
