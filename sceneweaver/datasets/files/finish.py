"""What every data set has beside its data: statistics, licences, card, Croissant metadata, checksums."""

from __future__ import annotations

import json

from sceneweaver.scene import write_atomic

from ..folder import Folder
from ..spec import Spec
from ..statistics import statistics
from .card import card
from .checksums import write_checksums
from .croissant import croissant
from .licences import licences, licences_text
from .plan import read_table


def finish(folder: Folder, spec: Spec) -> None:
    """Write what follows from the data and the index of a data set; checksums come last.

    All of it is a function of these files and the specification, without times.
    """
    numbers = statistics(read_table(folder.index))
    used = licences(folder)
    write_atomic(folder.meta / "statistics.json", _json(numbers))
    write_atomic(folder.path / "LICENSES.md", licences_text(spec, used))
    write_atomic(folder.path / "README.md", card(folder, spec, numbers, used))
    write_atomic(folder.path / "croissant.json", _json(croissant(folder, spec, numbers, used)))
    write_checksums(folder)


def _json(data: object) -> str:
    return json.dumps(data, indent=1, ensure_ascii=False) + "\n"
