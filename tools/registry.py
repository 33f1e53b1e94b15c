"""All tools by name: our own, and those of other packages, which bring one module and one card each.

A package offers a tool by an entry point of the group ``sceneweaver.tools``, ``name = "package.module:ToolClass"``. Its
card is ``name.yaml`` beside that module, or in a folder ``toolcards`` of its package or of its top-level package.
"""

from __future__ import annotations

import logging
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from importlib import import_module, metadata, resources, util
from importlib.resources.abc import Traversable
from pathlib import Path
from types import MappingProxyType

from sceneweaver.io import packaged
from sceneweaver.scene import InputError

from .base import Tool
from .card import ToolCard, read_card

GROUP = "sceneweaver.tools"

OWN: Mapping[str, str] = {
    "init_prior": "InitPrior",
    "init_library": "InitLibrary",
    "init_llm": "InitLlm",
    "init_model": "InitModel",
    "add_objects": "AddObjects",
    "add_tabletop": "AddTabletop",
    "add_crowd": "AddCrowd",
    "add_wall_objects": "AddWallObjects",
    "add_clutter": "AddClutter",
    "remove_objects": "RemoveObjects",
    "add_relation": "AddRelation",
    "update_rotation": "UpdateRotation",
    "update_size": "UpdateSize",
    "update_layout": "UpdateLayout",
}
"""Our own tools and their classes: they are there in a source tree, too, where no entry points are."""

log = logging.getLogger(__name__)


@dataclass(frozen=True)
class Registered:
    """A tool that can be called: its card, and what loads it. Nothing of it is imported before."""

    card: ToolCard
    load: Callable[[], Tool]
    origin: str


def tools() -> Mapping[str, Registered]:
    """All tools by name, our own first. One that is broken is left out with a warning in the log."""
    found: dict[str, Registered] = {}
    for name, target in _targets():
        if name in found:
            if found[name].origin != target:
                log.warning("tool %s of %s is left out: the name is taken by %s", name, target, found[name].origin)
            continue
        try:
            found[name] = Registered(_card(name, target), partial(_load, name, target), target)
        except Exception as error:  # whatever a foreign package does wrong must not stop the others
            log.warning("tool %s of %s is left out: %s", name, target, _line(error))
    return MappingProxyType(found)


def tool(name: str) -> Registered:
    """The tool of that name; InputError when there is none."""
    from sceneweaver.io.messages import suggest

    known = tools()
    if name not in known:
        raise InputError(f"tool: '{name}' is unknown{suggest(name, known)}")
    return known[name]


def _targets() -> Iterator[tuple[str, str]]:
    """Names and "module:Class" of all tools."""
    for name, cls in OWN.items():
        yield name, f"{__package__}.{name}:{cls}"
    for point in sorted(metadata.entry_points(group=GROUP), key=lambda p: (p.name, p.value)):
        if point.name not in OWN or not point.value.startswith(f"{__package__}."):
            yield point.name, point.value.replace(" ", "")


def _card(name: str, target: str) -> ToolCard:
    module = target.partition(":")[0]
    for folder in _folders(module):
        for file in (folder.joinpath(f"{name}.yaml"), folder.joinpath("toolcards", f"{name}.yaml")):
            if file.is_file():
                card = read_card(packaged.text_of(file))
                if card.name != name:
                    raise InputError(f"its card is called {card.name}; name card and entry point alike")
                return card
    raise InputError(f"there is no card {name}.yaml beside {module} or in toolcards of its package")


def _folders(module: str) -> Iterator[Traversable]:
    """Where the card of a module may be: beside it, and in its top-level package."""
    parent, _, _ = module.rpartition(".")
    if not parent:
        spec = util.find_spec(module)
        if spec is None or spec.origin is None:
            raise InputError(f"there is no module {module}")
        yield Path(spec.origin).parent
        return
    yield resources.files(parent)
    top = parent.partition(".")[0]
    if top != parent:
        yield resources.files(top)


def _load(name: str, target: str) -> Tool:
    """Import a tool and make it; InputError with one line when that fails."""
    module, _, path = target.partition(":")
    try:
        made = import_module(module)
        for part in path.split("."):
            made = getattr(made, part)
        tool = made()  # pyright: ignore[reportCallIssue]
    except InputError:
        raise
    except Exception as error:
        raise InputError(f"tool {name}: {target} does not load: {_line(error)}") from error
    if not callable(getattr(tool, "propose", None)) or getattr(tool, "name", None) != name:
        raise InputError(f"tool {name}: {target} is no tool; it needs name = {name!r} and propose(context)")
    return tool


def _line(error: Exception) -> str:
    return " ".join(f"{type(error).__name__}: {error}".split()) if str(error) else type(error).__name__
