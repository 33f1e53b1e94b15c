"""``sceneweaver dataset``: options that are wrong, and what commands say without a run."""

from __future__ import annotations

import pytest

SPEC = "schema: sceneweaver.dataset/1\nname: tiny\ncount: 3\nrequests: {prompts: [a bed]}\n"


@pytest.fixture
def spec(tmp_path):
    path = tmp_path / "spec.yaml"
    path.write_text(SPEC)
    return path


@pytest.mark.parametrize(
    ("options", "line"),
    [
        (["--shard", "3/3"], "'3/3' is not i/N with 0 <= i < N, such as 0/8"),
        (["--shard", "one"], "'one' is not i/N"),
        (["--worker-memory", "much"], "'much' is not a size; give bytes, or such as 800M or 2G"),
        (["--workers", "0"], "Invalid value for '--workers'"),
        (["--time-limit", "0"], "0.0 is not a number of seconds above 0"),
        (["--device", "tpu"], "'tpu' is not a device"),
        (["--engine", "slurm"], "'slurm' is not one of 'local', 'ray'"),
    ],
)
def test_a_wrong_option_is_one_line(run, spec, tmp_path, options, line):
    outcome = run("dataset", "make", spec, "--out", tmp_path / "out", *options)
    assert outcome.code == 2 and line in outcome.err and len(outcome.err.splitlines()) == 1
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("command", ["resume", "status"])
def test_a_folder_without_a_data_set_is_one_line(run, tmp_path, command):
    outcome = run("dataset", command, tmp_path)
    assert outcome.code == 2 and outcome.err.count("\n") == 1
    assert "no data set, as it has no dataset.json; check the path" in outcome.err


def test_a_wrong_specification_names_file_and_field(run, spec, tmp_path):
    spec.write_text(SPEC.replace("count: 3", "count: none"))
    outcome = run("dataset", "make", spec, "--out", tmp_path / "out", "--device", "cpu")
    assert outcome.code == 2 and "spec.yaml" in outcome.err and "count" in outcome.err
    outcome = run("dataset", "make", "ten_kids", "--out", tmp_path / "out")
    assert outcome.code == 2 and "ten_kinds" in outcome.err


def test_a_changed_specification_and_a_taken_folder_lose_nothing(run, spec, tmp_path):
    from sceneweaver.datasets.engines import begin
    from sceneweaver.datasets.engines.run import run_lock

    dataset = begin(spec, tmp_path / "out", "cpu")
    with run_lock(dataset.folder, None):
        outcome = run("dataset", "resume", tmp_path / "out", "--device", "cpu")
        assert outcome.code == 2 and "being written by process" in outcome.err
    spec.write_text(SPEC.replace("count: 3", "count: 4"))
    outcome = run("dataset", "make", spec, "--out", tmp_path / "out", "--device", "cpu")
    assert outcome.code == 2 and "spec: count is 4, but" in outcome.err and "was begun with 3" in outcome.err
    outcome = run("dataset", "status", tmp_path / "out", "--json")
    assert outcome.code == 0 and outcome.json["made"] == 0 and outcome.json["blocks"] == 1


def test_a_time_limit_ends_with_a_code_of_its_own(run, spec, tmp_path):
    outcome = run("dataset", "make", spec, "--out", tmp_path / "out", "--device", "cpu", "--time-limit", "1e-6")
    assert outcome.code == 5 and "the time is over; go on with: sceneweaver dataset resume" in outcome.out
    outcome = run("dataset", "resume", tmp_path / "out", "--shard", "0/2", "--time-limit", "1e-6", "--json")
    assert outcome.code == 5 and '"whole": false' in outcome.out
