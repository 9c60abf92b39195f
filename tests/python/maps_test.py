"""Maps are arrays of documented shapes, which are C++'s own memory."""
import gc

import numpy as np
import pytest

import inkedge
from conftest import asset

WIDTH, HEIGHT = SIZE = (96, 64)
ALL = ("depth", "normal", "depth_edges", "normal_edges", "edges", "types", "ids", "shade")
KINDS = {
    "depth": ("float32", ()), "normal": ("float32", (3,)), "depth_edges": ("uint8", ()), "normal_edges": ("uint8", ()),
    "edges": ("uint8", ()), "types": ("uint16", ()), "ids": ("uint32", (4,)), "shade": ("uint8", (4,)),
    "picture": ("uint8", ()),
}


@pytest.fixture(scope="module")
def maps(renderer):
    scene = inkedge.Scene.load(asset("lantern"), shade="light")
    return renderer.render(scene, inkedge.Camera.frame(scene), size=SIZE, maps=ALL, detector="classic")


def test_maps_have_their_shapes_and_types(maps):
    assert list(maps) == ["picture", *ALL]
    for name, array in maps.items():
        dtype, channels = KINDS[name]
        assert (array.dtype, array.shape) == (np.dtype(dtype), (HEIGHT, WIDTH, *channels)), name
        assert array.flags.c_contiguous


def test_a_picture_has_as_many_channels_as_its_colours_need(renderer, gear, view):
    for settings, channels in (({}, ()), ({"line_color": "red"}, (3,)), ({"background": "none"}, (4,))):
        picture = renderer.render(gear, view, size=SIZE, maps=(), **settings)["picture"]
        assert picture.shape == (HEIGHT, WIDTH, *channels)


def test_arrays_are_read_only_unless_writable_ones_are_asked_for(renderer, gear, view, maps):
    for array in maps.values():
        assert not array.flags.writeable
        with pytest.raises(ValueError):
            array.setflags(write=True)
    for array in renderer.render(gear, view, size=SIZE, writable=True).values():
        array[:] = 0


def test_an_array_outlives_all_that_it_came_from(gear):
    with inkedge.Renderer() as renderer:
        maps = renderer.render(gear, inkedge.Camera.frame(gear), size=SIZE)
    depth, kept = maps["depth"], maps["depth"].copy()
    del maps, renderer
    gc.collect()
    assert np.array_equal(depth, kept)
    assert not depth.flags.owndata and type(depth.base).__name__ == "PyCapsule"


def test_maps_are_a_mapping(maps):
    assert "depth" in maps and "nothing" not in maps and maps.get("nothing") is None and len(maps) == 9
    assert dict(maps).keys() == maps.keys() and dict(**maps)["depth"] is maps["depth"]
    with pytest.raises(KeyError):
        maps["nothing"]
    assert repr(maps).startswith("<inkedge.Maps of 96 x 64: picture, depth, normal, ")


def test_maps_agree_with_each_other(renderer, lantern):
    maps = renderer.render(lantern, inkedge.Camera.frame(lantern), size=SIZE)
    background = maps["ids"][..., 2] == 0
    assert np.array_equal(background, maps["depth"] == np.float32(maps.camera.far))
    lengths = np.linalg.norm(maps["normal"], axis=2)
    assert np.array_equal(background, lengths == 0) and np.allclose(lengths[~background], 1, atol=1e-5)
    assert (maps["types"] & inkedge.LineType.OUTLINE > 0).any()
    assert maps.instance_names == ["", "lantern/cup", "lantern/pane", "leaf"]
    assert {maps.instance_names[i] for i in np.unique(maps["ids"][..., 2])} == set(maps.instance_names)
    assert maps.backend.renderer and maps.times["read-back"] >= 0


def test_types_of_lines_are_the_tables():
    lines = inkedge.settings["lines"].choices
    assert [(flag.name.lower(), flag.value) for flag in inkedge.LineType] == [(n, 1 << i) for i, n in enumerate(lines)]
