"""Lays an arrangement out on one support: each thing at its place, beside another, upon it, or before a chair."""

from __future__ import annotations

import math
import random
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType

import numpy as np

from sceneweaver.assets import Asset
from sceneweaver.knowledge.small_things import CLUTTER
from sceneweaver.knowledge.surfaces import Arrangement, Slot
from sceneweaver.scene import Relation, SceneObject, Surface

from .surface_bodies import Shelf
from .surface_candidates import Spread, before_seat, surfaces_of
from .surface_field import EDGE, Array, Field
from .surface_scene import Seat, Surroundings
from .surface_setting import Setting, Standing

SHIFT = 0.12
"""How far [m] a thing beside a plate may move to where there is room."""

BESIDE = 0.1
"""How far [m] a thing may move that stands beside another."""

NEAR = 1.5
"""Distance [m] of what makes a slot needless."""

ASIDE = -0.55
"""Side at which the first of several alike stands, where one alone has the middle."""


@dataclass(frozen=True)
class Asked:
    """Something that was asked for by name; ``look`` are colour, material, style, words."""

    category: str
    look: dict[str, str] = field(default_factory=dict)


@dataclass
class Layout:
    """What one support got, what it lacks of its arrangement, and what was asked for and has no room."""

    objects: list[SceneObject] = field(default_factory=list)
    relations: list[Relation] = field(default_factory=list)
    missing: list[str] = field(default_factory=list)
    unplaced: list[Asked] = field(default_factory=list)


def dressed(
    around: Surroundings,
    shelf: Shelf,
    support: SceneObject,
    plan: Arrangement,
    dice: random.Random,
    clutter: float = CLUTTER,
    *,
    asked: Sequence[Asked] = (),
    looks: Mapping[str, dict[str, str]] = MappingProxyType({}),
) -> Layout:
    """An arrangement on a support in a room, with what was asked for by name.

    Args:
        around: the room; what is added counts as there from then on.
        shelf: draws the bodies.
        support: what is laid.
        plan: the slots.
        dice: what chance decides.
        clutter: in 0..1, how far things stray and how many there are.
        asked: things that stand whatever their chance.
        looks: colour, material, style and words of the things of some slots.
    """
    layer = _Slots(around, shelf, support, plan, dice, clutter, looks)
    layer.run(asked)
    layer.done.objects = layer.setting.objects
    return layer.done


class _Slots:
    def __init__(
        self,
        around: Surroundings,
        shelf: Shelf,
        support: SceneObject,
        plan: Arrangement,
        dice: random.Random,
        clutter: float,
        looks: Mapping[str, dict[str, str]],
    ):
        self._around, self._support, self._plan = around, support, plan
        self._dice, self._clutter, self._looks = dice, clutter, looks
        self._seats = around.seats(support)
        back = plan.user == "back"
        if self._seats and not any(slot.each for slot in plan.slots):  # the user is where the chair is
            back = float(np.mean([s.place[0] for s in self._seats])) < -0.2 * support.size[0]
        frame = around.frame(support, back)
        edge = 0.012 if min(support.size[:2]) > 0.3 else EDGE
        self.setting = Setting(support, frame, shelf, lambda surface: around.field(support, surface, frame, edge))
        outer = around.outer_side(support)
        self._mirror = dice.random() < 0.5 if outer == 0 else outer < 0
        self._surfaces = surfaces_of(support, back, plan.top)
        self.done = Layout()

    def run(self, asked: Sequence[Asked]) -> None:
        """The slots in order, those asked for whatever their chance, then what no slot is meant for."""
        rest = list(asked)
        # What is optional comes last, so that it never takes the place of what belongs there.
        for slot in sorted(self._plan.slots, key=lambda s: s.need == "optional"):
            one = next((a for a in rest if a.category in slot.what), None)
            if one is None and not self._wanted(slot):
                continue
            if slot.only and not any(
                s.slot == slot.by and s.asset.category in slot.only for s in self.setting.standing
            ):
                continue
            if slot.on is not None and self._at(slot.on) is None:
                continue
            if one is not None and slot.at is not None and sum(a.category == one.category for a in rest) > 1:
                slot = slot.model_copy(update={"at": (slot.at[0], slot.at[1] or ASIDE)})  # another one beside it
            good = self._seated(slot, one) if slot.each else self._single(slot, one)
            if good and one is not None:
                rest.remove(one)
                if slot.each is None:
                    self._twins(slot, one.category, rest)
            elif not good and slot.need == "needed" and one is None:
                self.done.missing.append(slot.what[0])
        self.done.unplaced += [one for one in rest if not self._anywhere(one)]

    def _wanted(self, slot: Slot) -> bool:
        """Whether a slot is filled that no one asked for: by its clutter, chance and what stands there already."""
        # One that varies by seat is decided at each seat, not here.
        if slot.clutter > self._clutter or not (slot.vary or self._chances(slot).random() <= slot.chance):
            return False
        if slot.by is not None and self._at(slot.by) is None:
            return False
        # Something near the support may make it needless, such as a television on the wall above.
        x, y, _ = self._support.pose.position
        near = [
            o.category
            for o in self._around.scene.objects
            if math.hypot(o.pose.position[0] - x, o.pose.position[1] - y) < NEAR
        ]
        return not any(c in slot.unless for c in (*near, *(s.asset.category for s in self.setting.standing)))

    def _at(self, slot: str | None, seat: str | None = None) -> Standing | None:
        """The first thing that stands for a slot, before a seat if one is given."""
        found = (s for s in self.setting.standing if s.slot == slot and (seat is None or s.seat == seat))
        return next(found, None) if slot is not None else None

    def _chances(self, slot: Slot) -> random.Random:
        """What decides about a slot: for a paired one the same on all such furniture of the room."""
        return self.setting.shelf.shared(f"{self._plan.name}/{slot.id}") if slot.paired else self._dice

    def _twins(self, slot: Slot, category: str, rest: list[Asked]) -> None:
        """More of the same that was asked for stands beside the first: two screens."""
        for one in [a for a in rest if a.category == category]:
            name = f"{slot.id}-{len(self.setting.standing)}"
            if self._single(Slot(id=name, what=(category,), need="needed", by=slot.id, gap=0.03), one):
                rest.remove(one)

    # one thing

    def _single(self, slot: Slot, one: Asked | None) -> bool:
        base = self._at(slot.on)
        surface = self._surfaces.get(slot.surface) or (self._surfaces["main"] if slot.need == "needed" else None)
        if base is not None:
            surface = base.carrying()
        if surface is None:
            return False
        low, high = self.setting.span(surface)
        if base is None and (high[0] - low[0] < slot.least[0] or high[1] - low[1] < slot.least[1]):
            return False
        return self._try(slot, one, surface, base)

    def _try(self, slot: Slot, one: Asked | None, surface: Surface, base: Standing | None) -> bool:
        ground = self.setting.field(surface, base)
        low, high = self.setting.span(surface)
        limit = (float(max(high - low)), float(max(high - low)), ground.headroom - 0.01)
        chances = self._chances(slot)
        spread = Spread(slot, chances, self._mirror and not slot.fixed, self._clutter)
        names = (one.category,) if one else tuple(n for n in spread.kinds() if self._around.may_add(n))
        like = self._at(slot.like) if one is None else None
        if like is not None and like.asset.size[2] <= limit[2] and self._around.may_add(like.asset.category):
            return not self._full(surface, like.asset) and self._place(slot, like.asset, surface, base, spread)
        look = one.look if one else self._looks.get(slot.id)
        optional = one is None and slot.need != "needed" and not slot.on
        return any(
            self._place(slot, asset, surface, base, spread)
            for asset, _ in self._bodies(slot, names, chances, limit, look)
            if not (optional and self._full(surface, asset))
        )

    def _bodies(
        self,
        slot: Slot,
        names: Sequence[str],
        dice: random.Random,
        limit: tuple[float, float, float],
        look: dict[str, str] | None,
    ) -> Iterator[tuple[Asset, bool]]:
        """Bodies of some categories to try, each as the slot has it, then the smallest; with whether it is the last."""
        for name in names:
            for size in (slot.size, ((0.0, 0.0), (0.0, 0.0), slot.size[2])):
                asset = self.setting.shelf.draw(name, dice, size, limit, look)
                if asset is None:
                    break
                yield asset, name == names[-1] and size != slot.size

    def _place(self, slot: Slot, asset: Asset, surface: Surface, base: Standing | None, spread: Spread) -> bool:
        ground, anchor = self.setting.field(surface, base), self._at(slot.by)
        for yaw in dict.fromkeys((spread.yaw, spread.yaw - spread.stray)):  # square where it is too tight to stray
            piece = self.setting.piece(asset, yaw)
            if anchor is not None:
                goals = spread.beside(piece, anchor, self.setting.piece(anchor.asset, anchor.yaw))
            elif base is not None:
                goals = [ground.centre]
            else:
                goals = [ground.inside(piece.shape, yaw, spread.share) + spread.drift]
            reach = slot.reach if anchor is None else min(slot.reach, BESIDE)
            at = ground.place([piece], (batch for goal in goals for batch in ground.near(goal, reach)))
            if at is not None:
                self._stand(slot, asset, surface, at, yaw, base=base, anchor=anchor)
                return True
        return False

    # before chairs

    def _seated(self, slot: Slot, one: Asked | None) -> bool:
        surface = self._surfaces["main"]
        ground = self.setting.field(surface)
        seats = self._seats
        if not seats and (slot.by is None or self.setting.standing):
            seats = self._imagined(surface)
        names = (one.category,) if one else tuple(n for n in slot.what if self._around.may_add(n))
        limit = (1.0, 1.0, ground.headroom)
        if slot.vary and one is None:
            return any([self._for_some(slot, surface, seat, names, limit) for seat in seats])
        may_lack = one is not None or slot.need == "needed"
        for asset, last in self._bodies(slot, names, self._dice, limit, one.look if one else None):
            places = self._for_all(slot, asset, ground, seats)
            if any(p is None for p in places) and not (last and may_lack):
                continue  # before every chair, or before none
            if self._set_before(slot, asset, surface, seats, places):
                return True
        return False

    def _for_some(
        self, slot: Slot, surface: Surface, seat: Seat, names: Sequence[str], limit: tuple[float, float, float]
    ) -> bool:
        """One of several things before a seat, or none, as chance has it there."""
        if not names or self._dice.random() > slot.chance:
            return False
        for name in self._dice.sample(names, len(names)):
            asset = self.setting.shelf.draw(name, self._dice, slot.size, limit)
            if asset is not None:
                places = self._for_all(slot, asset, self.setting.field(surface), [seat])
                if self._set_before(slot, asset, surface, [seat], places):
                    return True
        return False

    def _for_all(
        self, slot: Slot, asset: Asset, ground: Field, seats: Sequence[Seat]
    ) -> list[tuple[Array, float] | None]:
        """Where one of an asset goes before each seat; the free space is left as it was."""
        before = len(ground.taken)
        places: list[tuple[Array, float] | None] = []
        for seat in seats:
            spread = Spread(slot, self._dice, False, self._clutter)
            anchor, found = self._at(slot.by, seat.id), None
            if slot.by is None:
                found = before_seat(self.setting.shelf.shape(asset), ground, seat, spread.stray)
            elif anchor is not None:
                piece = self.setting.piece(asset, anchor.yaw + spread.stray)
                goals = spread.beside(piece, anchor, self.setting.piece(anchor.asset, anchor.yaw))
                at = ground.place([piece], (batch for goal in goals for batch in ground.near(goal, SHIFT)))
                found = (at, piece.yaw) if at is not None else None
            if found is not None:
                ground.put(self.setting.piece(asset, found[1]), found[0])
            places.append(found)
        del ground.taken[before:]
        return places

    def _set_before(
        self,
        slot: Slot,
        asset: Asset,
        surface: Surface,
        seats: Sequence[Seat],
        places: Sequence[tuple[Array, float] | None],
    ) -> bool:
        """Set a thing down before each seat that has a place for it; whether any has."""
        for seat, place in zip(seats, places, strict=True):
            if place is not None:
                self._stand(slot, asset, surface, *place, seat=seat, anchor=self._at(slot.by, seat.id))
        return any(place is not None for place in places)

    def _imagined(self, surface: Surface) -> list[Seat]:
        """Where people would sit at a table without chairs: at one side of it, the user's."""
        low, high = self.setting.span(surface)
        width = float(high[1] - low[1])
        ys = [0.0] if width < 1.0 else [-0.25 * width, 0.25 * width]
        return [Seat(f"front-{k}", np.array([high[0] + 0.3, y]), np.array([-1.0, 0.0])) for k, y in enumerate(ys)]

    # anything else

    def _anywhere(self, one: Asked) -> bool:
        width = self._dice.choice((-0.7, -0.4, 0.4, 0.7))
        name = f"asked-{len(self.setting.standing)}"
        slot = Slot(id=name, what=(one.category,), need="needed", at=(0.5, width), reach=0.5)
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
        id, where = self._around.new_id(asset.category), seat.id if seat else None
        self.setting.put(Standing(id, asset, surface, at, yaw, base, slot.id, where))
        target = anchor or base
        if slot.relate and target is not None:
            params = {"max": 0.3} if slot.relate == "near" else {}
            self.done.relations.append(
                Relation(type=slot.relate, subject=id, target=target.id, params=params, hard=False)
            )

    def _full(self, surface: Surface, asset: Asset) -> bool:
        """Whether one more thing would cover more of a surface than its arrangement allows."""
        covered = self.setting.cover(surface) + asset.size[0] * asset.size[1]
        return covered > self._plan.most * self.setting.field(surface).area
