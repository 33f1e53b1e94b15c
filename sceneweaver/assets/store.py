"""The asset store: imported assets by the hash of their content, one folder and one manifest row each.

``ROOT/objects/ab/abcd.../body.npz`` holds the arrays and ``row.json`` the manifest row. A folder is written under a
temporary name and renamed when it is whole, so that readers never see half an asset and two processes that import the
same asset at once do no harm: one of them comes second and leaves what is there.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from contextlib import AbstractContextManager
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.io import (
    load_json,
    own_folder,
    parse_json,
    read_arrays,
    read_bytes,
    reason,
    sweep,
    temporary_folder,
    write_atomic,
)
from sceneweaver.io.messages import quote, suggest
from sceneweaver.runtime.caches import cache_place, kept_in
from sceneweaver.scene import InputError, Part, Surface, Zone

from .asset import Asset, Origin
from .body import Grasp, Hull, Interior, Link, Material, Mesh

SCHEMA = "sceneweaver.asset/1"

_FACTS = {"hash": str, "size": list, "attributes": dict} | dict.fromkeys(
    ("category", "description", "source", "licence", "attribution"), str
)
"""What an asset is found and listed by, as a row has it."""


def default_root() -> Path:
    """``$SCENEWEAVER_ASSETS``, or the user's cache folder, or what stands in for that where it cannot be written."""
    given = os.environ.get("SCENEWEAVER_ASSETS")
    return Path(given).expanduser() if given else kept_in(cache_place("sceneweaver/assets"))


class Store:
    """A folder of assets; safe to share between processes."""

    def __init__(self, root: Path | None = None):
        self.root = default_root() if root is None else Path(root)

    @property
    def cache(self) -> Path:
        """Where convex decompositions and other costly results are kept."""
        return self.root / "cache"

    def add(self, asset: Asset, content: str) -> bool:
        """Keep an asset under the hash of its content; False when it was there already.

        Raises:
            InputError: when the folder cannot be written; nothing half-written stays behind.
        """
        final = self._folder(content)
        if (final / "row.json").exists():
            return False
        try:
            with self._draft() as draft:
                _write_body(draft / "body.npz", asset)
                write_atomic(draft / "row.json", json.dumps(row_of(asset, content), indent=1) + "\n")
                own_folder(self.root / "objects")
                own_folder(final.parent)
                os.rename(draft, final)
        except OSError as error:
            if (final / "row.json").exists():  # another process was quicker
                return False
            line = f"{self.root}: the store cannot be written ({reason(error)}); choose another with --store"
            raise InputError(line) from error
        return True

    def rows(self) -> Iterator[dict[str, Any]]:
        """All manifest rows, by id.

        Raises:
            InputError: when one lacks what an asset is found by, or has something else in its place.
        """
        found = []
        for path in self.root.glob("objects/*/*/row.json"):
            try:
                row = parse_json(read_bytes(path))
            except InputError:
                continue  # being removed by another process, or not ours
            if isinstance(row, dict) and row.get("schema") == SCHEMA and isinstance(row.get("id"), str):
                _require_facts(row, path.parent)
                found.append(row)
        yield from sorted(found, key=lambda row: row["id"])

    def load(self, asset_id: str) -> Asset:
        """An asset by id; InputError when the store has none of that id."""
        tail = asset_id.rpartition("-")[2]
        for path in self.root.glob(f"objects/{tail[:2]}/{tail}*/row.json") if len(tail) >= 8 else ():
            row = load_json(path)
            if isinstance(row, dict) and row.get("id") == asset_id:
                try:
                    return _read(path.parent, row)
                except (InputError, KeyError, TypeError, AttributeError, IndexError) as error:
                    why = f"damaged in the store ({reason(error)}); delete {path.parent} and import it anew"
                    raise InputError(f"asset: '{asset_id}' is {why}") from error
        known = [row["id"] for row in self.rows()]
        raise InputError(f"asset: '{asset_id}' is not in the store {self.root}{suggest(asset_id, known)}")

    def remove(self, asset_id: str) -> None:
        """Forget an asset; InputError when the store has none of that id."""
        asset_hash = next((row["hash"] for row in self.rows() if row["id"] == asset_id), None)
        if asset_hash is None:
            raise InputError(f"asset: '{asset_id}' is not in the store {self.root}")
        with self._draft() as trash:
            os.rename(self._folder(asset_hash), trash / "removed")

    def _draft(self) -> AbstractContextManager[Path]:
        """A temporary folder on the disk of the store; what a killed process left there goes."""
        self.root.mkdir(parents=True, exist_ok=True)
        drafts = own_folder(self.root / "drafts")
        sweep(drafts)
        return temporary_folder(drafts)

    def _folder(self, content: str) -> Path:
        return self.root / "objects" / content[:2] / content


def _require_facts(row: dict[str, Any], folder: Path) -> None:
    """InputError when a row lacks what an asset is found by."""
    wrong = next((key for key, kind in _FACTS.items() if not isinstance(row.get(key), kind)), None)
    if wrong is None and not (len(row["size"]) == 3 and all(isinstance(v, float | int) for v in row["size"])):
        wrong = "size"
    if wrong is not None:
        line = f"damaged in the store ('{wrong}' is missing or wrong); delete {folder} and import it anew"
        raise InputError(f"asset: {quote(row['id'])} is {line}")


def row_of(asset: Asset, content: str) -> dict[str, Any]:
    """The manifest row: all facts about an asset that are no arrays."""
    origin = asdict(asset.origin)
    return {
        "schema": SCHEMA,
        "id": asset.id,
        "hash": content,
        "category": asset.category,
        "description": asset.description,
        "source": origin.pop("source"),
        "licence": origin.pop("licence"),
        "attribution": origin.pop("attribution"),
        "axes": origin.pop("axes"),
        "metres_per_unit": origin.pop("metres_per_unit"),
        "front_confidence": origin.pop("front_confidence"),
        "notes": list(origin.pop("notes")),
        "size": list(asset.size),
        "mount": asset.mount,
        "mass": asset.mass,
        "friction": asset.friction,
        "sides": list(asset.sides),
        "attributes": asset.attributes,
        "parts": [part.model_dump(mode="json") for part in asset.parts],
        "surfaces": [surface.model_dump(mode="json") for surface in asset.surfaces],
        "zones": [zone.model_dump(mode="json") for zone in asset.zones],
        "links": [asdict(link) for link in asset.links],
        "grasps": [asdict(grasp) for grasp in asset.grasps],
        "interiors": [asdict(room) for room in asset.interiors],
        "masses": list(asset.masses),
        "materials": [asdict(material) for material in asset.mesh.materials],
        "triangles": len(asset.mesh.faces),
        "hulls": len(asset.hulls),
    }


def _write_body(path: Path, asset: Asset) -> None:
    mesh = asset.mesh
    np.savez_compressed(
        path,
        vertices=mesh.vertices,
        faces=mesh.faces,
        face_material=mesh.face_material,
        face_link=mesh.face_link,
        hull_vertices=np.concatenate([h.vertices for h in asset.hulls]),
        hull_faces=np.concatenate([h.faces for h in asset.hulls]),
        hull_counts=np.array([(len(h.vertices), len(h.faces), h.link, h.handle) for h in asset.hulls]),
    )


def _read(folder: Path, row: dict[str, Any]) -> Asset:
    arrays = read_arrays(folder / "body.npz")
    materials = tuple(Material(**{**m, "color": tuple(m["color"])}) for m in row["materials"])
    hulls, v, f = [], 0, 0
    for points, triangles, link, *handle in arrays["hull_counts"].tolist():
        corners, faces = arrays["hull_vertices"][v : v + points], arrays["hull_faces"][f : f + triangles]
        hulls.append(Hull(corners, faces, link, any(handle)))
        v, f = v + points, f + triangles
    return Asset(
        id=row["id"],
        category=row["category"],
        mesh=Mesh(arrays["vertices"], arrays["faces"], arrays["face_material"], arrays["face_link"], materials),
        hulls=tuple(hulls),
        parts=tuple(Part(**part) for part in row["parts"]),
        mount=row["mount"],
        mass=row["mass"],
        friction=row["friction"],
        origin=Origin(
            row["source"],
            row["licence"],
            row["attribution"],
            row["axes"],
            row["metres_per_unit"],
            row["front_confidence"],
            tuple(row["notes"]),
        ),
        surfaces=tuple(Surface(**surface) for surface in row["surfaces"]),
        zones=tuple(Zone(**zone) for zone in row["zones"]),
        sides=tuple(row["sides"]),
        links=tuple(Link(**_tuples(k)) for k in row["links"]),
        grasps=tuple(Grasp(**_tuples(k)) for k in row.get("grasps", ())),  # assets kept by older versions have none
        interiors=tuple(Interior(**_tuples(k)) for k in row.get("interiors", ())),
        masses=tuple(row.get("masses", ())),
        attributes=row["attributes"],
        description=row["description"],
    )


def _tuples(row: dict[str, Any]) -> dict[str, Any]:
    """A row with tuples where JSON has lists."""
    return {key: tuple(value) if isinstance(value, list) else value for key, value in row.items()}
