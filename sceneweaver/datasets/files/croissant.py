"""Croissant metadata (version 1.1): files with checksums, and the index as a set of records."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import sceneweaver

from ..folder import Folder
from ..spec import Spec
from .licences import TEXTS, Licence
from .tables import read_schema, table_of

CONTEXT = {
    "@language": "en",
    "@vocab": "https://schema.org/",
    "citeAs": "cr:citeAs",
    "column": "cr:column",
    "conformsTo": "dct:conformsTo",
    "cr": "http://mlcommons.org/croissant/",
    "rai": "http://mlcommons.org/croissant/RAI/",
    "data": {"@id": "cr:data", "@type": "@json"},
    "dataType": {"@id": "cr:dataType", "@type": "@vocab"},
    "dct": "http://purl.org/dc/terms/",
    "equivalentProperty": "cr:equivalentProperty",
    "examples": {"@id": "cr:examples", "@type": "@json"},
    "extract": "cr:extract",
    "field": "cr:field",
    "fileProperty": "cr:fileProperty",
    "fileObject": "cr:fileObject",
    "fileSet": "cr:fileSet",
    "format": "cr:format",
    "includes": "cr:includes",
    "isArray": "cr:isArray",
    "arrayShape": "cr:arrayShape",
    "isLiveDataset": "cr:isLiveDataset",
    "jsonPath": "cr:jsonPath",
    "key": "cr:key",
    "md5": "cr:md5",
    "parentField": "cr:parentField",
    "path": "cr:path",
    "recordSet": "cr:recordSet",
    "references": "cr:references",
    "regex": "cr:regex",
    "repeated": "cr:repeated",
    "replace": "cr:replace",
    "samplingRate": "cr:samplingRate",
    "sc": "https://schema.org/",
    "separator": "cr:separator",
    "source": "cr:source",
    "subField": "cr:subField",
    "transform": "cr:transform",
}

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
    table = table_of(folder, spec)
    index = _file(folder, table, "application/x-parquet", sums)
    columns = [column for column in read_schema(table) if not is_struct(column.type)]
    key, made = columns[0].name, f"made with sceneweaver {sceneweaver.__version__}"
    shards = sorted(path for path in folder.data.iterdir() if path.suffix in KINDS) if folder.data.exists() else []
    return {
        "@context": CONTEXT,
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
