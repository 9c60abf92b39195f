"""Renderers draw side by side in threads and processes, and memory stays as it is."""
import concurrent.futures
import multiprocessing
import os
import subprocess
import sys
import textwrap
import threading

import numpy as np
import pytest

import inkedge
from conftest import SOURCE, asset

SIZE = (128, 96)
PATIENCE = 120  # seconds until a process counts as hanging


def draw(azimuth=0.0):
    scene = inkedge.Scene.load(asset("gear"))
    with inkedge.Renderer() as renderer:
        return renderer.render(scene, inkedge.Camera.frame(scene, azimuth=azimuth), size=SIZE)["ids"].copy()


def run(code):
    """What a process of its own says: one that has not drawn yet."""
    return subprocess.run([sys.executable, "-c", textwrap.dedent(code), str(SOURCE)], capture_output=True, text=True,
                          timeout=PATIENCE, check=False)


def test_several_renderers_draw_in_several_threads(renderer, gear):
    azimuths = range(0, 360, 45)
    expected = [renderer.render(gear, inkedge.Camera.frame(gear, azimuth=a), size=SIZE)["ids"] for a in azimuths]
    with concurrent.futures.ThreadPoolExecutor(4) as pool:
        for found, right in zip(pool.map(draw, azimuths), expected, strict=True):
            assert np.array_equal(found, right)


def test_threads_that_share_a_renderer_wait_for_each_other(renderer, gear, lantern):
    def both(scene):
        camera = inkedge.Camera.frame(scene)
        return [renderer.render(scene, camera, size=SIZE)["ids"] for _ in range(8)]

    expected = {scene: both(scene)[0] for scene in (gear, lantern)}
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for scene, drawn in zip((gear, lantern), pool.map(both, (gear, lantern)), strict=True):
            assert all(np.array_equal(each, expected[scene]) for each in drawn)


def test_other_threads_go_on_while_one_loads_and_draws(renderer, gear, view):
    count, done = 0, threading.Event()

    def counts():
        nonlocal count
        while not done.wait(0.0005):  # gives the GIL away
            count += 1

    def goes_on_during(action):
        before = count
        return any(count > before for _ in range(200) if action())  # the machine may be busy with others

    interval = sys.getswitchinterval()
    counter = threading.Thread(target=counts)
    try:
        sys.setswitchinterval(600)  # no thread is made to give it away
        counter.start()
        assert goes_on_during(lambda: inkedge.Scene.load(asset("teapot")))
        assert goes_on_during(inkedge.Renderer)
        assert goes_on_during(lambda: renderer.render(gear, view, size=SIZE))
        assert goes_on_during(lambda: len(renderer.lines(gear, view, size=SIZE)))
        assert not goes_on_during(lambda: [0] * 100_000), "of what keeps the GIL"
    finally:
        done.set()
        sys.setswitchinterval(interval)
        counter.join()


@pytest.mark.parametrize("method", ["spawn", "forkserver"])
def test_processes_draw(method, renderer, gear):
    expected = renderer.render(gear, inkedge.Camera.frame(gear, azimuth=45), size=SIZE)["ids"]
    with multiprocessing.get_context(method).Pool(2) as pool:
        for found in pool.map_async(draw, [45.0, 45.0]).get(PATIENCE):
            assert np.array_equal(found, expected)


def test_a_process_may_fork_before_it_draws():
    done = run("""
        import multiprocessing, os, sys
        import inkedge

        scene = inkedge.Scene.load(f"{sys.argv[1]}/assets/gear.glb")
        camera = inkedge.Camera.frame(scene)

        def draw(_):
            with inkedge.Renderer() as renderer:
                return int(renderer.render(scene, camera, size=(64, 64))["ids"].sum())

        with multiprocessing.get_context("fork").Pool(2) as pool:
            sums = pool.map(draw, range(4))
        print(set(sums) == {draw(0)})
        """)
    assert (done.stdout, done.returncode) == ("True\n", 0), done.stderr


def test_a_fork_of_a_process_that_has_drawn_is_refused_and_ends():
    done = run("""
        import os, sys
        import inkedge

        scene = inkedge.Scene.load(f"{sys.argv[1]}/assets/gear.glb")
        camera = inkedge.Camera.frame(scene)
        renderer = inkedge.Renderer()
        renderer.render(scene, camera, size=(64, 64))
        child = os.fork()
        if child == 0:
            draws = lambda: renderer.render(scene, camera)
            for action in (inkedge.Renderer, draws, lambda: renderer.lines(scene, camera)):
                try:
                    action()
                except inkedge.RuntimeError as error:
                    print(str(error).startswith("expected a process of its own, found a fork of one"), flush=True)
            del renderer
            sys.exit(3)
        print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), flush=True)
        renderer.render(scene, camera, size=(64, 64))
        """)
    assert (done.stdout, done.returncode) == ("True\nTrue\nTrue\n3\n", 0), done.stderr


def test_exact_lines_are_found_in_threads_and_after_them(gear, view):
    def count(_):
        with inkedge.Renderer(lazy=True) as renderer:
            return len(renderer.lines(gear, view, size=SIZE))

    with concurrent.futures.ThreadPoolExecutor(4) as pool:
        assert len(set(pool.map(count, range(8)))) == 1


def resident():
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def test_drawing_leaves_nothing_behind(renderer):
    """tests/benchmarks/README.md has the figure of 10,000 renders."""
    scenes = [inkedge.Scene.from_arrays(np.random.default_rng(i).random((300, 3)), np.arange(300).reshape(-1, 3))
              for i in range(10)]
    cameras = [inkedge.Camera.frame(scene) for scene in scenes]

    def round_of_all(times):
        for _ in range(times):
            for scene, camera in zip(scenes, cameras):
                renderer.render(scene, camera, size=SIZE)
                renderer.lines(scene, camera, size=SIZE)

    round_of_all(3)
    before = resident()
    round_of_all(10)
    assert resident() < before * 1.02
