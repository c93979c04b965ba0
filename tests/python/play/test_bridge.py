# SPDX-License-Identifier: MIT
"""pliant play --connect: frames and forces between a run and a page, and who is let in."""

import http.client
import json
import signal
import socket
import struct
import sys
import threading
from contextlib import contextmanager
from pathlib import Path
from urllib.parse import urlsplit

import h5py
import numpy as np
import pytest
from imd_partners import MOLECULES, served_run
from pliant.play import bridge, command, connect, page, upstream
from pliant.play.imd.client import ImdFrame
from real_files import PEPTIDE

sync_client = pytest.importorskip("websockets.sync.client")
from websockets.exceptions import ConnectionClosed, InvalidStatus  # noqa: E402

COMMAND = Path(sys.executable).parent / "pliant"
BARE = b"<meta content=\"default-src 'none'; x\">" + page.PLACE
ENDLESS = ("--steps", "1000000000", "--every", "1000000", "--force", "0", "--damping", "1")
NUMBERS = 6
OPEN = {"open_timeout": 900}  # however busy the machine is


@pytest.fixture(autouse=True)
def built(tmp_path, monkeypatch):
    """A package with a page."""
    file = tmp_path / "page.html"
    file.write_bytes(BARE)
    monkeypatch.setattr(page, "PAGE", file)
    monkeypatch.setattr(bridge, "OPENING", 60.0)  # however busy the machine is
    monkeypatch.setattr(bridge, "LAST_WORD", 60.0)


class Served:
    """connect() in a thread: its address, and once it has ended its exit code."""

    def __init__(self, port):
        self.code = self.address = None
        shown = threading.Event()

        def show(address):
            self.address = address
            shown.set()

        def work():
            self.code = connect.connect("127.0.0.1", port, PEPTIDE, show)
            shown.set()

        self.thread = threading.Thread(target=work, daemon=True)
        self.thread.start()
        assert shown.wait(900)
        self.host = urlsplit(self.address).netloc

    def ask(self, path=None, host=None, method="GET"):
        connection = http.client.HTTPConnection(self.host, timeout=900)
        path = urlsplit(self.address).path if path is None else path
        connection.request(method, path, headers={"Host": host} if host else {})
        reply = connection.getresponse()
        return reply.status, reply.read()

    def talk(self, address=None, origin=None, **more):
        live = (address or self.address).replace("http:", "ws:") + "live"
        return sync_client.connect(live, origin=origin or f"http://{self.host}", **OPEN, **more)

    def end(self):
        self.thread.join(900)
        return self.code


@contextmanager
def bridged(folder, *options):
    """A run, and the bridge to it."""
    with served_run(COMMAND, folder, *(options or ENDLESS)) as run:
        yield run, Served(run.port)


def asked(talk):
    """The next frame: step, residual and positions; or what is said in place of it."""
    talk.send('{"do": "next"}')
    message = talk.recv(timeout=900)
    if isinstance(message, str):
        return json.loads(message)
    numbers = np.frombuffer(message, "<f8", NUMBERS)
    return int(numbers[0]), numbers[2], np.frombuffer(message[8 * NUMBERS :], "<f4").reshape(-1, 3)


def pull(talk, *forces):
    talk.send(json.dumps({"do": "pull", "forces": forces}))


def test_the_last_frame_of_a_run_is_shown_and_its_end_is_reported(tmp_path, monkeypatch):
    monkeypatch.setattr(upstream._Rate, "wanted", lambda *_: 0)  # each step is sent
    with bridged(tmp_path, "--steps", "300", "--imd-wait") as (run, served), served.talk() as talk:
        frames = []
        while isinstance(reply := asked(talk), tuple):
            frames.append(reply)
        assert reply == {"over": "the run has ended", "ended": True}
        talk.close()  # as the page does
        code, out, _ = run.end()
        assert (code, served.end()) == (0, 0)
    assert " 0 dropped" in out
    with h5py.File(tmp_path / "run.h5md") as file:
        positions = file["particles/trajectory/position/value"][:].astype("f4")
    assert frames[-1][0] == 300
    for step, residual, seen in frames:
        assert np.array_equal(seen, positions[step])
        assert 0 <= residual <= 1e-6


def test_a_pull_arrives_moves_the_atom_and_is_recorded(tmp_path):
    with bridged(tmp_path) as (run, served), served.talk() as talk:
        start = asked(talk)[2]
        pull(talk, [3, 40, 0, 0], [7, 0, -15.5, 0])
        while np.linalg.norm(asked(talk)[2][3] - start[3]) < 0.5:
            pass
        pull(talk)
        run.process.send_signal(signal.SIGINT)
        assert run.end()[0] == 130
    lines = (tmp_path / "run.forces").read_text().splitlines()
    assert "force OG 40 0 0" in lines
    assert "force H2 0 -15.5 0" in lines


def test_the_run_survives_a_page_that_goes_and_is_pulled_no_more(tmp_path):
    with bridged(tmp_path) as (run, served):
        with served.talk() as talk:
            start = asked(talk)
            pull(talk, [3, 40, 0, 0])
            while np.linalg.norm(asked(talk)[2][3] - start[2][3]) < 0.5:
                pass
        with served.talk() as talk:
            step, _, positions = asked(talk)
            while True:  # until the frames that were on their way are over
                before = positions
                step, _, positions = asked(talk)
                if np.array_equal(before, positions):
                    break
            assert step > start[0]
        assert run.process.poll() is None


def test_a_page_that_asks_for_nothing_holds_nothing_up(tmp_path):
    options = ("--steps", "100000", "--every", "100000", "--imd-wait")
    with bridged(tmp_path, *options) as (run, served), served.talk() as talk:
        assert run.end()[0] == 0  # with --imd-wait it goes no faster than the bridge reads
        assert asked(talk)[0] >= 50000  # the last of 30 frames a second
        assert asked(talk)["ended"]


def test_the_end_is_reported_to_a_page_that_asks_for_nothing(tmp_path):
    with bridged(tmp_path) as (run, served), served.talk() as talk:
        run.process.send_signal(signal.SIGINT)
        assert len(talk.recv(timeout=900)) > 8 * NUMBERS  # the last frame
        assert json.loads(talk.recv(timeout=900)) == {"over": "the run has ended", "ended": True}
        talk.close()
        assert served.end() == 0


def test_the_command_ends_with_the_run_whose_page_has_been_closed(tmp_path, capsys):
    with bridged(tmp_path) as (run, served):
        with served.talk() as talk:
            asked(talk)
        run.process.send_signal(signal.SIGINT)
        assert served.end() == 0
    assert capsys.readouterr().err == "note: the run has ended\n"


def test_the_command_ends_with_the_run_whose_page_nobody_opened(tmp_path, monkeypatch):
    monkeypatch.setattr(bridge, "OPENING", 0.0)
    with bridged(tmp_path) as (run, served):
        run.process.send_signal(signal.SIGINT)
        assert served.end() == 0


def test_who_does_not_know_the_address_is_refused(tmp_path):
    with bridged(tmp_path) as (_, served):
        path = urlsplit(served.address).path
        status, html = served.ask()
        assert status == 200
        assert f"connect-src ws://{served.host}{path}live; x".encode() in html
        for other in ("/", path[:-1], path + "x", path + "live/", "/etc/passwd", f"/{32 * 'a'}/"):
            assert served.ask(other) == (404, b"nothing is here\n")
        for host in ("evil.example", "localhost", "127.0.0.1", "127.0.0.1:1"):
            assert served.ask(host=host) == (403, b"expected another Host\n")
        for method in ("POST", "PUT", "HEAD", "OPTIONS"):
            assert served.ask(method=method)[0] == 405


def test_who_comes_from_elsewhere_gets_no_frame(tmp_path):
    with bridged(tmp_path) as (_, served):
        wrong = [
            ({"address": f"http://{served.host}/" + "a" * 32 + "/"}, 404),
            ({"origin": "http://evil.example"}, 403),
            ({"origin": "null"}, 403),
            ({"origin": f"https://{served.host}"}, 403),
            ({"origin": "http://localhost:" + served.host.rpartition(":")[2]}, 403),
        ]
        for options, status in wrong:
            with pytest.raises(InvalidStatus) as refused, served.talk(**options):
                pass
            assert refused.value.response.status_code == status
        live = served.address.replace("http:", "ws:") + "live"
        with pytest.raises(InvalidStatus) as refused, sync_client.connect(live, **OPEN):
            pass  # what says no origin is no browser
        assert refused.value.response.status_code == 403
        with served.talk() as talk:
            assert len(asked(talk)) == 3


BAD = [
    "pull", "[]", '{"do": "kill"}', '{"do": "pull"}', '{"do": "pull", "forces": [[1, 2, 3]]}',
    '{"do": "pull", "forces": [[327, 0, 0, 1]]}', '{"do": "pull", "forces": [[-1, 0, 0, 1]]}',
    '{"do": "pull", "forces": [[1.5, 0, 0, 1]]}', '{"do": "pull", "forces": [[true, 0, 0, 1]]}',
    '{"do": "pull", "forces": [[1, 0, 0, NaN]]}', '{"do": "pull", "forces": [[1, 0, 0, 1e39]]}',
    '{"do": "pull", "forces": [[1, 0, 0, 1], [1, 0, 0, 1]]}', " " * 70000, b"\xff\x00",
    b"[" * 60000,
]  # fmt: skip  # a table: a row a line


def test_what_no_page_says_costs_the_page_its_connection_and_nothing_else(tmp_path):
    with bridged(tmp_path) as (run, served):
        for message in BAD:
            with served.talk() as talk:
                talk.send(message)
                with pytest.raises(ConnectionClosed) as closed:
                    talk.recv(timeout=900)
                assert closed.value.rcvd.code in (1007, 1008, 1009), message
        with served.talk() as talk:
            assert asked(talk)[0] >= 0
        assert run.process.poll() is None


def told_of_pulls(talk):
    """What others pull with, once a page is told."""
    while True:
        said = talk.recv(timeout=900)
        if isinstance(said, str):
            return json.loads(said)["pulls"]


def test_two_pages_follow_and_each_is_told_what_the_other_pulls_with(tmp_path):
    with bridged(tmp_path) as (_, served), served.talk() as first:
        asked(first)
        with served.talk() as second:
            assert asked(second)[0] >= 0
            second.send(json.dumps({"do": "pull", "forces": [[7, 0, 0, 1]]}))
            assert told_of_pulls(first) == [[7, 0, 0, 1]]
            assert asked(first)[0] >= 0
        assert told_of_pulls(first) == []  # who leaves pulls no more


def test_of_a_run_with_a_temperature_no_residual_is_told():
    positions = np.zeros((2, 3))
    energies = {"temperature": 300.0, "total_energy": -600.0, "coulomb_energy": 12.0}
    frame = ImdFrame(step=5, time=0.1, energies=energies, positions=positions)
    assert np.isnan(np.frombuffer(bridge.packed(frame)[16:48], "<f8")).all()


def test_one_page_after_the_other_shares_one_connection(tmp_path):
    with bridged(tmp_path) as (run, served):
        for _ in range(3):
            with served.talk() as talk:
                asked(talk)
        run.process.send_signal(signal.SIGINT)
        assert "1 clients" in run.end()[1]


def half_a_frame(listener):
    """A server that goes in the middle of a frame of 327 atoms."""
    talk, _ = listener.accept()
    talk.sendall(struct.pack(">ii", 4, 0)[:4] + struct.pack("<i", 2))
    talk.recv(8)
    frame = struct.pack(">ii", 2, 327) + np.zeros((327, 3), "<f4").tobytes()
    talk.sendall(frame + frame[:-9])
    talk.close()


def test_a_connection_that_is_lost_is_no_end(capsys):
    with socket.create_server(("127.0.0.1", 0)) as listener:
        thread = threading.Thread(target=half_a_frame, args=[listener])
        thread.start()
        served = Served(listener.getsockname()[1])
        with served.talk() as talk:
            assert np.isnan(np.frombuffer(talk_frame(talk), "<f8", NUMBERS)).all()
            report = asked(talk)
        thread.join()
    assert report == {
        "over": "the connection is lost: IMD: the server stopped within a packet",
        "ended": False,
    }
    assert served.end() == 1
    assert "note: the connection is lost" in capsys.readouterr().err


def talk_frame(talk):
    talk.send('{"do": "next"}')
    return talk.recv(timeout=900)


def test_another_molecule_is_refused(tmp_path, capsys):
    other = MOLECULES / "caffeine.sdf"
    with served_run(COMMAND, tmp_path, *ENDLESS) as run:
        assert command.main(["--connect", f":{run.port}", str(other), "--no-open"]) == 1
    assert capsys.readouterr() == (
        "",
        f"pliant play: error: {other}: has 24 joints, the run 327: expected the file that the run "
        "reads, or the PDB file that it writes\n",
    )


def test_a_run_that_adds_hydrogens_is_known_by_its_file(tmp_path):
    bare = tmp_path / "bare.pdb"
    lines = PEPTIDE.read_text().splitlines(keepends=True)
    bare.write_text("".join(line for line in lines if line[76:78] != " H"))
    structure = connect.read(bare)
    joints = connect.build_model(structure, "protein").framework.joint_count
    assert joints > len(structure)
    assert connect.matching_model(bare, len(structure)) == "bonds"
    assert connect.matching_model(bare, joints) == "protein"


def test_nobody_listens_and_nothing_is_given(tmp_path, capsys):
    with socket.create_server(("127.0.0.1", 0)) as listener:
        port = listener.getsockname()[1]
    assert command.main(["--connect", f":{port}", str(PEPTIDE)]) == 1
    assert capsys.readouterr().err == (
        f"pliant play: error: 127.0.0.1:{port}: expected a run that listens there (pliant run "
        "--imd) and sends frames: Connection refused\n"
    )
    assert command.main(["--connect", ":8888"]) == 2
    said = "pliant play: error: --connect: expected FILE too, the one that the run reads\n"
    assert capsys.readouterr().err == said
    with pytest.raises(SystemExit) as ended:
        command.main(["--connect", "nowhere", str(PEPTIDE)])
    assert ended.value.code == 2
    assert "expected HOST:PORT, found 'nowhere'" in capsys.readouterr().err
