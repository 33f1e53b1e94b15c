"""Labels of files: words, numbers, ids and codes, and what they mean."""

from __future__ import annotations

import random
import uuid

import pytest

from sceneweaver.importers import SourceObject, SourceRoom, category_of, to_scene

LABELS = {
    "DiningTable_3": "dining_table",
    "dining table12": "dining_table",
    "king-size bed": "king_bed",
    "tv_stand-0": "tv_stand",
    "TVStand_203_1": "tv_stand",
    "TV": "tv",
    "tv2": "tv",
    "4k tv": "tv",
    "Chair.001": "chair",
    "chair1": "chair",
    "SM_Chair_02a": "chair",
    "sofa2b": "sofa",
    "2-seater sofa": "sofa",
    "bed_1_2": "bed",
    "Bed|1|2|3": "bed",
    "bunk_bed_1_2_3": "bunk_bed",
    "3d printer": "printer_3d",
    "chair-4602591c-785f-408d-bae3-10bc6bae9e6b": "chair",
    "88be8ad75f274c7b8da4a54fef3aaac9 desk": "desk",
}


@pytest.mark.parametrize(("label", "category"), LABELS.items())
def test_words_beside_numbers_and_ids_are_read(label, category):
    named = category_of(label)
    assert named.category == category
    assert named.confidence >= 0.7


@pytest.mark.parametrize(
    "code",
    [
        "",
        "12",
        "4daa",
        "b0",
        "x3",
        "g12",
        "sm_02",
        "B07B4MJYQH",
        "dQw4w9WgXcQ",
        "a4632de8-8892-4f16",
        "4602591c-785f-408d-bae3-10bc6bae9e6b",
        "4602591C_785F_408D_BAE3_10BC6BAE9E6B",
        "abcdefab-cdef-abcd-efab-cdefabcdefab",
        "88be8ad75f274c7b8da4a54fef3aaac9",
        "deadbeef",
    ],
)
def test_an_id_or_a_code_alone_is_no_label(code):
    assert category_of(code)[:2] == ("object", 0.0)


def test_no_id_of_many_means_anything():
    dice = random.Random(4)
    for _ in range(500):
        name = str(uuid.UUID(int=dice.getrandbits(128)))
        for written in (name, name.upper(), name.replace("-", ""), name.replace("-", "_")):
            assert category_of(written).confidence == 0.0, written


def test_ids_alone_are_said_to_be_no_labels():
    things = tuple(
        SourceObject(f"t{k}", str(uuid.UUID(int=k << 64 | 0xDADA)), (1.0 + k, 1.0, 0.2), size=(0.4, 0.4, 0.4))
        for k in range(2)
    )
    found = to_scene(
        SourceRoom("r", outline=((0, 0), (4, 0), (4, 3), (0, 3)), height=2.6, objects=things), "mine", name="r"
    )
    assert set(found.confidence.values()) == {0.0}
    assert {o.category for o in found.scene.objects} == {"object"}
    assert sum("is no known category" in note for note in found.notes) == len(things)
