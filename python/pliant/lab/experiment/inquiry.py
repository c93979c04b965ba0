# SPDX-License-Identifier: MIT
"""Finds the modules of ``pliant.lab.experiment.questions`` and asks each its question."""

from __future__ import annotations

import importlib
import pkgutil
from pathlib import Path
from types import ModuleType

from pliant.base import console
from pliant.lab.experiment import questions
from pliant.lab.experiment.answer import Answer
from pliant.lab.experiment.choices import Choices

FOLDER = "questions"


def modules() -> list[ModuleType]:
    """The questions, in the order of their pages."""
    names = [row.name for row in pkgutil.iter_modules(questions.__path__)]
    found = [importlib.import_module(f"{questions.__name__}.{name}") for name in names]
    asking = [module for module in found if hasattr(module, "answer")]
    return sorted(asking, key=lambda module: (module.ORDER, module.__name__))


def run_questions(folder: Path, seed: int, choices: Choices) -> list[tuple[str, Answer]]:
    """(name, answer) of each; one that cannot be answered says why, and the others go on."""
    asked = modules()
    answers = []
    with choices.progress("open questions") as show:
        for done, module in enumerate(asked):
            show(done, len(asked))
            name = module.__name__.rpartition(".")[2]
            answers.append((name, _ask(module, folder / FOLDER / name, seed, choices.quick)))
    return answers


def _ask(module: ModuleType, out: Path, seed: int, quick: bool) -> Answer:
    out.mkdir(parents=True, exist_ok=True)
    try:
        found: Answer = module.answer(out, seed, quick)
        return found
    except Exception as error:  # a page that fails must not cost the others
        console.warn(f"{module.__name__}: {type(error).__name__}: {error}")
        return Answer(module.TITLE, f"not answered: {type(error).__name__}: {error}")
