"""What a review tells of a scene in numbers: counts, shares, areas."""

from __future__ import annotations

from collections import Counter

from .checks import finish, floor, program
from .design import looks
from .space import floor_of, largest_rectangle
from .survey import Survey


def measures(survey: Survey) -> dict[str, float]:
    """Counts of things and relations, shares of the floor, and how mixed and how finished the room is."""
    report, scene, grid = survey.report, survey.scene, floor_of(survey)
    mounts = Counter(o.mount for o in scene.objects)
    count = Counter(b.item.category for b in survey.bodies)
    furniture = Counter(b.item.category for b in survey.bodies if b.item.mount != "surface")
    found = {
        "objects": len(scene.objects),
        "floor_objects": mounts["floor"],
        "relations_per_floor_object": len(scene.relations) / max(1, mounts["floor"]),
        "floor_m2": survey.area,
        "violations": sum(v.hard for v in report.violations),
        "categories": len(count),
        "diversity": len(count) / max(1.0, len(survey.bodies) ** 0.75),
        "largest_share": max(furniture.values(), default=0) / max(1, furniture.total()),
        "covered_share": floor.covered_share(survey),
        "used_share": floor.used_share(survey),
        "free_rectangle_m2": largest_rectangle(grid.inside & ~grid.taken)[0] * grid.cell**2,
        "empty_rectangle_m2": floor.idle_rectangle(survey).area,
        "balance": floor.emptiest_half(survey).share,
        "supports": len(looks.supports(survey)),
        "populated_share": finish.populated_share(survey),
        "expected_objects": program.expected_objects(survey),
        "small_objects": mounts["surface"],
        "walkable_share": report.walkable_share,
        "reachable_share": report.reachable_share,
    }
    return {name: round(float(value), 4) for name, value in found.items() if value is not None}
