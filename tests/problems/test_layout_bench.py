"""Layout Bench: its splits, its hashes, its tiers."""

from __future__ import annotations

import hashlib

import pytest

from sceneweaver import problems
from sceneweaver.cli import main
from sceneweaver.problems import layout_bench, store
from sceneweaver.scene import InputError
from tests.oracle.check_scene import check as oracle
from tests.problems.test_zoo import KNOWN


def test_a_split_is_made_anew_with_its_published_hash():
    cases = layout_bench.verify_split("tuning")
    assert len(cases) == sum(map(len, layout_bench.RECIPE["tuning"].values()))


def test_one_hash_is_over_all():
    data = dict(layout_bench.manifest())
    assert layout_bench.whole_hash(data) == data["hash"] and data["version"] == layout_bench.VERSION
    data["test"] = {**data["test"], "hash": "0" * 64}
    assert layout_bench.whole_hash(data) != data["hash"]


def test_dev_is_in_the_zoo_and_is_what_its_recipe_makes():
    rows = layout_bench.rows("dev")
    assert {name: row["hash"] for name, row in rows.items()} == {n: store.manifest()[n]["hash"] for n in rows}
    for case in layout_bench.make("dev", family="facilities"):
        assert case.hash == rows[case.name]["hash"] == problems.load(case.name).hash


def test_there_are_enough_that_are_hard():
    assert len(layout_bench.names("hard")) + len(layout_bench.names("open")) >= 60
    kinds = {name.partition("/")[0] for name in layout_bench.names() if layout_bench.tier_of(name) != "solved"}
    assert kinds >= {"rooms", "halls", "floor_plans", "warehouses", "chips", "facilities", "infeasible"}


def test_test_has_a_problem_of_each_row_and_publishes_no_hash_of_one():
    dev, test = (layout_bench.rows(split) for split in ("dev", "test"))
    assert [n.removesuffix("-dev") for n in dev] == [n.removesuffix("-test") for n in test]
    assert not any("hash" in row for row in test.values())
    assert len(layout_bench.manifest()["test"]["hash"]) == 64


def test_another_secret_makes_other_problems(tmp_path, monkeypatch):
    path = tmp_path / "secret"
    path.write_text("not the secret that it is made of\n")
    (mine, *_), (dev, *_) = (layout_bench.make(s, path, family="relations") for s in ("test", "dev"))
    problems.verify(mine)
    assert mine.name.removesuffix("-test") == dev.name.removesuffix("-dev") and mine.hash != dev.hash
    monkeypatch.setitem(layout_bench.PUBLISHED, "tuning", "another")
    with pytest.raises(InputError, match="the problems of tuning have hash"):
        layout_bench.verify_split("tuning")


def test_where_the_generator_finds_nothing_the_next_seed_is_taken(monkeypatch):
    tried = []

    def generate(family, objects, tightness, seed, **more):
        tried.append(seed)
        if len(tried) < 3:
            raise InputError("tightness: no room")
        return problems.generate(family, objects, tightness, seed, **more)

    monkeypatch.setattr(layout_bench, "generate", generate)
    (case,) = layout_bench.make("tuning", family="relations")
    name = "relations/n018-t40-d3-tuning"
    assert case.name == name and tried == [
        layout_bench.seed_of(layout_bench.PUBLISHED["tuning"], name, k) for k in range(3)
    ]


def test_seeds_are_of_the_secret_and_the_name():
    digest = hashlib.sha256(b"secret\nchips/n010").digest()
    assert layout_bench.seed_of("secret", "chips/n010") == int.from_bytes(digest[:4])


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: layout_bench.make("train"), "split: 'train'"),
        (lambda: layout_bench.make("test"), "seed-file"),
        (lambda: layout_bench.make("dev", family="boats"), "family: 'boats'"),
        (lambda: layout_bench.names("easy"), "tier: 'easy'"),
    ],
)
def test_bad_input_is_one_line(call, text):
    with pytest.raises(InputError, match=text) as error:
        call()
    assert "\n" not in str(error.value)


def test_a_short_secret_is_none(tmp_path):
    (tmp_path / "secret").write_text("1234\n")
    with pytest.raises(InputError, match="at least 16"):
        layout_bench.secret_of("test", tmp_path / "secret")


def test_the_command_verifies_a_split(capsys):
    assert main(["problems", "verify", "--split", "tuning"]) == 0
    assert capsys.readouterr().out == "8 of 8 problems are in order\n"
    assert main(["problems", "verify", "--split", "test"]) == 2
    assert main(["problems", "verify", "packing/n005-t60", "--split", "dev"]) == 2


def test_the_independent_checker_finds_all_published_layouts_valid():
    cases = [case for case in map(problems.load, layout_bench.names()) if case.feasible]
    layouts = [(c, poses) for c in cases for poses in (c.witness, c.best_layout) if poses is not None]
    assert len(cases) == 81 and len(layouts) > len(cases)
    assert [c.name for c, poses in layouts if not _by_the_oracle(c, poses)] == []
    spoilt = [_by_the_oracle(c, c.start("random", 1, 0)[0]) for c in cases[:5]]
    assert not any(spoilt)


def _by_the_oracle(case, poses) -> bool:
    scene = case.layout(poses).to_json()
    scene["relations"] = [r for r in scene["relations"] if r["type"] in KNOWN]
    return oracle(scene)["valid"]
