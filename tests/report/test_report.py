"""The page as text: complete, safe, and alone in the world."""

from __future__ import annotations

import base64
import hashlib
import json
import re
import zlib
from dataclasses import replace
from html.parser import HTMLParser
from typing import Any, Literal

import numpy as np
import pytest

from sceneweaver.assets.textures import maps
from sceneweaver.export.corners import texture_coordinates
from sceneweaver.export.openings import door_leaves, opening_meshes
from sceneweaver.report import ReportData, report_html, write_report
from sceneweaver.report.facts import faults_of, relation_rows
from sceneweaver.report.view3d import pack
from sceneweaver.scene import Door, InputError, Pose, Relation, Room, SceneObject
from sceneweaver.verify import check
from tests.report.scenes import HOSTILE, asked, asset, full, furnished, load


class Page(HTMLParser):
    """All tags with their attributes, the text of scripts, and the visible text."""

    def __init__(self, text: str):
        super().__init__(convert_charrefs=True)
        self.tags: list[tuple[str, dict[str, str | None]]] = []
        self.scripts: list[tuple[dict[str, str | None], str]] = []
        self.words: list[str] = []
        self.stack: list[str] = []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append((tag, dict(attrs)))
        if tag not in ("meta", "img", "input", "br"):
            self.stack.append(tag)
        if tag == "script":
            self.scripts.append((dict(attrs), ""))

    def handle_endtag(self, tag: str) -> None:
        assert self.stack and self.stack.pop() == tag, f"</{tag}> closes nothing"

    def handle_data(self, data: str) -> None:
        if self.stack and self.stack[-1] == "script":
            self.scripts[-1] = (self.scripts[-1][0], self.scripts[-1][1] + data)
        elif not self.stack or self.stack[-1] != "style":
            self.words.append(data)

    @property
    def text(self) -> str:
        return " ".join(self.words)


@pytest.fixture(scope="module")
def page() -> tuple[str, Page]:
    text = report_html(full())
    return text, Page(text)


def test_well_formed_and_complete(page) -> None:
    text, parsed = page
    assert not parsed.stack, "every element is closed"
    for words in (
        "not valid",
        "Scores",
        "Violations",
        "Pictures",
        "Steps",
        "rolled back",
        "Relations",
        "Metrics",
        "Unmet wishes",
        "Warnings",
        "Notes",
        "Not placed",
        "armchair-0 near desk-0",
    ):
        assert words in parsed.text, words
    ids = [attrs["id"] for _, attrs in parsed.tags if "id" in attrs]
    assert len(ids) == len(set(ids))
    asked = set(re.findall(r'byId\("([\w-]+)"\)', text)) | set(re.findall(r'\btoggle\("(button[\w-]+)"', text))
    assert asked <= set(ids), "the scripts find what they look for"
    assert all(attrs.get("alt") for tag, attrs in parsed.tags if tag == "img")
    assert all(attrs.get("aria-label") for tag, attrs in parsed.tags if tag in ("canvas", "nav", "aside", "input"))


def test_nothing_comes_from_elsewhere(page) -> None:
    text, parsed = page
    for tag, attrs in parsed.tags:
        assert tag not in ("link", "iframe", "object", "embed", "base", "form")
        for name in ("src", "href", "srcset", "action"):
            assert (attrs.get(name) or "data:").startswith("data:")
        assert not [name for name in attrs if name.startswith("on")]
    assert not re.findall(r"(?:https?:)?//[\w-]+\.\w+", re.sub(r"base64,[\w+/=]+", "", text))
    assert "@import" not in text and not re.findall(r"url\(", text)


def test_only_our_own_script_may_run(page) -> None:
    _, parsed = page
    policy = next(a["content"] for t, a in parsed.tags if t == "meta" and a.get("http-equiv")) or ""
    running = [code for attrs, code in parsed.scripts if attrs.get("type") not in ("application/json", "text/plain")]
    assert len(running) == 1
    digest = base64.b64encode(hashlib.sha256(running[0].encode()).digest()).decode()
    assert f"script-src 'sha256-{digest}'" in policy and "default-src 'none'" in policy
    assert "innerHTML" not in running[0] and "insertAdjacentHTML" not in running[0] and "eval(" not in running[0]


def test_hostile_text_is_inert() -> None:
    parsed = Page(report_html(full(HOSTILE)))
    calm = Page(report_html(full()))
    assert [tag for tag, _ in parsed.tags] == [tag for tag, _ in calm.tags], "it adds no element"
    assert parsed.text.count(HOSTILE) >= 8, "it is shown as it is"
    assert len(parsed.scripts) == 3


def test_hostile_objects_are_inert() -> None:
    scene = furnished()
    name = HOSTILE + "\u2028"
    bad = SceneObject(
        id=HOSTILE,
        category=name,
        description=name,
        size=(1, 1, 1),
        pose=Pose.from_yaw(2, 2, 0, 0),
        attributes={"color": HOSTILE},
    )
    rule = Relation(type="near", subject=HOSTILE, target="desk-0")
    scene = scene.model_copy(update={"objects": (*scene.objects, bad), "relations": (*scene.relations, rule)})
    parsed = Page(report_html(ReportData(scene, check(scene).to_dict(), load=load)))
    assert len(parsed.scripts) == 3 and not any(tag == "img" for tag, _ in parsed.tags)
    data = json.loads(next(code for attrs, code in parsed.scripts if attrs.get("id") == "scene-data"))
    assert data["objects"][HOSTILE]["category"] == name


def test_relations_and_whether_they_hold() -> None:
    scene = furnished()
    report = check(scene)
    rows = relation_rows(scene, report.to_dict())
    held = sum(row.held is True for row in rows)
    tally = report.relations
    assert held == tally.hard.satisfied + tally.soft.satisfied and len(rows) == 3
    assert all(row.detail for row in rows if row.held is False)
    assert all(row.held is None for row in relation_rows(scene, {}))
    metrics = report.to_dict()
    for violation in metrics["violations"]:  # as files had it before violations named their relations
        violation.pop("relation", None)
    assert all(row.held is None for row in relation_rows(scene, metrics))


def test_each_phrase_bears_what_became_of_it(page) -> None:
    _, parsed = page
    marks = [a for t, a in parsed.tags if t == "span" and "phrase" in (a.get("class") or "").split()]
    assert [(a["class"], a["data-items"]) for a in marks] == [
        ("phrase met", "0"),
        ("phrase met", "1"),
        ("phrase unmet", "2 1"),  # the worst first
        ("phrase met", "1"),
        ("phrase unmet", "4 3"),
        ("phrase unmet joined", "4"),
        ("phrase not_understood", "5"),
    ]
    assert all(a["role"] == "button" and a["tabindex"] == "0" for a in marks)
    assert marks[2]["title"] == "unmet: mug-0 is white\nmet: words"
    assert marks[4]["title"] == "unmet: words (gap 1.82 m, allowed 0 to 1.5 m)\nassumed: words"
    rows = [a["data-items"] for t, a in parsed.tags if t == "button" and "data-items" in a]
    assert rows == ["2", "4", "5", "6", "0", "1"], "what is not met, what stands nowhere, and what a model saw"
    data = json.loads(next(code for attrs, code in parsed.scripts if attrs.get("id") == "scene-data"))
    assert [item["objects"] for item in data["request"]][-3:] == [["lamp-0", "lamp-1", "armchair-0"], [], []]


def test_the_words_of_the_request_stay_as_they_were() -> None:
    request, phrases = asked("<b>x</b> & so on")
    text = report_html(ReportData(furnished(), request=request, phrases=phrases, load=load))
    start = text.index('<section id="request"')
    whole = Page(text[start : text.index("</section>", start) + len("</section>")])
    plain = re.sub(r" \((?:met|unmet|assumed|not understood)\)|[\u2713\u2717\u2248?]", "", "".join(whole.words))
    assert request in plain and not whole.stack


def test_an_old_graph_without_spans_is_a_list_under_the_text() -> None:
    request, phrases = asked("words")
    old = tuple(replace(phrase, span=None) for phrase in phrases)
    parsed = Page(report_html(replace(full(), request=request, phrases=old, review=None)))
    assert not [a for t, a in parsed.tags if "phrase" in (a.get("class") or "").split()]
    assert [a["data-items"] for t, a in parsed.tags if t == "button" and "data-items" in a] == list("0123456")
    assert request in parsed.text
    assert 'id="request"' not in report_html(replace(full(), phrases=()))


def test_what_a_model_saw_stands_beside_the_scores(page) -> None:
    text, parsed = page
    part = text[text.index('id="seen"') : text.index('id="findings"')]
    assert "symbolic critic 8.0; 6 to 7, deviation 0.5" in part and "mean 4.8 of 10, standard deviation 0.2" in part
    assert "armchair-0, nobody" in part and "(layout, in 2 of 2 answers)" in part and 'class="tag bad">grave' in part
    data = json.loads(next(code for attrs, code in parsed.scripts if attrs.get("id") == "scene-data"))
    assert [item["objects"] for item in data["seen"]] == [["armchair-0"], []]
    without = full().review.model_copy(update={"seen": None})
    assert 'id="seen"' not in report_html(replace(full(), review=without))


def test_steps_show_what_changed(page) -> None:
    text, _ = page
    # The second step is rolled back, so the third is compared with the first.
    third = text[text.index(">again<") :]
    assert "<s>6.0</s> <b>8.0</b>" in third[:400]


def _unpack(packed: Any, k: int) -> tuple[np.ndarray, np.ndarray]:
    """A mesh of the pack, decoded anew: vertices and faces."""
    raw = zlib.decompress(base64.b64decode(packed.meshes))
    row = packed.data["meshes"][k]
    n, m, at = row["vertices"], row["faces"], row["offset"]
    planes = np.frombuffer(raw, "<u2", 3 * n, at).reshape(3, n)
    faces = np.frombuffer(raw, "<u2" if n <= 65536 else "<u4", 3 * m, at + 6 * n).reshape(3, m)
    return (np.asarray(row["low"])[:, None] + planes * np.asarray(row["step"])[:, None]).T, faces.T


def test_meshes_survive_the_packing() -> None:
    import trimesh

    packed = pack(furnished(), [], [], load)
    items = {item["id"]: item for item in packed.data["items"] if item["id"]}
    for object_id, name in (("armchair-0", "armchair"), ("desk-0", "desk"), ("picture-0", "picture")):
        points, faces = _unpack(packed, items[object_id]["mesh"])
        mesh = asset(name).mesh
        np.testing.assert_allclose(points.min(axis=0), mesh.bounds[0], atol=5e-5)
        np.testing.assert_allclose(points.max(axis=0), mesh.bounds[1], atol=5e-5)
        own = trimesh.Trimesh(mesh.vertices, mesh.faces, process=False)
        assert trimesh.Trimesh(points, faces, process=False).area == pytest.approx(own.area, rel=1e-3)
        runs = packed.data["meshes"][items[object_id]["mesh"]]["runs"]
        assert sum(count for _, count in runs) == len(mesh.faces)
    assert items["lamp-0"]["mesh"] == items["lamp-1"]["mesh"]
    assert items["picture-0"]["wall"] == 3 and items["desk-0"]["wall"] is None


def test_texture_coordinates_and_images_survive_the_packing() -> None:
    packed = pack(furnished(), [], [], load)
    raw = zlib.decompress(base64.b64decode(packed.meshes))
    item = next(i for i in packed.data["items"] if i["id"] == "armchair-0")
    row, mesh = packed.data["meshes"][item["mesh"]], asset("armchair").mesh
    laid = row["uv"]
    planes = np.frombuffer(raw, "<u2", 6 * laid["faces"], laid["offset"]).reshape(2, -1)
    found = (planes.T * laid["step"]).reshape(-1, 3, 2)
    numbers = [packed.data["materials"][material]["texture"] for material, _ in row["runs"]]
    assert laid["faces"] == sum(count for (_, count), k in zip(row["runs"], numbers, strict=True) if k > 0)
    wanted = texture_coordinates(mesh)
    assert wanted is not None
    order = np.argsort(mesh.face_material, kind="stable")
    wanted = wanted[order][[maps(mesh.materials[k].texture) is not None for k in mesh.face_material[order]]]
    apart = found - wanted
    np.testing.assert_allclose(apart - apart[0, 0], 0, atol=2e-3)
    assert apart[0, 0] == pytest.approx(np.round(apart[0, 0]), abs=2e-3), "whole repeats"
    for texture in packed.data["textures"]:
        head, _, data = texture["color"].partition(",")
        assert head == "data:image/jpeg;base64" and base64.b64decode(data)[:2] == b"\xff\xd8"
    assert max(m["texture"] for m in packed.data["materials"]) == len(packed.data["textures"])


def test_doors_and_windows_are_closed_bodies() -> None:
    import trimesh

    found = list(opening_meshes(furnished().room))
    assert [wall for wall, *_ in found] == [1, 2]
    for _, _, mesh in found:
        body = trimesh.Trimesh(mesh.vertices, mesh.faces, process=False)
        assert body.is_watertight and body.volume > 0
        assert all(piece.volume > 0 for piece in body.split(only_watertight=False))


@pytest.mark.parametrize("swing", ["in-left", "in-right", "out", "slide"])
def test_the_frame_of_a_door_lets_its_leaf_pass(swing: Literal["in-left", "in-right", "out", "slide"]) -> None:
    """The leaf is that of simulators, and at no angle or place of its way does it go through the frame around it."""
    import manifold3d
    import trimesh

    def solid(mesh, matrix=None):
        body = trimesh.Trimesh(mesh.vertices, mesh.faces).apply_transform(np.eye(4) if matrix is None else matrix)
        return manifold3d.Manifold.batch_boolean(
            [
                manifold3d.Manifold(manifold3d.Mesh64(np.asarray(p.vertices), np.asarray(p.faces, dtype=np.uint64)))
                for p in body.split()
            ],
            manifold3d.OpType.Add,
        )

    door = Door(id="d", wall=1, offset=0.0, width=0.9, height=2.0, swing=swing)
    room = Room(outline=((0, 0), (4, 0), (4, 4), (0, 4)), doors=(door,))
    [(_, _, frame)], [(wall, leaf, mesh)] = opening_meshes(room), door_leaves(room)
    assert wall == 1 and leaf.door == "d" and leaf.limits[1] > 0.5
    still = trimesh.transformations.translation_matrix(leaf.position)
    still = still @ trimesh.transformations.rotation_matrix(leaf.yaw, (0, 0, 1))
    for share in np.linspace(0, 1, 12):
        far = share * leaf.limits[1]
        moved = (
            trimesh.transformations.rotation_matrix(far, leaf.axis)
            if leaf.joint == "hinge"
            else trimesh.transformations.translation_matrix(far * np.asarray(leaf.axis))
        )
        assert (solid(frame) ^ solid(mesh, still @ moved)).volume() < 1e-7, share


def test_a_missing_asset_is_shown_as_parts_and_said() -> None:
    scene = furnished()
    lost = scene.objects[0].model_copy(update={"asset": "nobody:1"})
    scene = scene.model_copy(update={"objects": (lost, *scene.objects[1:])})

    def careful(object_id: str):
        if object_id == "nobody:1":
            raise InputError("asset: gone")
        return load(object_id)

    parsed = Page(report_html(ReportData(scene, load=careful)))
    assert "desk-0: its mesh is missing" in parsed.text
    assert "not checked" in parsed.text


def test_an_empty_room() -> None:
    scene = furnished("").model_copy(update={"objects": (), "relations": ()})
    assert not Page(report_html(ReportData(scene))).stack


def test_size_of_a_full_room(tmp_path) -> None:
    names = ("armchair", "bookcase", "desk", "office_chair", "potted_plant", "bed", "wardrobe", "monitor")
    objects = []
    for k in range(104):
        made = asset(names[k % 8], k // 24)
        pose = Pose.from_yaw(0.5 + k % 10, 0.5 + k // 10, 0, k)
        objects.append(made.object(f"o-{k}", pose=pose, mount="floor"))
    found = {asset(n, s).id: asset(n, s) for n in names for s in range(5)}
    scene = furnished().model_copy(update={"objects": tuple(objects), "relations": ()})
    data = replace(full(), scene=scene, metrics={}, load=found.__getitem__)
    write_report(tmp_path / "report.html", data)
    assert (tmp_path / "report.html").stat().st_size < 6e6
    assert [p.name for p in tmp_path.iterdir()] == ["report.html"]


def test_faults_without_metrics() -> None:
    assert faults_of({}) == []
