"""What gives way where a scene asks for more than its room can hold."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Sequence
from typing import NamedTuple

from sceneweaver.rules.faults import number
from sceneweaver.scene import CATALOGUE, PRIORITIES, Dropped, FreeArea, Relation, Scene, SceneObject
from sceneweaver.scene.edits import Remove, apply
from sceneweaver.verify import Report, Violation, check

REASON = "the room has no place for it"

ALIKE = 6
"""Of so many objects of one kind one more goes at once: forty wardrobes are not tried forty times."""

TIED = CATALOGUE.with_role("seat") | {"over", "centered_on", "leftright_to_leftright"}
"""Types of hard relations whose subject is there for its target: a stool, lamp or rug of a desk goes with the desk."""

FEW = 3
"""Concessions at once from which on all relations that do not hold give way."""

LIGHT = 0.02
"""Weight of a relation of what has no place otherwise: it no longer draws it where it cannot be."""

FLAT = number("underfoot")
"""Height [m] up to which what lies on the floor is in nobody's way."""

PRUNINGS = 3
"""Times that small things are taken out of a scene that then shows more that are in the way."""


class Relaxed(NamedTuple):
    """A scene that asks for less, and what is to be said of that; ``unmet`` is what had been asked for.

    ``late``: it comes when larger rooms and more patience did not help.
    """

    scene: Scene
    notes: tuple[str, ...] = ()
    unmet: tuple[str, ...] = ()
    late: bool = False


def relaxed(scene: Scene, faults: Sequence[Violation], at_once: int = 1, *, fixed: bool = False) -> Relaxed | None:
    """The scene without what is least wanted of all that its best layout has trouble with.

    First go objects that are optional, then usual ones, ``at_once`` of them; then relations that do not hold become
    soft, those that nobody asked for, one or with ``at_once`` above 1 all; then goes what a room of the kind needs and
    no asked relation or free area names. Where something asked for suffers, all of these give way at once but for
    the last. Then what was asked for may be elsewhere than is usual, the smallest first or with ``at_once`` above 1
    all; then go all that nobody asked for and no asked relation or free area names, also where it is in nobody's way
    now, which it may be in every other layout; then floor is no longer kept free; then relations that were asked for
    become soft, with ``at_once`` above 1 one for each group of objects, above `FEW` all. Then go the other objects, by
    priority, seats with places at tables after others, those last that most of what was asked for is told to be at; of
    one that was asked for all relations become soft and so light that it may be anywhere, before it goes. None when the
    faults are about nothing that could give way.

    Where the room is ``fixed`` no larger one comes to help: there half of what stands in it and is optional or usual
    goes, the largest first, before a relation of what is needed or asked for gives way, or that itself.
    """
    ours = max(at_once, len(scene.objects)) if _harms_asked(scene, faults) else at_once
    for priority in PRIORITIES[:2]:
        lighter = lightened(scene, faults, priority, ours)
        if lighter is not None:
            return lighter
    trouble = Counter(name for fault in faults for name in fault.objects)
    pool = [o for o in scene.objects if o.id in trouble]
    false = {(fault.relation.type, fault.objects) for fault in faults if fault.relation is not None}
    broken = [r for r in scene.relations if r.hard and (r.type, (r.subject, *r.targets)) in false]
    unasked = [r for r in broken if not r.asked]
    if fixed and any(o.intent.priority not in PRIORITIES[:2] for o in pool):
        others = sorted(_spare(scene, pool, bearers(scene)), key=lambda o: (-o.size[0] * o.size[1], o.id))
        if others:
            return _without(scene, others[: (len(others) + 1) // 2])
    if unasked:
        return _softened(scene, unasked[:1] if ours == 1 else unasked)
    named = {name for r in scene.relations if r.asked for name in (r.subject, *r.targets)}
    named |= {name for area in scene.free_areas for name in (*area.targets, *area.others)} | bearers(scene)
    needed = [o for o in pool if o.intent.priority == "needed" and o.id not in named]
    if needed and broken:
        return _without(scene, [max(needed, key=lambda o: (trouble[o.id], o.size[0] * o.size[1], o.id))])
    usual = {o.id: [r for r in scene.relations if r.subject == o.id and r.hard and not r.asked] for o in pool}
    bound = [o for o in pool if o.intent.priority == "asked" and usual[o.id]]
    if bound:
        bound.sort(key=lambda o: (o.size[0] * o.size[1], o.id))
        freed = [r for o in (bound[:1] if at_once == 1 else bound) for r in usual[o.id]]
        return _softened(scene, freed)._replace(late=True)
    floors = [a for a in scene.free_areas if a.id in trouble] or ([] if pool else list(scene.free_areas))
    told = floors or any(r.asked for r in broken) or any(o.intent.priority == "asked" for o in pool)
    if told and (spare := _spare(scene, pool, named)):
        return _without(scene, spare)._replace(late=True)
    if floors:
        return _walked_over(scene, floors[:1] if at_once == 1 else floors)
    if broken:
        return _softened(scene, broken[:1] if at_once == 1 else broken if at_once > FEW else _apart(broken))
    if not pool:
        return None
    held, places = _held(scene), {r.subject for r in scene.relations if r.asked and r.type in TIED}
    first = min(pool, key=lambda o: (o.intent.rank, o.id in places, held[o.id], -trouble[o.id], o.id))
    ties = [r for r in scene.relations if first.id in (r.subject, *r.targets) and (r.hard or r.weight > LIGHT)]
    if first.intent.priority == "asked" and ties:
        return _softened(scene, ties, LIGHT)
    twins = [o for o in pool if o.category == first.category and o.intent.rank == first.intent.rank]
    twins.sort(key=lambda o: (held[o.id], -trouble[o.id], o.id))
    alike = sum(o.category == first.category for o in scene.objects)
    return _without(scene, twins[: 1 + alike // ALIKE])


def _spare(scene: Scene, pool: Sequence[SceneObject], named: Collection[str]) -> list[SceneObject]:
    """What nobody asked for, no room of the kind needs and nothing asked refers to, of all that stands or hangs as the
    objects in trouble do; of those whose trouble is with free floor what stands."""
    mounts = {o.mount for o in pool} or {"floor"}
    return [
        o
        for o in scene.objects
        if o.mount in mounts
        and o.mount != "surface"
        and o.size[2] > FLAT
        and o.intent.priority in PRIORITIES[:2]
        and o.id not in named
    ]


def _held(scene: Scene) -> Counter[str]:
    """How much of what was asked for is told to be at each object: a counter holds its stools in their places."""
    asked = {o.id for o in scene.objects if o.intent.priority == "asked"}
    return Counter(
        target for r in scene.relations if r.asked and r.subject in asked for target in r.targets if target in asked
    )


def _harms_asked(scene: Scene, faults: Sequence[Violation]) -> bool:
    """Whether something that was asked for stands in another's way, or is not where it was asked to be."""
    asked = {o.id for o in scene.objects if o.intent.priority == "asked"}
    said = {(r.type, (r.subject, *r.targets)) for r in scene.relations if r.asked and r.hard}
    return any(
        (fault.relation.type, fault.objects) in said if fault.relation is not None else asked & set(fault.objects)
        for fault in faults
    )


def lightened(
    scene: Scene, faults: Sequence[Violation], priority: str = PRIORITIES[0], at_once: int = 1
) -> Relaxed | None:
    """The scene without those ``at_once`` of a priority that its best layout has most trouble with; None for none."""
    trouble, kept = Counter(name for fault in faults for name in fault.objects), bearers(scene)
    least = [o for o in scene.objects if o.id in trouble and o.intent.priority == priority and o.id not in kept]
    least.sort(key=lambda o: (-trouble[o.id], -o.size[0] * o.size[1], o.id))
    return _without(scene, least[:at_once]) if least else None


def bearers(scene: Scene) -> frozenset[str]:
    """The ids of what carries something that was asked for, which would go with it: the stand of the television."""
    known = {o.id: o for o in scene.objects}
    found = set[str]()
    for obj in scene.objects:
        under = obj.support.object if obj.intent.priority == "asked" and obj.support is not None else None
        while under is not None and under in known and under not in found:
            found.add(under)
            support = known[under].support
            under = support.object if support is not None else None
    return frozenset(found)


def eased(layout: Scene, scene: Scene) -> Scene:
    """A layout of a scene that asked for more, as a layout of the scene that is left of it."""
    left = set(scene.ids)
    soft = {(r.type, r.subject, r.targets) for r in scene.relations if not r.hard}
    relations = tuple(
        r.model_copy(update={"hard": r.hard and (r.type, r.subject, r.targets) not in soft})
        for r in layout.relations
        if {r.subject, *r.targets} <= left
    )
    objects = tuple(o for o in layout.objects if o.id in left)
    kept = {area.id for area in scene.free_areas}
    areas = tuple(area for area in layout.free_areas if area.id in kept)
    changed = {"objects": objects, "relations": relations, "free_areas": areas, "dropped": scene.dropped}
    return layout.model_copy(update=changed)


def pruned(before: Scene, scene: Scene) -> tuple[Scene, Report, tuple[str, ...]]:
    """An edited scene without the new small things that nobody asked for and that are in the way of something.

    Returns:
        The scene, its report, and what is to be said of it.
    """
    old, notes = set(before.ids), list[str]()
    report = check(scene)
    for _ in range(PRUNINGS):
        named = {name for v in report.violations if v.hard and v.relation is None for name in v.objects}
        extra = [
            o.id for o in scene.objects if o.id in named - old and o.mount == "surface" and o.intent.request is None
        ]
        if not extra:
            break
        for name in sorted(extra):
            if name in scene.ids:
                scene = apply(scene, Remove(id=name, cascade=True))
        notes.append(f"{len(extra)} small things did not fit and were left out")
        report = check(scene)
    return scene, report, tuple(notes)


def cleared(scene: Scene, report: Report) -> tuple[Relaxed, Report]:
    """A scene in the layout that it has, without what is wrong in it: nothing is searched for.

    Relations that do not hold become soft, and of what stands in each other's way the least wanted goes.

    Args:
        scene: any scene.
        report: the judge's report of it.

    Returns:
        The scene with what is to be said of it, and its report.
    """
    notes, unmet = list[str](), list[str]()
    while faults := [v for v in report.violations if v.hard and v.kind != "dropped"]:
        known = {o.id: o for o in scene.objects}
        if floors := [
            a for a in scene.free_areas if a.id in {v.objects[0] for v in faults if v.kind == "blocked_floor"}
        ]:
            step = _walked_over(scene, floors)
            scene, unmet = step.scene, [*unmet, *step.unmet]
            report = check(scene)
            continue
        failing = {v.relation.index for v in faults if v.relation is not None}
        steps = [_softened(scene, [relation]) for k, relation in enumerate(scene.relations) if k in failing]
        held = _held(scene)
        gone, clashes = [], [known.keys() & set(v.objects) for v in faults if v.relation is None]
        while clashes := [names for names in clashes if names]:
            trouble = Counter(name for names in clashes for name in names)
            gone.append(min(trouble, key=lambda name: (known[name].intent.rank, held[name], -trouble[name], name)))
            clashes = [names for names in clashes if gone[-1] not in names]
        if not steps and not gone:
            break
        soft = [r.model_copy(update={"hard": r.hard and k not in failing}) for k, r in enumerate(scene.relations)]
        steps.append(_without(scene.model_copy(update={"relations": tuple(soft)}), [known[name] for name in gone]))
        for step in steps:
            notes, unmet = [*notes, *step.notes], [*unmet, *step.unmet]
        scene = steps[-1].scene
        report = check(scene)
    return Relaxed(scene, tuple(notes), tuple(unmet)), report


def left_out(name: str) -> str:
    """What is said of an object that nobody asked for and that is given up."""
    return f"{name} was left out: {REASON}"


def still_true(notes: Sequence[str], scene: Scene) -> tuple[str, ...]:
    """Notes without those that say of an object or a category of the scene that it was left out: a later step has
    brought it after all."""
    there = {*scene.ids, *(one.category for one in scene.objects)}
    return tuple(note for note in notes if note.partition(" was left out")[0] not in there)


def _without(scene: Scene, gone: Sequence[SceneObject]) -> Relaxed:
    """The scene without some objects, what stands on them and what is there for them alone.

    Those that were asked for are dropped.
    """
    notes, unmet = list[str](), list[str]()
    queue = list(gone)
    for obj in queue:
        if obj.id not in scene.ids:  # it stood on one that went before it
            continue
        queue += _there_for(scene, obj)
        scene = apply(scene, Remove(id=obj.id, cascade=True))
        if obj.intent.priority != "asked":
            notes.append(left_out(obj.id))
            continue
        unmet.append(f"{obj.id}: {REASON}")
        dropped = (*scene.dropped, Dropped(id=obj.id, category=obj.category, reason=REASON))
        scene = scene.model_copy(update={"dropped": dropped})
    return Relaxed(scene, tuple(notes), tuple(unmet))


def _walked_over(scene: Scene, floors: Sequence[FreeArea]) -> Relaxed:
    """The scene without some of its free areas."""
    left = tuple(area for area in scene.free_areas if area not in floors)
    unmet = [f"{area.request or area.id}: the room has no such free floor" for area in floors]
    return Relaxed(scene.model_copy(update={"free_areas": left}), unmet=tuple(unmet))


def _there_for(scene: Scene, obj: SceneObject) -> list[SceneObject]:
    """What nobody asked for and has its place by an object: the stool at a desk, the lamp beside a chair."""
    tied = {r.subject for r in scene.relations if r.hard and r.type in TIED and r.targets == (obj.id,)}
    return [o for o in scene.objects if o.id in tied and o.intent.priority != "asked"]


def _apart(relations: Sequence[Relation]) -> list[Relation]:
    """Some of the relations, no two of which are about the same object."""
    found, seen = [], set[str]()
    for one in relations:
        names = {one.subject, *one.targets}
        if not names & seen:
            found.append(one)
        seen |= names
    return found


def _softened(scene: Scene, relations: Sequence[Relation], weight: float | None = None) -> Relaxed:
    """The scene with some of its relations soft, and of a ``weight`` where one is given."""
    update = {"hard": False} if weight is None else {"hard": False, "weight": weight}
    soft = tuple(r.model_copy(update=update) if any(r is one for one in relations) else r for r in scene.relations)
    unmet = []
    for one in [r for r in relations if r.hard]:
        said = " ".join((one.subject, one.type, " and ".join(one.targets))).rstrip()
        said = f"{one.request}: {said}" if one.request is not None else said
        unmet += [f"{said} cannot hold here"] if one.asked else []
    return Relaxed(scene.model_copy(update={"relations": soft}), unmet=tuple(unmet))
