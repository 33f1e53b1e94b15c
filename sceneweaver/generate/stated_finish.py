"""What a request says in words of the floor, the walls and the woods of its room."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any, cast

from sceneweaver.assets.materials import color_named, finishes
from sceneweaver.knowledge.load import data_of
from sceneweaver.scene import InputError
from sceneweaver.scene.finish import FloorFinish, FloorMaterial

_WORDS = r"(?:[a-z-]+ ){0,3}?[a-z-]+"
_BEFORE = re.compile(r"(?P<words>(?:[a-z-]+ ){0,3}[a-z-]+) (?P<what>walls?|floors?|flooring)\b")
_AFTER = re.compile(
    rf"(?P<what>walls?|floor|flooring)(?:,|:)? (?:(?:are|is|be|in|of|painted|should|must|a|the|all|covered|with) )+"
    rf"(?P<words>{_WORDS})(?=[,.;!?\n]| and | with |$)"
)
LONGEST = 3
"""Words of a colour or a material at most."""


@dataclass(frozen=True)
class StatedFinish:
    """What is said: a colour of the walls and of an accent wall, whether they are panelled, the floor, woods."""

    walls: str | None = None
    accent: str | None = None
    panelled: bool = False
    floor: FloorFinish | None = None
    woods: tuple[str, ...] = ()


def stated_finish(text: str) -> StatedFinish:
    """What a request says of how its room is finished."""
    low = " ".join(re.sub(r"[^\w\s,.;:!?-]", " ", text.lower()).split())
    walls = accent = None
    floor: FloorFinish | None = None
    panelled = any(re.search(rf"\b{re.escape(word)}\b", low) for word in _data()["panelled"])
    for match in (*_BEFORE.finditer(low), *_AFTER.finditer(low)):
        words = [word for word in match["words"].replace("-", " ").split() if word not in ("painted", "and")]
        if match["what"].startswith("floor"):
            floor = floor or _floor(words)
        elif words and words[-1] in ("accent", "feature") and match["what"] == "wall":
            accent = accent or _color(words[:-1])
        elif match["what"] == "walls" or match.re is _AFTER:
            material = _material(words)
            panelled = panelled or bool(material.get("panelled"))
            walls = walls or _color(words) or material.get("color")
    for word in _data()["alone"]:
        if floor is None and re.search(rf"\b{word}\b", low):
            floor = _floor([word.removesuffix("s")])
    if _stands_alone("concrete", low):  # "concrete, concrete, concrete": all that is built is of it
        floor, walls = floor or FloorFinish(material="concrete"), walls or _data()["walls"]["concrete"]["color"]
    return StatedFinish(walls, accent, panelled, floor, tuple(_woods_of_room(low)))


def _floor(words: Sequence[str]) -> FloorFinish | None:
    """A floor of what is said before the word; None where that is nothing of which floors are."""
    spoken = " ".join(words)
    wood = next(iter(_woods(spoken)), None)
    known: Any = _data()["floors"]
    for material, row in known.items():
        if any(re.search(rf"\b{re.escape(word)}\b", spoken) for word in row["words"]):
            tone = wood if material == "wood" and wood in _of_family("wood") else None
            bare = [word for word in words if word not in row["words"]]
            tone = tone or (_color(bare) if material != "wood" else None)
            return FloorFinish(material=cast("FloorMaterial", material), tone=tone)
    if wood is not None and wood in _of_family("wood"):
        return FloorFinish(material="wood", tone=wood)
    color = _color(words)
    return FloorFinish(material="tile", tone=color) if color is not None else None


def _color(words: Sequence[str]) -> str | None:
    """The colour that the last words name, the longest that is one."""
    for count in range(min(LONGEST, len(words)), 0, -1):
        name = " ".join(words[-count:])
        try:
            color_named(name)
        except InputError:
            continue
        if name not in ("wood", "wooden"):
            return name
    return None


def _material(words: Sequence[str]) -> dict[str, Any]:
    known: dict[str, dict[str, Any]] = _data()["walls"]
    for count in range(min(LONGEST, len(words)), 0, -1):
        if (row := known.get(" ".join(words[-count:]))) is not None:
            return row
    return {}


def _woods(text: str) -> Iterable[str]:
    """Finishes of wood that a text names, the longest name first, each once."""
    names: dict[str, str] = {**{name: name for name in _of_family("wood")}, **_data()["woods"]}
    found: list[str] = []
    for name in sorted(names, key=len, reverse=True):
        if re.search(rf"\b{re.escape(name)}\b", text):
            text = re.sub(rf"\b{re.escape(name)}\b", " ", text)
            if names[name] not in found:
                found.append(names[name])
    return found


def _woods_of_room(text: str) -> Iterable[str]:
    """Woods that are said of no thing, as "in oak" or "oak furniture" is."""
    for clause in re.split(r"[,.;:!?]| and | with | in ", text):
        words = [word for word in clause.split() if word not in ("everywhere", "all", "furniture", "tones", "details")]
        for wood in _woods(" ".join(words[-2:])):
            named = {wood, *(name for name, meant in _data()["woods"].items() if meant == wood)}
            if any(" ".join(words).endswith(name) for name in named):
                yield wood


def _stands_alone(word: str, text: str) -> bool:
    """Whether a word is said of no thing: it ends its clause."""
    return re.search(rf"(?:^|[,.;:] ?|\band )(?:raw |bare )?{word}(?=[,.;!]| and |$)", text) is not None


@cache
def _of_family(family: str) -> frozenset[str]:
    return frozenset(name for name, finish in finishes().items() if finish.family == family)


def _data() -> Any:
    return data_of("stated_finishes.yaml")
