"""Requests in several languages, each with what a careful model answers."""

from __future__ import annotations

from typing import Any

GERMAN = (
    "Ein Arbeitszimmer mit einem großen Schreibtisch am Fenster, zwei schwarzen Bürostühlen daran und einem Regal "
    "aus Eiche an der linken Wand. Auf dem Schreibtisch steht eine Lampe. Kein Teppich."
)
GERMAN_READ: dict[str, Any] = {
    "language": "German",
    "room": {"kind": "office", "quote": "Arbeitszimmer"},
    "things": [
        {
            "id": "d",
            "name": "desk",
            "quote": "Schreibtisch",
            "count": [1, 1],
            "words": [{"kind": "size", "value": "large", "quote": "großen"}],
        },
        {
            "id": "c",
            "name": "office chair",
            "quote": "Bürostühlen",
            "count": [2, 2],
            "words": [{"kind": "color", "value": "black", "quote": "schwarzen"}],
        },
        {
            "id": "s",
            "name": "bookshelf",
            "quote": "Regal",
            "count": [1, 1],
            "words": [{"kind": "material", "value": "oak", "quote": "Eiche"}],
        },
        {"id": "l", "name": "desk lamp", "quote": "Lampe", "count": [1, 1]},
    ],
    "relations": [
        {"type": "near", "subject": "d", "targets": ["window"], "quote": "am Fenster"},
        {"type": "at", "subject": "c", "targets": ["d"], "quote": "daran"},
        {"type": "against", "subject": "s", "targets": ["wall:left"], "quote": "an der linken Wand"},
        {"type": "on", "subject": "l", "targets": ["d"], "quote": "Auf dem Schreibtisch"},
    ],
    "exclusions": [{"quote": "Kein Teppich", "names": ["rug"]}],
}

CHINESE = "一间约12平方米的儿童房，靠墙放一张双层床，窗前有一张白色书桌和一把椅子，不要电视。"
CHINESE_READ: dict[str, Any] = {
    "language": "Chinese",
    "room": {"kind": "children's room", "quote": "儿童房", "area": 12, "for_whom": ["儿童"]},
    "things": [
        {"id": "bed", "name": "bunk bed", "quote": "双层床", "count": [1, 1]},
        {
            "id": "desk",
            "name": "desk",
            "quote": "书桌",
            "count": [1, 1],
            "words": [{"kind": "color", "value": "white", "quote": "白色"}],
        },
        {"id": "chair", "name": "chair", "quote": "椅子", "count": [1, 1]},
    ],
    "relations": [
        {"type": "against", "subject": "bed", "targets": ["wall"], "quote": "靠墙"},
        {"type": "at", "subject": "desk", "targets": ["window"], "quote": "窗前"},
        {"type": "at", "subject": "chair", "targets": ["desk"], "implied": True},
    ],
    "exclusions": [{"quote": "不要电视", "names": ["TV"]}],
}

SPANISH = "Un comedor para seis personas con una mesa redonda de nogal, seis sillas alrededor y una lámpara encima."
SPANISH_READ: dict[str, Any] = {
    "language": "Spanish",
    "room": {"kind": "dining room", "quote": "comedor", "people": 6},
    "things": [
        {
            "id": "table",
            "name": "dining table",
            "quote": "mesa",
            "count": [1, 1],
            "words": [
                {"kind": "shape", "value": "round", "quote": "redonda"},
                {"kind": "material", "value": "walnut", "quote": "nogal"},
            ],
        },
        {"id": "chair", "name": "dining chair", "quote": "sillas", "count": [6, 6]},
        {"id": "lamp", "name": "pendant lamp", "quote": "lámpara", "count": [1, 1]},
    ],
    "relations": [
        {"type": "around", "subject": "chair", "targets": ["table"], "quote": "alrededor"},
        {"type": "above", "subject": "lamp", "targets": ["table"], "quote": "encima"},
    ],
}

JAPANESE = "六畳の和室に低いちゃぶ台と座布団を四つ、隅に箪笥を置いてください。それ以外は何もいりません。"
JAPANESE_READ: dict[str, Any] = {
    "language": "Japanese",
    "room": {"kind": "living room", "quote": "和室", "area": 9.7, "style": "scandinavian"},
    "things": [
        {
            "id": "t",
            "name": "low table",
            "quote": "ちゃぶ台",
            "count": [1, 1],
            "words": [{"kind": "size", "value": "low", "quote": "低い"}],
        },
        {"id": "z", "name": "floor cushion", "quote": "座布団", "count": [4, 4]},
        {"id": "k", "name": "chest of drawers", "quote": "箪笥", "count": [1, 1]},
    ],
    "relations": [{"type": "at", "subject": "k", "targets": ["corner"], "quote": "隅に"}],
    "only": True,
}

ARABIC = "غرفة جلوس كبيرة فيها أريكتان متقابلتان وبينهما طاولة قهوة، وسجادة حمراء على الأرض."
ARABIC_READ: dict[str, Any] = {
    "language": "Arabic",
    "room": {"kind": "living room", "quote": "غرفة جلوس", "scale": 1.3},
    "things": [
        {"id": "sofa", "name": "sofa", "quote": "أريكتان", "count": [2, 2]},
        {"id": "table", "name": "coffee table", "quote": "طاولة قهوة", "count": [1, 1]},
        {
            "id": "rug",
            "name": "rug",
            "quote": "سجادة",
            "count": [1, 1],
            "words": [{"kind": "color", "value": "red", "quote": "حمراء"}],
        },
    ],
    "relations": [
        {"type": "facing", "subject": "sofa", "targets": ["sofa"], "quote": "متقابلتان"},
        {"type": "between", "subject": "table", "targets": ["sofa"], "quote": "وبينهما"},
        {"type": "on", "subject": "rug", "targets": ["floor"], "quote": "على الأرض"},
    ],
}

REQUESTS: dict[str, tuple[str, dict[str, Any]]] = {
    "German": (GERMAN, GERMAN_READ),
    "Chinese": (CHINESE, CHINESE_READ),
    "Spanish": (SPANISH, SPANISH_READ),
    "Japanese": (JAPANESE, JAPANESE_READ),
    "Arabic": (ARABIC, ARABIC_READ),
}
