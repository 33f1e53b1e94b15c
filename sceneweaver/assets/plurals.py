"""Singular and plural of nouns, and slips of the pen."""

from __future__ import annotations

_IRREGULAR = {
    "knives": "knife",
    "loaves": "loaf",
    "scarves": "scarf",
    "leaves": "leaf",
    "halves": "half",
    "mice": "mouse",
    "people": "person",
    "children": "child",
    "men": "man",
    "women": "woman",
    "feet": "foot",
    "teeth": "tooth",
    "geese": "goose",
    "mattresses": "mattress",
    "buses": "bus",
    "axes": "axe",
    "vases": "vase",
    "cacti": "cactus",
    "pouffes": "pouffe",
    "shoes": "shoe",
    "canoes": "canoe",
    "ties": "tie",
    "pies": "pie",
    "caches": "cache",
    "quiches": "quiche",
}
_IN_IE = frozenset(
    (
        "beanie",
        "birdie",
        "bonhomie",
        "bookie",
        "boogie",
        "bootie",
        "bougie",
        "bowtie",
        "brasserie",
        "brownie",
        "budgie",
        "calorie",
        "charcuterie",
        "collie",
        "cookie",
        "cootie",
        "cutie",
        "dixie",
        "doggie",
        "falsie",
        "foodie",
        "freebie",
        "genie",
        "ghillie",
        "goalie",
        "goonie",
        "groupie",
        "hippie",
        "hoagie",
        "hoodie",
        "jalousie",
        "junkie",
        "laddie",
        "lassie",
        "lingerie",
        "magpie",
        "menagerie",
        "movie",
        "necktie",
        "newbie",
        "onesie",
        "patisserie",
        "pinkie",
        "pixie",
        "porkpie",
        "potpie",
        "prairie",
        "quickie",
        "rookie",
        "rotisserie",
        "selfie",
        "sharpie",
        "smoothie",
        "softie",
        "sortie",
        "sweetie",
        "talkie",
        "veggie",
        "walkie",
        "weirdie",
        "zombie",
    )
)
"""Nouns that end in -ie, whose plurals look like those of nouns in -y."""

_ALIKE = frozenset(
    (
        "bonsai",
        "scissors",
        "pliers",
        "tongs",
        "headphones",
        "binoculars",
        "stairs",
        "shears",
        "trousers",
        "canvas",
        "lens",
        "gas",
        "atlas",
        "christmas",
        "dice",
        "chess",
        "swiss",
        "series",
        "maracas",
        "clippers",
        "tweezers",
        "earphones",
        "earbuds",
        "overalls",
        "pyjamas",
        "pajamas",
        "jeans",
    )
)
"""Words that end like plurals and stay as they are."""


def singular(words: str) -> str:
    """The last word without its plural ending."""
    head, _, last = words.rpartition(" ")
    if last in _IRREGULAR:
        last = _IRREGULAR[last]
    elif last.endswith("shelves"):
        last = last[:-3] + "f"
    elif last in _ALIKE:
        pass
    elif last[:-1] in _IN_IE and last.endswith("s"):
        last = last[:-1]
    elif last.endswith("ies") and len(last) > 4:
        last = last[:-3] + "y"
    elif last.endswith("oes") or last.endswith(("sses", "shes", "ches", "xes", "zzes")):
        last = last[:-2]
    elif last.endswith("s") and not last.endswith(("ss", "us", "is")) and len(last) > 3:
        last = last[:-1]
    return f"{head} {last}".strip()


def slips(a: str, b: str) -> int:
    """Letters wrong, missing, too many or changed round between two words."""
    rows = [list(range(len(b) + 1))]
    for i, x in enumerate(a, start=1):
        row = [i]
        for j, y in enumerate(b, start=1):
            best = min(rows[-1][j] + 1, row[-1] + 1, rows[-1][j - 1] + (x != y))
            if i > 1 and j > 1 and x == b[j - 2] and a[i - 2] == y:
                best = min(best, rows[-2][j - 2] + 1)
            row.append(best)
        rows.append(row)
    return rows[-1][-1]
