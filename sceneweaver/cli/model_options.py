"""Options of commands that may ask a model. Keys are read from the environment alone: no option takes one."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from inspect import Parameter
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from sceneweaver.export.formats import FORMATS, USUAL
from sceneweaver.runtime.options import MODELS as PANEL
from sceneweaver.runtime.options import DesignOptions, Option, options_of

from .options import device_name, positive_seconds

if TYPE_CHECKING:
    from sceneweaver.agent import Result

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
CHECKS: dict[str, Callable[..., Any]] = {"device": device_name, "seconds": positive_seconds}
"""Callbacks that check a value."""


def design_parameters() -> list[Parameter]:
    """The options of a design as parameters of a command; which formats there are is known to the exporter."""
    formats = {"help": f"Files for other tools: {', '.join(FORMATS)}, all or none.", "default": ",".join(USUAL)}
    more = {"export": formats}
    rows = options_of(DesignOptions).items()
    return [_parameter(name, kind, option, more.get(name, {})) for name, (kind, option) in rows]


def _parameter(name: str, kind: Any, option: Option, more: Mapping[str, Any]) -> Parameter:
    how = {"help": option.help, **option.command, **more}
    kind, default = how.pop("type", kind), how.pop("default", option.default)
    given = typer.Option(
        *how.pop("flags", ()),
        min=option.least,
        max=option.most,
        callback=CHECKS.get(how.pop("checked", "")),
        rich_help_panel=how.pop("panel", None),
        **how,
    )
    return Parameter(name, Parameter.KEYWORD_ONLY, default=default, annotation=Annotated[kind, given])


def limits_of(
    max_calls: int | None, max_tokens: int | None, max_cost: float | None, prices: Path | None
) -> dict[str, Any]:
    """The limits and prices that these options mean, as arguments of a design; empty where none is given.

    Raises:
        InputError: for a price table that cannot be read.
    """
    if prices is None and (max_calls, max_tokens, max_cost) == (None, None, None):
        return {}
    from sceneweaver.llm import Limits, Prices

    limits = Limits(calls=max_calls, tokens=max_tokens, cost=max_cost)
    return {"limits": limits, "prices": Prices.load(prices) if prices is not None else None}


def request_of(prompt: str, given: Path | str | None) -> str:
    """The request; only a run to replay, or a scene to go on from, that has one can do without.

    Raises:
        InputError: when it is missing.
    """
    from sceneweaver.scene import InputError

    if not prompt and given is None:
        raise InputError("prompt: is missing; say what room to make, as in: sceneweaver design 'a bedroom' --out out")
    return prompt


def announce(given: Mapping[str, Any]) -> None:
    """Say on stderr which model will do what in a design with these options.

    Raises:
        MissingDependencyError: when a model is needed and none is configured.
    """
    if given.get("replay") is not None:
        typer.echo(f"made again from the records in {given['replay']}", err=True)
        return
    planner, critic = given.get("planner"), given.get("critic")
    done = {
        "plans": planner == "llm",
        "reads the request": given.get("reader", planner) == "llm",
        "writes down the room": given.get("init") == "llm",
        "looks at scenes": critic == "vlm" or (planner == "llm" and critic is None),
    }
    doing = [words for words, does in done.items() if does]
    if doing:
        from sceneweaver.llm import Endpoint

        endpoint = Endpoint.of(given.get("model"), given.get("base_url"), stream=given.get("stream"))
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
