"""The options of a design: said once, for Python, the command line and the MCP server.

A new one is a row here, and what is done with it.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated, Any, Literal, TypedDict, get_args, get_type_hints

PictureSet = Literal["full", "hero", "none"]
"""Which pictures a design leaves: all, those from above and the best at eye level, or none and no report either."""

MODELS, STARTS = "Models", "Starts"
"""Headings of the options of models, and of what a design begins with, in the help of commands."""

Init = Literal["auto", "library", "model", "llm", "prior"]
"""What begins a room: the planner's choice, a scene of a library, a model's, what a language model writes, or a draft
whose poses the learned prior draws."""


@dataclass(frozen=True)
class Option:
    """What is known of an option besides its type.

    Attributes:
        default: its value where none is given.
        help: what it means, on the command line.
        least: the least value; None: any.
        most: the largest.
        command: its type on the command line, where that differs, and other arguments of ``typer.Option``.
        server: what the MCP server says of it; None: it does not take it.
    """

    default: Any
    help: str = ""
    least: float | None = None
    most: float | None = None
    command: Mapping[str, Any] = field(default_factory=dict)
    server: str | None = None


class DesignOptions(TypedDict, total=False):
    """The options that a design takes from everywhere; their meaning in Python is that of `sceneweaver.design`."""

    seed: Annotated[
        int, Option(0, "Equal seeds give equal results.", 0, 2**32 - 1, server="Equal seeds give equal results")
    ]
    steps: Annotated[int, Option(10, "Steps of the agent at most.", 1, 100, server="Steps of the agent at most")]
    candidates: Annotated[
        int | None,
        Option(
            None,
            "Layouts that are refined for each call of a tool (default: by the device).",
            1,
            command={"show_default": False},
            server="Layouts for each call of a tool; null: by the device",
        ),
    ]
    planner: Annotated[
        Literal["rules", "llm"],
        Option("rules", "Who chooses the tools.", server="llm: if the server has a model"),
    ]
    device: Annotated[
        str, Option("auto", "Where to compute.", command={"metavar": "auto|cpu|cuda[:k|:all]", "checked": "device"})
    ]
    time_limit: Annotated[
        float | Literal["auto"] | None,
        Option(
            "auto",
            "Seconds that all may take, files included (default: 120, with a model 600).",
            command={"type": float | None, "default": None, "show_default": False, "checked": "seconds"},
        ),
    ]
    pictures: Annotated[
        PictureSet | bool,
        Option(
            "full",
            "Views and report: all views; those from above and the best at eye level; or none, and no report.",
            command={"type": PictureSet},
        ),
    ]
    export: Annotated[
        str | Iterable[str] | None,
        Option(
            None,  # the usual ones, see `sceneweaver.export`
            "Files for other tools.",
            command={"type": str, "metavar": "FORMATS"},
        ),
    ]
    clutter: Annotated[
        float,
        Option(
            0.4,
            "How lived-in the room looks: 0 a show room, 0.4 as usual.",
            0.0,
            1.0,
            command={"type": float | None, "default": None, "show_default": False},
            server="How lived-in: 0 a show room, 1 much lies about",
        ),
    ]
    settle: Annotated[
        bool,
        Option(
            False,
            "Prefer layouts that physics leaves alone; let things settle.",
            command={"flags": ("--settle/--no-settle",)},
        ),
    ]
    init: Annotated[
        Init,
        Option(
            "auto",
            "What the room begins with: the best scene of a library, one of --scene-model, what a language model "
            "writes down, or poses of the learned prior (default: as the planner likes).",
            command={"panel": STARTS, "show_default": False},
        ),
    ]
    scenes: Annotated[
        str | Path | None,
        Option(
            None,
            "Folder of scenes, of ours or of other systems, that --init library chooses among (default: our own).",
            command={"type": Path | None, "metavar": "DIR", "panel": STARTS, "show_default": False},
        ),
    ]
    scene_model: Annotated[
        Any,
        Option(
            None,
            "What --init model asks: module:attribute, an entry point, or a folder or file of a model's outputs.",
            command={"type": str | None, "metavar": "MODEL", "panel": STARTS, "show_default": False},
        ),
    ]
    start: Annotated[
        str | Path | None,
        Option(
            None,
            "The scene to go on from, of ours or of another system; FILE#NAME takes one of several.",
            command={"type": str | None, "metavar": "FILE", "panel": STARTS, "show_default": False},
        ),
    ]
    source: Annotated[
        str,
        Option(
            "auto",
            "Format of --start and of outputs of --scene-model (default: told by the file).",
            command={"flags": ("--from",), "metavar": "FORMAT", "panel": STARTS, "show_default": False},
        ),
    ]
    model: Annotated[
        Any,
        Option(
            None,
            "openai:NAME, anthropic:NAME, or a name at --base-url (default: $SCENEWEAVER_MODEL).",
            command={"type": str | None, "metavar": "MODEL", "panel": MODELS, "show_default": False},
        ),
    ]
    base_url: Annotated[
        str | None,
        Option(
            None,
            "Of a server for chat completions (default: $SCENEWEAVER_BASE_URL). Keys come from the environment.",
            command={"metavar": "URL", "panel": MODELS, "show_default": False},
        ),
    ]
    reader: Annotated[
        Literal["rules", "llm"] | None,
        Option(None, "Who reads the request (default: as --planner).", command={"panel": MODELS}),
    ]
    critic: Annotated[
        Literal["symbolic", "vlm"] | None,
        Option(
            None,
            "Who grades: by rules, or by looking at pictures as well (default: as --planner).",
            command={"panel": MODELS},
        ),
    ]
    samples: Annotated[int, Option(1, "How often the critic looks at a scene.", 1, 16, command={"panel": MODELS})]
    stream: Annotated[
        bool | None,
        Option(
            None,
            "Whether replies come in pieces.",
            command={"flags": ("--stream/--no-stream",), "panel": MODELS},
        ),
    ]
    memory_length: Annotated[
        int,
        Option(
            1,
            "Last steps that the planner is told of (default: 1).",
            0,
            100,
            command={"type": int | None, "default": None, "panel": MODELS, "show_default": False},
        ),
    ]
    replay: Annotated[
        str | Path | None,
        Option(
            None,
            "Make the design in this folder again from its records, without a network; PROMPT may be left out.",
            command={"type": Path | None, "metavar": "DIR", "panel": MODELS, "show_default": False},
        ),
    ]
    strict: Annotated[
        bool,
        Option(
            False,
            "End with code 4 where the model cannot be asked, not go on by rules.",
            command={"flags": ("--strict",), "panel": MODELS},
        ),
    ]


def options_of(kind: type) -> dict[str, tuple[Any, Option]]:
    """The options of a ``TypedDict``, in its order: the type of each, and what else is known of it."""
    hints = get_type_hints(kind, include_extras=True)
    found = {name: get_args(hint) for name, hint in hints.items() if hasattr(hint, "__metadata__")}
    return {
        name: (args[0], option) for name, args in found.items() for option in args[1:] if isinstance(option, Option)
    }


def takes(parameters: Iterable[inspect.Parameter]) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    """A decorator that has a function with ``**options`` show these keyword parameters in its signature.

    They come before its own keyword parameters that are no options of a design.
    """

    def shown(function: Callable[..., Any]) -> Callable[..., Any]:
        own = [p for p in inspect.signature(function, eval_str=True).parameters.values() if p.kind != p.VAR_KEYWORD]
        first = [p for p in own if p.kind != p.KEYWORD_ONLY]
        last = [p for p in own if p.kind == p.KEYWORD_ONLY]
        every = [*first, *parameters, *last]
        back = inspect.signature(function, eval_str=True).return_annotation
        function.__signature__ = inspect.Signature(every, return_annotation=back)  # type: ignore[attr-defined]
        function.__annotations__ = {p.name: p.annotation for p in every if p.annotation is not p.empty}
        function.__annotations__["return"] = back
        return function

    return shown


def defaults_of(kind: type) -> dict[str, Any]:
    """The default of each option of a ``TypedDict``."""
    return {name: option.default for name, (_, option) in options_of(kind).items()}
