"""Begin with a finished scene, ours or of another system, adapted to the request."""

from __future__ import annotations

import math
import random
from collections.abc import Sequence
from pathlib import Path

from sceneweaver.generate.given_room import with_openings
from sceneweaver.generate.library import CORNERS, adapted, is_of_another_shape
from sceneweaver.knowledge.library import SceneCard, library_scenes, load_scene
from sceneweaver.knowledge.scene_words import text_likeness
from sceneweaver.language import SceneGraph
from sceneweaver.scene import InputError

from .base import Context, Proposal
from .card import checked
from .model_outputs import words_of
from .scene_folder import scene_folder

NEAR_BEST = 0.04
"""Difference of scores within which the seed decides."""


TEXT, KIND = 2.0, 1.0
"""How much the words of a scene from a folder count, and that it is of the very kind that is asked for, beside each
thing that is."""


class InitLibrary:
    """Takes the best matching scene of the library, or of a folder, and makes it what the request says."""

    name = "init_library"

    def propose(self, context: Context) -> Proposal:
        """A whole scene; InputError when the library holds none of that kind of room."""
        inputs = checked(self.name, context.inputs)
        folder, name = inputs.get("folder", context.beginning.scenes), inputs.get("name")
        if folder is not None:
            return self._of_folder(context, Path(folder), name)
        score = ""
        if name is None:
            card, value = _best(library_scenes(), context, "the library")
            name, score = card.name, f", {value:.0%} alike"
        scene, notes, unmet = adapted(context, load_scene(name), self.name, name)
        notes.insert(0, f"begun with the library scene {name}{score}")
        return Proposal(scene=scene, notes=tuple(notes), unmet=tuple(unmet))

    def _of_folder(self, context: Context, place: Path, name: str | None) -> Proposal:
        """One of a user's scenes: what is theirs is kept as far as the request lets it."""
        folder = scene_folder(place)
        score = ""
        if name is None:
            card, value = _best(folder.cards, context, f"folder '{place}'", theirs=True)
            name, score = card.name, f", {value:.0%} alike, of {len(folder.cards)}"
        given = folder.load(name)
        opened, said = with_openings(context, given.scene)
        scene, notes, unmet = adapted(context, opened, self.name, name)
        scene = scene.model_copy(update={"room": scene.room.model_copy(update={"type": context.room_type.name})})
        by = f" ({given.source})" if given.source else ""
        first = (f"begun with the library scene {name}{by}{score}", *folder.left_out, *given.notes, said)
        return Proposal(
            scene=scene,
            fresh=is_of_another_shape(given.scene, context.brief),
            notes=tuple(note for note in (*first, *notes) if note),
            unmet=tuple(unmet),
            origin=given.scene,
        )


def _best(cards: Sequence[SceneCard], context: Context, where: str, *, theirs: bool = False) -> tuple[SceneCard, float]:
    """The card most like what is asked for, among equally good ones by seed.

    Of ``theirs``, scenes of any origin, rooms of a near kind may serve too, and their words count.
    """
    kind = context.room_type.name
    own = [card for card in cards if _kind_of(card) == kind or (theirs and _near(_kind_of(card), kind))]
    if not own:
        raise InputError(f"tool init_library: {where} holds no {kind.replace('_', ' ')}; use init_prior")
    more: list[tuple[tuple[float, float], ...]] = [()] * len(own)
    if theirs:
        words = text_likeness(context.brief.text, [words_of(card) for card in own])
        kinds = [1.0 if _kind_of(card) == kind else 0.0 for card in own]
        more = [((TEXT, word), (KIND, same)) for word, same in zip(words, kinds, strict=True)]
    scored = [(likeness(card, context.brief, terms), card) for card, terms in zip(own, more, strict=True)]
    top = max(score for score, _ in scored)
    pool = sorted((row for row in scored if row[0] >= top - NEAR_BEST), key=lambda row: row[1].name)
    score, card = random.Random(context.seed).choice(pool)
    return card, score


def _kind_of(card: SceneCard) -> str:
    return card.room.replace(" ", "_")


def _near(kind: str, other: str) -> bool:
    """Whether two kinds of rooms are forms of one: a master bedroom and a bedroom."""
    return kind.rpartition("_")[2] == other.rpartition("_")[2]


def likeness(card: SceneCard, brief: SceneGraph, more: Sequence[tuple[float, float]] = ()) -> float:
    """How near a library scene is to a request, 0 to 1: its objects first, then floor, shape, openings and style.

    ``more`` are other weights with what they are of, 0 to 1.
    """
    terms: list[tuple[float, float]] = [(0.5, 1.0), *more]
    for asked in brief.entities:
        least = asked.count[0] if asked.count else 1
        terms.append((1.0, min(1.0, card.categories.get(asked.category, 0) / max(1, least))))
    for category in brief.without:
        terms.append((0.3, 0.0 if category in card.categories else 1.0))
    area = brief.size[0] * brief.size[1] if brief.size is not None else brief.area
    if area:
        terms.append((1.5, math.exp(-1.5 * abs(math.log(card.area / area)))))
    if brief.size is not None:
        own, want = sorted(card.sides, reverse=True), brief.size
        terms.append((1.0, math.exp(-2.0 * abs(math.log((own[0] / own[1]) / (want[0] / want[1]))))))
    if brief.shape is not None:
        terms.append((2.0, 1.0 if card.corners == CORNERS[brief.shape] else 0.0))
    for want, have in ((brief.windows, card.windows), (brief.doors, card.doors)):
        if want is not None:
            terms.append((0.8, 1.0 if want == have else 0.0))
    if brief.people is not None and card.people:
        terms.append((1.0, min(brief.people, card.people) / max(brief.people, card.people)))
    if brief.style is not None:
        terms.append((0.5, 1.0 if brief.style == card.style else 0.0))
    return sum(w * v for w, v in terms) / sum(w for w, _ in terms)
