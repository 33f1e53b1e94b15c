"""Under which licences the assets of a data set are, and who is to be named."""

from __future__ import annotations

from collections import Counter
from typing import NamedTuple

from ..folder import Folder
from ..spec import Spec
from .tables import read_table

TEXTS = {
    "Apache-2.0": "https://www.apache.org/licenses/LICENSE-2.0",
    "BSD-3-Clause": "https://opensource.org/license/bsd-3-clause",
    "CC-BY-4.0": "https://creativecommons.org/licenses/by/4.0/",
    "CC-BY-NC-4.0": "https://creativecommons.org/licenses/by-nc/4.0/",
    "CC0-1.0": "https://creativecommons.org/publicdomain/zero/1.0/",
    "MIT": "https://opensource.org/license/mit",
}
"""Where the text of a licence stands."""

OWN = "Apache-2.0"
"""The licence of what the library itself draws and lays out."""


class Licence(NamedTuple):
    """A licence, with a source of assets that are under it, who is to be named, and how many assets these are."""

    name: str
    source: str
    attribution: str
    assets: int


DRAWN = Licence(OWN, "parametric", "sceneweaver", 0)
"""What holds where nothing came from elsewhere."""


def licences(folder: Folder) -> list[Licence]:
    """The licences of the assets of a data set, by name; one without assets is under the library's own."""
    rows = read_table(folder.asset_table) if folder.asset_table.exists() else ()
    found = Counter((row["licence"], row["source"], row["attribution"]) for row in rows)
    return [Licence(*key, count) for key, count in sorted(found.items())] or [DRAWN]


def licences_text(spec: Spec, used: list[Licence]) -> str:
    """``LICENSES.md``: every source of assets with its licence and attribution."""
    rows = "".join(
        f"| {one.source} | {_linked(one.name)} | {one.attribution or '-'} | {one.assets:,} |\n" for one in used
    )
    return (
        f"# Licences of {spec.name}\n\n"
        f"Layouts, descriptions and tables were made by sceneweaver and are under {_linked(OWN)}.\n"
        "Assets lie in `assets/`, each once; `meta/assets.parquet` names the licence of each, and the column\n"
        "`licences` of `meta/index.parquet` those of each scene.\n\n"
        "| source of assets | licence | attribution | assets |\n| --- | --- | --- | --- |\n" + rows
    )


def _linked(name: str) -> str:
    return f"[{name}]({TEXTS[name]})" if name in TEXTS else name
