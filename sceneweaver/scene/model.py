"""The scene itself: its content, and its edits as methods."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Any, Protocol

from sceneweaver.geometry.se2 import SE2
from sceneweaver.io import InputError
from sceneweaver.io.messages import is_number, show

from .content import SceneContent
from .display import Shown
from .edits import Add, AnyEdit, Relate, Remove, Rename, SetSize, Unrelate, apply, apply_all, carried
from .fields import LARGEST
from .limits import MOST_TURN
from .objects import Pose, SceneObject
from .relation import Relation


class HasId(Protocol):
    """An object, or a handle of one."""

    @property
    def id(self) -> str:
        """Its id."""
        ...


Named = str | HasId
"""An object of a scene: its id, itself, or a handle of it."""


def id_of(what: Any) -> str:
    """The id of an object: of itself, of its handle, or the id as it is; InputError for anything else."""
    found = getattr(what, "id", what)
    if not isinstance(found, str):
        raise InputError(f"{show(what)} is no object; give its id, or what add returned")
    return found


class Scene(Shown, SceneContent):
    """A whole scene. Immutable: edits return a new scene.

    Its edits are methods, and take ids, objects or handles. Each gives a new scene and raises InputError with one line
    where the edit is impossible; none solves a pose, `sceneweaver.EditSession` does. Lengths are metres, turns degrees
    counter-clockwise.

    Examples:
        >>> import sceneweaver as sw
        >>> scene = sw.Scene.example("bedroom")
        >>> scene.object("bed").category, len(scene.objects)
        ('bed', 16)
        >>> after = scene.move("chair", by=(0.1, 0.0)).resize("wardrobe", width=1.2).remove("armchair")
        >>> after.object("wardrobe").size[1], len(after.objects), scene.loads(after.dumps()) == after
        (1.2, 15, True)
    """

    def __repr__(self) -> str:
        return f"Scene({self.id!r}: {len(self.objects)} objects, {len(self.relations)} relations)"

    __str__ = __repr__

    def edit(self, *edits: AnyEdit) -> Scene:
        """The scene after some typed edits (`sceneweaver.scene.edits`), in order."""
        return apply_all(self, edits)[0] if len(edits) != 1 else apply(self, edits[0])

    def add(self, obj: SceneObject) -> Scene:
        """The scene with one object more; `sceneweaver.build` makes objects of words."""
        return apply(self, Add(object=obj))

    def remove(self, what: Named, *, cascade: bool = False) -> Scene:
        """The scene without an object and the relations that name it.

        Refused where something stands on it, unless ``cascade`` says to take that out as well.
        """
        return apply(self, Remove(id=id_of(what), cascade=cascade))

    def rename(self, what: Named, new_id: str) -> Scene:
        """The scene with another id for an object, in relations and supports too."""
        return apply(self, Rename(id=id_of(what), new_id=new_id))

    def move(
        self,
        what: Named,
        *,
        to: Pose | Sequence[float] | None = None,
        by: Sequence[float] | None = None,
        turn: float = 0.0,
    ) -> Scene:
        """The scene with an object elsewhere, and with it all that stands on it.

        Args:
            what: the object to move.
            to: where its bottom centre goes: (x, y) or (x, y, z) [m], or a whole pose.
            by: how far it goes instead: (dx, dy) or (dx, dy, dz) [m].
            turn: how far it is turned [degrees], `MOST_TURN` either way at most.
        """
        object_id = id_of(what)
        here = self.object(object_id).pose
        x, y, z = here.position
        if to is not None and by is not None:
            raise InputError(f'move "{object_id}": both to and by are given; give one of them')
        if isinstance(to, Pose):
            there, yaw = to.position, to.yaw
        else:
            step = point_of("by", by, 0.0) if by is not None else (0.0, 0.0, 0.0)
            there, yaw = point_of("to", to, z) if to is not None else (x + step[0], y + step[1], z + step[2]), here.yaw
        yaw += math.radians(_degrees("turn", turn))
        before, after = here.frame, SE2(there[0], there[1], yaw)
        poses = {}
        for name in carried(self, object_id):
            pose = self.object(name).pose
            u, v, w = pose.position
            position = (*after.world(*before.local(u, v)), w + there[2] - z)
            poses[name] = Pose.from_yaw(*position, yaw + pose.yaw - here.yaw)
        if isinstance(to, Pose) and not turn:
            poses[object_id] = to
        return self.replace_poses(poses)

    def resize(
        self, what: Named, *, depth: float | None = None, width: float | None = None, height: float | None = None
    ) -> Scene:
        """The scene with another size [m] of an object; what is not given stays. What stands on it goes along."""
        object_id = id_of(what)
        obj = self.object(object_id)
        size = tuple(old if new is None else new for old, new in zip(obj.size, (depth, width, height), strict=True))
        scene = apply(self, SetSize(id=object_id, size=size))  # pyright: ignore[reportArgumentType]
        tops = {s.name: s.z for s in scene.object(object_id).surfaces}
        for old in obj.surfaces:
            lift = tops[old.name] - old.z
            for other in self.objects:
                if lift and other.support and (other.support.object, other.support.surface) == (object_id, old.name):
                    scene = scene.move(other.id, by=(0.0, 0.0, lift))
        return scene

    def relate(
        self,
        subject: Named,
        type: str,  # noqa: A002 - the name of the field
        target: Named | tuple[Named, Named] | None = None,
        *,
        hard: bool = True,
        weight: float = 1.0,
        **params: Any,
    ) -> Scene:
        """The scene with one relation more: ``scene.relate("chair", "facing", "desk", degrees=10)``.

        Args:
            subject: the object that the relation places.
            type: a name of the catalogue, `sceneweaver.scene.CATALOGUE`.
            target: id of an object, of a door or window, "wall:k", two ids, or None, as the type asks.
            hard: whether the scene is invalid where the relation does not hold.
            weight: among soft relations.
            params: numbers of the type, set for this relation.
        """
        named = {"type": type, "subject": id_of(subject), "target": _target(target)}
        given = {**named, "params": params, "hard": hard, "weight": weight}
        return apply(self, Relate(relation=Relation(**given)))

    def unrelate(self, subject: Named, type: str, target: Named | tuple[Named, Named] | None = None) -> Scene:  # noqa: A002
        """The scene without the first relation of that type, subject and target."""
        return apply(self, Unrelate(type=type, subject=id_of(subject), target=_target(target)))


def _target(target: Any) -> str | tuple[str, str] | None:
    """A relation's target by ids."""
    if isinstance(target, list | tuple) and len(target) == 2:
        return id_of(target[0]), id_of(target[1])
    return None if target is None else id_of(target)


def _degrees(name: str, value: Any) -> float:
    if not is_number(value) or not -MOST_TURN <= value <= MOST_TURN:
        raise InputError(f"{name} is {show(value)}; give degrees from {-MOST_TURN:g} to {MOST_TURN:g}")
    return float(value)


def point_of(name: str, values: Iterable[Any], height: float) -> tuple[float, float, float]:
    """Three metres within `LARGEST` out of two or three; InputError, with ``name``, for anything else."""
    try:
        found = [float(v) for v in values]
    except (TypeError, ValueError):
        raise InputError(f"{name} is {show(values)}; give two or three numbers") from None
    if len(found) not in (2, 3) or not all(-LARGEST <= v <= LARGEST for v in found):
        raise InputError(f"{name} is {show(values)}; give two or three numbers from {-LARGEST:g} to {LARGEST:g}")
    return found[0], found[1], found[2] if len(found) == 3 else height
