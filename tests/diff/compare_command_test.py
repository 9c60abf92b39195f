#!/usr/bin/env python3
"""What became of lines, by the command: pictures, files of lines and models in any mixture.

usage: compare_command_test.py SOURCE COMMAND
       compare_command_test.py FOLDER     writes the README's models there
"""
import json
import math
import os
import subprocess
import sys
import tempfile

PIXELS = 8  # to a unit of the models: --camera-orthographic 40 of 320 rows


class Model:
    """Text of an OBJ: prisms, each an object of its own."""

    def __init__(self):
        self.text, self.count = "", 0

    def prism(self, outline, z0, z1, hole=(), lies=False):
        """Between two heights; outline and hole are as many points, counter-clockwise, of rays from one point.

        One that lies is along y; its outline, then clockwise, is of x and z."""
        n = len(outline)
        for ring in (outline, hole) if hole else (outline,):
            for z in (z0, z1):
                self.text += "".join(f"v {x} {z} {y}\n" if lies else f"v {x} {y} {z}\n" for x, y in ring)
        faces = []
        low, high, hole_low, hole_high = (self.count + 1 + k * n for k in range(4))
        for i in range(n):
            j = (i + 1) % n
            faces.append((low + i, low + j, high + j, high + i))
            if hole:
                faces.append((hole_low + j, hole_low + i, hole_high + i, hole_high + j))
                faces.append((high + i, high + j, hole_high + j, hole_high + i))
                faces.append((low + j, low + i, hole_low + i, hole_low + j))
        if not hole:
            faces += [tuple(high + i for i in range(n)), tuple(low + i for i in reversed(range(n)))]
        self.text += "".join(f"f {' '.join(map(str, face))}\n" for face in faces)
        self.count += n * (4 if hole else 2)

    def write(self, name):
        with open(name, "w", encoding="ascii") as file:
            file.write(self.text)
        return name


def plate(name, hole=(10.0, 10.0), chamfer=True, cover=True):
    """A plate with a round hole, a roof with a chamfered ridge, and a block with a cover in front of a part of it."""
    model = Model()
    corners = 64
    angles = [2 * math.pi * (i + 0.5) / corners for i in range(corners)]
    directions = [(math.cos(a), math.sin(a)) for a in angles]
    square = [(10 + 8 * x / max(abs(x), abs(y)), 10 + 8 * y / max(abs(x), abs(y))) for x, y in directions]
    square = [min(((2, 2), (18, 2), (18, 18), (2, 18)), key=lambda c, p=p: math.dist(c, p))
              if i % 16 in (7, 8) else p for i, p in enumerate(square)]
    model.prism(square, 0, 1, [(hole[0] + 4 * x, hole[1] + 4 * y) for x, y in directions])
    ridge = [(29, 5), (33, 5)] if chamfer else [(31, 7)]
    model.prism([(24, 0), *ridge, (38, 0)], 2, 12, lies=True)
    model.prism([(26, 20), (38, 20), (38, 26), (26, 26)], 0, 1)
    if cover:
        model.prism([(29, 18), (33, 18), (33, 28), (29, 28)], 2, 3)
    return model.write(name)


VIEW = ["--size", "320x320", "--camera-orthographic", "40", "--camera-position", "20,16,60",
        "--camera-focal-point", "20,16,0"]


class Test:
    def __init__(self, source, command):
        self.source, self.command = source, command

    def render(self, model, output, *flags):
        subprocess.run([self.command, "render", model, "-o", output, "-q", *flags], check=True)
        return output

    def compare(self, a, b, *flags):
        done = subprocess.run([self.command, "compare", a, b, "--lines", "--json", *flags], capture_output=True,
                              check=False)
        assert done.returncode in (0, 1), done.stderr.decode()
        found = json.loads(done.stdout)
        assert found["same"] == (done.returncode == 0), found
        return found

    def expect_none(self, a, b, *flags):
        found = self.compare(a, b, *flags)
        assert not found["changes"], f"{a} and {b}: {summary(found)}"
        assert found["length_before"] > 100
        return found


def summary(found):
    return [(change["change"], change["type"], change["name"], round(change["length"], 1), change.get("distance"))
            for change in found["changes"]]


class SameScene(Test):
    """However a scene is drawn, its lines are the same."""

    def backends(self):
        for backend in ("egl", "osmesa"):
            done = subprocess.run([self.command, "render", self.bracket, "-o", f"{backend}.png", "-q", *self.view,
                                   "--backend", backend], capture_output=True, check=False)
            if done.returncode == 4:
                print(f"SKIPPED: pictures by {backend}, which does not work here", flush=True)
            else:
                assert done.returncode == 0, done.stderr.decode()
                yield f"{backend}.png"

    def check(self):
        self.bracket = os.path.join(self.source, "assets", "bracket.glb")
        self.view = ["--azimuth", "35", "--elevation", "28", "--size", "640x640"]
        pictures = list(self.backends())
        if pictures:
            for flags in (["--supersampling", "2"], ["--lines-from", "object"]):
                pictures.append(self.render(self.bracket, f"{flags[0][2:]}.png", *self.view, *flags))
            for picture in pictures[1:]:
                self.expect_none(pictures[0], picture)
            image = self.render(self.bracket, "image.json", *self.view, "--lines-from", "image")
        exact = self.render(self.bracket, "exact.json", *self.view)
        svg = self.render(self.bracket, "exact.svg", *self.view)
        self.expect_none(exact, svg, "--distance", "0.5")
        self.expect_none(exact, self.bracket)  # drawn by the camera of the file
        self.expect_none(self.bracket, svg, *self.view)
        if pictures:
            self.expect_none(exact, image)
            # Where three lines of 1.5 pixels meet within 3, a picture has one blot of ink.
            self.expect_none(exact, pictures[0], "--speck", "6")


class Changes(Test):
    """What changed in a model is found, and nothing else, in pictures, files of lines and the models themselves."""

    def variants(self, name, **changed):
        model = plate(f"{name}.obj", **changed)
        self.render(model, f"{name}.json", *VIEW)
        self.render(model, f"{name}.svg", *VIEW)
        self.render(model, f"{name}.png", *VIEW, "--lines-from", "object")
        return name

    def each(self, a, b):
        for extension, flags in (("obj", VIEW), ("json", []), ("svg", []), ("png", [])):
            yield extension, self.compare(f"{a}.{extension}", f"{b}.{extension}", *flags)

    def check_hole(self):
        moved = self.variants("moved", hole=(10.25, 10))
        for extension, found in self.each("plate", moved):
            changes = found["changes"]
            assert [c["change"] for c in changes] == ["moved"], f"{extension}: {summary(found)}"
            change = changes[0]
            assert math.dist(change["way"], (0.25 * PIXELS, 0)) < 0.15, f"{extension}: {change['way']}"
            assert abs(change["length"] - 2 * math.pi * 4 * PIXELS) < 4, f"{extension}: {change['length']}"
            if extension != "png":
                assert (change["type"], change["name"]) == ("outline", "moved"), f"{extension}: {summary(found)}"

    def check_chamfer(self):
        for extension, found in self.each("plate", self.variants("sharp", chamfer=False)):
            changes = found["changes"]
            # Of its two edges one is left, between them.
            assert sorted(c["change"] for c in changes) == ["appeared", "vanished", "vanished"], summary(found)
            assert all(abs(c["length"] - 10 * PIXELS) < 4 for c in changes), f"{extension}: {summary(found)}"
            if extension != "png":
                assert all(c["type"] == "crease" for c in changes), summary(found)

    def check_hidden(self):
        self.variants("bare", cover=False)
        found = self.compare("plate.obj", "bare.obj", *VIEW)
        assert {c["change"] for c in found["changes"]} == {"vanished", "visibility"}, summary(found)
        gone = sum(c["length"] for c in found["changes"] if c["change"] == "vanished")
        assert abs(gone - 2 * (4 + 10) * PIXELS) < 3, summary(found)
        seen = [c for c in found["changes"] if c["change"] == "visibility"]
        assert all(c["visible"] and not c["visible_before"] for c in seen), seen
        # 1.5 pixels at each end are as near to what was seen before.
        assert abs(sum(c["length"] for c in seen) - 2 * (4 * PIXELS - 3)) < 2, summary(found)
        # One line of a file, and nothing else.
        with open("plate.json", encoding="utf-8") as file:
            lines = json.load(file)
        line = next(line for line in lines["lines"] if line["type"] == "crease" and line["visible"])
        line["visible"] = False
        with open("one.json", "w", encoding="utf-8") as file:
            json.dump(lines, file)
        changes = self.compare("one.json", "plate.json")["changes"]
        assert [(c["change"], c["visible"], c["name"]) for c in changes] == [("visibility", True, "plate")], changes

    def check_command(self):
        done = subprocess.run([self.command, "compare", "plate.png", "moved.png", "--lines", "-o", "changes.svg"],
                              capture_output=True, check=False)
        first, second = done.stdout.decode().splitlines()[:2]
        assert done.returncode == 1 and first.startswith("different: 1 change on "), done.stdout
        assert second.startswith("  moved      line, ") and "(2.0 right, 0.0 " in second, second
        with open("changes.svg", encoding="utf-8") as file:
            assert 'inkscape:label="changed"' in file.read()
        assert self.compare("plate.png", "moved.png", "--share", "0.5")["same"]
        for flags, said in ((["--level", "0.1"], "--level: expected it without --lines"),
                            (["-o", "x.dxf"], "x.dxf: expected a name that ends in .svg, .pdf or .png"),
                            (["-o", "plate.png"], "plate.png: expected an output other than what is compared")):
            done = subprocess.run([self.command, "compare", "plate.png", "moved.png", "--lines", *flags],
                                  capture_output=True, check=False)
            assert done.returncode == 2 and said in done.stderr.decode(), done.stderr
        done = subprocess.run([self.command, "compare", "plate.json", "plate.svg", "--lines", "--view", "iso"],
                              capture_output=True, check=True)
        assert done.stderr == b"inkedge: warning: --view does nothing: it is for models\n", done.stderr
        done = subprocess.run([self.command, "compare", "plate.png", "moved.png", "--distance", "2"],
                              capture_output=True, check=False)
        assert done.returncode == 2 and b"--distance: expected it with --lines" in done.stderr, done.stderr
        with open("other.svg", "w", encoding="utf-8") as file:
            file.write("<svg viewBox='0 0 1 1'/>")
        done = subprocess.run([self.command, "compare", "other.svg", "plate.png", "--lines"], capture_output=True,
                              check=False)
        assert done.returncode == 3 and b"other.svg: expected an SVG that inkedge wrote" in done.stderr, done.stderr

    def check(self):
        self.variants("plate")
        self.check_hole()
        self.check_chamfer()
        self.check_hidden()
        self.check_command()


def write_models(folder):
    os.chdir(folder)
    plate("old.obj")
    plate("new.obj", hole=(10.25, 10), chamfer=False, cover=False)


def main():
    if len(sys.argv) == 2:
        return write_models(sys.argv[1])
    source, command = map(os.path.abspath, sys.argv[1:])
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        SameScene(source, command).check()
        Changes(source, command).check()
        os.chdir(source)
    print("what changed is found, and nothing else")


if __name__ == "__main__":
    main()
