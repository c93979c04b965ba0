# SPDX-License-Identifier: MIT
"""Runs followed and steered over IMD, by programs that are not ours."""

import re
import shutil
import socket
import struct
import subprocess
import sys
import threading
import warnings
from pathlib import Path

import h5py
import numpy as np
import pytest
from imd_partners import (
    KILL,
    MOLECULES,
    PAUSE,
    VmdLike,
    job,
    sample_positions,
    served_run,
    served_sample,
)
from pliant.play.imd import Client, watch

import pliant

COMMAND = Path(sys.executable).parent / "pliant"


def positions_of(path):
    """Steps, and positions (F, N, 3)."""
    with h5py.File(path) as file:
        group = file["particles/trajectory/position"]
        return group["step"][:], group["value"][:]


@pytest.fixture
def universe():
    """MDAnalysis' Universe of a server."""
    pytest.importorskip("imdclient")
    mda = pytest.importorskip("MDAnalysis")

    def follow(topology, port):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return mda.Universe(str(topology), f"imd://localhost:{port}")

    return follow


# --- MDAnalysis and imdclient ---------------------------------------------------------------------


def test_mdanalysis_sees_each_frame_of_a_run(universe, tmp_path):
    with served_run(COMMAND, tmp_path, "--steps", "60", "--imd-wait") as run:
        seen = {}
        for ts in universe(tmp_path / "run.pdb", run.port).trajectory:
            seen[ts.data["step"]] = ts.positions.copy()
            assert ts.time == pytest.approx(0.01 * ts.data["step"])
            assert ts.data["dt"] == 0.01
            assert 0.0 <= ts.data["total_energy"] <= 1e-6
        code, out, _ = run.end()
    assert code == 0
    assert "IMD             1 clients, 61 frames sent, 0 dropped" in out
    steps, positions = positions_of(tmp_path / "run.h5md")
    assert list(seen) == list(steps) == list(range(61))
    for step, expected in zip(steps, positions, strict=True):
        assert np.array_equal(seen[step], expected.astype("f4"))


@pytest.mark.parametrize("order", ["native", "swapped"])
def test_mdanalysis_reads_both_byte_orders(universe, tmp_path, order):
    atoms = 22
    with served_sample(atoms, 40, 3, order) as run:
        trajectory = universe(MOLECULES / "alanine_dipeptide.pdb", run.port).trajectory
        count = 0
        for ts in trajectory:
            assert np.array_equal(ts.positions, sample_positions(atoms, count))
            assert ts.data["step"] == count
            assert ts.data["bonds_energy"] == 3.0
            assert ts.dimensions is None
            count += 1
        code, out, _ = run.end()
    assert (code, count) == (0, 40)
    assert out == "40 sent, 0 dropped, 0 refused\n"


@pytest.mark.parametrize("order", ["native", "swapped"])
def test_imdclient_reads_version_2(order):
    imdclient = pytest.importorskip("imdclient")
    with served_sample(9, 30, 2, order) as run:
        client = imdclient.IMDClient("127.0.0.1", run.port, 9)
        for number in range(30):
            frame = client.get_imdframe()
            assert np.array_equal(frame.positions, sample_positions(9, number))
            assert frame.energies["step"] == number
        with pytest.raises(EOFError):
            client.get_imdframe()
        client.stop()
        assert run.end()[:2] == (0, "30 sent, 0 dropped, 0 refused\n")


def test_a_slow_analysis_that_pauses_loses_nothing(universe):
    with served_sample(2000, 600) as run:
        imdclient = pytest.importorskip("imdclient")
        # Its buffer is for two frames: it asks for pauses all the time.
        client = imdclient.IMDClient("127.0.0.1", run.port, 2000, buffer_size=2 * 24_100)
        for number in range(600):
            assert client.get_imdframe().positions[0, 1] == number
        client.stop()
        assert run.end()[1] == "600 sent, 0 dropped, 0 refused\n"


def test_another_topology_is_noticed(universe):
    with (
        served_sample(23, 40) as run,
        pytest.raises((EOFError, RuntimeError), match="Expected n_atoms value 22, got 23"),
    ):
        next(iter(universe(MOLECULES / "alanine_dipeptide.pdb", run.port).trajectory))


# --- VMD ------------------------------------------------------------------------------------------


def test_vmd_drags_atoms_and_the_session_is_repeated_bit_by_bit(tmp_path):
    timing = ("--steps", "100000", "--damping", "0.1", "--force", "30", "--seed", "12345")
    options = ("--imd-version", "2", "--imd-wait")
    options += ("--technique", "bfs_cycle", "--mass-weighted")
    with served_run(COMMAND, tmp_path, *timing, *options) as run:
        vmd = VmdLike(run.port)
        (step, *_), first = vmd.read()
        assert step == 0
        vmd.drag([3, 100], [[0, 0, 1e9], [40, 0, 0]])
        for _ in range(100):
            energies, _ = vmd.read()
        assert energies[8] == 2.0  # forces that act
        vmd.drag([7], [[0.5, 0, 0]])
        vmd.send(PAUSE)
        vmd.send(PAUSE)  # goes on
        for _ in range(100):
            energies, last = vmd.read()
        vmd.drag([], np.empty((0, 3)))
        while energies[8] > 0.0:  # frames that were under way
            energies, _ = vmd.read()
        for _ in range(10):
            vmd.read()
        vmd.send(KILL)
        with pytest.raises(EOFError):
            while True:
                energies, _ = vmd.read()
                assert energies[2] <= 1e-6  # largest residual
        vmd.socket.close()
        code, out, _ = run.end()
    assert code == 130
    assert "3 packets of forces" in out
    assert last[3, 2] > first[3, 2] + 5.0
    forces = tmp_path / "run.forces"
    text = forces.read_text()
    assert text.startswith("pliant-forces 3\n")
    assert len(text) < 1000  # of some hundred steps: what the hand asked for, with counts
    # Steps that nobody pulls in are counted, and made again from the seed.
    alone = [int(count) for count in re.findall(r"^wander (\d+)$", text, re.MULTILINE)]
    assert alone and alone[-1] >= 9, alone
    subprocess.run(
        [COMMAND, "run", MOLECULES / "peptide_20.pdb", "-o", "again.h5md", "--forces", forces],
        cwd=tmp_path,
        check=True,
        capture_output=True,
    )
    steps, positions = positions_of(tmp_path / "run.h5md")
    again = positions_of(tmp_path / "again.h5md")
    assert np.array_equal(again[0], steps)
    assert again[1].tobytes() == positions.tobytes()


# --- our own client -------------------------------------------------------------------------------


def test_our_client_pulls_pauses_and_ends(tmp_path):
    options = ("--steps", "1000000", "--imd-wait", "--force", "0", "--damping", "1")
    with served_run(COMMAND, tmp_path, *options) as run, Client(port=run.port) as client:
        assert client.version == 3
        first = client.read()
        assert first.step == 0

        def read_until(holds):  # frames under way are of before
            while not holds(frame := client.read()):
                pass
            return frame

        client.pull([3], [[0, 0, 20.0]])
        read_until(lambda frame: frame.energies["dihedrals_energy"] == 1.0)
        client.set_rate(7)
        read_until(lambda frame: frame.positions[3, 2] > first.positions[3, 2] + 0.5)
        read_until(lambda frame: frame.step % 7 == 0 and client.read().step == frame.step + 7)
        client.pause()
        client.resume()
        client.release()
        last = read_until(lambda frame: frame.energies["dihedrals_energy"] == 0.0)
        client.kill()
        for last in client:
            assert last.energies["dihedrals_energy"] == 0.0
        assert last.step % 7 == 0
        client.close()
        assert run.end()[0] == 130


def test_a_server_that_says_nothing_is_reported(capsys, monkeypatch):
    monkeypatch.setattr(watch, "GREETING", 0.05)
    with socket.create_server(("127.0.0.1", 0)) as listener:
        port = listener.getsockname()[1]
        assert watch.main([f":{port}"]) == 1
    assert capsys.readouterr().err == (
        f"pliant watch: error: 127.0.0.1:{port}: expected an IMD server that speaks first, found "
        "0.05 s of silence: it may serve one client at a time\n"
    )


def test_our_client_refuses_what_no_server_takes():
    with served_sample(5, 1000) as run, Client(port=run.port) as client:
        for atoms, forces, message in [
            ([1, 1], np.zeros((2, 3)), "expected each atom once, and from 0"),
            ([-1], np.zeros((1, 3)), "expected each atom once, and from 0"),
            ([1], [[0, np.nan, 0]], "expected forces that are finite as 32-bit floats"),
            ([1], [[0, 1e300, 0]], "expected forces that are finite as 32-bit floats"),
            ([1.5], np.zeros((1, 3)), "expected indices of atoms, found float64"),
            ([1], np.zeros((2, 3)), r"expected n atoms and forces \(n, 3\), found \(1,\) and"),
        ]:
            with pytest.raises(pliant.OptionError, match=f"^pull: {message}"):
                client.pull(atoms, forces)
        client.kill()


def test_our_client_reads_the_other_byte_order():
    with served_sample(7, 20, 2, "swapped") as run, Client(port=run.port) as client:
        frames = list(client)
        client.close()
        assert len(frames) == 20
        assert frames[5].step == 5
        assert np.array_equal(frames[5].positions, sample_positions(7, 5))
        assert run.end()[0] == 0


@pytest.mark.parametrize(
    ("sent", "message"),
    [
        (b"HTTP/1.1 400 Bad Request\r\n\r\n", "expected a handshake of version 2 or 3"),
        (struct.pack(">ii", 4, 9), "expected a handshake of version 2 or 3"),
        (b"", "the server closed the connection without a word"),
        (struct.pack(">i", 4), "the server stopped within a packet"),
        (struct.pack(">ii", 4, 3) + struct.pack(">ii", 10, 6), "expected 7 bytes of session"),
        (struct.pack(">iiii", 4, 2, 2, -1), "the server speaks of -1 atoms"),
        (struct.pack(">iiii", 4, 2, 77, 0), "packet of type 77, which there is not"),
        (struct.pack(">iiii", 4, 2, 8, 0), "the server sent a packet RATE"),
        (struct.pack(">iiii", 4, 2, 2, 3) + bytes(30), "the server stopped within a packet"),
    ],
)
def test_our_client_trusts_no_server(sent, message):
    with socket.create_server(("127.0.0.1", 0)) as listener:
        listener.settimeout(900)

        def serve():
            peer, _ = listener.accept()
            with peer:
                peer.sendall(sent)
                peer.shutdown(socket.SHUT_WR)
                while peer.recv(4096):
                    pass

        server = threading.Thread(target=serve)
        server.start()
        with (
            pytest.raises(pliant.InputError, match=message),
            Client(port=listener.getsockname()[1]) as client,
        ):
            client.read()
        server.join()


# --- hostile clients ------------------------------------------------------------------------------


# --- GROMACS --------------------------------------------------------------------------------------

#: Eight atoms of argon, as gmx grompp takes them.
ARGON = {
    "conf.gro": "argon\n    8\n"
    + "".join(
        f"    1AR      AR{k + 1:5d}{0.5 + 0.4 * (k & 1):8.3f}{0.5 + 0.4 * (k >> 1 & 1):8.3f}"
        f"{0.5 + 0.4 * (k >> 2):8.3f}\n"
        for k in range(8)
    )
    + "   3.0 3.0 3.0\n",
    "topol.top": "[ defaults ]\n1 2 no 1.0 1.0\n[ atomtypes ]\nAR 39.948 0.0 A 0.3405 0.99\n"
    "[ moleculetype ]\nAR 1\n[ atoms ]\n1 AR 1 AR AR 1 0.0 39.948\n"
    "[ system ]\nargon\n[ molecules ]\nAR 8\n",
    "md.mdp": "integrator = md\nnsteps = -1\ndt = 0.002\ncutoff-scheme = Verlet\nrlist = 1.0\n"
    "rvdw = 1.0\nrcoulomb = 1.0\ncomm-mode = none\nIMD-group = System\n",
}


def test_our_client_pulls_at_a_run_of_gromacs(tmp_path):
    gmx = shutil.which("gmx")
    if gmx is None:
        pytest.skip("GROMACS is not installed")
    for name, text in ARGON.items():
        (tmp_path / name).write_text(text)
    words = "grompp -f md.mdp -c conf.gro -p topol.top -o t.tpr -maxwarn 5"
    subprocess.run([gmx, *words.split(" ")], cwd=tmp_path, check=True, capture_output=True)
    words = "mdrun -s t.tpr -imdwait -imdpull -imdterm -imdport 0 -nt 1"
    with job([gmx, *words.split(" ")], tmp_path) as run:
        port = int(run.wait_for(r"IMD connection on port (\d+)", run.process.stderr))
        with Client(port=port) as client:
            assert client.version == 2
            first = client.read()
            assert first.positions.shape == (8, 3)
            assert np.allclose(first.positions[0], 5.0, atol=0.1)
            client.pull([0, 7], [[0, 0, 60.0], [0, 0, -60.0]])
            last = first
            # By themselves the eight stay a cube: 0 and 1 at one height.
            while abs(last.positions[0, 2] - last.positions[1, 2]) < 2.0:
                last = client.read()
            client.release()
            client.kill()
            for frame in client:
                last = frame
        assert last.step > first.step
        run.process.stderr.read()
