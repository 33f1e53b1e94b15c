"""What categories are to each other in a room: which are seats at a table, which stand back to a wall, and so on."""

from __future__ import annotations

from functools import cache

from sceneweaver.assets import categories
from sceneweaver.assets.taxonomy import members


def _set(words: str) -> frozenset[str]:
    return frozenset(words.split())


DESKS = _set(
    "desk corner_desk standing_desk secretary_desk computer_desk dressing_table school_desk teacher_desk reception_desk"
)
"""Tables that one person sits or stands at, from the front."""

DINING = _set(
    "dining_table round_dining_table oval_table conference_table cafe_table bar_table kids_table patio_table"
    " folding_table chess_table poker_table"
)
"""Tables that people sit around."""

SEATED_AT = (
    DESKS
    | DINING
    | _set(
        "activity_table drafting_table lab_bench workbench sewing_machine_table kitchen_island bar_counter"
        " upright_piano digital_piano grand_piano picnic_table train_table"
    )
)
"""What a chair may belong to."""

COFFEE = _set("coffee_table round_coffee_table nesting_tables")

UPRIGHT_SEATS = _set("stool bar_stool piano_bench")
"""Seats at tables beside the members of the group of chairs."""

SOFAS = _set("sofa loveseat sectional_sofa sofa_bed")

LOUNGE = SOFAS | _set("armchair recliner chaise_longue egg_chair rocking_chair bean_bag theater_seat")
"""Seats to rest in, which look at a screen, at a table, at each other or into the room."""

TVS = _set("tv tv_on_stand projector_screen")

DESK_SCREENS = _set("monitor laptop keyboard")
"""What stands on a desk and faces whoever sits at it."""

BEDS = _set(
    "bed single_bed king_bed canopy_bed platform_bed upholstered_bed storage_bed metal_bed toddler_bed hospital_bed"
    " murphy_bed"
)
"""Beds whose back is the head, which goes against a wall."""

LONG_BEDS = _set("bunk_bed loft_bed daybed crib")
"""Beds of which some side goes against a wall."""

WALL_BACKED = _set(
    "wardrobe dresser tallboy sideboard cabinet linen_cabinet shoe_cabinet bookcase low_bookcase display_cabinet"
    " cube_shelf ladder_shelf metal_shelf pantry_shelf filing_cabinet medical_cabinet trophy_case hall_stand shoe_rack"
    " wine_rack bar_cabinet locker card_catalog tall_cabinet kitchen_cabinet kitchen_counter sink_cabinet"
    " coffee_station tv_stand console_table fridge side_by_side_fridge freezer stove oven_tower dishwasher"
    " washing_machine dryer toilet bidet pedestal_sink vanity double_vanity laundry_sink fireplace upright_piano"
    " vending_machine grandfather_clock minibar wine_cooler"
)
"""Large things whose back belongs against a wall, or against the back of another."""

TALL_PLANTS = frozenset(("potted_plant", "palm", "snake_plant", "bamboo_plant", "olive_tree", "fern", "floor_vase"))

WINDOW_WEAR = _set("curtain sheer_curtain window_blind radiator string_lights")
"""What may hang before a window."""

SEE_THROUGH = TALL_PLANTS | _set("floor_lamp tripod_lamp arc_lamp easel music_stand planter_box")
"""Tall things that do not darken a window."""

WALL_ART = _set(
    "picture poster photo_frames tapestry wall_clock wall_mirror round_mirror wall_shelf wall_planter whiteboard"
    " blackboard notice_board menu_board dartboard tv projector_screen"
)

CLOSED = _set("wardrobe locker tall_cabinet safe washing_machine dryer dishwasher stove minibar chest shoe_rack")
"""What may hold things that nobody misses when they are not there."""

EYE_LEVEL = _set("picture poster photo_frames wall_clock tapestry wall_mirror round_mirror")
"""What is looked at, and so hangs at the height of the eyes."""

_KIN: tuple[frozenset[str], ...] = (
    _set("desk standing_desk computer_desk corner_desk secretary_desk"),
    _set("teacher_desk desk"),
    _set("dining_table round_dining_table oval_table"),
    _set("cafe_table round_dining_table dining_table bar_table"),
    _set("conference_table oval_table"),
    _set("kids_table activity_table train_table"),
    _set("coffee_table round_coffee_table nesting_tables ottoman"),
    _set("side_table nightstand"),
    SOFAS,
    _set("armchair recliner egg_chair rocking_chair loveseat chaise_longue"),
    BEDS - {"hospital_bed"} | _set("bunk_bed loft_bed daybed"),
    _set("toddler_bed crib single_bed"),
    _set("chair dining_chair office_chair gaming_chair conference_chair folding_chair school_chair kids_chair"),
    _set("stool bar_stool"),
    _set("wardrobe clothes_rack"),
    _set("dresser tallboy chest"),
    _set("bookcase low_bookcase cube_shelf ladder_shelf display_cabinet library_shelf corner_shelf"),
    _set("cabinet sideboard console_table low_bookcase"),
    _set("filing_cabinet cabinet"),
    TVS,
    _set("tv_stand sideboard low_bookcase"),
    _set("fridge side_by_side_fridge"),
    _set("kitchen_counter kitchen_cabinet corner_cabinet"),
    _set("bathtub freestanding_bathtub"),
    _set("bathtub shower corner_shower freestanding_bathtub"),
    _set("pedestal_sink vanity double_vanity wall_basin"),
    _set("toilet wall_toilet"),
    _set("rug round_rug runner_rug"),
    _set("curtain sheer_curtain window_blind"),
    _set("picture poster photo_frames tapestry"),
    _set("wall_mirror round_mirror gym_mirror standing_mirror medicine_cabinet"),
    _set("whiteboard blackboard mobile_whiteboard projector_screen"),
    _set("ceiling_light pendant chandelier track_light ceiling_fan"),
    _set("floor_lamp tripod_lamp arc_lamp"),
    _set("table_lamp desk_lamp"),
    _set("wastebasket trash_can pedal_bin recycling_bin"),
    TALL_PLANTS,
    _set("monitor laptop"),
)

_ROLES: tuple[frozenset[str], ...] = (
    SOFAS,
    TVS,
    _set("desk standing_desk computer_desk corner_desk secretary_desk"),
    _set("dining_table round_dining_table oval_table"),
    _set("coffee_table round_coffee_table nesting_tables"),
    BEDS - {"hospital_bed", "toddler_bed"} | _set("bunk_bed loft_bed daybed"),
    _set("bookcase low_bookcase cube_shelf ladder_shelf library_shelf corner_shelf"),
    _set("fridge side_by_side_fridge"),
    _set("bathtub freestanding_bathtub"),
    _set("pedestal_sink vanity double_vanity wall_basin"),
    _set("toilet wall_toilet"),
    _set("rug round_rug runner_rug"),
    _set("ceiling_light pendant chandelier track_light ceiling_fan"),
    _set("floor_lamp tripod_lamp arc_lamp"),
    TALL_PLANTS - {"floor_vase"},
)
"""Things of which any takes the role of any other: beside one that was named, another is one too many."""

WORLDS: dict[str, frozenset[str]] = {
    "bathroom": _set("shower_stool bathroom_shelf medicine_cabinet toilet_brush plunger bath_mat"),
    "kitchen": _set(
        "kitchen_cabinet kitchen_counter corner_cabinet wall_cabinet corner_wall_cabinet "
        "sink_cabinet kitchen_island stove oven_tower hob"
        " range_hood dishwasher fridge side_by_side_fridge freezer"
    ),
    "laundry": _set("washing_machine dryer laundry_sink water_heater ironing_board drying_rack"),
    "clinic": _set(
        "dental_chair examination_table iv_stand stretcher hospital_bed medical_scale medical_cabinet"
        " instrument_trolley massage_table privacy_screen"
    ),
    "gym": _set(
        "treadmill spin_bike elliptical rowing_machine stair_climber weight_bench squat_rack smith_machine"
        " dumbbell_rack weight_plate_rack kettlebell_rack barbell cable_machine leg_press punching_bag heavy_bag"
    ),
    "workshop": _set(
        "tool_chest tool_cabinet drill_press table_saw air_compressor sawhorse tire_stack jerry_can workbench"
    ),
    "shop": _set(
        "display_case turnstile kiosk vending_machine beer_tap salad_bar buffet_table ice_machine host_stand stanchion"
        " menu_board cash_register coffee_station bar_counter mailboxes book_return_cart card_catalog"
    ),
    "sleeping": BEDS - {"hospital_bed", "murphy_bed"} | _set("bunk_bed loft_bed crib"),
}
"""Things that belong to one kind of place and are odd anywhere else."""

NEIGHBOURS = {
    frozenset(("bathroom", "laundry")),
    frozenset(("kitchen", "laundry")),
    frozenset(("clinic", "sleeping")),
    frozenset(("kitchen", "shop")),
}
"""Kinds of places whose things are sometimes found in each other."""

NEUTRAL_GROUPS = frozenset(("decor", "lighting", "plant_group", "textile", "container"))
"""Groups that no room is strange for."""

HARMLESS = _set(
    "radiator heater air_conditioner fan air_purifier vacuum_cleaner coat_rack umbrella_stand side_table"
    " wall_shelf coat_hooks key_holder ottoman pouf smoke_detector thermostat light_switch room_divider"
    " fire_extinguisher magazine_rack console_table chair armchair stool bench bookcase low_bookcase"
)
"""Furniture that no room is strange for."""


@cache
def groups_of(category: str) -> frozenset[str]:
    """The groups that a category belongs to, near and far."""
    known, found = categories(), set()
    name: str | None = category
    while name in known and known[name].parent:
        name = known[name].parent
        found.add(name)
    return frozenset(g for g in found if g is not None)


@cache
def kin(category: str) -> frozenset[str]:
    """The categories that may stand in for one another with this one, itself included."""
    return frozenset((category,)).union(*(k for k in _KIN if category in k))


@cache
def same_role(category: str) -> frozenset[str]:
    """The categories that are one more of what a person names by this one, itself included."""
    return frozenset((category,)).union(*(role for role in _ROLES if category in role))


@cache
def serves(category: str, what: tuple[str, ...]) -> int:
    """How well a category serves where one of ``what`` is meant: 2 it is one of them, 1 it may stand in, 0 not."""
    if category in what or any(category in members(name) for name in what):
        return 2
    return int(any(category in kin(name) for name in what))


@cache
def world(category: str) -> str | None:
    """The kind of place that a category belongs to alone; None when it may be anywhere."""
    for name, own in WORLDS.items():
        if category in own:
            return name
    return "bathroom" if "sanitary" in groups_of(category) else None


@cache
def upright_seat(category: str) -> bool:
    """Whether it is a chair to sit on at a table."""
    return category in UPRIGHT_SEATS or ("chair_group" in groups_of(category) and category != "rocking_chair")


@cache
def carries(category: str) -> bool:
    """Whether something should stand on or in it: tables, desks, counters, shelves, and no seats or beds."""
    row = categories().get(category)
    if row is None or not row.holds or category in CLOSED:
        return False
    return not groups_of(category) & {"seating", "bed_group", "tableware"}


def words(category: str) -> str:
    """The name as a user would write it."""
    return category.replace("_", " ")


def a(category: str) -> str:
    """The name with its article."""
    return f"{'an' if category[0] in 'aeiou' else 'a'} {words(category)}"
