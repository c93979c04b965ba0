# SPDX-License-Identifier: MIT
"""Packages that are called: ``pliant.check`` has modules, and ``pliant.check(path)`` checks."""

from __future__ import annotations

import importlib
import sys
from types import ModuleType
from typing import TYPE_CHECKING, Any

from pliant._extras import needed_by

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping
    from inspect import Signature


class CallablePackage(ModuleType):
    """A package that stands for the function of its own name.

    The function and the other names that it offers are in modules that need more than NumPy and
    h5py, so these are imported when a name is first asked for.
    """

    #: the module that defines each name: in the package, or by its whole name, "pliant. ..."
    _late: Mapping[str, str]

    def __call__(self, *arguments: Any, **options: Any) -> Any:
        """Calls the function."""
        return self._function(*arguments, **options)

    def __getattr__(self, name: str) -> Any:
        """One of the late names; kept, so that it is looked for once."""
        if name not in self._late:
            raise AttributeError(f"module '{self.__name__}' has no attribute '{name}'")
        with needed_by(self.__name__, inside=True):
            late = self._late[name]
            is_whole = late.startswith("pliant.")
            module = importlib.import_module(late if is_whole else f"{self.__name__}.{late}")
        value = getattr(module, name)
        setattr(self, name, value)
        return value

    def __dir__(self) -> list[str]:
        return sorted(self.__all__)

    @property
    def _function(self) -> Callable[..., Any]:
        function: Callable[..., Any] = getattr(self, self.__name__.rpartition(".")[2])
        return function

    @property
    def __signature__(self) -> Signature:
        """The signature of the function, for `inspect` and `help`."""
        from inspect import signature

        return signature(self._function)


def make_callable(package: str, late: Mapping[str, str]) -> None:
    """Makes a package that is being imported a CallablePackage.

    `late` names the module that defines each name; one is the package's own, that of the function.
    The object stays the same, so no order of imports puts another in its place.
    """
    module = sys.modules[package]
    module.__class__ = CallablePackage
    assert isinstance(module, CallablePackage)
    module._late = late
