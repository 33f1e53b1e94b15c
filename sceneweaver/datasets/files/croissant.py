"""Licences of a data set, and its Croissant metadata (version 1.1): files with checksums, and the index as records."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

import sceneweaver

from ..folder import Folder
from ..spec import Spec
from ..tables import read_schema, read_table
from ..templates import render

TEXTS = {
    "Apache-2.0": "https://www.apache.org/licenses/LICENSE-2.0",
    "BSD-3-Clause": "https://opensource.org/license/bsd-3-clause",
    "CC-BY-4.0": "https://creativecommons.org/licenses/by/4.0/",
    "CC-BY-NC-4.0": "https://creativecommons.org/licenses/by-nc/4.0/",
    "CC0-1.0": "https://creativecommons.org/publicdomain/zero/1.0/",
    "MIT": "https://opensource.org/license/mit",
}
"""Where the text of a licence stands."""

OWN = "Apache-2.0"
"""The licence of what the library itself draws and lays out."""


class Licence(NamedTuple):
    """A licence, with a source of assets that are under it, who is to be named, and how many assets these are."""

    name: str
    source: str
    attribution: str
    assets: int


DRAWN = Licence(OWN, "parametric", "sceneweaver", 0)
"""What holds where nothing came from elsewhere."""


def licences(folder: Folder) -> list[Licence]:
    """The licences of the assets of a data set, by name; one without assets is under the library's own."""
    rows = read_table(folder.asset_table) if folder.asset_table.exists() else ()
    found = Counter((row["licence"], row["source"], row["attribution"]) for row in rows)
    return [Licence(*key, count) for key, count in sorted(found.items())] or [DRAWN]


def licences_text(spec: Spec, used: list[Licence]) -> str:
    """``LICENSES.md``: every source of assets with its licence and attribution."""
    return render("files/licences.md", spec=spec, used=used, own=OWN, texts=TEXTS)


TYPES = {"bool": "sc:Boolean", "int32": "cr:Int32", "int64": "cr:Int64", "double": "cr:Float64", "string": "sc:Text"}


def croissant(
    folder: Folder, spec: Spec, numbers: dict[str, Any], used: list[Licence], sums: Mapping[str, str]
) -> dict[str, Any]:
    """The content of ``croissant.json``.

    Args:
        folder: the data set.
        spec: what it was made from.
        numbers: its statistics.
        used: licences of its assets.
        sums: SHA-256 of its files, by path.
    """
    from pyarrow.types import is_struct

    names = dict.fromkeys(one.name for one in used)
    table = folder.table(spec.product)
    index = _file(folder, table, "application/x-parquet", sums)
    columns = [column for column in read_schema(table) if not is_struct(column.type)]
    key, made = columns[0].name, f"made with sceneweaver {sceneweaver.__version__}"
    shards = sorted(path for path in folder.data.iterdir() if path.suffix in KINDS) if folder.data.exists() else []
    return {
        "@context": json.loads((Path(__file__).parent / "croissant_context.json").read_bytes()),
        "@type": "sc:Dataset",
        "conformsTo": "http://mlcommons.org/croissant/1.1",
        "name": spec.name,
        "description": f"Indoor {spec.product} of {numbers['rooms']} rooms, {made}.",
        "license": [TEXTS.get(name, name) for name in names],
        "version": "1.0.0",
        "citeAs": f"{spec.name}: {made}, specification {spec.hash}",
        "keywords": ["indoor scenes", "layout", "synthetic", "simulation"],
        "distribution": [index, *(_file(folder, path, KINDS[path.suffix], sums) for path in shards)],
        "recordSet": [
            {
                "@type": "cr:RecordSet",
                "@id": "scenes",
                "name": "scenes",
                "description": "One row a request; columns that are structs are left out.",
                "key": {"@id": f"scenes/{key}"},
                "field": [_field(index["@id"], column) for column in columns],
            }
        ],
    }


KINDS = {".tar": "application/x-tar", ".parquet": "application/x-parquet"}
"""Media types of shards by suffix."""


def _file(folder: Folder, path: Path, kind: str, sums: Mapping[str, str]) -> dict[str, Any]:
    name = path.relative_to(folder.path).as_posix()
    return {
        "@type": "cr:FileObject",
        "@id": name,
        "name": name,
        "contentUrl": name,
        "contentSize": f"{path.stat().st_size} B",
        "encodingFormat": kind,
        "sha256": sums[name],
    }


def _field(table: str, column: Any) -> dict[str, Any]:
    """A column of the index."""
    from pyarrow.types import is_list

    field = {
        "@type": "cr:Field",
        "@id": f"scenes/{column.name}",
        "name": column.name,
        "source": {"fileObject": {"@id": table}, "extract": {"column": column.name}},
    }
    if is_list(column.type):
        return field | {"dataType": TYPES[str(column.type.value_type)], "isArray": True, "arrayShape": "-1"}
    return field | {"dataType": TYPES[str(column.type)]}
