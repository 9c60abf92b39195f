"""Assertions of test suites: what holds passes, what does not leaves the candidate and a picture of the difference."""
import json

import numpy as np
import pytest

import inkedge
from inkedge.testing import assert_same_lines, assert_same_picture

SIZE = (320, 240)


@pytest.fixture
def work(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("INKEDGE_ACCEPT", raising=False)
    return tmp_path


def found_lines(scene, view, **settings):
    with inkedge.Renderer(lazy=True) as renderer:
        return renderer.lines(scene, view, size=SIZE, **settings)


def test_lines_hold_to_their_reference(gear, view, work):
    lines = found_lines(gear, view)
    for reference in ("expected/gear.json", "expected/gear.svg"):
        with pytest.raises(AssertionError, match="expected a reference, found none; look at candidates/gear.* and"):
            assert_same_lines(lines, reference)
        with pytest.MonkeyPatch.context() as patch:
            patch.setenv("INKEDGE_ACCEPT", "1")
            assert_same_lines(lines, reference)
        assert_same_lines(lines, reference)
        assert not list((work / "candidates").iterdir()), "nothing is left of what holds"
    lines.write("copy.json")
    assert_same_lines("copy.json", "expected/gear.svg")


def test_lines_that_vanished_are_said_and_left(gear, view, work):
    found_lines(gear, view).write("gear.json")
    fewer = found_lines(gear, view, lines="outline,occlusion")
    with pytest.raises(AssertionError) as failure:
        assert_same_lines(fewer, "gear.json", folder="left")
    said = str(failure.value)
    assert "\n  vanished   crease of " in said and "left/gear.difference.svg" in said and "INKEDGE_ACCEPT=1" in said
    assert (work / "left/gear.json").exists() and (work / "left/gear.difference.svg").read_text().startswith("<?xml")
    assert_same_lines(fewer, "gear.json", share=0.9)
    changes = inkedge.compare_lines("gear.json", fewer).changes
    assert {change["change"] for change in changes} == {"vanished"}
    assert {change["type"] for change in changes} == {"crease"} and changes[0]["before"][0]["pixels"]
    assert inkedge.compare_lines(fewer, fewer).same
    with pytest.raises(inkedge.UsageError, match="distance: expected"):
        inkedge.compare_lines(fewer, fewer, distance=-1)


def test_pictures_hold_to_their_reference(work):
    picture = np.full((24, 32, 3), 255, np.uint8)
    picture[10] = 0
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("INKEDGE_ACCEPT", "1")
        assert_same_picture(picture, "line.png")
    assert_same_picture(picture, "line.png")
    assert_same_picture("line.png", "line.png")
    assert not list((work / "candidates").iterdir())
    other = picture.copy()
    other[10, 5:8] = 200
    with pytest.raises(AssertionError,
                       match=r"different: 3 of 768 pixels over the level .*\n  candidate  candidates/line.png"):
        assert_same_picture(other, "line.png")
    assert (work / "candidates/line.difference.png").exists()
    assert_same_picture(other, "line.png", share=0.01)
    with pytest.raises(inkedge.UsageError, match="pixels: expected uint8"):
        inkedge.write_png("x.png", np.zeros((2, 2, 2), np.uint8))


def test_maps_are_their_picture(gear, view, renderer, work):
    maps = renderer.render(gear, view, size=(64, 48))
    inkedge.write_png("gear.png", maps["picture"])
    assert_same_picture(maps, "gear.png")
    assert json.dumps(inkedge.compare_pictures("gear.png", "gear.png").maximum) == "0.0"


def test_the_readmes_test_runs(gear, work):
    from conftest import SOURCE, asset
    readme = (SOURCE / "README.md").read_text()
    block = readme[readme.index("```python\nimport inkedge\nfrom inkedge.testing"):]
    (work / "part.glb").write_bytes(asset("gear").read_bytes())
    values = {}
    exec(block[len("```python\n"):block.index("\n```\n")], values)  # pylint: disable=exec-used  # it is ours
    with pytest.raises(AssertionError, match="expected/part.json: expected a reference"):
        values["test_the_part_is_drawn_as_ever"]()
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("INKEDGE_ACCEPT", "1")
        values["test_the_part_is_drawn_as_ever"]()
    values["test_the_part_is_drawn_as_ever"]()
