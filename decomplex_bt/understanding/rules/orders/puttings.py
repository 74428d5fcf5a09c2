"""Puttings: whether to put or lay something is to place it, or to change how something is ("put *on the radio*", "lay
*the table*")."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from decomplex_bt.understanding.document import ENDS, Token
from decomplex_bt.understanding.features import Observed

LAYING = frozenset(("lay", "set"))
"""What is done to a table."""
_PLAYED = frozenset("music song film movie tune album playlist podcast news".split())
_COOKERS = frozenset("hob stove cooker range".split())
"""What has power, and things are put on."""
_BURNING = frozenset("fire flame light lamp candle cigarette torch lantern stove it they them".split())
_CHANGING = frozenset(("on", "off", "out", "up", "through", "to"))
_CLAUSE_ENDS = ENDS | frozenset((",", ":", "and", "or", "but"))


def is_put_somewhere(said: Sequence[Token]) -> bool:
    """ "Put the cup" without "on", "off", "out" or "up" changes no state, it places, however little else is said."""
    words = [token.lower for token in said]
    words = words[: next((i for i, word in enumerate(words) if word in ENDS), len(words))]
    clause = said[: next((i for i, word in enumerate(words) if word in _CLAUSE_ENDS), len(words))]
    if "out" in words[: len(clause)] and _BURNING.isdisjoint(token.lemma for token in clause):
        return True  # "put out six plates"
    return not _CHANGING.intersection(words) and ("down" not in words or words[0] == "down")


def is_put_on(observed: Observed, said: Sequence[Token]) -> bool:
    """ "Put on the radio", "put out the candles": with a particle right behind it, to put is to switch; not "put out
    the plates on the table". What is played or switched is put on wherever it is ("put on a film in the kitchen")."""
    clause = said[: next((i for i, token in enumerate(said) if token.lower in _CLAUSE_ENDS), len(said))]
    if _is_played(observed, clause) or _is_put_out(observed, clause):
        return True
    if any(
        one.lower in ("on", "in", "onto", "into") and two.tag in ("DT", "PRP$") for one, two in pairwise(clause[2:])
    ):
        return False
    if bool(said) and said[0].lower == "out" and _BURNING.isdisjoint(token.lemma for token in clause):
        return False
    return bool(said) and said[0].lower in ("on", "out") and (said[0].tag == "RP" or said[0].dep == "prt")


def _is_put_out(observed: Observed, clause: Sequence[Token]) -> bool:
    """Whether it is put out, and something that burns was spoken of: "if the fire smokes, *put it out*"."""
    if [token.lower for token in clause[:2]] not in (["it", "out"], ["them", "out"]):
        return False
    is_whole = len(clause) == 2 or clause[2].pos in ("ADV", "CCONJ", "PUNCT")
    before = observed.document.tokens[: clause[0].i]
    return is_whole and any(token.pos == "NOUN" and token.lemma in _BURNING for token in before)


def _is_played(observed: Observed, clause: Sequence[Token]) -> bool:
    """Whether an "on" has something behind it that is played, or has power to be switched."""
    if not clause or clause[0].lower != "on":
        return False
    behind = clause[1:]
    parts = ("ADJ", "PROPN", "NOUN")  # with nothing behind: not "put on the shelf the radio"
    noun = next((i for i, token in enumerate(behind) if token.pos not in parts and i), len(behind))
    if not noun or any(token.tag in ("DT", "PRP$") for token in behind[noun : noun + 1]):
        return False
    lemma = behind[noun - 1].lemma
    if lemma in _COOKERS:
        return False
    return lemma in _PLAYED or "power" in observed.gazetteer.changeable.get(lemma, ())


def is_the_table(said: Sequence[Token]) -> bool:
    """ "Lay the table", "set the kitchen table": that is no thing which is put somewhere."""
    noun = next(
        (i for i, token in enumerate(said) if token.pos not in ("DET", "ADJ", "PROPN", "NOUN", "PRON")), len(said)
    )
    return bool(said[:noun]) and said[noun - 1].lemma == "table"
