"""Compiled part of Pliant; use the names that the package pliant gives."""

from collections.abc import Sequence
import enum
import os
import pathlib
from typing import Annotated

import numpy
import numpy.typing
from numpy.typing import NDArray


def version() -> str:
    """Version of the library."""

class Error(Exception):
    """Anything that Pliant raises by itself."""

class InputError(Error, ValueError):
    """
    The input is wrong: the message names file, line and field, what was expected and found.
    """

class OptionError(Error, ValueError):
    """An option is out of its range or names no known choice."""

class FileError(Error, OSError):
    """
    A file could not be opened, read or written; the message ends with the system's reason.
    """

class PliantWarning(UserWarning):
    """
    A guess was made or something was left out; see the warnings module for what to do with it.
    """

class GraphFacts:
    """What is known of the graph under a framework."""

    @property
    def joints(self) -> int:
        """Number of joints."""

    @property
    def bars(self) -> int:
        """Number of bars."""

    @property
    def components(self) -> int:
        """Number of connected components."""

    @property
    def cycles(self) -> int:
        """Number of independent cycles: bars - joints + components."""

    @property
    def bridges(self) -> int:
        """Number of bars that are on no cycle."""

    @property
    def blocks(self) -> int:
        """Number of blocks of two or more bars: rings and ring systems."""

    @property
    def largest_block(self) -> int:
        """Bars in the largest of them."""

    @property
    def bars_in_blocks(self) -> int:
        """Number of bars on some cycle."""

    @property
    def is_forest(self) -> bool:
        """True if there is no cycle."""

    def __repr__(self) -> str: ...

class Framework:
    """
    Joints joined by bars of fixed rest length; never changes.

    Parameters
    ----------
    bars : (B, 2) integers
        The two joints of each bar, from 0.
    rest_lengths : (B,) Angstrom, optional
        Default: the distances at ``positions``.
    joint_count : int, optional
        Default: the number of ``positions``, else one more than the largest joint in ``bars``.
    positions : (N, 3) Angstrom, optional
        Only looked at for ``joint_count`` and ``rest_lengths``; not kept.
    masses : (N,) u, optional
        Default: 1 each.
    pinned : joints or (N,) truth values, optional
        Joints that never move.
    names : N strings, optional
        What messages call the joints.
    structure : Structure, optional
        Whose atoms the joints are: messages and files call them so.

    Raises
    ------
    InputError
        A bar joins a joint to itself, names an unknown joint, has a length out of range (1e-150 to
        1e150), or is given twice with different lengths; shapes do not fit. Equal duplicates are merged.
    TypeError
        An argument is no array of numbers (of integers, for ``bars``).
    """

    def __init__(self, bars: numpy.typing.ArrayLike, rest_lengths: numpy.typing.ArrayLike | None = None, joint_count: int | None = None, *, positions: numpy.typing.ArrayLike | None = None, masses: numpy.typing.ArrayLike | None = None, pinned: numpy.typing.ArrayLike | None = None, names: Sequence[str] | None = None, structure: Structure | None = None) -> None: ...

    @property
    def joint_count(self) -> int:
        """Number N of joints."""

    @property
    def bar_count(self) -> int:
        """Number B of bars."""

    @property
    def bars(self) -> Annotated[NDArray[numpy.uint32], dict(shape=(None, 2), order='C', writable=False)]:
        """(B, 2) uint32, read-only view: the joints of each bar."""

    @property
    def rest_lengths(self) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', writable=False)]:
        """(B,) float64, read-only view: rest lengths in Angstrom."""

    @property
    def inverse_masses(self) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', writable=False)]:
        """(N,) float64, read-only view: 1/u, 0 for a pinned joint."""

    @property
    def pinned(self) -> Annotated[NDArray[numpy.uint32], dict(shape=(None,), order='C')]:
        """uint32 indices of the joints that never move, ascending."""

    @property
    def merged_bar_count(self) -> int:
        """How many bars were given twice and merged."""

    def label(self, joint: int) -> str:
        """What messages call a joint: "A:LYS12:CA", or "joint 7"."""

    def bar_label(self, bar: int) -> str:
        """What messages call a bar: "CA - CB"."""

    def __repr__(self) -> str: ...

    def graph_facts(self) -> GraphFacts:
        """
        Counts of components, independent cycles, bridges and blocks; linear in time.
        """

    def components(self) -> Annotated[NDArray[numpy.uint32], dict(shape=(None,), order='C')]:
        """
        (N,) uint32: the connected component of each joint, numbered by their lowest joint.
        """

    def blocks(self) -> Annotated[NDArray[numpy.uint32], dict(shape=(None,), order='C')]:
        """
        (B,) uint32: the block (biconnected component) of each bar; a bridge is one alone.

        Hopcroft and Tarjan, Commun. ACM 16 (1973) 372.
        """

    def bridges(self) -> Annotated[NDArray[numpy.bool_], dict(shape=(None,), order='C')]:
        """(B,) bool: whether each bar is a bridge, that is on no cycle."""

class State:
    """
    What changes during a run: positions, and those of one step earlier.

    Both (N, 3) arrays are writeable views of the memory that runs work on. While a run
    goes on in another thread their contents change; their number never does.
    """

    def __init__(self, positions: numpy.typing.ArrayLike) -> None:
        """At rest at a copy of ``positions``, (N, 3) Angstrom."""

    @property
    def positions(self) -> Annotated[NDArray[numpy.float64], dict(shape=(None, 3), order='C')]:
        """(N, 3) float64 view, Angstrom. Assigning copies into the same memory."""

    @positions.setter
    def positions(self, arg: numpy.typing.ArrayLike, /) -> None: ...

    @property
    def previous(self) -> Annotated[NDArray[numpy.float64], dict(shape=(None, 3), order='C')]:
        """(N, 3) float64 view, Angstrom: positions one step earlier, for Verlet."""

    @previous.setter
    def previous(self, arg: numpy.typing.ArrayLike, /) -> None: ...

    @property
    def step(self) -> int:
        """Steps done."""

    @step.setter
    def step(self, arg: int, /) -> None: ...

    @property
    def time(self) -> float:
        """ps."""

    @time.setter
    def time(self, arg: float, /) -> None: ...

    def __repr__(self) -> str: ...

class ResidualSummary:
    """How far a framework is from its rest lengths."""

    @property
    def max_relative(self) -> float:
        """Largest |length - rest| / rest."""

    @property
    def rms_relative(self) -> float:
        """Root of the mean of its square."""

    @property
    def max_length(self) -> float:
        """Largest |length - rest| in Angstrom."""

    @property
    def worst_bar(self) -> int:
        """The bar of max_relative."""

    @property
    def within(self) -> bool:
        """Every bar is within the tolerance."""

    @property
    def finite(self) -> bool:
        """Every length is a finite number."""

def measure(framework: Framework, positions: numpy.typing.ArrayLike, *, tolerance: float = 1e-06, tolerance_length: float | None = None) -> ResidualSummary:
    """
    Measures all bars at ``positions``, (N, 3) Angstrom, which need not be finite.
    """

def residuals(framework: Framework, positions: numpy.typing.ArrayLike) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C')]:
    """
    (B,) float64: length - rest of each bar at ``positions``, (N, 3); both in Angstrom.
    """

class Stop(enum.Enum):
    """Why a resolve ended."""

    converged = 0
    """Every bar is within the tolerance."""

    max_sweeps = 1
    """The limit was reached first."""

    not_finite = 2
    """A length became infinite or not a number; positions were put back."""

    stopped_by_caller = 3
    """The caller asked to stop."""

class Frame:
    """
    One step's result, as observers see it.

    ``positions`` is a view of the state that the run goes on to change:
    copy what is to be kept. A frame that you make yourself, for a recorder,
    holds a copy.
    """

    def __init__(self, step: int, time: float, positions: numpy.typing.ArrayLike, *, sweeps: int = 0, projections: int = 0, max_residual: float = 0.0, rms_residual: float = 0.0, stop: Stop = Stop.converged, root_joint: int | None = None, force: tuple[float, float, float] = (0.0, 0.0, 0.0)) -> None: ...

    @property
    def step(self) -> int:
        """Steps done."""

    @property
    def time(self) -> float:
        """ps."""

    @property
    def positions(self) -> Annotated[NDArray[numpy.float64], dict(shape=(None, 3), order='C', writable=False)]:
        """(N, 3) float64, read-only view, Angstrom."""

    @property
    def sweeps(self) -> int:
        """Sweeps of this step."""

    @property
    def projections(self) -> int:
        """Bars looked at in this step."""

    @property
    def max_residual(self) -> float:
        """Largest |length - rest| / rest."""

    @property
    def rms_residual(self) -> float:
        """Root of the mean of its square."""

    @property
    def stop(self) -> Stop:
        """Why resolving ended."""

    @property
    def converged(self) -> bool:
        """Every bar is within the tolerance."""

    @property
    def root_joint(self) -> int | None:
        """The joint where the technique began; None before any step."""

    @property
    def force(self) -> tuple[float, float, float]:
        """The force on it, kJ/(mol Angstrom)."""

class Format:
    """One row of the table of formats."""

    @property
    def name(self) -> str:
        """What options call it."""

    @property
    def summary(self) -> str:
        """What it does, in one line."""

    def __repr__(self) -> str: ...

    @property
    def extensions(self) -> list[str]:
        """File name extensions: ".pdb"."""

def formats() -> list[Format]:
    """The table of formats that ``read`` knows."""

class Structure:
    """
    Atoms with names, elements, residues and positions, and their bonds.

    Made by ``read``, by the adapters, or from columns:

    Parameters
    ----------
    positions : (N, 3) Angstrom
    elements : (N,) atomic numbers or symbols, optional
        0 or "" where it is not known, which is the default.
    names : N strings, optional
        Default: the symbols.
    residue_names, residue_ids, insertion_codes, chains : N each, optional
        Default: "UNK", 1, "", "". Consecutive atoms that agree in all of them make a residue.
    serials : (N,) integers, optional
        Default: 1 to N.
    bonds : (M, 2) integers, optional
        Pairs of atoms, from 0.
    bond_orders : (M,) integers, optional
        1, 2, 3; 4 for aromatic; 0 not known.
    title : str

    Raises
    ------
    InputError
        Lengths that differ, an unknown element, a bond to an unknown atom or of an atom to itself,
        a position that is not finite.
    """

    def __init__(self, positions: numpy.typing.ArrayLike, *, elements: numpy.typing.ArrayLike | None = None, names: Sequence[str] | None = None, residue_names: Sequence[str] | None = None, residue_ids: numpy.typing.ArrayLike | None = None, insertion_codes: Sequence[str] | None = None, chains: Sequence[str] | None = None, serials: numpy.typing.ArrayLike | None = None, bonds: numpy.typing.ArrayLike | None = None, bond_orders: numpy.typing.ArrayLike | None = None, title: str = '') -> None: ...

    @property
    def positions(self) -> Annotated[NDArray[numpy.float64], dict(shape=(None, 3), order='C')]:
        """(N, 3) float64 view, Angstrom. Assigning copies into the same memory."""

    @positions.setter
    def positions(self, arg: numpy.typing.ArrayLike, /) -> None: ...

    @property
    def title(self) -> str:
        """The file's own title."""

    @property
    def source(self) -> str:
        """Name of the file it was read from."""

    @property
    def format(self) -> str:
        """Name of the file's format."""

    @property
    def model(self) -> int:
        """Which model or frame this is, from 1."""

    @property
    def model_count(self) -> int:
        """Models or frames in the file."""

    def label(self, atom: int) -> str:
        """What messages call an atom: "A:LYS12:CA"."""

    def __len__(self) -> int: ...

    def __repr__(self) -> str: ...

    @property
    def names(self) -> numpy.typing.NDArray[numpy.str_]:
        """(N,) atom names."""

    @property
    def symbols(self) -> numpy.typing.NDArray[numpy.str_]:
        """(N,) symbols of the elements; "X" where the element is not known."""

    @property
    def elements(self) -> Annotated[NDArray[numpy.uint8], dict(shape=(None,), order='C', writable=False)]:
        """
        (N,) uint8, read-only view: atomic numbers; 0 where the element is not known.
        """

    @property
    def serials(self) -> Annotated[NDArray[numpy.int64], dict(shape=(None,), order='C', writable=False)]:
        """(N,) int64, read-only view: the number that the file gives each atom."""

    @property
    def masses(self) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C')]:
        """(N,) float64: masses of the elements in u."""

    @property
    def residue_of(self) -> Annotated[NDArray[numpy.uint32], dict(shape=(None,), order='C', writable=False)]:
        """(N,) uint32, read-only view: the residue of each atom, from 0."""

    @property
    def residue_count(self) -> int:
        """Number of residues."""

    @property
    def residue_ids(self) -> Annotated[NDArray[numpy.int64], dict(shape=(None,), order='C')]:
        """(N,) int64: the number of each atom's residue."""

    @property
    def residue_names(self) -> numpy.typing.NDArray[numpy.str_]:
        """(N,) the name of each atom's residue."""

    @property
    def insertion_codes(self) -> numpy.typing.NDArray[numpy.str_]:
        """(N,) the insertion code of each atom's residue; "" for none."""

    @property
    def chains(self) -> numpy.typing.NDArray[numpy.str_]:
        """(N,) the chain of each atom's residue; "" for none."""

    @property
    def bonds(self) -> Annotated[NDArray[numpy.uint32], dict(shape=(None, 2), order='C')]:
        """(M, 2) uint32: bonded atoms, sorted; a copy."""

    @property
    def bond_orders(self) -> Annotated[NDArray[numpy.uint8], dict(shape=(None,), order='C')]:
        """(M,) uint8: 1, 2, 3; 4 for aromatic; 0 where the order is not known."""

    @property
    def bond_origins(self) -> numpy.typing.NDArray[numpy.str_]:
        """
        (M,) where each bond is known from: "file", "residue", "link" or "distance".
        """

    def perceive_bonds(self, *, slack: float = 0.45, shortest: float = 0.4, guess_distances: bool = True) -> None:
        """
        Adds the bonds that residue templates, links and distances tell; bonds that are there stay.

        slack: Angstrom added to the sum of two covalent radii (Cordero et al.,
        Dalton Trans. 2008, 2832); shortest: closer atoms are not bonded.
        """

    def framework(self, bars: str = 'bonds', lengths: str = 'geometry', pin: str = '', *, use_masses: bool = True) -> Framework:
        """
        The framework whose joints are the atoms.

        Parameters
        ----------
        bars : str
            ``bonds``: a bar for each bond; ``angles``: and for each pair of atoms bonded to one atom.
        lengths : str
            ``geometry``: the distances at ``positions``; ``table``: standard lengths by elements and order.
        pin : str
            Selection of atoms that never move, in the words of MDAnalysis: ``"resid 3-8 and name CA"``.
        use_masses : bool
            Give joints the masses of their atoms.

        Raises
        ------
        InputError
            A bar would have no length.
        OptionError
            An unknown choice, or a selection that cannot be understood.
        """

def read(path: str | os.PathLike, model: int = 1, format: str | None = None, *, perceive_bonds: bool = True) -> Structure:
    """
    Reads one model of a molecule file: PDB, mmCIF, XYZ, SDF, also gzipped.

    Parameters
    ----------
    path : str or path
    model : int
        Which model, frame or record, from 1.
    format : str, optional
        A name in ``formats()``; default: by extension, then by content.
    perceive_bonds : bool
        Add bonds that the file does not state: residue templates, links, distances.

    Raises
    ------
    InputError
        Names file, line and field, what was expected and what was found.
    FileError
        The file cannot be read.
    OptionError
        No such format or model.

    Warns
    -----
    PliantWarning
        For each kind of guess, once. What is as it should be goes to the logger ``pliant``.
    """

def read_text(text: str, name: str = 'text', model: int = 1, format: str | None = None, *, perceive_bonds: bool = True) -> Structure:
    """
    The same for text in memory; ``name`` stands in messages and gives the extension.
    """

class Repeat(enum.Enum):
    """What happens after the first sweep of a resolve."""

    same = 0
    """The same ordering in each sweep."""

    reverse = 1
    """Backwards, forwards, backwards, ..."""

    reorder = 2
    """The ordering is asked again before each sweep."""

class OrderingEntry:
    """One row of the table of orderings."""

    @property
    def name(self) -> str:
        """What options call it."""

    @property
    def summary(self) -> str:
        """What it does, in one line."""

    def __repr__(self) -> str: ...

    @property
    def repeat(self) -> Repeat:
        """What happens after the first sweep."""

    @property
    def forests_only(self) -> bool:
        """
        Leaves bars out that close a cycle, so that only forests are resolved by it.
        """

def orderings() -> list[OrderingEntry]:
    """
    The table of orderings: those of the thesis "Motion Simulation of Geometric
    Constraint Structures", chapter 5, and ``input``.
    """

def order(framework: Framework, ordering: str = 'bfs_cycle', root: int = 0, *, seed: int = 0, walker: int = 0, step: int = 0) -> tuple[numpy.typing.NDArray[numpy.uint32], numpy.typing.NDArray[numpy.uint32], numpy.typing.NDArray[numpy.bool_]]:
    """
    The bars in the sequence in which a first sweep from ``root`` visits them.

    Returns (bar, near, is_tree), each (K,): the index of the bar, the joint from which
    it is looked at, and False where it closes a cycle of the traversal.
    """

class ResolveSummary:
    """What a resolve did."""

    @property
    def stop(self) -> Stop:
        """Why it ended."""

    @property
    def converged(self) -> bool:
        """Every bar is within the tolerance."""

    @property
    def sweeps(self) -> int:
        """Passes over the ordering in one direction."""

    @property
    def projections(self) -> int:
        """Bars looked at, summed over the sweeps."""

    @property
    def max_residual(self) -> float:
        """Largest |length - rest| / rest at the end."""

    @property
    def rms_residual(self) -> float:
        """Its root mean square at the end."""

    @property
    def worst_bar(self) -> int:
        """The bar of max_residual."""

    @property
    def seconds(self) -> float:
        """Wall time."""

    def brief(self, framework: Framework) -> str:
        """The summary as one line of text."""

    def __repr__(self) -> str: ...

class TechniqueEntry:
    """One row of the table of techniques: every ordering is one."""

    @property
    def name(self) -> str:
        """What options call it."""

    @property
    def summary(self) -> str:
        """What it does, in one line."""

    def __repr__(self) -> str: ...

    @property
    def forests_only(self) -> bool:
        """
        Leaves bars out that close a cycle, so that only forests are resolved by it.
        """

    @property
    def has_weighting(self) -> bool:
        """``weighting`` means something."""

def techniques() -> list[TechniqueEntry]:
    """The table of techniques: orderings and direct methods."""

class Resolver:
    """
    Resolves again and again with one technique on one framework.

    Keeps its plan and memory between calls. Threads that share one wait for each other. Parameters are those of ``resolve``.
    """

    def __init__(self, framework: Framework, technique: str = 'bfs_cycle', weighting: float = 0.5, *, mass_weighted: bool = False, tolerance: float = 1e-06, tolerance_length: float | None = None, max_sweeps: int = 10000, seed: int = 0, walker: int = 0) -> None: ...

    def resolve(self, positions: numpy.typing.NDArray[numpy.float64], root: int = 0, *, step: int = 0) -> ResolveSummary:
        """Moves ``positions`` in place, as the function ``resolve`` does."""

def resolve(framework: Framework, positions: numpy.typing.NDArray[numpy.float64], technique: str = 'bfs_cycle', weighting: float = 0.5, *, mass_weighted: bool = False, tolerance: float = 1e-06, tolerance_length: float | None = None, max_sweeps: int = 10000, seed: int = 0, walker: int = 0, root: int = 0, step: int = 0) -> ResolveSummary:
    """
    Moves ``positions`` in place until every bar has its rest length within the tolerance.

    Nonlinear Gauss-Seidel (SHAKE-like): sweeps of one-bar projections in the sequence of an ordering
    (Jakobsen, "Advanced character physics", GDC 2001; thesis "Motion Simulation of Geometric Constraint
    Structures"), or a direct method. Not converging is an outcome: look at ``stop`` or ``converged`` of
    what is returned. Other Python threads run meanwhile; Ctrl-C ends the call after a sweep.

    Parameters
    ----------
    framework : Framework
    positions : (N, 3) float64, Angstrom
        C-contiguous and writeable; this very memory is changed. If a length stops being finite it is
        put back as it was.
    technique : str
        A name in ``techniques()``.
    weighting : float
        Share of a correction that the far joint of a tree bar takes, 0 to 1; the near joint takes the
        rest. Bars that close a cycle are shared half and half.
    mass_weighted : bool
        Multiply shares by inverse masses.
    tolerance : float
        Largest |length - rest| / rest of a whole bar.
    tolerance_length : float, optional
        Largest |length - rest| in Angstrom, in place of ``tolerance``.
    max_sweeps : int
        Give up after so many.
    seed, walker : int
        What random orderings and the parting of coincident joints depend on.
    root : int
        The joint where the ordering begins.
    step : int
        Another number that random draws depend on.

    Raises
    ------
    TypeError
        ``positions`` is no such array.
    OptionError
        An option is out of range, or the technique leaves bars of this framework out.
    IndexError
        ``root`` is no joint.
    """

class PerturbationEntry:
    """One row of the table of perturbations."""

    @property
    def name(self) -> str:
        """What options call it."""

    @property
    def summary(self) -> str:
        """What it does, in one line."""

    def __repr__(self) -> str: ...

def perturbations() -> list[PerturbationEntry]:
    """
    The table of perturbations: what breaks the bars at the start of a step.
    """

class ForceFile:
    """Pushes to be replayed, and the settings that they were made for."""

    def __init__(self) -> None: ...

    @property
    def timestep(self) -> float | None:
        """ps; None where the file does not say."""

    @timestep.setter
    def timestep(self, arg: float | None, /) -> None: ...

    @property
    def tolerance(self) -> float | None:
        """Relative; None where the file does not say."""

    @tolerance.setter
    def tolerance(self, arg: float | None, /) -> None: ...

    @property
    def tolerance_length(self) -> float | None:
        """Angstrom; None where the file does not say."""

    @tolerance_length.setter
    def tolerance_length(self, arg: float | None, /) -> None: ...

    @property
    def max_sweeps(self) -> int | None:
        """None where the file does not say."""

    @max_sweeps.setter
    def max_sweeps(self, arg: int | None, /) -> None: ...

    @property
    def pushes(self) -> list[tuple[int, tuple[float, float, float]]]:
        """(joint, (x, y, z)) in kJ/(mol Angstrom), one a step."""

    @pushes.setter
    def pushes(self, arg: Sequence[tuple[int, tuple[float, float, float]]], /) -> None: ...

    def text(self, framework: Framework) -> str:
        """The file's text, which reads back to the same bits."""

def read_force_file(path: str | os.PathLike, framework: Framework) -> ForceFile:
    """
    Reads a force file; joints are named as the framework names them, or by index.
    """

class H5mdReader:
    """
    An H5MD file, ours or another program's, which may still be written.

    ``group`` is a name below /particles; default: "trajectory", else the first with
    positions. Raises FileError when HDF5 cannot read, InputError when what was read makes no
    sense; both name the file and the path within it.
    """

    def __init__(self, path: str | os.PathLike, *, group: str = '') -> None: ...

    def __len__(self) -> int: ...

    @property
    def joint_count(self) -> int:
        """Number N of joints."""

    def positions(self, frame: int) -> Annotated[NDArray[numpy.float64], dict(shape=(None, 3), order='C')]:
        """
        (N, 3) float64, Angstrom: a new array. Negative frames count from the end.
        """

    def step(self, frame: int) -> int:
        """The step of a frame."""

    def time(self, frame: int) -> float:
        """The time of a frame in ps."""

    @property
    def observables(self) -> list[str]:
        """Names of what is recorded once a frame as a number, sorted."""

    def observable(self, name: str) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C')]:
        """(F,) float64: one number a frame; truth values are 0 and 1."""

    def parameters(self) -> dict[str, bool | int | float | str]:
        """What stands below /parameters, by path: every option of the run."""

    def framework(self) -> Framework:
        """The framework that was recorded."""

    def structure(self, frame: int = 0) -> Structure:
        """The atoms and bonds that were recorded, at the positions of a frame."""

class H5mdRecorder:
    """
    Writes frames to an H5MD 1.1 file (de Buyl, Colberg, Hoefling, Comput. Phys. Commun. 185 (2014) 1546).

    The file opens in MDAnalysis, h5py and every other HDF5 program, while it is written and after its
    writer was killed, with every frame committed until then. An observer of ``run``, and a context
    manager that closes itself.

    Parameters
    ----------
    path : str or path
        Appears when it is complete but for the frames.
    framework : Framework
        Its bars, rest lengths and atom names are recorded.
    structure : Structure, optional
        Its bonds and masses are recorded too.
    parameters : dict of str to bool, int, float or str
        Values below /parameters, by path: ``{"run/seed": 5}``.
    single : bool
        Positions as 32-bit floats.
    compress : bool
        Shuffle and gzip positions.
    overwrite : bool
        Replace an existing file.
    flush_seconds : float
        Frames are committed this often; 0: each frame.

    Raises
    ------
    FileError
        The file exists, cannot be written, or is being written by another recorder.
    OptionError
        A bad option or path of a parameter.
    """

    def __init__(self, path: str | os.PathLike, framework: Framework, *, structure: Structure | None = None, parameters: dict = {}, single: bool = False, compress: bool = False, overwrite: bool = False, flush_seconds: float = 1.0) -> None: ...

    def record(self, frame: Frame) -> None:
        """
        Adds a frame, which must come after the last one and have finite positions.
        """

    def __call__(self, frame: Frame) -> None:
        """The same, so that it is an observer."""

    def flush(self) -> None:
        """Commits what was recorded: it survives this process."""

    def close(self) -> None:
        """Commits and closes; further calls do nothing."""

    @property
    def frames(self) -> int:
        """Frames recorded."""

    @property
    def committed_frames(self) -> int:
        """Frames recorded and certain to be in the file."""

    @property
    def path(self) -> pathlib.Path:
        """Where the file is."""

    def __enter__(self) -> H5mdRecorder: ...

    def __exit__(self, *exception: object) -> None: ...

class RunOptions:
    """What a run does; checked at its start."""

    def __init__(self) -> None: ...

    def check(self) -> None:
        """Raises OptionError naming the option, its value and its range."""

    @property
    def perturb(self) -> str:
        """A name in ``perturbations()``."""

    @perturb.setter
    def perturb(self, arg: str, /) -> None: ...

    @property
    def steps(self) -> int:
        """Steps to do."""

    @steps.setter
    def steps(self, arg: int, /) -> None: ...

    @property
    def every(self) -> int:
        """Show every so many steps, and step 0."""

    @every.setter
    def every(self, arg: int, /) -> None: ...

    @property
    def technique(self) -> str:
        """A name in ``techniques()``."""

    @technique.setter
    def technique(self, arg: str, /) -> None: ...

    @property
    def weighting(self) -> float:
        """Share of a correction that the far joint of a tree bar takes."""

    @weighting.setter
    def weighting(self, arg: float, /) -> None: ...

    @property
    def mass_weighted(self) -> bool:
        """Multiply shares by inverse masses."""

    @mass_weighted.setter
    def mass_weighted(self, arg: bool, /) -> None: ...

    @property
    def max_sweeps(self) -> int:
        """Sweeps after which a step is given up."""

    @max_sweeps.setter
    def max_sweeps(self, arg: int, /) -> None: ...

    @property
    def seed(self) -> int:
        """Of all random numbers."""

    @seed.setter
    def seed(self, arg: int, /) -> None: ...

    @property
    def walker(self) -> int:
        """Which of several independent runs this is."""

    @walker.setter
    def walker(self, arg: int, /) -> None: ...

    @property
    def tolerance(self) -> float:
        """Largest |length - rest| / rest of a whole bar."""

    @tolerance.setter
    def tolerance(self, arg: float, /) -> None: ...

    @property
    def tolerance_length(self) -> float:
        """
        Largest |length - rest| in Angstrom, in place of tolerance; 0: not used.
        """

    @tolerance_length.setter
    def tolerance_length(self, arg: float, /) -> None: ...

    @property
    def force(self) -> float:
        """Size of a random force, kJ/(mol Angstrom)."""

    @force.setter
    def force(self, arg: float, /) -> None: ...

    @property
    def timestep(self) -> float:
        """ps."""

    @timestep.setter
    def timestep(self, arg: float, /) -> None: ...

    @property
    def damping(self) -> float:
        """Share of its velocity that a pushed joint loses a step, 0 to 1."""

    @damping.setter
    def damping(self, arg: float, /) -> None: ...

    @property
    def displacement(self) -> float:
        """Length of a random displacement, Angstrom."""

    @displacement.setter
    def displacement(self, arg: float, /) -> None: ...

    @property
    def replay(self) -> list[tuple[int, tuple[float, float, float]]]:
        """
        Forces in place of ``perturb``: (joint, (x, y, z)) in kJ/(mol Angstrom), one a step.
        """

    @replay.setter
    def replay(self, arg: Sequence[tuple[int, tuple[float, float, float]]], /) -> None: ...

class RunSummary:
    """What a run did."""

    @property
    def state(self) -> State:
        """What the run moved: its last positions."""

    @property
    def steps(self) -> int:
        """Steps done."""

    @property
    def frames(self) -> int:
        """Frames shown to observers."""

    @property
    def unconverged_steps(self) -> int:
        """Steps after which some bar missed the tolerance."""

    @property
    def first_unconverged_step(self) -> int:
        """The first of them; -1 if none."""

    @property
    def sweeps(self) -> int:
        """Sweeps of all steps."""

    @property
    def max_sweeps(self) -> int:
        """Sweeps of the step that needed most."""

    @property
    def projections(self) -> int:
        """Bars looked at in all steps."""

    @property
    def worst_residual(self) -> float:
        """Largest |length - rest| / rest after any step."""

    @property
    def worst_bar(self) -> int:
        """Its bar."""

    @property
    def worst_step(self) -> int:
        """Its step."""

    @property
    def stopped_by_caller(self) -> bool:
        """An observer asked to stop."""

    @property
    def perturb_seconds(self) -> float:
        """Wall time of perturbing."""

    @property
    def resolve_seconds(self) -> float:
        """Wall time of resolving."""

    @property
    def observe_seconds(self) -> float:
        """Wall time of the observers."""

    @property
    def seconds(self) -> float:
        """Wall time of it all."""

    @property
    def converged(self) -> bool:
        """Every bar was within the tolerance after every step."""

    @property
    def mean_sweeps(self) -> float:
        """Sweeps a step."""

    @property
    def ns_per_bar_and_sweep(self) -> float:
        """Resolve time over projections, nanoseconds."""

    def __repr__(self) -> str: ...

def run_steps(framework: Framework, state: State, options: RunOptions, observers: Sequence[object]) -> RunSummary:
    """
    Steps ``state`` on and shows frames to observers; the function ``run`` says more.
    """
