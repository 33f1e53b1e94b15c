"""Which request each scene of a data set answers: a function of the specification and the scene's index alone."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

import sceneweaver
from sceneweaver.io import load_csv
from sceneweaver.io.messages import quote, suggest
from sceneweaver.scene import InputError

from .spec import Spec, Weights

ATTEMPT = 0x9E3779B9
"""What lies between the seeds of two attempts at a room (2**32 over the golden ratio)."""


@dataclass(frozen=True)
class Request:
    """One room that a data set asks for. Its layouts are the scenes ``index`` to ``index + layouts - 1``.

    Attributes:
        room: number of the room.
        index: number of its first scene.
        layouts: scenes that are wanted of it.
        prompt: the request in words.
        kind: the kind of room, or the programme of a home, that was drawn; empty for a prompt of a user.
        seed: what all draws of this room follow from.
        clutter: how lived-in it looks, 0 to 1.
        scene: a file of a user whose layouts are wanted; None where a room is drawn.
    """

    room: int
    index: int
    layouts: int
    prompt: str
    kind: str
    seed: int
    clutter: float
    scene: Path | None = None

    def key(self, layout: int) -> str:
        """The name of one of its scenes in the files of a data set."""
        return f"{self.index + layout:08d}"

    def attempt(self, number: int) -> int:
        """The seed of an attempt, counted from 0."""
        return (self.seed + number * ATTEMPT) % 2**32

    def columns(self, attempt: int) -> dict[str, Any]:
        """The columns of a row that follow from the request and the number of the attempt alone."""
        asked = {name: getattr(self, name) for name in ("room", "seed", "prompt", "kind", "clutter")}
        return {**asked, "attempt": attempt, "version": sceneweaver.__version__}


class Requests:
    """The requests of a specification, by number of the room."""

    def __init__(self, spec: Spec, folder: Path = Path()):
        self.spec = spec
        self.folder = folder
        self._prompts = _prompts(spec, folder)
        if spec.product == "homes":
            _require_known(spec)

    def __len__(self) -> int:
        return -(-self.spec.count // self.spec.rooms.layouts)

    def __getitem__(self, room: int) -> Request:
        if not 0 <= room < len(self):
            raise IndexError(room)
        spec = self.spec
        rng = np.random.default_rng([spec.seed, room])
        seed = int(rng.integers(2**32))
        clutter = round(float(rng.uniform(*spec.requests.clutter)), 3)
        kind, prompt, scene = "", "", None
        if spec.requests.scenes is not None:
            scene = self.folder / spec.requests.scenes[room % len(spec.requests.scenes)]
        elif self._prompts is not None:
            prompt = self._prompts[room % len(self._prompts)]
        else:
            kind = _drawn(rng, spec.requests.programmes or spec.requests.kinds or {})
            prompt = _words(spec, kind, rng)
        index = room * spec.rooms.layouts
        return Request(room, index, min(spec.rooms.layouts, spec.count - index), prompt, kind, seed, clutter, scene)

    @property
    def blocks(self) -> int:
        """How many blocks of rooms are made together."""
        return -(-len(self) // self.spec.block)

    def block(self, number: int) -> list[Request]:
        """The rooms of a block."""
        first = number * self.spec.block
        return [self[room] for room in range(first, min(first + self.spec.block, len(self)))]


def _require_known(spec: Spec) -> None:
    """Refuse programmes and a profile that do not ship with the library."""
    from sceneweaver.plans import profile_names, programme_names

    for name in spec.requests.programmes or ():
        if name not in programme_names():
            fix = suggest(name, programme_names(), what="programmes")
            raise InputError(f"requests.programmes: there is no programme {quote(name)}{fix}")
    if spec.of_homes.profile not in profile_names():
        fix = suggest(spec.of_homes.profile, profile_names(), what="profiles")
        raise InputError(f"homes.profile: there is no profile {quote(spec.of_homes.profile)}{fix}")


def _drawn(rng: np.random.Generator, weights: Weights) -> str:
    names = sorted(weights)
    p = np.array([weights[name] for name in names])
    return names[int(rng.choice(len(names), p=p / p.sum()))]


def _words(spec: Spec, kind: str, rng: np.random.Generator) -> str:
    """A request for a kind of room with what was drawn for it."""
    asked = spec.requests
    size, style, people = (_drawn(rng, weights) for weights in (asked.sizes, asked.styles, asked.people))
    words = [w for w in (size, style, kind.replace("_", " ")) if w]
    article = "an" if words[0][0] in "aeiou" else "a"
    text = " ".join([article, *words])
    if kind in asked.area:
        text += f" of {rng.uniform(*asked.area[kind]):.1f} m2"
    return f"{text} for {people}" if people else text


def _prompts(spec: Spec, folder: Path) -> Sequence[str] | None:
    if spec.requests.prompts is not None:
        return spec.requests.prompts
    if spec.requests.prompts_file is None:
        return None
    path = folder / spec.requests.prompts_file
    rows = load_csv(path)
    if not rows or "prompt" not in rows[0]:
        raise InputError(f"{path}: no column 'prompt'; the first line must name the columns")
    return [row["prompt"] for row in rows]
