"""The commands with their options, and what every one of them has in common: errors and exit codes.

Exit codes: 0 done and valid, 1 a fault of the program, 2 bad input, 3 not valid, 4 something needed is missing,
5 a time limit or a signal ended it before all was done, 130 interrupted. What went wrong is one line on stderr.
"""

from __future__ import annotations

import faulthandler
import gc
import json
import os
import signal
import sys
import threading
import time
import traceback
from collections.abc import Sequence
from enum import StrEnum
from functools import cache
from pathlib import Path
from typing import Annotated, Any

import typer
from typer.core import TyperCommand, TyperGroup

from sceneweaver.export.formats import FORMATS, USUAL
from sceneweaver.io import InputError
from sceneweaver.runtime.compiling import watched_by
from sceneweaver.runtime.deadline import process_began
from sceneweaver.runtime.options import takes
from sceneweaver.runtime.package import missing_module

from .dataset import dataset
from .exit_codes import BAD_INPUT, INTERRUPTED, MISSING
from .extensions import load_extensions
from .knowledge import knowledge
from .layout_bench import app as layout_bench
from .model_options import (
    BaseUrl,
    MaxCalls,
    MaxCost,
    MaxTokens,
    Model,
    NamedModel,
    PriceFile,
    design_parameters,
    limits_of,
)
from .options import Candidates, Device, Input, Json, Out, Picture, Png, Seed, TimeLimit, positive_seconds
from .streams import CompilingLine

# The base of typer's usage errors, which lives in click or, with newer versions of typer, in typer itself.
_UsageError: type[Exception] = next(c for c in typer.BadParameter.__mro__ if c.__name__ == "ClickException")

COLLECT = (50_000, 20, 100)
"""Thresholds of the garbage collector: with the usual ones a short run spends a tenth of its time in it."""

app = typer.Typer(
    name="sceneweaver",
    help="Lay out indoor scenes that a simulator accepts, and judge them.",
    add_completion=False,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
    epilog="Exit codes: 0 done and valid, 2 bad input, 3 not valid, 4 something needed is missing, 5 out of time.",
)


class WithOptimizers(TyperCommand):
    """A command whose help names the built-in optimisers; to ask for them loads the engine."""

    def format_help(self, ctx: Any, formatter: Any) -> None:
        """Write the help."""
        from sceneweaver.layout.stepwise import OPTIMIZERS

        for parameter in self.params:
            text = getattr(parameter, "help", None)
            if text:
                setattr(parameter, "help", text.replace("OPTIMIZERS", ", ".join(OPTIMIZERS)))  # noqa: B010 - of options
        super().format_help(ctx, formatter)


class Init(StrEnum):
    """Where candidates start."""

    SAMPLE = "sample"
    RANDOM = "random"
    CURRENT = "current"
    PRIOR = "prior"


class Transport(StrEnum):
    """How the MCP server is reached."""

    STDIO = "stdio"
    HTTP = "http"


def _version(wanted: bool) -> None:
    if wanted:
        import sceneweaver

        typer.echo(f"sceneweaver {sceneweaver.__version__}")
        raise typer.Exit


@app.callback()
def _root(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Show the version and exit.")
    ] = False,
) -> None:
    pass


@app.command(cls=WithOptimizers)
def refine(
    context: typer.Context,
    source: Input,
    out: Out,
    candidates: Candidates = 1024,
    seed: Seed = 0,
    init: Annotated[Init, typer.Option(help="Where the layouts start.")] = Init.SAMPLE,
    device: Device = "auto",
    optimizer: Annotated[
        str,
        typer.Option(metavar="NAME", help="How the layouts are improved: OPTIMIZERS, or one of a package."),
    ] = "search",
    objective: Annotated[
        Path | None,
        typer.Option(
            help="A JSON file with a list of terms that are minimised over valid layouts.", show_default=False
        ),
    ] = None,
    time_limit: TimeLimit = None,
    as_json: Json = False,
    picture: Picture = True,
) -> int:
    """Find poses for the objects of a scene so that nothing collides and all relations hold."""
    from .refine import run_refine

    return run_refine(
        source,
        out,
        candidates=candidates,
        seed=seed,
        init=init.value,
        device=device,
        optimizer=optimizer,
        objective=objective,
        time_limit=time_limit,
        as_json=as_json,
        picture=picture,
        began=context.obj,
    )


@app.command()
def repair(
    context: typer.Context,
    source: Annotated[
        Path,
        typer.Argument(metavar="IN", help="A scene.json, or a folder or file of any known format.", show_default=False),
    ],
    out: Out,
    relations: Annotated[
        bool, typer.Option("--relations/--no-relations", help="Make hard relations hold as well.")
    ] = True,
    soft: Annotated[
        bool | None,
        typer.Option(
            "--soft/--no-soft",
            help="Keep soft relations that hold (default: of many scenes, with those that geometry shows).",
            show_default=False,
        ),
    ] = None,
    drop: Annotated[
        bool, typer.Option("--drop", help="Take out the least that makes an overfull scene feasible, and say so.")
    ] = False,
    candidates: Annotated[
        int | None,
        typer.Option(
            min=1,
            help="How many repairs to choose from (default: by the size of the scene; of many scenes 8).",
            show_default=False,
        ),
    ] = None,
    format_name: Annotated[
        str,
        typer.Option("--from", metavar="FORMAT", help="The system that wrote it, or sceneweaver, of many scenes."),
    ] = "auto",
    assets: Annotated[
        str, typer.Option(metavar="own|theirs|boxes", help="Of other systems: what stands for their objects.")
    ] = "own",
    asset_folder: Annotated[
        Path | None, typer.Option(metavar="DIR", help="Their assets, meshes or metadata.", show_default=False)
    ] = None,
    sizes: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Sizes by asset or label, .json or .csv.", show_default=False)
    ] = None,
    jobs: Annotated[int, typer.Option(min=1, help="Processes, of many scenes.")] = 1,
    limit: Annotated[int | None, typer.Option(min=1, help="Most scenes.", show_default=False)] = None,
    seed: Seed = 0,
    device: Device = "auto",
    time_limit: TimeLimit = None,
    as_json: Json = False,
    picture: Picture = True,
) -> int:
    """Move the objects of a broken scene, or of each scene of a data set, as little as makes it valid."""
    from .repair import run_repair
    from .repair_many import choose, is_single, run_repair_many

    options = {"relations": relations, "drop": drop, "candidates": candidates, "seed": seed, "device": device}
    common: Any = {"time_limit": time_limit, "as_json": as_json, "began": context.obj}
    if is_single(source, format_name):
        return run_repair(source, out, **options, soft=bool(soft), picture=picture, **common)  # type: ignore[arg-type]
    return run_repair_many(
        source,
        out,
        choice=choose(soft is not False, options),
        format_name=format_name,
        assets=assets,
        folder=asset_folder,
        sizes=sizes,
        jobs=jobs,
        limit=limit,
        **common,
    )


@app.command()
def check(
    context: typer.Context,
    source: Input,
    as_json: Json = False,
    metrics: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Write metrics.json here.", show_default=False)
    ] = None,
    meshes: Annotated[
        Path | None,
        typer.Option(
            metavar="DIR",
            help="Folder of <asset>.glb, .obj, .stl or .ply files: judge the true shapes.",
            show_default=False,
        ),
    ] = None,
    picture: Annotated[
        Path | None, typer.Option(metavar="PNG", help="Draw the top view, what is wrong in red.", show_default=False)
    ] = None,
    physics: Annotated[
        bool, typer.Option("--physics", help="Simulate 3 s with MuJoCo as well: does everything stay where it is?")
    ] = False,
    openable: Annotated[
        bool, typer.Option("--openable", help="Open doors, drawers and lids as well: is anything in their way?")
    ] = False,
    robot_radius: Annotated[
        float | None,
        typer.Option(
            metavar="M", help="Radius [m] of the robot's base that is to get about; usually 0.2.", show_default=False
        ),
    ] = None,
    programme: Annotated[
        Path | None,
        typer.Option(metavar="YAML", help="Of a home: what its plan is to hold as well.", show_default=False),
    ] = None,
    profile: Annotated[str, typer.Option(metavar="NAME", help="Of a home: rules that its plan keeps.")] = "base",
    time_limit: TimeLimit = None,
) -> int:
    """Judge a scene: collisions, bounds, support, zones, relations; or a home. Changes nothing."""
    from .check import run_check
    from .home_views import holds_home
    from .homes import run_check_home

    if holds_home(source):
        if meshes is not None or picture is not None:
            raise InputError("--meshes and --picture are for single rooms; give the scene.json of one")
        return run_check_home(
            source,
            programme=programme,
            profile=profile,
            as_json=as_json,
            metrics=metrics,
            physics=physics,
            openable=openable,
            robot_radius=robot_radius,
            time_limit=time_limit,
            began=context.obj,
        )
    return run_check(
        source,
        as_json=as_json,
        metrics=metrics,
        meshes=meshes,
        picture=picture,
        physics=physics,
        openable=openable,
        robot_radius=robot_radius,
        time_limit=time_limit,
        began=context.obj,
    )


@app.command()
def render(
    context: typer.Context,
    source: Input,
    out: Annotated[
        Path,
        typer.Option(
            "--out",
            "-o",
            metavar="OUT",
            help="A PNG; of plans of homes an SVG, of homes or passes a folder.",
            show_default=False,
        ),
    ],
    plain: Annotated[bool, typer.Option("--plain", help="Of a plan: without title, axes, labels and zones.")] = False,
    width: Annotated[int, typer.Option(min=200, max=8192, help="Width in pixels.")] = 1600,
    height: Annotated[
        int | None, typer.Option(min=150, max=8192, help="Height in pixels (default: 3/4 of it).", show_default=False)
    ] = None,
    view: Annotated[
        str,
        typer.Option(
            metavar="VIEW",
            help="plan, eye-door, eye-corner, eye-corner2, corner, corner2 or top; of a home plan, overview, walk_01 "
            "and so on, or all.",
        ),
    ] = "plan",
    passes: Annotated[
        str | None,
        typer.Option(
            metavar="PASSES",
            help="Write data passes: some of rgb,depth,normal,position,instance,semantic,material.",
            show_default=False,
        ),
    ] = None,
    cameras: Annotated[
        str, typer.Option(metavar="auto|FILE", help="Of passes: those at eye level, or a JSON file with cameras.")
    ] = "auto",
    kind: Annotated[str, typer.Option("--format", metavar="png|exr|npz", help="Of passes.")] = "png",
    device: Device = "cpu",
    time_limit: TimeLimit = None,
    as_json: Json = False,
) -> int:
    """Draw a scene: a plan, a picture of the room, or data passes for learning. Of a home plans, storeys and a walk."""
    from .home_views import holds_home, render_home_file
    from .render import run_passes, run_render

    size = (width, height or round(0.75 * width))
    common: Any = {"device": device, "as_json": as_json, "time_limit": time_limit, "began": context.obj}
    if passes is None and holds_home(source):
        return render_home_file(source, out, view, size, **common)
    if passes is not None:
        return run_passes(source, out, passes, cameras, kind, size, **common)
    return run_render(source, out, view, size, plain=plain, **common)


@app.command("import")
def import_scenes(
    source: Annotated[Path, typer.Argument(metavar="FILE|DIR", help="Scenes of another system.", show_default=False)],
    out: Annotated[
        Path,
        typer.Option("--out", "-o", metavar="OUT", help="A folder, or for one scene a .json file.", show_default=False),
    ],
    format_name: Annotated[
        str, typer.Option("--from", metavar="FORMAT", help="The system that wrote it; docs/importers.md lists them.")
    ] = "auto",
    assets: Annotated[
        str,
        typer.Option(metavar="own|theirs|boxes", help="What stands for objects: our furniture, their meshes, boxes."),
    ] = "own",
    asset_folder: Annotated[
        Path | None, typer.Option(metavar="DIR", help="Their assets, meshes or metadata.", show_default=False)
    ] = None,
    sizes: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE",
            help="Sizes by asset or label, .json or .csv, where the files have none.",
            show_default=False,
        ),
    ] = None,
    room: Annotated[
        str | None, typer.Option(metavar="NAME", help="Only this room of a home.", show_default=False)
    ] = None,
    relations: Annotated[
        bool, typer.Option("--relations/--no-relations", help="Keep what holds between the objects as soft relations.")
    ] = True,
    limit: Annotated[int | None, typer.Option(min=1, help="Most scenes.", show_default=False)] = None,
    home: Annotated[
        bool, typer.Option("--home", help="Whole homes instead: rooms with the doors between them.")
    ] = False,
    mend: Annotated[
        bool, typer.Option("--repair", help="With --home: move walls, doors and windows as little as makes it valid.")
    ] = False,
    profile: Annotated[
        str, typer.Option(metavar="NAME", help="With --home: the rules that plans are to keep.")
    ] = "base",
    scale: Annotated[
        float | None,
        typer.Option(metavar="METRES", help="With --home: metres for a unit of a drawing.", show_default=False),
    ] = None,
    drawn: Annotated[
        str,
        typer.Option(metavar="auto|faces|middles", help="With --home: what outlines are: faces of walls or middles."),
    ] = "auto",
    as_json: Json = False,
) -> int:
    """Bring scenes of other systems into scene files: poses kept, categories, sizes and supports found."""
    if home:
        from .importing_homes import run_import_homes

        return run_import_homes(
            source,
            out,
            format_name=format_name,
            drawn=drawn,  # type: ignore[arg-type]
            scale=scale,
            folder=asset_folder,
            profile=profile if mend else None,
            limit=limit,
            as_json=as_json,
        )
    from .importing import run_import

    return run_import(
        source,
        out,
        format_name=format_name,
        assets=assets,  # type: ignore[arg-type]
        folder=asset_folder,
        sizes=sizes,
        room=room,
        relations=relations,
        limit=limit,
        as_json=as_json,
    )


CompareFrom = Annotated[
    list[str] | None,
    typer.Option(
        "--from",
        metavar="[NAME=]FORMAT",
        help="How files are read: auto, sceneweaver, or a format of docs/importers.md.",
        show_default=False,
    ),
]
CompareFolder = Annotated[
    list[str] | None,
    typer.Option(metavar="[NAME=]DIR", help="Their assets, meshes or metadata.", show_default=False),
]
CompareSizes = Annotated[
    list[str] | None,
    typer.Option(metavar="[NAME=]FILE", help="Sizes by asset or label, .json or .csv.", show_default=False),
]
CompareAssets = Annotated[
    str, typer.Option(metavar="own|theirs|boxes", help="What stands for objects: our furniture, their meshes, boxes.")
]
AssumeSizes = Annotated[
    bool, typer.Option("--assume-sizes", help="Judge usual sizes where the files have none; such figures are marked.")
]
Prompts = Annotated[
    Path | None,
    typer.Option(metavar="FILE", help="Annotated requests: a CSV file as of SceneEval.", show_default=False),
]
Reference = Annotated[
    str | None,
    typer.Option(metavar="NAME|PATH", help="Scenes whose categories are compared with.", show_default=False),
]
Stability = Annotated[bool, typer.Option("--stability/--no-stability", help="Simulate each scene for 5 s by MuJoCo.")]
SceneCount = Annotated[int | None, typer.Option(min=1, help="Most scenes of each system.", show_default=False)]
SceneLimit = Annotated[float, typer.Option(callback=positive_seconds, help="Seconds that a scene may take.")]
Jobs = Annotated[int, typer.Option(min=1, help="Processes that judge.")]
Shown = Annotated[int, typer.Option(min=0, max=24, help="Scenes of each system that are drawn.")]
Table = Annotated[
    Path,
    typer.Option("--out", "-o", metavar="OUT", help="A folder; a run into it again goes on.", show_default=False),
]


@app.command()
def evaluate(
    context: typer.Context,
    sources: Annotated[
        list[str],
        typer.Argument(metavar="SCENES...", help="Files or folders of scenes of one system.", show_default=False),
    ],
    out: Table,
    formats: CompareFrom = None,
    assets: CompareAssets = "own",
    asset_folder: CompareFolder = None,
    sizes: CompareSizes = None,
    assume_sizes: AssumeSizes = False,
    prompts: Prompts = None,
    reference: Reference = None,
    stability: Stability = True,
    limit: SceneCount = None,
    scene_limit: SceneLimit = 120.0,
    jobs: Jobs = 1,
    pictures: Shown = 3,
    time_limit: TimeLimit = None,
    as_json: Json = False,
) -> int:
    """Judge scenes of any format: collisions, stability, support, access, what was asked, sizes, diversity."""
    from .comparing import CompareOptions, run_evaluate

    options = CompareOptions(
        formats=formats or (),
        folders=asset_folder or (),
        sizes=sizes or (),
        assets=assets,
        assume_sizes=assume_sizes,
        prompts=prompts,
        reference=reference,
        stability=stability,
        limit=limit,
        jobs=jobs,
        scene_limit=scene_limit,
        pictures=pictures,
        time_limit=time_limit,
        as_json=as_json,
    )
    return run_evaluate(sources, out, options, context.obj)


@app.command()
def compare(
    context: typer.Context,
    systems: Annotated[
        list[str],
        typer.Argument(
            metavar="[NAME=]PATH...", help="Files or folders of scenes, one for each system.", show_default=False
        ),
    ],
    out: Table,
    formats: CompareFrom = None,
    assets: CompareAssets = "own",
    asset_folder: CompareFolder = None,
    sizes: CompareSizes = None,
    assume_sizes: AssumeSizes = False,
    prompts: Prompts = None,
    reference: Reference = None,
    stability: Stability = True,
    limit: SceneCount = None,
    scene_limit: SceneLimit = 120.0,
    jobs: Jobs = 1,
    pictures: Shown = 3,
    time_limit: TimeLimit = None,
    as_json: Json = False,
) -> int:
    """Put systems side by side: their scenes, of any format, judged alike, in one table with definitions."""
    from .comparing import CompareOptions, run_compare

    options = CompareOptions(
        formats=formats or (),
        folders=asset_folder or (),
        sizes=sizes or (),
        assets=assets,
        assume_sizes=assume_sizes,
        prompts=prompts,
        reference=reference,
        stability=stability,
        limit=limit,
        jobs=jobs,
        scene_limit=scene_limit,
        pictures=pictures,
        time_limit=time_limit,
        as_json=as_json,
    )
    return run_compare(systems, out, options, context.obj)


@app.command()
def export(
    context: typer.Context,
    source: Input,
    out: Annotated[
        Path,
        typer.Option(
            "--out", "-o", metavar="OUT", help="A folder, or a file whose suffix says the format.", show_default=False
        ),
    ],
    to: Annotated[
        str | None,
        typer.Option(
            "--to",
            "--format",
            metavar="FORMATS",
            help=f"With a folder: {', '.join(FORMATS)}, or all (default: {','.join(USUAL)}). For one reader: "
            + ", ".join(f"{one.name}:CLIENT ({', '.join(one.clients)})" for one in FORMATS.values() if one.clients)
            + ".",
            show_default=False,
        ),
    ] = None,
    textures: Annotated[
        bool, typer.Option("--textures/--no-textures", help="Materials with their maps, or plain and small.")
    ] = True,
    welded: Annotated[
        bool, typer.Option("--welded/--loose", help="Fruit in a bowl, books of a stack as one body, or each its own.")
    ] = False,
    time_limit: TimeLimit = None,
    as_json: Json = False,
) -> int:
    """Write a scene or a whole home for other tools: USD for Isaac Sim, MJCF for MuJoCo, GLB, SceneState."""
    from .export import run_export

    return run_export(
        source,
        out,
        to=to,
        as_json=as_json,
        textures=textures,
        welded=welded,
        time_limit=time_limit,
        began=context.obj,
    )


@app.command()
@takes(design_parameters())
def design(
    context: typer.Context,
    out: Annotated[
        Path, typer.Option("--out", "-o", metavar="DIR", help="Folder for the results.", show_default=False)
    ],
    prompt: Annotated[
        str, typer.Argument(metavar="PROMPT", help="The room or home, in words.", show_default=False)
    ] = "",
    *,
    home: Annotated[
        bool | None,
        typer.Option("--home/--room", help="A whole home, or one room (default: as it is read).", show_default=False),
    ] = None,
    no_pictures: Annotated[bool, typer.Option("--no-pictures", help="The same as --pictures none.")] = False,
    as_json: Json = False,
    max_calls: MaxCalls = None,
    max_tokens: MaxTokens = None,
    max_cost: MaxCost = None,
    prices: PriceFile = None,
    **options: Any,
) -> int:
    """Make a furnished room or home from a request in words. A run that was cut off goes on when started again."""
    from .design import run_design
    from .homes import run_design_home, wants_home

    options |= limits_of(max_calls, max_tokens, max_cost, prices)
    if no_pictures:
        options["pictures"] = "none"
    if wants_home(prompt, home=home, options=options):
        return run_design_home(prompt, out, options, as_json=as_json, began=context.obj)
    return run_design(prompt, out, options, as_json=as_json, began=context.obj)


@app.command()
def plan(
    context: typer.Context,
    source: Annotated[Path, typer.Argument(metavar="PROGRAMME", help="A programme.yaml.", show_default=False)],
    out: Annotated[Path, typer.Option("--out", "-o", metavar="DIR", help="Folder for the plans.", show_default=False)],
    candidates: Annotated[int, typer.Option(min=1, help="How many plans are searched for at once.")] = 1024,
    count: Annotated[int, typer.Option(min=1, max=1000, help="How many distinct plans are written.")] = 8,
    profile: Annotated[str, typer.Option(metavar="NAME", help="Rules that they keep.")] = "base",
    seed: Seed = 0,
    device: Device = "auto",
    time_limit: TimeLimit = None,
    as_json: Json = False,
) -> int:
    """Solve the floor plans of a programme of rooms, and draw the best ones."""
    from .homes import run_plan

    return run_plan(
        source,
        out,
        seed=seed,
        candidates=candidates,
        count=count,
        profile=profile,
        device=device,
        time_limit=time_limit,
        as_json=as_json,
        began=context.obj,
    )


@app.command()
def view(
    source: Annotated[
        Path, typer.Argument(metavar="DIR", help="The folder of a design, or one of its files.", show_default=False)
    ],
    port: Annotated[int, typer.Option(min=0, max=65535, help="Port to begin with; 0 takes any.")] = 8642,
    browser: Annotated[bool, typer.Option("--browser/--no-browser", help="Open it in the browser.")] = True,
) -> int:
    """Show a design in the browser, until Ctrl-C."""
    from .view import run_view

    return run_view(source, port, browser)


@app.command()
def mcp(
    folder: Annotated[
        Path, typer.Option(metavar="DIR", help="All files are read and written below it; it must be there.")
    ] = Path("."),
    transport: Annotated[
        Transport, typer.Option(help="stdio, as assistants start it; http: for clients of this computer.")
    ] = Transport.STDIO,
    port: Annotated[int, typer.Option(min=0, max=65535, help="Port of http; 0 takes any that is free.")] = 8643,
    device: Device = "auto",
    time_limit: Annotated[
        float, typer.Option(callback=positive_seconds, help="Seconds that one call may take at most.")
    ] = 300.0,
    scenes: Annotated[int, typer.Option(min=1, max=1000, help="Scenes that may be open at once.")] = 16,
    versions: Annotated[int, typer.Option(min=2, max=10_000, help="Versions that are kept of a scene.")] = 100,
    model: NamedModel = None,
    base_url: BaseUrl = None,
    max_calls: MaxCalls = None,
    max_tokens: MaxTokens = None,
    max_cost: MaxCost = None,
    prices: PriceFile = None,
) -> int:
    """Serve rooms to assistants over the Model Context Protocol: design, edit, check, render, export."""
    from .mcp import run_mcp

    return run_mcp(
        folder,
        transport=transport.value,
        port=port,
        device=device,
        time_limit=time_limit,
        scenes=scenes,
        versions=versions,
        models={"model": model, "base_url": base_url, **limits_of(max_calls, max_tokens, max_cost, prices)},
    )


@app.command()
def demo(
    context: typer.Context,
    out: Annotated[Path, typer.Option("--out", "-o", metavar="DIR", help="Folder for the results.")] = Path("out/demo"),
    seed: Seed = 0,
    device: Device = "auto",
    as_json: Json = False,
) -> int:
    """Design a teenager's bedroom with a desk by the window."""
    from .design import DEMO, run_design

    options = {"seed": seed, "device": device, "time_limit": 120.0}
    return run_design(DEMO, out, options, as_json=as_json, began=context.obj)


@app.command()
def examples(as_json: Json = False) -> int:
    """List the rooms that ship with sceneweaver."""
    from .examples import run_examples

    return run_examples(as_json=as_json)


assets = typer.Typer(name="assets", help="Furniture: draw it, show it, import other people's.")
app.add_typer(assets)
app.add_typer(dataset)
app.add_typer(knowledge)

StorePath = Annotated[
    Path | None,
    typer.Option(
        "--store",
        metavar="DIR",
        help="The asset store (default: $SCENEWEAVER_ASSETS, or the user's cache).",
        show_default=False,
    ),
]
AssetId = Annotated[str, typer.Argument(metavar="ID|NOUN", help="An asset's id, or a word for it.", show_default=False)]
Allow = Annotated[
    list[str] | None,
    typer.Option(
        "--license-allow",
        metavar="NAME",
        help="Only assets of this licence; may be given several times.",
        show_default=False,
    ),
]


@assets.command("list")
def assets_list(
    store: StorePath = None,
    source: Annotated[str | None, typer.Option(help="Only of this source.", show_default=False)] = None,
    license_allow: Allow = None,
    as_json: Json = False,
) -> int:
    """List what can be drawn and what the store holds."""
    from .assets import run_list

    return run_list(store=store, source=source, allow=license_allow or [], as_json=as_json)


@assets.command("show")
def assets_show(
    asset_id: AssetId,
    store: StorePath = None,
    seed: Seed = 0,
    picture: Annotated[Path | None, typer.Option(metavar="PNG", help="Draw it as well.", show_default=False)] = None,
    as_json: Json = False,
) -> int:
    """Say all about one asset: size, surfaces, zones, parts, licence."""
    from .assets import run_show

    return run_show(asset_id, store=store, seed=seed, picture=picture, as_json=as_json)


@assets.command("urdf")
def assets_urdf(
    asset_id: AssetId,
    out: Annotated[
        Path,
        typer.Option("--out", "-o", metavar="DIR", help="The folder; its parent must be there.", show_default=False),
    ],
    store: StorePath = None,
    seed: Seed = 0,
    as_json: Json = False,
) -> int:
    """Write one asset as URDF, with its doors and drawers as joints."""
    from .assets import run_urdf

    return run_urdf(asset_id, out, store=store, seed=seed, as_json=as_json)


@assets.command("sheet")
def assets_sheet(
    out: Png,
    names: Annotated[
        list[str] | None,
        typer.Argument(metavar="[CATEGORY|ID]...", help="What to draw (default: every category).", show_default=False),
    ] = None,
    seeds: Annotated[int, typer.Option(min=1, max=100, help="Variants of each category.")] = 1,
    columns: Annotated[int, typer.Option(min=1, max=40, help="Pictures in a row.")] = 8,
    tile: Annotated[int, typer.Option(min=32, max=1024, help="Pixels of a picture.")] = 240,
    view: Annotated[str, typer.Option(metavar="corner|front|side|top", help="Where it is seen from.")] = "corner",
    materials: Annotated[bool, typer.Option("--materials", help="Patterns of materials, at real size.")] = False,
    store: StorePath = None,
    device: Device = "cpu",
) -> int:
    """Draw a labelled contact sheet."""
    from .assets import run_materials, run_sheet

    if materials:
        return run_materials(names or [], out, columns=columns, tile=tile)

    return run_sheet(
        names or [],
        out,
        seeds=seeds,
        columns=columns,
        tile=tile,
        view=view,
        store=store,
        device="cuda" if device == "cuda:all" else "cpu" if device == "auto" else device,
    )


@assets.command("import")
def assets_import(
    source: Annotated[Path, typer.Argument(metavar="PATH", help="A mesh file, or a folder.", show_default=False)],
    kind: Annotated[
        str,
        typer.Option(
            "--format",
            metavar="auto|folder|objathor|3d-future|hssd|abo|mjcf|metascenes",
            help="What kind of library the folder is.",
        ),
    ] = "auto",
    store: StorePath = None,
    category: Annotated[str | None, typer.Option(help="What they are.", show_default=False)] = None,
    up: Annotated[str | None, typer.Option(metavar="AXIS", help="Up axis, such as y.", show_default=False)] = None,
    front: Annotated[
        str | None,
        typer.Option(metavar="AXIS|ask", help="Front, such as -z; ask lets a model look.", show_default=False),
    ] = None,
    model: Model = None,
    base_url: BaseUrl = None,
    unit: Annotated[
        float | None, typer.Option(metavar="METRES", help="Metres per unit, such as 0.01.", show_default=False)
    ] = None,
    licence: Annotated[str | None, typer.Option("--license", help="Their licence.", show_default=False)] = None,
    license_allow: Allow = None,
    time_limit: Annotated[
        float, typer.Option(callback=positive_seconds, help="Seconds for each piece of native work.")
    ] = 60.0,
    limit: Annotated[int | None, typer.Option(min=1, help="Stop after this many.", show_default=False)] = None,
    as_json: Json = False,
) -> int:
    """Bring meshes into the store: unit, axes, front, collision parts and surfaces."""
    from .assets import run_import

    return run_import(
        source,
        kind=kind,
        store=store,
        category=category,
        up=up,
        front=front,
        model=model,
        base_url=base_url,
        unit=unit,
        licence=licence,
        allow=license_allow or [],
        time_limit=time_limit,
        limit=limit,
        as_json=as_json,
    )


@assets.command("infinigen")
def assets_infinigen(
    names: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="[CATEGORY]...", help="What to make (default: eight common pieces).", show_default=False
        ),
    ] = None,
    seeds: Annotated[int, typer.Option(min=1, max=1000, help="Variants of each category.")] = 1,
    store: StorePath = None,
    time_limit: Annotated[float, typer.Option(callback=positive_seconds, help="Seconds for each generator.")] = 300.0,
    as_json: Json = False,
) -> int:
    """Make furniture with Infinigen's generators, in an environment of their own."""
    from .assets import run_infinigen

    return run_infinigen(names or [], seeds=seeds, store=store, time_limit=time_limit, as_json=as_json)


bench = typer.Typer(name="bench", help="Compare optimisers on many problems: curves, profiles, tables, plots.")
app.add_typer(bench)
bench.add_typer(layout_bench)

Results = Annotated[
    Path, typer.Argument(metavar="DIR", help="The folder of results, or a Parquet file.", show_default=False)
]
Goal = Annotated[
    str, typer.Option(metavar="KIND:VALUE", help="What is to be reached: valid:SHARE, objective:TOLERANCE.")
]
Family = Annotated[str | None, typer.Option(help="Only problems of this family.", show_default=False)]
Common = Annotated[bool, typer.Option("--common", help="Only problems and seeds that every method was run on.")]


@bench.command("run", cls=WithOptimizers)
def bench_run(
    out: Annotated[
        Path, typer.Option("--out", "-o", metavar="DIR", help="Folder for the results.", show_default=False)
    ],
    optimizers: Annotated[
        str,
        typer.Option(
            metavar="A,B",
            help="Names, package.module:Name, or label=either; package.module:NAMES for a mapping of them "
            "(default: OPTIMIZERS).",
            show_default=False,
        ),
    ] = "",
    problems: Annotated[str, typer.Option(metavar="A,B", help="Names, families, scene files, or all.")] = "all",
    seeds: Annotated[int, typer.Option(min=1, help="How many seeds, from 0.")] = 3,
    candidates: Annotated[int, typer.Option(min=1, help="Layouts that a method moves at once.")] = 64,
    seconds: Annotated[float, typer.Option(callback=positive_seconds, help="Budget of a run.")] = 5.0,
    evaluations: Annotated[
        int | None, typer.Option(min=1, help="Budget of a run in layouts measured.", show_default=False)
    ] = None,
    clock: Annotated[str, typer.Option(metavar="wall|cpu", help="What seconds are.")] = "wall",
    start: Annotated[str, typer.Option(metavar="sample|random|perturbed", help="Where layouts start.")] = "sample",
    restarts: Annotated[
        bool, typer.Option("--restarts/--no-restarts", help="Begin again where a method ends early.")
    ] = True,
    checkpoints: Annotated[int, typer.Option(min=1, help="Looks at a run.")] = 16,
    limit: Annotated[
        float, typer.Option(callback=positive_seconds, help="Wall seconds after which a run is killed.")
    ] = 300.0,
    isolate: Annotated[
        bool, typer.Option("--isolate/--no-isolate", help="Run in a process that may hang or crash.")
    ] = True,
    device: Device = "auto",
    as_json: Json = False,
) -> int:
    """Run optimisers on problems. What is in the folder already is not run again; a failure is a row of the results."""
    from .bench import run_bench

    return run_bench(
        optimizers,
        problems,
        out,
        seeds=seeds,
        candidates=candidates,
        seconds=seconds,
        evaluations=evaluations,
        clock=clock,
        start=start,
        restarts=restarts,
        checkpoints=checkpoints,
        limit=limit,
        isolate=isolate,
        device=device,
        as_json=as_json,
    )


@bench.command("compare")
def bench_compare(
    source: Results, target: Goal = "valid:0.5", family: Family = None, common: Common = False, as_json: Json = False
) -> int:
    """Print tables of results: quality next to time, by method and by family."""
    from .bench import run_compare

    return run_compare(source, target=target, family=family, common=common, as_json=as_json)


@bench.command("plot")
def bench_plot(
    source: Results,
    out: Annotated[
        Path, typer.Option("--out", "-o", metavar="DIR", help="Folder for the pictures.", show_default=False)
    ],
    target: Goal = "valid:0.5",
    form: Annotated[str, typer.Option("--format", metavar="png|svg", help="Of the pictures.")] = "png",
    family: Family = None,
    common: Common = False,
) -> int:
    """Draw anytime curves, performance profiles and data profiles."""
    from .bench import run_plot

    return run_plot(source, out, target=target, form=form, family=family, common=common)


problems = typer.Typer(name="problems", help="The zoo of layout problems: witnesses, proofs, cards.")
app.add_typer(problems)

ProblemName = Annotated[str, typer.Argument(metavar="NAME", help="A problem, see `problems list`.", show_default=False)]


@problems.command("list")
def problems_list(
    family: Annotated[str | None, typer.Option(help="Only of this family.", show_default=False)] = None,
    feasible: Annotated[
        bool | None, typer.Option("--feasible/--infeasible", help="Only with or without a layout.", show_default=False)
    ] = None,
    as_json: Json = False,
) -> int:
    """List the problems, by family and size."""
    from .problems import run_list

    return run_list(family=family, feasible=feasible, as_json=as_json)


@problems.command("show")
def problems_show(name: ProblemName, as_json: Json = False) -> int:
    """Print a problem's card: sizes, figures, proof, how hard it is."""
    from .problems import run_show

    return run_show(name, as_json=as_json)


@problems.command("export")
def problems_export(
    name: ProblemName,
    out: Annotated[Path, typer.Option("--out", "-o", metavar="DIR", help="Folder for the files.", show_default=False)],
    as_json: Json = False,
) -> int:
    """Write a problem: its canonical bytes, its card, the scene at the bad start and in its witness."""
    from .problems import run_export

    return run_export(name, out, as_json=as_json)


@app.command()
def warm(
    device: Device = "auto",
    arch: Annotated[
        int | None,
        typer.Option(
            metavar="SM",
            help="Compile for GPUs of this compute capability (90: H100, H200), which need not be here.",
            show_default=False,
        ),
    ] = None,
    as_json: Json = False,
) -> int:
    """Compile all kernels ahead, so that no first run waits for that; needed once, and after an update."""
    from .warm import run_warm

    return run_warm(device, arch, as_json=as_json)


@problems.command("verify")
def problems_verify(
    name: Annotated[
        str | None, typer.Argument(metavar="[NAME]", help="A problem (default: all).", show_default=False)
    ] = None,
    split: Annotated[
        str | None,
        typer.Option(
            metavar="dev|test|tuning",
            help="Make a split of Layout Bench anew, and check its hash as well.",
            show_default=False,
        ),
    ] = None,
    seed_file: Annotated[
        Path | None, typer.Option(metavar="FILE", help="The secret of the split test.", show_default=False)
    ] = None,
    as_json: Json = False,
) -> int:
    """Check hash, witness or proof of one problem, of all or of a split; 3 when something is wrong."""
    from .problems import run_verify

    return run_verify(name, split=split, seed_file=seed_file, as_json=as_json)


@cache
def _commands() -> TyperGroup:
    """All commands; once in a process, as their options are read out of annotations, which takes a while."""
    return typer.main.get_group(app)


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit code; ``argv`` is without the program's name.

    A time limit counts from the start of the process, or from this call where another program gives ``argv``.
    """
    began = process_began() if argv is None else time.monotonic()
    if argv is None:
        gc.set_threshold(*COLLECT)
    args = list(sys.argv[1:] if argv is None else argv)
    as_json = "--json" in args
    if threading.current_thread() is threading.main_thread():
        signal.signal(signal.SIGTERM, _terminated)
    if argv is None:  # what native code does wrong is said on stderr, also while that is kept from libraries
        faulthandler.enable(os.dup(2))
    try:
        load_extensions()
        with watched_by(CompilingLine()):
            code = _commands().main(args=args or ["--help"], prog_name="sceneweaver", standalone_mode=False, obj=began)
        sys.stdout.flush()
        if code == INTERRUPTED:  # so some versions of typer report Ctrl-C
            raise KeyboardInterrupt
        return code if isinstance(code, int) else 0
    except (KeyboardInterrupt, typer.Abort):
        return _fail("interrupted", INTERRUPTED, as_json)
    except BrokenPipeError:
        # Who reads our output has gone, as in `sceneweaver check --json | head`: typer ends with 1, quietly, as well.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1
    except _UsageError as error:
        return _fail(_usage(error), getattr(error, "exit_code", BAD_INPUT), as_json)
    except ModuleNotFoundError as error:
        if (error.name or "").partition(".")[0] == "sceneweaver":
            return _fault(error, as_json)
        return _fail(missing_module(error.name or "", f"the package '{error.name}' is missing"), MISSING, as_json)
    except Exception as error:
        from sceneweaver.io import SceneWeaverError

        if not isinstance(error, SceneWeaverError):
            return _fault(error, as_json)
        if _debugging():
            traceback.print_exc()
        return _fail(str(error), error.exit_code, as_json)


def _terminated(number: int, _: object) -> None:
    """End by an exception, so that temporary files are removed."""
    sys.exit(128 + number)


def _usage(error: Exception) -> str:
    """A usage error in one line, with the command whose help explains the options."""
    text = getattr(error, "format_message", error.__str__)()
    text = text.replace("Value error, ", "")  # which some versions of typer put before what is wrong
    context = getattr(error, "ctx", None)
    return f"{text.rstrip('.')}; see: {context.command_path if context else 'sceneweaver'} --help"


def _fault(error: Exception, as_json: bool) -> int:
    """Report a fault of the program itself."""
    if _debugging():
        traceback.print_exc()
        hint = ""
    else:
        hint = "; set SCENEWEAVER_DEBUG=1 to see where"
    return _fail(f"unexpected {type(error).__name__}: {str(error) or 'no message'}{hint}", 1, as_json)


def _debugging() -> bool:
    return os.environ.get("SCENEWEAVER_DEBUG", "") not in ("", "0")


def _fail(text: str, code: int, as_json: bool) -> int:
    from .output import complain

    line = complain(text)
    if as_json:
        typer.echo(json.dumps({"error": line, "exit_code": code}, ensure_ascii=False))
    return code
