"""Reading the clause around each task: the cues that open it, its negation, the state it tests, where it ends."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace

from decomplex_bt.domain.clauses import WEATHER
from decomplex_bt.understanding.control_flow.arcs import Wording
from decomplex_bt.understanding.control_flow.clause import AROUND, FINDING_OUT, Clause, MarkedTask
from decomplex_bt.understanding.control_flow.denials import WILLING, is_answer, negations
from decomplex_bt.understanding.cues import ASKING_LEMMAS, GOVERNING, OPPOSITES, PRO_FORMS, Cue, normal_form
from decomplex_bt.understanding.document import Document, Token
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.phrases import PERSON_NOUNS, degree_asked, head_of, nobody
from decomplex_bt.understanding.rules.prohibitions import is_forbidden, lifts

_ITS = frozenset("it them 'em em him her this that these those".split())
_PERSONS = frozenset(("he", "she", "they"))
_ECHOING = frozenset("is are am was were does do did has have had can will would".split())
_DENYING = frozenset(("not", "n't", "n\u2019t"))
_WHETHER = frozenset("if whether does do is are has have can could would will".split())
_COVERING = frozenset(("if", "only_if", "unless", "when"))
_IT = ("this", "that", "it")
_ALL_OF_IT = frozenset((*(f"all {it}" for it in _IT), *(f"all of {it}" for it in _IT), *(f"{it} all" for it in _IT)))
_NONE_OF_IT = frozenset(
    (
        *(f"none of {it}" for it in _IT), *(f"skip all {it}" for it in _IT), *(f"skip all of {it}" for it in _IT),
        *(f"there 's no need for any of {it}" for it in _IT), *(f"do n't do any of {it}" for it in _IT),
        *(f"do n't bother with any of {it}" for it in _IT), "the whole thing 's off", "it 's all off", "it is all off",
    )
)  # fmt: skip
_STARTING = frozenset((".", ",", ";", ":", "!", "?", "-", "–", "—", "and", "but", "oh", "though"))
_PUNCTUATION = frozenset((",", ".", ";", ":", "?", "!", "-", "–", "—", "...", "…", "(", ")"))
_INNER = frozenset(("still", "not", "can", "there", "also"))
_OTHER_ANSWER = {"yes": "no", "no": "yes"}
_OPENERS = frozenset(("if", "when"))
_LEAVING = tuple(
    tuple(phrase.split())
    for phrase in (
        "leave it", "leave that", "leave them", "leave him", "leave her", "skip it", "skip that", "skip them",
        "forget it", "forget about it", "forget that", "never mind", "nevermind", "do not", "dont", "do not bother",
        "dont bother", "do not do it", "do not do that", "hold off", "let it be", "let them be", "do it later",
        "do that later", "give it a miss", "no need",
    )
)  # fmt: skip
"""What says that something is not to be done, in the normal form of cues."""
_TURNING_TO = frozenset("now anyway finally lastly meanwhile besides".split())
_LEADING_IN = frozenset("and but so right okay ok well oh , please".split())
_OTHER = frozenset("another other different separate unrelated".split())
_MATTERS = frozenset("note matter subject topic".split())
_BEFORE_MATTER = frozenset("on to a an and but then now so for completely entirely quite".split())
"""What may stand before "another matter" where it tells only that one follows."""
_AFTER_LEAVING = frozenset("till until for as alone be where there then to and just bother".split())
_ONCE = frozenset(("after", "when"))
_PERFECT = frozenset("have 've \u2019ve had 'd \u2019d ve".split())
_DONE_SO_FAR = _PERFECT | frozenset("just already both all finally".split())
_WAYS = frozenset(("back", "home", "out", "again"))
_NUMBERS = {"it": "one", "they": "many", "them": "many", "those": "many", "these": "many"}
_OURS = frozenset(("we", "you", "i"))
_LEFT = frozenset(("they", "it", "those"))
_ADDED = frozenset("if all already now completely just still and but or".split())
_BEING = frozenset(("be", "'s", "'re", "s"))
_DEFINITE = frozenset("the my your his her our their this that these those".split())
_NEAR = 3
"""Within so many words behind an "if not" that no mark ends its order begins: "if not please just wake him"."""
_ABLE = frozenset("can could able unable manage".split())
_BESIDE_ABLE = frozenset("you is to still possibly actually somehow even".split())
_OPEN_QUESTIONS = frozenset("what who whose which where when why".split())
_DEGREES = frozenset(("ADJ", "ADV"))
"""How full something is a state answers, but neither how it is nor how many there are."""
_AMOUNTS = (["how", "many"], ["how", "much"])
_OTHERWISE = frozenset(("otherwise", "or", "alternatively"))
_COORDINATORS = frozenset(("and", "but", "or"))
_IS = frozenset(("is", "are", "'s", "\u2019s", "be"))
_JOINING = frozenset(("and", "or", "of", "&"))
_REFERRING = frozenset("it them that this those these one ones there he she her him they both some any em".split())


def clauses_of(observed: Observed, tasks: Sequence[MarkedTask]) -> tuple[Clause, ...]:
    """The clause of every task, in text order."""
    said = frozenset(j for task in tasks for _, indices in task.arguments for j in indices)
    clauses: list[Clause] = []
    for k in range(len(tasks)):
        clause = _clause(observed, tasks, k, said)
        clauses.append(_excepted(clause) if _is_excepted(clause, clauses) else clause)
    return tuple(clauses)


def _is_excepted(clause: Clause, before: Sequence[Clause]) -> bool:
    """Whether an "unless" before governs a clause as well: "unless it is wet or it is dark". What follows an "or if" is
    the consequence of that alone, unless the sentence began with the "unless"."""
    if not before or not clause.is_joined_check or not before[-1].is_check or clause.sentence != before[-1].sentence:
        return False
    is_first = len(before) == 1 or before[-2].sentence != clause.sentence
    is_joint = clause.opening in (("or",), ("and",)) or (
        clause.opening == ("or", "if") and (clause.ends_sentence or is_first)
    )
    return is_joint and (before[-1].is_excepted or "unless" in before[-1].near)


def _excepted(clause: Clause) -> Clause:
    """The clause as one under an "unless": unless A or B is if not A and not B, unless A and B if not A or not B."""
    wording = clause.wording
    joins = {"or": "and", "and": "or"}[clause.opening[0]]
    return replace(clause, is_excepted=True, wording=replace(wording, is_negated=not wording.is_negated, joins=joins))


def last_named(clauses: Sequence[Clause], k: int) -> Clause:
    """The last clause before `k`, at least 1, that names its object; the one right before where none does."""
    return next((clauses[j] for j in range(k - 1, -1, -1) if clauses[j].objects), clauses[k - 1])


def wordings_of(clauses: Sequence[Clause]) -> tuple[Wording, ...]:
    return tuple(clause.wording for clause in clauses)


@dataclass(frozen=True, slots=True)
class _Stretch:
    """The words around one task: those up to the task before and the task after, and its own clause among them."""

    previous: int
    """The task before, -1 without one."""
    split: int
    """The last mark between the task before and this one, else the task before."""
    following: int
    """The task after, else the number of tokens."""
    first: int
    last: int
    own_last: int
    """Where the clause ends if what stands behind an "and" is of the next task: "it is hot and the fan is not on"."""
    end: int
    """The next mark behind it outside its message, else the task after."""
    is_open: bool
    """Whether no mark stands between it and the task after."""
    cues: tuple[Cue, ...]
    """All cues of the instruction but those inside arguments that cannot be meant."""

    @classmethod
    def around(cls, observed: Observed, tasks: Sequence[MarkedTask], k: int, said: frozenset[int]) -> _Stretch:
        """The words around task `k`; `said`: the tokens of all arguments."""
        document, token = observed.document, tasks[k].token
        previous = tasks[k - 1].token if k else -1
        following = tasks[k + 1].token if k + 1 < len(tasks) else len(document)
        message = {j for kind, indices in tasks[k].arguments if kind == "message" for j in indices}
        between = [document.tokens[j] for j in range(previous + 1, following)]
        marks = [token.i for token in between if token.text in _PUNCTUATION and not _is_in_word(document, token.i)]
        split = max((j for j in marks if j < token), default=previous)
        end = min((j for j in marks if j > token and j not in message), default=following)
        is_open = end == following < len(document)
        cues = [cue for cue in observed.cues if cue.first not in (said if cue.name == "either_way" else message)]
        opening = [cue.last for cue in cues if split < cue.first <= token and cue.name in GOVERNING]
        joining = [cue.last for cue in cues if split < cue.first < token and cue.name in _COORDINATORS]
        closing = [cue.first for cue in cues if token < cue.first < end and cue.name in GOVERNING | PRO_FORMS]
        first = max(opening or joining, default=split) + 1
        last = min([end, *closing]) - 1
        joints = [j for j in range(token + 1, following) if document.tokens[j].lower in _COORDINATORS]
        own_last = min([last, *joints[-1:]]) if is_open else last
        return cls(
            previous=previous,
            split=split,
            following=following,
            first=min(first, token),
            last=max(last, token),
            own_last=max(own_last, token),
            end=end,
            is_open=is_open,
            cues=tuple(cues),
        )

    def names(self, start: int, stop: int) -> tuple[str, ...]:
        """The names of the cues that begin between two tokens, both excluded."""
        return tuple(cue.name for cue in self.cues if start < cue.first < stop)


def _is_in_word(document: Document, mark: int) -> bool:
    """Whether a mark is the hyphen of a word: "no-one"."""
    around = document.tokens[max(0, mark - 1) : mark + 2]
    if len(around) < 3 or around[1].text != "-":
        return False
    return around[0].end == around[1].start and around[1].end == around[2].start


def _clause(observed: Observed, tasks: Sequence[MarkedTask], k: int, said: frozenset[int]) -> Clause:
    """The clause of task `k`; `said`: the tokens of all arguments."""
    document, task, token = observed.document, tasks[k], tasks[k].token
    stretch = _Stretch.around(observed, tasks, k, said)
    previous, following, split = stretch.previous, stretch.following, stretch.split
    first, own_last = stretch.first, stretch.own_last
    far, near = stretch.names(previous, split + 1), stretch.names(split, token)
    behind = stretch.names(token, stretch.end)
    # "lock up but before that feed the cat": where no mark stands between, it belongs to what follows
    own = tuple(name for name in behind if not (stretch.is_open and name in ("before_that", "before_all")))
    ahead = [cue for cue in stretch.cues if previous < cue.first < token]
    is_joined = previous >= 0 and document.sentences[previous] == document.sentences[token]
    is_excluded = "unless" in near
    return Clause(
        task=task,
        first=first,
        last=stretch.last,
        far=far,
        near=near,
        behind=behind,
        sentence=document.sentences[token],
        boundary="start" if previous < 0 else (document.tokens[split].text if split > previous else "none"),
        wording=_wording(observed, task, first, own_last, (far, near, own), is_joined),
        objects=tuple(_nouns(document, task, ("object",))),
        thing=_thing(document, task),
        nouns=frozenset(_nouns(document, task, [kind for kind, _ in task.arguments])),
        receivers=frozenset(_nouns(document, task, ("recipient", "goal"))),
        places=_places(document, task),
        has_pronoun=any(
            document.tokens[indices[-1]].lower in _REFERRING for _, indices in task.arguments if len(indices)
        ),
        number=next((_number(document, indices) for kind, indices in task.arguments if kind == "object"), ""),
        covers=_covers(document, [cue for cue in ahead if cue.name in _COVERING]),
        ends_sentence=following == len(document) or document.sentences[following] != document.sentences[token],
        is_asked=observed.question[token]
        or "whether" in behind
        or (document.tokens[token].tag == "VB" and document.tokens[token].lemma in ASKING_LEMMAS),
        is_forbidden=is_forbidden(document, token),
        is_otherwise=any(
            cue.name == "else"
            and document.tokens[cue.first].lower in _OTHERWISE
            and not _is_adverb(document, cue.first)
            for cue in ahead
        ),
        is_of_somebody=_is_of_somebody(document, task, _PERSONS),
        is_of_person=_is_of_somebody(document, task, _PERSONS - {"they"}),
        asks_where=_asks_where(document, task, behind),
        says_absent=not is_excluded and _says_absent(observed, task, first, own_last),
        says_named_absent=not is_excluded and _says_absent(observed, task, first, own_last, is_named=True),
        says_undone=_says_undone(observed, task, previous, own_last, near),
        says_named_undone=_says_undone(observed, task, previous, own_last, near, is_named=True),
        says_only_whether=_is_bare(document, task, own_last, _ECHOING | _DENYING),
        question=_question(document, task),
        is_of_it=_is_of_somebody(document, task, _ITS),
        verb=document.tokens[token].lemma,
        is_of_nobody=bool(nobody(document, token)),
        is_of_weather=_is_of_weather(document, task, first, own_last),
        ways=frozenset(t.lower for t in document.tokens[token + 1 : own_last + 1] if t.lower in _WAYS),
        opening=tuple(
            cue.name
            for cue in stretch.cues
            if split < cue.first < token and cue.first not in said and cue.name not in _INNER
        ),
        calls_off=task.type == "check_state" and _calls_off(document, token, following, far + near),
        is_new_matter=previous >= 0
        and ((not is_joined and _opens_matter(document, token)) or _tells_matter(document, previous, token)),
        allows=task.type == "check_state" and _allows(document, token, following, far + near),
        is_had_done=_is_had_done(document, stretch.cues, token),
        said_state=_said_state(document, task),
        asks_open=task.type in FINDING_OUT and _asks_open(document, token),
        ability=_ability(document, ahead, token),
        turns=_turns(document, ahead, token),
    )


def _ability(document: Document, ahead: Sequence[Cue], token: int) -> str:
    said = [[normal_form(t.lower) for t in document.tokens[cue.first : cue.last + 1]] for cue in ahead]
    for cue, words in zip(ahead, said, strict=True):
        if cue.name == "fail" and not _ABLE.isdisjoint(words):
            return "denied"
        between = {normal_form(t.lower) for t in document.tokens[cue.last + 1 : token]}
        if cue.name in ("if", "when") and "you" in between and between & _ABLE and between <= _ABLE | _BESIDE_ABLE:
            return "asked"
    return ""


def _asks_open(document: Document, token: int) -> bool:
    tokens = document.tokens[token : token + 4]
    words = [t.lower for t in tokens]
    word = 1 + (words[1:2] == ["out"])
    is_order = tokens[0].lemma in ASKING_LEMMAS and tokens[0].tag in ("VB", "VBP")
    is_open = words[word : word + 1] != [] and words[word] in _OPEN_QUESTIONS
    is_how = (
        words[word : word + 1] == ["how"] and tokens[word + 1 : word + 2] != [] and tokens[word + 1].pos not in _DEGREES
    )
    return is_order and (is_open or is_how or words[word : word + 2] in _AMOUNTS)


def _turns(document: Document, ahead: Sequence[Cue], token: int) -> tuple[str, ...]:
    """What turns to the other case ahead of a verb, also where no mark ends it ("is he up *if not* wake him")."""
    found = []
    for cue in ahead:
        words = [normal_form(t.lower) for t in document.tokens[cue.first : cue.last + 2]]
        is_bare = words == ["if", "not"] and 0 < token - cue.first - 1 <= _NEAR and document.tokens[token].tag == "VB"
        if is_bare or (cue.name == "else" and "if" in words[:-1] and "otherwise" not in words):
            found.append("not")
        elif cue.name == "else" and not _is_adverb(document, cue.first):
            found.append("otherwise")
    return tuple(found)


def _calls_off(document: Document, token: int, following: int, leading: Sequence[str]) -> bool:
    """Whether the words behind a condition, up to the next task in its sentence, begin with a "leave it" or the like,
    or behind a "but" with a "let him" or a "wait"."""
    if _OPENERS.isdisjoint(leading):
        return False
    tokens, sentence = document.tokens, document.sentences[token]
    words = [normal_form(t.lower) for t in tokens[token + 1 : following] if document.sentences[t.i] == sentence]
    for i in range(1, len(words)):
        if words[i - 1] in _OTHERWISE:
            return False
        said = next((phrase for phrase in _LEAVING if tuple(words[i : i + len(phrase)]) == phrase), None)
        if said is not None:
            rest = words[i + len(said) : i + len(said) + 1]
            return not rest or rest[0] in _PUNCTUATION or rest[0] in _AFTER_LEAVING
        if "but" in leading and words[i - 1] in _PUNCTUATION and (words[i] == "wait" or _is_letting(words[i : i + 3])):
            return True
    return False


def _opens_matter(document: Document, token: int) -> bool:
    """Whether the sentence of a token begins with a word that turns to something else, be it behind an "and" or
    "right": "And *now* bring me the tea"."""
    first = document.sentences.index(document.sentences[token])
    while first < token and document.tokens[first].lower in _LEADING_IN:
        first += 1
    return document.tokens[first].lower in _TURNING_TO


def _tells_matter(document: Document, previous: int, token: int) -> bool:
    """Whether words between two tasks say, between marks, that another matter follows: "..., and then, *on a different
    note*, lock up", "*separately*, if it's dry, ..."."""
    for i in range(previous + 1, token - 1):
        words = [t.lower for t in document.tokens[i : i + 2]]
        last = i if words[0] == "separately" else i + 1
        is_said = last == i or (words[0] in _OTHER and words[1] in _MATTERS)
        if is_said and document.tokens[last + 1].text in _STARTING:
            start = i
            while start > 0 and document.tokens[start - 1].lower in _BEFORE_MATTER:
                start -= 1
            return document.tokens[start - 1].text in _PUNCTUATION
    return False


def _allows(document: Document, token: int, following: int, leading: Sequence[str]) -> bool:
    """Whether all that its sentence says behind a condition lifts a prohibition."""
    is_last = following == len(document) or document.sentences[following] != document.sentences[token]
    return is_last and not _OPENERS.isdisjoint(leading) and lifts(document, token)


def _is_letting(words: Sequence[str]) -> bool:
    return len(words) == 3 and words[0] == "let" and words[1] in _PERSONS | _ITS


def _is_had_done(document: Document, cues: Sequence[Cue], i: int) -> bool:
    """Whether the verb at token `i` tells what the listener has done by then ("after you have mopped it", "once you've
    swept and *mopped* it", "after mopping it"), where a "when" takes a perfect."""
    verb = document.tokens[i]
    if verb.dep == "conj" and verb.tag in ("VBD", "VBN", "VBG") and verb.head < i:
        return _is_had_done(document, cues, verb.head)
    opening = max((cue for cue in cues if cue.first < i and cue.name in _ONCE), key=lambda cue: cue.last, default=None)
    if opening is None or opening.last >= i:
        return False
    words = [token.lower for token in document.tokens[opening.last + 1 : i]]
    if verb.tag == "VBG":
        return opening.name == "after" and not words
    is_perfect = not _PERFECT.isdisjoint(words) or opening.name == "after"
    return words[:1] in (["you"], ["u"]) and _DONE_SO_FAR.issuperset(words[1:]) and is_perfect


def _is_of_weather(document: Document, task: MarkedTask, first: int, last: int) -> bool:
    is_of_it = not _nouns(document, task, ("object", "location"))
    words = {token.lower for token in document.tokens[first : last + 1]}
    return task.type == "check_state" and is_of_it and not words.isdisjoint(WEATHER)


def _places(document: Document, task: MarkedTask) -> frozenset[str]:
    tokens = [document.tokens[j] for kind, indices in task.arguments if kind in ("source", "location") for j in indices]
    return frozenset(t.lemma for t in tokens if t.pos in ("NOUN", "PROPN") or t.lower in AROUND)


def _nouns(document: Document, task: MarkedTask, kinds: Collection[str]) -> list[str]:
    """The nouns, as lemmas, of a task's arguments of some kinds."""
    indices = [j for kind, indices in task.arguments if kind in kinds for j in indices]
    return [document.tokens[j].lemma for j in indices if document.tokens[j].pos in ("NOUN", "PROPN")]


def _thing(document: Document, task: MarkedTask) -> frozenset[str]:
    tokens = [document.tokens[j] for kind, indices in task.arguments if kind == "object" for j in indices]
    return frozenset(token.lemma for token in tokens if token.pos not in ("DET", "ADP", "PUNCT"))


def _is_sought(document: Document, indices: range) -> bool:
    """Whether something of a certain kind is meant, no certain thing: "clean towels", "a free chair"."""
    tokens = [document.tokens[j] for j in indices]
    return any(token.pos == "ADJ" for token in tokens) and tokens[0].lower not in _DEFINITE


def _asks_where(document: Document, task: MarkedTask, behind: Sequence[str]) -> bool:
    kinds = {kind for kind, _ in task.arguments}
    if any(kind == "object" and _is_sought(document, indices) for kind, indices in task.arguments):
        return False  # "are there clean towels in the bathroom?" asks how they are as well
    is_asked = document.tokens[task.token].lemma in _BEING or not {"whether", "if"}.isdisjoint(behind)
    return task.type == "check_state" and "location" in kinds and "state" not in kinds and is_asked


def _number(document: Document, indices: range) -> str:
    """Whether an object is one thing or many; open of people, who may be "they" one by one."""
    tokens = [document.tokens[j] for j in indices]
    if len(tokens) == 1 and tokens[0].lower in _NUMBERS:
        return _NUMBERS[tokens[0].lower]
    head = document.tokens[head_of(document, indices)]
    if _is_sought(document, indices):  # "clean towels ... if they're all dirty"
        return ""
    if head.lemma in PERSON_NOUNS or head.pos != "NOUN" or any(token.lower in _JOINING for token in tokens):
        return ""
    return {"NN": "one", "NNS": "many"}.get(head.tag, "")


def _is_adverb(document: Document, otherwise: int) -> bool:
    """Whether an "otherwise" opens nothing: "or otherwise damaged", "if he says otherwise"."""
    before, after = document.tokens[otherwise - 1 : otherwise], document.tokens[otherwise + 1 : otherwise + 2]
    is_of_adjective = bool(after) and after[0].tag in ("VBN", "JJ")
    return is_of_adjective or (bool(before) and before[0].pos == "VERB")


def _is_of_somebody(document: Document, task: MarkedTask, persons: frozenset[str]) -> bool:
    objects = [indices for kind, indices in task.arguments if kind == "object"]
    return any(len(indices) == 1 and document.tokens[indices[0]].lower in persons for indices in objects)


def _covers(document: Document, openings: Sequence[Cue]) -> str:
    """Whether words like "all this" stand before the word that opens a condition, at the beginning of a clause."""
    if len(openings) != 1:
        return ""
    stop = openings[0].first
    words = [token.lower for token in document.tokens[max(0, stop - 6) : stop]]
    words = words[next((i + 1 for i in range(len(words) - 1, -1, -1) if words[i] in _STARTING), 0) :]
    said = " ".join(words)
    if said in _ALL_OF_IT:
        return "-" if openings[0].name == "unless" else "+"
    return "-" if said in _NONE_OF_IT and openings[0].name != "unless" else ""


def _is_being_of(document: Document, task: MarkedTask, persons: frozenset[str]) -> bool:
    return document.tokens[task.token].lemma in {"be", *_BEING} and _is_of_somebody(document, task, persons)


def _says_absent(observed: Observed, task: MarkedTask, first: int, last: int, *, is_named: bool = False) -> bool:
    said = {kind: [observed.document.tokens[j].lower for j in indices] for kind, indices in task.arguments}
    is_being = observed.document.tokens[task.token].lower in _IS or observed.document.tokens[task.token].lemma in _BEING
    thing = said.get("object", [""])
    is_of_it = thing[0] in _DEFINITE if is_named else _REFERRING.issuperset(thing)
    is_check = task.type == "check_state" and is_being and "state" not in said
    return is_check and is_of_it and bool(negations(observed, task.token, first, last))


def _says_undone(
    observed: Observed, task: MarkedTask, previous: int, last: int, near: Sequence[str], *, is_named: bool = False
) -> bool:
    tokens = observed.document.tokens
    things = [indices for kind, indices in task.arguments if kind in ("object", "goal", "source", "location")]
    if is_named:
        is_of_it = len(things) == 1 and tokens[things[0].start].lower in _DEFINITE and things[0].stop <= task.token
    else:
        is_of_it = len(things) <= 1 and all(tokens[j].lower in _THINGS for indices in things for j in indices)
    if not is_of_it:
        return False
    first = next((j for j in range(task.token - 1, previous, -1) if tokens[j].text in _PUNCTUATION), previous) + 1
    words = [token.lower for token in tokens[first : task.token]]
    # "it doesn't" is a cue for a failure in itself
    is_denied = "fail" in near or bool(negations(observed, task.token, first, last))
    behind = {token.lower for token in tokens[task.token + 1 : last + 1]}
    if "still" in words or not is_denied or not behind <= _PARTICLES | _EMPTY:
        return False
    lemma = tokens[task.token].lemma
    if lemma in _MOVING and behind.isdisjoint(_PARTICLES):
        return False  # "if they don't come"
    if not WILLING.isdisjoint(words):
        return lemma not in _FITTING
    return not _DOING.isdisjoint(words) and lemma in _HAPPENING


_Cues = tuple[Sequence[str], Sequence[str], Sequence[str]]


def _wording(observed: Observed, task: MarkedTask, first: int, last: int, cues: _Cues, is_joined: bool) -> Wording:
    far, near, behind = cues
    # "there isn't no milk", "not there neither" deny once
    tokens = observed.document.tokens
    # "if it refuses to open"
    refusing = [j for j in range(first, task.token) if tokens[j].lemma in _REFUSING and tokens[j + 1].lower == "to"]
    is_denied = bool(negations(observed, task.token, first, last)) != bool(refusing)
    state = _state(observed, task, last)
    leading = {*far, *near}
    orders = [
        *(label for name in near for label in _SUBORDINATE.get(name, ())),
        *(label for said in (leading, behind) for name in _ADVERBIAL if name in said for label in _ADVERBIAL[name]),
    ]
    lemmas = {
        tokens[j].lemma for j in range(first, last + 1) if not j or tokens[j - 1].lower not in ("right", "straight")
    }  # "right away" is no "away"
    lemmas -= {tokens[j].lemma for j in refusing}
    return Wording(
        is_denied != ("unless" in near),
        state,
        OPPOSITES.get(state, _OTHER_ANSWER.get(state)) if state else None,
        observed.document.sentences[task.token],
        tuple(dict.fromkeys(orders)),
        next((word for word in ("or", "and") if word in leading and not leading & GOVERNING), "") if is_joined else "",
        bool(lemmas & _CONTRARY)
        or state in _CONTRARY
        or _says_used_up(tokens[first : last + 1])
        or (state == "out" and _is_being_of(observed.document, task, _PERSONS)),
        _is_bare(observed.document, task, last, _ECHOING),  # "if he is", "if it does", "when they have"
    )


def _says_used_up(clause: Sequence[Token]) -> bool:
    """Whether a clause says that there is none left: "we're out (of it)", "we've run out", "they've gone"."""
    words = [normal_form(token.lower) for token in clause if token.text not in _PUNCTUATION]
    words = [word for word in words if word not in _ADDED]
    first, behind = words[:1], words[words.index("out") + 1 :] if "out" in words else ["in"]
    is_ours = not _OURS.isdisjoint(first) and not {"is", "are", "am", "run"}.isdisjoint(words)
    is_out = not behind or behind[0] == "of"
    return (is_ours and is_out) or (words[-1:] == ["gone"] and not _LEFT.isdisjoint(first))


def _is_bare(document: Document, task: MarkedTask, last: int, words: frozenset[str]) -> bool:
    """Whether a check is one of these words, and no more than a pronoun is said besides: "if he is"."""
    if task.type != "check_state" or document.tokens[task.token].lower not in words:
        return False
    if any(kind != "object" or len(indices) > 1 for kind, indices in task.arguments):
        return False
    return all(
        token.lower in _REFERRING or token.lower in words - _ECHOING or token.text in _PUNCTUATION
        for token in document.tokens[task.token + 1 : last + 1]
    )


def _question(document: Document, task: MarkedTask) -> frozenset[str]:
    messages = [indices for kind, indices in task.arguments if kind == "message" and len(indices)]
    if task.type != "informing" or not messages or document.tokens[messages[0].start].lower not in _WHETHER:
        return frozenset()
    return frozenset(word for j in messages[0] for word in (document.tokens[j].lemma, document.tokens[j].lower))


def _said_state(document: Document, task: MarkedTask) -> tuple[str, ...]:
    """The words of the state argument of a check."""
    said = [j for kind, indices in task.arguments if kind == "state" for j in indices]
    return tuple(document.tokens[j].lower for j in said)


def _state(observed: Observed, task: MarkedTask, last: int) -> str | None:
    """The word for the state that a clause tests: the end of its state argument, else a word with an opposite."""
    tokens = observed.document.tokens
    said = next((indices[-1] for kind, indices in task.arguments if kind == "state" and len(indices)), None)
    if said is not None:
        return tokens[said].lower
    if task.type != "check_state" or degree_asked(observed.document, task.token):
        return None
    if task.token < last and is_answer(observed.document, task.token + 1):
        return tokens[task.token + 1].lower
    for j in range(min(task.token, last), last + 1):
        governs = any(tokens[child].dep == "pobj" for child in observed.document.children[j])
        if tokens[j].lower in OPPOSITES and not governs and tokens[j].tag not in ("VB", "VBP", "VBZ", "VBD"):
            return tokens[j].lower
    return None


_DOING = frozenset(("do", "does", "did"))
_THINGS = frozenset("it they them that this those these one".split())
_PARTICLES = frozenset("on off up down out in".split())
_EMPTY = frozenset("at all properly fully for you , then".split())
_MOVING = frozenset(("come", "go", "turn", "switch", "move"))
_FITTING = frozenset(("fit", "stop", "find"))
_HAPPENING = frozenset(
    "open close shut start light flush pair work go come turn switch move budge lock unlock respond connect".split()
)
_REFUSING = frozenset(("refuse", "fail"))
_CONTRARY = frozenset("fail refuse stick stuck jam jammed gone missing away elsewhere vanish disappear".split())


_SUBORDINATE = {"before": ("after", "last"), "until": ("before", "first"), "after": ("before", "first")}
_ADVERBIAL = {
    "before_that": ("before", "first"),
    "before_all": ("first", "before"),
    "first": ("first", "before"),
    "last": ("last",),
}
"""The order labels that a cue speaks for: one that makes its clause subordinate, and one that is an adverb in it."""
