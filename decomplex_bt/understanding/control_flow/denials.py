"""Denials: the words that deny what a clause says."""

from __future__ import annotations

from decomplex_bt.understanding.cue_phrases import ASKING_LEMMAS, PRO_FORMS
from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.rules.speech.asides import tag_question

WILLING = frozenset(("would", "will", "wo"))
_COORDINATORS = frozenset(("and", "but", "or"))
_STATING = frozenset(
    "is 's s are 're re was were 'm m do does did have has had ca can could wo will would ai there got".split()
)
"""What stands ahead of a negation in a statement: "it *is* n't", "I *do* n't", "*ca* n't find it", "*got* no milk"."""
_CONTRACTED = frozenset(("n't", "nt"))
_GOING_BY = frozenset((("if", "so"), ("if", "not"), ("if", "yes"), ("if", "no")))
_LEADING = frozenset("do does did ca can could wo will would".split())
"""What needs a verb behind its negation."""
_DEGREES = frozenset("quite even always all both ever often each entirely".split())
"""What may stand between a negation and its verb, as "really" may."""
_ASKING = frozenset("please just kindly then now maybe go can could would will you".split())
"""What may stand ahead of the verb of an order."""
_NO_ORDERS = frozenset("to i we they he she who that which and or but not n't nor".split())
_ANSWERING = frozenset(("say", "answer", "reply"))
_LETTING = frozenset(("let", "make", "help"))
_DENYING = frozenset("no not n't".split())


def negations(observed: Observed, task: int, first: int, last: int) -> list[int]:
    """The tokens from `first` to `last` that deny what the clause of the task at token `task` says: of its verb, its
    subject or what it says of it, and not of a part of these ("a mug that isn't dirty", "hot but not too hot")."""
    document = observed.document
    if any(tag_question(document, at) is not None for at in range(task + 1, min(last + 3, len(document)))):
        return []  # "the light isn't on, is it?" asks whether it is
    if _is_answered(document, first):
        return []
    found = [cue.first for cue in observed.cues if first <= cue.first <= last and cue.name == "not"]
    found = [
        i
        for i in found
        if not (_is_polite(document, i) or is_answer(document, i) or _is_told(document, i) or _is_in_name(document, i))
        and _is_of(document, i, task, last)
    ]
    if any(token.lower == "neither" for token in document.tokens[first : last + 1]):  # "neither hot nor full": once
        found = [i for i in found if document.tokens[i].lower != "nor"]
    # "if there is no answer" is a cue for a failure, but its verb may be a task as well
    wholes = [cue for cue in observed.cues if cue.name in PRO_FORMS and cue.first <= task <= cue.last]
    said = [i for cue in wholes for i in range(cue.first, cue.last + 1)]
    if any(document.tokens[i].lower == "there" for i in said):
        found += [i for i in said if document.tokens[i].lower in _DENYING and i not in found]
    return found


def _is_answered(document: Document, first: int) -> bool:
    """Whether the words from `first` on ask "isn't it ...?", and an "if so" or "if not" behind takes that up: who asks
    so means "is it ...?"."""
    tokens = document.tokens
    words = [token.lower for token in tokens[first : first + 2]]
    is_denied = bool(words) and words[0] in _STATING and words[-1] in _CONTRACTED
    mark = next((t.i for t in tokens[first:] if t.text in MARKS), len(tokens))
    behind = tuple(t.lower for t in tokens[mark + 1 : mark + 3])
    return is_denied and behind in _GOING_BY and tokens[mark].text in ("?", ",")


ANSWERS = {
    **dict.fromkeys(("yes", "yeah", "yep", "yup"), "yes"),
    **dict.fromkeys(("no", "nah", "nope", "naw"), "no"),
}
"""What somebody says for a yes or a no."""


def is_answer(document: Document, i: int) -> bool:
    """Whether a "yes" or "no" is what somebody says: "if she says no"."""
    tokens = document.tokens
    after = tokens[i + 1 : i + 2]
    is_all = not after or after[0].text in MARKS or after[0].tag not in ("NN", "NNS", "JJ", "DT", "PRP$")
    return tokens[i].lower in ANSWERS and i > 0 and tokens[i - 1].lemma in _ANSWERING and is_all


def _is_in_name(document: Document, i: int) -> bool:
    """Whether a "not" is part of a name or of what a sign says: "the *Do Not Disturb* sign"."""
    around = document.tokens[i - 1 : i + 2] if i else ()
    is_title = len(around) == 3 and all(token.text[:1].isupper() for token in around)
    return is_title or [token.lower for token in around] == ["do", "not", "disturb"]


def _is_told(document: Document, i: int) -> bool:
    """Whether a "not" is of what somebody is told to do: "unless Tom asks you *not to*", not "if she is *not to be*
    found"."""
    tokens = document.tokens
    following = [token.lower for token in tokens[i + 1 : i + 3]]
    is_found = i > 0 and tokens[i - 1].lemma == "be" and following[1:] == ["be"]
    return tokens[i].lower == "not" and i > 0 and following[:1] == ["to"] and not is_found


def _is_of(document: Document, negation: int, task: int, last: int) -> bool:
    """Whether a negation is of the task's own clause: not of a verb behind it ("if it is on and nobody is there"), nor
    of a part of what it says. By the words around it, for where marks are lacking the parse is often wrong."""
    tokens = document.tokens
    if _is_of_another_order(document, negation, task):
        return False
    if negation <= task:
        return not _is_of_statement(document, negation, task)
    before = tokens[negation - 1]
    if before.lower in _COORDINATORS or (before.pos == "ADP" and tokens[negation].lower == "no"):
        return False
    if before.lower in ("do", "does") and negation > task + 1 and last <= negation:
        return False
    relatives = [j for j in range(task + 1, negation) if tokens[j].tag in ("WDT", "WP")]
    return not (relatives or before.lower == "that") or not any(
        tokens[i].dep in ("relcl", "acl") for i in (negation, *document.ancestors(negation))
    )


def _is_of_statement(document: Document, negation: int, task: int) -> bool:
    """Whether a negation belongs to a statement that the order at `task` follows without a mark: "I can't find my
    glasses have a look in the hall", "it isn't there look in the hall"."""
    tokens = document.tokens
    start = task
    while start > negation and tokens[start - 1].lower in _ASKING:
        start -= 1
    is_go_and = tokens[start - 1].lower == "and" and tokens[start - 2].lower == "go"
    start -= 2 * is_go_and
    if start - negation < 2 or negation == 0 or tokens[negation - 1].lower not in _STATING:
        return False
    between = [token.lower for token in tokens[negation + 1 : task]]
    if tokens[negation - 1].lower in _LEADING and all(word in _DEGREES or word.endswith("ly") for word in between):
        return False  # "if it doesn't quite fit"
    if tokens[negation - 1].lower == "do" and (
        negation < 2 or tokens[negation - 2].pos not in ("PRON", "NOUN", "PROPN")
    ):
        return False  # "don't go and look"
    is_bare = tokens[task].lower == tokens[task].lemma != "be" and tokens[task].tag not in ("VBZ", "VBD", "VBG", "VBN")
    is_order = is_bare and tokens[start - 1].lower not in _NO_ORDERS
    return is_order and tokens[negation + 1].lemma not in _LETTING


def _is_of_another_order(document: Document, negation: int, task: int) -> bool:
    """Whether a negation forbids something else, which is no task: "if it is hot don't touch it, just tell me", "no,
    forget the remote, turn it off"."""
    tokens = document.tokens
    after = tokens[negation + 1] if negation + 1 < len(tokens) else None
    if after is None or after.tag != "VB" or after.i == task:
        return False
    if tokens[negation].lower == "no":
        return negation < task
    if tokens[negation - 1].lower != "do" or (negation > 1 and tokens[negation - 2].dep in ("nsubj", "expl")):
        return False
    if task < negation and tokens[task].lemma in ASKING_LEMMAS:
        return False  # "check the taps don't drip"
    between = [token.lower for token in tokens[after.i + 1 : task]]
    return task < negation or "just" in between or "only" in between


def _is_polite(document: Document, negation: int) -> bool:
    """Whether a negation asks somebody to do something: "why don't you see if ...", "wouldn't you look"."""
    tokens = document.tokens
    after = tokens[negation + 1] if negation + 1 < len(tokens) else None
    if after is None or after.lower != "you" or negation == 0:
        return False
    return tokens[negation - 1].lower in WILLING or (negation > 1 and tokens[negation - 2].lower == "why")
