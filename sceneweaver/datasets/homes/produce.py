"""The homes of some requests with their files, one after the other."""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

from sceneweaver.assets import Library
from sceneweaver.runtime.deadline import Deadline, TimeUp
from sceneweaver.verify.home import HomeReport, check_home

from ..gates import passed
from ..produce.scenes import lap, reason_of
from ..requests import Request
from ..samples import Sample
from ..spec import Spec
from ..store import AssetStore
from ..store.pool import dataset_library
from ..store.scene_files import references, writer_of
from .files import asset_columns, home_columns, home_files, home_fingerprint, report_columns
from .making import MadeHome, MakeHome, make_home


def produce_homes(
    spec: Spec, requests: Sequence[Request], store: AssetStore, device: str = "cpu", make: MakeHome = make_home
) -> Iterator[Sample]:
    """The homes of some requests, in the order of their index.

    What a home becomes does not depend on the requests beside it, nor on what was made before. One that breaks down or
    takes too long is a row with the reason; errors of the machine, such as a full disk, are raised.

    Args:
        spec: the specification.
        requests: what is asked for.
        store: where meshes and images go.
        device: homes are made on the CPU, as many at a time as there are workers; another one is left alone.
        make: what makes a home.
    """
    del device
    library = dataset_library(spec.variants)
    writer_of(store, library.load)  # before anything is drawn: other processes may have drawn it
    for request in requests:
        yield _Attempts(spec, request, library, store, make).sample()
    store.sync()


@dataclass
class _Attempts:
    """The attempts at one home."""

    spec: Spec
    request: Request
    library: Library
    store: AssetStore
    make: MakeHome
    seconds: dict[str, float] = field(default_factory=dict)

    def sample(self) -> Sample:
        """The home, or why there is none."""
        spec, request, reason, rejected = self.spec, self.request, "", None
        attempt = 0
        try:
            with Deadline(time.monotonic() + spec.time_limit).enforced():
                for attempt in range(spec.rooms.attempts):
                    seed = request.attempt(attempt)
                    try:
                        with lap(self.seconds, "home"):
                            made = self.make(spec, request, seed, self.library)
                        with lap(self.seconds, "judge"):
                            report = check_home(made.home, made.plan, robot_radius=spec.of_homes.radius)
                        row = self._row(made, report)
                        reason = _reason(report, row["gates"])
                        if not reason:
                            with lap(self.seconds, "files"):
                                files = self._files(made, report, seed, row)
                            return self._sample("ok", row, attempt, files)
                        rejected = row
                    except Exception as error:
                        reason = reason_of(error)
        except TimeUp:
            return self._sample("failed", {"reason": reason_of(TimeUp())}, attempt)
        status, row = ("rejected", rejected) if rejected is not None else ("failed", {})
        return self._sample(status, {**row, "reason": reason}, attempt)

    def _row(self, made: MadeHome, report: HomeReport) -> dict[str, Any]:
        row = home_columns(made.home) | report_columns(report) | {"unmet": list(made.unmet)}
        row["gates"] = passed(self.spec.gates, row.get)
        return row | asset_columns(made.home, self.library) | home_fingerprint(made.home)

    def _files(self, made: MadeHome, report: HomeReport, seed: int, row: dict[str, Any]) -> dict[str, bytes]:
        """The files of a home; its row is told of them."""
        files, more = home_files(self.spec, self.request.key(0), made.home, report, seed, self.library, self.store)
        row |= {**more, "assets": references(files)}
        return files

    def _sample(self, status: Any, row: dict[str, Any], attempt: int, files: dict[str, bytes] | None = None) -> Sample:
        request = self.request
        named = request.columns(attempt) | {"layout": 0}
        rounded = {name: round(value, 4) for name, value in self.seconds.items()}
        return Sample(request.index, request.key(0), status, named | row, files or {}, rounded)


def _reason(report: HomeReport, gates: dict[str, bool]) -> str:
    """Why a home is not delivered; empty where it is."""
    if not report.valid:
        some = [violation.detail for violation in report.violations]
        more = f" and {len(some) - 1} more" if len(some) > 1 else ""
        return f"not valid: {some[0] if some else 'the judge says no'}{more}"
    missed = [name for name, through in gates.items() if not through]
    return f"gate: {', '.join(missed)}" if missed else ""
