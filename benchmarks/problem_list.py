"""What the frozen zoo is made of: the arguments of every problem of `sceneweaver.problems`."""

from __future__ import annotations

import gzip

from benchmarks.settings import ROOT
from benchmarks.tight_rooms import tight_room
from sceneweaver.problems import ProblemCase, generate, generate_infeasible
from sceneweaver.problems.generator import planted
from sceneweaver.scene import Scene

DESIGNS = ROOT / "benchmarks" / "data" / "strict_eyes"

# Objects, tightness, and for some a density or a shape. The seed is the place in the row: add at the end.
FEASIBLE: dict[str, tuple[tuple, ...]] = {
    "packing": ((5, 0.6), (10, 0.7), (20, 0.5), (20, 0.8), (40, 0.7), (80, 0.75), (200, 0.6))
    + ((10, 0.85), (20, 0.88), (200, 0.8)),
    "walls": ((6, 0.5), (10, 0.55), (16, 0.6), (24, 0.6), (40, 0.62), (60, 0.6), (40, 0.7)),
    "preferences": ((5, 0.4), (8, 0.5), (12, 0.4), (20, 0.4), (30, 0.5), (60, 0.4), (20, 0.6)),
    "relations": ((10, 0.35, 1), (10, 0.35, 2), (10, 0.35, 4), (20, 0.35, 1), (20, 0.35, 2), (20, 0.35, 3))
    + ((40, 0.35, 1), (40, 0.35, 2), (15, 0.5, 3), (20, 0.5, 4), (30, 0.35, 4)),
    "rooms": ((10, 0.45, "L"), (14, 0.5, "T"), (14, 0.45, "U"), (20, 0.5, "S"), (30, 0.55, "L"), (40, 0.55, "U"))
    + ((60, 0.5, "T"), (30, 0.78, "S")),
    "bodies": ((8, 0.5), (12, 0.65), (20, 0.6), (30, 0.7), (60, 0.65), (100, 0.6), (20, 0.8), (40, 0.78)),
    "groups": ((10, 0.45), (15, 0.5), (25, 0.5), (40, 0.55), (60, 0.5), (90, 0.55), (40, 0.78)),
    "surfaces": ((14, 0.4), (20, 0.6), (34, 0.5), (51, 0.7), (80, 0.6), (120, 0.7), (30, 0.85)),
    "halls": ((100, 0.45), (150, 0.5), (220, 0.5), (320, 0.45), (500, 0.4), (200, 0.7)),
}
INFEASIBLE = (
    ("area", 10),
    ("area", 40),
    ("wall_length", 12),
    ("wall_length", 24),
    ("clearance", 8),
    ("clearance", 20),
    ("distance", 12),
    ("distance", 30),
    ("angle", 10),
    ("angle", 30),
)
BEDROOMS = (5, 6, 7, 8, 9, 10)  # seeds
ROOMS = ("bathroom", "bedroom", "childrens_room", "gym", "kitchen", "living_room", "meeting_room", "office")
ROOMS += ("restaurant", "waiting_room")  # that the agent designed, kept for the critic


def made() -> list[ProblemCase]:
    """Make every problem anew; the same code gives the same ones."""
    found = [_bedroom(seed) for seed in BEDROOMS] + [_design(kind) for kind in ROOMS]
    for family, rows in FEASIBLE.items():
        for seed, (objects, tightness, *more) in enumerate(rows):
            name = f"{family}/n{objects:03d}-t{round(100 * tightness):02d}"
            extra = {}
            if more:
                extra = {"shape": more[0]} if isinstance(more[0], str) else {"density": more[0]}
                name += f"-{more[0]}" if isinstance(more[0], str) else f"-d{more[0]}"
            found.append(generate(family, objects, tightness, seed, name=name, **extra))
    for seed, (kind, objects) in enumerate(INFEASIBLE):
        name = f"infeasible/{kind.replace('_', '-')}-n{objects:03d}"
        found.append(generate_infeasible(kind, objects, seed, name=name))
    return found


def _bedroom(seed: int) -> ProblemCase:
    scene = tight_room(seed)
    return _found("bedrooms", f"seed{seed}", scene, seed)


def _design(kind: str) -> ProblemCase:
    scene = Scene.loads(gzip.decompress((DESIGNS / f"{kind}_1001.json.gz").read_bytes()))
    return _found("designs", kind.replace("_", "-"), scene.model_copy(update={"provenance": {}}), 1001)


def _found(family: str, title: str, scene: Scene, seed: int) -> ProblemCase:
    """The problem of a scene that is valid as it is."""
    return planted(family, f"{family}/n{len(scene.objects):03d}-{title}", scene, seed)
