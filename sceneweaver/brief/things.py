"""Noun phrases: things, how many and of what kind, and parts of a room that stand for several things."""

from __future__ import annotations

from typing import Any

from sceneweaver.assets import categories

from .lexer import Token
from .reading import SMALL, Mention, Pending, Said
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
                    return True
                if ahead.has("noun") and f"{token.text} {ahead.text}":
                    self.pending.tokens.append(token)
                    return True
        else:
            n = int(token.get("number"))
            bound, high = self.pending.bound, 400
            count = {"least": (n, max(n, min(high, n + 4))), "above": (n + 1, n + 5), "most": (min(1, n), n),
                     "below": (min(1, n), max(0, n - 1)), None: (n, n)}[bound]  # fmt: skip
        before = self.tokens[self.at - 2].text if self.at >= 2 else ""
        ahead = self._ahead(1)
        if before == "for" and (not ahead or ahead[0].has("break", "with", "relation", "and")):
            self.out.people = count[1]  # "an office for two"
            return True
        self._leftover()
        self.pending = Pending(count=count, any=True, definite=self.pending.definite)
        return True

    def _negation_over(self) -> bool:
        """Whether a new phrase begins: "no TV, and a desk" wants a desk, "without a TV or a desk" does not."""
        back = [t.text for t in reversed(self.tokens[max(0, self.at - 7) : self.at - 1])]
        return back[:1] != ["or"] and ("," in back[:2] or (back[:1] == ["and"] and "no" in back))

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
            self._connect(self._known(category) or self._made(token.text, category))
            self.pending, self.negated = Pending(), True
            return
        if self.negated:
            words = groups()["without"].get(token.text)
            self.out.without += words or [name if categories()[name].size is None else category]
            self.pending, self.joined = Pending(), False
            return
        mention = self._known(category) if self.pending.definite or self.relation is not None else None
        fresh = mention is None or self.pending.count is not None or any(
            t.has("color", "material") for t in self.pending.tokens
        )  # fmt: skip
        if mention is None or fresh:
            mention = self._made(token.text, category)
        self._for_modifiers(mention)
        self.pending = Pending()
        self._connect(mention)

    def _made(self, noun: str, category: str) -> Mention:
        count = self.pending.count
        if count is None and self.pending.any and not self.pending.definite:
            count = (1, 1)
        mention = Mention(noun, category, count)
        self.out.mentions.append(mention)
        return mention

    def _for_modifiers(self, mention: Mention) -> None:
        for word in self.pending.tokens:
            if word.has("color"):
                mention.color = word.get("color")
            elif word.has("material"):
                mention.material = word.get("material")
            elif word.has("finish"):
                mention.words.append(word.text)
            elif word.has("scale"):
                mention.scale = float(word.get("scale"))
            elif word.has("styles"):
                mention.style = word.get("styles")
            elif not word.has("moods", "dim", "density"):
                mention.words.append(word.text)
        if self.pending.length is not None:
            axis = next((t.get("dim") for t in self.pending.tokens if t.has("dim")), None)
            if axis is not None:
                mention.size[int(axis)] = self.pending.length
                mention.scale = 1.0

    def _connect(self, mention: Mention) -> None:
        """A noun ends a relation as its target, or begins a new phrase."""
        joined, self.joined = self.joined, False
        if self.relation is not None:
            kind, subjects, words = self.relation
            if kind == "between" and self.first_of_pair is None:
                self.first_of_pair = mention
                if mention.count is not None and mention.count[0] >= 2:
                    self._relate(kind, (mention, mention), subjects, words)
                return
            target: Any = (self.first_of_pair, mention) if kind == "between" else mention
            if self.at >= 2 and self.tokens[self.at - 2].has("each") and mention.count is not None:
                for subject in subjects:  # "four chairs around each table"
                    low, high = subject.count or (1, 1)
                    subject.count = (low * mention.count[0], high * mention.count[1])
            for subject in subjects if kind in ("on", "inside") else ():
                subject.category = SMALL.get(subject.category, subject.category)
            self._relate(kind, target, subjects, words)
            self.last = [mention]
            return
        if self.before_used and not joined:  # "on the desk a lamp and a book": both; a new phrase is free of it
            self.before = []
        for kind, target, words in self.before:
            self.out.said.append(Said(kind, [mention], target, words))
        self.before_used = bool(self.before)
        if self.owner is not None and self.owner is not mention:
            self._owned(self.owner, mention)
        if joined and self.last and not any(mention is m for m in self.last):
            self.subjects = [*self.subjects, mention]
            self.last = [*self.last, mention]
        else:
            self.subjects, self.last = [mention], [mention]

    def _owned(self, owner: Mention, mention: Mention) -> None:
        """ "A desk with a lamp": what is small stands on what it came with, the rest is near it."""
        known = categories()
        small = known[mention.category].mount[0] == "surface"
        if small and known[owner.category].mount[0] == "floor":
            self.out.said.append(Said("on", [mention], owner, f"{owner.noun} with {mention.noun}"))
        elif known[mention.category].mount[0] == "floor" and known[owner.category].mount[0] == "floor":
            self.out.said.append(Said("near", [mention], owner, f"{owner.noun} with {mention.noun}"))
        many = owner.count
        if self._each and many is not None and mention.count is not None:
            mention.count = (mention.count[0] * many[0], mention.count[1] * many[1])

    @property
    def _each(self) -> bool:
        return any(t.has("each") for t in self.tokens[max(0, self.at - 6) : self.at])

    def _group(self, token: Token) -> None:
        """A part of the room ("reading corner") stands for its things."""
        row = groups()["groups"][token.get("group")]
        negated, self.negated = self.negated, False
        if negated:
            self.out.without += [category_of(name) for name in row["things"]]
            self.pending = Pending()
            return
        made = []
        for name, (low, high) in row["things"].items():
            category = category_of(name)
            mention = self._known(category) or Mention(name.replace("_", " "), category, (low, high))
            if mention not in self.out.mentions:
                self.out.mentions.append(mention)
            made.append(mention)
        for mention in made[1:]:
            self.out.said.append(Said("near", [mention], made[0], token.text))
        names = ", ".join(m.noun for m in made)
        self.out.notes.append(f"'{token.text}' was taken for: {names}")
        self.pending, self.joined, self.relation = Pending(), False, None
        for kind, target, words in self.before:
            self.out.said.append(Said(kind, made[:1], target, words))
        self.before = []
        self.subjects, self.last = made[:1], made[:1]
