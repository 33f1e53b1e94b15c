"""The continuous parameters of scenes: sizes, outline, openings, numbers and weights of relations, weights of terms."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from sceneweaver.scene import CATALOGUE, InputError, Relation, Room, Scene
from sceneweaver.scene.fields import LARGEST, SMALLEST

from .user import TERMS

KINDS = ("size", "outline", "opening", "relation", "weight", "term")
"""What parameters there are, see `Parameters`."""

WEIGHTS = ("weight", "term")
"""Those in which the energy is linear."""


class Slot(NamedTuple):
    """One number of a scene: its kind, its place in the kind's array, and what it is called."""

    kind: str
    index: tuple[int, ...]
    label: str
    value: float
    lower: float
    upper: float


@dataclass(frozen=True)
class Parameters:
    """The continuous parameters of a problem of S scenes, each kind as an array; what a scene has not is masked out.

    ``"size"`` [S, N, 3]: depth, width, height of objects [m]; parts, zones and surfaces scale along.
    ``"outline"`` [S, V, 2]: corners of the room [m]; openings keep their distance from the first corner of their wall.
    ``"opening"`` [S, D, 2]: offset along the wall and width [m] of doors, then windows.
    ``"relation"`` [S, Q]: numbers of the scene's relations, lengths [m] and angles [degrees].
    ``"weight"`` [S, R]: weights of the scene's relations.
    ``"term"`` [S, T]: weights of `sceneweaver.define_term`'s terms, in alphabetical order.

    Attributes:
        values: the values that the problem was compiled with, by kind, float64.
        lower, upper: what a scene lets them be.
        mask: which there are.
        labels: for each scene what they are called, such as "size/bed/1", by kind in the order of `mask`.
    """

    values: dict[str, np.ndarray]
    lower: dict[str, np.ndarray]
    upper: dict[str, np.ndarray]
    mask: dict[str, np.ndarray]
    labels: dict[str, tuple[tuple[str, ...], ...]]

    @property
    def flat(self) -> np.ndarray:
        """All values [F], kind after kind."""
        return np.concatenate([self.values[kind].ravel() for kind in KINDS])

    def flattened(self, changes: Mapping[str, Any]) -> np.ndarray:
        """All values [F], with those of some kinds changed; errors as for `merged`."""
        found = self.merged(changes)
        return np.concatenate([found[kind].ravel() for kind in KINDS])

    def merged(self, changes: Mapping[str, Any]) -> dict[str, np.ndarray]:
        """All values, with those of some kinds changed.

        Raises:
            InputError: no such kind, another shape, or a number outside of its bounds.
        """
        found = dict(self.values)
        for kind, given in changes.items():
            if kind not in KINDS:
                raise InputError(f"parameters: no kind {kind!r}; there are {', '.join(KINDS)}")
            try:
                values = np.asarray(given, dtype=np.float64)
                values = np.broadcast_to(values, found[kind].shape)
            except (TypeError, ValueError):
                shape = list(found[kind].shape)
                raise InputError(f"parameters: {kind} is not an array of numbers of shape {shape}") from None
            values = np.where(self.mask[kind], values, found[kind])
            fits = (values >= self.lower[kind]) & (values <= self.upper[kind])
            if not np.all(fits | ~self.mask[kind]):
                at = tuple(np.argwhere(~fits & self.mask[kind])[0].tolist())
                low, high = self.lower[kind][at], self.upper[kind][at]
                raise InputError(f"parameters: {kind}{list(at)} is {values[at]:g}; it lies in [{low:g}, {high:g}]")
            found[kind] = values
        return found

    def unflat(self, flat: np.ndarray) -> dict[str, np.ndarray]:
        """Values by kind of all of them [..., F]."""
        found, first = {}, 0
        for kind in KINDS:
            shape = self.values[kind].shape
            last = first + self.values[kind].size
            found[kind] = flat[..., first:last].reshape(*flat.shape[:-1], *shape)
            first = last
        return found


def slots_of(scene: Scene) -> list[Slot]:
    """The parameters of one scene, kind after kind."""
    return [*_sizes(scene), *_corners(scene), *_openings(scene), *_numbers(scene), *_weights(scene), *_terms()]


def _sizes(scene: Scene) -> Iterator[Slot]:
    for i, o in enumerate(scene.objects):
        for c in range(3):
            yield Slot("size", (i, c), f"size/{o.id}/{c}", o.size[c], SMALLEST, LARGEST)


def _corners(scene: Scene) -> Iterator[Slot]:
    for v, corner in enumerate(scene.room.outline):
        for c in range(2):
            yield Slot("outline", (v, c), f"outline/{v}/{c}", corner[c], -LARGEST, LARGEST)


def _openings(scene: Scene) -> Iterator[Slot]:
    for i, o in enumerate(scene.room.openings):
        yield Slot("opening", (i, 0), f"opening/{o.id}/offset", o.offset, 0.0, LARGEST)
        yield Slot("opening", (i, 1), f"opening/{o.id}/width", o.width, SMALLEST, LARGEST)


def numbers_of(relation: Relation) -> Iterator[tuple[str, int | None, float]]:
    """The continuous numbers of a relation: name, which end of a range (None: it is none), and value."""
    for name, spec in CATALOGUE[relation.type].params.items():
        value = relation.params.get(name, spec.default)
        if spec.type == "number" and isinstance(value, int | float):
            yield name, None, float(value)
        elif spec.type == "range" and isinstance(value, list | tuple):
            yield name, 0, float(value[0])
            yield name, 1, float(value[1])


def _numbers(scene: Scene) -> Iterator[Slot]:
    at = 0
    for r, relation in enumerate(scene.relations):
        for name, end, value in numbers_of(relation):
            spec = CATALOGUE[relation.type].params[name]
            low = spec.minimum if spec.minimum is not None else spec.exclusive_minimum
            bounds = (-LARGEST if low is None else low, LARGEST if spec.maximum is None else spec.maximum)
            suffix = "" if end is None else f"/{end}"
            yield Slot("relation", (at,), f"relation/{r}/{relation.type}/{name}{suffix}", value, *bounds)
            at += 1


def _weights(scene: Scene) -> Iterator[Slot]:
    for r, relation in enumerate(scene.relations):
        yield Slot("weight", (r,), f"weight/{r}/{relation.type}", relation.weight, 0.0, LARGEST)


def _terms() -> Iterator[Slot]:
    for t, name in enumerate(sorted(TERMS)):
        yield Slot("term", (t,), f"term/{name}", TERMS[name].weight, 0.0, LARGEST)


def parameters_of(slots: Sequence[Sequence[Slot]], objects: int) -> Parameters:
    """The parameters of scenes as arrays; ``objects`` is the number N of poses."""
    shape = {"size": (objects, 3), "outline": (0, 2), "opening": (0, 2), "relation": (0,), "weight": (0,), "term": (0,)}
    for slot in (slot for of_scene in slots for slot in of_scene):
        shape[slot.kind] = tuple(map(max, shape[slot.kind], (i + 1 for i in slot.index)))
    whole = {kind: (len(slots), *shape[kind]) for kind in KINDS}
    values, lower, upper = ({kind: np.zeros(whole[kind]) for kind in KINDS} for _ in range(3))
    mask = {kind: np.zeros(whole[kind], dtype=bool) for kind in KINDS}
    for s, of_scene in enumerate(slots):
        for kind, index, _, value, low, high in of_scene:
            at = (s, *index)
            values[kind][at], lower[kind][at], upper[kind][at], mask[kind][at] = value, low, high, True
    labels = {kind: tuple(tuple(x.label for x in rows if x.kind == kind) for rows in slots) for kind in KINDS}
    return Parameters(values, lower, upper, mask, labels)


def scene_with(scene: Scene, values: Mapping[str, np.ndarray]) -> Scene:
    """A scene with other values [of one scene] of its parameters; weights of terms are not part of it.

    Raises:
        InputError: the room or a thing is impossible with them.
    """
    scene = _resized(scene, values["size"])
    room = _rebuilt(scene.room, values["outline"], values["opening"])
    if room is not scene.room:
        scene = scene.model_copy(update={"room": room})
    relations = tuple(_with_numbers(scene.relations, values["relation"], values["weight"]))
    return scene if relations == scene.relations else scene.model_copy(update={"relations": relations})


def _resized(scene: Scene, sizes: np.ndarray) -> Scene:
    for o, size in zip(scene.objects, sizes.tolist(), strict=False):
        if tuple(size) != o.size:
            scene = scene.resize(o.id, depth=size[0], width=size[1], height=size[2])
    return scene


def _rebuilt(room: Room, outline: np.ndarray, openings: np.ndarray) -> Room:
    """A room with other corners and openings, checked as a new one."""
    corners = tuple(tuple(corner) for corner in outline[: len(room.outline)].tolist())
    spans = openings[: len(room.openings)].tolist()
    if corners == room.outline and spans == [[o.offset, o.width] for o in room.openings]:
        return room
    changed = [o.model_copy(update={"offset": a, "width": w}) for o, (a, w) in zip(room.openings, spans, strict=True)]
    doors = len(room.doors)
    given = {name: getattr(room, name) for name in type(room).model_fields}
    return type(room)(
        **{**given, "outline": corners, "doors": tuple(changed[:doors]), "windows": tuple(changed[doors:])}
    )


def _with_numbers(relations: Sequence[Relation], numbers: np.ndarray, weights: np.ndarray) -> Iterator[Relation]:
    at = 0
    for relation, weight in zip(relations, weights.tolist(), strict=False):
        params: dict[str, Any] = {}
        for name, end, value in numbers_of(relation):
            new = float(numbers[at])
            at += 1
            if end == 0:
                params[name] = (new, float(numbers[at]))  # the other end comes next
            if end is None and new != value:
                params[name] = new
        kept = {name: value for name, value in params.items() if value != _now(relation, name)}
        if kept:
            given = {name: getattr(relation, name) for name in type(relation).model_fields}
            relation = type(relation)(**{**given, "params": {**relation.params, **kept}})
        yield relation if weight == relation.weight else relation.model_copy(update={"weight": weight})


def _now(relation: Relation, name: str) -> Any:
    value = relation.params.get(name, CATALOGUE[relation.type].params[name].default)
    return tuple(value) if isinstance(value, list | tuple) else value
