"""Commands run and measured."""

import os
import statistics
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass

CORES = len(os.sched_getaffinity(0))


def fail(message):
    sys.exit(f"tools/bench: error: {message}")


def say(message):
    print(f"tools/bench: {message}", file=sys.stderr, flush=True)


@dataclass
class Sample:
    wall: float  # seconds
    cpu: float  # seconds, of all threads
    peak: int  # bytes of memory
    status: int
    output: str
    errors: str


def environment(shader_cache):
    """The caller's, less what would change a render."""
    kept = {name: value for name, value in os.environ.items() if not name.startswith(("MESA_", "INKEDGE_"))}
    return {**kept, "MESA_SHADER_CACHE_DIR": str(shader_cache)}


def run_process(arguments, shader_cache):
    with tempfile.TemporaryFile() as output, tempfile.TemporaryFile() as errors:
        begin = time.monotonic()
        process = subprocess.Popen(
            [str(argument) for argument in arguments], stdout=output, stderr=errors, env=environment(shader_cache)
        )
        _, status, usage = os.wait4(process.pid, 0)
        wall = time.monotonic() - begin
        process.returncode = os.waitstatus_to_exitcode(status)
        output.seek(0)
        errors.seek(0)
        return Sample(
            wall,
            usage.ru_utime + usage.ru_stime,
            usage.ru_maxrss * 1024,
            process.returncode,
            output.read().decode(),
            errors.read().decode(),
        )


def expect_success(sample, arguments):
    if sample.status != 0:
        command = " ".join(map(str, arguments))
        fail(f"{command}: expected success, found exit status {sample.status}: {sample.errors.strip()}")
    return sample


@dataclass
class Timing:
    """The medians of a command's runs."""

    wall: float
    cpu: float
    peak: float
    samples: list


def take_turns(commands, repetitions):
    """Runs the commands one after the other, again and again: what disturbs one then disturbs the others too.
    commands: name -> function that runs it once."""
    samples = {name: [] for name in commands}
    for _ in range(repetitions):
        for name, run in commands.items():
            samples[name].append(run())

    def median(runs, what):
        return statistics.median(getattr(run, what) for run in runs)

    return {
        name: Timing(median(runs, "wall"), median(runs, "cpu"), median(runs, "peak"), runs)
        for name, runs in samples.items()
    }


class Bench:
    """The programs, a folder for what they write, and the shader cache that is warm."""

    def __init__(self, programs, folder):
        self.programs = programs
        self.folder = folder
        self.warm = folder / "shaders"
        self.warm.mkdir()
        self.models = {}

    def model(self, shape, triangles):
        """A model's file and its number of triangles."""
        if (shape, triangles) not in self.models:
            file = self.folder / f"{shape}-{triangles}.glb"
            made = self.run([self.programs / "make_mesh", shape, triangles, file])
            self.models[shape, triangles] = file, int(made.output)
        return self.models[shape, triangles]

    def measure(self, arguments):
        """As run(), whatever the exit status."""
        return run_process(arguments, self.warm)

    def run(self, arguments, shader_cache=None):
        return expect_success(run_process(arguments, shader_cache or self.warm), arguments)

    def run_with_empty_cache(self, arguments):
        with tempfile.TemporaryDirectory(dir=self.folder) as fresh:
            return self.run(arguments, fresh)

    def render(self, model, size, *more, output="picture.png"):
        return [self.programs / "inkedge", "render", model, "-o", self.folder / output, "--size", size, "-q", *more]

    def context_only(self):
        return [self.programs / "context_only"]

    def available(self, arguments):
        """Whether the command knows these arguments."""
        sample = run_process(arguments, self.warm)
        if sample.status == 2:
            return False
        expect_success(sample, arguments)
        return True
