"""Small things that have a place in the room and nothing to stand on."""

from __future__ import annotations

import pytest

from sceneweaver.generate.stands import with_stands
from sceneweaver.knowledge import room_types
from sceneweaver.language import SceneGraph, read_request


def stood(text: str, kind: str) -> SceneGraph:
    return with_stands(read_request(text), room_types()[kind])


@pytest.mark.parametrize(
    ("text", "kind", "thing"),
    [
        ("a bedroom with a sewing machine under the window", "bedroom", "sewing_machine"),
        ("a study with a typewriter in the corner", "study", "typewriter"),
        ("a bedroom with a printer beside the bed", "bedroom", "desk_printer"),
    ],
)
def test_what_has_a_place_gets_something_to_stand_on_there(text: str, kind: str, thing: str) -> None:
    graph = stood(text, kind)
    (carrier,) = [r.targets[0] for r in graph.relations if r.subject == thing and r.type == "on"]
    entity = graph.entity(carrier)
    assert entity is not None and entity.implied
    (said,) = [r for r in read_request(text).relations if r.subject == thing]
    assert [(r.type, r.targets) for r in graph.relations if r.subject == carrier] == [(said.type, said.targets)]


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("a bedroom with a lamp beside the bed", "bedroom"),  # on the nightstand
        ("a study with a desk and a typewriter by the window", "study"),  # on the desk
        ("a study with a typewriter on a table by the window", "study"),
        ("a bedroom with a wardrobe in the corner", "bedroom"),
        ("a living room with a television on the wall", "living_room"),
    ],
)
def test_what_can_do_without_gets_nothing(text: str, kind: str) -> None:
    graph = read_request(text)
    assert with_stands(graph, room_types()[kind]) == graph
