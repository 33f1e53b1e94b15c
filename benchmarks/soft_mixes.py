"""Twenty mixes of soft rows that pull against what is hard: heavy, many, in conflict, or impossible outright.

A mix makes soft relations for a room, the same ones every time. Some use relations and a term of the user's own, which
`defined` enters for as long as they are wanted.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from itertools import combinations, islice, pairwise
from typing import Any

import numpy as np
import warp as wp

import sceneweaver as sw
from sceneweaver.scene import Relation, Scene

OWN = ("same place", "wire", "far east", "askew")
"""Relations of the user's own: one body in another, short wire, outside of the room, at 40 degrees to everything."""

TERM = "huddle"
SLACK = 0.01  # [m] or [rad] that relations of the user's own leave


@wp.func
def same_place(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    d = wp.vec2(a[0] - b[0], a[1] - b[1])
    return wp.sqrt(wp.dot(d, d) + 1.0e-6) - p[0]


@wp.func
def wire(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    return wp.abs(a[0] - b[0]) + wp.abs(a[1] - b[1]) - p[0]


@wp.func
def far_east(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    return p[0] - a[0]


@wp.func
def askew(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    return wp.sin(2.0 * a[3] - p[0]) * wp.sin(2.0 * a[3] - p[0]) - p[1]


@contextmanager
def defined(term: float | None = None, categories: Sequence[str] = ()) -> Iterator[None]:
    """The relations of the user's own are there meanwhile; with ``term`` the term too, of that weight."""
    always: Callable[..., bool] = lambda a, b, p: False  # noqa: E731 - no layout of these is judged by them
    options: dict[str, Any] = {"holds": always, "check": False}
    sw.define_relation("same place", residual=same_place, params={"slack": SLACK}, **options)
    sw.define_relation("wire", residual=wire, params={"slack": SLACK}, **options)
    sw.define_relation("far east", residual=far_east, params={"x": 100.0}, target="none", **options)
    sw.define_relation("askew", residual=askew, params={"turn": 1.4, "slack": SLACK}, target="none", **options)
    if term is not None:
        sw.define_term(
            TERM, residual=wire, subjects=categories, targets=categories, params=[SLACK], weight=term, scale=1.0
        )
    try:
        yield
    finally:
        if term is not None:
            sw.undefine_term(TERM)
        for name in OWN:
            sw.undefine_relation(name)


def bare(scene: Scene) -> Scene:
    """A scene without its soft relations."""
    return scene.model_copy(update={"relations": tuple(r for r in scene.relations if r.hard)})


def judgeable(scene: Scene) -> Scene:
    """A scene without relations of the user's own, which the judge's processes do not know; soft ones may tie zones."""
    return scene.model_copy(update={"relations": tuple(r for r in scene.relations if r.type not in OWN)})


def movable(scene: Scene) -> list[str]:
    """Floor objects that may move, in the same mixed order every time."""
    ids = [o.id for o in scene.objects if o.mount == "floor" and o.support is None and not o.fixed]
    return [ids[i] for i in np.random.default_rng(7).permutation(len(ids))]


def mixed(scene: Scene, name: str) -> Scene:
    """A scene whose soft relations are those of a mix."""
    soft = MIXES[name](movable(scene))
    return bare(scene).model_copy(update={"relations": (*bare(scene).relations, *soft)})


def _soft(kind: str, subject: str, target: str | None = None, weight: float = 1.0, **params: Any) -> Relation:
    return Relation(type=kind, subject=subject, target=target, params=params, hard=False, weight=weight)


def pairs_of(ids: Sequence[str], count: int) -> list[tuple[str, str]]:
    """So many pairs, each object as often as any other."""
    gaps = ((ids[i], ids[(i + gap) % len(ids)]) for gap in range(1, len(ids)) for i in range(len(ids)))
    return list(islice(gaps, count))


def _of_pairs(kind: str, count: int, weight: float = 1.0, **params: Any) -> Callable[[Sequence[str]], list[Relation]]:
    return lambda ids: [_soft(kind, a, b, weight, **params) for a, b in pairs_of(ids, count)]


def _of_each(kind: str, weight: float, **params: Any) -> Callable[[Sequence[str]], list[Relation]]:
    return lambda ids: [_soft(kind, a, None, weight, **params) for a in ids]


def _hub(kind: str, weight: float, **params: Any) -> Callable[[Sequence[str]], list[Relation]]:
    return lambda ids: [_soft(kind, a, ids[0], weight, **params) for a in ids[1:]]


def _torn(ids: Sequence[str]) -> list[Relation]:
    """Everyone near the first and far from the second, which is near the first."""
    near = [_soft("near", a, ids[0], 5.0, max=0.1) for a in ids[1:]]
    return near + [_soft("distance", a, ids[1], 5.0, min=5.0, max=9.0) for a in ids[2:]]


def _both_sides(one: str, other: str) -> Callable[[Sequence[str]], list[Relation]]:
    return lambda ids: [_soft(side, a, b, 5.0) for a, b in pairwise(ids) for side in (one, other)]


def _of_all(ids: Sequence[str]) -> list[Relation]:
    rng = np.random.default_rng(3)
    types = ("near", "facing", "left_of", "parallel", "side_by_side", "centered_on", "same place", "wire")
    return [
        _soft(types[int(rng.integers(len(types)))], a, b, float(rng.uniform(1, 20)))
        for a, b in pairs_of(ids, 4 * len(ids))
    ]


MIXES: dict[str, Callable[[Sequence[str]], list[Relation]]] = {
    "ten nears of weight 10": _of_pairs("near", 10, 10.0, max=0.01),
    "all near one, weight 5": _hub("near", 5.0, max=0.01),
    "near and far at once": _torn,
    "every pair 6 m apart": lambda ids: [
        _soft("distance", a, b, 2.0, min=6.0, max=99.0) for a, b in combinations(ids, 2)
    ],
    "ten in one place": _of_pairs("same place", 10),
    "ten in one place, weight 20": _of_pairs("same place", 10, 20.0),
    "all in the first one": _hub("same place", 5.0),
    "ten wires": _of_pairs("wire", 10),
    "forty-five wires": _of_pairs("wire", 45),
    "ten wires of weight 10": _of_pairs("wire", 10, 10.0),
    "out of the room": _of_each("far east", 5.0),
    "askew, weight 5": _of_each("askew", 5.0),
    "all in corners": _of_each("in_corner", 5.0),
    "all in the middle": _of_each("in_middle", 5.0, offset=0.01),
    "far from doors": _of_each("away_from_door", 5.0, min=20.0),
    "left and right of the next": _both_sides("left_of", "right_of"),
    "before and behind the next": _both_sides("in_front_of", "behind"),
    "all beside one, weight 10": _hub("side_by_side", 10.0),
    "a term of weight 10": lambda ids: [],
    "of all kinds, weights to 20": _of_all,
}
TERMS = {"a term of weight 10": 10.0}
"""Weight of the user's term in the mixes that have it."""
