"""The retelling: an instruction with its alternatives told in full and behind their conditions, as models know them.

"Bring me a pen, or a pencil if there is none" is told as "bring me a pen, or if there is none, bring me a pencil", and
"wash the mug and do the same with the plate" as "wash the mug and wash the plate": its words are the instruction's own,
some of them twice and some in another place.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from decomplex_bt.instruction import Argument, Instruction, Task
from decomplex_bt.understanding.document import ENDS, MARKS, Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.gazetteer import PARTICLES
from decomplex_bt.understanding.references.chunks import head_of
from decomplex_bt.understanding.references.phrases import is_pronoun
from decomplex_bt.understanding.remainder import COMMA, STOP, Remainder, Told, told
from decomplex_bt.understanding.rules.ellipses.alternatives import Alternative, alternatives
from decomplex_bt.understanding.rules.ellipses.likewise import Likewise, likewise, so_does
from decomplex_bt.understanding.rules.orders.needs import NEEDING
from decomplex_bt.understanding.vocabulary import ANIMALS, ONES, PERSON_NOUNS, PLACE_ADVERBS, PREPOSITIONS

_OPENING = frozenset(("if", "only_if", "unless"))
_TURNING = frozenset(("else", "fail"))
_GOVERNING = _OPENING | _TURNING | {"when", "so"}
_JOINING = frozenset(("and", "but", "or", ","))
_ENDING = frozenset(("source", "goal", "location", "recipient"))
"""Types of arguments that tell from where, where to or to whom."""
_WHEREABOUTS = frozenset(("location", "source"))
_WHERE = frozenset("from in on under at behind beside by off near inside above below".split())
"""What tells of a thing where it is: "the one *from* the shelf" is not from where the first one was."""
_FROM = frozenset(("from", "off", "out"))
_NOMINAL = frozenset(("DET", "ADJ", "NOUN", "PROPN", "NUM"))
_NOUNS = frozenset(("NOUN", "PROPN", "NUM", "PRON"))
_LEADING = frozenset(("DET", "ADJ", "NUM", "PRON"))
_DESCRIBING = frozenset(("det", "amod", "poss", "nummod"))
_INDEFINITE = frozenset(("a", "an", "some"))
_DETERMINING = _INDEFINITE | {"the"}
_APPOSING = frozenset((",", ":", "-", "–", "—"))
_POINTING = frozenset(("this", "that", "these", "those"))
_SPEAKING = frozenset(("i", "we"))
_SERVING = frozenset(("do", "be", "work", "'s"))


@dataclass(frozen=True, slots=True)
class Retelling:
    """`told`: the whole; `verbs`: of the orders that the text leaves unsaid, where the word stands that carries each,
    with the place of the verb that it has; `merged`: how many tasks as it was read are told as part of another."""

    told: Remainder
    verbs: Mapping[int, int]
    merged: int


@dataclass(frozen=True, slots=True)
class _Specified:
    """Tokens: the `kind` of thing that an order names, and behind a `mark` the `words` that tell which one is meant."""

    kind: range
    mark: int
    words: range


def retold(observed: Observed, instruction: Instruction) -> Retelling | None:
    """The text of an instruction that has alternatives without a verb or ahead of their condition, told in full; None
    where it has none. `instruction`: how the text was read as it stands."""
    document = observed.document
    read = {document.indices(task.span).start: task for task in instruction.tasks}
    tasks = {i: task for i, task in read.items() if task.type == "check_state" or not _is_unsaid(observed, i)}
    insertions: dict[int, list[Told]] = defaultdict(list)
    moved: set[int] = set()
    verbs: dict[int, int] = {}
    praises: list[range] = []
    same = list(likewise(document))
    alike = {i for found in same for i in (*found.words, *(() if found.is_bare else found.other))}
    specified = list(_specified(observed, tasks))
    marks = {found.mark for found in specified}
    for found in alternatives(observed, {i: task.type for i, task in tasks.items()}):
        place, end = found.tokens.start, found.tokens.stop
        if place in alike:
            continue
        order = None if found.is_verbal else _antecedent(observed, tasks, found, marks)
        if order is not None and found.praise and not _serves(observed, tasks[order], found.tokens):
            continue
        words = None if order is None else _repeated(observed, tasks[order], found.tokens, place)
        if words is None and not found.is_verbal:
            continue
        condition = [*found.condition, COMMA] if found.condition else []
        moved.update((*found.condition, *found.praise))
        praises.append(found.praise)
        insertions[place] += map(Told, condition if condition or not found.is_run_on else [COMMA])
        if order is None or words is None:
            continue
        carrier = _carrier(document, found)
        verbs[document.tokens[carrier].start] = document.tokens[order].start
        insertions[place] += [Told(i, place, carrier if i == order else None) for i in words[0]]
        insertions[end] += [Told(i, place) for i in words[1]]
        if found.mark or found.own:
            moved.update(found.mark)
            insertions[found.mark.start].append(Told(COMMA if found.is_reminder else STOP))
        stop = max(end, found.condition.stop, found.own.stop)
        if _is_whole(observed, stop, order):
            moved.add(stop)
            insertions[stop].append(Told(STOP))
    for one in same:
        said = _said_of_other(observed, tasks, one)
        if said is None:
            continue
        order, ahead, behind = said
        verbs[document.tokens[one.carrier].start] = document.tokens[order].start
        moved.update(one.words)
        carriers = {order: one.carrier}
        other = one.other if one.is_bare else ()
        start, stop = (one.words.stop,) * 2 if one.is_bare else (one.other.start, one.other.stop)
        insertions[start] += [Told(i, one.carrier, carriers.get(i)) for i in (*ahead, *other)]
        insertions[stop] += [Told(i, one.carrier, carriers.get(i)) for i in behind]
    for which in specified:
        moved.update((*which.kind, which.mark, *which.words))
        insertions[which.kind.start] += _with_noun(document, which)
    if not insertions:
        return None
    sequence = [
        word
        for i in range(len(document) + 1)
        for word in (*insertions.get(i, ()), *([Told(i)] if i < len(document) and i not in moved else ()))
    ]
    merged = sum(any(i in words for words in praises) for i in read)
    merged += sum(i in which.words for i in read.keys() - tasks.keys() for which in specified)
    return Retelling(told(document, sequence), verbs, merged)


def _is_unsaid(observed: Observed, token: int) -> bool:
    """Whether a word that was read as a task stands for an unsaid verb: a preposition ("otherwise *on* the desk"), a
    particle, a number, or the noun of a phrase ("otherwise *a fig*", "otherwise *coffee*")."""
    document, tokens = observed.document, observed.document.tokens
    if tokens[token].lower in PREPOSITIONS | PARTICLES and tokens[token].pos in ("ADP", "ADV"):
        return True
    first = min((i for i in document.children[token] if i < token and tokens[i].dep in _DESCRIBING), default=token)
    # not "failing *which*, light it", "in either *case* report to me"
    is_phrase = all(word.pos in _LEADING and not word.tag.startswith("W") for word in tokens[first:token])
    is_last = token + 1 == len(tokens) or tokens[token + 1].text in MARKS
    is_bare = tokens[token].pos == "NOUN" and is_last and not observed.senses[token]
    is_named = tokens[token].pos in _NOUNS and first < token and is_phrase
    return tokens[token].pos == "NUM" or is_bare or is_named


def _specified(observed: Observed, tasks: Mapping[int, Task]) -> Iterator[_Specified]:
    """Every object of which only the kind is said and, behind a mark, which one: "bring me *a towel*, the big one if
    it's dry", told as "bring me the big towel if it's dry"; a full stop is such a mark, too, where the sentence ends
    with that order."""
    document, tokens = observed.document, observed.document.tokens
    openings = sorted(cue.first for cue in observed.cues if cue.name in _OPENING)
    for verb, task in tasks.items():
        for kind in (document.indices(a.span) for a in task.arguments if a.type == "object" and a.span is not None):
            if task.type == "check_state" or verb > kind.start or tokens[kind.start].lower not in _DETERMINING:
                continue
            mark = next((t.i for t in tokens[kind.stop :] if t.text in MARKS), len(tokens) - 1)
            end = next((t.i for t in tokens[mark + 1 :] if t.text in ENDS), len(tokens))
            words = range(mark + 1, next((i for i in openings if mark < i < end), end))
            is_apposed = tokens[mark].text == "." or (tokens[mark].text in _APPOSING and mark == kind.stop)
            is_last = not any(kind.stop <= other < words.stop for other in tasks)
            is_bare = head_of(document, kind) == kind.stop - 1  # not "the cup with the flowers, the tall one"
            if is_apposed and is_last and is_bare and _tells_which(observed, kind, words, is_whole=words.stop == end):
                yield _Specified(kind, mark, words)


def _tells_which(observed: Observed, kind: range, words: range, *, is_whole: bool) -> bool:
    """Whether words, which are the rest of a sentence or stand ahead of a condition, name one of a kind: "the big one",
    "the one with a lid", or "juice" where an "otherwise" follows. "The big one" of "the towels" may be an exception."""
    document, sentences = observed.document, observed.document.sentences
    said = document.tokens[words.start : words.stop]
    if not said or any(token.text in MARKS for token in said):
        return False
    is_indefinite = document.tokens[kind.start].lower in _INDEFINITE
    one = next((i for i, token in enumerate(said) if token.lower in ONES), None)
    if said[0].lower == "the" and one is not None and (one + 1 == len(said) or said[one + 1].pos == "ADP"):
        return is_indefinite or document.tokens[head_of(document, kind)].tag in ("NN", "NNP")
    turns = (cue.first for cue in observed.cues if cue.name in _TURNING and cue.first > words.stop)
    is_chosen = not is_whole and any(sentences[turn] == sentences[words.start] for turn in turns)
    is_noun = said[-1].pos in ("NOUN", "PROPN") and all(token.pos in _NOMINAL for token in said[:-1])
    return is_indefinite and is_chosen and is_noun


def _with_noun(document: Document, which: _Specified) -> Iterator[Told]:
    """The words that tell which one of a kind is meant, with its noun for "one"."""
    head = head_of(document, which.kind)
    noun = [
        i for i in which.kind if i == head or (document.tokens[i].dep == "compound" and document.tokens[i].head == head)
    ]
    for i in which.words:
        is_one = document.tokens[i].lower in ONES
        yield from (Told(n, i, i) for n in noun) if is_one else (Told(i),)


def _carrier(document: Document, found: Alternative) -> int:
    """The word that carries an unsaid verb: that by which the phrase serves ("a fig will *do*"), else its preposition,
    else its head."""
    for token in (document.tokens[i] for i in found.praise):
        if not _SERVING.isdisjoint((token.lemma, token.lower)):
            return token.i
    words = found.tokens
    return words.start if document.tokens[words.start].lower in PREPOSITIONS else head_of(document, words)


def _antecedent(
    observed: Observed, tasks: Mapping[int, Task], found: Alternative, marks: Collection[int]
) -> int | None:
    """The order that an alternative without a verb repeats: the last one before it that is no condition, in its
    sentence or, where that begins with its condition or an "otherwise" or, behind one of the `marks`, with what tells
    which thing is meant, in one before.

    A search of one place, otherwise another, is one search.
    """
    sentences, place = observed.document.sentences, found.tokens.start
    openings = [cue.last for cue in observed.cues if cue.name in _OPENING]
    orders = _orders_before(observed, tasks, place)
    said = observed.document.tokens[place : found.tokens.stop]
    is_vague = any(token.pos == "ADV" and token.lower not in PLACE_ADVERBS for token in said)
    if not orders or (is_vague and not _is_particle(observed.document, found.tokens)):
        return None  # "the charger's somewhere in here" names nothing to be plugged in
    last = orders[-1]
    leading = [cue.first for cue in observed.cues if cue.name in _OPENING | _TURNING]
    begins = (i for i in leading if sentences[i] == sentences[place] and _is_beginning(observed.document, i))
    if found.is_reminder:
        is_near = sentences[last] + 1 >= sentences[place]
        return last if is_near and _is_alike(observed, tasks[last], found.tokens) else None
    is_of_question = bool(found.praise) and sentences[last] + 2 == sentences[place]  # "No luck? Then the radio will do"
    is_added = sentences[last] + 1 == sentences[place] and _is_afterthought(observed.document, found)
    is_added |= any(last < mark < place and sentences[mark] + 1 == sentences[place] for mark in marks)
    is_near = sentences[last] == sentences[place] or is_of_question or is_added
    if not is_near and next(begins, None) is None:
        return None
    is_conditional = bool(found.condition) or any(last < i < place for i in openings)
    return last if is_conditional or tasks[last].type != "searching" else None


def _is_afterthought(document: Document, found: Alternative) -> bool:
    """Whether an "or" or "and" that begins a sentence adds an alternative with its condition to the order before:
    "Put it on the table. *Or on the shelf*, if the table's full"."""
    joint = found.tokens.start - 1
    is_joined = joint > 0 and document.tokens[joint].lower in ("or", "and") and document.tokens[joint - 1].text in MARKS
    return is_joined and bool(found.condition or found.own)


def _orders_before(observed: Observed, tasks: Mapping[int, Task], place: int) -> list[int]:
    """The orders before a token that are no conditions."""
    openings = [cue.last for cue in observed.cues if cue.name in _OPENING]
    conditions = {min((i for i in tasks if i > last), default=-1) for last in openings}
    return [i for i, task in tasks.items() if i < place and task.type != "check_state" and i not in conditions]


def _said_of_other(
    observed: Observed, tasks: Mapping[int, Task], found: Likewise
) -> tuple[int, Sequence[int], Sequence[int]] | None:
    """The order before that is said of something else by "the same", with its tokens to be said again ahead of that and
    behind it; None where there is none. A place that it does not have yet is added to it; another thing need not be
    where the first was."""
    document, place = observed.document, found.words.start
    order = next(reversed(_orders_before(observed, tasks, place)), None)
    if order is None or document.sentences[place] > document.sentences[order] + 1:
        return None
    if found in so_does(document):
        needing = list(range(order - 1, order + 1))
        return (order, [], needing) if document.tokens[order - 1].lower in NEEDING else None
    task, first = tasks[order], document.tokens[found.other.start]
    is_adverb = first.lower in PLACE_ADVERBS
    is_place = is_adverb or first.lower in PREPOSITIONS
    if is_adverb or not is_place:
        task = replace(task, arguments=tuple(a for a in task.arguments if a.type not in _WHEREABOUTS))
    thing = None if is_place else _done_to(document, task, _end_of_order(observed, order, place), found)
    words = None if is_adverb else _repeated(observed, task, found.other, place, thing=thing)
    if words is None and is_place:
        until = _end_of_order(observed, order, place)
        own = {i for _, tokens in _own_phrases(document, task, until) for i in tokens}
        words = sorted({order, *_particles(document, order, until), *own}), []
    return None if words is None else (order, *words)


def _done_to(document: Document, order: Task, until: int, found: Likewise) -> str:
    """The type of the argument of an order in whose place stands what "the same" is done with: of that of a case the
    one that takes up what its own case is of ("if Lea is up, bring *her* tea. If Kim is up, do the same")."""
    own = _own_phrases(document, order, until) if found.is_bare else ()
    taken_up = (a.type for a, tokens in own if is_pronoun(document, tokens))
    return next((kind for kind in taken_up if kind == "recipient"), "object")


def _is_alike(observed: Observed, order: Task, named: range) -> bool:
    """Whether what is not to be forgotten may be meant by an order beside what it names: no animal's or person's
    things ("walk the dog and don't forget *the bags*"), nothing of another kind or said before."""
    document = observed.document
    heads = [head_of(document, document.indices(a.span)) for a in order.arguments if a.type == "object" and a.span]
    one, other = document.tokens[heads[-1]] if heads else None, document.tokens[head_of(document, named)]
    living = PERSON_NOUNS | ANIMALS
    if one is None or (one.lemma in living) != (other.lemma in living):
        return False
    kinds = {observed.gazetteer.category(one.lemma), observed.gazetteer.category(other.lemma)}
    return one.lemma != other.lemma and len(kinds - {""}) < 2


def _serves(observed: Observed, order: Task, named: range) -> bool:
    """Whether what is said to do as well can have done to it what is done to the thing of an order: a blanket is as
    good as a heater, but none turns it on."""
    document = observed.document
    if order.type != "change_state":
        return document.tokens[document.indices(order.span).start].lemma != "check"
    things = [head_of(document, document.indices(a.span)) for a in order.arguments if a.type == "object" and a.span]
    kinds = {observed.gazetteer.category(document.tokens[i].lemma) for i in (*things, head_of(document, named))}
    return len(kinds) == 1


def _is_whole(observed: Observed, stop: int, order: int) -> bool:
    """Whether what follows a comma after an alternative without a verb goes with the order that has it ("tea, or coffee
    if there is none, *and close the door*"): where that hangs on nothing, it is a sentence of its own."""
    tokens, sentences = observed.document.tokens, observed.document.sentences
    if stop + 1 >= len(tokens) or tokens[stop].text != "," or tokens[stop + 1].lower not in ("and", "then"):
        return False
    return not any(
        c.name in _GOVERNING and c.first < order and sentences[c.first] == sentences[order] for c in observed.cues
    )


def _is_beginning(document: Document, i: int) -> bool:
    """Whether a sentence begins here, but for words that join it to the last one."""
    while i > 0 and document.tokens[i - 1].lower in _JOINING and document.sentences[i - 1] == document.sentences[i]:
        i -= 1
    return i == 0 or document.sentences[i - 1] != document.sentences[i]


def _repeated(
    observed: Observed, task: Task, words: range, place: int, *, thing: str | None = None
) -> tuple[Sequence[int], Sequence[int]] | None:
    """The tokens of an order to be said again ahead of an alternative and behind it; None where it has nothing of its
    kind. `thing`: the type of the argument in whose place the words stand, if it is known."""
    document = observed.document
    verb = document.indices(task.span).start
    until = _end_of_order(observed, verb, place)
    own = list(_own_phrases(document, task, until))
    particles = _particles(document, verb, until)
    if _is_particle(document, words):
        states = [tokens for _, tokens in own if _is_particle(document, tokens)]
        replaced = next(reversed([*(range(i, i + 1) for i in particles), *states]), None)
    elif thing is not None:
        replaced = next((tokens for argument, tokens in own if argument.type == thing), None)
    elif len(words) == 1 and document.tokens[words.start].pos == "ADJ":
        replaced = _kind(document, own)
    else:
        replaced = _replaced(observed, own, words) or _unread(document, own, range(verb + 1, until), words)
    if replaced is None:
        return None
    said = {verb, *particles, *_wishing(document, verb)}.difference(replaced)
    places = _WHEREABOUTS if any(document.tokens[i].lower in _WHERE for i in words[1:]) else frozenset()
    said.update(i for argument, tokens in own if tokens != replaced and argument.type not in places for i in tokens)
    said.update(range(verb + 1, replaced.start))  # what stands between, be it found or not: "bring *me* the orange"
    ahead, behind = sorted(i for i in said if i < replaced.start), sorted(i for i in said if i >= replaced.stop)
    is_led = document.tokens[words.start].lower in PREPOSITIONS
    if document.tokens[replaced.start].lower in PREPOSITIONS | {"for"} and len(replaced) > 1 and not is_led:
        ahead.append(replaced.start)
    return ahead, behind


def _kind(document: Document, own: Sequence[tuple[Argument, range]]) -> range | None:
    """The one adjective of what an order names, in whose place another kind stands: "a *green* mug"."""
    named = next((tokens for argument, tokens in own if argument.type == "object"), range(0))
    kinds = [i for i in named if document.tokens[i].pos == "ADJ" and document.tokens[i].dep == "amod"]
    return range(kinds[0], kinds[0] + 1) if len(kinds) == 1 else None


def _unread(document: Document, own: Sequence[tuple[Argument, range]], order: range, words: range) -> range | None:
    """The words of an order behind its arguments that none of them has, where they begin with the preposition of an
    alternative: "set the table *for four*, or for five if Ann comes"."""
    taken = {i for _, tokens in own for i in tokens}
    lead = document.tokens[words.start].lower
    starts = [i for i in order if document.tokens[i].lower == lead and i not in taken]
    if len(words) == 1 or lead not in PREPOSITIONS | {"for"} or len(starts) != 1:
        return None
    rest = _up_to(document, range(starts[0], order.stop), order.stop)
    is_last = rest.start > max(taken, default=-1)
    return rest if is_last and len(rest) > 1 else None


def _end_of_order(observed: Observed, verb: int, place: int) -> int:
    """Where an order's own words end that something behind it repeats: at a condition, at the latest at that."""
    openings = (cue.first for cue in observed.cues if cue.name in _OPENING and cue.first > verb)
    return min(next(openings, place), place)


def _own_phrases(document: Document, task: Task, until: int) -> Iterator[tuple[Argument, range]]:
    """The arguments behind an order's verb, with their tokens, up to another token."""
    verb = document.indices(task.span).start
    for argument in task.arguments:
        if argument.span is None or argument.type == "manner":
            continue
        tokens = _up_to(document, document.indices(argument.span), until)
        if verb < tokens.start < until:
            yield argument, tokens


def _particles(document: Document, verb: int, until: int) -> list[int]:
    """The particles of a verb: "turn it *off*"."""
    behind = (document.tokens[i] for i in document.children[verb] if verb < i < until)
    return [t.i for t in behind if t.dep == "prt" or (t.dep == "advmod" and t.lower in PARTICLES)]


def _is_particle(document: Document, words: range) -> bool:
    return len(words) == 1 and document.tokens[words.start].lower in PARTICLES


def _wishing(document: Document, verb: int) -> list[int]:
    """What makes a verb a wish: "*I'd* love", "*could I* have"."""
    ahead = [i for i in document.children[verb] if i < verb and document.tokens[i].dep in ("nsubj", "aux")]
    return ahead if any(document.tokens[i].lower in _SPEAKING for i in ahead) else []


def _is_plain(document: Document, words: range) -> bool:
    """Whether a pronoun points at nothing by itself: "it", not "that", which another thing may take the place of."""
    return is_pronoun(document, words) and document.tokens[words.start].lower not in _POINTING


def _up_to(document: Document, tokens: range, stop: int) -> range:
    """The tokens before another one, without what joins them to it: "the orange*, or* the apple"."""
    last = min(tokens.stop, stop)
    while last > tokens.start + 1 and document.tokens[last - 1].lower in _JOINING:
        last -= 1
    return range(tokens.start, last)


def _replaced(observed: Observed, own: Sequence[tuple[Argument, range]], words: range) -> range | None:
    """The argument in whose place the words of an alternative stand."""
    document = observed.document
    first, head = document.tokens[words.start], document.tokens[head_of(document, words)]
    if first.lower in PREPOSITIONS and len(words) > 1:
        alike = [tokens for _, tokens in own if document.tokens[tokens.start].lower == first.lower]
        ending = [
            tokens
            for argument, tokens in own
            if argument.type in _ENDING and (argument.type == "source") == (first.lower in _FROM)
        ]
        return next(reversed(alike or ending), None)
    by_type = {argument.type: tokens for argument, tokens in own}
    if first.lower in PLACE_ADVERBS and len(words) == 1:
        return next((tokens for argument, tokens in reversed(own) if argument.type in _ENDING), None)
    is_person = head.lemma in PERSON_NOUNS or (head.pos == "PROPN" and head.text[:1].isupper() and len(words) == 1)
    thing = by_type.get("object")
    if is_person and "recipient" in by_type:
        return by_type["recipient"]
    ending = [tokens for argument, tokens in own if argument.type in _ENDING]
    category = observed.gazetteer.category(head.lemma)
    is_place = category in ("room", "furniture") or (
        not category and thing is not None and _is_plain(document, thing) and "recipient" not in by_type
    )
    return ending[-1] if ending and (is_place or thing is None) else thing
