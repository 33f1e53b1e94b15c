"""A small furnished room for the tests of the report."""

from __future__ import annotations

from functools import cache
from typing import Any

from PIL import Image

from sceneweaver.assets import Asset, make
from sceneweaver.critic import ItemOutcome, Phrase, Review, VisualFault, VisualReview
from sceneweaver.critic.model import Fault, ItemKind, Status
from sceneweaver.language import Span
from sceneweaver.report import ReportData, StepRow
from sceneweaver.scene import Door, Dropped, Pose, Relation, Room, Scene, Support, Window

HOSTILE = "</script><script>alert(1)</script><img src=x onerror=alert(2)>'\"&"


@cache
def asset(name: str, seed: int = 1) -> Asset:
    """An asset, drawn once."""
    return make(name, seed)


def furnished(prompt: str = "A small study") -> Scene:
    """A study in which nothing hides the armchair in the middle."""
    desk = asset("desk")
    objects = (
        desk.object("desk-0", pose=Pose.from_yaw(0.5, 2.0, 0.0, 0.0)),
        asset("mug").object(
            "mug-0",
            pose=Pose.from_yaw(0.5, 2.0, desk.surfaces[0].z, 0.4),
            support=Support(object="desk-0", surface=desk.surfaces[0].name),
        ),
        asset("armchair").object("armchair-0", pose=Pose.from_yaw(2.2, 2.0, 0.0, -1.57)),
        asset("picture").object("picture-0", pose=Pose.from_yaw(0.02, 3.2, 1.4, 0.0)),
        asset("table_lamp").object("lamp-0", pose=Pose.from_yaw(3.5, 3.5, 0, 0), mount="floor"),
        asset("table_lamp").object("lamp-1", pose=Pose.from_yaw(3.5, 0.5, 0, 0), mount="floor"),
    )
    room = Room(
        type="study",
        outline=((0, 0), (4, 0), (4, 4), (0, 4)),
        doors=(Door(id="door-0", wall=1, offset=1.0, width=0.9, height=2.0),),
        windows=(Window(id="window-0", wall=2, offset=1.0, width=1.6, sill=0.9, height=1.2),),
    )
    relations = (
        Relation(type="against_wall", subject="desk-0"),
        Relation(type="near", subject="armchair-0", target="desk-0", params={"max": 0.5}),
        Relation(type="facing", subject="armchair-0", target="desk-0", hard=False),
    )
    return Scene(id="study", prompt=prompt, room=room, objects=objects, relations=relations)


def load(object_id: str) -> Asset:
    """The loader of the room's assets."""
    found = {a.id: a for a in (asset(n) for n in ("desk", "mug", "armchair", "picture", "table_lamp"))}
    return found[object_id]


def asked(text: str) -> tuple[str, tuple[Phrase, ...]]:
    """A request and what became of it: one phrase of each status, some over others, one that stands nowhere."""
    request = f"A desk with a red mug, two lamps near the armchair and {text}."

    def phrase(words: str, kind: ItemKind, status: Status, objects: tuple[str, ...] = (), **more: Any) -> Phrase:
        start = request.find(words)
        span = Span(start, start + len(words)) if start >= 0 else None
        outcome = ItemOutcome(item=words, kind=kind, status=status, objects=objects, **{"reason": text, **more})
        return Phrase(words, span, outcome)

    far = {"quantity": "gap", "measured": 1.82, "allowed": (0.0, 1.5), "unit": "m"}
    return request, (
        phrase("A desk", "entity", "met", ("desk-0",)),
        phrase("a red mug", "entity", "met", ("mug-0",)),
        phrase("red", "attribute", "unmet", ("mug-0",), reason="mug-0 is white"),
        phrase("two lamps", "entity", "assumed", ("lamp-0", "lamp-1")),
        phrase("two lamps near the armchair", "relation", "unmet", ("lamp-0", "lamp-1", "armchair-0"), **far),
        phrase(text, "unread", "not_understood"),
        phrase("window in the room", "room", "met", ("nobody",)),
    )


def seen(text: str) -> VisualReview:
    """What a model says, from two answers that are not of one mind."""

    def fault(objects: tuple[str, ...], severity: float, share: float) -> VisualFault:
        about: dict[str, Any] = {"criterion": "layout", "kind": "seen", "reason": text, "suggestion": text}
        return VisualFault(objects=objects, severity=severity, share=share, points=severity * share, **about)

    return VisualReview(
        model=text,
        samples=2,
        failed=(text,),
        pictures=("top view",),
        grades={"realism": 6.5, "layout": 3.0},
        deviation={"realism": 0.5, "layout": 0.0},
        ranges={"realism": (6.0, 7.0), "layout": (3.0, 3.0)},
        comments={"realism": (text, "more words"), "layout": (text,)},
        faults=(fault(("armchair-0", "nobody"), 3.0, 1.0), fault((), 1.0, 0.5)),
    )


def full(text: str = "words") -> ReportData:
    """A report with something in every section; ``text`` stands wherever free text can."""
    from sceneweaver.verify import check

    scene = furnished(text).model_copy(update={"dropped": (Dropped(id="x", category="sofa", reason=text),)})
    metrics: dict[str, Any] = check(scene).to_dict()
    picture = Image.effect_noise((320, 200), 40).convert("RGB")
    review = Review(
        grades={"realism": 8.0, "layout": 4.0},
        faults=(Fault(criterion="layout", kind="empty_area", reason=text, suggestion=text),),
        seen=seen(text),
    )
    steps = (
        StepRow(1, "init_prior", text, True, 2.5, {"realism": 6.0}, text, picture),
        StepRow(2, text, "add books", False, 1.0, {"realism": 5.0}, "", None),
        StepRow(3, "update_layout", "again", True, 1.0, {"realism": 8.0}),
    )
    return ReportData(
        scene,
        metrics,
        review,
        {"top": picture, "top_annotated": picture, "corner": picture, text: picture},
        steps,
        (text,),
        (text,),
        (text,),
        load,
        text,
        *asked(text),
    )
