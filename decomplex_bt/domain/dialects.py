"""Dialects: the plain word for one that only some people say or type ("fae", "owt", "oot").

Only words that are none in plain English, and of which the training corpus has few ("u" and "pls" it knows). What is
meant is read; spans and values keep what was said. A "plus" that lists things is read as the "and" that it stands for.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import product

_WORDS = {
    # Scotland, the north of England, Ireland
    "no": "naw nae",
    "yes": "aye",
    "nothing": "nowt nuttin nothin nothink",
    "anything": "owt anythin anythink",
    "something": "summat sommat somethin somethink summink summin",
    "from": "fae frae",
    "to": "tae",
    "with": "wi wiv wid",
    "do": "dae",
    "give": "gie",
    "go": "gae",
    "have": "hae",
    "take": "tak",
    "make": "mak",
    "out": "oot",
    "about": "aboot abt",
    "around": "aroon aroond",
    "down": "doon",
    "off": "aff",
    "on": "oan",
    "over": "ower",
    "now": "noo",
    "before": "afore",
    "behind": "ahint",
    "between": "atween",
    "house": "hoose",
    "window": "windae",
    "windows": "windaes",
    "head": "heid",
    "you": "ye yous youse yez yiz",
    "your": "yer yir",
    "yourself": "yersel yerself",
    "myself": "masel mesel meself",
    "maybe": "mebbe mibbe mebbies",
    "only": "nobbut",
    # wherever people talk or type fast
    "probably": "prolly probs probly",
    "definitely": "deffo defo",
    "that": "dat",
    "this": "dis",
    "these": "dese",
    "them": "dem",
    "there": "dere",
    "should": "shud",
    "could": "cud",
    "would": "wud",
    "what": "wot wat",
    "though": "tho",
    "through": "thru",
    "night": "nite",
    "tonight": "tonite",
}
_PLAIN = {word: plain for plain, words in _WORDS.items() for word in words.split()}
_STEMS = {stem: stem for stem in "can could did does had has have is are must should was were will would".split()}
_STEMS |= {
    "din": "do",
    "dis": "does",
    "disn": "does",
    "hiv": "have",
    "shid": "should",
    "wid": "would",
    "win": "will",
    "wis": "was",
}
"""What a Scottish "not" is joined to, and the plain word for it."""
_NOTS = frozenset(("nae", "na", "ny", "nay"))
_ENGLISH = frozenset(("arena", "canny"))
_CLIPPED = re.compile(r"[a-z]{2,}in['\u2019]")
_ENDING_IN = frozenset(
    "again aspirin basin begin bargain brain bulletin cabin captain certain chain chin coffin coin colin contain "
    "cousin cumin curtain dolphin drain entertain explain fountain gelatin grain grin join kevin latin login main "
    "maintain mandarin margin martin mountain muffin napkin obtain origin pain penguin plain plugin protein pumpkin "
    "rain raisin remain resin robin satin skin spin stain tarpaulin thin train twin villain violin vitamin".split()
)
"""Whole words, behind which a quote may close."""
_ENDING = frozenset(". ! ? ; :".split())
_DETERMINERS = frozenset("a an the some any my our your his her their this that these those another".split())
_JOINING = frozenset(", . ; : ! ? - and but so then right okay ok".split())


def joined() -> Iterator[tuple[str, str]]:
    """The two parts of each word that joins a verb to a "not" ("can" and "nae" of "cannae"), in lower case."""
    return ((stem, end) for stem, end in product(_STEMS, sorted(_NOTS)) if stem + end not in _ENGLISH)


def is_clipped(word: str) -> bool:
    """Whether a word is an "-ing" without its last letter: "moppin'"."""
    return _CLIPPED.fullmatch(word.lower()) is not None and word[:-1].lower() not in _ENDING_IN


def plain_words(words: Sequence[str]) -> list[str] | None:
    """The words with the plain one for each that is none, one for one; None where there is none such."""
    found: list[str] | None = None
    for i, word in enumerate(words):
        other = _plain_word(words, i)
        if other is not None:
            found = found or list(words)
            found[i] = other.capitalize() if word[0].isupper() else other
    return found


def _plain_word(words: Sequence[str], i: int) -> str | None:
    word = words[i].lower()
    if word in _NOTS and i > 0 and words[i - 1].lower() in _STEMS:
        return "no" if i > 1 and words[i - 2].lower() == "there" else "not"
    if word in _STEMS:
        is_joined = i + 1 < len(words) and words[i + 1].lower() in _NOTS
        return _STEMS[word] if is_joined and _STEMS[word] != word else _PLAIN.get(word)
    if word == "gonnae":  # "gonnae shut it" asks, "she's gonnae come" says what will be
        return "please" if i == 0 or words[i - 1].lower() in _JOINING else None
    if word == "plus" and _lists_on(words, i):
        return "and"
    if is_clipped(word):
        return f"{word[:-1]}g"
    return _PLAIN.get(word)


def _lists_on(words: Sequence[str], i: int) -> bool:
    """Whether a "plus" adds one more thing to those named, and no order: "a plate, *plus* a fork", not ". Plus, the
    light is on"."""
    behind = words[i + 1].lower() if i + 1 < len(words) else ""
    return i > 1 and words[i - 1] not in _ENDING and behind in _DETERMINERS
