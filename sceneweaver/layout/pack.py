"""Problems to device tables: concatenate, offset, upload."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache, reduce
from operator import or_
from typing import Any, NamedTuple, cast

import numpy as np
import warp as wp

from sceneweaver.kernels import tables as k
from sceneweaver.kernels.cells import CELLS

from .compile import LayoutProblem
from .rows import Row, Snap
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
    "soft": 1.0,
    "knee": 0.05,
}
PULL = 0.02  # [1/m] weight of the pull towards given poses, small beside any violation
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


class _Columns:
    """The tables under construction, by name: lists that become arrays in `arrays`."""

    def __init__(self) -> None:
        self.of: dict[str, list] = {table.name: [0] if "+ 1" in table.shape[0] else [] for table in k.TABLES}

    def add(self, **values: Any) -> None:
        """Append one element to each of some tables."""
        for name, value in values.items():
            self.of[name].append(value)

    def add_range(self, name: str, values: Sequence) -> None:
        """Append a range of a table that has a ``*_start``."""
        self.of[name] += values
        self.end_range(name, len(self.of[name]))

    def end_range(self, name: str, end: int) -> None:
        """Say where the next range of a table begins."""
        self.of[f"{name}_start"].append(end)

    def range_of(self, name: str, index: int) -> list:
        """The elements of a range."""
        start = self.of[f"{name}_start"]
        return self.of[name][start[index] : start[index + 1]]

    def count(self, name: str) -> int:
        """How many elements a table has so far."""
        return len(self.of[name])

    def add_prism(self, prism: Prism) -> int:
        """Append a prism; its index."""
        v = np.asarray(prism.polygon, dtype=np.float64)
        rows = _plan_rows(v.tobytes(), prism.real)
        self.add(prism_z=prism.z, prism_disc=rows.disc, prism_box=rows.box)
        self.of["vertex"] += rows.vertices
        self.of["edge"] += rows.edges
        self.of["edge_real"] += rows.real
        self.end_range("prism", self.count("vertex"))
        return self.count("prism_z") - 1

    def add_prisms(self, prisms: Sequence[Prism]) -> list[int]:
        """Append prisms; their indices."""
        return [self.add_prism(prism) for prism in prisms]

    def is_box(self, prism: int) -> bool:
        """True when a prism is its bounding box, of which every face is a way out."""
        return min(self.of["prism_box"][prism][2:]) > 0

    def arrays(self, device: str) -> k.Tables:
        """The tables on a device."""
        tables = k.Tables()
        for table in k.TABLES:
            scalar, width = getattr(table.dtype, "_wp_scalar_type_", table.dtype), getattr(table.dtype, "_length_", 1)
            values = np.asarray(self.of[table.name], dtype=wp.dtype_to_numpy(scalar))
            values = values.reshape(-1, width) if width > 1 else values.reshape(-1)
            setattr(tables, table.name, wp.array(values, dtype=table.dtype, device=device))
        return tables


class _PlanRows(NamedTuple):
    """What the tables say of a prism's polygon. One polygon stands in many problems: its rows are kept, not to
    change."""

    disc: tuple[float, float, float, float]
    box: tuple[float, float, float, float]
    vertices: list[list[float]]
    edges: list[list[float]]
    real: list[int]


@lru_cache(maxsize=1024)
def _plan_rows(polygon: bytes, real: tuple[bool, ...] | None) -> _PlanRows:
    """The rows of a polygon [V, 2] float64; ``real`` as in `Prism`."""
    v = np.frombuffer(polygon).reshape(-1, 2)
    along = v[[*range(1, len(v)), 0]] - v
    length = np.hypot(along[:, 0], along[:, 1])[:, None]
    edge = np.zeros((len(v), 4))
    edge[:, 0], edge[:, 1] = along[:, 1], -along[:, 0]
    edge[:, :2] /= np.where(length > 0, length, 1.0)
    if len(v) == 1:
        edge[:, 0] = 1.0
    edge[:, 2] = np.sum(edge[:, :2] * v, axis=1)
    centre = 0.5 * (v.min(axis=0) + v.max(axis=0))
    half = 0.5 * np.ptp(v, axis=0)
    faces = real or (True,) * len(v)
    box = all(faces) and len(v) == 4 and bool(np.all(np.abs(np.abs(v - centre) - half) <= SQUARE))
    half = np.maximum(half, SQUARE) * (1.0 if box else -1.0, 1.0 if all(faces) else -1.0)
    (x, y), (a, b) = centre.tolist(), half.tolist()
    disc = (x, y, reach_of([v - centre]), 0.0)
    return _PlanRows(disc, (x, y, a, b), v.tolist(), edge.tolist(), [int(face) for face in faces])


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


def _add_objects(columns: _Columns, problem: LayoutProblem, pools: Sequence[np.ndarray] | None) -> None:
    """Append a problem's objects: their shapes, who goes along with whom, and what stands on them."""
    incidences: list[list[tuple[int, int]]] = [[] for _ in range(problem.size)]
    for r, rel in enumerate(problem.relations):
        for i in sorted({o for o in rel.objects if o >= 0}):
            incidences[i].append((r, rel.objects.index(i)))
    carried = np.bincount(problem.roots, minlength=problem.size)
    for i in range(problem.size):
        solids, zones = problem.solids[i], problem.zones[i]
        prisms = []
        for shapes in (solids, zones):
            first = columns.count("prism_z")
            prisms += columns.add_prisms(shapes)
            columns.add(parts=(first, columns.count("prism_z")))
        flat = [Prism(p, (0.0, 0.0)) for p in problem.footprints[i]]
        columns.add_range("footprint", columns.add_prisms(flat))
        near = reach_of([s.polygon for s in solids])
        columns.add(
            object_size=problem.sizes[i],
            object_radius=(near, max(near, reach_of([z.polygon for z in zones]))),
            object_z=(min(s.z[0] for s in solids), max(s.z[1] for s in solids)),
            object_free=problem.free[i],
            object_clear=problem.clear[i],
            object_boxes=int(all(map(columns.is_box, prisms))),
            object_parent=problem.parents[i],
            object_root=problem.roots[i],
        )
        columns.add_range("yaw", problem.yaws[i])
        columns.add_range("group", problem.groups[i])
        columns.add_range("member", problem.groups[i][: carried[i]] if problem.roots[i] == i else [])
        columns.add_range("incidence", [r for r, _ in incidences[i]])
        columns.of["incidence_role"] += [role for _, role in incidences[i]]
        for d, surface in enumerate(problem.surfaces):
            if problem.roots[surface.supporter] == i:
                columns.add(surface_supporter=surface.supporter, surface_height=surface.height)
                columns.add_range("surface_member", surface.members)
                columns.add_range("pool", pools[d].reshape(-1, 4).tolist() if pools else [])
        columns.end_range("surface", columns.count("surface_supporter"))
    columns.end_range("object", columns.count("object_size"))


def _add_place(columns: _Columns, problem: LayoutProblem) -> None:
    """Append the place that a problem is about: outline, static prisms, cells."""
    region, roots = problem.region, problem.roots == np.arange(problem.size)
    columns.add_range("fixture", columns.add_prisms([*region.solids, *region.openings]))
    kinds = [k.FIXTURE_SOLID] * len(region.solids) + [k.FIXTURE_OPENING] * len(region.openings)
    columns.of["fixture_kind"] += kinds
    columns.add_range("plane", [(*plane, 0.0) for plane in region.planes])
    x0, y0, edge, reach, lines, rows = _grid(problem)
    columns.add(
        room_height=region.height,
        room_box=region.box,
        grid=(x0, y0, edge, reach),
        grid_count=(lines, rows),
        movable=int(np.sum((problem.free != 0) & roots)),
    )


def _add_relations(columns: _Columns, problem: LayoutProblem, first_object: int) -> list[Row]:
    """Append a problem's relations with their options and rows; their rows of exact values, which go behind all."""
    exact = []
    for rel in problem.relations:
        first = columns.count("row_feature")
        for rows in rel.options:
            for row in (r for r in rows if not r.is_open):
                prism = -1 if row.polygon is None else columns.add_prism(Prism(row.polygon, (0.0, 0.0)))
                _add_row(columns, row, row.aim, row.hold, prism)
            exact += [r for r in rows if r.exact is not None]
            columns.end_range("row", columns.count("row_feature"))
            columns.end_range("snap", columns.of["snap_start"][-1] + sum(r.exact is not None for r in rows))
        columns.end_range("option", len(columns.of["row_start"]) - 1)
        rest = {f for f in columns.of["row_feature"][first:] if f >= k.FEATURES_PLAIN}
        shapes = [f for o in rel.objects[:2] if o >= 0 for f in columns.range_of("footprint", first_object + o)]
        shapes += [f for f in columns.of["row_prism"][first:] if f >= 0]
        distances = rest == {k.FEATURE_DISTANCE} and all(map(columns.is_box, shapes))
        roots = {int(problem.roots[o]) for o in rel.objects if o >= 0}
        columns.add(
            relation_object=rel.objects,
            relation_weight=rel.weight,
            relation_fault=rel.fault,
            relation_rigid=int(len(roots) == 1 and rel.objects[1] >= 0),
            relation_kind=int(k.FORMULAS if not rest else k.DISTANCES if distances else k.RELATIONS),
        )
    columns.end_range("relation", columns.count("relation_weight"))
    return exact


def _add_row(columns: _Columns, row: Row, aim: tuple[float, float], hold: tuple[float, float], prism: int) -> None:
    columns.add(
        row_feature=row.feature,
        row_frame=(*row.normal, *row.point),
        row_aim=(*aim, row.offset, row.scale),
        row_prism=prism,
        row_hold=hold,
    )


def _add_terms(columns: _Columns, problem: LayoutProblem, which: int) -> None:
    """Append pair flags, and which kinds of terms each object may have."""
    first_object, first_relation = columns.of["object_start"][which], columns.of["relation_start"][which]
    boxy = np.array(columns.of["object_boxes"][first_object:], dtype=bool)
    round_pairs = (problem.flags != 0) & ~(boxy[:, None] & boxy)
    columns.add(pair_start=columns.count("pair_flags"))
    columns.of["pair_flags"] += (problem.flags | np.where(round_pairs, k.PAIR_POLYGON, 0)).ravel().tolist()
    all_boxes = boxy.all() and all(map(columns.is_box, columns.range_of("fixture", which)))
    always = int(k.BOUNDS) | int(k.PULL) | int(k.BOXES) | (0 if all_boxes else int(k.POLYGONS))
    kinds = columns.of["relation_kind"][first_relation:]
    for i in range(problem.size):
        mine = columns.range_of("incidence", first_object + i)
        columns.add(object_terms=reduce(or_, (kinds[r] for r in mine), always))


def _columns(
    problems: Sequence[LayoutProblem], pools: Sequence[Sequence[np.ndarray]] | None
) -> tuple[_Columns, list[Row]]:
    """The tables of problems but for the rows of exact values, which are the second."""
    columns, exact = _Columns(), []
    for which, problem in enumerate(problems):
        first_object = columns.of["object_start"][-1]
        _add_objects(columns, problem, pools[which] if pools else None)
        _add_place(columns, problem)
        exact += _add_relations(columns, problem, first_object)
        _add_terms(columns, problem, which)
    return columns, exact


def columns_of(problem: LayoutProblem) -> dict[str, list]:
    """The tables of one problem as lists of float64, by name, without the rows of exact values."""
    return _columns([problem], None)[0].of


def pack(problems: Sequence[LayoutProblem], device: str, pools: Sequence[Sequence[np.ndarray]] | None = None) -> Packed:
    """Concatenate the tables of problems (``kernels.tables.TABLES``) and put them on a device.

    ``pools`` gives, for every surface of every problem, layouts [entries, members, 4] in the supporter's frame, the
    same number of entries throughout; without it searches leave surfaces as they are.
    """
    columns, exact = _columns(problems, pools)
    first_exact = columns.count("row_feature")
    for row in exact:  # behind all others, which the energy reads; rows with prisms have no exact value
        snap = cast(Snap, row.exact)
        _add_row(columns, row, (snap.value, snap.alike), snap.within, -1)
    columns.of["snap_start"] = [first_exact + start for start in columns.of["snap_start"]]
    tables = columns.arrays(device)
    tables.pool_size = len(next((entries for layouts in pools or () for entries in layouts), ()))
    return Packed(
        wp.array([tables], dtype=k.Tables, device=device),
        tables,
        problems,
        max((p.size for p in problems), default=0),
        max((len(p.relations) for p in problems), default=0),
        reduce(or_, columns.of["object_terms"], 0),
        device,
    )
