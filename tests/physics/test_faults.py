"""What goes wrong is said in one line, and never looks like rest."""

from __future__ import annotations

from dataclasses import replace
from importlib import import_module
from typing import Any

import numpy as np
import pytest

from sceneweaver.assets import Asset, make
from sceneweaver.assets.store import Store
from sceneweaver.physics import build, settle, stability
from sceneweaver.physics import model as module
from sceneweaver.physics.hulls import solids_of
from sceneweaver.scene import InputError, Pose, Room, Scene, SceneObject

mujoco: Any = import_module("mujoco")

ROOM = Room(outline=((0, 0), (40, 0), (40, 40), (0, 40)))


def _box(object_id: str, x: float, y: float, z: float = 0.0) -> SceneObject:
    return SceneObject(id=object_id, category="box", size=(0.3, 0.2, 0.4), pose=Pose.from_yaw(x, y, z, 0.5))


def _scene(*objects: SceneObject) -> Scene:
    return Scene(id="s", room=ROOM, objects=objects)


def test_an_asset_whose_files_are_gone_is_named(tmp_path) -> None:
    store = Store(tmp_path)
    cabinet = replace(make("filing_cabinet", 1), id="own-0123456789abcdef")
    assert store.add(cabinet, "0123456789abcdef")
    scene = _scene(_box("b", 1, 1), cabinet.object("c", pose=Pose.from_yaw(3, 3, 0, 0)))
    assert build(scene, store.load).free == ("b", "c")
    (body,) = tmp_path.glob("objects/*/*/body.npz")
    np.savez(body, vertices=cabinet.mesh.vertices)
    with pytest.raises(InputError, match=r"objects\[1\].asset: 'own-0123456789abcdef' is damaged .*import it anew"):
        build(scene, store.load)
    body.unlink()
    with pytest.raises(InputError, match=r"objects\[1\].asset: 'own-0123456789abcdef' is damaged"):
        stability(scene, store.load)
    with pytest.raises(InputError, match=r"objects\[1\].asset: .*is not in the store"):
        build(scene, Store(tmp_path / "other").load)


@pytest.mark.parametrize("kept", ["none", "those of the body", "those of the doors"])
def test_an_asset_that_lacks_parts_stands_by_what_it_has(kept: str) -> None:
    whole = make("filing_cabinet", 1)
    hulls = tuple(h for h in whole.hulls if (h.link == 0) == (kept == "those of the body"))
    asset = replace(whole, hulls=() if kept == "none" else hulls)
    rug = make("rug", 0)
    scene = _scene(
        asset.object("c", pose=Pose.from_yaw(3, 3, 0, 0.3)), rug.object("rug", pose=Pose.from_yaw(3, 3, 0, 0))
    )
    found = build(scene, {asset.id: asset, rug.id: rug}.__getitem__)
    model = mujoco.MjModel.from_xml_string(found.xml)
    assert model.body_subtreemass[model.body("c").id] == pytest.approx(asset.mass, rel=1e-3)
    assert model.njnt == 2, "nothing moves that has no parts, and without its body nothing does"
    if kept != "those of the body":
        assert len(solids_of(scene.objects[0], asset, np.ones(3))) == len(asset.parts), "its prisms"


@pytest.mark.parametrize("memory", ["60K", "120K", "200K"])
def test_too_many_contacts_are_an_error(memory: str, monkeypatch: pytest.MonkeyPatch) -> None:
    crowd = _scene(*(_box(f"b{k}", 3 + 0.01 * k, 3) for k in range(12)))
    monkeypatch.setattr(module, "MEMORY", memory)
    with pytest.raises(InputError, match=r"objects: more contacts than MuJoCo has room for"):
        stability(crowd, seconds=0.1)


def test_deep_overlaps_are_not_rest() -> None:
    crowd = _scene(*(_box(f"b{k}", 3 + 0.01 * k, 3) for k in range(12)))
    result = settle(crowd, seconds=0.5)
    assert result.faults and max(result.moved.values()) > 0.05


def test_a_simulation_that_diverges_is_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    honest = module.build

    def wild(*given: Any) -> Any:
        model = honest(*given)
        return replace(model, xml=model.xml.replace("<option ", '<option gravity="0 0 -1e16" ', 1))

    monkeypatch.setattr(import_module("sceneweaver.physics.settle"), "build", wild)
    for ask in (stability, settle):
        with pytest.raises(InputError, match=r"objects: the simulation diverged at 'up'; take objects apart"):
            ask(_scene(_box("up", 1, 1, 1.0)))


@pytest.mark.slow
def test_a_thousand_objects() -> None:
    """They have room for their contacts, and stay where they are."""
    assets: dict[str, Asset] = {
        a.id: a for a in (make("dining_chair", 0), make("nightstand", 1), make("wastebasket", 1))
    }
    kinds = list(assets.values())
    objects = tuple(
        kinds[k % 3].object(f"o{k}", pose=Pose.from_yaw(1 + 1.2 * (k % 32), 1 + 1.2 * (k // 32), 0, k))
        for k in range(1000)
    )
    found = stability(_scene(*objects), assets.__getitem__, 0.2)
    assert found["free"] == 1000 and found["moved_over_0_01m"] == 0
