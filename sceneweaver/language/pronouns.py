"""Phrases that refer to what was named: it, them, one, the other, each, two of them."""

from __future__ import annotations

from .chunks import Chunk, NounPhrase
from .parsed import Mention
from .region_phrases import RegionPhrases
from .vocabulary import mounts


class Pronouns(RegionPhrases):
    """Phrases that refer to what was named: it, them, one, the other, each, two of them."""

    def _np_number(self, phrase: NounPhrase, chunk: Chunk) -> None:
        """A number alone: "four on each side", "a table for six", "two of them"."""
        before = self.chunks[self.at - 2] if self.at >= 2 else None
        if before is not None and before.kind == "purpose" and before.value == "people":
            self.out.people = (phrase.count or (1, 1))[1]
            self.glue = ""
            return
        after = self.chunks[self.at] if self.at < len(self.chunks) else None
        near = self.head or self.subject or self.previous
        group = self.refs.several(near)
        count = phrase.count or (1, 1)
        if group is None:
            if after is None or after.kind != "stop":
                self._unread(chunk.text, chunk.start, chunk.end)
            return
        if after is not None and after.kind == "place" and after.value.each:
            self.subset, self.head, self.glue = count, [group], ""
            self.subject = self.subject or [group]
            return
        part = self.refs.part(near, count[1])
        if part is not None:
            self._continue([part])

    def _np_pronoun(self, phrase: NounPhrase, chunk: Chunk) -> None:
        kind = phrase.value
        without = (self.waiting.subjects or []) if self.waiting is not None else []
        near = self._near(without) if self.waiting is not None else (self.head or self.subject or self.previous)
        if kind in ("partial", "rest"):
            after = self.chunks[self.at] if self.at < len(self.chunks) else None
            if kind == "partial" and after is not None and after.kind == "place" and after.value.each:
                group = self.refs.several(near)
                if group is not None:
                    self.subset, self.head, self.glue = (1, 1), [group], ""
                    self.subject = self.subject or [group]
                return
            if phrase.text.startswith("another") and self.refs.rest is not None:
                found: Mention | None = self.refs.rest
            else:
                found = self.refs.part(near) if kind == "partial" else self.refs.rest
            if found is None and kind == "partial":
                found = self._one_more(near)
            if found is None:
                self._unread(phrase.text, chunk.start, chunk.end)
                return
            if self.waiting is not None:
                self._target([found], phrase, False)
            elif self.glue == "open":
                self._named([found], phrase, chunk, False)
            else:
                self._continue([found])
            return
        if kind == "each" and self.waiting is None:
            group = self.refs.several(near)
            if group is not None:
                self.head, self.each, self.glue = [group], True, ""
                self.subject = [group]
                self.subject_open, self.frames = True, [f for f in self.frames[:1] if f.kind == "list"]
            return
        if (
            self.waiting is not None
            and phrase.text == "it"
            and self.previous
            and self.waiting.place.type in ("next_to", "left_of", "right_of", "near", "in_front_of", "behind")
        ):
            small = [*without, self.previous[-1]]
            if without and all(mounts(m.category)[0] == "surface" for m in small) and self.previous[-1] not in without:
                near = self.previous[-1:]  # a lamp beside "it" is beside the laptop, not beside the desk
        found_all = self.refs.pronoun(phrase, near if self.waiting is not None else self.subject, without)
        if self.waiting is not None:
            if not found_all and phrase.text == "it" and len(without) > 1:
                found_all = without[:1]  # "a fireplace and bookshelves on either side of it"
            if found_all:
                self._target(found_all, phrase, False)
            elif phrase.text == "it" and self._window_before():
                waiting, self.waiting = self.waiting, None
                self._at_place(
                    waiting.place.type, without, "window", waiting.place.words, None, self.chunk_span(), False
                )
                self.glue = ""
            else:
                self.waiting = None
            return
        if phrase.text in ("which", "itself", "themselves"):
            return
        if found_all:
            topic = found_all
            self._subject(topic, self.glue)
            self.glue = ""

    def _window_before(self) -> bool:
        """Whether the sentence named a window: "light falls through a window onto a desk beneath it"."""
        for chunk in reversed(self.chunks[: self.at - 1]):
            if chunk.kind == "stop":
                return False
            if chunk.kind == "noun" and chunk.value.what == "place" and chunk.value.value == "window":
                return True
        return False

    def _one_more(self, near: list[Mention]) -> Mention | None:
        """ "Another stands to the right": one more of what was named last."""
        for mention in [*reversed(near), *reversed(self.out.mentions[-3:])]:
            if mention.count == (1, 1):
                more = Mention(
                    mention.noun,
                    mention.category,
                    (1, 1),
                    mention.generic,
                    mention.color,
                    mention.material,
                    mention.style,
                )
                more.attributes, more.span = list(mention.attributes), self.chunk_span()
                self.out.mentions.append(more)
                return more
        return None
