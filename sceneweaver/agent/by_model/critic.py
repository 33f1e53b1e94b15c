"""The critic by vision: a model looks at pictures and data of a scene, grades it, and says what is wrong where.

It stands beside the symbolic critic and decides no validity. All that it says is checked: grades are in range, objects
exist, tools are known. Several answers are averaged, and how far they are apart is told.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from sceneweaver.assets import Library
from sceneweaver.critic import VisualFault, VisualReview
from sceneweaver.io.messages import clean, printable_line, shorten
from sceneweaver.knowledge import RoomType
from sceneweaver.language import SceneGraph
from sceneweaver.llm import ModelClient, ModelError, ModelFailed, Picture
from sceneweaver.runtime.deadline import NEVER, Deadline
from sceneweaver.scene import Scene
from sceneweaver.tools.registry import tools
from sceneweaver.verify import Report

from .look_reply import MOST_FAULTS, Look, Names, checker, tool_of
from .pictures import room_pictures
from .scene_text import compact, judge_facts, prompt, scene_text

PURPOSE = "look"
CRITERIA = ("realism", "functionality", "layout", "completion")
REQUEST, COMMENT, SENTENCE = 2000, 600, 300
"""Characters of the request that are told, and of comments and sentences of faults that are kept."""

RETRIES = 1
"""Times that an answer is refused before one with names that mean nothing is asked for anew, and taken without them."""

BLIND = "There are no pictures of this room: judge by the data alone, and say nothing of colours and looks."


def look(
    client: ModelClient,
    scene: Scene,
    report: Report,
    brief: SceneGraph,
    room_type: RoomType,
    library: Library,
    *,
    samples: int = 1,
    device: str = "cpu",
    pictures: Sequence[Picture] | None = None,
    deadline: Deadline = NEVER,
) -> VisualReview:
    """What a vision model says about a scene.

    Args:
        client: asks the model.
        scene: what is looked at.
        report: what the judge measured in it.
        brief: the request, for what is asked and for whom.
        room_type: what such a room has.
        library: where its furniture comes from.
        samples: answers that are asked for, side by side.
        device: where pictures are drawn.
        pictures: what the model is shown; None: drawn here, where it takes any.
        deadline: when no further picture is begun.

    Raises:
        ModelError: when not one answer can be used; that of the first.
    """
    if not client.pictures:
        pictures = ()
    elif pictures is None and (pictures := client.shown(PURPOSE)) is None:
        pictures = room_pictures(scene, library.load, device=device, deadline=deadline)
    names = Names(scene)
    known = tools()
    instructions = "\n\n".join([prompt("critic"), prompt("scene"), f"Tools:\n{_purposes()}"])
    content = [_told(scene, report, brief, room_type), *(pictures or (BLIND,))]
    asked = (PURPOSE, Look, instructions, content)
    found = client.ask_many(*asked, samples=samples, check=checker(names), retries=RETRIES)
    if not client.lost and (again := [k for k, answer in enumerate(found) if isinstance(answer, ModelFailed)]):
        more = client.ask_many(*asked, samples=len(again), retries=RETRIES)  # names that mean nothing are left out
        for k, answer in zip(again, more, strict=True):
            found[k] = answer
    looks = [answer for answer in found if isinstance(answer, Look)]
    errors = [answer for answer in found if isinstance(answer, ModelError)]
    if not looks:
        raise errors[0] if errors else ModelFailed(f"{PURPOSE}: no answer was asked for")
    return VisualReview(
        model=client.name,
        samples=len(looks),
        failed=tuple(shorten(clean(str(error)), SENTENCE) for error in errors),
        pictures=tuple(picture.title for picture in pictures),
        faults=_merged(looks, names, [*known]),
        **_averaged(looks),
    )


def _told(scene: Scene, report: Report, brief: SceneGraph, room_type: RoomType) -> str:
    """Request, kind of room, what was measured, and the scene, as JSON under headings."""
    usual = [item.id for item in room_type.items if item.need != "optional"]
    asked = {"text": shorten(brief.text, REQUEST), "kind_of_room": room_type.name, "such_a_room_has": usual}
    if brief.for_whom:
        asked["for"] = [shorten(who, SENTENCE) for who in brief.for_whom]
    parts = [f"Request: {compact(asked)}", f"Measured: {compact({'judge': judge_facts(report)})}"]
    return "\n\n".join((*parts, f"Scene: {scene_text(scene)}"))


def _purposes() -> str:
    """Tools that mend a scene, a line each."""
    cards = [tool.card for tool in tools().values() if tool.card.role != "initializer"]
    return "\n".join(f"- {card.name}: {' '.join(card.description.split())}" for card in cards)


def _averaged(looks: Sequence[Look]) -> dict[str, Any]:
    """Mean, standard deviation and range of the grades, and the comments, by criterion."""
    found: dict[str, dict[str, Any]] = {"grades": {}, "deviation": {}, "ranges": {}, "comments": {}}
    for criterion in CRITERIA:
        said = [one.graded(criterion) for one in looks]
        grades = [one.grade for one in said]
        mean = math.fsum(grades) / len(grades)
        found["grades"][criterion] = mean
        found["deviation"][criterion] = math.sqrt(math.fsum((g - mean) ** 2 for g in grades) / len(grades))
        found["ranges"][criterion] = (min(grades), max(grades))
        found["comments"][criterion] = tuple(printable_line(one.comment, COMMENT) for one in said)
    return found


def _merged(looks: Sequence[Look], names: Names, known: Sequence[str]) -> tuple[VisualFault, ...]:
    """The faults of all answers. Those of one criterion on the same objects are one, told in the first one's words;
    those of the whole room are, where they say the same."""
    seen: dict[tuple[Any, ...], list[VisualFault]] = {}
    for one in looks:
        times: dict[tuple[Any, ...], int] = {}
        for said in one.faults[:MOST_FAULTS]:
            objects, wrong = names.known(said.objects), printable_line(said.wrong, SENTENCE)
            if not wrong:
                continue
            key = (said.criterion, *(sorted(objects) or [wrong.casefold()]))
            times[key] = times.get(key, 0) + 1  # a second fault of one answer on the same objects is another one
            fault = VisualFault(
                criterion=said.criterion,
                kind="seen",
                objects=objects,
                reason=wrong,
                suggestion=printable_line(said.suggestion, SENTENCE),
                tool=tool_of(said.tool, known),
                severity=math.floor(said.severity + 0.5),
                share=1 / len(looks),
            )
            seen.setdefault((times[key], *key), []).append(fault)
    found = [_one(faults, len(looks)) for faults in seen.values()]
    return tuple(sorted(found, key=lambda fault: -fault.points))  # equal ones in the order in which they were said


def _one(faults: Sequence[VisualFault], samples: int) -> VisualFault:
    severity, share = math.fsum(f.severity for f in faults) / len(faults), len(faults) / samples
    update = {
        "severity": severity,
        "share": share,
        "points": severity * share,
        "suggestion": next((f.suggestion for f in faults if f.suggestion), ""),
        "tool": next((f.tool for f in faults if f.tool), None),
    }
    return faults[0].model_copy(update=update)
