"""Fifty bedrooms by one request: how different their shells, layouts, furniture and palettes are."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

from benchmarks.judging import Judge
from benchmarks.parallel import each
from benchmarks.results import Column, Result
from benchmarks.settings import Settings
from benchmarks.shell_signature import layout_signature, openings, shell_signature
from sceneweaver.agent import design
from sceneweaver.assets import categories
from sceneweaver.scene import Scene

REQUEST = "Design me a bedroom"

SEEDS, QUICK = 50, 2
"""Designs, and how many to see that everything works."""

BEDS, OTHERS = 8, 30
"""Categories of beds, and of other furniture, that as many designs as `SEEDS` have at least."""

SMALL = 0.25
"""Sides [m] of which one makes a thing furniture."""

COLUMNS = (
    Column("seed", "seed", "count"),
    Column("valid", "valid"),
    Column("corners", "corners", "count"),
    Column("floor", "floor m2", "number"),
    Column("openings", "door; windows"),
    Column("palette", "palette"),
    Column("walls", "walls"),
    Column("bed", "bed"),
    Column("furniture", "furniture", "count"),
    Column("objects", "objects", "count"),
    Column("grade", "grade", "number"),
)

SUMMARY = (
    Column("what", "different"),
    Column("found", "found", "count"),
    Column("of", "of", "count"),
    Column("target", "target", "count"),
    Column("most", "most common"),
)


@dataclass(frozen=True)
class Made:
    """One design, as far as it is compared with others."""

    seed: int
    scene: Scene
    valid: bool
    grade: float


def made(seed: int, device: str, most: int | None) -> Made:
    """Design one room, without files."""
    found = design(REQUEST, seed=seed, device=device, candidates=most, time_limit=None)
    return Made(seed, found.scene, found.report.valid, round(found.review.total, 2))


def run(settings: Settings, judge: Judge) -> Result:
    """Design the rooms, several at a time, and compare them."""
    del judge
    result = Result(
        "variety",
        "Sense of variety",
        f"'{REQUEST}' for as many seeds as there are rows. A shell is its shape, its sides to 0.5 m, the place of its "
        "door and windows as seen from the door; a layout is the wall and the third of it, or the middle, for each "
        "piece of furniture. Equal signatures mean that two rooms look alike.",
    )
    count = settings.count or (QUICK if settings.quick else SEEDS)
    seeds = range(settings.seed, settings.seed + count)
    rooms = each(made, [(seed, settings.device, settings.most) for seed in seeds], settings.jobs)
    tabulate(result, rooms)
    return result


def tabulate(result: Result, rooms: Sequence[Made]) -> None:
    """The table of rooms, and how many are different in what; a failure for each target that is missed."""
    table = result.add("rooms", "Rooms", COLUMNS)
    for one in rooms:
        room, finish, palette = one.scene.room, one.scene.room.finish, one.scene.palette
        accent = finish.accent if finish is not None else None
        painted = "" if finish is None else finish.walls + (f" + {accent.color} {accent.kind}" if accent else "")
        floor = "" if finish is None else f"{finish.floor.tone or ''} {finish.floor.material}".strip()
        table.rows.append(
            {
                "seed": one.seed,
                "valid": "yes" if one.valid else "no",
                "corners": len(room.outline),
                "floor": shell_signature(room).area,
                "openings": openings(room),
                "palette": palette.name if palette is not None else "none",
                "walls": f"{painted}; {floor}",
                "bed": ", ".join(sorted({o.category for o in one.scene.objects if is_bed(o.category)})),
                "furniture": len({o.category for o in one.scene.objects if furniture(o.category, o.size)}),
                "objects": len(one.scene.objects),
                "grade": one.grade,
            }
        )
    shells = [str(shell_signature(one.scene.room)) for one in rooms]
    layouts = [layout_signature(one.scene) for one in rooms]
    things = [o for one in rooms for o in one.scene.objects]
    beds = [o.category for o in things if is_bed(o.category)]
    others = [o.category for o in things if furniture(o.category, o.size) and not is_bed(o.category)]
    n, full = len(rooms), len(rooms) >= SEEDS
    counted = (
        ("shell and layout", list(zip(shells, layouts, strict=True)), n),
        ("shells", shells, None),
        ("layouts", layouts, None),
        ("shapes and sides", [str(shell_signature(one.scene.room).sides) for one in rooms], None),
        ("door and window walls", [openings(one.scene.room) for one in rooms], None),
        ("palettes", [row["palette"] for row in table.rows], None),
        ("walls and floors", [row["walls"] for row in table.rows], None),
        ("categories of beds", beds, BEDS if full else None),
        ("sizes of beds (0.1 m)", [_rounded(o.size) for o in things if is_bed(o.category)], None),
        ("designs of beds", [o.asset for o in things if is_bed(o.category)], None),
        ("categories of other furniture", others, OTHERS if full else None),
    )
    summary = result.add("variety", "What is different", SUMMARY)
    for what, values, target in counted:
        counts = Counter(values)
        top, often = counts.most_common(1)[0] if counts else ("", 0)
        most = f"{often} x {top}" if isinstance(top, str) and len(top) < 40 else f"{often} times"
        summary.rows.append({"what": what, "found": len(counts), "of": len(values), "target": target, "most": most})
        if target is not None and len(counts) < target:
            result.failures.append(f"{what}: {len(counts)} of at least {target}")
    result.notes.append("Beds: " + ", ".join(f"{name} {k}" for name, k in Counter(beds).most_common()))
    result.notes.append("Other furniture: " + ", ".join(f"{name} {k}" for name, k in Counter(others).most_common()))


def is_bed(category: str) -> bool:
    """Whether a category is one of beds."""
    known, name = categories(), category
    while name in known and known[name].parent:
        name = known[name].parent or ""
        if name == "bed_group":
            return True
    return False


def furniture(category: str, size: Sequence[float]) -> bool:
    """Whether a thing counts as furniture: of some size, and no small thing on a shelf."""
    known = categories().get(category)
    return known is not None and bool(known.mount) and known.mount[0] != "surface" and max(size) >= SMALL


def _rounded(size: Sequence[float]) -> tuple[float, ...]:
    return tuple(round(side, 1) for side in size)
