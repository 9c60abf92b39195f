"""How time and memory grow with triangles, pixels and views."""

import math

from lib.bench.commands import views_command
from lib.bench.processes import take_turns
from lib.bench.stages import SIZES
from lib.bench.table import mb, print_columns


def growth(bench, quick):
    """name of the series -> rows of (amount, timing)."""
    counts = [10_000, 100_000, 1_000_000] if quick else [10_000, 30_000, 100_000, 300_000, 1_000_000, 2_000_000]
    sizes = ["512x512", "1024x1024", "3840x2160"] if quick else ["512x512", *SIZES, "7680x4320"]
    views = [1, 10, 50] if quick else [1, 10, 100, 1000]
    repetitions = 1 if quick else 3

    def series(commands, times=repetitions):
        took = take_turns({amount: lambda c=command: bench.run(c) for amount, command in commands.items()}, times)
        return list(took.items())

    result = {
        "triangles, at 1024x1024": series(
            {triangles: bench.render(file, "1024x1024") for file, triangles in (bench.model("cad", n) for n in counts)}
        ),
        "pixels, of 9,984 triangles": series(
            {math.prod(map(int, size.split("x"))): bench.render(bench.model("cad", 10_000)[0], size) for size in sizes}
        ),
    }
    if bench.available(views_command(bench, 2, "64x64")):
        commands = {n: views_command(bench, n, "512x512") for n in views}
        result["views, of 9,984 triangles at 512x512"] = series(commands, 1)
    return result


def print_growth(series):
    for name, points in series.items():
        print(f"\nGrowth with {name}; the last two columns: per unit more than in the row above")
        rows = []
        before = None
        for amount, timing in points:
            more = ["", ""]
            if before:
                units = amount - before[0]
                cpu, peak = timing.cpu - before[1].cpu, timing.peak - before[1].peak
                more = [f"{cpu / units * 1e6:.3g} us", f"{peak / units:.0f} bytes"]
            rows.append([f"{amount:,}", f"{timing.wall:.3f} s", f"{timing.cpu:.3f} s", mb(timing.peak), *more])
            before = amount, timing
        print_columns([name.split(",")[0], "wall", "CPU", "peak", "CPU time", "memory"], rows)
