# SPDX-License-Identifier: MIT
"""Draws docs/pictures/bench_history.svg: what Pliant took, by data/bench_history.jsonl."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
HISTORY = HERE.parent / "data" / "bench_history.jsonl"
COLOURS = ("#0b7a75", "#d1495b", "#edae49", "#3b5b92", "#7a5195", "#6b8f23", "#8d6a4f")


def rows() -> list[dict[str, Any]]:
    """The rows of the history, oldest first."""
    return [json.loads(line) for line in HISTORY.read_text(encoding="utf-8").splitlines()]


def series(history: list[dict[str, Any]], kind: str) -> dict[str, list[float | None]]:
    """The values of each name; None where a row has none."""
    names = list(dict.fromkeys(name for row in history for name in row[kind]))
    return {name: [row[kind].get(name) for row in history] for name in names}


def draw(axes: Any, values: dict[str, list[float | None]], labels: list[str]) -> None:
    """One line for each name."""
    for (name, line), colour in zip(values.items(), COLOURS * 3, strict=False):
        axes.plot(range(len(line)), line, "o-", color=colour, label=name, markersize=4)
    axes.set_xticks(range(len(labels)), labels)
    axes.margins(x=0.1)
    axes.grid(axis="y", alpha=0.3)
    if values:
        axes.legend(fontsize=7, loc="upper left", bbox_to_anchor=(1, 1), frameon=False)
    axes.spines[["top", "right"]].set_visible(False)


def over_the_first(values: dict[str, list[float | None]]) -> dict[str, list[float | None]]:
    """Each value over the first one of its name."""
    firsts = {name: next(v for v in line if v is not None) for name, line in values.items()}
    return {
        name: [None if value is None else value / firsts[name] for value in line]
        for name, line in values.items()
    }


def make_history_picture(path: Path) -> None:
    """Both kinds of figures, one above the other."""
    import matplotlib

    matplotlib.use("svg")
    matplotlib.rcParams["svg.hashsalt"] = "pliant"
    import matplotlib.pyplot as plt

    history = rows()
    labels = [f"{row['version']}\n{row['day']}" for row in history]
    figure, (above, below) = plt.subplots(2, figsize=(8, 5.5), layout="constrained")
    draw(above, series(history, "ratios"), labels)
    above.set_yscale("log")
    above.set_title("Beside OpenMM's CCMA, 1e-6, 901 atoms", fontsize=9, loc="left")
    draw(below, over_the_first(series(history, "million_instructions")), labels)
    below.set_title("Instructions of fixed work, over the first count", fontsize=9, loc="left")
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)


if __name__ == "__main__":
    make_history_picture(HERE / "pictures" / "bench_history.svg")
