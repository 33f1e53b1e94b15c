"""LayoutVLM: ``layout.json`` with poses alone; sizes, walls and the request come from its input JSON beside it."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from sceneweaver.io import InputError, load_json
from sceneweaver.io.references import named_inside

from ..frames import euler_matrix
from ..model import Mount, ReadOptions, SourceFormat, SourceObject, SourceRoom
from ..values import Entry

_FIRST = re.compile(rb'\s*\{\s*"[^"]{1,200}-[0-9]+"\s*:\s*\{\s*"(?:position|rotation)"\s*:\s*\[')
_NAME = re.compile(r"(.+)-([0-9]+)")
_OTHERS = 64
"""JSON files beside a layout that are looked at for its input."""

MOUNTS: tuple[tuple[str, Mount], ...] = (
    ("onFloor", "floor"),
    ("onWall", "wall"),
    ("onCeiling", "ceiling"),
    ("onObject", "surface"),
)


def _matches(path: Path, head: bytes) -> bool:
    return path.suffix.lower() == ".json" and _FIRST.match(head) is not None


def _read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    layout = Entry.of(path, load_json(path))
    notes: list[str] = []
    task = _task(path, options.folder)
    assets: dict[str, Entry] = {}
    outline = height = None
    if task is None:
        notes.append("no input JSON (with boundary and assets) beside the layout: no walls, no sizes, no request")
    else:
        boundary = task["boundary"]
        corners = [
            v.numbers(len(v.value) if isinstance(v.value, list) else 3) for v in boundary["floor_vertices"].entries()
        ]
        outline = tuple((c[0], c[1]) for c in corners)
        height = boundary["wall_height"].length() if boundary.has("wall_height") else None
        assets = _assets(task, options.folder, set(layout.mapping()))
    objects = []
    for name, item in layout.items():
        if not isinstance(item.value, dict) or not item.has("position"):
            notes.append(f"{name}: no position (LayoutVLM left it unplaced); left out")
            continue
        objects.append(_object(name, item, assets.get(name), notes))
    yield SourceRoom(
        path.stem if path.stem != "layout" else (path.parent.name or "layout"),
        outline=outline,
        height=height,
        objects=tuple(objects),
        text=task.word("task_description") if task is not None else "",
        notes=tuple(notes),
    )


def _task(path: Path, folder: Path | None) -> Entry | None:
    """The input of the run: a JSON file with ``boundary`` and ``assets`` in the layout's folder, or in the user's."""
    for place in (path.parent, folder):
        if place is None:
            continue
        for other in sorted(place.glob("*.json"))[:_OTHERS]:
            if other.name == path.name:
                continue
            try:
                data = load_json(other)
            except InputError:
                continue
            if isinstance(data, dict) and "boundary" in data and "assets" in data:
                return Entry.of(other, data)
    return None


def _assets(task: Entry, folder: Path | None, placed: set[str]) -> dict[str, Entry]:
    """What is known of each object, by its name in the layout; boxes have x along the front.

    A prepared input has these names (``placed``) and boxes already. A raw one has ``<uid>-<i>``: its entries, or
    ``<folder>/<uid>/data.json``, have x and y the other way round and get the names that LayoutVLM gives them.
    """
    given = dict(task["assets"].items())
    if placed & set(given) or any("asset_var_name" in e.mapping() for e in given.values()):
        return given
    known: dict[str, list[Entry]] = defaultdict(list)
    for name, entry in given.items():
        match = _NAME.fullmatch(name)
        uid = match[1] if match else name
        data = entry if entry.has("assetMetadata") else _annotation(folder, uid)
        if data is not None:
            known[uid].append(data)
    names = {uid: _variable(entries[0]) for uid, entries in known.items()}
    letter: dict[str, int] = defaultdict(int)
    found: dict[str, Entry] = {}
    for uid, entries in known.items():
        name = names[uid]
        letter[name] += 1
        alone = list(names.values()).count(name) == 1
        variable = name if alone else f"{name}_{chr(ord('A') + letter[name] - 1)}"
        for i, entry in enumerate(entries):
            found[f"{variable}-{i}"] = Entry(_turned(entry, uid), entry.file, entry.place)
    return found


def _annotation(folder: Path | None, uid: str) -> Entry | None:
    if folder is None:
        return None
    place = named_inside(folder, folder / uid / "data.json")
    return Entry.of(place, load_json(place)) if place is not None and place.is_file() else None


def _variable(entry: Entry) -> str:
    annotations = entry.find("annotations")
    category = entry.word("category") or (annotations.word("category") if annotations is not None else "") or "object"
    return re.sub(r"[-' /,]", "_", category).lower()


def _turned(entry: Entry, uid: str) -> dict[str, Any]:
    """A raw entry as a prepared one: flags and category at the top, x and y of its box exchanged."""
    box = entry["assetMetadata"]["boundingBox"].mapping()
    annotations = entry.get("annotations")
    top = annotations if isinstance(annotations, dict) else {}
    turned = {"x": box.get("y"), "y": box.get("x"), "z": box.get("z")}
    return {**top, **entry.value, "uid": uid, "assetMetadata": {"boundingBox": turned}}


def _object(name: str, item: Entry, asset: Entry | None, notes: list[str]) -> SourceObject:
    x, y, z = item["position"].numbers(3)
    turn = euler_matrix(item["rotation"].numbers(3, -1e6, 1e6)) if item.has("rotation") else euler_matrix((0, 0, 0))
    match = _NAME.fullmatch(name)
    label = match[1] if match else name
    size = uid = None
    mount: Mount | None = None
    description = ""
    if asset is not None:
        label, uid, description = asset.word("category", label), asset.word("uid"), asset.word("description")
        mount = next((kind for flag, kind in MOUNTS if asset.get(flag) is True), None)
        if asset.has("assetMetadata"):
            box = asset["assetMetadata"]["boundingBox"]
            size = box.sides(box.named("xyz"))
    if size is None:
        notes.append(f"{name}: no box of its asset in the input; its size is not known")
    return SourceObject(name, label, (x, y, z), turn, size, asset=uid or None, mount=mount, description=description)


FORMAT = SourceFormat(
    "layoutvlm",
    "LayoutVLM layouts",
    _matches,
    _read,
    notes=(
        "Read: positions (centres of boxes) and angles [degrees] of layout.json; boundary, wall height, request and "
        "boxes of the input JSON beside it or in the asset folder, whose <uid>/data.json is read as well.",
        "The front is +x at 0; boxes of a prepared input have x along the front, those of a raw one y.",
        "There are no doors or windows. Three angles are turned about fixed x, y, z, in this order.",
    ),
    licence="MIT (code and tasks); assets of Objaverse have their own",
)
