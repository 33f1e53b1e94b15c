"""Jobs on whole homes: each takes plain data and homes, and gives them back."""

from __future__ import annotations

import io
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sceneweaver.home import Home
from sceneweaver.io.messages import show, suggest
from sceneweaver.scene import InputError

from .job import Job, drawing_device

if TYPE_CHECKING:
    from sceneweaver.furnish import FurnishedRoom
    from sceneweaver.plans import Envelope, Programme

JUDGED, SEARCH = 0.1, 0.7
"""Shares of a call's time: what is kept for the judge after rooms are furnished, and what a search for plans gets."""

RECTANGLE = ("width", "depth", "closed", "entrance_wall", "storeys", "height")
"""What a rectangular envelope is given by."""

Basis = Mapping[str, Any]
"""What the plan of a home is judged by: ``programme`` as text or None, and ``profile``."""


def design_home(job: Job, *, prompt: str, out: str, profile: str | None, **options: Any) -> dict[str, Any]:
    """A home from a request in words, written into a folder."""
    from sceneweaver.furnish import design_home as make
    from sceneweaver.furnish.asked import Asked

    said: list[str] = []

    def tell(line: str) -> None:
        said.append(line)
        job.say(len(said), None, line)

    job.say(0, None, "the request is read")
    asked = Asked.of(prompt, None, None, profile) if prompt.strip() else None
    result = make(prompt, out=out, profile=profile, device=job.device, stop=job.stop, said=tell, **options)
    assert asked is not None  # an empty request has been refused
    return {
        "home": result.home,
        "report": {**result.report.to_dict(), "valid": result.valid, "plan": result.plan_report.to_dict()},
        "basis": {"programme": result.programme.dumps(), "profile": asked.profile},
        "review": result.to_dict(),
        "rooms": _rooms(result.rooms),
        "unmet": list(result.unmet),
        "undone": list(result.undone),
        "notes": list(result.notes),
        "files": list(result.files),
    }


def plan_home(  # noqa: PLR0913 - as the tool has them
    job: Job,
    *,
    prompt: str,
    programme: str | Mapping[str, Any] | None,
    envelope: Mapping[str, Any] | None,
    profile: str | None,
    plans: int,
    count: int,
    seed: int,
) -> dict[str, Any]:
    """The best plans for a request or a programme."""
    from sceneweaver.furnish import propose_plans

    found = propose_plans(
        prompt,
        programme=_programme(programme),
        envelope=_envelope(envelope),
        profile=profile,
        seed=seed,
        plans=plans,
        count=count,
        device=job.device,
        time_limit=SEARCH * job.seconds,
    )
    basis = {"programme": found.programme.dumps(), "profile": found.profile}
    rows = [
        {
            "home": plan.home,
            "report": _judged(plan.home, basis),
            "cost": round(plan.report.cost, 4),
            "soft": list(dict.fromkeys(violation.rule for violation in plan.report.soft)),
        }
        for plan in found.plans
    ]
    valid = found.plans[0].valid
    return {"plans": rows, "basis": basis, "found": valid, "notes": list(found.notes)}


def furnish_home(
    job: Job,
    *,
    home: Home,
    basis: Basis | None,
    requests: Mapping[str, str] | None,
    seed: int | None,
    time_limit: float,
    **options: Any,
) -> dict[str, Any]:
    """The home with some of its rooms furnished, or all."""
    from sceneweaver.furnish import refurnish

    done: list[str] = []

    def said(room: FurnishedRoom) -> None:
        done.append(room.room_id)
        job.say(len(done), None, f"{room.room_id} is furnished" if room.scene is not None else f"{room.room_id} failed")

    job.say(0, None, "the rooms are furnished")
    made = refurnish(
        home,
        requests,
        seed=seed,
        device="cpu" if job.device == "auto" else job.device,
        time_limit=(1.0 - JUDGED) * time_limit,
        said=said,
        stop=job.stop,
        **options,
    )
    notes = [f"stopped by the time limit: {made.cut_off}"] if made.cut_off else []
    return {"home": made.home, "report": _judged(made.home, basis), "rooms": _rooms(made.rooms), "notes": notes}


def check_home(job: Job, *, home: Home, basis: Basis | None, **options: Any) -> dict[str, Any]:
    """The judge's report on a home, with that on its plan where it is known what that has to keep."""
    return _judged(home, basis, **options)


def render_home(
    job: Job, *, home: Home, views: Sequence[str], width: int, height: int
) -> list[tuple[str, str, int, int, bytes]]:
    """Pictures of a home as PNG: (view, what it shows, width, height, data)."""
    from sceneweaver.render.home import home_pictures, home_view, home_views, plan_picture

    captions, drawn = home_views(home), []
    names = list(dict.fromkeys(home_view(home, view) for view in views))
    for k, name in enumerate(names):
        job.say(k, len(names), f"drawing {name}")
        if name.startswith("plan_"):
            picture = plan_picture(home, name.removeprefix("plan_"), width=width)
        else:
            _, picture = next(home_pictures(home, None, [name], width, height, device=drawing_device(job.device)))
        content = io.BytesIO()
        picture.save(content, format="PNG", optimize=True)
        drawn.append((name, captions[name], *picture.size, content.getvalue()))
    return drawn


def export_home(
    job: Job, *, home: Home, report: Mapping[str, Any], folder: str, formats: Sequence[str], textures: bool
) -> dict[str, str]:
    """Files of a home for other tools, in a folder; the file of each format. ``report`` is the judge's."""
    from sceneweaver.io import write_atomic

    done = {}
    if "home" in formats:
        home.save(Path(folder, "home.json"))
        done["home"] = "home.json"
    if "plan" in formats:
        from sceneweaver.render.home import draw_plan

        for storey in (s.id for s in home.storeys if home.rooms_of(s.id)):
            name = f"plan_{storey}"
            write_atomic(Path(folder, f"{name}.svg"), draw_plan(home, storey))
            done[name] = f"{name}.svg"
    if "report" in formats:
        from sceneweaver.render.home import report_parts
        from sceneweaver.report.home import HomePage, write_home_report

        write_home_report(Path(folder, "report.html"), HomePage(home, report, **report_parts(home)))
        done["report"] = "report.html"
    others = [name for name in formats if name not in ("home", "plan", "report")]
    if others:
        from sceneweaver.export import export_home as write

        files = write(home, folder, others, textures=textures)
        done |= {name: path.relative_to(folder).as_posix() for name, path in files.items()}
    return done


def _judged(home: Home, basis: Basis | None, **options: Any) -> dict[str, Any]:
    from sceneweaver.plans import Programme, check_plan
    from sceneweaver.verify.home import check_home as judge

    plan = None
    if basis is not None:
        programme = Programme.loads(basis["programme"]) if basis["programme"] is not None else None
        plan = check_plan(home, programme, basis["profile"])
    return judge(home, plan, **options).to_dict()


def _rooms(rooms: Mapping[str, FurnishedRoom]) -> dict[str, dict[str, Any]]:
    """What became of rooms, as data."""
    return {
        name: {
            "request": room.request,
            "grade": round(room.review.total, 2) if room.review is not None else None,
            "unmet": [*room.unmet, *(f"it has no {what}" for what in room.lacking)],
            "failed": room.failed,
        }
        for name, room in rooms.items()
    }


def _programme(given: str | Mapping[str, Any] | None) -> Programme | None:
    """A programme by the name of an example, or from data."""
    from sceneweaver.plans import Programme

    if given is None:
        return None
    return Programme.example(given) if isinstance(given, str) else Programme.model_validate(dict(given))


def _envelope(given: Mapping[str, Any] | None) -> Envelope | None:
    """An envelope: a rectangle by its sides, or an outline."""
    from sceneweaver.plans import Envelope

    if given is None or "outline" in given:
        return None if given is None else Envelope.model_validate(dict(given))
    for name in given:
        if name not in RECTANGLE:
            raise InputError(f"envelope: '{name}' is no part of it{suggest(name, (*RECTANGLE, 'outline'))}")
    if not {"width", "depth"} <= given.keys():
        raise InputError("envelope: give width and depth [m] of a rectangle, or an outline with open_walls")
    closed = given.get("closed", ())
    if not isinstance(closed, list | tuple) or any(not isinstance(wall, int) for wall in closed):
        raise InputError(f"envelope: closed is {show(closed)}; give numbers of walls in a list")
    return Envelope.rectangle(**given)


JOBS = {each.__name__: each for each in (design_home, plan_home, furnish_home, check_home, render_home, export_home)}
"""All jobs on homes by name."""

LONG_RUNNERS = ("design_home", "furnish_home")
"""Jobs that watch their time and their stop themselves, and end in good order."""
