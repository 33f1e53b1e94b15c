"""Lights, cameras and named frames of a USD stage.

Lights are as bright as renderers want them for which white is 1 (Blender, Karma, Storm). Isaac Sim exposes for lights
a thousand times as bright, unless its exposure is automatic, which `AUTO_EXPOSURE` asks for.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

import numpy as np

from sceneweaver.assets import Mesh
from sceneweaver.geometry.rotations import from_matrix
from sceneweaver.geometry.walls import Wall
from sceneweaver.physics.frames import Frame, View
from sceneweaver.scene import Room

from .usd_layer import Prim, attribute, attributes, place, prim, prim_names, triple, usd
from .usd_looks import LAMP

AUTO_EXPOSURE = {"renderSettings": {"rtx:post:histogram:enabled": True}}
"""Custom data of a layer by which Isaac Sim sets its exposure by what it sees."""

_SKY, _SUN, _LAMP = 1.0, 3.0, 4.0  # radiance, irradiance, and intensity of a lamp of any size
_SUN_ANGLE = 1.5  # [degree] that it covers: soft edges of shadows
_HEIGHT = math.radians(36.0)  # of the sun over the horizon
_FILM = 36.0  # [mm], width of the sensor
_ASPECT = 4 / 3  # of the pictures that cameras take


def add_lights(parent: Prim, room: Room) -> None:
    """A sky all around, and a sun that shines through the windows of the wall that has most."""
    x, y = room.outline[0]
    light(parent, _to_the_sun(room), (float(x), float(y), 2 * room.height))


def light(parent: Prim, toward: np.ndarray, position: tuple[float, float, float]) -> None:
    """A sky all around, and a sun in a unit direction [3], whose prim stands at a position."""
    sky = prim(parent, "Sky", "DomeLight")
    attributes(sky, {"inputs:intensity": ("Float", _SKY), "inputs:color": ("Color3f", (0.94, 0.97, 1.0))})
    sun = prim(parent, "Sun", "DistantLight")
    shown = {"inputs:intensity": _SUN, "inputs:angle": _SUN_ANGLE}
    attributes(sun, {key: ("Float", value) for key, value in shown.items()})
    attribute(sun, "inputs:color", "Color3f", (1.0, 0.93, 0.82))
    # A distant light shines along its -z.
    side = np.cross((0.0, 0.0, 1.0), toward)
    side /= np.linalg.norm(side)
    turn = from_matrix(np.column_stack([side, np.cross(toward, side), toward]))
    place(sun, position, turn)


def add_lamp(parent: Prim, mesh: Mesh, scale: Sequence[float]) -> None:
    """A light in the middle of what glows of a mesh, where something does; it goes through shades."""
    glowing = np.array([m.emission >= LAMP for m in mesh.materials], dtype=bool)[mesh.face_material]
    if not glowing.any():
        return
    points = mesh.vertices[np.unique(mesh.faces[glowing])] * np.asarray(scale)
    low, high = points.min(axis=0), points.max(axis=0)
    made = prim(parent, "Light", "SphereLight", ["ShadowAPI"])
    values = {"inputs:radius": float(max(0.02, (high - low).min() / 4)), "inputs:intensity": _LAMP}
    attributes(made, {key: ("Float", value) for key, value in values.items()})
    attribute(made, "inputs:color", "Color3f", (1.0, 0.84, 0.65))
    attribute(made, "inputs:normalize", "Bool", True)  # as bright, however large
    attribute(made, "inputs:shadow:enable", "Bool", False)
    attribute(made, "xformOp:translate", "Double3", triple((low + high) / 2))
    attribute(made, "xformOpOrder", "TokenArray", ["xformOp:translate"], uniform=True)


def add_cameras(parent: Prim, found: Iterable[View]) -> None:
    """Cameras; names as `room:eye-door` are kept for display."""
    names = prim_names()
    for view in found:
        made = prim(parent, names(view.name.removeprefix("room:").replace("-", "_")), "Camera", displayName=view.name)
        place(made, view.position, view.quaternion)
        tall = _FILM / _ASPECT
        values = {
            "horizontalAperture": _FILM,
            "verticalAperture": tall,
            "focalLength": tall / 2 / math.tan(view.angle / 2),
            "focusDistance": float(np.linalg.norm(view.position)),
        }
        attributes(made, {key: ("Float", value) for key, value in values.items()})
        attribute(made, "clippingRange", "Float2", (0.05, 100.0))


def add_frames(parent: Prim, frames: Sequence[Frame]) -> None:
    """Frames below a body or the room: their kind, name and the size of the box that they mark are custom data."""
    names = prim_names(*(child.name for child in parent.nameChildren))
    for frame in frames:
        last = frame.name.rpartition(f":{frame.kind}:")[2]
        made = prim(parent, names(f"{frame.kind}_{last}"), displayName=frame.name)
        place(made, frame.position, frame.quaternion)
        facts = {"frame": frame.kind, "name": frame.name, "size": usd().Gf.Vec3d(*(2 * half for half in frame.half))}
        made.SetInfo("customData", {"sceneweaver": facts})


def _to_the_sun(room: Room) -> np.ndarray:
    """The unit direction [3] to the sun: behind the wall with most glass, a little aslant, so that bars draw lines."""
    glass = [sum(w.width * w.height for w in room.windows if w.wall == k) for k in range(len(room.outline))]
    return sun_behind(room.walls[int(np.argmax(np.round(glass, 6)))] if max(glass) > 0 else None)


def sun_behind(wall: Wall | None) -> np.ndarray:
    """The unit direction [3] to a sun that shines through a wall, or through none."""
    if wall is None:
        toward = np.array([-0.30, 0.34, 1.3])
    else:
        slant = np.asarray(wall.outward) + 0.42 * np.asarray(wall.along)
        toward = np.array([*(slant / np.linalg.norm(slant)), math.tan(_HEIGHT)])
    return toward / np.linalg.norm(toward)
