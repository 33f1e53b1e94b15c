"""Card, licences and Croissant metadata (version 1.1) of a data set, and their way to Hugging Face's hub."""

from __future__ import annotations

import fnmatch
import json
import os
from collections import Counter
from collections.abc import Mapping
from itertools import islice
from pathlib import Path
from typing import Any, NamedTuple

import sceneweaver
from sceneweaver.io import dump_yaml, packaged
from sceneweaver.io.tars import members
from sceneweaver.runtime.package import missing_extra
from sceneweaver.scene import InputError, MissingDependencyError

from ..folder import Folder
from ..seals import kind_fault, open_own
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
"""Where the text of a licence stands; Hugging Face knows these by their name in lower case."""

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
    fixed = json.loads(packaged.text(__package__ or "", "croissant.json"))
    (records,) = fixed["recordSet"]
    fields = [_field(index["@id"], column) for column in columns]
    return fixed | {
        "name": spec.name,
        "description": f"Indoor {spec.product} of {numbers['rooms']} rooms, {made}.",
        "license": [TEXTS.get(name, name) for name in names],
        "citeAs": f"{spec.name}: {made}, specification {spec.hash}",
        "distribution": [index, *(_file(folder, path, KINDS[path.suffix], sums) for path in shards)],
        "recordSet": [records | {"key": {"@id": f"scenes/{key}"}, "field": fields}],
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


SIZES = ((10**3, "n<1K"), (10**4, "1K<n<10K"), (10**5, "10K<n<100K"), (10**6, "100K<n<1M"), (10**7, "1M<n<10M"))

SEEN = 1000
"""Files of the first shard that are looked at for suffixes."""


def card(folder: Folder, spec: Spec, numbers: dict[str, Any], used: list[Licence]) -> str:
    """The text of ``README.md``.

    Args:
        folder: the data set.
        spec: what it was made from.
        numbers: its statistics.
        used: licences of its assets.
    """
    front = dump_yaml(_front(folder, spec, numbers, used))
    found = suffixes(folder)
    fields: dict[str, Any] = {
        "spec": spec,
        "numbers": numbers,
        "product": "furnished scenes" if spec.product == "scenes" else spec.product,
        "there": lambda pattern: bool(fnmatch.filter(found, pattern)),
        "licences": list(dict.fromkeys(one.name for one in used)),
        "version": sceneweaver.__version__,
        "text": dump_yaml(spec.model_dump(mode="json", by_alias=True), sort_keys=False, allow_unicode=True).rstrip(),
    }
    texts = (render(f"files/{name}.md", **fields) for name in (f"card_{spec.product}", "card_end"))
    return f"---\n{front}---\n\n" + "\n".join(texts)


def _front(folder: Folder, spec: Spec, numbers: dict[str, Any], used: list[Licence]) -> dict[str, Any]:
    """The YAML at the head of the card."""
    names = list(dict.fromkeys(one.name for one in used))
    one = names[0] if len(names) == 1 and names[0] in TEXTS else None
    mixed = {"license": "other", "license_name": "mixed", "license_link": "LICENSES.md"}
    licence = {"license": one.lower()} if one else mixed
    suffix = "parquet" if spec.product == "layouts" else "tar"
    splits = [name for name in sorted(spec.splits) if any(folder.data.glob(f"{name}-*.{suffix}"))]
    data = [{"split": name, "path": f"data/{name}-*.{suffix}"} for name in splits]
    return {
        "pretty_name": spec.name,
        **licence,
        "language": ["en"],
        "task_categories": ["robotics", "text-to-3d", "visual-question-answering"],
        "tags": ["indoor scenes", "3d", "layout", "synthetic", "simulation", "sceneweaver"],
        "size_categories": [next((name for most, name in SIZES if _items(numbers) < most), "n>10M")],
        "configs": [{"config_name": "default", "data_files": data}] if data else [],
        **({"dataset_info": _info(folder, splits, numbers)} if spec.product != "layouts" else {}),
    }


def _items(numbers: dict[str, Any]) -> int:
    return numbers.get("layouts", numbers["scenes"])


def _info(folder: Folder, splits: list[str], numbers: dict[str, Any]) -> dict[str, Any]:
    """Types of the files of a scene, as its JSON files have no columns that hold for all, and sizes of the splits."""
    kinds = {suffix: "json" if suffix.endswith("json") else "binary" for suffix in sorted(suffixes(folder))}
    kinds |= {"__key__": "string", "__url__": "string"}
    sizes = {name: sum(path.stat().st_size for path in folder.data.glob(f"{name}-*.tar")) for name in splits}
    return {
        "features": [{"name": name, "dtype": kind} for name, kind in kinds.items()],
        "splits": [{"name": name, "num_bytes": sizes[name], "num_examples": numbers["split"][name]} for name in splits],
        "dataset_size": sum(sizes.values()),
    }


def suffixes(folder: Folder) -> set[str]:
    """The suffixes of the files of the first scenes."""
    for path in sorted(folder.data.glob("*.tar"))[:1]:
        with open_own(path) as file:
            return {member.name.partition(".")[2] for member in islice(members(file, str(path)), SEEN)}
    return set()


NAMES = ("README.md", "LICENSES.md", "croissant.json", "checksums.sha256", "dataset.json", "spec.yaml", "meta/*")
"""What is uploaded, as patterns: all but data and assets."""


def push_card(
    path: Path, repo: str, *, endpoint: str | None = None, token_env: str = "HF_TOKEN", dry_run: bool = False
) -> list[str]:
    """Upload what describes a data set: card, licences, Croissant metadata, checksums, specification and tables.

    Args:
        path: the data set.
        repo: where to, as ``owner/name``; it is made, private, where it is not there.
        endpoint: address of the server; None: the hub.
        token_env: name of the environment variable that holds the access token.
        dry_run: only list the files.

    Returns:
        The files, relative to the root.

    Raises:
        InputError: the data set is not packed, the variable is not set, or the server refuses.
        MissingDependencyError: huggingface_hub is not installed.
    """
    if not Folder(path).checksums.exists():
        raise InputError(f"{path}: not packed yet; finish it with: sceneweaver dataset resume {path}")
    files = sorted(
        {file.relative_to(path).as_posix() for name in NAMES for file in path.glob(name) if not kind_fault(file)}
    )
    if dry_run:
        return files
    token = os.environ.get(token_env)
    if not token:
        raise InputError(f"--token-env: {token_env} is not set; put an access token with write permission into it")
    try:
        from huggingface_hub import CommitOperationAdd, HfApi
    except ModuleNotFoundError:
        raise MissingDependencyError(missing_extra("hub", "push-card needs huggingface_hub")) from None
    api = HfApi(endpoint=endpoint, token=token)
    try:
        api.create_repo(repo, repo_type="dataset", private=True, exist_ok=True)
        added = [CommitOperationAdd(name, path / name) for name in files]
        api.create_commit(repo, added, commit_message="Card and tables", repo_type="dataset")
    except Exception as error:  # its own, and those of the library for connections, another one in each version
        text = " ".join(str(error).split()).replace(token, "***")
        raise InputError(f"--repo: {repo}: {text[:200]}") from None
    return files
