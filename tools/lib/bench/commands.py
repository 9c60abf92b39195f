"""Whole commands: started cold, with many models, with many views, with a large mesh."""

import json
import statistics

from lib.bench.processes import CORES, take_turns
from lib.bench.table import Row, against, mb, ms


def cold_rows(bench, repetitions):
    model, triangles = bench.model("cad", 10_000)
    command = bench.render(model, "1024x1024")
    context = bench.context_only()
    for arguments in (command, context):
        bench.run(arguments)  # warms the cache
    took = take_turns(
        {
            "context, warm": lambda: bench.run(context),
            "command, warm": lambda: bench.run(command),
            "context, empty": lambda: bench.run_with_empty_cache(context),
            "command, empty": lambda: bench.run_with_empty_cache(command),
        },
        repetitions,
    )
    rows = []
    for cache, target in (("warm", "<= 2.5"), ("empty", "<= 3.5")):
        timing, yardstick = took[f"command, {cache}"], took[f"context, {cache}"]
        metric = f"cold command, {triangles:,} triangles, 1024x1024, shader cache {cache}"
        rows.append(against(metric, timing.wall * 1e3, "context only", yardstick.wall * 1e3, target))
        rows[-1].details["wall_s"] = [sample.wall for sample in timing.samples]
        rows[-1].details["yardstick_wall_s"] = [sample.wall for sample in yardstick.samples]
        rows.append(against("  its CPU time", timing.cpu * 1e3, "context only", yardstick.cpu * 1e3))
    rows.append(Row("  its peak memory", mb(took["command, warm"].peak),
                    f"context only {mb(took['context, warm'].peak)}",
                    took["command, warm"].peak / took["context, warm"].peak))  # fmt: skip
    return rows


def views_output(bench):
    (bench.folder / "views").mkdir(exist_ok=True)
    return "views/{view}.png"


def views_command(bench, count, size):
    model, _ = bench.model("cad", 10_000)
    return bench.render(model, size, "--views", f"turntable:{count}", output=views_output(bench))


def views_rows(bench, stages, count, repetitions):
    metric, target = f"{count} views of one model, 1024x1024", ">= 0.9"
    if not bench.available(views_command(bench, 2, "64x64")):
        return [Row(metric, "not available", target=target, verdict="not available").judge()]
    took = take_turns(
        {n: lambda n=n: bench.run(views_command(bench, n, "1024x1024")) for n in (1, count)}, repetitions
    )
    more = count - 1
    wall, cpu = took[count].wall - took[1].wall, took[count].cpu - took[1].cpu
    rows = []
    view = stages.get("view/cad/10000/1024x1024")
    for name, one in (("a warm view by itself", view and view["cpu_ms"] / 1e3), ("a view of this run", cpu / more)):
        if one is None or wall <= 0 or cpu <= 0:
            rows.append(Row(metric, "not measured", target=target).judge())
            continue
        value, yardstick = more / wall, CORES / one
        text = f"{yardstick:.1f}/s: {CORES} cores, CPU time of {name} {ms(one * 1e3)}"
        rows.append(Row(metric, f"{value:.1f}/s", text, value / yardstick, target, details={"cpu_s": one}).judge())
    return rows


def small_models_rows(bench, count):
    models = [bench.model("cad" if i % 2 else "smooth", 800 + 40 * i)[0] for i in range(count)]
    took = take_turns(
        {
            **{model: lambda m=model: bench.run(bench.render(m, "512x512")) for model in models},
            "context": lambda: bench.run(bench.context_only()),
        },
        3,
    )
    each = statistics.mean(took[model].wall for model in models) * 1e3
    context = took["context"].wall * 1e3
    rows = [against(f"{count} small models, a command each, 512x512: each", each, "context only", context)]
    (bench.folder / "models").mkdir()
    together = bench.render(models[0], "512x512", *models[1:], output="models/{model}.png")
    metric = f"{count} small models, one command, 512x512: each"
    if not bench.available(together):
        rows.append(Row(metric, "not available"))
    else:
        took = take_turns({"together": lambda: bench.run(together)}, 3)
        rows.append(against(metric, took["together"].wall * 1e3 / count, "a command each", each))
    return rows


STAGES_OF_DRAWING = ("planes", "surface", "lines", "edges", "composite", "read-back", "trace", "paint")


def large_mesh_rows(bench, repetitions):
    """A mesh of two million triangles: where the time goes, and the memory."""
    model, triangles = bench.model("cad", 2_000_000)
    small, few = bench.model("cad", 10_000)
    size = "1920x1080"
    took = take_turns(
        {
            "large": lambda: bench.run(bench.render(model, size, "--json")),
            "small": lambda: bench.run(bench.render(small, size, "--json")),
        },
        repetitions,
    )
    reports = [json.loads(sample.output)["milliseconds"] for sample in took["large"].samples]
    stages = {stage: statistics.median(report[stage] for report in reports) for stage in reports[0]}
    whole = took["large"].wall * 1e3
    text = f"cold command, {triangles:,} triangles, {size}"
    parts = {name: value for name, value in stages.items() if name not in STAGES_OF_DRAWING}
    if "prepare" not in parts:
        parts = {"load and prepare" if name == "load" else name: value for name, value in parts.items()}
    parts["draw"] = sum(stages[name] for name in STAGES_OF_DRAWING if name in stages)
    parts["everything else"] = whole - sum(parts.values())
    rows = [Row(text, ms(whole), details={"milliseconds": stages})]
    rows += [against(f"  {name}", value, "the whole", whole) for name, value in parts.items()]
    file_bytes = model.stat().st_size
    beyond = (took["large"].peak - file_bytes) / triangles
    more = (took["large"].peak - took["small"].peak - file_bytes + small.stat().st_size) / (triangles - few)
    peak = f"{beyond:.0f} bytes a triangle"
    rows.append(Row("  its peak memory beyond the file", peak, f"250 of {mb(took['large'].peak)}",
                    beyond / 250, "<= 1.0",
                    details={"peak": took["large"].peak, "file": file_bytes}).judge())  # fmt: skip
    rows.append(Row(f"  beyond a command for {few:,} triangles", f"{more:.0f} bytes a triangle", "250", more / 250))
    return rows
