"""Jobs that edit a scene: live, so that it stays valid, or just as told."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from sceneweaver.io.messages import suggest
from sceneweaver.scene import CATALOGUE, InputError, Scene
from sceneweaver.scene.edits import edits_from_json

from .job import Job, report_of

if TYPE_CHECKING:
    from sceneweaver.editing import EditSession

MOST_SESSIONS = 4
"""Scenes that are kept compiled for their next edit."""


def edit(job: Job, *, scene: Scene, op: str, arguments: Mapping[str, Any]) -> dict[str, Any]:
    """One edit of a live session. An object that is not there is refused before the engine is loaded."""
    for key in ("name", "subject"):
        if key in arguments:
            scene.index(arguments[key])
    session = _session(scene, job.device)
    try:
        result = EDITS[op](session, **arguments)
    except InputError:
        raise  # which left the session as it was
    except BaseException:
        _SESSIONS.remove(session)
        raise
    return {
        "scene": result.scene,
        "report": report_of(result.scene),
        "moves": [asdict(m) for m in result.moves],
        "notes": _notes(op, arguments),
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


def _add(session: EditSession, what: str, relations: Mapping[str, Any], **options: Any) -> Any:
    from sceneweaver.building.relating import relation_type

    for name in relations:
        if name != "frame":
            relation_type(name)
    return session.add(what, **options, **relations)


def _relate(  # noqa: PLR0913 - as the tool has them
    session: EditSession,
    subject: str,
    kind: str,
    target: Any,
    hard: bool,
    params: Mapping[str, Any],
    frame: str | None = None,
) -> Any:
    from sceneweaver.building.relating import relation_type, require_frame

    known = CATALOGUE[relation_type(kind)].params
    params = {**params, "frame": frame} if frame is not None and "frame" in known else params
    require_frame(relation_type(kind), params)
    for name in params:
        if name not in known:
            raise InputError(f"params: '{name}' is no number of {kind}{suggest(name, known)}")
    return session.relate(subject, kind, target, hard=hard, **params)


EDITS: Mapping[str, Callable[..., Any]] = {
    "move": lambda session, name, **options: session.move(name, **options),
    "resize": lambda session, name, **options: session.resize(name, **options),
    "add": _add,
    "remove": lambda session, name, cascade: session.remove(name, cascade=cascade),
    "relate": _relate,
    "unrelate": lambda session, subject, kind, target: session.unrelate(subject, kind, target),
    "edit": lambda session, edits: session.edit(*edits_from_json(edits)),
}
"""What may be done to a session, by name."""


def exact(job: Job, *, scene: Scene, op: str, arguments: Mapping[str, Any]) -> dict[str, Any]:
    """One edit that is done as it stands: nothing makes way, and the scene may not be valid then."""
    plain: Mapping[str, Callable[..., Scene]] = {
        "move": lambda name, **options: scene.move(name, **options),
        "resize": lambda name, **options: scene.resize(name, **options),
        "edit": lambda edits: scene.edit(*edits_from_json(edits)),
    }
    after = plain[op](**arguments)
    return {"scene": after, "report": report_of(after), "moves": [], "notes": []}


def _notes(op: str, arguments: Mapping[str, Any]) -> list[str]:
    if op != "add":
        return []
    from sceneweaver.assets import resolve

    note = resolve(arguments["what"]).note
    return [note] if note else []
