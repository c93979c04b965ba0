# SPDX-License-Identifier: MIT
"""Results of the Python package whose bits are looked at: of every technique on every framework."""

from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import NamedTuple

import numpy as np
from digest import Line, lines

import pliant

ROOT = Path(__file__).resolve().parents[3]
MOLECULES = ROOT / "data/molecules"
CHOSEN = ("caffeine", "cyclohexane_chair", "alanine_dipeptide", "cyclic_hexapeptide")
WEIGHTINGS = (0.5, 0.75, 1.0)
RUNS = {
    "force": {"perturb": "force", "force": 200.0},
    "force_all": {"perturb": "force_all", "damping": 0.1},
    "displacement": {"perturb": "displacement", "displacement": 0.15},
    "mass_weighted": {"perturb": "force", "mass_weighted": True},
}
STEPS, MOST_SWEEPS = 25, 60
ALONE = "alone"  # in place of a level: walkers one after the other
WALKERS = 11  # a full group of lanes, and one that is not
OF_FRAME = tuple("step time sweeps projections max_residual rms_residual root_joint force".split())
OF_RUN = tuple(
    "steps frames unconverged_steps first_unconverged_step sweeps max_sweeps projections "
    "worst_residual worst_bar worst_step".split()
)
OF_RESOLVE = tuple(
    "sweeps projections max_residual rms_residual worst_bar dropped_bars finishing_sweeps "
    "off_nearest".split()
)
OF_GRAPH = tuple("components cycles bridges blocks largest_block bars_in_blocks is_forest".split())


class Subject:
    """A framework and positions to begin at."""

    def __init__(self, name: str, framework: pliant.Framework, positions: np.ndarray) -> None:
        self.name, self.framework = name, framework
        self.positions = np.array(positions, dtype=float)
        # RandomState draws the same numbers in every version of numpy.
        shape = (WALKERS, *self.positions.shape)
        self._moves = np.random.RandomState(1).random_sample(shape) * 2 - 1
        if framework.is_planar:
            self._moves[:, :, 2] = 0

    @property
    def roots(self) -> tuple[int, int]:
        """A joint in the middle, and the last."""
        return len(self.positions) // 2, max(0, len(self.positions) - 1)

    def pushed(self, walker: int, size: float = 0.1) -> np.ndarray:
        """Each coordinate moved by at most `size`; of a plane, within it."""
        return self.positions + size * self._moves[walker]

    def walkers(self) -> np.ndarray:
        """All pushed but one that is where it was, and one that is far."""
        sizes = np.full(WALKERS, 0.1)
        sizes[4], sizes[9] = 0.0, 2.0
        return self.positions + sizes[:, None, None] * self._moves


class Way(NamedTuple):
    """A technique with a weighting."""

    name: str
    options: dict


def molecule(name: str) -> Path:
    """A file of data/molecules."""
    (path,) = MOLECULES.glob(f"{name}.*")
    return path


def subjects() -> Iterator[Subject]:
    """Every named example, and a few molecules with bars of bonds and of angles."""
    for example in pliant.examples():
        yield Subject(example.name, example.framework, np.array(example.positions, dtype=float))
    for name in CHOSEN:
        structure = pliant.read(molecule(name))
        for bars in ("bonds", "angles"):
            yield Subject(f"{name}_{bars}", structure.framework(bars), structure.positions)


def ways() -> Iterator[Way]:
    """Every technique with every weighting that it takes."""
    for row in pliant.techniques():
        for weighting in WEIGHTINGS if row.has_weighting else (None,):
            options = {"technique": row.name, "weighting": 0.5 if weighting is None else weighting}
            yield Way(row.name if weighting is None else f"{row.name}_{weighting:g}", options)


def values(thing: object, names: tuple[str, ...]) -> list:
    """Members of an object by their names."""
    return [getattr(thing, name) for name in names]


def numbers_of(thing: object, names: tuple[str, ...]) -> tuple:
    """Members that are numbers, and why it ended."""
    return (thing.stop.name, *(getattr(thing, name) for name in names))


def run(subject: Subject, **options) -> dict[str, object]:
    """Every frame of a short run."""
    positions, numbers = [], []

    def look(frame: pliant.Frame) -> None:
        positions.append(frame.positions.copy())
        numbers.append(numbers_of(frame, OF_FRAME))

    options = {"steps": STEPS, "max_sweeps": MOST_SWEEPS, "seed": 7, "walker": 3} | options
    done = pliant.run(subject.framework, subject.positions, observers=[look], **options)
    return {
        "positions": [*positions, done.state.positions, done.state.previous],
        "numbers": [tuple(numbers), *values(done, OF_RUN)],
    }


def replay(subject: Subject) -> dict[str, object]:
    """A run by the pushes of a force file."""
    file = pliant.make_force_file(subject.framework, STEPS, force=200.0, seed=3)
    moved = run(subject, replay=file.pushes, tolerance_length=1e-5, technique="bfs_cycle")
    return {"file": file.text(subject.framework)} | moved


def by_ordering(subject: Subject) -> dict[str, object]:
    """A run that visits the bars in a sequence of our own."""
    ordering = pliant.order(subject.framework, "bfs_cycle", subject.roots[0])
    backwards = [column[::-1].copy() for column in ordering]
    return run(subject, technique="input", ordering=backwards, perturb="displacement")


def resolve(subject: Subject, way: Way, mass_weighted: bool) -> dict[str, object]:
    """Resolves one after the other: near, given the positions before the push, and far."""
    options = {"tolerance": 1e-9, "max_sweeps": MOST_SWEEPS, "seed": 5, "walker": 2}
    resolver = pliant.Resolver(
        subject.framework, **way.options, mass_weighted=mass_weighted, **options
    )
    positions, numbers = [], []
    middle, last = subject.roots
    jobs = ((0.1, 0, None), (0.1, last, subject.positions), (2.0, middle, None))
    for step, (size, root, reference) in enumerate(jobs):
        positions.append(subject.pushed(step, size))
        done = resolver.resolve(positions[-1], root, step=step, reference=reference)
        numbers.append(numbers_of(done, OF_RESOLVE))
    return {"positions": positions, "numbers": tuple(numbers)}


def lanes(subject: Subject, way: Way, level: str) -> dict[str, object]:
    """Walkers resolved together; then fewer of them, with less given."""
    lanes = {"lanes": level != ALONE, "level": "" if level == ALONE else level}
    limits = {"tolerance": 1e-6, "max_sweeps": MOST_SWEEPS, "seed": 5}
    resolver = pliant.WalkerResolver(subject.framework, **way.options, **limits, **lanes)
    jobs = (
        (WALKERS, {"root": subject.roots[1], "measured": "rms_residual"}),
        (8, {"reference": subject.positions}),
        (3, {"root": subject.roots[0], "measured": "nothing"}),
    )
    positions, numbers = [], []
    for step, (count, options) in enumerate(jobs):
        positions.append(subject.walkers()[:count].copy())
        done = resolver.resolve(positions[-1], step=step, first_walker=7, **options)
        numbers.append(tuple(numbers_of(summary, OF_RESOLVE) for summary in done))
    return {"positions": positions, "numbers": [resolver.level, *numbers]}


def graph(subject: Subject) -> dict[str, object]:
    """What a framework is, before anything moves."""
    framework, pushed = subject.framework, subject.pushed(1)
    measured = pliant.measure_bars(framework, pushed)
    columns = ("bars", "rest_lengths", "inverse_masses", "pinned", "merged_bar_count")
    return {
        "framework": values(framework, columns),
        "graph": [framework.components(), framework.blocks(), framework.bridges(),
                  values(framework.graph_facts(), OF_GRAPH)],
        "measured": [pliant.residuals(framework, pushed), measured.max_relative,
                     measured.rms_relative, measured.max_length, measured.worst_bar],
        "choice": [pliant.choose_technique(framework, mass_weighted=m) for m in (False, True)],
    }  # fmt: skip  # a table: a row a line


def order(subject: Subject, ordering: str) -> dict[str, object]:
    """Bars in sequence, from two joints."""
    return {
        "sequences": [
            list(pliant.order(subject.framework, ordering, root, seed=5, walker=2, step=k))
            for k, root in enumerate(subject.roots)
        ]
    }


def read(path: Path) -> dict[str, object]:
    """A molecule's atoms and bonds, and the bars made of them."""
    structure = pliant.read(path)
    columns = tuple(
        "positions names elements residue_of residue_ids residue_names chains bonds "
        "bond_orders bond_origins masses".split()
    )
    kinds = (("bonds", "geometry"), ("bonds", "table"), ("angles", "geometry"))
    made = [structure.framework(bars, lengths) for bars, lengths in kinds]
    return {
        "structure": values(structure, columns),
        "frameworks": [values(framework, ("bars", "rest_lengths")) for framework in made],
    }


def moving_lines(subject: Subject, way: Way) -> Iterator[Line]:
    """All that one technique does with one framework."""
    name = f"{way.name} {subject.name}"
    for kind, options in RUNS.items():
        yield from lines(f"run {kind} {name}", partial(run, subject, **way.options, **options))
    yield from lines(f"resolve {name}", partial(resolve, subject, way, False))
    yield from lines(f"resolve_mass_weighted {name}", partial(resolve, subject, way, True))
    for level in (*pliant.lane_levels(), ALONE):
        yield from lines(f"lanes {level} {name}", partial(lanes, subject, way, level))


def library_lines() -> Iterator[Line]:
    """All lines of the package."""
    all_ways = list(ways())
    for subject in subjects():
        yield from lines(f"framework {subject.name}", partial(graph, subject))
        yield from lines(f"ordering {subject.name}", partial(by_ordering, subject))
        yield from lines(f"replay {subject.name}", partial(replay, subject))
        for row in pliant.orderings():
            yield from lines(f"order {row.name} {subject.name}", partial(order, subject, row.name))
        for way in all_ways:
            yield from moving_lines(subject, way)
    for path in sorted(MOLECULES.iterdir()):
        yield from lines(f"read {path.name}", partial(read, path))
