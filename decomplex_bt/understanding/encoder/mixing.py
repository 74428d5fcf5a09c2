"""Mixing of trained networks: their mean reads strangers as well as the latest and forgets less than it.

Wortsman et al., "Model soups", 2022. Of use where all went on from one another, or from the same.
"""

from __future__ import annotations

import shutil
from collections.abc import Callable, Mapping
from math import isclose
from pathlib import Path
from typing import Any

from decomplex_bt.domain.loader import Domain
from decomplex_bt.errors import InputError
from decomplex_bt.understanding.damage import ModelError
from decomplex_bt.understanding.encoder.flow_training import read_flow_network, write_flow_network
from decomplex_bt.understanding.encoder.flows import JUDGE_FILE, LABELS_FILE, NETWORK_FILE, read_labels
from decomplex_bt.understanding.encoder.model import ENCODER_FILE, HEADS_FILE
from decomplex_bt.understanding.encoder.stages import FOLDER_FILES
from decomplex_bt.understanding.encoder.training import read_encoder, write_encoder
from decomplex_bt.understanding.manifest import MANIFEST_FILE, check_models, file_hash, write_manifest

NETWORKS = (ENCODER_FILE, HEADS_FILE, NETWORK_FILE, JUDGE_FILE, LABELS_FILE)


def mix(shares: Mapping[Path, float], output: Path, domain: Domain) -> None:
    """Writes the weighted mean of trained encoders, folders and how much each counts (1 in all), to `output`, a new
    folder. The choice among readings and the confidences are those of the first.

    Raises `InputError` where the shares are none or `output` is there, `DataFileError` where a folder holds no encoder
    of this domain or the labels of flows differ, `TrainerMissingError`.
    """
    if not isclose(sum(shares.values()), 1) or min(shares.values()) <= 0:
        raise InputError(f"the shares are {', '.join(map(str, shares.values()))}; expected positive ones, 1 in all")
    if output.exists():
        raise InputError(f"{output} is there already; name a new folder")
    manifests = [check_models(folder, domain, models=(), files=FOLDER_FILES) for folder in shares]
    first, latest = next(iter(shares)), max(manifests, key=lambda manifest: len(manifest.voices))
    names = read_labels(first)
    for folder in shares:
        if read_labels(folder) != names:
            raise ModelError(folder / LABELS_FILE, f"labels of flows other than those in {first}")
    encoder = _mean(shares, lambda folder: read_encoder(folder, domain.ontology))
    flows = _mean(shares, lambda folder: read_flow_network(folder, names))
    output.mkdir(parents=True)
    write_encoder(encoder, output)
    write_flow_network(flows, names, output)
    for name in set(FOLDER_FILES) - set(NETWORKS):
        shutil.copyfile(first / name, output / name)
    write_manifest(
        output,
        domain,
        corpus=latest.corpus,
        voices=tuple(dict.fromkeys(voice for each in manifests for voice in each.voices)),
        examples=latest.examples,
        base=file_hash(first / MANIFEST_FILE),
        language_model=latest.language_model,
        libraries=tuple(latest.libraries),
    )


def _mean(shares: Mapping[Path, float], read: Callable[[Path], Any]) -> Any:
    """A network whose weights are the mean of those in the folders."""
    networks = [read(folder) for folder in shares]
    weights = [network.state_dict() for network in networks]
    mean = networks[0]
    mean.load_state_dict(
        {name: sum(w[name] * share for w, share in zip(weights, shares.values(), strict=True)) for name in weights[0]}
    )
    return mean.eval()
