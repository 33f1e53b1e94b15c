"""``sceneweaver assets``: what the commands do."""

from __future__ import annotations

import io
import json
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from sceneweaver.io import write_atomic
from sceneweaver.io.messages import suggest
from sceneweaver.scene import InputError

from .exit_codes import BAD_INPUT, NOT_VALID
from .output import complain, list_files
from .streams import no_chatter

if TYPE_CHECKING:
    from PIL.Image import Image

    from sceneweaver.assets import Asset
    from sceneweaver.assets.imports.hints import Hints, SeenFront
    from sceneweaver.llm import ModelClient

ASK = "ask"
"""Value of ``--front`` that lets a model look."""


def run_sheet(
    names: list[str], out: Path, *, seeds: int, columns: int, tile: int, view: str, store: Path | None, device: str
) -> int:
    """Draw a contact sheet of categories, or of assets by id."""
    from sceneweaver.assets.parametric import make, makers
    from sceneweaver.assets.sources import Library, ParametricSource, StoreSource
    from sceneweaver.assets.store import Store
    from sceneweaver.render.studio import VIEWS, contact_sheet

    if view not in VIEWS:
        raise InputError(f"view: '{view}' is unknown{suggest(view, VIEWS)}")
    library = Library([StoreSource(Store(store)), ParametricSource()])
    known = makers()
    for name in names:
        if ":" not in name and name not in known:
            raise InputError(f"category: '{name}' is unknown{suggest(name, known)}")

    def rows():
        for name in names or sorted(known):
            if ":" in name:
                yield name.partition(":")[2], library.load(name)
                continue
            for seed in range(seeds):
                yield name.replace("_", " ") + (f" {seed}" if seeds > 1 else ""), make(name, seed)

    return _save_sheet(contact_sheet(rows(), columns=columns, tile=tile, view=view, device=device), out)


def run_materials(names: list[str], out: Path, *, columns: int, tile: int) -> int:
    """Draw a contact sheet of patterns of materials."""
    from sceneweaver.render.studio import grid_of
    from sceneweaver.render.swatches import swatches

    return _save_sheet(grid_of(list(swatches(names, tile)), columns, tile), out)


def _save_sheet(image: Image, out: Path) -> int:
    buffer = io.BytesIO()
    if out.suffix.lower() in (".jpg", ".jpeg"):
        image.save(buffer, format="JPEG", quality=82, optimize=True)
    else:
        image.save(buffer, format="PNG", optimize=True)
    write_atomic(out, buffer.getvalue())
    typer.echo(f"{out}: {image.width} x {image.height} pixels")
    return 0


def run_list(*, store: Path | None, source: str | None, allow: list[str], as_json: bool) -> int:
    """List categories that can be drawn and assets of the store."""
    from sceneweaver.assets.category import categories
    from sceneweaver.assets.parametric import makers
    from sceneweaver.assets.store import Store

    rows = []
    if source in (None, "parametric"):
        for name in sorted(makers()):
            sizes = categories()[name].size
            assert sizes is not None
            rows.append(
                {
                    "id": f"parametric:{name}",
                    "category": name,
                    "source": "parametric",
                    "licence": "Apache-2.0",
                    "size": [f"{a:g}-{b:g}" for a, b in sizes.ranges],
                    "synonyms": list(categories()[name].synonyms),
                }
            )
    if source != "parametric":
        keys = ("id", "category", "source", "licence", "size", "attribution", "hash")
        stored = ({k: row[k] for k in keys} for row in Store(store).rows())
        rows += [row for row in stored if source in (None, row["source"])]
    if allow:
        rows = [row for row in rows if row["licence"] in allow]
    if as_json:
        typer.echo(json.dumps(rows, ensure_ascii=False, indent=1))
        return 0
    for row in rows:
        size = " x ".join(v if isinstance(v, str) else f"{v:.2f}" for v in row["size"])
        typer.echo(f"{row['id']:<44} {size:<32} {row['licence']}")
    typer.echo(f"{len(rows)} in all")
    return 0


def _named(asset_id: str, store: Path | None, seed: int) -> Asset:
    """The asset of an id, or a drawn one of what a word means."""
    from sceneweaver.assets.sources import Library, ParametricSource, StoreSource
    from sceneweaver.assets.store import Store
    from sceneweaver.assets.taxonomy import resolve

    if ":" not in asset_id:
        match = resolve(asset_id)
        if match.note:
            complain(match.note)
        label = f"&label={match.category}" if match.generic else ""
        asset_id = f"parametric:{match.body}?seed={seed}{label}"
    return Library([StoreSource(Store(store)), ParametricSource()]).load(asset_id)


def run_urdf(asset_id: str, out: Path, *, store: Path | None, seed: int, as_json: bool) -> int:
    """Write one asset as a URDF folder."""
    with no_chatter():
        from sceneweaver.export import write_urdf

        asset = _named(asset_id, store, seed)
        path = write_urdf(asset, out)
    if as_json:
        typer.echo(json.dumps({"id": asset.id, "file": str(path), "joints": [link.name for link in asset.links]}))
        return 0
    typer.echo(f"{asset.id}: {len(asset.links)} doors and drawers, {asset.mass:.1f} kg")
    list_files([path])
    return 0


def run_show(asset_id: str, *, store: Path | None, seed: int, picture: Path | None, as_json: bool) -> int:
    """Say all about one asset, or about what a word means."""
    from sceneweaver.assets.imports.prepare import content_hash
    from sceneweaver.assets.store import row_of

    asset = _named(asset_id, store, seed)
    row = row_of(asset, content_hash(asset))
    if picture is not None:
        from sceneweaver.render.studio import portrait

        buffer = io.BytesIO()
        portrait(asset, 640).save(buffer, format="PNG")
        write_atomic(picture, buffer.getvalue())
    if as_json:
        typer.echo(json.dumps(row, ensure_ascii=False, indent=1))
        return 0
    for key in (
        "id",
        "category",
        "description",
        "source",
        "licence",
        "attribution",
        "size",
        "mount",
        "mass",
        "friction",
        "sides",
        "attributes",
        "triangles",
        "hulls",
        "front_confidence",
        "notes",
        "hash",
    ):
        if row[key] not in ("", [], {}, None):
            typer.echo(f"{key:<17} {row[key]}")
    typer.echo(f"{'prisms':<17} {len(row['parts'])}")
    for surface in row["surfaces"]:
        room = "open above" if surface["headroom"] is None else f"{surface['headroom']:.3f} m of head room"
        typer.echo(f"{'surface':<17} {surface['name']} at {surface['z']:.3f} m, {room}")
    for zone in row["zones"]:
        typer.echo(f"{'zone':<17} {zone['name']}")
    for link in row["links"]:
        typer.echo(f"{'link':<17} {link['name']} ({link['joint']})")
    return 0


def run_import(
    source: Path,
    *,
    kind: str,
    store: Path | None,
    category: str | None,
    up: str | None,
    front: str | None,
    model: str | None,
    base_url: str | None,
    unit: float | None,
    licence: str | None,
    allow: list[str],
    time_limit: float,
    limit: int | None,
    as_json: bool,
) -> int:
    """Bring mesh files into the store; what cannot be used is named, and the rest goes on.

    With ``front`` "ask" a model looks at those whose front no file states.
    """
    from sceneweaver.assets.imports.prepare import content_hash, prepare
    from sceneweaver.assets.readers import entries
    from sceneweaver.assets.store import Store

    keep = Store(store)
    asking = front == ASK
    if not asking and (model or base_url):
        raise InputError("--model and --base-url are for --front ask; add it, or leave them out")
    client = _client(model, base_url) if asking else None
    made, refused, skipped = [], [], 0
    for hints in entries(source, kind):
        if limit is not None and len(made) >= limit:
            break
        stated = None if asking else front
        hints = hints.with_(category=category, up=up, front=stated, metres=unit, licence=licence)
        if allow and hints.licence not in allow:
            skipped += 1
            continue
        try:
            asset = prepare(hints, cache=keep.cache, seconds=time_limit)
            if client is not None and (seen := _seen(client, hints, asset)) is not None:
                asset = prepare(hints.with_(seen=seen), cache=keep.cache, seconds=time_limit)
            new = keep.add(asset, content_hash(asset))
        except InputError as error:
            refused.append(str(error))
            complain(str(error))
            continue
        made.append(
            {
                "id": asset.id,
                "category": asset.category,
                "size": list(asset.size),
                "new": new,
                "front_confidence": asset.origin.front_confidence,
                "notes": list(asset.origin.notes),
            }
        )
        if not as_json:
            size = " x ".join(f"{v:.2f}" for v in asset.size)
            typer.echo(f"{asset.id}  {size} m{'' if new else '  (was there)'}")
            for note in asset.origin.notes:
                typer.echo(f"    {note}")
    if as_json:
        typer.echo(json.dumps({"imported": made, "refused": refused, "skipped": skipped}, ensure_ascii=False, indent=1))
    else:
        typer.echo(f"{len(made)} imported, {len(refused)} refused, {skipped} skipped by licence, into {keep.root}")
    if not made and not refused and not skipped:
        raise InputError(f"{source}: there are no mesh files in it")
    return 0 if not refused else NOT_VALID if made else BAD_INPUT


def _client(model: str | None, base_url: str | None) -> ModelClient:
    from sceneweaver.llm import Endpoint, open_client

    return open_client(Endpoint.of(model, base_url))


def _seen(client: ModelClient, hints: Hints, asset: Asset) -> SeenFront | None:
    """Where a model sees the front of an asset whose front nobody stated; None where it has none, or the model is not
    sure or gives no answer."""
    from sceneweaver.agent.by_model.fronts import front_by_views
    from sceneweaver.assets import categories
    from sceneweaver.assets.imports.hints import SeenFront
    from sceneweaver.llm import ModelError

    alike = asset.category in categories() and not asset.sides and asset.mount != "wall"
    if hints.front is not None or alike:
        return None
    try:
        found = front_by_views(client, asset)
    except ModelError as error:
        complain(f"{hints.name}: front found from the shape, as {error}")
        return None
    return SeenFront(found.quarters, found.confidence, found.by) if found.by == client.name else None


def run_infinigen(names: list[str], *, seeds: int, store: Path | None, time_limit: float, as_json: bool) -> int:
    """Run Infinigen's generators and keep what they make."""
    from sceneweaver.assets.sources.infinigen_host import COMMON, generate
    from sceneweaver.assets.store import Store

    keep = Store(store)
    rows, failed = [], 0
    if not as_json:
        typer.echo("Preparing Infinigen's environment (once; about 1 GB) ...", err=True)
    for outcome in generate(names or list(COMMON), range(seeds), keep, seconds=time_limit):
        failed += outcome.asset is None
        rows.append(
            {
                "category": outcome.category,
                "seed": outcome.seed,
                "seconds": round(outcome.seconds, 1),
                "id": outcome.asset.id if outcome.asset else None,
                "reason": outcome.reason,
            }
        )
        if not as_json:
            what = outcome.asset.id if outcome.asset else f"skipped: {outcome.reason}"
            typer.echo(f"{outcome.category} seed {outcome.seed}: {what} ({outcome.seconds:.1f} s)")
    if as_json:
        typer.echo(json.dumps(rows, ensure_ascii=False, indent=1))
    else:
        typer.echo(f"{len(rows) - failed} imported, {failed} skipped, into {keep.root}")
    return NOT_VALID if failed else 0
