# SPDX-License-Identifier: MIT
"""What a log of commits holds, read without Pliant, and jobs that keep one, as shards do."""

import json
import struct
import subprocess
import tempfile
import time
import zlib
from dataclasses import dataclass
from pathlib import Path

from ensembles import COMMAND

#: starts of a command until a signal meets it at work, however late the signal is
TRIES = 20

_jobs = tempfile.TemporaryDirectory(prefix="pliant-jobs-")


def words_of_job(task, job):
    """The command that does a job, which stands in a file."""
    text = json.dumps({"task": task, **{name: as_json(value) for name, value in job.items()}})
    path = Path(_jobs.name) / f"{zlib.crc32(text.encode())}.json"
    path.write_text(text)
    return [str(COMMAND), task, "--job", str(path), "--json"]


def as_json(value):
    return str(value) if isinstance(value, Path) else value


@dataclass
class Commit:
    """One of them; `step` is that of a run, or the number of a sample's last frame."""

    walker: int
    is_done: bool
    frames_before: int
    step: int


def commits_in(path):
    """All that are whole, as far as their length says."""
    try:
        data = path.read_bytes()
    except FileNotFoundError:
        return []
    found, at = [], 16
    while at + 16 <= len(data):
        (words,) = struct.unpack_from("<Q", data, at)
        if at + 16 + 8 * words > len(data):
            break
        walker, is_done, before, step = struct.unpack_from("<4q", data, at + 16)
        found.append(Commit(walker, bool(is_done), before, step))
        at += 16 + 8 * words
    return found


class CommitCount:
    """Counts the commits of a log that grows, of which it looks at the lengths alone."""

    def __init__(self, path):
        self._path, self._at, self._count = path, 16, 0

    def now(self):
        try:
            with open(self._path, "rb") as file:
                size = file.seek(0, 2)
                while self._at + 16 <= size:
                    file.seek(self._at)
                    end = self._at + 16 + 8 * struct.unpack("<Q", file.read(8))[0]
                    if end > size:
                        break
                    self._at, self._count = end, self._count + 1
        except FileNotFoundError:
            pass
        return self._count


def wait_for_commits(child, path, count):
    """Until there are so many more; not if the process ends before."""
    log = CommitCount(path)
    goal = log.now() + count
    while log.now() < goal and child.poll() is None:
        time.sleep(0.0005)


def stopped(words, folder, count, how):
    """Stops a command as soon as its o.log has so many commits more; its exit code.

    Anew, if all was done before it was met; 0 if it cannot be stopped.
    """
    for _ in range(TRIES):
        (folder / "o.h5md").unlink(missing_ok=True)
        with subprocess.Popen(words, cwd=folder, stdout=subprocess.DEVNULL) as child:
            wait_for_commits(child, folder / "o.log", count)
            child.send_signal(how)
            code = child.wait()
        if code != 0:
            break
    return code


def steps_in(path):
    """Steps of all walkers that need not be done again."""
    return sum({one.walker: one.step for one in commits_in(path)}.values())
