"""Patterns of the pictures, from cameras and poses alone: what they leave out, and what is seen from behind."""

from __future__ import annotations

import numpy as np

from benchmarks.patterns.room import Hits, Room
from sceneweaver.critic import kinds
from sceneweaver.critic.groups import COUNTERS
from sceneweaver.render.instances import hidden_with
from sceneweaver.render.viewpoints import corner_directions, cut_walls, opposite
from sceneweaver.scene import Scene, SceneObject

KEYS = 3
"""Pieces that a room is known by: those with the largest faces."""

BEHIND = -0.3
"""Cosine between the front of a piece and the way to the camera below which it is seen from behind."""

WITH_FRONT = kinds.WALL_BACKED | kinds.LOUNGE | kinds.TVS | kinds.DESKS | kinds.BEDS | COUNTERS
"""What has a side that is looked at."""


def views(scene: Scene) -> list[tuple[np.ndarray, set[str]]]:
    """For both pictures from corners the way to the camera [2] and the ids of what is left out."""
    ways = corner_directions(scene)
    return [(way, hidden_with(scene, cut_walls(scene, way))) for way in (ways[0], opposite(ways))]


def key_pieces(scene: Scene) -> list[SceneObject]:
    """The pieces that a room is known by."""
    found = [o for o in scene.objects if o.category in WITH_FRONT and o.mount in ("floor", "wall")]
    return sorted(found, key=lambda o: (-round(o.size[1] * o.size[2], 4), o.id))[:KEYS]


def hidden_keys(room: Room) -> Hits:
    """Key pieces that neither picture shows from the front or the side."""
    pieces, both = key_pieces(room.survey.scene), views(room.survey.scene)
    lost = [o.id for o in pieces if all(_lost(o, way, gone) for way, gone in both)]
    return Hits(len(lost), len(pieces), tuple(lost))


def _lost(o: SceneObject, way: np.ndarray, gone: set[str]) -> bool:
    return o.id in gone or float(np.dot(o.pose.frame.axis, way)) < BEHIND


def lights_hidden(room: Room) -> Hits:
    """Rooms in which a lamp of the ceiling is drawn, though the ceiling is not, or that no lamp of their own lights."""
    scene = room.survey.scene
    lamps = [o for o in scene.objects if "lighting" in kinds.groups_of(o.category)]
    floating, dark = [], not lamps
    for _, gone in views(scene):
        floating += [o.id for o in scene.objects if o.mount == "ceiling" and o.id not in gone]
        dark = dark or all(o.id in gone and o.mount != "ceiling" for o in lamps)
    names = tuple(dict.fromkeys(floating)) + (("no lamp",) if dark else ())
    return Hits(int(bool(names)), 1, names)
