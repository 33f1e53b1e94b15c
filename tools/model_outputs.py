"""A model that has answered already: a file or a folder of its outputs, of which the fitting one is taken."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path

from sceneweaver.geometry.polygons import signed_area
from sceneweaver.importers import AUTO
from sceneweaver.knowledge.kin import is_one
from sceneweaver.knowledge.library import SceneCard
from sceneweaver.knowledge.scene_words import text_likeness
from sceneweaver.scene import InputError

from .scene_files import GivenScene
from .scene_folder import cards_in, scene_folder, scene_named
from .scene_model import SceneRequest


@dataclass(frozen=True)
class ModelOutputs:
    """Answers with the scene that a model made for a request.

    That is the one whose prompt is the request, else a file called like it, else among those of the kind of room the
    one with most of what is asked for, whose words are most alike: its prompt and what is in it.

    Attributes:
        path: a file, or a folder.
        source: the format; "auto" looks at each file.
        name: the only scene that is meant, by its name in the file or folder.
    """

    path: Path
    source: str = AUTO
    name: str = ""

    def generate(self, request: SceneRequest) -> GivenScene:
        """The scene as the importers read it, with a note on why it is this one.

        Raises:
            InputError: there is none, or its file is damaged.
        """
        folder, left_out = None, tuple[str, ...]()
        if self.path.is_dir() and self.source == AUTO:
            folder = scene_folder(self.path)
            cards, left_out = list(folder.cards), folder.left_out
        else:
            cards = cards_in("", self.path, self.source)
        cards = [card for card in cards if self.name in ("", card.name, card.part)]
        if not cards:
            lost = f"; {left_out[0]}" if left_out else ""
            raise InputError(f"{self.path} holds no scene{f' {self.name!r}' if self.name else ''}{lost}")
        card, why = chosen(cards, request)
        one = folder.load(card.name) if folder is not None else scene_named(self.path, card, self.source)
        return GivenScene(one.scene, card.name, one.source, (*left_out, *([why] if why else ()), *one.notes))


def chosen(cards: list[SceneCard], request: SceneRequest) -> tuple[SceneCard, str]:
    """Of some scenes that which was made for a request, or is nearest to it, and why."""
    text = _plain(request.text)
    for card in cards:
        if _plain(card.prompt) == text:
            return card, f"took '{card.name}', made for this very request"
    for card in cards:
        if _plain(card.name.rpartition("/")[2]) == text:
            return card, f"took '{card.name}', which is called like the request"
    if len(cards) == 1:
        return cards[0], ""
    own = [card for card in cards if card.room.replace(" ", "_") == request.kind] or cards
    words = text_likeness(request.text, [words_of(card) for card in own])
    scores = [round(word + _fit(card, request), 9) for card, word in zip(own, words, strict=True)]
    best = max(range(len(own)), key=lambda k: (scores[k], -k))
    there = _asked(own[best], request)
    return own[best], (
        f"took '{own[best].name}' of {len(cards)} scenes: {sum(there.values()):g} of {len(there)} kinds of things that "
        f"are asked for, {words[best]:.0%} alike in words"
    )


def _asked(card: SceneCard, request: SceneRequest) -> dict[str, float]:
    """By category that is asked for which share of its number a scene has, 0 to 1."""
    have = card.categories.items()
    return {
        want: min(1.0, sum(many for name, many in have if is_one(name, want, want)) / least)
        for want, least in request.categories.items()
    }


def _fit(card: SceneCard, request: SceneRequest) -> float:
    """How much of what is asked for a scene has, 0 to 1, and where a room is fixed how near its floor comes to that."""
    found = _asked(card, request)
    fit = sum(found.values()) / len(found) if found else 0.0
    if request.room is not None:
        fit += math.exp(-1.5 * abs(math.log(max(card.area, 1e-6) / signed_area(request.room.outline))))
    return fit


def words_of(card: SceneCard) -> str:
    """What a scene says of itself: its prompt, its kind of room, and its things, as often as they are there."""
    things = " ".join(" ".join([name.replace("_", " ")] * many) for name, many in card.categories.items())
    return f"{card.prompt} {card.room.replace('_', ' ')} {things} {card.text}"


def _plain(text: str) -> str:
    return " ".join("".join(c if c.isalnum() else " " for c in text.lower()).split())
