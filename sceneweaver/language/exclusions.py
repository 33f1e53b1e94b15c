"""What must not be there, and that nothing else is to be."""

from __future__ import annotations

from sceneweaver.assets import categories

from .chunks import Chunk, NounPhrase
from .pronouns import Pronouns
from .things import match_of, name_of
from .vocabulary import category_of, words


class Exclusions(Pronouns):
    """What must not be there, and that nothing else is to be."""

    def _without(self, chunk: Chunk) -> None:
        if self.waiting is not None:
            self.waiting = None
        if chunk.value == "nothing":
            self._nothing()
            return
        self.negated = "first"
        self.glue = "neg"

    def _nothing(self) -> None:
        rules = words("groups")["nothing_on"]
        for k, chunk in enumerate(self.chunks[self.at : self.at + 4]):
            if chunk.kind == "noun" and chunk.value.what == "place" and str(chunk.value.value).split(":")[0] in rules:
                named = rules[str(chunk.value.value).split(":")[0]]
                self.out.without += [(name, (name,), self.source.span(chunk.start, chunk.end)) for name in named]
                self.at += k + 1
                return
        if self.at < len(self.chunks) and self.chunks[self.at].text.split()[0] in ("else", "more"):
            self.out.only = True

    def _excluded(self, phrase: NounPhrase, chunk: Chunk) -> bool:
        """Whether a noun phrase is one of what must not be there."""
        glue = self.glue
        if (
            self.negated != "first"
            and glue != "or"
            and (phrase.count is not None or phrase.determiner in ("a", "an", "the", "another"))
            and not (self.negated == "article" and phrase.determiner in ("a", "an") and phrase.count is None)
        ):
            self.negated = ""
            return False
        if phrase.what in ("room",) or (phrase.what == "place" and phrase.value not in ("window", "door")):
            self.negated = ""
            return False
        after = self.chunks[self.at] if self.at < len(self.chunks) else None
        if phrase.definite and after is not None and after.kind == "place" and phrase.what == "thing":
            self.negated = "where"  # "don't put the bed near the door" wants a bed
            self.glue = "start"
            self._np_thing(phrase, chunk)
            return True
        span = self.source.span(phrase.start, phrase.end)
        if phrase.what == "place":
            self.out.openings[str(phrase.value)] = 0
        elif phrase.what == "group":
            for name in words("groups")["groups"][phrase.value]["things"]:
                self.out.without.append((phrase.text, (category_of(name),), span))
        elif phrase.what in ("thing",):
            noun = name_of(phrase)
            listed = words("groups")["without"].get(phrase.text)
            known = categories().get(str(phrase.value))
            match = match_of(noun)
            names = (
                tuple(listed)
                if listed
                else ((phrase.value,) if known is not None and known.size is None else (match.category,))
            )
            if match.how == "generic" and not listed and phrase.value is None:
                self._unread(f"no {noun}", phrase.start, phrase.end)
                self.out.without.append(
                    (noun, (match.category if match.category != "object" else noun.replace(" ", "_"),), span)
                )
            else:
                self.out.without.append((phrase.text, names, span))
        if self.negated == "first":
            self.negated = "article" if phrase.determiner in ("a", "an") else "list"
        self.glue = ""
        return True

    def _only(self, chunk: Chunk) -> None:
        if chunk.value == "all":
            self.out.only = True
            return
        ahead = self.chunks[self.at : self.at + 2]
        self.out.only = self.out.only or any(c.kind == "noun" and c.value.what in ("thing", "group") for c in ahead)
