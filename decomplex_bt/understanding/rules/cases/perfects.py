"""Perfects: checks of what somebody has done, or what has become of something, which a participle tells ("if Tim has
*put* it away", "once they've *arrived*")."""

from __future__ import annotations

from decomplex_bt.understanding.document import MARKS, Document

_IS_OR_HAS = frozenset(("'s",))
_HAVE = frozenset("has have had 's 've ve".split())
_HAVING = frozenset("has have had 've ve".split())
_PAST = frozenset(("VBN", "VBD"))
_OBJECTS = frozenset("it them him me us".split())
_HAVING_TWO_OBJECTS = frozenset("given told asked called named shown paid offered sent".split())
_SAME_FORMS = frozenset("put cut set shut let hit read run come become spread split shed hurt cost bet quit".split())
_WHETHER = frozenset(("if", "unless", "whether", "when"))
_WAITING = frozenset("until till once after".split())
_OPENING = _WHETHER | frozenset("after once when until till as soon".split())
_ASKING = frozenset("see check find look verify confirm".split())
_SPEAKING = frozenset(("you", "i", "we", "to"))
_NOT = frozenset("not n't nt".split())
_LISTENER = frozenset(("you", "u", "ya"))
_HAVING_AT_HAND = frozenset("get got bring take want need like".split())
_DO = frozenset(("do", "does", "did"))
_BETWEEN = frozenset("just already not n't finally actually really now all yet both also ever".split())
_PERFECTS = frozenset(
    "been got had come arrived fallen risen sat slipped dropped boiled walked driven started died nodded happened "
    "grown woken spat swallowed eaten passed returned escaped vanished disappeared begun drunk slept pulled".split()
)
_OF_SOMEBODY = frozenset("eaten driven returned pulled".split())
_SUBJECTS = frozenset(("he", "she", "who"))
_ADJECTIVES = frozenset(("drunk", "grown"))
"""Of the participles those that tell as well how somebody is."""
_NOT_ON = frozenset(("already", "too", "now", "again", "then"))
_COMPLEMENTS = frozenset(("JJ", "RB", "RP", "VBG"))
_AWAY = frozenset(("off", "out", "in", "to", "down", "up", "past"))


def told_by(document: Document, at: int) -> int:
    """The token that a check is told by: of "has" the participle ("they've arrived"), of "has been washed" the last; of
    "'s", where it is "has", the participle ("it's been", "it's gone cold"), and where it may as well be "is" that
    ("it's gone")."""
    tokens = document.tokens
    passive = passive_participle(document, at)
    if passive is not None:
        return passive
    done = perfect_participle(document, at) if _has_done(document, at) else None
    if done is not None:
        return done
    if tokens[at].lower == "gone" and at and tokens[at - 1].lower in _IS_OR_HAS:
        return at if _goes_on(document, at) else at - 1
    participle = next((t for t in tokens[at + 1 :] if t.lower not in _BETWEEN), None)
    if participle is not None and participle.dep == "amod":
        return at  # "has frozen peas"
    if tokens[at].lower in _HAVE - _IS_OR_HAS and participle is not None and participle.lower != "got":
        return participle.i if participle.tag in ("VBN", "VBD") else at
    if tokens[at].lower not in _IS_OR_HAS:
        return at
    if participle is None or participle.tag not in ("VBN", "VBD", "JJ", "NN", "VBP", "VB"):
        return at
    if participle.tag == "JJ" and participle.lower in _ADJECTIVES:
        return at
    if participle.lower in _OF_SOMEBODY and (at == 0 or tokens[at - 1].lower not in _SUBJECTS):
        return at  # "the cake's eaten" is no perfect
    is_perfect = participle.lower in _PERFECTS or (participle.lower == "gone" and _goes_on(document, participle.i))
    return participle.i if is_perfect else at


def passive_participle(document: Document, at: int) -> int | None:
    """The participle of "has been washed", told from any of its words before that; None where nothing is done."""
    words = document.tokens[at:]
    been = next((token for token in words if token.lower not in _HAVE | _BETWEEN), None)
    if been is None or been.lower != "been":
        return None
    participle = next((token for token in document.tokens[been.i + 1 :] if token.lower not in _BETWEEN), None)
    return participle.i if participle is not None and participle.tag in ("VBN", "VBD") else None


def perfect_participle(document: Document, have: int) -> int | None:
    """The participle of "has put", told from the "has"; None where nothing is done.

    Where the form may be an order as well, a mark must end its clause: "if he has put the kettle on" may mean "if he
    has, put the kettle on".
    """
    tokens = document.tokens
    if tokens[have].lower not in _HAVING and not _has_done(document, have):
        return None
    participle = next((token for token in tokens[have + 1 :] if token.lower not in _BETWEEN), None)
    if participle is None or participle.tag not in _PAST:
        return None
    if participle.lower != participle.lemma:
        return participle.i
    behind = tokens[participle.i + 1 :]
    end = next((token for token in behind if token.lower in MARKS or token.tag in ("VB", "VBP")), None)
    return participle.i if end is not None and end.lower in MARKS and participle.lower in _SAME_FORMS else None


def _has_done(document: Document, at: int) -> bool:
    """Whether a "'s" is a "has", since what was done has an object: "somebody's fed *the dog*", "Ann's put *it* away";
    not "he's given a book", "she's called Ann"."""
    tokens = document.tokens
    participle = next((token for token in tokens[at + 1 :] if token.lower not in _BETWEEN), None)
    if tokens[at].lower not in _IS_OR_HAS or participle is None or participle.tag not in (*_PAST, "VB", "VBP", "NN"):
        return False
    behind = next((token for token in tokens[participle.i + 1 :] if token.tag != "RP"), None)
    is_done = participle.tag in _PAST or participle.lower in _SAME_FORMS
    is_object = behind is not None and (behind.tag in ("DT", "PRP$", "CD") or behind.lower in _OBJECTS)
    return is_done and is_object and participle.lower not in _HAVING_TWO_OBJECTS


def is_done_by_others(document: Document, at: int) -> bool:
    """Whether an "if" or the like asks if somebody else has done what the verb says, or it is waited for: "if Tim has
    put it away", "if the cup has been rinsed", "until Tim has put it away"."""
    tokens = document.tokens
    have = at - 1
    while have > 0 and tokens[have].lower in _BETWEEN | {"been"}:
        have -= 1
    if have < 0 or at not in (perfect_participle(document, have), passive_participle(document, have)):
        return False
    if tokens[have].lower not in _HAVE:
        return False
    for j in range(have - 1, -1, -1):
        if tokens[j].lower in _WAITING and tokens[at - 1].lower == "been":
            return False  # "once the guest has been led in" is an order
        if tokens[j].lower in _WHETHER | _WAITING:
            if tokens[at - 1].lower == "been" and j and tokens[j - 1].lemma in _ASKING:
                return False  # "see if they have been washed"
            return have - j > 1 and tokens[have - 1].lower not in _SPEAKING
        if tokens[j].lower in MARKS or tokens[j].pos == "VERB":
            return False
    return False


def is_asked_done(document: Document, at: int) -> bool:
    """Whether a question asks if somebody has done what the verb says: "has anybody *fed* the cat?", "did I *lock* the
    door?", "have you *locked* it?"; not "have you got it?"."""
    tokens, start = document.tokens, at
    while start and tokens[start - 1].lower not in MARKS and document.sentences[start - 1] == document.sentences[at]:
        start -= 1
    words = [token.lower for token in tokens[start:at] if token.lower not in _BETWEEN]
    if len(words) < 2:
        return False
    if words[1] in _LISTENER and (tokens[at].lemma in _HAVING_AT_HAND or _is_ordered_behind(document, at)):
        return False
    is_perfect = words[0] in _HAVING and (tokens[at].tag in _PAST or tokens[at].lower in _SAME_FORMS)
    behind = tokens[at + 1 : at + 2]
    is_object = bool(behind) and (behind[0].tag in ("DT", "PRP$", "CD") or behind[0].lower in _OBJECTS)
    is_perfect = is_perfect and (words[0] != "have" or is_object)  # not "have the table laid by six"
    is_past = words[0] == "did" and tokens[at].tag in ("VB", "VBP")
    return (is_perfect or is_past) and not any(token.pos == "VERB" for token in tokens[start + 1 : at])


def _is_ordered_behind(document: Document, at: int) -> bool:
    """Whether the sentence behind that of a token is no case: "did you lock it? *Go and check*"."""
    behind = next((t for t in document.tokens[at:] if document.sentences[t.i] != document.sentences[at]), None)
    return behind is not None and behind.lower not in _WHETHER


def is_denied_of_others(document: Document, at: int) -> bool:
    """Whether an "if" or the like asks if somebody named does not do what the verb says: "if Ann doesn't *shut* it,
    ...", with a mark behind or the order ahead; not "if she doesn't *shut* the gate", which may be "if she doesn't,
    shut the gate"."""
    tokens, sentences = document.tokens, document.sentences
    if at < 3 or tokens[at - 1].lower not in _NOT or tokens[at - 2].lower not in _DO or tokens[at].tag != "VB":
        return False
    opener = next((j for j in range(at - 3, max(-1, at - 9), -1) if tokens[j].lower in _WHETHER), None)
    subject = () if opener is None else tokens[opener + 1 : at - 2]
    if opener is None or not subject or subject[-1].lower in _SPEAKING | {"it", "this", "that"}:
        return False
    is_many = subject[-1].tag in ("NNS", "NNPS") or subject[-1].lower == "they"  # "don't" is else an order's
    is_order = tokens[at - 2].lower == "do" and not is_many
    if is_order or any(t.pos in ("AUX", "VERB") or t.text in MARKS for t in subject):
        return False
    behind = [t for t in tokens[at + 1 :] if sentences[t.i] == sentences[at]]
    end = next((n for n, t in enumerate(behind) if t.lower in MARKS), len(behind))
    is_followed = any(t.tag == "VB" for t in behind[end:])
    is_trailing = not is_followed and opener > 0 and sentences[opener - 1] == sentences[at]
    return end > 0 and (is_followed or (is_trailing and tokens[opener - 1].lower not in MARKS))


def are_gone(document: Document, at: int) -> bool:
    """Whether who speaks has gone, which is no way of the robot's: "after *we've gone* to bed"."""
    words = [token.lower for token in document.tokens[max(0, at - 5) : at] if token.lower not in _BETWEEN | {"both"}]
    is_of_speaker = words[-2:-1] in (["we"], ["i"]) and words[-1] in _HAVING
    return is_of_speaker and words[-3:-2] != [] and words[-3] in _OPENING and document.tokens[at].tag in _PAST


def _goes_on(document: Document, gone: int) -> bool:
    """Whether "gone" tells what something has become, or where to: "gone cold", "gone out"."""
    token = document.tokens[gone + 1] if gone + 1 < len(document) else None
    return token is not None and token.lower not in _NOT_ON and (token.tag in _COMPLEMENTS or token.lower in _AWAY)
