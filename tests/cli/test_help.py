# SPDX-License-Identifier: MIT
"""The command's face is under version control: --help texts are committed beside this file.

After a change that is meant: PLIANT_UPDATE_HELP=1 pytest tests/cli/test_help.py, and read the diff.
"""

import os
import re
from pathlib import Path

import pytest

PAGES = {
    "pliant": ["--help"],
    "pliant-info": ["info", "--help"],
    "pliant-contacts": ["contacts", "--help"],
    "pliant-rigidity": ["rigidity", "--help"],
    "pliant-run": ["run", "--help"],
    "pliant-sample": ["sample", "--help"],
    "pliant-structgen": ["structgen", "--help"],
    "pliant-forcegen": ["forcegen", "--help"],
    "pliant-order": ["order", "--help"],
    "pliant-study": ["study", "--help"],
    "pliant-techniques": ["techniques", "--help"],
    "pliant-check": ["check", "--help"],
    "pliant-conformers": ["conformers", "--help"],
    "pliant-analyse": ["analyse", "--help"],
    "pliant-representatives": ["representatives", "--help"],
    "pliant-compare": ["compare", "--help"],
    "pliant-convert": ["convert", "--help"],
    "pliant-ensemble": ["ensemble", "--help"],
    "pliant-path": ["path", "--help"],
    "pliant-watch": ["watch", "--help"],
    "pliant-demo": ["demo", "--help"],
    "pliant-play": ["play", "--help"],
    "pliant-recover": ["recover", "--help"],
    "pliant-experiment": ["experiment", "--help"],
    "pliant-experiment-report": ["experiment", "report", "--help"],
    "pliant-experiment-sweep": ["experiment", "sweep", "--help"],
    "pliant-bench": ["bench", "--help"],
    "pliant-bench-work-precision": ["bench", "work-precision", "--help"],
    "pliant-bench-scaling": ["bench", "scaling", "--help"],
    "pliant-bench-throughput": ["bench", "throughput", "--help"],
    "pliant-bench-stress": ["bench", "stress", "--help"],
    "pliant-bench-step": ["bench", "step", "--help"],
    "pliant-bench-validity": ["bench", "validity", "--help"],
    "pliant-bench-coverage": ["bench", "coverage", "--help"],
    "pliant-bench-domains": ["bench", "domains", "--help"],
    "pliant-bench-conformers": ["bench", "conformers", "--help"],
    "pliant-bench-molecules": ["bench", "molecules", "--help"],
}
#: whose --help shows a part of their options
WITH_MORE = (
    *(
        "analyse",
        "check",
        "conformers",
        "contacts",
        "ensemble",
        "experiment",
        "forcegen",
        "info",
        "order",
    ),
    *("path", "representatives", "rigidity", "run", "sample", "structgen", "study"),
)
PAGES |= {f"pliant-{name}-all": [name, "--help-all"] for name in WITH_MORE}


@pytest.mark.parametrize("page", PAGES)
def test_help_is_as_committed(page, pliant):
    ended = pliant(*PAGES[page], env={**os.environ, "COLUMNS": "100", "NO_COLOR": "1"})
    assert ended.code == 0
    assert ended.err == ""
    path = Path(__file__).parent / "help" / f"{page}.help.txt"
    if os.environ.get("PLIANT_UPDATE_HELP"):
        path.write_text(ended.out)
    assert ended.out == path.read_text()


@pytest.mark.parametrize("name", WITH_MORE)
def test_help_is_short_and_leads_to_the_rest(name, pliant):
    short, full = (pliant(name, option).out for option in ("--help", "--help-all"))
    of_short, of_full = (
        set(re.findall(r"^ +(?:-\w,? ?(?:[A-Z]+, )?)?(--[a-z-]+)", text, re.M))
        for text in (short, full)
    )
    assert "--help-all" in of_short
    assert of_short < of_full
    assert len(of_short) <= 9


@pytest.mark.parametrize("page", [page for page in PAGES if not page.endswith("-all")])
def test_every_command_takes_help_all(page, pliant):
    assert pliant(*(word if word != "--help" else "--help-all" for word in PAGES[page])).code == 0
