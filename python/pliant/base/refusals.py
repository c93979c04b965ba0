# SPDX-License-Identifier: MIT
"""What a call says of an argument that it cannot take: its name, its value, and what it must be."""

from __future__ import annotations

import ast
import math
import os
import reprlib
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from inspect import Signature
from typing import Any, NoReturn

from pliant import _core
from pliant._core import OptionError
from pliant.base.extras import late
from pliant.base.signatures import documented, name_of, property_set_by, signature_of

difflib = late("difflib")

#: by the name of a type of many kinds: what refuses None, in words of its own
EXPLAINED: dict[str, Callable[[object], object]] = {}

#: whole numbers that 64 bits hold, with a sign and without
_SIGNED = (-(2**63), 2**63 - 1)
_UNSIGNED = (0, 2**64 - 1)

#: of more arguments than these the list is no help
MOST_LISTED = 8

#: what arguments of a type must be, in words
_WORDS = {
    "int": "a whole number",
    "float": "a number",
    "str": "a text",
    "Literal": "a text",
    "bool": "True or False",
    "None": "None",
    "PathLike": "a path",
    "Path": "a path",
    "Callable": "a function",
    "Sweep": "a function",
    "Iterable": "a sequence",
    "Sequence": "a sequence",
    "Mapping": "a dict",
    "ArrayLike": "an array",
    "NDArray": "an array",
    "object": "an object",
}

_RUN = (
    "model = pliant.build_model(molecule, {}=...), then pliant.%s(model.framework, model.positions)"
)

#: how functions are called that take what `build_model` makes
_WITH_MODEL = {
    "contacts": "pliant.build_model(molecule, {}=...).contacts has it",
    "run": _RUN % "run",
    "run_ensemble": _RUN % "run_ensemble",
}

#: of these, the text on the function says more: what they hold, their shapes
_SAY_LITTLE = {"ArrayLike", "NDArray", "Sequence", "object", "tuple"}


def refuse(
    name: str,
    value: object,
    annotation: str,
    least: int | None = None,
    most: int | None = None,
    words: str = "",
) -> NoReturn:
    """Raise TypeError; for a whole number out of range OptionError.

    `words`: what it must be, where the annotation says less.
    """
    if least is not None and most is not None and _is_whole(value):
        wanted = f"a whole number from {least} to {most}"
        raise OptionError(f"{name} = {shown(value)}: must be {wanted}")
    hint = _nearest(name, value, annotation)
    raise TypeError(f"{name} = {shown(value)}: must be {words or _wanted(annotation)}{hint}")


def _nearest(name: str, value: object, annotation: str) -> str:
    """The whole number that a text or a fraction may have meant."""
    if "int" not in kinds_of(annotation):
        return ""
    try:
        number = int(float(value))  # type: ignore[arg-type]
    except (TypeError, ValueError, OverflowError):
        return ""
    return f", such as {name}={number}"


def refuse_call(function: Any, positional: Sequence[object], named: Mapping[str, object]) -> None:
    """Raise an error that names what does not fit, in place of a signature of nanobind."""
    call, signature = name_of(function), signature_of(function)
    given = _given(call, signature, positional, named)
    for name, value in given.items():
        _refuse_unfit(function, name, value, str(signature.parameters[name].annotation))
    every = ", ".join(f"{name} = {shown(value)}" for name, value in given.items())
    raise TypeError(f"{call}: cannot take {every}")


def _given(
    call: str, signature: Signature, positional: Sequence[object], named: Mapping[str, object]
) -> dict[str, object]:
    """Arguments by name. Raises TypeError for those that are unknown, missing or too many."""
    refuse_unknown(call, [name for name in signature.parameters if name != "self"], named)
    try:
        given = signature.bind(*positional, **named).arguments
    except TypeError as error:
        raise TypeError(f"{call}: {error}") from None
    given.pop("self", None)
    return given


def _refuse_unfit(function: Any, name: str, value: object, annotation: str) -> None:
    """Raises TypeError, or OptionError for a whole number that no whole number of C++ can be."""
    known = property_set_by(function) or name
    for kind in EXPLAINED.keys() & set(kinds_of(annotation)) if value is None else ():
        EXPLAINED[kind](value)  # which raises
    if not _holds(value, ast.parse(annotation, mode="eval").body):
        says_less = _SAY_LITTLE.intersection(kinds_of(annotation))
        refuse(known, value, annotation, words=documented(function, name) if says_less else "")
    if _is_whole(value) and "int" in kinds_of(annotation):
        _refuse_out_of_range(known, int(value), annotation)  # type: ignore[call-overload]


def refuse_unknown(function: str, names: Iterable[str], named: Iterable[str]) -> None:
    """Raise TypeError for an argument that there is not, with the name that it is most like."""
    known = list(names)
    for name in named:
        if name not in known:
            model = _with_model(function, name)
            like = [] if model else difflib.get_close_matches(name, known, 1)
            hint = f" (did you mean {like[0]!r}?)" if like else ""
            if model:
                hint = f": {model}"
            elif not like and len(known) <= MOST_LISTED:
                hint = f"; known: {', '.join(known)}"
            hint = hint or f"; help(pliant.{function}) lists them"
            raise TypeError(f"{function}: has no argument {name!r}{hint}")


def _with_model(function: str, name: str) -> str:
    """How a function that builds no model is given one with an argument of `build_model`."""
    if function not in _WITH_MODEL or name not in signature_of(_core.build_model).parameters:
        return ""
    return _WITH_MODEL[function].format(name)


def _refuse_out_of_range(name: str, value: int, annotation: str) -> None:
    """Numbers without a sign alone refuse what is below 0."""
    least, most = _UNSIGNED if value < 0 else _SIGNED
    if not least <= value <= most:
        refuse(name, value, annotation, least, most)


def _alternatives(annotation: str) -> Iterator[ast.expr]:
    """The members of `int | str | None`."""
    open_ = [ast.parse(annotation, mode="eval").body]
    while open_:
        one = open_.pop(0)
        if isinstance(one, ast.BinOp):
            open_[:0] = [one.left, one.right]
        else:
            yield one


def kinds_of(annotation: str) -> list[str]:
    """The names of the alternatives, without modules and what stands in brackets."""
    return [_kind(one) for one in _alternatives(annotation)]


def _kind(one: ast.expr) -> str:
    bare = one.value if isinstance(one, ast.Subscript) else one
    return ast.unparse(bare).rpartition(".")[2]


def _holds(value: object, wanted: ast.expr) -> bool:
    """Whether a value and what it holds may be of the type; None only where it is named."""
    if isinstance(wanted, ast.BinOp):
        return _holds(value, wanted.left) or _holds(value, wanted.right)
    kind = _kind(wanted)
    if not _is_of(value, kind) or (value is None and kind != "None"):
        return False
    if not isinstance(wanted, ast.Subscript) or kind not in ("Sequence", "list", "tuple"):
        return True
    items: list[Any] = list(value)  # type: ignore[call-overload]
    inner = wanted.slice.elts if isinstance(wanted.slice, ast.Tuple) else [wanted.slice]
    if kind != "tuple" or ast.unparse(inner[-1]) == "...":
        return all(_holds(one, inner[0]) for one in items)
    return len(items) == len(inner) and all(map(_holds, items, inner))


def fits(value: object, annotation: str) -> bool:
    """Whether a value may be of the type; True where that is not known."""
    return any(_is_of(value, kind) for kind in kinds_of(annotation))


def _is_of(value: object, kind: str) -> bool:
    if kind == "int":
        return _is_whole(value)
    if kind == "float":
        return not isinstance(value, str) and hasattr(value, "__float__")
    if kind == "bool":
        return isinstance(value, bool)
    if kind == "None":
        return value is None
    if kind in ("str", "Literal"):
        return isinstance(value, str)
    if kind in ("PathLike", "Path"):
        return isinstance(value, (str, os.PathLike))
    if kind in ("Callable", "Sweep"):
        return callable(value)
    if kind == "Iterable":
        return hasattr(value, "__iter__")
    if kind == "Mapping":
        return hasattr(value, "keys")
    if kind in ("Sequence", "list", "tuple"):
        return hasattr(value, "__len__") and not isinstance(value, (str, bytes))
    return _is_object_of(value, kind)


def _is_object_of(value: object, kind: str) -> bool:
    """Whether it is an object of one of our classes."""
    known = getattr(_core, kind, None)
    return isinstance(value, known) if isinstance(known, type) else True


def _is_whole(value: object) -> bool:
    return hasattr(value, "__index__")


def _wanted(annotation: str) -> str:
    """ "a whole number or None"."""
    kinds = kinds_of(annotation)
    words = [_WORDS.get(kind, f"a {kind}") for kind in kinds]
    return " or ".join(dict.fromkeys(words))


def shown(value: object) -> str:
    """The value in a few characters."""
    if isinstance(value, float) and math.isnan(value):
        return "nan"
    short = reprlib.Repr()
    short.maxlong = 40
    return short.repr(value)
