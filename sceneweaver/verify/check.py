"""The judge: one call that measures everything about a scene and says what is wrong."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sceneweaver.io import InputError
from sceneweaver.io.messages import is_number, show
from sceneweaver.runtime.deadline import checkpoint
from sceneweaver.runtime.package import package_version
from sceneweaver.scene import Relation, Scene
from sceneweaver.verify import bounds, collisions, free_floor, stability, support, turned, zones
from sceneweaver.verify import walkable as access
from sceneweaver.verify.measure import Judgement
from sceneweaver.verify.meshes import MeshSet
from sceneweaver.verify.relations import judge_relation
from sceneweaver.verify.report import LinkTravel, RelationRef, RelationTally, Report, Tally, Violation
from sceneweaver.verify.solids import Placed

if TYPE_CHECKING:
    from sceneweaver.assets import Library
    from sceneweaver.assets.placed import Load


def check(
    scene: Scene,
    *,
    meshes: MeshSet | Mapping[str, Any] | str | Path | None = None,
    walkable: bool = True,
    physics: bool = False,
    openable: bool = False,
    library: Library | None = None,
    robot_radius: float = access.RADIUS,
) -> Report:
    """Judge a scene in float64, independently of the engine that made it.

    Args:
        scene: what to judge.
        meshes: the true shapes of assets: asset id -> ``trimesh.Trimesh`` or mesh file, a folder of
            ``<asset>.glb|obj|stl|ply`` files, or a `MeshSet` to be used again. Without it, objects are their parts or
            boxes.
        walkable: whether to measure the shares of the floor that can be walked on and reached, by a flood fill.
        physics: whether to simulate the scene by MuJoCo, with the collision parts of its assets; what does not stay
            where it is makes it invalid.
        openable: whether to measure how far doors, drawers and lids open, with the collision parts of their assets; one
            that is needed and blocked makes the scene invalid. Where an asset cannot be loaded, a warning says so.
        library: where the assets come from, for physics and what opens; None: the library of this user.
        robot_radius: of the base [m] that the shares of the floor are measured for, a disc; 0.01 to 5.

    Returns:
        Counts, shares, and every violation with its amount [m, or degrees].

    Raises:
        InputError: meshes that cannot be read, or a radius out of its range.

    Examples:
        >>> import sceneweaver as sw
        >>> scene = sw.Scene.example("bedroom")
        >>> report = sw.check(scene)
        >>> report.valid, report.collisions, report.relations.hard.satisfied == report.relations.hard.total
        (True, 0, True)
    """
    checkpoint()
    least, most = access.RADII
    if not is_number(robot_radius) or not least <= robot_radius <= most:
        raise InputError(f"robot_radius is {show(robot_radius)}; give metres, {least:g} to {most:g}")
    clock, warnings = _Clock(), list[str]()
    placed, shapes = Placed.of(scene), MeshSet.of(meshes)
    load = library.load if library is not None else None
    doubled = {second.id: first.id for first, second in reversed(scene.room.doubled)}
    warnings += [f"{second} is in the place of {first}: listed twice?" for second, first in sorted(doubled.items())]
    found = [Violation("dropped", (d.id,), f"{d.id} could not be placed: {d.reason}", 0.0) for d in scene.dropped]
    clock.lap("prepare")
    found += collisions.find(placed, shapes, warnings)
    clock.lap("collisions")
    found += bounds.find(placed, shapes)
    clock.lap("bounds")
    found += support.find(placed)
    clock.lap("support")
    found += zones.find(placed, warnings)
    clock.lap("zones")
    found += turned.find(scene)
    if scene.free_areas:
        found += free_floor.find(placed)
        clock.lap("free floor")
    judgements = []
    for relation in scene.relations:
        checkpoint()
        judgements.append(judge_relation(placed, relation))
    found += [_relation(scene, k, judgement) for k, judgement in enumerate(judgements) if not judgement.holds]
    clock.lap("relations")
    shares = links = steady = None
    if walkable:
        shares = access.measure(placed, robot_radius)
        clock.lap("walkable")
        if shares is None:
            warnings.append("the room is too large for the floor grid; walkable and reachable shares were not measured")
    if physics:
        steady, fallen = stability.measure(scene, load)
        found += fallen
        clock.lap("physics")
    if openable:
        links = _openable(scene, load, warnings)
        clock.lap("openable")
    report = _report(
        scene,
        found,
        RelationTally(*(_tally(scene.relations, judgements, hard) for hard in (True, False))),
        walkable_share=shares.walkable if shares else None,
        reachable_share=shares.reachable if shares else None,
        robot_radius=float(robot_radius) if shares and robot_radius != access.RADIUS else None,
        stability=steady,
        seconds=clock.seconds(),
        warnings=tuple(warnings),
    )
    if links is None:
        return report
    from sceneweaver.verify.openable import judged

    return judged(report, scene, links)


def _report(scene: Scene, found: list[Violation], relations: RelationTally, **more: Any) -> Report:
    """The report of what was found, with its counts by kind."""
    counts = Counter(violation.kind for violation in found)
    return Report(
        valid=not any(v.hard for v in found),
        requested=len(scene.objects) + len(scene.dropped),
        placed=len(scene.objects),
        dropped=len(scene.dropped),
        collisions=counts["collision"],
        out_of_bounds=counts["out_of_bounds"],
        unsupported=counts["unsupported"],
        blocked_zones=counts["blocked_zone"],
        blocked_openings=counts["blocked_opening"],
        relations=relations,
        violations=tuple(found),
        versions=versions(),
        **more,
    )


def _openable(scene: Scene, load: Load | None, warnings: list[str]) -> list[LinkTravel] | None:
    """How far what opens does; None, with a warning, where an asset cannot be loaded."""
    from sceneweaver.verify import openable

    try:
        return openable.measure(scene, load)
    except InputError as error:
        warnings.append(f"how far doors and drawers open was not measured: {error}")
        return None


def _relation(scene: Scene, index: int, judgement: Judgement) -> Violation:
    r = scene.relations[index]
    said = " ".join((r.subject, r.type, " and ".join(r.targets))).rstrip()
    return Violation.of(
        "relation" if r.hard else "soft_relation",
        (r.subject, *r.targets),
        f"{said}: {judgement.text}",
        judgement.worst,
        relation=RelationRef(index, r.type, r.subject, r.target),
    )


def _tally(relations: tuple[Relation, ...], judgements: list[Judgement], hard: bool) -> Tally:
    holds = [j.holds for r, j in zip(relations, judgements, strict=True) if r.hard is hard]
    return Tally(len(holds), sum(holds))


class _Clock:
    def __init__(self) -> None:
        self._start = self._last = time.perf_counter()
        self._laps: dict[str, float] = {}

    def lap(self, name: str) -> None:
        now = time.perf_counter()
        self._laps[name] = now - self._last
        self._last = now

    def seconds(self) -> dict[str, float]:
        return {"total": time.perf_counter() - self._start, **self._laps}


def versions() -> dict[str, str]:
    """Of the library and of what it measures with, by name."""
    return dict(_versions())


@cache
def _versions() -> tuple[tuple[str, str], ...]:
    import platform
    from importlib.metadata import PackageNotFoundError, version

    found = [("python", platform.python_version()), ("sceneweaver", package_version())]
    for name in ("numpy", "shapely", "manifold3d", "scipy", "trimesh"):
        try:
            found.append((name, version(name)))
        except PackageNotFoundError:
            continue
    return tuple(found)
