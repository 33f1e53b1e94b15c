"""A model that has answered already: a file or a folder of its outputs, of which the fitting one is taken."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from sceneweaver.knowledge.library import SceneCard
from sceneweaver.knowledge.scene_words import text_likeness
from sceneweaver.scene import InputError

from .scene_files import GivenScene, scenes_in
from .scene_folder import card_for, scene_folder
from .scene_model import SceneRequest


@dataclass(frozen=True)
class ModelOutputs:
    """Answers with the scene that a model made for a request.

    That is the one whose prompt is the request, else a file called like it, else among those of the kind of room the
    one whose words are most alike: its prompt and what is in it.

    Attributes:
        path: a file, or a folder.
        source: the format; "auto" looks at each file.
        name: the only scene that is meant, by its name in the file or folder.
    """

    path: Path
    source: str = "auto"
    name: str = ""

    def generate(self, request: SceneRequest) -> Any:
        """The scene as the importers read it, with a note on why it is this one; InputError where there is none."""
        return self._of_folder(request) if self.path.is_dir() and self.source == "auto" else self._of_file(request)

    def _of_folder(self, request: SceneRequest) -> GivenScene:
        folder = scene_folder(self.path)
        cards = [card for card in folder.cards if not self.name or card.name == self.name]
        if not cards:
            lost = f"; {folder.left_out[0]}" if folder.left_out else ""
            raise InputError(f"{self.path} holds no scene{f' {self.name!r}' if self.name else ''}{lost}")
        card, why = chosen(cards, request)
        one = folder.load(card.name)
        return GivenScene(one.scene, card.name, one.source, (*folder.left_out, why, *one.notes))

    def _of_file(self, request: SceneRequest) -> GivenScene:
        found = [one for one in scenes_in(self.path, self.source) if not self.name or one.name == self.name]
        if not found:
            raise InputError(f"{self.path} holds no scene{f' {self.name!r}' if self.name else ''}")
        if len(found) == 1:
            return found[0]
        cards = [card_for(str(k), one) for k, one in enumerate(found)]
        card, why = chosen(cards, request)
        one = found[int(card.name)]
        return GivenScene(one.scene, one.name, one.source, (why.replace(f"'{card.name}'", f"'{one.name}'"), *one.notes))


def chosen(cards: list[SceneCard], request: SceneRequest) -> tuple[SceneCard, str]:
    """Of some scenes that which was made for a request, or is nearest to it, and why."""
    text = _plain(request.text)
    for card in cards:
        if _plain(card.prompt) == text:
            return card, f"took '{card.name}', made for this very request"
    for card in cards:
        if _plain(card.name.rpartition("/")[2]) == text:
            return card, f"took '{card.name}', which is called like the request"
    own = [card for card in cards if card.room.replace(" ", "_") == request.kind] or cards
    if len(own) == 1:
        return own[0], f"took '{own[0].name}'"
    alike = text_likeness(request.text, [words_of(card) for card in own])
    best = max(range(len(own)), key=lambda k: (round(alike[k], 9), -k))
    return own[best], f"took '{own[best].name}' of {len(cards)} scenes, {alike[best]:.0%} alike in words"


def words_of(card: SceneCard) -> str:
    """What a scene says of itself: its prompt, its kind of room, and its things, as often as they are there."""
    things = " ".join(" ".join([name.replace("_", " ")] * many) for name, many in card.categories.items())
    return f"{card.prompt} {card.room.replace('_', ' ')} {things} {card.text}"


def _plain(text: str) -> str:
    return " ".join("".join(c if c.isalnum() else " " for c in text.lower()).split())
