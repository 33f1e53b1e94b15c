"""What docs/datasets.md and the data card tell people to run works on a data set, in its folder."""

import json
import re

import pytest
import yaml

from sceneweaver.datasets import AssetStore, Folder
from sceneweaver.datasets.files import finish, pack
from sceneweaver.datasets.store.scene_files import references, scene_files
from tests.datasets.small import make_small, small_spec
from tests.test_repository import ROOT, code_blocks

GUIDE = code_blocks((ROOT / "docs" / "datasets.md").read_text(), "python")


@pytest.fixture(scope="module")
def packed(tmp_path_factory):
    root = tmp_path_factory.mktemp("packed")
    store, named = AssetStore(root), []

    def files(scene):
        made = scene_files(scene, ("glb", "mjcf"), store, lambda asset: pytest.fail(asset))
        named.extend(references(made))
        return made

    pack(Folder(root), make_small(root, 4, files=files, row={"assets": named}))
    return root


@pytest.fixture
def offline(monkeypatch, tmp_path, packed):
    import datasets

    monkeypatch.setattr(datasets.config, "HF_DATASETS_CACHE", tmp_path / "cache")
    monkeypatch.setattr(datasets.config, "HF_HUB_OFFLINE", True)
    monkeypatch.chdir(packed)
    datasets.disable_progress_bars()


@pytest.mark.parametrize("number", range(len(GUIDE)))
def test_the_guide_runs(number, packed, offline, capsys):
    exec(compile(GUIDE[number], f"<example {number} in docs/datasets.md>", "exec"), {"__name__": "guide"})
    assert capsys.readouterr().out


def test_the_card_runs(packed, offline, capsys):
    for block in code_blocks((packed / "README.md").read_text(), "python"):
        exec(compile(block, "<example in the card>", "exec"), {"__name__": "card"})
    assert "00000" in capsys.readouterr().out


def test_the_fields_of_the_card_are_those_of_the_hub(packed, offline):
    from datasets import load_dataset
    from huggingface_hub import DatasetCard

    card = DatasetCard.load(packed / "README.md")
    assert card.data.license == "apache-2.0" and card.data.size_categories == ["n<1K"]
    loaded = load_dataset(str(packed))
    stated = {s["name"]: s["num_examples"] for s in card.data.to_dict()["dataset_info"]["splits"]}
    assert {name: len(rows) for name, rows in loaded.items()} == stated == {"train": 2, "test": 2}
    spec = yaml.safe_load(code_blocks(card.text, "yaml")[0])
    assert spec["name"] == "small" and spec["splits"] == {"train": 0.5, "test": 0.5}


def test_no_field_of_the_card_is_left_open(packed):
    assert not re.search(r"(?<!\{)\{[a-z]+\}(?!\})", (packed / "README.md").read_text().split("@misc")[0])


@pytest.mark.slow
def test_croissant_is_valid_and_its_records_are_those_of_the_index(packed):
    import mlcroissant

    found = mlcroissant.Dataset(packed / "croissant.json")
    assert not found.metadata.issues.errors
    records = list(found.records("scenes"))
    assert [int(r["scenes/index"]) for r in records] == [0, 1, 2, 3]
    assert records[1]["scenes/room_type"] == b"study" and b"Apache-2.0" in records[1]["scenes/licences"]
    assert all(
        not o.get("contentUrl", "").startswith("/")
        for o in json.loads((packed / "croissant.json").read_text())["distribution"]
    )


def test_layouts_have_a_card_as_well(tmp_path):
    from huggingface_hub import DatasetCard
    from pyarrow import Table, parquet

    folder = Folder(tmp_path)
    for place in (folder.data, folder.meta):
        place.mkdir()
    parquet.write_table(Table.from_pydict({"program": [0] * 5}), folder.data / "train-000000.parquet")
    program = {
        "program": 0,
        "status": "ok",
        "split": "train",
        "layouts": 5,
        "room_type": "gym",
        "categories": ["bench"],
    }
    failed = {"program": 1, "status": "failed", "reason": "time limit", "layouts": 0}
    parquet.write_table(Table.from_pylist([program | {"reason": None}, failed]), folder.meta / "programs.parquet")
    finish(folder, small_spec(10, product="layouts", rooms={"layouts": 5}))
    card = DatasetCard.load(tmp_path / "README.md")
    assert "5 valid layouts of 1 furnished rooms" in card.text and "| time limit | 1 |" in card.text
    assert card.data.configs[0]["data_files"] == [{"split": "train", "path": "data/train-*.parquet"}]
    named = json.loads((tmp_path / "croissant.json").read_text())
    assert [one["name"] for one in named["distribution"]] == ["meta/programs.parquet", "data/train-000000.parquet"]
    assert {"program", "layouts", "categories"} <= {field["name"] for field in named["recordSet"][0]["field"]}
