"""``import sceneweaver`` has to stay cheap: heavy libraries are imported where they are used."""

import json
import subprocess
import sys

HEAVY = {"warp", "jax", "pxr", "mujoco", "mujoco_warp", "coacd", "trimesh", "shapely", "manifold3d"}

PROGRAM = """
import json, sys, time
start = time.perf_counter()
import sceneweaver
seconds = time.perf_counter() - start
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
