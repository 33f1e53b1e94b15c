"""The patterns that strict eyes counted: each is found in a room that has it and not in one that has not."""

from __future__ import annotations

import gzip
from dataclasses import replace

import numpy as np
import pytest

from benchmarks.design_files import design_files, read_scene
from benchmarks.families.patterns import counted, tabulate
from benchmarks.judging import Judge
from benchmarks.patterns.room import Hits
from benchmarks.patterns.sets import SET_PATTERNS
from benchmarks.patterns.single import PATTERNS, measured
from benchmarks.results import Result
from benchmarks.settings import Settings
from sceneweaver.assets import make
from sceneweaver.scene import Palette, Pose, Room, Scene, SceneObject
from tests.critic.breaches import box, hung, lamp, on, room, top

Boxes = list[SceneObject]

BED, HEAD_AT_DOOR = box("bed-0", (2.0, 1.6, 0.5), 1.05, 2.5), box("bed-0", (2.0, 1.6, 0.5), 3.5, 1.05, 90)
SOFA = box("sofa-0", (0.9, 2.0, 0.8), 0.5, 2.5)
TABLE = top(box("dining_table-0", (0.9, 1.6, 0.75), 3.0, 2.5))
FOUR = [(2.3, 2.1, 0), (2.3, 2.9, 0), (3.7, 2.1, 180), (3.7, 2.9, 180)]
UNIT = (0.6, 0.6, 0.9)
LOW = top(box("cabinet-0", (0.4, 0.9, 0.9), 5.7, 2.5, 180))
MIRROR = hung("wall_mirror-0", (0.03, 2.4, 1.8), 3.0, 0.02, 90, 0.2)
LOCKERS = [box(f"locker-{k}", (0.5, 0.4, 1.8), 5.7, 1.0 + 0.4 * k, 180) for k in range(2)]


def seated(*turns: float) -> Boxes:
    """A table with four chairs, each turned by so many degrees from the table's sides."""
    seats = [
        box(f"dining_chair-{k}", (0.45, 0.45, 0.9), x, y, yaw + turn)
        for k, ((x, y, yaw), turn) in enumerate(zip(FOUR, turns, strict=True))
    ]
    return [TABLE, *seats]


def run(dishwasher: float = 0.9, stove: float = 1.85) -> Boxes:
    """A kitchen run along the left wall with a dishwasher of a height, and its stove at a place [m]."""
    units = [top(box(f"kitchen_counter-{k}", UNIT, 0.3, y)) for k, y in enumerate((2.45, 3.65))]
    washer = top(box("dishwasher-0", (0.6, 0.6, dishwasher), 0.3, 3.05))
    return [*units, washer, top(box("stove-0", UNIT, 0.3, stove))]


def curtain(y: float = 4.0) -> Boxes:
    """A curtain at the middle of the window; ``y`` [m] is that of its back, and the wall is at 5.0."""
    drawn = make("curtain", seed=3)
    depth = drawn.size[0]
    pose = Pose.from_yaw(2.8, y - depth / 2, 0.1, -1.5707963267948966)
    return [drawn.object("curtain-0", pose=pose, mount="wall")]


def machines(*turns: float) -> Boxes:
    return [box(f"treadmill-{k}", (1.8, 0.8, 1.4), 1.5 + 1.2 * k, 3.0, turn) for k, turn in enumerate(turns)]


def looks(color: str) -> Boxes:
    return [LOW, *(on(LOW, f"vase-{k}", (0.05, 0.05, 0.2), style="modern", color=color) for k in range(3))]


BLUE = Palette(
    name="sea", style="modern", woods=("oak",), paints=("blue paint",), textiles=("blue fabric",), metals=("brass",)
)

CASES: list[tuple[str, str, Boxes, Boxes]] = [
    ("light", "bedroom", [BED, lamp("pendant-0", 3.0, 2.5)], [BED]),
    ("palette", "bedroom", looks("blue"), looks("red")),
    (
        "rug_axis",
        "bedroom",
        [BED, box("rug-0", (1.6, 2.6, 0.01), 1.6, 2.5)],
        [BED, box("rug-0", (1.6, 2.6, 0.01), 1.6, 2.8)],
    ),
    (
        "rug_size",
        "dining_room",
        [*seated(0, 0, 0, 0), box("rug-0", (2.6, 3.0, 0.01), 3.0, 2.5)],
        [*seated(0, 0, 0, 0), box("rug-0", (1.2, 1.8, 0.01), 3.0, 2.5)],
    ),
    ("bed_head", "bedroom", [BED], [HEAD_AT_DOOR]),
    (
        "orphan",
        "bathroom",
        [box("stool-0", (0.4, 0.4, 0.45), 1.0, 2.5), box("bathtub-0", (1.7, 0.8, 0.6), 1.0, 3.3)],
        [box("stool-0", (0.4, 0.4, 0.45), 3.0, 2.5), box("bathtub-0", (1.7, 0.8, 0.6), 1.0, 4.5)],
    ),
    (
        "door_frame",
        "bedroom",
        [box("dresser-0", (0.45, 1.0, 0.9), 2.2, 0.25, 90)],
        [box("dresser-0", (0.45, 1.0, 0.9), 1.75, 0.25, 90)],
    ),
    (
        "screen",
        "bedroom",
        [box("armchair-0", (0.8, 0.8, 0.9), 3.0, 2.5), hung("tv-0", (0.1, 1.2, 0.7), 5.95, 2.5, 180, 0.9)],
        [box("armchair-0", (0.8, 0.8, 0.9), 3.0, 2.5, 180), hung("tv-0", (0.1, 1.2, 0.7), 5.95, 2.5, 180, 0.9)],
    ),
    (
        "curtain_axis",
        "bedroom",
        [hung("curtain-0", (0.18, 2.2, 2.3), 2.8, 4.9, -90, 0.05)],
        [hung("curtain-0", (0.18, 2.2, 2.3), 3.2, 4.9, -90, 0.05)],
    ),
    ("sill", "bedroom", curtain(5.0), curtain(5.12)),
    ("foreign", "meeting_room", [LOW, on(LOW, "cup-0")], [LOW, on(LOW, "perfume_bottle-0")]),
    ("duplicates", "kitchen", [LOW, on(LOW, "knife_block-0")], [LOW, *(on(LOW, f"knife_block-{k}") for k in range(3))]),
    (
        "blocked",
        "bedroom",
        [box("wardrobe-0", (0.6, 1.2, 2.0), 5.7, 2.5, 180)],
        [box("wardrobe-0", (0.6, 1.2, 2.0), 5.7, 2.5, 180), box("dresser-0", (0.5, 1.6, 0.9), 4.8, 2.5)],
    ),
    ("worktop", "kitchen", run(), run(dishwasher=0.83)),
    ("dishwasher", "kitchen", run(), run(dishwasher=0.83)),
    ("stove", "kitchen", run(), run(stove=0.31)),
    (
        "unlit",
        "dining_room",
        [*seated(0, 0, 0, 0), lamp("pendant-0", 3.0, 2.5, 1.5)],
        [*seated(0, 0, 0, 0), lamp("pendant-0", 5.0, 4.0, 2.3)],
    ),
    ("pendant", "living_room", [lamp("pendant-0", 3.0, 2.5, 2.2)], [lamp("pendant-0", 3.0, 2.5, 1.6)]),
    ("machines", "gym", machines(90, 90, 90), machines(90, 0, -90)),
    (
        "gym_lacks",
        "gym",
        [MIRROR, *LOCKERS, LOW, *(on(LOW, f"bottle-{k}") for k in range(15))],
        [MIRROR, LOW, *(on(LOW, f"bottle-{k}") for k in range(15))],
    ),
    ("one_angle", "dining_room", seated(3, -4, 0, 6), seated(0, 0, 0, 0)),
]


def scene(kind: str, objects: Boxes, space: Room | None = None) -> Scene:
    space = (space or room()).model_copy(update={"type": kind})
    return Scene(id=kind, prompt=f"a {kind.replace('_', ' ')}", room=space, objects=tuple(objects), palette=BLUE)


@pytest.mark.parametrize(("name", "kind", "without", "having"), CASES, ids=[c[0] for c in CASES])
def test_a_pattern_is_found_where_it_is(name: str, kind: str, without: Boxes, having: Boxes) -> None:
    clean, found = measured(scene(kind, without))[name], measured(scene(kind, having))[name]
    assert clean.of and not clean.found, clean
    assert 0 < found.found <= found.of, found


def test_a_wall_is_bare_until_something_covers_it() -> None:
    places = ((3.5, 0.02, 90), (5.98, 2.5, 180), (0.02, 2.5, 0))
    walls = [hung(f"picture-{k}", (0.04, 1.6, 0.8), *place, 1.1) for k, place in enumerate(places)]
    assert measured(scene("bedroom", walls))["bare_wall"] == Hits(0, 1)
    assert measured(scene("bedroom", walls[:2]))["bare_wall"] == Hits(1, 1, ("wall:3",))


def test_a_piece_that_turns_its_back_to_both_cameras_is_lost() -> None:
    from benchmarks.patterns.views import _lost

    piece = box("wardrobe-0", (0.6, 1.2, 2.0), 3.0, 2.5)
    ahead = np.array((1.0, 0.0))
    assert _lost(piece, -ahead, set()) and not _lost(piece, ahead, set())
    assert _lost(piece, ahead, {"wardrobe-0"})
    assert measured(scene("bedroom", [piece]))["behind"] == Hits(0, 1)


def test_the_same_picture_twice_is_a_clone() -> None:
    pair = [hung(f"picture-{k}", (0.03, 0.6, 0.8), 1 + k, 4.98, -90, 1.1) for k in range(2)]
    one, other = (p.model_copy(update={"asset": f"parametric:picture?seed={k}"}) for k, p in enumerate(pair))
    assert measured(scene("bedroom", [one, other]))["cloned"].found == 0
    assert measured(scene("bedroom", [one, other.model_copy(update={"asset": one.asset})]))["cloned"].found == 1


def test_rooms_alike_are_counted_over_all() -> None:
    def sets(*scenes: Scene) -> dict[str, Hits]:
        return {name: p.measure({str(k): s for k, s in enumerate(scenes)}) for name, p in SET_PATTERNS.items()}

    alike = sets(scene("bedroom", [BED]), scene("bedroom", [BED]))
    assert all(hits.found == hits.of > 0 for hits in alike.values())
    other = scene("bedroom", [HEAD_AT_DOOR], room(7.0, 4.0, door=2.0, window=None))
    different = sets(scene("bedroom", [BED]), other)
    assert different["same_shell"].found == different["same_layout"].found == 0
    assert different["usual_shell"].found == 1
    assert sets(scene("bedroom", [BED]), scene("gym", [BED]))["one_paint"].of == 0


def test_designs_are_read_from_folders_and_files(tmp_path) -> None:
    made = scene("bedroom", [BED])
    for name in ("a", "b", "b/steps/01"):
        (tmp_path / "many" / name).mkdir(parents=True)
        made.save(tmp_path / "many" / name / "scene.json")
    (tmp_path / "packed").mkdir()
    (tmp_path / "packed" / "c.json.gz").write_bytes(gzip.compress(made.dumps().encode()))
    found = design_files([tmp_path / "many", tmp_path / "packed", tmp_path / "many" / "a"])
    assert list(found) == ["a", "b", "c", "a (2)"]
    assert all(read_scene(path) == made for path in found.values())
    (tmp_path / "none").mkdir()
    with pytest.raises(ValueError, match="none holds no scene"):
        design_files([tmp_path / "none"])
    from benchmarks.families.patterns import run as family

    settings = Settings(designs=(tmp_path / "many",), jobs=1, out=tmp_path)
    result = family(settings, Judge(1))
    assert len(result.table("patterns").rows) == len(PATTERNS) + len(SET_PATTERNS)
    assert replace(settings, jobs=2).options()["designs"] == [str(tmp_path / "many")]


def test_a_table_adds_up_rooms() -> None:
    rooms = {"one": scene("bedroom", [BED]), "two": scene("bedroom", [HEAD_AT_DOOR])}
    result = Result("patterns", "", "")
    tabulate(result, rooms, counted(rooms, 1))
    row = next(r for r in result.table("patterns").rows if r["pattern"] == PATTERNS["bed_head"].text)
    assert (row["found"], row["of"], row["rooms"]) == (1, 2, "two")
