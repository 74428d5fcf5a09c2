"""Wordings: what the words of a clause say for certain, its negation, the state it tests, its order."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from decomplex_bt.understanding.control_flow.arcs import Wording
from decomplex_bt.understanding.control_flow.clause import MarkedTask
from decomplex_bt.understanding.control_flow.denials import ANSWERS, is_answer, negations
from decomplex_bt.understanding.control_flow.stretch import PUNCTUATION
from decomplex_bt.understanding.cue_phrases import ASKING_LEMMAS, GOVERNING, normal_form
from decomplex_bt.understanding.document import Document, Token
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.phrases import degree_asked
from decomplex_bt.understanding.states import OPPOSITES

PERSONS = frozenset(("he", "she", "they"))
ECHOING = frozenset("is are am was were does do did has have had can will would".split())
_OTHER_ANSWER = {"yes": "no", "no": "yes"}
_OURS = frozenset(("we", "you", "i"))
_LEFT = frozenset(("they", "it", "those"))
_ADDED = frozenset("if all already now completely just still and but or".split())
BEING = frozenset(("be", "'s", "'re", "s"))
REFERRING = frozenset("it them that this those these one ones there he she her him they both some any em".split())
_ANYBODY = frozenset("anyone anybody someone somebody".split())
_WHO = frozenset("it them him her me us".split())
_Cues = tuple[Sequence[str], Sequence[str], Sequence[str]]
_CLOSING = PUNCTUATION | {"but"}
_SUCH = frozenset(("so", "that", "this", "it"))
_COMING_UP = frozenset("light turn show come warm heat boil dry fill".split())
_REFUSING = frozenset(("refuse", "fail"))
_CONTRARY = frozenset("fail refuse decline stick stuck jam jammed gone missing away elsewhere vanish disappear".split())
_LOSING = frozenset(("drop", "spill"))
_SOME_OF = frozenset(("any", "some", "enough"))
_RESTING = frozenset("some something any anything none nothing left still".split())
_NO_LONGER = frozenset(("anymore", "more", "any"))
_SUBORDINATE = {"before": ("after", "last"), "until": ("before", "first"), "after": ("before", "first")}
_ADVERBIAL = {
    "before_that": ("before", "first"),
    "before_all": ("first", "before"),
    "first": ("first", "before"),
    "last": ("last",),
}
"""The order labels that a cue speaks for: one that makes its clause subordinate, and one that is an adverb in it."""


def is_of_somebody(document: Document, task: MarkedTask, persons: frozenset[str]) -> bool:
    """Whether the one thing that a task is of is one of these pronouns."""
    objects = [indices for kind, indices in task.arguments if kind == "object"]
    return any(len(indices) == 1 and document.tokens[indices[0]].lower in persons for indices in objects)


def is_being_of(document: Document, task: MarkedTask, persons: frozenset[str]) -> bool:
    """Whether a check is the "be" of one of these pronouns ("if he is ...")."""
    return document.tokens[task.token].lemma in {"be", *BEING} and is_of_somebody(document, task, persons)


def wording(observed: Observed, task: MarkedTask, first: int, last: int, cues: _Cues, is_joined: bool) -> Wording:
    """The wording of a task's clause, tokens `first` to `last`; `cues`: the names of those far ahead of the task, right
    ahead of it and behind it."""
    far, near, behind = cues
    # "there isn't no milk", "not there neither" deny once
    tokens = observed.document.tokens
    # "if it refuses to open"
    refusing = [j for j in range(first, task.token) if tokens[j].lemma in _REFUSING and tokens[j + 1].lower == "to"]
    denying = negations(observed, task.token, first, last) or _asked_of(observed, task.token, last)
    is_denied = bool(denying) != bool(refusing)
    state = _state(observed, task, last)
    leading = {*far, *near}
    orders = [
        *(label for name in near for label in _SUBORDINATE.get(name, ())),
        *(label for said in (leading, behind) for name in _ADVERBIAL if name in said for label in _ADVERBIAL[name]),
    ]
    named = {indices[-1] for kind, indices in task.arguments if kind == "object" and len(indices)}
    named = {j for j in named if tokens[j].tag in ("NN", "NNS")}  # "if *the jam* isn't there"
    lemmas = {
        tokens[j].lemma
        for j in range(first, last + 1)
        if j not in named and (not j or tokens[j - 1].lower not in ("right", "straight"))
    }  # "right away" is no "away"
    lemmas -= {tokens[j].lemma for j in refusing}
    return Wording(
        is_denied != ("unless" in near),
        state,
        OPPOSITES.get(state, _OTHER_ANSWER.get(state)) if state else None,
        observed.document.sentences[task.token],
        tuple(dict.fromkeys(orders)),
        _joint(tokens[task.token], leading) if is_joined else "",
        bool(lemmas & _CONTRARY)
        or state in _CONTRARY
        or (task.type == "check_state" and tokens[task.token].lemma in _LOSING)
        or _says_used_up(tokens[first : last + 1])
        or _says_too_few([token.lower for token in tokens[first : last + 1]])
        or (state == "out" and is_being_of(observed.document, task, PERSONS)),
        # "if he is", "if it does", "when they have"
        is_bare(observed.document, task, last, ECHOING) or _says_who(observed.document, task),
        is_of_somebody(observed.document, task, _ANYBODY),
        _is_of_rest(tokens, task, first, last),
        task.type == "check_state" and tokens[task.token].lemma == "work" and state is None,
        _is_of_stock(tokens, task),
    )


def _is_of_stock(tokens: Sequence[Token], task: MarkedTask) -> bool:
    """Whether a clause asks if there is, or somebody or something has, any or enough of something."""
    firsts = {tokens[indices.start].lower for kind, indices in task.arguments if kind == "object" and len(indices)}
    is_of_having = task.type == "check_state" and tokens[task.token].lemma in {*BEING, "be", "have", "see", "check"}
    return is_of_having and not _SOME_OF.isdisjoint(firsts)


def _is_of_rest(tokens: Sequence[Token], task: MarkedTask, first: int, last: int) -> bool:
    """Whether a clause says that there is, or is not, anything in or left of something, or that this is still where it
    was: "if *there's some left*", "if *it's still there*"."""
    if task.type != "check_state" or tokens[task.token].lemma not in BEING:
        return False
    said = [token.lower for token in tokens[max(first, task.token) : last + 1] if token.text not in PUNCTUATION]
    is_there = task.token > 0 and tokens[task.token - 1].lower == "there" and not _RESTING.isdisjoint(said)
    last_word = next((word for word in reversed(said) if word not in _NO_LONGER), "")
    return is_there or last_word in ("there", "here")


def _joint(carrier: Token, leading: Collection[str]) -> str:
    """What joins a clause without an "if" of its own to the one before; a "but" does where no verb follows ("bread
    *but* no butter")."""
    if not GOVERNING.isdisjoint(leading):
        return ""
    joint = next((word for word in ("or", "and") if word in leading), "")
    return joint or ("and" if "but" in leading and carrier.pos == "NOUN" else "")


def _asked_of(observed: Observed, task: int, last: int) -> list[int]:
    """What denies the question behind an order to find it out: "check whether it is *not* running"."""
    tokens = observed.document.tokens
    asking = next((cue for cue in observed.cues if cue.first == last + 1 and cue.name == "whether"), None)
    if asking is None or tokens[task].lemma not in ASKING_LEMMAS:
        return []
    start = asking.last + 1
    closing = {cue.first for cue in observed.cues if cue.name in GOVERNING}
    ends = (j for j in range(start, len(tokens)) if tokens[j].lower in _CLOSING or j in closing)
    return negations(observed, task, start, next(ends, len(tokens)) - 1)


def _says_too_few(words: Sequence[str]) -> bool:
    """Whether a clause says that there are fewer than was said, or too few."""
    return not {"fewer", "less"}.isdisjoint(words[-1:]) or words[-2:] in (["too", "few"], ["too", "little"])


def _says_used_up(clause: Sequence[Token]) -> bool:
    """Whether a clause says that there is none left: "we're out (of it)", "we've run out", "they've gone"."""
    words = [normal_form(token.lower) for token in clause if token.text not in PUNCTUATION]
    words = [word for word in words if word not in _ADDED]
    first, behind = words[:1], words[words.index("out") + 1 :] if "out" in words else ["in"]
    is_ours = not _OURS.isdisjoint(first) and not {"is", "are", "am", "run"}.isdisjoint(words)
    is_out = not behind or behind[0] == "of"
    return (is_ours and is_out) or (words[-1:] == ["gone"] and not _LEFT.isdisjoint(first))


def is_bare(document: Document, task: MarkedTask, last: int, words: frozenset[str]) -> bool:
    """Whether a check is one of these words, and no more than a pronoun is said besides: "if he is"."""
    if task.type != "check_state" or document.tokens[task.token].lower not in words:
        return False
    if any(kind != "object" or len(indices) > 1 for kind, indices in task.arguments):
        return False
    return all(
        token.lower in REFERRING or token.lower in words - ECHOING or token.text in PUNCTUATION
        for token in document.tokens[task.token + 1 : last + 1]
    )


def _says_who(document: Document, task: MarkedTask) -> bool:
    """Whether a check only says by a pronoun who somebody is: "if it's *him*"."""
    states = [indices for kind, indices in task.arguments if kind == "state"]
    return any(len(indices) == 1 and document.tokens[indices[0]].lower in _WHO for indices in states)


def _state(observed: Observed, task: MarkedTask, last: int) -> str | None:
    """The word for the state that a clause tests: the end of its state argument, else a word with an opposite."""
    tokens = observed.document.tokens
    said = next((indices for kind, indices in task.arguments if kind == "state" and len(indices)), None)
    if said is not None:
        words = [tokens[j].lower for j in said]
        if _says_who(observed.document, task):
            return None
        first = words[words.index("or") - 1] if "or" in words[1:] else words[-1]
        is_choice = words[-1] in (OPPOSITES.get(first), first) or OPPOSITES.get(words[-1]) == first
        said_last = first if is_choice else words[-1]  # "is it open or shut?" asks whether it is open
        return ANSWERS.get(said_last, said_last)
    if task.type != "check_state" or degree_asked(observed.document, task.token):
        return None
    if task.token < last and is_answer(observed.document, task.token + 1):
        return ANSWERS[tokens[task.token + 1].lower]
    named = {j for kind, indices in task.arguments if kind == "object" for j in indices}
    for j in range(min(task.token, last), last + 1):
        if j in named:
            continue  # "check the light"
        governs = any(tokens[child].dep == "pobj" for child in observed.document.children[j])
        if tokens[j].lower == "up" and tokens[task.token].lemma in _COMING_UP:
            continue  # "if nothing lights up"
        if tokens[j].lower == "done" and j < last and tokens[j + 1].lower in _SUCH:
            continue  # "if he hasn't *done so*"
        if tokens[j].lower in OPPOSITES and not governs and tokens[j].tag not in ("VB", "VBP", "VBZ", "VBD"):
            return tokens[j].lower
    return None
