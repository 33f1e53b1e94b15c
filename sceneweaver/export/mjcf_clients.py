"""MJCF for one reader: what MuJoCo, or a library that reads MJCF by its own rules, takes beyond the file for all."""

from __future__ import annotations

import math
from collections.abc import Callable
from xml.etree import ElementTree as Xml

from sceneweaver.physics.xml import child, text

SLEEP_TOLERANCE = 0.005
"""[m/s] below which MuJoCo lets bodies sleep: what rests on hulls trembles by less."""


def sleeping(root: Xml.Element) -> None:
    """What is at rest sleeps, which MuJoCo has since 3.4; older ones refuse the file."""
    option = root.find("option")
    option = child(root, "option") if option is None else option
    option.set("sleep_tolerance", text(SLEEP_TOLERANCE))
    flag = option.find("flag")
    (child(option, "flag") if flag is None else flag).set("sleep", "enable")


def sleeping_twin(file: str, model: str) -> bytes:
    """A file beside ``file`` that is the same room, sleeping."""
    root = Xml.Element("mujoco", model=model)
    child(root, "include", file=file)
    sleeping(root)
    Xml.indent(root, " ")
    return (Xml.tostring(root, encoding="unicode") + "\n").encode()


def inlined(root: Xml.Element) -> None:
    """No classes, each element says all: for robosuite, which knows no ``childclass``. Its worlds count in radians."""
    classes = {d.get("class"): d for d in root.iterfind("default/default")}

    def fill(element: Xml.Element, inherited: str | None) -> None:
        inherited = element.attrib.pop("childclass", inherited)
        own = element.attrib.pop("class", inherited)
        source = classes[own].find(element.tag) if own in classes else None
        for key, value in source.attrib.items() if source is not None else ():
            if key not in element.attrib:
                element.set(key, value)
        if element.tag == "joint" and element.get("type") == "hinge":
            element.set("range", text([math.radians(float(v)) for v in element.get("range", "0 0").split()]))
        for below in element:
            fill(below, inherited)

    world = root.find("worldbody")
    assert world is not None
    fill(world, None)
    for default in root.findall("default"):
        root.remove(default)
    root.insert(0, Xml.Element("compiler", angle="radian"))


def without_excludes(root: Xml.Element) -> None:
    """No pairs of bodies whose contacts are left out: Genesis spends minutes on them."""
    for contact in root.findall("contact"):
        root.remove(contact)


def without_margins(root: Xml.Element) -> None:
    """No distance at which parts touch already: Newton sets it to 0 and warns of each part."""
    for geom in root.iter("geom"):
        geom.attrib.pop("margin", None)


CLIENTS: dict[str, Callable[[Xml.Element], None]] = {
    "mujoco": sleeping,
    "robosuite": inlined,
    "genesis": without_excludes,
    "newton": without_margins,
}
"""Readers that need more than the file for all. It suits the other clients of the format as it is."""
