"""Tokens into a brief: what each word may be, tried in order."""

from __future__ import annotations

from .lexer import Token
from .places import Places
from .reading import MODIFIERS, Pending, Reading


class Parser(Places):
    """Reads tokens from left to right; make one, then call ``run``."""

    def run(self) -> Reading:
        """The whole request."""
        while self.at < len(self.tokens):
            token = self.tokens[self.at]
            self.at += 1
            self._one(token)
        self._stranger_ends()
        self._leftover()
        return self.out

    def _one(self, token: Token) -> None:
        if not token.kinds:
            self.strangers.append(token.text)
            return
        if token.has("break"):
            self._stranger_ends()
            self._break(token.text)
            return
        if token.has("only_all"):
            self.out.only = True
            return
        if token.has("neg") and not (token.has("number") and self._noun_follows(1)):
            self._stranger_ends()
            self.negated, self.joined = True, False
            self._leftover()
            return
        if token.has("nothing") and not token.has("noun"):
            self._nothing()
            return
        if token.has("only") and not token.has("noun"):
            self.out.only = self.out.only or self._noun_follows(4)
            return
        if token.has("bound") and self._number_follows():
            self.pending.bound = token.get("bound")
            return
        if token.has("number", "amount") and self._counted(token):
            return
        if token.has("length"):
            self.pending.length = token.get("length")
            return
        if token.text in ("seats", "sleeps", "seat", "sleep", "seating", "accommodates") and self._number_follows():
            self.out.people = (self.tokens[self.at].get("amount") or (0, self.tokens[self.at].get("number")))[1]
            self.at += 1
            return
        if token.has("place") and self._place(token):
            return
        if token.has("people_words", "whom") and self._people(token):
            return
        if token.has("group") and not token.has("noun") and (self.out.room is not None or self._other_room()):
            self._stranger_ends()
            self._group(token)
            return
        if token.has("room") and self._room(token):
            return
        if token.has("group") and not (token.has("noun") and self.relation):
            self._group(token)
            return
        if token.has("noun") and self._is_noun(token):
            self._stranger_ends()
            self._noun(token)
            return
        if token.has("pron") and self.relation is not None and self.relation[0] != "away" and self._pronoun():
            return
        if token.has("relation", "shape") and token.has("shape") and any(t.has("room", "noun") for t in self._ahead(1)):
            self.pending.tokens.append(token)  # "a round restaurant"
            return
        if token.has("relation") and self._relation(token):
            return
        if token.has("with"):
            self._with()
            return
        if token.has("and"):
            self.joined = True
            return
        if token.has("det"):
            if self.negated and token.text in ("a", "an") and self._negation_over():
                self.negated = False
            self._leftover()
            self.pending = Pending(definite=token.text in ("the", "this", "that", "these", "those"), any=True)
            return
        if token.has("each", "both"):
            return
        if token.has(*MODIFIERS):
            self.pending.tokens.append(token)
            return
        if token.has("verb") and self.last:
            self.subjects, self.relation = list(self.last), None
