# SPDX-License-Identifier: MIT
"""What MkDocs calls while it builds the site.

Pages of the repository become pages of the site, notebooks are run, headers are listed, formulas
become MathML. Links are written as the repository needs them, and rewritten here.
"""

from __future__ import annotations

import re
from pathlib import Path

import formulas
import headers
import help_texts
import notebooks
import package
import phone
import places
from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files
from mkdocs.structure.pages import Page

CITATION = Path(__file__).resolve().parents[2] / "CITATION.cff"


def on_startup(command: str, dirty: bool) -> None:
    """Makes the package that the reference is read from, before plugins look for its folder."""
    package.make()


def on_config(config: MkDocsConfig) -> MkDocsConfig:
    """Names the version on every page, at its foot."""
    version = re.search(r"^version: (.+)$", CITATION.read_text(encoding="utf-8"), re.MULTILINE)
    config.copyright = f"Pliant {version[1]} · MIT licence"
    return config


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """Adds what is not in docs/pages."""

    def add(name: str, content: str | bytes) -> None:
        files.append(File.generated(config, name, content=content))

    for source, name in places.included():
        add(name, source.read_bytes())
    add("help.md", help_texts.page())
    for name, text in headers.pages():
        add(name, text)
    for notebook in places.notebooks():
        text, pictures = notebooks.as_page(notebook)
        add(places.site_name(notebook), text)
        for name, content in pictures.items():
            add(f"notebooks/{name}", content)
    return files


def on_page_markdown(markdown: str, page: Page, config: MkDocsConfig, files: Files) -> str:
    """Leads links to where the site has what they name."""
    return places.with_links_of_the_site(markdown, page.file.src_uri)


def on_page_content(html: str, page: Page, config: MkDocsConfig, files: Files) -> str:
    """Turns formulas into MathML, which browsers draw by themselves; fits the page to a phone."""
    return phone.fitted(formulas.with_mathml(html))


def on_post_build(config: MkDocsConfig) -> None:
    """Lets search work where pages are opened from the disk: as a script it may be read there.

    And takes out what only a site of a known address can use.
    """
    index = Path(config.site_dir) / "search" / "search_index.json"
    (Path(config.site_dir) / "404.html").unlink()  # needs to know the address of the site
    script = f"var __index = {index.read_text(encoding='utf-8')}"
    index.with_suffix(".js").write_text(script, encoding="utf-8")
