"""Lays an arrangement out on one support: each thing at its place, beside another, upon it, or before a chair."""

from __future__ import annotations

import math
import random
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any

import numpy as np

from sceneweaver.assets import Asset
from sceneweaver.geometry.polygons import counter_clockwise
from sceneweaver.geometry.se2 import SE2
from sceneweaver.knowledge.lived_in import CLUTTER
from sceneweaver.knowledge.surfaces import Arrangement, Slot
from sceneweaver.scene import Relation, SceneObject, Support, Surface

from .surface_assets import OPEN, Shelf, placed
from .surface_geometry import EDGE, GAP, Array, Field
from .surface_places import Spread, seat_places, surfaces_of
from .surface_scene import Frame, Seat, Surroundings

SHIFT = 0.12
"""How far [m] a thing beside a plate may move to where there is room."""

FLAT = 0.02
"""Height [m] up to which a thing without a surface, such as a mouse pad, carries others on its top."""


@dataclass(frozen=True)
class Asked:
    """Something that was asked for by name; ``look`` are colour, material, style, words."""

    category: str
    look: dict[str, str] = field(default_factory=dict)


@dataclass
class Standing:
    """Something that was placed: its body and where, in the support's frame [m, rad]."""

    slot: str
    seat: str | None
    object: SceneObject
    asset: Asset
    surface: Surface
    at: Array
    yaw: float


@dataclass
class Layout:
    """What one support got."""

    objects: list[SceneObject] = field(default_factory=list)
    relations: list[Relation] = field(default_factory=list)
    missing: list[str] = field(default_factory=list)
    unplaced: list[Asked] = field(default_factory=list)


class Layer:
    """Lays out one support; make one, then call ``run``."""

    def __init__(
        self,
        around: Surroundings,
        shelf: Shelf,
        support: SceneObject,
        arrangement: Arrangement,
        dice: random.Random,
        clutter: float = CLUTTER,
        looks: Mapping[str, dict[str, str]] = MappingProxyType({}),
    ):
        """``looks`` are colour, material, style and words of the things of some slots."""
        self._looks = looks
        self._around, self._shelf, self._support = around, shelf, support
        self._plan, self._dice, self._clutter = arrangement, dice, clutter
        self._seats = around.seats(support)
        each = any(slot.each for slot in arrangement.slots)
        back = arrangement.user == "back"
        if self._seats and not each:  # the user is where the chair is
            back = float(np.mean([s.place[0] for s in self._seats])) < -0.2 * support.size[0]
        self._frame: Frame = around.frame(support, back)
        self._turn = math.pi if back else 0.0
        outer = around.outer_side(support)
        self._mirror = dice.random() < 0.5 if outer == 0 else outer < 0
        self._surfaces = surfaces_of(support, back, arrangement.top)
        self._fields: dict[str, Field] = {}
        self._cover: dict[str, float] = {}
        self._standing: list[Standing] = []
        self._by_id: dict[str, str] = {}
        self.done = Layout()

    def run(self, asked: Sequence[Asked] = ()) -> Layout:
        """Lay out the slots in order, those asked for whatever their chance, then what no slot is meant for."""
        rest = list(asked)
        for slot in sorted(self._plan.slots, key=lambda s: s.need == "optional"):
            one = next((a for a in rest if a.category in slot.what), None)
            if one is None and (slot.clutter > self._clutter or not self._chosen(slot)):
                continue
            if slot.by is not None and one is None and not any(s.slot == slot.by for s in self._standing):
                continue
            if one is None and self._there_already(slot):
                continue
            if slot.only and not any(s.slot == slot.by and s.asset.category in slot.only for s in self._standing):
                continue
            if slot.on is not None and not any(s.slot == slot.on for s in self._standing):
                continue
            if one is not None and slot.at is not None and sum(a.category == one.category for a in rest) > 1:
                slot = slot.model_copy(update={"at": (slot.at[0], slot.at[1] or -0.55)})  # another one beside it
            good = self._seated(slot, one) if slot.each else self._single(slot, one)
            if good and one is not None:
                rest.remove(one)
                if slot.each is None:
                    self._twins(slot, one.category, rest)
            elif not good and slot.need == "needed" and one is None:
                self.done.missing.append(slot.what[0])
        for one in rest:
            if not self._anywhere(one):
                self.done.unplaced.append(one)
        return self.done

    def _chosen(self, slot: Slot) -> bool:
        """Whether chance has a slot there; one that varies by seat is decided at each."""
        return slot.vary or self._chances(slot).random() <= slot.chance

    def _chances(self, slot: Slot) -> random.Random:
        """What decides about a slot: for a paired one the same on all such furniture of the room."""
        return self._shelf.shared(f"{self._plan.name}/{slot.id}") if slot.paired else self._dice

    def _twins(self, slot: Slot, category: str, rest: list[Asked]) -> None:
        """More of the same that was asked for stands beside the first: two screens."""
        for one in [a for a in rest if a.category == category]:
            beside = Slot(id=f"{slot.id}-{len(self._standing)}", what=(category,), need="needed", by=slot.id, gap=0.03)
            if self._single(beside, one):
                rest.remove(one)

    # one thing

    def _there_already(self, slot: Slot) -> bool:
        """Whether something near the support makes the slot needless, such as a television on the wall above it."""
        x, y, _ = self._support.pose.position
        return any(
            o.category in slot.unless and math.hypot(o.pose.position[0] - x, o.pose.position[1] - y) < 1.5
            for o in self._around.scene.objects
        ) or any(s.object.category in slot.unless for s in self._standing)

    def _single(self, slot: Slot, one: Asked | None) -> bool:
        base = next((s for s in self._standing if s.slot == slot.on), None) if slot.on else None
        surface = self._surfaces.get(slot.surface) or (self._surfaces["main"] if slot.need == "needed" else None)
        if base is not None:
            surface = _top(base)
        if surface is None:
            return False
        low, high = self._span(surface)
        if base is None and (high[0] - low[0] < slot.least[0] or high[1] - low[1] < slot.least[1]):
            return False
        return self._try(slot, one, surface, base)

    def _try(self, slot: Slot, one: Asked | None, surface: Surface, base: Standing | None) -> bool:
        ground = self._field(surface, base)
        low, high = self._span(surface)
        limit = (float(max(high - low)), float(max(high - low)), ground.headroom - 0.01)
        chances = self._chances(slot)
        spread = Spread(slot, chances, self._mirror and not slot.fixed, self._clutter)
        names = (one.category,) if one else tuple(n for n in spread.kinds() if self._around.may_add(n))
        like = next((s.asset for s in self._standing if s.slot == slot.like), None) if one is None else None
        if like is not None and like.size[2] <= limit[2] and self._around.may_add(like.category):
            return not self._full(surface, like) and self._place(slot, like, surface, base, ground, spread)
        for name in names:
            for size in (slot.size, ((0.0, 0.0), (0.0, 0.0), slot.size[2])):  # as it should be, then the smallest
                look = one.look if one else self._looks.get(slot.id)
                asset = self._shelf.draw(name, chances, size, limit, look)
                if asset is None:
                    break
                if one is None and slot.need != "needed" and not slot.on and self._full(surface, asset):
                    continue
                if self._place(slot, asset, surface, base, ground, spread):
                    return True
        return False

    def _place(
        self, slot: Slot, asset: Asset, surface: Surface, base: Standing | None, ground: Field, spread: Spread
    ) -> bool:
        shape = self._shelf.shape(asset)
        anchor = next((s for s in self._standing if s.slot == slot.by), None) if slot.by else None
        for yaw in dict.fromkeys((spread.yaw, spread.yaw - spread.stray)):  # square where it is too tight to stray
            if anchor is not None:
                goals = spread.beside(shape, yaw, anchor, self._shelf.shape(anchor.asset))
            elif base is not None:
                goals = [ground.centre]
            else:
                goals = [ground.inside(shape, yaw, spread.share) + spread.drift]
            for goal in goals:
                at = ground.find(shape, yaw, goal, slot.reach if anchor is None else min(slot.reach, 0.1))
                if at is not None:
                    self._stand(slot, asset, surface, at, yaw, base=base, anchor=anchor)
                    return True
        return False

    # before chairs

    def _seated(self, slot: Slot, one: Asked | None) -> bool:
        surface = self._surfaces["main"]
        ground = self._field(surface, None)
        if not self._seats:
            seats = self._imagined(surface) if slot.by is None or self._standing else []
        else:
            seats = self._seats
        names = (one.category,) if one else tuple(n for n in slot.what if self._around.may_add(n))
        if slot.vary and one is None:
            return any([self._for_some(slot, ground, surface, seat, names) for seat in seats])
        for name in names:
            for size in (slot.size, ((0.0, 0.0), (0.0, 0.0), slot.size[2])):  # as it should be, then the smallest
                asset = self._shelf.draw(name, self._dice, size, (1.0, 1.0, ground.headroom), one.look if one else None)
                if asset is None:
                    break
                places = self._for_all(slot, asset, ground, seats)
                last = name == names[-1] and size != slot.size and (one is not None or slot.need == "needed")
                if not last and any(p is None for p in places):
                    continue  # before every chair, or before none
                for seat, place in zip(seats, places, strict=True):
                    if place is not None:
                        self._stand(slot, asset, surface, *place, seat=seat, anchor=self._before(slot, seat))
                if any(p is not None for p in places):
                    return True
        return False

    def _for_some(self, slot: Slot, ground: Field, surface: Surface, seat: Seat, names: Sequence[str]) -> bool:
        """One of several things before a seat, or none, as chance has it there."""
        if not names or self._dice.random() > slot.chance:
            return False
        for name in self._dice.sample(names, len(names)):
            asset = self._shelf.draw(name, self._dice, slot.size, (1.0, 1.0, ground.headroom))
            place = self._for_all(slot, asset, ground, [seat])[0] if asset is not None else None
            if asset is not None and place is not None:
                self._stand(slot, asset, surface, *place, seat=seat, anchor=self._before(slot, seat))
                return True
        return False

    def _for_all(
        self, slot: Slot, asset: Asset, ground: Field, seats: Sequence[Seat]
    ) -> list[tuple[Array, float] | None]:
        """Where one of an asset goes before each seat; the field is left as it was."""
        shape, before = self._shelf.shape(asset), len(ground.taken)
        places: list[tuple[Array, float] | None] = []
        for seat in seats:
            spread = Spread(slot, self._dice, False, self._clutter)
            found = None
            anchor = self._before(slot, seat)
            if slot.by is None:
                found = seat_places(shape, ground, seat, spread.stray)
            elif anchor is not None:
                yaw = anchor.yaw + spread.stray
                for goal in spread.beside(shape, yaw, anchor, self._shelf.shape(anchor.asset)):
                    at = ground.find(shape, yaw, goal, SHIFT)
                    if at is not None:
                        found = (at, yaw)
                        break
            if found is not None:
                ground.put(shape, found[1], found[0])
            places.append(found)
        del ground.taken[before:]
        return places

    def _before(self, slot: Slot, seat: Seat) -> Standing | None:
        return next((s for s in self._standing if s.slot == slot.by and s.seat == seat.id), None)

    def _imagined(self, surface: Surface) -> list[Seat]:
        """Where people would sit at a table without chairs: at one side of it, the user's."""
        low, high = self._span(surface)
        width = float(high[1] - low[1])
        n = 1 if width < 1.0 else 2
        ys = [0.0] if n == 1 else [-0.25 * width, 0.25 * width]
        return [Seat(f"front-{k}", np.array([high[0] + 0.3, y]), np.array([-1.0, 0.0])) for k, y in enumerate(ys)]

    # anything else

    def _anywhere(self, one: Asked) -> bool:
        width = self._dice.choice((-0.7, -0.4, 0.4, 0.7))
        slot = Slot(id=f"asked-{len(self._standing)}", what=(one.category,), need="needed", at=(0.5, width), reach=0.5)
        surfaces = {s.name: s for s in self._surfaces.values()}
        return any(self._try(slot, one, surface, None) for surface in surfaces.values())

    def _stand(
        self,
        slot: Slot,
        asset: Asset,
        surface: Surface,
        at: Array,
        yaw: float,
        *,
        seat: Seat | None = None,
        base: Standing | None = None,
        anchor: Standing | None = None,
    ) -> None:
        id = self._around.new_id(asset.category)
        holder = base.object.id if base else self._support.id
        if base is not None and not any(s.name == surface.name for s in base.object.surfaces):
            self._carries(base, surface)
        spot = (float(at[0]), float(at[1]), self._height(surface, base))
        support = Support(object=holder, surface=surface.name)
        obj = placed(asset, id, self._frame, spot, yaw, support)
        self._standing.append(Standing(slot.id, seat.id if seat else None, obj, asset, surface, at, yaw))
        self.done.objects.append(obj)
        self._field(surface, base).put(self._shelf.shape(asset), yaw, at)
        if base is None:
            self._cover[surface.name] = self._cover.get(surface.name, 0.0) + asset.size[0] * asset.size[1]
        target = anchor or base
        if slot.relate and target is not None:
            params: dict[str, Any] = {"max": 0.3} if slot.relate == "near" else {}
            self.done.relations.append(
                Relation(type=slot.relate, subject=id, target=target.object.id, params=params, hard=False)
            )

    def _carries(self, base: Standing, surface: Surface) -> None:
        made = base.object.model_copy(update={"surfaces": (*base.object.surfaces, surface)})
        self.done.objects[self.done.objects.index(base.object)] = made
        base.object = made

    # surfaces

    def _field(self, surface: Surface, base: Standing | None) -> Field:
        key = f"{base.object.id if base else ''}/{surface.name}"
        if key not in self._fields:
            if base is None:
                edge = 0.012 if min(self._support.size[:2]) > 0.3 else EDGE
                self._fields[key] = self._around.field(self._support, surface, self._frame, edge)
            else:
                ring = SE2(base.at[0], base.at[1], base.yaw).to_world(counter_clockwise(surface.polygon))
                head = self._field(base.surface, None).headroom - surface.z
                self._fields[key] = Field(ring, head, edge=GAP / 2)
        return self._fields[key]

    def _height(self, surface: Surface, base: Standing | None) -> float:
        return surface.z if base is None else base.surface.z + surface.z

    def _span(self, surface: Surface) -> tuple[Array, Array]:
        ring = np.asarray(surface.polygon, dtype=float) * (-1.0 if self._turn else 1.0)
        return ring.min(axis=0), ring.max(axis=0)

    def _full(self, surface: Surface, asset: Asset) -> bool:
        covered = self._cover.get(surface.name, 0.0) + asset.size[0] * asset.size[1]
        return covered > self._plan.most * self._field(surface, None).area


def _top(base: Standing) -> Surface | None:
    """The surface of a thing that carries others: its own, or the top of a flat one."""
    if base.asset.surfaces:
        return max(base.asset.surfaces, key=lambda s: s.z)
    if base.asset.size[2] > FLAT or len(base.asset.parts) != 1:
        return None
    return Surface(name="top", polygon=base.asset.parts[0].polygon, z=base.asset.parts[0].z[1])


__all__ = ["OPEN", "Asked", "Layer", "Layout", "Standing"]
