"""Layout Bench: a fixed choice of problems in tiers, a part of which nobody sees, with one version and one hash.

Every split has one problem of each row of ``layout_bench.yaml``. The seeds are SHA-256 of the split's secret and the
name: that of "dev" and "tuning" stands here, and that of "test" in a file that is not published. Its hash is.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.io import load_json, load_packed_json, packaged, read_text, write_atomic
from sceneweaver.scene import InputError

from .case import ProblemCase, canonical
from .generator import generate
from .infeasible import generate_infeasible

Json = dict[str, Any]

SCHEMA = "sceneweaver.layout_bench/1"
RECIPE: Json = packaged.yaml_data(__package__ or "", "layout_bench.yaml")
VERSION: str = RECIPE["version"]
DATA = Path(__file__).parent / "data"
MANIFEST, LAYOUTS = "layout_bench.json", "layout_bench_layouts.json"
SPLITS = ("dev", "test", "tuning")
PUBLISHED = {"dev": "Layout Bench 1.0, dev", "tuning": "Layout Bench 1.0, tuning"}
TIERS = ("solved", "hard", "open", "infeasible")
ATTEMPTS = 20  # seeds that are tried for a problem
LEAST_SECRET = 16  # characters


def secret_of(split: str, seed_file: Path | str | None = None) -> str:
    """What the seeds of a split are made of.

    Raises:
        InputError: no such split; that of "test" without a file, or with one that has no secret.
    """
    if split not in SPLITS:
        raise InputError(f"split: {split!r} is none of {', '.join(SPLITS)}")
    if split in PUBLISHED:
        return PUBLISHED[split]
    if seed_file is None:
        raise InputError("seed-file: the problems of test are made from a secret; give the file that has it")
    secret = read_text(Path(seed_file)).strip()
    if len(secret) < LEAST_SECRET:
        raise InputError(f"seed-file: {seed_file} has {len(secret)} characters; a secret has at least {LEAST_SECRET}")
    return secret


def rows_of(split: str) -> Iterator[tuple[str, str, list[Any]]]:
    """Name, family and arguments of each problem of a split."""
    for family, rows in RECIPE["tuning" if split == "tuning" else "problems"].items():
        for row in rows:
            if family == "infeasible":
                title = f"{row[1].replace('_', '-')}-n{row[0]:03d}"
            else:
                title = f"n{row[0]:03d}-t{round(100 * row[1]):02d}"
                title += "".join(f"-{x}" if isinstance(x, str) else f"-d{x:g}" for x in row[2:])
            yield f"{family}/{title}-{split}", family, row


def seed_of(secret: str, name: str, attempt: int = 0) -> int:
    """The seed of a problem, from 0 to 2**32 - 1; further attempts have others."""
    text = f"{secret}\n{name}" + (f"\n{attempt}" if attempt else "")
    return int.from_bytes(hashlib.sha256(text.encode()).digest()[:4])


def _made(secret: str, name: str, family: str, row: list[Any]) -> ProblemCase:
    """The problem of a row, from the first seed that the generator finds one with."""
    more: Json = {("shape" if isinstance(x, str) else "density"): x for x in row[2:]}
    for attempt in range(ATTEMPTS):
        seed = seed_of(secret, name, attempt)
        try:
            if family == "infeasible":
                return generate_infeasible(row[1], row[0], seed, name=name)
            return generate(family, row[0], row[1], seed, name=name, **more)
        except InputError:
            if attempt + 1 == ATTEMPTS:
                raise
    raise AssertionError


def make(split: str, seed_file: Path | str | None = None, family: str | None = None) -> list[ProblemCase]:
    """Make the problems of a split anew, with the best objectives that are known, in the order of their names.

    Args:
        split: "dev", "test" or "tuning".
        seed_file: the secret of "test".
        family: only those of a family.

    Raises:
        InputError: no such split or family; no secret.

    Examples:
        >>> from sceneweaver.problems import layout_bench
        >>> [case.name for case in layout_bench.make("tuning", family="relations")]
        ['relations/n018-t40-d3-tuning']
    """
    secret, found = secret_of(split, seed_file), []
    for name, kind, row in rows_of(split):
        if family not in (None, kind):
            continue
        found.append(with_reference(_made(secret, name, kind, row)))
    if not found:
        raise InputError(f"family: {family!r} is none of those of Layout Bench")
    return sorted(found, key=lambda case: case.name)


@cache
def manifest() -> Mapping[str, Any]:
    """Version, hash, and for each split what is published of it: see `describe`. Empty before it was frozen."""
    path = DATA / MANIFEST
    if not path.exists():
        return {}
    data = load_json(path)
    if data.get("schema") != SCHEMA:
        raise InputError(f"layout bench: the manifest is of {data.get('schema')}, not {SCHEMA}")
    return data


@cache
def _layouts() -> Mapping[str, Any]:
    path = DATA / f"{LAYOUTS}.gz"
    return load_packed_json(path) if path.exists() else {}


def rows(split: str) -> Mapping[str, Json]:
    """For each published name of a split: tier, best objective where there is one, and the hash unless held back."""
    return manifest().get(split, {}).get("problems", {})


def names(tier: str | None = None) -> tuple[str, ...]:
    """Names of the published problems ("dev"), of one tier or of all.

    Raises:
        InputError: no such tier.

    Examples:
        >>> from sceneweaver.problems import layout_bench
        >>> len(layout_bench.names("hard")) + len(layout_bench.names("open")) >= 60
        True
    """
    if tier is not None and tier not in TIERS:
        raise InputError(f"tier: {tier!r} is none of {', '.join(TIERS)}")
    return tuple(name for name, row in rows("dev").items() if tier in (None, row["tier"]))


def tier_of(name: str) -> str:
    """The tier of a problem of "dev" or "test"; empty for others."""
    return next((rows(split)[name]["tier"] for split in ("dev", "test") if name in rows(split)), "")


def with_reference(case: ProblemCase) -> ProblemCase:
    """The problem with the best objective that is known: as published, else that of its witness."""
    if not case.objective or case.witness is None:
        return case
    row = next((rows(split)[case.name] for split in SPLITS if case.name in rows(split)), {})
    if "best_objective" not in row:
        return replace(case, best_objective=float(case.objective_of(case.witness[None])[0]))
    layout = _layouts().get(case.name)
    known = None if layout is None else np.array(layout, dtype=np.float32).reshape(-1, 4)
    return replace(case, best_objective=row["best_objective"], best_layout=known)


def split_hash(cases: list[ProblemCase]) -> str:
    """SHA-256 of the canonical bytes of a split's problems, by name, each with a line feed after it."""
    whole = hashlib.sha256()
    for case in sorted(cases, key=lambda c: c.name):
        whole.update(canonical(case) + b"\n")
    return whole.hexdigest()


def describe(splits: Mapping[str, list[ProblemCase]], tiers: Mapping[str, str]) -> Json:
    """What is published: for each split its problems (the hashes of those of "test" are left out) and its hash.

    ``tiers`` gives the tier of each name; what is not there is "open", or "infeasible" by its certificate.
    """
    found: Json = {"schema": SCHEMA, "version": VERSION}
    for split, cases in splits.items():
        problems: Json = {}
        for case in sorted(cases, key=lambda c: c.name):
            row: Json = {} if split == "test" else {"hash": case.hash}
            if split != "tuning":
                row["tier"] = tiers.get(case.name, "open") if case.feasible else "infeasible"
            if case.best_objective is not None:
                row["best_objective"] = round(case.best_objective, 4)
            problems[case.name] = row
        found[split] = {"hash": split_hash(cases), "problems": problems}
    return {**found, "hash": whole_hash(found)}


def whole_hash(data: Mapping[str, Any]) -> str:
    """SHA-256 of all that is published but the hash itself, as JSON with sorted keys and without spaces."""
    plain = {key: value for key, value in data.items() if key != "hash"}
    return hashlib.sha256(json.dumps(plain, sort_keys=True, separators=(",", ":")).encode()).hexdigest()


def freeze(splits: Mapping[str, list[ProblemCase]], tiers: Mapping[str, str], folder: Path = DATA) -> None:
    """Write the manifest, and the layouts of the best objectives of "dev"."""
    import gzip

    data = describe(splits, tiers)
    layouts = {
        case.name: [[float(str(v)) for v in row] for row in case.best_layout.astype(np.float32)]
        for case in sorted(splits.get("dev", []), key=lambda c: c.name)
        if case.best_layout is not None
    }
    text = json.dumps(layouts, separators=(",", ":"))
    write_atomic(folder / f"{LAYOUTS}.gz", gzip.compress(text.encode(), 9, mtime=0))
    write_atomic(folder / MANIFEST, json.dumps(data, indent=1, sort_keys=True) + "\n")
    manifest.cache_clear()
    _layouts.cache_clear()


def verify_split(split: str, seed_file: Path | str | None = None) -> list[ProblemCase]:
    """Make a split anew and compare it with what is published of it.

    Returns:
        Its problems.

    Raises:
        InputError: they have another hash, or the manifest another than it says.

    Examples:
        >>> from sceneweaver.problems import layout_bench
        >>> len(layout_bench.verify_split("tuning"))
        8
    """
    data = manifest()
    if whole_hash(data) != data.get("hash"):
        raise InputError("layout bench: the manifest has another hash than it says")
    cases = make(split, seed_file)
    found, published = split_hash(cases), data[split]["hash"]
    if found != published:
        raise InputError(f"layout bench: the problems of {split} have hash {found[:12]}, published is {published[:12]}")
    return cases
