"""Raster-to-Vector annotations (LIFULL): a flat as lines of text, ``x0 y0 x1 y1 kind n n`` with tabs between.

``wall`` and ``door`` are lines on the middles of walls, in pixels of a picture with y DOWN; a ``door`` is any opening.
Words of rooms are boxes somewhere within their rooms, words of fixtures boxes around them. No file says how large a
pixel is. Baths, toilets and doors of flats are much alike, so the middle of what each of them says is taken.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from statistics import median

import numpy as np

from sceneweaver.geometry.polygons import signed_area
from sceneweaver.io import InputError
from sceneweaver.io.messages import path_name, show
from sceneweaver.io.reading import open_regular

from ..line_plans import MOST_LINES, Label, enclosed, labelled, numbered, rooms_of
from ..model import ReadOptions, SourceFormat, SourceOpening, SourceRoom
from ..outlines import holds
from ..values import LARGEST

DOOR, BATH, TOILET = 0.75, 2.4, 1.3
"""Width [m] of a door, floor [m2] of a bathroom and of a room for a toilet: as flats usually have them."""

SLIDES = 1.0
"""Openings between two rooms that are wider than this [m], and those of closets, slide."""

SNAP = 4.0
"""Ends of walls nearer than this [pixels] meet."""

ROOMS = {
    "living_room": "living_room",
    "kitchen": "kitchen",
    "bedroom": "bedroom",
    "bathroom": "wet_room",  # a bath without a toilet, as Japanese flats have it
    "restroom": "guest_toilet",
    "washing_room": "laundry_room",
    "balcony": "balcony",
    "corridor": "hallway",
    "closet": "closet",
    "PS": "shaft",
    "outside": "outside",
    "stairs": "stairs",
}
TELLING = {"entrance": "entrance_hall", "bathtub": "wet_room", "toilet": "guest_toilet", "cooking_counter": "kitchen"}
"""Fixtures that tell what a room is where no word stands in it."""

CUPBOARD = 2.5
"""A room without a word and with less floor [m2] is a closet."""

FRONT = 1.6
"""Widest front [m] of a closet for which none is drawn."""

APART = 0.3
"""Pieces of a picture farther apart than this [m] are storeys."""

CLOSET_OF = {"bedroom", "living_room", "living_kitchen", "hallway", "laundry_room", "kitchen", "entrance_hall", "room"}
HALL_OF = {"hallway", "kitchen", "living_kitchen", "living_room", "entrance_hall", "bedroom", "stairs"}
"""What a closet without an opening, and an entrance without a way on, are joined to."""

KINDS = {*ROOMS, *TELLING, "wall", "door", "washing_basin", "special", "entrance"}
MOST_BYTES = 2**20


def matches(path: Path, head: bytes) -> bool:
    """Text whose first lines are four numbers, a word of the annotations and two numbers."""
    if path.suffix.lower() != ".txt":
        return False
    rows = [row.split() for row in head.decode("utf-8", "replace").splitlines()[:8] if row.strip()]
    return bool(rows) and all(len(row) >= 5 and row[4] in KINDS for row in rows[:-1] or rows)


def read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    """The rooms of the flat, the largest first."""
    where = path_name(path)
    lines = _lines(path, where)
    walls = np.array([ends for kind, ends in lines if kind == "wall"])
    if not len(walls):
        raise InputError(f"{where}: no line of it is a wall; the fifth word of a wall's line is 'wall'")
    rings = enclosed(walls * np.array([1.0, -1.0, 1.0, -1.0]), SNAP)
    if not rings:
        raise InputError(f"{where}: its walls enclose no room; ends of walls must meet within {SNAP:g} pixels")
    middles = [(kind, ((e[0] + e[2]) / 2, -(e[1] + e[3]) / 2)) for kind, e in lines]
    words = labelled(rings, [Label(kind, point) for kind, point in middles if kind in ROOMS])
    fixtures = labelled(rings, [Label(kind, point) for kind, point in middles if kind in TELLING])
    doors = [(np.array([e[0], -e[1]]), np.array([e[2], -e[3]])) for kind, e in lines if kind == "door"]
    kinds = [_kind(w, f) for w, f in zip(words, fixtures, strict=True)]
    inside = [_sides(a, b, rings, kinds) for a, b in doors]
    opened = {k for sides in inside if len(sides) == 2 for k in sides}
    entries = [k for k, f in enumerate(fixtures) if "entrance" in f]
    kinds = ["shaft" if kind == "room" and k not in {*opened, *entries} else kind for k, kind in enumerate(kinds)]
    unit, known = _unit(doors, inside, rings, kinds, options.scale)
    said = [known]
    if not any(len(sides) == 1 and sides[0] in entries for sides in inside):
        entries, told = _entries(doors, inside, kinds)
        said.append(told)
    kinds = _with_entrance(kinds, entries)
    small = [signed_area(ring) * unit * unit < CUPBOARD for ring in rings]
    kinds = ["closet" if kind == "room" and less else kind for kind, less in zip(kinds, small, strict=True)]
    openings = []
    for n, ((a, b), sides) in enumerate(zip(doors, inside, strict=True)):
        outer = len(sides) < 2
        window = outer and not (set(sides) & set(entries))
        kind = "window" if window else "door"
        ends = [(float(p[0] * unit), float(p[1] * unit)) for p in (a, b)]
        slides = not outer and (math.dist(*ends) > SLIDES or any(kinds[k] in ("closet", "balcony") for k in sides))
        openings.append(
            SourceOpening(
                f"{kind}_{n}",
                kind,
                ends[0],
                ends[1],
                swing="slide" if slides else None,
                leads_to="outside" if outer and not window else None,
            )
        )
    metres = [ring * unit for ring in rings]
    openings += _assumed(metres, kinds, entries, {k for sides in inside if len(sides) == 2 for k in sides}, said)
    names = numbered(kinds)
    pieces = _pieces(metres, entries)
    for k, (name, kind, ring) in enumerate(zip(names, kinds, metres, strict=True)):
        if options.room in (None, name):
            yield from rooms_of([(name, kind, ring)], openings, 0.2, said, storey=pieces[k])


def _lines(path: Path, where: str) -> list[tuple[str, tuple[float, float, float, float]]]:
    with open_regular(path, MOST_BYTES) as file:
        text = file.read(MOST_BYTES + 1).decode("utf-8", "replace")
    if len(text) > MOST_BYTES:
        raise InputError(f"{where}: larger than {MOST_BYTES >> 20} MB; a flat a file is read")
    found = []
    for number, row in enumerate(text.splitlines(), 1):
        parts = row.split()
        if not parts:
            continue
        try:
            a, b, c, d = (float(v) for v in parts[:4])
            kind = parts[4]
        except (ValueError, IndexError):
            raise InputError(f"{where}: line {number}: {show(row[:40])}; give x0 y0 x1 y1 and a word") from None
        if not max(map(abs, (a, b, c, d))) <= LARGEST:
            raise InputError(f"{where}: line {number}: {show(row[:40])}: numbers must be finite pixels")
        found.append((kind, (a, b, c, d)))
    if len(found) > MOST_LINES:
        raise InputError(f"{where}: {len(found)} lines; at most {MOST_LINES} are read")
    if not found:
        raise InputError(f"{where}: the file is empty; give a line for each wall, opening, room and fixture")
    return found


def _kind(words: list[str], fixtures: list[str]) -> str:
    """What a room is by the words in it, else by its fixtures."""
    found = {ROOMS[word] for word in words}
    if "wet_room" in found and "toilet" in fixtures:
        return "bathroom"
    if {"living_room", "kitchen"} <= found:
        return "living_kitchen"
    for kind in ("living_room", "bedroom", "kitchen", "balcony"):
        if kind in found:
            return kind
    if "wet_room" in found and "guest_toilet" in found:
        return "bathroom"
    if found:
        return next(ROOMS[word] for word in words)
    told = [TELLING[f] for f in fixtures]
    if "wet_room" in told and "guest_toilet" in told:
        return "bathroom"
    return told[0] if told else "room"


def _entries(
    doors: list[tuple[np.ndarray, np.ndarray]], inside: list[list[int]], kinds: list[str]
) -> tuple[list[int], str]:
    """The room with the entrance, where no word says it: the hall, else the kitchen, that opens to the outside."""
    outer = [sides[0] for sides in inside if len(sides) == 1]
    for kind in ("entrance_hall", "hallway", "kitchen", "living_kitchen"):
        found = next((k for k in outer if kinds[k] == kind), None)
        if found is not None:
            return [found], f"no word says where the entrance is: the opening of the {kind} to the outside is taken"
    return [], "no word says where the entrance is"


def _assumed(
    rings: list[np.ndarray], kinds: list[str], entries: list[int], joined: set[int], notes: list[str]
) -> list[SourceOpening]:
    """Openings that the annotations leave out: fronts of closets, and the step between the entrance and the hall."""
    found = []
    for k, kind in enumerate(kinds):
        if k in joined or (kind != "closet" and k not in entries):
            continue
        behind = CLOSET_OF if kind == "closet" else HALL_OF
        shared = [line for j, other in enumerate(kinds) if j != k and other in behind for line in _shared(rings, k, j)]
        if not shared:
            continue
        a, b = max(shared, key=lambda line: math.dist(*line))
        length = math.dist(a, b)
        low = 0.5 - min(FRONT, length - 0.2) / 2 / length
        if length < 0.5:
            continue
        (x0, y0), (x1, y1) = a, b
        ends = [(x0 + t * (x1 - x0), y0 + t * (y1 - y0)) for t in (low, 1 - low)]
        if kind == "closet":
            found.append(SourceOpening(f"front_{k}", "door", ends[0], ends[1], swing="slide"))
        else:
            found.append(SourceOpening(f"step_{k}", "passage", ends[0], ends[1]))
    if found:
        notes.append(
            f"{len(found)} openings assumed: fronts of closets, the step at the entrance, which none is drawn for"
        )
    return found


def _shared(rings: list[np.ndarray], k: int, j: int) -> list[tuple[tuple[float, float], tuple[float, float]]]:
    """Lines that the outlines of two rooms share."""
    found = []
    for a, b in zip(rings[k], np.roll(rings[k], -1, axis=0), strict=True):
        way = (b - a) / np.hypot(*(b - a))
        for c, d in zip(rings[j], np.roll(rings[j], -1, axis=0), strict=True):
            off = [abs(float(way[0] * (p - a)[1] - way[1] * (p - a)[0])) for p in (c, d)]
            low, high = sorted((float((c - a) @ way), float((d - a) @ way)))
            low, high = max(low, 0.0), min(high, float(np.hypot(*(b - a))))
            if max(off) < 0.01 and high - low > 0.1:
                found.append(tuple((float(x), float(y)) for x, y in (a + low * way, a + high * way)))
    return found


def _pieces(rings: list[np.ndarray], entries: list[int]) -> list[str]:
    """The storey of each room: pieces of a picture that do not touch are storeys, that of the entrance the lowest."""
    import shapely

    grown = shapely.union_all([shapely.Polygon(ring).buffer(APART / 2, join_style="mitre") for ring in rings])
    parts = shapely.get_parts(grown)
    if len(parts) == 1:
        return ["" for _ in rings]
    inner = [shapely.Polygon(ring).representative_point() for ring in rings]
    of = [next(n for n, part in enumerate(parts) if part.intersects(point)) for point in inner]
    size = {n: sum(shapely.Polygon(r).area for r, m in zip(rings, of, strict=True) if m == n) for n in set(of)}
    order = sorted(size, key=lambda n: (n not in [of[k] for k in entries], -size[n]))
    return [str(order.index(n)) for n in of]


def _with_entrance(kinds: list[str], entries: list[int]) -> list[str]:
    """Types of rooms where the word entrance stands in one: a closet is the hall then, the only bedroom a studio."""
    alone = sum(kind in ("bedroom", "living_room", "living_kitchen") for kind in kinds) == 1
    told = {"closet": "entrance_hall", "room": "entrance_hall"} | ({"bedroom": "studio_apartment"} if alone else {})
    return [told.get(kind, kind) if k in entries else kind for k, kind in enumerate(kinds)]


def _sides(a: np.ndarray, b: np.ndarray, rings: list[np.ndarray], kinds: list[str]) -> list[int]:
    """The rooms on the two sides of an opening, by numbers."""
    along = (b - a) / max(1e-9, float(np.hypot(*(b - a))))
    across = np.array([-along[1], along[0]]) * (SNAP + 2)
    found: list[int] = []
    for point in ((a + b) / 2 + across, (a + b) / 2 - across):
        found += [
            k for k, ring in enumerate(rings) if kinds[k] not in ("shaft", "outside") and holds(ring, point.tolist())
        ]
    return found


def _unit(
    doors: list[tuple[np.ndarray, np.ndarray]],
    sides: list[list[int]],
    rings: list[np.ndarray],
    kinds: list[str],
    scale: float | None,
) -> tuple[float, str]:
    """Metres of a pixel, and how that was found."""
    if scale is not None:
        return scale, f"a pixel is {scale:g} m, as given"
    said = [
        DOOR / float(np.hypot(*(b - a)))
        for (a, b), rooms in zip(doors, sides, strict=True)
        if len(rooms) == 2 and (a != b).any() and not any(kinds[k] in ("closet", "balcony", "room") for k in rooms)
    ]
    usual = {"wet_room": BATH, "guest_toilet": TOILET}
    said += [
        math.sqrt(usual[kind] / signed_area(ring)) for kind, ring in zip(kinds, rings, strict=True) if kind in usual
    ]
    if not said:
        raise InputError("nothing says how large a pixel is: no door, bath or toilet; give a scale, metres for a pixel")
    unit = median(said)
    return unit, f"a pixel is taken for {unit:.4g} m, as the doors, baths and toilets of a flat usually are"


FORMAT = SourceFormat(
    name="r2v",
    title="Raster-to-Vector annotations (LIFULL flats)",
    matches=matches,
    read=read,
    notes=(
        "Read: walls, openings and words of rooms, a flat a .txt file: a room is what walls enclose, with the word in "
        "it, or what its fixtures tell.",
        "Meaning: lines are middles of walls in pixels with y down. An opening between two rooms is a door, one to the "
        "outside a window, but from a room with the word entrance it is the entrance.",
        "Assumed: the scale, which no file states: the middle of what doors (0.75 m wide), bathrooms (2.4 m2) and "
        "rooms for a toilet (1.3 m2) say; closets and openings wider than 1 m slide; heights.",
        "Lost: fixtures, kinds of doors.",
    ),
    licence="MIT (annotations of Raster-to-Vector)",
)
