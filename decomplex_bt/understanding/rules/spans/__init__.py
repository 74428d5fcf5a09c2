"""Spans: which words belong to an argument, and which arguments to a task."""
