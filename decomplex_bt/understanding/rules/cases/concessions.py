"""Concessions that tell both of two cases ("whether you find it or not", "no matter if it's on"): what is ordered
beside them is done either way."""

from __future__ import annotations

from decomplex_bt.understanding.document import FINITE, MARKS, Document

_NO_MATTER = tuple(
    tuple(phrase.split())
    for phrase in (
        "no matter if", "no matter whether", "regardless of if", "regardless of whether", "irrespective of whether",
        "irrespective of if", "independently of whether", "independent of whether", "it does n't matter if",
        "it does n't matter whether",
    )
)  # fmt: skip
"""What says by itself that it makes no difference."""
_OPENERS = frozenset(phrase[0] for phrase in _NO_MATTER) | {"whether"}
_TELLING = frozenset("whether matter regardless irrespective independently independent".split())
"""Words of which every concession has one."""
_BEING = frozenset("'s 're s".split())
_LEADING_ON = frozenset("TO MD VBP VBZ VBD PRP".split())
"""Tags of what a bare verb may hang on: "to find", "can find", "do find"."""
_JOINTS = frozenset(("and", "but", "so"))
_NOT = frozenset(("not", "no", "n't", "nt"))
_CONTRACTED = _NOT - {"not", "no"}
_ASKED = frozenset(
    "check see find look verify ask tell know wonder determine confirm ensure discover inspect test learn let figure "
    "suss notice establish sure certain doubt report say examine decide choose remind inform text call message ring "
    "question unclear unsure idea remember recall forget matter me us about on of as to depend depending care".split()
)
"""What a "whether" is asked, told or chosen by: "let me know whether it's on or not", "depending on whether"."""


def either_way(document: Document, at: int) -> range | None:
    """The words that token `at` is among in which both of two cases are told as making no difference: "whether there is
    or not", "regardless of whether it's on", "no matter if it is"; or None."""
    return next((words for words in concessions(document) if at in words), None)


def concessions(document: Document) -> tuple[range, ...]:
    """Of all such concessions the words, in text order."""
    if document.words.isdisjoint(_TELLING):
        return ()  # as with most instructions
    words = [token.lower for token in document.tokens]
    found: list[range] = []
    for start, word in enumerate(words):
        if word not in _OPENERS or (found and start < found[-1].stop):
            continue
        opener = next((phrase for phrase in _NO_MATTER if tuple(words[start : start + len(phrase)]) == phrase), ())
        if not opener and (word != "whether" or _is_asked(document, start)):
            continue
        inside = start + (len(opener) or 1)
        stop = _end(document, inside)
        other = _other_case(document, range(inside, stop))
        if opener or other is not None:
            found.append(range(start, stop if other is None else other))
    return tuple(found)


def _end(document: Document, inside: int) -> int:
    """Where a clause ends: at a mark, or at an "and" or the like, or at an order behind its verb that no mark sets off
    ("whether or not it's hot *put* the bread in")."""
    tokens, sentences = document.tokens, document.sentences
    is_said = False
    for i in range(inside, len(tokens)):
        if tokens[i].text in MARKS or tokens[i].lower in _JOINTS or sentences[i] != sentences[inside - 1]:
            return i
        is_led = tokens[i - 1].tag in _LEADING_ON or tokens[i - 1].lower in _NOT
        if is_said and not is_led and _is_order(document, i):
            return i
        is_said = is_said or tokens[i].tag in FINITE or tokens[i].lower in _BEING
    return len(tokens)


def _is_order(document: Document, i: int) -> bool:
    """Whether a bare verb begins there that has an object, and no subject ahead of it that it agrees with."""
    token, following = document.tokens[i], document.tokens[i + 1 : i + 2]
    has_object = any(t.tag in ("DT", "PRP", "PRP$") for t in following)
    is_bare = token.tag in ("VB", "VBP", "VBD") and token.lower == token.lemma
    subjects = [document.tokens[j].tag for j in document.children[i] if j < i and document.tokens[j].dep == "nsubj"]
    return is_bare and has_object and {"NN", "NNP"}.issuperset(subjects)


def _other_case(document: Document, clause: range) -> int | None:
    """Where the second case of a clause ends: behind the "or not" or "or it isn't" of "whether there is or ...", at the
    end of the clause behind "whether or not ..." and "whether it's wet or dry"; None where it has none."""
    words = [token.lower for token in document.tokens[: clause.stop]]
    joint = next((i for i in clause if words[i] == "or"), None)
    if joint is None or joint + 1 >= clause.stop:
        return None
    if joint > clause.start + 1:
        denied = next((i for i in range(joint + 1, min(joint + 4, clause.stop)) if words[i] in _NOT), None)
        if denied is not None and (words[denied] in _CONTRACTED or denied == joint + 1):
            return denied + 1
    return clause.stop


def _is_asked(document: Document, start: int) -> bool:
    """Whether something ahead of a "whether" in its clause, up to a mark behind which it stands, asks or tells it."""
    tokens, sentences = document.tokens, document.sentences
    for i in range(start - 1, -1, -1):
        if sentences[i] != sentences[start] or (tokens[i].text in MARKS and i < start - 1):
            return False
        if tokens[i].lemma in _ASKED or tokens[i].lower in _ASKED:
            return True
    return False
