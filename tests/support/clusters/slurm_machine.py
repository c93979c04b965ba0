# SPDX-License-Identifier: MIT
"""Slurm on this machine: daemons with a folder, a key and ports of their own, while needed.

Needs root, and slurm-wlm and munge of Debian. Nothing of a Slurm that is installed is changed.
"""

import contextlib
import ctypes
import os
import shutil
import signal
import socket
import subprocess
import time
from pathlib import Path

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "scancel", "scontrol", "squeue")

SETTINGS = """\
ClusterName=test
SlurmctldHost=localhost
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.sock,cred_expire=5
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
MpiDefault=none
ReturnToService=2
KillWait=5
SchedulerParameters=sched_interval=2,batch_sched_delay=0
NodeName=localhost CPUs=2 RealMemory=1500 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def what_is_missing():
    """Why there can be no Slurm here; "" if there can."""
    path = os.environ["PATH"] + ":/usr/sbin"
    missing = [name for name in PROGRAMS if shutil.which(name, path=path) is None]
    if missing:
        return f"{', '.join(missing)} of Debian's slurm-wlm and munge: not installed"
    return "" if os.geteuid() == 0 else "its daemons need root"


class Slurm:
    """Its commands, while its daemons run."""

    def __init__(self, folder):
        self.folder = folder
        self.environment = {**os.environ, "SLURM_CONF": str(folder / "slurm.conf")}

    def call(self, *words):
        """What a command of Slurm prints."""
        ended = subprocess.run(
            [*map(str, words)], env=self.environment, capture_output=True, text=True, timeout=900
        )
        assert ended.returncode == 0, f"{words}: {ended.stderr}"
        return ended.stdout

    def submit(self, script, *words):
        """The number of the job."""
        return self.call("sbatch", "--parsable", *words, script).strip()

    def jobs(self):
        """Number and state of each job, or part of an array, that waits or runs."""
        lines = self.call("squeue", "--noheader", "--array", "--format=%i %T").splitlines()
        return dict(line.split() for line in lines)

    def wait_until_empty(self, seconds=600):
        """Until no job waits or runs."""
        end = time.monotonic() + seconds
        while self.jobs():
            assert time.monotonic() < end, self.call("scontrol", "show", "jobs")
            time.sleep(0.2)


@contextlib.contextmanager
def slurm_in(folder):
    """Slurm with all that it writes in `folder`. Its jobs and daemons end with the context."""
    folder = Path(folder)
    for name in ("state", "spool"):
        (folder / name).mkdir()
    (folder / "munge.key").write_bytes(os.urandom(1024))
    (folder / "munge.key").chmod(0o600)
    text = SETTINGS.format(folder=folder, ports=_free_ports(2))
    (folder / "slurm.conf").write_text(text)
    slurm = Slurm(folder)
    with contextlib.ExitStack() as daemons:
        for words in _daemons(folder):
            daemons.enter_context(_running(words, slurm.environment))
        try:
            _wait_for_node(slurm)
            yield slurm
        finally:
            _end_jobs(slurm)


def _daemons(folder):
    munge = ["munged", "--foreground", "--force", f"--socket={folder}/munge.sock"]
    for name in ("key-file", "pid-file", "log-file", "seed-file"):
        munge.append(f"--{name}={folder}/munge.{name.split('-')[0]}")
    settings = ["-D", "-f", str(folder / "slurm.conf")]
    return [munge, ["slurmctld", *settings], ["slurmd", *settings, "-N", "localhost"]]


@contextlib.contextmanager
def _running(words, environment):
    program = shutil.which(words[0], path=os.environ["PATH"] + ":/usr/sbin")
    pipes = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    with subprocess.Popen(
        [program, *words[1:]], env=environment, preexec_fn=_die_with_parent, **pipes
    ) as daemon:
        if words[0] == "munged":
            _wait_for(Path(words[3].partition("=")[2]).exists, daemon)
        try:
            yield
        finally:
            daemon.terminate()
            try:
                daemon.wait(20)
            except subprocess.TimeoutExpired:
                daemon.kill()


def _wait_for(is_there, daemon):
    end = time.monotonic() + 900
    while not is_there():
        assert daemon.poll() is None and time.monotonic() < end, daemon.args
        time.sleep(0.05)


def _die_with_parent():
    ctypes.CDLL(None).prctl(1, signal.SIGKILL)  # PR_SET_PDEATHSIG


def _wait_for_node(slurm):
    end = time.monotonic() + 900
    while True:
        with contextlib.suppress(AssertionError):
            if slurm.call("sinfo", "--noheader", "--format=%t").strip() == "idle":
                return
        log = slurm.folder / "slurmctld.log"
        assert time.monotonic() < end, log.read_text()[-2000:] if log.exists() else "no log"
        time.sleep(0.2)


def _end_jobs(slurm):
    with contextlib.suppress(AssertionError, subprocess.TimeoutExpired):
        slurm.call("scancel", "--user=root")
        slurm.wait_until_empty(60)


def _free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    try:
        for one in sockets:
            one.bind(("", 0))
        return [one.getsockname()[1] for one in sockets]
    finally:
        for one in sockets:
            one.close()
