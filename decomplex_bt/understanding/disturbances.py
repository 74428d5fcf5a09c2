"""Disturbances: what becomes of an instruction on its way from a mouth or a keyboard, with its annotation carried on.

Each takes an annotated instruction and a generator and gives a disturbed copy, whose meaning a human reader still gets:
"if", "unless" and "otherwise" are never lost, though "not" may be heard as "knot".
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import pairwise
from types import MappingProxyType

import numpy as np

from decomplex_bt.instruction import Instruction
from decomplex_bt.understanding.noise import (
    Change,
    changed,
    edited,
    spans_of,
    valued_as,
    without_case,
    without_marks,
    without_punctuation,
)

Disturbance = Callable[[Instruction, np.random.Generator], Instruction]

FILLER_RATE = 0.1
"""Share of words with a filler before them; at least one in an instruction."""
HESITATIONS = ("um", "uh", "er", "erm", "uhm")
FILLERS = (*HESITATIONS, "you know", "I mean", "like", "please", "well", "okay", "sort of", "just", "hmm")
"""What may stand between words; inside an argument only a hesitation does."""

SLIP_RATE = 0.02
"""Share of letters that a finger slips on: about one in ten words."""
_KEYBOARD = ("qwertyuiop", "asdfghjkl", "zxcvbnm")
_NEXT_KEYS = {
    key: "".join(row[max(0, i - 1) : i] + row[i + 1 : i + 2]) for row in _KEYBOARD for i, key in enumerate(row)
}

HOMOPHONE_RATE = 0.15
"""Share of words with a homophone that are heard as it."""
DROP_RATE = 0.08
"""Share of short function words that are not heard."""
CONTRACTION_RATE = 0.5
"""Share of contractions that come without their apostrophe or in two words, and of full forms that are contracted."""
_DROPPED = frozenset("the a an of to at in and is are will that some my".split())
_SOUNDS_ALIKE = (
    "two to too", "for four", "there their", "hear here", "right write", "by buy", "know no", "new knew", "one won",
    "see sea", "be bee", "meet meat", "mail male", "pair pear", "flower flour", "stairs stares", "wait weight",
    "week weak", "hole whole", "where wear", "whether weather", "steal steel", "ate eight", "through threw",
    "your you're", "our hour", "son sun", "which witch", "would wood", "break brake", "peace piece", "not knot",
    "need knead", "plain plane", "pour poor", "roll role", "tea tee", "sweet suite", "board bored", "him hymn",
)  # fmt: skip
_HOMOPHONES = {
    word: tuple(other for other in group.split() if other != word) for group in _SOUNDS_ALIKE for word in group.split()
}
_BE_LIKE = frozenset("is are was do does did has have could should would".split())
_SUBJECTS = frozenset("it that he she there what who".split())
_WORD = re.compile(r"[^\W_]+(?:['’][^\W_]+)*")
_NUMBER = re.compile(r"(?<![\w.:])(\d{1,2})(?::(\d\d))?(?![\w:]|\.\d)")
_ONES = (
    "zero one two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen sixteen seventeen "
    "eighteen nineteen"
).split()
_TENS = "twenty thirty forty fifty sixty seventy eighty ninety".split()


def with_fillers(instruction: Instruction, rng: np.random.Generator) -> Instruction:
    """Words that say nothing, between the others, half of them with a comma behind; no value has them."""
    text = instruction.text
    places = [match.start() for match in re.finditer(r"\S+", text)]
    chosen = [i for i in places if rng.random() < FILLER_RATE] or [places[int(rng.integers(len(places)))]]
    changes = []
    for i in chosen:
        is_inside = any(span.start < i < span.end for span in spans_of(instruction))
        said = str(rng.choice(HESITATIONS if is_inside else FILLERS)) + (", " if rng.random() < 0.5 else " ")
        if i == places[0] and text[i].isupper() and not text[i + 1 : i + 2].isupper() and not _is_i(text[i:]):
            said = said[0].upper() + said[1:]
            changes.append(Change(i, i + 1, text[i].lower()))
        changes.append(Change(i, i, said))
    return valued_as(changed(instruction, changes), instruction)


def with_slips(instruction: Instruction, rng: np.random.Generator) -> Instruction:
    """Letters swapped with the next, dropped, doubled or taken from the key beside, anywhere in the text."""
    text = instruction.text
    borders = {border for span in spans_of(instruction) for border in (span.start, span.end)}
    changes: list[Change] = []
    i = 0
    while i < len(text):
        if text[i].lower() in _NEXT_KEYS and rng.random() < SLIP_RATE:
            is_after_gap = bool(changes) and changes[-1].end == i and not changes[-1].text
            slips = list(_slips(text, i, borders, rng, is_after_gap=is_after_gap))
            changes.append(slips[int(rng.integers(len(slips)))])
            i = changes[-1].end
        else:
            i += 1
    return changed(instruction, changes)


def as_recognised(instruction: Instruction, rng: np.random.Generator) -> Instruction:
    """As a speech recogniser may write it: lower case without punctuation, homophones, unheard function words,
    contractions split, run together or made, numbers in words."""
    changes = [*_number_words(instruction.text)]
    words = list(_WORD.finditer(instruction.text))
    dropped: set[int] = set()
    for word, following in pairwise([*words, None]):
        assert word is not None
        if any(change.start < word.end() and word.start() < change.end for change in changes):
            continue
        changes += _misheard(instruction, word, following, dropped, rng)
    return edited(changed(instruction, changes), without_punctuation)


def _lower(instruction: Instruction, rng: np.random.Generator) -> Instruction:
    return edited(instruction, without_case)


def _unmarked(instruction: Instruction, rng: np.random.Generator) -> Instruction:
    return edited(instruction, without_marks)


def _plain(instruction: Instruction, rng: np.random.Generator) -> Instruction:
    return edited(instruction, without_punctuation)


DISTURBANCES: Mapping[str, Disturbance] = MappingProxyType(
    {
        "lower case": _lower,
        "no punctuation": _unmarked,
        "lower case, no punctuation": _plain,
        "fillers": with_fillers,
        "typing slips": with_slips,
        "speech recogniser": as_recognised,
    }
)


def _is_i(text: str) -> bool:
    return re.match(r"I\b", text) is not None


def _slips(text: str, i: int, borders: set[int], rng: np.random.Generator, *, is_after_gap: bool) -> Iterator[Change]:
    """What may happen to the letter at `i` without touching the border of a span or emptying one.

    `is_after_gap`: the letter before was dropped.
    """
    letter, keys = text[i], _NEXT_KEYS[text[i].lower()]
    has_next = i + 1 < len(text) and text[i + 1].isalpha() and i + 1 not in borders
    has_last = i > 0 and not is_after_gap and text[i - 1].isalpha() and i not in borders
    key = keys[int(rng.integers(len(keys)))]
    yield Change(i, i + 1, letter * 2)
    yield Change(i, i + 1, key.upper() if letter.isupper() else key)
    if has_next and text[i + 1].lower() != letter.lower():
        yield Change(i, i + 2, text[i + 1] + letter)
    if has_next or has_last:
        yield Change(i, i + 1, "")


def _misheard(
    instruction: Instruction,
    word: re.Match[str],
    following: re.Match[str] | None,
    dropped: set[int],
    rng: np.random.Generator,
) -> Sequence[Change]:
    """What becomes of a word and the space behind it; `dropped`: where words start that were not heard."""
    text, said = instruction.text, word[0].lower()
    is_next = following is not None and text[word.end() : following.start()] == " "
    if "'" in said or "’" in said:
        if rng.random() >= CONTRACTION_RATE:
            return ()
        apostrophe = word.start() + next(i for i, letter in enumerate(said) if letter in "'’")
        return (Change(apostrophe, apostrophe + 1, str(rng.choice(("", " ")))),)
    if is_next and following is not None:
        contracted = _contracted(said, following, text)
        if contracted and rng.random() < CONTRACTION_RATE:
            return (Change(word.end(), following.start(), ""), contracted)
        if said in _DROPPED and rng.random() < DROP_RATE and _may_go(instruction, word, dropped):
            dropped.add(word.start())
            return (Change(word.start(), word.end(), ""), Change(word.end(), following.start(), ""))
    if said in _HOMOPHONES and rng.random() < HOMOPHONE_RATE:
        return (Change(word.start(), word.end(), str(rng.choice(_HOMOPHONES[said]))),)
    return ()


def _contracted(said: str, following: re.Match[str], text: str) -> Change | None:
    """What the word behind becomes in a contraction: "is not" is heard as "isnt", "it is on" as "its on"."""
    second, goes_on = following[0].lower(), re.match(r" \w", text[following.end() :]) is not None
    if said in _BE_LIKE and second == "not":
        return Change(following.start(), following.end(), "nt")
    if said in _SUBJECTS and second == "is" and goes_on:
        return Change(following.start(), following.end(), "s")
    return None


def _may_go(instruction: Instruction, word: re.Match[str], dropped: set[int]) -> bool:
    """Whether every span that this word lies in keeps another word."""
    return all(
        any(
            other.start() + span.start != word.start() and other.start() + span.start not in dropped
            for other in _WORD.finditer(span.of(instruction.text))
        )
        for span in spans_of(instruction)
        if span.start <= word.start() < span.end
    )


def _number_words(text: str) -> Iterator[Change]:
    """Numbers below a hundred and times of the clock, in words."""
    for match in _NUMBER.finditer(text):
        said = _spoken(int(match[1]))
        if match[2]:
            said += f" {_spoken(int(match[2]))}" if int(match[2]) else " o'clock"
        yield Change(match.start(), match.end(), said)


def _spoken(number: int) -> str:
    if number < 20:
        return _ONES[number]
    return " ".join([_TENS[number // 10 - 2], *([_ONES[number % 10]] if number % 10 else [])])
