# SPDX-License-Identifier: MIT
"""Puts a built site beside those of other versions, and lets readers choose among them.

Usage: .venv/bin/python docs/tools/site_versions.py FOLDER [SITE]

FOLDER, which a web server or a branch of pages serves, gets `1.0/` (major and minor version of this
Pliant), `versions.json`, which the theme reads, and an `index.html` that leads to the newest. The
layout is that of the program mike, which commits to a branch; this only writes files. SITE is
build/site, or what is given.
"""

from __future__ import annotations

import json
import shutil
import sys
from pathlib import Path

import citation

SITE = Path(__file__).resolve().parents[2] / "build" / "site"
#: in the settings of the theme, on every page: without and with a choice of versions
NONE = '"version": null'
CHOICE = '"version": {"provider": "mike"}'
LEADS = """<!doctype html>
<meta charset="utf-8">
<title>Pliant</title>
<meta http-equiv="refresh" content="0; url={name}/index.html">
<a href="{name}/index.html">Pliant {title}</a>
"""


def place(site: Path, folder: Path, version: str) -> None:
    """Adds a site to a folder of versions, in place of one of the same major and minor version.

    Raises FileNotFoundError if there is no site, ValueError if its pages offer no choice.
    """
    name = ".".join(version.split(".")[:2])
    if not (site / "index.html").is_file():
        raise FileNotFoundError(f"{site}: no index.html: ./dev docs builds the site")
    shutil.rmtree(folder / name, ignore_errors=True)
    shutil.copytree(site, folder / name)
    for page in (folder / name).rglob("*.html"):
        _let_choose(page)
    _list(folder, name, version)


def _let_choose(page: Path) -> None:
    text = page.read_text(encoding="utf-8")
    if NONE not in text:
        raise ValueError(f"{page}: no {NONE}: the theme has other settings now")
    page.write_text(text.replace(NONE, CHOICE), encoding="utf-8")


def _list(folder: Path, name: str, version: str) -> None:
    """Writes which versions there are, the newest first."""
    path = folder / "versions.json"
    rows = json.loads(path.read_text(encoding="utf-8")) if path.exists() else []
    kept = [row for row in rows if row["version"] != name]
    kept.append({"version": name, "title": version, "aliases": []})
    kept.sort(key=lambda row: [int(part) for part in row["version"].split(".")], reverse=True)
    kept = [{**row, "aliases": ["latest"] if row is kept[0] else []} for row in kept]
    path.write_text(json.dumps(kept, indent=2) + "\n", encoding="utf-8")
    newest = {"name": kept[0]["version"], "title": kept[0]["title"]}
    (folder / "index.html").write_text(LEADS.format(**newest), encoding="utf-8")


if __name__ == "__main__":
    if not 2 <= len(sys.argv) <= 3:
        sys.exit(__doc__)
    site = Path(sys.argv[2]) if len(sys.argv) == 3 else SITE
    place(site, Path(sys.argv[1]), citation.version())
    print(f"{sys.argv[1]}: Pliant {citation.version()} added")
