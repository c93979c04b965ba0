# SPDX-License-Identifier: MIT
"""Which folder may include which, and what a public header may need."""

import re
import shutil
import subprocess
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from itertools import takewhile
from pathlib import Path

import pytest
from sources import CPP, ROOT, files, numbered_lines, place, refuse

# The folders of src/pliant, and which of the others each may include.
MAY_INCLUDE = {
    "base": (),
    "text": ("base",),
    "framework": ("base",),
    "measure": ("base",),
    "rigidity": ("base", "framework"),
    "molecule": ("base", "text", "framework"),
    "model": ("base", "text", "framework", "rigidity", "molecule"),
    "order": ("base", "text", "framework"),
    "perturb": ("base", "text", "framework"),
    "resolve": ("base", "framework", "order", "rigidity"),
    "conformers": ("base", "framework", "rigidity", "resolve"),
    "sample": ("base", "framework", "rigidity", "resolve", "conformers"),
    "run": ("base", "framework", "order", "resolve", "perturb"),
    "fit": ("base", "text", "measure"),
    "path": ("base", "framework", "molecule", "model", "resolve", "perturb", "sample", "run"),
    "record": ("base", "text", "framework"),
    "jobs": (
        "base",
        "text",
        "framework",
        "molecule",
        "model",
        "order",
        "resolve",
        "perturb",
        "conformers",
        "sample",
        "run",
        "path",
        "record",
    ),
    "stream": ("base", "framework", "perturb"),
    "lab": ("base", "text", "framework", "order", "resolve", "perturb", "record"),
}

# The wings of large folders, in order: each may include those before it. What lies in the folder
# itself stands where ITSELF stands; where that is nowhere, last: it is the door of its wings.
ITSELF = "itself"
WINGS = {
    "base": (ITSELF, "graphs", "math", "system", "threads"),
    "base/system": (ITSELF, "posix", "windows"),
    "framework": (ITSELF, "measures"),
    "molecule": ("structure", "read", "bonds"),
    "molecule/read": ("shared", "pdb", "cif", "sdf", "xyz"),
    "model": ("atoms", "prepare", "contacts", ITSELF, "rigidity"),
    "perturb": (ITSELF, "force_files"),
    "resolve": ("method", "sweeps", "equations", "newton", "shake", "blocks", "lanes", "bodies"),
    "resolve/bodies": ("tree", "near", "pull", "outward", "region"),
    "conformers": ("rings", "torsions", "strain", "choice"),
    "sample": ("network", "turns", "loops", "pocket"),
    "fit": (ITSELF, "map", "saxs"),
    "jobs": ("asked", "files"),
    "lab": ("examples", "generate", "test_sets"),
    "record": ("hdf5", "h5md", "xml"),
}

# Libraries that stay behind .cpp files, so that users of our headers need not have them.
PRIVATE_LIBRARIES = re.compile(
    r"(hdf5|H5\w+)\.h|(gemmi|Eigen|fmt|nlohmann|CLI|nanobind|gtest|gmock|rapidcheck)/|pugi\w+\.hpp|"
    r"(zlib|bzlib|lzma)\.h|CLI11?\.hpp"
)

INCLUDE = re.compile(r'\s*#\s*include\s*([<"])([^>"]+)[>"]')
LIBRARY = ROOT / "src" / "pliant"


def includes(path: Path) -> Iterator[tuple[int, str, str]]:
    """Line, kind of quote and name of each include of a file."""
    for number, line in numbered_lines(path):
        if found := INCLUDE.match(line):
            yield number, found[1], found[2]


def folder_of(path: Path) -> str:
    """The folder of src/pliant that a file is in; `` for src/pliant itself."""
    parts = path.relative_to(LIBRARY).parts
    return parts[0] if len(parts) > 1 else ""


def wings_of(name: str) -> list[str]:
    """The folders of `pliant/molecule/read/pdb/pdb.hpp`: molecule, read, pdb."""
    return name.split("/")[1:-1]


def may_enter(mine: list[str], theirs: list[str]) -> bool:
    """Whether a file of the folders `mine` may include one of `theirs`, both within one folder.

    The row of the last folder that they share decides.
    """
    both = zip(mine, theirs, strict=False)
    shared = len(list(takewhile(lambda pair: pair[0] == pair[1], both)))
    row = WINGS.get("/".join(mine[:shared]), ())
    row = row if ITSELF in row else (*row, ITSELF)
    here, there = [(*folders, ITSELF)[shared] for folders in (mine, theirs)]
    return row.index(there) <= row.index(here)


def wrong_directions(path: Path) -> Iterator[str]:
    """One text for each include that goes against MAY_INCLUDE or WINGS."""
    folder, mine = folder_of(path), wings_of(path.relative_to(LIBRARY.parent).as_posix())
    allowed = (folder, *MAY_INCLUDE.get(folder, ()))
    for number, _, name in includes(path):
        if not name.startswith("pliant/"):
            continue
        if name.split("/")[1] not in allowed:
            yield f"{place(path, number)}: {folder} may not include {name}"
        elif name.split("/")[1] == folder and not may_enter(mine, wings_of(name)):
            yield f"{place(path, number)}: {'/'.join(mine)} may not include {name}"


def test_wings_are_entered_one_way():
    assert may_enter(["base", "math"], ["base"])  # the ground floor
    assert not may_enter(["base"], ["base", "math"])
    assert may_enter(["molecule"], ["molecule", "read", "pdb"])  # the door
    assert not may_enter(["molecule", "read", "pdb"], ["molecule"])
    assert may_enter(["molecule", "bonds"], ["molecule", "read"])
    assert not may_enter(["molecule", "structure"], ["molecule", "read"])
    assert may_enter(["molecule", "read", "cif"], ["molecule", "read", "shared"])
    assert not may_enter(["molecule", "read", "shared"], ["molecule", "read", "pdb"])


def test_every_folder_is_in_the_table():
    folders = {path.name for path in LIBRARY.iterdir() if path.is_dir()}
    assert folders <= set(MAY_INCLUDE)


def rows_of_page(columns: int) -> Iterator[list[str]]:
    """The cells of the tables of the page on structure that have so many columns."""
    for line in (LIBRARY / "README.md").read_text().splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if line.startswith("| `") and len(cells) == columns:
            yield cells


def test_the_page_on_structure_tells_the_same():
    folders = {row[0].strip("`"): row[3] for row in rows_of_page(4)}
    expected = {name: ", ".join(needs) or "nothing of ours" for name, needs in MAY_INCLUDE.items()}
    assert folders == expected
    wings = {row[0].strip("`"): row[1] for row in rows_of_page(2)}
    assert {name: ", ".join(row) for name, row in WINGS.items()} == wings


def test_every_wing_is_in_the_table():
    folders = {path.relative_to(LIBRARY).as_posix() for path in LIBRARY.rglob("*") if path.is_dir()}
    rows = {f"{folder}/{wing}" for folder, row in WINGS.items() for wing in row if wing != ITSELF}
    assert folders - set(MAY_INCLUDE) == rows


def unit_of(name: str) -> str:
    """A header and its source are one unit: `pliant/base/log`."""
    return name.rsplit(".", 1)[0].removesuffix("_internal")


def circles_of_units() -> list[set[str]]:
    """Groups of units that include each other, directly or not (Tarjan's components)."""
    needs = {}
    for path in files(*CPP, folders=("src",)):
        unit = unit_of(path.relative_to(ROOT / "src").as_posix())
        names = {unit_of(name) for _, _, name in includes(path) if name.startswith("pliant/")}
        needs[unit] = needs.get(unit, set()) | (names - {unit})
    reached = {unit: reach(unit, needs) for unit in needs}
    return [
        {other for other in reached[unit] if unit in reached.get(other, ())} | {unit}
        for unit in sorted(reached)
        if unit in reached[unit]
    ]


def reach(unit: str, needs: dict[str, set[str]]) -> set[str]:
    """All that `unit` needs, directly or not."""
    found: set[str] = set()
    todo = list(needs[unit])
    while todo:
        name = todo.pop()
        if name not in found:
            found.add(name)
            todo.extend(needs.get(name, ()))
    return found


def test_no_circle_of_units_crosses_a_wing():
    refuse(
        [
            "a circle of includes crosses a wing: " + ", ".join(sorted(circle))
            for circle in circles_of_units()
            if len({name.rsplit("/", 1)[0] for name in circle}) > 1
        ]
    )


LARGEST_CIRCLE = 3  # units: a table, its rows and what both need


def test_no_circle_of_units_is_large():
    circles = {frozenset(circle) for circle in circles_of_units()}
    refuse(
        [
            f"a circle of {len(circle)} units: {', '.join(sorted(circle))}"
            for circle in sorted(circles, key=sorted)
            if len(circle) > LARGEST_CIRCLE
        ]
    )


# Sources that hold rows of a table which another header declares, or are compiled several times.
SYSTEM = LIBRARY / "base" / "system"  # one source for each kind of system
WITHOUT_HEADER = re.compile(r"examples_\w+\.cpp|families\.cpp|lane_level\.cpp")
# Finders of contacts are declared by their rows.
CONTACT_KINDS = (ROOT / "src" / "pliant" / "framework" / "contact_kind_rows.hpp").read_text()
SAMPLERS = (ROOT / "src" / "pliant" / "sample" / "samplers.cpp").read_text()


def test_every_source_has_a_header_of_its_name():
    refuse(
        [
            f"{place(path, 1)}: no header of this name"
            for path in files(".cpp", folders=("src",))
            if not WITHOUT_HEADER.fullmatch(path.name)
            and f"find_{path.stem}," not in CONTACT_KINDS
            and f"make_{path.stem}," not in SAMPLERS
            and not path.with_suffix(".hpp").exists()
            and not (SYSTEM / path.name).with_suffix(".hpp").exists()
            and not path.with_name(path.stem + "_internal.hpp").exists()
        ]
    )


def test_the_table_has_no_cycle():
    done: set[str] = set()
    while len(done) < len(MAY_INCLUDE):
        ready = {name for name, needs in MAY_INCLUDE.items() if done.issuperset(needs)} - done
        assert ready, f"a cycle among {sorted(set(MAY_INCLUDE) - done)}"
        done |= ready


def test_the_library_does_not_stand_on_its_laboratory():
    assert not [name for name, needs in MAY_INCLUDE.items() if "lab" in needs]


def test_includes_go_one_way():
    refuse(
        [
            text
            for path in files(*CPP, folders=("src",))
            if folder_of(path)
            for text in wrong_directions(path)
        ]
    )


def test_includes_of_ours_are_quoted_and_whole():
    refuse(
        [
            f'{place(path, number)}: write #include "pliant/...", not {quote}{name}'
            for path in files(*CPP, folders=("src",))
            for number, quote, name in includes(path)
            if (quote == '"') != name.startswith("pliant/")
        ]
    )


def test_headers_need_the_standard_library_only():
    refuse(
        [
            f"{place(path, number)}: {name} in a header that is installed"
            for path in files(".hpp", folders=("src",))
            if not path.stem.endswith("_internal")
            for number, _, name in includes(path)
            if PRIVATE_LIBRARIES.match(name)
        ]
    )


CONTENTS = LIBRARY / "pliant.hpp"
CONSUMER = ROOT / "tests" / "install" / "consumer" / "every_header.cpp"


def ours(path: Path) -> list[str]:
    """The headers of ours that a file includes."""
    return [name for _, _, name in includes(path) if name.startswith("pliant/")]


# What users may include is promised until the next major version, and what that includes is
# installed with it: both stay few.
MOST_PUBLIC = 25
MOST_INSTALLED = 66


def test_public_headers_are_few():
    needs = {
        f"pliant/{path.relative_to(LIBRARY).as_posix()}": set(ours(path))
        for path in files(".hpp", folders=("src",))
    }
    assert len(ours(CONTENTS)) <= MOST_PUBLIC
    assert len(reach("pliant/pliant.hpp", needs)) <= MOST_INSTALLED


def test_every_public_header_is_used_by_the_consumer():
    public, text = ours(CONTENTS), CONSUMER.read_text()
    assert sorted(public) == sorted(ours(CONSUMER))
    refuse([f"{place(CONSUMER)}: uses nothing of {n}" for n in public if f'("{n}"' not in text])


# Where XML text becomes elements, after document types and entities were refused.
XML_DOOR = "xml_document.cpp"
OPENS_XML = re.compile(r"\bload_(buffer|string|file)\w*\(|\bparse_(doctype|full)\b")


def test_xml_has_one_door():
    refuse(
        [
            f"{place(path, number)}: parse XML with XmlDocument, which expands no entity"
            for path in files(*CPP)
            for number, line in numbered_lines(path)
            if OPENS_XML.search(line) and path.name != XML_DOOR
        ]
    )
    door = (LIBRARY / "record/xml" / XML_DOOR).read_text()
    assert door.index("check_xml_text(") < door.index("load_buffer(")
    assert "parse_doctype" not in door
    assert "parse_full" not in door


def compile_alone(header: Path) -> str:
    """What the compiler says of a header that is included first and alone; empty if nothing."""
    name = header.relative_to(ROOT / "src").as_posix()
    command = ["g++", "-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-I", "src", "-x", "c++"]
    result = subprocess.run(
        [*command, "-"],
        cwd=ROOT,
        text=True,
        capture_output=True,
        input=f'#include "{name}"\n',
        check=False,
    )
    return result.stderr and f"{name}:\n{result.stderr}"


@pytest.mark.long
@pytest.mark.skipif(not shutil.which("g++"), reason="g++ is not installed")
def test_headers_compile_alone():
    headers = [path for path in files(".hpp", folders=("src",)) if path.parent.name != "windows"]
    with ThreadPoolExecutor(max_workers=2) as pool:
        refuse([text for text in pool.map(compile_alone, headers) if text])
