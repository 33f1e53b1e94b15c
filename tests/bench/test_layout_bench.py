"""The protocol of Layout Bench: tests of pairs, quality by the judge, runs that are gone on with, tuning, the page."""

from __future__ import annotations

import dataclasses
import itertools
import json
import time

import numpy as np
import pytest
from scipy import stats

from sceneweaver import bench, problems
from sceneweaver.bench import results, worker
from sceneweaver.bench.board import BEGIN, END, anytime, places, write_page
from sceneweaver.bench.pairs import holm, wilcoxon
from sceneweaver.bench.protocol import problems_of, read_budgets, read_protocol, run_protocol, verdicts, whole_seeds
from sceneweaver.bench.quality import judged
from sceneweaver.bench.tuning import draw, trials_of, tune
from sceneweaver.cli import main
from sceneweaver.scene import InputError
from tests.bench import optimizers

FACTORY = "facilities/n012-t85-equal-dev"


def run_of(case, poses=None, **more) -> results.Run:
    layout = None if poses is None else np.asarray(poses, dtype="<f4").tobytes()
    claims = {"valid": float(poses is not None), "known_objective": case.best_objective, "outcome": "budget"}
    if poses is not None and case.objective:
        claims["best_objective"] = float(case.objective_of(poses[None])[0])
    row = results.Row("m", case.name, case.family, case.hash, 1, 1, None, 0, 4, layout=layout)
    row = dataclasses.replace(row, **{**claims, **more})
    return results.Run({name: np.array([getattr(row, name)], dtype=object) for name in results.COLUMNS})


def test_quality_is_the_judges():
    case = problems.load(FACTORY)
    assert case.best_objective is not None and case.witness is not None
    value = float(case.objective_of(case.witness[None])[0])
    good = judged(run_of(case, case.witness), case)
    assert good.valid and not good.fault and good.quality == pytest.approx(min(case.best_objective / value, 1.0))
    if case.best_layout is not None:
        assert judged(run_of(case, case.best_layout), case).quality == pytest.approx(1.0)
    plain = problems.load("packing/n005-t60")
    assert judged(run_of(plain, plain.witness), plain).quality == 1.0
    assert judged(run_of(plain), plain) == bench.quality.Judged(False, None, 0.0)


@pytest.mark.parametrize(
    ("lie", "fault"),
    [
        ({"best_objective": 1.0}, "says 1.0 of an objective"),
        ({"problem_hash": "0"}, "another hash"),
        ({"layout": b"1234"}, "4 bytes"),
        ({"layout": None}, "has no layout"),
    ],
)
def test_what_is_not_so_is_noticed(lie, fault):
    case = problems.load(FACTORY)
    found = judged(run_of(case, case.witness, **lie), case)
    assert fault in found.fault and (found.quality == 0.0 or "says" in lie or "best_objective" in lie)


def test_a_layout_that_is_not_valid_counts_for_nothing_whatever_is_said_of_it():
    case = problems.load(FACTORY)
    found = judged(run_of(case, case.start("random", 1, 0)[0]), case)
    assert not found.valid and found.quality == 0.0 and "judge" in found.fault
    nan = np.full_like(case.witness, np.nan)
    assert judged(run_of(case, nan), case).quality == 0.0


def test_what_is_fixed_may_not_move():
    name = next(n for n in problems.layout_bench.names() if n.startswith("warehouses/n014"))
    case = problems.load(name)
    dock = next(i for i, o in enumerate(case.scene.objects) if o.fixed)
    moved = np.array(case.witness)
    moved[dock, 1] += 0.05
    assert judged(run_of(case, case.witness), case).valid and not judged(run_of(case, moved), case).valid


def test_holm_against_its_definition_and_wilcoxon_against_all_signs():
    rng = np.random.default_rng(1)
    p = rng.uniform(0, 0.2, 7)
    order = np.argsort(p)
    wanted = np.maximum.accumulate(np.minimum((7 - np.arange(7)) * p[order], 1.0))
    assert np.array(holm(list(p)))[order] == pytest.approx(wanted)
    off = rng.normal(0.3, 1.0, 10)
    ranks = stats.rankdata(np.abs(off))
    seen = abs(ranks @ np.sign(off))
    exact = np.mean([abs(ranks @ np.array(s)) >= seen - 1e-9 for s in itertools.product((-1, 1), repeat=10)])
    assert wilcoxon(off) == pytest.approx(exact, abs=0.03)
    assert wilcoxon(np.zeros(5)) == 1.0


def test_pairs_are_of_what_both_were_run_on():
    a = np.array([[0.9, 0.8], [0.7, np.nan], [0.2, 0.2]])
    b = np.array([[0.5, 0.5], [0.7, 0.1], [np.nan, np.nan]])
    (pair,) = bench.paired({"b": b, "a": a})
    assert (pair.first, pair.second, pair.problems) == ("a", "b", 2)
    assert pair.difference == pytest.approx(np.mean([0.4, 0.3, 0.0])) and pair.low <= pair.difference <= pair.high


@pytest.mark.slow
def test_the_protocol_goes_through_and_goes_on(tmp_path):
    cases = [problems.load(FACTORY), problems.load("packing/n020-t60-dev")]
    went = []
    say = lambda done, total, row: went.append((row.method, row.problem, row.seed))  # noqa: E731
    arguments = {"budgets": [0.05, 0.1], "seeds": 1, "candidates": 4}
    assert run_protocol(["search"], cases[:1], tmp_path, progress=say, **arguments)
    assert len(went) == 1
    assert run_protocol(["search", "adam"], cases, tmp_path, progress=say, jobs=2, **arguments)
    assert len(went) == 4 and run_protocol(["search", "adam"], cases, tmp_path, progress=say, **arguments)
    assert len(went) == 4, "what is there is not run again"
    found, known = read_protocol(tmp_path), {case.name: case for case in cases}
    assert read_budgets(tmp_path) == [0.05, 0.1]
    judged_runs = verdicts(tmp_path, found, [0.05, 0.1], known)
    assert list(judged_runs) == [0.05, 0.1] and not any(v.fault for rows in judged_runs.values() for v in rows.values())
    board = places([run.at(0.1) for run in found], judged_runs[0.1], 0.1)
    assert {row.method for row in board} == {"search", "adam"} and board[0].quality >= board[1].quality
    assert board[0].quality > 0.3 and board[0].killed == board[0].failed == 0
    curve = anytime(found, np.array([1e-9, 0.05, 0.1]), known)[board[0].method]
    before = places([run.at(0.05) for run in found], judged_runs[0.05], 0.05)
    first = next(row.quality for row in before if row.method == board[0].method)
    assert curve == pytest.approx([0.0, first, board[0].quality], abs=1e-3), "a curve meets the table at each budget"
    data = bench.leaderboard(tmp_path, known)
    text = bench.board_markdown(json.loads(json.dumps(data)))
    assert (
        "**0.1 s**, 2 problems, 1 seeds:" in text
        and "**0.05 s**" in text
        and f"{board[0].method} - {board[1].method}" in text
    )
    page = tmp_path / "page.md"
    page.write_text(f"# Title\n{BEGIN}\nold\n{END}\nrest\n")
    assert main(["bench", "layout-bench", "page", str(tmp_path), "--into", str(page)]) == 0
    assert "old" not in page.read_text() and "p (Holm)" in page.read_text() and page.read_text().endswith("rest\n")
    assert main(["bench", "layout-bench", "verify", str(tmp_path)]) == 0


def test_a_table_is_of_seeds_that_are_whole():
    case = problems.load(FACTORY)
    runs = [run_of(case, method=m, seed=seed) for m, seed in (("a", 0), ("b", 0), ("a", 1), ("b", 2), ("a", 2))]
    assert [run.key[2] for run in whole_seeds(runs)] == [0, 0, 2, 2]
    assert len(whole_seeds(runs[2:4])) == 2, "where none is whole all count"


def test_time_that_is_over_leaves_the_rest_for_another_time(tmp_path):
    cases = [problems.load(FACTORY)]
    assert not run_protocol(["search"], cases, tmp_path, budgets=[0.05], seeds=1, candidates=4, minutes=1e-6)
    assert read_protocol(tmp_path, required=False) == []
    began = time.monotonic()
    endless = bench.Method("endless", optimizers.Endless())
    assert not run_protocol([endless], cases, tmp_path, budgets=[50.0], seeds=1, candidates=4, minutes=0.05)
    assert time.monotonic() - began < 30.0 and read_protocol(tmp_path, required=False) == []


def test_what_takes_too_much_memory_is_killed_and_says_so(tmp_path, monkeypatch):
    taken = iter([2**30])
    monkeypatch.setattr(worker, "resident", lambda pid: next(taken, 4 * 2**30))
    settings = bench.Settings(candidates=4, seconds=30.0, clock="cpu", memory=2.0)
    path = bench.run([optimizers.Endless()], ["packing/n005-t60"], tmp_path, seeds=1, settings=settings, isolate=True)
    (run,) = bench.read_runs(path)
    assert run.last("outcome") == "killed" and "3.0 GiB of memory, 2 are allowed" in run.last("reason")
    (place,) = places([run], {run.key: judged(run, problems.load("packing/n005-t60"))}, 30.0)
    assert (place.killed, place.failed, place.quality) == (1, 0, 0.0)


@dataclasses.dataclass(frozen=True)
class Told(optimizers.Momentum):
    """Keeps what it is told, and gives it away as an error."""

    rate: float = 1.0
    told: tuple = ()
    space = {"rate": ("log", 0.1, 10.0), "told": ("choice", [(), (1,)])}

    def __post_init__(self) -> None:
        if self.rate > 5.0:
            raise ValueError("too fast")

    def configure(self, objective, seconds):
        return dataclasses.replace(self, told=(len(objective), seconds))

    def init(self, problem, poses, key):
        raise RuntimeError(f"{self.told} {self.rate:g}")


def test_a_method_is_told_of_objective_and_budget(tmp_path):
    case = problems.load(FACTORY)
    settings = bench.Settings(candidates=2, seconds=0.25)
    path = bench.run([bench.Method("told", Told(), {"rate": 2.0})], [case], tmp_path, seeds=1, settings=settings)
    (run,) = bench.read_runs(path)
    assert run.last("reason") == f"RuntimeError: ({len(case.objective)}, 0.25) 2"


def test_settings_are_drawn_from_what_a_method_declares():
    trials = trials_of(bench.Method("told", Told()), 6, seed=3)
    assert [t.name for t in trials] == [f"told#{k}" for k in range(6)] and trials[0].settings == {}
    assert all(0.1 <= t.settings["rate"] <= 5.0 for t in trials[1:]), "what does not go together is left out"
    assert [t.settings for t in trials] == [t.settings for t in trials_of(bench.Method("told", Told()), 6, seed=3)]
    assert len(trials_of(bench.Method("momentum", optimizers.Momentum()), 6)) == 1
    with pytest.raises(InputError, match="space: rate"):
        draw({"rate": ("log", -1.0, 2.0)}, np.random.default_rng(0))


def test_tuning_writes_what_run_takes(tmp_path):
    cases = problems_of("tuning", only=["facilities/n016-t85-equal-tuning"])
    path = tune(["search"], cases, tmp_path, trials=2, seconds=0.05, candidates=4)
    row = json.loads(path.read_text())["methods"]["search"]
    assert row["trials"] == 2 and row["quality"] >= row["own"] > 0.0
    (method,) = bench.protocol.tuned_methods(["search"], path)
    assert method.settings == row["settings"]


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda path: problems_of("dev", only=["boats"]), 'nothing of dev goes by "boats"'),
        (lambda path: read_protocol(path), "no results of Layout Bench"),
        (lambda path: write_page(path / "page.md", "text"), "has no place for a leaderboard"),
        (lambda path: bench.Settings(memory=-1.0), "memory: -1.0"),
        (lambda path: bench.run(["adam"], ["packing"], path, jobs=0), "jobs: 0"),
    ],
)
def test_bad_input_is_one_line(tmp_path, call, text):
    (tmp_path / "page.md").write_text("nothing\n")
    with pytest.raises(InputError, match=text) as error:
        call(tmp_path)
    assert "\n" not in str(error.value)
