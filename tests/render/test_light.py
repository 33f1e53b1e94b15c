"""Plain light against what can be worked out, exposure, and that both kinds of light show one world."""

from __future__ import annotations

import numpy as np
import pytest

from sceneweaver.assets.body import Material, Mesh
from sceneweaver.assets.shapes import box
from sceneweaver.render.camera import Camera
from sceneweaver.render.instances import Instance
from sceneweaver.render.tracing import DirectLights, Lights, Portal, Quality, Triangles, trace
from sceneweaver.render.tracing.tracer import exposed
from sceneweaver.render.words import is_one_of

BLACK = (0.0, 0.0, 0.0)
GREY = Material("grey", (0.735, 0.735, 0.735), roughness=1.0)  # 0.5 in linear light
NO_LIGHT = {"sun_color": BLACK, "sky": BLACK, "ground": BLACK, "background": BLACK, "exposure": 1.0}
FROM_ABOVE = Camera.orthographic((0, 0, 2.0), (0, 0, 0), 2.0)


def solid(shape, material: Material = GREY) -> Instance:
    zeros = np.zeros(len(shape[1]), dtype=np.int32)
    return Instance(Mesh(np.asarray(shape[0], dtype=float), shape[1], zeros, zeros, (material,)), np.eye(4))


FLOOR = solid(box((-4, 4), (-4, 4), (-0.1, 0)))


def on_floor(*things: Instance, side: int = 32, levels: int = 3, **lights) -> np.ndarray:
    """Linear light of the floor from above, 2 m wide, in plain light."""
    given = DirectLights(**{**NO_LIGHT, **lights})
    return trace(
        [FLOOR, *things], FROM_ABOVE, side, side, lights=given, quality=Quality(bounces=16, levels=levels)
    ).linear


def test_an_open_floor_has_the_light_of_sky_and_sun() -> None:
    seen = on_floor(sky=(1.0, 0.8, 0.6), ground=(1.0, 0.8, 0.6), sun=(0, 1, 1), sun_color=(2.0, 2.0, 2.0))
    expected = 0.5 * (np.array([1.0, 0.8, 0.6]) + 2.0 / np.sqrt(2))
    assert seen.reshape(-1, 3) == pytest.approx(np.broadcast_to(expected, (32 * 32, 3)), rel=0.02)


def test_the_beam_falls_through_the_window_alone() -> None:
    # A window of 0.4 x 0.4 m, 1 m up in the plane x = -1; the beam comes down to the right at 45 degrees.
    portal = Portal((-1.0, -0.2, 1.0), (0.0, 0.4, 0.0), (0.0, 0.0, 0.4), (1.0, 0.0, 0.0))
    beam = {"beam": (-1.0, 0.0, 1.0), "beam_softness": 1e-3, "beam_color": (1.0, 1.0, 1.0), "portals": (portal,)}
    seen = on_floor(side=40, levels=0, **beam)[..., 1]
    x, y = np.meshgrid((np.arange(40) + 0.5) / 20 - 1, 1 - (np.arange(40) + 0.5) / 20)
    lit = (x > 0.12) & (x < 0.28) & (abs(y) < 0.1)
    far = (x < -0.15) | (x > 0.55) | (abs(y) > 0.35)
    assert seen[lit] == pytest.approx(0.5 / np.sqrt(2), rel=0.05) and seen[far].max() < 1e-6
    assert on_floor(side=40, **beam, beam_floor=0.1).max() == 0.0, "the floor lies below what it shines on"


def test_a_glow_reaches_three_metres_and_fades() -> None:
    middle = [on_floor(glows=((0.0, 0.0, z, 1.0),))[16, 16, 0] for z in (0.5, 1.0, 2.0, 3.1)]
    assert middle[0] > 2 * middle[1] > 4 * middle[2] > 0 == middle[3]


def test_near_surfaces_hide_the_sky_and_throw_back_their_colour() -> None:
    red = solid(box((0.3, 0.5), (-4, 4), (0, 3)), Material("red", (0.9, 0.05, 0.05), roughness=1.0))
    sky = {"sky": (1.0, 1.0, 1.0), "ground": (1.0, 1.0, 1.0), "reach": 2.0}
    near = on_floor(red, **sky)[:, 18].mean(axis=0)  # 0.15 m from the wall
    assert near[0] < 0.45 and near == pytest.approx(near[0], rel=0.02)  # plain: only darker
    thrown = on_floor(red, **sky, bounce=0.6)[:, 18].mean(axis=0)
    assert thrown[0] > 1.12 * thrown[1] and thrown[1] == pytest.approx(thrown[2], rel=0.02)


def test_both_kinds_of_light_show_one_world() -> None:
    pane = solid(box((-0.6, -0.5), (0.2, 1), (0, 1)), Material("pane", (0.9, 0.9, 0.9), 0.05, opacity=0.2))
    things = [solid(box((-0.4, 0.4), (-0.3, 0.3), (0, 0.6))), FLOOR, pane]
    camera = Camera.look_at((-2.5, -1.5, 1.6), (0, 0, 0.2), fov=0.8, aspect=1.5)
    draft, full = (
        trace(things, camera, 30, 20, lights=one, quality=Quality.draft()) for one in (DirectLights(), Lights())
    )
    assert set(np.unique(draft.instance)) == {-1, 0, 1, 2}
    for name in ("instance", "distance"):
        assert np.array_equal(getattr(draft, name), getattr(full, name)), name
    corners = np.concatenate([one.mesh.vertices[one.mesh.faces] for one in things])
    faces = np.arange(3 * len(corners)).reshape(-1, 3)
    for opaque in (None, 24):  # in one mesh, or the pane in its own
        hits = Triangles(corners.reshape(-1, 3), faces, opaque=opaque).first_hits([camera], 30, 20)
        assert np.allclose(hits.distance[0], full.distance, atol=1e-4)
        assert np.array_equal(np.where(hits.face[0] < 0, -1, hits.face[0] // 12), full.instance)  # 12 a box


def test_exposure_follows_the_light_and_not_its_strength() -> None:
    rng = np.random.default_rng(2)
    soft, key = rng.uniform(0.4, 0.6, (2000, 1)) * np.array([1.0, 0.9, 0.7]), np.zeros(2000, dtype=np.int32)
    exposure, gains = exposed(soft, key)
    brighter, same = exposed(4 * soft, key)
    assert brighter == pytest.approx(exposure / 4) and same == pytest.approx(gains)
    assert gains[0] < 1 < gains[2], "warm light looks whiter"
    shown = (soft * gains).mean(axis=0)
    assert shown.max() / shown.min() < (1.0 / 0.7), "though not white"
    grey, even = exposed(np.full((2000, 3), 0.5), key)
    assert even == pytest.approx(1.0) and grey * 0.5 * 0.82 == pytest.approx(0.47)
    assert exposed(soft, key - 1)[0] == 1.0, "nothing is seen"
    half = np.where(np.arange(2000) % 10 < 5, 0, -1)
    dark = np.where(half[:, None] < 0, 100.0, soft)  # what is no surface does not count
    assert exposed(dark, half)[0] == pytest.approx(exposure, rel=0.02)


@pytest.mark.parametrize(
    ("text", "kind", "expected"),
    [
        ("king_bed", "key", True),
        ("bedside lamp", "key", False),
        ("Coffee-Table", "all round", True),
        ("sofa", "all round", False),
        ("bath_mat", "minor", True),
        ("tv_stand", "powered", True),
        ("small_bathroom", "plain ceiling", True),
        ("living_room", "plain doors", False),
    ],
)
def test_words_of_kinds(text: str, kind: str, expected: bool) -> None:
    assert is_one_of(text, kind) is expected
