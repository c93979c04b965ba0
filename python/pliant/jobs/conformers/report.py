# SPDX-License-Identifier: MIT
"""What is printed of a library at the end."""

from __future__ import annotations

from collections import Counter

from pliant.base.console import counted, printable_name
from pliant.jobs.conformers.library import LibraryDone
from pliant.jobs.conformers.records import short

SALT = "molecules is kept"  #: end of the note on a salt


def lines_of(found: LibraryDone) -> list[str]:
    """Seven lines."""
    options = found.options
    given = found.source.file
    records = counted(len(found.outcomes), "record")
    rows = [
        ("input", f"{printable_name(given)}, {records}" if given else short(found.source.smiles)),
        ("molecules", _molecules(found)),
        ("conformers", _conformers(found)),
        ("drawn", _drawn(found)),
        ("energy", _energies(found)),
        ("time", _time(found)),
        ("output", printable_name(found.output)),
    ]
    if options.minimise:
        rows[3] = ("drawn", f"{rows[3][1]}; minimised: lengths and angles are the force field's")
    return [f"{name:<12}{text}" for name, text in rows]


def _molecules(found: LibraryDone) -> str:
    text = f"{len(found.done)} done, {len(found.failed)} failed"
    if found.failed:
        text += f" ({printable_name(found.failures)})"
    salts = sum(any(note.endswith(SALT) for note in one.notes) for one in found.done)
    if salts:
        text += f"; the largest component was kept of {counted(salts, 'record')} with several"
    return text


def _conformers(found: LibraryDone) -> str:
    mean = found.conformers / len(found.done)
    text = f"{found.conformers}, {mean:.1f} a molecule"
    if not found.short:
        return f"{text}: all that were asked for"
    options = found.options
    why = f"no more that differ by {options.rms:g} Å" if options.rms else "no more were drawn"
    if options.window:
        why += f" within {options.window:g} kcal/mol"
    few = f"{len(found.short)} of {counted(len(found.done), 'molecule')}"
    has = "has" if len(found.short) == 1 else "have"
    return f"{text}; {few} {has} fewer than {options.max}: {why}"


def _drawn(found: LibraryDone) -> str:
    options = found.options
    if options.starts == 1:
        return f"{options.frames} candidates a molecule, lengths and angles as given"
    return (
        f"{options.frames} candidates a molecule from {options.starts} starts, "
        "each with lengths and angles of its own"
    )


def _energies(found: LibraryDone) -> str:
    names = Counter(one.energy for one in found.done)
    if set(names) == {""}:
        return "none: as drawn, not ranked"
    if len(names) == 1:
        return next(iter(names))
    return "; ".join(f"{name}: {counted(n, 'molecule')}" for name, n in names.most_common())


def _time(found: LibraryDone) -> str:
    made = len(found.outcomes) - found.resumed
    text = f"{found.seconds:.1f} s, {made / max(found.seconds, 1e-3):.1f} molecules a second"
    if found.resumed:
        text += f"; {found.resumed} were there already"
    return text
