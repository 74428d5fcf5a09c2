"""The command line `decomplex-bt`: each command parses its options, calls the library, prints."""

from decomplex_bt.cli.app import main

__all__ = ["main"]
