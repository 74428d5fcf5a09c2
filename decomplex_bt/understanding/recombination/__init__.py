"""Recombination: annotated instructions told in other words, for networks to learn from."""
