"""``import sceneweaver`` has to stay cheap: heavy libraries are imported where they are used."""

import json
import os
import subprocess
import sys
from pathlib import Path

HEAVY = {"warp", "jax", "pxr", "mujoco", "mujoco_warp", "coacd", "trimesh", "shapely", "manifold3d", "scipy"}

ROOT = Path(__file__).parents[2]

PROGRAM = """
import json, sys, time
start = time.perf_counter()
import sceneweaver
seconds = time.perf_counter() - start
import sceneweaver.assets, sceneweaver.language
print(json.dumps({"seconds": seconds, "modules": sorted({name.partition(".")[0] for name in sys.modules})}))
"""


def test_import_pulls_in_nothing_heavy(tmp_path, record_property):
    result = subprocess.run(
        [sys.executable, "-c", PROGRAM], cwd=tmp_path, capture_output=True, text=True, timeout=120, check=False
    )
    assert result.returncode == 0, result.stderr
    seen = json.loads(result.stdout)
    record_property("import_seconds", round(seen["seconds"], 3))
    print(f"import sceneweaver: {seen['seconds']:.3f} s")
    assert not HEAVY & set(seen["modules"])


def test_the_engine_starts_without_a_word():
    program = (
        "import sceneweaver.render.tracing; from sceneweaver.layout.devices import pick_devices; pick_devices('auto')"
    )
    environment = {k: v for k, v in os.environ.items() if k != "SCENEWEAVER_DEBUG"}
    result = subprocess.run([sys.executable, "-c", program], cwd=ROOT, env=environment, capture_output=True, check=True)
    assert result.stdout == result.stderr == b""
