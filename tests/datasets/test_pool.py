"""The drawings that scenes of a data set choose from."""

import random

import pytest

from sceneweaver.assets import Library
from sceneweaver.assets.sources.base import Wish
from sceneweaver.datasets.store.pool import dataset_library

PALETTES = [f"oak/white paint/brass/cream,navy,mustard/{seed}" for seed in (5, 77, 123456)]


def test_a_pool_has_few_drawings_of_a_kind_and_they_are_all_loaded_by_id() -> None:
    rng, library = random.Random(1), dataset_library(4)
    found = {}
    for _ in range(60):
        size = (None, round(rng.uniform(1.4, 1.449), 3), round(rng.uniform(0.72, 0.739), 3))
        wish = Wish(size=size, palette=rng.choice(PALETTES), seed=rng.randrange(2**31), count=1)
        asset = library.choose("desk", 1, wish)[0]
        assert asset.size[1] <= size[1] + 1e-9 and asset.size[2] <= size[2] + 1e-9  # what fits still fits
        found[asset.id] = asset
    assert 2 <= len(found) <= 4
    for name, asset in found.items():
        assert Library().load(name) is asset  # drawn once, whoever asks


def test_what_words_ask_for_and_what_is_fitted_keeps_its_size() -> None:
    library = dataset_library(16)
    said = Wish(size=(None, 1.483, None), beyond=True, count=1)
    assert library.choose("desk", 1, said)[0].size[1] == pytest.approx(1.483, abs=2e-3)
    unit = Wish(size=(None, 0.613, None), suite=12345, count=1)
    assert library.choose("base_cabinet", 1, unit)[0].size[1] == pytest.approx(0.613, abs=2e-3)


def test_books_have_their_own_look_in_every_palette() -> None:
    library = dataset_library(16)
    ids = {library.choose("book", 1, Wish(palette=p, seed=3, count=1))[0].id for p in PALETTES}
    assert len(ids) == 1
