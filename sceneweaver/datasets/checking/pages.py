"""A verification as a page of Markdown."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from .findings import CHECKS

_MEANING = {
    "checksum": "shards, tables and assets have the SHA-256 that is listed",
    "index": "rows are complete, in order, and have reasons where nothing was delivered",
    "shard": "every delivered scene lies in its shard once, and nothing else does",
    "content": "the files of each scene have the hash and size of its row",
    "split": "no room, content or group of near-duplicates is in two splits",
    "licence": "the licence of every asset is known, and named by the scenes that have it",
    "asset": "every file that a GLB or MJCF names is in the store",
    "judge": "the judge finds every scene valid: nothing collides, leaves the room, floats or breaks a relation",
    "record": "what index and metrics.json record is what is measured",
    "gate": "every delivered scene passes the gates of the specification",
    "export": "objects stand in GLB and MJCF where scene.json has them",
    "compile": "MuJoCo compiles the sample of MJCF files",
    "stability": "nothing diverges, or moves farther than a gate allows",
}


def markdown(data: Mapping[str, Any]) -> str:
    """The page."""
    counts, faults = data["counts"], data["faults"]
    verdict = "All holds." if data["ok"] else "Not all holds."
    lines = [
        f"# Verification of {data['name']}",
        "",
        f"{verdict} Everything below was measured from the files alone, with sceneweaver {data['version']}.",
        "",
        "| measured | |",
        "| --- | ---: |",
        *(f"| {name} | {value:,} |" for name, value in counts.items()),
        "",
        "| check | faults | what holds |",
        "| --- | ---: | --- |",
        *(f"| {check} | {faults.get(check, 0)} | {_MEANING[check]} |" for check in CHECKS),
    ]
    if (moved := data["stability"]) is not None:
        lines += [
            "",
            f"{moved['scenes']} scenes were let loose in MuJoCo for 3 s. Of {moved['things']:,} things that may move "
            f"{100 * moved['moved_over_0_01m']:.2f} % moved over 1 cm and {100 * moved['moved_over_0_1m']:.2f} % "
            f"over 10 cm; the mean shift is {1e3 * moved['mean_shift_m']:.2f} mm.",
        ]
        if moved["farthest"]:
            lines += ["", "| scene | thing | shift [m] |", "| --- | --- | ---: |"]
            lines += [f"| {row['key']} | {row['object']} | {row['shift_m']:.3f} |" for row in moved["farthest"]]
    if data["first"]:
        lines += ["", "## First faults", "", "| key | check | what |", "| --- | --- | --- |"]
        lines += [f"| {f['key']} | {f['check']} | {_cell(f['detail'])} |" for f in data["first"]]
    return "\n".join(lines) + "\n"


def _cell(text: str) -> str:
    """A text as a cell of a table."""
    return text.replace("|", "/")
