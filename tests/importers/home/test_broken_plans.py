"""Files of plans that are broken: one line each, which names the file and what is wrong."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

import sceneweaver as sw
from tests.importers.home.plans import TEXTS, dxf

SVG = '<svg xmlns="http://www.w3.org/2000/svg" {}>{}</svg>'
SCALED = 'data-scale="0.01"'
ROOM = '<rect id="bedroom" width="400" height="300"/>'


def replaced(name: str, *changes: tuple[str, str]) -> str:
    text = TEXTS[name][1]()
    for old, new in changes:
        assert old in text, old
        text = text.replace(old, new, 1)
    return text


def without(name: str, key: str) -> str:
    data = json.loads(TEXTS[name][1]())
    del data[key]
    return json.dumps(data)


CASES: list[tuple[str, str, str]] = [
    ("resplan", replaced("resplan", ("POLYGON", "POLIGON")), "is no geometry; give GeoJSON or WKT"),
    ("resplan", replaced("resplan", ("4.0 0.0", "1e9 0.0")), "too large"),
    ("resplan", json.dumps({"door": "POLYGON ((0 0, 1 0, 1 1, 0 0))"}), "no layer is a room"),
    ("resplan", TEXTS["resplan"][1]()[:-9], "JSON"),
    ("resplan", json.dumps({"bedroom": "POLYGON ((0 0, 0.01 0, 0.01 0.01, 0 0))", "door": "POINT (0 0)"}), "left"),
    ("msd", replaced("msd", ("entity_subtype", "kind")), "a column is missing; entity_type, entity_subtype and geom"),
    ("msd", replaced("msd", ("POLYGON ((", "POLYGON (")), "row 2: ['\"]?POLYGON"),
    ("msd", replaced("msd", (",8.7,", ",high,")), "row 2: elevation is .high.; give metres"),
    ("msd", replaced("msd", ("unit_id", "unit"), ("apartment_id", "flat")), "neither unit_id nor apartment_id"),
    ("msd", TEXTS["msd"][1]().split("\n")[0] + "\n", "no row is an area of a flat"),
    ("infinigen-plan", json.dumps({"rooms": {}}), "holds no room"),
    ("infinigen-plan", replaced("infinigen-plan", ("shapely.Polygon", "os.system")), "shapely"),
    ("infinigen-plan", without("infinigen-plan", "rooms"), "rooms"),
    ("infinigen-plan", replaced("infinigen-plan", ("shapely.Polygon(", "shapely.LineString(")), "a box or a polygon"),
    ("infinigen-plan", TEXTS["infinigen-plan"][1]()[:40], "JSON"),
    ("ai2thor", without("ai2thor", "rooms"), "rooms"),
    ("ai2thor", replaced("ai2thor", ('"x": -0.05', '"x": "a"')), "x"),
    ("ai2thor", json.dumps({"rooms": [], "floorPolygon": 1}), "holds no room"),
    ("ai2thor", replaced("ai2thor", ('"id": "room|1", ', "")), "id"),
    ("ai2thor", TEXTS["ai2thor"][1]()[:300], "JSON"),
    ("cubicasa", replaced("cubicasa", ("Space Bedroom", "Place"), ("Space Entry", "Place")), "no room in it"),
    ("cubicasa", replaced("cubicasa", ('Bedroom"><polygon points="', 'Bedroom"><polygon points="nan,')), "finite"),
    ("cubicasa", replaced("cubicasa", ('Bedroom"><polygon points="', 'Bedroom"><polygon points="1,')), "x,y pairs"),
    ("cubicasa", TEXTS["cubicasa"][1]()[:-5], "XML"),
    ("cubicasa", replaced("cubicasa", ('<g class="Model">', '<g class="Model" transform="skewX(3)">')), "transform"),
    ("svg", SVG.format("", ROOM), "nothing says how large a unit is; give --scale"),
    ("svg", SVG.format(SCALED, '<circle class="room" r="4"/>'), "circle 1: a room has straight walls"),
    ("svg", SVG.format(SCALED, '<g id="rooms"><line id="a" x2="4"/></g>'), "a: a room must be closed; end it"),
    (
        "svg",
        SVG.format(SCALED, ROOM + '<line id="door-7" x1="900" x2="980"/>'),
        "door-7: lies in no wall of a room; move",
    ),
    ("svg", SVG.format(SCALED, '<polygon id="hall" points="0,0 9,9 9,0 0,9"/>'), "hall: its outline crosses itself"),
    ("r2v", "1 2 x 4 wall 1 1\n", "line 1: .1 2 x 4"),
    ("r2v", "9 9 50 9 door 1 1\n", "no line of it is a wall"),
    ("r2v", "0 0 90 0 wall 1 1\n0 0 0 80 wall 1 1\n", "its walls enclose no room"),
    ("r2v", "", "the file is empty"),
    ("r2v", "0 0 inf 0 wall 1 1\n", "numbers must be finite"),
    ("rplan", without("rplan", "ed_rm"), "'ed_rm' is missing"),
    ("rplan", replaced("rplan", ('"room_type": [3', '"room_type": ["x"')), "room_type"),
    ("rplan", json.dumps({"room_type": [], "edges": [], "ed_rm": []}), "no room in it"),
    ("rplan", json.dumps({"room_type": [1], "edges": [[0, 0, 9, 0, 1, 0]], "ed_rm": [[4]]}), "one of the 1 rooms"),
    ("rplan", TEXTS["rplan"][1]()[:99], "JSON"),
]


@pytest.mark.parametrize(("name", "text", "says"), CASES, ids=[f"{c[0]}-{k}" for k, c in enumerate(CASES)])
def test_one_line_for_a_broken_file(name: str, text: str, says: str, tmp_path: Path) -> None:
    path = tmp_path / TEXTS[name][0]
    path.write_text(text)
    with pytest.raises(sw.InputError, match=says) as error:
        sw.read_homes(path, name)
    assert "\n" not in str(error.value) and path.name in str(error.value)


def _dxf(folder: Path, draw: str) -> Path:
    from ezdxf.filemanagement import new

    document = new("R2010")
    document.header["$INSUNITS"] = 0 if draw == "unit" else 6
    space = document.modelspace()
    if draw == "open":
        space.add_lwpolyline([(0, 0), (4, 0), (4, 3)], dxfattribs={"layer": "ROOMS"})
    elif draw == "arc":
        space.add_lwpolyline([(0, 0, 0.5), (4, 0, 0), (4, 3, 0)], "xyb", close=True, dxfattribs={"layer": "ROOMS"})
    elif draw == "apart":
        space.add_line((0, 0), (4, 0), dxfattribs={"layer": "WALL"})
    else:
        space.add_lwpolyline([(0, 0), (4, 0), (4, 3)], close=True, dxfattribs={"layer": "ROOMS"})
    path = folder / "plan.dxf"
    document.saveas(path)
    return path


@pytest.mark.parametrize(
    ("draw", "says"),
    [
        ("open", "LWPOLYLINE .* on layer ROOMS: a room must be closed"),
        ("arc", "it has arcs; rooms and walls are straight here"),
        ("apart", "its 1 lines of walls enclose no room"),
        ("unit", "nothing says how large a unit is"),
    ],
)
def test_one_line_for_a_broken_dxf(draw: str, says: str, tmp_path: Path) -> None:
    with pytest.raises(sw.InputError, match=says) as error:
        sw.read_homes(_dxf(tmp_path, draw))
    assert "\n" not in str(error.value) and "plan.dxf" in str(error.value)


def test_a_dxf_that_is_cut_short(tmp_path: Path) -> None:
    path = dxf(tmp_path)
    path.write_bytes(path.read_bytes()[:700])
    with pytest.raises(sw.InputError, match=r"flat\.dxf: ") as error:
        sw.read_homes(path)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("scale", [0.0, -1.0, float("nan"), float("inf")])
def test_a_scale_that_is_none(scale: float, tmp_path: Path) -> None:
    (tmp_path / "a.svg").write_text(SVG.format(SCALED, ROOM))
    with pytest.raises(sw.InputError, match="scale: "):
        sw.read_homes(tmp_path / "a.svg", scale=scale)


def test_a_home_of_ours_that_is_broken(tmp_path: Path) -> None:
    path = tmp_path / "home.json"
    path.write_text('{"schema": "sceneweaver.home/1", "id": "x", "rooms": []}')
    with pytest.raises(sw.InputError, match=r"home\.json: rooms"):
        sw.read_homes(path)
