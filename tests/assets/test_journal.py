"""What processes tell each other."""

from pathlib import Path

from sceneweaver.assets.journal import Journal, journal_key

ONE, TWO = journal_key("one", 1), journal_key("two", 2.5)


def test_one_tells_and_another_reads(tmp_path: Path) -> None:
    first, second = Journal(tmp_path / "j"), Journal(tmp_path / "j")
    assert second.get(ONE) is None
    first.put(ONE, b"value")
    first.put(TWO, b"")
    second._looked = -10.0  # time goes by
    assert second.get(ONE) == b"value" and second.get(TWO) == b""
    assert Journal(tmp_path / "j").get(ONE) == b"value"


def test_what_is_half_written_is_not_read_until_it_is_whole(tmp_path: Path) -> None:
    writer = Journal(tmp_path)
    writer.put(ONE, b"a" * 100)
    writer.put(TWO, b"b" * 100)
    (file,) = tmp_path.glob("*.journal")
    content = file.read_bytes()
    for cut in (len(content) - 1, len(content) - 110, len(content) - 124 + 1):
        file.write_bytes(content[:cut])
        reader = Journal(tmp_path)
        assert reader.get(ONE) == b"a" * 100 and reader.get(TWO) is None
        file.write_bytes(content)
        reader._looked = -10.0
        assert reader.get(TWO) == b"b" * 100
    file.write_bytes(content[:-1] + b"c")
    assert Journal(tmp_path).get(TWO) is None


def test_a_place_that_cannot_be_written_is_no_error(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    journal = Journal(tmp_path / "file" / "j")
    journal.put(ONE, b"value")
    assert journal.get(ONE) is None
