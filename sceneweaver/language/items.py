"""What a noun phrase is in its clause: the target of a word of place, an item of an open list, or a subject."""

from __future__ import annotations

from typing import Any

from .chunks import Chunk, NounPhrase
from .parsed import Mention, Said
from .relating import Relating
from .state import Frame, Waiting
from .vocabulary import Place, family, mounts


class Items(Relating):
    """What a noun phrase is in its clause: the target of a word of place, an item of an open list, or a subject."""

    def _named(self, mentions: list[Mention], phrase: NounPhrase, chunk: Chunk, new: bool) -> None:
        """Things that were named take their place: target, item of a list, or subject."""
        if self.waiting is not None:
            self._target(mentions, phrase, new)
            return
        glue, self.glue = self.glue, ""
        more = glue in ("and", "or", "comma and") and (not new or (self.done and not self.frames and glue == "and"))
        if more and self.last_target is not None and not self._verb_follows(self.at):
            self._one_more_target(mentions)
            return
        if glue == "open" and self.frames:
            self._item(mentions, phrase)
            return
        if self.inverted and self.frames and self.frames[0].kind == "fronted" and not self._verb_follows(self.at):
            if glue.startswith("comma"):
                self.frames = self.frames[:1]
            self._item(mentions, phrase)
            return
        clause = glue in ("start", "while", "comma", "comma and", "and") and (
            (self.done and self._verb_follows(self.at))
            or (bool(self.frames) and self._verb_follows(self.at) and not self.subject_open)
        )
        if glue in ("start", "while") or clause or not (self.subject or self.frames or self.fronted):
            self._subject(mentions, glue)
            return
        if self.fronted and not (self.frames and glue == ""):
            self._subject(mentions, glue, keep=bool(self.first_items) and self.subject_open and glue in ("and",))
            return
        self._coordinate(mentions, phrase, glue)

    def _subject(self, mentions: list[Mention], glue: str, keep: bool = False) -> None:
        """A new clause, or an item of its own."""
        if self.subject and not keep:
            self.previous = list(self.subject)
            if glue != "start":
                self.refs.topics.append(list(self.subject))
        if glue != "start" or not self.frames:
            self.frames = [f for f in self.frames[:1] if f.kind == "list"]
        self.subject = [*self.subject, *mentions] if keep else list(mentions)
        self.head, self.first_items = list(mentions), [*self.first_items, *mentions]
        self.subject_open, self.lost, self.inverted, self.done, self.last_target = True, False, False, False, None
        self.head_related, self.joined = False, ""
        if self.frames and self.frames[0].kind == "list":
            self.frames[0].items += mentions
        fronted, self.fronted = self.fronted, []
        for place, targets, at in fronted:
            self._relate(place, mentions, targets, at)
            if place.type in ("on", "inside") and isinstance(targets[0], Mention):
                self._stands_on(targets[0], place.words)
        if fronted:
            self.frames.append(Frame("fronted", fronted=fronted, items=list(mentions)))

    def _coordinate(self, mentions: list[Mention], phrase: NounPhrase, glue: str) -> None:
        """One more of a list: with "and" of the innermost, after a comma of the outermost one."""
        self.joined = (
            "and" if glue in ("and", "or", "comma and") and not (glue == "comma and" and self.head_related) else "comma"
        )
        self.last_target = None
        if glue in ("comma", "comma and", "bracket") and self.frames:
            base = self.frames[0]
            if len(self.frames) > 1 and not self._goes_on(mentions, phrase):
                self.frames = self.frames[:1]
            elif (
                base.kind in ("with", "verb")
                and not base.finite
                and self.subject_open
                and self._placed_next(self.at)
                or base.kind == "fronted"
                and not base.finite
                and self._placed_next(self.at)
            ):
                self.frames = []
        elif (
            glue in ("and", "or")
            and self.frames
            and self.frames[-1].kind == "fronted"
            and not self.frames[-1].finite
            and self._placed_next(self.at)
        ):
            self.frames.pop()
        if self.frames:
            self._item(mentions, phrase)
            return
        if self.subject_open:
            self.previous = list(self.subject[-1:])
            if not (glue == "and" and not self.done) and glue.startswith("comma") and self.head_related:
                self.subject = list(mentions)
            else:
                self.subject = [*self.subject, *mentions]
        else:
            self.previous = list(self.subject)
            self.subject, self.subject_open = list(mentions), True
        self.head, self.first_items = list(mentions), [*self.first_items, *mentions]
        self.head_related = False

    def _goes_on(self, mentions: list[Mention], phrase: NounPhrase) -> bool:
        """Whether a comma does not end an inner list: small things after small things that something holds."""
        inner = self.frames[-1]
        small = all(mounts(m.category)[0] == "surface" for m in mentions) and not self._placed_next(self.at)
        held = inner.kind == "verb" and inner.type in ("on", "inside")
        if held and self.frames[0].kind == "list":
            return small and bool(inner.items)
        first = inner.items[:1]
        carrier = (
            inner.kind == "with" and bool(inner.owner) and family(inner.owner[-1].category) in ("table", "storage")
        )
        if carrier and self.frames[0].kind in ("list", "fronted"):
            return small and bool(first) and mounts(first[0].category)[0] == "surface"
        if held and self.frames[0].kind == "with" and phrase.count and small:
            return bool(first and first[0].noun in inner.numbered)
        return bool(
            inner.kind == "with"
            and small
            and phrase.count
            and first
            and first[0].count
            and first[0].noun in inner.numbered
        )

    def _item(self, mentions: list[Mention], phrase: NounPhrase) -> None:
        """What is named in an open list."""
        frame = self.frames[-1]
        if frame.items:
            self.previous = list(frame.items[-1:])
        frame.items += mentions
        if phrase.count is not None:
            frame.numbered += [m.noun for m in mentions]
        self.head, self.glue, self.head_related = list(mentions), "", False
        if frame.kind == "list":
            self.first_items = [*self.first_items, *mentions]
            self.subject = list(mentions)
            if frame.type == "centered":
                frame.type = ""
                self.out.said.append(Said("at", list(mentions), ("middle",), frame.words, implied=False))
        elif frame.kind == "fronted":
            for place, targets, at in frame.fronted:
                self._relate(place, mentions, targets, at)
                if place.type in ("on", "inside") and isinstance(targets[0], Mention):
                    self._stands_on(targets[0], place.words)
            self.subject = [*self.subject, *mentions]
        elif frame.kind == "with":
            self._owned(frame, mentions, phrase)
        else:
            self._placed(frame, mentions)
        if frame.each or phrase.determiner == "each":
            self._for_each(frame.owner, mentions)

    def _for_each(self, owners: list[Mention], mentions: list[Mention]) -> None:
        many = next((o.count for o in owners if o.count is not None), None)
        for mention in mentions:
            if many is not None and mention.count is not None:
                mention.count = (mention.count[0] * many[0], mention.count[1] * many[1])

    def _placed(self, frame: Frame, mentions: list[Mention]) -> None:
        kind = frame.type
        targets = tuple(frame.owner[-1:] if kind != "between" else frame.owner)
        if frame.owner and len(frame.owner) > 1 and kind in ("on", "inside"):
            targets = tuple(frame.owner[:1])
        if not targets:
            return
        if kind == "beside":
            seat = all(family(m.category) == "seat" for m in mentions) and family(frame.owner[0].category) == "table"
            night = len(mentions) == 1 and mentions[0].category == "nightstand" and mentions[0].count == (2, 2)
            kind = "at" if seat else "flanking" if night else "next_to"
        elif kind in ("on", "inside"):
            kind = self.support(kind, frame.owner[0])
        place = Place(kind, words=frame.words, each=frame.each or kind == "flanking")
        self._relate(place, mentions, targets, None, span=self.chunk_span())

    def _target(self, mentions: list[Mention], phrase: NounPhrase, new: bool) -> None:
        """A word of place gets its target."""
        waiting = self.waiting
        assert waiting is not None
        if waiting.place.type == "between" and waiting.first is None and len(mentions) == 1 and not (mentions[0].many):
            waiting.first = mentions[0]
            self.glue = "open"
            return
        self.waiting = None
        if self.each and new and waiting.subjects:
            self._for_each(waiting.subjects, mentions)
        targets: tuple[Any, ...] = tuple(mentions)
        if waiting.place.type == "between":
            targets = (waiting.first, mentions[0]) if waiting.first is not None else (mentions[0], mentions[-1])
        elif waiting.place.type not in ("around",):
            targets = targets[:1] if phrase.what != "pronoun" or len(mentions) == 1 else targets
        each = phrase.determiner in ("each", "every")
        self._bound(waiting, targets, each)
        if waiting.subjects is not None and new and not waiting.lost:
            self.head = list(mentions)
        elif waiting.subjects is None:
            self.head = []
        self.glue = ""
        if waiting.lost and not waiting.subjects:  # "light falls on a bench": the sentence is about the bench
            self.head, self.lost = list(mentions), False
            self.subject = self.subject or list(mentions)
            if self.lit and new:
                self._say(
                    "near", mentions, ("window",), "through the window", None, False, None, self.chunk_span(), True
                )
            self.lit = False
        self.last_target = (waiting, targets) if waiting.place.type not in ("between",) else None

    def _bound(self, waiting: Waiting, targets: tuple[Any, ...], each: bool = False) -> None:
        if waiting.lost and not waiting.subjects:
            return
        if waiting.subjects is None:
            self.fronted.append((waiting.place, targets, waiting.chunk))
            return
        place = waiting.place
        if each:
            place = Place(place.type, place.side, True, place.words)
            target = targets[0]
            if isinstance(target, Mention):
                for subject in waiting.subjects:
                    n = target.count
                    if subject.count is not None and n is not None and waiting.count is None and subject.count != n:
                        subject.count = (subject.count[0] * n[0], subject.count[1] * n[1])
        if len(targets) > 1 and place.type != "between":
            for target in targets:
                self._relate(place, waiting.subjects, (target,), waiting.chunk, count=waiting.count)
        else:
            self._relate(place, waiting.subjects, targets, waiting.chunk, count=waiting.count)

    def _one_more_target(self, mentions: list[Mention]) -> None:
        assert self.last_target is not None
        waiting, _ = self.last_target
        self._bound(
            Waiting(waiting.place, waiting.subjects, waiting.chunk, waiting.count, lost=waiting.lost), tuple(mentions)
        )

    def _continue(self, mentions: list[Mention]) -> None:
        """What follows is about some of what was just named."""
        self.head = list(mentions)
        if self._verb_follows(self.at) or self.glue in ("start", "while"):
            self.subject, self.subject_open, self.frames = (
                list(mentions),
                True,
                [f for f in self.frames[:1] if f.kind == "list"],
            )
        self.glue = ""

    def _nobody(self) -> None:
        """What was named is no object, so that what is said of it is said of nothing."""
        if self.frames and self.glue == "open":
            self.head = []
        elif self.glue in ("start", "while", "comma", "comma and", "and"):
            self.head = []
            if self.glue in ("start", "while") or self._verb_follows(self.at):
                self.subject, self.fronted = [], []
        self.lost = True
        self.glue = ""

    def _stands_on(self, surface: Mention, words: str) -> None:
        """The small things that come after it in the sentence stand there."""
        if self.surface is not surface:
            self._on_the_same(last=True)
        self.surface, self.surface_words = surface, words

    def _on_the_same(self, last: bool = False) -> None:
        """ "On the desk, a lamp is beside a book, and a mug ...": small things of the sentence stand there as well."""
        surface, self.surface = self.surface, None
        started, self.started = self.started, len(self.out.mentions)
        if surface is None:
            return
        held = {
            id(m)
            for s in self.out.said
            for m in s.subjects
            if s.type in ("on", "inside") or isinstance(s.targets[0], str)
        }
        for mention in self.out.mentions[started : -1 if last else None]:
            if id(mention) not in held and mention is not surface and "surface" in mounts(mention.category):
                self.out.said.append(
                    Said("on", [mention], (surface,), self.surface_words, implied=True, span=mention.span)
                )
