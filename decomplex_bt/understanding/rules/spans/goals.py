"""Goals: where something is put, or somebody goes, as far as the words of an order tell it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from decomplex_bt.understanding.arguments import CERTAIN, FoundArgument
from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.chunks import head_of, noun_chunks
from decomplex_bt.understanding.references.fitness import VESSELS
from decomplex_bt.understanding.vocabulary import ANIMALS, PERSON_NOUNS

_REFUSE = frozenset("bin dustbin rubbish trash garbage recycling".split())
_KEEPING = frozenset("keep leave stack store stow stash pile file".split())
"""What is done to things somewhere, and to no thing "in"."""
CLAUSE_ENDS = MARKS | frozenset("and but or then if unless when before after until please".split())
_WAYS = frozenset("down up in out".split())
_ONTO = frozenset("in on into onto under behind by".split())


def put_in(observed: Observed, arguments: Sequence[FoundArgument], put: int) -> list[FoundArgument]:
    """The arguments with what is put in, where nothing else is, as what is put: "put in *the pasta*"; not what things
    are put in themselves ("wash the pot and put *in the cabinet*"), nor what is kept or stacked somewhere."""
    document = observed.document
    own = {a.type: a for a in arguments if a.owner == put}
    goal = own.get("goal")
    is_particle = goal is not None and goal.tokens.start == put + 1 and document.tokens[put + 1].lower == "in"
    if goal is None or not is_particle or "object" in own or len(goal.tokens) < 2:
        return list(arguments)
    noun = document.tokens[head_of(document, range(put + 2, goal.tokens.stop))].lemma
    holds = noun in VESSELS or observed.gazetteer.category(noun) in ("furniture", "room")
    if holds or document.tokens[put].lemma in _KEEPING:
        return list(arguments)
    kept = [a for a in arguments if a is not goal]
    return [*kept, replace(goal, type="object", tokens=range(put + 2, goal.tokens.stop))]


def gone_to(document: Document, arguments: Sequence[FoundArgument], going: int) -> list[FoundArgument]:
    """The arguments with where something goes as where it is put: "anything from the bank *goes on my desk*"."""
    tokens, start = document.tokens, going + 1
    is_led = start < len(tokens) and tokens[start].lower in _ONTO and tokens[going].lemma in ("go", "belong")
    place = next((chunk for chunk in noun_chunks(document) if is_led and chunk.start == start + 1), None)
    if place is None or any((a.owner, a.type) == (going, "goal") and a.tokens.start > going for a in arguments):
        return list(arguments)
    kept = [a for a in arguments if set(a.tokens).isdisjoint(range(start, place.stop))]
    return [*kept, FoundArgument("goal", going, range(start, place.stop), CERTAIN)]


def put_inside(document: Document, arguments: Sequence[FoundArgument], putting: int) -> list[FoundArgument]:
    """The arguments without a mere "in" as where something is put, which what was spoken of before tells ("open the
    washer and put *in* the sheets")."""
    own = {a.type: a for a in arguments if a.owner == putting}
    goal = own.get("goal")
    is_particle = goal is not None and [document.tokens[i].lower for i in goal.tokens] == ["in"]
    return [a for a in arguments if not (is_particle and "object" in own and a is goal)]


def put_out(document: Document, arguments: Sequence[FoundArgument], putting: int) -> list[FoundArgument]:
    """The arguments with the "out" behind an animal, somebody or the rubbish as where they are put: "put the cat
    *out*"; plates that are put out are not put outside."""
    own = {a.type: a for a in arguments if a.owner == putting}
    thing = own.get("object")
    if thing is None or "goal" in own or document.tokens[putting].lemma not in ("put", "let", "turn"):
        return list(arguments)
    at = thing.tokens.stop
    words = [token.lower for token in document.tokens[at : at + 2]]
    last = document.tokens[at - 1]
    is_put_outside = last.lemma in ANIMALS | PERSON_NOUNS | _REFUSE or last.lower in ("him", "her")
    is_out = words[:1] == ["out"] and (len(words) == 1 or words[1] in CLAUSE_ENDS)
    if not is_out or not is_put_outside or thing.tokens.start < putting:
        return list(arguments)
    return [*arguments, FoundArgument("goal", putting, range(at, at + 1), CERTAIN)]


def gone_back(document: Document, arguments: Sequence[FoundArgument], going: int) -> list[FoundArgument]:
    """The arguments with a mere "back down" or "back in" as which way somebody comes, and no place."""

    def is_way(argument: FoundArgument) -> bool:
        words = [document.tokens[i].lower for i in argument.tokens]
        is_goal = (argument.owner, argument.type) == (going, "goal")
        return is_goal and words[:1] == ["back"] and len(words) == 2 and words[1] in _WAYS

    return [replace(a, type="direction") if is_way(a) else a for a in arguments]
