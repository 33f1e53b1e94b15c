"""Phrases about things and their parts."""

from __future__ import annotations

from .chunks import Chunk, NounPhrase
from .parsed import Mention
from .room_phrases import RoomPhrases
from .things import describe, match_of, name_of, new_mention, note_on, singular

MOST_NEW = 400
"""Mentions that are made at most."""


_FLOORS = ("basement", "attic", "loft", "cellar", "rooftop", "upstairs", "downstairs")
"""Words before the name of a room."""

_BUILT_IN = ("integrated", "built in", "integral", "inset")
"""Words for what is part of the thing that it comes with."""

_IN_FRAMES = ("print", "photo", "photograph", "picture", "image", "portrait")
"""What a frame shows."""


class ThingPhrases(RoomPhrases):
    """Phrases about things and their parts."""

    def _np_thing(self, phrase: NounPhrase, chunk: Chunk) -> None:
        if phrase.text in ("furniture", "object"):
            self._for_room(phrase)
            self.glue = ""
            return
        waiting = self.waiting
        target = waiting is not None and self.glue != "start"
        if waiting is None and phrase.determiner in ("each", "every"):  # "each bowl next to a spoon"
            group = self.refs.known(phrase, True, [])
            if group is not None and group.many:
                self._named([group], phrase, chunk, False)
                self.each = True
                return
        if (
            waiting is not None
            and waiting.subjects
            and len(waiting.subjects) > 1
            and (phrase.definite or phrase.determiner == "each")
        ):
            one = self.refs.known(phrase, True, [])  # "ten tables and four chairs around each table"
            waiting.subjects = [s for s in waiting.subjects if s is not one]
        without = (waiting.subjects or []) if waiting is not None else []
        if (
            phrase.value in ("rest", "the other", "the others")
            and self.refs.rest is not None
            and singular_is(self.refs.rest, phrase)
        ):
            found: Mention | None = self.refs.rest
        else:
            found = self.refs.known(phrase, target, without)
            if found is None and phrase.count == (1, 1) and phrase.determiner == "one" and not target:
                several = self.refs.known(phrase, True, without)
                if several is not None and several.many:
                    found = self.refs.part([several])
        new = found is None
        of_room = any((t.has("room") and not t.has("noun")) or t.text in _FLOORS for t in phrase.qualities)
        if new and of_room and phrase.value is None and self.glue == "start" and not self.out.mentions:
            self._np_abstract(phrase, chunk)  # "a basement cinema"
            self.lost = False
            return
        if new and self._of_the_room(phrase):
            return
        mention = found if found is not None else self._new(phrase)
        if mention is None:
            self._lost_noun()
            return
        if not new:
            self._again(mention, phrase)
        self._named([mention], phrase, chunk, new)

    def _of_the_room(self, phrase: NounPhrase) -> bool:
        """Whether an unknown noun at the very start is the room or who it is for: "a mountain hut for two hikers: "."""
        if self.out.mentions or self.waiting is not None or match_of(name_of(phrase)).how != "generic":
            return False
        before, after = self._chunk(self.at - 2), self._chunk(self.at)
        if before is not None and before.kind == "purpose" and before.value == "people" and phrase.count is not None:
            self._np_people(phrase, before)
            return True
        room = self.out.room_type is not None or bool(self.out.room_words) or self._other_room()
        if room or phrase.definite or phrase.plural or phrase.count not in (None, (1, 1)) or after is None:
            return False
        if not (after.start in self.source.colons or (after.kind == "purpose" and after.value == "people")):
            return False
        self._unknown_room(phrase)
        self._for_room(phrase)
        self.lost = False
        return True

    def _is_part(self, phrase: NounPhrase) -> bool:
        """Whether what a thing is told to come with is a part of it: an integrated basin, the photo in a frame."""
        owner = self.frames[-1].owner[-1:] if self.frames and self.frames[-1].kind == "with" else []
        if not owner or self.waiting is not None or phrase.definite:
            return False
        built_in = any(t.text in _BUILT_IN for t in phrase.qualities)
        framed = singular(owner[0].noun).endswith("frame") and singular(phrase.text) in _IN_FRAMES
        return built_in or framed

    def _new(self, phrase: NounPhrase) -> Mention | None:
        implied = self._implied(phrase)
        if implied is not None:
            return implied
        if len(self.out.mentions) >= MOST_NEW:
            self._unread(phrase.text, phrase.start, phrase.end)
            return None
        mention = new_mention(phrase, self.source)
        if mention.generic and not self._concrete(phrase):
            self._unread(self.source.text[phrase.start : phrase.end], phrase.start, phrase.end)
            return None
        if any(t.text == "matching" for t in phrase.qualities) and (self.head or self.previous or self.subject):
            like = (self.head or self.previous or self.subject)[-1]
            mention.color, mention.material = mention.color or like.color, mention.material or like.material
            mention.style = mention.style or like.style
            mention.attributes += [
                a for a in like.attributes if a.kind in ("color", "material", "style", "other", "finish")
            ]
        note_on(mention, self.out)
        self.out.mentions.append(mention)
        return mention

    def _concrete(self, phrase: NounPhrase) -> bool:
        """Whether a noun that is not known stands where a thing is named: in a list, or as what is placed."""
        if phrase.definite or not any(c.isalpha() for c in phrase.text):
            return False
        if phrase.determiner or phrase.count is not None:
            return True
        return bool(self.frames or self.waiting) and self.glue != "start" and bool(self.out.mentions)

    def _implied(self, phrase: NounPhrase) -> Mention | None:
        """What a "dining area" called for, when the request now says what it is to be."""
        if phrase.definite:
            return None
        noun = name_of(phrase)
        head = singular(noun).split()[-1]
        for mention in (m for m in reversed(self.out.mentions[-12:]) if m.implied):
            match = match_of(noun)
            if mention.category == match.category or singular(mention.noun).split()[-1] == head:
                if singular(noun) != head:
                    mention.noun, mention.category, mention.generic = noun, match.category, match.how == "generic"
                if phrase.count is not None or phrase.determiner:
                    mention.count = phrase.count or (1, 1)
                mention.implied = False
                mention.span = self.source.span(phrase.start, phrase.end)
                describe(mention, phrase, self.source)
                return mention
        return None

    def _again(self, mention: Mention, phrase: NounPhrase) -> None:
        """More is said of what was named before."""
        if mention.count is None and phrase.count is not None:
            mention.count = phrase.count
        if mention.implied:
            mention.implied = False
        known = {a.words for a in mention.attributes}
        phrase.qualities = [t for t in phrase.qualities if t.text not in known]
        describe(mention, phrase, self.source)

    def _lost_noun(self) -> None:
        if self.waiting is not None:
            self._unread(self.waiting.chunk.text, self.waiting.chunk.start, self.waiting.chunk.end)
            self.waiting = None
            return
        self._nobody()


def singular_is(mention: Mention, phrase: NounPhrase) -> bool:
    """Whether a phrase names a mention by its last word."""
    return mention.noun.rstrip("s").endswith(phrase.text.rstrip("s"))
