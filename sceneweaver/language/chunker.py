"""Tokens into chunks, each by the classes of its tokens."""

from __future__ import annotations

from .chunks import CLOSED, OPEN, QUALITIES, Chunk, NounPhrase
from .noun_phrases import NounPhrases
from .tokens import Token
from .vocabulary import Verb, frame


class Chunker(NounPhrases):
    """Finds the chunks of tokens from left to right; make one, then call ``run``."""

    def run(self) -> list[Chunk]:
        """All chunks."""
        while self.at < len(self.tokens):
            self._next()
        return self.out

    def _next(self) -> None:
        token = self.tokens[self.at]
        after = self._token(1)
        if token.has("break"):
            self._add({",": "comma", ".": "stop"}.get(token.text, "bracket"))  # type: ignore[arg-type]
        elif token.has("only_all"):
            self._add("only", value="all")
        elif token.has("neg"):
            self._add("without", value=token.text)
        elif token.has("nothing"):
            self._add("without", value="nothing")
        elif token.has("only") and not token.has("noun"):
            self._add("only", value="named")
        elif token.has("mutual"):
            self._add("place", value=token.get("mutual"), mutual=True)
        elif (
            token.has("partial", "rest", "each", "both", "pron") and self._pronoun(token, after) or self._purpose(token)
        ):
            pass
        elif token.has("with") and not (token.has("noun") and not self.noun_before):
            self._add("with", value=token.text)
        elif (token.has("preposition", "place_adverb")) and self._is_place(token, after):
            place = token.get("preposition") or token.get("place_adverb")
            bare = token.has("place_adverb", "bare")
            if token.has("place_adverb") and token.has("preposition") and not self._noun_follows():
                place = token.get("place_adverb")
            self._add("place", value=place, bare=bare if token.has("preposition") else True)
            if not token.has("preposition"):
                self.out[-1].passive = True  # takes no target
        elif (
            token.text in ("seats", "sleeps", "seating", "sleeping")
            and after is not None
            and self._people_seated(after)
        ):
            self._add("word", value=token)
        elif token.has("and") and not token.has("noun"):
            self._add("and")
        elif token.has("while"):
            self._add("while", value=token.text)
        elif token.has("verb") and self._is_verb(
            self.at, seen_noun=self.noun_before or self._participle_next(token, after)
        ):
            self._verb(token)
        elif (
            not token.kinds
            and self.noun_before
            and token.text.endswith(("ing", "ed"))
            and (after is None or after.has(*CLOSED))
        ):
            self._add("verb", value=Verb("act", "ing" if token.text.endswith("ing") else "ed"))
        elif (
            not token.kinds
            and self.noun_before
            and token.text.endswith("s")
            and after is not None
            and after.has(*CLOSED)
        ):
            self._add("verb", value=Verb("act", "s"))  # a verb that is not known
        elif self._noun_phrase():
            pass
        elif token.has("verb"):
            self._verb(token)
        else:
            self._add("word", value=token)

    def _noun_follows(self, offset: int = 1) -> bool:
        """Whether a noun phrase comes next."""
        token = self._token(offset)
        if (
            token is None
            or token.has("break", "and", "with", "while")
            or (token.has("preposition") and not token.has("det", *QUALITIES))
        ):
            return False
        if token.has("verb") and not token.has("noun", *QUALITIES):
            return False
        return not (token.has("adverbs", "stop") and not token.has("det", "number", "amount", "noun", *QUALITIES))

    def _is_place(self, token: Token, after: Token | None) -> bool:
        if (
            token.has("shape", "adjective", "color", "scale", "noun", "region")
            and after is not None
            and token.text not in ("opposite", "inside")
        ):
            return not after.has("noun", "room", *QUALITIES) or after.has("det", "number")
        return True

    def _pronoun(self, token: Token, after: Token | None) -> bool:
        text = token.text
        opens = (
            after is not None
            and (after.has(*OPEN) or not after.kinds)
            and not after.has(*CLOSED)
            and not (after.has("verb") and self._is_verb(self.at + 1, seen_noun=True))
        )
        if token.has("each", "both") and (opens or (after is not None and after.has("det", "number"))):
            return False
        if token.has("det", "number") and opens:
            return False
        if token.has("rest") and opens:
            return False
        if token.text == "another" and opens:
            return False
        if token.text == "one" and after is not None and after.text == "of":
            return False
        kind = next(k for k in ("rest", "partial", "both", "each", "pron") if token.has(k))
        phrase = NounPhrase("pronoun", text, token.start, token.end, value=kind)
        if (
            token.text == "one"
            and self.noun_before
            and after is not None
            and not (after.has("verb", "preposition", "place_adverb"))
        ):
            return False
        self._add("noun", value=phrase)
        return True

    def _purpose(self, token: Token) -> bool:
        """ "for players to rest", "to illuminate the layout": what something is for; people are read."""
        after = self._token(1)
        verb = after.get("verb") if after is not None else None
        voices = frame(verb) if isinstance(verb, Verb) and verb.form == "base" else None
        if (
            token.text == "to" and isinstance(verb, Verb) and voices is not None and "active" in voices
        ):  # "open to reveal two toys"
            self._add("word", value=token)
            self._add("verb", value=Verb(verb.lemma, "ing"))
            return True
        if (
            token.text == "to"
            and after is not None
            and after.has("verb", "stop")
            or token.text in ("to", "ready to", "in order to")
        ):
            end = self.at + 1
        elif token.text == "for" or token.has("purposes"):
            end = self.at + 1
            ahead = self.tokens[end : end + 4]
            if any(t.has("whom", "people_words", "number", "amount") for t in ahead[:3]) and not any(
                t.has("noun") for t in ahead[:2] if not t.has("whom", "people_words", "number")
            ):
                self._add("purpose", value="people")
                return True
            if any(t.has("room", "group") for t in ahead[:3]):
                self._add("purpose", value="room")
                return True
        else:
            return False
        while end < len(self.tokens) and not self.tokens[end].has("break", "with", "while"):
            t = self.tokens[end]
            if t.has("and") and end + 1 < len(self.tokens) and self.tokens[end + 1].has("det", "number"):
                break
            if end > self.at + 1 and (
                t.has("place_adverb") or (t.has("preposition") and t.text not in ("in", "on", "at", "by", "about"))
            ):
                break
            if end > self.at + 2 and t.has("verb") and t.get("verb").form == "s" and not t.has("noun"):
                break
            end += 1
        self._add("purpose", end - self.at, value="use")
        return True

    def _verb(self, token: Token) -> None:
        verb: Verb = token.get("verb")
        after = self._token(1)
        if verb.form == "ed" and after is not None and after.text in ("by", "with", "of", "in", "on", "to", "around"):
            voices = frame(verb)
            if voices is not None and "with" in voices and after.text == "with":
                self._add("verb", 2, value=verb, passive=True)
                return
            if (
                voices is not None
                and "by" in voices
                and (
                    after.text in ("by", "with", "of")
                    or (after.text in ("in", "to", "on") and verb.lemma in ("cover", "connect", "fill"))
                )
            ):
                self._add("verb", 2, value=verb, passive=True)
                return
        self._add("verb", value=verb)

    def _people_seated(self, after: Token) -> bool:
        """Whether "seats eight" says for how many people, and not which chairs."""
        third = self._token(2)
        return after.has("number", "amount") and not (third is not None and (third.has(*OPEN) or not third.kinds))
