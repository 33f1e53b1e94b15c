"""Rows of things on a shelf board: chosen by a theme until it is full enough, lined up at the front edge."""

from __future__ import annotations

import math
import random
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from sceneweaver.assets import Asset
from sceneweaver.knowledge.small_things import CLUTTER
from sceneweaver.knowledge.surfaces import Crowd, Unit
from sceneweaver.scene import SceneObject, Surface

from .surface_bodies import Shelf
from .surface_candidates import ROUND
from .surface_choice import seen_from_behind
from .surface_field import Array
from .surface_scene import Surroundings
from .surface_setting import Setting, Standing

CLEAR = 0.012
"""Free height [m] above things on a board."""

OPEN_TOP = 0.5
"""Tallest thing [m] on a board with nothing above it."""

BETWEEN = 0.015
"""Least gap [m] between groups."""


SHIFT = 0.05
"""How far [m] a thing may move from its place in the row to where there is room."""

WITHIN = 0.004
"""Least gap [m] to what stands on the board already."""


@dataclass
class Group:
    """Things that stand together; ``width`` [m] is along the board with the gaps between them."""

    unit: Unit
    assets: list[Asset]
    yaws: list[float]
    width: float


def filled(
    around: Surroundings,
    shelf: Shelf,
    support: SceneObject,
    board: Surface,
    theme: Crowd,
    dice: random.Random,
    density: float,
    clutter: float = CLUTTER,
) -> list[SceneObject]:
    """Things of a theme on a board of a support in a room; they count as there from then on.

    Args:
        around: the room.
        shelf: draws the bodies.
        support: has the board.
        board: one of its surfaces.
        theme: what stands there.
        dice: what chance decides.
        density: in 0..1, how full it gets.
        clutter: in 0..1, how far things stray.
    """
    frame = around.frame(support, seen_from_behind(support, board))
    setting = Setting(support, frame, shelf, lambda surface: around.field(support, surface, frame))
    _Row(setting, board, theme, around, dice, density, clutter).fill()
    return setting.objects


class _Row:
    """One board of a shelf in a room; what the room has few of comes first."""

    def __init__(
        self,
        setting: Setting,
        board: Surface,
        theme: Crowd,
        around: Surroundings,
        dice: random.Random,
        density: float,
        clutter: float,
    ):
        field = setting.field(board)
        self._setting, self._board, self._field = setting, board, field
        self._theme, self._around, self._shelf, self._dice = theme, around, setting.shelf, dice
        height = setting.support.pose.position[2] + board.z
        self._level = "low" if height < 0.6 else "high" if height > 1.6 else "middle"
        self._astray, self._density = min(2.0, clutter / CLUTTER), density
        self._width = float(field.high[1] - field.low[1])
        self._depth = float(field.high[0] - field.low[0])
        self._high = min(field.headroom - CLEAR, OPEN_TOP)
        self._used: dict[int, int] = {}
        self._seen: dict[str, int] = {}

    def fill(self) -> None:
        """Set things on the board, each where nothing is in its way."""
        if self._field.empty or self._high < 0.03 or self._width < 0.08 or self._depth < 0.06:
            return
        for asset, goal, yaw in self._lined_up(self._ordered(self._chosen())):
            piece = self._setting.piece(asset, yaw)
            at = self._field.place([piece], self._field.near(goal, SHIFT), gap=WITHIN)
            if at is not None:
                id = self._around.new_id(asset.category)
                self._setting.put(Standing(id, asset, self._board, at, yaw))

    def _chosen(self) -> list[Group]:
        least, most = self._theme.share
        target = self._width * (least + (most - least) * self._density) * self._dice.uniform(0.92, 1.0)
        few, many = self._theme.count
        many = max(few, round(few + (many - few) * min(1.0, 0.35 + 0.8 * self._width)))
        groups: list[Group] = []
        taken, number, last = 0.0, 0, -1
        for _ in range(24):
            room = self._width - taken - BETWEEN * len(groups)
            if taken >= target or number >= many:
                break
            choice = self._pick(last)
            if choice is None:
                break
            group = self._group(choice, min(room, max(target - taken, 0.12)), room, many - number)
            if group is None:
                self._used[choice] = self._theme.units[choice].most  # too large for what is left
                continue
            self._used[choice] = self._used.get(choice, 0) + 1
            for asset in {a.id: a for a in group.assets}.values():
                self._seen[asset.category] = self._seen.get(asset.category, 0) + 1
            groups.append(group)
            taken, number, last = taken + group.width, number + len(group.assets), choice
        return groups

    def _pick(self, last: int) -> int | None:
        weights = []
        for k, unit in enumerate(self._theme.units):
            fits = unit.level in (None, self._level) and self._used.get(k, 0) < unit.most
            if unit.end:  # only beside a row
                fits = fits and any(self._theme.units[i].fill and n for i, n in self._used.items())
            often = 0 if unit.fill else min(self._around.there[name] for name in unit.what)
            repeated = 0.45 if k == last and not unit.fill else 1.0
            weights.append(unit.weight * repeated / (1.0 + 0.3 * often) if fits else 0.0)
        return self._dice.choices(range(len(weights)), weights)[0] if sum(weights) > 0 else None

    def _group(self, choice: int, wanted: float, room: float, number: int) -> Group | None:
        """Things of one unit, at most ``room`` metres wide and ``number`` many; None when not even one fits."""
        unit = self._theme.units[choice]
        repeat = min(self._dice.randint(*unit.repeat), number)
        allowed = [n for n in unit.what if self._around.may_add(n)]
        names = sorted(allowed, key=lambda n: (self._seen.get(n, 0), self._dice.random()))
        quarter = abs(math.sin(math.radians(unit.turn))) > 0.7
        for name in names:
            width, depth = room, self._depth - 0.004
            limit = (width, depth, self._high) if quarter else (depth, width, self._high)
            size = unit.size
            if unit.fill:  # one row for what should be filled, or a good half of it
                width = min(room, wanted * self._dice.choice((1.0, 1.0, 0.6)))
                size = (size[0], (width, width), size[2])
            asset = self._shelf.draw(name, self._dice, size, limit)
            if asset is None:
                continue
            assets, yaws, total = [], [], 0.0
            for k in range(max(1, repeat)):
                body = asset if unit.same or k == 0 else self._shelf.draw(name, self._dice, unit.size, limit) or asset
                astray = unit.loose * (self._astray if unit.loose < ROUND else 1.0)
                yaw = math.radians(unit.turn) + math.radians(astray) * self._dice.uniform(-1, 1)
                low, high = self._shelf.shape(body).extent(yaw)
                broad = float(high[1] - low[1])
                if body.size[2] > self._high or float(high[0] - low[0]) > self._depth or total + broad > room:
                    break
                assets.append(body)
                yaws.append(yaw)
                total += broad + unit.gap
            if assets:
                return Group(unit, assets, yaws, total - unit.gap)
        return None

    def _ordered(self, groups: list[Group]) -> list[Group]:
        """Rows first and the bookend at their end, or as they came; mirrored by chance."""
        if self._theme.mode == "pack":
            rank = {id(g): 0 if g.unit.fill else 1 if g.unit.end else 2 for g in groups}
            groups = sorted(groups, key=lambda g: rank[id(g)])
        if self._dice.random() < 0.5:
            groups = groups[::-1]
            for group in groups:
                if group.unit.end:  # its upright plate to the row
                    group.yaws = [yaw + math.pi for yaw in group.yaws]
        return groups

    def _lined_up(self, groups: list[Group]) -> Iterator[tuple[Asset, Array, float]]:
        spare = self._width - sum(g.width for g in groups)
        gaps = self._gaps(groups, spare)
        y = float(self._field.low[1]) + gaps[0] if gaps else 0.0
        for k, group in enumerate(groups):
            for asset, yaw in zip(group.assets, group.yaws, strict=True):
                low, high = self._shelf.shape(asset).extent(yaw)
                back = self._depth - float(high[0] - low[0])
                inward = min(self._theme.setback + 0.2 * max(0.0, back - 0.1), 0.5 * back)
                x = float(self._field.high[0]) - inward - float(high[0])
                yield asset, np.array([x, y - float(low[1])]), yaw
                y += float(high[1] - low[1]) + group.unit.gap
            y += gaps[k + 1] - group.unit.gap

    def _gaps(self, groups: list[Group], spare: float) -> list[float]:
        """Gaps [m] before, between and after the groups: rows stay together, the rest is spread."""
        n = len(groups)
        if n == 0:
            return []
        shares = [1.0] * (n + 1)
        least = [BETWEEN] * (n + 1)
        if self._theme.mode == "pack":
            for k in range(n + 1):
                a, b = groups[k - 1] if k else None, groups[k] if k < n else None
                joined = a is not None and b is not None and all(g.unit.fill or g.unit.end for g in (a, b))
                end = (a is None and b is not None and (b.unit.fill or b.unit.end)) or (
                    b is None and a is not None and (a.unit.fill or a.unit.end)
                )
                if joined or end:
                    shares[k], least[k] = 0.0, 0.006
        else:
            shares[0] = shares[-1] = 0.6
        least = [v * min(1.0, max(0.0, spare) / max(1e-9, sum(least))) for v in least]
        rest = max(0.0, spare - sum(least))
        if sum(shares) == 0:
            shares[-1] = 1.0
        shares = [s * self._dice.uniform(0.8, 1.2) for s in shares]
        return [v + rest * s / sum(shares) for v, s in zip(least, shares, strict=True)]
