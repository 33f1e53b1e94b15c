"""Problems to device tables: concatenate, offset, upload."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import reduce
from operator import or_

import numpy as np
import warp as wp

from sceneweaver.kernels import tables as k
from sceneweaver.kernels.cells import CELLS

from .compile import LayoutProblem
from .shapes import Prism, reach_of

# The judge lets bodies sink in by 1 mm, zones by 5 mm; the verdict keeps well inside of that, the energy aims at air.
MARGINS = {
    "collision_aim": 2.0e-3,
    "collision_hold": -5.0e-4,
    "bounds_aim": 2.0e-3,
    "bounds_hold": -5.0e-4,
    "zone_aim": 0.0,
    "zone_hold": -4.5e-3,
    "least_overlap_z": 5.0e-4,
}
WEIGHTS = {
    "collision": 1.0,
    "bounds": 1.0,
    "zone": 1.0,
    "opening": 1.0,
    "relation": 1.0,
    "pull": 0.0,
    "knee": 0.05,
}
SQUARE = 1.0e-6  # [m] by which a rectangle may be off


def margins() -> k.Margins:
    """Clearances of energy and verdict."""
    m = k.Margins()
    for name, value in MARGINS.items():
        setattr(m, name, value)
    return m


def weights(**changes: float) -> k.Weights:
    """Default weights with changes."""
    w = k.Weights()
    for name, value in (WEIGHTS | changes).items():
        setattr(w, name, value)
    return w


@dataclass
class Packed:
    """Tables of a batch of problems on one device, with the largest counts for launch sizes and all kinds of terms."""

    tables: wp.array  # of one k.Tables
    keep: k.Tables  # the arrays that it points to
    problems: Sequence[LayoutProblem]
    objects: int
    relations: int
    terms: int
    device: str


class _Prisms:
    """Prism table under construction."""

    def __init__(self) -> None:
        self.start = [0]
        self.z: list[tuple[float, float]] = []
        self.disc: list[tuple[float, float, float]] = []
        self.box: list[tuple[float, float, float, float]] = []
        self.vertex: list[np.ndarray] = []
        self.edge: list[np.ndarray] = []
        self.real: list[int] = []

    def add(self, prism: Prism) -> int:
        v = np.asarray(prism.polygon, dtype=np.float64)
        along = np.roll(v, -1, axis=0) - v
        length = np.hypot(along[:, 0], along[:, 1])[:, None]
        out = np.c_[along[:, 1], -along[:, 0]] / np.where(length > 0, length, 1.0)
        if len(v) == 1:
            out = np.array([[1.0, 0.0]])
        centre = 0.5 * (v.min(axis=0) + v.max(axis=0))
        self.start.append(self.start[-1] + len(v))
        self.z.append(prism.z)
        self.disc.append((*centre, reach_of([v - centre])))
        half = 0.5 * np.ptp(v, axis=0)
        real = all(prism.real or (True,))
        box = real and len(v) == 4 and bool(np.all(np.abs(np.abs(v - centre) - half) <= SQUARE))
        half = np.maximum(half, SQUARE) * (1.0 if box else -1.0, 1.0 if real else -1.0)
        self.box.append((*centre, *half))
        self.vertex.append(v)
        self.edge.append(np.c_[out, np.sum(out * v, axis=1)])
        self.real += [int(r) for r in (prism.real or (True,) * len(v))]
        return len(self.z) - 1

    def is_box(self, index: int) -> bool:
        """True when a prism is its bounding box, of which every face is a way out."""
        return min(self.box[index][2:]) > 0


class _Ranges:
    """A CSR list under construction."""

    def __init__(self) -> None:
        self.start = [0]
        self.values: list = []

    def add(self, values) -> None:
        self.values.extend(values)
        self.start.append(len(self.values))

    def of(self, index: int) -> list:
        return self.values[self.start[index] : self.start[index + 1]]


def _grid(problem: LayoutProblem) -> tuple[float, float, float, float, int, int]:
    """Cells over a problem's place: lowest corner, edge, the largest reach of an object, columns, rows."""
    x0, y0, x1, y1 = problem.region.box
    shapes = zip(problem.solids, problem.zones, strict=True)
    reach = max((reach_of([p.polygon for p in (*solids, *zones)]) for solids, zones in shapes), default=1.0)
    edge = max(0.75, 0.5 * reach, 1.02 * math.sqrt((x1 - x0) * (y1 - y0) / CELLS), max(x1 - x0, y1 - y0) / 64)
    columns, rows = (max(1, math.ceil(length / edge)) for length in (x1 - x0, y1 - y0))
    while columns * rows > CELLS:
        edge *= 1.05
        columns, rows = (max(1, math.ceil(length / edge)) for length in (x1 - x0, y1 - y0))
    return x0, y0, edge, reach, columns, rows


def pack(problems: Sequence[LayoutProblem], device: str, pools: Sequence[Sequence[np.ndarray]] | None = None) -> Packed:
    """Concatenate the tables of problems and put them on a device.

    ``pools`` gives, for every surface of every problem, layouts [entries, members, 4] in the supporter's frame, the
    same number of entries throughout; without it searches leave surfaces as they are.
    """
    prisms = _Prisms()
    foot, members, groups = (_Ranges() for _ in range(3))
    ranges: list[tuple[int, int]] = []  # of prisms: solids and zones of every object
    touch, fixture, plane, option, row, snap = (_Ranges() for _ in range(6))
    surfaces, surface_members, pool = (_Ranges() for _ in range(3))
    supporters: list[int] = []
    surface_heights: list[float] = []
    roles: list[int] = []
    kinds: list[int] = []
    object_start, relation_start, pair_start = [0], [0], []
    flags: list[np.ndarray] = []
    reach: list[tuple[float, float]] = []
    heights: list[tuple[float, float]] = []
    triples: list[tuple[int, int, int]] = []
    relation_weight: list[float] = []
    relation_fault: list[int] = []
    relation_rigid: list[int] = []
    relation_kind: list[int] = []
    boxes: list[int] = []
    terms: list[int] = []
    fields: dict[str, list] = {n: [] for n in ("feature", "frame", "aim", "prism", "hold")}

    def table(shapes: Sequence[Prism]) -> list[int]:
        return [prisms.add(s) for s in shapes]

    for which, problem in enumerate(problems):
        n = problem.size
        pair_start.append(sum(f.size for f in flags))
        parts: list[list[tuple[int, int]]] = [[] for _ in range(n)]
        for r, rel in enumerate(problem.relations):
            for i in sorted({o for o in rel.objects if o >= 0}):
                parts[i].append((r, rel.objects.index(i)))
        carried = np.bincount(problem.roots, minlength=n)
        for i in range(n):
            begin = len(prisms.z)
            for shapes in (problem.solids[i], problem.zones[i]):
                first = len(prisms.z)
                table(shapes)
                ranges.append((first, len(prisms.z)))
            whole = (begin, len(prisms.z))
            foot.add(table([Prism(p, (0.0, 0.0)) for p in problem.footprints[i]]))
            near = reach_of([s.polygon for s in problem.solids[i]])
            reach.append((near, max(near, reach_of([z.polygon for z in problem.zones[i]]))))
            heights.append((min(s.z[0] for s in problem.solids[i]), max(s.z[1] for s in problem.solids[i])))
            members.add(problem.groups[i][: carried[i]] if problem.roots[i] == i else [])
            groups.add(problem.groups[i])
            mine = [d for d, surface in enumerate(problem.surfaces) if problem.roots[surface.supporter] == i]
            surfaces.add(mine)
            for d in mine:
                supporters.append(problem.surfaces[d].supporter)
                surface_heights.append(problem.surfaces[d].height)
                surface_members.add(problem.surfaces[d].members)
                pool.add(pools[which][d].reshape(-1, 4) if pools else [])
            boxes.append(int(all(prisms.is_box(b) for b in range(*whole))))
            touch.add([r for r, _ in parts[i]])
            roles += [role for _, role in parts[i]]
        region = problem.region
        fixture.add(table([*region.solids, *region.openings]))
        kinds += [k.FIXTURE_SOLID] * len(region.solids) + [k.FIXTURE_OPENING] * len(region.openings)
        plane.add([tuple(p) for p in region.planes])
        for rel in problem.relations:
            triples.append(rel.objects)
            relation_weight.append(rel.weight)
            relation_fault.append(rel.fault)
            roots = {int(problem.roots[o]) for o in rel.objects if o >= 0}
            alone = rel.objects[1] < 0
            relation_rigid.append(int(len(roots) == 1 and not alone))
            first = len(row.start) - 1
            rows_before = len(fields["feature"])
            for rows in rel.options:
                kept = [r for r in rows if not r.is_open]
                for r in kept:
                    fields["feature"].append(r.feature)
                    fields["frame"].append((*r.normal, *r.point))
                    fields["aim"].append((*r.aim, r.offset, r.scale))
                    fields["prism"].append(-1 if r.polygon is None else prisms.add(Prism(r.polygon, (0.0, 0.0))))
                    fields["hold"].append(r.hold)
                row.add(kept)
                snap.add([r for r in rows if r.exact is not None])
            option.add(range(first, len(row.start) - 1))
            rest = {f for f in fields["feature"][rows_before:] if f >= k.FEATURES_PLAIN}
            shapes = [f for o in rel.objects[:2] if o >= 0 for f in foot.of(object_start[-1] + o)]
            shapes += [f for f in fields["prism"][rows_before:] if f >= 0]
            distances = rest == {k.FEATURE_DISTANCE} and all(map(prisms.is_box, shapes))
            relation_kind.append(int(k.FORMULAS if not rest else k.DISTANCES if distances else k.RELATIONS))
        boxy = np.array(boxes[object_start[-1] :], dtype=bool)
        round_pairs = (problem.flags != 0) & ~(boxy[:, None] & boxy)
        flags.append((problem.flags | np.where(round_pairs, k.PAIR_POLYGON, 0)).ravel())
        all_boxes = boxy.all() and all(map(prisms.is_box, fixture.of(which)))
        always = int(k.BOUNDS) | int(k.PULL) | int(k.BOXES) | (0 if all_boxes else int(k.POLYGONS))
        kinds_of = relation_kind[relation_start[-1] :]
        terms += [reduce(or_, (kinds_of[r] for r, _ in mine), always) for mine in parts]
        object_start.append(object_start[-1] + n)
        relation_start.append(relation_start[-1] + len(problem.relations))

    first_snap = len(fields["feature"])
    for r in snap.values:  # behind all others, which the energy reads; rows with prisms have no exact value
        fields["feature"].append(r.feature)
        fields["frame"].append((*r.normal, *r.point))
        fields["aim"].append((r.exact.value, r.exact.alike, r.offset, r.scale))
        fields["prism"].append(-1)
        fields["hold"].append(r.exact.within)

    def ints(values) -> wp.array:
        return wp.array(np.asarray(values, dtype=np.int32).reshape(-1), dtype=wp.int32, device=device)

    def floats(values, dtype) -> wp.array:
        width = 1 if dtype is wp.float32 else dtype._length_
        data = np.asarray(values, dtype=np.float32)
        if width == 4 and data.ndim == 2 and data.shape[1] == 3:
            data = np.pad(data, ((0, 0), (0, 1)))
        return wp.array(data.reshape(-1, width) if width > 1 else data.reshape(-1), dtype=dtype, device=device)

    t = k.Tables()
    for name, values in {
        "object_start": object_start,
        "relation_start": relation_start,
        "fixture_start": fixture.start,
        "plane_start": plane.start,
        "pair_start": pair_start,
        "object_free": np.concatenate([p.free for p in problems]),
        "object_clear": np.concatenate([p.clear for p in problems]),
        "object_boxes": boxes,
        "object_terms": terms,
        "object_root": np.concatenate([p.roots for p in problems]),
        "object_parent": np.concatenate([p.parents for p in problems]),
        "group_start": groups.start,
        "group": groups.values,
        "movable": [int(np.sum((p.free != 0) & (p.roots == np.arange(p.size)))) for p in problems],
        "surface_start": surfaces.start,
        "surface_supporter": supporters,
        "surface_member_start": surface_members.start,
        "surface_member": surface_members.values,
        "pool_start": pool.start,
        "member_start": members.start,
        "member": members.values,
        "footprint_start": foot.start,
        "incidence_start": touch.start,
        "incidence": touch.values,
        "incidence_role": roles,
        "footprint": foot.values,
        "prism_start": prisms.start,
        "edge_real": prisms.real,
        "fixture": fixture.values,
        "fixture_kind": kinds,
        "relation_fault": relation_fault,
        "relation_rigid": relation_rigid,
        "relation_kind": relation_kind,
        "option_start": option.start,
        "row_start": row.start,
        "snap_start": first_snap + np.asarray(snap.start),
        "row_feature": fields["feature"],
        "row_prism": fields["prism"],
    }.items():
        setattr(t, name, ints(values))
    outlines = [p.region.box for p in problems]
    for name, dtype, values in (
        ("room_height", wp.float32, [p.region.height for p in problems]),
        ("room_box", wp.vec4, outlines),
        ("surface_height", wp.float32, surface_heights),
        ("pool", wp.vec4, pool.values),
        ("grid", wp.vec4, [(x0, y0, edge, reach) for x0, y0, edge, reach, _, _ in map(_grid, problems)]),
        ("object_size", wp.vec3, np.concatenate([p.sizes for p in problems])),
        ("object_radius", wp.vec2, reach),
        ("object_z", wp.vec2, heights),
        ("prism_z", wp.vec2, prisms.z),
        ("prism_disc", wp.vec4, prisms.disc),
        ("prism_box", wp.vec4, prisms.box),
        ("vertex", wp.vec2, np.concatenate(prisms.vertex) if prisms.vertex else []),
        ("edge", wp.vec4, np.concatenate(prisms.edge) if prisms.edge else []),
        ("plane", wp.vec4, plane.values),
        ("relation_weight", wp.float32, relation_weight),
        ("row_frame", wp.vec4, fields["frame"]),
        ("row_aim", wp.vec4, fields["aim"]),
        ("row_hold", wp.vec2, fields["hold"]),
    ):
        setattr(t, name, floats(values, dtype))
    t.parts = wp.array(np.asarray(ranges, dtype=np.int32).reshape(-1, 2), dtype=wp.vec2i, device=device)
    t.pool_size = len(next((entries for layouts in pools or () for entries in layouts), ()))
    t.pair_flags = wp.array(np.concatenate(flags).astype(np.uint8), dtype=wp.uint8, device=device)
    t.grid_count = wp.array([g[4:] for g in map(_grid, problems)], dtype=wp.vec2i, device=device)
    t.relation_object = wp.array(np.asarray(triples, dtype=np.int32).reshape(-1, 3), dtype=wp.vec3i, device=device)
    return Packed(
        wp.array([t], dtype=k.Tables, device=device),
        t,
        problems,
        max((p.size for p in problems), default=0),
        max((len(p.relations) for p in problems), default=0),
        reduce(or_, terms, 0),
        device,
    )
