"""A clause: what surrounds one task, and what its words say for certain of it and of the clauses before."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from decomplex_bt.understanding.control_flow.arcs import Wording
from decomplex_bt.understanding.cues import ASKING_LEMMAS, OPPOSITES, WISHING, are_apart


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
    is_excepted: bool = False
    """Whether it stands under the "unless" of the clause before it."""
    ways: frozenset[str] = frozenset()
    """The words behind its verb that tell which way: "back", "out"."""
    opening: tuple[str, ...] = ()
    """The cues ahead of its verb but for those that say nothing of other clauses ("or somebody is *still* in"), or are
    of what is said in the clause before ("unless it's *after* ten or somebody is in")."""
    calls_off: bool = False
    """Whether all that is said to be done in its case is to leave what was ordered: "but if it's wet, *leave it*"."""
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
    """Whether it is "asked" if its verb can be done ("if you can find it"), or "denied" that what was asked of can be
    ("if you can't, ...")."""
    is_unwilling: bool = False
    """Whether it says that somebody won't do something: "if he won't come"."""
    is_only_then: bool = False
    """Whether it is to be done "only then"."""
    says_too: bool = False
    """Whether it ends in an "either" or "too": it is so of somebody or something else as well."""
    says_still: bool = False
    """Whether it asks if something is "still" so."""
    is_in_it: bool = False
    """Whether it asks what is in "it": "if there's room *in it*"."""
    identified: str = ""
    """The noun or name of who or what it asks if "it" is: "if it's the *plumber*"."""
    says_instead: bool = False
    """Whether it asks if something is so "instead": "if a child is there *instead*"."""
    forbids_order: bool = False
    """Whether a "don't" behind it forbids in its case what was ordered: "if she's in there *don't*, ..."."""
    is_past_forbidden: bool = False
    """Whether an "and" behind a comma goes on from an "otherwise" that only forbids: "otherwise don't wake her, *and
    lock up*"."""
    is_either_way: bool = False
    """Whether what it hangs on is said right ahead to make no difference: "whether you find it or not, *come back*"."""
    turns: tuple[str, ...] = ()
    """What turns to the other case ahead of its verb: "not" for an "if not" or the like, "otherwise" for the rest."""

    def names_same(self, other: Clause) -> bool:
        """Whether the objects of both may be one thing, by the words for it: "the old stove" and "the stove", not "the
        small box" and "the big box"."""
        is_head = bool(self.objects) and self.objects[-1:] == other.objects[-1:]
        return is_head and (self.thing <= other.thing or other.thing <= self.thing)

    def is_asked_again_after(self, first: Clause) -> bool:
        """Whether it asks if something is *still* as the condition before has it, in the same words, when something was
        done about it: "if it's red, restart it. Still red?", not "if it's dry, fold it. If it's still damp, ..."."""
        is_same = (self.wording.state or self.verb) == (first.wording.state or first.verb)
        is_check = self.task.type == "check_state"
        return is_check and self.says_still and is_same and self.wording.is_negated == first.wording.is_negated

    def is_absence_of(self, before: Clause) -> bool:
        """Whether it says no more than that whoever the task before should give or tell something to is not there:
        "take it to Anna, and if she's out, ..."."""
        is_left_with = self.says_too and self.is_of_person and before.task.type == "placing"
        is_handed = before.task.type in _HANDING or is_left_with  # "leave it with Tom, and if he isn't in either"
        if self.task.type != "check_state" or not is_handed or not self.is_of_somebody:
            return False
        if not self.is_of_person and before.number == "many":
            return False  # "they" may as well be what is given
        kinds = {kind for kind, _ in before.task.arguments}
        # not "in by six"
        is_all = max((j for _, indices in self.task.arguments for j in indices), default=0) >= self.last
        is_gone = self.wording.state in _GONE and not self.wording.is_negated
        is_away = self.wording.is_negated and (self.wording.state in AROUND or not self.places.isdisjoint(AROUND))
        return bool(kinds & {"recipient", "goal"}) and "unless" not in self.near and is_all and (is_gone or is_away)

    def is_failure_of(self, before: Clause, named: Clause) -> bool:
        """Whether it says no more than that the change before it failed: "unlock it, and if it won't open, ..." or "if
        the trunk won't open"; `named`: the clause up to there that last names a thing, which may be put in what is
        changed then ("put the shirts in the washing machine and start it. If *the machine* doesn't start, ...")."""
        is_one = not (self.number and before.number) or self.number == before.number
        is_opposite = self.wording.state is not None and OPPOSITES.get(self.wording.state) == before.wording.state
        is_change = before.task.type == "change_state" and is_one and not is_opposite
        is_where_put = before.has_pronoun and not before.objects and not named.receivers.isdisjoint(self.objects[-1:])
        is_of_it = self.says_undone or (self.says_named_undone and (self.names_same(named) or is_where_put))
        is_of_it = is_of_it or (before.wording.state == "on" and self.says_broken(named))
        return is_change and is_of_it and "unless" not in self.near

    def says_broken(self, named: Clause) -> bool:
        """Whether it asks if what was named last is out of order, which is found out by switching it on; not where that
        chooses between two orders ("switch it on, *or if it's broken* open the door")."""
        is_broken = self.is_check and self.wording.state in _BROKEN and not self.wording.is_negated
        is_broken = is_broken and "or" not in (*self.far, *self.near)
        return is_broken and (self.names_same(named) or (self.has_pronoun and not self.objects))

    def tries_out(self, before: Clause) -> bool:
        """Whether it asks if what was handled before works; of what was moved with an effort ("lift it") "it doesn't
        work" says that the effort failed."""
        is_handled = before.task.type in _MOVED and before.verb not in _STRAINING
        is_kept_out = self.verb == "fit" and before.task.type == "placing"
        is_of_thing = (
            self.is_check
            and self.verb in _FUNCTIONING
            and not is_kept_out
            and not self.is_of_person
            and bool(before.objects)
        )
        is_it = self.has_pronoun and not self.objects and "fail" not in self.near
        return is_handled and is_of_thing and (is_it or self.names_same(before))

    def is_guard_of(self, before: Clause) -> bool:
        """Whether it asks no more than whether the change before it is needed: "wash it if it's dirty", "fill it unless
        it's full", "turn the tv off if it's on"."""
        if before.task.type != "change_state" or not self.is_check or self.wording.state is None:
            return False
        is_needed = self.wording.state in (before.effects if self.wording.is_negated else before.needs)
        return is_needed and (self.names_same(before) or (self.has_pronoun and not self.objects))

    def undoes(self, before: Clause) -> bool:
        """Whether it takes back what the order before brings about: "light it" and "blow it out", "put it in the oven"
        and "take it out", "go there" and "come back"."""
        is_of_it = self.names_same(before) or (self.is_of_it and not self.objects)
        one, other = before.task.type, self.task.type
        if (
            one == other == "change_state"
        ):  # but "turn it off and on again", "empty it and fill it" is done at a stretch
            is_renewed = not self.ways.isdisjoint(("again", "back")) or "empty" in before.effects
            return is_of_it and not is_renewed and not before.effects.isdisjoint(self.needs)
        is_return = not (self.ways.isdisjoint(_RETURNING) or self.nouns - _RETURNING)
        is_gone = one in _LEADING and before.ways.isdisjoint(_RETURNING)
        if other == "motion" and is_return:
            return is_gone
        return is_of_it and ((one == "placing" and other == "taking") or (other in _LEADING and is_return and is_gone))

    def comes_through(self, before: Clause) -> bool:
        """Whether what it asks is what the order before brings about: "fill it" and "it's full", "start it" and "it's
        done", "turn the oven on" and "it's hot", "let her out" and "she's back", "put them in the oven" and "when
        they're brown"."""
        is_of_thing = self.names_same(before) or (self.is_of_it and not self.objects)
        is_sent = before.verb in _SENDING or before.task.type == "following" or "out" in before.ways
        if "back" in self.ways and is_sent:
            return is_of_thing or (self.is_of_somebody and not self.objects)
        is_reached = self.wording.state in before.effects and not self.wording.is_negated
        is_over = self.wording.state in _OVER or (self.wording.state is None and self.verb in _ENDING)
        is_worked = before.task.type == "placing" and not before.receivers.isdisjoint(_WORKING) and "when" in self.near
        if is_worked and self.wording.state is not None and self.number == before.number:
            return True
        is_heated = self.wording.state in _HEATED and not _HEATERS.isdisjoint(before.objects[-1:])
        is_run = "running" in before.effects and (is_over or (is_heated and not self.wording.is_negated))
        return is_of_thing and (is_reached or is_run)

    def is_only_of(self, order: Clause, before: Clause) -> bool:
        """Whether it asks about the thing of an order alone, and not about that of the order before: "turn the tv off
        and water the fern if it's dry", "fold the shirts and hang up the socks if they're damp". What is fetched or
        turned on may be so for the sake of the other order."""
        are_two = bool(before.nouns) and bool(order.objects) and before.nouns.isdisjoint(order.objects)
        is_fetched = before.task.type in _FINDING and order.task.type == "change_state"
        is_handed = any(kind == "recipient" for kind, _ in before.task.arguments)
        is_prepared = (is_fetched and not is_handed) or "running" in before.effects
        is_of_it = self.is_guard_of(order) or (self.is_check and (self.names_same(order) or self.takes_up(order)))
        return are_two and is_of_it and not is_prepared

    def takes_up(self, order: Clause) -> bool:
        """Whether its object is a pronoun that may mean the thing which the order right before names."""
        is_one = not (self.number and order.number) or self.number == order.number
        is_pronoun = (self.is_of_it or self.is_of_somebody) and not self.objects
        return is_pronoun and is_one and bool(order.objects) and not order.has_pronoun and not self.is_of_weather

    def is_fallback_for(self, before: Clause) -> bool:
        """Whether it is for where the order before fails, that is itself done where something else does: "look in the
        shed; failing that, try the porch; *failing that*, ask Tom". An "otherwise" behind a "failing that" turns back
        to where the first did not fail."""
        ahead, own = {*before.far, *before.near}, {*self.far, *self.near}
        are_orders = self.task.type != "check_state" != before.task.type and self.sentence - before.sentence < _FAR
        is_opened = not own.isdisjoint(_FALLING_BACK) and self.near != ("and",)
        is_other = self.is_otherwise and not before.is_otherwise and "fail" not in own
        is_plain = own.isdisjoint(_CHOOSING - _FALLING_BACK) and not (self.is_forbidden or before.is_forbidden)
        return are_orders and not ahead.isdisjoint(_FALLING_BACK) and is_opened and is_plain and not is_other

    def is_choice_beside(self, before: Clause) -> bool:
        """Whether it is ordered instead of the order before, as it may be: "close the window *or turn the heater on*";
        not where a condition may choose, nor with what is forbidden."""
        are_orders = self.task.type != "check_state" != before.task.type and self.sentence == before.sentence
        is_joined = self.near == ("or",) and not self.far and self.boundary in ("none", ",")
        is_free = not {*before.far, *before.near, *before.behind, *self.behind} & _CHOOSING
        return are_orders and is_joined and is_free and not (self.is_forbidden or before.is_forbidden)

    def is_case_beside(self, first: Clause) -> bool:
        """Whether it tests another state of what the other tests, as far as its words say: "if it's lukewarm" beside
        "if the soup is hot"."""
        state, other = self.wording.state or "", first.wording.state or ""
        is_other_state = self.said_state != first.said_state and not are_apart(state, other)
        is_same_verb = self.verb == first.verb or {self.verb, first.verb} <= _BEING or (self.is_wish and first.is_wish)
        is_one = not (self.number and first.number) or self.number == first.number
        # "that" may be another thing
        is_of_it = (self.is_of_somebody or (self.is_of_it and bool(self.number))) and not self.objects
        is_of_it = is_of_it or (self.is_of_some and first.number != "one")
        is_same = is_one and (self.names_same(first) or is_of_it) and not self.is_of_weather
        return is_other_state and is_same_verb and (is_same or (self.is_of_weather and first.is_of_weather))

    def is_elsewhere_than(self, first: Clause) -> bool:
        """Whether it asks if who or what the other looks for is in another place."""
        is_of_them = self.names_same(first) or (self.has_pronoun and not self.objects)
        are_places = self.is_of_whereabouts and first.is_of_whereabouts and bool(self.places) and bool(first.places)
        are_stated = not self.wording.is_negated and not first.wording.is_negated
        return is_of_them and are_places and are_stated and self.places.isdisjoint(first.places)

    def is_rival_of(self, first: Clause) -> bool:
        """Whether it asks what cannot be where the other holds: if it is another thing ("if it's the phone, ..., if
        it's the doorbell, ..."), or if something is so instead."""
        is_other = bool(self.identified and first.identified) and self.identified != first.identified
        are_stated = not (self.wording.is_negated or first.wording.is_negated)
        return self.is_check and are_stated and (is_other or self.says_instead)

    def is_content_of(self, first: Clause) -> bool:
        """Whether it asks if something is in what the other asks to be empty, or if there is room in what that asks to
        be full: "if the basket is empty, ...; if *it still contains clothes*, ..."."""
        words = {self.verb, *self.thing} if self.is_check else frozenset()
        is_held = self.verb in _HOLDING or self.says_there_is
        is_of_it = (self.has_pronoun and self.is_in_it) or (self.verb in _HOLDING and "it" in self.thing)
        is_room = not _ROOM.isdisjoint(words)
        state = first.wording.state
        is_other = (state in _EMPTY and not is_room) or (state in _FILLED and is_room)
        is_other = is_other and _DAMAGES.isdisjoint(words) and (self.verb != "have" or self.says_still or self.is_in_it)
        are_stated = not (self.wording.is_negated or first.wording.is_negated)
        is_one = bool(first.objects) and first.number != "many"
        return self.is_check and first.is_check and is_held and is_of_it and is_other and are_stated and is_one

    def is_case_against(self, order: Clause) -> bool:
        """Whether it calls off the order before it in a case that does not come about through that: "mow the lawn, but
        if it's wet, leave it", not "turn it on, and if it won't start, leave it"."""
        is_gone = self.wording.is_contrary and (self.names_same(order) or not self.objects)
        is_outcome = self.says_undone or self.says_named_undone or is_gone or "fail" in self.near
        is_plain = self.is_check and not is_outcome and not self.comes_through(order) and not self.wording.is_echo
        return self.calls_off and is_plain and order.task.type in _CALLED_OFF and not order.is_forbidden

    @property
    def needed(self) -> frozenset[str]:
        """The nouns of what an order needs as it is when it begins: whatever it changes, and its places, not what is
        only to be had through it ("fetch *the milk*")."""
        changed = self.objects if self.task.type == "change_state" else ()
        return self.receivers | self.places | frozenset(changed)

    @property
    def effects(self) -> frozenset[str]:
        """The states that an order to change something ends in."""
        return _NEEDED.get(self.wording.state or self.verb, (_NEVER, _NEVER))[0]

    @property
    def needs(self) -> frozenset[str]:
        """The states that an order to change something ends."""
        return _NEEDED.get(self.wording.state or self.verb, (_NEVER, _NEVER))[1]

    def is_answer_to(self, before: Clause, others: Sequence[Clause]) -> bool:
        """Whether it says how somebody answered what the task before asked ("ask Lea if she wants soap, and if she
        does, ..."), where that is in the same sentence, or the `others`, the conditions so far, are of things."""
        is_fitting = self.verb == "do" or not before.question.isdisjoint((self.verb, "'s", "\u2019s"))
        is_of_them = self.is_of_somebody and not any(other.number == "many" for other in others)
        is_answer = self.says_only_whether and bool(before.question) and is_fitting
        is_of_things = not any(other.is_of_somebody or other.may_be_of_person for other in others)
        is_told = self.sentence == before.sentence and self.is_of_somebody
        return is_answer and (is_told or (is_of_things and (self.is_of_person or is_of_them)))

    @property
    def says_answer(self) -> bool:
        """Whether it says that somebody answers yes, or no."""
        return self.is_check and self.wording.state in _ANSWERS

    @property
    def says_reply(self) -> bool:
        """Whether it says how somebody takes what they are asked to do: "if he refuses", "if she won't do it"."""
        is_reply = self.verb in _REPLYING or self.is_unwilling or self.says_answer
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

    def repeats(self, before: Clause) -> bool:
        """Whether it only says again what is ordered before, to put something ahead of it or behind it: "before you
        bring it", "when you've brought it"."""
        is_same = self.verb == before.verb and self.task.type == before.task.type
        is_of_it = self.is_of_it or (bool(self.objects) and self.names_same(before))
        return is_same and is_of_it and ("before" in self.near or self.is_had_done)

    def forbids_same(self, before: Clause) -> bool:
        """Whether one of both forbids what the other orders, with the same verb: "don't open it if it's windy,
        otherwise *open it*", "water it, but if it's wet *don't water it*"."""
        is_same = self.verb == before.verb and self.task.type == before.task.type
        is_bare = all(kind != "object" for kind, _ in self.task.arguments)
        is_of_it = self.is_of_it or is_bare or (bool(self.objects) and self.names_same(before))
        is_near = self.sentence == before.sentence or (self.is_otherwise and self.sentence - before.sentence == 1)
        is_near = is_near and self.receivers <= before.receivers
        return self.is_forbidden != before.is_forbidden and is_same and is_of_it and is_near

    def may_repeat(self, before: Clause) -> bool:
        """Whether both may be one and the same order: of one type, to one effect, and of things that are not named
        apart."""
        is_same = not (self.objects and before.objects) or self.names_same(before)
        is_other = self.verb != before.verb and self.effects != before.effects and "do" not in (self.verb, before.verb)
        is_of_thing = self.has_pronoun or bool(self.objects)
        # "load it, but don't start it until ...", not "don't start until ..."
        is_other_change = self.task.type == "change_state" and is_other and is_of_thing
        return self.task.type == before.task.type and is_same and not is_other_change

    def is_opposite_of(self, first: Clause) -> bool:
        """Whether it tests the opposite of an earlier condition, of the same thing by name: "if the tv is off, ..., if
        the tv is on, ..."."""
        one, other = self.wording, first.wording
        is_other_state = one.is_opposite_of(other) or other.is_opposite_of(one)
        is_denied = one.state is not None and one.state == other.state and one.is_negated != other.is_negated
        is_turned = is_denied or (is_other_state and one.is_negated == other.is_negated)
        is_same = self.names_same(first) or (self.says_answer and self.is_of_somebody)
        return self.is_check and first.is_check and is_turned and is_same and not self.is_of_other_place(first)

    def is_of_other_place(self, first: Clause) -> bool:
        """Whether both say where the thing is of which they test a state, and that is not one place: "the glass on the
        desk", "the glass on the shelf"."""
        is_of_state = self.wording.state is not None and first.wording.state is not None
        places, others = self.places - AROUND - _THERE, first.places - AROUND - _THERE
        return is_of_state and bool(places) and bool(others) and places.isdisjoint(others)

    @property
    def is_trailing(self) -> bool:
        """Whether it stands behind what hangs on it: "bring the dog in if he's still out"."""
        return self.boundary == "none" and self.ends_sentence

    @property
    def is_first_anyway(self) -> bool:
        """Whether it is to be done first in any case: "but whatever you do, fill it first"."""
        words = {*self.far, *self.near}
        is_first = "first" in (*self.near, *self.behind)
        return "either_way" in words and is_first and {"if", "unless", "else", "when"}.isdisjoint(words)

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

    def may_fail_as(self, after: Clause) -> bool:
        """Whether it is a search of which a later clause tells that it failed: "find my keys. ... If you can't see
        them"."""
        are_searches = self.task.type == after.task.type == "searching"
        is_same = after.names_same(self) or (after.has_pronoun and not after.objects)
        return are_searches and is_same and after.wording.is_negated and "if" in after.near

    def needs_found(self, check: Clause) -> bool:
        """Whether it fetches what an order to check asks for, so that there must be such a thing: "see if there's any
        milk *and bring me some*"."""
        is_asked = check.task.type == "check_state" and check.is_asked and "whether" in check.behind
        is_of_place = check.wording.state is None or check.wording.state in _PRESENT | _ARRIVED
        is_joined = self.boundary == "none" and self.near[-1:] == ("and",) and {"if", "so"}.isdisjoint(self.near)
        is_of_it = self.has_pronoun and not self.objects and self.task.type in ("bringing", "taking", "placing")
        is_plain = not self.is_forbidden and not check.wording.is_negated and bool(check.thing)
        return is_asked and is_of_place and is_joined and is_of_it and is_plain

    @property
    def is_check(self) -> bool:
        """Whether it states what is to be checked ("it is wet"), and is neither an order to check nor a question."""
        return self.task.type == "check_state" and not self.is_asked

    @property
    def is_question(self) -> bool:
        """Whether it asks ("is it on?", "lamp on?"), and is no order to check."""
        return self.is_asked and "whether" not in self.behind and self.verb not in ASKING_LEMMAS

    @property
    def is_wish(self) -> bool:
        """Whether it asks what somebody would have: "if she wants tea", "if he'd rather have water"."""
        return self.is_check and (self.verb in WISHING or "instead" in (*self.near, *self.behind))

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

    def is_other_case_than(self, before: Clause) -> bool:
        """Whether it is a further case for what the other, which only says whether something is so, is said for ("if he
        isn't, *or if he's late*, ...")."""
        is_added = self.near[:2] == ("or", "if") or self.opening == ("or",)
        is_next = self.sentence == before.sentence and self.boundary in ("none", ",") and not self.ends_sentence
        return is_added and is_next and self.is_check and before.says_only_whether and "if" in before.near

    @property
    def is_done_if_not(self) -> bool:
        """Whether an "if not" opens what is no look for something, which an "otherwise" could fall back on."""
        return self.turns == ("not",) and self.task.type not in FINDING_OUT and not self.is_forbidden

    @property
    def is_added_to_otherwise(self) -> bool:
        """Whether it is a further case for what an "if not" opens ("if not, *or if he's late*, ...")."""
        return self.far == ("else",) and self.near[:2] == ("or", "if") and self.is_check and not self.ends_sentence

    def is_of_other_state(self, first: Clause) -> bool:
        """Whether it tests a state that has nothing to do with the one that an order to check asks ("check if it is
        done, and if it's burnt, ...", but "if it's still wet": it is not done then)."""
        state, other = self.wording.state, first.wording.state
        is_order = first.task.type == "check_state" and first.is_asked and not first.is_question
        if state is None or other is None or not is_order or (self.says_still and other in _ENDS):
            return False
        return not self.objects and self.has_pronoun and are_apart(state, other)

    def asks_of(self, order: Clause, first: Clause) -> bool:
        """Whether it asks right behind an order after the state of what that is to be done with, and that is another
        thing, and another state, than the first asks ("is the tv on? ... close the window if *it's open*")."""
        state, other = self.wording.state, first.wording.state
        is_behind = self.boundary == "none" and self.near[:1] == ("if",) and self.has_pronoun and not self.objects
        if not (is_behind and self.is_check and state is not None and other is not None and are_apart(state, other)):
            return False
        is_own = bool(order.objects) and order.objects[-1] not in first.nouns  # "the bathroom light", "... door"
        return is_own and self.sentence == order.sentence and "or" not in order.near

    def turns_on_report(self, report: Clause) -> str:
        """ "so" or "else", by which it is done in one case of what is to be told right ahead of it ("tell me if it's on
        and switch it off *if so*", "... and get some *if not*"); "" where it is not."""
        asking = {"whether", "if"} & {*self.far, *self.near}
        is_told = report.task.type == "informing" and bool(asking) and self.sentence == report.sentence
        return self.behind[-1] if is_told and self.behind[-1:] in (("so",), ("else",)) else ""

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

    def is_apart_from(self, order: Clause) -> bool:
        """Whether it asks if nobody is in a place that an order has nothing to do with."""
        known = order.nouns | order.places | order.receivers
        is_handed = order.task.type == "bringing" and bool(order.receivers)
        is_order = order.task.type in _LEADING | {"change_state"} and not is_handed
        is_elsewhere = bool(self.places) and self.places.isdisjoint(known | _THERE)
        return is_order and self.is_check and self.is_of_nobody and is_elsewhere

    def is_of_other_matter(self, first: Clause) -> bool:
        """Whether it has nothing to do with what the other asks: it asks about the weather, or if nobody is there, and
        that about a thing."""
        is_other_weather = self.is_of_weather and first.task.type == "check_state" and not first.is_of_weather
        return is_other_weather or self.is_of_nobody_at(first)

    def is_of_another(self, first: Clause) -> bool:
        """Whether its words say that it is no mention of an earlier condition: it is of another matter or of a thing
        elsewhere, or asks the same of another thing ("if there's no milk, ..., if there's no tea, ..."), or whether
        something is missing whose state the other tests, or it tests a state, and that of many things where the other
        is about one (or the other way round), or of what the other asks the place of."""
        own = {kind for kind, _ in self.task.arguments}
        is_of_other = self.asks_same_of_another(first) or self.is_of_other_matter(first)
        if is_of_other or self.asks_for_what_had_state(first) or self.is_of_other_place(first):
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
        ("on start", "on running lit", "off out"), ("off stop", "off out", "on running lit"),
        ("open", "open ajar", "closed shut"), ("close shut", "closed shut", "open ajar"),
        ("lock bolt", "locked bolted", "unlocked open"), ("unlock unbolt", "unlocked open", "locked bolted shut"),
        ("heat warm reheat microwave", "hot warm", "cold cool lukewarm tepid chilly"),
        ("cool chill", "cold cool chilled", "warm hot lukewarm"),
        ("clean wash rinse wipe scrub mop sweep vacuum hoover dust polish", "clean washed spotless",
         "dirty filthy muddy dusty sticky stained grubby greasy unwashed"),
        ("fill refill run", "full", "empty low"), ("empty", "empty", "full overflowing"),
        ("dry", "dry", "wet damp soaked"),
        ("iron press", "ironed smooth", "wrinkled creased crumpled"),
        ("charge recharge", "charged full", "flat low dead empty"), ("water", "wet moist damp", "dry thirsty"),
        ("cover", "covered", "uncovered bare"), ("uncover", "uncovered bare", "covered"),
        ("light", "lit", "unlit out"), ("blow snuff extinguish", "out unlit", "lit burning"),
        ("make", "made", "unmade"), ("fold", "folded", "unfolded crumpled"),
        ("plug", "plugged", "unplugged"), ("unplug", "unplugged", "plugged"),
    )
    for verb in verbs.split()
}  # fmt: skip
"""What verbs of change, or the states that they bring about, are for: the states they end in, and those they end."""
_HOLDING = frozenset("contain hold have".split())
_DAMAGES = frozenset("hole crack tear rip dent scratch leak chip stain".split())
"""What is in something though it may be empty."""
_ROOM = frozenset(("room", "space"))
_EMPTY = frozenset(("empty",))
_FILLED = frozenset(("full", "packed", "crammed"))
_ANSWERS = frozenset(("yes", "no"))
_REPLYING = frozenset("refuse decline agree accept consent object comply oblige".split())
_IFS = frozenset(("if", "unless", "only_if"))
_BEING = frozenset(("be", "'s", "\u2019s", "s"))
_CHOOSING = frozenset("depending whether if unless only_if when else fail not".split())
_FALLING_BACK = frozenset(("else", "fail"))
_FAR = 2
"""From so many sentences on a "failing that" is not about the order before [sentences]."""
_LEADING = frozenset(("motion", "following", "bringing", "placing", "taking"))
_SENDING = frozenset(("let", "send"))
_RETURNING = frozenset(("back", "home"))
_OVER = frozenset("done finished ready over complete through".split())
_BROKEN = frozenset("broken faulty busted bust kaput knackered damaged order blink".split())
"""States in which nothing can be switched on: "out of *order*", "on the *blink*"."""
_ENDS = frozenset("done finished ready over cooked baked clean dry".split())
"""States that something comes to in the end: what is still otherwise has not."""
_WORKING = frozenset("oven stove hob microwave toaster grill pan pot fridge freezer".split())
"""Places where a thing is put for what becomes of it there."""
_HEATED = frozenset("hot warm heated preheated".split())
_HEATERS = frozenset(
    "oven stove hob hotplate iron kettle grill barbecue heater heating radiator boiler griddle sauna".split()
)
"""What gets hot once it is switched on."""
_ENDING = frozenset("finish end stop boil beep".split())
_USED = frozenset("free busy empty available occupied taken use unused vacant unoccupied deserted quiet loud".split())
"""States that tell whether somebody is there."""
_CALLED_OFF = frozenset("taking placing bringing change_state".split())
"""The types of orders that may be called off: not what is looked for, asked or waited for."""
_HANDING = frozenset(("bringing", "informing"))
_MOVED = frozenset(("taking", "placing", "bringing"))
_STRAINING = frozenset("lift pull push drag move shift heave pry remove peel hide fish squeeze stuff".split())
_FUNCTIONING = frozenset("work function write run fit light start ring".split())
"""What a thing does that is as it should be."""
_MISSING = frozenset(("missing", "gone", "lost"))
_THERE = frozenset(("there", "here"))
_NO_THINGS = frozenset("none one some any drop".split())
_GONE = frozenset(("out", "away", "gone"))
AROUND = frozenset("in home there here around about back".split())
"""Words for where somebody is who is here, or home."""
_ARRIVED = frozenset("left come arrived delivered".split())
_FINDING = frozenset(("searching", "bringing", "taking"))
FINDING_OUT = frozenset(("searching", "check_state"))
_PRESENT = frozenset(
    "gone up empty out missing in away clear here there home back left present absent around inside outside upstairs "
    "downstairs free busy finished done available about nearby lost".split()
)
"""States that tell whether somebody or something is where they were looked for."""
