"""The same flat from every system: clear floors corner by corner, doors between the two rooms they lie between."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver.home import HomeDoor, HomeWindow
from tests.importers.home.plans import BEDROOM, HALL, TEXTS, dxf, file_of

NEAR = 1e-3 + 1e-9
FORMATS = [*TEXTS, "dxf"]


def read(name: str, folder: Path) -> sw.ImportedHome:
    scale = TEXTS[name][2] if name in TEXTS else None
    (imported,) = sw.read_homes(file_of(name, folder), scale=scale)
    assert imported.format == name
    return imported


def same_ring(found: object, wanted: list[tuple[float, float]]) -> None:
    """Equal corners in order, from any of them on."""
    a, b = np.asarray(found), np.asarray(wanted)
    assert a.shape == b.shape
    assert min(np.abs(np.roll(a, k, axis=0) - b).max() for k in range(len(a))) <= NEAR


def ends(home: sw.Home, opening: HomeDoor | HomeWindow) -> np.ndarray:
    wall = home.room(opening.room).walls[opening.wall]
    points = [wall.point(opening.offset), wall.point(opening.offset + opening.width)]
    return np.array(sorted(points))


@pytest.mark.parametrize("name", FORMATS)
def test_floors_between_walls(name: str, tmp_path: Path) -> None:
    home = read(name, tmp_path).home
    bedroom, hall = home.rooms
    assert bedroom.type == "bedroom" and hall.type in ("hallway", "entrance_hall")
    same_ring(bedroom.outline, BEDROOM)
    same_ring(hall.outline, HALL)
    assert home.walls.inner == 0.1


@pytest.mark.parametrize("name", FORMATS)
def test_doors_join_their_rooms(name: str, tmp_path: Path) -> None:
    home = read(name, tmp_path).home
    bedroom, hall = home.rooms
    entrance, door = sorted(home.doors, key=lambda d: d.to is not None)
    assert {door.room, door.to} == {bedroom.id, hall.id} and entrance.to is None and entrance.room == hall.id
    x = 4.0 if door.room == bedroom.id else 4.1
    assert np.abs(ends(home, door) - [(x, 0.7), (x, 1.6)]).max() <= NEAR
    assert np.abs(ends(home, entrance) - [(4.9, 0.0), (5.9, 0.0)]).max() <= NEAR
    assert door.opens_into == bedroom.id or name == "ai2thor"  # which says how its doors turn
    assert home.graph()[bedroom.id] == [(hall.id, door.id)] and home.entrances == (entrance,)


@pytest.mark.parametrize("name", FORMATS)
def test_windows_light_their_room(name: str, tmp_path: Path) -> None:
    home = read(name, tmp_path).home
    if name == "rplan":
        assert not home.windows
        return
    (window,) = home.windows
    assert window.room == home.rooms[0].id
    assert np.abs(ends(home, window) - [(1.0, 3.0), (2.5, 3.0)]).max() <= NEAR


@pytest.mark.parametrize("name", FORMATS)
def test_what_was_assumed_is_said(name: str, tmp_path: Path) -> None:
    imported = read(name, tmp_path)
    said = " ".join(imported.notes)
    assert ("half its thickness" in said) == (name in ("infinigen-plan", "ai2thor", "r2v"))
    assert ("turned by" in said) == (name == "msd")
    assert [room.name for room in imported.raw] and all("\n" not in note for note in imported.notes)


def test_our_own_file_goes_round(tmp_path: Path) -> None:
    home = sw.Home.example("flat")
    home.save(tmp_path / "home.json")
    (imported,) = sw.read_homes(tmp_path / "home.json")
    assert imported.home == home and imported.format == "sceneweaver"


def test_a_home_that_was_read_goes_round(tmp_path: Path) -> None:
    home = read("svg", tmp_path).home
    home.save(tmp_path / "out.json")
    assert sw.Home.load(tmp_path / "out.json") == home


def test_several_houses_of_a_file(tmp_path: Path) -> None:
    import json

    plan = json.loads(TEXTS["resplan"][1]())
    file = tmp_path / "plans.json"
    file.write_text(json.dumps([{"id": 4, **plan}, {"id": 9, **plan}]))
    homes = sw.read_homes(file)
    assert [h.home.id for h in homes] == ["plans-4", "plans-9"] and [len(h.home.rooms) for h in homes] == [2, 2]


def test_a_folder_passes_over_what_is_broken(tmp_path: Path) -> None:
    file_of("resplan", tmp_path)
    (tmp_path / "b.svg").write_text("<svg xmlns='http://www.w3.org/2000/svg'><rect id='bedroom'/></svg>")
    said: list[str] = []
    assert len(sw.read_homes(tmp_path, on_error=said.append)) == 1
    assert len(said) == 1 and "b.svg: bedroom: width is missing" in said[0]


def test_how_outlines_are_drawn_can_be_said(tmp_path: Path) -> None:
    file = file_of("infinigen-plan", tmp_path)
    (faces,) = sw.read_homes(file, drawn="faces")
    same_ring(faces.home.rooms[0].outline, [(-0.05, -0.05), (4.05, -0.05), (4.05, 3.05), (-0.05, 3.05)])
    with pytest.raises(sw.InputError, match="drawn: 'inside'"):
        sw.read_homes(file, drawn="inside")  # type: ignore[arg-type]


def test_storeys_by_their_elevation(tmp_path: Path) -> None:
    rows = TEXTS["msd"][1]().splitlines()
    upper = [row.replace(",8.7,", ",11.6,") for row in rows[1:]]
    file = tmp_path / "house.csv"
    file.write_text("\n".join([*rows, *upper]))
    (imported,) = sw.read_homes(file)
    ground, first = imported.home.storeys
    assert (ground.id, first.id) == ("0", "1") and first.elevation == pytest.approx(2.9)
    assert [len(imported.home.rooms_of(s.id)) for s in imported.home.storeys] == [2, 2]


def test_storeys_drawn_beside_each_other_are_stacked(tmp_path: Path) -> None:
    text = TEXTS["cubicasa"][1]()
    floor = text[text.index('<g class="Floorplan') : text.index("</g></svg>")]
    second = floor.replace("Floor-1", "Floor-2").replace("<g class", '<g transform="translate(1000 40)" class', 1)
    file = tmp_path / "model.svg"
    file.write_text(text.replace(floor, floor + second))
    (imported,) = sw.read_homes(file, scale=0.01)
    a, b = (imported.home.rooms_of(s.id) for s in imported.home.storeys)
    same_ring(b[0].outline, list(a[0].outline))
    assert any("drawn beside the lowest" in note for note in imported.notes)


def test_rooms_without_a_wall_between_them_are_open_to_each_other(tmp_path: Path) -> None:
    file = tmp_path / "open.svg"
    file.write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" data-scale="0.01"><rect id="living" width="500" height="400"/>'
        '<rect id="kitchen" x="500" width="200" height="400"/>'
        '<rect id="bedroom" y="410" width="500" height="300"/>'
        '<rect id="bath" x="510" y="410" width="190" height="300"/>'
        "</svg>"
    )
    (imported,) = sw.read_homes(file)
    (door,) = imported.home.doors
    assert (door.kind, door.width, {door.room, door.to}) == ("open", 4.0, {"living_room_0", "kitchen_0"})


def test_noise_of_pixels_is_taken_out(tmp_path: Path) -> None:
    """A tail along a wall, a step of 2 cm, a wall that leans by 1 cm, and a corner that another room has."""
    file = tmp_path / "noise.svg"
    file.write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" data-scale="0.01">'
        '<polygon id="bedroom" points="0,0 400,0 400,100 402,100 402,300 1,300 0,150 -8,150 -8,600 -14,600 -14,140 '
        '0,140"/>'
        '<rect id="bath" x="380" y="200" width="200" height="100"/></svg>'
    )
    (imported,) = sw.read_homes(file, drawn="faces")
    bedroom, bath = imported.home.rooms
    same_ring(bath.outline, [(3.8, -3.0), (5.8, -3.0), (5.8, -2.0), (3.8, -2.0)])
    ring = np.asarray(bedroom.outline)
    steps = np.abs(np.roll(ring, -1, axis=0) - ring)
    assert len(ring) <= 8 and steps.min(axis=1).max() < 1e-9 and ring[:, 0].min() > -0.05
    assert any("narrower" in note for note in imported.notes) and any("another room" in n for n in imported.notes)


def test_walls_enclose_the_rooms_of_a_dxf(tmp_path: Path) -> None:
    from ezdxf.filemanagement import new

    document = new("R2010")
    document.header["$INSUNITS"] = 0
    space = document.modelspace()
    lines = [((0, 0), (6000, 0)), ((6000, 0), (6000, 3000)), ((6000, 3000), (0, 3000)), ((0, 3000), (0, 0))]
    for a, b in [*lines, ((4000, 0), (4000, 3000))]:
        space.add_line(a, b, dxfattribs={"layer": "WALLS"})
    space.add_text("Kitchen", dxfattribs={"insert": (1000, 1000)})
    space.add_line((4000, 1000), (4000, 1900), dxfattribs={"layer": "door"})
    file = tmp_path / "walls.dxf"
    document.saveas(file)
    with pytest.raises(sw.InputError, match=r"walls.dxf: nothing says how large a unit is; give --scale"):
        sw.read_homes(file)
    (imported,) = sw.read_homes(file, scale=0.001)
    kitchen, room = imported.home.rooms
    same_ring(kitchen.outline, [(0.05, 0.05), (3.95, 0.05), (3.95, 2.95), (0.05, 2.95)])
    assert (kitchen.type, room.type, len(imported.home.doors)) == ("kitchen", "room", 1)


def test_the_dxf_of_this_folder_is_one(tmp_path: Path) -> None:
    assert dxf(tmp_path).stat().st_size > 1000
