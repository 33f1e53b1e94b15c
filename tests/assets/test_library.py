"""Retrieval over sources, and ids as recipes."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest

from sceneweaver.assets import Library, Store, Wish, make
from sceneweaver.assets.imports.prepare import content_hash
from sceneweaver.assets.sources import ParametricSource, StoreSource
from sceneweaver.assets.sources.library import embedder
from sceneweaver.scene import InputError, MissingDependencyError

OURS = Library([ParametricSource()])


@pytest.fixture
def both(tmp_path) -> Library:
    """A store with one imported wardrobe, before our own library."""
    asset = make("wardrobe", 3)
    asset = replace(asset, id="", origin=replace(asset.origin, source="test", licence="CC-BY-4.0"))
    content = content_hash(asset)
    store = Store(tmp_path / "store")
    store.add(replace(asset, id=f"test:wardrobe-{content[:12]}"), content)
    return Library([StoreSource(store), ParametricSource()])


def test_an_id_draws_the_same_body_again() -> None:
    for card in OURS.find("bookshelves", Wish(words="white modern", size=(None, 0.9, 1.8), count=3)).cards:
        again = OURS.load(card.id)
        assert again.id == card.id and content_hash(again) == content_hash(ParametricSource().load(card.id))
        assert again.size[1:] == pytest.approx((0.9, 1.8), abs=1e-3) and again.attributes["color"] == "white"


def test_several_instances_match_or_vary() -> None:
    chairs = OURS.choose("dining chairs", 6)
    assert len({c.id for c in chairs}) == 1 and len(chairs) == 6
    books = OURS.choose("book", 6, same=False)
    assert len({b.id for b in books}) == 6


def test_the_store_comes_first_and_licences_count(both: Library) -> None:
    assert both.find("wardrobe").cards[0].source == "test"
    assert both.choose("wardrobe")[0].origin.licence == "CC-BY-4.0"
    only = both.find("wardrobe", Wish(licences=frozenset({"Apache-2.0"})))
    assert {card.source for card in only.cards} == {"parametric"}
    with pytest.raises(InputError, match="nothing suits 'wardrobe'"):
        both.choose("wardrobe", wish=Wish(licences=frozenset({"MIT"})))


def test_what_came_with_a_scene_is_offered_to_no_other(tmp_path) -> None:
    asset = make("wardrobe", 3)
    asset = replace(asset, id="", origin=replace(asset.origin, source="imported"))
    content = content_hash(asset)
    own = f"imported:wardrobe-{content[:12]}"
    store = Store(tmp_path / "store")
    store.add(replace(asset, id=own), content)
    library = Library([StoreSource(store), ParametricSource()])
    assert library.choose("wardrobe")[0].id.startswith("parametric:")
    assert library.load(own).category == "wardrobe"


def test_size_decides_between_equals(both: Library) -> None:
    asset = both.find("wardrobe").cards[0]
    other = (asset.size[0], 0.85 if asset.size[1] > 1.2 else 1.9, asset.size[2])
    assert both.find("wardrobe", Wish(size=other)).cards[0].source == "parametric"


def test_an_unknown_noun_gets_a_labelled_body() -> None:
    found = OURS.find("flux capacitor")
    assert found.match.how == "generic" and found.cards[0].category == "flux_capacitor"


def test_embeddings_are_used_where_there_are_any() -> None:
    def embed(texts):
        return np.array([[1.0, 0.0]] + [[float("walnut" in text), 0.1] for text in texts[1:]])

    found = Library([ParametricSource()], embed=embed).find("desk", Wish(words="something warm", count=12))
    texts = [card.text for card in found.cards]
    assert any("walnut" in t for t in texts) and "walnut" in texts[0]


@pytest.mark.parametrize(
    "asset_id", ["parametric:desk?seed=x", "parametric:desk?seed=1&tall=3", "parametric:desk?seed=-1"]
)
def test_a_wrong_recipe_is_named(asset_id: str) -> None:
    with pytest.raises(InputError, match="is no parametric id"):
        OURS.load(asset_id)


def test_an_id_of_nobody_is_named() -> None:
    with pytest.raises(InputError, match="no source has 'shop:desk'"):
        OURS.load("shop:desk")


def test_the_embedder_says_what_is_missing(tmp_path) -> None:
    with pytest.raises(InputError, match="no folder with a model"):
        embedder(str(tmp_path / "none"))
    try:
        import sentence_transformers  # noqa: F401  # pyright: ignore[reportMissingImports]
    except ModuleNotFoundError:
        with pytest.raises(MissingDependencyError, match="pip install sentence-transformers"):
            embedder(str(tmp_path))


@pytest.mark.parametrize("size", [(2.0, 3.0, 0.0), (-1.0, None, None), (None, float("nan"), None), (float("inf"),) * 3])
def test_a_wished_size_is_a_length(size) -> None:
    with pytest.raises(InputError, match=r"size: a (depth|width|height) of"):
        OURS.find("rug", Wish(size=size))


@pytest.mark.parametrize("spoil", [{"parts": 3}, {"links": [{}]}, {"size": None, "materials": None}])
def test_a_damaged_row_of_the_store_is_one_line(tmp_path, spoil) -> None:
    asset = make("stool", 3)
    content = content_hash(asset)
    name = f"test:stool-{content[:12]}"
    store = Store(tmp_path)
    store.add(replace(asset, id=name), content)
    assert store.load(name).size == asset.size
    (row,) = tmp_path.glob("objects/*/*/row.json")
    row.write_text(json.dumps({**json.loads(row.read_text()), **spoil}))
    with pytest.raises(InputError, match="damaged in the store"):
        store.load(name)
    row.write_text("[]")
    assert list(store.rows()) == []
    with pytest.raises(InputError, match="is not in the store"):
        store.load(name)


@pytest.mark.parametrize(
    ("spoil", "wrong"),
    [
        ({"hash": None}, "hash"),
        ({"category": 3}, "category"),
        ({"size": [1.0, "2", 3.0]}, "size"),
        ({"size": []}, "size"),
    ],
)
def test_what_a_damaged_row_lacks_is_said_where_assets_are_listed(tmp_path, spoil, wrong) -> None:
    asset = make("stool", 3)
    content = content_hash(asset)
    store = Store(tmp_path)
    store.add(replace(asset, id=f"test:stool-{content[:12]}"), content)
    (row,) = tmp_path.glob("objects/*/*/row.json")
    row.write_text(json.dumps({**json.loads(row.read_text()), **spoil}))
    for use in (lambda: list(store.rows()), StoreSource(store).cards):
        with pytest.raises(InputError, match=f"damaged in the store \\('{wrong}' is missing or wrong\\); delete"):
            use()
