"""Rooms designed from a request in words, measured: by the judge on true meshes, and by the critic."""

from __future__ import annotations

import time
from collections import Counter
from typing import Any

from benchmarks.settings import Settings
from sceneweaver.agent import Result, design
from sceneweaver.assets import Library
from sceneweaver.knowledge import room_type
from sceneweaver.scene import Scene
from sceneweaver.verify import Report, check
from sceneweaver.verify.solids import Placed
from sceneweaver.verify.walkable import measure

PAPER = {
    "bedroom": 14.0,
    "living_room": 17.3,
    "bathroom": 19.7,
    "childrens_room": 23.0,
    "gym": 29.7,
    "meeting_room": 31.0,
    "office": 40.0,
    "restaurant": 88.0,
    "waiting_room": 25.7,
    "kitchen": 34.7,
}
"""The ten kinds of rooms of the SceneWeaver paper with its mean counts of objects (its tables 2 and 8)."""

LIBRARY = Library()


def request(room: str) -> str:
    """The request for a kind of room, as the paper words it."""
    words = {"childrens_room": "children's room"}.get(room, room.replace("_", " "))
    return f"Design me a{'n' if words[0] in 'aeiou' else ''} {words}"


def designed(room: str, settings: Settings, seed: int, **switches: Any) -> tuple[Result, float]:
    """A design without files, and the seconds that it took."""
    began = time.perf_counter()
    result = design(request(room), seed=seed, device=settings.device, candidates=settings.most, **switches)
    return result, time.perf_counter() - began


def on_meshes(scene: Scene) -> Report:
    """What the judge says of the true meshes."""
    import trimesh

    meshes = {}
    for object_id in {o.asset for o in scene.objects if o.asset is not None}:
        mesh = LIBRARY.load(object_id).mesh
        meshes[object_id] = trimesh.Trimesh(mesh.vertices, mesh.faces, process=False)
    return check(scene, meshes=meshes)


def dominance(scene: Scene) -> float:
    """The largest share of one category among the objects, less what the room is made of."""
    room = room_type(scene.room.type)
    free = [o for o in scene.objects if o.intent.program_item not in room.made_of]
    counts = Counter(o.category for o in free)
    return max(counts.values(), default=0) / max(1, len(scene.objects))


def needed_reached(scene: Scene) -> float:
    """Of what was asked for or is needed and stands on the floor, the share whose functional sides can be reached."""
    needed = [o.id for o in scene.objects if o.mount == "floor" and o.intent.priority in ("asked", "needed")]
    access = measure(Placed.of(scene))
    missed = set(access.unreached) if access else set(needed)
    return 1.0 - len(missed.intersection(needed)) / max(1, len(needed))


def relations_per_object(scene: Scene) -> float:
    """Relations whose subject stands on the floor, for each object that does."""
    floor = {o.id for o in scene.objects if o.mount == "floor"}
    return sum(r.subject in floor for r in scene.relations) / max(1, len(floor))
