"""Where the words stand that a model quotes."""

from __future__ import annotations

import unicodedata

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sceneweaver.language import Span
from sceneweaver.language.by_model.quotes import MOST, Quotes
from tests.sizes import examples


def place(text: str, quote: str) -> str | None:
    """The words of a text at the first place of a quote."""
    found = Quotes(text).all(quote)
    return text[slice(*found[0])] if found else None


@pytest.mark.parametrize(
    ("text", "quote", "found"),
    [
        ("a Bed and a lamp", "bed", "Bed"),
        ("a bedroom with a bed", "bed", "bed"),
        ("ein Nachttisch", "tisch", "tisch"),
        ("a  queen\n bed", "queen bed", "queen\n bed"),
        ("the child’s bed", "child's bed", "child’s bed"),
        ("a book\u2011case", "book-case", "book\u2011case"),
        (unicodedata.normalize("NFD", "un canapé rouge"), "canapé", unicodedata.normalize("NFD", "canapé")),
        ("un canapé", unicodedata.normalize("NFD", "canapé"), "canapé"),
        ("un canapé rouge", "canape", "canapé"),
        ("Große Straße", "GROSSE", "Große"),
        ("一张双人床和书桌", "双人床", "双人床"),
        ("窓際に机を置いてください", "机", "机"),
        ("ソファとﾃｰﾌﾞﾙ", "テーブル", "ﾃｰﾌﾞﾙ"),
        ("سَرِير كبير", "سرير", "سَرِير"),
        ("غرفة نـــوم", "غرفة نوم", "غرفة نـــوم"),
        (unicodedata.normalize("NFD", "큰 침대"), "침대", unicodedata.normalize("NFD", "침대")),
        ("a bed 👩‍👩‍👧 and 🛋️", "🛋", "🛋️"),
        ("a👍🏽b", "👍", None),
        ("a bed", "desk", None),
        ("a bed", "", None),
        ("", "bed", None),
    ],
)
def test_words_are_found_as_people_see_them(text: str, quote: str, found: str | None) -> None:
    assert place(text, quote) == found


def test_whole_words_come_first_and_each_place_in_turn() -> None:
    text = "a bedroom, a bed, a chair and a chair"
    quotes, taken = Quotes(text), set[Span]()
    assert [text[slice(*span)] for span in quotes.all("bed")] == ["bed"]
    assert quotes.all("bed")[0].start == 13
    first = quotes.next("chair", taken)
    assert first is not None
    taken.add(first)
    second = quotes.next("chair", taken)
    assert second is not None
    assert first.start < second.start
    taken.add(second)
    assert quotes.next("chair", taken) == first
    assert quotes.nearest("chair", Span(33, 37)) == second
    assert quotes.nearest("desk", None) is None


def test_many_places_of_a_word_take_no_time() -> None:
    quotes = Quotes("a" * 20_000)
    assert all(len(quotes.all("a")) == MOST for _ in range(400))


@examples(50, 150)
@given(st.text(max_size=40), st.integers(0, 40), st.integers(0, 40))
def test_what_is_found_is_within_the_text_and_never_empty(text: str, start: int, length: int) -> None:
    for span in Quotes(text).all(text[start : start + length]):
        assert 0 <= span.start < span.end <= len(text)


@examples(30, 100)
@given(st.text(st.characters(categories=("Lu", "Ll", "Lo", "Zs")), min_size=1, max_size=30), st.data())
def test_letters_are_found_where_they_were_taken_from(text: str, data: st.DataObject) -> None:
    start = data.draw(st.integers(0, len(text) - 1))
    quote = text[start : data.draw(st.integers(start + 1, len(text)))]
    seen = unicodedata.normalize("NFKC", quote).strip()
    if seen and quote.strip() == quote and not any(0x1100 <= ord(c) <= 0x11FF for c in text):
        assert Quotes(text).all(quote)
