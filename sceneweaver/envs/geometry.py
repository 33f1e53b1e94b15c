"""What tasks ask of a scene, as geometry in the frames of its bodies: grasps, interiors, surfaces, doors.

Bodies of an object and of its links share the object's frame while everything is closed (see `sceneweaver.physics`), so
that a point of an asset, in the object's size, is a point of the body that carries it.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from sceneweaver.assets.placed import Load, loader
from sceneweaver.physics.things import Joint, Thing, things_of
from sceneweaver.scene import Scene

Array = np.ndarray

OPENING = 0.08
"""How far the drawn robots' fingers open [m]."""

_SPARE = 0.006  # [m] between open fingers and what they close around, both sides together
_DEPTH = 0.025  # [m] by which fingertips reach below the top of what they hold
_AROUND = 12  # places on a round rim
_WALL = 0.006  # [m] thickness of the wall of a vessel, about
_DOWN = np.array([0.0, 0.0, -1.0])


@dataclass(frozen=True)
class Articulation:
    """A door, lid or drawer: the ``name`` of its body and joint, its piece, what it is, and how it moves against it."""

    name: str
    object: str
    role: str
    joint: Joint

    @property
    def slides(self) -> bool:
        """Whether it is a drawer or the like, and not on a hinge."""
        return self.joint.kind == "slide"

    @property
    def open_end(self) -> float:
        """The end that is farther from closed."""
        return max(self.joint.limits, key=abs)


@dataclass(frozen=True)
class GraspFrame:
    """Where a parallel gripper takes hold, in the frame of ``body``; see `sceneweaver.assets.Grasp`."""

    name: str
    body: str
    position: Array
    approach: Array
    closing: Array
    width: float


@dataclass(frozen=True)
class Interior:
    """A box, or the ellipse in its plan, that holds things, in the frame of ``body``."""

    name: str
    body: str
    low: Array
    high: Array
    entry: Array
    oval: bool


@dataclass(frozen=True)
class SupportSurface:
    """A surface that things stand on, in the frame of ``body``: its plan ``outline`` [K, 2], the corners ``low`` and
    ``high`` [2] of its box, ``z`` [m]."""

    name: str
    body: str
    low: Array
    high: Array
    z: float
    outline: Array


@dataclass(frozen=True)
class Item:
    """An object or what can be taken out of one.

    Attributes:
        name: Of its body.
        category: What it is.
        free: Whether it moves by itself.
        low, high: Corners [3] of its box in its frame, everything closed.
        mass: With all that moves on it [kg].
    """

    name: str
    category: str
    free: bool
    low: Array
    high: Array
    mass: float

    @property
    def centre(self) -> Array:
        """The middle of its box [3] in its frame."""
        return (self.low + self.high) / 2

    @property
    def size(self) -> Array:
        """Extents [3] of its box."""
        return self.high - self.low


class SceneGeometry:
    """All of this for one scene; each list is in the order of the scene's objects.

    Args:
        scene: The scene.
        load: From asset id to asset; None: the library of this user.
        loose: As in `things_of`.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver.envs import SceneGeometry
        >>> geometry = SceneGeometry(sw.Scene.example("bedroom"))
        >>> geometry.items["bed"].free
        True
    """

    def __init__(self, scene: Scene, load: Load | None = None, *, loose: bool = True) -> None:
        """Load the assets of the scene."""
        self.scene = scene
        self.things: list[Thing] = things_of(scene, loader(load), loose=loose)
        self.items: dict[str, Item] = {}
        self.articulations: dict[str, Articulation] = {}
        self.grasps: dict[str, list[GraspFrame]] = {}
        self.interiors: list[Interior] = []
        self.surfaces: list[SupportSurface] = []
        for thing in self.things:
            self._add_bodies(thing)
            self._add_asset(thing)

    def leaf_of(self, joint: str) -> list[Array]:
        """Points [V, 3] of the parts of a door's or drawer's body but its handles, in the object's frame, closed."""
        bodies = (body for thing in self.things for body in thing.bodies if body.name == joint)
        solids = next(bodies).solids
        return [np.asarray(s.points) for s in solids if not s.handle] or [np.asarray(s.points) for s in solids]

    def interior(self, body: str, name: str) -> Interior:
        """The interior of that name that a body carries."""
        return next(one for one in self.interiors if (one.body, one.name) == (body, name))

    def surface(self, body: str, name: str) -> SupportSurface:
        """The surface of that name that an object has."""
        return next(one for one in self.surfaces if (one.body, one.name) == (body, name))

    @cached_property
    def owner(self) -> dict[str, str]:
        """Which object each body belongs to."""
        return {body.name: thing.object.id for thing in self.things for body in thing.bodies}

    def _add_bodies(self, thing: Thing) -> None:
        base, *others = thing.bodies
        moved = sum(body.mass for body in others if not body.loose)
        points = [s.points for body in thing.bodies if not body.loose for s in body.solids]
        self.items[base.name] = _item(base.name, thing.object.category, thing.free, points, base.mass + moved)
        for body in others:
            assert body.link is not None
            if body.joint is None:
                solids = [s.points for s in body.solids]
                self.items[body.name] = _item(body.name, body.link.category, True, solids, body.mass)
                continue
            self.articulations[body.name] = Articulation(body.name, base.name, body.link.role, body.joint)

    def _add_asset(self, thing: Thing) -> None:
        names = {body.number: body.name for body in thing.bodies}
        for top in thing.object.surfaces:
            plan = np.asarray(top.polygon)
            low, high = plan.min(axis=0), plan.max(axis=0)
            self.surfaces.append(SupportSurface(top.name, thing.object.id, low, high, top.z, plan))
        if thing.asset is None:
            return
        scale = np.asarray(thing.scale)
        for grasp in thing.asset.grasps:
            body = names[thing.body_of(grasp.link)]
            approach, closing = np.asarray(grasp.approach), np.asarray(grasp.closing)
            width = grasp.width * float(np.linalg.norm(closing * scale))
            frame = GraspFrame(grasp.name, body, np.asarray(grasp.position) * scale, approach, closing, width)
            self.grasps.setdefault(body, []).append(frame)
        for inside in thing.asset.interiors:
            low, high = np.asarray(inside.low) * scale, np.asarray(inside.high) * scale
            body = names[thing.body_of(inside.link)]
            self.interiors.append(Interior(inside.name, body, low, high, np.asarray(inside.entry), inside.oval))


def _item(name: str, category: str, free: bool, solids: list[Array], mass: float) -> Item:
    points = np.concatenate(solids) if solids else np.zeros((1, 3))
    return Item(name, category, free, points.min(axis=0), points.max(axis=0), mass)


def grasps_of(geometry: SceneGeometry, body: str) -> list[GraspFrame]:
    """Grasps of a body in its frame, the best first; empty: a hand of 8 cm cannot hold it.

    A thing whose asset names none is taken from above: a vessel by its rim, any other across its narrow side.
    """
    given = [frame for frame in geometry.grasps.get(body, ()) if frame.width < OPENING - _SPARE]
    if given or body not in geometry.items:
        return given
    item = geometry.items[body]
    found = []
    vessels = [one for one in geometry.interiors if one.body == body and one.entry[2] > 0.9]
    for vessel in vessels:
        found += _rim(vessel, item.high[2])
    for axis in np.argsort(item.size[:2]):
        width = float(item.size[axis])
        if width < OPENING - _SPARE:
            height = max(item.high[2] - _DEPTH, (item.low[2] + item.high[2]) / 2)
            position = np.array([*item.centre[:2], height])
            found.append(GraspFrame("top", body, position, _DOWN, np.eye(3)[axis], width))
    return found


def _rim(vessel: Interior, top: float) -> list[GraspFrame]:
    """Around the rim of a vessel: one finger inside, the other outside."""
    half, middle = (vessel.high - vessel.low)[:2] / 2, (vessel.high + vessel.low)[:2] / 2
    if half.min() < 0.02:  # no room for a finger
        return []
    found = []
    angles = np.arange(_AROUND if vessel.oval else 4) * 2 * np.pi / (_AROUND if vessel.oval else 4)
    for angle in angles:
        out = np.array([np.cos(angle), np.sin(angle)])
        edge = middle + half * out
        position = np.array([*edge, top - _DEPTH])
        found.append(GraspFrame("rim", vessel.body, position, _DOWN, np.append(out, 0.0), _WALL))
    return found
