"""A fuzzer of files: damaged files of every kind go through the program's own commands, and each ends as it should.

    python -m tests.io.mutated_files --count 2000 --seed 1 --jobs 2 [--kinds scene,glb] [--case 17]

Each case has a folder of its own with ``in``, ``out``, ``tmp`` and, beside them, ``outside`` with a file that is known.
A process that has imported the library is forked for it. A case fails when the command ends with another code than
0, 2, 3, 4 or 5, prints a traceback or an unexpected error, ends with 2 without a line that names something, changes
anything but ``out``, leaves temporary files, takes longer than its limit and two seconds (found again with nothing
beside it), or more than 2 GB.
"""

from __future__ import annotations

import argparse
import contextlib
import hashlib
import os
import re
import shlex
import shutil
import signal
import stat
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from random import Random

from tests.io.mutations import mutate, plant_link
from tests.io.specimens import KINDS, Call, Kind, read

CODES = (0, 2, 3, 4, 5)
"""How a command may end."""

MEMORY = 2 << 30
"""Most bytes that a case may take, its child processes with it."""

GRACE = 2.0
"""Seconds beyond its limit that a command may take."""

LONGEST = 1000
"""Characters of a line on stderr."""

KNOWN = b"what stands outside is nobody's business\n"

_LINE = re.compile(r"^sceneweaver: .*[^\s:]: ?.+|^sceneweaver: .*('.+'|--\w+|/)")


@dataclass
class Case:
    """One damaged file and the command that opens it."""

    seed: int
    number: int
    kind: str
    folder: Path
    call: Call
    damage: str = ""
    before: dict[str, str] = field(default_factory=dict[str, str])
    began: float = 0.0
    pid: int = 0
    killed: str = ""

    @property
    def argv(self) -> list[str]:
        """The words of the command in this case."""
        return [self._filled(word) for word in shlex.split(self.call.argv)]

    def _filled(self, text: str) -> str:
        return text.replace("{in}", str(self.folder / "in")).replace("{out}", str(self.folder / "out"))

    @property
    def env(self) -> dict[str, str]:
        """What the environment says beside that of this process."""
        given = {"TMPDIR": str(self.folder / "tmp"), "SCENEWEAVER_ROOMS": str(self.folder / "rooms")}
        given |= {"SCENEWEAVER_ASSETS": str(self.folder / "out" / "store"), "OPENAI_API_KEY": "none"}
        return given | {key: self._filled(value) for key, value in KINDS[self.kind].env.items()}

    def text(self, name: str) -> str:
        """What the command said on ``out`` or ``err``."""
        return (self.folder / "log" / name).read_text(encoding="utf-8", errors="replace")


@dataclass(frozen=True)
class Result:
    """How a case ended: an exit code, or what is wrong."""

    code: int
    faults: tuple[str, ...]
    seconds: float
    memory: int


class Fuzzer:
    """Makes cases of one seed and runs them."""

    def __init__(self, root: Path, seed: int, kinds: Sequence[str]) -> None:
        self.root, self.seed, self.kinds = root, seed, sorted(kinds)
        self._good: dict[str, Path] = {}

    def prepare(self) -> None:
        """Make the good files of all kinds, each in a process of its own, and import what commands need."""
        os.environ.setdefault("WARP_CACHE_PATH", _warp_cache())
        os.environ["XDG_CACHE_HOME"] = str(self.root / "cache")
        _import()  # first, as each of the processes would have to do it
        for name in self.kinds:
            folder = self.root / "good" / name
            folder.mkdir(parents=True)
            _apart(KINDS[name], folder)
            self._good[name] = folder

    def case(self, number: int) -> Case | None:
        """The case of a number; None where its kind is not wanted. Equal seeds and numbers make equal cases."""
        random = Random(f"{self.seed}/{number}")
        name = random.choice(sorted(KINDS))
        if name not in self._good:
            return None
        kind = KINDS[name]
        folder = self.root / "cases" / f"{number:06d}"
        for part in ("in", "out", "tmp", "log", "outside", "rooms"):
            (folder / part).mkdir(parents=True)
        (folder / "outside" / "known.txt").write_bytes(KNOWN)
        place = folder / kind.place
        shutil.copytree(self._good[name], place, dirs_exist_ok=True, symlinks=True)
        call = random.choices(kind.calls, [one.weight for one in kind.calls])[0]
        case = Case(self.seed, number, name, folder, call)
        files = sorted({f for glob in kind.targets for f in place.glob(glob) if f.is_file()})
        said = []
        for _ in range(random.choice((1, 1, 1, 2))):
            file = random.choice(files)
            if file.is_file() and not file.is_symlink():
                said.append(f"{file.relative_to(folder)}: {mutate(file, random, folder / 'outside')}")
        if call.writes and random.random() < 0.15:
            said.append(plant_link(folder / "out", random.choice(call.writes), random, folder / "outside"))
        case.damage = "; ".join(said)
        case.before = _snapshot(folder)
        return case

    def run(self, numbers: Iterator[int], count: int, jobs: int) -> Iterator[tuple[Case, Result]]:
        """Run so many cases, some at once, and give each as it ends; what took too long is run again, alone."""
        running: list[Case] = []
        again: list[Case] = []
        left = count
        while left or running:
            while left and len(running) < jobs:
                number = next(numbers, None)
                if number is None:
                    left = 0
                    break
                if (case := self.case(number)) is not None:
                    left -= 1
                    running.append(self._started(case))
            time.sleep(0.005)
            for case in list(running):
                result = _ended(case)
                if result is not None:
                    running.remove(case)
                    if any(fault.startswith("took") for fault in result.faults):
                        again.append(case)
                    else:
                        yield case, result
                        shutil.rmtree(case.folder, ignore_errors=True)
        for case in again:
            shutil.rmtree(case.folder)
            alone = self.case(case.number)
            assert alone is not None
            self._started(alone)
            while (result := _ended(alone)) is None:
                time.sleep(0.005)
            yield alone, result
            shutil.rmtree(alone.folder, ignore_errors=True)

    @staticmethod
    def _started(case: Case) -> Case:
        sys.stdout.flush()
        sys.stderr.flush()
        case.began = time.monotonic()
        case.pid = os.fork()
        if case.pid == 0:
            _child(case)
        return case


def _apart(kind: Kind, folder: Path) -> None:
    """Make the files of a kind in a process that may start what this one must not have started."""
    pid = os.fork()
    if pid == 0:
        code = 1
        try:
            kind.make(folder)
            code = 0
        except BaseException:
            import traceback

            traceback.print_exc()
        finally:
            sys.stderr.flush()
            os._exit(code)
    if os.waitpid(pid, 0)[1]:
        raise RuntimeError(f"{folder.name}: its good files could not be made")


def _import() -> None:
    """Import what most commands import, so that no case has to."""
    import PIL.Image
    import trimesh
    import yaml

    import sceneweaver.assets.imports.prepare
    import sceneweaver.cli.app
    import sceneweaver.datasets.engines
    import sceneweaver.render
    import sceneweaver.verify

    loaded = (PIL.Image, trimesh, yaml, sceneweaver.assets.imports.prepare, sceneweaver.cli.app)
    assert all((*loaded, sceneweaver.datasets.engines, sceneweaver.render, sceneweaver.verify))


def _warp_cache() -> str:
    """Where compiled kernels are kept: not below the cache of the cases, which is empty."""
    import warp

    return str(warp.config.kernel_cache_dir or Path(os.environ.get("XDG_CACHE_HOME", "~/.cache")).expanduser() / "warp")


def _child(case: Case) -> None:
    """The command, in a process of its own that never returns."""
    code = 70
    try:
        os.setsid()
        os.environ.update(case.env)
        tempfile.tempdir = None
        for number, name in ((1, "out"), (2, "err")):
            descriptor = os.open(case.folder / "log" / name, os.O_WRONLY | os.O_CREAT | os.O_APPEND, 0o644)
            os.dup2(descriptor, number)
        os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
        os.chdir(case.folder)
        code = _called(case.argv)
        import atexit

        atexit._run_exitfuncs()
        sys.stdout.flush()
        sys.stderr.flush()
    except BaseException:
        import traceback

        traceback.print_exc()
        sys.stderr.flush()
    finally:
        os._exit(code)


def _called(argv: list[str]) -> int:
    from sceneweaver.cli.app import main
    from sceneweaver.io import SceneWeaverError

    if not argv[0].startswith("@"):
        return main(argv)
    try:
        read(argv[0][1:], *argv[1:])
    except SceneWeaverError as error:
        print(f"sceneweaver: {error}", file=sys.stderr)
        return error.exit_code
    return 0


def _ended(case: Case) -> Result | None:
    """What became of a case; None while it runs. One that takes far too much is ended."""
    pid, status, used = os.wait4(case.pid, os.WNOHANG)
    seconds = time.monotonic() - case.began
    if not pid:
        if seconds > 3 * case.call.limit + 10:
            case.killed = "time"
        elif _resident(case.pid) > 2 * MEMORY:
            case.killed = "memory"
        if case.killed:
            _kill(case.pid)
        return None
    _kill(case.pid)  # what it has left
    code, memory = os.waitstatus_to_exitcode(status), used.ru_maxrss * 1024
    return Result(code, tuple(_faults(case, code, seconds, memory)), seconds, memory)


def _kill(group: int) -> None:
    with contextlib.suppress(ProcessLookupError, PermissionError):
        os.killpg(group, signal.SIGKILL)


def _resident(pid: int) -> int:
    try:
        return int(Path(f"/proc/{pid}/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")
    except (OSError, IndexError):
        return 0


def _faults(case: Case, code: int, seconds: float, memory: int) -> Iterator[str]:
    said = case.text("err")
    if case.killed:
        yield f"took {seconds:.1f} s" if case.killed == "time" else f"memory: over {2 * MEMORY >> 20} MiB"
        return
    if code not in CODES:
        yield f"exit {code}"
    for line in said.splitlines():
        if "Traceback (most" in line or line.startswith("sceneweaver: unexpected "):
            yield line[:200]
            break
    if code == 2 and not any(_LINE.search(line) for line in said.splitlines()):
        yield f"exit 2 without a line that names something: {said[:200]!r}"
    for line in said.split("\n"):
        if len(line) > LONGEST or not line.replace("\t", " ").isprintable():
            yield f"a line that no terminal should get: {line[:120]!r}"
            break
    if seconds > case.call.limit + GRACE:
        yield f"took {seconds:.1f} s of {case.call.limit:g}"
    if memory > MEMORY:
        yield f"memory: {memory >> 20} MiB"
    after = _snapshot(case.folder)
    for name in sorted(case.before.keys() | after.keys()):
        if case.before.get(name) != after.get(name):
            yield f"changed: {name}"
            break
    for place in (case.folder / "out", case.folder / "tmp"):
        left = [f for f in place.rglob("*") if place.name == "tmp" or f.name.startswith(".sceneweaver-")]
        if left:
            yield f"left: {left[0].relative_to(case.folder)}"


def _snapshot(folder: Path) -> dict[str, str]:
    """All that must not change, by path: kind, size and content."""
    found: dict[str, str] = {}
    for part in ("in", "outside", "rooms", "."):
        for place in sorted((folder / part).rglob("*") if part != "." else (folder / part).iterdir()):
            status = place.lstat()
            said = f"{stat.S_IFMT(status.st_mode):o}"
            if stat.S_ISLNK(status.st_mode):
                said += f" {place.readlink()}"
            elif stat.S_ISREG(status.st_mode):
                said += f" {hashlib.sha256(place.read_bytes()).hexdigest()}"
            found[str(place.relative_to(folder))] = said
    return found


@dataclass
class Tally:
    """How cases of each kind ended, and those that failed."""

    counts: dict[str, Counter[str]] = field(default_factory=dict[str, Counter[str]])
    failures: list[tuple[Case, Result]] = field(default_factory=list[tuple[Case, Result]])
    slowest: float = 0.0
    largest: int = 0

    def add(self, case: Case, result: Result) -> None:
        """Count one."""
        outcome = "failed" if result.faults else str(result.code)
        self.counts.setdefault(case.kind, Counter())[outcome] += 1
        self.slowest, self.largest = max(self.slowest, result.seconds), max(self.largest, result.memory)
        if result.faults:
            self.failures.append((case, result))

    def table(self) -> str:
        """Kinds by outcomes."""
        columns = [*map(str, CODES), "failed"]
        rows = [f"{'kind':<10}" + "".join(f"{name:>8}" for name in columns) + f"{'all':>8}"]
        total = sum(self.counts.values(), Counter[str]())
        for kind, count in (*sorted(self.counts.items()), ("all", total)):
            rows.append(f"{kind:<10}" + "".join(f"{count[name]:>8}" for name in columns) + f"{sum(count.values()):>8}")
        return "\n".join((*rows, f"slowest {self.slowest:.1f} s, most memory {self.largest >> 20} MiB"))

    def story(self, number: int) -> str:
        """What failed, by its number among the failures, and how to do it again."""
        case, result = self.failures[number]
        return (
            f"--seed {case.seed} --case {case.number} ({case.kind}): {'; '.join(result.faults)}\n"
            f"    {case.call.argv}\n    {case.damage}"
        )


def fuzz(count: int, seed: int, jobs: int, kinds: Sequence[str], case: int | None = None) -> Tally:
    """Run so many cases, or one by its number."""
    tally = Tally()
    root = Path(tempfile.mkdtemp(prefix="mutated-files-"))  # a TemporaryDirectory is removed by each fork as it ends
    try:
        fuzzer = Fuzzer(root, seed, kinds)
        fuzzer.prepare()
        numbers = iter(range(10**9)) if case is None else iter([case])
        for one, result in fuzzer.run(numbers, count if case is None else 1, jobs):
            tally.add(one, result)
            if result.faults:
                print(tally.story(-1), file=sys.stderr, flush=True)  # at once: a long run may be ended
            if case is not None:
                print(f"{one.number} {one.kind} {one.call.argv}: {one.damage}\n  {result}\n{one.text('err')[-3000:]}")
    finally:
        shutil.rmtree(root, ignore_errors=True)
    return tally


def main() -> int:
    """Fuzz, and print what came of it."""
    parser = argparse.ArgumentParser(description="Damaged files of every kind through the commands.")
    parser.add_argument("--count", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--kinds", default=",".join(KINDS), help="comma-separated; default: all")
    parser.add_argument("--case", type=int, default=None, help="only the case of this number")
    given = parser.parse_args()
    kinds = given.kinds.split(",")
    if unknown := set(kinds) - set(KINDS):
        parser.error(f"unknown kinds: {', '.join(sorted(unknown))}; known: {', '.join(KINDS)}")
    tally = fuzz(given.count, given.seed, given.jobs, kinds, given.case)
    for number in range(len(tally.failures)):
        print(tally.story(number))
    print(tally.table())
    return 1 if tally.failures else 0


if __name__ == "__main__":
    raise SystemExit(main())
