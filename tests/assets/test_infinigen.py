"""Running generators in an environment of their own: what crashes or hangs is reported, and the rest goes on."""

from __future__ import annotations

from pathlib import Path

import pytest

from sceneweaver.assets import Store
from sceneweaver.assets.sources import infinigen_host
from sceneweaver.scene import InputError, MissingDependencyError

# A worker without dependencies: it has numpy only because the test runs it with our own interpreter.
WORKER = """
import sys, time
module, factory, seed, out = sys.argv[1:]
if factory == "SofaFactory":
    sys.exit("the shader exploded")
if factory == "ToiletFactory":
    time.sleep(60)
import numpy as np
corners = np.array([[i & 1, i >> 1 & 1, i >> 2 & 1] for i in range(8)]) - 0.5
faces = [[0,2,3],[0,3,1],[4,5,7],[4,7,6],[0,1,5],[0,5,4],[2,6,7],[2,7,3],[0,4,6],[0,6,2],[1,3,7],[1,7,5]]
np.savez(out, vertices=corners * [0.6, 1.2, 0.7], faces=np.array(faces), face_material=np.zeros(12, dtype=int),
         looks=np.array([[0.4, 0.2, 0.1, 0.5, 0.0]]), names=np.array(["wood"]))
"""


@pytest.fixture
def worker(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A stand-in for uv that runs scripts with our own interpreter, and the script."""
    import sys

    script, uv = tmp_path / "worker.py", tmp_path / "uv"
    script.write_text(WORKER)
    uv.write_text(f'#!/bin/sh\n[ "$1" = sync ] && exit 0\nshift 3\nexec {sys.executable} "$@"\n')
    uv.chmod(0o755)
    monkeypatch.setenv("UV", str(uv))
    return script


def test_crashes_and_hangs_are_reported_and_skipped(tmp_path: Path, worker: Path) -> None:
    store = Store(tmp_path / "store")
    made = infinigen_host.generate(["desk", "sofa", "toilet"], [3], store, seconds=5, worker=worker)
    desk, sofa, toilet = made
    assert desk.asset is not None and desk.asset.size == pytest.approx((0.6, 1.2, 0.7))
    assert desk.asset.origin.source == "infinigen" and desk.asset.origin.front_confidence == 1.0
    assert sofa.asset is None and "the shader exploded" in sofa.reason
    assert toilet.asset is None and toilet.reason == "not done within 5 s"
    assert [row["id"] for row in store.rows()] == [desk.asset.id]


def test_unknown_generators_are_named(tmp_path: Path, worker: Path) -> None:
    with pytest.raises(InputError, match="infinigen: 'zebra' has no generator"):
        list(infinigen_host.generate(["zebra"], [0], Store(tmp_path), worker=worker))


def test_without_uv_it_says_so(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("UV", str(tmp_path / "none"))
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr(infinigen_host.sys, "prefix", str(tmp_path / "a" / "b"))
    with pytest.raises(MissingDependencyError, match="pip install uv"):
        list(infinigen_host.generate(["desk"], [0], Store(tmp_path)))


def test_every_generator_is_of_a_known_category() -> None:
    from sceneweaver.assets import categories

    assert set(infinigen_host.GENERATORS) <= set(categories())
    assert set(infinigen_host.COMMON) <= set(infinigen_host.GENERATORS)
