# SPDX-License-Identifier: MIT
"""pliant play: what is served, to whom, and once; the message where something is missing."""

import base64
import http.client
import json
import re
import socket
import threading
import time
import webbrowser

import numpy as np
import pytest
from pliant.play import command, page
from pliant.play import server as page_server
from pliant.play.measured import measured_for_page
from pliant.play.server import PageServer
from real_files import PEPTIDE

import pliant

BARE = b"<!doctype html><title>page</title>" + page.PLACE + b"<p>end</p>"


@pytest.fixture
def built(tmp_path, monkeypatch):
    """A package with a page."""
    file = tmp_path / "pliant.html"
    file.write_bytes(BARE)
    monkeypatch.setattr(page, "PAGE", file)
    return file


@pytest.fixture
def server():
    with PageServer(b"first", b"then") as running:
        thread = threading.Thread(target=running.serve_forever, kwargs={"poll_interval": 0.01})
        thread.start()
        yield running
        running.shutdown()
        thread.join()


def ask(server, path, host=None, method="GET"):
    connection = http.client.HTTPConnection("127.0.0.1", server.server_port, timeout=900)
    connection.request(method, path, headers={"Host": host} if host else {})
    reply = connection.getresponse()
    return reply.status, reply.read(), reply


def given_in(text):
    block = re.search(rb'<script type="application/json" id="given">(.*?)</script>', text)
    return json.loads(block[1])


def test_the_first_page_is_handed_out_once(server):
    assert ask(server, server.path)[:2] == (200, b"first")
    assert ask(server, server.path)[:2] == (200, b"then")
    assert ask(server, server.path)[:2] == (200, b"then")


def test_nothing_else_is_served(server):
    for path in ("/", server.path + "x", server.path + "../", "/etc/passwd", "/" + "a" * 32 + "/"):
        assert ask(server, path)[:2] == (404, b"nothing is here\n")
    for method in ("POST", "PUT", "HEAD", "OPTIONS"):
        assert ask(server, server.path, method=method)[0] == 501
    assert ask(server, server.path)[1] == b"first"


@pytest.mark.parametrize("host", ["evil.example", "localhost", "127.0.0.1", "127.0.0.1:1"])
def test_another_host_is_refused(server, host):
    assert ask(server, server.path, host)[:2] == (403, b"expected another Host\n")
    assert ask(server, server.path)[1] == b"first"


def connect(server, text=b""):
    client = socket.create_connection(("127.0.0.1", server.server_port), timeout=900)
    client.sendall(text)
    return client


def test_clients_that_say_nothing_keep_nobody_waiting(server, monkeypatch):
    monkeypatch.setattr(page_server, "SLOWEST", 1e6)
    monkeypatch.setattr(page_server._Handler, "timeout", 1e6)
    begun = f"GET {server.path} HTTP/1.1\r\nHost: ".encode()
    with connect(server), connect(server), connect(server, begun):
        assert ask(server, server.path)[:2] == (200, b"first")


def test_a_client_has_a_time_for_its_whole_request(server, monkeypatch):
    monkeypatch.setattr(page_server, "SLOWEST", 0.1)
    monkeypatch.setattr(page_server._Handler, "timeout", 1e6)
    with connect(server, b"GET / HTTP/1.1\r\n") as client, pytest.raises(OSError):
        while True:  # a header that has no end, until nobody hears it
            client.sendall(b"a")
            time.sleep(0.01)


def test_of_many_clients_that_say_nothing_the_first_go(server, monkeypatch):
    monkeypatch.setattr(page_server, "SLOWEST", 1e6)
    monkeypatch.setattr(page_server._Handler, "timeout", 1e6)
    monkeypatch.setattr(page_server, "MOST_WAITING", 2)
    with connect(server) as first, connect(server) as second, connect(server), connect(server):
        assert first.recv(1) == second.recv(1) == b""
        assert ask(server, server.path)[:2] == (200, b"first")
        assert len(server.waiting) <= 2


def test_the_first_page_is_one_clients_alone(server):
    seen, together = [], threading.Barrier(8)

    def look():
        together.wait()
        seen.append(ask(server, server.path)[1])

    clients = [threading.Thread(target=look) for _ in range(8)]
    for client in clients:
        client.start()
    for client in clients:
        client.join()
    assert sorted(seen) == [b"first", *[b"then"] * 7]


def test_addresses_are_of_this_machine_and_differ():
    with PageServer(b"", b"") as one, PageServer(b"", b"") as other:
        assert one.server_address[0] == "127.0.0.1"
        assert one.path != other.path
        assert len(one.path) == 34
        assert one.address == f"http://127.0.0.1:{one.server_port}{one.path}"


def test_headers_let_nobody_keep_or_frame_it(server):
    reply = ask(server, server.path)[2]
    assert reply.getheader("Cache-Control") == "no-store"
    assert reply.getheader("X-Frame-Options") == "DENY"
    assert reply.getheader("Server").strip() == "pliant"


def test_the_file_is_inside_the_page_and_is_no_markup():
    name = "</script><script>alert(1)</script>.pdb"
    text = page.with_file(BARE, name, b"\x00\xff</script>")
    assert text.count(b"</script>") == 1
    found = given_in(text)
    assert found["name"] == name
    assert base64.b64decode(found["data"]) == b"\x00\xff</script>"
    assert given_in(page.without_file(BARE, name)) == {"name": name, "gone": True}


def test_without_a_file_the_page_is_opened_as_a_file(built, monkeypatch, capsys):
    opened = []
    monkeypatch.setattr(webbrowser, "open", lambda address: opened.append(address) or True)
    assert command.main([]) == 0
    assert opened == [built.as_uri()]
    assert capsys.readouterr().out == f"opened {built.as_uri()}\n"


def test_no_open_prints_the_address(built, capsys):
    assert command.main(["--no-open"]) == 0
    assert capsys.readouterr().out == f"{built.as_uri()}\n"


def test_without_a_browser_the_address_is_printed(built, monkeypatch, capsys):
    monkeypatch.setattr(webbrowser, "open", lambda address: False)
    assert command.main([]) == 0
    assert capsys.readouterr().out == f"{built.as_uri()}\n"


def test_a_file_is_served_until_ctrl_c(built, tmp_path, monkeypatch, capsys):
    molecule = tmp_path / "m.xyz"
    molecule.write_bytes(b"1\n\nC 0 0 0\n")
    seen = []

    def look(server, poll_interval):
        thread = threading.Thread(target=lambda: seen.append(ask(server, server.path)[1]))
        thread.start()
        server.handle_request()
        thread.join()
        raise KeyboardInterrupt

    monkeypatch.setattr(PageServer, "serve_forever", look)
    assert command.main([str(molecule), "--no-open"]) == 0
    assert re.fullmatch(r"http://127\.0\.0\.1:\d+/[\w-]{32}/\n", capsys.readouterr().out)
    assert base64.b64decode(given_in(seen[0])["data"]) == molecule.read_bytes()


def test_distances_are_told_by_the_names_of_the_atoms(tmp_path, capsys):
    table = tmp_path / "d.csv"
    rows = "A:3,A:17,20,2,,,\n4,16,,,,25,\n5,12,,,8,,\n5,15,20,2,,,MTSL\n"
    table.write_text(f"site1,site2,distance,error,low,high,kind\n{rows}", encoding="utf-8")
    told = measured_for_page(PEPTIDE, table, None, None)["distances"]
    structure = pliant.read(PEPTIDE)
    names = {structure.label(atom) for atom in np.flatnonzero(structure.names == "CA")}
    assert [(row["low"], row["high"]) for row in told["rows"]] == [(18, 22), (0, 25), (8, None)]
    assert {name for row in told["rows"] for name in row["names"]} <= names
    assert told["holds"] == 1
    assert "1 of 4 distances are of labels or atoms: not shown" in capsys.readouterr().err


def test_a_map_is_told_by_its_surface_and_the_points_inside(tmp_path):
    peptide = pliant.read(PEPTIDE)
    density = pliant.DensityMap.from_structure(peptide, 6.0)
    density.save(tmp_path / "m.mrc")
    told = measured_for_page(PEPTIDE, None, str(tmp_path / "m.mrc"), 6.0)["map"]
    inside = np.frombuffer(base64.b64decode(told["inside"]), np.uint8)
    volume = inside.sum() * told["spacing"] ** 3
    assert volume == pytest.approx(1.21 * peptide.masses.sum(), rel=0.05)
    corners = np.frombuffer(base64.b64decode(told["positions"]), "<i2").reshape(-1, 3)
    assert np.allclose(corners.mean(axis=0) * told["step"], peptide.positions.mean(axis=0), atol=1)


def test_distances_go_with_a_run_too(tmp_path, monkeypatch):
    table, told = tmp_path / "d.csv", []
    table.write_text("site1,site2,high\n3,17,20\n", encoding="utf-8")
    monkeypatch.setattr(command, "connect", lambda *given: told.append(given) or 0)
    words = ["--connect", ":8888", str(PEPTIDE), "--distances", str(table)]
    assert command.main(words) == 0
    assert told[0][-1] == measured_for_page(PEPTIDE, str(table), None, None)


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (["--distances", "d.csv"], 2, "--distances, --map: expected FILE too"),
        ([str(PEPTIDE), "--resolution", "8"], 2, "resolution: of a map, and none is given"),
        ([str(PEPTIDE), "--map", "none.mrc"], 2, "resolution: a map needs it"),
        ([str(PEPTIDE), "--distances", "none.csv"], 1, "none.csv: No such file or directory"),
        ([str(PEPTIDE), "--distances", "d.csv"], 1, "d.csv:2: site2 '99': expected one residue"),
    ],
)
def test_distances_that_cannot_be_shown(words, code, said, built, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "d.csv").write_text("site1,site2,high\n3,99,20\n", encoding="utf-8")
    assert command.main([*words, "--no-open"]) == code
    assert capsys.readouterr().err.startswith(f"pliant play: error: {said}")


def test_a_package_without_the_page_says_how_to_make_it(tmp_path, monkeypatch, capsys):
    missing = tmp_path / "pliant.html"
    monkeypatch.setattr(page, "PAGE", missing)
    assert command.main([]) == 1
    assert capsys.readouterr().err == (
        f"pliant play: error: {missing}: not there: ./dev play makes the page, "
        "./dev build then installs it\n"
    )


def test_bad_files_and_options(built, tmp_path, monkeypatch, capsys):
    assert command.main([str(tmp_path / "none.pdb")]) == 1
    wanted = f"pliant play: error: {tmp_path}/none.pdb: cannot be read: No such file or directory\n"
    assert capsys.readouterr().err == wanted
    assert command.main([str(tmp_path)]) == 1
    assert capsys.readouterr().err.endswith(": cannot be read: Is a directory\n")
    monkeypatch.setattr(page, "MOST_BYTES", 1024**2)
    (tmp_path / "large.pdb").write_bytes(b" " * (3 * 1024**2))
    assert command.main([str(tmp_path / "large.pdb")]) == 1
    assert capsys.readouterr().err == (
        f"pliant play: error: {tmp_path}/large.pdb: expected at most 1 MB, found 3\n"
    )
    with pytest.raises(SystemExit) as ended:
        command.main(["--port", "1"])
    assert ended.value.code == 2
