# SPDX-License-Identifier: MIT
"""What a call says of an argument that it cannot take: its name, its value, and what it must be."""

from __future__ import annotations

import ast
import gc
import inspect
import math
import os
import re
import reprlib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any, NoReturn

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
}


def refuse(
    name: str, value: object, annotation: str, least: int | None = None, most: int | None = None
) -> NoReturn:
    """Raise TypeError; for a whole number out of range OptionError."""
    from pliant._core import OptionError

    if least is not None and most is not None and _is_whole(value):
        wanted = f"a whole number from {least} to {most}"
        raise OptionError(f"{name} = {shown(value)}: must be {wanted}")
    hint = _nearest(name, value, annotation)
    raise TypeError(f"{name} = {shown(value)}: must be {_wanted(annotation)}{hint}")


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
    """Raise an error that names the argument which does not fit; return where none is found."""
    signature = function.__nb_signature__[0][0]
    parameters = _parameters(signature)
    is_method = next(iter(parameters), "") == "self"
    given = _given(_called(function), parameters, positional, named, is_method)
    unfit = [name for name, value in given.items() if not fits(value, parameters[name])]
    for name in unfit:
        refuse(name, given[name], parameters[name])
    for name, value in given.items():
        if _is_whole(value) and "int" in kinds_of(parameters[name]):
            _refuse_out_of_range(name, int(value), parameters[name])  # type: ignore[call-overload]
    _refuse_contents(parameters, given)


def refuse_unknown(function: str, names: Iterable[str], named: Iterable[str]) -> None:
    """Raise TypeError for an argument that there is not, with the name that it is most like."""
    known = list(names)
    for name in named:
        if name not in known:
            import difflib

            like = difflib.get_close_matches(name, known, 1)
            hint = f" (did you mean {like[0]!r}?)" if like else ""
            if not like and len(known) <= MOST_LISTED:
                hint = f"; known: {', '.join(known)}"
            hint = hint or f"; help(pliant.{function}) lists them"
            raise TypeError(f"{function}: has no argument {name!r}{hint}")


def _called(function: Any) -> str:
    """By what name it is called: a class by its own."""
    name = str(function.__name__)
    return str(function.__qualname__).split(".")[0] if name == "__init__" else name


def _refuse_out_of_range(name: str, value: int, annotation: str) -> None:
    """Numbers without a sign alone refuse what is below 0."""
    least, most = _UNSIGNED if value < 0 else _SIGNED
    if not least <= value <= most:
        refuse(name, value, annotation, least, most)


def _refuse_contents(parameters: Mapping[str, str], given: Mapping[str, object]) -> None:
    """Refuses the first sequence: its items were not looked at, so one of them must be wrong."""
    nested = [
        name
        for name in given
        if "[" in parameters[name] and "Literal" not in parameters[name] and given[name] is not None
    ]
    for name in nested[:1]:
        refuse(name, given[name], parameters[name])


def _parsed(signature: str) -> ast.FunctionDef:
    """A signature of nanobind, whose defaults are literals, or places in a tuple: ``\\0``."""
    text = re.sub(r"\\(\d+)", r"_[\1]", signature)
    text = re.sub(r"ndarray\[[^\]]*=[^\]]*\]", "ndarray", text)  # of what is in it
    tree = ast.parse(text + ": ...").body[0]
    assert isinstance(tree, ast.FunctionDef)
    return tree


def _parameters(signature: str) -> dict[str, str]:
    """Annotations by name."""
    args = _parsed(signature).args
    every = [*args.posonlyargs, *args.args, *args.kwonlyargs]
    return {one.arg: ast.unparse(one.annotation) if one.annotation else "object" for one in every}


def signature_of(function: Any, is_bound: bool = False) -> inspect.Signature:
    """The signature of a compiled function; the first where it has several.

    Raises AttributeError where it cannot be read, as for an attribute that there is not.
    """
    try:
        text, _, defaults = function.__nb_signature__[0]
        tree = _parsed(text)
        found = list(_signature_parameters(tree.args, defaults or ()))
    except (SyntaxError, ValueError, AssertionError) as error:
        raise AttributeError("__signature__") from error
    returns = ast.unparse(tree.returns) if tree.returns else inspect.Signature.empty
    return inspect.Signature(found[is_bound:], return_annotation=returns)


def _signature_parameters(
    args: ast.arguments, defaults: Sequence[object]
) -> Iterator[inspect.Parameter]:
    kinds = inspect.Parameter
    positional = [*args.posonlyargs, *args.args]
    values: list[ast.expr | None] = [None] * (len(positional) - len(args.defaults))
    for one, value in zip(positional, [*values, *args.defaults], strict=True):
        is_only = one in args.posonlyargs
        kind = kinds.POSITIONAL_ONLY if is_only else kinds.POSITIONAL_OR_KEYWORD
        yield _parameter(one, kind, value, defaults)
    if args.vararg:
        yield _parameter(args.vararg, kinds.VAR_POSITIONAL, None, defaults)
    for one, value in zip(args.kwonlyargs, args.kw_defaults, strict=True):
        yield _parameter(one, kinds.KEYWORD_ONLY, value, defaults)
    if args.kwarg:
        yield _parameter(args.kwarg, kinds.VAR_KEYWORD, None, defaults)


def _parameter(one: ast.arg, kind: Any, value: ast.expr | None, defaults: Any) -> inspect.Parameter:
    default: object = inspect.Parameter.empty
    if isinstance(value, ast.Subscript) and isinstance(value.slice, ast.Constant):
        default = defaults[value.slice.value]
    elif value is not None:
        default = ast.literal_eval(value)
    annotation = ast.unparse(one.annotation) if one.annotation else inspect.Parameter.empty
    return inspect.Parameter(one.arg, kind, default=default, annotation=annotation)


def give_signatures(function: object, method: object, bound: object) -> None:
    """Lets `inspect.signature` see those of compiled functions and methods, given one of each.

    Their types can have no attributes set but in their own dict.
    """
    for one, is_bound in ((function, False), (method, False), (bound, True)):

        def get(self: Any, is_bound: bool = is_bound) -> inspect.Signature:
            return signature_of(self, is_bound)

        slots: Any = gc.get_referents(type(one).__dict__)[0]
        slots["__signature__"] = property(get)


def _given(
    function: str,
    parameters: Mapping[str, str],
    positional: Sequence[object],
    named: Mapping[str, object],
    is_method: bool,
) -> dict[str, object]:
    """Arguments by name. Raises TypeError for names that there are not."""
    names = list(parameters)
    refuse_unknown(function, names[is_method:], named)
    given = {**dict(zip(names, positional, strict=False)), **named}
    if is_method:
        given.pop("self", None)
    if len(positional) > len(names):
        raise TypeError(
            f"{function}: takes {len(names) - is_method} arguments, "
            f"found {len(positional) - is_method}"
        )
    return given


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
    bare = (
        one.value if isinstance(one, ast.Subscript) else one for one in _alternatives(annotation)
    )
    return [ast.unparse(one).rpartition(".")[2] for one in bare]


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
    from pliant import _core

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
