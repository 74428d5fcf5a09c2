"""What can be sent to other processes, and what cannot, in words."""

from __future__ import annotations

import pickle
from typing import Any

from decomplex_bt.errors import InputError, quoted


def check_sendable(name: str, value: Any, *, remedy: str) -> None:
    """Raises `InputError` for what other processes cannot be given."""
    from joblib import wrap_non_picklable_objects

    sent = wrap_non_picklable_objects([value])  # as joblib sends it, which would make a subclass of a class alone
    try:
        pickle.dumps(sent)
    except Exception as error:  # whatever the pickling of a value may raise
        what = f"{name} is {quoted(value)}, which other processes cannot be given"
        raise InputError(f"{what}: {error}; {remedy}") from None
