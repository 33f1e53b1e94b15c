"""What is kept of costly results."""

from sceneweaver.assets.recent import Recent


def test_the_last_values_are_kept_up_to_a_size() -> None:
    made: list[int] = []

    def make(k: int) -> str:
        made.append(k)
        return "x" * 40

    kept: Recent[int, str] = Recent(100, len)
    for k in (1, 2, 1, 3, 1, 2):
        kept.get(k, lambda k=k: make(k))
    assert made == [1, 2, 3, 2]  # 2 went for 3, as 1 had been used since
    assert kept.nbytes == 80 and (kept.hits, kept.misses) == (2, 4)
    assert kept.get(9, lambda: "y" * 1000) == "y" * 1000
    assert kept.nbytes == 1000  # what is alone stays, however large
