"""Chunks into mentions and relations: who is placed where, clause by clause."""

from __future__ import annotations

from sceneweaver.assets.taxonomy import category_named

from .chunks import Chunk, NounPhrase
from .parsed import Mention
from .state import Frame, Waiting
from .things import describe, give_sides, singular
from .tokens import Token
from .verbs import Verbs
from .vocabulary import Place, mounts

_TURNED = ("transform", "convert", "turn", "set up")

SEATED = 4
"""Chairs from which on those around a table are taken for dining chairs."""


def _is_plain(noun: str) -> bool:
    """Whether chairs are not called armchairs and the like, but for what covers them."""
    return singular(noun).split()[-1] == "chair" and not _EASY.intersection(noun.split())


_EASY = frozenset(("arm", "easy", "lounge", "reading", "accent", "club", "wing", "sofa", "papasan", "slipper"))
"""Words for chairs to rest in."""


class Clauses(Verbs):
    """Chunks into mentions and relations: who is placed where, clause by clause."""

    def _purpose(self, chunk: Chunk) -> None:
        if self.waiting is not None:
            self._open_ends()
        if self.glue == "verb":
            self.glue = ""

    def _adjective(self, chunk: Chunk) -> None:
        """Words of quality alone: of what "is" so, of what stands before them, or of the room."""
        phrase: NounPhrase = chunk.value
        if self.glue == "open" and self.frames and self.frames[-1].owner and not self.frames[-1].items:
            self.head, self.glue = self.frames.pop().owner, ""  # "covered in red felt"
        who = self.predicate or (self.head if self.glue == "" and not self.waiting else [])
        if phrase.sides is not None:
            sides, phrase.sides = phrase.sides, None
            last = (self.head or self.subject)[-1:]
            if last and not self.waiting and _furniture(last[0], sides):
                give_sides(last[0], sides)
            else:
                self.out.sides.append(sides)
        if phrase.length is not None and (self.head or self.subject):
            axis = next((t.get("dim") for t in phrase.qualities if t.has("dim")), None)
            if axis is not None:
                last_one = (self.head or self.subject)[-1]
                last_one.size[int(axis)], last_one.scale = phrase.length, 1.0
        if who:
            for mention in who:
                describe(
                    mention, NounPhrase("thing", "", phrase.start, phrase.end, qualities=phrase.qualities), self.source
                )
        else:
            for token in phrase.qualities:
                self._quality_of_room(token, room=not self.out.mentions or self.after_be)

    def _word(self, chunk: Chunk) -> None:
        token: Token = chunk.value
        if (
            token.text in ("seats", "sleeps", "accommodates")
            and self.at < len(self.chunks)
            and self.chunks[self.at].kind == "noun"
        ):
            phrase = self.chunks[self.at].value
            if phrase.what == "number":
                self.out.people = (phrase.count or (1, 1))[1]
                self.at += 1
                return
        if not token.kinds and token.text.isalpha() and not token.text.endswith("ly"):
            self._unread(token.text, chunk.start, chunk.end)

    def run(self) -> None:
        """All chunks."""
        self._sentence()
        while self.at < len(self.chunks):
            chunk = self.chunks[self.at]
            self.at += 1
            if chunk.kind not in ("while", "verb", "word"):
                self.relative = False
            getattr(self, f"_{chunk.kind}")(chunk)
        self._sentence()
        self._seated()

    def _seated(self) -> None:
        """Chairs around a table to eat at are dining chairs, upholstered or not."""
        for said in self.out.said:
            target = said.targets[0]
            if said.type not in ("around", "along", "at", "flanking") or not isinstance(target, Mention):
                continue
            for one in said.subjects:
                many = one.count is not None and one.count[0] >= SEATED
                if many and "dining" in target.category and one.category == "armchair" and _is_plain(one.noun):
                    one.category = "dining_chair"

    def _sentence(self) -> None:
        self._open_ends()
        self._on_the_same()
        inverted = [t for f in self.frames[:1] for _, ts, _ in f.fronted for t in ts if isinstance(t, Mention)]
        topic = (inverted if self.inverted else []) or self.subject or self.first_items[:1]
        if not topic and self.lost:
            topic = self.out.mentions[self.begun :][:1]
        self.begun = len(self.out.mentions)
        if topic and topic not in self.refs.topics[-1:]:
            self.refs.topics.append(list(topic))
        self.begin()

    def _stop(self, chunk: Chunk) -> None:
        self._sentence()

    def _bracket(self, chunk: Chunk) -> None:
        self.glue = "bracket"

    def _comma(self, chunk: Chunk) -> None:
        if self.waiting is not None and self.waiting.first is None:
            self._open_ends()
        self.manner, self.each = "", False
        self.glue = "comma"
        self.predicate = []

    def _and(self, chunk: Chunk) -> None:
        self.glue = "comma and" if self.glue == "comma" else "or" if chunk.text == "or" else "and"

    def _while(self, chunk: Chunk) -> None:
        if chunk.text == "but":
            self.negated = ""
            self.glue = "comma"
            return
        if chunk.text == "where" and (self.head or self.subject):
            place = (self.head or self.subject)[-1]
            if mounts(place.category)[0] == "floor":
                self._stands_on(place, chunk.text)
        if chunk.text in ("that", "which", "whose", "who"):
            self.relative = bool(self.head)
            return
        if self.subject:
            self.refs.topics.append(list(self.subject))
        self._open_ends()
        bottom = [f for f in self.frames[:1] if f.kind == "list"]
        self.frames, self.fronted, self.waiting = bottom, [], None
        self.subject, self.subject_open, self.glue, self.negated, self.manner = [], True, "while", "", ""

    def _noun(self, chunk: Chunk) -> None:
        phrase: NounPhrase = chunk.value
        self.after_be = False
        if self.negated and self._excluded(phrase, chunk):
            return
        getattr(self, f"_np_{phrase.what}")(phrase, chunk)

    def _place(self, chunk: Chunk) -> None:
        place: Place = chunk.value
        self.after_be = False
        if self.negated:
            self._nowhere(chunk)
            return
        if self.waiting is not None:
            self._open_ends()
        before = self._chunk(self.at - 2)
        turned = before is not None and before.kind == "verb" and before.value.lemma in _TURNED
        if turned and place.type in ("inside", "through", "on") and self._noun_next():
            self.at += 1  # "transformed into a studio"
            return
        if place.type == "centered_on" and not (self.subject or self.head or self.out.mentions) and self._noun_next():
            self.frames.append(Frame("list", type="centered", words=chunk.text))  # "a bedroom centered on a bed"
            self.glue, self.lost = "open", False
            return
        if chunk.mutual:
            self._mutual(place, chunk)
            return
        after = self._chunk(self.at)
        if chunk.text == "in" and after is not None and after.kind == "adjective" and self.head:
            return  # "a pair of chairs in green and violet"
        glue, self.glue = self.glue, ""
        subjects = self._subjects_of(place, glue)
        fronts = chunk.bare and subjects is None and not self._target_next()
        if self._noun_next() and not (chunk.passive or fronts):
            lost = self.lost and not subjects
            self.waiting = Waiting(self._mannered(place), subjects, chunk, self.subset, lost=lost)
            self.subset = None
            self.glue = "object"
            return
        self._implicit(self._mannered(place), subjects, chunk)
        self.subset = None

    def _subjects_of(self, place: Place, glue: str) -> list[Mention] | None:
        """Who a word of place is about; None: who comes after it."""
        if glue in ("start", "while") or (glue in ("comma", "and", "comma and") and self._fronts(self.at - 1)):
            self.lost = self.lost and glue == ""
            self.frames = (
                [f for f in self.frames[:1] if f.kind == "list"] if glue != "and" or self.done else self.frames
            )
            if self.subject and glue != "start":
                self.previous = list(self.subject)
                self.refs.topics.append(list(self.subject))
                self.subject, self.subject_open, self.done = [], True, False
            return None
        if glue == "verb":
            return list(self.subject)
        if glue in ("comma", "comma and") and not self.frames and self.subject:
            return list(self.subject) if self.done else list(self.head)
        if glue == "and" and self.last_subjects:
            return list(self.last_subjects)
        if glue == "open" and self.frames and not self.frames[-1].items:
            return None
        if not self.head:
            return list(self.subject) if self.subject else ([] if self.lost else None)
        head = list(self.head)
        frame = self.frames[-1] if self.frames else None
        if (
            frame is not None
            and frame.kind == "verb"
            and frame.type in ("on", "inside")
            and place.type in ("opposite", "along")
        ):
            return list(frame.owner)  # "a console supports a TV across from the sofa"
        if self.joined != "and":
            return head
        if self.subject_open and not self.frames and len(self.subject) > 1 and self.head == self.subject[-1:]:
            head = self._meant(place, self.subject)
        elif self.frames and len(self.frames[-1].items) > 1 and self.head == self.frames[-1].items[-1:]:
            head = self._meant(place, self.frames[-1].items)
        return head

    def _nowhere(self, chunk: Chunk) -> None:
        """Where something must not be cannot be said as a relation."""
        after = self.chunks[self.at] if self.at < len(self.chunks) else None
        if self.negated == "where" or self.negated == "first":
            said = chunk.text
            end = chunk.end
            if after is not None and after.kind == "noun" and after.value.what != "room":
                said, end = f"{chunk.text} {self.source.text[after.start : after.end]}", after.end
                self.at += 1
            elif after is not None and after.kind == "noun":
                self.negated = ""
                return
            self._unread(f"not {said}", chunk.start, end)
            self.out.note(f"'not {said}' cannot be said as a relation and was left out")
            self.negated = ""
            return
        self.negated = (
            "" if not (after is not None and after.kind == "noun" and after.value.what == "room") else self.negated
        )
        if self.negated:
            self.negated = ""
            return
        self._place(chunk)

    def _mannered(self, place: Place) -> Place:
        """ "Leaning against", "hanging on", "centered under": what the verb adds to a word of place."""
        manner, self.manner = self.manner, ""
        if manner == "lean" and place.type in ("against", "on", "next_to", "near"):
            return Place(
                "leaning_on" if place.type in ("against", "on") else place.type, words=f"leaning {place.words}"
            )
        if manner == "center" and place.type in ("on", "inside", "centered_on"):
            return Place("centered_on", words=f"centered {place.words}")
        if manner == "drape" and place.type in ("above", "through"):
            return Place("on", words=f"draped {place.words}")
        if manner in ("hang", "mount") and place.type in ("above", "on", "inside", "against"):
            return Place(place.type, words=f"{'hanging' if manner == 'hang' else 'mounted'} {place.words}")
        return place


def _furniture(mention: Mention, sides: tuple[float, ...]) -> bool:
    """Whether sides [m] may be those of a thing."""
    size = category_named(mention.category).size
    return size is not None and max(sides[:2]) <= 2 * max(size.depth[1], size.width[1])
