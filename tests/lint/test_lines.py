# SPDX-License-Identifier: MIT
"""Each room has at most the lines that its row of tests/lines.toml allows.

``python tests/lint/test_lines.py`` writes the rows anew; their difference shows what grew.
"""

from collections import Counter
from math import ceil
from pathlib import Path

from sources import ROOT, refuse, tracked

try:
    import tomllib
except ImportError:  # Python 3.10
    from pip._vendor import tomli as tomllib

TABLE = ROOT / "tests" / "lines.toml"
COUNTED = {".cpp", ".hpp", ".py", ".mjs", ".js", ".pyi", ".css", ".html"}
STEP = 10  # rows are multiples of it
#: a row may be above its room by one of them
LINES, SHARE = 50, 0.03


def rows() -> dict[str, int]:
    """Room and lines, product and tests."""
    return {k: v for part in tomllib.loads(TABLE.read_text()).values() for k, v in part.items()}


def room_of(name: str, rooms) -> str:
    """The innermost room that a file is in; `` if it is in none."""
    above = [parent.as_posix() for parent in Path(name).parents]
    return next((one for one in above if one in rooms), "")


def lines_of(names: list[str], rooms) -> Counter:
    """Lines of the files of each room, without those of the rooms in it."""
    found = Counter(dict.fromkeys(rooms, 0))
    for name in names:
        if Path(name).suffix in COUNTED and (ROOT / name).is_file():
            found[room_of(name, rooms)] += (ROOT / name).read_bytes().count(b"\n")
    return found


def known() -> list[str]:
    """Every file that git knows, or will know."""
    return sorted(set(tracked("--cached", "--others", "--exclude-standard")))


def findings(found: Counter, allowed: dict[str, int]) -> list[str]:
    """One text for each room with more lines than its row has, or much fewer."""
    return [
        f"{room or 'no room'}: {lines} lines, and its row has {allowed.get(room, 0)}: "
        "take some out, or write the rows anew (tests/README.md)"
        for room, lines in sorted(found.items())
        if not 0 <= allowed.get(room, 0) - lines <= max(LINES, SHARE * allowed.get(room, 0))
    ]


def test_each_room_keeps_to_its_lines():
    refuse(findings(lines_of(known(), rows()), rows()))


def test_a_room_that_grew_or_shrank_is_named():
    allowed = {"a": 1000, "b": 4000}
    assert findings(Counter(a=1000, b=3880), allowed) == []
    assert "a: 1001 lines, and its row has 1000" in findings(Counter(a=1001), allowed)[0]
    assert "a: 949 lines, and its row has 1000" in findings(Counter(a=949), allowed)[0]
    assert "b: 3879 lines" in findings(Counter(b=3879), allowed)[0]
    assert "no room: 1 lines" in findings(Counter({"": 1}), allowed)[0]


def test_a_file_is_in_the_innermost_room():
    rooms = ("src", "src/pliant/base")
    assert room_of("src/pliant/base/math/a.cpp", rooms) == "src/pliant/base"
    assert room_of("src/pliant/text/a.cpp", rooms) == "src"
    assert room_of("other.py", rooms) == ""


def write_anew() -> None:
    """The rows as the rooms are now, each rounded up."""
    found = lines_of(known(), rows())
    text = [
        f'"{line.split(chr(34))[1]}" = {STEP * ceil(found[line.split(chr(34))[1]] / STEP)}'
        if line.startswith('"')
        else line
        for line in TABLE.read_text().splitlines()
    ]
    TABLE.write_text("\n".join([*text, ""]))


if __name__ == "__main__":
    write_anew()
