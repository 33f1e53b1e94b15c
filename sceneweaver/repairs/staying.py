"""Passes in which objects stay where they were: the sum of movements instead of the sum of their squares.

A projection spreads movement over many objects, as squares do. What a repair costs is metres, and the same validity is
often had with fewer objects moved. So objects are bound to where they were, and the rest is projected again.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from contextlib import suppress

from sceneweaver.runtime.deadline import Deadline, TimeUp

from .solving import JUDGED, MOVED, Budget, Work, add_option, hard_relations, judge, project

ROUNDS = 4  # at most; a scene whose price a round leaves as it was is done
TOGETHER = 4  # sets of several objects that are bound at once
ALONE = 12  # objects that are bound each by itself, beside those that stay anyway


def let_stay(work: Sequence[Work], budget: Budget, clock: Deadline) -> None:
    """Project valid scenes again with objects bound to where they were; what costs less becomes the best option.

    Relations that hold in the best option have to hold again, and what is square there keeps its yaw. In scenes that
    stay invalid objects that moved for nothing are put back.
    """
    with suppress(TimeUp), clock.enforced(lambda: JUDGED):
        _bind_blameless([each for each in work if not each.best.report.valid], budget, clock)
        _bind(work, budget, clock)
        for each in work:
            if not each.best.report.valid and not clock.passed:
                _return(each)


def _bind(work: Sequence[Work], budget: Budget, clock: Deadline) -> None:
    left = [each for each in work if each.best.report.valid and each.best.moves and not each.best.taken_out]
    for number in range(ROUNDS):
        trials = [(each, b, hard) for each in left for b in _bound(each, number == 0) for hard in _kept(each)]
        if not trials or clock.passed:
            return
        prices = {id(each): each.best.badness for each in left}
        for square in (True, False):
            some = [trial for trial in trials if (trial[0].best.skewed == 0) == square]
            if some and not clock.passed:
                scenes, bound, hard = zip(*some, strict=True)
                judge(scenes, project(scenes, hard, budget, clock, square=square, bound=bound))
        left = [each for each in left if each.best.badness < prices[id(each)]]


def _bind_blameless(work: Sequence[Work], budget: Budget, clock: Deadline) -> None:
    """Of scenes that stay invalid, project what the judge names alone: what is wrong with the rest cannot be much."""
    named = [_roots(each, _named(each)) for each in work]
    trials = [(each, _loose(each) - who) for each, who in zip(work, named, strict=True) if _loose(each) - who]
    if trials and not clock.passed:
        scenes, bound = zip(*trials, strict=True)
        judge(scenes, project(scenes, [_kept(each)[0] for each in scenes], budget, clock, square=True, bound=bound))


def _named(work: Work) -> list[int]:
    index = {o.id: i for i, o in enumerate(work.scene.objects)}
    return [index[name] for v in work.before.violations if v.hard for name in v.objects if name in index]


def _loose(work: Work) -> frozenset[int]:
    """Objects that may move and stand on no other."""
    return frozenset(i for i, o in enumerate(work.scene.objects) if not o.fixed and o.support is None)


def _return(work: Work) -> None:
    """Put objects back one after another, nearest first, where that makes nothing worse."""
    carriers = {o.support.object for o in work.scene.objects if o.support is not None}
    for move in sorted(work.best.moves, key=lambda m: m.distance + abs(m.rise)):
        obj = work.scene.object(move.id)
        if obj.support is None and obj.id not in carriers:
            add_option(work, work.best.scene.replace_poses({obj.id: obj.pose}))


def _kept(work: Work) -> list[frozenset[int]]:
    """Relations that have to hold: those that are hard, and the wishes that hold in the best option; and of the wishes
    only those that held before."""
    asked, best = hard_relations(work.scene) if work.relations else frozenset(), work.best
    return list(dict.fromkeys([asked | (work.wishes - best.lost - best.unmet), asked | (work.held - best.lost)]))


def _bound(work: Work, together: bool) -> list[frozenset[int]]:
    """Sets of objects to bind: what stays anyway with each that moved, and ``together`` with several of the nearest."""
    far = {m.id: m.distance + abs(m.rise) for m in work.best.moves if m.distance + abs(m.rise) > MOVED or m.turn}
    objects = work.scene.objects
    roots = _loose(work)
    clashes = _clashes(work)
    stay = frozenset(i for i in roots if objects[i].id not in far)
    moved = sorted((i for i in roots if objects[i].id in far), key=lambda i: far[objects[i].id])
    free = [i for i in moved if not clashes.get(i, frozenset()) & (stay | {i})]
    sets = [stay | {i} for i in free[:ALONE]]
    if together:
        most: list[int] = []
        for i in free:
            if not clashes.get(i, frozenset()) & set(most):
                most.append(i)
        steps = sorted({max(2, round(len(most) * k / TOGETHER)) for k in range(1, TOGETHER + 1)})
        sets += [stay | set(most[:k]) for k in steps if k <= len(most)]
    return list(dict.fromkeys(sets))


def _clashes(work: Work) -> dict[int, frozenset[int]]:
    """Of each object those with which it cannot stay: itself, where it is wrong alone or with something fixed."""
    index = {o.id: i for i, o in enumerate(work.scene.objects)}
    fixed = {i for i, o in enumerate(work.scene.objects) if o.fixed}
    found: dict[int, frozenset[int]] = {}
    for violation in work.before.violations:
        if not violation.hard or violation.kind == "relation":
            continue
        who = _roots(work, (index[name] for name in violation.objects if name in index))
        loose = who - fixed
        for i in loose:
            found[i] = found.get(i, frozenset()) | (loose - {i} if len(loose) > 1 else loose)
    return found


def _roots(work: Work, numbers: Iterable[int]) -> frozenset[int]:
    """What these objects stand on in the end."""
    index = {o.id: i for i, o in enumerate(work.scene.objects)}

    def root(i: int) -> int:
        support = work.scene.objects[i].support
        return i if support is None else root(index[support.object])

    return frozenset(root(i) for i in numbers)
