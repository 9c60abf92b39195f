#!/usr/bin/env python3
"""Makes a data set of a model: lines, depth, normals and ids of views around it, and their cameras.

usage: make_dataset.py MODEL FOLDER [VIEWS]; from a build tree with PYTHONPATH=build/release/python
"""
import json
import pathlib
import sys

import cv2
import inkedge


def main(model, folder, views="8"):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    scene = inkedge.Scene.load(model)
    cameras = {}
    with inkedge.Renderer() as renderer:
        for i in range(int(views)):
            camera = inkedge.Camera.frame(scene, azimuth=360 * i / int(views), elevation=20)
            maps = renderer.render(scene, camera, size=(640, 480))
            cv2.imwrite(f"{folder}/{i:03}_lines.png", (maps["types"] > 0).astype("uint8") * 255)  # white on black
            cv2.imwrite(f"{folder}/{i:03}_depth.tiff", maps["depth"])  # float32, units of the scene
            cv2.imwrite(f"{folder}/{i:03}_normal.png", (maps["normal"][..., ::-1] + 1) * 127.5)  # OpenCV has BGR
            cv2.imwrite(f"{folder}/{i:03}_ids.png", maps["ids"][..., 2].astype("uint16"))  # 0: background
            cameras[f"{i:03}"] = maps.camera.to_dict()
    labels = {instance.id: instance.node for instance in scene.instances}
    (folder / "cameras.json").write_text(json.dumps({"labels": labels, "cameras": cameras}, indent=1))


main(*sys.argv[1:])
