"""Files of plans as homes."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterator
from pathlib import Path

from sceneweaver.home import Home, is_home
from sceneweaver.io import InputError, load_json
from sceneweaver.io.messages import path_name, quote, suggest

from ..model import ReadOptions, SourceRoom
from ..read import AUTO, read_rooms, sources
from .build import home_of
from .floors import Drawn
from .model import ImportedHome

OWN = "sceneweaver"
"""The format of our own ``home.json``."""

DRAWN: tuple[Drawn, ...] = ("auto", "faces", "middles")


def read_homes(
    path: str | os.PathLike[str],
    format: str = AUTO,  # noqa: A002 - as users say it
    *,
    drawn: Drawn = "auto",
    scale: float | None = None,
    folder: str | os.PathLike[str] | None = None,
    on_error: Callable[[str], None] | None = None,
) -> list[ImportedHome]:
    """The homes in a plan, a file of plans, or a folder of such: rooms of one house with the doors between them.

    Rooms keep their places; plans that are turned are turned back, noise of pixels is taken out, and where rooms are
    drawn on the middle lines of walls each is inset by half a wall, so that outlines are clear floors on a grid of
    1 mm. A door joins the two rooms that it lies between. Furniture is left out: `read_scenes` has it.

    Args:
        path: a file, or a folder of many.
        format: one of `sceneweaver.importers.formats`, "sceneweaver" for our own home.json, or "auto".
        drawn: whether outlines are the "faces" of walls or their "middles"; "auto": as the gaps between rooms say.
        scale: metres for a unit, for formats that do not say it (SVG, DXF, pixels).
        folder: assets or metadata of the system that wrote the file.
        on_error: called with one line for a file or house that cannot be read, which is then passed over; None: it is
            raised.

    Raises:
        InputError: a file is broken or not recognised; one line with file, element and fix.

    Examples:
        >>> import tempfile, pathlib
        >>> import sceneweaver as sw
        >>> file = pathlib.Path(tempfile.mkdtemp()) / "plan.svg"
        >>> _ = file.write_text(
        ...     '<svg xmlns="http://www.w3.org/2000/svg" data-scale="0.01"><g id="rooms">'
        ...     '<rect id="bedroom" width="400" height="300"/><rect id="hall" x="410" width="200" height="300"/></g>'
        ...     '<g id="doors"><line x1="405" y1="100" x2="405" y2="190"/></g></svg>'
        ... )
        >>> home = sw.read_homes(file)[0].home
        >>> home.rooms[0].outline[2], [(door.room, door.to) for door in home.doors]
        ((4.0, 0.0), [('bedroom_0', 'hallway_0')])
    """
    if drawn not in DRAWN:
        raise InputError(f"drawn: {quote(drawn)} is unknown{suggest(drawn, DRAWN)}")
    if scale is not None and not 0 < scale < 1e4:
        raise InputError(f"scale: is {scale:g}; give metres for a unit, such as 0.001 for millimetres")
    options = ReadOptions(folder=None if folder is None else Path(folder), scale=scale)
    found: list[ImportedHome] = []
    used: set[str] = set()
    for file, name, rooms in _houses(Path(path), format, options, on_error):
        try:
            if isinstance(rooms, Home):
                found.append(ImportedHome(rooms, OWN, (), ()))
            else:
                known, house = name, _home_id(file, rooms[0], used)
                found.append(home_of(rooms, known, name=house, drawn=drawn))
        except InputError as error:
            house = rooms[0].house if not isinstance(rooms, Home) else ""
            line = f"{path_name(file)}: {f'{house}: ' if house else ''}{error}"
            if on_error is None:
                raise InputError(line) from None
            on_error(line)
    return found


def _houses(
    path: Path, format_name: str, options: ReadOptions, on_error: Callable[[str], None] | None
) -> Iterator[tuple[Path, str, Home | list[SourceRoom]]]:
    """File, format and either a home of ours or the rooms of one house."""
    if format_name in (AUTO, OWN) and path.suffix == ".json" and path.is_file():
        own = _own(path)
        if own is not None:
            yield path, OWN, own
            return
        if format_name == OWN:
            raise InputError(f'{path_name(path)}: is no home of ours; it needs "schema": "sceneweaver.home/1"')
    for file, entry in sources(path, format_name):
        gathered: list[SourceRoom] = []
        for room in read_rooms(file, entry, options, on_error):
            if gathered and room.house != gathered[0].house:
                yield file, entry.name, gathered
                gathered = []
            gathered.append(room)
        if gathered:
            yield file, entry.name, gathered


def _own(path: Path) -> Home | None:
    """A home of ours; None where the file is none."""
    try:
        data = load_json(path, max_bytes=2**28)
    except InputError:
        return None  # its format says what is wrong with it
    if not is_home(data):
        return None
    try:
        return Home.from_json(data)
    except InputError as error:
        raise InputError(f"{path_name(path)}: {error}") from None


def _home_id(file: Path, room: SourceRoom, used: set[str]) -> str:
    stem = re.sub(
        r"[^\w.-]+", "-", f"{file.name.split('.')[0]}-{room.house}" if room.house else file.name.split(".")[0]
    )
    name, k = stem or "home", 2
    while name in used:
        name, k = f"{stem}-{k}", k + 1
    used.add(name)
    return name
