"""``sceneweaver import``: scenes of other systems into scene files."""

from __future__ import annotations

import json
from collections import Counter
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from sceneweaver.io import write_atomic
from sceneweaver.io.messages import printable_line
from sceneweaver.scene import InputError

from .exit_codes import BAD_INPUT, NOT_VALID
from .output import LONGEST, complain, print_json
from .streams import no_chatter

if TYPE_CHECKING:
    from sceneweaver.importers import ImportedScene
    from sceneweaver.importers.bodies import Assets

INDEX = "import.json"
"""What became of each scene, beside the scenes of a folder."""

MOST_NOTES = 8
"""Notes of a scene that are listed on a terminal; the index and --json have them all."""

SHOWN = 20
"""Scenes that are listed on a terminal."""


def run_import(
    source: Path,
    out: Path,
    *,
    format_name: str,
    assets: Assets,
    folder: Path | None,
    sizes: Path | None,
    room: str | None,
    relations: bool,
    limit: int | None,
    as_json: bool,
) -> int:
    """Write the scenes of a file or folder: one into ``out`` when that ends in .json, else each into that folder."""
    with no_chatter():
        from sceneweaver.importers import read_scenes
        from sceneweaver.importers.sizes import load_sizes

        table = load_sizes(sizes) if sizes is not None else None
    single = out.suffix == ".json"
    refused: list[str] = []
    rows: list[dict[str, Any]] = []
    kept: ImportedScene | None = None

    def refuse(line: str) -> None:
        refused.append(line)
        complain(line)

    with no_chatter():
        found = read_scenes(
            source,
            format_name,
            assets=assets,
            folder=folder,
            sizes=table,
            room=room,
            relations=relations,
            on_error=None if single else refuse,
        )
        for imported in found:
            if limit is not None and len(rows) >= limit:
                break
            if single and kept is not None:
                raise InputError(f"--out: {source} has several scenes; give a folder, or choose one with --room")
            kept = imported
            place = out if single else out / f"{imported.scene.id}.json"
            if not single:
                out.mkdir(parents=True, exist_ok=True)
                imported.scene.save(place)
            rows.append(_row(imported, place))
    if single and kept is not None:
        out.parent.mkdir(parents=True, exist_ok=True)
        kept.scene.save(out)
    report = {"scenes": rows, "refused": refused}
    if rows and not single:
        write_atomic(out / INDEX, json.dumps(report, ensure_ascii=False, indent=1).encode())
    if as_json:
        print_json(report)
    else:
        _tell(rows, refused, out)
    return 0 if rows and not refused else NOT_VALID if rows else BAD_INPUT


def _row(imported: ImportedScene, place: Path) -> dict[str, Any]:
    scene = imported.scene
    sure = imported.confidence.values()
    return {
        "file": str(place),
        "format": imported.format,
        "room": imported.room,
        "objects": len(scene.objects),
        "relations": len(scene.relations),
        "boundary": imported.boundary,
        "confidence": round(sum(sure) / len(sure), 3) if sure else None,
        "sizes_from": dict(sorted(Counter(imported.sizes_from.values()).items())),
        "notes": list(imported.notes),
    }


def _tell(rows: list[dict[str, Any]], refused: list[str], out: Path) -> None:
    for row in rows[:SHOWN]:
        typer.echo(f"{row['file']}  {row['format']}, {row['objects']} objects, {row['relations']} relations")
        if len(rows) == 1:
            for note in row["notes"][:MOST_NOTES]:
                typer.echo(printable_line(f"    {note}", LONGEST))
            if len(row["notes"]) > MOST_NOTES:
                typer.echo(f"    and {len(row['notes']) - MOST_NOTES} notes more; --json has them")
    if len(rows) > 1:
        typer.echo(f"{len(rows)} scenes imported, {len(refused)} files or rooms refused, into {out}")
