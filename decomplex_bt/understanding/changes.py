"""Changes: the states that verbs of change end in, and those that they end."""

from __future__ import annotations

from typing import NamedTuple


class Change(NamedTuple):
    """What something is after a change (`ends_in`) and what it is no longer (`ends`), as the words of states."""

    ends_in: frozenset[str] = frozenset()
    ends: frozenset[str] = frozenset()


def change(word: str) -> Change:
    """What a verb of change does, or the state that an order names ("turn it *off*"); of an unknown word nothing."""
    return _CHANGES.get(word, _NONE)


_NONE = Change()
_CHANGES = {
    verb: Change(frozenset(goals.split()), frozenset(needs.split()))
    for verbs, goals, needs in (
        ("on start", "on running lit", "off out"), ("off stop", "off out", "on running lit"),
        ("open", "open ajar", "closed shut"), ("close shut", "closed shut", "open ajar"),
        ("lock bolt", "locked bolted", "unlocked open"), ("unlock unbolt", "unlocked open", "locked bolted shut"),
        ("heat warm reheat microwave", "hot warm", "cold cool lukewarm tepid chilly"),
        ("cool chill", "cold cool chilled", "warm hot lukewarm"),
        ("clean wash rinse wipe scrub mop sweep vacuum hoover dust polish", "clean washed spotless",
         "dirty filthy muddy dusty sticky stained grubby greasy unwashed"),
        ("fill refill run", "full", "empty low"), ("empty", "empty", "full overflowing"),
        ("dry", "dry", "wet damp soaked"), ("defrost thaw", "defrosted thawed", "frozen"),
        ("iron press", "ironed smooth", "wrinkled creased crumpled"),
        ("charge recharge", "charged full", "flat low dead empty"), ("water", "wet moist damp", "dry thirsty"),
        ("cover", "covered", "uncovered bare"), ("uncover", "uncovered bare", "covered"),
        ("light", "lit", "unlit out"), ("blow snuff extinguish", "out unlit", "lit burning"),
        ("wake waken", "awake up", "asleep sleeping dozing napping"),
        ("make", "made", "unmade"), ("fold", "folded", "unfolded crumpled"),
        ("plug", "plugged", "unplugged"), ("unplug", "unplugged", "plugged"),
    )
    for verb in verbs.split()
}  # fmt: skip
"""What verbs of change, or the states that they bring about, are for: the states they end in, and those they end."""
