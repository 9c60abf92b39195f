"""draw.py MODEL PREFIX: draws a model with the Python module that is installed there."""
import sys

import inkedge

assert inkedge.__file__.startswith(sys.argv[2] + "/"), f"expected the module of {sys.argv[2]}, found {inkedge.__file__}"
scene = inkedge.Scene.load(sys.argv[1])
camera = inkedge.Camera.frame(scene)
with inkedge.Renderer() as renderer:
    maps = renderer.render(scene, camera, size=(256, 192))
    assert maps["picture"].shape == (192, 256) and 0.002 < (maps["types"] > 0).mean() < 0.5
    print(f"inkedge {inkedge.__version__} of Python: {len(renderer.lines(scene, camera))} lines")
