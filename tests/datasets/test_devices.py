"""Where data sets are laid out when nothing is said."""

from __future__ import annotations

from sceneweaver.datasets import Spec
from sceneweaver.datasets.engines.manifest import devices
from sceneweaver.layout import devices as of_the_engine


def test_scenes_are_laid_out_on_the_cpu_also_beside_a_gpu(monkeypatch):
    monkeypatch.setattr(of_the_engine, "pick_devices", lambda name: ["cuda:0", "cuda:1"])
    scenes, layouts = (
        {"schema": "sceneweaver.dataset/1", "name": "a", "count": 1, "product": p} for p in ("scenes", "layouts")
    )
    asked = {"requests": {"kinds": {"bedroom": 1}}}
    assert devices("auto", Spec.model_validate(scenes | asked)) == ["cpu"]
    assert devices("cuda:all", Spec.model_validate(scenes | asked)) == ["cuda:0", "cuda:1"]
    assert devices("auto", Spec.model_validate(layouts | asked)) == ["cuda:0", "cuda:1"]
