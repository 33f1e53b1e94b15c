"""Questions of what there is: counts, existence, colours, what rests on what."""

from __future__ import annotations

from collections import Counter
from functools import lru_cache

from sceneweaver.knowledge import room_types
from sceneweaver.knowledge.kin import kin
from sceneweaver.verify.solids import Body

from ..facts import Facts
from ..naming import color
from ..nouns import noun, nouns, with_article
from .question import Asker, Question, yes_no


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
    facts = asker.facts
    known = _countable(facts)
    if not known:
        return None
    # A number is drawn first, so that none is the usual answer.
    numbers = sorted({len(facts.by_category[c]) for c in known} & set(range(1, 13)))
    wanted = numbers[int(asker.rng.integers(len(numbers)))] if numbers else 0
    choice = [c for c in known if len(facts.by_category[c]) == wanted]
    if not choice:
        return None
    category = choice[int(asker.rng.integers(len(choice)))]
    found, words = facts.by_category[category], nouns(category)
    return Question(
        "count",
        "count",
        asker.one_of(
            f"How many {words} are there in the room?",
            f"How many {words} does the room have?",
            f"Count the {words} in this room. How many are there?",
        ),
        len(found),
        tuple(b.id for b in found),
        {"category": category},
        "number of objects of this category",
    )


def exists(asker: Asker) -> Question | None:
    """Whether there is something of a category; what is not there is usual in rooms of this kind."""
    facts = asker.facts
    there = sorted(facts.by_category)
    kind = room_types().get(facts.scene.room.type)
    if kind is None:
        return None
    # Both answers come from things that rooms of this kind have as often, so that knowing rooms does not do.
    pools = []
    for need in ("optional", "usual"):
        kinds = sorted({c for item in kind.items if item.need == need for c in item.what})
        absent = [c for c in kinds if not any(c == d or _confusable(c, d) or _confusable(d, c) for d in there)]
        pools.append(([c for c in kinds if c in there], absent))
    found = next(((present, absent) for present, absent in pools if present and absent), None)
    if found is None:
        return None
    present, absent = found
    said = asker.coin()
    pool = present if said else absent
    category = pool[int(asker.rng.integers(len(pool)))]
    words = with_article(noun(category))
    return Question(
        "exists",
        "yes_no",
        asker.one_of(f"Is there {words} in the room?", f"Does the room have {words}?", f"Can {words} be found here?"),
        yes_no(said),
        tuple(b.id for b in facts.by_category.get(category, ())),
        {"category": category, "count": len(facts.by_category.get(category, ()))},
        "whether the number of objects of this category is above 0",
    )


def more_of(asker: Asker) -> Question | None:
    """Whether there are more of one category than of another."""
    facts = asker.facts
    known = _countable(facts)
    pairs = [(a, b) for a in known for b in known if a != b and len(facts.by_category[a]) != len(facts.by_category[b])]
    found = asker.balanced(
        asker.shuffled(pairs), lambda p: (len(facts.by_category[p[0]]) > len(facts.by_category[p[1]]), None)
    )
    if found is None:
        return None
    (a, b), said, _ = found
    return Question(
        "more_of",
        "yes_no",
        asker.one_of(
            f"Are there more {nouns(a)} than {nouns(b)} in the room?",
            f"Does the room have more {nouns(a)} than {nouns(b)}?",
        ),
        yes_no(said),
        tuple(body.id for c in (a, b) for body in facts.by_category[c]),
        {a: len(facts.by_category[a]), b: len(facts.by_category[b])},
        "comparison of the numbers of objects of the two categories",
    )


def what_color(asker: Asker) -> Question | None:
    """The colour of a thing, of four."""
    coloured = [b for b in asker.standing if color(b)]
    shown = sorted({c for b in asker.facts.bodies if (c := color(b))})
    if not coloured or len(shown) < 2:
        return None
    body = coloured[int(asker.rng.integers(len(coloured)))]
    name, said = asker.name(body), color(body)
    if said is None or said in name:
        return None
    others = [c for c in asker.shuffled([*shown, "red", "blue", "green", "black", "white"]) if _far(c, said)]
    options = asker.shuffled(list(dict.fromkeys([said, *others]))[:4])
    return Question(
        "color",
        "choice",
        asker.one_of(f"What colour is {name}?", f"Which of these colours is {name}?"),
        said,
        asker.ids(body),
        {"color": said},
        "the colour that the object's attributes give",
        options=tuple(options),
    )


def _far(one: str, other: str) -> bool:
    """Whether two colours are told apart at once."""
    pale = {"white", "cream", "beige", "light grey", "silver", "tan", "gold", "grey"}
    dark = {"black", "brown", "dark brown", "navy", "dark green", "burgundy", "grey"}
    return one != other and not any({one, other} <= group for group in (pale, dark))


def what_is_on(asker: Asker) -> Question | None:
    """What rests on a thing."""
    carriers = [
        (key, things)
        for key, things in asker.facts.carried.items()
        if key[0] in asker.names and 1 <= len(things) <= 8 and len({_surface(t) for t in things}) == 1
    ]
    if not carriers:
        return None
    (carrier, how), things = carriers[int(asker.rng.integers(len(carriers)))]
    body = asker.facts.by_id[carrier]
    name = asker.name(body)
    where = "directly on" if how == "on" else "inside"
    return Question(
        f"what_is_{how}",
        "list",
        asker.one_of(f"What is {where} {name}?", f"List everything that is {where} {name}."),
        _inventory(things),
        (*asker.ids(body), *(t.id for t in things)),
        {"carrier": carrier, "supports": {t.id: _surface(t) for t in things}},
        "the objects whose support is this one, each as its noun",
    )


def _surface(thing: Body) -> str | None:
    return thing.item.support.surface if thing.item.support is not None else None


def _inventory(things: list[Body]) -> list[str]:
    counts = Counter(noun(t.item.category) for t in things)
    return [word for word in sorted(counts) for _ in range(counts[word])]


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
    (thing, carrier), said, support = found
    return Question(
        "is_on",
        "yes_no",
        asker.one_of(
            f"Is {asker.name(thing)} on {asker.name(carrier)}?",
            f"Does {asker.name(thing)} rest on {asker.name(carrier)}?",
        ),
        yes_no(said),
        asker.ids(thing, carrier),
        {"support": support},
        "whether the support of the first object is the second",
    )


def _stands_over(facts: Facts, thing: Body, carrier: Body) -> bool:
    """Whether a carrier holds a thing by way of others."""
    support = thing.item.support
    while support is not None:
        if support.object == carrier.id:
            return True
        support = facts.by_id[support.object].item.support
    return False


TEMPLATES = (how_many, how_many, exists, exists, more_of, what_color, what_is_on, is_on)
