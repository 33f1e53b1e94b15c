"""What the judge finds wrong with layouts, and causes that are proved: fixed objects in the way, what does not fit by
arithmetic, relations that no pose can fulfil."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator

import numpy as np
import shapely

from sceneweaver.layout import Solution
from sceneweaver.layout.rows import NEVER
from sceneweaver.scene import Relation, Scene, SceneObject
from sceneweaver.verify import Violation, check

from .search import QUICK, Search
from .space import INTRUSION, PENETRATION, extent, fits_turned, fullest, hull, wall_claims
from .study import BEST, Study
from .words import LINES, crowd_words, few, listed, plural, relation_words, sized, span_words, surface_words

WORDS = {
    "collision": "{0} and {1} collide",
    "out_of_bounds": "{0} is partly outside of the room",
    "unsupported": "{0} is not held as its mount says",
    "blocked_zone": "{1} is in the access zone of {0}",
    "blocked_opening": "{0} is in the clearance of {1}",
    "yaw_domain": "{0} is turned to none of the yaws that it may have",
}


def violation_words(violation: Violation) -> str:
    """What is wrong with the objects of a violation, without amounts, so that it can be counted over layouts."""
    return WORDS[violation.kind].format(*violation.objects)


def out_of_place(violations: Iterable[Violation]) -> list[Violation]:
    """Those that are about objects and the room alone, without relations."""
    return [v for v in violations if v.kind in WORDS]


def most_unmet(scene: Scene, solution: Solution) -> str:
    """The hard relations that are unmet most often; costs nothing."""
    hard = [j for j, r in enumerate(scene.relations) if r.hard]
    share = (~solution.relations).sum(axis=0)
    worst = [j for j in sorted(hard, key=lambda j: (-share[j], j)) if share[j]][:LINES]
    unmet = [f"{relation_words(scene.relations[j])} unmet in {share[j]}" for j in worst]
    broken = int(np.sum(solution.status == 1))
    diverged = int(np.sum(solution.status == 3))
    words = [f"{broken} with a collision or something out of place"] * bool(broken) + unmet
    words += [f"{diverged} diverged"] * bool(diverged)
    return f"Of {plural(solution.candidates, 'candidate')}: {'; '.join(words)}."


def most_frequent(study: Study) -> str:
    """What is wrong most often in the best candidates."""
    counts: Counter[str] = Counter()
    few = study.top[: max(4, min(BEST, 800 // max(1, len(study.scene.objects))))]
    judged = {int(c): found for c in few if (found := study.findings(int(c))) is not None}
    for c, found in judged.items():
        counts.update({violation_words(v) for v in out_of_place(found)})
        for j, rel in enumerate(study.scene.relations):
            if rel.hard and not study.solution.relations[c, j]:
                counts[f"{relation_words(rel)} is unmet"] += 1
    if not counts:
        return most_unmet(study.scene, study.solution)
    worst = sorted(counts.items(), key=lambda item: (-item[1], item[0]))[: LINES + 1]
    which = f"In the best {len(judged)} layouts" if len(judged) > 1 else "In the only layout"
    return f"{which}: {'; '.join(f'{text} ({n})' for text, n in worst)}."


def hints(study: Study) -> list[str]:
    """Where it is tight, and what is wrong most often."""
    tight = study.walls.tightest(wall_claims(study.scene))
    return [f"It is tight: {tight}."] * bool(tight) + [most_frequent(study)]


def fixed_faults(search: Search) -> Iterator[str]:
    """Fixed objects that collide or stand where nothing may."""
    study = search.study
    fixed = [i for i, o in enumerate(study.scene.objects) if o.fixed]
    if not fixed:
        return
    scene = study.scene_of(())
    found = [
        violation
        for violation in out_of_place(check(scene, walkable=False).violations)
        if all(scene.object(name).fixed for name in violation.objects if name in study.index)
    ]
    unheld = [violation.detail for violation in found if violation.kind == "unsupported"]
    others = [violation_words(violation) for violation in found if violation.kind != "unsupported"]
    if others:
        yield f"Fixed objects are in the way of any layout: {listed(others, 6, '; ')}."
    if unheld:
        yield f"Fixed objects are not held as their mounts say: {listed(unheld, 6, '; ')}."
    if found or search.solvable([scene], QUICK)[0]:
        return
    alone = [study.scene.model_copy(update={"objects": _stack(study, i), "relations": ()}) for i in fixed]
    loose = [study.scene.objects[i] for i, can in zip(fixed, search.solvable(alone, QUICK), strict=True) if not can]
    for obj in loose:
        yield f"{obj.id} is fixed where nothing holds it (its mount is {obj.mount})."
    if not loose:
        yield "The fixed objects cannot all stay where they are."


def _stack(study: Study, i: int) -> tuple[SceneObject, ...]:
    return tuple(study.scene.objects[j] for j in sorted(study.carriers([i])))


def arithmetic(study: Study) -> list[str]:
    """What does not fit by arithmetic alone."""
    lines = [*_too_tall(study), *_too_large_for_surfaces(study), *_too_large(study)]
    fixed = study.walls.fixed
    lines += study.walls.missing(wall_claims(study.scene))
    floor = [i for i in study.free if study.scene.objects[i].mount == "floor"]
    blocked = [(p, INTRUSION) for p in study.problem.region.openings] + [(p, PENETRATION) for p in fixed]
    full = fullest([study.problem.solids[i] for i in floor], shapely.Polygon(study.scene.room.outline), blocked)
    if full:
        free = " free of doors and fixed objects" if fixed else " free of doors" if study.scene.room.doors else ""
        cover = f"{plural(full.count, 'object')} {'cover' if full.count > 1 else 'covers'}"
        missing = round(full.need, 1) - round(full.free, 1)
        lines.append(
            f"The floor is too small: {cover} {full.need:.1f} m2; {full.free:.1f} m2 is{free or ' there'}: "
            f"{missing:.1f} m2 missing."
        )
    return lines


def _too_tall(study: Study) -> list[str]:
    lines, height = [], study.scene.room.height
    for i in study.free:
        obj = study.scene.objects[i]
        low, high = extent(study.problem.solids[i])
        base = _base(study, i)
        if high - low > height + PENETRATION:
            lines.append(f"{obj.id} is {high - low:.2f} m tall; the room is {height:.2f} m high.")
        elif base is not None and base + high > height + PENETRATION:
            on = f"on {obj.support.object}, " if obj.support else ""
            reach = f"{obj.id} reaches {base + high:.2f} m ({on}from {base:.2f} m)"
            lines.append(f"{reach}; the room is {height:.2f} m high.")
    return few(lines)


def _base(study: Study, i: int) -> float | None:
    """Height that an object stands at, where that is given."""
    obj, above = study.scene.objects[i], 0.0
    while not obj.fixed and obj.support is not None:
        above += study.surface(obj).z
        obj = study.scene.objects[study.index[obj.support.object]]
    if obj.fixed:
        return above + obj.pose.position[2]
    base = {"floor": 0.0, "ceiling": study.scene.room.height - obj.size[2]}.get(obj.mount)
    return None if base is None else above + base


def _too_large_for_surfaces(study: Study) -> list[str]:
    lines = []
    for domain in study.compiled.domains:
        before = len(lines)
        for i in (i for i in domain.surface.members if not study.scene.objects[i].fixed):
            obj = study.scene.objects[i]
            surface = study.surface(obj)
            on = surface_words(obj)
            high = extent(study.problem.solids[i])[1]
            if surface.headroom is not None and high > surface.headroom + PENETRATION:
                lines.append(f"{obj.id} is {high:.2f} m tall; {on} has {surface.headroom:.2f} m of head room.")
            elif not fits_turned(hull(study.problem.solids[i]), domain.problem.region.planes):
                lines.append(f"{sized(obj)} is larger than what it stands on: {on} is {span_words(surface.polygon)}.")
        polygon = shapely.Polygon(study.surface(study.scene.objects[domain.surface.members[0]]).polygon)
        blocked = [(p, PENETRATION) for p in domain.problem.region.solids]
        full = fullest(domain.problem.solids, polygon, blocked)
        if full and len(lines) == before:
            members = [study.scene.objects[i] for i in domain.surface.members]
            cover = f"{crowd_words(members)} {'cover' if len(members) > 1 else 'covers'}"
            lines.append(
                f"{surface_words(members[0])} is overfull: {cover} {full.need:.3g} m2 of {full.free:.3g} m2: "
                f"{full.need - full.free:.2g} m2 missing."
            )
    return few(lines)


def _too_large(study: Study) -> list[str]:
    lines = []
    for i in study.always_at_fault():
        obj = study.scene.objects[i]
        if obj.support is None and not fits_turned(hull(study.problem.solids[i]), study.problem.region.planes):
            lines.append(f"{sized(obj)} fits nowhere in the room: its floor is {span_words(study.scene.room.outline)}.")
    return few(lines)


def never(study: Study) -> Iterator[str]:
    """Hard relations that no pose can fulfil."""
    for j, rel in enumerate(study.scene.relations):
        ids = [n for n in (rel.subject, *rel.targets) if n in study.index]
        if rel.hard and study.problem.relations[j].options == [[NEVER]]:
            yield f"{relation_words(rel)} can never hold{_why_never(study, rel)}."
            continue
        fixed = rel.type != "around" and all(study.scene.object(n).fixed for n in ids)
        if rel.hard and fixed and not study.solution.relations[:, j].any():
            are = f"{' and '.join(ids)} {'is' if len(ids) == 1 else 'are'} fixed"
            yield f"{relation_words(rel)} does not hold, and {are}."


def _why_never(study: Study, rel: Relation) -> str:
    obj = study.scene.object(rel.subject)
    if rel.type in ("on_top", "inside"):
        if obj.support is None:
            return f": {obj.id} stands on no surface (its mount is {obj.mount})"
        if obj.support.object != rel.target:
            return f": {obj.id} stands on {obj.support.object}"
        return f": {surface_words(obj)} has no head room, so nothing is inside"
    if rel.type.endswith("against_wall"):
        longest = max(w.length for w in study.problem.region.walls)
        return f": {sized(obj)} is too wide (the longest wall is {longest:.2f} m)"
    if rel.type == "at_window":
        return ": the room has no window"
    return ": the room has no convex corner" if rel.type == "in_corner" else ""
