"""The frozen problems: a manifest, a compressed file for each family, what was measured, and whether all is so."""

from __future__ import annotations

import gzip
import hashlib
import json
from collections.abc import Iterable, Mapping
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.io import load_json, load_packed_json, write_atomic
from sceneweaver.scene import InputError
from sceneweaver.verify import check

from . import layout_bench
from .case import ProblemCase, canonical, from_plain, plain
from .certificates import prove
from .recipes import families

Json = dict[str, Any]

SCHEMA = "sceneweaver.problems/1"
DATA = Path(__file__).parent / "data"
ROUNDING = 1e-4  # [m] of energies


@cache
def manifest() -> Mapping[str, Json]:
    """For each name: family, version, hash, objects, relations, feasible, facts; by family, then size, then name."""
    data = load_json(DATA / "manifest.json")
    if data["schema"] != SCHEMA:
        raise InputError(f"problems: the manifest is of {data['schema']}, not {SCHEMA}")
    return data["problems"]


def names(family: str | None = None, feasible: bool | None = None) -> tuple[str, ...]:
    """Names of the frozen problems, by family, then size.

    Args:
        family: only those of a family.
        feasible: only those with a valid layout, or only those without.

    Raises:
        InputError: an unknown family.

    Examples:
        >>> from sceneweaver import problems
        >>> len(problems.names()) >= 60
        True
    """
    if family is not None and family not in families():
        raise InputError(f"family: {family!r} is none of {', '.join(families())}")
    return tuple(
        name
        for name, row in manifest().items()
        if family in (None, row["family"]) and feasible in (None, row["feasible"])
    )


@cache
def measured() -> Mapping[str, Json]:
    """For each name that was measured: hash, best energy [m], its layout where it is not the witness, difficulty."""
    path = DATA / "measured.json"
    return load_json(path)["problems"] if path.exists() else {}


@cache
def _family(name: str) -> Mapping[str, Json]:
    return {entry["name"]: entry for entry in load_packed_json(DATA / f"{name}.json.gz")}


@cache
def load(name: str) -> ProblemCase:
    """A frozen problem; read once.

    Raises:
        InputError: there is none of this name, or its data have another hash than the manifest.

    Examples:
        >>> from sceneweaver import problems
        >>> case = problems.load(problems.names("packing")[0])
        >>> case.compile("cpu").feasible(case.witness[None]).tolist()
        [True]
    """
    import difflib

    row = manifest().get(name)
    if row is None:
        near = difflib.get_close_matches(str(name), manifest(), 1)
        raise InputError(f"no problem {name!r}; " + (f"did you mean {near[0]}?" if near else "see problems.names()"))
    known = measured().get(name, {})
    known = known if known.get("hash") == row["hash"] else {}
    case = from_plain(
        _family(row["family"])[name],
        row["facts"],
        best_energy=known.get("best_energy"),
        best=np.array(known["best"], dtype=np.float32) if "best" in known else None,
        difficulty=known.get("difficulty", {}),
    )
    if case.hash != row["hash"]:
        raise InputError(f"problem {name}: its data have hash {case.hash[:12]}, the manifest says {row['hash'][:12]}")
    return layout_bench.with_reference(case)


def freeze(cases: Iterable[ProblemCase], folder: Path = DATA) -> None:
    """Write a zoo: the data of each family and the manifest. Measurements are left alone.

    Raises:
        InputError: two problems have one name.
    """
    rows = sorted(cases, key=lambda c: (c.family, len(c.scene.objects), c.name))
    if len({c.name for c in rows}) != len(rows):
        raise InputError("problems: two have one name")
    folder.mkdir(parents=True, exist_ok=True)
    for family in {c.family for c in rows}:
        text = json.dumps([plain(c) for c in rows if c.family == family], separators=(",", ":"), ensure_ascii=False)
        write_atomic(folder / f"{family}.json.gz", gzip.compress(text.encode(), 9, mtime=0))
    problems = {c.name: _row(c) for c in rows}
    text = json.dumps({"schema": SCHEMA, "problems": problems}, indent=1, ensure_ascii=False)
    write_atomic(folder / "manifest.json", text + "\n")
    _forget()


def record(results: Mapping[str, Json], folder: Path = DATA) -> None:
    """Write what was measured, as `measured` gives it."""
    rows = {name: results[name] for name in manifest() if name in results}
    lines = ",\n".join(f" {json.dumps(name)}: {json.dumps(row, separators=(',', ':'))}" for name, row in rows.items())
    text = f'{{"schema": {json.dumps(SCHEMA)}, "problems": {{\n{lines}\n}}}}'
    write_atomic(folder / "measured.json", text + "\n")
    _forget()


def _forget() -> None:
    """Read everything anew the next time."""
    for kept in (manifest, measured, _family, load):
        kept.cache_clear()


def _row(case: ProblemCase) -> Json:
    return {
        "family": case.family,
        "version": case.version,
        "hash": case.hash,
        "objects": len(case.scene.objects),
        "relations": len(case.scene.relations),
        "feasible": case.feasible,
        "facts": dict(case.facts),
    }


def verify(case: ProblemCase) -> None:
    """Check a problem: its hash, its witness by the judge and by the engine, or its certificate.

    Raises:
        InputError: with what is wrong, in one line.

    Examples:
        >>> from sceneweaver import problems
        >>> problems.verify(problems.load("infeasible/area-n010"))
    """
    found = hashlib.sha256(canonical(case)).hexdigest()
    row = manifest().get(case.name)
    if found != case.hash or (row is not None and row["hash"] != case.hash):
        raise InputError(f"problem {case.name}: its hash is {found[:12]}, not what it is said to be")
    if (case.witness is None) == (case.certificate is None):
        raise InputError(f"problem {case.name}: it needs either a witness or a certificate")
    if case.certificate is not None:
        prove(case.scene, case.certificate)
        return
    assert case.witness is not None
    report = check(case.layout(case.witness), walkable=False)
    if not report.valid:
        first = report.violations[0]
        raise InputError(f"problem {case.name}: the judge finds the witness not valid ({first.kind}: {first.detail})")
    if check(case.scene, walkable=False).valid:
        raise InputError(f"problem {case.name}: its scene is valid already; it is to be a bad start")
    problem = case.compile("cpu")
    poses = np.array(case.witness)[None]
    if not problem.feasible(poses)[0]:
        raise InputError(f"problem {case.name}: the engine finds the witness not feasible")
    _verify_reference(case)
    if case.best_energy is None:
        return
    if case.best_energy > float(problem.energy(poses)[0]) + ROUNDING:
        raise InputError(f"problem {case.name}: the witness has less than the best known energy")
    if case.best is not None:
        energy = float(problem.energy(case.best[None])[0])
        if abs(energy - case.best_energy) > ROUNDING or not check(case.layout(case.best), walkable=False).valid:
            raise InputError(f"problem {case.name}: its best layout is not valid, or has {energy:.6f} m")


def _verify_reference(case: ProblemCase) -> None:
    """The layout of the best objective that is known is valid and has it."""
    if case.best_objective is None:
        return
    layout = case.witness if case.best_layout is None else case.best_layout
    assert layout is not None
    valid, value = case.judge(layout)
    if not valid:
        raise InputError(f"problem {case.name}: the layout of its best objective is not valid")
    if value is None or (
        case.best_layout is not None and abs(value - case.best_objective) > ROUNDING * max(value, 1.0)
    ):
        raise InputError(f"problem {case.name}: the layout of its best objective has {value}")
