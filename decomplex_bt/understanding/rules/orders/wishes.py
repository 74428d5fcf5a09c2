"""Wishes: what somebody would like to have or do, where the request right behind asks for the same or serves it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise, takewhile

from decomplex_bt.understanding.document import ENDS, Document, Token
from decomplex_bt.understanding.vocabulary import ONES

_WISHING = frozenset("like want need love fancy".split())
_BEFORE_WISHES = frozenset("'d would do really just rather could so".split())
_CASES = frozenset("if unless otherwise or else when once whether then also after before".split())
_OPENING_CASES = frozenset("if unless is are when should in".split())
_SPEAKERS = frozenset(("me", "us"))
_OTHERS = frozenset(("her", "him", "them"))
_ELSE = frozenset("another other no this these".split())
_MORE = frozenset(("too", "also", "well", "another"))
_PRONOUNS = frozenset("some one it them that those any".split())
_PHRASE = frozenset(("DET", "ADJ", "NUM", "NOUN", "PROPN"))
_CLAUSE_ENDS = ENDS | frozenset((",", ":", "and", "or", "but"))


_IDLE = tuple(
    tuple(phrase.split())
    for phrase in (
        "feel like", "feeling like", "fancy", "fancying", "could do with", "dying for", "in the mood for", "need to",
        "want to", "wanna",
    )
)  # fmt: skip
"""What a wish begins with where it goes without its subject."""
_FILLERS = frozenset("well oh so um uh hmm hey ok okay right really just robot ,".split())
_BRINGING = frozenset(("bringing", "taking"))
_FETCHING = frozenset(("bringing", "taking", "searching"))
_NOT_ORDERING = frozenset("to i we you he she they it not n't".split())


def is_background(document: Document, at: int, request: int, kind: str) -> bool:
    """Whether the verb at token `at` is of a wish without a subject that only tells why the order at token `request`,
    the next task, of type `kind`, is given: "feel like some music, turn on the radio", "need to iron a shirt get the
    board". What "and" joins to the order, or a comma to one that fetches nothing, may be ordered itself ("need to feed
    the cat, mop the hall")."""
    tokens, sentences = document.tokens, document.sentences
    start = _beginning(document, at)
    said = [token.lower for token in tokens[start : start + 4]]
    opening = next((phrase for phrase in _IDLE if tuple(said[: len(phrase)]) == phrase), None)
    between = [token.lower for token in tokens[start:request]]
    if opening is None or not _CASES.isdisjoint(between) or not _MORE.isdisjoint(between) or "and" in between:
        return False
    is_of_deed = opening[-1] in ("to", "wanna")
    is_near = sentences[request] == sentences[at] or (not is_of_deed and sentences[request] == sentences[at] + 1)
    is_bare = tokens[request].lower == tokens[request].lemma and tokens[request - 1].lower not in _NOT_ORDERING
    is_order = is_bare or between[-2:] in (["can", "you"], ["could", "you"])
    is_alone = not is_of_deed or kind in _FETCHING or "," not in between
    return is_near and is_order and is_alone and request > start + len(opening)


def backgrounds(document: Document, tasks: Mapping[int, str]) -> frozenset[int]:
    """The tokens of all wishes that only tell why the task behind them is ordered, in which no token is among the
    `tasks`, which are tokens with types: their words are no arguments of it."""
    found: set[int] = set()
    for one, request in pairwise((-1, *sorted(tasks))):
        first = one + 1
        while first < request and document.tokens[first].lower in ENDS:
            first += 1
        start = _beginning(document, first)
        if one < start < request and is_background(document, start, request, tasks[request]):
            found.update(range(start, request))
    return frozenset(found)


def _beginning(document: Document, at: int) -> int:
    """Where the sentence of a token begins, its fillers left out."""
    tokens, sentences = document.tokens, document.sentences
    first = next(i for i in range(at + 1) if sentences[i] == sentences[at])
    while first + 1 < len(tokens) and sentences[first + 1] == sentences[at] and tokens[first].lower in _FILLERS:
        first += 1
    return first


def is_served(document: Document, wish: int, request: int) -> bool:
    """Whether the verb at token `wish` only tells what the one at token `request`, the next task, is to bring: "I'd
    like some tea, can you get me some?", "Anna would like some. Bring her some". Not what somebody else than who wishes
    is to have, another thing, or a case."""
    tokens, sentences = document.tokens, document.sentences
    if tokens[wish].lemma not in _WISHING or sentences[request] > sentences[wish] + 1:
        return False
    if tokens[request - 1].lower == "to":
        return False  # "I want you to bring it" is the order itself
    behind = tokens[request + 1 : request + 3]  # "bring *them some*", not "bring *them* here"
    is_given_to_others = len(behind) > 1 and behind[0].lower in _OTHERS
    is_given_to_others = is_given_to_others and (behind[1].pos in _PHRASE or behind[1].lower in _PRONOUNS)
    if is_given_to_others is _is_own(document, wish):
        return False
    wished = tokens[wish + 1 : request]
    goes_on = any(one.lower == "and" and two.pos not in _PHRASE for one, two in pairwise(wished))
    if goes_on or any(token.lower in _CASES for token in wished):
        return False
    first = request + 1 + is_given_to_others
    asked = list(takewhile(lambda token: token.lower not in _CLAUSE_ENDS, tokens[first:]))
    is_for_another = any(one.lower in ("to", "for") and two.lower not in _SPEAKERS for one, two in pairwise(asked))
    return not is_for_another and _MORE.isdisjoint(token.lower for token in asked) and _is_same(wished, asked)


def is_taken_up(document: Document, wish: int, tasks: Mapping[int, str]) -> bool:
    """Whether the verb at token `wish` only names what the next sentence, which begins with a case, says to bring: "I
    need my coat. If it's in the hall, *bring it*". `tasks`: tokens with types."""
    tokens, sentences = document.tokens, document.sentences
    if tokens[wish].lemma not in _WISHING or not _is_own(document, wish):
        return False
    said = [t for t in tokens[wish + 1 :] if sentences[t.i] == sentences[wish]]
    behind = [t for t in tokens[wish + 1 :] if sentences[t.i] == sentences[wish] + 1]
    if behind and behind[-1].text == "?" and not any(tasks.get(t.i) in _BRINGING for t in behind):
        # "I'd love a tea. Is there any milk? If not, bring it black"
        behind = [t for t in tokens[wish + 1 :] if sentences[t.i] == sentences[wish] + 2]
    ahead = [t for t in tokens[:wish] if sentences[t.i] == sentences[wish]]
    is_plain = all(t.i not in tasks and t.lower not in _CASES | {"and", "to"} for t in (*ahead, *said))
    if not is_plain or not behind or behind[0].lower not in _OPENING_CASES:
        return False
    brought = [t.i for t in behind if tasks.get(t.i) in _BRINGING and t.i + 1 < len(tokens)]
    return any(tokens[i + 1].lower in ("it", "them") for i in brought)


def wishers(document: Document, tasks: Mapping[int, str]) -> frozenset[int]:
    """The tokens up to the verb of every wish that is taken up: "*I* need my coat. If it's in the hall, bring it"; and
    all up to the order that serves it: "*Anna would like a tea. Please* bring her one"."""
    found: set[int] = set()
    for token in document.tokens:
        if token.lemma not in _WISHING or token.i in tasks:
            continue
        if is_taken_up(document, token.i, tasks):
            found.update(range(_beginning(document, token.i), token.i))
        request = min((i for i in tasks if i > token.i), default=None)
        if request is not None and tasks[request] in _BRINGING and is_served(document, token.i, request):
            found.update(range(_beginning(document, token.i), request))
    return frozenset(found)


def _is_own(document: Document, wish: int) -> bool:
    """Whether it is the speaker who wishes: not "my son would like"."""
    i = wish - 1
    while i > 0 and document.tokens[i].lower in _BEFORE_WISHES:
        i -= 1
    is_near = i >= 0 and document.sentences[i] == document.sentences[wish]
    return is_near and document.tokens[i].lower in ("i", "we")


def _is_same(wished: Sequence[Token], asked: Sequence[Token]) -> bool:
    """Whether what is asked for is a pronoun, "the blue one", or names the same thing with no other adjective."""
    asked = [token for token in asked if token.lower not in _SPEAKERS and token.tag != "RP"]
    last = len(list(takewhile(lambda token: token.pos in ("DET", "ADJ"), asked)))
    if 0 < last < len(asked) and asked[last].lower in ONES:  # "the blue one"
        is_same = _ELSE.isdisjoint(token.lower for token in asked[:last])
        return is_same and (last + 1 == len(asked) or asked[last + 1].lower != "of")
    if asked and asked[0].lower in _PRONOUNS and (len(asked) == 1 or asked[1].pos not in _PHRASE):
        return len(asked) == 1 or asked[1].lower != "of"
    first, second = _phrase(wished), _phrase(asked)
    nouns = [[token.lemma for token in phrase if token.pos in ("NOUN", "PROPN")][-1:] for phrase in (first, second)]
    adjectives = [{token.lemma for token in phrase if token.pos == "ADJ"} for phrase in (first, second)]
    return bool(nouns[0]) and nouns[0] == nouns[1] and adjectives[1] <= adjectives[0]


def _phrase(tokens: Sequence[Token]) -> list[Token]:
    """The noun phrase that words begin with."""
    return list(takewhile(lambda token: token.pos in _PHRASE or token.lower in _PRONOUNS, tokens))
