"""Ctrl-C ends a long call, and not only once it has come to its end."""
import subprocess
import sys
import textwrap

import pytest

from conftest import SOURCE

PATIENCE = 120  # seconds: drawing would take longer, and what is loaded would be refused


@pytest.fixture(scope="module")
def slow_surface(tmp_path_factory):
    """A model of slow values and fine waves: over half a minute on it is refused, for it has too many vertices."""
    file = tmp_path_factory.mktemp("models") / "slow.implicit"
    slow = "+".join(["sin(x)*exp(y)"] * 680)
    waves = "0.001*sin(400*x)*sin(400*y)*sin(400*z)"
    file.write_text(f"bounds -1 -1 -1  1 1 1\nf = x^2 + y^2 + z^2 - 0.5 + {waves} + 1e-9*({slow})\n")
    return file


CALLS = {
    "load": "inkedge.Scene.load(sys.argv[2], tolerance=0.001)",
    "render": 'renderer.render(scene, camera, size=(16384, 16384), maps=(), supersampling=4, tile_size=256)',
    "lines": 'renderer.lines(scene, camera, size=(16384, 16384), lines_from="image", supersampling=4, tile_size=256)',
}


def interrupted(call, before, surface):
    """What a process says that runs a call and gets SIGINT a moment after it has begun."""
    code = textwrap.dedent(f"""
        import signal, sys
        import inkedge

        scene = inkedge.Scene.load(f"{{sys.argv[1]}}/assets/cube.glb")
        camera = inkedge.Camera.frame(scene)
        renderer = inkedge.Renderer()
        renderer.render(scene, camera, size=(64, 64))
        {before}
        try:
            signal.setitimer(signal.ITIMER_REAL, 0.3)
            {call}
            print("it came to its end")
        except (KeyboardInterrupt, OverflowError) as error:
            print(type(error).__name__)
        print(renderer.render(scene, camera, size=(64, 64))["picture"].shape)
        """)
    done = subprocess.run([sys.executable, "-c", code, str(SOURCE), surface], capture_output=True, text=True,
                          timeout=PATIENCE, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()


@pytest.mark.parametrize("name", CALLS)
def test_ctrl_c_ends_a_call(name, slow_surface):
    before = "signal.signal(signal.SIGALRM, lambda *_: signal.raise_signal(signal.SIGINT))"
    assert interrupted(CALLS[name], before, slow_surface) == ["KeyboardInterrupt", "(64, 64)"], "and it draws again"


def test_what_another_handler_raises_ends_it(slow_surface):
    before = "def fail(*_): raise OverflowError\nsignal.signal(signal.SIGALRM, fail)".replace("\n", "\n" + " " * 8)
    assert interrupted(CALLS["load"], before, slow_surface) == ["OverflowError", "(64, 64)"]


def test_a_signal_that_raises_nothing_ends_nothing(slow_surface):
    before = "signal.signal(signal.SIGALRM, lambda *_: print('seen', flush=True))"
    call = 'renderer.render(scene, camera, size=(2048, 2048), maps=(), supersampling=4, tile_size=256)'
    assert interrupted(call, before, slow_surface) == ["seen", "it came to its end", "(64, 64)"]
