"""Files and folders of other systems as scenes of ours, one after another."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterator
from pathlib import Path

from sceneweaver.io import InputError, open_regular, reason
from sceneweaver.io.messages import path_name, quote, suggest

from .bodies import Assets
from .box_files import PICKLE, is_pickle
from .formats import formats
from .model import HEAD, ReadOptions, SourceFormat, SourceRoom
from .scene import ImportedScene, to_scene
from .sizes import SizeTable

AUTO = "auto"
KINDS: tuple[Assets, ...] = ("own", "theirs", "boxes")


def format_of(path: Path, name: str = AUTO) -> SourceFormat:
    """The format of a file or folder: the one that is named, or the one that recognises it.

    Raises:
        InputError: the name is unknown, the path is not there, or no format or several recognise it.
    """
    known = formats()
    if name != AUTO:
        if name not in known:
            raise InputError(f"--from: '{name}' is unknown{suggest(name, known)}")
        return known[name]
    if not path.exists():
        raise InputError(f"{path_name(path)}: no such file or folder")
    head = _head(path)
    found = [f for f in known.values() if _matches(f, path, head)]
    if not found and is_pickle(path, head):
        raise InputError(f"{path_name(path)}: it is {PICKLE}")
    if not found:
        raise InputError(
            f"{path_name(path)}: no format recognises it; say which with --from, one of {', '.join(known)}"
        )
    best = max(f.priority for f in found)
    found = [f for f in found if f.priority == best]
    if len(found) > 1:
        raise InputError(f"{path_name(path)}: it may be {' or '.join(f.name for f in found)}; say which with --from")
    return found[0]


def _head(path: Path) -> bytes:
    if path.is_dir():
        return b""
    with open_regular(path, 2**62) as file:
        return file.read(HEAD)


def _matches(entry: SourceFormat, path: Path, head: bytes) -> bool:
    try:
        return bool(entry.matches(path, head))
    except (InputError, OSError, ValueError):
        return False


def sources(path: Path, name: str = AUTO) -> Iterator[tuple[Path, SourceFormat]]:
    """The files of a path with their formats: the path itself, or what a folder holds, by name.

    A folder that a format reads as a whole is one source. Files that no format recognises are passed over.

    Raises:
        InputError: nothing in it is recognised.
    """
    if not path.is_dir():
        yield path, format_of(path, name)
        return
    wanted = formats().values() if name == AUTO else [format_of(path, name)]
    whole = [f for f in wanted if _matches(f, path, b"")]
    if whole:
        yield path, max(whole, key=lambda f: f.priority)
        return
    some = False
    for folder, folders, files in os.walk(path):
        folders.sort()
        here = Path(folder)
        for inner in list(folders):
            entry = _recognised(here / inner, name, b"")
            if entry is not None:
                folders.remove(inner)
                some = True
                yield here / inner, entry
        for file in sorted(files):
            entry = _recognised(here / file, name, None)
            if entry is not None:
                some = True
                yield here / file, entry
    if not some:
        raise InputError(f"{path_name(path)}: no file in this folder is of a known format; say which with --from")


def _recognised(path: Path, name: str, head: bytes | None) -> SourceFormat | None:
    try:
        head = _head(path) if head is None else head
    except (InputError, OSError):
        return None
    known = formats()
    pool = list(known.values()) if name == AUTO else [known[name]]
    found = [f for f in pool if _matches(f, path, head)]
    return max(found, key=lambda f: f.priority) if found else None


def read_scenes(
    path: str | os.PathLike[str],
    source: str = AUTO,
    *,
    assets: Assets = "own",
    folder: str | os.PathLike[str] | None = None,
    sizes: SizeTable | None = None,
    room: str | None = None,
    relations: bool = True,
    on_error: Callable[[str], None] | None = None,
) -> Iterator[ImportedScene]:
    """The scenes in a file or folder of another system, one by one.

    Args:
        path: a file, or a folder of many.
        source: the format, one of `formats`, or "auto".
        assets: what stands for their objects: "own" furniture of the category and size, "theirs" from ``folder``, or
            plain "boxes".
        folder: their assets, meshes or metadata.
        sizes: (depth, width, height) [m] by asset or label, for formats without sizes.
        room: only this room of a home.
        relations: whether to infer soft relations from the geometry.
        on_error: called with one line for a file or room that cannot be read, which is then passed over; None: it is
            raised.

    Raises:
        InputError: a file is broken or not recognised; one line with file, field and fix.

    Examples:
        >>> import json, tempfile, pathlib
        >>> import sceneweaver as sw
        >>> file = pathlib.Path(tempfile.mkdtemp()) / "bedroom.json"
        >>> bed = {"length": 120, "width": 90, "height": 40, "left": 90, "top": 60, "depth": 20, "orientation": 90}
        >>> prompt = "Room Type: bedroom\\nRoom Size: max length 256px, max width 256px"
        >>> _ = file.write_text(json.dumps([{"query_id": "a", "prompt": prompt, "object_list": [["double_bed", bed]]}]))
        >>> [imported.scene.objects[0].category for imported in sw.read_scenes(file)]
        ['bed']
    """
    if assets not in KINDS:
        raise InputError(f"assets: '{assets}' is unknown{suggest(assets, KINDS)}")
    options = ReadOptions(folder=None if folder is None else Path(folder), room=room)
    used: set[str] = set()
    some = False
    for file, entry in sources(Path(path), source):
        for rooms in read_rooms(file, entry, options, on_error):
            if room is not None and rooms.name != room:
                continue
            some = True
            name = _scene_name(file, rooms, used)
            try:
                made = to_scene(rooms, entry.name, name=name, assets=assets, sizes=sizes, relations=relations)
            except InputError as error:
                line = f"{path_name(file)}: room {quote(rooms.name)}: {error}"
                if on_error is None:
                    raise InputError(line) from None
                on_error(line)
                continue
            yield made
    if room is not None and not some:
        raise InputError(f"--room: {path_name(Path(path))} has no room {quote(room)}")


def read_rooms(
    file: Path, entry: SourceFormat, options: ReadOptions, on_error: Callable[[str], None] | None
) -> Iterator[SourceRoom]:
    """The rooms of a file; whatever is wrong with it is one line that names it: raised, or given to ``on_error``."""
    try:
        yield from entry.read(file, options)
    except InputError as error:
        line = str(error) if path_name(file) in str(error) else f"{path_name(file)}: {error}"
    except (ArithmeticError, AttributeError, IndexError, KeyError, TypeError, ValueError) as error:
        line = f"{path_name(file)}: not as {entry.title} writes it ({type(error).__name__}: {reason(error)})"
    else:
        return
    if on_error is None:
        raise InputError(line)
    on_error(line)


def _scene_name(file: Path, room: SourceRoom, used: set[str]) -> str:
    """A name of its own for the scene of a room: the file's, with the room's where there are several."""
    stem = re.sub(r"[^\w.-]+", "-", f"{file.name.split('.')[0]}-{room.name}" if room.name else file.name.split(".")[0])
    name, k = stem, 2
    while name in used:
        name, k = f"{stem}-{k}", k + 1
    used.add(name)
    return name
