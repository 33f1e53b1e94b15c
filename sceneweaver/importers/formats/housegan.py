"""RPLAN as House-GAN++ and HouseDiffusion read it: floor plans without furniture, one JSON each.

``room_type`` (a number a node), ``boxes`` [x0, y0, x1, y1] a node, ``edges`` [x0, y0, x1, y1, type, type of the
neighbour] and ``ed_rm`` (the nodes that an edge belongs to, its own first). Nodes of types 15 and 17 are doors, the
others rooms; a room's outline is the ring of its own edges. Pixels of a 256 x 256 picture with y DOWN; RPLAN's pictures
show 18 m x 18 m, so a pixel is 18 / 256 m.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.io import InputError
from sceneweaver.io.messages import path_name

from ..model import ReadOptions, SourceFormat, SourceOpening, SourceRoom
from ..outlines import middle_line, near_wall, ring_of_edges
from ..values import keys_seen, loaded, member, numbers, sequence

PIXEL = 18.0 / 256.0
"""Metres of a pixel of RPLAN's pictures."""

ROOMS = {
    1: "living_room",
    2: "kitchen",
    3: "bedroom",
    4: "bathroom",
    5: "balcony",
    6: "entrance",
    7: "dining_room",
    8: "study",
    10: "storage",
    16: "room",
}
FRONT_DOOR, INNER_DOOR = 15, 17
MOST = 500
"""Rooms and doors of a plan."""

REACH = 8 * PIXEL  # of a door's middle from the face of its wall
CLOSE = 1.5 * PIXEL  # ends of edges nearer than this meet


def matches(path: Path, head: bytes) -> bool:
    """JSON with types of rooms, edges and the rooms of edges."""
    names = keys_seen(head)
    return head.lstrip()[:1] == b"{" and {"room_type", "ed_rm"} <= names


def read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    """The rooms of the plan, in its order."""
    where = path_name(path)
    data = loaded(path)
    types = numbers(member(data, "room_type", where), (None,), f"{where}: room_type").astype(int).tolist()
    edges = numbers(member(data, "edges", where), (None, None), f"{where}: edges")
    if len(types) > MOST or len(edges) > 20 * MOST:
        raise InputError(f"{where}: {len(types)} rooms and {len(edges)} edges; at most {MOST} and {20 * MOST} are read")
    if not len(types):
        raise InputError(f"{where}: room_type: no room in it")
    if len(edges) and edges.shape[1] < 4:
        raise InputError(f"{where}: edges: {edges.shape[1]} numbers; x0, y0, x1, y1 are needed")
    owners = _owners(data, len(edges), len(types), where)
    metres = edges[:, :4] * np.array([1.0, -1.0, 1.0, -1.0]) * PIXEL
    rings: dict[int, np.ndarray | None] = {}
    for node in range(len(types)):
        mine = [k for k, nodes in enumerate(owners) if nodes[0] == node]
        rings[node] = ring_of_edges(metres[mine], CLOSE) if mine else None
    counts: dict[str, int] = {}
    names: dict[int, str] = {}
    for node, kind in enumerate(types):
        if kind not in (FRONT_DOOR, INNER_DOOR):
            word = ROOMS.get(kind, "room")
            names[node] = f"{word}_{counts.setdefault(word, 0)}"
            counts[word] += 1
    doors = {node: kind for node, kind in enumerate(types) if node not in names}
    for node, name in names.items():
        ring = rings[node]
        if options.room is not None and options.room != name:
            continue
        if ring is None:
            ring = _boxed(data, node, where)
        openings, lost = _doors(node, ring, doors, rings, owners, names)
        notes = [f"a pixel is taken for {PIXEL:g} m (RPLAN's pictures show 18 m)"]
        if types[node] not in ROOMS:
            notes.append(f"type {types[node]} of the room is unknown")
        if rings[node] is None:
            notes.append("its edges do not close: its box is the outline")
        if lost:
            notes.append(f"{lost} doors of the room left out: their edges do not close")
        yield SourceRoom(
            name=name,
            type=ROOMS.get(types[node], "room"),
            outline=tuple((float(x), float(y)) for x, y in ring),
            openings=openings,
            notes=tuple(notes),
        )


def _owners(data: Mapping[str, Any], count: int, nodes: int, where: str) -> list[list[int]]:
    """The nodes of each edge, its own first."""
    rows = sequence(member(data, "ed_rm", where), f"{where}: ed_rm")
    if len(rows) != count:
        raise InputError(f"{where}: ed_rm: {len(rows)} entries, but there are {count} edges")
    found = []
    for k, row in enumerate(rows):
        mine = numbers(sequence(row, f"{where}: ed_rm[{k}]"), (None,), f"{where}: ed_rm[{k}]").astype(int).tolist()
        if not mine or min(mine) < 0 or max(mine) >= nodes:
            raise InputError(f"{where}: ed_rm[{k}]: it must name one of the {nodes} rooms")
        found.append(mine)
    return found


def _boxed(data: Mapping[str, Any], node: int, where: str) -> np.ndarray:
    """The outline of a node by its box."""
    boxes = numbers(member(data, "boxes", where, "its edges do not close"), (None, 4), f"{where}: boxes")
    if node >= len(boxes):
        raise InputError(f"{where}: boxes: {len(boxes)} boxes, but room {node} needs one")
    x0, y0, x1, y1 = boxes[node] * PIXEL
    return np.array([(x0, -y1), (x1, -y1), (x1, -y0), (x0, -y0)])


def _doors(
    node: int,
    ring: np.ndarray,
    doors: Mapping[int, int],
    rings: Mapping[int, np.ndarray | None],
    owners: list[list[int]],
    names: Mapping[int, str],
) -> tuple[tuple[SourceOpening, ...], int]:
    """The doors of a room: those that share an edge with it or lie in its walls; and how many do not close."""
    found, lost = [], 0
    for door, kind in doors.items():
        sharing = {n for nodes in owners if door in nodes for n in nodes if n in names}
        shape = rings[door]
        if shape is None:
            lost += node in sharing
            continue
        a, b, _ = middle_line(shape)
        if not near_wall(ring, a, b, REACH) or (sharing and node not in sharing):
            continue
        others = sorted(sharing - {node})
        leads = "outside" if kind == FRONT_DOOR else names[others[0]] if others else None
        found.append(
            SourceOpening(
                name=f"door_{door}",
                kind="door",
                start=(float(a[0]), float(a[1])),
                end=(float(b[0]), float(b[1])),
                leads_to=leads,
            )
        )
    return tuple(found), lost


FORMAT = SourceFormat(
    name="rplan",
    title="RPLAN, House-GAN++ (JSON)",
    matches=matches,
    read=read,
    notes=(
        "Read: room_type, edges and ed_rm (boxes where edges do not close): a room a node with its outline and doors. "
        "There is no furniture in it.",
        "Meaning: pixels with y down, 18 / 256 m each; types as House-GAN++ numbers them (1 living room ... 15 front "
        "door, 17 inner door). A room keeps its place in the plan.",
        "Assumed: a door takes the middle of its box along the longer side; heights are not in the file.",
        "Lost: windows (not in the file), RPLAN's own pictures, from which this JSON is made.",
    ),
    licence="as RPLAN states",
)
