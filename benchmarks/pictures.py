"""Measuring pictures in a process of its own: ``python -m benchmarks.pictures TASK`` prints one line of JSON.

A task is a JSON object {"room": a scene of `DESIGNS`, "views": names, "width": W, "height": H, "quality": Q,
"device": D}. The tracer is built twice and each view drawn twice: the first time compiles kernels.
"""

from __future__ import annotations

import json
import sys
import time
from typing import Any

from benchmarks.children import device_mib, peak_mib
from benchmarks.settings import ROOT

DESIGNS = ROOT / "benchmarks" / "data" / "strict_eyes"


def measure(task: dict[str, Any]) -> dict[str, Any]:
    """Seconds to prepare a room and for each of its views, how bright these are, and the most memory held [MiB]."""
    import numpy as np

    from benchmarks.design_files import read_scene
    from sceneweaver.render.instances import instances_of
    from sceneweaver.render.tracing import Quality, Tracer, interior_lights
    from sceneweaver.render.viewpoints import eye_cameras
    from sceneweaver.render.views import Inside

    width, height, device = task["width"], task["height"], task["device"]
    scene = read_scene(DESIGNS / f"{task['room']}.json.gz")
    cameras = eye_cameras(scene, width / height)
    instances = Inside(scene, instances_of(scene), [cameras[view] for view in task["views"]], device).instances
    quality = getattr(Quality, task["quality"])()
    seconds: list[float] = []
    for _ in range(2):
        start = time.perf_counter()
        tracer = Tracer(instances, interior_lights(scene), device)
        seconds.append(time.perf_counter() - start)
    views = []
    for view in task["views"]:
        pictures, times = [], []
        for _ in range(2):
            start = time.perf_counter()
            pictures.append(tracer.picture(cameras[view], width, height, quality).rgb)
            times.append(time.perf_counter() - start)
        same = bool(np.array_equal(*pictures))
        views.append(
            {"view": view, "first": times[0], "seconds": times[1], "same": same, "mean": float(pictures[1].mean())}
        )
    triangles = sum(len(one.mesh.faces) for one in instances)
    return {
        "objects": len(scene.objects),
        "triangles": triangles,
        "prepared": seconds[1],
        "views": views,
        "peak_mib": peak_mib(),
        "device_mib": device_mib(device),
    }


if __name__ == "__main__":
    sys.stdout.write("\n" + json.dumps(measure(json.loads(sys.argv[1]))) + "\n")
