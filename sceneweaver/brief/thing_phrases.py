"""Phrases about things and their parts."""

from __future__ import annotations

from .chunks import Chunk, NounPhrase
from .model import Attribute
from .parsed import Mention
from .room_phrases import RoomPhrases
from .things import describe, match_of, name_of, new_mention, note_on, singular
from .vocabulary import Place, family, mounts

MOST_NEW = 400
"""Mentions that are made at most."""


_FLOORS = ("basement", "attic", "loft", "cellar", "rooftop", "upstairs", "downstairs")
"""Words before the name of a room."""


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
        mention = found if found is not None else self._new(phrase)
        if mention is None:
            self._lost_noun(phrase, chunk)
            return
        if not new:
            self._again(mention, phrase)
        self._named([mention], phrase, chunk, new)

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

    def _lost_noun(self, phrase: NounPhrase, chunk: Chunk) -> None:
        if self.waiting is not None:
            self._unread(self.waiting.chunk.text, self.waiting.chunk.start, self.waiting.chunk.end)
            self.waiting = None
            return
        self._nobody()

    def _np_region(self, phrase: NounPhrase, chunk: Chunk) -> None:
        """The top, the middle, a corner, a side: of a thing, or of the room."""
        region, of = str(phrase.value), phrase.of
        if of is not None and of.what == "room" and self.waiting is None and self.out.room_type is None:
            self._np_room(of, chunk)
            return
        waiting, self.waiting = self.waiting, None
        owner: Mention | str | None = None
        if of is not None:
            if of.what in ("room", "place"):
                owner = str(of.value) if of.what == "place" and of.value not in ("floor", "room") else "room"
            elif of.what in ("thing", "pronoun"):
                owner = self._whose(of)
        else:
            named = [t for t in phrase.qualities if t.has("noun")]
            if named:
                inner = NounPhrase("thing", named[-1].text, phrase.start, phrase.end, value=None, determiner="the")
                owner = self.refs.known(inner, True, (waiting.subjects or []) if waiting else [])
            if any(t.has("room") and not t.has("noun") for t in phrase.qualities):
                owner = "room"
        if (
            waiting is None
            and not phrase.definite
            and self.frames
            and self.frames[-1].kind == "with"
            and self.frames[-1].owner
            and of is None
        ):
            self._np_part(phrase, chunk)
            return
        if waiting is None:
            if region in ("center", "corner", "side"):
                self._nobody()
            elif owner is not None and isinstance(owner, Mention):
                self._named([owner], phrase, chunk, False)
            else:
                found = self.refs.carrier([*self.subject, *self._near([])], [], "top", phrase.text)
                if found is not None and phrase.definite:
                    self._named([found], phrase, chunk, False)
                else:
                    self._nobody()
            return
        subjects = waiting.subjects or []
        if (
            owner is None
            and region == "corner"
            and phrase.determiner not in ("its", "their")
            and (
                waiting.place.words in ("in", "inside", "into", "near", "fill", "fills")
                or waiting.place.type == "occupying"
                or not subjects
                or any(mounts(s.category)[0] == "floor" for s in subjects)
            )
        ):
            owner = "room"
        if owner is None and region == "center":
            small = bool(subjects) and all("surface" in mounts(s.category) for s in subjects)
            frame = self.frames[-1] if self.frames else None
            if frame is not None and frame.kind == "with" and any(family(o.category) == "table" for o in frame.owner):
                small = small or any(
                    s in frame.items and family(s.category) not in ("seat", "table") and "rug" not in s.category
                    for s in subjects
                )
            near = self._near(subjects) if subjects else (self.refs.topics[-1] if self.refs.topics else [])
            root = self._root(near[-1]) if near else None
            if small and self.surface is not None and phrase.determiner not in ("its", "their"):
                owner = self.surface
            elif small and root is not None and root is not near[-1] and root not in subjects:
                owner = root
            elif (small or phrase.determiner in ("its", "their")) and near:
                owner = self.refs.carrier(near, subjects) or near[-1]
            else:
                owner = "room"
        if owner is None:
            near = self._near(subjects)
            if phrase.determiner == "its" and near and near[-1].many:
                pronoun = NounPhrase("pronoun", "it", phrase.start, phrase.end, value="pron")
                near = self.refs.pronoun(pronoun, [], [*subjects, *near]) or near
            owner = self.refs.carrier(near, subjects, "top" if region == "top" else region, phrase.text) or (
                near[-1] if near else None
            )
        if owner is None:
            self._nobody()
            return
        if isinstance(owner, str):
            if any(t.text == "opposite" for t in phrase.qualities) and subjects:
                others = self._main(subjects)
                if others:
                    self._say(
                        "opposite", subjects, (others[-1],), phrase.text, None, False, None, self.chunk_span(), True
                    )
            place = {"corner": "corner", "center": "middle"}.get(region, "room")
            if owner in ("wall", "window", "door", "ceiling") or owner.startswith("wall:"):
                place = owner
            if phrase.determiner in ("each", "every", "all") or phrase.text == "corners":
                for subject in subjects:
                    if subject.count == (1, 1):
                        subject.count = phrase.count or (4, 4)
            self._bound(
                waiting._replace_place(Place("at", words=waiting.place.words))
                if place in ("corner", "middle")
                else waiting,
                (place,),
            )
        else:
            kind = waiting.place.type
            if region == "center" and kind in (
                "inside",
                "on",
                "at",
                "near",
                "centered_on",
                "occupying",
                "along",
                "covering",
            ):
                kind = "centered_on"
            elif region == "inside":
                kind = "inside"
            elif region in ("top", "corner") and kind in ("inside", "at", "occupying", "covering", "on"):
                kind = "on"
            elif region == "end" and kind in ("at", "on", "near"):
                kind = (
                    "on"
                    if subjects and all("surface" in mounts(s.category) for s in subjects)
                    else "at_foot"
                    if "bed" in owner.category
                    else "next_to"
                )
            elif phrase.text in ("edge", "rim", "ledge", "lip") and kind in ("near", "next_to"):
                kind = "on"
            elif region in ("foot", "head") and kind in ("at", "near", "by", "on"):
                kind = {"foot": "at_foot", "head": "at_head"}[region]
            elif region in ("side", "front", "back") and kind in ("on", "at", "by", "near", "inside"):
                kind = {"side": "next_to", "front": "in_front_of", "back": "behind"}[region]
            if kind == "occupying":
                kind = "on"
            place = Place(kind, waiting.place.side, waiting.place.each, f"{waiting.place.words} {phrase.text}")
            self._bound(waiting._replace_place(place), (owner,))
        self.glue, self.last_target = "", None
        if waiting.subjects is None:
            self.head = []

    def _whose(self, of: NounPhrase) -> Mention | None:
        """What a part is of."""
        without = (self.waiting.subjects or []) if self.waiting is not None else []
        if of.what == "pronoun":
            found = self.refs.pronoun(of, self._near(without), without)
            return found[-1] if found else None
        if of.what != "thing":
            return None
        found_one = self.refs.known(of, True, without)
        return found_one if found_one is not None else self._new(of)

    def _np_part(self, phrase: NounPhrase, chunk: Chunk) -> None:
        """What a thing has is said of it: "with three drawers", "a tufted headboard"."""
        owners = self.frames[-1].owner if self.frames and self.frames[-1].kind in ("with", "verb") else []
        owners = owners or (self.head if self.glue in ("open", "", "and") else [])
        opening = phrase.text.split()[-1].rstrip("s")
        if self.waiting is not None and opening in ("door", "window"):
            phrase.what, phrase.value = "place", opening
            self._np_place(phrase, chunk)
            return
        waiting, self.waiting = self.waiting, None
        if waiting is not None and phrase.definite and waiting.subjects:  # "a pillow against the headboard"
            near = [m for m in reversed(self.out.mentions[-20:]) if any(a.value == phrase.text for a in m.attributes)]
            near = [m for m in near if m not in waiting.subjects] or self._near(waiting.subjects)
            if near:
                self._bound(waiting, (near[0],))
            self.glue = ""
            return
        if waiting is not None and waiting.subjects:
            owners = waiting.subjects
        span = self.source.span(phrase.start, phrase.end)
        said = self.source.text[phrase.start : phrase.end]
        for owner in owners[-1:]:
            owner.attributes.append(
                Attribute(kind="part", value=phrase.text, words=" ".join(said.split()), count=phrase.count, span=span)
            )
            for token in phrase.qualities:
                if token.has("material", "adjective", "color", "shape", "styles", "scale"):
                    owner.attributes.append(
                        Attribute(
                            kind="part",
                            value=f"{token.text} {phrase.text}",
                            words=f"{token.text} {phrase.text}",
                            span=span,
                        )
                    )
        if not owners and not phrase.definite:
            mention = self._new(phrase) if phrase.determiner or phrase.count else None
            if mention is not None:
                self._named([mention], phrase, chunk, True)
                return
        self.glue = ""
        self.head = list(owners[-1:]) if owners else self.head


def singular_is(mention: Mention, phrase: NounPhrase) -> bool:
    """Whether a phrase names a mention by its last word."""
    return mention.noun.rstrip("s").endswith(phrase.text.rstrip("s"))
