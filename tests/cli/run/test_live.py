# SPDX-License-Identifier: MIT
"""pliant run --imd and pliant watch: options, and what they say."""

import json
import signal
import subprocess
import sys
from contextlib import ExitStack

import h5py
import pytest
from imd_partners import served_run
from pliant.play.imd import Client
from real_files import DIPEPTIDE

import pliant as library


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (("--imd", "70000"), 'pliant: error: --imd: expected a port from 0 to 65535, or HOST:PORT, '
         'found "70000"'),
        (("--imd", "localhost"), 'pliant: error: --imd: expected a port from 0 to 65535, or '
         'HOST:PORT, found "localhost"'),
        (("--imd", "--imd-version", "4"), "pliant run: error: --imd-version: expected a whole "
         'number from 2 to 3, found "4"'),
        (("--imd-wait",), "pliant: error: --imd-wait: goes with --imd"),
        (("--imd", "--walkers", "2"), "pliant: error: --imd: follows one walker, not several"),
    ],
)  # fmt: skip  # a table: a row a line
def test_options_that_make_no_sense(pliant, tmp_path, options, said):
    ended = pliant("run", DIPEPTIDE, *options)
    assert ended.code == 2
    assert ended.err.splitlines()[0] == said
    assert list(tmp_path.iterdir()) == []


def test_a_port_that_is_taken(pliant, command, tmp_path):
    (tmp_path / "other").mkdir()
    with served_run(command, tmp_path / "other", "--imd-wait") as run:
        ended = pliant("run", DIPEPTIDE, "--imd", run.port)
    assert ended.code == 1
    assert ended.err.splitlines()[-1] == (
        f"pliant: error: IMD on 127.0.0.1:{run.port}: cannot listen: Address already in use"
    )
    assert [path.name for path in tmp_path.iterdir()] == ["other"]


def test_a_run_that_is_reached_from_elsewhere_says_so(pliant):
    ended = pliant("run", DIPEPTIDE, "--steps", "2", "--imd", "0.0.0.0:0")
    assert ended.code == 0
    assert "warning: --imd 0.0.0.0:0: IMD has no passwords: whoever reaches port " in ended.err


def test_a_run_whose_pushes_no_file_holds_says_so(pliant, tmp_path):
    ended = pliant("run", DIPEPTIDE, "--steps", "2", "--imd", "0", "--perturb", "displacement")
    assert ended.code == 0
    assert (
        "warning: clients can pull, but a force file cannot describe this run: it cannot be "
        "repeated" in ended.err
    )


def test_what_goes_on_is_not_live(pliant, tmp_path):
    assert pliant("run", DIPEPTIDE, "-o", "a.h5md", "--steps", "2").code == 0
    ended = pliant("run", "--continue", "a.h5md", "--imd")
    assert (ended.code, ended.err) == (
        2,
        "pliant: error: --imd: does not go with --continue, which adds to a.h5md\n",
    )


def test_nobody_came(pliant):
    ended = pliant("run", DIPEPTIDE, "--steps", "2", "--imd", "0", "--json")
    facts = json.loads(ended.out)
    assert {name: value for name, value in facts.items() if name.startswith("imd")} == {
        "imd_clients": 0,
        "imd_clients_refused": 0,
        "imd_frames_sent": 0,
        "imd_frames_dropped": 0,
        "imd_forces_taken": 0,
        "imd_seconds_waited": 0.0,
    }


def test_watch_records_what_it_sees(pliant, command, tmp_path):
    with served_run(command, tmp_path, "--steps", "1000000", "--imd-wait") as run:
        words = ["watch", f"localhost:{run.port}", "--frames", "40", "--json"]
        record = ["-o", "seen.h5md", "--topology", "run.pdb"]
        ended = pliant(*words, *record)
        run.process.send_signal(signal.SIGINT)
        assert run.end()[0] == 130
    assert ended.code == 0, ended.err
    seen = json.loads(ended.out)
    assert (seen["frames"], seen["first_step"], seen["last_step"]) == (40, 0, 39)
    assert seen["frames_dropped"] == 0
    assert 0.0 < seen["worst_residual"] <= 1e-6
    assert seen["mean_sweeps"] == pytest.approx(39 / 40)
    reader = library.H5mdReader(tmp_path / "seen.h5md")
    assert len(reader) == 40
    with h5py.File(tmp_path / "run.h5md") as ours, h5py.File(tmp_path / "seen.h5md") as theirs:
        path = "particles/trajectory/position/value"
        assert (ours[path][:40].astype("f4") == theirs[path][:].astype("f4")).all()


ENDLESS = ("--steps", "1000000000", "--every", "1000000")


@pytest.mark.long
def test_who_reads_nothing_keeps_nobody_else_from_watching(pliant, command, tmp_path):
    with served_run(command, tmp_path, *ENDLESS) as run, Client(port=run.port):
        ended = pliant("watch", f":{run.port}", "--frames", "5", "--json")
    assert (ended.code, ended.err) == (0, "")
    assert json.loads(ended.out)["frames"] == 5


def test_one_client_too_many_is_reported(pliant, command, tmp_path):
    with served_run(command, tmp_path, *ENDLESS) as run, ExitStack() as clients:
        for _ in range(16):
            client = clients.enter_context(Client(port=run.port))
            client.read()
            client.set_rate(1_000_000_000)
        ended = pliant("watch", f":{run.port}")
        said = run.wait_for(r"^warning: IMD client (.*)$", run.process.stderr)
    assert (ended.code, ended.out, ended.err) == (
        1,
        "",
        "pliant watch: error: IMD: the server closed the connection without a word: it may have "
        "as many clients as it serves\n",
    )
    assert said.endswith(" turned away: 16 are connected, and no more are served")


def test_watch_says_what_is_wrong(pliant, tmp_path):
    ended = pliant("watch", "nowhere")
    assert ended.code == 2
    assert "expected HOST:PORT, found 'nowhere'" in ended.err
    ended = pliant("watch", ":8888", "-o", "a.h5md")
    assert (ended.code, ended.err) == (
        2,
        "pliant watch: error: --output and --topology go together\n",
    )
    (tmp_path / "a.h5md").touch()
    ended = pliant("watch", ":8888", "-o", "a.h5md", "--topology", DIPEPTIDE)
    assert (ended.code, ended.err) == (
        2,
        "pliant watch: error: --output a.h5md: exists; --overwrite replaces it\n",
    )


def test_watch_notices_other_atoms(pliant, command, tmp_path):
    with served_run(command, tmp_path, "--steps", "1000", "--imd-wait") as run:
        ended = pliant("watch", f"localhost:{run.port}", "-o", "a.h5md", "--topology", DIPEPTIDE)
    assert ended.code == 1
    assert ended.err == "pliant watch: error: --topology: has 22 atoms, the run 327\n"
    assert not (tmp_path / "a.h5md").exists()


def test_watch_needs_neither_extra_nor_analysis():
    code = (
        "import sys, pliant.play.imd.watch as _\n"
        "assert not {'MDAnalysis', 'imdclient'} & set(sys.modules)"
    )
    subprocess.run([sys.executable, "-c", code], check=True)
