"""The last touch, after which doors and drawers open: doors hung at the other side, pieces turned about or left out."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

from sceneweaver.assets.mirror import mirrored_zone
from sceneweaver.assets.placed import Load
from sceneweaver.assets.sources.parametric import other_hand
from sceneweaver.generate.carry import carried, follow
from sceneweaver.scene import CATALOGUE, PRIORITIES, Pose, Relation, Scene, SceneObject
from sceneweaver.scene.edits import Relate, Remove, apply
from sceneweaver.tools.base import Proposal
from sceneweaver.verify import Violation, check, openable
from sceneweaver.verify.report import LinkTravel

from .executor import Executor, Outcome

APART = 0.6
"""Distance [m] that is asked for between a piece and what keeps it from opening: a door is hardly wider."""

FAR = 100.0
"""Distance [m] that is no limit."""

ROUNDS = 12
"""Pieces that are mended at most."""


def opened(outcome: Outcome, executor: Executor) -> tuple[Outcome, list[str]]:
    """The outcome where more opens and nothing else is worse, with the shares in its report.

    Returns:
        The outcome, and what is to be said of it.
    """
    load = executor.library.load
    scene, notes = outcome.scene, []
    found = openable.measure(scene, load)
    failed: set[str] = set()
    for _ in range(ROUNDS if outcome.report.valid else 0):
        wrong = {v.objects[0] for v in openable.violations(scene, found)}
        blocked = sorted((link for link in found if not link.opens), key=lambda link: link.object not in wrong)
        piece = next((link for link in blocked if link.object not in failed), None)
        if piece is None:
            break
        failed.add(piece.object)
        for other, said in _ways(scene, piece, load, needed=piece.object in wrong):
            links = openable.measure(other, load)
            if _cost(other, links) < _cost(scene, found) and check(other, walkable=False).valid:
                scene, found = other, links
                notes += said
                break
    if scene is not outcome.scene:
        after = executor.judged(scene)
        outcome = replace(after, notes=outcome.notes, unmet=outcome.unmet)
    wrong = openable.violations(scene, found) if outcome.report.valid else []
    if wrong:
        after = _searched(outcome, executor, wrong)
        if after.report.valid and set(after.scene.ids) == set(scene.ids):
            links = openable.measure(after.scene, load)
            if _cost(after.scene, links) < _cost(scene, found):
                scene, found = after.scene, links
                outcome = replace(after, notes=outcome.notes, unmet=outcome.unmet)
    return replace(outcome, report=openable.judged(outcome.report, scene, found)), notes


def _searched(outcome: Outcome, executor: Executor, wrong: Sequence[Violation]) -> Outcome:
    """The outcome of a search that keeps what does not open off what is in its way."""
    edits: dict[str, Relate] = {}
    for violation in wrong:
        piece, blocker = violation.objects[0], violation.objects[-1]
        if piece not in outcome.scene.ids or piece == blocker:
            continue
        # a desk whose user sits between it and the wall stands off every wall, so only what touches one keeps to it
        rows = [r for r in outcome.scene.relations if r.type == "against_wall" and r.subject == piece]
        at_wall = any(CATALOGUE["against_wall"].value(r, "gap")[0] < APART for r in rows)
        if blocker in outcome.scene.ids:
            row = Relation(type="distance", subject=piece, target=blocker, params={"min": APART, "max": FAR})
        elif at_wall:  # with its back
            row = Relation(type="against_wall", subject=piece)
        else:
            row = Relation(type="off_walls", subject=piece, params={"min": APART})
        edits[piece] = Relate(relation=row)
    if not edits:
        return outcome
    return executor.run(outcome.scene, Proposal(edits=tuple(edits.values())), executor.settings.seed, rival=outcome)


def _cost(scene: Scene, found: Sequence[LinkTravel]) -> tuple[int, int]:
    """What is wrong: links that are needed and blocked, then all that are blocked."""
    return len(openable.violations(scene, found)), sum(not link.opens for link in found)


def _ways(scene: Scene, link: LinkTravel, load: Load, *, needed: bool) -> Iterator[tuple[Scene, list[str]]]:
    """Scenes in which a link may open, what changes least first, with what is to be said of each.

    Something goes only where the link is ``needed``: what nobody asked for, be it in the way or the piece itself.
    """
    known = {o.id: o for o in scene.objects}
    piece = known.get(link.object)
    if piece is not None:
        flipped = _mirrored(piece, load)
        turned = _turned(scene, piece)
        if flipped is not None:
            yield _with(scene, flipped), []
        yield turned, []
        if flipped is not None:
            yield _with(turned, flipped.model_copy(update={"pose": turned.object(piece.id).pose})), []
    if not needed:
        return
    usual = PRIORITIES.index("usual")
    pool = [known.get(link.blocked_by or ""), piece]
    for gone in sorted((o for o in pool if o is not None and o.intent.rank <= usual), key=lambda o: o.intent.rank):
        said = f"{gone.id} was left out: {link.link} of {link.object} would not open"
        yield apply(scene, Remove(id=gone.id, cascade=True)), [said]


def _mirrored(piece: SceneObject, load: Load) -> SceneObject | None:
    """The piece with its doors hung at the other side; None where it cannot be had so."""
    asset = other_hand(piece.asset) if piece.asset is not None else None
    if asset is None:
        return None
    drawn = load(asset)
    if drawn.size != piece.size:
        return None
    return piece.model_copy(
        update={
            "asset": drawn.id,
            "parts": drawn.parts,
            "surfaces": drawn.surfaces,
            "zones": tuple(mirrored_zone(zone) for zone in piece.zones),
        }
    )


def _turned(scene: Scene, piece: SceneObject) -> Scene:
    """The scene with a piece, and all on it, turned about: its front is where its back was."""
    pose = piece.pose
    turned = Pose.from_yaw(*pose.position, pose.frame.yaw + math.pi)
    objects = {o.id: o for o in scene.objects}
    riders = {name: follow(pose, turned, objects[name].pose) for name in carried(objects, piece.id)}
    return scene.replace_poses({piece.id: turned, **riders})


def _with(scene: Scene, piece: SceneObject) -> Scene:
    return scene.model_copy(update={"objects": tuple(piece if o.id == piece.id else o for o in scene.objects)})
