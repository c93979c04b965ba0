# SPDX-License-Identifier: MIT
"""./dev test --changed runs the tests that are near a change."""

from pathlib import PurePosixPath as P

import changed_tests as near
import pytest
from sources import ROOT, files

UNIT = P("tests/unit/resolve/bodies/outward/loop_closure_test.cpp")
LAW = P("tests/law/limit_law_test.cpp")
OPENED = P("tests/python/trajectory/test_opened.py")

RANKS = [
    # test, what is in it, what changed, how near
    (UNIT, "", f"{UNIT}", near.ITSELF),
    (UNIT, "", "src/pliant/resolve/bodies/outward/loop_closure.cpp", near.NAMED),
    (UNIT, '#include "pliant/resolve/resolve.hpp"', "src/pliant/resolve/resolve.cpp", near.USES),
    (UNIT, '#include "support/frameworks.hpp"', "tests/support/frameworks.hpp", near.USES),
    (UNIT, "", "src/pliant/resolve/bodies/outward/unit_pass.hpp", near.FOLDER),
    (UNIT, "", "src/pliant/resolve/bodies/near/cells.hpp", near.AREA),
    (UNIT, "", "src/pliant/record/h5md/h5md_reader.cpp", None),
    (
        LAW,
        '#include "pliant/resolve/resolve.hpp"',
        "src/pliant/resolve/bodies/outward/x.cpp",
        near.AFAR,
    ),
    (LAW, "", "tests/law/bond_law_test.cpp", None),
    (OPENED, "", "python/pliant/trajectory/opened.py", near.NAMED),
    (
        OPENED,
        "from pliant.trajectory.record import Record",
        "python/pliant/trajectory/record.py",
        near.USES,
    ),
    (
        OPENED,
        "from pliant.trajectory import a, record",
        "python/pliant/trajectory/record.py",
        near.USES,
    ),
    (
        OPENED,
        "from pliant.measure import read_record",
        "python/pliant/measure/frames.py",
        near.AFAR,
    ),
    (OPENED, "from damaged_h5md import damages", "tests/support/python/damaged_h5md.py", near.USES),
    (OPENED, "", "python/pliant/trajectory/stored.py", near.FOLDER),
    (OPENED, "", "tests/python/trajectory/conftest.py", near.AREA),
    (OPENED, "", "python/pliant/base/csv_cells.py", None),
    (P("tests/python/base/test_console.py"), "", "python/pliant/base/console.py", near.NAMED),
    (P("tests/python/resolve/test_x.py"), "", "python/bind/resolve/bind_resolve.cpp", near.FOLDER),
    (P("tests/cli/sample/test_sample.py"), "", "apps/commands/cmd_sample.cpp", near.NAMED),
    (P("tests/cli/test_help.py"), "", "apps/commands/cmd_sample.cpp", near.AREA),
    (P("tests/docs/test_pages.py"), "", "docs/pages/commands.md", near.AREA),
    (P("tests/docs/test_pages.py"), 'ROOT / "README.md"', "README.md", near.USES),
]


@pytest.mark.parametrize(("test", "text", "changed", "rank"), RANKS)
def test_a_test_is_as_near_as_its_name_and_what_it_includes_say(test, text, changed, rank):
    assert near.nearness(test, text, P(changed)) == rank


def test_the_nearest_tests_are_chosen_as_far_as_the_time_goes():
    a, b, c, d, e = map(P, "abcde")
    ranks = {a: near.USES, b: near.ITSELF, c: near.USES, d: near.AREA, e: near.AREA}
    seconds = {a: 30.0, b: 100.0, c: 20.0, d: 20.0, e: 10.0}
    assert near.choose(ranks, seconds, budget=165.0) == [b, c, a, e]


def test_every_source_of_the_library_has_a_test_near_it():
    tests = near.all_tests()

    def is_lonely(source):
        return all(near.nearness(test, text, source) is None for test, text in tests.items())

    sources = [P(path.relative_to(ROOT).as_posix()) for path in files(".cpp", folders=("src",))]
    assert [source for source in sources if is_lonely(source)] == []


def test_the_suites_of_a_file_are_found():
    text = "TEST(One, A) {\nTEST_P(Two,\n  B)\nRC_GTEST_PROP(Three, C, ()) {\n// TEST(Four, D)\n"
    assert near.suites(text) == {"One", "Two", "Three"}
