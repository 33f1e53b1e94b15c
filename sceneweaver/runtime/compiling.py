"""Warp is started, and kernels are compiled ahead of their first launch, with a word about it.

A kernel is compiled once for each kind of device and kept in Warp's cache. Where some are missing there, whoever
watches (`watched_by`) hears how many and for about how long; a notebook shows it, and the log has it.
"""

from __future__ import annotations

import contextlib
import ctypes
import logging
import math
import multiprocessing
import os
import sys
import threading
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any, NamedTuple

from . import caches
from .processes import cores

log = logging.getLogger(__name__)

THREADS = 2, 8
"""Modules that are compiled side by side: at least, and at most where there are so many cores."""

SECONDS = {
    "search": 8.0,
    "view_kernels": 7.5,
    "snap": 6.0,
    "gradients_gpu": 5.0,
    "proposals": 5.0,
    "cache_kernels": 4.0,
    "plan_cuts": 3.5,
    "plan_search": 3.5,
    "quality": 3.5,
    "develop_kernels": 3.5,
    "residuals": 3.3,
    "gradients": 2.7,
    "projection": 2.5,
    "linearise": 2.4,
    "starts": 2.3,
}
"""Seconds that the largest modules take, on one core of a laptop."""

USUAL_SECONDS = 1.2
"""Seconds of any other module."""

ON_GPU = 2.5
"""How much longer the compiler for a GPU takes."""

Device = str
Module = Any
"""A ``warp.Module``."""


class Variant(NamedTuple):
    """A module for launches with so many threads a block; None: as many as the module says, which is 256 mostly.

    A GPU needs a variant for each number, a CPU has one alone.
    """

    module: Module
    block: int | None = None


@dataclass(frozen=True)
class Compiling:
    """How far the compiling of kernels is.

    Attributes:
        done: modules that are compiled.
        total: modules that have to be.
        seconds: since it began.
        about: seconds that it may take in all.
    """

    done: int
    total: int
    seconds: float
    about: float

    def __str__(self) -> str:
        if self.done == self.total:
            return f"compiled {self.total} modules of kernels in {self.seconds:.1f} s"
        about = 5 * math.ceil(self.about / 5)
        return f"compiling kernels, once (about {about} s): {self.done} of {self.total} modules"


Watcher = Callable[[Compiling], None]

_watchers: list[Watcher] = []
_starting = threading.Lock()
_compiling = threading.RLock()
_started = False


@contextlib.contextmanager
def watched_by(watcher: Watcher) -> Iterator[None]:
    """While the block runs, a function hears of kernels that are compiled, in whichever thread; the innermost alone."""
    _watchers.append(watcher)
    try:
        yield
    finally:
        _watchers.remove(watcher)


def prepare_warp() -> None:
    """Tell Warp where to keep compiled kernels, and not to greet; cheap, and without effect once it has started."""
    wp = import_module("warp")
    if not os.environ.get("SCENEWEAVER_DEBUG"):
        wp.config.log_level = wp.LOG_ERROR
    if wp.config.kernel_cache_dir is None:
        usual = _usual_cache(wp)
        with contextlib.suppress(OSError):  # then Warp says what is wrong
            place = caches.writable(usual)
            if place != usual:
                _link(usual, place)
            wp.config.kernel_cache_dir = str(place.parent)  # to which Warp adds its version


def start_warp() -> None:
    """Start Warp, once. A machine without a driver for GPUs is no cause for a warning."""
    global _started
    with _starting:
        if not _started:
            prepare_warp()
            with _no_word_about_a_driver():
                import_module("warp").init()
            _started = True


def threads() -> int:
    """How many modules are compiled side by side here."""
    least, most = THREADS
    return min(max(cores(), least), most)


def kernel_cache() -> Path:
    """The folder of compiled kernels; Warp is started for that."""
    start_warp()
    return Path(import_module("warp").config.kernel_cache_dir)


def load(device: Device, modules: Iterable[Module | Variant]) -> int:
    """Compile what is not compiled yet of some modules, side by side, and load all.

    From a warm cache this takes milliseconds.

    Args:
        device: a Warp device.
        modules: the ``warp.Module`` of each, or a variant of it.

    Returns:
        How many were compiled.
    """
    start_warp()
    wp = import_module("warp")
    where = wp.get_device(device)
    wanted = list(dict.fromkeys(_variant(module, where) for module in modules))
    wanted = [variant for variant in wanted if not _is_loaded(variant, where)]
    missing = [variant for variant in wanted if not _is_compiled(variant, where)]
    if missing:
        with _compiling:  # who comes second finds them compiled
            missing = [variant for variant in missing if not _is_compiled(variant, where)]
            _compile(missing, where)
    for block in dict.fromkeys(variant.block for variant in wanted):
        own = [variant.module for variant in wanted if variant.block == block]
        wp.force_load(where, own, block_dim=block, max_workers=threads())
    return len(missing)


def compile_for(arch: int, modules: Iterable[Module | Variant]) -> int:
    """Compile for GPUs of an architecture, of which none need be here, into the cache that `kernel_cache` names.

    Args:
        arch: compute capability without its point: 90 for an H200.
        modules: as for `load`.

    Returns:
        How many were compiled.

    Raises:
        ValueError: the compiler does not know the architecture.
    """
    start_warp()
    wp = import_module("warp")
    known = wp.get_cuda_supported_archs()
    if arch not in known:
        raise ValueError(f"{arch} is not one of {', '.join(map(str, known))}")
    cache = Path(wp.config.kernel_cache_dir)
    missing: dict[Module, list[int]] = {}
    for module in modules:  # all names first: to compile a module changes what names of others are made of
        own, block = module if isinstance(module, Variant) else Variant(module)
        block = block or own.options["block_dim"]
        name = own.get_module_identifier(block)
        if block not in missing.get(own, ()) and not (cache / name / f"{name}.sm{arch}.cubin").exists():
            missing.setdefault(own, []).append(block)

    def compile_module(module: Module) -> int:
        """All variants of a module, one after the other: the module itself says which is meant."""
        usual = module.options["block_dim"]
        try:
            for block in missing[module]:
                module.options["block_dim"] = block
                wp.compile_aot_module(module, arch=arch, use_ptx=False)
        finally:
            module.options["block_dim"] = usual
        return len(missing[module])

    with _compiling, ThreadPoolExecutor(threads()) as pool:
        return sum(pool.map(compile_module, missing))


def _compile(modules: Sequence[Variant], device: Any) -> None:
    """Compile modules, the longest first, and tell whoever watches."""
    wp = import_module("warp")
    if not modules:
        return
    _move_where_there_is_room(wp)
    seconds = [_seconds_of(variant.module, device) for variant in modules]
    about, begun = _busy() * max(sum(seconds) / threads(), *seconds), time.monotonic()
    tell = _watchers[-1] if _watchers else _note
    tell(Compiling(0, len(modules), 0.0, about))
    order = sorted(range(len(modules)), key=lambda i: -seconds[i])
    with ThreadPoolExecutor(threads()) as pool:
        work = {pool.submit(_compile_one, modules[i], device): seconds[i] for i in order}
        share = 0.0
        try:
            for done, future in enumerate(as_completed(work), 1):
                future.result()
                share, so_far = share + work[future] / sum(seconds), time.monotonic() - begun
                tell(Compiling(done, len(modules), so_far, max(about, so_far / share)))
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            raise
    log.info("%d modules of kernels compiled for %s in %.1f s", len(modules), device, time.monotonic() - begun)


def _compile_one(variant: Variant, device: Any) -> None:
    wp = import_module("warp")
    try:
        wp.force_load(device, [variant.module], block_dim=variant.block, max_workers=0)
    except OSError as error:  # the disk became full, or its folder was taken away
        log.info("%s: kernels are kept elsewhere (%s)", wp.config.kernel_cache_dir, error)
        with _starting:
            _move_where_there_is_room(wp, error.strerror or str(error))
        variant.module.mark_modified()
        wp.force_load(device, [variant.module], block_dim=variant.block, max_workers=0)


def _busy() -> float:
    """How many times longer work takes as other processes want the cores as well."""
    with contextlib.suppress(OSError, AttributeError):
        return max(1.0, (os.getloadavg()[0] + threads()) / max(cores(), threads()))
    return 1.0


def _seconds_of(module: Module, device: Any) -> float:
    return SECONDS.get(module.name.rpartition(".")[2], USUAL_SECONDS) * (1.0 if device.is_cpu else ON_GPU)


def _note(state: Compiling) -> None:
    """What is done where nobody watches: a notebook shows how far it is, and the log says it."""
    if _shown_in_notebook(state):
        return
    first = state.done == 0 and multiprocessing.parent_process() is None
    log.log(logging.WARNING if first else logging.INFO, "%s", state)


_handle: Any = None


def _shown_in_notebook(state: Compiling) -> bool:
    """Show the state in the cell that runs, in the place of the last one; False where there is no notebook."""
    global _handle
    shell = getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)()
    if getattr(shell, "kernel", None) is None:
        return False
    data = {"text/plain": str(state)}
    if state.done == 0 or _handle is None:
        _handle = import_module("IPython.display").display(data, raw=True, display_id=True)
    else:
        _handle.update(data, raw=True)
    return True


def _variant(module: Module | Variant, device: Any) -> Variant:
    """What a device needs of a module, with the number that it has there."""
    own, block = module if isinstance(module, Variant) else Variant(module)
    return Variant(own, 1 if device.is_cpu else block or own.options["block_dim"])


def _is_loaded(variant: Variant, device: Any) -> bool:
    """Whether a module is loaded, as it is now: a relation of the user's changes modules that were loaded before."""
    loaded = variant.module.execs.get((device.context, variant.block))
    return loaded is not None and loaded.module_hash == variant.module.get_module_hash(variant.block)


def _is_compiled(variant: Variant, device: Any) -> bool:
    """Whether the cache has a module. These are names of the pinned version of Warp."""
    wp = import_module("warp")
    module, size = variant
    folder = Path(wp.config.kernel_cache_dir, module.get_module_identifier(size))
    names = module._get_compile_output_name(device, block_dim=size), module._get_meta_name(block_dim=size)
    return all((folder / name).exists() for name in names)


def _usual_cache(wp: Any) -> Path:
    """Where Warp would keep kernels: ``$WARP_CACHE_PATH``, else the user's caches."""
    given = os.environ.get("WARP_CACHE_PATH")
    return Path(os.path.realpath(given) if given else caches.cache_place("warp"), wp.config.version)


def _move_where_there_is_room(wp: Any, trouble: str = "") -> None:
    """See to it that the cache can be written: kernels that are there already are found in a new place as well."""
    now = Path(wp.config.kernel_cache_dir)
    place = caches.writable(now, trouble)
    if place != now:
        _link(now, place)
        wp.config.kernel_cache_dir = str(place)


def _link(old: Path, new: Path) -> None:
    """Links in a new cache to the kernels of an old one, which can be read but not written."""
    with contextlib.suppress(OSError):
        for folder in old.glob("wp_*"):
            for file in folder.iterdir():
                link = new / folder.name / file.name
                link.parent.mkdir(exist_ok=True)
                with contextlib.suppress(FileExistsError):
                    link.symlink_to(file)


@contextlib.contextmanager
def _no_word_about_a_driver() -> Iterator[None]:
    """Keep off stderr what Warp's native code says where there is no driver; anything else that is said there stays."""
    if os.environ.get("SCENEWEAVER_DEBUG") or not hasattr(os, "memfd_create") or has_driver():
        yield
        return
    sys.stderr.flush() if sys.stderr is not None else None
    try:
        usual = os.dup(2)
    except OSError:  # there is no stderr
        yield
        return
    with open(os.memfd_create("stderr"), "w+b", buffering=0) as said:
        os.dup2(said.fileno(), 2)
        try:
            yield
        finally:
            os.dup2(usual, 2)
            os.close(usual)
            said.seek(0)
            for line in said.read().splitlines(keepends=True):
                if not line.startswith(b"Warp CUDA warning: Could not find or load the NVIDIA CUDA driver"):
                    os.write(2, line)


def has_driver() -> bool:
    """Whether there may be a driver for GPUs; on Linux that is known without starting Warp, which takes a second."""
    if sys.platform != "linux":
        return True
    for name in ("libcuda.so", "libcuda.so.1"):
        with contextlib.suppress(OSError):
            ctypes.CDLL(name)
            return True
    return False
