"""What was read of a request as a scene graph: ids, relations one by one, what contradicts itself."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import pairwise
from typing import Any, get_args

from sceneweaver.assets.plurals import singular
from sceneweaver.assets.states import state_of
from sceneweaver.assets.taxonomy import category_named, narrower

from .built_in import by_their_names
from .carrying import is_vessel, told_by_carriers
from .coverage import silent_words
from .distribution import tell_each
from .in_room import mean_in_room
from .meaning import unsaid
from .measured import give_states, measured
from .model import Amount, Attribute, Entity, Exclusion, RelationType, SceneGraph, StatedMeasure, StatedRelation, Unread
from .mutual import split_mutual
from .parsed import Barred, Left, Mention, Parsed, Said
from .source import Source
from .statements.audiences import audiences
from .statements.counts import bounded_counts, peopled, shared_counts, told_apart
from .statements.resolve import entity_named, resolved
from .stations import settle_stations
from .told_states import LAID_FOR, state_as_told
from .translation import UNKNOWN
from .untold import empty_sentences, in_phrases
from .vocabulary import words

MOST = 400
"""Most things of a request that are taken seriously, of one kind and together."""

MOST_SMALL = 120
"""Most small things of one kind that are laid out one by one: with hundreds of bottles the room gets nothing else."""

SEVERAL, PLURAL = 6, 6
"""Things that there are at least of what is all over a room, and most of a bare plural."""

PLACE = "place_setting"
"""What is laid for somebody who eats at a table."""

PATCH, FEW = 0.2, 3
"""Floor [m2] that one thing covers from which on `FEW` of it are all over a room."""

FULL, SCATTERED = "full", "scattered"
"""States that follow from what else is said: of a cup of tea, of clothes all over a floor; see ``states.yaml``."""

_SAME = ("room_type", "room_words", "other_rooms", "shape", "wing", "style", "only")
"""What a graph says of the room as it was parsed."""

_SIDES = ("left_of", "right_of", "next_to", "in_front_of", "behind", "near", "flanking", "around")


def build(text: str, source: Source, parsed: Parsed) -> SceneGraph:
    """The graph of a request; notes say what was left out."""
    notes = parsed.notes
    settle_stations(parsed)
    tell_each(parsed)
    split_mutual(parsed)
    mentions = _first(_without_contradictions(parsed), parsed)
    for mention in mentions:
        _narrowed(mention)
    mean_in_room(mentions, parsed, text.lower())
    lengths = measured(parsed, mentions, text)
    give_states(parsed, mentions, text)
    _in_form(mentions)
    mentions += _laid_places(mentions, parsed)
    told_by_carriers(parsed, mentions)
    _named(mentions)
    _shared_support(parsed)
    _by_attribute(parsed, mentions)
    _pairs_of_flanks(parsed)
    relations = _once([r for said in parsed.said for r in _relations(said, mentions, notes)])
    exclusions = {(words, names): span for words, names, span in reversed(parsed.without)}
    barred = [found for said in parsed.barred if (found := _barred(said, mentions)) is not None]
    entities = tuple(_entity(m, notes) for m in mentions)
    measures = _measures(lengths, parsed, mentions, entities)
    unread = {left.words: left for left in reversed(parsed.unread) if left.words.strip()}
    named = {entity.id for entity in entities}
    amounts = tuple(a for a in resolved(parsed.amounts, entities, "amount") if a.entity in named)
    entities = tuple(_many(_spread_form(entity, amounts), amounts) for entity in entities)
    relations = [*relations, *by_their_names(entities, relations, parsed.stated_openings)]
    relations, arrangements = told_apart(relations, resolved(parsed.arrangements, entities, "arrangement"))
    people = peopled(
        bounded_counts(entities, [*parsed.bounds, *shared_counts(entities, parsed.shared, parsed.people)]),
        relations,
        resolved(parsed.capacities, entities, "capacity"),
        arrangements,
        parsed.people,
        parsed.room_type,
    )
    free = resolved(parsed.free_areas, entities, "free_area")
    by_id = {e.id: e for e in people.entities}
    arrangements, said = audiences(by_id, people.relations, people.arrangements, people.capacities, free, people.people)
    graph = SceneGraph(
        text=text,
        **{name: getattr(parsed, name) for name in _SAME},
        size=source.size,
        area=source.area,
        height=source.height,
        scale=parsed.room_scale,
        for_whom=tuple(dict.fromkeys(parsed.for_whom)),
        finishes=tuple(said.model_copy(update={"id": f"finish-{k}"}) for k, said in enumerate(parsed.finishes)),
        looks=tuple(look.model_copy(update={"id": f"look-{k}"}) for k, look in enumerate(parsed.room_looks)),
        colors=tuple(dict.fromkeys(parsed.colors)),
        windows=parsed.openings.get("window"),
        doors=parsed.openings.get("door"),
        density=parsed.density or "normal",  # type: ignore[arg-type]
        people=people.people,
        entities=people.entities,
        openings=resolved(parsed.stated_openings, entities, "opening"),
        free_areas=free,
        capacities=people.capacities,
        arrangements=arrangements,
        views=resolved(parsed.views, entities, "view"),
        amounts=amounts,
        measures=measures,
        relations=tuple(r.model_copy(update={"id": f"relation-{k}"}) for k, r in enumerate(said)),
        exclusions=_numbered(
            [
                Exclusion(words=w, categories=c, others=w in parsed.others, span=span)
                for (w, c), span in reversed(exclusions.items())
            ]
            + [_but_for(one, entities) for one in parsed.unwanted]
            + barred
        ),
        unread=tuple(
            Unread(words=left.words, span=source.span(left.start, left.end) if left.end > left.start else left.span)
            for left in reversed(unread.values())
        ),
    )
    notes += [f"'{said.words}' cannot be said as a relation" for said in unsaid(graph) if not said.implied]
    silent = silent_words(graph, source.language, parsed.referred, source.slips, source.told)
    placed = {unread.words for unread in silent}
    left = sorted((*(one for one in graph.unread if one.span or one.words not in placed), *silent), key=_first_at)
    if source.language != "en":  # in the words of the request
        left = list(dict.fromkeys(_own_words(one, text) for one in left))
        notes = [note.replace(UNKNOWN, "") for note in notes]
    else:
        left = list(in_phrases(sorted((*left, *empty_sentences(graph, left, parsed.referred)), key=_first_at), graph))
    return graph.model_copy(update={"notes": tuple(dict.fromkeys(notes)), "unread": tuple(left)})


def _first_at(unread: Unread) -> float:
    """Where words stand; what has no place comes last."""
    return unread.span.start if unread.span else float("inf")


def _measures(
    lengths: Sequence[tuple[StatedMeasure, Mention | None]],
    parsed: Parsed,
    mentions: Sequence[Mention],
    entities: Sequence[Entity],
) -> tuple[StatedMeasure, ...]:
    """The lengths of things, then the limits on all things of a kind; a limit on what stands on nothing that is named
    is not understood."""
    found = [
        measure.model_copy(update={"entity": mention.id if mention is not None else ""})
        for measure, mention in lengths
        if mention is None or mention in mentions
    ]
    for limit in parsed.limits:
        on = entity_named(limit.on, entities, limit.span) if limit.on else ""
        if on is None:
            parsed.unread.append(Left(limit.words, span=limit.span))
        else:
            found.append(limit.model_copy(update={"on": on}))
    return tuple(measure.model_copy(update={"id": f"measure-{k}"}) for k, measure in enumerate(found))


def _in_form(mentions: Iterable[Mention]) -> None:
    """What is another thing in the state that is said of it: a blanket that lies crumpled is no folded one. A cup of
    tea is full."""
    for mention in mentions:
        for told in mention.attributes:
            state = state_as_told(mention.category, told) if told.kind == "state" and told.count is None else None
            if state is not None:
                mention.category = state.becomes.get(mention.category, mention.category)
        drink = mention.noun.partition(" of ")[2]
        if drink in words("states")["drinks"] and state_of(mention.category, FULL) is not None:
            level = any(told.kind == "state" for told in mention.attributes)
            full = Attribute(kind="state", value=FULL, words=f"{FULL} of {drink}", span=mention.span)
            mention.attributes += [] if level else [full]
            mention.unnamed = [word for word in mention.unnamed if word not in drink.split()]


def _laid_places(mentions: Sequence[Mention], parsed: Parsed) -> list[Mention]:
    """The places on tables that are told to be laid, which takes the place of what was told."""
    found: list[Mention] = []
    for mention in mentions:
        for told in [told for told in mention.attributes if told.value.startswith(LAID_FOR)]:
            mention.attributes.remove(told)
            many = int(told.value.rpartition(" ")[2])
            places = Mention("place setting", PLACE, (many, many) if many else None, plural=True, span=told.span)
            found.append(places)
            parsed.said.append(Said("on", [places], (mention,), words=told.words, span=told.span))
    return found


def _spread_form(entity: Entity, amounts: Sequence[Amount]) -> Entity:
    """Clothes or papers all over a floor are no piles of folded ones."""
    spread = any(amount.entity == entity.id and amount.spread in ("floor", "everywhere") for amount in amounts)
    state = state_of(entity.category, SCATTERED) if spread else None
    other = state.becomes.get(entity.category) if state is not None else None
    return entity if other is None else entity.model_copy(update={"category": other})


def _own_words(unread: Unread, text: str) -> Unread:
    """What was not understood as it stands in the request."""
    span = unread.span
    alone = all(word.startswith(UNKNOWN) for word in unread.words.split())
    words = unread.words.replace(UNKNOWN, "") if span is None or alone else text[span.start : span.end].strip().lower()
    return unread.model_copy(update={"words": words})


def _but_for(excluded: Exclusion, entities: Sequence[Entity]) -> Exclusion:
    """What is not wanted by material, property or place, without what the request names."""
    named = {entity.category for entity in entities}
    return excluded.model_copy(update={"categories": tuple(c for c in excluded.categories if c not in named)})


def _barred(said: Barred, mentions: list[Mention]) -> Exclusion | None:
    """What must not be somewhere; None where the request names nothing there."""
    (subject,) = said.subjects
    names = tuple(t if isinstance(t, str) else t.id if t in mentions else "" for t in said.targets)
    if not all(names) or not (said.categories or subject in mentions) or said.type not in get_args(RelationType):
        return None
    return Exclusion(
        words=said.words,
        categories=said.categories or (subject.category,),
        relation=said.type,  # type: ignore[arg-type]
        targets=names,
        subject="" if said.categories else subject.id,
        span=said.span,
    )


def _numbered(exclusions: list[Exclusion]) -> tuple[Exclusion, ...]:
    return tuple(one.model_copy(update={"id": f"exclusion-{k}"}) for k, one in enumerate(exclusions))


def _without_contradictions(parsed: Parsed) -> list[Mention]:
    """What is both wanted and not wanted stays out."""
    related = {m for said in parsed.said for m in said.subjects}
    wanted = {m.category: singular(m.noun) for m in parsed.mentions}
    parsed.without = [
        (said, _but_named("" if said in parsed.others else said, names, wanted), span)
        for said, names, span in parsed.without
    ]
    excluded = {name for _, names, _ in parsed.without for name in names}
    first: dict[str, Mention] = {}
    kept: list[Mention] = []
    for mention in parsed.mentions:
        other = first.setdefault(mention.category, mention)
        apart = other is not mention and related.isdisjoint((mention, other)) and other.span != mention.span
        if apart and other.count and mention.count and other.count != mention.count and _alike(other, mention):
            parsed.note(f"{other.noun}: {other.count[0]} and {mention.count[0]} were asked for; both are made")
        if mention.category in excluded:
            parsed.note(f"{mention.noun} is both wanted and not wanted; it was left out")
        elif mention.count == (0, 0):
            parsed.without.append((mention.noun, (mention.category,), mention.span))
        else:
            kept.append(mention)
    return kept


def _but_named(said: str, names: tuple[str, ...], wanted: Mapping[str, str]) -> tuple[str, ...]:
    """What a word rules out but for kinds of it that are asked for by a name of their own: "no plants, a cactus"."""
    own = singular(said)
    return tuple(n for n in names if n not in wanted or (said and (len(names) == 1 or wanted[n].endswith(own))))


def _alike(one: Mention, other: Mention) -> bool:
    """Whether two mentions are described in the same words, so that they may be one thing said twice."""
    looks = [(m.color, m.material, m.scale, m.noun.rstrip("s")) for m in (one, other)]
    return looks[0] == looks[1]


def _first(mentions: list[Mention], parsed: Parsed) -> list[Mention]:
    """What comes first in a request, as long as that is `MOST` things; the rest counts as not understood."""
    total, kept = 0, []
    for mention in mentions:
        if mention.count is not None and mention.count[1] > MOST_SMALL and mention.is_small:
            parsed.note(f"{mention.count[1]} x {mention.noun} was brought to {MOST_SMALL}")
            parsed.unread.append(Left(f"{mention.count[1]} {mention.noun}"))
            mention.count = (min(mention.count[0], MOST_SMALL), MOST_SMALL)
        total += min(mention.count[1], MOST) if mention.count else 1
        if total <= MOST:
            kept.append(mention)
        else:
            parsed.unread.append(Left(mention.noun))
    if len(kept) < len(mentions):
        parsed.note(f"{len(mentions) - len(kept)} more were left out: at most {MOST} things are made of a request")
    return kept


def _narrowed(mention: Mention) -> None:
    """All that is said of a thing, in its name, before it or later, decides its kind: a corner bookcase."""
    if not mention.generic:
        spoken = [*mention.noun.split()[:-1], *(a.words for a in mention.attributes)]
        mention.category = narrower(mention.category, " ".join(spoken))


def _named(mentions: list[Mention]) -> None:
    used: dict[str, int] = {}
    for mention in mentions:
        n = used.get(mention.category, 0) + 1
        used[mention.category] = n
        mention.id = mention.category if n == 1 else f"{mention.category}-{n}"


def _shared_support(parsed: Parsed) -> None:
    """What is beside something that stands on a table stands on the table as well, when it is small."""
    carried: dict[Mention, Mention] = {}
    kinds: dict[Mention, str] = {}
    for said in parsed.said:
        if said.type in ("on", "inside") and isinstance(said.targets[0], Mention):
            for subject in said.subjects:
                if carried.setdefault(subject, said.targets[0]) is said.targets[0] and is_vessel(said.targets[0]):
                    kinds[subject] = said.type
    at_places = [s for s in parsed.said if isinstance(s.targets[0], str) and s.targets[0] != "each other"]
    placed = {m for said in at_places for m in said.subjects}
    for _ in range(2):  # a book beside a mug beside a lamp on the desk
        for said in [s for s in parsed.said if s.type in _SIDES]:
            target = said.targets[0]
            if not isinstance(target, Mention):
                continue
            for one, two in [(s, target) for s in said.subjects] + [(target, s) for s in said.subjects]:
                carrier, open_ = carried.get(two), one not in carried and one not in placed
                if carrier is not None and carrier is not one and open_ and one.is_small and two.is_small:
                    carried[one] = carrier
                    kinds[one] = kinds.get(two, "on")
                    parsed.said.append(Said(kinds[one], [one], (carrier,), said.words, implied=True, span=said.span))


def _by_attribute(parsed: Parsed, mentions: list[Mention]) -> None:
    """ "Wall-mounted", "bedside" and the like say where something is, too."""
    rules = words("nouns")["said_of_place"]
    beds: list[Mention | str] = [m for m in mentions if m.category.endswith("bed") and m.noun != "flower bed"]
    related = {m for s in parsed.said for m in s.subjects if not s.implied}
    for mention in mentions:
        spoken = [word for a in mention.attributes for word in (a.words, *([a.value] if a.kind != "part" else []))]
        spoken += [word for word in rules if f"{mention.noun} ".startswith(f"{word} ")]
        for phrase in dict.fromkeys(word for word in spoken if word in rules):
            kind, place = rules[phrase]
            there = next(iter(beds), None) if place == "bed" else place
            if there is None or there is mention or (place in ("bed", "corner") and mention in related):
                continue
            kind = "flanking" if place == "bed" and mention.count == (2, 2) else kind
            parsed.said.append(Said(kind, [mention], (there,), phrase, implied=True, span=mention.span))


def _pairs_of_flanks(parsed: Parsed) -> None:
    """ "Bookcases on either side of the fireplace" without a number are two: one a side."""
    for said in parsed.said:
        for mention in said.subjects if said.type == "flanking" and len(said.subjects) == 1 else ():
            if mention.count is None or mention.count[0] == 2 < mention.count[1]:
                mention.count = (2, 2)


def _entity(mention: Mention, notes: list[str]) -> Entity:
    count = mention.count
    if count is not None and count[1] > MOST:
        notes.append(f"{count[1]} x {mention.noun} was brought to {MOST}")
        count = (min(count[0], MOST), MOST)
    found = category_named(mention.category).size
    for want, bounds, name in zip(mention.size, found.reach if found else (), ("deep", "wide", "high"), strict=False):
        if want is not None and not bounds[0] - 1e-6 <= want <= bounds[1] + 1e-6:
            notes.append(
                f"a {mention.noun} {want:g} m {name} cannot be made; it is {bounds[0]:g} to {bounds[1]:g} m {name}"
            )
    seen: dict[tuple[str, str], Attribute] = {}
    for attribute in mention.attributes:
        seen.setdefault((attribute.kind, f"{attribute.words}{attribute.count or ''}"), attribute)
    given: dict[str, Any] = {name: getattr(mention, name) for name in Entity.model_fields if hasattr(mention, name)}
    given["attributes"] = [a.model_copy(update={"id": f"{mention.id}/{k}"}) for k, a in enumerate(seen.values())]
    given["size"] = tuple(side if side is None or side > 0 else None for side in mention.size)
    given |= {"count": count, "words": tuple(dict.fromkeys(mention.words)), "unnamed": tuple(mention.unnamed)}
    return Entity(**given)


def _is_patch(category: str) -> bool:
    """Whether one thing of a category covers a piece of floor: leaves, shavings, scattered clothes."""
    known = category_named(category)
    return known.size is not None and known.mount[0] == "floor" and known.size.depth[0] * known.size.width[0] >= PATCH


def _many(entity: Entity, amounts: Sequence[Amount]) -> Entity:
    """An entity of which there are many, with so many; a number that the request gives stays."""
    patch = _is_patch(entity.category)
    told = [FEW if patch else amount.least or SEVERAL for amount in amounts if amount.entity == entity.id]
    low, high = entity.count or (1, 1)
    given = entity.count is not None and (low == high or high > PLURAL)
    return entity if not told or given else entity.model_copy(update={"count": (max(low, *told), MOST)})


def _relations(said: Said, mentions: list[Mention], notes: list[str]) -> list[StatedRelation]:
    """A spoken relation, one for each kind of thing that it is about."""
    subjects = [m for m in dict.fromkeys(said.subjects) if m in mentions]
    if said.targets == ("each other",):
        if len(subjects) < 2:
            noun = subjects[0].noun if subjects else "things"
            notes.append(f"'{said.words}' cannot be said of these {noun}; it was left out")
        both = [(a.id, (b.id,)) for a, b in _couples(said.type, subjects)]
    else:
        names = tuple(t if isinstance(t, str) else t.id if t in mentions else "" for t in said.targets)
        both = [(subject.id, names) for subject in subjects if all(names) and subject.id not in names]
    given = {name: getattr(said, name) for name in StatedRelation.model_fields if hasattr(said, name)}
    return [StatedRelation(**given | {"subject": subject, "targets": names}) for subject, names in both]


def _couples(kind: str, subjects: list[Mention]) -> list[tuple[Mention, Mention]]:
    """Who is related to whom: two that face each other both do, a row goes from one to the next."""
    if kind == "facing":
        couples = list(zip(subjects[::2], subjects[1::2], strict=False))
        return [pair for a, b in couples for pair in ((a, b), (b, a))]
    return list(pairwise(subjects))


def _once(relations: list[StatedRelation]) -> list[StatedRelation]:
    """Each relation once; "a bed with nightstands" says no more where a word says how they stand to the bed."""
    kept: dict[tuple[Any, ...], StatedRelation] = {}
    stated = [r for r in relations if not r.implied]
    plain, placed = {(r.subject, r.targets) for r in stated}, {r.subject for r in stated}
    carried = {r.subject for r in stated if r.type in ("on", "inside")}
    for r in relations:
        placed_anyway = r.subject in carried or (r.subject in placed and r.type in ("near", "above"))
        if not (r.implied and ((r.subject, r.targets) in plain or (" with " in r.words and placed_anyway))):
            kept.setdefault((r.type, r.subject, r.targets, r.side), r)
    return list(kept.values())
