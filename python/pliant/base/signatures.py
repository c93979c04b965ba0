# SPDX-License-Identifier: MIT
"""Signatures of compiled functions, as nanobind tells them: for `inspect`, and for refusals."""

from __future__ import annotations

import ast
import gc
import inspect
import re
from collections.abc import Iterator, Sequence
from typing import Any

from pliant import _core


def _parsed(signature: str) -> ast.FunctionDef:
    """A signature of nanobind, whose defaults are literals, or places in a tuple: ``\\0``."""
    text = re.sub(r"\\(\d+)", r"_[\1]", signature)
    text = text.replace("def (", "def _(", 1)  # of what sets a property
    text = re.sub(r"ndarray\[[^\]]*=[^\]]*\]", "ndarray", text)  # of what is in it
    tree = ast.parse(text + ": ...").body[0]
    assert isinstance(tree, ast.FunctionDef)
    return tree


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


def name_of(function: Any) -> str:
    """By what name it is called: a class by its own, what sets a property as `State.step`."""
    name = str(function.__name__)
    if name == "__init__":
        return str(function.__qualname__).split(".")[0]
    return name or property_set_by(function)


def property_set_by(function: Any) -> str:
    """The name of the property, which nanobind does not tell its setter; "" of other functions."""
    for kind in vars(_core).values():
        for name, one in vars(kind).items() if isinstance(kind, type) else ():
            if getattr(one, "fset", None) is function:
                return name
    return ""


def documented(function: Any, name: str) -> str:
    """What the text on a function or class says that an argument is: "an array (N, 3)"."""
    owner, _, method = str(function.__qualname__).rpartition(".")
    told = getattr(_core, owner, None) if method == "__init__" else function
    found = re.search(rf"^{name} : (.*?)(, optional)?$", told.__doc__ or "", re.MULTILINE)
    words = found[1].replace(" array-like", "") if found else ""
    return f"an array {words}" if words.startswith("(") else words


def give_signatures(function: object, method: object, bound: object) -> None:
    """Lets `inspect.signature` see those of compiled functions and methods, given one of each.

    Their types can have no attributes set but in their own dict.
    """
    for one, is_bound in ((function, False), (method, False), (bound, True)):

        def get(self: Any, is_bound: bool = is_bound) -> inspect.Signature:
            return signature_of(self, is_bound)

        slots: Any = gc.get_referents(type(one).__dict__)[0]
        slots["__signature__"] = property(get)
