"""A clause: what surrounds one task, and what its words say for certain of it and of the clauses before."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from decomplex_bt.understanding.changes import change
from decomplex_bt.understanding.control_flow.arcs import Wording
from decomplex_bt.understanding.cue_phrases import ASKING_LEMMAS, WISHING

Presence = Literal["", "there", "away"]
"""What a check asks that asks no more than whether somebody or something is at hand ("if she's in", "if there are
none") or is not ("if she's out"), its negation aside; "" for all else."""


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
    """The bounds of the clause, without an "either" or "too" at its end."""
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
    says_there_is: bool
    """Whether it asks if there is something that it names: "if there's a letter"."""
    is_of_some: bool
    """Whether it is of some of what was named: "if one of them is up"."""
    verb: str
    """The lemma of its verb."""
    is_of_nobody: bool = False
    """Whether it says that nobody is, or does, something."""
    is_of_weather: bool = False
    """Whether it asks about the weather or the day."""
    presence: Presence = ""
    is_event: bool = False
    """Whether it tells of what comes about and is waited for: "once *it's dry*"."""
    is_excepted: bool = False
    """Whether it stands under the "unless" of the clause before it."""
    ways: frozenset[str] = frozenset()
    """The words behind its verb that tell which way: "back", "out"."""
    opening: tuple[str, ...] = ()
    """The cues ahead of its verb but for those that say nothing of other clauses ("or somebody is *still* in"), or are
    of what is said in the clause before ("unless it's *after* ten or somebody is in")."""
    calls_off: bool = False
    """Whether all that is said to be done in its case is to leave what was ordered: "but if it's wet, *leave it*"."""
    skips: frozenset[str] = frozenset()
    """What the verb may be, as a lemma, of the order that is not to be done in its case: "if it's clean, *skip the
    washing*"."""
    is_new_matter: bool = False
    """Whether its sentence, of which it is the first, begins with a "now" or the like: "*Now* bring me the tea", or
    words between marks say that it is of another matter."""
    allows: bool = False
    """Whether all that is said of its case is that what was forbidden may be done: "but if it's hot, *do*"."""
    is_had_done: bool = False
    """Whether it is what is to be done by then: "after *you have mopped* it", "once *you've mopped* it"."""
    said_state: tuple[str, ...] = ()
    """The words of the state that it tests: "half", "full"."""
    asks_open: bool = False
    """Whether it orders to find out what no yes or no answers: "see who it is", "check what the boys are doing"."""
    ability: str = ""
    """Whether it is "asked" if its verb can be done ("if you can find it"), or "answered" or "denied" that what was
    asked of can be ("if you can, ...", "if you can't, ...")."""
    is_in_vain: bool = False
    """Whether what opens it says that what was done before was of no use: "if that doesn't help"."""
    is_unwilling: bool = False
    """Whether it says that somebody won't do something: "if he won't come"."""
    is_only_then: bool = False
    """Whether it is to be done "only then"."""
    says_too: bool = False
    """Whether it ends in an "either" or "too": it is so of somebody or something else as well."""
    says_still: bool = False
    """Whether it asks if something is "still" so."""
    identified: str = ""
    """The noun or name of who or what it asks if "it" is: "if it's the *plumber*"."""
    says_instead: bool = False
    """Whether it asks if something is so "instead": "if a child is there *instead*"."""
    forbids_order: bool = False
    """Whether a "don't" behind it forbids in its case what was ordered: "if she's in there *don't*, ..."."""
    is_past_idle: bool = False
    """Whether an "and" behind a comma goes on from an "otherwise" that orders nothing: "otherwise don't wake her, *and
    lock up*", "otherwise leave it, *and lock up*"."""
    is_either_way: bool = False
    """Whether what it hangs on is said right ahead to make no difference: "whether you find it or not, *come back*"."""
    is_past_guess: bool = False
    """Whether the sentence before ends in a guess at where something is, behind a case: "if it's not here, *it must be
    in the hall*. Bring it to me"."""
    is_mere_contrast: bool = False
    """Whether a "but" right ahead sets an order beside the one before, and nothing behind says when: "*but* draw the
    blinds", not "but draw them before you go"."""
    is_waited_for: bool = False
    """Whether a "wait" in the order of the text says to wait for it: "..., *wait until it's hot*", not "but wait"."""
    is_end: bool = False
    """Whether an "until" says that the order before goes on up to it: "beat it *until it's stiff*"."""
    says_already: bool = False
    """Whether it asks if something is "already" so."""
    picks: str = ""
    """Whether its object is what of those that were checked "is" so, or "not": "close *any that aren't*"."""
    tells_where: bool = False
    """Whether all that is said of its case is where something is: "if it's locked, *the key is in the drawer*"."""
    is_and_then: bool = False
    """Whether an "and then" leads on to it."""
    removes: bool = False
    """Whether it says to take something "away", "out" or "off" again."""
    is_of_any: bool = False
    """Whether it asks if there are any of what was named: "are there *any* in the tin?"."""
    lets_be: str = ""
    """The noun of what may be as it is in its case, if no more is said of that: "if it's late, *the pots can wait*"."""
    is_of_kind: bool = False
    """Whether any of a kind will do as its object, not a certain one: "a blanket", "another shawl"."""
    names_any: bool = False
    """Whether it asks something of any of those that it names: "if *any cup* is cracked"."""
    is_urged: bool = False
    """Whether a "but do" sets it against what was forbidden: "don't open it if it rains, *but do* close this"."""
    is_reminder: bool = False
    """Whether it says not to forget it: "*don't forget to* lock up"."""
    is_had: bool = False
    """Whether it waits until something is in hand: "once *you have it*, ..."."""
    case: str = ""
    """Whether words ahead say that it is done in the "same" case as the task before, or in the "other" one: "*in that
    case*, also ...", "*in the former case*"."""
    is_on_arrival: bool = False
    """Whether words ahead say that it is done once the listener has got somewhere: "*once you're there*"."""
    of_both: str = ""
    """Whether an "if" is of "neither" or "either" of what was asked before: "*if neither*, ...", "if it's *in
    either*"."""
    turns: tuple[str, ...] = ()
    """What turns to the other case ahead of its verb: "not" for an "if not" or the like, "otherwise" for the rest."""
    is_then: bool = False
    """Whether it ends in a "then", which takes up a case: "put it on the floor *then*"."""
    is_past_wait: bool = False
    """Whether the words ahead, in a sentence before, only say to wait: "if it isn't hot, *wait*. Then bring it"."""
    turns_up: bool = False
    """Whether it says that what was spoken of is found: "if *it turns up*", "should *he appear*"."""
    is_past_supposition: bool = False
    """Whether the sentence before says what "it" might be: "*it might be Ann*. If it is, ..."."""

    def names_same(self, other: Clause) -> bool:
        """Whether the objects of both may be one thing, by the words for it: "the old stove" and "the stove", not "the
        small box" and "the big box"."""
        is_head = bool(self.objects) and self.objects[-1:] == other.objects[-1:]
        return is_head and (self.thing <= other.thing or other.thing <= self.thing)

    def takes_up(self, order: Clause) -> bool:
        """Whether its object is a pronoun that may mean the thing which the order right before names."""
        is_one = not (self.number and order.number) or self.number == order.number
        is_pronoun = (self.is_of_it or self.is_of_somebody) and not self.objects
        return is_pronoun and is_one and bool(order.objects) and not order.has_pronoun and not self.is_of_weather

    def is_of_same_it(self, other: Clause) -> bool:
        """Whether the objects of both are no more than "it", or both than "they"."""
        are_pronouns = (self.is_of_it and other.is_of_it) or (self.number == other.number == "many")
        are_bare = not (self.objects or other.objects or self.is_of_weather or other.is_of_weather)
        return are_pronouns and are_bare and self.number == other.number != ""

    @property
    def needed(self) -> frozenset[str]:
        """The nouns of what an order needs as it is when it begins: whatever it changes, and its places, not what is
        only to be had through it ("fetch *the milk*")."""
        changed = self.objects if self.task.type == "change_state" else ()
        return self.receivers | self.places | frozenset(changed)

    @property
    def effects(self) -> frozenset[str]:
        """The states that an order to change something ends in."""
        return change(self.wording.state or self.verb).ends_in

    @property
    def needs(self) -> frozenset[str]:
        """The states that an order to change something ends."""
        return change(self.wording.state or self.verb).ends

    @property
    def says_answer(self) -> bool:
        """Whether it says that somebody answers yes, or no."""
        return self.is_check and self.wording.state in _ANSWERS

    @property
    def says_reply(self) -> bool:
        """Whether it says how somebody takes, or whether they know, what they are asked: "if he refuses", "if she won't
        do it", "if they don't remember", "if he doesn't come"."""
        is_kept_away = self.verb == "come" and self.wording.is_negated and not (self.said_state or self.places)
        is_said = self.verb in _SAYING and not self.wording.is_negated
        is_reply = self.verb in _REPLYING or is_said or self.is_unwilling or self.says_answer or is_kept_away
        return self.is_check and self.is_of_somebody and not self.is_trailing and is_reply

    @property
    def is_put_to_somebody(self) -> bool:
        """Whether it orders to ask, tell or offer somebody something, to which there may be a reply."""
        is_put = self.task.type == "informing" or (self.task.type == "bringing" and self.verb == "offer")
        return is_put and not self.is_forbidden and any(kind == "recipient" for kind, _ in self.task.arguments)

    @property
    def may_be_of_person(self) -> bool:
        """Whether it names somebody, or something that may be a person's name."""
        return not self.number and any(kind == "object" for kind, _ in self.task.arguments)

    @property
    def is_trailing(self) -> bool:
        """Whether it stands behind what hangs on it: "bring the dog in if he's still out"."""
        return self.boundary == "none" and self.ends_sentence

    @property
    def is_of_whereabouts(self) -> bool:
        """Whether it asks where somebody or something is."""
        is_located = any(kind == "location" for kind, _ in self.task.arguments)
        return self.task.type == "check_state" and (is_located or self.wording.state in PRESENT)

    @property
    def is_check(self) -> bool:
        """Whether it states what is to be checked ("it is wet"), and is neither an order to check nor a question."""
        return self.task.type == "check_state" and not self.is_asked

    @property
    def is_question(self) -> bool:
        """Whether it asks ("is it on?", "lamp on?"), and is no order to check."""
        return self.is_asked and "whether" not in self.behind and self.verb not in ASKING_LEMMAS

    @property
    def asks_who(self) -> bool:
        """Whether it asks who or what something is: "if it's the plumber"."""
        is_named = self.verb in ("be", "'s") and bool(self.objects) and not self.says_there_is
        return self.is_check and (bool(self.identified) or (is_named and not self.said_state and not self.places))

    @property
    def is_finding_out(self) -> bool:
        """Whether it is an order to find something out, or a question."""
        return (self.task.type == "searching" or self.is_asked) and not self.is_forbidden

    @property
    def is_wish(self) -> bool:
        """Whether it asks what somebody would have: "if she wants tea", "if he'd rather have water"."""
        return self.is_check and (self.verb in WISHING or "instead" in (*self.near, *self.behind))

    @property
    def leaves_open(self) -> bool:
        """Whether it is an order to check something that says no state of it."""
        is_order = self.task.type == "check_state" and self.is_asked
        return is_order and not self.wording.state and not self.asks_where

    @property
    def is_joined_check(self) -> bool:
        """Whether "and" or "or" may join it to the check before it."""
        return self.is_check and self.boundary in ("none", ",") and not self.far

    @property
    def is_unable(self) -> bool:
        """Whether it says that somebody cannot do something: "if you *can't open it*", "and *you can't lift it*"."""
        is_denied = self.wording.is_negated and {"can", "not"} <= {*self.near} and not self.is_forbidden
        return is_denied and not {"if", "whether", "when", "and", "or", "but"}.isdisjoint(self.near)

    @property
    def is_done_if_not(self) -> bool:
        """Whether an "if not" opens what is no look for something, which an "otherwise" could fall back on."""
        return self.turns == ("not",) and self.task.type not in FINDING_OUT and not self.is_forbidden

    @property
    def is_added_to_otherwise(self) -> bool:
        """Whether it is a further case for what an "if not" opens ("if not, *or if he's late*, ...")."""
        return self.far == ("else",) and self.near[:2] == ("or", "if") and self.is_check and not self.ends_sentence


_ANSWERS = frozenset(("yes", "no"))
_REPLYING = frozenset("refuse decline agree accept consent object comply oblige know remember recall".split())
_SAYING = frozenset(("say", "choose"))
"""What somebody does with what they are asked to choose among: "if she *says* tea"."""
CHOOSING = frozenset("depending whether if unless only_if when else fail not".split())
LEADING = frozenset(("motion", "following", "bringing", "placing", "taking"))
AROUND = frozenset("in home there here around about back".split())
"""Words for where somebody is who is here, or home."""
FINDING = frozenset(("searching", "bringing", "taking"))
FINDING_OUT = frozenset(("searching", "check_state"))
PRESENT = frozenset(
    "gone up empty out missing in away clear here there home back left present absent around inside outside upstairs "
    "downstairs free busy finished done available about nearby lost".split()
)
"""States that tell whether somebody or something is where they were looked for."""
