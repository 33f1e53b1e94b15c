"""Scenes, solutions and verdicts as HTML: safe, self-contained, and drawn only when asked."""

from __future__ import annotations

import html
import re
import subprocess
import sys
from html.parser import HTMLParser
from pathlib import Path

import pytest

import sceneweaver as sw
from tests.report.browser import BINARY, Browser


class Outline(HTMLParser):
    """Tags and text of a piece of HTML, with a complaint about what is not closed."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags: list[str] = []
        self.text, self.frames = "", []
        self._open: list[str] = []
        self.feed(text)
        assert self._open == []

    def handle_starttag(self, tag, attrs):
        self.tags.append(tag)
        if tag != "img":
            self._open.append(tag)
        if tag == "iframe":
            self.frames.append(dict(attrs))
        for name, value in attrs:
            assert not name.startswith("on") and (name != "src" or value.startswith("data:image/"))

    def handle_endtag(self, tag):
        assert self._open.pop() == tag

    def handle_data(self, data):
        self.text += data + " "


@pytest.fixture(scope="module")
def scene() -> sw.Scene:
    return sw.Scene.example("bedroom")


def test_a_scene(scene):
    seen = Outline(scene._repr_html_())
    assert seen.tags.count("img") == 1 and "17.2 m2" in seen.text and f"{len(scene.objects)}: " in seen.text
    assert len(scene._repr_html_()) < 60_000


def test_a_solution(scene):
    solution = sw.refine(scene, candidates=4, init="current", device="cpu")
    seen = Outline(solution._repr_html_())
    assert "4 of 4 layouts" in seen.text and "img" in seen.tags
    assert "iframe" in Outline(solution.show().html).tags


def test_a_verdict(scene):
    assert "valid yes" in Outline(sw.check(scene)._repr_html_()).text
    moved = scene.move("chair", to=(99.0, 0.0))
    text = Outline(sw.check(moved)._repr_html_()).text
    assert "valid no" in text and "out of bounds" in text and "chair reaches" in text


def test_what_stands_in_a_scene_stays_text():
    room = sw.Room.rectangle(3, 3, kind='<script>alert("x")</script>')
    scene = sw.Scene(id='"><img src=x onerror=alert(1)>', room=room)
    Outline(scene._repr_html_())
    frame = Outline(scene.show().html)
    assert frame.tags == ["iframe"]
    page = frame.frames[0]["srcdoc"]
    assert "<img src=x" not in page and "<script>alert" not in page


def test_the_frame_loads_nothing_and_may_do_little(scene):
    (frame,) = Outline(scene.show(width=500, height=300).html).frames
    assert (frame["width"], frame["height"], frame["sandbox"]) == ("500", "300", "allow-scripts")
    assert "default-src 'none'" in frame["srcdoc"] and not re.search(r"(src|href)=\"(?!data:)", frame["srcdoc"])
    assert len(frame["srcdoc"]) < 1_000_000


@pytest.mark.parametrize("size", [{"width": 10}, {"height": 1e9}, {"width": "50%"}, {"height": True}])
def test_sizes_out_of_range(scene, size):
    with pytest.raises(sw.InputError, match="is not a whole number from 200 to 4000 pixels"):
        scene.show(**size)


def test_nothing_of_it_is_loaded_before_it_is_needed():
    code = "import sys, sceneweaver as sw; sw.Scene.example(); print('sceneweaver.notebook' in sys.modules)"
    out = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert out.stdout.strip() == "False"


@pytest.mark.skipif(BINARY is None, reason="no Chromium here")
def test_the_view_runs_in_its_frame(scene, tmp_path: Path):
    page = html.unescape(Outline(scene.show().html).frames[0]["srcdoc"])
    path = tmp_path / "frame.html"
    path.write_text(f"<body>{scene.show(width=600, height=400).html.replace('sandbox=', 'data-was=')}</body>", "utf-8")
    assert page.startswith("<!doctype html>")
    inner = "document.querySelector('iframe').contentDocument"
    with Browser(640, 440) as browser:
        browser.open(path.as_uri())
        browser.wait(f"{inner}.getElementById('stage').className === 'stage running'")
        assert browser.js(f"{inner}.getElementById('stage').clientHeight") == 400
        assert [line for line in browser.logs if not line.startswith("request: file:")] == []
