"""Homes on the server: how one is read, what is said of it, and which are open or can be opened."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sceneweaver.geometry.polygons import signed_area
from sceneweaver.home import Home
from sceneweaver.home.io import EXAMPLES
from sceneweaver.io import read_bytes
from sceneweaver.scene import InputError

from .answers_homes import HomeRoomFacts, HomeState, OpenHome
from .handles import Handle, Handles, Version
from .limits import MOST_HOME, MOST_LISTED
from .paths import Folder
from .service import Service, uri_of
from .words_homes import home_faults, soft_rules

FILE = "home.json"
"""What the file of a home is called."""


def read_home(folder: Folder, name: str) -> tuple[Home, str]:
    """A home by the name of a file, of a folder that holds one, or of an example, and where it is from.

    Raises:
        InputError: for a name that is refused, or what is no home.
    """
    path = folder.place(name, "name")
    if name in EXAMPLES and not path.exists():
        return Home.example(name), f"the example {name}"
    if path.is_dir():
        path = folder.place(f"{name}/{FILE}", "name")
    shown = folder.shown(path)
    if path.suffix.lower() != ".json":
        raise InputError(f"name: '{shown}' is no file of a home; give one that ends in .json, or an example")
    try:
        return Home.loads(read_bytes(path, max_bytes=MOST_HOME)), shown
    except InputError as error:
        raise InputError(f"name: {shown}: {str(error).removeprefix(f'{path}: ')}") from None


def opened_home(service: Service, handle: Handle[Home]) -> HomeState:
    """A home that has just been opened."""
    return HomeState(**home_fields(service, handle, handle.current, handle.current.change, []))


def home_fields(
    service: Service, handle: Handle[Home], version: Version[Home], change: str, notes: list[str]
) -> dict[str, Any]:
    """The fields of a `HomeState`."""
    report, access = version.report, version.report["access"]
    return {
        "home": handle.id,
        "version": version.number,
        "change": change,
        "valid": report["valid"],
        "violations": home_faults(report),
        "soft": soft_rules(report),
        "rooms": room_facts(version.content),
        "entrance": access["entrance"],
        "unreached": [*access["unreached_rooms"], *access["unreached_objects"]][:MOST_LISTED],
        "notes": [service.folder.without_paths(note) for note in notes],
        "resource": uri_of(handle),
    }


def room_facts(home: Home) -> list[HomeRoomFacts]:
    """What is said of each room of a home."""
    graph = home.graph()
    return [
        HomeRoomFacts(
            id=room.id,
            type=room.type,
            storey=room.storey,
            area=round(signed_area(room.outline), 2),
            leads_to=list(dict.fromkeys(other for other, _ in graph[room.id])),
            objects=None if room.scene is None else len(room.scene.objects),
            request=None if room.scene is None else room.scene.prompt or None,
        )
        for room in home.rooms
    ]


def open_homes(homes: Handles[Home]) -> list[OpenHome]:
    """All open homes."""
    found = []
    for handle in homes:
        version: Version[Home] = handle.current
        rooms: tuple[Any, ...] = version.content.rooms
        furnished = sum(room.scene is not None for room in rooms)
        found.append(
            OpenHome(
                home=handle.id,
                name=version.content.id,
                version=version.number,
                versions=sorted(handle.versions),
                rooms=len(rooms),
                furnished=furnished,
                valid=version.report["valid"],
            )
        )
    return found


def report_data(handle: Handle[Home]) -> Mapping[str, Any]:
    """The judge's report on a home as it is now, and what the design said that it came from."""
    version = handle.current
    reviewed = handle.versions.get(1)
    return {
        "home": handle.id,
        "version": version.number,
        "report": version.report,
        "review": reviewed.review if reviewed is not None else None,
        "reviewed_version": 1 if reviewed is not None and reviewed.review is not None else None,
    }
