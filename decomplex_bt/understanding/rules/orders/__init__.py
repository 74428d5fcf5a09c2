"""Orders: what is ordered, what is not, and what about."""
