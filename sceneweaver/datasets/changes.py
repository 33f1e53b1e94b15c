"""One change of a scene: an object moved, turned, removed, recoloured or exchanged; on purpose harmless or not."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from typing import Any, Literal

import numpy as np

from sceneweaver.assets.sources.parametric import PREFIX, ParametricSource
from sceneweaver.scene import InputError, Pose, Remove, Scene, SceneObject
from sceneweaver.scene.edits import apply, carried
from sceneweaver.verify.solids import Body

from .describe.facts import Facts, has_front
from .describe.moves import Space, is_movable
from .describe.naming import color, color_families

Kind = Literal["moved", "turned", "removed", "recoloured", "exchanged"]

Breaks = Literal["collision", "out_of_bounds", "unsupported", "blocked_opening", "relation"]
"""Kinds of violations, as `sceneweaver.check` names them."""

SUNK = 0.05
"""How far [m] two things are pushed into each other."""

PUSHED, LIFTED = 0.15, 0.15
"""How far [m] a thing is pushed through a wall, or lifted off what it stands on."""

PLAIN_PUSH = 0.06
"""Least distance [m] by which a thing is pushed into another."""

LEAST_MOVE, LEAST_TURN = 0.1, math.radians(25)
"""Distance [m] and angle [rad] from which a change is plain to see."""

LIKE_IT = 4
"""Other drawings of a kind that are looked at."""


@dataclass(frozen=True)
class Change:
    """What is changed.

    Attributes:
        kind: what is done.
        object: id of what it is done to; what stands on it goes along.
        after: the scene after it.
        breaks: the one kind of hard violation that it is to cause; None: it is to stay valid.
    """

    kind: Kind
    object: str
    after: Scene
    breaks: Breaks | None = None


class Changer:
    """The changes of one scene, in a drawn order."""

    def __init__(self, facts: Facts, rng: np.random.Generator):
        self.facts = facts
        self.scene = facts.scene
        self.rng = rng
        self.space = Space(facts.scene, facts.placed)
        self.drawn = ParametricSource()
        holders = {carrier for carrier, _ in facts.carried}
        self.single = [b for b in facts.bodies if b.id not in holders and not b.item.fixed]
        self.small = [b for b in self.single if b.item.support is not None and not b.tilted]
        self.large = [b for b in facts.furniture if is_movable(facts.scene, b)]

    def shuffled(self, items: list[Any]) -> list[Any]:
        """The items in a drawn order."""
        return [items[int(k)] for k in self.rng.permutation(len(items))]

    def _things(self) -> list[Body]:
        """Large and small things in turn, in a drawn order."""
        large, small = self.shuffled(self.large), self.shuffled(self.small)
        return [b for pair in zip(large, small, strict=False) for b in pair] or large or small

    def _to(self, body: Body, x: float, y: float, z: float, yaw: float) -> Scene:
        return self.scene.move(body.id, to=Pose.from_yaw(x, y, z, yaw))

    # ---- what stays valid

    def moved(self) -> Iterator[Change]:
        """A thing somewhere else on the floor or on its surface."""
        for body in self._things():
            support = body.item.support
            if support is None:
                turn, reach = self.rng.uniform(-math.pi, math.pi, 16), self.rng.uniform(0.3, 1.2, 16)
                spots = np.array(body.centre) + np.stack([np.cos(turn), np.sin(turn)], axis=1) * reach[:, None]
                carrier = None
            else:
                holder, carrier = self.facts.by_id[support.object], (support.object, support.surface)
                surface = next(s for s in holder.item.surfaces if s.name == support.surface)
                corners = np.array(surface.polygon)
                drawn = corners.min(axis=0) + np.ptp(corners, axis=0) * self.rng.random((16, 2))
                spots = np.column_stack(holder.frame.world(drawn[:, 0], drawn[:, 1]))
            far = np.hypot(*(spots - body.centre).T) > max(LEAST_MOVE, max(body.size[:2]) / 2)
            poses = np.column_stack([spots, np.full(len(spots), body.yaw)])[far]
            if not len(poses):
                continue
            free = self.space.free(body.id, poses, body.position[2], carrier)
            for x, y, yaw in poses[free][:1].tolist():
                yield Change("moved", body.id, self._to(body, x, y, body.position[2], yaw))

    def turned(self) -> Iterator[Change]:
        """A thing with a front, turned where it stands."""
        for body in self._things():
            if has_front(body):
                yaw = body.yaw + float(self.rng.uniform(LEAST_TURN, math.tau - LEAST_TURN))
                yield Change("turned", body.id, self._to(body, *body.position, yaw))

    def removed(self) -> Iterator[Change]:
        """A thing that is gone, with all relations that name it."""
        for body in self.shuffled(self.single):
            yield Change("removed", body.id, apply(self.scene, Remove(id=body.id)))

    def recoloured(self) -> Iterator[Change]:
        """A thing in another colour; its shape stays."""
        for body in self.shuffled(list(self.facts.bodies)):
            was = color(body)
            if was is None or body.item.asset is None or not body.item.asset.startswith(PREFIX):
                continue
            head, _, query = body.item.asset.partition("&")
            parts = [p for p in query.split("&") if p and not p.startswith(("color=", "material="))]
            near = color_families()[was]
            wanted = self.shuffled(sorted(c for c, family in color_families().items() if family != near))[0]
            asset_id = "&".join([head, f"color={wanted.replace(' ', '%20')}", *parts])
            try:
                old, new = self.drawn.load(body.item.asset), self.drawn.load(asset_id)
            except InputError:
                continue
            if new.attributes.get("color") != wanted or new.size != old.size or new.parts != old.parts:
                continue
            changed = {name: value for name, value in new.attributes.items() if old.attributes.get(name) != value}
            update = {
                "asset": new.id,
                "attributes": {**body.item.attributes, **changed},
                "description": new.description,
            }
            yield Change("recoloured", body.id, self._replaced(body.item.model_copy(update=update)))

    def exchanged(self) -> Iterator[Change]:
        """A thing in the place of another of its kind."""
        for body in self.shuffled([b for b in self.single if b.item.mount in ("floor", "surface")]):
            if body.item.asset is None or not body.item.asset.startswith(PREFIX):
                continue
            for k in range(1, LIKE_IT + 1):
                item = self._drawn_anew(body.item, k)
                if item is not None:
                    yield Change("exchanged", body.id, self._replaced(item))

    def _drawn_anew(self, item: SceneObject, k: int) -> SceneObject | None:
        """The object with the drawing of another seed, where that is of another shape."""
        assert item.asset is not None
        head, _, query = item.asset.partition("?")
        given = dict(p.split("=", 1) for p in query.split("&"))
        given["seed"] = str(int(given.get("seed", "0")) + k)
        given.pop("mirrored", None)
        try:
            asset = self.drawn.load(head + "?" + "&".join(f"{name}={value}" for name, value in given.items()))
        except InputError:
            return None
        asset = asset.of_style(item.attributes.get("style"))
        made = asset.object(item.id, pose=item.pose, mount=item.mount, support=item.support)
        if made.parts == item.parts or made.category != item.category:
            return None
        return made.model_copy(update={"intent": item.intent, "fixed": item.fixed})

    def _replaced(self, item: SceneObject) -> Scene:
        objects = tuple(item if o.id == item.id else o for o in self.scene.objects)
        return self.scene.model_copy(update={"objects": objects})

    # ---- what breaks one thing

    def collision(self) -> Iterator[Change]:
        """A thing pushed into its neighbour."""
        import shapely

        facts = self.facts
        for body in self._things():
            level = [
                b
                for b in facts.bodies
                if b is not body
                and b.item.mount == body.item.mount
                and (b.item.support and b.item.support.object) == (body.item.support and body.item.support.object)
                and min(b.z[1], body.z[1]) - max(b.z[0], body.z[0]) > 0.02
                and facts.boxes_apart(b, body) < 1.0
            ]
            mine = shapely.union_all(facts.placed.footprint(body))
            for other in sorted(level, key=lambda b: math.dist(b.centre, body.centre))[:2]:
                line = shapely.shortest_line(mine, shapely.union_all(facts.placed.footprint(other)))
                (x0, y0), (x1, y1) = shapely.get_coordinates(line)[[0, -1]]
                gap = math.hypot(x1 - x0, y1 - y0)
                if gap < 1e-3:
                    continue
                step = (gap + min(SUNK, 0.4 * min(*body.size[:2], *other.size[:2]))) / gap
                if gap * step < PLAIN_PUSH:
                    continue
                x, y, z = body.position
                after = self._to(body, x + (x1 - x0) * step, y + (y1 - y0) * step, z, body.yaw)
                yield Change("moved", body.id, after, "collision")

    def out_of_bounds(self) -> Iterator[Change]:
        """A thing pushed through the wall that it stands against."""
        for body in self.shuffled(self.large):
            wall = self.facts.wall_at(body)
            if wall is not None:
                x, y = (PUSHED * v for v in self.facts.placed.walls[wall].outward)
                after = self.scene.move(body.id, by=(x, y))
                yield Change("moved", body.id, after, "out_of_bounds")

    def unsupported(self) -> Iterator[Change]:
        """A thing that floats above what it stood on."""
        for body in self._things():
            yield Change("moved", body.id, self.scene.move(body.id, by=(0.0, 0.0, LIFTED)), "unsupported")

    def blocked_opening(self) -> Iterator[Change]:
        """A thing in the space that a door needs."""
        for body in self.shuffled(self.large):
            for door in self.facts.placed.doors:
                x, y = np.mean(door.polygon, axis=0)
                after = self._to(body, float(x), float(y), body.position[2], body.yaw)
                yield Change("moved", body.id, after, "blocked_opening")

    def relation(self) -> Iterator[Change]:
        """A thing that leaves its place in one hard relation."""
        hard = [r for r in self.scene.relations if r.hard and r.subject in self.facts.by_id]
        for relation in self.shuffled(hard):
            body = self.facts.by_id[relation.subject]
            if body.tilted or body.item.fixed:
                continue
            turn = float(self.rng.choice([-1, 1])) * float(self.rng.uniform(LEAST_TURN, math.pi / 2))
            ahead, left = self.rng.uniform(-0.4, 0.4, 2)
            (fx, fy), (x, y, z) = body.front, body.position
            yield Change("turned", body.id, self._to(body, x, y, z, body.yaw + turn), "relation")
            x, y = x + fx * ahead - fy * left, y + fy * ahead + fx * left
            if math.hypot(ahead, left) > LEAST_MOVE:
                yield Change("moved", body.id, self._to(body, float(x), float(y), z, body.yaw), "relation")

    def sources(self, breaking: bool) -> list[Callable[[], Iterator[Change]]]:
        """Where changes of one sort come from, in a drawn order."""
        harmless = [self.moved, self.turned, self.removed, self.recoloured, self.exchanged]
        harmful = [self.collision, self.out_of_bounds, self.unsupported, self.blocked_opening, self.relation]
        return self.shuffled([partial(source) for source in (harmful if breaking else harmless)])


def changed_ids(change: Change, scene: Scene) -> list[str]:
    """Ids of all that a change touches: the object, then what goes along with it."""
    return list(carried(scene, change.object)) if change.kind in ("moved", "turned") else [change.object]
