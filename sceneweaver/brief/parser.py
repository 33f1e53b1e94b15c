"""Tokens into a brief: what each word may be, tried in order."""

from __future__ import annotations

from sceneweaver.assets import categories

from .lexer import Token
from .parser_state import MODIFIERS, ParsedRequest, PendingModifiers, give_sides
from .places import Places


class Parser(Places):
    """Reads tokens from left to right; make one, then call ``run``."""

    def run(self) -> ParsedRequest:
        """The whole request."""
        while self.at < len(self.tokens):
            token = self.tokens[self.at]
            self.at += 1
            self._one(token)
        self._stranger_ends()
        self._break(".")
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
            if self.relation is not None:
                self._open_ends()
            self.negated, self.negated_article, self.negated_nouns, self.joined = True, False, 0, False
            self._leftover()
            return
        if token.text == "but":
            self.negated, self.joined = False, False
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
            self._length(token)
            return
        if token.has("sides"):
            self._sides(token)
            return
        if token.text in ("seats", "sleeps", "seat", "sleep", "seating", "accommodates") and self._number_follows():
            self.out.people = (self.tokens[self.at].get("amount") or (0, self.tokens[self.at].get("number")))[1]
            self.at += 1
            return
        if token.has("place") and self._place(token):
            return
        if token.has("people_words", "whom") and self._people(token):
            return
        if token.has("group") and not token.has("noun") and (self.out.room_type is not None or self._other_room()):
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
        if token.has("pron") and self.relation is not None and self.relation.kind != "away" and self._pronoun():
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
            article = token.text in ("a", "an")
            if self.negated and article and self._negation_over():
                self.negated = False
            self._leftover()
            definite = token.text in ("the", "this", "that", "these", "those")
            self.pending = PendingModifiers(definite=definite, any=True, article=article)
            return
        if token.has("each", "both"):
            self.pending.definite = self.pending.definite or token.has("each")
            return
        if token.has(*MODIFIERS):
            self.pending.tokens.append(token)
            return
        if token.has("verb") and self.last:
            self._verb(token)

    def _verb(self, token: Token) -> None:
        """ "The sofa is red", "it should be red": the verb says what the words after it are about."""
        before = self.tokens[self.at - 2] if self.at >= 2 else None
        about = before is not None and (before.has("noun") or before.text in ("it", "they", "both", "all"))
        if about and token.text.split()[-1] in ("is", "are", "be"):
            self.predicate = list(self.last)
        if about:
            self.opening = False
        elif self.negated and self.joined:
            self.negated = False  # "no rug, put a plant in the corner"
        self.subjects, self.relation = list(self.last), None

    def _length(self, token: Token) -> None:
        """ "A 2 m wide sofa" and "a sofa, 2 m wide"."""
        ahead = self._ahead(2)
        after = len(ahead) < 2 or not ahead[1].has("noun", *MODIFIERS)
        if ahead and ahead[0].has("dim") and after and self.last and not self.pending.any:
            self.last[-1].size[int(ahead[0].get("dim"))] = token.get("length")
            self.last[-1].scale = 1.0
            self.at += 1
            return
        self.pending.length = token.get("length")

    def _sides(self, token: Token) -> None:
        """ "A 1.2 m x 0.6 m table", "a table (120 x 60 cm)"; what is of no thing is the room's."""
        sides: tuple[float, ...] = token.get("sides")
        ahead = next((t for t in self._ahead(4) if t.has("noun", "room", "place", "break", "and")), None)
        if self.pending.any and ahead is not None and ahead.has("noun") and not ahead.has("room"):
            self.pending.sides = sides
            return
        back = self.tokens[max(0, self.at - 5) : self.at - 1]
        named = next((t for t in reversed(back) if t.has("noun", "room") or t.text in (".", "and", "room")), None)
        if named is not None and named.has("noun") and not named.has("room") and self.last and self._furniture(sides):
            give_sides(self.last[-1], sides)
            return
        self.out.sides.append(sides)

    def _furniture(self, sides: tuple[float, ...]) -> bool:
        """Whether sides [m] may be those of the thing just named."""
        size = categories()[self.last[-1].category].size
        return size is not None and max(sides[:2]) <= 2 * max(size.depth[1], size.width[1])
