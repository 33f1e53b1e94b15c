"""The table of nouns that ships with the library, derived from the files of WordNet's database.

``python -m benchmarks nouns FOLDER`` reads its ``data.noun`` and ``index.sense`` and writes the table anew; which sense
makes a noun which kind of thing is told by ``data/noun_kinds.yaml``.
"""

from __future__ import annotations

import argparse
import gzip
import math
import re
from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import cache, lru_cache
from pathlib import Path

import yaml

from benchmarks.settings import ROOT
from sceneweaver.assets import categories
from sceneweaver.assets.plurals import singular
from sceneweaver.assets.taxonomy import phrases

KINDS = ROOT / "benchmarks" / "data" / "noun_kinds.yaml"
OUT = ROOT / "sceneweaver" / "assets" / "wordnet"

PLAIN = re.compile(r"[a-z][a-z']*(?:[_-][a-z][a-z']*)?$")
"""Nouns of one or two words."""

PRIOR = {"things": 3.0, "large": 1.5, "nothing": 1.0}
"""How much more often a sense is meant where rooms are spoken of."""

UNSEEN = 0.5
"""Weight of a sense that the texts counted by WordNet never use."""

NEAR, FAR = 1, 2
"""Steps up to a category that is of the same kind: in any case, and where few things are of that kind."""
FEW = 40
"""Things under a sense up to which two steps are near."""
SISTERS = 40
"""Things directly under a sense up to which two of them may be alike."""
ALIKE = 0.3
"""Likeness of what two nouns are said to be, from which the body of one may stand for the other."""
SURE = 4
"""Tenths from which a noun is a thing rather than something else."""
BROAD = 1500
"""Senses under one from which it says nothing of a thing: "device", "container"."""

_LITTLE = re.compile(
    r"(an?|the|of|x?or|and|in|on|for|to|with|that|is|used?|using|by|as|from|at|into|its?|be|are|one|which|can|who|whose|"
    r"ha[sd]|have|having|such|other|usually|often|esp|especially|etc|very|not|made?|make|when|where)$"
)
"""Words that say little of what something is."""


@dataclass
class Synset:
    """One sense: words, what is said of it, what is above and below it by id."""

    words: tuple[str, ...]
    gloss: str
    above: tuple[str, ...]
    below: tuple[str, ...]
    instance: bool
    count: int = 0


@dataclass
class WordNet:
    """The senses of nouns, and how often each word is a noun at all."""

    synsets: dict[str, Synset]
    senses: dict[str, list[tuple[str, int]]]
    """Lemma -> senses with their counts, the usual one first."""
    keys: dict[str, str]
    others: dict[str, int] = field(default_factory=dict)
    """Lemma -> how often it is a verb, an adjective or an adverb."""


def read_wordnet(folder: Path) -> WordNet:
    """The database in a folder with ``data.noun`` and ``index.sense``."""
    synsets: dict[str, Synset] = {}
    for line in (folder / "data.noun").read_text("utf-8").splitlines():
        if line.startswith("  "):
            continue
        head, _, gloss = line.partition(" | ")
        parts = head.split()
        n = int(parts[3], 16)
        words = tuple(parts[4 + 2 * k] for k in range(n))
        at = 4 + 2 * n
        pointers = [parts[at + 1 + 4 * k : at + 4 + 4 * k] for k in range(int(parts[at]))]
        above = tuple(o for kind, o, pos in pointers if kind in ("@", "@i") and pos == "n")
        below = tuple(o for kind, o, pos in pointers if kind == "~" and pos == "n")
        instance = any(kind == "@i" for kind, _, _ in pointers)
        synsets[parts[0]] = Synset(words, gloss.partition(";")[0].strip().lower(), above, below, instance)
    senses: dict[str, list[tuple[int, str, int]]] = defaultdict(list)
    keys: dict[str, str] = {}
    others: dict[str, int] = defaultdict(int)
    for line in (folder / "index.sense").read_text("utf-8").splitlines():
        key, offset, rank, count = line.split()
        lemma, _, rest = key.partition("%")
        if rest[0] != "1":
            others[lemma] += int(count) + 1
            continue
        senses[lemma].append((int(rank), offset, int(count)))
        keys[key.removesuffix("::")] = offset
        synsets[offset].count += int(count)
    plain = {lemma: [(offset, count) for _, offset, count in sorted(rows)] for lemma, rows in senses.items()}
    return WordNet(synsets, plain, keys, dict(others))


class Kinds:
    """Which kind of thing each sense is."""

    def __init__(self, net: WordNet) -> None:
        self.net = net
        data = yaml.safe_load(KINDS.read_text("utf-8"))
        self.meant: dict[str, str | None] = data.pop("senses")
        self.by_likeness = frozenset(data.pop("by_likeness"))
        self.group: dict[str, str] = {}
        self._roots: dict[str, str] = {}
        for group, kinds in data.items():
            for kind, keys in kinds.items():
                self.group[kind] = group
                for key in keys:
                    self._roots.setdefault(net.keys[key], kind)

    @cache  # noqa: B019 - one of these for a run
    def kind(self, synset: str) -> str:
        """The kind of the nearest sense above that has one."""
        level = [synset]
        while level:
            found = [self._roots[one] for one in level if one in self._roots]
            if found:
                return found[0]
            level = [up for one in level for up in self.net.synsets[one].above]
        return "abstract"

    def is_thing(self, synset: str) -> bool:
        """Whether it is a thing that can stand in a room."""
        return self.group[self.kind(synset)] == "things"


@dataclass(frozen=True)
class Row:
    """What is written of a noun: its kind, how sure that is in tenths, and the category that is near to it."""

    kind: str
    sure: int
    category: str = ""
    near: str = ""
    """same: another name of it, kind: one of its kind, like: of the same kind as it."""


class Table:
    """Every noun with what it is."""

    def __init__(self, net: WordNet) -> None:
        self.net, self.kinds = net, Kinds(net)
        self.category: dict[str, str] = {}
        self.of_category = self._senses_of_categories()
        for name, synset in self.of_category.items():
            if synset not in self.category or len(name) < len(self.category[synset]):
                self.category[synset] = name

    def rows(self) -> Iterator[tuple[str, Row]]:
        """Every noun, with a blank between two words."""
        for lemma in sorted(self.net.senses):
            if PLAIN.match(lemma):
                row = self._row(lemma)
                if row is not None and not self._goes_without_saying(lemma, row):
                    yield lemma.replace("_", " ").replace("-", " "), row

    def _goes_without_saying(self, lemma: str, row: Row) -> bool:
        """Whether two words are no thing, as their last word says already, or a plant that hardly anyone names."""
        head = lemma.replace("-", "_").rpartition("_")[2]
        alone = self._row(head) if head != lemma and head in self.net.senses else None
        if row.kind == "plant" and head != lemma:
            return not any(count for _, count in self.net.senses[lemma]) and row.near != "same"
        known = singular(head) in phrases() or head in phrases()
        return head != lemma and row.sure < SURE and not known and (alone is None or alone.sure < SURE)

    def _row(self, lemma: str) -> Row | None:
        weights: dict[str, float] = defaultdict(float)
        best: tuple[float, str] = (0.0, "")
        own = 0
        for rank, (offset, count) in enumerate(self.net.senses[lemma], start=1):
            synset = self.net.synsets[offset]
            spelt = next((w for w in synset.words if w.lower() == lemma), lemma)
            if synset.instance or spelt != lemma or _is_latin(synset):
                continue
            kind = self.kinds.kind(offset)
            weight = (count + UNSEEN / rank) * PRIOR[self.kinds.group[kind]]
            weights[kind] += weight
            own += count + 1
            if self.kinds.is_thing(offset) and weight > best[0]:
                best = (weight, offset)
        if not weights:
            return None
        groups: dict[str, float] = defaultdict(float)
        for kind, weight in weights.items():
            groups[self.kinds.group[kind]] += weight
        group = max(groups, key=groups.__getitem__)
        kind = max((k for k in weights if self.kinds.group[k] == group), key=weights.__getitem__)
        share = groups["things"] / sum(groups.values())
        share *= min(1.0, 4 * own / (own + self.net.others.get(lemma, 0)))  # mostly a verb or an adjective
        sure = min(9, math.floor(10 * share))
        if not best[1]:
            return Row(kind, 0)
        if group == "things" and sure >= 2:
            kind = self.kinds.kind(best[1])
        category, near = self._near(best[1]) if sure >= 2 else ("", "")
        return Row(kind, sure, category, near)

    def _near(self, synset: str) -> tuple[str, str]:
        """The category whose body may stand for a sense, and how near it is."""
        if synset in self.category:
            return self.category[synset], "same"
        for up in self.net.synsets[synset].above:
            if up in self.category:
                return self.category[up], "kind"
        for up in self.net.synsets[synset].above:
            for high in self.net.synsets[up].above:
                if high in self.category and self._breadth(high) <= FEW:
                    return self.category[high], "kind"
        if self.kinds.kind(synset) not in self.kinds.by_likeness:
            return "", ""
        below = [s for s in self.net.synsets[synset].below if s in self.category]
        if below and self._breadth(synset) <= FEW:
            return self.category[max(below, key=lambda s: self.net.synsets[s].count)], "wide"
        best = (ALIKE, "")
        for up in self.net.synsets[synset].above:
            sisters = self.net.synsets[up].below
            if len(sisters) > SISTERS:
                continue
            for sister in sisters:
                if sister in self.category and self.kinds.kind(sister) == self.kinds.kind(synset):
                    alike = _alike(self.net.synsets[synset].gloss, self.net.synsets[sister].gloss)
                    best = max(best, (alike, self.category[sister]))
        return (best[1], "like") if best[1] else ("", "")

    @cache  # noqa: B019 - one of these for a run
    def _breadth(self, synset: str) -> int:
        """How many senses are below one."""
        return sum(1 + self._breadth(one) for one in self.net.synsets[synset].below)

    def _senses_of_categories(self) -> dict[str, str]:
        """The sense that the name of a category has and most of its other names share.

        Names of several words that WordNet lacks stand for a kind of what their last word says: synonyms of another
        kind ("paprika" of a spice jar) do not count.
        """
        found: dict[str, str] = {}
        for name, row in categories().items():
            if row.size is None or name.startswith("generic_") or name == "object":
                continue
            if name in self.kinds.meant:
                key = self.kinds.meant[name]
                if key is not None:
                    found[name] = self.net.keys[key]
                continue
            own = row.words.replace(" ", "_")
            heads = {offset for offset, _ in self.net.senses.get(own.rpartition("_")[2], ())}
            votes: dict[str, float] = defaultdict(float)
            for phrase in (row.words, *row.synonyms):
                lemma = singular(phrase.replace("-", " ")).replace(" ", "_")
                for rank, (offset, count) in enumerate(self.net.senses.get(lemma, ()), start=1):
                    if lemma != own and own in self.net.senses and offset not in votes:
                        continue
                    if lemma != own and "_" in own and heads and not heads & set(self._above(offset)):
                        continue
                    if self.kinds.is_thing(offset) or self.kinds.kind(offset) in ("part", "structure", "vehicle"):
                        votes[offset] += (3 if lemma == own else 1) * (1 + math.log1p(count)) / rank
            if votes:
                found[name] = max(votes, key=votes.__getitem__)
        return found

    def _above(self, synset: str) -> Iterator[str]:
        """A sense and all above it, the nearest first."""
        level, seen = [synset], set[str]()
        while level:
            for one in level:
                seen.add(one)
                yield one
            level = list(dict.fromkeys(up for one in level for up in self.net.synsets[one].above if up not in seen))

    def kinds_above(self) -> dict[str, list[str]]:
        """For every category the words for it and all that it is a kind of; of a name that WordNet lacks, those of its
        last word."""
        found: dict[str, list[str]] = {}
        for name, row in categories().items():
            synset = self.of_category.get(name) or ("" if name in self.kinds.meant else self._head(row.words))
            if row.size is None or not synset:
                continue
            above = [s for s in self._above(synset) if s == synset or 1 < self._breadth(s) < BROAD]
            words = [w.lower() for s in above for w in self.net.synsets[s].words]
            found[name] = [w for w in dict.fromkeys(words) if PLAIN.match(w)]
        return found

    def _head(self, words: str) -> str:
        """The sense of the last word of a name, if it is mostly a thing."""
        lemma = singular(words).rpartition(" ")[2]
        row = self._row(lemma) if " " in words and lemma in self.net.senses else None
        things = [s for s, _ in self.net.senses.get(lemma, ()) if self.kinds.is_thing(s)]
        return things[0] if row is not None and row.sure >= SURE and things else ""


def _is_latin(synset: Synset) -> bool:
    """Whether a sense is a taxon of biology."""
    return any(w[0].isupper() and ("genus" in w or synset.gloss.startswith(("a genus", "genus"))) for w in synset.words)


@lru_cache(maxsize=65536)
def _content(gloss: str) -> frozenset[str]:
    return frozenset(singular(w) for w in re.findall(r"[a-z]{3,}", gloss) if not _LITTLE.match(w))


def _alike(one: str, other: str) -> float:
    a, b = _content(one), _content(other)
    return len(a & b) / max(1, min(len(a), len(b)) + 1)


def text_of(table: Table) -> str:
    """The table as text: a line for each kind, certainty and category with all its nouns, then what is above what."""
    groups: dict[Row, list[str]] = defaultdict(list)
    for noun, row in table.rows():
        groups[row].append(noun.replace(" ", "_"))
    lines = []
    for row in sorted(groups, key=lambda r: (r.kind, r.sure, r.category, r.near)):
        lines.append(f"{row.kind} {row.sure} {row.category or '-'} {row.near or '-'} {' '.join(groups[row])}")
    lines.append("")
    lines += [f"{name} {' '.join(words)}" for name, words in sorted(table.kinds_above().items())]
    return "\n".join(lines) + "\n"


def notice_of(folder: Path) -> str:
    """The notice that goes with every copy, as it stands at the head of the database."""
    lines = (folder / "data.noun").read_text("utf-8").splitlines()
    return "\n".join(line.lstrip()[2:].strip() for line in lines if line.startswith("  ")) + "\n"


def main(words: Sequence[str] | None = None) -> int:
    """Write the table and its notice; 0."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks nouns", description=__doc__)
    parser.add_argument("folder", type=Path, help="folder with data.noun and index.sense of WordNet 3.1")
    folder = parser.parse_args(words).folder
    OUT.mkdir(exist_ok=True)
    written = text_of(Table(read_wordnet(folder))).encode()
    (OUT / "nouns.txt.gz").write_bytes(gzip.compress(written, 9, mtime=0))
    (OUT / "NOTICE").write_text(notice_of(folder), encoding="utf-8")
    return 0
