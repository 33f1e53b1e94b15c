"""Data sets by Ray: a local cluster, a node of which goes away; slow, as a cluster takes its time to begin."""

from __future__ import annotations

import sys

import pytest

from sceneweaver.datasets.engines import Listener, Options, begin, open_dataset, resume
from sceneweaver.scene import MissingDependencyError
from tests.datasets import fake
from tests.datasets.test_engines import content, made, rows, spec_file


def test_without_ray_one_line_says_what_to_install(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "ray", None)
    dataset, listener = begin(spec_file(tmp_path), tmp_path / "out", "cpu"), Listener(print, print)
    with pytest.raises(MissingDependencyError, match=r"\(extra 'ray'\); install it with: pip install .*'ray>="):
        resume(dataset, Options(engine="ray"), listener, produce=fake.produce)


@pytest.mark.slow
def test_a_cluster_that_loses_a_node_makes_the_same_bytes(tmp_path):
    cluster_utils = pytest.importorskip("ray.cluster_utils")
    source = spec_file(tmp_path, "slow", "flaky", "a hopeless room", "crash")
    cluster = cluster_utils.Cluster(initialize_head=True, head_node_args={"num_cpus": 1, "include_dashboard": False})
    second, lost = cluster.add_node(num_cpus=1), []

    def lose_a_node(record: dict) -> None:
        if not lost:
            lost.append(record["block"])
            cluster.remove_node(second, allow_graceful=False)

    notices: list[str] = []
    try:
        options = Options(engine="ray", address=cluster.address)
        dataset = begin(source, tmp_path / "out", "cpu")
        listener = Listener(lose_a_node, notices.append)
        assert resume(dataset, options, listener, produce=fake.produce, pack=lambda d: None)
    finally:
        cluster.shutdown()
    assert lost and {row["prompt"]: row["status"] for row in rows(tmp_path / "out")} == {
        "slow": "ok",
        "flaky": "ok",
        "a hopeless room": "rejected",
        "crash": "failed",
    }
    made(source, tmp_path / "local", workers=1)
    here, there = (content(tmp_path / name) for name in ("local", "out"))
    for name in here:
        assert there[name].replace(b"worker killed", b"worker killed by signal 9") == here[name] or name.endswith("tar")
    assert open_dataset(tmp_path / "out").folder.complete.exists()
