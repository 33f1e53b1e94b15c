"""Scenes of any system judged alike: `evaluate` for one, `compare` for several side by side."""

from __future__ import annotations

import hashlib
import json
import math
import os
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import islice
from pathlib import Path
from typing import Any

from sceneweaver.assets import Library
from sceneweaver.io import InputError
from sceneweaver.io.messages import clean, show
from sceneweaver.runtime.deadline import Deadline
from sceneweaver.runtime.package import package_version
from sceneweaver.scene import Scene

from .candidate import Candidate, Reading, Source, candidates
from .judge import SceneRow
from .metrics import METRICS
from .requested import Requests
from .summary import Evaluation, summed
from .work import Task, rows_of

SCHEMA = "sceneweaver.comparison/1"

SCENE_LIMIT = 120.0
"""Seconds that a scene may take, unless another limit is given."""

VERSION = 1
"""Of what is measured: rows of another one are not taken again."""

Sources = Source | Iterable[Source]


@dataclass(frozen=True)
class Comparison:
    """Several systems, judged alike.

    Attributes:
        systems: what was found of each, in the order given.
        settings: how it was measured.
        shown: some scenes of each system, for pictures.

    Examples:
        >>> import sceneweaver as sw
        >>> examples = {name: sw.Scene.example(name) for name in ("bedroom", "study")}
        >>> found = sw.compare(examples, stability=False)
        >>> [round(system.figures["objects"].value) for system in found.systems]
        [16, 17]
    """

    systems: tuple[Evaluation, ...]
    settings: Mapping[str, Any] = field(default_factory=dict)
    shown: Mapping[str, tuple[Candidate, ...]] = field(default_factory=dict)

    @property
    def cut_off(self) -> bool:
        """Whether time was up before all scenes were judged."""
        return any(system.cut_off for system in self.systems)

    def system(self, name: str) -> Evaluation:
        """The one of that name; InputError when there is none."""
        for system in self.systems:
            if system.name == name:
                return system
        raise InputError(f"system: {show(name)} is not one of {', '.join(s.name for s in self.systems)}")

    def table(self) -> str:
        """The table as Markdown: a line a figure, a column a system."""
        heads = [f"{s.name} (n = {s.judged})" for s in self.systems]
        lines = [
            "| figure | better | " + " | ".join(heads) + " |",
            "| --- | --- |" + " ---: |" * len(heads),
        ]
        for metric in METRICS:
            cells = [s.figures[metric.key].text(metric) for s in self.systems]
            lines.append(f"| {metric.title} | {metric.better or '-'} | " + " | ".join(cells) + " |")
        return "\n".join(lines) + "\n"

    def to_dict(self) -> dict[str, Any]:
        """Plain JSON data: figures with their definitions, without the rows."""
        return {
            "schema": SCHEMA,
            "settings": dict(self.settings),
            "metrics": [
                {
                    "key": m.key,
                    "title": m.title,
                    "unit": m.unit,
                    "better": m.better,
                    "definition": m.definition,
                    "source": m.source,
                }
                for m in METRICS
            ],
            "systems": [system.to_dict() for system in self.systems],
        }

    def to_json(self) -> str:
        """The text of ``comparison.json``."""
        return json.dumps(self.to_dict(), ensure_ascii=False, allow_nan=False, indent=1) + "\n"


def evaluate(scenes: Sources, *, name: str = "scenes", reading: Reading | None = None, **options: Any) -> Evaluation:
    """Judge the scenes of one system.

    Args:
        scenes: scenes, or files and folders of scenes in any format that is read.
        name: of the system.
        reading: how files are read.
        options: as of `compare`.

    Returns:
        Its figures, each with an interval over scenes, or why there is none.

    Raises:
        InputError: as `compare`.

    Examples:
        >>> import sceneweaver as sw
        >>> found = sw.evaluate([sw.Scene.example("bedroom"), sw.Scene.example("study")], stability=False)
        >>> found.judged, found.figures["collisions"].value, found.figures["objects"].value
        (2, 0.0, 16.5)
    """
    readings = {} if reading is None else {name: reading}
    return compare({name: scenes}, readings=readings, **options).systems[0]


def compare(  # noqa: PLR0913 - keyword-only, each with its default
    systems: Mapping[str, Sources],
    *,
    readings: Mapping[str, Reading] | None = None,
    prompts: Requests | str | Path | None = None,
    reference: str | Sources | None = None,
    stability: bool = True,
    limit: int | None = None,
    jobs: int = 1,
    scene_limit: float = SCENE_LIMIT,
    time_limit: float | None = None,
    library: Library | None = None,
    on_error: Callable[[str, str], None] | None = None,
    on_row: Callable[[SceneRow], None] | None = None,
    known: Mapping[str, SceneRow] | None = None,
    deadline: Deadline | None = None,
    pictures: int = 0,
) -> Comparison:
    """Judge the scenes of several systems, all by the same judge.

    Args:
        systems: by name scenes, or files and folders of scenes in any format that is read.
        readings: by name how the files of a system are read, where that is another way than by what is in them.
        prompts: annotated requests, a CSV file as of SceneEval; a scene goes with the request of its prompt, else of
            the last number in its name.
        reference: scenes whose categories others are compared with, or the name of one of the systems.
        stability: whether scenes are simulated by MuJoCo for 5 s.
        limit: scenes of each system at most; None: all.
        jobs: processes; with 1 all is done in this one.
        scene_limit: seconds that a scene may take.
        time_limit: seconds after which no more scenes are begun; what is there is summed up.
        library: where assets come from, with one process; None: the library of this user.
        on_error: called with a system and a line for a file that cannot be read; None: the line is kept alone.
        on_row: called with each row as it is made.
        known: rows that were made before, by key: scenes that have one are not judged again.
        deadline: instead of ``time_limit``.
        pictures: scenes of each system to keep for pictures.

    Raises:
        InputError: no system, a file that cannot be read where it is the only one, an option out of its range.

    Examples:
        >>> import sceneweaver as sw
        >>> scene = sw.Scene.example("bedroom")
        >>> broken = scene.replace_poses({"wardrobe": scene.object("bed").pose})
        >>> found = sw.compare({"as made": scene, "broken": broken}, stability=False)
        >>> [system.figures["clean_scenes"].value for system in found.systems]
        [1.0, 0.0]
    """
    _require(systems, limit, jobs, scene_limit, time_limit, library)
    requests = Requests.load(prompts) if isinstance(prompts, str | Path) else prompts
    end = deadline or Deadline(math.inf if time_limit is None else time.monotonic() + time_limit)
    how, refused = readings or {}, {name: list[str]() for name in systems}

    def refuse(name: str, line: str) -> None:
        refused[name].append(line)
        if on_error is not None:
            on_error(name, line)

    if isinstance(reference, str) and reference not in systems and not os.path.exists(reference):
        raise InputError(f"reference: {clean(reference)} is no file or folder, nor one of {', '.join(systems)}")
    settings = _settings(stability, requests, limit, scene_limit, how)
    rows: dict[str, list[tuple[int, SceneRow]]] = {name: [] for name in systems}
    shown: dict[str, list[Candidate]] = {name: [] for name in systems}
    places: dict[str, int] = {}
    begun, complete = dict.fromkeys(systems, 0), dict.fromkeys(systems, False)

    def tasks() -> Iterator[Task]:
        for name, sources in systems.items():
            own = candidates(sources, how.get(name), lambda line, name=name: refuse(name, line))
            for place, candidate in enumerate(islice(own, limit)):
                if len(shown[name]) < pictures:
                    shown[name].append(candidate)
                asked = requests.find(prompt=candidate.scene.prompt, name=candidate.name) if requests else None
                key = _key(name, place, candidate, asked.lines if asked is not None else (), stability)
                places[key] = place
                begun[name] += 1
                if known is not None and key in known:
                    rows[name].append((place, known[key]))
                    continue
                yield Task(name, candidate, stability, asked, scene_limit, key)
            complete[name] = True

    load = library.load if library is not None else None
    for row in rows_of(tasks(), jobs, end, load):
        rows[row.system].append((places[row.key], row))
        if on_row is not None:
            on_row(row)
    wanted = _reference(reference, systems, rows)
    found = []
    for name in systems:
        own = [row for _, row in sorted(rows[name], key=lambda pair: pair[0])]
        cut = not complete[name] or len(own) < begun[name]
        found.append(summed(name, own, reference=wanted, refused=refused[name], cut_off=cut))
    return Comparison(tuple(found), settings, {name: tuple(some) for name, some in shown.items()})


def _require(
    systems: Mapping[str, Any],
    limit: int | None,
    jobs: int,
    scene_limit: float,
    time_limit: float | None,
    library: Library | None,
) -> None:
    if not systems:
        raise InputError("systems: there are none; give at least one, such as {'ours': 'designs/'}")
    if limit is not None and limit < 1:
        raise InputError(f"limit is {limit}; give at least 1")
    if jobs < 1:
        raise InputError(f"jobs is {jobs}; give at least 1")
    for name, seconds in (("scene_limit", scene_limit), ("time_limit", time_limit)):
        if seconds is not None and not seconds > 0:
            raise InputError(f"{name} is {seconds:g}; give seconds above 0")
    if library is not None and jobs > 1:
        raise InputError("library: is for one process; give jobs=1, or import its assets into the user's library")


def _settings(
    stability: bool, requests: Requests | None, limit: int | None, scene_limit: float, how: Mapping[str, Reading]
) -> dict[str, Any]:
    return {
        "version": package_version(),
        "stability": stability,
        "prompts": len(requests.by_id) if requests is not None else 0,
        "limit": limit,
        "scene_limit": scene_limit,
        "readings": {
            name: {"format": one.format, "assets": one.assets, "assume_sizes": one.assume_sizes}
            for name, one in how.items()
        },
    }


def _key(system: str, place: int, candidate: Candidate, lines: Sequence[Any], stability: bool) -> str:
    """Of a row: equal where the scene, its system and what is measured are the same."""
    said = [VERSION, package_version(), system, place, candidate.name, stability, candidate.format]
    said += [sorted(candidate.lacks.items()), [line.text for line in lines], candidate.scene.dumps()]
    return hashlib.sha256(json.dumps(said, ensure_ascii=False).encode()).hexdigest()[:32]


def _reference(
    reference: str | Sources | None, systems: Mapping[str, Any], rows: Mapping[str, list[tuple[int, SceneRow]]]
) -> list[Mapping[str, int]] | None:
    """Categories of the scenes of the reference set."""
    if reference is None:
        return None
    if isinstance(reference, str) and reference in systems:
        return [row.categories for _, row in rows[reference]]
    return [_categories(candidate.scene) for candidate in candidates(reference)]


def _categories(scene: Scene) -> dict[str, int]:
    found: dict[str, int] = {}
    for obj in scene.objects:
        found[obj.category] = found.get(obj.category, 0) + 1
    return found
