"""Openings: what the words around a task do with what was said before, call it off, allow it or turn from it."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.understanding.control_flow.stretch import PUNCTUATION
from decomplex_bt.understanding.control_flow.wording import PERSONS
from decomplex_bt.understanding.cue_phrases import ASKING_LEMMAS, normal_form
from decomplex_bt.understanding.cues import Cue
from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.rules.orders.prohibitions import NEGATIONS, is_behind_otherwise, lifts
from decomplex_bt.understanding.vocabulary import PREPOSITIONS

ITS = frozenset("it them 'em em him her this that these those".split())
STARTING = frozenset((".", ",", ";", ":", "!", "?", "-", "–", "—", "and", "but", "oh", "though"))
_MAY = frozenset("can may could will 'll".split())
_BEING_LEFT = frozenset("stay wait keep do remain".split())
_OPENERS = frozenset(("if", "when"))
_LEAVING = tuple(
    tuple(phrase.split())
    for phrase in (
        "leave it", "leave that", "leave them", "leave those", "leave him", "leave her", "skip it", "skip that",
        "skip them", "forget it", "forget about it", "forget that", "never mind", "nevermind", "do not", "dont",
        "do not bother", "dont bother", "do not do it", "do not do that", "hold off", "let it be", "let them be",
        "let him be", "let her be", "do it later", "do that later", "give it a miss", "no need",
    )
)  # fmt: skip
"""What says that something is not to be done, in the normal form of cues."""
_FORBIDDING = (["do", "not"], ["dont"])
_TURNING_TO = frozenset("now anyway finally lastly meanwhile besides".split())
_COUNTING = frozenset("second secondly third thirdly fourth fourthly fifth fifthly".split())
"""What tells of the next of several matters, set off by a mark: "*third*, close the frame"."""
_LEADING_IN = frozenset("and but so right okay ok well oh , please".split())
_OTHER = frozenset("another other different separate unrelated".split())
_MATTERS = frozenset("note matter subject topic".split())
_BEFORE_MATTER = frozenset("on to a an and but then now so for completely entirely quite".split())
"""What may stand before "another matter" where it tells only that one follows."""
_AFTER_LEAVING = frozenset("till until for as alone be where there then to and just bother".split())
_BE = frozenset("is are 's 're".split())
_SAID_WHERE = frozenset("there one it they".split())
_BEING_LET = frozenset("be wait stay sleep rest".split())
_PICKED = frozenset("any those ones one anything whatever whichever".split())
_ONCE = frozenset(("after", "when"))
_PERFECT = frozenset("have 've had 'd ve".split())
_DONE_SO_FAR = _PERFECT | frozenset("just already both all finally".split())
_NEAR = 3
"""Within so many words behind an "if not" that no mark ends its order begins: "if not please just wake him"."""
_URGING = frozenset(("please", "do", "also", "just"))
_TIMING = frozenset(
    "before beforehand first firstly prior between ahead earlier sooner until till already after afterwards "
    "meantime meanwhile while when once start begin beginning advance".split()
)
"""Words that may say when something is done that a "but" adds."""
_PUTTING_OFF = frozenset("wait delay postpone not only".split())
_HOLDING_BACK = frozenset("but first before yet though".split())
_PARTING = PUNCTUATION | frozenset("and but then so or first before please just".split())
_TRIED = frozenset(("that", "this", "it", "you"))
_TRYING = frozenset("help work works trick fail fails succeed manage possible impossible".split())
_ABLE = frozenset("can could able unable manage".split())
_BESIDE_ABLE = frozenset("you is to still possibly actually somehow even".split())
_OPEN_QUESTIONS = frozenset("what who whose which where when why".split())
_ARRIVING = (["you", "is", "there"], ["you", "are", "there"], ["you", "get", "there"])
_CASES = dict.fromkeys(("that", "this", "such", "latter", "second"), "same") | dict.fromkeys(
    ("former", "first"), "other"
)
"""Which case is meant by what stands before "case", behind what is done in one."""
_LIMITS = frozenset("under over below above".split())
_DEGREES = frozenset(("ADJ", "ADV"))
"""How full something is a state answers, but neither how it is nor how many there are."""
_AMOUNTS = (["how", "many"], ["how", "much"])
_WAITING = frozenset(("wait", "hold"))
_SOFTENING = frozenset(("just", "please", "simply", ","))
_SUPPOSING = frozenset(("might", "may", "could"))
OTHERWISE = frozenset(("otherwise", "or", "alternatively"))


def ability(document: Document, ahead: Sequence[Cue], token: int) -> str:
    """Whether what opens a clause asks if the listener is able ("asked": "if you can find it"), says that it is
    ("answered": "can you find it? If you can, ..."), or denies it ("denied")."""
    said = [[normal_form(t.lower) for t in document.tokens[cue.first : cue.last + 1]] for cue in ahead]
    for cue, words in zip(ahead, said, strict=True):
        if cue.name == "fail" and not _ABLE.isdisjoint(words):
            return "denied"
        if cue.name == "so" and not _ABLE.isdisjoint(words):
            return "answered"
        between = {normal_form(t.lower) for t in document.tokens[cue.last + 1 : token]}
        if cue.name in ("if", "when") and "you" in between and between & _ABLE and between <= _ABLE | _BESIDE_ABLE:
            return "asked"
    return ""


def says_in_vain(ahead: Sequence[Cue], document: Document) -> bool:
    """Whether what opens a clause says that what was done before it was of no use: "if that doesn't help"."""
    said = [{t.lower for t in document.tokens[cue.first : cue.last + 1]} for cue in ahead if cue.name == "fail"]
    return any(not _TRYING.isdisjoint(words) and not _TRIED.isdisjoint(words) for words in said)


def asks_open(document: Document, token: int) -> bool:
    """Whether a task is to find out what no yes or no answers ("see what he is doing", "check how many there are")."""
    tokens = document.tokens[token : token + 4]
    words = [t.lower for t in tokens]
    word = 1 + (words[1:2] == ["out"])
    is_order = tokens[0].lemma in ASKING_LEMMAS and tokens[0].tag in ("VB", "VBP")
    is_open = words[word : word + 1] != [] and words[word] in _OPEN_QUESTIONS
    is_how = words[word : word + 1] == ["how"] and word + 1 < len(tokens) and tokens[word + 1].pos not in _DEGREES
    return is_order and (is_open or is_how or words[word : word + 2] in _AMOUNTS)


def turns(document: Document, ahead: Sequence[Cue], token: int) -> tuple[str, ...]:
    """What turns to the other case ahead of a verb, also where no mark ends it ("is he up *if not* wake him")."""
    found = []
    for cue in ahead:
        words = [normal_form(t.lower) for t in document.tokens[cue.first : cue.last + 2]]
        is_bare = words == ["if", "not"] and 0 < token - cue.first - 1 <= _NEAR and document.tokens[token].tag == "VB"
        if is_bare or (cue.name == "else" and "if" in words[:-1] and "otherwise" not in words):
            found.append("not")
        elif cue.name == "else" and not is_adverb(document, cue.first):
            found.append("otherwise")
    return tuple(found)


def is_on_arrival(document: Document, previous: int, token: int) -> bool:
    """Whether the words ahead of a verb, up to the task before, say that it is done there: "*once you're there*"."""
    words = [normal_form(t.lower) for t in document.tokens[previous + 1 : token]]
    openings = (i for i, word in enumerate(words) if word in ("once", "when"))
    return any(words[i + 1 : i + 4] in _ARRIVING for i in openings)


def is_past_wait(document: Document, previous: int, token: int) -> bool:
    """Whether all that the sentences between the task before and that of a verb order is to wait: "if it isn't hot,
    *wait*. Then bring it"."""
    ahead = [t for t in document.tokens[previous + 1 : token] if document.sentences[t.i] < document.sentences[token]]
    return previous >= 0 and any(t.lower in _WAITING and t.tag in ("VB", "VBP", "NN") for t in ahead)


def is_past_supposition(document: Document, token: int) -> bool:
    """Whether the sentence before that of a verb says what "it" might be: "*it might be Ann*. If it is, ..."."""
    sentence = document.sentences[token] - 1
    words = [t.lower for t in document.tokens[:token] if document.sentences[t.i] == sentence]
    return words[:1] == ["it"] and words[1:2] != [] and words[1] in _SUPPOSING and words[2:3] == ["be"]


def takes_up_case(document: Document, previous: int, token: int) -> str:
    """ "same" where the words ahead of a verb, up to the task before, say that it is done in the case of that ("*in
    that case*, also ..."), "other" where in the other one ("*in the former case*", "if it's under ten, ...; *over
    that*, ..."); else ""."""
    sentence = document.sentences[token]
    ahead = document.tokens[previous + 1 : token]
    words = [normal_form(t.lower) for t in ahead if document.sentences[t.i] == sentence]
    for i, word in enumerate(words):
        if word == "case" and "in" in words[max(0, i - 3) : i]:
            return _CASES.get(words[i - 1], "")
    while words and words[-1] in (",", "just", "please"):
        words.pop()
    tokens = document.tokens
    is_limited = any(t.lower in _LIMITS and tokens[t.i + 1].tag == "CD" for t in tokens[:previous])
    is_parted = words[-3:-2] in ([], [";"], [","], ["and"])
    is_beyond = words[-1:] == ["that"] and not _LIMITS.isdisjoint(words[-2:-1])
    return "other" if is_limited and is_parted and is_beyond else ""


def of_both(document: Document, previous: int, token: int, last: int) -> str:
    """ "neither" or "either", where an "if" ahead of a verb is of none, or any, of what was asked before: "*if
    neither*, ...", "*if it isn't in either*, ...", "*if either* is, ..."; else ""."""
    words = [normal_form(t.lower) for t in document.tokens[previous + 1 : max(token, last) + 1]]
    if "if" not in words[: token - previous - 1]:
        return ""
    words = words[words.index("if") :]
    if words[1] in ("neither", "none") or "neither" in words:
        return "neither"
    if "either" not in words or words[1:3] == ["either", "way"]:
        return ""
    is_place = words[words.index("either") - 1] in ("in", "of", "on", "at")
    is_denied = not {"not", "none", "no"}.isdisjoint(words)
    return ("neither" if is_denied else "either") if words[1] == "either" or is_place else ""


def calls_off(document: Document, previous: int, token: int, following: int, leading: Sequence[str]) -> bool:
    """Whether the words behind a condition, up to the next task in its sentence, begin with a "leave it" or the like,
    or behind a "but" with a "let him" or a "wait"; or those between a "but" and the condition do ("but leave it *if
    it's wet*"). A "don't" that forbids another deed leaves that alone ("go up. If she's asleep, *don't turn on* the
    light"). `previous`, `following`: the tasks before and behind."""
    if _OPENERS.isdisjoint(leading):
        return False
    if _calls_off_ahead(document, previous, token):
        return True
    tokens, sentence = document.tokens, document.sentences[token]
    words = [normal_form(t.lower) for t in tokens[token + 1 : following] if document.sentences[t.i] == sentence]
    is_joined = following < len(tokens) and document.sentences[following] == sentence
    forbids_other = is_joined and previous >= 0 and tokens[following].lemma != tokens[previous].lemma
    for i in range(1, len(words)):
        is_else = i > 1 and words[i - 1] == "else" and words[i - 2] in PUNCTUATION | {"or"}
        if is_else or words[i - 1] in OTHERWISE or words[i - 2 : i] == ["if", "not"]:
            return False
        said = _leaves(words[i:])
        if said is not None:  # "leave it *otherwise*", "leave it *if it's dry*" tell of another case than this
            return (
                said
                and {"otherwise", "else", "if"}.isdisjoint(words[i:])
                and not (forbids_other and words[i:] in _FORBIDDING)
            )
        if "but" in leading and _is_letting(words[i : i + 3]) and words[i + 2] in _BEING_LET:
            return True
        if "but" in leading and words[i - 1] in PUNCTUATION and (words[i] == "wait" or _is_letting(words[i : i + 3])):
            return True
    return False


def picks(document: Document, token: int) -> str:
    """ "is" or "not", where what is behind a verb is what of those that were checked is so, or is not: "any that are
    not", "those which are", "the ones that aren't", "whatever isn't"; else ""."""
    words = [normal_form(t.lower) for t in document.tokens[token + 1 : token + 8]]
    words = words[words[:1] == ["the"] :]
    if words[:1] == [] or words[0] not in _PICKED:
        return ""
    rest = words[1 + (words[1:2] != [] and words[1] in ("that", "which")) :]
    if rest[:1] == [] or rest[0] not in ("is", "are"):
        return ""
    is_denied = rest[1:2] == ["not"]
    behind = rest[1 + is_denied :]
    is_end = not behind or behind[0] in PUNCTUATION or behind[0] in ("and", "then", "yet")
    return ("not" if is_denied else "is") if is_end else ""


def tells_where(document: Document, token: int) -> bool:
    """Whether the words behind a case, up to the end of its sentence, say where something is: "if it's locked, *the key
    is in the drawer*", "if we're out of it, *there's some in the cellar*"."""
    tokens, sentences = document.tokens, document.sentences
    rest = [t for t in tokens[token + 1 :] if sentences[t.i] == sentences[token]]
    comma = next((n for n, t in enumerate(rest) if t.text == ","), len(rest))
    said = rest[comma + 1 :]
    be = next((n for n, t in enumerate(said) if t.lower in _BE), 0)
    is_named = be > 0 and (said[be - 1].pos in ("NOUN", "PROPN") or said[be - 1].lower in _SAID_WHERE)
    return is_named and any(t.lower in PREPOSITIONS for t in said[be + 1 :]) and all(t.tag != "VB" for t in said)


def let_be(document: Document, token: int) -> str:
    """The noun, as a lemma, of what may be as it is, or the "it", where that is all that is said behind a case up to
    the end of its sentence: "if there's no room, *the jars can stay* out", "if it's late, *it can wait*"; "" else."""
    tokens, sentences = document.tokens, document.sentences
    rest = [t for t in tokens[token + 1 :] if sentences[t.i] == sentences[token]]
    comma = next((n for n, t in enumerate(rest) if t.text == ","), len(rest))
    said = rest[comma + 1 :]
    may = next((n for n, t in enumerate(said) if t.lower in _MAY), 0)
    is_named = may > 1 and said[0].pos == "DET" and said[may - 1].pos in ("NOUN", "PROPN")
    is_named = is_named or (may == 1 and said[0].lower in ITS and "do" not in (t.lower for t in said))
    is_named = is_named and said[may + 1 : may + 2] != [] and said[may + 1].lower in _BEING_LEFT
    is_alone = is_named and all(t.text not in PUNCTUATION for t in said[may:-1])
    is_alone = is_alone and all(t.pos not in ("VERB", "CCONJ") for t in said[may + 2 :])
    return said[may - 1].lemma if is_alone else ""


def _calls_off_ahead(document: Document, previous: int, token: int) -> bool:
    words = [normal_form(t.lower) for t in document.tokens[previous + 1 : token]]
    start = next((i for i in range(len(words) - 1, -1, -1) if words[i] == "but"), len(words)) + 1
    stop = next((i for i in range(start, len(words)) if words[i] in _OPENERS), start)
    while start < stop and words[start] in _URGING:
        start += 1
    order = words[start:stop]
    is_letting = _is_letting(order[:3]) and PUNCTUATION.isdisjoint(order)
    return stop < len(words) and previous >= 0 and (bool(_leaves(order)) or is_letting)


def _leaves(words: Sequence[str]) -> bool | None:
    """Whether words that begin with a "leave it" or the like leave it at that, not "... on the shelf"; None: they begin
    otherwise."""
    said = next((phrase for phrase in _LEAVING if tuple(words[: len(phrase)]) == phrase), None)
    if said is None:
        return None
    rest = words[len(said) : len(said) + 1]
    return not rest or rest[0] in PUNCTUATION or rest[0] in _AFTER_LEAVING


def opens_matter(document: Document, token: int) -> bool:
    """Whether the sentence of a token begins with a word that turns to something else, be it behind an "and" or
    "right": "And *now* bring me the tea"."""
    first = document.sentences.index(document.sentences[token])
    while first < token and document.tokens[first].lower in _LEADING_IN:
        first += 1
    is_counted = document.tokens[first].lower in _COUNTING and first < token
    if is_counted and document.tokens[first + 1].text in (",", ":"):
        return first + 2 == token  # not "second, *if that went well*, ..."
    return document.tokens[first].lower in _TURNING_TO


def tells_matter(document: Document, previous: int, token: int) -> bool:
    """Whether words between two tasks say, between marks, that another matter follows: "..., and then, *on a different
    note*, lock up", "*separately*, if it's dry, ..."."""
    for i in range(previous + 1, token - 1):
        words = [t.lower for t in document.tokens[i : i + 2]]
        last = i if words[0] == "separately" else i + 1
        is_said = last == i or (words[0] in _OTHER and words[1] in _MATTERS)
        if is_said and document.tokens[last + 1].text in STARTING:
            start = i
            while start > 0 and document.tokens[start - 1].lower in _BEFORE_MATTER:
                start -= 1
            return document.tokens[start - 1].text in PUNCTUATION
    return False


def allows(document: Document, token: int, following: int, leading: Sequence[str]) -> bool:
    """Whether all that its sentence says behind a condition lifts a prohibition."""
    is_last = following == len(document) or document.sentences[following] != document.sentences[token]
    return is_last and not _OPENERS.isdisjoint(leading) and lifts(document, token)


def _is_letting(words: Sequence[str]) -> bool:
    return len(words) == 3 and words[0] == "let" and words[1] in PERSONS | ITS


def is_had_done(document: Document, cues: Sequence[Cue], i: int) -> bool:
    """Whether the verb at token `i` tells what the listener has done by then ("after you have mopped it", "once you've
    swept and *mopped* it", "after mopping it"), where a "when" takes a perfect."""
    verb = document.tokens[i]
    is_joined = verb.dep == "conj" and verb.tag in ("VBD", "VBN", "VBG") and verb.head < i
    if is_joined and is_had_done(document, cues, verb.head):
        return True
    opening = max((cue for cue in cues if cue.first < i and cue.name in _ONCE), key=lambda cue: cue.last, default=None)
    if opening is None or opening.last >= i:
        return False
    words = [token.lower for token in document.tokens[opening.last + 1 : i]]
    if verb.tag == "VBG":
        return opening.name == "after" and not words
    is_perfect = not _PERFECT.isdisjoint(words) or opening.name == "after"
    return words[:1] in (["you"], ["u"]) and _DONE_SO_FAR.issuperset(words[1:]) and is_perfect


def is_mere_contrast(document: Document, i: int) -> bool:
    """Whether a "but" stands right ahead of the order at token `i`, and no word up to the end of its sentence may say
    that it comes before or between others; what others do later says nothing of that ("but open it *before she comes
    in*")."""
    tokens, sentences = document.tokens, document.sentences
    start = i - 1
    while start > 0 and tokens[start].lower in _URGING:
        start -= 1
    behind = (t.lower for t in tokens[i:] if sentences[t.i] == sentences[i] and not _is_before_others(document, t.i))
    return start >= 0 and tokens[start].lower == "but" and _TIMING.isdisjoint(behind)


def is_due_before_others(document: Document, i: int) -> bool:
    """Whether the words behind the verb at token `i`, in its sentence, say that it is due before somebody else acts."""
    sentences = document.sentences
    return any(_is_before_others(document, j) for j in range(i, len(document)) if sentences[j] == sentences[i])


def _is_before_others(document: Document, at: int) -> bool:
    """Whether a "before" at a token opens what somebody else does: "before *Kim* comes in"."""
    who, does = (*document.tokens[at + 1 : at + 3], None, None)[:2]
    if document.tokens[at].lower != "before" or who is None or does is None:
        return False
    is_somebody = who.lower in PERSONS or (who.tag == "NNP" and who.text[:1].isupper())
    return is_somebody and does.tag in ("VBZ", "VBP", "VBD")


def is_waited_for(document: Document, cues: Sequence[Cue], i: int) -> bool:
    """Whether an order to wait opens the clause of the verb at token `i` ("*wait until* it's hot", "and *hang on till*
    she's back"); not behind a "but" or "first", which may say to wait before."""
    tokens = document.tokens
    opening = max((cue for cue in cues if cue.first < i), key=lambda cue: cue.last, default=None)
    if opening is None or opening.name != "until":
        return False
    start = next((j + 1 for j in range(opening.first - 1, -1, -1) if tokens[j].lower in _PARTING), 0)
    words = [token.lower for token in tokens[start : opening.first]]
    is_wait = words[:1] in (["wait"], ["stay"]) or words[:2] in (["hang", "on"], ["hold", "on"], ["stand", "by"])
    is_held_back = not _HOLDING_BACK.isdisjoint(token.lower for token in tokens[max(0, start - 2) : start])
    return is_wait and not is_held_back and {"first", "with"}.isdisjoint(words)  # "wait with that till ..."


def is_end(document: Document, cues: Sequence[Cue], i: int) -> bool:
    """Whether an "until" opens the clause of the verb at token `i` and says up to what the order before goes on ("beat
    it *until it's stiff*"), not how long it is put off ("that can wait until ...", "no sooner than ...")."""
    opening = max((cue for cue in cues if cue.first < i), key=lambda cue: cue.last, default=None)
    if opening is None or opening.name != "until" or opening.first != opening.last:
        return False
    ahead = document.tokens[opening.first - 1] if opening.first else None
    return ahead is not None and ahead.lemma not in _PUTTING_OFF and ahead.text not in MARKS


def is_past_idle(observed: Observed, previous: int, split: int, token: int) -> bool:
    """Whether an order at `token` is joined by ", and" (the comma is `split`) to what orders nothing right behind an
    "otherwise": a "don't", or a verb that is no task ("otherwise *leave it*"); `previous`: the task before."""
    tokens, sentences = observed.document.tokens, observed.document.sentences
    if not 0 <= split < token - 1 or tokens[split].text != "," or tokens[split + 1].lower != "and":
        return False
    start = next((i for i in range(split, -1, -1) if sentences[i] != sentences[token]), -1) + 1
    denied = [i for i in range(start, split) if tokens[i].lower in NEGATIONS and is_behind_otherwise(observed, i)]
    denied += [i for i in range(start, split) if tokens[i].tag in ("VB", "VBP") and _opens_otherwise(observed, i)]
    if not denied or previous >= max(denied):
        return False
    return all(t.text not in PUNCTUATION and t.tag != "CC" for t in tokens[max(denied) : split])


def _opens_otherwise(observed: Observed, verb: int) -> bool:
    """Whether a verb is the first word behind an "otherwise" or "if not", but for a "just" or "please"."""
    ends = [cue.last + 1 for cue in observed.cues if cue.name == "else" and cue.last < verb]
    return bool(ends) and all(token.lower in _SOFTENING for token in observed.document.tokens[ends[-1] : verb])


def is_adverb(document: Document, otherwise: int) -> bool:
    """Whether an "otherwise" opens nothing: "or otherwise damaged", "if he says otherwise", "unless I tell you
    otherwise, ..."."""
    before, after = document.tokens[otherwise - 1 : otherwise], document.tokens[otherwise + 1 : otherwise + 2]
    is_of_adjective = bool(after) and after[0].tag in ("VBN", "JJ")
    is_told = otherwise > 1 and document.tokens[otherwise - 2].lemma == "tell" and before[0].pos == "PRON"
    is_told = is_told and (not after or after[0].text in PUNCTUATION)
    return is_of_adjective or is_told or (bool(before) and before[0].pos == "VERB")
