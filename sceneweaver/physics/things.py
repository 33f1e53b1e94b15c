"""Objects as a simulator sees them: rigid bodies with collision parts, masses and joints, in each object's own frame.

Every writer of a simulator's files starts from here, so that all of them agree on what moves and what it weighs.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Literal

import numpy as np

from sceneweaver.assets import Asset, Link, categories
from sceneweaver.assets.carrying import is_hook
from sceneweaver.assets.placed import Load, loader, scaled_asset
from sceneweaver.assets.roles import with_role
from sceneweaver.scene import Scene, SceneObject

from .hulls import solids_of
from .inertia import Inertia, inertia_of, shares_of
from .solids import Solid

_DENSITY = 150.0  # [kg/m3] of an object's parts, when neither an asset nor its category says what it weighs
_LIGHTEST = 1e-3  # [kg]
_LID_SHARE = 0.25  # of a thing's mass that a lid on a hinge has at most
_HELD = (math.inf, math.inf)  # [N m] and [N] that hold hinges and slides at most: no limit
_HELD_SHARE = 0.25  # the same, of what tips or pushes the base; damping brings as much again at 1 rad/s
_GRAVITY = 9.81  # [m/s2]


@dataclass(frozen=True, eq=False)
class Joint:
    """How a body moves against another, of which it shares the frame when closed, at 0.

    Attributes:
        kind: A hinge turns about the axis, a slide goes along it.
        axis: Unit vector [3]; ``anchor`` [3] is a point on the axis [m].
        limits: Lower and upper end [rad] or [m].
        hold: Friction and damping at once, [N m] or [N]: it keeps the body where it is against the little that a tilt
            or a hinge below brings, and a hand moves it with ease.
    """

    kind: Literal["hinge", "slide"]
    axis: np.ndarray
    anchor: np.ndarray
    limits: tuple[float, float]
    hold: float

    @classmethod
    def of(
        cls, link: Link, scale: tuple[float, float, float], mass: float, most: tuple[float, float] = _HELD
    ) -> Joint | None:
        """The joint of a door, drawer or control of that mass [kg]; None for what hangs on nothing.

        ``scale`` is that of the object: a drawer of a deeper one comes out farther. ``most`` limits what holds it, of
        hinges [N m] and of slides [N].
        """
        if link.joint == "free":
            return None
        slides = link.joint == "slide"
        axis = np.asarray(link.axis, dtype=float) * (np.asarray(scale) if slides else 1.0)
        stretch = float(np.linalg.norm(axis)) if slides else 1.0
        low, high = (float(end) * stretch for end in link.limits)
        if link.role == "control":
            hold = max(0.5, 15.0 * mass) if slides else 0.02  # a button carries its own weight
        else:
            hold = max(1.0, 2.0 * mass) if slides else max(0.2, 0.5 * mass)
        anchor = np.asarray(link.anchor) * np.asarray(scale)
        return cls(link.joint, axis / np.linalg.norm(axis), anchor, (low, high), min(hold, most[slides]))


@dataclass(frozen=True)
class RigidBody:
    """What moves as one: the base of a thing (number 0), or what its link of that number moves.

    Attributes:
        name: The object's id for the base, ``<id>.<link>`` for the others; no two of a scene are alike.
        number: 0, or the number of the link, from 1; as in `Solid.link` and ``Mesh.face_link``.
        link: How it moves against the base; None for the base. A free one ("item") hangs on nothing.
        mass: In kg.
        solids: Its collision parts, in the object's frame.
        joint: Of a door, drawer or control, in the size of the object; None: it hangs on nothing, or is the base.
    """

    name: str
    number: int
    link: Link | None
    mass: float
    solids: tuple[Solid, ...]
    joint: Joint | None = None

    @property
    def loose(self) -> bool:
        """Whether it only lies on the rest and can be taken."""
        return self.link is not None and self.joint is None

    @property
    def inertia(self) -> Inertia:
        """In the object's frame, the mass spread over the parts by volume."""
        return inertia_of(self.solids, shares_of(self.solids, self.mass))


@dataclass(frozen=True)
class Thing:
    """An object with what a simulator needs: its parts (in its frame), mass [kg], friction, and whether it may move.

    ``key`` is equal for things with equal bodies, ``shape`` for those that differ at most in finish; ``scale`` [3]
    brings the asset to the object's size. ``welded`` says that what could be taken off it is part of its base.
    """

    object: SceneObject
    asset: Asset | None
    key: str
    shape: str
    scale: tuple[float, float, float]
    solids: tuple[Solid, ...]
    mass: float
    friction: float
    free: bool
    welded: bool = False

    @cached_property
    def bodies(self) -> tuple[RigidBody, ...]:
        """The base and what its links move; a link without collision parts belongs to the base."""
        links = self.asset.links if self.asset is not None else ()
        mine: dict[int, list[Solid]] = {0: []}
        for solid in self.solids:
            mine.setdefault(self.body_of(solid.link), []).append(solid)
        masses = self._masses(mine)
        found = [RigidBody(self.object.id, 0, None, masses[0], tuple(mine[0]))]
        for number in sorted(mine)[1:]:
            link, mass = links[number - 1], masses[number]
            joint = Joint.of(link, self.scale, mass, self._most_held(number, masses[0], mine))
            found.append(RigidBody(f"{self.object.id}.{link.name}", number, link, mass, tuple(mine[number]), joint))
        return tuple(found)

    @cached_property
    def face_body(self) -> np.ndarray:
        """The number of the body of each face of the asset's mesh, int32 [F]."""
        assert self.asset is not None
        numbers = [0, *(self.body_of(link) for link in range(1, len(self.asset.links) + 1))]
        return np.asarray(numbers, dtype=np.int32)[self.asset.mesh.face_link]

    def body_of(self, link: int) -> int:
        """The number of the body that a part or face of link ``link`` belongs to."""
        if link and self.welded and self.asset is not None and self.asset.links[link - 1].joint == "free":
            return 0
        return link if link in self._moving else 0

    @cached_property
    def _moving(self) -> frozenset[int]:
        return frozenset(solid.link for solid in self.solids)

    def _most_held(self, number: int, mass: float, mine: dict[int, list[Solid]]) -> tuple[float, float]:
        """What may hold a hinge [N m] or slide [N] of a piece whose base has a ``mass`` [kg]; ``mine``: parts by body.

        A hand that opens a lid pulls the base along by what holds the lid: that stays below what would tip the base
        over its nearest edge, with the hand at the far end of the lid, or push it over the floor.
        """
        if not self.free or self.asset is None or not mine[0]:
            return _HELD
        link, scale = self.asset.links[number - 1], np.asarray(self.scale)
        base = np.concatenate([solid.points for solid in mine[0]])[:, :2]
        half, weight = float(np.ptp(base, axis=0).min()) / 2, _HELD_SHARE * mass * _GRAVITY
        axis = np.asarray(link.axis) / np.linalg.norm(link.axis)
        anchor = np.asarray(link.anchor) * scale
        out = np.concatenate([solid.points for solid in mine[number]]) - anchor
        reach = float(np.linalg.norm(out - np.outer(out @ axis, axis), axis=1).max())
        height = max(float(anchor[2]), 0.0) + float(np.hypot(*axis[:2])) * reach
        return weight * half * reach / max(height, reach), weight * self.friction

    def _masses(self, mine: dict[int, list[Solid]]) -> dict[int, float]:
        """Of each body [kg]: as the asset says, else by the volume of its parts.

        What lids weigh above their share is in the base: a box with a heavier lid falls over when that is open.
        """
        found = self._drawn_masses(mine)
        total, links = sum(found.values()), self.asset.links if self.asset is not None else ()
        for number in [n for n in found if n and links[n - 1].role == "lid" and links[n - 1].joint == "hinge"]:
            lighter = min(found[number], _LID_SHARE * total)
            found[0] += found[number] - lighter
            found[number] = lighter
        return found

    def _drawn_masses(self, mine: dict[int, list[Solid]]) -> dict[int, float]:
        given = self.asset.masses if self.asset is not None else ()
        if given:
            found = dict.fromkeys(mine, 0.0)
            for link, mass in enumerate(given):
                found[self.body_of(link)] += mass
            share = self.mass / max(sum(given), 1e-9)
            return {number: max(mass * share, _LIGHTEST) for number, mass in found.items()}
        volume = {number: sum(s.volume for s in solids) for number, solids in mine.items()}
        total = sum(volume.values())
        return {number: max(self.mass * v / total, _LIGHTEST) for number, v in volume.items()}


def things_of(scene: Scene, load: Load | None = None, *, loose: bool = True) -> list[Thing]:
    """All objects, in their order; each asset is loaded once.

    Args:
        scene: The scene.
        load: From asset id to asset; None: the library of this user.
        loose: Whether fruit in a bowl, books of a stack and the like are bodies of their own; else each such thing is
            one body, which is quicker.
    """
    load, bodies = loader(load), {}
    return [replace(_thing(k, o, load, bodies), welded=not loose) for k, o in enumerate(scene.objects)]


def moving_links(asset: Asset) -> frozenset[int]:
    """Numbers of the links of an asset that are bodies of their own in a thing: those that have collision parts."""
    found = frozenset(hull.link for hull in asset.hulls)
    return found - {0} if 0 in found else frozenset()


def is_fixture(thing: SceneObject) -> bool:
    """Whether it stands still: it is fixed, hangs on a wall or ceiling or from a hook, or is built in."""
    named = thing.category.strip().lower().replace(" ", "_") in with_role("built_in")
    hangs = thing.support is not None and is_hook(thing.support.surface)
    return thing.fixed or thing.mount in ("wall", "ceiling") or hangs or named


def _thing(index: int, thing: SceneObject, load: Load, bodies: dict[str, tuple[Solid, ...]]) -> Thing:
    asset, scale = scaled_asset(index, thing, load)
    size = "" if scale == (1, 1, 1) else f"*{' '.join(f'{v:.9g}' for v in scale)}"
    key = f"parts:{thing.id}" if thing.asset is None else f"{thing.asset}{size}"
    shape = key if asset is None else f"{asset.geometry}{size}"
    if shape not in bodies:
        bodies[shape] = tuple(solids_of(thing, asset, np.asarray(scale)))
    solids = bodies[shape]
    mass, friction = _weight(thing, asset, float(np.prod(scale)), sum(s.volume for s in solids))
    return Thing(thing, asset, key, shape, scale, solids, mass, friction, not is_fixture(thing))


def _weight(thing: SceneObject, asset: Asset | None, scale: float, volume: float) -> tuple[float, float]:
    """Mass [kg] and friction: of the asset, else of the category, else by the volume of the parts."""
    if asset is not None:
        return max(asset.mass * scale, _LIGHTEST), asset.friction
    kind = categories().get(thing.category.strip().lower().replace(" ", "_"))
    if kind is not None:
        return math.sqrt(kind.mass[0] * kind.mass[1]), kind.friction
    return max(_DENSITY * volume, _LIGHTEST), 0.5
