import os
import pathlib

import pytest

import inkedge

SOURCE = pathlib.Path(os.environ["TESTED_SOURCE"])
COMMAND = os.environ["TESTED_COMMAND"]


def asset(name):
    return SOURCE / "assets" / f"{name}.glb"


@pytest.fixture(scope="session")
def renderer():
    with inkedge.Renderer() as opened:
        yield opened


@pytest.fixture(scope="session")
def gear():
    return inkedge.Scene.load(asset("gear"))


@pytest.fixture(scope="session")
def lantern():
    return inkedge.Scene.load(asset("lantern"))


@pytest.fixture(scope="session")
def view(gear):
    return inkedge.Camera.frame(gear, azimuth=-30, elevation=22)
