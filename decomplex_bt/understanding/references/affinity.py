"""How well a phrase fills a gap: the options that are not ruled out, each with the features that a model weighs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

from decomplex_bt.understanding.references.agreement import OWN, pair_meant
from decomplex_bt.understanding.references.antecedents import meant, other_place
from decomplex_bt.understanding.references.asked_again import asked_before
from decomplex_bt.understanding.references.certainty import is_pointing_back, referable
from decomplex_bt.understanding.references.context import Context, kind_of
from decomplex_bt.understanding.references.gapped import gapped_pair
from decomplex_bt.understanding.references.gaps import PREDICATE, Gap
from decomplex_bt.understanding.references.insides import containers_of
from decomplex_bt.understanding.references.options import Option
from decomplex_bt.understanding.references.ordinals import one_of_two
from decomplex_bt.understanding.references.phrases import Candidate
from decomplex_bt.understanding.references.predicates import predicate_options
from decomplex_bt.understanding.references.traits import determiner_of, modifier, named, traits_of, traits_of_none
from decomplex_bt.understanding.references.wordings import is_bare_one, is_coloured, is_halved, is_of_somebody, wordings

_TOGETHER = frozenset("both them they those these either".split())


def options_of(context: Context, gap: Gap) -> list[Option]:
    """All ways to fill a gap, leaving it last."""
    if gap.type == PREDICATE:
        return [*predicate_options(context, gap), Option(None, "", "", tuple(traits_of_none(context, gap)))]
    options: list[Option] = []
    document = context.observed.document
    own = modifier(context.observed, gap.tokens)
    other, ordered = other_place(context, gap), one_of_two(context, gap)
    of_side: dict[str, list[Candidate]] = {"before": [], "after": []}
    for candidate in referable(context, gap):
        if candidate.tokens.stop <= gap.position:
            of_side["before"].append(candidate)
        elif candidate.tokens.start > max(gap.position, gap.tokens.stop - 1):
            of_side["after"].append(candidate)
    pair = gapped_pair(context, gap)
    if pair or gap.word in _TOGETHER:
        pairs = list(_together(of_side["before"]))
        pair = pair or pair_meant(context, gap, pairs)
        of_side = {"before": [pair], "after": []} if pair else {**of_side, "before": [*of_side["before"], *pairs]}
    halved = [c for c in of_side["before"] if is_halved(document, gap, c)] if is_bare_one(document, gap) else []
    of_side = {"before": halved, "after": []} if halved else of_side
    of_side["before"].sort(key=lambda candidate: -candidate.tokens.stop)
    for side, candidates in of_side.items():
        heads: dict[int, int] = {}
        of_kind: dict[str, dict[int, int]] = {}
        for candidate in candidates:
            kind = kind_of(context, candidate)
            place = candidate.tokens.stop
            rank = heads.setdefault(place, len(heads))
            ranks = of_kind.setdefault(kind, {})
            kind_rank = ranks.setdefault(place, len(ranks))
            features = tuple(traits_of(context, gap, candidate, side, rank, kind, kind_rank))
            word = gap.word or f"unsaid.{gap.type}"
            determiner = determiner_of(document, candidate)
            contrast = f"{own}.{modifier(context.observed, named(candidate))}" if gap.tokens else ""
            is_of_colour = own == "colour" and is_coloured(context.observed, candidate)
            is_contrasted = is_of_colour or (candidate.tokens == other and gap.form == "one")
            for text, way in wordings(context.observed, gap, candidate, is_contrasted):
                if ordered and way != "same":  # "the first one" is the red car, no "first red car"
                    continue
                more = (
                    f"way:{way}.{gap.form}",
                    f"way:{way}.{word}.{determiner}",
                    f"way:{way}.{gap.form}.{determiner}.{candidate.shape}",
                    f"way:{way}.{gap.form}.{contrast}",
                    f"way:{way}.{word}.{contrast}.{determiner}",
                )
                options.append(Option(candidate, gap.type, text, features, more))
    if (is_of_somebody(document, gap) or (gap.word in OWN and gap.type == "object")) and options:
        return options  # "bring me Mum's" and "bring me mine" leave their noun to those before
    if not options or not (
        pair
        or halved
        or meant(context, gap)
        or is_pointing_back(document, gap)
        or containers_of(context, gap)
        or asked_before(context, gap)
    ):
        options.append(Option(None, "", "", tuple(traits_of_none(context, gap))))
    return options


def _together(candidates: Sequence[Candidate]) -> Iterator[Candidate]:
    """Two things that tasks name one after the other, which a plural may mean together."""
    objects = [c for c in candidates if c.type == "object" and not c.mention and c.shape in ("whole", "long")]
    for first, second in pairwise(objects):
        if first.owner != second.owner or first.tokens.stop < second.tokens.start:
            yield replace(second, text=f"{first.text} and {second.text}", shape="pair")
