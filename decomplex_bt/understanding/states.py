"""States: which are opposites, which lie near each other, which tell of one and the same matter."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

OPPOSITES: Mapping[str, str] = MappingProxyType(
    {
        word: opposite
        for first, second in (
            ("bright", "dark"), ("bright", "dim"), ("long", "short"), ("tall", "short"), ("heavy", "light"),
            ("deep", "shallow"), ("thick", "thin"), ("wide", "narrow"), ("strong", "weak"), ("hard", "soft"),
            ("sharp", "blunt"), ("calm", "rough"), ("smooth", "rough"), ("tidy", "messy"),
            ("cooled", "hot"), ("thawed", "frozen"), ("melted", "frozen"), ("dried", "wet"), ("emptied", "full"),
            ("on", "off"), ("open", "closed"), ("open", "shut"), ("hot", "cold"), ("warm", "cold"), ("clean", "dirty"),
            ("full", "empty"), ("locked", "unlocked"), ("awake", "asleep"), ("wet", "dry"), ("in", "out"),
            ("home", "out"), ("home", "away"), ("inside", "outside"), ("up", "down"), ("free", "occupied"),
            ("free", "busy"), ("running", "stopped"), ("done", "running"), ("finished", "running"), ("lit", "unlit"),
            ("charged", "flat"), ("alive", "dead"), ("early", "late"), ("light", "dark"), ("ripe", "unripe"),
            ("made", "unmade"), ("plugged", "unplugged"), ("loose", "tight"), ("high", "low"), ("present", "absent"),
            ("good", "bad"), ("working", "broken"), ("fresh", "stale"), ("fresh", "old"), ("quiet", "loud"),
            ("large", "small"), ("big", "small"), ("full", "low"), ("raining", "dry"), ("upstairs", "downstairs"),
        )
        for word, opposite in ((first, second), (second, first))
    }
)  # fmt: skip
"""States to an opposite (of several, to the last here), for mentions such as "if it is on … if it is off"; open
vocabulary, not only the domain's."""

SCALES: tuple[frozenset[str], ...] = tuple(
    frozenset(words.split())
    for words in (
        "hot warm lukewarm tepid cold cool chilled frozen freezing boiling", "wet dry damp moist soaked soaking soggy",
        "clean dirty filthy muddy dusty stained spotless grubby", "locked unlocked open closed shut ajar",
        "asleep awake sleeping dozing crying fussing", "hungry thirsty starving full fed", "running dry",
        "burnt burned charred", "done cooked raw ready baked", "fresh sour stale mouldy moldy rotten spoiled spoilt",
        "salty sweet spicy bland", "creased wrinkled crumpled", "squeaking squeaky creaking",
        "torn ripped cracked chipped broken damaged intact", "sticking stuck jammed", "sick ill poorly feverish",
        "plugged unplugged", "on off running stopped lit unlit blinking flashing flickering", "heavy",
        "blue red green yellow amber black white grey gray brown pink orange purple", "dead alive wilting wilted",
        "full half empty overflowing", "on off blinking flashing red green amber yellow orange",
        "raining pouring snowing sunny dry shining",
    )
)  # fmt: skip
"""States that tell of one and the same matter."""
_POLES = tuple(
    frozenset(words.split())
    for words in (
        "hot warm boiling scalding", "cold cool chilled frozen freezing", "wet damp moist soaked soaking soggy",
        "dirty filthy muddy dusty stained grubby", "asleep sleeping dozing", "burnt burned charred",
        "broken cracked chipped torn ripped", "sour stale mouldy moldy rotten spoiled spoilt", "hungry thirsty",
        "raining pouring snowing hailing drizzling windy stormy foggy icy", "on blinking flashing flickering",
        "lit blinking flashing flickering",
    )
)  # fmt: skip
"""States at the same end of a scale: neither is the other's opposite."""


def are_near(state: str, other: str) -> bool:
    """Whether two states stand at the same end of a scale: "raining" and "snowing", "wet" and "damp"."""
    return state != other and any(state in pole and other in pole for pole in _POLES)


def are_apart(state: str, other: str) -> bool:
    """Whether two states tell of different matters: "done" and "burnt", "asleep" and "cold"; not where that is not
    known of one."""
    scales, others = ({i for i, scale in enumerate(SCALES) if word in scale} for word in (state, other))
    return bool(scales) and bool(others) and scales.isdisjoint(others)


def are_alike(state: str, other: str) -> bool:
    """Whether two states are known to tell of one and the same matter: "hot" and "lukewarm"."""
    return any(state in scale and other in scale for scale in SCALES)
