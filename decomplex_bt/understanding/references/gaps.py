"""Gaps: what has to be resolved, words that refer or arguments left unsaid."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from decomplex_bt.domain.clauses import AIR, WEATHER
from decomplex_bt.domain.ontology import Ontology
from decomplex_bt.instruction import Argument, Task
from decomplex_bt.understanding.bare_states import bare_state
from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.amounts import is_amount, is_half
from decomplex_bt.understanding.references.chunks import head_of, is_child, stripped
from decomplex_bt.understanding.references.phrases import degree_asked, is_placed, is_pointing
from decomplex_bt.understanding.vocabulary import ONES, PRONOUNS, QUANTIFIERS

REFERRING = PRONOUNS
PREDICATE = "predicate"
"""The type of a gap that a state or a place fills: what a check leaves out in "if it is"."""

COUNTS = frozenset("one two three four five six few couple pair".split())
_LEADING = frozenset(
    "the that this these those other others another a an each both either of same all whole thing lot former latter "
    "place machine inside where".split()
)
_KINDS = frozenset("white red brown black green wholemeal rye plain semi-skimmed decaf".split())
"""What tells kinds of food and drink apart, which the tagger may take for nouns."""
_TELLING = frozenset("spare yellow blue grey gray pink orange purple".split())
_ORDINALS = frozenset("first second third fourth fifth last next".split())
"""What tells which of those named, not of what kind; see `ordinals`."""
_ALONE = frozenset("inside five six both either each none".split())
_SINGLE = frozenset("it them him her this that these those".split())
_MEASURES = frozenset(
    "glass cup mug bowl jug bottle spoonful bit piece slice drop bucket bag packet pinch splash portion helping "
    "handful bunch stack set bowlful litre liter pint pound loaf sheet tube jar basketful dash squirt".split()
)
"""What there is so much of something in, or of it, told alone, too: "chop *a bit*"."""
_AMOUNTS = _MEASURES | frozenset("plate pan pot box tin half third quarter".split())
"""What there may be so much of: "a plate *of it*"."""
_AND = frozenset(("and", "&"))
_CLAUSE_ENDS = frozenset("and but or then if unless when before after until please".split())
DENYING = frozenset(("not", "n't"))
_YET = frozenset("already yet still anymore".split())
_BEING = frozenset(("be", "look", "seem", "feel"))
_AIR = AIR | {"late", "early"}
"""States of the day or the room, of which "is cold" may say what it names nothing for."""
_OPENING = frozenset(("if", "when", "unless", "and", "but", "case"))
_SIDES = frozenset(
    tuple(phrase.split())
    for phrase in (
        "on top of", "on the top of", "in front of", "to the left of", "to the right of", "on the left of",
        "on the right of", "next to", "close to", "beside", "behind", "under", "underneath", "by", "near",
    )
)  # fmt: skip
"""Prepositions for where a thing is by another one."""
_LONGEST_SIDE = max(map(len, _SIDES))
ASIDE = frozenset(("message", "manner", "state", "direction"))
"""Arguments that say something themselves, and refer only where they are no more than one word that does."""
_TAKEN_UP = frozenset(
    "it them him her one another any some mine his hers ours yours theirs those these".split()
)  # "that" is mostly what was said or done
NAMING_FORMS = frozenset(("rest", "sort", "measure", "told"))
"""Forms of words that may as well mean what they say: "bring me *a glass*"."""
_REST = frozenset(("rest", "remainder"))
_SORTED = frozenset("any those some".split())
_SORTING = frozenset("that which who with without in on from under left".split())
"""What tells which of them: "any *that* have holes", "those *without* lids"."""
OWN = {"mine": "my", "his": "his", "hers": "her", "yours": "your", "ours": "our", "theirs": "their"}

DETERMINERS = QUANTIFIERS | _LEADING | COUNTS | frozenset(OWN.values())


@dataclass(frozen=True, slots=True)
class Gap:
    """Something to be resolved: an argument's words, or an argument that was not said (`tokens` empty at the task).

    `word`: the head of the words, "" where unsaid; `form`: how the words are built, which tells how to spell what fills
    them; `preposition`: the word before them; `is_certain`: whether something is left out for certain.
    """

    task: Task
    type: str
    position: int
    word: str
    form: str = "pronoun"
    preposition: str = ""
    tokens: range = range(0)
    is_required: bool = False
    is_certain: bool = False


def gap_of(document: Document, task: Task, argument: Argument) -> Gap | None:
    """The gap that an argument's words leave to be resolved, or None where they name what they mean; of "her on the
    porch" it is who that is."""
    if argument.span is None:
        return None
    tokens = document.indices(argument.span)
    if argument.type in ASIDE and not _is_taken_up(document, tokens):
        return None
    inner = _landmark(document, tokens) or stripped(document, tokens)
    if not inner:
        return None
    joined = _joined(document, inner)
    if joined is not None:
        return Gap(task, argument.type, joined, document.tokens[joined].lower, "joined", "", range(joined, joined + 1))
    if is_placed(document, inner):
        inner = inner[:1]
    form = _form(document, inner) or ("kind" if _is_kind(document, task, argument, inner) else None)
    is_amount_alone = form is None and argument.type == "object" and is_amount(document, tokens)
    if is_amount_alone:
        inner, form = tokens, "half" if is_half(document, tokens) else "count"
    if form is None:
        return None
    before = inner.start - 1
    preposition = document.tokens[before].lower if before >= tokens.start else ""
    head = document.tokens[inner.stop - 1] if form == "part" else document.tokens[head_in(document, inner)]
    word = "'s" if form == "own" and head.lower not in OWN else head.lower
    if form == "sort":
        word = document.tokens[inner.start].lower
    is_of_it = form == "part" and word == "it" and argument.type == "object" and _is_amount(document, inner)
    is_alone = form in ("one", "own") and len(inner) == 1 and (task.type, argument.type) == ("check_state", "object")
    # "if *one* is chipped", "when *his* is full"
    is_subject = is_alone and document.indices(task.span).start == inner.stop
    is_another = [document.tokens[i].lower for i in inner] == ["another", "one"]
    is_certain = is_of_it or is_subject or is_another or is_told_one(document, inner) or is_amount_alone
    return Gap(task, argument.type, inner.start, word, form, preposition, inner, is_certain=is_certain)


def _is_taken_up(document: Document, tokens: range) -> bool:
    """Whether words are a single one that refers, and maybe a preposition: "if she spits *it* out", "rinse it *with
    them*"."""
    inner = stripped(document, tokens)
    is_without = document.tokens[tokens.start].lower == "without"  # whose sense the value would lose
    return len(inner) == 1 and document.tokens[inner.start].lower in _TAKEN_UP and not is_without


def _is_kind(document: Document, task: Task, argument: Argument, tokens: range) -> bool:
    """Whether an adjective alone tells of what kind there is some: "any wine? If there's *white*, ..."."""
    is_asked = argument.type == "object" and len(tokens) == 1 and asks_there_is(document, task)
    return is_asked and (document.tokens[tokens.start].pos == "ADJ" or document.tokens[tokens.start].lower in _KINDS)


def _landmark(document: Document, tokens: range) -> range:
    """The one on, before or beside which something is, without its preposition: "on top of *the blue one*", "in front
    of *the blue one*". Empty in other words, and for a part of it: "in the pocket of the blue one"."""
    words = [document.tokens[i].lower for i in tokens]
    if words[-1:] not in (["one"], ["ones"]):
        return range(0)
    start = next((i for i in tokens[1:] if is_beside(document, i)), tokens.stop)
    return range(start, tokens.stop) if "of" not in words[start - tokens.start :] else range(0)


def is_beside(document: Document, at: int) -> bool:
    """Whether a preposition ends ahead of a token that tells by which thing something is: "on top of", "next to"."""
    before = [token.lower for token in document.tokens[max(0, at - _LONGEST_SIDE) : at]]
    return any(tuple(before[k:]) in _SIDES for k in range(len(before)))


def is_told_one(document: Document, tokens: range) -> bool:
    """Whether a clause tells of what sort "one" is, which is like a thing that was named: "this pen is dry, get me
    *one* that writes"."""
    words = [token.lower for token in document.tokens[tokens.start : tokens.start + 2]] if tokens else []
    return words[:1] == ["one"] and words[1:] in (["that"], ["which"], ["who"])


def _is_amount(document: Document, tokens: range) -> bool:
    """Whether words name so much of something: "a glass of it", not "the left of it"."""
    first, vessel = (document.tokens[i] for i in tokens[:2])
    return first.lower in ("a", "an", "one", "some") and len(tokens) == 4 and vessel.lower in _AMOUNTS


def _joined(document: Document, tokens: range) -> int | None:
    """Where the pronoun stands in "it and the charger" or "the charger and it"; None in other words."""
    words = [document.tokens[i].lower for i in tokens]
    if len(words) < 3:
        return None
    if words[0] in _SINGLE and words[1] in _AND:
        return tokens.start
    return tokens.stop - 1 if words[-1] in _SINGLE and words[-2] in _AND else None


def _form(document: Document, tokens: range) -> str | None:
    """pronoun, one ("the red one"), own ("hers", "Ruby's"), part ("half of it"), count ("two"), rest ("the rest"), sort
    ("any that leak"), measure ("a slice"), told ("the spare"), or None."""
    words = [document.tokens[i].lower for i in tokens]
    if len(words) == 2 and words[0] == "the" and words[1] in _REST:
        return "rest"
    if len(words) > 2 and words[0] in _SORTED and words[1] in _SORTING:
        return "sort"
    if len(words) == 2 and words[0] in ("a", "an", "another") and words[1] in _MEASURES:
        return "measure"
    if len(words) == 2 and words[0] in ("the", "some", "a", "an") and _is_telling(document, tokens.stop - 1):
        return "told"
    if (is_pointing(document, tokens) and words[0] not in OWN) or is_child(document, tokens):
        return None
    head = document.tokens[head_in(document, tokens)].lower
    last = document.tokens[tokens.stop - 1]
    if len(words) == 1:
        if words[0] in OWN:
            return "own"
        if words[0] in COUNTS:
            return "one" if words[0] == "one" else "count"
        return "pronoun" if words[0] in PRONOUNS or words[0] in _ALONE else None
    if words[:2] == ["one", "of"] and len(words) == 3:
        return "part" if words[-1] in PRONOUNS else None
    if words[:2] == ["one", "of"] and words[-1] != "ones":
        return None
    if words[-1:] == ["one"] and _is_numbered(document, tokens):
        return None
    if head in ONES:  # in "the red mug and the blue one" the words themselves say which noun is meant
        return "one" if not {"and", "or"} & set(words) else None
    is_owner = last.lower == "'s" and document.tokens[tokens.stop - 2].pos in ("NOUN", "PROPN")
    if (last.tag == "POS" or is_owner) and "and" not in words:  # "my mug and Tom's" says of what kind both are
        return "own"
    if len(words) > 1 and words[-2] == "of" and words[-1] in OWN:
        return None  # "anything of ours" says whose
    if len(words) > 2 and words[-2] == "of" and words[-1] in PRONOUNS:
        return "part"
    if words[-1] in COUNTS and len(words) == 2 and words[0] == "a":
        return "count"
    return "pronoun" if all(word in _LEADING | PRONOUNS | QUANTIFIERS for word in words) else None


def _is_telling(document: Document, at: int) -> bool:
    """Whether a word ends a phrase that tells things of a kind apart: "the *spare*", "some *cold*", "the *biggest*"."""
    token = document.tokens[at]
    is_last = at + 1 == len(document) or document.tokens[at + 1].pos not in ("NOUN", "PROPN", "ADJ")
    is_adjective = (
        token.tag in ("JJ", "JJR", "JJS") and token.lower not in _LEADING | PRONOUNS | QUANTIFIERS | _ORDINALS
    )
    return is_last and (is_adjective or token.lower in _KINDS | _TELLING)


def _is_numbered(document: Document, tokens: range) -> bool:
    """Whether "one" is the number of what a bare noun right ahead of it names: "to *room one*", not "the kitchen one",
    "a big one"."""
    *ahead, noun, _ = [document.tokens[i] for i in tokens] if len(tokens) > 1 else [None, None]
    is_bare = noun is not None and noun.tag in ("NN", "NNP") and noun.head != tokens.stop - 1
    return is_bare and all(word is not None and word.pos == "ADP" for word in ahead)


def head_in(document: Document, tokens: range) -> int:
    """The head of a phrase; of "one of the new ones" the last word."""
    words = [document.tokens[i].lower for i in tokens]
    return tokens.stop - 1 if words[:2] == ["one", "of"] and words[-1] == "ones" else head_of(document, tokens)


def unsaid_gaps(observed: Observed, task: Task, ontology: Ontology) -> Iterator[Gap]:
    """The arguments that a task may have by ellipsis."""
    document = observed.document
    said = {argument.type for argument in task.arguments}
    position = document.indices(task.span).start
    if task.type == "searching" and "object" not in said:
        yield Gap(task, "object", position, "", is_required="location" not in said)
        return
    if task.type == "motion":
        return
    if task.type == "informing" and "recipient" not in said and not _is_read_off(document, position):
        yield Gap(task, "recipient", position, "")
        return
    if task.type == "bringing" and not said & {"recipient", "goal"}:
        yield Gap(task, "recipient", position, "")
        yield Gap(task, "goal", position, "")
    for group in ontology.task_types[task.type].required:
        if group[0] == "goal" and observed.gazetteer.ending_type(document, position) == task.type:
            continue
        if group[0] == "goal" and observed.gazetteer.particle(document, position) in ("away", "up"):
            continue  # "put the cups away", "hang up the washing"
        if group[0] == "goal" and _is_put_aside(document, position):
            continue
        if group[0] == "goal" and (_is_put_away(document, position) or _is_kept(document, position)):
            continue
        if group[0] == "object" and _is_of_weather(document, position):
            continue
        if group[0] in ("object", "goal") and not said & set(group):
            is_certain = group[0] == "object" and _lacks_subject(observed, task, position)
            yield Gap(task, group[0], position, "", is_required=group[0] == "object", is_certain=is_certain)
    if task.type == "check_state" and not said & {"state", "location"}:
        is_certain = is_bare_being(document, position) or bool(degree_asked(document, position))
        yield Gap(task, PREDICATE, position, "", is_certain=is_certain)


def _is_read_off(document: Document, verb: int) -> bool:
    """Whether something is read or answered to nobody: "when it beeps, read it", "if it rings, answer it"."""
    behind = [token.lower for token in document.tokens[verb + 1 : verb + 3]]
    is_end = len(behind) < 2 or behind[1] in MARKS or behind[1] in ("and", "then")
    return document.tokens[verb].lemma in ("read", "answer") and behind[:1] in (["it"], ["them"]) and is_end


def _is_of_weather(document: Document, check: int) -> bool:
    """Whether an "its" that stands for "it's" is of the weather, which is nothing's: "if *its* raining"."""
    behind = document.tokens[check + 1].lower if check + 1 < len(document) else ""
    return document.tokens[check].lower == "its" and behind in WEATHER and behind.endswith("ing")


def _is_put_aside(document: Document, verb: int) -> bool:
    """Whether something is put aside, which is nowhere in particular."""
    words = [token.lower for token in document.tokens[verb + 1 :]]
    return "aside" in words[: next((i for i, word in enumerate(words) if word in MARKS | {"and", "but"}), len(words))]


def _is_put_away(document: Document, verb: int) -> bool:
    """Whether something is put out or away, which is where it goes: "put the bins *out*", "put *out* a towel", "put the
    pan *away*", "leave *out* the jam"."""
    tokens = document.tokens
    is_put = tokens[verb].lemma in ("put", "let", "leave")
    behind = tokens[verb + 1].lower if verb + 1 < len(tokens) else ""
    return is_put and (last_word(document, verb) in ("out", "away") or behind in ("out", "away"))


def _is_kept(document: Document, verb: int) -> bool:
    """Whether something is kept, or somebody let or tucked in, which is nowhere in particular: "keep *the lid*"."""
    return document.tokens[verb].lemma in ("keep", "tuck") or is_let_through(document, verb)


def is_let_through(document: Document, verb: int) -> bool:
    """Whether somebody is let in or out, which is nowhere in particular: "let the cat back *in*"."""
    return document.tokens[verb].lemma == "let" and last_word(document, verb) in ("in", "out")


def last_word(document: Document, verb: int) -> str:
    """The word that ends the clause of a verb: the "out" of "put the bins out and ..."."""
    words = [token.lower for token in document.tokens[verb + 1 :]]
    end = next((i for i, word in enumerate(words) if word in MARKS or word in _CLAUSE_ENDS), len(words))
    return words[end - 1] if end else ""


def says_there_is(document: Document, task: Task) -> bool:
    """Whether a check says that there is, or is not, something that it names: "if there's a letter for me"."""
    gaps = (gap_of(document, task, a) for a in task.arguments if a.type == "object" and a.span is not None)
    return asks_there_is(document, task) and any(gap is None or gap.form in NAMING_FORMS | {"kind"} for gap in gaps)


def asks_there_is(document: Document, task: Task) -> bool:
    """Whether a check asks if there is something, be it named or not: "if there's one"."""
    verb = document.indices(task.span).start
    around = [token.lower for token in document.tokens[max(0, verb - 1) : verb + 2]]
    return task.type == "check_state" and "there" in around


_BEFORE_ORDERS = frozenset(("please", "then"))


def is_bare_being(document: Document, verb: int) -> bool:
    """Whether a pronoun is said to be, or not to be, and no more: "if it is", "if they aren't turn them on"."""
    tokens = document.tokens
    before = next((token for token in reversed(tokens[:verb]) if token.lower not in _YET), None)
    is_being = tokens[verb].lemma in ("be", "'s") or tokens[verb].lower in ("s", "re")
    if not is_being or before is None or before.lower not in PRONOUNS - {"there"}:
        return False
    behind = next((token for token in tokens[verb + 1 :] if token.lower not in DENYING | _YET), None)
    # what stands in its base form behind a "be" is an order
    return behind is None or behind.text in MARKS or behind.tag == "VB" or behind.lower in _BEFORE_ORDERS


def _lacks_subject(observed: Observed, task: Task, verb: int) -> bool:
    """Whether a check says how something is without saying what: "if is still wet", "if it is dry but isn't folded",
    "*if dirty*, wash the cup"."""
    tokens = observed.document.tokens
    if task.type != "check_state" or verb == 0:
        return False
    if tokens[verb].lemma not in _BEING:
        return _is_bare_state(observed, verb)
    spans = [argument.span for argument in task.arguments if argument.span is not None]
    words = {tokens[i].lower for span in spans for i in observed.document.indices(span)}
    is_of_place = any(argument.type == "location" for argument in task.arguments)
    is_told = bool(words) and not is_of_place and (WEATHER | _AIR).isdisjoint(words)
    return tokens[verb - 1].lower in _OPENING and is_told


def _is_bare_state(observed: Observed, at: int) -> bool:
    """Whether a state stands alone between an "if" and a mark: "*if dirty,* wash the cup", not "if dark, ..."."""
    tokens = observed.document.tokens
    opening = next((i for i in range(at - 1, -1, -1) if tokens[i].lower in _OPENING), None)
    is_led = opening is not None and bare_state(observed, opening) == at
    is_set_off = 0 < at < len(tokens) - 1 and tokens[at - 1].lower in _OPENING and tokens[at + 1].text == ","
    return (is_led or (is_set_off and tokens[at].tag == "VBN")) and tokens[at].lower not in WEATHER | _AIR
