"""Every stage by itself: what the benchmark programs measured, and the rows of it."""

import json
import statistics

from lib.bench.processes import fail
from lib.bench.table import Row, against, mb, ms

SIZES = ["1024x1024", "1920x1080", "3840x2160"]
COUNTS = [10_000, 100_000, 1_000_000]
COUNTERS = ("triangles", "strokes", "bytes", "edge_pixels", "differing_pixels", "bytes_per_second", "edges")
COUNTERS += ("contour_edges",)
COUNTERS += ("missed", "lines_found", "curves", "intersections", "chains", "crossings", "visibility", "lines")


def read_stages(file):
    """name -> medians over the repetitions, milliseconds; and what the program says of its context."""
    report = json.loads(file.read_text())
    runs = {}
    for entry in report["benchmarks"]:
        if entry.get("error_occurred"):
            fail(f"{entry['name']}: {entry.get('error_message')}")
        if entry["run_type"] == "iteration":
            name = entry["run_name"]
            for suffix in ("/process_time", "/real_time", "/manual_time", "/iterations:10"):
                name = name.replace(suffix, "")
            runs.setdefault(name, []).append(entry)
    stages = {}
    for name, entries in runs.items():
        stages[name] = {
            "cpu_ms": statistics.median(entry["cpu_time"] for entry in entries),
            "wall_ms": statistics.median(entry["real_time"] for entry in entries),
            "repetitions_cpu_ms": [entry["cpu_time"] for entry in entries],
            "repetitions_wall_ms": [entry["real_time"] for entry in entries],
        }
        for counter in COUNTERS:
            if counter in entries[0]:
                stages[name][counter] = statistics.median(entry[counter] for entry in entries)
    return stages, report["context"]


def time_stages(bench, filters, repetitions, seconds, program="stages_benchmark"):
    out = bench.folder / "stages.json"
    bench.run(
        [
            bench.programs / program,
            f"--benchmark_filter={filters}",
            f"--benchmark_repetitions={repetitions}",
            f"--benchmark_min_time={seconds}",
            # Lines' models are large: one is kept at a time.
            f"--benchmark_enable_random_interleaving={'false' if program == 'lines_benchmark' else 'true'}",
            f"--benchmark_out={out}",
            "--benchmark_out_format=json",
        ]
    )
    return read_stages(out)


def stage_rows(stages, context):
    software = context["software"] == "yes"
    clock = "cpu_ms" if software else "wall_ms"
    no_opencv = "no OpenCV" if context["opencv"] == "no" else "not measured"

    def took(*names):
        return sum(stages[name][clock] for name in names) if all(name in stages for name in names) else None

    def limit(target):  # these hold for software OpenGL
        return target if software else "-"

    rows = [against("context in a process that had one", took("context"), "", None, missing="-")]
    for count in COUNTS:
        for shape in ("cad", "smooth"):
            model = f"{shape}/{count}"
            actual = stages.get(f"load/{model}", {}).get("triangles", count)
            for stage in ("load", "prepare", "upload"):
                metric = f"{stage} {shape}, {actual:,.0f} triangles"
                rows.append(against(metric, took(f"{stage}/{model}"), "memcpy", took(f"memcpy/mesh/{model}")))
    for stage in ("planes", "surface"):
        for count in COUNTS:
            for shape in ("cad", "smooth"):
                for size in SIZES:
                    name = f"{stage}/{shape}/{count}/{size}"
                    rows.append(against(f"geometry pass {name}", took(name), "", None, missing="-"))
    for size in SIZES:
        opencv = took(f"opencv-farid/{size}")
        ink = limit("<= 1.0") if size == "1024x1024" else "-"
        rows += [
            against(f"edge pass classic Sobel {size}", took(f"edges-sobel/{size}"),
                    "OpenCV", took(f"opencv-sobel/{size}"),
                    missing=no_opencv),
            against(f"edge pass classic Farid {size}", took(f"edges-farid/{size}"), "OpenCV", opencv, limit("<= 1.2"),
                    no_opencv),
            *(against(f"edge pass of a function, {name} {size}", took(f"function-{name}/{size}"), f"classic {kernel}",
                      took(f"edges-{kernel}/{size}"), limit("<= 1.2"))
              for kernel in ("sobel", "farid") for name in (kernel, f"wrapped-{kernel}")),
            against(f"a function's values {size}", took(f"function/{size}"), "planes",
                    took(f"planes/cad/100000/{size}")),
            against(f"edge pass planes {size}", took(f"lines-pass/{size}"),
                    "OpenCV", opencv, limit("<= 0.7"), no_opencv),
            against(f"the same, with read-back {size}", took(f"lines/{size}"), "OpenCV", opencv, missing=no_opencv),
            against(f"ink, width 2 {size}", took(f"trace/{size}", f"paint/{size}"), "OpenCV", opencv, ink, no_opencv),
            against(f"composite {size}", took(f"composite/{size}"), "memcpy", took(f"memcpy/picture/{size}")),
            against(f"read-back {size}", took(f"read-back/{size}"), "memcpy", took(f"memcpy/planes-triangles/{size}")),
            against(f"encode PNG {size}", took(f"encode/{size}"), "memcpy", took(f"memcpy/picture/{size}")),
            against(f"memcpy of an edge pass's input {size}", took(f"memcpy/surface/{size}"), "OpenCV", opencv,
                    missing=no_opencv),
        ]  # fmt: skip
    for count in COUNTS:
        name = f"view/cad/{count}/1024x1024"
        rows.append(against(f"warm {name}", took(name), "", None, missing="-"))
    return [row for row in rows if row]


def lines_rows(stages):
    """Lines from object space, by lines_benchmark; needs no graphics."""
    rows = []
    found = {tuple(name.split("/")[1:]): timing for name, timing in stages.items() if name.startswith("find/")}
    for (shape, count, finder), timing in found.items():
        model = f"{shape}/{count}"
        metric = f"contour edges of {timing['edges']:,.0f}, {shape}, {finder}"
        every = found.get((shape, count, "every"))
        if finder == "every":
            rows.append(against(metric, timing["cpu_ms"], "one read", stages[f"read-arrays/{model}"]["cpu_ms"]))
            continue
        rows.append(against(metric, timing["cpu_ms"], "every", every and every["cpu_ms"]))
        if finder == "random":
            share = 1.0 - timing["missed"]
            rows.append(Row("  share found, by length", f"{share:.4f}", "all", share, ">= 0.99").judge())
        made = stages[f"prepare-finder/{model}/{finder}"]
        rows.append(Row("  made once", f"{ms(made['cpu_ms'])}, {mb(made['bytes'])}"))
    for count, target in (("100000", 20.0), ("1000000", 80.0)):
        for shape in ("cad", "smooth"):
            view = stages.get(f"object-lines/{shape}/{count}")
            if view is None:
                continue
            for name, metric in (("edge-table", "edge table"), ("ray-tree", "tree of the rays")):
                rows.append(Row(f"{metric}, {shape}/{count}, once", ms(stages[f"{name}/{shape}/{count}"]["cpu_ms"])))
            # Without waiting, wall time is no more than this.
            metric = f"lines of a view, {shape}/{count}, CPU time of all threads"
            rows.append(against(metric, view["cpu_ms"], "target", target, "<= 1"))
            rows.append(Row("  its wall time", ms(view["wall_ms"])))
            for stage in ("curves", "intersections", "chains", "crossings", "visibility", "lines"):
                if stage in view:
                    rows.append(Row(f"  {stage}, least wall time", ms(view[stage])))
    return [row for row in rows if row]


DEVICE_TABLE = "The graphics card, by its own clock"


def device_rows(stages):
    rows = []
    for size in ("3840x2160", "7680x4320"):
        copy = stages[f"device/copy/{size}"]
        rows.append(Row(f"copy of textures {size}", ms(copy["wall_ms"]), f"{copy['bytes_per_second'] / 1e9:.0f} GB/s"))
        planes = stages[f"device/planes/cad/100000/{size}"]
        rows.append(Row(f"geometry pass planes/cad/100000 {size}", ms(planes["wall_ms"])))
        passes = (("edges-sobel", "classic Sobel"), ("edges-farid", "classic Farid"), ("lines-pass", "planes"))
        for name, metric in passes:
            edges = stages[f"device/{name}/{size}"]
            share = edges["bytes_per_second"] / copy["bytes_per_second"]
            value = f"{ms(edges['wall_ms'])}, {edges['bytes_per_second'] / 1e9:.0f} GB/s"
            yardstick = f"copy {copy['bytes_per_second'] / 1e9:.0f} GB/s"
            rows.append(Row(f"edge pass {metric} {size}", value, yardstick, share, ">= 0.6").judge())
    return rows
