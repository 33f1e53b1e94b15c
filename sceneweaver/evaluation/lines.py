"""Which lines of an annotated request a scene meets, by the critic's measures."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import combinations, islice, product
from typing import Any, NamedTuple

from sceneweaver.assets.taxonomy import members, resolve
from sceneweaver.critic import asked_attributes, asked_relations
from sceneweaver.critic.survey import Survey
from sceneweaver.io import packaged
from sceneweaver.knowledge import match_room, room_type
from sceneweaver.knowledge.kin import kin
from sceneweaver.knowledge.load import plain_room
from sceneweaver.language import Attribute, Entity, SceneGraph, StatedRelation, read_request
from sceneweaver.runtime.deadline import checkpoint
from sceneweaver.scene import Scene
from sceneweaver.verify import Report
from sceneweaver.verify.solids import Body

from .requested import Annotated, Line

MOST_GROUPS = 2000
"""Groups of objects that a relation is tried of."""

ELEMENTS = ("wall", "window", "door", "ceiling", "floor", "room")
"""Parts of a room that lines of OARel name; any other is the name of a room."""

GROUPED = ("around", "between")
"""Relations of which all objects take part at once."""


class Met(NamedTuple):
    """What became of a line: ``holds`` is None where nothing in the scene can tell."""

    line: Line
    holds: bool | None
    found: int = 0


@dataclass(frozen=True, eq=False)
class _Chosen(Survey):
    """A survey in which some objects stand for what is asked, whatever else is there."""

    whole: Survey
    chosen: Mapping[str, Sequence[Body]]

    def standing_for(self, asked: str) -> list[Body]:
        return list(self.chosen.get(asked, ()))

    def footprint(self, body: Body) -> Any:
        return self.whole.footprint(body)

    def kept_gaps(self) -> dict[tuple[int, int], float]:
        return self.whole.kept_gaps()


@cache
def _words() -> Mapping[str, Mapping[str, Mapping[str, str]]]:
    return packaged.parse(packaged.text("sceneweaver.evaluation", "words.yaml"))


def judged(scene: Scene, report: Report, asked: Annotated) -> list[Met]:
    """Each line of a request, judged in a scene made for it."""
    named = match_room(scene.room.type)
    kind = room_type(named[0]) if named is not None else plain_room()
    survey = Survey.of(scene, report, kind, SceneGraph(text=asked.text))
    matched = _matched(asked.categories, survey.bodies)
    found = []
    for line in asked.lines:
        checkpoint()
        found.append(_JUDGES[line.metric](survey, line, matched))
    return found


def fits(category: str, word: str) -> bool:
    """Whether an object of a category is what a word of an annotation names.

    Examples:
        >>> fits("wardrobe", "wardrobe"), fits("office_chair", "chair"), fits("bed", "nightstand")
        (True, True, False)
    """
    return category in _accepted(word) or category.endswith(f"_{resolve(word).category}")


@cache
def _accepted(word: str) -> frozenset[str]:
    match = resolve(word)
    noun = word.replace("_", " ")
    return frozenset((match.category, *members(match.category), *kin(match.category, noun), *_named(noun)))


def _named(noun: str) -> tuple[str, ...]:
    """A group of the taxonomy that is called so has its members."""
    return members(noun.replace(" ", "_"))


def _matched(words: Sequence[str], bodies: Sequence[Body]) -> dict[str, list[Body]]:
    """Each object goes to one of the words at most: the one that names its own category, else the narrowest."""
    found: dict[str, list[Body]] = {word: [] for word in words}
    for body in bodies:
        category = body.item.category
        able = [word for word in words if fits(category, word)]
        if able:
            best = min(able, key=lambda w: (resolve(w).category != category, len(_accepted(w)), words.index(w)))
            found[best].append(body)
    return found


def _count(survey: Survey, line: Line, matched: Mapping[str, list[Body]]) -> Met:
    del survey
    count = len(matched[line.rest[0]])
    return Met(line, line.enough(count), count)


def _attribute(survey: Survey, line: Line, matched: Mapping[str, list[Body]]) -> Met:
    category, *said = line.rest
    bodies = matched.get(category, [])
    if not bodies:
        return Met(line, False)
    good = 0
    for body in bodies:
        answers = [_has(survey, body, category, words) for words in said]
        if any(answer is None for answer in answers):
            return Met(line, None)
        good += all(answers)
    return Met(line, line.enough(good), good)


def _has(survey: Survey, body: Body, category: str, words: str) -> bool | None:
    """Whether an object is as said; None where the reader does not know the words or nothing in the scene tells."""
    attributes, narrower = _read(words, category)
    if narrower is not None and fits(body.item.category, narrower):
        return True
    if not attributes:
        return None
    asked = Entity(id=category, noun=category, category=body.item.category, attributes=attributes)
    found = list(asked_attributes.outcomes(asked, [body], windows=survey.scene.room.windows))
    states = {item.outcome.status for item in found}
    if not states or "not_understood" in states:
        return None
    return states <= {"met"}


@cache
def _read(words: str, category: str) -> tuple[tuple[Attribute, ...], str | None]:
    """What the reader makes of "a <words> <category>": attributes, or a category of its own (a twin bed)."""
    text = f"a room with a {words.replace('_', ' ')} {category.replace('_', ' ')}"
    entities = read_request(text).entities
    if len(entities) != 1:
        return (), None
    entity = entities[0]
    narrower = entity.category if entity.category != resolve(category).category and not entity.attributes else None
    return entity.attributes, narrower


def _between_objects(survey: Survey, line: Line, matched: Mapping[str, list[Body]]) -> Met:
    words, at, *names = line.rest
    names = [name.split(":")[0] for name in names]
    index = int(at) if at.isdigit() and int(at) < len(names) else 0
    needed = {name: names.count(name) for name in names}
    if any(len(matched.get(name, ())) < count for name, count in needed.items()):
        return Met(line, False)
    meant = _words()["objects"].get(words)
    if meant is None:
        return Met(line, None)
    anchor, others = names[index], [name for k, name in enumerate(names) if k != index]
    pools = [list(combinations(matched[name], others.count(name))) for name in dict.fromkeys(others)]
    good = 0
    for one, parts in islice(product(matched[anchor], product(*pools)), MOST_GROUPS):
        checkpoint()
        group = [body for part in parts for body in part]
        if one in group:
            continue
        holds = _holds(survey, meant, one, group)
        if holds is None:
            return Met(line, None)
        good += holds
    wanted = line._replace(number=1) if len(others) > 1 and line.number == len(others) else line
    return Met(line, wanted.enough(good), good)


def _holds(survey: Survey, meant: Mapping[str, str], anchor: Body, others: Sequence[Body]) -> bool | None:
    kind = meant["type"]
    if kind in GROUPED:
        groups = [(others, [anchor])] if kind == "around" else [([anchor], others)]
    else:
        groups = [([anchor], [other]) if meant.get("swap") else ([other], [anchor]) for other in others]
    for subjects, targets in groups:
        said = StatedRelation(id="r", type=kind, subject="a", targets=("b",), side=meant.get("side"))  # pyright: ignore[reportArgumentType]
        holds = _ruled(survey, said, {"a": subjects, "b": targets})
        if holds is not True:
            return holds
    return True


def _to_room(survey: Survey, line: Line, matched: Mapping[str, list[Body]]) -> Met:
    words, category, *rest = line.rest
    element = ",".join(rest)
    bodies = matched.get(category, [])
    if not bodies:
        return Met(line, False)
    meant = _words()["room"].get(words)
    if element not in ELEMENTS:  # a room of a home: this one, or none
        other, own = match_room(element), match_room(survey.scene.room.type)
        here = other is not None and own is not None and other[0] == own[0]
        return Met(line, line.enough(len(bodies) if here else 0))
    if meant is None:
        return Met(line, None)
    good = 0
    for body in bodies:
        target = meant.get("place", element)
        said = StatedRelation(id="r", type=meant["type"], subject="a", targets=(target,))  # pyright: ignore[reportArgumentType]
        holds = _ruled(survey, said, {"a": [body]})
        if holds is None:
            return Met(line, None)
        good += holds
    return Met(line, line.enough(good), good)


def _ruled(survey: Survey, said: StatedRelation, chosen: Mapping[str, Sequence[Body]]) -> bool | None:
    """What the critic says of a relation between chosen objects; None where it cannot be measured."""
    things = tuple(_entities(chosen))
    graph = SceneGraph(text="", entities=things, relations=(said,))
    view = _Chosen(survey.scene, survey.report, survey.room_type, graph, survey.placed, whole=survey, chosen=chosen)
    (item,) = asked_relations.outcomes(view)
    return None if item.outcome.status == "not_understood" else item.outcome.status == "met"


def _entities(chosen: Mapping[str, Sequence[Body]]) -> Iterator[Entity]:
    for name, bodies in chosen.items():
        category = bodies[0].item.category
        yield Entity(id=name, noun=category, category=category, count=(len(bodies), len(bodies)))


_JUDGES = {"CNT": _count, "ATR": _attribute, "OOR": _between_objects, "OAR": _to_room}
