"""A cluster of Slurm on this machine alone: a controller, and two nodes that are one daemon each."""
import contextlib
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import time

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "scontrol", "squeue", "scancel")
NODES = ("near", "far")
SILENCE = 10  # seconds until a node that says nothing counts as lost

CONFIGURATION = """\
ClusterName=inkedge
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller}
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool-%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd-%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd-%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
MpiDefault=none
SwitchType=switch/none
ReturnToService=2
SlurmdTimeout={silence}
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
NodeName=near NodeHostname={host} NodeAddr=127.0.0.1 Port={near} CPUs=1
NodeName=far NodeHostname={host} NodeAddr=127.0.0.1 Port={far} CPUs=1
PartitionName=all Nodes=near,far Default=YES MaxTime=INFINITE State=UP
"""


def why_not():
    """Why there can be no cluster here; "": there can be one."""
    path = os.environ.get("PATH", "") + ":/usr/sbin:/sbin"
    missing = [program for program in PROGRAMS if not shutil.which(program, path=path)]
    if missing:
        return f"no {', '.join(missing)}; apt-get install slurmctld slurmd slurm-client munge"
    return "" if os.geteuid() == 0 else "slurmd wants root"


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for each in sockets:
        each.bind(("127.0.0.1", 0))
    ports = [each.getsockname()[1] for each in sockets]
    for each in sockets:
        each.close()
    return ports


def until(condition, seconds, what):
    end = time.monotonic() + seconds
    while not (found := condition()):
        assert time.monotonic() < end, f"expected {what} within {seconds} s, found none"
        time.sleep(0.02)
    return found


class Cluster:
    """A context manager; its daemons end with it."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.folder.mkdir()
        for each in (self.folder, self.folder.parent):
            each.chmod(0o711)  # munged wants its socket to be within everybody's reach
        (self.folder / "state").mkdir()
        self.daemons = {}
        self.environment = {name: value for name, value in os.environ.items() if not name.startswith("SLURM")}
        self.environment["SLURM_CONF"] = str(self.folder / "slurm.conf")
        self.environment["PATH"] += ":/usr/sbin:/sbin"

    def __enter__(self):
        controller, near, far = free_ports(3)
        (self.folder / "slurm.conf").write_text(CONFIGURATION.format(
            host=socket.gethostname().split(".")[0], folder=self.folder, silence=SILENCE, controller=controller,
            near=near, far=far))
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o400)
        at = {"socket": "munge.socket", "pid-file": "munged.pid", "log-file": "munged.log", "seed-file": "munged.seed"}
        try:
            self.start("munged", "--foreground", f"--key-file={key}",
                       *(f"--{name}={self.folder / file}" for name, file in at.items()))
            until((self.folder / "munge.socket").exists, 20, "a socket of munged")
            self.start("slurmctld", "-D")
            for node in NODES:
                self.start_node(node)
            until(lambda: self.states_of_nodes() == {"idle": 2}, 60, "two idle nodes")
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        self.tell("scancel", "--user=root", check=False)
        for daemon in reversed(list(self.daemons.values())):
            daemon.terminate()
        for daemon in self.daemons.values():
            try:
                daemon.wait(20)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()

    def start(self, name, *arguments):
        with open(self.folder / f"{name}.out", "ab") as out:
            self.daemons[(name, *arguments)] = subprocess.Popen([name, *arguments], env=self.environment, stdout=out,
                                                               stderr=out, stdin=subprocess.DEVNULL)

    def start_node(self, node):
        self.start("slurmd", "-D", "-N", node)

    def kill_node(self, node):
        """The daemon alone: the tasks that it has started go on."""
        daemon = self.daemons.pop(("slurmd", "-D", "-N", node))
        daemon.send_signal(signal.SIGKILL)
        daemon.wait()

    def tell(self, *command, check=True):
        done = subprocess.run(command, env=self.environment, capture_output=True, text=True, check=False, timeout=60)
        assert done.returncode == 0 or not check, f"{command}: {done.stderr}"
        return done.stdout

    @contextlib.contextmanager
    def asking(self, *command):
        """A command that may not come to its end."""
        process = subprocess.Popen(command, env=self.environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            yield
        finally:
            process.kill()
            process.wait()

    def states_of_nodes(self):
        states = {}
        for state in self.tell("sinfo", "--noheader", "--Node", "--format=%T", check=False).split():
            states[state] = states.get(state, 0) + 1
        return states

    def queue(self):
        """The tasks that are waiting or at work: their array index, state and id."""
        lines = self.tell("squeue", "--noheader", "--array", "--format=%K %T %A").splitlines()
        return {int(index): (state, job) for index, state, job in (line.split() for line in lines)}

    def hurry(self):
        """Lets tasks that were put back start now, and not in two minutes."""
        for state, job in self.queue().values():
            if state == "PENDING":
                self.tell("scontrol", "update", f"JobId={job}", "StartTime=now", check=False)


def tasks():
    """The batches at work: by array index lists of (process, node)."""
    found = {}
    for folder in pathlib.Path("/proc").iterdir():
        try:
            command = (folder / "cmdline").read_bytes().split(b"\0")
            if len(command) < 2 or command[1] != b"batch":
                continue
            environment = dict(entry.split("=", 1) for entry in
                               (folder / "environ").read_text(errors="replace").split("\0") if "=" in entry)
        except OSError:
            continue
        if "SLURM_ARRAY_TASK_ID" in environment:
            index = int(environment["SLURM_ARRAY_TASK_ID"])
            found.setdefault(index, []).append((int(folder.name), environment.get("SLURMD_NODENAME")))
    return found


def family(process):
    """A process and all that it has started."""
    children = []
    for thread in pathlib.Path(f"/proc/{process}/task").iterdir():
        children += map(int, (thread / "children").read_text().split())
    return [process, *(each for child in children for each in family(child))]
