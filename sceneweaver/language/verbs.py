"""Verbs and "with": the lists that they open, and who they are about."""

from __future__ import annotations

from .chunks import Chunk
from .exclusions import Exclusions
from .parsed import Mention
from .state import Frame, Waiting
from .vocabulary import Place, Verb, frame, shows


class Verbs(Exclusions):
    """Verbs and "with": the lists that they open, and who they are about."""

    def _open_ends(self) -> None:
        """A word of place without a target is said of what is near, or is noted."""
        waiting, self.waiting = self.waiting, None
        if waiting is None or waiting.lost or waiting.first is not None:
            return
        if waiting.place.words not in (
            "in",
            "on",
            "at",
            "by",
            "over",
            "under",
            "around",
            "from",
            "before",
            "about",
            "to",
            "up to",
            "all",
            "next",
            "across",
        ):
            self.out.note(f"'{waiting.place.words}': it is not clear of what; it was left out")

    def _with(self, chunk: Chunk) -> None:
        self.negated = ""
        if self.waiting is not None:
            self._open_ends()
        owner = self.head if self.glue in ("", "and") else (self.subject or self.first_items)[-1:]
        if self.each and self.subject:
            owner = self.subject
        if not owner or self.lost:
            owner = [] if not self.previous else owner
        if self.glue == "start" and not self.out.mentions:
            owner = []
        if not owner and self.glue in ("comma", "comma and", "while") and self.refs.topics and self.out.mentions:
            owner = []
        if owner:
            self.frames.append(Frame("with", list(owner), words=chunk.text, each=self.each))
            if chunk.text in ("full of", "filled with"):
                self.frames[-1] = Frame("verb", list(owner), "inside", "after", chunk.text)
        elif not self.frames:
            self.frames.append(Frame("list"))
        self.glue, self.subject_open = "open", self.subject_open
        self.manner = ""

    def _verb(self, chunk: Chunk) -> None:
        verb: Verb = chunk.value
        if self.relative and self.head:
            self.relative = False
            if verb.lemma == "be":
                return
            verb = Verb(verb.lemma, "ing" if not chunk.passive else "ed")
        finite = verb.form in ("s", "base") or (verb.form == "ed" and chunk.passive and self.after_be)
        after_be, self.after_be = self.after_be, False
        if self.negated and verb.form in ("base", "s") and self.glue != "":
            self.negated = ""
        if verb.lemma == "be" and verb.form in ("s", "base"):
            self.after_be = True
            self._finite(chunk)
            if self.negated:
                self.negated = ""
            self.predicate = list(self.subject)
            return
        if chunk.passive and verb.lemma in ("be",):
            return
        if verb.form == "ed" and self._noun_next() and self.head and frame(verb) is not None and not chunk.passive:
            verb = Verb(verb.lemma, "s")  # "three cabinets lined the walls"
            finite = self.glue == ""
        if verb.lemma in ("center", "centre", "anchor", "focus") and not self.subject and not self.frames:
            after = self._chunk(self.at)
            if (
                after is not None
                and after.kind == "place"
                and after.value.type in ("around", "on", "centered_on", "near", "above")
            ):
                self.at += 1  # "a room centered around a desk"
            if self._noun_next():
                self.frames.append(Frame("list", type="centered" if verb.lemma != "anchor" else "", words=chunk.text))
                self.glue, self.lost = "open", False
                return
        together = self.glue.startswith(("and", "comma")) and self.frames and self.frames[-1].kind == "verb"
        if together and not finite and not self.frames[-1].finite and self.glue == "and":
            self.head = list(self.frames.pop().owner)  # "holding a vase and flanked by chairs"
        voices = frame(verb)
        if verb.form in ("s", "base") and not (chunk.passive):
            self._finite(chunk)
        owner = (
            self.subject
            if (finite or after_be)
            else self.head
            if self.glue not in ("comma", "comma and")
            else (self.subject if self.done else self.head or self.subject)
        )
        if verb.lemma == "drape" and not chunk.passive:
            self.manner = "drape"
        if (
            verb.lemma in ("hang", "suspend", "lean", "prop", "mount", "center", "centre", "hook")
            and voices is not None
            and not chunk.passive
        ):
            self.manner = {"suspend": "hang", "prop": "lean", "centre": "center", "hook": "mount"}.get(
                verb.lemma, verb.lemma
            )
            if self.manner == "center" and self._place_or_nothing(chunk, owner):
                self.manner = ""
            self.glue = "verb" if finite else ""
            self.placing = owner
            return
        if (
            voices is None
            or (chunk.passive and not {"by", "with"} & voices.keys())
            or (not chunk.passive and "active" not in voices)
        ):
            if shows(verb.lemma) and verb.form != "ed":
                self._shows(chunk, owner)
            elif verb.form == "ed" and verb.lemma == "pair":
                self._open(Frame("with", owner, words=chunk.text), after_be)
            self.glue = "verb" if finite or after_be else ""
            self.placing = owner
            return
        if verb.form == "ed" and not chunk.passive:
            self.glue, self.placing = ("verb" if after_be else ""), owner
            return
        if shows(verb.lemma) and not owner:
            self._shows(chunk, owner)
            return
        kind, placed = (voices.get("by") or voices["with"]) if chunk.passive else voices["active"]
        self._framed(chunk, kind, placed, owner, finite or after_be)

    def _place_or_nothing(self, chunk: Chunk, owner: list[Mention]) -> bool:
        """ "A rug centered": in the middle of the room, or of what small things stand on, when nothing more is said."""
        after = self._chunk(self.at)
        if after is not None and after.kind in ("place", "adjective", "word"):
            return False
        if after is not None and after.kind == "noun":
            return True
        if owner:
            self._implicit(Place("centered_on", words=chunk.text), list(owner), chunk)
        return True

    def _framed(self, chunk: Chunk, kind: str, placed: str, owner: list[Mention], finite: bool) -> None:
        if kind == "centering" and owner and not chunk.passive:
            after = self._chunk(self.at)
            if after is not None and after.kind == "noun" and after.value.definite:  # "a rug anchors the space"
                self.at += 1
                if after.value.what in ("abstract", "room", "place"):
                    self._at_place("at", owner, "middle", chunk.text, None, self.chunk_span(), True)
            self.glue = ""
            return
        if kind == "centering":
            if not chunk.passive and self._noun_next() and not owner:  # "the room centers on a table"
                self._open(Frame("list", words="centered"), finite)
                self.frames[-1].type = "centered"
            elif chunk.passive and not owner:
                self._open(Frame("list"), finite)
            self.glue = "open" if self._noun_next() else ""
            return
        if not owner and not self.lost and not self.fronted and kind != "occupying":
            self._open(Frame("list"), finite)
            self.glue = "open"
            return
        if placed == "before":
            words = Place(kind, words=chunk.text)
            if finite:
                self.frames = [f for f in self.frames[:1] if f.kind == "list"]
            self.waiting = Waiting(words, list(owner), chunk, self.subset, lost=self.lost and not owner)
            self.subset = None
            self.glue = "object"
            return
        self._open(Frame("verb", list(owner), kind, placed, chunk.text, finite=finite, each=self.each), finite)
        self.glue = "open"

    def _shows(self, chunk: Chunk, owner: list[Mention]) -> None:
        owner = [m for m in owner if not m.implied]
        self._open(Frame("with", list(owner), words=chunk.text) if owner else Frame("list", words=chunk.text), True)
        self.glue = "open"

    def _open(self, frame: Frame, finite: bool) -> None:
        if finite:
            self.frames = [f for f in self.frames[:1] if f.kind == "list" and f.owner == frame.owner]
        self.frames.append(frame)

    def _finite(self, chunk: Chunk) -> None:
        """A finite verb ends the search for its subject; one in the singular has the last thing of a list for it."""
        self.done = True
        verb: Verb = chunk.value
        if self.glue in ("and", "comma", "comma and") and self.subject and not self.subject_open:
            self.frames = [f for f in self.frames[:1] if f.kind == "list"]
            self.head = list(self.subject)
        elif self.subject_open and self.subject:
            if verb.form == "s" and chunk.text not in ("are", "were") and len(self.subject) > 1 and not self.fronted:
                related = {id(m) for s in self.out.said for m in s.subjects}
                if any(id(m) in related for m in self.subject[:-1]):
                    self.subject = self.subject[-1:]
            self.frames = []
            self.head = list(self.subject)
        elif self.fronted and not self.subject:
            self.frames = [Frame("fronted", fronted=self.fronted, finite=True)]
            self.fronted = []
            self.glue = "open"
            self.subject_open = False
            self.inverted = True
            return
        elif self.frames and self.frames[-1].items and not self.subject:
            self.subject, self.head = self.frames[-1].items[-1:], self.frames[-1].items[-1:]
        self.subject_open = False
        self.glue = "verb"
        self.placing = list(self.subject)
