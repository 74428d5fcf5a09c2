"""Writes the mean of trained networks to a new folder, each of which counts for its share.

    python benchmarks/mixed_networks.py --output FOLDER ENCODER=0.3 OTHER=0.35 THIRD=0.35

The choice among readings and the confidences are those of the first. So the shipped ones were made ("What each choice
gains" in docs/accuracy.md). Needs the extra `train`.
"""

from __future__ import annotations

import argparse
from pathlib import Path

from decomplex_bt.domain.loader import load_domain
from decomplex_bt.errors import DecomplexError
from decomplex_bt.understanding.encoder.mixing import mix


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("parts", nargs="+", metavar="ENCODER=SHARE", help="a folder with a trained encoder")
    parser.add_argument("--output", type=Path, required=True, help="a folder that is not there yet")
    parser.add_argument("--domain", default="household")
    arguments = parser.parse_args()
    try:
        shares = {Path(folder): float(share) for folder, _, share in (p.rpartition("=") for p in arguments.parts)}
    except ValueError:
        parser.error(f"expected folders with their shares, as in encoder=0.5, not {' '.join(arguments.parts)}")
    try:
        mix(shares, arguments.output, load_domain(arguments.domain))
    except DecomplexError as error:
        parser.error(str(error))


if __name__ == "__main__":
    main()
