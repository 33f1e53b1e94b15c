"""Names in the files of a home: ``<room>:<object>`` for things, ``home:...`` for what is around them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from sceneweaver.assets.placed import Load
from sceneweaver.home import Home, HomeRoom
from sceneweaver.physics.things import Thing, things_of
from sceneweaver.scene import Pose, SceneObject

from ..names import legal_name


@dataclass(frozen=True, eq=False)
class HomeNames:
    """The names of a home's things: by room, from an object's id to its name in the home, no two alike.

    Nor are two alike where a format has ``_`` for what it cannot write. ``home`` begins the names of walls, doors and
    whatever else belongs to no room.
    """

    home: str
    things: dict[str, dict[str, str]]

    @classmethod
    def of(cls, home: Home) -> HomeNames:
        """The names of a home."""
        own = "home"
        while any(room.id == own or room.id.startswith(f"{own}:") for room in home.rooms):
            own += "_"
        taken = set[str]()

        def unique(text: str) -> str:
            name, number = text, 1
            while legal_name(name) in taken:
                number += 1
                name = f"{text}_{number}"
            taken.add(legal_name(name))
            return name

        things = {}
        for room in home.rooms:
            ids = room.scene.ids if room.scene is not None else ()
            things[room.id] = {object_id: unique(f"{room.id}:{object_id}") for object_id in ids}
        return cls(own, things)

    def object(self, room: str, thing: SceneObject, elevation: float) -> SceneObject:
        """An object of a room's scene under its name in the home, in the home's frame."""
        named = self.things[room]
        x, y, z = thing.pose.position
        support = thing.support
        if support is not None:
            support = support.model_copy(update={"object": named.get(support.object, support.object)})
        pose = Pose(position=(x, y, z + elevation), quaternion=thing.pose.quaternion)
        return thing.model_copy(update={"id": named[thing.id], "pose": pose, "support": support})


def things_of_rooms(
    home: Home, names: HomeNames, load: Load | None = None, *, loose: bool = True
) -> Iterator[tuple[HomeRoom, list[Thing]]]:
    """The things of each furnished room, as `things_of`, under their names in the home and in its frame."""
    for room in home.rooms:
        if room.scene is not None:
            up = home.storey_of(room.id).elevation
            things = things_of(room.scene, load, loose=loose)
            yield room, [_named(thing, names.object(room.id, thing.object, up)) for thing in things]


def _named(thing: Thing, named: SceneObject) -> Thing:
    if thing.asset is not None:
        return replace(thing, object=named)
    # What is drawn as its parts has a body of its own, named by its id.
    return replace(thing, object=named, key=f"parts:{named.id}", shape=f"parts:{named.id}")
