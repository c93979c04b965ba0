# SPDX-License-Identifier: MIT
"""Numbers that are the same everywhere: no function whose last bits a C library chooses."""

import re

from sources import ROOT, refuse

#: IEEE 754 fixes the bits of + - * / sqrt; of these each C library has its own.
CHOSEN = re.compile(
    r"std::(exp2?|expm1|log(2|10|1p)?|pow|a?(sin|cos|tan)h?|atan2|cbrt|hypot|erfc?|[lt]gamma)\("
)
#: Drawn examples, which are given once and for all by what a test holds.
MAY = {"src/pliant/lab/examples"}


def test_results_do_not_depend_on_the_c_library():
    refuse(
        [
            f"{path.relative_to(ROOT)}:{number}: {match.group()} has other bits elsewhere: see "
            "base/math/elementary.hpp"
            for path in sorted((ROOT / "src/pliant").rglob("*.?pp"))
            if str(path.relative_to(ROOT).parent) not in MAY
            for number, line in enumerate(path.read_text().splitlines(), 1)
            if (match := CHOSEN.search(line.split("//")[0]))
        ]
    )
