"""The household robot that does what a complex sentence says."""

from importlib.metadata import version

__version__ = version("decomplex-bt")
