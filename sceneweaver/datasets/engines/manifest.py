"""The manifest of a data set: what it was made from, and with what. Runs that go on have to agree with it."""

from __future__ import annotations

import hashlib
import json
import platform
from dataclasses import dataclass, field
from functools import cached_property
from importlib.metadata import version
from itertools import chain
from pathlib import Path
from typing import Any

import sceneweaver
from sceneweaver.io import TEMPORARY, read_bytes, reason, write_atomic
from sceneweaver.scene import InputError

from ..folder import Folder
from ..requests import Requests
from ..spec import Spec, load_spec, spec_file

SCHEMA = "sceneweaver.dataset-manifest/1"
PROMPTS = "prompts.csv"
"""Where a data set keeps a file of prompts, so that it needs no other file to go on."""

MAX_INPUT = 2**30


@dataclass(frozen=True)
class Dataset:
    """A data set: where it lies and what it is made from.

    Attributes:
        folder: its paths.
        spec: its specification; the files that it names lie beside the manifest.
        device: the kind of device that lays out its rooms, "cpu" or "cuda", on which results depend.
        versions: of what makes it, by name.
        inputs: SHA-256 of the files that the specification names, by their name in the data set.
    """

    folder: Folder
    spec: Spec
    device: str
    versions: dict[str, str]
    inputs: dict[str, str] = field(default_factory=dict)

    @cached_property
    def requests(self) -> Requests:
        """What is asked for."""
        return Requests(self.spec, self.folder.path)

    def to_dict(self) -> dict[str, Any]:
        """The manifest as JSON."""
        return {
            "schema": SCHEMA,
            "name": self.spec.name,
            "hash": self.spec.hash,
            "spec": self.spec.model_dump(mode="json"),
            "inputs": self.inputs,
            "device": self.device,
            "versions": self.versions,
        }


def open_dataset(path: Path) -> Dataset:
    """The data set in a folder.

    Raises:
        InputError: there is none, or its manifest is damaged.
    """
    folder = Folder(path)
    if not folder.manifest.exists():
        raise InputError(f"{path}: no data set, as it has no {folder.manifest.name}; check the path")
    try:
        data = json.loads(read_bytes(folder.manifest, max_bytes=MAX_INPUT))
        spec = Spec.model_validate(data["spec"])
        return Dataset(folder, spec, str(data["device"]), dict(data["versions"]), dict(data["inputs"]))
    except (ValueError, TypeError, KeyError) as error:
        raise InputError(f"{folder.manifest}: damaged: {reason(error)}") from None


def begin(source: Path, out: Path, device: str = "auto") -> Dataset:
    """The data set of a specification in a folder: a new one, or the one that is there when it is the same.

    Args:
        source: a specification in YAML.
        out: a folder that is missing, empty, or holds this data set.
        device: where rooms are laid out; of a data set that is there, its kind has to agree.

    Raises:
        InputError: the specification is wrong, the folder holds something else, or it cannot be written.
    """
    spec, inputs = load_source(source)
    folder = Folder(out)
    if folder.manifest.exists():
        there = open_dataset(out)
        _require_same(there, spec, digests(inputs))
        agreed_device(there, device)
        return there
    return create(folder, spec, device, inputs, read_bytes(spec_file(source)))


def load_source(source: Path) -> tuple[Spec, dict[str, bytes]]:
    """The specification of a file, or of an example by name, as a data set keeps it, and the files that it names.

    Raises:
        InputError: one of them is wrong.
    """
    source = spec_file(source)
    spec = load_spec(source)
    Requests(spec, source.parent)  # an error names the file of the user
    inputs: dict[str, bytes] = {}
    changed: dict[str, Any] = {}
    if spec.requests.prompts_file is not None:
        inputs[PROMPTS] = read_bytes(source.parent / spec.requests.prompts_file, max_bytes=MAX_INPUT)
        changed = {"prompts_file": PROMPTS}
    if spec.requests.scenes is not None:
        names = tuple(f"inputs/{number:06d}.json" for number in range(len(spec.requests.scenes)))
        for name, path in zip(names, spec.requests.scenes, strict=True):
            inputs[name] = read_bytes(source.parent / path)
        changed = {"scenes": names}
    return spec.model_copy(update={"requests": spec.requests.model_copy(update=changed)}), inputs


def create(
    folder: Folder, spec: Spec, device: str, inputs: dict[str, bytes] | None = None, source: bytes | None = None
) -> Dataset:
    """Write the manifest of a new data set; it comes last of all that a run needs to go on."""
    inputs = inputs or {}
    files = inputs | ({} if source is None else {folder.spec.name: source})
    versions = {
        "sceneweaver": sceneweaver.__version__,
        "warp-lang": version("warp-lang"),
        "python": platform.python_version(),
    }
    kind = devices(device, spec)[0].partition(":")[0]
    dataset = Dataset(folder, spec, kind, versions, digests(inputs))
    try:
        _require_empty(folder.path, files)
        for name in ("", *files):
            (folder.path / name).parent.mkdir(parents=True, exist_ok=True)
        folder.path.mkdir(exist_ok=True)
    except OSError as error:
        raise InputError(f"--out: {folder.path} cannot be written ({reason(error)}); choose another place") from None
    for name, content in files.items():
        write_atomic(folder.path / name, content)
    write_atomic(folder.manifest, json.dumps(dataset.to_dict(), indent=1, ensure_ascii=False) + "\n")
    return dataset


def devices(name: str, spec: Spec) -> list[str]:
    """The devices that a name stands for, see `pick_devices`; the CPU without looking for a GPU.

    "auto" is the CPU for furnished scenes: the workers of a machine, one for each core, have many small searches, for
    which they would stand in line at a GPU (on one H200, sixteen of them made no block in a minute).
    """
    if name == "cpu" or (name == "auto" and spec.product == "scenes"):
        return ["cpu"]
    from sceneweaver.layout.devices import pick_devices

    return pick_devices(name)


def agreed_device(dataset: Dataset, device: str) -> str:
    """The devices that a data set goes on with: those of the name, if they are of the kind that it was begun on.

    Raises:
        InputError: it is of the other kind.
    """
    if device == "auto":
        return "cpu" if dataset.device == "cpu" else "cuda:all"
    kind = device.partition(":")[0]
    if kind != dataset.device:
        raise InputError(
            f"--device: {device}, but {dataset.folder.path} was begun on {dataset.device}, and results differ between "
            f"kinds of devices; go on with --device {dataset.device}, or choose another folder"
        )
    return device


def _require_empty(path: Path, files: dict[str, bytes]) -> None:
    """Refuse a folder with files that are not ours; what a run left that was killed at its very start is."""
    for place in path.rglob("*") if path.exists() else ():
        name = place.relative_to(path).as_posix()
        ours = name.startswith(TEMPORARY) or place.is_dir() or (name in files and place.read_bytes() == files[name])
        if not ours:
            raise InputError(f"--out: {path} is not empty and holds no data set; choose another folder")


def digests(inputs: dict[str, bytes]) -> dict[str, str]:
    """The SHA-256 of each file, by name."""
    return {name: hashlib.sha256(content).hexdigest() for name, content in inputs.items()}


def _require_same(there: Dataset, spec: Spec, inputs: dict[str, str]) -> None:
    old, new = (_flat(s.model_dump(mode="json")) for s in (there.spec, spec))
    for name in dict.fromkeys(chain(new, old)):
        if old.get(name) != new.get(name):
            raise InputError(
                f"spec: {name} is {_said(new.get(name))}, but {there.folder.path} was begun with "
                f"{_said(old.get(name))}; choose another folder for another data set"
            )
    for name, digest in inputs.items():
        if there.inputs.get(name) != digest:
            raise InputError(
                f"spec: requests.{'scenes' if spec.requests.scenes else 'prompts_file'} has other content than "
                f"{there.folder.path / name}, which the data set was begun with; choose another folder"
            )


def _flat(data: Any, name: str = "") -> dict[str, Any]:
    """The leaves of nested objects, by dotted name."""
    if not isinstance(data, dict):
        return {name: data}
    found: dict[str, Any] = {}
    for key, value in data.items():
        found |= _flat(value, f"{name}.{key}" if name else key)
    return found


def _said(value: Any) -> str:
    text = "not given" if value is None else json.dumps(value, ensure_ascii=False)
    return text if len(text) <= 60 else f"{text[:57]}..."
