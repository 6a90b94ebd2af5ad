"""Slurm for real, on this host and for one test: munged, slurmctld and a slurmd for each node, with all their files in one folder.

Runs as root and as anybody, without systemd and without cgroups. The packages: scripts/install-packages.sh --all.
"""
import os
import pwd
import shutil
import socket
import subprocess
import time
from pathlib import Path

LONGEST_S = 60
PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "sinfo", "squeue")
NODES = ("node-a", "node-b")
PATH = os.environ["PATH"] + ":/usr/sbin:/sbin"
CONFIG = """ClusterName=nullscope
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[0]}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool-%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd-%n.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=1
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
ReturnToService=2
{nodes}
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def free_ports(count):
    """Held together, so that they differ."""
    sockets = [socket.socket() for _ in range(count)]
    for each in sockets:
        each.bind(("127.0.0.1", 0))
    ports = [each.getsockname()[1] for each in sockets]
    for each in sockets:
        each.close()
    return ports


class Cluster:
    """With `with`. environment: what Slurm's commands need."""

    def __init__(self, folder):
        missing = [program for program in PROGRAMS if not shutil.which(program, path=PATH)]
        if missing:
            raise AssertionError(f"Slurm is not here ({', '.join(missing)}): scripts/install-packages.sh --all installs it")
        self.folder = Path(folder)
        self.processes = []
        self.environment = {**os.environ, "PATH": PATH, "SLURM_CONF": str(self.folder / "slurm.conf")}

    def __enter__(self):
        try:
            self.start()
        except BaseException:
            self.stop()
            raise
        return self

    def __exit__(self, *_):
        self.stop()

    def begin(self, *words):
        log = open(self.folder / f"{len(self.processes)}-{Path(words[0]).name}.log", "wb")
        self.processes.append(subprocess.Popen(words, cwd=self.folder, env=self.environment, stdin=subprocess.DEVNULL, stdout=log,
                                               stderr=log, start_new_session=True))
        log.close()

    def start(self):
        self.folder.chmod(0o755)
        ports = free_ports(1 + len(NODES))
        host = socket.gethostname().split(".")[0]
        nodes = "\n".join(f"NodeName={name} NodeHostname={host} NodeAddr=127.0.0.1 Port={port} CPUs=1 State=UNKNOWN"
                          for name, port in zip(NODES, ports[1:]))
        (self.folder / "slurm.conf").write_text(CONFIG.format(host=host, ports=ports, folder=self.folder, nodes=nodes,
                                                              user=pwd.getpwuid(os.getuid()).pw_name))
        (self.folder / "state").mkdir()
        for name in NODES:
            (self.folder / f"spool-{name}").mkdir()
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o600)
        self.begin("munged", "--foreground", "--force", f"--socket={self.folder}/munge.socket", f"--key-file={key}",
                   f"--pid-file={self.folder}/munged.pid", f"--seed-file={self.folder}/munge.seed", f"--log-file={self.folder}/munged.log")
        self.wait_for("munged", lambda: (self.folder / "munge.socket").exists())
        self.begin("slurmctld", "-D", "-i")
        for name in NODES:
            self.begin("slurmd", "-D", "-N", name)
        self.wait_for("the nodes", lambda: self.ask("sinfo", "-h", "-N", "-o", "%T").split() == ["idle"] * len(NODES))

    def ask(self, *words):
        return subprocess.run(words, env=self.environment, cwd=self.folder, capture_output=True, text=True, timeout=LONGEST_S).stdout

    def wait_for(self, what, ready):
        deadline = time.monotonic() + LONGEST_S
        while not ready():
            ended = [process.args[0] for process in self.processes if process.poll() is not None]
            if ended or time.monotonic() > deadline:
                logs = "\n".join(f"--- {log.name}\n{log.read_text(errors='replace')[-2000:]}" for log in sorted(self.folder.glob("*.log")))
                raise AssertionError(f"Slurm: {what} not ready; ended: {ended}\n{logs}")
            time.sleep(0.05)

    def stop(self):
        for process in reversed(self.processes):
            process.terminate()
        for process in reversed(self.processes):
            try:
                process.wait(timeout=10)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
