#!/usr/bin/env python3
"""An array of Slurm draws a batch while its tasks and nodes are killed: cluster_test.py SOURCE COMMAND.

Nothing may be lost, nothing doubled, and the bytes are those of one machine's run. The cluster runs on this machine.
Exit status 77: it cannot be made here.
"""
import hashlib
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

from cluster import SILENCE, Cluster, family, tasks, until, why_not

TASKS = 8
ITEMS = 48
PATIENCE = 300  # seconds until something counts as hanging
FLAGS = ["--size", "200x200", "--views", "turntable:3", "--maps", "depth,ids", "-q"]


def write_list(source, folder):
    """Items of whatever is in assets, and one that cannot be drawn."""
    assets = sorted((source / "assets").glob("*.glb"))
    small = [asset for asset in assets if asset.stat().st_size < 400_000]
    (folder / "damaged.stl").write_text("solid x")
    lines = [json.dumps({"model": str(small[i % len(small)]), "id": f"{i:03}"}) for i in range(ITEMS)]
    lines.append(json.dumps({"model": str(folder / "damaged.stl"), "id": "damaged"}))
    listed = folder / "list.jsonl"
    listed.write_text("\n".join(lines) + "\n")
    return listed


def results_of(output):
    """The results by id, without what differs from run to run; each id once."""
    found = {}
    for file in sorted(output.glob("results*.jsonl")):
        for line in file.read_text().splitlines():
            result = json.loads(line)
            del result["seconds"]
            assert result["id"] not in found, f"{result['id']} twice"
            found[result["id"]] = result
    return found


def files_of(output):
    """A hash of each file by its path, but for the results."""
    return {str(file.relative_to(output)): hashlib.sha256(file.read_bytes()).hexdigest()
            for file in output.rglob("*") if file.is_file() and not file.name.startswith("results")}


class Array:
    """The array at work, and what is done to it."""

    def __init__(self, cluster, output):
        self.cluster, self.output = cluster, output

    def lines(self, task):
        file = self.output / f"results.{task}-of-{TASKS}.jsonl"
        return len(file.read_text().splitlines()) if file.exists() else 0

    def begun(self, others):
        """A task that has drawn something and is still at work: its index, process and node."""
        def look():
            for task, running in tasks().items():
                if task not in others and self.lines(task) > 0 and len(running) == 1:
                    return (task, *running[0])
            return None
        return until(look, PATIENCE, "a task that is at work")

    def requeued(self, task):
        until(lambda: self.cluster.queue().get(task, ("", ""))[0] == "PENDING", PATIENCE, f"task {task} in the queue")

    def kill_task(self):
        """kill -9 of a batch and its workers; the job has failed, and is put back by hand."""
        task, process, _ = self.begun([])
        job = self.cluster.queue()[task][1]
        for each in family(process):
            os.kill(each, signal.SIGKILL)
        until(lambda: task not in self.cluster.queue(), PATIENCE, f"task {task} ended")
        self.cluster.tell("scontrol", "requeue", job)
        print(f"killed task {task} after {self.lines(task)} items")
        return task

    def end_task(self, others):
        """What Slurm sends a minute before the limit of time: the task puts itself back into the queue."""
        task, _, _ = self.begun(others)
        with self.cluster.asking("scancel", "--batch", "--signal=USR1", self.cluster.queue()[task][1]):
            self.requeued(task)  # scancel asks again and again while it is
        print(f"ended task {task} after {self.lines(task)} items")
        return task

    def silence_node(self, others):
        """kill -9 of a node's daemon: its task goes on, stopped for a while, beside the copy that takes its place."""
        task, process, node = self.begun(others)
        old = family(process)
        for each in old:
            os.kill(each, signal.SIGSTOP)
        self.cluster.kill_node(node)

        def copy():
            self.cluster.hurry()
            return [each for each, _ in tasks().get(task, []) if each != process]
        until(copy, PATIENCE + SILENCE, f"a copy of task {task}")
        for each in old:
            os.kill(each, signal.SIGCONT)
        print(f"silenced {node} with task {task} after {self.lines(task)} items; a copy began beside it")
        until(lambda: not pathlib.Path(f"/proc/{process}").exists(), PATIENCE, "the old copy's end")
        self.cluster.start_node(node)

    def finish(self):
        def over():
            self.cluster.hurry()
            return not self.cluster.queue() and not tasks()
        until(over, PATIENCE, "the end of all tasks")


def run(source, command, folder):
    listed = write_list(source, folder)
    batch = [command, "batch", listed, "-o"]
    alone, output = folder / "alone", folder / "tasks"
    one = subprocess.run([*batch, alone, *FLAGS], capture_output=True, text=True, check=False)
    assert one.returncode == 1, one.stderr  # of the damaged one

    with Cluster(folder / "cluster") as cluster:
        cluster.environment["INKEDGE"] = str(command)
        cluster.tell("sbatch", f"--array=0-{TASKS - 1}", "--cpus-per-task=1", "--mem-per-cpu=0",
                     f"--output={folder}/task-%a.log", str(source / "tools/slurm/render.sbatch"), str(listed), "-o",
                     str(output), *FLAGS)
        array = Array(cluster, output)
        killed = array.kill_task()
        ended = array.end_task([killed])
        array.silence_node([killed, ended])
        array.finish()

    expected = results_of(alone)
    assert len(expected) == ITEMS + 1
    assert results_of(output) == expected, "each item once, with the same result"
    assert len(list(output.glob("results.?-of-8.jsonl"))) == TASKS
    assert files_of(output) == files_of(alone), "the same files and bytes"
    last = subprocess.run([*batch, output, *FLAGS, "--json"], capture_output=True, text=True, check=False)
    assert json.loads(last.stdout)["before"] == {**json.loads(last.stdout)["before"], "drawn": ITEMS, "refused": 1}
    assert [file.name for file in output.glob("results*")] == ["results.jsonl"] and results_of(output) == expected
    print(f"{ITEMS + 1} items by {TASKS} tasks: nothing lost, nothing doubled, the bytes of one machine's run")


def main(source, command):
    if missing := why_not():
        print(f"[  SKIPPED ] slurm_test: {missing}; there can be no cluster here", flush=True)
        return 77
    start = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="inkedge-slurm-") as folder:
        try:
            run(pathlib.Path(source).resolve(), pathlib.Path(command).resolve(), pathlib.Path(folder))
        except BaseException:
            for log in [*pathlib.Path(folder).glob("task-*.log"), *pathlib.Path(folder).glob("cluster/*.out")]:
                print(f"{log.name}: {log.read_text()[-500:]}")
            raise
    print(f"{time.monotonic() - start:.0f} s")
    return 0


if __name__ == "__main__":
    sys.stdout.reconfigure(line_buffering=True)
    sys.exit(main(*sys.argv[1:]))
