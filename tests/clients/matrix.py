"""Exported rooms and homes in clients: ``python -m tests.clients.matrix FILE.JSON... [--clients a,b] [--out FILE]``.

Each client runs in a process and an environment of its own, one after the other, and what hangs is stopped. The lines
of JSON go to the file as they come; at the end the table of them is printed, as docs/simulators.md shows it.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from contextlib import nullcontext
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from sceneweaver.assets.placed import Load, loader, welded_assets
from sceneweaver.export import export_scene, format_named
from sceneweaver.home import Home, is_home
from sceneweaver.scene import Scene
from tests.clients.environments import UnavailableError, python_of
from tests.clients.expected import expected, expected_of_home

SECONDS, LIMIT = 3.0, 900.0
"""How long rooms are let loose, and how long a client may take for one, in seconds."""


@dataclass(frozen=True)
class Entry:
    """A row of the table: its title, the module ``client_<module>.py``, its environment, the format it reads."""

    title: str
    module: str
    environment: str
    format: str


CLIENTS = {
    "mujoco": Entry("MuJoCo", "mujoco", "mujoco", "mjcf"),
    "mujoco_sleep": Entry("MuJoCo, sleeping", "mujoco_sleep", "mujoco", "mjcf"),
    "mujoco_warp": Entry("MuJoCo Warp", "mujoco_warp", "newton", "mjcf"),
    "mujoco33": Entry("MuJoCo 3.3", "mujoco", "mujoco33", "mjcf"),
    "dm_control": Entry("dm_control", "dm_control", "dm_control", "mjcf"),
    "robosuite": Entry("robosuite", "robosuite", "robosuite", "mjcf:robosuite"),
    "newton": Entry("Newton, MJCF", "newton", "newton", "mjcf:newton"),
    "newton_usd": Entry("Newton, USD", "newton_usd", "newton", "usd"),
    "ovphysx": Entry("ovphysx", "ovphysx", "ovphysx", "usd"),
    "sapien": Entry("SAPIEN", "sapien", "sapien", "urdf"),
    "drake": Entry("Drake", "drake", "drake", "sdf"),
    "pybullet": Entry("PyBullet", "pybullet", "pybullet", "urdf"),
    "pybullet_sdf": Entry("PyBullet", "pybullet_sdf", "pybullet", "sdf:pybullet"),
    "genesis": Entry("Genesis", "genesis", "genesis", "mjcf:genesis"),
    "blender": Entry("Blender, GLB", "blender", "blender", "glb"),
    "blender_usd": Entry("Blender, USD", "blender_usd", "blender", "usd"),
}


def run(python: Path, module: str, folder: Path, wanted: Path, seconds: float, limit: float = LIMIT) -> dict[str, Any]:
    """What a client measures in a folder; ``error`` says in a line why nothing."""
    script = Path(__file__).with_name("measure.py")
    command = [str(python), "-B", str(script), module, str(folder), str(wanted), str(seconds)]
    try:
        done = subprocess.run(command, cwd=wanted.parent, capture_output=True, text=True, timeout=limit, check=False)
    except subprocess.TimeoutExpired:
        return {"client": module, "error": f"not done within {limit:g} s"}
    if done.returncode:
        lines = done.stderr.strip().splitlines() or [f"exit code {done.returncode}"]
        return {"client": module, "error": lines[-1][:300]}
    return json.loads(done.stdout.strip().splitlines()[-1])


def write_home(home: Home, folder: Path, name: str, load: Load) -> None:
    """Write a home in a format into a new folder, under the name of a scene's file, by which clients load it."""
    folder.mkdir()
    one = format_named(name)
    one.for_homes().write(home, folder / one.file, load, textures=True)


def measure_room(
    path: Path, names: Sequence[str], seconds: float = SECONDS, *, welded: bool = False, keep: Path | None = None
) -> list[dict[str, Any]]:
    """The rows of one file of a scene or a home in those clients; what they read is kept in a folder on wish."""
    rows: list[dict[str, Any]] = []
    home = Home.load(path) if is_home(json.loads(path.read_text())) else None
    load = loader(welded_assets() if welded else None)
    with tempfile.TemporaryDirectory() if keep is None else nullcontext(keep) as place:
        Path(place).mkdir(parents=True, exist_ok=True)
        wanted = Path(place).resolve() / "expected.json"
        found = expected(Scene.load(path), loose=not welded) if home is None else expected_of_home(home, load)
        wanted.write_text(json.dumps(found))
        for name in names:
            entry = CLIENTS[name]
            row: dict[str, Any] = {"name": name, "scene": path.parent.name, "format": entry.format}
            rows.append(row)
            folder = Path(place).resolve() / entry.format.replace(":", "-")
            try:
                if not folder.exists():
                    if home is None:
                        export_scene(Scene.load(path), folder, [entry.format], welded=welded)
                    else:
                        write_home(home, folder, entry.format, load)
                row |= run(python_of(entry.environment), entry.module, folder, wanted, seconds)
            except UnavailableError as error:
                row["error"] = f"skipped: {error}"
            print(json.dumps(row), flush=True)
    return rows


def table(rows: Sequence[dict[str, Any]]) -> str:
    """The rows joined by client, as Markdown: off and most are the largest, shares are over all that may move, joints
    are those that are right and open to 90 %."""
    head = "| client | version | reads | rooms | bodies | off [m] | joints |"
    head += " > 10 cm | > 1 cm | most [mm] | load [s] | speed |"
    lines = [head, "| --- | --- | --- |" + " --: |" * 9]
    for name, entry in CLIENTS.items():
        mine = [r for r in rows if r["name"] == name]
        good = [r for r in mine if "error" not in r]
        if not mine:
            continue
        cells = [entry.title, good[0]["version"] if good else "", f"`{entry.format}`", f"{len(good)} of {len(mine)}"]
        cells += _cells(good) if good else [mine[0]["error"], *[""] * 7]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)


def _cells(rows: Sequence[dict[str, Any]]) -> list[str]:
    def total(key: str) -> int:
        return sum(r.get(key, 0) for r in rows)

    cells = [f"{total('bodies'):,}", f"{max(r['pose_m'] for r in rows):.1e}"]
    cells.append(f"{total('joints_opened')} of {total('joints_expected')}" if total("joints") else "")
    if "far" not in rows[0]:
        return [*cells, "", "", "", f"{sum(r['load_s'] for r in rows) / len(rows):.1f}", ""]
    free = total("free")
    cells += [f"{sum(r[key] * r['free'] for r in rows) / free:.1%}".replace("%", " %") for key in ("far", "little")]
    cells.append(f"{1e3 * max(r['most_m'] for r in rows):.1f}")
    cells.append(f"{sum(r['load_s'] for r in rows) / len(rows):.1f}")
    return [*cells, f"{len(rows) * SECONDS / sum(r['rest_s'] for r in rows):.2g}"]


def main(arguments: Sequence[str]) -> int:
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scenes", nargs="+", type=Path)
    parser.add_argument("--clients", default=",".join(CLIENTS))
    parser.add_argument("--out", type=Path, help="a file that lines of JSON are added to")
    parser.add_argument("--seconds", type=float, default=SECONDS)
    parser.add_argument("--keep", type=Path, help="a folder for what is measured, for measure.py on another machine")
    parser.add_argument("--welded", action="store_true", help="things of fruit bowls, stacks and the like as one body")
    given = parser.parse_args(arguments)
    rows = []
    for path in given.scenes:
        keep = None if given.keep is None else given.keep / path.parent.name
        found = measure_room(path, given.clients.split(","), given.seconds, welded=given.welded, keep=keep)
        rows += found
        if given.out is not None:
            with given.out.open("a", encoding="utf-8") as file:
                file.writelines(json.dumps(row) + "\n" for row in found)
    print(table(rows))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
