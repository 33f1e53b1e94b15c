"""Small rooms with plain boxes, and what the critic measures of a request for them."""

from __future__ import annotations

import math
from typing import Any

from sceneweaver.critic import Alignment, ItemOutcome
from sceneweaver.critic.asked import alignment, measured
from sceneweaver.critic.survey import Survey
from sceneweaver.language import SceneGraph
from sceneweaver.scene import Door, Intent, Part, Pose, Room, Scene, SceneObject, Support, Surface, Window
from tests.critic.rooms import BEDROOM
from tests.reports import empty_report

ROOM = Room(
    type="bedroom",
    outline=((0, 0), (6, 0), (6, 5), (0, 5)),
    height=2.6,
    doors=(Door(id="door-0", wall=0, offset=0.3, width=0.9, height=2.05, swing="in-left"),),
    windows=(Window(id="window-0", wall=2, offset=2.0, width=1.6, sill=0.9, height=1.3),),
)
"""6 x 5 m; the door in the wall y = 0 at x = 0.3 to 1.2, the window in the wall y = 5 at x = 2.4 to 4."""

BED, TABLE, CHAIR, RUG, LAMP, SOFA = (
    (2.0, 1.6, 0.5),
    (0.9, 1.8, 0.75),
    (0.5, 0.5, 0.9),
    (2.0, 3.0, 0.01),
    (0.3, 0.3, 1.5),
    (0.9, 2.0, 0.8),
)
"""Sizes [m]: depth, width, height."""


def box(
    object_id: str,
    size: tuple[float, float, float],
    x: float,
    y: float,
    yaw: float = 0.0,
    z: float = 0.0,
    **more: Any,
) -> SceneObject:
    """A box of the category before the dash of its id, which stands for the entity of that name; yaw in degrees."""
    category = object_id.rsplit("-", 1)[0]
    more.setdefault("intent", Intent(request=category))
    pose = Pose.from_yaw(x, y, z, math.radians(yaw))
    return SceneObject(id=object_id, category=category, size=size, pose=pose, **more)


def on(base: SceneObject, object_id: str, size: tuple[float, float, float], inner: bool = False) -> SceneObject:
    """A box on the top of another, or on its inner board."""
    (x, y, _), z = base.pose.position, 0.1 if inner else base.size[2]
    support = Support(object=base.id, surface="board" if inner else "top")
    return box(object_id, size, x, y, z=z, mount="surface", support=support)


def carrier(base: SceneObject, inner: bool = False) -> SceneObject:
    """The object with a surface on its top, and with one inside."""
    d, w, h = base.size
    corners = ((-d / 2, -w / 2), (d / 2, -w / 2), (d / 2, w / 2), (-d / 2, w / 2))
    surfaces = [Surface(name="top", polygon=corners, z=h, headroom=None)]
    if inner:
        surfaces.append(Surface(name="board", polygon=corners, z=0.1, headroom=0.5))
    return base.model_copy(update={"surfaces": tuple(surfaces)})


def legs(base: SceneObject) -> SceneObject:
    """The object as a top on four legs, open below."""
    d, w, h = base.size

    def prism(x: float, y: float, half: tuple[float, float], z: tuple[float, float]) -> Part:
        a, b = half
        return Part(polygon=((x - a, y - b), (x + a, y - b), (x + a, y + b), (x - a, y + b)), z=z)

    feet = [
        prism(i * (d / 2 - 0.03), j * (w / 2 - 0.03), (0.03, 0.03), (0.0, h - 0.05)) for i in (-1, 1) for j in (-1, 1)
    ]
    return base.model_copy(update={"parts": (*feet, prism(0.0, 0.0, (d / 2, w / 2), (h - 0.05, h)))})


def graph(objects: tuple[SceneObject, ...], *relations: dict[str, Any], **data: Any) -> SceneGraph:
    """A request for the objects of a scene, each category once with its count."""
    names = dict.fromkeys(o.category for o in objects)
    entities = [
        {"id": n, "noun": n, "category": n, "count": (k, k)}
        for n in names
        if (k := sum(o.category == n for o in objects))
    ]
    return SceneGraph.model_validate({"text": "", "entities": entities, "relations": relations, **data})


def survey(objects: tuple[SceneObject, ...], brief: SceneGraph, room: Room = ROOM) -> Survey:
    """The scene as the checks see it; nobody judged it."""
    scene = Scene(id="made", room=room, objects=objects)
    return Survey.of(scene, empty_report(), BEDROOM, brief)


def aligned(objects: tuple[SceneObject, ...], brief: SceneGraph, room: Room = ROOM) -> Alignment:
    """What became of each item."""
    return alignment(measured(survey(objects, brief, room)))


def relation(*objects: SceneObject, room: Room = ROOM, **said: Any) -> ItemOutcome:
    """What became of one stated relation."""
    return aligned(objects, graph(objects, {"id": "it", **said}), room).of("it")


def holds(*objects: SceneObject, room: Room = ROOM, **said: Any) -> bool:
    """Whether a stated relation is met."""
    outcome = relation(*objects, room=room, **said)
    assert outcome.status in ("met", "unmet"), outcome
    return outcome.status == "met"
