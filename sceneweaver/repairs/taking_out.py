"""Objects taken out of an overfull scene: as few as make the rest feasible, the smallest of those."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from sceneweaver.runtime.deadline import Deadline
from sceneweaver.scene import Scene

from .solving import Budget, Option, Work, judged, mend

SINGLES = 24  # objects that are tried one by one, those at fault and the smallest first


def take_out(work: Work, budget: Budget, clock: Deadline) -> None:
    """Add the option with the least objects taken out that the judge calls valid, where one was found.

    One object is tried first, all in shared launches, with what stands on it; of those that do, the one with the
    smallest footprint goes. Where no single one does, the one that leaves least amiss goes, and again. What went
    first is put back at the end where that can be.
    """
    gone: list[str] = []
    current, option = work, None
    while len(gone) < len(work.scene.objects) and not clock.passed:
        tried = [_without(work, [*gone, name]) for name in _at_fault(current)]
        mend(tried, budget, clock)
        if not tried:
            return
        current = min(tried, key=lambda each: (each.best.badness[0], _area(work.scene, each), each.best.badness[1]))
        gone = [o.id for o in work.scene.objects if o.id not in {kept.id for kept in current.scene.objects}]
        if current.best.report.valid:
            option = current
            break
    if option is None:
        return
    for name in gone[:-1] if len(gone) > 1 else ():
        again = _without(work, [other for other in gone if other != name])
        if len(again.scene.objects) <= len(option.scene.objects) or clock.passed:
            continue
        mend([again], budget, clock)
        if again.best.report.valid:
            option = again
            gone = [other for other in gone if other != name]
    work.options.append(_as_option(work, option))


def _as_option(work: Work, option: Work) -> Option:
    """The best layout of what is left, as an option of the whole scene."""
    best, left = option.best, {o.id for o in option.scene.objects}
    kept = [
        k for k, r in enumerate(work.scene.relations) if left.issuperset({r.subject, *r.targets} & _ids(work.scene))
    ]
    lost = {kept[k] for k in best.lost} | (work.held - set(kept))
    unmet = {kept[k] for k in best.unmet} | (work.wishes - work.held - set(kept))
    taken = tuple(o.id for o in work.scene.objects if o.id not in left)
    return replace(best, lost=frozenset(lost), unmet=frozenset(unmet), taken_out=taken)


def _at_fault(work: Work) -> list[str]:
    """Objects to try without: those that the judge names in the best layout, then the others, the smallest first."""
    named = {name for v in work.best.report.violations if v.hard for name in v.objects}
    free = [o for o in work.scene.objects if not o.fixed]
    free.sort(key=lambda o: (o.id not in named, o.size[0] * o.size[1], o.id))
    return [o.id for o in free[:SINGLES]]


def _area(scene: Scene, option: Work) -> float:
    """Footprint of what is missing [m2]."""
    left = {o.id for o in option.scene.objects}
    return sum(o.size[0] * o.size[1] for o in scene.objects if o.id not in left)


def _ids(scene: Scene) -> set[str]:
    return {o.id for o in scene.objects}


def _without(work: Work, names: Sequence[str]) -> Work:
    """The work without some objects, what stands on them, and the relations that name any of them."""
    scene, gone = work.scene, _with_carried(work.scene, names)
    objects = tuple(o for o in scene.objects if o.id not in gone)
    kept = [k for k, r in enumerate(scene.relations) if not gone.intersection((r.subject, *r.targets))]
    relations = tuple(scene.relations[k] for k in kept)
    smaller = scene.model_copy(update={"objects": objects, "relations": relations})
    held, wishes = (
        frozenset(new for new, old in enumerate(kept) if old in numbers) for numbers in (work.held, work.wishes)
    )
    ids = {scene.objects[i].id for i in work.square}
    square = frozenset(i for i, o in enumerate(objects) if o.id in ids)
    return Work(smaller, judged(smaller, work.relations, walkable=False), work.relations, held, wishes, square)


def _with_carried(scene: Scene, names: Iterable[str]) -> set[str]:
    """Objects with all that stands on them."""
    gone = set(names)
    while True:
        more = {o.id for o in scene.objects if o.support is not None and o.support.object in gone} - gone
        if not more:
            return gone
        gone |= more
