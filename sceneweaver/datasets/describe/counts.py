"""Questions of what there is: counts, existence, colours, what rests on what."""

from __future__ import annotations

from collections import Counter
from functools import lru_cache

from sceneweaver.knowledge import room_types
from sceneweaver.knowledge.kin import kin
from sceneweaver.verify.solids import Body

from .asker import Asker, Question
from .english import colors_apart, noun, nouns, with_article
from .facts import Facts
from .naming import color


@lru_cache(maxsize=2**16)
def _confusable(category: str, other: str) -> bool:
    """Whether someone may count one for the other."""
    mine, theirs = noun(category), noun(other)
    same_words = theirs.endswith(mine) or mine.endswith(theirs) or nouns(category) in theirs or nouns(other) in mine
    return same_words or other in kin(category)


def _countable(facts: Facts) -> list[str]:
    """Categories that nothing else in the room could be taken for."""
    there = sorted(facts.by_category)
    return [c for c in there if not any(d != c and _confusable(c, d) for d in there)]


def how_many(asker: Asker) -> Question | None:
    """How many of a category there are."""
    by_category = asker.facts.by_category
    known = _countable(asker.facts)
    # A number is drawn first, so that none is the usual answer.
    numbers = sorted({len(by_category[c]) for c in known} & set(range(1, 13)))
    if not numbers:
        return None
    wanted = asker.one(numbers)
    category = asker.one([c for c in known if len(by_category[c]) == wanted])
    objects = tuple(b.id for b in by_category[category])
    return asker.ask("count", wanted, (), {"category": category}, objects=objects, things=nouns(category))


def exists(asker: Asker) -> Question | None:
    """Whether there is something of a category; what is not there is usual in rooms of this kind."""
    by_category = asker.facts.by_category
    there = sorted(by_category)
    kind = room_types().get(asker.facts.scene.room.type)
    if kind is None:
        return None
    # Both answers come from things that rooms of this kind have as often, so that knowing rooms does not do.
    for need in ("optional", "usual"):
        kinds = sorted({c for item in kind.items if item.need == need for c in item.what})
        absent = [c for c in kinds if not any(c == d or _confusable(c, d) or _confusable(d, c) for d in there)]
        present = [c for c in kinds if c in there]
        if present and absent:
            said = asker.coin()
            category = asker.one(present if said else absent)
            objects = tuple(b.id for b in by_category.get(category, ()))
            operands = {"category": category, "count": len(objects)}
            return asker.ask("exists", said, (), operands, objects=objects, thing=with_article(noun(category)))
    return None


def more_of(asker: Asker) -> Question | None:
    """Whether there are more of one category than of another."""
    by_category = asker.facts.by_category
    known = _countable(asker.facts)
    pairs = [(a, b) for a in known for b in known if a != b and len(by_category[a]) != len(by_category[b])]
    found = asker.balanced(
        asker.shuffled(pairs), lambda pair: (len(by_category[pair[0]]) > len(by_category[pair[1]]), None)
    )
    if found is None:
        return None
    (a, b), said, _ = found
    objects = tuple(body.id for c in (a, b) for body in by_category[c])
    operands = {a: len(by_category[a]), b: len(by_category[b])}
    return asker.ask("more_of", said, (), operands, objects=objects, things=nouns(a), others=nouns(b))


def what_color(asker: Asker) -> Question | None:
    """The colour of a thing, of four."""
    coloured = [b for b in asker.standing if color(b)]
    shown = sorted({c for b in asker.facts.bodies if (c := color(b))})
    if not coloured or len(shown) < 2:
        return None
    body = asker.one(coloured)
    said = color(body)
    if said is None or said in asker.name(body):
        return None
    others = [c for c in asker.shuffled([*shown, "red", "blue", "green", "black", "white"]) if colors_apart(c, said)]
    options = asker.shuffled(list(dict.fromkeys([said, *others]))[:4])
    return asker.ask("color", said, (body,), {"color": said}, options=options)


def what_is_on(asker: Asker) -> Question | None:
    """What rests on a thing."""
    carriers = [
        (key, things)
        for key, things in asker.facts.carried.items()
        if key[0] in asker.names and 1 <= len(things) <= 8 and len({_surface(t) for t in things}) == 1
    ]
    if not carriers:
        return None
    (carrier, how), things = asker.one(carriers)
    body = asker.facts.by_id[carrier]
    operands = {"carrier": carrier, "supports": {t.id: _surface(t) for t in things}}
    objects = (*asker.ids(body), *(t.id for t in things))
    counts = Counter(noun(t.item.category) for t in things)
    inventory = [word for word in sorted(counts) for _ in range(counts[word])]
    return asker.ask(f"what_is_{how}", inventory, (body,), operands, objects=objects)


def _surface(thing: Body) -> str | None:
    return thing.item.support.surface if thing.item.support is not None else None


def is_on(asker: Asker) -> Question | None:
    """Whether a thing rests on another."""
    facts = asker.facts
    carriers = [facts.by_id[c] for c, how in facts.carried if how == "on" and c in asker.names]
    small = [b for b in asker.named if b.item.support is not None and len(asker.names[b.id].ids) == 1]

    def answer(pair: tuple[Body, Body]) -> tuple[bool | None, str]:
        thing, carrier = pair
        support = thing.item.support
        on = {b.id for b in facts.carried.get((carrier.id, "on"), ())}
        chain = support is not None and support.object != carrier.id and _stands_over(facts, thing, carrier)
        inside = support is not None and support.object == carrier.id and thing.id not in on
        return (None if chain or inside else thing.id in on), support.object if support else ""

    likely = [(b, facts.by_id[b.item.support.object]) for b in small if b.item.support is not None]
    direct = [(b, c) for b, c in asker.shuffled(likely) if c.id in asker.names][:8]
    found = asker.balanced(asker.shuffled([*direct, *list(asker.pairs(small, carriers))[:8]]), answer)
    if found is None:
        return None
    pair, said, support = found
    return asker.ask("is_on", said, pair, {"support": support})


def _stands_over(facts: Facts, thing: Body, carrier: Body) -> bool:
    """Whether a carrier holds a thing by way of others."""
    support = thing.item.support
    while support is not None:
        if support.object == carrier.id:
            return True
        support = facts.by_id[support.object].item.support
    return False


TEMPLATES = (how_many, how_many, exists, exists, more_of, what_color, what_is_on, is_on)
