"""Homes in ``render`` and ``view``: which file is one, what is written, what is refused."""

from __future__ import annotations

import pytest
from PIL import Image

from sceneweaver.cli.home_views import holds_home
from sceneweaver.cli.view import show
from sceneweaver.home import Home


@pytest.fixture
def home(tmp_path):
    path = tmp_path / "home.json"
    Home.example("flat").save(path)
    return path


def test_a_home_is_told_by_its_schema(home, tmp_path):
    (tmp_path / "broken.json").write_text("{")
    assert holds_home(home) and not holds_home(tmp_path / "broken.json") and not holds_home(tmp_path / "none.json")


def test_plans_are_written_as_drawings_and_as_pictures(run, home, tmp_path):
    assert run("render", home, "-o", tmp_path / "plan.svg").code == 0
    assert (tmp_path / "plan.svg").read_text().startswith("<svg")
    assert run("render", home, "-o", tmp_path / "plan.png", "--width", "500").code == 0
    with Image.open(tmp_path / "plan.png") as picture:
        assert picture.width == 500


@pytest.mark.parametrize(
    ("out", "view", "said"),
    [
        ("x.png", "nope", "'nope' is unknown"),
        ("x.svg", "overview", "is no drawing"),
        ("x.png", "all", "give a folder"),
    ],
)
def test_what_cannot_be_drawn_is_said_in_one_line(run, home, tmp_path, out, view, said):
    done = run("render", home, "-o", tmp_path / out, "--view", view)
    assert done.code != 0 and said in done.err and done.err.count("\n") == 1
    assert not (tmp_path / out).exists()


def test_the_page_of_a_home_is_shown_with_the_pictures_of_its_folder(home, tmp_path):
    (tmp_path / "views").mkdir()
    Image.new("RGB", (40, 30)).save(tmp_path / "views" / "overview_ground.png")
    for path in (home, tmp_path):
        page = show(path)[0]().decode()
        assert 'id="room-kitchen"' in page and page.count("<figure><img") == 1
