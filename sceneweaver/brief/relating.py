"""Relations, as they are said: who is related to what."""

from __future__ import annotations

from typing import Any

from sceneweaver.assets import categories

from .lexer import Token
from .mutual import EACH_OTHER
from .parser_state import Mention, OpenRelation, ParsedRelation, ParserState, PendingModifiers

LOST = "lost"
"""Kind of a relation whose subject was not understood."""


class Relating(ParserState):
    """Reads relations, "with", pronouns and the ends of phrases."""

    def _relation(self, token: Token) -> bool:
        kind = str(token.get("relation"))
        if token.has("place") and kind in ("left_of", "right_of") and not self._noun_follows(3):
            return False
        if kind in ("by", "inside", "on") and token.has("stop") and not self._target_follows():
            return False
        if self.negated and any(t.has("room") and not t.has("noun") for t in self._ahead(2)):
            self.negated = False  # "no plants in the living room"
            return True
        if self.negated:
            self._where_it_must_not_be()
            return True
        strange = self._strange_subject()
        self._stranger_ends()
        self._leftover()
        self.predicate = []
        if kind.startswith("each_other:"):
            self._mutual(kind.removeprefix("each_other:"), token.text)
            return True
        subjects, guessed, rest = list(self.subjects), False, []
        if self.last and not self._verb_before():
            # "A bed and a desk by the window": the desk; "... are by the window": both; "on" is said of all.
            subjects, guessed = list(self.last), True
        if self.joined or (self.opening and self.last):  # ahead of its subject, or one more about the same
            subjects, rest, guessed = [], self.subjects or self.last[-1:], False
        self.first_of_pair, self.joined, self.opening = None, False, False
        self.relation = OpenRelation(LOST if strange else kind, subjects, token.text, guessed, rest)
        if kind == "flank" and not token.text.endswith(("of", "flanking")):
            self._flanked()
        return True

    def _where_it_must_not_be(self) -> None:
        self._leftover()
        start = self.at - 1
        while self.at < len(self.tokens) and self.tokens[self.at].has("det"):
            self.at += 1
        self.at = min(self.at + 1, len(self.tokens))
        words = " ".join(t.text for t in self.tokens[start : self.at])
        self.out.unread.append(f"not {words}")
        self._note(f"'not {words}' cannot be said as a relation and was left out")
        self.negated = False

    def _strange_subject(self) -> bool:
        """Whether the noun before a relation was not understood: ", a zorb next to"."""
        start = self.at - 2 - len(self.strangers)
        return bool(self.strangers) and start >= 0 and self.tokens[start].has("det", "and", "break", "number", "amount")

    def _mutual(self, kind: str, words: str) -> None:
        subjects = list(self.last or self.subjects)
        if subjects:
            self.out.said.append(ParsedRelation(kind, subjects, EACH_OTHER, words))
            self.closed = True
        self.relation, self.joined, self.opening = None, False, False

    def _flanked(self) -> None:
        """ "A bed with a nightstand on either side": of what it came with, or of what was named before."""
        assert self.relation is not None
        subjects = self.relation.subjects[-1:]
        others = [m for m in self.out.mentions if m not in subjects]
        if self.owner is not None and self.owner not in subjects:
            others = [self.owner]
        if subjects and others:
            self._relate("flank", others[-1], subjects, self.relation.words)
        else:
            self._open_ends()

    def _target_follows(self) -> bool:
        return any(t.has("noun", "place", "pron", "room") for t in self._ahead(5) if not t.has("break"))

    def _verb_before(self) -> bool:
        return any(t.has("verb") and not t.has("relation") for t in self.tokens[max(0, self.at - 3) : self.at - 1])

    def _relate(self, kind: str, target: Any, subjects: list[Mention], words: str, place: str = "") -> None:
        """Ends a relation at its target; ``place`` is how a place was called."""
        rest = self.relation.rest if self.relation is not None else []
        if self.relation is not None and self.relation.guessed:
            subjects = _meant(kind, target, subjects)
        self.relation, self.first_of_pair = None, None
        self.pending = PendingModifiers()
        spoken = words if not place or words.endswith(place) else f"{words} the {place.removeprefix('the ')}"
        if kind == LOST:
            self.out.unread.append(spoken)
            return
        aims = target if isinstance(target, tuple) else (target,)
        subjects = [s for s in subjects if all(s is not aim for aim in aims)]
        if not subjects and rest and not self._subject_follows():
            subjects = [s for s in rest if s is not target]
        if not subjects:
            self.before.append((kind, target, spoken))
            self.before_used = False
            return
        if kind == "flank" and len(subjects) == 1 and subjects[0].count == (1, 1):
            subjects[0].count = (2, 2)  # "a nightstand on either side of the bed"
        self.out.said.append(ParsedRelation(kind, list(subjects), target, spoken))
        self.subjects, self.closed = list(subjects), True

    def _subject_follows(self) -> bool:
        """Whether a noun comes after "next to the bed", to which this belongs."""
        ahead = self._ahead(4)
        while ahead and (ahead[0].text == "," or ahead[0].has("verb")):
            ahead = ahead[1:]
        return bool(ahead) and (ahead[0].has("det", "number", "amount", "color", "material", "scale", "noun", "group"))

    def _pronoun(self) -> bool:
        assert self.relation is not None
        kind, subjects, words = self.relation.kind, self.relation.subjects, self.relation.words
        others = [m for m in self.out.mentions if m not in subjects]
        if not others:
            return False
        target = self.owner if self.owner is not None and self.owner not in subjects else others[-1]
        self._relate(kind, target, subjects, words)
        return True

    def _with(self) -> None:
        self.owner = self.last[-1] if self.last and self.out.mentions and not self.negated else None
        self.negated = False
        if self._each and self.subjects:  # "two nightstands beside the bed, each with a lamp"
            self.owner = self.subjects[-1]
        if not self.last:
            self._leftover()
        self.joined, self.closed = False, False
        self._open_ends()

    @property
    def _each(self) -> bool:
        return any(t.has("each") for t in self.tokens[max(0, self.at - 6) : self.at])

    def _open_ends(self) -> None:
        """A relation without a target is noted, unless its word has other uses."""
        if self.relation is not None and not (
            self.relation.kind in ("by", "inside", "on", LOST) or self.relation.words in ("around", "over", "under")
        ):
            self._note(f"'{self.relation.words}': it is not clear of what; it was left out")
        self.relation = None

    def _before_ends(self) -> None:
        """A relation said ahead of a subject that never came."""
        if self.before and not self.before_used:
            for _, _, words in self.before:
                self._note(f"'{words}': it is not clear what is meant to be there; it was left out")
        self.before, self.before_used = [], False

    def _break(self, text: str) -> None:
        if (
            text == ","
            and self.pending.any
            and self.pending.tokens
            and not any(t.has("det", "number", "amount", "and", "verb") for t in self._ahead(1))
        ):
            return  # "a large, comfortable sofa"
        self._leftover()
        if self.relation is not None and self.first_of_pair is None:
            self._open_ends()
        if text == ",":
            if self.before_used:
                self.before, self.before_used = [], False
            if self.closed:
                self.owner = None  # "a bed with a lamp beside it, a desk": the desk is not the bed's
            self.joined = True
            return
        self.negated, self.joined, self.owner, self.predicate = False, False, None, []
        self.relation, self.first_of_pair = None, None
        if text in "()":
            return
        self._before_ends()
        self.subjects, self.opening, self.closed = [], True, True


def _meant(kind: str, target: Any, listed: list[Mention]) -> list[Mention]:
    """Who of a list a relation after it is about: the last, or all that belong together."""
    known = categories()
    if kind in ("on", "inside") and isinstance(target, Mention):
        small = []
        for mention in reversed(listed):
            if "surface" not in known[mention.category].mount:
                break
            small.insert(0, mention)
        return small or listed[-1:]
    if kind == "flank" and len(listed) == 2:
        return listed
    groups = {_family(m) for m in listed[-2:]}
    if len(listed) == 2 and groups in ({"seat", "table"}, {"seat"}):
        return listed  # "two armchairs and a side table by the window"
    return listed[-1:]


def _family(mention: Mention) -> str:
    return family(mention.category)


def family(category: str) -> str:
    """Seats, tables, or the group of the taxonomy that a category is in."""
    known, name = categories(), category
    while (parent := known[name].parent) is not None and parent in known and parent != "furniture":
        name = parent
    return {"chair_group": "seat", "seating": "seat", "table_group": "table"}.get(name, name)
