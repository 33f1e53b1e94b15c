"""Files with scenes: ours as they are, those of other systems as the importers read them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from sceneweaver.io import InputError, open_regular, read_bytes
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


def scenes_in(path: Path, source: str = "auto") -> Iterator[GivenScene]:
    """The scenes of a file or a folder, one after the other.

    Args:
        path: a scene.json, or whatever an importer reads.
        source: the format; "auto" looks at the file.

    Raises:
        InputError: it cannot be read, is damaged, or is of no known format.
    """
    if source in ("auto", "sceneweaver") and path.is_file() and _is_ours(path):
        yield GivenScene(Scene.load(path))
        return
    from sceneweaver.importers import read_scenes

    for one in read_scenes(path, source):
        yield GivenScene(one.scene, one.room, one.format, one.notes)


def is_damaged(path: Path) -> bool:
    """Whether a file that cannot be read as scenes was meant to be one: a reader knows it, or its text is broken."""
    from sceneweaver.importers import detect
    from sceneweaver.io import parse_json

    try:
        if _is_ours(path):
            return True
        detect(path)
        return True
    except InputError:
        pass
    if path.suffix.lower() != ".json":
        return False
    try:
        parse_json(read_bytes(path))
    except InputError:
        return True
    return False


def _is_ours(path: Path) -> bool:
    with open_regular(path) as file:
        return OURS in file.read(HEAD)
