"""Data sets of homes: the same bytes whoever makes them and however often they are killed, and what they hold."""

from __future__ import annotations

import gzip
import io
import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pyarrow.parquet as pq
import pytest
import yaml

from sceneweaver.cli.dataset_runs import Progress
from sceneweaver.datasets import Folder, Requests, Spec, load_spec, make_block
from sceneweaver.datasets.checking.findings import Findings
from sceneweaver.datasets.checking.home import HomeJudge
from sceneweaver.datasets.checking.verify import verify_dataset
from sceneweaver.datasets.engines import Listener, Options, begin, merge, resume
from sceneweaver.datasets.homes.files import home_fingerprint
from sceneweaver.datasets.reading import extract, scenes_of, shards_of, spans_of
from sceneweaver.datasets.spec import spec_schema
from sceneweaver.datasets.work import Produce, pack
from sceneweaver.envs import HomeEnv
from sceneweaver.home import Home
from sceneweaver.navigation import Roadmap, load_episodes
from sceneweaver.scene import InputError, Scene
from tests.datasets.homes import fake_homes
from tests.verify.build import box
from tests.verify.home.homes import flat, mirrored, turned

ASKED = {
    "schema": "sceneweaver.dataset/1",
    "name": "tiny-homes",
    "product": "homes",
    "count": 4,
    "block": 2,
    "exports": ["glb"],
    "rooms": {"attempts": 1},
    "homes": {"point_goals": 3, "object_goals": 3},
    "splits": {"train": 0.5, "test": 0.5},
}
PLANS = {
    "requests": {"programmes": {"flat-studio": 1.0}},
    "homes": {"furnished": False, "plans": 16, "point_goals": 2},
    "rooms": {"attempts": 3},
    "count": 2,
}


def spec_file(folder: Path, *prompts: str, **changes: object) -> Path:
    """A specification with some prompts, or other changes; what is None is left out."""
    folder.mkdir(parents=True, exist_ok=True)
    asked = {"requests": {"prompts": list(prompts)}} if prompts else {}
    said = {name: value for name, value in (ASKED | asked | changes).items() if value is not None}
    (folder / "homes.yaml").write_text(yaml.safe_dump(said))
    return folder / "homes.yaml"


def made(source: Path, out: Path, **options: object) -> Path:
    """Make a data set of homes that cost nothing."""
    dataset = begin(source, out, "cpu")
    listener = Listener(lambda record: None, lambda text: None)
    resume(dataset, Options(**{"workers": 1, **options}), listener, produce=fake_homes.produce)
    return out


def made_here(source: Path, out: Path, produce: Produce | None = fake_homes.produce) -> Path:
    """The same by this process alone, which is quicker."""
    dataset = begin(source, out, "cpu")
    for number in range(dataset.requests.blocks):
        make_block(dataset.folder, dataset.requests, number, "cpu", produce)
    pack(dataset.folder, dataset.requests)
    return out


def sums(out: Path) -> str:
    """The checksums of all files but times."""
    return (out / "checksums.sha256").read_text()


def rows(out: Path) -> list[dict]:
    return pq.read_table(out / "meta/index.parquet").to_pylist()


def homes_of(out: Path) -> dict[str, dict[str, bytes]]:
    """The files of all homes, by key."""
    return {key: files for s in shards_of(Folder(out)) for span in spans_of(s, 8) for key, files in scenes_of(span)}


def test_a_home_is_a_block_unless_another_one_is_said(tmp_path):
    prompts = {"requests": {"prompts": ["a home"]}}
    assert load_spec(spec_file(tmp_path, "a home", block=None)).block == 1
    assert Spec.model_validate({**ASKED, **prompts, "block": 16}).block == 16
    for product in ("scenes", "layouts"):
        rooms = {"schema": ASKED["schema"], "name": "rooms", "count": 1, "product": product, **prompts}
        assert Spec.model_validate(rooms).block == 16
    assert "of homes 1" in spec_schema()["properties"]["block"]["description"]


def test_each_home_is_delivered_and_told_of_by_itself(tmp_path):
    """Of four homes a run makes two until it breaks down: these are kept, and the next run makes the others alone."""
    source = spec_file(tmp_path, "a home", block=None)
    dataset = begin(source, tmp_path / "out", "cpu")
    for number in (0, 2):
        make_block(dataset.folder, dataset.requests, number, "cpu", fake_homes.produce)
    said, begun = io.StringIO(), []
    progress = Progress(None, said, dataset.spec.product)

    def going(count: int) -> None:
        begun.append(count)
        progress.begun(count)

    resume(
        dataset,
        Options(workers=1),
        Listener(progress.block, progress.notice, going),
        produce=fake_homes.produce,
    )
    assert begun == [2]
    assert [line[:20] for line in said.getvalue().splitlines()] == ["1/2 blocks, 1 homes,", "2/2 blocks, 2 homes,"]
    assert sums(tmp_path / "out") == sums(made_here(source, tmp_path / "calm"))


@pytest.fixture(scope="module")
def whole(tmp_path_factory) -> Path:
    """A data set of four homes: two delivered, one shut off by a bar in its hall, one that cannot be planned."""
    folder = tmp_path_factory.mktemp("homes")
    source = spec_file(folder, "a home", "a home with a terrace", "a home that is shut", "nothing")
    return made_here(source, folder / "out")


def test_rows_say_what_is_delivered_and_why_not(whole):
    found = rows(whole)
    assert [row["status"] for row in found] == ["ok", "ok", "rejected", "failed"]
    first, terrace, shut, nothing = found
    assert first["room_count"] == 6 and first["door_count"] == 6 and first["storeys"] == 1 and first["furnished"]
    assert first["categories"] == ["bed", "thing"] and first["object_count"] == 2 and first["valid"]
    assert first["walkable_share"] > 0.9 and first["reachable_share"] == 1.0 and first["unreached"] == []
    assert first["point_goals"] == 3 and first["object_goals"] == 3 and terrace["unmet"] == ["a terrace"]
    assert shut["reason"].startswith("not valid: ") and "living" in shut["unreached"] and shut["shard"] is None
    assert nothing["reason"].startswith("programme: no plan keeps all rules") and nothing["room_count"] is None


def test_files_of_a_home_agree_with_each_other(whole):
    for key, files in homes_of(whole).items():
        home = Home.loads(files["home.json"].decode())
        assert json.loads(files["metrics.json"])["valid"] and "seconds" not in files["metrics.json"].decode()[:100]
        furnished = {f"room-{k:02d}.scene.json": room.scene for k, room in enumerate(home.rooms) if room.scene}
        assert {name for name in files if name.endswith("scene.json")} == set(furnished)
        for name, scene in furnished.items():
            assert Scene.loads(files[name].decode()) == scene
        assert json.loads(files["navigation.json"])["graph"]["home"] == home.id
        assert yaml.safe_load(files["map-0.yaml"])["image"] == "map-0.png"
        for name in ("pointnav.json.gz", "objectnav.json.gz"):
            data = json.loads(gzip.decompress(files[name]))
            assert {one["scene_id"] for one in data["episodes"]} == {f"{key}.glb"}
        assert files["glb"][:4] == b"glTF"


def test_an_extracted_home_is_an_environment(whole, tmp_path):
    names = {path.name for path in extract(whole, "00000000", tmp_path / "one")}
    assert {"home.json", "home.glb", "map-0.png", "pointnav.json.gz"} <= names
    env = HomeEnv(tmp_path / "one/home.json", tmp_path / "one/objectnav.json.gz")
    _, info = env.reset(seed=0)
    assert info["category"] in ("bed", "thing") and info["distance_to_goal"] >= 1.0
    roadmap = Roadmap(env.homes[0], stairs=False)
    for episode in load_episodes(tmp_path / "one/pointnav.json.gz").episodes:
        assert roadmap.to([episode.goal]).distance(episode.start) == pytest.approx(episode.geodesic, abs=1e-3)


@pytest.mark.slow
def test_workers_shares_and_killed_workers_give_the_same_bytes(whole, tmp_path):
    """A worker that is killed in the middle of a home, two workers, and two shares on other disks."""
    prompts = ("a home", "a home with a terrace", "a home that is shut", "nothing")
    source = spec_file(tmp_path, *prompts)
    assert sums(made(source, tmp_path / "two", workers=2)) == sums(whole)
    for shard in ((0, 2), (1, 2)):
        made(source, tmp_path / f"disk{shard[0]}", shard=shard)
    merge([tmp_path / "disk0", tmp_path / "disk1"], tmp_path / "merged")
    assert sums(made(source, tmp_path / "merged")) == sums(whole)
    flaky = spec_file(tmp_path / "flaky", "a flaky home", "a home")
    once = made(flaky, tmp_path / "killed")
    assert [row["status"] for row in rows(once)] == ["ok"] * 4
    again = made(flaky, tmp_path / "killed-again", workers=2)
    assert sums(once) == sums(again)


@pytest.mark.slow
def test_what_is_lost_is_made_again_to_the_same_bytes(whole, tmp_path):
    source = spec_file(tmp_path, "a home", "a home with a terrace", "a home that is shut", "nothing")
    out = made(source, tmp_path / "out")
    next((out / "data").glob("*.tar")).unlink()
    made(source, out)
    assert sums(out) == sums(whole)


@pytest.mark.slow
def test_a_run_that_is_killed_at_any_time_goes_on_to_the_same_bytes(tmp_path):
    """Plans of studios by the command, its whole group of processes killed after ever longer times."""
    source = spec_file(tmp_path, **{**PLANS, "count": 6})
    command = [sys.executable, "-m", "sceneweaver", "dataset", "make", str(source), "--workers", "2", "--out"]
    subprocess.run([*command, str(tmp_path / "calm")], check=True, capture_output=True, timeout=300)
    for delay in (2.5, 4.0, 5.0, 6.0, 7.0, 9.0):
        run = subprocess.Popen([*command, str(tmp_path / "killed")], start_new_session=True, stdout=-3, stderr=-3)
        time.sleep(delay)
        os.killpg(run.pid, signal.SIGKILL)
        run.wait()
    subprocess.run([*command, str(tmp_path / "killed")], check=True, capture_output=True, timeout=300)
    assert sums(tmp_path / "killed") == sums(tmp_path / "calm")


def test_plans_are_made_and_verified(tmp_path):
    """Planned by the solver, without furniture; each is judged again from its files, and changes are found."""
    source = spec_file(tmp_path, **PLANS)
    made_here(source, tmp_path / "out", None)
    found = rows(tmp_path / "out")
    assert {row["status"] for row in found} == {"ok"} and all(
        row["plan_valid"] and not row["furnished"] for row in found
    )
    assert len({row["layout_signature"] for row in found}) == 2
    checked = verify_dataset(tmp_path / "out")
    assert checked.ok and checked.data["counts"]["judged"] == 2, checked.lines()
    row, files = found[0], homes_of(tmp_path / "out")["00000000"]
    judge = HomeJudge(tmp_path / "out", ("glb",), homes=load_spec(source).of_homes)

    def faults(row: dict, **changed: bytes) -> list[str]:
        findings = Findings()
        judge.judge(row, {**files, **changed}, findings)
        return [fault.detail for some in findings.first.values() for fault in some]

    assert faults(row) == []
    assert faults({**row, "room_count": 3, "walkable_share": 0.5})[0] == "room_count is 4; the index says 3"
    assert "map-0.png is not the map of home.json" in faults(row, **{"map-0.png": files["map-0.rooms.png"]})
    episodes = json.loads(gzip.decompress(files["pointnav.json.gz"]))
    episodes["episodes"][0]["info"]["geodesic_distance"] += 1.0
    longer = faults(row, **{"pointnav.json.gz": gzip.compress(json.dumps(episodes).encode())})
    assert len(longer) == 1 and "pointnav.json.gz: episode 0 is" in longer[0]
    home = Home.loads(files["home.json"].decode())
    shut = home.with_changes(doors=home.doors[1:]).dumps().encode()
    assert any("door_count" in line for line in faults(row, **{"home.json": shut}))


def test_a_home_is_the_same_turned_and_mirrored_for_near_duplicates():
    home = flat(living=[box("sofa", (0.9, 2.0, 0.8), 1.2, 2.0)])
    other = flat(living=[box("sofa", (0.9, 2.0, 0.8), 2.2, 2.0)])
    signature = home_fingerprint(home)["layout_signature"]
    assert home_fingerprint(turned(home))["layout_signature"] == signature
    assert home_fingerprint(mirrored(home))["layout_signature"] == signature
    assert home_fingerprint(other)["layout_signature"] != signature


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"requests": {"programmes": {"castle": 1}}}, "there is no programme 'castle'"),
        ({"homes": {"profile": "lax"}}, "there is no profile 'lax'"),
        ({"requests": {"kinds": {"bedroom": 1}}}, "requests of homes are programmes, prompts or a prompts_file"),
        ({"counterfactuals": 2}, "homes have no layouts, counterfactuals or views"),
        ({"product": "scenes", "homes": None, "requests": {"programmes": {"flat-studio": 1}}}, "for product: homes"),
        ({"homes": {"radius": 0}}, "homes.radius"),
    ],
)
def test_a_specification_that_is_wrong_is_refused(changes, said, tmp_path):
    with pytest.raises(InputError, match=said):
        Requests(load_spec(spec_file(tmp_path, **{"requests": {"prompts": ["a flat"]}, **changes})))


def test_specifications_of_rooms_are_what_they_were():
    """Their hash does not know of homes, so that data sets that are begun go on."""
    from sceneweaver.datasets.spec import EXAMPLES

    known = {"layouts": "261026ba4e54", "ten_kinds": "d79d082fe360"}
    assert {name: load_spec(EXAMPLES[name]).hash[:12] for name in known} == known
    asked = Spec.model_validate(ASKED | {"requests": {"programmes": {"flat-studio": 1.0}}})
    assert Spec.model_validate(asked.model_dump(mode="json")) == asked
