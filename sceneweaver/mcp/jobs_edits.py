"""Jobs that edit a scene: live, so that it stays valid, or just as told."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import asdict
from typing import TYPE_CHECKING, Any, NamedTuple

from sceneweaver.io.messages import suggest
from sceneweaver.scene import CATALOGUE, InputError, Scene
from sceneweaver.scene.edits import edited_ids, edits_from_json

from .job import Job, report_of

if TYPE_CHECKING:
    from sceneweaver.editing import EditSession

MOST_SESSIONS = 4
"""Scenes that are kept compiled for their next edit."""


class Change(NamedTuple):
    """A scene after an edit, the ids of what was edited in it, and notes on words that were not known."""

    scene: Scene
    edited: Collection[str]
    notes: Collection[str] = ()


def edit(job: Job, *, scene: Scene, op: str, arguments: Mapping[str, Any]) -> dict[str, Any]:
    """One edit of a live session. What cannot be done is refused before the engine is loaded, which takes seconds."""
    change = CHANGES[op](scene, **arguments)
    session = _session(scene, job.device)
    try:
        result = session.update(change.scene, change.edited)
    except InputError:
        raise  # which left the session as it was
    except BaseException:
        _SESSIONS.remove(session)
        raise
    return {
        "scene": result.scene,
        "report": report_of(result.scene),
        "moves": [asdict(m) for m in result.moves],
        "notes": list(change.notes),
    }


_SESSIONS: list[EditSession] = []


def _session(scene: Scene, device: str) -> EditSession:
    """The session that has come to this scene, or a new one; the latest is kept last."""
    from sceneweaver.editing import EditSession

    kept = next((each for each in _SESSIONS if each.scene == scene), None)
    if kept is None:
        kept = EditSession(scene, device=device, ready=False)
    else:
        _SESSIONS.remove(kept)
    _SESSIONS[:] = [*_SESSIONS[-(MOST_SESSIONS - 1) :], kept]
    return kept


def exact(job: Job, *, scene: Scene, op: str, arguments: Mapping[str, Any]) -> dict[str, Any]:
    """One edit that is done as it stands: nothing makes way, and the scene may not be valid then."""
    after = CHANGES[op](scene, **arguments).scene
    return {"scene": after, "report": report_of(after), "moves": [], "notes": []}


def _add(scene: Scene, what: str, relations: Mapping[str, Any], **options: Any) -> Change:
    from sceneweaver.building import SceneBuilder
    from sceneweaver.building.relating import relation_type

    for name in relations:  # a builder takes other keywords as well
        if name != "frame":
            relation_type(name)
    builder = SceneBuilder.of(scene)
    added = builder.add(what, **options, **relations)
    return Change(builder.scene(), {added.id}, builder.notes)


def _relate(  # noqa: PLR0913 - as the tool has them
    scene: Scene,
    subject: str,
    kind: str,
    target: Any,
    hard: bool,
    params: Mapping[str, Any],
    frame: str | None = None,
) -> Change:
    from sceneweaver.building import SceneBuilder
    from sceneweaver.building.relating import relation_type

    scene.index(subject)
    known = CATALOGUE[relation_type(kind)].params
    params = {**params, "frame": frame} if frame is not None and "frame" in known else params
    for name in params:
        if name not in known:
            raise InputError(f"params: '{name}' is no number of {kind}{suggest(name, known)}")
    builder = SceneBuilder.of(scene)
    builder.relate(subject, kind, target, hard=hard, **params)
    return Change(builder.scene(), {subject})


def _edit(scene: Scene, edits: Any) -> Change:
    typed = edits_from_json(edits)
    after = scene.edit(*typed)
    return Change(after, edited_ids(typed).intersection(after.ids))


CHANGES: Mapping[str, Callable[..., Change]] = {
    "move": lambda scene, name, **options: Change(scene.move(name, **options), {name}),
    "resize": lambda scene, name, **options: Change(scene.resize(name, **options), {name}),
    "add": _add,
    "remove": lambda scene, name, cascade: Change(scene.remove(name, cascade=cascade), ()),
    "relate": _relate,
    "unrelate": lambda scene, subject, kind, target: Change(scene.unrelate(subject, kind, target), ()),
    "edit": _edit,
}
"""What may be done to a scene, by name."""
