"""A data set as batches of padded arrays, shard after shard, with no more scenes in memory than a buffer holds."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from sceneweaver.io import InputError
from sceneweaver.scene import Scene

from ..folder import Folder
from ..reading import of_others, rows_of, scenes_of, spans_of
from .batch import Limits, Tensors, collate
from .vocabulary import Vocabulary

FILE = "scene.json"
OPENINGS, CORNERS = 16, 16
SPAN = 64  # scenes of a shard that are listed at once


@dataclass(frozen=True)
class TensorView:
    """The scenes of a data set, or of a list, as arrays; read anew in each pass.

    Attributes:
        vocabulary: numbers of categories and kinds of rooms, of all splits.
        limits: how many objects N, corners C and openings O the arrays have room for.
        frame: of positions and sizes, see `Tensors`.
        count: how many scenes.
        scenes: those of a list; empty where they are in shards.
        shards: tar files, in order.
    """

    vocabulary: Vocabulary
    limits: Limits
    frame: str
    count: int
    scenes: tuple[Scene, ...] = ()
    shards: tuple[Path, ...] = ()

    def __len__(self) -> int:
        """How many scenes."""
        return self.count

    def all(self) -> Tensors:
        """All scenes in one piece, in the order of the data set."""
        found = list(self._read(range(len(self.shards))))
        return self._collated(found)

    def batches(
        self, size: int, *, seed: int | None = None, buffer: int = 1024, whole: bool = False
    ) -> Iterator[Tensors]:
        """One pass over the scenes in batches.

        Args:
            size: scenes of a batch B.
            seed: of the order: shards are shuffled, and scenes within a buffer; equal seeds give equal orders. None: in
                the order of the data set.
            buffer: scenes that are in memory at most, beside a batch, to be drawn from.
            whole: leave out the last batch where it has fewer than ``size`` scenes.

        Raises:
            InputError: a number is out of range, a shard is damaged, or a scene has more than the limits.
        """
        for name, value in (("size", size), ("buffer", buffer)):
            if not isinstance(value, int) or isinstance(value, bool) or value < 1:
                raise InputError(f"{name}: {value!r} is not a whole number of at least 1")
        return self._batches(size, seed, buffer, whole)

    def _batches(self, size: int, seed: int | None, buffer: int, whole: bool) -> Iterator[Tensors]:
        rng = None if seed is None else np.random.default_rng(seed)
        order = range(len(self.shards)) if rng is None else rng.permutation(len(self.shards))
        rows = self._read(order) if rng is None else _shuffled(self._read(order), buffer, rng)
        batch: list[tuple[str, Scene]] = []
        for row in rows:
            batch.append(row)
            if len(batch) == size:
                yield self._collated(batch)
                batch = []
        if batch and not whole:
            yield self._collated(batch)

    def _collated(self, rows: Sequence[tuple[str, Scene]]) -> Tensors:
        keys = [key for key, _ in rows]
        return collate([scene for _, scene in rows], self.vocabulary, self.limits, frame=self.frame, keys=keys)

    def _read(self, order: Iterable[int]) -> Iterator[tuple[str, Scene]]:
        """Keys and scenes, one in memory at a time."""
        for scene in self.scenes:
            yield scene.id, scene
        for shard in order:
            for span in spans_of(self.shards[shard], SPAN):
                for key, files in scenes_of(span, (FILE,)):
                    yield key, Scene.loads(files[FILE])


def _shuffled(rows: Iterator[tuple[str, Scene]], buffer: int, rng: np.random.Generator) -> Iterator[tuple[str, Scene]]:
    """Rows in another order: each next one is any of the buffer, whose place the next row takes."""
    held: list[tuple[str, Scene]] = []
    for row in rows:
        if len(held) < buffer:
            held.append(row)
            continue
        k = int(rng.integers(buffer))
        held[k], row = row, held[k]
        yield row
    for k in rng.permutation(len(held)):
        yield held[k]


def tensors(
    source: str | Path | Sequence[Scene],
    *,
    split: str | None = None,
    vocabulary: Vocabulary | None = None,
    objects: int | None = None,
    corners: int | None = None,
    openings: int = OPENINGS,
    frame: str = "middle",
) -> TensorView:
    """A data set as padded arrays: poses, sizes, categories and masks, room outlines, openings.

    A packed data set is streamed from its shards; its index says how large arrays have to be and which categories there
    are, so nothing is read twice. NumPy comes out, which ``jax.numpy.from_dlpack`` and ``torch.from_numpy`` take
    without a copy.

    Args:
        source: the folder of a packed data set of scenes, or scenes.
        split: "train", say; None: all. A list of scenes has none.
        vocabulary: that of a model that is there already; None: of all that the data set has, whatever the split.
        objects, corners, openings: room for so many; None: as many as the largest scene of any split has.
        frame: "middle", "room" or "unit", see `Tensors`.

    Raises:
        InputError: no data set that is packed, an unknown split or frame, or a number out of range.

    Examples:
        >>> import sceneweaver as sw
        >>> view = sw.datasets.tensors([sw.Scene.example("bedroom"), sw.Scene.example("study")])
        >>> batch = next(view.batches(2, seed=0))
        >>> batch.poses.shape == (2, view.limits.objects, 4), sorted(batch.keys)
        (True, ['bedroom', 'study'])
        >>> view.vocabulary.name(batch.categories[0, 0]) != ""
        True
    """
    if isinstance(source, str | Path):
        found, shards, count, most = _of_folder(Folder(Path(source)), split)
        scenes: tuple[Scene, ...] = ()
    else:
        scenes, shards = tuple(source), ()
        if split is not None:
            raise InputError(f'split: "{split}", but a list of scenes has no splits; give those of the split alone')
        if not scenes:
            raise InputError("source: no scenes; give at least one")
        names = (o.category for scene in scenes for o in scene.objects)
        found = Vocabulary.of(names, (scene.room.type for scene in scenes))
        most = (max(len(s.objects) for s in scenes), max(len(s.room.outline) for s in scenes))
        count = len(scenes)
    limits = Limits(objects or max(most[0], 1), corners or max(most[1], 3), openings)
    view = TensorView(vocabulary or found, limits, frame, count, scenes, shards)
    collate([], view.vocabulary, limits, frame=frame)  # a wrong frame is one before anything is read
    return view


def _of_folder(folder: Folder, split: str | None) -> tuple[Vocabulary, tuple[Path, ...], int, tuple[int, int]]:
    """Vocabulary, shards of a split, how many scenes it has, and most objects and corners of any."""
    if not folder.index.exists():
        raise InputError(f"{folder.path}: no packed data set of scenes; see: sceneweaver dataset make")
    categories, rooms, shards, splits = set[str](), set[str](), dict[str, None](), set[str]()
    count, objects, corners = 0, 0, 0
    with of_others(folder):
        columns = ["status", "split", "shard", "categories", "room_type", "object_count", "wall_count"]
        for row in rows_of(folder, columns):
            if row["status"] != "ok":
                continue
            categories.update(row["categories"])
            rooms.add(row["room_type"])
            splits.add(row["split"])
            objects, corners = max(objects, row["object_count"]), max(corners, row["wall_count"] or CORNERS)
            if split in (None, row["split"]):
                shards[row["shard"]] = None
                count += 1
    if split is not None and split not in splits:
        raise InputError(f'split: "{split}" is not one of {", ".join(sorted(splits))}')
    return Vocabulary.of(categories, rooms), tuple(folder.path / s for s in sorted(shards)), count, (objects, corners)
