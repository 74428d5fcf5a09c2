"""Cue phrases: the words that say how tasks hang together, by class (if, otherwise, either way, before that, ...)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType

PHRASES: Mapping[str, tuple[str, ...]] = MappingProxyType(
    {
        # opens a condition with a verb of its own
        "if": (
            "if", "in case", "in case that", "in case of", "in the case that", "in the event of", "just in case", "provided", "provided that", "providing", "providing that", "as long as", "so long as",
            "assuming", "assuming that", "supposing", "suppose", "on condition that", "on the condition that", "in the event",
            "in the event that", "given that", "granted", "iff", "as far as", "if in fact", "if by any chance", "if ever", "if indeed",
            "subject to", "to the extent that", "on the off chance", "on the off chance that", "conditional on", "contingent on", "what if",
        ),
        "only_if": ("only if", "only when", "but only if", "but only when", "only in case", "only as long as", "only provided", "only do if", "only do it if", "only do that if", "only do so if"),
        "even_if": ("even if", "even though", "although", "whether or not", "even when"),
        "unless": ("unless", "except if", "except when", "if not already", "but not if", "not if", "but not when", "save if", "save where", "save when", "except where", "except in case", "other than if"),
        "whether": ("whether", "whether or not"),
        "depending": ("depending on", "depending", "depends on"),
        "when": ("when", "whenever", "the moment", "the minute", "every time", "the instant"),
        # stands for a whole condition, without a verb that is a task
        "so": (
            "if so", "if yes", "if yeah", "if that is the case", "in that case", "in which case", "if true", "if possible", "if you can",
            "if that works", "if it works", "if it does", "if you do", "if you succeed", "if successful", "if that is so", "if positive", "if you manage",
            "if any", "in this case", "in such a case", "in the latter case", "in the second case", "in the positive case", "in the affirmative case", "on success", "if affirmative", "in that event", "in which event", "if that is fine", "if that is ok", "if that goes well",
        ),
        "else": (
            "otherwise", "or else", "else", "elsewise", "alternatively", "as an alternative", "if not", "or if not", "and if not", "if no",
            "in the other case", "in any other case", "in all other cases", "in every other case", "in the opposite case", "in the negative case", "if negative", "if not yet", "failing which", "in its absence", "if neither", "if none", "in case not",
            "if not even that", "on the other hand", "if otherwise",
        ),
        "fail": (
            "failing that", "failing this", "failing both", "failing either", "failing him", "failing her", "failing them", "on failure", "in case of failure", "should that fail", "should this fail", "should it fail", "if nothing happens", "still nothing",
            "if that does nothing", "if that does not help", "if that does not do it", "if that does not do the trick", "if it does not help", "if nothing", "if you strike out", "if you come up empty", "if you really can not", "if you just can not", "if you simply can not", "if you absolutely can not",
            "should this prove impossible", "should that prove impossible", "if that proves impossible", "that proving impossible", "should the attempt fail", "if that is beyond you",
            "should you fail", "should you come up empty", "should you not succeed", "should that not work", "should this not work", "should it not work", "if you can not manage", "if you can not manage it", "if you can not manage that", "if you can not manage to",
            "if you can not do it", "if you can not do that", "if you are not able to", "if not able", "if you get nowhere", "if that gets you nowhere", "if there is no answer", "no answer", "if that fails", "if this fails", "if it fails", "if you fail", "if that does not work",
            "if it does not work", "if this does not work", "if that will not work", "if it will not work", "if that is not possible", "if it is not possible", "if not possible",
            "if you can not", "if u can not", "if you could not", "if you are unable", "if unable", "if unsuccessful", "if impossible", "if that is impossible", "no luck", "no joy",
            "no dice", "no good", "no success", "no go", "nothing doing", "as a last resort", "last resort", "as a fallback", "fallback", "plan b", "worst case",
            "if all else fails", "if you do not succeed", "if you do not", "if it does not", "if it will not", "if you have no luck", "when that fails",
            "when you can not", "if you do not manage", "if there is a problem", "if something goes wrong", "if not successful", "without success", "in vain",
        ),
        # ends what a condition governs
        "either_way": (
            "either way", "in either event", "in any event", "whichever", "whichever way", "either which way", "whatever", "no matter", "under both plans", "in both events", "like it or not", "whether it does or not", "whether it is or not", "whether or no", "in any case", "in either case", "in both cases", "any case", "anyway", "anyways", "anyhow", "regardless", "regardless of that", "no matter what",
            "whatever happens", "whatever the case", "whatever you find", "whatever the outcome", "whatever the answer", "whichever it is", "come what may", "at any rate", "one way or another",
            "one way or the other", "irrespective", "in every case", "both ways", "whatever it is", "always", "in all cases", "either case",
            "apart from that", "apart from this", "aside from that", "aside from this", "other than that", "independently of that", "independently of this", "independent of that", "independent of this",
        ),
        # order
        "then": ("then", "and then", "next", "so then", "only then"),
        "after_that": (
            "after that", "after this", "afterwards", "afterward", "after wards", "later", "later on", "thereafter", "subsequently", "when done", "once done", "when you are done",
            "once you are done", "when that is done", "once that is done", "when finished", "once finished", "having done that", "after you have done that", "after doing that",
            "when you are finished", "with that done", "that done", "following that", "from there", "once you have done that", "after which", "upon that", "when that is finished",
        ),
        "before": ("before", "prior to", "ahead of", "by the time"),
        "before_that": (
            "before that", "before this", "before which", "prior to which", "before you do that", "before doing that", "before you do", "beforehand",
            "but first", "prior to that", "ahead of that", "before doing so", "before you do so", "before you do this",
            "even before that", "even before this", "earlier still", "even earlier", "earlier than that", "sooner than that", "until then", "till then", "up to then",
        ),
        "before_all": (
            "before any of that", "before any of this", "before any of it", "before all that", "before all this", "before all of that", "before all of this", "before you do any of that",
            "before you do any of this", "before doing any of that", "before doing any of this", "before either of those", "before you do either", "ahead of all that", "ahead of all this",
            "ahead of both", "before both", "prior to both", "prior to all that", "prior to any of that", "prior to all of which", "before all of which",
            "ahead of everything", "ahead of everything else", "ahead of any of that", "ahead of any of this", "ahead of all of that", "ahead of all of this", "ahead of anything", "ahead of anything else",
            *(f"before {start} {all_of}" for start in ("you start", "you start on", "you begin", "you begin on", "starting", "starting on", "you get to", "you get started on") for all_of in ("any of that", "any of this", "any of it", "all that", "all this", "all of that", "all of this")),
            "before everything", "before anything at all", "earlier than all that", "earlier than all this", "earlier than any of that", "earlier than any of this", "even before all that", "even before any of that",
        ),
        "after": ("after", "once", "as soon as", "soon as", "so soon as", "directly", "now that", "having", "upon", "immediately after", "right after"),
        "until": ("until", "till", "til", "not until", "until after", "no sooner than", "not earlier than",
            *(f"{word} before {who}" for word in ("not", "never") for who in ("you", "i", "we", "he", "she", "they")),
        ),
        "first": (
            "first", "firstly", "first of all", "first off", "to start with", "to begin with", "start by", "begin by", "start with", "before anything else", "before anything", "first thing",
            "before everything else", "at first", "step one", "for starters", "right at the start", "at the very start", "at the very beginning", "very first", "begin with", "at the outset",
        ),
        "last": (
            "last", "lastly", "last of all", "last thing", "at last", "finally", "in the end", "at the end", "at the very end", "to finish", "to top it off",
            "final thing", "at the close", "right at the end", "last but not least", "to end with", "to conclude", "very last", "to round off",
        ),
        "also": ("also", "too", "as well", "in addition", "additionally", "plus", "besides", "moreover", "on top of that", "likewise", "same for", "same goes for"),
        "while": ("while", "whilst", "meanwhile", "in the meantime", "at the same time", "on your way", "on the way", "while you are at it", "as you", "in the meanwhile"),
        # within a clause
        "not": (
            "not", "never", "nothing", "nobody", "none", "nowhere", "neither", "nor", "no", "no longer", "no more", "no one", "not any",
            "unable", "cannot", "not yet", "hardly", "no sign of",
        ),
        "either": ("either", "neither"),
        "instead": ("instead", "rather", "in its place"),
        "still": ("still", "already", "yet"),
        "can": ("can", "could", "able", "manage", "possible", "possibly"),
        "but": ("but", "except that", "however", "though", "although", "only"),
        "or": ("or",),
        "and": ("and", "&", "n"),
        "please": ("please", "pls", "plz", "kindly", "could you", "can you", "would you", "will you", "i want you to", "i need you to", "i would like you to", "would you mind if i asked you to", "would you mind if i ask you to", "do you mind if i ask you to", "do you mind if i asked you to", "mind if i ask you to", "mind if i asked you to", "may i ask you to", "could i ask you to", "can i ask you to"),
        "there": ("there",),
    }
)  # fmt: skip
"""Phrases of each class in normal form (see `normal_form`). Of overlapping phrases the longest counts, of equal ones each."""

GOVERNING = frozenset(("if", "only_if", "unless", "whether", "when", "depending"))
PRO_FORMS = frozenset(("so", "else", "fail"))
SIGNALS = (
    "if", "only_if", "unless", "when", "else", "fail", "so", "either_way", "then", "after_that", "before",
    "before_that", "before_all", "after", "until", "first", "last", "either", "also", "while", "but", "or", "and", "not",
    "instead", "depending", "whether", "even_if",
)  # fmt: skip
"""The cues that are features one by one."""
STRONG = frozenset(
    ("if", "only_if", "unless", "when", "else", "fail", "so", "either_way", "before", "after", "until", "whether")
)
"""Those that alone say that one task hangs on another, or in which order they come."""

WISHING = frozenset("want like prefer fancy".split())
"""Verbs, by their lemmas, of what somebody would have."""
ASKING_LEMMAS = frozenset(
    "check see find look verify ask tell know wonder determine confirm ensure discover inspect test learn let figure suss notice make establish sure certain doubt report say examine".split()
)
"""What stands before an "if" that reports or checks and opens no condition ("see if", "find out if", "let me know if")."""

_NORMAL = {
    "n't": "not", "nt": "not", "ca": "can", "wo": "will", "'s": "is", "'re": "are", "'ll": "will",
    "'ve": "have", "it's": "it is", "are": "is", "was": "is", "were": "is", "u": "you", "isnt": "is not", "cuz": "because", "ur": "your",
}  # fmt: skip


def normal_form(word: str) -> str:
    """A token as the phrases spell it: contractions written out, forms of "be" as "is"."""
    return _NORMAL.get(word, word)


def _build_table() -> dict[tuple[str, ...], tuple[str, ...]]:
    table: dict[tuple[str, ...], tuple[str, ...]] = {}
    for name, phrases in PHRASES.items():
        for phrase in phrases:
            key = tuple(normal_form(word) for word in phrase.split())
            if name not in table.get(key, ()):
                table[key] = (*table.get(key, ()), name)
    return table


TABLE = _build_table()
"""The classes of every phrase, by its words in normal form."""
LONGEST = max(map(len, TABLE))
"""The words of the longest phrase."""


CONDITIONAL = frozenset(
    "if only_if unless when until before before_that before_all after so else fail depending".split()
)
"""With one of these in its sentence a prohibition may be a condition's or an order's ("don't go until …"): that is for
the flow to say."""


def last_of(names: Sequence[str], wanted: frozenset[str]) -> str:
    """The last of `names` that is wanted, or "none"."""
    return next((name for name in reversed(names) if name in wanted), "none")
