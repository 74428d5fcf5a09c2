"""The setting: all that episodes in one domain's house share, made once per process."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import lru_cache

from numpy.random import Generator

from decomplex_bt.corpus import read_corpus, read_voices
from decomplex_bt.domain.loader import Domain
from decomplex_bt.envs.geometry import Geometry
from decomplex_bt.envs.options import Request
from decomplex_bt.envs.prior import Prior
from decomplex_bt.envs.spots import Spots
from decomplex_bt.errors import InputError


@dataclass(frozen=True, eq=False)
class Setting:
    """A domain with its house's geometry, spots and prior. `misfits`: requests known not to suit the house."""

    domain: Domain
    geometry: Geometry
    spots: Spots
    prior: Prior
    misfits: set[Request] = field(default_factory=set)


@lru_cache(maxsize=16)
def setting_of(domain: Domain) -> Setting:
    """The setting of a domain. Raises `InputError` where its house does not fit together."""
    geometry = Geometry(domain.house, domain.kinds)
    return Setting(domain, geometry, Spots(geometry), Prior(geometry))


def draw_request(domain: Domain, rng: Generator) -> Request:
    """An annotated instruction of the domain's training corpus: a voice first, then one of its examples."""
    voices = _training_voices(domain)
    requests = _requests(domain, voices[int(rng.integers(len(voices)))])
    return requests[int(rng.integers(len(requests)))]


@lru_cache(maxsize=8)
def _training_voices(domain: Domain) -> tuple[str, ...]:
    folder = domain.folder / "corpus"
    voices = tuple(sorted(name for name, voice in read_voices(folder).items() if voice.split == "train"))
    if not voices:
        raise InputError(f"{folder} has no voice in the split 'train' to draw an instruction from; give one")
    return voices


@lru_cache(maxsize=1024)  # more than there are voices: reading one takes longer than many resets
def _requests(domain: Domain, voice: str) -> tuple[Request, ...]:
    examples = read_corpus(domain.folder / "corpus" / f"{voice}.yaml", domain.ontology)
    return tuple(Request(example.instruction.text, example.instruction) for example in examples)
