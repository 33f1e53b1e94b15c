"""``read_request``: a request in plain English as a typed brief."""

from __future__ import annotations

import re

from sceneweaver.assets import categories
from sceneweaver.scene import InputError

from .clean import Cleaned, check, clean
from .lexer import tokens
from .meaning import meanings
from .model import Entity, Exclusion, SceneGraph, StatedRelation, Unread
from .mutual import EACH_OTHER, pairs, split_mutual
from .parser import Parser
from .parser_state import Mention, ParsedRelation, ParsedRequest

STATED = {"beside": "next_to", "by": "near", "flank": "flanking", "at_table": "at", "away": "far_from"}
"""Kinds of the parser that the graph calls by another name."""

MOST = 400
"""Most things of a request that are taken seriously, of one kind and together."""


def read_request(text: str) -> SceneGraph:
    """What a request says. What is not understood is listed, what is assumed is noted; nothing is lost.

    Raises:
        InputError: when there is nothing to read.
    """
    if not isinstance(text, str) or not text.strip():
        raise InputError('prompt: it is empty; say what room you want, such as "a bedroom with a desk"')
    cleaned = clean(text)
    notes = list(cleaned.notes)
    parsed = Parser(tokens(cleaned.text, notes, cleaned.sides), notes).run()
    _sides(parsed, cleaned)
    notes += [note for note in cleaned.notes if note not in notes]
    foreign = sum(ord(c) > 0x24F and c.isalpha() for c in text)
    if foreign > 3 or not re.search(r"[a-zA-Z]", text):
        notes.append("only English is read; what else the request says was not understood")
    elif parsed.room_type is None and not parsed.mentions and sum(len(u.split()) for u in parsed.unread) >= 3:
        notes.append("nothing of it names a room or furniture; only English is read")
    brief = _brief(text, cleaned, parsed, notes)
    if not notes and not brief.unread and brief == SceneGraph(text=text):
        return brief.model_copy(update={"notes": ("nothing of the request was understood",)})
    return brief


def _sides(parsed: ParsedRequest, cleaned: Cleaned) -> None:
    """The sides that are of no thing are those of the room; the first count."""
    for sides in parsed.sides:
        if cleaned.size is None:
            cleaned.size = (max(sides[:2]), min(sides[:2]))
            if len(sides) > 2 and cleaned.height is None:
                cleaned.height = sides[2]
        elif set(sides[:2]) != set(cleaned.size):
            cleaned.notes.append(f"{sides[0]:g} x {sides[1]:g} m: the room has other sides already; it was left out")
    check(cleaned)


def _brief(text: str, cleaned: Cleaned, parsed: ParsedRequest, notes: list[str]) -> SceneGraph:
    split_mutual(parsed)
    mentions = _first(_without_contradictions(parsed, notes), parsed, notes)
    _named(mentions)
    ids = {id(m): m.id for m in mentions}
    relations = [r for said in parsed.said for r in _relations(said, ids, notes)]
    relations = [r.model_copy(update={"id": f"relation-{k}"}) for k, r in enumerate(_once(relations))]
    style = parsed.style
    graph = SceneGraph(
        text=text,
        room_type=parsed.room_type,
        room_words=parsed.room_words,
        shape=parsed.shape,  # type: ignore[arg-type]
        size=cleaned.size,
        area=cleaned.area,
        height=cleaned.height,
        scale=parsed.room_scale,
        people=parsed.people,
        for_whom=tuple(parsed.for_whom),
        style=style,
        colors=tuple(dict.fromkeys(parsed.colors)),
        windows=parsed.openings.get("window"),
        doors=parsed.openings.get("door"),
        density=parsed.density or "normal",  # type: ignore[arg-type]
        entities=tuple(_asked(m, notes) for m in mentions),
        relations=tuple(relations),
        exclusions=tuple(
            Exclusion(id=f"exclusion-{k}", words=word, categories=(word,))
            for k, word in enumerate(dict.fromkeys(parsed.without))
        ),
        only=parsed.only,
        unread=tuple(Unread(words=word) for word in dict.fromkeys(parsed.unread) if word.strip()),
    )
    sayable = {id(r) for r, _ in meanings(graph)}
    notes += [f"'{r.words}' cannot be said as a relation" for r in relations if id(r) not in sayable]
    return graph.model_copy(update={"notes": tuple(dict.fromkeys(notes))})


def _without_contradictions(parsed: ParsedRequest, notes: list[str]) -> list[Mention]:
    """What is both wanted and not wanted stays out."""
    kept: list[Mention] = []
    related = {id(m) for said in parsed.said for m in said.subjects}
    for k, one in enumerate(parsed.mentions):
        for two in parsed.mentions[k + 1 :] if one.count and id(one) not in related else ():
            if (
                one.category == two.category
                and one.count
                and two.count
                and one.count != two.count
                and not {id(one), id(two)} & related
                and (one.color, one.material, one.scale) == (two.color, two.material, two.scale)
            ):
                notes.append(f"{one.noun}: {one.count[0]} and {two.count[0]} were asked for; both are made")
    for mention in parsed.mentions:
        if mention.category in parsed.without:
            notes.append(f"{mention.noun} is both wanted and not wanted; it was left out")
            continue
        if mention.count == (0, 0):
            parsed.without.append(mention.category)
            continue
        kept.append(mention)
    return kept


def _first(mentions: list[Mention], parsed: ParsedRequest, notes: list[str]) -> list[Mention]:
    """What comes first in a request, as long as that is `MOST` things; the rest counts as not understood."""
    total, kept = 0, []
    for mention in mentions:
        total += min(mention.count[1], MOST) if mention.count else 1
        if total <= MOST:
            kept.append(mention)
        else:
            parsed.unread.append(mention.noun)
    if len(kept) < len(mentions):
        notes.append(f"{len(mentions) - len(kept)} more were left out: at most {MOST} things are made of a request")
    return kept


def _named(mentions: list[Mention]) -> None:
    used: dict[str, int] = {}
    for mention in mentions:
        n = used.get(mention.category, 0) + 1
        used[mention.category] = n
        mention.id = mention.category if n == 1 else f"{mention.category}-{n}"


def _asked(mention: Mention, notes: list[str]) -> Entity:
    count = mention.count
    if count is not None and count[1] > MOST:
        notes.append(f"{count[1]} x {mention.noun} was brought to {MOST}")
        count = (min(count[0], MOST), MOST)
    d, w, h = mention.size
    found = categories()[mention.category].size
    for want, bounds, name in zip(mention.size, found.ranges if found else (), ("deep", "wide", "high"), strict=False):
        if want is not None and not bounds[0] - 1e-6 <= want <= bounds[1] + 1e-6:
            notes.append(
                f"a {mention.noun} {want:g} m {name} cannot be made; it is {bounds[0]:g} to {bounds[1]:g} m {name}"
            )
    return Entity(
        id=mention.id,
        noun=mention.noun,
        category=mention.category,
        count=count,
        color=mention.color,
        material=mention.material,
        style=mention.style,
        size=(d, w, h),
        scale=mention.scale,
        words=tuple(mention.words),
    )


def _relations(said: ParsedRelation, ids: dict[int, str], notes: list[str]) -> list[StatedRelation]:
    """A spoken relation, one for each kind of thing that it is about."""
    subjects = [m for m in said.subjects if id(m) in ids]
    kind = STATED.get(said.kind, said.kind)
    if said.target == EACH_OTHER:
        if len(subjects) < 2:
            noun = subjects[0].noun if subjects else "things"
            notes.append(f"'{said.words}' cannot be said of these {noun}; it was left out")
        both = [(a.id, (b.id,)) for a, b in pairs(said.kind, subjects)]
    else:
        targets = said.target if isinstance(said.target, tuple) else (said.target,)
        names = tuple(t if isinstance(t, str) else ids.get(id(t), "") for t in targets)
        kind = "at" if names in (("corner",), ("middle",)) else kind
        both = [(subject.id, names) for subject in subjects if all(names) and names != (subject.id,)]
    return [
        StatedRelation(type=kind, subject=subject, targets=names, words=said.words)  # type: ignore[arg-type]
        for subject, names in both
    ]


def _once(relations: list[StatedRelation]) -> list[StatedRelation]:
    """Each relation once; "a bed with nightstands" says no more where a word says how they stand to the bed."""
    seen, kept = set(), []
    plain = {(r.subject, r.targets) for r in relations if " with " not in r.words}
    for r in relations:
        if " with " in r.words and (r.subject, r.targets) in plain:
            continue
        key = (r.type, r.subject, r.targets)
        if key not in seen:
            seen.add(key)
            kept.append(r)
    return kept
