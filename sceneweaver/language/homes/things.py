"""What is to be in rooms, what is not, and how they are to look, as measured in rooms that are furnished."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache

from sceneweaver.home import HomeRoom
from sceneweaver.language.model import SceneGraph

from .measured import MeasuredHome
from .model import HomeDemand, HomeRequest, RoomAsked, Status
from .places import place


def things(request: HomeRequest, measured: MeasuredHome) -> Iterator[HomeDemand]:
    """What is to be in rooms, and what is not, by the categories that its words name; nothing in a home without things.

    A wish that names no thing, and what of a wish is not read, is a demand that was not understood.
    """
    if not any(room.scene is not None for room in measured.home.rooms):
        return
    said = set[str]()
    phrases = [one.words.lower() for one in request.unread]
    for room in request.rooms:
        there = place(room.id, request, measured)
        have = [] if there is None or there.scene is None else [thing.category for thing in there.scene.objects]
        for wish in room.wishes:
            for one in _wished(room, wish, there, have):
                told = one.words in said or any(wish in words for words in phrases)
                if one.status != "not understood" or not told:
                    yield one
                said.add(one.words)
        for words in room.unwanted:
            barred = {entity.category for entity in graph_of(f"a room with a {words}").entities}
            found = [name for name in barred if name in have]
            status: Status = "not understood" if not barred else "not met" if found else "met"
            yield HomeDemand("thing", f"{room.id}: no {words}", status, ", ".join(found) or "none")


def _wished(room: RoomAsked, wish: str, there: HomeRoom | None, have: list[str]) -> Iterator[HomeDemand]:
    graph = graph_of(in_a_room(wish))
    wanted = dict.fromkeys((entity.category for entity in graph.entities), 0)
    for entity in graph.entities:
        wanted[entity.category] += entity.count[0] if entity.count is not None else 1
    if wanted:
        whole = all(have.count(name) >= least for name, least in wanted.items())
        status: Status = "met" if whole else "partly" if any(name in have for name in wanted) else "not met"
        counted = ", ".join(f"{have.count(name)} {name}" for name in wanted)
        missing = "no such room" if there is None else "nothing stands in it" if there.scene is None else ""
        yield HomeDemand("thing", f"{room.id}: {wish}", status, missing or counted)
    for words in unread_of(wish):
        yield HomeDemand("words", words, "not understood", f"in what {room.id} is to have")


def unread_of(wish: str) -> list[str]:
    """What of a wish the reader of rooms makes nothing of; all of it where it makes nothing of any."""
    graph = graph_of(in_a_room(wish))
    if graph.unread:
        return [f"{wish} ({', '.join(one.words for one in graph.unread)})"]
    return []


def in_a_room(wish: str) -> str:
    """A wish as a request for a room."""
    return f"a room {wish}" if wish.split()[0] in ("with", "for", "where", "that", "of", "in", "to") else wish


@lru_cache(maxsize=512)
def graph_of(words: str) -> SceneGraph:
    """What the reader of rooms makes of words."""
    from sceneweaver.language.read import read_request

    return read_request(words)
