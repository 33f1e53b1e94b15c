"""How full vessels are, and lids that are open."""

import pytest

from sceneweaver.language.read import read_by_rules


@pytest.mark.parametrize(
    ("text", "category", "value"),
    [
        ("a pub, a jug half full of beer on the counter", "pitcher", "half full of beer"),
        ("a shed with a bucket nearly empty", "bucket", "nearly empty"),
        ("an office with an overflowing bin", "trash_can", "overflowing"),
        ("a den with three mugs half empty on a table", "mug", "half empty"),
        ("an attic, the chest open", "chest", "door open"),
    ],
)
def test_states_of_vessels(text, category, value):
    found = read_by_rules(text).entity(category)
    assert found is not None
    assert value in [one.value for one in found.attributes if one.kind == "state"]
