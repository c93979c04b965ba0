# SPDX-License-Identifier: MIT
"""Python commands in forks of one process that has imported what they need, which takes long.

What a fork prints, how it ends, its folder and its environment are those of a process of its own;
figures of its reports are not rendered.
"""

import atexit
import functools
import gc
import importlib
import io
import json
import os
import re
import subprocess
import sys
import tempfile
import threading
import traceback
from pathlib import Path

SCRIPTS = Path(sys.executable).parent

#: what the commands import when they begin to work
HEAVY = tuple(
    "MDAnalysis MDAnalysis.analysis.rms dask_jobqueue distributed h5py matplotlib.figure "
    "matplotlib.backends.backend_agg openmm.app rich.live scipy.spatial scipy.stats "
    "rdkit.Chem.AllChem pliant.jobs.conformers.workers pliant.report.suite "
    "pliant.report.check.suite pliant.report.compare.suite "
    "pliant.shards.cluster pliant.shards.flexibility".split()
)

#: a picture of one grey dot
DOT = bytes.fromhex(
    "89504e470d0a1a0a0000000d4948445200000001000000010800000000"
    "3a7e9b550000000a49444154789c636800000082008177cd72b60000000049454e44ae426082"
)

#: what may differ from the environment of the tests, since no import looks at it
LATE_VARIABLES = {"PATH", "COLUMNS", "HOME", "NO_COLOR", "SLURM_ARRAY_TASK_ID"}


@functools.cache
def commands():
    """Module and function of each command that is written in Python, by its name."""
    found = {}
    for script in SCRIPTS.glob("pliant-*"):
        place = re.search(r"^from (\S+) import (\w+)$", script.read_text(), re.MULTILINE)
        if place:
            found[script.name.removeprefix("pliant-")] = place.groups()
    return found


def called(words):
    """Name of the program that `pliant WORDS` is, and the words for it."""
    if words[:1] == ["lab"] and len(words) > 1:
        return f"lab-{words[1]}", words[2:]
    return words[0], words[1:]


def save_dot(figure, place, dpi):
    """In the place of save_png: rendering a figure takes longer than all else of a report."""
    Path(place).write_bytes(DOT)


def save_figures_by(save):
    """All reports of this process save the figures that they drew so; how they did before."""
    module = importlib.import_module("pliant.report.figures.draw_in_parallel")
    before, module.save_png = module.save_png, save
    return before


class Forks:
    """A process that has imported modules, and forks for each call."""

    def __init__(self, modules):
        words = [sys.executable, __file__, *modules]
        pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE}
        self.process = subprocess.Popen(words, text=True, **pipes)
        self.lock = threading.Lock()
        atexit.register(self.end)

    def end(self):
        self.process.stdin.close()
        self.process.wait(900)

    def run(self, job, timeout):
        """Code, standard output and error of a job: {"code" or "command": ...}."""
        with tempfile.TemporaryFile("w+b") as out, tempfile.TemporaryFile("w+b") as err:
            own = {"out": f"/proc/{os.getpid()}/fd/{out.fileno()}"}
            own["err"] = f"/proc/{os.getpid()}/fd/{err.fileno()}"
            with self.lock:
                print(json.dumps({**job, **own}), file=self.process.stdin, flush=True)
                clock = threading.Timer(timeout, self.process.kill)
                clock.start()
                answer = self.process.stdout.readline()
                clock.cancel()
            if not answer:
                raise subprocess.TimeoutExpired(str(job), timeout)
            texts = []
            for file in (out, err):
                file.seek(0)
                texts.append(io.TextIOWrapper(file).read())
        return int(answer), *texts


@functools.cache
def forks(*modules):
    """Of these modules, once a process of the tests."""
    return Forks(modules)


def surroundings(cwd, env):
    return {"cwd": str(cwd or os.getcwd()), "env": dict(os.environ if env is None else env)}


def ended_code(text, *modules, cwd=None, env=None, timeout=900):
    """What python -c would give, where some modules are imported already."""
    job = {"code": text, **surroundings(cwd, env)}
    return subprocess.CompletedProcess(["-c", text], *forks(*modules).run(job, timeout))


def is_forkable(words, env=None, cwd=None, timeout=None, **others):
    """Whether a fork does what subprocess.run(words, ...) does: a command in Python, no more."""
    env = os.environ if env is None else env
    changed = {name for name in {*env, *os.environ} if env.get(name) != os.environ.get(name)}
    return (
        bool(words) and called(words)[0] in commands() and changed <= LATE_VARIABLES and not others
    )


def ended_command(words, cwd=None, env=None, timeout=900):
    """What the command `pliant WORDS` would give, which is_forkable()."""
    name, rest = called([*words])
    job = {"command": commands()[name], "words": [name, *rest], **surroundings(cwd, env)}
    return subprocess.CompletedProcess(["pliant", *words], *forks(*HEAVY).run(job, timeout))


# --- in the process that forks -------------------------------------------------------------------


def take_place(job):
    """Folder, environment, input and output of the job."""
    os.chdir(job["cwd"])
    os.environ.clear()
    os.environ.update(job["env"])
    for descriptor, path, how in (
        (0, os.devnull, os.O_RDONLY),
        (1, job["out"], os.O_WRONLY),
        (2, job["err"], os.O_WRONLY),
    ):
        opened = os.open(path, how)
        os.dup2(opened, descriptor)
        os.close(opened)
    sys.stdin, sys.stdout, sys.stderr = (open(k, "rw"[k > 0], closefd=False) for k in range(3))  # noqa: SIM115


def do(job):
    """The job, as the main module of a process does it."""
    main = sys.modules["__main__"]
    if "code" in job:
        del main.__file__
        sys.argv, sys.path[0] = ["-c"], ""
        exec(compile(job["code"], "<string>", "exec"), {"__name__": "__main__"})
        return
    script = SCRIPTS / f"pliant-{job['words'][0]}"
    main.__file__ = str(script)  # which processes that are spawned import
    sys.argv, sys.path[0] = [str(script), *job["words"][1:]], str(SCRIPTS)
    save_figures_by(save_dot)
    module, function = job["command"]
    sys.exit(getattr(importlib.import_module(module), function)())


def code_of(end):
    """The exit code of SystemExit."""
    if end.code is None or isinstance(end.code, int):
        return end.code or 0
    print(end.code, file=sys.stderr)
    return 1


def run_job(job):
    """Does the job and ends this process."""
    code = 1
    try:
        take_place(job)
        do(job)
        code = 0
    except SystemExit as end:
        code = code_of(end)
    except BaseException:
        traceback.print_exc()
    finally:
        threading._shutdown()
        atexit._run_exitfuncs()
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(code & 0xFF)


def serve(modules):
    """Forks for each line of the input; writes how the fork ended."""
    for name in modules:
        importlib.import_module(name)
    gc.collect()
    gc.freeze()
    for line in sys.stdin:
        child = os.fork()
        if child == 0:
            run_job(json.loads(line))
        _, status = os.waitpid(child, 0)
        print(os.waitstatus_to_exitcode(status), flush=True)


if __name__ == "__main__":
    serve(sys.argv[1:])
