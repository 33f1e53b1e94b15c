"""Swatches: a pattern's colour and scale come through, and light from the side shows its relief."""

from __future__ import annotations

import numpy as np
import pytest

from sceneweaver.assets import Material
from sceneweaver.cli import main
from sceneweaver.render.swatches import swatch, swatches
from sceneweaver.scene import InputError


def test_a_swatch_has_the_colour_of_its_material_and_the_pattern_at_its_scale() -> None:
    red, blue = (Material("m", color, texture="metro tiles") for color in ((0.7, 0.2, 0.2), (0.2, 0.2, 0.7)))
    one, other = (np.asarray(swatch(m, 0.6, 120)).mean(axis=(0, 1)) for m in (red, blue))
    assert one[0] > 1.5 * one[2] and other[2] > 1.5 * other[0]
    # Six rows of tiles in 0.6 m: as many dark joints from top to bottom, three in half of that.
    for wide, joints in ((0.6, 6), (0.3, 3)):
        rows = np.asarray(swatch(red, wide, 240).convert("L")).astype(float).mean(axis=1)
        dark = np.append(rows, rows[0]) < rows.mean() - 2 * rows[40:60].std() - 4
        assert joints - 1 <= (np.diff(dark.astype(int)) == 1).sum() <= joints + 1


def test_relief_is_lit_from_the_side() -> None:
    flat, deep = (
        np.asarray(swatch(Material("m", (0.5, 0.5, 0.5), texture=t), 0.2, 120).convert("L")).std()
        for t in ("painted", "cut pile")
    )
    assert deep > 5 * flat


def test_names_and_what_has_no_pattern(tmp_path, capsys) -> None:
    assert [label for label, _ in swatches(["oak", "linen"], 32)] == ["oak, 0.8 m", "linen, 0.12 m"]
    with pytest.raises(InputError, match="did you mean"):
        next(iter(swatches(["oac"], 32)))
    with pytest.raises(InputError, match="has no pattern"):
        swatch(Material("bare", (0.5, 0.5, 0.5)), 1.0)
    path = tmp_path / "sheet.png"
    assert main(["assets", "sheet", "oak", "marble", "--materials", "--tile", "64", "-o", str(path)]) == 0
    assert path.is_file() and "128 x 72 pixels" in capsys.readouterr().out
