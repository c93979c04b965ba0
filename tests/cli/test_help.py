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
    "pliant-lab": ["lab", "--help"],
    "pliant-lab-structgen": ["lab", "structgen", "--help"],
    "pliant-lab-forcegen": ["lab", "forcegen", "--help"],
    "pliant-lab-order": ["lab", "order", "--help"],
    "pliant-study": ["study", "--help"],
    "pliant-lab-techniques": ["lab", "techniques", "--help"],
    "pliant-check": ["check", "--help"],
    "pliant-conformers": ["conformers", "--help"],
    "pliant-analyse": ["analyse", "--help"],
    "pliant-compare": ["compare", "--help"],
    "pliant-convert": ["convert", "--help"],
    "pliant-ensemble": ["ensemble", "--help"],
    "pliant-path": ["path", "--help"],
    "pliant-fit": ["fit", "--help"],
    "pliant-design": ["design", "--help"],
    "pliant-watch": ["watch", "--help"],
    "pliant-play": ["play", "--help"],
    "pliant-lab-experiment": ["lab", "experiment", "--help"],
    "pliant-lab-experiment-report": ["lab", "experiment", "report", "--help"],
    "pliant-lab-experiment-sweep": ["lab", "experiment", "sweep", "--help"],
    "pliant-lab-bench": ["lab", "bench", "--help"],
    "pliant-lab-bench-work-precision": ["lab", "bench", "work-precision", "--help"],
    "pliant-lab-bench-throughput": ["lab", "bench", "throughput", "--help"],
    "pliant-lab-bench-stress": ["lab", "bench", "stress", "--help"],
    "pliant-lab-bench-step": ["lab", "bench", "step", "--help"],
    "pliant-lab-bench-reading": ["lab", "bench", "reading", "--help"],
    "pliant-lab-bench-study": ["lab", "bench", "study", "--help"],
    "pliant-lab-bench-validity": ["lab", "bench", "validity", "--help"],
    "pliant-lab-bench-coverage": ["lab", "bench", "coverage", "--help"],
    "pliant-lab-bench-fit": ["lab", "bench", "fit", "--help"],
    "pliant-lab-bench-domains": ["lab", "bench", "domains", "--help"],
    "pliant-lab-bench-conformers": ["lab", "bench", "conformers", "--help"],
}
#: whose --help shows a part of their options
WITH_MORE = (
    *("analyse", "check", "conformers", "contacts", "design", "ensemble", "fit", "info"),
    *(
        "path",
        "rigidity",
        "run",
        "sample",
        "study",
        "lab experiment",
        "lab forcegen",
        "lab order",
        "lab structgen",
    ),
)
PAGES |= {
    f"pliant-{name.replace(' ', '-')}-all": [*name.split(), "--help-all"] for name in WITH_MORE
}


def committed(page):
    """The text of a page."""
    return Path(__file__).parent / "help" / f"{page}.help.txt"


@pytest.mark.parametrize("page", PAGES)
def test_help_is_as_committed(page, pliant):
    ended = pliant(*PAGES[page], env={**os.environ, "COLUMNS": "100", "NO_COLOR": "1"})
    assert ended.code == 0
    assert ended.err == ""
    path = committed(page)
    if os.environ.get("PLIANT_UPDATE_HELP"):
        path.write_text(ended.out)
    assert ended.out == path.read_text()


@pytest.mark.parametrize("name", WITH_MORE)
def test_help_is_short_and_leads_to_the_rest(name):
    page = f"pliant-{name.replace(' ', '-')}"
    short, full = (committed(one).read_text() for one in (page, f"{page}-all"))
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
