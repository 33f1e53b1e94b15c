"""``sceneweaver import --home``: plans of other systems into files of homes."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from sceneweaver.io import write_atomic
from sceneweaver.io.messages import printable_line
from sceneweaver.scene import InputError

from .exit_codes import BAD_INPUT, NOT_VALID
from .importing import INDEX, MOST_NOTES, SHOWN
from .output import LONGEST, complain, print_json
from .streams import no_chatter

if TYPE_CHECKING:
    from sceneweaver.importers import ImportedHome, PlanRepair
    from sceneweaver.importers.home.floors import Drawn


def run_import_homes(
    source: Path,
    out: Path,
    *,
    format_name: str,
    drawn: Drawn,
    scale: float | None,
    folder: Path | None,
    profile: str | None,
    limit: int | None,
    as_json: bool,
) -> int:
    """Write the homes of a file or folder: one into ``out`` when that ends in .json, else each into that folder.

    ``profile`` is that by which plans are repaired; None: they stay as they are. The exit code tells of files that were
    refused, not of plans that break rules.
    """
    with no_chatter():
        from sceneweaver.importers import read_homes, repair_plan
    single = out.suffix == ".json"
    refused: list[str] = []
    rows: list[dict[str, Any]] = []

    def refuse(line: str) -> None:
        refused.append(line)
        complain(line)

    with no_chatter():
        found = read_homes(
            source, format_name, drawn=drawn, scale=scale, folder=folder, on_error=None if single else refuse
        )[:limit]
        if single and len(found) > 1:
            raise InputError(f"--out: {source} has {len(found)} homes; give a folder, or choose one file")
        for imported in found:
            mended = None if profile is None else repair_plan(imported.home, profile)
            place = out if single else out / f"{imported.home.id}.json"
            place.parent.mkdir(parents=True, exist_ok=True)
            (imported.home if mended is None else mended.home).save(place)
            rows.append(_row(imported, mended, place))
    report = {"homes": rows, "refused": refused}
    if rows and not single:
        write_atomic(out / INDEX, json.dumps(report, ensure_ascii=False, indent=1).encode())
    if as_json:
        print_json(report)
    else:
        _tell(rows, refused, out)
    return 0 if rows and not refused else NOT_VALID if rows else BAD_INPUT


def _row(imported: ImportedHome, mended: PlanRepair | None, place: Path) -> dict[str, Any]:
    home = imported.home
    row: dict[str, Any] = {
        "file": str(place),
        "format": imported.format,
        "storeys": len(home.storeys),
        "rooms": len(home.rooms),
        "doors": len(home.doors),
        "windows": len(home.windows),
        "notes": list(imported.notes),
    }
    if mended is not None:
        row["before"] = [f"{v.rule}: {v.detail}" for v in mended.before.violations]
        row["left"] = list(mended.left)
        row["moved"] = [f"{m.what} {m.id}: {m.how}{f' by {m.by:.3f} m' if m.by else ''}" for m in mended.moved]
    return row


def _tell(rows: list[dict[str, Any]], refused: list[str], out: Path) -> None:
    for row in rows[:SHOWN]:
        line = f"{row['file']}  {row['format']}, {row['rooms']} rooms, {row['doors']} doors, {row['windows']} windows"
        if "left" in row:
            line += f"; {len(row['before'])} rules broken, {len(row['left'])} after {len(row['moved'])} changes"
        typer.echo(line)
        if len(rows) == 1:
            for note in (row["notes"] + row.get("moved", []) + row.get("left", []))[: 3 * MOST_NOTES]:
                typer.echo(printable_line(f"    {note}", LONGEST))
    if len(rows) > 1:
        typer.echo(f"{len(rows)} homes imported, {len(refused)} files refused, into {out}")
