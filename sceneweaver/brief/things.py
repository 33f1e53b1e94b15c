"""Noun phrases: things, how many and of what kind, and parts of a room that stand for several things."""

from __future__ import annotations

from typing import Any

from sceneweaver.assets import categories
from sceneweaver.assets.taxonomy import likeliness

from .lexer import Token
from .parser_state import SMALL, Mention, ParsedRelation, PendingModifiers
from .relating import Relating
from .tables import category_of, groups


class Things(Relating):
    """Reads nouns."""

    def _counted(self, token: Token) -> bool:
        if token.has("amount"):
            count = token.get("amount")
            if token.text in ("twin", "double", "single") and self.at < len(self.tokens):
                ahead = self.tokens[self.at]
                if ahead.has("room") or ahead.text == "room":
                    self.out.people = 1 if token.text == "single" else 2  # "a twin room"
                    if ahead.text == "room" and self.out.room_type is None:
                        self.out.room_type, self.out.room_words = "bedroom", f"{token.text} room"
                        self._note(f"'{token.text} room' was taken for a bedroom")
                    return True
                if ahead.has("noun") and token.text != "single":
                    self.pending.tokens.append(token)
                    return True
        else:
            n = int(token.get("number"))
            bound, high = self.pending.bound, 400
            count = {
                "least": (n, max(n, min(high, n + 4))),
                "above": (n + 1, n + 5),
                "most": (min(1, n), n),
                "below": (min(1, n), max(0, n - 1)),
                None: (n, n),
            }[bound]
        before = self.tokens[self.at - 2].text if self.at >= 2 else ""
        ahead = self._ahead(1)
        if before == "for" and (not ahead or ahead[0].has("break", "with", "relation", "and")):
            self.out.people = count[1]  # "an office for two"
            return True
        if self.negated and self._negation_over():
            self.negated = False
        definite = self.pending.definite
        self._leftover()
        self.pending = PendingModifiers(count=count, any=True, definite=definite)
        if len(ahead) > 0 and ahead[0].text == "of" and [t.text for t in self._ahead(2)[1:]] in (["them"], ["these"]):
            self.out.unread.append(f"{token.text} of them")
        return True

    def _negation_over(self) -> bool:
        """Whether a new phrase begins: "no TV, a desk" wants a desk, "without a TV or a desk" does not."""
        before = self.tokens[self.at - 2]
        return (
            self.negated_nouns > 0
            and not self.negated_article
            and before.text != "or"
            and before.has("break", "and", "verb")
        )

    def _is_noun(self, token: Token) -> bool:
        ahead = self.tokens[self.at] if self.at < len(self.tokens) else None
        if token.has("color", "material") and ahead is not None and ahead.has("noun"):
            self.pending.tokens.append(token)
            return False
        return not (token.has("stop", "verb") and self.pending.empty and self.relation is None and not self.joined)

    def _noun(self, token: Token) -> None:
        name = token.get("noun")
        category = category_of(name)
        if name in ("furniture", "object"):  # "white furniture" is about the whole room
            self._leftover()
            self.negated = False
            return
        if self.negated and self.pending.definite and any(t.has("relation") for t in self._ahead(1)):
            self.negated = False  # "don't put the bed near the door" wants a bed
            self._connect(self._known(token.text, category) or self._made(token.text, category))
            self.pending, self.negated = PendingModifiers(), True
            return
        if self.negated:
            self.negated_article = self.negated_article or (self.negated_nouns == 0 and self.pending.article)
            self.negated_nouns += 1
            words = groups()["without"].get(token.text)
            self.out.without += words or [name if categories()[name].size is None else category]
            self.pending, self.joined = PendingModifiers(), False
            return
        mention = self._implied(token.text, category) or self._known(token.text, category)
        if mention is None:
            mention = self._made(token.text, category)
        self._describe(mention)
        self.pending, self.predicate, self.opening = PendingModifiers(), [], False
        self._connect(mention)

    def _known(self, noun: str, category: str) -> Mention | None:
        """What was named before and is meant again; None when it is another one."""
        pending = self.pending
        if not pending.definite and (self.relation is None or pending.count is not None):
            return None
        colors = {t.get("color") for t in pending.tokens if t.has("color")}
        materials = {t.get("material") for t in pending.tokens if t.has("material")}
        if not pending.definite and (colors or materials):
            return None
        taken = self.relation.subjects if self.relation is not None and not pending.definite else []

        def same(m: Mention) -> bool:
            return (
                m not in taken
                and (pending.count is None or m.count is None or pending.count == m.count)
                and (not colors or m.color in colors or m.color is None)
                and (not materials or m.material in materials or m.material is None)
            )

        fitting = [m for m in reversed(self.out.mentions) if same(m)]
        exact = [m for m in fitting if m.category == category]
        if not exact and pending.definite:  # "the table" after "a round coffee table"
            exact = [m for m in fitting if singular(m.noun).endswith(singular(noun))]
        clear = [m for m in exact if (m.color in colors if colors else True)]
        found = next(iter(clear or exact), None)
        if found is not None and found.count is None:
            found.count = pending.count
        return found

    def _implied(self, noun: str, category: str) -> Mention | None:
        """What a "dining area" called for, when the request now says what it is to be."""
        head = singular(noun).split()[-1]
        for mention in (m for m in reversed(self.out.mentions) if m.implied):
            if mention.category == category or singular(mention.noun).split()[-1] == head:
                if singular(noun) != head:
                    mention.noun, mention.category = noun, category
                if self.pending.count is not None:
                    mention.count = self.pending.count
                mention.implied = False
                return mention
        return None

    def _made(self, noun: str, category: str) -> Mention:
        count = self.pending.count
        if count is None and self.pending.any and not self.pending.definite:
            count = (1, 1)
        mention = Mention(noun, category, count)
        self.out.mentions.append(mention)
        return mention

    def _connect(self, mention: Mention) -> None:
        """A noun ends a relation as its target, or begins a new phrase."""
        joined, self.joined = self.joined, False
        if self.relation is not None:
            kind, subjects, words = self.relation.kind, self.relation.subjects, self.relation.words
            if kind == "between" and self.first_of_pair is None:
                self.first_of_pair = mention
                if mention.count is not None and mention.count[0] >= 2:
                    self._relate(kind, (mention, mention), subjects, words)
                return
            target: Any = (self.first_of_pair, mention) if kind == "between" else mention
            every = self.at >= 2 and self.tokens[self.at - 2].has("each") and mention.count is not None
            self._relate(kind, target, subjects, words)
            said = self.out.said[-1] if self.out.said else None
            for subject in said.subjects if said is not None and said.target is mention else ():
                if every and mention.count is not None:  # "four chairs around each table"
                    low, high = subject.count or (1, 1)
                    subject.count = (low * mention.count[0], high * mention.count[1])
                if kind in ("on", "inside"):
                    subject.category = SMALL.get(subject.category, subject.category)
            self.last = [mention]
            return
        if self.before_used and not joined:  # "on the desk a lamp and a book": both; a new phrase is free of it
            self.before = []
        for kind, target, words in self.before:
            self.out.said.append(ParsedRelation(kind, [mention], target, words))
        self.before_used = bool(self.before)
        if self.owner is not None and self.owner is not mention:
            self._owned(self.owner, mention, joined)
        if joined and self.last and not self.closed and not any(mention is m for m in self.last):
            self.subjects = [*self.subjects, mention]
            self.last = [*self.last, mention]
        else:
            self.subjects, self.last = [mention], [mention]
        self.closed = False

    def _owned(self, owner: Mention, mention: Mention, joined: bool) -> None:
        """ "A desk with a lamp": what is small stands on what it came with, the rest is near it."""
        known = categories()
        small = known[mention.category].mount[0] == "surface"
        if small and owner in self.party:  # of a reading corner's things books stand in the bookcase
            ranks = [(r, m) for m in self.party if (r := likeliness(mention.category, m.category)) is not None]
            if not ranks:
                return
            owner = min(ranks, key=lambda pair: pair[0])[1]
        if small and known[owner.category].mount[0] == "floor":
            self.out.said.append(ParsedRelation("on", [mention], owner, f"{owner.noun} with {mention.noun}"))
        elif not joined and known[mention.category].mount[0] == "floor" and known[owner.category].mount[0] == "floor":
            self.out.said.append(ParsedRelation("near", [mention], owner, f"{owner.noun} with {mention.noun}"))
        many = owner.count
        if self._each and many is not None and mention.count is not None:
            mention.count = (mention.count[0] * many[0], mention.count[1] * many[1])

    def _group(self, token: Token) -> None:
        """A part of the room ("reading corner") stands for its things."""
        row = groups()["groups"][token.get("group")]
        negated, self.negated = self.negated, False
        if negated:
            self.out.without += [category_of(name) for name in row["things"]]
            self.negated_nouns += 1
            self.pending = PendingModifiers()
            return
        made = []
        least, most = self.pending.count or (1, 1)
        for name, (low, high) in row["things"].items():
            category = category_of(name)
            mention = next((m for m in self.out.mentions if m.category == category and not m.implied), None)
            if mention is not None and mention.count is not None and mention.count[1] > high:
                continue  # a library of bookcases has one for its reading corner
            if mention is None:
                mention = Mention(name.replace("_", " "), category, (low * least, high * most), implied=True)
                self.out.mentions.append(mention)
            made.append(mention)
        for mention in made[1:]:
            self.out.said.append(ParsedRelation("near", [mention], made[0], token.text))
        names = ", ".join(m.noun for m in made)
        self.out.notes.append(f"'{token.text}' was taken for: {names}")
        self.pending, self.joined, self.relation = PendingModifiers(), False, None
        for kind, target, words in self.before:
            self.out.said.append(ParsedRelation(kind, made[:1], target, words))
        self.before, self.closed, self.opening = [], False, False
        self.subjects, self.last, self.party = made[:1], made[:1], made


def singular(noun: str) -> str:
    """A noun without the ending of its plural; good enough for comparing nouns with each other."""
    for ending, plain in (("shelves", "shelf"), ("ies", "y"), ("ches", "ch"), ("shes", "sh"), ("ss", "ss"), ("s", "")):
        if noun.endswith(ending):
            return noun[: len(noun) - len(ending)] + plain
    return noun
