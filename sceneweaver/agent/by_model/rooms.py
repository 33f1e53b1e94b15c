"""Kinds of rooms that nobody described: a model writes one down, it is tried out, and kept for offline use after."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

from sceneweaver.agent.executor import Executor
from sceneweaver.agent.loop import empty_scene
from sceneweaver.agent.settings import Settings
from sceneweaver.assets import Library
from sceneweaver.assets.sources.parametric import ParametricSource
from sceneweaver.generate.room_rules import check_room
from sceneweaver.io import own_folder, read_bytes, require_no_link, write_atomic
from sceneweaver.io.messages import shorten
from sceneweaver.knowledge import RoomType, match_room, room_type
from sceneweaver.knowledge.learned import keep_room, know, named_in, room_file, rooms_apart, rooms_of
from sceneweaver.knowledge.load import room_words
from sceneweaver.knowledge.room_files import LARGEST, plain, read_room, room_text, slug
from sceneweaver.language import SceneGraph
from sceneweaver.language.vocabulary import vocabulary as known_phrases
from sceneweaver.llm import ModelClient
from sceneweaver.scene import InputError, Scene, SceneWeaverError
from sceneweaver.tools.base import Context
from sceneweaver.tools.init_llm import compact, drawn, instructions, vocabulary
from sceneweaver.tools.room_reply import RoomReply, kind_data

from .scene_text import prompt

RETRIES = 5
"""Times that a model is told what is wrong with a room."""

TRIAL = Settings(device="cpu", candidates=24, generations=0, choice=False, attempts=(2, 4))
"""How the example of a room is laid out."""

PROBLEMS = 5
"""Problems of an example that are told."""

ROOMS, ROOM = "rooms", "room.yaml"
"""In the records of a run: what was known of rooms that it names when it began, and what it learned."""


@dataclass(frozen=True)
class Learned:
    """A kind of room, with the text of its file."""

    room: RoomType
    text: str


def learned_room(client: ModelClient, words: str, folder: Path | None = None, *, keep: bool = True) -> RoomType:
    """The kind of room that words name: a known one, else one that a model writes down.

    Args:
        client: whom to ask.
        words: such as "mountain hut".
        folder: of the run's records; gets a copy of what is learned.
        keep: whether it is kept for later.

    Raises:
        ModelError: when the model writes nothing that can be drawn, laid out and judged valid.
        InputError: for words that are no name.
    """
    found = match_room(words)
    if found is not None:
        return room_type(found[0])
    made = learn(client, words)
    if folder is not None:
        folder.parent.mkdir(parents=True, exist_ok=True)
        write_atomic(own_folder(folder) / ROOM, made.text, within=folder.parent)
    if keep:
        keep_room(made.text)
    know(made.room)
    return made.room


def learn(client: ModelClient, words: str) -> Learned:
    """What a model writes down of a kind of room; an example of it was drawn, laid out and judged valid.

    Raises:
        ModelError: when it writes nothing such.
        InputError: for words that are no name, or that name something already.
    """
    name = slug(words)
    if meant := _known(plain(words)):
        raise InputError(f"room: '{shorten(words)}' is known already, as {meant}; give it another name")

    def learned(reply: RoomReply) -> Learned:
        said = kind_data(reply, name, _words(reply.words, name), f"written by the language model {client.name}"[:120])
        text = room_text(said)
        return Learned(read_room(text), text)

    def check(reply: RoomReply) -> None:
        room = learned(reply).room
        check_room(room)
        check_example(room)

    task = {"kind_of_room": shorten(words, 60)}
    said = client.ask(
        "room",
        RoomReply,
        f"{instructions()}\n{prompt('room_kind')}",
        [f'{{"task":{compact(task)},\n"words":{vocabulary()}}}'],
        check=check,
        retries=RETRIES,
    )
    return learned(said)


def check_example(room: RoomType) -> None:
    """Draw a room of the kind, lay it out on the CPU and judge it.

    Raises:
        InputError: with what is wrong with the example, in words that mend the room.
    """
    brief = SceneGraph(text=f"a {room.name.replace('_', ' ')}", room_type=room.name)
    empty = empty_scene(brief, room)
    context = Context(brief, room, empty, Library(sources=[ParametricSource()]), 0, brief.text)
    proposal = drawn(context, room, {})
    if proposal.unmet:
        raise InputError(f"the room cannot be drawn in full: {'; '.join(proposal.unmet[:PROBLEMS])}")
    try:
        outcome = Executor(room, brief, TRIAL, context.library).run(empty, proposal, seed=0)
    except SceneWeaverError:
        raise
    except Exception as error:  # anything may stand in what a model wrote
        raise InputError(f"an example cannot be laid out ({type(error).__name__}); write it more simply") from error
    lost = _lost(room, proposal.scene or empty, outcome.scene)
    if outcome.report.valid and not lost:
        return
    area = room.area[1]
    said = [f"{name} has no place" for name in lost]
    said += [shorten(v.detail, 160) for v in outcome.report.violations if v.hard][:PROBLEMS]
    said += [f"{d.id}: {d.reason}" for d in outcome.scene.dropped][: PROBLEMS - len(said)]
    raise InputError(
        f"an example of it with {area:g} m2 cannot be laid out: {'; '.join(said)}; "
        "name less, make relations soft, or give a larger area"
    )


def _lost(room: RoomType, before: Scene, after: Scene) -> list[str]:
    """Items of which nothing is left: those that are needed, and what is usual outside of groups, which give way."""
    had, left = ({o.intent.program_item for o in scene.objects} for scene in (before, after))
    kept = [i for i in room.items if i.need == "needed" or (i.need == "usual" and i.group is None)]
    return [i.id for i in kept if i.id in had - left]


@contextmanager
def rooms_of_run(text: str, own: Path | None, replayed: Path | None = None) -> Iterator[None]:
    """Within it a run knows the learned rooms that it knew when it began, whatever was learned or forgotten since.

    Args:
        text: the request.
        own: folder of the run's records; those of its rooms that the request names are copied there when it begins.
        replayed: folder of the records of a run that is replayed.
    """
    began = replayed or (own if own is not None and (own / ROOMS).is_dir() else None)
    with rooms_of(began / ROOMS) if began is not None else rooms_apart():
        if own is not None and began == own:
            for place in (own / ROOMS, *(own / ROOMS).iterdir(), own / ROOM):
                require_no_link(place)
            _known_again(own / ROOM)
        if own is not None and own != began:
            own.parent.mkdir(parents=True, exist_ok=True)
            own_folder(own_folder(own) / ROOMS)
            for room in named_in(text):
                write_atomic(own / ROOMS / f"{room.name}.yaml", room_file(room.name), within=own.parent)
        yield


def _known_again(file: Path) -> None:
    """Know the room that a run learned before it was broken off."""
    with suppress(InputError, UnicodeDecodeError, FileNotFoundError):
        know(read_room(read_bytes(file, max_bytes=LARGEST).decode()))


def _known(word: str) -> str:
    """What a phrase means already, a kind of room or a thing; empty where it means nothing."""
    if word in room_words():
        return room_words()[word]
    kinds = known_phrases().get(word, {})
    return "/".join(sorted(kinds)) if kinds else ""


def _words(words: Sequence[str], name: str) -> list[str]:
    """The other names of a room that mean nothing else."""
    found = [plain(word)[:40] for word in words]
    return [w for w in dict.fromkeys(found) if w and w != name.replace("_", " ") and not _known(w) and w.isascii()]
