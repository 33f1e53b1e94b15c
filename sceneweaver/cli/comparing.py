"""``sceneweaver evaluate`` and ``sceneweaver compare``."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from sceneweaver.io import InputError, locked
from sceneweaver.io.messages import printable_line, show, suggest

from .clock import Clock, clock
from .exit_codes import NOT_VALID, UNFINISHED
from .output import LONGEST, complain, list_files, print_json
from .streams import no_chatter

if TYPE_CHECKING:
    from sceneweaver.evaluation import Comparison, Reading, Requests, SceneRow
    from sceneweaver.runtime.deadline import Deadline

MOST_SYSTEMS = 50

KEPT = 0.1
"""Share of the time that is kept for writing the page, `MOST_KEPT` seconds at most."""

MOST_KEPT = 30.0


@dataclass(frozen=True)
class CompareOptions:
    """What both commands take; of ``formats``, ``folders`` and ``sizes`` each is a value for all systems, or
    ``NAME=value`` for one."""

    formats: Sequence[str] = ()
    folders: Sequence[str] = ()
    sizes: Sequence[str] = ()
    assets: str = "own"
    assume_sizes: bool = False
    prompts: Path | None = None
    reference: str | None = None
    stability: bool = True
    limit: int | None = None
    jobs: int = 1
    scene_limit: float = 120.0
    pictures: int = 3
    time_limit: float | None = None
    as_json: bool = False


def run_evaluate(sources: Sequence[str], out: Path, options: CompareOptions, began: float) -> int:
    """Judge files and folders of one system; as `run_compare`."""
    named = named_sources(sources)
    name = next(iter(named)) if len(named) == 1 else "scenes"
    return _run({name: list(named.values())}, out, options, "evaluation", began)


def run_compare(sources: Sequence[str], out: Path, options: CompareOptions, began: float) -> int:
    """Judge systems and write their table; the time limit [s] counts from ``began``, by ``time.monotonic()``."""
    systems = {name: [path] for name, path in named_sources(sources).items()}
    return _run(systems, out, options, "comparison", began)


def _run(systems: Mapping[str, list[Path]], out: Path, options: CompareOptions, stem: str, began: float) -> int:
    with no_chatter():
        from sceneweaver.evaluation import Requests

        readings = _readings(systems, options)
        requests = Requests.load(options.prompts) if options.prompts is not None else None
    if out.exists() and not out.is_dir():
        raise InputError(f"--out: {out} is a file; give a folder")
    try:
        out.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(f"--out: {out} cannot be made ({error.strerror or error}); choose another place") from None
    with locked(out / f"{stem}.json", f"--out: {out}"), clock(options.time_limit, began) as until, no_chatter():
        found, paths = _judged(systems, readings, requests, out, options, stem, until)
    return _told(found, paths, options.as_json)


def _judged(
    systems: Mapping[str, list[Path]],
    readings: Mapping[str, Reading],
    requests: Requests | None,
    out: Path,
    options: CompareOptions,
    stem: str,
    until: Clock,
) -> tuple[Comparison, list[Path]]:
    from sceneweaver.evaluation import compare
    from sceneweaver.evaluation.files import add_row, read_known, row_file, schema, write_comparison

    schema()  # Parquet needs pyarrow: better now than after an hour
    known = read_known(out)
    deadline = until.deadline.before(_kept(until.deadline))
    with row_file(out) as file:

        def keep(row: SceneRow) -> None:
            add_row(file, row)

        found = compare(
            systems,
            readings=readings,
            prompts=requests,
            reference=options.reference,
            stability=options.stability,
            limit=options.limit,
            jobs=options.jobs,
            scene_limit=options.scene_limit,
            on_error=lambda name, line: _complain(name, line),
            on_row=keep,
            known=known,
            deadline=deadline,
            pictures=options.pictures,
        )
    return found, write_comparison(found, out, stem, until.deadline)


def _complain(name: str, line: str) -> None:
    complain(f"{name}: {line}")


def _kept(deadline: Deadline) -> float:
    """Seconds that are kept for writing."""
    return min(MOST_KEPT, KEPT * deadline.left) if deadline.end < float("inf") else 0.0


def _told(found: Comparison, paths: list[Path], as_json: bool) -> int:
    judged = sum(system.judged for system in found.systems)
    failed = any(system.failed or system.refused for system in found.systems)
    code = UNFINISHED if found.cut_off else 0 if judged and not failed else NOT_VALID
    if as_json:
        files = {path.suffix[1:]: str(path) for path in paths}
        print_json({"exit_code": code, **found.to_dict(), "files": files})
        return code
    _print_table(found)
    for system in found.systems:
        for row in system.failed[:5]:
            typer.echo(printable_line(f"  {system.name}, {row.scene}: not judged, {row.error}", LONGEST))
    if found.cut_off:
        typer.echo("  time was up before all scenes were judged; run it again to go on")
    list_files(paths)
    return code


def _print_table(found: Comparison) -> None:
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    from sceneweaver.evaluation import METRICS

    table = Table()
    table.add_column("figure")
    for system in found.systems:
        table.add_column(Text(f"{system.name}\nn = {system.judged}"), justify="right")
    for metric in METRICS:
        cells = [system.figures[metric.key].text(metric) for system in found.systems]
        table.add_row(metric.title, *(Text(printable_line(cell, LONGEST)) for cell in cells))
    Console().print(table)


def named_sources(sources: Sequence[str]) -> dict[str, Path]:
    """Paths by the names of their systems: ``name=path``, else the name of the file or folder.

    Raises:
        InputError: a path that is not there, two systems of one name, or too many.
    """
    if len(sources) > MOST_SYSTEMS:
        raise InputError(f"{len(sources)} systems; at most {MOST_SYSTEMS} are compared")
    found: dict[str, Path] = {}
    for source in sources:
        name, equals, rest = source.partition("=")
        path = Path(source) if not equals or Path(source).exists() else Path(rest)
        if not path.exists():
            raise InputError(f"{path}: no such file or folder")
        if not equals or path == Path(source):
            name = path.resolve().stem if path.is_file() else path.resolve().name
        if not name or not name.isprintable():
            raise InputError(f"{show(source)}: give a system as name=path")
        if name in found:
            raise InputError(f"{show(name)} is the name of two systems; give each its own as name=path")
        found[name] = path
    return found


def _readings(systems: Mapping[str, list[Path]], options: CompareOptions) -> dict[str, Reading]:
    from sceneweaver.evaluation import Reading
    from sceneweaver.importers import AUTO, formats
    from sceneweaver.importers.own import OWN
    from sceneweaver.importers.read import KINDS
    from sceneweaver.importers.sizes import load_sizes

    if options.assets not in KINDS:
        raise InputError(f"--assets: '{options.assets}' is unknown{suggest(options.assets, KINDS)}")
    by_name = {
        option: _by_name(f"--{option}", values, systems)
        for option, values in (("from", options.formats), ("asset-folder", options.folders), ("sizes", options.sizes))
    }
    known = {AUTO, OWN, *formats()}
    for value in by_name["from"].values():
        if value not in known:
            raise InputError(f"--from: '{value}' is unknown{suggest(value, known)}")
    found = {}
    for name in systems:
        folder, sizes = by_name["asset-folder"].get(name), by_name["sizes"].get(name)
        found[name] = Reading(
            format=by_name["from"].get(name, AUTO),
            assets=options.assets,  # pyright: ignore[reportArgumentType]
            folder=Path(folder) if folder is not None else None,
            sizes=load_sizes(Path(sizes)) if sizes is not None else None,
            assume_sizes=options.assume_sizes,
        )
    return found


def _by_name(option: str, values: Sequence[str], systems: Mapping[str, list[Path]]) -> dict[str, str]:
    """The values of an option by system: those for all, then those for one."""
    found: dict[str, str] = {}
    for value in sorted(values, key=lambda v: v.partition("=")[0] in systems and "=" in v):
        name, equals, rest = value.partition("=")
        if equals and name in systems:
            found[name] = rest
        elif equals and not Path(value).exists():
            raise InputError(f"{option}: {show(name)} is no system here{suggest(name, systems)}")
        else:
            found |= dict.fromkeys(systems, value)
    return found
