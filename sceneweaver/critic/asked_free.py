"""What became of the floor that a request wants free: measured from where things stand, whoever placed them."""

from __future__ import annotations

from collections.abc import Iterator

from sceneweaver.language.free_floor import scene_area
from sceneweaver.verify.free_floor import measure

from .survey import Survey
from .verdict import Asked, met, not_understood, text_of, unmet


def outcomes(survey: Survey) -> Iterator[Asked]:
    """Each free area that the request states.

    A rectangle or circle that the scene keeps free is measured at its place; one that it does not keep, or that is not
    free there, anywhere in the room where the request names no place.
    """
    scene = survey.scene
    kept = {area.request: area for area in scene.free_areas if area.request is not None}
    for asked in survey.brief.free_areas:
        area = scene_area(asked, survey.ids_of, scene.room)
        if area is None:
            yield not_understood("free_area", asked.id, (), f"'{asked.words}' names nothing that is there")
            continue
        placed = kept.get(asked.id)
        found = measure(survey.placed, placed if placed is not None else area, anywhere=placed is None)
        if not found.holds and placed is not None and not area.targets and area.kind in ("rectangle", "circle"):
            found = measure(survey.placed, area, anywhere=True)
        objects = tuple(name for name in (*area.targets, *area.others) if name in survey.placed.by_id)
        m = found.measurement
        if m is None:
            yield not_understood("free_area", asked.id, objects, f"'{asked.words}' was not measured")
        elif found.holds:
            yield met("free_area", asked.id, objects, f"{text_of(m)}", m)
        else:
            wrong = tuple(name for name in found.objects if name in survey.placed.by_id)
            by = f" because of {', '.join(wrong[:4])}" if wrong else ""
            yield unmet(
                "free_area",
                asked.id,
                objects,
                f"{text_of(m)}{by}",
                m,
                fault="asked_free_floor",
                wrong=wrong or objects,
                share=m.excess / max(m.low, 1e-6),
                suggestion=f"keep free: {asked.words}",
            )
