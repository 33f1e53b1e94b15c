"""The optimisers of a comparison: built in, of an entry point, by import path, or objects."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from importlib import import_module
from importlib.util import find_spec
from typing import Any

from sceneweaver.layout import StepOptimizer, find_optimizer, step_optimizer
from sceneweaver.scene import InputError


@dataclass(frozen=True)
class Method:
    """An optimiser under the name that it has in results.

    Attributes:
        name: in results.
        source: a name of the registry or of an entry point, ``package.module:Name``, or a `StepOptimizer`.

    Examples:
        >>> from sceneweaver import bench
        >>> from sceneweaver.layout import BuiltIn
        >>> bench.Method("adam, short", BuiltIn("adam", budget=99)).make().budget
        99
    """

    name: str
    source: str | StepOptimizer

    def make(self) -> StepOptimizer:
        """The optimiser. What its modules need is imported now, and may be missing.

        Raises:
            InputError: what the source names is no `StepOptimizer`. ImportError: something is missing.
        """
        if not isinstance(self.source, str):
            return self.source
        if ":" in self.source:
            module, _, attribute = self.source.partition(":")
            found = getattr(import_module(module), attribute, None)
            if found is None:
                raise InputError(f'optimizers: "{module}" has no "{attribute}"')
            found = found() if isinstance(found, type) or not hasattr(found, "step") else found
        else:
            found = self.source
        return step_optimizer(found)


def find_methods(optimizers: Sequence[str | StepOptimizer | Method]) -> list[Method]:
    """The methods that names and objects stand for.

    ``label=source`` gives another name. Where ``package.module:NAME`` in capitals is a mapping of names to sources, all
    of them join.

    Raises:
        InputError: nothing goes by such a name, or two go by the same.
    """
    methods = [method for given in optimizers for method in _found(given)]
    if not methods:
        raise InputError("optimizers: give at least one")
    names = [method.name for method in methods]
    for name in names:
        if names.count(name) > 1:
            raise InputError(f'optimizers: "{name}" is there twice; give label=source')
    return methods


def _found(given: Any) -> list[Method]:
    if isinstance(given, Method):
        return [given]
    if not isinstance(given, str):
        find_optimizer(given)
        return [Method(type(given).__name__, given)]
    label, _, source = given.rpartition("=")
    if ":" not in source:
        find_optimizer(source)
        return [Method(label or source, source)]
    module, _, attribute = source.partition(":")
    try:
        there = find_spec(module) is not None
    except ImportError:
        there = False
    if not there or not attribute:
        raise InputError(f'optimizers: there is no "{source}"; a source is package.module:Name')
    if attribute.isupper():
        mapping = getattr(import_module(module), attribute, None)
        if not isinstance(mapping, Mapping):
            raise InputError(f'optimizers: "{source}" is no mapping of names to optimisers')
        return [Method(str(name), each) for name, each in mapping.items()]
    return [Method(label or attribute, source)]
