"""Exports land in the folder that was chosen: no link in it leads what they write elsewhere."""

from __future__ import annotations

import pytest

from sceneweaver.assets import make
from sceneweaver.export import export_scene
from sceneweaver.scene import InputError, Pose, Room, Scene

FOLDERS = {"mjcf": "meshes", "usd": "textures", "scenestate": "models", "sdf": "sdf", "urdf": "urdf"}


@pytest.fixture(scope="module")
def scene() -> Scene:
    table = make("coffee_table", seed=1).object("coffee_table-0", pose=Pose.from_yaw(1.5, 1.5, 0.0, 0.3))
    return Scene(
        id="lounge",
        prompt="a table",
        room=Room(type="lounge", outline=((0, 0), (3, 0), (3, 3), (0, 3))),
        objects=(table,),
    )


@pytest.mark.parametrize("name", FOLDERS)
def test_a_link_for_a_folder_is_refused(scene, tmp_path, name):
    own, away = tmp_path / "own", tmp_path / "away"
    export_scene(scene, own, (name,))
    folder = own / FOLDERS[name]
    assert folder.is_dir(), sorted(own.iterdir())
    folder.rename(away)
    folder.symlink_to(away)
    before = {path: path.stat().st_mtime_ns for path in away.rglob("*")}
    with pytest.raises(InputError, match=f"{FOLDERS[name]}: this is a link to another place"):
        export_scene(scene, own, (name,))
    assert {path: path.stat().st_mtime_ns for path in away.rglob("*")} == before


def test_a_link_for_a_file_is_replaced_with_all_that_lies_beside_it(scene, tmp_path):
    own, away = tmp_path / "own", tmp_path / "away"
    own.mkdir()
    away.mkdir()
    for name in ("scene.usdc", "scene.glb", "scene.xml"):
        (away / name).write_text("keep")
        (own / name).symlink_to(away / name)
    export_scene(scene, own, ("usd", "glb", "mjcf"))
    assert {path.name: path.read_text() for path in away.iterdir()} == dict.fromkeys(
        ("scene.usdc", "scene.glb", "scene.xml"), "keep"
    )
    assert not any((own / name).is_symlink() for name in ("scene.usdc", "scene.glb", "scene.xml"))


def test_the_folder_that_was_chosen_may_itself_be_a_link(scene, tmp_path):
    place, chosen = tmp_path / "disk", tmp_path / "chosen"
    place.mkdir()
    chosen.symlink_to(place)
    export_scene(scene, chosen, ("mjcf",))
    assert (place / "scene.xml").is_file() and chosen.is_symlink()
