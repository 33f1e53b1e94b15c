"""How far doors and drawers open: what is in their way, what is not, and what that does to a verdict."""

import math
from pathlib import Path

import pytest

from sceneweaver.assets import Library, categories
from sceneweaver.scene import Pose, Scene
from sceneweaver.verify import check, openable
from tests.verify.build import box, only, scene

CHEST = "parametric:dresser?seed=0"
FRIDGE = "parametric:fridge?seed=0"


def with_asset(asset: str, x: float, y: float, objects: list | None = None, yaw: float = 0.0, **room) -> Scene:
    """A scene with one asset, and boxes."""
    made = scene(objects or [], **room)
    thing = Library().load(asset).object("piece", pose=Pose.from_yaw(x, y, 0.0, yaw))
    return made.model_copy(update={"objects": (thing, *made.objects)})


@pytest.fixture(scope="module")
def chest() -> tuple[float, float]:
    """How far the fronts of the drawers are before the middle of the chest, and how far they come out [m]."""
    asset = Library().load(CHEST)
    front = max(float(h.vertices[:, 0].max()) for h in asset.hulls if h.link)
    (travel,) = {link.limits[1] for link in asset.links}
    return front, travel


def test_alone_everything_opens():
    report = check(with_asset(CHEST, 2.0, 4.0), openable=True)
    assert report.openable_share == 1.0 and report.blocked_links == () and report.valid


@pytest.mark.parametrize("share", [0.0, 0.3, 0.75])
def test_a_box_before_a_chest(chest, share):
    front, travel = chest
    gap = share * travel + 0.5 * travel / 20  # half a step beyond
    before = box("block", (0.4, 3.0, 2.0), 2.0 + front + gap + 0.2, 4.0)
    made = with_asset(CHEST, 2.0, 4.0, [before])
    found = openable.measure(made)
    assert {link.share for link in found} == {share} and {link.blocked_by for link in found} == {"block"}
    report = check(made, openable=True)
    assert not report.valid and report.openable_share == 0.0
    blocked = [v for v in report.violations if v.kind == "blocked_link"]
    assert len(blocked) == math.ceil(len(found) / 2) and blocked[0].objects == ("piece", "block")
    assert "block is in its way" in blocked[0].detail and blocked[0].hard
    assert all(v.kind != "blocked_link" for v in check(made).violations)  # only where it is asked for


def test_an_arm_of_a_box_high_up_leaves_the_lower_drawers_free(chest):
    front, _ = chest
    asset = Library().load(CHEST)
    over = box("shelf", (0.4, 3.0, 0.1), 2.0 + front + 0.25, 4.0, z=asset.size[2] - 0.12)
    found = openable.measure(with_asset(CHEST, 2.0, 4.0, [over]))
    assert any(link.opens for link in found) and any(not link.opens for link in found)


def test_walls_are_in_the_way(chest):
    front, travel = chest
    made = with_asset(CHEST, 8.0 - front - 0.5 * travel, 4.0)
    found = openable.measure(made)
    assert {link.blocked_by for link in found} == {"wall:1"} and {link.share for link in found} <= {0.45, 0.5}


def test_what_a_hand_moves_is_not(chest):
    front, _ = chest
    seat = (
        Library()
        .load("parametric:dining_chair?seed=0")
        .object("chair", pose=Pose.from_yaw(2.0 + front + 0.3, 4.0, 0.0, math.pi))
    )
    made = with_asset(CHEST, 2.0, 4.0)
    made = made.model_copy(update={"objects": (*made.objects, seat)})
    assert all(link.opens for link in openable.measure(made))
    fixed = made.model_copy(update={"objects": (made.objects[0], seat.model_copy(update={"fixed": True}))})
    assert "chair" in {link.blocked_by for link in openable.measure(fixed)}


def test_each_door_of_an_appliance_is_needed():
    asset = Library().load(FRIDGE)
    d, w, _ = asset.size
    block = box("block", (0.5, w, 0.3), 2.0 + d / 2 + 0.35, 4.0)  # low: before the lower door alone
    report = check(with_asset(FRIDGE, 2.0, 4.0, [block]), openable=True)
    lowest = min(
        asset.links,
        key=lambda k: min(h.vertices[:, 2].min() for h in asset.hulls if h.link == asset.links.index(k) + 1),
    )
    blocked = only(report, "blocked_link")
    assert blocked.objects == ("piece", "block") and lowest.name in blocked.detail


def test_doors_of_rooms():
    door = {"id": "door", "wall": 0, "offset": 3.0, "width": 0.9, "height": 2.05, "swing": "in-left"}
    free = scene([], doors=[door])
    assert [(link.object, link.link, link.share) for link in openable.measure(free)] == [("door", "leaf", 1.0)]
    inside = scene([box("block", (0.3, 0.3, 1.0), 3.4, 0.5)], doors=[door])
    (link,) = openable.measure(inside)
    assert link.share < 0.9 and link.blocked_by == "block"
    assert only(check(inside, openable=True), "blocked_link").objects == ("door", "block")


def test_an_asset_that_is_gone_is_said(tmp_path: Path):
    made = scene([box("piece", (0.5, 0.5, 0.5), 2.0, 2.0, asset="imported:gone")])
    report = check(made, openable=True)
    assert report.valid and report.openable_share is None and report.blocked_links is None
    assert any("imported:gone" in warning for warning in report.warnings)


FEW = ("chest", "freezer", "jewelry_box", "pedal_bin", "wardrobe", "washing_machine", "laundry_hamper", "toilet")
"""Categories whose lids and doors once went behind their backs, or into each other."""


@pytest.mark.parametrize(
    "names", [pytest.param(FEW, id="few"), pytest.param(tuple(categories()), id="all", marks=pytest.mark.slow)]
)
def test_everything_opens_with_its_back_at_a_wall(names):
    """No door or lid is in the way of another of its piece, nor goes behind the piece."""
    load, stuck = Library().load, []
    for name in names:
        if categories()[name].size is None:
            continue
        asset = load(f"parametric:{name}?seed=0")
        if not asset.links or name == "reception_desk":  # its drawers open to its back, where somebody sits
            continue
        pose = Pose.from_yaw(asset.size[0] / 2, 6.0, 0.0 if asset.mount == "floor" else 1.0, 0.0)
        made = scene([], size=12.0, height=6.0)
        made = made.model_copy(update={"objects": (asset.object(name, pose=pose, mount="floor"),)})
        stuck += [link for link in openable.measure(made, load) if not link.opens]
    assert stuck == []
