"""Prohibitions: the verbs that an instruction forbids ("don't open the window"), or calls needless, which are no tasks
whatever a model says of them."""

from __future__ import annotations

from collections.abc import Collection
from itertools import pairwise

from decomplex_bt.understanding.cue_phrases import CONDITIONAL, normal_form
from decomplex_bt.understanding.document import FINITE, MARKS, Document, Token
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.rules.orders.spared import spared

NEGATIONS = frozenset(("n't", "nt", "not", "never"))
_AUXILIARIES = frozenset("do must should shall need dare".split())
_BETWEEN = frozenset("please ever even".split())
OMITTING = frozenset("forget omit neglect fail hesitate".split())
"""What not to do is to see to it: "don't forget to lock up", "don't hesitate to wake me"."""
_POLITELY = frozenset("please maybe kindly perhaps possibly".split())
_REQUESTING = frozenset("could can would will".split())
_LETS = (("let", "'s"), ("let", "us"))
_BEFORE_ADVICE = MARKS | frozenset("and but so then oh no".split())
_LIMITS = frozenset("only just merely simply".split())
"""What is "not only" done is done as well."""
_NO_NEED = frozenset((("no", "need"), ("no", "reason"), ("no", "use")))
_NECESSARY = frozenset(("necessary", "needed", "required"))
_NEEDING = frozenset(("need", "have"))
_IN_PLACE_OF = frozenset((("rather", "than"), ("instead", "of")))
_ENDS = MARKS | {"and", "but", "just", "then"}
_ALLOWING = frozenset(
    tuple(phrase.split())
    for phrase in (
        "do", "do so", "do it", "do that", "go ahead", "you may", "you can", "you may do so", "that is fine",
        "that is ok", "that is okay", "that is all right", "it is fine", "it is ok", "fine", "ok", "okay",
    )
)  # fmt: skip
"""What says that something may be done after all, in the normal form of cues."""
_BESIDE_ALLOWING = frozenset("then please by all means though however".split())
_BESIDE_OTHERWISE = frozenset((",", "then", "please", "just", "well"))
_LEFT = frozenset("it them that this 'em".split())
_LONGEST_NAMED = 4
"""The most words that name what is let be."""
_CASES = frozenset("if when unless otherwise else".split())


def forbidden(observed: Observed) -> tuple[int, ...]:
    """The tokens of the verbs that are forbidden whatever happens, in text order.

    A rule of grammar: "do not", "must not", "never" and the like ahead of a bare verb, with no subject but "you", in a
    clause without a condition, an order or a question, or right behind an "otherwise"; "without", "rather than" and
    "instead of" ahead of a gerund; and what is to be left as it is.
    """
    document = observed.document
    tokens = document.tokens
    negations = [i for i, token in enumerate(tokens) if token.lower in NEGATIONS]
    needless, passed = _needless(document), [*_passed_over(document), *spared(observed)]
    if not negations and not needless:
        return tuple(sorted(passed))
    cues = [cue.first for cue in observed.cues if cue.name in CONDITIONAL]
    conditional = {document.sentences[cue] for cue in cues}
    ordered = [token.lemma for token in tokens if token.tag in ("VB", "VBP")]
    is_passed = {v: document.sentences[v] not in conditional or ordered.count(tokens[v].lemma) > 1 for v in needless}
    found = passed + [i for verb in needless if is_passed[verb] for i in (verb, *_joined(document, verb))]
    for i in negations:
        # of what an "otherwise" forbids only what stands behind may say more
        governing = [cue for cue in cues if cue > i] if is_behind_otherwise(observed, i) else cues
        is_asked = _is_asked_not_to(document, i)
        if any(_may_govern(document, cue, i) for cue in governing) or (observed.question[i] and not is_asked):
            continue
        is_told = tokens[i].lower == "never" or (i > 0 and tokens[i - 1].lower in _AUXILIARIES)
        if not is_told and not is_asked:
            continue
        verb = i + 1
        if is_asked and verb < len(tokens) and tokens[verb].lower == "to":
            verb += 1  # "try not to wake her"
        if verb < len(tokens) and tokens[verb].lower in _LIMITS:
            continue
        while verb < len(tokens) and (tokens[verb].tag == "RB" or tokens[verb].lower in _BETWEEN):
            verb += 1
        if verb + 2 < len(tokens) and tokens[verb].lower in _NEEDING and tokens[verb + 1].lower == "to":
            verb += 2  # "you don't need to wash it"
        is_named = verb < len(tokens) and tokens[verb].lemma not in OMITTING
        is_verb = is_named and (_is_bare(document, verb) or (is_asked and tokens[verb].tag == "VBG"))
        if is_verb and (is_asked or not _has_subject(document, verb)):
            found += [verb, *_joined(document, verb)]
    return tuple(sorted(set(found)))


def put_off(document: Document) -> frozenset[int]:
    """The verbs of orders that are only forbidden in a case until something else is done first, in the sentence behind
    ("if it's wet, don't *fold* it. Dry it first")."""
    tokens, sentences = document.tokens, document.sentences
    return frozenset(
        i + 1
        for i in range(2, len(tokens) - 1)
        if tokens[i].lower in NEGATIONS
        and (tokens[i - 2].text, tokens[i - 1].lower) == (",", "do")
        and tokens[sentences.index(sentences[i])].lower == "if"
        and _is_bare(document, i + 1)
        and [t.lower for t in tokens if sentences[t.i] == sentences[i] + 1 and t.text not in MARKS][-1:] == ["first"]
    )


def _is_asked_not_to(document: Document, negation: int) -> bool:
    """Whether a "not" is of a request not to do something: "could you please *not* open it", "would you mind *not*
    opening it", "you'd better *not*", "let's *not*", "try *not* to"; no "couldn't you", which asks to do it."""
    tokens = document.tokens
    if tokens[negation].lower != "not":
        return False
    last = negation - 1
    while last >= 0 and tokens[last].lower in _POLITELY:
        last -= 1
    ahead = tuple(token.lower for token in tokens[max(0, last - 2) : last + 1])
    if ahead[-1:] == ("mind",):
        ahead = ahead[:-1]
    is_of_you = ahead[-1:] == ("you",) and ahead[-2:-1] and ahead[-2] in _REQUESTING
    is_advice = ahead[-1:] in (("better",), ("best",)) and (
        ahead[:-1] in (("had",), ("you", "had")) or ahead[0] == "you" or _opens_clause(document, last)
    )
    return is_of_you or is_advice or ahead[-2:] in _LETS or ahead[-1:] == ("try",)


def _opens_clause(document: Document, at: int) -> bool:
    """Whether a clause of an order begins here: "*better* not open it", "but *best* not wake her"."""
    tokens, sentences = document.tokens, document.sentences
    is_first = at == 0 or sentences[at - 1] != sentences[at]
    return is_first or tokens[at - 1].lower in _BEFORE_ADVICE


def is_behind_otherwise(observed: Observed, negation: int) -> bool:
    """Whether a "don't" stands right behind an "otherwise" or "if not", so that it is all that is said of that case
    ("otherwise *don't* open it"), and forbids nothing that is ordered before."""
    tokens = observed.document.tokens
    start = negation if tokens[negation].lower == "never" else negation - 1
    last = start - 1
    while last > 0 and tokens[last].lower in _BESIDE_OTHERWISE:
        last -= 1
    if start < 0 or not any(cue.name == "else" and cue.last == last for cue in observed.cues):
        return False
    ordered = {token.lemma for token in tokens[:last] if token.pos == "VERB" or token.tag.startswith("VB")}
    return tokens[min(negation + 1, len(tokens) - 1)].lemma not in ordered


def is_elided(document: Document, at: int) -> bool:
    """Whether the "do" of a "don't" forbids in a case what was ordered before, and says no verb: "if she's in there
    *don't*, ...", "if it's wet then *don't*"; not "if they *don't*, ..."."""
    tokens, sentences = document.tokens, document.sentences
    if tokens[at].lower != "do" or at + 1 >= len(tokens) or tokens[at + 1].lower not in NEGATIONS:
        return False
    behind = tokens[at + 2].lower if at + 2 < len(tokens) and sentences[at + 2] == sentences[at] else "."
    if behind not in _ENDS:
        return False
    case = at - 1
    while case >= 0 and sentences[case] == sentences[at] and tokens[case].lower not in _CASES:
        case -= 1
    if case < 0 or sentences[case] != sentences[at]:
        return False
    said = tokens[case + 1 : at]
    asked = [t for t in said if t.tag in FINITE or t.lower in ("'s", "is", "are")]
    relative = [
        t for t in said[1:] if t.tag in ("WDT", "WP") or t.lower == "that"
    ]  # "if the cups that *are* left don't"
    is_next = tokens[at - 1].text in MARKS or tokens[at - 1].lower in _BESIDE_OTHERWISE
    return len(asked) > len(relative) and (is_next or tokens[at - 1].tag not in ("PRP", "WDT", "WP"))


def is_left_alone(document: Document, verb: int, tasks: Collection[int]) -> bool:
    """Whether a verb only says of a case that nothing is done in it: "if it's too heavy, *leave it*"; `tasks`: the
    tokens of those that are no checks."""
    tokens = document.tokens
    after = tokens[verb + 2] if verb + 2 < len(tokens) else None
    is_end = after is None or after.text in MARKS or after.lower in ("and", "but")
    is_left = tokens[verb].lower == "leave" and verb + 1 < len(tokens) and tokens[verb + 1].lower in _LEFT and is_end
    sentence = [t.i for t in tokens[:verb] if document.sentences[t.i] == document.sentences[verb]]
    case = max((i for i in sentence if tokens[i].lower in _CASES), default=None)
    return is_left and case is not None and not any(case < i < verb for i in tasks)


def let_be(document: Document) -> frozenset[int]:
    """The words that only say what is let be for what is ordered behind a mark instead: "*leave the AC*, just close the
    window"."""
    found: set[int] = set()
    tokens = document.tokens
    for verb in (token.i for token in tokens if token.lower == "leave") if "leave" in document.words else ():
        stop = next((t.i for t in tokens[verb + 1 :] if t.text in MARKS), len(tokens))
        words = tokens[verb + 1 : stop]
        is_thing = 0 < len(words) <= _LONGEST_NAMED and words[-1].pos in ("NOUN", "PROPN", "PRON")
        is_thing = is_thing and all(t.pos in ("DET", "ADJ", "NOUN", "PROPN", "PRON") for t in words)
        behind = [t.lower for t in tokens[stop + 1 : stop + 2]]
        if is_thing and behind in (["just"], ["only"]) and tokens[stop].text != ".":
            found.update(range(verb, stop))
    return frozenset(found)


def _may_govern(document: Document, cue: int, negation: int) -> bool:
    """Whether a cue behind a negation lifts it ("don't open it, but if it's hot, do", "don't open it. If it's hot,
    do"), or stands in its sentence, and neither behind a semicolon nor opens what is contrasted with it: not "don't
    wake her, but if she's up, ...", "don't turn it off, *just* turn it down if ..."."""
    is_next = document.sentences[cue] - document.sentences[negation]
    if cue > negation and is_next in (0, 1) and lifts(document, cue):
        return True
    between = [token.lower for token in document.tokens[negation + 1 : cue]]
    is_contrasted = any(word in MARKS and after in _LIMITS for word, after in pairwise(between))
    return not is_next and between[-1:] != ["but"] and ";" not in between and not is_contrasted


def lifts(document: Document, start: int) -> bool:
    """Whether the words from a condition at token `start` to the end of its sentence end in a "do", "you may" or the
    like behind a mark, or, without one, in a "do" that has no subject: "but if it's hot, *do*", "but if it's hot
    *do*"."""
    sentence = document.sentences[start]
    parts: list[list[Token]] = [[]]
    for token in document.tokens[start:]:
        if document.sentences[token.i] != sentence:
            break
        if token.text in MARKS:
            parts.append([])
        elif token.lower not in _BESIDE_ALLOWING:
            parts[-1].append(token)
    said = [part for part in parts if part]
    if not said:  # nothing is said behind the token but marks
        return False
    condition, *others = said
    if not others:
        return len(condition) > 2 and condition[-1].lower == "do" and condition[-2].pos in ("ADJ", "ADV", "VERB")
    is_all = not any(token.tag == "VB" for part in others[:-1] for token in part)
    return is_all and tuple(normal_form(token.lower) for token in others[-1]) in _ALLOWING


def _is_bare(document: Document, verb: int) -> bool:
    """Whether a word behind a "don't" is a verb; of "don't empty the bin" the tagger takes it for an adjective, of a
    "don't *hoover*" that repeats an order for anything."""
    tokens = document.tokens
    is_followed = verb + 1 < len(tokens) and tokens[verb + 1].tag in ("DT", "PRP$", "PRP")
    is_last = verb + 1 == len(tokens) or tokens[verb + 1].text in MARKS
    is_repeated = is_last and any(token.lower == tokens[verb].lower for token in tokens[: verb - 2])
    is_bare = tokens[verb].tag in ("VB", "VBP") or (is_followed and tokens[verb].pos in ("ADJ", "NOUN"))
    return is_bare or (is_repeated and tokens[verb - 1].lower in NEGATIONS)


def _needless(document: Document) -> list[int]:
    """The verbs of what need not be done: "no need to mop", "it's not necessary to mop"."""
    if document.words.isdisjoint(_NECESSARY | {"no"}):
        return []
    words = [normal_form(token.lower) for token in document.tokens]
    return [
        i + 3
        for i in range(len(words) - 3)
        if words[i + 2] == "to"
        and ((words[i], words[i + 1]) in _NO_NEED or (words[i] == "not" and words[i + 1] in _NECESSARY))
    ]


def is_needless(document: Document, verb: int) -> bool:
    """Whether a verb of `forbidden` is only not needed ("you don't need to wash it", "no use to wash it"), or something
    else is done in its place ("rather than wash it"), or it is an order to leave something as it is."""
    is_left = document.tokens[verb].lower == "leave" and not is_forbidden(document, verb)
    is_tried = verb > 1 and document.tokens[verb - 2].lower == "not"  # "try not to"
    return is_left or (document.tokens[verb - 1].lower in ("to", "than", "of") and not is_tried)


def _passed_over(document: Document) -> list[int]:
    """The verbs of what is not done in that something else is: "without opening it", "rather than wash it", "instead of
    washing it"; not "don't leave without locking up"."""
    if document.words.isdisjoint(("without", "rather", "instead")):
        return []
    tokens = document.tokens
    found = []
    for i, token in enumerate(tokens[:-1]):
        words = tuple(t.lower for t in tokens[max(0, i - 1) : i + 1])
        is_without = token.lower == "without" and not _is_denied(document, i)
        if is_without or words in _IN_PLACE_OF:
            verb = i + 1
            while verb + 1 < len(tokens) and (tokens[verb].tag == "RB" or tokens[verb].lower == "having"):
                verb += 1
            is_verb = tokens[verb].tag == "VBG" or (words == ("rather", "than") and tokens[verb].tag in ("VB", "VBP"))
            found += [verb, *_added(document, verb)] if is_verb else []
    return found


def _is_denied(document: Document, i: int) -> bool:
    """Whether a negation stands ahead of a token in its clause."""
    for j in range(i - 1, -1, -1):
        if document.tokens[j].lower in _ENDS:
            return False
        if document.tokens[j].lower in NEGATIONS:
            return True
    return False


def _added(document: Document, verb: int) -> list[int]:
    """The verbs in the same form that an "and" or "or" joins to a verb."""
    tokens = document.tokens
    return [
        i for i in document.children[verb] if tokens[i].dep == "conj" and tokens[i].tag == tokens[verb].tag == "VBG"
    ]


def _joined(document: Document, verb: int) -> list[int]:
    """The verbs that an "or" joins to a forbidden one: "never boil or fry it"."""
    tokens = document.tokens
    joints = [i for i in document.children[verb] if tokens[i].lower in ("or", "nor")]
    return [
        i
        for i in document.children[verb]
        if tokens[i].dep == "conj" and tokens[i].tag in ("VB", "VBP") and any(joint < i for joint in joints)
    ]


def prohibitions(observed: Observed, tasks: Collection[int]) -> frozenset[int]:
    """The tokens of what is forbidden, up to the end of its clause, where none of them is a task's: the words of "don't
    put it in the closet" are no other task's."""
    tokens = observed.document.tokens
    found: set[int] = set()
    for verb in forbidden(observed):
        stop = verb
        while stop < len(tokens) and tokens[stop].lower not in _ENDS:
            stop += 1
        if not any(verb <= task < stop for task in tasks):
            found.update(range(verb, stop))
    return frozenset(found)


def is_forbidden(document: Document, verb: int) -> bool:
    """Whether a verb is in the bare form right behind a "do not", "never" or the like, said to the one spoken to."""
    tokens = document.tokens
    i = verb - 1
    if i > 0 and tokens[i].lower == "to" and tokens[i - 1].lower in _NEEDING:  # "you don't have to wash it"
        i -= 2
    while i >= 0 and (tokens[i].lower in _BETWEEN or tokens[i].lower == "you"):  # "don't you dare", "don't ever"
        i -= 1
    is_negated = i >= 0 and tokens[i].lower in NEGATIONS
    is_order = is_negated and (tokens[i].lower == "never" or (i > 0 and tokens[i - 1].lower in _AUXILIARIES))
    return is_order and _is_bare(document, verb) and not _has_subject(document, verb)


def _has_subject(document: Document, verb: int) -> bool:
    """Whether somebody but the one spoken to is said not to do it: "they don't open on Sundays"; who is named ahead of
    a mark is the parser's subject alone ("if Gran's asleep, don't mop")."""
    tokens = document.tokens
    start = next((i for i in range(verb - 1, -1, -1) if tokens[i].text in MARKS), -1)
    return any(
        tokens[child].dep in ("nsubj", "nsubjpass", "expl") and tokens[child].lower != "you" and start < child < verb
        for child in document.children[verb]
    )
