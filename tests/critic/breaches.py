"""Rooms of plain boxes, and which design rules they break on which objects."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from sceneweaver.critic.design import faults
from sceneweaver.critic.survey import Survey
from sceneweaver.language import SceneGraph
from sceneweaver.scene import Door, Room, Scene, SceneObject, Support, Window
from tests.critic import measuring, rooms
from tests.reports import empty_report


def box(object_id: str, size: tuple[float, float, float], x: float, y: float, yaw: float = 0.0, **more: Any) -> Any:
    """A box of the category before the dash of its id, which nobody asked for; yaw in degrees."""
    look = {k: more.pop(k) for k in ("material", "color", "style") if k in more}
    made = measuring.box(object_id, size, x, y, yaw, **{"intent": {}, **more})
    return made.model_copy(update={"attributes": look}) if look else made


def hung(
    object_id: str, size: tuple[float, float, float], x: float, y: float, yaw: float, z: float, **more: Any
) -> Any:
    """A box on a wall."""
    return box(object_id, size, x, y, yaw, z=z, mount="wall", **more)


def lamp(object_id: str, x: float, y: float, bottom: float = 2.3) -> Any:
    """A lamp at the ceiling whose lower end is at a height [m]."""
    return box(object_id, (0.4, 0.4, rooms.HEIGHT - bottom), x, y, z=bottom, mount="ceiling")


def on(base: SceneObject, object_id: str, size: tuple[float, float, float] = (0.2, 0.2, 0.1), **look: Any) -> Any:
    """A box on the top of another."""
    x, y, z = base.pose.position
    support = Support(object=base.id, surface="top")
    return box(object_id, size, x, y, z=z + base.size[2], mount="surface", support=support, **look)


def top(base: SceneObject) -> SceneObject:
    """The object with a surface on its top."""
    return measuring.carrier(base)


def room(width: float = 6.0, depth: float = 5.0, *, door: float = 0.3, window: float | None = 2.0) -> Room:
    """A rectangle; the door is in the wall y = 0, the window, 1.6 m wide, in the wall opposite, both by x [m]."""
    sill, high = 0.9, 1.3
    windows = (
        ()
        if window is None
        else (Window(id="window-0", wall=2, offset=width - window - 1.6, width=1.6, sill=sill, height=high),)
    )
    return Room(
        type="room",
        outline=((0, 0), (width, 0), (width, depth), (0, depth)),
        height=rooms.HEIGHT,
        windows=windows,
        doors=(Door(id="door-0", wall=0, offset=door, width=0.9, height=2.05, swing="in-left"),),
    )


def survey(kind: str, objects: Iterable[SceneObject], space: Room | None = None, **scene: Any) -> Survey:
    """A room of a kind as the checks see it; nobody judged it."""
    made = Scene(id=kind, room=space or room(), objects=tuple(objects), **scene)
    return Survey.of(made, empty_report(), rooms.kind(kind, []), SceneGraph(text=""))


def broken(rule: str, kind: str, objects: Iterable[SceneObject], space: Room | None = None, **scene: Any) -> set[str]:
    """The objects of the breaches of a rule; {""} for a breach about the room."""
    found = [f.fault for f in faults(survey(kind, objects, space, **scene)) if f.fault.rule == rule]
    return {name for fault in found for name in fault.objects or ("",)}
