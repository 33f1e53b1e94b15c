"""The report: counts, the form of metrics.json, saving, and a light import."""

import dataclasses
import json
import subprocess
import sys

import jsonschema
import pytest

from sceneweaver.scene import Scene
from sceneweaver.verify import Report, Violation, check
from tests.reports import COUNTS
from tests.verify.agreement import zoo
from tests.verify.build import box, judge, rectangle, relation, scene

COUNT = {"type": "integer", "minimum": 0}
SHARE = {"type": ["number", "null"], "minimum": 0, "maximum": 1}
TALLY = {
    "type": "object",
    "properties": {"total": COUNT, "satisfied": COUNT},
    "required": ["total", "satisfied"],
    "additionalProperties": False,
}
MEASURED = ["quantity", "measured", "allowed", "unit"]
KINDS = [
    "collision",
    "out_of_bounds",
    "unsupported",
    "blocked_zone",
    "blocked_opening",
    "relation",
    "soft_relation",
    "dropped",
]
PROPERTIES = {
    "schema": {"const": "sceneweaver.metrics/1"},
    "valid": {"type": "boolean"},
    **dict.fromkeys(("requested", "placed", "dropped", "collisions", "out_of_bounds", "unsupported"), COUNT),
    **dict.fromkeys(("blocked_zones", "blocked_openings"), COUNT),
    "relations": {
        "type": "object",
        "properties": {"hard": TALLY, "soft": TALLY},
        "required": ["hard", "soft"],
        "additionalProperties": False,
    },
    "walkable_share": SHARE,
    "reachable_share": SHARE,
    "openable_share": SHARE,
    "blocked_links": {"type": ["array", "null"], "items": {"type": "object"}},
    "stability": {"type": ["object", "null"]},
    "scores": {"type": ["object", "null"]},
    "alignment": {"type": ["object", "null"], "additionalProperties": COUNT},
    "violations": {
        "type": "array",
        "items": {
            "type": "object",
            "properties": {
                "kind": {"enum": [*KINDS, "unstable", "blocked_link", "yaw_domain"]},
                "objects": {"type": "array", "items": {"type": "string"}, "minItems": 1},
                "detail": {"type": "string", "pattern": "^[^\n]+$"},
                "amount": {"type": "number", "minimum": 0},
                "hard": {"type": "boolean"},
                "relation": {
                    "type": "object",
                    "properties": {
                        "index": COUNT,
                        "type": {"type": "string"},
                        "subject": {"type": "string"},
                        "target": {"type": ["string", "array", "null"]},
                    },
                    "required": ["index", "type", "subject", "target"],
                    "additionalProperties": False,
                },
                "zone": {"type": "string"},
                "quantity": {"type": "string"},
                "measured": {"type": "number"},
                "allowed": {"type": "array", "items": {"type": ["number", "null"]}, "minItems": 2, "maxItems": 2},
                "unit": {"enum": ["m", "deg"]},
            },
            "required": ["kind", "objects", "detail", "amount", "hard"],
            "dependentRequired": {key: MEASURED for key in MEASURED},
            "additionalProperties": False,
        },
    },
    "seconds": {
        "type": "object",
        "required": ["total"],
        "additionalProperties": {"type": "number", "minimum": 0},
    },
    "seed": {"type": ["integer", "null"]},
    "device": {"type": ["string", "null"]},
    "candidates": {"type": ["integer", "null"]},
    "cut_off": {"type": ["string", "null"]},
    "versions": {"type": "object", "additionalProperties": {"type": "string"}},
}
METRICS = {
    "type": "object",
    "required": list(PROPERTIES),
    "properties": {**PROPERTIES, "warnings": {"type": "array"}},
    "additionalProperties": False,
}
DOOR = {"id": "door-0", "wall": 0, "offset": 1.0, "width": 0.9, "height": 2.0}


@pytest.fixture(scope="module")
def wrong() -> Scene:
    """A scene with one violation of each kind, and a dropped object."""
    zone = {"name": "doors", "polygon": rectangle(0.3, -0.5, 0.8, 0.5), "z": [0.0, 1.8]}
    objects = [
        box("a", (1, 1, 1), 2.0, 4.0),
        box("b", (1, 1, 1), 2.9, 4.0),
        box("out", (1, 1, 1), 7.8, 4.0),
        box("high", (1, 1, 1), 6.0, 6.0, z=0.5),
        box("wardrobe", (0.6, 1.0, 2.0), 0.3, 7.0, zones=[zone]),
        box("bag", (0.3, 0.3, 0.3), 0.9, 7.0),
        box("mat", (0.5, 0.5, 0.5), 1.4, 0.5),
    ]
    relations = [relation("near", "a", "b"), relation("facing", "a", "wardrobe"), relation("near", "a", "out", False)]
    made = scene(objects, relations, doors=[DOOR]).model_dump(by_alias=True, mode="json")
    dropped = [{"id": "sofa", "category": "sofa", "reason": "no wall is free"}]
    return Scene.model_validate({**made, "dropped": dropped})


def test_counts(wrong):
    report = check(wrong)
    assert not report.valid
    assert (report.requested, report.placed, report.dropped) == (8, 7, 1)
    counts = (report.collisions, report.out_of_bounds, report.unsupported)
    assert (*counts, report.blocked_zones, report.blocked_openings) == (1, 1, 1, 1, 1)
    assert (report.relations.hard.total, report.relations.hard.satisfied) == (2, 1)
    assert (report.relations.soft.total, report.relations.soft.satisfied) == (1, 0)
    assert sorted(v.kind for v in report.violations) == sorted(KINDS)
    assert report.stability is None
    assert report.scores is None
    sentences = {v.kind: v.detail for v in report.violations}
    assert sentences["dropped"] == "sofa could not be placed: no wall is free"
    assert sentences["blocked_zone"] == "bag stands 35.0 cm inside the zone 'doors' of wardrobe"
    assert sentences["soft_relation"].startswith("a near out: distance 4.8 m, allowed 0 to 1 m")


def test_violations_say_in_fields_what_they_say_in_words(wrong):
    report = check(wrong)
    by_kind = {v.kind: v for v in report.violations}
    for v in report.violations:
        assert v.hard is (v.kind != "soft_relation")
        assert (v.relation is None) is (v.kind not in ("relation", "soft_relation"))
        assert (v.measurement is None) is (v.kind == "dropped")
        if v.measurement is not None:
            assert not v.measurement.ok() and v.amount == v.measurement.excess
        if v.relation is not None:
            said = wrong.relations[v.relation.index]
            assert (said.type, said.subject, said.target) == (v.relation.type, v.relation.subject, v.relation.target)
            assert v.objects == (said.subject, *said.targets) and v.hard is said.hard
    assert by_kind["blocked_zone"].zone == "doors"
    data = {v["kind"]: v for v in report.to_dict()["violations"]}
    assert data["relation"]["relation"] == {"index": 1, "type": "facing", "subject": "a", "target": "wardrobe"}
    assert (data["relation"]["unit"], data["relation"]["allowed"][0]) == ("deg", None)
    soft = data["soft_relation"]
    assert (soft["quantity"], soft["allowed"], soft["unit"]) == ("distance", [0.0, 1.0], "m")
    assert soft["measured"] == pytest.approx(4.8) and soft["amount"] == pytest.approx(3.8)
    assert data["unsupported"]["measured"] == 0.5 and data["unsupported"]["allowed"] == [0.0, 0.0]
    assert data["blocked_zone"]["measured"] == pytest.approx(0.35)
    assert "measured" not in data["dropped"] and "relation" not in data["collision"]


def test_dropped_alone_makes_it_invalid():
    made = scene([box("a", (1, 1, 1), 4, 4)])
    assert check(made).valid
    data = made.model_dump(by_alias=True, mode="json")
    report = check(Scene.model_validate({**data, "dropped": [{"id": "x", "category": "x", "reason": "too big"}]}))
    assert not report.valid
    assert report.violations == (Violation("dropped", ("x",), "x could not be placed: too big", 0.0),)


def test_soft_relations_leave_it_valid():
    things = [box("a", (1, 1, 1), 2, 2), box("b", (1, 1, 1), 6, 6)]
    report = judge(things, [relation("near", "a", "b", hard=False)])
    assert report.valid
    assert [v.kind for v in report.violations] == ["soft_relation"]


def test_an_empty_scene():
    report = check(scene([]))
    assert report.valid
    assert (report.requested, report.walkable_share, report.reachable_share) == (0, 1.0, 1.0)


@pytest.mark.parametrize("name", ["bedroom-small", None])
def test_form_of_metrics(wrong, name):
    report = check(wrong if name is None else Scene.model_validate(zoo(name)))
    jsonschema.validate(json.loads(report.to_json()), METRICS)
    assert json.loads(report.to_json()) == report.to_dict()
    filled = dataclasses.replace(
        report,
        seed=3,
        device="cuda:0",
        candidates=1024,
        stability={"moved_over_0_1m": 0, "moved_over_0_01m": 1, "mean_shift_m": 0.001},
        scores={"critic": "symbolic"},
    )
    jsonschema.validate(json.loads(filled.to_json()), METRICS)
    assert filled.to_dict()["stability"]["moved_over_0_01m"] == 1


def test_names_are_those_of_the_json(wrong):
    report = check(wrong)
    for name in set(PROPERTIES) - {"schema"}:
        assert hasattr(report, name)
    assert report.relations["hard"]["total"] == report.relations.hard.total
    with pytest.raises(KeyError):
        report.relations["medium"]


def test_the_tally_of_relations_is_no_list_and_those_unmet_are_one(wrong):
    report = check(wrong, walkable=False)
    for read in (lambda: report.relations[0], lambda: list(report.relations), lambda: report.relations.hard[0]):
        with pytest.raises(TypeError, match=r"Tally is no list: it counts relations .* Report\.unmet has those"):
            read()
    with pytest.raises(KeyError, match="'firm' is not one of hard, soft"):
        report.relations["firm"]
    hard, soft = report.relations["hard"], report.relations.soft
    assert hard["total"] == hard.total
    missed = [v.hard for v in report.unmet]
    assert (missed.count(True), missed.count(False)) == (hard.total - hard.satisfied, soft.total - soft.satisfied)
    assert missed and all(wrong.relations[v.relation.index].type == v.relation.type for v in report.unmet)
    assert "unmet" not in report.to_dict()


def test_seconds(wrong):
    seconds = check(wrong).seconds
    assert sum(v for k, v in seconds.items() if k != "total") <= seconds["total"]
    assert "walkable" not in check(wrong, walkable=False).seconds


def test_save(tmp_path, wrong):
    path = tmp_path / "metrics.json"
    path.write_text("old")
    report = check(wrong)
    report.save(path)
    assert json.loads(path.read_text("utf-8")) == report.to_dict()
    assert [p.name for p in tmp_path.iterdir()] == ["metrics.json"]
    other = tmp_path / "other"
    other.touch()
    assert path.stat().st_mode == other.stat().st_mode


def test_a_failed_save_leaves_nothing_behind(tmp_path):
    report = Report(
        **dict.fromkeys(COUNTS, 0),
        valid=True,
        walkable_share=float("nan"),
    )
    path = tmp_path / "metrics.json"
    path.write_text("old")
    with pytest.raises(ValueError):
        report.save(path)
    assert path.read_text() == "old"
    assert [p.name for p in tmp_path.iterdir()] == ["metrics.json"]


def test_order_and_repeats_do_not_matter(wrong):
    first, second = check(wrong), check(wrong)
    assert first.violations == second.violations


def test_import_is_light():
    program = "import sys, sceneweaver.verify; print(*{name.partition('.')[0] for name in sys.modules})"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    heavy = {"shapely", "manifold3d", "trimesh", "scipy", "warp", "jax", "mujoco"}
    assert not heavy & set(done.stdout.split())
