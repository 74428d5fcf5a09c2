"""Reports: how far goes what somebody is told or asked, where a second clause belongs to it ("tell Ann the bath is full
*and it's too hot*", "ask Tom to get the bikes *and lock them up*", "... to feed the cat *before he leaves*")."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace

from decomplex_bt.understanding.arguments import CERTAIN, FoundArgument
from decomplex_bt.understanding.document import FINITE, MARKS, Document
from decomplex_bt.understanding.references.chunks import noun_chunks
from decomplex_bt.understanding.vocabulary import PERSON_NOUNS, TIMES_OF_DAY, WEEKDAYS

_TELLING = frozenset("tell say text message inform remind ask".split())
_JOINTS = frozenset(("and", "&"))
_CLAUSE_ENDS = MARKS | _JOINTS | frozenset("but or so then because cos".split())
_ASKING = frozenset("if unless whether when once where who what which why how".split())
_THEY = frozenset(("he", "she", "they"))
_SUBJECTS = _THEY | {"i", "we", "it", "there"}
_DEFINITE = frozenset("the this that these those".split())
_TYPED_IS = frozenset(("its", "theres", "hes", "shes", "theyre"))
"""What is typed for "it's" and the like."""
_CONTRACTED = frozenset("'s 're 'm 'll 've 'd".split())
_STATING = frozenset("be have do feel look seem love hate think know hope".split())
_BEING = frozenset("'s 're 'm is are am".split())
_NEEDING = frozenset("need want like fancy".split())
"""Verbs by which a clause is an order again: "... and I need a towel"."""
_TIMES = frozenset(("before", "when", "while", "until", "till", "after", "once"))
_SAID = frozenset("so this that".split())
_WHEN = WEEKDAYS | TIMES_OF_DAY | frozenset("tonight tomorrow later today now soon".split())
_AROUND_TIMES = frozenset("this in the on at again please first early late next right".split())
_ABLE = frozenset("could can would will might may should".split())
_OTHERWISE_DONE = frozenset("him her them if unless when".split())
"""What tells that a second order is not of who is asked, or leaves that open."""
_TOLD_NEXT = frozenset("the a an this there his her hers its their theirs my mine our ours your yours to that".split())
"""What may begin what somebody is told who is named right ahead of it."""
_GOING = frozenset("run pop nip head drive".split())
"""Ways on which somebody is sent to do something."""
_COURTESIES = frozenset(
    "thanks thank hello hi goodbye bye goodnight night morning sorry please grace happy congratulations".split()
)
_TAKEN_UP = {"it": frozenset(("NN", "NNP")), "them": frozenset(("NNS", "NNPS"))}
"""By the word that takes up what was named, how that is tagged."""


def reported(document: Document, tasks: Collection[int], verb: int) -> range:
    """The tokens by which what is told by a verb goes on behind its first clause, in which no token is among the
    `tasks`; empty where it does not."""
    start = _clause_end(document, verb + 1)
    if document.tokens[verb].lemma not in _TELLING or any(i in tasks for i in range(verb + 1, start)):
        return range(0)
    request = _request(document, range(verb + 1, start))
    before = next((i for i in request if document.tokens[i].lower == "before" and _is_theirs(document, i + 1)), start)
    if before < start:
        return range(before, start)
    stop = start
    while _is_joint(document, stop) and (
        (request and stop == start and _is_of_request(document, request, stop + 1))
        or (_states(document, range(verb + 1, start)) and _is_statement(document, stop + 1))
    ):
        stop = _clause_end(document, stop + 1)
    return range(start, stop)


def within_reports(document: Document, tasks: Mapping[int, str]) -> frozenset[int]:
    """The tokens by which messages go on, in which nothing is a task."""
    if document.words.isdisjoint(_JOINTS | {"before"}):
        return frozenset()
    telling = [verb for verb, kind in tasks.items() if kind == "informing"]
    return frozenset(i for verb in telling for i in reported(document, tasks.keys(), verb))


def orders_behind(document: Document, tasks: Mapping[int, str]) -> Iterator[int]:
    """The verb of every order that "and" joins to what somebody is told of how something is, and that nothing told can
    go on with: "tell him I'm busy *and take his number*"; not "tell him I'll wait and do that"."""
    tokens = document.tokens
    telling = (verb for verb, kind in tasks.items() if kind == "informing" and tokens[verb].lemma in _TELLING)
    for verb in telling:
        stop = _clause_end(document, verb + 1)
        clause = tokens[verb + 1 : stop]
        finite = [t for t in clause if t.tag in FINITE or t.lower in _CONTRACTED]
        is_state = len(finite) == 1 and finite[0].lower in _BEING and _states(document, range(verb + 1, stop))
        if not is_state or not _is_joint(document, stop) or any(t.tag in ("VB", "TO", "MD") for t in clause):
            continue
        order = tokens[stop + 1]
        is_order = order.tag == "VB" and order.lower == order.lemma and order.lower not in _NEEDING | _STATING
        has_thing = any(t.tag in ("DT", "PRP$", "PRP", "NN", "NNS") for t in tokens[order.i + 1 : order.i + 3])
        if is_order and has_thing and order.i not in tasks:
            yield order.i


def with_reports(
    document: Document, tasks: Mapping[int, str], arguments: Sequence[FoundArgument], verb: int
) -> list[FoundArgument]:
    """The arguments with the message of a verb of telling as a whole, to the end of a clause that it is cut off in."""
    message = next((a for a in arguments if (a.type, a.owner) == ("message", verb) and a.tokens.start > verb), None)
    if message is None:
        return list(arguments)
    start, stop = message.tokens.start, message.tokens.stop
    order = next((i for i in message.tokens[2:] if i in tasks and document.tokens[i - 1].lower in _JOINTS), None)
    if order is not None and _states(document, range(verb + 1, order - 1)):
        rest = [a for a in arguments if a is not message]
        thing = next((chunk for chunk in noun_chunks(document) if chunk.start == order + 1), range(0))
        is_bare = bool(thing) and not any(set(a.tokens) & set(thing) for a in rest)
        own = [FoundArgument("object", order, thing, CERTAIN)] if is_bare else []
        return [*rest, replace(message, tokens=range(start, order - 1)), *own]
    cut = next((i for i in message.tokens[1:][-2:] if document.tokens[i].lower in _TIMES), stop)
    if cut < stop and (cut + 1 == stop or document.tokens[stop - 1].lower in _SUBJECTS):  # "... before he"
        end = _clause_end(document, stop)
        stop = cut if any(i in tasks for i in range(cut, end)) else end
    more = reported(document, tasks.keys(), verb)
    if more and start < more.start <= stop + 1:
        stop = max(stop, more.stop)
    whole = range(start, stop)
    if any(i in tasks for i in whole):
        return list(arguments)
    rest = [a for a in arguments if a is not message and set(a.tokens).isdisjoint(whole)]
    return [*rest, replace(message, tokens=whole)]


def with_next_told(document: Document, arguments: Sequence[FoundArgument], verb: int) -> list[FoundArgument]:
    """The arguments with who is told something else behind an "and", and what, as a recipient and a message of their
    own: "tell Tom his phone's here and *Anna* *hers is on the desk*"; not "... and Anna is in the hall"."""
    own = {a.type: a for a in arguments if a.owner == verb}
    message, first = own.get("message"), own.get("recipient")
    if message is None or first is None or not verb < first.tokens.start < message.tokens.start:
        return list(arguments)
    at = next((i for i in message.tokens[2:-3] if _is_told_next(document, i, message.tokens.stop)), None)
    if at is None or sum((a.owner, a.type) == (verb, "message") for a in arguments) > 1:
        return list(arguments)
    rest = [a for a in arguments if a is not message]
    return [
        *rest,
        replace(message, tokens=range(message.tokens.start, at)),
        FoundArgument("recipient", verb, range(at + 1, at + 2), CERTAIN),
        FoundArgument("message", verb, range(at + 2, message.tokens.stop), CERTAIN),
    ]


def _is_told_next(document: Document, at: int, stop: int) -> bool:
    """Whether an "and" at a token leads somebody, and right behind them a clause or a request."""
    joint, whom, begin, second = document.tokens[at : at + 4]
    is_named = whom.tag == "NNP" and whom.text[:1].isupper()
    if joint.lower not in _JOINTS or not (is_named or whom.lemma.lower() in PERSON_NOUNS):
        return False
    if begin.lower == "to":
        return second.tag in ("VB", "VBP")
    behind = document.tokens[at + 3 : stop]
    is_clause = any(token.tag in FINITE or token.lower in _CONTRACTED for token in behind)
    return begin.lower in _TOLD_NEXT and is_clause


def without_times(document: Document, arguments: Sequence[FoundArgument], verb: int) -> list[FoundArgument]:
    """The arguments of a verb of telling without a time alone as its message ("remind me *tonight*"), and with a "this"
    that it tells as the message ("state *this* to Ann")."""
    is_said = document.tokens[verb].lemma == "say"  # "say *good night*"
    kept = [
        a for a in arguments if is_said or (a.owner, a.type) != (verb, "message") or not _is_time(document, a.tokens)
    ]
    if any((a.owner, a.type) == (verb, "message") for a in kept):
        return kept
    words = [token.lower for token in document.tokens[verb + 2 : verb + 4]]
    is_so = words[:1] == ["so"] and (words[1:] == [] or words[1] in MARKS)  # "tell me so, because ..."
    at = verb + 2 if is_so else verb + 1
    if (is_so or _is_pointing(document, at)) and not any(at in a.tokens for a in kept):
        return [*kept, FoundArgument("message", verb, range(at, at + 1), CERTAIN)]
    return [
        replace(a, type="message")
        if (a.owner, a.type) == (verb, "object") and {document.tokens[i].lower for i in a.tokens} <= _SAID
        else a
        for a in kept
    ]


def _is_pointing(document: Document, at: int) -> bool:
    """Whether a "this" stands alone at a token, as no part of a phrase or a clause."""
    tokens = document.tokens
    if at >= len(tokens) or tokens[at].lower not in ("this", "that"):
        return False
    return at + 1 == len(tokens) or tokens[at + 1].pos in ("ADV", "ADP", "PUNCT", "CCONJ")


def _is_time(document: Document, words: range) -> bool:
    said = {document.tokens[i].lower for i in words}
    is_date = any(document.tokens[i].tag == "POS" for i in words)  # "tomorrow's date"
    return not is_date and bool(said & _WHEN) and said <= _WHEN | _AROUND_TIMES


def _clause_end(document: Document, start: int) -> int:
    """Where the clause that a token is in ends: at a mark or a joint."""
    tokens, sentences = document.tokens, document.sentences
    behind = range(start, len(tokens))
    ends = (i for i in behind if tokens[i].lower in _CLAUSE_ENDS or sentences[i] != sentences[start])
    return next(ends, len(tokens))


def _is_joint(document: Document, at: int) -> bool:
    return at + 1 < len(document) and document.tokens[at].lower in _JOINTS


def _request(document: Document, clause: range) -> range:
    """From where on a clause tells what somebody is asked to do ("to *feed the cat*", "if he *could feed the cat*");
    empty where it is no request."""
    tokens = document.tokens
    for i in clause[1:-1]:
        word = tokens[i].lower
        if word == "to" and tokens[i + 1].tag in ("VB", "VBP"):
            return range(i + 1, clause.stop)
        if word in ("if", "whether") and i + 2 < clause.stop and tokens[i + 2].lower in _ABLE:
            return range(i + 2, clause.stop)
    return range(0)


def _is_of_request(document: Document, request: range, at: int) -> bool:
    """Whether an order takes up the thing of the request before: "to get *the bikes* and *lock them*"."""
    tokens = document.tokens
    particles = [token.lower for token in tokens[at + 1 : at + 2] if token.tag in ("RP", "RB")]
    behind = tokens[at + 1 + len(particles) : at + 2 + len(particles)]
    word = behind[0].lower if behind else ""
    rest = {token.lower for token in tokens[at + 2 + len(particles) : _clause_end(document, at)]}
    if tokens[at].lower != tokens[at].lemma or rest & _OTHERWISE_DONE:
        return False  # "... and give them to him", "... and bring it if it's dry"
    if _is_greeting(document, at):
        return True
    if tokens[request.start].lemma in _GOING and tokens[at].tag in ("VB", "VBP"):
        return True  # "ask Tom to run next door *and borrow some eggs*"
    if word not in _TAKEN_UP:
        return False
    named = [tokens[chunk.stop - 1].tag for chunk in noun_chunks(document) if set(chunk) & set(request)]
    return any(tag in _TAKEN_UP[word] for tag in named)


def _is_greeting(document: Document, at: int) -> bool:
    """Whether an order is to say no more than what is said out of courtesy, which who is asked to come, go or do
    something says: "ask Tom to come down *and say goodbye*", not "... and say that supper is ready"."""
    said = document.tokens[at + 1 : _clause_end(document, at + 1)]
    words = {token.lower for token in said}
    is_told = any(token.tag in FINITE - {"VBP"} or token.lower in _CONTRACTED for token in said)
    return document.tokens[at].lower == "say" and not words.isdisjoint(_COURTESIES) and not is_told


def _is_theirs(document: Document, at: int) -> bool:
    """Whether a clause tells when those act who are spoken of: "before *he leaves*"."""
    tokens = document.tokens
    return at + 1 < len(tokens) and tokens[at].lower in _THEY and tokens[at + 1].tag in FINITE


def _states(document: Document, clause: range) -> bool:
    """Whether a clause behind a verb of telling states something: neither a question nor a request."""
    words = [document.tokens[i] for i in clause]
    is_asked = any(token.lower in _ASKING for token in words)
    is_finite = any(token.tag in FINITE or token.lower in _CONTRACTED for token in words[1:])
    return is_finite and not is_asked and not _request(document, clause)


def _is_statement(document: Document, at: int) -> bool:
    """Whether a clause has a subject of its own and says how something is, not what is needed."""
    tokens = document.tokens
    if at + 1 >= len(tokens):
        return False
    first = tokens[at]
    if first.lower in _TYPED_IS:
        behind, further = (*tokens[at + 1 : at + 3], first)[:2]
        return behind.pos not in ("NOUN", "PROPN") and (behind.tag, further.pos) != ("JJ", "NOUN")
    if first.lower in _SUBJECTS:
        verb = at + 1
    else:
        chunk = next((chunk for chunk in noun_chunks(document) if chunk.start == at), range(0))
        if not chunk or not (first.tag in ("PRP$", "NNP") or first.lower in _DEFINITE):
            return False
        verb = chunk.stop
        if verb < len(tokens) and tokens[verb].tag != "MD" and tokens[verb].lower == tokens[verb].lemma:
            return False  # "and the door shut"
    while verb < len(tokens) and tokens[verb].tag == "RB":
        verb += 1
    is_finite = verb < len(tokens) and (tokens[verb].tag in FINITE or tokens[verb].lower in _CONTRACTED)
    return is_finite and not any(token.lemma in _NEEDING for token in tokens[verb : verb + 2])
