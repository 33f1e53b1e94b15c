"""Files with scenes: ours as they are, those of other systems as the importers read them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

from sceneweaver.importers import AUTO, format_of, read_scenes
from sceneweaver.io import InputError, open_regular, parse_json, read_bytes
from sceneweaver.scene import Scene

HEAD = 4096
"""Bytes within which a scene of ours says what it is."""

OURS = b"sceneweaver.scene/"


@dataclass(frozen=True)
class GivenScene:
    """A scene of a file.

    Attributes:
        scene: in our model.
        name: of its room in the file; empty where that has one scene without a name.
        source: the format; empty for a scene of ours.
        notes: what was assumed of it or left out, a line each.
    """

    scene: Scene
    name: str = ""
    source: str = ""
    notes: tuple[str, ...] = ()


def scenes_in(
    path: Path,
    source: str = AUTO,
    *,
    part: str | None = None,
    plain: bool = False,
    on_error: Callable[[str], None] | None = None,
) -> Iterator[GivenScene]:
    """The scenes of a file or a folder, one after the other.

    Args:
        path: a scene.json, or whatever an importer reads.
        source: the format; "auto" looks at the file.
        part: only rooms of this name.
        plain: boxes in the place of furniture, and no relations: for a look at what there is.
        on_error: called with a line for a room of a file that is broken; None: it is raised.

    Raises:
        InputError: it cannot be read, is damaged, or is of no known format.
    """
    if source == AUTO and path.is_file() and _is_ours(path):
        yield GivenScene(Scene.load(path))
        return
    assets = "boxes" if plain else "own"
    for one in read_scenes(path, source, assets=assets, room=part, relations=not plain, on_error=on_error):
        yield GivenScene(one.scene, one.room, one.format, one.notes)


def is_damaged(path: Path) -> bool:
    """Whether what cannot be read as scenes was meant to be some: a reader knows it, or it is JSON that is broken."""
    if path.is_dir():
        return True
    try:
        if _is_ours(path):
            return True
        format_of(path)
    except InputError:
        pass
    else:
        return True
    try:
        if path.suffix.lower() == ".json":
            parse_json(read_bytes(path))
    except InputError:
        return True
    return False


def _is_ours(path: Path) -> bool:
    with open_regular(path) as file:
        return OURS in file.read(HEAD)
