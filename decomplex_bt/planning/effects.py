"""What plan steps do to states, for those who must know it without a planner: beliefs and assumed states."""

from __future__ import annotations

_EFFECTS: dict[str, tuple[tuple[int, str, str], ...]] = {
    # action: (index of the object, state pair, value)
    "open-up": ((0, "aperture", "open"),),
    "close-up": ((0, "aperture", "closed"),),
    "switch-on": ((0, "power", "on"),),
    "switch-off": ((0, "power", "off"),),
    "heat": ((0, "temperature", "hot"), (1, "power", "on")),
    "wash": ((0, "cleanliness", "clean"), (1, "power", "on")),
    "chill": ((0, "temperature", "cold"), (1, "aperture", "closed")),
    "rinse": ((0, "cleanliness", "clean"),),
    "fill": ((0, "fill", "full"),),
    "drain": ((0, "fill", "empty"),),
    "drain-place": ((0, "fill", "empty"),),
    "wipe": ((0, "cleanliness", "clean"),),
}


def values_after(name: str, objects: tuple[str, ...]) -> dict[tuple[str, str], str]:
    """The values of (entity, state pair) that an action of the domain brings about by itself; a test holds this against
    domain.pddl."""
    return {(objects[index], pair): value for index, pair, value in _EFFECTS.get(name, ())}
