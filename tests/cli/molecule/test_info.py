# SPDX-License-Identifier: MIT
import json


def test_info_counts_as_json(pliant, ethanol):
    ended = pliant("info", ethanol, "--json")
    assert (ended.code, ended.err) == (0, "")
    facts = json.loads(ended.out)
    counts = {key: facts[key] for key in ("atoms", "joints", "bonds", "bars", "cycles")}
    assert counts == {"atoms": 9, "joints": 9, "bonds": 8, "bars": 8, "cycles": 0}
    assert (facts["components"], facts["bridges"], facts["blocks"]) == (1, 8, 0)
    assert facts["elements"] == {"H": 6, "C": 2, "O": 1}


def test_info_as_a_table(pliant, ethanol):
    ended = pliant("info", ethanol)
    assert ended.code == 0
    assert "bonds                8   from distance 8" in ended.out
    assert "cycles               0   independent: bars - atoms + components" in ended.out


TRIANGLE_WITH_A_TAIL = """<graph>
<joint id="a" x="0" y="0" z="0" pinned="true"/><joint id="b" x="1" y="0" z="0"/>
<joint id="c" x="0" y="1" z="0"/><joint id="d" x="0" y="2" z="0"/>
<bar a="a" b="b"/><bar a="b" b="c"/><bar a="c" b="a"/><bar a="c" b="d"/>
</graph>"""


def test_a_graph_has_joints_and_no_atoms(pliant, tmp_path):
    (tmp_path / "g.xml").write_text(TRIANGLE_WITH_A_TAIL)
    ended = pliant("info", "g.xml")
    assert ended.out.splitlines() == [
        "g.xml (graph)",
        "joints               4   1 joint pinned",
        "bars                 4",
        "components           1",
        "cycles               1   independent: bars - joints + components",
        "bridges              1   bars on no cycle",
        "blocks               1   ring systems, with 3 bars in all, 3 in the largest",
        "nothing was guessed",
    ]
    facts = json.loads(pliant("info", "g.xml", "--json").out)
    assert (facts["joints"], facts["pinned"]) == (4, 1)
    assert {"atoms", "elements", "bonds", "residues"}.isdisjoint(facts)


def test_limits_and_sterics_of_a_bars_file_are_counted(pliant, tmp_path):
    (tmp_path / "g.xml").write_text(TRIANGLE_WITH_A_TAIL)
    (tmp_path / "bars.txt").write_text(
        "pliant-bars 1\nbars bonds\nlimit a d 1.5 2.5\nlimit b d 0 3 hydrophobic\n"
        "kind a X\nkind d X\nsterics X X 1\n"
    )
    ended = pliant("info", "g.xml", "--bars", "bars.txt")
    assert ended.out.splitlines()[-3:-1] == [
        "limits               2   of kind given 1, hydrophobic 1",
        "sterics: joints keep least distances",
    ]
    facts = json.loads(pliant("info", "g.xml", "--bars", "bars.txt", "--json").out)
    assert (facts["bars"], facts["limits"], facts["sterics"]) == (4, 2, True)
    counts = {kind: count for kind, count in facts["limits_by_kind"].items() if count}
    assert counts == {"given": 1, "hydrophobic": 1}


def test_a_comment_may_read_like_tinker(pliant, tmp_path):
    (tmp_path / "water.xyz").write_text("1\n 1 O 0.0 0.0 0.0 1 2 3\nO 0 0 0\n")
    assert pliant("info", "water.xyz").code == 0
