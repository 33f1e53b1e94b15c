"""Beginning with a model's scene: what it is asked, what it may answer, and all that it may do wrong."""

from __future__ import annotations

import math
import sys
import time

import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver.importers import SourceObject, SourceRoom
from sceneweaver.knowledge import room_type
from sceneweaver.language import Entity, SceneGraph
from sceneweaver.scene import InputError, Scene
from sceneweaver.tools.answers import MOST_OBJECTS, scene_of
from sceneweaver.tools.base import Context
from sceneweaver.tools.beginning import Beginning
from sceneweaver.tools.found_models import name_of, scene_model
from sceneweaver.tools.init_model import InitModel
from sceneweaver.tools.scene_model import SceneModel, SceneRequest, asked

SHELL = {"outline": [[0, 0], [5, 0], [5, 3], [3, 3], [3, 4], [0, 4]], "height": 2.6}
BED = {"label": "double_bed", "size": [2.1, 1.7, 0.5], "position": [1.4, 1.3, 0.25], "yaw": 0.3}
LAMP = {"label": "floor lamp", "size": [0.4, 0.4, 1.6], "position": [4.2, 0.6, 0.8], "yaw": -1.2}
PLAIN = {"room": SHELL, "objects": [BED, LAMP]}


class Says:
    """A model with one answer, or one mistake."""

    def __init__(self, answer=None, error=None):
        self.answer, self.error, self.requests = answer, error, []

    def generate(self, request):
        self.requests.append(request)
        if self.error is not None:
            raise self.error
        return self.answer


class Hangs:
    """A model that never answers."""

    def generate(self, request):
        while True:
            time.sleep(0.01)


@pytest.fixture
def begun(library):
    """What the tool proposes for a model."""

    def run(model, brief=None, inputs=None, left=lambda: math.inf):
        brief = brief or SceneGraph(text="a bedroom")
        beginning = Beginning(model=model, name="theirs", left=left)
        scene = Scene.example("bedroom")
        context = Context(brief, room_type("bedroom"), scene, library, 3, inputs=inputs or {}, beginning=beginning)
        return InitModel().propose(context)

    return run


def test_plain_data_stand_where_they_say(begun):
    proposal = begun(Says(PLAIN))
    scene = proposal.scene
    assert scene is not None and not proposal.fresh
    assert [o.category for o in scene.objects] == ["bed", "floor_lamp"] and scene.room.type == "bedroom"
    for obj, row in zip(scene.objects, PLAIN["objects"], strict=True):
        x, y, z = row["position"]
        assert obj.size == tuple(row["size"])
        assert obj.pose.position == pytest.approx((x, y, z - row["size"][2] / 2), abs=1e-9)
        assert obj.pose.yaw == pytest.approx(row["yaw"], abs=1e-9)
    assert proposal.origin is not None and proposal.origin.ids == scene.ids
    assert Scene.loads(scene.dumps()) == scene


def test_a_room_without_openings_gets_some_where_nothing_is_in_the_way(begun):
    proposal = begun(Says(PLAIN))
    assert not proposal.origin.room.doors and len(proposal.scene.room.doors) == 1
    assert any("came without openings" in note for note in proposal.notes)
    assert sw.check(proposal.scene).blocked_openings == 0
    open_room = sw.Room.rectangle(5, 4, kind="bedroom").with_door("south", at=0.2)
    mine = proposal.origin.model_copy(update={"room": open_room})
    assert begun(Says(mine)).scene.room.doors == open_room.doors


def test_scenes_and_rooms_of_readers_are_answers_too(begun):
    whole = Scene.example("bedroom")
    assert begun(Says(whole)).scene.object("bed").pose == whole.object("bed").pose
    bed = SourceObject(name="b", label="bed", position=(2.0, 1.5, 0.3), size=(2.0, 1.6, 0.6))
    room = SourceRoom(name="r", type="bedroom", outline=((0, 0), (4, 0), (4, 3), (0, 3)), objects=(bed,))
    assert begun(Says(room)).scene.ids == ("b",)
    arrays = {**PLAIN, "objects": [{**BED, "position": np.array(BED["position"]), "yaw": np.float32(0.5)}]}
    assert begun(Says(arrays)).scene.objects[0].pose.yaw == pytest.approx(0.5, abs=1e-6)


def test_what_a_model_is_asked(begun):
    model = Says(PLAIN)
    entities = (
        Entity(id="a", noun="bed", category="double_bed"),
        Entity(id="b", noun="lamps", category="table_lamp", count=(2, 2)),
        Entity(id="c", noun="lamp", category="table_lamp"),
    )
    begun(model, SceneGraph(text="a bedroom", entities=entities))
    begun(model, SceneGraph(text="a bedroom", size=(4.0, 3.5)))
    free, fixed = model.requests
    assert (free.text, free.kind, free.seed, free.room) == ("a bedroom", "bedroom", 3, None)
    assert free.categories == {"double_bed": 1, "table_lamp": 3}
    assert sorted(max(axis) - min(axis) for axis in zip(*fixed.room.outline, strict=True)) == [3.5, 4.0]


def test_data_without_a_room_furnish_the_one_that_was_asked_for():
    room = sw.Room.rectangle(4.0, 3.0, height=2.5)
    scene = scene_of({"objects": [BED]}, "m", room).scene
    assert scene.room.outline == room.outline and scene.room.height == 2.5


def test_what_is_asked_for_is_known_in_the_scene(begun):
    asked_for = (
        Entity(id="bed", noun="bed", category="bed"),
        Entity(id="desk", noun="desk", category="desk"),
    )
    scene = begun(Says(PLAIN), SceneGraph(text="x", entities=asked_for)).scene
    assert {o.intent.request: o.category for o in scene.objects} == {"bed": "bed", None: "floor_lamp"}


NONSENSE = [
    (None, "it has no scene for this request"),
    ("a bedroom", 'its answer is "a bedroom"; give a Scene'),
    (7, "its answer is 7"),
    ({}, "objects is null"),
    ({"objects": {}}, "objects is"),
    ({"objects": []}, "its scene holds no object"),
    ({**PLAIN, "objects": [BED] * 10_000}, f"its scene has 10000 objects; at most {MOST_OBJECTS} are taken"),
    ({**PLAIN, "objects": [7]}, r"objects\[0\] is 7"),
    ({**PLAIN, "objects": [{**BED, "label": " "}]}, r"objects\[0\].label is"),
    ({**PLAIN, "objects": [{**BED, "size": [1, 2]}]}, r"objects\[0\].size is .* give 3 numbers"),
    ({**PLAIN, "objects": [{**BED, "size": [1, -2, 1]}]}, r"objects\[0\].size\[1\] is -2.0"),
    ({**PLAIN, "objects": [{**BED, "position": [1, math.nan, 1]}]}, r"objects\[0\].position\[1\] is NaN"),
    ({**PLAIN, "objects": [{**BED, "position": [1, 1e9, 1]}]}, r"objects\[0\].position\[1\] is 1"),
    ({**PLAIN, "objects": [{**BED, "yaw": math.inf}]}, r"objects\[0\].yaw is"),
    ({**PLAIN, "objects": [{**BED, "yaw": "left"}]}, r"objects\[0\].yaw is"),
    ({**PLAIN, "objects": [{**BED, "position": None}]}, r"objects\[0\].position is null"),
    ({**PLAIN, "room": 5}, "room is 5"),
    ({**PLAIN, "room": {"outline": [[0, 0]]}}, "room.outline is"),
    ({**PLAIN, "room": {**SHELL, "height": math.nan}}, "room.height is NaN"),
    (Scene(id="bare", room=sw.Room.rectangle(3, 3)), "its scene holds no object"),
]


@pytest.mark.parametrize(("answer", "line"), NONSENSE, ids=[str(k) for k in range(len(NONSENSE))])
def test_nonsense_is_one_line(begun, answer, line):
    with pytest.raises(InputError, match=f"tool init_model: theirs: .*{line}") as caught:
        begun(Says(answer))
    assert "\n" not in str(caught.value) and len(str(caught.value)) < 500


@pytest.mark.parametrize(
    ("error", "line"),
    [
        (ValueError("no\nweights"), "it failed: ValueError: no weights"),
        (InputError("no such room"), "no such room"),
        (SystemExit(3), "it failed: SystemExit"),
        (MemoryError(), "it failed: MemoryError"),
    ],
)
def test_a_model_that_raises_is_one_line(begun, error, line):
    with pytest.raises(InputError, match=f"tool init_model: theirs: {line}") as caught:
        begun(Says(error=error))
    assert "\n" not in str(caught.value)


def test_a_model_that_hangs_is_left_alone(begun):
    with pytest.raises(InputError, match="gave no answer within 0.2"):
        begun(Hangs(), inputs={"seconds": 0.2})
    end = time.monotonic() + 0.2
    with pytest.raises(InputError, match="gave no answer within"):
        begun(Hangs(), left=lambda: end - time.monotonic())
    assert asked(Says(PLAIN), SceneRequest("x"), 5.0) is PLAIN


def test_without_a_model_it_says_so(begun):
    with pytest.raises(InputError, match="tool init_model needs a model of scenes"):
        begun(None)


def test_models_are_found(tmp_path, monkeypatch):
    (tmp_path / "their_models.py").write_text(
        "class Good:\n    def generate(self, request):\n        return None\n"
        "good = Good()\nclass Needs:\n    def __init__(self, weights): pass\nnone = 3\n"
    )
    monkeypatch.syspath_prepend(str(tmp_path))
    try:
        for name in ("their_models:good", "their_models:Good"):
            assert isinstance(scene_model(name), SceneModel)
        for name, line in (
            ("their_models:bad", "does not load: AttributeError"),
            ("no_models:good", "does not load: ModuleNotFoundError"),
            ("their_models:none", "is no model; it needs a method generate"),
            ("their_models:Needs", "cannot be made without arguments"),
            ("nothing", 'is no folder or file, no "module:attribute" and no entry point'),
            ("os:system('x')", 'is no folder or file, no "module:attribute"'),
        ):
            with pytest.raises(InputError, match=line) as caught:
                scene_model(name)
            assert "\n" not in str(caught.value)
    finally:
        sys.modules.pop("their_models", None)
    mine = Says()
    assert scene_model(mine) is mine and name_of(mine).endswith("test_init_model:Says") and name_of("a:b") == "a:b"
    with pytest.raises(InputError, match="is no model"):
        scene_model(3)


def test_an_entry_point_names_a_model(monkeypatch):
    from importlib import metadata

    point = metadata.EntryPoint("theirs", f"{__name__}:Says", "sceneweaver.scene_models")
    monkeypatch.setattr(metadata, "entry_points", lambda group: [point] if group == point.group else [])
    assert type(scene_model("theirs")).__name__ == "Says"
