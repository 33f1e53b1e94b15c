"""What words refer to: "the table", "it", "them", "the other", "its top"."""

from __future__ import annotations

from collections.abc import Callable

from sceneweaver.assets.taxonomy import category_named

from .carrying import is_board
from .chunks import NounPhrase
from .parsed import Mention, Parsed
from .parsed import without as apart
from .things import match_of, name_of, singular
from .tokens import Token
from .vocabulary import words

REACH = 60
"""Mentions that are looked through for what a word refers to."""


TOPICS = 3
"""Sentences back to which "it" and "them" may refer."""


class References:
    """The mentions so far, and which of them a word means."""

    def __init__(self, parsed: Parsed):
        self.parsed = parsed
        self.topics: list[list[Mention]] = []  # what the last sentences were about, the last one last
        self.rest: Mention | None = None  # what "the other" is

    def tell_of(self, topic: list[Mention]) -> None:
        """A sentence or clause ends that was about some things."""
        self.topics = [*self.topics[-TOPICS + 1 :], list(topic)]

    def _recent(self) -> list[Mention]:
        return self.parsed.mentions[: -REACH - 1 : -1]

    def known(self, phrase: NounPhrase, target: bool, without: list[Mention]) -> Mention | None:
        """What was named before and is meant again; None when it is another one."""
        if not phrase.definite and not (target and (phrase.count in (None, (1, 1)))):
            return self._said_again(phrase, without)
        if phrase.determiner == "another":
            kin = [m for m in self._recent() if m.many and singular(m.noun).endswith(singular(phrase.text))]
            return kin[0] if kin and target else None
        noun = name_of(phrase)
        qualities = {t.text for t in phrase.qualities if t.has("color", "material", "scale", "shape", "styles")}
        category = match_of(noun).category
        fitting = [m for m in apart(self._recent(), without) if _may_be(m, phrase, qualities)]
        head, whole = singular(phrase.text), singular(noun)
        if not phrase.definite:  # "a lamp on a nightstand" after "two nightstands"
            every = phrase.determiner in ("each", "every")  # "every bench" after "five island benches"
            alike = (m for m in fitting if m.category == category or (every and m.many))
            return next((m for m in alike if singular(m.noun).endswith(head)), None)
        last = head.split()[-1]
        kinds = words("nouns")["kinds"].get(head, ())
        tests: tuple[Callable[[Mention, str], bool], ...] = (  # the first that any passes tells
            lambda m, name: name == whole,
            lambda m, name: name.split(" of ")[0].endswith((head, whole)),
            lambda m, name: m.category == category and not m.generic,
            lambda m, name: " " in head and name.split(" of ")[0].endswith(last),
            lambda m, name: head in name.split() or name == last,
            lambda m, name: m.category in kinds or m.category.rpartition("_")[2] == last,
        )
        found = (([m for m in fitting if any(test(m, name) for name in _names(m))]) for test in tests)
        meant = next((group for group in found if group), [])
        ranks = words("nouns")["usual"].get(last, ()) if whole in (head, last) else ()
        meant.sort(key=lambda m: next((k for k, names in enumerate(ranks) if m.category in names), len(ranks)))
        clear = [m for m in meant if qualities and qualities <= _described(m)]
        return next(iter(clear or meant), None)

    def _said_again(self, phrase: NounPhrase, without: list[Mention]) -> Mention | None:
        """A noun without article that was named as where something is: "a map over the desk, desk wide enough"."""
        if phrase.determiner or phrase.count is not None or phrase.plural or phrase.qualities:
            return None
        noun = singular(phrase.text)
        targets = {t for said in self.parsed.said[-8:] for t in said.targets if isinstance(t, Mention)}
        for mention in apart(self._recent()[:12], without):
            if mention in targets and mention.count is None and singular(mention.noun) == noun:
                return mention
        return None

    def pronoun(self, phrase: NounPhrase, near: list[Mention], without: list[Mention]) -> list[Mention]:
        """Who "it", "them", "both" are; ``near`` is what stands closest in the sentence."""
        if phrase.text in ("the former", "the latter"):
            two = self.last(2, without if phrase.text == "the former" else [])
            return two[:1] if phrase.text == "the former" else two[-1:]
        several = phrase.text in ("them", "they", "these", "those", "themselves") or phrase.value in ("both", "each")
        for group in (near, *reversed(self.topics), *([m] for m in self._recent()[:8])):
            group = apart(group, without)
            if not group:
                continue
            if several and len(group) == 1 and not group[0].many:
                continue
            alone = len(group) == 1 and group[0].many and not is_board(group[0])
            if not several and phrase.text == "it" and alone:
                continue
            return group if several else group[-1:] if len(group) > 1 and phrase.text != "which" else group
        if several:  # "a shelf next to a desk, a sofa facing them"
            two = apart(self._recent()[:4], without)[:2]
            return two[::-1] or near
        return []

    def several(self, near: list[Mention]) -> Mention | None:
        """The last group of several, of which "one" may be said."""
        for mention in [*reversed(near), *self._recent()[:10]]:
            if mention.many:
                return mention
        return None

    def part(self, near: list[Mention], count: int = 1) -> Mention | None:
        """ "One of them": it is parted from the last group, and "the other" is what is left."""
        group = self.several(near)
        if group is not None and self.rest is not None and group not in self.parsed.mentions:
            group = self.rest  # it was parted before: what is left of it
        if group is None or group.count is None or not count < group.count[1] <= 40 or group.count[0] <= count:
            return group
        if group not in self.parsed.mentions:
            return group  # places that are no things
        parted, self.rest = self.parsed.split(group, count)
        for topic in self.topics:
            topic[:] = [p for m in topic for p in ([parted, self.rest] if m is group else [m])]
        return parted

    def in_row(self, spoken: list[str], group: Mention | None) -> tuple[Mention, int] | None:
        """Things of which one is meant by its place among them, and which one: "on the third of eight lockers"; None
        where they are too few for that, or one of them was parted from the others before."""
        table = words("said_again")
        group = group.per if group is not None and group.per is not None else group  # "a towel on each, the third ..."
        if group is None or group.count is None or not spoken or spoken[0] not in table["nth"] or self.rest is not None:
            return None
        least, most = group.count
        nth = table["nth"][spoken[0]]
        if nth == 0:
            nth = (least + 1) // 2 if least == most and least % 2 else 0
        return (group, nth) if least >= table["row"] and 0 != nth <= least else None

    def by_quality(self, qualities: list[Token], without: list[Mention]) -> Mention | None:
        """ "The larger one", "the white one": of things of one kind, the one of which that is said."""
        recent = apart(self._recent()[:12], without)
        kin = [m for m in recent if sum(singular(m.noun) == singular(o.noun) for o in recent) > 1]
        for token in qualities:
            if any(m for m in kin if token.text in _described(m)):
                return next(m for m in kin if token.text in _described(m))
            if token.has("scale") and len({m.scale for m in kin}) > 1:
                wanted = token.get("scale")
                return max(kin, key=lambda m: m.scale if wanted >= 1.0 else -m.scale)
        return None

    def last(self, count: int, without: list[Mention]) -> list[Mention]:
        """So many things that were named last: "between the two"; a group of so many is these."""
        recent = apart(self._recent()[:8], without)
        for mention in recent[:3]:
            if mention.count == (count, count):
                return [mention]
        single = [m for m in recent if m.count in (None, (1, 1)) and not m.many and not m.is_rug][:count]
        return single[::-1] if len(single) == count else []

    def carrier(self, near: list[Mention], without: list[Mention], kind: str = "top", word: str = "") -> Mention | None:
        """Whose top, shelf or side is meant where nobody is named."""
        choices = [*reversed(near), *(m for t in reversed(self.topics) for m in t), *self._recent()[:20]]
        held = bool(near) and near[-1].family in ("table", "storage")
        if word.endswith("top") and word != "top" and not held and self.parsed.said:
            last = [t for t in self.parsed.said[-1].targets if isinstance(t, Mention) and t.family == "table"]
            choices = [*last, *choices]  # "a lamp hangs above the table. On the tabletop ..."
        choices = apart(choices, without)
        for noun in words("nouns")["carriers"].get(word, ()):
            for mention in choices:
                if singular(mention.noun).split(" of ")[0].endswith(noun):
                    return mention
        tops = [m for m in choices if m.family in ("table", "storage")]
        if kind != "top" or tops:
            return next(iter(tops if kind == "top" else choices), None)
        floor = (m for m in choices if category_named(m.category).holds or "floor" in category_named(m.category).mount)
        return next(floor, None)


def _names(mention: Mention) -> list[str]:
    """The nouns by which the request calls a mention, in the singular."""
    return [singular(noun) for noun in (mention.noun, *mention.also)]


def _described(mention: Mention) -> set[str]:
    """What was said of a mention, and each word of it: a glass topped table is the glass table."""
    return {word for a in mention.attributes for word in (a.words, *a.words.split())}


def _may_be(mention: Mention, phrase: NounPhrase, qualities: set[str]) -> bool:
    """Whether nothing that a phrase says speaks against a mention: its words of quality, its number."""
    described = _described(mention)
    new = bool(qualities) and not qualities <= described
    if new and (not phrase.definite or described & _opposed(qualities, mention)):
        return False
    return phrase.count is None or mention.count is None or phrase.count[1] <= mention.count[1]


def _opposed(qualities: set[str], mention: Mention) -> set[str]:
    """Words said of a mention that a phrase with other words cannot mean."""
    kinds = {a.kind for a in mention.attributes}
    colors = {a.words for a in mention.attributes if a.kind in ("color", "material")}
    return colors if "color" in kinds and not colors & qualities else set()
