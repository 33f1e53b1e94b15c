"""``read_brief``: a request in plain English as a typed brief."""

from __future__ import annotations

import re
from typing import Any

from sceneweaver.assets import categories
from sceneweaver.scene import InputError

from .clean import Cleaned, check, clean
from .lexer import tokens
from .model import Asked, AskedRelation, Brief
from .mutual import EACH_OTHER, pairs, split_mutual
from .parser import Parser
from .parser_state import BESIDE, CATALOGUE, Mention, ParsedRelation, ParsedRequest
from .relating import family

_BEDS = ("bed", "king_bed", "single_bed", "canopy_bed")

MOST = 400
"""Most things of a request that are taken seriously, of one kind and together."""


def read_brief(text: str) -> Brief:
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
    if not notes and not brief.unread and brief == Brief(text=text):
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


def _brief(text: str, cleaned: Cleaned, parsed: ParsedRequest, notes: list[str]) -> Brief:
    split_mutual(parsed)
    mentions = _first(_without_contradictions(parsed, notes), parsed, notes)
    _named(mentions)
    ids = {id(m): m.id for m in mentions}
    relations = [r for said in parsed.said for r in _relations(said, ids, notes)]
    style = parsed.style
    return Brief(
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
        objects=tuple(_asked(m, notes) for m in mentions),
        relations=tuple(_once(relations)),
        without=tuple(dict.fromkeys(parsed.without)),
        only=parsed.only,
        unread=tuple(dict.fromkeys(word for word in parsed.unread if word.strip())),
        notes=tuple(dict.fromkeys(notes)),
    )


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


def _asked(mention: Mention, notes: list[str]) -> Asked:
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
    return Asked(
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


def _relations(said: ParsedRelation, ids: dict[int, str], notes: list[str]) -> list[AskedRelation]:
    """A spoken relation as relations of the catalogue, one for each kind of thing that it is about."""
    subjects = [m for m in said.subjects if id(m) in ids]
    if said.target == EACH_OTHER:
        if len(subjects) < 2:
            noun = subjects[0].noun if subjects else "things"
            notes.append(f"'{said.words}' cannot be said of these {noun}; it was left out")
        return [
            AskedRelation(type=CATALOGUE[said.kind], subject=a.id, target=b.id, words=said.words)
            for a, b in pairs(said.kind, subjects)
        ]
    out = []
    for subject in subjects:
        kind, target, params = _meaning(said, subject, ids)
        if kind is None:
            if target is not None:
                notes.append(f"'{said.words}' cannot be said as a relation and was left out")
            continue
        if isinstance(target, str) and target == subject.id:
            continue
        out.append(AskedRelation(type=kind, subject=subject.id, target=target, params=params, words=said.words))
    return out


def _meaning(said: ParsedRelation, subject: Mention, ids: dict[int, str]) -> tuple[str | None, Any, dict[str, Any]]:
    """Type, target and parameters; type None when there is no such relation (target None: nothing to say)."""
    target = said.target
    if isinstance(target, str):
        return _at_place(said.kind, target, subject)
    if isinstance(target, tuple):
        pair = tuple(ids.get(id(m), "") for m in target)
        return ("between", pair, {}) if all(pair) else (None, None, {})
    name = ids.get(id(target))
    if name is None:
        return None, None, {}
    kind = CATALOGUE.get(said.kind)
    mount = categories()[subject.category].mount
    support = categories()[target.category]
    carries = support.mount[0] == "floor" or bool(support.holds)
    if said.kind in ("on", "inside") and (mount[0] == "wall" or ("surface" not in mount and mount[0] != "floor")):
        return "above", name, {}
    if said.kind in ("on", "inside") and (not carries or (mount[0] == "floor" and "surface" not in mount)):
        return "near", name, {"max": 0.3}
    if said.kind in ("beside", "by") and subject.category == "nightstand" and target.category in _BEDS:
        return "leftright_to_leftright", name, {}
    if said.kind == "flank" and mount[0] != "floor":
        return "near", name, {"max": BESIDE}
    if said.kind in ("by", "at_table") and family(subject.category) == "seat" and family(target.category) == "table":
        return "front_against", name, {}
    if said.kind in ("beside", "by", "below"):
        return "near", name, {"max": BESIDE if said.kind != "below" else 0.0}
    if said.kind == "against":
        return "near", name, {"max": 0.1}
    if said.kind == "above" and mount[0] == "ceiling":
        return "near", name, {"max": 0.3}
    if said.kind == "away":
        return None, name, {}
    if said.kind == "around" and mount[0] == "floor":
        return "front_against", name, {}
    return kind, name, {}


def _at_place(kind: str, place: str, subject: Mention) -> tuple[str | None, Any, dict[str, Any]]:
    mount = categories()[subject.category].mount[0]
    if place == "middle":
        return "centered_on", "middle", {}
    if place == "corner":
        return ("in_corner", None, {}) if mount == "floor" else (None, None, {})
    if place == "window" and kind in ("facing", "opposite"):
        return None, place, {}
    if place == "window":
        return ("away_from_door", None, {}) if kind == "away" else ("at_window", "window", {})
    if place == "door":
        return ("away_from_door", None, {}) if kind in ("away", "opposite", "facing") else (None, place, {})
    if place.startswith("wall"):
        return ("against_wall", place if ":" in place else None, {}) if mount != "surface" else (None, None, {})
    return None, None, {}


def _once(relations: list[AskedRelation]) -> list[AskedRelation]:
    """Each relation once; "a bed with nightstands" says no more where a word says how they stand to the bed."""
    seen, kept = set(), []
    for r in relations:
        if " with " in r.words and any(
            o is not r and (o.subject, o.target) == (r.subject, r.target) and " with " not in o.words for o in relations
        ):
            continue
        key = (r.type, r.subject, r.target)
        if key not in seen:
            seen.add(key)
            kept.append(r)
    return kept
