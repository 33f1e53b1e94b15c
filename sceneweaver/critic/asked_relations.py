"""What became of the relations that a request states."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from sceneweaver.assets.taxonomy import members
from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.geometry.walls import Wall
from sceneweaver.knowledge.desk_sides import desk_side
from sceneweaver.knowledge.stations import AT_STATION, IN_REACH, OVER_STATION, own_on_floor, own_on_wall
from sceneweaver.language import Exclusion, SceneGraph, StatedRelation, Thing
from sceneweaver.language.model import ANYTHING
from sceneweaver.language.vocabulary import words
from sceneweaver.rules.stated import Word, number, word_of_place, word_of_things
from sceneweaver.verify.measure import Measurement, Measurements
from sceneweaver.verify.solids import Body
from sceneweaver.verify.stated import Target, sides_named, stated

from . import group_measures
from .asked_calls import adding, relating
from .asked_capacity import is_table, used_seats
from .partners import own_partners, share_of
from .places import corners, segments, whole
from .survey import Survey
from .verdict import Asked, Verdict, counted, decide, met, not_understood, text_of, unmet, weight_of

GROUPS = ("flanking", "around")
"""Relations of several subjects at once."""

MOST_PAIRS = 64
"""Pairs of targets that something may be between, at most."""


class Ruling(NamedTuple):
    """Whether a relation holds, the subjects that are wrong, and the measurement that tells most."""

    holds: bool
    wrong: tuple[Body, ...] = ()
    worst: Measurement | None = None
    share: float = 1.0


def outcomes(survey: Survey) -> Iterator[Asked]:
    """Each stated relation, measured."""
    for k, said in enumerate(survey.brief.relations):
        yield _outcome(survey, said, said.id or f"relation-{k}")


def holding(survey: Survey, barred: Exclusion) -> list[Body] | None:
    """The bodies that are where an exclusion says that they must not be; None when that cannot be measured."""
    if barred.relation is None:
        return None
    said = StatedRelation(type=barred.relation, subject=barred.subject, targets=barred.targets, words=barred.words)
    if ANYTHING in barred.categories:
        bodies = _not_placed_at(survey, barred)
    elif barred.subject:
        bodies = list(survey.standing_for(barred.subject))
    else:
        names = {name for word in barred.categories for name in (word, *members(word))}
        bodies = [b for b in survey.bodies if b.item.category in names]
    if not bodies:
        return []
    if "middle" in barred.targets:
        return [b for b in bodies if group_measures.of_middle(survey, [b]).ok()]
    if said.type in GROUPS:
        said = said.model_copy(update={"type": "next_to"})
    table = _table(survey, said, bodies)
    if table is None:
        return None
    return [b for b, rows in zip(bodies, table, strict=True) if any(v.holds for r in rows.values() for v in r.values())]


def _not_placed_at(survey: Survey, barred: Exclusion) -> list[Body]:
    """All that no relation of the request places at the targets of an exclusion."""
    names = {s.subject for s in survey.brief.relations if set(s.targets) & set(barred.targets)} | set(barred.targets)
    apart = {b.id for name in names if survey.brief.entity(name) is not None for b in survey.standing_for(name)}
    return [b for b in survey.bodies if b.id not in apart]


def words_of(said: StatedRelation) -> str:
    """A relation as it was written, or as its type has it."""
    return said.words or f"{said.subject} {said.type} {' and '.join(said.targets)}".replace("_", " ").strip()


def _outcome(survey: Survey, said: StatedRelation, item: str) -> Asked:
    subjects = survey.standing_for(said.subject)
    named = {name: survey.standing_for(name) for name in said.targets if survey.brief.entity(name) is not None}
    ids = list(dict.fromkeys(b.id for b in (*subjects, *itertools.chain(*named.values()))))
    words = words_of(said)
    missing = [n for n, found in ((said.subject, subjects), *named.items()) if not found]
    if missing:
        noun = next((e.noun for e in survey.brief.entities if e.id == missing[0]), missing[0])
        asked = survey.brief.entity(missing[0])
        call = adding(survey, asked, 1) if asked is not None else None
        reason = f"'{words}' does not hold: there is no '{noun}'"
        return unmet("relation", item, ids, reason, fault="asked_relation", suggestion=f"add '{noun}'", call=call)
    absent = [p for p in said.targets if p in ("window", "door") and not segments(survey, p)]
    if absent:
        reason = f"'{words}' does not hold: the room has no {absent[0]}"
        return unmet("relation", item, ids, reason, fault="asked_relation", suggestion=f"add a {absent[0]}")
    ruling = _ruling(survey, said, subjects)
    if ruling is None:
        return not_understood("relation", item, ids, f"'{words}' is nothing that can be measured here")
    if ruling.holds:
        tail = f": {text_of(ruling.worst)}" if ruling.worst is not None and ruling.worst.unit else ""
        return met("relation", item, ids, f"'{words}' holds{tail}", ruling.worst, assumed=said.implied)
    wrong = [b.id for b in ruling.wrong or subjects]
    shown = ", ".join(wrong[:4])
    why = text_of(ruling.worst) if ruling.worst is not None else "there is nothing to relate it to"
    return unmet(
        "relation",
        item,
        ids,
        f"'{words}' does not hold for {shown}: {why}",
        ruling.worst,
        fault="asked_relation",
        wrong=wrong,
        share=ruling.share,
        suggestion=f"put {shown} as asked",
        call=relating(survey, said, item, ruling.wrong or subjects),
    )


def _ruling(survey: Survey, said: StatedRelation, subjects: Sequence[Body]) -> Ruling | None:
    """Whether it holds; None when nothing of it can be measured."""
    if "middle" in said.targets:
        m = group_measures.of_middle(survey, subjects)
        return Ruling(m.ok(), (), m)
    if said.type == "facing" and _of_people(said) and all(is_table(b) for b in subjects):
        seats = [seat for b in subjects for seat in used_seats(survey, b)]
        if not seats:
            return Ruling(False, tuple(subjects), counted("seats at it", 0, 1))
        subjects = seats
    if said.type in GROUPS:
        return _of_group(survey, said, subjects)
    table = _table(survey, said, subjects)
    if table is None:
        return None
    if said.each:
        return _of_each(survey, said, subjects, table)
    verdicts = [_any_of_each(rows) for rows in table]
    if said.type == "between" and said.count is None and (alone := _left_out(survey, said, table)) is not None:
        return Ruling(False, tuple(subjects), alone)
    return _counted(survey, said, subjects, verdicts)


def _of_people(said: StatedRelation) -> bool:
    """Whether it is said of those who sit at a thing: a console looks at nothing."""
    return not set(words("bearing_words")["looking"].split()).isdisjoint(said.words.lower().split())


def _table(
    survey: Survey, said: StatedRelation, subjects: Sequence[Body]
) -> list[dict[str, dict[str, Verdict]]] | None:
    """For each subject, by target of the relation and by instance of it, whether it holds."""
    found = []
    for body in subjects:
        if said.type == "between":
            verdicts = _between(survey, said, body)
            if verdicts is None:
                return None
            found.append({"between": verdicts})
            continue
        rows = {}
        for name in said.targets:
            verdicts = _verdicts(survey, said, body, name)
            if verdicts is None:
                return None
            rows[name] = verdicts
        found.append(rows)
    return found if said.targets else None


def _verdicts(survey: Survey, said: StatedRelation, body: Body, name: str) -> dict[str, Verdict] | None:
    """Whether it holds of a subject for every instance of a target; None when it says nothing of such a target."""
    if survey.brief.entity(name) is not None:
        meant = desk_side(said, survey.brief)
        word = word_of_things(_word_of(said, survey.brief))
        if word is None or not word.holds:
            return None
        reach = word_of_things(IN_REACH) if own_on_floor(said, survey.brief) is not None else None
        found = {}
        for other in in_order(survey.standing_for(meant.desk if meant is not None else name), said.nth):
            if other is body:
                continue
            if said.side is None:
                verdict = _judged(survey, word, said, body, other)
                if verdict.holds and reach is not None:
                    verdict = _judged(survey, reach, said, body, other)
                walls = _across_the_room(survey, body, other) if said.type == "opposite" and verdict.holds else None
                found[other.id] = Verdict(False, walls) if walls is not None and not walls.ok() else verdict
                continue
            for side in sides_named(other, said.side):
                found[f"{other.id} {side}"] = _judged(survey, word, said, body, other, side)
        return found
    if name == "room":
        return {name: Verdict(True)}
    word = word_of_place(said.type, name)
    if not word.holds:
        return None
    if name.startswith("half:"):
        return {name: decide([[group_measures.of_half(survey, body, name.partition(":")[2])]])}
    if name.partition(":")[0] == "corner":
        return {
            f"corner {b.index}": _in_corner(survey, word, said, body, (a, b))
            for a, b in corners(survey, name.partition(":")[2])
        }
    if name in ("ceiling", "floor"):
        return {name: _judged(survey, word, said, body, None)}
    return {segment.id: _judged(survey, word, said, body, segment) for segment in segments(survey, name)}


def _word_of(said: StatedRelation, brief: SceneGraph) -> str:
    """The word of ``rules/stated.yaml`` that is meant: of seats at desks and before mirrors it is their own."""
    side, station = desk_side(said, brief), own_on_wall(said, brief)
    if side is not None:
        return side.side
    if station is not None:
        return AT_STATION if station.seats == said.subject else OVER_STATION
    return said.type


def in_order(bodies: Sequence[Body], nth: int) -> list[Body]:
    """The ``nth`` of bodies along their row, counted from either of its ends as a request does not say from which, -1
    for the last; all of them for 0."""
    if not nth or abs(nth) > len(bodies):
        return list(bodies)
    spread = [max(b.centre[k] for b in bodies) - min(b.centre[k] for b in bodies) for k in (0, 1)]
    axis = spread.index(max(spread))
    row = sorted(bodies, key=lambda b: b.centre[axis])
    at = nth - 1 if nth > 0 else len(row) + nth
    return list(dict.fromkeys((row[at], row[-1 - at])))


def _judged(
    survey: Survey, word: Word, said: StatedRelation, body: Body, target: Target | None, side: str | None = None
) -> Verdict:
    return decide(_ways(survey, word, said, body, target, side))


def _ways(
    survey: Survey, word: Word, said: StatedRelation, body: Body, target: Target | None, side: str | None = None
) -> Iterator[Measurements]:
    other = _thing(target) if isinstance(target, Body) else None
    scope = {"a": _thing(body), "b": other, "diagonal": survey.diagonal, "area": survey.area}
    return stated(word, survey, body, target, scope, dict(said.params), side)


def _walls_of(survey: Survey, body: Body) -> list[Wall]:
    """The walls that a body stands or hangs at."""
    close = number("at_wall")
    return [
        wall
        for wall in survey.placed.walls
        if -close <= wall.coordinates(body.centre)[0] <= wall.length + close
        and min(abs(wall.coordinates(corner)[1]) for corner in body.corners) <= close
    ]


def _across_the_room(survey: Survey, body: Body, other: Body) -> Measurement | None:
    """The angle between the walls that two things are at, where both are at walls."""
    pairs = list(itertools.product(_walls_of(survey, body), _walls_of(survey, other)))
    if not pairs:
        return None
    most = max(abs(math.degrees(wrap_angle(a.yaw - b.yaw))) for a, b in pairs)
    return Measurement("between their walls", most, 180.0 - number("across"), 180.0, "deg", 1e-6)


def _in_corner(survey: Survey, word: Word, said: StatedRelation, body: Body, walls: Sequence[Wall]) -> Verdict:
    """As it is said of both walls of a corner."""
    return decide([[m for wall in walls for way in _ways(survey, word, said, body, whole(wall)) for m in way]])


def _thing(body: Body) -> Thing:
    return Thing(body.id, body.item.category, body.size, body.item.mount)


def _between(survey: Survey, said: StatedRelation, body: Body) -> dict[str, Verdict] | None:
    """Whether a subject is between things, for every choice of them."""
    pools = []
    for name in said.targets:
        if survey.brief.entity(name) is not None:
            pools.append(
                [(b.id, group_measures.outline(survey, b)) for b in survey.standing_for(name) if b is not body]
            )
        else:
            pools.append([(s.id, s.line) for s in segments(survey, name)])
    if len(pools) == 1:
        pools *= 2
    if len(pools) < 2:
        return None
    found = {}
    for chosen in itertools.islice(itertools.product(*pools), MOST_PAIRS):
        names = [name for name, _ in chosen]
        if len(set(names)) == len(names):
            shapes = [shape for _, shape in chosen]
            ends = [next((b for b in survey.bodies if b.id == name), None) for name in names]
            found[" ".join(names)] = decide([group_measures.of_between(survey, body, shapes, ends)])
    return found


def _left_out(survey: Survey, said: StatedRelation, table: list[dict[str, dict[str, Verdict]]]) -> Measurement | None:
    """Of what something is between, how many it is beside, where those are fewer than asked: between a sofa and two
    chairs it has both chairs beyond it."""
    used = {name for rows in table for n, v in rows["between"].items() if v.holds for name in n.split()}
    if not used:
        return None
    for target in said.targets:
        ids = [b.id for b in survey.standing_for(target)]
        least = min(len(ids), survey.least(target))
        have = counted(f"of {target.replace('_', ' ')} that it is beside", len(used.intersection(ids)), least)
        if ids and not have.ok():
            return have
    return None


def _any_of_each(rows: dict[str, dict[str, Verdict]]) -> Verdict:
    """It has to hold for some instance of every target."""
    best = []
    for verdicts in rows.values():
        if not verdicts:
            return Verdict(False)
        best.append(next((v for v in verdicts.values() if v.holds), None) or _nearest(list(verdicts.values())))
    return next((v for v in best if not v.holds), best[0])


def _nearest(verdicts: Sequence[Verdict]) -> Verdict:
    return min(verdicts, key=lambda v: weight_of(v.worst) if v.worst is not None else math.inf)


def _counted(survey: Survey, said: StatedRelation, subjects: Sequence[Body], verdicts: Sequence[Verdict]) -> Ruling:
    """Whether it holds of as many subjects as it is said of: all of them, where it does not say."""
    good = [b for b, v in zip(subjects, verdicts, strict=True) if v.holds]
    bad = [b for b in subjects if b not in good]
    if said.count is not None:
        least, most = said.count
        enough = counted("objects of which it holds", len(good), least, most if said.side else math.inf)
        if enough.ok():
            return Ruling(True, (), _first(verdicts, True) or enough)
        wrong = bad[: max(1, least - len(good))] if len(good) < least else good[most:]
        return Ruling(False, tuple(wrong), _first(verdicts, False) or enough, abs(len(good) - least) / max(1, least))
    if len(good) >= survey.least(said.subject):  # what came along may stand elsewhere
        bad = [b for b in bad if b.item.intent.request == said.subject]
    if not bad:
        return Ruling(True, (), _first(verdicts, True))
    return Ruling(False, tuple(bad), _first(verdicts, False), len(bad) / len(subjects))


def _first(verdicts: Sequence[Verdict], holds: bool) -> Measurement | None:
    return next((v.worst for v in verdicts if v.holds is holds and v.worst is not None), None)


def _of_each(
    survey: Survey, said: StatedRelation, subjects: Sequence[Body], table: list[dict[str, dict[str, Verdict]]]
) -> Ruling:
    """Whether every instance of the target (or side of it) has as many subjects of its own as it should."""
    least, most = share_of(survey, said), (said.count or (1, 10**6))[1]
    names = dict.fromkeys(name for rows in table for verdicts in rows.values() for name in verdicts)
    have = {
        n: [b for b, rows in zip(subjects, table, strict=True) if any(n in v and v[n].holds for v in rows.values())]
        for n in names
    }
    short = {name: found for name, found in have.items() if not least <= len(found) <= most}
    if not have:
        return Ruling(False, tuple(subjects))
    own = own_partners({name: [b.id for b in found] for name, found in have.items()}, least)
    shared = {name: [b for b in have[name] if b.id in ids] for name, ids in own.items() if len(ids) < least}
    short |= {name: found for name, found in shared.items() if name not in short}
    if not short:
        return Ruling(True, (), counted("objects at each", min(map(len, have.values())), least, _end(most)))
    name, found = min(short.items(), key=lambda row: len(row[1]))
    busy = {b.id for bodies in have.values() for b in bodies}
    wrong = [b for b in subjects if b.id not in busy] or (found[most:] if len(found) > most else list(subjects))
    return Ruling(
        False, tuple(wrong), counted(f"objects at {name}", len(found), least, _end(most)), len(short) / len(have)
    )


def _together(survey: Survey, said: StatedRelation) -> list[Body]:
    """The subjects of all relations that flank the same, or are around it: a sofa and a table flank a rug, each on one
    side."""
    same = (o for o in survey.brief.relations if o.type == said.type and o.targets == said.targets)
    return [b for name in dict.fromkeys(o.subject for o in same) for b in survey.standing_for(name)]


def _end(most: int) -> float:
    return math.inf if most >= 10**6 else most


def _of_group(survey: Survey, said: StatedRelation, subjects: Sequence[Body]) -> Ruling | None:
    """Flanking and around: the subjects of each target together."""
    targets: list[group_measures.Target] = []
    for name in said.targets:
        if survey.brief.entity(name) is not None:
            targets += [b for b in survey.standing_for(name) if b not in subjects or len(subjects) > 1]
        elif said.type == "flanking" and name in ("window", "door"):
            targets += segments(survey, name)
        else:
            return None
    if not said.each and (said.type == "flanking" or len(subjects) == 1):
        subjects = _together(survey, said)
    least, most = (share_of(survey, said) if said.each else 1), 10**6
    if said.count is not None:
        least, most = said.count
    elif not said.each:
        least = max(1, min(len(subjects), survey.least(said.subject)))
    rule = group_measures.of_flanking if said.type == "flanking" else group_measures.of_around
    parts = group_measures.shared_out(survey, subjects, targets, said.type)
    rulings = []
    for target, part in zip(targets, parts, strict=True):
        verdict = rule(survey, part, target)
        enough = counted("objects beside it", len(part), least, _end(most) if said.each else math.inf)
        rulings.append(verdict if not verdict.holds or enough.ok() else Verdict(False, enough))
    if not rulings:
        return Ruling(False, tuple(subjects))
    used = {b.id for part in parts for b in part}
    stray = [b for b in subjects if b.id not in used]
    if said.each:
        good = all(v.holds for v in rulings)
    elif len(targets) == 1 or said.count is not None:
        good = any(v.holds for v in rulings)
    else:  # several targets share the subjects
        good = all(rule(survey, part, t).holds for t, part in zip(targets, parts, strict=True) if part)
        good = good and len(used) >= least
    if good:
        return Ruling(True, (), _first(rulings, True))
    wrong = tuple(stray or subjects)
    return Ruling(False, wrong, _first(rulings, False), len(wrong) / len(subjects))
