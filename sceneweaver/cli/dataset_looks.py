"""``sceneweaver dataset``: what there is, what it will cost, whether it holds, and one scene taken out."""

from __future__ import annotations

from pathlib import Path

import typer

from .dataset_runs import Progress, duration, handles
from .exit_codes import NOT_VALID
from .output import list_files, print_json, progress_bar
from .streams import no_chatter


def run_status(path: Path, *, as_json: bool) -> int:
    """Say how far a data set is."""
    from sceneweaver.datasets.engines import open_dataset, status

    found = status(open_dataset(path))
    if as_json:
        print_json(found.to_dict())
        return 0
    state = "whole" if found.whole else "being made" if found.running else "not whole; resume it"
    typer.echo(f"{path}: {state}, {found.made} of {found.blocks} blocks")
    typer.echo("  " + ", ".join(f"{count} {name}" for name, count in found.rows.items()))
    if found.rate:
        left = found.seconds_left
        typer.echo(f"  {found.rate:.2f} scenes a second" + ("" if left is None else f", {duration(left)} left"))
    for reason, count in found.reasons.items():
        typer.echo(f"  {count} x {reason}")
    return 0


def run_plan(source: Path, sample: int, workers: int | None, device: str, *, as_json: bool) -> int:
    """Say what a data set will cost."""
    with handles() as (_, stderr):
        from sceneweaver.datasets.engines import Listener, estimate

        notices = Progress(None, stderr)
        found = estimate(source, sample, workers, device, Listener(lambda record: None, notices.notice))
    if as_json:
        print_json(found.to_dict())
        return 0
    typer.echo(f"{found.count} scenes with {found.workers} workers, from {found.sample} that were made:")
    typer.echo(f"  {found.rate:.2f} scenes a second, {duration(found.seconds)} in all")
    typer.echo(
        f"  {_size(found.bytes)} on the disk: {_size(found.scene_bytes)} a scene, "
        f"{_size(found.asset_bytes)} of assets that scenes share"
    )
    typer.echo("  of the sample: " + ", ".join(f"{count} {name}" for name, count in found.shares.items()))
    return 0


def run_verify(path: Path, workers: int | None, sample: int | None, stability: int, *, as_json: bool) -> int:
    """Judge a data set from its files alone."""
    from sceneweaver.datasets.checking import verify_dataset
    from sceneweaver.runtime.processes import cores

    with progress_bar("judging", 1) as bar, no_chatter():
        found = verify_dataset(
            path,
            workers=workers or cores(),
            sample=sample,
            stability=stability,
            progress=None if bar is None else lambda done, total: bar(done, total, done, 0.0),
        )
    if as_json:
        print_json(found.data)
    else:
        for line in found.lines():
            typer.echo(line)
    return 0 if found.ok else NOT_VALID


def run_report(path: Path, out: Path | None, pictures: int) -> int:
    """Write the page about a data set."""
    with no_chatter():
        from sceneweaver.datasets.report import write_report
        from sceneweaver.runtime.processes import cores

        page = write_report(path, out, pictures=pictures, workers=cores())
    list_files([page])
    return 0


def run_schema() -> int:
    """Print the JSON schema of specifications."""
    from sceneweaver.datasets.spec import spec_schema

    print_json(spec_schema())
    return 0


def run_push_card(path: Path, repo: str, endpoint: str | None, token_env: str, dry_run: bool) -> int:
    """Upload what describes a data set."""
    from sceneweaver.datasets.files import push_card

    for name in push_card(path, repo, endpoint=endpoint, token_env=token_env, dry_run=dry_run):
        typer.echo(name)
    return 0


def run_extract(path: Path, key: str, out: Path) -> int:
    """Copy one scene into a folder that stands alone."""
    from sceneweaver.datasets.reading import extract

    for file in extract(path, key, out):
        typer.echo(file)
    return 0


def _size(count: float) -> str:
    for unit in ("bytes", "kB", "MB", "GB"):
        if count < 1000:
            return f"{count:.3g} {unit}"
        count /= 1000
    return f"{count:.3g} TB"
