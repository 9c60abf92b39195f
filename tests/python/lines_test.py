"""Lines are lists of arrays, with what is known of each line."""
import gc
import json

import numpy as np
import pytest

import inkedge

SIZE = (320, 240)


@pytest.fixture(scope="module")
def lines(gear, view):
    with inkedge.Renderer(lazy=True) as renderer:  # exact lines need no context
        lines = renderer.lines(gear, view, size=SIZE, hidden="solid")
        assert renderer.backend.backend == ""
    return lines


def test_every_line_has_its_arrays(lines):
    count = len(lines)
    assert count > 100
    for pixels, positions, strengths in zip(lines.pixels, lines.positions, lines.strengths, strict=True):
        points = len(pixels)
        assert points >= 2
        assert (pixels.shape, positions.shape, strengths.shape) == ((points, 2), (points, 3), (points,))
        assert pixels.dtype == positions.dtype == strengths.dtype == np.float64
        assert not (pixels.flags.writeable or positions.flags.writeable or strengths.flags.writeable)
    for name, dtype in (("types", "uint16"), ("ids", "uint32"), ("visible", "bool"), ("closed", "bool"),
                        ("objects", "uint32"), ("patches", "uint32"), ("widths", "float64")):
        array = getattr(lines, name)
        assert (array.shape, array.dtype) == ((count,), np.dtype(dtype)), name
    assert len(set(lines.ids)) == count and lines.visible.any() and not lines.visible.all()
    assert (lines.types == inkedge.LineType.OUTLINE).any() and set(lines.objects) == {1}
    assert lines.instances[0].id == 1


def test_points_project_to_their_pixels(lines):
    camera = lines.camera
    for pixels, positions in zip(lines.pixels, lines.positions):
        seen = camera.K @ (camera.world_to_camera[:3] @ np.c_[positions, np.ones(len(positions))].T)
        assert np.allclose((seen[:2] / seen[2]).T + 0.5, pixels, atol=1e-6), "(0, 0) is the picture's corner"


def test_files_hold_the_same_lines(lines, tmp_path):
    lines.write(tmp_path / "gear.json")
    written = json.loads((tmp_path / "gear.json").read_text())["lines"]
    assert [line["id"] for line in written] == list(lines.ids)
    lines.write(tmp_path / "gear.svg")
    assert lines.svg().startswith("<?xml") and (tmp_path / "gear.svg").stat().st_size > 1000


def test_a_line_outlives_all_others(gear, view, renderer):
    lines = renderer.lines(gear, view, size=SIZE)
    first, kept = lines.pixels[0], lines.pixels[0].copy()
    del lines
    gc.collect()
    assert np.array_equal(first, kept)
