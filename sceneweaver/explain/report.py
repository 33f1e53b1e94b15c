"""Why nothing is valid: proofs first, then what small refinements find, the most fundamental cause first."""

from __future__ import annotations

import itertools
import time
from collections.abc import Iterator

import numpy as np
import shapely

from sceneweaver.layout import Solution
from sceneweaver.scene import Room, Scene

from .pairs import misfits
from .proofs import arithmetic, fixed_faults, hints, most_unmet, never
from .search import CHUNK, CROWD, FIRM, SURE, Search
from .study import LOOK, OutOfTime, Study
from .words import FOUND, LINES, crowd_words, few, listed, sized, span_words, surface_words

LONGEST = 10.0  # [s] that an explanation may take
RESERVE = 0.3  # [s] of it kept for the last words
PAIRS = 144  # pairs of relations that are tried at most


def lonely_objects(search: Search) -> Iterator[str]:
    """Objects that find no place even with the movable rest away."""
    study = search.study
    roots = [i for i in study.always_at_fault() if study.scene.objects[i].support is None]
    for i, can in zip(roots, search.can([study.presence([i]) for i in roots]), strict=True):
        if not can and search.surely_not(study.presence([i])):
            yield f"No place in the room was found for {sized(study.scene.objects[i])}{_why_no_place(search, i)}."


def _why_no_place(search: Search, i: int) -> str:
    """What leaves no place for an object: the first of room, openings and fixed objects that does."""
    study = search.study
    part, room = study.presence([i]), study.scene.room
    bare = room.model_copy(update={"doors": (), "windows": ()})
    try:
        if not search.solvable([study.scene_of(part, fixed=False, room=bare)], FIRM)[0]:
            on_wall = study.scene.objects[i].mount == "wall"
            return ": no wall has room for it" if on_wall else f": the floor is {span_words(room.outline)} all in all"
        if not search.solvable([study.scene_of(part, fixed=False)], FIRM)[0]:
            return ": the clearances of doors and windows leave none"
    except OutOfTime:
        search.cut = True
        return ""
    return ": the fixed objects leave none"


def full_surfaces(search: Search) -> Iterator[str]:
    """Surfaces whose things do not fit on them together, and carriers that fit nowhere with what they carry."""
    study = search.study
    full = False
    for domain in study.compiled.domains:
        members = [i for i in domain.surface.members if not study.scene.objects[i].fixed]
        if not study.fault[:, members].any(axis=1).all():
            continue
        fixed = any(study.scene.objects[i].fixed for i in study.carriers(members))
        room = None if fixed else _hall(study.scene.room)
        several = [study.scene_of(study.presence(members), fixed=fixed, room=room)]
        if search.solvable(several, FIRM)[0]:
            continue
        alone = [study.scene_of(study.presence([i]), fixed=fixed, room=room) for i in members]
        misfits = [i for i, can in zip(members, search.solvable(alone, FIRM), strict=True) if not can]
        obj = study.scene.objects[members[0]]
        on, polygon = surface_words(obj), study.surface(obj).polygon
        for i in misfits:
            yield f"No place on {on} ({span_words(polygon)}) was found for {sized(study.scene.objects[i])}."
        if not misfits and not search.solvable(several, SURE)[0]:
            area = sum(study.area(i) for i in members)
            yield (
                f"{crowd_words([study.scene.objects[i] for i in members])} do not fit on {on} together {FOUND}: "
                f"footprints of {area:.3g} m2 on {shapely.Polygon(polygon).area:.3g} m2 ({span_words(polygon)})."
            )
        full = True
    if full:
        return
    roots = study.problem.roots
    groups = [np.flatnonzero(roots == i).tolist() for i in study.always_at_fault() if np.sum(roots == i) > 1]
    for group, can in zip(groups, search.can([study.presence(g) for g in groups]), strict=True):
        if not can and search.surely_not(study.presence(group)):
            root = study.scene.objects[int(roots[group[0]])].id
            carried = [study.scene.objects[i].id for i in group if study.scene.objects[i].id != root]
            yield f"No place in the room was found for {root} with what stands on it ({listed(carried, 6)})."


def _hall(room: Room) -> Room:
    """An empty room larger than a room on all sides."""
    (x0, y0), (x1, y1) = np.min(room.outline, axis=0) - 5, np.max(room.outline, axis=0) + 5
    outline = ((x0, y0), (x1, y0), (x1, y1), (x0, y1))
    return Room(outline=tuple((float(x), float(y)) for x, y in outline), height=room.height + 5)


def crowded_objects(search: Search) -> Iterator[str]:
    """Objects that do not fit together even without relations."""
    study = search.study
    everyone = study.presence(study.free)
    if np.any(study.solution.status == 2):  # only relations were unmet
        search.note(everyone, True)
    if len(study.free) <= (CROWD if study.units else 3 * CROWD) and not search.can([everyone])[0]:
        order = sorted(study.free, key=lambda i: (-study.fault[:, i].mean(), -study.area(i), i))
        yield from search.crowding(order)


def single_relations(search: Search) -> Iterator[str]:
    """Hard relations that no place was found for, though only they and their objects are in the room."""
    study = search.study
    doubtful = [u for u in range(len(study.units)) if not study.good[:, u].any()]
    doubtful.sort(key=study.suspicion)
    for u, can in zip(doubtful, search.can([{u} for u in doubtful]), strict=True):
        if not can and search.surely_not({u}):
            yield search.settled(frozenset({u}))


def pairs_of_relations(search: Search) -> Iterator[str]:
    """Two hard relations that do not go together."""
    study = search.study
    keys = [study.keys(u) for u in range(len(study.units))]
    seen = study.good.astype(np.float32)
    met = seen.T @ seen > 0  # some candidate has both
    pairs = [p for p in itertools.combinations(range(len(study.units)), 2) if not met[p] and keys[p[0]] & keys[p[1]]]
    pairs.sort(key=lambda p: (study.suspicion(p[0])[0] + study.suspicion(p[1])[0], p))
    used: set[int] = set()
    for some in (pairs[i : i + CHUNK] for i in range(0, min(PAIRS, len(pairs)), CHUNK)):
        for pair, can in zip(some, search.can(some), strict=True):
            if not can and not used.intersection(pair) and search.surely_not(pair):
                used.update(pair)
                yield search.settled(frozenset(pair))
        if used:
            return


def second_try(search: Search) -> Iterator[str]:
    """A valid layout after all, when the run was short."""
    study = search.study
    weak = study.solution.timed_out or study.solution.candidates < LOOK
    everything = frozenset(range(len(study.units))) | study.presence(study.free)
    if weak and len(study.free) <= 3 * CROWD and search.can([everything])[0]:
        yield (
            "A short search found a valid layout, so there is one: give the run more candidates, more steps, "
            "more time or another seed."
        )


def grown_conflict(search: Search) -> Iterator[str]:
    """A smallest set found of relations and objects, grown around the relations that are unmet most often."""
    study = search.study
    seeds = sorted(range(len(study.units)), key=study.suspicion)
    best: frozenset[int] | None = None
    for seed in seeds[:LINES]:
        try:
            found = search.smallest(search.outward(seed))
        except OutOfTime:
            if best is None:
                raise
            search.cut = True
            break
        if found is not None and (best is None or len(found) < len(best)):
            best = found
        if best is not None and len(best) <= LINES:
            break
    if not seeds:
        best = search.smallest(sorted(study.presence(study.free)))
    if best is not None:
        yield search.settled(best)


# The most fundamental first.
FINDS = (
    lonely_objects,
    full_surfaces,
    crowded_objects,
    single_relations,
    pairs_of_relations,
    second_try,
    grown_conflict,
)


def find_causes(search: Search) -> tuple[list[str], bool]:
    """Lines about the first kind of cause that there is, and whether they are proved."""
    if lines := list(fixed_faults(search)) or arithmetic(search.study) or list(never(search.study)):
        return lines[: 2 * LINES], True
    for find in FINDS:
        lines = []
        try:
            for line in find(search):
                lines.append(line)
        except OutOfTime:
            if not lines:
                raise
            search.cut = True
        if lines:
            return few(lines), False
    return [], False


def explain(scene: Scene, solution: Solution, *, device: str, seed: int, deadline: float | None = None) -> str | None:
    """Why no candidate of a refinement is valid: one to about six lines of plain English; None when one is valid.

    Args:
        scene: what was refined.
        solution: what came of it.
        device: where to run the small refinements, as for ``refine``.
        seed: their seed.
        deadline: when to be back, in the time of ``time.monotonic()``; it never takes much longer than 10 s anyway.
    """
    if np.any(solution.status == 0):
        return None
    start = time.monotonic()
    end = start + LONGEST if deadline is None else min(deadline, start + LONGEST)
    until = end - min(RESERVE, 0.1 * (end - start))
    if until - start < 0.02:
        return "\n".join([*_timed_out(solution, False), most_unmet(scene, solution)])
    study = Study(scene, solution, device, until)
    search = Search(study, seed)
    proved = False
    try:
        lines, proved = find_causes(search)
        if not lines:
            lines = ["No single cause was found.", *hints(study)]
        if search.cut:
            lines.append(f"Looking further was stopped after {time.monotonic() - start:.1f} s.")
    except OutOfTime as cut:
        lines = [f"Looking for the cause was stopped after {time.monotonic() - start:.1f} s.", *cut.lines]
        lines += hints(study) if time.monotonic() < end else [most_unmet(scene, solution)]
    return "\n".join([*_timed_out(solution, proved), *lines])


def _timed_out(solution: Solution, proved: bool) -> list[str]:
    if not solution.timed_out:
        return []
    proof = "but more time would not have helped" if proved else "which is no proof that there is none"
    return [f"The time limit stopped the run after {solution.elapsed:.1f} s, before any layout was valid, {proof}."]


def certificate(scene: Scene, solution: Solution, *, device: str) -> str | None:
    """Why a scene has no valid layout at all, by arithmetic: lines that prove it; None where that proves nothing.

    Args:
        scene: what was refined.
        solution: what came of it; objects at fault in all of its layouts are looked at.
        device: as for ``refine``; nothing is searched there.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver.explain import certificate
        >>> room = sw.Room(outline=((0, 0), (4, 0), (4, 3), (0, 3)))
        >>> raft = sw.SceneObject(id="raft", category="raft", size=(6, 2, 1))
        >>> scene = sw.Scene(id="hall", room=room, objects=(raft,))
        >>> solution = sw.refine(scene, candidates=2, device="cpu", explain=False)
        >>> print(certificate(scene, solution, device="cpu"))
        raft (6 m x 2 m) fits nowhere in the room: its floor is 4 m x 3 m.
    """
    if np.any(solution.status == 0):
        return None
    study = Study(scene, solution, device, time.monotonic() + LONGEST)
    return "\n".join(arithmetic(study) or list(never(study)) or list(misfits(study))) or None
