"""The data card: what is in a data set, how it was made, how to load it; and its way to Hugging Face's hub."""

from __future__ import annotations

import fnmatch
import os
import tarfile
from itertools import islice
from pathlib import Path
from typing import Any

import yaml

import sceneweaver
from sceneweaver.scene import InputError, MissingDependencyError

from ..folder import Folder
from ..spec import Spec
from ..templates import render
from .croissant import Licence

SIZES = ((10**3, "n<1K"), (10**4, "1K<n<10K"), (10**5, "10K<n<100K"), (10**6, "100K<n<1M"), (10**7, "1M<n<10M"))

SEEN = 1000
"""Files of the first shard that are looked at for suffixes."""

HUB_LICENCES = {"Apache-2.0", "BSD-3-Clause", "CC-BY-4.0", "CC-BY-NC-4.0", "CC0-1.0", "MIT"}
"""Licences that Hugging Face knows by their name in lower case."""

FILES = {
    "scene.json": "the scene: room, objects, poses, relations (`sceneweaver.scene/1`)",
    "metrics.json": "what the judge and the critic measured",
    "glb": "glTF 2.0, whose buffers and pictures lie in `assets/`",
    "xml": "MJCF for MuJoCo, whose meshes and textures lie in `assets/`",
    "usdc": "USD, whose meshes and textures lie in `assets/`",
    "*.png": "pictures and data passes",
    "captions.json": "descriptions, each statement with what makes it true",
    "questions.jsonl": "questions with answers by geometry",
    "instructions.jsonl": "instructions for rearrangement with their goals",
    "twin-*.scene.json": "a changed twin of the scene",
    "twin-*.difference.json": "what the twin differs in, and the measured effect",
}


def card(folder: Folder, spec: Spec, numbers: dict[str, Any], used: list[Licence]) -> str:
    """The text of ``README.md``.

    Args:
        folder: the data set.
        spec: what it was made from.
        numbers: its statistics.
        used: licences of its assets.
    """
    front = yaml.safe_dump(_front(folder, spec, numbers, used), sort_keys=False, allow_unicode=True)
    found = suffixes(folder)
    fields: dict[str, Any] = {
        "spec": spec,
        "numbers": numbers,
        "product": "furnished scenes" if spec.product == "scenes" else "layouts",
        "files": [(name, what) for name, what in FILES.items() if fnmatch.filter(found, name)],
        "licences": list(dict.fromkeys(one.name for one in used)),
        "version": sceneweaver.__version__,
        "text": yaml.safe_dump(
            spec.model_dump(mode="json", by_alias=True), sort_keys=False, allow_unicode=True
        ).rstrip(),
    }
    texts = (render(f"files/{name}.md", **fields) for name in (f"card_{spec.product}", "card_end"))
    return f"---\n{front}---\n\n" + "\n".join(texts)


def _front(folder: Folder, spec: Spec, numbers: dict[str, Any], used: list[Licence]) -> dict[str, Any]:
    """The YAML at the head of the card."""
    names = list(dict.fromkeys(one.name for one in used))
    one = names[0] if len(names) == 1 and names[0] in HUB_LICENCES else None
    mixed = {"license": "other", "license_name": "mixed", "license_link": "LICENSES.md"}
    licence = {"license": one.lower()} if one else mixed
    suffix = "tar" if spec.product == "scenes" else "parquet"
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
        **({"dataset_info": _info(folder, splits, numbers)} if spec.product == "scenes" else {}),
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
        with tarfile.open(path, "r:") as tar:
            return {member.name.partition(".")[2] for member in islice(tar, SEEN)}
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
    files = sorted({file.relative_to(path).as_posix() for name in NAMES for file in path.glob(name) if file.is_file()})
    if dry_run:
        return files
    token = os.environ.get(token_env)
    if not token:
        raise InputError(f"--token-env: {token_env} is not set; put an access token with write permission into it")
    try:
        from huggingface_hub import CommitOperationAdd, HfApi
        from huggingface_hub.errors import HfHubHTTPError, HFValidationError
    except ModuleNotFoundError:
        raise MissingDependencyError(
            "push-card needs huggingface_hub; install it with: pip install sceneweaver[hub]"
        ) from None
    api = HfApi(endpoint=endpoint, token=token)
    try:
        api.create_repo(repo, repo_type="dataset", private=True, exist_ok=True)
        added = [CommitOperationAdd(name, path / name) for name in files]
        api.create_commit(repo, added, commit_message="Card and tables", repo_type="dataset")
    except (HFValidationError, HfHubHTTPError, OSError) as error:
        text = " ".join(str(error).split()).replace(token, "***")
        raise InputError(f"--repo: {repo}: {text[:200]}") from None
    return files
