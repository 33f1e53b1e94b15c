"""Looks that are not wanted are looked for on what is drawn."""

from sceneweaver.assets import Library, Wish
from sceneweaver.critic import review_scene
from sceneweaver.knowledge import room_type
from sceneweaver.language import read_request
from sceneweaver.scene import FloorFinish, Pose, Room, RoomFinish, Scene
from sceneweaver.verify import check


def exclusion(text, color, walls="white", category="sofa"):
    library = Library()
    asset = library.load(library.choose(category, 1, Wish(color=color))[0].id)
    outline = ((0.0, 0.0), (6.0, 0.0), (6.0, 4.0), (0.0, 4.0))
    finish = RoomFinish(walls=walls, floor=FloorFinish(material="tile", tone="light grey"))
    room = Room(type="living_room", outline=outline, height=2.6, finish=finish)
    thing = asset.object(f"{category}-0", pose=Pose.from_yaw(3.0, 2.0, 0.0, 0.0), mount="floor")
    scene = Scene(id="s", prompt=text, room=room, objects=(thing,))
    found = review_scene(scene, check(scene), room_type("living_room"), read_request(text))
    (item,) = [one for one in found.alignment.items if one.kind == "exclusion"]
    return item.status


def test_a_body_or_a_wall_in_the_color_is_found():
    assert exclusion("a living room, nothing pink", "pink") == "unmet"
    assert exclusion("a living room, nothing pink", "grey") == "met"
    assert exclusion("a living room, nothing pink", "grey", walls="blush") == "unmet"


def test_of_some_things_alone():
    assert exclusion("a living room, no red tables", "red") == "met"
    assert exclusion("a living room, no red seats", "red") == "unmet"


def test_what_the_request_gives_a_color_may_have_it():
    assert exclusion("a living room with a pink sofa, nothing else pink, no pink anywhere", "pink") == "met"
