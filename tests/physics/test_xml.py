"""Elements as text, beside the writer of the standard library."""

from __future__ import annotations

from xml.etree import ElementTree

import numpy as np

from sceneweaver.physics.xml import child, document


def test_text_of_elements_is_that_of_the_standard_library() -> None:
    root = ElementTree.Element("mujoco", model='a "model" of <é> & more\n\tlines\r')
    world = child(root, "worldbody")
    body = child(world, "body", {"name": "a/b's"}, pos=np.array([1 / 3, 0, -2e-7]), mass=1)
    child(body, "geom", size=(0.1, 2), friction=0.5)
    child(child(body, "body", name="within"), "site", name="tip > top")
    child(root, "empty")
    written = document(root)
    ElementTree.indent(root, " ")
    assert written == ElementTree.tostring(root, encoding="unicode") + "\n"
    assert [e.attrib for e in ElementTree.fromstring(written).iter()] == [e.attrib for e in root.iter()]
