"""A problem of the zoo: a scene at a bad start, what is known of it, its card, and layouts to start from."""

from __future__ import annotations

import hashlib
import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import jinja2
import numpy as np

from sceneweaver.geometry.se2 import absolute, relative
from sceneweaver.io import packaged
from sceneweaver.scene import SCHEMA, InputError, Pose, Scene
from sceneweaver.verify import check

from .certificates import prove
from .recipes import MOST_SEED, families, whole_number

if TYPE_CHECKING:
    from sceneweaver.layout import ObjectiveTerm, Problem
    from sceneweaver.layout.objective_values import ObjectiveValues

Json = dict[str, Any]

NOISE_M, NOISE_RAD = 0.3, math.radians(15)
"""Deviations of the noise on a witness to start from [m], [rad]."""


@dataclass(frozen=True, eq=False)
class ProblemCase:
    """A problem, frozen or generated.

    Attributes:
        name: ``family/...``, unique in the zoo.
        family: what kind of problem it is, see `families`.
        version: counts up when the problem changes; results are comparable where version and hash are the same.
        hash: SHA-256 of the problem's canonical bytes (`canonical`), as hexadecimal digits.
        scene: the scene at a bad start: all that may move lies anywhere.
        witness: a valid layout [N, 4] float32 (x, y, z [m], yaw [rad]); None where there is none.
        certificate: a proof that no layout is valid, which `prove` checks; None where there is one.
        objective: terms to be minimised among valid layouts; without any, being valid is all.
        facts: measured figures: ``tightness`` (share of the floor that footprints and hard zones take, the doors' own
            floor left out), ``density`` (hard relations an object), ``wishes`` (soft ones), ``wall_fill`` (share of the
            walls that backs stand at), ``surface_tightness``.
        best_energy: the lowest energy [m] of a valid layout that is known; None where nothing was measured.
        best: a layout [N, 4] float32 of that energy; None where it is the witness's, or nothing was measured.
        difficulty: for each optimiser that was tried its share of valid layouts, with the budget.
        best_objective: the lowest objective of a valid layout that is known; None without an objective.
        best_layout: a layout [N, 4] float32 that has it; None where it is the witness's.
        starts: names that `start` knows.

    Examples:
        >>> from sceneweaver import problems
        >>> case = problems.load("packing/n005-t60")
        >>> problem = case.compile("cpu")
        >>> problem.feasible(case.start("random", 4, seed=0)).any(), problem.feasible(case.witness[None]).all()
        (np.False_, np.True_)
    """

    name: str
    family: str
    version: int
    hash: str
    scene: Scene
    witness: np.ndarray | None
    certificate: Json | None
    facts: Mapping[str, float]
    best_energy: float | None = None
    best: np.ndarray | None = None
    difficulty: Mapping[str, Any] = field(default_factory=dict)
    objective: tuple[ObjectiveTerm, ...] = ()
    best_objective: float | None = None
    best_layout: np.ndarray | None = None
    _compiled: dict[str, Problem] = field(default_factory=dict, init=False, repr=False)

    def __getstate__(self) -> dict[str, Any]:
        """What another process gets: it compiles for itself."""
        return vars(self) | {"_compiled": {}}

    def __repr__(self) -> str:
        kind = "feasible" if self.feasible else "infeasible"
        return f"ProblemCase({self.name!r}, {len(self.scene.objects)} objects, {kind}, version {self.version})"

    @property
    def feasible(self) -> bool:
        """Whether a valid layout is known."""
        return self.witness is not None

    @property
    def starts(self) -> tuple[str, ...]:
        """Names of the start distributions that `start` knows."""
        return ("sample", "random", "perturbed") if self.feasible else ("sample", "random")

    @property
    def card(self) -> str:
        """What there is to know of the problem, as Markdown."""
        return card_of(self)

    def compile(self, device: str = "auto") -> Problem:
        """The problem on a device ("auto", "cpu", "cuda", "cuda:k"), compiled once.

        Raises:
            InputError: a wrong device. MissingDependencyError: the device is not there.
        """
        from sceneweaver.layout import compile as compile_problem

        if device not in self._compiled:
            self._compiled[device] = compile_problem(self.scene, device=device)
        return self._compiled[device]

    def start(self, name: str, count: int, seed: int = 0) -> np.ndarray:
        """Draw layouts to start from.

        Args:
            name: "sample" (drawn from the relations by the engine), "random" (anywhere in the box around the room,
                things anywhere on their surface) or "perturbed" (the witness with noise of 0.3 m and 15 degrees).
            count: how many.
            seed: from 0 to 2**32 - 1; equal seeds give equal layouts.

        Returns:
            Poses [count, N, 4] float32.

        Raises:
            InputError: another name, or one that this problem has not; a bad count or seed.
        """
        if name not in self.starts:
            raise InputError(f"start: {name!r} is none of {', '.join(self.starts)} of {self.name}")
        count, seed = whole_number("count", count, 1, MOST_SEED), whole_number("seed", seed, 0, MOST_SEED)
        if name == "sample":
            return self.compile("cpu").sample(seed, count)
        return draw(self.scene, self.witness if name == "perturbed" else None, count, seed)

    def layout(self, poses: np.ndarray) -> Scene:
        """The scene at poses [N, 4].

        Raises:
            InputError: ``poses`` has another shape.
        """
        return placed(self.scene, poses)

    def objective_of(self, poses: np.ndarray) -> np.ndarray:
        """The objective of layouts [B, N, 4], as [B] float64, whether they are valid or not; 0 without terms."""
        return self._values(poses).sum(axis=1)

    @cached_property
    def _values(self) -> ObjectiveValues:
        from sceneweaver.layout.objective_values import ObjectiveValues

        return ObjectiveValues(self.scene, self.objective)

    def judge(self, poses: np.ndarray) -> tuple[bool, float | None]:
        """Whether the judge, which is not the engine, finds a layout [N, 4] valid, and its objective; None without one.

        Raises:
            InputError: ``poses`` has another shape.
        """
        valid = check(self.layout(poses), walkable=False).valid
        return valid, float(self.objective_of(np.asarray(poses)[None])[0]) if self.objective else None


def placed(scene: Scene, poses: np.ndarray) -> Scene:
    """A scene at poses [N, 4] (x, y, z, yaw)."""
    given = np.asarray(poses, dtype=np.float64)
    if given.shape != (len(scene.objects), 4):
        raise InputError(f"poses: shape {given.shape}; give one row x, y, z, yaw for each of {len(scene.objects)}")
    return scene.replace_poses({o.id: Pose.from_yaw(*map(float, p)) for o, p in zip(scene.objects, given, strict=True)})


def plain(case: ProblemCase) -> Json:
    """The problem as plain JSON data: what its hash is of. What a scene leaves to its defaults is left out."""
    data = {
        "name": case.name,
        "family": case.family,
        "version": case.version,
        "scene": case.scene.model_dump(mode="json", by_alias=True, exclude_defaults=True),
        "witness": None if case.witness is None else [[float(str(v)) for v in row] for row in case.witness],
        "certificate": case.certificate,
    }
    if case.objective:
        data["objective"] = [term.to_dict() for term in case.objective]
    return data


def canonical(case: ProblemCase) -> bytes:
    """The bytes that a problem's hash is of: its JSON with sorted keys, without spaces, in UTF-8.

    Examples:
        >>> import hashlib
        >>> from sceneweaver import problems
        >>> case = problems.load("packing/n005-t60")
        >>> hashlib.sha256(problems.canonical(case)).hexdigest() == case.hash
        True
    """
    return json.dumps(plain(case), sort_keys=True, separators=(",", ":"), ensure_ascii=False).encode()


def from_plain(data: Json, facts: Mapping[str, float], **known: Any) -> ProblemCase:
    """A problem from its plain data, with its hash. Each call reads the scene anew."""
    witness = None if data["witness"] is None else np.array(data["witness"], dtype=np.float32).reshape(-1, 4)
    if witness is not None:
        witness.flags.writeable = False
    scene = Scene.from_json({"schema": SCHEMA, **data["scene"]})
    rest = {key: data[key] for key in ("name", "family", "version", "certificate")}
    objective = _terms(data["objective"]) if data.get("objective") else ()
    case = ProblemCase(hash="", scene=scene, witness=witness, facts=facts, objective=objective, **rest, **known)
    return replace(case, hash=hashlib.sha256(canonical(case)).hexdigest())


def _terms(rows: Sequence[Json]) -> tuple[ObjectiveTerm, ...]:
    from sceneweaver.layout import terms_from  # the engine is loaded where it is needed

    return tuple(terms_from(rows))


def card_of(case: ProblemCase) -> str:
    """A title, a line on the family, a table of figures, what proves the problem, how hard it is."""
    scene = case.scene
    relations = [
        f"{len(some)} {word}: {', '.join(sorted({r.type for r in some}))}"
        for word, hard in (("hard", True), ("soft", False))
        if (some := [r for r in scene.relations if r.hard == hard])
    ]
    text = packaged.text(__package__ or "", "card.md")
    return jinja2.Template(text, trim_blocks=True, lstrip_blocks=True).render(
        case=case,
        scene=scene,
        about=families()[case.family],
        carried=sum(o.support is not None for o in scene.objects),
        zones=sum(z.hard for o in scene.objects for z in o.zones),
        parts=sum(len(o.solids) for o in scene.objects),
        relations="; ".join(relations) or "none",
        proof=prove(scene, case.certificate) if case.certificate is not None else None,
        best="not measured" if case.best_energy is None else f"{case.best_energy:.4g} m",
        tried={name: row for name, row in case.difficulty.items() if isinstance(row, dict)},
    )


def draw(scene: Scene, witness: np.ndarray | None, count: int, seed: int) -> np.ndarray:
    """Layouts [count, N, 4] float32, by a stream of its own for each seed.

    Without a witness all but what stands on a surface is uniform in the box around the room, at its own height, and
    what stands on a surface uniform in the box around that; all turned anyhow. With one, it is the witness with noise,
    N(0, 0.3 m) and N(0, 15 degrees), for all but what stands on a surface, which goes along. What is fixed stays.
    """
    rng = np.random.default_rng([seed, 0 if witness is None else 1])
    n = len(scene.objects)
    own = np.array([(*o.pose.position, o.pose.yaw) for o in scene.objects], dtype=np.float64).reshape(n, 4)
    base = own if witness is None else witness.astype(np.float64)
    poses = np.repeat(base[None], count, axis=0)
    outline = np.array(scene.room.outline)
    for i in _supporters_first(scene):
        item = scene.objects[i]
        if item.fixed:
            continue
        if item.support is None and witness is None:
            poses[:, i, :2] = rng.uniform(outline.min(axis=0), outline.max(axis=0), (count, 2))
            poses[:, i, 3] = rng.uniform(-math.pi, math.pi, count)
        elif item.support is None:
            poses[:, i, :2] += rng.normal(0.0, NOISE_M, (count, 2))
            poses[:, i, 3] += rng.normal(0.0, NOISE_RAD, count)
        else:
            below = scene.index(item.support.object)
            local = np.repeat(relative(base[i], base[below])[None], count, axis=0)
            if witness is None:
                surface = next(s for s in scene.objects[below].surfaces if s.name == item.support.surface)
                corners = np.array(surface.polygon)
                local[:, :2] = rng.uniform(corners.min(axis=0), corners.max(axis=0), (count, 2))
                local[:, 2] = surface.z
                local[:, 3] = rng.uniform(-math.pi, math.pi, count)
            poses[:, i] = absolute(local, poses[:, below])
    return poses.astype(np.float32)


def _supporters_first(scene: Scene) -> list[int]:
    def depth(i: int) -> int:
        support = scene.objects[i].support
        return 0 if support is None else 1 + depth(scene.index(support.object))

    return sorted(range(len(scene.objects)), key=depth)
