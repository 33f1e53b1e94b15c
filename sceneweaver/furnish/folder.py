"""The folder of a home: what a run that was cut off goes on from, and the rooms that it has furnished."""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from sceneweaver.agent.design import chosen_room
from sceneweaver.critic import review_scene
from sceneweaver.home import Home
from sceneweaver.io import InputError, locked, own_folder, parse_json, read_bytes, sweep, write_atomic
from sceneweaver.language import read_request
from sceneweaver.scene import Scene
from sceneweaver.verify import check

from .jobs import FurnishedRoom, RoomJob, lacking

HOME, METRICS, REPORT, RUN, PLAN, PROGRAMME = (
    "home.json",
    "metrics.json",
    "report.html",
    "run.json",
    "plan.json",
    "programme.yaml",
)
"""Files of the folder: the home and its verdict, the page about it, and what a run goes on from."""

SCHEMA = "sceneweaver.home-run/1"

PLAIN = re.compile(r"[A-Za-z0-9][A-Za-z0-9_-]{0,63}")
"""Ids of rooms that are names of folders."""

ROOMS, VIEWS, SCENE, STATE = "rooms", "views", "scene.json", "room.json"


class HomeFolder:
    """Writes a home step by step; what it holds is whole at any moment.

    Args:
        path: of the folder; it is made where it is not there.
    """

    def __init__(self, path: Path):
        self.path = path

    @contextmanager
    def held(self) -> Iterator[None]:
        """Make the folder, keep other processes from writing to it, and clear away what a killed run left half written.

        Raises:
            InputError: when the folder cannot be written, holds the run of a single room, or another process writes
                to it.
        """
        try:
            self.path.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise InputError(f"--out: {self.path} cannot be written ({error.strerror}); choose another place") from None
        if (self.path / "state.json").exists():
            raise InputError(f"--out: {self.path} holds the design of a room; choose another place for a home")
        own_folder(self.path / ROOMS)
        with locked(self.path / HOME, f"--out: {self.path}"):
            for folder in (self.path, self.path / VIEWS, *self.path.glob(f"{ROOMS}/*")):
                sweep(folder)
            yield

    def begin(self, key: Mapping[str, Any]) -> dict[str, Any]:
        """What a run with this key left here to go on from: ``round`` and ``log``; empty for a new run.

        Raises:
            InputError: the folder holds another run.
        """
        path = self.path / RUN
        if not path.exists() and not path.is_symlink():
            return {}
        data = parse_json(read_bytes(path, within=self.path))
        if not isinstance(data, dict) or data.get("schema") != SCHEMA:
            raise InputError(f"{path}: this is no state of a run; remove it or choose another folder")
        had = data.get("key", {})
        for name, value in key.items():
            if had.get(name) != value:
                raise InputError(
                    f"--out: {self.path} holds a run with {name} {had.get(name)!r}, not {value!r}; choose another place"
                )
        return {name: data.get(name) for name in ("round", "log", "asked")}

    def planned(self, key: Mapping[str, Any], home: Home, programme: str, **state: Any) -> None:
        """Write the plan that is furnished next, and then the state that points to it."""
        self.write(PLAN, home.dumps())
        self.write(PROGRAMME, programme)
        self.write(RUN, _text({"schema": SCHEMA, "key": dict(key), **state}))

    def plan(self) -> Home | None:
        """The plan that the state points to; None where there is none."""
        return Home.load(self.path / PLAN) if (self.path / PLAN).is_file() else None

    def keep(self, job: RoomJob, room: FurnishedRoom) -> None:
        """Write a room that is done, its scene first; one that was cut off is not kept."""
        if room.scene is None or room.cut_off:
            return
        there = self.kept(job)
        if there is not None and there.scene == room.scene:
            return
        folder = own_folder(self.path / ROOMS / room_folder(job.room_id))
        write_atomic(folder / SCENE, room.scene.dumps(), within=self.path)
        state = {
            "key": digest(job),
            "request": room.request,
            "unmet": list(room.unmet),
            "notes": list(room.notes),
            "seconds": room.seconds,
        }
        write_atomic(folder / STATE, _text(state), within=self.path)

    def kept(self, job: RoomJob) -> FurnishedRoom | None:
        """A room of the same job that was furnished before; None: there is none, or it is damaged."""
        folder = self.path / ROOMS / room_folder(job.room_id)
        try:
            state = parse_json(read_bytes(folder / STATE, within=self.path))
            if not isinstance(state, dict) or state.get("key") != digest(job):
                return None
            scene = Scene.load(folder / SCENE, within=self.path)
        except InputError:
            return None
        brief = read_request(job.request)
        report = check(scene)
        review = review_scene(scene, report, chosen_room(brief, scene.room)[0], brief)
        unmet, notes = (tuple(map(str, state.get(name) or ())) for name in ("unmet", "notes"))
        seconds = float(state.get("seconds") or 0.0)
        return FurnishedRoom(
            job.room_id, job.request, scene, report, review, unmet, lacking(scene, brief), notes, seconds
        )

    def write(self, name: str, text: str) -> None:
        """Write a file of the folder, whole or not at all."""
        write_atomic(self.path / name, text, within=self.path)


def room_folder(room_id: str) -> str:
    """The name of the folder of a room: its id, where that is a plain name."""
    return room_id if PLAIN.fullmatch(room_id) else f"room-{hashlib.sha256(room_id.encode()).hexdigest()[:12]}"


def digest(job: RoomJob) -> str:
    """A name for what decides the scene of a room."""
    return hashlib.sha256(json.dumps(job.key, sort_keys=True, default=str).encode()).hexdigest()


def _text(data: Any) -> str:
    return json.dumps(data, indent=1, ensure_ascii=False) + "\n"
