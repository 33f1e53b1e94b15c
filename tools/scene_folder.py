"""A folder of scenes, of ours or of other systems, as a library: an index beside the files, kept and renewed."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import ClassVar, Literal

from pydantic import Field

from sceneweaver.importers import AUTO, format_of
from sceneweaver.io import parse_json, read_bytes, write_atomic
from sceneweaver.io.messages import shorten, suggest
from sceneweaver.knowledge import match_room
from sceneweaver.knowledge.library import SceneCard, card_of
from sceneweaver.knowledge.likely import likeliest_room
from sceneweaver.scene import InputError
from sceneweaver.scene.base import FrozenModel

from .scene_files import GivenScene, is_damaged, scenes_in

INDEX = "sceneweaver-index.json"
"""The file beside the scenes that says what they hold."""

MOST_FILES, MOST_SCENES, DEEP = 20_000, 2_000, 3
"""Files of a folder, scenes of a file, and levels of folders that are looked at, at most."""

TOLD = 3
"""Damaged files that are named one by one."""

OF_RUNS = frozenset(("steps", "views", "llm", "meshes", "textures"))
"""Folders that a design writes beside its scene, whose files are no scenes of their own."""

_CAMEL = re.compile(r"(?<=[a-z])(?=[A-Z])|[^A-Za-z]+")


class Indexed(FrozenModel):
    """What a file was when it was read, and the scenes in it; ``broken`` says in a line why there is none."""

    file: str
    size: int
    changed: int = Field(description="When it was last written [ns]")
    cards: tuple[SceneCard, ...] = ()
    broken: str = ""


class Index(FrozenModel):
    """What the index of a folder holds."""

    _noun: ClassVar[str] = "index"

    schema_: Literal["sceneweaver.scene-index/1"] = Field(alias="schema", default="sceneweaver.scene-index/1")
    files: tuple[Indexed, ...] = ()


@dataclass(frozen=True)
class SceneFolder:
    """The scenes of a folder.

    Attributes:
        place: the folder.
        cards: what each scene holds; names are paths inside the folder without ``.json``, with ``#k`` or ``#room``
            behind where a file has several.
        left_out: a line for each of the first damaged files, and one that counts the others.
    """

    place: Path
    cards: tuple[SceneCard, ...]
    left_out: tuple[str, ...]

    def load(self, name: str) -> GivenScene:
        """The scene of a card's name with what was assumed of it.

        Raises:
            InputError: there is none of that name, or its file is damaged by now.
        """
        card = next((card for card in self.cards if card.name == name), None)
        if card is None:
            raise InputError(f"library: there is no scene '{name}'{suggest(name, [card.name for card in self.cards])}")
        for file in _files(self.place):
            stem = _stem(self.place, file)
            if name == stem or name.startswith(f"{stem}#"):
                return scene_named(file, card)
        raise InputError(f"library: the file of scene '{name}' is gone")


def scene_folder(place: str | Path) -> SceneFolder:
    """The scenes of a folder, by its index as far as that is as old as the files.

    Files are read once: what is found is written into ``sceneweaver-index.json`` in the folder, where that can be
    written, and read from there until the size or the date of a file changes. A damaged file costs a line, a file that
    is no scene nothing.

    Raises:
        InputError: there is no such folder, or it holds more files than can be looked at.
    """
    folder = Path(place)
    if not folder.is_dir():
        raise InputError(f"folder: '{folder}' is no folder; give one that holds scenes")
    old = {row.file: row for row in _kept(folder).files}
    rows: list[Indexed] = []
    try:
        for file in _files(folder):
            rows.append(_row(folder, file, old.get(str(file.relative_to(folder)))))
    finally:  # when time is up in the middle, the next one goes on from here
        if rows and {row.file: row for row in rows} != old:
            with suppress(InputError):  # a folder that cannot be written is read again each time
                text = Index(files=tuple(rows)).model_dump_json(by_alias=True, exclude_defaults=False)
                write_atomic(folder / INDEX, text + "\n", within=folder)
    broken = [f"{row.file}: {row.broken}" for row in rows if row.broken]
    told = [f"left out: {line}" for line in broken[:TOLD]]
    if len(broken) > TOLD:
        told.append(f"left out: {len(broken) - TOLD} more files that are damaged")
    return SceneFolder(folder, tuple(card for row in rows for card in row.cards), tuple(told))


def kind_named(words: str, categories: tuple[str, ...] = ()) -> str:
    """The kind of room that a system's own word for it means ("LivingDiningRoom-3421"), else that such things tell."""
    spoken = [part.lower() for part in _CAMEL.split(words) if part]
    for length in range(len(spoken), 0, -1):
        for start in range(len(spoken) - length + 1):
            found = match_room(" ".join(spoken[start : start + length]))
            if found is not None and found[1] == 1.0:
                return found[0]
    for word in spoken:  # "masterbedroom": both parts, else the last one
        cuts = range(2, len(word) - 2)
        for text in (*(f"{word[:k]} {word[k:]}" for k in cuts), *(word[k:] for k in cuts)):
            found = match_room(text)
            if found is not None and found[1] == 1.0:
                return found[0]
    likely = likeliest_room(categories)
    return likely.name if likely is not None else "_".join(spoken) or "room"


def _row(folder: Path, file: Path, old: Indexed | None) -> Indexed:
    """What a file holds: as the index says, or as it says itself."""
    name = str(file.relative_to(folder))
    size, changed = _state(file)
    if old is not None and (old.size, old.changed) == (size, changed):
        return old
    cards, lost, broken = list[SceneCard](), list[str](), ""
    try:
        cards = cards_in(_stem(folder, file), file, on_error=lost.append)
    except InputError as error:
        if is_damaged(file):
            lost.append(str(error))
    if lost:
        more = f" (and {len(lost) - 1} more)" if len(lost) > 1 else ""
        broken = shorten(lost[0].removeprefix(f"{file}: "), 200) + more
    return Indexed(file=name, size=size, changed=changed, cards=tuple(cards), broken=broken)


def _state(path: Path) -> tuple[int, int]:
    """Size [bytes] of a file, or of all in a folder that is one scene, and when the last of it was written [ns]."""
    found = [path, *sorted(path.rglob("*"))] if path.is_dir() else [path]
    states = [one.lstat() for one in found[:MOST_FILES]]
    return sum(state.st_size for state in states), max(state.st_mtime_ns for state in states)


def card_for(name: str, one: GivenScene) -> SceneCard:
    """What a scene holds, in words of both systems."""
    scene = one.scene
    card = card_of(name, scene.model_dump(mode="json", by_alias=True))
    if not one.source:
        return card
    origin = scene.provenance.get("imported")
    labels = origin.get("objects", {}) if isinstance(origin, Mapping) else {}
    words = {str(row.get("label", "")) for row in labels.values() if isinstance(row, Mapping)}
    text = shorten(" ".join(sorted(words)).replace("_", " "), 2000)
    kind = kind_named(scene.room.type, tuple(card.categories))
    return card.model_copy(update={"room": kind, "source": one.source, "text": text})


def cards_in(
    stem: str, file: Path, source: str = AUTO, on_error: Callable[[str], None] | None = None
) -> list[SceneCard]:
    """What the scenes of a file hold, under names of their own.

    Raises:
        InputError: it holds none, or is damaged and nobody hears of it.
    """
    found = [
        card_for(one.name, one) for one in islice(scenes_in(file, source, plain=True, on_error=on_error), MOST_SCENES)
    ]
    if len(found) == 1:
        return [found[0].model_copy(update={"name": stem, "part": found[0].name})]
    many, seen, cards = Counter(card.name for card in found), Counter[str](), list[SceneCard]()
    for k, card in enumerate(found):
        part, nth = card.name, seen[card.name]
        seen[part] += 1
        own = f"{part or k}-{nth}" if many[part] > 1 and part else str(part or k)
        cards.append(card.model_copy(update={"name": f"{stem}#{own}" if stem else own, "part": part, "nth": nth}))
    return cards


def scene_named(file: Path, card: SceneCard, source: str = AUTO) -> GivenScene:
    """The scene of a card, with its furniture.

    Raises:
        InputError: the file is damaged, or does not hold it any more.
    """
    lost = list[str]()
    found = scenes_in(file, source, part=card.part or None, on_error=lost.append)
    one = next(islice(found, card.nth, None), None)
    if one is None:
        raise InputError(lost[0] if lost else f"{file}: it does not hold scene '{card.name}' any more")
    return one


def _kept(folder: Path) -> Index:
    """The index that is there; an empty one where there is none that can be read."""
    path = folder / INDEX
    if not path.is_file():
        return Index()
    try:
        return Index.model_validate(parse_json(read_bytes(path, within=folder)))
    except (InputError, ValueError):
        return Index()


def _files(folder: Path) -> list[Path]:
    """Files that may hold scenes, in order: of a run its scene alone."""
    found: list[Path] = []
    waiting = [(folder, 0)]
    while waiting:
        place, deep = waiting.pop()
        inner = sorted(place.iterdir())
        own = {path.name for path in inner}
        run = "scene.json" in own and bool(own & {"metrics.json", "state.json", "repair.json"})
        for path in inner:
            if path.name.startswith(".") or path.is_symlink():
                continue
            if path.is_dir():
                if _is_one_scene(path):
                    found.append(path)
                elif deep < DEEP and not run and path.name not in OF_RUNS:
                    waiting.append((path, deep + 1))
            elif path.is_file() and path.name not in (INDEX, "index.json") and (not run or path.name == "scene.json"):
                found.append(path)
        if len(found) > MOST_FILES:
            raise InputError(f"folder: '{folder}' holds more than {MOST_FILES} files; give a folder with fewer")
    return sorted(found)


def _is_one_scene(folder: Path) -> bool:
    """Whether an importer reads a folder as a whole."""
    try:
        format_of(folder)
    except InputError:
        return False
    return True


def _stem(folder: Path, file: Path) -> str:
    path = file.relative_to(folder)
    named = path.parent if path.name == "scene.json" and path.parent != Path() else path.with_suffix("")
    if file.is_dir():
        named = path
    return named.as_posix()
