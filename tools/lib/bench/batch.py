"""Many small models: inkedge batch against a shell loop of inkedge render."""

import importlib.util
import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from lib.bench.processes import CORES, fail, say, take_turns
from lib.bench.table import Row, mb, ms

ROOT = Path(__file__).resolve().parents[3]
VIEWS = 4
FLAGS = ["--views", f"turntable:{VIEWS}", "--size", "512x512", "-q"]
MAPS = ["--maps", "depth,ids"]
HOSTILE = 0.01  # share of all models


def corpus(bench, count):
    """A folder of small models of many sizes, some of them hostile."""
    folder = bench.folder / "corpus"
    folder.mkdir()
    for i in range(count):
        shape, triangles = ("cad", "smooth", "scan")[i % 3], 500 + 37 * (i % 101)
        shutil.copyfile(bench.model(shape, triangles)[0], folder / f"{i:05}.glb")
    hostile = bench.folder / "hostile"
    subprocess.run([sys.executable, ROOT / "tools/make_hostile", hostile], check=True, stdout=subprocess.DEVNULL)
    refused = [case["file"] for case in json.loads((hostile / "expected.json").read_text())
               if not case["picture"] and case["file"].endswith(".glb")]  # fmt: skip
    for i in range(max(1, int(HOSTILE * count))):
        shutil.copyfile(hostile / refused[i % len(refused)], folder / f"{i:05}.glb")
    return folder


def fresh(bench):
    """A folder for what one run writes. It stays until all runs are over: just after files were removed ext4 takes
    several times as long to make others, and the next run would pay for it."""
    return Path(tempfile.mkdtemp(dir=bench.folder))


def batch(bench, models, *more):
    """A batch; some of its models are hostile: it ends with 1."""
    out = fresh(bench)
    sample = bench.measure([bench.programs / "inkedge", "batch", models, "-o", out, *FLAGS, "--json", *more])
    if sample.status not in (0, 1):
        fail(f"inkedge batch: expected success, found exit status {sample.status}: {sample.errors.strip()}")
    results = [json.loads(line) for line in (out / "results.jsonl").read_text().splitlines()]
    return sample, results


def loop(bench, models):
    """The same by a shell loop of render, as many at a time as there are cores."""
    out = fresh(bench)
    script = (
        f'ls {models} | xargs -P {CORES} -I NAME sh -c \'mkdir -p "{out}/NAME" && '
        f'"{bench.programs}/inkedge" render "{models}/NAME" -o "{out}/NAME/{{view}}.{{map}}.png" '
        f'--metadata "{out}/NAME/{{view}}.json" {" ".join(FLAGS + MAPS)} 2>/dev/null || true\''
    )
    return bench.measure(["sh", "-c", script])


def pool(bench, models, *maps):
    """Edges of the same models by worker processes of moderngl and OpenCV; with "maps", depth and ids, too."""
    out = fresh(bench)
    script = Path(__file__).with_name("peers") / "moderngl_edges.py"
    sample = bench.measure([sys.executable, script, "--pool", models, out, "512", VIEWS, CORES, *maps])
    pictures = len(list(out.glob("*/*.png")))
    if sample.status != 0 or pictures < (2 if maps else 0.9) * VIEWS * len(list(models.iterdir())):
        fail(f"moderngl's pool: expected pictures, found {pictures}: {sample.errors.strip()[-200:]}")
    return sample


def batch_rows(bench, count):
    models = corpus(bench, count)
    part = bench.folder / "part"  # of what the loop is given, too
    part.mkdir()
    for model in sorted(models.iterdir())[:: max(1, count // 100)]:
        shutil.copyfile(model, part / model.name)
    few = len(list(part.iterdir()))
    rivals = {"batch": lambda: batch(bench, part, *MAPS)[0], "loop": lambda: loop(bench, part),
              "pictures": lambda: batch(bench, part)[0]}
    if all(importlib.util.find_spec(module) for module in ("moderngl", "cv2")):
        rivals["pool"] = lambda: pool(bench, part, "maps")
        rivals["pool of pictures"] = lambda: pool(bench, part)
    else:
        say("no moderngl or OpenCV for Python here: batch is not held against a pool of them")
    took = take_turns(rivals, 3)
    one = take_turns({"one": lambda: batch(bench, part, *MAPS, "--jobs", "1")[0]}, 1)["one"]
    sample, results = batch(bench, models, *MAPS)
    drawn = sum(result["state"] == "drawn" for result in results)
    each = one.cpu / few
    text = f"{count} models x {VIEWS} views x (picture, depth, ids), 512x512"
    rate = count / sample.wall
    against = [
        Row(f"  {what}", f"{few / took[ours].wall:.1f} models/s", f"{few / took[theirs].wall:.1f} models/s",
            took[theirs].wall / took[ours].wall, target).judge()
        for ours, theirs, what, target in (
            ("batch", "loop", "against a shell loop of render", ">= 5"),
            ("batch", "pool", "against worker processes of moderngl and OpenCV", ">= 4"),
            ("pictures", "pool of pictures", "the same, pictures alone", ">= 4"))
        if theirs in took
    ]  # fmt: skip
    return [
        Row(text, f"{rate:.1f} models/s", f"{CORES} cores, CPU time of one {ms(each * 1e3)}", rate * each / CORES,
            ">= 0.95", details={"wall_s": sample.wall, "drawn": drawn}).judge(),
        *against,
        Row("  peak memory of a process", mb(sample.peak), "400 MB", sample.peak / 400e6, "<= 1").judge(),
    ]  # fmt: skip
