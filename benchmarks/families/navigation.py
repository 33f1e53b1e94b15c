"""Navigation: planned homes with boxes that stand about; what the judge, ways, maps and steps of a base cost."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

import numpy as np
import shapely

from benchmarks import parallel
from benchmarks.judging import Judge
from benchmarks.results import Column, Result
from benchmarks.settings import Settings
from sceneweaver.envs import HomeEnv
from sceneweaver.furnish.planning import plan_home
from sceneweaver.home import Home
from sceneweaver.navigation import Roadmap, navigation_graph, occupancy_map, point_goal_episodes
from sceneweaver.plans import Programme, envelope_for
from sceneweaver.scene import Scene
from sceneweaver.verify.home import check_home

PROGRAMMES = (
    "flat-studio",
    "flat-1-bedroom",
    "flat-2-bedrooms",
    "flat-3-bedrooms",
    "house-3-bedrooms",
    "clinic-doctor",
)
FLOOR = 4.0
"""Floor of a room [m2] that has one box."""
EPISODES = 20
"""Ways that are measured, and gone by the environment."""
SEEN = 1
"""Of these, ways that are searched over all lines of sight as well."""
AGREED = 1e-4
"""How far [m] the two may be apart."""

COLUMNS = (
    Column("home", "programme"),
    Column("rooms", "rooms", "count"),
    Column("boxes", "boxes", "count"),
    Column("judge", "judge [ms]", "number"),
    Column("roadmap", "roadmap [ms]", "number"),
    Column("way", "way [ms]", "number"),
    Column("graph", "graph [ms]", "number"),
    Column("map", "map [ms]", "number"),
    Column("step", "step [ms]", "number"),
    Column("apart", "off all lines of sight [m]", "number"),
    Column("success", "expert arrives", "share"),
    Column("spl", "SPL", "number"),
)


def run(settings: Settings, judge: Judge) -> Result:
    """Measure every programme."""
    del judge  # that of homes is what is measured
    result = Result(
        "navigation",
        "Navigation in homes",
        f"Plans of programmes with a box for each {FLOOR:g} m2 of floor, at random, for a base of 0.25 m; processor "
        "time. Lengths of ways are compared with Dijkstra's algorithm over all lines of sight. The expert of the "
        "environment follows the shortest way.",
    )
    table = result.add("homes", "By programme", COLUMNS)
    names = settings.programmes or PROGRAMMES[: 1 if settings.quick else None]
    table.rows += parallel.each(_row, [(name, settings.quick, settings.seed) for name in names], settings.jobs)
    for row in table.rows:
        if not row["apart"] <= AGREED:
            result.failures.append(f"{row['home']}: a way is {row['apart']:.6f} m off the shortest")
        if row["success"] < 1:
            result.failures.append(f"{row['home']}: the expert arrives in {row['success']:.0%}")
    return result


def _row(name: str, quick: bool, seed: int) -> dict[str, Any]:
    programme = Programme.example(name)
    plan = plan_home(programme, envelope_for(programme, seed), seed=seed, candidates=64, device="cpu").home
    home = crowded(plan, seed)
    count = 6 if quick else EPISODES
    judged = _timed(lambda: check_home(home))
    roadmap = _timed(lambda: _made(home))
    made = _made(home)
    episodes = point_goal_episodes(home, count, seed, roadmap=made).episodes
    ways = _timed(lambda: [made.path(one.start, one.goal) for one in episodes]) / max(1, len(episodes))
    success, spl, step = _gone(home, count, seed)
    return {
        "home": name,
        "rooms": len(home.rooms),
        "boxes": sum(len(room.scene.objects) for room in home.rooms if room.scene is not None),
        "judge": judged,
        "roadmap": roadmap,
        "way": ways,
        "graph": _timed(lambda: navigation_graph(home, roadmap=made)),
        "map": _timed(lambda: [occupancy_map(home, storey.id, ways=made.ways) for storey in home.storeys]),
        "step": step,
        "apart": max((_apart(made, one) for one in episodes[:SEEN]), default=0.0),
        "success": success,
        "spl": spl,
    }


def _timed(work: Callable[[], Any]) -> float:
    """Processor time of some work [ms]."""
    began = time.process_time()
    work()
    return 1000 * (time.process_time() - began)


def _made(home: Home) -> Roadmap:
    """The roadmap of a home with all its tangents, without stairs."""
    made = Roadmap(home, stairs=False)
    made.to([])
    return made


def crowded(home: Home, seed: int) -> Home:
    """A home with boxes at random, that may stand in each other and before doors."""
    rng = np.random.default_rng(seed)
    for room in home.rooms:
        floor = shapely.Polygon(room.outline)
        x0, y0, x1, y1 = floor.bounds
        things = []
        for k in range(int(floor.area / FLOOR) if room.type != "stairs" else 0):
            x, y, turn, depth, width = rng.uniform((x0, y0, 0, 0.2, 0.2), (x1, y1, np.pi, 0.7, 0.7)).tolist()
            pose = {"position": [x, y, 0.0], "quaternion": [0.0, 0.0, float(np.sin(turn / 2)), float(np.cos(turn / 2))]}
            things.append({"id": f"box-{k}", "category": "box", "size": [depth, width, 0.8], "pose": pose})
        shell = home.shell(room.id).model_dump(mode="json")
        data = {"schema": "sceneweaver.scene/1", "id": room.id, "room": shell, "objects": things}
        home = home.with_scene(room.id, Scene.model_validate(data))
    return home


def _gone(home: Home, count: int, seed: int) -> tuple[float, float, float]:
    """Share of episodes in which the expert arrives, its mean SPL, and the time of a step without its search [ms]."""
    env, arrived, spl = HomeEnv(home, count=count, seed=seed), 0, 0.0
    for number in range(len(env.episodes[0].episodes)):
        _, info = env.reset(options={"episode": number})
        done = cut = False
        while not (done or cut):
            *_, done, cut, info = env.step(env.expert_action())
        arrived, spl = arrived + info["success"], spl + info["spl"]
    env.reset(seed=seed)
    actions = np.random.default_rng(seed).choice([1, 1, 2, 3], 300).tolist()
    step = _timed(lambda: [env.step(action) for action in actions]) / len(actions)
    total = len(env.episodes[0].episodes)
    return arrived / total, spl / total, step


def _apart(roadmap: Roadmap, episode: Any) -> float:
    """How far [m] the length of a way is from that over all lines of sight between all corners of its region."""
    from scipy.sparse import csr_array
    from scipy.sparse.csgraph import dijkstra

    start, number = roadmap.region(episode.start)
    goal, other = roadmap.region(episode.goal)
    if number != other:
        return 0.0 if not np.isfinite(roadmap.to([episode.goal]).distance(episode.start)) else np.inf
    region = next(r for f in roadmap.ways.floors.values() for r in f.regions if r.distance(shapely.Point(start)) < 1e-9)
    rings = [np.asarray(ring.coords)[:-1] for ring in (region.exterior, *region.interiors)]
    nodes = np.concatenate([[start, goal], *rings])
    grown = region.buffer(1e-7, join_style="mitre")
    shapely.prepare(grown)
    i, j = np.triu_indices(len(nodes), 1)
    lines: Any = shapely.linestrings(np.stack([nodes[i], nodes[j]], axis=1))
    seen = shapely.covers(grown, lines)
    size = len(nodes)
    graph = csr_array((np.maximum(shapely.length(lines[seen]), 1e-12), (i[seen], j[seen])), shape=(size, size))
    known = float(dijkstra(graph, directed=False, indices=0)[1])
    return abs(known - episode.geodesic)
