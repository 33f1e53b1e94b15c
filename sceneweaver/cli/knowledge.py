"""``sceneweaver knowledge``: the commands with their options."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from .model_options import BaseUrl, Model
from .options import Json

knowledge = typer.Typer(name="knowledge", help="Kinds of rooms: those that are known, and others that a model learns.")

Words = Annotated[
    str, typer.Argument(metavar="NAME", help='What such a room is called, as "mountain hut".', show_default=False)
]


@knowledge.command()
def learn(
    words: Words,
    model: Model = None,
    base_url: BaseUrl = None,
    record: Annotated[
        Path | None,
        typer.Option(metavar="DIR", help="Keep questions and answers here.", show_default=False),
    ] = None,
    replay: Annotated[
        Path | None,
        typer.Option(metavar="DIR", help="Answer from these records instead, without a network.", show_default=False),
    ] = None,
    out: Annotated[
        Path | None,
        typer.Option("--out", "-o", metavar="FILE", help="Write the room here as well.", show_default=False),
    ] = None,
    as_json: Json = False,
) -> int:
    """Have a model write down a kind of room, try it out, and keep it for offline use after."""
    from .knowledge_runs import run_learn

    return run_learn(words, model=model, base_url=base_url, record=record, replay=replay, out=out, as_json=as_json)


@knowledge.command("list")
def list_rooms(as_json: Json = False) -> int:
    """List the kinds of rooms that are known, learned ones first."""
    from .knowledge_runs import run_list

    return run_list(as_json=as_json)


@knowledge.command()
def show(words: Words, as_json: Json = False) -> int:
    """Say what such a room holds."""
    from .knowledge_runs import run_show

    return run_show(words, as_json=as_json)


@knowledge.command()
def forget(words: Words, as_json: Json = False) -> int:
    """Remove a room that was learned, for good."""
    from .knowledge_runs import run_forget

    return run_forget(words, as_json=as_json)
