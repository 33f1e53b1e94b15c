"""Begin with what a model of scenes answers, or with a scene of another system."""

from __future__ import annotations

from collections import Counter

from sceneweaver.generate.shell import floor_area, shell
from sceneweaver.generate.taken import taken
from sceneweaver.scene import InputError, Room

from .answers import scene_of
from .base import Context, Proposal
from .card import checked
from .scene_model import SECONDS, SceneRequest, asked


class InitModel:
    """Asks the model that the design was given, and takes its scene as it is."""

    name = "init_model"

    def propose(self, context: Context) -> Proposal:
        """A whole scene; InputError without a model, or where it gives none in time that can be used."""
        inputs = checked(self.name, context.inputs)
        given = context.beginning
        if given.model is None:
            raise InputError(f"tool {self.name} needs a model of scenes, and there is none; use init_prior")
        try:
            request = request_of(context)
            answer = asked(given.model, request, float(inputs.get("seconds", SECONDS)), given.left)
            made = scene_of(answer, given.name, request.room)
            scene, notes, unmet = taken(context, made.scene, self.name, given.name)
        except InputError as error:
            raise InputError(f"tool {self.name}: {given.name}: {error}") from error
        said = f"begun with a scene of {given.name}, {len(made.scene.objects)} objects"
        return Proposal(scene=scene, notes=(said, *made.notes, *notes), unmet=tuple(unmet), origin=made.scene)


def request_of(context: Context) -> SceneRequest:
    """What the model is asked: a room only where the request fixes its floor."""
    brief, named = context.brief, Counter[str]()
    for one in brief.entities:
        named[one.category] += max(1, one.count[0] if one.count else 1)
    return SceneRequest(
        text=brief.text,
        kind=context.room_type.name,
        room=_fixed_room(context),
        categories=dict(named),
        seed=context.seed,
    )


def _fixed_room(context: Context) -> Room | None:
    area, _, fixed, _ = floor_area(context.room_type, context.brief, context.seed)
    return shell(context.room_type, context.brief, area, context.seed)[0] if fixed else None
