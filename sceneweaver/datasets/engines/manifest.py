"""The manifest of a data set: what it was made from, and with what. Runs that go on have to agree with it."""

from __future__ import annotations

import hashlib
import json
import os
import platform
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from importlib.metadata import version
from itertools import chain
from pathlib import Path
from typing import Any

import sceneweaver
from sceneweaver.io import TEMPORARY, locked, read_bytes, reason, write_atomic
from sceneweaver.scene import InputError

from ..folder import Folder
from ..requests import Requests
from ..seals import (
    DamagedError,
    Entry,
    entry_of,
    entry_of_bytes,
    fault_of,
    kind_fault,
    read_seal,
    remove,
    seal_text,
    sha256,
    write_seal,
)
from ..spec import Spec, load_spec, spec_file

SCHEMA = "sceneweaver.dataset-manifest/1"
PROMPTS = "prompts.csv"
"""Where a data set keeps a file of prompts, so that it needs no other file to go on."""

MAX_INPUT = 2**30

KINDS = ("cpu", "cuda")
VERSIONS = ("sceneweaver", "warp-lang", "python")
FIELDS = {"schema", "name", "hash", "spec", "inputs", "device", "versions"}


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

    @property
    def text(self) -> str:
        """The manifest as it is written."""
        return json.dumps(self.to_dict(), indent=1, ensure_ascii=False) + "\n"

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
    if not os.path.lexists(folder.manifest):
        fix = "check the path" if begun_with(folder) is None else _restore(folder)
        raise InputError(f"{path}: no data set, as it has no {folder.manifest.name}; {fix}")
    try:
        content = read_bytes(folder.manifest, max_bytes=MAX_INPUT)
        dataset = read_manifest(folder, content)
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError) as error:
        raise InputError(f"{folder.manifest}: damaged: {reason(error)}; {_restore(folder)}") from None
    begun = begun_with(folder)
    if begun is not None and begun.get(folder.manifest.name) != entry_of_bytes(content):
        raise InputError(f"{folder.manifest}: is not what the data set was begun with; {_restore(folder)}")
    return dataset


def read_manifest(folder: Folder, content: bytes) -> Dataset:
    """The data set of a manifest.

    Raises:
        ValueError, TypeError, KeyError: it is none, or its fields do not agree with each other.
    """
    data = json.loads(content)
    if data["schema"] != SCHEMA:
        raise ValueError(f"schema is {data['schema']!r}; {SCHEMA} is read")
    text = json.dumps(data["spec"], sort_keys=True, ensure_ascii=False)
    if data["hash"] != hashlib.sha256(text.encode()).hexdigest():
        raise ValueError("hash is not that of its spec")
    spec = Spec.model_validate(data["spec"])
    if data["name"] != spec.name:
        raise ValueError(f"name is {data['name']!r}; its spec says {spec.name!r}")
    if data["device"] not in KINDS:
        raise ValueError(f"device is {data['device']!r}, not one of {', '.join(KINDS)}")
    for name in ("versions", "inputs"):
        if not all(isinstance(value, str) for value in data[name].values()):
            raise ValueError(f"{name} has values that are no texts")
    if set(data["versions"]) != set(VERSIONS) or set(data) != FIELDS:
        raise ValueError("fields are missing, or there are more")
    for name in data["inputs"]:
        if not (name in (PROMPTS, folder.spec.name) or re.fullmatch(r"inputs/\d+\.json", name)):
            raise ValueError(f"inputs names {name!r}, which is no input")
    return Dataset(folder, spec, data["device"], dict(data["versions"]), dict(data["inputs"]))


def begun_with(folder: Folder) -> dict[str, Entry] | None:
    """The seal of what a data set was begun with; None where there is none, or a damaged one."""
    try:
        return read_seal(folder.begun)
    except DamagedError:
        return None


def require_inputs(dataset: Dataset, notice: Callable[[str], None]) -> None:
    """See that specification and inputs are what the data set was begun with; a seal that is gone is written anew.

    Raises:
        InputError: one of them is not, with the way to bring it back.
    """
    folder, begun = dataset.folder, begun_with(dataset.folder)
    for name, fault in input_faults(dataset, begun):
        raise InputError(f"{folder.path / name}: {fault}; {_restore(folder)}")
    if begun is None:
        fault = "is damaged" if os.path.lexists(folder.begun) else "is missing"
        notice(f"{folder.begun.relative_to(folder.path)}: {fault}; it is written again")
        remove(folder.begun)
        names = [folder.manifest.name, *dataset.inputs, folder.spec.name]
        folder.work.mkdir(exist_ok=True)
        there = [name for name in names if not kind_fault(folder.path / name)]
        if not kind_fault(folder.joined):
            there.append(folder.joined.relative_to(folder.path).as_posix())
        write_seal(folder.begun, {name: entry_of(folder.path / name) for name in there})


def input_faults(dataset: Dataset, begun: Mapping[str, Entry] | None) -> Iterator[tuple[str, str]]:
    """What a data set was begun with and what is not that any more: names with what is wrong with each."""
    folder = dataset.folder
    for name, digest in dataset.inputs.items():
        path = folder.path / name
        if fault := kind_fault(path):
            yield name, fault
        elif sha256(path) != digest:
            yield name, "has other content"
    for name, entry in (begun or {}).items():
        if name not in dataset.inputs and (fault := fault_of(folder.path / name, entry)):
            yield name, fault


def _restore(folder: Folder) -> str:
    if os.path.lexists(folder.joined):
        return f"bring it back with: sceneweaver dataset merge, as before, --out {folder.path}"
    return f"bring it back with: sceneweaver dataset make SPEC --out {folder.path}"


def begin(source: Path, out: Path, device: str = "auto") -> Dataset:
    """The data set of a specification in a folder: a new one, or the one that is there when it is the same.

    Of one that is there, what it was begun with is brought back where it is missing or damaged.

    Args:
        source: a specification in YAML.
        out: a folder that is missing, empty, or holds this data set.
        device: where rooms are laid out; of a data set that is there, its kind has to agree.

    Raises:
        InputError: the specification is wrong, the folder holds something else or is being written to, or it cannot
            be written.
    """
    spec, inputs = load_source(source)
    given = read_bytes(spec_file(source))
    folder = Folder(out)
    restore(folder, spec, inputs, given)
    if not os.path.lexists(folder.manifest):
        return create(folder, spec, device, inputs, given)
    dataset = open_dataset(out)
    _require_same(dataset, spec, digests(inputs))
    agreed_device(dataset, device)
    return dataset


def restore(folder: Folder, spec: Spec, inputs: dict[str, bytes], given: bytes | None) -> None:
    """Write again what a data set was begun with and what is missing or damaged, where it is the same specification."""
    begun = begun_with(folder)
    if begun is None:
        return
    name = folder.manifest.name
    manifests = [_made(folder, spec, kind, inputs).text.encode() for kind in KINDS]
    as_made = any(not fault_of(folder.manifest, entry_of_bytes(text)) for text in manifests)
    if as_made and fault_of(folder.manifest, begun.get(name, Entry("", 0))):  # the seal is that of another data set
        remove(folder.begun)
        return
    files = [*inputs.items(), *((name, text) for text in manifests)]
    files += [] if given is None else [(folder.spec.name, given)]
    for name, content in files:
        path, entry = folder.path / name, entry_of_bytes(content)
        if begun.get(name) == entry and fault_of(path, entry):
            remove(path)
            path.parent.mkdir(parents=True, exist_ok=True)
            write_atomic(path, content, within=folder.path)


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
    folder: Folder,
    spec: Spec,
    device: str,
    inputs: dict[str, bytes] | None = None,
    source: bytes | None = None,
    more: dict[str, bytes] | None = None,
) -> Dataset:
    """Write the manifest of a new data set; it comes last of all that a run needs to go on.

    Another process that is as quick makes the same one, or the one that comes second is told so.
    """
    dataset = _made(folder, spec, devices(device, spec)[0].partition(":")[0], inputs or {})
    files = {**(inputs or {}), **({} if source is None else {folder.spec.name: source}), **(more or {})}
    text = dataset.text.encode()
    entries = {name: entry_of_bytes(content) for name, content in (files | {folder.manifest.name: text}).items()}
    seal = folder.begun.relative_to(folder.path).as_posix()
    files[seal] = seal_text(folder.begun, entries).encode()
    try:
        folder.path.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(f"--out: {folder.path} cannot be written ({reason(error)}); choose another place") from None
    with locked(folder.manifest, f"--out: {folder.path}"):
        if os.path.lexists(folder.manifest):  # another process was quicker
            there = open_dataset(folder.path)
            _require_same(there, spec, digests(inputs or {}))
            return there
        _require_empty(folder.path, files)
        for name, content in files.items():
            (folder.path / name).parent.mkdir(parents=True, exist_ok=True)
            write_atomic(folder.path / name, content, within=folder.path)
        write_atomic(folder.manifest, text)
    return dataset


def _made(folder: Folder, spec: Spec, kind: str, inputs: dict[str, bytes]) -> Dataset:
    """The data set that is begun now with a specification on a kind of device."""
    values = (sceneweaver.__version__, version("warp-lang"), platform.python_version())
    return Dataset(folder, spec, kind, dict(zip(VERSIONS, values, strict=True)), digests(inputs))


def devices(name: str, spec: Spec) -> list[str]:
    """The devices that a name stands for, see `pick_devices`; the CPU without looking for a GPU.

    "auto" is the CPU for furnished scenes and homes: the workers of a machine, one for each core, have many small
    searches, for which they would stand in line at a GPU (on one H200, sixteen of them made no block in a minute).
    """
    if name == "cpu" or (name == "auto" and spec.product != "layouts"):
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
        passing = any(part.startswith(TEMPORARY) for part in place.relative_to(path).parts)
        ours = name in files and not fault_of(place, entry_of_bytes(files[name]))
        if not (passing or ours or (place.is_dir() and not place.is_symlink())):
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
