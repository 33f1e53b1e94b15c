"""The columns of the index of a data set: one row a scene."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sceneweaver.scene import MissingDependencyError

if TYPE_CHECKING:
    import pyarrow as pa


def arrow():
    """The module pyarrow.

    Raises:
        MissingDependencyError: when it is not installed.
    """
    try:
        import pyarrow
        import pyarrow.parquet
    except ModuleNotFoundError:
        raise MissingDependencyError(
            "data sets need pyarrow; install it with: pip install sceneweaver[datasets]"
        ) from None
    return pyarrow


GRADES = ("realism", "functionality", "layout", "completion", "alignment")
"""The critic's grades of a scene, from 0 to 10."""

GATES = ("valid", "grade", "unmet", "openable", "walkable", "still")
"""What a specification asks of a scene; one that it does not ask for is null."""


def index_schema() -> pa.Schema:
    """What `meta/index.parquet` holds. Columns of scenes that are not there are null."""
    pa = arrow()
    text, whole, number, flag = pa.string(), pa.int32(), pa.float64(), pa.bool_()
    return pa.schema(
        [
            ("index", pa.int64()),
            ("key", text),
            ("status", text),
            ("reason", text),
            ("split", text),
            ("shard", text),
            ("room", pa.int64()),
            ("layout", whole),
            ("attempt", whole),
            ("seed", pa.int64()),
            ("prompt", text),
            ("kind", text),
            ("room_type", text),
            ("clutter", number),
            ("area", number),
            ("wall_count", whole),
            ("object_count", whole),
            ("categories", pa.list_(text)),
            ("relation_count", whole),
            ("valid", flag),
            ("collisions", whole),
            ("out_of_bounds", whole),
            ("relations_satisfied", number),
            ("openable_share", number),
            ("walkable_share", number),
            ("grade", number),
            ("grades", pa.struct([(name, number) for name in GRADES])),
            ("unmet", pa.list_(text)),
            ("gates", pa.struct([(name, flag) for name in GATES])),
            ("assets", pa.list_(text)),
            ("asset_ids", pa.list_(text)),
            ("licences", pa.list_(text)),
            ("layout_signature", text),
            ("near_duplicate_group", pa.int64()),
            ("content_hash", text),
            ("bytes", pa.int64()),
            ("version", text),
            ("source", text),
        ]
    )
