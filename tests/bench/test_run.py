"""Runs: what is counted, what is looked at, how they end, and that a folder goes on where it was left."""

from __future__ import annotations

import json
import time

import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver import problems
from sceneweaver.bench import Method, Settings, read_about, read_runs, run, runner
from sceneweaver.bench.results import COLUMNS, Row
from sceneweaver.bench.runner import Queue, devices_of
from sceneweaver.bench.starts import Starts
from tests.bench import optimizers
from tests.kernels.harness import ZOO
from tests.layout.made import BOX, relation, scene, thing

PAIR = scene([BOX, thing("other")], [relation("near", "box", "other", max=0.4)])
SHORT = Settings(candidates=8, seconds=0.2, restarts=False)


def one(tmp_path, optimizer, problem=PAIR, settings=SHORT, **others):
    """The one run of a comparison."""
    (found,) = read_runs(run([optimizer], [problem], tmp_path / "out", seeds=1, settings=settings, **others))
    return found


def test_a_run_is_rows_of_looks(tmp_path):
    found = one(tmp_path, optimizers.Momentum(), settings=Settings(candidates=8, seconds=60.0, restarts=False))
    assert set(found.columns) == set(COLUMNS) == set(Row.__annotations__)
    assert found.last("outcome") == "ended" and found.last("steps") == 20 and found.last("rounds") == 1
    assert list(found["checkpoint"]) == list(range(len(found["checkpoint"]))) and found["seconds"][0] == 0
    assert (found.last("energy_calls"), found.last("evaluations")) == (20, 160)  # looks measure as well: not counted
    assert (np.diff(found["seconds"]) > 0).all() and (np.diff(found["steps"]) > 0).all()
    assert set(found["outcome"][:-1]) == {"running"}
    assert found.last("objects") == 2 and found.last("variables") == 6 and found.last("candidates") == 8


def test_the_last_row_is_what_refine_gives(tmp_path):
    settings = Settings(candidates=8, seconds=60.0, restarts=False)
    found = one(tmp_path, optimizers.Momentum(), settings=settings)
    given = sw.compile(PAIR, device="cpu").sample(0, 8)
    solution = sw.refine(PAIR, init=given, optimizer=optimizers.Momentum(), device="cpu", explain=False)
    assert found.last("best_energy") == pytest.approx(solution.energy.min(), abs=1e-6)
    assert found.last("median_energy") == pytest.approx(np.median(solution.energy), abs=1e-6)
    assert found.last("valid") == (solution.status == 0).mean()


def test_looks_are_not_in_the_time(tmp_path):
    began = time.perf_counter()
    found = one(tmp_path, optimizers.Slow(), settings=Settings(candidates=2, seconds=60.0, restarts=False))
    others = time.perf_counter() - began - found.last("wall_seconds") - found.last("setup_seconds")
    assert found.last("wall_seconds") >= 0.06 and found.last("setup_seconds") >= 0.3 and others >= 0.3


def test_own_counts_are_taken(tmp_path):
    found = one(tmp_path, optimizers.Counting(), settings=Settings(candidates=2, seconds=60.0, restarts=False))
    assert (found.last("energy_calls"), found.last("evaluations")) == (140, 2000)


def test_a_budget_ends_what_goes_on(tmp_path):
    found = one(tmp_path, optimizers.Endless())
    assert found.last("outcome") == "budget" and 0.1 < found.last("seconds") <= 0.2 and found.last("budget") == 0.2
    few = Settings(candidates=8, seconds=60.0, evaluations=100)
    found = one(tmp_path / "few", optimizers.Endless(), settings=few)
    assert found.last("outcome") == "budget" and found.last("evaluations") == 104


def test_a_run_is_read_to_the_step(tmp_path):
    """Sleeping takes the same time always: what counts at a budget is the last step that ended by then."""
    settings = Settings(candidates=2, seconds=1.0, budgets=(0.25, 0.05), checkpoints=1)
    found = one(tmp_path, optimizers.Naps(), settings=settings)
    assert list(found["budget"][1:]) == [0.05, 0.25, 1.0] and found.last("outcome") == "budget"
    assert list(found["steps"]) == [0, 0, 2, 9] and (found["seconds"][1:] <= found["budget"][1:]).all()
    for budget, steps in ((0.05, 0), (0.25, 2), (1.0, 9)):
        cut = found.at(budget)
        assert (cut.last("steps"), cut.last("outcome"), cut.failed) == (steps, "budget", False)
    assert found.at(0.7) is found


def test_what_was_read_before_a_failure_counts(tmp_path):
    found = one(tmp_path, optimizers.NapsThenFails(), settings=Settings(candidates=2, seconds=60.0, budgets=(0.15,)))
    assert found.failed and found.at(60.0).failed and found.last("layout") is None
    assert not found.at(0.15).failed and found.at(0.15).last("steps") == 1


def test_enough_is_one_valid_layout(tmp_path):
    room = sw.Scene.load(ZOO / "bedroom-small.json")
    settings = Settings(candidates=4, seconds=60.0, enough=True)
    found = one(tmp_path, optimizers.SolvesOne(), room, settings)
    assert found.last("outcome") == "ended" and found.last("valid") == 0.25 and found.last("layout")
    assert found.last("seconds") < 60.0 and found.at(60.0) is found


def test_a_queue_goes_by_seeds_and_stays_with_problems():
    cases = [problems.load(f"packing/{name}") for name in ("n005-t60", "n010-t70")]
    everything = [(Method(m, m), case, seed) for case in cases for m in "ab" for seed in (0, 1)]
    queue, taken = Queue(list(everything)), []
    while len(taken) < 8:
        taken += [(k, *(one.name for one in queue.take(k)[:2])) for k in (0, 1)]
    assert queue.take(0) is None
    for k, name in ((0, "packing/n005-t60"), (1, "packing/n010-t70")):
        assert [(m, p) for worker, m, p in taken if worker == k] == [("a", name), ("b", name)] * 2
    alone = Queue(list(everything))
    assert [alone.take(0)[2] for _ in range(8)] == [0] * 4 + [1] * 4
    helped = Queue(everything[:4])
    assert [helped.take(k)[0].name for k in (0, 1)] == ["a", "b"], "who has nothing left helps"


def test_what_ends_early_begins_again_and_keeps_the_best(tmp_path):
    problem = ZOO / "bedroom-small.json"  # not to be solved by a few steps of descent
    few = Settings(candidates=4, seconds=60.0, evaluations=4 * 100)
    found = one(tmp_path, optimizers.Momentum(), str(problem), few)
    assert found.last("rounds") == 5 and found.last("steps") == 100 and found.last("outcome") == "budget"
    alone = Settings(candidates=4, seconds=60.0, restarts=False)
    first = one(tmp_path / "alone", optimizers.Momentum(), str(problem), alone)
    assert found.last("valid") >= first.last("valid") and found.last("best_energy") <= first.last("best_energy")
    assert found.last("median_energy") < first.last("median_energy")


def test_it_ends_when_all_are_valid(tmp_path):
    room = sw.Scene.load(ZOO / "bedroom-small.json")
    found = one(tmp_path, optimizers.Solved(), room, Settings(candidates=4, seconds=60.0))
    assert found.last("outcome") == "ended" and found.last("rounds") == 1 and found.last("valid") == 1
    assert found.last("distinct") == 1 and found.last("best_valid_energy") == found.last("best_energy")


def test_what_stands_on_surfaces_is_in_order_at_the_start():
    """Else no optimiser, which moves roots alone, could find a valid layout."""
    task = problems.load("surfaces/n014-t40")
    problem = task.compile("cpu")
    starts = Starts(task, Settings(candidates=6))
    (first, seed), (later, other) = starts.draw(3), starts.draw(3, attempt=2)
    assert seed == 3 and other != 3 and (first != later).any()
    roots = problem.free[0].any(axis=1)
    raw = task.start("sample", 6, 3)
    np.testing.assert_array_equal(first[:, roots], raw[:, roots])
    valid = np.repeat(task.witness[None], 6, axis=0)
    assert not problem.feasible(problem.carry(valid, like=raw)).any()
    for poses in (first, later):
        assert problem.feasible(problem.carry(valid, like=poses)).all()


@pytest.mark.parametrize("clock", ["wall", "cpu"])
def test_both_clocks_are_noted(tmp_path, clock):
    found = one(tmp_path, optimizers.Momentum(), settings=Settings(candidates=2, seconds=30.0, clock=clock))
    assert found.last("seconds") == found.last(f"{clock}_seconds") > 0
    assert found.last("cpu_seconds") != found.last("wall_seconds")


@pytest.mark.parametrize(
    ("optimizer", "reason"),
    [
        (optimizers.Failing(), "ZeroDivisionError: one over nothing"),
        (optimizers.Misshapen(), "ValueError: best gave an array of shape"),
        (Method("gone", "tests.bench.nothing:Here"), "ModuleNotFoundError"),
        (
            Method("gone", "tests.bench.optimizers:Here"),
            'InputError: optimizers: "tests.bench.optimizers" has no "Here"',
        ),
    ],
)
def test_a_failure_is_a_row(tmp_path, optimizer, reason):
    path = run([optimizer, "adam"], [PAIR], tmp_path, seeds=1, settings=SHORT)
    runs = {r.key[0]: r for r in read_runs(path)}
    wrong = runs.pop(Method("", optimizer).name or next(iter(set(runs) - {"adam"})))
    assert wrong.failed and wrong.last("outcome") == "failed" and wrong.last("reason").startswith(reason)
    assert not runs["adam"].failed


def test_a_process_that_hangs_or_crashes_is_a_row(tmp_path):
    named = [f"{kind.lower()}=tests.bench.optimizers:{kind}" for kind in ("Hanging", "Crashing", "Momentum")]
    short, long = (Settings(candidates=2, seconds=0.1, limit=limit) for limit in (3.0, 500.0))
    run(named[:1], [PAIR], tmp_path / "short", seeds=1, settings=short, isolate=True)
    run(named[1:], [PAIR], tmp_path / "long", seeds=1, settings=long, isolate=True)
    runs = {r.key[0]: r for name in ("short", "long") for r in read_runs(tmp_path / name)}
    assert runs["hanging"].last("outcome") == runs["crashing"].last("outcome") == "killed"
    assert runs["hanging"].last("reason") == "killed after 3 s"
    assert runs["crashing"].last("reason") == "the process ended by itself, exit code 7"
    assert runs["momentum"].last("outcome") in ("ended", "budget")


def test_the_limit_is_of_the_runs_clock(tmp_path):
    """By processor time a step that never ends is killed, however long others make it wait."""
    few = Settings(candidates=2, seconds=50.0, clock="cpu", limit=1.0)
    run(["endless=tests.bench.optimizers:Busy"], [PAIR], tmp_path, seeds=1, settings=few, isolate=True)
    (found,) = read_runs(tmp_path)
    assert found.last("outcome") == "killed" and found.last("reason") == "killed after 1 s"


def test_a_folder_goes_on_where_it_was_left(tmp_path):
    made = []

    def stop(done, total, row):
        made.append((row.method, row.seed))
        if len(made) == 2:
            raise KeyboardInterrupt

    names = ["adam", "langevin"]
    with pytest.raises(KeyboardInterrupt):
        run(names, [PAIR], tmp_path, seeds=2, settings=SHORT, progress=stop)
    assert len(read_runs(tmp_path)) == 2
    path = run(names, [PAIR], tmp_path, seeds=2, settings=SHORT, progress=stop)
    assert made == [("adam", 0), ("adam", 1), ("langevin", 0), ("langevin", 1)]
    before = {r.key: r.columns for r in read_runs(path)}
    run([*names, optimizers.Momentum()], [PAIR], tmp_path, seeds=2, settings=SHORT, progress=stop)
    assert made[4:] == [("Momentum", 0), ("Momentum", 1)]
    after = {r.key: r.columns for r in read_runs(path)}
    assert len(after) == 6
    for key, columns in before.items():
        for name in COLUMNS:
            np.testing.assert_array_equal(after[key][name], columns[name])
    with pytest.raises(sw.InputError, match="holds runs with another candidates"):
        run(names, [PAIR], tmp_path, settings=Settings(candidates=9, seconds=0.2, restarts=False))


def test_a_file_says_what_it_is_of(tmp_path):
    path = run(["adam"], [PAIR], tmp_path, seeds=1, settings=SHORT)
    about = read_about(path)
    assert about["settings"] == json.loads((tmp_path / "settings.json").read_text()) == SHORT.to_dict()
    assert {"python", "sceneweaver", "warp-lang", "numpy"} <= set(about["versions"])
    assert not any("commit" in name for part in about.values() for name in part)


@pytest.mark.parametrize("text", ["", "nonsense"])
def test_what_is_no_results(tmp_path, text):
    with pytest.raises(sw.InputError, match="no results"):
        read_runs(tmp_path)
    (tmp_path / "x.parquet").write_text(text)
    with pytest.raises(sw.InputError, match="x.parquet: not readable as Parquet"):
        read_runs(tmp_path / "x.parquet")


@pytest.mark.parametrize(
    ("field", "value"),
    [
        ("candidates", 0),
        ("candidates", 1.5),
        ("seconds", 0.0),
        ("seconds", float("nan")),
        ("limit", float("inf")),
        ("evaluations", 0),
        ("clock", "sun"),
        ("start", "anywhere"),
        ("checkpoints", 0),
        ("budgets", (0.0,)),
        ("budgets", (99.0,)),
    ],
)
def test_what_is_no_setting(field, value):
    with pytest.raises(sw.InputError, match=f"{field}: "):
        Settings(**{field: value})


def test_results_need_pyarrow(tmp_path, monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "pyarrow.parquet", None)
    with pytest.raises(sw.MissingDependencyError, match=r"pyarrow is not installed \(extra 'bench'\); install it with"):
        run(["adam"], [PAIR], tmp_path, settings=SHORT)


def test_a_gpu_has_one_worker(monkeypatch):
    monkeypatch.setattr(runner, "pick_devices", lambda name: ["cuda:0", "cuda:1"] if name == "cuda:all" else [name])
    assert devices_of("cpu", 3) == ["cpu"] * 3
    assert devices_of("cuda", 1) == ["cuda:0"] and devices_of("cuda", 2) == ["cuda:0", "cuda:1"]
    assert devices_of("cuda:1", 1) == ["cuda:1"]
    for name, jobs in (("cuda", 3), ("cuda:0", 2)):
        with pytest.raises(sw.InputError, match="a GPU has one worker"):
            devices_of(name, jobs)


def test_results_do_not_depend_on_what_ran_before(tmp_path):
    """A worker that has made other runs, and one that has not, find the same."""
    few = Settings(candidates=4, seconds=60.0, evaluations=4 * 60)
    tasks = [problems.load(name) for name in ("packing/n010-t70", "walls/n010-t55")]
    run(["search", "adam"], tasks, tmp_path / "long", seeds=2, settings=few, isolate=True)
    run(["adam"], tasks[1:], tmp_path / "short", seeds=[1], settings=few, isolate=True)
    (alone,) = read_runs(tmp_path / "short")
    other = next(r for r in read_runs(tmp_path / "long") if r.key == alone.key)
    for name in ("best_energy", "median_energy", "valid", "layout", "evaluations"):
        assert other.last(name) == alone.last(name)
