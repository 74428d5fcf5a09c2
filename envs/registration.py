"""The environment ids, registered with Gymnasium when it is imported (plugin entry point)."""


def register_envs() -> None:
    """Registers every id of this package. Called by Gymnasium; calling it again changes nothing."""
