"""The clause around each task: the cues that open it, its negation, the state it tests, where it ends."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace

from decomplex_bt.understanding.control_flow.arcs import Wording
from decomplex_bt.understanding.control_flow.denials import WILLING, negations
from decomplex_bt.understanding.cues import ASKING_LEMMAS, GOVERNING, OPPOSITES, PRO_FORMS, Cue, are_apart
from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.phrases import PERSON_NOUNS, degree_asked, head_of, nobody
from decomplex_bt.understanding.rules.prohibitions import is_forbidden


@dataclass(frozen=True, slots=True)
class MarkedTask:
    """A task as the flow model sees it: its token, its type and the tokens of its arguments as (type, indices)."""

    token: int
    type: str
    arguments: tuple[tuple[str, range], ...] = ()


@dataclass(frozen=True, slots=True)
class Clause:
    """What surrounds one task, and what its words say for certain. Indices are those of tokens, nouns are lemmas."""

    task: MarkedTask
    first: int
    last: int
    """The bounds of the clause."""
    far: tuple[str, ...]
    """The cues between the task before and the last punctuation mark ahead of this one."""
    near: tuple[str, ...]
    """The cues from there to the task."""
    behind: tuple[str, ...]
    """The cues after the task up to the next punctuation mark or task."""
    sentence: int
    boundary: str
    """The last mark between the task before and this one; "none" without one, "start" for the first task."""
    wording: Wording
    objects: tuple[str, ...]
    """The nouns of its object."""
    thing: frozenset[str]
    """All words of its object that tell which one is meant: "small" and "box"."""
    nouns: frozenset[str]
    """The nouns of all its arguments."""
    receivers: frozenset[str]
    """The nouns of those who get or are told something, and of where something is put."""
    places: frozenset[str]
    """The nouns of where it says that something is, is looked for or taken from, and "there" and its kin."""
    has_pronoun: bool
    """Whether an argument is a pronoun."""
    number: str
    """Whether its object is "one" thing or "many"; "" where the words leave it open."""
    covers: str
    """The side, "+" or "-", of all that was ordered before, if that hangs on it ("all this only if ..."), else ""."""
    ends_sentence: bool
    """Whether no task follows in its sentence."""
    is_asked: bool
    """Whether it orders to check ("see if it is on") or asks ("is it on?")."""
    is_forbidden: bool
    """Whether it says not to do something ("don't open it")."""
    is_otherwise: bool
    """Whether "otherwise" or the like opens it."""
    is_of_somebody: bool
    """Whether its object is "he", "she" or "they"."""
    is_of_person: bool
    """Whether its object is "he" or "she"."""
    asks_where: bool
    """Whether it asks for nothing but where something is."""
    says_absent: bool
    """Whether it says no more than that what was spoken of is not in one of its `places`."""
    says_named_absent: bool
    """The same of something that it names."""
    says_undone: bool
    """Whether it says no more than that what was spoken of does not do what it was made to ("if it won't open")."""
    says_named_undone: bool
    """The same of something that it names ("if the trunk won't open")."""
    says_only_whether: bool
    """Whether it says no more than that somebody or something is so, or is not: "if she does", "if he isn't"."""
    question: frozenset[str]
    """The words and lemmas of what it asks somebody, where yes or no answers it ("ask Lea if she wants soap")."""
    is_of_it: bool
    """Whether its object is a pronoun and no more: "it", not "the other one"."""
    verb: str
    """The lemma of its verb."""
    is_of_nobody: bool = False
    """Whether it says that nobody is, or does, something."""
    is_excepted: bool = False
    """Whether it stands under the "unless" of the clause before it."""

    def names_same(self, other: Clause) -> bool:
        """Whether the objects of both may be one thing, by the words for it: "the old stove" and "the stove", not "the
        small box" and "the big box"."""
        is_head = bool(self.objects) and self.objects[-1:] == other.objects[-1:]
        return is_head and (self.thing <= other.thing or other.thing <= self.thing)

    def is_absence_of(self, before: Clause) -> bool:
        """Whether it says no more than that whoever the task before should give or tell something to is not there:
        "take it to Anna, and if she's out, ..."."""
        if self.task.type != "check_state" or before.task.type not in _HANDING or not self.is_of_somebody:
            return False
        if not self.is_of_person and before.number == "many":
            return False  # "they" may as well be what is given
        kinds = {kind for kind, _ in before.task.arguments}
        # not "in by six"
        is_all = max((j for _, indices in self.task.arguments for j in indices), default=0) >= self.last
        is_gone = self.wording.state in _GONE and not self.wording.is_negated
        is_away = self.wording.is_negated and (self.wording.state in _AROUND or not self.places.isdisjoint(_AROUND))
        return bool(kinds & {"recipient", "goal"}) and "unless" not in self.near and is_all and (is_gone or is_away)

    def is_failure_of(self, before: Clause, named: Clause) -> bool:
        """Whether it says no more than that the change before it failed: "unlock it, and if it won't open, ..." or "if
        the trunk won't open"; `named`: the clause up to there that last names a thing."""
        is_one = not (self.number and before.number) or self.number == before.number
        is_opposite = self.wording.state is not None and OPPOSITES.get(self.wording.state) == before.wording.state
        is_change = before.task.type == "change_state" and is_one and not is_opposite
        is_of_it = self.says_undone or (self.says_named_undone and self.names_same(named))
        return is_change and is_of_it and "unless" not in self.near

    def is_guard_of(self, before: Clause) -> bool:
        """Whether it asks no more than whether the change before it is needed: "wash it if it's dirty", "fill it unless
        it's full", "turn the tv off if it's on"."""
        if before.task.type != "change_state" or not self.is_check or self.wording.state is None:
            return False
        goals, needs = _NEEDED.get(before.wording.state or before.verb, (_NEVER, _NEVER))
        is_needed = self.wording.state in (goals if self.wording.is_negated else needs)
        return is_needed and (self.names_same(before) or (self.has_pronoun and not self.objects))

    def is_answer_to(self, before: Clause, others: Sequence[Clause]) -> bool:
        """Whether it says how somebody answered what the task before asked ("ask Lea if she wants soap, and if she
        does, ..."), where the `others`, the conditions so far, are of things."""
        is_fitting = self.verb == "do" or not before.question.isdisjoint((self.verb, "'s", "\u2019s"))
        is_of_them = self.is_of_somebody and not any(other.number == "many" for other in others)
        is_answer = self.says_only_whether and bool(before.question) and is_fitting
        is_of_things = not any(other.is_of_somebody or other.may_be_of_person for other in others)
        return is_answer and is_of_things and (self.is_of_person or is_of_them)

    @property
    def may_be_of_person(self) -> bool:
        """Whether it names somebody, or something that may be a person's name."""
        return not self.number and any(kind == "object" for kind, _ in self.task.arguments)

    def repeats(self, before: Clause) -> bool:
        """Whether it only says again what is ordered before, to put something ahead of it: "before you bring it"."""
        is_same = self.verb == before.verb and self.task.type == before.task.type
        is_of_it = self.is_of_it or (bool(self.objects) and self.names_same(before))
        return is_same and is_of_it and "before" in self.near

    def may_repeat(self, before: Clause) -> bool:
        """Whether both may be one and the same order: of one type and of things that are not named apart."""
        is_same = not (self.objects and before.objects) or self.names_same(before)
        return self.task.type == before.task.type and is_same

    def is_opposite_of(self, first: Clause) -> bool:
        """Whether it tests the opposite of an earlier condition, of the same thing by name: "if the tv is off, ..., if
        the tv is on, ..."."""
        one, other = self.wording, first.wording
        is_other_state = one.is_opposite_of(other) or other.is_opposite_of(one)
        is_denied = one.state is not None and one.state == other.state and one.is_negated != other.is_negated
        is_turned = is_denied or (is_other_state and one.is_negated == other.is_negated)
        return self.is_check and first.is_check and is_turned and self.names_same(first)

    @property
    def is_trailing(self) -> bool:
        """Whether it stands behind what hangs on it: "bring the dog in if he's still out"."""
        return self.boundary == "none" and self.ends_sentence

    @property
    def is_of_whereabouts(self) -> bool:
        """Whether it asks where somebody or something is."""
        is_located = any(kind == "location" for kind, _ in self.task.arguments)
        return self.task.type == "check_state" and (is_located or self.wording.state in _PRESENT)

    def finds_out(self, after: Clause) -> bool:
        """Whether a later clause tells what it found out: "look in the box. If it isn't there, ...", "bring the tongs
        from the shed, and if they're not in the shed, ...", "..., and if the tongs aren't there, ..."."""
        is_place = "there" in after.places or not after.places.isdisjoint(self.places)
        is_thing = self.task.type == "searching" or not after.is_of_person
        says_absent = after.says_absent or (after.says_named_absent and after.names_same(self))
        return says_absent and is_thing and is_place and bool(self.places) and self.task.type in _FINDING

    @property
    def is_check(self) -> bool:
        """Whether it states what is to be checked ("it is wet"), and is neither an order to check nor a question."""
        return self.task.type == "check_state" and not self.is_asked

    @property
    def opening(self) -> tuple[str, ...]:
        """The cues ahead of its verb but for those that say nothing of other clauses ("or somebody is *still* in")."""
        return tuple(name for name in self.near if name not in _INNER)

    @property
    def is_joined_check(self) -> bool:
        """Whether "and" or "or" may join it to the check before it."""
        return self.is_check and self.boundary in ("none", ",") and not self.far

    def joining_role(self, before: Clause) -> str:
        """The role, "and" or "or", of a check that is joined to the one before it under the same "if" or "unless" ("if
        it is wet or the fan is off"), as parts are joined where both are as stated; "" where nothing settles that:
        unless it ends the sentence ("open it if it is dry and the fan is on"), the second of two that "and" joins may
        as well be a condition in the branch of the first."""
        if not self.is_joined_check or not before.is_check or self.sentence != before.sentence:
            return ""
        if self.is_excepted:
            return self.wording.joins
        is_bare = self.boundary == "none" and self.opening == (self.wording.joins,)
        is_certain = is_bare and (self.wording.joins == "or" or self.ends_sentence)
        return self.wording.joins if is_certain and not _IFS.isdisjoint(before.near) else ""

    def is_of_other_state(self, first: Clause) -> bool:
        """Whether it tests a state that has nothing to do with the one that an order to check asks ("check if it is
        done, and if it's burnt, ...")."""
        state, other = self.wording.state, first.wording.state
        if state is None or other is None or "whether" not in first.behind or "still" in self.near:
            return False
        return not self.objects and self.has_pronoun and are_apart(state, other)

    def asks_same_of_another(self, first: Clause) -> bool:
        """Whether it asks of something that it names what the other asks of something else."""
        is_same = self.verb == first.verb and self.wording.state == first.wording.state and self.places == first.places
        is_other = bool(self.objects) and bool(first.objects) and set(self.objects).isdisjoint(first.objects)
        return self.is_check and first.is_check and is_same and is_other and _NO_THINGS.isdisjoint(self.objects)

    def asks_for_what_had_state(self, first: Clause) -> bool:
        """Whether it asks if something is missing, where the other tests another state of it."""
        is_of_state = any(kind == "state" for kind, _ in first.task.arguments)
        return self.wording.state in _MISSING and is_of_state and first.wording.state not in _PRESENT

    def is_of_nobody_at(self, first: Clause) -> bool:
        """Whether it asks if nobody is, or does, something, where the other tests a state of a thing that has nothing
        to do with who is there: "if the trunk is shut, ..., and if nobody is sleeping, ..."."""
        is_of_thing = first.task.type == "check_state" and bool(first.number) and first.wording.state is not None
        is_of_users = first.wording.state in _USED or not self.nouns.isdisjoint(first.objects)
        return self.is_check and self.is_of_nobody and is_of_thing and not is_of_users

    def is_of_another(self, first: Clause) -> bool:
        """Whether its words say that it is no mention of an earlier condition: it asks the same of another thing ("if
        there's no milk, ..., if there's no tea, ..."), or whether something is missing whose state the other tests, or
        it tests a state, and that of many things where the other is about one (or the other way round), or of what the
        other asks the place of."""
        own = {kind for kind, _ in self.task.arguments}
        is_of_other = self.asks_same_of_another(first) or self.is_of_nobody_at(first)
        if is_of_other or self.asks_for_what_had_state(first):
            return True
        if self.task.type != "check_state" or first.task.type != "check_state" or "state" not in own:
            return False
        state, other = self.wording.state, first.wording.state
        if state in _PRESENT or set(self.objects) & set(first.objects):
            return False
        if (
            state is not None
            and other is not None
            and (state == other or OPPOSITES.get(state) == other or OPPOSITES.get(other) == state)
        ):
            return False
        is_of_others = bool(self.number and first.number) and self.number != first.number
        return is_of_others or (first.asks_where and "location" not in own)


_NEVER: frozenset[str] = frozenset()
_NEEDED = {
    verb: (frozenset(goals.split()), frozenset(needs.split()))
    for verbs, goals, needs in (
        ("on", "on running lit", "off out"), ("off", "off out", "on running lit"),
        ("open", "open ajar", "closed shut"), ("close shut", "closed shut", "open ajar"),
        ("lock bolt", "locked bolted", "unlocked open"), ("unlock unbolt", "unlocked open", "locked bolted shut"),
        ("heat warm reheat microwave", "hot warm", "cold cool lukewarm tepid chilly"),
        ("cool chill", "cold cool chilled", "warm hot lukewarm"),
        ("clean wash rinse wipe scrub mop sweep vacuum hoover dust polish", "clean washed spotless",
         "dirty filthy muddy dusty sticky stained grubby greasy unwashed"),
        ("fill refill", "full", "empty low"), ("empty", "empty", "full overflowing"), ("dry", "dry", "wet damp soaked"),
        ("iron press", "ironed smooth", "wrinkled creased crumpled"),
        ("charge recharge", "charged full", "flat low dead empty"), ("water", "wet moist damp", "dry thirsty"),
        ("cover", "covered", "uncovered bare"), ("light", "lit", "unlit out"),
        ("make", "made", "unmade"), ("plug", "plugged", "unplugged"), ("fold", "folded", "unfolded crumpled"),
    )
    for verb in verbs.split()
}  # fmt: skip
"""What verbs of change, or the states that they bring about, are for: the states they end in, and those they end."""
_IFS = frozenset(("if", "unless", "only_if"))
_USED = frozenset("free busy empty available occupied taken use unused vacant unoccupied deserted quiet loud".split())
"""States that tell whether somebody is there."""
_HANDING = frozenset(("bringing", "informing"))
_MISSING = frozenset(("missing", "gone", "lost"))
_NO_THINGS = frozenset("none one some any drop".split())
_ITS = frozenset("it them 'em em him her this that these those".split())
_PERSONS = frozenset(("he", "she", "they"))
_GONE = frozenset(("out", "away", "gone"))
_AROUND = frozenset("in home there here around about back".split())
_FINDING = frozenset(("searching", "bringing", "taking"))
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
_INNER = frozenset(("still", "not", "can", "there", "also"))
_PUNCTUATION = frozenset((",", ".", ";", ":", "?", "!", "-", "–", "—", "...", "…", "(", ")"))
_NUMBERS = {"it": "one", "they": "many", "them": "many", "those": "many", "these": "many"}
_BEING = frozenset(("be", "'s", "'re", "s"))
_DEFINITE = frozenset("the my your his her our their this that these those".split())
_OTHERWISE = frozenset(("otherwise", "or", "alternatively"))
_COORDINATORS = frozenset(("and", "but", "or"))
_IS = frozenset(("is", "are", "'s", "\u2019s", "be"))
_JOINING = frozenset(("and", "or", "of", "&"))
_PRESENT = frozenset(
    "gone up empty out missing in away clear here there home back left present absent around inside outside upstairs "
    "downstairs free busy finished done available about nearby lost".split()
)
"""States that tell whether somebody or something is where they were looked for."""
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
    )


def _places(document: Document, task: MarkedTask) -> frozenset[str]:
    tokens = [document.tokens[j] for kind, indices in task.arguments if kind in ("source", "location") for j in indices]
    return frozenset(t.lemma for t in tokens if t.pos in ("NOUN", "PROPN") or t.lower in _AROUND)


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
        OPPOSITES.get(state) if state else None,
        observed.document.sentences[task.token],
        tuple(dict.fromkeys(orders)),
        next((word for word in ("or", "and") if word in leading and not leading & GOVERNING), "") if is_joined else "",
        bool(lemmas & _CONTRARY)
        or state in _CONTRARY
        or (state == "out" and _is_being_of(observed.document, task, _PERSONS)),
        _is_bare(observed.document, task, last, _ECHOING),  # "if he is", "if it does", "when they have"
    )


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


def _state(observed: Observed, task: MarkedTask, last: int) -> str | None:
    """The word for the state that a clause tests: the end of its state argument, else a word with an opposite."""
    tokens = observed.document.tokens
    said = next((indices[-1] for kind, indices in task.arguments if kind == "state" and len(indices)), None)
    if said is not None:
        return tokens[said].lower
    if task.type != "check_state" or degree_asked(observed.document, task.token):
        return None
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
