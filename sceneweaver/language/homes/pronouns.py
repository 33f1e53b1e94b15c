"""Words that mean rooms which were named before: "one of them", "each with ..."."""

from __future__ import annotations

from sceneweaver.language.model import Span

from .parts import Named, Reading

PER_EACH = (
    "each",
    "both",
    "everyone",
    "everybody",
    "per",
    "every",
    "each of them",
    "both of them",
    "each of which",
    "for each",
    "each one",
)
"""Words that mean every one of several."""


def read_pronouns(reading: Reading) -> None:
    """ "One of them", "each with", "two on the ground floor": some of the rooms that were named last."""
    tokens = reading.tokens
    for sentence in reading.sentences():
        for k in sentence:
            token = tokens[k]
            before = [one for one in reading.named if one.at < k and one.at >= sentence.start and one.of is None]
            nearby = [one for one in before if k - one.at < 14]
            after = tokens[k + 1] if k + 1 < len(tokens) else None
            if not nearby or any(one.first <= k <= one.last for one in reading.named):
                continue
            whole = next((one for one in reversed(nearby) if one.count is None or one.count > 1), nearby[-1])
            of_them = after is not None and (
                after.has("of_them") or after.text in ("of",) and k + 2 < len(tokens) and tokens[k + 2].text == "them"
            )
            count = token.get("number")
            if (
                count is not None
                and after is not None
                and (of_them or after.text in ("en-suite", "with", "is", "has", ",") or after.get("room") == "ensuite")
            ):
                if not of_them and tokens[k - 1].text not in (",", ":", "and", "("):
                    continue
                _refer(reading, whole, k, int(count), k + 1 if of_them else k)
            elif (
                token.text in PER_EACH
                and after is not None
                and (
                    after.text in ("with", "has", "have", "gets", "has its own", ",")
                    or after.has("joint", "room", "area")
                )
            ):
                _refer(reading, whole, k, None, k)
    reading.named.sort(key=lambda one: one.at)


def _refer(reading: Reading, whole: Named, at: int, count: int | None, last: int) -> None:
    if any(one.at == at for one in reading.named):
        return
    span = Span(reading.tokens[at].span.start, reading.tokens[last].span.end)
    reading.named.append(Named(whole.kind, at, at, last, span, count, "number" if count else "", of=whole))
    for k in range(at, last + 1):
        reading.did(k, "rooms")
