"""Proofs that there is no layout: they hold for what they are made for and never for a room with a layout."""

from __future__ import annotations

import copy
import math

import pytest

from sceneweaver import problems
from sceneweaver.layout import refine
from sceneweaver.scene import InputError, Scene
from tests.sizes import share

KINDS = ("area", "wall_length", "clearance", "distance", "angle")


def claims(scene: Scene) -> list[dict]:
    """Everything that a certificate could claim about a scene."""
    hard = range(len(scene.relations))
    backs = [r.subject for r in scene.relations if r.type == "against_wall"]
    floor = [o for o in scene.objects if o.mount == "floor"]
    lists = [[o.id for o in floor], [o.id for o in floor if o.parts is None]]
    found: list[dict] = [
        {"kind": "area", "objects": ids, "z": [low, high]} for ids in lists for low, high in ((0.01, 0.2), (0.05, 0.35))
    ]
    found += [{"kind": "wall_length", "objects": backs, "depth": d / 100} for d in range(8, 60, 4)]
    found += [{"kind": "clearance", "relation": k} for k in hard]
    found += [{"kind": "distance", "near": [a], "far": b} for a in hard for b in hard]
    found += [{"kind": "angle", "relations": [a, b]} for a in hard for b in hard]
    found += [{"kind": "angle", "relations": [a, b, c]} for a in hard for b in hard for c in hard if len(hard) < 25]
    return found


@pytest.mark.parametrize(
    "name", share((n for n in problems.names(feasible=True) if int(n.split("/n")[1][:3]) <= 24), 3)
)
def test_no_certificate_holds_for_a_room_that_has_a_layout(name):
    case = problems.load(name)
    for scene in (case.scene, case.layout(case.witness)):
        for claim in claims(scene):
            with pytest.raises(InputError):
                problems.prove(scene, claim)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("seed", [21, 22, 23])
def test_every_kind_makes_proven_problems(kind, seed):
    case = problems.generate_infeasible(kind, 12, seed)
    problems.verify(case)
    assert case.witness is None and case.certificate["kind"] == kind and len(case.scene.objects) == 12


@pytest.mark.parametrize("name", [f"infeasible/{k}" for k in ("area-n010", "clearance-n008", "angle-n010")])
def test_a_search_finds_no_layout(name):
    solution = refine(problems.load(name).scene, candidates=16, device="cpu", time_limit=10)
    assert solution.status.all()


def boxes(count: int, side: float) -> Scene:
    """Squares in a room of 4 m by 4 m."""
    box = {"category": "box", "size": [side, side, 1.0], "pose": {}}
    room = {"type": "room", "outline": [[0, 0], [4, 0], [4, 4], [0, 4]], "doors": []}
    objects = [{**box, "id": f"b{k}"} for k in range(count)]
    return Scene.from_json({"schema": "sceneweaver.scene/1", "id": "s", "room": room, "objects": objects})


def test_area_knows_what_just_fits_and_what_just_does_not():
    claim = {"kind": "area", "objects": [f"b{k}" for k in range(16)], "z": [0.1, 0.9]}
    with pytest.raises(InputError, match="do fit"):
        problems.prove(boxes(16, 1.0), claim)  # sixteen squares of 1 m2 on 16 m2
    assert "are free" in problems.prove(boxes(16, 1.01), claim)


def against(count: int, width: float, side: float) -> Scene:
    scene = boxes(count, 1.0).to_json()
    for item in scene["objects"]:
        item["size"] = [0.5, width, 1.0]
    scene["room"]["outline"] = [[0, 0], [side, 0], [side, side], [0, side]]
    scene["relations"] = [{"type": "against_wall", "subject": o["id"], "hard": True} for o in scene["objects"]]
    return Scene.from_json(scene)


def test_wall_length_counts_the_walls_of_the_room():
    names = [f"b{k}" for k in range(16)]
    claim = {"kind": "wall_length", "objects": names, "depth": 0.3}
    with pytest.raises(InputError, match="do fit"):
        problems.prove(against(16, 1.0, 4.0), claim)
    assert "16.5" in problems.prove(against(16, 1.034, 4.0), claim)
    with pytest.raises(InputError, match="may miss"):
        problems.prove(against(16, 1.034, 4.0), {**claim, "depth": 0.48})
    with pytest.raises(InputError, match="each once"):
        problems.prove(against(16, 1.0, 4.0), {**claim, "objects": [*names, "b0"]})


def test_a_chain_is_as_long_as_its_gaps_and_what_is_between():
    scene = boxes(3, 1.0).to_json()
    most = 0.25 + 0.25 + math.sqrt(2.0)

    def asked(least: float) -> Scene:
        near = [
            {"type": "near", "subject": a, "target": b, "params": {"max": 0.25}}
            for a, b in (("b0", "b1"), ("b1", "b2"))
        ]
        far = {"type": "distance", "subject": "b2", "target": "b0", "params": {"min": least, "max": 9.0}}
        return Scene.from_json({**scene, "relations": [*near, far]})

    claim = {"kind": "distance", "near": [0, 1], "far": 2}
    assert "b0 - b1 - b2" in problems.prove(asked(most + 0.01), claim)
    with pytest.raises(InputError, match="does reach"):
        problems.prove(asked(most), claim)


def test_fronts_can_be_opposed_in_pairs_only():
    def ring(count: int) -> Scene:
        pairs = [(f"b{k}", f"b{(k + 1) % count}") for k in range(count)]
        relations = [{"type": "front_to_front", "subject": a, "target": b, "hard": True} for a, b in pairs]
        return Scene.from_json({**boxes(count, 0.5).to_json(), "relations": relations})

    assert "180.0 degrees off" in problems.prove(ring(3), {"kind": "angle", "relations": [0, 1, 2]})
    with pytest.raises(InputError, match="do add up"):
        problems.prove(ring(4), {"kind": "angle", "relations": [0, 1, 2, 3]})


@pytest.mark.parametrize("kind", KINDS)
def test_a_proof_with_something_missing_or_soft_is_refused(kind):
    case = problems.generate_infeasible(kind, 10, 3)
    for key in case.certificate:
        broken = {k: v for k, v in case.certificate.items() if k != key}
        with pytest.raises(InputError):
            problems.prove(case.scene, broken)
    data = copy.deepcopy(case.scene.to_json())
    for relation in data["relations"]:
        relation["hard"] = False
    if kind != "area":
        with pytest.raises(InputError):
            problems.prove(Scene.from_json(data), case.certificate)


@pytest.mark.parametrize("claim", [None, {}, {"kind": "magic"}, {"kind": "area", "objects": ["nobody"], "z": [0, 1]}])
def test_what_is_no_certificate_is_said_in_one_line(claim):
    with pytest.raises(InputError) as error:
        problems.prove(boxes(2, 1.0), claim)
    assert "\n" not in str(error.value)
