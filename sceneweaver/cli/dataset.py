"""``sceneweaver dataset``: the commands with their options."""

from __future__ import annotations

import re
from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from .options import Device, Json, TimeLimit

dataset = typer.Typer(name="dataset", help="Data sets: many rooms from one specification.")


class Engine(StrEnum):
    """Where blocks are made."""

    LOCAL = "local"
    RAY = "ray"


UNITS = {"": 1, "K": 2**10, "M": 2**20, "G": 2**30}


def _shard(value: str | None) -> str | None:
    if value is not None and _parts(value) is None:
        raise typer.BadParameter(f"'{value}' is not i/N with 0 <= i < N, such as 0/8")
    return value


def _parts(value: str) -> tuple[int, int] | None:
    found = re.fullmatch(r"(\d{1,9})/(\d{1,9})", value)
    return (int(found[1]), int(found[2])) if found and int(found[1]) < int(found[2]) else None


def _size(value: str | None) -> str | None:
    if value is not None and not re.fullmatch(r"\d{1,15}[KMG]?B?", value.upper()):
        raise typer.BadParameter(f"'{value}' is not a size; give bytes, or such as 800M or 2G")
    return value


def _bytes(value: str | None) -> int | None:
    if value is None:
        return None
    number = value.upper().removesuffix("B")
    unit = number[-1] if number[-1] in UNITS else ""
    return int(number.removesuffix(unit)) * UNITS[unit]


Spec = Annotated[
    Path, typer.Argument(metavar="SPEC", help="A specification in YAML, or ten_kinds or layouts.", show_default=False)
]
Folder = Annotated[Path, typer.Argument(metavar="DIR", help="The folder of a data set.", show_default=False)]
NewFolder = Annotated[Path, typer.Option("--out", "-o", metavar="DIR", help="A folder.", show_default=False)]
Workers = Annotated[
    int | None, typer.Option(min=1, max=4096, help="Processes (default: the cores).", show_default=False)
]
Shard = Annotated[
    str | None,
    typer.Option(callback=_shard, metavar="i/N", help="Only the i-th of N shares of the work.", show_default=False),
]
WhereEngine = Annotated[Engine, typer.Option("--engine", help="Processes of this machine, or a Ray cluster.")]
Address = Annotated[str | None, typer.Option(help="Of the Ray cluster (default: one here).", show_default=False)]
Memory = Annotated[
    str | None,
    typer.Option(
        "--worker-memory",
        callback=_size,
        metavar="SIZE",
        help="Replace a worker that holds more, such as 2G.",
        show_default=False,
    ),
]
Patient = Annotated[bool, typer.Option("--wait/--no-wait", help="When the disk is full: wait for room, or end.")]
JsonLines = Annotated[bool, typer.Option("--json", help="Print a line of JSON a block and one at the end.")]


FullCheck = Annotated[
    bool, typer.Option("--full-check", help="Of one that is whole, read all files, not only their sizes.")
]


@dataset.command()
def make(
    source: Spec,
    out: NewFolder,
    workers: Workers = None,
    device: Device = "auto",
    shard: Shard = None,
    engine: WhereEngine = Engine.LOCAL,
    address: Address = None,
    worker_memory: Memory = None,
    patient: Patient = True,
    time_limit: TimeLimit = None,
    as_json: JsonLines = False,
) -> int:
    """Make a data set; started again, it goes on where it ended."""
    from .dataset_runs import Run, run_make

    memory = _bytes(worker_memory)
    settings = Run(workers, device, _parts(shard or ""), engine.value, address, memory, patient, as_json, time_limit)
    return run_make(source, out, settings)


@dataset.command()
def resume(
    folder: Folder,
    workers: Workers = None,
    device: Device = "auto",
    shard: Shard = None,
    engine: WhereEngine = Engine.LOCAL,
    address: Address = None,
    worker_memory: Memory = None,
    patient: Patient = True,
    time_limit: TimeLimit = None,
    full_check: FullCheck = False,
    as_json: JsonLines = False,
) -> int:
    """Go on with a data set that is not whole, or make anew what is damaged; it needs no specification."""
    from .dataset_runs import Run, run_resume

    memory = _bytes(worker_memory)
    settings = Run(
        workers, device, _parts(shard or ""), engine.value, address, memory, patient, as_json, time_limit, full_check
    )
    return run_resume(folder, settings)


@dataset.command()
def merge(
    folders: Annotated[list[Path], typer.Argument(metavar="DIR...", help="Data sets.", show_default=False)],
    out: NewFolder,
    workers: Workers = None,
    as_json: JsonLines = False,
) -> int:
    """Join data sets: shares of one that were made apart, or whole ones of different specifications."""
    from .dataset_runs import Run, run_merge

    return run_merge(folders, out, Run(workers, "auto", None, "local", None, None, True, as_json))


@dataset.command()
def status(folder: Folder, as_json: Json = False) -> int:
    """Say how far a data set is: blocks, scenes, rate, why some were not delivered."""
    from .dataset_looks import run_status

    return run_status(folder, as_json=as_json)


@dataset.command()
def plan(
    source: Spec,
    sample: Annotated[int, typer.Option(min=1, max=10_000, help="Scenes that are made to find out.")] = 20,
    workers: Workers = None,
    device: Device = "auto",
    as_json: Json = False,
) -> int:
    """Say what a data set will cost: seconds and bytes, from a sample that is made and thrown away."""
    from .dataset_looks import run_plan

    return run_plan(source, sample, workers, device, as_json=as_json)


@dataset.command()
def verify(
    folder: Folder,
    workers: Workers = None,
    sample: Annotated[
        int | None, typer.Option(min=1, help="Judge so many scenes only (default: all).", show_default=False)
    ] = None,
    stability: Annotated[int, typer.Option(min=0, help="Let so many scenes loose in MuJoCo.")] = 0,
    as_json: Json = False,
) -> int:
    """Judge a data set from its files alone: sums, tables, every scene. 3 when something does not hold."""
    from .dataset_looks import run_verify

    return run_verify(folder, workers, sample, stability, as_json=as_json)


@dataset.command()
def report(
    folder: Folder,
    out: Annotated[
        Path | None,
        typer.Option("--out", "-o", metavar="HTML", help="The page (default: report.html there).", show_default=False),
    ] = None,
    pictures: Annotated[int, typer.Option(min=0, max=100_000, help="Scenes that are drawn, at most.")] = 400,
) -> int:
    """Write a page about a data set, also of one that is still made: figures, variety, samples, troubles."""
    from .dataset_looks import run_report

    return run_report(folder, out, pictures)


@dataset.command()
def schema() -> int:
    """Print the JSON schema of specifications."""
    from .dataset_looks import run_schema

    return run_schema()


@dataset.command(name="push-card")
def push_card(
    folder: Folder,
    repo: Annotated[str, typer.Option(metavar="OWNER/NAME", help="A data set on the hub.", show_default=False)],
    endpoint: Annotated[str | None, typer.Option(help="Another hub than huggingface.co.", show_default=False)] = None,
    token_env: Annotated[str, typer.Option(metavar="NAME", help="Environment variable with the token.")] = "HF_TOKEN",
    dry_run: Annotated[bool, typer.Option("--dry-run", help="Only list what would be uploaded.")] = False,
) -> int:
    """Upload card, licences and tables of a data set to the Hugging Face hub, without its shards."""
    from .dataset_looks import run_push_card

    return run_push_card(folder, repo, endpoint, token_env, dry_run)


@dataset.command()
def extract(
    folder: Folder,
    key: Annotated[str, typer.Argument(metavar="KEY", help="The key of a scene.", show_default=False)],
    out: NewFolder,
) -> int:
    """Copy one scene, with the meshes and images that it names, into a folder that stands alone."""
    from .dataset_looks import run_extract

    return run_extract(folder, key, out)
