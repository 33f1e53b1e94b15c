"""``sceneweaver knowledge``: what the commands do."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import typer

from sceneweaver.io import write_atomic
from sceneweaver.io.messages import shorten
from sceneweaver.knowledge import Item, RoomType, match_room, room_type, room_types
from sceneweaver.knowledge.learned import forget_room, keep_room, learned_rooms, room_file
from sceneweaver.knowledge.room_files import slug
from sceneweaver.scene import InputError, MissingDependencyError

from .exit_codes import NOT_VALID
from .output import print_json
from .streams import no_chatter


def run_learn(
    words: str,
    *,
    model: str | None,
    base_url: str | None,
    record: Path | None,
    replay: Path | None,
    out: Path | None,
    as_json: bool,
) -> int:
    """Have a room written down and keep it; 3 when the model wrote none that can be drawn, 4 when none answers."""
    from sceneweaver.llm import BudgetSpent, Endpoint, ModelFailed, ModelUnreachable, open_client

    name = slug(words)
    if name in learned_rooms():
        raise InputError(f"room: {name} is learned already; forget it first: sceneweaver knowledge forget {name}")
    if out is not None and out.is_dir():
        raise InputError(f"--out: {out} is a folder; give a file")
    endpoint = None if replay is not None else Endpoint.of(model, base_url)
    client = open_client(endpoint, records=record, replay=replay)
    failed = ""
    with no_chatter():
        from sceneweaver.agent.by_model.rooms import learn

        try:
            learned = learn(client, words)
        except (ModelUnreachable, BudgetSpent) as error:
            raise MissingDependencyError(str(error)) from None
        except ModelFailed as error:
            learned, failed = None, shorten(str(error), 400)
    if learned is None:
        said = f"the model wrote no {' '.join(words.split())} that can be drawn: {failed}"
        if as_json:
            print_json({"error": said, "exit_code": NOT_VALID})
        typer.echo(f"sceneweaver: {said}", err=True)
        return NOT_VALID
    path = keep_room(learned.text)
    if out is not None:
        write_atomic(out, learned.text)
    files = [str(path), *([str(out)] if out is not None else [])]
    if as_json:
        print_json({"learned": name, "room": _facts(learned.room), "usage": client.usage.to_dict(), "files": files})
        return 0
    typer.echo(f"{name}: learned, {_line(learned.room)}")
    for file in files:
        typer.echo(f"  {file}")
    typer.echo(f'  use it, also offline: sceneweaver design "a {name.replace("_", " ")}" -o out')
    return 0


def run_list(*, as_json: bool) -> int:
    """List all kinds of rooms."""
    rows = [(room, True) for room in learned_rooms().values()] + [(room, False) for room in room_types().values()]
    if as_json:
        print_json({"rooms": [{**_facts(room), "learned": learned} for room, learned in rows]})
        return 0
    for room, learned in rows:
        typer.echo(f"{room.name:<20} {'learned  ' if learned else '         '}{shorten(room.description, 88)}")
    return 0


def run_show(words: str, *, as_json: bool) -> int:
    """Say what a kind of room holds; of a learned one its file."""
    found = match_room(words)
    room = room_type(found[0] if found else words)
    learned = room.name in learned_rooms() and room.name not in room_types()
    if as_json:
        print_json({**_facts(room), "learned": learned, "items": [_item(item) for item in room.items]})
        return 0
    if learned:
        typer.echo(room_file(room.name).rstrip())
        return 0
    typer.echo(f"{room.name}: {room.description} {_line(room)}")
    for item in room.items:
        least, most = item.count.least, item.count.most
        count = str(least) if least == most else f"{least}-{most}"
        typer.echo(f"  {item.id:<18} {item.need:<9} {count:<6} {', '.join(dict.fromkeys(item.what))}")
    return 0


def run_forget(words: str, *, as_json: bool) -> int:
    """Remove a learned room."""
    path = forget_room(words)
    if as_json:
        print_json({"forgotten": path.stem, "files": [str(path)]})
    else:
        typer.echo(f"{path.stem}: forgotten")
    return 0


def _facts(room: RoomType) -> dict[str, Any]:
    return {
        "name": room.name,
        "words": list(room.words),
        "description": room.description,
        "area": list(room.area),
        "sources": list(room.sources),
    }


def _item(item: Item) -> dict[str, Any]:
    return {
        "id": item.id,
        "what": list(dict.fromkeys(item.what)),
        "need": item.need,
        "count": [item.count.least, item.count.most],
        "with": item.with_,
        "place": [place.model_dump() for place in item.place],
    }


def _line(room: RoomType) -> str:
    needed = sum(item.need == "needed" for item in room.items)
    return f"{len(room.items)} kinds of things ({needed} needed) on {room.area[0]:g} to {room.area[2]:g} m2"
