"""Formats of annotated instructions: inline YAML, JSON Lines, CoNLL, BRAT standoff; HuRIC for reading alone."""
