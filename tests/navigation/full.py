"""Homes full of boxes, and rivals that search for shortest ways in other manners."""

from __future__ import annotations

import itertools
import math
from typing import Any

import numpy as np
import shapely

from sceneweaver.home import Home
from sceneweaver.navigation import Roadmap
from tests.verify.build import box
from tests.verify.home.homes import flat, thing


def boxes(low: tuple[float, float], high: tuple[float, float], count: int, seed: int) -> list[dict[str, Any]]:
    """Boxes that stand about, turned, also into each other."""
    drawn = np.random.default_rng(seed).uniform((0.2, 0.2, *low, 0), (0.8, 0.8, *high, 360), (count, 5)).tolist()
    return [box(f"box-{k}", (depth, width, 1.0), x, y, yaw) for k, (depth, width, x, y, yaw) in enumerate(drawn)]


def full_flat(seed: int = 0) -> Home:
    """The flat with boxes in three rooms, a bed and two sofas."""
    return flat(
        bedroom_2=[thing("bed", "bed", (2.0, 1.6, 0.5), 9.0, 6.5, 180.0), *boxes((6.8, 4.6), (9.6, 5.2), 2, seed)],
        living=[
            thing("sofa", "sofa", (0.9, 2.0, 0.8), 0.8, 2.4),
            thing("sofa-2", "sofa", (0.9, 1.6, 0.8), 3.0, 0.8, 90.0),
            *boxes((1.5, 1.5), (3.5, 3.5), 3, seed + 1),
        ],
        kitchen=boxes((0.8, 5.5), (3.8, 7.2), 4, seed + 2),
    )


def places(roadmap: Roadmap, count: int, seed: int) -> np.ndarray:
    """Places [count, 2] of the base in the largest region."""
    region = largest(roadmap)
    rng, found = np.random.default_rng(seed), []
    while len(found) < count:
        point = rng.uniform(region.bounds[:2], region.bounds[2:])
        if shapely.contains_xy(region, *point):
            found.append(point)
    return np.array(found)


def largest(roadmap: Roadmap) -> Any:
    """The largest region of all storeys."""
    return max((r for floor in roadmap.ways.floors.values() for r in floor.regions), key=lambda region: region.area)


def seen_from_everywhere(region: Any, points: np.ndarray) -> Any:
    """A graph of networkx of all corners of a region and some points that see each other, whatever a way does there."""
    import networkx

    rings = [region.exterior, *region.interiors]
    nodes = np.concatenate([points, *(np.asarray(ring.coords)[:-1] for ring in rings)])
    grown = region.buffer(1e-7, join_style="mitre")
    shapely.prepare(grown)
    i, j = np.triu_indices(len(nodes), 1)
    lines: Any = shapely.linestrings(np.stack([nodes[i], nodes[j]], axis=1))
    seen = shapely.covers(grown, lines)
    graph = networkx.Graph()
    graph.add_weighted_edges_from(
        zip(i[seen].tolist(), j[seen].tolist(), shapely.length(lines[seen]).tolist(), strict=True)
    )
    return graph


def on_grid(region: Any, start: np.ndarray, goal: np.ndarray, cell: float) -> float:
    """The length of the shortest way over a fine grid with steps to cells up to 5 away [m], by Dijkstra's algorithm.

    Steps may jump over what is thinner than they are long."""
    from scipy.sparse import csr_array
    from scipy.sparse.csgraph import dijkstra

    low = np.array(region.bounds[:2]) - cell
    count = np.ceil((np.array(region.bounds[2:]) + cell - low) / cell).astype(int)
    x, y = (low[k] + (np.arange(count[k]) + 0.5) * cell for k in (0, 1))
    shapely.prepare(region)
    free = shapely.contains_xy(region, *np.meshgrid(x, y, indexing="ij"))
    number = np.full(free.shape, -1)
    number[free] = np.arange(free.sum())
    steps = [(a, b) for a, b in itertools.product(range(-5, 6), repeat=2) if math.gcd(a, b) == 1 and (a, b) > (0, 0)]
    rows, columns, lengths = [], [], []
    for a, b in steps:
        here = number[: count[0] - a, max(-b, 0) : count[1] - max(b, 0)]
        there = number[a:, max(b, 0) : count[1] + min(b, 0)]
        both = (here >= 0) & (there >= 0)
        rows.append(here[both])
        columns.append(there[both])
        lengths.append(np.full(both.sum(), math.hypot(a, b) * cell))
    size = int(free.sum())
    graph = csr_array((np.concatenate(lengths), (np.concatenate(rows), np.concatenate(columns))), shape=(size, size))
    ends = [number[tuple(((point - low) / cell).astype(int))] for point in (start, goal)]
    return float(dijkstra(graph, directed=False, indices=ends[0])[ends[1]])
