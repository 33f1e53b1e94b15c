"""Parts of things: tops, middles, sides, shelves, headboards."""

from __future__ import annotations

from .chunks import Chunk, NounPhrase
from .model import Attribute
from .parsed import Mention
from .thing_phrases import ThingPhrases
from .vocabulary import Place, family, mounts

_TWO = ("two", "double", "dual")


class RegionPhrases(ThingPhrases):
    """Parts of things: tops, middles, sides, shelves, headboards."""

    def _np_thing(self, phrase: NounPhrase, chunk: Chunk) -> None:
        if self._is_part(phrase):
            self._np_part(phrase, chunk)
        else:
            super()._np_thing(phrase, chunk)

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
                own = self.subject[-1:] if phrase.determiner == "its" else []
                own = [m for m in own if mounts(m.category)[0] == "floor"]
                found = own[0] if own else self.refs.carrier([*self.subject, *self._near([])], [], "top", phrase.text)
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
            number, _, noun = phrase.text.partition(" ")
            if number in _TWO and noun:  # "two sinks" that no cabinet has
                phrase.count, phrase.text, phrase.plural = (2, 2), noun, True
            mention = self._new(phrase) if phrase.determiner or phrase.count else None
            if mention is not None:
                self._named([mention], phrase, chunk, True)
                return
        self.glue = ""
        self.head = list(owners[-1:]) if owners else self.head
