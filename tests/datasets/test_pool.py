"""The drawings that scenes of a data set choose from."""

import math
import pickle
import random
from functools import partial
from itertools import pairwise
from types import CodeType, FunctionType
from typing import Any

import pytest

from sceneweaver.assets import Library, categories
from sceneweaver.assets.parametric import makers
from sceneweaver.assets.roles import with_role
from sceneweaver.assets.sources.base import Wish
from sceneweaver.datasets.store.pool import dataset_library, offered, ratio_of, sizes_of

PALETTES = [f"oak/white paint/brass/cream,navy,mustard/{seed}" for seed in (5, 77, 123456)]


def test_a_pool_has_few_drawings_of_a_kind_and_they_are_all_loaded_by_id() -> None:
    rng, library = random.Random(1), dataset_library(4)
    found = {}
    for _ in range(60):
        size = (None, round(rng.uniform(1.4, 1.5), 3), round(rng.uniform(0.72, 0.729), 3))
        wish = Wish(size=size, palette=rng.choice(PALETTES), seed=rng.randrange(2**31), count=1)
        asset = library.choose("desk", 1, wish)[0]
        # What fits still fits; a drawing is of its size to 2 mm.
        assert asset.size[1] <= size[1] + 2e-3 and asset.size[2] <= size[2] + 2e-3
        found[asset.id] = asset
    assert 2 <= len(found) <= 4
    for name, asset in found.items():
        assert Library().load(name) is asset  # drawn once, whoever asks


def test_a_pool_is_told_to_other_processes_by_its_variants() -> None:
    assert pickle.loads(pickle.dumps(dataset_library(3))) is dataset_library(3)


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


def test_a_category_comes_in_few_sizes_over_its_whole_range() -> None:
    for name, known in categories().items():
        for axis, (low, high) in enumerate(known.size.ranges if known.size is not None else ()):
            ratio = ratio_of(name, axis)
            sizes = sizes_of(name, axis)
            assert (sizes[0], sizes[-1]) == (low, high) and sizes == tuple(sorted(set(sizes))), name
            assert len(sizes) <= 2 + math.log(high / low) / math.log(ratio), name
            # Where a range is too narrow for a size between, its ends are up to half a step further apart.
            assert all(b < ratio**1.5 * a + 0.05 for a, b in pairwise(sizes)), name


def test_the_next_smaller_size_is_taken() -> None:
    assert offered("desk", (None, 1.39, None)) == (None, 1.2, None)
    assert offered("desk", (None, 1.4, 0.729)) == (None, 1.4, 0.72)
    assert offered("desk", (None, 99.0, None)) == (None, 1.8, None)
    assert offered("desk", (None, 0.1, None)) == (None, 1.1, None)  # the least usual one
    depth, width, _ = offered("round_rug", (2.0, 1.5, None))
    assert depth == width and width is not None and width <= 1.5


def test_one_drawing_serves_all_styles_where_they_look_alike() -> None:
    library = dataset_library(4)

    def chosen(category: str, **wish):
        made = [
            library.choose(category, 1, Wish(style=style, palette=PALETTES[0], count=1, **wish))[0]
            for style in ("classic", "modern")
        ]
        assert [asset.attributes["style"] for asset in made] == ["classic", "modern"]
        return made

    for category in ("vase", "desk", "book"):
        first, second = chosen(category)
        assert first.id == second.id and "style" not in first.id
    said = library.choose("vase", 1, Wish(words="rustic", palette=PALETTES[0], count=1))[0]
    assert said.attributes["style"] == "rustic" and "style" not in said.id
    first, second = chosen("wardrobe")
    assert first.id != second.id and len(first.mesh.vertices) != len(second.mesh.vertices)
    first, second = chosen("armchair", color="red")
    assert "style=classic" in first.id and "style=modern" in second.id


def test_what_is_drawn_otherwise_in_another_style_is_known() -> None:
    asks = {name for name, maker in makers().items() if _reads_style(maker)}
    assert asks == with_role("drawn_by_style")


def _reads_style(maker: Any) -> bool:
    """Whether a drawing function, or one of the drawings' that it calls, reads the style of the drawing."""
    waiting, seen = [maker], set()
    while waiting:
        function = waiting.pop()
        if isinstance(function, partial):
            function = function.func
        if not isinstance(function, FunctionType) or function in seen:
            continue
        seen.add(function)
        for code in _codes(function.__code__):
            if "style" in code.co_names:
                return True
            called = [function.__globals__.get(name) for name in code.co_names]
            waiting += [f for f in called if ".parametric.families" in getattr(f, "__module__", "")]
        waiting.append(getattr(function, "__wrapped__", None))
    return False


def _codes(code: CodeType) -> list[CodeType]:
    return [code, *(c for const in code.co_consts if isinstance(const, CodeType) for c in _codes(const))]
