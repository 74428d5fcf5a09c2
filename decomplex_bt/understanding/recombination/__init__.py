"""Annotated instructions told in other words and in another order, for models to learn from."""
