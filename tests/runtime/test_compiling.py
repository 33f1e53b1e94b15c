"""Kernels are compiled ahead with a word, where they can be kept, and Warp starts without one."""

import errno
import importlib
import importlib.util
import logging
import os
import subprocess
import sys
import tempfile
from functools import partial
from pathlib import Path
from types import SimpleNamespace

import pytest
import warp as wp

from sceneweaver.runtime import caches, compiling
from sceneweaver.runtime.compiling import Compiling, Variant, compile_for, load, watched_by
from tests import warm_kernels
from tests.layout.made import BOX, CUP, relation, table, thing
from tests.layout.made import scene as made

ROOT = Path(__file__).parents[2]
KERNEL = """
from tests.layout.made import BOX, CUP, relation, table, thing
from tests.layout.made import scene as made
import warp as wp

@wp.kernel
def add(values: wp.array(dtype=float)):
    i = wp.tid()
    values[i] = values[i] + {number}.0
"""


@pytest.fixture
def cache(tmp_path, monkeypatch):
    """An empty kernel cache and a temporary folder of this test's own."""
    compiling.start_warp()
    for name in ("tmp", "kernels"):
        (tmp_path / name).mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "tmp"))
    monkeypatch.setattr(wp.config, "kernel_cache_dir", str(tmp_path / "kernels"))
    monkeypatch.setattr(caches, "_told", False)
    return tmp_path / "kernels"


@pytest.fixture
def module(tmp_path, request):
    """Makes a Warp module of one kernel; each number is another one."""

    def make(number: int) -> wp.Module:
        name = f"made_for_{request.node.name.partition('[')[0]}_{number}"
        file = tmp_path / f"{name}.py"
        file.write_text(KERNEL.format(number=number))
        spec = importlib.util.spec_from_file_location(name, file)
        made = importlib.util.module_from_spec(spec)
        sys.modules[name] = made
        spec.loader.exec_module(made)
        return wp.get_module(name)

    return make


def compiled(folder: Path) -> set[str]:
    return {path.name for path in folder.rglob("*.o")}


def test_what_is_missing_is_compiled_once_and_watchers_hear_it(cache, module):
    first, second, heard = module(1), module(2), []
    with watched_by(lambda _: pytest.fail("an outer watcher hears nothing")), watched_by(heard.append):
        assert load("cpu", [first]) == 1
        assert [(state.done, state.total) for state in heard] == [(0, 1), (1, 1)]
        assert load("cpu", [first]) == 0  # it is loaded
        first.unload()
        assert load("cpu", [first]) == 0 and len(heard) == 2  # it is in the cache
        first.unload()
        assert load("cpu", [first, second]) == 1  # only the one that is missing
    assert [(state.done, state.total) for state in heard[2:]] == [(0, 1), (1, 1)]
    assert len(compiled(cache)) == 2
    values = wp.zeros(3, dtype=float, device="cpu")
    wp.launch(sys.modules[second.name].add, 3, [values], device="cpu")
    assert values.numpy().tolist() == [2.0] * 3


def test_what_has_changed_is_compiled_anew(cache, module):
    made = module(1)
    assert load("cpu", [made]) == 1
    made.options["fuse_fp"] = not made.options["fuse_fp"]
    made.mark_modified()
    assert load("cpu", [made]) == 1
    assert load("cpu", [made]) == 0


def test_modules_are_compiled_for_a_gpu_that_is_not_here(cache, module):
    several = [Variant(module(7)), Variant(module(7), 64), Variant(module(8), 32)]
    block = several[0].module.options["block_dim"]
    assert compile_for(90, several) == 3
    names = {variant.module.get_module_identifier(variant.block) for variant in several}
    assert {file.parent.name for file in cache.rglob("*.sm90.cubin")} == names
    assert several[0].module.options["block_dim"] == block
    assert compile_for(90, several) == 0
    with pytest.raises(ValueError, match="^11 is not one of "):
        compile_for(11, several)


def test_what_is_said():
    assert str(Compiling(0, 9, 0.0, 58.2)) == "compiling kernels, once (about 60 s): 0 of 9 modules"
    assert str(Compiling(9, 9, 61.04, 58.2)) == "compiled 9 modules of kernels in 61.0 s"


def test_where_nobody_watches_the_log_has_it(cache, module, caplog):
    made = module(1)
    with caplog.at_level(logging.INFO, logger="sceneweaver"):
        load("cpu", [made])
    said = [(record.levelno, record.message) for record in caplog.records]
    assert said[0][0] == logging.WARNING and said[0][1].startswith("compiling kernels, once (about ")
    assert said[1][0] == logging.INFO and said[1][1].startswith("compiled 1 modules of kernels in ")
    caplog.clear()
    made.unload()
    load("cpu", [made])
    assert not caplog.records


def test_a_notebook_shows_it_in_one_place(cache, module, monkeypatch, caplog):
    shown = []
    handle = SimpleNamespace(update=lambda data, raw: shown.append(("update", data["text/plain"])))

    def display(data, raw, display_id):
        shown.append(("display", data["text/plain"]))
        return handle

    shell = SimpleNamespace(get_ipython=lambda: SimpleNamespace(kernel=object()))
    monkeypatch.setitem(sys.modules, "IPython", shell)
    monkeypatch.setitem(sys.modules, "IPython.display", SimpleNamespace(display=display))
    load("cpu", [module(1)])
    assert [how for how, _ in shown] == ["display", "update"]
    assert shown[0][1].startswith("compiling kernels, once") and shown[1][1].startswith("compiled 1 ")
    assert not [record for record in caplog.records if record.levelno >= logging.WARNING]


@pytest.mark.parametrize("trouble", [pytest.param("full", marks=pytest.mark.slow), "read-only", "gone"])
def test_a_cache_that_cannot_be_written_moves_and_keeps_what_it_had(trouble, cache, module, monkeypatch, caplog):
    first, second = module(1), module(2)
    load("cpu", [first])
    first.unload()
    if trouble == "full":
        real = os.statvfs
        small = SimpleNamespace(f_bavail=1, f_frsize=4096)
        monkeypatch.setattr(os, "statvfs", lambda path: small if Path(path) == cache else real(path))
    elif trouble == "read-only":
        real_access = os.access
        monkeypatch.setattr(os, "access", lambda path, mode: Path(path) != cache and real_access(path, mode))
    else:
        cache.rename(cache.parent / "old")
        cache.write_text("")
    load("cpu", [second])
    now = Path(wp.config.kernel_cache_dir)
    assert now.is_relative_to(tempfile.gettempdir())
    assert any(second.name in name for name in compiled(now))
    if trouble != "gone":
        heard = []
        with watched_by(heard.append):
            assert load("cpu", [first]) == 0 and not heard  # found by a link
    (line,) = [record.message for record in caplog.records if "cannot be written" in record.message]
    assert str(cache) in line and "\n" not in line


def test_a_disk_that_becomes_full_meanwhile(cache, module, monkeypatch):
    made, real, calls = module(1), wp.force_load, []

    def force_load(*arguments, **options):
        calls.append(wp.config.kernel_cache_dir)
        if len(calls) == 1:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        return real(*arguments, **options)

    monkeypatch.setattr(wp, "force_load", force_load)
    assert load("cpu", [made]) == 1
    assert calls[0] == str(cache) and Path(calls[1]).is_relative_to(tempfile.gettempdir())


def test_times_are_those_of_modules():
    names = {name.rpartition(".")[2] for name in warm_kernels.modules()}
    assert set(compiling.SECONDS) <= names


def test_warming_covers_every_module_that_commands_launch():
    from sceneweaver.layout.warming import kernel_modules
    from sceneweaver.plans.solve_run import kernel_modules as plan_modules
    from sceneweaver.render.tracing.tracer import kernel_modules as picture_modules

    warmed = {variant.module.name for device in ("cpu", "cuda:0") for variant in kernel_modules(device)}
    warmed |= {variant.module.name for variant in plan_modules()} | {module.name for module in picture_modules()}
    all_of_them = set()
    for name in warm_kernels.modules():
        if wp.get_module(importlib.import_module(name).__name__).kernels:
            all_of_them.add(name)
    apart = {"sceneweaver.envs.batched.task_kernels", "sceneweaver.envs.batched.reset_kernels"}
    apart |= {"sceneweaver.kernels.evaluator"}  # in one launch what others do in several; for comparison
    apart |= {"sceneweaver.prior.flow_kernels"}  # of the learned prior, where one asks for it
    apart |= {"sceneweaver.kernels.adjoint"}  # derivatives by parameters, which no command asks for
    assert all_of_them - warmed == apart


def test_the_blocks_of_a_gpu_are_those_of_the_launches(monkeypatch):
    """What is launched on a CPU is recorded with the threads that a block has on a GPU."""
    import sceneweaver as sw
    from sceneweaver import kernels
    from sceneweaver.optimizers import OPTIMIZERS, launches, search
    from sceneweaver.plans import Envelope, Programme, solve_plans

    used, real_launch = set(), wp.launch
    monkeypatch.setattr(launches, "load_for", lambda kernel, device, block: used.add((kernel.module.name, block)))

    def launch(kernel, *arguments, block_dim=256, **options):
        used.add((kernel.module.name, block_dim))
        return real_launch(kernel, *arguments, block_dim=block_dim, **options)

    monkeypatch.setattr(wp, "launch", launch)
    monkeypatch.setenv("OMP_NUM_THREADS", "1")  # kernels that a CPU does not use otherwise are not loaded before
    monkeypatch.setattr(search, "Rounds", partial(search.Rounds, in_one=False))  # as on a GPU
    scene = made([table(), CUP, BOX, thing("other")], [relation("near", "box", "other", max=0.4)])
    for optimizer in OPTIMIZERS:
        sw.refine(scene, candidates=2, device="cpu", steps=1, optimizer=optimizer, snap=True)
    solve_plans(Programme.example("flat-1-bedroom"), Envelope.rectangle(9, 7), candidates=2, moves=1, device="cpu")
    own = f"{kernels.__name__}."
    used = {(name.removeprefix(own), block) for name, block in used if name.startswith(own)}
    used = {("gradients_gpu" if name == "gradients" else name, block) for name, block in used}
    assert {("snap", 32), ("starts", 32), ("proposals", 128), ("rounds", 64), ("step", 64)} <= used
    assert {pair for pair in used if pair[1] not in kernels.BLOCKS.get(pair[0], (256,))} == set()


def started(program: str, **environment: str) -> subprocess.CompletedProcess[str]:
    kept = {k: v for k, v in os.environ.items() if k not in ("SCENEWEAVER_DEBUG", "WARP_CACHE_PATH", "XDG_CACHE_HOME")}
    command = [sys.executable, "-c", program]
    return subprocess.run(
        command, cwd=ROOT, env=kept | environment, capture_output=True, text=True, timeout=240, check=False
    )


@pytest.mark.slow
def test_warp_starts_without_a_word_and_a_gpu_that_is_missing_is_named():
    program = (
        "from sceneweaver.layout.devices import pick_devices; import sceneweaver.render.tracing\n"
        "import os; print(pick_devices('auto')); os.write(2, b'mine')\n"
        "from sceneweaver.physics.batch import device_named; device_named('auto')\n"
    )
    done = started(program)
    assert done.returncode == 0 and done.stderr == "mine", done.stderr
    program = "import sys; from sceneweaver.cli import main; sys.exit(main(['warm', '--device', 'cuda:999']))"
    done = started(program)
    assert done.returncode == 4 and len(done.stderr.splitlines()) == 1 and 'device: "cuda:999"' in done.stderr


@pytest.mark.parametrize("home", ["below a file", pytest.param("not there", marks=pytest.mark.slow)])
def test_home_that_cannot_be_written_costs_one_line(home, tmp_path):
    """The kernels that this run has compiled stand in the temporary folder already, to save time."""
    place = tmp_path / f"sceneweaver-{os.getuid()}" / "warp" / wp.config.version
    place.parent.mkdir(parents=True, mode=0o700)
    place.parents[1].chmod(0o700)
    place.mkdir()
    compiling._link(compiling.kernel_cache(), place)
    file = tmp_path / "file"
    file.write_text("")
    where = file / "home" if home == "below a file" else tmp_path / "nobody"
    program = (
        "import sceneweaver as sw\n"
        "from sceneweaver.assets.textures.library import maps; maps('plastic')\n"
        "s = sw.refine(sw.Scene.example('bedroom'), candidates=2, device='cpu', steps=1); print(s.candidates)\n"
    )
    done = started(program, HOME=str(where), TMPDIR=str(tmp_path))
    assert done.returncode == 0 and done.stdout == "2\n", done.stderr
    lines = [line for line in done.stderr.splitlines() if not line.startswith("compiling kernels, once")]
    assert len(lines) == 1 and "cannot be written" in lines[0] and str(place.parents[1]) in lines[0]
    assert list(place.parents[1].rglob("plastic-*.npz"))
    assert not (tmp_path / "nobody").exists()
