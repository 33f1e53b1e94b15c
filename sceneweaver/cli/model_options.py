"""Options of commands that may ask a model. Keys are read from the environment alone: no option takes one."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

if TYPE_CHECKING:
    from sceneweaver.agent import Result

PANEL = "Models"


class Reader(StrEnum):
    """Who reads a request."""

    RULES = "rules"
    LLM = "llm"


class Critic(StrEnum):
    """Who grades a scene."""

    SYMBOLIC = "symbolic"
    VLM = "vlm"


Model = Annotated[
    str | None,
    typer.Option(
        metavar="MODEL",
        help="openai:NAME, anthropic:NAME, or a name at --base-url (default: $SCENEWEAVER_MODEL).",
        rich_help_panel=PANEL,
        show_default=False,
    ),
]
NamedModel = Annotated[
    str | None,
    typer.Option(
        metavar="MODEL",
        help="That design may ask: openai:NAME, anthropic:NAME, or a name at --base-url (default: none).",
        rich_help_panel=PANEL,
        show_default=False,
    ),
]
BaseUrl = Annotated[
    str | None,
    typer.Option(
        metavar="URL",
        help="Of a server for chat completions (default: $SCENEWEAVER_BASE_URL). Keys come from the environment.",
        rich_help_panel=PANEL,
        show_default=False,
    ),
]
ReaderOption = Annotated[
    Reader | None,
    typer.Option("--reader", help="Who reads the request (default: as --planner).", rich_help_panel=PANEL),
]
CriticOption = Annotated[
    Critic | None,
    typer.Option(
        "--critic",
        help="Who grades: by rules, or by looking at pictures as well (default: as --planner).",
        rich_help_panel=PANEL,
    ),
]
Samples = Annotated[
    int, typer.Option(min=1, max=16, help="How often the critic looks at a scene.", rich_help_panel=PANEL)
]
Stream = Annotated[
    bool | None,
    typer.Option("--stream/--no-stream", help="Whether replies come in pieces.", rich_help_panel=PANEL),
]
MaxCalls = Annotated[
    int | None,
    typer.Option(min=0, metavar="N", help="Requests at most.", rich_help_panel=PANEL, show_default=False),
]
MaxTokens = Annotated[
    int | None,
    typer.Option(min=0, metavar="N", help="Tokens at most, in and out.", rich_help_panel=PANEL, show_default=False),
]
MaxCost = Annotated[
    float | None,
    typer.Option(min=0.0, metavar="SUM", help="Cost at most, by --prices.", rich_help_panel=PANEL, show_default=False),
]
PriceFile = Annotated[
    Path | None,
    typer.Option(
        "--prices", metavar="FILE", help="YAML table of what tokens cost.", rich_help_panel=PANEL, show_default=False
    ),
]
MemoryLength = Annotated[
    int | None,
    typer.Option(
        min=0,
        max=100,
        help="Last steps that the planner is told of (default: 1).",
        rich_help_panel=PANEL,
        show_default=False,
    ),
]
Replay = Annotated[
    Path | None,
    typer.Option(
        metavar="DIR",
        help="Make the design in this folder again from its records, without a network; PROMPT may be left out.",
        rich_help_panel=PANEL,
        show_default=False,
    ),
]
Strict = Annotated[
    bool,
    typer.Option(
        "--strict", help="End with code 4 where the model cannot be asked, not go on by rules.", rich_help_panel=PANEL
    ),
]


def model_arguments(
    *,
    model: str | None,
    base_url: str | None,
    reader: Reader | None,
    critic: Critic | None,
    samples: int,
    stream: bool | None,
    max_calls: int | None,
    max_tokens: int | None,
    max_cost: float | None,
    prices: Path | None,
    memory_length: int | None,
    replay: Path | None,
    strict: bool,
) -> dict[str, Any]:
    """The arguments of ``design`` that these options mean.

    Raises:
        InputError: for a price table that cannot be read.
    """
    given: dict[str, Any] = {"model": model, "base_url": base_url, "samples": samples, "stream": stream}
    given |= {"reader": reader and reader.value, "critic": critic and critic.value, "replay": replay, "strict": strict}
    if memory_length is not None:
        given["memory_length"] = memory_length
    if prices is not None or (max_calls, max_tokens, max_cost) != (None, None, None):
        from sceneweaver.llm import Limits, Prices

        given["limits"] = Limits(calls=max_calls, tokens=max_tokens, cost=max_cost)
        given["prices"] = Prices.load(prices) if prices is not None else None
    return given


def request_of(prompt: str, replay: Path | None) -> str:
    """The request; only a replay can do without.

    Raises:
        InputError: when it is missing.
    """
    from sceneweaver.scene import InputError

    if not prompt and replay is None:
        raise InputError("prompt: is missing; say what room to make, as in: sceneweaver design 'a bedroom' --out out")
    return prompt


def announce(planner: str, given: dict[str, Any]) -> None:
    """Say on stderr which model will do what.

    Raises:
        MissingDependencyError: when a model is needed and none is configured.
    """
    if given["replay"] is not None:
        typer.echo(f"made again from the records in {given['replay']}", err=True)
        return
    with_model = planner == "llm"
    done = {
        "plans": with_model,
        "reads the request": (given["reader"] or planner) == "llm",
        "looks at scenes": given["critic"] == "vlm" or (with_model and given["critic"] is None),
    }
    doing = [words for words, does in done.items() if does]
    if doing:
        from sceneweaver.llm import Endpoint

        endpoint = Endpoint.of(given["model"], given["base_url"], stream=given["stream"])
        typer.echo(f"model {endpoint.title} at {endpoint.url}: {', '.join(doing)}", err=True)


def told(result: Result) -> None:
    """What a model did, on stdout."""
    models = result.models
    if models is None:
        return
    usage, steps = models.usage, len(models.planned)
    by_model = sum(who != "rules" for who in models.planned)
    cost = "" if usage["cost"] is None else f", {usage['cost']:.4g} {usage['currency']}".rstrip()
    tokens = usage["tokens_in"] + usage["tokens_out"]
    planned = f"planned {by_model} of {steps} steps, " if models.roles.planner == "llm" else ""
    typer.echo(f"  model   {models.name}: {planned}{usage['calls']} calls, {tokens} tokens{cost}")
    for text in models.disagreements:
        typer.echo(f"  read    {text}")
